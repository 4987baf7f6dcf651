"""List of images to bake: one for each group of glTF primitives that share materials, or one for a whole file."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

import numpy as np

from warpsample.host.json_tree import Part
from warpsample.mesh.files.gltf import check_supported
from warpsample.mesh.files.normals import read_normals, read_smooth_normals
from warpsample.mesh.files.uv import LAST_SET
from warpsample.mesh.mesh import Mesh
from warpsample.texture.glb_file import GlbFile, convert_read_errors
from warpsample.texture.high import average_normals
from warpsample.texture.materials import OCCLUSION, Slot, name_group
from warpsample.texture.notes import describe_coarse_texels, join_names
from warpsample.texture.primitives import Primitive, group_by_material, is_flat, list_primitives, visible_primitives
from warpsample.texture.report import TextureReport
from warpsample.texture.sets import Texels, TextureOptions
from warpsample.texture.texture_points import TexturePoints
from warpsample.texture.uv.new_uv import add_uv, charts_for
from warpsample.texture.uv.unwrapping import PADDING, unwrap

_FLAWS = {
    "overlapped": "overlapping texels, which show one of several faces",
    "outside": "faces partly or wholly outside the image",
    "zero_area": "faces without an area in the image",
    "flat_slivers": "slivers of the mesh without an area in the image",
    "squeezed": "faces more than eight texels wide on the mesh but less than one in the image",
    "mirrored": "mirrored faces",
}
REFUSED = ("overlapped", "outside", "zero_area", "squeezed")
"""Flaws of texture coordinates that are an error with `--strict`."""
SCENES = (".glb", ".gltf")
"""Suffixes of files whose materials receive the pictures."""

_MOST_NAMES = 5  # most meshes named per flaw


@dataclass(frozen=True, eq=False)
class TextureJob:
    """One image to bake: its faces, texels, texture coordinates and material slot.

    Attributes:
        name: name of the material, or of the file.
        points_at: function that returns the texels of the primitives at one place as points on the mesh.
        report: report on the coordinates at the first place.
        count: number of points there.
        coarse: warning about texels that are too small for the rays, at any place, or None.
        set: number of the set of texture coordinates; for new coordinates, the number that the set gets.
        coordinates: description of the coordinates, and of sets of the file that are not used.
        group: primitives that show the image; empty for an image of a whole file.
    """

    name: str
    points_at: Callable[[list[Primitive]], TexturePoints]
    report: TextureReport
    count: int
    coarse: str | None
    set: int
    coordinates: str
    group: list[Primitive]

    @property
    def places(self) -> int:
        """Number of places of the mesh in the scene."""
        return 1 + max((len(one.others) for one in self.group), default=0)

    def make_points(self) -> TexturePoints:
        """Compute the texels as points on the mesh; hold them for one image at a time, since they take much memory."""
        return self.points_at(self.group)

    def at_other_places(self) -> Iterator["TextureJob"]:
        """Yield a copy of this job for each further place of its mesh in the scene."""
        for place in range(self.places - 1):
            group = [one.others[place] for one in self.group if place < len(one.others)]
            yield replace(self, name=f"{self.name}, place {place + 2}", group=group)

    def convert_lengths(
        self, lengths: np.ndarray, directions: np.ndarray, face: np.ndarray, weights: np.ndarray
    ) -> np.ndarray:
        """Return lengths in the scene as lengths in the glTF meshes, (P,) float64; see `Primitive.convert_lengths`."""
        found = lengths.astype(np.float64)
        group = sorted(self.group, key=lambda one: (one.faces.start, one.faces.stop))  # those without faces before others
        owner = np.searchsorted([one.faces.start for one in group], face, side="right") - 1
        order = np.argsort(owner, kind="stable")
        for rows in np.split(order, 1 + np.flatnonzero(np.diff(owner[order]))) if len(order) else ():
            one = group[owner[rows[0]]]
            found[rows] = one.convert_lengths(lengths[rows], directions[rows], face[rows], weights[rows])
        return found


def plan_jobs(
    path: Path, mesh: Mesh, how: TextureOptions, output: str, *, slot: Slot, traced: Mesh
) -> tuple[list[TextureJob], GlbFile | None]:
    """List all images to bake for an output file; for a .glb or .gltf, also return the scene with new coordinates.

    New texture coordinates are already added to the .glb.

    Args:
        path: file with the mesh.
        mesh: mesh as `load_mesh` reads it.
        how: options of the texture.
        output: suffix of the output file.
        slot: place of the image in a material.
        traced: mesh that the rays are traced against.

    Raises:
        ValueError: the coordinates cannot be used, or have flaws and `how.strict` is set.
    """
    jobs, file = (
        _plan_scene_jobs(path, mesh, how, slot, traced)
        if output in SCENES
        else ([_plan_file_job(path, mesh, how, output, traced)], None)
    )
    if how.strict:
        reports = [report for job in jobs for report in _report_places(job)]
        if flaws := list(dict.fromkeys(line for report in reports for line in describe_flaws(report, REFUSED))):
            raise ValueError(f"--strict: got {path.name!r} with {'; '.join(flaws)}")
    return jobs, file


def _report_places(job: TextureJob) -> Iterator[TextureReport]:
    """Yield the reports on the texture coordinates of an image at each place of its mesh; others may stretch other faces."""
    yield job.report
    for other in job.at_other_places():
        yield other.make_points().report


def describe_flaws(report: TextureReport, names: Sequence[str] = tuple(_FLAWS)) -> Iterator[str]:
    """Yield phrases on flaws of the texture coordinates of an image to bake, for example overlapping faces."""
    for name in names:
        count, parts = getattr(report, name), report.named[name]
        if count:
            more = f" and {len(parts) - _MOST_NAMES:,} more" if len(parts) > _MOST_NAMES else ""
            yield f"{_FLAWS[name]}: {count:,}" + (f" ({join_names(parts[:_MOST_NAMES])}{more})" if any(parts) else "")


def _plan_scene_jobs(
    path: Path, mesh: Mesh, how: TextureOptions, slot: Slot, traced: Mesh
) -> tuple[list[TextureJob], GlbFile]:
    """List an image to bake for each group of primitives that share materials; also return the edited scene."""
    with convert_read_errors(path):
        file = GlbFile(path)
        check_supported(file.part)
        slotted = list(_groups_with_slot(file, mesh, slot))
        texels = Texels(path, mesh, how, _read_corner_normals(path, mesh, how))
    if not slotted:
        raise ValueError(
            f"--quantity: got {slot.name} for {path.name!r}, whose materials lack {slot.containers[-1]}, the parent of "
            f"{slot.key}, want a file with that glTF extension, or an .exr or .npz as --output"
        )
    groups = [group for group in slotted if not is_flat(mesh, group)]
    if not groups:
        raise ValueError("mesh: got only faces without an area, want at least one face with an area")
    jobs, materials = [], file.part.parts("materials")
    for group in groups:
        rows, name = [one.faces for one in group if not is_flat(mesh, [one])], name_group(file, group)
        with convert_read_errors(path):
            first = _find_set(materials, group, slot)
        others = [place.faces for one in group for place in one.others if not is_flat(mesh, [place])]
        found = texels.choose_set(rows, name, first=first, others=others)
        if found.points is None:
            faced = [one for one in group if len(one.triangles)]
            charts = charts_for(faced, mesh, square_side(how.size, found.passed))
            with convert_read_errors(path):
                number, uv = add_uv(file, faced, charts)
            points_at = partial(_make_points_by_new_uv, texels, uv, faced)
            label = found.describe(f"new coordinates, set {number}")
            jobs.append(TextureJob(name, points_at, *_look_at(points_at(faced), traced, faced), number, label, faced))
        else:
            own = f"TEXCOORD_{found.number}"
            able = [one for one in group if own in one.part.part("attributes")]  # flat primitives may lack the set
            points_at, label = partial(_make_points_by_set, texels, found.number), found.describe(f"set {found.number}")
            jobs.append(TextureJob(name, points_at, *_look_at(found.points, traced, able), found.number, label, able))
    return jobs, file


def _look_at(points: TexturePoints, traced: Mesh, group: Sequence[Primitive] = ()) -> tuple[TextureReport, int, str | None]:
    """Return the fields `report`, `count` and `coarse` of a texture to compute."""
    return points.report, len(points), describe_coarse_texels(points, traced, group)


def _make_points_by_set(texels: Texels, number: int, group: list[Primitive]) -> TexturePoints:
    """Return the texels of glTF primitives as points, by the file's set of texture coordinates `number`."""
    return texels.points_by_set(number, [one.faces for one in group if not is_flat(texels.mesh, [one])])


