"""Deliberately wrong samplers and random numbers, which the tests of samplers must reject."""

from collections.abc import Callable, Iterable
from functools import partial

import numpy as np
import warp as wp

from warpsample.directions.sample import sample_square
from warpsample.distributions.cosine_hemisphere import CosineHemisphere
from warpsample.distributions.microfacets.beckmann import Beckmann
from warpsample.distributions.offset_ball import OffsetBall
from warpsample.distributions.uniform_disk import UniformDisk
from warpsample.distributions.uniform_hemisphere import UniformHemisphere
from warpsample.distributions.uniform_sphere import UniformSphere
from warpsample.host.kernel_cache import load
from warpsample.proof.evidence import Evidence, Subject, independent
from warpsample.proof.mixing import POINTS, cells_of, judge_cells, judge_far_samples, judge_keys, keys_of
from warpsample.proof.routes import add_normal
from warpsample.proof.streams import judge_stream
from warpsample.proof.twins.sequences import pcg4d
from warpsample.proof.verify import LAWS, Law, Verdict, judge
from warpsample.proof.wrong import WrongSampler
from warpsample.proof.wrong_lights import WRONG_LIGHTS
from warpsample.proof.wrong_lobes import WRONG_LOBES
from warpsample.proof.wrong_microfacets import WRONG_MICROFACETS
from warpsample.proof.wrong_pictures import WRONG_PICTURES
from warpsample.proof.wrong_scattered import WRONG_SCATTERED
from warpsample.sequences.hashing import run_words
from warpsample.statistics.charts import DISK

_RIGHT = CosineHemisphere()
_F = np.float32


def _scaled_sphere(scale: float, u: np.ndarray) -> np.ndarray:
    """Sample wrong cosine-lobe directions: the normal plus a point of a sphere with radius `scale`, normalised."""
    return add_normal(scale * UniformSphere().sample(u).astype(np.float64)).astype(_F)


def _short_normal(u: np.ndarray) -> np.ndarray:
    """Sample wrong cosine-lobe directions: a normal of length 0.9 plus a point of the unit sphere, normalised."""
    return add_normal(UniformSphere().sample(u).astype(np.float64) / 0.9).astype(_F)


def _lifted_in_float32(u: np.ndarray) -> np.ndarray:
    """Sample cosine-lobe directions with a rounding error: z is sqrt(1 - x^2 - y^2) in float32."""
    x, y = UniformDisk().sample(u).T
    return np.stack([x, y, np.sqrt(np.maximum(_F(1) - x * x - y * y, 0))], axis=-1)


def _with_gap(u: np.ndarray) -> np.ndarray:
    """Sample wrong cosine-lobe directions, which never have an azimuth in a gap of 1e-3 rad."""
    return _RIGHT.sample(np.stack([u[..., 0], (u[..., 1] * (1 - 1e-3 / (2 * np.pi))).astype(_F)], axis=-1))


def _swapped_quadrant(u: np.ndarray) -> np.ndarray:
    """Sample wrong cosine-lobe directions: sine and cosine of the azimuth are swapped in one quadrant."""
    w = _RIGHT.sample(u)
    quadrant = (u[..., 1] >= 0.25) & (u[..., 1] < 0.5)
    w[quadrant, :2] = w[quadrant, 1::-1]
    return w


def _with_change(change: Callable[[np.ndarray, np.ndarray], None], u: np.ndarray) -> np.ndarray:
    """Sample cosine-lobe directions, and then change the array by `change(directions, u)`."""
    w = _RIGHT.sample(u)
    change(w, u)
    return w


def _nan_in_the_middle(w: np.ndarray, u: np.ndarray) -> None:
    """Set the direction of the unit square's centre, u = (0.5, 0.5), to NaN, in place."""
    w[(u == 0.5).all(axis=-1)] = np.nan


def _one_below(w: np.ndarray, u: np.ndarray) -> None:
    """Flip one direction in 10^5 to below the surface, in place."""
    w[::100_000, 2] *= -1


def _with_seam(u: np.ndarray) -> np.ndarray:
    """Sample wrong points of the unit disk: azimuths in the first octant are one percent too small."""
    p = UniformDisk("concentric").sample(u)
    turns = DISK.azimuth(p)
    short = np.where(turns < 0.125, 0.01 * turns, 0.0)
    turned = (p[..., 0] + 1j * p[..., 1]) * np.exp(-2j * np.pi * short)
    return np.stack([turned.real, turned.imag], axis=-1).astype(_F)


