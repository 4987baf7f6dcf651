"""How long tests wait for what should end by itself."""

HANGS = 3600.0
"""Seconds: ten times what the longest takes beside others on two busy cores. Only what would never end takes longer."""
