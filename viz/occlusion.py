"""Ambient occlusion at a mesh's vertices, its standard error and the number of rays that were cast, side by side."""

from pathlib import Path
from typing import Annotated, Literal

import numpy as np
import typer

import warpsample as ws
from warpsample.cli.terminal import Size, fail_plainly, show_or_save
from warpsample.plotting import rendering
from warpsample.plotting.scenes import Panel, meshes_side_by_side
from warpsample.viewer.start import bunny


def panels_of(found: ws.Estimate, samples: int) -> list[Panel]:
    """What is shown of an estimate of `samples` rays.

    The colours of the errors end at a round number above those of 99 in 100 vertices, so that a few do not darken the rest.
    """
    error = max(float(np.quantile(found.standard_error, 0.99)), 1e-6)
    return [
        Panel(found.value, "Ambient occlusion (1: fully open)", "gray", 1.0),
        Panel(found.standard_error, "Standard error", "viridis", rendering.round_ticks(error, 5)[-1]),
        Panel(found.rays, f"Rays cast, of {samples:,}", "magma", float(samples)),
    ]


@fail_plainly(count="--samples")
def main(
    mesh: Annotated[Path | None, typer.Argument(help="Mesh file; by default the bunny in warp-lang.")] = None,
    samples: Annotated[int, typer.Option(help="Rays at each vertex.")] = 1024,
    max_distance: Annotated[
        float | None, typer.Option(help="Hits at or beyond this distance are ignored.", show_default=False)
    ] = None,
    seed: Annotated[int, typer.Option(help="Seed of the rays.")] = 0,
    up: Annotated[Literal["x", "y", "z"], typer.Option(help="The mesh's axis that points up in the picture.")] = "y",
    screenshot: Annotated[
        Path | None, typer.Option(help="No window, but a file: .png, or .html to turn in a browser.")
    ] = None,
    size: Size = (1800, 680),
) -> None:
    """Show ambient occlusion at a mesh's vertices, its standard error and the number of rays cast, side by side."""
    rendering.check_output(screenshot, rendering.SCENE_SUFFIXES, mesh)
    rendering.check_size(size, (900, 340))
    rendering.check_rendering()
    surface = ws.load_mesh(mesh or bunny())
    found = ws.ambient_occlusion(surface, ws.vertex_points(surface), samples, max_distance=max_distance, seed=seed)
    cast, asked = int(found.rays.sum()), samples * len(found.rays)
    error = np.sqrt(np.mean(np.square(found.standard_error)))
    rays = f"{cast / asked:.0%} of {asked:,} rays cast"
    what = f"{len(found.rays):,} vertices; {rays}; RMS standard error {error:.4f}; seed {seed}"
    plotter = meshes_side_by_side(
        surface.vertices,
        surface.faces,
        panels_of(found, samples),
        caption=what,
        up=up,
        off_screen=screenshot is not None,
        size=size,
    )
    show_or_save(plotter, screenshot, what)


if __name__ == "__main__":
    typer.run(main)
