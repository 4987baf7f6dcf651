"""`bench rays`: rays per second and build times of warpsample, wp.Mesh, Embree and Open3D on the same rays."""

from dataclasses import dataclass
from importlib.metadata import version
from itertools import product
from typing import Annotated, Any

import numpy as np
import typer

from warpsample.bench.record import Benchmark, Picture, Repeats, RowsByPart, Scenes, Track
from warpsample.bench.reporting.tables import Cell, TableView
from warpsample.bench.rows import Spread, Timed, column
from warpsample.bench.running.timing import time_interleaved
from warpsample.bench.scenes import KINDS, SCENES, build_rays
from warpsample.bench.tools.tracers import TRACERS, RayTool, count_visits, list_builds
from warpsample.host.engine import check_workers
from warpsample.mesh.mesh import Mesh


@dataclass(frozen=True)
class RaySpeed(Timed):
    """Row of `bench rays`: rays per second of one tool on one set of rays."""

    scene: str = column("scene")
    triangles: int = column("triangles")
    kind: str = column(
        "rays", "camera: from a camera; outward, inward: cosine lobe off and into the surface; random: uniform"
    )
    any_hit: bool = column("query", show={True: "any hit", False: "nearest hit"}.get)
    tool: str = column("tool")
    version: str = column("version")
    hit: float = column("hit", "fraction of the rays with a hit", show=".0%")
    differ: int = column("differ", "largest number of rays for which a tool and the wide tree disagree about a hit")
    rays: int = column("rays")
    million_per_second: Spread = column("million/s", "million rays per second by the wide tree on one thread", show=".3g")
    ours: Spread | None = column("/ tool", "speed of the wide tree over that of the tool on one thread, in the same round")
    gain: Spread = column(
        "all / 1 thread", "speed with all threads over the speed with one thread, in the same round", show=".2f"
    )
    nodes: float | None = column(
        "nodes", "mean number of nodes of the wide tree that a ray visits; unknown for other tools", show=".1f"
    )
    leaves: float | None = column("leaves", "mean number of leaves, of up to 16 triangles, that a ray visits", show=".1f")


@dataclass(frozen=True)
class BuildTime(Timed):
    """Row of `bench rays`: time of one tool to prepare a scene in memory for its first ray.

    The time starts with vertices and faces in memory.
    """

    scene: str = column("scene")
    triangles: int = column("triangles")
    tool: str = column("tool")
    workers: int = column("workers", show=lambda n: f"({n})" if n else "")
    milliseconds: Spread = column("ms")


@dataclass(frozen=True)
class MissingTool:
    """Row of `bench rays`: tool that is not installed, with the reason."""

    tool: str = column("tool")
    failure: str = column("why it did not run, and what to install")


def measure(
    track: Track,
    *,
    scene: Scenes = None,
    rays: Annotated[int, typer.Option(help="Number of rays of each kind.", min=64)] = 131_072,
    repeats: Repeats = 5,
) -> RowsByPart:
    """Measure tracing speed and build times on each scene; the compared runs alternate."""
    worker_counts = sorted({1, check_workers(None)})
    names = scene or list(SCENES)
    rows: RowsByPart = {"rows": [], "builds": []}
    missing: dict[str, str] = {}
    for name in track(names, len(names)):
        mesh = SCENES[name]()
        for kind, any_hit in product(KINDS, (True, False)):
            tools = build_tracers(mesh, kind, rays, missing)
            nodes, leaves = count_visits(mesh, kind, rays, any_hit)
            case = {"scene": name, "triangles": len(mesh.faces), "kind": kind, "any_hit": any_hit}
            rows["rows"] += compare(tools, worker_counts, repeats, {"nodes": nodes, "leaves": leaves}, **case)
        rows["builds"] += _measure_builds(name, mesh, missing, worker_counts, repeats)
        build_rays.cache_clear()
    return rows | {"missing": [MissingTool(*item) for item in missing.items()]}


