"""Tools in a process each, which take turns at one task."""

from collections.abc import Callable, Iterable
from contextlib import ExitStack
from dataclasses import dataclass
from typing import Any

from warpsample.bench.child import Child, Job
from warpsample.bench.timing import interleave


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


def take_turns(build: Callable[..., Job], tools: Iterable[str], repeats: int, **arguments: Any) -> Turns:
    """Builds each tool's job undisturbed, one after the other, and then runs all in turns.

    Args:
        build: (tool, **arguments) -> its job.
        tools: names.
        repeats: timed runs of each.
        **arguments: of `build`, but for the tool.
    """
    with ExitStack() as stack:
        children: dict[str, Child] = {}
        failures: dict[str, str] = {}
        for tool in tools:
            child = stack.enter_context(Child(build, tool=tool, **arguments))
            failure = child.wait_until_built()
            if failure:
                failures[tool] = f"not installed: {failure.missing}" if failure.missing else failure.reason
            else:
                children[tool] = child
        times, _ = interleave([child.run for child in children.values()], repeats)
        told = {tool: child.report() for tool, child in children.items()}
    return Turns(dict(zip(children, times, strict=True)), told, failures)
