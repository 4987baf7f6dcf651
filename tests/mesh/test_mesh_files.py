"""Mesh files: every format keeps all digits, polygons and instances, and no truncated file is read."""

import json
import re
import struct
import sys
import tracemalloc

import mesh_file_cases as cases
import numpy as np
import pytest
import trimesh

import warpsample as ws

SPHERE = trimesh.creation.icosphere(subdivisions=1)
TETRAHEDRON = (
    np.float64([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]),
    np.array([(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]),
)


def refused(path, why=".+"):
    return pytest.raises(ValueError, match=f"^path: got '{re.escape(str(path))}', which cannot be read as a mesh: {why}$")


@pytest.mark.parametrize(("scale", "offset"), [(1e-6, 0.0), (1.0, 0.0), (1.0, 5e6)])
@pytest.mark.parametrize("kind", cases.KINDS)
def test_coordinates_keep_all_digits_of_the_file(kind, scale, offset, tmp_path):
    vertices = np.random.default_rng(1).normal(size=(42, 3)) * scale + offset
    path = cases.write(kind, tmp_path, vertices, SPHERE.faces)
    mesh = ws.load_mesh(path)
    assert mesh.vertices.dtype == np.float64
    assert mesh.faces.dtype == np.int32
    assert np.array_equal(mesh.vertices[mesh.faces], vertices.astype(cases.HOLDS[kind])[SPHERE.faces])


@pytest.mark.parametrize("kind", cases.KINDS)
def test_what_ends_early_is_refused(kind, tmp_path):
    path = cases.write(kind, tmp_path, SPHERE.vertices, SPHERE.faces)
    content = path.read_bytes()
    for share in (30, 70, 97):
        cut = content[: len(content) * share // 100]
        if kind == "obj":  # which declares no counts: known is what ends within a line
            cut = cut.rpartition(b"\n")[0] + (b"\nf 1 2" if b"f" in cut else b"\nv 1 2")
        path.write_bytes(cut)
        with refused(path):
            ws.load_mesh(path)


@pytest.mark.parametrize("kind", [kind for kind in cases.KINDS if kind != "obj" and "usd" not in kind])
def test_wherever_it_ends_early_it_is_refused(kind, tmp_path):
    path = cases.write(kind, tmp_path, *TETRAHEDRON)
    content = path.read_bytes()
    needed = content.rstrip() if kind in cases.TEXTS else content
    if kind == "stl_text":  # the solid's name may be shorter
        needed = content[: content.index(b"endsolid") + len(b"endsolid")]
    for end in range(len(needed)):
        path.write_bytes(content[:end])
        with refused(path):
            ws.load_mesh(path)
    path.write_bytes(needed)
    assert ws.load_mesh(path).report.area == pytest.approx(1.5 + 0.75**0.5)


@pytest.mark.parametrize("kind", cases.KINDS)
def test_garbled_empty_and_foreign_files_are_refused(kind, tmp_path, capfd):
    path = cases.write(kind, tmp_path, SPHERE.vertices, SPHERE.faces)
    content = bytearray(path.read_bytes())
    header = slice(80, 84) if kind == "stl" else slice(0, 24)  # where it is the count alone that matters
    content[header] = np.random.default_rng(2).bytes(header.stop - header.start)
    path.write_bytes(content)
    with refused(path):
        ws.load_mesh(path)
    path.write_bytes(b"")
    with refused(path, "it is empty"):
        ws.load_mesh(path)
    path = cases.write(kind, tmp_path, SPHERE.vertices, SPHERE.faces)
    for suffix in set(cases.SUFFIXES.values()) - {path.suffix}:
        foreign = tmp_path / f"foreign{suffix}"
        foreign.write_bytes(path.read_bytes())
        with refused(foreign):
            ws.load_mesh(foreign)
    assert capfd.readouterr() == ("", "")


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
    path = cases.write(kind, tmp_path, SPHERE.vertices, SPHERE.faces)
    content = path.read_bytes()
    assert content.count(declared) == 1
    path.write_bytes(content.replace(declared, huge))
    tracemalloc.start()
    try:
        with refused(path):
            ws.load_mesh(path)
        assert tracemalloc.get_traced_memory()[1] < 1e6
    finally:
        tracemalloc.stop()


def test_huge_tables_of_binary_usd_allocate_nothing(tmp_path):
    path = cases.write("usdc", tmp_path, SPHERE.vertices, SPHERE.faces)
    content = bytearray(path.read_bytes())
    table = int.from_bytes(content[16:24], "little")
    content[table : table + 8] = (10**8).to_bytes(8, "little")  # usd-core would take 3 GB for them
    path.write_bytes(content)
    with refused(path, "its header declares 100,000,000 sections .*"):
        ws.load_mesh(path)


@pytest.mark.parametrize("kind", cases.KINDS)
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
    assert peak <= 2 * (path.stat().st_size + mesh.vertices.nbytes + mesh.faces.nbytes)


POLYGONS = [[0, 1, 2], [0, 1, 2, 3], [10, 4, 5, 6, 7, 8, 9], [0, 1, 11, 2, 3]]
"""A triangle, a square, an L that is not convex and has a corner on an edge, and a pentagon."""
CORNERS = np.float64([(0, 0, 0), (4, 0, 0), (4, 4, 0), (0, 4, 0), (9, 2, 1), (7, 2, 1), (7, 4, 1), (6, 4, 1), (6, 0, 1)])
CORNERS = np.vstack([CORNERS, [(7, 0, 1), (9, 0, 1), (5, 2, 0)]])


@pytest.mark.parametrize("kind", ["ascii", "binary_little_endian", "binary_big_endian", "obj", "off", "usda"])
def test_polygons_are_cut_into_triangles_without_loss(kind, tmp_path):
    path = tmp_path / f"polygons.{'ply' if kind not in ('obj', 'off', 'usda') else kind}"
    if kind == "obj":
        path.write_text(cases.rows(CORNERS, "v ") + "".join(cases.rows([p], "f ", 1) for p in POLYGONS))
    elif kind == "off":
        faces = "".join(cases.rows([[len(p), *p, 255, 0, 0]]) for p in POLYGONS)  # with a colour
        path.write_text(f"OFF {len(CORNERS)} {len(POLYGONS)} 0\n{cases.rows(CORNERS)}{faces}")
    elif kind == "usda":
        counts, indices = [len(p) for p in POLYGONS], [i for p in POLYGONS for i in p]
        path.write_text(
            f'#usda 1.0\ndef Mesh "m" {{\npoint3f[] points = {[tuple(c) for c in CORNERS.tolist()]}\n'
            f"int[] faceVertexCounts = {counts}\nint[] faceVertexIndices = {indices}\n}}\n"
        )
    else:
        path.write_bytes(cases.ply(kind, CORNERS, POLYGONS))
    mesh = ws.load_mesh(path)
    assert mesh.report.faces == 1 + 2 + 5 + 3
    assert mesh.report.area == pytest.approx(8.0 + 16.0 + (3.0 * 2.0 + 1.0 * 2.0) + 18.0)  # no triangle lies outside
    assert (mesh.face_normals[mesh.face_areas > 0.0] == (0, 0, 1)).all()


def test_ply_of_other_elements(tmp_path):
    """Elements that are ignored, before and after the mesh, with lists of different lengths."""
    path = tmp_path / "more.ply"
    for order in ("ascii", "binary_big_endian"):
        whole = cases.ply(order, CORNERS, POLYGONS[:1])
        extra = b"element extra 2\nproperty list ushort double parts\nproperty short flag\n"
        row = b"2 0.5 0.5 9\n0 9\n" if order == "ascii" else struct.pack(">HddhHh", 2, 0.5, 0.5, 9, 0, 9)
        head, end, data = whole.partition(b"end_header\n")
        path.write_bytes(head + extra + end + data + row)
        assert ws.load_mesh(path).report.area == 8.0
        path.write_bytes(head.replace(b"element vertex", extra + b"element vertex") + end + row + data)
        assert ws.load_mesh(path).report.area == 8.0
        path.write_bytes(head + extra.replace(b"extra", b"tristrips") + end + data + row)
        with refused(path, "it has triangle strips, want all of them as faces"):
            ws.load_mesh(path)
        path.write_bytes(head.replace(b"list uchar int", b"list float int") + end + data)
        with refused(path, "its header has the line 'property list float int vertex_indices'"):
            ws.load_mesh(path)


def test_obj_indices_and_lines(tmp_path):
    path = tmp_path / "lines.obj"
    triangle = "v 0 0 {0}\nv 1 0 {0}\nv 0 1 {0} 1 0.5 0.5\n"
    path.write_text(
        "\ufeff# with a mark\no first\n" + triangle.format(0) + "vt 0 0\nvn 0 0 1\nf -3 -2 -1\n"
        "o second\r\n" + triangle.format(1) + "f -3//1 -2//1 -1//1\nf 1/1/1 2/1/1 \\\n 3/1/1\nl 1 2\np 1\n",
        encoding="utf-8",
    )
    mesh = ws.load_mesh(path)
    assert mesh.vertices[mesh.faces][:, :, 2].tolist() == [[0, 0, 0], [1, 1, 1], [0, 0, 0]]
    whole = path.read_text(encoding="utf-8")
    for line, why in [
        ("f 1 2", "line 18: it is no face: '1 2'"),
        ("f 1/1 2/1 3/", "line 18: it is no face: .*"),
        ("f 1//1 2//1 3/1", "line 18: it is no face: .*"),
        ("f 1 2 7", "a face has the vertex 6, and there are 6, from 0 on"),
        ("f 1 2 -7", "a face has the vertex -1, and .*"),
        ("f 0 1 2", "line 18: a face has the vertex 0, and they count from 1"),
        ("f 1 2 3.5", "line 18: invalid literal .*"),
        ("v 1 2", "line 18: a vertex has 2 numbers, not 3"),
        ("v 1 2 x", "line 18: could not convert .*"),
        ("curv 1 2", "line 18: it begins with 'curv'"),
        ("f 1 2 3 \\\n", "line 17: it ends within a line|line 18: it ends within a line"),
    ]:
        path.write_text(whole + line, encoding="utf-8")
        with refused(path, why):
            ws.load_mesh(path)


def test_stl_corners_are_merged_and_info_says_so(tmp_path, call):
    for kind in ("stl", "stl_text"):
        path = cases.write(kind, tmp_path, SPHERE.vertices, SPHERE.faces)
        report = ws.load_mesh(path).report
        assert (report.vertices, report.faces, report.boundary_edges) == (42, 80, 0)
        status, out, _ = call("info", path)
        assert status == 0
        assert [line for line in out.splitlines() if "merged corners" in line and " 198 " in line]
    signed = np.float64([(0.0, 0, 0), (1, 0, 0), (0, 1, 0), (-0.0, 0, 0), (1, 0, 0), (0, -1, 0)])
    path = cases.write("stl", tmp_path, signed, np.arange(6).reshape(2, 3))
    assert ws.load_mesh(path).report.vertices == 4  # -0 is 0


def hierarchy():
    """Meshes below nodes that rotate, mirror, scale and translate, one of them twice."""
    scene, matrices = trimesh.Scene(), trimesh.transformations
    turned = matrices.rotation_matrix(0.7, (1, 2, 3), (0.5, 0, 0))
    scene.add_geometry(SPHERE, "a", "a", transform=turned)
    scene.add_geometry(trimesh.creation.box(), "b", "b", parent_node_name="a", transform=np.diag([-2.0, 1.0, 3.0, 1.0]))
    scene.graph.update("again", "b", geometry="a", matrix=matrices.translation_matrix((5e6, -5e6, 1e-9)))
    return scene


@pytest.mark.parametrize("suffix", ["glb", "gltf"])
def test_gltf_scenes_are_placed(suffix, tmp_path):
    scene = hierarchy()
    path = tmp_path / f"scene.{suffix}"
    if suffix == "glb":
        scene.export(path)
    else:
        for name, content in trimesh.exchange.gltf.export_gltf(scene).items():
            (tmp_path / name.replace("model", "scene")).write_bytes(content)
    mesh, expected = ws.load_mesh(path), trimesh.load_scene(path, process=False).to_mesh()
    assert mesh.report.faces == 80 + 12 + 80
    assert mesh.report.area == pytest.approx(expected.area)
    ours, theirs = (np.sort(m.vertices[m.faces].mean(axis=1), axis=0) for m in (mesh, expected))
    assert np.abs(ours - theirs).max() <= 1e-8
    assert np.einsum("ij,ij->", ours, ours) > 0.0
    volume = np.einsum("ij,ij->", *(mesh.vertices[mesh.faces[:, 0]][:92], mesh.cross_products[:92])) / 6.0
    assert volume == pytest.approx(SPHERE.volume + 6.0, rel=1e-5)  # none is inside out


def gltf(primitive, accessors, data, **more):
    """A .gltf by hand: one node, one primitive, all accessors in one view."""
    views = [{"buffer": 0, "byteLength": len(data), **more.pop("view", {})}]
    return json.dumps(
        {
            "asset": {"version": "2.0"},
            "scenes": [{"nodes": [0]}],
            "nodes": [{"mesh": 0, "rotation": [0, 0, 0, 1], "scale": [2, 1, 1], "translation": [0, 0, 1]}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, **primitive}]}],
            "accessors": [{"bufferView": 0, **accessor} for accessor in accessors],
            "bufferViews": views,
            "buffers": [{"uri": "some%20data.bin", "byteLength": len(data)}],
            **more,
        }
    )


