"""Direction of up in mesh files whose format defines the direction; +z in all other files, as on maps."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from warpsample.estimate.quantities.record import Quantity
from warpsample.host.arguments import is_file, naming_file
from warpsample.host.locks import imported
from warpsample.mesh.files.usd import read_up_axis

_GLTF = (".glb", ".gltf")
_USD = (".usd", ".usda", ".usdc", ".usdz")
_Y, _NORTH_BY_Y = (0.0, 1.0, 0.0), (0.0, 0.0, -1.0)
"""Axis of up, and the direction of north for that axis: -z, which was +y before the mesh was turned upright."""


def with_up(path: Path, quantity: Quantity, options: Mapping[str, Any]) -> tuple[dict[str, Any], str]:
    """Add the up axis of a mesh file's format, and north for +y up, to the options of a command; return (options, a note).

    Args:
        path: path of the mesh.
        quantity: quantity, which may depend on the direction of up.
        options: given options; given axes stay.
    """
    made = dict(options)
    format = "" if not quantity.takes("up") or "up" in options else upright_by_y(path)
    if format:
        made["up"] = _Y
    north = quantity.takes("north") and "north" not in options and tuple(made.get("up") or ()) == _Y
    if north:
        made["north"] = _NORTH_BY_Y
    if format:
        return made, f"up is +y{' and north -z' if north else ''}, as {format} has it; --up 0 0 1 is for +z"
    return made, "north is -z" if north else ""


def upright_by_y(path: Path) -> str:
    """Return the name of a file's format if +y is up in the file, else ""."""
    suffix = path.suffix.lower()
    if not is_file(path):
        return ""
    if suffix in _GLTF:
        return "glTF"
    if suffix not in _USD:
        return ""
    with naming_file("path", path, "a mesh"):
        return "this USD file" if read_up_axis(path) == "Y" else ""


def up_of(quantity: Quantity, options: Mapping[str, Any]) -> Any:
    """Return the vector of the option `--up` or its default; None for a quantity without this option."""
    return options.get("up") or quantity.default("up") if quantity.takes("up") else None


def compute_upright_placement(middle: np.ndarray, up: Any) -> dict[str, list[float]]:
    """Return the translation and rotation of a node of a .glb that turn `up` to +y and move vertices to their middle.

    Args:
        middle: (3,) middle of the vertices.
        up: Direction of up, or None for no rotation.
    """
    if up is None or tuple(up) == _Y:
        return {"translation": middle.tolist()}
    turn = imported("scipy.spatial.transform").Rotation.align_vectors([_Y], [up])[0]
    return {"translation": turn.apply(middle).tolist(), "rotation": turn.as_quat().tolist()}
