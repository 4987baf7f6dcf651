"""What was measured, as tables to read and as a JSON file to keep."""

import json
from collections.abc import Iterable, Sequence
from dataclasses import asdict
from math import log10
from pathlib import Path
from typing import TYPE_CHECKING, Any

from warpsample.bench import directions, error, peers, rays, scaling, visibility
from warpsample.bench.machine import machine
from warpsample.bench.startup import Startup
from warpsample.bench.timing import Spread
from warpsample.host.files import write_bytes

if TYPE_CHECKING:
    from rich.console import Console

_SPREAD = "medians; in brackets the range of the middle half of the repeats"


def save(path: Path, command: str, settings: dict[str, Any], **measured: Iterable[Any]) -> None:
    """Writes machine, settings and every row with all its repeats; complete or not at all."""
    rows = {name: [asdict(row) for row in found] for name, found in measured.items()}
    text = json.dumps({"command": command, "machine": machine(), "settings": settings, **rows}, indent=1)
    write_bytes(path, text.encode())


def heading(console: "Console", what: str) -> None:
    """Says what is measured, where and how to read it."""
    console.print(what)
    console.print(", ".join(f"{key} {value}" for key, value in machine().items()), highlight=False)


def show_directions(console: "Console", rows: list[directions.Row], starts: list[Startup]) -> None:
    """Maps, sequences and start-up."""
    heading(console, f"sample_directions into an existing (P, n, 3) float32 array: {_SPREAD}.")
    _show_maps(console, [row for row in rows if row.table == "maps"])
    _show_sequences(console, [row for row in rows if row.table == "sequences"])
    cells = [
        [s.kernel_cache, *(f"{t:.2f}" for t in (s.import_warp, s.import_warpsample, s.first_directions, s.further_kernel))]
        for s in starts
    ]
    headings = ["kernel cache", "import warp", "+ import warpsample", "first directions", "each further kernel"]
    _table(console, "A new process, seconds (compiling: the cold line)", headings, cells)


def _show_maps(console: "Console", rows: list[directions.Row]) -> None:
    samplers = [row for row in rows if row.distribution != "fill"]
    everyone = max(row.workers for row in samplers)
    cells = []
    for name in dict.fromkeys(row.distribution for row in samplers):
        by_case = {(row.workers, row.pdf): row for row in samplers if row.distribution == name}
        best = by_case[everyone, False]
        alone, with_pdf = (by_case.get(case) for case in ((1, False), (everyone, True)))
        cells.append(
            [
                directions.short_name(name) + (" *" if best.sequence == directions.GIVEN else ""),
                _figure(alone and alone.nanoseconds.median),
                _spread(best.nanoseconds),
                _figure(with_pdf and with_pdf.nanoseconds.median),
                _spread(best.of_fill),
                *(f"{best.worst[law]:.1e}" if law in best.worst else "–" for law in ("length", "angle", "pdf")),
            ]
        )
    title = f"Maps: ns per direction, {rows[0].points:,} points x {directions.SAMPLES}, independent"
    workers = "all workers" if everyone > 1 else "1 worker"
    headings = ["map", "1 worker", workers, "with pdf", "share of fill", "length", "angle", "pdf"]
    _table(console, title, headings, cells)
    console.print("length, angle, pdf: worst errors against float64 (unit length; radians; relative), frame included")
    if any(row.sequence == directions.GIVEN for row in samplers):
        console.print("*: the map alone, u given, into a new array")
    fills = [row.nanoseconds.median for row in rows if row.distribution == "fill"]
    console.print(
        f"ceiling: NumPy's out.fill(0) of the same array, 1 thread: {_spread(Spread.of(fills))} ns per direction\n"
    )


def _show_sequences(console: "Console", rows: list[directions.Row]) -> None:
    samplers = [row for row in rows if row.distribution != "fill"]
    counts = list(dict.fromkeys(row.samples for row in rows))
    cases = list(dict.fromkeys((row.sequence, row.workers) for row in samplers))
    found = {(row.sequence, row.workers, row.samples): row for row in rows}
    total = f"{rows[-1].points * rows[-1].samples:,} directions, cosine lobe, polar"
    headings = ["sequence", "workers", *(f"n = {n}" for n in counts)]
    speeds = [[s, str(w), *(_spread(found[s, w, n].million_per_second) for n in counts)] for s, w in cases]
    fill = [_figure(found["", 1, n].million_per_second.median) for n in counts]
    _table(
        console,
        f"Sequences: million directions a second by samples per point, {total}",
        headings,
        [*speeds, ["ceiling (fill)", "1", *fill]],
    )
    shares = [[s, str(w), *(_spread(found[s, w, n].of_fill) for n in counts)] for s, w in cases]
    _table(console, "The same as a share of the fill's speed right after", headings, shares)


