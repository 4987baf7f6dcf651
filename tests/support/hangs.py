"""How long tests wait for what should end by itself, and how they interrupt it."""

import signal

HANGS = 1200.0
"""Seconds: ten times what the longest takes beside others on two busy cores. Less than .ci/run gives a test."""


def send_one():
    """Python calls the handler before the function ends."""
    signal.raise_signal(signal.SIGINT)
