"""Which tracer answers for rays, and all that depends on it; `trace`, the estimates and the benchmarks ask once."""

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
    """A way to trace rays.

    Attributes:
        name: what users call it by.
        prepare: (chunk, rays): adds to the first rays of a chunk what a query needs.
        face_query: any_hit -> (Accelerator, ray, reach, scratch) -> (distance, face, nodes, leaves) of one ray.
        distance_query: the same, from several nodes; with any_hit it tells only whether something is met.
        floats: of a chunk of rays with what is added to them.
        accelerator: (scene, device, workers) -> what the queries search, of the opaque faces, built at the first call.
        skips: whether its tree can be searched for what the rays of a point need not look at, and starts can be found in it.
    """

    name: str
    prepare: wp.Function
    floats: int
    face_query: Callable[[bool], wp.Function]
    distance_query: Callable[[bool], wp.Function]
    accelerator: Callable[[Scene, wp.Device, int], AcceleratorArgs]
    skips: bool


WIDE = Tracer(
    "wide",
    prepare_wide,
    CHUNK_FLOATS,
    wide_query,
    partial(wide_query, several=True),
    lambda scene, _device, workers: scene.blockers(workers).accelerator(),
    skips=True,
)
"""The 16-wide tree, on the CPU."""

BUILTIN = Tracer(
    "warp",
    prepare_builtin,
    PREPARED,
    lambda _any_hit: builtin_query,  # the built-in any-hit query tells no face
    lambda any_hit: builtin_any_query if any_hit else builtin_query,
    lambda scene, device, _workers: scene.builtin(device),
    skips=False,
)
"""wp.Mesh, on any device."""

TRACERS = {tracer.name: tracer for tracer in (WIDE, BUILTIN)}


def tracer_of(name: Any, device: wp.Device) -> Tracer:
    """The tracer to use on a device: by "auto" the wide tree on the CPU.

    Raises:
        TypeError, ValueError: not a tracer, or not one for that device.
    """
    check_choice(name, "tracer", ("auto", *TRACERS))
    if name == "wide" and not at_home(device):
        raise ValueError(f"tracer: got 'wide' for rays on {device}, want 'warp' or 'auto': the wide tree is for the CPU")
    if name == "auto":
        return WIDE if at_home(device) else BUILTIN
    return TRACERS[name]