STRIP = np.float32([(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0), (0, 2, 0)])
FAN = np.float32([(0, 0, 0), (1, 0, 0), (2, 1, 0), (1, 2, 0), (0, 2, 0)])


@pytest.mark.parametrize(("mode", "points", "area"), [(5, STRIP, 3.0), (6, FAN, 6.0)])
def test_gltf_strips_and_fans(mode, points, area, tmp_path):
    path = tmp_path / "by_hand.gltf"
    (tmp_path / "some data.bin").write_bytes(points.tobytes())
    path.write_text(gltf({"mode": mode}, [{"componentType": 5126, "type": "VEC3", "count": 5}], points.tobytes()))
    mesh = ws.load_mesh(path)
    assert mesh.report.area == pytest.approx(area)
    assert (mesh.face_normals == (0, 0, 1)).all()
    assert (mesh.vertices[:, 2] == 1.0).all()


def test_gltf_of_short_numbers_far_apart(tmp_path):
    """Normalised positions of 16 bits, each followed by another number, and no indices."""
    path, data = tmp_path / "short.gltf", np.int16([(0, 0, 0, 9), (32767, 0, 0, 9), (0, -32767, -32768, 9)]).tobytes()
    (tmp_path / "some data.bin").write_bytes(data)
    places = {"componentType": 5122, "type": "VEC3", "count": 3, "normalized": True}
    path.write_text(gltf({}, [places], data, view={"byteStride": 8}))
    assert ws.load_mesh(path).vertices.tolist() == [[0, 0, 1], [2, 0, 1], [0, -1, 0]]


