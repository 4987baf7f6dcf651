"""Directions at points, and the points of the square that they come from."""

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
from warpsample.host.arguments import check_flag, check_integer, check_scale, told
from warpsample.host.arrays import Array, Floats, cpu
from warpsample.host.engine import check_memory, run
from warpsample.host.options import CallOptions, explained_by
from warpsample.host.progress import bar
from warpsample.host.vectors import as_vectors, check_out, new_vectors
from warpsample.mesh.polydata import cloud
from warpsample.mesh.surface import SurfacePoints

if TYPE_CHECKING:
    from pyvista import PolyData

_STREAM_HINT = "stream them: slices of the normals with first_point=, or `warpsample directions`"


class Status(IntEnum):
    """Why a point has directions or not."""

    OK = samples.OK
    INACTIVE = samples.INACTIVE
    ZERO_NORMAL = samples.ZERO_NORMAL
    NONFINITE_NORMAL = samples.NONFINITE_NORMAL


@dataclass(frozen=True, eq=False)
class Directions:
    """Directions at P points, n each; NumPy or Warp arrays, as the normals were.

    Attributes:
        vectors: (P, n, 3) float32 (as a wp.array: (P, n) of vec3), unit length, world frame, pointing away from the
            surface; zero vectors where the status is not 0.
        pdf: (P, n) float32, in the distribution's measure, 0 where the status is not 0; None unless asked for.
        status: (P,) uint8, a `Status`.
    """

    vectors: Floats
    pdf: Floats | None
    status: Array

    def counts(self) -> dict[Status, int]:
        """How many points have each status; those that occur.

        Returns:
            {status: number of points, at least 1}.

        Example:
            >>> found = ws.sample_directions(np.array([[0.0, 0.0, 1.0], [0.0, 0.0, 0.0]]), 16)
            >>> print({status.name: number for status, number in found.counts().items()})
            {'OK': 1, 'ZERO_NORMAL': 1}
        """
        status = self.status.numpy() if isinstance(self.status, wp.array) else self.status
        return {Status(code): int(n) for code, n in sorted(Counter(status.tolist()).items())}

    def to_polydata(self, points: SurfacePoints | None = None, scale: float = 1.0) -> "PolyData":
        """The cloud as PyVista's PolyData: a point at position + scale * direction for each direction.

        Args:
            points: what the directions are at, in the same rows; by default all start at the origin.
            scale: of a direction, in the unit of the positions; at most 1e30.

        Returns:
            "Normals" (the directions, which .ply keeps too), "point" (the row) and, where it is kept, "pdf". Rows whose
            status is not 0 have no directions and are left out.

        Raises:
            ModuleNotFoundError: PyVista is missing.
            TypeError: not SurfacePoints, or a scale that is no number.
            ValueError: another number of points, or a scale that is too large.

        Example:
            >>> mesh = ws.load_mesh("courtyard")
            >>> points = ws.sample_surface(mesh, 100)
            >>> cloud = ws.sample_directions(points, 16).to_polydata(points, scale=0.5)
            >>> print(cloud.n_points)
            1600
        """
        scale = check_scale(scale)
        vectors, pdf, status = (a.numpy() if isinstance(a, wp.array) else a for a in (self.vectors, self.pdf, self.status))
        rows = np.flatnonzero(status == 0)
        if not isinstance(points, SurfacePoints | None):
            raise TypeError(f"points: got {told(points)}, want SurfacePoints, as sample_surface gives them")
        if points is not None and len(points) != len(status):
            raise ValueError(f"points: got {len(points)} points, want {len(status)}, one for each row of directions")
        start = np.zeros((1, 1, 3)) if points is None else points.position[rows, None].astype(np.float64)
        ways = vectors[rows]
        return cloud(
            (start + scale * ways).reshape(-1, 3),
            ways.reshape(-1, 3),
            point=np.repeat(rows, ways.shape[1]),
            pdf=None if pdf is None else pdf[rows].ravel(),
        )


