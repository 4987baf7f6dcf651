"""Fails a call of ours by which NumPy or SciPy computes a transcendental function in less than double precision.

NumPy has a float32 loop for each kind of processor (AVX2, AVX-512, neither), and they round differently: a test that judges
by the sine of a float32 judges the processor. Arithmetic, comparisons and square roots round alike everywhere (IEEE 754), as
does `**` where NumPy squares or takes the root; test_precision.py says what else may be written with it.
"""

import sys
from collections.abc import Callable
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import scipy.special

_OURS = (
    str(Path(find_spec("warpsample").origin).parent),
    *(str(Path(__file__).resolve().parents[2] / folder) for folder in ("tests", "viz")),
)
_EXACT = (  # with what compares, takes apart or selects, and products with one constant
    *("add", "conjugate", "divide", "divmod", "floor_divide", "fmod", "multiply", "reciprocal", "remainder", "square"),
    *("subtract", "negative", "positive", "fabs", "deg2rad", "degrees", "rad2deg", "radians"),
    *("copysign", "sign", "signbit", "heaviside", "isfinite", "isinf", "isnan", "logical_and", "logical_not", "logical_or"),
    *("logical_xor", "equal", "not_equal", "greater", "greater_equal", "less", "less_equal", "maximum", "minimum"),
    *("fmax", "fmin", "ceil", "floor", "rint", "trunc", "frexp", "ldexp", "modf", "nextafter", "spacing"),
)
_LINEAR = ("matmul", "matvec", "vecdot", "vecmat")  # sums of products: not transcendental
_REAL = ("absolute", "sqrt")  # exact but for complex numbers
_PLAIN = ("angle", "i0", "sinc")  # functions of NumPy's that call some of these inside
# What is timed as its users would write it, in float32: rays of peers, and of the embreex that confirms to 1e-4.
_TIMED = (
    ("tools/directions.py", "_map_polar"),
    ("tools/numpy_rays.py", "compute_cosine_directions"),
    ("tools/sky.py", "patch_of"),
)
_METHODS = ("reduce", "accumulate", "reduceat", "outer", "at")


class Watched:
    """Stands for a ufunc, a method of one or a function of arrays, and looks at what our own code had it compute in."""

    def __init__(self, function: Callable[..., Any], refused: str):
        self._function, self._refused = function, refused

    @property
    def __class__(self) -> type:
        return type(self._function)  # isinstance(np.sin, np.ufunc), as libraries ask, stays true

    def __call__(self, *arguments: Any, **keywords: Any) -> Any:
        found = self._function(*arguments, **keywords)  # first, so that its own errors stay what they are
        caller = sys._getframe(1)
        if _is_watched(caller.f_code.co_filename, caller.f_code.co_name):
            single = {kind.name for kind in self._inside(arguments, keywords.get("dtype")) if kind.char in self._refused}
            assert not single, (
                f"{caller.f_code.co_filename}:{caller.f_lineno}: "
                f"{self._function.__name__} in {', '.join(sorted(single))}, which each processor rounds otherwise: "
                "convert to float64 first"
            )
        return found

    def __getattr__(self, name: str) -> Any:
        found = getattr(self._function, name)
        return Watched(found, self._refused) if name in _METHODS else found

    def _inside(self, arguments: tuple[Any, ...], dtype: Any) -> list[np.dtype]:
        """What is computed in, once NumPy has converted: Python's numbers follow the arrays, short integers are float32."""
        if dtype is not None:
            return [np.dtype(dtype)]
        ufunc = self._function
        if not isinstance(ufunc, np.ufunc):
            return [np.asarray(argument).dtype for argument in arguments]
        given = [type(x) if type(x) in (int, float, complex) else np.asarray(x).dtype for x in arguments[: ufunc.nin]]
        return list(ufunc.resolve_dtypes((*given, *[None] * ufunc.nout))[: ufunc.nin])


@cache
def _is_watched(file: str, name: str) -> bool:
    return file.startswith(_OURS) and ("/".join(Path(file).parts[-2:]), name) not in _TIMED


def watch() -> None:
    """Starts to watch, for everything that is imported afterwards."""
    if type(np.sin) is Watched:  # a test imports conftest, which pytest has loaded under another name
        return
    assert "warpsample" not in sys.modules, "warpsample was imported before it is watched"
    for module in (np, scipy.special):
        _watch(module)


def _watch(module: ModuleType) -> None:
    for name, function in list(vars(module).items()):
        single = isinstance(function, np.ufunc) and any(set("fF") & set(kind.split("->")[0]) for kind in function.types)
        if single and function.__name__ not in (*_EXACT, *_LINEAR):
            setattr(module, name, Watched(function, "F" if function.__name__ in _REAL else "efF"))
        elif module is np and name in _PLAIN:
            setattr(module, name, Watched(function, "efF"))
