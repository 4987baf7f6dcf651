""".glb and .gltf: scenes are placed, strips and fans cut, short numbers scaled, and none is read by half."""

import json

import mesh_file_cases as cases
import numpy as np
import pytest
import trimesh

import warpsample as ws


def hierarchy():
    """Meshes under nodes that turn, mirror, scale and shift, one of them twice."""
    scene, matrices = trimesh.Scene(), trimesh.transformations
    turned = matrices.rotation_matrix(0.7, (1, 2, 3), (0.5, 0, 0))
    scene.add_geometry(cases.SPHERE, "a", "a", transform=turned)
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
    assert volume == pytest.approx(cases.SPHERE.volume + 6.0, rel=1e-5)  # none is inside out


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
    """Positions are 16-bit shares of 32767, each followed by another number, and there are no indices."""
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
        (gltf({}, [{**places, "sparse": {"count": 1}}], data), "it has sparse data, want a file that holds all numbers"),
        (gltf({"indices": 5}, [places], data), "its JSON is incomplete: .*"),
        (gltf({"mode": 1}, [places], data), "it has no faces"),
        (gltf({}, [places], data, nodes=[{"mesh": 0, "children": [0]}]), r".*\(RecursionError\)"),
        (
            gltf({}, [places], data, extensionsUsed=["KHR_draco_mesh_compression"]),
            "it uses KHR_draco.*, want a file that does not",
        ),
    ]:
        path.write_text(damaged)
        with cases.refused(path, why):
            ws.load_mesh(path)
    path.write_text(whole)
    (tmp_path / "some data.bin").write_bytes(data[:-1])
    with cases.refused(path, "it declares 36 bytes of data, but there are 35"):
        ws.load_mesh(path)
