"""The whole table of `warpsample bake`: (kind of source) x (kind of file) x (option). Each cell works or is refused.

A cell is refused by one sentence with status 2, and leaves no file. `test_cells_that_are_refused` runs all of these;
`test_cells_that_work` runs all others, and the result is a file.
"""

import re
import shutil
from itertools import product
from pathlib import Path

import city_files
import numpy as np
import pytest
import trimesh
from textured_scenes import rich
from typer.testing import CliRunner

import warpsample as ws
from warpsample.cli.commands import app
from warpsample.output.bake_rules import can_hold, check_table
from warpsample.output.bake_table import CITY, FILES, MEAN_FILES, OPTIONS, RASTER, SOURCES, TEXTURE
from warpsample.output.baked import BakeRun
from warpsample.output.quantities import quantities, quantity_of

NAMES = {"meshes": "in.obj", CITY: "in.city.json", RASTER: "in.tif", TEXTURE: "in.glb"}
SUFFIXES = sorted({suffix for files in FILES.values() for suffix in files} | {".txt"})
VALUES = {
    "quantity": "sky", "samples": "4", "tolerance": "0.5", "max_distance": "9", "falloff": "1", "sequence": "sobol",
    "seed": "1", "points": "9", "at": "faces", "by": "part", "weather": "athens", "period": ("06-01", "06-01"),
    "environment": "light.npy", "sampling": "both", "patches": "tregenza", "up": ("0", "0", "1"), "north": ("0", "1", "0"),
    "ground_albedo": "0.1", "reflectance": "0.1", "refine": "9", "transmittance": "0.5", "lod": "2.2", "split": True,
    "context": "ground", "model": "block", "receiver": "surface", "canopy": "trees.tif", "trunk": "0.5", "tile": "8",
    "margin": "4", "far": "far.tif", "texture": "16", "uv": "new", "supersample": "2", "normals": "smooth", "gutter": "1",
    "strength": "0.5", "depth": "16", "strict": True, "high": "high.ply", "cage": "2", "inside": "keep",
    "instances": "mean", "chunk": "9", "cluster": "nowhere", "processes": "1", "resume": True, "workers": "1",
    "device": "cpu", "report": "report.html",
}  # fmt: skip
WITH = {"falloff": ["max_distance"], "margin": ["tile"], "trunk": ["canopy"], "high": ["cage"], "cage": ["high"],
        "refine": ["reflectance"]}  # fmt: skip
"""Further options that an option needs."""

QUANTITIES = {"weather": "sun-hours", "period": "sun-hours", "environment": "irradiance", "reflectance": "irradiance",
              "refine": "irradiance", "sampling": "irradiance",
              "patches": "sky-matrix", "north": "sky-matrix", "ground_albedo": "irradiation",
              "falloff": "ao", "up": "sky", "context": "sky", "strength": "ao"}  # fmt: skip
"""Quantities that have an option; ao otherwise."""

CELLS = [cell for cell in product(SOURCES, SUFFIXES, OPTIONS) if (cell[0], cell[2]) != ("meshes", "texture")]
"""(source, suffix, option); a mesh with `--texture` is the kind of source TEXTURE."""


def quantity_for(source, suffix, name):
    """A quantity that has the option, and that the file can hold if there is one."""
    option = OPTIONS[name]
    chosen = VALUES["quantity"] if name == "quantity" else QUANTITIES.get(name, "ao")
    others = [chosen, *(each for each in quantities() if not option.by_quantity or quantity_of(each).takes(name))]
    if option.needs:
        others = [chosen, *(each for each in quantities() if quantity_of(each).takes(option.needs))]
    return next((each for each in others if can_hold(quantity_of(each), source, suffix)), chosen)


def arguments(source, suffix, name):
    """The command line of a cell, without `bake`."""
    quantity = quantity_for(source, suffix, name)
    name_of_source = "uv.obj" if source == TEXTURE and suffix not in (".glb", ".gltf") else NAMES[source]
    if (source, suffix) == (CITY, ".jsonl"):
        name_of_source = "in.city.jsonl"
    given = [name_of_source, "-o", f"out.city{suffix}" if suffix == ".json" else f"out{suffix}", "--quantity", quantity]
    options = [each for each in (name, *WITH.get(name, ())) if each != "quantity"]
    if (source, name) == (RASTER, "transmittance"):
        options.append("canopy")
    files = quantity_of(quantity).files
    options += [each for each in files if each not in options]
    if source == TEXTURE and "texture" not in options:
        options.append("texture")
    if quantity_of(quantity).takes("samples") and "samples" not in options:
        options.append("samples")
    if quantity_of(quantity).takes("period") and "period" not in options:
        options.append("period")
    if name == "strict":
        options.append("uv")
    for each in options:
        value = "0" if (each, name_of_source) == ("uv", "uv.obj") else VALUES[each]
        values = [] if value is True else [value] if isinstance(value, str) else list(value)
        given += [f"--{each.replace('_', '-')}", *values]
    return given


def works(source, suffix, name):
    """Whether the table allows a cell, by its rows alone."""
    quantity = quantity_of(quantity_for(source, suffix, name))
    option = OPTIONS[name]
    has = not option.by_quantity or quantity.takes(name)
    return suffix in option.where.get(source, ()) and can_hold(quantity, source, suffix) and has


