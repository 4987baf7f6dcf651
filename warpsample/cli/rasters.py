"""What the command line says of rasters: options of `bake` that apply to them alone."""

from pathlib import Path
from typing import Annotated, Any, Literal

from warpsample.cli.terminal import option
from warpsample.estimate.quantities.record import ARGUMENTS
from warpsample.host.arguments import check_choice
from warpsample.output.quantities import check_options, quantity_of

SUFFIXES = (".tif", ".tiff", ".vrt", ".asc")
"""Of rasters of heights."""

Model = Annotated[Literal["joined", "block", "tin"] | None, option("Surface of a raster; by default joined.")]
Receiver = Annotated[
    Literal["horizontal", "surface"] | None,
    option("Normals in a raster's cells; by default surface for the sun, else horizontal."),
]
Canopy = Annotated[Path | None, option("Heights of crowns above the ground, in a raster's cells.")]
Trunk = Annotated[str | None, option("Their undersides: a share of that, by default 0.25, or another raster.")]
Transmittance = Annotated[
    str | None,
    option(
        "Share of light that passes faces: a number, NAME.npy, or by part, as leaf=0.2,glass=0.8; by default none. "
        "Of a raster, a number, what passes crowns; by default 0.03."
    ),
]
Tile = Annotated[int | None, option("Cells along the sides of a raster's tiles; by default one for all.")]
Margin = Annotated[int | None, option("Cells around a tile; by default 256.")]
Far = Annotated[Path | None, option("Another raster, of the terrain beyond the edges.")]

_OF_MESHES = ("points", "at", "by", "lod", "split", "context", "report", "chunk", "cluster", "up", "north")
_OF_THE_SUN = ("irradiation", "sun-hours")


def is_raster(source: Path, output: Path) -> bool:
    """Whether a command is about a raster: by the name of the file that it reads, or writes."""
    return source.suffix.lower() in SUFFIXES or output.suffix.lower() in SUFFIXES[:2]


def bake_raster_file(
    source: Path,
    output: Path,
    quantity: str,
    *,
    trees_and_tiles: dict[str, Any],
    options: dict[str, Any],
    processes: int | None,
    resume: bool,
) -> str:
    """Computes a raster's numbers by `cluster.raster_baking`; what is missing is a ModuleNotFoundError.

    Raises:
        TypeError, ValueError, FileNotFoundError: an argument that cannot be used; before anything is computed.
    """
    try:
        from warpsample.city.rasters.calls import QUANTITIES
        from warpsample.cluster.raster_baking import RasterJob, bake_raster
    except ModuleNotFoundError as error:
        raise ModuleNotFoundError(f"a raster needs {error.name}: pip install 'warpsample[city,cluster]'") from error
    if output.suffix not in (".zarr", *SUFFIXES[:2]):
        raise ValueError(f"--output: got {output.name!r} for a raster, want .tif or .zarr")
    check_choice(quantity, "--quantity", QUANTITIES)
    options = {name: value for name, value in options.items() if value is not None}
    given = options | {name: value for name, value in trees_and_tiles.items() if value is not None}
    for name in _OF_MESHES:
        if name in given:
            raise ValueError(f"--{name}: got {given[name]} for {source.name}; it applies only to meshes")
    check_options(quantity_of(quantity), options)
    told = {ARGUMENTS.get(name, name): _plain(name, value) for name, value in given.items()}
    receiver = told.pop("receiver", "surface" if quantity in _OF_THE_SUN else "horizontal")
    job = RasterJob(str(source), quantity, told.pop("model", "joined"), receiver, tuple(sorted(told.items())))
    return bake_raster(job, output, processes, resume)


def refuse_for_meshes(mesh: Path, **options: object) -> None:
    """Refuses the options of rasters for meshes; the ValueError names the first that is given."""
    for name, value in options.items():
        if value is not None:
            raise ValueError(f"--{name}: got {value} for {mesh.name}; it applies only to rasters")


def _plain(name: str, value: Any) -> Any:
    """Paths as texts, and a trunk or a transmittance as the number that it may be."""
    if name in ("trunk", "transmittance"):
        try:
            return float(value)
        except ValueError:
            return value
    return str(value) if isinstance(value, Path) else value
