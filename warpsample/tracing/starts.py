"""Positions where the rays of surface points start: just in front of the point's face, and not behind any other face.

A point on an edge or a corner sees the same as points of its own face just beside it. So the faces that touch a point and
rise steeply above its own face are searched. The start moves towards the centre of its own face, just far enough to be on
the same side of these faces as the centre. If a face crosses the point's own face, like a wall in the middle of a floor,
the start moves to the front of that face. Between several such walls, it moves along the floor to where it is in front of
all. The own face of a vertex is one that is not behind a wall, if there is one.

The starts of a height field's vertices are raised vertically instead. Beside a face as steep as a wall, a move towards the
centre of another steep face would lead down along that face and behind other faces.
"""

import numpy as np
import warp as wp

from warpsample.host.arrays import cpu
from warpsample.host.engine import run
from warpsample.host.locks import once
from warpsample.maths.memory import byte_at, int_at, set_vec3, vec3_at
from warpsample.maths.numerics import ZERO, normalize
from warpsample.mesh.mesh import Mesh, unit_or_zero
from warpsample.mesh.surface import SurfacePoints
from warpsample.tracing.placement import PlacementArgs, in_double, local_origin
from warpsample.tracing.queries import Accelerator
from warpsample.tracing.scene import Scene
from warpsample.tracing.sight.contacts import (
    NextFace,
    find_next_face,
    find_own_face,
    has_exact_normal,
    look_around,
    raise_start,
    start_above,
    start_of,
)
from warpsample.tracing.sight.face_contact import FaceContact
from warpsample.tracing.sight.facets import Contacts, ContactsArgs, corners_of, facet_of, with_normal
from warpsample.tracing.sight.walls import stand_between_walls
from warpsample.tracing.tracers import Tracer
from warpsample.tracing.wide.layout import SCRATCH

_TRIES = wp.constant(12)  # faces that are tried as a vertex's own: six meet at a vertex of a grid


def faces_and_normals(mesh: Mesh, points: SurfacePoints, argument: str = "origins") -> tuple[np.ndarray, np.ndarray]:
    """Return the face of each surface point, (P,) int32, and the normal of that face, (P, 3) float32.

    Normals are unit vectors or zero. A point without a face has its own normal in place of the face's. Both arrays are
    copies.

    Raises:
        ValueError: a face number that the mesh does not have; the message names the argument.
    """
    face = np.array(points.face, np.int32, order="C")
    if face.size and not (face.min() >= -1 and face.max() < len(mesh.faces)):
        raise ValueError(
            f"{argument}: got points on faces {face.min()} to {face.max()}, want -1 (none) to {len(mesh.faces) - 1}"
        )
    on_faces = bool((face >= 0).any())  # else skip the mesh's normals, which it would cache: 36 bytes a face
    normals = mesh.face_normals[face] if on_faces else np.zeros((len(face), 3), np.float32)
    alone = np.flatnonzero(face < 0)
    if len(alone):
        own = np.asarray(points.normal, np.float64)[alone]
        normals[alone] = unit_or_zero(np.where(np.isfinite(own).all(axis=1, keepdims=True), own, 0.0))
    return face, normals


def set_starts(
    scene: Scene,
    placement: PlacementArgs,
    face: np.ndarray,
    *,
    towards: np.ndarray | None,
    raised: np.ndarray | None,
    tracer: Tracer,
    workers: int,
) -> np.ndarray:
    """Compute the positions where the rays of surface points start, (P, sides, 3) float32, just off the points' faces.

    The address of the array is stored in `placement`. The caller must keep the array. The search uses the 16-wide tree on
    the CPU, whichever tracer and device the rays have.

    The distances of wp.Mesh to needle-like faces are inexact. So for this tracer, the points are moved off their faces as if
    the mesh had the same extent in all directions, and that extent is stored in `placement`.

    Args:
        scene: scene with the points on its surface.
        placement: positions of the points, and in `normals` the unit normals of their faces, or the points' own normals.
        face: (P,) int32, face of each point, -1 if unknown. Then the touching face that best matches the normal is used.
        towards: (P, 3) float32, direction to the side of the face from which rays start; None for both sides, that of the
            normal first.
        raised: (P,) bool, contiguous, points whose starts are raised vertically (see `SurfacePoints`); None for none.
        tracer: tracer of the rays.
        workers: number of threads.
    """
    if not tracer.exact:
        placement.extent = wp.vec3(1.0, 1.0, 1.0)
    sides = 2 if towards is None else 1
    starts = np.empty((placement.points, sides, 3), np.float32)
    contacts = ContactsArgs(
        placement=placement, towards=0 if towards is None else towards.ctypes.data, face=face.ctypes.data
    )
    contacts.vertices, contacts.triangles = scene.vertices.ctypes.data, scene.faces.ctypes.data
    contacts.spread = wp.vec3(*scene.spread) if tracer.exact else placement.extent
    contacts.starts, contacts.sides = starts.ctypes.data, sides
    contacts.raised = 0 if raised is None else raised.ctypes.data
    tree = scene.tree(workers).accelerator()  # of all faces, as translucent faces can hold points, too
    run(_start_kernel(), placement.points, [contacts, tree], cpu(), workers=workers, work=16 * placement.points)
    placement.starts = starts.ctypes.data
    return starts


