"""Keinert's experiment: sphere + normal in green over the cosine set in red is yellow; ball + normal is not."""

from typing import Annotated

import numpy as np
import typer

import warpsample as ws
from warpsample.cli.terminal import FigureFile, Size, fail_plainly, show_or_save
from warpsample.host.arguments import check_integer
from warpsample.plotting import rendering
from warpsample.plotting.overlay_sheet import overlay, overlay_sheet
from warpsample.proof.routes import add_normal

PIXELS = 700  # width and height of a picture


def directions(count: int, sequence: str, seed: int) -> dict[str, np.ndarray]:
    """Return directions, (count, 3), of the sets "cosine", "sphere" and "ball", from the same points of the unit square."""
    u = ws.sample_square(sequence, 1, count, seed=seed)[0]
    sphere = ws.UniformSphere().sample(u).astype(np.float64)
    radius = np.cbrt(ws.sample_square("independent", 1, count, seed=seed)[0, :, :1].astype(np.float64))
    return {
        "cosine": ws.CosineHemisphere("polar").sample(u),
        "sphere": add_normal(sphere),
        "ball": add_normal(radius * sphere),
    }


@fail_plainly()
def main(
    samples: Annotated[int, typer.Option(help="Number of points per set.")] = 1024,
    sequence: Annotated[str, typer.Option(help=f"One of: {', '.join(ws.sequences.names())}.")] = "fibonacci",
    seed: Annotated[int, typer.Option(help="Seed of the points.")] = 0,
    screenshot: FigureFile = None,
    size: Size = (1600, 860),
) -> None:
    """Show that points on a sphere plus the normal, normalised, are the cosine set: red and green add up to yellow.

    For comparison a second picture has points in a ball in place of the sphere, as in early ray tracers.
    """
    rendering.check_output(screenshot, rendering.FIGURE_SUFFIXES)
    rendering.check_size(size)
    check_integer(samples, "--samples", 1, 100_000)
    rendering.check_rendering()
    sets = directions(samples, sequence, seed)
    panels, shares = [], []
    for name in ("sphere", "ball"):
        picture, share = overlay(sets["cosine"], sets[name], PIXELS)
        panels.append(("cosine set", f"points of a {name} + normal, normalised", picture, share))
        shares.append(f"{name} {share:.1%}")
    summary = f"{samples:,} points per set, {sequence} sequence, seed {seed}, seen along the normal"
    figure = overlay_sheet(panels, f"{summary}; the ball has the directions of the sphere and random radii")
    rendering.size_figure(figure, size)
    show_or_save(figure, screenshot, f"{summary}; yellow: {', '.join(shares)}")


if __name__ == "__main__":
    typer.run(main)
