"""Data for integrands, and the simplest integrands."""

import warp as wp


@wp.struct
class Sky:
    zenith: float
    horizon: float


@wp.struct
class Albedo:
    by_id: wp.array[wp.float32]


@wp.func
def one(w: wp.vec3) -> float:
    return 1.0


@wp.func
def direction(w: wp.vec3) -> wp.vec3:
    return w
