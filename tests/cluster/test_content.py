"""What tells runs apart is what they hold: the sources and the numbers of functions, and the numbers of their data."""

import importlib.util
import subprocess
import sys
from importlib import import_module

import numpy as np
import pytest
import warp as wp

import warpsample as ws
from warpsample import cluster

dask = pytest.importorskip("dask")
pytest.importorskip("zarr")
xr = pytest.importorskip("xarray")
content = import_module("warpsample.estimate.source.content")
store = import_module("warpsample.cluster.store")

SOURCE = """
import warp as wp
from warpsample import funcs

SCALE, SHIFT, TABLE = 2.0, wp.vec3(0.0, 0.0, 1.0), [1.0, 3.0]


class Settings:
    gain = 1.0


@wp.struct
class Sun:
    direction: wp.vec3
    turn: wp.mat22
    half: wp.float16


@wp.struct
class Sky:
    zenith: wp.float32
    lit: wp.bool
    sun: Sun
    table: wp.array[wp.float32]
    mesh: wp.uint64


@wp.func
def raised(x: wp.vec3):
    return SCALE * x[0]


@wp.func
def raised(x: float):
    return SCALE * x + SHIFT[2] + Settings.gain


@wp.func
def sky(w: wp.vec3, lobe: funcs.Lobe, data: Sky) -> float:
    return raised(data.zenith) + wp.static(TABLE[1])


@wp.func
def through(w: wp.vec3, lobe: funcs.Lobe, data: Sky) -> float:
    return data.zenith + wp.where(wp.mesh_query_ray_anyhit(data.mesh, lobe.normal, w, 1.0), 0.0, 1.0)
"""
POINTS = ws.SurfacePoints(np.zeros((30, 3)), np.tile(np.float32([0, 0, 1]), (30, 1)))


@pytest.fixture
def defined(tmp_path):
    """Loads the source, with words replaced, as the module `skies`."""
    made = []

    def load(*replaced):
        text = SOURCE
        for old, new in replaced:
            assert old in text
            text = text.replace(old, new)
        file = tmp_path / f"skies_{len(made)}.py"  # Python keeps the lines of a file
        file.write_text(text)
        specification = importlib.util.spec_from_file_location("skies", file)
        made.append(importlib.util.module_from_spec(specification))
        specification.loader.exec_module(made[-1])
        return made[-1]

    return load


def sky_of(module):
    data = module.Sky()
    data.zenith, data.sun.direction = 1.0, wp.vec3(0.0, 0.0, 1.0)
    data.table = wp.array([1.0, 2.0], dtype=wp.float32, device="cpu")
    return data


@pytest.mark.parametrize(
    ("old", "new", "changed"),
    [
        ("data.zenith)", "-data.zenith)", "sky"),
        ("SCALE *", "3.0 * SCALE *", "raised"),
        ("SCALE, SHIFT, TABLE = 2.0", "SCALE, SHIFT, TABLE = 2.5", "raised"),
        ("wp.vec3(0.0, 0.0, 1.0)", "wp.vec3(0.0, 0.0, 2.0)", "raised"),
        ("gain = 1.0", "gain = 2.0", "raised"),
        ("[1.0, 3.0]", "[1.0, 4.0]", "sky"),
        ("half: wp.float16", "half: wp.float32", "sky"),
        ("return SCALE * x[0]", "return x[0]", "raised"),
    ],
)
def test_a_function_is_its_source_and_all_that_it_names(defined, old, new, changed):
    before, after = (content.function_content(defined(*replaced).sky) for replaced in ((), ((old, new),)))
    assert content.function_content(defined().sky) == before
    assert content.difference("integrand", before, after) == f"integrand: the function skies.{changed} changed"


@pytest.mark.parametrize(
    ("held", "read"),
    [
        ("TABLE = [raised, 2.0, lower]", "wp.static(TABLE[2])(wp.static(TABLE[1]))"),
        ("TABLE = {'a': (raised,), 'b': {lower: 2.0}}", "wp.static(next(iter(TABLE['b'])))(wp.static(TABLE['b'][lower]))"),
    ],
)
def test_a_function_that_names_others_in_a_list_is_its_own_self_and_theirs(defined, held, read):
    """As Dask tells such a list, it differs from itself."""
    lower = "@wp.func\ndef lower(x: float):\n    return x - 1.0\n\n\n" + held + "\n\n\n@wp.func\ndef sky("
    listed = (("@wp.func\ndef sky(", lower), ("wp.static(TABLE[1])", read))
    before = content.function_content(defined(*listed).sky)
    assert content.function_content(defined(*listed).sky) == before
    for other, changed in ((("x - 1.0", "x - 3.0"), "lower"), ((" 2.0", " 4.0"), "sky")):
        after = content.function_content(defined((listed[0][0], lower.replace(*other)), listed[1]).sky)
        assert content.difference("integrand", before, after) == f"integrand: the function skies.{changed} changed"


