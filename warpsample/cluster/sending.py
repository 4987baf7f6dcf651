"""Transfer of large arguments to the workers of a Dask Client."""

import sys
from collections import deque
from collections.abc import Iterator, Mapping
from typing import Any
from weakref import WeakValueDictionary

import dask
from dask.base import tokenize
from dask.highlevelgraph import MaterializedLayer

from warpsample.cluster.job import Job

_KEPT = 4  # futures kept alive: if one is released and sent again, a late release message would delete the new copy
_sent: WeakValueDictionary[tuple[str, str], Any] = WeakValueDictionary()
_last_sent: deque[Any] = deque(maxlen=_KEPT)
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
    """Layer of a Dask graph whose tasks use data sent to a Client, and fail when the Client is closed."""

    def __init__(self, mapping: Mapping[Any, Any]) -> None:
        """Store the tasks by key, together with the current Client, if there is one."""
        super().__init__(mapping)
        self.client: Any = current_client()

    def __iter__(self) -> Iterator[Any]:
        """Iterate over the keys.

        Raises:
            RuntimeError: if the Client is closed. Schedulers without a Client iterate first, so the error reaches the user.
        """
        if not self._of_this_time():
            _refuse()
        return super().__iter__()

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle the tasks; if the Client is closed, pickle tasks that raise an error.

        An error raised while pickling would reach the user without its message.
        """
        return MaterializedLayer, (self.mapping if self._of_this_time() else dict.fromkeys(self.mapping, (_refuse,)),)

    def _of_this_time(self) -> bool:
        """Check whether the layer's Client is still open, or there was none."""
        return self.client is None or self.client.status == "running"


def _refuse() -> None:
    """Raise the error of a dataset whose Client is closed.

    Raises:
        RuntimeError: always.
    """
    raise RuntimeError(
        "this dataset is of a Client that is closed, to which its mesh was sent: make it again, within the Client that is "
        "to compute it, or without one"
    )


def shared_by_key(job: Job) -> tuple[dict[str, Any], list[Any]]:
    """Return (tasks of the large arguments, keys or futures that other tasks use in place of the arguments).

    Without a Client the arguments are tasks of the graph. With a Client each argument is sent once, as a task that returns
    the argument, and reused by later calls. If all workers with a copy are lost, the scheduler runs the task again.
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
    """Return the argument unchanged."""
    return value
