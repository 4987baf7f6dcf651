"""A scene of numbers on a mesh or at points, in colours with a bar."""

from typing import TYPE_CHECKING

from warpsample.plotting.actors import label_bar
from warpsample.plotting.scenes import BAR, add_title, columns_over_caption, look_from

if TYPE_CHECKING:
    import pyvista

_COLOURS = "viridis"
_POINT = 5  # pixels
_ZOOM = 1.3


def number_scene(
    numbers: "pyvista.PolyData", name: str, *, title: str, caption: str, high: float, up: str, size: tuple[int, int]
) -> "pyvista.Plotter":
    """A plotter with the array of that name in colours from 0 to `high`; `up` is the axis "x", "y" or "z" that points up."""
    plotter = columns_over_caption(1, caption, True, size)
    plotter.subplot(0, 0)
    bar = {**BAR, "title": title}
    plotter.add_mesh(
        numbers, scalars=name, cmap=_COLOURS, clim=(0.0, high), lighting=False, point_size=_POINT, scalar_bar_args=bar
    )
    label_bar(plotter.scalar_bars[title], high)
    add_title(plotter, title)
    look_from(plotter, up, _ZOOM)
    return plotter
