"""PyVista windows with several scenes side by side, each with a title and a colour bar, over a caption."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from warpsample.mesh.polydata import surface
from warpsample.plotting.actors import label_bar
from warpsample.plotting.rendering import AXES, VIEW
from warpsample.plotting.style import INK, SKY, SURFACE, font_file

if TYPE_CHECKING:
    import pyvista

_ROWS = (0.92, 0.08)  # shares of the height: panels, caption
_TITLE, _TEXT = 0.036, 0.029  # height of text, as shares of the window's height
_WIDEST = 1.15  # of a panel's width: a window that is narrower for its height has smaller text
_ABOVE, _BELOW, _BESIDE = 0.11, 0.17, 0.03  # shares of a panel that the mesh leaves free for texts
_SHARP = 30.0  # degrees between faces, from which their common edge is drawn
_EDGE = "#5a5a5a"

_BAR: dict[str, Any] = {"title_font_size": 1, "label_font_size": 18, "color": INK, "fmt": "%.4g"}
_BAR |= {"height": 0.06, "width": 0.8, "position_x": 0.1, "position_y": 0.075}


@dataclass(frozen=True, eq=False)
class Panel:
    """Panel of a scene: numbers at the vertices, (V,), or faces, (F,), of a mesh, with title and colours.

    Attributes:
        value: the numbers. Places with NaN have the colour SURFACE.
        title: text above the mesh.
        colours: name of a colour map. 0 has its first colour.
        high: value with the last colour.
        label: text below the colour bar: quantity and unit.
    """

    value: np.ndarray
    title: str
    colours: str
    high: float
    label: str = ""


def meshes_side_by_side(
    vertices: np.ndarray,
    faces: np.ndarray,
    panels: list[Panel],
    *,
    caption: str,
    up: str,
    off_screen: bool,
    size: tuple[int, int],
    above: float = 0.0,
    edges: bool = False,
) -> "pyvista.Plotter":
    """Build a plotter that shows a mesh once for each panel, in the colours of the panel, with a shared camera.

    Args:
        vertices: (V, 3) positions.
        faces: (F, 3) rows of `vertices`.
        panels: numbers and colours.
        caption: text below all panels.
        up: name of the axis that points up: "x", "y" or "z".
        off_screen: whether no window is opened.
        size: width and height of the picture in pixels.
        above: height from which the mesh is seen, as `fit_view` takes it.
        edges: whether sharp edges are drawn.
    """
    plotter = columns_over_caption(len(panels), caption, off_screen, size)
    for column, panel in enumerate(panels):
        plotter.subplot(0, column)
        draw_panel(plotter, surface(vertices, faces), panel)
        if edges:
            draw_edges(plotter, vertices, faces)
        fit_view(plotter, vertices, up, above)
    plotter.link_views()
    return plotter


def columns_over_caption(columns: int, caption: str, off_screen: bool, size: tuple[int, int]) -> "pyvista.Plotter":
    """Build a plotter with empty renderers side by side, at `subplot(0, column)`, and a caption below the renderers."""
    import pyvista as pv

    style = {"off_screen": off_screen, "window_size": size, "border": False}
    plotter = pv.Plotter(shape=(2, columns), row_weights=_ROWS, groups=[(1, np.s_[:])], **style)
    plotter.set_background(SKY, all_renderers=True)
    plotter.subplot(1, 0)
    text = add_text(plotter, caption, (0.5, 0.6))
    text.prop.font_size = round(_TEXT * min(size[1], _WIDEST * size[0] / columns))
    plotter.enable_anti_aliasing("ssaa", all_renderers=True)
    return plotter


def add_text(
    plotter: "pyvista.Plotter", words: str, at: tuple[float, float], size: float = _TEXT, name: str | None = None
) -> Any:
    """Write a text into the current renderer, centred at fractions of its width and height; return the actor.

    `size` is the height of the text as a share of the window's height. A text replaces an earlier text with the same `name`.
    """
    text = plotter.add_text(words, position=at, viewport=True, color=INK, font_file=font_file(), name=name)
    text.prop.font_size = round(size * min(plotter.window_size[1], _WIDEST * _size_of(plotter)[0]))
    text.prop.justification_horizontal = "center"
    text.prop.justification_vertical = "center"
    return text


def _size_of(plotter: "pyvista.Plotter") -> tuple[float, float]:
    """Return the width and height, in pixels, of the plotter's current renderer."""
    left, bottom, right, top = plotter.renderer.GetViewport()
    width, height = plotter.window_size
    return (right - left) * width, (top - bottom) * height


