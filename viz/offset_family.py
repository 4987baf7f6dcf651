"""Projected offset sets: a circle, disk, sphere or ball about the tip of the normal, projected onto directions."""

from collections.abc import Callable
from typing import Annotated

import numpy as np
import typer

import warpsample as ws
from warpsample.cli.terminal import FigureFile, Size, fail_plainly, show_or_save
from warpsample.distributions.record import Distribution
from warpsample.host.arguments import check_integer
from warpsample.plotting import rendering
from warpsample.plotting.family_sheet import SetPanel, family_sheet
from warpsample.proof import routes
from warpsample.statistics.charts import SPHERE, chart_of
from warpsample.statistics.histogram import joined_test

SHOWN = 400  # drawn points per set
CELLS = 60
SETS = (
    ("Circle about n, in 2-D", ws.OffsetCircle(), "1/π", lambda u: routes.circle(u[:, 0])),
    ("Disk about n, in 2-D", ws.OffsetDisk(), "2cos²θ/π", routes.disk),
    ("Sphere about n, in 3-D", ws.OffsetSphere(), "sin 2θ", routes.sphere),
    ("Ball about n, in 3-D", ws.OffsetBall(), "4cos³θ sinθ", routes.ball),
)
SPHERES = tuple(
    (f"Sphere of radius ρ = {rho:g}", ws.OffsetSphere(rho), "density", lambda u, rho=rho: rho * routes.sphere(u))
    for rho in (0.5, 0.9, 2.0)
)


def panel(
    title: str,
    distribution: Distribution,
    formula: str,
    points: Callable[[np.ndarray], np.ndarray],
    count: int,
    seed: int,
) -> SetPanel:
    """Sample `count` directions of an offset set, test their angles against the density, and return the panel to draw.

    Args:
        title: text above the panel.
        distribution: distribution of the directions.
        formula: formula of the density, for the legend.
        points: function from numbers in [0, 1), (N, 3), to points of the set about the origin.
        count: number of directions.
        seed: seed of the points.
    """
    u = [ws.sample_square(name, 1, SHOWN, seed=seed)[0] for name in ("r2", "independent")]
    moved = points(np.concatenate(u, axis=1)[:, :3].astype(np.float64)) + np.eye(distribution.width)[-1]
    w = distribution.sample(ws.sample_square("independent", 1, count, seed=seed)[0])
    chart = chart_of(distribution)
    low = 0.0 if chart is SPHERE else -np.pi / 2
    high = np.pi if distribution.largest_angle > np.pi / 2 else np.pi / 2
    edges = np.linspace(low, high, CELLS + 1)
    observed, _ = np.histogram(np.clip(chart.polar(w), low, high), edges)
    fine = np.linspace(low, high, 10 * CELLS + 1)
    return SetPanel(
        title=title,
        points=moved[:, [0, -1]],
        directions=routes.normalize(moved)[:, [0, -1]],
        edges=np.degrees(edges),
        observed=observed / (count * np.diff(edges)),
        angles=np.degrees(0.5 * (fine[1:] + fine[:-1])),
        density=np.diff(distribution.cdf(fine)) / np.diff(fine),
        formula=formula,
        test=joined_test(observed, count * np.diff(distribution.cdf(edges))),
    )


@fail_plainly()
def main(
    samples: Annotated[int, typer.Option(help="Number of independent directions per histogram.")] = 200_000,
    seed: Annotated[int, typer.Option(help="Seed of the points.")] = 0,
    screenshot: FigureFile = None,
    size: Size = (1600, 1650),
) -> None:
    """Show the projected offset sets: points, histograms of the angles with their densities, and a proof.

    A set about the tip of the normal is projected onto the unit circle or sphere. The unit sphere gives the cosine lobe; the
    ball, the disk and spheres of other radii do not.
    """
    rendering.check_output(screenshot, rendering.FIGURE_SUFFIXES)
    rendering.check_size(size)
    check_integer(samples, "--samples", 1000, 100_000_000)
    rendering.check_rendering()
    four, others = ([panel(*row, samples, seed) for row in rows] for rows in (SETS, SPHERES))
    summary = f"{samples:,} independent directions per histogram, seed {seed}"
    figure = family_sheet(four, others, f"{summary}; {SHOWN} points of each set, seen from the side")
    rendering.size_figure(figure, size)
    worst = min(each.test.p_value for each in four + others)
    show_or_save(figure, screenshot, f"{summary}; smallest p-value of {len(four + others)} tests {worst:.3f}")


if __name__ == "__main__":
    typer.run(main)
