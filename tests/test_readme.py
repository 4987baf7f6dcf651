"""The code blocks of the README run unchanged."""

import inspect
import re
import sys

import pytest
import warp as wp
from page_reader import Reader

import warpsample as ws
from warpsample.cli import bake, commands
from warpsample.output.quantities import quantities
from warpsample.proof import defects, report
from warpsample.proof.evidence import Evidence, Subject
from warpsample.viewer.accessor import WarpsampleAccessor

ROOMS = (
    "distributions",
    "sequences",
    "tracing",
    "estimate",
    "proof",
    "bench",
    "output",
    "radiation",
    "city",
    "city/cityjson",
    "texture",
)


def documents(repository):
    """Return the top README and the READMEs that it links to."""
    rooms = [repository / "warpsample" / room for room in ROOMS]
    return [folder / "README.md" for folder in (repository, *rooms, repository / "viz")]


def blocks(repository, language):
    text = "\n".join(path.read_text() for path in documents(repository))
    return re.findall(rf"^```{language}\n(.*?)^```", text, flags=re.DOTALL | re.MULTILINE)


def test_links_lead_to_files(repository):
    for path in documents(repository):
        links = re.findall(r"\]\(([^)#]+)\)", path.read_text())
        assert [link for link in links if "://" not in link and not (path.parent / link).exists()] == []
    first, *others = documents(repository)
    shown = re.findall(r"\]\(([^)]+README.md)\)", first.read_text())
    apart = repository / "warpsample" / "cluster" / "README.md"  # which tests/cluster runs, of fewer points
    assert {repository / link for link in shown} == {*others, apart}


def test_what_is_said_to_take_warp_arrays_takes_them(repository):
    page = (repository / "warpsample" / "tracing" / "README.md").read_text()
    said = re.search(r"## CUDA\n\n(.*?) take `wp.array`s", page, flags=re.DOTALL)[1]
    devices = {"sample_directions": ws.sample_directions(wp.ones(1, dtype=wp.vec3, device="cpu"), 1).vectors.device}
    ray = wp.ones(1, dtype=wp.vec3, device="cpu")
    devices["trace"] = ws.trace(ws.load_mesh("courtyard"), ray, ray).distance.device
    assert sorted(re.findall(r"`(\w+)`", said)) == sorted(devices)


def test_the_first_page_is_short(repository):
    assert len((repository / "README.md").read_text().splitlines()) <= 120


@pytest.mark.parametrize(
    ("index", "expected"),
    [
        (1, r"^\(10000, 64, 3\) \(10000, 64\)\nsky view 0\.63, standard error 0\.003\d\n$"),
        *(
            pytest.param(*block, marks=pytest.mark.slow)
            for block in (
                (0, r"^(.*\n)*\[ *-?\d\.?\d*(e-\d+)? +-?\d\.?\d*(e-\d+)? +(0\.666\d*|6\.66\d*e-01)\]\n$"),
                (2, r"^\[ True  True  True  True\] \(4, 2\)\n$"),
                (3, r"^\{'OK': 676, 'INVALID_PARAMETER': 324\}\n$"),
                (4, r"^\(1000, 64, 3\)\n$"),
                (5, r"^0\.94\n$"),
                (6, r"^\(1000, 64, 3\)\n$"),
                (7, r"^\(1000, 64, 3\) True\n$"),
                # 8 and 9, a lobe and its better formulas: tests/proof/test_own.py
                (10, r"^\(2, 256, 2\)\n$"),
                (11, r"^0\.70\n$"),
                (12, r"^\(2080,\) 0\.62 True\n$"),
                (13, r"^\(2080,\) 2\.7\n$"),
                (14, r"^\(2080,\) 270 kWh/m2\n\(2080, 24\) 2021-06-21T12:00\n$"),
                (15, r"^\(2080,\) True\n$"),
                (16, r"^\(2080, 145\) True\n$"),
                (17, r"^0\.09 of the irradiation is reflected\n$"),
                (18, r"^True 1\.0\n3\.9 W/m2, 1\.7 without other faces\n$"),
                (19, r"^0\.26 ± 0\.00\d, EPSG:3794\n0\.2\d to 0\.2\d\n4 of 15 hours\n$"),
                (20, r"^\['' 'RoofSurface' 'WallSurface'\] \[0\.74 0\.91 0\.42\] True\n$"),
                (21, r"^\(256, 256\) 0 True\n$"),
                (22, r"^0\.7[45]\d* 6400\n$"),
            )
        ),
    ],
)
def test_python_blocks_run_and_print_what_they_say(index, expected, repository, tmp_path, monkeypatch, call, capsys):
    found = blocks(repository, "python")
    assert len(found) == 23
    monkeypatch.chdir(tmp_path)
    reader = Reader(f"block_{index}", tmp_path, call)
    monkeypatch.setitem(sys.modules, reader.module.__name__, reader.module)
    assert re.match(expected, printed := reader.python(found[index], capsys)), printed


