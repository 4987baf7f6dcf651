"""Report on computed values: an .html file without links, with picture, histogram, tables and all arguments."""

import base64
from collections.abc import Iterable, Iterator, Mapping
from html import escape
from importlib.metadata import version
from pathlib import Path
from platform import python_version
from typing import Any

import numpy as np

from warpsample.estimate.result import PointStatus
from warpsample.host.files import check_output, write_bytes
from warpsample.output.baked import Baked
from warpsample.output.by_parts import part_table
from warpsample.output.pictured import draw_picture, get_picture_values, title_of
from warpsample.plotting.rendering import check_rendering

_BINS, _MOST_ROWS = 40, 200
_QUARTILES = {"minimum": 0, "first quartile": 25, "median": 50, "third quartile": 75, "maximum": 100}
_STYLE = """body { font: 16px/1.5 sans-serif; margin: 2em auto; max-width: 60em; padding: 0 1em; color: #222 }
img, svg { max-width: 100%; height: auto } table { border-collapse: collapse } div { overflow-x: auto }
td, th { padding: .2em .8em; text-align: right; border-bottom: 1px solid #ddd }
td:first-child, th:first-child { text-align: left }
"""


def check_report(path: Path | None, *others: Path) -> None:
    """Check that the .html report can be written, and that its path is no input or output file.

    Raises:
        ValueError: a wrong suffix, or a path that cannot be written.
    """
    if path is not None:
        if path.suffix != ".html":
            raise ValueError(f"--report: got {str(path)!r}, want a file that ends in .html")
        check_output(path, "--report", *others)


def write_report(path: Path, baked: Baked, city: Any) -> None:
    """Write the report of a run, complete or not at all; the same run gives the same bytes."""
    title = f"{baked.quantity.title} of {baked.run.mesh.name}"
    parts = [
        "<!doctype html><html lang=en><meta charset=utf-8><meta name=viewport content='width=device-width'>",
        f"<title>{escape(title)}</title><style>{_STYLE}</style><h1>{escape(title)}</h1>",
        *_draw(baked),
        f"<h2>Histogram</h2>{_histogram(get_picture_values(baked), title_of(baked))}",
        f"<h2>Statistics</h2>{_table(_statistics(baked))}",
        *_by_part(baked, city),
        f"<h2>Arguments</h2>{_table(_arguments(baked).items())}",
        f"<h2>Versions</h2>{_table((name, version(name)) for name in ('warpsample', 'warp-lang', 'numpy'))}",
        f"<p>Python {python_version()}</p></html>\n",
    ]
    write_bytes(path, "\n".join(parts).encode(errors="backslashreplace"))  # names may hold bytes that are not in UTF-8


def _draw(baked: Baked) -> Iterator[str]:
    """Yield the HTML text of the picture, or a sentence if this machine cannot draw one."""
    try:
        check_rendering()
    except (RuntimeError, ModuleNotFoundError) as error:
        yield f"<p>No picture: {escape(str(error))}</p>"
        return
    data = base64.b64encode(draw_picture(baked)).decode()
    yield f'<img alt="{escape(title_of(baked))}" src="data:image/png;base64,{data}">'


def _histogram(value: np.ndarray, title: str) -> str:
    """Return a histogram of values as SVG text for the .html report."""
    value = value[np.isfinite(value)]
    counts, edges = np.histogram(value, bins=_BINS)
    tall = max(int(counts.max(initial=0)), 1)
    bars = "".join(
        f'<rect x="{20 * k}" y="{200 - 190 * n / tall:.1f}" width="19" height="{190 * n / tall:.1f}" fill="#38678f"/>'
        for k, n in enumerate(counts.tolist())
    )
    ends = f'<text y="220">{edges[0]:.4g}</text><text x="800" y="220" text-anchor="end">{edges[-1]:.4g}</text>'
    middle = f'<text x="400" y="220" text-anchor="middle">{escape(title)}; the highest bar: {tall:,}</text>'
    return f'<svg viewBox="0 0 800 230" role="img" aria-label="histogram" font-size="14">{bars}{ends}{middle}</svg>'


def _statistics(baked: Baked) -> Iterator[tuple[str, str]]:
    """Yield the number of points, mean, standard error, quartiles and number of rays."""
    found, value = baked.result, get_picture_values(baked)
    good = value[np.isfinite(value)]
    yield "points", f"{len(value):,}"
    for status, count in zip(*np.unique(found.status, return_counts=True), strict=True):
        if status:
            yield f"without a number: {PointStatus(int(status)).name.lower()}", f"{count:,}"
    if len(good):
        error = np.sqrt(np.mean(np.square(found.standard_error[found.status == 0].astype(np.float64))))
        yield "mean", f"{good.mean():.6g}"
        yield "standard error, root mean square", f"{error:.3g}"
        for name, share in _QUARTILES.items():
            yield name, f"{np.percentile(good, share):.6g}"
    if rays := int(found.rays.sum(dtype=np.int64)):
        yield "rays", f"{rays:,}"


def _by_part(baked: Baked, city: Any) -> Iterator[str]:
    """Yield the HTML table of means over the parts of the mesh, or nothing for a mesh without parts."""
    if baked.mesh is None or baked.mesh.part is None or baked.run.at == "vertices":
        return
    columns = part_table(baked, city)
    rows = list(zip(*(column.tolist() for column in columns.values()), strict=True))
    yield f"<h2>By part</h2>{_table(rows[:_MOST_ROWS], list(columns))}"
    if len(rows) > _MOST_ROWS:
        yield f"<p>{len(rows) - _MOST_ROWS:,} further parts are left out; a .csv with --by part has all parts.</p>"


def _arguments(baked: Baked) -> Mapping[str, Any]:
    """Return all arguments of the command, defaults included, keyed by option name."""
    return baked.run.recorded | baked.quantity.recorded_options(baked.run.options) | baked.run.more


def _table(rows: Iterable[Iterable[Any]], header: Iterable[str] = ()) -> str:
    """Return the HTML text of a table with the given rows."""
    head = "".join(f"<th>{escape(name)}</th>" for name in header)
    body = "".join(f"<tr>{''.join(f'<td>{escape(_cell(cell))}</td>' for cell in row)}</tr>" for row in rows)
    return f"<div><table>{f'<tr>{head}</tr>' if head else ''}{body}</table></div>"


def _cell(value: Any) -> str:
    """Return a value as the text of a cell of an HTML table."""
    return f"{value:.6g}" if isinstance(value, float) else "" if value is None else str(value)
