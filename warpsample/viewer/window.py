"""Window of the viewer: menus and sliders, the mesh with directions, one enlarged cloud of directions, and charts."""

from dataclasses import replace
from textwrap import wrap
from typing import Any

import numpy as np

from warpsample.mesh.mesh import Mesh
from warpsample.mesh.points.sampling import sample_surface
from warpsample.mesh.surface import SurfacePoints
from warpsample.plotting.actors import CloudActor, LobeActor, MeshPicker, Pin, Sheet
from warpsample.plotting.charts import LobeCharts
from warpsample.plotting.rendering import MOST_NORMALS, VIEW, describe_counts, limit_counts
from warpsample.plotting.scenes import draw_frame, draw_mesh, draw_normals, look_from
from warpsample.plotting.style import INK, LOBE, font_file
from warpsample.texture.occlusion_picture import OcclusionPicture
from warpsample.viewer import widgets
from warpsample.viewer.choice import Choice, format_distribution
from warpsample.viewer.clouds import all_clouds, one_cloud
from warpsample.viewer.controls import Controls
from warpsample.viewer.lobes import lobe_of

LENGTH = 0.06
"""Length of a lobe on the mesh, as a share of the diagonal of the mesh's bounding box."""

_MOST_NEAR = 10_000  # directions of the enlarged cloud
_MOST_LETTERS = 62  # of a line above the mesh
_COLUMNS = (widgets.WIDTH, 0.37, 0.46)  # of the window's width
_ROWS = (0.54, 0.46)
_KNOBS, _MESH, _CLOUD, _CHARTS = (0, 0), (0, 1), (1, 1), (0, 2)


