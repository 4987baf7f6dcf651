"""Tools in a process each, which take turns at one task."""

from collections.abc import Callable, Iterable
from contextlib import ExitStack
from dataclasses import dataclass
from typing import Any, NamedTuple

from warpsample.bench.running.child import Child, ChildJob
from warpsample.bench.running.timing import in_turns


class Tool(NamedTuple):
    """A tool at a task.

    Attributes:
        library: whose version is said, and what pip installs.
        make: makes what does the work, of arguments that all tools of a task share.
        threaded: whether it uses more than one thread.
    """

    library: str
    make: Callable[..., Any]
    threaded: bool = True


@dataclass(frozen=True)
class Turns:
    """What came of it, by tool: the seconds of each repeat, its job's report, or why it did not run."""

    seconds: dict[Any, list[float]]
    told: dict[Any, dict[str, Any]]
    failures: dict[Any, str]

    def of_all(self) -> dict[Any, list[float]]:
        """The seconds, of tools that are all ours.

        Raises:
            RuntimeError: one did not run.
        """
        for tool, failure in self.failures.items():
            raise RuntimeError(f"{tool}: {failure}")
        return self.seconds

    def rows(self, kind: type, figures: Callable[[str], dict[str, Any]], **case: Any) -> list[Any]:
        """A row of each tool, of the fields of the case and its own figures; those that did not run come first."""
        failed = [kind(tool=tool, failure=failure, **case) for tool, failure in self.failures.items()]
        return failed + [kind(tool=tool, **case, **{"seconds": t} | figures(tool)) for tool, t in self.seconds.items()]


def keeping_last(run: Callable[[], Any]) -> tuple[Callable[[], object], Callable[[], Any]]:
    """Work that keeps its last result, and what gives that."""
    last: list[Any] = []

    def work() -> None:
        last[:] = [run()]

    return work, lambda: last[0]


def take_turns(build: Callable[..., ChildJob], tools: Iterable[Any], repeats: int, **arguments: Any) -> Turns:
    """Builds each tool's job undisturbed, one after the other, and then runs all in turns.

    Args:
        build: (tool, **arguments) -> its job.
        tools: names, or what else tells them apart.
        repeats: timed runs of each after the first; of none the first is the timed one.
        **arguments: of `build`, but for the tool.
    """
    with ExitStack() as stack:
        children, failures = {}, {}
        for tool in tools:
            child = stack.enter_context(Child(build, tool=tool, **arguments))
            if failure := child.wait_until_built():
                failures[tool] = failure
            else:
                children[tool] = child
        runs = {tool: child.run if repeats else child.first for tool, child in children.items()}
        seconds = in_turns(runs, max(1, repeats))
        told = {tool: child.report() for tool, child in children.items()}
    return Turns(seconds, told, failures)
