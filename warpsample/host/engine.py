"""Execution of Warp kernels on worker threads or on a CUDA device, and checks of free memory and disk space."""

import os
import shutil
from collections import defaultdict, deque
from collections.abc import Callable, Iterator
from contextlib import suppress
from ctypes import Structure
from functools import partial
from pathlib import Path
from time import perf_counter
from typing import Any

import warp as wp

from warpsample.host.arguments import check_integer
from warpsample.host.files import WriteError
from warpsample.host.interrupts import uninterrupted
from warpsample.host.kernel_cache import load
from warpsample.host.locks import imported, make
from warpsample.host.progress import begin
from warpsample.host.sharing import share

# Batches of a worker: many batches even out threads of different speed, but each batch passes the GIL around. A worker gets
# more than the few batches only if each has at least _BATCH_WORK directions.
_FEW_BATCHES, _MANY_BATCHES = 4, 16
_BATCH_WORK = 1 << 17

LEAST_WORK = 1 << 17
"""Directions from which on threads share a call. Below it (0.3 ms) waking threads costs more than it gains."""

MOST_WORK = 1 << 25
"""Largest number of directions of a batch: 0.1 s, after which the call can be interrupted and a progress bar moves."""

MOST_TASKS = (1 << 31) - 1
"""Largest number of tasks of a batch: wp.tid() is an int32."""

MOST_WORKERS = 1024
"""Largest number of threads of a call."""

_PARTS = 32  # the first launch of a thread has the tasks of a batch divided by this number
_USUAL, _LONG = 0.1, 0.2  # seconds that a launch should take, and seconds above which the next launch is smaller

_MOST_ON_DEVICE = 1 << 34  # directions of a batch on a CUDA device; with fewer than 10^5 tasks a part of the device is idle
_ALWAYS_FREE = 1 << 24  # bytes; to ask the system how much more is free takes 100 us

_UNITS = (("TB", 12), ("GB", 9), ("MB", 6), ("kB", 3))

_idle: dict[tuple[wp.Kernel, str], list[wp.Launch]] = defaultdict(list)


def check_workers(workers: int | None) -> int:
    """Return the number of threads, from 1 to 1024: by default WARPSAMPLE_WORKERS, or the number of cores.

    Raises:
        TypeError: the value is no whole number.
        ValueError: the number is outside the range.
    """
    if workers is None:
        variable = os.environ.get("WARPSAMPLE_WORKERS", "").strip()
        if variable:
            return check_integer(int(variable) if variable.isdecimal() else variable, "WARPSAMPLE_WORKERS", 1, MOST_WORKERS)
        return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    return check_integer(workers, "workers", 1, MOST_WORKERS)


def check_memory(needed: int, what: str, remedy: str) -> None:
    """Raise an error if arrays do not fit into the free memory, before anything is allocated.

    Args:
        needed: bytes.
        what: plural noun for the arrays.
        remedy: advice at the end of the error.

    Raises:
        MemoryError: gives the needed and the free memory in GB.
    """
    if needed < _ALWAYS_FREE:
        return
    free = imported("psutil").virtual_memory().available
    if needed > free:
        raise MemoryError(f"{what} need {needed / 1e9:.1f} GB and {free / 1e9:.1f} GB are free; {remedy}")


def check_space(path: Path, needed: int, what: str) -> None:
    """Raise an error if the disk has too little space for an output, before anything is computed.

    Raises:
        WriteError: the output is larger than the free space; gives both sizes.
    """
    folder = path.resolve().parent
    free = shutil.disk_usage(next(parent for parent in (folder, *folder.parents) if parent.exists())).free
    if needed > free:
        raise WriteError(f"{path} cannot be written: {what} take {_format_size(needed)}, and {_format_size(free)} are free")


def _format_size(size: int) -> str:
    """Return a number of bytes in the largest unit that is not above the number."""
    unit, power = next(((unit, power) for unit, power in _UNITS if size >= 10**power), ("bytes", 0))
    return f"{size / 10**power:,.3f} {unit}" if power else f"{size} {unit}"


