"""`bench cluster`: processes against threads, what a chunk and a mesh cost over Dask, and the plan for 10^9 points."""

from warpsample.bench.cluster.measuring import measure
from warpsample.bench.cluster.planning import draw, readme, tables
from warpsample.bench.cluster.record import Found, Settings
from warpsample.bench.record import Benchmark

RECORD = Benchmark(
    name="cluster",
    title="Past one process",
    summary="Processes against threads over Dask, what a chunk and a mesh cost, and the plan for 10^9 points.",
    settings=Settings,
    found=Found,
    measure=measure,
    tables=tables,
    readme=readme,
    figures=draw,
)