def test_gltf_is_not_read_by_half(tmp_path):
    path, data = tmp_path / "by_hand.gltf", STRIP[:3].tobytes()
    places = {"componentType": 5126, "type": "VEC3", "count": 3}
    (tmp_path / "some data.bin").write_bytes(data)
    whole = gltf({}, [places], data)
    path.write_text(whole)
    assert ws.load_mesh(path).report.faces == 1
    (tmp_path / "model.gltf").write_text(whole)  # trimesh would take this one for one that is damaged
    for damaged, why in [
        (whole[:-1], "Expecting .*"),
        (gltf({}, [{**places, "count": 4}], data), "it declares 4 VEC3 in 36 bytes"),
        (gltf({}, [{**places, "byteOffset": 1}], data), "it declares 3 VEC3 in 36 bytes"),
        (gltf({}, [{**places, "sparse": {"count": 1}}], data), "it has sparse data, want all of its numbers"),
        (gltf({"indices": 5}, [places], data), "its description is not whole: .*"),
        (gltf({"mode": 1}, [places], data), "there is no face in it"),
        (gltf({}, [places], data, nodes=[{"mesh": 0, "children": [0]}]), r".*\(RecursionError\)"),
        (
            gltf({}, [places], data, extensionsUsed=["KHR_draco_mesh_compression"]),
            "it needs KHR_draco.*, want a file without",
        ),
    ]:
        path.write_text(damaged)
        with refused(path, why):
            ws.load_mesh(path)
    path.write_text(whole)
    (tmp_path / "some data.bin").write_bytes(data[:-1])
    with refused(path, "it declares 36 bytes of data, and there are 35"):
        ws.load_mesh(path)


