"""Keinert's experiment: sphere + normal in green and the cosine set in red agree in yellow; beside it a wrong set."""

from typing import Annotated

import numpy as np
import typer

import warpsample as ws
from warpsample.cli.terminal import FigureFile, Size, fail_plainly, show_or_save
from warpsample.host.arguments import check_integer
from warpsample.plotting import rendering
from warpsample.plotting.overlay_sheet import overlay, overlay_sheet
from warpsample.proof.routes import add_normal

PIXELS = 700  # of a picture's side


def directions(count: int, sequence: str, seed: int) -> dict[str, np.ndarray]:
    """(count, 3) directions of the sets "cosine", "sphere" and "ball", row by row from the same points of the square."""
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
    samples: Annotated[int, typer.Option(help="Points of each set.")] = 1024,
    sequence: Annotated[str, typer.Option(help=f"One of: {', '.join(ws.sequences.names())}.")] = "fibonacci",
    seed: Annotated[int, typer.Option(help="Seed of the points.")] = 0,
    screenshot: FigureFile = None,
    size: Size = (1600, 860),
) -> None:
    """Show that the sphere plus the normal, normalised, is the cosine set: drawn in green and red, it is yellow.

    Beside it stands a ball in place of the sphere, as in early ray tracers, which does not turn yellow.
    """
    rendering.check_output(screenshot, rendering.FIGURE_SUFFIXES)
    rendering.check_size(size)
    check_integer(samples, "--samples", 1, 100_000)
    rendering.check_rendering()
    found = directions(samples, sequence, seed)
    panels, shares = [], []
    for name in ("sphere", "ball"):
        picture, share = overlay(found["cosine"], found[name], PIXELS)
        panels.append(("the cosine set", f"normalize({name} + n)", picture, share))
        shares.append(f"{name} {share:.1%}")
    what = f"{samples:,} points each, {sequence}, seed {seed}, seen along the normal"
    figure = overlay_sheet(panels, f"{what}; the ball is the sphere with a radius of its own for each point")
    rendering.size_figure(figure, size)
    show_or_save(figure, screenshot, f"{what}; yellow: {', '.join(shares)}")


if __name__ == "__main__":
    typer.run(main)
