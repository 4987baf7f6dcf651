"""Figure of rays towards a map of distant light: on the map, at points of a scene, and the light that they compute."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from warpsample.plotting.style import INK

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_WIDTH, _HEIGHT = 16.0, 11.3  # inches, for which the text is sized
_TITLE, _TEXT = 17, 14
_GAMMA = 2.2
_LEVELS = 40  # of brightness in pictures of noise, which are then smaller files
_COLOURS = "#ffd23f", "#ff2e63"  # of rays from the first and from the second distribution
_ZOOM = 4.0  # degrees, height of the enlarged part of the map


@dataclass(frozen=True, eq=False)
class RayColumn:
    """Column of the figure: rays from one or two distributions.

    Attributes:
        title: text above the column.
        directions: unit directions of rays from each distribution, (N, 3), which are drawn on the map.
        note: text below the map.
        rays: near and far ends of rays from each distribution in the view of the scene, (M, 2, 2).
        light: (H, W, 3) light in the view of the scene; 0 is black, 1 and more is brightest.
        error: text below the light.
    """

    title: str
    directions: list[np.ndarray]
    note: str
    rays: list[np.ndarray]
    light: np.ndarray
    error: str


@dataclass(frozen=True, eq=False)
class RayRows:
    """Pictures that all columns share.

    Attributes:
        names: text at the left of each of the three rows.
        picture: (H, 2H, 3) equirectangular map of the light; row 0 is about +z, columns go from x towards y.
        zoom: (3,) unit direction whose surroundings are enlarged in a corner of the map.
        shading: (H, W) grey picture of the scene, behind its rays, 0 to 1.
        view: left, right, bottom and top of the view of the scene.
        point: (2,) position in the view of the point whose rays are drawn on the map.
    """

    names: tuple[str, str, str]
    picture: np.ndarray
    zoom: np.ndarray
    shading: np.ndarray
    view: tuple[float, float, float, float]
    point: np.ndarray


def ray_sheet(columns: list[RayColumn], rows: RayRows, caption: str) -> "Figure":
    """Draw columns side by side, each with a map, rays in a scene, and light, and a caption below."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(_WIDTH, _HEIGHT), layout="compressed", dpi=100)
    left, right, bottom, top = rows.view
    ratio = (top - bottom) / (right - left)
    grid = figure.subplots(3, len(columns), height_ratios=(0.5, ratio, ratio), squeeze=False)
    for (on_map, scene, light), column in zip(grid.T, columns, strict=True):
        on_map.set_title(column.title, fontsize=_TITLE, color=INK)
        on_map.set_xlabel(column.note, fontsize=_TITLE, color=INK)
        _draw_map(on_map, rows, column.directions)
        _draw_rays(scene, rows, column.rays)
        shown = np.round(_LEVELS * _as_screens_do(column.light)) / _LEVELS
        light.imshow(shown, extent=rows.view, interpolation="nearest")
        light.set_xlabel(column.error, fontsize=_TITLE, color=INK)
    for axes in grid.flat:
        axes.set(xticks=[], yticks=[])
        axes.spines[:].set_visible(False)
    for axes, name in zip(grid[:, 0], rows.names, strict=True):
        axes.set_ylabel(name, fontsize=_TEXT, color=INK)
    figure.supxlabel(caption, fontsize=_TEXT, color=INK)
    return figure


def map_degrees(directions: np.ndarray) -> np.ndarray:
    """Return azimuth from x towards y, 0 to 360, and altitude, -90 to 90, of unit directions (..., 3), as (..., 2)."""
    x, y, z = np.moveaxis(directions.astype(np.float64), -1, 0)
    return np.degrees(np.stack([np.arctan2(y, x) % (2.0 * np.pi), np.arcsin(np.clip(z, -1.0, 1.0))], axis=-1))


def _as_screens_do(light: np.ndarray) -> np.ndarray:
    """Return the brightness of pixels, 0 to 1, for light of 0 to 1 and more."""
    return np.float_power(np.clip(light, 0.0, 1.0), 1.0 / _GAMMA)


def _draw_map(axes: "Axes", rows: RayRows, directions: list[np.ndarray]) -> None:
    """Draw the map of the light with directions as dots, and an enlarged part of the map in the lower right corner."""
    inset, shown = axes.inset_axes((0.75, 0.0, 0.25, 0.5)), _as_screens_do(rows.picture)
    for part, size in ((axes, 5.0), (inset, 6.0)):
        part.imshow(shown, extent=(0.0, 360.0, -90.0, 90.0), interpolation="nearest")
        for w, colour in zip(directions, _COLOURS, strict=True):
            part.plot(*map_degrees(w).T, ".", color=colour, markersize=size, markeredgecolor=INK, markeredgewidth=0.3)
    azimuth, altitude = map_degrees(rows.zoom)
    wide = 0.5 * _ZOOM / np.cos(np.radians(altitude))  # so that discs are round
    inset.set(xlim=(azimuth - wide, azimuth + wide), ylim=(altitude - 0.5 * _ZOOM, altitude + 0.5 * _ZOOM), aspect="auto")
    inset.set(xticks=[], yticks=[])
    inset.spines[:].set_color("white")
    axes.indicate_inset_zoom(inset, edgecolor="white", alpha=1.0)


def _draw_rays(axes: "Axes", rows: RayRows, rays: list[np.ndarray]) -> None:
    """Draw rays as lines with a dot at the far end on the grey picture of the scene, and mark the point of the map."""
    axes.imshow(rows.shading, interpolation="nearest", cmap="gray", vmin=0.0, vmax=1.0, extent=rows.view)
    for ends, colour in zip(rays, _COLOURS, strict=True):
        axes.plot(*ends.transpose(2, 1, 0), color=colour, linewidth=0.8)
        axes.plot(*ends[:, 1].T, ".", color=colour, markersize=4.0)
    axes.plot(*rows.point, "v", color="white", markersize=10.0, markeredgecolor=INK)
