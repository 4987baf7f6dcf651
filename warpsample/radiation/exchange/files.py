"""Files of view factors: .npz, which scipy.sparse.load_npz reads too, and the text formats of uDALES and View3D."""

import zipfile
from collections.abc import Callable, Iterator, Mapping
from contextlib import ExitStack
from dataclasses import fields
from itertools import chain
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np

from warpsample.estimate.result import Skipped
from warpsample.host.arguments import check_file, naming_file, quote
from warpsample.host.files import check_output, complete_or_absent, read_arrays, write_arrays
from warpsample.radiation.exchange.closure import rows_of
from warpsample.radiation.exchange.row_factors import matrices_of

Factors = Mapping[str, Any]
"""Fields of a `ViewFactors`, by name."""

WANTS = "a name that ends in .npz or .vf, or begins with vfsparse.inp"
_SPARSE, _SKY = "vfsparse.inp", "svf.inp"
_LEAST = 5e-7
_LINES = 1 << 16  # lines formatted at a time
_VECTORS = ("outside", "outside_error", "behind", "behind_error", "areas", "rays", "status")
_OPTIONAL = ("sky", "sky_error", "ground", "ground_error"), ("absorbed", "absorbed_error"), ("reflectance",)
"""Optional fields of a file; the fields of a group are all present or all absent."""


def check_factors_file(path: Any, argument: str, *inputs: Path | None) -> Path:
    """Check that a file of view factors can be written to `path`, and return the path; called before the computation.

    Raises:
        TypeError, ValueError: no path, a name of an unknown format, or a file that cannot be written.
    """
    if not isinstance(path, str | Path):
        raise TypeError(f"{argument}: got {quote(path)}, want {WANTS}")
    path = Path(path)
    if path.suffix not in (".npz", ".vf") and not path.name.startswith(_SPARSE):
        raise ValueError(f"{argument}: got {str(path)!r}, want {WANTS}")
    named, *unnamed = _list_files(path)
    for file in (named, *unnamed):
        check_output(file, argument, *inputs)
    for file in unnamed:
        if file.exists() and not named.exists():
            raise ValueError(
                f"{argument}: got {str(path)!r}, which would replace {file.name} in the same folder, want another name"
            )
    return path


def save(factors: Factors, path: Path) -> None:
    """Write view factors to a file, in the format of its suffix; the path has been checked.

    Raises:
        WriteError: a file cannot be written.
    """
    writers: tuple[Callable[[Factors, BinaryIO], None], ...] = (_write_npz,)
    if path.suffix == ".vf":
        writers = (_write_view3d,)
    elif path.suffix != ".npz":
        writers = (_write_sparse, _write_sky)
    with ExitStack() as files:
        streams = [files.enter_context(complete_or_absent(file)) for file in _list_files(path)]
        for stream, write in zip(streams, writers, strict=True):
            write(factors, stream)
            stream.flush()  # so that both files are on the disk before either replaces an old one


def load(path: Any, argument: str) -> dict[str, Any]:
    """Read view factors from an .npz file written by `save`; return the fields by name.

    Raises:
        TypeError, OSError, ValueError: no such file.
    """
    file = check_file(path, argument, "an .npz file of view factors")
    with naming_file(argument, file, "view factors"):
        held = read_arrays(file)
        _check_arrays(held)
        matrix, standard_error = matrices_of(held["data"], held["standard_error"], held["indices"], held["indptr"])
        matrix.check_format()
        if not matrix.has_canonical_format:
            raise ValueError("the column indices of the matrix do not ascend")
        return {
            "matrix": matrix,
            "standard_error": standard_error,
            "skipped": Skipped(*held["skipped"].tolist()),
            **{name: held[name] for name in (*_VECTORS, *chain(*_OPTIONAL)) if name in held},
            "names": tuple(held["names"].tolist()) if "names" in held else None,
        }