class Viewer:
    """Window of `warpsample view`: clouds of directions on a mesh, one enlarged cloud, and charts of all directions.

    Every change of a menu or slider redraws all of them.

    Coordinates are relative to the middle of the mesh, where float32 is most precise.

    Attributes:
        vertices: (V, 3) vertices of the mesh.
        points: points with clouds.
        scale: length of a lobe in the unit of the mesh.
        chosen: pinned point, whose cloud is enlarged.
        near: enlarged cloud.
        clouds: clouds at all points.
    """

    def __init__(
        self,
        mesh: Mesh,
        points: int,
        choice: Choice,
        *,
        up: str = "y",
        size: tuple[int, int] = (1600, 900),
        off_screen: bool = False,
        occlusion: OcclusionPicture | None = None,
    ):
        """Build the window: menus and sliders, the mesh with clouds of directions, the enlarged cloud, and the charts.

        Args:
            mesh: mesh that carries the points.
            points: number of points, placed uniformly by area; at most MOST_POINTS are drawn.
            choice: settings at the start.
            up: name of the mesh's axis that points up: "x", "y" or "z".
            size: width and height of the window in pixels.
            off_screen: whether no window is opened. The widgets work without a window too.
            occlusion: picture of baked occlusion, shown on the mesh.

        Raises:
            ValueError: the lobe of the compared density is too narrow to draw.
        """
        import pyvista as pv

        lobe_of(choice.claim)
        self._requested, self._normals, self._kinds = points, mesh.face_normals, set()
        self._middle = 0.5 * (mesh.vertices.min(axis=0) + mesh.vertices.max(axis=0))
        self.scale, self.vertices = LENGTH * mesh.diagonal, mesh.vertices - self._middle
        at = sample_surface(mesh, limit_counts(points, 1)[0], seed=choice.seed)
        self.points: SurfacePoints = replace(at, position=at.position - self._middle)
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
        self._draw_charts()
        self._draw_cloud()
        self._draw_mesh(mesh, up, occlusion)
        self._pin_point(int(np.argmax(self.points.normal @ np.array(VIEW[up]))))
        self.plotter.subplot(*_KNOBS)
        self.controls: Controls = Controls(self.plotter, choice, self.show)
        self.controls.lay_out()
        self.plotter.render_window.AddObserver("WindowResizeEvent", self.controls.lay_out)
        self.show(choice)

    def show(self, choice: Choice) -> None:
        """Draw the clouds and charts of the given settings in the window.

        If kernels must be compiled first, the caption reports this.
        """
        kind = (choice.sequence, type(choice.distribution), getattr(choice.distribution, "method", None), type(choice.claim))
        if self._kinds and kind not in self._kinds:
            self.caption.input = "Compiling the kernels of this choice, once ..."
            self.plotter.render()
        self._kinds.add(kind)
        _, shown = limit_counts(len(self.points), choice.samples)
        self.clouds = all_clouds(replace(choice, samples=shown), self.points, self.scale)
        self.cloud_actor.show(self.clouds.position, self.clouds.pdf, lobe_of(choice.claim).peak)
        self.caption.input = self._describe_settings(choice, shown)
        self._show_near(choice)

    def summary(self) -> str:
        """Describe the window in one line: counts, distribution, compared density and verdicts."""
        choice = self.controls.choice
        _, shown = limit_counts(len(self.points), choice.samples)
        verdicts = (f"{name} {part.verdict()}" for name, part in (("θ", self.clouds.theta), ("φ", self.clouds.azimuth)))
        counts = describe_counts((len(self.points), shown), (self._requested, choice.samples))
        return f"{counts} of {format_distribution(choice.distribution)}; " + "; ".join(verdicts).replace("\n", ": ")

    def pick(self, position: np.ndarray, face: int) -> None:
        """Select another point of the mesh, and show the cloud of directions there enlarged.

        A point on a degenerate face changes nothing.
        """
        if not self._normals[face].any():
            return
        self._pin_point(len(self.points), SurfacePoints(position[None], self._normals[face][None], np.array([face])))
        self._show_near(self.controls.choice)

    def _show_near(self, choice: Choice) -> None:
        """Draw the enlarged cloud of directions at the selected point, its density, and the charts."""
        drawn = replace(choice, samples=min(choice.samples, _MOST_NEAR))
        self.near = one_cloud(drawn, self.chosen, self._chosen_id)
        lobe = lobe_of(choice.claim)
        self.near_actor.show(self.near.position, self.near.pdf, lobe.peak)
        self.lobe_actor.show(lobe.surface)
        width, height = self.plotter.window_size
        size = (round(_COLUMNS[2] * width), height)
        if self.charts is None or self.charts.size != size:
            self.charts = LobeCharts(size)
        self._sheet.show(self.charts.draw(self.clouds.theta, self.clouds.azimuth, self.near.disk))
        self.plotter.render()

    def _pin_point(self, point: int, at: SurfacePoints | None = None) -> None:
        """Mark the selected point on the mesh: `at`, or row `point` of `points`.

        `point` is the global id of the pinned point.
        """
        self.chosen: SurfacePoints = at or self.points.take(slice(point, point + 1))
        self._chosen_id = point
        start = self.chosen.position[0]
        self._pin.show(start, start + 1.4 * self.scale * self.chosen.normal[0])

    def _describe_settings(self, choice: Choice, shown: int) -> str:
        """Return the caption above the mesh: counts, distribution, sequence, seed and compared density."""
        claim = choice.density if choice.density is not None and choice.density.parameters else None
        density = format_distribution(claim) if claim else choice.claim_name
        counts = describe_counts((len(self.points), shown), (self._requested, choice.samples))
        lines = [
            f"{counts} of {format_distribution(choice.distribution)}",
            f"{choice.sequence} points, seed {choice.seed}; compared with {density}",
            "length and colour: compared density [1/sr]",
        ]
        if len(self.points) > MOST_NORMALS:
            lines.append(f"normals of the first {MOST_NORMALS:,} points only")
        if self.clouds.outside:
            lines.append(f"orange: {self.clouds.outside:,} directions outside that density")
        return "\n".join(piece for line in lines for piece in wrap(line, _MOST_LETTERS))

    def _draw_charts(self) -> None:
        """Create the panel of the window that shows the charts, still empty."""
        self.plotter.subplot(*_CHARTS)
        self.charts, self._sheet = None, Sheet(self.plotter)

    def _draw_cloud(self) -> None:
        """Create the panel of the window with the enlarged cloud of directions, still empty."""
        self.plotter.subplot(*_CLOUD)
        self.near_actor, self.lobe_actor = CloudActor(self.plotter, point_size=4, bar=False), LobeActor(self.plotter)
        draw_frame(self.plotter)
        self._add_text("Directions at the pinned point; surface: the compared density", 0.98, "top")
        self._add_text("Double-click on the mesh to pin another point.", 0.02, "bottom")

    def _draw_mesh(self, mesh: Mesh, up: str, occlusion: OcclusionPicture | None) -> None:
        """Create the panel of the window with the mesh, its normals, and selection of points by mouse."""
        self.plotter.subplot(*_MESH)
        texture = None if occlusion is None else (occlusion.picture, occlusion.uv)
        actor = draw_mesh(self.plotter, self.vertices, mesh.faces, texture)
        self.picker: MeshPicker = MeshPicker(self.plotter, actor, self.pick)
        draw_normals(self.plotter, self.points.position, self.points.normal, self.scale)
        self.cloud_actor: CloudActor = CloudActor(self.plotter, point_size=2, bar=True)
        self._pin = Pin(self.plotter, LOBE)
        self.caption = self._add_text("", 0.98, "top")
        look_from(self.plotter, up, 1.0)

    def _add_text(self, words: str, height: float, edge: str) -> Any:
        """Add a text to the current renderer, with its edge `edge` at a fraction of the height, and return the actor."""
        text = self.plotter.add_text(words, position=(0.02, height), viewport=True, color=INK, font_file=font_file())
        text.prop.justification_vertical = edge
        return text
