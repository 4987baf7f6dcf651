"""What the command line says of `bake`: its options, and which of them apply to which quantity."""

import inspect
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Annotated, Any, Literal

import typer

from warpsample import sequences
from warpsample.cli import rasters, stores, textures
from warpsample.cli.terminal import At, MeshFile, Workers, fail_plainly, option, output_file, working
from warpsample.estimate.quantities.record import OPTIONS as NAMES
from warpsample.output.baked import BakeRun
from warpsample.output.quantities import quantities, quantity_of, taking

OPTIONS: dict[str, tuple[Any, str]] = {
    "samples": (int, "Rays of each point"),
    "max_distance": (float, "How far rays go, in units of the mesh"),
    "falloff": (float, "Exponent of the decline up to --max-distance"),
    "environment": (Path, "Light, equirectangular: .hdr or .npy"),
    "weather": (Path, "A year, .epw, or athens, an example"),
    "period": (tuple[str, str], "Of the year, as 06-01 08-31 or 03-21T09 03-21T15"),
    "ground_albedo": (float, "Of the ground beyond the mesh"),
    "patches": (str, "Of the sky: tregenza, reinhart2, reinhart4"),
    "up": (tuple[float, float, float], "The sky's axis; +y for .glb, .gltf and USD that says so"),
    "north": (tuple[float, float, float], "Where north is"),
    "sequence": (str, f"One of: {', '.join(sequences.names())}"),
    "tolerance": (float, "Standard error to reach, root mean square over the points"),
    "device": (str, "Where to compute, as cuda:0; by default the CPU"),
}
"""(type, help) of the options that apply to some quantities, by the records of these."""


def bake_command(
    mesh: MeshFile,
    output: Annotated[
        Path,
        output_file(
            ".ply .vtp .glb .npz .csv .png .zarr; of CityJSON .city.json .city.jsonl .csv; of a raster .tif .zarr; "
            "with --texture .glb .png .exr .npz"
        ),
    ],
    *,
    quantity: str = "ao",
    points: Annotated[int | None, option("So many points, uniform by area; else those of --at.")] = None,
    at: At = None,
    by: Annotated[Literal["part"] | None, option("Means over the named parts of the mesh, a row each; .csv only.")] = None,
    lod: Annotated[str | None, option("Level of detail of CityJSON, as 2.2; by default the highest of each object.")] = None,
    split: Annotated[bool, typer.Option("--split", help="A result for each polygon of CityJSON.")] = False,
    context: Annotated[str | None, option("Around CityJSON: ground, a level plane, or terrain, a mesh or a raster.")] = None,
    report: Annotated[
        Path | None, option("An .html about the run, too: picture, histogram, parts, arguments; offline.")
    ] = None,
    seed: Annotated[int, typer.Option(help="Seed of points and rays.")] = 0,
    workers: Workers = None,
    chunk: stores.Chunk = None,
    cluster: stores.Cluster = None,
    processes: stores.Processes = None,
    resume: stores.Resume = False,
    model: rasters.Model = None,
    receiver: rasters.Receiver = None,
    canopy: rasters.Canopy = None,
    trunk: rasters.Trunk = None,
    transmittance: rasters.Transmittance = None,
    tile: rasters.Tile = None,
    margin: rasters.Margin = None,
    far: rasters.Far = None,
    texture: textures.Size = None,
    uv: textures.Uv = None,
    supersample: textures.Supersample = None,
    normals: textures.Normals = None,
    gutter: textures.Gutter = None,
    strength: textures.Strength = None,
    depth: textures.Depth = None,
    strict: textures.Strict = False,
    **options: Any,
) -> None:
    """Estimate a number at each vertex, face or point of a mesh, with its standard error, into a file.

    Of CityJSON, the means over its surfaces, as attributes of these or into a .csv; of a raster of heights, in each cell.
    """
    from warpsample.output.bake import bake
    from warpsample.output.by_parts import is_by_parts
    from warpsample.output.texture_bake import bake_texture
    from warpsample.output.upward import with_up

    given = {name: value for name, value in options.items() if value is not None}
    working_on = f"reading {mesh}, casting rays, writing {output}; kernels are compiled when first used, for about 10 s"
    alone = {"model": model, "receiver": receiver, "canopy": canopy, "trunk": trunk}
    alone |= {"tile": tile, "margin": margin, "far": far}
    of_textures = {"uv": uv, "supersample": supersample, "normals": normals, "gutter": gutter, "strength": strength}
    of_textures |= {"depth": depth, "strict": strict or None}
    options = {"seed": seed, "workers": workers, **given}
    if rasters.is_raster(mesh, output):
        of_meshes = {"points": points, "at": at, "by": by, "lod": lod, "split": split or None, "context": context}
        of_meshes |= {"report": report, "texture": texture, **of_textures}
        drawn = {**of_meshes, "chunk": chunk, "cluster": cluster, **options}
        with working(working_on):
            summary = rasters.bake_raster_file(
                mesh,
                output,
                quantity,
                trees_and_tiles=alone | {"transmittance": transmittance},
                options=drawn,
                processes=processes,
                resume=resume,
            )
        print(summary)
        return
    rasters.refuse_for_meshes(mesh, **alone)
    options, said = with_up(mesh, quantity_of(quantity), options)
    run = BakeRun(mesh, output, quantity, at, points, options, by, lod, split, context, report, transmittance)
    how = textures.options_of(run, texture, of_textures)
    if how is not None:
        stores.refuse_for_files(output, chunk=chunk, cluster=cluster, processes=processes, resume=resume)
        with working(working_on):
            summary = bake_texture(run, how)
        print("\n  ".join(filter(None, (summary, said))))
        return
    if points is None and at is None and not is_by_parts(run):
        run = replace(run, at="vertices")
    with working(working_on):
        if output.suffix == stores.SUFFIX:
            if report is not None:
                raise ValueError(f"--report: got {report.name!r} for {output.name!r}, want another file than a store")
            if transmittance is not None:
                raise ValueError(f"--transmittance: got {transmittance} for {output.name}, want another file than a store")
            summary = stores.bake_into_store(run, chunk, cluster, processes, resume)
        else:
            stores.refuse_for_files(output, chunk=chunk, cluster=cluster, processes=processes, resume=resume)
            summary = bake(run)
    print("\n  ".join(filter(None, (summary, said))))


