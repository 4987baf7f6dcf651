"""For the sweep of test_arguments.py: what each argument of each public function accepts, and values that none accepts."""

import tempfile
from dataclasses import dataclass
from fractions import Fraction
from inspect import signature
from math import inf, nan
from pathlib import Path
from tempfile import mkdtemp
from typing import Any

import numpy as np
import warp as wp
from weights_of_tests import upward

import warpsample as ws
from warpsample.funcs import Lobe

VERTICES = np.array([[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 2.0, 0.0], [0.0, 2.0, 1.0]])
FACES = np.array([[0, 1, 2], [0, 2, 3]])
MESH = ws.Mesh(VERTICES, FACES)
POINTS = ws.vertex_points(MESH)
ON_A_FACE = ws.SurfacePoints(POINTS.position, POINTS.normal, np.zeros(len(POINTS), np.int32))
UNIT = np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.6, 0.0, 0.8], [0.0, 0.6, 0.8]], np.float32)
COUNT = 16
FACES_OF_COURTYARD = 2080
QUAD = Path(tempfile.mkdtemp(), "quad.obj")
QUAD.write_text("v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n")
UV = np.array([[(0.1, 0.9), (0.9, 0.9), (0.9, 0.1)], [(0.1, 0.9), (0.9, 0.1), (0.1, 0.1)]])
TEXELS = ws.texture_points(MESH, UV, 4)


@wp.struct
class Sky:
    zenith: float


@wp.func
def radiance(w: wp.vec3, lobe: Lobe, sky: Sky) -> float:
    return sky.zenith * w[2]


@wp.func
def without_a_type(w) -> float:
    return 1.0


@dataclass(frozen=True)
class Kind:
    """What an argument takes: an example; labels of `values` that are as good, since its docstring says so; its own values.

    `said` is what an error may call it, where that is not its name: the part of it that is wrong, or what it stands for.
    """

    good: Any
    valid: frozenset[str] = frozenset()
    said: tuple[str, ...] = ()
    wrong: tuple[Any, ...] = ()


def kind(good, *valid, said=(), wrong=()):
    return Kind(good, frozenset(valid), said, wrong)


WHOLE = "int32(2)"
NUMBER = ("float32(0.5)", "Fraction(1, 2)")
LIMITLESS = (*NUMBER, WHOLE, "1.5", "2**70", "10**5000", "inf")
POSITIVE = (*NUMBER, WHOLE, "1.5")
FLAG = ("True", "np.True_")
IN_MESH = ("mesh", "vertices", "faces")
BAD_MESHES = (
    (VERTICES, FACES.astype(float)),
    (VERTICES, np.ma.masked_array(FACES)),
    (VERTICES, [[0, 1, 2], [0, 1]]),
    (np.ma.masked_array(VERTICES), FACES),
    ("3", "3"),
    (None, None),
    [VERTICES, FACES],
)
JUNE = ("06-21T09", "06-21T12")
NO_LIGHT = (np.full((4, 4), nan), np.full((4, 4), -1.0), np.full((4, 4), 1e300), "3.hdr", Path("3.hdr"), ws.trace)

