"""Functions that sample lobes whose roughness and view differ from point to point, by warpsample and by Mitsuba."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from itertools import count as count_from
from typing import Any

import numpy as np

from warpsample.bench.record import SEED
from warpsample.bench.running.turns import Tool, keep_last_result
from warpsample.bench.tools.directions import Built
from warpsample.directions.sample import sample_directions
from warpsample.distributions.microfacets.ggx import GGX
from warpsample.distributions.microfacets.visible_ggx import VisibleGGX
from warpsample.distributions.record import Distribution
from warpsample.distributions.scattering.reflection import Reflection

CONSTANT = "warpsample, constant"
BY_POINT = "warpsample, by point"
MITSUBA = "Mitsuba, by point"

LOBES: dict[str, Callable[[Any, Any], Distribution]] = {
    "GGX": lambda alpha, view: GGX(alpha),
    "VisibleGGX": lambda alpha, view: VisibleGGX(alpha, view=view),
    "Reflection(VisibleGGX)": lambda alpha, view: Reflection(VisibleGGX(alpha, view=view), view=view),
}
"""Functions (roughness, view) -> lobe, keyed by the name in the tables."""


@dataclass(frozen=True)
class Surface:
    """Points that differ in normal, roughness and view.

    Attributes:
        normals: (P, 3) unit normals, float32.
        alpha: (P,) roughness between 0.05 and 0.95, float32.
        view: (P, 3) unit vectors above the surface in local coordinates, float32.
    """

    normals: np.ndarray
    alpha: np.ndarray
    view: np.ndarray


def build_surface(points: int) -> Surface:
    """Build random normals, roughnesses, and views at least 0.1 above the surface."""
    rng = np.random.default_rng(SEED)
    normals = rng.normal(size=(points, 3))
    height, azimuth = rng.uniform(0.1, 1.0, points), rng.uniform(0.0, 2.0 * np.pi, points)
    side = np.sqrt(1.0 - height * height)
    view = np.stack([side * np.cos(azimuth), side * np.sin(azimuth), height], axis=1)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    return Surface(normals.astype(np.float32), rng.uniform(0.05, 0.95, points).astype(np.float32), view.astype(np.float32))


def _warpsample(constant: bool, lobe: str, surface: Surface, count: int, workers: int) -> Built:
    """Build the sampler of world directions and densities, and the function of their cosines."""
    row = (0.3, (0.6, 0.0, 0.8)) if constant else (surface.alpha, surface.view)
    out = np.empty((len(surface.normals), count, 3), np.float32)
    run = partial(sample_directions, surface.normals, count, sequence="independent", out=out, workers=workers)
    return partial(run, distribution=LOBES[lobe](*row), pdf=True), lambda: np.einsum("pni,pi->pn", out, surface.normals)


def _mitsuba(lobe: str, surface: Surface, count: int, workers: int) -> Built:
    """Build Mitsuba's sampler of local directions and densities, without world frames, and the function of their cosines."""
    import drjit as dr
    import mitsuba as mi

    mi.set_variant("llvm_ad_rgb")
    dr.set_thread_count(workers)
    size, seeds = len(surface.normals) * count, count_from()
    alphas, views = mi.Float(surface.alpha), mi.Vector3f(np.ascontiguousarray(surface.view.T))
    texture = mi.TensorXf(surface.alpha[None, :, None])
    material = mi.load_dict(
        {
            "type": "roughconductor",
            "distribution": "ggx",
            "alpha": {"type": "bitmap", "data": texture, "raw": True, "filter_type": "nearest", "wrap_mode": "clamp"},
        }
    )

    def sample(view: Any, point: Any, alpha: Any, u: Any) -> Any:
        if lobe != "Reflection(VisibleGGX)":
            microfacets = mi.MicrofacetDistribution(mi.MicrofacetType.GGX, alpha, alpha, lobe == "VisibleGGX")
            return microfacets.sample(view, u)
        hit = dr.zeros(mi.SurfaceInteraction3f)
        hit.wi, hit.uv = view, mi.Point2f((mi.Float(point) + 0.5) / len(surface.normals), 0.5)
        drawn, _ = material.sample(mi.BSDFContext(), hit, 0.0, u)
        return drawn.wo, drawn.pdf

    def run() -> Any:
        point = dr.arange(mi.UInt32, size) // count
        rng = mi.PCG32(size, initstate=dr.opaque(mi.UInt64, next(seeds)))
        u = mi.Point2f(rng.next_float32(), rng.next_float32())
        alpha = None if lobe == "Reflection(VisibleGGX)" else dr.gather(mi.Float, alphas, point)
        directions, pdf = sample(dr.gather(mi.Vector3f, views, point), point, alpha, u)
        dr.eval(directions, pdf)
        dr.sync_thread()
        return directions

    work, result = keep_last_result(run)
    return work, lambda: np.asarray(result().z)


WAYS = {
    CONSTANT: Tool("warpsample", partial(_warpsample, True)),
    BY_POINT: Tool("warpsample", partial(_warpsample, False)),
    MITSUBA: Tool("mitsuba", _mitsuba),
}
"""Tools by name; `make(lobe, surface, count, threads)` returns (work, function of the last run's cosines)."""
