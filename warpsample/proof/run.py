"""The whole trial of `warpsample verify`, each task in its own process."""

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

_USUAL, _SLOW = 4, 16  # the sweep takes every n-th variate, unless it is thorough
_SLOW_TWINS = ("visible_beckmann",)
_MOST_PROCESSES = 8  # each uses up to 3 GB, and all cores for its kernels


@dataclass(frozen=True)
class TrialPart:
    """A part of the trial: a case, a sequence, a defect, or one of the words "routes", "meshes" and "rays"."""

    kind: str
    key: Any = None

    def verdicts(self, thorough: bool = False) -> list[Verdict]:
        """The verdicts of this task. `thorough`: see `run`."""
        return _KINDS[self.kind](self.key, thorough)


def trial(only: str | None = None) -> list[TrialPart]:
    """All tasks, the longest first: every case, sequence, second route and hostile input, and the rays.

    Without the extra `test` it is a ModuleNotFoundError, before any work; so is a distribution without a twin a
    NotImplementedError. `only`: the name of a distribution, of a sequence, or "meshes", "rays" or "routes".
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
    """Return the samplers and twins of those tasks that judge one lobe."""
    found = [Subject(repr(task.key), task.key, task.key) for task in tasks if task.kind == "case"]
    return found + [defects.subject_of(task.key) for task in tasks if task.kind == "defect"]


def _kinds_of_parts() -> dict[str, str]:
    """The kind of task by what can be asked for by name."""
    parts = dict.fromkeys(distributions.names(), "case") | dict.fromkeys(sequences.names(), "sequence")
    return parts | {kind: kind for kind in ("meshes", "rays", "routes")}


def extent(thorough: bool) -> str:
    """The extent of the sweep, in words."""
    if thorough:
        return "The sweep takes each of the 2^24 values of both coordinates."
    slow = " and ".join(_SLOW_TWINS)
    return (
        f"The sweep takes every {_USUAL}th of the 2^24 values of both coordinates ({slow}: {_SLOW}th); --thorough takes all."
    )


def planted() -> list[TrialPart]:
    """One task for each defect."""
    return [TrialPart("defect", name) for name in defects.names()]


def run(tasks: list[TrialPart], thorough: bool = False) -> Iterator[tuple[TrialPart, list[Verdict]]]:
    """Yields tasks with their verdicts as they end, on one process for each core.

    A thorough run sweeps all 2^24 variates, not every fourth (with a twin that inverts by bisection, every 16th).
    """
    context = multiprocessing.get_context("spawn")  # Warp's threads do not survive a fork
    workers = min(len(tasks), os.cpu_count() or 1, _MOST_PROCESSES)
    with _deaf():
        pool = ProcessPoolExecutor(workers, context)
    try:
        with _deaf():  # again: multiprocessing has since started its resource tracker, which unblocks SIGINT
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
def _deaf() -> Iterator[None]:
    """Processes started within ignore a terminal's signals: the parent handles Ctrl-C, reports it once and ends them."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, (signal.SIGINT, signal.SIGQUIT, signal.SIGHUP))
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _judge_case(case: Distribution, thorough: bool) -> list[Verdict]:
    hostile = stress.judge_normals(case) if case.width == 3 else []
    every = 1 if thorough else _SLOW if case.name in _SLOW_TWINS else _USUAL
    return verify.judge_case(case, every=every) + hostile


def _judge_sequence(name: str, thorough: bool) -> list[Verdict]:
    return [*streams.judge_sequence(name), *mixing.judge_mixing(name), stress.judge_indices(name)]


def _judge_meshes(key: None, thorough: bool) -> list[Verdict]:
    return [stress.judge_bad_normals(), *stress.judge_meshes()]


_KINDS = {
    "case": _judge_case,
    "sequence": _judge_sequence,
    "meshes": _judge_meshes,
    "rays": lambda key, thorough: rays.judge_rays(thorough),
    "routes": lambda key, thorough: routes.judge_routes(),
    "defect": lambda key, thorough: defects.judge_defect(key),
}
