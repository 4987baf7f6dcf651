"""What `warpsample view` calls: from the command line's words to a window or a file."""

from pathlib import Path

import warp as wp

from warpsample import sequences
from warpsample.distributions import as_spatial
from warpsample.distributions.cosine_hemisphere import CosineHemisphere
from warpsample.distributions.offset_sphere import OffsetSphere
from warpsample.distributions.record import Distribution
from warpsample.host.arguments import check_integer, check_seed
from warpsample.mesh.mesh import Mesh
from warpsample.plotting.rendering import save_scene
from warpsample.plotting.scenes import clouds_on_mesh
from warpsample.texture.shown import ShownOcclusion
from warpsample.viewer.choice import Choice
from warpsample.viewer.lobes import lobe_of
from warpsample.viewer.window import Viewer

LEAST_SIZE = (1200, 675)
"""The smallest window, in pixels, in which knobs and charts can be read."""


def bunny() -> Path:
    """The path of the mesh that comes with warp-lang."""
    return Path(wp.__file__).parent / "examples" / "assets" / "bunny.usd"


def choice(distribution: str | None, density: str | None, sequence: str, samples: int, seed: int) -> Choice:
    """A choice from the command line's words; by default Shirley's trick, compared with the cosine lobe.

    A distribution that is named is compared with its own density, unless another one is. Unknown names and values out of
    range are a ValueError, values of a wrong type a TypeError.
    """
    sequences.get(sequence)
    check_integer(samples, "--samples", 1, 2**31 - 1)
    check_seed(seed)
    if distribution is None:
        claimed = CosineHemisphere() if density is None else _density(density)
        return Choice(OffsetSphere(), claimed, sequence, samples, seed)
    return Choice(as_spatial(distribution), None if density is None else _density(density), sequence, samples, seed)


def _density(name: str) -> Distribution:
    try:
        return as_spatial(name)
    except (TypeError, ValueError) as error:
        raise type(error)(str(error).replace("distribution:", "density:", 1)) from None


def window(
    mesh: Mesh, points: int, chosen: Choice, *, up: str, size: tuple[int, int], occlusion: ShownOcclusion | None
) -> None:
    """Opens the viewer, and returns when it is closed."""
    Viewer(mesh, points, chosen, up=up, size=size, occlusion=occlusion).plotter.show(title="warpsample")


def save(
    mesh: Mesh,
    points: int,
    chosen: Choice,
    *,
    up: str,
    size: tuple[int, int],
    path: Path,
    occlusion: ShownOcclusion | None = None,
) -> str:
    """Writes a .png of the viewer, or an .html of its clouds on the mesh; gives a line about what the picture shows."""
    viewer = Viewer(mesh, points, chosen, up=up, size=size, off_screen=True, occlusion=occlusion)
    if path.suffix == ".png":
        viewer.plotter.enable_anti_aliasing("msaa", multi_samples=8, all_renderers=True)
        save_scene(viewer.plotter, path, viewer.summary())
    else:
        at, clouds = viewer.points, viewer.clouds
        viewer.plotter.close()
        seen = (clouds.position, clouds.pdf, lobe_of(chosen.claim).peak)
        scene = clouds_on_mesh(
            viewer.vertices, mesh.faces, at.position, at.normal, scale=viewer.scale, clouds=seen, up=up, size=size
        )
        save_scene(scene, path, viewer.summary())
    return viewer.summary()
