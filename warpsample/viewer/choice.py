"""Settings of the viewer, and texts that describe distributions."""

from dataclasses import dataclass, fields
from typing import Any

import numpy as np

from warpsample.distributions.cosine_hemisphere import CosineHemisphere
from warpsample.distributions.offset_ball import OffsetBall
from warpsample.distributions.offset_sphere import OffsetSphere
from warpsample.distributions.record import Distribution

OWN, COSINE = "its own density", "the cosine lobe"
"""Names of the densities that the menu "Compared with" offers."""


@dataclass(frozen=True)
class Choice:
    """Settings of the viewer: distribution, density to compare with, sequence, number of directions, and seed.

    Attributes:
        distribution: distribution of the directions.
        density: distribution whose density the directions are compared with; None is `distribution` itself.
        sequence: name of the point sequence. The default is independent points, which the chi-square test requires.
        samples: number of directions at each point.
        seed: seed of the directions.
        camera: whether the view of view-dependent lobes is the direction from each point to the camera.
    """

    distribution: Distribution
    density: Distribution | None = None
    sequence: str = "independent"
    samples: int = 1024
    seed: int = 0
    camera: bool = True

    @property
    def claim(self) -> Distribution:
        """Distribution whose density is compared with the sampled directions."""
        return self.density or self.distribution

    @property
    def claim_name(self) -> str:
        """Name of the distribution whose density is compared with the sampled directions."""
        if self.density is None:
            return OWN
        return COSINE if isinstance(self.density, CosineHemisphere) else self.density.name


def default_density(distribution: Distribution) -> Distribution | None:
    """Return the distribution whose density the viewer shows by default; None is the sampled distribution itself.

    An offset sphere or an offset ball is compared with the cosine lobe: the viewer then shows that only the sphere of
    radius 1 gives a cosine lobe.
    """
    return CosineHemisphere() if isinstance(distribution, OffsetSphere | OffsetBall) else None


def format_distribution(distribution: Distribution, camera: bool = False) -> str:
    """Return a distribution in the notation of the command line, with numbers of three digits: "ggx(alpha=0.1)".

    Parameters by point are shown as ranges: "ggx(alpha=0.1 to 0.5)". With `camera`, the view is shown as "camera".
    """
    names = [item.name for item in fields(distribution)]
    lobes = [name for name in names if isinstance(getattr(distribution, name), Distribution)]
    values = {name: getattr(distribution, name) for name in ([*lobes, *distribution.parameters] or names)}
    texts = (f"{name}={'camera' if camera and name == 'view' else _format_value(v, camera)}" for name, v in values.items())
    return f"{distribution.name}({', '.join(texts)})".replace("()", "")


def _format_value(value: Any, camera: bool = False) -> str:
    """Format a parameter of a distribution, with three digits per number."""
    if isinstance(value, Distribution):
        return format_distribution(value, camera)
    if isinstance(value, np.ndarray):
        return f"{np.nanmin(value):.3g} to {np.nanmax(value):.3g}" if value.ndim == 1 else "by point"
    if isinstance(value, str):
        return repr(value)
    return f"({', '.join(_format_value(v) for v in value)})" if isinstance(value, tuple) else f"{value:.3g}"
