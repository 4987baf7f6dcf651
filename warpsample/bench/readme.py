"""The measured part of the room's README, and its pictures, from the files of `results/`: a pure function of them.

`python -m warpsample.bench.readme` writes it anew without measuring anything.
"""

import hashlib
from pathlib import Path

from warpsample.bench import benchmarks, pictures
from warpsample.bench.peers.jobs import TASKS
from warpsample.bench.rays.tables import range_over_embree
from warpsample.bench.record import SEED, Benchmark
from warpsample.bench.report import digits, markdown
from warpsample.bench.result import RESULTS, Result, kept
from warpsample.bench.visibility.tables import time_to
from warpsample.host.files import check_output, check_output_folder, write_bytes

README = Path(__file__).parent / "README.md"
PICTURES = Path(__file__).parents[2] / "viz"
BEGIN, END = "<!-- measured: `warpsample bench all --write` -->", "<!-- end of what is measured -->"


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
    """Writes the README's measured part and the pictures of the first processor; returns the files."""
    write_bytes(README, fill(README.read_text(encoding="utf-8"), RESULTS).encode())
    files = [README]
    processor = processors(RESULTS)[0]
    for name, result in kept(processor, benchmarks(), RESULTS).items():
        benchmark = benchmarks()[name]
        figures = benchmark.figures(result.found, str(result.machine))
        shown = {f"bench_{picture}": figures[picture] for picture in benchmark.pictures}
        files += pictures.save(shown, PICTURES, digest(RESULTS / f"{name}-{processor}.json"))
    return files


def fill(text: str, folder: Path) -> str:
    """A README's text with the part between its marks made from the results in a folder."""
    head, rest = text.split(BEGIN)
    _, tail = rest.split(END)
    sections = [_section(processor, i == 0, folder) for i, processor in enumerate(processors(folder))]
    return "\n\n".join([head + BEGIN, *sections, END + tail])


def processors(folder: Path) -> list[str]:
    """The kinds that there are results of, AVX-512 before AVX2."""
    return sorted({path.stem.rpartition("-")[2] for path in folder.glob("*.json")}, reverse=True)


def headline(folder: Path = RESULTS) -> list[str]:
    """What the first page of the package says of speed: phrases of the first processor's results."""
    found = kept(processors(folder)[0], benchmarks(), folder)
    speeds = {row.peer: row.million_per_second for row in found["peers"].found.rows}
    theirs = speeds.get("Mitsuba, three planes")
    over = range_over_embree(found["rays"].found)
    times = [time_to(found["visibility"].found, tool, "bunny", 0.01) for tool in ("warpsample", "Mitsuba")]
    beside = [
        f" (Mitsuba: {digits(theirs.median)})" if theirs else "",
        f" (Mitsuba's fused kernel: {digits(times[1])})" if times[1] else "",
    ]
    machine = found["peers"].machine
    return [
        f"{digits(speeds[TASKS['directions'].ours].median)} million directions a second{beside[0]}",
        *([f"rays {over[0]:.1f} to {over[1]:.1f} times as fast as Embree's"] if over else []),
        f"to an RMSE of 0.01 in {digits(times[0])} µs a point{beside[1]}",
        machine.processor,
    ]


def digest(path: Path) -> str:
    """Of a file of results, by which a picture says what it was made from."""
    return f"{path.name} {hashlib.sha256(path.read_bytes()).hexdigest()}"


def _section(processor: str, first: bool, folder: Path) -> str:
    found = kept(processor, benchmarks(), folder)
    machine = next(iter(found.values())).machine
    head = f"## {machine.processor}, {machine.cores} cores"
    return "\n\n".join([head, *(_of_benchmark(benchmarks()[name], result, first) for name, result in found.items())])


def _of_benchmark(benchmark: Benchmark, result: Result, with_pictures: bool) -> str:
    shown = benchmark.pictures.items() if with_pictures else ()
    parts = [
        f"### {benchmark.title}",
        *benchmark.readme(result),
        *(f"![{what}](../../viz/bench_{name}.png)" for name, what in shown),
        f"({_settings(benchmark, result)})",
    ]
    return markdown(parts)


def _settings(benchmark: Benchmark, result: Result) -> str:
    m = result.machine
    chosen = [f"{name} {value:,}" if isinstance(value, int) else f"{name} {value}"
              for name, value in vars(result.settings).items() if value is not None]  # fmt: skip
    where = f"warp-lang {m.warp}, NumPy {m.numpy}, Python {m.python}, commit {m.commit}"
    return f"`warpsample bench {benchmark.name}`: {', '.join(chosen)}, seed {SEED}; {where}"


if __name__ == "__main__":
    write()
