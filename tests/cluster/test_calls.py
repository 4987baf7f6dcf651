"""The calls over Dask: lazy, checked at once, each chunk computed once, and the bits of one call."""

import ast
import inspect
import pickle
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from functools import wraps
from importlib import import_module
from threading import Barrier
from time import sleep
from types import SimpleNamespace

import numpy as np
import pytest
import warp as wp
import weights_of_tests as functions
from docstrings import failures, flaws, sections
from hangs import HANGS

import warpsample as ws
from warpsample import cluster, funcs

dask = pytest.importorskip("dask")
pytest.importorskip("xarray")
chunks, named = (import_module(f"warpsample.cluster.{name}") for name in ("chunks", "named"))

POINTS, RAYS, SEED = 130, 40, 3
ACTIVE = np.arange(POINTS) % 3 > 0
PICTURE = np.random.default_rng(0).random((8, 16, 3))


@pytest.fixture(scope="module")
def points(mesh):
    return ws.sample_surface(mesh, POINTS, seed=SEED)


@pytest.fixture(autouse=True)
def _in_this_thread():
    with dask.config.set(scheduler="sync"):
        yield


def assert_same(lazy, right):
    found = lazy.compute()
    assert set(found.data_vars) == {name for name, array in vars(right).items() if isinstance(array, np.ndarray)}
    for name, array in found.data_vars.items():
        assert array.dtype == getattr(right, name).dtype
        assert np.array_equal(array.values, getattr(right, name)), name
    return found


@pytest.mark.parametrize("chunk", [1, 60, POINTS, 65_536])
def test_chunks_change_no_bit(mesh, points, chunk):
    right = ws.ambient_occlusion(mesh, points, RAYS, seed=SEED)
    assert_same(cluster.ambient_occlusion(mesh, points, RAYS, seed=SEED, chunk=chunk), right)
    slow = cluster.ambient_occlusion(mesh, points, RAYS, seed=SEED, chunk=chunk, skip=False).compute()
    assert np.array_equal(slow.value, right.value)
    assert np.array_equal(slow.standard_error, right.standard_error)


@pytest.mark.parametrize("scheduler", ["sync", "threads"])
def test_workers_make_the_points(mesh, points, scheduler):
    with dask.config.set(scheduler=scheduler, num_workers=2):
        made = assert_same(
            cluster.ambient_occlusion(mesh, POINTS, RAYS, seed=SEED, chunk=50),
            ws.ambient_occlusion(mesh, points, RAYS, seed=SEED),
        )
    for name in ("position", "normal", "face"):
        assert np.array_equal(made[name], getattr(points, name))
        assert made[name].dtype == getattr(points, name).dtype


@pytest.mark.parametrize(("place", "make"), [("faces", ws.face_centers), ("vertices", ws.vertex_points)])
def test_on_faces_and_vertices(mesh, place, make):
    right = make(mesh)
    found = assert_same(cluster.sky_view_factor(mesh, place, 2, chunk=700), ws.sky_view_factor(mesh, right, 2))
    for name in ("position", "normal", "face"):
        assert np.array_equal(found[name], getattr(right, name))


def test_the_first_id_goes_with_points_and_rays(mesh):
    right = ws.ambient_occlusion(
        mesh, ws.sample_surface(mesh, 90, seed=SEED, first_point=40), RAYS, seed=SEED, first_point=40
    )
    assert_same(cluster.ambient_occlusion(mesh, 90, RAYS, seed=SEED, first_point=40, chunk=33), right)


@pytest.mark.slow
def test_every_estimate(mesh, points):
    shared = {"seed": SEED, "active": ACTIVE}
    few = {**shared, "tolerance": 0.05}
    assert_same(cluster.bent_normals(mesh, points, RAYS, chunk=POINTS, **few), ws.bent_normals(mesh, points, RAYS, **few))
    for light in (PICTURE, PICTURE[..., 0].tolist(), functions.upward):
        right = ws.irradiance(mesh, points, light, RAYS, up=(0, 1, 0), **shared)
        assert_same(cluster.irradiance(mesh, points, light, RAYS, up=(0, 1, 0), chunk=60, **shared), right)
    right = ws.integrate(points, functions.upward, RAYS, mesh=mesh, **shared)
    assert_same(cluster.integrate(points, functions.upward, RAYS, mesh=mesh, chunk=60, **shared), right)
    right = ws.integrate(points.normal, functions.by_point, RAYS, **shared)
    assert_same(cluster.integrate(points.normal, functions.by_point, RAYS, chunk=60, **shared), right)


