"""Numbers at the vertices of a .glb become attributes of it, and nothing else in it changes."""

import numpy as np
from textured_scenes import array_of, opened, rich, with_data_outside

import warpsample as ws


def test_a_glb_keeps_all_that_it_has(call, tmp_path):
    path, output = tmp_path / "in.glb", tmp_path / "out.glb"
    path.write_bytes(rich())
    status, out, err = call("bake", path, "-o", output, "--samples", 64)
    assert (status, err) == (0, "")
    assert "\n  the colours of 'Wånd' are replaced\n" in out
    mesh = ws.load_mesh(path)
    value = ws.ambient_occlusion(mesh, ws.vertex_points(mesh), 64).value
    before, after = opened(path), opened(output)
    for number, rows in ((0, slice(0, 4)), (1, slice(4, 8))):
        had = before[0]["meshes"][number]["primitives"][0]["attributes"]
        attributes = after[0]["meshes"][number]["primitives"][0]["attributes"]
        assert np.array_equal(array_of(*after[:2], attributes.pop("_value"))[:, 0], value[rows])
        colours = array_of(*after[:2], attributes["COLOR_0"])
        assert np.array_equal(colours[:, 0], np.round(255 * value[rows]).astype(np.uint8))
        assert after[0]["accessors"][attributes.pop("COLOR_0")]["normalized"] is True
        assert {attributes.pop(name) for name in ("_standard_error", "_rays", "_status")} & set(had.values()) == set()
        had.pop("COLOR_0", None)
        assert attributes == had
        after[0]["meshes"][number]["primitives"][0]["attributes"] = had
    for key in ("bufferViews", "accessors"):
        assert len(after[0][key]) == len(before[0][key]) + 10
        del after[0][key][-10:]
    after[0]["buffers"] = before[0]["buffers"]
    assert after[0] == before[0]
    assert after[1].startswith(before[1])
    assert after[2] == before[2]
    assert np.array_equal(ws.load_mesh(output).vertices, mesh.vertices)


def test_a_mesh_in_two_places_has_the_numbers_of_the_first(call, tmp_path):
    from glb_files import placed_twice

    quad = np.array([(0, 0, 0), (2, 0, 0), (2, 1, 0), (0, 1, 0)], np.float32)
    path, output = placed_twice(tmp_path / "in.glb", quad), tmp_path / "out.glb"
    status, out, _ = call("bake", path, "-o", output, "--samples", 16)
    assert (status, "of 'meshes[0]', in several places, the first place counts" in out) == (0, True)
    tree, data, _ = opened(output)
    assert "_value" not in tree["meshes"][1]["primitives"][0]["attributes"]  # of points
    assert array_of(tree, data, tree["meshes"][1]["primitives"][1]["attributes"]["_value"]).shape == (4, 1)


def test_a_file_that_cannot_be_edited_is_refused_before_the_work(call, tmp_path):
    path = with_data_outside(tmp_path / "in.glb")
    status, _, err = call("bake", path, "-o", tmp_path / "out.glb", "--samples", 16)
    assert (status, "cannot be read as a glTF file to be edited: the buffer buffers[0] is in another file" in err) == (
        2,
        True,
    )
