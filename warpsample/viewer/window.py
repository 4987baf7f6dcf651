"""Window of the viewer, whose clouds of directions and charts follow the menus, the sliders and the camera."""

from dataclasses import fields, replace
from textwrap import wrap
from typing import Any

import numpy as np

from warpsample.distributions.record import Distribution
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.points.sampling import sample_surface
from warpsample.mesh.surface import SurfacePoints
from warpsample.mesh.tangents import face_tangents
from warpsample.plotting.rendering import MOST_NORMALS, VIEW, describe_counts, limit_counts
from warpsample.texture.occlusion_picture import OcclusionPicture
from warpsample.viewer.choice import Choice, format_distribution
from warpsample.viewer.clouds import MOST_COUNTED, all_clouds, count_clouds, one_cloud
from warpsample.viewer.controls import Controls
from warpsample.viewer.own_lobes import check_rows, follows_camera, lobes_at
from warpsample.viewer.panels import Panels

LENGTH = 0.06
"""Length of a lobe on the mesh, as a share of the diagonal of the mesh's bounding box."""

_MOST_NEAR = 10_000  # directions of the enlarged cloud
_MOST_LETTERS = 62  # of a line above the mesh


class Viewer(Panels):
    """Window of `warpsample view`: clouds of directions on a mesh, one enlarged cloud, and charts of all directions.

    Every change of a menu or slider redraws all of them. If the lobes depend on the direction to the viewer, the camera is
    the viewer: clouds change while the user turns the model, and the charts change when the user stops.

    Coordinates are relative to the middle of the mesh, where float32 is most precise.

    Attributes:
        vertices: (V, 3) vertices of the mesh.
        points: points with clouds.
        scale: length of a lobe in the unit of the mesh.
        chosen: pinned point, whose cloud is enlarged.
        near: enlarged cloud; None if the pinned point has no directions.
        clouds: clouds at all points.
        counts: counts of the angles of all directions; None without directions.
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
        uv: np.ndarray | None = None,
    ):
        """Build the window: menus and sliders, the mesh with clouds of directions, the enlarged cloud, and the charts.

        Args:
            mesh: mesh that carries the points.
            points: number of points, placed uniformly by area; at most MOST_POINTS are drawn.
            choice: settings at the start. Parameters by point have a row for each vertex or each face.
            up: name of the mesh's axis that points up: "x", "y" or "z".
            size: width and height of the window in pixels.
            off_screen: whether no window is opened. The widgets work without a window too.
            occlusion: picture of baked occlusion, shown on the mesh.
            uv: (F, 3, 2) texture coordinates of face corners. The x axes of lobes that are not symmetric are then
                along increasing u.

        Raises:
            ValueError: the lobe of the compared density is too narrow to draw, or parameters by point have another number
                of rows.
        """
        check_rows(choice, mesh)
        self._requested, self._normals, self._kinds = points, mesh.face_normals, set()
        self._mesh, self._uv, self._middle = mesh, uv, mesh.bounds.mean(axis=0)
        self.scale, self.vertices = LENGTH * mesh.diagonal, mesh.vertices - self._middle
        at = sample_surface(mesh, limit_counts(points, 1)[0], seed=choice.seed)
        self.points: SurfacePoints = self._with_tangents(replace(at, position=at.position - self._middle))
        super().__init__(size, off_screen)
        self.add_mesh(mesh, self.points, middle=self._middle, scale=self.scale, up=up, occlusion=occlusion)
        self._pin_point(int(np.argmax(self.points.normal @ np.array(VIEW[up]))))
        self.choose_knobs()
        self.controls: Controls = Controls(self.plotter, choice, self.show)
        self.controls.lay_out()
        self.plotter.render_window.AddObserver("WindowResizeEvent", self.controls.lay_out)
        self.show(choice)
        self.plotter.render_window.AddObserver("StartEvent", self.follow)

    def show(self, choice: Choice) -> None:
        """Draw the clouds and charts of the given settings in the window.

        If kernels must be compiled first, the caption reports this.
        """
        kind = (choice.sequence, *_kernels_of(choice.distribution), *_kernels_of(choice.claim), choice.camera)
        if self._kinds and kind not in self._kinds:
            self.caption.input = "Compiling the kernels of this choice, once ..."
            self.plotter.render()
        self._kinds.add(kind)
        self._draw_directions(choice)
        self._draw_charts()
        self.plotter.render()

    def follow(self, *_: Any) -> None:
        """Draw the lobes of the present camera, before each frame: clouds always, charts when the user stops turning."""
        if not follows_camera(self.controls.choice):
            return
        if not np.array_equal(self.eye, self._drawn_eye):
            self._draw_directions(self.controls.choice)
        if self._are_charts_old and not self.is_turning:
            self._draw_charts()

    def summary(self) -> str:
        """Describe the window in one line: counts, distribution, compared density and verdicts."""
        choice = self.controls.choice
        parts = (("θ", "theta"), ("φ", "azimuth"), ("(θ, φ)", "cells"))
        seen = {name: getattr(self.counts, field, None) for name, field in parts}
        verdicts = (f"{name} {part.verdict()}".replace("\n", ": ") for name, part in seen.items() if part is not None)
        return "; ".join((self._describe_directions(choice), *verdicts))

    def pick(self, position: np.ndarray, face: int) -> None:
        """Select another point of the mesh, and show the cloud of directions there enlarged.

        A point on a degenerate face changes nothing.
        """
        if not self._normals[face].any():
            return
        point = SurfacePoints(position[None], self._normals[face][None], np.array([face]))
        self._pin_point(len(self.points), self._with_tangents(point))
        self._draw_near(self.controls.choice)
        self.show_charts(self.counts, self.near)
        self.plotter.render()

    def _draw_directions(self, choice: Choice) -> None:
        """Draw the clouds of the settings and of the present camera, on the mesh and enlarged, and the caption."""
        _, shown = limit_counts(len(self.points), choice.samples)
        self._drawn_eye = self.eye
        self._drawn = self._lobes_at(replace(choice, samples=shown), self.points)
        self.clouds = all_clouds(self._drawn, self._frame(choice, self.points), self.scale)
        self.show_clouds(self.clouds)
        self.caption.input = self._describe_settings(choice)
        self._draw_near(choice)
        self._are_charts_old = True

    def _draw_near(self, choice: Choice) -> None:
        """Draw the enlarged cloud of directions at the selected point, and its density."""
        drawn = replace(choice, samples=min(choice.samples, _MOST_NEAR))
        self.near = one_cloud(self._lobes_at(drawn, self.chosen), self._frame(choice, self.chosen), self._chosen_id)
        self.show_near(self.near)

    def _lobes_at(self, choice: Choice, points: SurfacePoints) -> Choice:
        """Return settings with the distributions of points, for the present camera."""
        absolute = replace(points, position=points.position + self._middle)
        return lobes_at(choice, self._mesh, absolute, self.eye + self._middle)

    def _with_tangents(self, points: SurfacePoints) -> SurfacePoints:
        """Return points on faces with tangents along increasing u, if the mesh has texture coordinates."""
        return points if self._uv is None else replace(points, tangent=face_tangents(self._mesh, self._uv, points.face))

    def _frame(self, choice: Choice, points: SurfacePoints) -> SurfacePoints:
        """Return points without tangents for lobes that are symmetric about the normal; else return the points."""
        return replace(points, tangent=None) if _is_symmetric(choice) else points

    def _draw_charts(self) -> None:
        """Count the directions that are drawn, and draw the charts."""
        self.counts = count_clouds(self._drawn, self.clouds)
        self.show_charts(self.counts, self.near)
        self._are_charts_old = False

    def _pin_point(self, point: int, at: SurfacePoints | None = None) -> None:
        """Mark the selected point on the mesh: `at`, or row `point` of `points`.

        `point` is the global id of the pinned point.
        """
        self.chosen: SurfacePoints = at or self.points.take(slice(point, point + 1))
        self._chosen_id = point
        start = self.chosen.position[0]
        self.pin.show(start, start + 1.4 * self.scale * self.chosen.normal[0])

    def _describe_directions(self, choice: Choice) -> str:
        """Return the counts of points and directions, and the distribution."""
        _, shown = limit_counts(len(self.points), choice.samples)
        counts = describe_counts((len(self.points), shown), (self._requested, choice.samples))
        return f"{counts} of {format_distribution(choice.distribution, choice.camera)}"

    def _describe_settings(self, choice: Choice) -> str:
        """Return the caption above the mesh: counts, distribution, sequence, seed and compared density."""
        claim = choice.density if choice.density is not None and choice.density.parameters else None
        density = format_distribution(claim, choice.camera) if claim else choice.claim_name
        own, used = bool(self._drawn.claim.by_point), len(self.clouds.rows)
        lines = [
            self._describe_directions(choice),
            f"{choice.sequence} points, seed {choice.seed}; compared with {density}",
            f"length and colour: compared density{' / largest at the point' if own else ' [1/sr]'}",
        ]
        if self._uv is not None and not _is_symmetric(choice):
            lines.append("x of the lobes: along u of the texture coordinates")
        if used < len(self.points):
            why = "face away from the camera" if follows_camera(choice) else "have invalid parameters"
            lines.append(f"{len(self.points) - used:,} points {why}: no directions")
        if own and used > MOST_COUNTED:
            lines.append(f"charts: directions of {MOST_COUNTED} points only")
        if len(self.points) > MOST_NORMALS:
            lines.append(f"normals of the first {MOST_NORMALS:,} points only")
        if self.clouds.outside:
            lines.append(f"orange: {self.clouds.outside:,} directions outside that density")
        return "\n".join(piece for line in lines for piece in wrap(line, _MOST_LETTERS))


def _is_symmetric(choice: Choice) -> bool:
    """Return whether the sampled and the compared distribution are symmetric about the normal."""
    return choice.distribution.symmetric and choice.claim.symmetric


def _kernels_of(distribution: Distribution) -> tuple[Any, ...]:
    """Return the properties of a distribution, and of lobes in its fields, for which kernels are compiled."""
    values = [getattr(distribution, item.name) for item in fields(distribution)]
    nested = (kernel for value in values if isinstance(value, Distribution) for kernel in _kernels_of(value))
    return type(distribution), getattr(distribution, "method", None), tuple(distribution.by_point), *nested