def test_directions_and_what_they_meet(mesh, points):
    right = ws.sample_directions(points, 8, distribution=ws.GGX(alpha=0.3), seed=SEED, pdf=True, active=ACTIVE)
    options = {"seed": SEED, "pdf": True, "active": ACTIVE, "chunk": 40}
    cut = {name: dask.array.from_array(np.array(getattr(points, name)), (50, 3)) for name in ("position", "normal")}
    for normals in (points, points.normal, cut["normal"], POINTS):
        lazy = cluster.sample_directions(normals, 8, distribution="ggx(alpha=0.3)", mesh=mesh, **options)
        assert_same(lazy, right)
    hits = ws.trace(mesh, points, right.vectors, any_hit=True)
    assert cluster.trace(mesh, POINTS, right.vectors).distance.dims == ("point", "sample")
    for way in (lazy.vectors, lazy.vectors.data, right.vectors):
        found = cluster.trace(mesh, points, way, any_hit=True, chunk=70).compute()
        assert np.array_equal(found.distance, hits.distance, equal_nan=True)
        assert np.array_equal(found.face, hits.face)
    eye = [36.0, 36.0, 9.0]
    found = cluster.trace(mesh, eye, points.normal, chunk=70).compute()
    assert np.array_equal(found.distance, ws.trace(mesh, eye, points.normal).distance)
    found = cluster.trace(mesh, cut["position"], cut["normal"], chunk=70).compute()
    assert np.array_equal(found.distance, ws.trace(mesh, points.position, points.normal).distance)


def test_options_are_taken_by_keyword_alone(mesh, points):
    with pytest.raises(TypeError, match="too many positional arguments"):
        cluster.ambient_occlusion(mesh, points, RAYS, 0.3)


def test_nothing_is_computed_before_it_is_asked_for_and_then_once(mesh, monkeypatch):
    ran = []

    @wraps(ws.ambient_occlusion)
    def counted(*arguments, first_point, **options):
        ran.append((first_point, options["workers"]))
        return ws.ambient_occlusion(*arguments, first_point=first_point, **options)

    lazy = cluster.ambient_occlusion(mesh, POINTS, RAYS, chunk=60)
    monkeypatch.setitem(chunks.FUNCTIONS, "ambient_occlusion", counted)
    assert ran == []
    lazy.compute()
    assert sorted(ran) == [(0, 1), (60, 1), (120, 1)]
    ran.clear()
    lazy.value[:50].compute()
    assert ran == [(0, 1)]
    ran.clear()
    lazy.position.compute()
    assert ran == []
    cluster.ambient_occlusion(mesh, 10, RAYS, workers=2).value.compute()
    assert ran[-1] == (0, 2)


def test_a_billion_points_are_few_numbers_here(mesh):
    lazy = cluster.ambient_occlusion(mesh, 10**9, 256, chunk=1 << 22)
    assert lazy.sizes["point"] == 10**9
    assert len(lazy.value.data.__dask_keys__()) == 239


def test_attributes_repeat_the_run(mesh):
    about = cluster.ambient_occlusion(mesh, POINTS, RAYS, seed=SEED, chunk=60).attrs
    expected = {"call": "ambient_occlusion", "mesh": mesh.digest, "points": POINTS, "place": "area", "chunk": 60}
    expected |= {"count": RAYS, "seed": SEED, "sequence": "fibonacci", "max_distance": None, "skip": True}
    assert expected.items() <= about.items()
    assert {"warpsample", "warp-lang"} <= set(about)


def test_names_of_tasks_tell_calls_apart(mesh, points):
    def called(*arguments, **options):
        return cluster.ambient_occlusion(mesh, *arguments, **options).value.data.name

    assert called(POINTS, RAYS) == called(POINTS, RAYS)
    moved = ws.SurfacePoints(points.position + 1e-9, points.normal, points.face)
    others = [(POINTS, RAYS), (POINTS, 48), (POINTS + 1, RAYS), ("faces", RAYS), (points, RAYS), (moved, RAYS)]
    assert len({called(*other) for other in others}) == len(others)
    assert called(POINTS, RAYS) != called(POINTS, RAYS, chunk=60)


NO = ws.SurfacePoints(np.zeros((2, 3)), np.zeros((2, 3)))


