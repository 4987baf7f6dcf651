"""Which way is up in a mesh file, where its format says so: otherwise it is z, as on maps."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from warpsample.estimate.quantities.record import Quantity
from warpsample.mesh.files.usd import read_up_axis

_GLTF = (".glb", ".gltf")
_USD = (".usd", ".usda", ".usdc", ".usdz")
_Y, _NORTH_BY_Y = (0.0, 1.0, 0.0), (0.0, 0.0, -1.0)
"""The axis, and where north is by it: what is turned upright has its y into the picture."""


def with_up(path: Path, quantity: Quantity, options: Mapping[str, Any]) -> tuple[dict[str, Any], str]:
    """The options of a run with the file's own axes, unless they are given; and a sentence that says so, or "".

    Args:
        path: of the mesh.
        quantity: that may depend on what is up.
        options: as given.
    """
    suffix, made = path.suffix.lower(), dict(options)
    if not quantity.takes("up") or "up" in options or not path.is_file():
        return made, ""
    if suffix in _GLTF:
        format = "glTF"
    elif suffix in _USD and read_up_axis(path) == "Y":
        format = "this USD file"
    else:
        return made, ""
    made["up"] = _Y
    if quantity.takes("north") and "north" not in options:
        made["north"] = _NORTH_BY_Y
    return made, f"up is +y, as {format} has it; --up 0 0 1 is for +z"
