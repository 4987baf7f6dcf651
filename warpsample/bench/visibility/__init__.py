"""`bench visibility`: how long ambient occlusion takes to an error."""

from warpsample.bench.record import Benchmark
from warpsample.bench.visibility.figures import draw
from warpsample.bench.visibility.measuring import Found, Settings, measure
from warpsample.bench.visibility.tables import readme, tables

RECORD = Benchmark(
    name="visibility",
    title="Numbers per point",
    summary="Time to an RMSE of ambient occlusion: ours, with and without skipping, Mitsuba, embreex, trimesh and Open3D.",
    settings=Settings,
    found=Found,
    measure=measure,
    tables=tables,
    readme=readme,
    figures=draw,
    pictures={"visibility": "Time to an RMSE of ambient occlusion by each tool"},
    wrong=lambda found: any(not confirmed.agrees for confirmed in found.confirmed),
)
