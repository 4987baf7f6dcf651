"""Tests with extreme and invalid input: normals, ids and indices at the limits of integers, damaged and huge meshes."""

from itertools import product

import numpy as np

from warpsample import sequences
from warpsample.directions.sample import Status, sample_directions, sample_square
from warpsample.distributions.cosine_hemisphere import CosineHemisphere
from warpsample.distributions.record import Distribution
from warpsample.distributions.scattering.base import ScatteredLight
from warpsample.distributions.uniform_sphere import UniformSphere
from warpsample.mesh.mesh import Mesh, as_mesh
from warpsample.mesh.points.sampling import sample_surface
from warpsample.proof import laws, twins
from warpsample.proof.mixing import grid_cells
from warpsample.proof.twins.sequences import expected
from warpsample.proof.verify import Verdict

_SAMPLES = 64
_IDS = sorted({max(0, 2**k + step) for k in (24, 31, 32, 40, 63) for step in (-2, -1, 0, 1)} | {0, 1, 2**64 - 1})
_INDICES = [0, 1, 2**16 - 1, 2**24 - 1, 2**24, 2**24 + 1, 2**31 - 2]
_COUNTS = [1, 7, 64, 2**24 + 3, 2**31 - 1]
_SEEDS = [0, 1, 2**32, 2**64 - 1]


def hostile_normals() -> np.ndarray:
    """Return (N, 3) float32 normals of length 1e-45 to 3e38: axes, diagonals, and normals close to axes and to -z.

    They include components of -0.0, and random normals.
    """
    signs = np.array(list(product((-1.0, -0.0, 0.0, 1.0), repeat=3)))
    beside = np.concatenate([axis + step * np.roll(axis, 1) for axis in np.eye(3) for step in (1e-30, 1e-8, 1e-7, -1e-4)])
    beside = np.concatenate([beside.reshape(-1, 3), -beside.reshape(-1, 3)])
    steps = np.array([[x, y, -1.0] for x, y in product((0.0, -0.0, 1e-38, 1e-20, -1e-7, 6e-8, 3e-4), repeat=2)])
    random = np.random.default_rng(0).normal(size=(500, 3))
    plain = np.concatenate([signs[np.abs(signs).sum(axis=1) > 0], beside, steps, random])
    plain /= np.abs(plain).max(axis=1, keepdims=True)
    sizes = np.array([1e-45, 1e-42, 1.2e-38, 1e-30, 1e-6, 0.64, 1.0, 1e12, 1e30, 1.7e38])
    scaled = (plain[None] * sizes[:, None, None]).astype(np.float32).reshape(-1, 3)
    return scaled[scaled.any(axis=1)]


