"""What the viewer is asked to show, and its names in words."""

from dataclasses import dataclass, fields

from warpsample.distributions.record import Distribution


@dataclass(frozen=True)
class Choice:
    """What the knobs are set to.

    A density of None is the distribution's own. The viewer starts with independent points, for which chi-square's test is
    made; the samples are at each point, and the seed is of the directions.
    """

    distribution: Distribution
    density: Distribution | None = None
    sequence: str = "independent"
    samples: int = 1024
    seed: int = 0

    @property
    def claim(self) -> Distribution:
        """The distribution with whose density the directions are compared."""
        return self.density or self.distribution


def spelt(distribution: Distribution) -> str:
    """A distribution as the command line takes it, with numbers of three digits: "ggx(alpha=0.1)"."""
    names = type(distribution).parameters or [item.name for item in fields(distribution)]
    values = (f"{name}={_rounded(getattr(distribution, name))}" for name in names)
    return f"{distribution.name}({', '.join(values)})".replace("()", "")


def _rounded(value: float | str | tuple[float, ...]) -> str:
    if isinstance(value, str):
        return repr(value)
    return f"({', '.join(_rounded(v) for v in value)})" if isinstance(value, tuple) else f"{value:.3g}"
