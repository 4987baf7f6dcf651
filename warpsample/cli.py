"""The `warpsample` command."""

import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Annotated, Any, Literal

import typer
import warp as wp

from warpsample import distributions, sequences
from warpsample.mesh import load_mesh

app = typer.Typer(no_args_is_help=True, add_completion=False, help="Directions around the normals of a mesh.")
bench_app = typer.Typer(no_args_is_help=True, help="Run time, measured on this machine.")
app.add_typer(bench_app, name="bench")

_SPATIAL = (name for name in distributions.names() if distributions.get(name).width == 3)
DISTRIBUTION_HELP = f"A name, or one with parameters as in 'beckmann(alpha=0.1)': {', '.join(_SPATIAL)}."
_PIPE_WIDTH = 120  # of tables where there is no terminal to fit

Repeats = Annotated[int, typer.Option(help="Timed runs of each case, each after untimed ones.", min=1)]
JsonFile = Annotated[Path | None, typer.Option(help="A file for machine, settings and every repeat.", show_default=False)]
PlotFolder = Annotated[Path | None, typer.Option(help="A folder for pictures; made if need be.", show_default=False)]
MeshFile = Annotated[Path, typer.Argument(help="Mesh file: .ply .obj .stl .off .glb .gltf .usd.", show_default=False)]


@contextmanager
def fail_plainly() -> Iterator[None]:
    """Turns an error about the input into one line on stderr and exit status 2; anything else keeps its traceback."""
    try:
        yield
    except (ValueError, TypeError, OSError, MemoryError, ModuleNotFoundError, RuntimeError) as error:
        print(f"error: {error}", file=sys.stderr)  # noqa: T201
        raise SystemExit(2) from error
    except KeyboardInterrupt as interrupt:
        print(str(interrupt) or "interrupted; nothing was written", file=sys.stderr)  # noqa: T201
        raise SystemExit(130) from None


def show_or_save(picture: Any, screenshot: Path | None, what: str) -> None:
    """The end of a script that makes pictures: a window, or a file and a line on stdout that says what it shows.

    Args:
        picture: a PyVista plotter or a matplotlib figure.
        screenshot: the file; None opens a window.
        what: is to be seen.
    """
    from warpsample.plotting import rendering, scenes  # noqa: PLC0415

    figure = hasattr(picture, "savefig")
    if screenshot is None:
        (scenes.figure_in_window(picture) if figure else picture).show()
        return
    if figure:
        rendering.save_figure(picture, screenshot)
    else:
        rendering.save_scene(picture, screenshot, what)
    print(f"{screenshot}: {what}")  # noqa: T201


@app.command()
@fail_plainly()
def info(mesh: MeshFile) -> None:
    """Say what is in a mesh file and what is wrong with it."""
    from rich.console import Console  # noqa: PLC0415
    from rich.table import Table  # noqa: PLC0415

    report = load_mesh(mesh).report
    table = Table(title=str(mesh), show_header=False, title_justify="left")
    table.add_column(style="bold")
    table.add_column(justify="right")
    table.add_column(style="dim")
    rows = [
        ("vertices", f"{report.vertices:,}", ""),
        ("faces", f"{report.faces:,}", "triangles"),
        ("area", f"{report.area:.6g}", "square units"),
        *(
            (f"{axis} from, to", f"{low:.6g}, {high:.6g}", "")
            for axis, low, high in zip("xyz", report.lower, report.upper, strict=True)
        ),
        ("degenerate faces", f"{report.degenerate_faces:,}", "no area, so no points"),
        ("duplicate faces", f"{report.duplicate_faces:,}", "same three vertices"),
        ("unused vertices", f"{report.unreferenced_vertices:,}", "no normal"),
        ("boundary edges", f"{report.boundary_edges:,}", "open there"),
        ("non-manifold edges", f"{report.nonmanifold_edges:,}", "over two faces"),
        ("inconsistent edges", f"{report.inconsistent_edges:,}", "wound both ways"),
    ]
    for row in rows:
        table.add_row(*row)
    Console().print(table)