def test_two_functions_of_one_name_are_both_reported(defined):
    maker = "def made(k):\n    @wp.func\n    def one(x: float):\n        return x * wp.static(k)\n    return one\n\n\n"

    def describe(first, second):
        both = maker + f"one, two = made({first}), made({second})\n\n\n@wp.func\ndef sky("
        return content.function_content(defined(("@wp.func\ndef sky(", both), ("raised(data", "one(1.0) + two(data")).sky)

    assert describe(1.0, 2.0) == describe(1.0, 2.0)
    assert len({str(describe(*numbers)) for numbers in ((1.0, 2.0), (3.0, 2.0), (1.0, 3.0))}) == 3


@pytest.mark.slow
def test_a_function_in_another_process_is_the_same(defined, tmp_path, child_environment):
    module = defined()
    code = (
        "import sys; sys.path.insert(0, sys.argv[1]); import skies_0 as skies; "
        "from warpsample.estimate.source.content import function_content; "
        "print(*sorted(function_content(skies.sky).values()), file=sys.stderr)"
    )
    environment = {**child_environment, "PYTHONHASHSEED": "1"}  # of Python's own hashes; here it is random
    command = [sys.executable, "-c", code, str(tmp_path)]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    found = done.stderr.splitlines()[-1].split()
    assert set(content.function_content(module.sky).values()) - {"skies.sky"} == set(found) - {"skies_0.sky"}


@pytest.mark.parametrize(
    ("change", "field"),
    [
        (lambda data: setattr(data, "zenith", 1.0000001), "zenith"),
        (lambda data: setattr(data, "zenith", float("nan")), "zenith"),
        (lambda data: setattr(data, "lit", True), "lit"),
        (lambda data: data.sun.direction.__setitem__(1, 2.0), "sun.direction"),
        (lambda data: data.sun.turn.__setitem__((0, 1), 2.0), "sun.turn"),
        (lambda data: setattr(data.sun, "half", 0.5), "sun.half"),
        (lambda data: data.table.fill_(3.0), "table"),
        (lambda data: setattr(data, "table", None), "table"),
        (lambda data: setattr(data, "mesh", 7), "mesh"),
    ],
)
def test_data_are_all_their_numbers(defined, change, field):
    module = defined()
    data = sky_of(module)
    before = content.data_content(data, module.sky)
    assert content.data_content(sky_of(defined()), module.sky) == before
    change(data)
    after = content.data_content(data, module.sky)
    assert content.difference("data", before, after) == f"data: other numbers in its field {field!r}"


def test_what_is_behind_an_address_equals_nothing(defined):
    module = defined()
    data = sky_of(module)
    assert content.data_content(data, module.through) == content.data_content(data, module.through)
    data.mesh = 7
    found = [content.data_content(data, module.through) for _ in range(2)]
    assert content.difference("data", *found) == "data: an address in its field 'mesh', and what is there cannot be compared"


def integral(module, data, **options):
    return cluster.integrate(POINTS, module.sky, 2, data=data, chunk=20, **options)


@pytest.mark.slow
def test_names_of_tasks_are_made_of_contents(defined):
    module = defined()
    data = sky_of(module)
    names = [integral(module, given).value.data.name for given in (data, data, sky_of(module))]
    assert len(set(names)) == 1
    data.zenith = 5.0
    names.append(integral(module, data).value.data.name)
    data.table.fill_(5.0)
    names.append(integral(module, data).value.data.name)
    module.SCALE = 3.0
    names.append(integral(module, data).value.data.name)
    assert len(set(names)) == 4


@pytest.mark.slow
def test_a_lazy_dataset_computes_what_was_given(mesh):
    """Everything that a call takes changes in place before it is computed."""
    points, picture = ws.sample_surface(mesh, 30), np.ones((4, 8), np.float32)
    up, way, active = np.array([0.0, 0.0, 1.0]), ws.sample_directions(points, 2).vectors, np.ones(30, bool)
    eye = np.array([36.0, 36.0, 9.0])
    calls = [
        lambda room: room.irradiance(mesh, points, picture, 8, up=up, active=active),
        lambda room: room.trace(mesh, points, way),
        lambda room: room.trace(mesh, eye, points.normal),
    ]
    right, lazy = [call(ws) for call in calls], [call(cluster) for call in calls]
    for array in (points.position, points.normal, picture, way, eye):
        np.add(array, 1.0, out=array)
    up[0], active[:] = 3.0, False
    with dask.config.set(scheduler="sync"):
        for one, other in zip(right, lazy, strict=True):
            name = "value" if hasattr(one, "value") else "distance"
            assert np.array_equal(other[name], getattr(one, name), equal_nan=True)


