"""Two tracers, the 16-wide tree and wp.Mesh: the choice between them, and the functions that each provides."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

import warp as wp

from warpsample.host.arguments import check_choice
from warpsample.host.device_memory import at_home
from warpsample.tracing.builtin import builtin_any_query, builtin_query, prepare_builtin
from warpsample.tracing.queries import CHUNK_FLOATS, PREPARED, AcceleratorArgs
from warpsample.tracing.scene import Scene
from warpsample.tracing.wide.prepare import prepare_wide
from warpsample.tracing.wide.query import wide_query


@dataclass(frozen=True)
class Tracer:
    """Method to trace rays: functions that trace a ray, and functions that prepare mesh and rays.

    Attributes:
        name: name in the public argument `tracer`.
        prepare: function (chunk, rays) that computes the derived rows of the first rays of a chunk.
        floats: number of float32 in a chunk, with the derived rows.
        face_query: function any_hit -> query (Accelerator, ray, reach, scratch) -> (distance, face, nodes, leaves).
        distance_query: function any_hit -> query like that of `face_query`, from several start nodes. With any_hit, only
            whether its distance is finite is defined.
        accelerator: function (scene, device, workers) -> addresses that queries read, of the opaque faces. The first call
            builds the tree.
        skips: whether the tree supports searches other than rays, which find directions to skip.
        exact: whether rays hit needle-like faces at the right distance; else rays start farther off their faces.
    """

    name: str
    prepare: wp.Function
    floats: int
    face_query: Callable[[bool], wp.Function]
    distance_query: Callable[[bool], wp.Function]
    accelerator: Callable[[Scene, wp.Device, int], AcceleratorArgs]
    skips: bool
    exact: bool


WIDE = Tracer(
    "wide",
    prepare_wide,
    CHUNK_FLOATS,
    wide_query,
    partial(wide_query, several=True),
    lambda scene, _device, workers: scene.blockers(workers).accelerator(),
    skips=True,
    exact=True,
)
"""Tracer by the 16-wide tree, on the CPU."""

BUILTIN = Tracer(
    "warp",
    prepare_builtin,
    PREPARED,
    lambda _any_hit: builtin_query,  # the built-in any-hit query returns no face
    lambda any_hit: builtin_any_query if any_hit else builtin_query,
    lambda scene, device, _workers: scene.builtin(device),
    skips=False,
    exact=False,
)
"""Tracer by wp.Mesh, on any device."""

TRACERS = {tracer.name: tracer for tracer in (WIDE, BUILTIN)}


def tracer_of(name: Any, device: wp.Device) -> Tracer:
    """Return the tracer with a name for a device; "auto" is the wide tree on the CPU and wp.Mesh on CUDA.

    Raises:
        TypeError, ValueError: not the name of a tracer, or one that does not support the device.
    """
    check_choice(name, "tracer", ("auto", *TRACERS))
    if name == "wide" and not at_home(device):
        raise ValueError(
            f"tracer: got 'wide' for rays on {device}, want 'warp' or 'auto', because the 'wide' tracer needs the CPU"
        )
    if name == "auto":
        return WIDE if at_home(device) else BUILTIN
    return TRACERS[name]
