"""Public functions that sample directions at points, and points of the unit square."""

from collections import Counter
from dataclasses import dataclass
from enum import IntEnum
from typing import TYPE_CHECKING, Any

import numpy as np
import warp as wp

from warpsample import sequences
from warpsample.directions import samples
from warpsample.directions.plan import DirectionPlan, split_at_high_word
from warpsample.directions.square import square_blocks
from warpsample.distributions import as_spatial
from warpsample.distributions.cosine_hemisphere import CosineHemisphere
from warpsample.distributions.elementwise import FLAT_BLOCK
from warpsample.distributions.record import Distribution
from warpsample.host.arguments import check_flag, check_integer, check_scale, quote
from warpsample.host.arrays import Array, Floats, cpu
from warpsample.host.engine import check_memory, run
from warpsample.host.options import CallOptions
from warpsample.host.progress import bar
from warpsample.host.summary import Summary
from warpsample.host.vectors import as_vectors, check_out, new_vectors
from warpsample.mesh.polydata import cloud
from warpsample.mesh.surface import SurfacePoints

if TYPE_CHECKING:
    from pyvista import PolyData

_STREAM_HINT = "compute them in parts: pass slices of the normals with first_point=, or use `warpsample directions`"


class Status(IntEnum):
    """Status of a point: OK, or the reason for which the point has no directions.

    INVALID_PARAMETER is the status of a point whose row of a parameter is out of range or NaN: the row is NaN in
    `distribution.by_point`, a dictionary by the name of the parameter. A point with the status INVALID_TANGENT has
    directions, in the frame that it would have without a tangent.
    """

    OK = samples.OK
    INACTIVE = samples.INACTIVE
    ZERO_NORMAL = samples.ZERO_NORMAL
    NONFINITE_NORMAL = samples.NONFINITE_NORMAL
    INVALID_PARAMETER = samples.INVALID_PARAMETER
    INVALID_TANGENT = samples.INVALID_TANGENT


@dataclass(frozen=True, eq=False, repr=False)
class Directions(Summary):
    """Directions at P points, n at each point, in NumPy arrays or wp.arrays, like the normals.

    Attributes:
        vectors: (P, n, 3) float32 (as a wp.array: (P, n) of vec3), unit length, world frame, pointing away from the
            surface; zero vectors where the status is neither OK nor INVALID_TANGENT.
        pdf: (P, n) float32, density in the distribution's measure, 0 where the vectors are zero; None without `pdf=True`.
        status: (P,) uint8, values of `Status`.
    """

    vectors: Floats
    pdf: Floats | None
    status: Array

    def counts(self) -> dict[Status, int]:
        """Return the number of points with each status, for example "OK" or "ZERO_NORMAL".

        Returns:
            {status: number of points}, without a status that no point has.

        Example:
            >>> found = ws.sample_directions(np.array([[0.0, 0.0, 1.0], [0.0, 0.0, 0.0]]), 16)
            >>> print({status.name: number for status, number in found.counts().items()})
            {'OK': 1, 'ZERO_NORMAL': 1}
        """
        status = self.status.numpy() if isinstance(self.status, wp.array) else self.status
        return {Status(code): int(n) for code, n in sorted(Counter(status.tolist()).items())}

    def to_polydata(self, points: SurfacePoints | None = None, scale: float = 1.0) -> "PolyData":
        """Convert the directions to a PyVista point cloud, with a point at position + scale * direction for each direction.

        Args:
            points: the points of the directions, in the same order; by default all directions start at the origin.
            scale: length of a direction, in the unit of the positions; at most 1e30.

        Returns:
            PolyData with the arrays "Normals" (the directions, which .ply files also store), "point" (the row) and, if
            present, "pdf". Points without directions are left out.

        Raises:
            ModuleNotFoundError: PyVista is not installed.
            TypeError: points are not SurfacePoints, or the scale is not a number.
            ValueError: the number of points differs from the number of rows, or the scale is out of range.

        Example:
            >>> mesh = ws.load_mesh("courtyard")
            >>> points = ws.sample_surface(mesh, 100)
            >>> cloud = ws.sample_directions(points, 16).to_polydata(points, scale=0.5)
            >>> print(cloud.n_points)
            1600
        """
        scale = check_scale(scale)
        vectors, pdf, status = (a.numpy() if isinstance(a, wp.array) else a for a in (self.vectors, self.pdf, self.status))
        rows = np.flatnonzero((status == Status.OK) | (status == Status.INVALID_TANGENT))
        if not isinstance(points, SurfacePoints | None):
            raise TypeError(f"points: got {quote(points)}, want SurfacePoints, such as sample_surface returns")
        if points is not None and len(points) != len(status):
            raise ValueError(f"points: got {len(points)} points, want {len(status)}, one for each row of the directions")
        start = np.zeros((1, 1, 3)) if points is None else points.position[rows, None].astype(np.float64)
        directions = vectors[rows]
        return cloud(
            (start + scale * directions).reshape(-1, 3),
            directions.reshape(-1, 3),
            point=np.repeat(rows, directions.shape[1]),
            pdf=None if pdf is None else pdf[rows].ravel(),
        )


