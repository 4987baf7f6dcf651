"""Arrays of other libraries are taken wherever NumPy's are, by their protocols, and give the same bits.

PyTorch is one of them where it is installed; two small classes stand for all that have one protocol alone.
"""

import re
import signal

import numpy as np
import pytest
import warp as wp
from foreign_arrays import Copies, Dlpack, Interface

import warpsample as ws
from warpsample.host.vectors import as_vectors
from warpsample.tracing.triples import Triples

COUNT = 16
NORMALS = np.random.default_rng(1).normal(size=(40, 3)).astype(np.float32)
VERTICES = np.array([[-9.0, -9.0, 0.0], [9.0, -9.0, 0.0], [0.0, 9.0, 1.0]])
FACES = np.array([[0, 1, 2]])
POSITIONS = np.random.default_rng(2).uniform(-1.0, 1.0, (40, 3)) - [0.0, 0.0, 3.0]
ACTIVE = NORMALS[:, 0] > 0.0
READ_ONLY_BY_DLPACK = np.lib.NumpyVersion(np.__version__) >= "2.1.0"  # before, an array is never or always read-only


def torch_of(array):
    return pytest.importorskip("torch").from_numpy(array)


def skip_if_read_only(foreign):
    if foreign is Dlpack and not READ_ONLY_BY_DLPACK:
        pytest.skip("what comes by DLPack is read-only")


FOREIGN = pytest.mark.parametrize("foreign", [Interface, Dlpack, torch_of])


def surface_points(of):
    return ws.SurfacePoints(of(POSITIONS), of(NORMALS), of(np.full(40, -1)), of(np.full((40, 3), 1.0 / 3.0)))


def directions(of):
    found = ws.sample_directions(of(NORMALS), COUNT, active=of(ACTIVE), pdf=True)
    return found.vectors, found.pdf, found.status


def hits(of):
    found = ws.trace((of(VERTICES), of(FACES)), of(POSITIONS), of(NORMALS))
    assert 5 < np.count_nonzero(found.face == 0) < 35
    return found.distance, found.face


def occlusion(of):
    found = ws.ambient_occlusion(ws.Mesh(of(VERTICES), of(FACES)), surface_points(of), COUNT, active=of(ACTIVE))
    assert (found.value[ACTIVE] < 1.0).any()
    return found.value, found.standard_error, found.rays, found.status


def light(of):
    picture, up = np.linspace(0.0, 1.0, 96).reshape(4, 8, 3), np.array([0.6, 0.0, 0.8])
    return (ws.irradiance((VERTICES, FACES), surface_points(np.asarray), of(picture), COUNT, up=of(up)).value,)


def maps(of):
    lobe, u = ws.GGX(0.3), np.random.default_rng(3).uniform(size=(50, 2)).astype(np.float32)
    w = lobe.sample(of(u))
    return w, lobe.pdf(of(w)), lobe.invert(of(w)), lobe.cdf(of(u[:, 0]))


@FOREIGN
@pytest.mark.parametrize("call", [directions, hits, occlusion, light, maps])
def test_what_others_hold_gives_the_bits_and_the_kind_that_numpys_gives(call, foreign):
    for found, expected in zip(call(foreign), call(lambda array: array), strict=True):
        assert type(found) is np.ndarray
        assert (found.dtype, found.shape, found.tobytes()) == (expected.dtype, expected.shape, expected.tobytes())


@FOREIGN
def test_nothing_is_copied(foreign):
    made = foreign(NORMALS)
    assert as_vectors(made, 3, "normals").address == NORMALS.ctypes.data
    assert np.shares_memory(Triples.of(made, "origins").owner, NORMALS)
    points = surface_points(foreign)
    assert np.shares_memory(points.position, POSITIONS)
    assert np.shares_memory(points.normal, NORMALS)


@FOREIGN
def test_what_is_not_contiguous_or_read_only_is_read(foreign):
    array = np.asfortranarray(NORMALS)
    found = ws.sample_directions(foreign(array), COUNT)
    assert found.vectors.tobytes() == ws.sample_directions(NORMALS, COUNT).vectors.tobytes()
    if foreign is torch_of or (foreign is Dlpack and not READ_ONLY_BY_DLPACK):
        return  # they export nothing that is read-only
    array = NORMALS.copy()
    array.setflags(write=False)
    assert ws.sample_directions(foreign(array), COUNT).vectors.tobytes() == found.vectors.tobytes()


@FOREIGN
def test_out_is_written_in_place(foreign):
    memory = np.full((40, COUNT, 3), 7.0, np.float32)
    if foreign is Dlpack and not READ_ONLY_BY_DLPACK:
        with pytest.raises(ValueError, match=r"^out: got an array that is read-only, want a C-contiguous, writeable"):
            ws.sample_directions(NORMALS, COUNT, out=foreign(memory))
        return
    found = ws.sample_directions(foreign(NORMALS), COUNT, out=foreign(memory))
    assert type(found.vectors) is np.ndarray
    assert found.vectors.ctypes.data == memory.ctypes.data
    assert memory.tobytes() == ws.sample_directions(NORMALS, COUNT).vectors.tobytes()


@FOREIGN
@pytest.mark.parametrize(
    ("make", "kind", "message"),
    [
        (lambda: np.zeros((40, COUNT, 3)), TypeError, "got dtype float64, want a C-contiguous, writeable float32"),
        (lambda: np.zeros((COUNT, 40, 3), np.float32).swapaxes(0, 1), ValueError, "got an array that is not C-contiguous"),
        (lambda: np.zeros((40, 3), np.float32), ValueError, r"got shape \(40, 3\), want"),
    ],
)
def test_a_wrong_out_is_named(foreign, make, kind, message):
    skip_if_read_only(foreign)
    with pytest.raises(kind, match=f"^out: {message}"):
        ws.sample_directions(NORMALS, COUNT, out=foreign(make()))


