"""The tables of rays and of builds."""

from statistics import mean

from warpsample.bench.rays.measuring import Build, Found, Speed
from warpsample.bench.report import SPREAD, Table, digits, figure, spread
from warpsample.bench.result import Result
from warpsample.bench.tracers import REMEDIES

_QUERIES = {True: "any hit", False: "nearest hit"}


def tables(result: Result) -> list[Table | str]:
    """A table for each query, and one of builds."""
    found = result.found
    everyone = max(row.workers for row in found.rows)
    note = (
        f"by {everyone}: times as fast by {everyone} workers. visits: nodes, and leaves of up to 16 triangles, of a ray, "
        f"on average. differ: of {max(row.rays for row in found.rows):,} rays, those that some tool answers otherwise."
    )
    return [
        f"The same rays by each tool, taking turns: {SPREAD}.",
        *(_of_query(found.rows, any_hit, everyone) for any_hit in _QUERIES),
        note,
        _of_builds(found.builds),
        *(f"{missing.tool}: {missing.remedy}" for missing in found.missing),
    ]


def readme(result: Result) -> list[Table | str]:
    """Both queries in one table, against Embree and wp.Mesh; the rest in words."""
    rows = [row for row in result.found.rows if row.workers == 1]
    by_case = {(row.scene, row.kind, row.any_hit, row.tool): row for row in rows}
    others = [tool for tool in ("Embree", "wp.Mesh") if any(row.tool == tool for row in rows)]
    cells = []
    for scene, triangles, kind in dict.fromkeys((row.scene, row.triangles, row.kind) for row in rows):
        cells.append([f"{triangles:,} {kind}"])
        for any_hit in _QUERIES:
            cells[-1].append(figure(by_case[scene, kind, any_hit, "wide"].million_per_second.median))
            cells[-1] += [spread(by_case[scene, kind, any_hit, tool].ours) for tool in others]
    headings = [column for query in _QUERIES.values() for column in (f"{query}, M/s", *(f"/ {tool}" for tool in others))]
    peers = [f"{REMEDIES[tool]} {next(r.version for r in rows if r.tool == tool)}" for tool in others if tool in REMEDIES]
    against = " and ".join([*peers, "wp.Mesh"])
    return [
        (
            f"Million rays a second on one thread, and how many times as fast that is as {against} on the same rays; about "
            f"{max(row.rays for row in rows):,} of each kind: from a camera, in the cosine lobe off the surface and into "
            "it, and at random. The scenes are the bunny as it is and split, PyVista's hills, and a city of 4,096 boxes."
        ),
        Table("", ["triangles, rays", *headings], cells),
        *_in_words(result.found),
    ]


def range_over_embree(found: Found) -> tuple[float, float] | None:
    """The least and the greatest of how many times as fast ours is on one thread; None without Embree."""
    ratios = [row.ours.median for row in found.rows if row.workers == 1 and row.tool == "Embree"]
    return (min(ratios), max(ratios)) if ratios else None


def _of_query(rows: list[Speed], any_hit: bool, everyone: int) -> Table:
    found = {(row.scene, row.kind, row.tool, row.workers): row for row in rows if row.any_hit == any_hit}
    others = [tool for tool in dict.fromkeys(row.tool for row in rows) if tool != "wide"]
    cells = []
    for scene, triangles, kind in dict.fromkeys((row.scene, row.triangles, row.kind) for row in rows):
        alone, together = (found[scene, kind, "wide", workers] for workers in (1, everyone))
        theirs = [found[scene, kind, tool, 1] for tool in others]
        cells.append(
            [
                f"{triangles:,} {kind}",
                f"{100 * alone.hit:.0f}",
                figure(alone.million_per_second.median),
                figure(together.gain and together.gain.median),
                *(spread(row.ours) for row in theirs),
                f"{alone.nodes:.1f}, {alone.leaves:.1f}",
                f"{max((row.differ for row in theirs), default=0):,}",
            ]
        )
    title = f"{_QUERIES[any_hit]}: wide, million rays a second, 1 worker; times as fast as each tool on 1 thread"
    headings = ["triangles, rays", "hit %", "M/s", f"by {everyone}", *(f"/ {tool}" for tool in others), "visits", "differ"]
    return Table(title, headings, cells)


def _of_builds(builds: list[Build]) -> Table:
    tools = dict.fromkeys((build.tool, build.workers) for build in builds)
    times = {(build.scene, build.tool, build.workers): build.milliseconds for build in builds}
    cells = [
        [f"{triangles:,}", *(spread(times[scene, tool, workers]) for tool, workers in tools)]
        for scene, triangles in dict.fromkeys((build.scene, build.triangles) for build in builds)
    ]
    headings = ["triangles", *(f"{tool} ({workers})" if workers else tool for tool, workers in tools)]
    return Table("Building, milliseconds (workers)", headings, cells)


def _in_words(found: Found) -> list[str]:
    differ = max(row.differ for row in found.rows)
    answers = (
        f"the tools differ on {differ:,} rays of a set at most" if differ else "no two tools differ on any of these rays"
    )
    everyone = max(row.workers for row in found.rows)
    gains = [row.gain.median for row in found.rows if row.tool == "wide" and row.gain]
    largest = max(build.triangles for build in found.builds)
    seconds = {(b.tool, b.workers): digits(b.milliseconds.median / 1e3) for b in found.builds if b.triangles == largest}
    built = f"{seconds['wide', 1]} s to build, {seconds['wide', everyone]} s with {everyone} workers"
    theirs = f"; embreex takes {seconds['Embree', 0]} s" if ("Embree", 0) in seconds else ""
    return [
        (
            f"Whether a ray hits: {answers}. {_of_workers(everyone, gains)}"
            f"The tree of {largest:,} triangles takes {built}, and {seconds['wide, refit', everyone]} s to refit{theirs}."
        )
    ]


def _of_workers(everyone: int, gains: list[float]) -> str:
    return f"On average {everyone} workers are {mean(gains):.1f} times as fast as one. " if gains else ""
