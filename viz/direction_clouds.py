"""The viewer: clouds of directions around the normals of a mesh, against their density. As `warpsample view`."""

import typer
import warp as wp

from warpsample.cli.commands import view

if __name__ == "__main__":
    wp.config.log_level = wp.LOG_WARNING
    typer.run(view)
