"""A job in a process of its own, run when it is told to, so that the threads and compilers of two libraries never meet.

The parent pickles what is to be built and then a word for each run; it reads pickled answers. The other side is `python -m`
this module.
"""

import os
import pickle
import subprocess
import sys
from collections.abc import Callable
from contextlib import suppress
from time import perf_counter
from typing import Any, NamedTuple

from warpsample.bench.running.timing import stopwatch

_PACKAGES = {"rvt": "rvt-py", "xrspatial": "xarray-spatial"}
"""What pip installs for modules of another name."""


class ChildJob(NamedTuple):
    """What a child runs.

    Attributes:
        work: what is timed.
        report: what it says of the last run.
        warm: what is run before it, untimed; by default `work`.
    """

    work: Callable[[], object]
    report: Callable[[], dict[str, Any]]
    warm: Callable[[], object] | None = None


class Child:
    """A child process that builds a job; a context that ends it."""

    def __init__(self, build: Callable[..., ChildJob], **arguments: Any):
        """Starts it, and does not wait; the child imports anew `build`, which makes the job of the arguments."""
        self._name = f"{build.__module__}:{build.__qualname__}"
        self._built: dict[str, Any] | None = None
        command = [sys.executable, "-m", "warpsample.bench.running.child"]
        environment = {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, sys.path))}
        pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "stderr": subprocess.DEVNULL}
        self.process = subprocess.Popen(command, env=environment, **pipes)
        self._tell(build, arguments)

    def __enter__(self) -> "Child":
        """Nothing: it has started."""
        return self

    def __exit__(self, error: type[BaseException] | None, *rest: object) -> None:
        """Ends the process: it reads to the end of its input, unless something is wrong, as an interrupt."""
        if error:
            self.process.kill()
        with suppress(OSError):
            self.process.communicate()

    def wait_until_built(self) -> str | None:
        """Waits until the child has built its job and run it once; why it could not in a line, or None."""
        if self._built is None:
            self._built = self._read()
        return self._built.get("failure")

    def first(self) -> float:
        """The seconds of the first run, for work that is too long to be repeated."""
        self.wait_until_built()
        return self._built["seconds"]

    def run(self) -> float:
        """Runs the job and says how many seconds it took.

        Raises:
            RuntimeError: there is no job, or its process has ended.
        """
        return self._ask("run")["seconds"]

    def report(self) -> dict[str, Any]:
        """The job's report of its last run."""
        return self._ask("report")

    def _ask(self, what: str) -> dict[str, Any]:
        if failure := self.wait_until_built():
            raise RuntimeError(failure)
        self._tell(what)
        answer = self._read()
        if "failure" in answer:
            raise RuntimeError(f"{self._name}: {answer['failure']}")
        return answer

    def _tell(self, *what: Any) -> None:
        with suppress(BrokenPipeError):  # then there is no answer either
            pickle.dump(what, self.process.stdin)
            self.process.stdin.flush()

    def _read(self) -> dict[str, Any]:
        try:
            return pickle.load(self.process.stdout)
        except EOFError:
            return {"failure": f"its process ended with status {self.process.wait()}"}


def _serve() -> None:
    told, answers = sys.stdin.buffer, os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # what libraries print is no answer

    def answer(content: dict[str, Any]) -> None:
        pickle.dump(content, answers)
        answers.flush()

    try:
        build, arguments = pickle.load(told)
        job = build(**arguments)
        start = perf_counter()
        job.work()
        seconds = perf_counter() - start
    except ModuleNotFoundError as error:
        package = (error.name or "").partition(".")[0]
        answer({"failure": f"not installed: pip install {_PACKAGES.get(package, package)}"})
        return
    except Exception as error:  # whatever a library does when it cannot work here is the answer
        answer({"failure": f"{type(error).__name__}: {error}".splitlines()[0]})
        return
    answer({"seconds": seconds})
    run = stopwatch(job.work, job.warm)
    with suppress(EOFError):
        while what := pickle.load(told):
            answer({"seconds": run()} if what == ("run",) else job.report())


if __name__ == "__main__":
    _serve()
