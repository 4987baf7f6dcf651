"""Irradiance under light from afar: a picture of it all around, or a function of the direction."""

from dataclasses import replace
from math import pi
from os import PathLike
from typing import Any

import numpy as np
import warp as wp

from warpsample.estimate.estimating import estimate
from warpsample.estimate.integrand import integrand_of
from warpsample.estimate.plan import Plan, RaySum
from warpsample.estimate.result import Estimate
from warpsample.estimate.source.definitions import naming_function
from warpsample.estimate.visibility import ambient_occlusion
from warpsample.estimate.weights import seen_in
from warpsample.host.arrays import as_real, as_unit
from warpsample.host.options import explained_by
from warpsample.host.picture import read_picture
from warpsample.mesh.surface import SurfacePoints
from warpsample.tracing.options import RayOptions
from warpsample.tracing.placed_points import PlacedPoints

_BRIGHTEST = 1e37  # of a picture: pi times that is a float32


@explained_by(RayOptions, ambient_occlusion)
def irradiance(
    mesh: Any,
    points: SurfacePoints,
    radiance: Any,
    count: int = 256,
    *,
    up: Any = (0.0, 0.0, 1.0),
    sequence: str = "fibonacci",
    seed: int = 0,
    first_point: int = 0,
    active: Any = None,
    tolerance: float | None = None,
    skip: bool = True,
    tracer: str = "auto",
    device: Any = None,
    workers: int | None = None,
    progress: bool = False,
) -> Estimate:
    """The irradiance of light from afar that the mesh does not block; faces reflect none. pi under a radiance of 1.

    Args:
        mesh: a Mesh or whatever `as_mesh` takes.
        points: P of them; as for `ambient_occlusion`.
        radiance: an equirectangular picture, (H, W) or (H, W, 3), numbers from 0 to 1e37, or the path of an .hdr or .npy
            file: row 0 is about `up`, columns go round it, counter-clockwise seen from there, for up = (0, 0, 1) from x
            towards y; read off bilinearly. Or a wp.func (direction: wp.vec3) -> float or wp.vec3, in the mesh's
            coordinates. A small bright sun takes many rays: they are spread by the cosine alone.
        count: rays of each point; none is cast where the radiance is 0.
        up: (3,), of any length; only for a picture.
        tolerance: see `ambient_occlusion`.
        sequence, seed, first_point, active, skip, tracer, device, workers, progress: see `RayOptions`.

    Returns:
        value (P,), or (P, 3) for a radiance of three numbers, in the radiance's unit times steradian, at least 0 where
        the radiance is; its standard error, and for each point the rays cast and a status.

    Raises:
        TypeError, ValueError: an argument that cannot be used; names it, what it got and what it wants.
        MemoryError: more than is free.

    Example:
        >>> mesh, sky = ws.load_mesh("courtyard"), np.linspace(2.0, 0.0, 16)[:, None].repeat(32, axis=1)  # bright above
        >>> light = ws.irradiance(mesh, ws.sample_surface(mesh, 100), sky, 64)
        >>> print(light.value.shape, 0.0 < light.value.min() < light.value.max() < 2.0 * np.pi)
        (100,) True
    """
    at = PlacedPoints.of(mesh, points)
    options = RayOptions.of(len(at), sequence=sequence, seed=seed, first_point=first_point, ids=at.id, active=active).by(
        skip=skip, tracer=tracer, device=device, workers=workers, progress=progress
    )
    plan = Plan.of(at, count, options, tolerance=tolerance)
    axis = as_unit(up, "up")
    if isinstance(radiance, wp.Function):
        with naming_function("radiance"):
            integrand = integrand_of(radiance, argument="radiance", device=options.memory.device)
            return estimate(plan, RaySum(integrand, unit=pi))
    picture = _picture(radiance)
    colour = picture.ndim == 3
    pixels = np.ascontiguousarray(np.broadcast_to(picture if colour else picture[..., None], (*picture.shape[:2], 3)))
    found = estimate(plan, RaySum(seen_in(pixels, axis), unit=pi))
    if colour:
        return found
    numbers = ("value", "standard_error", "spread", "degrees_of_freedom")
    return replace(found, **{name: getattr(found, name)[:, 0] for name in numbers})


def _picture(radiance: Any) -> np.ndarray:
    """A picture of radiances, (H, W) or (H, W, 3) float32; refuses anything else."""
    got = "got"
    if isinstance(radiance, str | PathLike):
        got, radiance = f"got {str(radiance)!r} with", read_picture(radiance)
    picture = as_real(radiance, "radiance", "an array of numbers, a path or a wp.func")
    if picture.ndim not in (2, 3) or picture.shape[2:] not in ((), (3,)) or 0 in picture.shape:
        raise ValueError(f"radiance: {got} shape {picture.shape}, want (H, W) or (H, W, 3)")
    with np.errstate(over="ignore"):
        picture = picture.astype(np.float32)
    if not (picture.min() >= 0.0 and picture.max() <= _BRIGHTEST):
        raise ValueError(f"radiance: {got} numbers that are below 0, above {_BRIGHTEST:g} or not finite, want none of these")
    return picture
