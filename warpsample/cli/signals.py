"""Signals: Ctrl-C, SIGTERM, SIGHUP and SIGQUIT end a command like an exception, so that everything is cleaned up.

Python handles a signal between two of its own steps. A call of a compiler or of VTK is one step, which ends first.
"""

import signal
import sys
import threading
import weakref
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from warpsample.cli.streams import print_error, show_cursor

SIGNALS = tuple(getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP", "SIGQUIT") if hasattr(signal, name))


class Ended(KeyboardInterrupt):
    """Exception that ends a command after a signal like SIGTERM or Ctrl-C."""


class _State:
    """State of signal handling: first signal, last exception raised, and whether a message was printed."""

    number: int | None = None
    rising: "weakref.ref[Ended] | None" = None
    reported = False


@contextmanager
def listening() -> Iterator[None]:
    """Convert signals like SIGTERM to the exception `Ended` within a `with` statement, so that files are cleaned up.

    The command ends with a sentence on stderr and exit status 128 + the signal's number.

    A KeyboardInterrupt without a signal ends like SIGINT. Signals that the parent ignores, as nohup does, stay ignored.
    """
    usual = (signal.SIG_DFL, signal.default_int_handler)
    is_main = threading.current_thread() is threading.main_thread()
    before = {number: signal.getsignal(number) for number in SIGNALS if is_main and signal.getsignal(number) in usual}
    _written().clear()
    try:
        for number in before:
            signal.signal(number, _hear)
        yield
    except BaseException as error:
        if _State.reported or not (heard() or isinstance(error, KeyboardInterrupt)):
            raise
        raise SystemExit(_report(error)) from None
    finally:
        if before:
            _State.reported = True  # later signals are ignored
            _raise_again_after(0.0)
            for number, handler in before.items():  # everything is cleaned up, so a further one may end the process at once
                signal.signal(number, signal.SIG_DFL if heard() else handler)
            _State.number, _State.rising, _State.reported = None, None, False


@contextmanager
def at_once() -> Iterator[None]:
    """Restore the default handling of signals within a `with` statement: a signal ends the process at once."""
    ours = [number for number in SIGNALS if signal.getsignal(number) is _hear]
    try:
        for number in ours:
            signal.signal(number, signal.SIG_DFL)
        yield
    finally:
        for number in ours:
            signal.signal(number, _hear)


def heard() -> bool:
    """Return whether the process has received a signal that ends it."""
    return _State.number is not None


def _written() -> list[Path]:
    """Return a list with the output file that was completed last; importing the module takes too long for a first step."""
    return getattr(sys.modules.get("warpsample.host.files"), "written", [])


def _report(error: BaseException) -> int:
    """Print why a signal ended the command, and return the exit status, 128 + the signal's number."""
    _State.reported = True
    show_cursor()
    number = _State.number or signal.SIGINT
    by = "" if number == signal.SIGINT else f" by {signal.Signals(number).name}"
    what = _written()[0] if _written() else "nothing"
    print_error((isinstance(error, KeyboardInterrupt) and str(error)) or f"interrupted{by}; {what} was written")
    return 128 + number


def _hear(number: int, _: object) -> None:
    """Handle a signal: raise `Ended`, unless an earlier `Ended` is still propagating.

    If Python drops the exception, as in the callback of a weak reference, it is raised again a little later.
    """
    if _State.reported or (_State.rising is not None and _State.rising() is not None):
        return
    _State.number = _State.number or number
    _raise_again_after(0.3)
    ended = Ended()
    _State.rising = weakref.ref(ended)
    try:
        raise ended
    finally:
        del ended  # its own traceback would keep it alive


def _raise_again_after(seconds: float) -> None:
    """Schedule another raise of `Ended` after some seconds, in case Python drops the exception; 0 cancels it."""
    if hasattr(signal, "setitimer") and (seconds or heard()):
        signal.signal(signal.SIGALRM, _hear if seconds else signal.SIG_DFL)
        signal.setitimer(signal.ITIMER_REAL, seconds, seconds)
