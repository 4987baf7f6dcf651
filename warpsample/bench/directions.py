"""`bench directions`: directions a second by every map and sequence into an existing array, beside NumPy's fill of it."""

import re
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Annotated, Any

import numpy as np
import typer
import warp as wp

from warpsample import distributions, sequences
from warpsample.bench.record import SEED, Benchmark, Found, Picture, Repeats, Track
from warpsample.bench.rows import Spread, Timed, column
from warpsample.bench.running.timing import timed
from warpsample.bench.tables import TableView, all_workers
from warpsample.directions.sample import sample_directions, sample_square
from warpsample.distributions.cosine_hemisphere import CosineHemisphere
from warpsample.distributions.record import Distribution
from warpsample.host.engine import check_workers

COUNTS = (1, 4, 16, 64, 256)
SAMPLES = 64
"""Samples of a point in the table of maps."""
GIVEN = "given"
"""In place of a sequence: the map alone, `distribution.sample(u)` into a new array, for what lies in a plane."""
FILL = ("fill", "", 1, False)

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
    million_per_second: Spread = column("million a second", "of what lies in a plane by the map alone, u given")
    of_fill: Spread = column("share of fill", "its speed over that of a fill right after it")


def measure(
    track: Track,
    *,
    points: Annotated[int, typer.Option(help="Points, with 64 samples each, or as many directions.", min=1)] = 65_536,
    repeats: Repeats = 15,
) -> Found:
    """Every map at 64 samples, and every sequence with the cosine lobe."""
    chosen = groups(points)
    return {"rows": [row for group in track(chosen, len(chosen)) for row in measure_group(*group, repeats)]}


def maps() -> list[Distribution]:
    """The cosine lobe by every method, then an ordinary case of every other distribution, those in a plane last."""
    all_cases = [distributions.get(name).cases() for name in distributions.names()]
    chosen = [
        case for cases in all_cases for case in (cases if cases[0] == CosineHemisphere() else [cases[len(cases) // 2]])
    ]
    return sorted(chosen, key=lambda case: (not isinstance(case, CosineHemisphere), -case.width))


def groups(points: int) -> list[tuple[str, int, int, list[Any]]]:
    """(table, points, samples, cases) of what takes turns; a case is a map, a sequence, workers, and whether with the pdf.

    Args:
        points: with 64 samples each; with other counts as many as give the same number of directions.
    """
    everyone = sorted({1, check_workers(None)})
    by_map = [
        ("maps", points, SAMPLES, [(case, "independent", w, p) for w in everyone for p in (False, True)]
         if case.width == 3 else [(case, GIVEN, everyone[-1], False)])
        for case in maps()
    ]  # fmt: skip
    lobes = [(CosineHemisphere(), name, w, False) for name in sequences.names() for w in everyone]
    return [*by_map, *(("sequences", max(1, points * SAMPLES // count), count, lobes) for count in COUNTS)]


def measure_group(table: str, points: int, samples: int, cases: list[Any], repeats: int) -> list[DirectionSpeed]:
    """The rows of what takes turns, a fill among it and after each."""
    normals = np.random.default_rng(SEED).normal(size=(points, 3)).astype(np.float32)
    out = np.zeros((points, samples, 3), np.float32)
    fill = partial(out.fill, 0.0)
    works = {}
    for case in (FILL, *cases):
        works[case] = fill if case == FILL else _work(normals, out, case)
        works["after", case] = fill
    seconds = timed(works, repeats, _BUDGET)
    return [
        DirectionSpeed(
            table=table,
            distribution=str(case[0]),
            sequence=case[1],
            points=points,
            samples=samples,
            workers=case[2],
            pdf=case[3],
            million_per_second=Spread.of([points * samples / t / 1e6 for t in seconds[case]]),
            of_fill=Spread.of_ratios(seconds["after", case], seconds[case]),
            seconds=seconds[case],
        )
        for case in (FILL, *cases)
    ]


def _work(normals: np.ndarray, out: np.ndarray, row: tuple[Distribution, str, int, bool]) -> Callable[[], object]:
    case, sequence, workers, pdf = row
    if sequence == GIVEN:
        u = sample_square("independent", *out.shape[:2])
        return partial(case.sample, wp.array(u, dtype=wp.vec2, device="cpu", copy=False))
    given = {"distribution": case, "sequence": sequence, "pdf": pdf, "out": out, "workers": workers}
    return partial(sample_directions, normals, out.shape[1], **given)


def _is_sequence(row: DirectionSpeed) -> bool:
    return row.table == "sequences"


def _all_and_fill(rows: list[DirectionSpeed]) -> list[DirectionSpeed]:
    return [row for row in rows if _is_sequence(row) and (row in all_workers(rows) or not row.sequence)]


_MAPS = {"lines": "distribution", "across": "workers pdf", "brief": None, "where": lambda row: not _is_sequence(row)}
_SAME = {"lines": "sequence workers", "across": "samples", "brief": _all_and_fill}

RECORD = Benchmark(
    name="directions",
    summary="Directions a second by every map, sequence and count, beside NumPy's fill of the same array.",
    measure=measure,
    parts={"rows": DirectionSpeed},
    views=[
        TableView("rows", "Maps, million directions a second", cells="million_per_second", **_MAPS),
        TableView("rows", "Sequences, million directions a second", cells="million_per_second", where=_is_sequence, **_SAME),
        TableView("rows", "The same as a share of a fill's speed right after", cells="of_fill", where=_is_sequence, **_SAME),
    ],
    pictures=[
        Picture("directions", "rows", "samples", y="million_per_second", series="sequence", where=_all_and_fill, log="x")
    ],
)
