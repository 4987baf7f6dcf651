"""`bench rays`: rays a second, and how long trees take to build."""

from warpsample.bench.rays.figures import draw
from warpsample.bench.rays.measuring import Found, Settings, measure
from warpsample.bench.rays.tables import readme, tables
from warpsample.bench.record import Benchmark

RECORD = Benchmark(
    name="rays",
    title="Rays",
    summary="Rays a second beside wp.Mesh, Embree and Open3D: five meshes, four kinds of rays, two queries; builds.",
    settings=Settings,
    found=Found,
    measure=measure,
    tables=tables,
    readme=readme,
    figures=draw,
    pictures={"rays": "Rays a second by each tool, any and nearest hit"},
)
