"""Results of estimates: values per point, standard errors, confidence intervals and statistics of skipped work."""

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
from warpsample.host.neighbours import describe_type
from warpsample.host.summary import Summary
from warpsample.host.vectors import as_directions
from warpsample.mesh.mesh import mesh_of
from warpsample.mesh.surface import SurfacePoints
from warpsample.tracing.sight.point import NONFINITE_POSITION

if TYPE_CHECKING:
    from pyvista import PolyData
    from xarray import Dataset


class PointStatus(IntEnum):
    """Status of a point: OK (0), or the reason why the point has no value.

    A point with the status INVALID_TANGENT has a value, for the frame that it would have without a tangent.
    """

    OK = Status.OK
    INACTIVE = Status.INACTIVE
    ZERO_NORMAL = Status.ZERO_NORMAL
    NONFINITE_NORMAL = Status.NONFINITE_NORMAL
    NONFINITE_POSITION = NONFINITE_POSITION
    NONFINITE_VALUE = NONFINITE_VALUE
    INVALID_PARAMETER = Status.INVALID_PARAMETER
    INVALID_TANGENT = Status.INVALID_TANGENT


def status_of(points: SurfacePoints) -> np.ndarray:
    """Return the status code of each point, (P,) uint8: OK, or the reason why its normal or position is invalid."""
    normal = as_directions(points.normal)
    cases = {
        PointStatus.NONFINITE_NORMAL: ~np.isfinite(normal).all(axis=1),
        PointStatus.ZERO_NORMAL: ~normal.any(axis=1),
        PointStatus.NONFINITE_POSITION: ~np.isfinite(points.position).all(axis=1),
    }
    return np.select(list(cases.values()), [np.uint8(status) for status in cases], np.uint8(PointStatus.OK))


def has_status(status: np.ndarray, wanted: PointStatus) -> np.ndarray:
    """Return the (P,) bool mask of the points with the status `wanted`.

    NumPy gets the status as an int. NumPy looks up attributes of an enum by Python code and drops exceptions that a signal
    handler raises there, such as KeyboardInterrupt.
    """
    return status == int(wanted)


def has_value(status: np.ndarray) -> np.ndarray:
    """Return the (P,) bool mask of the points with a value: of the status OK or INVALID_TANGENT."""
    return has_status(status, PointStatus.OK) | has_status(status, PointStatus.INVALID_TANGENT)


@dataclass(frozen=True)
class Skipped:
    """Counts of points and rays that were skipped without changing the result.

    Attributes:
        points: Number of points without a value: inactive, without a normal, or without a finite position.
        open_points: Number of points that cast no ray because the mesh has no face in their lobe.
        empty_rays: Number of rays not cast because their part of the lobe is proven empty, at any point.
        weightless_rays: Number of rays not cast because their weight is 0, as below the sky's horizon.
        unneeded_rays: Number of rays that `tolerance` saved, less the rays of the trial.
    """

    points: int = 0
    open_points: int = 0
    empty_rays: int = 0
    weightless_rays: int = 0
    unneeded_rays: int = 0


