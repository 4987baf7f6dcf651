"""What happens between the batches of a long call: a bar moves, and whoever no longer wants the call stops it.

A bar is for `progress=True`, on a terminal's stderr or in a notebook only. So is a line that says what is being waited for,
but that a terminal is told in any case. And the package's logger, which nobody hears by default:
`logging.basicConfig(level="INFO")` shows the kernels that are compiled, the ray counts of a tolerance, and the tiles.
"""

import logging
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager, nullcontext, suppress
from contextvars import ContextVar
from typing import Any

LEAST_WORK = 1 << 25
"""Directions, or the like: 0.1 s. What takes less does not show how far it is."""

log: logging.Logger = logging.getLogger("warpsample")
log.addHandler(logging.NullHandler())

_PATIENCE = 1.0  # seconds without a word

_seen: ContextVar[bool] = ContextVar("seen", default=False)
_shown: ContextVar[tuple[Any, Any, bool] | None] = ContextVar("shown", default=None)
_NO_BAR = nullcontext()
_asked: ContextVar[Callable[[], None] | None] = ContextVar("asked", default=None)


def bar(progress: bool, what: str, total: int | None = None) -> AbstractContextManager[None]:
    """Shows a bar for the work within, if `progress` is True: anew for each run, or one of `total` tasks."""
    return _bar(what, total) if progress else _NO_BAR


@contextmanager
def _bar(what: str, total: int | None) -> Iterator[None]:
    from rich.console import Console  # only bars need it
    from rich.progress import BarColumn, Progress, TaskProgressColumn, TextColumn, TimeRemainingColumn

    console = Console(stderr=True)
    columns = TextColumn("{task.description}"), BarColumn(), TaskProgressColumn(), TimeRemainingColumn()
    disable = not (console.is_terminal or console.is_jupyter)
    with Progress(*columns, console=console, disable=disable, transient=True) as display:
        token, seen = _shown.set((display, display.add_task(what, total=total), total is not None)), _seen.set(not disable)
        try:
            yield
        finally:
            _shown.reset(token)
            _seen.reset(seen)


@contextmanager
def awaited(what: str) -> Iterator[None]:
    """Says what the work within is if it takes more than a second: on stderr, which a bar of rich's writes around."""
    if not (_seen.get() or _is_terminal()):
        yield
        return
    timer = threading.Timer(_PATIENCE, _say, [f"warpsample: {what}\n"])
    timer.daemon = True
    timer.start()
    try:
        yield
    finally:
        timer.cancel()


def _is_terminal() -> bool:
    with suppress(AttributeError, ValueError):  # there is no stderr, or it is closed
        return sys.stderr.isatty()
    return False


def _say(line: str) -> None:
    with suppress(AttributeError, ValueError, OSError):
        sys.stderr.write(line)
        sys.stderr.flush()


@contextmanager
def asking(wanted: Callable[[], None]) -> Iterator[None]:
    """Within, the calls of this thread ask after each batch whether they are wanted: what `wanted` raises ends them."""
    token = _asked.set(wanted)
    try:
        yield
    finally:
        _asked.reset(token)


def begin(tasks: int, work: int) -> Callable[[int], None] | None:
    """A function that any thread calls with the number of tasks it has done; None if nobody is to be told."""
    told, wanted = _bar_of(tasks, work), _asked.get()
    if wanted is None:
        return told

    def done(tasks: int) -> None:
        if told:
            told(tasks)
        wanted()

    return done


def _bar_of(tasks: int, work: int) -> Callable[[int], None] | None:
    """What moves the bar; None without one, or for short work."""
    shown = _shown.get()
    if shown is None or work < LEAST_WORK:
        return None
    display, task, together = shown
    if not together:
        display.reset(task, total=tasks)
    return lambda done: display.advance(task, done)
