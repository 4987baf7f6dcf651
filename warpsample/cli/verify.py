"""The command `warpsample verify`: tests of all samplers, one sampler, or user-defined samplers."""

import importlib
import sys
from collections.abc import Iterable
from contextlib import closing
from pathlib import Path
from typing import Annotated, Any

import typer

from warpsample.cli.terminal import console, fail_plainly, option, with_progress

ONLY_HELP = (
    "Test only one distribution or sequence, such as ggx or sobol; or meshes, rays or routes. See --module for your own."
)


@fail_plainly()
def verify_command(
    *,
    only: Annotated[str | None, option(ONLY_HELP)] = None,
    module: Annotated[
        Path | None, option("Python file that registers user-defined distributions, such as my_lobe.py.")
    ] = None,
    thorough: Annotated[
        bool,
        typer.Option(
            "--thorough",
            help="Test all 2^24 values of each random number instead of every fourth value. Takes three times as long.",
        ),
    ] = False,
    power: Annotated[
        bool, typer.Option("--power", help="Test the tests instead: check that they reject each deliberately wrong sampler.")
    ] = False,
    plant: Annotated[
        str | None, option("Also test this deliberately wrong sampler, such as 'ball for sphere'. --power lists the names.")
    ] = None,
    markdown: Annotated[
        bool, typer.Option("--markdown", help="Print the results as the Markdown table of the distributions.")
    ] = False,
) -> None:
    """Test every sampler against its density and a second implementation, and print tables. Exit status 1 if a test fails.

    Ctrl-C prints the tables of the tests completed by then.
    """
    from warpsample.host.registry import look_up
    from warpsample.proof import report, run

    if module is not None:
        _load(module)
    try:
        tasks = run.defect_tasks() if power else run.list_tasks(only) if only else run.list_tasks()
    except ValueError as error:
        raise error if module is not None else ValueError(f"{error}; --module adds user-defined distributions") from None
    if plant is not None:
        defects = {task.key: task for task in run.defect_tasks()}
        tasks.append(look_up(defects, plant, "plant"))
    outcome: dict[Any, Any] = {}
    try:
        with closing(run.run(tasks, thorough)) as parts:  # ends the worker processes after an interrupt
            outcome.update(with_progress(parts, len(tasks), "verifying"))  # one by one: an interrupt keeps finished parts
    except KeyboardInterrupt as interrupt:  # raise the same object: another signal may have caused it
        if outcome and not (power or markdown):
            done = f"{len(outcome)} of {len(tasks)} parts"
            interrupt.args = (f"interrupted after {done}; the tables contain only these parts",)
            _print_report([v for found in outcome.values() for v in found], outcome, thorough, single=only is not None)
        raise
    in_order = {task: outcome[task] for task in tasks}
    verdicts = [verdict for found in in_order.values() for verdict in found]
    if power:
        console().print(report.power_table({str(task.key): found for task, found in in_order.items()}))
        raise SystemExit(any(all(v.passed for v in found) for found in in_order.values()))
    if markdown:
        print(report.markdown(verdicts))
    else:
        _print_report(verdicts, tasks, thorough, single=only is not None)
    raise SystemExit(not all(v.passed for v in verdicts))


def _print_report(verdicts: list[Any], tasks: Iterable[Any], thorough: bool, *, single: bool) -> None:
    """Print the results of all tests as tables, the number of random numbers tested, and advice on failed tests."""
    from warpsample.proof import advice, report, run

    tables = console()
    (report.show_one if single else report.show)(verdicts, tables)
    if sweep := run.describe_sweep(tasks, thorough):
        tables.print(sweep)
    for sentence in advice.advise(verdicts, run.subjects(tasks)):
        tables.print(f"\n{sentence}", markup=False, highlight=False)


def _load(module: Path) -> None:
    """Import a Python file, whose folder is added to `sys.path` so that worker processes find the file."""
    from warpsample.host.arguments import check_file

    path = check_file(module, "module", "a Python file")
    if path.suffix != ".py" or not path.stem.isidentifier():
        raise ValueError(f"module: got {str(path)!r}, want a Python file such as my_lobe.py")
    sys.path.insert(0, str(path.resolve().parent))
    importlib.import_module(path.stem)
