"""Worker threads of the package, which are kept between calls and run parts of a call in parallel.

Each helper holds a lock while it works. The caller takes the locks of all helpers before it returns, and never gives them
back: a thread that comes later finds the lock taken and touches nothing.
"""

import os
import threading
from _thread import start_new_thread
from collections.abc import Callable, Sequence
from contextlib import suppress
from queue import SimpleQueue

_waiting: "SimpleQueue[_Helper]" = SimpleQueue()
_threads = 0


class _Helper:
    """Part of a call that waits in a queue for a free worker thread."""

    def __init__(self, part: Callable[[], None], stop: Callable[[], None]) -> None:
        self._part: Callable[[], None] | None = part
        self._stop = stop
        self._working = threading.RLock()  # the caller may take it twice
        self._process = os.getpid()
        self.error: BaseException | None = None

    def work(self) -> None:
        """Run this part of the call on a worker thread; an error is stored for the caller."""
        if not self._working.acquire(blocking=False):
            return
        try:
            if self._part:
                self._part()
        except BaseException as error:  # the caller raises it
            self.error = error
            self._stop()
        finally:
            self._working.release()

    def end(self) -> None:
        """Cancel this part if it has not started yet, else wait until it is complete."""
        if self._process != os.getpid():  # forked within the call, from a signal handler: the thread does not exist here
            self.error = RuntimeError(
                "this process was forked during a call, and lacks the threads of that call; call again"
            )
            return
        self._working.acquire()
        self._part = None  # it holds memory, and a thread may take this helper from the queue much later


def share(parts: Sequence[Callable[[], None]], stop: Callable[[], None]) -> None:
    """Run functions in parallel: the first in this thread, the rest on worker threads; return when all have ended.

    All threads have stopped when this function ends, also by the first error of a part. In the main thread, call it within
    `uninterrupted`. `stop` leaves no work to the parts, which all do the same work until none is left.
    """
    helpers = [_Helper(part, stop) for part in parts[1:]]
    try:
        try:
            _start_threads(len(helpers))
            for helper in helpers:
                _waiting.put(helper)
            parts[0]()
        finally:
            _end(helpers, stop)
    finally:
        _end(helpers, stop)  # again, if an exception that no signal raised (PyThreadState_SetAsyncExc) ended the first one
    for helper in helpers:
        if helper.error is not None:
            raise helper.error


def _end(helpers: list[_Helper], stop: Callable[[], None]) -> None:
    stop()
    for helper in helpers:
        helper.end()


def _start_threads(count: int) -> None:
    """Start worker threads until there are `count`, or the operating system refuses to start more."""
    global _threads  # noqa: PLW0603  (threads belong to the process)
    with suppress(RuntimeError):
        while _threads < count:
            start_new_thread(_serve, (_waiting,))
            _threads += 1


def _serve(waiting: "SimpleQueue[_Helper]") -> None:
    while True:
        waiting.get().work()


def _forget_threads() -> None:
    """Reset the list of threads in a forked child, where the parent's threads do not exist."""
    global _waiting, _threads
    _waiting, _threads = SimpleQueue(), 0


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_forget_threads)
