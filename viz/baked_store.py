"""Sky view factors that were baked into a Zarr store and read back by xarray, and the chunks of the store."""

import tempfile
from pathlib import Path
from typing import Annotated, Any, Literal

import matplotlib as mpl
import numpy as np
import typer

import warpsample as ws
from warpsample.cli.terminal import Size, fail_plainly, show_or_save
from warpsample.mesh.polydata import surface
from warpsample.plotting import rendering, style
from warpsample.plotting.panels import Panel, add_text, add_title, columns_over_caption, draw_edges, draw_panel, fit_view

ABOVE = 0.9  # height of the camera: the ground between the walls is seen
_MOST_LABELS = 25
_BAR = {"position_x": 0.1, "position_y": 0.075, "width": 0.8, "height": 0.06, "label_font_size": 18, "title_font_size": 1}


def bake(folder: str, mesh: ws.Mesh, samples: int, chunk: int, seed: int, up: str) -> dict[str, np.ndarray]:
    """Bake the sky view factors of a mesh's vertices into a store in `folder`, and return the arrays that xarray reads."""
    from warpsample import cluster  # noqa: PLC0415  (an import error names the extra)

    store = Path(folder) / "sky.zarr"
    cluster.bake(store, "sky_view_factor", mesh, "vertices", samples, up=rendering.AXES[up], seed=seed, chunk=chunk)
    import xarray as xr  # noqa: PLC0415

    return {name: array.to_numpy() for name, array in xr.open_zarr(store).items()}


def make_panels(arrays: dict[str, np.ndarray]) -> list[Panel]:
    """Return panels of the sky view factors and of the standard errors; the error's last colour is their 99th percentile."""
    error = max(float(np.quantile(arrays["standard_error"], 0.99)), 1e-6)
    last = rendering.round_ticks(error, 5)[-1]
    return [
        Panel(arrays["value"], "Sky view factor", style.OPENNESS, 1.0, "0: no sky, 1: the whole sky"),
        Panel(arrays["standard_error"], "Standard error", style.ERROR, last, "standard error of the sky view factor"),
    ]


def draw_chunks(plotter: Any, mesh: ws.Mesh, number: np.ndarray) -> None:
    """Draw the vertices of a mesh as dots with one colour for each chunk number, (V,), into the current renderer."""
    import pyvista as pv  # noqa: PLC0415

    chunks = int(number[-1]) + 1
    plotter.add_mesh(surface(mesh.vertices, mesh.faces), color="white", lighting=False)
    draw_edges(plotter, mesh.vertices, mesh.faces)
    colours = [mpl.colormaps["tab20"](i % 20) for i in range(chunks)]
    dots = pv.PolyData(mesh.vertices)
    dots["chunk"] = number.astype(float)
    look = {"cmap": mpl.colors.ListedColormap(colours), "clim": (-0.5, chunks - 0.5), "point_size": 16, "lighting": False}
    actor = plotter.add_mesh(dots, scalars="chunk", render_points_as_spheres=True, show_scalar_bar=False, **look)
    plotter.add_scalar_bar(title="chunk", mapper=actor.mapper, n_labels=0, color=style.INK, **_BAR)
    if chunks <= _MOST_LABELS:
        for i in range(chunks):
            add_text(plotter, str(i), (0.1 + 0.8 * (i + 0.5) / chunks, 0.118))
    add_text(plotter, "number of the chunk, a file of the store", (0.5, 0.04))
    add_title(plotter, f"Chunk of each vertex: {chunks} chunks")


@fail_plainly(count="--samples")
def main(
    mesh: Annotated[Path, typer.Argument(help="Mesh file, or courtyard, an example.")] = Path("courtyard"),
    samples: Annotated[int, typer.Option(help="Number of rays per vertex.")] = 1024,
    chunk: Annotated[int, typer.Option(help="Number of vertices per chunk.", min=1)] = 100,
    seed: Annotated[int, typer.Option(help="Seed of the rays.")] = 0,
    up: Annotated[Literal["x", "y", "z"], typer.Option(help="Axis of the mesh that points up.")] = "z",
    screenshot: Annotated[
        Path | None, typer.Option(help="Save to this file, .png or .html, in place of a window.", show_default=False)
    ] = None,
    size: Size = (1800, 680),
) -> None:
    """Bake the sky view factors of a mesh's vertices into a Zarr store by chunks, read the store, and show its arrays."""
    rendering.check_output(screenshot, rendering.SCENE_SUFFIXES, mesh)
    rendering.check_size(size, (900, 340))
    rendering.check_rendering()
    surface_mesh = ws.load_mesh(mesh)
    with tempfile.TemporaryDirectory() as folder:
        arrays = bake(folder, surface_mesh, samples, chunk, seed, up)
    number = np.arange(len(arrays["value"])) // chunk
    summary = (
        f"{mesh.name}: {len(number):,} vertices in {number[-1] + 1:,} chunks of a store, {samples:,} rays each; seed {seed}"
    )
    plotter = columns_over_caption(3, summary, screenshot is not None, size)
    for column, panel in enumerate([*make_panels(arrays), None]):
        plotter.subplot(0, column)
        if panel is None:
            draw_chunks(plotter, surface_mesh, number)
        else:
            draw_panel(plotter, surface(surface_mesh.vertices, surface_mesh.faces), panel)
            draw_edges(plotter, surface_mesh.vertices, surface_mesh.faces)
        fit_view(plotter, surface_mesh.vertices, up, ABOVE)
    plotter.link_views()
    show_or_save(plotter, screenshot, summary)


if __name__ == "__main__":
    typer.run(main)
