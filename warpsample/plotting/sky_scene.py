"""A scene of what sun and sky bring: a mesh in colours, and the sky above a point of it as a map."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from warpsample.mesh.polydata import surface
from warpsample.plotting.rendering import INK, LOBE, round_ticks
from warpsample.plotting.scenes import ZOOM, Panel, add_title, columns_over_caption, draw_panel, look_from

if TYPE_CHECKING:
    import pyvista

SUN = "#ffd23f"
_QUADS = 8  # of each patch: its sides are arcs
_TITLE = "Share of each sky patch"


@dataclass(frozen=True, eq=False)
class SkyMap:
    """The sky of a point: K patches, the sun's paths on some days, by their names, and where it is in T hours; in degrees.

    Patches have lower and upper edges, (K, 2), two sides, (K, 2), clockwise from north, and the share of the point's lobe
    that each lights, (K,). Paths and suns are altitude and azimuth, (N, 2) and (T, 2); the slider goes through the hours.
    """

    altitudes: np.ndarray
    azimuths: np.ndarray
    shares: np.ndarray
    paths: dict[str, np.ndarray]
    sun: np.ndarray


def on_map(altitude: np.ndarray, azimuth: np.ndarray) -> np.ndarray:
    """(..., 3) positions on a map of the sky, from degrees: the zenith at the origin, the horizon a circle of radius 1.

    North is up (+y) and east at the right (+x), as on a map of the ground; a photograph of the sky mirrors this.
    """
    radius, angle = 1.0 - np.asarray(altitude) / 90.0, np.radians(azimuth)
    return np.stack([radius * np.sin(angle), radius * np.cos(angle), np.zeros_like(radius + angle)], axis=-1)


def patches_on_map(altitudes: np.ndarray, azimuths: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Points (N, 3) and quads (K * 8, 4) of sky patches on a map; eight quads of each patch, one patch after the other."""
    share = np.linspace(0.0, 1.0, _QUADS + 1)
    azimuth = azimuths[:, :1] + share * np.diff(azimuths, axis=1)
    lower, upper = (on_map(altitudes[:, [side]], azimuth) for side in (0, 1))
    first = np.arange(len(altitudes))[:, None] * 2 * (_QUADS + 1) + np.arange(_QUADS)
    quads = np.stack([first, first + 1, first + _QUADS + 2, first + _QUADS + 1], axis=-1)
    return np.stack([lower, upper], axis=1).reshape(-1, 3), quads.reshape(-1, 4)


def sun_and_sky(
    mesh: tuple[np.ndarray, np.ndarray],
    year: Panel,
    *,
    hours: np.ndarray,
    hour: int,
    sky: SkyMap,
    point: np.ndarray,
    captions: tuple[str, Callable[[int], str]],
    up: str,
    off_screen: bool,
    size: tuple[int, int],
) -> "pyvista.Plotter":
    """A plotter with the mesh by a sum, the mesh in an hour, and the sky of a point; in a window a slider turns the hour.

    `mesh` is (V, 3) and (F, 3), `hours` (T, F) the year's sum in each hour, `point` (3,) marked on both meshes, `captions`
    one below all and a function of the hour for its title, `up` the axis that points up, "x", "y" or "z", and `size` in
    pixels.
    """
    import pyvista as pv

    plotter = columns_over_caption(3, captions[0], off_screen, size)
    high = round_ticks(float(max(hours.max(), 1.0)), 5)[-1]
    shown = Panel(hours[hour], "W/m2", year.colours, high)
    made = [surface(*mesh) for _ in range(2)]
    for column, (drawn, panel) in enumerate(zip(made, (year, shown), strict=True)):
        plotter.subplot(0, column)
        draw_panel(plotter, drawn, panel, "" if column else panel.title)
        plotter.add_mesh(pv.PolyData(point[None]), color=LOBE, point_size=14, render_points_as_spheres=True)
        look_from(plotter, up, ZOOM)
    plotter.subplot(0, 2)
    dot = _draw_sky(plotter, sky)
    plotter.subplot(0, 1)

    def show(value: float) -> None:
        now = round(value)
        made[1]["W/m2"] = hours[now]
        dot.points = on_map(*sky.sun[now].T)[None]
        plotter.subplot(0, 1)
        add_title(plotter, captions[1](now), "hour")

    show(hour)
    if not off_screen:
        slider = {"fmt": "%.0f h", "pointa": (0.15, 0.17), "pointb": (0.85, 0.17), "color": INK}
        plotter.add_slider_widget(show, (0, len(hours) - 1), value=hour, **slider)
    plotter.link_views([0, 1])
    return plotter


def _draw_sky(plotter: "pyvista.Plotter", sky: SkyMap) -> Any:
    """Draws the map into the current renderer; the dot of the sun."""
    import pyvista as pv

    high = round_ticks(float(max(sky.shares.max(), 1e-6)), 5)[-1]
    shares = Panel(np.repeat(sky.shares, _QUADS), _TITLE, "gray", high)
    draw_panel(plotter, surface(*patches_on_map(sky.altitudes, sky.azimuths)), shares, _TITLE)
    ends = {}
    for day, path in sky.paths.items():
        if len(path) > 1:
            line = on_map(*path.T)
            plotter.add_mesh(pv.lines_from_points(line), color=SUN, line_width=3)
            ends[day] = line[len(line) // 2]
    ends |= {name: 1.08 * on_map(0.0, azimuth) for name, azimuth in zip("NESW", (0.0, 90.0, 180.0, 270.0), strict=True)}
    style = {"font_size": 16, "shape": None, "show_points": False, "always_visible": True, "text_color": LOBE}
    plotter.add_point_labels(np.array(list(ends.values())), list(ends), **style)
    dot = pv.PolyData(np.zeros((1, 3)))
    plotter.add_mesh(dot, color=SUN, point_size=22, render_points_as_spheres=True)
    plotter.view_xy()
    plotter.enable_parallel_projection()
    plotter.camera.parallel_scale = 1.35
    return dot
