"""Search for the wrong function of a sampler, by comparing its functions with each other and with a second implementation.

Six parts describe one lobe: the map, the density, the inverse and the cdf of the class, and the two functions of the twin.
A seventh part, the declared support, limits all others. Each check compares two parts, or one part with a property of every
lobe. A check that fails is a `Conflict`: at least one of its parts is wrong.
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from warpsample.proof import laws
from warpsample.proof.evidence import Subject
from warpsample.proof.opinions import DENSITIES, MAPS, MARGIN, STEP, Opinions
from warpsample.proof.report import format_figure
from warpsample.proof.verify import LEVEL
from warpsample.statistics.charts import DISK

PARTS = ("map", "density", "inverse", "cdf", "support", "twin's map", "twin's density")
WRONG = 1e-2  # float32 seldom loses all but two digits: a greater error comes from a wrong formula
_SHARE = 1e-3  # fraction of the variates: a smaller fraction of invalid values is a forgotten edge case
_MASS = 1e-4  # the limit of the law "mass"
_CDF = 1e-3  # quadrature converges to 5e-5
_MANY = 1000  # least number of directions in the support for a meaningful test


@dataclass(frozen=True)
class Conflict:
    """Failed check of a sampler: a set of functions, at least one of them wrong, and the result in words.

    Attributes:
        parts: parts of which at least one is wrong.
        text: result of the check in words.
    """

    parts: frozenset[str]
    text: str


def find_smallest_sets(conflicts: Iterable[Conflict]) -> list[frozenset[str]]:
    """Return the smallest sets of parts that explain all failed checks; several sets if the checks leave a choice."""
    wanted = {conflict.parts for conflict in conflicts}
    for size in range(len(PARTS) + 1):
        sets = [frozenset(parts) for parts in combinations(PARTS, size) if all(some & {*parts} for some in wanted)]
        if sets:
            return sets
    return []


def find_conflicts(subject: Subject) -> list[Conflict]:
    """Compare the functions of a sampler and of its second implementation with each other; return the failed checks."""
    o = Opinions(subject)
    with np.errstate(all="ignore"):
        early = [Conflict(frozenset(parts), text) for parts, text in _check_support(o)]
    if early:  # all other checks rely on the declared support
        return early
    checks = (
        _check_maps,
        _check_densities,
        _compare_maps,
        _compare_densities,
        _compare_samples,
        _check_inverse,
        _check_cdf,
        _check_polar,
    )
    with np.errstate(all="ignore"):
        return [Conflict(frozenset(parts), text) for check in checks for parts, text in check(o)]


Conflicts = Iterator[tuple[set[str], str]]


def _check_support(o: Opinions) -> Conflicts:
    """Yield a failed check of the declared support if both maps and the density agree on another support."""
    beyond = [o.directions_outside(part) for part in MAPS]
    if all(len(w) and (o.density("density", w) > 0.0).mean() > 0.5 for w in beyond):
        yield {"support"}, f"both maps leave it, {_describe_reach(o, 'map')}, and the density is above 0 there"
        return
    reach = [o.greatest_angle(part) for part in MAPS]
    near = o.chart.point(max(reach) * np.linspace(1.01, 1.1, 10)[:, None], np.linspace(0.0, 1.0, 16))
    alike = abs(reach[0] - reach[1]) <= WRONG * o.high and max(reach) < 0.9 * o.high
    if alike and not (o.density("density", near) > 0.0).any():
        yield {"support"}, f"both maps end before it, {_describe_reach(o, 'map')}, and the density is 0 beyond"


def _describe_reach(o: Opinions, part: str) -> str:
    """Describe the largest angle of the directions of one map, and the largest angle that the sampler declares."""
    return f"at {_format_angle(o, o.greatest_angle(part))}, while `largest_angle` is {_format_angle(o, o.high)}"


def _check_maps(o: Opinions) -> Conflicts:
    """Yield a failed check of each map with directions that are invalid, not of unit length, or outside the support."""
    for part in MAPS:
        w = o.at_u[part]
        length = np.abs(np.linalg.norm(w, axis=-1) - 1.0) if o.chart is not DISK else np.abs(w).sum(axis=-1) * 0.0
        invalid = (~(length <= WRONG)).mean()
        if invalid > _SHARE:
            yield {part}, f"the {part} gives NaN or another length than 1 for {_format_percent(invalid)} of u"
        outside = len(o.directions_outside(part)) / len(w)
        if outside:
            yield {part}, f"the {part} leaves the support, {_describe_reach(o, part)}, for {_format_percent(outside)} of u"


def _check_densities(o: Opinions) -> Conflicts:
    """Yield a failed check of each density that has invalid values or does not integrate to 1."""
    w = np.concatenate(list(o.draws.values()))[::16]
    for part in DENSITIES:
        pdf, masses = o.density(part, w), o.masses[part]
        invalid = (~(pdf >= 0.0) | np.isinf(pdf)).mean() if len(w) else 0.0
        if invalid > _SHARE:
            yield {part}, f"the {part} is NaN, infinite or below 0 at {_format_percent(invalid)} of the sampled directions"
        elif masses is None:
            yield {part}, f"the integral of the {part} does not converge: it jumps, or oscillates"
        elif not abs(masses.sum() - 1.0) <= _MASS:
            yield {part}, f"the {part} integrates to {_format_value(masses.sum())} over the support"


def _compare_maps(o: Opinions) -> Conflicts:
    """Yield a failed check of the two maps if their directions differ."""
    w, twin = (o.at_u[part] for part in MAPS)
    apart = np.linalg.norm(w - twin, axis=-1)
    if np.nanmax(apart, initial=0.0) > WRONG:
        at = _first_worst(apart)
        there = (
            f"at u = {_format_vector(o.u[at])} the map gives {_format_vector(w[at])}, its twin {_format_vector(twin[at])}"
        )
        yield {*MAPS}, f"the map and its twin differ by up to {format_figure(apart[at])}: {there}"


def _compare_densities(o: Opinions) -> Conflicts:
    """Yield a failed check of the two densities if their values differ."""
    for part in MAPS:
        w = o.at_u[part]
        kept = o.is_inside(w, -1e-4)
        u, w = o.u[kept], w[kept]
        pdf, twin = (o.density(density, w) for density in DENSITIES)
        apart = np.nan_to_num(np.abs(pdf - twin) / np.maximum(np.abs(pdf), np.abs(twin)))
        if apart.max(initial=0.0) > WRONG:
            at = _first_worst(apart)
            text = f"the density and its twin differ by up to {_format_percent(apart[at])}: at w = {_format_vector(w[at])} "
            yield {*DENSITIES}, f"{text}the density is {_format_value(pdf[at])}, its twin {_format_value(twin[at])}"
            if part == "twin's map":
                near = (apart > 0.5 * apart.max()) & (u > 4.0 * STEP).all(axis=-1) & (u < 1.0 - 4.0 * STEP).all(axis=-1)
                yield from _compare_stretch(o, u[near], pdf[near], twin[near])


def _compare_stretch(o: Opinions, u: np.ndarray, *densities: np.ndarray) -> Conflicts:
    """Yield a failed check if one density, but not the other, contradicts how the reference map stretches areas."""
    if len(u) == 0:
        return
    stretch = o.stretch("twin's map", u)
    differ = 0.2 * np.abs(densities[0] - densities[1]) * stretch
    fits = [np.median(np.abs(pdf * stretch - 1.0) - differ) < 0.0 for pdf in densities]
    if fits[0] != fits[1]:
        wrong, right = DENSITIES if fits[1] else DENSITIES[::-1]
        yield (
            {"twin's map", wrong},
            f"the twin's map stretches areas by 1 / ({right}), not by 1 / ({wrong}), where the densities differ",
        )


def _compare_samples(o: Opinions) -> Conflicts:
    """Yield a failed check of each pair of map and density if the map's directions do not follow the density."""
    for density in DENSITIES:
        masses = o.masses[density]
        if masses is None or not masses.sum() > 0.0:
            continue
        law = o.sampler_in_support(density, masses.sum())
        edges = np.unique([o.chart.low, *o.edges, o.chart.high])
        for part in MAPS:
            if len(o.draws[part]) >= _MANY and not _cells_p_value(law, o.draws[part], edges) >= LEVEL:
                yield (
                    {part, density},
                    f"directions of the {part} are not distributed as the {density}{_describe_means(o, part, density)}",
                )


