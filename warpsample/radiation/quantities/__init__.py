"""The quantities that the sun and the patches of the sky make, a file each."""
