"""The commands `warpsample info`, `directions` and `view`, and the registration of all commands."""

from functools import cached_property
from pathlib import Path
from typing import Annotated, Any, Literal

import typer
from typer.core import TyperGroup

import warpsample
from warpsample import distributions, sequences
from warpsample.cli import radiation, signals, stores
from warpsample.cli.bake import bake_command
from warpsample.cli.streams import escape, print_report
from warpsample.cli.terminal import (
    MESH_HELP,
    At,
    BakedFile,
    MeshFile,
    Size,
    Workers,
    fail_plainly,
    option,
    output_file,
    working,
)
from warpsample.cli.verify import verify_command
from warpsample.mesh.examples import example
from warpsample.mesh.files import load_mesh
from warpsample.mesh.files.uv import find_uv
from warpsample.mesh.points.arrays import read_array
from warpsample.texture.occlusion_picture import read_occlusion

app = typer.Typer(no_args_is_help=True, add_completion=False, context_settings={"help_option_names": ["-h", "--help"]})


class _Benchmarks(TyperGroup):
    """The commands of `warpsample bench`, imported on first use: their import takes a second."""

    def list_commands(self, ctx: Any) -> list[str]:
        return self._loaded.list_commands(ctx)

    def get_command(self, ctx: Any, cmd_name: str) -> Any:
        return self._loaded.get_command(ctx, cmd_name)

    @cached_property
    def _loaded(self) -> Any:
        from warpsample.cli.bench import app

        return typer.main.get_command(app)


_BENCH_HELP = "Measure run times and errors on this machine, and compare with other programs."
app.add_typer(typer.Typer(cls=_Benchmarks, no_args_is_help=True, help=_BENCH_HELP), name="bench")

_SPATIAL = (name for name in distributions.names() if distributions.get(name).width == 3)
DISTRIBUTION_HELP = (
    f"Distribution of the directions, with or without parameters, such as 'beckmann(alpha=0.1)': {', '.join(_SPATIAL)}."
)
AT_HELP = "'ggx(alpha=@roughness)' takes the parameter of each point from this array."
ARRAYS_HELP = "File with the arrays that --distribution names: .ply, .vtp or .npz, with one row for each"
ARRAYS_DEFAULT = "Values at vertices are interpolated to the points. Default: the mesh file."
_Sequence = Annotated[
    str, typer.Option(help=f"Sequence of random or evenly spread sample points: {', '.join(sequences.names())}.")
]
_Seed = Annotated[int, typer.Option(help="Seed of the random points and directions.")]
_Up = Annotated[
    Literal["x", "y", "z"] | None,
    option("Axis of the mesh that points up in the picture. Default: z for the courtyard, y for other meshes."),
]
_Screenshot = Annotated[
    Path | None, option("File to write instead of opening a window: .png, or .html to turn in a browser.")
]


def _print_version(is_requested: bool) -> None:
    """Print the version and exit if the option `--version` is given."""
    if is_requested:
        print(f"warpsample {warpsample.__version__}")
        raise typer.Exit


@app.callback()
def warpsample_command(
    version: Annotated[
        bool, typer.Option("--version", help="Print the version and exit.", callback=_print_version, is_eager=True)
    ] = False,
) -> None:
    """Sample directions at points of 3D models, and compute sky view, sunlight and occlusion with error bars."""


@app.command()
@fail_plainly()
def info(mesh: BakedFile) -> None:
    """Print the size, extent, defects and named parts of a mesh, the surfaces of CityJSON, or the cells of a raster."""
    from rich.console import Console
    from rich.table import Table
    from rich.text import Text

    from warpsample.output.info import describe_source

    with working(f"reading {mesh}"):
        rows = describe_source(mesh)
    table = Table(title=Text(escape(str(mesh))), show_header=False, title_justify="left")
    table.add_column(style="bold")
    table.add_column(justify="right")
    table.add_column(style="dim")
    for row in rows:
        table.add_row(*(Text(escape(cell)) for cell in row))
    Console().print(table)


@app.command("directions")
@fail_plainly()
def directions_command(
    mesh: MeshFile,
    output: Annotated[Path, output_file(".npz .vtp .ply")],
    *,
    points: Annotated[
        int | None, option("Number of points, placed uniformly by area. Default: 10,000 if --at is not given.")
    ] = None,
    at: At = None,
    samples: Annotated[int, typer.Option(help="Number of directions per point.")] = 64,
    distribution: Annotated[
        str,
        typer.Option(help=f"{DISTRIBUTION_HELP} {AT_HELP}"),
    ] = "cosine_hemisphere",
    arrays: Annotated[Path | None, option(f"{ARRAYS_HELP} vertex, face or point. {ARRAYS_DEFAULT}")] = None,
    sequence: _Sequence = "sobol",
    seed: _Seed = 0,
    workers: Workers = None,
) -> None:
    """Sample directions at points of a mesh and write a file; an .npz also records the arguments and versions."""
    from warpsample.output.export import DirectionsRun, export

    points = 10_000 if points is None and at is None else points
    with working(f"reading {mesh}, sampling, writing {output}; a kernel is compiled when it is first used, for about 2 s"):
        summary = export(DirectionsRun(mesh, output, points, samples, distribution, sequence, seed, at, arrays), workers)
    print_report(f"{output}: {summary}")


