"""`warpsample bake --texture`: compute a quantity at the texels of a mesh, and write a glTF file or an image."""

import json
from collections.abc import Iterator
from dataclasses import dataclass, fields
from functools import partial
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np

from warpsample.host.device_memory import Memory
from warpsample.host.files import check_output, complete_or_absent, write_arrays
from warpsample.mesh.files import load_mesh
from warpsample.mesh.files.beside import files_beside
from warpsample.mesh.mesh import Mesh
from warpsample.output.bake import input_files
from warpsample.output.bake_rules import check_table
from warpsample.output.baked import BakeRun
from warpsample.output.data_beside import check_data_beside, write_with_data
from warpsample.output.faces_option import with_optics
from warpsample.output.quantities import quantity_of
from warpsample.output.run_record import RunRecord
from warpsample.output.textures.choice import texture_options
from warpsample.output.textures.images import Filled, fill_texture
from warpsample.output.textures.instances import Picture, describe_places, pictures_of, place_pictures
from warpsample.texture.glb_file import GlbFile, convert_read_errors
from warpsample.texture.high import HighMesh
from warpsample.texture.inside import Closed
from warpsample.texture.jobs import TextureJob, describe_flaws, is_flat, plan_jobs
from warpsample.texture.materials import THICKNESS, Slot, add_texture, slot_for_quantity
from warpsample.texture.notes import (
    describe_coarse_texels,
    describe_light,
    describe_materials,
    describe_missing_files,
    join_names,
)
from warpsample.texture.pictures import check_library, encode_exr, encode_png
from warpsample.texture.primitives import Primitive, group_by_material, list_primitives
from warpsample.texture.sets import TextureOptions

_WITHOUT_LIGHT = ("normals", "position", "thickness")  # quantities that do not depend on light
_DATA = ".bin"  # suffix of the data beside a .gltf


def bake_texture(run: BakeRun) -> str:
    """Compute a run with `--texture` and write `run.output`, complete or not at all; an interrupt leaves the old file.

    Returns:
        a report for the terminal, in lines.

    Raises:
        TypeError, ValueError, FileNotFoundError: an argument that cannot be used, before anything is computed.
        KeyboardInterrupt: the run is interrupted; the message states how many texels are done.
        WriteError: the file cannot be written.
    """
    quantity = quantity_of(run.quantity)
    check_table(run)
    how = texture_options(run)
    _check(run, how)
    record = RunRecord(quantity.title, quantity.unit, things="points")
    with record.show(f"reading {run.mesh.name}"):
        baked = _read(run, how)
        found = _compute(baked, record)
        notes = _write(baked, found)
    lines = [f"{run.output}: {quantity.title} in {_count(found)} of {how.size[0]} x {how.size[1]} texels"]
    for row in found:
        lines += [line for picture in row for line in _describe_picture(picture.filled)]
        lines += describe_places(row)
    further = sum(picture.rays[1] for row in found for picture in row)
    lines += [*baked.coarse, *([f"{further:,} further rays cast to find points inside closed bodies"] if further else [])]
    return "\n  ".join([*lines, *record.describe(), *baked.notes, *notes])


@dataclass(frozen=True, eq=False)
class _TextureRun:
    """Source of a run with `--texture`, as read and checked.

    Attributes:
        run: Arguments of the command.
        how: Options of the texture.
        jobs: Textures to compute.
        file: glTF file to write the textures into, or None for an image.
        high: Finer mesh, or None.
        traced: Mesh that the rays are traced against.
        notes: Sentences on the file.
        coarse: Sentences on texels that are too small for the rays.
    """

    run: BakeRun
    how: TextureOptions
    jobs: list[TextureJob]
    file: GlbFile | None
    high: HighMesh | None
    traced: Mesh
    notes: list[str]
    coarse: list[str]


def _read(run: BakeRun, how: TextureOptions) -> _TextureRun:
    """Read the meshes of a run and plan its textures."""
    mesh = with_optics(load_mesh(run.mesh), **run.optics)
    jobs, file = plan_jobs(run.mesh, mesh, how, run.output.suffix, slot_for_quantity(run.quantity))
    high = None if how.high is None else HighMesh.load(how.high, how.cage, how.normals)
    notes = [] if file is None else _check_scene(file, run, how, jobs)
    traced = mesh if high is None else high.mesh
    return _TextureRun(run, how, jobs, file, high, traced, notes, _coarse(jobs, traced, how))


def _compute(baked: _TextureRun, record: RunRecord) -> list[list[Picture]]:
    """Compute the pictures of all textures."""
    closed = Closed(baked.traced)
    fill = partial(fill_texture, run=baked.run, how=baked.how, closed=closed, high=baked.high, record=record)
    points = sum(len(job.points) * (1 + max((len(one.others) for one in job.group), default=0)) for job in baked.jobs)
    with record.count(points, f"{baked.run.output} is as it was before"):
        return [pictures_of(job, fill, baked.how) for job in baked.jobs]


def _write(baked: _TextureRun, found: list[list[Picture]]) -> list[str]:
    """Write the pictures into a glTF file or an image, and return sentences on replaced textures."""
    if baked.file is not None:
        return _write_scene(baked.file, baked.run, baked.how, found)
    with complete_or_absent(baked.run.output) as stream:
        _write_image(stream, baked.run, baked.how, found[0][0].filled)
    return []


def _coarse(jobs: list[TextureJob], traced: Mesh, how: TextureOptions) -> list[str]:
    """Return sentences on jobs with texels too small for the rays; with `--strict` raise a ValueError instead."""
    lines = [(job, describe_coarse_texels(job.points, traced)) for job in jobs]
    found = [f"{job.name!r}: {line}" for job, line in lines if line is not None]
    if how.strict and found:
        raise ValueError(f"--strict: got {'; '.join(found)}")
    return found


