"""Work that no interrupt tears apart: what a signal's handler raises meanwhile is raised when the work is done.

Python calls the handlers of signals in the main thread, between any two of its steps. An exception that one of them raises
there, as Ctrl-C does, would leave a lock taken, a kernel half-registered, or threads that still write into arrays that are
no longer kept.
"""

import _signal  # the functions behind `signal`, which spends a hundred times as long on names of signals
import signal
import sys
import threading
from collections.abc import Callable
from contextlib import ContextDecorator
from functools import partial, wraps
from traceback import walk_tb
from types import CodeType, FrameType
from typing import Any, ParamSpec, TypeVar

T = TypeVar("T")
P = ParamSpec("P")


class handlers_first(ContextDecorator):  # noqa: N801  (a class, as each small call pays for a generator)
    """Raises what a signal's handler has raised, where an error was made of that within, such as one that names a file.

    A handler raises anything, most often a deadline's TimeoutError, which is an OSError but says nothing of a file.
    """

    def __enter__(self) -> None:
        """Keeps what is being handled already."""
        self._before = handled()

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, _: object) -> None:
        """Raises the handler's own error, if it led to this one."""
        own = raised_by_a_handler(error, self._before) if isinstance(error, Exception) else None
        if own is not None and own is not error:
            raise own from own.__cause__

    def _recreate_cm(self) -> "handlers_first":
        """One of its own for each call of a function that is decorated."""
        return handlers_first()


def handled() -> BaseException | None:
    """What is being handled here: a call may be made while an interrupt is, which is then none of its own."""
    return sys.exc_info()[1]


def raised_by_a_handler(error: BaseException, before: BaseException | None) -> BaseException | None:
    """What a signal's handler has raised, of an error and those that led to it; None if it is something else's.

    Args:
        error: what was raised.
        before: what was being handled before the work began, and did not lead to the error.
    """
    codes = {_code_of(_signal.getsignal(n)) for n in range(1, signal.NSIG)} - {None}
    cause: BaseException | None = error
    while cause is not None and cause is not before:
        if isinstance(cause, KeyboardInterrupt) or any(frame.f_code in codes for frame, _ in walk_tb(cause.__traceback__)):
            return cause
        cause = cause.__context__ if cause.__cause__ is None else cause.__cause__
    return None


def _code_of(handler: Any) -> CodeType | None:
    """What Python runs for a handler: a function, a method, a partial of one, or an instance that can be called."""
    if not callable(handler):
        return None
    handler = handler.func if isinstance(handler, partial) else handler
    return getattr(handler, "__code__", None) or getattr(type(handler).__call__, "__code__", None)


def to_its_end(work: Callable[P, T]) -> Callable[P, T]:
    """Decorates a function that Python itself, or the system, is done with soon: it runs as `uninterrupted` runs work."""

    @wraps(work)
    def run(*arguments: P.args, **named: P.kwargs) -> T:
        return uninterrupted(partial(work, *arguments, **named))

    return run


def uninterrupted(work: Callable[[], T], stop: Callable[[], None] | None = None) -> T:
    """Runs work to its end. Handlers of signals are called at once, as ever, but what they raise is raised afterwards.

    Args:
        work: what other threads than the main one never hear an interrupt in anyway.
        stop: called when there is something to be raised, so that the work may end early; from a handler.
    """
    if threading.get_ident() != threading.main_thread().ident:
        return work()
    handlers = _Handlers(stop)
    try:
        return handlers.run(work)
    finally:
        if handlers.raised is not None:  # which may count as False, as a list of problems does
            raise handlers.raised


class _Handlers:
    """The user's handlers, and in place of them one that calls them, and keeps what they raise while `run` is on the stack.

    Attributes:
        raised: what was kept, the first of it.
    """

    def __init__(self, stop: Callable[[], None] | None) -> None:
        """Replaces nothing yet."""
        self._stop = stop
        self._users = {n: handler for n in range(1, signal.NSIG) if callable(handler := _signal.getsignal(n))}
        self.raised: BaseException | None = None

    def run(self, work: Callable[[], T]) -> T:
        """Runs work; the frame that `_hear` looks for."""
        try:
            for number in self._users:
                _signal.signal(number, self._hear)
            return work()
        finally:
            self._put_back(list(self._users))

    def _put_back(self, numbers: list[int]) -> None:
        """Gives signals back, but for those that a handler has given to another one; the first may interrupt the others."""
        while numbers:
            try:
                while numbers:
                    if _signal.getsignal(numbers[-1]) == self._hear:
                        _signal.signal(numbers[-1], self._users[numbers[-1]])
                    numbers.pop()
            except BaseException as error:  # noqa: PERF203
                self._keep(error)

    def _hear(self, number: int, frame: FrameType | None) -> None:
        try:
            self._users[number](number, frame)
        except BaseException as error:
            if not self._runs(frame):  # an interrupt has left this handler behind
                raise
            self._keep(error)

    def _keep(self, error: BaseException) -> None:
        self.raised = error if self.raised is None else self.raised
        if self._stop:
            self._stop()

    def _runs(self, frame: FrameType | None) -> bool:
        while frame is not None:
            if frame.f_code is _Handlers.run.__code__ and frame.f_locals["self"] is self:
                return True
            frame = frame.f_back
        return False
