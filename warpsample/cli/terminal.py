"""Output of all commands and scripts: errors in one line, progress, tables, and pictures in a window or a file."""

import codecs
import inspect
import re
import sys
import threading
import unicodedata
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from functools import wraps
from pathlib import Path
from typing import Annotated, Any, Literal

import typer

from warpsample.cli import signals
from warpsample.cli.streams import discard_output, print_error, print_report
from warpsample.host.files import WriteError


def option(words: str, *names: str) -> Any:
    """Build the Typer option of a command from its whole help text, `words`, which states the default."""
    return typer.Option(*names, help=words, show_default=False)


def output_file(kinds: str) -> Any:
    """Build the Typer option `--output` of a command; `kinds` lists the file suffixes in its help text."""
    return option(f"File to write: {kinds}.", "--output", "-o")


MESH_HELP = "Mesh file (.ply .obj .stl .off .glb .gltf .usd), or courtyard for the built-in example"
MeshFile = Annotated[Path, typer.Argument(help=f"{MESH_HELP}.", show_default=False)]
BakedFile = Annotated[
    Path,
    typer.Argument(
        help=f"{MESH_HELP}; CityJSON file; or raster of heights, such as a .tif.", show_default=False, metavar="mesh"
    ),
]
At = Annotated[
    Literal["vertices", "faces"] | None,
    option("Use the vertices or the centres of the faces, instead of --points."),
]
FigureFile = Annotated[Path | None, option("File to write instead of opening a window: .png, .svg or .pdf.")]
Workers = Annotated[
    int | None, option("Number of threads. Default: the environment variable WARPSAMPLE_WORKERS, or one per core.")
]
Size = Annotated[tuple[int, int], typer.Option(help="Width and height in pixels.")]

_OF_SIGPIPE = 128 + 13  # the status of what ends by that signal
_PIPE_WIDTH = 120  # width of tables without a terminal
_SILENCE = 1.0  # seconds that a step may take without a message


def fail_plainly(**options: str) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
    """Decorate a command to report an error as one line on stderr and exit status 1 or 2, without a traceback.

    The status is 2 for bad input, and 1 for a file that cannot be written.

    Other errors keep their traceback. A message that starts with the name of an argument shows the option instead.

    Args:
        **options: Names of options that differ from the argument's name, keyed by argument.
    """

    def decorate(command: Callable[..., Any]) -> Callable[..., Any]:
        names = _options_of(command) | options

        @wraps(command)
        def run(*arguments: Any, **keywords: Any) -> None:  # without a docstring: `wraps` gives it the command's
            with signals.listening(), printing_errors(**names):
                command(*arguments, **keywords)
                sys.stdout.flush()

        return run

    return decorate


@contextmanager
def printing_errors(**options: str) -> Iterator[None]:
    """Report an error within a `with` statement as one line on stderr, and exit with status 1 or 2."""
    try:
        yield
    except SystemExit as stop:
        if stop.code == 1 and _closed_pipe(stop):  # as rich and click end when nobody reads on
            raise SystemExit(_OF_SIGPIPE) from None
        raise
    except (ValueError, TypeError, OSError, EOFError, MemoryError, ModuleNotFoundError, RuntimeError) as error:
        if signals.heard() or isinstance(error, typer.Exit):  # a closed terminal can fail in many ways
            raise
        _fail(error, options)


def _closed_pipe(error: BaseException | None) -> bool:
    """Return whether an error was caused by a closed pipe."""
    while error is not None and not isinstance(error, BrokenPipeError):
        error = error.__context__
    return error is not None


def _options_of(command: Callable[..., Any]) -> dict[str, str]:
    """Return the options of a command, keyed by parameter name."""
    return {
        name: f"--{name.replace('_', '-')}"
        for name, parameter in inspect.signature(command).parameters.items()
        if any(isinstance(item, typer.models.OptionInfo) for item in getattr(parameter.annotation, "__metadata__", ()))
    }


def _fail(error: Exception, options: dict[str, str]) -> None:
    """Print an error as one line on stderr, and exit with status 1 (cannot write) or 2 (bad input)."""
    try:
        sys.stdout.flush()
    except OSError as flaw:  # a full disk, or a closed pipe
        discard_output(sys.stdout)
        if type(error) is OSError and error.errno == flaw.errno and error.filename is None:
            error = WriteError(f"standard output cannot be written: {flaw.strerror}")
    if isinstance(error, BrokenPipeError):
        raise SystemExit(_OF_SIGPIPE) from None
    if isinstance(error, FileNotFoundError) and error.errno and error.filename is None:  # of `os.getcwd`
        error = FileNotFoundError("the working folder no longer exists; change to another folder")
    message = re.sub(r"^\w+(?=: )", lambda name: options.get(name[0], name[0]), str(error) or type(error).__name__)
    print_error(f"error: {message}")
    raise SystemExit(1 if isinstance(error, WriteError) else 2) from error


def print_anything() -> None:
    """Make stdout and stderr replace characters that the terminal's encoding lacks, for example θ by theta."""
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="warpsample")


def _spell(error: UnicodeError) -> tuple[str, int]:
    """Return replacements for characters that a stream cannot encode; an error handler for `codecs`."""
    if not isinstance(error, UnicodeEncodeError):
        raise error
    return "".join(map(_spell_letter, error.object[error.start : error.end])), error.end


def _spell_letter(letter: str) -> str:
    """Return the name of a Greek letter, or the number of another character."""
    name = unicodedata.name(letter, "")
    if name.startswith("GREEK SMALL LETTER "):
        return name.split()[-1].lower()
    return letter.encode("ascii", "backslashreplace").decode()


codecs.register_error("warpsample", _spell)


@contextmanager
def working(what: str) -> Iterator[None]:
    """Show the name of a step on a terminal's stderr if the step, within a `with` statement, takes over a second."""
    timer = threading.Timer(_SILENCE, print_error, [f"{what} ..."])
    timer.daemon = True
    if sys.stderr.isatty():
        timer.start()
    try:
        yield
    finally:
        timer.cancel()


def show_or_save(picture: Any, screenshot: Path | None, what: str) -> None:
    """Show a picture in a window or, with `screenshot`, write it to a file and print a line about it.

    Args:
        picture: PyVista plotter or Matplotlib figure.
        screenshot: Path of the file, or None for a window.
        what: Description of the picture.
    """
    from warpsample.plotting import rendering, scenes

    figure = hasattr(picture, "savefig")
    if screenshot is None:
        with signals.at_once():
            (scenes.figure_in_window(picture) if figure else picture).show()
        return
    if figure:
        rendering.save_figure(picture, screenshot)
    else:
        rendering.save_scene(picture, screenshot, what)
    print_report(f"{screenshot}: {what}")


def console() -> Any:
    """Return a rich Console for tables on stdout."""
    from rich.console import Console

    return Console(width=None if sys.stdout.isatty() else _PIPE_WIDTH)


def with_progress(items: Iterable[Any], total: int, what: str) -> Iterator[Any]:
    """Yield the items, with a progress bar on stderr if stderr is a terminal."""
    from rich.console import Console
    from rich.progress import track

    bar = Console(stderr=True)
    return track(items, what, total, console=bar, disable=not bar.is_terminal)
