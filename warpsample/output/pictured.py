"""Baked numbers as a picture: the mesh or its points, in colours."""

from io import BytesIO
from typing import Any, BinaryIO

import numpy as np

from warpsample.output.upward import upright_by_y
from warpsample.plotting.number_scene import number_scene

_SIZE = (1200, 900)
_FRONT = "vertices", "faces"


def shown(baked: Any) -> np.ndarray:
    """(P,) what is shown of the values: themselves, or the length of those of three components; NaN without a number."""
    value = baked.found.value.astype(np.float64)
    length = np.linalg.norm(value, axis=1) if value.ndim == 2 else value
    return np.where(baked.found.status == 0, length, np.nan)


def title_of(baked: Any) -> str:
    """What is shown, with its unit."""
    unit = baked.quantity.unit
    name = f"length of {baked.quantity.title}" if baked.found.value.ndim == 2 else baked.quantity.title
    return f"{name}, {unit}" if unit else name


def picture_of(baked: Any, of_faces: np.ndarray | None = None) -> bytes:
    """The scene as a .png; `of_faces` are (F,) means over parts, to be shown in place of the numbers."""
    value, at, what = shown(baked), baked.run.at, baked.run.at or "points"
    if of_faces is not None:
        value, at, what = of_faces, "faces", f"faces, with the means over {len(baked.mesh.parts):,} surfaces"
    made = (baked.mesh if at in _FRONT else baked.points).to_polydata()
    (made.cell_data if at == "faces" else made.point_data)["shown"] = value
    largest = np.nanmax(value, initial=0.0)
    high = float(largest if baked.quantity.unit else max(largest, baked.quantity.white)) or 1.0
    own = (0.0, 1.0, 0.0) if upright_by_y(baked.run.mesh) else (0.0, 0.0, 1.0)
    axis = np.abs(np.array(baked.run.options.get("up") or own, float)).argmax()
    said = f"{baked.run.mesh.name}: {len(value):,} {what}"
    plotter = number_scene(made, "shown", title=title_of(baked), caption=said, high=high, up="xyz"[axis], size=_SIZE)
    try:
        held = BytesIO()
        plotter.screenshot(held, return_img=False)
        return held.getvalue()
    finally:
        plotter.close()


def write_png(file: BinaryIO, baked: Any) -> None:
    """Writes the picture."""
    file.write(picture_of(baked))
