"""Writes numbers at the texels of a mesh into a .glb or an image: `warpsample bake --texture`."""

import json
from collections.abc import Iterator
from dataclasses import fields
from functools import partial
from pathlib import Path
from time import perf_counter
from typing import Any, BinaryIO

import numpy as np

from warpsample.estimate.quantities.record import Quantity
from warpsample.host.device_memory import Memory
from warpsample.host.files import check_output, complete_or_absent, write_arrays
from warpsample.mesh.files import load_mesh
from warpsample.mesh.files.beside import files_beside, pictures_beside
from warpsample.mesh.mesh import Mesh
from warpsample.output.baked import BakeRun
from warpsample.output.data_beside import check_data_beside, write_with_data
from warpsample.output.faces_option import with_optics
from warpsample.output.quantities import check_options, quantity_of
from warpsample.output.texture_images import Filled, filled
from warpsample.output.texture_instances import Picture, describe_places, pictures_of, place_pictures
from warpsample.texture.glb_file import GlbFile, convert_read_errors
from warpsample.texture.high import HighMesh
from warpsample.texture.inside import Closed
from warpsample.texture.jobs import SCENES, TextureJob, describe_flaws, plan_jobs
from warpsample.texture.materials import OCCLUSION, THICKNESS, Slot, add_texture, slot_for_quantity
from warpsample.texture.notes import (
    describe_coarse_texels,
    describe_light,
    describe_materials,
    describe_missing_files,
    join_names,
)
from warpsample.texture.pictures import DEPTHS, check_library, encode_exr, encode_png
from warpsample.texture.primitives import Primitive, group_by_material, is_flat, list_primitives, visible_primitives
from warpsample.texture.sets import TextureOptions

SUFFIXES = (*SCENES, ".png", ".exr", ".npz")
"""Suffixes of the files that hold textures."""

_INTO_PNG = (0.0, 1.0)
"""What the numbers are that a .png holds."""

_WITHOUT_LIGHT = ("normals", "position", "thickness")  # quantities that no light goes into
_DATA = ".bin"  # suffix of the data beside a .gltf


def bake_texture(run: BakeRun, how: TextureOptions) -> str:
    """Runs and writes `run.output`, which appears when it is complete; an interrupted run leaves the old file.

    Gives a report in sentences. An argument that cannot be used is refused before anything is computed.
    """
    quantity = quantity_of(run.quantity)
    _check(run, quantity, how)
    mesh = with_optics(load_mesh(run.mesh), **run.optics)
    slot = slot_for_quantity(quantity.name)
    jobs, file = plan_jobs(run.mesh, mesh, how, run.output.suffix, slot)
    high = None if how.high is None else HighMesh.load(how.high, how.cage, how.normals)
    told = [] if file is None else _before(file, run, how, jobs)
    traced = mesh if high is None else high.mesh
    coarse = _coarse(jobs, traced, how)
    closed, start = Closed(traced), perf_counter()
    fill = partial(filled, run=run, how=how, closed=closed, high=high)
    found = [pictures_of(job, fill, how) for job in jobs]
    seconds = perf_counter() - start
    _refuse_mostly_inside(found, how)
    if file is None:
        with complete_or_absent(run.output) as stream:
            _write_image(stream, run, how, found[0][0].filled)
    else:
        told += _write_scene(file, run, how, found, slot)
    count = sum(len(row) for row in found)
    lines = [f"{run.output}: {quantity.title} in {_pictures(count)} of {how.size[0]} x {how.size[1]} texels"]
    for row in found:
        lines += [line for picture in row for line in _told(picture.filled)]
        lines += describe_places(row)
    lines += coarse
    rays, further = (sum(picture.rays[kind] for row in found for picture in row) for kind in (0, 1))
    lines += [f"{further:,} further rays cast to find points inside closed bodies"] if further else []
    cast = f"{rays:,} rays cast in {seconds:.2f} s, {rays / max(seconds, 1e-9) / 1e6:.1f} million a second"
    return "\n  ".join([*lines, cast if rays else f"took {seconds:.2f} s", *told])


def _coarse(jobs: list[TextureJob], traced: Mesh, how: TextureOptions) -> list[str]:
    """Return sentences on jobs with texels too small for the rays; with `--strict` raise a ValueError instead."""
    told = [(job, describe_coarse_texels(job.points, traced)) for job in jobs]
    found = [f"{job.name!r}: {line}" for job, line in told if line is not None]
    if how.strict and found:
        raise ValueError(f"--strict: got {'; '.join(found)}")
    return found


