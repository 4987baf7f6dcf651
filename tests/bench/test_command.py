"""`warpsample bench`: a command for each benchmark, what it keeps, and how it refuses."""

import json
import sys
from dataclasses import replace

import pytest
from bench_output import give, run_command
from matplotlib.figure import Figure

from warpsample.bench import benchmarks
from warpsample.bench.reporting import pictures, readme
from warpsample.bench.result import RESULTS, load_results


@pytest.fixture
def results():
    """Rows of every benchmark from the files of results, with invented repeats for `peers`."""
    stored = load_results(readme.list_processors(RESULTS)[0], benchmarks())
    rows = {name: result.rows for name, result in stored.items()}
    rows["peers"]["rows"] = [replace(row, seconds=[1.0, 2.0]) for row in rows["peers"]["rows"]]
    return rows


@pytest.fixture
def measured(results, monkeypatch):
    """The settings that each benchmark was asked for; nothing is measured."""
    asked = {}
    for name in results:
        give(monkeypatch, name, measure=lambda _, *, name=name, **settings: asked.update({name: settings}) or results[name])
    return asked


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("name", "options", "pictures"),
    [
        ("cluster", {"points": 1000}, ["cluster"]),
        ("directions", {"points": 64}, ["directions"]),
        ("error", {"rmse": 0.01, "largest": 64}, ["error"]),
        ("kernels", {"points": 64}, ["kernels"]),
        ("light", {"side": 2, "points": 64}, ["light"]),
        ("peers", {"points": 64}, ["peers"]),
        ("radiation", {"scene": "city", "points": 64}, ["radiation"]),
        ("rays", {"scene": "bunny", "rays": 64}, ["rays"]),
        ("scaling", {"largest": 1000}, ["scaling"]),
        ("startup", {}, ["startup"]),
        ("textures", {"side": 64}, ["textures"]),
        ("view-factors", {"side": 2, "rays": 64}, ["view_factors"]),
        ("visibility", {"scene": "city", "points": 64}, ["visibility"]),
    ],
)
def test_a_command_keeps_what_it_finds(measured, monkeypatch, capsys, tmp_path, name, options, pictures):
    given = [text for option, value in options.items() for text in (f"--{option}", value)]
    file = tmp_path / "a.json"
    assert run_command(monkeypatch, name, *given, "--repeats", 3, "--json", file, "--plot", tmp_path / "new") == 0
    out = capsys.readouterr()
    assert "\r" not in out.out
    chosen = {option: [value] if option == "scene" else value for option, value in options.items()} | {"repeats": 3}
    assert measured == {name: benchmarks()[name].settings(**chosen)}
    kept_there = json.loads(file.read_text())
    assert kept_there["command"] == f"bench {name}"
    assert kept_there["settings"].items() >= chosen.items()
    assert {"cpu", "cores", "system", "python", "warpsample", "warp", "numpy", "commit"} <= set(kept_there["machine"])
    if name == "peers":
        assert [row["seconds"] for row in kept_there["rows"]] == [[1.0, 2.0]] * len(kept_there["rows"])
    assert sorted(path.stem for path in (tmp_path / "new").iterdir()) == pictures
    assert not list(tmp_path.glob("*.part"))


def test_what_is_wrong_ends_with_a_status(measured, results, monkeypatch):
    wrong = results["peers"] | {"rows": [replace(row, agrees=False) for row in results["peers"]["rows"]]}
    give(monkeypatch, "peers", measure=lambda *_, **__: wrong)
    assert run_command(monkeypatch, "peers") == 1