def _help_of(name: str) -> str:
    """What an option is, what it is by default, and which quantities take it."""
    defaults: dict[str, list[str]] = {}
    for quantity in (takers := taking(name)):
        value = quantity_of(quantity).default(name)
        if value is not None:
            told = " ".join(f"{part:g}" for part in value) if isinstance(value, tuple) else str(value)
            defaults.setdefault(told, []).append(quantity)
    first, *others = defaults or ("",)
    told = "".join(f", or {value} for {' and '.join(defaults[value])}" for value in others)
    left = [quantity for quantity in quantities() if quantity not in takers]
    only = f"only for {', '.join(takers)}" if len(takers) <= len(left) else f"not for {', '.join(left)}"
    return "; ".join([OPTIONS[name][1], *([f"by default {first}{told}"] if first else []), only]) + "."


def _parameters() -> Iterator[inspect.Parameter]:
    """The parameters of the command: its own, and in place of **options those of the quantities."""
    *own, _ = inspect.signature(bake_command).parameters.values()
    titles = ", ".join(f"{name}: {quantity.title}" for name, quantity in quantities().items())
    kinds = {"quantity": Annotated[Literal[tuple(quantities())], typer.Option(help=f"{titles}.")]}
    yield from (parameter.replace(annotation=kinds.get(parameter.name, parameter.annotation)) for parameter in own)
    for name, (kind, _) in OPTIONS.items():
        yield inspect.Parameter(name, own[-1].kind, default=None, annotation=Annotated[kind | None, option(_help_of(name))])


_TAKEN = list(_parameters())
bake_command.__signature__ = inspect.Signature(_TAKEN)  # type: ignore[attr-defined]
bake_command.__annotations__ = {parameter.name: parameter.annotation for parameter in _TAKEN}
bake_command = fail_plainly(**{argument: f"--{name}" for argument, name in NAMES.items()})(bake_command)
