"""`warpsample export`: write the results in a finished store to a mesh file."""

from pathlib import Path
from typing import Any

import numpy as np

from warpsample.cluster.arrays import POINT_ARRAYS
from warpsample.cluster.chunks import CALLS
from warpsample.cluster.holdings import about_of, arrays_of, whole_chunks
from warpsample.cluster.job import SHAPE
from warpsample.cluster.store import check_store
from warpsample.estimate.quantities.record import OPTIONS, Quantity
from warpsample.host.engine import check_memory
from warpsample.host.files import check_output, complete_or_absent
from warpsample.host.shared_values import digest_of
from warpsample.mesh.files import load_mesh
from warpsample.mesh.files.linked_files import list_linked_files
from warpsample.mesh.surface import SurfacePoints
from warpsample.output.baked import WRITERS, Baked, BakeRun, check_glb


def export_store(store: Path, mesh: Path, output: Path) -> str:
    """Convert a finished Zarr store of results to another file, for example a .ply or .csv.

    Args:
        store: Path of the store.
        mesh: Path of the mesh file that the store was computed on.
        output: Path of the file to write; the suffix selects the format.

    Returns:
        a sentence that describes the file, for the terminal.

    Raises:
        ValueError, FileNotFoundError: if the store is missing, unfinished or of another mesh, or the format cannot hold
            its results.
        MemoryError: if the points do not fit into memory.
        WriteError: if the file cannot be written.
    """
    if output.suffix not in WRITERS:
        raise ValueError(f"--output: got {str(output)!r}, want a file that ends in one of {' '.join(WRITERS)}")
    about = _read_attributes(store)
    quantity = CALLS[about["call"]]
    run = _run(quantity, about, mesh, output)
    check_output(output, "--output", mesh, *list_linked_files(mesh))
    if run.at is None and output.suffix in (".ply", ".glb"):
        raise ValueError(f"--output: got {output.name!r} for points, want .vtp, .npz or .csv")
    shape = load_mesh(mesh)
    if digest_of(shape.vertices, shape.faces) != about.get(SHAPE, about["mesh"]):
        raise ValueError(
            f"mesh: got {str(mesh)!r}, which is not the mesh of {str(store)!r}; pass the mesh file from which the store "
            "was computed"
        )
    if output.suffix == ".glb":
        check_glb(run, shape)
    arrays = _read_arrays(store, _list_arrays(store, quantity))
    points = SurfacePoints(*map(arrays.pop, POINT_ARRAYS))
    found = quantity.result(**arrays, **dict.fromkeys(quantity.shared))
    with complete_or_absent(output) as file:
        WRITERS[output.suffix](file, Baked(run, shape, points, found))
    return f"{output}: {quantity.title} of {len(points):,} {run.at or 'points'}"


def _read_attributes(store: Path) -> dict[str, Any]:
    """Return the attributes of a store; raise an error unless the store holds all chunks of a quantity.

    Raises:
        ValueError, FileNotFoundError: if the store is missing, unfinished, damaged or of another call.
    """
    path = check_store(store, "store")
    if not path.exists():
        raise FileNotFoundError(f"store: got {str(store)!r}, which is missing, want a store that `warpsample bake` wrote")
    about = about_of(path, "store")
    if about.get("call") not in CALLS:
        raise ValueError(f"store: got {str(store)!r} of {about.get('call')}, want one of {', '.join(CALLS)}")
    whole = whole_chunks(path, _list_arrays(path, CALLS[about["call"]]), "store")
    if missing := np.count_nonzero(~whole):
        raise ValueError(
            f"store: got {str(store)!r}, which lacks {missing:,} of {len(whole):,} chunks, want a finished store: run "
            "`warpsample bake` again with --resume"
        )
    return about


def _run(quantity: Quantity, about: dict[str, Any], mesh: Path, output: Path) -> BakeRun:
    """Return the arguments of the `warpsample bake` command that wrote a store, from the store's attributes."""
    at = about["place"] if about["place"] in ("vertices", "faces") else None
    kept = {name: tuple(value) if isinstance(value, list) else value for name, value in about.items()}
    options = {OPTIONS.get(name, name): kept[name] for name in quantity.parameters if name in kept}
    return BakeRun(mesh, output, quantity.name, at, None if at else about["points"], options)


def _list_arrays(store: Path, quantity: Quantity) -> list[str]:
    """Return the names of the arrays to export: points, results of the quantity, and optional results in the store."""
    others = [name for name in quantity.sometimes if (store / name).is_dir()]
    return [*POINT_ARRAYS, *quantity.arrays, *others]


def _read_arrays(store: Path, names: list[str]) -> dict[str, np.ndarray]:
    """Read arrays of a store into memory.

    Raises:
        MemoryError: if the arrays do not fit into memory.
        ValueError: if an array is missing or cannot be read.
    """
    kept = arrays_of(store, names, "store")
    check_memory(sum(array.nbytes for array in kept.values()), f"the numbers of {store}", "read it in parts, with xarray")
    return {name: array[:] for name, array in kept.items()}
