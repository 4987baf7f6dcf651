"""Textures of meshes that a scene shows in several places: places with equal values share one picture."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import partial
from itertools import chain
from typing import Any

import numpy as np

from warpsample.output.textures.comparison import KnownPictures
from warpsample.output.textures.images import COUNTS, Filled, Images
from warpsample.texture.glb_file import GlbFile
from warpsample.texture.jobs import REFUSED, TextureJob
from warpsample.texture.notes import join_names
from warpsample.texture.primitives import Primitive
from warpsample.texture.report import merge_flaws
from warpsample.texture.sets import TextureOptions


@dataclass(frozen=True)
class Encoded:
    """Picture as a glTF file stores it.

    Attributes:
        png: content of the .png.
        longest: length that is stored as 1; 1 for values that are no lengths.
    """

    png: bytes
    longest: float


Picture = Encoded | Images
"""Picture to write: encoded, or as images for a file that holds one picture."""


@dataclass(frozen=True, eq=False)
class PlacedTexture:
    """Computed texture, and the places in the scene (instances of the mesh) that show the texture.

    Attributes:
        filled: its numbers; of counts, the largest of all places; and flaws of coordinates at any place.
        groups: the primitives of each place.
        rays: (numbers, points inside bodies), how many were cast for all these places.
        picture: its picture.
    """

    filled: Filled
    groups: list[list[Primitive]]
    rays: tuple[int, int]
    picture: Picture

    @classmethod
    def of(cls, places: list[Filled], picture: Picture) -> "PlacedTexture":
        """Return the texture that some places share."""
        rays = sum(one.rays for one in places), sum(one.inside_rays for one in places)
        most = {name: max(getattr(one, name) for one in places) for name in COUNTS}
        report = merge_flaws([one.report for one in places], REFUSED)
        return cls(replace(places[0], **most, report=report), [one.job.group for one in places], rays, picture)


def pictures_of(
    job: TextureJob,
    fill: Callable[..., tuple[Filled, Images]],
    how: TextureOptions,
    encode: Callable[[Images], Picture],
) -> list[PlacedTexture]:
    """Compute a texture for each place of its mesh in the scene, and return the pictures that differ.

    The arguments of `fill` are a texture at one place, its points, and `is_compared`, whether its picture is compared with
    others. `encode` returns the picture to write. The images of few places are in memory at a time.
    """
    is_compared, bare = how.instances == "split" and job.places > 1, list[list[Primitive]]()
    places = _fill_places(job, partial(fill, is_compared=is_compared), bare)
    found = _share(places, how.depth, encode) if is_compared else [_mean_of(places, how.gutter, encode)]
    return [replace(found[0], groups=found[0].groups + bare), *found[1:]]


def _fill_places(
    job: TextureJob, fill: Callable[..., tuple[Filled, Images]], bare: list[list[Primitive]]
) -> Iterator[tuple[Filled, Images]]:
    """Yield a texture at each place of its mesh; the primitives of places without texels go to `bare`."""
    for one in chain([job], job.at_other_places()):
        points = one.make_points()
        if len(points):
            yield fill(one, points)
        else:
            bare.append(one.group)
        del points  # before those of the next place are made


def _share(places: Iterator[tuple[Filled, Images]], depth: int, encode: Callable[[Images], Picture]) -> list[PlacedTexture]:
    """Return the pictures that differ; places with equal pictures share one."""
    known, pictures, alike = KnownPictures(depth), list[Picture](), list[list[Filled]]()
    for filled, images in places:
        number = known.find_or_add(images)
        if number == len(pictures):
            pictures.append(encode(images))
            alike.append([])
        alike[number].append(filled)
        del images  # before those of the next place are computed
    return [PlacedTexture.of(some, picture) for some, picture in zip(alike, pictures, strict=True)]


def _mean_of(places: Iterator[tuple[Filled, Images]], gutter: Any, encode: Callable[[Images], Picture]) -> PlacedTexture:
    """Return the mean of the pictures of all places of a mesh, with the mean of their standard errors."""
    first, images = next(places)
    alike, sums = [first], None
    for other, made in places:
        sums = _sums(images) if sums is None else sums
        for total, more in zip(sums, _sums(made), strict=True):
            np.add(total, more, out=total)
        alike.append(other)
        del made
    if sums is None:
        return PlacedTexture.of(alike, encode(images))
    (total, count), points = sums, images.points
    rows = (total / np.where(count > 0, count, np.nan)).reshape(3, -1, total.shape[-1])[:, points.texel]
    value, error, unbiased = (points.image(some, gutter=gutter).reshape(images.value.shape) for some in rows)
    images = replace(images, value=value, error=error, unbiased=unbiased, own=count[..., 0] > 0)
    found = PlacedTexture.of(alike, encode(images))
    mean = float(np.nanmean(rows[0])) if count.any() else float("nan")
    empty = int(np.count_nonzero(count.ravel()[points.texel] == 0))  # at all places
    counts = {"missed": min(found.filled.missed, empty), "lost": min(found.filled.lost, empty)}
    return replace(found, filled=replace(found.filled, **counts, mean=mean, error=images.known_error))


def _sums(images: Images) -> tuple[np.ndarray, np.ndarray]:
    """Return values and two errors of a texture, (3, H, W, C), and counts, (H, W, 1).

    The count is 1 for a texel with a value of its own; for other texels all are 0.
    """
    own = images.own[..., None]
    all_three = np.stack([images.value, images.error, images.unbiased]).astype(np.float64)
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
    """Yield a sentence on how many pictures the places of meshes share, if a mesh is in several places."""
    names: dict[int, list[str]] = {}
    for one in pictures[0].groups[0]:
        if one.others:
            names.setdefault(1 + len(one.others), []).append(one.name)
    if names:
        places = " and ".join(f"the {count} places of {join_names(some)}" for count, some in names.items())
        shown = f"show {len(pictures)} pictures, by copies of meshes and materials"
        yield f"{places} {'share one picture' if len(pictures) == 1 else shown}"
