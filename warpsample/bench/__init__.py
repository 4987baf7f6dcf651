"""Benchmarks of run time, error and memory, for the `warpsample bench` command."""

import sys

from warpsample.bench.record import Benchmark
from warpsample.host.registry import records_of


def benchmarks() -> dict[str, Benchmark]:
    """Return every benchmark by name: the `RECORD` of each file or folder of this room."""
    return dict(sorted(records_of(sys.modules[__name__]).items()))
