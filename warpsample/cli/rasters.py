"""What the command line says of rasters: options of `bake` that apply to them alone."""

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
"""Of rasters of heights."""

OPTIONS: dict[str, Any] = {
    "model": Annotated[Literal["joined", "block", "tin"] | None, option("Surface of a raster; by default joined.")],
    "receiver": Annotated[
        Literal["horizontal", "surface"] | None,
        option("Normals in a raster's cells; by default surface for the sun, else horizontal."),
    ],
    "canopy": Annotated[Path | None, option("Heights of crowns above the ground, in a raster's cells.")],
    "trunk": Annotated[str | None, option("Their undersides: a share of that, by default 0.25, or another raster.")],
    "transmittance": Annotated[
        str | None,
        option(
            "Share of light that passes faces: a number, NAME.npy, or by part, as leaf=0.2,glass=0.8; by default none. "
            "Of a raster, a number, what passes crowns; by default 0.03."
        ),
    ],
    "tile": Annotated[int | None, option("Cells along the sides of a raster's tiles; by default one for all.")],
    "margin": Annotated[int | None, option("Cells around a tile; by default 256.")],
    "far": Annotated[Path | None, option("Another raster, of the terrain beyond the edges.")],
}
"""The types of the options that apply to rasters, of which transmittance applies to meshes, too."""

_OF_MESHES = ("points", "at", "by", "lod", "split", "context", "report", "reflectance", "up", "north")
_OF_THE_SUN = ("irradiation", "sun-hours")


def is_raster(source: Path, output: Path) -> bool:
    """Whether a command is about a raster: by the name of the file that it reads, or writes."""
    return source.suffix.lower() in SUFFIXES or output.suffix.lower() in SUFFIXES[:2]


def bake_raster_file(
    run: BakeRun, of_rasters: Mapping[str, Any], of_stores: Mapping[str, Any], of_textures: Mapping[str, Any]
) -> str:
    """Computes a raster's numbers by `cluster.raster_baking`; what is missing is a ModuleNotFoundError.

    Args:
        run: of which `mesh` is the raster.
        of_rasters: the options that are given of this file.
        of_stores: those of stores, of which rasters take some.
        of_textures: those of textures, of which they take none.

    Raises:
        TypeError, ValueError, FileNotFoundError: an argument that cannot be used; before anything is computed.
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
    told = {ARGUMENTS.get(name, name): _plain(name, value) for name, value in (options | dict(of_rasters)).items()}
    receiver = told.pop("receiver", "surface" if run.quantity in _OF_THE_SUN else "horizontal")
    job = RasterJob(str(run.mesh), run.quantity, told.pop("model", "joined"), receiver, tuple(sorted(told.items())))
    return bake_raster(job, run.output, of_stores.get("processes"), of_stores.get("resume", False))


def refuse_for_meshes(mesh: Path, options: Mapping[str, Any]) -> None:
    """Refuses the options of rasters that are given for meshes; the ValueError names the first."""
    for name, value in options.items():
        if name != "transmittance":
            raise ValueError(f"--{name}: got {value} for {mesh.name}; it applies only to rasters")


def _plain(name: str, value: Any) -> Any:
    """Paths as texts, and a trunk or a transmittance as the number that it may be."""
    if name in ("trunk", "transmittance"):
        try:
            return float(value)
        except ValueError:
            return value
    return str(value) if isinstance(value, Path) else value