app.command("bake")(bake_command)
app.command("export")(fail_plainly()(stores.export_command))
app.command("shading")(fail_plainly()(radiation.shading_command))
app.command("view-factors")(fail_plainly()(radiation.view_factors_command))


@app.command()
@fail_plainly()
def view(
    mesh: Annotated[Path | None, typer.Argument(help=f"{MESH_HELP}. Default: the bunny of warp-lang.")] = None,
    *,
    points: Annotated[
        int | None,
        typer.Option(
            help="Number of points with clouds, placed uniformly by area. Default: 100.", min=1, show_default=False
        ),
    ] = None,
    samples: Annotated[int, typer.Option(help="Number of directions per point.", min=1)] = 1024,
    distribution: Annotated[
        str | None,
        option(
            f"{DISTRIBUTION_HELP} {AT_HELP} Default: offset_sphere(rho=1.0). The camera is the viewer of lobes that"
            " depend on a view, unless the view is given. The x axes of lobes are along u of texture coordinates."
        ),
    ] = None,
    density: Annotated[
        str | None,
        option(
            "Distribution whose density the directions are compared with. Default: the cosine lobe for offset_sphere and"
            " offset_ball, the distribution itself for others."
        ),
    ] = None,
    arrays: Annotated[Path | None, option(f"{ARRAYS_HELP} vertex or face. {ARRAYS_DEFAULT}")] = None,
    sequence: _Sequence = "independent",
    seed: _Seed = 0,
    up: _Up = None,
    screenshot: _Screenshot = None,
    size: Size = (1600, 900),
) -> None:
    """Show clouds of directions at points of a mesh, and compare the directions with a density.

    The window starts with directions normalize(n + rho s), for the normal n and
    random points s of the unit sphere, and compares them with the cosine lobe.
    They agree for rho = 1. Change rho, and the charts report that they do not
    agree.

    For a .glb or .gltf with baked occlusion the window shows the occlusion
    instead, unless --points, --distribution or --density is given.
    """
    from warpsample.mesh.files.linked_files import list_linked_files
    from warpsample.plotting import rendering
    from warpsample.viewer import start
    from warpsample.viewer.baked import show_occlusion

    rendering.check_output(screenshot, rendering.SCENE_SUFFIXES, mesh, arrays, *list_linked_files(mesh))
    chosen = any(each is not None for each in (points, distribution, density))
    path = mesh or start.bunny()
    choice = start.choice(
        distribution,
        density,
        sequence,
        samples,
        seed,
        arrays=lambda name: read_array(arrays or path, name, "--arrays").array,
    )
    rendering.check_size(size, start.LEAST_SIZE)
    with working("testing whether pictures can be drawn on this machine"):
        rendering.check_rendering()
    with working(f"reading {path}"):
        surface, occlusion, uv = _read_viewed(path)
    up = up or ("y" if example(path) is None else "z")
    if occlusion is not None and not chosen:
        with signals.at_once() if screenshot is None else working(f"drawing {screenshot}"):
            summary = show_occlusion(surface, occlusion, up=up, size=size, path=screenshot)
        print_report(f"{screenshot or path}: {summary}")
        return
    points = points or (100 if occlusion is None else 1)  # more clouds would hide the occlusion
    _show_clouds((surface, points, choice), screenshot, {"up": up, "size": size, "occlusion": occlusion, "uv": uv})


def _read_viewed(path: Path) -> tuple[Any, Any, Any]:
    """Read a mesh, its occlusion or None, and its texture coordinates or None; raise a ValueError if the file changes."""
    from warpsample.output.input_state import InputState

    state = InputState.of(path)
    found = load_mesh(path), read_occlusion(path), find_uv(path)
    state.check()
    return found


def _show_clouds(drawn: tuple[Any, ...], screenshot: Path | None, scene: dict[str, Any]) -> None:
    """Open the window of the viewer, or save its picture and print a line of description."""
    from warpsample.viewer import start

    if screenshot is None:
        with signals.at_once():
            start.window(*drawn, **scene)
        return
    with working(f"drawing {screenshot}; kernels are compiled when first used, for about 10 s"):
        summary = start.save(*drawn, **scene, path=screenshot)
    print_report(f"{screenshot}: {summary}")


app.command("verify")(verify_command)