def sample_directions(
    normals: Any,
    count: int,
    *,
    distribution: Distribution | str = CosineHemisphere(),
    sequence: str = "sobol",
    seed: int = 0,
    first_point: int = 0,
    pdf: bool = False,
    active: Any = None,
    out: Any = None,
    device: Any = None,
    workers: int | None = None,
    progress: bool = False,
) -> Directions:
    """Sample `count` directions about each normal from a distribution such as the cosine lobe.

    Each direction is a pure function of (seed, first_point + row, sample, count): threads, parts and the mask `active`
    do not change a bit. Compiling the first kernel takes about 1.5 s; compiled kernels are cached on disk.

    Args:
        normals: (P, 3) float32 or float64, of any length above 0, or SurfacePoints. NumPy gives NumPy, a wp.array gives a
            wp.array on its device. Arrays of other libraries (PyTorch, JAX, CuPy) are not copied: they count as NumPy arrays
            in the CPU's memory, and as wp.arrays on CUDA. A zero or non-finite normal gives zero vectors and a status.
        count: Number of directions per point, n, 1 to 2^31 - 1.
        distribution: Distribution of the directions, or its name. Its parameters may be arrays with one row for each point;
            a row out of range gives zero vectors and a status. Default: CosineHemisphere(method="polar").
        sequence: Sequence of the points of the square, a name in `warpsample.sequences.names()`. Default: "sobol".
        seed: Random seed, an integer of 64 bits. Default: 0.
        first_point: Global id of row 0, an integer; 0 for points with an `id`. Default: 0.
        pdf: Whether to return the density of each direction. Default: False.
        active: (P,) bool. Inactive rows give zero vectors and cost next to nothing. Default: None, all rows are active.
        out: (P, n, 3) float32 array to write into, of the same kind as the normals, or of another library, whose memory
            `vectors` then is. Default: None, a new array.
        device: Warp device, such as "cuda:0", which takes NumPy arrays in parts. Default: None, that of the normals.
        workers: Number of CPU threads, an integer. Default: None, the value of WARPSAMPLE_WORKERS or all cores.
        progress: Whether to show a progress bar on a terminal or in a notebook. Default: False.

    Returns:
        vectors (P, n, 3) of unit length in world coordinates, pdf (P, n) if `pdf` is True, and a status per point. Tangents
        of SurfacePoints set the x axes of the frames.

    Raises:
        TypeError, ValueError: an argument is invalid; the message names the argument and the expected values.
        MemoryError: the results need more memory than is free; the message states the size and how to compute in parts.

    Example:
        >>> points = ws.sample_surface(ws.load_mesh("courtyard"), 100)
        >>> d = ws.sample_directions(points, 16, distribution=ws.Beckmann(alpha=0.1), pdf=True)
        >>> print(d.vectors.shape, d.pdf.shape, (d.pdf > 0.0).all())
        (100, 16, 3) (100, 16) True
    """
    normals_in = as_vectors(normals.normal if isinstance(normals, SurfacePoints) else normals, 3, "normals", "(P, {})")
    if len(normals_in.shape) != 1 or normals_in.shape == (0,):
        raise ValueError(f"normals: got shape {(*normals_in.shape, 3)}, want (P, 3) with P of at least 1")
    points, count = normals_in.shape[0], check_integer(count, "count", 1, 2**31 - 1)
    ids = normals.id if isinstance(normals, SurfacePoints) else None
    random = {"seed": seed, "first_point": first_point, "ids": ids, "active": active}
    computing = {
        "device": device,
        "workers": workers,
        "progress": progress,
        "given": normals_in.owner,
        "argument": "normals",
    }
    options = CallOptions.of(points, **random, **computing)
    tangents = normals.tangent if isinstance(normals, SurfacePoints) else None
    sampling = DirectionPlan(
        as_spatial(distribution),
        sequences.get(sequence),
        count,
        check_flag(pdf, "pdf"),
        options,
        tangents,
    )
    sampling.distribution.check_points(points)
    shape, total = (points, count), points * count
    vectors = None if out is None else check_out(out, normals_in, shape)
    size = total * ((12 if out is None else 0) + (4 if sampling.pdf else 0)) + points
    if normals_in.device.is_cpu:
        check_memory(size, f"{total:,} directions", _STREAM_HINT)
    vectors = vectors or new_vectors(normals_in, shape, 3)
    densities = new_vectors(normals_in, shape, 1) if sampling.pdf else None
    with bar(options.progress, "sampling directions"):
        status = sampling.fill(normals_in, vectors, densities)
    return Directions(vectors.owner, densities and densities.owner, status)


def sample_square(sequence: str, points: int, count: int, *, seed: int = 0, first_point: int = 0) -> np.ndarray:
    """Return the points of the square that `sample_directions` maps to directions.

    Args:
        sequence: Name in `warpsample.sequences.names()`.
        points: Number of surface points, P.
        count: Number of points of the square for each surface point, n, 1 to 2^31 - 1.
        seed: Random seed, an integer of 64 bits. Default: 0.
        first_point: Global id of row 0, an integer; 0 for points with an `id`. Default: 0.

    Returns:
        (P, n, 2) float32, multiples of 2^-24 in [0, 1).

    Raises:
        TypeError, ValueError: an argument is invalid; the message names the argument.
        MemoryError: the results need more memory than is free.

    Example:
        >>> u = ws.sample_square("sobol", points=2, count=256)
        >>> print(u.shape, u.mean(axis=1).round(2).tolist())
        (2, 256, 2) [[0.5, 0.5], [0.5, 0.5]]
    """
    record = sequences.get(sequence)
    points = check_integer(points, "points", 1, 2**63 - 1)
    count = check_integer(count, "count", 1, 2**31 - 1)
    options = CallOptions.of(points, seed=seed, first_point=first_point)
    total = points * count
    check_memory(8 * total, f"{total:,} points of the square", "compute them in parts with first_point=")
    square = np.empty((points, count, 2), np.float32)
    for start, end in split_at_high_word(options.first_point, points):
        pairs = (end - start) * count
        inputs = [pairs, FLAT_BLOCK, count, options.seed, options.first_point + start, square[start:].ctypes.data]
        run(square_blocks(record), -(-pairs // FLAT_BLOCK), inputs, cpu(), workers=options.workers, work=pairs)
    return square
