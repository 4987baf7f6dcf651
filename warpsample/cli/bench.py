"""The commands `warpsample bench NAME`, one for each benchmark, and `warpsample bench all`."""

import inspect
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Annotated, Any

import typer

from warpsample.bench import benchmarks
from warpsample.bench.record import Benchmark, Result
from warpsample.bench.reporting import pictures, readme, tables
from warpsample.bench.result import save_repeats, save_summary
from warpsample.bench.running.machine import describe_machine
from warpsample.bench.scenes import check_scenes
from warpsample.cli.terminal import console, fail_plainly, option, with_progress, working
from warpsample.host.files import check_output, check_output_folder

app = typer.Typer()

Write = Annotated[
    bool,
    typer.Option(
        "--write", help="Save the results in this Git checkout, and rewrite its two benchmark pages and their pictures."
    ),
]


def _measure(benchmark: Benchmark, **settings: Any) -> Result:
    """Measure a benchmark with a progress bar, print its tables, and return the result."""
    chosen = benchmark.settings(**settings)
    rows = benchmark.measure(lambda items, total: with_progress(items, total, f"measuring {benchmark.name}"), **chosen)
    result = Result(describe_machine(), chosen, rows)
    tables.print_parts(console(), benchmark.report(result))
    return result


def _run_and_save(
    benchmark: Benchmark,
    settings: dict[str, Any],
    json: Annotated[Path | None, option("File to write, .json: machine, settings and the result of every repeat.")] = None,
    plot: Annotated[Path | None, option("Folder for pictures of the results; created if missing.")] = None,
    write: Write = False,
) -> None:
    """Measure a benchmark, write the requested files, and exit with status 1 if methods disagree."""
    check_scenes(settings.get("scene"))
    if json is not None:
        check_output(json, "--json")
    if plot is not None:
        check_output_folder(plot, "--plot")
        pictures.check_matplotlib("--plot")
    if write:
        _check_write()
    result = _measure(benchmark, **settings)
    if json is not None:
        save_repeats(json, benchmark, result)
    if plot is not None:
        with working(f"drawing into {plot}"):
            files = pictures.save_figures(benchmark.figures(result), plot)
        for file in files:
            print(f"{file}", file=sys.stderr)
    if write:
        _write([(benchmark, result)])
    raise SystemExit(benchmark.has_disagreement(result.rows))


def _check_write() -> None:
    """Raise an error if `--write` cannot work: outside a checkout, or without Matplotlib."""
    readme.check_checkout("--write")
    pictures.check_matplotlib("--write")


def _write(results: list[tuple[Benchmark, Result]]) -> None:
    """Save all results and write the pages of benchmarks; called last, so that an interrupt changes no file."""
    for file in [*(save_summary(*rows, readme.RESULTS) for rows in results), *readme.write_pages()]:
        print(f"{file}", file=sys.stderr)


def _command(name: str, benchmark: Benchmark) -> Callable[..., None]:
    """Return the command of a benchmark: its settings as options, and `--json`, `--plot` and `--write`."""
    shared = list(inspect.signature(_run_and_save).parameters.values())[2:]

    def command(json: Path | None, plot: Path | None, write: bool, **settings: Any) -> None:
        _run_and_save(benchmarks()[name], settings, json, plot, write)

    options = [*benchmark.options.values(), *[each.replace(kind=each.KEYWORD_ONLY) for each in shared]]
    command.__doc__ = benchmark.summary
    command.__signature__ = inspect.Signature(options)  # type: ignore[attr-defined]
    command.__annotations__ = {each.name: each.annotation for each in options}
    return fail_plainly(size="--side")(command)  # the side of an image is the `size` of the library's calls


for _name, _benchmark in benchmarks().items():
    app.command(_name)(_command(_name, _benchmark))


@app.command("all")
@fail_plainly()
def bench_all(write: Write = False) -> None:
    """Run all benchmarks one after another, with default settings."""
    if write:
        _check_write()
    results = [(benchmark, _measure(benchmark)) for benchmark in benchmarks().values()]
    if write:
        _write(results)
    raise SystemExit(any(benchmark.has_disagreement(result.rows) for benchmark, result in results))
