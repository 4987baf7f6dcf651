"""What all tools are asked for, each in a process of its own: here their results become jobs.

`count` directions of the cosine lobe about each of `points` normals, float32 (x, y, z); or points on a mesh, uniform by
area.
"""

from collections.abc import Callable
from dataclasses import dataclass
from importlib.metadata import version
from typing import Any

import numpy as np

from warpsample.bench.child import Job
from warpsample.bench.integrands import INTEGRANDS, evaluate
from warpsample.bench.peers.directions import DIRECTIONS
from warpsample.bench.peers.surface import SURFACE
from warpsample.bench.peers.tool import Peer
from warpsample.bench.record import SEED
from warpsample.proof import twins

SAMPLES = 64
_JUDGED = 1 << 20  # directions or points that the report's means take


def build_directions(peer: str, points: int, workers: int) -> Job:
    """The job of one peer; its report has "library" and "means", {integrand: [mean, its standard error]}."""
    normals = np.random.default_rng(SEED).normal(size=(points, 3))
    normals = (normals / np.linalg.norm(normals, axis=1, keepdims=True)).astype(np.float32)
    work, result = DIRECTIONS[peer].build(normals, SAMPLES, workers)
    frames = twins.frames(normals[: max(1, _JUDGED // SAMPLES)].astype(np.float64))

    def report() -> dict[str, Any]:
        d = np.asarray(result()).reshape(points, SAMPLES, 3)[: len(frames)]
        local = np.einsum("nij,nsi->nsj", frames, d).reshape(-1, 3).astype(np.float32)
        return _report(DIRECTIONS[peer], {i.name: evaluate(i, local).astype(np.float64) for i in INTEGRANDS})

    return Job(work, report)


def build_surface(peer: str, points: int, workers: int) -> Job:
    """Points on a sphere of 81,920 faces; the report's means are of x, x^2 and z^2."""
    import trimesh  # noqa: PLC0415

    work, result = SURFACE[peer].build(trimesh.creation.icosphere(subdivisions=6), points, workers)

    def report() -> dict[str, Any]:
        p = np.asarray(result(), np.float64)[:_JUDGED]
        return _report(SURFACE[peer], {"x": p[:, 0], "x^2": p[:, 0] ** 2, "z^2": p[:, 2] ** 2})

    return Job(work, report)


@dataclass(frozen=True)
class Task:
    """What the tools compete at.

    Attributes:
        peers: by name.
        ours: whose speed the others' are compared with.
        build: (peer, points, workers) -> its job.
        each: directions or points for each of `points`.
        exact: the means that each must have, by name.
        rounding: how far a mean may be off by construction.
    """

    peers: dict[str, Peer]
    ours: str
    build: Callable[..., Job]
    each: int
    exact: dict[str, float]
    rounding: float


TASKS = {
    "directions": Task(
        DIRECTIONS, "warpsample independent", build_directions, SAMPLES, {i.name: i.mean for i in INTEGRANDS}, 1e-9
    ),
    # The faceted sphere lies within 1e-4 of the round one, so its means do.
    "surface": Task(SURFACE, "warpsample surface", build_surface, 1, {"x": 0.0, "x^2": 1.0 / 3.0, "z^2": 1.0 / 3.0}, 1e-4),
}


def _report(peer: Peer, values: dict[str, np.ndarray]) -> dict[str, Any]:
    means = {name: [float(v.mean()), float(v.std() / np.sqrt(len(v)))] for name, v in values.items()}
    return {"library": f"{peer.library} {version(peer.library)}", "means": means}
