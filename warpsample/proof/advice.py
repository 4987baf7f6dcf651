"""Advice for users whose sampler fails tests: which function is wrong or imprecise, and how to mend it."""

from collections.abc import Iterable, Iterator

import numpy as np

from warpsample.proof.diagnosis import WRONG, Conflict, find_conflicts, find_smallest_sets
from warpsample.proof.evidence import Subject
from warpsample.proof.opinions import DENSITIES, MAPS
from warpsample.proof.report import format_figure, name_of
from warpsample.proof.verify import LAWS, Verdict
from warpsample.statistics.charts import DISK, SPHERE, chart_of, support_of

_ERRORS = {
    "unit length": "worst_unit_length",
    "direction": "worst_angle",
    "density": "worst_pdf",
    "round trip": "worst_round_trip",
}
_IMPRECISE = {*_ERRORS, "sine", "tails"}  # laws that may be broken by rounding errors alone
_MOST_CASES = 3  # of one distribution: more cases seldom add evidence
_MOST_TEXTS = 3
_MEND = {
    "map": "`sample`, the first function of Maps",
    "density": "`pdf`, the second function of Maps",
    "inverse": "`invert`, the third function of Maps",
    "cdf": "`_cdf`",
    "support": "`largest_angle`, the greatest angle to +z in radians, or in a disk the radius: override it in the class",
    "twin's map": "the first function of twin=(directions, density)",
    "twin's density": "the second function of twin=(directions, density)",
}
_JUDGED = {
    "density": {*DENSITIES},
    "round trip": {"inverse"},
}  # parts by law: if one of these is wrong, advice on its precision is useless


def advise(verdicts: Iterable[Verdict], subjects: Iterable[Subject] = ()) -> list[str]:
    """Return sentences of advice on each distribution that fails a test.

    Args:
        verdicts: verdicts of any laws.
        subjects: lobes and twins that were judged; those with broken laws are searched for the wrong part.
    """
    names = {law.name for law in LAWS}
    broken: dict[str, list[Verdict]] = {}
    for verdict in verdicts:
        if verdict.law in names and not verdict.passed:
            broken.setdefault(name_of(verdict), []).append(verdict)
    known = {subject.name: subject for subject in subjects}
    return [f"{name} {text}" for name, found in sorted(broken.items()) for text in _advise_one(found, known)]


def _advise_one(verdicts: list[Verdict], known: dict[str, Subject]) -> Iterator[str]:
    """Yield sentences of advice on one distribution that fails tests, without its name at the beginning."""
    worst = {v.law: v for v in sorted(verdicts, key=lambda v: v.measured)}
    imprecise = [law for law in _ERRORS if law in worst and worst[law].measured <= WRONG]
    only_digits = not worst.keys() - _IMPRECISE and not _large_errors(worst)
    names = list(dict.fromkeys(v.subject for v in verdicts if v.subject in known))[:_MOST_CASES]
    conflicts = [] if only_digits else [conflict for name in names for conflict in find_conflicts(known[name])]
    sets = find_smallest_sets(conflicts) if conflicts else []
    suspects = frozenset().union(*sets)
    if "finite" in worst and not suspects & {*MAPS, "support"}:
        count = f"{worst['finite'].measured:,.0f}"
        yield f"gives NaN, an infinity or density 0 at {count} values of u: try u[0] = 0 and u[0] = 1 - 2^-24 first."
    if "outside" in worst and "support" not in suspects:
        yield _describe_outside(known.get(worst["outside"].subject))
    if sets:
        yield _name_parts(sets, conflicts) if len(sets) == 1 else _list_choices(sets, conflicts, known[names[0]])
    elif not worst.keys() & {"finite", "outside"} and not only_digits:
        yield _describe_unexplained(worst)
    imprecise = [law for law in imprecise if not suspects & _JUDGED.get(law, set())]
    if imprecise and "direction" not in _large_errors(worst) and "support" not in suspects:
        yield _describe_digits(worst, imprecise, alone=only_digits)


