"""Signals: Ctrl-C, SIGTERM, SIGHUP and SIGQUIT end a command like an exception, so that everything is cleaned up.

Python handles a signal between two of its own steps. A call of a compiler or of VTK is one step, which ends first.
"""

import os
import signal
import sys
import threading
import weakref
from collections.abc import Iterator
from contextlib import contextmanager, suppress

TYPE_CHECKING = False  # importing it from `typing` takes 10 ms, without signal handling
if TYPE_CHECKING:
    from typing import TextIO

SIGNALS = tuple(getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP", "SIGQUIT") if hasattr(signal, name))

_AGAIN = 0.3  # seconds


class Ended(KeyboardInterrupt):
    """A signal, as an exception."""

    def __init__(self, number: int):
        """Without a message: `_tell` prints it."""
        super().__init__()
        self.number = number


class _State:
    """State of this process: the first signal, the last exception raised for it, and whether the user was told."""

    number: int | None = None
    rising: "weakref.ref[Ended] | None" = None
    told = False


@contextmanager
def listening() -> Iterator[None]:
    """Within, signals raise `Ended` in the main thread: a sentence on stderr and exit status 128 + the signal's number.

    A KeyboardInterrupt without a signal ends like SIGINT. Signals that the parent ignores, as nohup does, stay ignored. May
    be nested.
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
            _State.told = True  # later signals are ignored
            _raise_again_after(0.0)
            for number, handler in before.items():  # everything is cleaned up, so a further one may end the process at once
                signal.signal(number, signal.SIG_DFL if heard() else handler)
            _State.number, _State.rising, _State.told = None, None, False


@contextmanager
def at_once() -> Iterator[None]:
    """Within, a signal ends the process at once: an open window runs no Python that could handle it, and writes nothing."""
    ours = [number for number in SIGNALS if signal.getsignal(number) is _hear]
    try:
        for number in ours:
            signal.signal(number, signal.SIG_DFL)
        yield
    finally:
        for number in ours:
            signal.signal(number, _hear)


def heard() -> bool:
    """Whether a signal is ending the command."""
    return _State.number is not None


def say(sentence: str) -> None:
    """Prints a line on stderr, unless it is closed."""
    try:
        print(sentence, file=sys.stderr, flush=True)
    except OSError:
        forget(sys.stderr)


def forget(stream: "TextIO") -> None:
    """Discards all further output of a stream, including what Python writes when it ends."""
    with suppress(OSError, ValueError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())


def _tell(error: BaseException) -> int:
    """Reports the end of the command, in the words of a KeyboardInterrupt if it has any; returns the exit status."""
    _State.told = True
    _show_cursor()
    number = _State.number or signal.SIGINT
    by = "" if number == signal.SIGINT else f" by {signal.Signals(number).name}"
    say((isinstance(error, KeyboardInterrupt) and str(error)) or f"interrupted{by}; nothing was written")
    return 128 + number


def _show_cursor() -> None:
    """Shows the cursor, which rich hides for good if it is interrupted while it starts a bar."""
    terminal = sys.__stderr__
    if terminal is not None and terminal.isatty() and os.environ.get("TERM", "dumb") != "dumb":
        with suppress(OSError):
            print("\x1b[?25h", end="", file=terminal, flush=True)


def _hear(number: int, _: object) -> None:
    """Raises `Ended`, but not while one is propagating, since the cleaning up must not be interrupted.

    If Python drops the exception, as in the callback of a weak reference, it is raised again a little later.
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
        del ended  # its own traceback would keep it alive


def _raise_again_after(seconds: float) -> None:
    """Calls `_hear` after so many seconds, in case the exception has been dropped; 0 cancels it."""
    if hasattr(signal, "setitimer") and (seconds or heard()):
        signal.signal(signal.SIGALRM, _hear if seconds else signal.SIG_DFL)
        signal.setitimer(signal.ITIMER_REAL, seconds, seconds)
