"""Where the points of a command are: so many on the surface (`--points`), or at the vertices or the faces (`--at`)."""

from warpsample.host.arguments import check_integer
from warpsample.host.engine import check_memory
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.points.sampling import BYTES_PER_POINT, sample_surface
from warpsample.mesh.surface import SurfacePoints, face_centers, vertex_points

PLACES = {"vertices": vertex_points, "faces": face_centers}


def check_places(points: int | None, at: str | None) -> None:
    """Refuses a wrong number of points, one beside a place, and more than there is memory for."""
    if points is None:
        return
    if at is not None:
        raise ValueError(f"--points: got {points} together with --at {at}, want one of the two")
    check_integer(points, "--points", 1, 2**31 - 1)
    check_memory(BYTES_PER_POINT * points, f"{points:,} surface points", "take fewer with --points")


def points_on(mesh: Mesh, points: int | None, at: str | None, seed: int) -> SurfacePoints:
    """The points of checked options: uniform by area if their number is given, else at the vertices or what is named."""
    return PLACES[at or "vertices"](mesh) if points is None else sample_surface(mesh, points, seed=seed)