def triangle(stage, path, z=0.0):
    from pxr import UsdGeom

    mesh = UsdGeom.Mesh.Define(stage, path)
    mesh.GetPointsAttr().Set([(0, 0, z), (1, 0, z), (0, 1, z)])
    mesh.GetFaceVertexCountsAttr().Set([3])
    mesh.GetFaceVertexIndicesAttr().Set([0, 1, 2])
    return mesh


@pytest.fixture
def stage(tmp_path):
    from pxr import Usd

    return Usd.Stage.CreateNew(str(tmp_path / "scene.usda"))


def loaded(stage):
    stage.GetRootLayer().Save()
    return ws.load_mesh(stage.GetRootLayer().realPath)


def test_usd_polygons_placement_and_mirroring(stage):
    from pxr import Gf

    triangle(stage, "/moved").AddTranslateOp().Set(Gf.Vec3d(0, 0, 5e6 + 1e-3))
    triangle(stage, "/mirrored").AddScaleOp().Set(Gf.Vec3f(-1, 1, 1))
    left = triangle(stage, "/left")
    left.GetFaceVertexIndicesAttr().Set([0, 2, 1])
    left.CreateOrientationAttr("leftHanded")
    mesh = loaded(stage)
    assert mesh.report.area == 1.5
    assert mesh.report.upper[2] == 5e6 + 1e-3
    assert (mesh.face_normals == (0, 0, 1)).all()  # the mirrored one and the left-handed one are turned back


