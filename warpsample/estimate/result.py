"""The result of an estimate: a number for each point, its error, and what was skipped."""

from dataclasses import dataclass, fields
from enum import IntEnum
from math import inf
from typing import TYPE_CHECKING, Any, ClassVar, Literal

import numpy as np
from numpy.typing import NDArray

from warpsample.directions.sample import Status
from warpsample.estimate.intervals import Interval, interval_of
from warpsample.estimate.lobes import NONFINITE_VALUE
from warpsample.host.arguments import check_choice, check_number
from warpsample.host.extras import missing
from warpsample.host.neighbours import kind_told
from warpsample.host.summary import Summary
from warpsample.host.vectors import as_directions
from warpsample.mesh.mesh import mesh_of
from warpsample.mesh.surface import SurfacePoints
from warpsample.tracing.sight.point import NONFINITE_POSITION

if TYPE_CHECKING:
    from pyvista import PolyData
    from xarray import Dataset


class PointStatus(IntEnum):
    """Why a point has a number or not."""

    OK = Status.OK
    INACTIVE = Status.INACTIVE
    ZERO_NORMAL = Status.ZERO_NORMAL
    NONFINITE_NORMAL = Status.NONFINITE_NORMAL
    NONFINITE_POSITION = NONFINITE_POSITION
    NONFINITE_VALUE = NONFINITE_VALUE


def status_of(points: SurfacePoints) -> np.ndarray:
    """(P,) uint8, a `PointStatus`: of points whose numbers no kernel makes, as the estimates have it."""
    normal = as_directions(points.normal)
    cases = {
        PointStatus.NONFINITE_NORMAL: ~np.isfinite(normal).all(axis=1),
        PointStatus.ZERO_NORMAL: ~normal.any(axis=1),
        PointStatus.NONFINITE_POSITION: ~np.isfinite(points.position).all(axis=1),
    }
    return np.select(list(cases.values()), [np.uint8(status) for status in cases], np.uint8(PointStatus.OK))


def has_status(status: np.ndarray, wanted: PointStatus) -> np.ndarray:
    """Which points have a status; NumPy is to see no `PointStatus`, only its int.

    Of an enum it looks attributes up on the class, by Python code, and drops what a signal's handler raises there: Ctrl-C.
    """
    return status == int(wanted)


@dataclass(frozen=True)
class Skipped:
    """How much work was skipped, without a change to the result.

    Attributes:
        points: without a number: inactive, without a normal, nowhere.
        open_points: that no ray was cast from, since nothing is where it would go.
        empty_rays: in parts of the lobe that meet nothing, of `open_points` or others; their answer is known.
        weightless_rays: below the sky's horizon, or where the radiance is 0.
        unneeded_rays: that `tolerance` saved, less those of the trial that told so.
    """

    points: int = 0
    open_points: int = 0
    empty_rays: int = 0
    weightless_rays: int = 0
    unneeded_rays: int = 0


class PointResult(Summary):
    """What results of P points have in common: a `status` of each, and ways to PyVista and xarray."""

    status: NDArray[np.uint8]

    _axes: ClassVar[tuple[str, ...]] = ("component",)
    """What the columns of an array with a row for each point are called."""

    def counts(self) -> dict[PointStatus, int]:
        """How many points have each status; those that occur.

        Returns:
            {status: number of points, at least 1}.

        Example:
            >>> mesh, active = ws.load_mesh("courtyard"), np.arange(100) < 40
            >>> found = ws.ambient_occlusion(mesh, ws.sample_surface(mesh, 100), 64, active=active)
            >>> print({status.name: number for status, number in found.counts().items()})
            {'OK': 40, 'INACTIVE': 60}
        """
        return {PointStatus(code): int(n) for code, n in enumerate(np.bincount(self.status)) if n}

    def _arrays(self) -> dict[str, np.ndarray]:
        """The fields that have a row for each point, by name."""
        kept = {item.name: getattr(self, item.name) for item in fields(self)}  # type: ignore[arg-type]
        arrays = {name: a for name, a in kept.items() if isinstance(a, np.ndarray) and a.dtype.kind != "M"}  # no hours
        return {name: a for name, a in arrays.items() if a.shape[:1] == self.status.shape and a.ndim < 3}

    def _coordinates(self) -> dict[str, np.ndarray]:
        """What is known of the columns of arrays, for `to_xarray`; nothing by default."""
        return {}

    def to_polydata(self, on: Any, at: Literal["vertices", "faces"] | None = None) -> "PolyData":
        """The numbers on what they are of, as PyVista's PolyData.

        Args:
            on: the SurfacePoints of the result; or the mesh (a Mesh or whatever `as_mesh` takes), if they were its
                vertices or the centres of its faces.
            at: which of the two; by default the one of which there are as many as numbers.

        Returns:
            a copy with an array for each field that has a row for each point: "value", "standard_error", "rays", "status"
            and what else there is.

        Raises:
            ModuleNotFoundError: PyVista is missing.
            TypeError: neither points nor a mesh.
            ValueError: another number of points, or as many vertices as faces and no `at`.

        Example:
            >>> mesh = ws.load_mesh("courtyard")
            >>> found = ws.ambient_occlusion(mesh, ws.face_centers(mesh), 64)
            >>> print(found.to_polydata(mesh).cell_data["value"].shape)
            (2080,)
        """
        if at is not None:
            check_choice(at, "at", ("vertices", "faces"))
        if isinstance(on, SurfacePoints):
            made, sizes = on.to_polydata(), {"points": len(on)}
        else:
            mesh = mesh_of(on, "on", "SurfacePoints, a warpsample.Mesh")
            made, sizes = mesh.to_polydata(), {"vertices": len(mesh.vertices), "faces": len(mesh.faces)}
        fit = [name for name, size in sizes.items() if size == len(self.status) and at in (None, name)]
        if len(fit) != 1:
            raise ValueError(f"on: got {sizes} for {len(self.status)} numbers, want as many of one kind; at={at!r}")
        data = made.cell_data if fit == ["faces"] else made.point_data
        for name, array in self._arrays().items():
            data[name] = array
        return made

    def to_xarray(self, points: SurfacePoints) -> "Dataset":
        """The numbers as a dataset of xarray, with where the points are as coordinates.

        Args:
            points: the P points that they are of.

        Returns:
            a variable for each field that has a row for each point, of the dimension "point", and of "component", "patch" or
            "hour" where a point has several numbers; coordinates x, y, z, face, and id and hour where there are any.

        Raises:
            ModuleNotFoundError: xarray is missing.
            TypeError: no points.
            ValueError: another number of points.

        Example:
            >>> mesh = ws.load_mesh("courtyard")
            >>> points = ws.sample_surface(mesh, 9)
            >>> print(dict(ws.bent_normals(mesh, points, 64).to_xarray(points)["value"].sizes))
            {'point': 9, 'component': 3}
        """
        if not isinstance(points, SurfacePoints):
            raise TypeError(f"points: got {kind_told(points)}, want SurfacePoints")
        if len(points) != len(self.status):
            raise ValueError(f"points: got {len(points)}, want the {len(self.status)} of the numbers")
        try:
            from xarray import Dataset
        except ModuleNotFoundError:
            raise missing("datasets need xarray", "xarray") from None
        where = {axis: points.position[:, k] for k, axis in enumerate("xyz")} | {"face": points.face, "id": points.id}
        coordinates: dict[str, Any] = {name: ("point", a) for name, a in where.items() if a is not None}
        coordinates |= self._coordinates()
        arrays = self._arrays().items()
        return Dataset({name: (("point", *self._axes)[: a.ndim], a) for name, a in arrays}, coordinates)


