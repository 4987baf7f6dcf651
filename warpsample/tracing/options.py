"""Options of calls that cast rays from points, checked once and passed as one record."""

from dataclasses import dataclass, replace
from typing import Any

from warpsample import sequences
from warpsample.host.arguments import check_flag
from warpsample.host.options import CallOptions
from warpsample.sequences.record import Sequence
from warpsample.tracing.tracers import WIDE, Tracer, tracer_of


@dataclass(frozen=True, eq=False, kw_only=True)
class RayOptions(CallOptions):
    """Checked options of a call that casts rays, see `RayKeywords` and `CallOptions`."""

    sequence: Sequence
    skip: bool = True
    tracer: Tracer = WIDE

    def check_through_glass(self) -> None:
        """Raise ValueError if the tracer does not support translucent faces."""
        if self.tracer is not WIDE:
            raise ValueError(f"tracer: got {self.tracer.name!r} for a mesh that transmits light, want 'wide' on the CPU")

    @classmethod
    def of(cls, points: int, *, sequence: str = "fibonacci", **drawn: Any) -> "RayOptions":
        """The options of rays from so many points, cast on the CPU by all cores.

        Args:
            points: how many.
            sequence: of the rays, a name of `warpsample.sequences.names()`.
            drawn: `seed`, `first_point`, `ids` and `active` as `CallOptions.of` takes them.

        Raises:
            TypeError, ValueError: one that cannot be used; names it, what it got and what it wants.
        """
        return cls(**vars(CallOptions.of(points, **drawn)), sequence=sequences.get(sequence))

    def by(self, *, skip: bool = True, tracer: str = "auto", **how: Any) -> "RayOptions":
        """A copy of the options of which one says how the rays are cast.

        Args:
            skip: whether to leave out rays whose answer is known: parts of the mesh below a point's horizon are not looked
                at, nor directions in which nothing is to be met; changes no bit.
            tracer: "wide", "warp" (wp.Mesh, without skipping) or "auto": wide on the CPU, wp.Mesh on a CUDA device.
            how: `device`, `workers`, `progress`, `given` and `argument` as `CallOptions.by` takes them.

        Raises:
            TypeError, ValueError: one that cannot be used; names it, what it got and what it wants.
        """
        options = super().by(**how)
        return replace(options, skip=check_flag(skip, "skip"), tracer=tracer_of(tracer, options.memory.device))