KINDS = {
    "mesh": kind(MESH, said=IN_MESH, wrong=BAD_MESHES),
    "on": kind(MESH, said=("vertices", "faces"), wrong=BAD_MESHES),
    "vertices": kind(VERTICES + 1.0, wrong=(VERTICES * nan,)),
    "faces": kind(FACES, wrong=(FACES.astype(float), FACES - 1, FACES + 2)),
    "path": kind(Path(wp.__file__).parent / "examples" / "assets" / "bunny.usd", wrong=("a\0b", "long" * 1000)),
    "load_uv.path": kind(QUAD, wrong=("a\0b", "long" * 1000, Path(__file__))),
    "uv": kind(UV, wrong=(UV[:1], UV[..., :1])),
    "size": kind(8, WHOLE, wrong=(0, (8, 0), (8, 8, 8), 2**20)),
    "unwrap.size": kind(64, WHOLE, said=("size",), wrong=(0, (8, 8), 2**20)),
    "padding": kind(2, WHOLE, "int32(2)", wrong=(65,)),
    "samples": kind(2, WHOLE, wrong=(0, 2000)),
    "texture_points.normals": kind("smooth", wrong=("flat",)),
    "corner_normals": kind(np.ones((2, 3, 3)), wrong=(UV,)),
    "TexturePoints.take.rows": kind(slice(0, 2), wrong=(range(2),)),
    "TexturePoints.image.values": kind(TEXELS.points.position[:, 0]),
    "TexturePoints.precise_image.values": kind(TEXELS.points.position[:, 0]),
    "errors": kind(TEXELS.points.position[:, 0]),
    "gutter": kind("all", WHOLE, wrong=("none", 2**40)),
    "set": kind(0, said=("path",), wrong=(256,)),
    "points": kind(POINTS, wrong=(MESH, UNIT)),
    "integrate.points": kind(UNIT, wrong=(FACES,)),
    "integrand": kind(upward, said=("data",), wrong=(without_a_type, radiance, radiance.func, Sky)),
    "data": kind(Sky(), wrong=(Sky, Lobe())),
    "sample_square.points": kind(4, WHOLE),
    "accessor.sample_directions.points": kind(4, WHOLE),
    "count": kind(COUNT, WHOLE, wrong=(0, np.float64(2.0), np.ma.masked_array(2))),
    "seed": kind(3, WHOLE),
    "first_point": kind(3, WHOLE),
    "workers": kind(1, WHOLE, wrong=(0,)),
    "max_distance": kind(1.5, *LIMITLESS),
    "falloff": kind(2.0, *POSITIVE),
    "refine": kind(0.5, *LIMITLESS),
    "sampling": kind("both"),
    "tolerance": kind(0.1, *POSITIVE, wrong=(0.0,)),
    "scale": kind(0.1, *POSITIVE, "-1", "2**70"),
    "alpha": kind(0.5, *NUMBER, "of Warp"),
    "alpha_y": kind(0.5, *NUMBER, "of Warp", "None"),
    "HenyeyGreenstein.g": kind(0.5, *NUMBER, "of Warp"),
    "matrix": kind(np.eye(3), wrong=(np.eye(2), np.zeros((3, 3)), np.full((3, 3), nan))),
    "lobes": kind([ws.GGX(0.3), ws.UniformSphere()], wrong=(ws.GGX(0.3), [ws.UniformDisk()] * 2, ["ggx"] * 2)),
    "Mixture.weights": kind([1.0, 3.0], "one less", wrong=([1.0], [-1.0, 2.0], [nan, 1.0], [0.0, 0.0])),
    "lobe": kind(ws.VisibleGGX(0.3), wrong=(ws.VisibleGGX, "ggx(alpha=0.3)", ws.UniformDisk())),
    "corners": kind(np.eye(3), wrong=(np.eye(2), np.zeros((3, 3)), np.full((3, 3), nan))),
    "eta": kind(1.5, *POSITIVE, "of Warp", wrong=(1.0, 1.0005, 0.0, 101.0)),
    "RoughDielectric.view": kind(np.array([0.0, 0.6, 0.8]), wrong=("123", (0, 0, 0), (nan, 0, 1))),
    "corner": kind(np.array([-1.0, -1.0, 1.0]), wrong=("123", (0, 0, 0), (nan, 0, 1), np.eye(2))),
    "edge_x": kind(np.array([2.0, 0.0, 0.0]), wrong=("123", (0, 0, 0), (inf, 0, 1), np.eye(2))),
    "edge_y": kind(np.array([0.0, 2.0, 0.0]), wrong=("123", (0, 0, 0), (1.0, 2.0, 0.0), (nan, 0, 1), np.eye(2))),
    "level": kind(0.95, *NUMBER),
    "kappa": kind(0.5, *POSITIVE, "of Warp"),
    "rho": kind(0.5, *POSITIVE, "of Warp"),
    "exponent": kind(0.5, *POSITIVE, "of Warp"),
    "cos_angle": kind(0.5, *NUMBER, "-1", "of Warp"),
    "one_minus_cos": kind(0.5, *POSITIVE, "of Warp", said=("cos_angle",)),
    "method": kind("polar"),
    "view": kind(np.array([0.0, 0.6, 0.8]), wrong=("123", (0, 0, 0), (0, 0, -1), (nan, 0, 1))),
    "up": kind(np.array([0.0, 0.6, 0.8]), wrong=("123", (0, 0, 0), (inf, 0, 1))),
    "patches": kind("tregenza", wrong=("klems",)),
    "sky_patches.name": kind("tregenza", said=("patches",), wrong=("klems",)),
    "north": kind(np.array([0.0, 0.6, 0.8]), wrong=("123", (0, 0, 0), (inf, 0, 1), (0.0, 0.0, 2.0))),
    "SkyMatrix.save.path": kind(Path(tempfile.mkdtemp(), "sky.npz")),
    "fold": kind(np.ones((145, 2)), "one less", wrong=(np.ones(146), np.full(145, nan), np.ones((145, 2, 2)))),
    "barycentric": kind(False, *FLAG),
    "pdf": kind(True, *FLAG),
    "any_hit": kind(False, *FLAG),
    "skip": kind(False, *FLAG),
    "progress": kind(False, *FLAG),
    "raised": kind(np.array([True, False, True, True]), "bool"),
    "active": kind(np.array([True, False, True, True]), "bool"),
    "distribution": kind("cosine_hemisphere", wrong=(ws.GGX, "ggx(alpha=\0)", "ggx(alpha=" + "(" * 1000)),
    "sequence": kind("fibonacci"),
    "sample_directions.sequence": kind("sobol"),
    "accessor.sample_directions.sequence": kind("sobol"),
    "tracer": kind("wide"),
    "device": kind("cpu"),
    "at": kind("vertices"),
    "out": kind(np.zeros((4, COUNT, 3), np.float32), wrong=(np.zeros((4, COUNT, 3)),)),
    "normals": kind(UNIT, wrong=(FACES, MESH)),
    "origins": kind(UNIT, said=("directions",), wrong=(FACES, MESH)),
    "directions": kind(-UNIT, wrong=(FACES, MESH, POINTS)),
    "direct_sun.directions": kind(-UNIT, wrong=(0.0 * UNIT, UNIT + inf, UNIT[:0])),
    "weights": kind(np.ones(4), "of Warp", wrong=(np.full(4, nan), np.ones(3), np.ones((4, 0)))),
    "disc": kind(0.533, *POSITIVE, wrong=(-0.5, 46.0)),
    "cosine": kind(False, *FLAG),
    "weather": kind("athens", wrong=("3.epw", "a\0b", Path(__file__))),
    "ground_albedo": kind(0.3, *NUMBER, wrong=(-0.1, 1.1)),
    "period": kind(JUNE, wrong=("06-01", ("06-01",), ("06-31", "07-01"), ("06-01T25", "07-01"), (6, 7))),
    "irradiation.patches": kind("tregenza", wrong=("klems",)),
    "irradiation.north": kind(np.array([0.0, 1.0, 0.3]), wrong=("123", (0, 0, 0), (0, 0, 2), (inf, 0, 1))),
    "series": kind(False, *FLAG),
    "position": kind(VERTICES),
    "normal": kind(UNIT),
    "face": kind(
        np.array([0, 1, -1, 0]), "of Warp", wrong=([0.0, 1.0, 0.0, 1.0], [-2, 0, 0, 0], [2**31, 0, 0, 0], [2**64, 0, 0, 0])
    ),
    "Mesh.part": kind(np.array([0, -1]), wrong=([0.0, 0.0], [-2, 0], [0, 1])),
    "Mesh.parts": kind(("wall",), said=("part",), wrong=("wall", ("wall", 1))),
    "load_city.path": kind("courtyard", wrong=("a\0b", "long" * 1000, Path(__file__))),
    "lod": kind(1, wrong=("2.2.2", "roof", 7)),
    "split": kind(False, *FLAG),
    "context": kind("ground", said=IN_MESH, wrong=("earth", "3.ply", *BAD_MESHES)),
    "City.points.count": kind(100, WHOLE, wrong=(0, np.float64(2.0))),
    "City.surface_means.values": kind(np.ones(FACES_OF_COURTYARD)),
    "error": kind(np.ones(FACES_OF_COURTYARD)),
    "City.surface_means.points": kind(ON_A_FACE, said=("values",), wrong=(MESH, UNIT, POINTS)),
    "City.write.points": kind(ON_A_FACE, wrong=(MESH, UNIT, POINTS)),
    "City.write.path": kind(Path(tempfile.mkdtemp(), "out.city.json")),
    "results": kind(
        {"a": np.ones(3)}, "{}", said=("results['a']",), wrong=({"": np.ones(3)}, {"a": UNIT}, {"a_error": np.ones(3)})
    ),
    "found": kind(ws.trace(MESH, POINTS, UNIT), wrong=(ws.Hits,)),
    "SurfacePoints.id": kind(np.array([7, 0, 2**40, 3], np.uint64), "of Warp", wrong=([0.0, 1.0, 2.0, 3.0], [-1, 0, 0, 0])),
    "rows": kind(np.array([3, 0]), "one less", "of Warp", "[]", wrong=([0.5], [4], [-1])),
    "tangents": kind(True, *FLAG),
    "arrays": kind({"roughness": np.ones(1)}.get, "a function", "a type"),
    "tangent": kind(np.ones((4, 3))),
    "vectors": kind(UNIT),
    "SurfacePoints.barycentric": kind(np.full((4, 3), 1 / 3)),
    "u": kind(
        np.full((4, 2), 0.5), "one axis more", wrong=(np.full((4, 2), nan), np.full((4, 2), 1.0), np.full((4, 2), -0.1))
    ),
    "w": kind(UNIT, "one axis more", wrong=(FACES,)),
    "theta": kind(
        np.linspace(0.0, 3.0, 4),
        *("float32(0.5)", WHOLE, "-1", "1.5", "nan", "inf", "[]", "[[]]", "one less", "one axis more", "no axis", "of Warp"),
    ),
    "picture": kind(np.ones((4, 8)), "one less", wrong=(*NO_LIGHT, np.zeros((4, 8)))),
    "EnvironmentMap.north": kind(np.array([0.0, 1.0, 0.0]), "None", wrong=("123", (0, 0, 0), (inf, 0, 1), (0.0, 0.0, 2.0))),
    "radiance": kind(np.ones((4, 4)), "one less", wrong=NO_LIGHT),
    "sequences.get.name": kind("sobol", said=("sequence",)),
    "distributions.get.name": kind("ggx", said=("distribution",)),
    "value": kind("ggx(alpha=0.5)", said=("distribution",)),
    "view_factors.count": kind(COUNT, wrong=(0, 3, 2**24 + 1)),
    "replicates": kind(2, WHOLE, wrong=(0, 65)),
    "groups": kind(np.array([1, 0]), "texts", wrong=([-1, 0], [2**31 - 1, 0], [0.0, 1.0], "part", ["a"])),
    "reciprocal": kind(False, *FLAG),
    "first_face": kind(3, WHOLE, wrong=(2**62,)),
    "view_factors.active": kind(np.array([True, False]), "bool"),
    "emission": kind(np.ones(2), "float32(0.5)", WHOLE, "-1", "1.5", "no axis"),
    "temperature": kind(np.full(2, 280.0), "float32(0.5)", WHOLE, "1.5", "no axis", wrong=([-1.0, 0.0], [nan, 0.0])),
    "emissivity": kind(np.array([0.5, 0.9]), "float32(0.5)", "no axis", wrong=([0.5, 1.5], [0.5, 0.0])),
    "outside": kind(270.0, "float32(0.5)", WHOLE, "1.5", "no axis", wrong=([1.0, 2.0], -1.0)),
    "reflectance": kind(np.array([0.5, 0.1]), "float32(0.5)", "no axis", wrong=([0.5, 1.5], [0.5, nan])),
    "grid_points.spacing": kind(0.5, *POSITIVE, "2**70"),
    "grid_points.on": kind("ground"),
    "grid_points.faces": kind(np.array([True, False]), "bool"),
    "height": kind(1.0, *POSITIVE, "2**70"),
    "sample_surface.spacing": kind("random"),
    "radius": kind(0.5, *POSITIVE, "2**70", said=("count",)),
    "distributions.register.kind": kind(ws.GGX, wrong=(ws.GGX(0.5), ws.Mesh)),
    "twin": kind((np.add, np.add), wrong=((np.add,), np.add)),
    "transmittance": kind(np.array([0.5, 0.1]), "float32(0.5)", "no axis", wrong=([0.5, 1.5], [0.5, nan], [0.5, -0.1])),
    **{f"load_mesh.{name}": kind(0.5, "float32(0.5)", "no axis") for name in ("transmittance", "reflectance")},
    "ViewFactors.save.path": kind(Path(mkdtemp()) / "factors.npz"),
}
NEEDS = {  # to be of use
    "falloff": {"max_distance": 2.0},
    "data": {"integrand": radiance},
    "cosine": {"weights": np.ones(4)},
    "ViewFactors.radiosity.emission": {"reflectance": 0.5},
    "integrate.mesh": {"points": POINTS},
    "Mesh.part": {"parts": ("wall",)},
    "Mesh.parts": {"part": np.array([0, 0])},
    "City.surface_means.points": {"values": np.ones(4)},
    "integrate.max_distance": {"points": POINTS, "mesh": MESH},
    "load_mesh.transmittance": {"path": "courtyard"},  # not the .usd of others, which a process of its own reads
    "load_mesh.reflectance": {"path": "courtyard"},
}
NEEDS |= {  # one of the two
    f"sample_surface.{argument}": {"count": COUNT}
    for argument in signature(ws.sample_surface).parameters
    if argument not in ("count", "radius")
} | {"sample_surface.radius": {"spacing": "blue"}}
NEEDS |= {  # to be quick
    f"irradiation.{argument}": {"period": JUNE, "patches": "tregenza"}
    for argument in signature(ws.irradiation).parameters
    if argument not in ("period", "patches")
} | {f"sun_hours.{argument}": {"period": JUNE} for argument in signature(ws.sun_hours).parameters if argument != "period"}
NO_DEFAULT = {
    "ViewFactors.radiosity.reflectance",
    "UniformCone.cos_angle",
    "UniformCone.one_minus_cos",
    "integrate.data",
    "City.surface_means.points",
    "Mesh.part",
    "sample_surface.count",
    "sample_surface.radius",
}  # one of the two must be given


