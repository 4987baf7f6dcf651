"""`sample_directions` into an existing array, against NumPy's fill of it and against Warp's own sampler."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from statistics import median

import numpy as np
import warp as wp

from warpsample.bench.timing import interleave, ratio_of
from warpsample.directions import sample_directions
from warpsample.distributions.cosine_hemisphere import CosineHemisphere
from warpsample.engine import check_workers

SEQUENCES = ("sobol", "independent", "fibonacci")
METHODS = ("polar", "offset")


@dataclass(frozen=True)
class Row:
    """One case.

    Attributes:
        case: "fill" (NumPy's `out.fill(0)`), "built-ins" (a plain Warp kernel, a sample per task, one thread), or
            "sequence method".
        points: P.
        samples: per point.
        workers: threads.
        million_per_second: directions, median.
        of_fill: this case's speed over the fill's in the same round: median, least, greatest.
        of_builtins: over the built-ins', median.
        of_one_worker: over the same case's with one worker, median; 1 for one worker.
        seconds: of each repeat.
    """

    case: str
    points: int
    samples: int
    workers: int
    million_per_second: float
    of_fill: tuple[float, float, float]
    of_builtins: float
    of_one_worker: float
    seconds: list[float]


@wp.kernel(enable_backward=False)
def _builtins(normals: wp.array[wp.vec3], samples: wp.int32, seed: wp.int32, out: wp.array[wp.vec3]):
    """What a Warp user writes today for the cosine lobe: the sphere sampler plus the normal, a sample per task."""
    i = wp.tid()
    state = wp.rand_init(seed, i)
    out[i] = wp.normalize(normals[i / samples] + wp.sample_unit_sphere_surface(state))


def measure(points: int, repeats: int) -> Iterator[Row]:
    """All cases at (points x 64) and (64 points x 1)."""
    for shape in ((points, 64), (64 * points, 1)):
        yield from _measure_shape(*shape, repeats)


def _measure_shape(points: int, samples: int, repeats: int) -> Iterator[Row]:
    normals = np.random.default_rng(0).normal(size=(points, 3)).astype(np.float32)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    out = np.zeros((points, samples, 3), np.float32)
    everyone = check_workers(None)
    cases: dict[tuple[str, int], Callable[[], object]] = {
        ("fill", 1): partial(out.fill, 0.0),
        ("built-ins", 1): _builtins_case(normals, out),
    }
    for sequence in SEQUENCES:
        for method in METHODS:
            for workers in sorted({1, everyone}):
                cases[f"{sequence} {method}", workers] = partial(
                    sample_directions, normals, samples, CosineHemisphere(method), sequence, out=out, workers=workers
                )
    times = dict(zip(cases, interleave(list(cases.values()), repeats), strict=True))
    for (case, workers), seconds in times.items():
        yield Row(
            case=case,
            points=points,
            samples=samples,
            workers=workers,
            million_per_second=points * samples / median(seconds) / 1e6,
            of_fill=ratio_of(times["fill", 1], seconds),
            of_builtins=ratio_of(times["built-ins", 1], seconds)[0],
            of_one_worker=ratio_of(times[case, 1], seconds)[0],
            seconds=seconds,
        )


def _builtins_case(normals: np.ndarray, out: np.ndarray) -> Callable[[], object]:
    total, samples = out.shape[0] * out.shape[1], out.shape[1]
    given = wp.array(normals, dtype=wp.vec3, device="cpu", copy=False)
    target = wp.array(out.reshape(-1, 3), dtype=wp.vec3, device="cpu", copy=False)
    return partial(
        wp.launch, _builtins, dim=total, inputs=[given, samples, 0], outputs=[target], device="cpu", record_tape=False
    )
