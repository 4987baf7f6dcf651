"""`warpsample verify`: the trial of every sampler, of one, or of one's own."""

import importlib
import sys
from collections.abc import Iterable
from contextlib import closing
from pathlib import Path
from typing import Annotated, Any

import typer

from warpsample.cli.terminal import console, fail_plainly, option, with_progress

ONLY_HELP = "One distribution or sequence by its name, or meshes, rays or routes, in one table; --module brings your own."


@fail_plainly()
def verify_command(
    *,
    only: Annotated[str | None, option(ONLY_HELP)] = None,
    module: Annotated[Path | None, option("A Python file that registers distributions of your own.")] = None,
    thorough: Annotated[bool, typer.Option("--thorough", help="Sweep all 2^24 variates, not every fourth.")] = False,
    power: Annotated[bool, typer.Option("--power", help="Try the laws on planted defects instead.")] = False,
    plant: Annotated[str | None, option("Put this planted defect among the samplers; see --power.")] = None,
    markdown: Annotated[bool, typer.Option("--markdown", help="The README's table of distributions instead.")] = False,
) -> None:
    """Prove every sampler: a table for each law, and what to do about those that are broken. Exit status 1 if one is.

    Ctrl-C prints the tables of what is done by then.
    """
    from warpsample.host.registry import look_up
    from warpsample.proof import report, run

    if module is not None:
        _load(module)
    try:
        tasks = run.defect_tasks() if power else run.list_tasks(only) if only else run.list_tasks()
    except ValueError as error:
        raise error if module is not None else ValueError(f"{error}; --module brings one of your own") from None
    if plant is not None:
        defects = {task.key: task for task in run.defect_tasks()}
        tasks.append(look_up(defects, plant, "plant"))
    outcome: dict[Any, Any] = {}
    try:
        with closing(run.run(tasks, thorough)) as found:  # its processes end with it, whoever is interrupted
            outcome.update(with_progress(found, len(tasks), "verifying"))  # one by one: an interrupt keeps them
    except KeyboardInterrupt as interrupt:  # raised again itself: it may stand for another signal
        interrupt.args = (f"interrupted after {len(outcome)} of {len(tasks)} parts; what is told is of these",)
        if outcome and not (power or markdown):
            _tell([v for found in outcome.values() for v in found], outcome, thorough, single=only is not None)
        raise
    in_order = {task: outcome[task] for task in tasks}
    verdicts = [verdict for found in in_order.values() for verdict in found]
    if power:
        console().print(report.power_table({str(task.key): found for task, found in in_order.items()}))
        raise SystemExit(any(all(v.passed for v in found) for found in in_order.values()))
    if markdown:
        print(report.markdown(verdicts))
    else:
        _tell(verdicts, tasks, thorough, single=only is not None)
    raise SystemExit(not all(v.passed for v in verdicts))


def _tell(verdicts: list[Any], tasks: Iterable[Any], thorough: bool, *, single: bool) -> None:
    """Prints tables, how far the sweep went, and what to do about what is broken."""
    from warpsample.proof import advice, report, run

    tables = console()
    (report.show_one if single else report.show)(verdicts, tables)
    tables.print(run.describe_sweep(thorough))
    for sentence in advice.advise(verdicts, run.subjects(tasks)):
        tables.print(f"\n{sentence}", markup=False, highlight=False)


def _load(module: Path) -> None:
    """Imports a file by its name, from its folder, so that the processes of the trial find it as well."""
    from warpsample.host.arguments import check_file

    path = check_file(module, "module", "a Python file")
    if path.suffix != ".py" or not path.stem.isidentifier():
        raise ValueError(f"module: got {str(path)!r}, want a Python file such as my_lobe.py")
    sys.path.insert(0, str(path.resolve().parent))
    importlib.import_module(path.stem)
