"""The command `warpsample bake`, whose options follow from the table in `output.bake_table` and the quantities' records."""

import inspect
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Annotated, Any, Literal

import typer

from warpsample.cli.stores import explain_missing
from warpsample.cli.streams import print_report
from warpsample.cli.terminal import BakedFile, fail_plainly, option, output_file, working
from warpsample.estimate.quantities.record import OPTIONS as NAMES
from warpsample.host.extras import missing
from warpsample.mesh.files.gltf import describe_invisible
from warpsample.output.bake_rules import check_table, is_by_parts
from warpsample.output.bake_table import (
    CITY,
    FILES,
    MESH,
    OPTIONS,
    PANELS,
    RASTER,
    SOURCES,
    STORE,
    TEXTURE,
    Option,
    describe_scope,
)
from warpsample.output.baked import BakeRun
from warpsample.output.quantities import quantities, quantities_with, quantity_of
from warpsample.output.run_record import RunRecord
from warpsample.output.upward import with_up

_KINDS = {MESH: "a mesh", CITY: "CityJSON", RASTER: "a raster", TEXTURE: "a texture (--texture)"}
_FILES_HELP = "; ".join(f"for {_KINDS[source]} {' '.join(files)}" for source, files in FILES.items())


def bake_command(mesh: BakedFile, output: Annotated[Path, output_file(_FILES_HELP)], **options: Any) -> None:
    """Compute sky view, occlusion, sunlight or another quantity on a mesh, with standard errors, and write a file.

    CityJSON gets the mean over each surface, in the file or a .csv. A raster of heights gets a value in each cell.
    """
    run = BakeRun.of(mesh, output, options.pop("quantity"), options)
    with working(f"reading {mesh}, casting rays, writing {output}; kernels are compiled when first used, for about 10 s"):
        check_table(run)
        summary = _bake_raster(run) if run.kind == RASTER else _bake_mesh(run)
    print_report(summary)


def _bake_mesh(run: BakeRun) -> str:
    """Run `warpsample bake` for a mesh or CityJSON file: write a texture, a store or a file, and return a report."""
    options, note = with_up(run.mesh, quantity_of(run.quantity), run.options)
    run = replace(run, options=options)
    if run.kind != TEXTURE and run.points is None and run.at is None and not is_by_parts(run):
        # Vertices blend values that differ at edges, such as those of a roof and of the wall below the roof.
        run = replace(run, at="faces" if run.output.suffix == ".png" or run.kind == CITY else "vertices")
    invisible = describe_invisible(run.mesh)  # before the output is written, which stays even if the mesh's file changes
    report = _bake_store(run) if run.output.suffix == STORE else _bake_file(run)
    return "\n  ".join(filter(None, (report, *invisible, note)))


def _bake_file(run: BakeRun) -> str:
    """Run `warpsample bake` for a mesh or CityJSON file with a file as output, and return a report."""
    from warpsample.output.bake import bake
    from warpsample.output.source import read_source
    from warpsample.output.textures.bake import bake_texture
    from warpsample.output.textures.source import read_texture_source

    record = RunRecord.of(quantity_of(run.quantity))
    with record.show(f"reading {run.mesh.name}"):
        return bake_texture(read_texture_source(run), record) if run.kind == TEXTURE else bake(read_source(run), record)


def _bake_store(run: BakeRun) -> str:
    """Run `warpsample bake` for a mesh with a Zarr store as output, and return a report."""
    try:
        from warpsample.cluster.runs import bake_run
    except ModuleNotFoundError as error:
        raise explain_missing(error) from error
    return bake_run(run)


