"""Irradiance from distant light, given as a picture of the whole sphere or as a function of the direction."""

from dataclasses import dataclass, replace
from math import pi
from typing import Any, get_args

import numpy as np
import warp as wp
from numpy.typing import NDArray
from typing_extensions import Unpack

from warpsample.distributions.lights.picture import as_picture
from warpsample.estimate.integrand import integrand_of
from warpsample.estimate.plan import Plan, RaySum, plan_of
from warpsample.estimate.result import Estimate, PointStatus, has_status
from warpsample.estimate.source.definitions import naming_function
from warpsample.estimate.split import add_spreads
from warpsample.estimate.weights import build_environment_integrand
from warpsample.host.arguments import check_choice, quote
from warpsample.host.arrays import as_unit
from warpsample.host.options import RayKeywords, with_options
from warpsample.mesh.surface import SurfacePoints
from warpsample.radiation.reflection.patches import Patches, patches_of
from warpsample.radiation.reflection.reflections import REPLICATES, Reflected, cached_reflections, reflections_of
from warpsample.radiation.sky.picture_light import PictureLight, Sampling
from warpsample.radiation.sky.radiance_light import RadianceLight
from warpsample.tracing.placed_points import PlacedPoints

_SAMPLINGS = get_args(Sampling)


@dataclass(frozen=True, eq=False, repr=False)
class Irradiance(Estimate):
    """Irradiance at P points, with the part that faces reflect.

    Attributes:
        reflected: Part of `value` from faces, by all orders of reflection, in the same shape and unit; None if all
            faces are black.
        reflected_error: Standard error of `reflected`; None if all faces are black.
        reflected_runs: (P, 1 or 3, 8) float32, `reflected` of each of its eight runs, for errors of means over points; None
            if all faces are black.
    """

    reflected: NDArray[np.float32] | None = None
    reflected_error: NDArray[np.float32] | None = None
    reflected_runs: NDArray[np.float32] | None = None


