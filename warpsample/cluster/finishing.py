"""Collection of results from the workers of a Dask Client, and errors that explain why workers fail."""

import time
from collections.abc import Callable, Iterator
from types import SimpleNamespace
from typing import Any

import dask
from dask.array import Array
from dask.sizeof import sizeof

from warpsample.cluster.job import Job

AT_A_TIME = 1 << 12
"""Number of tasks in a graph. A scheduler needs 2 KB per task, and a thread finds the next task in 0.1 ms."""

_BEAT = 0.02  # seconds between two checks for finished tasks
_LOOK = 5.0  # seconds without a finished task, after which the workers' memory is checked
_TRIES = 3  # submissions to a scheduler that forgets tasks, without a finished task in between
_PROCESS = 288 << 20  # bytes of a worker with this package and its kernels; a lower bound
_COPIES = 3  # lower bound of the copies of the large arguments: as received, as unpacked, and the tree


def finished(client: Any, job: Job, tasks: Callable[[list[int]], Array], chunks: list[int]) -> Iterator[Any]:
    """Compute chunks on a Dask Client, and yield the result of each as soon as it is complete.

    Tasks that a restarted scheduler has lost are submitted again.

    Args:
        client: Client of `distributed`.
        job: Job to compute.
        tasks: Function that builds the Dask array of the tasks of a list of chunks.
        chunks: Indices of all chunks to compute.

    Yields:
        the first element of a task's result.

    Raises:
        ConnectionError: if the scheduler no longer answers, or workers keep dying; the message gives the reason.
        MemoryError: if all workers are too small for the job.
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
        except KilledWorker as error:  # noqa: PERF203  (once per submission)
            _check_size([error.last_worker], job)
            raise ConnectionError(str(error).splitlines()[0]) from error
        except (CancelledError, CommClosedError, TimeoutError) as error:
            if client.status != "running":
                raise ConnectionError("the Dask scheduler no longer answers") from error
            if isinstance(error, TimeoutError):  # a deadline of the user; the scheduler still answers
                raise
            tries -= 1
            if not tries:
                raise ConnectionError(f"the Dask scheduler repeatedly lost the tasks ({error})") from error


def _finished(client: Any, job: Job, tasks: Callable[[list[int]], Array], chunks: list[int]) -> Iterator[tuple[int, Any]]:
    """Compute chunks on a Dask Client without a second try, and yield (chunk, result) as each is complete.

    The next graph is submitted when half of the tasks of the previous one are done.
    """
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
                if isinstance(result, tuple | BaseException):  # the future's status may have changed; raise the full error
                    raise result[1] if isinstance(result, tuple) else result
                yield held.pop(future), result[0]
            if ready:
                heard = time.monotonic()
            elif time.monotonic() > heard + _LOOK:
                check_workers_of(client, job)
                heard = time.monotonic()
            time.sleep(_BEAT)
    except CancelledError:  # the scheduler forgot the tasks; after a cancel, tasks submitted again may never finish
        raise
    except BaseException:  # from a task, a signal handler, or the consumer of the results
        if client.status == "running":
            client.cancel(list(held))
        raise


def check_workers_of(client: Any, job: Job) -> None:
    """Raise an error if every worker of a Client has too little memory for the job.

    Workers that are too small pause forever, or are killed and restarted again and again.

    Raises:
        MemoryError: if all workers are too small. The message states the limit of the largest worker and the memory needed.
    """
    known = client.scheduler_info(n_workers=-1).get("workers", {})
    _check_size([SimpleNamespace(address=name, memory_limit=worker["memory_limit"]) for name, worker in known.items()], job)


def _check_size(workers: list[Any], job: Job) -> None:
    """Raise an error if every worker in a list has too little memory for the job.

    Args:
        workers: Objects with an `address`, and a `memory_limit` in bytes; 0 or None means no limit.
        job: Job to compute.

    Raises:
        MemoryError: if all workers are too small.
    """
    pause = dask.config.get("distributed.worker.memory.pause") or 1.0
    needed = (_PROCESS + _COPIES * sum(map(sizeof, job.shared.values()))) / pause
    if workers and all(0 < (worker.memory_limit or 0) < needed for worker in workers):
        most = max(workers, key=lambda worker: worker.memory_limit)
        raise MemoryError(
            f"the workers have too little memory: {most.address} may use {most.memory_limit / 2**20:,.0f} MiB, "
            f"want at least {needed / 2**20:,.0f} MiB for each worker"
        )
