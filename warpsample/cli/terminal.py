"""What every command and script shares: errors in a line, progress, tables, and where a picture goes."""

import sys
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Annotated, Any

import typer

from warpsample.files import WriteError

FigureFile = Annotated[Path | None, typer.Option(help="No window, but a file: .png, .svg or .pdf.", show_default=False)]
Size = Annotated[tuple[int, int], typer.Option(help="Width and height in pixels.")]

_PIPE_WIDTH = 120  # of tables where there is no terminal to fit


@contextmanager
def fail_plainly() -> Iterator[None]:
    """Turns an error into one line on stderr: status 1 for a file that cannot be written, 2 for what is wrong in the input.

    Anything else keeps its traceback.
    """
    try:
        yield
    except (ValueError, TypeError, OSError, MemoryError, ModuleNotFoundError, RuntimeError) as error:
        print(f"error: {error}", file=sys.stderr)  # noqa: T201
        raise SystemExit(1 if isinstance(error, WriteError) else 2) from error
    except KeyboardInterrupt as interrupt:
        print(str(interrupt) or "interrupted; nothing was written", file=sys.stderr)  # noqa: T201
        raise SystemExit(130) from None


def show_or_save(picture: Any, screenshot: Path | None, what: str) -> None:
    """The end of a script that makes pictures: a window, or a file and a line on stdout that says what it shows.

    Args:
        picture: a PyVista plotter or a matplotlib figure.
        screenshot: the file; None opens a window.
        what: is to be seen.
    """
    from warpsample.plotting import rendering, scenes  # noqa: PLC0415

    figure = hasattr(picture, "savefig")
    if screenshot is None:
        (scenes.figure_in_window(picture) if figure else picture).show()
        return
    if figure:
        rendering.save_figure(picture, screenshot)
    else:
        rendering.save_scene(picture, screenshot, what)
    print(f"{screenshot}: {what}")  # noqa: T201


def console() -> Any:
    """For tables on stdout."""
    from rich.console import Console  # noqa: PLC0415

    return Console(width=None if sys.stdout.isatty() else _PIPE_WIDTH)


def with_progress(items: Iterable[Any], total: int, what: str) -> Iterator[Any]:
    """Shows a bar on stderr, if that is a terminal."""
    from rich.console import Console  # noqa: PLC0415
    from rich.progress import track  # noqa: PLC0415

    bar = Console(stderr=True)
    return track(items, what, total, console=bar, disable=not bar.is_terminal)
