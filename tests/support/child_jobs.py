"""Jobs of child processes that go wrong, and some that do not."""

import os
import sys
from pathlib import Path

from warpsample.bench.running.child import ChildJob


def elsewhere():
    """Needs a module whose package has another name."""
    raise ModuleNotFoundError(name="xrspatial")


def hopeless():
    """A job whose library is missing."""
    import no_such_library  # noqa: F401


def dying():
    """A job whose process ends."""
    os._exit(3)


def mortal():
    """A job that works once."""
    runs = []

    def work():
        runs.append(1)
        if len(runs) > 1:
            os._exit(4)

    return ChildJob(work, dict)


def loud():
    """A job that prints."""
    return ChildJob(lambda: sys.stdout.write("noise\n"), lambda: {"answer": 42})


def no_end(at_work):
    """A job that is never built."""
    Path(at_work).touch()
    while True:
        pass
