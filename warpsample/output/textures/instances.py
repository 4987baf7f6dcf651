"""Textures of meshes that a scene shows in several places: places with equal values share one picture."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np

from warpsample.output.textures.comparison import Digest, do_pictures_differ
from warpsample.output.textures.images import COUNTS, Filled
from warpsample.texture.glb_file import GlbFile
from warpsample.texture.jobs import TextureJob
from warpsample.texture.notes import join_names
from warpsample.texture.primitives import Primitive
from warpsample.texture.sets import TextureOptions


@dataclass(frozen=True, eq=False)
class PlacedTexture:
    """Computed texture, and the places in the scene (instances of the mesh) that show the texture.

    Attributes:
        filled: its numbers.
        groups: the primitives of each place.
        rays: (numbers, points inside bodies), how many were cast for all these places.
    """

    filled: Filled
    groups: list[list[Primitive]]
    rays: tuple[int, int]


def pictures_of(job: TextureJob, fill: Callable[..., Filled], how: TextureOptions) -> list[PlacedTexture]:
    """Compute a texture for each place of its mesh in the scene, and return the pictures that differ.

    The arguments of `fill` are a texture at one place, and `is_compared`, whether its picture is compared with others.
    """
    is_compared = how.instances == "split" and any(one.others for one in job.group)
    fill = partial(fill, is_compared=is_compared)
    found, bare = [_picture(fill(job), job)], []

    def pictures() -> Iterator[PlacedTexture]:
        """Yield the picture of each other place; a place without texels goes to `bare`."""
        for other in job.at_other_places():
            if len(other.points):
                yield _picture(fill(other), other)
            else:
                bare.append(other.group)

    if how.instances == "mean":
        found = [_mean_of(found[0], pictures(), how.gutter)]
    else:
        digests = [Digest.of(found[0].filled)] if is_compared else []
        for made in pictures():
            own = Digest.of(made.filled)
            equal = (i for i in range(len(found)) if not _do_places_differ(found[i], digests[i], made, own, how.depth))
            if (same := next(equal, None)) is None:
                found.append(made)
                digests.append(own)
            else:
                found[same] = _joined(found[same], made)
    return [replace(found[0], groups=found[0].groups + bare), *found[1:]]


def _do_places_differ(
    known: PlacedTexture, digest: Digest | None, made: PlacedTexture, own: Digest | None, depth: int
) -> bool:
    """Return whether the pictures of two places differ; digests show most differences in a fraction of the time."""
    if digest is not None and own is not None and digest.differ(own, depth):
        return True
    return do_pictures_differ(known.filled, made.filled, depth)


def _joined(known: PlacedTexture, other: PlacedTexture) -> PlacedTexture:
    """Return one picture for the places of two equal pictures, with the larger number of points of each count."""
    rays = known.rays[0] + other.rays[0], known.rays[1] + other.rays[1]
    most = {name: max(getattr(known.filled, name), getattr(other.filled, name)) for name in COUNTS}
    return replace(known, filled=replace(known.filled, **most), groups=known.groups + other.groups, rays=rays)


def _mean_of(first: PlacedTexture, others: Iterator[PlacedTexture], gutter: Any) -> PlacedTexture:
    """Return the mean of the pictures of all places of a mesh, with the mean of their standard errors."""
    total, count = _sums(first.filled)
    for other in others:
        first = _joined(first, other)
        more, times = _sums(other.filled)
        total += more
        count += times
    if len(first.groups) == 1:
        return first
    points, old = first.filled.job.points, first.filled
    rows = (total / np.where(count > 0, count, np.nan)).reshape(3, -1, total.shape[-1])[:, points.texel]
    value, error, unbiased = (points.image(some, gutter=gutter).reshape(old.value.shape) for some in rows)
    mean = float(np.nanmean(rows[0])) if count.any() else float("nan")
    empty = int(np.count_nonzero(count.ravel()[points.texel] == 0))  # at all places
    counts = {"missed": min(old.missed, empty), "lost": min(old.lost, empty)}
    images = {"value": value, "error": error, "unbiased": unbiased, "own": count[..., 0] > 0}
    return replace(first, filled=replace(old, **images, **counts, mean=mean))


def _picture(filled: Filled, job: TextureJob) -> PlacedTexture:
    return PlacedTexture(filled, [job.group], (filled.rays, filled.inside_rays))


def _sums(filled: Filled) -> tuple[np.ndarray, np.ndarray]:
    """Return values and two errors of a texture, (3, H, W, C), and counts, (H, W, 1).

    The count is 1 for a texel with a value of its own; for other texels all are 0.
    """
    own = filled.own[..., None]
    all_three = np.stack([filled.value, filled.error, filled.unbiased]).astype(np.float64)
    return np.where(own, all_three.reshape(3, *own.shape[:2], -1), 0.0), own.astype(np.int64)


def place_pictures(file: GlbFile, pictures: list[list[PlacedTexture]]) -> list[list[list[Primitive]]]:
    """Copy meshes in a .glb so that each place in the scene can show its own picture.

    Args:
        file: to be edited.
        pictures: those of each job.

    Returns:
        for each job and each of its pictures the primitives that show it, those of copies among them.
    """
    shown: dict[int, dict[int, int]] = {}  # node -> number of a primitive in its mesh -> number of its picture
    for row in pictures:
        for number, picture in enumerate(row):
            for one in (one for group in picture.groups for one in group):
                shown.setdefault(one.node, {})[one.number] = number
    known: dict[Any, int] = {}  # (mesh, pictures) -> the mesh or its copy
    found: list[list[dict[Any, Primitive]]] = [[{} for _ in row] for row in pictures]
    for job, row in enumerate(pictures):
        for number, picture in enumerate(row):
            for one in (one for group in picture.groups for one in group):
                mesh = _mesh_for(file, one, shown[one.node], known)
                found[job][number].setdefault((mesh, one.number), replace(one, mesh=mesh))
    return [[list(primitives.values()) for primitives in row] for row in found]


def _mesh_for(file: GlbFile, one: Primitive, shown: dict[int, int], known: dict[Any, int]) -> int:
    """Assign a glTF node its mesh, or a copy if the node shows other pictures than the mesh; return the mesh's number."""
    key = one.mesh, tuple(sorted(shown.items()))
    if key not in known:
        known[key] = file.copy_item("meshes", one.mesh) if any(shown.values()) else one.mesh
    file.tree["nodes"][one.node]["mesh"] = known[key]
    return known[key]


def describe_places(pictures: list[PlacedTexture]) -> Iterator[str]:
    """Yield a sentence on how many pictures the places of a mesh share, if the mesh is in several places."""
    places = sum(len(picture.groups) for picture in pictures)
    if places > 1:
        several = join_names(one.name for one in pictures[0].groups[0] if one.others)
        shown = (
            "share one picture"
            if len(pictures) == 1
            else f"show {len(pictures)} pictures, by copies of meshes and materials"
        )
        yield f"the {places} places of {several} {shown}"
