"""Distributions of scattered light: phase functions and transformed lobes; each is defined in a file of its own."""
