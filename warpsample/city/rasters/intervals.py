"""Confidence intervals of results on rasters: half widths at 95 %, and conversion to other levels."""

from typing import Any

import numpy as np
import xarray as xr

from warpsample.estimate.intervals import DEGREES, LEVEL, half_width_of, interval_of, least_errors
from warpsample.estimate.result import Estimate
from warpsample.estimate.visibility import SkyView
from warpsample.host.arguments import check_number
from warpsample.host.neighbours import describe_type

_SHARES = ("ao", "sky", "visible-sky")


def errors_of(found: Any) -> tuple[np.ndarray, np.ndarray]:
    """Return (standard error, half width of the 95 % interval) at each point of a result, (P,) float32.

    The standard error of an estimate is 0 where the rays of each stratum agree, as below a crown with a small gap. Here it
    is at least the half width over 2.26, as for horizons. Both are 0 only at points without a value, and at points without
    rays that are proven to see the whole sky.
    """
    half = half_width_of(found)
    if isinstance(found, Estimate):
        is_open = (found.rays == 0) & (found.value == 1.0)
        if isinstance(found, SkyView):
            is_open &= found.below_horizon == 0.0
        half = np.where(is_open, np.float32(0.0), half)
        return np.maximum(found.standard_error, least_errors(half)), half
    return found.standard_error, half


def interval(dataset: xr.Dataset, level: float = LEVEL) -> xr.Dataset:
    """Return the lower and upper ends of the confidence interval of each cell of a raster result.

    The interval is value -+ half_width at a level of 0.95. At other levels the half width is scaled with the quantile of a t
    distribution with 9 degrees of freedom. A `far_error` is added on both sides. Intervals of fractions are clipped to 0 to
    1, others to at least 0.

    Args:
        dataset: Result of a call of `rasters`, or file of `warpsample bake`. Bands of a GeoTIFF need names:
            `rioxarray.open_rasterio(path, band_as_variable=True)`, then `dataset.rename(band_1="value",
            band_2="standard_error", band_3="half_width")`.
        level: Fraction of the cells whose interval contains the true value, 0.01 to 0.9999. Default: 0.95.

    Returns:
        Dataset of `lower` and `upper` (y, x), float32, in the unit of `value`; NaN in cells without data.

    Raises:
        TypeError: `dataset` is not a Dataset, or `level` not a number.
        ValueError: A dataset without `value` or `half_width`, or a level out of range.

    Example:
        >>> from affine import Affine
        >>> street = np.zeros((60, 60)); street[:, :20] = street[:, 40:] = 20.0
        >>> found = ws.rasters.sky_view_factor((street, Affine(1, 0, 0, 0, -1, 0), None), 1024)
        >>> ends = ws.rasters.interval(found, 0.95)
        >>> print(bool((ends.lower <= found.value).all()), bool((found.value <= ends.upper).all()))
        True True
    """
    if not isinstance(dataset, xr.Dataset):
        raise TypeError(f"dataset: got {describe_type(dataset)}, want an xarray.Dataset of warpsample.rasters")
    if not {"value", "half_width"} <= set(dataset):
        raise ValueError(f"dataset: got a dataset of {', '.join(map(str, dataset)) or 'nothing'}, want value and half_width")
    level = check_number(level, "level", 0.01, 0.9999)
    one, wanted = (float(interval_of(np.float64(0.0), 1.0, DEGREES, at).upper) for at in (LEVEL, level))
    half = dataset.half_width * np.float32(wanted / one) + dataset.get("far_error", np.float32(0.0))
    greatest = np.float32(1.0 if dataset.attrs.get("quantity") in _SHARES else np.inf)
    ends = {"lower": dataset.value - half, "upper": dataset.value + half}
    cut = xr.Dataset(ends, attrs=dataset.attrs | {"level": level}).clip(np.float32(0.0), greatest, keep_attrs=True)
    for name, end in cut.items():
        end.attrs = dataset.value.attrs | {"long_name": f"{name} end of the {100.0 * level:g} % confidence interval"}
    return cut
