"""Calls that compute sky view, irradiation and sun hours at the centre of each cell of a raster."""

from typing import Any

import xarray as xr
from typing_extensions import Unpack

from warpsample.city.keywords import IrradiationKeywords, SkyKeywords, SunHoursKeywords
from warpsample.city.rasters.datasets import TREES_AND_TILES, compute_dataset
from warpsample.estimate.quantities.sky_view_factor import RECORD as SKY
from warpsample.estimate.quantities.visible_sky import RECORD as VISIBLE_SKY
from warpsample.host.options import with_options
from warpsample.radiation.quantities.irradiation import RECORD as IRRADIATION
from warpsample.radiation.quantities.sun_hours import RECORD as SUN_HOURS


@with_options(SkyKeywords, SKY.parameters | TREES_AND_TILES)
def sky_view_factor(
    source: Any,
    count: int = 256,
    *,
    model: str = "joined",
    receiver: str = "horizontal",
    **options: Unpack[SkyKeywords],
) -> xr.Dataset:
    """Compute the sky view factor (SVF) of each cell: the cosine-weighted fraction of the sky that is visible.

    SOLWEIG and UMEP use the same definition. The sky view factor times the diffuse irradiance of open ground is the
    irradiance of the cell under a uniform sky. By default, rays search for the horizon in each azimuth. Trees switch to rays
    over the whole sky, and so do values of `sequence`, `tolerance`, `tracer` and `device` other than the defaults. With
    tiles or distant terrain, the Earth's curvature is included outside the margin.

    Args:
        source: Raster of heights: a path, an xarray.DataArray with `rio.crs`, or (array, affine, CRS), see `surface`.
        count: Number of rays per cell. Default: 256.
        model: Surface of the heights, "joined", "block" or "tin", see `surface`. Default: "joined".
        receiver: "horizontal", or "surface" for the tilt of the cell, where 2 or 3 rays may give up to 1.9, noise about the
            right mean. Default: "horizontal".
        max_distance: Distance from which on hits are ignored, a float in map units. Default: None, no limit.
        sequence: Sequence of the rays, a name in `warpsample.sequences.names()`. Default: "fibonacci".
        seed: Random seed, an integer of 64 bits. Default: 0.
        tolerance: Root mean square of the standard errors to reach, in the result's unit. Default: None, all `count` rays.
        skip: Whether to leave out rays whose answer is known. Changes no value. Default: True.
        tracer: Tracer, "wide", "warp" (`wp.Mesh`, skips no rays) or "auto": wide on the CPU, warp on CUDA. Default: "auto".
        device: Warp device, such as "cuda:0", which computes in parts and returns NumPy arrays. Default: None, the CPU.
        workers: Number of CPU threads, an integer. Default: None, the value of WARPSAMPLE_WORKERS or all cores.
        progress: Whether to show a progress bar on a terminal or in a notebook. Default: False.
        canopy: Raster of the heights of tree crowns, as `source`, on the same cells; 0 is no tree. Default: None, no trees.
        trunk: Underside of the crowns, a share of their height from 0 to 1, or another raster. Default: 0.25.
        relative: Whether `canopy` and `trunk` are heights above the ground; False for elevations. Default: True.
        transmittance: Share of light that crowns transmit; with dates 12 shares for months or 365 for days. Default: 0.03.
        tile: Number of cells along each side of a tile, for rasters that exceed memory. Default: None, a single tile.
        margin: Number of full-resolution cells around a tile; cells outside are pooled, see `far_error`. Default: None, 256.
        far: Raster of the terrain around `source`, as `source`. Default: None, no terrain around it.

    Returns:
        Dataset of `value`, `standard_error` and `half_width` (y, x), NaN in cells without data, with the options as
        attributes. value -+ half_width is a 95 % confidence interval; `interval` computes other levels. With tiles also
        `far_error`, a bound of the error due to pooled terrain.

    Raises:
        TypeError, ValueError, FileNotFoundError: An argument that cannot be used; the message names the argument.
        MemoryError: The computation does not fit into the free memory.

    Example:
        >>> from affine import Affine
        >>> street = np.zeros((60, 60)); street[:, :20] = street[:, 40:] = 20.0
        >>> found = ws.rasters.sky_view_factor((street, Affine(1, 0, 0, 0, -1, 0), None), 1024)
        >>> print(found.value.shape, f"{found.value[30, 30]:.1f}")
        (60, 60) 0.5
    """
    return compute_dataset(SKY, source, {"count": count, **options}, model=model, receiver=receiver)


