"""The options that calls share, said and checked once: what a call over points is told besides its own subject."""

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
    """A decorator for functions whose docstrings point to what others say of the arguments that they share.

    A line "seed, workers: see `Name`." under "Args:" becomes what the source of that name says of each: a function, or a
    class, whose methods say it.
    """
    texts = {source.__name__: _texts_of(source) for source in sources}

    def explained(pointer: re.Match[str]) -> str:
        return "".join(texts[pointer[2]][name] for name in pointer[1].split(", "))

    def explain(function: Call) -> Call:
        if function.__doc__:  # Python keeps none by -OO
            function.__doc__ = _POINTER.sub(explained, inspect.cleandoc(function.__doc__))
        return function

    return explain


def _texts_of(source: Any) -> dict[str, str]:
    """What docstrings say of each argument, whole lines by the argument's name."""
    owners = reversed(source.__mro__[:-1]) if inspect.isclass(source) else ()
    functions = [getattr(owner, name) for owner in owners for name in vars(owner) if not name.startswith("_")] or [source]
    arguments = ((inspect.getdoc(function) or "").partition("Args:\n")[2].partition("\n\n")[0] for function in functions)
    return {found[1]: found[0] for text in arguments for found in _ARGUMENT.finditer(f"{text}\n")}


@dataclass(frozen=True, eq=False, kw_only=True)
class CallOptions:
    """What calls over points have in common, checked: whose random numbers are drawn, and how they are computed.

    Attributes:
        seed: of 64 bits.
        first_point: the global id of row 0.
        ids: (P,) uint64, the global ids of all rows; None if they are counted from the first.
        active: (P,) uint8, not 0 where a point counts; None if all do.
        memory: where kernels run.
        workers: threads on the CPU.
        progress: whether to show a bar.
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
        """The options of a call over so many points.

        Args:
            points: how many.
            seed: of 64 bits.
            first_point: the global id of row 0; 0 if the points have their own, `SurfacePoints.id`.
            ids: (P,) uint64, those of `SurfacePoints`.
            active: (P,) bool; other points get 0 and a status, and cost next to nothing.
            how: what `by` takes; by default computed on the CPU by all cores.

        Raises:
            TypeError, ValueError: one that cannot be used; names it, what it got and what it wants.
        """
        return cls(
            seed=check_seed(seed),
            first_point=check_first_point(first_point, points, ids),
            ids=ids,
            active=check_active(active, points),
            **_ways(**how),
        )

    def by(self: Options, **how: Any) -> Options:
        """A copy of the options that are computed in another way.

        Args:
            device: where to compute, the CPU by default; on a CUDA device in parts, which come back as NumPy's arrays.
            workers: threads on the CPU, by default as many as WARPSAMPLE_WORKERS says, or as there are cores.
            progress: whether to show a bar, on a terminal or in a notebook; changes no bit.
            given: an array that the call was given, on whose device a wp.array is computed with.
            argument: what that array is called.

        Raises:
            TypeError, ValueError: one that cannot be used; names it, what it got and what it wants.
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
    """The fields that say how a call is computed, by the arguments of `CallOptions.by`."""
    return {
        "memory": Memory.of(device, given, argument),
        "workers": check_workers(workers),
        "progress": check_flag(progress, "progress"),
    }
