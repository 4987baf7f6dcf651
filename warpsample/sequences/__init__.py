"""Sequences of points in the unit square, a file each."""

import sys

from warpsample.host.registry import look_up, records_of
from warpsample.sequences.record import Sequence

_KNOWN = records_of(sys.modules[__name__])


def names() -> list[str]:
    """Names of all sequences, sorted."""
    return sorted(_KNOWN)


def get(name: str) -> Sequence:
    """The record of a sequence.

    Raises:
        ValueError: the name is not known; the message lists those that are.
    """
    return look_up(_KNOWN, name, "sequence")