class PointResult(Summary):
    """Base class of results at P points: a `status` for each point, and conversion to PyVista and xarray."""

    status: NDArray[np.uint8]

    _axes: ClassVar[tuple[str, ...]] = ("component",)
    """Names of the dimensions after "point" of the result's arrays, for `to_xarray`."""

    def counts(self) -> dict[PointStatus, int]:
        """Return the number of points with each status, such as OK or ZERO_NORMAL.

        Returns:
            {status: number of points}, without statuses that no point has.

        Example:
            >>> mesh, active = ws.load_mesh("courtyard"), np.arange(100) < 40
            >>> found = ws.ambient_occlusion(mesh, ws.sample_surface(mesh, 100), 64, active=active)
            >>> print({status.name: number for status, number in found.counts().items()})
            {'OK': 40, 'INACTIVE': 60}
        """
        return {PointStatus(code): int(n) for code, n in enumerate(np.bincount(self.status)) if n}

    def _arrays(self) -> dict[str, np.ndarray]:
        """Return the arrays of the result with one row per point, keyed by name."""
        kept = {item.name: getattr(self, item.name) for item in fields(self)}  # type: ignore[arg-type]
        arrays = {name: a for name, a in kept.items() if isinstance(a, np.ndarray) and a.dtype.kind != "M"}  # no hours
        return {name: a for name, a in arrays.items() if a.shape[:1] == self.status.shape and a.ndim < 3}

    def _coordinates(self) -> dict[str, np.ndarray]:
        """Return additional coordinates of the result for `to_xarray`, keyed by dimension; none by default."""
        return {}

    def to_polydata(self, on: Any, at: Literal["vertices", "faces"] | None = None) -> "PolyData":
        """Return the points or the mesh as PyVista's PolyData, with the result's arrays as point data or cell data.

        Args:
            on: SurfacePoints of the result, or the mesh (anything that `as_mesh` accepts) whose vertices or face centers
                the points are.
            at: Location of the points on the mesh, "vertices" or "faces". Default: None, the one whose number matches.

        Returns:
            A copy with one array per field that has a row for each point, such as "value", "standard_error", "rays" and
            "status".

        Raises:
            ModuleNotFoundError: PyVista is missing.
            TypeError: `on` is neither points nor a mesh.
            ValueError: the number of points, vertices or faces differs from the result's, or vertices and faces both match
                and `at` is missing.

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
            shown = " and ".join(f"{size:,} {name}" for name, size in sizes.items())
            wants = "at= to choose one of the two" if fit else f"the same number of {at or ' or '.join(sizes)}"
            raise ValueError(f"on: got {shown} for {len(self.status)} values, want {wants}")
        data = made.cell_data if fit == ["faces"] else made.point_data
        for name, array in self._arrays().items():
            data[name] = array if len(array) else array.ravel()  # PyVista has no empty arrays of vectors
        return made

    def to_xarray(self, points: SurfacePoints) -> "Dataset":
        """Return the result as an xarray Dataset, with the points' positions as coordinates.

        Args:
            points: The P SurfacePoints of the result.

        Returns:
            A Dataset with one variable per field that has a row for each point. The dimensions are "point" and, where a
            point has several numbers, "component", "patch" or "hour". The coordinates are x, y and z, and face, id and hour
            where known.

        Raises:
            ModuleNotFoundError: xarray is missing.
            TypeError: `points` is not SurfacePoints.
            ValueError: the number of points differs from the result's.

        Example:
            >>> mesh = ws.load_mesh("courtyard")
            >>> points = ws.sample_surface(mesh, 9)
            >>> print(dict(ws.bent_normals(mesh, points, 64).to_xarray(points)["value"].sizes))
            {'point': 9, 'component': 3}
        """
        if not isinstance(points, SurfacePoints):
            raise TypeError(f"points: got {describe_type(points)}, want SurfacePoints")
        if len(points) != len(self.status):
            raise ValueError(f"points: got {len(points)} points, want the {len(self.status)} points of this result")
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
    """Exact values at P points, with a standard error of 0.

    Attributes:
        value: (P,) or (P, 3) float32, for positions float64; 0 where the status is neither OK nor INVALID_TANGENT.
        standard_error: Zeros, float32, of the shape of `value`.
        rays: Number of rays cast per point, (P,) int32.
        status: `PointStatus` of each point, (P,) uint8.
    """

    value: NDArray[np.float32]
    standard_error: NDArray[np.float32]
    rays: NDArray[np.int32]
    status: NDArray[np.uint8]


@dataclass(frozen=True, eq=False, repr=False)
class Estimate(PointResult):
    """Estimated values at P points, with standard errors and confidence intervals.

    Attributes:
        value: (P,) or (P, 3) float32; 0 where the status is neither OK nor INVALID_TANGENT.
        standard_error: float32, of the shape and unit of `value`; 0 where all rays agree. The square is an unbiased estimate
            of the variance, from two independent randomisations of the rays of each stratum. Strata are few: use `interval`
            for the range of the true value at a point.
        spread: Scale of the t distribution of `interval`, float32, of the shape and unit of `value`. It is 0 only at points
            without a value and where all rays have weight 0, unless the light is a picture.
        degrees_of_freedom: Degrees of freedom of that t distribution, float32, of the shape of `value`: at least 1, or 0 at
            points without a value.
        rays: Number of rays cast per point, (P,) int32. With `tolerance` the number includes the rays of the trial, and may
            exceed `count`.
        status: `PointStatus` of each point, (P,) uint8.
        skipped: Amount of skipped work.
    """

    value: NDArray[np.float32]
    standard_error: NDArray[np.float32]
    spread: NDArray[np.float32]
    degrees_of_freedom: NDArray[np.float32]
    rays: NDArray[np.int32]
    status: NDArray[np.uint8]
    skipped: Skipped

    possible: ClassVar[tuple[float, float]] = (-inf, inf)
    """Least and greatest possible value; intervals are clipped to this range."""

    open_is_exact: ClassVar[bool] = False
    """Whether the value of a point without rays does not depend on their directions."""

    @property
    def largest_error(self) -> NDArray[np.float32]:
        """Largest error of each value whose rays all agree, (P,): 0 where the value is exact, infinite if unknown."""
        return np.where((self.rays == 0) & self.open_is_exact, np.float32(0.0), np.float32(np.inf))

    def interval(self, level: float = 0.95) -> Interval:
        """Return a confidence interval for each point, which contains the true value with a probability of about `level`.

        The interval is value -+ spread * (quantile of Student's t), see `estimate.intervals`. It is clipped to the possible
        values, 0 to 1 for occlusion and sky view. With 32 rays or more, 95 to 99 % of the intervals of level 0.95 contain
        the true value on bunny and city, at points that are not proven open; `estimate/README.md` lists other scenes. The
        interval does not account for a part of a picture that is far brighter than its mean and that no ray has hit. It is
        (value, value) where the status is not 0.

        Args:
            level: Confidence level, 0.01 to 0.9999. Default: 0.95.

        Returns:
            (lower, upper), each of the shape and unit of `value`.

        Raises:
            TypeError, ValueError: `level` is not a number from 0.01 to 0.9999.

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
    """Estimate of a share: an `Estimate` whose values are from 0 to 1."""

    possible: ClassVar[tuple[float, float]] = (0.0, 1.0)


@dataclass(frozen=True, eq=False, repr=False)
class OpenShare(Share):
    """Estimate of the share of a point's rays that hit nothing."""

    open_is_exact: ClassVar[bool] = True
