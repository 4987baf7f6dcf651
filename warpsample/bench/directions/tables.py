"""The tables of maps and sequences."""

from warpsample.bench.directions import measuring
from warpsample.bench.directions.measuring import Speed
from warpsample.bench.report import SPREAD, Table, figure, spread
from warpsample.bench.result import Result
from warpsample.bench.timing import Spread


def tables(result: Result) -> list[Table | str]:
    """Maps and sequences."""
    rows = result.found.rows
    return [
        f"`sample_directions` writes into an existing (P, n, 3) float32 array: {SPREAD}.",
        *_maps([row for row in rows if row.table == "maps"]),
        *_sequences([row for row in rows if row.table == "sequences"]),
    ]


def readme(result: Result) -> list[Table | str]:
    """The sequences by all workers."""
    rows = [row for row in result.found.rows if row.table == "sequences"]
    workers = max(row.workers for row in rows)
    counts = list(dict.fromkeys(row.samples for row in rows))
    found = {(row.sequence, row.samples): row for row in rows if row.workers == workers or not row.sequence}
    cells = [
        [name, *(f"{figure(found[name, n].million_per_second.median)}, {spread(found[name, n].of_fill)}" for n in counts)]
        for name in dict.fromkeys(row.sequence for row in rows if row.sequence)
    ]
    fill = ["NumPy's fill, 1 thread", *(figure(found["", n].million_per_second.median) for n in counts)]
    return [
        (
            f"Million directions a second into an existing (P, n, 3) float32 array, {rows[0].points * rows[0].samples:,} of "
            f"them, {workers} workers; and the share of the speed of NumPy's `out.fill(0)` on the same array:"
        ),
        Table("", ["", f"n = {counts[0]}", *map(str, counts[1:])], [*cells, fill]),
    ]


def short_name(row: Speed) -> str:
    """The distribution as Python writes it, without the names of strings and what follows the first parameter."""
    return measuring.short_name(row.distribution) + (" *" if row.sequence == measuring.GIVEN else "")


def _maps(rows: list[Speed]) -> list[Table | str]:
    samplers = [row for row in rows if row.distribution != "fill"]
    everyone = max(row.workers for row in samplers)
    cells = []
    for name in dict.fromkeys(row.distribution for row in samplers):
        by_case = {(row.workers, row.pdf): row for row in samplers if row.distribution == name}
        best = by_case[everyone, False]
        alone, with_pdf = (by_case.get(case) for case in ((1, False), (everyone, True)))
        cells.append(
            [
                short_name(best),
                figure(alone and alone.nanoseconds.median),
                spread(best.nanoseconds),
                figure(with_pdf and with_pdf.nanoseconds.median),
                spread(best.of_fill),
                *(f"{best.worst[law]:.1e}" if law in best.worst else "–" for law in ("length", "angle", "pdf")),
            ]
        )
    title = f"Maps: ns per direction, {rows[0].points:,} points x {measuring.SAMPLES}, independent"
    workers = "all workers" if everyone > 1 else "1 worker"
    headings = ["map", "1 worker", workers, "with pdf", "share of fill", "length", "angle", "pdf"]
    fills = [row.nanoseconds.median for row in rows if row.distribution == "fill"]
    notes = [
        "length, angle, pdf: the worst errors against float64 (unit length; radians; relative), frame included",
        *(["*: the map alone, u given, into a new array"] if any(row.sequence == measuring.GIVEN for row in rows) else []),
        f"ceiling: NumPy's out.fill(0) of the same array, 1 thread: {spread(Spread.of(fills))} ns per direction",
    ]
    return [Table(title, headings, cells), "\n".join(notes)]


def _sequences(rows: list[Speed]) -> list[Table]:
    counts = list(dict.fromkeys(row.samples for row in rows))
    cases = list(dict.fromkeys((row.sequence, row.workers) for row in rows if row.sequence))
    found = {(row.sequence, row.workers, row.samples): row for row in rows}
    total = f"{rows[-1].points * rows[-1].samples:,} directions, cosine lobe, polar"
    headings = ["sequence", "workers", *(f"n = {n}" for n in counts)]
    speeds = [[s, str(w), *(spread(found[s, w, n].million_per_second) for n in counts)] for s, w in cases]
    shares = [[s, str(w), *(spread(found[s, w, n].of_fill) for n in counts)] for s, w in cases]
    fill = ["ceiling (fill)", "1", *(figure(found["", 1, n].million_per_second.median) for n in counts)]
    title = f"Sequences: million directions a second by samples per point, {total}"
    return [
        Table(title, headings, [*speeds, fill]),
        Table("The same as a share of the fill's speed right after", headings, shares),
    ]
