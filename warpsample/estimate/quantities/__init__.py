"""Quantities computed from rays about the normal, with one file per quantity."""
