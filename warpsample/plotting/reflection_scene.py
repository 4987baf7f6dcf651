"""Scene of a mesh whose points have lobes of their own, one lobe enlarged, and the map of its directions."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from warpsample.mesh.polydata import surface
from warpsample.plotting.actors import CloudActor, LobeActor, Pin, Sheet
from warpsample.plotting.cell_map import CellMap
from warpsample.plotting.map_chart import MapChart
from warpsample.plotting.panels import Panel, add_bar, add_title, columns_over_caption, draw_panel, fit_view
from warpsample.plotting.rendering import pixels_of
from warpsample.plotting.scenes import draw_frame
from warpsample.plotting.style import INK, LOBE, SKY

if TYPE_CHECKING:
    import pyvista

_WIDTH = 4.3  # inches of the sheet with the maps, for which its text is sized
_SHARE = "density, share of the lobe's largest"
_PLACES = {
    "observed": (0.16, 0.705, 0.62, 0.21),
    "expected": (0.16, 0.42, 0.62, 0.21),
    "density": (0.81, 0.42, 0.03, 0.495),
    "residuals": (0.16, 0.1, 0.62, 0.21),
    "sigma": (0.81, 0.1, 0.03, 0.21),
}
_AMBIENT = 0.45  # light from everywhere, so that colours in shadow are those of the bar
_NEAR = 1.15  # half the height of the panel with the enlarged lobe
_PIN = 8.0  # pixels, of which anti-aliasing leaves half
_BRUSH = "#7a7a7a"


@dataclass(frozen=True, eq=False)
class EnlargedLobe:
    """Lobe of one point in the frame of the point: directions, the density as a surface, and the map of many directions.

    Attributes:
        position: (n, 3) directions with the length of `share`.
        share: (n,) density as a share of the lobe's largest.
        surface: (I, J, 3) grid of the density as a surface.
        view: (3,) direction to the viewer.
        cells: map of the counted directions.
    """

    position: np.ndarray
    share: np.ndarray
    surface: np.ndarray
    view: np.ndarray
    cells: CellMap


def reflection_scene(
    mesh: tuple[np.ndarray, np.ndarray],
    panel: Panel,
    *,
    clouds: tuple[np.ndarray, np.ndarray],
    lines: np.ndarray,
    pin: tuple[np.ndarray, np.ndarray],
    lobe: EnlargedLobe,
    caption: str,
    up: str,
    off_screen: bool,
    size: tuple[int, int],
) -> "pyvista.Plotter":
    """Build a plotter that shows clouds of directions on a mesh, one enlarged lobe, and the map of its directions.

    Args:
        mesh: (V, 3) vertices and (F, 3) faces.
        panel: numbers at the vertices, and their colours.
        clouds: (N, 3) positions of directions, and (N,) densities as shares of the largest of their lobe.
        lines: (M, 2, 3) ends of lines on the surface.
        pin: (3,) foot and (3,) head of a pin at the point of the enlarged lobe.
        lobe: enlarged lobe.
        caption: text below the scene.
        up: name of the axis that points up: "x", "y" or "z".
        off_screen: whether no window is opened.
        size: width and height of the picture in pixels.
    """
    import pyvista as pv

    plotter = columns_over_caption(3, caption, off_screen, size)
    plotter.subplot(0, 0)
    colored = draw_panel(plotter, surface(*mesh).compute_normals(split_vertices=False), panel)
    colored.prop.lighting, colored.prop.interpolation = True, "Phong"
    colored.prop.ambient = _AMBIENT
    ends = np.insert(np.arange(2 * len(lines)).reshape(-1, 2), 0, 2, axis=1)
    brushed = pv.PolyData(lines.reshape(-1, 3), lines=ends.ravel())
    plotter.add_mesh(brushed, color=_BRUSH, line_width=1.5, lighting=False, pickable=False)
    CloudActor(plotter, point_size=3, bar=False).show(*clouds, 1.0)
    Pin(plotter, LOBE, _PIN).show(*pin)
    fit_view(plotter, np.concatenate([mesh[0], clouds[0]]), up)
    plotter.subplot(0, 1)
    _draw_lobe(plotter, lobe)
    plotter.subplot(0, 2)
    width = round(size[0] / 3)
    Sheet(plotter).show(draw_map(lobe.cells, (width, round(_height_of(plotter)))))
    return plotter


def draw_map(cells: CellMap, size: tuple[int, int]) -> np.ndarray:
    """Draw the maps of counted directions, density and residuals below each other; return pixels (H, W, 3) uint8."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(_WIDTH, _WIDTH * size[1] / size[0]), dpi=size[0] / _WIDTH, facecolor=SKY)
    MapChart(figure, _PLACES, animated=False).show(cells)
    return pixels_of(figure)


def _draw_lobe(plotter: "pyvista.Plotter", lobe: EnlargedLobe) -> None:
    """Draw the enlarged lobe into the plotter's current renderer: cloud, surface, frame and direction to the viewer."""
    draw_frame(plotter)
    cloud = CloudActor(plotter, point_size=5, bar=False)
    cloud.show(lobe.position, lobe.share, 1.0)
    LobeActor(plotter).show(lobe.surface)
    Pin(plotter, INK, _PIN).show(np.zeros(3), 1.15 * lobe.view)
    add_title(plotter, "Lobe at the red pin; black pin: to the camera")
    add_bar(plotter, cloud.actor, "share", _SHARE, 1.0)
    plotter.scalar_bars["share"].SetDrawBelowRangeSwatch(False)
    plotter.camera.parallel_scale = _NEAR


def _height_of(plotter: "pyvista.Plotter") -> float:
    """Return the height of the plotter's current renderer in pixels."""
    _, bottom, _, top = plotter.renderer.GetViewport()
    return (top - bottom) * plotter.window_size[1]


def brush_lines(position: np.ndarray, tangent: np.ndarray, length: Any) -> np.ndarray:
    """Return lines (M, 2, 3) through positions (M, 3) along unit tangents (M, 3), with lengths (M,)."""
    half = 0.5 * np.asarray(length)[:, None] * tangent
    return np.stack([position - half, position + half], axis=1)
