"""A Zarr store read back by xarray: the sky view of a mesh's vertices, its standard error, and the chunk of each vertex."""

import tempfile
from pathlib import Path
from typing import Annotated, Literal

import numpy as np
import typer

import warpsample as ws
from warpsample.cli.terminal import Size, fail_plainly, show_or_save
from warpsample.plotting import rendering
from warpsample.plotting.scenes import Panel, meshes_side_by_side


def baked(folder: str, mesh: ws.Mesh, samples: int, chunk: int, seed: int, up: str) -> dict[str, np.ndarray]:
    """The arrays of a store in a folder, which is made chunk by chunk and then opened as anybody would."""
    from warpsample import cluster  # noqa: PLC0415  (it says which extra is missing)

    store = Path(folder) / "sky.zarr"
    cluster.bake(store, "sky_view_factor", mesh, "vertices", samples, up=rendering.AXES[up], seed=seed, chunk=chunk)
    import xarray as xr  # noqa: PLC0415

    return {name: array.to_numpy() for name, array in xr.open_zarr(store).items()}


def panels_of(found: dict[str, np.ndarray], chunk: int) -> list[Panel]:
    """What is shown of the arrays; the colours of the errors end above those of 99 in 100 vertices."""
    number = np.arange(len(found["value"])) // chunk
    error = max(float(np.quantile(found["standard_error"], 0.99)), 1e-6)
    return [
        Panel(found["value"], "Sky view factor", "gray", 1.0),
        Panel(found["standard_error"], "Standard error", "viridis", rendering.round_ticks(error, 5)[-1]),
        Panel(number, "Chunk of the store", "turbo", float(max(1, number[-1]))),
    ]


@fail_plainly(count="--samples")
def main(
    mesh: Annotated[Path, typer.Argument(help="Mesh file; or courtyard, an example.")] = Path("courtyard"),
    samples: Annotated[int, typer.Option(help="Rays at each vertex.")] = 1024,
    chunk: Annotated[int, typer.Option(help="Vertices of a chunk.", min=1)] = 100,
    seed: Annotated[int, typer.Option(help="Seed of the rays.")] = 0,
    up: Annotated[Literal["x", "y", "z"], typer.Option(help="The mesh's axis that points up.")] = "z",
    screenshot: Annotated[
        Path | None, typer.Option(help="No window, but a file: .png, or .html to turn in a browser.", show_default=False)
    ] = None,
    size: Size = (1800, 680),
) -> None:
    """Bake the sky view of a mesh's vertices into a Zarr store by chunks, read it back, and show it."""
    rendering.check_output(screenshot, rendering.SCENE_SUFFIXES, mesh)
    rendering.check_size(size, (900, 340))
    rendering.check_rendering()
    of = ws.load_mesh(mesh)
    with tempfile.TemporaryDirectory() as folder:
        found = baked(folder, of, samples, chunk, seed, up)
    chunks = -(-len(found["value"]) // chunk)
    what = f"{len(found['value']):,} vertices in {chunks:,} chunks of a store; {samples:,} rays each; seed {seed}"
    plotter = meshes_side_by_side(
        of.vertices, of.faces, panels_of(found, chunk), caption=what, up=up, off_screen=screenshot is not None, size=size
    )
    show_or_save(plotter, screenshot, what)


if __name__ == "__main__":
    typer.run(main)
