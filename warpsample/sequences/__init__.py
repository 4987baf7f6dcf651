"""Sequences of points in the unit square, a file each."""

import sys

from warpsample.host.registry import look_up, records_of
from warpsample.sequences.record import Sequence

_KNOWN = records_of(sys.modules[__name__])


def names() -> list[str]:
    """Names of all sequences.

    Returns:
        the names, sorted; what `sequence=` takes.

    Example:
        >>> print(ws.sequences.names())
        ['fibonacci', 'independent', 'philox', 'r2', 'sobol', 'stratified']
    """
    return sorted(_KNOWN)


def get(name: str) -> Sequence:
    """The record of a sequence.

    Args:
        name: one of `names()`.

    Returns:
        its `wp.func`, what it promises and where it comes from.

    Raises:
        TypeError: not a string.
        ValueError: the name is not known; the message lists those that are.

    Example:
        >>> record = ws.sequences.get("sobol")
        >>> print(record.summary, record.progressive)
        Owen-scrambled Sobol', the best for smooth integrands True
    """
    return look_up(_KNOWN, name, "sequence")