def _rough_beckmann(u: np.ndarray) -> np.ndarray:
    """Sample Beckmann normals with a rounding error: sin theta is sqrt(1 - cos^2 theta) in float32.

    cos theta and the azimuth are correct.
    """
    u = u.astype(np.float64)
    cosine = (1 / np.sqrt(1 - 1e-6 * np.log1p(-u[..., 0]))).astype(_F)
    circle = np.stack([f(2 * np.pi * u[..., 1]) for f in (np.cos, np.sin)]).astype(_F)
    x, y = np.sqrt(np.maximum(1 - cosine * cosine, 0)) * circle
    return np.stack([x, y, cosine], axis=-1)


def _sine(w: np.ndarray) -> np.ndarray:
    """Return the sine of the angle between directions and +z; 0 for NaN."""
    return np.nan_to_num(np.sqrt(np.maximum(1 - w[..., 2] ** 2, 0)))


def _on_grid(bits: int, points: int, count: int, seed: int) -> np.ndarray:
    """Return defective random numbers: independent ones, rounded down to multiples of 2^-bits."""
    return np.floor(independent(points, count, seed) * _F(2**bits)) / _F(2**bits)


@wp.kernel(enable_backward=False)
def _builtin_kernel(seed: wp.int32, count: wp.int32, out: wp.array[wp.vec2]):
    """Draw random numbers from Warp's own generator `wp.randf`, as in Warp's documentation.

    Each thread has a state of 32 bits, and all states are on one cycle.
    """
    point = wp.tid()
    state = wp.rand_init(seed, point)
    for j in range(count):
        out[point * count + j] = wp.vec2(wp.randf(state), wp.randf(state))


def _built_in_generator(points: int, count: int, seed: int) -> np.ndarray:
    """Return (points, count, 2) random numbers of Warp's own generator `wp.randf`."""
    load(_builtin_kernel, "cpu")
    out = wp.empty(points * count, dtype=wp.vec2, device="cpu")
    wp.launch(_builtin_kernel, points, inputs=[seed % 2**31, count], outputs=[out], device="cpu")
    return out.numpy().reshape(points, count, 2)


def _duplicated(points: int, count: int, seed: int) -> np.ndarray:
    """Return defective random numbers: one point in 10^5 has the same numbers as point 1."""
    u = independent(points, count, seed)
    u[::100_000] = u[1]
    return u


def _one_stream_for_all_seeds(points: int, count: int, seed: int) -> np.ndarray:
    """Return defective random numbers: the same numbers for all seeds."""
    return independent(points, count, 0)


def _second_is_the_next_first(points: int, count: int, seed: int) -> np.ndarray:
    """Return defective random numbers: each second coordinate equals the first coordinate of the next point."""
    u = sample_square("independent", points + 1, count, seed=seed)
    return np.stack([u[:-1, :, 0], u[1:, :, 0]], axis=-1)


def _raw_words_as_key(seed: int, first: int, stream: int | None = None, sample: int = 0) -> np.ndarray:
    """Return defective random numbers: PCG4D hashes seed, id, stream and sample number without mixing them first.

    A single step of pcg4d then carries each bit only to higher bits.
    """
    point = first + np.arange(POINTS, dtype=np.uint64)
    words = [point % 2**32, (point >> 32) ^ sample, seed % 2**32, (seed >> 32) ^ (0x9E3779B9 * (stream or 0) % 2**32)]
    x, y, _, _ = pcg4d(*(np.full(POINTS, word, np.uint64) for word in words))
    return np.array([x >> 8, y >> 8]).astype(np.int64)


def _ids_of_32_bits(seed: int, first: int, stream: int | None = None, sample: int = 0) -> np.ndarray:
    """Return defective random numbers: the upper 32 bits of the point ids are ignored."""
    return cells_of("independent")(seed, first % 2**32, stream, sample)


def _in_one_word(points: np.ndarray, run: tuple[int, ...]) -> np.ndarray:
    """Return the (N, 4) words of PCG4D for one argument that varies and three constant arguments."""
    return np.stack(pcg4d(points, *(np.full(len(points), word, np.uint64) for word in run)), axis=1)


def _ids_in_one_word(seed: int, streams: bool) -> np.ndarray:
    """Return defective random keys of points: the point id enters only one of the four arguments of PCG4D."""
    random = np.random.default_rng(1).integers(2**32, size=16 * POINTS, dtype=np.uint64)
    return keys_of(seed, streams) if streams else _in_one_word(random, run_words(seed, 0)[1:])


def _samples_in_one_word() -> np.ndarray:
    """Return defective random words: the sample number enters only one of the four arguments of PCG4D."""
    halves = 512 * np.arange(16 * POINTS, dtype=np.uint64)
    return _in_one_word(halves ^ halves >> np.uint64(16), run_words(1, 0)[1:]) >> np.uint64(8)


