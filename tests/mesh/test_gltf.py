""".glb and .gltf: scenes are placed, strips and fans cut, short numbers scaled, and none is read by half."""

import copy
import json
import os
import struct
from types import SimpleNamespace

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
    positions = {"componentType": 5122, "type": "VEC3", "count": 3, "normalized": True}
    path.write_text(gltf({}, [positions], data, view={"byteStride": 8}))
    assert ws.load_mesh(path).vertices.tolist() == [[0, 0, 1], [2, 0, 1], [0, -1, 0]]


def test_gltf_is_not_read_by_half(tmp_path):
    path, data = tmp_path / "by_hand.gltf", STRIP[:3].tobytes()
    positions = {"componentType": 5126, "type": "VEC3", "count": 3}
    (tmp_path / "some data.bin").write_bytes(data)
    whole = gltf({}, [positions], data)
    path.write_text(whole)
    assert ws.load_mesh(path).report.faces == 1
    (tmp_path / "model.gltf").write_text(whole)  # trimesh would take this one for one that is damaged
    for damaged, why in [
        (whole[:-1], "Expecting .*"),
        (
            gltf({}, [{**positions, "count": 4}], data),
            r"accessors\[0\] declares 4 VEC3, too many for the 36 bytes of the buffer view",
        ),
        (
            gltf({}, [{**positions, "byteOffset": 1}], data),
            r"accessors\[0\] declares 3 VEC3, too many for the 36 bytes of the buffer view",
        ),
        (
            gltf({}, [{**positions, "sparse": {"count": 1}}], data),
            "the file has sparse accessors, want a file that stores all numbers; .*",
        ),
        (
            gltf({"indices": 5}, [positions], data),
            r"meshes\[0\].primitives\[0\].indices: got 5, want a whole number below 1, .*",
        ),
        (gltf({"mode": 1}, [positions], data), "the file has no visible faces"),
        (
            gltf({}, [positions], data, extensionsUsed=["KHR_draco_mesh_compression"]),
            "the file uses KHR_draco.*, want a file without these extensions; export it again",
        ),
    ]:
        path.write_text(damaged)
        with cases.refused(path, why):
            ws.load_mesh(path)
    path.write_text(whole)
    (tmp_path / "some data.bin").write_bytes(data[:-1])
    with cases.refused(path, "the buffer declares 36 bytes, but has only 35; .*"):
        ws.load_mesh(path)


POSITIONS = {"componentType": 5126, "type": "VEC3", "count": 3}
CORNERS = {"componentType": 5123, "type": "SCALAR", "count": 3, "byteOffset": 36}
DATA = STRIP[:3].tobytes() + np.uint16([0, 1, 2]).tobytes()


def changed(**members):
    """A tree of one triangle under two nodes, with other members at JSON paths such as nodes__0__scale."""
    tree = json.loads(gltf({"indices": 1, "mode": 4}, [POSITIONS, CORNERS], DATA, nodes=[{"children": [1]}, {"mesh": 0}]))
    for path, value in members.items():
        *above, last = [int(key) if key.isdecimal() else key for key in path.split("__")]
        part = tree
        for key in above:
            part = part[key]
        part[last] = value
    return tree


@pytest.fixture
def load(tmp_path):
    """Loads a tree, or the text of one, beside its data."""
    (tmp_path / "some data.bin").write_bytes(DATA)

    def load(tree):
        path = tmp_path / "by_hand.gltf"
        path.write_text(tree if isinstance(tree, str) else json.dumps(tree))
        return ws.load_mesh(path)

    load.refused = lambda why: cases.refused(tmp_path / "by_hand.gltf", why)
    return load


@pytest.mark.parametrize(
    ("nodes", "roots", "why"),
    [
        ([{"children": [0]}], [0], "node 0 is its own ancestor, want a tree of nodes"),
        (
            [{"children": [1]}, {"children": [2]}, {"children": [1]}],
            [0],
            "node 1 is a child of nodes 0 and 2, want one .*",
        ),
        ([{"children": [1]}, {"children": [0]}], [0], "node [01] is its own ancestor, want a tree of nodes"),
        ([{"children": [1, 1]}, {"mesh": 0}], [0], "node 1 is a child of node 0 twice, want one parent for each node"),
        ([{"children": [2]}, {"children": [2]}, {"mesh": 0}], [0, 1], "node 2 is a child of nodes 0 and 1, want .*"),
        (
            [{"children": [1]}, {"mesh": 0}],
            [0, 1],
            r"scenes\[0\] lists node 1, a child of node 0, want only nodes without a parent",
        ),
        ([{"mesh": 0}], [0, 0], r"scenes\[0\] lists node 0 2 times, want each node once"),
        ([{"mesh": 0}], [-1], r"scenes\[0\].nodes\[0\]: got -1, want a whole number below 1, which is how many there are"),
        # 2^12 visits of 13 nodes; of 61 nodes it would have been 2^60.
        (
            [*({"children": [i + 1, i + 1]} for i in range(12)), {"mesh": 0}],
            [0],
            "node 1 is a child of node 0 twice, .*",
        ),
    ],
)
def test_nodes_are_trees(nodes, roots, why, load):
    with load.refused(why):
        load(changed(nodes=nodes, scenes=[{"nodes": roots}]))


