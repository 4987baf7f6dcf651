"""Where a command's tasks run: threads of this process, processes of this machine, or somebody's cluster."""

import logging
import signal
from collections.abc import Iterator
from contextlib import contextmanager
from multiprocessing import resource_tracker
from typing import Any

import dask

from warpsample.host.engine import check_workers

_PATIENCE = 10.0  # seconds for a scheduler to answer
_ITS_OWN = "127.0.0.1"
_TUNED = {
    "distributed.scheduler.active-memory-manager.start": False,  # after 2 s it takes an idle process its copy of the mesh
    "distributed.scheduler.worker-saturation": float("inf"),  # chunks that wait hold nothing; asking for each takes 2 ms
}
"""Of processes of our own."""


@contextmanager
def computing(address: str | None, processes: int | None, threads: int | None) -> Iterator[None]:
    """Within, Dask computes by the scheduler at an address, by so many processes of one thread each, or by threads.

    Nothing is logged meanwhile: what matters is raised.

    Raises:
        ConnectionError: no scheduler answers there.
    """
    before = logging.root.manager.disable
    logging.disable(logging.CRITICAL)
    try:
        if address is None and processes is None:
            with dask.config.set(scheduler="threads", num_workers=check_workers(threads)):
                yield
            return
        with _client(address, processes):
            yield
    finally:
        logging.disable(before)


@contextmanager
def _client(address: str | None, processes: int | None) -> Iterator[None]:
    from distributed import Client, LocalCluster

    if address is None:
        options = {"n_workers": processes, "threads_per_worker": 1, "host": _ITS_OWN, "dashboard_address": f"{_ITS_OWN}:0"}
        with _left_to_us(signal.SIGINT), dask.config.set(_TUNED):
            own = LocalCluster(**options, silence_logs=logging.CRITICAL)
        with own, Client(own):
            yield
        return
    with _connected(Client, address):
        yield


@contextmanager
def _left_to_us(number: signal.Signals) -> Iterator[None]:
    """Processes that are started within, and by threads that are, do not get a signal: a terminal's Ctrl-C goes to all."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    resource_tracker.ensure_running()  # which unblocks signals when it starts
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {number})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _connected(client: Any, address: str) -> Any:
    if address.startswith("inproc:"):
        raise ConnectionError(f"cluster: got {address!r}, which its own process alone reaches, want HOST:PORT")
    try:
        return client(address, timeout=_PATIENCE)
    except (OSError, ValueError, TypeError) as error:
        reason = str(error).splitlines()[0]
        raise ConnectionError(f"cluster: got {address!r}, where no scheduler answers: {reason}") from None
