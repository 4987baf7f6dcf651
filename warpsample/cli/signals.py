"""Ended from outside: Ctrl-C, SIGTERM, SIGHUP and SIGQUIT end a command as an exception does, so that all is cleaned up.

Python hears a signal between two of its own steps. A compiler or VTK at work is one step: it is over first.
"""

import os
import signal
import sys
import threading
import weakref
from collections.abc import Iterator
from contextlib import contextmanager, suppress

TYPE_CHECKING = False  # that of `typing` takes 10 ms, in which no signal is heard
if TYPE_CHECKING:
    from typing import TextIO

SIGNALS = tuple(getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP", "SIGQUIT") if hasattr(signal, name))

_AGAIN = 0.3  # seconds


class Ended(KeyboardInterrupt):
    """A signal, on its way up."""

    def __init__(self, number: int):
        """Without words: `told` has them."""
        super().__init__()
        self.number = number


class _State:
    """Of this process: the first signal heard, the last exception made of it, and whether the user knows."""

    number: int | None = None
    rising: "weakref.ref[Ended] | None" = None
    told = False


@contextmanager
def listening() -> Iterator[None]:
    """Within, the signals raise `Ended` in the main thread; it ends in a sentence and exit status 128 + the signal's number.

    A KeyboardInterrupt that no signal has raised ends as SIGINT does. Signals that the parent ignores, as nohup does, stay
    ignored. May be nested.
    """
    usual = (signal.SIG_DFL, signal.default_int_handler)
    here = threading.current_thread() is threading.main_thread()
    before = {number: signal.getsignal(number) for number in SIGNALS if here and signal.getsignal(number) in usual}
    try:
        for number in before:
            signal.signal(number, _hear)
        yield
    except BaseException as error:
        if _State.told or not (heard() or isinstance(error, KeyboardInterrupt)):
            raise
        raise SystemExit(_tell(error)) from None
    finally:
        if before:
            _State.told = True  # what comes now comes too late
            _raise_again_after(0.0)
            for number, handler in before.items():  # all is cleaned up, so that a further one may end it at once
                signal.signal(number, signal.SIG_DFL if heard() else handler)
            _State.number, _State.rising, _State.told = None, None, False


@contextmanager
def at_once() -> Iterator[None]:
    """Within, a signal ends the process by itself: an open window runs no Python that could hear one, and writes nothing."""
    ours = [number for number in SIGNALS if signal.getsignal(number) is _hear]
    try:
        for number in ours:
            signal.signal(number, signal.SIG_DFL)
        yield
    finally:
        for number in ours:
            signal.signal(number, _hear)


def heard() -> bool:
    """Whether the command is being ended by a signal."""
    return _State.number is not None


def say(sentence: str) -> None:
    """A line on stderr, unless nobody is there any more."""
    try:
        print(sentence, file=sys.stderr, flush=True)  # noqa: T201
    except OSError:
        forget(sys.stderr)


def forget(stream: "TextIO") -> None:
    """Sends nowhere what is still to come, and what Python writes when it ends."""
    with suppress(OSError, ValueError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())


def _tell(error: BaseException) -> int:
    """Says that the command was ended, in the words of a KeyboardInterrupt if it has any; the exit status."""
    _State.told = True
    _show_cursor()
    number = _State.number or signal.SIGINT
    by = "" if number == signal.SIGINT else f" by {signal.Signals(number).name}"
    say((isinstance(error, KeyboardInterrupt) and str(error)) or f"interrupted{by}; nothing was written")
    return 128 + number


def _show_cursor() -> None:
    """Rich does, unless it is interrupted while it starts a bar."""
    terminal = sys.__stderr__
    if terminal is not None and terminal.isatty() and os.environ.get("TERM", "dumb") != "dumb":
        with suppress(OSError):
            print("\x1b[?25h", end="", file=terminal, flush=True)


def _hear(number: int, _: object) -> None:
    """Raises `Ended`, but not while one is on its way, since what cleans up must not be interrupted.

    One that is raised where Python drops exceptions, as in a weak reference's callback, is raised again a little later.
    """
    if _State.told or (_State.rising is not None and _State.rising() is not None):
        return
    _State.number = _State.number or number
    _raise_again_after(_AGAIN)
    ended = Ended(_State.number)
    _State.rising = weakref.ref(ended)
    try:
        raise ended
    finally:
        del ended  # which its own traceback would keep alive


def _raise_again_after(seconds: float) -> None:
    """Lets `_hear` look whether the exception has been dropped; not after 0 seconds."""
    if hasattr(signal, "setitimer") and (seconds or heard()):
        signal.signal(signal.SIGALRM, _hear if seconds else signal.SIG_DFL)
        signal.setitimer(signal.ITIMER_REAL, seconds, seconds)