@pytest.mark.parametrize(
    ("arguments", "options", "message"),
    [
        (("corners",), {}, "points: got 'corners', want SurfacePoints, a whole number"),
        ((None,), {}, "points: got None, want SurfacePoints"),
        ((0,), {}, "points: got 0, want a whole number of at least 1"),
        ((True,), {}, "points: got True, want SurfacePoints"),
        ((9,), {"chunk": 0}, "chunk: got 0, want a whole number from 1"),
        ((9,), {"count": 1}, "count: got 1, want a whole number from 2"),
        ((9,), {"sequence": "halton"}, "sequence: got 'halton', want one of"),
        ((9,), {"seed": -1}, "seed: got -1"),
        ((9,), {"max_distance": -1.0}, "max_distance: got -1.0"),
        ((9,), {"progress": True}, "progress: got a value for a call over Dask"),
        ((9,), {"first_point": 2**64 - 8}, "first_point: got"),
        ((NO,), {"active": np.ones(3, bool)}, r"active: got shape \(3,\), want an array of bool of shape \(2,\)"),
    ],
)
def test_what_cannot_be_used_is_refused_at_once(mesh, arguments, options, message):
    with pytest.raises((TypeError, ValueError), match=f"^{message}"):
        cluster.ambient_occlusion(mesh, *arguments, **options)


def test_so_are_rows_and_meshes_that_lack(mesh, points):
    with pytest.raises(ValueError, match="^mesh: got None, want the mesh of normals=9"):
        cluster.sample_directions(9, 8)
    with pytest.raises(ValueError, match="^directions: got 3 rows, want 130, one for each point"):
        cluster.trace(mesh, points, np.ones((3, 3)))
    with pytest.raises(ValueError, match="^out: got a value"):
        cluster.sample_directions(points, 8, out=np.empty((POINTS, 8, 3), np.float32))
    with pytest.raises(AttributeError, match="no attribute 'nothing'"):
        cluster.nothing  # noqa: B018
    assert set(cluster.__all__) <= set(dir(cluster))


def test_a_function_goes_by_its_name_or_not_at_all():
    sent = pickle.loads(pickle.dumps(named.named("integrand", functions.upward, None)))
    assert sent.unwrap() is functions.upward

    @wp.func
    def here(w: wp.vec3) -> float:
        return w[2]

    for value in (here, functions.Data()):
        with pytest.raises(
            TypeError, match="^integrand: got .*, which other processes cannot import, want a wp.func at the top"
        ):
            pickle.dumps(named.named("integrand", value, None))


@pytest.mark.slow
def test_the_room_opens_without_dask_and_says_what_it_needs(child_environment):
    code = (
        "import sys; from warpsample import cluster; "
        "print(sorted({'dask', 'distributed', 'zarr', 'xarray', 'warp'} & set(sys.modules))); "
        "sys.modules['dask'] = None; cluster.ambient_occlusion"
    )
    done = subprocess.run([sys.executable, "-c", code], env=child_environment, capture_output=True, text=True, check=False)
    assert done.stdout == "[]\n"
    assert done.stderr.splitlines()[-1].startswith("ModuleNotFoundError: warpsample.cluster needs dask")
    assert done.stderr.rstrip().endswith("pip install '.[cluster]'")


def test_ids_and_raised_points_go_with_the_points(mesh, points):
    """Also through chunks, and into the name of the run; a first id beside them is refused before anything runs."""
    ids = (np.arange(POINTS, dtype=np.uint64) * np.uint64(2**31))[::-1]
    owned = ws.SurfacePoints(points.position, points.normal, points.face, id=ids)
    right = ws.ambient_occlusion(mesh, owned, RAYS, seed=SEED)
    lazy = cluster.ambient_occlusion(mesh, owned, RAYS, seed=SEED, chunk=33)
    assert np.array_equal(assert_same(lazy, right).id, ids)
    assert lazy.attrs["id"] != cluster.ambient_occlusion(mesh, owned.take(slice(None, None, -1)), RAYS).attrs["id"]
    assert "id" not in cluster.ambient_occlusion(mesh, points, RAYS).attrs
    raised = ws.vertex_points(mesh).take(slice(0, POINTS))
    raised = ws.SurfacePoints(raised.position, raised.normal, raised=np.arange(POINTS) % 2 > 0)
    right = ws.ambient_occlusion(mesh, raised, RAYS, seed=SEED)
    assert_same(cluster.ambient_occlusion(mesh, raised, RAYS, seed=SEED, chunk=33), right)
    directions = ws.sample_directions(owned, 8, seed=SEED)
    assert_same(cluster.sample_directions(owned, 8, mesh=mesh, seed=SEED, chunk=33), directions)
    with pytest.raises(ValueError, match=r"^first_point: got 7, want 0 for points that have their own ids, `id`$"):
        cluster.ambient_occlusion(mesh, owned, RAYS, first_point=7)


