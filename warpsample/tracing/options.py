"""Checked options of all calls that cast rays from points, for example sequence and tracer."""

from dataclasses import dataclass, replace
from typing import Any

from warpsample import sequences
from warpsample.host.arguments import check_flag
from warpsample.host.options import CallOptions
from warpsample.sequences.record import Sequence
from warpsample.tracing.tracers import WIDE, Tracer, tracer_of


@dataclass(frozen=True, eq=False, kw_only=True)
class RayOptions(CallOptions):
    """Checked options of a call that casts rays from points, see `RayKeywords` and `CallOptions`."""

    sequence: Sequence
    skip: bool = True
    tracer: Tracer = WIDE

    def check_through_glass(self) -> None:
        """Raise ValueError if the tracer does not support translucent faces."""
        if self.tracer is not WIDE:
            raise ValueError(f"tracer: got {self.tracer.name!r} for a mesh that transmits light, want 'wide' on the CPU")

    @classmethod
    def of(
        cls, points: int, *, sequence: str = "fibonacci", skip: bool = True, tracer: str = "auto", **shared: Any
    ) -> "RayOptions":
        """Check the options of a call that casts rays from `points` points, and return a `RayOptions`.

        The options are those of `RayKeywords`; `shared` is as for `CallOptions.of`.
        """
        options = CallOptions.of(points, **shared)
        return cls(**vars(options), sequence=sequences.get(sequence))._with_tracer(skip, tracer)

    def replace(self, *, skip: bool = True, tracer: str = "auto", **how: Any) -> "RayOptions":
        """Check new values of options (`tracer`, `workers` and more), and return a copy with the new values.

        `how` is as for `CallOptions.replace`.
        """
        return super().replace(**how)._with_tracer(skip, tracer)

    def _with_tracer(self, skip: bool, tracer: str) -> "RayOptions":
        return replace(self, skip=check_flag(skip, "skip"), tracer=tracer_of(tracer, self.memory.device))
