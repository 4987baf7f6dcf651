"""Where the rays of points on a surface start: a little in front of the face that a point lies on, and behind no other.

What lies on an edge or a corner sees what points of its own face just beside it see. So of the faces that touch a point,
those that rise above its own are looked at: the start moves towards the middle of its own face, as little as brings it to
that side of them. A face that stands across the point's own, as a wall in the middle of a floor, has the point on its front.
The vertices of a field of heights are raised instead: beside a face as steep as a wall, a move towards the middle of another
steep face leads down along it, and behind the others.
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
from warpsample.tracing.sight.contacts import FaceContact, look_around, own_face, standing_off, start_above, start_of
from warpsample.tracing.sight.facets import Contacts, ContactsArgs, corners_of, facet_of, with_normal
from warpsample.tracing.tracers import Tracer
from warpsample.tracing.wide.layout import SCRATCH


def faces_and_normals(mesh: Mesh, points: SurfacePoints, argument: str = "origins") -> tuple[np.ndarray, np.ndarray]:
    """(P,) int32, a copy of the points' faces; and (P, 3) float32, unit or zero, the normals of these, else the points' own.

    Raises:
        ValueError: a face that the mesh has not; names the argument.
    """
    face = np.array(points.face, np.int32, order="C")
    if face.size and not (face.min() >= -1 and face.max() < len(mesh.faces)):
        raise ValueError(
            f"{argument}: got points on faces {face.min()} to {face.max()}, want -1 (none) to {len(mesh.faces) - 1}"
        )
    on_faces = bool((face >= 0).any())  # else the mesh makes no normals, which it would keep: 36 bytes a face
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
) -> np.ndarray | None:
    """Tells a placement of points on faces where rays start; gives the starts (P, sides, 3) float32, for the caller to keep.

    A tracer in whose tree other faces cannot be looked for has none: its points are moved off their faces as if the mesh
    were as large in all directions, since wp.Mesh tells distances to needles that badly.

    Args:
        scene: what the points are on.
        placement: their positions, and in `normals` the unit normals of their faces, their own where they lie on none.
        face: (P,) int32, -1 where it is not known: then of those that touch a point the one that faces its normal best.
        towards: (P, 3) float32, to which side of its face each looks; None for both, that of the normal first.
        raised: (P,) bool, contiguous, as `SurfacePoints` has it, or None.
        tracer: of the rays.
        workers: threads.
    """
    if not tracer.skips:
        placement.extent = wp.vec3(1.0, 1.0, 1.0)
        return None
    sides = 2 if towards is None else 1
    starts = np.empty((placement.points, sides, 3), np.float32)
    contacts = ContactsArgs(
        placement=placement, towards=0 if towards is None else towards.ctypes.data, face=face.ctypes.data
    )
    contacts.vertices, contacts.triangles = scene.vertices.ctypes.data, scene.faces.ctypes.data
    contacts.spread, contacts.starts, contacts.sides = wp.vec3(*scene.spread), starts.ctypes.data, sides
    contacts.raised = 0 if raised is None else raised.ctypes.data
    tree = scene.tree(workers).accelerator()  # of all faces: on which a point stands is no matter of light
    run(_start_kernel(), placement.points, [contacts, tree], cpu(), workers=workers, work=16 * placement.points)
    placement.starts = starts.ctypes.data
    return starts


@wp.func
def _is_raised(contacts: Contacts, i: wp.int64) -> wp.bool:
    raised = wp.bool(False)
    if contacts.raised != wp.uint64(0):
        raised = byte_at(contacts.raised, i) != wp.uint8(0)
    return raised


@wp.func
def _set_start(contacts: Contacts, i: wp.int64, side: wp.int32, start: wp.vec3):
    set_vec3(contacts.starts, i * wp.int64(contacts.sides) + wp.int64(side), start)


@once
def _start_kernel() -> wp.Kernel:
    """A kernel with a task for each point."""

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
            # The normal is from before the corners were rounded.
            contact.facet = with_normal(contacts, corners_of(contacts, contact.own), in_double(normal))
        # First the search for its own face, if that is not known; then a start for each side.
        for step in range(wp.where(known, 1, 0), contacts.sides + 1):
            if step > 0 and contact.own >= 0:
                contact = standing_off(contacts, contact, look, known)
            if wp.dot(look, look) > ZERO and (step == 0 or contact.own >= 0) and not contact.alone:
                contact.alone = wp.bool(step > 0)
                contact = look_around(contacts, tree, contact, look, step == 0, words.ptr)
            if step == 0:
                contact.own = own_face(contact)
                if contact.own >= 0:
                    contact.facet = facet_of(contacts, contact.own)
            else:
                _set_start(contacts, i, step - 1, start_of(contacts, contact, look))
                look = -look

    return find_starts
