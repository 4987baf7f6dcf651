"""View factors from one face of a mesh, their standard errors, and the sky view factor of each face."""

from pathlib import Path
from typing import Annotated, Any, Literal

import numpy as np
import typer

import warpsample as ws
from warpsample.cli.terminal import Size, fail_plainly, show_or_save
from warpsample.host.arguments import check_integer
from warpsample.plotting import rendering, style
from warpsample.plotting.panels import Panel, draw_edges, fit_view, meshes_side_by_side

MARK = "#0077ff"
ABOVE = 2.0  # height of the camera: walls do not hide the ground


def make_panels(factors: ws.ViewFactors, face: int) -> list[Panel]:
    """Compute three panels to draw: view factors from the face `face`, their standard errors, and sky view factors.

    The numbers are at the corners of the faces, (3 F,).

    Faces that `face` does not see have NaN. The last colours are round numbers above nine of ten numbers.
    """
    row, error = (matrix[[face]].toarray()[0] for matrix in (factors.matrix, factors.standard_error))
    hidden = row <= 0.0
    panels = [
        Panel(np.where(hidden, np.nan, row), "View factors from the blue face", style.AMOUNT, _round_above(row),
              "share of its radiation that arrives (grey: none)"),
        Panel(np.where(hidden, np.nan, error), "Standard errors of the view factors", style.ERROR, _round_above(error),
              "standard error (grey: not seen)"),
        Panel(factors.sky, "Sky view factor of each face", style.OPENNESS, 1.0, "0: no sky, 1: the whole sky"),
    ]  # fmt: skip
    return [Panel(np.repeat(each.value, 3), each.title, each.colours, each.high, each.label) for each in panels]


def choose_face(mesh: ws.Mesh, factors: ws.ViewFactors, up: str) -> int:
    """Return the number of the upward-facing face that sees most faces, or of any face if none faces up."""
    seen = np.diff(factors.matrix.indptr)
    level = mesh.face_normals.astype(np.float64) @ rendering.AXES[up] > 0.9
    return int(np.argmax(np.where(level, seen, -1) if level.any() else seen))


def outline(plotter: Any, mesh: ws.Mesh, face: int, up: str, panels: int) -> None:
    """Draw the sharp edges of a mesh and the outline of one face in each panel, seen from above."""
    import pyvista as pv  # noqa: PLC0415

    for column in range(panels):
        plotter.subplot(0, column)
        draw_edges(plotter, mesh.vertices, mesh.faces)
        sides = pv.lines_from_points(mesh.vertices[mesh.faces[face]], close=True)
        plotter.add_mesh(sides, color=MARK, line_width=5, lighting=False)
        fit_view(plotter, mesh.vertices, up, ABOVE)


def _round_above(values: np.ndarray) -> float:
    """Return a round number above 90 % of the positive values, as the end of a colour bar.

    The largest values would darken the picture.
    """
    positive = values[values > 0.0]
    return rendering.round_ticks(float(np.quantile(positive, 0.9)) if positive.size else 1.0, 5)[-1]


@fail_plainly()
def main(
    mesh: Annotated[Path, typer.Argument(help="Mesh file, or courtyard, an example.")] = Path("courtyard"),
    face: Annotated[
        int | None,
        typer.Option(help="Number of the face. Default: the upward-facing face that sees most faces.", show_default=False),
    ] = None,
    count: Annotated[int, typer.Option(help="Number of rays per face.")] = 4096,
    seed: Annotated[int, typer.Option(help="Seed of the rays.")] = 0,
    up: Annotated[Literal["x", "y", "z"], typer.Option(help="Axis of the mesh that points up.")] = "z",
    screenshot: Annotated[
        Path | None, typer.Option(help="Save to this file, .png or .html, in place of a window.", show_default=False)
    ] = None,
    size: Size = (1800, 680),
) -> None:
    """Show the view factors from one face of a mesh, their standard errors, and the sky view factor of each face."""
    rendering.check_output(screenshot, rendering.SCENE_SUFFIXES, mesh)
    rendering.check_size(size, (900, 340))
    rendering.check_rendering()
    surface = ws.load_mesh(mesh)
    if face is not None:
        check_integer(face, "face", 0, len(surface.faces) - 1)
    factors = ws.view_factors(surface, count, seed=seed, up=np.eye(3)["xyz".index(up)])
    face = choose_face(surface, factors, up) if face is None else face
    place = ", ".join(f"{x:g}" for x in surface.vertices[surface.faces[face]].mean(axis=0).round(3))
    summary = f"{mesh.name}: from face {face:,} at ({place}); {len(surface.faces):,} faces, {count:,} rays each; seed {seed}"
    corners = surface.vertices[surface.faces].reshape(-1, 3)
    faces = np.arange(len(corners), dtype=np.int32).reshape(-1, 3)
    panels = make_panels(factors, face)
    off_screen = screenshot is not None
    plotter = meshes_side_by_side(corners, faces, panels, caption=summary, up=up, off_screen=off_screen, size=size)
    outline(plotter, surface, face, up, len(panels))
    show_or_save(plotter, screenshot, summary)


if __name__ == "__main__":
    typer.run(main)
