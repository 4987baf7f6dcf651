"""Run time against error, against other tools and against what the machine can do, for `warpsample bench`."""

import sys

from warpsample.bench.record import Benchmark
from warpsample.host.registry import records_of


def benchmarks() -> dict[str, Benchmark]:
    """Every benchmark by its name: what a file or a folder of this room defines as `RECORD`."""
    return dict(sorted(records_of(sys.modules[__name__]).items()))
