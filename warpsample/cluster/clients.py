"""Choice of the Dask scheduler of a command: threads of this process, local processes, or a cluster at an address."""

import gc
import logging
import signal
import threading
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from multiprocessing import resource_tracker
from typing import Any

import dask

from warpsample.host.arguments import check_integer
from warpsample.host.engine import check_workers

_PATIENCE = 10.0  # seconds for a scheduler to answer
_ITS_OWN = "127.0.0.1"
_TUNED = {
    "distributed.scheduler.active-memory-manager.start": False,  # removes copies of the mesh from idle processes after 2 s
    "distributed.scheduler.worker-saturation": float("inf"),  # waiting chunks take no memory; requesting each takes 2 ms
}
"""Settings of Dask for local processes started here."""
_ENDING = [getattr(signal, name) for name in ("SIGTERM", "SIGHUP", "SIGQUIT") if hasattr(signal, name)]


def check_processes(processes: int | None) -> None:
    """Raise an error unless the number of processes is None or from 1 to 1024.

    Raises:
        TypeError, ValueError: a number outside 1 to 1024.
    """
    if processes is not None:
        check_integer(processes, "--processes", 1, 1024)


@contextmanager
def computing(address: str | None, processes: int | None, threads: int | None) -> Iterator[None]:
    """Set the Dask scheduler (threads, processes or a cluster) within a `with` statement, and silence Dask's logging.

    Errors that matter are raised, so log lines on a terminal would only repeat them.

    Args:
        address: Address of a Dask scheduler. Default: None, this machine.
        processes: Number of local processes with one thread each. Default: None, threads of this process.
        threads: Number of threads, if neither of the others is given. Default: None, all.

    Raises:
        ConnectionError: no scheduler answers at the address.
    """
    before = logging.root.manager.disable
    logging.disable(logging.CRITICAL)
    try:
        if address is None and processes is None:
            with dask.config.set(scheduler="threads", num_workers=check_workers(threads)):
                yield
            return
        with _open_client(address, processes):
            yield
    finally:
        logging.disable(before)


@contextmanager
def _open_client(address: str | None, processes: int | None) -> Iterator[None]:
    """Open a Dask Client within a `with` statement, connected to the scheduler at `address` or to new local processes."""
    from distributed import Client, LocalCluster

    if address is None:
        options = {"n_workers": processes, "threads_per_worker": 1, "host": _ITS_OWN, "dashboard_address": f"{_ITS_OWN}:0"}
        with ExitStack() as stack:
            with _block_signal(signal.SIGINT), _delay_signals(), dask.config.set(_TUNED):
                own = stack.enter_context(LocalCluster(**options, silence_logs=logging.CRITICAL))
            with Client(own):
                yield
        return
    with _connect(Client, address):
        yield


@contextmanager
def _block_signal(number: signal.Signals) -> Iterator[None]:
    """Block a signal in the body of a `with` statement, so that processes and threads started there do not get the signal.

    A terminal sends Ctrl-C to all processes of a command, and only the main process should handle it.
    """
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    resource_tracker.ensure_running()  # started first, because its start unblocks signals
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {number})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


@contextmanager
def _delay_signals() -> Iterator[None]:
    """Delay SIGTERM, SIGHUP and SIGQUIT to the end of a `with` statement, unless they end the process at once.

    Dask prints tracebacks about processes that it can no longer start. Blocked signals could not end these processes.
    """
    heard: list[int] = []
    is_main = threading.current_thread() is threading.main_thread()
    numbers = [number for number in _ENDING if is_main and callable(signal.getsignal(number))]
    before = {number: signal.signal(number, lambda number, _: heard.append(number)) for number in numbers}
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
        if heard:
            signal.raise_signal(heard[0])


def _connect(client: Any, address: str) -> Any:
    """Connect a Dask Client to the scheduler at an address, and return the Client.

    Raises:
        ConnectionError: if no scheduler answers, or the address is valid only inside another process.
    """
    if address.startswith("inproc:"):
        raise ConnectionError(f"cluster: got {address!r}, which only the process that created it can reach, want HOST:PORT")
    try:
        return client(address, timeout=_PATIENCE)
    except (OSError, ValueError, TypeError) as error:
        reason = str(error).splitlines()[0]
    gc.collect()  # else the Client that failed stays Dask's current one
    raise ConnectionError(
        f"cluster: got {address!r}, where no scheduler answers, want the address of a running Dask scheduler: {reason}"
    )
