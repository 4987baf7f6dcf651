"""Stores: each chunk whole or absent, what is missing computed and nothing else, and nothing of another run."""

import json
import os
import shutil
import subprocess
import sys
from functools import partial
from importlib import import_module
from pathlib import Path
from zlib import crc32

import numpy as np
import pytest

import warpsample as ws
from warpsample import cluster
from warpsample.host.files import check_output

pytestmark = pytest.mark.slow  # seconds each, and kernels to compile; .ci/run runs them too

dask = pytest.importorskip("dask")
pytest.importorskip("zarr")
xr = pytest.importorskip("xarray")
baking, holdings, lock = (import_module(f"warpsample.cluster.{name}") for name in ("baking", "holdings", "lock"))

POINTS, RAYS, CHUNK = 130, 40, 50
ARRAYS = ("value", "standard_error", "spread", "degrees_of_freedom", "rays", "status")


@pytest.fixture(scope="module")
def right(mesh):
    return ws.ambient_occlusion(mesh, ws.sample_surface(mesh, POINTS), RAYS)


@pytest.fixture(autouse=True)
def _in_this_thread():
    with dask.config.set(scheduler="sync"):
        yield


@pytest.fixture
def computed(monkeypatch):
    """The first rows of the chunks that are computed."""
    ran, bake_chunk = [], baking.bake_chunk

    def counted(call, path, span, *rest):
        ran.append(span.start)
        return bake_chunk(call, path, span, *rest)

    monkeypatch.setattr(baking, "bake_chunk", counted)
    return ran


def bake(path, mesh, *more, **options):
    return cluster.bake(path, "ambient_occlusion", mesh, *(more or (POINTS, RAYS)), **{"chunk": CHUNK, **options})


def whole_chunks(path):
    return holdings.whole_chunks(path, [file.parent.name for file in path.glob("[!.]*/zarr.json")])


def assert_whole(path, right):
    with xr.open_zarr(path) as found:
        for name in ARRAYS:
            assert found[name].dtype == getattr(right, name).dtype
            assert np.array_equal(found[name], getattr(right, name)), name
    assert all(whole_chunks(path))
    assert list(path.parent.iterdir()) == [path]


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


@pytest.mark.parametrize("array", ["value/c/2", "position/c/2/0", "status/c/2"])
@pytest.mark.parametrize("size", [0, 3, -1])
def test_a_chunk_that_is_cut_short_is_found(path, mesh, right, computed, array, size):
    bake(path, mesh)
    computed.clear()
    content = (path / array).read_bytes()
    (path / array).write_bytes(content[:size])
    assert whole_chunks(path).tolist() == [True, True, False]
    bake(path, mesh, resume=True)
    assert computed == [100]
    assert_whole(path, right)


def test_so_is_one_with_another_byte(path, mesh, right):
    bake(path, mesh)
    content = bytearray((path / "value/c/0").read_bytes())
    content[len(content) // 2] ^= 1
    (path / "value/c/0").write_bytes(content)
    assert whole_chunks(path).tolist() == [False, True, True]
    bake(path, mesh, resume=True)
    assert_whole(path, right)


@pytest.mark.parametrize("files", [("value/c/{}",), ("value/c/{}", ".run/chunks/{}")])
def test_a_chunk_in_the_place_of_another_is_found(path, mesh, right, computed, files):
    """It is whole, but not what belongs there; also if it came with its record."""
    bake(path, mesh)
    computed.clear()
    for file in files:
        shutil.copy(path / file.format(0), path / file.format(1))
    assert whole_chunks(path).tolist() == [True, False, True]
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


HOLD = """
import sys
from pathlib import Path
from warpsample.cluster.lock import locked
with locked(Path(sys.argv[1])):
    print("held", flush=True)
    sys.stdin.read()
"""


@pytest.mark.slow
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


def test_a_second_writer_is_refused_until_the_first_is_gone(path, mesh, right, child_environment):
    pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "text": True}
    first = subprocess.Popen([sys.executable, "-c", HOLD, path], env=child_environment, **pipes)
    assert first.stdout.readline() == "held\n"
    with pytest.raises(OSError, match="out.zarr cannot be written: another process is writing it$"):
        bake(path, mesh)
    assert not path.exists()
    first.kill()
    first.communicate()
    assert [file.name for file in path.parent.iterdir()] == [".out.zarr.lock"]
    bake(path, mesh)
    assert_whole(path, right)


