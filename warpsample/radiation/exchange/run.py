"""The command `warpsample view-factors`: computes view factors of a mesh file and writes them to a file."""

from pathlib import Path
from typing import Any

import numpy as np

from warpsample.host.arguments import check_file, naming_file
from warpsample.host.files import read_array
from warpsample.mesh.files import load_mesh
from warpsample.mesh.files.gltf import describe_invisible
from warpsample.radiation.exchange.files import check_factors_file
from warpsample.radiation.exchange.result import ViewFactors
from warpsample.radiation.exchange.view_factors import view_factors


def run_view_factors(mesh: Path, output: Path, groups: Path | None, options: dict[str, Any]) -> str:
    """Compute view factors of a mesh file, write a file of factors, and return a sentence about the result.

    The file is complete or absent.

    Args:
        mesh: Path of the mesh file.
        output: Path of the result: a name in .npz or .vf, or one that begins with vfsparse.inp.
        groups: Path of a text or .npy file with one integer per face; "part" for the named parts; None for no groups.
        options: Further arguments of `view_factors`.

    Raises:
        TypeError, ValueError, OSError: an argument or a file cannot be used; nothing is written then.
    """
    check_factors_file(output, "--output", mesh, groups)
    found = view_factors(load_mesh(mesh), groups=_read_groups(groups), progress=True, **options)
    invisible = describe_invisible(mesh)
    found.save(output)
    return "\n  ".join([f"{output}: {summary(found)}", *invisible])


def _read_groups(path: Path | None) -> Any:
    """Read the group of each face from a file; return "part" for named parts, and None without groups."""
    if path is None or path == Path("part"):
        return path and path.name
    wants = "a text or .npy file with one whole number per face, or part"
    file = check_file(path, "--groups", wants)
    with naming_file("--groups", file, wants):
        if file.suffix == ".npy":
            return read_array(file)
        return np.loadtxt(file, dtype=np.int64, ndmin=1)


def summary(found: ViewFactors) -> str:
    """Return lines about view factors: numbers of factors and rays, errors of closure and reciprocity."""
    there = found.areas > 0.0
    closure = np.abs(found.row_sums() - 1.0)[there]
    exchange = found.matrix * found.areas[:, None]
    apart = np.abs(exchange - exchange.T).sum() / max(exchange.sum(), np.finfo(float).tiny)
    weight = found.areas / max(found.areas.sum(), np.finfo(float).tiny)
    skipped = found.skipped
    parts = [
        f"{found.matrix.nnz:,} view factors between {len(found.areas):,} surfaces by {found.rays.sum():,} rays",
        f"sums of rows differ from 1 by at most {closure.max(initial=0.0):.1g} (closure)",
        f"A_i F_ij and A_j F_ji differ by {apart:.2g} of their size (reciprocity)",
        f"{weight @ found.outside:.2g} of the radiation leaves to the outside",
        f"{weight @ found.behind:.2g} of the radiation hits backs of faces",
    ]
    if skipped.open_points:
        parts.append(f"{skipped.open_points:,} faces see only the outside and cast no rays")
    if skipped.points:
        parts.append(f"{skipped.points:,} faces without area")
    if not found.matrix.nnz:
        parts.append("no front faces another front; reverse the faces of a room, so that their normals point inward")
    return "\n  ".join(parts)