def test_shell_blocks_are_the_commands_that_are_tested(repository):
    commands = [line for block in blocks(repository, "sh") for line in block.splitlines()]
    assert commands == [
        "pip install '.[viz]'  # in a clone of this repository",  # .ci/run, with the tests' extra
        "warpsample view",  # .ci/run, by its script and with --screenshot
        "warpsample bake courtyard -o sky.ply --quantity sky --samples 256",  # below
        "warpsample bake dsm.tif -o svf.tif --quantity sky",  # tests/cluster/test_raster_command.py
        "warpsample bake in.glb -o out.glb --texture 1024 --samples 256",  # tests/texture
        "python3 -m venv .venv && . .venv/bin/activate",  # these: .ci/run
        "pip install '.[viz,test]'",
        "python viz/direction_clouds.py --screenshot direction_clouds.png  # the picture above",  # test_plotting.py, too
        "pytest",  # this
        "warpsample verify",  # test_verify.py, on fewer cases
        "warpsample verify --power",
        "warpsample bench peers",  # these: tests/bench/test_command.py, on what was measured before
        "warpsample bench city --raster dsm.tif",
        "warpsample bench all --write",
        "warpsample info courtyard",
        "warpsample directions courtyard -o directions.npz --points 10000 --samples 64",
        "warpsample bake courtyard -o sky.ply --quantity sky --samples 256",
        "warpsample bake courtyard -o year.vtp --quantity irradiation --weather athens --at faces",
        "warpsample view courtyard --screenshot clouds.html",
        # these: tests/cluster/test_raster_command.py
        "warpsample bake dsm.tif -o svf.tif --quantity sky --tile 1024 --margin 256 --far alps_25m.tif --processes 2",
        "warpsample bake dsm.tif -o svf.tif --quantity sky --tile 1024 --margin 256 --far alps_25m.tif --resume",
        "warpsample bake tile.city.jsonl -o out.city.jsonl --quantity sky --samples 256",  # these: test_by_parts.py
        "warpsample bake tile.city.jsonl -o year.csv --quantity irradiation --weather athens --split",
        # these: tests/texture
        "warpsample bake in.glb -o out.glb --texture 1024 --samples 256          # occlusion into every material",
        "warpsample bake in.obj -o ao.png --texture 1024 --supersample 4         # means over whole texels",
        "warpsample bake in.glb -o light.exr --texture 512 --quantity irradiance --environment sky.hdr --uv 1",
        "warpsample bake low.glb -o out.glb --texture 1024 --quantity normals --high high.ply --cage 0.02",
        "python viz/gallery.py",  # test_gallery.py, without the benchmarks
        'warpsample view statue.ply --distribution "visible_ggx(alpha=@roughness)"',  # test_own_lobes.py
        "python viz/shirley_overlay.py --screenshot shirley_overlay.png",  # these: test_plotting.py
        "python viz/offset_family.py --screenshot offset_family.png",
        "python viz/sequences.py --screenshot sequences.png",
        "python viz/own_lobes.py --screenshot own_lobes.png",  # test_own_lobes_picture.py
        "python viz/occlusion.py --screenshot occlusion.png",
        "python viz/baked_texture.py --screenshot baked_texture.png",
        "python viz/sun_and_sky.py --screenshot sun_and_sky.png",
        "python viz/environment_map.py --screenshot environment_map.png",  # test_environment_picture.py
        "python viz/view_factors.py --screenshot view_factors.png",
        "python viz/baked_store.py --screenshot baked_store.png",
        "python viz/maps.py --screenshot maps.png",
        "python viz/light_between.py --screenshot light_between.png",
        "python viz/glossy_reflection.py --screenshot glossy_reflection.png",  # these: test_own_kernels.py
        "python viz/direct_light.py --screenshot direct_light.png",
    ]