def show_error(console: "Console", curves: list[error.Curve], rmse: float) -> None:
    """A table for each integrand."""
    heading(console, "RMSE of means over the cosine lobe, and wall time of one estimate, all workers, sampling included.")
    for name in dict.fromkeys(curve.integrand for curve in curves):
        chosen = [curve for curve in curves if curve.integrand == name]
        shown = [p.count for p in chosen[0].points if round(log10(p.count) / log10(4)) % 2 == 0]
        cells = [
            [
                curve.sequence,
                *(f"{p.rmse:.1e}" for p in curve.points if p.count in shown),
                "–" if curve.slope is None else f"{curve.slope:.2f}",
                *(f"{p.microseconds.median:.3g}" for p in curve.points if p.count == shown[-1]),
                _time_to(curve, rmse),
                f"{curve.efficiency:.3g}",
            ]
            for curve in chosen
        ]
        headings = [
            "sequence",
            *(f"N = {n:,}" for n in shown),
            "slope",
            f"µs at {shown[-1]:,}",
            f"µs to {rmse:g}",
            "efficiency",
        ]
        _table(console, f"{name} ({chosen[0].kind}), mean {chosen[0].mean:.6f}", headings, cells)
    _show_best(console, curves, rmse)
    console.print(
        f"slope: of log RMSE over log N from 16 on, above float32's floor of {error.FLOOR:g}. ~: by that slope, beyond the "
        f"N measured. <: reached by the least N.\nefficiency: 1/(variance x time) at N = {error.COMPARED_AT:,} over that of "
        "independent; an RMSE below the floor counts as the floor."
    )


def _show_best(console: "Console", curves: list[error.Curve], rmse: float) -> None:
    sequences = list(dict.fromkeys(curve.sequence for curve in curves))
    found = {(curve.integrand, curve.sequence): curve for curve in curves}
    cells = []
    for name in dict.fromkeys(curve.integrand for curve in curves):
        mine = [found[name, sequence] for sequence in sequences]
        times = {curve.sequence: reached[0] for curve in mine if (reached := curve.reaching(rmse))}
        best = min(times, key=times.__getitem__) if times else "–"
        cells.append([name, *(_time_to(curve, rmse) for curve in mine), best])
    _table(console, f"In short: µs to an RMSE of {rmse:g}", ["integrand", *sequences, "fastest"], cells)


def _time_to(curve: error.Curve, rmse: float) -> str:
    reached = curve.reaching(rmse)
    if reached is None:
        return "never"
    microseconds, beyond = reached
    sign = "" if not beyond else "<" if rmse > curve.points[0].rmse else "~"
    return f"{sign}{microseconds:.3g}"


def show_peers(console: "Console", rows: list[peers.Row], targets: list[peers.ToError]) -> None:
    """A table for each job, and the times to an error."""
    heading(console, f"The same job by other tools, a process each, taking turns: {_SPREAD}.")
    titles = {
        "directions": f"Directions of the cosine lobe, {peers.SAMPLES} at each normal, float32, million a second",
        "surface": "Points on a mesh, uniform by area, million a second",
    }
    for job, title in titles.items():
        chosen = [row for row in rows if row.job == job]
        cells = [
            [row.peer, row.library, str(row.threads), _spread(row.million_per_second), _spread(row.ours), _agreement(row)]
            for row in chosen
            if row.failure is None
        ]
        if not chosen:
            continue
        ours = f"{peers.OURS[job].removeprefix('warpsample ')} / it"
        _table(console, title, ["tool", "version", "threads", "M/s", ours, "off by"], cells)
        for row in chosen:
            if row.failure is not None:
                console.print(f"{row.peer}: {row.failure}")
    console.print(
        "off by: the means of seven integrals, three on the mesh, worst against the exact value, in standard errors\n"
    )
    if targets:
        cells = [
            [
                t.integrand,
                f"{t.rmse:g}",
                f"{t.samples:,}",
                f"{t.microseconds.median:.3g}",
                t.peer,
                f"{t.independent_samples:,.0f}",
                f"{t.peer_microseconds:.3g}",
                f"{t.ratio:,.0f}",
            ]
            for t in targets
        ]
        headings = ["integrand", "RMSE", "N", "µs", "fastest other", "N", "µs", "ratio"]
        _table(
            console,
            "Time to an RMSE at a point, sampling alone: ours by default (sobol), theirs independent",
            headings,
            cells,
        )


def _agreement(row: peers.Row) -> str:
    if row.worst_deviation is None:
        return "–"
    return f"{row.worst_deviation:.1f}" + ("" if row.agrees else " WRONG")


def show_scaling(console: "Console", rows: list[scaling.Row]) -> None:
    """A table for each axis."""
    heading(console, f"Streamed directions of the default, a process to each case: {_SPREAD}.")
    for axis in dict.fromkeys(row.axis for row in rows):
        cells = [
            [
                f"{row.points:,}",
                f"{row.samples:,}",
                str(row.workers),
                _spread(row.nanoseconds),
                "–" if row.peak_megabytes is None else f"{row.peak_megabytes:.0f}",
            ]
            for row in rows
            if row.axis == axis
        ]
        _table(console, f"By {axis}", ["points", "samples", "workers", "ns per direction", "peak memory, MB"], cells)


