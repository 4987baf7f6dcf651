"""Checks of pictures of the whole sphere and of their orientation."""

from os import PathLike
from typing import Any

import numpy as np

from warpsample.distributions.lights.pixel_table import MOST_PIXELS
from warpsample.host.arguments import quote
from warpsample.host.arrays import as_real, as_unit
from warpsample.host.picture import read_picture

BRIGHTEST = 1e37
"""Largest number of a picture: pi times this number still fits into a float32."""

LUMINANCE = (0.2126, 0.7152, 0.0722)
"""Weights of red, green and blue in the luminance (ITU-R BT.709)."""

_LEAST_SINE = 1e-6  # of the angle between north and up


def as_picture(value: Any, argument: str, wants: str = "an array of numbers or a path") -> np.ndarray:
    """Read a picture, given as an array or a path, as an (H, W) or (H, W, 3) float32 copy.

    Raises:
        TypeError, ValueError: another shape, or numbers outside 0 to 1e37.
    """
    got = "got"
    if isinstance(value, str | PathLike):
        got, value = f"got {str(value)!r} with", read_picture(value, argument)
    picture = as_real(value, argument, wants)
    if picture.ndim not in (2, 3) or picture.shape[2:] not in ((), (3,)) or 0 in picture.shape:
        raise ValueError(f"{argument}: {got} shape {picture.shape}, want (H, W) or (H, W, 3)")
    with np.errstate(over="ignore"):
        picture = picture.astype(np.float32)
    if not (picture.min() >= 0.0 and picture.max() <= BRIGHTEST):
        raise ValueError(f"{argument}: {got} numbers below 0, above {BRIGHTEST:g} or not finite, want 0 to {BRIGHTEST:g}")
    return picture


def luminance_of(value: Any) -> np.ndarray:
    """Return the luminance of a picture, given as an array or a path, as a read-only (H, W) float32 copy.

    Raises:
        TypeError, ValueError: the picture cannot be used, is black, or has 32,768 rows or columns or more.
    """
    picture = as_picture(value, "picture")
    if max(picture.shape[:2]) >= MOST_PIXELS:
        raise ValueError(f"picture: got shape {picture.shape}, want fewer than {MOST_PIXELS:,} rows and columns")
    luminance = np.ascontiguousarray(picture if picture.ndim == 2 else weigh_colours(picture))
    if not luminance.max() > 0.0:
        raise ValueError(f"picture: got {' x '.join(map(str, picture.shape))} zeros, want a number above 0")
    luminance.setflags(write=False)
    return luminance


def weigh_colours(picture: np.ndarray) -> np.ndarray:
    """Return the luminance of (H, W, 3) colours, (H, W) float32; above 0 where any colour is."""
    luminance = np.zeros(picture.shape[:2], np.float32)
    for channel, weight in enumerate(LUMINANCE):
        luminance += np.float32(weight) * picture[..., channel]
    dim = (luminance == 0.0) & picture.any(axis=2)  # products that underflow
    luminance[dim] = np.float32(np.finfo(np.float32).smallest_subnormal)
    return luminance


def frame_of(up: Any, north: Any) -> tuple[Any, Any, np.ndarray]:
    """Check the orientation of a picture; return up and north as unit vectors, and the matrix from world to the picture.

    Raises:
        TypeError, ValueError: a vector cannot be used, or north is along up.
    """
    up = as_unit(up, "up")
    z = np.array(up)
    if north is None:
        return up, None, _frame_about(z)
    north = as_unit(north, "north")
    across = np.cross(north, z)
    length = np.sqrt(across @ across)
    if length < _LEAST_SINE:
        raise ValueError(f"north: got {quote(north)}, want a vector that is not along up")
    x = across / length
    return up, north, np.stack([x, np.cross(z, x), z])


def _frame_about(n: np.ndarray) -> np.ndarray:
    """Return the frame of `maths.frames.frame_about` in float64, with its axes in rows (Duff2017)."""
    x, y, z = n
    sign = np.copysign(1.0, z)
    a = -1.0 / (sign + z)
    b = x * y * a
    return np.array([[1.0 + sign * x * x * a, sign * b, -sign * x], [b, sign + y * y * a, -y], [x, y, z]])
