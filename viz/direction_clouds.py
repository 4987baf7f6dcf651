"""The viewer: clouds of directions around the normals of a mesh, compared with their density; as `warpsample view`."""

import typer

from warpsample.cli.commands import view

if __name__ == "__main__":
    typer.run(view)
