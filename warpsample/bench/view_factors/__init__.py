"""`bench view-factors`: what view factors cost, beside pyViewFactor and embreex."""

from warpsample.bench.record import Benchmark
from warpsample.bench.view_factors.figures import draw
from warpsample.bench.view_factors.measuring import Found, Settings, measure
from warpsample.bench.view_factors.tables import readme, tables

RECORD = Benchmark(
    name="view-factors",
    title="View factors",
    summary="All view factors of a mesh: ours, pyViewFactor, and rays by NumPy and embreex, beside tracing alone.",
    settings=Settings,
    found=Found,
    measure=measure,
    tables=tables,
    readme=readme,
    figures=draw,
    wrong=lambda found: any(row.agrees is False for row in found.rows),
)