def _describe_outside(subject: Subject | None) -> str:
    """Return a sentence of advice on a density that is not 0 outside the declared support."""
    if subject is None:
        return "has a density beyond its support, or at NaN: return 0 there."
    chart, (_, end) = chart_of(subject.sampler), support_of(subject.sampler)
    if chart is not DISK and end >= chart.high:
        return "has a density above 0 at NaN: return 0 there, as wp.where(wp.dot(w, w) > 0.0, density, 0.0) does."
    up, least = "w[2]" if chart is SPHERE else "w[1]", float(np.cos(end))
    inside = f"{up} > 0.0" if abs(least) < 1e-9 else f"{up} >= {least:.6g}"
    inside = f"wp.length(w) <= {end:.6g}" if chart is DISK else inside
    return f"has a density beyond its support, or at NaN: return 0 there, as wp.where({inside}, density, 0.0) does."


def _large_errors(worst: dict[str, Verdict]) -> set[str]:
    """Return the tests whose measured error is too large to be a rounding error."""
    return {law for law in _ERRORS if law in worst and worst[law].measured > WRONG}


def _name_parts(sets: list[frozenset[str]], conflicts: list[Conflict]) -> str:
    """Return a sentence that names the functions that must be wrong, because they explain every conflict."""
    parts = _in_order(sets[0])
    same = len(parts) == 2 and set(parts) in ({*MAPS}, {*DENSITIES}) and all(c.parts != sets[0] for c in conflicts)
    error = f" The two agree: both have the same error, and {parts[0]} and twin must be mended." if same else ""
    mend = "; ".join(_MEND[part] for part in parts)
    return f"has a wrong {' and a wrong '.join(parts)}: {_evidence(conflicts)}.{error} The other parts agree. Mend {mend}."


def _list_choices(sets: list[frozenset[str]], conflicts: list[Conflict], subject: Subject) -> str:
    """Return sentences that list the parts that may be wrong, where the conflicts do not decide, and a way to decide."""
    choices = ", or ".join(f"the {' and the '.join(_in_order(parts))}" for parts in sets)
    more = [] if subject.sampler.symmetric else ["`_cdf` with symmetric = True, if the density depends on the angle alone"]
    more += [] if subject.sampler.maps.invert is not None else ["`invert`"]
    check = f" Another part is a further check: {', or '.join(more)}." if more else ""
    return (
        f"has parts that contradict each other: {_evidence(conflicts)}.{_BETWEEN.get(frozenset(sets), '')} Either of these "
        f"is wrong: {choices}. The checks cannot decide which: compare the values with those of the lobe that you mean."
        f"{check}"
    )


_BETWEEN = {
    frozenset({frozenset(MAPS), frozenset(DENSITIES)}): " The maps belong to another lobe than the densities.",
    frozenset({frozenset({"map", "density"}), frozenset({"twin's map", "twin's density"})}): (
        " The class and its twin describe different lobes."
    ),
}


def _in_order(parts: Iterable[str]) -> list[str]:
    """Sort parts of a sampler (map, density, inverse, ...) by the order in which a user should mend them."""
    return [part for part in _MEND if part in parts]


def _evidence(conflicts: list[Conflict]) -> str:
    """Return one text with the first failed check of each group of parts."""
    texts: dict[frozenset[str], str] = {}
    for conflict in conflicts:
        texts.setdefault(conflict.parts, conflict.text)
    return "; ".join([*texts.values()][:_MOST_TEXTS])


def _describe_unexplained(worst: dict[str, Verdict]) -> str:
    """Return a sentence on failed tests that no wrong part of the sampler explains."""
    laws = ", ".join(worst)
    return (
        f"breaks {laws}, while all parts agree to {WRONG:g} at 2^18 values of u: the error is small or rare. Look at the "
        "ends of u[0] and u[1] and at the ends of the support first."
    )


def _describe_digits(worst: dict[str, Verdict], laws: list[str], *, alone: bool) -> str:
    """Return sentences on lost digits of float32, with ways to keep or to excuse the digits."""
    what = ", ".join(
        f"{law} {format_figure(worst[law].measured)} (at most {format_figure(worst[law].limit)})" for law in laws
    )
    fields = ", ".join(f"{_ERRORS[law]} = {format_figure(2.0 * worst[law].measured)}" for law in laws)
    last = f"If fewer digits are enough, state the limits in the class: {fields}."
    if "sine" in worst:
        last = "Its sine loses digits near the pole. No attribute of the class can excuse this: narrow lobes need the sine."
    return (
        f"is {'imprecise, not wrong' if alone else 'imprecise, too'}: {what}. Float32 loses digits in 1 - x, in "
        "sqrt(1 - z^2) and in wp.pow near 1; exp_double and log1p_double of warpsample.maths.exponentials keep them, as in "
        "power_cosine.py. "
        f"{last}"
    )
