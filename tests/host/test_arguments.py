"""Every argument of every public function gets all wrong values: the error names it, and is not NumPy's or Warp's."""

import inspect
import traceback
from enum import Enum
from functools import partial
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
import pyvista as pv
import warp as wp
from argument_examples import COUNT, FACES, MESH, NEEDS, NO_DEFAULT, POINTS, TEXELS, UNIT, VERTICES, kind_of, values
from scipy.sparse import csr_array

import warpsample as ws
from warpsample.distributions.record import Distribution
from warpsample.estimate.result import PointResult
from warpsample.output.quantities import quantities

PACKAGE = Path(ws.__file__).parent
RESULTS = (
    ws.City,
    ws.CitySurfaces,
    ws.Directions,
    ws.Estimate,
    ws.AllHits,
    ws.Hits,
    ws.Interval,
    ws.MeshReport,
    ws.NetRadiation,
    ws.Skipped,
    ws.SkyPatches,
    ws.SkySkipped,
    ws.TexturePoints,
    ws.TextureReport,
    ws.ViewFactors,
    *(quantity.result for quantity in quantities().values()),
)  # which users read and do not make
FOR_PROOFS = (
    "seam",
    "bound_maps",
    "kernel_parameters",
    "kernel_values",
)  # take what `sample` has taken, or what the package passes
PLANE = pv.PolyData.from_regular_faces(VERTICES, FACES)
HALVES = csr_array(np.full((2, 2), 0.5))
CITY = ws.load_city("courtyard")
EXAMPLES = {
    ws.City: CITY,
    ws.CitySurfaces: CITY.surfaces,
    ws.Directions: ws.Directions(np.zeros((4, COUNT, 3), np.float32), None, np.zeros(4, np.uint8)),
    ws.Estimate: ws.Estimate(*np.zeros((4, 4), np.float32), np.zeros(4, int), np.zeros(4, np.uint8), ws.Skipped()),
    ws.EnvironmentMap: ws.EnvironmentMap(np.ones((2, 4))),
    ws.GGX: ws.GGX(0.5),
    ws.Mesh: MESH,
    ws.Mixture: ws.Mixture([ws.GGX(0.5), ws.EnvironmentMap(np.ones((2, 4)))], [1.0, 2.0]),
    ws.SkyMatrix: ws.SkyMatrix(
        *np.zeros((2, 4, 145), np.float32), *np.zeros((2, 4), np.uint8), ws.SkySkipped(), ws.sky_patches()
    ),
    ws.SurfacePoints: POINTS,
    ws.NetRadiation: ws.NetRadiation(*np.zeros((3, 2))),
    ws.TexturePoints: TEXELS,
    ws.ViewFactors: ws.ViewFactors(
        HALVES, HALVES, *np.zeros((5, 2)), np.full(2, COUNT), np.zeros(2, np.uint8), ws.Skipped()
    ),
}
VIA = {  # whose arguments **options are
    type(PLANE.warpsample).sample_directions: ws.sample_directions,
    **{
        getattr(type(PLANE.warpsample), quantity.call.__name__): quantity.call
        for quantity in quantities().values()
        if quantity.in_stores
    },
}


def targets():
    """(name, function) of the public functions, constructors and methods."""
    for name in ws.__all__:
        item = getattr(ws, name)
        if isinstance(item, ModuleType):
            own = inspect.getmembers(item, lambda f, module=item: getattr(f, "__module__", "") == module.__name__)
            yield from ((f"{name}.{key}", f) for key, f in own if inspect.isfunction(f) and not key.startswith("_"))
        elif not inspect.isclass(item):
            yield name, item
        elif not issubclass(item, Enum):
            if item not in RESULTS:
                yield name, item
            yield from methods(name, item, EXAMPLES.get(item))
    yield from methods("Distribution", Distribution, EXAMPLES[ws.GGX])
    yield from methods("PointResult", PointResult, EXAMPLES[ws.Estimate])
    yield from methods("accessor", type(PLANE.warpsample), PLANE.warpsample)


def methods(name, owner, example):
    for key, function in vars(owner).items():
        if inspect.isfunction(function) and not key.startswith("_") and key not in FOR_PROOFS:
            yield f"{name}.{key}", getattr(example, key, function)