@explained_by(CallOptions)
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
    """`count` directions about each normal.

    The bits are a pure function of (seed, first_point + row, sample, count): chunks, threads and which points are active
    do not change them. The first kernel of a process takes about 1.5 s to compile; compiled ones are cached on disk.

    Args:
        normals: (P, 3) float32 or float64, of any length above 0; or SurfacePoints. NumPy in, NumPy out; wp.array in,
            wp.array out on its device. Arrays of other libraries (PyTorch, JAX, CuPy) are taken without a copy: as NumPy's
            in the CPU's memory, as a wp.array on a CUDA device. A zero or non-finite normal gives zero vectors, pdf 0 and
            a status.
        count: directions per point, n, 1 to 2^31 - 1.
        distribution: an instance, or a name for one with its defaults.
        sequence: a name of `warpsample.sequences.names()`.
        pdf: whether to return the density of each direction.
        active: (P,) bool; rows that are False give zero vectors and cost next to nothing.
        out: a float32 array of shape (P, n, 3) to write into, of the same kind as the normals; another library's is written
            in place too, and `vectors` is a NumPy array or wp.array of its memory.
        device: where to compute, by default where the normals are; NumPy arrays go to a CUDA device in parts and back.
        seed, first_point, workers, progress: see `CallOptions`.

    Returns:
        vectors (P, n, 3) of unit length in world coordinates, pdf (P, n) if asked for, and a status per point.

    Raises:
        TypeError, ValueError: an argument that cannot be used; names it, what it got and what it wants.
        MemoryError: more than is free; says how much and how to stream.

    Example:
        >>> points = ws.sample_surface(ws.load_mesh("courtyard"), 100)
        >>> d = ws.sample_directions(points, 16, distribution=ws.Beckmann(alpha=0.1), pdf=True)
        >>> print(d.vectors.shape, d.pdf.shape, (d.pdf > 0.0).all())
        (100, 16, 3) (100, 16) True
    """
    given = as_vectors(normals.normal if isinstance(normals, SurfacePoints) else normals, 3, "normals", "(P, {})")
    if len(given.shape) != 1 or given.shape == (0,):
        raise ValueError(f"normals: got shape {(*given.shape, 3)}, want (P, 3) with P of at least 1")
    points, count = given.shape[0], check_integer(count, "count", 1, 2**31 - 1)
    ids = normals.id if isinstance(normals, SurfacePoints) else None
    drawn = {"seed": seed, "first_point": first_point, "ids": ids, "active": active}
    how = {"device": device, "workers": workers, "progress": progress, "given": given.owner, "argument": "normals"}
    options = CallOptions.of(points, **drawn, **how)
    sampling = DirectionPlan(
        as_spatial(distribution),
        sequences.get(sequence),
        count,
        check_flag(pdf, "pdf"),
        options,
    )
    shape, total = (points, count), points * count
    vectors = None if out is None else check_out(out, given, shape)
    size = total * ((12 if out is None else 0) + (4 if sampling.pdf else 0)) + points
    if given.device.is_cpu:
        check_memory(size, f"{total:,} directions", _STREAM_HINT)
    vectors = vectors or new_vectors(given, shape, 3)
    densities = new_vectors(given, shape, 1) if sampling.pdf else None
    with bar(options.progress, "sampling directions"):
        status = sampling.fill(given, vectors, densities)
    return Directions(vectors.owner, densities and densities.owner, status)


@explained_by(CallOptions)
def sample_square(sequence: str, points: int, count: int, *, seed: int = 0, first_point: int = 0) -> np.ndarray:
    """The points of the square that `sample_directions` maps to directions.

    Args:
        sequence: a name of `warpsample.sequences.names()`.
        points: how many surface points, P.
        count: points of the square for each, n, 1 to 2^31 - 1.
        seed, first_point: see `CallOptions`.

    Returns:
        (P, n, 2) float32, multiples of 2^-24 in [0, 1).

    Raises:
        TypeError, ValueError: an argument that cannot be used; names it.
        MemoryError: more than is free.

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
    check_memory(8 * total, f"{total:,} points of the square", "take them in parts with first_point")
    square = np.empty((points, count, 2), np.float32)
    for start, end in split_at_high_word(options.first_point, points):
        pairs = (end - start) * count
        inputs = [pairs, FLAT_BLOCK, count, options.seed, options.first_point + start, square[start:].ctypes.data]
        run(square_blocks(record), -(-pairs // FLAT_BLOCK), inputs, cpu(), workers=options.workers, work=pairs)
    return square