def test_all_are_run_and_written(measured, monkeypatch, capsys, tmp_path):
    """Both pages, the pictures and the results are written from the measured rows, by default sizes."""
    monkeypatch.setattr(readme, "README", tmp_path / "README.md")
    monkeypatch.setattr(readme, "PICTURES", tmp_path / "viz")
    monkeypatch.setattr(readme, "RESULTS", tmp_path / "results")
    blocks = "".join(f"<!-- bench {name} -->\n<!-- end -->\n" for name in benchmarks())
    (tmp_path / "README.md").write_text(f"Before.\n{blocks}![A picture](../../viz/bench_directions.png)\nAfter.\n")
    (tmp_path / readme.SECOND_PAGE).write_text(f"Before.\n{blocks}After.\n")
    assert run_command(monkeypatch, "all", "--write") == 2
    assert "--write: got an installed package, want a Git checkout" in capsys.readouterr().err
    (tmp_path / "results").mkdir()
    (tmp_path / "viz").mkdir()
    (tmp_path / "viz" / "gallery.py").touch()
    assert measured == {}
    monkeypatch.setattr(pictures, "draw_figure", lambda *_: Figure((1.0, 1.0)))  # all are drawn above
    assert run_command(monkeypatch, "all", "--write") == 0
    assert measured == {name: benchmark.settings() for name, benchmark in benchmarks().items()}
    text = (tmp_path / "README.md").read_text(encoding="utf-8")
    assert text.startswith("Before.\n")
    assert text.endswith("After.\n")
    assert all(f"(`warpsample bench {name}`:" in text for name in benchmarks())
    assert "`warpsample bench" not in (tmp_path / readme.SECOND_PAGE).read_text(encoding="utf-8")  # no other processor
    assert len(list((tmp_path / "results").iterdir())) == len(benchmarks())
    assert [path.name for path in (tmp_path / "viz").glob("*.png")] == ["bench_directions.png"]


def test_an_end_before_the_last_result_leaves_results_and_readme_as_they_were(measured, monkeypatch, tmp_path, repository):
    monkeypatch.setattr(readme, "PICTURES", repository / "viz")
    monkeypatch.setattr(readme, "RESULTS", tmp_path)

    def stopped(*_, **__):
        raise KeyboardInterrupt

    give(monkeypatch, list(benchmarks())[-1], measure=stopped)
    assert run_command(monkeypatch, "all", "--write") == 130
    assert len(measured) == len(benchmarks()) - 1
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("name", ["README", "RESULTS"])
def test_a_checkout_that_cannot_be_written_is_refused_before_any_work(
    measured, monkeypatch, capsys, tmp_path, repository, name
):
    monkeypatch.setattr(readme, "PICTURES", repository / "viz")
    place = {"README": tmp_path / "no" / "README.md", "RESULTS": tmp_path / "file"}[name]
    (tmp_path / "file").touch()
    monkeypatch.setattr(readme, name, place)
    assert run_command(monkeypatch, "all", "--write") == 2
    assert f"--write: got '{place}'" in capsys.readouterr().err
    assert measured == {}


def test_all_without_write_leaves_everything(measured, monkeypatch, tmp_path):
    before = {path: path.stat().st_mtime_ns for path in [readme.README, *RESULTS.iterdir()]}
    assert run_command(monkeypatch, "all") == 0
    assert set(measured) == set(benchmarks())
    assert {path: path.stat().st_mtime_ns for path in [readme.README, *RESULTS.iterdir()]} == before


def test_what_cannot_be_written_is_refused_before_any_work(measured, monkeypatch, capsys, tmp_path):
    (tmp_path / "file").touch()
    assert run_command(monkeypatch, "directions", "--json", tmp_path / "no" / "a.json") == 2
    assert "--json: got" in capsys.readouterr().err
    assert run_command(monkeypatch, "directions", "--plot", tmp_path / "file") == 2
    assert "which is a file, want a folder" in capsys.readouterr().err
    assert run_command(monkeypatch, "rays", "--scene", "teapot") == 2
    assert "--scene: got 'teapot', want one of bunny, " in capsys.readouterr().err
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    assert run_command(monkeypatch, "directions", "--plot", tmp_path) == 2
    assert "pip install '.[viz]'" in capsys.readouterr().err
    assert measured == {}


def test_an_image_that_is_too_small_is_refused_by_the_name_of_the_option(monkeypatch, capsys):
    def measure(track, **settings):
        raise ValueError("size: got 128, want a larger image")

    give(monkeypatch, "textures", measure=measure)
    assert run_command(monkeypatch, "textures", "--side", 128) == 2
    assert capsys.readouterr().err == "error: --side: got 128, want a larger image\n"
