"""Distributions of directions towards lights: uniform in the solid angle of a triangle or of a rectangle."""