def build_tracers(mesh: Mesh, kind: str, count: int, missing: dict[str, str]) -> dict[str, RayTool]:
    """Build the installed ray tracers of `TRACERS`; add the reason for each missing tool to `missing`."""
    tools = {name: _tracer_or_reason(tool.make, tool.library, mesh, kind, count) for name, tool in TRACERS.items()}
    missing |= {name: tool for name, tool in tools.items() if isinstance(tool, str)}
    return {name: tool for name, tool in tools.items() if not isinstance(tool, str)}


def _tracer_or_reason(make: Any, library: str, *rays: Any) -> RayTool | str:
    try:
        return make(*rays)
    except (ImportError, OSError) as error:  # OSError: Open3D does not find a system library
        return f"{error}; pip install {library}"


def compare(
    tools: dict[str, RayTool], worker_counts: list[int], repeats: int, visited: dict[str, float], **case: Any
) -> list[RaySpeed]:
    """Measure the tracing speed of all tools on one set of rays and one query, with alternating runs.

    Args:
        tools: tools by name, with their rays; "wide" must be one of the names.
        worker_counts: numbers of workers.
        repeats: timed runs.
        visited: fields `nodes` and `leaves` of the wide tree.
        **case: fields `scene`, `triangles`, `kind` and `any_hit` of all rows.
    """
    hits = {name: tool(case["any_hit"], 1)() for name, tool in tools.items()}
    works = {(name, workers): tools[name](case["any_hit"], workers) for name, workers in product(tools, worker_counts)}
    seconds = time_interleaved(works, repeats)
    return [
        RaySpeed(
            **case,
            tool=name,
            version=version(TRACERS[name].library) if name in TRACERS else "",
            hit=float(hit.mean()),
            differ=max(int(np.count_nonzero(other != hits["wide"])) for other in hits.values()),
            rays=len(hit),
            million_per_second=Spread.of([len(hit) / t / 1e6 for t in seconds[name, 1]]),
            ours=Spread.of_ratios(seconds[name, 1], seconds["wide", 1]) if name != "wide" else None,
            gain=Spread.of_ratios(seconds[name, 1], seconds[name, worker_counts[-1]]),
            **(visited if name == "wide" else {"nodes": None, "leaves": None}),
            seconds=seconds[name, 1],
        )
        for name, hit in hits.items()
    ]


def _measure_builds(
    scene: str, mesh: Mesh, missing: dict[str, str], worker_counts: list[int], repeats: int
) -> list[BuildTime]:
    works = {
        (name, workers if name.startswith("wide") else 0): work
        for workers in worker_counts
        for name, work in list_builds(mesh, workers).items()
        if name not in missing
    }
    return [
        BuildTime(scene, len(mesh.faces), *case, Spread.of([1e3 * t for t in seconds]), seconds=seconds)
        for case, seconds in time_interleaved(works, repeats).items()
    ]


def _select_for_page(rows: list[Any]) -> list[Any]:
    return [row for row in rows if row.scene != "hills" and row.triangles != 48_800 and getattr(row, "kind", "") != "camera"]


_CELLS = [
    *(Cell(name, where=(("tool", "wide"),)) for name in ("hit", "million_per_second", "gain")),
    *(Cell("ours", f"/ {tool}", where=(("tool", tool),)) for tool in TRACERS if tool != "wide"),
    *(Cell(name, where=(("tool", "wide"),)) for name in ("nodes", "leaves", "differ")),
]

RECORD = Benchmark(
    name="rays",
    summary="Compare rays per second and build times of warpsample, wp.Mesh, Embree and Open3D on five meshes.",
    measure=measure,
    parts={"rows": RaySpeed, "builds": BuildTime, "missing": MissingTool},
    views=[
        TableView(
            "rows",
            "Speed of the wide tree, and its ratio to each tool's speed",
            "triangles kind",
            _CELLS,
            split="any_hit",
            page_rows=_select_for_page,
        ),
        TableView(
            "builds",
            "Build time, milliseconds (threads)",
            "triangles",
            "milliseconds",
            across="tool workers",
            page_rows=_select_for_page,
        ),
    ],
    pictures=[Picture("rays", "rows", "kind", y="million_per_second", panels="scene", down="any_hit")],
)