def _describe_means(o: Opinions, *parts: str) -> str:
    """Describe the mean angles under two functions of a sampler; return "" if the means agree."""
    means = [o.mean_angle(part) for part in parts]
    if None in means or abs(means[0] - means[1]) < WRONG * (o.high - o.low):
        return ""
    return f" (mean {_format_angle(o, means[0])} of the {parts[0]}, {_format_angle(o, means[1])} of the {parts[1]})"


def _cells_p_value(law: laws.Sampler, w: np.ndarray, edges: np.ndarray) -> float:
    """Return the p-value of the chi-square test of directions against a density; 1 if the density's integral diverges."""
    try:
        return laws.cells_p_value(law, w, edges)
    except ValueError:
        return 1.0  # a density with a divergent integral is a separate conflict


def _check_inverse(o: Opinions) -> Conflicts:
    """Yield a failed check of the inverse and each map that the inverse does not undo."""
    if o.sampler.maps.invert is None:
        return
    for part in MAPS:
        w = o.at_u[part]
        kept = o.is_inside(w, MARGIN)
        back = np.asarray(o.sampler.invert(w[kept].astype(np.float32)))[:, : o.sampler.variates].astype(np.float64)
        apart = back - o.u[kept][:, : o.sampler.variates]
        apart = np.abs(apart - np.round(apart)).max(axis=-1, initial=0.0)
        apart[np.isnan(apart)] = np.inf
        if apart.max(initial=0.0) > WRONG:
            at = _first_worst(apart)
            there = f"{_format_vector(o.u[kept][at])} and returns to {_format_vector(back[at])}"
            yield {part, "inverse"}, f"the inverse does not undo the {part}: it starts from u = {there}"


