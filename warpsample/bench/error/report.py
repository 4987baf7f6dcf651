"""The tables of errors and times, and their picture."""

from math import log10
from typing import TYPE_CHECKING

from warpsample import sequences
from warpsample.bench.error.measuring import COMPARED_AT, FLOOR, Curve, Found, curves
from warpsample.bench.integrands import INTEGRANDS, Integrand
from warpsample.bench.report import Table, digits
from warpsample.bench.result import Result

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def tables(result: Result) -> list[Table | str]:
    """A table for each integrand, and one for all."""
    found, rmse = curves(result.found.points), result.settings.rmse
    parts = [
        _of_integrand(i, {s: curve for (name, s), curve in found.items() if name == i.name}, rmse) for i in _shown(found)
    ]
    note = (
        f"slope: of log RMSE over log N from 16 on, above float32's floor of {FLOOR:g}. ~: by that slope, beyond the N "
        f"measured. <: reached by the least N.\nefficiency: 1/(variance x time) at N = {COMPARED_AT:,} over that of "
        "independent; an RMSE below the floor counts as the floor."
    )
    return [
        "RMSE of means over the cosine lobe, and wall time of one estimate, all workers, sampling included.",
        *parts,
        _in_short(found, rmse),
        note,
    ]


def readme(result: Result) -> list[Table | str]:
    """The times to an RMSE, the shortest in bold."""
    found, rmse = curves(result.found.points), result.settings.rmse
    short = _in_short(found, rmse)
    cells = [[cell if cell != _bare(row, short) else f"**{cell}**" for cell in row[:-1]] for row in short.cells]
    return [
        (
            f"{len(cells)} integrals of known value over the cosine lobe; microseconds of one estimate to an RMSE of "
            f"{rmse:g}, sampling included (~: by the fitted slope, beyond the {max(p.count for p in result.found.points):,} "
            "samples measured):"
        ),
        Table("", ["", *short.headings[1:-1]], cells),
    ]


def draw(found: Found, caption: str) -> dict[str, "Figure"]:
    """RMSE against wall time in log-log, a plot to each integrand."""
    from matplotlib.figure import Figure  # noqa: PLC0415

    by_case = curves(found.points)
    shown = _shown(by_case)
    figure = Figure(figsize=(12.0, 6.5), layout="constrained")
    grid = figure.subplots(2, -(-len(shown) // 2), squeeze=False).ravel()
    for axes, integrand in zip(grid, shown, strict=False):
        for sequence, curve in ((s, curve) for (name, s), curve in by_case.items() if name == integrand.name):
            times, errors = zip(*((p.microseconds.median, p.rmse) for p in curve.points), strict=True)
            axes.loglog(times, errors, "o-", color=sequences.get(sequence).colour, markersize=4, linewidth=1, label=sequence)
        axes.set_title(f"{integrand.name} ({integrand.kind})", fontsize=11)
        axes.grid(alpha=0.3)
    for axes in grid[len(shown) :]:
        axes.axis("off")
    handles, labels = grid[0].get_legend_handles_labels()
    legend = {"handles": handles, "labels": labels, "frameon": False}
    grid[-1].legend(**legend, loc="center") if len(shown) < len(grid) else grid[0].legend(**legend)
    figure.supxlabel(f"wall time of one estimate [µs]\n{caption}", fontsize=10)
    figure.supylabel("RMSE", fontsize=10)
    return {"error": figure}


def _shown(found: dict[tuple[str, str], Curve]) -> list[Integrand]:
    names = {name for name, _ in found}
    return [integrand for integrand in INTEGRANDS if integrand.name in names]


def _of_integrand(integrand: Integrand, mine: dict[str, Curve], rmse: float) -> Table:
    counts = [p.count for p in next(iter(mine.values())).points if round(log10(p.count) / log10(4)) % 2 == 0]
    plain = mine["independent"].efficiency
    cells = [
        [
            sequence,
            *(f"{p.rmse:.1e}" for p in curve.points if p.count in counts),
            "–" if curve.slope is None else f"{curve.slope:.2f}",
            *(digits(p.microseconds.median) for p in curve.points if p.count == counts[-1]),
            _time_to(curve, rmse),
            digits(curve.efficiency / plain),
        ]
        for sequence, curve in mine.items()
    ]
    ends = ["slope", f"µs at {counts[-1]:,}", f"µs to {rmse:g}", "efficiency"]
    title = f"{integrand.name} ({integrand.kind}), mean {integrand.mean:.6f}"
    return Table(title, ["sequence", *(f"N = {n:,}" for n in counts), *ends], cells)


def _in_short(found: dict[tuple[str, str], Curve], rmse: float) -> Table:
    names = list(dict.fromkeys(sequence for _, sequence in found))
    cells = []
    for integrand in _shown(found):
        mine = {sequence: found[integrand.name, sequence] for sequence in names}
        times = {sequence: reached[0] for sequence, curve in mine.items() if (reached := curve.reaching(rmse))}
        best = min(times, key=times.__getitem__) if times else "–"
        cells.append([integrand.name, *(_time_to(curve, rmse) for curve in mine.values()), best])
    return Table(f"In short: µs to an RMSE of {rmse:g}", ["integrand", *names, "fastest"], cells)


def _bare(row: list[str], short: Table) -> str | None:
    """The cell of the fastest sequence."""
    return row[list(short.headings).index(row[-1])] if row[-1] in short.headings else None


def _time_to(curve: Curve, rmse: float) -> str:
    reached = curve.reaching(rmse)
    if reached is None:
        return "never"
    microseconds, beyond = reached
    sign = "" if not beyond else "<" if rmse > curve.points[0].rmse else "~"
    return f"{sign}{digits(microseconds)}"
