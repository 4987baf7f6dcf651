"""Scene of a mesh or of points in colours, with a colour bar."""

from typing import TYPE_CHECKING

from warpsample.plotting.panels import add_bar, add_title, columns_over_caption, fit_view

if TYPE_CHECKING:
    import pyvista

_COLOURS = "viridis"
_POINT = 5  # pixels


def number_scene(
    numbers: "pyvista.PolyData", name: str, *, title: str, caption: str, high: float, up: str, size: tuple[int, int]
) -> "pyvista.Plotter":
    """Build a plotter that shows a mesh or points coloured by one of their arrays, from 0 to `high`, with a colour bar.

    Args:
        numbers: mesh or points with the array.
        name: name of the array.
        title: text above the scene, the quantity with its unit.
        caption: text below the scene.
        high: value with the last colour.
        up: name of the axis that points up: "x", "y" or "z".
        size: width and height of the picture in pixels.
    """
    plotter = columns_over_caption(1, caption, True, size)
    plotter.subplot(0, 0)
    style = {"cmap": _COLOURS, "clim": (0.0, high), "lighting": False, "point_size": _POINT, "show_scalar_bar": False}
    actor = plotter.add_mesh(numbers, scalars=name, **style)
    add_bar(plotter, actor, title, title, high)
    add_title(plotter, title)
    fit_view(plotter, numbers.points, up)
    return plotter
