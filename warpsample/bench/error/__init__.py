"""`bench error`: the error of means against run time, by every sequence."""

from warpsample.bench.error.measuring import Found, Settings, measure
from warpsample.bench.error.report import draw, readme, tables
from warpsample.bench.record import Benchmark

RECORD = Benchmark(
    name="error",
    title="Which sequence",
    summary="RMSE against run time: every sequence on seven integrands of known mean, from 4 samples on.",
    settings=Settings,
    found=Found,
    measure=measure,
    tables=tables,
    readme=readme,
    figures=draw,
    pictures={"error": "The RMSE of seven integrands against wall time, by six sequences"},
)