def _make_points_by_new_uv(
    texels: Texels, uv: list[np.ndarray], first: list[Primitive], group: list[Primitive]
) -> TexturePoints:
    """Return the texels of primitives at another place, by texture coordinates computed at their first place."""
    known = {(one.mesh, one.number): (one, own) for one, own in zip(first, uv, strict=True)}
    found = [(one, *known[one.mesh, one.number]) for one in group if not is_flat(texels.mesh, [one])]
    parts = [(one.faces, own if one.mirrored == source.mirrored else own[:, ::-1]) for one, source, own in found]
    return texels.points(parts)


def _groups_with_slot(file: GlbFile, mesh: Mesh, slot: Slot) -> Iterator[list[Primitive]]:
    """Yield the groups of primitives whose materials can show a texture of the given kind."""
    materials = file.part.parts("materials")
    for group in group_by_material(visible_primitives(list_primitives(file.part, file.data), mesh)):
        if slot.optional or any(
            slot.find_holder(materials[number]) is not None for one in group for number in one.materials
        ):
            yield group


def _plan_file_job(path: Path, mesh: Mesh, how: TextureOptions, output: str, traced: Mesh) -> TextureJob:
    """Return the single image to bake for all faces of a file that is no scene."""
    with convert_read_errors(path):
        texels, rows = Texels(path, mesh, how, _read_corner_normals(path, mesh, how)), [slice(0, len(mesh.faces))]
    found = texels.choose_set(rows, path.name, lenient=output != ".npz")
    if found.points is not None:
        number, label = found.number, found.describe(f"set {found.number}")
        return TextureJob(
            path.name, lambda _: texels.points_by_set(number, rows), *_look_at(found.points, traced), number, label, []
        )
    if output != ".npz":
        raise ValueError(
            f"--output: got a {output} for {path.name!r} {found.describe('without texture coordinates that can be used')}, "
            "want .npz, which holds new ones, or .glb for a glTF file"
        )
    uv = unwrap(mesh, square_side(how.size, found.passed), padding=PADDING)[1]
    points, label = texels.points([(rows[0], uv)]), found.describe("new coordinates")
    return TextureJob(path.name, lambda _: texels.points([(rows[0], uv)]), *_look_at(points, traced), 0, label, [])


