"""Generate the tables, headlines and pictures of the benchmark pages from the files in `results/`.

`README.md` shows the first kind of processor, AVX-512, and `AVX2.md` shows every other kind. The text around the tables is
hand-written. `python -m warpsample.bench.reporting.readme` writes both pages without a new measurement.
"""

import hashlib
import re
from pathlib import Path

from warpsample.bench import benchmarks
from warpsample.bench.reporting import pictures
from warpsample.bench.reporting.tables import format_markdown
from warpsample.bench.result import RESULTS, load_results
from warpsample.bench.rows import format_digits
from warpsample.host.files import check_output, check_output_folder, write_bytes

README = Path(__file__).parents[1] / "README.md"
SECOND_PAGE = "AVX2.md"
"""Name of the page for every processor but the first, in the folder of the README."""
PICTURES = Path(__file__).parents[3] / "viz"

_BLOCK = re.compile(r"<!-- bench ([\w-]+) -->\n.*?<!-- end -->", re.DOTALL)
_HEADLINE = re.compile(r"<!-- headline -->\n.*?<!-- end -->", re.DOTALL)
_PICTURE = re.compile(r"viz/bench_(\w+)\.png")


def check_checkout(argument: str) -> None:
    """Raise an error unless the package is a checkout whose benchmark pages and results can be written.

    Raises:
        ValueError: the package is installed without its pictures, or a page or folder cannot be written.
    """
    if not (PICTURES / "gallery.py").is_file():
        raise ValueError(
            f"{argument}: got an installed package, want a Git checkout, whose pages and pictures can be rewritten"
        )
    for page in list_pages():
        check_output(page, argument)
    check_output_folder(RESULTS, argument)
    check_output_folder(PICTURES, argument)


def list_pages() -> dict[Path, slice]:
    """Return the benchmark pages, each with the slice of processors that the page shows."""
    return {README: slice(1), README.with_name(SECOND_PAGE): slice(1, None)}


def write_pages() -> list[Path]:
    """Write both benchmark pages and the README's pictures; return the files.

    The pictures show the first processor.
    """
    kinds = list_processors(RESULTS)
    text = README.read_text(encoding="utf-8")
    files = []
    for page, chosen in list_pages().items():
        write_bytes(page, fill_page(page.read_text(encoding="utf-8"), RESULTS, kinds[chosen]).encode())
        files.append(page)
    for name, result in load_results(kinds[0], benchmarks(), RESULTS).items():
        figures = benchmarks()[name].figures(result, find_pictures(text))
        named = {f"bench_{picture}": figure for picture, figure in figures.items()}
        files += pictures.save_figures(named, PICTURES, describe_source(RESULTS / f"{name}-{kinds[0]}.json"))
    return files


def find_pictures(text: str) -> list[str]:
    """Return the names of the pictures that the text of a benchmark page includes."""
    return list(dict.fromkeys(_PICTURE.findall(text)))


def fill_page(text: str, folder: Path, shown: list[str]) -> str:
    """Return the text of a benchmark page with new tables and headlines between its marks.

    Args:
        text: page with marks `<!-- bench NAME -->`, `<!-- headline -->` and `<!-- end -->`.
        folder: folder of results.
        shown: kinds of processor that the page shows, in this order.
    """
    everything = [load_results(processor, benchmarks(), folder) for processor in shown]

    def tables_of(match: re.Match[str]) -> str:
        name = match[1]
        results = [results[name] for results in everything if name in results]
        tables = [format_markdown(benchmarks()[name].build_page(result)) for result in results]
        return "\n".join([f"<!-- bench {name} -->", *["\n\n".join(tables)] * bool(tables), "<!-- end -->"])

    def headline_of(match: re.Match[str]) -> str:
        phrases = [phrase for processor in shown for phrase in list_headlines(processor, folder)]
        return "\n".join(["<!-- headline -->", *(f"- {phrase}" for phrase in phrases), "<!-- end -->"])

    return _HEADLINE.sub(headline_of, _BLOCK.sub(tables_of, text))


def list_processors(folder: Path) -> list[str]:
    """Return the kinds of processor with results in `folder`, AVX-512 before AVX2."""
    return sorted({path.stem.rpartition("-")[2] for path in folder.glob("*.json")}, reverse=True)


def list_headlines(processor: str, folder: Path = RESULTS) -> list[str]:
    """Return a processor's headline results as phrases for the start of a page, the processor's name last."""
    results = load_results(processor, benchmarks(), folder)
    if not {"peers", "rays", "visibility"} <= results.keys():
        return []
    peers, rays, visibility = (results[name].rows["rows"] for name in ("peers", "rays", "visibility"))
    speeds = {row.tool: format_digits(row.million_per_second.median) for row in peers if row.million_per_second}
    ratios = [row.ours.median for row in rays if row.tool == "Embree"]
    on_bunny = [row for row in visibility if (row.scene, row.target) == ("bunny", 0.01) and row.microseconds]
    times = {row.tool: format_digits(row.microseconds.median) for row in on_bunny}
    mitsuba = speeds.get("Mitsuba, three planes")
    return [
        f"{speeds['warpsample independent']} million directions a second{f' (Mitsuba: {mitsuba})' if mitsuba else ''}",
        *([f"rays {min(ratios):.1f} to {max(ratios):.1f} times as fast as Embree's"] if ratios else []),
        f"ambient occlusion to an RMSE of 0.01 in {times['warpsample']} µs a point"
        + (f" (Mitsuba's fused kernel: {times['Mitsuba']})" if "Mitsuba" in times else ""),
        results["peers"].machine.processor,
    ]


def describe_source(path: Path) -> str:
    """Return the name and the SHA-256 digest of a results file, which a picture records as its source."""
    return f"{path.name} {hashlib.sha256(path.read_bytes()).hexdigest()}"


if __name__ == "__main__":
    write_pages()
