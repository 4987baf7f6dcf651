"""Rays a second: ours, wp.Mesh, Embree and Open3D on the same rays and threads; and how long each takes to build."""

from dataclasses import dataclass, field
from itertools import product
from typing import Annotated

import numpy as np
import typer

from warpsample.bench.record import Repeats, Track
from warpsample.bench.scenes import KINDS, SCENES, check_scenes, ray_set
from warpsample.bench.timing import Spread, interleave, stopwatch
from warpsample.bench.tracers import REMEDIES, TRACERS, Tracer, Wide, builds
from warpsample.host.engine import check_workers
from warpsample.mesh.mesh import Mesh


@dataclass(frozen=True)
class Settings:
    """Of the command."""

    scene: Annotated[list[str] | None, typer.Option(help="Only this one; may be repeated.", show_default=False)] = None
    rays: Annotated[int, typer.Option(help="Rays of a set.", min=64)] = 131_072
    repeats: Repeats = 5

    def __post_init__(self) -> None:
        """Refuses unknown scenes."""
        check_scenes(self.scene)


@dataclass(frozen=True)
class Speed:
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
        ours: how many times as fast our wide tree is by as many threads, in the same round; None for itself.
        gain: how many times as fast the tool is as by one thread, in the same round; None for one thread.
        nodes: visited by a ray, on average; None where unknown.
        leaves: likewise.
        seconds: of each repeat; none where they were not kept.
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
    ours: Spread | None
    gain: Spread | None
    nodes: float | None
    leaves: float | None
    seconds: list[float] = field(default_factory=list)


@dataclass(frozen=True)
class Build:
    """How long a tool takes to be ready for a scene.

    Attributes:
        scene: its name.
        triangles: of the scene.
        tool: its name.
        workers: threads; 0 where the tool decides.
        milliseconds: from vertices and faces in memory to the first ray.
        seconds: of each repeat; none where they were not kept.
    """

    scene: str
    triangles: int
    tool: str
    workers: int
    milliseconds: Spread
    seconds: list[float] = field(default_factory=list)


@dataclass(frozen=True)
class Missing:
    """A tool that is not there.

    Attributes:
        tool: its name.
        remedy: why not, and what to install.
    """

    tool: str
    remedy: str


@dataclass(frozen=True)
class Found:
    """Of every scene, tool, kind of rays, query and number of workers."""

    rows: list[Speed]
    builds: list[Build]
    missing: list[Missing]


def measure(settings: Settings, track: Track) -> Found:
    """Scene by scene, all that is compared taking turns."""
    everyone = sorted({1, check_workers(None)})
    names = settings.scene or list(SCENES)
    found = Found([], [], [])
    missing: dict[str, str] = {}
    for name in track(names, len(names)):
        mesh = SCENES[name]()
        for kind, any_hit in product(KINDS, (True, False)):
            tools = tracers_of(mesh, kind, settings.rays, missing)
            found.rows.extend(compare(name, mesh, kind, any_hit, tools, everyone, settings.repeats))
        found.builds.extend(_builds(name, mesh, missing, everyone, settings.repeats))
        ray_set.cache_clear()
    found.missing.extend(Missing(*item) for item in missing.items())
    return found


def tracers_of(mesh: Mesh, kind: str, count: int, missing: dict[str, str]) -> dict[str, Tracer]:
    """Those of TRACERS that are installed, each with its rays; the others are added to `missing`, with what to install."""
    tools: dict[str, Tracer] = {}
    for name, tool in TRACERS.items():
        try:
            tools[name] = tool(mesh, kind, count)
        except (ImportError, OSError) as error:  # noqa: PERF203  (OSError: a library of the system's that Open3D wants)
            missing[name] = f"{error}; pip install {REMEDIES.get(name, name)}"
    return tools


def compare(
    scene: str, mesh: Mesh, kind: str, any_hit: bool, tools: dict[str, Tracer], everyone: list[int], repeats: int
) -> list[Speed]:
    """One set of rays and one query by all tools, taking turns.

    Args:
        scene: its name.
        mesh: the scene.
        kind: of the rays that the tools hold.
        any_hit: whether any hit is asked for, or the nearest.
        tools: by name, "wide" among them.
        everyone: numbers of workers.
        repeats: timed runs.
    """
    cases = [(name, workers) for name in tools for workers in everyone]
    work = {(name, workers): tools[name].hits(any_hit, workers) for name, workers in cases}
    found = {name: tools[name].hits(any_hit, 1)() for name in tools}
    times, _ = interleave([stopwatch(work[case]) for case in cases], repeats)
    seconds_of = dict(zip(cases, times, strict=True))
    wide = tools["wide"]
    visits = wide.visits(any_hit) if isinstance(wide, Wide) else None
    return [
        Speed(
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
            ours=Spread.of_ratios(seconds, seconds_of["wide", workers]) if name != "wide" else None,
            gain=Spread.of_ratios(seconds_of[name, 1], seconds) if workers > 1 else None,
            nodes=visits[0] if visits and name == "wide" else None,
            leaves=visits[1] if visits and name == "wide" else None,
            seconds=seconds,
        )
        for (name, workers), seconds in seconds_of.items()
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
