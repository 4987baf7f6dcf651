"""Timed comparison of tools: one process for each tool, with alternating runs of the same task."""

from collections.abc import Callable, Iterable
from contextlib import ExitStack
from dataclasses import dataclass
from typing import Any, NamedTuple

from warpsample.bench.running.child import Child, ChildJob
from warpsample.bench.running.timing import run_interleaved


class Tool(NamedTuple):
    """Tool that a benchmark compares: its library and the function that builds its work.

    Attributes:
        library: package that pip installs, whose version the tables show.
        make: function that builds the tool's work; all tools of a task take the same arguments.
        threaded: True if the tool uses more than one thread.
    """

    library: str
    make: Callable[..., Any]
    threaded: bool = True


@dataclass(frozen=True)
class ToolRuns:
    """Seconds, reports and failures of tools after a comparison, keyed by tool.

    Attributes:
        seconds: run time of each repeat.
        reports: report of each job on its last run.
        failures: reason for each tool that did not run.
    """

    seconds: dict[Any, list[float]]
    reports: dict[Any, dict[str, Any]]
    failures: dict[Any, str]

    def require_all(self) -> dict[Any, list[float]]:
        """Return the seconds of all tools; raise a RuntimeError if a tool did not run.

        Raises:
            RuntimeError: a case did not run.
        """
        for tool, failure in self.failures.items():
            raise RuntimeError(f"{tool}: {failure}")
        return self.seconds

    def rows(self, kind: type, figures: Callable[[str], dict[str, Any]], **case: Any) -> list[Any]:
        """Build a benchmark row for each tool, from the case and from `figures(tool)`.

        Rows of tools that did not run come first.
        """
        failed = [kind(tool=tool, failure=failure, **case) for tool, failure in self.failures.items()]
        return failed + [kind(tool=tool, **case, **{"seconds": t} | figures(tool)) for tool, t in self.seconds.items()]


def keep_last_result(run: Callable[[], Any]) -> tuple[Callable[[], object], Callable[[], Any]]:
    """Return a function that calls `run` and keeps the result, and a function that returns the last result."""
    last: list[Any] = []

    def work() -> None:
        last[:] = [run()]

    return work, lambda: last[0]


def run_tools(build: Callable[..., ChildJob], tools: Iterable[Any], repeats: int, **arguments: Any) -> ToolRuns:
    """Prepare each tool in its own process, one after the other, then time all tools in alternation.

    Args:
        build: function (tool, **arguments) -> job.
        tools: names of the tools, or other keys.
        repeats: timed runs of each tool after the first; 0 times the first run.
        **arguments: arguments of `build`, besides the tool.
    """
    with ExitStack() as stack:
        children, failures = {}, {}
        for tool in tools:
            child = stack.enter_context(Child(build, tool=tool, **arguments))
            if failure := child.wait_until_built():
                failures[tool] = failure
            else:
                children[tool] = child
        runs = {tool: child.run if repeats else child.get_first_seconds for tool, child in children.items()}
        seconds = run_interleaved(runs, max(1, repeats))
        reports = {tool: child.report() for tool, child in children.items()}
    return ToolRuns(seconds, reports, failures)
