"""Benchmarks of run time, error and memory, for the `warpsample bench` command."""

import sys

from warpsample.bench.record import Benchmark
from warpsample.host.registry import records_of


def benchmarks() -> dict[str, Benchmark]:
    """Return all benchmarks of the `warpsample bench` command, keyed by name.

    A benchmark is the `RECORD` of a file or folder of this room.
    """
    return dict(sorted(records_of(sys.modules[__name__]).items()))