REFUSAL = r"^--[a-z-]+( \d+)?: got .*(want|applies only to) "
BY_CONTENT = ("cluster",)
"""Options whose value decides, not the table: no scheduler answers at the address."""

REFUSED = [cell for cell in CELLS if not works(*cell)]
WORKING = [cell for cell in CELLS if works(*cell)]


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """One small input of each kind, in the current folder."""
    raster_cases = pytest.importorskip("raster_cases")
    box = trimesh.creation.box((2.0, 2.0, 2.0))
    box.export(tmp_path / "in.ply")
    lines = [f"v {x} {y} {z}" for x, y, z in box.vertices.tolist()]
    lines += ["o box", *(f"f {a} {b} {c}" for a, b, c in (box.faces + 1).tolist())]
    (tmp_path / "in.obj").write_text("\n".join(lines))
    (tmp_path / "uv.obj").write_text(
        "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nvt 0.1 0.1\nvt 0.9 0.1\nvt 0.9 0.9\nvt 0.1 0.9\nf 1/1 2/2 3/3 4/4\n"
    )
    house = city_files.house()
    city_files.written(tmp_path / "in.city.json", house)
    objects = {"CityObjects": house["CityObjects"], "vertices": house["vertices"]}
    feature = {"type": "CityJSONFeature", "id": next(iter(house["CityObjects"])), **objects}
    city_files.written(tmp_path / "in.city.jsonl", {**house, "CityObjects": {}, "vertices": []}, feature)
    heights = np.zeros((12, 12), np.float32)
    heights[4:8, 4:8] = 5.0
    for name in ("in.tif", "far.tif", "trees.tif"):
        raster_cases.write_tif(tmp_path / name, heights)
    scene = rich()[:-12]  # without the bytes after the data, which a .gltf cannot hold
    (tmp_path / "in.glb").write_bytes(scene[:8] + len(scene).to_bytes(4, "little") + scene[12:])
    textured = ws.load_mesh(tmp_path / "in.glb")
    trimesh.util.concatenate([box, trimesh.Trimesh(textured.vertices, textured.faces)]).export(tmp_path / "high.ply")
    np.save(tmp_path / "light.npy", np.ones((2, 4, 3)))
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_every_option_and_file_of_the_table_is_in_a_cell():
    assert set(VALUES) == set(OPTIONS)
    assert len(CELLS) == (len(SOURCES) * len(OPTIONS) - 1) * len(SUFFIXES) == len(WORKING) + len(REFUSED)
    assert len(CELLS) > 2500
    for option in OPTIONS.values():
        assert all(set(files) <= set(FILES[source]) for source, files in option.where.items())
    assert all(set(files) <= set(FILES[source]) for source, files in MEAN_FILES.items())


def run_of(given):
    """The run of a command line."""
    options, rest = {}, given[3:]
    while rest:
        name = rest.pop(0)[2:].replace("-", "_")
        count = 0 if VALUES[name] is True else 1 if isinstance(VALUES[name], str) else len(VALUES[name])
        values, rest = rest[:count], rest[count:]
        options[name] = True if not values else values[0] if count == 1 else tuple(values)
    return BakeRun.of(Path(given[0]), Path(given[2]), options.pop("quantity"), {"seed": 0, **options})


def outcome(given):
    """(exit status, stdout, stderr) of the command in this process."""
    done = CliRunner().invoke(app, ["bake", *given])
    if done.exception is not None and not isinstance(done.exception, SystemExit):
        raise done.exception
    return done.exit_code, done.stdout, done.stderr


def test_cells_that_are_refused(folder):
    """Before a file is read: the sentence names an option, what it got, and what it applies to or wants."""
    before = sorted(folder.iterdir())
    print(len(CELLS), "cells,", len(REFUSED), "are refused")  # noqa: T201
    for number, cell in enumerate(REFUSED):
        given = arguments(*cell)
        with pytest.raises(ValueError, match=REFUSAL) as refusal:
            check_table(run_of(given))
        if number % 23 == 0:  # the whole command takes 20 ms
            status, out, err = outcome(given)
            assert (status, out, err.count("\n")) == (2, "", 1), given
            assert re.match(REFUSAL, err.removeprefix("error: ")), (given, str(refusal.value), err)
    assert sorted(folder.iterdir()) == before


@pytest.mark.thorough
@pytest.mark.parametrize("source", SOURCES)
@pytest.mark.filterwarnings("ignore")  # such as that a small raster has walls at its rim
def test_cells_that_work(folder, source, can_render):
    """The command ends with status 0 and the file, or with one sentence on the file's content, and without a file."""
    before, undecided = set(folder.iterdir()), []
    for cell in (each for each in WORKING if each[0] == source):
        given = arguments(*cell)
        status, out, err = outcome(given)
        made = set(folder.iterdir()) - before
        names = {Path(given[2]).name, *(["report.html"] if "--report" in given else [])}
        is_made = (status, {path.name for path in made}) == (0, names) and out.startswith(given[2])
        is_refused = (status, made, out, err.count("\n")) == (2, set(), "", 1) and cell[2] in BY_CONTENT
        undecided += [] if is_made or is_refused else [(" ".join(given), status, err, sorted(path.name for path in made))]
        for path in made:
            shutil.rmtree(path) if path.is_dir() else path.unlink()
    assert undecided == [], "\n".join(map(str, undecided))
