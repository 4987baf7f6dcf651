"""A mesh before and after its ambient occlusion is baked into a texture, and the standard errors of its texels."""

from pathlib import Path
from typing import Annotated, Literal

import matplotlib as mpl
import numpy as np
import typer

import warpsample as ws
from warpsample.cli.terminal import Size, fail_plainly, show_or_save
from warpsample.host.arguments import check_integer
from warpsample.plotting import rendering
from warpsample.plotting.scenes import ZOOM, add_title, columns_over_caption, draw_mesh, look_from
from warpsample.viewer.start import bunny


def images_of(mesh: ws.Mesh, side: int, samples: int, seed: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """New texture coordinates (F, 3, 2) of a mesh, v down, and the images of occlusion and of its errors, (H, W)."""
    split, uv = ws.unwrap(mesh, side)
    normals = mesh.vertex_normals[mesh.faces]
    t = ws.texture_points(split, uv, side, normals="lifted", corner_normals=normals)
    found = ws.ambient_occlusion(split, t.points, samples, seed=seed)
    return uv, t.image(found.value), t.image_error(found)


def coloured(image: np.ndarray, high: float) -> np.ndarray:
    """(H, W, 3) uint8, from viridis' first colour for 0 to its last for `high`."""
    return np.round(255 * mpl.colormaps["viridis"](np.clip(image / high, 0.0, 1.0))[..., :3]).astype(np.uint8)


@fail_plainly(count="--samples")
def main(
    mesh: Annotated[Path | None, typer.Argument(help="Mesh file; by default the bunny in warp-lang.")] = None,
    side: Annotated[int, typer.Option(help="Side of the texture in texels.")] = 512,
    samples: Annotated[int, typer.Option(help="Rays of each texel.")] = 256,
    seed: Annotated[int, typer.Option(help="Seed of the rays.")] = 0,
    up: Annotated[Literal["x", "y", "z"], typer.Option(help="The mesh's axis that points up in the picture.")] = "y",
    screenshot: Annotated[
        Path | None, typer.Option(help="No window, but a file: .png, or .html to turn in a browser.")
    ] = None,
    size: Size = (1800, 680),
) -> None:
    """Show a mesh before and after its ambient occlusion is baked into a texture, and the errors of its texels."""
    rendering.check_output(screenshot, rendering.SCENE_SUFFIXES, mesh)
    rendering.check_size(size, (900, 340))
    check_integer(side, "--side", 128, 8192)
    rendering.check_rendering()
    surface = ws.load_mesh(mesh or bunny())
    uv, occlusion, error = images_of(surface, side, samples, seed)
    high = rendering.round_ticks(max(float(np.quantile(error, 0.99)), 1e-6), 5)[-1]
    grey = np.round(255.0 * np.clip(occlusion, 0.0, 1.0)).astype(np.uint8)
    panels = {"Before": None, "Ambient occlusion": (grey, uv), f"Standard error, 0 to {high:g}": (coloured(error, high), uv)}
    rms = float(np.sqrt(np.mean(np.square(error))))
    what = f"{len(surface.faces):,} faces, {side} x {side} texels, {samples:,} rays each; RMS error {rms:.4f}; seed {seed}"
    plotter = columns_over_caption(len(panels), what, screenshot is not None, size)
    for column, (title, texture) in enumerate(panels.items()):
        plotter.subplot(0, column)
        draw_mesh(plotter, surface.vertices, surface.faces, texture)
        add_title(plotter, title)
        look_from(plotter, up, ZOOM)
    plotter.link_views()
    show_or_save(plotter, screenshot, what)


if __name__ == "__main__":
    typer.run(main)
