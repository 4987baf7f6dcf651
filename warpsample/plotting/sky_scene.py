"""Scene of irradiation on a mesh in a year and in an hour, and a map of the sky above one point."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from warpsample.mesh.polydata import surface
from warpsample.plotting.panels import Panel, add_title, columns_over_caption, draw_edges, draw_panel, fit_view
from warpsample.plotting.rendering import AXES, round_ticks
from warpsample.plotting.style import AMOUNT, INK, font_file

if TYPE_CHECKING:
    import pyvista

SUN = "#ffd23f"
_PATH, _PIN = "#1f4e79", "#00a2ff"
_QUADS = 8  # of each patch: its sides are arcs
_HOUR, _IRRADIANCE = "hour", "mean irradiance of the hour, W/m²"
_SKY = "Sky above the blue pin, with the sun"
_SHARE = "share of the view per sky patch (grey: hidden)"
_ABOVE = 0.9  # height of the camera: the ground between the walls is seen


@dataclass(frozen=True, eq=False)
class SkyMap:
    """Sky above a point, in degrees: K patches, the paths of the sun on some days, and the sun in T hours.

    Attributes:
        altitudes: (K, 2) altitude of the lower and upper edge of each patch.
        azimuths: (K, 2) azimuth of the two sides of each patch, clockwise from north.
        shares: (K,) share of the point's cosine lobe that each patch fills.
        paths: (N, 2) altitude and azimuth of the sun along a day, keyed by the name of the day.
        sun: (T, 2) altitude and azimuth of the sun in the hours of the slider.
    """

    altitudes: np.ndarray
    azimuths: np.ndarray
    shares: np.ndarray
    paths: dict[str, np.ndarray]
    sun: np.ndarray


def map_positions(altitude: np.ndarray, azimuth: np.ndarray) -> np.ndarray:
    """Convert altitudes and azimuths, in degrees, to positions on a map of the sky, (..., 3).

    The zenith is the origin and the horizon a circle of radius 1. North is up (+y) and east at the right (+x), as on a map
    of the ground; a photograph of the sky is its mirror image.
    """
    radius, angle = 1.0 - np.asarray(altitude) / 90.0, np.radians(azimuth)
    return np.stack([radius * np.sin(angle), radius * np.cos(angle), np.zeros_like(radius + angle)], axis=-1)


def map_patches(altitudes: np.ndarray, azimuths: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Build the polygons of K sky patches on a map of the sky: points, (N, 3), and quads, (K * 8, 4).

    Each patch has eight quads, in order.
    """
    share = np.linspace(0.0, 1.0, _QUADS + 1)
    azimuth = azimuths[:, :1] + share * np.diff(azimuths, axis=1)
    lower, upper = (map_positions(altitudes[:, [side]], azimuth) for side in (0, 1))
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
    """Build a plotter that shows a mesh in colours of a year and of an hour, and a map of the sky above a point.

    In a window a slider chooses the hour.

    Args:
        mesh: (V, 3) vertices and (F, 3) faces.
        year: numbers of the year at the faces, and their colours.
        hours: (T, F) mean irradiance in each hour, W/m².
        hour: hour that is shown first, a row of `hours`.
        sky: sky above `point`.
        point: (3,) position that a blue pin marks on both meshes.
        captions: text below the scene, and a function that returns the title for an hour.
        up: name of the axis that points up: "x", "y" or "z".
        off_screen: whether no window is opened.
        size: width and height of the picture in pixels.
    """
    plotter = columns_over_caption(3, captions[0], off_screen, size)
    high = round_ticks(float(max(hours.max(), 1.0)), 5)[-1]
    shown = Panel(hours[hour], _HOUR, year.colours, high, _IRRADIANCE)
    surfaces = [surface(*mesh) for _ in range(2)]
    rise = max(float(np.ptp(mesh[0] @ AXES[up])), 1e-6)  # the pin ends above the roofs
    tip = point + 1.2 * rise * np.array(AXES[up])
    for column, (colored, panel) in enumerate(zip(surfaces, (year, shown), strict=True)):
        plotter.subplot(0, column)
        draw_panel(plotter, colored, panel)
        draw_edges(plotter, *mesh)
        _draw_pin(plotter, point, tip)
        fit_view(plotter, mesh[0], up, _ABOVE)
    plotter.subplot(0, 2)
    sun = _draw_sky(plotter, sky)
    plotter.subplot(0, 1)

    def show(value: float) -> None:
        now = round(value)
        surfaces[1][_HOUR] = hours[now]
        sun.points = map_positions(*sky.sun[now].T)[None]
        plotter.subplot(0, 1)
        add_title(plotter, captions[1](now), f"title {_HOUR}")

    show(hour)
    if not off_screen:
        slider = {"fmt": "%.0f h", "pointa": (0.15, 0.2), "pointb": (0.85, 0.2), "color": INK}
        plotter.add_slider_widget(show, (0, len(hours) - 1), value=hour, **slider)
    plotter.link_views([0, 1])
    return plotter


def _draw_pin(plotter: "pyvista.Plotter", start: np.ndarray, end: np.ndarray) -> None:
    """Draw a line with a round head from `start`, (3,), to `end`, (3,), into the current renderer."""
    import pyvista as pv

    style = {"color": _PIN, "lighting": False, "show_scalar_bar": False}
    plotter.add_mesh(pv.Line(start, end), line_width=8, **style)
    plotter.add_mesh(pv.PolyData(end[None]), point_size=32, render_points_as_spheres=True, **style)


def _draw_sky(plotter: "pyvista.Plotter", sky: SkyMap) -> Any:
    """Draw the map of the sky into the plotter's current renderer, and return the actor of the sun's dot."""
    import pyvista as pv

    high = round_ticks(float(max(sky.shares.max(), 1e-6)), 5)[-1]
    shares = np.repeat(np.where(sky.shares > 0.0, sky.shares, np.nan), _QUADS)
    points, quads = map_patches(sky.altitudes, sky.azimuths)
    draw_panel(plotter, surface(points, quads), Panel(shares, _SKY, AMOUNT, high, _SHARE))
    labels = {"N": 0.0, "E": 90.0, "S": 180.0, "W": 270.0}
    places = {name: 1.1 * map_positions(0.0, azimuth) for name, azimuth in labels.items()}
    for day, path in sky.paths.items():
        if len(path) > 1:
            line = map_positions(*path.T) + np.array([0.0, 0.0, 0.01])
            plotter.add_mesh(pv.lines_from_points(line), color=_PATH, line_width=3, lighting=False)
            places[f"sun's path on {day}"] = line[np.argmax(path[:, 0])] - [0.0, 0.09, 0.0]
    style = {"font_size": 17, "shape": None, "show_points": False, "always_visible": True, "text_color": INK}
    style |= {"justification_horizontal": "center", "justification_vertical": "center", "font_file": font_file()}
    plotter.add_point_labels(np.array(list(places.values())), list(places), **style)
    dot = pv.PolyData(np.zeros((1, 3)))
    plotter.add_mesh(dot, color=SUN, point_size=22, render_points_as_spheres=True)
    plotter.view_xy()
    plotter.enable_parallel_projection()
    plotter.camera.parallel_scale = 1.5
    plotter.camera.focal_point = (0.0, -0.08, 0.0)
    plotter.camera.position = (0.0, -0.08, 5.0)
    return dot
