"""Choice among the sets of texture coordinates in a mesh file, and points for the texels."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from warpsample.host.options import CallOptions
from warpsample.mesh.files import gltf, usd
from warpsample.mesh.files.text import has_obj_lines
from warpsample.mesh.files.uv import LAST_SET, SUFFIXES, MissingSetError, find_ply_names, load_uv
from warpsample.mesh.mesh import Mesh
from warpsample.texture.report import find_face_flaws, find_outside_faces, find_slivers, find_squeezed_faces
from warpsample.texture.shading import compute_corner_normals
from warpsample.texture.texture_points import TexturePoints, place_texels
from warpsample.texture.uv.charts import find_flat_areas

UV_CHOICES = ("auto", "0", "1", "new")
_CROWDED = 10.0  # times the area of the image: texels would take long, and tell only how many overlap


@dataclass(frozen=True)
class TextureOptions:
    """Options of a `warpsample bake --texture` command, such as size, samples, normals and gutter.

    Attributes:
        size: width and height in texels.
        uv: texture coordinates to use, one of UV_CHOICES.
        samples: points per texel.
        normals: normals of the points: "face", "smooth", "lifted", or "file" for those of a glTF file, where primitives
            without normals are flat.
        gutter: fill distance in texels, or "all".
        strength: strength of the occlusion in the material, from 0 to 1.
        depth: bits per channel of a .png.
        strict: whether flawed coordinates are an error.
        high: path of a finer mesh on which values are computed, or None.
        cage: distance around the coarse mesh within which the finer mesh is searched, in units of the mesh.
        inside: "fill" or "keep" for texels inside closed bodies.
        instances: "split" or "mean" for meshes in several places.
    """

    size: tuple[int, int]
    uv: str = "auto"
    samples: int = 1
    normals: str = "face"
    gutter: str | int = "all"
    strength: float = 1.0
    depth: int = 8
    strict: bool = False
    high: Path | None = None
    cage: float = 0.0
    inside: str = "fill"
    instances: str = "split"


@dataclass(frozen=True)
class ChosenSet:
    """Chosen set of texture coordinates for some faces; without points if new coordinates are needed.

    Attributes:
        number: number of the set.
        points: texels as points; None if the faces get new coordinates.
        passed: phrases on the sets that were not used, with the reasons.
    """

    number: int = 0
    points: TexturePoints | None = None
    passed: tuple[str, ...] = ()

    def describe(self, which: str) -> str:
        """Return a phrase for the user: the chosen coordinates, and why sets with lower numbers were passed over."""
        return which + (f" ({'; '.join(self.passed)})" if self.passed else "")


class Texels:
    """Source of texel points for the faces of a mesh file, by any of the file's sets of texture coordinates.

    Attributes:
        path: path of the mesh file.
        mesh: mesh as `load_mesh` reads it.
        how: options of the texture.
        normals: (F, 3, 3) corner normals of the points, or None for those of faces or vertices.
    """

    path: Path
    mesh: Mesh
    how: TextureOptions
    normals: np.ndarray | None

    def __init__(self, path: Path, mesh: Mesh, how: TextureOptions, normals: np.ndarray | None) -> None:
        """Store the arguments; sets are read at first use."""
        self.path, self.mesh, self.how, self.normals = path, mesh, how, normals
        self._sets: list[np.ndarray | None] = []
        self._named: dict[int, np.ndarray] = {}
        self._unreadable: dict[int, str] = {}  # sets of the file that cannot be read, with the reasons

    def points(self, parts: list[tuple[slice, np.ndarray]]) -> TexturePoints:
        """Return the texels of some faces as points, for ranges of faces and the texture coordinates of each, (n, 3, 2)."""
        parts = sorted(parts, key=lambda part: part[0].start)
        faces = np.concatenate([np.zeros(0, np.int64), *(np.arange(some.start, some.stop) for some, _ in parts)])
        is_whole, how = len(faces) == len(self.mesh.faces), self.how
        is_interpolated = how.high is not None or how.normals == "file"  # with a finer mesh, normals of the rays to it
        normals = "smooth" if is_interpolated else how.normals
        own, given = (None, self.normals) if is_whole else (faces, None if self.normals is None else self.normals[faces])
        turned = None if normals == "face" else compute_corner_normals(self.mesh, given, own)
        uv, options = np.concatenate([np.zeros((0, 3, 2)), *(uv for _, uv in parts)]), CallOptions.of(1)
        return place_texels(self.mesh, own, uv, turned, how.size, samples=how.samples, normals=normals, options=options)

    def choose_set(
        self,
        rows: list[slice],
        name: str,
        *,
        first: int | None = None,
        lenient: bool = False,
        others: Sequence[slice] = (),
    ) -> "ChosenSet":
        """Choose the set of texture coordinates for some faces, as the option `--uv` asks.

        A number takes the set of that number. "new" returns a ChosenSet without points. "auto" takes the first of these:

        1. the set `first`, which the faces already use for such a picture, if no face is outside the image and
           no face with an area in space is flat or squeezed in the image;
        2. the lowest set for which the same is true and no faces overlap;
        3. with `lenient`, the lowest set with texels and with no face outside the image;
        4. a ChosenSet without points, for new coordinates.

        Args:
            rows: faces.
            name: name of the faces in error messages.
            first: number of a set that "auto" prefers, or None.
            lenient: whether "auto" may take a set with overlaps.
            others: the same faces at other places, where other faces may be flat or squeezed.

        Raises:
            ValueError: not all faces have the requested set, or the set has no texels.
        """
        if self.how.uv == "new":
            return ChosenSet()
        faces = sum(len(self.mesh.faces[some]) for some in rows)
        if self.how.uv != "auto":
            number = int(self.how.uv)
            lacking = self._count_lacking(number, rows)
            if number in self._unreadable:
                raise ValueError(f"--uv: got {number}, a set that cannot be read: {self._unreadable[number]}")
            if lacking:
                raise ValueError(
                    f"--uv: got {number}, want a set of texture coordinates for all faces of {name!r}, but {lacking:,} of "
                    f"{faces:,} lack it or have no finite numbers in it; --uv new makes a set"
                )
            found = self.points_by_set(number, rows)
            if not len(found):
                raise ValueError(
                    f"--uv: got {number}, in which all faces of {name!r} are flat or outside the image, want another set"
                )
            return ChosenSet(number, found)
        return self._choose_best(rows, first, others, lenient=lenient)

    def _choose_best(self, rows: list[slice], first: int | None, others: Sequence[slice], *, lenient: bool) -> "ChosenSet":
        """Choose the set of texture coordinates for some faces as `--uv auto` does; arguments are those of `choose_set`."""
        within, faces = None, sum(len(self.mesh.faces[some]) for some in rows)
        passed: list[str] = []
        for number in dict.fromkeys([*([] if first is None else [first]), *range(LAST_SET + 1)]):
            lacking = self._count_lacking(number, rows)
            if 0 < lacking < faces or (lacking and self._is_named(number, rows)):
                why = f"{lacking:,} of {faces:,} faces lack it or have no finite numbers in it"
                passed.append(f"set {number} is passed over: {self._unreadable.get(number, why)}")
            if not lacking:
                found, (outside, times) = None, self._measure_layout(number, rows)
                if outside:
                    why = f"{outside:,} faces reach beyond the image"
                elif times > _CROWDED and number != first and not lenient:
                    why = f"faces overlap, with {times:.0f} times the area of the image, and auto accepts no overlap"
                    why += _advise(number)
                else:
                    found = self.points_by_set(number, rows)
                    why = self._describe_flaw(number, found, others, may_overlap=number == first)
                    if why is None:
                        return ChosenSet(number, found, tuple(passed))
                passed.append(f"set {number} is passed over: {why}")
                if found is not None and len(found):
                    within = within or ChosenSet(number, found, tuple(passed[:-1]))  # without its own flaw
        return within if lenient and within else ChosenSet(passed=tuple(passed))

    def _describe_flaw(self, number: int, found: TexturePoints, others: Iterable[slice], *, may_overlap: bool) -> str | None:
        """Return why `--uv auto` does not choose a set of texture coordinates, or None if the set can be chosen."""
        report = found.report
        if not len(found):
            return "no face has a texel"
        if report.overlapped and not may_overlap:
            counts = f"{report.overlapped:,} of {report.covered:,} texels ({report.overlapped / report.covered:.2%})"
            return f"faces overlap in {counts}, and auto accepts none{_advise(number)}"
        flat, squeezed = self._count_lost(number, others)
        if report.zero_area or flat:
            return "faces have no area in it"
        if report.squeezed or squeezed:
            return (
                f"{report.squeezed or squeezed:,} faces more than eight texels wide on the mesh are less than one wide in it"
            )
        return None

    def _measure_layout(self, number: int, rows: Iterable[slice]) -> tuple[int, float]:
        """Return the number of faces that reach beyond the image, and the sum of all areas, 1 for that of the image."""
        uv = self._read_set(number)
        assert uv is not None
        measured = [(np.count_nonzero(find_outside_faces(uv[some])), find_flat_areas(uv[some]).sum()) for some in rows]
        outside, areas = zip(*measured, strict=True)
        return int(sum(outside)), float(sum(areas))

    def _count_lost(self, number: int, rows: Iterable[slice]) -> tuple[int, int]:
        """Count the given faces that have no area in a set of texture coordinates, without slivers, and those squeezed."""
        uv, flat, squeezed = self._read_set(number), 0, 0
        assert uv is not None
        for some in rows:
            face, lost = np.arange(some.start, some.stop), find_face_flaws(uv[some])["zero_area"]
            flat += int(np.count_nonzero(lost & ~find_slivers(self.mesh, face, lost)))
            narrow = find_squeezed_faces(self.mesh, face, uv[some] * np.array(self.how.size), lost)
            squeezed += int(np.count_nonzero(narrow))
        return flat, squeezed

    def _is_named(self, number: int, rows: Iterable[slice]) -> bool:
        """Return whether the file has a set of texture coordinates, perhaps with NaN, for some of the given faces."""
        return self._read_set(number) is not None and any(self._find_named(number)[some].any() for some in rows)

    def _count_lacking(self, number: int, rows: Iterable[slice]) -> int:
        """Count the given faces for which a set of texture coordinates is missing, NaN or infinite."""
        uv = self._read_set(number)
        if uv is None:
            return sum(len(self.mesh.faces[some]) for some in rows)
        return sum(int(np.count_nonzero(~np.isfinite(uv[some]).all(axis=(1, 2)))) for some in rows)

    def points_by_set(self, number: int, rows: list[slice]) -> TexturePoints:
        """Return the texels of some faces as points, by the file's set of texture coordinates `number`."""
        uv = self._read_set(number)
        assert uv is not None
        return self.points([(some, uv[some]) for some in rows])

    def _read_set(self, number: int) -> np.ndarray | None:
        """Return the texture coordinates of set `number`, (F, 3, 2), or None if the file lacks the set."""
        while len(self._sets) <= number and (not self._sets or self._sets[-1] is not None):
            self._sets.append(self._load_set(len(self._sets)))
        return self._sets[number] if number < len(self._sets) else None

    def _load_set(self, number: int) -> np.ndarray | None:
        if self.path.suffix.lower() not in SUFFIXES:
            return None
        try:
            return load_uv(self.path, set=number)
        except ValueError as error:  # the mesh itself was read without error
            if not isinstance(error.__cause__, MissingSetError):
                self._unreadable[number] = str(error.__cause__)
            elif not self._find_named(number).any():
                return None
            return np.full((len(self.mesh.faces), 3, 2), np.nan)

    def _find_named(self, number: int) -> np.ndarray:
        """Return the (F,) bool mask of the faces for which the file has the set `number`, perhaps with NaN.

        These are all faces for an .obj or .ply with texture coordinates, and for a set of a USD file that cannot be read.
        """
        if number not in self._named:
            self._named[number] = self._read_named(number)
        return self._named[number]

    def _read_named(self, number: int) -> np.ndarray:
        suffix = self.path.suffix.lower()
        if suffix in (".glb", ".gltf"):
            return gltf.find_faces_with(self.path, f"TEXCOORD_{number}")
        if suffix == ".obj":
            is_named = number == 0 and has_obj_lines(self.path, "vt")
            return np.full(len(self.mesh.faces), is_named)
        if suffix == ".ply":
            return np.full(len(self.mesh.faces), find_ply_names(self.path, number) is not None)
        if number in self._unreadable:
            return np.ones(len(self.mesh.faces), np.bool_)
        return usd.find_faces_with(self.path, number)


def _advise(number: int) -> str:
    """Return advice on how to take a set of texture coordinates with overlaps; "" where there is none."""
    return f"; --uv {number} takes it" if str(number) in UV_CHOICES else ""
