"""The command `warpsample bake`: its options, and the quantities and files to which each option applies."""

import inspect
from collections.abc import Iterator
from copy import copy
from dataclasses import replace
from itertools import chain
from pathlib import Path
from typing import Annotated, Any, Literal, get_args

import typer

from warpsample import sequences
from warpsample.cli import rasters, stores, textures
from warpsample.cli.terminal import BakedFile, Workers, fail_plainly, option, output_file, working
from warpsample.estimate.quantities.record import OPTIONS as NAMES
from warpsample.output.baked import BakeRun
from warpsample.output.quantities import quantities, quantity_of, taking

OPTIONS: dict[str, tuple[Any, str]] = {
    "samples": (int, "Number of rays per point"),
    "max_distance": (float, "Length of the rays, in units of the mesh"),
    "falloff": (float, "Exponent of the decrease of occlusion with distance, up to --max-distance"),
    "environment": (Path, "Equirectangular image of the light: .hdr or .npy"),
    "weather": (Path, "Weather file of a year, .epw, or athens for the built-in example"),
    "period": (
        tuple[str, str],
        "First and last day of the period, such as 06-01 08-31, or with hours, 03-21T09 03-21T15. Default: the whole year",
    ),
    "ground_albedo": (float, "Fraction of light that the ground around the mesh reflects, 0 to 1"),
    "refine": (float, "Longest edge of the parts into which faces are divided for reflected light, in units of the mesh"),
    "patches": (str, "Division of the sky into patches: tregenza, reinhart2 or reinhart4"),
    "up": (
        tuple[float, float, float],
        "Direction from the ground to the zenith; 0 1 0 for .glb, .gltf and USD files with +y up",
    ),
    "north": (tuple[float, float, float], "Direction of north; 0 0 -1 for files with +y up"),
    "sequence": (str, f"Sampling sequence: {', '.join(sequences.names())}"),
    "tolerance": (float, "Standard error at which to stop, as the root mean square over the points, such as 0.01"),
    "device": (str, "Device that computes, such as cuda:0. Default: the CPU"),
}
"""(type, help) of each option that applies only to some quantities; the records of the quantities state which."""

_ROOMS = (stores.OPTIONS, rasters.OPTIONS, textures.OPTIONS)
"""Annotations of the options that apply only to some kinds of files, keyed by option name."""


_PANELS = {
    "What to compute": "quantity samples tolerance max_distance falloff sequence seed",
    "Where": "points at by",
    "Light": "weather period environment patches up north ground_albedo reflectance refine transmittance",
    "CityJSON": "lod split context",
    "Rasters of heights": " ".join(name for name in rasters.OPTIONS if name != "transmittance"),
    "Textures": " ".join(textures.OPTIONS),
    "Zarr stores": " ".join(stores.OPTIONS),
    "Run": "workers device report",
}
"""Names of the options in each panel of the help page."""

_AT_HELP = (
    "Compute at the vertices or at the centres of the faces. Default without --points: vertices; faces for a .png and for "
    "CityJSON written as a mesh; random points for means over parts and surfaces."
)
_REFLECTANCE_HELP = (
    "Fraction of light that faces reflect, 0 to 1: a number, NAME.npy with one number per face, or numbers by part, such as "
    "wall=0.3,roof=0.1. Default: 0. Only for irradiance, irradiation."
)


