"""`warpsample bake --texture`: compute a quantity at the texels of a mesh, and write a glTF file or an image."""

import json
from collections.abc import Iterator
from dataclasses import fields
from functools import partial
from typing import Any, BinaryIO

import numpy as np

from warpsample.host.files import complete_or_absent, write_arrays
from warpsample.output.baked import BakeRun
from warpsample.output.quantities import quantity_of
from warpsample.output.run_record import RunRecord
from warpsample.output.textures.images import Filled, Images, fill_texture
from warpsample.output.textures.instances import Encoded, PlacedTexture, describe_places, pictures_of, place_pictures
from warpsample.output.textures.source import TextureSource
from warpsample.texture.glb_file import GlbFile
from warpsample.texture.inside import Closed
from warpsample.texture.jobs import describe_flaws
from warpsample.texture.materials import THICKNESS, Slot, Users, add_texture, find_users, slot_for_quantity
from warpsample.texture.notes import describe_rounding
from warpsample.texture.pictures import encode_exr, encode_png
from warpsample.texture.primitives import Primitive
from warpsample.texture.sets import TextureOptions
from warpsample.texture.tangents import FrameReader


def bake_texture(source: TextureSource, record: RunRecord) -> str:
    """Compute the textures of a `warpsample bake --texture` command, write the output, and return a report in lines.

    Args:
        source: Source of the run, as `read_texture_source` returns it.
        record: Record of the run.

    Returns:
        a report for the terminal, in lines.

    Raises:
        ValueError: an input file has changed since it was read; no texel has a value; or with `--strict`, more than half of
            a chart is inside closed bodies.
        KeyboardInterrupt: the run is interrupted; the message states how many points are done.
        WriteError: the file cannot be written.
    """
    found = _compute(source, record)
    _refuse_without_values(source, found)
    _refuse_mostly_inside(source, found)
    notes = _write(source, found)
    width, height = source.how.size
    lines = [f"{source.run.output}: {record.title} in {_count(found)} of {width} x {height} texels"]
    for row in found:
        lines += [line for picture in row for line in _describe_picture(picture.filled)]
        lines += describe_places(row)
    further = sum(picture.rays[1] for row in found for picture in row)
    lines += [*source.coarse, *([f"{further:,} further rays cast to find points inside closed bodies"] if further else [])]
    are_filled = any(picture.filled.inside for row in found for picture in row)
    values_of = "with the values that are replaced: " if are_filled else ""
    return "\n  ".join([*lines, *record.describe(values_of), *source.notes, *notes])


def _compute(source: TextureSource, record: RunRecord) -> list[list[PlacedTexture]]:
    """Compute the images of all textures of a command, for each place of the meshes in the scene."""
    closed = Closed(source.traced)
    reader = FrameReader(source.run.mesh, source.mesh)
    fill = partial(
        fill_texture, run=source.run, how=source.how, closed=closed, high=source.high, reader=reader, record=record
    )
    encode = _keep if source.file is None else partial(_encode, source.run, source.how)
    points = sum(job.count * job.places for job in source.jobs)
    with record.count(points, f"{source.run.output} is as it was before"):
        try:  # coordinates, normals and tangents are read from the files again
            found = [pictures_of(job, fill, source.how, encode) for job in source.jobs]
        except (TypeError, ValueError, OSError):
            source.state.check()
            raise
    source.state.check()
    return found


def _keep(images: Images) -> Images:
    """Return images as they are, for a file that holds a single picture."""
    return images


def _encode(run: BakeRun, how: TextureOptions, images: Images) -> Encoded:
    """Encode the values of a texture as a .png; lengths become fractions of the longest length."""
    longest = float(images.value.max()) if slot_for_quantity(run.quantity) is THICKNESS else 1.0
    return Encoded(encode_png(images.value / (longest or 1.0), how.depth), longest)


def _refuse_without_values(source: TextureSource, found: list[list[PlacedTexture]]) -> None:
    """Raise a ValueError if no texel of any picture has a value."""
    if not all(np.isnan(picture.filled.mean) for row in found for picture in row):
        return
    if source.high is not None:
        raise ValueError(
            f"--cage: got {source.how.cage:g}, within which no texel finds a face of {str(source.how.high)!r}, want a "
            "larger distance, or a finer mesh in the same place"
        )
    quantity = source.run.quantity
    raise ValueError(f"mesh: got {source.run.mesh.name!r}, at whose texels {quantity} has no value, want another mesh")


def _refuse_mostly_inside(source: TextureSource, found: list[list[PlacedTexture]]) -> None:
    """Raise a ValueError, with `--strict`, if most points of a UV chart are inside closed bodies."""
    pictures = (picture.filled for row in found for picture in row)
    doubtful = [f"{one.job.name!r}: {_describe_mostly_inside(one)}" for one in pictures if one.mostly_inside]
    if source.how.strict and doubtful:
        raise ValueError(f"--strict: got {'; '.join(doubtful)}")


