"""Sky patches, and how much of each one points see."""