def test_usd_instances_are_placed_and_empty_prims_left_out(stage):
    from pxr import Gf, UsdGeom

    stage.CreateClassPrim("/prototype")
    triangle(stage, "/prototype/mesh", 1.0)
    for x in (0, 10, 20):
        place = UsdGeom.Xform.Define(stage, f"/at{x}")
        place.AddTranslateOp().Set(Gf.Vec3d(x, 0, 0))
        place.GetPrim().GetReferences().AddInternalReference("/prototype")
        place.GetPrim().SetInstanceable(True)
    UsdGeom.Mesh.Define(stage, "/empty")
    UsdGeom.Points.Define(stage, "/points").GetPointsAttr().Set([(99, 99, 99)])
    mesh = loaded(stage)
    assert mesh.vertices[mesh.faces[:, 0]].tolist() == [[0, 0, 1], [10, 0, 1], [20, 0, 1]]


def test_usd_point_instancers_are_placed(stage):
    from pxr import Gf, UsdGeom

    many = UsdGeom.PointInstancer.Define(stage, "/many")
    many.AddTranslateOp().Set(Gf.Vec3d(0, 0, 100))
    stage.OverridePrim("/many/prototypes")
    UsdGeom.Xform.Define(stage, "/many/prototypes/one").AddTranslateOp().Set(Gf.Vec3d(0, 5, 0))
    triangle(stage, "/many/prototypes/one/mesh").AddTranslateOp().Set(Gf.Vec3d(0, 0, 1))
    triangle(stage, "/many/prototypes/two")
    many.GetPrototypesRel().SetTargets(["/many/prototypes/one", "/many/prototypes/two"])
    many.GetProtoIndicesAttr().Set([0, 0, 1, 0])
    many.GetPositionsAttr().Set([(0, 0, 0), (10, 0, 0), (20, 0, 0), (30, 0, 0)])
    many.GetScalesAttr().Set([(1, 1, 1), (-2, 2, 2), (1, 1, 1), (1, 1, 1)])
    many.GetInvisibleIdsAttr().Set([3])
    mesh = loaded(stage)
    assert mesh.vertices[mesh.faces.min(axis=1)].tolist() == [[0, 5, 101], [10, 10, 102], [20, 0, 100]]
    assert mesh.face_areas.tolist() == [0.5, 2.0, 0.5]
    assert (mesh.face_normals == (0, 0, 1)).all()