def _check_scene(file: GlbFile, run: BakeRun, how: TextureOptions, jobs: list[TextureJob]) -> list[str]:
    """Check a .glb or .gltf before anything is computed, and return sentences on its materials and missing files."""
    with convert_read_errors(run.mesh):
        if run.output.suffix == ".gltf":
            file.check_no_trailing_bytes()
        group = [one for job in jobs for one in job.group]
        notes = list(describe_materials(file.part, group, slot_for_quantity(run.quantity).name))
        placed = list_primitives(file.part, file.data)
        if how.high is None and run.quantity not in _WITHOUT_LIGHT:  # a finer mesh has none of these materials
            notes += describe_light(file.part, placed, jobs[0].points.mesh.transmittance)
        groups = group_by_material(placed)
        several = join_names(one.name for job in jobs for one in job.group if one.others)
        flat = join_names(one.name for group in groups if is_flat(jobs[0].points.mesh, group) for one in group)
    if several and how.strict and how.instances == "mean":
        raise ValueError(f"--strict: got --instances mean for {several} in several places, want split")
    if flat:
        notes.append(f"without an area, and so left without a picture: {flat}")
    return [*notes, *describe_missing_files(run.mesh, file.tree, run.output)]


def _write_scene(file: GlbFile, run: BakeRun, how: TextureOptions, found: list[list[Picture]]) -> list[str]:
    """Write a .glb, or a .gltf and its data beside it, with all pictures; return sentences on what was replaced."""
    notes: list[str] = []
    slot = slot_for_quantity(run.quantity)
    for row, groups in zip(found, place_pictures(file, found), strict=True):
        for picture, group in reversed(list(zip(row, groups, strict=True))):  # copies are of unchanged materials
            notes += _put(file, picture.filled, group, slot, how)
    notes = list(dict.fromkeys(notes))
    if run.output.suffix == ".glb":
        with complete_or_absent(run.output) as stream:
            file.write(stream)
        return notes
    ways = {"write_data": file.write_data, "text_naming": file.text_naming, "named_by": files_beside}
    data = write_with_data(run.output, _DATA, **ways, inputs=_inputs(run, how))
    if data.stem != run.output.stem:
        notes.append(f"its data are in {data.name}: {run.output.with_suffix(_DATA).name} belongs to another file")
    return notes


def _inputs(run: BakeRun, how: TextureOptions) -> list[Path]:
    """Return the files that a run reads."""
    high = [] if how.high is None else [how.high, *files_beside(how.high)]
    return [*input_files(run, quantity_of(run.quantity)), *high]


def _check(run: BakeRun, how: TextureOptions) -> None:
    """Check the library of the output's format, the device and the paths, before any file is read."""
    check_library(run.output.suffix)
    Memory.of(run.options.get("device"))
    check_output(run.output, "--output", *_inputs(run, how))
    if run.output.suffix == ".gltf":
        check_data_beside(run.output, _DATA, "--output")


def _put(file: GlbFile, one: Filled, group: list[Primitive], slot: Slot, how: TextureOptions) -> Iterator[str]:
    """Add the picture of a job to a glTF file; lengths become fractions of the longest, in units of the primitives."""
    info: dict[str, Any] = {"texCoord": one.job.set} if one.job.set else {}
    info |= {"strength": how.strength} if how.strength != 1.0 else {}
    longest = float(one.value.max()) if slot is THICKNESS else 1.0
    more = {"thicknessFactor": longest} if slot is THICKNESS else {}
    png = encode_png(one.value / (longest or 1.0), how.depth)
    return add_texture(file, group, png, slot, info=info, more=more)


def _write_image(stream: BinaryIO, run: BakeRun, how: TextureOptions, found: Filled) -> None:
    """Write an image; an .npz also holds the texture coordinates and the arguments."""
    if run.output.suffix == ".png":
        stream.write(encode_png(found.value, how.depth))
    elif run.output.suffix == ".exr":
        stream.write(encode_exr({"": found.value, "standard_error": found.error}))
    else:
        texture = {f"texture_{item.name}": str(getattr(how, item.name)) for item in fields(how)}
        options = {name: str(value) for name, value in quantity_of(run.quantity).told(run.options).items()}
        uv = found.job.points.corners / np.array(how.size)
        arrays = {"value": found.value, "standard_error": found.error, "covered": found.job.points.covered, "uv": uv}
        write_arrays(stream, {**arrays, "run": np.array(json.dumps(run.recorded | options | texture))})


def _count(found: list[list[Picture]]) -> str:
    """Return the number of pictures as text."""
    count = sum(map(len, found))
    return "one picture" if count == 1 else f"{count} pictures"


def _describe_picture(found: Filled) -> Iterator[str]:
    """Yield sentences on a picture: mean, standard error, flaws of the coordinates, and filled points."""
    job, report = found.job, found.job.points.report
    known = np.sqrt(np.mean(np.square(found.error[job.points.covered], dtype=np.float64)))
    numbers = "none with a value" if np.isnan(found.mean) else f"mean {found.mean:.4f}; standard error {known:.2g}"
    yield f"{job.name!r}, {job.coordinates}: {report.covered:,} texels, {numbers}"
    yield from describe_flaws(job)
    if found.inside:
        yield f"{found.inside:,} points inside closed bodies, filled from their charts"
    if found.enclosed:
        yield f"{found.enclosed:,} points inside closed bodies keep their values, because their whole charts are inside"
    if found.missed:
        yield f"{found.missed:,} points without a hit on the finer mesh within the cage, filled from their charts"
    if found.lost:
        yield f"{found.lost:,} points without a value, filled from their charts"
