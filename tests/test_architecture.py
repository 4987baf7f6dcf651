"""The map of the house: a room imports only from rooms below it in this list, and importing the package is light.

- `__init__.py`: the public names; `funcs.py`: the public `wp.func`s and structs of the kernel API; neither defines any
- `cli`: the `warpsample` command
- `viewer`: the window and the PyVista accessor
- `bench`: run time against error, and other tools side by side
- `cluster`: the calls over Dask, and into Zarr stores
- `output`: files of directions and of numbers
- `radiation`: sun, sky patches, weather, view factors
- `plotting`: arrays to PyVista actors and matplotlib figures, imported lazily; computes nothing else
- `estimate`: numbers per point (ambient occlusion, sky view, bent normals, irradiance); what is skipped
- `proof`: the laws that judge a sampler, for the tests and `warpsample verify`
- `tracing`: rays against the mesh; `wide/` is the 16-wide tree, `builtin.py` is `wp.Mesh`
- `directions`: directions at points: the call and its kernels
- `mesh`: a validated mesh and points on it
- `distributions`: from the unit square to a direction, a file each
- `statistics`: charts, histograms and quadrature, for proof and pictures
- `sequences`: points of the unit square, a file each
- `host`: arguments, arrays, threads, devices, memory, files
- `maths`: float32 building blocks that vectorise, nothing but `wp.func`s

`viz/` has scripts that call the package; `tests/` has a file or folder for each room.
"""

import ast
import importlib
import re
import subprocess
import sys

import pytest

ROOMS = [
    "maths",
    "host",
    "sequences",
    "statistics",
    "distributions",
    "mesh",
    "directions",
    "tracing",
    "proof",
    "estimate",
    "plotting",
    "radiation",
    "output",
    "cluster",
    "bench",
    "viewer",
    "cli",
    "__main__",
    "funcs",
    "__init__",
]
"""From the lowest up."""
UNRELATED = [
    ("distributions", "mesh"),
    ("mesh", "distributions"),
    ("tracing", "distributions"),
    ("plotting", "directions"),
]


def imports(path):
    """(module, whether it happens when the file is imported) of each import."""
    tree = ast.parse(path.read_text())
    typing_only = {
        id(child)
        for node in ast.walk(tree)
        if isinstance(node, ast.If) and getattr(node.test, "id", "") == "TYPE_CHECKING"
        for child in ast.walk(node)
    }
    top = {id(node) for node in tree.body}
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{path}: relative import"
            names = [node.module] + ([f"warpsample.{a.name}" for a in node.names] if node.module == "warpsample" else [])
        else:
            continue
        for name in names:
            yield name, id(node) in top and id(node) not in typing_only


def room_of(module):
    parts = module.split(".")
    return parts[1] if parts[0] == "warpsample" and len(parts) > 1 else None


def test_rooms_import_only_from_rooms_below(repository):
    package = repository / "warpsample"
    files = sorted(package.rglob("*.py"))
    assert len(files) > 20
    for path in files:
        room = path.relative_to(package).parts[0].removesuffix(".py")
        assert room in ROOMS, f"{path.name} is in no room"
        for module, _ in imports(path):
            other = room_of(module)
            if other in ROOMS and other != room:
                assert ROOMS.index(other) < ROOMS.index(room), f"{path} imports {module}, which is above it"
                assert (room, other) not in UNRELATED, f"{path} imports {module}"


def test_the_map_names_every_room_once(repository):
    named = re.findall(r"^- `(\w+)", __doc__, flags=re.MULTILINE)
    folders = {path.parent.name for path in (repository / "warpsample").glob("*/__init__.py")}
    assert sorted(named[1:]) == sorted(folders)
    assert named[1:] == [room for room in reversed(ROOMS) if room in folders]


def test_heavy_libraries_are_imported_where_they_are_used(repository):
    heavy = {"pyvista", "matplotlib", "scipy", "trimesh", "pxr", "psutil", "rich", "pvlib", "pandas", "pyradiance"}
    for path in sorted((repository / "warpsample").rglob("*.py")):
        for module, at_top in imports(path):
            if (path.stem, module) == ("accessor", "pyvista"):
                continue  # PyVista imports it, and nothing here does
            assert not (at_top and module.split(".")[0] in heavy), f"{path} imports {module} when it is imported"
            if module.split(".")[0] in {"dask", "distributed", "zarr", "xarray"}:
                assert path.parent.name == "cluster", f"{path} imports {module}"


def test_files_with_kernels_keep_their_annotations(repository):
    for path in sorted((repository / "warpsample").rglob("*.py")):
        assert "from __future__ import annotations" not in path.read_text()


def test_nothing_is_called_utils(repository):
    for path in (repository / "warpsample").rglob("*.py"):
        assert path.stem not in ("utils", "common", "misc", "helpers")


def test_import_compiles_nothing_and_touches_no_file(tmp_path, child_environment):
    code = (
        "import sys, warpsample; heavy = {'pyvista', 'matplotlib', 'scipy', 'trimesh', 'pxr', 'typer', 'dask'}; "
        "print(sorted(heavy & set(sys.modules)))"
    )
    environment = {**child_environment, "WARP_CACHE_PATH": str(tmp_path / "cache"), "PYTHONDONTWRITEBYTECODE": "1"}
    done = subprocess.run(
        [sys.executable, "-c", code], env=environment, capture_output=True, text=True, check=True, cwd=tmp_path
    )
    assert (done.stdout, done.stderr) == ("[]\n", "")
    assert list(tmp_path.rglob("*.o")) == []


def test_the_command_line_hears_signals_before_it_imports_anything(child_environment):
    code = (
        "import sys; before = set(sys.modules); import warpsample.cli.signals; "
        "print(sorted({'warp', 'numpy', 'typer', 'typing'} & (set(sys.modules) - before)))"
    )
    done = subprocess.run([sys.executable, "-c", code], env=child_environment, capture_output=True, text=True, check=True)
    assert (done.stdout, done.stderr) == ("[]\n", "")


def test_public_names_come_from_where_type_checkers_see_them(repository):
    import warpsample as ws

    block = next(n for n in ast.parse((repository / "warpsample/__init__.py").read_text()).body if isinstance(n, ast.If))
    seen = {alias.name: node.module for node in block.body for alias in node.names}
    assert sorted(seen) == sorted(ws.__all__)
    for name, home in seen.items():
        assert getattr(importlib.import_module(home), name) is getattr(ws, name)
    assert set(ws.__all__) <= set(dir(ws))
    with pytest.raises(AttributeError, match="no attribute 'nothing'"):
        ws.nothing  # noqa: B018


def test_every_distribution_and_sequence_has_its_names_and_its_twin():
    """The steps that the READMEs of the rooms list for a new one, besides its own file."""
    import warpsample as ws
    from warpsample import distributions, funcs
    from warpsample.proof import twins
    from warpsample.proof.twins import sequences as integer_twins

    assert set(distributions.classes()) <= set(ws.__all__)
    assert set(distributions.names()) == twins.names()
    assert set(ws.sequences.names()) == integer_twins.names()
    cases = [case.maps for kind in distributions.classes().values() for case in kind.cases()]
    maps = {func.key for case in cases for func in (case.sample, case.pdf, case.invert) if func is not None}
    assert maps | set(ws.sequences.names()) <= set(funcs.__all__)
    assert set(funcs.__all__) <= set(dir(funcs))


def test_public_names_are_documented():
    import warpsample as ws

    assert sorted(ws.__all__, key=str) == sorted(n for n in ws.__all__ if hasattr(ws, n))
    for name in ws.__all__:
        assert getattr(ws, name).__doc__, name
