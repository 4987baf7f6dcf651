"""The viewer, as `warpsample view`: clouds of directions about the normals of a mesh, compared with a density."""

import typer

from warpsample.cli.commands import view

if __name__ == "__main__":
    typer.run(view)
