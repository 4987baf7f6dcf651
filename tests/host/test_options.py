"""Options that calls share are checked as one record and said once: docstrings point to it, `help` shows what it says."""

import inspect

import numpy as np
import pytest

import warpsample as ws
from warpsample.host.options import CallOptions, explained_by
from warpsample.tracing.options import RayOptions
from warpsample.tracing.tracers import BUILTIN, WIDE


def source(seed, workers):
    """What others point to.

    Args:
        seed: of 64 bits,
            as a whole number.
        workers: threads.

    Raises:
        ValueError: not meant.
    """


@explained_by(source, RayOptions)
def pointing(count, seed, workers, tracer, progress):
    """Points to both.

    Args:
        count: its own.
        workers, seed: see `source`.
        tracer, progress: see `RayOptions`.

    Returns:
        nothing.
    """


def test_a_pointer_becomes_what_the_source_says():
    before, after = inspect.getdoc(pointing).split("    tracer: ")
    assert before.endswith(
        "Args:\n    count: its own.\n    workers: threads.\n    seed: of 64 bits,\n        as a whole number.\n"
    )
    assert after.endswith("changes no bit.\n\nReturns:\n    nothing.")
    assert "\n    progress: whether to show a progress bar" in after  # of the record's base


def test_a_pointer_to_what_is_not_said_is_refused():
    def lost():
        """Says too little.

        Args:
            cores, seed: see `source`.
        """

    with pytest.raises(KeyError, match="cores"):
        explained_by(source)(lost)
    lost.__doc__ = None  # as by python -OO
    assert explained_by(source)(lost).__doc__ is None


@pytest.mark.parametrize(
    "call", [ws.ambient_occlusion, ws.irradiance, ws.direct_sun, ws.sample_directions, ws.sample_surface]
)
def test_help_leaves_no_pointer(call):
    assert "see `" not in inspect.getdoc(call).partition("Args:")[2].partition("Returns:")[0]


def test_a_record_is_checked_in_two_steps():
    drawn = RayOptions.of(3, sequence="r2", seed=5, first_point=7, active=[True, False, True])
    assert (drawn.sequence.name, drawn.seed, drawn.first_point, drawn.active.tolist()) == ("r2", 5, 7, [1, 0, 1])
    assert (drawn.skip, drawn.tracer, drawn.progress) == (True, WIDE, False)
    cast = drawn.by(skip=np.False_, tracer="warp", workers=2, progress=True)
    assert (cast.seed, cast.sequence, cast.active) == (drawn.seed, drawn.sequence, drawn.active)
    assert (cast.skip, cast.tracer, cast.workers, cast.progress) == (False, BUILTIN, 2, True)
    with pytest.raises(TypeError, match="unexpected keyword argument 'cores'"):
        CallOptions.of(3).by(cores=2)
