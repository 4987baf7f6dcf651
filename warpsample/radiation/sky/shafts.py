"""The beams about sky patches: what is in one that a ray may meet, and whether one triangle fills it.

They are those of the estimates (`estimate.skipping.beams`), but they point to the sky and not about the normal.
"""

import numpy as np
import warp as wp

from warpsample.estimate.skipping.beams import boxes_in, triangles_in
from warpsample.estimate.skipping.frontier import NEAR
from warpsample.estimate.spot import Spot, start_beam
from warpsample.maths.memory import address_at
from warpsample.maths.numerics import lowest_bit
from warpsample.radiation.sky.patches import SkyPatches
from warpsample.tracing.wide.corners import corner, size_of
from warpsample.tracing.wide.layout import (
    BEAM_FLOATS,
    CORNERS,
    NODE_BYTES,
    PLANES,
    WIDTH,
    Accelerator,
    leaf_at,
    link_in,
    node_at,
)
from warpsample.tracing.wide.query import WAITING, put_aside

OPEN, CLOSED, UNKNOWN = 1, 2, 3
"""What is known of a patch: nothing is in it; one triangle fills it; neither."""

_OPEN = wp.constant(wp.int32(OPEN))
_CLOSED = wp.constant(wp.int32(CLOSED))
_UNKNOWN = wp.constant(wp.int32(UNKNOWN))
_VISITS = wp.constant(wp.int32(32))  # nodes and leaves that a beam may look into
_BEAM = wp.constant(wp.uint64(12 * WIDTH))
_INSIDE = wp.constant(wp.float32(2.0**-17))
"""Of an angle, by which a beam must be within a triangle: directions are rounded by less than 2^-20."""

_SECTORS = {"tregenza": 6, "reinhart2": 12, "reinhart4": 12}
"""Of each row: of a number of patches that it divides."""

_NOWHERE = wp.constant(wp.uint64(0))


def groups_of(patches: SkyPatches) -> np.ndarray:
    """(G + 1,) int32, where groups of neighbours in a row begin: all in a sector, so that one beam holds each group."""
    sectors = np.floor((patches.azimuths.mean(axis=1) + 1e-6) * _SECTORS[patches.name] / 360.0)
    changes = (np.diff(patches.rows) != 0) | (np.diff(sectors) != 0)
    return np.array([0, *(np.flatnonzero(changes) + 1), len(patches)], np.int32)


def beams_of(patches: SkyPatches, starts: np.ndarray) -> np.ndarray:
    """(G, 3, 16) float32, the vectors of the beams about groups of patches, as in `estimate.cells`: planes and corners.

    The planes are the horizon's, which the point's own takes the place of; two at the azimuths; one through the upper
    corners, and one that touches the lower edge in its middle. About the cap, the last, there is a square pyramid.

    Args:
        patches: of the sky.
        starts: (G + 1,), where groups of neighbours in a row begin, and their end.
    """
    low, high = np.radians(patches.altitudes[starts[:-1]]).T
    first, last = np.radians(patches.azimuths[starts[:-1], 0]), np.radians(patches.azimuths[starts[1:] - 1, 1])
    middle, half = 0.5 * (first + last), np.cos(0.5 * (last - first))
    vectors = np.zeros((len(low), WIDTH, 3))
    vectors[:, 0, 2] = 1.0
    vectors[:, 1] = np.stack([np.cos(first), -np.sin(first), 0.0 * first], axis=1)
    vectors[:, 2] = np.stack([-np.cos(last), np.sin(last), 0.0 * last], axis=1)
    vectors[:, 3] = _towards(middle, np.sin(high), -np.cos(high) * half)
    vectors[:, 4] = _towards(middle, -np.sin(low), np.cos(low))
    for i, azimuth in enumerate((first, last)):
        vectors[:, PLANES + 2 * i] = _towards(azimuth, np.cos(high), np.sin(high))
        vectors[:, PLANES + 2 * i + 1] = _towards(azimuth, np.cos(low), np.sin(low) * half)
    quarters = 0.5 * np.pi * np.arange(4)
    vectors[-1, 1:PLANES] = _towards(quarters, -np.sin(low[-1]), np.cos(low[-1]))
    aside = np.sqrt(2.0) * np.cos(low[-1])
    vectors[-1, PLANES : PLANES + CORNERS] = _towards(quarters + 0.25 * np.pi, aside, np.sin(low[-1]))
    return np.ascontiguousarray(np.swapaxes(vectors @ patches.frame, 1, 2), np.float32)


def _towards(azimuth: np.ndarray, along: np.ndarray, up: np.ndarray) -> np.ndarray:
    """(K, 3) unit vectors with those shares along an azimuth and upwards."""
    vectors = np.stack(np.broadcast_arrays(along * np.sin(azimuth), along * np.cos(azimuth), up), axis=1)
    return vectors / np.linalg.norm(vectors, axis=1, keepdims=True)


@wp.func
def aim_at(beams: wp.uint64, k: wp.int32, spot: Spot):
    """Starts the k-th beam from a point; its first plane is the point's horizon."""
    start_beam(beams + wp.uint64(k) * _BEAM, spot.n, spot.o, spot.low, spot.beam)


