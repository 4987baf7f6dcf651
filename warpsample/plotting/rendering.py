"""Whether pictures can be made here, how much is drawn on one, its colours, and how it is saved."""

import importlib
import json
import os
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from functools import lru_cache
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from warpsample.host import files
from warpsample.host.engine import check_memory
from warpsample.host.extras import missing

if TYPE_CHECKING:
    import pyvista
    from matplotlib.figure import Figure

MOST_POINTS = 1_000_000
"""The most cloud points on a picture; software rendering draws that many in a second."""
MOST_NORMALS = 100_000
"""The most normals on a picture; software rendering draws that many in a tenth of a second."""
MOST_SMOOTH_FACES = 200_000
"""The most faces that are shaded smoothly; with more of them, each is a few pixels large and smoothing takes seconds."""
SCENE_SUFFIXES = (".png", ".html")
"""The kinds of files that a 3-D scene can be saved as."""
FIGURE_SUFFIXES = (".png", ".svg", ".pdf")
"""The kinds of files that a figure can be saved as."""

_MOST_SIDE = 1 << 14
_MOST_PIXELS = 100_000_000  # software rendering takes a minute and a half; 2^28 with their samples it leaves black
_BYTES_PER_PIXEL = 80  # 75 measured, with eight samples each

SURFACE = "#d8d4cc"
SKY = "#c7d5e0"  # that a white mesh stands out from
LOBE = "#d1495b"
BARS = "#7aa6c2"
DOTS = "#2f6690"
INK = "#333333"

AXES = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}
VIEW = {"x": (0.35, 0.3, 1.0), "y": (0.3, 0.35, 1.0), "z": (0.3, -1.0, 0.35)}
"""The direction from which a mesh is seen when the axis of that name points up."""

# The caption is a style, because the scene's own script empties the body.
_CAPTION = (
    "<style>body::after{{content:{};position:fixed;z-index:9;left:1em;top:1em;font:15px sans-serif;color:#333}}</style>"
)
PROBE = (
    "import pyvista as pv; p = pv.Plotter(off_screen=True, window_size=(16, 16)); p.add_mesh(pv.Sphere()); p.screenshot()"
)
"""The program that a child process runs to find out whether scenes can be rendered here."""
_NO_GL = "pictures need an OpenGL library and none works here. On Debian or Ubuntu: apt-get install libegl1 libgl1-mesa-dri"


def has_screen() -> bool:
    """Whether a window can be opened."""
    return sys.platform != "linux" or bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


def check_output(screenshot: Path | None, suffixes: tuple[str, ...], *inputs: Path | None) -> None:
    """Refuses a picture that nobody would see, by a ValueError.

    Without a file a window is to open, and there may be no screen; a file may have another suffix, be one of the inputs, or
    cannot be written.
    """
    if screenshot is None and not has_screen():
        raise ValueError("there is no screen to open a window on: save a picture with --screenshot FILE")
    if screenshot is not None and screenshot.suffix not in suffixes:
        raise ValueError(f"--screenshot: got {str(screenshot)!r}, want a file that ends in {' or '.join(suffixes)}")
    if screenshot is not None:
        files.check_output(screenshot, "--screenshot", *inputs)


def check_rendering() -> None:
    """Renders 16 x 16 pixels in a child process, because creating a Plotter without an OpenGL library kills Python.

    What is missing is a ModuleNotFoundError, of a package, or a RuntimeError; either says what to install.
    """
    try:
        importlib.import_module("matplotlib")
        importlib.import_module("pyvista")
    except ModuleNotFoundError as error:
        raise missing(f"pictures need {error.name}", error.name) from None
    if not has_screen():
        # Without a screen VTK tries X first and complains on stderr before it takes EGL.
        os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow")
    if not _renders(PROBE):
        raise RuntimeError(_NO_GL)


@lru_cache
def _renders(probe: str) -> bool:
    return subprocess.run([sys.executable, "-c", probe], capture_output=True, check=False).returncode == 0


