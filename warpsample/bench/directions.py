"""`bench directions`: time per direction of every map and sequence into an existing array, beside NumPy's fill of it."""

import re
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Annotated, Any

import numpy as np
import typer
import warp as wp

from warpsample import distributions, sequences
from warpsample.bench.pictures import Picture
from warpsample.bench.record import SEED, Benchmark, Found, Repeats, Track
from warpsample.bench.rows import Spread, Timed, column
from warpsample.bench.running.timing import interleave, stopwatch
from warpsample.bench.tables import Cell, TableView, all_workers
from warpsample.directions.sample import sample_directions, sample_square
from warpsample.distributions.cosine_hemisphere import CosineHemisphere
from warpsample.distributions.record import Distribution
from warpsample.host.engine import check_workers
from warpsample.proof import laws, twins
from warpsample.proof.evidence import Evidence, Subject
from warpsample.proof.stress import exact_directions

COUNTS = (1, 4, 16, 64, 256)
SAMPLES = 64
"""Samples of a point in the table of maps."""
GIVEN = "given"
"""In place of a sequence: the map alone, `distribution.sample(u)` into a new array, for what lies in a plane."""

_ERRORS_EVERY = 64  # the sweep's step through the 2^24 variates
_ERROR_POINTS = 2048
_BUDGET = 20.0  # seconds after which a group makes do with three repeats


def short_name(distribution: str) -> str:
    """What Python writes, without the names of strings and without what follows the first parameter."""
    return re.sub(r", .*\)", ")", distribution.replace("method=", "").replace("'", ""))


@dataclass(frozen=True)
class DirectionSpeed(Timed):
    """One map or sequence: of maps all at 64 samples, independent; of sequences all with the cosine lobe, polar."""

    table: str = column("table")
    distribution: str = column("map", "fill is NumPy's `out.fill(0)` of the same array, on one thread", show=short_name)
    sequence: str = column("sequence", show=lambda name: name or "fill")
    points: int = column("points")
    samples: int = column("n", "samples of a point", show="n = {}".format)
    workers: int = column("workers", show=lambda n: f"{n} workers" if n > 1 else "1 worker")
    pdf: bool = column("pdf", show=lambda pdf: "with pdf" if pdf else "")
    million_per_second: Spread = column("million a second")
    nanoseconds: Spread = column("ns", "nanoseconds of a direction; of what lies in a plane by the map alone, u given")
    of_fill: Spread = column("share of fill", "its speed over that of a fill right after it")
    worst: dict[str, float] = column("worst errors")
    fill_seconds: tuple[float, ...] = ()

    @property
    def worst_angle(self) -> float:
        """The worst angle between a direction and the one that float64 gives."""
        return self.worst["angle"]


def measure(
    track: Track,
    *,
    points: Annotated[int, typer.Option(help="Points, with 64 samples each, or as many directions.", min=1)] = 65_536,
    repeats: Repeats = 15,
) -> Found:
    """Every map at 64 samples, and every sequence with the cosine lobe."""
    chosen = groups(points, repeats)
    return {"rows": [row for group in track(chosen, len(chosen)) for row in group()]}


