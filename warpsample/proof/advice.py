"""What broken laws say of a distribution, in sentences: what is wrong, what is merely imprecise, and what to do."""

from collections.abc import Iterable, Iterator

from warpsample.proof.report import figure, name_of
from warpsample.proof.verify import LAWS, Verdict

_WRONG = 1e-2  # float32 loses digits, seldom all but two of them: what is further off has another formula
_ERRORS = {
    "unit length": "worst_unit_length",
    "direction": "worst_angle",
    "density": "worst_pdf",
    "round trip": "worst_round_trip",
}
_IMPRECISE = {*_ERRORS, "sine", "tails"}  # laws that lost digits alone may break
_TOGETHER = ("stretch", "mean stretch", "cells", "angle", "moments", "azimuth", "azimuth gap")


def advice(verdicts: Iterable[Verdict]) -> list[str]:
    """A sentence or two for each thing that is broken of each distribution; none for those whose laws hold."""
    names = {law.name for law in LAWS}
    broken: dict[str, dict[str, Verdict]] = {}
    for verdict in verdicts:
        if verdict.law in names and not verdict.passed:
            kept = broken.setdefault(name_of(verdict), {})
            kept[verdict.law] = max(kept.get(verdict.law, verdict), verdict, key=lambda v: v.measured)
    return [f"{name} {sentence}" for name, found in sorted(broken.items()) for sentence in _told(found)]


def _told(broken: dict[str, Verdict]) -> Iterator[str]:
    """What is said of one distribution, by its broken laws."""
    far = {law for law in ("direction", "density", "round trip") if law in broken and broken[law].measured > _WRONG}
    apart = [law for law in _TOGETHER if law in broken]
    if "finite" in broken:
        count = f"{broken['finite'].measured:,.0f}"
        yield f"gives NaN, an infinity or density 0 at {count} values of u: try u[0] = 0 and u[0] = 1 - 2^-24 first."
    if "outside" in broken:
        yield "has a density beyond its support, or at NaN: return 0 there, as wp.where(w[2] > 0.0, density, 0.0) does."
    if "density" in far or "mass" in broken:
        yield _of_density(broken, "direction" in far)
    elif "direction" in far:
        yield f"has a wrong map: up to {figure(broken['direction'].measured)} rad from its twin, whose density it has."
    elif apart:
        told = ", ".join(apart)
        yield f"has a map and a density that each agree with its twin, but not with each other ({told}): mend the twin, too."
    if "round trip" in far and "direction" not in far:
        yield f"has a wrong inverse: sample, then invert, ends up to {figure(broken['round trip'].measured)} from u."
    imprecise = [law for law in _ERRORS if law in broken and law not in far and broken[law].measured <= _WRONG]
    if imprecise and "direction" not in far:
        yield _of_digits(broken, imprecise, alone=set(broken) <= _IMPRECISE)


def _of_density(broken: dict[str, Verdict], map_too: bool) -> str:
    mass = f"; its integral is {figure(broken['mass'].measured)} from 1" if "mass" in broken else ""
    if "density" not in broken:
        return f"has a wrong density, and its twin the same one{mass}: mend the formula of both."
    off = f"up to {figure(broken['density'].measured)} of itself from its twin's{mass}"
    told = "wrong density, and a wrong map" if map_too else "wrong density; its map is the twin's"
    return f"has a {told}. The density is {off}. Mend this first: the statistics follow from it."


def _of_digits(broken: dict[str, Verdict], laws: list[str], alone: bool) -> str:
    """The advice on what float32 loses."""
    what = ", ".join(f"{law} {figure(broken[law].measured)} (at most {figure(broken[law].limit)})" for law in laws)
    said = ", ".join(f"{_ERRORS[law]} = {figure(2.0 * broken[law].measured)}" for law in laws)
    kept = f"If fewer are enough, say so in the class: {said}."
    if "sine" in broken:
        kept = "Its sine is lost near the pole, which nothing in the class can excuse: narrow lobes need it."
    return (
        f"is {'imprecise, not wrong' if alone else 'imprecise, too'}: {what}. Float32 loses digits in 1 - x, in "
        "sqrt(1 - z^2) and in wp.pow near 1; exp_double and log1p_double of warpsample.maths.exponentials keep them, as in "
        "power_cosine.py. "
        f"{kept}"
    )
