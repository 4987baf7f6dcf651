"""Mesh files of every kind keep all digits; none is read in part, and no memory is taken for data that is missing."""

import os
import struct
import tracemalloc

import mesh_file_cases as cases
import numpy as np
import pytest
import trimesh

import warpsample as ws

CUT_ANYWHERE = [kind for kind in cases.KINDS if kind != "obj" and "usd" not in kind]
"""Kinds of files that tell how long they are, so that a cut is seen wherever it is."""

TETRAHEDRON = (
    np.float64([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]),
    np.array([(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]),
)


@pytest.mark.parametrize(("scale", "offset"), [(1e-6, 0.0), (1.0, 0.0), (1.0, 5e6)])
@pytest.mark.parametrize("kind", cases.EACH_KIND)
def test_coordinates_keep_all_digits_of_the_file(kind, scale, offset, tmp_path):
    vertices = np.random.default_rng(1).normal(size=(42, 3)) * scale + offset
    path = cases.write(kind, tmp_path, vertices, cases.SPHERE.faces)
    mesh = ws.load_mesh(path)
    assert mesh.vertices.dtype == np.float64
    assert mesh.faces.dtype == np.int32
    assert np.array_equal(mesh.vertices[mesh.faces], vertices.astype(cases.HOLDS[kind])[cases.SPHERE.faces])


@pytest.mark.parametrize("kind", [kind for kind in cases.ONE_USD if kind.values[0] not in CUT_ANYWHERE])
def test_what_ends_early_is_refused(kind, tmp_path):
    path = cases.write(kind, tmp_path, cases.SPHERE.vertices, cases.SPHERE.faces)
    content = path.read_bytes()
    for share in (30, 70, 97):
        cut = content[: len(content) * share // 100]
        if kind == "obj":  # which declares no counts: known is what ends within a line
            cut = cut.rpartition(b"\n")[0] + (b"\nf 1 2" if b"f" in cut else b"\nv 1 2")
        path.write_bytes(cut)
        with cases.refused(path):
            ws.load_mesh(path)


@pytest.mark.parametrize("kind", CUT_ANYWHERE)
def test_wherever_it_ends_early_it_is_refused(kind, tmp_path):
    path = cases.write(kind, tmp_path, *TETRAHEDRON)
    content = path.read_bytes()
    needed = content.rstrip() if kind in cases.TEXTS else content
    if kind == "stl_text":  # the solid's name may be shorter
        needed = content[: content.index(b"endsolid") + len(b"endsolid")]
    for end in range(len(needed)):
        path.write_bytes(content[:end])
        with cases.refused(path):
            ws.load_mesh(path)
    path.write_bytes(needed)
    assert ws.load_mesh(path).report.area == pytest.approx(1.5 + 0.75**0.5)


@pytest.mark.parametrize("kind", cases.EACH_KIND)
def test_garbled_empty_and_foreign_files_are_refused(kind, tmp_path, capfd):
    path = cases.write(kind, tmp_path, cases.SPHERE.vertices, cases.SPHERE.faces)
    content = bytearray(path.read_bytes())
    header = slice(80, 84) if kind == "stl" else slice(0, 24)  # where it is the count alone that matters
    content[header] = np.random.default_rng(2).bytes(header.stop - header.start)
    path.write_bytes(content)
    with cases.refused(path):
        ws.load_mesh(path)
    path.write_bytes(b"")
    with cases.refused(path, "the file is empty"):
        ws.load_mesh(path)
    assert_foreign_files_are_refused(kind, tmp_path, {suffix for suffix in cases.SUFFIXES.values() if "usd" not in suffix})
    assert capfd.readouterr() == ("", "")


@pytest.mark.thorough
@pytest.mark.parametrize("kind", cases.KINDS)
def test_foreign_files_are_no_usd(kind, tmp_path, capfd):
    assert_foreign_files_are_refused(kind, tmp_path, {suffix for suffix in cases.SUFFIXES.values() if "usd" in suffix})
    assert capfd.readouterr() == ("", "")


def assert_foreign_files_are_refused(kind, folder, suffixes):
    """A file of one kind under the suffixes of others is no mesh."""
    path = cases.write(kind, folder, cases.SPHERE.vertices, cases.SPHERE.faces)
    for suffix in suffixes - {path.suffix}:
        foreign = folder / f"foreign{suffix}"
        foreign.write_bytes(path.read_bytes())
        with cases.refused(foreign):
            ws.load_mesh(foreign)


@pytest.mark.parametrize(
    ("kind", "declared", "huge"),
    [
        *((kind, b"vertex 42", b"vertex 4000000000") for kind in ("ply_text", "ply_little", "ply_big")),
        *((kind, b"face 80", b"face 4000000000") for kind in ("ply_text", "ply_little", "ply_big")),
        ("ply_little", b"list uchar", b"list uint"),
        ("off", b"42 80", b"4000000000 80"),
        ("off", b"42 80", b"42 4000000000"),
        ("stl", struct.pack("<I", 80), struct.pack("<I", 4_000_000_000)),
        ("gltf", b'"count":240', b'"count":4000000000'),
        ("gltf", b'"byteLength":504}],', b'"byteLength":4000000000}],'),
        ("glb", b'"count":240', b'"count":9e9'),
        ("glb", b'"count":240', b'"count":999'),
    ],
)
def test_huge_counts_allocate_nothing(kind, declared, huge, tmp_path):
    path = cases.write(kind, tmp_path, cases.SPHERE.vertices, cases.SPHERE.faces)
    content = path.read_bytes()
    assert content.count(declared) == 1
    path.write_bytes(content.replace(declared, huge))
    tracemalloc.start()
    try:
        with cases.refused(path):
            ws.load_mesh(path)
        assert tracemalloc.get_traced_memory()[1] < 1e6
    finally:
        tracemalloc.stop()


@pytest.mark.parametrize("kind", cases.ONE_USD)
def test_reading_takes_no_more_than_twice_the_file_and_the_mesh(kind, tmp_path):
    sphere = trimesh.creation.icosphere(subdivisions=4)
    path = cases.write(kind, tmp_path, sphere.vertices, sphere.faces)
    ws.load_mesh(path)  # imports
    tracemalloc.start()
    try:
        mesh = ws.load_mesh(path)
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    arrays = [array for array in (mesh.vertices, mesh.faces, mesh.part) if array is not None]
    assert peak <= 2 * (path.stat().st_size + sum(array.nbytes for array in arrays))


def test_missing_and_foreign_files_are_named(tmp_path):
    with pytest.raises(FileNotFoundError, match=r"^path: got .*nothing\.ply', which is missing"):
        ws.load_mesh(tmp_path / "nothing.ply")
    with pytest.raises(FileNotFoundError, match="which is a folder, want a mesh file"):
        ws.load_mesh(tmp_path)
    os.mkfifo(tmp_path / "pipe.ply")  # opened, it would wait for ever
    (tmp_path / "device.ply").symlink_to("/dev/zero")
    for name in ("pipe.ply", "device.ply"):
        with pytest.raises(FileNotFoundError, match=f"{name}', which is no ordinary file, want a mesh file"):
            ws.load_mesh(tmp_path / name)
    (tmp_path / "notes.txt").write_text("hello")
    with pytest.raises(ValueError, match=r"^path: got 'notes\.txt', want a file that ends in one of \.ply"):
        ws.load_mesh(tmp_path / "notes.txt")


@pytest.mark.parametrize("number", ["1_0", "\u0661"])
@pytest.mark.parametrize(
    ("suffix", "text"),
    [
        (".obj", "v {} 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
        (".off", "OFF\n3 1 0\n{} 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
        (".ply", ("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                 "element face 1\nproperty list uchar int vertex_indices\nend_header\n{} 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")),
        (".stl", ("solid s\nfacet normal 0 0 1\nouter loop\nvertex {} 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
                 "endfacet\nendsolid s\n")),
    ],
)  # fmt: skip
def test_what_only_python_takes_for_a_number_is_refused(tmp_path, suffix, text, number):
    path = tmp_path / f"mesh{suffix}"
    path.write_text(text.format("5.0"))
    assert ws.load_mesh(path).vertices[:, 0].max() == 5.0
    path.write_text(text.format(number), encoding="utf-8")
    with pytest.raises(ValueError, match="which cannot be read as a mesh: "):
        ws.load_mesh(path)
