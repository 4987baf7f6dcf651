"""`bench startup`: what a new process waits for, what small calls cost, and what all threads gain, also after a pause."""

from warpsample.bench.record import Benchmark
from warpsample.bench.startup.figures import draw
from warpsample.bench.startup.measuring import Found, Settings, measure
from warpsample.bench.startup.tables import readme, tables

RECORD = Benchmark(
    name="startup",
    title="Before the work begins",
    summary="What a new process waits for, what a small call costs, and what all threads gain, also after a pause.",
    settings=Settings,
    found=Found,
    measure=measure,
    tables=tables,
    readme=readme,
    figures=draw,
)