def show_rays(console: "Console", rows: list[rays.Row], builds: list[rays.Build], missing: dict[str, str]) -> None:
    """A table for each query, and one of builds."""
    heading(console, f"The same rays by each tool, taking turns: {_SPREAD}.")
    everyone = max(row.workers for row in rows)
    found = {(row.scene, row.kind, row.any_hit, row.tool, row.workers): row for row in rows}
    sets = dict.fromkeys((row.scene, row.triangles, row.kind) for row in rows)
    others = [tool for tool in dict.fromkeys(row.tool for row in rows) if tool != "wide"]
    for any_hit, query in ((True, "any hit"), (False, "nearest hit")):
        cells = []
        for scene, triangles, kind in sets:
            alone, together = (found[scene, kind, any_hit, "wide", workers] for workers in (1, everyone))
            theirs = [found[scene, kind, any_hit, tool, 1] for tool in others]
            cells.append(
                [
                    f"{triangles:,} {kind}",
                    f"{100 * alone.hit:.0f}",
                    _figure(alone.million_per_second.median),
                    _figure(Spread.of_ratios(alone.seconds, together.seconds).median),
                    *(_spread(Spread.of_ratios(row.seconds, alone.seconds)) for row in theirs),
                    f"{alone.nodes:.1f}, {alone.leaves:.1f}",
                    f"{max((row.differ for row in theirs), default=0):,}",
                ]
            )
        title = f"{query}: wide, million rays a second, 1 worker; times as fast as each tool on 1 thread"
        headings = [
            "triangles, rays",
            "hit %",
            "M/s",
            f"by {everyone}",
            *(f"/ {tool}" for tool in others),
            "visits",
            "differ",
        ]
        _table(console, title, headings, cells)
    console.print(
        f"by {everyone}: times as fast by {everyone} workers. visits: nodes, and leaves of up to 16 triangles, of a ray, on "
        f"average. differ: of {max(row.rays for row in rows):,} rays, those that some tool says otherwise about.\n"
    )
    tools = dict.fromkeys((build.tool, build.workers) for build in builds)
    times = {(build.scene, build.tool, build.workers): build.milliseconds for build in builds}
    cells = [
        [f"{triangles:,}", *(_spread(times[scene, tool, workers]) for tool, workers in tools)]
        for scene, triangles in dict.fromkeys((build.scene, build.triangles) for build in builds)
    ]
    headings = ["triangles", *(f"{tool} ({workers})" if workers else tool for tool, workers in tools)]
    _table(console, "Building, milliseconds (workers)", headings, cells)
    for tool, remedy in missing.items():
        console.print(f"{tool}: {remedy}")


def show_visibility(console: "Console", rows: list[visibility.Row], many: visibility.Many) -> None:
    """A table for each scene and RMSE, and a line about many points."""
    heading(console, f"Ambient occlusion, its rays and everything before them, to an RMSE over all points: {_SPREAD}.")
    for scene, target, open_points in dict.fromkeys((row.scene, row.target, row.open_points) for row in rows):
        mine = [row for row in rows if (row.scene, row.target, row.open_points) == (scene, target, open_points)]
        cells = [
            [
                f"{row.tool} ({row.version})",
                f"{row.rays:,}",
                f"{row.cast:,.0f}",
                f"{row.rmse:.4f}",
                _spread(row.microseconds),
                _spread(row.times_ours),
            ]
            for row in mine
            if row.microseconds and row.times_ours
        ]
        measured = next(row for row in mine if row.points)
        what = "only points that see nothing but sky, rays as for all" if open_points else f"RMSE {target:g}"
        title = f"{scene}, {measured.points:,} points, {measured.workers} workers: {what}"
        _table(console, title, ["tool", "rays", "cast", "RMSE", "µs per point", "times ours"], cells)
    memory = f", {many.peak_megabytes:,.0f} MB at most, Python, mesh and points included" if many.peak_megabytes else ""
    console.print(f"{many.scene}, {many.points:,} points x {many.rays} rays: {many.seconds:.1f} s{memory}.")
    for tool, failure in dict.fromkeys((row.tool, row.failure) for row in rows if row.failure):
        console.print(f"{tool}: {failure}; pip install mitsuba embreex open3d", markup=False)


def _table(console: "Console", title: str, headings: Sequence[str], cells: Iterable[Sequence[str]]) -> None:
    from rich.box import SIMPLE  # noqa: PLC0415
    from rich.table import Table  # noqa: PLC0415

    table = Table(title=title, box=SIMPLE, padding=(0, 1, 0, 0), title_justify="left")
    for i, text in enumerate(headings):
        table.add_column(text, justify="left" if i == 0 else "right", overflow="fold")
    for row in cells:
        table.add_row(*row)
    console.print(table)


def _figure(x: float | None) -> str:
    """Three digits, and no more than two places."""
    return "–" if x is None else f"{x:,.{0 if x >= 100 else 1 if x >= 10 else 2}f}"


def _spread(spread: Spread | None) -> str:
    return "–" if spread is None else f"{_figure(spread.median)} ({_figure(spread.low)}–{_figure(spread.high)})"
