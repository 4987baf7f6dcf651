"""`warpsample bench`."""

import sys
from collections.abc import Callable
from pathlib import Path
from typing import Annotated, Any

import typer

from warpsample.cli.terminal import console, fail_plainly, with_progress, working
from warpsample.host.files import check_output, check_output_folder

app = typer.Typer(no_args_is_help=True, help="Run time, measured on this machine.")

Repeats = Annotated[int, typer.Option(help="Timed runs of each case, each after untimed ones.", min=1)]
JsonFile = Annotated[Path | None, typer.Option(help="A file for machine, settings and every repeat.", show_default=False)]
PlotFolder = Annotated[Path | None, typer.Option(help="A folder for pictures; made if need be.", show_default=False)]


@app.command("directions")
@fail_plainly()
def bench_directions(
    points: Annotated[int, typer.Option(help="Points, with 64 samples each, or as many directions.", min=1)] = 65_536,
    repeats: Repeats = 15,
    json: JsonFile = None,
    plot: PlotFolder = None,
) -> None:
    """Time per direction against worst error: every map, sequence and count, beside NumPy's fill of the same array."""
    from warpsample.bench import directions, plots, report, startup  # noqa: PLC0415

    _check_bench(json, plot)
    groups = directions.groups(points, repeats)
    rows = [row for group in with_progress(groups, len(groups), "measuring") for row in group()]
    with working("measuring the start of a process, with a cold and a warm kernel cache"):
        starts = startup.measure()
    report.show_directions(console(), rows, starts)
    _keep(json, "bench directions", {"points": points, "repeats": repeats}, rows=rows, startup=starts)
    _draw(plot, lambda caption: plots.draw_directions(rows, caption))


@app.command("error")
@fail_plainly()
def bench_error(
    rmse: Annotated[float, typer.Option(help="The RMSE to state the time to.", min=1e-6, max=1.0)] = 1e-3,
    randomisations: Annotated[int, typer.Option(help="Estimates of each mean, at least.", min=64)] = 256,
    largest: Annotated[int, typer.Option(help="Greatest number of samples of an estimate.", min=16)] = 65_536,
    repeats: Repeats = 7,
    json: JsonFile = None,
    plot: PlotFolder = None,
) -> None:
    """RMSE against run time: every sequence on seven integrands of known mean, from 4 samples on."""
    from warpsample.bench import error, plots, report  # noqa: PLC0415

    _check_bench(json, plot)
    groups = error.groups(randomisations, repeats, largest)
    curves = [curve for group in with_progress(groups, len(groups), "measuring") for curve in group()]
    report.show_error(console(), curves, rmse)
    settings = {"rmse": rmse, "randomisations": randomisations, "largest": largest, "repeats": repeats, "seed": 0}
    _keep(json, "bench error", settings, curves=curves)
    _draw(plot, lambda caption: plots.draw_error(curves, caption))


@app.command("peers")
@fail_plainly()
def bench_peers(
    points: Annotated[
        int, typer.Option(help="Normals, with 64 directions each; 16 times as many on a mesh.", min=1)
    ] = 65_536,
    repeats: Repeats = 15,
    json: JsonFile = None,
    plot: PlotFolder = None,
) -> None:
    """The same job by NumPy, SciPy, Numba, PyTorch, Warp's built-ins, Mitsuba, trimesh and Open3D, and by warpsample."""
    from warpsample.bench import peers, plots, report  # noqa: PLC0415

    _check_bench(json, plot)
    sizes = {"directions": points, "surface": 16 * points}
    rows = [row for job in with_progress(sizes, len(sizes), "measuring") for row in peers.measure(job, sizes[job], repeats)]
    with working("measuring the time to an error"):
        targets = peers.time_to_error(rows, repeats)
    report.show_peers(console(), rows, targets)
    _keep(json, "bench peers", {"points": points, "repeats": repeats}, rows=rows, time_to_error=targets)
    _draw(plot, lambda caption: plots.draw_peers(rows, caption))
    raise SystemExit(any(row.agrees is False for row in rows))