def _refuse_mostly_inside(found: list[list[Picture]], how: TextureOptions) -> None:
    """With `--strict`, raise a ValueError for charts with more than half of their points filled for being inside."""
    pictures = (picture.filled for row in found for picture in row)
    doubtful = [f"{one.job.name!r}: {_describe_mostly_inside(one)}" for one in pictures if one.mostly_inside]
    if how.strict and doubtful:
        raise ValueError(f"--strict: got {'; '.join(doubtful)}")


def _describe_mostly_inside(found: Filled) -> str:
    """Return a sentence on charts with more than half of their points filled for being inside closed bodies."""
    charts = "one chart is" if found.mostly_inside == 1 else f"{found.mostly_inside:,} charts are"
    return f"{charts} more than half inside closed bodies and filled: if a body is a room, pass --inside keep"


def _before(file: GlbFile, run: BakeRun, how: TextureOptions, jobs: list[TextureJob]) -> list[str]:
    """Checks a .glb or .gltf before anything is computed; what is to be said of it."""
    with convert_read_errors(run.mesh):
        if run.output.suffix == ".gltf":
            file.check_no_trailing_bytes()
        told = list(
            describe_materials(file.part, [one for job in jobs for one in job.group], slot_for_quantity(run.quantity).name)
        )
        mesh = jobs[0].points.mesh
        placed = visible_primitives(list_primitives(file.part, file.data), mesh)
        if how.high is None and run.quantity not in _WITHOUT_LIGHT:  # a finer mesh has none of these materials
            told += describe_light(file.part, placed, mesh)
        groups = group_by_material(placed)
        several = join_names(one.name for job in jobs for one in job.group if one.others)
        flat = join_names(one.name for group in groups if is_flat(mesh, group) for one in group)
    if several and how.strict and how.instances == "mean":
        raise ValueError(f"--strict: got --instances mean for {several} in several places, want split")
    if flat:
        told.append(f"without an area, and so left without a picture: {flat}")
    return [*told, *describe_missing_files(run.mesh, file.tree, run.output)]


def _write_scene(file: GlbFile, run: BakeRun, how: TextureOptions, found: list[list[Picture]], slot: Slot) -> list[str]:
    """Write a .glb, or a .gltf and its data beside it, with all pictures; return sentences on what was replaced."""
    told: list[str] = []
    for row, groups in zip(found, place_pictures(file, found), strict=True):
        for picture, group in reversed(list(zip(row, groups, strict=True))):  # copies are of unchanged materials
            told += _put(file, picture.filled, group, slot, how)
    told = list(dict.fromkeys(told))
    if run.output.suffix == ".glb":
        with complete_or_absent(run.output) as stream:
            file.write(stream)
        return told
    ways = {"write_data": file.write_data, "text_naming": file.text_naming, "named_by": files_beside}
    data = write_with_data(run.output, _DATA, **ways, inputs=[*_inputs(run, how), *pictures_beside(run.output)])
    if data.stem != run.output.stem:
        told.append(f"its data are in {data.name}: {run.output.with_suffix(_DATA).name} belongs to another file")
    return told


def _inputs(run: BakeRun, how: TextureOptions) -> list[Path]:
    """Return the files that a run reads."""
    named = [run.options.get(option) for option in quantity_of(run.quantity).files]
    files = [*named, run.mesh, how.high, *files_beside(run.mesh), *files_beside(how.high)]
    return [file for file in files if file is not None]


def _check(run: BakeRun, quantity: Quantity, how: TextureOptions) -> None:
    suffix, name = run.output.suffix, str(run.output)
    if suffix not in SUFFIXES:
        wants = f"want a file that ends in one of {' '.join(SUFFIXES)}, in lower case"
        raise ValueError(f"--output: got {name!r} for --texture, {wants}")
    if suffix in SCENES and run.mesh.suffix.lower() not in SCENES:
        raise ValueError(
            f"--output: got {name!r} for {run.mesh.name!r}, want .png, .exr or .npz: only glTF becomes a {suffix}"
        )
    if quantity.is_matrix:
        raise ValueError(f"--quantity: got {quantity.name} for --texture, want one of a few numbers at each point")
    _check_picture(run, quantity, how)
    check_library(suffix)
    Memory.of(run.options.get("device"))
    check_output(run.output, "--output", *_inputs(run, how))
    if suffix == ".gltf":
        check_data_beside(run.output, _DATA, "--output")
    check_options(quantity, run.options)