@wp.func
def _is_raised(contacts: Contacts, i: wp.int64) -> wp.bool:
    """Return whether rays of the i-th point start vertically above the point, as for height fields."""
    raised = wp.bool(False)
    if contacts.raised != wp.uint64(0):
        raised = byte_at(contacts.raised, i) != wp.uint8(0)
    return raised


@wp.func
def _set_start(contacts: Contacts, i: wp.int64, side: wp.int32, start: wp.vec3):
    """Store the position where rays of the i-th point start, on one side of its face."""
    set_vec3(contacts.starts, i * wp.int64(contacts.sides) + wp.int64(side), start)


@once
def _start_kernel() -> wp.Kernel:
    """Build a kernel that computes the position where each surface point's rays start, one point per task."""

    @wp.kernel(module="unique", enable_backward=False, grid_stride=False)
    def find_starts(contacts: Contacts, tree: Accelerator, first_task: wp.int64):
        words = wp.zeros(shape=(SCRATCH,), dtype=wp.int32)
        i = first_task + wp.int64(wp.tid())
        contact = FaceContact()
        contact.p = local_origin(contacts.placement, i)
        contact.own = int_at(contacts.face, i)
        contact.along = -1
        contact.against = -1
        contact.alone = wp.bool(False)
        normal = vec3_at(contacts.placement.normals, i)
        look = in_double(normal)
        if contacts.sides == 1:
            look = in_double(normalize(vec3_at(contacts.towards, i)))
        if _is_raised(contacts, i):
            for side in range(contacts.sides):
                _set_start(contacts, i, side, start_above(contacts, contact.p, look))
                look = -look
            return
        known = contact.own >= 0
        if known:
            # This normal was computed before the corners were rounded to float32.
            contact.facet = with_normal(contacts, corners_of(contacts, contact.own), in_double(normal))
        # Step 0 searches for the point's own face, if it is unknown; each further step finds the start on one side. Step 1
        # is repeated with each face that is like the first while the own face is behind another one, at last with the first.
        first = contact.own
        tries = wp.where(known, _TRIES, 0)
        has_others = wp.bool(False)
        exact = wp.bool(known)  # not `known` itself, which Warp would change with it
        others = NextFace()
        others.after = -2
        step = wp.where(known, 1, 0)
        while step <= contacts.sides:
            if step > 0 and contact.own >= 0:
                contact = raise_start(contacts, contact, look, known)
            if wp.dot(look, look) > ZERO and (step == 0 or contact.own >= 0) and not contact.alone:
                contact.alone = wp.bool(step > 0)
                contact = look_around(contacts, tree, contact, look, step == 0, words.ptr)
            again = step == 1 and contact.behind and tries < _TRIES
            if again:
                others = find_next_face(contacts, tree, contact, others, exact, words.ptr)
                has_others = has_others or others.face >= 0
                tries = wp.where(others.face < 0, _TRIES, tries + 1)
                contact.own = wp.where(tries < _TRIES, others.face, first)
            elif step == 0:
                first = find_own_face(contact)
                contact.own = first
                exact = has_exact_normal(contact, look)
            else:
                mixed = contact.in_corner and wp.dot(contact.aside, contact.aside) > ZERO
                if contact.several or mixed or (contact.behind and has_others):
                    contact = stand_between_walls(contacts, tree, contact, exact, words.ptr)
                _set_start(contacts, i, step - 1, start_of(contacts, contact, look))
                look = -look
            if (again or step == 0) and contact.own >= 0:
                contact.facet = facet_of(contacts, contact.own)
            step += wp.where(again, 0, 1)

    return find_starts
