"""A job in a process of its own, run when it is told to, so that the threads and compilers of two libraries never meet.

The parent writes a line for each run and reads one with its seconds; `python -m warpsample.bench.child` is the other side.
"""

import importlib
import json
import os
import subprocess
import sys
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from warpsample.bench.timing import stopwatch


@dataclass(frozen=True)
class Job:
    """What a child runs.

    Attributes:
        work: what is timed.
        report: what it says of the last run: anything that JSON holds.
        warm: what is run before it, untimed; by default `work`.
    """

    work: Callable[[], object]
    report: Callable[[], dict[str, Any]]
    warm: Callable[[], object] | None = None


class Child:
    """A child process with a job; a context that ends it."""

    def __init__(self, builder: str, **arguments: Any):
        """`builder`: "module:function" that makes a `Job` of the arguments, which JSON must hold."""
        command = [sys.executable, "-m", "warpsample.bench.child", builder, json.dumps(arguments)]
        self._process = subprocess.Popen(
            command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True
        )

    def __enter__(self) -> "Child":
        """Nothing: it has started."""
        return self

    def __exit__(self, error: type[BaseException] | None, *rest: object) -> None:
        """Ends the process: it reads to the end of its input, unless something is wrong, as an interrupt."""
        if error:
            self._process.kill()
        with suppress(OSError):
            self._process.communicate()

    @cached_property
    def failure(self) -> str | None:
        """Why there is no job, in a line; None if there is one. Waits until that is known."""
        return self._start.get("failure")

    @cached_property
    def missing(self) -> str | None:
        """The module that is not installed, if that is why."""
        return self._start.get("missing")

    @cached_property
    def _start(self) -> dict[str, Any]:
        return self._read()

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
        if self.failure is not None:
            raise RuntimeError(self.failure)
        with suppress(BrokenPipeError):  # then there is no answer either
            print(what, file=self._process.stdin, flush=True)
        answer = self._read()
        if "failure" in answer:
            raise RuntimeError(f"{self._process.args[-2]}: {answer['failure']}")
        return answer

    def _read(self) -> dict[str, Any]:
        line = self._process.stdout.readline() if self._process.stdout else ""
        return json.loads(line) if line else {"failure": f"its process ended with status {self._process.wait()}"}


def _serve(builder: str, arguments: dict[str, Any]) -> None:
    answers = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)  # what libraries print is no answer

    def answer(content: dict[str, Any]) -> None:
        print(json.dumps(content), file=answers, flush=True)

    module, function = builder.split(":")
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
