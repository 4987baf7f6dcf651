"""Checks before a picture is drawn, limits on its contents, and functions that save it."""

import importlib
import json
import os
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
from warpsample.host.extras import missing, run_program

if TYPE_CHECKING:
    import pyvista
    from matplotlib.figure import Figure

MOST_POINTS = 1_000_000
"""Largest number of cloud points in a picture; software rendering takes a second for a million points."""
MOST_NORMALS = 100_000
"""Largest number of normals in a picture; software rendering takes a tenth of a second for 100,000 lines."""
MOST_SMOOTH_FACES = 200_000
"""Largest number of faces with smooth shading. In larger meshes a face covers few pixels, and smoothing takes seconds."""
SCENE_SUFFIXES = (".png", ".html")
"""File suffixes of saved 3-D scenes."""
FIGURE_SUFFIXES = (".png", ".svg", ".pdf")
"""File suffixes of saved figures."""

_MOST_SIDE = 1 << 14
_MOST_PIXELS = 100_000_000  # software rendering takes 90 s; above 2^28 samples the picture stays black
_BYTES_PER_PIXEL = 80  # 75 measured, with eight samples each

AXES = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}
VIEW = {"x": (0.35, 0.3, 1.0), "y": (0.3, 0.35, 1.0), "z": (0.3, -1.0, 0.35)}
"""Direction from the mesh to the camera, keyed by the name of the axis that points up."""

# The caption is a style, because the script of the scene empties the body.
_CAPTION = (
    "<style>body::after{{content:{};position:fixed;z-index:9;left:1em;top:1em;font:15px sans-serif;color:#333}}</style>"
)
PROBE = (
    "import pyvista as pv; p = pv.Plotter(off_screen=True, window_size=(16, 16)); p.add_mesh(pv.Sphere()); p.screenshot()"
)
"""Program of the child process that tests whether scenes can be rendered on this machine."""
_NO_GL = "pictures need an OpenGL library and none works here. On Debian or Ubuntu: apt-get install libegl1 libgl1-mesa-dri"


def has_screen() -> bool:
    """Return whether a window can be opened on this machine."""
    return sys.platform != "linux" or bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


def check_output(screenshot: Path | None, suffixes: tuple[str, ...], *inputs: Path | None) -> None:
    """Raise an error unless a picture can be shown in a window or saved to a file.

    Args:
        screenshot: path of the picture; None opens a window.
        suffixes: file suffixes that are allowed.
        *inputs: files that the picture must not replace.

    Raises:
        ValueError: there is no screen and no file; or the file has another suffix, is an input, or cannot be written.
    """
    if screenshot is None and not has_screen():
        raise ValueError("this machine has no screen for a window; save a picture with --screenshot FILE")
    if screenshot is not None and screenshot.suffix not in suffixes:
        raise ValueError(f"--screenshot: got {str(screenshot)!r}, want a file that ends in {' or '.join(suffixes)}")
    if screenshot is not None:
        files.check_output(screenshot, "--screenshot", *inputs)


def check_rendering() -> None:
    """Raise an error unless PyVista can render scenes on this machine.

    A child process renders 16 x 16 pixels, because creating a Plotter without an OpenGL library kills Python.

    Raises:
        ModuleNotFoundError: PyVista or matplotlib is missing. The message names the extra to install.
        RuntimeError: there is no OpenGL library that works. The message names the packages to install.
    """
    try:
        importlib.import_module("matplotlib")
        importlib.import_module("pyvista")
    except ModuleNotFoundError as error:
        raise missing(f"pictures need {error.name}", error.name) from None
    if not has_screen():
        # Without a screen VTK tries X first and complains on stderr before it takes EGL.
        os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow")
    if not _is_successful(PROBE):
        raise RuntimeError(_NO_GL)


@lru_cache
def _is_successful(probe: str) -> bool:
    return run_program(probe)[0] == 0