@app.command("directions")
@fail_plainly()
def directions_command(
    mesh: MeshFile,
    output: Annotated[Path, typer.Option("--output", "-o", help="The file to write: .npz .vtp .ply.", show_default=False)],
    count: Annotated[int, typer.Option(help="Surface points; only for the placement 'surface'.")] = 10_000,
    samples: Annotated[int, typer.Option(help="Directions at each point.")] = 64,
    distribution: Annotated[str, typer.Option(help=DISTRIBUTION_HELP)] = "cosine_hemisphere",
    sequence: Annotated[str, typer.Option(help=f"One of: {', '.join(sequences.names())}.")] = "sobol",
    seed: Annotated[int, typer.Option(help="Seed of points and directions.")] = 0,
    placement: Annotated[Literal["surface", "faces", "vertices"], typer.Option(help="Where the points are.")] = "surface",
    workers: Annotated[int | None, typer.Option(help="Threads; all cores by default.", show_default=False)] = None,
) -> None:
    """Sample directions at points of a mesh into a file; .npz holds all that is needed to repeat the run."""
    from warpsample.export import Run, export  # noqa: PLC0415

    summary = export(Run(mesh, output, count, samples, distribution, sequence, seed, placement), workers)
    print(f"{output}: {summary}")  # noqa: T201


@app.command("bake")
@fail_plainly()
def bake_command(
    mesh: MeshFile,
    output: Annotated[
        Path, typer.Option("--output", "-o", help="The file to write: .ply .vtp .glb .npz .csv.", show_default=False)
    ],
    quantity: Annotated[
        Literal["ao", "sky", "irradiance"], typer.Option(help="Ambient occlusion, sky view or light.")
    ] = "ao",
    at: Annotated[Literal["vertices", "faces", "surface"], typer.Option(help="Where: of faces, the centres.")] = "vertices",
    points: Annotated[int, typer.Option(help="How many; only at 'surface'.")] = 10_000,
    samples: Annotated[int, typer.Option(help="Rays of each point.")] = 256,
    max_distance: Annotated[
        float | None, typer.Option(help="What is farther does not hide; not for irradiance.", show_default=False)
    ] = None,
    falloff: Annotated[
        float | None, typer.Option(help="Exponent, with max-distance: less by distance; ao only.", show_default=False)
    ] = None,
    environment: Annotated[
        Path | None,
        typer.Option(help="Light, equirectangular: .hdr or .npy; irradiance only.", show_default=False),
    ] = None,
    up: Annotated[tuple[float, float, float], typer.Option(help="The sky's axis.")] = (0.0, 0.0, 1.0),
    sequence: Annotated[str, typer.Option(help=f"One of: {', '.join(sequences.names())}.")] = "fibonacci",
    seed: Annotated[int, typer.Option(help="Seed of points and rays.")] = 0,
    tolerance: Annotated[
        float | None, typer.Option(help="Standard error at which a point has rays enough.", show_default=False)
    ] = None,
    workers: Annotated[int | None, typer.Option(help="Threads; all cores by default.", show_default=False)] = None,
) -> None:
    """Estimate a number at each vertex, face or point of a mesh, with its standard error, into a file."""
    from warpsample.bake import Run, bake  # noqa: PLC0415

    options = {"sequence": sequence, "seed": seed, "tolerance": tolerance, "workers": workers}
    for name, value, quantities in (("max_distance", max_distance, ("ao", "sky")), ("falloff", falloff, ("ao",))):
        if value is not None and quantity not in quantities:
            raise ValueError(
                f"--{name.replace('_', '-')}: got {value} for {quantity}, want it for {' or '.join(quantities)} only"
            )
        if value is not None:
            options[name] = value
    print(bake(Run(mesh, output, quantity, at, points, samples, environment, up, options)))  # noqa: T201


