"""The standard streams of a command: opened if they are closed, and written to as long as somebody reads them."""

import os
import sys
from contextlib import suppress

TYPE_CHECKING = False  # importing it from `typing` takes 10 ms, without signal handling
if TYPE_CHECKING:
    from typing import TextIO


def open_closed_streams() -> None:
    """Connect each of stdin, stdout and stderr that is closed to the null device."""
    while (number := os.open(os.devnull, os.O_RDWR)) <= 2:
        pass
    os.close(number)
    for number, (name, mode) in enumerate((("stdin", "r"), ("stdout", "w"), ("stderr", "w"))):
        if getattr(sys, name) is None:
            setattr(sys, name, os.fdopen(number, mode, encoding="utf-8", closefd=False))


def escape(text: str) -> str:
    """Replace each unprintable character of a text, line breaks included, by an escape such as repr() gives.

    Names in a file could otherwise move the cursor of a terminal or forge lines of a report.
    """
    return text if text.isprintable() else "".join(one if one.isprintable() else repr(one)[1:-1] for one in text)


def print_report(text: str) -> None:
    """Print a text of one or more lines on stdout; other characters that are not printable are escaped."""
    print("\n".join(map(escape, text.split("\n"))))


def print_error(sentence: str) -> None:
    """Print a message as one line on stderr; do nothing if stderr is closed."""
    try:
        print(escape(sentence), file=sys.stderr, flush=True)
    except OSError:
        discard_output(sys.stderr)


def discard_output(stream: "TextIO") -> None:
    """Discard all further output of a stream, including the text that Python writes when it ends."""
    with suppress(OSError, ValueError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())


def show_cursor() -> None:
    """Make the terminal's cursor visible again, after an interrupted progress bar."""
    terminal = sys.__stderr__
    if terminal is not None and terminal.isatty() and os.environ.get("TERM", "dumb") != "dumb":
        with suppress(OSError):
            print("\x1b[?25h", end="", file=terminal, flush=True)
