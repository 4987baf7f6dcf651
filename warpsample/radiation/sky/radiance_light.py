"""Distant light with a radiance for each direction, as the other calls of radiation take it."""

from dataclasses import dataclass, replace
from math import pi
from typing import TYPE_CHECKING, Any

import numpy as np

from warpsample.estimate.along import along
from warpsample.estimate.estimating import estimate
from warpsample.estimate.integrand import Integrand
from warpsample.estimate.plan import Plan, RaySum
from warpsample.estimate.split import SplitSum
from warpsample.host.locks import imported
from warpsample.radiation.reflection.lobe_shares import Targets
from warpsample.radiation.reflection.patches import Patches
from warpsample.radiation.reflection.reflections import Probes

if TYPE_CHECKING:
    from scipy.sparse import csr_array

_RAYS_OF_PLACE = 32  # rays from each sample position on a reflecting patch, unless all rays are those of the cosine lobe


@dataclass(frozen=True, eq=False)
class RadianceLight:
    """Distant light whose radiance is a function of the direction, for example a picture of the sky.

    Attributes:
        summed: sum over rays that gives the irradiance.
        integrand: radiance as a function of the direction.
        size: number of colours, 1 or 3.
        cache_key: text that identifies the light in the cache of reflected light; None: the function identifies it.
    """

    summed: RaySum | SplitSum
    integrand: Integrand
    size: int
    cache_key: str | None = None

    def at(self, plan: Plan) -> Any:
        """Compute the irradiance at the points of a call from this light, without reflections."""
        found = estimate(plan, self.summed)
        if self.size == self.integrand.channels:
            return found
        numbers = ("value", "standard_error", "spread", "degrees_of_freedom")
        return replace(found, **{name: getattr(found, name)[:, 0] for name in numbers})

    def targets(self, patches: Patches, workers: int) -> Targets:
        """Return the light sources that rays of reflecting patches may reach: the patches, and this light outside the mesh.

        A radiance that is not finite counts as 0.
        """
        csr_array = imported("scipy.sparse").csr_array

        def light_outside(directions: np.ndarray) -> "csr_array":
            radiance = along(self.integrand, directions, workers)[:, : self.size]
            number, columns = np.where(np.isfinite(radiance), radiance, np.float32(0.0)).ravel(), np.arange(self.size)
            ends = np.arange(0, len(number) + 1, self.size)
            return csr_array((number, np.tile(columns, len(radiance)), ends), shape=radiance.shape)

        return Targets(patches, light_outside)

    def irradiance_of(self, probes: Probes, columns: slice) -> np.ndarray:
        """Return the irradiance of reflecting patches by this light.

        It is that of the rays of the patches, or of further rays if some of the rays are drawn from a picture.
        """
        if isinstance(self.summed, RaySum):
            return pi * probes.light_outside.toarray()[:, columns]
        value = self.at(Plan.of(probes.at, _RAYS_OF_PLACE, probes.options)).value.reshape(len(probes.at), -1)
        return probes.means(np.ascontiguousarray(value[:, columns]), value[:, columns].shape[1])
