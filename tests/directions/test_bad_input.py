"""sample_directions names what it cannot use before any work, and writes nothing then."""

import numpy as np
import pytest

import warpsample as ws

GOOD = np.ones((4, 3), np.float32)
READ_ONLY = np.zeros((4, 2, 3), np.float32)
READ_ONLY.setflags(write=False)


@pytest.mark.parametrize(
    ("normals", "arguments", "error", "message"),
    [
        (
            np.empty((0, 3), np.float32),
            {},
            ValueError,
            r"normals: got shape \(0, 3\), want \(P, 3\) with P of at least 1",
        ),
        (np.ones((4, 2), np.float32), {}, ValueError, r"normals: got shape \(4, 2\), want \(P, 3\)"),
        (np.ones(3, np.float32), {}, ValueError, r"normals: got shape \(3,\), want \(P, 3\) with P"),
        (np.ones((2, 2, 3), np.float32), {}, ValueError, r"normals: got shape \(2, 2, 3\), want \(P, 3\) with P"),
        (np.ones((4, 3), int), {}, TypeError, "normals: got dtype int64, want float32"),
        (np.ones((4, 3), complex), {}, TypeError, "normals: got dtype complex128"),
        ("bunny", {}, TypeError, "normals: got dtype <U5"),
        (None, {}, TypeError, "normals: got dtype object"),
        (GOOD, {"count": 0}, ValueError, "count: got 0, want a whole number from 1"),
        (GOOD, {"count": -1}, ValueError, "count: got -1"),
        (GOOD, {"count": 2**31}, ValueError, "count: got 2147483648"),
        (GOOD, {"count": 2.5}, TypeError, "count: got 2.5, want a whole number"),
        (GOOD, {"count": True}, TypeError, "count: got True"),
        (GOOD, {"seed": -1}, ValueError, "seed: got -1, want a whole number of 64 bits"),
        (GOOD, {"seed": 2**64}, ValueError, "seed: got 18446744073709551616"),
        (
            GOOD,
            {"first_point": 2**64 - 3},
            ValueError,
            "first_point: got 18446744073709551613, want an id of 64 bits with",
        ),
        (GOOD, {"sequence": "halton"}, ValueError, "sequence: got 'halton', want one of fibonacci, independent"),
        (
            GOOD,
            {"distribution": "lambert"},
            ValueError,
            "distribution: got 'lambert', want one of beckmann",
        ),
        (GOOD, {"workers": 0}, ValueError, "workers: got 0, want a whole number from 1"),
        (GOOD, {"workers": 1.5}, TypeError, "workers: got 1.5"),
        (GOOD, {"active": np.ones(3, bool)}, ValueError, r"active: got shape \(3,\), want an array of bool of shape \(4,\)"),
        (GOOD, {"active": np.ones(4)}, TypeError, "active: got dtype float64, want an array of bool"),
        (GOOD, {"out": np.zeros((4, 2, 3))}, TypeError, "out: got dtype float64, want a C-contiguous"),
        (
            GOOD,
            {"out": np.zeros((4, 3, 3), np.float32)},
            ValueError,
            r"out: got shape \(4, 3, 3\), want .* \(4, 2, 3\)",
        ),
        (
            GOOD,
            {"out": np.zeros((2, 4, 3), np.float32).swapaxes(0, 1)},
            ValueError,
            "out: got an array that is not C-cont",
        ),
        (GOOD, {"out": READ_ONLY}, ValueError, "out: got an array that is read-only"),
        (GOOD, {"out": [0.0]}, TypeError, "out: got a value of type list, want a NumPy array, the type of the normals"),
        (GOOD, {"device": "tpu"}, ValueError, "device: got 'tpu', want one of cpu"),
    ],
)
def test_bad_input_is_named_before_any_work(normals, arguments, error, message):
    with pytest.raises(error, match="^" + message):
        ws.sample_directions(normals, **{"count": 2, **arguments})


def test_out_may_not_overlap_the_normals(normals):
    with pytest.raises(
        ValueError, match=r"^out: got an array that overlaps the normals, want an array with memory of its own"
    ):
        ws.sample_directions(normals, 1, out=normals[:, None])


def test_nothing_is_written_when_an_argument_is_bad(normals):
    out = np.full((1000, 2, 3), 7.0, np.float32)
    with pytest.raises(ValueError, match="sequence"):
        ws.sample_directions(normals, 2, out=out, sequence="halton")
    assert (out == 7.0).all()


def test_more_than_memory_is_refused_with_a_way_out(normals):
    with pytest.raises(
        MemoryError, match=r"1,000,000,000,000 directions need 12000\.0 GB and .* are free; compute them in parts"
    ):
        ws.sample_directions(normals, 10**9)
