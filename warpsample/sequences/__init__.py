"""Sequences of sample points in the unit square; each sequence is defined in a file of its own."""

import sys

from warpsample.host.registry import look_up, records_of
from warpsample.sequences.record import Sequence

_RECORDS = records_of(sys.modules[__name__])


def names() -> list[str]:
    """Return the names of all sequences.

    Returns:
        the names, sorted; each is a value for the argument `sequence`.

    Example:
        >>> print(ws.sequences.names())
        ['fibonacci', 'independent', 'philox', 'r2', 'sobol', 'stratified']
    """
    return sorted(_RECORDS)


def get(name: str) -> Sequence:
    """Return the description of a sequence: its Warp functions and statistical properties.

    Args:
        name: one of `names()`.

    Returns:
        the record, with the `wp.func` of the sequence, its properties and its source.

    Raises:
        TypeError: the name is not a string.
        ValueError: the name is unknown; the message lists the known names.

    Example:
        >>> record = ws.sequences.get("sobol")
        >>> print(record.summary, record.progressive)
        Owen-scrambled Sobol', the best for smooth integrands True
    """
    return look_up(_RECORDS, name, "sequence")
