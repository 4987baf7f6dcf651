"""Start of `warpsample view`: conversion of the command's options to settings, and the window or the picture."""

import re
from pathlib import Path

import numpy as np
import warp as wp

from warpsample import sequences
from warpsample.distributions import Arrays, as_spatial
from warpsample.distributions.offset_sphere import OffsetSphere
from warpsample.distributions.record import Distribution
from warpsample.host.arguments import check_integer, check_seed
from warpsample.mesh.mesh import Mesh
from warpsample.plotting.rendering import save_scene
from warpsample.plotting.scenes import clouds_on_mesh
from warpsample.texture.occlusion_picture import OcclusionPicture
from warpsample.viewer.choice import Choice, default_density
from warpsample.viewer.window import Viewer

LEAST_SIZE = (1200, 675)
"""Smallest width and height of the window in pixels for legible knobs and charts."""

_CAMERA = "camera"
"""Name of the array that stands for the direction to the camera, in `view=@camera`."""
_ABOVE = np.array([0.0, 0.0, 1.0])  # until the camera is known


def bunny() -> Path:
    """Return the path of the mesh of the Stanford bunny, which the package warp-lang contains."""
    return Path(wp.__file__).parent / "examples" / "assets" / "bunny.usd"


def choice(
    distribution: str | None, density: str | None, sequence: str, samples: int, seed: int, *, arrays: Arrays | None = None
) -> Choice:
    """Check the options of `warpsample view`, and return the settings of the viewer.

    Args:
        distribution: name of the distribution, with parameters. Default: points on the sphere plus the normal, normalised.
            Without a `view`, and with `view=@camera`, the camera is the viewer of lobes that depend on a view.
        density: name of the distribution to compare with. Default: the cosine lobe for offset spheres and offset balls, the
            distribution itself for others.
        sequence: name of the point sequence.
        samples: number of directions at each point.
        seed: seed of the directions.
        arrays: function that returns the array of a name such as "@roughness", with a row for each vertex or face.

    Raises:
        TypeError, ValueError: a name is unknown, a value has a wrong type or is out of range, or the directions do not
            depend on the normal.
    """
    sequences.get(sequence)
    check_integer(samples, "--samples", 1, 2**31 - 1)
    check_seed(seed)
    known = None if arrays is None else lambda name: _ABOVE if name == _CAMERA else arrays(name)
    sampled = OffsetSphere() if distribution is None else as_spatial(distribution, known)
    compared = default_density(sampled) if density is None else _parse_density(density, known)
    for argument, each in (("distribution", sampled), ("density", compared)):
        if each is not None and each.in_world:
            raise ValueError(f"{argument}: got {each!r}, which ignores the normals, want a distribution about the normal")
    camera = not any(re.search(rf"\bview\s*=(?!\s*@{_CAMERA}\b)", text or "") for text in (distribution, density))
    return Choice(sampled, None if compared == sampled else compared, sequence, samples, seed, camera)


def _parse_density(name: str, arrays: Arrays | None) -> Distribution:
    """Parse the value of the option --density as a distribution; an error names this option."""
    try:
        return as_spatial(name, arrays)
    except (TypeError, ValueError) as error:
        raise type(error)(str(error).replace("distribution:", "density:", 1)) from None


def window(
    mesh: Mesh,
    points: int,
    chosen: Choice,
    *,
    up: str,
    size: tuple[int, int],
    occlusion: OcclusionPicture | None,
    uv: np.ndarray | None = None,
) -> None:
    """Open the window of the viewer, and return when a user closes the window."""
    Viewer(mesh, points, chosen, up=up, size=size, occlusion=occlusion, uv=uv).plotter.show(title="warpsample")


def save(
    mesh: Mesh,
    points: int,
    chosen: Choice,
    *,
    up: str,
    size: tuple[int, int],
    path: Path,
    occlusion: OcclusionPicture | None = None,
    uv: np.ndarray | None = None,
) -> str:
    """Save a picture of the viewer as .png, or its 3D scene as .html, without a window; return a line of description."""
    viewer = Viewer(mesh, points, chosen, up=up, size=size, off_screen=True, occlusion=occlusion, uv=uv)
    if path.suffix == ".png":
        viewer.plotter.enable_anti_aliasing("msaa", multi_samples=8, all_renderers=True)
        save_scene(viewer.plotter, path, viewer.summary())
    else:
        at, clouds = viewer.points, viewer.clouds
        viewer.plotter.close()
        colored = (clouds.position, clouds.color, clouds.peak)
        scene = clouds_on_mesh(
            viewer.vertices, mesh.faces, at.position, at.normal, scale=viewer.scale, clouds=colored, up=up, size=size
        )
        save_scene(scene, path, viewer.summary())
    return viewer.summary()
