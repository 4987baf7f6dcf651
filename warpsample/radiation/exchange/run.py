"""View factors from a mesh file into a file, for the command line."""

from pathlib import Path
from typing import Any

import numpy as np

from warpsample.host.arguments import check_file, naming_file
from warpsample.host.files import read_array
from warpsample.mesh.files import load_mesh
from warpsample.radiation.exchange.files import check_factors_file, save
from warpsample.radiation.exchange.result import ViewFactors
from warpsample.radiation.exchange.view_factors import view_factors


def run_view_factors(mesh: Path, output: Path, groups: Path | None, options: dict[str, Any]) -> str:
    """Computes and writes, complete or not at all; returns a sentence about what was written.

    Args:
        mesh: the mesh file.
        output: .npz, .vf, or vfsparse.inp and what follows.
        groups: a text or an .npy of one whole number for each face; "part" for the named parts; None for no groups.
        options: others of `view_factors`.

    Raises:
        TypeError, ValueError, OSError: an argument or a file that cannot be used; before anything is written.
    """
    check_factors_file(output, "--output", mesh, groups)
    found = view_factors(load_mesh(mesh), groups=_groups(groups), progress=True, **options)
    save(found, output)
    return f"{output}: {summary(found)}"


def _groups(path: Path | None) -> Any:
    if path is None or path == Path("part"):
        return path and path.name
    wants = "a text or an .npy of one whole number for each face, or part"
    file = check_file(path, "--groups", wants)
    with naming_file("--groups", file, wants):
        if file.suffix == ".npy":
            return read_array(file)
        return np.loadtxt(file, dtype=np.int64, ndmin=1)


def summary(found: ViewFactors) -> str:
    """How many factors there are, by how many rays, and how well rows close and pairs agree."""
    there = found.areas > 0.0
    absorbed = 0.0 if found.absorbed is None else found.absorbed
    closure = np.abs(found.matrix.sum(axis=1) + found.outside + found.behind + absorbed - 1.0)[there]
    exchange = found.matrix * found.areas[:, None]
    apart = np.abs(exchange - exchange.T).sum() / max(exchange.sum(), np.finfo(float).tiny)
    skipped = found.skipped
    parts = [
        f"{found.matrix.nnz:,} view factors between {len(found.areas):,} surfaces by {found.rays.sum():,} rays",
        f"closure to {closure.max(initial=0.0):.1g}",
        f"reciprocity to {apart:.2g}",
        f"outside {found.areas @ found.outside / max(found.areas.sum(), np.finfo(float).tiny):.2g}",
        f"behind {found.areas @ found.behind / max(found.areas.sum(), np.finfo(float).tiny):.2g}",
    ]
    if skipped.open_points:
        parts.append(f"{skipped.open_points:,} open faces cast none")
    if skipped.points:
        parts.append(f"{skipped.points:,} faces without area")
    if not found.matrix.nnz:
        parts.append("no front faces another: those of a room must look inwards")
    return ", ".join(parts)
