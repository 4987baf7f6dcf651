"""Types, descriptions, defaults and checks of the options that many functions of the package share."""

import inspect
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import wraps
from typing import Any, TypedDict, TypeVar

import numpy as np

from warpsample.host.arguments import check_first_point, check_flag, check_seed
from warpsample.host.arrays import Array, check_active
from warpsample.host.device_memory import Memory
from warpsample.host.engine import check_workers

Call = TypeVar("Call", bound=Callable[..., Any])
Options = TypeVar("Options", bound="CallOptions")

DEFAULTS: dict[str, Any] = {
    "sequence": "fibonacci",
    "seed": 0,
    "first_point": 0,
    "active": None,
    "tolerance": None,
    "skip": True,
    "tracer": "auto",
    "device": None,
    "workers": None,
    "progress": False,
}
"""Default of each option that calls share, in the order of signatures."""


class SeedKeywords(TypedDict, total=False):
    """Keyword options of functions that draw random numbers."""

    seed: int
    """Random seed, an integer of 64 bits. Default: 0."""
    workers: int | None
    """Number of CPU threads, an integer. Default: None, the value of WARPSAMPLE_WORKERS or all cores."""


class CastKeywords(SeedKeywords, total=False):
    """Keyword options of functions that cast rays."""

    skip: bool
    """Whether to leave out rays whose answer is known. Changes no value. Default: True."""
    progress: bool
    """Whether to show a progress bar on a terminal or in a notebook. Default: False."""


class EstimateKeywords(CastKeywords, total=False):
    """Keyword options of functions that estimate a mean over directions."""

    sequence: str
    """Sequence of the rays, a name in `warpsample.sequences.names()`. Default: "fibonacci"."""
    tolerance: float | None
    """Root mean square of the standard errors to reach, in the result's unit. Default: None, all `count` rays."""
    tracer: str
    """Tracer, "wide", "warp" (`wp.Mesh`, skips no rays) or "auto": wide on the CPU, warp on CUDA. Default: "auto"."""
    device: Any
    """Warp device, such as "cuda:0", which computes in parts and returns NumPy arrays. Default: None, the CPU."""


class PointKeywords(TypedDict, total=False):
    """Keyword options of functions that return a row for each point."""

    first_point: int
    """Global id of row 0, an integer; 0 for points with an `id`. Default: 0."""
    active: Any
    """(P,) bool. Inactive points get 0 and a status, and cast no rays. Default: None, all points are active."""


class CastPointKeywords(CastKeywords, PointKeywords, total=False):
    """Keyword options of functions that cast rays from points."""


class RayKeywords(EstimateKeywords, PointKeywords, total=False):
    """Keyword options of functions that estimate a mean over directions at each point."""


def with_options(keywords: type, defaults: Mapping[str, Any] = DEFAULTS) -> Callable[[Call], Call]:
    """Decorate a function with `**options` so that unknown options raise a TypeError and its signature lists all.

    Args:
        keywords: TypedDict of the options.
        defaults: Default of each option, in the order of the signature. Other entries are ignored.
    """

    def decorate(function: Call) -> Call:
        plain, types, kind = inspect.signature(function), keywords.__annotations__, inspect.Parameter.KEYWORD_ONLY
        *own, _options = plain.parameters.values()
        known = ((name, default, types[name]) for name, default in defaults.items() if name in types)
        shared = (inspect.Parameter(name, kind, default=default, annotation=type) for name, default, type in known)
        signature = plain.replace(parameters=[*own, *shared])

        @wraps(function)
        def call(*arguments: Any, **options: Any) -> Any:
            for name in options:
                if name not in signature.parameters:
                    raise TypeError(
                        f"{name}: got an argument that {function.__name__} does not take, want one of "
                        f"{', '.join(signature.parameters)}"
                    )
            return function(*arguments, **options)

        call.__signature__ = signature  # type: ignore[attr-defined]
        return call  # type: ignore[return-value]

    return decorate


@dataclass(frozen=True, eq=False, kw_only=True)
class CallOptions:
    """Checked options that functions over points share: seed, ids, mask of active points, device, threads and progress.

    Attributes:
        ids: (P,) uint64, the global ids of all rows; None if they are counted from `first_point`.
        active: (P,) uint8, not 0 where a point is active; None if all are.
        memory: Memory of the device that kernels run on.
    """

    seed: int
    first_point: int
    ids: np.ndarray | None
    active: np.ndarray | None
    memory: Memory
    workers: int
    progress: bool

    @classmethod
    def of(
        cls, points: int, *, seed: Any = 0, first_point: Any = 0, ids: Any = None, active: Any = None, **how: Any
    ) -> "CallOptions":
        """Check the options of a call over `points` points, and return a `CallOptions`; `how` is as for `replace`."""
        return cls(
            seed=check_seed(seed),
            first_point=check_first_point(first_point, points, ids),
            ids=ids,
            active=check_active(active, points),
            **_ways(**how),
        )

    def replace(self: Options, **how: Any) -> Options:
        """Check new values of `device`, `workers` and `progress`, and return a copy with the new values.

        A wp.array `given` to the call, as the argument of the name `argument`, is computed with on its own device.
        """
        return replace(self, **_ways(**how))


def _ways(
    *,
    device: Any = None,
    workers: int | None = None,
    progress: bool = False,
    given: Array | None = None,
    argument: str = "",
) -> dict[str, Any]:
    """Check the options `device`, `workers` and `progress`, and return the corresponding fields of `CallOptions`."""
    return {
        "memory": Memory.of(device, given, argument),
        "workers": check_workers(workers),
        "progress": check_flag(progress, "progress"),
    }
