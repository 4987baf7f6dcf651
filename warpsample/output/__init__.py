"""Files: directions, and numbers for each point."""
