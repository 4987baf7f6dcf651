"""PyVista scenes: meshes with normals, clouds of directions, and numbers at their vertices."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from warpsample.mesh.polydata import surface
from warpsample.plotting.actors import CloudActor, Sheet, label_bar
from warpsample.plotting.rendering import AXES, BARS, INK, MOST_NORMALS, MOST_SMOOTH_FACES, SKY, SURFACE, VIEW, pixels_of

if TYPE_CHECKING:
    import pyvista
    from matplotlib.figure import Figure

ZOOM = 1.08
"""How much a mesh is enlarged in a panel: it leaves space for the panel's title and colour bar."""
# A bar's title takes no space: only a browser draws it, which does not show the texts above the panels.
BAR: dict[str, Any] = {"title_font_size": 1, "label_font_size": 18, "color": "black", "fmt": "%.4g"}
BAR |= {"height": 0.06, "width": 0.7, "position_x": 0.15, "position_y": 0.01}
"""The look of a panel's colour bar."""

_TEXT = {"font_size": 11, "color": "black"}
_ROWS = (0.91, 0.09)  # the panels' share of the height, and the caption's


def draw_mesh(
    plotter: "pyvista.Plotter", vertices: np.ndarray, faces: np.ndarray, texture: tuple[np.ndarray, np.ndarray] | None = None
) -> Any:
    """Adds a mesh, (V, 3) and (F, 3), to the current renderer, shaded smoothly if it is not too large; its actor.

    A texture, a picture (H, W) or (H, W, 3) of uint8 and (F, 3, 2) coordinates of corners, v down, is shown without shading.
    """
    if texture is not None:
        return _draw_textured(plotter, vertices[faces], *texture)
    smooth = len(faces) <= MOST_SMOOTH_FACES
    return plotter.add_mesh(surface(vertices, faces), color=SURFACE, smooth_shading=smooth, split_sharp_edges=smooth)


def _draw_textured(plotter: "pyvista.Plotter", corners: np.ndarray, picture: np.ndarray, uv: np.ndarray) -> Any:
    """Adds faces by their corners, (F, 3, 3), with a texture; its actor."""
    import pyvista as pv

    mesh = surface(corners.reshape(-1, 3), np.arange(3 * len(corners)).reshape(-1, 3))
    mesh.active_texture_coordinates = (uv.reshape(-1, 2) * (1.0, -1.0) + (0.0, 1.0)).astype(np.float32)
    colours = np.repeat(picture[..., None], 3, axis=2) if picture.ndim == 2 else picture
    shown = pv.Texture(np.ascontiguousarray(colours))
    shown.interpolate = True
    return plotter.add_mesh(mesh, texture=shown, lighting=False)


def draw_normals(plotter: "pyvista.Plotter", position: np.ndarray, normal: np.ndarray, scale: float) -> None:
    """Adds points, (P, 3), and unit normals, `scale` long in world units; of more than MOST_NORMALS, the first ones."""
    import pyvista as pv

    position, normal = position[:MOST_NORMALS], normal[:MOST_NORMALS]
    ends = np.stack([position, position + scale * normal], axis=1).reshape(-1, 3)
    segments = pv.PolyData(ends, lines=np.insert(np.arange(len(ends)).reshape(-1, 2), 0, 2, axis=1).ravel())
    plotter.add_mesh(segments, color="black", line_width=2, pickable=False)
    plotter.add_mesh(pv.PolyData(position), color="black", point_size=5, render_points_as_spheres=True, pickable=False)


def draw_frame(plotter: "pyvista.Plotter") -> None:
    """Adds the tangent plane, as a unit disk, and the frame t, b, n about the origin, and looks at them from above."""
    import pyvista as pv

    plotter.add_mesh(pv.Disc(inner=0.0, outer=1.0, c_res=72), color=SURFACE, opacity=0.5, lighting=False, pickable=False)
    for axis, colour in (("x", BARS), ("y", BARS), ("z", "black")):
        line = pv.Line((0, 0, 0), 1.15 * np.array(AXES[axis]))
        plotter.add_mesh(line, color=colour, line_width=3, pickable=False)
    tips = 1.25 * np.eye(3)
    style = {"font_size": 20, "text_color": INK, "shape": None, "show_points": False, "always_visible": True}
    plotter.add_point_labels(tips, ["t", "b", "n"], **style)
    plotter.camera_position = [(2.2, -3.2, 1.78), (0.0, 0.0, 0.42), (0.0, 0.0, 1.0)]
    plotter.enable_parallel_projection()
    plotter.camera.parallel_scale = 1.2


