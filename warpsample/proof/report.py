"""Tables of test results: one table for each test, and the table in the README of the distributions."""

import re
from collections.abc import Iterable
from dataclasses import fields
from typing import Any

from warpsample import distributions
from warpsample.distributions.record import Distribution
from warpsample.proof.verify import FAMILY_WISE, LAWS, LEVEL, Verdict

_SUMMARIES = {
    **{law.name: law.summary for law in LAWS},
    "hostile normals, lost": "points without directions; normals on and near axes, near −z, of −0.0, 1e-45 to 3e38 long",
    "hostile normals, unit length": "worst | |w| − 1 | of directions about these normals, in world coordinates",
    "hostile normals, direction": "worst angle in radians from the float64 directions about these normals",
    "hostile normals, density": "worst relative error of the density about these normals",
    "bad normals": "rows of invalid normals that are not zero with a status, and neighbouring rows that have changed",
    "points on their face": "distance of sampled points from their triangle's plane",
    "points on faces without area": "points on degenerate faces and slivers, or not finite",
    "shares of the area": "Kolmogorov-Smirnov test of the face index of 10⁶ points",
    "indices": "greatest difference from exact integers, in cells of 2⁻²⁴",
    "bits of seeds": "seeds that differ in one of 64 bits, follow each other, or are random: chi-square, bits changed",
    "bits of ids": "point ids that differ in one of 64 bits, follow each other, or are random: the same tests",
    "bits of samples": "samples of one point whose numbers differ in one of 31 bits: the same tests",
    "low bits of keys": "the lowest four bits of three words of keys, over points and streams: chi-square",
    "low bits of far samples": "the lowest three bits of samples 1,024 from each other: chi-square",
    "streams and purposes": "streams of a point that differ in one of 32 bits, and seeds of internal purposes",
    "correlation of dimensions": "u[0] against u[1]",
    "correlation of points": "neighbouring point ids, each dimension against each",
    "correlation of seeds": "neighbouring seeds at the same point and sample",
    "correlation of samples": "neighbouring samples of one point",
    "uniform": "Kolmogorov-Smirnov test of each coordinate over points",
    "repeats": "number of equal pairs among 64 · 10⁶ samples, against a Poisson distribution",
    "shared streams": "points among 10⁶ whose first two samples equal those of another point",
    "frozen stream": "1 if the stream has changed since it was recorded",
    "rays that leave a closed mesh": "rays that escape from just below its faces, in all directions, nearest or any hit",
    "rays between two faces": "rays that escape from a closed mesh when aimed at an edge or a vertex",
    "rays that hit their own face": "outward rays from surface points that hit the face they start on",
    "tracers that differ": "outward rays that hit something by only one of the wide tree and wp.Mesh",
    "route, cells": "chi-square of directions drawn by the method of the source, against our density",
    "route, angle": "Kolmogorov-Smirnov test of directions drawn by the method of the source, against our cdf",
    "route, azimuth": "Rayleigh's test of directions drawn by the method of the source, for a preferred azimuth",
    "one map, two routes": "greatest distance between two formulas of one map, on the same variates",
    "one density, two routes": "greatest relative difference of two formulas of one density",
}


def show_one(verdicts: list[Verdict], console: Any) -> None:
    """Print test results as one table, with a row for each test and distribution: the case closest to failing."""
    table = _make_table()
    for heading in ("test", "sampler", "cases", "worst", "limit"):
        table.add_column(heading, justify="left" if heading in ("test", "sampler") else "right")
    table.add_column("result")
    table.add_column("worst case", overflow="fold")
    for law in dict.fromkeys(v.law for v in verdicts):
        for group in _group_verdicts(v for v in verdicts if v.law == law):
            limit = "p ≥ " if group[0].statistical else "≤ "
            row = _format_row(group)
            table.add_row(law, *row[:3], f"{limit}{row[3]}", *row[4:])
    console.print(table)
    console.print(summarize(verdicts))


def show(verdicts: list[Verdict], console: Any) -> None:
    """Print test results on a rich Console, with a table for each test.

    A row is a distribution, with its case closest to failing, the limit and the verdict.
    """
    for law, summary in _SUMMARIES.items():
        table = _make_table()
        statistical = any(v.statistical for v in verdicts if v.law == law)
        figures = ("smallest p-value", "at least") if statistical else ("worst", "at most")
        for heading in ("sampler", "cases", *figures):
            table.add_column(heading, justify="left" if heading == "sampler" else "right")
        table.add_column("result")
        table.add_column("worst case", overflow="fold")
        for group in _group_verdicts(v for v in verdicts if v.law == law):
            table.add_row(*_format_row(group))
        if table.row_count:
            console.print(f"[bold]{law}[/]: {summary}")
            console.print(table)
    console.print(summarize(verdicts))


