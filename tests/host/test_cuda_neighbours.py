"""Arrays of other libraries that a CUDA device holds go to Warp, and what no one reads is refused by its name."""

import numpy as np
import pytest
import warp as wp
from foreign_arrays import Copies, Dlpack

import warpsample as ws
from warpsample.host.neighbours import as_ndarray, from_cuda
from warpsample.host.vectors import as_vectors

COUNT = 16
NORMALS = np.random.default_rng(1).normal(size=(40, 3)).astype(np.float32)
POSITIONS = np.random.default_rng(2).uniform(-1.0, 1.0, (40, 3))
POINTS = ws.SurfacePoints(POSITIONS, NORMALS)
VERTICES, FACES = np.eye(3), np.array([[0, 1, 2]])


class Elsewhere(Dlpack):
    """An array on a device that neither NumPy nor Warp has: Apple's Metal, as DLPack numbers it."""

    def __dlpack__(self, **options):
        raise BufferError("it is on a GPU")

    def __dlpack_device__(self):
        return 8, 0


class CudaInterface:
    """An array that says that a CUDA device holds it, as Numba's do."""

    def __init__(self, array):
        self.__cuda_array_interface__ = {**array.__array_interface__, "version": 3}

    def __len__(self):
        return self.__cuda_array_interface__["shape"][0]


class CudaDlpack(Dlpack):
    """An array that says so by DLPack."""

    def __dlpack_device__(self):
        return 2, 0


class CudaDlpackAndCopies(CudaDlpack, Copies):
    """As JAX's, which NumPy would copy to the host."""


def test_an_unknown_device_is_named():
    with pytest.raises(
        TypeError,
        match=r"^normals: got .*Elsewhere.*, which NumPy cannot convert to an array \(it is on a GPU\), want an array$",
    ):
        ws.sample_directions(Elsewhere(NORMALS), COUNT)


@pytest.mark.skipif(wp.is_cuda_available(), reason="there is a CUDA device")
@pytest.mark.parametrize("foreign", [CudaInterface, CudaDlpack, CudaDlpackAndCopies])
@pytest.mark.parametrize(
    ("argument", "call"),
    [
        ("normals", lambda x: ws.sample_directions(x, COUNT)),
        ("active", lambda x: ws.sample_directions(NORMALS, COUNT, active=x)),
        ("out", lambda x: ws.sample_directions(NORMALS, COUNT, out=x)),
        ("origins", lambda x: ws.trace((VERTICES, FACES), x, x)),
        ("directions", lambda x: ws.trace((VERTICES, FACES), NORMALS, x)),
        ("position", lambda x: ws.SurfacePoints(x, NORMALS)),
        ("vertices", lambda x: ws.as_mesh((x, FACES))),
        ("radiance", lambda x: ws.irradiance((VERTICES, FACES), POINTS, x)),
        ("u", lambda x: ws.GGX(0.3).sample(x)),
        ("w", lambda x: ws.GGX(0.3).pdf(x)),
    ],
)
def test_cuda_arrays_go_to_warp_and_not_to_numpy(argument, call, foreign):
    """Without a device it refuses them; NumPy, which could read them here, is not asked."""
    message = rf"^{argument}: got a value of type {foreign.__name__} on a CUDA device, which Warp cannot convert to an array"
    with pytest.raises(TypeError, match=message + r" \(.+\), want an array without gradients on one of cpu$"):
        call(foreign(NORMALS))


def test_warp_takes_the_address_that_a_cuda_array_tells(monkeypatch):
    """The branch that a GPU would take, with Warp's arrays and devices in its place."""
    given, asked = CudaInterface(NORMALS), []
    made = wp.zeros(40, dtype=wp.vec3, device="cpu")

    class Recorder(wp.array):
        def __new__(cls, **arguments):
            asked.append(arguments)
            return made

    with monkeypatch.context() as patched:
        patched.setattr(wp, "get_cuda_device", lambda: "cuda:0")
        patched.setattr(wp, "array", Recorder)
        assert from_cuda(given, "normals") is made
    assert asked == [{"data": given, "device": "cuda:0", "copy": False}]
    monkeypatch.setattr(wp, "from_dlpack", lambda value: wp.array(value.owner, device="cpu"))
    found = ws.sample_directions(CudaDlpackAndCopies(NORMALS), COUNT)
    assert isinstance(found.vectors, wp.array)  # what comes back for it
    assert found.vectors.numpy().tobytes() == ws.sample_directions(NORMALS, COUNT).vectors.tobytes()
    points = ws.SurfacePoints(CudaDlpack(POSITIONS), CudaDlpack(NORMALS))  # copied to the host, where points are
    assert type(points.position) is np.ndarray
    assert (points.position == POSITIONS).all()


@pytest.mark.skipif(not wp.is_cuda_available(), reason="no CUDA device")
@pytest.mark.parametrize("kind", [CudaInterface, CudaDlpack])
def test_a_cuda_array_is_taken_without_a_copy(kind):
    class Other(kind):
        """A wp.array in disguise."""

        def __init__(self, array):
            self.owner = array
            if kind is CudaInterface:
                self.__cuda_array_interface__ = array.__cuda_array_interface__

    there = wp.array(NORMALS, dtype=wp.float32, device="cuda")
    assert as_vectors(Other(there), 3, "normals").address == there.ptr
    assert (as_ndarray(Other(there), "position") == NORMALS).all()
    assert (ws.GGX(0.3).pdf(Other(there)).numpy() == ws.GGX(0.3).pdf(there).numpy()).all()
