"""What is large on its way to the workers of a Client."""

import sys
from collections import deque
from collections.abc import Iterator, Mapping
from typing import Any
from weakref import WeakValueDictionary

import dask
from dask.base import tokenize
from dask.highlevelgraph import MaterializedLayer

from warpsample.cluster.job import Job

_KEPT = 4  # of what was sent: a scheduler that hears of the end of one only after it was sent again loses that too
_sent: WeakValueDictionary[tuple[str, str], Any] = WeakValueDictionary()
_last_sent: deque[Any] = deque(maxlen=_KEPT)
_QUIETLY = {"distributed.admin.large-graph-warning-threshold": "1PiB"}  # it is sent once for all calls


def current_client() -> Any | None:
    """The Client that computes what is asked for here, if there is one; one that found no scheduler is none."""
    if "distributed" not in sys.modules:
        return None
    from distributed import Client

    try:
        client = Client.current()
    except ValueError:
        return None
    return client if client.status == "running" else None


class Tasks(MaterializedLayer):
    """Tasks of a graph that take what a Client has sent, and cannot be computed when it is closed."""

    def __init__(self, mapping: Mapping[Any, Any]) -> None:
        """Takes the tasks by their keys; they are of the Client that there is now, if there is one."""
        super().__init__(mapping)
        self.client: Any = current_client()

    def __iter__(self) -> Iterator[Any]:
        """The keys, which what computes without a Client asks for first."""
        if not self._of_this_time():
            _refuse()
        return super().__iter__()

    def __reduce__(self) -> tuple[Any, ...]:
        """Gives another Client's scheduler tasks that say what is wrong: an error here would lose its words on the way."""
        return MaterializedLayer, (self.mapping if self._of_this_time() else dict.fromkeys(self.mapping, (_refuse,)),)

    def _of_this_time(self) -> bool:
        return self.client is None or self.client.status == "running"


def _refuse() -> None:
    """Says that a dataset outlived its Client.

    Raises:
        RuntimeError: always.
    """
    raise RuntimeError(
        "this dataset is of a Client that is closed, to which its mesh was sent: make it again, within the Client that is "
        "to compute it, or without one"
    )


def shared_by_key(job: Job) -> tuple[dict[str, Any], list[Any]]:
    """Tasks that are the large arguments, and what other tasks call them by; without a Client they are part of the graph.

    With one they are sent once, the last few for all calls, as tasks that return them: the scheduler has what it makes them
    of again, should all workers be gone that have a copy.
    """
    client = current_client()
    if client is None:
        tasks = {f"{name}-{tokenize(value)}": value for name, value in job.shared.items()}
        return tasks, list(tasks)
    called = []
    for value in job.shared.values():
        key = client.id, tokenize(value)
        future = _sent.get(key)
        if future is None or future.status not in ("pending", "finished"):
            with dask.config.set(_QUIETLY):
                future = _sent[key] = client.submit(_itself, value, key=f"{type(value).__name__}-{key[1]}")
            _last_sent.append(future)
        called.append(future)
    return {}, called


def _itself(value: Any) -> Any:
    return value
