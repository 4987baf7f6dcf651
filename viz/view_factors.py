"""What one face of a mesh sees: its row of the view factors over the mesh, their standard errors, and everyone's sky."""

from pathlib import Path
from typing import Annotated, Any, Literal

import numpy as np
import typer

import warpsample as ws
from warpsample.cli.terminal import Size, fail_plainly, show_or_save
from warpsample.host.arguments import check_integer
from warpsample.mesh.polydata import surface
from warpsample.plotting import rendering
from warpsample.plotting.scenes import Panel, look_from, meshes_side_by_side

MARK, EDGES = "#00c8ff", "#8a8a8a"


def panels_of(found: ws.ViewFactors, face: int) -> list[Panel]:
    """What is shown of the row of a face: numbers of the corners of all faces, each face's own three times."""
    row, error = (matrix[[face]].toarray()[0] for matrix in (found.matrix, found.standard_error))
    panels = [
        Panel(row, f"View factors from face {face:,}", "magma", _above(row)),
        Panel(error, "Standard error", "viridis", _above(error)),
        Panel(found.sky, "What each face sees of the sky", "gray", 1.0),
    ]
    return [Panel(np.repeat(panel.value, 3), panel.title, panel.colours, panel.high) for panel in panels]


def default_face(mesh: ws.Mesh, found: ws.ViewFactors, up: str) -> int:
    """The face that sees the most others, of those that look up where there are any: the ground between walls."""
    seen = np.diff(found.matrix.indptr)
    level = mesh.face_normals.astype(np.float64) @ rendering.AXES[up] > 0.9
    return int(np.argmax(np.where(level, seen, -1) if level.any() else seen))


def outline(plotter: Any, mesh: ws.Mesh, face: int, up: str, panels: int) -> None:
    """Draws a face's sides and the mesh's edges in all panels, which look down so far that walls do not hide the ground."""
    import pyvista as pv  # noqa: PLC0415

    edges = surface(mesh.vertices, mesh.faces).extract_feature_edges(30.0)
    sides = pv.lines_from_points(mesh.vertices[mesh.faces[face]], close=True)
    for column in range(panels):
        plotter.subplot(0, column)
        plotter.add_mesh(edges, color=EDGES, line_width=1)
        plotter.add_mesh(sides, color=MARK, line_width=4)
        look_from(plotter, up, 1.0)
        plotter.camera.elevation = 40.0


def _above(values: np.ndarray) -> float:
    """A round number above 9 in 10 of those that are not 0, so that a few do not darken the rest."""
    some = values[values > 0.0]
    return rendering.round_ticks(float(np.quantile(some, 0.9)) if some.size else 1.0, 5)[-1]


@fail_plainly()
def main(
    mesh: Annotated[Path, typer.Argument(help="Mesh file; or courtyard, an example.")] = Path("courtyard"),
    face: Annotated[
        int | None,
        typer.Option(
            help="Number of the face; by default that which sees most others, of those that look up.",
            show_default=False,
        ),
    ] = None,
    count: Annotated[int, typer.Option(help="Rays of each face.")] = 4096,
    seed: Annotated[int, typer.Option(help="Seed of the rays.")] = 0,
    up: Annotated[Literal["x", "y", "z"], typer.Option(help="The mesh's axis that points up.")] = "z",
    screenshot: Annotated[
        Path | None, typer.Option(help="No window, but a file: .png, or .html to turn in a browser.", show_default=False)
    ] = None,
    size: Size = (1800, 680),
) -> None:
    """Show the view factors from one face to all others of a mesh, their standard errors, and the sky of each face."""
    rendering.check_output(screenshot, rendering.SCENE_SUFFIXES, mesh)
    rendering.check_size(size, (900, 340))
    rendering.check_rendering()
    of = ws.load_mesh(mesh)
    if face is not None:
        check_integer(face, "face", 0, len(of.faces) - 1)
    found = ws.view_factors(of, count, seed=seed, up=np.eye(3)["xyz".index(up)])
    face = default_face(of, found, up) if face is None else face
    place = ", ".join(f"{x:g}" for x in of.vertices[of.faces[face]].mean(axis=0).round(3))
    what = f"face {face:,} at ({place}); {count:,} rays of each of {len(of.faces):,} faces; seed {seed}"
    corners = of.vertices[of.faces].reshape(-1, 3)
    faces = np.arange(len(corners), dtype=np.int32).reshape(-1, 3)
    panels = panels_of(found, face)
    plotter = meshes_side_by_side(corners, faces, panels, caption=what, up=up, off_screen=screenshot is not None, size=size)
    outline(plotter, of, face, up, len(panels))
    show_or_save(plotter, screenshot, what)


if __name__ == "__main__":
    typer.run(main)