def kind_of(name, argument):
    return KINDS.get(f"{name}.{argument}") or KINDS[argument]


def values(example):
    """Values by label: those that nearly every argument refuses, and arrays with one fault each."""
    plain = {
        "None": None,
        "an object": object(),
        "text": "3",
        "bytes": b"3",
        "[]": [],
        "[[]]": [[]],
        "{}": {},
        "a set": {0.0, 1.0, 2.0},
        "a function": lambda *_: 1,
        "a type": float,
        "a path": Path("3"),
        "1j": 1j,
        "nan": nan,
        "inf": inf,
        "-1": -1,
        "2**70": 2**70,
        "10**5000": 10**5000,
        "1.5": 1.5,
        "True": True,
        "np.True_": np.True_,
        "float32(0.5)": np.float32(0.5),
        "Fraction(1, 2)": Fraction(1, 2),
        "int32(2)": np.int32(2),
        "np.ma.masked": np.ma.masked,
    }
    array = example if isinstance(example, np.ndarray) else np.ones((4, 3))
    rows = [row.tolist() if row.ndim else [row.item()] for row in array]
    return plain | {
        "masked": np.ma.masked_array(array),
        "masked rows": [np.ma.masked_array(row) for row in array],
        "complex": array.astype(complex),
        "objects": array.astype(object),
        "texts": array.astype(str),
        "bool": array.astype(bool),
        "times": np.zeros(array.shape, "datetime64[s]"),
        "records": np.zeros(array.shape, [("x", float)]),
        "one less": array[..., :-1],
        "one axis more": array[None, None],
        "no axis": np.array(array.ravel()[0]),
        "ragged": [*rows[:-1], [1.0, [2.0]]],
        "of Warp": wp.zeros(4, dtype=wp.int8, device="cpu"),
    }