def _bake_raster(run: BakeRun) -> str:
    """Run `warpsample bake` for a raster of heights: compute each cell, write the output, and return a report.

    Raises:
        ModuleNotFoundError: a package for rasters, or for stores and processes, is not installed.
    """
    processes, resume = run.more.get("processes"), run.more.get("resume", False)
    needs_dask = run.output.suffix == STORE or processes is not None
    try:
        from warpsample.output.rasters.bake import bake_raster
        from warpsample.output.rasters.tile_files import TileFiles

        if needs_dask:
            from warpsample.cluster.raster_baking import ProcessTiles, ZarrTiles
    except ModuleNotFoundError as error:
        extra = "city,cluster" if needs_dask else "city"
        raise missing(f"a raster needs {error.name}", error.name, extra) from error
    if not needs_dask:
        return bake_raster(run, TileFiles(run.output, resume))
    is_store = run.output.suffix == STORE
    return bake_raster(
        run, ZarrTiles(run.output, resume, processes) if is_store else ProcessTiles(run.output, resume, processes)
    )


def _list_parameters() -> Iterator[inspect.Parameter]:
    """Yield the parameters of the command `warpsample bake`, in the order of its help page."""
    *files, _ = inspect.signature(bake_command).parameters.values()
    yield from files
    for name, row in sorted(OPTIONS.items(), key=lambda item: PANELS.index(item[1].panel)):
        default = {"quantity": "ao", "seed": 0}.get(name, False if row.kind is bool else None)
        kind, words = _describe(name, row)
        info = typer.Option(f"--{name}", help=words) if row.kind is bool else option(words)
        info.rich_help_panel = row.panel
        annotation = Annotated[kind if default is not None else kind | None, info]
        yield inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=default, annotation=annotation)


def _describe(name: str, row: Option) -> tuple[Any, str]:
    """Return the type of an option of `warpsample bake`, annotated with its help text."""
    if name == "quantity":
        titles = {each: quantity.title for each, quantity in quantities().items()}
        others = {each: title for each, title in titles.items() if title.rstrip("s") != each.replace("-", " ").rstrip("s")}
        text = ", ".join(f"{each} is {title}" for each, title in others.items())
        return Literal[tuple(titles)], f"Quantity to compute; {text}. Default: ao."
    if row.by_quantity:
        return row.kind, ". ".join([row.words, *_describe_defaults(name), _list_quantities(name)]) + "."
    only = [f"Only for {' and '.join(quantities_with(row.needs))}."] if row.needs else []
    scope = describe_scope(name)
    is_clear = len(row.where) == 1 and row.panel != "Zarr stores" and all(row.where[s] == FILES[s] for s in row.where)
    return row.kind, " ".join([row.words, *only, *([f"Only for {_with_files(row)}."] if scope and not is_clear else [])])


def _with_files(row: Option) -> str:
    """Return a help sentence that lists the inputs and output suffixes to which an option applies."""
    parts = [
        source if row.where[source] == FILES[source] else f"{source} as {' '.join(row.where[source])}"
        for source in SOURCES
        if source in row.where
    ]
    return ", ".join(parts)


def _describe_defaults(name: str) -> Iterator[str]:
    """Yield a sentence that states the default of an option for each quantity, or nothing without a default."""
    defaults: dict[str, list[str]] = {}
    for quantity in quantities_with(name):
        value = quantity_of(quantity).default(name)
        if value is not None:
            text = " ".join(f"{part:g}" for part in value) if isinstance(value, tuple) else str(value)
            defaults.setdefault(text, []).append(quantity)
    if defaults:
        first, *others = defaults
        yield f"Default: {first}" + "".join(f", or {value} for {' and '.join(defaults[value])}" for value in others)


def _list_quantities(name: str) -> str:
    """Return a help sentence that lists the quantities to which an option applies, or does not apply if fewer."""
    applicable = quantities_with(name)
    rest = [quantity for quantity in quantities() if quantity not in applicable]
    return f"Only for {', '.join(applicable)}" if len(applicable) <= len(rest) else f"Not for {', '.join(rest)}"


_PARAMETERS = list(_list_parameters())
bake_command.__signature__ = inspect.Signature(_PARAMETERS)  # type: ignore[attr-defined]
bake_command.__annotations__ = {parameter.name: parameter.annotation for parameter in _PARAMETERS}
bake_command = fail_plainly(**{argument: f"--{name}" for argument, name in NAMES.items()}, size="--texture")(bake_command)