def test_options_and_calls_are_those_of_the_commands_and_the_accessor(repository):
    output = (repository / "warpsample" / "output" / "README.md").read_text()
    said = re.search(r"^(.*) also\ntake `--at", output, flags=re.MULTILINE)[1].split(". ")[-1]
    parameters = {name.removesuffix("_command"): inspect.signature(call).parameters for name, call in vars(commands).items()
                  if inspect.isfunction(call) and call.__module__ in (commands.__name__, bake.__name__)}  # fmt: skip
    assert re.findall(r"`(\w+)`", said) == sorted((n for n, given in parameters.items() if "at" in given), reverse=True)
    calls = re.search(
        r"^`mesh.warpsample` has (.*) and a method", (repository / "viz" / "README.md").read_text(), flags=re.MULTILINE
    )[1]
    public = {name for name, call in vars(WarpsampleAccessor).items() if inspect.isfunction(call) and name[0] != "_"}
    of_quantities = {quantity.call.__name__ for quantity in quantities().values() if quantity.in_stores}
    assert set(re.findall(r"`(\w+)`", calls)) == public - of_quantities


@pytest.mark.slow
def test_mesh_commands_run(repository, tmp_path, call, can_render, monkeypatch):
    """The commands run in this process, which has loaded the kernels already."""
    monkeypatch.chdir(tmp_path)
    lines = [line for block in blocks(repository, "sh") for line in block.splitlines() if "courtyard" in line]
    assert [line.split()[1] for line in lines] == ["bake", "info", "directions", "bake", "bake", "view"]
    for line in lines[1:]:
        assert call(*line.split()[1:])[0] == 0
    assert {path.name for path in tmp_path.iterdir()} == {"directions.npz", "sky.ply", "year.vtp", "clouds.html"}


_FIGURE = r"(\d\.\de-\d\d|–)"
ERRORS = re.compile(rf"\| {_FIGURE}, {_FIGURE}, {_FIGURE}, {_FIGURE} \|")


def table_of_distributions(repository):
    """Return the lines of the page's table, and those that the registry has, which have no figures."""
    lines = (repository / "warpsample/distributions/README.md").read_text().splitlines()
    expected = report.markdown([]).splitlines()
    start = lines.index(expected[0])
    return lines[start : start + len(expected)], expected


def test_the_table_of_distributions_is_that_of_the_registry(repository):
    shown, expected = table_of_distributions(repository)
    assert [ERRORS.sub("| –, –, –, – |", line) for line in shown] == expected


@pytest.mark.thorough
def test_the_figures_of_the_table_of_distributions_are_right(repository):
    shown, _ = table_of_distributions(repository)
    for line in shown[2 : 2 + len(ws.distributions.names())]:
        kind = getattr(ws, re.match(r"\| `(\w+)\(", line)[1])
        found = [
            worst_errors(case) for case in kind.cases() if case.name != "visible_beckmann" or case.view == (1.0, 0.0, 0.0)
        ]
        for law, figure_shown, limit in zip(
            ("length", "angle", "pdf", "round trip"),
            ERRORS.search(line).groups(),
            (kind.worst_unit_length, kind.worst_angle, kind.worst_pdf, kind.worst_round_trip),
            strict=True,
        ):
            measured = [errors_of_case[law] for errors_of_case in found if law in errors_of_case]
            assert (figure_shown == "–") == (not measured)
            if measured:
                # The README's figure is over all variates, rounded to two digits; this one over every 256th.
                assert max(measured) * 0.95 <= float(figure_shown) <= limit


def worst_errors(case):
    return Evidence(Subject(repr(case), case, case), every=256).sweep


def test_every_sequence_is_in_the_readme(repository):
    text = (repository / "warpsample/sequences/README.md").read_text()
    for name in ws.sequences.names():
        assert f"`{name}`" in text


def test_the_count_of_defects_is_true(repository):
    assert f"on {len(defects.names())} wrong samplers" in (repository / "warpsample/proof/README.md").read_text()
