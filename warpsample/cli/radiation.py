"""The commands `warpsample view-factors` and `warpsample shading`."""

from pathlib import Path
from typing import Annotated

import typer

from warpsample.cli.streams import print_report
from warpsample.cli.terminal import MeshFile, Workers, option, output_file, working


def view_factors_command(
    mesh: MeshFile,
    output: Annotated[Path, output_file(".npz .vf, or vfsparse.inp with its companion files")],
    *,
    count: Annotated[int, typer.Option(help="Number of rays per face.")] = 4096,
    groups: Annotated[
        Path | None,
        option(
            "Text or .npy file with the surface number of each face, or part for the named parts. Default: each face "
            "is a surface."
        ),
    ] = None,
    reciprocal: Annotated[
        bool,
        typer.Option(
            "--reciprocal", help="Combine the rays of both faces of each pair, and scale each row of factors to sum to 1."
        ),
    ] = False,
    up: Annotated[
        tuple[float, float, float] | None,
        option("Direction of the zenith, such as 0 0 1. It divides the outside into sky and ground. Default: no division."),
    ] = None,
    seed: Annotated[int, typer.Option(help="Seed of the rays.")] = 0,
    workers: Workers = None,
) -> None:
    """Compute the view factors between all faces of a mesh, with occlusion, and write a sparse matrix."""
    from warpsample.radiation.exchange.run import run_view_factors

    options = {"count": count, "reciprocal": reciprocal, "up": up, "seed": seed, "workers": workers}
    with working(f"reading {mesh}, casting rays, writing {output}; kernels are compiled when first used, for about 5 s"):
        print_report(run_view_factors(mesh, output, groups, options))


def shading_command(
    mesh: MeshFile,
    groups: Annotated[
        Path,
        typer.Argument(help="Text file with one line per triangle: the name of its EnergyPlus surface.", show_default=False),
    ],
    output: Annotated[Path, output_file(".csv")],
    *,
    weather: Annotated[
        Path, option("Weather file (.epw) with the location and the hours, or athens for the built-in example.")
    ],
    samples: Annotated[int, typer.Option(help="Number of points per surface, placed uniformly by area.")] = 1024,
    up: Annotated[tuple[float, float, float], typer.Option(help="Direction from the ground to the zenith.")] = (
        0.0,
        0.0,
        1.0,
    ),
    north: Annotated[tuple[float, float, float], typer.Option(help="Direction of north.")] = (0.0, 1.0, 0.0),
    seed: Annotated[int, typer.Option(help="Seed of the random points.")] = 0,
    workers: Workers = None,
) -> None:
    """Write the sunlit fraction of each surface in each hour of a year, as a Schedule:File:Shading for EnergyPlus."""
    from warpsample.output.shading import Shading, write_shading

    with working(f"reading {mesh}, casting rays, writing {output}; kernels are compiled when first used, for about 10 s"):
        summary = write_shading(Shading(mesh, groups, output, weather, samples, up, north, seed), workers)
    print_report(f"{output}: {summary}")
