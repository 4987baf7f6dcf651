"""Polygons in every kind of file, and what .ply, .obj and .stl hold besides a plain mesh."""

import struct

import mesh_file_cases as cases
import numpy as np
import pytest

import warpsample as ws

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
    """Rows of other elements, with lists of different lengths, are passed over before and after the mesh's own."""
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
        with cases.refused(path, "the file has triangle strips, want separate faces; export the mesh as triangles"):
            ws.load_mesh(path)
        path.write_bytes(head.replace(b"list uchar int", b"list uchar float") + end + data)
        with cases.refused(path, "the header declares vertex_indices of a type with fractions, want whole numbers, .*"):
            ws.load_mesh(path)
        path.write_bytes(head.replace(b"list uchar int", b"list float int") + end + data)
        with cases.refused(path, "the header has the unknown line 'property list float int vertex_indices'"):
            ws.load_mesh(path)
    path.write_bytes(cases.ply("ascii", CORNERS, POLYGONS[:1]).replace(b"\n7 3 ", b"\n7 3.0 "))  # a flag, then the count
    with cases.refused(path, "'3.0' is not a whole number"):
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
        ("f 1 2", "line 18: '1 2' is not a face, want .*"),
        ("f 1/1 2/1 3/", "line 18: .* is not a face, want .*"),
        ("f 1//1 2//1 3/1", "line 18: .* is not a face, want .*"),
        ("f 1 2 7", "a face has the vertex 6, want a vertex from 0 to 5"),
        ("f 1 2 -7", "a face has the vertex -1, want .*"),
        ("f 0 1 2", "line 18: a face has the vertex 0, but vertices count from 1"),
        ("f 1 2 3.5", "line 18: '3.5' is not a whole number"),
        ("f 1 2 99999999999999999999", r"line 18: a face has the vertex 1e\+20, want an index below 2\^31"),
        ("v 1 2", "line 18: a vertex has 2 numbers, want at least 3"),
        ("v 1 2 x", "line 18: 'x' is not a number"),
        ("curv 1 2", "line 18: the keyword 'curv' is unknown"),
        ("f 1 2 3 \\\n", "line 17: the file ends within a line|line 18: the file ends within a line"),
    ]:
        path.write_text(whole + line, encoding="utf-8")
        with cases.refused(path, why):
            ws.load_mesh(path)


def test_stl_corners_are_merged_and_info_says_so(tmp_path, call):
    for kind in ("stl", "stl_text"):
        path = cases.write(kind, tmp_path, cases.SPHERE.vertices, cases.SPHERE.faces)
        report = ws.load_mesh(path).report
        assert (report.vertices, report.faces, report.boundary_edges) == (42, 80, 0)
        status, out, _ = call("info", path)
        assert status == 0
        assert [line for line in out.splitlines() if "merged corners" in line and " 198 " in line]
    signed = np.float64([(0.0, 0, 0), (1, 0, 0), (0, 1, 0), (-0.0, 0, 0), (1, 0, 0), (0, -1, 0)])
    path = cases.write("stl", tmp_path, signed, np.arange(6).reshape(2, 3))
    assert ws.load_mesh(path).report.vertices == 4  # -0 is 0
