"""All view factors of a mesh by each tool, in turns; error, memory and entries."""

import tempfile
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated, Any

import numpy as np
import typer

from warpsample.bench.record import Repeats, Track
from warpsample.bench.timing import Spread
from warpsample.bench.turns import take_turns
from warpsample.bench.view_factors.jobs import build_factors, reference_rows
from warpsample.bench.view_factors.scenes import scene_of
from warpsample.bench.view_factors.tools import OURS, PAIRS, TOOLS, TRACE
from warpsample.host.engine import check_workers

SMALL_SCENES = ("boxes 6", "city 4")
"""540 and 1,128 faces."""

_MOST_APART = 1.3  # square error over the one that is due
_MOST_RELATIVE = 0.25  # RMSE over the RMS of the factors, of a tool that one ray for a pair makes coarse
_FEWER = 16  # times fewer rays of embreex on the large city, which takes half a minute for all


@dataclass(frozen=True)
class Settings:
    """Of the command."""

    side: Annotated[int, typer.Option(help="Blocks along a side of the large city; 18 are 22,344 faces.", min=1)] = 18
    rays: Annotated[int, typer.Option(help="Of each face.", min=64)] = 4096
    repeats: Repeats = 3


@dataclass(frozen=True)
class Factors:
    """One tool on one scene.

    Attributes:
        scene: its name and size.
        faces: of it.
        workers: threads.
        tool: its name.
        failure: why there is nothing, then the rest is None.
        version: of its library.
        rays: of each face.
        took: seconds; of the tracing alone as for all faces, from some of them.
        traces: how many times as long as the tracing alone of as many rays, in the same round.
        rmse: over the entries of some rows, zeros included; None for the tracing alone.
        rate: the power of the rays by which the RMSE of ours falls, from a quarter of them on.
        times_ours: as long as ours to the same RMSE, extrapolated: rays by as many more of them, others by fewer of ours.
        due: square error over what is due, by our error bars or for independent rays; None for what has no chance in it.
        relative: RMSE over the RMS of the factors.
        agrees: whether `due` is below 1.3, or without it `relative` below 0.25.
        entries: of the matrix.
        peak_megabytes: greatest resident memory of the process, everything included; None where unknown.
        above: of these, above what it had with libraries and mesh loaded and a small mesh's factors computed.
        seconds: of each repeat; none where they were not kept.
    """

    scene: str
    faces: int
    workers: int
    tool: str
    failure: str | None = None
    version: str | None = None
    rays: int | None = None
    took: Spread | None = None
    traces: Spread | None = None
    rmse: float | None = None
    rate: float | None = None
    times_ours: Spread | None = None
    due: float | None = None
    relative: float | None = None
    agrees: bool | None = None
    entries: int | None = None
    peak_megabytes: float | None = None
    above: float | None = None
    seconds: list[float] = field(default_factory=list)


@dataclass(frozen=True)
class Found:
    """Of every scene and tool."""

    rows: list[Factors]


def measure(settings: Settings, track: Track) -> Found:
    """The small city by one thread and by all, boxes and the large city by all, the latter once."""
    most = check_workers(None)
    tools = [*TOOLS, TRACE]
    boxes, city = SMALL_SCENES
    cases = [(boxes, most, tools, settings.repeats)]
    cases += [(city, workers, tools, settings.repeats) for workers in sorted({1, most})]
    cases.append((f"city {settings.side}", most, [tool for tool in tools if tool != PAIRS], 0))
    return Found([row for case in track(cases, len(cases)) for row in compare(*case, settings.rays)])


def compare(scene: str, workers: int, tools: Sequence[str], repeats: int, rays: int) -> list[Factors]:
    """Tools on one scene, taking turns.

    Args:
        scene: as `scene_of` takes it.
        workers: threads.
        tools: names, with ours and the tracing alone.
        repeats: timed runs; without any the first run of each is the timed one.
        rays: of each face; embreex gets fewer where pyViewFactor does not take part.
    """
    mesh = scene_of(scene)
    with tempfile.TemporaryDirectory() as folder:
        reference = Path(folder) / "reference.npy"
        np.save(reference, reference_rows(mesh, workers), allow_pickle=False)
        same: dict[str, Any] = {"scene": scene, "workers": workers, "reference": str(reference)}
        fewer = rays if PAIRS in tools else rays // _FEWER
        turns = take_turns(build_factors, tools, repeats, **same, rays=rays, fewer=fewer)
    rows = [Factors(scene, len(mesh.faces), workers, tool, failure) for tool, failure in turns.failures.items()]
    seconds = {
        tool: [t * turns.told[tool]["scale"] for t in times or [turns.told[tool]["first"]]]
        for tool, times in turns.seconds.items()
    }
    for tool, times in seconds.items():
        told = turns.told[tool]
        factor = told["rays"] / rays  # the tracing alone, of as many
        rows.append(
            Factors(
                scene,
                len(mesh.faces),
                workers,
                tool,
                version=told["version"],
                rays=None if tool == PAIRS else told["rays"],
                took=Spread.of(times),
                traces=Spread.of_ratios(times, [factor * t for t in seconds[TRACE]]),
                seconds=times,
                **({} if tool == TRACE else judged(told, turns.told[OURS], times, seconds[OURS])),
            )
        )
    return rows


def judged(told: dict[str, Any], ours: dict[str, Any], times: list[float], our_times: list[float]) -> dict[str, Any]:
    """Fields of `Factors` that have to do with the error.

    Args:
        told: a tool's report.
        ours: that of ours.
        times: its seconds.
        our_times: those of ours.
    """
    more = told["rmse"] / ours["rmse"]
    # Independent rays at their own rate; what knows no rays, or shares ours, beside ours of as large an error.
    factor = more**2 if told["independent"] else float(np.float_power(more, 1.0 / ours["rate"]))
    due = None if told["due"] is None else told["rmse"] ** 2 / told["due"]
    return {
        "rmse": told["rmse"],
        "rate": told["rate"],
        "times_ours": Spread.of_ratios([factor * t for t in times], our_times),
        "due": due,
        "relative": told["relative"],
        "agrees": bool(told["relative"] <= _MOST_RELATIVE if due is None else due <= _MOST_APART),
        "entries": told["entries"],
        "peak_megabytes": told["peak_megabytes"],
        "above": told["above"],
    }
