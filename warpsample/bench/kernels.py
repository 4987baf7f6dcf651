"""`bench kernels`: what the kernel API costs: a user's own integrand and a user's own kernel, beside what is built in."""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Annotated

import numpy as np
import typer
import warp as wp

from warpsample.bench.pictures import OURS, THEIRS
from warpsample.bench.record import SEED, Benchmark, Repeats, Track
from warpsample.bench.report import SPREAD, Table, spread
from warpsample.bench.result import Result
from warpsample.bench.scenes import bunny, city
from warpsample.bench.timing import Spread, interleave, stopwatch
from warpsample.directions.sample import sample_directions
from warpsample.distributions.cosine_hemisphere import square_to_cosine_hemisphere
from warpsample.estimate.integrate import integrate
from warpsample.estimate.visibility import ambient_occlusion
from warpsample.host.kernel_cache import load, wide_flags
from warpsample.maths.frames import frame_about, to_world
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.surface import sample_surface
from warpsample.sequences.fibonacci import fibonacci
from warpsample.tracing.tree import Tree, any_hit, offset_origin, tree

if TYPE_CHECKING:
    from matplotlib.figure import Figure

COUNTS = (64, 256, 1024, 4096)
"""Directions of a point that are integrated."""
RAYS = 256
"""Rays of a point whose occlusion is estimated."""
SCENES: dict[str, Callable[[], Mesh]] = {"bunny": lambda: bunny(0), "city": city}

_TOTAL = 1 << 22  # directions of a run
_KERNEL, _CAST, _SKIPPED = "a kernel of ten lines", "ambient_occlusion, skip=False", "ambient_occlusion"
_OWN, _STORED, _SUMMED = "integrate", "sample_directions", "sample_directions and NumPy"


@dataclass(frozen=True)
class Settings:
    """Of the command."""

    points: Annotated[int, typer.Option(help="Points on each mesh.", min=64)] = 8192
    repeats: Repeats = 15


@dataclass(frozen=True)
class Cost:
    """One way to a result, on one thread.

    Attributes:
        way: how.
        scene: against which mesh rays are cast; "" for none.
        count: directions of a point.
        nanoseconds: of a direction.
        ours: how many times as long as the first way to the same result, within each round.
        seconds: of each repeat; none where they were not kept.
    """

    way: str
    scene: str
    count: int
    nanoseconds: Spread
    ours: Spread
    seconds: list[float] = field(default_factory=list)


@dataclass(frozen=True)
class Found:
    """Of every case."""

    rows: list[Cost]


@wp.func
def gradient(w: wp.vec3) -> float:
    """A sky that is brighter upwards."""
    return 0.3 + 0.7 * wp.max(w[2], 0.0)


@wp.func
def coloured(w: wp.vec3) -> wp.vec3:
    """The same in red, green and blue."""
    return wp.vec3(0.3, 0.4, 0.5) + wp.max(w[2], 0.0) * wp.vec3(0.7, 0.5, 0.2)


@wp.kernel(module="unique", enable_backward=False, module_options={"cpu_compiler_flags": wide_flags()})
def occlusion(tree: Tree, position: wp.array[wp.vec3d], normal: wp.array[wp.vec3], count: int, out: wp.array[float]):
    """The kernel that the README of `tracing` shows, with the compiler's flag that it names."""
    p = wp.tid()
    frame = frame_about(normal[p])
    origin = offset_origin(tree, position[p], normal[p])
    for j in range(count):
        u = fibonacci(wp.uint64(0), wp.uint64(p), wp.uint32(j), wp.uint32(count))
        w = to_world(frame, square_to_cosine_hemisphere(u))
        if not any_hit(tree, origin, w, wp.INF):
            out[p] += 1.0 / float(count)


def measure(settings: Settings, track: Track) -> Found:
    """Each result by all ways to it, in turns."""
    groups = [("", count, ways(count)) for count in COUNTS for ways in (means, colours)]
    groups += [(scene, RAYS, occlusions(scene, settings.points)) for scene in SCENES]
    rows = []
    for scene, count, ways in track(groups, len(groups)):
        points = settings.points if scene else _TOTAL // count
        times, _ = interleave([stopwatch(work) for work in ways.values()], settings.repeats)
        for way, seconds in zip(ways, times, strict=True):
            each = Spread.of([1e9 * t / (points * count) for t in seconds])
            rows.append(Cost(way, scene, count, each, Spread.of_ratios(seconds, times[0]), seconds))
    return Found(rows)