def add_title(plotter: "pyvista.Plotter", title: str, name: str | None = None) -> None:
    """Write a title at the top of the plotter's current renderer; it replaces an earlier title with the same `name`."""
    add_text(plotter, title, (0.5, 0.955), _TITLE, name)


def add_bar(plotter: "pyvista.Plotter", actor: Any, key: str, label: str, high: float) -> None:
    """Add a colour bar from 0 to `high` for an actor to the plotter's current renderer, with a label below the bar.

    Args:
        plotter: plotter with the actor.
        actor: actor with scalar colours.
        key: name of the bar, unique in the plotter; an .html shows the name.
        label: quantity and unit.
        high: value with the last colour.
    """
    plotter.add_scalar_bar(title=key, mapper=actor.mapper, **_BAR)
    label_bar(plotter.scalar_bars[key], high)
    add_text(plotter, label, (0.5, 0.04))


def add_scale(plotter: "pyvista.Plotter", colours: str, high: float) -> None:
    """Add a colour bar from 0 to `high` for a texture, which has no scalar colours, to the plotter's current renderer."""
    import pyvista as pv

    table = pv.LookupTable(colours, scalar_range=(0.0, high))
    mapper = pv.DataSetMapper(pv.PolyData(np.zeros((1, 3))))
    mapper.lookup_table = table
    key = f"texture {len(plotter.scalar_bars)}"
    plotter.add_scalar_bar(title=key, mapper=mapper, **_BAR)
    label_bar(plotter.scalar_bars[key], high)


def draw_panel(plotter: "pyvista.Plotter", mesh: "pyvista.PolyData", panel: Panel) -> Any:
    """Draw a mesh in the colours of a panel into the plotter's current renderer, with title and bar; return the actor."""
    mesh[panel.title] = panel.value
    style = {"cmap": panel.colours, "clim": (0.0, panel.high), "nan_color": SURFACE, "lighting": False}
    actor = plotter.add_mesh(mesh, scalars=panel.title, show_scalar_bar=False, **style)
    actor.mapper.resolve = "polygon_offset"  # edges on the faces stay visible
    add_bar(plotter, actor, f"{panel.title}: {panel.label}", panel.label, panel.high)
    add_title(plotter, panel.title, f"title {panel.title}")
    return actor


def draw_edges(plotter: "pyvista.Plotter", vertices: np.ndarray, faces: np.ndarray) -> None:
    """Draw the boundary of a mesh, and its edges between faces that meet at more than 30 degrees."""
    edges = surface(vertices, faces).extract_feature_edges(_SHARP)
    plotter.add_mesh(edges, color=_EDGE, line_width=1.5, lighting=False, show_scalar_bar=False)


def fit_view(plotter: "pyvista.Plotter", points: np.ndarray, up: str, above: float = 0.0) -> None:
    """Set the camera of the current renderer so that the points, (N, 3), fill the space between title and colour bar.

    The projection is parallel. `up` names the axis that points up. The direction to the camera is VIEW[up], moved by `above`
    along that axis: a positive number shows more of the ground.
    """
    points = np.asarray(points, np.float64)
    points = points[np.isfinite(points).all(axis=1)]
    back = np.array(VIEW[up]) + above * np.array(AXES[up])
    back /= np.linalg.norm(back)
    right = np.cross(AXES[up], back)
    right /= np.linalg.norm(right)
    axes = np.stack([right, np.cross(back, right), back])
    seen = points @ axes.T
    low, high = seen.min(axis=0), seen.max(axis=0)
    width, height = _size_of(plotter)
    free = np.array([(1.0 - 2.0 * _BESIDE) * width / height, 1.0 - _ABOVE - _BELOW])
    scale = float(max(((high - low)[:2] / free).max(), 1e-9))  # height of the renderer in units of the points
    middle = 0.5 * (low + high) - [0.0, 0.5 * (_BELOW - _ABOVE) * scale, 0.0]
    distance = float(np.linalg.norm(high - low)) + scale
    focus = middle @ axes
    plotter.camera_position = [focus + distance * back, focus, AXES[up]]
    plotter.enable_parallel_projection()
    plotter.camera.parallel_scale = 0.5 * scale
    plotter.renderer.ResetCameraClippingRange()