def _read_corner_normals(path: Path, mesh: Mesh, how: TextureOptions) -> np.ndarray | None:
    """Return the normals at face corners, (F, 3, 3), to interpolate at texels; None for normals of faces or vertices."""
    if how.high is not None:
        return average_normals(mesh, how.cage)
    if how.normals == "face":
        return None
    return read_normals(path) if how.normals == "file" else read_smooth_normals(path, mesh)


def _find_set(materials: list[Part], group: list[Primitive], slot: Slot) -> int | None:
    """Return the number of the texture-coordinate set that a group's materials use already, or None."""
    numbers = [number for one in group for number in one.materials]
    known = [kind.find_info(materials[number]) for kind in (slot, OCCLUSION) for number in numbers]
    sets = [_read_set_number(info) for info in known if info is not None]
    return sets[0] if sets else None


def _read_set_number(info: Part) -> int:
    """Return the number of the texture-coordinate set used by a glTF texture info; a KHR_texture_transform overrides it."""
    number = info.whole("texCoord", 0, LAST_SET)
    if "extensions" in info and "KHR_texture_transform" in info.part("extensions"):
        number = info.part("extensions").part("KHR_texture_transform").whole("texCoord", number, LAST_SET)
    return number


def square_side(size: tuple[int, int], passed: Sequence[str]) -> int:
    """Return the side of a square image, in texels; new texture coordinates need a square.

    Args:
        size: width and height.
        passed: reasons why sets of the file are not used.

    Raises:
        ValueError: width and height differ.
    """
    if size[0] != size[1]:
        why = f" ({'; '.join(passed)})" if passed else ""
        raise ValueError(
            f"--texture: got {size[0]}x{size[1]} for new texture coordinates{why}, want a square, such as {max(size)}"
        )
    return size[0]
