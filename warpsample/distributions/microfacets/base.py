"""Base class of the distributions of microfacet normals, whose roughness may differ along x and y."""

from typing import Any, ClassVar

import numpy as np

from warpsample.distributions.record import Distribution, Maps, Range

Matrix = tuple[tuple[float, float, float], tuple[float, float, float], tuple[float, float, float]]


class Microfacets(Distribution):
    """Base class of distributions of microfacet normals with the fields `alpha` and `alpha_y`.

    Without `alpha_y` the lobe is isotropic, and its functions take no `alpha_y`.
    """

    alpha: float
    alpha_y: float | None

    support = "hemisphere"
    parameters: ClassVar[tuple[str, ...]] = ("alpha", "alpha_y")
    bounds: ClassVar[Range] = (1e-6, 1.0)
    isotropic: ClassVar[Maps]
    anisotropic: ClassVar[Maps]

    def __post_init__(self) -> None:
        """Check the parameters; without `alpha_y` the distribution is isotropic and has one parameter less."""
        if self.alpha_y is None:
            names = tuple(name for name in type(self).parameters if name != "alpha_y")
            object.__setattr__(self, "parameters", names)
        super().__post_init__()

    def __repr__(self) -> str:
        """Return the class name and the parameters as text, without `alpha_y` if it is None."""
        return super().__repr__().replace(", alpha_y=None", "")

    @property
    def maps(self) -> Maps:  # type: ignore[override]
        """Warp functions of the distribution for kernels: map, density and inverse."""
        return self.isotropic if self.alpha_y is None else self.anisotropic

    @property
    def symmetric(self) -> bool:  # type: ignore[override]
        """True if the density depends only on the angle to +z, which is the case without `alpha_y`."""
        return self.alpha_y is None

    @property
    def polar(self) -> bool:  # type: ignore[override]
        """True if u[0] alone determines the angle to +z, which is the case without `alpha_y`."""
        return self.alpha_y is None

    @property
    def stretch(self) -> Matrix | None:  # type: ignore[override]
        """Roughnesses along x and y as a diagonal matrix, rounded to float32; None without `alpha_y`."""
        if self.alpha_y is None:
            return None
        return (float(np.float32(self.alpha)), 0.0, 0.0), (0.0, float(np.float32(self.alpha_y)), 0.0), (0.0, 0.0, 1.0)

    def _cdf(self, theta: Any) -> np.ndarray:
        """Return the probability that the angle to +z is at most theta, if the distribution is isotropic. See `cdf`."""
        return self._isotropic_cdf(theta) if self.symmetric else Distribution._cdf(self, theta)

    def _isotropic_cdf(self, theta: np.ndarray) -> np.ndarray:
        """Return the probability that the angle to +z is at most theta, for the isotropic distribution."""
        return Distribution._cdf(self, theta)
