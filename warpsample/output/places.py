"""Points at which a command computes: random on the surface (`--points`), or vertices or face centres (`--at`)."""

from warpsample.host.arguments import check_integer
from warpsample.host.engine import check_memory
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.points.sampling import BYTES_PER_POINT, sample_surface
from warpsample.mesh.surface import SurfacePoints, face_centers, vertex_points

PLACES = {"vertices": vertex_points, "faces": face_centers}


def check_points(points: int | None) -> None:
    """Check the number of random points of the option --points.

    Raises:
        ValueError: a number that is not positive, or too large.
        MemoryError: the points do not fit into memory.
    """
    if points is not None:
        check_integer(points, "--points", 1, 2**31 - 1)
        check_memory(BYTES_PER_POINT * points, f"{points:,} surface points", "take fewer with --points")


def check_places(points: int | None, at: str | None) -> None:
    """Check the options --points and --at, which exclude each other.

    Raises:
        ValueError: both, or a wrong number.
        MemoryError: the points do not fit into memory.
    """
    if points is not None and at is not None:
        raise ValueError(f"--points: got {points} together with --at {at}, want only one of the two")
    check_points(points)


def points_on(mesh: Mesh, points: int | None, at: str | None, seed: int) -> SurfacePoints:
    """Return the points of a mesh that --points (random, uniform by area) or --at (vertices, face centres) specifies."""
    return PLACES[at or "vertices"](mesh) if points is None else sample_surface(mesh, points, seed=seed)