def test_usd_shows_what_a_renderer_shows(stage):
    triangle(stage, "/hidden").MakeInvisible()
    triangle(stage, "/hidden/below")
    triangle(stage, "/guide").CreatePurposeAttr("guide")
    triangle(stage, "/proxy").CreatePurposeAttr("proxy")
    triangle(stage, "/render", 1.0).CreatePurposeAttr("render")
    moving = triangle(stage, "/moving")
    moving.GetPointsAttr().Clear()
    for time in (2.0, 3.0):
        moving.GetPointsAttr().Set([(0, 0, time), (1, 0, time), (0, 1, time)], time)
    mesh = loaded(stage)
    assert mesh.vertices[mesh.faces[:, 0], 2].tolist() == [1.0, 2.0]


def test_usd_that_is_not_whole_is_refused_in_one_sentence(stage, tmp_path, capfd):
    from pxr import UsdGeom

    path = tmp_path / "refers.usda"
    path.write_text('#usda 1.0\ndef Xform "x" (prepend references = @./missing.usda@</m>) { }\n')
    with refused(path, "Could not open asset .*missing.usda@ .*"):
        ws.load_mesh(path)
    path = tmp_path / "bad_byte.usda"
    path.write_bytes(b'#usda 1.0\ndef Mesh "m\xbe\xff" { }\n')
    with refused(path, "it is damaged"):
        ws.load_mesh(path)
    path = cases.write("usdz", tmp_path, SPHERE.vertices, SPHERE.faces)
    content = bytearray(path.read_bytes())
    content[len(content) // 2] ^= 1
    path.write_bytes(content)
    with refused(path, "inner.usdc in it is damaged"):
        ws.load_mesh(path)
    triangle(stage, "/mesh")
    UsdGeom.Sphere.Define(stage, "/ball")
    with refused(tmp_path / "scene.usda", "/ball is a Sphere, want meshes alone"):
        loaded(stage)
    assert capfd.readouterr() == ("", "")


def test_missing_and_foreign_files_are_named(tmp_path):
    with pytest.raises(FileNotFoundError, match=r"^path: got .*nothing\.ply', which is missing"):
        ws.load_mesh(tmp_path / "nothing.ply")
    with pytest.raises(FileNotFoundError, match="which is a folder, want a mesh file"):
        ws.load_mesh(tmp_path)
    (tmp_path / "notes.txt").write_text("hello")
    with pytest.raises(ValueError, match=r"^path: got 'notes\.txt', want a file that ends in one of \.ply"):
        ws.load_mesh(tmp_path / "notes.txt")


def test_usd_without_usd_core_says_what_to_install(bunny_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "pxr", None)
    with pytest.raises(ModuleNotFoundError, match=r"^path: got 'bunny\.usd', which needs usd-core: pip install usd-core"):
        ws.load_mesh(bunny_path)


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
