"""`warpsample bake` into a store: check of the command's options, progress bar and report."""

from time import perf_counter
from types import TracebackType

import numpy as np

from warpsample.cluster.baking import DONE, bake_job
from warpsample.cluster.clients import computing
from warpsample.cluster.job import CHUNK, job_of
from warpsample.cluster.store import check_store
from warpsample.host.arguments import check_integer
from warpsample.mesh.files import load_mesh
from warpsample.output.baked import BakeRun
from warpsample.output.by_parts import check_parts
from warpsample.output.faces_option import with_optics
from warpsample.output.quantities import check_options, in_stores, quantity_of
from warpsample.output.terminal_bar import terminal_bar


def bake_run(run: BakeRun, chunk: int | None, address: str | None, processes: int | None, resume: bool) -> str:
    """Compute a run of `warpsample bake` into the store `run.output`.

    Args:
        run: Arguments of the command.
        chunk: Number of points per chunk. None: 65536.
        address: Address of a Dask scheduler. None: this machine.
        processes: Number of local processes with one thread each. None: threads of this process.
        resume: Whether to continue an existing store.

    Returns:
        a report for the terminal, in lines.

    Raises:
        TypeError, ValueError, FileNotFoundError: an argument that cannot be used, before anything is computed.
        KeyboardInterrupt: the run is interrupted; the message states how many points are done.
        OSError: the store cannot be written, another process is writing it, or the scheduler no longer answers.
    """
    store = check_store(run.output, "--output")
    threads = run.options.get("workers")
    _check(run, address, processes, threads)
    quantity, points = quantity_of(run.quantity), run.points if run.at is None else run.at
    options = quantity.arguments({name: value for name, value in run.options.items() if name != "workers"})
    mesh = with_optics(load_mesh(run.mesh), **run.optics)
    job = job_of(quantity.call.__name__, (mesh, points), options, CHUNK if chunk is None else chunk)
    with computing(address, processes, threads), _Watch(run, job.total) as watch:
        bake_job(job, store, resume, "--output", watch.hear)
    return watch.report()


def _check(run: BakeRun, address: str | None, processes: int | None, threads: int | None) -> None:
    """Check that the options of the command fit together and apply to a store.

    Raises:
        TypeError, ValueError: if an option cannot be used.
    """
    if run.quantity not in in_stores():
        raise ValueError(f"--quantity: got {run.quantity} for {run.output.name}, want one of {', '.join(in_stores())}")
    check_parts(run, quantity_of(run.quantity))
    check_options(quantity_of(run.quantity), run.options)
    if run.points is not None and run.at is not None:
        raise ValueError(f"--points: got {run.points} together with --at {run.at}, want one of the two")
    if processes is not None:
        check_integer(processes, "--processes", 1, 1024)
    where = {"--cluster": address, "--processes": processes, "--workers": threads}
    given = [f"{name} {value}" for name, value in where.items() if value is not None]
    if len(given) > 1:
        raise ValueError(f"{given[0]}: got it together with {given[1]}, want one of the two")


class _Watch:
    """Progress bar of a run on a terminal, with sums over the chunks for the final report."""

    def __init__(self, run: BakeRun, points: int) -> None:
        """Prepare the bar of a run, with all sums at zero."""
        self.run, self.points, self.start = run, points, perf_counter()
        self.title = quantity_of(run.quantity).title
        self.there: int | None = None
        self.sums = np.zeros((), DONE)
        self.bar = terminal_bar()
        self.task = self.bar.add_task(self.title, total=points, told="")

    def __enter__(self) -> "_Watch":
        """Show the bar."""
        self.bar.start()
        return self

    def __exit__(self, kind: type | None, error: BaseException | None, trace: TracebackType | None) -> None:
        """Hide the bar."""
        self.bar.stop()

    def hear(self, told: np.void) -> None:
        """Add a summary of dtype DONE to the sums, and update the bar.

        The first call is for all chunks that were complete before; only their points are counted.
        """
        if self.there is None:
            self.there, self.start = int(told["points"]), perf_counter()
        else:
            for name in DONE.names or ():
                self.sums[name] += told[name]
        done = self.there + int(self.sums["points"])
        self.bar.update(self.task, completed=done, told=f"{self._speed():.1f} million rays/s, {self._error()}")

    def report(self) -> str:
        """Return the report of the run for the terminal, in lines."""
        lines = [f"{self.run.output}: {self.title} of {self.points:,} {self.run.at or 'points'}"]
        if self.there:
            lines.append(f"{self.there:,} of them were there already")
        if self.sums["points"]:
            lines.append(f"{self._error()}, root mean square over the points")
            lines.append(f"{self.sums['rays']:,} rays cast in {self._seconds():.2f} s, {self._speed():.1f} million a second")
        return "\n  ".join(lines)

    def _seconds(self) -> float:
        """Return the time since the first chunk was started, in seconds, greater than 0."""
        return max(perf_counter() - self.start, 1e-9)

    def _speed(self) -> float:
        """Return the speed in million rays per second."""
        return float(self.sums["rays"]) / self._seconds() / 1e6

    def _error(self) -> str:
        """Return the root mean square of the points' standard errors, as text."""
        return f"standard error {np.sqrt(self.sums['squared_error'] / max(1, self.sums['points'])):.2g}"
