"""Rays: none leaves a closed mesh, wherever it is aimed; both tracers and both queries agree."""

from functools import cache

import numpy as np

from warpsample.directions.sample import sample_directions
from warpsample.host.extras import missing
from warpsample.mesh.mesh import Mesh, as_mesh
from warpsample.mesh.points.sampling import sample_surface
from warpsample.proof.verify import LEVEL, Verdict
from warpsample.tracing.trace import trace

_PER_POINT = 64


@cache
def closed_meshes() -> dict[str, tuple[Mesh, tuple[float, float, float]]]:
    """Closed meshes by name, with a point inside each; a ModuleNotFoundError without trimesh, which makes them."""
    try:
        from trimesh import creation
    except ModuleNotFoundError:
        raise missing("the laws of rays need trimesh", "trimesh") from None

    torus = creation.torus(1.0, 0.3, major_sections=48, minor_sections=24)
    return {
        "sphere": (as_mesh(creation.icosphere(subdivisions=4)), (0.0, 0.0, 0.0)),
        "torus": (as_mesh(torus), (1.0, 0.0, 0.0)),
        "box": (as_mesh(creation.box()), (0.1, 0.1, 0.1)),
        "needles": (as_mesh(creation.cylinder(1e-3, 1.0, sections=200)), (0.0, 0.0, 0.1)),
    }


def rays_inside(mesh: Mesh, count: int, seed: int) -> tuple[np.ndarray, np.ndarray]:
    """Rays in all directions, (P, 3) and (P, 64, 3), from just below the faces of a closed mesh, uniform by area."""
    points = sample_surface(mesh, count // _PER_POINT, seed=seed)
    below = 1e-5 * np.ptp(mesh.vertices, axis=0).max()
    directions = np.random.default_rng(seed).normal(size=(count // _PER_POINT, _PER_POINT, 3))
    return points.position - below * points.normal, directions.astype(np.float32)


def rays_at_edges(mesh: Mesh, origin: tuple[float, float, float], count: int, seed: int) -> tuple[np.ndarray, np.ndarray]:
    """Rays (R, 3), (R, 3) from near `origin`: every second one at a vertex, the others at points on edges, in float64."""
    rng = np.random.default_rng(seed)
    face, corner = rng.integers(0, len(mesh.faces), count), rng.integers(0, 3, count)
    start, end = (mesh.vertices[mesh.faces[face, (corner + k) % 3]] for k in (0, 1))
    share = np.where(np.arange(count) % 2 == 0, rng.uniform(size=count), 0.0)[:, None]
    origins = origin + rng.normal(0.0, 1e-4, (count, 3))
    return origins, start + share * (end - start) - origins


def _most_apart(rays: int) -> float:
    """How many rays may pass a silhouette's edge so near that the tracers' starts, a millionth apart, decide.

    On the torus these are 0.8 in a million (32 of 40 million, by 16 runs), on the others fewer; more by chance than this
    are one in 10^7.
    """
    from scipy.stats import poisson

    return float(poisson.isf(LEVEL, 1e-6 * rays))


def judge_rays(thorough: bool) -> list[Verdict]:
    """Judges every closed mesh; if thorough with ten times as many rays: 10^7 inside, 10^6 at edges."""
    count = 10_000_000 if thorough else 1_000_000
    meshes = closed_meshes()
    return [
        verdict
        for name, (mesh, origin) in meshes.items()
        for verdict in judge_mesh(name, mesh, origin, count // len(meshes), count // 10 // len(meshes))
    ]


def judge_mesh(name: str, mesh: Mesh, origin: tuple[float, float, float], inside: int, at_edges: int) -> list[Verdict]:
    """The laws of one closed mesh, faces outward.

    So many rays start from just below it in all directions; others are aimed at edges and vertices from the origin, a point
    inside.
    """
    rays, aimed = rays_inside(mesh, inside, 1), rays_at_edges(mesh, origin, at_edges, 2)
    found = [trace(mesh, *rays, any_hit=any_hit, tracer="wide").face for any_hit in (False, True)]
    escaped = sum(np.count_nonzero(face < 0) for face in found)
    through = [np.count_nonzero(trace(mesh, *aimed, tracer=tracer).face < 0) for tracer in ("wide", "warp")]
    through[0] += np.count_nonzero(trace(mesh, *aimed, any_hit=True, tracer="wide").face < 0)
    points = sample_surface(mesh, inside // _PER_POINT, seed=3)
    cosines = sample_directions(points, _PER_POINT, seed=3).vectors
    wide, warp = (trace(mesh, points, cosines, tracer=tracer).face for tracer in ("wide", "warp"))
    # Closer to the horizon the rounding of a direction decides on which side of its face a ray is.
    clear = (cosines * points.normal[:, None]).sum(axis=2) > 1e-5
    own = np.count_nonzero((wide == points.face[:, None]) & clear)
    differ = np.count_nonzero(((wide < 0) != (warp < 0)) & clear)
    everywhere = f"of {inside:,} in all directions, by either query"
    aimed_at = f"of {at_edges:,} at edges; wp.Mesh {through[1]:,}"
    return [
        Verdict.of_error("rays that leave a closed mesh", name, escaped, note=everywhere),
        Verdict.of_error("rays between two faces", name, through[0], note=aimed_at),
        Verdict.of_error("rays that meet their own face", name, own, note="of surface points, outward"),
        Verdict.of_error("tracers that differ", name, differ, limit=_most_apart(inside), note="wide and wp.Mesh"),
    ]