@with_options(RayKeywords)
def irradiance(
    mesh: Any,
    points: SurfacePoints,
    radiance: Any,
    count: int = 256,
    *,
    up: Any = (0.0, 0.0, 1.0),
    refine: float | None = None,
    sampling: Sampling | None = None,
    **options: Unpack[RayKeywords],
) -> Irradiance:
    """Compute the irradiance of each point under distant light, with shadows of the mesh and light that its faces reflect.

    An open point under a radiance of 1 gets pi. Faces with a reflectance (see `Mesh`) reflect as for `irradiation`, with
    rays of their own on the CPU, and without a `tolerance`.

    Args:
        mesh: Mesh or anything that `as_mesh` accepts.
        points: P SurfacePoints, as for `ambient_occlusion`.
        radiance: Equirectangular picture, (H, W) or (H, W, 3), numbers from 0 to 1e37, or the path of an .hdr or .npy file:
            row 0 is about `up`, columns go round it counter-clockwise, for up = (0, 0, 1) from x towards y. Or a wp.func
            (direction: wp.vec3) -> float or wp.vec3 in mesh coordinates.
        count: Number of rays per point, 2 to 2^24; none is cast where the radiance is 0. Default: 256.
        up: (3,) vector of any length towards row 0 of a picture. Default: (0.0, 0.0, 1.0).
        refine: Longest edge of the parts of faces that each reflect evenly, a float in mesh units, see `irradiation`.
            No effect if no face reflects. Default: None, 8,192 parts more than there are sides.
        sampling: Distribution of the rays: "cosine" for the cosine lobe, "picture" for the luminance of the picture, or
            "both" for rays of each, weighted by the balance heuristic. The share of each with "both" follows from the
            picture: all are of the cosine lobe for an even sky. Default: None, "both" for a picture, "cosine" for a wp.func.
        sequence: Sequence of the rays, a name in `warpsample.sequences.names()`. Default: "fibonacci".
        seed: Random seed, an integer of 64 bits. Default: 0.
        first_point: Global id of row 0, an integer; 0 for points with an `id`. Default: 0.
        active: (P,) bool. Inactive points get 0 and a status, and cast no rays. Default: None, all points are active.
        tolerance: Root mean square of the standard errors to reach, in the result's unit. Default: None, all `count` rays.
        skip: Whether to leave out rays whose answer is known. Changes no value. Default: True.
        tracer: Tracer, "wide", "warp" (`wp.Mesh`, skips no rays) or "auto": wide on the CPU, warp on CUDA. Default: "auto".
        device: Warp device, such as "cuda:0", which computes in parts and returns NumPy arrays. Default: None, the CPU.
        workers: Number of CPU threads, an integer. Default: None, the value of WARPSAMPLE_WORKERS or all cores.
        progress: Whether to show a progress bar on a terminal or in a notebook. Default: False.

    Returns:
        value (P,), or (P, 3) for a radiance of three numbers, in the radiance's unit times steradian, at least 0 where
        the radiance is; its standard error, the part that faces reflect, and for each point the rays cast and a status.

    Raises:
        TypeError, ValueError: an argument has a wrong type, shape or value.
        MemoryError: the result needs more memory than is free.

    Example:
        >>> mesh, sky = ws.load_mesh("courtyard"), np.linspace(2.0, 0.0, 16)[:, None].repeat(32, axis=1)  # bright above
        >>> light = ws.irradiance(mesh, ws.sample_surface(mesh, 100), sky, 64)
        >>> print(light.value.shape, 0.0 < light.value.min() < light.value.max() < 2.0 * np.pi)
        (100,) True
    """
    at = PlacedPoints.of(mesh, points)
    plan = plan_of(at, count, **options)
    axis, patches = as_unit(up, "up"), patches_of(at.mesh, refine)
    if patches is not None and plan.tolerance is not None:
        raise ValueError(
            f"tolerance: got {quote(plan.tolerance)} for a mesh with a reflectance, want None; count alone sets the "
            "number of rays"
        )
    if sampling is not None:
        check_choice(sampling, "sampling", _SAMPLINGS)
    if isinstance(radiance, wp.Function):
        if sampling not in (None, "cosine"):
            raise ValueError(f"sampling: got {quote(sampling)} for a radiance that is a function, want 'cosine'")
        with naming_function("radiance"):
            integrand = integrand_of(radiance, argument="radiance", device=plan.options.memory.device)
            summed = RaySum(integrand, unit=pi, result=Irradiance)
            light = RadianceLight(summed, integrand, integrand.channels)
            found = light.at(plan)
    else:
        picture = PictureLight.of(as_picture(radiance, "radiance", "an array of numbers, a path or a wp.func"), axis)
        sampling = sampling or "both"
        summed = picture.summed(sampling, Irradiance)
        light = RadianceLight(
            summed, build_environment_integrand(picture.pixels, axis), picture.colours, f"{picture.cache_key} {sampling}"
        )
        found = light.at(plan)
    return found if patches is None else _add_reflected(found, _compute_reflected(patches, light, plan))


def _compute_reflected(patches: Patches, light: RadianceLight, plan: Plan) -> Reflected:
    """Compute the irradiance at the points of a call by light that reflecting patches reflect.

    The radiosity of the patches is cached on the mesh.
    """
    if len(plan.at) == 0:
        return Reflected(*np.zeros((2, 0, light.size)), 0)
    light_of = light.cache_key or light.integrand.function
    key = light_of, light.size, patches.cuts.tobytes(), plan.count, plan.options.seed
    found = cached_reflections(patches.mesh, key, lambda: reflections_of(patches, light, plan.count, plan.options))
    return found.at(plan.at.points, plan.count, plan.options)


def _add_reflected(found: Irradiance, reflected: Reflected) -> Irradiance:
    """Add reflected light to the irradiance from distant light, and combine the errors."""
    good = has_status(found.status, PointStatus.OK)
    more, error = (np.where(good[:, None], a, 0.0).reshape(found.value.shape) for a in (reflected.value, reflected.error))
    constant = np.full(error.shape, REPLICATES - 1.0)
    spread, degrees = add_spreads((found.spread, found.degrees_of_freedom), (error, constant))
    numbers = {
        "value": found.value + more,
        "standard_error": np.hypot(found.standard_error.astype(np.float64), error),
        "spread": spread,
        "degrees_of_freedom": degrees,
        "reflected": more,
        "reflected_error": error,
    }
    rays = found.rays + np.where(good, reflected.rays, 0).astype(np.int32)
    singles = {name: array.astype(np.float32) for name, array in numbers.items()}
    return replace(found, rays=rays, reflected_runs=reflected.runs, **singles)