@FOREIGN
def test_out_may_not_be_the_normals(foreign):
    skip_if_read_only(foreign)
    memory = NORMALS.copy()
    with pytest.raises(ValueError, match=r"^out: got an array that overlaps the normals"):
        ws.sample_directions(foreign(memory), 1, out=foreign(memory.reshape(40, 1, 3)))


def test_an_out_that_gives_copies_would_stay_as_it_is_and_is_refused():
    with pytest.raises(TypeError, match=r"^out: got a value of type Copies, want a NumPy array, the type of the normals"):
        ws.sample_directions(NORMALS, COUNT, out=Copies(np.zeros((40, COUNT, 3), np.float32)))
    as_normals = ws.sample_directions(Copies(NORMALS), COUNT)
    assert as_normals.vectors.tobytes() == ws.sample_directions(NORMALS, COUNT).vectors.tobytes()


@pytest.mark.parametrize(
    ("make", "reason"),
    [
        (lambda tensor: tensor.clone().requires_grad_(), r"Tensor that requires grad.*detach"),
        (lambda tensor: tensor.bfloat16(), "BFloat16"),
        (lambda tensor: tensor.to_sparse(), "to_dense"),
        (lambda tensor: tensor.to("meta"), "meta"),
        (lambda tensor: (1j * tensor).conj().imag, "resolve_neg"),
    ],
)
def test_a_tensor_that_numpy_makes_nothing_of_is_named(make, reason):
    wrong = make(torch_of(NORMALS))
    calls = {
        "normals": lambda: ws.sample_directions(wrong, COUNT),
        "origins": lambda: ws.trace((VERTICES, FACES), wrong, NORMALS),
        "position": lambda: ws.SurfacePoints(wrong, NORMALS),
        "u": lambda: ws.GGX(0.3).sample(wrong),
        "vertices": lambda: ws.Mesh(wrong, FACES),
        "out": lambda: ws.sample_directions(NORMALS, COUNT, out=wrong),
    }
    for argument, call in calls.items():
        with pytest.raises(TypeError) as raised:
            call()
        said = rf"{argument}: got .*, which NumPy cannot convert to an array \(.*{reason}.*\), want .*"
        assert re.fullmatch(said, str(raised.value))


def test_points_of_warps_arrays_are_numpys_and_so_are_their_numbers():
    """Rays and normals of Warp's arrays are answered by Warp's; an array with points that are NumPy's is refused."""
    corners = np.float32([(0, 0, 0), (2, 0, 0), (0, 2, 0)])
    mesh, up = ws.as_mesh((corners, [(0, 1, 2)])), np.tile(np.float32([0.0, 0.0, 1.0]), (3, 1))
    positions, normals = (wp.array(array, dtype=wp.vec3, device="cpu") for array in (corners, up))
    points = ws.SurfacePoints(positions, normals)
    assert type(points.position) is type(points.normal) is np.ndarray
    for call in (ws.ambient_occlusion, ws.sky_view_factor, ws.bent_normals):
        found = call(mesh, points, 16)
        assert {type(getattr(found, name)) for name in ("value", "standard_error", "rays", "status")} == {np.ndarray}
        assert np.array_equal(found.value, call(mesh, ws.SurfacePoints(corners, up), 16).value)
    assert type(ws.sample_directions(points, 4).vectors) is np.ndarray
    ways = ws.sample_directions(normals, 4).vectors
    assert type(ways) is type(ws.trace(mesh, positions, ways).distance) is wp.array
    with pytest.raises(ValueError, match="^directions: got a wp.array on cpu, want a NumPy array on cpu"):
        ws.trace(mesh, points, ways)


def test_half_precision_is_as_numpys_is():
    with pytest.raises(TypeError, match=r"^normals: got dtype float16, want float32 \(or float64"):
        ws.sample_directions(torch_of(NORMALS).half(), COUNT)


@pytest.fixture
def late():
    """Python code of a value, within which a signal's handler raises."""

    class Handler:
        def __call__(self, *_):
            raise KeyboardInterrupt("too late")

    def send_one(*_, **__):
        signal.raise_signal(signal.SIGINT)
        raise AssertionError("the handler has raised nothing")

    before = signal.signal(signal.SIGINT, Handler())
    yield send_one
    signal.signal(signal.SIGINT, before)


@pytest.mark.parametrize("name", ["__array__", "__dlpack__", "__dlpack_device__"])
def test_an_interrupt_within_a_values_own_code_comes_out_as_it_is(late, name):
    """As while a lazy array is computed: it says nothing of the value."""
    with pytest.raises(KeyboardInterrupt, match="^too late$"):
        ws.trace((VERTICES, FACES), POSITIONS, type("Lazy", (), {name: late})())
    with pytest.raises(KeyboardInterrupt, match="^too late$"):
        ws.GGX(0.3).sample(type("Lazy", (), {name: late})())
    with pytest.raises(KeyboardInterrupt, match="^too late$"):
        ws.trace((VERTICES, FACES), POSITIONS, NORMALS, any_hit=type("Flag", (), {"__repr__": late})())


@pytest.mark.usefixtures("late")
def test_an_interrupt_within_an_integrand_comes_out_as_it_is():
    @wp.func
    def unsaid(w: wp.vec3):
        signal.raise_signal(2)
        return w[2]

    with pytest.raises(KeyboardInterrupt, match="^too late$"):
        ws.integrate(NORMALS, unsaid, COUNT)
