"""Stores: their contents, resumed and refused runs, and places that cannot be written."""

import subprocess
import sys
from importlib import import_module
from pathlib import Path

import numpy as np
import pytest

import warpsample as ws
from warpsample import cluster
from warpsample.host.files import check_output

pytest.importorskip("dask")
pytest.importorskip("zarr")

from store_cases import CHUNK, POINTS, RAYS, assert_whole, bake, whole_chunks

# seconds each, and kernels to compile; .ci/run runs them too
pytestmark = [pytest.mark.slow, pytest.mark.usefixtures("in_this_thread")]

baking = import_module("warpsample.cluster.baking")


def test_a_store_holds_numbers_places_and_the_run(path, mesh, right):
    found = bake(path, mesh)
    points = ws.sample_surface(mesh, POINTS)
    for name in ("position", "normal", "face"):
        assert np.array_equal(found.coords[name], getattr(points, name))
    assert {
        "call": "ambient_occlusion",
        "mesh": mesh.digest,
        "count": RAYS,
        "chunk": CHUNK,
        "seed": 0,
    }.items() <= found.attrs.items()
    assert_whole(path, right)


@pytest.mark.parametrize("chunk", [13, POINTS, 1000])
def test_chunks_change_no_bit(path, mesh, right, chunk, computed):
    bake(path, mesh, chunk=chunk)
    assert sorted(computed) == list(range(0, POINTS, chunk))
    assert_whole(path, right)


def test_every_call_has_a_store(path, tmp_path, mesh):
    points = ws.sample_surface(mesh, POINTS)
    way = ws.sample_directions(points, 4).vectors
    stores = {
        "directions": cluster.bake(path, "sample_directions", POINTS, 4, mesh=mesh, chunk=CHUNK).vectors,
        "given": cluster.bake(tmp_path / "g.zarr", "sample_directions", points.normal, 4, chunk=CHUNK).vectors,
    }
    for found in stores.values():
        assert np.array_equal(found, way)
    hits = cluster.bake(tmp_path / "h.zarr", "trace", mesh, points, stores["directions"], chunk=CHUNK)
    met = ws.trace(mesh, points, way)
    assert np.array_equal(hits.distance, met.distance)
    assert np.array_equal(hits.face, met.face)
    glass = ws.as_mesh(mesh, transmittance=0.5)
    through = cluster.bake(tmp_path / "t.zarr", "trace", glass, points, stores["directions"], chunk=CHUNK)
    assert np.array_equal(through.transmitted, ws.trace(glass, points, way).transmitted)
    active = np.arange(POINTS) > 70  # the first chunk is 0 throughout, and is there all the same
    light = cluster.bake(
        tmp_path / "l.zarr", "irradiance", mesh, points, np.ones((4, 8, 3)), RAYS, active=active, chunk=CHUNK
    )
    assert np.array_equal(light.value, ws.irradiance(mesh, points, np.ones((4, 8, 3)), RAYS, active=active).value)
    assert all(whole_chunks(tmp_path / "l.zarr"))


def test_resume_computes_what_is_missing_and_nothing_else(path, mesh, right, computed):
    bake(path, mesh, resume=True)  # begins
    assert sorted(computed) == [0, 50, 100]
    computed.clear()
    bake(path, mesh, resume=True)
    assert computed == []
    (path / "rays/c/1").unlink()
    bake(path, mesh, resume=True)
    assert computed == [50]
    assert_whole(path, right)


def test_an_interrupt_leaves_a_store_that_resumes(path, mesh, right, monkeypatch):
    bake_chunk = baking.bake_chunk

    def interrupted(call, path, span, *rest):
        if span.start == CHUNK:
            raise KeyboardInterrupt
        return bake_chunk(call, path, span, *rest)

    with monkeypatch.context() as patch:
        patch.setattr(baking, "bake_chunk", interrupted)
        with pytest.raises(KeyboardInterrupt, match=rf"^interrupted after \d+ of 130 points; {path} can be resumed$"):
            bake(path, mesh)
    assert not all(whole_chunks(path))
    bake(path, mesh, resume=True)
    assert_whole(path, right)


