"""Animations of values that a bake replaces, by KHR_animation_pointer."""

import numpy as np
import pytest
from glb_files import glb
from textured_scenes import SQUARE, TWO, opened

NODE = {"sampler": 1, "target": {"node": 0, "path": "scale"}}
PLAIN = {"index": 0, "extensions": {"KHR_texture_transform": {"offset": [0.5, 0.5]}}}
SLOTS = {
    "ao": ({"occlusionTexture": PLAIN}, "/materials/1/occlusionTexture/", "strength", "occlusion"),
    "normals": ({"normalTexture": PLAIN}, "/materials/1/normalTexture/", "scale", "normal map"),
    "thickness": (
        {"extensions": {"KHR_materials_volume": {"thicknessTexture": PLAIN}}},
        "/materials/1/extensions/KHR_materials_volume/thicknessTexture/",
        None,
        "thickness",
    ),
}
"""The members of a material with a picture, the pointer to the picture, a property of the picture, and its name."""


def pointing(to):
    return {"sampler": 0, "target": {"path": "pointer", "extensions": {"KHR_animation_pointer": {"pointer": to}}}}


def bake(call, path, quantity, animations, extensions):
    """Bake a quad with a material whose texture transform is animated; return the JSON of the output and the report."""
    primitive = {"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 1}
    used = ["KHR_texture_transform", "KHR_animation_pointer", *extensions]
    used += ["KHR_materials_volume"] if quantity == "thickness" else []
    tree = {"meshes": [{"primitives": [primitive]}], "nodes": [{"mesh": 0}], "animations": animations}
    tree |= {"materials": [{}, {"name": "glass", **SLOTS[quantity][0]}], "textures": [{"source": 0}]}
    tree |= {"images": [{"uri": "data:image/png;base64,iVBORw0KGgo="}], "extensionsUsed": used}
    tree |= {"extensions": {name: {} for name in extensions}} if extensions else {}
    arrays = [np.pad(SQUARE, ((0, 0), (0, 1))), SQUARE, TWO, np.float32([0, 1]), SQUARE[:2], np.ones((2, 3), np.float32)]
    path.write_bytes(glb(tree, arrays))
    samples = ("--samples", 4) if quantity == "ao" else ()
    status, out, err = call("bake", path, "-o", path.with_name("out.glb"), "--texture", 8, "--quantity", quantity, *samples)
    assert (status, err) == (0, "")
    return opened(path.with_name("out.glb"))[0], out


@pytest.mark.parametrize("quantity", SLOTS)
@pytest.mark.parametrize("extension", ["", "KHR_interactivity"])
def test_animations_of_replaced_values_are_left_out(call, tmp_path, quantity, extension):
    """KHR_interactivity starts animations by number: the first one then stays, with a channel that changes nothing."""
    _, pointer, own, name = SLOTS[quantity]
    moved = [pointing(f"{pointer}extensions/KHR_texture_transform/{what}") for what in ("offset", "scale")]
    moved += [pointing(pointer + own) if own else pointing(pointer.replace("Texture/", "Factor"))]
    kept = [NODE, pointing("/materials/0/alphaCutoff"), pointing(pointer.replace("Texture/", "TextureLike"))]
    samplers = [{"input": 3, "output": 4}, {"input": 3, "output": 5}]
    animations = [{"channels": moved, "samplers": samplers}, {"channels": [*moved, *kept], "samplers": samplers}]
    tree, out = bake(call, tmp_path / "in.glb", quantity, animations, [extension] if extension else [])
    idle = {"channels": [{"sampler": 0, "target": {"path": "pointer"}}], "samplers": samplers}
    assert tree["animations"] == [*([idle] if extension else []), {"channels": kept, "samplers": samplers}]
    assert out.count(f"\n  the animation of the {name} of material 'glass' is left out") == 1
    assert "KHR_animation_pointer" in tree["extensionsUsed"]
    assert "KHR_texture_transform" not in tree["extensionsUsed"]


@pytest.mark.parametrize("changed", ["strength", "extensions/KHR_texture_transform/offset"])
def test_a_file_without_other_animations_has_none_left(call, tmp_path, changed):
    channel = pointing(SLOTS["ao"][1] + changed)
    animations = [{"channels": [channel], "samplers": [{"input": 3, "output": 4}]}]
    tree, out = bake(call, tmp_path / "in.glb", "ao", animations, [])
    assert "animations" not in tree
    assert "extensionsUsed" not in tree
    assert "left out" in out