@pytest.mark.slow
def test_so_it_does_with_data_and_refuses_another_function(defined):
    module = defined()
    data = sky_of(module)
    with dask.config.set(scheduler="sync"):
        before = integral(module, data)
        data.zenith = 5.0
        assert set(before.value.to_numpy()) == {2.0 * 1.0 + 1.0 + 1.0 + 3.0}
        assert set(integral(module, data).value.to_numpy()) == {2.0 * 5.0 + 1.0 + 1.0 + 3.0}
        module.SCALE = 3.0
        with pytest.raises(ValueError, match=r"^integrand: the function skies.raised changed since the call"):
            before.compute()


@pytest.mark.slow
def test_a_store_of_other_numbers_is_not_resumed(defined, path):
    module = defined()
    data = sky_of(module)

    def bake(integrand, given):
        return cluster.bake(path, "integrate", POINTS, integrand, 2, data=given, chunk=20, resume=True)

    with dask.config.set(scheduler="sync"):
        assert set(bake(module.sky, data).value.to_numpy()) == {7.0}
        again = defined()
        bake(again.sky, sky_of(again))
        data.sun.direction = wp.vec3(1.0, 0.0, 0.0)
        with pytest.raises(
            ValueError, match=r"out.zarr' of another run; data: other numbers in its field 'sun.direction'; repeat"
        ):
            bake(module.sky, data)
        other = defined(("SCALE *", "5.0 *"))
        with pytest.raises(
            ValueError, match=r"out.zarr' of another run; integrand: the function skies.raised changed; repeat"
        ):
            bake(other.sky, sky_of(other))
        other = defined(("def sky", "def heaven"))
        with pytest.raises(ValueError, match=r"integrand: it was skies.sky, and is skies.heaven;"):
            bake(other.heaven, sky_of(other))


LOBE = """
from dataclasses import dataclass
import warp as wp
from warpsample.distributions.record import Distribution, Maps
@wp.func
def square_to_own(u: wp.vec2) -> wp.vec3:
    return wp.normalize(wp.vec3(u[0], u[1], 1.0))
@wp.func
def square_to_own_pdf(w: wp.vec3) -> wp.float32:
    return 1.0
@dataclass(frozen=True)
class Own(Distribution):
    name, density, measure, support, source = "own", "1", "per steradian", "up", "this test"
    maps = Maps(square_to_own, square_to_own_pdf)
"""


@pytest.mark.slow
def test_a_store_by_another_lobe_of_the_same_name_is_not_resumed(defined, path, monkeypatch):
    def bake(module):
        lobe = {"distribution": module.Own(), "chunk": 20, "resume": True}
        return cluster.bake(path, "sample_directions", np.eye(3), 2, **lobe)

    monkeypatch.setitem(globals(), "SOURCE", LOBE)
    with dask.config.set(scheduler="sync"):
        bake(defined())
        bake(defined())
        with pytest.raises(
            ValueError, match=r"out.zarr' of another run; distribution: the function \S*square_to_own changed; repeat"
        ):
            bake(defined(("u[1], 1.0", "u[1], 2.0")))


@pytest.mark.slow
def test_a_store_of_other_streams_is_not_resumed(path, mesh, monkeypatch):
    def bake():
        return cluster.bake(path, "ambient_occlusion", mesh, 30, 2, resume=True)

    bake()
    job = import_module("warpsample.cluster.job")
    monkeypatch.setattr(job, "STREAMS", 7)
    with pytest.raises(ValueError, match=r"with random numbers of version 4, want version 7, which gives"):
        bake()
    file = path / "zarr.json"
    assert '"streams": 4,' in file.read_text()
    file.write_text(file.read_text().replace('"streams": 4,', ""))  # as it was made before streams had numbers
    with pytest.raises(ValueError, match=r"with random numbers of version 1, want version 7"):
        bake()


@pytest.mark.parametrize(
    "lobe",
    [
        lambda path: f"environment_map(picture={str(path)!r})",
        lambda path: ws.Mixture((ws.EnvironmentMap(path), ws.CosineHemisphere()), (1.0, 1.0)),
    ],
)
def test_a_picture_of_the_same_name_is_another_run(tmp_path, lobe):
    picture, path = tmp_path / "sky.npy", tmp_path / "d.zarr"

    def baked(**more):
        return cluster.bake(path, "sample_directions", np.eye(3), 2, distribution=lobe(picture), **more)

    with dask.config.set(scheduler="sync"):
        np.save(picture, np.ones((2, 4)))
        first = baked().vectors
        assert np.array_equal(baked(resume=True).vectors, first)
        np.save(picture, np.eye(2, 4))
        with pytest.raises(ValueError, match=r"of pictures \['.*, want a store of pictures \['"):
            baked(resume=True)
