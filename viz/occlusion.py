"""Ambient occlusion at the vertices of a mesh, its standard error, and the number of rays that were cast."""

from pathlib import Path
from typing import Annotated, Literal

import numpy as np
import typer

import warpsample as ws
from warpsample.cli.terminal import Size, fail_plainly, show_or_save
from warpsample.plotting import rendering, style
from warpsample.plotting.panels import Panel, meshes_side_by_side
from warpsample.viewer.start import bunny


def make_panels(found: ws.Estimate, samples: int) -> list[Panel]:
    """Return panels of an estimate with `samples` rays per vertex: values, standard errors, and rays cast.

    The last colour of the errors is a round number above their 99th percentile, so that the largest do not darken the rest.
    """
    error = max(float(np.quantile(found.standard_error, 0.99)), 1e-6)
    last = rendering.round_ticks(error, 5)[-1]
    return [
        Panel(found.value, "Ambient occlusion", style.OPENNESS, 1.0, "0: occluded, 1: open"),
        Panel(found.standard_error, "Standard error", style.ERROR, last, "standard error of the occlusion"),
        Panel(found.rays, "Rays that were cast", style.AMOUNT, float(samples), f"rays per vertex, of {samples:,}"),
    ]


@fail_plainly(count="--samples")
def main(
    mesh: Annotated[
        Path | None, typer.Argument(help="Mesh file. Default: the bunny in warp-lang.", show_default=False)
    ] = None,
    samples: Annotated[int, typer.Option(help="Number of rays per vertex.")] = 1024,
    max_distance: Annotated[
        float | None, typer.Option(help="Ignore hits at or beyond this distance, in units of the mesh.", show_default=False)
    ] = None,
    seed: Annotated[int, typer.Option(help="Seed of the rays.")] = 0,
    up: Annotated[Literal["x", "y", "z"], typer.Option(help="Axis of the mesh that points up in the picture.")] = "y",
    screenshot: Annotated[
        Path | None, typer.Option(help="Save to this file, .png or .html, in place of a window.", show_default=False)
    ] = None,
    size: Size = (1800, 680),
) -> None:
    """Show ambient occlusion at the vertices of a mesh, its standard error, and the number of rays that were cast."""
    rendering.check_output(screenshot, rendering.SCENE_SUFFIXES, mesh)
    rendering.check_size(size, (900, 340))
    rendering.check_rendering()
    surface = ws.load_mesh(mesh or bunny())
    found = ws.ambient_occlusion(surface, ws.vertex_points(surface), samples, max_distance=max_distance, seed=seed)
    cast, total = int(found.rays.sum()), samples * len(found.rays)
    error = np.sqrt(np.mean(np.square(found.standard_error)))
    rays = f"{cast / total:.0%} of {total:,} rays cast"
    summary = f"{len(found.rays):,} vertices; {rays}; RMS standard error {error:.4f}; seed {seed}"
    plotter = meshes_side_by_side(
        surface.vertices,
        surface.faces,
        make_panels(found, samples),
        caption=summary,
        up=up,
        off_screen=screenshot is not None,
        size=size,
    )
    show_or_save(plotter, screenshot, summary)


if __name__ == "__main__":
    typer.run(main)
