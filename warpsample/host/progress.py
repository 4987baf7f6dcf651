"""Progress of long calls: a bar, a line for a long wait, a logger, and a check between batches that can stop a call.

The bar is shown with `progress=True`, on a terminal or in a notebook. The line for a long wait is shown there too, and on a
terminal in any case. The logger shows nothing by default; `logging.basicConfig(level="INFO")` shows the compiled kernels,
the ray counts of a tolerance, and the tiles.
"""

import logging
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager, nullcontext, suppress
from contextvars import ContextVar
from typing import Any

LEAST_WORK = 1 << 25
"""Directions, or comparable units, from which on a call moves a bar: 0.1 s."""

log: logging.Logger = logging.getLogger("warpsample")
log.addHandler(logging.NullHandler())

_PATIENCE = 1.0  # seconds before a wait is reported

_is_on: ContextVar[bool] = ContextVar("is_on", default=False)
_display: ContextVar[tuple[Any, Any, bool] | None] = ContextVar("display", default=None)
_NO_BAR = nullcontext()
_check: ContextVar[Callable[[], None] | None] = ContextVar("check", default=None)


def bar(progress: bool, what: str, total: int | None = None) -> AbstractContextManager[None]:
    """Show a progress bar within a `with` statement, if `progress` is True.

    The bar has `total` tasks; without `total` it starts anew for each run of a kernel.
    """
    return _bar(what, total) if progress else _NO_BAR


@contextmanager
def _bar(what: str, total: int | None) -> Iterator[None]:
    """Show a progress bar in a terminal (on stderr) or in a notebook."""
    from rich.console import Console  # only bars need it
    from rich.progress import BarColumn, Progress, TaskProgressColumn, TextColumn, TimeRemainingColumn

    console = Console(stderr=True)
    columns = TextColumn("{task.description}"), BarColumn(), TaskProgressColumn(), TimeRemainingColumn()
    disable = not (console.is_terminal or console.is_jupyter)
    with run_display(Progress(*columns, console=console, disable=disable, transient=True)) as display:
        token, seen = (
            _display.set((display, display.add_task(what, total=total), total is not None)),
            _is_on.set(not disable),
        )
        try:
            yield
        finally:
            _display.reset(token)
            _is_on.reset(seen)


@contextmanager
def run_display(display: Any) -> Iterator[Any]:
    """Show a progress bar of rich within a `with` statement, and stop it even if an interrupt comes while it starts.

    Otherwise its thread draws the bar again after the last message.
    """
    try:
        with display:
            yield display
    finally:
        display.live.stop()


@contextmanager
def awaited(what: str) -> Iterator[None]:
    """Print a line on stderr if the work within a `with` statement takes more than a second."""
    if not (_is_on.get() or _is_terminal()):
        yield
        return
    timer = threading.Timer(_PATIENCE, _print_line, [f"warpsample: {what}\n"])
    timer.daemon = True
    timer.start()
    try:
        yield
    finally:
        timer.cancel()


def _is_terminal() -> bool:
    """Return whether stderr is a terminal."""
    with suppress(AttributeError, ValueError):  # there is no stderr, or it is closed
        return sys.stderr.isatty()
    return False


def _print_line(line: str) -> None:
    """Print a line on stderr, unless stderr is closed."""
    with suppress(AttributeError, ValueError, OSError):
        sys.stderr.write(line)
        sys.stderr.flush()


@contextmanager
def asking(wanted: Callable[[], None]) -> Iterator[None]:
    """Call `wanted` regularly while kernels run within a `with` statement; an error from it stops the kernels."""
    token = _check.set(wanted)
    try:
        yield
    finally:
        _check.reset(token)


def begin(tasks: int, work: int) -> Callable[[int], None] | None:
    """Return the function to call after each batch of a kernel's tasks, which moves the progress bar; None without a bar."""
    advance, wanted = _bar_of(tasks, work), _check.get()
    if wanted is None:
        return advance

    def done(tasks: int) -> None:
        if advance:
            advance(tasks)
        wanted()

    return done


def _bar_of(tasks: int, work: int) -> Callable[[int], None] | None:
    """Return the function that moves the current progress bar; None without a bar, or for short work."""
    shown = _display.get()
    if shown is None or work < LEAST_WORK:
        return None
    display, task, together = shown
    if not together:
        display.reset(task, total=tasks)
    return lambda done: display.advance(task, done)
