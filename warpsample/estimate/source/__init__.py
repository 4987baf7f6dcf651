"""Inspection of user-defined Warp functions and their data: current definitions, and hashes that detect changes."""
