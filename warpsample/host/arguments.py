"""Checks of arguments. Each error names the argument, the value that it got, and the values that are allowed."""

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


def quote(value: Any) -> str:
    """Return the text of a value for an error message: one line of at most 80 characters. Raise no error."""
    try:
        text = repr(value)
    except Exception:  # of the value's own code; Python itself refuses to print ints of 5,000 digits
        return f"a value of type {type(value).__name__}"
    text = " ".join(text.splitlines())
    return text if len(text) <= _LONGEST else f"{text[: _LONGEST - 3]}..."


def check_flag(value: Any, argument: str) -> bool:
    """Check that an argument is True or False, and return it as a bool.

    Raises:
        TypeError: the value is neither True nor False; "no" and 2 are true to Python, and are refused here.
    """
    if not isinstance(value, _FLAGS):
        raise TypeError(f"{argument}: got {quote(value)}, want True or False")
    return bool(value)


def check_choice(value: Any, argument: str, choices: Sequence[str]) -> str:
    """Check that an argument is one of the allowed names, and return it.

    Raises:
        TypeError: the value is no string.
        ValueError: the string is none of the choices.
    """
    if not isinstance(value, str) or value not in choices:
        kind = ValueError if isinstance(value, str) else TypeError
        raise kind(f"{argument}: got {quote(value)}, want one of {', '.join(choices)}")
    return value


def check_file(value: Any, argument: str, wants: str) -> Path:
    """Check that an argument is the path of an existing ordinary file, and return the path.

    Args:
        value: path, as a string or a `PathLike` of one.
        argument: name of the argument in errors.
        wants: noun phrase for the allowed files, as "an .hdr or .npy file".

    Raises:
        TypeError: the value is no path.
        FileNotFoundError: the file is missing, or is a folder, a device or a pipe; reading a pipe may never end.
    """
    if not isinstance(value, str | PathLike) or not isinstance(fspath(value), str):
        raise TypeError(f"{argument}: got {quote(value)}, want the path of {wants}")
    path = Path(value)
    if flaw := flaw_of(path):
        raise FileNotFoundError(f"{argument}: got {str(path)!r}, which is {flaw}, want {wants}")
    return path


def is_file(path: str | Path) -> bool:
    """Return whether a path is that of an ordinary file; False where `Path.is_file` raises an OSError."""
    return not flaw_of(Path(path))


def flaw_of(path: Path) -> str:
    """Return why a path cannot be read as a file, for example "a folder", or "" if it can."""
    try:
        return "" if path.is_file() else "a folder" if path.is_dir() else "no ordinary file" if path.exists() else "missing"
    except (OSError, ValueError):  # too long a name, a folder that may not be read, a zero byte
        return "out of reach"


@contextmanager
def naming_file(argument: str, path: Path, wants: str) -> Iterator[None]:
    """Convert any error within a `with` statement that reads a file to a ValueError that names the file.

    ModuleNotFoundError and MemoryError stay unchanged, and so does TimeoutError, as of a user's deadline.

    Args:
        argument: name of the argument in the error.
        path: file to be read.
        wants: noun for the content, as "a mesh".
    """
    try:
        if path.exists() and not path.stat().st_size:  # the built-in example is no file
            raise ValueError("the file is empty")
        yield
    except (ModuleNotFoundError, MemoryError, TimeoutError):
        raise
    except Exception as error:
        reason = (str(error).strip().splitlines() or [""])[0]
        if not isinstance(error, ValueError) or not reason:
            reason = f"{reason} ({type(error).__name__})".strip()
        raise ValueError(f"{argument}: got {str(path)!r}, which cannot be read as {wants}: {reason}") from error


def check_integer(value: Any, argument: str, low: int, high: int, wants: str | None = None) -> int:
    """Check that an argument is a whole number from `low` to `high`, and return it as an int.

    Raises:
        TypeError: the value is no whole number.
        ValueError: the number is outside [low, high].
    """
    if type(value) is int and low <= value <= high:
        return value
    wants = wants or (f"a whole number of at least {low}" if high >= 2**62 else f"a whole number from {low} to {high}")
    try:
        number = index(None if isinstance(value, (*_FLAGS, np.ma.MaskedArray)) else value)
    except TypeError:
        raise TypeError(f"{argument}: got {quote(value)}, want {wants}") from None
    if not low <= number <= high:
        raise ValueError(f"{argument}: got {quote(number)}, want {wants}")
    return number


def check_number(value: Any, argument: str, low: float, high: float) -> float:
    """Check that an argument is a real number from `low` to `high`, and return it as a float.

    Raises:
        TypeError: the value is no real number.
        ValueError: the number is NaN or outside [low, high].
    """
    wants = f"a number from {low:g} to {high:g}"
    if not isinstance(value, Real) or isinstance(value, bool):
        raise TypeError(f"{argument}: got {quote(value)}, want {wants}")
    try:
        number = float(value)
    except OverflowError:  # an int beyond float64
        number = inf if value > 0 else -inf
    if not low <= number <= high:
        raise ValueError(f"{argument}: got {quote(value)}, want {wants}")
    return number


def check_scale(scale: Any) -> float:
    """Check the length of drawn direction vectors, at most 1e30 so that float32 holds it, and return it as a float."""
    return check_number(scale, "scale", -1e30, 1e30)


def check_seed(seed: Any) -> int:
    """Check a seed, a whole number from 0 to 2^64 - 1, and return it as an int."""
    return check_integer(seed, "seed", 0, 2**64 - 1, "a whole number of 64 bits, 0 to 2^64 - 1")


def check_first_point(first_point: Any, points: int, ids: Any = None) -> int:
    """Check the global id of the first point, which must leave room for `points` ids of 64 bits, and return it.

    Only 0 is allowed where the points have `ids`. Errors are those of `check_integer`.
    """
    if ids is not None:
        return check_integer(first_point, "first_point", 0, 0, "0 for points that have their own ids, `id`")
    return check_integer(first_point, "first_point", 0, 2**64 - points, f"an id of 64 bits with room for {points} points")
