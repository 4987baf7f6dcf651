"""What the command line says of `bake`: its options, and which of them apply to which quantity."""

from pathlib import Path
from typing import Annotated, Literal

import typer

from warpsample import sequences
from warpsample.cli import stores
from warpsample.cli.terminal import At, MeshFile, fail_plainly, working

_APPLIES = {  # options of bake, to these quantities
    "max_distance": ("ao", "sky"),
    "falloff": ("ao",),
    "sequence": ("ao", "sky", "irradiance"),
    "tolerance": ("ao", "sky", "irradiance"),
    "period": ("irradiation", "sun-hours"),
    "ground_albedo": ("irradiation",),
    "patches": ("irradiation", "sky-matrix"),
    "north": ("irradiation", "sun-hours", "sky-matrix"),
    "device": ("ao", "sky", "irradiance"),
}


@fail_plainly(count="--samples", radiance="--environment")
def bake_command(
    mesh: MeshFile,
    output: Annotated[
        Path, typer.Option("--output", "-o", help="The file to write: .ply .vtp .glb .npz .csv .zarr.", show_default=False)
    ],
    quantity: Annotated[
        Literal["ao", "sky", "irradiance", "irradiation", "sun-hours", "sky-matrix"],
        typer.Option(help="Ambient occlusion, sky view, light; or what sun and sky bring by the weather of a year."),
    ] = "ao",
    points: Annotated[
        int | None, typer.Option(help="So many points, uniform by area; else those of --at.", show_default=False)
    ] = None,
    at: At = None,
    samples: Annotated[
        int | None,
        typer.Option(help="Rays of each point; 256, or 1,024 for irradiation and sky-matrix.", show_default=False),
    ] = None,
    max_distance: Annotated[
        float | None, typer.Option(help="Hits at or beyond it are ignored; ao and sky only.", show_default=False)
    ] = None,
    falloff: Annotated[
        float | None,
        typer.Option(help="Exponent of the decline up to --max-distance; ao only.", show_default=False),
    ] = None,
    environment: Annotated[
        Path | None,
        typer.Option(help="Light, equirectangular: .hdr or .npy; irradiance only.", show_default=False),
    ] = None,
    weather: Annotated[
        Path | None,
        typer.Option(help="A year, .epw, or athens, an example; irradiation and sun-hours only.", show_default=False),
    ] = None,
    period: Annotated[
        tuple[str, str] | None,
        typer.Option(help="Of the year, as 06-01 08-31 or 03-21T09 03-21T15; with --weather.", show_default=False),
    ] = None,
    ground_albedo: Annotated[
        float | None, typer.Option(help="Of the ground beyond the mesh, 0.2; irradiation only.", show_default=False)
    ] = None,
    patches: Annotated[
        str | None,
        typer.Option(
            help="Of the sky: tregenza (of a sky-matrix), reinhart2 (of irradiation), reinhart4.", show_default=False
        ),
    ] = None,
    up: Annotated[tuple[float, float, float], typer.Option(help="The sky's axis.")] = (0.0, 0.0, 1.0),
    north: Annotated[
        tuple[float, float, float] | None, typer.Option(help="Where north is; 0 1 0.", show_default=False)
    ] = None,
    sequence: Annotated[
        str | None,
        typer.Option(help=f"One of: {', '.join(sequences.names())}; by default fibonacci.", show_default=False),
    ] = None,
    seed: Annotated[int, typer.Option(help="Seed of points and rays.")] = 0,
    tolerance: Annotated[
        float | None, typer.Option(help="Standard error to reach, root mean square over the points.", show_default=False)
    ] = None,
    device: Annotated[
        str | None, typer.Option(help="Where to compute, as cuda:0; by default the CPU.", show_default=False)
    ] = None,
    workers: Annotated[int | None, typer.Option(help="Threads; all cores by default.", show_default=False)] = None,
    chunk: stores.Chunk = None,
    cluster: stores.Cluster = None,
    processes: stores.Processes = None,
    resume: stores.Resume = False,
) -> None:
    """Estimate a number at each vertex, face or point of a mesh, with its standard error, into a file."""
    from warpsample.output.bake import Run, bake  # noqa: PLC0415

    options = {"seed": seed, "workers": workers}
    given = {"max_distance": max_distance, "falloff": falloff, "sequence": sequence, "tolerance": tolerance}
    given |= {"device": device, "period": period, "ground_albedo": ground_albedo, "patches": patches, "north": north}
    for name, value in given.items():
        if value is not None and quantity not in _APPLIES[name]:
            raise ValueError(
                f"--{name.replace('_', '-')}: got {value} for {quantity}; it applies only to {' and '.join(_APPLIES[name])}"
            )
        if value is not None:
            options[name] = value
    samples = (1024 if quantity in ("irradiation", "sky-matrix") else 256) if samples is None else samples
    at = "vertices" if points is None and at is None else at
    with working(f"reading {mesh}, casting rays, writing {output}; kernels are compiled when first used, for about 10 s"):
        run = Run(mesh, output, quantity, at, points, samples, environment, up, options, weather)
        if output.suffix == stores.SUFFIX:
            summary = stores.bake_into_store(run, chunk, cluster, processes, resume)
        else:
            stores.refuse_for_files(output, chunk=chunk, cluster=cluster, processes=processes, resume=resume)
            summary = bake(run)
    print(summary)  # noqa: T201
