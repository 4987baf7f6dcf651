"""The command `warpsample export`."""

from pathlib import Path
from typing import Annotated

import typer

from warpsample.cli.streams import print_report
from warpsample.cli.terminal import output_file, working
from warpsample.host.extras import missing
from warpsample.output.bake_table import STORE


def export_command(
    store: Annotated[Path, typer.Argument(help="Store that `warpsample bake -o out.zarr` has written.", show_default=False)],
    mesh: Annotated[Path, typer.Argument(help="Mesh file from which the store was computed.", show_default=False)],
    output: Annotated[Path, output_file(".ply .vtp .glb .npz .csv")],
) -> None:
    """Convert a Zarr store that `warpsample bake` has finished to another format, such as .ply or .csv."""
    try:
        from warpsample.cluster.exporting import export_store
    except ModuleNotFoundError as error:
        raise explain_missing(error) from error
    with working(f"reading {store} and {mesh}, writing {output}"):
        summary = export_store(store, mesh, output)
    print_report(summary)


def explain_missing(error: ModuleNotFoundError) -> ModuleNotFoundError:
    """Return an import error with the name of the package extra to install for Zarr stores."""
    return missing(f"a {STORE} needs {error.name}, on Python 3.11 or newer", error.name, "cluster")