def test_what_killed_writers_left_goes(path, mesh, right):
    bake(path, mesh)
    assert_whole(path, right)
    for folder in ("writing-0123abcd", "ended-0123abcd"):
        (path / ".run" / folder).mkdir()
        (path / ".run" / folder / "half").write_bytes(b"half")
    bake(path, mesh, resume=True)
    assert list((path / ".run").glob("*-*")) == []


LIMITED = """
import resource, signal
import warpsample as ws
from warpsample import cluster
signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
resource.setrlimit(resource.RLIMIT_FSIZE, (30_000, 30_000))
cluster.bake({path!r}, "ambient_occlusion", ws.load_mesh("courtyard"), 8000, 2, chunk=4000)
"""


@pytest.mark.slow
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


def test_a_store_by_another_name_has_the_same_lock(path, mesh, right, tmp_path):
    (tmp_path / "link.zarr").symlink_to(path)
    bake(tmp_path / "link.zarr", mesh)  # where there is nothing yet
    (tmp_path / "link.zarr").unlink()
    assert_whole(path, right)
    (tmp_path / "link.zarr").symlink_to(path)
    with lock.locked(path), pytest.raises(OSError, match=r"out.zarr cannot be written: another process is writing it$"):
        bake(tmp_path / "link.zarr", mesh, resume=True)


def test_a_folder_that_is_gone_is_a_sentence(mesh, tmp_path, monkeypatch):
    (tmp_path / "gone").mkdir()
    monkeypatch.chdir(tmp_path / "gone")
    (tmp_path / "gone").rmdir()
    wants = "cannot be written: No such file or directory$"
    with pytest.raises(ValueError, match=f"^path: got 'out.zarr', which {wants}"):
        bake("out.zarr", mesh)
    with pytest.raises(ValueError, match=f"^--output: got 'out.npz', which {wants}"):
        check_output(Path("out.npz"), "--output")


# The command line


@pytest.mark.parametrize(
    "text", ["garbage", "null", "3", "[]", "", '{"attributes": [1], "zarr_format": 3, "node_type": "group"}']
)
def test_metadata_that_cannot_be_read_is_named(path, mesh, text):
    bake(path, mesh)
    (path / "zarr.json").write_text(text)
    with pytest.raises(ValueError, match=r"^path: got '.*out\.zarr', whose zarr\.json cannot be read"):
        bake(path, mesh, resume=True)


def without_consolidated(path):
    """The metadata of all arrays are then those beside their chunks."""
    kept = json.loads((path / "zarr.json").read_text())
    del kept["consolidated_metadata"]
    (path / "zarr.json").write_text(json.dumps(kept))


def test_an_array_that_is_missing_or_damaged_is_named(path, mesh, computed):
    bake(path, mesh)
    without_consolidated(path)
    computed.clear()
    with pytest.warns(RuntimeWarning, match="consolidated metadata"):  # xarray's
        bake(path, mesh, resume=True)
    assert computed == []
    damage_an_array(path, mesh)


def test_an_array_that_is_damaged_is_named_beside_metadata_that_are_not(path, mesh):
    bake(path, mesh)
    damage_an_array(path, mesh)


def damage_an_array(path, mesh):
    (path / "spread/zarr.json").write_text("null")
    with pytest.raises(ValueError, match=r"^path: got '.*out\.zarr', whose array 'spread' cannot be read"):
        bake(path, mesh, resume=True)
    shutil.rmtree(path / "spread")
    with pytest.raises(
        ValueError,
        match=r"^path: got '.*out\.zarr', whose array 'spread' is missing; compute the store again under a new name$",
    ):
        bake(path, mesh, resume=True)


@pytest.mark.parametrize(("key", "value"), [("dimension_names", None), ("shape", []), ("data_type", 3)])
def test_consolidated_metadata_that_are_damaged_are_named(path, mesh, key, value):
    bake(path, mesh)
    kept = json.loads((path / "zarr.json").read_text())
    kept["consolidated_metadata"]["metadata"]["value"][key] = value
    (path / "zarr.json").write_text(json.dumps(kept))
    said = (
        rf"^path: got '.*out\.zarr', whose zarr\.json has another {key} "
        rf"than this run writes at 'value'; compute the store again under a new name$"
    )
    with pytest.raises(ValueError, match=said):
        bake(path, mesh, resume=True)


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ('"value": {', '"volue": {', "has other arrays than this run writes"),
        ('"metadata": {', '"metadota": {', "is damaged"),
        ('"coordinates": "position', '"coordinates": "pasition', "has other coordinates than this run writes"),
    ],
)
def test_so_are_other_names_in_them(path, mesh, old, new, said):
    bake(path, mesh)
    text = (path / "zarr.json").read_text()
    assert old in text
    (path / "zarr.json").write_text(text.replace(old, new))
    with pytest.raises(
        ValueError, match=rf"^path: got '.*out\.zarr', whose zarr\.json {said}; compute the store again under a new name$"
    ):
        bake(path, mesh, resume=True)


