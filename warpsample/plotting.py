"""Arrays as PyVista actors and matplotlib figures. Draws what it is given and computes nothing else."""

import os
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    import pyvista
    from matplotlib.figure import Figure

    from warpsample.proof.histogram import HistogramTest

MOST_POINTS = 1_000_000
"""Cloud points that software rendering draws in a second."""

_SURFACE = "#d8d4cc"
_SKY = "#c7d5e0"  # that a white mesh stands out from
_LOBE = "#d1495b"
_BARS = "#7aa6c2"

_AXES = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}
_VIEW = {"x": (0.35, 0.3, 1.0), "y": (0.3, 0.35, 1.0), "z": (0.3, -1.0, 0.35)}

_PROBE = (
    "import pyvista as pv; p = pv.Plotter(off_screen=True, window_size=(16, 16)); p.add_mesh(pv.Sphere()); p.screenshot()"
)
_NO_GL = "pictures need an OpenGL library and none works here. On Debian or Ubuntu: apt-get install libegl1 libgl1-mesa-dri"


def has_screen() -> bool:
    """Whether a window can be opened."""
    return sys.platform != "linux" or bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


def check_output(screenshot: Path | None) -> None:
    """Refuses a picture that nobody would see.

    Raises:
        ValueError: no file and no screen, or a file in no folder.
    """
    if screenshot is None and not has_screen():
        raise ValueError("there is no screen to open a window on: save a picture with --screenshot FILE")
    if screenshot is not None and not screenshot.resolve().parent.is_dir():
        raise ValueError(f"--screenshot: got {str(screenshot)!r}, whose folder does not exist")


def show_or_save(plotter: "pyvista.Plotter", screenshot: Path | None, what: str) -> None:
    """Opens a window, or saves the picture and prints what it is."""
    if screenshot is None:
        plotter.show()
        return
    save_screenshot(plotter, screenshot)
    print(f"{screenshot}: {what}")  # noqa: T201


def check_rendering() -> None:
    """Renders 16 x 16 pixels in a child process, because without a GL library constructing a Plotter kills Python.

    Raises:
        ModuleNotFoundError: PyVista or matplotlib is missing; says how to install them.
        RuntimeError: rendering does not work; says what to install.
    """
    try:
        import matplotlib  # noqa: F401, ICN001, PLC0415
        import pyvista  # noqa: F401, PLC0415
    except ModuleNotFoundError as error:
        raise ModuleNotFoundError(f"pictures need {error.name}: pip install 'warpsample[viz]'") from None
    if not has_screen():
        # Without a screen VTK tries X first and complains on stderr before it takes EGL.
        os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow")
    probe = subprocess.run([sys.executable, "-c", _PROBE], capture_output=True, check=False)
    if probe.returncode != 0:
        raise RuntimeError(_NO_GL)


@dataclass(frozen=True, eq=False)
class Clouds:
    """Directions at points as one set of coloured points.

    Attributes:
        position: (N, 3) float, world coordinates, N of all clouds together.
        value: (N,) what colours them.
        title: of the colour bar, with its unit.
    """

    position: np.ndarray
    value: np.ndarray
    title: str


