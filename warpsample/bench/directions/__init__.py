"""`bench directions`: `sample_directions` against what the machine can do."""

from warpsample.bench.directions.figures import draw
from warpsample.bench.directions.measuring import Found, Settings, measure
from warpsample.bench.directions.tables import readme, tables
from warpsample.bench.record import Benchmark

RECORD = Benchmark(
    name="directions",
    title="Directions, against what the machine can do",
    summary="Time per direction against worst error: every map, sequence and count, beside NumPy's fill of the same array.",
    settings=Settings,
    found=Found,
    measure=measure,
    tables=tables,
    readme=readme,
    figures=draw,
)