@dataclass(frozen=True, eq=False, repr=False)
class ExactResult(PointResult):
    """Numbers of P points that rays of no random direction give.

    Attributes:
        value: (P,) or (P, 3) float32; 0 where the status is not 0.
        standard_error: float32, 0, of the same shape.
        rays: (P,) int32, the rays cast that are counted.
        status: (P,) uint8, a `PointStatus`.
    """

    value: NDArray[np.float32]
    standard_error: NDArray[np.float32]
    rays: NDArray[np.int32]
    status: NDArray[np.uint8]


@dataclass(frozen=True, eq=False, repr=False)
class Estimate(PointResult):
    """A number for each of P points.

    Attributes:
        value: (P,) float32, or (P, 3); 0 where the status is not 0.
        standard_error: of the same shape and unit, 0 where all rays agree. Its square is an unbiased estimate of the
            variance, from two independent randomisations of the rays of each stratum, of which there are few. For the range
            of the right value at a point see `interval`.
        spread: of the same shape and unit, the scale of the t distribution by which `interval` goes; never 0 where there is
            a number, but under no light.
        degrees_of_freedom: of the same shape, those of that distribution, float32: at least 1, or 0 without a number.
        rays: (P,) int32, rays cast, those of the trial of a `tolerance` among them.
        status: (P,) uint8, a `PointStatus`.
        skipped: what was not done.
    """

    value: NDArray[np.float32]
    standard_error: NDArray[np.float32]
    spread: NDArray[np.float32]
    degrees_of_freedom: NDArray[np.float32]
    rays: NDArray[np.int32]
    status: NDArray[np.uint8]
    skipped: Skipped

    possible: ClassVar[tuple[float, float]] = (-inf, inf)
    """The least and the greatest number that there can be."""

    def interval(self, level: float = 0.95) -> Interval:
        """Where the right number of each point lies: between the two in a share of about `level` of all estimates.

        value -+ spread * (the quantile of t), see `estimate.intervals`, clipped to the possible values: 0 to 1 for occlusion
        and sky view. From 32 rays on, 95 to 99 % of the intervals of 0.95 contain the right value on bunny and city, where
        points are not proven open; the room's README has other scenes. A picture's bright part that no ray has hit is in no
        interval. The interval is (value, value) where the status is not 0.

        Args:
            level: 0.01 to 0.9999.

        Returns:
            (lower, upper), each of `value`'s shape and unit.

        Raises:
            TypeError, ValueError: a level that is none.

        Example:
            >>> mesh = ws.load_mesh("courtyard")
            >>> found = ws.ambient_occlusion(mesh, ws.sample_surface(mesh, 100), 64)
            >>> lower, upper = found.interval(0.95)
            >>> print(lower.shape, (lower < found.value).all(), (found.value <= upper).all())
            (100,) True True
        """
        level = check_number(level, "level", 0.01, 0.9999)
        lower, upper = interval_of(self.value, self.spread, self.degrees_of_freedom, level)
        return Interval(*(np.clip(end, *np.float32(self.possible)) for end in (lower, upper)))


@dataclass(frozen=True, eq=False, repr=False)
class Share(Estimate):
    """An `Estimate` of a share, from 0 to 1."""

    possible: ClassVar[tuple[float, float]] = (0.0, 1.0)
