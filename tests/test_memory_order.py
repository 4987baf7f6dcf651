"""Arrays of another memory order, such as transposes and every second number of a longer array, give the same bits."""

import dataclasses

import numpy as np
import pytest
from affine import Affine

import warpsample as ws

RNG = np.random.default_rng(0)
SQUARE = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], np.float64)
FACES = np.array([[0, 1, 2], [0, 2, 3], [4, 6, 5], [0, 5, 1], [0, 4, 5]], np.int32)  # a room without two walls
UV = RNG.uniform(0.1, 0.9, (5, 3, 2))
MESH = ws.Mesh(SQUARE, FACES)
NORMALS = np.float32([[0.3, 0.2, 0.9], [-0.5, 0.1, 0.7], [0.0, 0.0, 1.0], [0.1, -0.8, 0.4]])
POSITIONS = RNG.uniform(0.2, 0.8, (4, 3)) * [1, 1, 0.1]
POINTS = ws.SurfacePoints(POSITIONS, NORMALS)
PICTURE = np.float32(RNG.uniform(0.1, 1.0, (8, 16, 3)))
DIRECTIONS = np.float32(RNG.normal(size=(7, 3))) + np.float32([0, 0, 2])
SQUARE_POINTS = np.float32(RNG.uniform(0.1, 0.9, (4, 5, 2)))


def in_c_order(array):
    return np.ascontiguousarray(array)


def scattered(array):
    """The same numbers in Fortran order, or, with one axis, as every second number of a longer array."""
    array = np.asarray(array)
    return np.asfortranarray(array) if array.ndim > 1 else np.repeat(array, 2)[::2]


def surface_points(order):
    """Points on faces with every attribute."""
    made = ws.sample_surface(MESH, 6, barycentric=True)
    tangents = np.float32(np.pad(np.eye(3)[[0, 1, 2, 0, 1, 2]] + 0.25, ((0, 0), (0, 1)), constant_values=-1.0))
    arrays = {"id": np.arange(6, dtype=np.uint64) * 7, "raised": np.arange(6) % 2 == 0, "tangent": tangents}
    names = ("position", "normal", "face", "barycentric")
    return ws.SurfacePoints(**{name: order(a) for name, a in ({n: getattr(made, n) for n in names} | arrays).items()})


def with_optics(order):
    shares = {"transmittance": order([0.0, 0.5, 0.0, 0.2, 0.0]), "reflectance": order([0.3, 0.2, 0.1, 0.4, 0.5])}
    return ws.Mesh(order(SQUARE), order(FACES), order(np.int32([0, 0, 1, 1, 1])), ["a", "b"], **shares)


def texture(order):
    normals = RNG_NORMALS
    made = ws.texture_points(MESH, order(UV), 16, samples=2, normals="lifted", corner_normals=order(normals), tangents=True)
    points = made.points
    values = np.float64(points.position) * 3.0
    errors = np.float32(points.position[:, 0])
    one = ws.texture_points(MESH, order(UV[:, [0, 2, 1]]), 16)
    flat = one.points.position[:, :2]
    return [points, made.image(order(values)), one.points, one.image_error(order(flat)), made.covered, errors]


RNG_NORMALS = RNG.normal(size=(5, 3, 3))

