"""Tools in a process each, which take turns at one task."""

import tempfile
from collections.abc import Callable, Iterable
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from warpsample.bench.running.child import Child, ChildJob, Failure
from warpsample.bench.running.timing import interleave


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
    """What came of it.

    Attributes:
        seconds: of each repeat, by tool.
        told: its job's report, by tool.
        failures: why a tool did not run, by tool.
    """

    seconds: dict[str, list[float]]
    told: dict[str, dict[str, Any]]
    failures: dict[str, str]

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


def take_turns(build: Callable[..., ChildJob], tools: Iterable[str], repeats: int, **arguments: Any) -> Turns:
    """Builds each tool's job undisturbed, one after the other, and then runs all in turns.

    Args:
        build: (tool, **arguments) -> its job.
        tools: names.
        repeats: timed runs of each.
        **arguments: of `build`, but for the tool; of an array it gets the path of an .npy file.
    """
    with ExitStack() as stack:
        folder = Path(stack.enter_context(tempfile.TemporaryDirectory()))
        given = {name: _saved(value, folder / f"{name}.npy") for name, value in arguments.items()}
        children: dict[str, Child] = {}
        failures: dict[str, str] = {}
        for tool in tools:
            child = stack.enter_context(Child(build, tool=tool, **given))
            if failure := child.wait_until_built():
                failures[tool] = remedy(failure)
            else:
                children[tool] = child
        times, _ = interleave([child.run for child in children.values()], repeats)
        told = {tool: child.report() for tool, child in children.items()}
    return Turns(dict(zip(children, times, strict=True)), told, failures)


def remedy(failure: Failure) -> str:
    """Why there is no job, and what to install if that is why."""
    return f"not installed: pip install {failure.missing}" if failure.missing else failure.reason


def _saved(value: Any, path: Path) -> Any:
    if not isinstance(value, np.ndarray):
        return value
    np.save(path, value, allow_pickle=False)
    return str(path)
