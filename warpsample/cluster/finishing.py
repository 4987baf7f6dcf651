"""Tasks as the workers of a Client finish them; and what it means when they do not."""

import time
from collections.abc import Callable, Iterator
from types import SimpleNamespace
from typing import Any

import dask
from dask.array import Array
from dask.sizeof import sizeof

from warpsample.cluster.job import Job

AT_A_TIME = 1 << 12
"""Tasks of a graph: a scheduler takes 2 KB for each, and a thread finds the next one in 0.1 ms."""

_BEAT = 0.02  # seconds between two looks at what is finished
_LOOK = 5.0  # seconds without a task finished, after which the workers are looked at
_TRIES = 3  # without one task finished, of what a restarted scheduler has forgotten
_PROCESS = 288 << 20  # bytes of a worker that has this package and its kernels, less than there ever are
_COPIES = 3  # at least, of what is sent: as it comes, as it is, and the tree


def finished(client: Any, job: Job, tasks: Callable[[list[int]], Array], chunks: list[int]) -> Iterator[Any]:
    """What the task of each chunk tells, in the order in which they are finished.

    Args:
        client: a Client of distributed.
        job: what is computed.
        tasks: makes the tasks of some chunks.
        chunks: all of them.

    Raises:
        ConnectionError: the scheduler is gone, or the workers end; says why.
        MemoryError: the workers are too small.
    """
    from distributed import CancelledError
    from distributed.comm import CommClosedError
    from distributed.scheduler import KilledWorker

    left, tries = dict.fromkeys(chunks), _TRIES
    while left:
        try:
            for chunk, told in _finished(client, job, tasks, list(left)):
                left.pop(chunk)
                tries = _TRIES
                yield told
        except KilledWorker as error:  # noqa: PERF203  (once for each scheduler that forgets)
            _check_size([error.last_worker], job)
            raise ConnectionError(str(error).splitlines()[0]) from error
        except (CancelledError, CommClosedError, TimeoutError) as error:
            if client.status != "running":
                raise ConnectionError("the scheduler is gone") from error
            if isinstance(error, TimeoutError):  # of a user's deadline: the scheduler is there
                raise
            tries -= 1
            if not tries:
                raise ConnectionError(f"the scheduler forgets its tasks ({error})") from error


def _finished(client: Any, job: Job, tasks: Callable[[list[int]], Array], chunks: list[int]) -> Iterator[tuple[int, Any]]:
    """(chunk, what its task tells): the next graph goes to the scheduler when half of the one before is done."""
    from distributed import CancelledError, as_completed, futures_of

    size = max(AT_A_TIME, 8 * sum(client.nthreads().values()))
    parts = iter([chunks[start : start + size] for start in range(0, len(chunks), size)])
    held: dict[Any, int] = {}
    done, heard = as_completed(with_results=True), time.monotonic()
    try:
        while True:
            if len(held) <= size // 2 and (part := next(parts, None)):
                futures = futures_of(client.persist(tasks(part)))
                held.update({future: part[future.key[1]] for future in futures})
                done.update(futures)
            if not held:
                return
            ready = done.next_batch(block=False)
            for future, result in ready:
                if isinstance(result, tuple | BaseException):  # its status may be another by now; of an error all is told
                    raise result[1] if isinstance(result, tuple) else result
                yield held.pop(future), result[0]
            if ready:
                heard = time.monotonic()
            elif time.monotonic() > heard + _LOOK:
                check_workers_of(client, job)
                heard = time.monotonic()
            time.sleep(_BEAT)
    except CancelledError:  # it has forgotten them: with a cancel, what is sent again next may never be finished
        raise
    except BaseException:  # of a task, of a signal's handler, or of who is told
        if client.status == "running":
            client.cancel(list(held))
        raise


def check_workers_of(client: Any, job: Job) -> None:
    """Refuses a job that none of a Client's workers has the memory for; they would pause for good, or end again and again.

    Raises:
        MemoryError: says how much a worker may take, and how much it needs.
    """
    known = client.scheduler_info(n_workers=-1).get("workers", {})
    _check_size([SimpleNamespace(address=name, memory_limit=worker["memory_limit"]) for name, worker in known.items()], job)


def _check_size(workers: list[Any], job: Job) -> None:
    """Refuses workers if all of them are too small.

    Raises:
        MemoryError: they are.
    """
    pause = dask.config.get("distributed.worker.memory.pause") or 1.0
    needed = (_PROCESS + _COPIES * sum(map(sizeof, job.shared.values()))) / pause
    if workers and all(0 < (worker.memory_limit or 0) < needed for worker in workers):
        most = max(workers, key=lambda worker: worker.memory_limit)
        raise MemoryError(
            f"the workers are too small: {most.address} may take {most.memory_limit / 2**20:,.0f} MiB, want at least "
            f"{needed / 2**20:,.0f} MiB for each"
        )