def _check_cdf(o: Opinions) -> Conflicts:
    """Yield a failed check of the cdf, alone or together with each map or density that contradicts it."""
    if not o.sampler.symmetric:
        return
    cdf = np.asarray(o.sampler.cdf(o.edges), np.float64)
    ends = f"the cdf is {_format_value(cdf[0])} at the start and {_format_value(cdf[-1])} at the end of the support"
    if not (np.abs(cdf[[0, -1]] - [0.0, 1.0]).max() <= _CDF and (np.diff(cdf) >= -_CDF).all()):
        yield {"cdf"}, ends
    for part in MAPS:
        if len(o.draws[part]) >= _MANY and not laws.angles_p_value(o.sampler, o.chart.polar(o.draws[part])) >= LEVEL:
            yield {part, "cdf"}, f"angles of the {part} are not distributed as the cdf"
    for part in DENSITIES:
        masses = o.masses[part]
        if masses is not None:
            apart = np.abs(masses.sum(axis=1).cumsum() - (cdf[1:] - cdf[0]))
            if not apart.max() <= _CDF:
                at = int(np.nan_to_num(apart, nan=np.inf).argmax())
                mass, value = _format_value(masses[: at + 1].sum()), _format_value(cdf[at + 1])
                end = _format_angle(o, o.edges[at + 1])
                yield {part, "cdf"}, f"up to {end} the {part} integrates to {mass}, the cdf is {value}"


def _check_polar(o: Opinions) -> Conflicts:
    """Yield a failed check of the map that contradicts the declaration `polar`, if the other map agrees.

    With `polar`, u[0] is the cdf and u[1] the azimuth divided by 2 pi.
    """
    if not (o.sampler.symmetric and o.sampler.polar):
        return
    keeps = [_is_polar(o, o.at_u[part]) for part in MAPS]
    if keeps[0] != keeps[1]:
        wrong = MAPS[keeps[0]]
        yield (
            {wrong},
            f"`polar` is declared, but the {wrong} does not use u[0] as the cdf and u[1] as the azimuth divided by 2 pi",
        )


def _is_polar(o: Opinions, w: np.ndarray) -> bool:
    """Return whether directions w at `u` have u[0] as the cdf and u[1] as the azimuth divided by 2 pi."""
    both = [np.asarray(o.sampler.cdf(o.chart.polar(w)), np.float64)]
    both += [o.chart.azimuth(w)] if o.chart.azimuths > 1.0 else []
    apart = np.stack(both, axis=-1) - o.u[:, : len(both)]
    return bool(np.abs(apart - np.round(apart)).max(initial=0.0) <= WRONG)


def _first_worst(apart: np.ndarray) -> int:
    """Return the index of the first error that is at least 99 % of the greatest, so that all processors agree."""
    return int(np.argmax(apart >= 0.99 * np.nanmax(apart)))


def _format_percent(share: float) -> str:
    """Format a fraction as a percentage."""
    return f"{100.0 * share:.3g} %"


def _format_value(number: float) -> str:
    """Format a number with four digits."""
    return f"{number:.4g}"


def _format_vector(values: np.ndarray) -> str:
    """Format a vector with three digits per component."""
    return f"({', '.join(f'{value:.3g}' for value in values)})"


def _format_angle(o: Opinions, a: float) -> str:
    """Format a polar coordinate: as a radius on the disk, in degrees on the sphere."""
    return f"radius {a:.3g}" if o.chart is DISK else f"{np.degrees(a):.3g}°"
