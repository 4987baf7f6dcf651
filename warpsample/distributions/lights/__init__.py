"""Distributions of directions towards light; each is defined in a file of its own."""
