"""Tests of the independence of random numbers over points, samples and seeds, and a command that writes them.

External test batteries read the stream: `python -m warpsample.proof.streams independent | dieharder -a -g 200`.
"""

import hashlib
import sys
from collections.abc import Callable, Iterator
from itertools import count

import numpy as np

from warpsample import sequences
from warpsample.directions.sample import sample_square
from warpsample.maths.numerics import GRID
from warpsample.proof import laws
from warpsample.proof.twins.sequences import frozen_digest
from warpsample.proof.verify import Verdict

Variates = Callable[..., np.ndarray]

_SIDE = 128  # points, and samples of each, in a block of the endless stream


def integers(u: np.ndarray) -> np.ndarray:
    """Convert random numbers in [0, 1) to integers below 2^24, exactly."""
    return (u * np.float32(GRID)).astype("<u4", order="C")


def digest(name: str) -> str:
    """Return a hash of some points of a sequence, to detect any change of the sequence's values.

    The ids of the surface points cross a multiple of 2^32.
    """
    cells = integers(sample_square(name, 257, 67, seed=12345, first_point=2**33 - 100))
    return hashlib.sha256(cells.astype(np.int64).tobytes()).hexdigest()[:16]


def judge_stream(name: str, variates: Variates, points: int = 1_000_000, random: bool = True) -> list[Verdict]:
    """Test random numbers for independence over points, samples and seeds; return the results.

    Args:
        name: name in tables.
        variates: function (points, count, seed) -> (points, count, 2) float32.
        points: number of points with 64 samples each, among which pairs may repeat only as often as by chance.
        random: whether the samples of one point should be independent, too.
    """
    first, other = (variates(200_000, 4, seed).astype(np.float64) for seed in (3, 4))
    u = first[:, 1]
    pairs = {
        "dimensions": [(u[:, 0], u[:, 1])],
        "points": [(u[1:, a], u[:-1, b]) for a in (0, 1) for b in (0, 1)],
        "seeds": [(u[:, a], other[:, 1, a]) for a in (0, 1)],
        "samples": [(u[:, a], first[:, 2, a]) for a in (0, 1)] if random else [],
    }
    p_values = {
        f"correlation of {which}": laws.joint_p_value(*(laws.correlation_p_value(*pair) for pair in some))
        for which, some in pairs.items()
        if some
    }
    # One sample from each of many points is uniform, even if the samples of a point are dependent. Half a cell is added to
    # get the centres of the grid's cells.
    one_each = first[np.arange(len(first)), np.arange(len(first)) % 4] + 0.5 / GRID
    p_values["uniform"] = laws.joint_p_value(*(laws.uniform_p_value(one_each[:, axis]) for axis in (0, 1)))
    if random:
        p_values["repeats"] = repeats_p_value(variates, points)
    verdicts = [Verdict.from_p_value(law, name, p_value) for law, p_value in p_values.items()]
    return [*verdicts, Verdict.from_error("shared streams", name, shared_streams(variates, points))]


def judge_sequence(name: str, points: int = 1_000_000) -> list[Verdict]:
    """Test a sequence for independence, and test that its values have not changed; return the results."""

    def variates(points: int, samples: int, seed: int) -> np.ndarray:
        return sample_square(name, points, samples, seed=seed)

    frozen = Verdict.from_error("frozen stream", name, digest(name) != frozen_digest(name), note=digest(name))
    return [*judge_stream(name, variates, points, sequences.get(name).random), frozen]


def repeats_p_value(variates: Variates, points: int) -> float:
    """Return the p-value of the number of equal pairs among 64 samples of each of `points` points (birthday test).

    The number has a Poisson distribution with mean n^2 / 2^49, which is 7 for a million points. A generator with a small
    state has too many equal pairs; one that avoids repeats has too few.
    """
    from scipy.stats import poisson

    cells = integers(variates(points, 64, 5)).astype(np.uint64).reshape(-1, 2)
    packed = np.sort((cells[:, 0] << np.uint64(24)) | cells[:, 1])
    met = int((packed[1:] == packed[:-1]).sum())
    mean = len(packed) ** 2 / 2.0**49
    return laws.joint_p_value(float(poisson.sf(met - 1, mean)), float(poisson.cdf(met, mean)))


def shared_streams(variates: Variates, points: int) -> int:
    """Count the points whose first two samples equal those of another point; 96 bits never agree by chance."""
    cells = integers(variates(points, 64, 6)[:, :2]).astype(np.uint64).reshape(-1, 4)
    packed = np.stack([(cells[:, 0] << np.uint64(24)) | cells[:, 1], (cells[:, 2] << np.uint64(24)) | cells[:, 3]], axis=1)
    return points - len(np.unique(packed, axis=0))


def emitted_bytes(name: str) -> Iterator[bytes]:
    """Yield the random numbers of a sequence as an endless stream of bytes, three bytes for each number.

    A block holds both dimensions of 128 points x 128 samples, for seed 0, 1, 2, and so on. A battery compares neighbours in
    its stream. So the neighbours are samples of a point for even seeds, and points for odd seeds.
    """
    for seed in count():
        u = sample_square(name, points=_SIDE, count=_SIDE, seed=seed)
        cells = integers(u if seed % 2 == 0 else u.swapaxes(0, 1))
        yield cells.view(np.uint8).reshape(-1, 4)[:, :3].tobytes()


def main() -> None:
    """Write the stream of the sequence named by the first argument to standard output, until the reader stops."""
    if len(sys.argv) != 2 or sys.argv[1] not in sequences.names():
        sys.exit(f"usage: python -m warpsample.proof.streams {'|'.join(sequences.names())}")
    try:
        for block in emitted_bytes(sys.argv[1]):
            sys.stdout.buffer.write(block)
    except BrokenPipeError:
        sys.stderr.close()  # the reader has stopped: print nothing, also not at exit


if __name__ == "__main__":
    main()
