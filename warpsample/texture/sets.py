"""Which set of texture coordinates a run bakes to, and the points of its texels."""

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from warpsample.mesh.files.uv import LAST_SET, SUFFIXES, load_uv
from warpsample.mesh.mesh import Mesh
from warpsample.texture.report import find_face_flaws
from warpsample.texture.texture_points import TexturePoints, texture_points

UV_CHOICES = ("auto", "0", "1", "new")


@dataclass(frozen=True)
class TextureOptions:
    """What `warpsample bake --texture` is told besides what points are.

    `size` is width and height in texels; `uv` of UV_CHOICES; `samples` the points of each texel; `gutter` "all" or texels;
    `depth` the bits of a number in a .png; `strict` whether flaws of the coordinates are refused; `high` a finer mesh whose
    numbers are wanted, and `cage` how far around the coarse one it is looked for; `inside` is "fill" or "keep", for texels
    inside closed bodies; `instances` is "split" or "mean", for meshes in several places.
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
    """A set of coordinates for some faces.

    `points` are the texels by the set, None where the faces get new coordinates; `passed` are phrases on the sets that are
    not taken, and why.
    """

    number: int = 0
    points: TexturePoints | None = None
    passed: tuple[str, ...] = ()

    def describe(self, which: str) -> str:
        """The name of the coordinates, with the reasons for not taking the sets before them."""
        return which + (f" ({'; '.join(self.passed)})" if self.passed else "")


class Texels:
    """The texels of a mesh file by its own sets of coordinates, each of which is read once."""

    path: Path
    mesh: Mesh
    how: TextureOptions
    normals: np.ndarray | None

    def __init__(self, path: Path, mesh: Mesh, how: TextureOptions, normals: np.ndarray | None) -> None:
        """Reads nothing yet; `normals` are those of the corners that the file has, if it has any."""
        self.path, self.mesh, self.how, self.normals = path, mesh, how, normals
        self._sets: list[np.ndarray | None] = []

    def points(self, uv: np.ndarray, rows: list[slice]) -> TexturePoints:
        """The texels of some faces by the coordinates of all."""
        own = np.full(uv.shape, np.nan)
        for some in rows:
            own[some] = uv[some]
        how = self.how
        normals = how.normals if how.high is None else "smooth"  # of the rays to it
        return texture_points(self.mesh, own, how.size, samples=how.samples, normals=normals, corner_normals=self.normals)

    def choose_set(self, rows: list[slice], name: str, *, first: int | None = None, lenient: bool = False) -> "ChosenSet":
        """Choose the set for some faces, as the run asks for; one without points where they are to get new coordinates.

        Of "auto" it is `first`, the one that these faces have a picture of that kind by, if that lies within the image and
        all faces have an area there that have one in space; else the lowest of these in which nothing overlaps; and if there
        is none and it may be `lenient`, the lowest within.

        Raises:
            ValueError: a set that is asked for and that some of the faces have not.
        """
        if self.how.uv == "new":
            return ChosenSet()
        if self.how.uv != "auto":
            number = int(self.how.uv)
            if not self._has(number, rows):
                raise ValueError(f"--uv: got {number}, and not all faces of {name!r} have the set {number} of coordinates")
            found = self.points_by_set(number, rows)
            if not len(found):
                raise ValueError(
                    f"--uv: got {number}, by which {name!r} has no texels: its faces are flat or beyond the image"
                )
            return ChosenSet(number, found)
        within = None
        passed: list[str] = []
        for number in dict.fromkeys([*([] if first is None else [first]), *range(LAST_SET + 1)]):
            if self._has(number, rows):
                found = self.points_by_set(number, rows)
                why = self._describe_flaw(number, rows, found, may_overlap=number == first)
                if why is None:
                    return ChosenSet(number, found, tuple(passed))
                passed.append(f"set {number} is passed over: {why}")
                if len(found) and not found.report.outside:
                    within = within or ChosenSet(number, found)
        return within if lenient and within else ChosenSet(passed=tuple(passed))

    def _describe_flaw(self, number: int, rows: list[slice], found: TexturePoints, *, may_overlap: bool) -> str | None:
        """Describe why "auto" does not take a set; None if it does."""
        report = found.report
        if report.outside:
            return f"{report.outside:,} faces reach beyond the image"
        if not len(found):
            return "no face has a texel"
        if report.overlapped and not may_overlap:
            counts = f"{report.overlapped:,} of {report.covered:,} texels ({report.overlapped / report.covered:.2%})"
            return f"faces overlap in {counts}, and auto accepts none; --uv {number} takes it"
        return "faces have no area in it" if self._is_flat(number, rows) else None

    def _has(self, number: int, rows: Iterable[slice]) -> bool:
        uv = self._read_set(number)
        return uv is not None and all(np.isfinite(uv[some]).all() for some in rows)

    def _is_flat(self, number: int, rows: Iterable[slice]) -> bool:
        """Whether faces that have an area in space have none in the image."""
        uv, areas = self._read_set(number), self.mesh.face_areas
        assert uv is not None
        return any((find_face_flaws(uv[some])["zero_area"] & (areas[some] > 0.0)).any() for some in rows)

    def points_by_set(self, number: int, rows: list[slice]) -> TexturePoints:
        """The texels of some faces by a set that they have."""
        uv = self._read_set(number)
        assert uv is not None
        return self.points(uv, rows)

    def _read_set(self, number: int) -> np.ndarray | None:
        """All coordinates of a set; None from the first on that no face has."""
        while len(self._sets) <= number and (not self._sets or self._sets[-1] is not None):
            self._sets.append(self._load_set(len(self._sets)))
        return self._sets[number] if number < len(self._sets) else None

    def _load_set(self, number: int) -> np.ndarray | None:
        if self.path.suffix.lower() not in SUFFIXES:
            return None
        try:
            return load_uv(self.path, set=number)
        except ValueError:  # the mesh itself has been read: there is no such set
            return None
