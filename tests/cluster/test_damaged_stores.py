"""Damaged stores: chunks and records that changed are computed again, and metadata that cannot be read are named."""

import json
import os
import shutil
from zlib import crc32

import pytest

pytest.importorskip("dask")
pytest.importorskip("zarr")

from store_cases import CHUNK, assert_whole, bake, whole_chunks

# seconds each, and kernels to compile; .ci/run runs them too
pytestmark = [pytest.mark.slow, pytest.mark.usefixtures("in_this_thread")]


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
        rf"^path: got '.*out\.zarr', whose zarr\.json has another '{key}' "
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
        match=r".*spread/zarr.json has another 'data_type' than this run writes; compute the store again under a new name$",
    ):
        bake(path, mesh, resume=True)


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