def budgeted(points: int, count: int) -> tuple[int, int]:
    """How many of the points, and of the directions at each, are drawn: in all, MOST_POINTS directions at most."""
    points = min(points, MOST_POINTS)
    return points, max(1, min(count, MOST_POINTS // max(points, 1)))


def extent_of(shown: tuple[int, int], asked: tuple[int, int]) -> str:
    """How many points, and directions at each, are shown, in words for a caption; and how many were asked for, if more."""
    said = f"{shown[0]:,} {'point' if shown[0] == 1 else 'points'} x {shown[1]:,} directions"
    return said if shown == asked else f"{said} (of {asked[0]:,} x {asked[1]:,} asked for)"


def round_ticks(high: float, most: int) -> np.ndarray:
    """Round numbers at equal steps, at most so many, from 0 to the first one at or above `high`, which is above 0."""
    from matplotlib.ticker import MaxNLocator

    return MaxNLocator(most, steps=[1, 2, 2.5, 5, 10]).tick_values(0.0, high)


def save_scene(plotter: "pyvista.Plotter", path: Path, caption: str) -> None:
    """Writes a scene that is not yet shown, and closes its plotter. A failure leaves no half-written file.

    A .png has the plotter's size; an .html can be turned in a browser and has the caption, as the scene's own texts do not
    appear in it. Without trame-pyvista an .html is a ModuleNotFoundError.
    """
    try:
        if path.suffix == ".png":
            picture = BytesIO()
            plotter.screenshot(picture, return_img=False)
            files.write_bytes(path, picture.getvalue())
        else:
            style = _CAPTION.format(json.dumps(caption, ensure_ascii=False).replace("<", "\\3c "))
            with _offline():
                page = plotter.trame.export_html(None).read().replace("</head>", f"{style}</head>", 1)
            files.write_bytes(path, page.encode())
    except ImportError as error:
        raise missing(f"an .html scene needs trame-pyvista and nest-asyncio2 ({error})", "trame") from None
    finally:
        plotter.close()


@contextmanager
def _offline() -> Iterator[None]:
    """Keeps trame from fetching its WebAssembly viewer from Kitware's server, which an .html by vtk.js does not need."""
    try:
        from trame.widgets import vtklocal
    except ImportError:
        yield
        return
    fetch = vtklocal.initialize
    vtklocal.initialize = lambda *_: None
    try:
        yield
    finally:
        vtklocal.initialize = fetch


def check_size(size: tuple[int, int], least: tuple[int, int] = (600, 600)) -> None:
    """Refuses a picture whose text could not be read (ValueError), or that could not be drawn or held in memory.

    Sizes are width and height in pixels. What needs more memory than is free is a MemoryError.
    """
    said = f"--size: got {size[0]} x {size[1]}"
    if size[0] < least[0] or size[1] < least[1]:
        raise ValueError(f"{said}, want at least {least[0]} x {least[1]}, in which text can be read")
    if max(size) > _MOST_SIDE or size[0] * size[1] > _MOST_PIXELS:
        raise ValueError(f"{said}, want at most {_MOST_SIDE:,} of each and {_MOST_PIXELS:,} pixels in all")
    check_memory(_BYTES_PER_PIXEL * size[0] * size[1], f"{said}, whose pixels", "take a smaller picture")


def size_figure(figure: "Figure", size: tuple[int, int]) -> None:
    """Gives a figure a width and height in pixels; its text keeps its share of the width."""
    width = figure.get_figwidth()
    figure.set_dpi(size[0] / width)
    figure.set_size_inches(width, width * size[1] / size[0])


def save_figure(figure: "Figure", path: Path) -> None:
    """Writes a figure. A failure leaves no half-written file."""
    picture = BytesIO()
    figure.savefig(picture, format=path.suffix[1:], dpi=figure.dpi)
    files.write_bytes(path, picture.getvalue())


def pixels_of(figure: "Figure") -> np.ndarray:
    """The pixels of a figure, (H, W, 3) uint8."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    return np.asarray(canvas.buffer_rgba())[..., :3].copy()
