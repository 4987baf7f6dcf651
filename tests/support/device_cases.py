"""Calls that run on a device: each kind of estimate, and one of each kernel."""

import numpy as np
import warp as wp

import warpsample as ws
from warpsample.funcs import Lobe

PICTURE = np.random.default_rng(5).uniform(0.0, 3.0, (8, 16, 3)).astype(np.float32)


@wp.struct
class Weights:
    by_id: wp.array[wp.float32]
    factor: wp.float32


@wp.struct
class Data:
    weights: Weights
    by_row: wp.array2d[wp.float32]


@wp.func
def weighed(w: wp.vec3, lobe: Lobe, data: Data) -> float:
    number = data.weights.by_id[wp.int32(lobe.point - wp.uint64(1000))] + data.by_row[1, lobe.row]
    return data.weights.factor * w[2] * number


@wp.func
def blue(w: wp.vec3) -> wp.vec3:
    return wp.vec3(0.0, wp.abs(w[0]), 1.0)


def data_of(points):
    """A number for each point by its id, and one by its row, in an array whose rows do not touch."""
    data = Data()
    data.weights = Weights()
    data.weights.by_id = wp.array(np.arange(points, dtype=np.float32), dtype=wp.float32, device="cpu")
    data.weights.factor = 0.5
    rows = np.float32([np.zeros(points), np.arange(points) % 7, np.zeros(points)])
    data.by_row = wp.array(rows.T.copy(), dtype=wp.float32, device="cpu").transpose()
    return data


def owned(points):
    """The points with ids of their own, in no order."""
    return ws.SurfacePoints(points.position, points.normal, points.face, id=np.arange(1000, 1300)[::-1])


ACTIVE = np.arange(300) % 3 > 0
ESTIMATES = {
    "occlusion": lambda mesh, at, **o: ws.ambient_occlusion(mesh, at, 64, active=ACTIVE, first_point=2**33, **o),
    "tolerance": lambda mesh, at, **o: ws.ambient_occlusion(mesh, at, 256, tolerance=0.05, **o),
    "data": lambda _, at, **o: ws.integrate(at, weighed, 64, data=data_of(300), first_point=1000, **o),
    "ids": lambda mesh, at, **o: ws.ambient_occlusion(mesh, owned(at), 64, **o),
    "free ids": lambda _, at, **o: ws.integrate(owned(at), weighed, 64, data=data_of(300), **o),
    "falloff": lambda mesh, at, **o: ws.ambient_occlusion(mesh, at, 32, max_distance=0.5, falloff=1.5, **o),
    "sky": lambda mesh, at, **o: ws.sky_view_factor(mesh, at, 64, up=(0, 1, 0), **o),
    "bent": lambda mesh, at, **o: ws.bent_normals(mesh, at, 64, **o),
    "picture": lambda mesh, at, **o: ws.irradiance(mesh, at, PICTURE, 64, **o),
    "function": lambda mesh, at, **o: ws.irradiance(mesh, at, blue, 64, **o),
    "glossy": lambda mesh, at, **o: ws.integrate(
        at, weighed, 64, data=data_of(300), distribution=ws.GGX(0.3), mesh=mesh, first_point=1000, **o
    ),
}

CALLS = {
    "surface": lambda mesh, _: ws.sample_surface(mesh, 1000),
    "directions": lambda _, at: ws.sample_directions(at, 16).vectors,
    "rays": lambda mesh, at: ws.trace(mesh, at, at.normal).distance,
    "occlusion": lambda mesh, at: ws.ambient_occlusion(mesh, at, 64).value,
    "data": lambda mesh, at: ESTIMATES["data"](mesh, at).value,
}
