"""Tasks of `warpsample verify` (samplers, sequences, meshes and rays to test), run in a pool of processes."""

import multiprocessing
import os
import signal
from collections.abc import Iterable, Iterator
from concurrent.futures import ProcessPoolExecutor, as_completed
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

from warpsample import distributions, sequences
from warpsample.distributions.record import Distribution
from warpsample.host.registry import look_up
from warpsample.proof import defects, mixing, rays, routes, streams, stress, verify
from warpsample.proof.evidence import Subject
from warpsample.proof.verify import Verdict

_USUAL, _SLOW = 4, 16  # the sweep takes every n-th variate, unless the run is thorough
_SLOW_TWINS = ("visible_beckmann",)
_MOST_PROCESSES = 8  # each uses up to 3 GB, and all cores for its kernels


@dataclass(frozen=True)
class TrialPart:
    """One task of `warpsample verify`: the tests of one distribution, sequence or mesh.

    Attributes:
        kind: kind of task: "case", "sequence", "defect", "routes", "meshes" or "rays".
        key: distribution of a case, or name of a sequence or a defect; None for other kinds.
    """

    kind: str
    key: Any = None

    def verdicts(self, thorough: bool = False) -> list[Verdict]:
        """Run the tests of this task and return the results; `thorough` tests all 2^24 random numbers."""
        return _KINDS[self.kind](self.key, thorough)


def list_tasks(only: str | None = None) -> list[TrialPart]:
    """Return all tasks of `warpsample verify`, the longest first.

    The tasks are every case of a distribution, every sequence, the routes, hostile meshes, and rays.

    Args:
        only: name of a distribution or a sequence, or "meshes", "rays" or "routes"; None for all.

    Raises:
        ModuleNotFoundError: the extra `test` is not installed.
        NotImplementedError: a distribution has no twin.
    """
    if only is not None:
        kind = look_up(_kinds_of_parts(), only, "only")
        tasks = [TrialPart("case", case) for case in verify.cases(only)] if kind == "case" else [TrialPart(kind, only)]
        if kind == "rays":
            rays.closed_meshes()
        return tasks
    rays.closed_meshes()
    cases = sorted(verify.cases(), key=lambda case: case.symmetric)
    return [
        TrialPart("meshes"),
        *(TrialPart("case", case) for case in cases),
        *(TrialPart("sequence", name) for name in sequences.names()),
        TrialPart("routes"),
        TrialPart("rays"),
    ]


def subjects(tasks: Iterable[TrialPart]) -> list[Subject]:
    """Return the samplers that the given tasks test, each with its second implementation."""
    found = [Subject(repr(task.key), task.key, task.key) for task in tasks if task.kind == "case"]
    return found + [defects.subject_of(task.key) for task in tasks if task.kind == "defect"]


def _kinds_of_parts() -> dict[str, str]:
    """Return the kind of task for each name that `warpsample verify --only` accepts."""
    parts = dict.fromkeys(distributions.names(), "case") | dict.fromkeys(sequences.names(), "sequence")
    return parts | {kind: kind for kind in ("meshes", "rays", "routes")}


def describe_sweep(tasks: Iterable[TrialPart], thorough: bool) -> str:
    """Return a sentence on how many different random numbers are tested; "" for tasks without distributions."""
    if not subjects(tasks):
        return ""
    if thorough:
        return "The sweep takes each of the 2^24 values of both coordinates."
    slow = " and ".join(_SLOW_TWINS)
    return (
        f"The sweep takes every {_USUAL}th of the 2^24 values of both coordinates ({slow}: {_SLOW}th); --thorough takes all."
    )


def defect_tasks() -> list[TrialPart]:
    """Return one task for each deliberately wrong sampler."""
    return [TrialPart("defect", name) for name in defects.names()]


def run(tasks: list[TrialPart], thorough: bool = False) -> Iterator[tuple[TrialPart, list[Verdict]]]:
    """Run tasks of `warpsample verify` in one process per core; yield each task with its test results when it ends.

    A thorough run sweeps all 2^24 variates, not every fourth, or every 16th for a twin that inverts by bisection.
    """
    context = multiprocessing.get_context("spawn")  # Warp's threads do not survive a fork
    workers = min(len(tasks), os.cpu_count() or 1, _MOST_PROCESSES)
    with _ignore_signals_in_children():
        pool = ProcessPoolExecutor(workers, context)
    try:
        with _ignore_signals_in_children():  # again: the resource tracker has unblocked SIGINT
            futures = {pool.submit(task.verdicts, thorough): task for task in tasks}
        for future in as_completed(futures):
            yield futures[future], future.result()
    except BaseException:
        for process in multiprocessing.active_children():  # a task may take a minute
            process.terminate()
        raise
    finally:
        pool.shutdown(cancel_futures=True)


@contextmanager
def _ignore_signals_in_children() -> Iterator[None]:
    """Context manager: child processes started inside ignore the terminal's signals.

    The parent process handles Ctrl-C, reports it once and ends its children.
    """
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, (signal.SIGINT, signal.SIGQUIT, signal.SIGHUP))
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _judge_case(case: Distribution, thorough: bool) -> list[Verdict]:
    """Run all tests of a distribution, including tests with extreme normals, and return the results."""
    hostile = stress.judge_normals(case) if case.width == 3 else []
    every = 1 if thorough else _SLOW if case.name in _SLOW_TWINS else _USUAL
    return verify.judge_case(case, every=every) + hostile


def _judge_sequence(name: str, thorough: bool) -> list[Verdict]:
    """Run all tests of a sequence, and return the results."""
    return [*streams.judge_sequence(name), *mixing.judge_mixing(name), stress.judge_indices(name)]


def _judge_meshes(key: None, thorough: bool) -> list[Verdict]:
    """Run tests with invalid normals, and with meshes that are tiny, huge or damaged; return the results."""
    return [stress.judge_bad_normals(), *stress.judge_meshes()]


_KINDS = {
    "case": _judge_case,
    "sequence": _judge_sequence,
    "meshes": _judge_meshes,
    "rays": lambda key, thorough: rays.judge_rays(thorough),
    "routes": lambda key, thorough: routes.judge_routes(),
    "defect": lambda key, thorough: defects.judge_defect(key),
}
