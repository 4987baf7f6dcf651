"""A job in a process of its own, run when it is told to, so that the threads and compilers of two libraries never meet.

The parent writes a line for each run and reads one with its seconds; the other side is `python -m` this module.
"""

import importlib
import json
import os
import subprocess
import sys
from collections.abc import Callable
from contextlib import suppress
from typing import Any, NamedTuple

from warpsample.bench.running.timing import stopwatch


class ChildJob(NamedTuple):
    """What a child runs.

    Attributes:
        work: what is timed.
        report: what it says of the last run: anything that JSON holds.
        warm: what is run before it, untimed; by default `work`.
    """

    work: Callable[[], object]
    report: Callable[[], dict[str, Any]]
    warm: Callable[[], object] | None = None


class Failure(NamedTuple):
    """Why a child has no job, in a line; and the module that is not installed, if that is why."""

    reason: str
    missing: str | None = None


class Child:
    """A child process that builds a job; a context that ends it."""

    def __init__(self, build: Callable[..., ChildJob], **arguments: Any):
        """Starts it, and does not wait; the child imports anew `build`, which makes the job of arguments that JSON holds."""
        self._name = f"{build.__module__}:{build.__qualname__}"
        self._ready: Failure | bool | None = None
        command = [sys.executable, "-m", "warpsample.bench.running.child", self._name, json.dumps(arguments)]
        environment = {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, sys.path))}
        self.process = subprocess.Popen(
            command, env=environment, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True
        )

    def __enter__(self) -> "Child":
        """Nothing: it has started."""
        return self

    def __exit__(self, error: type[BaseException] | None, *rest: object) -> None:
        """Ends the process: it reads to the end of its input, unless something is wrong, as an interrupt."""
        if error:
            self.process.kill()
        with suppress(OSError):
            self.process.communicate()

    def wait_until_built(self) -> Failure | None:
        """Waits until the child has built its job and run it once; why it could not, or None."""
        if self._ready is None:
            answer = self._read()
            self._ready = Failure(answer["failure"], answer.get("missing")) if "failure" in answer else True
        return self._ready if isinstance(self._ready, Failure) else None

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
            raise RuntimeError(failure.reason)
        with suppress(BrokenPipeError):  # then there is no answer either
            print(what, file=self.process.stdin, flush=True)
        answer = self._read()
        if "failure" in answer:
            raise RuntimeError(f"{self._name}: {answer['failure']}")
        return answer

    def _read(self) -> dict[str, Any]:
        line = self.process.stdout.readline() if self.process.stdout else ""
        return json.loads(line) if line else {"failure": f"its process ended with status {self.process.wait()}"}


def _serve(name: str, arguments: dict[str, Any]) -> None:
    answers = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)  # what libraries print is no answer

    def answer(content: dict[str, Any]) -> None:
        print(json.dumps(content), file=answers, flush=True)

    module, function = name.split(":")
    try:
        job = getattr(importlib.import_module(module), function)(**arguments)
        job.work()
    except Exception as error:  # whatever a library does when it cannot work here is the answer
        missing = error.name if isinstance(error, ModuleNotFoundError) else None
        answer({"failure": f"{type(error).__name__}: {error}".splitlines()[0], "missing": missing})
        return
    answer({})
    run = stopwatch(job.work, job.warm)
    for line in sys.stdin:
        answer({"seconds": run()} if line == "run\n" else job.report())


if __name__ == "__main__":
    _serve(sys.argv[1], json.loads(sys.argv[2]))
