"""Input of a `warpsample bake --texture` command: the checked arguments, the meshes, and the textures to compute."""

from dataclasses import dataclass
from pathlib import Path

from warpsample.host.device_memory import Memory
from warpsample.host.files import check_output
from warpsample.mesh.files import load_mesh
from warpsample.mesh.files.linked_files import list_linked_files
from warpsample.mesh.mesh import Mesh
from warpsample.output.bake_rules import check_table
from warpsample.output.baked import BakeRun
from warpsample.output.faces_option import with_optics
from warpsample.output.input_state import InputState
from warpsample.output.quantities import quantity_of
from warpsample.output.source import input_files
from warpsample.output.textures.choice import texture_options
from warpsample.texture.glb_file import GlbFile, convert_read_errors
from warpsample.texture.high import HighMesh
from warpsample.texture.jobs import TextureJob, plan_jobs
from warpsample.texture.materials import slot_for_quantity
from warpsample.texture.notes import describe_light, describe_materials, describe_missing_files, join_names
from warpsample.texture.pictures import check_library
from warpsample.texture.primitives import group_by_material, is_flat, list_primitives, visible_primitives
from warpsample.texture.sets import TextureOptions
from warpsample.texture.uv.new_uv import describe_extensions

_WITHOUT_LIGHT = ("normals", "position", "thickness")  # quantities that do not depend on light


@dataclass(frozen=True, eq=False)
class TextureSource:
    """Input of a `warpsample bake --texture` command, checked and loaded: arguments, meshes, and textures to compute.

    Attributes:
        run: Arguments of the command.
        state: State of the input files before they were read.
        how: Options of the texture.
        jobs: Textures to compute.
        mesh: Mesh of the run.
        file: glTF file to write the textures into, or None for an image.
        high: Finer mesh, or None.
        traced: Mesh that the rays are traced against.
        notes: Sentences on the file.
        coarse: Sentences on texels that are too small for the rays.
    """

    run: BakeRun
    state: InputState
    how: TextureOptions
    jobs: list[TextureJob]
    mesh: Mesh
    file: GlbFile | None
    high: HighMesh | None
    traced: Mesh
    notes: list[str]
    coarse: list[str]


def read_texture_source(run: BakeRun) -> TextureSource:
    """Check the arguments of a `warpsample bake --texture` command, read the meshes, and list the textures to compute.

    Raises:
        TypeError, ValueError, FileNotFoundError: a file or an option that cannot be used; the message names the option.
    """
    check_table(run)
    how = texture_options(run)
    _check(run, how)
    state = InputState.of(run.mesh, how.high)
    mesh = load_mesh(run.mesh)
    high = None if how.high is None else HighMesh.load(how.high, how.cage, how.normals)
    traced = with_optics(mesh if high is None else high.mesh, **run.optics)
    mesh = traced if high is None else mesh
    jobs, file = plan_jobs(run.mesh, mesh, how, run.output.suffix, slot=slot_for_quantity(run.quantity), traced=traced)
    notes = [] if file is None else _check_scene(file, mesh, run, how, jobs)
    return TextureSource(run, state, how, jobs, mesh, file, high, traced, notes, _list_coarse(jobs, how))


def _list_coarse(jobs: list[TextureJob], how: TextureOptions) -> list[str]:
    """Return the warnings about textures with texels too small for the rays; with `--strict` raise a ValueError instead."""
    found = [f"{job.name!r}: {job.coarse}" for job in jobs if job.coarse is not None]
    if how.strict and found:
        raise ValueError(f"--strict: got {'; '.join(found)}")
    return found


def _check_scene(file: GlbFile, mesh: Mesh, run: BakeRun, how: TextureOptions, jobs: list[TextureJob]) -> list[str]:
    """Check a .glb or .gltf before anything is computed, and return sentences on its materials and missing files."""
    slot = slot_for_quantity(run.quantity)
    with convert_read_errors(run.mesh):
        if run.output.suffix == ".gltf":
            file.check_no_trailing_bytes()
        group = [one for job in jobs for one in job.group]
        notes = list(describe_materials(file.part, group, slot.name))
        placed = visible_primitives(list_primitives(file.part, file.data), mesh)
        if how.high is None and run.quantity not in _WITHOUT_LIGHT:  # a finer mesh has none of these materials
            notes += describe_light(file.part, placed, mesh)
        groups = group_by_material(placed)
        new = [one for job in jobs for one in job.group if f"TEXCOORD_{job.set}" not in one.part.part("attributes")]
        notes += describe_extensions(file.part, new)
        several = join_names(one.name for job in jobs for one in job.group if one.others)
        faceted = join_names(one.name for one in group if slot.directed and "NORMAL" not in one.part.part("attributes"))
        flat = join_names(one.name for group in groups if is_flat(mesh, group) for one in group)
    if several and how.strict and how.instances == "mean":
        raise ValueError(f"--strict: got --instances mean for {several} in several places, want --instances split")
    if faceted:
        notes.append(f"without NORMAL, and so baked for the flat normals of viewers: {faceted}")
    if flat:
        notes.append(f"without an area, and so left without a picture: {flat}")
    return [*notes, *describe_missing_files(run.mesh, file.tree, run.output)]


def _inputs(run: BakeRun, how: TextureOptions) -> list[Path]:
    """Return the paths of all files that a `warpsample bake --texture` command reads."""
    high = [] if how.high is None else [how.high, *list_linked_files(how.high)]
    return [*input_files(run, quantity_of(run.quantity)), *high]


def _check(run: BakeRun, how: TextureOptions) -> None:
    """Check the library of the output's format, the device and the paths, before any file is read."""
    check_library(run.output.suffix)
    Memory.of(run.options.get("device"))
    check_output(run.output, "--output", *_inputs(run, how))
