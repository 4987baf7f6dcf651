"""Starts and directions of rays from faces, by a four-dimensional lattice, and the codes that record hits."""

from fractions import Fraction

import warp as wp

from warpsample.distributions.cosine_hemisphere import square_to_cosine_hemisphere
from warpsample.maths.frames import to_world
from warpsample.maths.memory import vec3_at, vec3i_at
from warpsample.maths.numerics import HALF, ONE, ZERO, uniform_from_bits, weyl
from warpsample.tracing.placement import extent_along, in_double, offset_within
from warpsample.tracing.queries import Glass
from warpsample.tracing.sight.point import HORIZON_MARGIN

SKY, GROUND, BACK = -1, -2, -3
"""Codes of rays: SKY and GROUND for rays that hit nothing, above or below the horizon; BACK - face for a hit of a face's
back. The code of a hit of a front is the number of the face."""

# 2^64 / g, / g^2, / g^3 for the root g of g^4 = g + 1, rounded to odd: the steps along a face and in azimuth.
_STEP_A = wp.constant(wp.uint64(0xD1B54A32D192ED03))
_STEP_B = wp.constant(wp.uint64(0xABC98388FB8FAC03))
_STEP_TURN = wp.constant(wp.uint64(0x8CB92BA72F3D8DD7))
_BIT = wp.constant(wp.uint32(1))
_CELL = wp.constant(wp.float64(2.0**-31))
_INWARDS = wp.constant(wp.float64(4.0))
_ROUNDINGS = wp.constant(wp.float64(2.0**-22))


@wp.struct
class FaceRays:
    """Kernel argument that describes the rays of some faces of a scene: scalars, and addresses of arrays.

    rows: (B,) int32, the faces. codes: (B, replicates, per_replicate) int32, result of each ray, see SKY. vertices,
    triangles: (V, 3) float32 and (F, 3) int32 of the scene; normals: (F, 3) float32, unit. step: 2^64 / per_replicate, step
    of sin^2 theta from ray to ray. first_face: global id of face 0. extent, coarseness: of the scene; they give the distance
    of starts from their face. up: axis of the sky. glass: transmitting faces, if any; then weights: (B, replicates,
    per_replicate) float32, share of light that these faces transmit to the end of each ray.
    """

    rows: wp.uint64
    codes: wp.uint64
    vertices: wp.uint64
    triangles: wp.uint64
    normals: wp.uint64
    seed: wp.uint64
    first_face: wp.uint64
    replicates: wp.int32
    per_replicate: wp.int32
    step: wp.uint64
    extent: wp.vec3
    coarseness: wp.float32
    up: wp.vec3
    weights: wp.uint64
    glass: Glass


FaceRaysArgs = type(FaceRays().__ctype__())


def step_of(per_replicate: int) -> int:
    """Return 2^64 / per_replicate, rounded: the step with which a lattice places that many rays; 0 for a single ray."""
    return round(Fraction(1 << 64, per_replicate)) if per_replicate > 1 else 0


@wp.struct
class Face:
    """Face prepared to cast rays: corner a, sides b and c as vectors, normal n, and offset of the rays' starts.

    inner_a, inner_b, inner_c: least barycentric weights of the corners.
    """

    a: wp.vec3d
    b: wp.vec3d
    c: wp.vec3d
    n: wp.vec3
    offset: wp.float64
    inner_a: wp.float64
    inner_b: wp.float64
    inner_c: wp.float64


@wp.func
def face_at(rays: FaceRays, face: wp.int32) -> Face:
    """Prepare a face to cast rays; the starts keep a small distance from the face's sides.

    A start nearer to a side than four offsets and eight roundings could lie behind an adjacent face, and see out of a closed
    room, if the two faces meet at an angle of 14 degrees or more. Such starts are moved inwards. This changes factors by the
    square of (distance / face size), a negligible share. Starts are moved by at most half of the face.
    """
    corners = vec3i_at(rays.triangles, face)
    f = Face()
    f.a = in_double(vec3_at(rays.vertices, corners[0]))
    f.b = in_double(vec3_at(rays.vertices, corners[1])) - f.a
    f.c = in_double(vec3_at(rays.vertices, corners[2])) - f.a
    f.n = vec3_at(rays.normals, face)
    extent = rays.extent
    f.offset = wp.float64(offset_within(extent, rays.coarseness, f.n))
    inwards = _INWARDS * f.offset + _ROUNDINGS * wp.float64(extent[0] + extent[1] + extent[2])
    area = wp.length(wp.cross(f.b, f.c))
    share = inwards / wp.max(area, wp.float64(1e-300))
    f.inner_a = share * wp.length(f.c - f.b)
    f.inner_b = share * wp.length(f.c)
    f.inner_c = share * wp.length(f.b)
    too_much = wp.max(ONE, (f.inner_a + f.inner_b + f.inner_c) / HALF)
    f.inner_a = f.inner_a / too_much
    f.inner_b = f.inner_b / too_much
    f.inner_c = f.inner_c / too_much
    return f


@wp.func
def _uniform(bits: wp.uint32) -> wp.float64:
    """Map 32 random bits to a float64 number in (0, 1), from the upper 31 bits."""
    return (wp.float64(wp.int32(bits >> _BIT)) + HALF) * _CELL


@wp.func
def direction_of(frame: wp.mat33, key: wp.vec4ui, step: wp.uint64, i: wp.uint32) -> wp.vec3:
    """Return the direction of the i-th ray of a face, cosine-weighted about the normal."""
    radius = weyl(i, step) + wp.uint32(step >> wp.uint64(33)) + key[0]
    turn = weyl(i, _STEP_TURN) + key[1]
    return to_world(frame, square_to_cosine_hemisphere(wp.vec2(uniform_from_bits(radius), uniform_from_bits(turn))))


@wp.func
def start_of(f: Face, key: wp.vec4ui, i: wp.uint32) -> wp.vec3:
    """Return the start of the i-th ray of a face: a uniform point of the face, offset off the face.

    The point follows Turk1990, method 2.
    """
    root = wp.sqrt(_uniform(weyl(i, _STEP_A) + key[2]))
    split = _uniform(weyl(i, _STEP_B) + key[3])
    b = wp.max(root * (ONE - split) - f.inner_b, ZERO)
    c = wp.max(root * split - f.inner_c, ZERO)
    room = ONE - (f.inner_a + f.inner_b + f.inner_c)
    less = wp.min(ONE, room / wp.max(b + c, _CELL))
    b = f.inner_b + less * b
    c = f.inner_c + less * c
    return wp.vec3(
        wp.float32(f.a[0] + b * f.b[0] + c * f.c[0] + f.offset * wp.float64(f.n[0])),
        wp.float32(f.a[1] + b * f.b[1] + c * f.c[1] + f.offset * wp.float64(f.n[1])),
        wp.float32(f.a[2] + b * f.b[2] + c * f.c[2] + f.offset * wp.float64(f.n[2])),
    )


@wp.func
def lowest_start(f: Face) -> wp.float64:
    """Return the lowest height at which rays of a face start: a dot product with the face's normal."""
    along = in_double(f.n)
    return wp.dot(along, f.a) + wp.min(wp.min(wp.dot(along, f.b), wp.dot(along, f.c)), ZERO) + f.offset


@wp.func
def horizon_margin(rays: FaceRays, n: wp.vec3) -> wp.float32:
    """Return how far geometry must lie below a ray's start, along n, to be below the horizon in spite of rounding."""
    return HORIZON_MARGIN * extent_along(rays.extent, n)
