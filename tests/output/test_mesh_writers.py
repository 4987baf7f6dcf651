"""Meshes and clouds are written with every bit of their coordinates, at any scale and on any map, and in little memory."""

import json
import re
import struct
import tracemalloc
from functools import lru_cache

import numpy as np
import pytest
import trimesh

import warpsample as ws
from warpsample.output import bake, baked, export, places, source
from warpsample.output.mesh_writers import Lazy, write_vtp

MAP = np.array([500_000.0, 5_400_000.0, 300.0])
PLACES = [(size, at) for size in (1e-6, 1.0, 5e6) for at in (0.0, 1.0)]  # size, and whether on the map


@lru_cache
def ground(size=1.0, at=0.0):
    """4,096 triangles of random corners in a square of that size, none of them exact in float32."""
    x, y = np.meshgrid(np.linspace(0.0, size, 33), np.linspace(0.0, size, 65), indexing="ij")
    rng = np.random.default_rng(3)
    vertices = np.stack([x, y, size * rng.uniform(0.0, 0.05, x.shape)], axis=-1).reshape(-1, 3) / 3.0 + at * MAP
    corner = (np.arange(32)[:, None] * 65 + np.arange(64)).ravel()
    faces = np.concatenate([corner[:, None] + [0, 65, 66], corner[:, None] + [0, 66, 1]])
    return ws.Mesh(vertices, faces)


@pytest.fixture
def placed(tmp_path):
    """Writes a mesh as .obj, whose text keeps float64, and returns its path."""

    def write(mesh):
        path = tmp_path / "ground.obj"
        lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in mesh.vertices.tolist()]
        path.write_text("\n".join([*lines, *(f"f {a} {b} {c}" for a, b, c in (mesh.faces + 1).tolist())]))
        assert np.array_equal(ws.load_mesh(path).vertices, mesh.vertices)
        return path

    return write


def read(path):
    if path.suffix != ".vtp":
        return ws.load_mesh(path)
    import pyvista as pv

    found = pv.read(path)
    assert found.points.dtype == np.float64
    return ws.as_mesh(found)


@pytest.mark.parametrize(("size", "at"), PLACES)
@pytest.mark.parametrize(
    ("of", "suffix"),
    [
        ("faces", ".ply"),
        *(pytest.param("faces", suffix, marks=pytest.mark.slow) for suffix in (".glb", ".vtp")),
        *(pytest.param("vertices", suffix, marks=pytest.mark.thorough) for suffix in (".ply", ".vtp")),
        pytest.param("vertices", ".glb", marks=pytest.mark.slow),
    ],
)
def test_every_face_keeps_its_area(call, placed, tmp_path, suffix, of, size, at):
    mesh, output = ground(size, at), tmp_path / f"out{suffix}"
    status, _, err = call("bake", placed(mesh), "-o", output, "--samples", 2, "--at", of)
    assert (status, err) == (0, "")
    found = read(output)
    assert (np.abs(found.face_areas - mesh.face_areas) <= (1e-4 if suffix == ".glb" else 0.0) * mesh.face_areas).all()
    assert np.count_nonzero(mesh.face_areas) > 4000
    expected, corners = mesh.vertices[mesh.faces], found.vertices[found.faces]
    if suffix != ".glb":
        assert np.array_equal(found.faces, mesh.faces)
        assert np.array_equal(found.vertices, mesh.vertices)
    else:  # to the last bit of float32 about the middle, and of float64 on the map
        assert np.abs(corners - expected).max() <= 2.0**-24 * mesh.diagonal + np.spacing(np.abs(expected).max())


@pytest.mark.parametrize("scale", [1e-6, 1.0, 5e6])
@pytest.mark.parametrize("suffix", [".ply", ".glb", ".vtp"])
def test_what_float32_holds_stays_as_it_is(call, tmp_path, suffix, scale):
    """A .ply of it stays small, and other readers find the same numbers."""
    whole = ground().vertices.astype(np.float32) * np.float32(scale)
    source, output = tmp_path / "in.ply", tmp_path / f"out{suffix}"
    trimesh.Trimesh(whole, ground().faces, process=False).export(source)
    assert call("bake", source, "-o", output, "--samples", 2)[0] == 0
    assert np.array_equal(read(output).vertices, whole.astype(np.float64))
    if suffix == ".ply":
        import meshio
        import pyvista as pv

        assert b"property float x\n" in output.read_bytes()[:500]
        assert np.array_equal(pv.read(output).points, whole)
        assert np.array_equal(meshio.read(output).points, whole)


