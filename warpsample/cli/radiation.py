"""What the command line says of sun and sky: `view-factors` and `shading`."""

from pathlib import Path
from typing import Annotated

import typer

from warpsample.cli.terminal import MeshFile, Workers, option, output_file, working


def view_factors_command(
    mesh: MeshFile,
    output: Annotated[Path, output_file(".npz .vf, or vfsparse.inp and more")],
    *,
    count: Annotated[int, typer.Option(help="Rays of each face.")] = 4096,
    groups: Annotated[
        Path | None, option("Text or .npy: the number of each face's surface; or part, the named ones.")
    ] = None,
    reciprocal: Annotated[bool, typer.Option("--reciprocal", help="Pool both directions of each pair, and close.")] = False,
    up: Annotated[tuple[float, float, float] | None, option("The sky's axis, to part sky from ground.")] = None,
    seed: Annotated[int, typer.Option(help="Seed of the rays.")] = 0,
    workers: Workers = None,
) -> None:
    """Estimate the view factors between all faces of a mesh, what is in the way included, into a sparse matrix."""
    from warpsample.radiation.exchange.run import run_view_factors

    options = {"count": count, "reciprocal": reciprocal, "up": up, "seed": seed, "workers": workers}
    with working(f"reading {mesh}, casting rays, writing {output}; kernels are compiled when first used, for about 5 s"):
        print(run_view_factors(mesh, output, groups, options))


def shading_command(
    mesh: MeshFile,
    groups: Annotated[
        Path,
        typer.Argument(help="Text with a line for each triangle: its surface's name in EnergyPlus.", show_default=False),
    ],
    output: Annotated[Path, output_file(".csv")],
    *,
    weather: Annotated[Path, option("The place and its hours, .epw, or athens, an example.")],
    samples: Annotated[int, typer.Option(help="Points of each surface, uniform by area.")] = 1024,
    up: Annotated[tuple[float, float, float], typer.Option(help="The sky's axis.")] = (0.0, 0.0, 1.0),
    north: Annotated[tuple[float, float, float], typer.Option(help="Where north is.")] = (0.0, 1.0, 0.0),
    seed: Annotated[int, typer.Option(help="Seed of the points.")] = 0,
    workers: Workers = None,
) -> None:
    """Write the sunlit share of surfaces in each hour of a year, as EnergyPlus reads it: Schedule:File:Shading."""
    from warpsample.output.shading import Shading, write_shading

    with working(f"reading {mesh}, casting rays, writing {output}; kernels are compiled when first used, for about 10 s"):
        summary = write_shading(Shading(mesh, groups, output, weather, samples, up, north, seed), workers)
    print(f"{output}: {summary}")
