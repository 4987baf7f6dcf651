"""User-defined distributions: registration, tests by name, and advice on wrong ones."""

import re
import subprocess
import sys

import numpy as np
import pytest

import warpsample as ws
from warpsample.distributions.own import user_distributions
from warpsample.proof import run
from warpsample.proof.advice import advise
from warpsample.proof.defects import WrongSampler
from warpsample.proof.evidence import Subject
from warpsample.proof.verify import Verdict, cases

NUMBER = re.compile(r"\d+(?:\.\d+)?(?:e-\d\d)?")


@pytest.fixture
def alone():
    """Leaves no distribution behind."""
    yield
    user_distributions.clear()


def subclass(name="my_ggx", of=ws.GGX, **more):
    return type("MyGGX", (of,), {"name": name, **more})


def squashed(text):
    """The text without its figures and with single blanks, and its figures."""
    return " ".join(NUMBER.sub("#", text).split()), [float(found) for found in NUMBER.findall(text)]


@pytest.mark.thorough
def test_the_walk_of_the_readme_is_what_happens(repository, tmp_path, child_environment):
    text = (repository / "warpsample/distributions/README.md").read_text()
    text = text[text.index("## From outside") :]
    wrong, right = re.findall(r"^```python\n(.*?)^```", text, flags=re.DOTALL | re.MULTILINE)
    (said,) = re.findall(r"^```text\n(.*?)^```", text, flags=re.DOTALL | re.MULTILINE)
    imports, functions = right.split("\n\n\n", 1)
    right = f"{imports}\n" + wrong[: wrong.index("@wp.func")] + functions + wrong[wrong.index("@dataclass") :]
    found = []
    for source in (wrong, right):
        (tmp_path / "my_lobe.py").write_text(source)
        command = re.search(r"`warpsample (verify --only .*?)`", text)[1].split()
        given = {"env": child_environment, "cwd": tmp_path, "capture_output": True, "text": True}
        found.append(subprocess.run([sys.executable, "-m", "warpsample", *command], check=False, **given))
    assert [done.returncode for done in found] == [1, 0], found
    assert "BROKEN" not in found[1].stdout
    printed, table = found[0].stdout.split("\n\n", 1)[1], found[0].stdout.splitlines()
    rows, *sentences = said.split("\n\n")
    lines = [next(line for line in table if line.split()[:1] == row.split()[:1]) for row in rows.splitlines()]
    shown = [*lines, *printed.split("\n\n")[-len(sentences) :]]
    for expected, got in zip([*rows.splitlines(), *sentences], shown, strict=True):
        (words, figures), (words_now, figures_now) = squashed(expected), squashed(got)
        assert words == words_now
        assert figures_now == pytest.approx(figures, rel=0.2)  # pow of another processor rounds in another way


def test_a_class_goes_by_its_name(alone):
    mine = subclass()
    assert ws.distributions.register(mine) is mine
    assert "my_ggx" in ws.distributions.names()
    assert ws.distributions.as_distribution("my_ggx(alpha=0.5)") == mine(0.5)
    again = subclass()  # as a cell of a notebook that is run once more
    ws.distributions.register(again)
    assert ws.distributions.get("my_ggx") is again


@pytest.mark.parametrize(
    ("kind", "error", "match"),
    [
        (3, TypeError, "kind: got 3, want a subclass of warpsample.distributions.Distribution"),
        (subclass("ggx"), ValueError, "kind: got MyGGX with name = 'ggx', the name of GGX, want another name"),
        (subclass("my ggx"), ValueError, "kind: got MyGGX with name = 'my ggx', want a name of letters"),
        (subclass(density=None), TypeError, "kind: got MyGGX with density = None, want a string"),
        (subclass(measure="per turn"), ValueError, "kind: got MyGGX with measure = 'per turn', want one of per steradian, "),
        (subclass(maps=None), TypeError, "kind: got MyGGX with maps = None, want Maps"),
        (subclass(_cdf=ws.distributions.Distribution._cdf), TypeError, "kind: got MyGGX without _cdf, want"),
        (type("Bare", (ws.distributions.Distribution,), {}), TypeError, "kind: got Bare with name = None, want a string"),
    ],
)
def test_what_a_class_lacks_is_reported(kind, error, match, alone):
    with pytest.raises(error, match=match):
        ws.distributions.register(kind)
    assert user_distributions == {}


def test_a_twin_is_two_functions(alone):
    with pytest.raises(
        TypeError, match="twin: got 3, want None or a pair \\(directions, density\\) of functions in float64"
    ):
        ws.distributions.register(subclass(), twin=3)