def run(kernel: wp.Kernel, tasks: int, inputs: list[Any], device: wp.Device, *, workers: int, work: int) -> None:
    """Run `kernel(*inputs, first_task)` once for each task; the number of a task is `first_task + wp.tid()`.

    The call can be interrupted after each launch of a part of a batch. No thread is at work afterwards.

    Args:
        kernel: kernel whose last parameter is first_task, an int64.
        tasks: number of tasks, of any size; batches stay below 2^31.
        inputs: the other parameters; structs as instances of Warp's struct or of ctypes.
        device: on a CPU, `workers` threads share the batches; on CUDA the launches queue up.
        workers: largest number of threads.
        work: number of directions, or of comparable units, in all; work below LEAST_WORK stays on the calling thread.
    """
    sound = wp.config.mode != "debug"  # two threads at once crash in kernels that Warp built for debugging
    workers = workers if device.is_cpu and work >= LEAST_WORK and sound else 1
    each = min(max(work // (workers * _BATCH_WORK), _FEW_BATCHES), _MANY_BATCHES)
    shares = workers * each if workers > 1 else 1
    most = MOST_WORK if device.is_cpu else _MOST_ON_DEVICE
    batch = min(-(-tasks // shares), max(1, most * tasks // work), MOST_TASKS)
    starts, done, halted = iter(range(0, tasks, batch)), begin(tasks, work), []
    first = max(1, batch // _PARTS) if device.is_cpu and work >= LEAST_WORK else batch
    how = {"batch": batch, "first": first, "tasks": tasks, "done": done, "halted": halted}
    stop = partial(deque, starts, maxlen=0)  # batches that threads have taken are completed, unless a signal halts them

    def run_all() -> None:
        commands = [_take(kernel, inputs, device) for _ in range(workers)]
        share([partial(_run_batches, command, starts, **how) for command in commands], stop)
        _idle[kernel, device.alias].extend(commands)  # not after an error, which may have left one half-changed

    uninterrupted(run_all, partial(halted.append, True))


def _take(kernel: wp.Kernel, inputs: list[Any], device: wp.Device) -> wp.Launch:
    """Return a prepared launch of a kernel with the given inputs; launches are reused, since creating one is slow."""
    command = None
    with suppress(IndexError):  # another thread may take the last one
        command = _idle[kernel, device.alias].pop()
    if command is None:  # not within the handling of the error, which would be the context of an interrupt
        load(kernel, device.alias)
        command = make(partial(_record, kernel, inputs, device))
    for index, value in enumerate(inputs):
        if isinstance(value, Structure):
            command.set_param_at_index_from_ctype(index, value)
        else:
            command.set_param_at_index(index, value)
    return command


def _record(kernel: wp.Kernel, inputs: list[Any], device: wp.Device) -> wp.Launch:
    """Create a prepared launch of a kernel; struct inputs are empty and set later."""
    blank = [arg.type() if isinstance(x, Structure) else x for arg, x in zip(kernel.adj.args, inputs, strict=False)]
    return wp.launch(kernel, dim=1, inputs=[*blank, 0], device=device, record_tape=False, record_cmd=True)


def _run_batches(
    command: wp.Launch,
    starts: Iterator[int],
    *,
    batch: int,
    first: int,
    tasks: int,
    done: Callable[[int], None] | None,
    halted: list[bool],
) -> None:
    """Run tasks of a kernel on this thread, a batch at a time, until none is left or `halted` is not empty.

    Some tasks take thousands of times as long as others, such as points where thousands of faces meet. So the first launch
    has only `first` tasks, and the sizes of the next ones follow from the time that the launch before has taken.

    Threads can share `starts`, since next() on a range is atomic; a lock could stay closed after an interrupt. `done` is
    called after each launch.
    """
    last, most = len(command.kernel.adj.args) - 1, first
    for start in starts:
        at, end = start, min(start + batch, tasks)
        while at < end and not halted:
            command.set_param_at_index_from_ctype(last, at)
            size, began = min(most, end - at), perf_counter()
            if command.bounds.size != size:
                command.set_dim(size)
            command.launch()
            if done:
                done(size)
            if first < batch:  # else a launch has a whole batch, as on a CUDA device, where it only joins a queue
                most = _next_size(size, perf_counter() - began, most, batch)
            at += size


def _next_size(size: int, seconds: float, most: int, batch: int) -> int:
    """Return the largest size of the next launch, after one of `size` tasks, which may be the rest of a batch."""
    if seconds > _LONG:
        return max(1, int(size * _USUAL / seconds))
    return min(8 * most, batch) if seconds < _USUAL / 8.0 else most