def _check_arrays(held: dict[str, np.ndarray]) -> None:
    """Check the arrays read from an .npz file of view factors; raise a ValueError for an inconsistent one.

    Raises:
        ValueError: an array is missing, or has another type, shape or range than `save` writes.
    """
    optional = [name for names in _OPTIONAL if any(name in held for name in names) for name in names]
    lacking = {"data", "standard_error", "indices", "indptr", "shape", "skipped", *_VECTORS, *optional} - set(held)
    if lacking:
        raise ValueError(f"the file lacks the arrays {', '.join(sorted(lacking))}")
    rows, entries = (held["indptr"].size - 1,), (held["indices"].size,)
    whole = "int32" if entries[0] < 2**31 else "int64"
    kinds = {
        **dict.fromkeys((*_VECTORS, *optional), ("float64", rows)),
        **dict.fromkeys(("data", "standard_error"), ("float64", entries)),
        "indices": (whole, entries),
        "indptr": (whole, (rows[0] + 1,)),
        "rays": ("int64", rows),
        "status": ("uint8", (held["status"].size,)),
        "skipped": ("int64", (len(fields(Skipped)),)),
    }
    for name, (kind, shape) in kinds.items():
        array = held[name]
        if array.dtype != kind or array.shape != shape:
            raise ValueError(f"the array {name} has dtype {array.dtype} and shape {array.shape}, want {kind} and {shape}")
        if kind == "float64" and not (np.isfinite(array).all() and array.min(initial=0.0) >= 0.0):
            raise ValueError(f"the array {name} has numbers that are negative or not finite")
    if "names" in held and (held["names"].dtype.kind != "U" or held["names"].shape != rows):
        raise ValueError(
            f"the array names has dtype {held['names'].dtype} and shape {held['names'].shape}, want texts and {rows}"
        )
    if held["shape"].tolist() != 2 * [*rows]:
        raise ValueError("the matrix of view factors is not square")


def _list_files(path: Path) -> tuple[Path, ...]:
    """Return the paths of all files to write for an output path: the uDALES format has a second file for the sky."""
    if path.suffix in (".npz", ".vf"):
        return (path,)
    return path, path.with_name(_SKY + path.name.removeprefix(_SPARSE))


def _write_npz(factors: Factors, stream: BinaryIO) -> None:
    """Write all fields of view factors to a stream in NumPy's .npz format."""
    matrix = factors["matrix"]
    arrays = {
        "format": np.array(b"csr"),
        "_is_array": np.array(True),
        "shape": np.array(matrix.shape),
        "data": matrix.data,
        "indices": matrix.indices,
        "indptr": matrix.indptr,
        "standard_error": factors["standard_error"].data,
        "skipped": np.array([getattr(factors["skipped"], item.name) for item in fields(Skipped)]),
        **{name: factors[name] for name in (*_VECTORS, *chain(*_OPTIONAL)) if factors[name] is not None},
    }
    arrays |= {} if factors["names"] is None else {"names": np.array(factors["names"], str)}
    write_arrays(stream, arrays, zipfile.ZIP_DEFLATED)


def _write_sparse(factors: Factors, stream: BinaryIO) -> None:
    """Write view factors as lines "i j F", numbered from 1 and sorted.

    Like uDALES, omit values that six decimals would print as 0.
    """
    matrix = factors["matrix"]
    row = rows_of(matrix.indptr)
    for first in range(0, matrix.nnz, _LINES):
        part = slice(first, first + _LINES)
        large = matrix.data[part] >= _LEAST
        columns = (values[part][large].tolist() for values in (row + 1, matrix.indices + 1, matrix.data))
        stream.write("".join(f"{i} {j} {f:.8f}\n" for i, j, f in zip(*columns, strict=True)).encode())


def _write_sky(factors: Factors, stream: BinaryIO) -> None:
    """Write the sky view factor of each face to a stream, in the format of uDALES."""
    absorbed = 0.0 if factors["absorbed"] is None else factors["absorbed"]
    rest = np.maximum(1.0 - factors["matrix"].sum(axis=1) - absorbed, 0.0)
    stream.write(b"# sky view factors\n")
    stream.write("".join(f"{share:.8f}\n" for share in rest.tolist()).encode())


def _write_view3d(factors: Factors, stream: BinaryIO) -> None:
    """Write view factors in View3D's text format.

    It has a header of 30 characters, the areas, a dense row per line, and emittances of 1.
    """
    size = factors["matrix"].shape[0]
    stream.write(f"{f'View3D 3.5 0 0 0 {size}':<30}\n".encode())
    stream.write(_format_line(f"{area:.9g}" for area in factors["areas"].tolist()))
    for i in range(size):
        row = factors["matrix"][[i]].toarray()[0]
        stream.write(_format_line(f"{share:.8f}" if share else "0" for share in row.tolist()))
    stream.write(_format_line("1.000" for _ in range(size)))


def _format_line(words: Iterator[str]) -> bytes:
    """Return a line of text with the words separated by spaces, as bytes."""
    return (" ".join(words) + "\n").encode()