_SAMPLERS = (
    WRONG_LOBES
    | WRONG_MICROFACETS
    | WRONG_PICTURES
    | WRONG_SCATTERED
    | WRONG_LIGHTS
    | {
        "sphere scaled by 0.98": WrongSampler(_RIGHT, sample=partial(_scaled_sphere, 0.98)),
        "sphere scaled by 0.99999": WrongSampler(_RIGHT, sample=partial(_scaled_sphere, 0.99999)),
        "normals of length 0.9": WrongSampler(_RIGHT, sample=_short_normal),
        "azimuth gap of 1e-3 rad": WrongSampler(_RIGHT, sample=_with_gap),
        "cos θ as √(1 − x² − y²)": WrongSampler(_RIGHT, sample=_lifted_in_float32),
        "ball for sphere": WrongSampler(_RIGHT, sample=OffsetBall().sample),
        "uniform for cosine": WrongSampler(_RIGHT, sample=UniformHemisphere().sample),
        "sin and cos swapped in a quadrant": WrongSampler(_RIGHT, sample=_swapped_quadrant),
        "x and y swapped": WrongSampler(_RIGHT, sample=lambda u: _RIGHT.sample(u)[..., [1, 0, 2]]),
        "upside down": WrongSampler(_RIGHT, sample=lambda u: _RIGHT.sample(u) * _F([1, 1, -1])),
        "one in 10⁵ below the surface": WrongSampler(_RIGHT, sample=partial(_with_change, _one_below)),
        "NaN at the centre of the square": WrongSampler(_RIGHT, sample=partial(_with_change, _nan_in_the_middle)),
        "length off by 4e-7": WrongSampler(_RIGHT, sample=lambda u: _RIGHT.sample(u) * _F(1 + 4e-7)),
        "concentric map with a seam": WrongSampler(UniformDisk("concentric"), sample=_with_seam),
        "Beckmann's sin θ as √(1 − cos²θ)": WrongSampler(Beckmann(1e-3), sample=_rough_beckmann),
        "Beckmann of α² for α": WrongSampler(Beckmann(0.1), sample=Beckmann(0.01).sample),
        "pdf off by 1e-3": WrongSampler(_RIGHT, pdf=lambda w: _RIGHT.pdf(w) * _F(1.001)),
        "pdf per radian, called per steradian": WrongSampler(_RIGHT, pdf=lambda w: _RIGHT.pdf(w) * _sine(w)),
        "pdf not 0 below the surface": WrongSampler(_RIGHT, pdf=lambda w: np.nan_to_num(np.abs(w[..., 2])) * _F(1 / np.pi)),
        "inverse with a swapped pair": WrongSampler(_RIGHT, invert=lambda w: _RIGHT.invert(w)[..., ::-1]),
        "inverse that is NaN at the pole": WrongSampler(
            _RIGHT, invert=lambda w: np.where(w[..., 2:] > 0.999, _F(np.nan), _RIGHT.invert(w))
        ),
    }
)
_STREAMS = {
    "u on 16 bits": partial(_on_grid, 16),
    "u on 12 bits": partial(_on_grid, 12),
    "Warp's own generator": _built_in_generator,
    "one point in 10⁵ has another's stream": _duplicated,
    "the seed is ignored": _one_stream_for_all_seeds,
    "u[1] is the next point's u[0]": _second_is_the_next_first,
}
_MIXERS = {"raw words as a key": _raw_words_as_key, "ids of 32 bits": _ids_of_32_bits}


_KEYS = {"ids in one word of a hash": _ids_in_one_word}
_SAMPLES = {"samples in one word of a hash": _samples_in_one_word}


def names() -> list[str]:
    """Return the names of all deliberate defects."""
    return [*_SAMPLERS, *_STREAMS, *_MIXERS, *_KEYS, *_SAMPLES]


def subject_of(name: str) -> Subject:
    """Return the deliberately wrong sampler with the given name, and the implementation to compare it with."""
    sampler = _SAMPLERS.get(name, _RIGHT)
    return Subject(name, sampler, getattr(sampler, "claims", _RIGHT), _STREAMS.get(name, independent))


def judge_defect(
    name: str, every: int = 16, draws: int = 1 << 22, points: int = 1_000_000, which: Iterable[Law] = LAWS
) -> list[Verdict]:
    """Run all tests on the deliberately wrong sampler with the given name, and return the verdicts.

    Args:
        name: name of the defect.
        every: see `Evidence`.
        draws: see `Evidence`.
        points: number of points for the laws of streams.
        which: laws of directions and densities to test; the laws of streams are always tested.
    """
    subject = subject_of(name)
    verdicts = judge(Evidence(subject, every, draws), which)
    verdicts += judge_cells(name, _MIXERS[name]) if name in _MIXERS else []
    verdicts += [judge_keys(name, _KEYS[name])] if name in _KEYS else []
    verdicts += [judge_far_samples(name, _SAMPLES[name]())] if name in _SAMPLES else []
    return verdicts + (judge_stream(name, subject.variates, points) if name in _STREAMS else [])
