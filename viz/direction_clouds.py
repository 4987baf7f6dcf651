"""Direction clouds on a mesh, beside the histogram of the projected sphere against the cosine lobe.

Around each chosen point p the directions w are drawn at p + s cos(theta) w. For the cosine lobe that is a uniform sphere
of diameter s resting on the surface: a wrong density shows at once.
"""

from pathlib import Path
from typing import Annotated, Literal

import numpy as np
import typer
import warp as wp

import warpsample as ws
from warpsample import plotting
from warpsample.cli import DISTRIBUTION_HELP, fail_plainly
from warpsample.distributions import as_distribution
from warpsample.proof.histogram import cosine_lobe_angles

BUNNY = Path(wp.__file__).parent / "examples" / "assets" / "bunny.usd"
HISTOGRAM_DRAWS = 1_000_000
CELLS = 90


def cloud_positions(points: ws.SurfacePoints, vectors: np.ndarray, scale: float) -> np.ndarray:
    """(P * n, 3): p + scale * cos(theta) * w of all directions w, vectors (P, n, 3)."""
    w = vectors.astype(np.float64)
    cosine = np.einsum("psk,pk->ps", w, points.normal.astype(np.float64))
    return (points.position[:, None] + scale * cosine[..., None] * w).reshape(-1, 3)


def projected_sphere_angles(normal: np.ndarray, draws: int, seed: int) -> np.ndarray:
    """Radians between the normals and independent directions of sphere + normal, projected: about `draws` of them."""
    count = -(-draws // len(normal))
    w = ws.sample_directions(normal, count, ws.CosineHemisphere("offset"), "independent", seed).vectors.astype(np.float64)
    n = normal[:, None].astype(np.float64)
    return np.arctan2(np.linalg.norm(np.cross(w, n), axis=-1), (w * n).sum(axis=-1)).ravel()


def main(
    mesh: Annotated[Path, typer.Argument(help="Mesh file; by default the bunny inside warp-lang.")] = BUNNY,
    points: Annotated[int, typer.Option(help="How many surface points, uniform by area.")] = 150,
    samples: Annotated[int, typer.Option(help="Directions at each point.")] = 1024,
    distribution: Annotated[str, typer.Option(help=DISTRIBUTION_HELP)] = "cosine_hemisphere",
    sequence: Annotated[str, typer.Option(help=f"One of: {', '.join(ws.sequences.names())}.")] = "sobol",
    seed: Annotated[int, typer.Option(help="Seed of everything random.")] = 0,
    up: Annotated[Literal["x", "y", "z"], typer.Option(help="The mesh's axis that points up in the picture.")] = "y",
    screenshot: Annotated[Path | None, typer.Option(help="Save a PNG here instead of opening a window.")] = None,
    size: Annotated[tuple[int, int], typer.Option(help="Width and height in pixels.")] = (1600, 800),
) -> None:
    """Draw direction clouds on a mesh, beside the histogram of the projected sphere against the cosine lobe."""
    plotting.check_output(screenshot)
    if size[0] < 600 or size[1] < 300:
        raise ValueError(f"--size: got {size[0]} x {size[1]}, want at least 600 x 300, in which the histogram can be read")
    chosen = as_distribution(distribution)
    plotting.check_rendering()
    surface = ws.load_mesh(mesh)
    # Only what is drawn is sampled: the first part of a lattice would be a cap of the cloud and not a thinner cloud.
    shown_points, shown = plotting.budgeted(points, samples)
    at = ws.sample_surface(surface, shown_points, seed)
    drawn = ws.sample_directions(at, shown, chosen, sequence, seed, pdf=True)
    scale = 0.06 * float(np.linalg.norm(surface.vertices.max(axis=0) - surface.vertices.min(axis=0)))
    edges, test = cosine_lobe_angles(projected_sphere_angles(at.normal, HISTOGRAM_DRAWS, seed), CELLS)
    clouds = plotting.Clouds(cloud_positions(at, drawn.vectors, scale), drawn.pdf.ravel(), "pdf [1/sr]")
    what = f"{shown_points:,} points x {shown:,} directions"
    if (shown_points, shown) != (points, samples):
        what += f" (of {points:,} x {samples:,} asked for)"
    title = f"{distribution}, {sequence}: {what}, drawn at p + s cos(theta) w"
    caption = f"{int(test.observed.sum()):,} independent directions about {shown_points:,} normals, seed {seed}"
    plotter = plotting.clouds_beside_histogram(
        plotting.lobe_histogram(edges, test, caption),
        title,
        up,
        off_screen=screenshot is not None,
        size=size,
        vertices=surface.vertices,
        faces=surface.faces,
        position=at.position,
        normal=at.normal,
        scale=scale,
        clouds=clouds,
    )
    plotting.show_or_save(plotter, screenshot, f"{what}; χ² {test.chi_square:.1f}, p = {test.p_value:.3f}")


if __name__ == "__main__":
    wp.config.log_level = wp.LOG_WARNING
    with fail_plainly():
        typer.run(main)
