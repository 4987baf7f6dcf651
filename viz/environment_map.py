"""Light of a sky with a small sun on the bunny: rays about the normal, rays by the picture of the sky, and both."""

from typing import Annotated

import numpy as np
import typer

import warpsample as ws
from warpsample.cli.terminal import FigureFile, Size, fail_plainly, show_or_save
from warpsample.host.arguments import check_integer, check_seed
from warpsample.plotting import rendering
from warpsample.plotting.ray_sheet import RayColumn, RayRows, ray_sheet
from warpsample.radiation.sky.picture_light import PictureLight
from warpsample.viewer.start import bunny

SUN = np.array([-0.75, 0.2, 0.63]) / np.linalg.norm([-0.75, 0.2, 0.63])
RADIUS = np.radians(0.5)  # half the angle of the sun's disc
SUN_LIGHT = np.array([30_000.0, 24_000.0, 17_000.0])  # red, green and blue radiance; that of the sky is about 1
HEIGHT = 1024  # rows of the picture of the sky
TO_CAMERA = np.array([0.25, -1.0, 0.55])
VIEW = (-1.05, 1.2, -0.4, 1.17)  # left, right, bottom and top of the shown part of the scene, in heights of the bunny
PIXELS = 168  # along the width of the view
CLOUDS = np.array([[-0.75, 0.1], [-0.42, 0.58], [0.2, 0.4], [0.6, -0.22], [0.9, 0.35]])
"""Positions of the points with drawn rays, to the right and up. The rays of the first point are drawn on the map, too."""
LENGTH = 0.25  # of a drawn ray, in heights of the bunny
ON_MAP, AT_POINT = 256, 64  # drawn rays
REFERENCE, EVERY = 4096, 5  # rays of the reference, computed for one in so many pixels
EXPOSURE = 0.14
UP = (0.0, 0.0, 1.0)


def environment() -> np.ndarray:
    """Return an environment map, (HEIGHT, 2 HEIGHT, 3) float32: a blue sky with clouds and a small sun above dark ground."""
    theta, phi = (np.arange(HEIGHT)[:, None] + 0.5) * np.pi / HEIGHT, (np.arange(2 * HEIGHT) + 0.5) * np.pi / HEIGHT
    w = np.stack(np.broadcast_arrays(np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)), axis=-1)
    up, random = w[..., 2:], np.random.default_rng(7)
    plane = 1.5 * w[..., :2] / (np.abs(up) + 0.25)  # clouds are in a plane, and smaller towards the horizon
    waves = np.zeros(w.shape[:2])
    for octave in range(5):
        for angle, phase in random.uniform(0.0, 2.0 * np.pi, (8, 2)):
            waves += 0.6**octave * np.cos(2.0**octave * (plane @ [np.cos(angle), np.sin(angle)]) + phase)
    cover = np.clip(0.5 * (waves[..., None] - 0.8), 0.0, 1.0)
    blue = np.array([0.16, 0.34, 0.75]) * (0.55 + 0.9 * np.exp(-4.0 * np.abs(up)))
    picture = np.where(up > 0.0, (1.0 - cover) * blue + cover * (1.1 - 0.25 * cover), [0.11, 0.10, 0.08])
    disc = np.clip((RADIUS - angle_to_sun(w)) * HEIGHT / np.pi + 0.5, 0.0, 1.0)[..., None]  # pixels at the edge get a part
    return (picture + disc * SUN_LIGHT).astype(np.float32)


def angle_to_sun(directions: np.ndarray) -> np.ndarray:
    """Return the angles between unit directions, (..., 3), and the centre of the sun, in radians."""
    return 2.0 * np.arcsin(np.clip(0.5 * np.linalg.norm(directions - SUN, axis=-1), 0.0, 1.0))


def scene() -> ws.Mesh:
    """Return the mesh of the Stanford bunny, of height 1 with +z up, on a floor at z = 0 that is larger than the view."""
    mesh = ws.load_mesh(bunny())
    vertices = mesh.vertices[:, [0, 2, 1]] * [1.0, -1.0, 1.0]  # its y points up
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    vertices = (vertices - [*(low + high)[:2] / 2.0, low[2]]) / (high[2] - low[2])
    floor = 9.0 * np.array([[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0]])
    faces = np.concatenate([mesh.faces, len(vertices) + np.array([[0, 1, 2], [0, 2, 3]])])
    return ws.as_mesh((np.concatenate([vertices, floor]), faces))


def camera_axes() -> np.ndarray:
    """Return the unit vectors to the right, up and to the camera, (3, 3)."""
    right = np.cross([0.0, 0.0, 1.0], TO_CAMERA)
    axes = np.stack([right, np.cross(TO_CAMERA, right), TO_CAMERA])
    return axes / np.linalg.norm(axes, axis=1, keepdims=True)


def pixel_positions() -> np.ndarray:
    """Return the positions of the pixels of the view, to the right and up, (rows, PIXELS, 2), from the top row."""
    left, right, bottom, top = VIEW
    rows = round(PIXELS * (top - bottom) / (right - left))
    x, y = (np.arange(PIXELS) + 0.5) / PIXELS, (np.arange(rows) + 0.5) / rows
    return np.stack(np.meshgrid(left + x * (right - left), top - y * (top - bottom)), axis=-1)


def visible_points(mesh: ws.Mesh, positions: np.ndarray) -> ws.SurfacePoints:
    """Return the points of a mesh that a camera with parallel rays sees at positions to the right and up, (P, 2)."""
    axes = camera_axes()
    origins = np.concatenate([positions, np.full((len(positions), 1), 5.0)], axis=1) @ axes
    hits = ws.trace(mesh, origins, np.broadcast_to(-axes[2], origins.shape))
    normal = mesh.face_normals[hits.face]
    normal = np.where((normal @ axes[2] < 0.0)[:, None], -normal, normal)
    return ws.SurfacePoints(origins - hits.distance[:, None].astype(float) * axes[2], normal, hits.face)


