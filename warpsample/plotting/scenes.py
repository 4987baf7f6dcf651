"""Meshes, clouds of directions and lobes in PyVista plotters."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from warpsample.mesh.polydata import surface
from warpsample.plotting.rendering import (
    AXES,
    BARS,
    INK,
    LOBE,
    MOST_NORMALS,
    MOST_SMOOTH_FACES,
    SKY,
    SURFACE,
    VIEW,
    pixels_of,
)

if TYPE_CHECKING:
    import pyvista
    from matplotlib.figure import Figure

OUTSIDE = "#e8871e"
"""Of directions where the density is 0."""


class CloudActor:
    """Points coloured by density, as one actor whose points can be replaced."""

    def __init__(self, plotter: "pyvista.Plotter", point_size: int, bar: bool):
        """Into the plotter's current renderer; `bar`: with a colour bar below."""
        import pyvista as pv  # noqa: PLC0415

        cloud = pv.PolyData(np.zeros((1, 3), np.float32))
        cloud["pdf"] = np.zeros(1, np.float32)
        args = {"title": "pdf [1/sr]", "n_labels": 2, "fmt": "%.3g", "position_x": 0.2, "position_y": 0.01, "color": INK}
        args |= {"title_font_size": 15, "label_font_size": 14, "height": 0.13, "width": 0.6}
        self.actor = plotter.add_mesh(
            cloud,
            scalars="pdf",
            cmap="viridis",
            below_color=OUTSIDE,
            point_size=point_size,
            lighting=False,
            pickable=False,
            show_scalar_bar=bar,
            scalar_bar_args=args if bar else None,
            reset_camera=False,
        )
        self._bar = plotter.scalar_bars["pdf [1/sr]"] if bar else None

    def show(self, position: np.ndarray, pdf: np.ndarray, peak: float) -> None:
        """Replaces the points, (N, 3), their densities, (N,), and the density of the last colour."""
        import pyvista as pv  # noqa: PLC0415

        cloud = pv.PolyData(position)
        cloud["pdf"] = np.where(pdf > 0.0, pdf, np.float32(-1.0))  # below the range, so of the colour of what is outside
        self.actor.mapper.dataset = cloud
        self.actor.mapper.scalar_range = (0.0, peak)
        if self._bar is not None:
            self._bar.SetDrawBelowRangeSwatch(bool((pdf <= 0.0).any()))


class LobeActor:
    """A density as a translucent surface over the tangent plane."""

    def __init__(self, plotter: "pyvista.Plotter"):
        import pyvista as pv  # noqa: PLC0415

        style = {"color": LOBE, "opacity": 0.25, "pickable": False, "reset_camera": False, "show_scalar_bar": False}
        self.actor = plotter.add_mesh(pv.Plane(i_resolution=1, j_resolution=1), **style)

    def show(self, grid: np.ndarray) -> None:
        """Replaces the surface: (I, J, 3), rings by spokes."""
        rings, spokes = grid.shape[:2]
        first = (np.arange(rings - 1)[:, None] * spokes + np.arange(spokes - 1)).ravel()
        quads = np.stack([first, first + 1, first + spokes + 1, first + spokes], axis=1)
        self.actor.mapper.dataset = surface(grid.reshape(-1, 3), quads)


class Sheet:
    """Pixels that fill a renderer, whatever its camera does."""

    def __init__(self, plotter: "pyvista.Plotter"):
        """Into the plotter's current renderer."""
        import pyvista as pv  # noqa: PLC0415
        from vtkmodules.vtkRenderingCore import vtkCoordinate, vtkPolyDataMapper2D, vtkTexturedActor2D  # noqa: PLC0415

        corners = vtkCoordinate()
        corners.SetCoordinateSystemToNormalizedViewport()
        mapper = vtkPolyDataMapper2D()
        mapper.SetTransformCoordinate(corners)
        mapper.SetInputData(pv.Plane(center=(0.5, 0.5, 0.0), i_resolution=1, j_resolution=1))
        self.actor = vtkTexturedActor2D()
        self.actor.SetMapper(mapper)
        plotter.add_actor(self.actor, pickable=False)

    def show(self, pixels: np.ndarray) -> None:
        """Replaces the pixels: (H, W, 3) uint8."""
        import pyvista as pv  # noqa: PLC0415

        self.actor.SetTexture(pv.Texture(pixels))


class MeshPicker:
    """What of a mesh is under the mouse."""

    def __init__(self, plotter: "pyvista.Plotter", actor: Any, picked: Callable[[np.ndarray, int], None]):
        """For an actor in the plotter's current renderer; a double click gives `picked` the place, (3,), and the face.

        The faces of the drawn surface are in the mesh's order, edges split or not (a test sees to it).
        """
        from vtkmodules.vtkRenderingCore import vtkCellPicker  # noqa: PLC0415

        self._renderer, self._picked, self._picker = plotter.renderer, picked, vtkCellPicker()
        self._picker.PickFromListOn()
        self._picker.AddPickList(actor)
        iren = plotter.iren
        iren.track_click_position(lambda _: self.click(iren.get_event_position()), side="left", double=True, viewport=True)

    def click(self, at: tuple[int, int]) -> None:
        """As if by the mouse, at pixels from the window's lower left."""
        if self._renderer.IsInViewport(*at) and self._picker.Pick(*at, 0, self._renderer) and self._picker.GetCellId() >= 0:
            self._picked(np.array(self._picker.GetPickPosition()), self._picker.GetCellId())


def draw_mesh(plotter: "pyvista.Plotter", vertices: np.ndarray, faces: np.ndarray) -> Any:
    """The mesh in the plotter's current renderer, smooth where it is not too large; the actor."""
    smooth = len(faces) <= MOST_SMOOTH_FACES
    return plotter.add_mesh(surface(vertices, faces), color=SURFACE, smooth_shading=smooth, split_sharp_edges=smooth)


