"""`sample_directions` into an existing array: time per direction of every map and sequence, beside NumPy's fill of it."""

import re
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial
from typing import Annotated, Any

import numpy as np
import typer
import warp as wp

from warpsample import distributions, sequences
from warpsample.bench.record import SEED, Repeats, Track
from warpsample.bench.timing import Spread, interleave, stopwatch
from warpsample.directions.sample import sample_directions, sample_square
from warpsample.distributions.cosine_hemisphere import CosineHemisphere
from warpsample.distributions.record import Distribution
from warpsample.host.engine import check_workers
from warpsample.proof import laws, twins
from warpsample.proof.evidence import Evidence, Subject
from warpsample.proof.stress import exact_directions

COUNTS = (1, 4, 16, 64, 256)
SAMPLES = 64
"""Of the table of maps."""
GIVEN = "given"
"""In place of a sequence: the map alone, `distribution.sample(u)` into a new array, for what lies in a plane."""
_ERRORS_EVERY = 64  # the sweep's step through the 2^24 variates
_ERROR_POINTS = 2048
_BUDGET = 20.0  # seconds after which a group makes do with three repeats


@dataclass(frozen=True)
class Speed:
    """One case.

    Attributes:
        table: "maps" (all at 64 samples, independent) or "sequences" (all with the cosine lobe, polar).
        distribution: as Python writes it; "fill" for NumPy's `out.fill(0)` of the same array, one thread.
        sequence: its name, "" for fill, or GIVEN.
        points: P.
        samples: of each point.
        workers: threads.
        pdf: whether densities are computed and stored.
        million_per_second: directions.
        nanoseconds: per direction.
        of_fill: its speed over that of a fill right after it.
        worst: "length" (of unit length), "angle" (radians) and "pdf" (relative): worst errors against float64.
        seconds: of each repeat; none where they were not kept.
        fill_seconds: of the fill after each.
    """

    table: str
    distribution: str
    sequence: str
    points: int
    samples: int
    workers: int
    pdf: bool
    million_per_second: Spread
    nanoseconds: Spread
    of_fill: Spread
    worst: dict[str, float]
    seconds: list[float] = field(default_factory=list)
    fill_seconds: list[float] = field(default_factory=list)


@dataclass(frozen=True)
class Found:
    """Of every map, sequence and count."""

    rows: list[Speed]


@dataclass(frozen=True)
class Settings:
    """Of the command."""

    points: Annotated[int, typer.Option(help="Points, with 64 samples each, or as many directions.", min=1)] = 65_536
    repeats: Repeats = 15


def measure(settings: Settings, track: Track) -> Found:
    """Everything."""
    chosen = groups(settings.points, settings.repeats)
    return Found([row for group in track(chosen, len(chosen)) for row in group()])


def maps() -> list[Distribution]:
    """The cosine lobe by every method, then an ordinary case of every other distribution, those in a plane last."""
    all_cases = [distributions.get(name).cases() for name in distributions.names()]
    chosen = [
        case for cases in all_cases for case in (cases if cases[0] == CosineHemisphere() else [cases[len(cases) // 2]])
    ]
    return sorted(chosen, key=lambda case: (not isinstance(case, CosineHemisphere), -case.width))


def groups(points: int, repeats: int) -> list[Callable[[], list[Speed]]]:
    """What measures the rows, an interleaved group at a time.

    Args:
        points: with 64 samples each; with other counts as many as give the same number of directions.
        repeats: timed runs of each case.
    """
    everyone = sorted({1, check_workers(None)})
    by_map = [
        partial(
            _measure_group, "maps", points, SAMPLES, [(case, "independent", w, p) for w in everyone for p in (False, True)]
        )
        if case.width == 3
        else partial(_measure_group, "maps", points, SAMPLES, [(case, GIVEN, everyone[-1], False)])
        for case in maps()
    ]
    by_sequence = [
        partial(
            _measure_group,
            "sequences",
            max(1, points * SAMPLES // count),
            count,
            [(CosineHemisphere(), name, w, False) for name in sequences.names() for w in everyone],
        )
        for count in COUNTS
    ]
    return [partial(group, repeats) for group in [*by_map, *by_sequence]]


def worst_errors(case: Distribution) -> dict[str, float]:
    """Of "length", "angle" and "pdf", over a grid of variates, and about random normals in the world's coordinates."""
    local = Evidence(Subject(repr(case), case, case), every=_ERRORS_EVERY).sweep
    if case.width == 2:
        return {name: local[name] for name in ("length", "angle", "pdf") if name in local}
    normals = np.random.default_rng(1).normal(size=(_ERROR_POINTS, 3)).astype(np.float32)
    got = sample_directions(normals, SAMPLES, distribution=case, sequence="independent", pdf=True)
    w = got.vectors.astype(np.float64)
    exact, in_frame = exact_directions(case, normals, sample_square("independent", len(normals), SAMPLES))
    # Where the offset method draws its rim anew, by another hash, it has no twin.
    kept = 2.0 * np.pi * got.pdf > 2.0**-6 * 1.001 if case == CosineHemisphere("offset") else np.ones(w.shape[:2], bool)
    world = {
        "length": laws.length_error(w),
        "angle": laws.angle_error(w[kept], exact[kept]),
        "pdf": laws.density_error(got.pdf[kept], twins.density(case, in_frame)[kept]),
    }
    return {name: max(local[name], world[name]) for name in world}


def short_name(distribution: str) -> str:
    """What Python writes, without the names of strings and without what follows the first parameter."""
    return re.sub(r", .*\)", ")", distribution.replace("method=", "").replace("'", ""))


def _measure_group(table: str, points: int, samples: int, chosen: list[tuple[Any, ...]], repeats: int) -> list[Speed]:
    normals = np.random.default_rng(SEED).normal(size=(points, 3)).astype(np.float32)
    out = np.zeros((points, samples, 3), np.float32)
    fill = stopwatch(partial(out.fill, 0.0))
    cases = [stopwatch(_work(normals, out, *columns)) for columns in chosen]
    times, fills = interleave([fill, *cases], repeats, reference=fill, budget=_BUDGET)
    worst = worst_errors(chosen[0][0]) if table == "maps" else {}
    described = [("fill", "", 1, False), *chosen]
    return [
        Speed(
            table=table,
            distribution=str(case),
            sequence=sequence,
            points=points,
            samples=samples,
            workers=workers,
            pdf=pdf,
            million_per_second=Spread.of([points * samples / t / 1e6 for t in seconds]),
            nanoseconds=Spread.of([1e9 * t / (points * samples) for t in seconds]),
            of_fill=Spread.of_ratios(beside, seconds),
            worst={} if case == "fill" else worst,
            seconds=seconds,
            fill_seconds=beside,
        )
        for (case, sequence, workers, pdf), seconds, beside in zip(described, times, fills, strict=True)
    ]


def _work(
    normals: np.ndarray, out: np.ndarray, case: Distribution, sequence: str, workers: int, pdf: bool
) -> Callable[[], object]:
    if sequence != GIVEN:
        return partial(
            sample_directions, normals, out.shape[1], distribution=case, sequence=sequence, pdf=pdf, out=out, workers=workers
        )
    u = sample_square("independent", *out.shape[:2])
    return partial(case.sample, wp.array(u, dtype=wp.vec2, device="cpu", copy=False))
