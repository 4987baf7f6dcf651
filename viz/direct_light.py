"""User-defined kernel: light of a lamp on a floor, with directions of the cosine lobe and with directions to the lamp."""

from typing import Annotated, Any

import numpy as np
import typer
import warp as wp

import warpsample as ws
from warpsample import funcs
from warpsample.cli.terminal import FigureFile, Size, fail_plainly, show_or_save
from warpsample.host.arguments import check_integer, check_seed
from warpsample.host.kernel_cache import start
from warpsample.plotting import rendering
from warpsample.plotting.light_sheet import irradiance_sheet
from warpsample.viewer.start import bunny

LAMP, RADIUS = (
    wp.constant(wp.vec3(-1.2, 0.7, 1.8)),
    wp.constant(0.25),
)  # ball with a radiance of 1 W/(m² sr); unit: the height of the bunny
SIDE = 192  # points along a side of the floor
EXTENT = (-1.2, 1.8, -1.8, 1.2)  # left, right, bottom and top of the floor, in heights of the bunny
BRIGHTEST = 0.06  # W/m²: the irradiance right below the lamp


@wp.kernel(enable_backward=False)
def lamp_light(
    points: wp.array[wp.vec3], tree: funcs.Tree, to_lamp: bool, count: int, seed: wp.uint64, out: wp.array[wp.vec2]
):
    """Estimate the irradiance of points with normal +z, and its standard error: the mean of cosine / density over rays.

    A ray counts if it reaches the lamp and hits no face before.
    """
    p = wp.tid()
    away = LAMP - points[p]
    distance = wp.length(away)
    frame = funcs.frame_about(away / distance)
    sin_squared = RADIUS * RADIUS / (distance * distance)  # of half the angle of the lamp
    one_minus_cos = sin_squared / (1.0 + wp.sqrt(1.0 - sin_squared))
    mean, squares = wp.float32(0.0), wp.float32(0.0)
    for j in range(count):
        u = funcs.independent(seed, wp.uint64(p), wp.uint32(j), wp.uint32(count))
        w = funcs.square_to_cosine_hemisphere(u)
        density = funcs.square_to_cosine_hemisphere_pdf(w)
        lit = wp.length_sq(wp.cross(w, away)) < RADIUS * RADIUS and wp.dot(w, away) > 0.0
        if to_lamp:
            local = funcs.square_to_uniform_cone(u, one_minus_cos)
            w = funcs.to_world(frame, local)
            density = funcs.square_to_uniform_cone_pdf(local, one_minus_cos)
            lit = True
        value = wp.float32(0.0)
        if lit and not funcs.any_hit(tree, points[p], w, distance):
            value = w[2] / density
        change = value - mean
        mean += change / float(j + 1)
        squares += change * (value - mean)
    out[p] = wp.vec2(mean, wp.sqrt(squares / (float(count) * float(count - 1))))


def estimate(tree: Any, points: np.ndarray, to_lamp: bool, count: int, seed: int) -> np.ndarray:
    """Estimate the irradiance at points of the floor, (P, 3); return irradiance and standard error as (P, 2)."""
    inputs = [wp.array(points, dtype=wp.vec3, device="cpu"), tree, to_lamp, count, wp.uint64(seed)]
    out = wp.empty(len(points), dtype=wp.vec2, device="cpu")
    wp.launch(lamp_light, dim=len(points), inputs=inputs, outputs=[out], device="cpu")
    return out.numpy()


def scene(side: int) -> tuple[Any, np.ndarray]:
    """Build the search tree of the Stanford bunny, and points of the floor on which it stands, (side^2, 3).

    The bunny has height 1, and the floor is at z = 0.

    The points are in rows from +y to -y.
    """
    mesh = ws.load_mesh(bunny())
    vertices = mesh.vertices[:, [0, 2, 1]] * [1.0, -1.0, 1.0]  # its y points up
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    vertices = (vertices - [*(low + high)[:2] / 2.0, low[2]]) / (high[2] - low[2])
    x, y = np.meshgrid(np.linspace(*EXTENT[:2], side), np.linspace(EXTENT[3], EXTENT[2], side))
    return ws.tree((vertices, mesh.faces)), np.stack([x.ravel(), y.ravel(), np.zeros(x.size)], axis=1)


@fail_plainly()
def main(
    samples: Annotated[int, typer.Option(help="Number of rays per point and method.")] = 256,
    seed: Annotated[int, typer.Option(help="Seed of the rays.")] = 0,
    screenshot: FigureFile = None,
    size: Size = (1600, 680),
) -> None:
    """Show the light of a lamp and the bunny's shadow on a floor, by rays of the cosine lobe and by rays to the lamp."""
    rendering.check_output(screenshot, rendering.FIGURE_SUFFIXES)
    rendering.check_size(size, (600, 300))
    check_integer(samples, "--samples", 2, 100_000)
    check_seed(seed)
    rendering.check_rendering()
    start()
    wp.config.log_level = wp.LOG_WARNING  # no line for each kernel
    (tree, points), pictures = scene(SIDE), {}
    for name, to_lamp in (("Rays of the cosine lobe", False), ("Rays to the lamp", True)):
        light, error = estimate(tree, points, to_lamp, samples, seed).astype(np.float64).T
        rms = np.sqrt(np.mean(np.square(error)))
        pictures[f"{name}: RMS standard error {rms:.2g} W/m²"] = light.reshape(SIDE, SIDE)
    summary = f"{samples:,} rays per point; seed {seed}"
    labels = "x, heights of the bunny", "y, heights of the bunny", "irradiance of the floor, W/m²"
    lamp = "lamp of 1 W/(m² sr) at the upper left; the bunny on the floor is not drawn, its shadow is black"
    figure = irradiance_sheet(pictures, EXTENT, labels, BRIGHTEST, f"{lamp}; {summary}")
    rendering.size_figure(figure, size)
    show_or_save(figure, screenshot, f"{summary}; {'; '.join(pictures)}")


if __name__ == "__main__":
    typer.run(main)