@pytest.mark.parametrize("suffix", [".ply", ".vtp"])
@pytest.mark.parametrize(("size", "at"), PLACES)
def test_a_cloud_keeps_its_directions(call, placed, tmp_path, suffix, size, at):
    mesh, output = ground(size, at), tmp_path / f"cloud{suffix}"
    assert call("directions", placed(mesh), "-o", output, "--points", 100, "--samples", 6)[0] == 0
    points = ws.sample_surface(mesh, 100)
    ways = ws.sample_directions(points, 6).vectors
    scale = export.CLOUD_SCALE * mesh.diagonal
    expected = points.position[:, None] + scale * ways.astype(np.float64)
    if suffix == ".ply":
        found = trimesh.load(output)
        raw = found.metadata["_ply_raw"]["vertex"]["data"]
        positions, normals = found.vertices, np.stack([raw[name] for name in ("nx", "ny", "nz")], axis=-1)
    else:
        import pyvista as pv

        found = pv.read(output)
        assert np.array_equal(found.point_data["point"], np.repeat(np.arange(100), 6))
        assert found.n_cells == found.n_verts == 600
        positions, normals = found.points, found.point_data.active_normals
    assert np.array_equal(positions, expected.reshape(-1, 3))
    assert np.array_equal(normals, ways.reshape(-1, 3))


def test_a_glb_that_would_lose_faces_is_refused_before_the_work(call, placed, tmp_path, monkeypatch):
    """The mesh has faces of a millimetre, ten kilometres apart."""
    near = ground(1e-3)
    vertices = np.concatenate([near.vertices, near.vertices + np.array([1e4, 0.0, 0.0])])
    path = placed(ws.Mesh(vertices, np.concatenate([near.faces, near.faces + len(near.vertices)])))
    monkeypatch.setattr(source, "_place_points", None)
    status, _, err = call("bake", path, "-o", tmp_path / "out.glb")
    said = (
        r"error: --output: got 'out.glb', whose float32 would change the area of ([\d,]+) of 8,192 faces by more than 1%, "
    )
    assert status == 2
    assert re.fullmatch(said + "want .ply or .vtp\n", err)
    assert list(tmp_path.iterdir()) == [path]


def test_a_face_without_area_is_not_counted_as_lost(call, tmp_path):
    path = tmp_path / "flat.obj"
    path.write_text("v 0.1 0 0\nv 1.1 0 0\nv 0.1 1 0\nv 0.3 0.2 0\nv 0.4 0.3 0\nf 1 2 3\nf 1 4 5\nf 1 1 2\n")
    assert ws.load_mesh(path).report.degenerate_faces >= 1
    assert call("bake", path, "-o", tmp_path / "out.glb", "--samples", 2)[0] == 0


def test_a_glb_larger_than_its_format_allows_is_refused(call, placed, tmp_path, monkeypatch):
    """A limit that the corners of faces exceed and the vertices do not stands for 4 GiB."""
    assert baked.MOST_GLB_BYTES < 2**32
    monkeypatch.setattr(baked, "MOST_GLB_BYTES", 400_000)
    path, output = placed(ground()), tmp_path / "out.glb"
    status, _, err = call("bake", path, "-o", output, "--at", "faces")
    said = "error: --output: got 'out.glb' of 12,288 corners, want .ply or .vtp; this format holds at most 4 GiB\n"
    assert (status, err, output.exists()) == (2, said, False)
    assert call("bake", path, "-o", output, "--at", "vertices", "--samples", 2)[0] == 0
    assert output.stat().st_size <= 400_000
    monkeypatch.undo()
    assert call("bake", path, "-o", output, "--at", "faces", "--samples", 2)[0] == 0
    assert output.stat().st_size > 400_000


@pytest.mark.slow
def test_a_glb_of_light_is_refused_from_its_own_size_on(call, placed, tmp_path, monkeypatch):
    """All that is known of light is counted, no byte more."""
    light, path, output = tmp_path / "light.npy", placed(ground()), tmp_path / "out.glb"
    np.save(light, np.ones((4, 8, 3)))
    given = ["bake", path, "-o", output, "--at", "faces", "--samples", 2, "--quantity", "irradiance", "--environment", light]
    assert call(*given)[0] == 0
    data = output.read_bytes()
    arrays = struct.unpack_from("<I", data, 20 + struct.unpack_from("<I", data, 12)[0])[0]
    assert 400_000 < arrays < len(data)
    for less in (0, 1):
        monkeypatch.setattr(baked, "MOST_GLB_BYTES", arrays - less)
        assert call(*given)[0] == 2 * less