def maps() -> list[Distribution]:
    """The cosine lobe by every method, then an ordinary case of every other distribution, those in a plane last."""
    all_cases = [distributions.get(name).cases() for name in distributions.names()]
    chosen = [
        case for cases in all_cases for case in (cases if cases[0] == CosineHemisphere() else [cases[len(cases) // 2]])
    ]
    return sorted(chosen, key=lambda case: (not isinstance(case, CosineHemisphere), -case.width))


def groups(points: int, repeats: int) -> list[Callable[[], list[DirectionSpeed]]]:
    """What measures the rows, an interleaved group at a time.

    Args:
        points: with 64 samples each; with other counts as many as give the same number of directions.
        repeats: timed runs of each case.
    """
    everyone = sorted({1, check_workers(None)})
    by_map = [
        ("maps", points, SAMPLES, [(case, "independent", w, p) for w in everyone for p in (False, True)]
         if case.width == 3 else [(case, GIVEN, everyone[-1], False)])
        for case in maps()
    ]  # fmt: skip
    by_sequence = [
        ("sequences", max(1, points * SAMPLES // count), count,
         [(CosineHemisphere(), name, w, False) for name in sequences.names() for w in everyone])
        for count in COUNTS
    ]  # fmt: skip
    return [partial(_measure_group, *group, repeats) for group in [*by_map, *by_sequence]]


def worst_errors(case: Distribution) -> dict[str, float]:
    """The worst "length", "angle" and "pdf", over a grid of variates, and about random normals in world coordinates."""
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


def _measure_group(table: str, points: int, samples: int, chosen: list[Any], repeats: int) -> list[DirectionSpeed]:
    normals = np.random.default_rng(SEED).normal(size=(points, 3)).astype(np.float32)
    out = np.zeros((points, samples, 3), np.float32)
    fill = stopwatch(partial(out.fill, 0.0))
    cases = [stopwatch(_work(normals, out, case, name, workers=w, pdf=pdf)) for case, name, w, pdf in chosen]
    times, fills = interleave([fill, *cases], repeats, reference=fill, budget=_BUDGET)
    worst = worst_errors(chosen[0][0]) if table == "maps" else {}
    described = [("fill", "", 1, False), *chosen]
    return [
        DirectionSpeed(
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
            fill_seconds=tuple(beside),
        )
        for (case, sequence, workers, pdf), seconds, beside in zip(described, times, fills, strict=True)
    ]


def _work(
    normals: np.ndarray, out: np.ndarray, case: Distribution, sequence: str, *, workers: int, pdf: bool
) -> Callable[[], object]:
    if sequence != GIVEN:
        return partial(
            sample_directions, normals, out.shape[1], distribution=case, sequence=sequence, pdf=pdf, out=out, workers=workers
        )
    u = sample_square("independent", *out.shape[:2])
    return partial(case.sample, wp.array(u, dtype=wp.vec2, device="cpu", copy=False))


def _map_cells(rows: list[DirectionSpeed]) -> list[Cell]:
    """Times on one thread and on all, with densities, and the worst errors against float64, the frame included."""
    most = ("workers", max(row.workers for row in rows))
    return [
        Cell("nanoseconds", "1 worker", ".3g", (("workers", 1), ("pdf", False))),
        Cell("nanoseconds", f"{most[1]} workers", None, (most, ("pdf", False))),
        Cell("nanoseconds", "with pdf", ".3g", (most, ("pdf", True))),
        Cell("of_fill", None, None, (most, ("pdf", False))),
        *(Cell("worst", law, lambda worst, law=law: f"{worst[law]:.1e}" if law in worst else "–") for law in _LAWS),
    ]


def _is_map(row: DirectionSpeed) -> bool:
    return row.table == "maps"


def _is_sequence(row: DirectionSpeed) -> bool:
    return row.table == "sequences"


def _fastest_first(rows: list[DirectionSpeed]) -> list[DirectionSpeed]:
    return sorted((row for row in all_workers(rows) if row.worst and not row.pdf), key=lambda row: row.nanoseconds.median)


def _all_and_fill(rows: list[DirectionSpeed]) -> list[DirectionSpeed]:
    return [row for row in rows if row.table == "sequences" and (row in all_workers(rows) or not row.sequence)]


_WORST = "worst error of unit length, of the angle in radians, and of the pdf, relative"
_LAWS = ("length", "angle", "pdf")
_SAME = {"lines": "sequence workers", "across": "samples", "brief": _all_and_fill}

RECORD = Benchmark(
    name="directions",
    summary="Time per direction against worst error: every map, sequence and count, beside NumPy's fill of the same array.",
    measure=measure,
    parts={"rows": DirectionSpeed},
    views=[
        TableView("rows", f"Maps, ns per direction; {_WORST}", "distribution", _map_cells, where=_is_map, brief=None),
        TableView("rows", "Sequences, million directions a second", cells="million_per_second", where=_is_sequence, **_SAME),
        TableView("rows", "The same as a share of a fill's speed right after", cells="of_fill", where=_is_sequence, **_SAME),
    ],
    pictures=[
        Picture("maps", "rows", "nanoseconds", y="worst_angle", series="distribution", where=_fastest_first, log="xy"),
        Picture("sequences", "rows", "samples", y="million_per_second", series="sequence", where=_all_and_fill, log="x"),
    ],
)
