"""A .glb with much in it that a baker might lose, and what it holds when it is read back."""

import io
import json
import struct

import numpy as np
import trimesh
from glb_files import glb
from PIL import Image

from warpsample.mesh.files.gltf import iterate_primitives
from warpsample.texture.glb_file import GlbFile

RAYS = ("--samples", 256)
SQUARE = np.array([(0, 0), (1, 0), (1, 1), (0, 1)], np.float32)
TWO = np.array([0, 1, 2, 0, 2, 3], np.uint16)


def corner():
    """A floor y = 0 of 2 x 4 beside a wall of height 1 at x = 0, both long in z, each with coordinates; y is up."""
    floor = np.array([(0, 0, 40), (2, 0, 40), (2, 0, -40), (0, 0, -40)], np.float32)
    wall = np.array([(0, 0, 40), (0, 0, -40), (0, 1, -40), (0, 1, 40)], np.float32)
    return floor, wall


def rich(with_uv=True):
    """The bytes of a scene: a floor with a material that has an occlusion in its second set, a mirrored, skinned wall.

    The wall has morph targets, joints, colours and a name in another script; its material has no occlusion, and two
    variants. There are an animation, extras, an extension that nobody knows, and a mesh that the scene does not place.
    """
    floor, wall = corner()
    down = (1 - SQUARE) * (-1, 1) + (1, 0)  # u to the right, v down
    arrays = [floor, (5 * SQUARE).astype(np.float32), down.astype(np.float32), TWO]
    arrays += [wall * np.float32([-1, 1, 1]), TWO.reshape(2, 3)[:, ::-1].ravel().copy(), down.astype(np.float32)]
    arrays += [
        np.repeat(np.array([[0, 1, 0, 0]], np.uint8), 4, axis=0),
        np.repeat(np.float32([[0.5, 0.5, 0, 0]]), 4, axis=0),
    ]
    arrays += [wall * np.float32(0.01), np.arange(12, dtype=np.uint8).reshape(4, 3) * 20, np.float32([0.0, 1.0])]
    arrays += [np.tile(np.float32([[1, 0, 0]]), (4, 1)), np.arange(4, dtype=np.float32)]
    attributes = {"POSITION": 4, "NORMAL": 12, "JOINTS_0": 7, "WEIGHTS_0": 8, "COLOR_0": 10, "_AGE": 13}
    variants = {"mappings": [{"material": 2, "variants": [0]}, {"material": 1, "variants": [1]}]}
    walls = {
        "attributes": attributes | ({"TEXCOORD_0": 6} if with_uv else {}),
        "indices": 5,
        "material": 1,
        "targets": [{"POSITION": 9}],
        "extensions": {"KHR_materials_variants": variants},
        "extras": {"kept": [1.0, 1e-7, True, None]},
    }
    floors = {"attributes": {"POSITION": 0, "TEXCOORD_0": 1, "TEXCOORD_1": 2}, "indices": 3, "material": 0}
    transform = {"KHR_texture_transform": {"scale": [0.5, 0.25], "texCoord": 0}}
    ground = {"name": "ground", "occlusionTexture": {"index": 0, "texCoord": 1, "extensions": transform}}
    ground["pbrMetallicRoughness"] = {"metallicRoughnessTexture": {"index": 0}}
    tree = {
        "meshes": [
            {"name": "floor", "primitives": [floors]},
            {"name": "Wånd", "primitives": [walls], "weights": [0.5]},
            {"name": "spare", "primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 3, "material": 0}]},
        ],
        "nodes": [
            {"mesh": 0, "name": "floor"},
            {"mesh": 1, "name": "wall", "skin": 0, "scale": [-1, 1, 1]},
            {"name": "joint"},
            {"mesh": 2},
            {"name": "another joint"},
        ],
        "scenes": [{"nodes": [0, 1, 2, 4]}],
        "materials": [ground, {"name": "brick", "alphaMode": "OPAQUE"}, {"name": "snow"}],
        "textures": [{"source": 0}],
        "images": [{"uri": "data:image/png;base64,iVBORw0KGgo="}],
        "skins": [{"joints": [2, 4]}],
        "animations": [
            {
                "channels": [{"sampler": 0, "target": {"node": 2, "path": "weights"}}],
                "samplers": [{"input": 11, "output": 11}],
            }
        ],
        "extensionsUsed": ["KHR_materials_variants", "KHR_texture_transform", "EXT_nobody_knows"],
        "extensions": {"KHR_materials_variants": {"variants": [{"name": "a"}, {"name": "b"}]}, "EXT_nobody_knows": {"x": 1}},
    }
    made = glb(tree, arrays)
    after = struct.pack("<II", 4, 0x12345678) + b"last"  # a chunk of an extension
    return made[:8] + struct.pack("<I", len(made) + len(after)) + made[12:] + after


def opened(path):
    """The JSON of a .glb, its data, and what follows."""
    content = path.read_bytes()
    size = struct.unpack("<I", content[12:16])[0]
    begin = 28 + size
    data = struct.unpack("<I", content[20 + size : 24 + size])[0]
    return json.loads(content[20 : 20 + size]), content[begin : begin + data], content[begin + data :]


def changed(content, change):
    """A .glb whose JSON is changed."""
    size = struct.unpack("<I", content[12:16])[0]
    tree = json.loads(content[20 : 20 + size])
    change(tree)
    text = json.dumps(tree).encode()
    text += b" " * (-len(text) % 4)
    length = len(content) - size + len(text)
    return content[:8] + struct.pack("<II", length, len(text)) + content[16:20] + text + content[20 + size :]


def with_data_outside(path):
    """Write the scene `rich` with its data in another file, data.bin in the same folder; return the path."""
    path.write_bytes(rich())
    (path.parent / "data.bin").write_bytes(opened(path)[1])
    path.write_bytes(changed(rich(), lambda tree: tree["buffers"][0].update(uri="data.bin")))
    return path


def array_of(tree, data, number):
    """The numbers of an accessor."""
    kinds = {5126: "f4", 5125: "u4", 5123: "u2", 5121: "u1"}
    accessor = tree["accessors"][number]
    view, width = (
        tree["bufferViews"][accessor["bufferView"]],
        {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}[accessor["type"]],
    )
    kind = np.dtype(kinds[accessor["componentType"]])
    strides = view.get("byteStride", width * kind.itemsize), kind.itemsize
    return np.ndarray((accessor["count"], width), kind, data, view["byteOffset"], strides)


def picture(tree, data, texture):
    """(H, W, 1) or (H, W, 3) float64 from 0 to 1: the picture of a texture."""
    view = tree["bufferViews"][tree["images"][tree["textures"][texture]["source"]]["bufferView"]]
    made = np.array(Image.open(io.BytesIO(data[view["byteOffset"] : view["byteOffset"] + view["byteLength"]])))
    return made.reshape(*made.shape[:2], -1) / np.iinfo(made.dtype).max


def baked(call, path, *options, texture=64):
    output = path.with_name("out.glb")
    status, out, err = call("bake", path, "-o", output, "--texture", texture, *RAYS, *options)
    assert (status, err) == (0, "")
    return output, out


def occlusion(tree, mesh):
    """What the material of a mesh says of its occlusion."""
    return tree["materials"][tree["meshes"][mesh]["primitives"][0]["material"]]["occlusionTexture"]


def floor_and_glass(path, share_of_room=0.95):
    """A floor of 8 x 8 that reaches through a closed box, a node named "box" whose material is of glass."""
    floor = np.array([(-4, 0, 4), (4, 0, 4), (4, 0, -4), (-4, 0, -4)], np.float32)
    box = trimesh.creation.box((8 * share_of_room, 4, 8 * share_of_room))
    arrays = [floor, SQUARE, TWO, np.float32(box.vertices), np.uint16(box.faces).ravel()]
    meshes = [
        {"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}]},
        {"primitives": [{"attributes": {"POSITION": 3}, "indices": 4, "material": 1}]},
    ]
    tree = {"meshes": meshes, "nodes": [{"mesh": 0, "name": "floor"}, {"mesh": 1, "name": "box"}]}
    tree["materials"] = [{"name": "floor"}, {"name": "glass", "alphaMode": "BLEND"}]
    path.write_bytes(glb(tree, arrays))
    return path


def means_of_places(path):
    """The mean of the occlusion that each place of each primitive shows, by node and material's name."""
    tree, data, _ = opened(path)
    found = []
    for one in iterate_primitives(GlbFile(path).part):
        material = tree["materials"][tree["meshes"][one.mesh]["primitives"][one.number]["material"]]
        info = material["occlusionTexture"]
        found.append((one.node.path, material["name"], picture(tree, data, info["index"]).mean().round(2)))
    return found
