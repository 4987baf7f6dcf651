"""Files of directions, and of numbers for each point."""
