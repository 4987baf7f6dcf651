"""Rasters that tests of cities share, with the sums that any surface of one must have."""

import numpy as np
import rasterio
from affine import Affine

import warpsample as ws
from warpsample.city.rasters.tiles import RasterRun
from warpsample.estimate.quantities.sky_view_factor import RECORD as SKY

NORTH_UP = Affine(1.0, 0.0, 0.0, 0.0, -1.0, 0.0)
SLOVENIA = Affine(1.0, 0.0, 564000.0, 0.0, -1.0, 146000.0)
_OPTIONS = {"model": "joined", "receiver": "horizontal", "canopy": None, "trunk": 0.25, "relative": True}
_OPTIONS |= {"transmittance": 0.03, "tile": None, "margin": None, "far": None}
ON_A_MAP = Affine(2.5, 0.0, 500000.0, 0.0, -2.5, 5000000.0)


def rough(rows=14, columns=11, seed=5, rim=9.0):
    """Heights from -10 to 8 with cliffs, slopes and flats, within a flat rim that is higher than all."""
    rng = np.random.default_rng(seed)
    heights = np.round(rng.choice([-6.0, 0.0, 4.0], (rows, columns)) + rng.uniform(-4.0, 4.0, (rows, columns)), 3)
    heights[2:5, 2:5] = 1.5
    heights[[0, -1]] = rim
    heights[:, [0, -1]] = rim
    return heights


def heights():
    """Heights of 60 x 44 cells: boxes on level ground, and a cell without data."""
    rng = np.random.default_rng(2)
    made = np.zeros((60, 44), np.float32)
    for _ in range(60):
        i, j = rng.integers(0, 54), rng.integers(0, 38)
        made[i : i + 5, j : j + 4] = rng.uniform(4.0, 25.0)
    made[7, 9] = np.nan
    return made


def flux(mesh):
    """(3, 3): the sum over the faces of each coordinate of their middle times each of their area vector.

    For a surface that closes a body with a plane below or above it, all three entries of the diagonal are its volume.
    """
    middle = mesh.vertices[mesh.faces].mean(axis=1)
    return middle.T @ (0.5 * mesh.cross_products)


def corners_of(mesh):
    """(F, 9) the triangles of a mesh, their turns kept, in an order of their own: equal for equal surfaces."""
    corners = np.round(mesh.vertices[mesh.faces], 6) + 0.0
    first = np.lexsort(corners.transpose(2, 0, 1)[::-1], axis=1)[:, 0]
    turned = np.stack([corners[np.arange(len(corners)), (first + k) % 3] for k in range(3)], axis=1).reshape(-1, 9)
    return turned[np.lexsort(turned.T[::-1])]


def write_tif(path, bands, *, transform=ON_A_MAP, crs="EPSG:3794", mask=None, units=None, scale=None, **profile):
    """A GeoTIFF of the bands given, (rows, columns) each."""
    bands = np.atleast_3d(np.asarray(bands).T).T
    size = {"count": len(bands), "height": bands.shape[1], "width": bands.shape[2]}
    with rasterio.open(path, "w", "GTiff", **size, dtype=bands.dtype, crs=crs, transform=transform, **profile) as file:
        file.write(bands)
        if mask is not None:
            file.write_mask(mask)
        if units is not None:
            file.units = (units,)
        if scale is not None:
            file.scales, file.offsets = (scale[0],), (scale[1],)
    return path


def sky(surface, cells, count, **options):
    """The sky view factor in the middle of some cells, in their order."""
    points, known = surface.points(options.pop("receiver", "horizontal"))
    return ws.sky_view_factor(surface.mesh, points.take(np.searchsorted(known, cells)), count, **options)


def town(rows=60, columns=44, seed=2):
    """Blocks of houses on a slope, and a hole."""
    rng = np.random.default_rng(seed)
    heights = 0.2 * np.arange(columns) + np.zeros((rows, columns))
    for _ in range(60):
        i, j = rng.integers(0, rows - 6), rng.integers(0, columns - 6)
        heights[i : i + 5, j : j + 4] = rng.uniform(4.0, 25.0)
    return heights


def run(source, quantity=SKY, count=64, **options):
    """A run of tiles of a raster, or of an array of heights."""
    if isinstance(source, np.ndarray):
        source = source, NORTH_UP, None
    return RasterRun.of(source, quantity, {"count": count}, **_OPTIONS | options)


def whole(made):
    """What all tiles of a run have, laid out."""
    laid = {name: np.full(made.reader.shape, np.nan, np.float32) for name in made.names}
    for span in made.spans():
        for name, values in made.numbers(span).items():
            laid[name][span] = values
    return laid