def test_types_show_each_call_with_the_options_of_its_quantity(repository):
    """A call has its own parameters, `chunk` and the fields of its TypedDict, with the defaults of the quantity."""
    nodes = ast.parse((repository / "warpsample/cluster/__init__.pyi").read_text()).body
    stubs = {node.name: node.args for node in nodes if isinstance(node, ast.FunctionDef)}
    assert set(stubs) == set(chunks.CALLS)
    for name, taken in stubs.items():
        keywords = getattr(import_module("warpsample.cluster.calls"), taken.kwarg.annotation.slice.id).__annotations__
        own = {arg.arg for arg in (*taken.args, *taken.kwonlyargs)}
        parameters = inspect.signature(chunks.CALLS[name].call).parameters
        assert own | set(keywords) == set(parameters) | {"chunk"}, name
        defaults = [
            *zip(taken.args[::-1], taken.defaults[::-1], strict=False),
            *zip(taken.kwonlyargs, taken.kw_defaults, strict=True),
        ]
        assert all(ast.literal_eval(default) == parameters[arg.arg].default for arg, default in defaults), name


@pytest.mark.parametrize("name", ["ambient_occlusion", *cluster.__all__])
def test_a_call_says_what_it_takes_and_shows_it(name):
    if name == "bake":
        pytest.importorskip("zarr")
    call = getattr(cluster, name)
    assert flaws(call) == []
    assert failures(name, sections(call)["Example"]) == ""


def test_lobes_by_point_and_tangents_are_cut_with_the_points():
    mesh, rng = ws.load_mesh("courtyard"), np.random.default_rng(4)
    points = ws.sample_surface(mesh, 500, seed=3).with_tangents(rng.normal(size=(500, 4)))
    view = rng.normal(size=(500, 3))
    view[:, 2] = abs(view[:, 2])
    alpha = rng.uniform(0.1, 1.0, 500)
    lobe = ws.VisibleGGX(alpha, view=view)
    whole = ws.sample_directions(points, 4, distribution=lobe, pdf=True)
    lazy = cluster.sample_directions(points, 4, distribution=lobe, pdf=True, chunk=130)
    found = lazy.compute()
    for name in ("vectors", "pdf", "status"):
        assert np.array_equal(found[name], getattr(whole, name)), name
    assert np.array_equal(found.tangent, points.tangent)
    # The identity of a run contains the numbers of the arrays.
    again = cluster.sample_directions(points, 4, distribution=ws.VisibleGGX(alpha.copy(), view=view), pdf=True, chunk=130)
    alpha[400] *= 1.01
    other = cluster.sample_directions(points, 4, distribution=ws.VisibleGGX(alpha, view=view), pdf=True, chunk=130)
    assert again.attrs == lazy.attrs
    assert again.vectors.data.name == lazy.vectors.data.name
    assert other.attrs != lazy.attrs
    assert other.vectors.data.name != lazy.vectors.data.name
    with pytest.raises(ValueError, match="distribution.alpha: got 500 rows, want 9"):
        cluster.sample_directions(points.take(slice(9)), 4, distribution=lobe)


def test_integrals_over_lobes_by_point_have_the_same_bits():
    points = ws.sample_surface(ws.load_mesh("courtyard"), 300, seed=3)
    lobe = ws.GGX(np.linspace(0.1, 1.0, 300))
    found = cluster.integrate(points, funcs.square_to_cosine_hemisphere_pdf, 16, distribution=lobe, chunk=110).compute()
    whole = ws.integrate(points, funcs.square_to_cosine_hemisphere_pdf, 16, distribution=lobe)
    assert np.array_equal(found.value, whole.value)


def test_two_threads_send_a_mesh_once(mesh, monkeypatch):
    """One of two equal tasks may be forgotten while the other is computed."""
    sending, sent, both = import_module("warpsample.cluster.sending"), [], Barrier(2)

    class Future:
        status = "pending"

    class Client:
        id, status = "of a test", "running"

        def submit(self, function, value, key):
            sent.append(key)
            sleep(0.05)  # in which the other thread would send it, too
            return Future()

    monkeypatch.setattr(sending, "current_client", Client)

    def send(_):
        both.wait(HANGS)
        return sending.shared_by_key(SimpleNamespace(shared={"mesh": mesh}))[1]

    with ThreadPoolExecutor(2) as threads:
        (one,), (other,) = threads.map(send, range(2))
    assert one is other
    assert len(sent) == 1
