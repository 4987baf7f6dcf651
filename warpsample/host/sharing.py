"""Threads that are kept, and help with a call: none of them is at work on it when it ends, however it ends.

Each helper holds a lock of its own while it works. The caller takes all of these locks before it leaves, and never gives
them back: then no helper is at work, and one that comes later finds its lock taken and touches nothing. Taking them again
does no harm, so that it can be done until it was done without an interrupt.
"""

import os
import threading
from _thread import start_new_thread
from collections.abc import Callable, Sequence
from contextlib import suppress
from functools import partial
from queue import SimpleQueue
from typing import Generic, TypeVar

from warpsample.host.interrupts import uninterrupted

T = TypeVar("T")

_asked: "SimpleQueue[_Helper]" = SimpleQueue()
_threads = 0


class _Helper:
    """A part of a call for whichever thread has time for it, unless the call has ended before."""

    def __init__(self, part: Callable[[], None], stop: Callable[[], None]) -> None:
        self._part: Callable[[], None] | None = part
        self._stop = stop
        self._held = threading.RLock()
        self._process = os.getpid()
        self.error: BaseException | None = None

    def work(self) -> None:
        """Does the part, in a thread of ours."""
        if not self._held.acquire(blocking=False):
            return
        try:
            if self._part:
                self._part()
        except BaseException as error:  # the caller raises it
            self.error = error
            self._stop()
        finally:
            self._held.release()

    def end(self) -> None:
        """Waits until nobody works on it and lets nobody begin: in the caller's thread, as often as it likes."""
        if self._process != os.getpid():  # forked within the call, from a signal's handler: its thread does not exist here
            self.error = RuntimeError("this process was forked within a call, and has none of its threads: call again")
            return
        self._held.acquire()
        self._part = None  # it holds memory, and may wait for a thread for long


def share(parts: Sequence[Callable[[], None]], stop: Callable[[], None]) -> None:
    """Does parts of a call at once: the first in this thread, which needs no waking, each other one if a thread is free.

    The parts all do the same work, until none is left; `stop` leaves none. An interrupt, or an error of any part, which is
    raised, ends the call early, but not before all threads have stopped.
    """
    helpers = [_Helper(part, stop) for part in parts[1:]]
    try:
        uninterrupted(partial(_work, parts[0], helpers, stop), stop)
    finally:
        _end(helpers, stop)  # again, if the first one was broken off by an exception that no signal has raised
    for helper in helpers:
        if helper.error is not None:
            raise helper.error


def _work(own: Callable[[], None], helpers: list[_Helper], stop: Callable[[], None]) -> None:
    try:
        _ask(helpers)
        own()
    finally:
        _end(helpers, stop)


def _end(helpers: list[_Helper], stop: Callable[[], None]) -> None:
    stop()
    for helper in helpers:
        helper.end()


def _ask(helpers: list[_Helper]) -> None:
    """Asks as many threads; starts those that there are not yet, or as many of them as the system gives."""
    global _threads  # noqa: PLW0603  (threads belong to the process)
    with suppress(RuntimeError):  # no more threads are available, or Python is ending: fewer threads share the work
        while _threads < len(helpers):
            start_new_thread(_serve, (_asked,))
            _threads += 1
    for helper in helpers:
        _asked.put(helper)


def _serve(asked: "SimpleQueue[_Helper]") -> None:
    while True:
        asked.get().work()


class InOrder(Generic[T]):
    """Results that threads put as they make them; a function takes them in the order of their numbers, one at a time."""

    def __init__(self, take: Callable[[T], None]) -> None:
        self._take = take
        self._next = 0
        self._early: dict[int, T] = {}
        self._taking = threading.Lock()

    def put(self, number: int, result: T) -> None:
        """Hands over a result, and those after it that have waited for it; numbers count from 0."""
        with self._taking:
            self._early[number] = result
            while self._next in self._early:
                self._take(self._early.pop(self._next))
                self._next += 1


def _forget_threads() -> None:
    """In a forked child the parent's threads do not exist."""
    global _asked, _threads
    _asked, _threads = SimpleQueue(), 0


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_forget_threads)