def _check_picture(run: BakeRun, quantity: Quantity, how: TextureOptions) -> None:
    """Refuses numbers, and options of pictures, that do not go together with the file to write."""
    suffix = run.output.suffix
    slot = slot_for_quantity(quantity.name)
    if slot is THICKNESS and how.normals == "lifted":
        raise ValueError("--normals: got lifted for thickness, want face or smooth: its rays start beneath the face")
    fits = slot.directed or (slot is THICKNESS and suffix in SCENES)
    if suffix in (*SCENES, ".png") and not fits and getattr(quantity.result, "possible", None) != _INTO_PNG:
        raise ValueError(
            f"--quantity: got {quantity.name} for {run.output.name!r}, want .exr or .npz: a {suffix} holds 0 to 1"
        )
    if suffix not in SCENES and how.instances != "split":
        raise ValueError(f"--instances: got {how.instances} for {run.output.name!r}; it applies only to .glb and .gltf")
    if (suffix not in SCENES or slot is not OCCLUSION) and how.strength != 1.0:
        what = quantity.name if suffix in SCENES else repr(run.output.name)
        raise ValueError(f"--strength: got {how.strength:g} for {what}; it applies only to occlusion in a .glb")
    if slot.directed and how.depth != DEPTHS[0]:
        raise ValueError(f"--depth: got {how.depth} for {quantity.name}, want 8, or an .exr")
    if suffix not in (*SCENES, ".png") and how.depth != DEPTHS[0]:
        raise ValueError(f"--depth: got {how.depth} for {run.output.name!r}; it applies only to .glb and .png")


def _put(file: GlbFile, one: Filled, group: list[Primitive], slot: Slot, how: TextureOptions) -> Iterator[str]:
    """Puts the picture of a job into a .glb: lengths as shares of the longest, in units of the primitives."""
    info: dict[str, Any] = {"texCoord": one.job.set} if one.job.set else {}
    info |= {"strength": how.strength} if how.strength != 1.0 else {}
    longest = float(one.value.max()) if slot is THICKNESS else 1.0
    more = {"thicknessFactor": longest} if slot is THICKNESS else {}
    png = encode_png(one.value / (longest or 1.0), how.depth)
    return add_texture(file, group, png, slot, info=info, more=more)


def _write_image(stream: BinaryIO, run: BakeRun, how: TextureOptions, found: Filled) -> None:
    """Writes the images of a file of its own: an .npz also tells the texture coordinates that they are for, and the run."""
    if run.output.suffix == ".png":
        stream.write(encode_png(found.value, how.depth))
    elif run.output.suffix == ".exr":
        stream.write(encode_exr({"": found.value, "standard_error": found.error}))
    else:
        texture = {f"texture_{item.name}": str(getattr(how, item.name)) for item in fields(how)}
        options = {name: str(value) for name, value in quantity_of(run.quantity).told(run.options).items()}
        uv = found.job.points.corners / np.array(how.size)
        arrays = {"value": found.value, "standard_error": found.error, "covered": found.job.points.covered, "uv": uv}
        write_arrays(stream, {**arrays, "run": np.array(json.dumps(run.told | options | texture))})


def _pictures(count: int) -> str:
    return "one picture" if count == 1 else f"{count} pictures"


def _told(found: Filled) -> Iterator[str]:
    """A job in sentences."""
    job, report = found.job, found.job.points.report
    known = np.sqrt(np.mean(np.square(found.error[job.points.covered], dtype=np.float64)))
    numbers = "none with a number" if np.isnan(found.mean) else f"mean {found.mean:.4f}; standard error {known:.2g}"
    yield f"{job.name!r}, {job.coordinates}: {report.covered:,} texels, {numbers}"
    yield from describe_flaws(job)
    if found.inside:
        yield f"{found.inside:,} points inside closed bodies, filled from their charts"
    if found.mostly_inside:
        yield _describe_mostly_inside(found)
    if found.enclosed:
        yield f"{found.enclosed:,} points inside closed bodies keep their numbers, as their whole charts are inside"
    if found.missed:
        yield f"{found.missed:,} points that met nothing of the finer mesh within the cage, filled from their charts"
    if found.lost:
        yield f"{found.lost:,} points without a number, filled from their charts"
