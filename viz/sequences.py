"""Point sequences on the unit square and on the hemisphere, and the errors of means over the directions."""

from typing import Annotated

import numpy as np
import typer

import warpsample as ws
from warpsample.bench.tools.integrands import INTEGRANDS, KnownIntegral, evaluate
from warpsample.cli.terminal import FigureFile, Size, fail_plainly, show_or_save
from warpsample.host.arguments import check_integer
from warpsample.plotting import rendering
from warpsample.plotting.sequence_sheet import Convergence, sequence_sheet

SHOWN = 256  # points per square
COUNTS = (16, 64, 256, 1024, 4096)
INTEGRANDS_SHOWN = ("sky gradient", "20° cap", "narrow lobe")


def errors(names: tuple[str, ...], randomisations: int, seed: int) -> list[Convergence]:
    """Compute the errors of means over the cosine lobe for each integrand and sequence, with COUNTS samples.

    Args:
        names: names of the integrands.
        randomisations: number of means per root mean square error.
        seed: seed of the points.
    """
    chosen = [integrand for integrand in INTEGRANDS if integrand.name in names]
    found = {integrand.name: {name: np.empty(len(COUNTS)) for name in ws.sequences.names()} for integrand in chosen}
    up = np.tile(np.array([0.0, 0.0, 1.0], np.float32), (randomisations, 1))
    for name in ws.sequences.names():
        for k, count in enumerate(COUNTS):
            w = ws.sample_directions(up, count, sequence=name, seed=seed).vectors
            for integrand in chosen:
                found[integrand.name][name][k] = _rmse(integrand, w)
    return [Convergence(f"{i.name} ({i.kind})", np.array(COUNTS), found[i.name]) for i in chosen]


def _rmse(integrand: KnownIntegral, w: np.ndarray) -> float:
    """Return the root mean square error, over all randomisations, of the mean of an integrand over N directions.

    The directions are (randomisations, N, 3).
    """
    means = evaluate(integrand, w).mean(axis=1, dtype=np.float64)
    return float(np.sqrt(np.mean((means - integrand.mean) ** 2)))


@fail_plainly()
def main(
    randomisations: Annotated[int, typer.Option(help="Number of estimates per root mean square error.")] = 256,
    seed: Annotated[int, typer.Option(help="Seed of the points.")] = 0,
    screenshot: FigureFile = None,
    size: Size = (1600, 1100),
) -> None:
    """Show the sequences on the square and on the hemisphere, and the errors of means by the number of samples."""
    rendering.check_output(screenshot, rendering.FIGURE_SUFFIXES)
    rendering.check_size(size)
    check_integer(randomisations, "--randomisations", 16, 100_000)
    rendering.check_rendering()
    names = ws.sequences.names()
    squares = {name: ws.sample_square(name, 1, SHOWN, seed=seed)[0] for name in names}
    lobes = {name: ws.CosineHemisphere("concentric").sample(u) for name, u in squares.items()}
    curves = errors(INTEGRANDS_SHOWN, randomisations, seed)
    summary = f"{SHOWN} points; errors over {randomisations} randomisations; seed {seed}"
    caption = f"{summary}; directions of the cosine lobe by the concentric map"
    figure = sequence_sheet(squares, lobes, curves, caption)
    rendering.size_figure(figure, size)
    best = {curve.title: min(curve.rmse, key=lambda name, c=curve: c.rmse[name][-1]) for curve in curves}
    show_or_save(
        figure, screenshot, f"{summary}; smallest error at {COUNTS[-1]:,}: " + ", ".join(f"{k} {v}" for k, v in best.items())
    )


if __name__ == "__main__":
    typer.run(main)
