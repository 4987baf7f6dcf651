"""A mesh before and after ambient occlusion is baked into a texture, and the standard errors of the texels."""

from pathlib import Path
from typing import Annotated, Any, Literal

import matplotlib as mpl
import numpy as np
import typer

import warpsample as ws
from warpsample.cli.terminal import Size, fail_plainly, show_or_save
from warpsample.host.arguments import check_integer
from warpsample.plotting import rendering, style
from warpsample.plotting.panels import add_scale, add_text, add_title, columns_over_caption, fit_view
from warpsample.plotting.scenes import draw_mesh
from warpsample.viewer.start import bunny


def bake_images(mesh: ws.Mesh, side: int, samples: int, seed: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return new texture coordinates, (F, 3, 2) with v down, and images of occlusion and of its errors, (side, side)."""
    split, uv = ws.unwrap(mesh, side)
    normals = mesh.vertex_normals[mesh.faces]
    t = ws.texture_points(split, uv, side, normals="lifted", corner_normals=normals)
    found = ws.ambient_occlusion(split, t.points, samples, seed=seed)
    return uv, t.image(found.value), t.image_error(found)


def color_image(image: np.ndarray, colours: str, high: float) -> np.ndarray:
    """Return an image, (H, W), in the colours of a map as (H, W, 3) uint8: 0 has the first colour, `high` the last."""
    return np.round(255 * mpl.colormaps[colours](np.clip(image / high, 0.0, 1.0))[..., :3]).astype(np.uint8)


def draw_textured(plotter: Any, mesh: ws.Mesh, uv: np.ndarray, image: np.ndarray, colours: str, high: float) -> None:
    """Draw a mesh with an image as texture, (H, W), in the colours of a map from 0 to `high`, with a colour bar."""
    draw_mesh(plotter, mesh.vertices, mesh.faces, (color_image(image, colours, high), uv))
    add_scale(plotter, colours, high)


@fail_plainly(count="--samples")
def main(
    mesh: Annotated[
        Path | None, typer.Argument(help="Mesh file. Default: the bunny in warp-lang.", show_default=False)
    ] = None,
    side: Annotated[int, typer.Option(help="Width and height of the texture in texels.")] = 512,
    samples: Annotated[int, typer.Option(help="Number of rays per texel.")] = 256,
    seed: Annotated[int, typer.Option(help="Seed of the rays.")] = 0,
    up: Annotated[Literal["x", "y", "z"], typer.Option(help="Axis of the mesh that points up in the picture.")] = "y",
    screenshot: Annotated[
        Path | None, typer.Option(help="Save to this file, .png or .html, in place of a window.", show_default=False)
    ] = None,
    size: Size = (1800, 680),
) -> None:
    """Show a mesh before and after ambient occlusion is baked into a texture, and the standard errors of the texels."""
    rendering.check_output(screenshot, rendering.SCENE_SUFFIXES, mesh)
    rendering.check_size(size, (900, 340))
    check_integer(side, "--side", 128, 8192)
    rendering.check_rendering()
    surface = ws.load_mesh(mesh or bunny())
    uv, occlusion, error = bake_images(surface, side, samples, seed)
    high = rendering.round_ticks(max(float(np.quantile(error, 0.99)), 1e-6), 5)[-1]
    rms = float(np.sqrt(np.mean(np.square(error))))
    texels = f"{len(surface.faces):,} faces, {side} x {side} texels"
    summary = f"{texels}, {samples:,} rays each; RMS standard error {rms:.4f}; seed {seed}"
    plotter = columns_over_caption(3, summary, screenshot is not None, size)
    columns = (
        ("The mesh without a texture", None, "lit by a lamp at the camera"),
        ("Baked ambient occlusion", (occlusion, style.OPENNESS, 1.0), "0: occluded, 1: open"),
        ("Standard error of each texel", (error, style.ERROR, high), "standard error of the occlusion"),
    )
    for column, (title, texture, label) in enumerate(columns):
        plotter.subplot(0, column)
        if texture is None:
            draw_mesh(plotter, surface.vertices, surface.faces)
        else:
            draw_textured(plotter, surface, uv, *texture)
        add_title(plotter, title)
        add_text(plotter, label, (0.5, 0.04))
        fit_view(plotter, surface.vertices, up)
    plotter.link_views()
    show_or_save(plotter, screenshot, summary)


if __name__ == "__main__":
    typer.run(main)
