"""Rooms of the package: a room imports only from rooms below it in this list, and importing the package takes little time.

- `__init__.py`: public names. `funcs.py`: public `wp.func`s and structs of the kernel API. Neither file defines any of them.
  `rasters.py`: another name of `city/rasters`
- `cli`: the `warpsample` command
- `viewer`: the window, and the PyVista accessor
- `bench`: benchmarks of run time and error, also of other tools
- `cluster`: calls over Dask, and calls that write Zarr stores
- `output`: files of directions and of numbers
- `city`: rasters of heights and CityJSON: reading as surfaces, and writing results
- `texture`: texels as points on a mesh, images of numbers at texels, reading and writing of .glb
- `radiation`: sun, sky patches, weather, view factors
- `plotting`: drawing of arrays by PyVista and matplotlib, which are imported lazily; it computes nothing else
- `estimate`: numbers per point (ambient occlusion, sky view, bent normals, irradiance), and the rays that are skipped
- `proof`: laws that judge a sampler, for the tests and `warpsample verify`
- `tracing`: rays against the mesh. `sight/`: visibility from a point. `wide/`: the 16-wide tree. `builtin.py`: `wp.Mesh`
- `directions`: directions at points: the call and its kernels
- `mesh`: a validated mesh, and points on it
- `distributions`: maps from the unit square to directions, one file each
- `statistics`: charts, histograms and quadrature, for proof and pictures
- `sequences`: points of the unit square, one file each
- `host`: arguments, arrays, threads, devices, memory, files
- `maths`: float32 functions that vectorise; only `wp.func`s

`viz/` has scripts that call the package. `tests/` has a file or a folder for each room.
"""

import ast
import importlib
import re
import subprocess
import sys
from functools import cache

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
    "texture",
    "city",
    "rasters",
    "output",
    "cluster",
    "bench",
    "viewer",
    "cli",
    "__main__",
    "funcs",
    "__init__",
]
"""Rooms, from the lowest to the highest."""
UNRELATED = [
    ("distributions", "mesh"),
    ("mesh", "distributions"),
    ("tracing", "distributions"),
    ("plotting", "directions"),
]


HEAVY = {
    "pyvista",
    "matplotlib",
    "scipy",
    "trimesh",
    "pxr",
    "psutil",
    "rich",
    "pvlib",
    "pandas",
    "pyradiance",
    "xatlas",
    "PIL",
    "OpenEXR",
}
"""Libraries that are imported inside functions, because they take long to import."""
NOT_EVERYWHERE = {"vtkmodules", "trame", "distributed", "xarray", "fcntl", "resource"}
"""Further libraries that are imported inside functions: parts of extras, and modules that some systems lack."""
IN_ONE_PLACE = {name: {"cluster"} for name in ("dask", "distributed", "zarr", "google_crc32c")} | {
    "xarray": {"cluster", "rasters", "sources", "estimate"}
}
IN_ONE_PLACE |= {name: {"rasters", "sources"} for name in ("rasterio", "rioxarray", "affine", "pyproj")}
"""Libraries that whole folders are based on; such a folder is imported on first use of one of its names."""
MOST_FILES = 20
"""Largest number of files in a folder, without `__init__.py`; a larger folder is divided into folders by topic."""
MOST_NOQA = 20
"""Largest number of lines with a `noqa` comment."""
SAYS_NOTHING = re.compile(r"(Of|As|Likewise|The same)\b|\S+(\s+\S+)?$")
"""First lines of docstrings that are unclear: they refer to another docstring, or have one or two words."""


@cache
def tree_of(path):
    return ast.parse(path.read_text())


def trees(folder):
    """Return (path, syntax tree) of each file."""
    return [(path, tree_of(path)) for path in sorted(folder.rglob("*.py"))]


@cache
def imports(path):
    """Return (module, when) of each import: "first" with the file, "late" inside a function, or only for "types"."""
    tree = tree_of(path)
    typing_only = {
        id(child)
        for node in ast.walk(tree)
        if isinstance(node, ast.If) and getattr(node.test, "id", "") == "TYPE_CHECKING"
        for child in ast.walk(node)
    }
    top = {id(node) for node in tree.body}
    found = []
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{path}: relative import"
            names = [node.module] + ([f"warpsample.{a.name}" for a in node.names] if node.module == "warpsample" else [])
        else:
            continue
        when = "types" if id(node) in typing_only else "first" if id(node) in top else "late"
        found += [(name, when) for name in names]
    return found


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


