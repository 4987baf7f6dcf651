"""Start of `warpsample view`: conversion of the command's options to settings, and the window or the picture."""

from pathlib import Path

import warp as wp

from warpsample import sequences
from warpsample.distributions import as_spatial
from warpsample.distributions.offset_sphere import OffsetSphere
from warpsample.distributions.record import Distribution
from warpsample.host.arguments import check_integer, check_seed
from warpsample.mesh.mesh import Mesh
from warpsample.plotting.rendering import save_scene
from warpsample.plotting.scenes import clouds_on_mesh
from warpsample.texture.occlusion_picture import OcclusionPicture
from warpsample.viewer.choice import Choice, default_density
from warpsample.viewer.lobes import lobe_of
from warpsample.viewer.window import Viewer

LEAST_SIZE = (1200, 675)
"""Smallest width and height of the window in pixels for legible knobs and charts."""


def bunny() -> Path:
    """Return the path of the mesh of the Stanford bunny, which the package warp-lang contains."""
    return Path(wp.__file__).parent / "examples" / "assets" / "bunny.usd"


def choice(distribution: str | None, density: str | None, sequence: str, samples: int, seed: int) -> Choice:
    """Check the options of `warpsample view`, and return the settings of the viewer.

    Args:
        distribution: name of the distribution, with parameters. Default: points on the sphere plus the normal, normalised.
        density: name of the distribution to compare with. Default: the cosine lobe for offset spheres and offset balls, the
            distribution itself for others.
        sequence: name of the point sequence.
        samples: number of directions at each point.
        seed: seed of the directions.

    Raises:
        TypeError, ValueError: a name is unknown, or a value has a wrong type or is out of range.
    """
    sequences.get(sequence)
    check_integer(samples, "--samples", 1, 2**31 - 1)
    check_seed(seed)
    sampled = OffsetSphere() if distribution is None else as_spatial(distribution)
    compared = default_density(sampled) if density is None else _parse_density(density)
    return Choice(sampled, None if compared == sampled else compared, sequence, samples, seed)


def _parse_density(name: str) -> Distribution:
    """Parse the value of the option --density as a distribution; an error names this option."""
    try:
        return as_spatial(name)
    except (TypeError, ValueError) as error:
        raise type(error)(str(error).replace("distribution:", "density:", 1)) from None


def window(
    mesh: Mesh, points: int, chosen: Choice, *, up: str, size: tuple[int, int], occlusion: OcclusionPicture | None
) -> None:
    """Open the window of the viewer, and return when a user closes the window."""
    Viewer(mesh, points, chosen, up=up, size=size, occlusion=occlusion).plotter.show(title="warpsample")


def save(
    mesh: Mesh,
    points: int,
    chosen: Choice,
    *,
    up: str,
    size: tuple[int, int],
    path: Path,
    occlusion: OcclusionPicture | None = None,
) -> str:
    """Save a picture of the viewer as .png, or its 3D scene as .html, without a window; return a line of description."""
    viewer = Viewer(mesh, points, chosen, up=up, size=size, off_screen=True, occlusion=occlusion)
    if path.suffix == ".png":
        viewer.plotter.enable_anti_aliasing("msaa", multi_samples=8, all_renderers=True)
        save_scene(viewer.plotter, path, viewer.summary())
    else:
        at, clouds = viewer.points, viewer.clouds
        viewer.plotter.close()
        colored = (clouds.position, clouds.pdf, lobe_of(chosen.claim).peak)
        scene = clouds_on_mesh(
            viewer.vertices, mesh.faces, at.position, at.normal, scale=viewer.scale, clouds=colored, up=up, size=size
        )
        save_scene(scene, path, viewer.summary())
    return viewer.summary()
