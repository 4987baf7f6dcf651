"""Options of `warpsample bake` for rasters of heights, and the function that computes a raster."""

from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Any, Literal

from warpsample.cli.terminal import option
from warpsample.estimate.quantities.record import ARGUMENTS
from warpsample.host.arguments import check_choice
from warpsample.host.extras import missing
from warpsample.output.baked import BakeRun
from warpsample.output.quantities import check_options, quantity_of

SUFFIXES = (".tif", ".tiff", ".vrt", ".asc")
"""Suffixes of rasters of heights."""

OPTIONS: dict[str, Any] = {
    "model": Annotated[
        Literal["joined", "block", "tin"] | None,
        option(
            "Surface through the heights: joined (walls at steps), block (flat cells) or tin (triangles). Default: joined."
        ),
    ],
    "receiver": Annotated[
        Literal["horizontal", "surface"] | None,
        option("Orientation of the cells. Default: surface for irradiation and sun-hours, else horizontal."),
    ],
    "canopy": Annotated[Path | None, option("Raster with the heights of tree crowns above the ground, on the same cells.")],
    "trunk": Annotated[
        str | None, option("Height of the undersides of crowns: a fraction of --canopy, or a raster. Default: 0.25.")
    ],
    "transmittance": Annotated[
        str | None,
        option(
            "Fraction of light that faces transmit, 0 to 1: a number, NAME.npy with one number per face, or numbers "
            "by part, such as leaf=0.2,glass=0.8. Default: 0. For a raster, the fraction that tree crowns transmit. "
            "Default: 0.03."
        ),
    ],
    "tile": Annotated[
        int | None, option("Number of cells along each side of a tile. Default: one tile for the whole raster.")
    ],
    "margin": Annotated[int | None, option("Number of cells at full resolution around a tile. Default: 256.")],
    "far": Annotated[Path | None, option("Raster of the terrain outside the first raster.")],
}
"""Annotations of the options for rasters, keyed by name; `transmittance` also applies to meshes."""

_OF_MESHES = ("points", "at", "by", "lod", "split", "context", "report", "reflectance", "up", "north")
_OF_THE_SUN = ("irradiation", "sun-hours")


def is_raster(source: Path, output: Path) -> bool:
    """Return whether the input or the output of a command is a raster, judged by the suffixes of both files."""
    return source.suffix.lower() in SUFFIXES or output.suffix.lower() in SUFFIXES[:2]


def bake_raster_file(
    run: BakeRun, of_rasters: Mapping[str, Any], of_stores: Mapping[str, Any], of_textures: Mapping[str, Any]
) -> str:
    """Compute a quantity in each cell of a raster, write the output, and return the report as text.

    Args:
        run: Arguments of the command; `run.mesh` is the path of the raster.
        of_rasters: Given options of this module.
        of_stores: Given options for stores. Only `processes` and `resume` apply to rasters.
        of_textures: Given options for textures. None apply to rasters.

    Raises:
        ModuleNotFoundError: A package for rasters is not installed.
        TypeError, ValueError, FileNotFoundError: An argument is invalid; raised before any work.
    """
    try:
        from warpsample.city.rasters.calls import QUANTITIES
        from warpsample.cluster.raster_baking import RasterJob, bake_raster
    except ModuleNotFoundError as error:
        raise missing(f"a raster needs {error.name}", error.name, "city,cluster") from error
    if run.output.suffix not in (".zarr", *SUFFIXES[:2]):
        raise ValueError(f"--output: got {run.output.name!r} for a raster, want .tif or .zarr")
    check_choice(run.quantity, "--quantity", QUANTITIES)
    options = {name: value for name, value in run.options.items() if value is not None}
    refused = {name: getattr(run, name, options.get(name)) for name in _OF_MESHES}
    refused = {name: value for name, value in refused.items() if value is not None and value is not False}
    refused |= {name: of_stores[name] for name in ("chunk", "cluster") if name in of_stores}
    for name, value in (refused | dict(of_textures)).items():
        raise ValueError(f"--{name}: got {value} for {run.mesh.name}; it applies only to meshes")
    check_options(quantity_of(run.quantity), options)
    arguments = {ARGUMENTS.get(name, name): _to_plain(name, value) for name, value in (options | dict(of_rasters)).items()}
    receiver = arguments.pop("receiver", "surface" if run.quantity in _OF_THE_SUN else "horizontal")
    job = RasterJob(
        str(run.mesh), run.quantity, arguments.pop("model", "joined"), receiver, tuple(sorted(arguments.items()))
    )
    return bake_raster(job, run.output, of_stores.get("processes"), of_stores.get("resume", False))


def refuse_for_meshes(mesh: Path, options: Mapping[str, Any]) -> None:
    """Raise a ValueError if a mesh is given an option that applies only to rasters."""
    for name, value in options.items():
        if name != "transmittance":
            raise ValueError(f"--{name}: got {value} for {mesh.name}; it applies only to rasters")


def _to_plain(name: str, value: Any) -> Any:
    """Return a path as a string, a numeric trunk or transmittance as a float, and other values unchanged."""
    if name in ("trunk", "transmittance"):
        try:
            return float(value)
        except ValueError:
            return value
    return str(value) if isinstance(value, Path) else value
