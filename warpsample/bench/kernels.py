"""`bench kernels`: cost of user-defined integrands and kernels, compared with the built-in calls."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Annotated

import numpy as np
import typer
import warp as wp

from warpsample.bench.record import SEED, Benchmark, Picture, Repeats, RowsByPart, TableView, Track
from warpsample.bench.rows import Spread, Timed, column
from warpsample.bench.running.timing import time_interleaved
from warpsample.bench.scenes import bunny, city
from warpsample.directions.sample import sample_directions
from warpsample.distributions.cosine_hemisphere import square_to_cosine_hemisphere
from warpsample.estimate.integrate import integrate
from warpsample.estimate.visibility import ambient_occlusion
from warpsample.host.kernel_cache import load, wide_flags
from warpsample.maths.frames import frame_about, to_world
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.points.sampling import sample_surface
from warpsample.sequences.fibonacci import fibonacci
from warpsample.tracing.own_rays import Tree, any_hit, offset_origin
from warpsample.tracing.tree import tree

COUNTS = (64, 256, 1024, 4096)
"""Directions per point of the means."""
RAYS = 256
"""Rays per point of the occlusion."""
SCENES: dict[str, Callable[[], Mesh]] = {"bunny": lambda: bunny(0), "city": city}

_TOTAL = 1 << 22  # directions of a timed run


@dataclass(frozen=True)
class WayCost(Timed):
    """Row of `bench kernels`: cost of one method to compute a result, for example a user-defined kernel, on one thread."""

    way: str = column("way")
    scene: str = column("mesh")
    count: int = column("directions", "directions per point")
    nanoseconds: Spread = column("ns per direction")
    ours: Spread = column("time / first way", "time over that of the first way to the same result, in the same round")


@wp.func
def gradient(w: wp.vec3) -> float:
    """Return the radiance of a sky that is brighter towards the zenith."""
    return 0.3 + 0.7 * wp.max(w[2], 0.0)


@wp.kernel(module="unique", enable_backward=False, module_options={"cpu_compiler_flags": wide_flags()})
def occlusion(tree: Tree, position: wp.array[wp.vec3d], normal: wp.array[wp.vec3], count: int, out: wp.array[float]):
    """Estimate ambient occlusion in a user-defined kernel, as in the README of `tracing`.

    The kernel is built with the compiler flag given there.
    """
    p = wp.tid()
    frame = frame_about(normal[p])
    origin = offset_origin(tree, position[p], normal[p])
    for j in range(count):
        u = fibonacci(wp.uint64(0), wp.uint64(p), wp.uint32(j), wp.uint32(count))
        w = to_world(frame, square_to_cosine_hemisphere(u))
        if not any_hit(tree, origin, w, wp.INF):
            out[p] += 1.0 / float(count)


def measure(
    track: Track,
    *,
    points: Annotated[int, typer.Option(help="Number of points on each mesh, placed uniformly by area.", min=64)] = 8192,
    repeats: Repeats = 15,
) -> RowsByPart:
    """Time user-defined integrands and kernels and the built-in calls in alternation; return the rows."""
    groups = [("", count, build_means(count)) for count in COUNTS]
    groups += [(scene, RAYS, build_occlusions(scene, points)) for scene in SCENES]
    rows = []
    for scene, count, ways in track(groups, len(groups)):
        size = count * (points if scene else _TOTAL // count)
        times = time_interleaved(ways, repeats)
        first = next(iter(times.values()))
        for way, seconds in times.items():
            each = Spread.of([1e9 * t / size for t in seconds])
            rows.append(WayCost(way, scene, count, each, Spread.of_ratios(seconds, first), seconds=seconds))
    return {"rows": rows}


def build_means(count: int) -> dict[str, Callable[[], object]]:
    """Build functions to time, which compute the cosine-weighted mean of a cheap function by different methods.

    The ways are a fused call, directions alone into an array, and directions with a mean by NumPy.
    """
    normals = np.random.default_rng(SEED).normal(size=(_TOTAL // count, 3)).astype(np.float32)
    out = np.empty((len(normals), count, 3), np.float32)

    def average_with_numpy() -> np.ndarray:
        return (0.3 + 0.7 * np.maximum(_sample(normals, count)[..., 2], 0.0)).mean(axis=1)

    return {
        "integrate": lambda: integrate(normals, gradient, count, workers=1),
        "sample_directions": lambda: _sample(normals, count, out),
        "sample_directions and NumPy": average_with_numpy,
    }


def _sample(normals: np.ndarray, count: int, out: np.ndarray | None = None) -> np.ndarray:
    return sample_directions(normals, count, sequence="fibonacci", out=out, workers=1).vectors


def build_occlusions(scene: str, points: int) -> dict[str, Callable[[], object]]:
    """Build functions that compute ambient occlusion: by a user-defined kernel, and by the built-in call.

    The built-in call runs with and without skipping.
    """
    mesh = SCENES[scene]()
    at = sample_surface(mesh, points, seed=SEED)
    ray_tree = tree(mesh)
    position = wp.array(at.position, dtype=wp.vec3d, device="cpu")
    normal = wp.array(at.normal, dtype=wp.vec3, device="cpu")
    out = wp.zeros(points, dtype=float, device="cpu")
    load(occlusion, "cpu")  # otherwise Warp prints a message between the tables

    def run_kernel() -> wp.array:
        out.zero_()
        wp.launch(occlusion, points, inputs=[ray_tree, position, normal, RAYS], outputs=[out], device="cpu")
        return out

    return {
        "a kernel of ten lines": run_kernel,
        "ambient_occlusion, skip=False": lambda: ambient_occlusion(mesh, at, RAYS, skip=False, workers=1),
        "ambient_occlusion": lambda: ambient_occlusion(mesh, at, RAYS, workers=1),
    }


def _select_city(rows: list[WayCost]) -> list[WayCost]:
    return [row for row in rows if row.scene == "city"]


def _select_for_page(rows: list[WayCost]) -> list[WayCost]:
    return [row for row in rows if row.count in (256, 4096)]


_MEANS = "Means of a sky over the cosine lobe, one thread"
_OCCLUSION = f"Ambient occlusion with {RAYS} rays per point, one thread"

RECORD = Benchmark(
    name="kernels",
    summary="Measure the cost of a user-defined integrand and a user-defined kernel, beside the built-in calls.",
    measure=measure,
    parts={"rows": WayCost},
    views=[
        TableView(
            "rows", _MEANS, "count way", "nanoseconds ours", where=lambda row: not row.scene, page_rows=_select_for_page
        ),
        TableView("rows", _OCCLUSION, "scene way", "nanoseconds ours", where=lambda row: row.scene, page_rows=_select_city),
    ],
    pictures=[Picture("kernels", "rows", "nanoseconds", y="way", series="count", panels="scene", log="x")],
)
