"""`bench directions`: directions per second of every map and sequence, compared with filling the array by NumPy."""

import re
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Annotated, Any

import numpy as np
import typer
import warp as wp

from warpsample import distributions, sequences
from warpsample.bench.record import SEED, Benchmark, Picture, Repeats, RowsByPart, Track
from warpsample.bench.reporting.tables import TableView, select_all_workers
from warpsample.bench.rows import Spread, Timed, column
from warpsample.bench.running.timing import time_interleaved
from warpsample.directions.sample import sample_directions, sample_square
from warpsample.distributions.cosine_hemisphere import CosineHemisphere
from warpsample.distributions.record import Distribution
from warpsample.host.engine import check_workers

COUNTS = (1, 4, 16, 64, 256)
SAMPLES = 64
"""Samples per point in the table of maps."""
MAP_ONLY = "map only"
"""Replaces the sequence of a planar map, timed alone: `distribution.sample(u)` into a new array."""
FILL = ("fill", "", 1, False)

_BUDGET = 20.0  # seconds after which a group stops at three repeats


def shorten_distribution(distribution: str) -> str:
    """Return the `repr` of a distribution with its first parameter only, and without quotation marks."""
    return re.sub(r", .*\)", ")", distribution.replace("method=", "").replace("'", ""))


@dataclass(frozen=True)
class DirectionSpeed(Timed):
    """Row of `bench directions`: directions per second of one map or sequence.

    Maps use 64 independent samples; sequences use the polar cosine lobe.
    """

    table: str = column("table")
    distribution: str = column(
        "map", "fill: NumPy's `out.fill(0)` of the same array on one thread", show=shorten_distribution
    )
    sequence: str = column("sequence", show=lambda name: name or "fill")
    points: int = column("points")
    samples: int = column("n", "samples per point", show="n = {}".format)
    workers: int = column("workers", show=lambda n: f"{n} workers" if n > 1 else "1 worker")
    pdf: bool = column("pdf", show=lambda pdf: "with pdf" if pdf else "")
    million_per_second: Spread = column(
        "million per second", "for planar maps the time of the map alone, from existing points of the square"
    )
    of_fill: Spread = column("fraction of fill", "speed over that of a fill of the same array right after")


def measure(
    track: Track,
    *,
    points: Annotated[
        int,
        typer.Option(
            help="Number of points with 64 samples each. Other sample counts use the same number of directions.", min=1
        ),
    ] = 65_536,
    repeats: Repeats = 15,
) -> RowsByPart:
    """Time the sampling of 64 directions per point, for every distribution and for every sequence; return the rows."""
    chosen = list_groups(points)
    return {"rows": [row for group in track(chosen, len(chosen)) for row in measure_group(*group, repeats)]}


def list_maps() -> list[Distribution]:
    """Return the distributions to time: every method of CosineHemisphere, then one instance of each other distribution.

    Planar distributions come last.
    """
    all_cases = [distributions.get(name).cases() for name in distributions.names()]
    chosen = [
        case for cases in all_cases for case in (cases if cases[0] == CosineHemisphere() else [cases[len(cases) // 2]])
    ]
    return sorted(chosen, key=lambda case: (not isinstance(case, CosineHemisphere), -case.width))


def list_groups(points: int) -> list[tuple[str, int, int, list[Any]]]:
    """Return the groups of cases to time in alternation, as tuples (table, points, samples, cases).

    A case is (map, sequence, workers, with pdf).

    Args:
        points: points with 64 samples each; other counts have the same number of directions.
    """
    everyone = sorted({1, check_workers(None)})
    by_map = [
        ("maps", points, SAMPLES, [(case, "independent", w, p) for w in everyone for p in (False, True)]
         if case.width == 3 else [(case, MAP_ONLY, everyone[-1], False)])
        for case in list_maps()
    ]  # fmt: skip
    lobes = [(CosineHemisphere(), name, w, False) for name in sequences.names() for w in everyone]
    return [*by_map, *(("sequences", max(1, points * SAMPLES // count), count, lobes) for count in COUNTS)]


def measure_group(table: str, points: int, samples: int, cases: list[Any], repeats: int) -> list[DirectionSpeed]:
    """Time cases of sampling in alternation, with a fill of the array after each; return a row per case and fill."""
    normals = np.random.default_rng(SEED).normal(size=(points, 3)).astype(np.float32)
    out = np.zeros((points, samples, 3), np.float32)
    fill = partial(out.fill, 0.0)
    works = {}
    for case in (FILL, *cases):
        works[case] = fill if case == FILL else _build_work(normals, out, case)
        works["after", case] = fill
    seconds = time_interleaved(works, repeats, _BUDGET)
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


def _build_work(normals: np.ndarray, out: np.ndarray, row: tuple[Distribution, str, int, bool]) -> Callable[[], object]:
    case, sequence, workers, pdf = row
    if sequence == MAP_ONLY:
        u = sample_square("independent", *out.shape[:2])
        return partial(case.sample, wp.array(u, dtype=wp.vec2, device="cpu", copy=False))
    options = {"distribution": case, "sequence": sequence, "pdf": pdf, "out": out, "workers": workers}
    return partial(sample_directions, normals, out.shape[1], **options)


def _is_sequence(row: DirectionSpeed) -> bool:
    return row.table == "sequences"


def _select_for_page(rows: list[DirectionSpeed]) -> list[DirectionSpeed]:
    return [row for row in rows if _is_sequence(row) and (row in select_all_workers(rows) or not row.sequence)]


_MAPS = {"lines": "distribution", "across": "workers pdf", "page_rows": None, "where": lambda row: not _is_sequence(row)}
_SAME = {"lines": "sequence workers", "across": "samples", "page_rows": _select_for_page}

RECORD = Benchmark(
    name="directions",
    summary="Measure directions per second of every sequence and count, beside NumPy's fill of the same array.",
    measure=measure,
    parts={"rows": DirectionSpeed},
    views=[
        TableView("rows", "Maps, million directions per second", cells="million_per_second", **_MAPS),
        TableView(
            "rows", "Sequences, million directions per second", cells="million_per_second", where=_is_sequence, **_SAME
        ),
        TableView(
            "rows",
            "Speed of the sequences as a fraction of a fill",
            cells="of_fill",
            where=_is_sequence,
            **_SAME | {"page_rows": None},
        ),
    ],
    pictures=[
        Picture("directions", "rows", "samples", y="million_per_second", series="sequence", where=_select_for_page, log="x")
    ],
)
