"""Meshes for the benchmarks, with sets of rays and points on the meshes."""

from collections.abc import Callable
from functools import cache
from pathlib import Path

import numpy as np
import warp as wp

from warpsample.bench.record import SEED
from warpsample.directions.sample import sample_directions
from warpsample.distributions.uniform_sphere import UniformSphere
from warpsample.host.extras import missing
from warpsample.host.registry import look_up
from warpsample.mesh.files import load_mesh
from warpsample.mesh.mesh import Mesh, as_mesh
from warpsample.mesh.points.sampling import sample_surface
from warpsample.mesh.surface import SurfacePoints
from warpsample.tracing.trace import trace

PER_POINT = 64
"""Cosine rays per point."""

KINDS = ("camera", "outward", "inward", "random")

_OFFSET = 1e-4  # of the mesh's size: larger than every tool's rounding, so that all tools trace the same rays
_LATITUDE, _TILT = 52.37, 23.44  # degrees; latitude of Amsterdam, tilt of the Earth's axis
_LOOKS = 64  # directions per point of the test for close faces


def bunny(subdivisions: int) -> Mesh:
    """Load the bunny mesh that comes with warp-lang; each subdivision splits its 12,200 triangles in four.

    Raises:
        ModuleNotFoundError: `subdivisions` is positive and trimesh is missing; the message explains how to install it.
    """
    mesh = load_mesh(Path(wp.__file__).parent / "examples" / "assets" / "bunny.usd")
    vertices, faces = mesh.vertices, mesh.faces
    if subdivisions:
        try:
            from trimesh.remesh import subdivide
        except ModuleNotFoundError:
            raise missing("the split bunny needs trimesh", "trimesh", "bench") from None
        for _ in range(subdivisions):
            vertices, faces = subdivide(vertices, faces)
    return as_mesh((vertices, faces))


def hills() -> Mesh:
    """Load PyVista's random hills as a mesh of 19,602 triangles."""
    try:
        from pyvista.examples import load_random_hills
    except ModuleNotFoundError:
        raise missing("the scene of hills needs PyVista", "pyvista") from None
    return as_mesh(load_random_hills())


def city(side: int = 64) -> Mesh:
    """Build a city mesh of side x side boxes with random heights on a square plane.

    Most triangles are long, thin and upright.
    """
    rng = np.random.default_rng(0)
    corners = np.array([[x, y, z] for z in (0.0, 1.0) for y in (0.0, 1.0) for x in (0.0, 1.0)])
    quads = np.array([[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]])
    box = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
    place = np.stack(np.meshgrid(np.arange(side), np.arange(side)), axis=-1).reshape(-1, 2) * 40.0
    sizes = np.column_stack([np.full((side * side, 2), 24.0), rng.lognormal(3.0, 0.6, side * side)])
    buildings = corners * sizes[:, None] + np.column_stack([place, np.zeros(side * side)])[:, None]
    faces = box + 8 * np.arange(side * side)[:, None, None]
    ground = np.array([[-40.0, -40.0], [side * 40.0, -40.0], [side * 40.0, side * 40.0], [-40.0, side * 40.0]])
    vertices = np.concatenate([buildings.reshape(-1, 3), np.column_stack([ground, np.zeros(4)])])
    plane = len(vertices) - np.array([[4, 3, 2], [4, 2, 1]])
    return as_mesh((vertices, np.concatenate([faces.reshape(-1, 3), plane])))


SCENES: dict[str, Callable[[], Mesh]] = {
    "bunny": lambda: bunny(0),
    "bunny, 4 to 1": lambda: bunny(1),
    "bunny, 64 to 1": lambda: bunny(3),
    "hills": hills,
    "city": city,
}
"""Functions that build the scenes, by name."""


