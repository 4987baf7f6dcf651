"""Parts of a PyVista scene whose contents can be replaced: clouds, lobes, pins, a sheet of pixels, and the mouse.

Each adds itself to the current renderer of its plotter.
"""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np

from warpsample.mesh.polydata import surface
from warpsample.plotting.rendering import INK, LOBE, round_ticks

if TYPE_CHECKING:
    import pyvista

OUTSIDE = "#e8871e"
"""The colour of directions at which the density is 0."""

_TITLE = "density [1/sr]"
_BAR = {"title": _TITLE, "fmt": "%.4g", "color": INK, "title_font_size": 1, "label_font_size": 15}
_BAR |= {"position_x": 0.2, "position_y": 0.02, "height": 0.1, "width": 0.6}
_MOST_STEPS = 5  # of a colour bar's ticks


class CloudActor:
    """Points of so many pixels, coloured by density, as one actor; a colour bar may stand below them."""

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
        """Replaces the points, (N, 3), and their densities per steradian, (N,); `peak` is what has the last colour."""
        import pyvista as pv

        cloud = pv.PolyData(position)
        cloud["pdf"] = np.where(pdf > 0.0, pdf, np.float32(-1.0))  # -1 is below the range and so has the colour OUTSIDE
        self.actor.mapper.dataset = cloud
        self.actor.mapper.scalar_range = (0.0, peak)
        if self._bar is not None:
            label_bar(self._bar, peak)
            self._bar.SetDrawBelowRangeSwatch(bool((pdf <= 0.0).any()))


def label_bar(bar: Any, high: float) -> None:
    """Labels a VTK scalar bar, from 0 to `high`, at round numbers.

    Its title is hidden: only a browser draws it clear of the labels.
    """
    from vtkmodules.util.numpy_support import numpy_to_vtk

    ticks = round_ticks(high, _MOST_STEPS)
    bar.SetCustomLabels(numpy_to_vtk(ticks[ticks <= high * (1.0 + 1e-6)], deep=True))
    bar.SetUseCustomLabels(True)
    bar.GetTitleTextProperty().SetOpacity(0.0)


class LobeActor:
    """A density as a translucent surface over the tangent plane."""

    def __init__(self, plotter: "pyvista.Plotter"):
        import pyvista as pv

        style = {"color": LOBE, "opacity": 0.25, "pickable": False, "reset_camera": False, "show_scalar_bar": False}
        self.actor = plotter.add_mesh(pv.Plane(i_resolution=1, j_resolution=1), **style)

    def show(self, grid: np.ndarray) -> None:
        """Replaces the surface by (I, J, 3) points of I rings with J spokes."""
        rings, spokes = grid.shape[:2]
        first = (np.arange(rings - 1)[:, None] * spokes + np.arange(spokes - 1)).ravel()
        quads = np.stack([first, first + 1, first + spokes + 1, first + spokes], axis=1)
        self.actor.mapper.dataset = surface(grid.reshape(-1, 3), quads)


class Sheet:
    """Pixels that fill a renderer, whatever its camera does."""

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
        """Replaces the pixels, (H, W, 3) uint8."""
        import pyvista as pv

        self._actor.SetTexture(pv.Texture(pixels))


class Pin:
    """A pin that stands on a point."""

    def __init__(self, plotter: "pyvista.Plotter", colour: str):
        import pyvista as pv

        style = {"color": colour, "pickable": False, "reset_camera": False}
        self._shaft = plotter.add_mesh(pv.Line(), line_width=4, **style)
        self._head = plotter.add_mesh(pv.PolyData(np.zeros((1, 3))), point_size=13, render_points_as_spheres=True, **style)

    def show(self, start: np.ndarray, end: np.ndarray) -> None:
        """Moves the pin: it stands on `start`, (3,), and its head is at `end`, (3,)."""
        import pyvista as pv

        self._shaft.mapper.dataset = pv.Line(start, end)
        self._head.mapper.dataset = pv.PolyData(end[None])


class MeshPicker:
    """Finds the point of a mesh that is under the mouse."""

    def __init__(self, plotter: "pyvista.Plotter", actor: Any, picked: Callable[[np.ndarray, int], None]):
        """Calls `picked` with the point, (3,), and its face at a double click on an actor of the current renderer.

        The faces of the drawn surface are in the mesh's order, whether its edges are split or not (a test sees to it).
        """
        from vtkmodules.vtkRenderingCore import vtkCellPicker

        self._renderer, self._picked, self._picker = plotter.renderer, picked, vtkCellPicker()
        self._picker.PickFromListOn()
        self._picker.AddPickList(actor)
        iren = plotter.iren
        iren.track_click_position(lambda _: self.click(iren.get_event_position()), side="left", double=True, viewport=True)

    def click(self, at: tuple[int, int]) -> None:
        """Does what a double click does, at pixels from the window's lower left corner."""
        if self._renderer.IsInViewport(*at) and self._picker.Pick(*at, 0, self._renderer) and self._picker.GetCellId() >= 0:
            self._picked(np.array(self._picker.GetPickPosition()), self._picker.GetCellId())
