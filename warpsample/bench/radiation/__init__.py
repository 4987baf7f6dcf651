"""`bench radiation`: what sky and sun cost, beside Radiance, Mitsuba and embreex."""

from warpsample.bench.radiation.figures import draw
from warpsample.bench.radiation.measuring import Found, Settings, measure
from warpsample.bench.radiation.tables import readme, tables
from warpsample.bench.record import Benchmark

RECORD = Benchmark(
    name="radiation",
    title="Sky and sun",
    summary="Sky matrices and sun positions: ours, Radiance's rcontrib, Mitsuba and embreex; and a year's irradiation.",
    settings=Settings,
    found=Found,
    measure=measure,
    tables=tables,
    readme=readme,
    figures=draw,
    wrong=lambda found: any(row.agrees is False for row in (*found.sky, *found.sun)),
)