def limit_counts(points: int, count: int) -> tuple[int, int]:
    """Reduce the numbers of points and of directions per point so that at most MOST_POINTS directions are drawn."""
    points = min(points, MOST_POINTS)
    return points, max(1, min(count, MOST_POINTS // max(points, 1)))


def describe_counts(shown: tuple[int, int], requested: tuple[int, int]) -> str:
    """Describe the numbers of points, and of directions at each point, in a caption.

    If fewer are drawn than requested, the caption has the requested numbers too.
    """
    counts = f"{shown[0]:,} {'point' if shown[0] == 1 else 'points'} x {shown[1]:,} directions"
    return counts if shown == requested else f"{counts} (of {requested[0]:,} x {requested[1]:,} requested)"


def round_ticks(high: float, most: int) -> np.ndarray:
    """Return round numbers for the ticks of an axis from 0 to `high` > 0, in at most `most` equal steps.

    The last number is the first one at or above `high`.
    """
    from matplotlib.ticker import MaxNLocator

    return MaxNLocator(most, steps=[1, 2, 2.5, 5, 10]).tick_values(0.0, high)


def save_scene(plotter: "pyvista.Plotter", path: Path, caption: str) -> None:
    """Write a PyVista scene to a .png or .html file, and close its plotter. A failure leaves no incomplete file.

    A .png has the size of the plotter. An .html can be turned in a browser; it shows `caption` in place of the texts of the
    scene. The scene must not have been shown before.

    Raises:
        ModuleNotFoundError: trame-pyvista is missing, which writes .html.
    """
    try:
        if path.suffix == ".png":
            picture = BytesIO()
            plotter.screenshot(picture, return_img=False)
            files.write_bytes(path, picture.getvalue())
        else:
            style = _CAPTION.format(json.dumps(caption, ensure_ascii=False).replace("<", "\\3c "))
            with _without_download():
                page = plotter.trame.export_html(None).read().replace("</head>", f"{style}</head>", 1)
            files.write_bytes(path, page.encode())
    except ImportError as error:
        raise missing(f"an .html scene needs trame-pyvista and nest-asyncio2 ({error})", "trame") from None
    finally:
        plotter.close()


@contextmanager
def _without_download() -> Iterator[None]:
    """Prevent a download of trame's WebAssembly viewer within a `with` statement, since .html files do not need it."""
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
    """Raise an error for a picture whose width and height, in pixels, are too small or too large.

    Raises:
        ValueError: the text of a picture of this size could not be read, or the picture is too large to draw.
        MemoryError: drawing the picture needs more memory than is free.
    """
    received = f"--size: got {size[0]} x {size[1]}"
    if size[0] < least[0] or size[1] < least[1]:
        raise ValueError(f"{received}, want at least {least[0]} x {least[1]}, so that text can be read")
    if max(size) > _MOST_SIDE or size[0] * size[1] > _MOST_PIXELS:
        raise ValueError(f"{received}, want at most {_MOST_SIDE:,} of each and {_MOST_PIXELS:,} pixels in all")
    check_memory(_BYTES_PER_PIXEL * size[0] * size[1], f"{received}, whose pixels", "take a smaller picture")


def size_figure(figure: "Figure", size: tuple[int, int]) -> None:
    """Set the width and height of a figure in pixels. The ratio of text size to figure width stays the same."""
    width = figure.get_figwidth()
    figure.set_dpi(size[0] / width)
    figure.set_size_inches(width, width * size[1] / size[0])


def save_figure(figure: "Figure", path: Path) -> None:
    """Write a matplotlib figure to a file. A failure leaves no incomplete file."""
    picture = BytesIO()
    figure.savefig(picture, format=path.suffix[1:], dpi=figure.dpi)
    files.write_bytes(path, picture.getvalue())


def pixels_of(figure: "Figure") -> np.ndarray:
    """Draw a matplotlib figure, and return its pixels, (H, W, 3) uint8."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    return np.asarray(canvas.buffer_rgba())[..., :3].copy()
