"""Inspection of users' Warp functions and data: current definitions, and digests that identify them."""
