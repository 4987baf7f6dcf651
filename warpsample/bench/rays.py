"""Rays a second: ours, wp.Mesh, Embree and Open3D on the same rays and threads; and how long each takes to build."""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import product

import numpy as np

from warpsample.bench.scenes import KINDS, SCENES, rays
from warpsample.bench.timing import Spread, interleave, stopwatch
from warpsample.bench.tracers import REMEDIES, TOOLS, Tool, Wide, builds
from warpsample.host.engine import check_workers
from warpsample.mesh.mesh import Mesh


@dataclass(frozen=True)
class Row:
    """One tool on one set of rays.

    Attributes:
        scene: its name.
        triangles: of the scene.
        kind: of the rays.
        any_hit: whether any hit was asked for, or the nearest.
        tool: its name.
        version: of its library.
        workers: threads.
        hit: share of the rays that meet something, by this tool.
        differ: how many rays it answers otherwise than our wide tree: hit or not.
        rays: how many.
        million_per_second: rays.
        nodes: visited by a ray, on average; None where unknown.
        leaves: likewise.
        seconds: of each repeat.
    """

    scene: str
    triangles: int
    kind: str
    any_hit: bool
    tool: str
    version: str
    workers: int
    hit: float
    differ: int
    rays: int
    million_per_second: Spread
    nodes: float | None
    leaves: float | None
    seconds: list[float]


@dataclass(frozen=True)
class Build:
    """How long a tool takes to be ready for a scene.

    Attributes:
        scene: its name.
        triangles: of the scene.
        tool: its name.
        workers: threads; 0 where the tool decides.
        milliseconds: from vertices and faces in memory to the first ray.
        seconds: of each repeat.
    """

    scene: str
    triangles: int
    tool: str
    workers: int
    milliseconds: Spread
    seconds: list[float]


@dataclass(frozen=True)
class Measured:
    """Of one scene.

    Attributes:
        rows: of every tool, kind of rays, query and number of workers.
        builds: of every tool.
        missing: what to install, by tool.
    """

    rows: list[Row]
    builds: list[Build]
    missing: dict[str, str]


def measure(scenes: list[str], count: int, repeats: int) -> Iterator[Measured]:
    """Scene by scene, all that is compared taking turns.

    Args:
        scenes: names of SCENES.
        count: rays of a set, about.
        repeats: timed runs.
    """
    everyone = sorted({1, check_workers(None)})
    for name in scenes:
        mesh = SCENES[name]()
        missing: dict[str, str] = {}
        rows = [
            row
            for kind, any_hit in product(KINDS, (True, False))
            for row in _compare(name, mesh, kind, any_hit, _tools(mesh, kind, count, missing), everyone, repeats)
        ]
        yield Measured(rows, _builds(name, mesh, missing, everyone, repeats), missing)
        rays.cache_clear()


def _tools(mesh: Mesh, kind: str, count: int, missing: dict[str, str]) -> dict[str, Tool]:
    tools: dict[str, Tool] = {}
    for name, tool in TOOLS.items():
        try:
            tools[name] = tool(mesh, kind, count)
        except (ImportError, OSError) as error:  # noqa: PERF203  (OSError: a library of the system's that Open3D wants)
            missing[name] = f"{error}; pip install {REMEDIES.get(name, name)}"
    return tools


def _compare(
    scene: str, mesh: Mesh, kind: str, any_hit: bool, tools: dict[str, Tool], everyone: list[int], repeats: int
) -> list[Row]:
    cases = [(name, workers) for name in tools for workers in everyone]
    work = {(name, workers): tools[name].hits(any_hit, workers) for name, workers in cases}
    found = {name: tools[name].hits(any_hit, 1)() for name in tools}
    times, _ = interleave([stopwatch(work[case]) for case in cases], repeats)
    wide = tools["wide"]
    visits = wide.visits(any_hit) if isinstance(wide, Wide) else None
    return [
        Row(
            scene=scene,
            triangles=len(mesh.faces),
            kind=kind,
            any_hit=any_hit,
            tool=name,
            version=tools[name].version,
            workers=workers,
            hit=float(found[name].mean()),
            differ=int(np.count_nonzero(found[name] != found["wide"])),
            rays=len(found[name]),
            million_per_second=Spread.of([len(found[name]) / t / 1e6 for t in seconds]),
            nodes=visits[0] if visits and name == "wide" else None,
            leaves=visits[1] if visits and name == "wide" else None,
            seconds=seconds,
        )
        for (name, workers), seconds in zip(cases, times, strict=True)
    ]


def _builds(scene: str, mesh: Mesh, missing: dict[str, str], everyone: list[int], repeats: int) -> list[Build]:
    cases = {
        (name, workers if name.startswith("wide") else 0): work
        for workers in everyone
        for name, work in builds(mesh, workers).items()
        if name not in missing
    }
    times, _ = interleave([stopwatch(work) for work in cases.values()], repeats)
    return [
        Build(scene, len(mesh.faces), name, workers, Spread.of([1e3 * t for t in seconds]), seconds)
        for (name, workers), seconds in zip(cases, times, strict=True)
    ]
