"""A finished store as a mesh file: `warpsample export`."""

from dataclasses import fields
from pathlib import Path
from typing import Any

import numpy as np

from warpsample.cluster.arrays import PLACES
from warpsample.cluster.runs import CALLS
from warpsample.cluster.store import about_of, arrays_of, check_store, whole_chunks
from warpsample.estimate.result import Estimate, Skipped
from warpsample.estimate.visibility import SkyView
from warpsample.host.engine import check_memory
from warpsample.host.files import check_output, complete_or_absent
from warpsample.mesh.files import load_mesh
from warpsample.mesh.surface import SurfacePoints
from warpsample.output.baked import WRITERS, Baked, Run, check_glb

_RUN = ("call", "mesh", "place", "points", "chunk", "count", "up", "radiance", "workers", "first_point")


def export_store(store: Path, mesh: Path, output: Path) -> str:
    """Writes the numbers of a store on its mesh, as `warpsample bake` would have.

    Returns:
        a sentence about what was written.

    Raises:
        ValueError, FileNotFoundError: no finished store of numbers, of another mesh, or a file that cannot hold them.
        MemoryError: more points than there is memory for.
        WriteError: the file cannot be written.
    """
    if output.suffix not in WRITERS:
        raise ValueError(f"--output: got {str(output)!r}, want a file that ends in one of {' '.join(WRITERS)}")
    about = _about(store)
    run = _run(about, mesh, output)
    check_output(output, "--output", mesh)
    if run.at is None and output.suffix in (".ply", ".glb"):
        raise ValueError(f"--output: got {output.name!r} for points, want .vtp, .npz or .csv")
    shape = load_mesh(mesh)
    if shape.digest != about["mesh"]:
        raise ValueError(f"mesh: got {str(mesh)!r}, which is not the mesh of {str(store)!r}")
    if output.suffix == ".glb":
        check_glb(run, shape)
    arrays = _arrays(store, _names(about))
    points = SurfacePoints(*map(arrays.pop, PLACES))
    found = _result(about)(**arrays, skipped=Skipped())
    with complete_or_absent(output) as file:
        WRITERS[output.suffix](file, Baked(run, shape, points, found))
    return f"{output}: {run.quantity} of {len(points):,} {run.at or 'points'}"


def _about(store: Path) -> dict[str, Any]:
    path = check_store(store, "store")
    if not path.exists():
        raise FileNotFoundError(f"store: got {str(store)!r}, which is missing, want what `warpsample bake` wrote")
    about = about_of(path, "store")
    if about.get("call") not in CALLS.values():
        raise ValueError(f"store: got {str(store)!r} of {about.get('call')}, want one of {', '.join(CALLS.values())}")
    whole = whole_chunks(path, _names(about), "store")
    if missing := np.count_nonzero(~whole):
        raise ValueError(
            f"store: got {str(store)!r}, {missing:,} of whose {len(whole):,} chunks are missing, want a finished one: bake "
            "it again, with --resume"
        )
    return about


def _run(about: dict[str, Any], mesh: Path, output: Path) -> Run:
    """The arguments of `warpsample bake` that the store is of."""
    at = about["place"] if about["place"] in ("vertices", "faces") else None
    options = {name: value for name, value in about.items() if name not in _RUN}
    quantity = next(name for name, call in CALLS.items() if call == about["call"])
    up = tuple(about.get("up", (0.0, 0.0, 1.0)))
    return Run(mesh, output, quantity, at, None if at else about["points"], about["count"], None, up, options)


def _result(about: dict[str, Any]) -> type:
    return SkyView if about["call"] == CALLS["sky"] else Estimate


def _names(about: dict[str, Any]) -> list[str]:
    """The arrays of a store."""
    return [*PLACES, *(item.name for item in fields(_result(about)) if item.name != "skipped")]


def _arrays(store: Path, names: list[str]) -> dict[str, np.ndarray]:
    kept = arrays_of(store, names, "store")
    check_memory(sum(array.nbytes for array in kept.values()), f"the numbers of {store}", "read it in parts, with xarray")
    return {name: array[:] for name, array in kept.items()}