def parameters(function):
    """All arguments of a function by name, including those through **options."""
    found = {}
    for name, parameter in inspect.signature(function).parameters.items():
        if parameter.kind is inspect.Parameter.VAR_KEYWORD:
            inner = parameters(VIA[function.__func__])
            passed = ("mesh", "points", "count", "normals", "distribution")  # on, by the function itself
            found = {**{key: p for key, p in inner.items() if key not in passed}, **found}
        else:
            found[name] = parameter
    return found


CALLS = dict(targets())
CASES = [(name, argument) for name, function in CALLS.items() for argument in parameters(function)]
COMPILED = ("direct_sun-disc", "integrate-max_distance", "integrate-mesh")  # for these alone: seconds


def fault_of(call, value, valid, said):
    """The fault in the reaction of a call to a value; "" if there is none."""
    try:
        call(value)
    except (TypeError, ValueError, FileNotFoundError) as error:
        where = Path(traceback.extract_tb(error.__traceback__)[-1].filename)
        named = str(error).startswith(tuple(f"{name}: got " for name in said))
        right = named and where.is_relative_to(PACKAGE) and "\n" not in str(error) and not valid
        return "" if right else f"{type(error).__name__} in {where.name}: {error}"
    except Exception as error:  # what a fault may be
        return f"{type(error).__name__}: {error}"
    return "" if valid else "no error"


def faults(name, argument):
    """(label, fault) for all values of one argument, with valid values for the others."""
    function, own = CALLS[name], kind_of(name, argument)
    takes = parameters(function)
    needed = {key: kind_of(name, key).good for key, p in takes.items() if p.default is p.empty}
    needed |= NEEDS.get(f"{name}.{argument}") or NEEDS.get(argument, {})
    optional = takes[argument].default is None and f"{name}.{argument}" not in NO_DEFAULT
    valid = own.valid | {"good"} | ({"None"} if optional else set())
    tried = {**values(own.good), "good": own.good, **{f"wrong {i}": value for i, value in enumerate(own.wrong)}}

    def call(value):
        return function(**{**needed, argument: value})

    found = {label: fault_of(call, value, label in valid, (argument, *own.said)) for label, value in tried.items()}
    return {label: fault for label, fault in found.items() if fault}


def slow_where_compiled(cases):
    for case in cases:
        name = "-".join(case)
        yield pytest.param(*case, id=name, marks=[pytest.mark.slow] if name in COMPILED else [])


@pytest.mark.filterwarnings("ignore:temperature. got at most")
@pytest.mark.parametrize(("name", "argument"), list(slow_where_compiled(CASES)))
def test_a_wrong_argument_is_named(name, argument):
    assert faults(name, argument) == {}


def test_the_sweep_is_over_everything():
    swept = {name for name, _ in CASES}
    assert {f"distributions.{key}" for key in ("get", "as_distribution", "as_spatial")} <= swept
    assert {"Distribution.sample", "Distribution.pdf", "Distribution.invert", "Distribution.cdf"} <= swept
    assert {"Directions.to_polydata", "PointResult.to_polydata", "accessor.sky_view_factor", "UniformCone", "Mesh"} <= swept
    without = {name for name in CALLS if name not in swept}
    assert {name for name in without if inspect.signature(CALLS[name]).parameters} == set()
    assert ("bent_normals", "tolerance") in CASES
    assert ("accessor.sky_view_factor", "tracer") in CASES


@pytest.mark.parametrize(
    ("wrong", "fault"),
    [
        (bool, "no error"),
        (lambda value: np.asarray([[value], [1, 2]]), "ValueError"),
        (wp.get_device, "ValueError in"),
        (lambda value: ws.sample_square(value, 1, 1), "ValueError in arguments.py: sequence: got"),
        (lambda value: {}[value], "KeyError"),
    ],
)
def test_the_sweep_finds_what_is_wrong(wrong, fault):
    """It finds no error, NumPy's own error, Warp's own, one that names another argument, and another kind of error."""
    assert fault_of(wrong, "no", valid=False, said=("skip",)).startswith(fault)


