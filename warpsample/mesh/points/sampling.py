"""Random points on the surface of a mesh: independent points, or Poisson-disk points with a minimum distance."""

from typing import Any

import numpy as np

from warpsample.host.arguments import check_choice, check_flag, check_integer, check_number
from warpsample.host.engine import check_memory, run
from warpsample.host.options import CallOptions
from warpsample.mesh.mesh import Mesh, as_mesh
from warpsample.mesh.placing import BLOCK, guide_to, place_points
from warpsample.mesh.points.thinning import darts_for, thinned
from warpsample.mesh.surface import SurfacePoints

BYTES_PER_POINT = 24 + 12 + 4
"""Bytes of memory per point: position, normal and face."""

SPACINGS = ("random", "blue")


def sample_surface(
    mesh: Any,
    count: int | None = None,
    *,
    spacing: str = "random",
    radius: float | None = None,
    seed: int = 0,
    first_point: int = 0,
    barycentric: bool = False,
    device: Any = None,
    workers: int | None = None,
) -> SurfacePoints:
    """Sample points on the surface, uniform by area.

    Row i is a pure function of (mesh, seed, first_point + i), so a run can be split anywhere. Areas are summed in float64
    and drawn with 64 bits, which keeps the shares of 10^7 faces. `spacing="blue"` thins sixteen times as many random
    points to Poisson-disk points; all rows then depend on (mesh, seed, count, radius).

    Args:
        mesh: Mesh or anything that `as_mesh` accepts. Degenerate faces get no points.
        count: Number of points, 1 to 2^31 - 1. Default: None, as many as `radius` allows.
        spacing: "random" for independent points, "blue" for Poisson-disk points. Default: "random".
        radius: Least distance of "blue" points in space, a float in mesh units, where normals differ by less than 120
            degrees, so that both sides of a sheet have points. Default: None, about 0.76 of the root of the area per point.
        seed: Random seed, an integer of 64 bits. Default: 0.
        first_point: Global id of row 0, an integer; 0 for points with an `id`. Default: 0.
        barycentric: Whether to return the weights of the corners. Default: False.
        device: Warp device, such as "cuda:0", which computes in parts and returns NumPy arrays. Default: None, the CPU.
        workers: Number of CPU threads, an integer. Default: None, the value of WARPSAMPLE_WORKERS or all cores.

    Returns:
        position float64, normal float32 (of the face), face; barycentric if asked for.

    Raises:
        TypeError, ValueError: an argument that cannot be used, or a mesh without area; names it.
        MemoryError: more than is free.

    Source: Turk1990, method 2; Cline2009 for Poisson disks, here of points that are thrown beforehand.

    Example:
        >>> mesh = ws.load_mesh("courtyard")
        >>> points = ws.sample_surface(mesh, 100, seed=1)
        >>> print(points.position.shape, points.normal.shape, points.face.max() < len(mesh.faces))
        (100, 3) (100, 3) True
        >>> print(ws.sample_surface(mesh, spacing="blue", radius=3.0).position.shape[0] > 500)
        True
    """
    mesh, barycentric = as_mesh(mesh), check_flag(barycentric, "barycentric")
    check_choice(spacing, "spacing", SPACINGS)
    if radius is not None:
        radius = _check_radius(radius, count, spacing)
    if radius is None:
        count = check_integer(count, "count", 1, 2**31 - 1)
    if not mesh.face_areas.any():
        raise ValueError("mesh: got a mesh whose faces have no area, want at least one face with an area")
    blue = spacing == "blue"
    if blue and first_point != 0:
        raise ValueError(
            f"first_point: got {first_point!r} with spacing='blue', want 0, because blue-noise points depend on each other"
        )
    drawn = darts_for(count, radius, float(mesh.face_areas.sum())) if blue else count
    drawn = check_integer(drawn, "count", 1, 2**31 - 1)
    options = CallOptions.of(drawn, seed=seed, first_point=first_point, device=device, workers=workers)
    points = _random_points(mesh, drawn, options, barycentric)
    if not blue:
        return points
    return points.take(thinned(points, count, radius, float(mesh.face_areas.sum()), options.workers))


def _check_radius(radius: Any, count: Any, spacing: str) -> float:
    """Return `radius` as a float; raise a ValueError unless spacing is "blue" and `count` is None."""
    if spacing != "blue":
        raise ValueError(f"radius: got {radius!r} with spacing={spacing!r}, want no radius, or spacing='blue'")
    if count is not None:
        raise ValueError(f"radius: got {radius!r} with count={count!r}, want only one of the two")
    return check_number(radius, "radius", 1e-300, 1e300)


def _random_points(mesh: Mesh, count: int, options: CallOptions, barycentric: bool) -> SurfacePoints:
    """Sample independent points on the surface, uniformly by area."""
    memory = options.memory
    size = count * (BYTES_PER_POINT + (24 if barycentric else 0))
    check_memory(size, f"{count:,} surface points", "take them in parts with first_point")
    position, normal, face = np.empty((count, 3)), np.empty((count, 3), np.float32), np.empty(count, np.int32)
    weights = np.empty((count if barycentric else 0, 3))
    block = BLOCK if memory.in_place else 1
    last = int(np.searchsorted(mesh.area_sums, mesh.area_sums[-1]))  # last face with an area above 0
    guide = guide_to(mesh.area_sums[: last + 1], count)
    with memory.loan() as whole:
        surface = [len(mesh.vertices), last, *map(whole.lend, (mesh.vertices, mesh.faces, mesh.area_sums, guide))]
        surface += [(len(guide) - 1).bit_length() - 1, whole.lend(mesh.face_normals)]
        for rows in memory.parts(count, size // count):
            points = rows.stop - rows.start
            with memory.loan() as loan:
                found = [loan.output(array, rows) for array in (position, normal, face)]
                found.append(loan.output(weights, rows) if barycentric else 0)
                inputs = [options.seed, options.first_point + rows.start, points, *surface, *found]
                run(
                    place_points(block), -(-points // block), inputs, memory.device, workers=options.workers, work=8 * points
                )
    return SurfacePoints(position, normal, face, weights if barycentric else None)
