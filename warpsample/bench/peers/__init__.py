"""`bench peers`: the same task by other tools, side by side."""

from warpsample.bench.peers.measuring import Found, Settings, measure
from warpsample.bench.peers.report import draw, readme, tables
from warpsample.bench.record import Benchmark

RECORD = Benchmark(
    name="peers",
    title="Directions, against other tools",
    summary="The same task by warpsample, NumPy, SciPy, Numba, PyTorch, Warp's built-ins, Mitsuba, trimesh and Open3D.",
    settings=Settings,
    found=Found,
    measure=measure,
    tables=tables,
    readme=readme,
    figures=draw,
    wrong=lambda found: any(row.agrees is False for row in found.rows),
)
