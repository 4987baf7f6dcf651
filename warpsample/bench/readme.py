"""The tables in the room's README, and its pictures, from the files of `results/`: a pure function of them.

`python -m warpsample.bench.readme` writes them anew without measuring anything. What stands around the tables is written by
hand, there.
"""

import hashlib
import re
from pathlib import Path

from warpsample.bench import benchmarks, pictures
from warpsample.bench.result import RESULTS, kept
from warpsample.bench.rows import digits
from warpsample.bench.tables import markdown
from warpsample.host.files import check_output, check_output_folder, write_bytes

README = Path(__file__).parent / "README.md"
PICTURES = Path(__file__).parents[2] / "viz"

_BLOCK = re.compile(r"<!-- bench ([\w-]+) -->\n.*?<!-- end -->", re.DOTALL)
_PICTURE = re.compile(r"viz/bench_(\w+)\.png")


def check_checkout(argument: str) -> None:
    """Refuses an installed package, which has no pictures beside it, and a checkout that may not be written.

    Raises:
        ValueError: this is no checkout, or the README or the folders of results and pictures cannot be written.
    """
    if not (PICTURES / "gallery.py").is_file():
        raise ValueError(f"{argument}: got an installed package, want a checkout, whose README and pictures can be written")
    check_output(README, argument)
    check_output_folder(RESULTS, argument)
    check_output_folder(PICTURES, argument)


def write() -> list[Path]:
    """Writes the README's tables, and the pictures that it shows, of the first processor; returns the files."""
    text = README.read_text(encoding="utf-8")
    write_bytes(README, fill(text, RESULTS).encode())
    files, processor, shown = [README], processors(RESULTS)[0], pictures_in(text)
    for name, result in kept(processor, benchmarks(), RESULTS).items():
        figures = {f"bench_{picture}": figure for picture, figure in benchmarks()[name].figures(result, shown).items()}
        files += pictures.save(figures, PICTURES, digest(RESULTS / f"{name}-{processor}.json"))
    return files


def pictures_in(text: str) -> list[str]:
    """The names of the pictures that a README shows."""
    return list(dict.fromkeys(_PICTURE.findall(text)))


def fill(text: str, folder: Path) -> str:
    """A README's text in which each block `<!-- bench name --> ... <!-- end -->` has its tables, of a folder of results."""
    everything = [kept(processor, benchmarks(), folder) for processor in processors(folder)]

    def block(found: re.Match[str]) -> str:
        name = found[1]
        results = [results[name] for results in everything if name in results]
        tables = [markdown(benchmarks()[name].brief(result)) for result in results]
        return "\n\n".join([f"<!-- bench {name} -->", *tables, "<!-- end -->"])

    return _BLOCK.sub(block, text)


def processors(folder: Path) -> list[str]:
    """The kinds of processor that there are results of, AVX-512 before AVX2."""
    return sorted({path.stem.rpartition("-")[2] for path in folder.glob("*.json")}, reverse=True)


def headline(processor: str, folder: Path = RESULTS) -> list[str]:
    """What the first page of the package says of speed: phrases of a processor's results."""
    results = kept(processor, benchmarks(), folder)
    peers, rays, visibility = (results[name].found["rows"] for name in ("peers", "rays", "visibility"))
    speeds = {row.tool: digits(row.million_per_second.median) for row in peers if row.million_per_second}
    over = [row.ours.median for row in rays if row.tool == "Embree"]
    on_bunny = [row for row in visibility if (row.scene, row.target) == ("bunny", 0.01) and row.microseconds]
    times = {row.tool: digits(row.microseconds.median) for row in on_bunny}
    theirs = speeds.get("Mitsuba, three planes")
    return [
        f"{speeds['warpsample independent']} million directions a second{f' (Mitsuba: {theirs})' if theirs else ''}",
        *([f"rays {min(over):.1f} to {max(over):.1f} times as fast as Embree's"] if over else []),
        f"to an RMSE of 0.01 in {times['warpsample']} µs a point"
        + (f" (Mitsuba's fused kernel: {times['Mitsuba']})" if "Mitsuba" in times else ""),
        results["peers"].machine.processor,
    ]


def digest(path: Path) -> str:
    """The name and the digest of a file of results, by which a picture says what it was made from."""
    return f"{path.name} {hashlib.sha256(path.read_bytes()).hexdigest()}"


if __name__ == "__main__":
    write()
