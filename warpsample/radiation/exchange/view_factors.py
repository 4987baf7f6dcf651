"""The call `view_factors`: view factors between the faces of a mesh, with occlusion, by ray casting."""

from dataclasses import replace
from typing import Any

import numpy as np
from typing_extensions import Unpack

from warpsample.estimate.result import PointStatus, Skipped, has_status
from warpsample.host.arguments import check_flag, check_integer
from warpsample.host.arrays import as_unit
from warpsample.host.options import CastKeywords, with_options
from warpsample.host.progress import bar
from warpsample.mesh.mesh import Mesh, as_mesh
from warpsample.radiation.exchange.casting import Casting
from warpsample.radiation.exchange.reciprocity import reciprocal_factors
from warpsample.radiation.exchange.result import ViewFactors
from warpsample.radiation.exchange.row_factors import RowFactors, factors_of, matrices_of
from warpsample.radiation.exchange.surfaces import Surfaces, check_groups, surfaces_of
from warpsample.tracing.options import RayOptions
from warpsample.tracing.scene import check_opaque

_MOST_RAYS = 2**24  # per face
_MOST_REPLICATES = 64


@with_options(CastKeywords)
def view_factors(
    mesh: Any,
    count: int = 4096,
    *,
    groups: Any = None,
    reciprocal: bool = False,
    replicates: int = 4,
    up: Any = None,
    first_face: int = 0,
    active: Any = None,
    **options: Unpack[CastKeywords],
) -> ViewFactors:
    """Compute view factors: the share of diffuse radiation from each face's front that first hits each other face's front.

    A face's rays come from one lattice in four dimensions: 4,096 are as good as 10,000 to 15,000 independent ones. The bits
    of a row depend on (mesh, seed, first_face + face, count, replicates) alone; those of its errors on the replicates of
    other rows, too. Memory: 40 bytes per entry and 8 per replicate of an entry.

    Radiation passes faces with a transmittance (see `Mesh`) up to the first opaque face. The factor is the share that
    arrives, and `absorbed` the share that is lost on the way. A face with a transmittance has a row, and no column.

    Args:
        mesh: Mesh or anything that `as_mesh` accepts. The front of a face is the side from which its corners run
            counter-clockwise. Of faces that coincide, rays hit one whose front they see. Rays start two millionths of the
            mesh's extent in front of their face, so that a gap between faces at less than 14 degrees may leak.
        count: Number of rays per face, from `replicates` to 2^24, rounded down to a multiple of it. Default: 4096.
        groups: (F,) numbers of surfaces from 0 on, (F,) names of surfaces, or "part" for the named parts of the mesh. Rows
            and columns are then surfaces: a row is the mean over the surface's faces by area, with the error of the sum,
            and `names` has the names. Default: None, a surface per face.
        reciprocal: Whether to adjust both directions of each pair, so that areas[i] matrix[i, j] is areas[j] matrix[j, i]
            and rows close to 1e-7, with smaller errors unless faces coincide; not with a transmittance. Default: False.
        replicates: Number of independent parts of each face's rays, whose differences give the errors, 1 to 64. More parts
            give larger errors that are known better. One part gives upper bounds of the errors. Default: 4.
        up: (3,) vector of any length that divides `outside` into `sky` and `ground`. Default: None, `outside` alone.
        first_face: Global id of face 0, an integer. Default: 0.
        active: (F,) bool. Inactive faces block rays, but have empty rows. Not with `reciprocal`. Default: None, all faces.
        seed: Random seed, an integer of 64 bits. Default: 0.
        skip: Whether to leave out rays whose answer is known. Changes no value. Default: True.
        workers: Number of CPU threads, an integer. Default: None, the value of WARPSAMPLE_WORKERS or all cores.
        progress: Whether to show a progress bar on a terminal or in a notebook. Default: False.

    Returns:
        the matrix with standard errors, the shares that hit no front, the number of rays, and a status for each face.

    Raises:
        TypeError, ValueError: an argument has a wrong type, shape or value.
        MemoryError: the result needs more memory than is free.

    Warns:
        UserWarning: the coordinates are too coarse for most faces, because parts of the mesh are far apart; or, with
            reciprocal, no scaling closes all rows, because there are too few rays.

    Example:
        >>> mesh = ws.load_mesh("courtyard")
        >>> v = ws.view_factors(mesh, 256, up=(0, 0, 1))
        >>> closure = v.matrix.sum(axis=1) + v.outside + v.behind
        >>> print(v.matrix.shape, closure.min(), closure.max(), f"{v.sky.mean():.2f}")
        (2080, 2080) 1.0 1.0 0.62
    """
    mesh = as_mesh(mesh)
    faces = len(mesh.faces)
    replicates = check_integer(replicates, "replicates", 1, _MOST_REPLICATES)
    wants = f"a whole number from {replicates}, the number of replicates, to {_MOST_RAYS}"
    rays = check_integer(count, "count", replicates, _MOST_RAYS, wants) // replicates
    groups, names = check_groups(groups, mesh)
    reciprocal = check_flag(reciprocal, "reciprocal")
    checked = RayOptions.of(faces, active=active, **options)
    casting = Casting(
        mesh,
        rays,
        replicates,
        checked.seed,
        None if up is None else as_unit(up, "up"),
        check_integer(first_face, "first_face", 0, 2**64 // replicates - faces),
        checked.skip,
        checked.workers,
    )
    status = _find_status(mesh, checked.active)
    is_good = has_status(status, PointStatus.OK)
    if active is not None and reciprocal:
        raise ValueError(
            "active: got a mask with reciprocal=True, want None, because reciprocal=True needs rays from both faces of "
            "each pair"
        )
    if reciprocal:
        check_opaque(mesh, "reciprocal")
    with bar(checked.progress, "casting rays"):
        counts, cast = casting.counts(np.flatnonzero(is_good).astype(np.int32), groups)
    surfaces = surfaces_of(mesh.face_areas, is_good, groups)
    factors = factors_of(counts, casting.rays, casting.upward(), surfaces)
    del counts  # twice as many bytes as the factors
    if reciprocal:
        factors = reciprocal_factors(factors, surfaces)
    if mesh.transmits and "absorbed" not in factors.others:  # faces that transmit everything
        factors.others["absorbed"] = np.zeros(len(surfaces.areas)), np.zeros(len(surfaces.areas))
    found = _build_result(factors, surfaces, status, cast, casting.rays)
    return replace(found, reflectance=surfaces.means(mesh.reflectance) if mesh.reflects else None, names=names)


def _find_status(mesh: Mesh, active: np.ndarray | None) -> np.ndarray:
    """Return the `PointStatus` of each face, (F,) uint8: the face casts rays, is inactive, or has no area."""
    status = np.where(mesh.face_areas > 0.0, int(PointStatus.OK), int(PointStatus.ZERO_NORMAL)).astype(np.uint8)
    if active is not None:
        status[active == 0] = int(PointStatus.INACTIVE)
    return status


def _build_result(factors: RowFactors, surfaces: Surfaces, status: np.ndarray, cast: np.ndarray, rays: int) -> ViewFactors:
    """Build the result of `view_factors` from computed factors; the faces in the mask `cast` have cast `rays` rays each."""
    open_faces = int(np.count_nonzero((status == 0) & ~cast))
    matrix, standard_error = matrices_of(factors.value, np.sqrt(factors.variance), factors.indices, factors.indptr)
    others = {}
    for name, (value, variance) in factors.others.items():
        others |= {name: value, f"{name}_error": np.sqrt(variance)}
    return ViewFactors(
        matrix=matrix,
        standard_error=standard_error,
        areas=surfaces.areas,
        rays=surfaces.summed(cast * np.int64(rays)),
        status=status,
        skipped=Skipped(int(np.count_nonzero(status)), open_faces, open_faces * rays),
        **others,
    )
