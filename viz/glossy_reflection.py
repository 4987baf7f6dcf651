"""User-defined kernel: an environment map is filtered for rough surfaces with the facets of the GGX lobe."""

from typing import Annotated

import numpy as np
import typer
import warp as wp

from warpsample import funcs
from warpsample.cli.terminal import FigureFile, Size, fail_plainly, show_or_save
from warpsample.host.arguments import check_integer
from warpsample.host.kernel_cache import start
from warpsample.plotting import rendering
from warpsample.plotting.light_sheet import light_sheet

ALPHAS = (0.02, 0.1, 0.3, 1.0)
LAMPS = np.array([[-0.5, -0.75, 0.43, 14.0, 11.0, 7.0], [0.6, -0.7, 0.38, 5.0, 0.5, 0.3], [-0.93, 0.1, 0.35, 0.4, 4.0, 0.9]])


@wp.func
def radiance(picture: wp.array2d[wp.vec3], w: wp.vec3) -> wp.vec3:
    """Look up the pixel of an equirectangular picture in the direction w: row 0 is at +z, columns go from x towards y."""
    row = int(wp.acos(wp.clamp(w[2], -1.0, 1.0)) / wp.pi * float(picture.shape[0]))
    column = int((wp.atan2(w[1], w[0]) / (2.0 * wp.pi) + 1.0) * float(picture.shape[1])) % picture.shape[1]
    return picture[wp.min(row, picture.shape[0] - 1), column]


@wp.kernel(enable_backward=False)
def reflect(picture: wp.array2d[wp.vec3], normals: wp.array[wp.vec3], alpha: float, count: int, out: wp.array[wp.vec3]):
    """Average the light that the facets of a rough surface reflect to an eye in the direction of the normal, z.

    The weight of the light is the cosine of its angle to the normal.

    A facet with normal h reflects the light from 2 (z.h) h - z.
    """
    p = wp.tid()
    frame = funcs.frame_about(normals[p])
    light, weight = wp.vec3(), wp.float32(0.0)
    for j in range(count):
        u = funcs.sobol(wp.uint64(0), wp.uint64(p), wp.uint32(j), wp.uint32(count))
        facet = funcs.square_to_ggx(u, alpha)
        w = 2.0 * facet[2] * facet - wp.vec3(0.0, 0.0, 1.0)
        if w[2] > 0.0:
            light += w[2] * radiance(picture, funcs.to_world(frame, w))
            weight += w[2]
    out[p] = light / weight


def compute_reflection(picture: np.ndarray, normals: np.ndarray, alpha: float, count: int) -> np.ndarray:
    """Compute the radiance, (..., 3), that rough surfaces with unit normals, (..., 3), reflect from an environment map.

    The map is an equirectangular picture, (H, W, 3).
    """
    flat = wp.array(normals.reshape(-1, 3), dtype=wp.vec3, device="cpu")
    inputs = [wp.array(picture, dtype=wp.vec3, device="cpu"), flat, alpha, count]
    out = wp.empty_like(flat)
    wp.launch(reflect, dim=len(flat), inputs=inputs, outputs=[out], device="cpu")
    return out.numpy().reshape(normals.shape)


def map_directions(height: int) -> np.ndarray:
    """Return the unit directions of the pixels of an equirectangular picture, (height, 2 height, 3)."""
    theta, phi = (np.arange(height)[:, None] + 0.5) * np.pi / height, (np.arange(2 * height) + 0.5) * np.pi / height
    return np.stack(np.broadcast_arrays(np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)), axis=-1)


def ball_directions(side: int) -> np.ndarray:
    """Return the directions from which a polished ball reflects light to a distant eye at -y, (side, side, 3).

    Pixels outside the ball have (0, 1, 0).
    """
    x, z = np.meshgrid(np.linspace(-1.0, 1.0, side), np.linspace(1.0, -1.0, side))
    y = -np.sqrt(np.maximum(1.0 - x * x - z * z, 0.0))
    return np.stack([-2.0 * y * x, 1.0 - 2.0 * y * y, -2.0 * y * z], axis=-1)


def environment() -> np.ndarray:
    """Return an environment map, (256, 512, 3) float32: a sky bright at the horizon, a chequered floor and three lamps."""
    w = map_directions(256)
    up, lamp = w[..., 2:], w @ LAMPS[:, :3].T > np.cos(0.2) * np.linalg.norm(LAMPS[:, :3], axis=1)
    dark = np.floor(1.5 * w[..., :2] / np.minimum(up, -1e-3)).sum(axis=-1, keepdims=True) % 2.0
    picture = np.where(up > 0.0, [0.25, 0.5, 1.0] * (0.3 + np.exp(-4.0 * np.abs(up))), [0.4, 0.36, 0.3] * (1.0 - 0.8 * dark))
    return np.where(lamp.any(axis=-1, keepdims=True), lamp @ LAMPS[:, 3:], picture).astype(np.float32)


@fail_plainly()
def main(
    samples: Annotated[int, typer.Option(help="Number of directions per pixel.")] = 1024,
    screenshot: FigureFile = None,
    size: Size = (1600, 680),
) -> None:
    """Show the reflections of an environment for four roughnesses: a map over all normals, and a ball."""
    rendering.check_output(screenshot, rendering.FIGURE_SUFFIXES)
    rendering.check_size(size, (600, 300))
    check_integer(samples, "--samples", 16, 100_000)
    rendering.check_rendering()
    start()
    wp.config.log_level = wp.LOG_WARNING  # no line for each kernel
    picture, columns, ball = environment(), {}, ball_directions(192)
    for alpha in ALPHAS:
        seen = np.where(ball[..., 1:2] < 1.0, compute_reflection(picture, ball, alpha, samples), np.nan)
        columns[f"roughness α = {alpha:g}"] = [compute_reflection(picture, map_directions(64), alpha, samples), seen]
    summary = f"{samples:,} directions for each pixel"
    rows = "map over all\ndirections", "ball with this surface"
    figure = light_sheet(columns, rows, (1.0, 2.0), f"environment as surfaces reflect it, from smooth to rough; {summary}")
    rendering.size_figure(figure, size)
    show_or_save(figure, screenshot, summary)


if __name__ == "__main__":
    typer.run(main)
