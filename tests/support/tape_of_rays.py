"""A script: rays of a user's kernel under wp.Tape, in a process of their own, as a wrong backward pass may end it."""

import numpy as np
import warp as wp

import warpsample as ws
from warpsample import funcs

wp.set_module_options({"optimization_level": 0})


@wp.kernel
def weigh(tree: funcs.Tree, heights: wp.array[wp.float32], weights: wp.array[wp.float32], out: wp.array[wp.float32]):
    i = wp.tid()
    origin = wp.vec3(0.25, 0.25, heights[i])
    down = wp.vec3(0.0, 0.1 * heights[i], -1.0)
    distance, face = funcs.nearest_hit(tree, origin, down, wp.INF)
    if face >= 0 and not funcs.any_hit(tree, origin, -down, wp.INF):
        wp.atomic_add(out, 0, weights[i] * distance)


if __name__ == "__main__":
    given = np.float32([(1.0, -1.0, 2.0), (3.0, 3.0, 3.0)])
    heights, weights = (wp.array(x, dtype=wp.float32, device="cpu", requires_grad=True) for x in given)
    out = wp.zeros(1, dtype=wp.float32, device="cpu", requires_grad=True)
    triangle = (np.eye(3) - [0.0, 0.0, 1.0]) * [2.0, 2.0, 0.0]
    with wp.Tape() as tape:
        wp.launch(weigh, 3, inputs=[ws.tree((triangle, [(0, 1, 2)])), heights, weights], outputs=[out], device="cpu")
    tape.backward(out)
    expected = np.array([np.hypot(1.0, 0.1), 0.0, 2.0 * np.hypot(1.0, 0.2)])
    assert np.allclose(weights.grad.numpy(), expected, rtol=1e-6), weights.grad.numpy()
    assert not heights.grad.numpy().any(), heights.grad.numpy()
