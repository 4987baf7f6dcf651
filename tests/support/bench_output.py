"""What the tests of benchmarks share: the command, its lines, its pictures."""

import sys

import pytest

from warpsample import cli
from warpsample.cli import terminal


def lines_of(show, capsys, *found):
    console = terminal.console()
    show(console, *found)
    lines = capsys.readouterr().out.splitlines()
    assert max(map(len, lines)) <= 120
    assert not [line for line in lines if "…" in line]
    return lines


def not_blank(files):
    from matplotlib.image import imread

    return all(imread(file)[..., :3].std() > 0.05 for file in files)


def run_command(monkeypatch, *arguments):
    monkeypatch.setattr(sys, "argv", ["warpsample", "bench", *map(str, arguments)])
    with pytest.raises(SystemExit) as stop:
        cli.main()
    return stop.value.code
