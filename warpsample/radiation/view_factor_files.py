"""View factors in files: our own .npz, which scipy.sparse.load_npz reads too, and the texts of uDALES and View3D."""

import zipfile
from collections.abc import Callable, Iterator
from dataclasses import fields
from pathlib import Path
from typing import TYPE_CHECKING, Any, BinaryIO

import numpy as np

from warpsample.estimate.result import Skipped
from warpsample.host.arguments import check_file, naming_file, told
from warpsample.host.files import check_output, complete_or_absent, write_array

if TYPE_CHECKING:
    from warpsample.radiation.view_factors import ViewFactors

WANTS = "a name that ends in .npz or .vf, or begins with vfsparse.inp"
_SPARSE, _SKY = "vfsparse.inp", "svf.inp"
_LEAST = 5e-7
_LINES = 1 << 16  # of a text at a time
_VECTORS = ("outside", "outside_error", "behind", "behind_error", "areas", "rays", "status")
_OPTIONAL = ("sky", "sky_error", "ground", "ground_error")


def check_factors_file(path: Any, argument: str, *inputs: Path | None) -> Path:
    """`path`, if view factors can be written there: before anything is computed.

    Raises:
        TypeError, ValueError: no path, a name that tells no format, or a file that cannot be written.
    """
    if not isinstance(path, str | Path):
        raise TypeError(f"{argument}: got {told(path)}, want {WANTS}")
    path = Path(path)
    if path.suffix not in (".npz", ".vf") and not path.name.startswith(_SPARSE):
        raise ValueError(f"{argument}: got {str(path)!r}, want {WANTS}")
    for file in _files(path):
        check_output(file, argument, *inputs)
    return path


def save(factors: "ViewFactors", path: Path) -> None:
    """Writes a checked path; each file is complete or absent."""
    writers: tuple[Callable[[ViewFactors, BinaryIO], None], ...] = (_write_npz,)
    if path.suffix == ".vf":
        writers = (_write_view3d,)
    elif path.suffix != ".npz":
        writers = (_write_sparse, _write_sky)
    for file, write in zip(_files(path), writers, strict=True):
        with complete_or_absent(file) as stream:
            write(factors, stream)


def load(path: Any, argument: str) -> dict[str, Any]:
    """What an .npz of `save` holds, by the names of the fields.

    Raises:
        TypeError, OSError, ValueError: no such file.
    """
    from scipy.sparse import csr_array  # noqa: PLC0415

    file = check_file(path, argument, "an .npz file of view factors")
    with naming_file(argument, file, "view factors"), np.load(file, allow_pickle=False) as archive:
        held = {name: archive[name] for name in archive.files}
        lacking = {"data", "indices", "indptr", "shape", "standard_error", "skipped", *_VECTORS} - set(held)
        if lacking:
            raise ValueError(f"it has no {', '.join(sorted(lacking))}")
        shape, pattern = tuple(held["shape"].tolist()), (held["indices"], held["indptr"])
        matrices = {
            name: csr_array((held[key], *pattern), shape=shape)
            for name, key in (("matrix", "data"), ("standard_error", "standard_error"))
        }
        for matrix in matrices.values():
            matrix.check_format()
        skipped = Skipped(*(int(number) for number in held["skipped"]))
        return {
            **matrices,
            **{name: held[name] for name in _VECTORS},
            **{name: held[name] for name in _OPTIONAL if name in held},
            "skipped": skipped,
        }


def _files(path: Path) -> tuple[Path, ...]:
    """The files that are written for a path: uDALES has one for the sky beside that of the factors."""
    if path.suffix in (".npz", ".vf"):
        return (path,)
    return path, path.with_name(_SKY + path.name.removeprefix(_SPARSE))


def _write_npz(factors: "ViewFactors", stream: BinaryIO) -> None:
    matrix = factors.matrix
    arrays = {
        "format": np.array(b"csr"),
        "_is_array": np.array(True),
        "shape": np.array(matrix.shape),
        "data": matrix.data,
        "indices": matrix.indices,
        "indptr": matrix.indptr,
        "standard_error": factors.standard_error.data,
        "skipped": np.array([getattr(factors.skipped, item.name) for item in fields(Skipped)]),
        **{name: getattr(factors, name) for name in (*_VECTORS, *_OPTIONAL) if getattr(factors, name) is not None},
    }
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED, allowZip64=True) as archive:
        for name, array in arrays.items():
            write_array(archive, name, array)


def _write_sparse(factors: "ViewFactors", stream: BinaryIO) -> None:
    """Lines "i j F" from 1 on, sorted; what would print as 0 in uDALES' own six decimals is left out, as it does."""
    matrix = factors.matrix
    row = np.repeat(np.arange(matrix.shape[0]), np.diff(matrix.indptr))
    for first in range(0, matrix.nnz, _LINES):
        part = slice(first, first + _LINES)
        large = matrix.data[part] >= _LEAST
        columns = (values[part][large].tolist() for values in (row + 1, matrix.indices + 1, matrix.data))
        stream.write("".join(f"{i} {j} {f:.8f}\n" for i, j, f in zip(*columns, strict=True)).encode())


def _write_sky(factors: "ViewFactors", stream: BinaryIO) -> None:
    """All that does not come from a face comes from the sky, to uDALES."""
    rest = np.maximum(1.0 - factors.matrix.sum(axis=1), 0.0)
    stream.write(b"# sky view factors\n")
    stream.write("".join(f"{share:.8f}\n" for share in rest.tolist()).encode())


def _write_view3d(factors: "ViewFactors", stream: BinaryIO) -> None:
    """Its header of 30 characters, the areas, a dense row a line, and emittances, which are 1."""
    size = factors.matrix.shape[0]
    stream.write(f"{f'View3D 3.5 0 0 0 {size}':<30}\n".encode())
    stream.write(_line(f"{area:.9g}" for area in factors.areas.tolist()))
    for i in range(size):
        row = factors.matrix[[i]].toarray()[0]
        stream.write(_line(f"{share:.8f}" if share else "0" for share in row.tolist()))
    stream.write(_line("1.000" for _ in range(size)))


def _line(words: Iterator[str]) -> bytes:
    return (" ".join(words) + "\n").encode()