def test_what_is_valid_may_not_be_refused():
    assert fault_of(lambda value: ws.sample_square(value, 1, 1), "no", valid=True, said=("sequence",)) != ""


@pytest.mark.parametrize("function", [ws.sky_view_factor, ws.bent_normals, partial(ws.irradiance, radiance=[[1.0]])])
def test_unknown_options_name_the_function_that_was_called(function):
    name = getattr(function, "func", function).__name__
    with pytest.raises(TypeError, match=rf"^falloff: got an argument that {name} does not take, want one of mesh, points,"):
        function(MESH, POINTS, falloff=1.0)


@pytest.mark.parametrize("name", ["sample_directions", "ambient_occlusion", "sky_view_factor"])
def test_the_accessor_names_unknown_options(name):
    said = (
        rf"^tolerence: got an argument that {name} does not take|^{name}\(\) got an unexpected keyword argument 'tolerence'"
    )
    with pytest.raises(TypeError, match=said):
        getattr(PLANE.warpsample, name)(2, tolerence=0.1)


@pytest.mark.parametrize(
    "call",
    [
        lambda **active: ws.sample_directions(UNIT, COUNT, **active),
        lambda **active: ws.sample_directions(wp.array(UNIT, dtype=wp.vec3, device="cpu"), COUNT, **active),
        *(
            partial(function, MESH, POINTS, COUNT)
            for function in (ws.ambient_occlusion, ws.sky_view_factor, ws.bent_normals)
        ),
        partial(ws.irradiance, MESH, POINTS, np.ones((2, 2)), COUNT),
    ],
)
@pytest.mark.parametrize(
    ("active", "kind", "got"),
    [
        ([1, 0, 1, 1], TypeError, "dtype int64"),
        ([1.0, 0.0, 1.0, 1.0], TypeError, "dtype float64"),
        ([1, 0, 1], TypeError, "dtype int64"),
        ("yes", TypeError, "'yes'"),
        (wp.zeros(4, dtype=wp.float32, device="cpu"), TypeError, "dtype float32"),
        (True, ValueError, r"shape \(\)"),
        ([True] * 3, ValueError, r"shape \(3,\)"),
        ([[True] * 4], ValueError, r"shape \(1, 4\)"),
        (wp.zeros(3, dtype=wp.bool, device="cpu"), ValueError, r"shape \(3,\)"),
    ],
)
def test_a_wrong_active_mask_is_the_same_error_everywhere(call, active, kind, got):
    with pytest.raises(kind, match=rf"^active: got {got}, want an array of bool of shape \(4,\), one for each point$"):
        call(active=active)


def test_points_become_what_is_worked_with():
    points = ws.SurfacePoints([[0, 0, 1]], np.array([[0, 0, 2]], np.float16), np.array([1], np.uint8), [[1, 0, 0]])
    kinds = [a.dtype for a in (points.position, points.normal, points.face, points.barycentric)]
    assert kinds == [np.float64, np.float64, np.int32, np.float64]
    assert ws.ambient_occlusion(MESH, points, COUNT).status.tolist() == [0]
    kept = ws.SurfacePoints(UNIT, UNIT)
    assert kept.position.dtype == kept.normal.dtype == np.float32
    assert kept.face.tolist() == [-1] * 4


@pytest.mark.parametrize("tolerance", [None, 0.1])
@pytest.mark.parametrize("estimate", [ws.ambient_occlusion, ws.sky_view_factor, ws.bent_normals])
def test_no_points_are_no_numbers(estimate, tolerance):
    none = ws.SurfacePoints(np.empty((0, 3)), np.empty((0, 3)))
    found = estimate(MESH, none, COUNT, tolerance=tolerance)
    assert found.value.shape == found.standard_error.shape == ((0, 3) if estimate is ws.bent_normals else (0,))
    assert (found.value.dtype, found.rays.shape, found.counts(), found.skipped) == (np.float32, (0,), {}, ws.Skipped())


def test_long_values_are_cut():
    with pytest.raises(
        TypeError, match=r"^count: got \[0, 1, 2, .*\.\.\., want a whole number from 1 to 2147483647$"
    ) as raised:
        ws.sample_square("sobol", 1, list(range(1000)))
    assert len(str(raised.value)) <= 200