def look_from(plotter: "pyvista.Plotter", up: str, zoom: float = 1.2) -> None:
    """Turns the current renderer's camera so that the axis "x", "y" or "z" points up, and enlarges by `zoom`."""
    plotter.view_vector(VIEW[up], viewup=AXES[up])
    plotter.camera.zoom(zoom)


def clouds_on_mesh(
    vertices: np.ndarray,
    faces: np.ndarray,
    position: np.ndarray,
    normal: np.ndarray,
    *,
    scale: float,
    clouds: tuple[np.ndarray, np.ndarray, float],
    up: str,
    size: tuple[int, int],
    off_screen: bool = True,
) -> "pyvista.Plotter":
    """A plotter with a mesh, points with their normals, and all clouds as one set of points.

    Normals are `scale` long, in world units; `clouds` are (N, 3) points, (N,) densities per steradian, and the density that
    has the last colour; `up` is the axis that points up, "x", "y" or "z", and `size` in pixels.
    """
    import pyvista as pv

    plotter = pv.Plotter(off_screen=off_screen, window_size=size)
    plotter.set_background("white")
    draw_mesh(plotter, vertices, faces)
    draw_normals(plotter, position, normal, scale)
    CloudActor(plotter, point_size=2, bar=True).show(*clouds)
    look_from(plotter, up)
    return plotter


@dataclass(frozen=True, eq=False)
class Panel:
    """A number at each vertex, (V,), or face, (F,), of a mesh, and its colours: 0 has the first, `high` the last.

    The title stands above the mesh; `colours` names a colour map.
    """

    value: np.ndarray
    title: str
    colours: str
    high: float


def meshes_side_by_side(
    vertices: np.ndarray,
    faces: np.ndarray,
    panels: list[Panel],
    *,
    caption: str,
    up: str,
    off_screen: bool,
    size: tuple[int, int],
) -> "pyvista.Plotter":
    """A plotter with the mesh in the colours of each panel; one camera turns them all.

    `up` is the axis that points up, "x", "y" or "z", and `size` that of all panels together, in pixels.
    """
    plotter = columns_over_caption(len(panels), caption, off_screen, size)
    for column, panel in enumerate(panels):
        plotter.subplot(0, column)
        draw_panel(plotter, surface(vertices, faces), panel, panel.title)
        look_from(plotter, up, ZOOM)
    plotter.link_views()
    return plotter


def columns_over_caption(columns: int, caption: str, off_screen: bool, size: tuple[int, int]) -> "pyvista.Plotter":
    """A plotter with empty renderers side by side, `subplot(0, column)`, and a caption below all of them."""
    import pyvista as pv

    style = {"off_screen": off_screen, "window_size": size, "border": False}
    plotter = pv.Plotter(shape=(2, columns), row_weights=_ROWS, groups=[(1, np.s_[:])], **style)
    plotter.set_background(SKY, all_renderers=True)
    plotter.subplot(1, 0)
    plotter.add_text(caption, position="lower_edge", **_TEXT)
    plotter.enable_anti_aliasing("ssaa", all_renderers=True)
    return plotter


def add_title(plotter: "pyvista.Plotter", title: str, name: str | None = None) -> None:
    """Writes a title above the plotter's current renderer; one with the same name replaces it."""
    plotter.add_text(title, position="upper_edge", name=name, **_TEXT)


def draw_panel(plotter: "pyvista.Plotter", mesh: "pyvista.PolyData", panel: Panel, title: str) -> None:
    """Draws a mesh in the colours of a panel into the plotter's current renderer, with a title above it."""
    mesh[panel.title] = panel.value
    plotter.add_mesh(
        mesh,
        scalars=panel.title,
        cmap=panel.colours,
        clim=(0.0, panel.high),
        lighting=False,
        scalar_bar_args={**BAR, "title": panel.title},
    )
    label_bar(plotter.scalar_bars[panel.title], panel.high)
    add_title(plotter, title)


def figure_in_window(figure: "Figure") -> "pyvista.Plotter":
    """A plotter of the figure's size that shows it, for those who have no other window for figures."""
    import pyvista as pv

    pixels = pixels_of(figure)
    plotter = pv.Plotter(window_size=(pixels.shape[1], pixels.shape[0]))
    Sheet(plotter).show(pixels)
    return plotter
