"""Rasters as files or arrays: sources, transforms, reference systems, stored numbers, and reading of parts."""
