"""Animation channels of meshes and materials, which KHR_animation_pointer names by number."""

import json
import re
from collections.abc import Iterable
from typing import Any

from warpsample.host.json_tree import Part, collect_names

_POINTER = "KHR_animation_pointer"
_WITHOUT_ANIMATIONS = re.compile(f"{_POINTER}|KHR_node_visibility|(KHR|EXT|MSFT)_(materials|texture|lights|mesh)_.+")
"""Extensions that refer to no animation by number, as KHR_interactivity and MOZ_hubs_components do."""


def copy_channels(tree: dict[str, Any], old: str, new: str) -> None:
    """Copy the channels that change anything below a JSON pointer, so that the copies change the same below another one.

    Args:
        tree: JSON of the file, which is edited.
        old: JSON pointer that ends with "/", for example "/materials/0/".
        new: JSON pointer for the copies.
    """
    for animation in tree.get("animations", []):
        for channel in [each for each in animation.get("channels", []) if _find_pointer(each).startswith(old)]:
            copy = json.loads(json.dumps(channel, allow_nan=False))
            copy["target"]["extensions"][_POINTER]["pointer"] = new + _find_pointer(channel).removeprefix(old)
            animation["channels"].append(copy)


def drop_channels(tree: dict[str, Any], replaced: Iterable[str]) -> bool:
    """Remove the channels that change replaced values or members of them, and return whether there were any.

    An animation without channels is removed, too. If an extension of the file may refer to animations by number, the
    animation keeps one channel without a target, because glTF has no animation without channels and viewers ignore such a
    channel.

    Args:
        tree: JSON of the file, which is edited.
        replaced: JSON pointers to the values.
    """
    starts, animations = tuple(f"{pointer}/" for pointer in replaced), tree.get("animations", [])
    found = [(each, channel) for each in animations for channel in each.get("channels", [])]
    found = [(animation, channel) for animation, channel in found if f"{_find_pointer(channel)}/".startswith(starts)]
    is_numbered = bool(found) and not all(map(_WITHOUT_ANIMATIONS.fullmatch, collect_names(tree, "extensions")))
    for animation, channel in found:
        if len(animation["channels"]) > 1:
            animation["channels"].remove(channel)
        elif is_numbered:
            channel["target"] = {"path": "pointer"}
        else:
            animations.remove(animation)
    if found and not animations:  # glTF has no empty lists
        del tree["animations"]
    return bool(found)


def _find_pointer(channel: dict[str, Any]) -> str:
    """Return the JSON pointer to what an animation channel changes, or "" for a channel that changes a node."""
    try:
        return Part(channel).part("target").part("extensions").part(_POINTER).text("pointer")
    except (TypeError, ValueError):
        return ""