@app.command("scaling")
@fail_plainly()
def bench_scaling(
    largest: Annotated[int, typer.Option(help="Greatest number of points.", min=1000)] = 100_000_000,
    repeats: Repeats = 5,
    json: JsonFile = None,
    plot: PlotFolder = None,
) -> None:
    """Cost per direction and peak memory against points, samples and workers, streamed."""
    from warpsample.bench import plots, report, scaling  # noqa: PLC0415

    _check_bench(json, plot)
    count = len(scaling.cases(largest))
    rows = list(with_progress(scaling.measure(largest, repeats), count, "measuring"))
    report.show_scaling(console(), rows)
    _keep(json, "bench scaling", {"largest": largest, "repeats": repeats}, rows=rows)
    _draw(plot, lambda caption: plots.draw_scaling(rows, caption))


@app.command("rays")
@fail_plainly()
def bench_rays(
    scene: Annotated[list[str] | None, typer.Option(help="Only this one; may be repeated.", show_default=False)] = None,
    rays: Annotated[int, typer.Option(help="Rays of a set.", min=64)] = 131_072,
    repeats: Repeats = 5,
    json: JsonFile = None,
    plot: PlotFolder = None,
) -> None:
    """Rays a second against wp.Mesh, Embree and Open3D: five meshes, four kinds of rays, any and nearest hit, builds."""
    from warpsample.bench import plots, report, scenes  # noqa: PLC0415
    from warpsample.bench import rays as bench  # noqa: PLC0415
    from warpsample.host.registry import look_up  # noqa: PLC0415

    _check_bench(json, plot)
    names = scene or list(scenes.SCENES)
    for name in names:
        look_up(scenes.SCENES, name, "scene")
    measured = list(with_progress(bench.measure(names, rays, repeats), len(names), "measuring"))
    rows, builds = ([row for part in measured for row in getattr(part, name)] for name in ("rows", "builds"))
    report.show_rays(console(), rows, builds, measured[0].missing)
    _keep(json, "bench rays", {"scenes": names, "rays": rays, "repeats": repeats, "seed": 0}, rows=rows, builds=builds)
    _draw(plot, lambda caption: plots.draw_rays(rows, caption))


@app.command("visibility")
@fail_plainly()
def bench_visibility(
    scene: Annotated[list[str] | None, typer.Option(help="Only this one; may be repeated.", show_default=False)] = None,
    points: Annotated[int, typer.Option(help="Points on each scene.", min=16)] = 4096,
    repeats: Repeats = 3,
    json: JsonFile = None,
    plot: PlotFolder = None,
) -> None:
    """Time to an RMSE of ambient occlusion: ours, with and without skipping, Mitsuba, embreex, trimesh and Open3D."""
    from warpsample.bench import plots, report, scenes, visibility  # noqa: PLC0415
    from warpsample.host.registry import look_up  # noqa: PLC0415

    _check_bench(json, plot)
    names = scene or visibility.SCENES
    for name in names:
        look_up(scenes.SCENES, name, "scene")
    found = with_progress(visibility.measure(list(names), points, repeats), len(names), "measuring")
    rows = [row for part in found for row in part]
    with working(f"measuring {256 * points:,} points"):
        many = visibility.measure_many(names[0], 256 * points, 256)
    report.show_visibility(console(), rows, many)
    settings = {"scenes": list(names), "points": points, "repeats": repeats, "seed": 0}
    _keep(json, "bench visibility", settings, rows=rows, many=[many])
    _draw(plot, lambda caption: plots.draw_visibility(rows, caption))


def _check_bench(json: Path | None, plot: Path | None) -> None:
    if json is not None:
        check_output(json, "--json")
    if plot is not None:
        from warpsample.bench import plots  # noqa: PLC0415

        check_output_folder(plot, "--plot")
        plots.check_drawing()


def _keep(json: Path | None, command: str, settings: dict[str, Any], **measured: Any) -> None:
    from warpsample.bench import report  # noqa: PLC0415

    if json is not None:
        report.save(json, command, settings, **measured)


def _draw(plot: Path | None, draw: Callable[[str], dict[str, Any]]) -> None:
    from warpsample.bench import machine, plots  # noqa: PLC0415

    if plot is not None:
        with working(f"drawing into {plot}"):
            files = plots.save(draw(machine.caption()), plot)
        for file in files:
            print(f"{file}", file=sys.stderr)  # noqa: T201
