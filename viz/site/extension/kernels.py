"""Functions for kernels: signatures in Warp's types, and example kernels."""

import inspect
import re
from typing import Any

import warp as wp

from warpsample import funcs

_SHOWN = {wp.vec2: "wp.vec2", wp.vec3: "wp.vec3", wp.vec3d: "wp.vec3d", wp.mat33: "wp.mat33", Any: "Any"}
_SHOWN |= {kind: f"wp.{kind.__name__}" for kind in (wp.float32, wp.uint32, wp.uint64, wp.int32)}
_ARGUMENTS = {
    "u": "u",
    "w": "w",
    "p": "w",
    "alpha": "0.3",
    "exponent": "10.0",
    "kappa": "10.0",
    "rho": "1.0",
    "one_minus_cos": "0.1",
    "alpha_y": "0.3",
    "g": "0.5",
    "matrix": "wp.identity(n=3, dtype=wp.float32)",
    "eta": "1.5",
    "cosine": "0.5",
    "corners": "wp.identity(n=3, dtype=wp.float32)",
    "corner": "wp.vec3(-1.0, -1.0, 1.0)",
    "edge_x": "wp.vec3(2.0, 0.0, 0.0)",
    "edge_y": "wp.vec3(0.0, 2.0, 0.0)",
    "m": "wp.vec3(0.0, 0.6, 0.8)",
    "view": "wp.vec3(0.6, 0.0, 0.8)",
    "seed": "wp.uint64(0)",
    "point": "wp.uint64(0)",
    "sample": "wp.uint32(i)",
    "count": "wp.uint32(256)",
    "table": "table",
    "tree": "tree",
    "position": "position[i]",
    "origin": "position[i]",
    "n": "normal[i]",
    "normal": "normal[i]",
    "frame": "funcs.frame_about(normal[i])",
    "tangent": "wp.vec4(1.0, 0.0, 0.0, 1.0)",
    "direction": "normal[i]",
    "max_distance": "10.0",
}
_ARRAY = re.compile(r"(?:~?numpy\.)?ndarray\[tuple\[(?:~?typing\.)?Any, \.\.\.\], (?:~?numpy\.)?dtype\[([^]]+)\]\]")
KERNEL = "tree: funcs.Tree, table: wp.uint64, position: wp.array[wp.vec3d], normal: wp.array[wp.vec3]"
"""Arguments of the kernel that contains the lines of an example."""


def home(item: Any) -> str | None:
    """Return the name of the module that defines a wp.func or a wp.struct; None for other objects."""
    if isinstance(item, wp.Function):
        return item.func.__module__
    return item.cls.__module__ if hasattr(item, "cls") else None


def format_type(kind: Any) -> str:
    """Format a type as a kernel writes it, such as "wp.vec3"."""
    return getattr(kind, "key", None) or _SHOWN.get(kind) or str(getattr(kind, "__name__", kind))


def signature(app: Any, what: str, name: str, item: Any, options: Any, text: str, returned: str) -> tuple[str, str] | None:  # noqa: ARG001
    """Format the signature of a documented function: Warp's types for a wp.func, and short array types for others."""
    if not isinstance(item, wp.Function):
        return tuple(part and _ARRAY.sub(r"NDArray[\1]", part) for part in (text, returned))
    found = inspect.signature(item.func)
    taken = ", ".join(f"{key}: {format_type(parameter.annotation)}" for key, parameter in found.parameters.items())
    given = found.return_annotation
    return f"({taken})", "" if given is inspect.Signature.empty else format_type(given)


def example(item: Any) -> str:
    """Return example lines of a kernel that calls a wp.func."""
    if not isinstance(item, wp.Function):
        return _STRUCTS[item.key]
    taken = set(inspect.signature(item.func).parameters)
    lines = ["i = wp.tid()"]
    if {"u", "w", "p"} & taken:
        lines.append("u = funcs.sobol(wp.uint64(0), wp.uint64(0), wp.uint32(i), wp.uint32(256))")
    if {"w", "p"} & taken:
        lines.append(f"w = {_format_call(_map_of(item.key))}")
    result = "distance, face" if item.key == "nearest_hit" else "x"
    return "\n".join([*lines, f"{result} = {_format_call(item)}"])


_STRUCTS = {
    "Tree": ">>> tree = ws.tree(ws.load_mesh('courtyard'))  # then wp.launch(kernel, dim, inputs=[tree, ...])",
    "Lobe": "@wp.func\ndef by_point(w: wp.vec3, lobe: funcs.Lobe) -> float:\n    return w[2] * float(lobe.point)",
}


def _map_of(key: str) -> Any:
    """Return the function that maps the unit square to directions, given the name of its density or its inverse.

    For other names it is the map of the cosine lobe.
    """
    if key.endswith("_pdf"):
        return getattr(funcs, key.removesuffix("_pdf"))
    shape, inverse, variant = key.partition("_to_square")
    return getattr(funcs, f"square_to_{shape}{variant}") if inverse else funcs.square_to_cosine_hemisphere


def _format_call(item: Any) -> str:
    return f"funcs.{item.key}({', '.join(_ARGUMENTS[key] for key in inspect.signature(item.func).parameters)})"
