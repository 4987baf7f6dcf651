"""Ray tracing in user-defined Warp kernels: a struct that represents a mesh, and functions that trace rays."""

from typing import Any

import warp as wp

from warpsample.maths.numerics import ONE, ZERO, direction_to_unit
from warpsample.tracing.placement import MOST_DISTANCE, distance_to_scene, in_double, is_far_off, offset_within
from warpsample.tracing.queries import Accelerator, Glass
from warpsample.tracing.wide.layout import SCRATCH
from warpsample.tracing.wide.prepare import RAY_WORKSPACE, ray_of
from warpsample.tracing.wide.query import wide_walk
from warpsample.tracing.wide.through import path_transmittance

_MOST_DISTANCE = wp.constant(wp.float32(MOST_DISTANCE))
_walk_to_any = wide_walk(True)
_walk_to_nearest = wide_walk(False)


@wp.struct
class Tree:
    """Mesh prepared for rays in a kernel; `warpsample.tree` builds it, and a kernel takes it as an argument.

    A point x of the user is (x - centre) * scale in the tree's coordinates, where the mesh is within 1 of 0 on each axis.

    Attributes:
        nodes: nodes of the 16-wide tree of the opaque faces, on the CPU; empty on CUDA.
        leaves: leaves of that tree.
        mesh: id of a wp.Mesh on CUDA; 0 on the CPU.
        centre: centre of the mesh in the user's coordinates.
        scale: factor from the user's units to the tree's.
        extent: distance that the mesh reaches from 0 on each axis, in the tree's coordinates.
        coarseness: spacing of stored positions, in the tree's coordinates.
        glass_nodes: nodes of the tree of the translucent faces; empty for a mesh of opaque faces.
        glass_leaves: leaves of that tree.
        transmittance: (F,) transmittances of all faces; empty for a mesh of opaque faces.
    """

    nodes: wp.array[wp.float32]
    leaves: wp.array[wp.float32]
    mesh: wp.uint64
    centre: wp.vec3d
    scale: wp.float64
    extent: wp.vec3
    coarseness: wp.float32
    glass_nodes: wp.array[wp.float32]
    glass_leaves: wp.array[wp.float32]
    transmittance: wp.array[wp.float32]


@wp.struct
class Local:
    """Ray in the normalised coordinates of a `Tree`; the mesh lies in the cube from -1 to 1.

    Attributes:
        o: origin.
        d: unit direction.
        reach: largest distance of a hit from o.
        ahead: distance that the ray travelled from the user's origin to o.
    """

    o: wp.vec3
    d: wp.vec3
    reach: wp.float32
    ahead: wp.float32


@wp.func
def _to_tree_coordinates(tree: Tree, origin: wp.vec3d, direction: wp.vec3, max_distance: wp.float32) -> Local:
    """Convert a ray from the user's coordinates to the normalised coordinates of a `Tree`.

    The reach is NaN for an invalid ray, and below 0 if the ray misses the mesh.
    """
    unit = direction_to_unit(direction)
    o = (origin - tree.centre) * tree.scale
    ray = Local()
    ray.d = wp.vec3(unit[0], unit[1], unit[2])
    reach = wp.float64(wp.where(max_distance > _MOST_DISTANCE, _MOST_DISTANCE, max_distance)) * tree.scale  # NaN stays
    ahead = ZERO
    if is_far_off(o):
        w = in_double(direction)
        w = (ONE / wp.sqrt(wp.dot(w, w))) * w
        ahead = distance_to_scene(o, w)
        o = wp.where(ahead < ZERO, o - o, o + ahead * w)
    ray.o = wp.vec3(o)
    ray.reach = wp.where(ahead < ZERO, -1.0, wp.float32(reach - ahead))
    ray.ahead = wp.float32(ahead)
    if not (wp.abs(unit[3]) < 0.1 and wp.dot(ray.o - ray.o, ray.o - ray.o) == 0.0):
        ray.reach = wp.float32(wp.NAN)
    return ray


@wp.func
def _accelerator(tree: Tree) -> Accelerator:
    """Return the search tree over the opaque faces of a `Tree`."""
    accelerator = Accelerator()
    accelerator.nodes = tree.nodes.ptr
    accelerator.leaves = tree.leaves.ptr
    accelerator.start = tree.nodes.ptr
    accelerator.starts = 1
    return accelerator


@wp.func
def _glass(tree: Tree) -> Glass:
    """Return the search tree over the translucent faces of a `Tree`, with all transmittances."""
    glass = Glass()
    glass.tree.nodes = tree.glass_nodes.ptr
    glass.tree.leaves = tree.glass_leaves.ptr
    glass.tree.start = tree.glass_nodes.ptr
    glass.tree.starts = 1
    glass.transmittance = tree.transmittance.ptr
    return glass


@wp.func
def _any_hit(tree: Tree, origin: wp.vec3d, direction: wp.vec3, max_distance: wp.float32) -> bool:
    hit = wp.bool(False)
    ray = _to_tree_coordinates(tree, origin, direction, max_distance)
    if ray.reach > 0.0:
        if tree.mesh != wp.uint64(0):
            hit = wp.mesh_query_ray_anyhit(tree.mesh, ray.o, ray.d, ray.reach)
        else:
            workspace = wp.zeros(shape=(RAY_WORKSPACE,), dtype=wp.float32)
            words = wp.zeros(shape=(SCRATCH,), dtype=wp.int32)
            to = ray_of(ray.o, ray.d, workspace)
            _near, face, _nodes, _leaves = _walk_to_any(_accelerator(tree), to, ray.reach, words.ptr)
            hit = face >= 0  # not by the distance, so that the compiler drops its computation
    return hit