def test_nothing_but_tracing_knows_the_wide_tree(repository):
    """Other rooms use `tracing.sight`, and users call `trace` and `tree`. So the tree can be changed in one place."""
    package = repository / "warpsample"
    for path in sorted(package.rglob("*.py")):
        if path.relative_to(package).parts[0] != "tracing":
            inner = [module for module, _ in imports(path) if module.startswith("warpsample.tracing.wide")]
            assert inner == [], f"{path} imports {inner}"


def test_the_map_names_every_room_once(repository):
    named = re.findall(r"^- `(\w+)", __doc__, flags=re.MULTILINE)
    folders = {path.parent.name for path in (repository / "warpsample").glob("*/__init__.py")}
    assert sorted(named[1:]) == sorted(folders)
    assert named[1:] == [room for room in reversed(ROOMS) if room in folders]


def test_heavy_libraries_are_imported_where_they_are_used(repository):
    for path in sorted((repository / "warpsample").rglob("*.py")):
        for module, when in imports(path):
            if (path.stem, module) == ("accessor", "pyvista"):
                continue  # PyVista imports it, and nothing here does
            assert not (when == "first" and module.split(".")[0] in HEAVY), f"{path} imports {module} when it is imported"
            where = IN_ONE_PLACE.get(module.split(".")[0], {path.parent.name})
            assert path.parent.name in where, f"{path} imports {module}"


def test_files_with_kernels_keep_their_annotations(repository):
    for path in sorted((repository / "warpsample").rglob("*.py")):
        assert "from __future__ import annotations" not in path.read_text()


def test_no_files_import_each_other(repository):
    """Code that two files share belongs into a third file below both; imports for types count as well."""
    package = repository / "warpsample"
    names = {".".join(path.relative_to(repository).with_suffix("").parts): path for path in package.rglob("*.py")}
    below = {name: {module for module, _ in imports(path) if module in names} for name, path in names.items()}
    grown = True
    while grown:
        wider = {name: found.union(*(below[other] for other in found)) for name, found in below.items()}
        grown, below = wider != below, wider
    assert [name for name, found in below.items() if name in found] == []


def host_functions(tree):
    """Return the functions that Python runs; functions that Warp compiles cannot have keyword-only parameters."""
    for node in ast.walk(tree):
        if isinstance(node, ast.FunctionDef):
            decorators = {ast.unparse(decorator).split("(")[0] for decorator in node.decorator_list}
            if not decorators & {"wp.func", "wp.kernel", "wp.func_grad"}:
                yield node


def test_functions_of_six_parameters_take_some_by_keyword(repository):
    """A call with six positional arguments does not show the meaning of each argument."""
    package = repository / "warpsample"
    files = sorted(package.rglob("*.py"))
    for path in files:
        for function in host_functions(tree_of(path)):
            taken = function.args
            named = f"{path.relative_to(package)}: {function.name}"
            assert taken.kwonlyargs or len(taken.posonlyargs) + len(taken.args) < 6, named


def test_nothing_is_called_utils(repository):
    for path in (repository / "warpsample").rglob("*.py"):
        assert path.stem not in ("utils", "common", "misc", "helpers")


def test_modules_of_calls_are_imported_by_their_names_and_lazily(child_environment):
    """`import warpsample.rasters` gives the object of `from warpsample import rasters`, and no heavy library."""
    code = (
        "import sys, warpsample.rasters, warpsample.cluster; heavy = {'xarray', 'rasterio', 'dask', 'warp'}; "
        "print(sorted(heavy & set(sys.modules))); import warpsample.funcs; from warpsample import cluster, funcs, rasters; "
        "from warpsample.rasters import surface; modules = (cluster, funcs, rasters); import warpsample.city.rasters; "
        "print(all(m is sys.modules['warpsample.' + m.__name__.rpartition('.')[2]] for m in modules), "
        "rasters is warpsample.rasters is warpsample.city.rasters, rasters.surface is surface)"
    )
    done = subprocess.run([sys.executable, "-c", code], env=child_environment, capture_output=True, text=True, check=True)
    assert (done.stdout, done.stderr) == ("[]\nTrue True True\n", "")


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

    nodes = ast.parse((repository / "warpsample/__init__.pyi").read_text()).body
    seen = {alias.asname: node.module for node in nodes if isinstance(node, ast.ImportFrom) for alias in node.names}
    assert sorted(seen) == sorted(ws.__all__)
    for name, home in seen.items():
        assert getattr(importlib.import_module(home), name) is getattr(ws, name)
    assert set(ws.__all__) <= set(dir(ws))
    with pytest.raises(AttributeError, match="no attribute 'nothing'"):
        ws.nothing  # noqa: B018