CALLS = {
    "points": surface_points,
    "mesh": with_optics,
    "occlusion": lambda order: ws.ambient_occlusion(with_optics(order), surface_points(order), 16, active=order([True] * 6)),
    "up": lambda order: ws.sky_view_factor(MESH, surface_points(order), 16, up=order([0.1, 0.2, 1.0])),
    "refit": lambda order: ws.ambient_occlusion(ws.refit(MESH, order(SQUARE * [1, 1, 0.5])), POINTS, 16),
    "local": lambda order: surface_points(order).to_local(order(RNG_NORMALS[[0, 1, 2, 3, 4, 0]])),
    "world": lambda order: surface_points(order).to_world(order(RNG_NORMALS[[0, 1, 2, 3, 4, 0], 0])),
    "tangents": lambda order: POINTS.with_tangents(order(DIRECTIONS[:4])),
    "directions": lambda order: ws.sample_directions(order(NORMALS), 4, active=order([True, False, True, True]), pdf=True),
    "doubles": lambda order: ws.sample_directions(order(np.float64(NORMALS)), 4),
    "lobes by point": lambda order: ws.sample_directions(
        NORMALS, 4, distribution=ws.VisibleGGX(order(np.float32([0.1, 0.2, 0.3, 0.4])), order(DIRECTIONS[:4])), pdf=True
    ),
    "matrices by point": lambda order: ws.sample_directions(
        NORMALS, 4, distribution=ws.LinearlyTransformedCosine(order(np.eye(3) + 0.1 * RNG_NORMALS[:4])), pdf=True
    ),
    "triangle": lambda order: ws.SphericalTriangle(order(DIRECTIONS[:3])).sample(order(SQUARE_POINTS)),
    "picture": lambda order: ws.EnvironmentMap(order(PICTURE)).sample(order(SQUARE_POINTS)),
    "lobe": lambda order: ws.GGX(0.3).sample(order(SQUARE_POINTS)),
    "density": lambda order: ws.GGX(0.3).pdf(order(NORMALS)),
    "inverse": lambda order: ws.GGX(0.3).invert(order(NORMALS)),
    "trace": lambda order: ws.trace(MESH, order(POSITIONS), order(DIRECTIONS[:4])),
    "trace far": lambda order: ws.trace(MESH, order(np.float32(POSITIONS)), order(DIRECTIONS[:4]), max_distance=0.5),
    "all hits": lambda order: ws.trace_all(MESH, order(POSITIONS), order(DIRECTIONS[:4])),
    "sun": lambda order: ws.direct_sun(MESH, surface_points(order), order(DIRECTIONS), active=order([True] * 6)),
    "sun in doubles": lambda order: ws.direct_sun(
        MESH, POINTS, order(np.float64(DIRECTIONS)), weights=order(RNG_NORMALS[:, :, 0].repeat(2, 0)[:7])
    ),
    "sky": lambda order: ws.sky_matrix(MESH, surface_points(order), 16),
    "fold": lambda order: ws.sky_matrix(MESH, POINTS, 16, fold=order(RADIANCE)),
    "fold one": lambda order: ws.sky_matrix(MESH, POINTS, 16, fold=order(RADIANCE[:, 0])),
    "irradiance": lambda order: ws.irradiance(MESH, surface_points(order), order(PICTURE), 16),
    "view factors": lambda order: ws.view_factors(with_optics(order), 16, groups="part"),
    "radiation": lambda order: ws.view_factors(MESH, 64).net_radiation(
        order([[290.0, 280.0]] * 5), order([0.9] * 5), outside=1
    ),
    "groups": lambda order: ws.view_factors(MESH, 16, groups=order(np.int32([0, 1, 1, 0, 2]))),
    "raster": lambda order: (
        ws.rasters.sky_view_factor((order(RNG_NORMALS[0] * 3.0), Affine(1, 0, 0, 0, -1, 0), None), 64).value
    ),
    "texture": texture,
    "tangents of vertices": lambda order: ws.vertex_points(MESH, uv=order(UV)),
}
RADIANCE = RNG.uniform(0.0, 1.0, (145, 3))


def bits(found):
    """All arrays of a result, as bytes."""
    if isinstance(found, np.ndarray):
        return found.tobytes()
    if isinstance(found, list | tuple):
        return [bits(one) for one in found]
    if dataclasses.is_dataclass(found):
        return {item.name: bits(getattr(found, item.name)) for item in dataclasses.fields(found)}
    return found.tobytes() if hasattr(found, "tobytes") else repr(found)[:40]


SLOW = ("raster",)  # imports of xarray and rasterio


@pytest.mark.parametrize("name", [pytest.param(n, marks=pytest.mark.slow) if n in SLOW else n for n in CALLS])
def test_memory_order_changes_no_bit(name):
    call = CALLS[name]
    assert bits(call(scattered)) == bits(call(in_c_order))
