"""A validated mesh, and points on it."""
