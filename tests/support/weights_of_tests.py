"""Functions of a user's, at the top of a module of their own."""

import warp as wp

from warpsample import funcs


@wp.struct
class Data:
    """What an integrand may take."""

    scale: wp.float32


@wp.func
def upward(w: wp.vec3) -> float:
    """More light from above."""
    return 1.0 + w[2]


@wp.func
def by_point(w: wp.vec3, lobe: funcs.Lobe) -> float:
    """Another number for each point."""
    return w[2] * float(lobe.point)
