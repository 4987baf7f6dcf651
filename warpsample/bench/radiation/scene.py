"""Points, a reference of their sky, and a year of suns."""

import numpy as np

from warpsample.bench.record import SEED
from warpsample.bench.scenes import SCENES
from warpsample.directions.sample import sample_directions
from warpsample.host.registry import look_up
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.surface import SurfacePoints, sample_surface
from warpsample.radiation.sky.sky_matrix import sky_matrix
from warpsample.tracing.trace import trace

OFF = 1e-5
"""Of the mesh's size, by which peers move points off their face."""

REFERENCE_RAYS = 1 << 16
_REFERENCE_SEED = 1 << 40  # far from those of the estimates
_CLOSE = 1e-4  # of the mesh's size: tools put what is nearer on different sides
_LOOKS = 64
_LATITUDE = 52.37  # Amsterdam's
_TILT = 23.44


def points_of(scene: str, points: int) -> tuple[Mesh, SurfacePoints]:
    """A scene and points uniform on it by area, in the order of the faces; seed 0.

    Those that have something within 10^-4 of the mesh's size before them are left out.
    """
    mesh = look_up(SCENES, scene, "scene")()
    found = sample_surface(mesh, points + points // 4 + 16, seed=SEED)
    looks = sample_directions(found.normal, _LOOKS, seed=SEED).vectors
    clear = (trace(mesh, found, looks, max_distance=_CLOSE * size_of(mesh), any_hit=True).face < 0).all(axis=1)
    chosen = np.flatnonzero(clear)[:points]
    if len(chosen) < points:
        raise ValueError(f"points: got {len(chosen)} with nothing close before them, want {points}")
    chosen = chosen[np.argsort(found.face[chosen], kind="stable")]
    return mesh, SurfacePoints(found.position[chosen], found.normal[chosen], found.face[chosen])


def size_of(mesh: Mesh) -> float:
    """The longest side of its box."""
    return float(np.ptp(mesh.vertices, axis=0).max())


def lifted(mesh: Mesh, points: SurfacePoints) -> np.ndarray:
    """(P, 3) float32: where peers start their rays."""
    return (points.position + OFF * size_of(mesh) * points.normal).astype(np.float32)


def sky_reference(mesh: Mesh, points: SurfacePoints, workers: int) -> np.ndarray:
    """(P, 145) float64: by `sky_matrix` with 65,536 rays in place of 1,024, of another seed."""
    found = sky_matrix(mesh, points, REFERENCE_RAYS, seed=_REFERENCE_SEED, workers=workers)
    return found.value.astype(np.float64)


def year_of_suns() -> np.ndarray:
    """(T, 3) float32, about 4,400: of each hour of a year in which the sun is up, by a circular orbit; +x east, +y north."""
    hours = np.arange(8760) + 0.5
    declination = -np.radians(_TILT) * np.cos(2.0 * np.pi * (hours / 24.0 + 10.0) / 365.0)
    angle, latitude = 2.0 * np.pi * (hours % 24.0 - 12.0) / 24.0, np.radians(_LATITUDE)
    east = -np.cos(declination) * np.sin(angle)
    north = np.cos(latitude) * np.sin(declination) - np.sin(latitude) * np.cos(declination) * np.cos(angle)
    up = np.sin(latitude) * np.sin(declination) + np.cos(latitude) * np.cos(declination) * np.cos(angle)
    return np.stack([east, north, up], axis=1)[up > 0.0].astype(np.float32)