@app.command()
@fail_plainly()
def view(
    mesh: Annotated[Path | None, typer.Argument(help="Mesh file; by default the bunny inside warp-lang.")] = None,
    points: Annotated[int, typer.Option(help="How many surface points, uniform by area.", min=1)] = 100,
    samples: Annotated[int, typer.Option(help="Directions at each point.", min=1)] = 1024,
    distribution: Annotated[
        str | None, typer.Option(help=f"{DISTRIBUTION_HELP} By default offset_sphere(rho=1.0).", show_default=False)
    ] = None,
    density: Annotated[
        str | None,
        typer.Option(help="What the directions are held against; by default their own.", show_default=False),
    ] = None,
    sequence: Annotated[str, typer.Option(help=f"One of: {', '.join(sequences.names())}.")] = "sobol",
    seed: Annotated[int, typer.Option(help="Of points and directions.")] = 0,
    up: Annotated[Literal["x", "y", "z"], typer.Option(help="The mesh's axis that points up in the picture.")] = "y",
    screenshot: Annotated[
        Path | None,
        typer.Option(help="No window, but a file: .png, or .html of the clouds to turn in a browser.", show_default=False),
    ] = None,
    size: Annotated[tuple[int, int], typer.Option(help="Width and height in pixels.")] = (1600, 900),
) -> None:
    """See directions on a mesh: clouds around points, one of them enlarged, and how well they keep to a density.

    It starts with sphere + normal, normalised, held against the cosine lobe: turn rho, and see when it is right.
    """
    from warpsample.plotting import rendering  # noqa: PLC0415
    from warpsample.viewer import start  # noqa: PLC0415

    rendering.check_output(screenshot, rendering.SCENE_SUFFIXES)
    choice = start.choice(distribution, density, sequence, samples, seed)
    start.check_size(size)
    rendering.check_rendering()
    surface = load_mesh(mesh or start.bunny())
    if screenshot is None:
        start.window(surface, points, choice, up, size)
    else:
        print(f"{screenshot}: {start.save(surface, points, choice, up, size, screenshot)}")  # noqa: T201


@bench_app.command("directions")
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
    starts = startup.measure()
    report.show_directions(_console(), rows, starts)
    _keep(json, "bench directions", {"points": points, "repeats": repeats}, rows=rows, startup=starts)
    _draw(plot, lambda caption: plots.draw_directions(rows, caption))


@bench_app.command("error")
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
    report.show_error(_console(), curves, rmse)
    settings = {"rmse": rmse, "randomisations": randomisations, "largest": largest, "repeats": repeats, "seed": 0}
    _keep(json, "bench error", settings, curves=curves)
    _draw(plot, lambda caption: plots.draw_error(curves, caption))


@bench_app.command("peers")
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
    targets = peers.time_to_error(rows, repeats)
    report.show_peers(_console(), rows, targets)
    _keep(json, "bench peers", {"points": points, "repeats": repeats}, rows=rows, time_to_error=targets)
    _draw(plot, lambda caption: plots.draw_peers(rows, caption))
    raise SystemExit(any(row.agrees is False for row in rows))


@bench_app.command("scaling")
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
    report.show_scaling(_console(), rows)
    _keep(json, "bench scaling", {"largest": largest, "repeats": repeats}, rows=rows)
    _draw(plot, lambda caption: plots.draw_scaling(rows, caption))


@bench_app.command("rays")
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
    from warpsample.registry import look_up  # noqa: PLC0415

    _check_bench(json, plot)
    names = scene or list(scenes.SCENES)
    for name in names:
        look_up(scenes.SCENES, name, "scene")
    measured = list(with_progress(bench.measure(names, rays, repeats), len(names), "measuring"))
    rows, builds = ([row for part in measured for row in getattr(part, name)] for name in ("rows", "builds"))
    report.show_rays(_console(), rows, builds, measured[0].missing)
    _keep(json, "bench rays", {"scenes": names, "rays": rays, "repeats": repeats, "seed": 0}, rows=rows, builds=builds)
    _draw(plot, lambda caption: plots.draw_rays(rows, caption))