def means(count: int) -> dict[str, Callable[[], object]]:
    """The mean of a cheap function over the cosine lobe: fused, the directions alone into an array, and these with NumPy."""
    normals = _normals(count)
    out = np.empty((len(normals), count, 3), np.float32)
    return {
        _OWN: lambda: integrate(normals, gradient, count, workers=1),
        _STORED: lambda: _directions(normals, count, out),
        _SUMMED: lambda: (0.3 + 0.7 * np.maximum(_directions(normals, count)[..., 2], 0.0)).mean(axis=1),
    }


def colours(count: int) -> dict[str, Callable[[], object]]:
    """The same of a colour, as one writes it."""
    normals, low, change = _normals(count), np.float32([0.3, 0.4, 0.5]), np.float32([0.7, 0.5, 0.2])
    return {
        f"{_OWN}, a colour": lambda: integrate(normals, coloured, count, workers=1),
        f"{_SUMMED}, a colour": lambda: (low + np.maximum(_directions(normals, count)[..., 2:], 0.0) * change).mean(axis=1),
    }


def _normals(count: int) -> np.ndarray:
    return np.random.default_rng(SEED).normal(size=(_TOTAL // count, 3)).astype(np.float32)


def _directions(normals: np.ndarray, count: int, out: np.ndarray | None = None) -> np.ndarray:
    return sample_directions(normals, count, sequence="fibonacci", out=out, workers=1).vectors


def occlusions(scene: str, points: int) -> dict[str, Callable[[], object]]:
    """Ambient occlusion of points: by a user's kernel, and by the call that is built in."""
    mesh = SCENES[scene]()
    at = sample_surface(mesh, points, seed=SEED)
    searched = tree(mesh)
    position = wp.array(at.position, dtype=wp.vec3d, device="cpu")
    normal = wp.array(at.normal, dtype=wp.vec3, device="cpu")
    out = wp.zeros(points, dtype=float, device="cpu")
    load(occlusion, "cpu")  # Warp would announce it between our tables

    def own() -> wp.array:
        out.zero_()
        wp.launch(occlusion, points, inputs=[searched, position, normal, RAYS], outputs=[out], device="cpu")
        return out

    return {
        _KERNEL: own,
        _CAST: lambda: ambient_occlusion(mesh, at, RAYS, skip=False, workers=1),
        _SKIPPED: lambda: ambient_occlusion(mesh, at, RAYS, workers=1),
    }


def tables(result: Result) -> list[Table | str]:
    """A table of means, and one of occlusion."""
    rows = result.found.rows
    return [
        f"One thread: {SPREAD}. times: how many times as long as by the first way.",
        _table("Means of a sky over the cosine lobe", [row for row in rows if not row.scene]),
        _table(f"Ambient occlusion by {RAYS} rays a point", [row for row in rows if row.scene]),
    ]


def readme(result: Result) -> list[Table | str]:
    """Both tables, and what they say."""
    _, means_table, occlusion_table = tables(result)
    return [
        "The mean of a sky of one line over the cosine lobe, on one thread; `sample_directions` alone fills a given array:",
        means_table,
        f"Ambient occlusion by {RAYS} rays a point: the kernel that [tracing](../tracing/README.md) shows, and the call:",
        occlusion_table,
    ]


def _table(title: str, rows: list[Cost]) -> Table:
    cells = [[row.scene or f"{row.count:,}", row.way, spread(row.nanoseconds), spread(row.ours)] for row in rows]
    return Table(title, ["mesh" if rows and rows[0].scene else "directions", "way", "ns per direction", "times"], cells)


def draw(found: Found, caption: str) -> dict[str, "Figure"]:
    """Nanoseconds of a direction, by each way."""
    from matplotlib.figure import Figure  # noqa: PLC0415

    figure = Figure(figsize=(9.0, 5.5), layout="constrained")
    axes = figure.subplots()
    labels = [f"{row.scene or f'{row.count:,} directions'}: {row.way}" for row in found.rows]
    colours = [OURS if row.ours.low == row.ours.high == 1.0 else THEIRS for row in found.rows]
    places = range(len(found.rows))[::-1]
    axes.hlines(places, [r.nanoseconds.low for r in found.rows], [r.nanoseconds.high for r in found.rows], color=colours)
    axes.scatter([row.nanoseconds.median for row in found.rows], places, color=colours)
    axes.set_yticks(places, labels)
    axes.set_xscale("log")
    axes.set_xlabel("time per direction [ns]")
    axes.grid(alpha=0.3, axis="x")
    figure.supxlabel(caption, fontsize=10)
    return {"kernels": figure}


RECORD = Benchmark(
    name="kernels",
    title="Kernels of your own",
    summary="The price of a user's integrand and of a user's kernel with rays, beside what is built in.",
    settings=Settings,
    found=Found,
    measure=measure,
    tables=tables,
    readme=readme,
    figures=draw,
)