def test_every_distribution_and_sequence_has_its_names_and_its_twin():
    """Check the steps that the READMEs list for a new distribution or sequence, besides its own file."""
    import warpsample as ws
    from warpsample import distributions, funcs
    from warpsample.proof import twins
    from warpsample.proof.twins import sequences as integer_twins

    assert set(distributions.classes()) <= set(ws.__all__)
    assert set(distributions.names()) == twins.names()
    assert set(ws.sequences.names()) == integer_twins.names()
    kinds = distributions.classes().values()  # maps of lobes of lobes are made for each nested lobe, of functions in funcs
    cases = [case.maps for kind in kinds for case in kind.cases() if not case.nested]
    maps = {func.key for case in cases for func in (case.sample, case.pdf, case.invert) if func is not None}
    assert maps | set(ws.sequences.names()) <= set(funcs.__all__)
    assert set(funcs.__all__) <= set(dir(funcs))


def test_public_names_are_documented():
    import warpsample as ws

    assert sorted(ws.__all__, key=str) == sorted(n for n in ws.__all__ if hasattr(ws, n))
    for name in ws.__all__:
        assert getattr(ws, name).__doc__, name


def test_the_first_line_of_a_docstring_is_a_full_phrase(repository):
    """This includes `tests/support`, whose functions are read without the test that calls them."""
    kinds = ast.Module | ast.ClassDef | ast.FunctionDef
    found = [
        f"{path.relative_to(repository)}: {text.splitlines()[0]}"
        for folder in (repository / "warpsample", repository / "tests/support")
        for path, tree in trees(folder)
        for node in ast.walk(tree)
        if isinstance(node, kinds) and (text := ast.get_docstring(node)) and SAYS_NOTHING.match(text.splitlines()[0])
    ]
    assert found == []
    assert all(
        map(SAYS_NOTHING.match, ("Of the command.", "As `FileIO.write`.", "Likewise of one.", "The same.", "1.", "A b."))
    )


def test_each_class_has_its_own_name(repository):
    homes = {}
    for path, tree in trees(repository / "warpsample"):
        for node in ast.walk(tree):
            if isinstance(node, ast.ClassDef):
                homes.setdefault(node.name, []).append(str(path.relative_to(repository)))
    assert len(homes) > 100
    assert {name: files for name, files in homes.items() if len(files) > 1} == {}


def test_no_folder_holds_more_files_than_one_sees_at_once(repository):
    for folder in (repository / "warpsample", *(repository / "warpsample").rglob("*/")):
        files = [path.name for path in folder.glob("*.py") if path.name != "__init__.py"]
        assert len(files) <= MOST_FILES, f"{folder} holds {len(files)} files"


def test_what_is_imported_late_is_heavy_or_missing_on_some_machines(repository):
    """All other imports are at the top of the file, so that cycles of files are found; see pyproject.toml."""
    for room in ROOMS[: ROOMS.index("bench")]:
        for path in sorted((repository / "warpsample" / room).rglob("*.py")):
            if path.name == "__init__.py":
                continue
            for module, when in imports(path):
                assert when != "late" or module.split(".")[0] in HEAVY | NOT_EVERYWHERE, f"{path} imports {module} late"


def test_few_lines_are_kept_from_the_linter(repository):
    kept = sum(path.read_text().count("# noqa") for path in (repository / "warpsample").rglob("*.py"))
    assert 0 < kept <= MOST_NOQA


def test_only_benchmarks_wait_for_the_import_of_benchmarks(child_environment):
    code = "import sys, warpsample.cli.commands; print({'warpsample.bench', 'warpsample.cli.bench'} & set(sys.modules))"
    done = subprocess.run([sys.executable, "-c", code], env=child_environment, capture_output=True, text=True, check=True)
    assert (done.stdout, done.stderr) == ("set()\n", "")
