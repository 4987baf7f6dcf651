"""What the room's README shows is run, of fewer points."""

import re

import pytest

import warpsample as ws

pytest.importorskip("dask")
pytest.importorskip("zarr")
pytest.importorskip("xarray")


def blocks(repository, language):
    text = (repository / "warpsample" / "cluster" / "README.md").read_text()
    return re.findall(rf"^```{language}\n(.*?)^```", text, flags=re.DOTALL | re.MULTILINE)


def test_what_the_readme_shows_runs(repository, tmp_path, monkeypatch, call, capsys):
    monkeypatch.chdir(tmp_path)
    first, second = blocks(repository, "python")
    exec(first.replace("10**9", "3000"))
    assert 0.6 < float(capsys.readouterr().out) < 0.8
    _, shell = blocks(repository, "sh")
    for line in shell.splitlines():
        command = line.split("#")[0].replace("1000000", "3000").replace("--processes 2", "").split()[1:]
        assert call(*command)[0] == 0
    found = {}
    exec(second, found)
    right = ws.sky_view_factor(ws.load_mesh("courtyard"), ws.sample_surface(ws.load_mesh("courtyard"), 3000), 256)
    assert (found["sky"].value.to_numpy() == right.value).all()
    assert {path.name for path in tmp_path.iterdir()} == {"sky.zarr", "sky.vtp"}
