"""Deferral of signals: an exception that a signal handler raises waits until a piece of work is complete.

Python calls signal handlers in the main thread, between any two of its steps. An exception raised there, as by Ctrl-C,
would leave a lock taken, a kernel half-registered, or threads that write into arrays that are no longer kept.
"""

import _signal  # the functions behind `signal`, which spends a hundred times as long on names of signals
import signal
import threading
from collections.abc import Callable
from types import FrameType
from typing import Any, TypeVar

T = TypeVar("T")


def uninterrupted(work: Callable[[], T], stop: Callable[[], None] | None = None) -> T:
    """Call `work` and return its result; exceptions of signal handlers (Ctrl-C) are raised only afterwards.

    Handlers are called at once, as usual, and in the main thread only. A handler that raises nothing changes nothing. `stop`
    is called when a handler has raised an exception, so that `work` can end early.
    """
    if threading.get_ident() != threading.main_thread().ident:
        return work()
    usual = range(1, min(signal.NSIG, 32))  # without real-time signals, to halve the time of this search: 2 us
    users: dict[int, Any] = {n: handler for n in usual if callable(handler := _signal.getsignal(n))}
    raised: list[BaseException] = []
    deferring = True

    def defer(number: int, frame: FrameType | None) -> None:
        try:
            users[number](number, frame)
        except BaseException as error:
            if not deferring:
                raise
            raised.append(error)
            if stop:
                stop()

    try:
        for number in users:
            _signal.signal(number, defer)
        return work()
    finally:
        deferring = False  # first: if a handler raises in the loop, a signal that is not yet given back raises as usual
        for number, handler in users.items():
            if _signal.getsignal(number) is defer:  # else a handler has set another one
                _signal.signal(number, handler)
        if raised:
            raise raised.pop(0)  # which leaves no cycle of the exception and this frame
