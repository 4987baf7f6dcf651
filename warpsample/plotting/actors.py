"""Objects of a PyVista scene whose contents can be replaced: point clouds, surfaces, pins and pictures.

The constructor of each class adds the part to the current renderer of the plotter.
"""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np

from warpsample.mesh.polydata import surface
from warpsample.plotting.rendering import round_ticks
from warpsample.plotting.style import INK, LOBE, font_file

if TYPE_CHECKING:
    import pyvista

OUTSIDE = "#e8871e"
"""Colour of directions with a density of 0."""

_TITLE = "density [1/sr]"
_BAR = {"title": _TITLE, "fmt": "%.4g", "color": INK, "title_font_size": 1, "label_font_size": 15}
_BAR |= {"position_x": 0.2, "position_y": 0.02, "height": 0.1, "width": 0.6}
_FONT_OF_A_FILE = 4  # VTK_FONT_FILE in vtkTextProperty.h, which vtkmodules does not have
_MOST_STEPS = 5  # between ticks of a colour bar


class CloudActor:
    """Cloud of points in a PyVista scene, coloured by density, with an optional colour bar below."""

    def __init__(self, plotter: "pyvista.Plotter", point_size: int, bar: bool):
        import pyvista as pv

        cloud = pv.PolyData(np.zeros((1, 3), np.float32))
        cloud["pdf"] = np.zeros(1, np.float32)
        self.actor = plotter.add_mesh(
            cloud,
            scalars="pdf",
            cmap="viridis",
            below_color=OUTSIDE,
            point_size=point_size,
            lighting=False,
            pickable=False,
            show_scalar_bar=bar,
            scalar_bar_args=_BAR if bar else None,
            reset_camera=False,
        )
        self._bar = plotter.scalar_bars[_TITLE] if bar else None
        if self._bar is not None:
            self._bar.SetBelowRangeAnnotation("")

    def show(self, position: np.ndarray, pdf: np.ndarray, peak: float) -> None:
        """Show other points, (N, 3), coloured by densities, (N,); `peak` is the density of the last colour."""
        import pyvista as pv

        cloud = pv.PolyData(position)
        cloud["pdf"] = np.where(pdf > 0.0, pdf, np.float32(-1.0))  # -1 is below the range: colour OUTSIDE
        self.actor.mapper.dataset = cloud
        self.actor.mapper.scalar_range = (0.0, peak)
        if self._bar is not None:
            label_bar(self._bar, peak)
            self._bar.SetDrawBelowRangeSwatch(bool((pdf <= 0.0).any()))


def label_bar(bar: Any, high: float) -> None:
    """Set the labels of a VTK scalar bar to round numbers from 0 to `high`, and hide the title of the bar.

    VTK draws the title over the labels; only a browser draws the title next to them.
    """
    from vtkmodules.util.numpy_support import numpy_to_vtk

    ticks = round_ticks(high, _MOST_STEPS)
    bar.SetCustomLabels(numpy_to_vtk(ticks[ticks <= high * (1.0 + 1e-6)], deep=True))
    bar.SetUseCustomLabels(True)
    bar.GetTitleTextProperty().SetOpacity(0.0)
    bar.GetLabelTextProperty().SetFontFamily(_FONT_OF_A_FILE)
    bar.GetLabelTextProperty().SetFontFile(font_file())


class LobeActor:
    """Density of directions in a PyVista scene, as a translucent surface over the tangent plane."""

    def __init__(self, plotter: "pyvista.Plotter"):
        import pyvista as pv

        style = {"color": LOBE, "opacity": 0.25, "pickable": False, "reset_camera": False, "show_scalar_bar": False}
        self.actor = plotter.add_mesh(pv.Plane(i_resolution=1, j_resolution=1), **style)

    def show(self, grid: np.ndarray) -> None:
        """Show another surface, given by a grid of points, (I, J, 3), on I rings and J spokes."""
        rings, spokes = grid.shape[:2]
        first = (np.arange(rings - 1)[:, None] * spokes + np.arange(spokes - 1)).ravel()
        quads = np.stack([first, first + 1, first + spokes + 1, first + spokes], axis=1)
        self.actor.mapper.dataset = surface(grid.reshape(-1, 3), quads)


class Sheet:
    """Picture that fills a whole panel of a PyVista window."""

    def __init__(self, plotter: "pyvista.Plotter"):
        import pyvista as pv
        from vtkmodules.vtkRenderingCore import vtkCoordinate, vtkPolyDataMapper2D, vtkTexturedActor2D

        corners = vtkCoordinate()
        corners.SetCoordinateSystemToNormalizedViewport()
        mapper = vtkPolyDataMapper2D()
        mapper.SetTransformCoordinate(corners)
        mapper.SetInputData(pv.Plane(center=(0.5, 0.5, 0.0), i_resolution=1, j_resolution=1))
        self._actor = vtkTexturedActor2D()
        self._actor.SetMapper(mapper)
        plotter.add_actor(self._actor, pickable=False)

    def show(self, pixels: np.ndarray) -> None:
        """Show another picture, given by its pixels, (H, W, 3) uint8."""
        import pyvista as pv

        self._actor.SetTexture(pv.Texture(pixels))


class Pin:
    """Pin in a PyVista scene: a line with a round head that marks a point."""

    def __init__(self, plotter: "pyvista.Plotter", colour: str, width: float = 4.0):
        """Add a pin of a colour, with a width of the line in pixels."""
        import pyvista as pv

        style = {"color": colour, "pickable": False, "reset_camera": False}
        self._shaft = plotter.add_mesh(pv.Line(), line_width=width, **style)
        style |= {"point_size": 3.25 * width, "render_points_as_spheres": True}
        self._head = plotter.add_mesh(pv.PolyData(np.zeros((1, 3))), **style)

    def show(self, start: np.ndarray, end: np.ndarray) -> None:
        """Move the pin: its foot to `start`, (3,), and its head to `end`, (3,)."""
        import pyvista as pv

        self._shaft.mapper.dataset = pv.Line(start, end)
        self._head.mapper.dataset = pv.PolyData(end[None])

    def set_visible(self, visible: bool) -> None:
        """Show or hide the pin."""
        self._shaft.SetVisibility(visible)
        self._head.SetVisibility(visible)


class MeshPicker:
    """Mouse picking in a PyVista scene: a double click selects a point of a mesh and its face."""

    def __init__(self, plotter: "pyvista.Plotter", actor: Any, choose: Callable[[np.ndarray, int], None]):
        """Call `choose` with the point, (3,), and its face at each double click on an actor of the current renderer.

        The drawn surface has the faces in the order of the mesh, also where its sharp edges are split (a test checks this).
        """
        from vtkmodules.vtkRenderingCore import vtkCellPicker

        self._renderer, self._choose, self._picker = plotter.renderer, choose, vtkCellPicker()
        self._picker.PickFromListOn()
        self._picker.AddPickList(actor)
        iren = plotter.iren
        iren.track_click_position(lambda _: self.click(iren.get_event_position()), side="left", double=True, viewport=True)

    def click(self, at: tuple[int, int]) -> None:
        """Pick the point of the mesh at a pixel, as a double click does.

        Pixels count from the lower left corner of the window.
        """
        if self._renderer.IsInViewport(*at) and self._picker.Pick(*at, 0, self._renderer) and self._picker.GetCellId() >= 0:
            self._choose(np.array(self._picker.GetPickPosition()), self._picker.GetCellId())