def sample_rays(points: ws.SurfacePoints, count: int, share: float, lobe: ws.EnvironmentMap, seed: int) -> list[np.ndarray]:
    """Sample directions from the cosine lobe, and a share of the `count` directions from another lobe.

    Returns:
        the directions from the cosine lobe and those from the other lobe, two arrays (P, rays, 3).
    """
    second = round(share * count)
    lobes = (ws.CosineHemisphere(), count - second), (lobe, second)
    return [
        ws.sample_directions(points, rays, distribution=lobe, seed=seed).vectors if rays else np.zeros((len(points), 0, 3))
        for lobe, rays in lobes
    ]


def project_rays(mesh: ws.Mesh, points: ws.SurfacePoints, directions: np.ndarray) -> np.ndarray:
    """Return the ends of rays of length LENGTH in the view, (rays, 2, 2), without the rays whose far end is hidden."""
    axes, near = camera_axes(), np.broadcast_to(points.position[:, None], directions.shape).reshape(-1, 3)
    far = near + LENGTH * directions.reshape(-1, 3)
    shown = ws.trace(mesh, far, np.broadcast_to(axes[2], far.shape), any_hit=True).face < 0
    return np.stack([near[shown], far[shown]], axis=1) @ axes[:2].T


def count_to_sun(directions: list[np.ndarray]) -> int:
    """Count the unit directions, (N, 3) each, that are in the sun's disc, with the pixels at its edge."""
    return sum(int((angle_to_sun(w) < RADIUS + 0.5 * np.pi / HEIGHT).sum()) for w in directions)


def relative_rmse(light: np.ndarray, reference: np.ndarray) -> float:
    """Return the root mean square error of light at points, divided by the mean of the reference."""
    return float(np.sqrt(np.mean(np.square(light.astype(np.float64) - reference))) / reference.mean())


def make_columns(picture: np.ndarray, samples: int, seed: int) -> tuple[list[RayColumn], np.ndarray, dict[str, float]]:
    """Compute the columns of the figure: rays and irradiance for each way of sampling.

    Returns:
        columns, the grey picture of the scene, and the relative RMSE keyed by the way of sampling.
    """
    mesh, pixels = scene(), pixel_positions()
    seen, few = visible_points(mesh, pixels.reshape(-1, 2)), visible_points(mesh, CLOUDS)
    checked = np.arange(0, len(seen), EVERY)
    reference = ws.irradiance(mesh, seen.take(checked), picture, REFERENCE, seed=seed ^ 1).value  # of other rays
    sky = PictureLight.of(picture, UP)
    share = sky.share
    columns, errors = [], {}
    for name, title, part in (
        ("cosine", "Rays about the normal", 0.0),
        ("picture", "Rays to bright pixels", 1.0),
        ("both", f"Both, {100.0 * share:.0f} % to bright pixels", share),
    ):
        light = ws.irradiance(mesh, seen, picture, samples, sampling=name, seed=seed).value
        errors[name] = relative_rmse(light[checked], reference)
        lobe = sky.lobe(name)
        on_map = [w[0] for w in sample_rays(few.take([0]), ON_MAP, part, lobe, seed)]
        columns.append(
            RayColumn(
                f'{title}\nsampling="{name}"',
                on_map,
                f"{count_to_sun(on_map)} of {ON_MAP} rays go to the sun",
                [project_rays(mesh, few, w) for w in sample_rays(few, AT_POINT, part, lobe, seed)],
                EXPOSURE * light.reshape(*pixels.shape[:2], 3),
                f"relative RMSE {errors[name]:.2g}",
            )
        )
    return columns, 0.12 + 0.55 * (seen.normal @ camera_axes()[2]).reshape(pixels.shape[:2]), errors


@fail_plainly(count="--samples")
def main(
    samples: Annotated[int, typer.Option(help="Number of rays per pixel.")] = 64,
    seed: Annotated[int, typer.Option(help="Seed of the rays.")] = 0,
    screenshot: FigureFile = None,
    size: Size = (1600, 1130),
) -> None:
    """Show the light of a sky with a sun on the bunny, by rays about the normal, by rays from the picture, and by both."""
    rendering.check_output(screenshot, rendering.FIGURE_SUFFIXES)
    rendering.check_size(size, (900, 640))
    check_integer(samples, "--samples", 4, 100_000)
    check_seed(seed)
    rendering.check_rendering()
    picture = environment()
    columns, grey, errors = make_columns(picture, samples, seed)
    names = (
        "rays of the point ▼\non the map of the light",
        f"{AT_POINT} rays at {len(CLOUDS)} points",
        f"irradiance,\n{samples:,} rays per pixel",
    )
    sun = f"sky with a sun of {2.0 * np.degrees(RADIUS):g} degree, enlarged in the corner of the map"
    rmse = f"relative RMSE: root mean square error against {REFERENCE:,} rays, divided by the mean"
    figure = ray_sheet(columns, RayRows(names, picture, SUN, grey, VIEW, CLOUDS[0]), f"{sun}; {rmse}; seed {seed}")
    listed = ", ".join(f"{name} {error:.2g}" for name, error in errors.items())
    summary = f"{samples:,} rays per pixel; relative RMSE: {listed}; seed {seed}"
    rendering.size_figure(figure, size)
    show_or_save(figure, screenshot, summary)


if __name__ == "__main__":
    typer.run(main)