def test_so_is_one_of_another_shape(path, mesh):
    bake(path, mesh)
    without_consolidated(path)
    file = path / "spread/zarr.json"
    file.write_text(file.read_text().replace('"float32"', '"float64"'))
    with pytest.raises(
        ValueError,
        match=r".*spread/zarr.json has another data_type than this run writes; compute the store again under a new name$",
    ):
        bake(path, mesh, resume=True)


def test_what_a_user_has_at_hidden_names_stays(path, tmp_path, mesh):
    own = tmp_path / f".{path.name}.part" / "thesis.txt"
    own.parent.mkdir()
    lock = tmp_path / f".{path.name}.lock"
    for file in (own, lock):
        file.write_text("thesis")
    bake(path, mesh)
    assert sorted(file.name for file in tmp_path.iterdir()) == [lock.name, own.parent.name, path.name]
    assert [file.read_text() for file in (own, lock)] == ["thesis", "thesis"]
    assert path.stat().st_mode & 0o777 == own.parent.stat().st_mode & 0o777  # of a folder like others


@pytest.mark.parametrize("kind", ["pipe", "folder", "link"])
def test_a_lock_that_is_no_ordinary_file_is_refused_at_once(kind, path, mesh, tmp_path):
    """A pipe would wait for who reads it, deaf to every signal; a link's target is somebody's."""
    file = tmp_path / lock.lock_name(path)
    {"pipe": os.mkfifo, "folder": os.mkdir, "link": partial(os.symlink, "thesis.txt")}[kind](file)
    with pytest.raises(OSError, match=r"out.zarr cannot be written: its lock file \.out\.zarr\.lock cannot be opened: "):
        bake(path, mesh)
    assert list(tmp_path.iterdir()) == [file]


@pytest.mark.parametrize("name", [".run/chunks/0", "value/c/0", "spread/zarr.json"])
def test_a_pipe_in_a_store_is_no_chunk(name, path, mesh, right):
    bake(path, mesh)
    (path / name).unlink()
    os.mkfifo(path / name)
    if name.endswith("zarr.json"):
        with pytest.raises(ValueError, match=r"whose spread/zarr.json is not an ordinary file$"):
            bake(path, mesh, resume=True)
    else:
        bake(path, mesh, resume=True)
        assert_whole(path, right)


def test_records_of_version_0_1_are_read(path, mesh, computed):
    """They have the CRC-32 of each file; a changed file is computed again."""
    bake(path, mesh)
    for file in (path / ".run/chunks").iterdir():
        content = {"chunk": int(file.name)}
        for name in json.loads(file.read_text())["crc32c"]:
            below = f"{file.name}/0" if name in ("position", "normal") else file.name
            content[name] = crc32((path / name / "c" / below).read_bytes())
        file.write_text(json.dumps(content))
    computed.clear()
    bake(path, mesh, resume=True)
    assert computed == []
    damaged = path / "value/c/1"
    damaged.write_bytes(damaged.read_bytes()[:-1] + b"x")
    bake(path, mesh, resume=True)
    assert computed == [CHUNK]


def test_a_record_of_nothing_but_brackets_is_none(path, mesh, right):
    bake(path, mesh)
    (path / ".run/chunks/0").write_text("[" * 100_000)
    bake(path, mesh, resume=True)
    assert_whole(path, right)


def test_a_folder_in_the_place_of_a_chunk_is_named(path, mesh):
    bake(path, mesh)
    (path / "value/c/1").unlink()
    (path / "value/c/1").mkdir()
    with pytest.raises(OSError, match=r"out.zarr/value/c/1 cannot be written: Is a directory$"):
        bake(path, mesh, resume=True)


def test_a_store_that_cannot_be_made_leaves_nothing(path, tmp_path, mesh):
    path.symlink_to("nowhere/out.zarr")
    with pytest.raises(ValueError, match=r"^path: got .*, whose folder does not exist$"):
        cluster.bake(path, "ambient_occlusion", mesh, POINTS, RAYS, chunk=CHUNK)
    assert list(tmp_path.iterdir()) == [path]
