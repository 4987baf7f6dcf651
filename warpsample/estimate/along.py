"""Evaluation of an integrand along given directions, without points or a mesh."""

import numpy as np
import warp as wp

from warpsample.estimate.integrand import Integrand, Lobe
from warpsample.host.device_memory import Memory
from warpsample.host.engine import run
from warpsample.host.locks import once
from warpsample.maths.memory import set_vec3, vec3_at

_BLOCK = 256  # directions per task


def along(integrand: Integrand, directions: np.ndarray, workers: int) -> np.ndarray:
    """Evaluate a user-defined function of direction at M unit directions; return the values, (M, channels) float32.

    Args:
        integrand: Function to evaluate. The lobe's normal is the direction itself; the lobe's row and point id are 0.
        directions: (M, 3) contiguous float32 unit vectors.
        workers: Number of CPU threads.
    """
    made = np.empty((len(directions), 3), np.float32)
    if len(made):
        memory = Memory.of(None)
        with memory.loan() as loan:
            inputs = [len(made), loan.lend(directions), loan.output(made), integrand.data_for(loan)]
            kernel, tasks = _kernel(integrand.function, integrand.struct), -(-len(made) // _BLOCK)
            run(kernel, tasks, inputs, memory.device, workers=workers, work=len(made))
    return made[:, : integrand.channels]


@once
def _kernel(function: wp.Function, struct: type) -> wp.Kernel:
    """Build the Warp kernel that evaluates a function of direction for each direction of an array."""

    @wp.kernel(module="unique", enable_backward=False, grid_stride=False)
    def along(total: wp.int64, directions: wp.uint64, target: wp.uint64, data: struct, first_task: wp.int64):
        first = (first_task + wp.int64(wp.tid())) * wp.int64(_BLOCK)
        length = wp.int32(wp.min(wp.int64(_BLOCK), total - first))
        for i in range(length):
            at = first + wp.int64(i)
            lobe = Lobe()
            lobe.normal = vec3_at(directions, at)
            set_vec3(target, at, function(lobe.normal, lobe, data))

    return along
