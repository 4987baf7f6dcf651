"""How long tests wait for what should end by itself, and how they interrupt it."""

import signal

HANGS = 3600.0
"""Seconds: ten times what the longest takes beside others on two busy cores. Only what would never end takes longer."""


def send_one():
    """Python calls the handler before the function ends."""
    signal.raise_signal(signal.SIGINT)
