"""What the tests of benchmarks share: the command, what it prints, its pictures, and results without measuring."""

import sys
from dataclasses import replace
from importlib import import_module

import pytest

from warpsample import cli
from warpsample.bench import benchmarks, pictures, report
from warpsample.bench.machine import this_machine
from warpsample.bench.result import Result
from warpsample.cli import terminal


def untracked(items, total):
    """Items, without a bar."""
    items = list(items)
    assert len(items) == total
    return iter(items)


def lines_of(name, settings, found, capsys):
    """What the command of a benchmark prints."""
    report.show(terminal.console(), benchmarks()[name].tables(Result(this_machine(), settings, found)))
    lines = capsys.readouterr().out.splitlines()
    assert max(map(len, lines)) <= 120
    assert not [line for line in lines if "…" in line]
    return lines


def drawn(name, found, folder):
    """The names of the pictures of a benchmark, none of them blank."""
    from matplotlib.image import imread

    files = pictures.save(benchmarks()[name].figures(found, "caption"), folder)
    assert all(imread(file)[..., :3].std() > 0.05 for file in files)
    return [file.name for file in files]


def give(monkeypatch, name, **changes):
    """Lets a benchmark have another `measure` (settings, track), or other fields."""
    module = import_module(f"warpsample.bench.{name.replace('-', '_')}")
    monkeypatch.setattr(module, "RECORD", replace(module.RECORD, **changes))


def run_command(monkeypatch, *arguments):
    monkeypatch.setattr(sys, "argv", ["warpsample", "bench", *map(str, arguments)])
    with pytest.raises(SystemExit) as stop:
        cli.main()
    return int(stop.value.code)