@cache
def build_rays(mesh: Mesh, kind: str, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Build about `count` rays of one kind for a mesh: origins (P, 3) or (3,) and directions, float32, seed 0.

    Args:
        mesh: mesh that the rays are made for.
        kind: "camera": through the pixels of a square picture, row by row. "outward": cosine lobe at points uniform by area,
            in the order of the faces. "inward": the mirror image of the outward rays. "random": uniform directions from
            uniform origins in the mesh's bounding box.
        count: number of rays, at least 64.
    """
    lower, upper = mesh.report.lower, mesh.report.upper
    size = float(np.max(upper - lower))
    if kind == "camera":
        side = int(np.sqrt(count))
        across, down = np.meshgrid(*2 * [np.linspace(-0.4, 0.4, side)])
        forward = np.array([-1.0, -0.8, -0.6]) / np.linalg.norm([1.0, 0.8, 0.6])
        right = np.cross(forward, [0.0, 0.0, 1.0]) / np.linalg.norm(np.cross(forward, [0.0, 0.0, 1.0]))
        directions = forward + across.reshape(-1, 1) * right - down.reshape(-1, 1) * np.cross(right, forward)
        return (0.5 * (lower + upper) - 1.6 * size * forward).astype(np.float32), directions.astype(np.float32)
    if kind == "random":
        origins = np.random.default_rng(SEED).uniform(lower, upper, (count, 3)).astype(np.float32)
        up = np.broadcast_to(np.float32([0.0, 0.0, 1.0]), (count, 3))
        return origins, sample_directions(up, 1, distribution=UniformSphere(), sequence="independent").vectors[:, 0]
    points = sample_surface(mesh, count // PER_POINT)
    order = np.argsort(points.face, kind="stable")
    side = 1.0 if kind == "outward" else -1.0
    normal = points.normal[order]
    directions = side * sample_directions(normal, PER_POINT, sequence="independent").vectors
    return (points.position[order] + side * _OFFSET * size * normal).astype(np.float32), directions.astype(np.float32)


def sample_scene(scene: str, points: int) -> tuple[Mesh, SurfacePoints]:
    """Return a scene's mesh and points on it: uniform by area, in the order of the faces, seed 0."""
    mesh = look_up(SCENES, scene, "scene")()
    samples = sample_surface(mesh, points, seed=SEED)
    return mesh, samples.take(np.argsort(samples.face, kind="stable"))


def sample_clear_points(scene: str, points: int) -> tuple[Mesh, SurfacePoints]:
    """Return a scene's mesh and points on it that have no other face close in front.

    Close is within 10^-4 of the mesh's size.

    Raises:
        ValueError: too few points remain.
    """
    mesh = look_up(SCENES, scene, "scene")()
    samples = sample_surface(mesh, points + points // 4 + 16, seed=SEED)
    looks = sample_directions(samples.normal, _LOOKS, seed=SEED).vectors
    close = _OFFSET * float(np.ptp(mesh.vertices, axis=0).max())
    clear = (trace(mesh, samples, looks, max_distance=close, any_hit=True).face < 0).all(axis=1)
    chosen = np.flatnonzero(clear)[:points]
    if len(chosen) < points:
        raise ValueError(
            f"points: got {len(chosen)} points without a close face in front, want {points}; pass a smaller number"
        )
    return mesh, samples.take(chosen[np.argsort(samples.face[chosen], kind="stable")])


def compute_year_of_suns() -> np.ndarray:
    """Compute the directions (T, 3) float32 towards the sun in each hour of a year with the sun above the horizon.

    There are about 4,400. The Earth's orbit is circular; +x is east and +y is north.
    """
    hours = np.arange(8760) + 0.5
    declination = -np.radians(_TILT) * np.cos(2.0 * np.pi * (hours / 24.0 + 10.0) / 365.0)
    angle, latitude = 2.0 * np.pi * (hours % 24.0 - 12.0) / 24.0, np.radians(_LATITUDE)
    east = -np.cos(declination) * np.sin(angle)
    north = np.cos(latitude) * np.sin(declination) - np.sin(latitude) * np.cos(declination) * np.cos(angle)
    up = np.sin(latitude) * np.sin(declination) + np.cos(latitude) * np.cos(declination) * np.cos(angle)
    return np.stack([east, north, up], axis=1)[up > 0.0].astype(np.float32)


def check_scenes(names: list[str] | None) -> None:
    """Raise a ValueError if a name is not that of a benchmark scene; the message lists the names."""
    for name in names or []:
        look_up(SCENES, name, "scene")
