"""Panels of the viewer's window: menus and sliders, the mesh, one enlarged cloud of directions, and charts."""

from typing import Any

import numpy as np

from warpsample.mesh.mesh import Mesh
from warpsample.mesh.surface import SurfacePoints
from warpsample.plotting.actors import CloudActor, LobeActor, MeshPicker, Pin, Sheet
from warpsample.plotting.charts import LobeCharts
from warpsample.plotting.scenes import draw_frame, draw_mesh, draw_normals, look_from
from warpsample.plotting.style import INK, LOBE, font_file
from warpsample.texture.occlusion_picture import OcclusionPicture
from warpsample.viewer import widgets
from warpsample.viewer.clouds import Clouds, NearCloud
from warpsample.viewer.counts import AngleCounts
from warpsample.viewer.lobes import shape_of

_COLUMNS = (widgets.WIDTH, 0.37, 0.46)  # of the window's width
_ROWS = (0.54, 0.46)
_KNOBS, _MESH, _CLOUD, _CHARTS = (0, 0), (0, 1), (1, 1), (0, 2)
_CLICK = "Double-click on the mesh to pin another point."


class Panels:
    """Panels of the window, and the parts of their scenes that change.

    Attributes:
        plotter: plotter of the window.
        cloud_actor: clouds on the mesh.
        near_actor: enlarged cloud at the pinned point.
        lobe_actor: lobe at the pinned point.
        caption: text above the mesh.
        picker: mouse picking on the mesh.
        charts: charts that were drawn last; None before.
    """

    def __init__(self, size: tuple[int, int], off_screen: bool):
        """Build a window of a width and height in pixels, with empty panels.

        `off_screen` states whether no window is opened.
        """
        import pyvista as pv

        self.plotter = pv.Plotter(
            shape=(2, 3),
            col_weights=_COLUMNS,
            row_weights=_ROWS,
            groups=[(np.s_[:], 0), (np.s_[:], 2)],
            off_screen=off_screen,
            window_size=size,
            border=False,
        )
        self.plotter.set_background("white", all_renderers=True)
        self.plotter.disable_anti_aliasing(all_renderers=True)  # takes as long as everything else in software
        self.plotter.subplot(*_CHARTS)
        self.charts: LobeCharts | None = None
        self._made_charts: dict[Any, LobeCharts] = {}
        self._sheet = Sheet(self.plotter)
        self._add_cloud()

    def add_mesh(
        self,
        mesh: Mesh,
        points: SurfacePoints,
        *,
        middle: np.ndarray,
        scale: float,
        up: str,
        occlusion: OcclusionPicture | None,
    ) -> None:
        """Create the panel of the window with the mesh, its normals, and selection of points by mouse.

        Args:
            mesh: the mesh.
            points: points with clouds, relative to the middle.
            middle: (3,) middle of the mesh.
            scale: length of a normal.
            up: name of the axis that points up.
            occlusion: picture of baked occlusion, shown on the mesh.
        """
        self.plotter.subplot(*_MESH)
        texture = None if occlusion is None else (occlusion.picture, occlusion.uv)
        actor = draw_mesh(self.plotter, mesh.vertices - middle, mesh.faces, texture)
        self.picker: MeshPicker = MeshPicker(self.plotter, actor, self.pick)
        draw_normals(self.plotter, points.position, points.normal, scale)
        self.cloud_actor: CloudActor = CloudActor(self.plotter, point_size=2, bar=True)
        self.pin: Pin = Pin(self.plotter, LOBE)
        self.caption = self._add_text("", 0.98, "top")
        look_from(self.plotter, up, 1.0)
        self._camera = self.plotter.camera

    def pick(self, position: np.ndarray, face: int) -> None:
        """Select another point of the mesh: a position, (3,) in drawn coordinates, on a face."""
        raise NotImplementedError

    def choose_knobs(self) -> None:
        """Make the panel of the knobs the current one."""
        self.plotter.subplot(*_KNOBS)

    @property
    def eye(self) -> np.ndarray:
        """Position (3,) of the camera of the panel with the mesh, float64."""
        return np.array(self._camera.position, np.float64)

    @property
    def is_turning(self) -> bool:
        """True while the user turns or moves the model."""
        style = self.plotter.iren.interactor.GetInteractorStyle()
        return style.GetState() != 0  # VTKIS_NONE of vtkInteractorStyle.h

    def show_clouds(self, clouds: Clouds) -> None:
        """Replace the clouds on the mesh."""
        self.cloud_actor.show(clouds.position, clouds.color, clouds.peak)

    def show_near(self, near: NearCloud | None) -> None:
        """Replace the enlarged cloud, its lobe and the direction to the viewer; None hides all three."""
        view = None if near is None else getattr(near.lobe, "view", None)
        self.near_actor.actor.SetVisibility(near is not None)
        self.lobe_actor.actor.SetVisibility(near is not None)
        self._view.set_visible(view is not None)
        self._near_title.input = (
            "The pinned point faces away from the camera."
            if near is None
            else "Directions at the pinned point; surface: the compared density"
        )
        self._hint.input = _CLICK if view is None else f"{_CLICK}\nBlack pin: direction to the viewer"
        if near is not None:
            shape = shape_of(near.lobe)
            self.near_actor.show(near.position, near.pdf, shape.peak)
            self.lobe_actor.show(shape.surface)
        if view is not None:
            self._view.show(np.zeros(3), 1.15 * np.array(view))

    def show_charts(self, counts: AngleCounts | None, near: NearCloud | None) -> None:
        """Replace the charts; without directions the panel is empty."""
        width, height = self.plotter.window_size
        size = (round(_COLUMNS[2] * width), height)
        if counts is None:
            self._sheet.show(np.full((*size[::-1], 3), 255, np.uint8))
            return
        key = (size, counts.cells is not None)
        if key not in self._made_charts:
            self._made_charts = {k: v for k, v in self._made_charts.items() if k[0] == size}
            self._made_charts[key] = LobeCharts(*key)
        self.charts = self._made_charts[key]
        disk = np.zeros((0, 2)) if near is None else near.disk
        self._sheet.show(self.charts.draw(counts.theta, counts.azimuth, disk, counts.cells))

    def _add_cloud(self) -> None:
        """Create the panel of the window with the enlarged cloud of directions, still empty."""
        self.plotter.subplot(*_CLOUD)
        self.near_actor, self.lobe_actor = CloudActor(self.plotter, point_size=4, bar=False), LobeActor(self.plotter)
        self._view = Pin(self.plotter, INK)
        draw_frame(self.plotter)
        self._near_title = self._add_text("", 0.98, "top")
        self._hint = self._add_text(_CLICK, 0.02, "bottom")

    def _add_text(self, words: str, height: float, edge: str) -> Any:
        """Add a text to the current renderer, with its edge `edge` at a fraction of the height, and return the actor."""
        text = self.plotter.add_text(words, position=(0.02, height), viewport=True, color=INK, font_file=font_file())
        text.prop.justification_vertical = edge
        return text
