"""What the command line says of `bake`: its options, and which of them apply to which quantity."""

import inspect
from collections.abc import Iterator
from dataclasses import replace
from itertools import chain
from pathlib import Path
from typing import Annotated, Any, Literal, get_args

import typer

from warpsample import sequences
from warpsample.cli import rasters, stores, textures
from warpsample.cli.terminal import At, BakedFile, Workers, fail_plainly, option, output_file, working
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
    "refine": (float, "Longest edge of parts of faces that reflect evenly, in units of the mesh"),
    "patches": (str, "Of the sky: tregenza, reinhart2, reinhart4"),
    "up": (tuple[float, float, float], "The sky's axis; +y for .glb, .gltf and USD that says so"),
    "north": (tuple[float, float, float], "Where north is; -z where the file says that up is +y"),
    "sequence": (str, f"One of: {', '.join(sequences.names())}"),
    "tolerance": (float, "Standard error to reach, root mean square over the points"),
    "device": (str, "Where to compute, as cuda:0; by default the CPU"),
}
"""(type, help) of the options that apply to some quantities, by the records of these."""

_ROOMS = (stores.OPTIONS, rasters.OPTIONS, textures.OPTIONS)
"""The types of the options that apply to some files, by their names."""


def bake_command(
    mesh: BakedFile,
    output: Annotated[
        Path,
        output_file(
            ".ply .vtp .glb .npz .csv .png .zarr; of CityJSON .city.json .city.jsonl .csv; of a raster .tif .zarr; "
            "with --texture .glb .gltf .png .exr .npz"
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
    reflectance: Annotated[
        str | None, option("Share of light that faces send back: a number, NAME.npy, or by part, as wall=0.3,roof=0.1.")
    ] = None,
    seed: Annotated[int, typer.Option(help="Seed of points and rays.")] = 0,
    workers: Workers = None,
    **options: Any,
) -> None:
    """Estimate a number at each vertex, face or point of a mesh, with its standard error, into a file.

    Of CityJSON, the means over its surfaces, as attributes of these or into a .csv; of a raster of heights, in each cell.
    """
    given = {name: value for name, value in options.items() if value is not None and value is not False}
    of_stores, of_rasters, of_textures = ({name: given.pop(name) for name in room if name in given} for room in _ROOMS)
    own = {"seed": seed, "workers": workers, **given}
    optics = {"transmittance": of_rasters.get("transmittance"), "reflectance": reflectance}
    run = BakeRun(mesh, output, quantity, at, points, own, by, lod, split, context, report, **optics)
    with working(f"reading {mesh}, casting rays, writing {output}; kernels are compiled when first used, for about 10 s"):
        if rasters.is_raster(mesh, output):
            summary = rasters.bake_raster_file(run, of_rasters, of_stores, of_textures)
        else:
            rasters.refuse_for_meshes(mesh, of_rasters)
            summary = _bake_mesh(run, of_stores, of_textures)
    print(summary)


def _bake_mesh(run: BakeRun, of_stores: dict[str, Any], of_textures: dict[str, Any]) -> str:
    """Computes numbers on a mesh into whichever file is asked for; the report in sentences."""
    from warpsample.output.bake import bake
    from warpsample.output.by_parts import is_by_parts, is_city
    from warpsample.output.texture_bake import bake_texture
    from warpsample.output.upward import with_up

    reflecting = taking("refine")
    if run.reflectance is not None and run.quantity not in reflecting:
        only = " and ".join(reflecting)
        raise ValueError(f"--reflectance: got {run.reflectance} for {run.quantity}; it applies only to {only}")
    options, said = with_up(run.mesh, quantity_of(run.quantity), run.options)
    run = replace(run, options=options)
    how = textures.options_of(run, of_textures)
    into_store = how is None and run.output.suffix == stores.SUFFIX
    if not into_store:
        stores.refuse_for_files(run.output, of_stores)
    if how is None and run.points is None and run.at is None and not is_by_parts(run):
        # Vertices blend what differs at edges, as a roof that sees the sky and the wall below it.
        run = replace(run, at="faces" if run.output.suffix == ".png" or is_city(run) else "vertices")
    summary = bake_texture(run, how) if how else stores.bake_into_store(run, **of_stores) if into_store else bake(run)
    return "\n  ".join(filter(None, (summary, said)))


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
    """The parameters of the command: its own, and in place of **options those of some files and of the quantities."""
    *own, _ = inspect.signature(bake_command).parameters.values()
    titles = {name: quantity.title for name, quantity in quantities().items()}
    others = {name: title for name, title in titles.items() if title.rstrip("s") != name.replace("-", " ").rstrip("s")}
    told = ", ".join(f"{name}: {title}" for name, title in others.items())
    kinds = {"quantity": Annotated[Literal[tuple(titles)], typer.Option(help=f"{told}; others are what they are called.")]}
    yield from (parameter.replace(annotation=kinds.get(parameter.name, parameter.annotation)) for parameter in own)
    for name, kind in chain.from_iterable(room.items() for room in _ROOMS):
        default = False if get_args(kind)[0] is bool else None
        yield inspect.Parameter(name, own[-1].kind, default=default, annotation=kind)
    for name, (kind, _) in OPTIONS.items():
        yield inspect.Parameter(name, own[-1].kind, default=None, annotation=Annotated[kind | None, option(_help_of(name))])


_TAKEN = list(_parameters())
bake_command.__signature__ = inspect.Signature(_TAKEN)  # type: ignore[attr-defined]
bake_command.__annotations__ = {parameter.name: parameter.annotation for parameter in _TAKEN}
bake_command = fail_plainly(**{argument: f"--{name}" for argument, name in NAMES.items()}, size="--texture")(bake_command)
