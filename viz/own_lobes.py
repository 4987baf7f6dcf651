"""A surface whose roughness and brush lines vary: each point reflects the camera in a lobe of its own."""

from pathlib import Path
from typing import Annotated

import numpy as np
import typer

import warpsample as ws
from warpsample.cli.terminal import Size, fail_plainly, show_or_save
from warpsample.host.arguments import check_integer, check_seed
from warpsample.plotting import rendering
from warpsample.plotting.panels import Panel
from warpsample.plotting.reflection_scene import EnlargedLobe, brush_lines, reflection_scene
from warpsample.viewer.counts import count_directions
from warpsample.viewer.lobes import probabilities_of, shape_of
from warpsample.viewer.own_lobes import constant_lobes
from warpsample.viewer.start import bunny

ROUGH, BRUSHED = (0.08, 0.35), (1.0, 8.0)
"""Ranges of the mean roughness, from bottom to top, and of the ratio of the two roughnesses, from left to right."""
LENGTH = 0.11  # of a lobe on the mesh, as a share of its diagonal
COUNTED = 200_000  # directions of the map
LINES = 2500


def roughness(position: np.ndarray, bounds: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the mean roughness, and the ratio of the roughnesses across and along the brush lines, at positions (N, 3)."""
    share = np.clip((position - bounds[0]) / (bounds[1] - bounds[0]), 0.0, 1.0)
    return tuple(low * np.float_power(high / low, share[:, axis]) for axis, (low, high) in ((1, ROUGH), (0, BRUSHED)))


def brushed(mesh: ws.Mesh, count: int, seed: int) -> ws.SurfacePoints:
    """Place points on a mesh, evenly, with tangents along the brush lines, which run around the vertical axis y."""
    points = ws.sample_surface(mesh, count, spacing="blue", seed=seed)
    return points.with_tangents(np.cross(points.position - mesh.bounds.mean(axis=0), [0.0, 1.0, 0.0]))


def reflections(points: ws.SurfacePoints, bounds: np.ndarray, camera: np.ndarray) -> ws.Reflection:
    """Return the lobes of light that points reflect towards a distant camera in the direction `camera`, (3,)."""
    mean, ratio = roughness(points.position, bounds)
    view = points.to_local(camera)
    normals = ws.VisibleGGX(alpha=mean / np.sqrt(ratio), alpha_y=mean * np.sqrt(ratio), view=view)
    return ws.Reflection(normals, view=view)


def enlarge(point: ws.SurfacePoints, lobe: ws.Reflection, samples: int, seed: int) -> EnlargedLobe:
    """Sample the lobe of one point: some directions to draw, and COUNTED directions for the map."""
    constant = constant_lobes(lobe)[0]
    d = ws.sample_directions(point, COUNTED, distribution=lobe, sequence="independent", seed=seed, pdf=True)
    local, shape = point.to_local(d.vectors)[0], shape_of(constant)
    share = np.minimum(d.pdf[0] / shape.peak, 1.0)
    cells = count_directions(local, probabilities_of(constant), independent=True, claim="the density").cells
    shown = slice(4 * samples)
    return EnlargedLobe(share[shown, None] * local[shown], share[shown], shape.surface, np.array(constant.view), cells)


@fail_plainly()
def main(
    points: Annotated[int, typer.Option(help="Number of points on both sides of the mesh.")] = 150,
    samples: Annotated[int, typer.Option(help="Number of directions per point.")] = 400,
    seed: Annotated[int, typer.Option(help="Seed of the points and directions.")] = 0,
    screenshot: Annotated[
        Path | None, typer.Option(help="Save to this file, .png or .html, in place of a window.", show_default=False)
    ] = None,
    size: Size = (1800, 680),
) -> None:
    """Show the reflected lobes of a surface with varying roughness, and one lobe enlarged with its map."""
    rendering.check_output(screenshot, rendering.SCENE_SUFFIXES)
    rendering.check_size(size, (900, 340))
    check_integer(points, "--points", 10, 1000)
    check_integer(samples, "--samples", 16, 10_000)
    check_seed(seed)
    rendering.check_rendering()
    mesh, camera = ws.load_mesh(bunny()), np.array(rendering.VIEW["y"])
    at = brushed(mesh, points, seed)
    lobes = reflections(at, mesh.bounds, camera)
    d = ws.sample_directions(at, samples, distribution=lobes, seed=seed, pdf=True)
    facing = np.flatnonzero(d.status == ws.Status.OK)  # a view from below the surface gives no directions
    share = d.pdf[facing] / d.pdf[facing].max(axis=1, keepdims=True)
    scale = LENGTH * mesh.diagonal
    clouds = at.position[facing, None] + scale * share[..., None] * d.vectors[facing]
    chosen = choose(at, facing, mesh.bounds, camera)
    lobe = enlarge(at.take([chosen]), lobes.take([chosen]), samples, seed)
    lines = brushed(mesh, LINES, seed)
    mean = roughness(mesh.vertices, mesh.bounds)[0]
    ratio, tangent = roughness(lines.position, mesh.bounds)[1], lines.to_world([1.0, 0.0, 0.0])
    summary = (
        f"{len(facing)} of {points} points face the camera, {samples:,} directions each; lines: brushed surface; "
        f"map: {COUNTED:,} directions; seed {seed}"
    )
    foot = at.position[chosen]
    plotter = reflection_scene(
        (mesh.vertices, mesh.faces),
        Panel(mean, "Lobes that reflect the camera", "Oranges", ROUGH[1], "roughness, mean along and across the lines"),
        clouds=(clouds.reshape(-1, 3).astype(np.float32), share.ravel()),
        lines=brush_lines(lines.position, tangent, 0.012 * mesh.diagonal * np.log2(ratio)),
        pin=(foot, foot + 1.3 * scale * at.normal[chosen]),
        lobe=lobe,
        caption=summary,
        up="y",
        off_screen=screenshot is not None,
        size=size,
    )
    show_or_save(plotter, screenshot, summary)


def choose(points: ws.SurfacePoints, rows: np.ndarray, bounds: np.ndarray, camera: np.ndarray) -> int:
    """Return the row of a point in the middle of the right half that is seen at about 50 degrees from its normal."""
    cosine = points.normal[rows] @ (camera / np.linalg.norm(camera))
    share = (points.position[rows] - bounds[0]) / (bounds[1] - bounds[0])
    return int(rows[np.argmin(np.abs(cosine - 0.64) + np.abs(share[:, :2] - [0.75, 0.5]).sum(axis=1))])


if __name__ == "__main__":
    typer.run(main)