@bench_app.command("visibility")
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
    from warpsample.registry import look_up  # noqa: PLC0415

    _check_bench(json, plot)
    names = scene or visibility.SCENES
    for name in names:
        look_up(scenes.SCENES, name, "scene")
    found = with_progress(visibility.measure(list(names), points, repeats), len(names), "measuring")
    rows = [row for part in found for row in part]
    many = visibility.measure_many(names[0], 256 * points, 256)
    report.show_visibility(_console(), rows, many)
    settings = {"scenes": list(names), "points": points, "repeats": repeats, "seed": 0}
    _keep(json, "bench visibility", settings, rows=rows, many=[many])
    _draw(plot, lambda caption: plots.draw_visibility(rows, caption))


def _check_bench(json: Path | None, plot: Path | None) -> None:
    if json is not None and not json.resolve().parent.is_dir():
        raise ValueError(f"--json: got {str(json)!r}, whose folder does not exist")
    if plot is not None:
        from warpsample.bench import plots  # noqa: PLC0415

        if plot.exists() and not plot.is_dir():
            raise ValueError(f"--plot: got {str(plot)!r}, which is a file, want a folder")
        plots.check_drawing()


def _keep(json: Path | None, command: str, settings: dict[str, Any], **measured: Any) -> None:
    from warpsample.bench import report  # noqa: PLC0415

    if json is not None:
        report.save(json, command, settings, **measured)


def _draw(plot: Path | None, draw: Callable[[str], dict[str, Any]]) -> None:
    from warpsample.bench import machine, plots  # noqa: PLC0415

    if plot is not None:
        for file in plots.save(draw(machine.caption()), plot):
            print(f"{file}", file=sys.stderr)  # noqa: T201


@app.command()
@fail_plainly()
def verify(
    thorough: Annotated[bool, typer.Option("--thorough", help="Sweep all 2^24 variates, not every fourth.")] = False,
    power: Annotated[bool, typer.Option("--power", help="Try the laws on planted defects instead.")] = False,
    plant: Annotated[
        str | None, typer.Option(help="Put this planted defect among the samplers; see --power.", show_default=False)
    ] = None,
    markdown: Annotated[bool, typer.Option("--markdown", help="The README's table of distributions instead.")] = False,
) -> None:
    """Prove every sampler: a table for each law. Exit status 1 if one is broken."""
    from warpsample.proof import report, run  # noqa: PLC0415
    from warpsample.registry import look_up  # noqa: PLC0415

    tasks = run.planted() if power else run.trial()
    if plant is not None:
        defects = {task.key: task for task in run.planted()}
        tasks.append(look_up(defects, plant, "plant"))
    outcome = dict(with_progress(run.run(tasks, thorough), len(tasks), "verifying"))
    in_order = {task: outcome[task] for task in tasks}
    verdicts = [verdict for task in in_order for verdict in in_order[task]]
    console = _console()
    if power:
        console.print(report.power_table({str(task.key): found for task, found in in_order.items()}))
        raise SystemExit(any(all(v.passed for v in found) for found in in_order.values()))
    if markdown:
        print(report.markdown(verdicts))  # noqa: T201
    else:
        report.show(verdicts, console)
        console.print(run.extent(thorough))
    raise SystemExit(not all(v.passed for v in verdicts))


def _console() -> Any:
    """For tables on stdout."""
    from rich.console import Console  # noqa: PLC0415

    return Console(width=None if sys.stdout.isatty() else _PIPE_WIDTH)


def with_progress(items: Iterable[Any], total: int, what: str) -> Iterator[Any]:
    """Shows a bar on stderr, if that is a terminal."""
    from rich.console import Console  # noqa: PLC0415
    from rich.progress import track  # noqa: PLC0415

    console = Console(stderr=True)
    return track(items, what, total, console=console, disable=not console.is_terminal)


def main() -> None:
    """Entry point."""
    wp.config.log_level = wp.LOG_WARNING  # what Warp logs goes to stdout, which belongs to the output
    app()


if __name__ == "__main__":
    main()