@pytest.mark.parametrize(("faces", "kind"), [(2**29, "Int32"), (2**30, "Int64")])
def test_a_vtp_of_2_to_the_31_corners_counts_them_in_64_bits(faces, kind):
    """Its head says so, and no more of it is written here."""

    class Full:
        def write(self, data):
            self.head = data
            raise OSError

    file, three = Full(), np.zeros((3, 3))
    with pytest.raises(OSError, match="^$"):
        write_vtp(file, three, Lazy((faces, 3), np.dtype(np.int32), lambda i: i), {}, {})
    assert re.search(rb'type="(\w+)" Name="offsets"', file.head)[1] == kind.encode()


def test_a_glb_says_what_is_in_it(call, placed, tmp_path):
    """Lengths, alignment, limits of positions and a float64 translation are as the format asks."""
    mesh, path = ground(1.0, 1.0), tmp_path / "out.glb"
    call("bake", placed(mesh), "-o", path, "--samples", 2)
    content = path.read_bytes()
    magic, version, length, text_length, kind = struct.unpack_from("<4sIIII", content)
    assert (magic, version, length, kind, text_length % 4) == (b"glTF", 2, len(content), 0x4E4F534A, 0)
    tree = json.loads(content[20 : 20 + text_length])
    buffer = content[28 + text_length :]
    assert tree["buffers"] == [{"byteLength": len(buffer)}]
    assert struct.unpack_from("<II", content, 20 + text_length) == (len(buffer), 0x004E4942)
    (primitive,) = tree["meshes"][0]["primitives"]
    numbers = {"POSITION", "COLOR_0", "_value", "_standard_error", "_rays", "_status"}
    assert set(primitive["attributes"]) == numbers
    positions = tree["accessors"][primitive["attributes"]["POSITION"]]
    view = tree["bufferViews"][positions["bufferView"]]
    found = np.frombuffer(buffer, "<f4", 3 * positions["count"], view["byteOffset"]).reshape(-1, 3)
    assert (positions["min"], positions["max"]) == (found.min(axis=0).tolist(), found.max(axis=0).tolist())
    assert tree["nodes"] == [{"mesh": 0, "translation": mesh.bounds.mean(axis=0).tolist()}]
    assert all(view["byteOffset"] % 4 == 0 for view in tree["bufferViews"])


class Sink:
    """A stream that counts what is written and keeps nothing."""

    def __init__(self):
        self.size = 0

    def write(self, block):
        self.size += memoryview(block).nbytes
        return memoryview(block).nbytes

    def writelines(self, blocks):
        for block in blocks:
            self.write(block)

    def tell(self):
        return self.size

    def seek(self, *where):
        raise OSError("as a pipe")

    def flush(self):
        pass


def traced(write):
    """(bytes written, peak of the memory of Python and NumPy)."""
    sink = Sink()
    tracemalloc.start()
    try:
        write(sink)
        return sink.size, tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()


@pytest.mark.parametrize("suffix", bake.SUFFIXES)
@pytest.mark.parametrize("at", ["vertices", "faces"])
def test_a_bake_takes_no_more_than_twice_its_file(tmp_path, suffix, at):
    mesh = ground()
    points = places.PLACES[at](mesh)
    found = ws.ambient_occlusion(mesh, points, 2)
    run = baked.BakeRun(tmp_path / "in", tmp_path / f"out{suffix}", "ao", at, None, {})
    written, held = traced(lambda sink: baked.WRITERS[suffix](sink, bake.Baked(run, mesh, points, found)))
    assert held <= 2 * written


@pytest.mark.parametrize("suffix", [".ply", ".vtp"])
def test_a_cloud_takes_no_more_than_twice_its_file(placed, tmp_path, suffix):
    """The memory includes the mesh and the directions; some points have none."""
    faces = ground().faces.copy()
    faces[::10, 1] = faces[::10, 0]
    output = tmp_path / f"x{suffix}"
    run = export.DirectionsRun(
        placed(ws.Mesh(ground().vertices, faces)), output, None, 96, "cosine_hemisphere", "sobol", 0, "faces"
    )
    export.export(run, 1)  # builds the kernel
    _, held = traced(lambda _: export.export(run, 1))
    assert output.stat().st_size > 3600 * 96 * 36
    assert held <= 2 * output.stat().st_size
