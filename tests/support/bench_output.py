"""What the tests of benchmarks share: the command, what it prints, its pictures, and results without measuring."""

import sys
from dataclasses import replace
from functools import update_wrapper
from importlib import import_module

import pytest

from warpsample import cli
from warpsample.bench import benchmarks
from warpsample.bench.record import Result
from warpsample.bench.reporting import pictures, tables
from warpsample.bench.running.machine import describe_machine
from warpsample.cli import terminal


def untracked(items, total):
    """Items, without a bar."""
    items = list(items)
    assert len(items) == total
    return iter(items)


def lines_of(name, settings, found, capsys):
    """What the command of a benchmark prints."""
    benchmark = benchmarks()[name]
    tables.print_parts(
        terminal.console(), benchmark.report(Result(describe_machine(), benchmark.settings(**settings), found))
    )
    lines = capsys.readouterr().out.splitlines()
    assert max(map(len, lines)) <= 120
    assert not [line for line in lines if "…" in line]
    return lines


def draw_pictures(name, found, folder):
    """Draw the pictures of a benchmark, check that none is blank, and return their names."""
    from matplotlib.image import imread

    result = Result(describe_machine(), benchmarks()[name].settings(), found)
    files = pictures.save_figures(benchmarks()[name].figures(result), folder)
    assert all(imread(file)[..., :3].std() > 0.05 for file in files)
    return [file.name for file in files]


def give(monkeypatch, name, **changes):
    """Lets a benchmark have another `measure` with the same options, or other fields."""
    module = import_module(f"warpsample.bench.{name.replace('-', '_')}")
    if "measure" in changes:
        changes["measure"] = update_wrapper(changes["measure"], module.RECORD.measure)
    monkeypatch.setattr(module, "RECORD", replace(module.RECORD, **changes))


def run_command(monkeypatch, *arguments):
    monkeypatch.setattr(sys, "argv", ["warpsample", "bench", *map(str, arguments)])
    with pytest.raises(SystemExit) as stop:
        cli.main()
    return int(stop.value.code)