def test_a_store_is_not_written_over_or_mixed_with_another_run(path, mesh, right, computed):
    bake(path, mesh)
    computed.clear()
    with pytest.raises(ValueError, match="^path: got .*out.zarr', which exists already"):
        bake(path, mesh)
    points = ws.sample_surface(mesh, POINTS)
    other, glass = ws.Mesh(mesh.vertices + 1.0, mesh.faces), ws.Mesh(mesh.vertices, mesh.faces, transmittance=0.5)
    panes = ws.Mesh(other.vertices, mesh.faces, transmittance=0.5)
    for arguments, options, message in [
        ((mesh, POINTS, RAYS), {"seed": 1}, "seed 0, want a store of seed 1"),
        ((mesh, POINTS, 48), {}, "count 40, want a store of count 48"),
        ((mesh, 131, RAYS), {}, "points 130, want a store of points 131"),
        ((mesh, points, RAYS), {}, "position None, want a store of position '"),
        ((mesh, "faces", RAYS), {}, "place 'area', want a store of place 'faces'"),
        ((mesh, POINTS, RAYS), {"chunk": 49}, "chunk 50, want a store of chunk 49"),
        ((mesh, POINTS, RAYS), {"max_distance": 3.0}, "max_distance None, want a store of max_distance 3.0"),
        ((glass, POINTS, RAYS), {}, "the same mesh with another transmittance or reflectance of its faces; "),
        ((panes, POINTS, RAYS), {}, f"mesh '{mesh.digest}', want a store of mesh '{panes.digest}'"),
        ((other, POINTS, RAYS), {}, f"mesh '{mesh.digest}', want a store of mesh '{other.digest}'"),
    ]:
        with pytest.raises(ValueError, match=f"^path: got .*out.zarr' of {message}"):
            bake(path, *arguments, resume=True, **options)
    with pytest.raises(ValueError, match="^path: got .* of call 'ambient_occlusion', want a store of call 'bent_normals'"):
        cluster.bake(path, "bent_normals", mesh, POINTS, RAYS, chunk=CHUNK, resume=True)
    assert computed == []
    assert_whole(path, right)


def test_ids_are_part_of_the_run(path, mesh):
    """Kept beside the numbers, and a store of other ids is not gone on with."""
    points = ws.sample_surface(mesh, POINTS)
    own = [ws.SurfacePoints(points.position, points.normal, points.face, id=np.arange(POINTS) * 3 + k) for k in (0, 1)]
    found = bake(path, mesh, own[0], RAYS, seed=1)
    assert np.array_equal(found.coords["id"], own[0].id)
    assert np.array_equal(found.value, ws.ambient_occlusion(mesh, own[0], RAYS, seed=1).value)
    bake(path, mesh, own[0], RAYS, seed=1, resume=True)
    for other in (own[1], points):
        with pytest.raises(ValueError, match="of id "):
            bake(path, mesh, other, RAYS, seed=1, resume=True)


LIMITED = """
import resource, signal
import warpsample as ws
from warpsample import cluster
signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
resource.setrlimit(resource.RLIMIT_FSIZE, (30_000, 30_000))
cluster.bake({path!r}, "ambient_occlusion", ws.load_mesh("courtyard"), 8000, 2, chunk=4000)
"""


def test_a_store_that_cannot_be_written(path, tmp_path, mesh):
    for name, message in [
        ("out.vtp", "want a name that ends in .zarr"),
        ("no/out.zarr", "whose folder does not exist"),
        ("x" * 246 + ".zarr", "which cannot be written: File name too long"),
        ("loop.zarr", "which is a link to itself"),
        ("file.zarr", "which exists and is not a Zarr store"),
    ]:
        (tmp_path / "file.zarr").touch()
        if not (tmp_path / "loop.zarr").is_symlink():
            (tmp_path / "loop.zarr").symlink_to("loop.zarr")
        with pytest.raises(ValueError, match=message):
            bake(tmp_path / name, mesh)
    with pytest.raises(ValueError, match="^call: got 'occlusion', want one of ambient_occlusion"):
        cluster.bake(path, "occlusion", mesh, 9)
    code = LIMITED.format(path=str(path))
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert "WriteError: " in done.stderr.splitlines()[-1]
    assert done.stderr.splitlines()[-1].endswith("cannot be written: File too large")
    assert not any(whole_chunks(path))


def test_a_folder_that_is_gone_is_a_sentence(mesh, tmp_path, monkeypatch):
    (tmp_path / "gone").mkdir()
    monkeypatch.chdir(tmp_path / "gone")
    (tmp_path / "gone").rmdir()
    wants = "cannot be written: No such file or directory$"
    with pytest.raises(ValueError, match=f"^path: got 'out.zarr', which {wants}"):
        bake("out.zarr", mesh)
    with pytest.raises(ValueError, match=f"^--output: got 'out.npz', which {wants}"):
        check_output(Path("out.npz"), "--output")


def test_a_store_that_cannot_be_made_leaves_nothing(path, tmp_path, mesh):
    path.symlink_to("nowhere/out.zarr")
    with pytest.raises(ValueError, match=r"^path: got .*, whose folder does not exist$"):
        cluster.bake(path, "ambient_occlusion", mesh, POINTS, RAYS, chunk=CHUNK)
    assert list(tmp_path.iterdir()) == [path]