def test_nodes_may_be_deep(load):
    step = {"translation": [1, 0, 0]}
    nodes = [*({"children": [i + 1], **step} for i in range(5000)), {"mesh": 0, **step}]
    assert load(changed(nodes=nodes)).vertices.min(axis=0).tolist() == [5001, 0, 0]


@pytest.mark.parametrize(
    ("members", "why"),
    [
        ({"bufferViews__0__byteStride": 0}, r"bufferViews\[0\].byteStride: got 0, want at least 12, the bytes of one VEC3"),
        ({"bufferViews__0__byteLength": 43}, r"bufferViews\[0\] ends at byte 43, but the buffer has only 42 bytes"),
        ({"bufferViews__0__byteOffset": -6}, r"bufferViews\[0\].byteOffset: got -6, want a whole number of at least 0"),
        ({"accessors__0__byteOffset": 9}, r"accessors\[0\] declares 3 VEC3, too many for the 42 bytes of the buffer view"),
        ({"accessors__0__count": 3.0}, r"accessors\[0\].count: got 3.0, want a whole number of at least 0"),
        ({"accessors__0__count": True}, r"accessors\[0\].count: got True, want a whole number of at least 0"),
        ({"accessors__0__type": "VEC2"}, ".*POSITION: got an accessor of type 'VEC2' with .* 5126, want VEC3 with .*"),
        ({"accessors__0__normalized": True}, r"accessors\[0\].normalized: got 32-bit numbers, want numbers of 8 or 16 bits"),
        ({"accessors__1__componentType": 5126}, ".*indices: got an accessor of type 'SCALAR' with .* 5126, want SCALAR .*"),
        ({"accessors__0": None}, r"accessors\[0\]: got None, want an object"),
        ({"meshes__0__primitives__0__attributes": {}}, r"the JSON member .*attributes.POSITION is missing"),
        ({"meshes__0__primitives__0__mode": 7}, r"meshes\[0\].primitives\[0\].mode: got 7, want a whole number from 0 to 6"),
        ({"nodes__1__mesh": -1}, r"nodes\[1\].mesh: got -1, want a whole number below 1, which is how many there are"),
        ({"nodes__0__scale": [1, "2", 1]}, r"nodes\[0\].scale: got \[1, '2', 1\], want 3 finite numbers"),
        ({"nodes__0__translation": [10**400, 0, 0]}, r"nodes\[0\].translation: got .*, want 3 finite numbers"),
        ({"nodes__0__rotation": [0, 0, 0, 0]}, r"nodes\[0\].rotation: got \[0.*\], want a quaternion of length 1"),
        ({"nodes__0__matrix": [float("nan")] * 16}, "the JSON has the number NaN, want finite numbers"),
        ({"nodes__0__matrix": [1] * 16}, r"nodes\[0\].matrix: got a matrix with a perspective, .*"),
        ({"nodes__0__scale": [1e300] * 3, "nodes__1__scale": [1e300] * 3}, "vertices: got coordinates .* not finite.*"),
        ({"asset__version": "1.0"}, "asset.version: got '1.0', want glTF 2.0; export the file as glTF 2.0"),
        ({"asset__version": "3.0"}, "asset.version: got '3.0', want glTF 2.0; .*"),
        ({"asset__minVersion": "2.1"}, "asset.minVersion: got '2.1', want glTF 2.0; .*"),
        ({"asset__version": 2.0}, "asset.version: got 2.0, want a text"),
        ({"asset": []}, r"asset: got \[\], want an object"),
        ({"buffers__0__uri": "data:application/octet-stream,AAAA"}, r"buffers\[0\].uri: got data that are not base64, .*"),
        ({"buffers__0__uri": "data:;base64,***"}, r"buffers\[0\].uri: got data that are not base64, want .*"),
        ({"buffers__0__uri": "%2Fetc/hosts"}, r"buffers\[0\].uri: got '%2Fetc/hosts', want the name of a file, or data"),
        ({"buffers__0__uri": "http://a/b.bin"}, r"buffers\[0\].uri: got 'http://a/b.bin', want the name of a file, or data"),
        ({"buffers__0__uri": "/dev/null"}, r"buffers\[0\].uri: got '/dev/null', want the name of a file, or data"),
        ({"buffers__0__uri": "pipe"}, r"buffers\[0\].uri: got '.*/pipe', which is no ordinary file, want a file"),
        ({"buffers__0__uri": "../gone%20bin"}, r"buffers\[0\].uri: got '.*/\.\./gone bin', which is missing, want a file"),
        ({"buffers__0__uri": "%00"}, r"buffers\[0\].uri: got '.*', which is missing, want a file"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_named_by_its_place(members, why, load, tmp_path):
    os.mkfifo(tmp_path / "pipe")  # opened, it would wait for ever
    with load.refused(why):
        load(changed(**members))


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("[]", r"the JSON is \[\], want an object"),
        ("[" * 100_000, "the JSON is nested too deeply"),
        ('{"extras": ' + 5000 * "1" + "}", "the JSON has a number of more than 4,300 digits"),
        ('{"nodes": [{"mesh": 0, "mesh": 1}]}', "the JSON has an object with two members 'mesh', want each name once"),
    ],
)
def test_what_is_no_json_object_is_refused(text, why, load):
    with load.refused(why):
        load(text)


def places_in(part, above=()):
    for key in part if isinstance(part, dict) else range(len(part)):
        yield (*above, key)
        if isinstance(part[key], dict | list):
            yield from places_in(part[key], (*above, key))


@pytest.mark.parametrize("value", [None, True, -1, 1, 1.0, 2**64, 1e308, "x", [], {}, [0], "/dev/zero"], ids=repr)
def test_any_value_at_any_place_is_read_or_refused(value, load):
    """Without a warning, an error of another kind or a long search."""
    for *above, last in places_in(changed()):
        tree = changed()
        part = tree
        for key in above:
            part = part[key]
        part[last] = copy.deepcopy(value)
        try:
            load(tree)
        except ValueError as error:
            assert str(error).startswith("path: got ")  # noqa: PT017  (many are read)
            assert not str(error).endswith("Error)")  # noqa: PT017


def test_the_second_part_of_a_glb_is_as_long_as_it_declares(tmp_path):
    text = json.dumps(changed(buffers=[{"byteLength": len(DATA)}])).encode()
    path = tmp_path / "by_hand.glb"
    for declared, kind, why in (
        (len(DATA), b"BIN\0", None),
        (len(DATA) + 1, b"BIN\0", "the second chunk declares 43 bytes, but the file has only 42 more"),
        (len(DATA), b"ELSE", "the buffer declares 42 bytes, but has only 0; .*"),
    ):
        parts = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", declared, kind) + DATA
        path.write_bytes(struct.pack("<4sII", b"glTF", 2, 12 + len(parts)) + parts)
        if why is None:
            assert ws.load_mesh(path).report.faces == 1
        else:
            with cases.refused(path, why):
                ws.load_mesh(path)


def test_a_scene_beyond_the_memory_is_refused(load, monkeypatch):
    """A mesh that many nodes place is read once, and what they take is known before it is taken."""
    nodes = [{"mesh": 0, "translation": [i, 0, 0]} for i in range(1000)]
    tree = changed(nodes=nodes, scenes=[{"nodes": list(range(1000))}])
    assert load(tree).report.faces == 1000
    monkeypatch.setattr("warpsample.host.engine._ALWAYS_FREE", 0)
    monkeypatch.setattr("psutil.virtual_memory", lambda: SimpleNamespace(available=20_000))
    with pytest.raises(MemoryError, match=r"^scenes of \d+ vertices and more need .* GB are free; leave out some of it$"):
        load(tree)


@pytest.mark.parametrize(
    "name", ["KHR_materials_clearcoat", "KHR_node_visibility", "KHR_lights_punctual", "EXT_texture_webp"]
)
def test_required_extensions_that_change_no_faces_are_read(name, load):
    assert load(changed(extensionsUsed=[name], extensionsRequired=[name])).report.faces == 1


@pytest.mark.parametrize("name", ["FOO_bar", "KHR_node_visible", "KHR_mesh_quantization_2", "CESIUM_RTC"])
def test_other_required_extensions_are_refused(name, load):
    with load.refused(f"the file requires {name}, want a file that requires none but KHR_mesh_quantization, .*"):
        load(changed(extensionsUsed=[name], extensionsRequired=[name]))
    assert load(changed(extensionsUsed=[name])).report.faces == 1