def draw_normals(plotter: "pyvista.Plotter", position: np.ndarray, normal: np.ndarray, scale: float) -> None:
    """Points, (P, 3), and their normals at length `scale`; the first MOST_NORMALS of them."""
    import pyvista as pv  # noqa: PLC0415

    position, normal = position[:MOST_NORMALS], normal[:MOST_NORMALS]
    ends = np.stack([position, position + scale * normal], axis=1).reshape(-1, 3)
    segments = pv.PolyData(ends, lines=np.insert(np.arange(len(ends)).reshape(-1, 2), 0, 2, axis=1).ravel())
    plotter.add_mesh(segments, color="black", line_width=2, pickable=False)
    plotter.add_mesh(pv.PolyData(position), color="black", point_size=5, render_points_as_spheres=True, pickable=False)


class Mark:
    """A pin at a point."""

    def __init__(self, plotter: "pyvista.Plotter", colour: str):
        import pyvista as pv  # noqa: PLC0415

        style = {"color": colour, "pickable": False, "reset_camera": False}
        self._pin = plotter.add_mesh(pv.Line(), line_width=4, **style)
        self._head = plotter.add_mesh(pv.PolyData(np.zeros((1, 3))), point_size=13, render_points_as_spheres=True, **style)

    def show(self, start: np.ndarray, end: np.ndarray) -> None:
        """From the point `start`, (3,), to its head."""
        import pyvista as pv  # noqa: PLC0415

        self._pin.mapper.dataset = pv.Line(start, end)
        self._head.mapper.dataset = pv.PolyData(end[None])


def draw_frame(plotter: "pyvista.Plotter") -> None:
    """The tangent plane as the unit disk, and the frame t, b, n about the origin, seen from above."""
    import pyvista as pv  # noqa: PLC0415

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
    """Turns the current renderer's camera so that the axis "x", "y" or "z" points up."""
    plotter.view_vector(VIEW[up], viewup=AXES[up])
    plotter.camera.zoom(zoom)


def clouds_on_mesh(
    vertices: np.ndarray,
    faces: np.ndarray,
    position: np.ndarray,
    normal: np.ndarray,
    scale: float,
    clouds: tuple[np.ndarray, np.ndarray, float],
    up: str,
    size: tuple[int, int],
    off_screen: bool = True,
) -> "pyvista.Plotter":
    """A plotter with the mesh, points with their normals, and all clouds as one set of points.

    Args:
        vertices: (V, 3).
        faces: (F, 3).
        position: (P, 3).
        normal: (P, 3), drawn at length `scale`.
        scale: world units.
        clouds: (N, 3) points, (N,) densities per steradian, the density of the last colour.
        up: "x", "y" or "z", the axis that points up.
        size: width and height in pixels.
        off_screen: no window.
    """
    import pyvista as pv  # noqa: PLC0415

    plotter = pv.Plotter(off_screen=off_screen, window_size=size)
    plotter.set_background("white")
    draw_mesh(plotter, vertices, faces)
    draw_normals(plotter, position, normal, scale)
    CloudActor(plotter, point_size=2, bar=True).show(*clouds)
    look_from(plotter, up)
    return plotter


@dataclass(frozen=True, eq=False)
class Panel:
    """A number at each vertex.

    Attributes:
        value: (V,).
        title: above the picture.
        colours: a colour map's name.
        limits: of the colours.
    """

    value: np.ndarray
    title: str
    colours: str
    limits: tuple[float, float]


def meshes_side_by_side(
    vertices: np.ndarray,
    faces: np.ndarray,
    panels: list[Panel],
    caption: str,
    up: str,
    off_screen: bool,
    size: tuple[int, int],
) -> "pyvista.Plotter":
    """A plotter with the mesh in each panel's colours; one camera turns them all.

    Args:
        vertices: (V, 3).
        faces: (F, 3).
        panels: from left to right.
        caption: below the first.
        up: "x", "y" or "z", the axis that points up.
        off_screen: no window.
        size: of all together, pixels.
    """
    import pyvista as pv  # noqa: PLC0415

    plotter = pv.Plotter(shape=(1, len(panels)), off_screen=off_screen, window_size=size, border=False)
    plotter.set_background(SKY)
    bar = {"title_font_size": 1, "label_font_size": 15, "height": 0.06, "width": 0.7, "color": "black"}
    bar |= {"position_x": 0.15, "position_y": 0.06, "n_labels": 5, "fmt": "%.4g"}
    for column, panel in enumerate(panels):
        plotter.subplot(0, column)
        coloured = surface(vertices, faces)
        coloured[panel.title] = panel.value
        plotter.add_mesh(
            coloured,
            scalars=panel.title,
            cmap=panel.colours,
            clim=panel.limits,
            lighting=False,
            scalar_bar_args={**bar, "title": panel.title},  # too small to read but in a browser, which has no texts above
        )
        plotter.add_text(panel.title, font_size=11, color="black", position="upper_edge")
        look_from(plotter, up)
    plotter.subplot(0, 0)
    plotter.add_text(caption, font_size=8, color="black", position="lower_left")
    plotter.link_views()
    plotter.enable_anti_aliasing("ssaa", all_renderers=True)
    return plotter


def figure_in_window(figure: "Figure") -> "pyvista.Plotter":
    """A plotter of the figure's size that shows it, for whoever has no other window for figures."""
    import pyvista as pv  # noqa: PLC0415

    pixels = pixels_of(figure)
    plotter = pv.Plotter(window_size=(pixels.shape[1], pixels.shape[0]))
    Sheet(plotter).show(pixels)
    return plotter