def test_a_missing_twin_is_a_sentence_before_any_work(alone, call):
    ws.distributions.register(subclass())
    for trial in (run.list_tasks, lambda: run.list_tasks("my_ggx")):
        with pytest.raises(NotImplementedError, match=r"got MyGGX\(.*\), which has no twin to be judged by; write a second"):
            trial()
    status, out, err = call("verify", "--only", "my_ggx")
    assert (status, out) == (2, "")
    assert "register(..., twin=(directions, density))" in err


def test_only_takes_what_there_is(call, tmp_path):
    assert [task.key for task in run.list_tasks("ggx")] == cases("ggx")
    assert [(task.kind, task.key) for name in ("sobol", "rays") for task in run.list_tasks(name)] == [
        ("sequence", "sobol"),
        ("rays", "rays"),
    ]
    status, out, err = call("verify", "--only", "gxx")
    assert (status, out) == (2, "")
    assert err.startswith("error: --only: got 'gxx', want one of beckmann, cosine_hemisphere, ")
    assert "; --module adds user-defined distributions" in err.replace("\n", " ")
    for name, said in (("none.py", "which is missing, want a Python file"), ("lobe.txt", "want a Python file such as")):
        (tmp_path / "lobe.txt").write_text("")
        status, out, err = call("verify", "--module", tmp_path / name)
        assert (status, err.startswith("error: --module: got "), said in err) == (2, True, True)


def test_an_interrupt_prints_what_is_done(call, monkeypatch):
    def half(tasks, thorough):
        yield tasks[0], [Verdict.from_error("finite", "Done()", 0.0)]
        raise KeyboardInterrupt

    monkeypatch.setattr(run, "run", half)
    status, out, err = call("verify", "--only", "ggx")
    assert status == 130
    assert err == "interrupted after 1 of 7 parts; the tables contain only these parts\n"
    assert re.search(r"finite +Done +1 +0 +≤ 0 +holds", out)
    assert "1 verdict, 0 broken" in out


def test_what_is_imprecise_is_distinguished_from_what_is_wrong():
    def advise_on(**errors):
        verdicts = [
            Verdict.from_error(law.replace("_", " "), "Mine(alpha=0.1)", value, limit=1e-6) for law, value in errors.items()
        ]
        return " ".join(advise([*verdicts, Verdict.from_error("mass", "Right()", 0.0)]))

    assert advise_on(direction=1e-4, tails=1.0).startswith(
        "Mine is imprecise, not wrong: direction 1.0e-04 (at most 1.0e-06)."
    )
    assert "state the limits in the class: worst_angle = 2.0e-04." in advise_on(direction=1e-4)
    assert "No attribute of the class can excuse this" in advise_on(direction=1e-4, sine=1.0)
    assert advise_on(direction=0.5, cells=1.0).startswith("Mine breaks direction, cells, while all parts agree to 0.01")
    assert advise_on(finite=3.0).startswith("Mine gives NaN, an infinity or density 0 at 3 values of u")
    assert advise_on(outside=3.0).startswith("Mine has a density beyond its support, or at NaN: return 0 there")
    assert advise([Verdict.from_error("mass", "Right()", 0.0)]) == []


@pytest.mark.parametrize(
    ("lobe", "changed", "advice"),
    [
        (ws.CosineHemisphere(), {}, "beyond its support, or at NaN: return 0 there, as wp.where(w[2] > 0.0, density, 0.0)"),
        (ws.UniformSphere(), {}, "above 0 at NaN: return 0 there, as wp.where(wp.dot(w, w) > 0.0, density, 0.0)"),
        (
            ws.UniformSphere(),
            {"largest_angle": np.arccos(-0.5)},
            "beyond its support, or at NaN: return 0 there, as wp.where(w[2] >= -0.5, ",
        ),
        (ws.UniformCone(0.5), {}, "beyond its support, or at NaN: return 0 there, as wp.where(w[2] >= 0.5, density"),
        (ws.UniformDisk(), {}, "beyond its support, or at NaN: return 0 there, as wp.where(wp.length(w) <= 1, density"),
        (ws.OffsetCircle(), {}, "beyond its support, or at NaN: return 0 there, as wp.where(w[1] > 0.0, density"),
    ],
)
def test_the_condition_outside_of_the_support_is_that_of_the_lobe(monkeypatch, lobe, changed, advice):
    """Of a sphere, too: w[2] > 0 would cut off its lower half."""
    monkeypatch.setattr("warpsample.proof.advice.find_conflicts", lambda _: [])
    said = advise([Verdict.from_error("outside", "Mine()", 0.1)], [Subject("Mine()", WrongSampler(lobe, **changed), lobe)])
    assert said[0].startswith(f"Mine has a density {advice}"), said
