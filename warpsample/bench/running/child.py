"""Work in a separate process that runs on request, so that threads and compilers of two libraries never share one.

The parent sends a pickled build function, then one pickled word for each run; the child answers with pickled dicts.
The child process is `python -m` this module.
"""

import os
import pickle
import subprocess
import sys
from collections.abc import Callable
from contextlib import suppress
from time import perf_counter
from typing import Any, NamedTuple

from warpsample.bench.running.timing import build_stopwatch

_PACKAGES = {"rvt": "rvt-py", "xrspatial": "xarray-spatial"}
"""Package names that differ from the module name, for the hint how to install."""


class ChildJob(NamedTuple):
    """Work of a child process: the function to time, and its report.

    Attributes:
        work: function to time.
        report: function that returns facts about the last run.
        warm: untimed function that runs before `work`; default: `work`.
    """

    work: Callable[[], object]
    report: Callable[[], dict[str, Any]]
    warm: Callable[[], object] | None = None


class Child:
    """Child process that prepares work and runs it on request; a context manager that ends the process."""

    def __init__(self, build: Callable[..., ChildJob], **arguments: Any):
        """Start the child process without waiting; the process imports `build` and calls it with the arguments."""
        self._name = f"{build.__module__}:{build.__qualname__}"
        self._built: dict[str, Any] | None = None
        command = [sys.executable, "-m", "warpsample.bench.running.child"]
        environment = {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, sys.path))}
        pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "stderr": subprocess.DEVNULL}
        self.process = subprocess.Popen(command, env=environment, **pipes)
        self._send(build, arguments)

    def __enter__(self) -> "Child":
        """Return this object, whose child process runs since construction."""
        return self

    def __exit__(self, error: type[BaseException] | None, *rest: object) -> None:
        """End the child process: close its input and wait, or kill it after an error or an interrupt."""
        if error:
            self.process.kill()
        with suppress(OSError):
            self.process.communicate()

    def wait_until_built(self) -> str | None:
        """Wait until the child process is prepared and has run its work once; return None, or one line with the failure."""
        if self._built is None:
            self._built = self._read()
        return self._built.get("failure")

    def get_first_seconds(self) -> float:
        """Return the seconds of the child's first run, for work that takes too long to repeat."""
        self.wait_until_built()
        return self._built["seconds"]

    def run(self) -> float:
        """Run the child's work once, and return the seconds it takes.

        Raises:
            RuntimeError: the child has no job, or its process has ended.
        """
        return self._request("run")["seconds"]

    def report(self) -> dict[str, Any]:
        """Return the report of the child's work on its last run."""
        return self._request("report")

    def _request(self, request: str) -> dict[str, Any]:
        if failure := self.wait_until_built():
            raise RuntimeError(failure)
        self._send(request)
        answer = self._read()
        if "failure" in answer:
            raise RuntimeError(f"{self._name}: {answer['failure']}")
        return answer

    def _send(self, *request: Any) -> None:
        with suppress(BrokenPipeError):  # the child has ended, so there is no answer
            pickle.dump(request, self.process.stdin)
            self.process.stdin.flush()

    def _read(self) -> dict[str, Any]:
        try:
            return pickle.load(self.process.stdout)
        except EOFError:
            return {"failure": f"its process ended with status {self.process.wait()}"}


def _serve() -> None:
    requests, answers = sys.stdin.buffer, os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # keeps output of libraries out of the answers

    def answer(content: dict[str, Any]) -> None:
        pickle.dump(content, answers)
        answers.flush()

    try:
        build, arguments = pickle.load(requests)
        job = build(**arguments)
        start = perf_counter()
        job.work()
        seconds = perf_counter() - start
    except ModuleNotFoundError as error:
        package = (error.name or "").partition(".")[0]
        answer({"failure": f"not installed: pip install {_PACKAGES.get(package, package)}"})
        return
    except Exception as error:  # the reason why a library does not work here is the answer
        answer({"failure": f"{type(error).__name__}: {error}".splitlines()[0]})
        return
    answer({"seconds": seconds})
    run = build_stopwatch(job.work, job.warm)
    with suppress(EOFError):
        while request := pickle.load(requests):
            answer({"seconds": run()} if request == ("run",) else job.report())


if __name__ == "__main__":
    _serve()
