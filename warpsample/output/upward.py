"""Which way is up in a mesh file, where its format says so: otherwise it is z, as on maps."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from warpsample.estimate.quantities.record import Quantity
from warpsample.host.locks import imported
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
    made = dict(options)
    format = "" if not quantity.takes("up") or "up" in options else upright_by_y(path)
    if not format:
        return made, ""
    made["up"] = _Y
    north = ""
    if quantity.takes("north") and "north" not in options:
        made["north"] = _NORTH_BY_Y
        north = " and north -z"
    return made, f"up is +y{north}, as {format} has it; --up 0 0 1 is for +z"


def upright_by_y(path: Path) -> str:
    """The name of the format by which +y is up in a file; "" where z is, or where there is no such file."""
    suffix = path.suffix.lower()
    if not path.is_file():
        return ""
    if suffix in _GLTF:
        return "glTF"
    return "this USD file" if suffix in _USD and read_up_axis(path) == "Y" else ""


def up_of(quantity: Quantity, options: Mapping[str, Any]) -> Any:
    """What was up for a quantity in a run; None of one that has no up."""
    return options.get("up") or quantity.default("up") if quantity.takes("up") else None


def placed_upright(middle: np.ndarray, up: Any) -> dict[str, list[float]]:
    """How a node of a .glb places vertices about a middle, so that what was up is +y; as they are where nothing was."""
    if up is None or tuple(up) == _Y:
        return {"translation": middle.tolist()}
    turn = imported("scipy.spatial.transform").Rotation.align_vectors([_Y], [up])[0]
    return {"translation": turn.apply(middle).tolist(), "rotation": turn.as_quat().tolist()}
