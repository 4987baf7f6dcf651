"""The tables of new processes and of calls."""

from warpsample.bench.report import SPREAD, Table, spread
from warpsample.bench.result import Result
from warpsample.bench.startup.measuring import PAUSE
from warpsample.bench.startup.processes import CACHES, STEPS


def tables(result: Result) -> list[Table | str]:
    """New processes, then calls."""
    return [f"{SPREAD[0].upper()}{SPREAD[1:]}.", _processes(result), _calls(result)]


def readme(result: Result) -> list[Table | str]:
    """Both tables, with what they are about."""
    return [
        "Seconds in a new process; with a cold kernel cache, as on the very first run, kernels are compiled:",
        _processes(result),
        f"Calls over and over, or each after {1000 * PAUSE:.0f} ms in which nothing is done and threads fall asleep:",
        _calls(result),
    ]


def _processes(result: Result) -> Table:
    found = {(wait.step, wait.cache): wait.took for wait in result.found.waits}
    cells = [[step, *(spread(found[step, cache]) for cache in CACHES)] for step in STEPS]
    return Table("A new process, seconds", ["", *(f"{cache} cache" for cache in CACHES)], cells)


def _calls(result: Result) -> Table:
    cells = [
        [call.what, call.when, str(call.workers), spread(call.microseconds), spread(call.gain)]
        for call in result.found.calls
    ]
    return Table("Calls", ["call", "when", "workers", "µs", "times as fast as one worker"], cells)