def _describe_mostly_inside(found: Filled) -> str:
    """Return a warning about UV charts most of whose points are inside closed bodies."""
    charts = "one chart is" if found.mostly_inside == 1 else f"{found.mostly_inside:,} charts are"
    return f"{charts} more than half inside closed bodies and filled: if a body is a room, pass --inside keep"


def _write(source: TextureSource, found: list[list[PlacedTexture]]) -> list[str]:
    """Write the pictures into a glTF file or an image; return sentences on replaced textures and rounded positions."""
    if source.file is not None:
        return _write_scene(source.file, source, found)
    images = found[0][0].picture
    assert isinstance(images, Images)
    with complete_or_absent(source.run.output) as stream:
        _write_image(stream, source.run, source.how, images)
    is_rounded = source.run.output.suffix == ".exr" and images.value.dtype == np.float64
    return list(describe_rounding(images.points, images.value)) if is_rounded else []


def _write_scene(file: GlbFile, source: TextureSource, found: list[list[PlacedTexture]]) -> list[str]:
    """Write a .glb or .gltf with all pictures; return sentences on replaced textures."""
    run, notes = source.run, list[str]()
    slot, placed = slot_for_quantity(run.quantity), place_pictures(file, found)
    users = find_users(file)
    for row, groups in zip(found, placed, strict=True):
        for number, (picture, group) in reversed(list(enumerate(zip(row, groups, strict=True)))):
            notes += _add_picture(file, users, picture, group, slot, source.how, is_first=number == 0)
    notes = list(dict.fromkeys(notes))
    with complete_or_absent(run.output) as stream:
        (file.write if run.output.suffix == ".glb" else file.write_text)(stream)
    return notes


def _add_picture(
    file: GlbFile,
    users: Users,
    one: PlacedTexture,
    group: list[Primitive],
    slot: Slot,
    how: TextureOptions,
    *,
    is_first: bool,
) -> Iterator[str]:
    """Store a picture in a glTF file as a texture, and return sentences on textures that it replaces."""
    assert isinstance(one.picture, Encoded)
    info: dict[str, Any] = {"texCoord": one.filled.job.set} if one.filled.job.set else {}
    info |= {"strength": how.strength} if how.strength != 1.0 else {}
    more = {"thicknessFactor": one.picture.longest} if slot is THICKNESS else {}
    return add_texture(file, users, group, one.picture.png, slot, is_first=is_first, info=info, more=more)


def _write_image(stream: BinaryIO, run: BakeRun, how: TextureOptions, found: Images) -> None:
    """Write an image; an .npz also holds the texture coordinates and the arguments."""
    if run.output.suffix == ".png":
        stream.write(encode_png(found.value, how.depth))
    elif run.output.suffix == ".exr":
        stream.write(encode_exr({"": found.value, "standard_error": found.error}))
    else:
        texture = {f"texture_{item.name}": str(getattr(how, item.name)) for item in fields(how)}
        options = {name: str(value) for name, value in quantity_of(run.quantity).recorded_options(run.options).items()}
        uv = found.points.corners / np.array(how.size)
        arrays = {"value": found.value, "standard_error": found.error, "covered": found.points.covered, "uv": uv}
        write_arrays(stream, {**arrays, "run": np.array(json.dumps(run.recorded | options | texture))})


def _count(found: list[list[PlacedTexture]]) -> str:
    """Return the number of computed images as text, for example "2 pictures"."""
    count = sum(map(len, found))
    return "one picture" if count == 1 else f"{count} pictures"


def _describe_picture(found: Filled) -> Iterator[str]:
    """Yield sentences on a picture: mean, standard error, flaws of the coordinates, and filled points."""
    job, error = found.job, found.error
    numbers = "none with a value" if np.isnan(found.mean) else f"mean {found.mean:.4f}; standard error {error:.2g}"
    yield f"{job.name!r}, {job.coordinates}: {found.report.covered:,} texels, {numbers}"
    yield from describe_flaws(found.report)
    if found.inside:
        yield f"{found.inside:,} points inside closed bodies, filled from their charts"
    if found.mostly_inside:
        yield _describe_mostly_inside(found)
    if found.enclosed:
        yield f"{found.enclosed:,} points inside closed bodies keep their values, because their whole charts are inside"
    filled = "left at 0" if np.isnan(found.mean) else "filled from their charts, or from others where theirs have no value"
    if found.missed:
        yield f"{found.missed:,} points without a hit on the finer mesh within the cage, {filled}"
    if found.lost:
        yield f"{found.lost:,} points without a value, {filled}"
