"""PyVista scenes of meshes with normals and clouds of directions."""

from typing import TYPE_CHECKING, Any

import numpy as np

from warpsample.mesh.polydata import surface
from warpsample.plotting.actors import CloudActor, Sheet
from warpsample.plotting.rendering import AXES, MOST_NORMALS, MOST_SMOOTH_FACES, VIEW, pixels_of
from warpsample.plotting.style import BARS, INK, SURFACE

if TYPE_CHECKING:
    import pyvista
    from matplotlib.figure import Figure


def draw_mesh(
    plotter: "pyvista.Plotter", vertices: np.ndarray, faces: np.ndarray, texture: tuple[np.ndarray, np.ndarray] | None = None
) -> Any:
    """Draw a mesh into the plotter's current renderer, and return the actor.

    Meshes of at most MOST_SMOOTH_FACES faces are shaded smoothly.

    Args:
        plotter: plotter to draw into.
        vertices: (V, 3) positions.
        faces: (F, 3) rows of `vertices`.
        texture: picture, (H, W) or (H, W, 3) uint8, and coordinates of the corners of faces, (F, 3, 2) with v down. A mesh
            with a texture is drawn without shading.
    """
    if texture is not None:
        return _draw_textured(plotter, vertices[faces], *texture)
    smooth = len(faces) <= MOST_SMOOTH_FACES
    return plotter.add_mesh(surface(vertices, faces), color=SURFACE, smooth_shading=smooth, split_sharp_edges=smooth)


def _draw_textured(plotter: "pyvista.Plotter", corners: np.ndarray, picture: np.ndarray, uv: np.ndarray) -> Any:
    """Draw faces, given by their corners, (F, 3, 3), with a texture, and return the actor."""
    import pyvista as pv

    mesh = surface(corners.reshape(-1, 3), np.arange(3 * len(corners)).reshape(-1, 3))
    mesh.active_texture_coordinates = (uv.reshape(-1, 2) * (1.0, -1.0) + (0.0, 1.0)).astype(np.float32)
    colours = np.repeat(picture[..., None], 3, axis=2) if picture.ndim == 2 else picture
    shown = pv.Texture(np.ascontiguousarray(colours))
    shown.interpolate = True
    return plotter.add_mesh(mesh, texture=shown, lighting=False)


def draw_normals(plotter: "pyvista.Plotter", position: np.ndarray, normal: np.ndarray, scale: float) -> None:
    """Draw points, (P, 3), and unit normals as lines of length `scale` in world units; at most the first MOST_NORMALS."""
    import pyvista as pv

    position, normal = position[:MOST_NORMALS], normal[:MOST_NORMALS]
    ends = np.stack([position, position + scale * normal], axis=1).reshape(-1, 3)
    segments = pv.PolyData(ends, lines=np.insert(np.arange(len(ends)).reshape(-1, 2), 0, 2, axis=1).ravel())
    plotter.add_mesh(segments, color="black", line_width=2, pickable=False)
    plotter.add_mesh(pv.PolyData(position), color="black", point_size=5, render_points_as_spheres=True, pickable=False)


def draw_frame(plotter: "pyvista.Plotter") -> None:
    """Draw the tangent plane as a unit disk, and the frame t, b, n at the origin, seen from above."""
    import pyvista as pv

    plotter.add_mesh(pv.Disc(inner=0.0, outer=1.0, c_res=72), color=SURFACE, opacity=0.5, lighting=False, pickable=False)
    for axis, colour in (("x", BARS), ("y", BARS), ("z", "black")):
        line = pv.Line((0, 0, 0), 1.15 * np.array(AXES[axis]))
        plotter.add_mesh(line, color=colour, line_width=3, pickable=False)
    tips = 1.25 * np.eye(3)
    style = {"font_size": 20, "text_color": INK, "shape": None, "show_points": False, "always_visible": True}
    plotter.add_point_labels(tips, ["t", "b", "n"], **style)
    plotter.camera_position = [(2.2, -3.2, 1.78), (0.0, 0.0, 0.42), (0.0, 0.0, 1.0)]
    plotter.enable_parallel_projection()
    plotter.camera.parallel_scale = 1.2


def look_from(plotter: "pyvista.Plotter", up: str, zoom: float = 1.2) -> None:
    """Turn the camera of the current renderer so that the axis "x", "y" or "z" points up, and enlarge by `zoom`."""
    plotter.view_vector(VIEW[up], viewup=AXES[up])
    plotter.camera.zoom(zoom)


def clouds_on_mesh(
    vertices: np.ndarray,
    faces: np.ndarray,
    position: np.ndarray,
    normal: np.ndarray,
    *,
    scale: float,
    clouds: tuple[np.ndarray, np.ndarray, float],
    up: str,
    size: tuple[int, int],
    off_screen: bool = True,
) -> "pyvista.Plotter":
    """Build a plotter that shows a mesh, points with normals, and clouds of directions.

    Args:
        vertices: (V, 3) positions.
        faces: (F, 3) rows of `vertices`.
        position: (P, 3) points.
        normal: (P, 3) unit normals.
        scale: length of a drawn normal in world units.
        clouds: positions of the directions, (N, 3), densities per steradian, (N,), and the density with the last colour.
        up: name of the axis that points up: "x", "y" or "z".
        size: width and height of the picture in pixels.
        off_screen: whether no window is opened.
    """
    import pyvista as pv

    plotter = pv.Plotter(off_screen=off_screen, window_size=size)
    plotter.set_background("white")
    draw_mesh(plotter, vertices, faces)
    draw_normals(plotter, position, normal, scale)
    CloudActor(plotter, point_size=2, bar=True).show(*clouds)
    look_from(plotter, up)
    return plotter


def figure_in_window(figure: "Figure") -> "pyvista.Plotter":
    """Build a plotter that shows a matplotlib figure in a window of the same size; matplotlib opens no window."""
    import pyvista as pv

    pixels = pixels_of(figure)
    plotter = pv.Plotter(window_size=(pixels.shape[1], pixels.shape[0]))
    Sheet(plotter).show(pixels)
    return plotter
