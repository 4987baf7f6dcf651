"""The trial as a command: what it prints, and its exit status with and without a planted defect."""

import re
import sys
from io import StringIO

import pytest
from rich.console import Console

import warpsample as ws
from warpsample import cli
from warpsample.proof import defects, report, run, verify
from warpsample.proof.run import TrialPart
from warpsample.proof.streams import judge_sequence
from warpsample.proof.stress import judge_bad_normals, judge_indices, judge_normals


@pytest.fixture
def call(monkeypatch, capsys):
    """Runs `warpsample verify ...` on a few tasks in this process; returns (exit status, stdout, stderr)."""
    short = [TrialPart("case", ws.OffsetCircle()), TrialPart("case", ws.OffsetDisk())]
    monkeypatch.setattr(run, "list_tasks", lambda: list(short))
    monkeypatch.setattr(run, "run", lambda tasks, thorough: ((task, task.verdicts(thorough)) for task in tasks))

    def verify_command(*arguments):
        monkeypatch.setattr(sys, "argv", ["warpsample", "verify", *arguments])
        with pytest.raises(SystemExit) as stop:
            cli.main()
        return stop.value.code, *capsys.readouterr()

    return verify_command


def test_the_trial_holds_every_case_sequence_and_route():
    tasks = run.list_tasks()
    assert {task.key for task in tasks if task.kind == "case"} == set(verify.cases())
    assert {task.key for task in tasks if task.kind == "sequence"} == set(ws.sequences.names())
    assert {task.kind for task in tasks} == {"case", "sequence", "routes", "meshes", "rays"}
    statistics = sum(law.limit is None and law.applies(case) for law in verify.LAWS for case in verify.cases())
    assert statistics + 150 <= verify.MOST_STATISTICS  # with those of sequences, routes and meshes


@pytest.mark.slow
def test_tables_a_law_each_and_status_0(call):
    status, out, err = call()
    assert (status, err) == (0, "")
    for law in ("finite", "unit length", "density", "cells", "tails", "moments"):
        assert f"\n{law}: " in f"\n{out}"
    assert out.count("OffsetDisk") == sum(law.applies(ws.OffsetDisk()) for law in verify.LAWS)
    assert "BROKEN" not in out
    assert " 0 broken" in out
    assert "--thorough takes all" in " ".join(out.split())
    assert max(map(len, out.splitlines())) <= 120


@pytest.mark.slow
def test_a_planted_defect_gives_status_1(call, monkeypatch):
    monkeypatch.setattr(run, "list_tasks", list)  # the defect alone
    status, out, _ = call("--plant", "ball for sphere")
    assert status == 1
    assert [line for line in out.splitlines() if "ball for sphere" in line and "BROKEN" in line]


def test_an_unknown_defect_lists_the_known_ones(call):
    status, out, err = call("--plant", "typo")
    assert (status, out) == (2, "")
    assert err.startswith("error: --plant: got 'typo', want one of Beckmann density without alpha_y, ")


@pytest.mark.slow
def test_power_names_the_laws_and_a_defect_that_nobody_catches(call, monkeypatch):
    monkeypatch.setattr(run, "defect_tasks", lambda: [TrialPart("defect", "inverse with a swapped pair")])
    status, out, _ = call("--power")
    assert status == 0
    assert "inverse with a swapped pair   round trip" in out
    monkeypatch.setattr(
        run, "defect_tasks", lambda: [TrialPart("case", ws.OffsetCircle())]
    )  # correct, so nothing catches it
    status, out, _ = call("--power")
    assert status == 1
    assert "nothing" in out


def test_every_verdict_has_a_table():
    found = [*judge_sequence("philox", 1000), judge_indices("philox")]
    found += [*judge_normals(ws.UniformHemisphere()), judge_bad_normals()]
    found += [verify.Verdict(law.name, "made up", 0.0, 1.0, False) for law in verify.LAWS]
    report.show(found, Console(file=(shown := StringIO()), width=200))
    assert {verdict.law for verdict in found} - set(re.findall(r"^(.+?): ", shown.getvalue(), flags=re.MULTILINE)) == set()


@pytest.mark.slow
def test_tasks_run_in_processes_and_an_error_reaches_the_caller():
    task = TrialPart("case", ws.OffsetCircle())
    (found,) = run.run([task])
    assert found == (task, task.verdicts())
    with pytest.raises(ValueError, match="sequence: got 'no such', want one of"):
        list(run.run([TrialPart("sequence", "no such")]))


def test_every_defect_can_be_planted():
    assert [task.key for task in run.defect_tasks()] == defects.names()


def test_the_summary_counts_in_words():
    exact, statistical = (verify.Verdict("law", "made up", 1.0, 1.0, whether) for whether in (False, True))
    assert report.summarize([exact]) == "1 verdict, 0 broken."
    assert "2 verdicts, 0 broken. 1 is a statistical test that fails below" in report.summarize([exact, statistical])
    assert "2 are statistical tests that fail below" in report.summarize([statistical] * 2)


def test_only_samplers_are_swept():
    assert run.describe_sweep([TrialPart("meshes"), TrialPart("sequence", "sobol")], thorough=False) == ""
    assert run.describe_sweep([TrialPart("case", ws.OffsetDisk())], thorough=True).startswith("The sweep takes each")
