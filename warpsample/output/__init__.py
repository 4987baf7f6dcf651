"""Commands that write files: sampled directions, and quantities computed at the points of a mesh."""