@with_options(SkyKeywords, VISIBLE_SKY.parameters | TREES_AND_TILES)
def visible_sky(source: Any, count: int = 256, *, model: str = "joined", **options: Unpack[SkyKeywords]) -> xr.Dataset:
    """Compute the fraction of the sky's solid angle that is visible from each cell, for any tilt of the receiver.

    RVT, xarray-spatial, GRASS r.skyview and WhiteboxTools call this fraction sky view factor.

    Args:
        source: Raster of heights: a path, an xarray.DataArray with `rio.crs`, or (array, affine, CRS), see `surface`.
        count: Number of rays per cell. Default: 256.
        model: Surface of the heights, "joined", "block" or "tin", see `surface`. Default: "joined".
        max_distance: Distance from which on hits are ignored, a float in map units. Default: None, no limit.
        sequence: Sequence of the rays, a name in `warpsample.sequences.names()`. Default: "fibonacci".
        seed: Random seed, an integer of 64 bits. Default: 0.
        tolerance: Root mean square of the standard errors to reach, in the result's unit. Default: None, all `count` rays.
        skip: Whether to leave out rays whose answer is known. Changes no value. Default: True.
        tracer: Tracer, "wide", "warp" (`wp.Mesh`, skips no rays) or "auto": wide on the CPU, warp on CUDA. Default: "auto".
        device: Warp device, such as "cuda:0", which computes in parts and returns NumPy arrays. Default: None, the CPU.
        workers: Number of CPU threads, an integer. Default: None, the value of WARPSAMPLE_WORKERS or all cores.
        progress: Whether to show a progress bar on a terminal or in a notebook. Default: False.
        canopy: Raster of the heights of tree crowns, as `source`, on the same cells; 0 is no tree. Default: None, no trees.
        trunk: Underside of the crowns, a share of their height from 0 to 1, or another raster. Default: 0.25.
        relative: Whether `canopy` and `trunk` are heights above the ground; False for elevations. Default: True.
        transmittance: Share of light that crowns transmit; with dates 12 shares for months or 365 for days. Default: 0.03.
        tile: Number of cells along each side of a tile, for rasters that exceed memory. Default: None, a single tile.
        margin: Number of full-resolution cells around a tile; cells outside are pooled, see `far_error`. Default: None, 256.
        far: Raster of the terrain around `source`, as `source`. Default: None, no terrain around it.

    Returns:
        Dataset with the arrays of `sky_view_factor`.

    Raises:
        TypeError, ValueError, FileNotFoundError: An argument that cannot be used; the message names the argument.
        MemoryError: The computation does not fit into the free memory.

    Example:
        >>> from affine import Affine
        >>> step = np.zeros((40, 40)); step[:, 20:] = 20.0
        >>> found = ws.rasters.visible_sky((step, Affine(1, 0, 0, 0, -1, 0), None))
        >>> print(f"{found.value[20, 19]:.1f}, {found.value[20, 30]:.1f}")
        0.5, 1.0
    """
    return compute_dataset(VISIBLE_SKY, source, {"count": count, **options}, model=model, receiver="horizontal")


