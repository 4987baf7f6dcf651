"""Options that all calls over points share, such as seed and device: their checks and their descriptions."""

import inspect
import re
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any, TypeVar

import numpy as np

from warpsample.host.arguments import check_first_point, check_flag, check_seed
from warpsample.host.arrays import Array, check_active
from warpsample.host.device_memory import Memory
from warpsample.host.engine import check_workers

_ARGUMENT = re.compile(r"^    (\w+): .*\n(?:        .*\n)*", re.MULTILINE)
_POINTER = re.compile(r"^    (\w+(?:, \w+)*): see `([\w.]+)`\.$\n?", re.MULTILINE)

Call = TypeVar("Call", bound=Callable[..., Any])
Options = TypeVar("Options", bound="CallOptions")


def explained_by(*sources: Any) -> Callable[[Call], Call]:
    """Return a decorator that copies descriptions of shared arguments into the docstring of a function.

    A line "seed, workers: see `Name`." under "Args:" is replaced by the descriptions of `seed` and `workers` in the
    docstring of the source with that name.

    Args:
        sources: functions, and classes whose methods describe the arguments.
    """
    texts = {source.__name__: _texts_of(source) for source in sources}

    def explained(pointer: re.Match[str]) -> str:
        return "".join(texts[pointer[2]][name] for name in pointer[1].split(", "))

    def explain(function: Call) -> Call:
        if function.__doc__:  # Python removes docstrings with -OO
            function.__doc__ = _POINTER.sub(explained, inspect.cleandoc(function.__doc__))
        return function

    return explain


def _texts_of(source: Any) -> dict[str, str]:
    """Return the descriptions of arguments in the docstrings of a source, as whole lines by the name of the argument."""
    owners = reversed(source.__mro__[:-1]) if inspect.isclass(source) else ()
    functions = [getattr(owner, name) for owner in owners for name in vars(owner) if not name.startswith("_")] or [source]
    arguments = ((inspect.getdoc(function) or "").partition("Args:\n")[2].partition("\n\n")[0] for function in functions)
    return {found[1]: found[0] for text in arguments for found in _ARGUMENT.finditer(f"{text}\n")}


@dataclass(frozen=True, eq=False, kw_only=True)
class CallOptions:
    """Checked options that all calls over points share.

    Attributes:
        seed: seed of all random numbers, 64 bits.
        first_point: global id of row 0.
        ids: (P,) uint64, global ids of all rows; None if the ids count up from `first_point`.
        active: (P,) uint8, not 0 for active points; None if all points are active.
        memory: memory and device of the kernels.
        workers: number of threads on the CPU.
        progress: whether to show a progress bar.
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
        cls,
        points: int,
        *,
        seed: Any = 0,
        first_point: Any = 0,
        ids: np.ndarray | None = None,
        active: Any = None,
        **how: Any,
    ) -> "CallOptions":
        """Check the options of a call and return a `CallOptions`.

        Args:
            points: number of points.
            seed: seed of the random numbers, 64 bits.
            first_point: global id of row 0; must be 0 if the points have their own ids, `SurfacePoints.id`.
            ids: (P,) uint64, the ids of `SurfacePoints`.
            active: (P,) bool; points that are not active get 0 and a status, and take almost no time.
            how: arguments of `by`; by default all cores of the CPU compute.

        Raises:
            TypeError, ValueError: an argument is not allowed; names the argument, its value and the allowed values.
        """
        return cls(
            seed=check_seed(seed),
            first_point=check_first_point(first_point, points, ids),
            ids=ids,
            active=check_active(active, points),
            **_ways(**how),
        )

    def by(self: Options, **how: Any) -> Options:
        """Return a copy of the options with another device, another number of threads, or a progress bar.

        Args:
            device: device that computes, by default the CPU; a CUDA device computes in parts, and results are NumPy arrays.
            workers: number of threads on the CPU, by default WARPSAMPLE_WORKERS or the number of cores.
            progress: whether to show a progress bar, on a terminal or in a notebook; changes no bit.
            given: array of the caller; with a wp.array its device computes.
            argument: name of that array in errors.

        Raises:
            TypeError, ValueError: an argument is not allowed; names the argument, its value and the allowed values.
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
    """Return the fields `memory`, `workers` and `progress` of the arguments of `CallOptions.by`."""
    return {
        "memory": Memory.of(device, given, argument),
        "workers": check_workers(workers),
        "progress": check_flag(progress, "progress"),
    }
