"""Distribution of directions by the luminance of a picture of the whole sphere, such as an environment map of a sky."""

from dataclasses import dataclass
from functools import cached_property
from math import pi
from typing import Any, ClassVar

import numpy as np
import warp as wp

from warpsample.distributions.lights.picture import frame_of, luminance_of
from warpsample.distributions.lights.pixel_draws import (
    environment_map_to_square,
    pixel_drawer,
    square_to_environment_map,
    square_to_environment_map_pdf,
)
from warpsample.distributions.lights.pixel_table import MOST_STEPS, build_table, pixel_angles, read_shares, read_steps
from warpsample.distributions.parameters import Parameters, about_normal_of, bind_parameters, split_address
from warpsample.distributions.record import Cases, Distribution, Maps
from warpsample.host.arguments import check_flag
from warpsample.host.device_memory import Loan
from warpsample.host.locks import once
from warpsample.host.shared_values import digest_of, find_or_make

_draw = pixel_drawer(MOST_STEPS)
_SEAM, _NARROW = 2.0**-10, 2.0**-5  # of the unit square


@once
def build_about_world(draw: wp.Function) -> wp.Function:
    """Build the wp.func (unit normal, u, Parameters) from a function (u, table) with directions in world coordinates."""
    read_table = bind_parameters(draw, wp.vec2, 1)

    @wp.func
    def about_world(n: wp.vec3, u: wp.vec2, parameters: Parameters):
        """Sample a direction towards a picture in world coordinates; return the direction and its density as a vec4."""
        return read_table(u, parameters)

    return about_world


