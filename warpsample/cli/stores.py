"""Options of `warpsample bake` for Zarr stores, and the command `warpsample export`."""

from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Any

import typer

from warpsample.cli.terminal import option, output_file, working
from warpsample.host.extras import missing
from warpsample.output.baked import BakeRun

SUFFIX = ".zarr"

OPTIONS: dict[str, Any] = {
    "chunk": Annotated[int | None, option("Number of points per task and per chunk of the store. Only for .zarr.")],
    "cluster": Annotated[str | None, option("Address of a Dask scheduler, such as tcp://host:8786. Only for .zarr.")],
    "processes": Annotated[int | None, option("Number of processes, each with one thread. Only for .zarr and rasters.")],
    "resume": Annotated[bool, typer.Option("--resume", help="Continue an interrupted run. Only for .zarr and rasters.")],
}
"""Annotations of the options for stores, keyed by name."""


def bake_into_store(
    run: BakeRun,
    chunk: int | None = None,
    cluster: str | None = None,
    *,
    processes: int | None = None,
    resume: bool = False,
) -> str:
    """Compute a run chunk by chunk into a Zarr store, and return the report as text.

    Raises:
        ModuleNotFoundError: A package for stores is not installed.
        ValueError: An argument is invalid; raised before any work.
    """
    if run.report is not None:
        raise ValueError(f"--report: got {run.report.name!r} for {run.output.name!r}, want another file than a store")
    try:
        from warpsample.cluster.runs import bake_run
    except ModuleNotFoundError as error:
        raise _explain_missing(error) from error
    return bake_run(run, chunk, cluster, processes, resume)


def refuse_for_files(output: Path, options: Mapping[str, Any]) -> None:
    """Raise a ValueError if an option for stores is given with an output that is not a store."""
    for name, value in options.items():
        raise ValueError(f"--{name}: got {value} for {output.name}; it applies only to {SUFFIX}")


def export_command(
    store: Annotated[Path, typer.Argument(help="Store that `warpsample bake -o out.zarr` has written.", show_default=False)],
    mesh: Annotated[Path, typer.Argument(help="Mesh file from which the store was computed.", show_default=False)],
    output: Annotated[Path, output_file(".ply .vtp .glb .npz .csv")],
) -> None:
    """Convert a finished Zarr store and its mesh to a file of another format, as `bake` writes."""
    try:
        from warpsample.cluster.exporting import export_store
    except ModuleNotFoundError as error:
        raise _explain_missing(error) from error
    with working(f"reading {store} and {mesh}, writing {output}"):
        summary = export_store(store, mesh, output)
    print(summary)


def _explain_missing(error: ModuleNotFoundError) -> ModuleNotFoundError:
    """Return the error with the name of the package extra that is needed for stores."""
    return missing(f"a {SUFFIX} needs {error.name}, on Python 3.11 or newer", error.name, "cluster")