def bake_command(
    mesh: BakedFile,
    output: Annotated[
        Path,
        output_file(
            ".ply .vtp .glb .npz .csv .png .zarr; for CityJSON .city.json .city.jsonl .csv; for a raster .tif .zarr; "
            "with --texture .glb .gltf .png .exr .npz"
        ),
    ],
    *,
    quantity: str = "ao",
    points: Annotated[
        int | None, option("Number of points, placed uniformly by area. Default: the locations of --at.")
    ] = None,
    at: Annotated[Literal["vertices", "faces"] | None, option(_AT_HELP)] = None,
    by: Annotated[
        Literal["part"] | None, option("Write the mean over each named part of the mesh, one row per part. Only for .csv.")
    ] = None,
    lod: Annotated[str | None, option("Level of detail to read, such as 2.2. Default: the highest of each object.")] = None,
    split: Annotated[bool, typer.Option("--split", help="Write one result per polygon, not per surface.")] = False,
    context: Annotated[
        str | None, option("Terrain around the model: ground for a level plane, or the path of a mesh or raster.")
    ] = None,
    report: Annotated[
        Path | None, option("Also write an .html report with picture, histogram, means by part and arguments.")
    ] = None,
    reflectance: Annotated[str | None, option(_REFLECTANCE_HELP)] = None,
    seed: Annotated[int, typer.Option(help="Seed of the random points and rays.")] = 0,
    workers: Workers = None,
    **options: Any,
) -> None:
    """Compute sky view, occlusion, sunlight or another quantity on a mesh, with standard errors, and write a file.

    CityJSON gets the mean over each surface, in the file or a .csv. A raster of heights gets a value in each cell.
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
    """Compute a quantity on a mesh, write the texture, store or file, and return the report as text."""
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
        # Vertices blend values that differ at edges, such as those of a roof and of the wall below the roof.
        run = replace(run, at="faces" if run.output.suffix == ".png" or is_city(run) else "vertices")
    summary = bake_texture(run, how) if how else stores.bake_into_store(run, **of_stores) if into_store else bake(run)
    return "\n  ".join(filter(None, (summary, said)))


def _format_help(name: str) -> str:
    """Return the help text of an option: description, default, and the quantities to which the option applies."""
    defaults: dict[str, list[str]] = {}
    for quantity in (applicable := taking(name)):
        value = quantity_of(quantity).default(name)
        if value is not None:
            text = " ".join(f"{part:g}" for part in value) if isinstance(value, tuple) else str(value)
            defaults.setdefault(text, []).append(quantity)
    first, *others = defaults or ("",)
    exceptions = "".join(f", or {value} for {' and '.join(defaults[value])}" for value in others)
    rest = [quantity for quantity in quantities() if quantity not in applicable]
    only = f"Only for {', '.join(applicable)}" if len(applicable) <= len(rest) else f"Not for {', '.join(rest)}"
    return ". ".join([OPTIONS[name][1], *([f"Default: {first}{exceptions}"] if first else []), only]) + "."


def _list_parameters() -> Iterator[inspect.Parameter]:
    """Yield the parameters of the command, with the options of files and of quantities in place of `**options`."""
    *fixed, _ = inspect.signature(bake_command).parameters.values()
    titles = {name: quantity.title for name, quantity in quantities().items()}
    others = {name: title for name, title in titles.items() if title.rstrip("s") != name.replace("-", " ").rstrip("s")}
    text = ", ".join(f"{name} is {title}" for name, title in others.items())
    kinds = {"quantity": Annotated[Literal[tuple(titles)], typer.Option(help=f"Quantity to compute; {text}.")]}
    yield from (parameter.replace(annotation=kinds.get(parameter.name, parameter.annotation)) for parameter in fixed)
    for name, kind in chain.from_iterable(room.items() for room in _ROOMS):
        default = False if get_args(kind)[0] is bool else None
        yield inspect.Parameter(name, fixed[-1].kind, default=default, annotation=kind)
    for name, (kind, _) in OPTIONS.items():
        annotation = Annotated[kind | None, option(_format_help(name))]
        yield inspect.Parameter(name, fixed[-1].kind, default=None, annotation=annotation)


def _group(parameters: list[inspect.Parameter]) -> list[inspect.Parameter]:
    """Return the parameters sorted by panel of the help page, with the panel set in each option."""
    panels = {name: panel for panel, names in _PANELS.items() for name in names.split()}
    order = ["", *_PANELS]
    grouped = sorted(parameters, key=lambda each: order.index(panels.get(each.name, "")))
    return [_set_panel(each, panels[each.name]) if each.name in panels else each for each in grouped]


def _set_panel(parameter: inspect.Parameter, panel: str) -> inspect.Parameter:
    """Return a copy of a parameter whose option appears in a panel of the help page."""
    kind, shared = get_args(parameter.annotation)
    info = copy(shared)  # other commands use the same object
    info.rich_help_panel = panel
    return parameter.replace(annotation=Annotated[kind, info])


_PARAMETERS = _group(list(_list_parameters()))
bake_command.__signature__ = inspect.Signature(_PARAMETERS)  # type: ignore[attr-defined]
bake_command.__annotations__ = {parameter.name: parameter.annotation for parameter in _PARAMETERS}
bake_command = fail_plainly(**{argument: f"--{name}" for argument, name in NAMES.items()}, size="--texture")(bake_command)