@wp.func
def _within(d: wp.vec3, ab: wp.vec3, bc: wp.vec3, ca: wp.vec3, edge: wp.vec3) -> wp.int32:
    """1 where a direction is on the inner side of the planes through the origin and a triangle's edges."""
    inside = wp.where(wp.dot(d, ab) >= edge[0], 1, 0) & wp.where(wp.dot(d, bc) >= edge[1], 1, 0)
    return inside & wp.where(wp.dot(d, ca) >= edge[2], 1, 0)


@wp.func
def triangles_about(leaf: wp.uint64, beam: wp.uint64) -> wp.int32:
    """Mask of the triangles that fill a beam: all rays between its corners meet them, and so do those just beside."""
    aim = wp.array(ptr=beam, shape=(BEAM_FLOATS,), dtype=wp.float32)
    o = wp.vec3(aim[4 * WIDTH], aim[4 * WIDTH + 1], aim[4 * WIDTH + 2])
    p = wp.vec3(aim[PLANES], aim[WIDTH + PLANES], aim[2 * WIDTH + PLANES])
    q = wp.vec3(aim[PLANES + 1], aim[WIDTH + PLANES + 1], aim[2 * WIDTH + PLANES + 1])
    r = wp.vec3(aim[PLANES + 2], aim[WIDTH + PLANES + 2], aim[2 * WIDTH + PLANES + 2])
    s = wp.vec3(aim[PLANES + 3], aim[WIDTH + PLANES + 3], aim[2 * WIDTH + PLANES + 3])
    mask = wp.int32(0)
    k = wp.int32(0)
    while k < WIDTH:
        a = corner(leaf, 0, k, o)
        b = corner(leaf, 3, k, o)
        c = corner(leaf, 6, k, o)
        # Towards the origin or away from it: then the triangle is in front of it where all three are above 0.
        ab = wp.cross(a, b)
        volume = wp.dot(ab, c)
        sign = wp.copysign(1.0, volume)
        ab = sign * ab
        bc = sign * wp.cross(b, c)
        ca = sign * wp.cross(c, a)
        far_a = size_of(a)
        far_b = size_of(b)
        far_c = size_of(c)
        edge = _INSIDE * wp.vec3(far_a * far_b, far_b * far_c, far_c * far_a)
        inside = _within(p, ab, bc, ca, edge) & _within(q, ab, bc, ca, edge)
        inside = inside & _within(r, ab, bc, ca, edge) & _within(s, ab, bc, ca, edge)
        apart = wp.where(wp.abs(volume) > _INSIDE * far_a * far_b * far_c, 1, 0)
        mask = mask | ((inside & apart) << k)
        k += 1
    return mask


@wp.func
def _what_fills(spot: Spot, leaf: wp.uint64, met: wp.int32, filled: wp.uint64):
    """What is known of a beam in which triangles of a leaf are; likewise."""
    known = wp.int32(_UNKNOWN)
    if (triangles_about(leaf, spot.beam) & met) != 0:
        known = _CLOSED
        filled = leaf
    elif filled != _NOWHERE and triangles_about(filled, spot.beam) != 0:
        known = _CLOSED
    return known, filled


@wp.func
def look(accelerator: Accelerator, spot: Spot, near: wp.int32, filled: wp.uint64):
    """(what is known of the beam that is aimed, the leaf with the triangle that fills it or else `filled`).

    Args:
        accelerator: the tree as the point's rays see it.
        spot: the point, its beam aimed.
        near: mask of the triangles around the point.
        filled: address of a leaf that filled another beam, and is looked at first; or 0.
    """
    known = wp.int32(0)
    top = spot.scratch
    node = accelerator.start
    mask = wp.where(accelerator.starts > 0, -1, 0)  # -1: not found yet
    leaf = _NOWHERE
    met = wp.int32(0)
    visits = wp.int32(_VISITS)
    if near != 0:
        leaf = spot.room + NEAR
        met = triangles_in(leaf, spot.beam) & near
    for other in range(1, accelerator.starts):
        top = put_aside(top, accelerator.start + wp.uint64(other) * wp.uint64(NODE_BYTES), -1, 0.0)
    while known == 0:
        if met != 0:
            known, filled = _what_fills(spot, leaf, met, filled)
        elif visits == 0:
            known = _UNKNOWN
        elif mask == -1:
            mask = boxes_in(node, spot.beam)
        elif mask != 0:
            child = lowest_bit(mask)
            mask = mask & (mask - 1)
            place = link_in(node, child)
            visits -= 1
            if place < 0:
                leaf = leaf_at(accelerator, ~place)
                met = triangles_in(leaf, spot.beam)
            else:
                if mask != 0:
                    top = put_aside(top, node, mask, 0.0)
                node = node_at(accelerator, place)
                mask = -1
        elif top != spot.scratch:
            top -= WAITING
            node = address_at(top, 0)
            mask = wp.array(ptr=top, shape=(4,), dtype=wp.int32)[2]
        else:
            known = _OPEN
    return known, filled