def summarize(verdicts: list[Verdict]) -> str:
    """Return sentences with the numbers of tests, of failed tests, and of statistical tests."""
    failed = sum(not v.passed for v in verdicts)
    statistics = sum(v.statistical for v in verdicts)
    counts = f"{len(verdicts):,} {'verdict' if len(verdicts) == 1 else 'verdicts'}, {failed} broken."
    if not statistics:
        return counts
    which = "1 is a statistical test that fails" if statistics == 1 else f"{statistics} are statistical tests that fail"
    chance = f"so a correct build fails by chance in at most {FAMILY_WISE:g} of all runs."
    return f"{counts} {which} below p = {LEVEL:g}, {chance}"


def _make_table(title: str | None = None) -> Any:
    """Return an empty rich table in the style of all tables of test results."""
    from rich import box
    from rich.table import Table

    return Table(title=title, title_justify="left", box=box.SIMPLE_HEAD)


def power_table(caught: dict[str, list[Verdict]]) -> Any:
    """Return a rich table with a row for each deliberately wrong sampler: the tests that reject it."""
    table = _make_table("Deliberately wrong samplers, and the tests that reject them")
    table.add_column("wrong sampler")
    table.add_column("rejected by")
    for name, verdicts in caught.items():
        broken = [v.law for v in verdicts if not v.passed]
        table.add_row(name, ", ".join(broken) or "[red]nothing[/]")
    return table


def markdown(verdicts: list[Verdict]) -> str:
    """Return the Markdown table of the README of the distributions: properties, worst errors over all cases, and limits."""
    measured = {law: _worst_by_name(verdicts, law) for law in ("unit length", "direction", "density", "round trip")}
    lines = [
        "| distribution | density | per | inverse | worst errors: length, direction, density, inverse | source |",
        "| --- | --- | --- | --- | --- | --- |",
    ]
    kinds = [distributions.get(name) for name in distributions.names()]
    for kind in kinds:
        errors = ", ".join(f"{by[kind.__name__]:.1e}" if kind.__name__ in by else "–" for by in measured.values())
        cells = (
            _format_signature(kind),
            kind.density,
            kind.measure.removeprefix("per "),
            _describe_inverse(kind),
            errors,
            kind.source,
        )
        lines.append(f"| {' | '.join(cells)} |")
    return "\n".join([*lines, "", *(f"- `{kind.__name__}`: {kind.limits}." for kind in kinds if kind.limits)])


def _format_signature(kind: type[Distribution]) -> str:
    """Return the constructor of a distribution with the names of its parameters, as Markdown."""
    return f"`{kind.__name__}({', '.join(field.name for field in fields(kind))})`"


def _describe_inverse(kind: type[Distribution]) -> str:
    """Return whether all, some or none of a distribution's cases have an inverse, as "yes", "in part" or "no"."""
    invertible = [case.maps.invert is not None for case in kind.cases()]
    return "yes" if all(invertible) else "in part" if any(invertible) else "no"


def _worst_by_name(verdicts: Iterable[Verdict], law: str) -> dict[str, float]:
    """Return the worst error that one test has measured, keyed by distribution."""
    worst: dict[str, float] = {}
    for v in verdicts:
        if v.law == law:
            worst[name_of(v)] = max(worst.get(name_of(v), 0.0), v.measured)
    return worst


def _group_verdicts(verdicts: Iterable[Verdict]) -> list[list[Verdict]]:
    """Group test results by distribution, with the case closest to failing first in each group."""
    groups: dict[str, list[Verdict]] = {}
    for v in verdicts:
        groups.setdefault(name_of(v), []).append(v)
    return [sorted(group, key=_distance_to_failure) for _, group in sorted(groups.items())]


def name_of(v: Verdict) -> str:
    """Return the name of the distribution that a test result is about, without parameters."""
    case = re.fullmatch(r"(\w+)\(.*\)", v.subject)
    return case[1] if case else v.subject


def _distance_to_failure(v: Verdict) -> float:
    """Return a sort key for test results that is smallest for the result closest to failing."""
    return v.measured if v.statistical else -v.measured / max(v.limit, 1e-300)


def _format_row(group: list[Verdict]) -> list[str]:
    """Return the texts of a table row that summarises a group of test results."""
    hardest = group[0]
    verdict = "[green]holds[/]" if all(v.passed for v in group) else "[red]BROKEN[/]"
    at = hardest.subject[len(name_of(hardest)) + 1 : -1] if len(group) > 1 and hardest.measured != 0.0 else ""
    return [
        name_of(hardest) if len(group) > 1 else hardest.subject.removesuffix("()"),
        str(len(group)),
        format_figure(hardest.measured),
        format_figure(hardest.limit),
        verdict,
        "; ".join(filter(None, (at, hardest.note))),
    ]


def format_figure(value: float) -> str:
    """Format a measured number for tables, with two digits."""
    return f"{value:.2g}" if value == 0.0 or 1e-3 <= value < 1e3 else f"{value:.1e}"