@with_options(IrradiationKeywords, IRRADIATION.parameters | TREES_AND_TILES)
def irradiation(
    source: Any,
    weather: Any,
    *,
    model: str = "joined",
    receiver: str = "surface",
    **options: Unpack[IrradiationKeywords],
) -> xr.Dataset:
    """Compute the irradiation of each cell in kWh/m² from sun and sky, over a year or a period.

    The position of the sun is relative to true north at the middle of the raster.

    Args:
        source: Raster of heights: a path, an xarray.DataArray with `rio.crs`, or (array, affine, CRS), see `surface`.
        weather: Path of an EPW file of 8,760 hours, or "athens", an example.
        model: Surface of the heights, "joined", "block" or "tin", see `surface`. Default: "joined".
        receiver: "surface" for each m² of the tilted cell, whose area is its plan area over the cosine of its slope; or
            "horizontal". Default: "surface".
        ground_albedo: Albedo of the ground around the raster, a float from 0 to 1. Default: 0.2.
        period: First and last day, both included, as ("06-01", "08-31"), as for `warpsample.irradiation`. Default: None, the
            year.
        patches: Patches of the sky, "tregenza" (145), "reinhart2" (577) or "reinhart4" (2,305). Default: "reinhart2".
        count: Number of rays per cell to the sky, and the same number to the ground, 2 to 2^24. Default: 1024.
        seed: Random seed, an integer of 64 bits. Default: 0.
        skip: Whether to leave out rays whose answer is known. Changes no value. Default: True.
        workers: Number of CPU threads, an integer. Default: None, the value of WARPSAMPLE_WORKERS or all cores.
        progress: Whether to show a progress bar on a terminal or in a notebook. Default: False.
        canopy: Raster of the heights of tree crowns, as `source`, on the same cells; 0 is no tree. Default: None, no trees.
        trunk: Underside of the crowns, a share of their height from 0 to 1, or another raster. Default: 0.25.
        relative: Whether `canopy` and `trunk` are heights above the ground; False for elevations. Default: True.
        transmittance: Share of light that crowns transmit; with dates 12 shares for months or 365 for days. Default: 0.03.
        tile: Number of cells along each side of a tile, for rasters that exceed memory. Default: None, a single tile.
        margin: Number of full-resolution cells around a tile; cells outside are pooled, see `far_error`. Default: None, 256.
        far: Raster of the terrain around `source`, as `source`. Default: None, no terrain around it.

    Returns:
        Dataset with the arrays of `sky_view_factor`, in kWh/m².

    Raises:
        TypeError, ValueError, FileNotFoundError: An argument that cannot be used; the message names the argument.
        ModuleNotFoundError: pvlib or pyradiance is not installed; the message explains how to install both.
        MemoryError: The computation does not fit into the free memory.

    Example:
        >>> from affine import Affine
        >>> flat = (np.zeros((4, 4)), Affine(10, 0, 0, 0, -10, 0), None)
        >>> june = ws.rasters.irradiation(flat, "athens", period=("06-01", "06-30"), patches="tregenza")
        >>> print(f"{june.value.mean():.0f} {june.value.units}")
        270 kWh m-2
    """
    return compute_dataset(IRRADIATION, source, {"weather": weather, **options}, model=model, receiver=receiver)


@with_options(SunHoursKeywords, SUN_HOURS.parameters | TREES_AND_TILES)
def sun_hours(
    source: Any,
    weather: Any,
    *,
    model: str = "joined",
    receiver: str = "surface",
    **options: Unpack[SunHoursKeywords],
) -> xr.Dataset:
    """Count the hours of a year or a period during which the sun is visible from each cell.

    Args:
        source: Raster of heights: a path, an xarray.DataArray with `rio.crs`, or (array, affine, CRS), see `surface`.
        weather: Path of an EPW file of 8,760 hours, or "athens", an example.
        model: Surface of the heights, "joined", "block" or "tin", see `surface`. Default: "joined".
        receiver: "surface", which does not see the sun behind its own plane, or "horizontal". Default: "surface".
        period: First and last day, both included, as ("06-01", "08-31"), as for `warpsample.irradiation`. Default: None, the
            year.
        seed: Random seed, an integer of 64 bits. Default: 0.
        workers: Number of CPU threads, an integer. Default: None, the value of WARPSAMPLE_WORKERS or all cores.
        canopy: Raster of the heights of tree crowns, as `source`, on the same cells; 0 is no tree. Default: None, no trees.
        trunk: Underside of the crowns, a share of their height from 0 to 1, or another raster. Default: 0.25.
        relative: Whether `canopy` and `trunk` are heights above the ground; False for elevations. Default: True.
        transmittance: Share of light that crowns transmit; with dates 12 shares for months or 365 for days. Default: 0.03.
        tile: Number of cells along each side of a tile, for rasters that exceed memory. Default: None, a single tile.
        margin: Number of full-resolution cells around a tile; cells outside are pooled, see `far_error`. Default: None, 256.
        far: Raster of the terrain around `source`, as `source`. Default: None, no terrain around it.

    Returns:
        Dataset with the arrays of `sky_view_factor`, in hours. `standard_error` and `half_width` are 0, because the result
        is not random.

    Raises:
        TypeError, ValueError, FileNotFoundError: An argument that cannot be used; the message names the argument.
        ModuleNotFoundError: pvlib is not installed; the message explains how to install it.
        MemoryError: The computation does not fit into the free memory.

    Example:
        >>> from affine import Affine
        >>> flat = (np.zeros((4, 4)), Affine(10, 0, 0, 0, -10, 0), None)
        >>> print(float(ws.rasters.sun_hours(flat, "athens", period=("06-21", "06-21")).value.mean()))
        15.0
    """
    return compute_dataset(SUN_HOURS, source, {"weather": weather, **options}, model=model, receiver=receiver)
