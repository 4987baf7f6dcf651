"""The quantities that rays around a normal make, a file each."""
