"""Seconds of new processes and of calls, one below the other."""

from typing import TYPE_CHECKING

from warpsample.bench.pictures import OURS, THEIRS, dots, new_figure
from warpsample.bench.report import spread
from warpsample.bench.startup.measuring import Found
from warpsample.bench.timing import Spread

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def draw(found: Found, caption: str) -> dict[str, "Figure"]:
    """A dot for each step with a cold and a warm cache, and for each call."""
    figure, axes = new_figure(caption, 9.0, 6.0)
    milliseconds = [_scaled(wait.took, 1e3) for wait in found.waits]
    milliseconds += [_scaled(call.microseconds, 1e-3) for call in found.calls]
    names = [f"{wait.step}, {wait.cache} cache" for wait in found.waits]
    names += [f"{call.what} {call.when}, {call.workers} worker{'s' if call.workers > 1 else ''}" for call in found.calls]
    colours = [OURS] * len(found.waits) + [THEIRS] * len(found.calls)
    dots(axes, names, milliseconds, colours, [spread(each) for each in milliseconds])
    axes.set_xlabel("time [ms]")
    return {"startup": figure}


def _scaled(found: Spread, factor: float) -> Spread:
    return Spread(factor * found.median, factor * found.low, factor * found.high)
