"""What the command line says of Zarr stores: options of `bake`, and `export`."""

from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Any

import typer

from warpsample.cli.terminal import option, output_file, working
from warpsample.host.extras import missing
from warpsample.output.baked import BakeRun

SUFFIX = ".zarr"

OPTIONS: dict[str, Any] = {
    "chunk": Annotated[int | None, option("Points of a task and a file of the store; .zarr only.")],
    "cluster": Annotated[str | None, option("Address of a Dask scheduler, tcp://...; .zarr only.")],
    "processes": Annotated[int | None, option("So many processes of a thread each; .zarr, and rasters.")],
    "resume": Annotated[bool, typer.Option("--resume", help="Go on with what was begun; .zarr, and rasters.")],
}
"""The types of the options that apply to stores."""


def bake_into_store(
    run: BakeRun,
    chunk: int | None = None,
    cluster: str | None = None,
    *,
    processes: int | None = None,
    resume: bool = False,
) -> str:
    """Computes a run into a Zarr store by `cluster.runs.bake_run`; what is missing is a ModuleNotFoundError."""
    if run.report is not None:
        raise ValueError(f"--report: got {run.report.name!r} for {run.output.name!r}, want another file than a store")
    try:
        from warpsample.cluster.runs import bake_run
    except ModuleNotFoundError as error:
        raise _needed(error) from error
    return bake_run(run, chunk, cluster, processes, resume)


def refuse_for_files(output: Path, options: Mapping[str, Any]) -> None:
    """Refuses the options of stores that are given for other files; the ValueError names the first."""
    for name, value in options.items():
        raise ValueError(f"--{name}: got {value} for {output.name}; it applies only to {SUFFIX}")


def export_command(
    store: Annotated[Path, typer.Argument(help="What `warpsample bake -o out.zarr` wrote.", show_default=False)],
    mesh: Annotated[Path, typer.Argument(help="The mesh file that it was given.", show_default=False)],
    output: Annotated[Path, output_file(".ply .vtp .glb .npz .csv")],
) -> None:
    """Write the numbers of a finished Zarr store on their mesh, into a file as `bake` does."""
    try:
        from warpsample.cluster.exporting import export_store
    except ModuleNotFoundError as error:
        raise _needed(error) from error
    with working(f"reading {store} and {mesh}, writing {output}"):
        summary = export_store(store, mesh, output)
    print(summary)


def _needed(error: ModuleNotFoundError) -> ModuleNotFoundError:
    return missing(f"a {SUFFIX} needs {error.name}, on Python 3.11 or newer", error.name, "cluster")