@wp.func
def _transmitted(tree: Tree, origin: wp.vec3d, direction: wp.vec3, max_distance: wp.float32) -> wp.float32:
    share = wp.float32(1.0)
    ray = _to_tree_coordinates(tree, origin, direction, max_distance)
    if ray.reach > 0.0:
        if tree.mesh != wp.uint64(0):
            if wp.mesh_query_ray_anyhit(tree.mesh, ray.o, ray.d, ray.reach):
                share = 0.0
        else:
            workspace = wp.zeros(shape=(RAY_WORKSPACE,), dtype=wp.float32)
            words = wp.zeros(shape=(SCRATCH,), dtype=wp.int32)
            to = ray_of(ray.o, ray.d, workspace)
            _near, face, _nodes, _leaves = _walk_to_any(_accelerator(tree), to, ray.reach, words.ptr)
            if face >= 0:
                share = 0.0
            elif tree.transmittance.shape[0] > 0:
                share = path_transmittance(_glass(tree), to, ray.reach, words.ptr)
    elif not (ray.reach <= 0.0):
        share = wp.float32(wp.NAN)
    return share


@wp.func
def _nearest_hit(tree: Tree, origin: wp.vec3d, direction: wp.vec3, max_distance: wp.float32):
    distance = wp.float32(wp.INF)
    face = wp.int32(-1)
    ray = _to_tree_coordinates(tree, origin, direction, max_distance)
    if ray.reach > 0.0:
        near = wp.float32(wp.INF)
        if tree.mesh != wp.uint64(0):
            query = wp.mesh_query_ray(tree.mesh, ray.o, ray.d, ray.reach)
            if query.result and query.t < ray.reach:
                near = query.t
                face = query.face
        else:
            workspace = wp.zeros(shape=(RAY_WORKSPACE,), dtype=wp.float32)
            words = wp.zeros(shape=(SCRATCH,), dtype=wp.int32)
            to = ray_of(ray.o, ray.d, workspace)
            near, face, _nodes, _leaves = _walk_to_nearest(_accelerator(tree), to, ray.reach, words.ptr)
        distance = wp.float32((wp.float64(near) + wp.float64(ray.ahead)) * (ONE / tree.scale))
    elif not (ray.reach <= 0.0):
        distance = wp.float32(wp.NAN)
    return distance, face


# The traversals read memory by address, where no gradients exist: the backward pass that Warp generates for them crashes.
@wp.func_grad(_any_hit)
def _no_gradient(tree: Tree, origin: wp.vec3d, direction: wp.vec3, max_distance: wp.float32, adj_hit: bool):
    pass


@wp.func_grad(_transmitted)
def _no_gradient_of_share(tree: Tree, origin: wp.vec3d, direction: wp.vec3, max_distance: wp.float32, adj_share: wp.float32):
    pass


@wp.func_grad(_nearest_hit)
def _no_gradients(
    tree: Tree,
    origin: wp.vec3d,
    direction: wp.vec3,
    max_distance: wp.float32,
    adj_distance: wp.float32,
    adj_face: wp.int32,
):
    pass


@wp.func
def any_hit(tree: Tree, origin: Any, direction: wp.vec3, max_distance: wp.float32) -> bool:
    """Return whether a ray hits an opaque face of the mesh before max_distance; False for an invalid ray.

    A ray is invalid if its direction is zero, if its direction or origin is infinite or NaN, or if its max_distance is NaN.
    Under wp.Tape the result is a constant.

    Args:
        tree: result of `warpsample.tree`.
        origin: vec3 or vec3d, in the mesh's coordinates; on the surface, see `offset_origin`.
        direction: vec3 of any length.
        max_distance: largest distance of a hit, in units of the coordinates; wp.INF for no limit.
    """
    return _any_hit(tree, in_double(origin), direction, max_distance)


@wp.func
def nearest_hit(tree: Tree, origin: Any, direction: wp.vec3, max_distance: wp.float32):
    """Return (distance, face) of the nearest opaque face before max_distance; (inf, -1) without a hit.

    An invalid ray (see `any_hit`) gives (NaN, -1). Under wp.Tape both are constants, without a gradient.

    Args:
        tree: result of `warpsample.tree`.
        origin: vec3 or vec3d, in the mesh's coordinates; on the surface, see `offset_origin`.
        direction: vec3 of any length.
        max_distance: largest distance of a hit, in units of the coordinates; wp.INF for no limit.
    """
    distance, face = _nearest_hit(tree, in_double(origin), direction, max_distance)
    return distance, face


@wp.func
def transmitted(tree: Tree, origin: Any, direction: wp.vec3, max_distance: wp.float32) -> wp.float32:
    """Return the fraction of light transmitted along a ray up to max_distance: 0 behind an opaque face.

    It is the product of the transmittances of all faces that the ray crosses; NaN for an invalid ray (see `any_hit`). Under
    wp.Tape it is a constant.

    Args:
        tree: result of `warpsample.tree`.
        origin: vec3 or vec3d, in the mesh's coordinates; on the surface, see `offset_origin`.
        direction: vec3 of any length.
        max_distance: length of the ray, in units of the coordinates; wp.INF for no limit.
    """
    return _transmitted(tree, in_double(origin), direction, max_distance)


@wp.func
def offset_origin(tree: Tree, position: Any, normal: wp.vec3) -> wp.vec3d:
    """Return a surface point moved off the surface along its unit normal, so that its rays do not hit their own face.

    The distance is two millionths of the mesh's extent along the normal. Negate the normal for rays into the mesh.
    """
    away = offset_within(tree.extent, tree.coarseness, normal)
    return in_double(position) + (wp.float64(away) / tree.scale) * in_double(normal)
