"""Checks of arguments, each with an error that names the argument, what it got and what it wants."""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from math import inf
from numbers import Real
from operator import index
from os import PathLike, fspath
from pathlib import Path
from typing import Any

import numpy as np

_LONGEST = 80  # characters of a value in a message
_FLAGS = (bool, np.bool_)


def told(value: Any) -> str:
    """`value` as a message shows it: short, on one line, and without an error of its own."""
    try:
        text = repr(value)
    except Exception:  # whatever the value's own code raises; Python itself refuses to print ints of 5,000 digits
        return f"a value of type {type(value).__name__}"
    text = " ".join(text.splitlines())
    return text if len(text) <= _LONGEST else f"{text[: _LONGEST - 3]}..."


def check_flag(value: Any, argument: str) -> bool:
    """`value` as a bool, or a TypeError: "no" and 2 are true to Python, and mean nothing here."""
    if not isinstance(value, _FLAGS):
        raise TypeError(f"{argument}: got {told(value)}, want True or False")
    return bool(value)


def check_choice(value: Any, argument: str, choices: Sequence[str]) -> str:
    """`value`, if it is one of the names; a TypeError for what is no string, a ValueError for another one."""
    if not isinstance(value, str) or value not in choices:
        kind = ValueError if isinstance(value, str) else TypeError
        raise kind(f"{argument}: got {told(value)}, want one of {', '.join(choices)}")
    return value


def check_file(value: Any, argument: str, wants: str) -> Path:
    """`value` as the path of a file that exists; a TypeError for what is no path.

    A FileNotFoundError is also for a folder, and for a device or a pipe, which may never end.
    """
    if not isinstance(value, str | PathLike) or not isinstance(fspath(value), str):
        raise TypeError(f"{argument}: got {told(value)}, want the path of {wants}")
    path = Path(value)
    if flaw := _flaw(path):
        raise FileNotFoundError(f"{argument}: got {str(path)!r}, which is {flaw}, want {wants}")
    return path


def _flaw(path: Path) -> str:
    try:
        return "" if path.is_file() else "a folder" if path.is_dir() else "no ordinary file" if path.exists() else "missing"
    except (OSError, ValueError):  # too long a name, a folder that may not be read, a zero byte
        return "out of reach"


@contextmanager
def naming_file(argument: str, path: Path, wants: str) -> Iterator[None]:
    """Wraps the reader of a file: whatever it raises on a damaged file becomes one ValueError that names the file.

    ModuleNotFoundError, MemoryError and TimeoutError, as of a user's deadline, come as they are.
    """
    try:
        if not path.stat().st_size:
            raise ValueError("it is empty")
        yield
    except (ModuleNotFoundError, MemoryError, TimeoutError):
        raise
    except Exception as error:
        reason = (str(error).strip().splitlines() or [""])[0]
        if not isinstance(error, ValueError) or not reason:
            reason = f"{reason} ({type(error).__name__})".strip()
        raise ValueError(f"{argument}: got {str(path)!r}, which cannot be read as {wants}: {reason}") from error


def check_integer(value: Any, argument: str, low: int, high: int, wants: str | None = None) -> int:
    """`value` as an int: a TypeError for what is no whole number, a ValueError for one outside [low, high]."""
    if type(value) is int and low <= value <= high:
        return value
    wants = wants or (f"a whole number of at least {low}" if high >= 2**62 else f"a whole number from {low} to {high}")
    try:
        number = index(None if isinstance(value, (*_FLAGS, np.ma.MaskedArray)) else value)
    except TypeError:
        raise TypeError(f"{argument}: got {told(value)}, want {wants}") from None
    if not low <= number <= high:
        raise ValueError(f"{argument}: got {told(number)}, want {wants}")
    return number


def check_number(value: Any, argument: str, low: float, high: float) -> float:
    """`value` as a float: a TypeError for what is no real number, a ValueError for NaN and outside [low, high]."""
    wants = f"a number from {low:g} to {high:g}"
    if not isinstance(value, Real) or isinstance(value, bool):
        raise TypeError(f"{argument}: got {told(value)}, want {wants}")
    try:
        number = float(value)
    except OverflowError:  # an int beyond float64
        number = inf if value > 0 else -inf
    if not low <= number <= high:
        raise ValueError(f"{argument}: got {told(value)}, want {wants}")
    return number


def check_scale(scale: Any) -> float:
    """A length that directions are drawn by, within what float32 holds."""
    return check_number(scale, "scale", -1e30, 1e30)


def check_seed(seed: Any) -> int:
    """A seed of 64 bits."""
    return check_integer(seed, "seed", 0, 2**64 - 1, "a whole number of 64 bits, 0 to 2^64 - 1")


def check_first_point(first_point: Any, points: int, ids: Any = None) -> int:
    """A global point id that leaves room for `points` ids of 64 bits; with ids of their own, 0."""
    if ids is not None:
        return check_integer(first_point, "first_point", 0, 0, "0 for points that have ids of their own, `id`")
    return check_integer(first_point, "first_point", 0, 2**64 - points, f"an id of 64 bits with room for {points} points")