def budgeted(points: int, count: int, budget: int = MOST_POINTS) -> tuple[int, int]:
    """(points, directions of each) to draw, at most those asked for, so that all clouds together stay within the budget."""
    points = min(points, budget)
    return points, max(1, min(count, budget // max(points, 1)))


def draw_clouds(
    plotter: "pyvista.Plotter",
    vertices: np.ndarray,
    faces: np.ndarray,
    position: np.ndarray,
    normal: np.ndarray,
    scale: float,
    clouds: Clouds,
) -> None:
    """The mesh, the points with their normals, and all clouds as one set of points.

    Args:
        plotter: its current renderer is drawn into.
        vertices: (V, 3).
        faces: (F, 3).
        position: (P, 3).
        normal: (P, 3), drawn at length `scale`.
        scale: world units.
        clouds: what to draw around the points.
    """
    import pyvista as pv  # noqa: PLC0415

    surface = pv.PolyData.from_regular_faces(vertices, faces)
    plotter.add_mesh(surface, color=_SURFACE, smooth_shading=True, split_sharp_edges=True)
    ends = np.stack([position, position + scale * normal], axis=1).reshape(-1, 3)
    segments = pv.PolyData(ends, lines=np.insert(np.arange(len(ends)).reshape(-1, 2), 0, 2, axis=1).ravel())
    plotter.add_mesh(segments, color="black", line_width=2)
    plotter.add_mesh(pv.PolyData(position), color="black", point_size=5, render_points_as_spheres=True)
    cloud = pv.PolyData(clouds.position)
    cloud["pdf"] = clouds.value
    bar = {
        "title": clouds.title,
        "n_labels": 2,
        "fmt": "%.2f",
        "vertical": False,
        "position_x": 0.25,
        "position_y": 0.02,
    }
    bar |= {"title_font_size": 16, "label_font_size": 14, "height": 0.11, "width": 0.5, "color": "black"}
    plotter.add_mesh(cloud, scalars="pdf", cmap="viridis", point_size=3, lighting=False, scalar_bar_args=bar)


def lobe_histogram(edges: np.ndarray, test: "HistogramTest", caption: str) -> "Figure":
    """Counts of theta as bars against the lobe's density, with the residuals below.

    Args:
        edges: (K + 1,) radians.
        test: of the K cells.
        caption: what was drawn, for the axis.
    """
    from matplotlib.figure import Figure  # noqa: PLC0415

    figure = Figure(layout="constrained")
    above, below = figure.subplots(2, 1, sharex=True, height_ratios=(3, 1))
    degrees, widths, total = np.degrees(edges), np.diff(edges), test.observed.sum()
    above.stairs(test.observed / (total * widths), degrees, fill=True, color=_BARS, label="normalize(sphere + n)")
    fine = np.linspace(0.0, np.pi / 2, 361)
    above.plot(np.degrees(fine), np.sin(2 * fine), color=_LOBE, linewidth=2, label="cosine lobe, sin 2θ")
    above.set_ylabel("density [1/rad]")
    above.set_ylim(0, 1.2)
    above.legend(loc="upper center", ncols=2, frameon=False)
    above.set_title(f"χ² = {test.chi_square:.1f}, dof = {test.dof}, p = {test.p_value:.3f}")
    below.axhspan(-2, 2, color="0.92")
    below.stairs(test.residuals, degrees, fill=True, color=_BARS)
    below.axhline(0, color="0.3", linewidth=0.8)
    below.set_ylim(-5, 5)
    below.set_xlim(0, 90)
    below.set_xticks(range(0, 91, 15))
    below.set_ylabel("residual [σ]")
    below.set_xlabel(f"θ from the normal [degrees]\n{caption}")
    return figure


def clouds_beside_histogram(
    figure: "Figure", caption: str, up: str, off_screen: bool, size: tuple[int, int], **scene: Any
) -> "pyvista.Plotter":
    """A plotter with the clouds on the left and the figure on the right.

    Args:
        figure: the right half.
        caption: above the clouds.
        up: "x", "y" or "z", the axis that points up.
        off_screen: no window.
        size: of both halves, pixels.
        scene: the arguments of `draw_clouds` after the plotter.
    """
    import pyvista as pv  # noqa: PLC0415

    plotter = pv.Plotter(shape=(1, 2), off_screen=off_screen, window_size=size, border=False)
    plotter.set_background("white")
    plotter.subplot(0, 0)
    draw_clouds(plotter, **scene)
    plotter.add_text(caption, font_size=10, color="black")
    plotter.view_vector(_VIEW[up], viewup=_AXES[up])
    plotter.camera.zoom(1.25)
    plotter.subplot(0, 1)
    _show_figure(plotter, figure, size[0] // 2, size[1])
    plotter.enable_anti_aliasing("ssaa", all_renderers=True)
    return plotter


@dataclass(frozen=True, eq=False)
class Panel:
    """A number at each vertex.

    Attributes:
        value: (V,).
        title: above the picture.
        colours: a colour map's name.
        limits: of the colours.
    """

    value: np.ndarray
    title: str
    colours: str
    limits: tuple[float, float]


def meshes_side_by_side(
    vertices: np.ndarray,
    faces: np.ndarray,
    panels: list[Panel],
    caption: str,
    up: str,
    off_screen: bool,
    size: tuple[int, int],
) -> "pyvista.Plotter":
    """A plotter with the mesh in each panel's colours; one camera turns them all.

    Args:
        vertices: (V, 3).
        faces: (F, 3).
        panels: from left to right.
        caption: below the first.
        up: "x", "y" or "z", the axis that points up.
        off_screen: no window.
        size: of all together, pixels.
    """
    import pyvista as pv  # noqa: PLC0415

    plotter = pv.Plotter(shape=(1, len(panels)), off_screen=off_screen, window_size=size, border=False)
    plotter.set_background(_SKY)
    for column, panel in enumerate(panels):
        plotter.subplot(0, column)
        surface = pv.PolyData.from_regular_faces(vertices, faces)
        surface[panel.title] = panel.value
        bar = {
            "title_font_size": 1,
            "label_font_size": 15,
            "height": 0.06,
            "width": 0.7,
            "position_x": 0.15,
            "color": "black",
        }
        plotter.add_mesh(
            surface,
            scalars=panel.title,
            cmap=panel.colours,
            clim=panel.limits,
            lighting=False,
            scalar_bar_args={
                **bar,
                "title": " " * (column + 1),
                "position_y": 0.06,
                "n_labels": 5,
                "fmt": "%.4g",
                "color": "black",
            },
        )
        plotter.add_text(panel.title, font_size=11, color="black", position="upper_edge")
        plotter.view_vector(_VIEW[up], viewup=_AXES[up])
        plotter.camera.zoom(1.2)
    plotter.subplot(0, 0)
    plotter.add_text(caption, font_size=8, color="black", position="lower_left")
    plotter.link_views()
    plotter.enable_anti_aliasing("ssaa", all_renderers=True)
    return plotter


def _show_figure(plotter: "pyvista.Plotter", figure: "Figure", width: int, height: int) -> None:
    """The figure as a picture that fills the current renderer and stays put when the mouse turns the other one."""
    import pyvista as pv  # noqa: PLC0415
    from matplotlib.backends.backend_agg import FigureCanvasAgg  # noqa: PLC0415

    figure.set_size_inches(width / figure.dpi, height / figure.dpi)
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    pixels = np.asarray(canvas.buffer_rgba())[..., :3].copy()
    sheet = pv.Plane(i_size=width, j_size=height, i_resolution=1, j_resolution=1)
    plotter.add_mesh(sheet, texture=pv.Texture(pixels), lighting=False)
    plotter.view_xy()
    plotter.enable_parallel_projection()
    plotter.camera.parallel_scale = height / 2
    plotter.renderer.SetInteractive(False)


def save_screenshot(plotter: "pyvista.Plotter", path: Path) -> np.ndarray:
    """Renders into a PNG; a failure leaves no half file. Returns the image, (H, W, 3) uint8."""
    partial = path.with_name(f".{path.name}.part.png")
    try:
        image = plotter.screenshot(partial, return_img=True)
        partial.replace(path)
    finally:
        partial.unlink(missing_ok=True)
        plotter.close()
    return image
