"""The window: knobs at the left, mesh and one chosen cloud in the middle, charts at the right."""

from dataclasses import replace
from typing import Any

import numpy as np

from warpsample.mesh.mesh import Mesh
from warpsample.mesh.surface import SurfacePoints, sample_surface
from warpsample.plotting.charts import LobeCharts
from warpsample.plotting.rendering import INK, LOBE, MOST_NORMALS, VIEW, budgeted, clouds_told
from warpsample.plotting.scenes import (
    CloudActor,
    LobeActor,
    Mark,
    MeshPicker,
    Sheet,
    draw_frame,
    draw_mesh,
    draw_normals,
    look_from,
)
from warpsample.viewer import controls
from warpsample.viewer.lobes import Choice, all_clouds, lobe_of, one_cloud, told

LENGTH = 0.06
"""Of a lobe on the mesh, over the diagonal of the mesh's box."""
MOST_CHOSEN = 10_000  # directions of the enlarged cloud

_COLUMNS = (controls.WIDTH, 0.37, 0.46)  # of the window's width
_ROWS = (0.54, 0.46)
_KNOBS, _MESH, _CLOUD, _CHARTS = (0, 0), (0, 1), (1, 1), (0, 2)


class Viewer:
    """Clouds on a mesh, one of them enlarged, and charts of all; redrawn at each turn of a knob.

    Attributes:
        plotter: the window, not yet shown.
        controls: its knobs.
        picker: of another point.
        scale: length of a lobe.
        vertices: of the mesh, in drawn coordinates.
        points: where the clouds are, in drawn coordinates: about the middle of the mesh, where float32 is finest.
        chosen: the point whose cloud is enlarged, in drawn coordinates.
        clouds: what is drawn on the mesh.
        near: what is drawn of the chosen point.
    """

    def __init__(
        self,
        mesh: Mesh,
        points: int,
        choice: Choice,
        up: str = "y",
        size: tuple[int, int] = (1600, 900),
        off_screen: bool = False,
    ):
        """Draws everything once.

        Args:
            mesh: any.
            points: clouds on it, at points uniform by area; at most the budget is drawn.
            choice: where the knobs start.
            up: "x", "y" or "z", the mesh's axis that points up.
            size: of the window in pixels.
            off_screen: no window; the widgets work all the same.

        Raises:
            ValueError: a choice that cannot be seen.
        """
        import pyvista as pv  # noqa: PLC0415

        lobe_of(choice.claim)
        self._asked, self._normals, self._kinds = points, mesh.face_normals, set()
        self._middle = 0.5 * (mesh.vertices.min(axis=0) + mesh.vertices.max(axis=0))
        self.scale, self.vertices = LENGTH * mesh.diagonal, mesh.vertices - self._middle
        at = sample_surface(mesh, budgeted(points, 1)[0], choice.seed)
        self.points = replace(at, position=at.position - self._middle)
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
        self._draw_mesh(mesh, up)
        self._choose(int(np.argmax(self.points.normal @ np.array(VIEW[up]))))
        self.plotter.subplot(*_KNOBS)
        self.controls = controls.Controls(self.plotter, choice, self.show)
        self.plotter.render_window.AddObserver("WindowResizeEvent", self.controls.place)
        self.show(choice)

    def show(self, choice: Choice) -> None:
        """Draws a choice; the first of its kind compiles its kernels, and says so."""
        kind = (choice.sequence, type(choice.distribution), getattr(choice.distribution, "method", None), type(choice.claim))
        if self._kinds and kind not in self._kinds:
            self._says.input = "compiling the kernels of this choice, once ..."
            self.plotter.render()
        self._kinds.add(kind)
        _, shown = budgeted(len(self.points), choice.samples)
        self.clouds = all_clouds(replace(choice, samples=shown), self.points, self.scale)
        self._clouds.show(self.clouds.position, self.clouds.pdf, lobe_of(choice.claim).peak)
        self._says.input = self._told(choice, shown)
        self._show_near(choice)

    def summary(self) -> str:
        """What is seen, in a line."""
        choice = self.controls.choice
        _, shown = budgeted(len(self.points), choice.samples)
        judged = (f"{name} {part.verdict()}" for name, part in (("θ", self.clouds.theta), ("φ", self.clouds.azimuth)))
        what = clouds_told((len(self.points), shown), (self._asked, choice.samples))
        return f"{what} of {told(choice.distribution)}; " + "; ".join(judged).replace("\n", ": ")

    def pick(self, position: np.ndarray, face: int) -> None:
        """Enlarges the cloud of another point: its place in drawn coordinates, and the face that it is on."""
        if not self._normals[face].any():
            return  # a degenerate face has no cloud
        self._choose(len(self.points), SurfacePoints(position[None], self._normals[face][None], np.array([face])))
        self._show_near(self.controls.choice)

    def _show_near(self, choice: Choice) -> None:
        drawn = replace(choice, samples=min(choice.samples, MOST_CHOSEN))
        self.near = one_cloud(drawn, self.chosen, self._chosen_id)
        lobe = lobe_of(choice.claim)
        self._near.show(self.near.position, self.near.pdf, lobe.peak)
        self._lobe.show(lobe.surface)
        width, height = self.plotter.window_size
        size = (round(_COLUMNS[2] * width), height)
        if self._charts is None or self._charts.size != size:
            self._charts = LobeCharts(size)
        self._sheet.show(self._charts.draw(self.clouds.theta, self.clouds.azimuth, self.near.disk))
        self.plotter.render()

    def _choose(self, point: int, at: SurfacePoints | None = None) -> None:
        """The point of that id: a row of `points`, unless it is given."""
        row = slice(point, point + 1)
        self.chosen = at or SurfacePoints(self.points.position[row], self.points.normal[row], self.points.face[row])
        self._chosen_id = point
        start = self.chosen.position[0]
        self._mark.show(start, start + 1.4 * self.scale * self.chosen.normal[0])

    def _told(self, choice: Choice, shown: int) -> str:
        density = choice.density and (told(choice.density) if choice.density.parameters else choice.density.name)
        drawn = clouds_told((len(self.points), shown), (self._asked, choice.samples))
        lines = [
            f"{drawn}, {choice.sequence}, seed {choice.seed},",
            f"of {told(choice.distribution)},",
            "drawn at length pdf / largest pdf" + (f" of {density}" if density else ""),
        ]
        if len(self.points) > MOST_NORMALS:
            lines.append(f"normals of {MOST_NORMALS:,} of them")
        if self.clouds.outside:
            lines.append(f"{self.clouds.outside:,} of them outside that density, orange")
        return "\n".join(lines)

    def _draw_charts(self) -> None:
        self.plotter.subplot(*_CHARTS)
        self._charts, self._sheet = None, Sheet(self.plotter)

    def _draw_cloud(self) -> None:
        self.plotter.subplot(*_CLOUD)
        self._near, self._lobe = CloudActor(self.plotter, point_size=4, bar=False), LobeActor(self.plotter)
        draw_frame(self.plotter)
        self._caption("the pinned point's cloud, the density as a surface", 0.98, "top")
        self._caption("double click on the mesh: another point", 0.02, "bottom")

    def _draw_mesh(self, mesh: Mesh, up: str) -> None:
        self.plotter.subplot(*_MESH)
        self.picker = MeshPicker(self.plotter, draw_mesh(self.plotter, self.vertices, mesh.faces), self.pick)
        draw_normals(self.plotter, self.points.position, self.points.normal, self.scale)
        self._clouds = CloudActor(self.plotter, point_size=2, bar=True)
        self._mark = Mark(self.plotter, LOBE)
        self._says = self._caption("", 0.98, "top")
        look_from(self.plotter, up, 1.05)

    def _caption(self, words: str, height: float, edge: str) -> Any:
        """A text whose top or bottom is at a share of the renderer's height."""
        text = self.plotter.add_text(words, position=(0.02, height), viewport=True, color=INK, font_size=9)
        text.prop.justification_vertical = edge
        return text
