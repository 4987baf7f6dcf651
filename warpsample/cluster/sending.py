"""Transfer of large arguments to the workers of a Dask Client."""

import sys
import threading
from collections import deque
from collections.abc import Iterator, Mapping
from typing import Any
from weakref import WeakValueDictionary

import dask
from dask.base import tokenize
from dask.highlevelgraph import MaterializedLayer

from warpsample.cluster.job import Job

_KEPT = 4  # futures kept alive: if one is released and sent again, a late release message would delete the new copy
_futures: WeakValueDictionary[tuple[str, str], Any] = WeakValueDictionary()
_last_futures: deque[Any] = deque(maxlen=_KEPT)
_sending = threading.Lock()  # two calls in threads would each send the same mesh
_QUIETLY = {"distributed.admin.large-graph-warning-threshold": "1PiB"}  # no warning: the data are sent once for all calls


def current_client() -> Any | None:
    """Return the current Client if it is connected to a scheduler, else None."""
    if "distributed" not in sys.modules:
        return None
    from distributed import Client

    try:
        client = Client.current()
    except ValueError:
        return None
    return client if client.status == "running" else None


class Tasks(MaterializedLayer):
    """Dask tasks that use data sent to a Client in advance. Computing a task after the Client is closed raises an error."""

    def __init__(self, mapping: Mapping[Any, Any]) -> None:
        """Store a mapping from keys to tasks, together with the current Client, if there is one."""
        super().__init__(mapping)
        self.client: Any = current_client()

    def __iter__(self) -> Iterator[Any]:
        """Return an iterator over the keys of the tasks.

        Raises:
            RuntimeError: if the Client is closed. Schedulers without a Client iterate first, so the error reaches the user.
        """
        if not self._is_usable():
            _raise_closed()
        return super().__iter__()

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle the tasks; if the Client is closed, pickle tasks that raise an error.

        An error raised while pickling would reach the user without its message.
        """
        return MaterializedLayer, (self.mapping if self._is_usable() else dict.fromkeys(self.mapping, (_raise_closed,)),)

    def _is_usable(self) -> bool:
        """Return whether the layer's Client is still open; True also for a layer without a Client."""
        return self.client is None or self.client.status == "running"


def _raise_closed() -> None:
    """Raise the error of a dataset whose Client is closed.

    Raises:
        RuntimeError: always.
    """
    raise RuntimeError(
        "this dataset's mesh was sent to a Dask Client that is closed; make the dataset again with the Client that "
        "computes it, or without a Client"
    )


def shared_by_key(job: Job) -> tuple[dict[str, Any], list[Any]]:
    """Make the large arguments of a job available to tasks: send each to the Dask Client once, or add it to the graph.

    Return (tasks, keys or futures of the arguments).

    Without a Client the arguments are tasks of the graph. With a Client each argument is sent once, as a task that returns
    the argument, and reused by later calls. If all workers with a copy are lost, the scheduler runs the task again.
    """
    client = current_client()
    if client is None:
        tasks = {f"{name}-{tokenize(value)}": value for name, value in job.shared.items()}
        return tasks, list(tasks)
    with _sending:
        return {}, [_send(client, value) for value in job.shared.values()]


def _send(client: Any, value: Any) -> Any:
    """Send an argument to a Client, unless it was sent before; return its future."""
    key = client.id, tokenize(value)
    future = _futures.get(key)
    if future is None or future.status not in ("pending", "finished"):
        with dask.config.set(_QUIETLY):
            future = _futures[key] = client.submit(_return_unchanged, value, key=f"{type(value).__name__}-{key[1]}")
        _last_futures.append(future)
    return future


def _return_unchanged(value: Any) -> Any:
    """Return the argument unchanged; as a Dask task, this keeps a large argument on a worker."""
    return value
