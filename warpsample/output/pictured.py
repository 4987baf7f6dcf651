"""Picture of computed values: the mesh, its points or the cells of a raster, in colours."""

from io import BytesIO
from typing import Any, BinaryIO

import numpy as np

from warpsample.output.upward import upright_by_y
from warpsample.plotting.map_sheet import Map, map_sheet
from warpsample.plotting.number_scene import number_scene

_SIZE = (1200, 900)
_FRONT = "vertices", "faces"
_MOST_CELLS = 2000  # cells along the sides of a picture of a raster


def get_picture_values(baked: Any) -> np.ndarray:
    """Return the (P,) values that a picture shows: the length of a vector, the mean of a colour; NaN without a value."""
    value = baked.result.value.astype(np.float64)
    if value.ndim == 2:
        value = np.linalg.norm(value, axis=1) if baked.quantity.is_vector else value.mean(axis=1)
    return np.where(baked.result.status == 0, value, np.nan)


def title_of(baked: Any) -> str:
    """Return the title of a picture: the name of the shown quantity, with the unit."""
    unit = baked.quantity.unit
    name = f"length of {baked.quantity.title}" if baked.quantity.is_vector else baked.quantity.title
    return f"{name}, {unit}" if unit else name


def _shown_name(baked: Any) -> str:
    """Return the name of the mesh file for a caption, with escapes for bytes that are not in UTF-8."""
    return str(baked.run.mesh.name).encode(errors="backslashreplace").decode()


def draw_picture(baked: Any, of_faces: np.ndarray | None = None) -> bytes:
    """Draw the mesh or points coloured by the computed values, and return the .png file as bytes."""
    if baked.mesh is None:
        return _draw_map(baked)
    value, at, what = get_picture_values(baked), baked.run.at, baked.run.at or "points"
    if of_faces is not None:
        value, at, what = of_faces, "faces", f"faces, with the means over {len(baked.mesh.parts):,} surfaces"
    caption = f"{_shown_name(baked)}: {len(value):,} {what}"
    if at == "faces" and len(value) < len(baked.mesh.faces):  # surfaces of a city, without the ground
        known, value = value, np.full(len(baked.mesh.faces), np.nan)
        value[baked.points.face] = known
    scene = (baked.mesh if at in _FRONT else baked.points).to_polydata()
    (scene.cell_data if at == "faces" else scene.point_data)["shown"] = value
    largest = np.nanmax(value, initial=0.0)
    high = float(largest if baked.quantity.unit else max(largest, baked.quantity.white)) or 1.0
    own = (0.0, 1.0, 0.0) if upright_by_y(baked.run.mesh) else (0.0, 0.0, 1.0)
    axis = np.abs(np.array(baked.run.options.get("up") or own, float)).argmax()
    plotter = number_scene(scene, "shown", title=title_of(baked), caption=caption, high=high, up="xyz"[axis], size=_SIZE)
    try:
        stream = BytesIO()
        plotter.screenshot(stream, return_img=False)
        return stream.getvalue()
    finally:
        plotter.close()


def _draw_map(baked: Any) -> bytes:
    """Draw the cells of a raster coloured by the computed values, and return the .png file as bytes."""
    value = get_picture_values(baked).reshape(baked.shape)
    step = -(-max(baked.shape) // _MOST_CELLS)
    largest = float(np.nanmax(value, initial=0.0))
    high = float(largest if baked.quantity.unit else max(largest, baked.quantity.white)) or 1.0
    title = title_of(baked)
    drawn = Map(value[::step, ::step], step * baked.steps, baked.quantity.title, title, "viridis", (0.0, high), baked.north)
    some = "" if step == 1 else f", of which the picture shows every {step}th in both directions"
    caption = f"{_shown_name(baked)}: {baked.shape[0]:,} x {baked.shape[1]:,} cells{some}"
    stream = BytesIO()
    map_sheet([drawn], caption).savefig(stream, format="png", metadata={"Software": None})
    return stream.getvalue()


def write_png(file: BinaryIO, baked: Any) -> None:
    """Write a .png picture of the computed values to an open file."""
    file.write(draw_picture(baked))