def exact_directions(distribution: Distribution, normals: np.ndarray, u: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the exact directions about normals, in world coordinates and in the normals' frames, each (P, n, 3) float64."""
    wide = normals.astype(np.float64)
    unit = wide / np.abs(wide).max(axis=1, keepdims=True)
    unit /= np.linalg.norm(unit, axis=1, keepdims=True)
    frames = twins.frames(unit)
    if distribution == CosineHemisphere("offset"):  # sphere + normal in world coordinates
        total = unit[:, None] + twins.directions(UniformSphere(), u.astype(np.float64))
        exact = total / np.linalg.norm(total, axis=-1, keepdims=True)
        return exact, np.einsum("nij,nsi->nsj", frames, exact)
    local = twins.directions(distribution, u.astype(np.float64))
    if distribution.in_world:
        return local, distribution.sample(u).astype(np.float64)
    # The density is evaluated at the float32 direction: in a narrow lobe, the direction's rounding error changes it too
    # much.
    return np.einsum("nij,nsj->nsi", frames, local), distribution.sample(u).astype(np.float64)


def judge_normals(distribution: Distribution) -> list[Verdict]:
    """Test a distribution about extremely long, short and tilted normals, and return the results."""
    normals = hostile_normals()
    got = sample_directions(normals, _SAMPLES, distribution=distribution, sequence="independent", pdf=True)
    u = sample_square("independent", len(normals), _SAMPLES)
    w = got.vectors.astype(np.float64)
    kept = np.ones(w.shape[:2], bool)
    angle, density, note = 5e-7, 2e-6, ""
    if distribution == CosineHemisphere("offset"):
        # abs(n + s) = 2 pi pdf. For shorter sums the direction is drawn again, in a frame and from another hash.
        kept = 2.0 * np.pi * got.pdf > 2.0**-6 * 1.001
        angle, density, note = 1.3e-5, 1.3e-5, "frame-free: n and s have errors of 1e-7 each, their sum is as short as 2^-6"
    if isinstance(distribution, ScatteredLight):
        # The exact density belongs to the exact normal m. v.m is as small as 1e-5, where the rounding of m changes it.
        angle, density, note = distribution.worst_angle + 2e-7, 5e-2, "near v.m = 0 the rounding of m changes the density"
    exact, local = exact_directions(distribution, normals, u)
    name = repr(distribution)
    lost = sum(n for status, n in got.counts().items() if status is not Status.OK)
    densities = twins.density(distribution, local)[kept]
    return [
        Verdict.from_error("hostile normals, lost", name, lost),
        # The columns of the frame add 1e-7 to the 2e-7 of the local direction.
        Verdict.from_error("hostile normals, unit length", name, laws.length_error(w), limit=2.5e-7),
        Verdict.from_error(
            "hostile normals, direction", name, laws.angle_error(w[kept], exact[kept]), limit=angle, note=note
        ),
        Verdict.from_error(
            "hostile normals, density", name, laws.density_error(got.pdf[kept], densities), limit=density, note=note
        ),
    ]


def judge_bad_normals() -> Verdict:
    """Test that zero, NaN and infinite normals give zero vectors, density 0 and a status; return the result.

    The directions of their neighbours must not change.
    """
    nan, inf = np.nan, np.inf
    bad = [(0, 0, 0), (-0.0, 0, 0), (nan, 0, 1), (0, nan, 0), (inf, 0, 0), (0, -inf, 1), (inf, nan, 0)]
    want = [Status.ZERO_NORMAL] * 2 + [Status.NONFINITE_NORMAL] * 5
    normals = np.tile(np.array([0.0, 0.6, 0.8], np.float32), (2 * len(bad), 1))
    normals[::2] = bad
    wrong = 0
    for count in (1, 3, 64):
        got = sample_directions(normals, count, pdf=True)
        alone = sample_directions(normals[1:2], count, first_point=1)
        wrong += int((got.status[::2] != want).sum()) + int(got.vectors[::2].any()) + int(got.pdf[::2].any())
        wrong += int((got.status[1::2] != 0).sum()) + int((got.vectors[1] != alone.vectors[0]).any())
    return Verdict.from_error("bad normals", "zero, NaN, infinite", wrong, note="wrong rows or neighbours")


def judge_indices(name: str) -> Verdict:
    """Test a sequence at the limits of 32- and 64-bit ids, sample indices, counts and seeds; return the result.

    The exact integers of the twins are the reference.
    """
    asked = [(p, s, c) for p in _IDS for c in _COUNTS for s in {*_INDICES, c - 1} if s < c]
    columns = np.array(asked, np.uint64).T
    worst = 0
    for seed in _SEEDS:
        want = np.array([expected(name, seed=seed, point=p, sample=s, count=c) for p, s, c in asked])
        worst = max(worst, int(np.abs(grid_cells(name, seed, None, *columns) - want).max()))
    note = f"cells of 2^-24; ids to 2^64, indices to 2^31, {len(_SEEDS)} seeds"
    return Verdict.from_error("indices", name, worst, limit=float(sequences.get(name).cells_off), note=note)


def judge_meshes() -> list[Verdict]:
    """Test points sampled on meshes that are tiny, far away, huge, or full of bad faces; return the results."""
    corner = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], float)
    faces = np.array([(0, 1, 2), (0, 1, 3), (0, 2, 3), (1, 2, 3)])
    verdicts = []
    for scale, offset in ((1e-6, 0.0), (1e-6, 1.0), (1.0, 5e6), (5e6, 5e6)):
        vertices = corner * scale + offset
        points = sample_surface((vertices, faces), 100_000)
        a, b, c = (vertices[faces[points.face, k]] for k in range(3))
        normal = np.cross(b - a, c - a)
        height = np.abs(((points.position - a) * normal).sum(axis=1)) / np.linalg.norm(normal, axis=1)
        ulps, edges = height.max() / np.spacing(scale + offset), f"edges of {scale:g} at {offset:g}"
        verdicts.append(Verdict.from_error("points on their face", edges, ulps, limit=4.0, note="in float64 ulps"))
    bad = np.concatenate([faces, [(0, 0, 1), (1, 1, 1), (0, 1, 4), (0, 1, 2)]])  # degenerate, a sliver, a duplicate
    points = sample_surface((np.concatenate([corner, [(0.5, 1e-300, 0.0)]]), bad), 100_000)
    on_bad = np.isin(points.face, (4, 5, 6)).sum() + (~np.isfinite(points.position)).sum()
    verdicts.append(Verdict.from_error("points on faces without area", "degenerate faces and a sliver", on_bad))
    many = ten_million_faces()
    points = sample_surface(many, 1_000_000)
    p_value = laws.uniform_p_value((points.face + 0.5) / len(many.faces))
    return [*verdicts, Verdict.from_p_value("shares of the area", f"{len(many.faces):,} equal faces", p_value)]


def ten_million_faces() -> Mesh:
    """Return a flat square of 9,999,392 equal triangles."""
    side = 2237
    x, y = (a.ravel() for a in np.meshgrid(np.arange(side), np.arange(side), indexing="ij"))
    first = (np.arange(side - 1)[:, None] * side + np.arange(side - 1)).ravel()
    faces = np.concatenate([first[:, None] + (0, side, 1), first[:, None] + (side, side + 1, 1)])
    return as_mesh((np.stack([x, y, 0 * x], axis=1).astype(float), faces))