def _sky(height: int, width: int) -> np.ndarray:
    """Return a picture for tests: a sky with a sun, a black row and black pixels."""
    r, c = np.ogrid[:height, :width]
    picture = 1.0 + np.square(np.sin(1.7 * r + 0.9 * c)) + 0.1 * c
    picture[height // 2, 1] = 1e3
    picture[height // 3, 0] = picture[-1, -1] = 0.0
    picture[height // 2 + 1] = 0.0
    return picture


@dataclass(frozen=True)
class EnvironmentMap(Distribution):
    """Directions towards an environment map, a picture of the whole sphere, with a density proportional to luminance.

    Directions, also those of `sample`, `pdf` and `invert`, are in world coordinates, whatever the normal. The
    density in a pixel of luminance L is constant, L / Σ L Ω per steradian, where Ω is the solid angle of a pixel. A pixel's
    share is a multiple of 2^-32 of its row; no pixel of luminance 0 is drawn.

    Attributes:
        picture: (H, W) luminance, or (H, W, 3) colours with the weights 0.2126, 0.7152 and 0.0722, numbers from 0 to 1e37
            with one above 0; or the path of an .hdr or .npy file. Row 0 is about `up`, columns go round it counter-clockwise
            seen from outside. It is copied, and kept as (H, W) float32 luminance.
        up: (3,) vector of any length towards row 0.
        north: (3,) vector of any length, not along `up`; column 0 begins at north x up. None is the layout of
            `ws.irradiance`, which is north = (0, 1, 0) for up = (0, 0, 1).
    """

    picture: Any
    up: Any = (0.0, 0.0, 1.0)
    north: Any = None

    name = "environment_map"
    density = "L/ΣLΩ, L=luminance, Ω=solid angle of a pixel"
    support = "sphere"
    parameters: ClassVar[tuple[str, ...]] = ("table",)
    source = "Pharr2023, section 12.5; guide tables: Chen1974"
    in_world = True
    limits = (
        "directions are in world coordinates. The share of a pixel is a multiple of 2⁻³² of its row. The error of the "
        "inverse is measured where a pixel fills 1/32 of the square's width and height"
    )
    case_values: ClassVar[Cases] = (
        (np.ones((4, 8)),),
        (_sky(8, 16),),
        (_sky(5, 4), (0.3, -0.4, 0.5), (0.1, 1.0, 0.2)),
        (_sky(3, 8), (0.6, 0.0, -0.8)),
        (np.ones((1, 1)), (0.0, 1.0, 0.0), (1.0, 0.0, 0.0)),
    )
    symmetric = False
    polar = False
    maps: ClassVar[Maps] = Maps(
        square_to_environment_map,
        square_to_environment_map_pdf,
        environment_map_to_square,
        draw=_draw,
        about=build_about_world(_draw),
    )
    _drawer: ClassVar[Any] = staticmethod(pixel_drawer)

    def __post_init__(self) -> None:
        """Check the picture and the vectors, and copy the picture as luminance."""
        object.__setattr__(self, "picture", luminance_of(self.picture))
        up, north, _ = frame_of(self.up, self.north)
        object.__setattr__(self, "up", up)
        object.__setattr__(self, "north", north)

    @property
    def by_point(self) -> dict[str, np.ndarray]:
        """Parameters with one row for each point: an empty dictionary, since all points share the picture."""
        return {}

    @property
    def stretch(self) -> tuple[tuple[float, ...], ...]:
        """Rotation from the picture's frame to the world, so that rows are bands about +z. See `Distribution`."""
        return tuple(map(tuple, self.frame.T.tolist()))

    @property
    def jumps(self) -> tuple[float, ...]:
        """Polar angles in radians of the edges between the picture's rows, where the density jumps. See `Distribution`."""
        height = len(self.picture)
        return tuple(pi * row / height for row in range(1, height))

    def seam(self, u: np.ndarray) -> np.ndarray:
        """Return a mask of points u that `invert` cannot recover precisely: near a pixel's edges, or in a narrow pixel."""
        rows, columns = self.shares()
        row = np.searchsorted(rows, u[..., 0], side="right") - 1
        column = (columns[row] <= u[..., 1, None]).sum(axis=-1) - 1
        found = np.zeros(u.shape[:-1], bool)
        for x, low, high in (
            (u[..., 0], rows[row], rows[row + 1]),
            (u[..., 1], columns[row, column], columns[row, column + 1]),
        ):
            found |= (x - low < _SEAM) | (high - x < _SEAM) | (high - low < _NARROW)
        return found

    def shares(self) -> tuple[np.ndarray, np.ndarray]:
        """Return the cumulative distribution functions of the rows, and of the pixels within each row.

        Returns:
            cumulative shares of the picture's light by row, (H + 1,) float64 from 0 to 1; cumulative shares by pixel within
            each row, (H, W + 1) float64.

        Example:
            >>> rows, pixels = ws.EnvironmentMap(np.array([[1.0, 3.0], [0.0, 4.0]])).shares()
            >>> print(rows, pixels[0])
            [0.  0.5 1. ] [0.   0.25 1.  ]
        """
        return read_shares(self.table_array)

    @property
    def frame(self) -> np.ndarray:
        """Matrix from world coordinates to the picture's frame, (3, 3) float64."""
        return frame_of(self.up, self.north)[2]

    @cached_property
    def table_array(self) -> np.ndarray:
        """Table of the picture's pixels that kernels sample from, as bytes; built at the first use, and not pickled.

        See `pixel_table`.
        """
        return find_or_make(f"{self.name} {self._content()}", self._build_table)

    def about(self, tangents: bool = False) -> wp.Function:
        """Return the wp.func that samples world directions, with as few search steps as the picture allows.

        The normal has no effect.

        Args:
            tangents: whether the first argument of the function is a frame. Default: False.

        Returns:
            a `wp.func` (unit normal or frame, u, Parameters) -> (world direction, pdf), see `Distribution`.

        Example:
            >>> print(type(ws.EnvironmentMap(np.ones((2, 4))).about()).__name__)
            Function
        """
        about = build_about_world(type(self)._drawer(read_steps(self.table_array)))
        return about_normal_of(about) if check_flag(tangents, "tangents") else about

    def _build_table(self) -> np.ndarray:
        """Build the table; see `table_array`."""
        return build_table(self.picture, self.frame, pixel_angles(len(self.picture)))

    @cached_property
    def _digest(self) -> str:
        """SHA-256 of the picture."""
        return digest_of(self.picture)

    @property
    def table(self) -> int:
        """Address of the picture's table, for kernels on the CPU; valid while this distribution exists."""
        return int(self.table_array.ctypes.data)

    def kernel_values(self, loan: Loan | None = None) -> tuple[Any, ...]:
        """Return the kernel parameter: the address of the pixel table on the kernels' device, split into float32 numbers."""
        return (split_address(self.table if loan is None else _lend_table(loan, self.table_array)),)

    def __getstate__(self) -> dict[str, Any]:
        """Return the fields to pickle: all but the table."""
        return {name: value for name, value in self.__dict__.items() if name != "table_array"}

    def _content(self) -> tuple[Any, ...]:
        """Return the fields, with a digest in place of the picture."""
        return self._digest, self.up, self.north


def list_picture_hashes(distribution: Distribution) -> list[str]:
    """Return the SHA-256 of each picture that a distribution or one of its nested lobes samples, in hexadecimal digits."""
    own = [digest_of(distribution.picture)] if isinstance(distribution, EnvironmentMap) else []
    return own + [found for lobe in distribution.nested.values() for found in list_picture_hashes(lobe)]


def _lend_table(loan: Loan, table: np.ndarray) -> int:
    """Return the address of the table of a picture in the memory of the kernels' device; copy the table if necessary."""
    if (
        loan.memory.in_place and not loan.memory.device.is_cpu
    ):  # arguments in wp.arrays on CUDA: the table needs a copy there
        return loan.lend(wp.array(table, dtype=wp.uint8, device=loan.memory.device))
    return loan.lend(table)


RECORD = EnvironmentMap
