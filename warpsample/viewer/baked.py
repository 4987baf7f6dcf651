"""View of a mesh file with an occlusion texture: the mesh without and with the texture, and a summary of the values."""

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from warpsample.mesh.mesh import Mesh
from warpsample.mesh.points.sampling import sample_surface
from warpsample.plotting.panels import add_scale, add_text, add_title, columns_over_caption, fit_view
from warpsample.plotting.rendering import save_scene
from warpsample.plotting.scenes import draw_mesh
from warpsample.plotting.style import OPENNESS
from warpsample.texture.occlusion_picture import OcclusionPicture

if TYPE_CHECKING:
    import pyvista

_POINTS = 20_000  # of the summary: its mean is known to 0.002 or better
_LABEL = "occlusion texture of the file; 0: occluded, 1: open"


def sample_occlusion(mesh: Mesh, occlusion: OcclusionPicture) -> tuple[np.ndarray, int]:
    """Sample the occlusion texture of a mesh at P random points, uniform by area; return (P,) values and a face count.

    The count is the number of faces with texture; the points are on these faces.

    0 is occluded and 1 is open. A face without a picture has the same texture coordinates at all its corners.
    """
    pictured = np.ptp(occlusion.uv, axis=1).max(axis=1) > 0.0
    points = sample_surface(mesh, _POINTS, seed=0, barycentric=True)
    points = points.take(np.flatnonzero(pictured[points.face]))
    at = np.einsum("pk,pkc->pc", points.barycentric, occlusion.uv[points.face])
    height, width = occlusion.picture.shape
    column, row = (np.clip((at * (width, height)).astype(int), 0, (width - 1, height - 1))).T
    return occlusion.picture[row, column] / 255.0, int(pictured.sum())


def describe_occlusion(mesh: Mesh, occlusion: OcclusionPicture) -> str:
    """Describe the occlusion texture of a mesh in one line: the number of faces with texture, and the values by area."""
    values, faces = sample_occlusion(mesh, occlusion)
    count = f"baked occlusion on {faces:,} of {len(mesh.faces):,} faces"
    if not len(values):
        return count
    low, high = np.quantile(values, [0.05, 0.95])
    return f"{count}; mean {values.mean():.2f} by area, 90 % of the area from {low:.2f} to {high:.2f}"


def occlusion_scene(
    mesh: Mesh, occlusion: OcclusionPicture, *, up: str, size: tuple[int, int], off_screen: bool
) -> "pyvista.Plotter":
    """Build a plotter that shows a mesh twice: in one colour, and with its occlusion texture and a colour bar."""
    plotter = columns_over_caption(2, describe_occlusion(mesh, occlusion), off_screen, size)
    vertices = mesh.vertices - mesh.bounds.mean(axis=0)  # float32 is most precise about the origin
    for column, texture in enumerate((None, (occlusion.picture, occlusion.uv))):
        plotter.subplot(0, column)
        draw_mesh(plotter, vertices, mesh.faces, texture)
        add_title(plotter, "Mesh without textures" if texture is None else "Baked occlusion")
        if texture is not None:
            add_scale(plotter, OPENNESS, 1.0)
            add_text(plotter, _LABEL, (0.5, 0.04))
        fit_view(plotter, vertices[mesh.used], up)
    plotter.link_views()
    return plotter


def show_occlusion(
    mesh: Mesh, occlusion: OcclusionPicture, *, up: str, size: tuple[int, int], path: Path | None = None
) -> str:
    """Show the occlusion texture of a mesh in a window, or write a .png or .html file; return a line about the values."""
    plotter = occlusion_scene(mesh, occlusion, up=up, size=size, off_screen=path is not None)
    summary = f"{describe_occlusion(mesh, occlusion)} (0: occluded, 1: open)"
    if path is None:
        plotter.show(title="warpsample")
    else:
        save_scene(plotter, path, summary)
    return summary
