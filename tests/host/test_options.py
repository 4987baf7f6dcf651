"""Options that calls share: one text, one type and one default each, in help, in editors and at run time."""

import ast
import inspect
import re
from importlib import import_module

import numpy as np
import pytest
from docstrings import sections

import warpsample as ws
from warpsample.host.options import DEFAULTS, CallOptions, RayKeywords, with_options
from warpsample.tracing.options import RayOptions
from warpsample.tracing.tracers import BUILTIN, WIDE

OWN = {
    "active": (ws.sample_directions, ws.view_factors),
    "count": (ws.rasters.sky_view_factor, ws.rasters.visible_sky),
    "device": (ws.sample_directions, ws.trace, ws.tree),
    "first_point": (ws.to_frame,),
    "sequence": (ws.sample_directions, ws.sample_square),
}
"""Options that mean something else in these calls."""


def texts():
    """{field: text} of all TypedDicts of options, whose texts stand below the fields."""
    found = {}
    for name in ("warpsample.host.options", "warpsample.city.keywords"):
        for node in ast.walk(ast.parse(inspect.getsource(import_module(name)))):
            if isinstance(node, ast.ClassDef) and node.name.endswith("Keywords"):
                pairs = [pair for pair in zip(node.body, node.body[1:], strict=False) if isinstance(pair[0], ast.AnnAssign)]
                found |= {field.target.id: " ".join(text.value.value.split()) for field, text in pairs}
    return found


TEXTS = texts()
CALLS = [getattr(ws, name) for name in ws.__all__ if inspect.isfunction(getattr(ws, name))]
RASTERS = [ws.rasters.sky_view_factor, ws.rasters.visible_sky, ws.rasters.irradiation, ws.rasters.sun_hours]
LOBES = [ws.ambient_occlusion, ws.sky_view_factor, ws.visible_sky, ws.bent_normals, ws.mean_distance, ws.irradiance]
SHOWING = [*LOBES, ws.integrate, ws.sky_matrix, ws.irradiation, ws.direct_sun, ws.view_factors, *RASTERS]


def arguments(call):
    """{argument: text} of a docstring."""
    found = re.split(r"^ {4}(\w+): ", sections(call)["Args"], flags=re.MULTILINE)[1:]
    return {name: " ".join(text.split()) for name, text in zip(found[::2], found[1::2], strict=True)}


def written(default):
    """A default as texts have it."""
    return repr(default).replace("'", '"')


@pytest.mark.parametrize("call", [*CALLS, *RASTERS], ids=lambda call: f"{call.__module__}.{call.__name__}")
def test_a_shared_option_has_the_same_text_in_each_docstring(call):
    """More may follow the text. Only rasters share what is not in `DEFAULTS`."""
    for name, text in arguments(call).items():
        if name in (TEXTS if call in RASTERS else DEFAULTS) and call not in OWN.get(name, ()):
            assert text.startswith(TEXTS[name])


@pytest.mark.parametrize("call", SHOWING, ids=lambda call: f"{call.__module__}.{call.__name__}")
def test_help_shows_each_option_with_its_type_and_default(call):
    parameters = inspect.signature(call).parameters.values()
    described, given = arguments(call), [p for p in parameters if p.default is not p.empty]
    assert {"seed", "workers"} <= {p.name for p in given}
    assert all(p.kind is not p.VAR_KEYWORD and p.annotation is not p.empty for p in parameters)
    for parameter in given:
        assert f"Default: {written(parameter.default)}" in described[parameter.name], parameter.name


def test_defaults_are_those_of_the_checks():
    functions = (RayOptions.of, CallOptions.of, import_module("warpsample.host.options")._ways)
    parameters = [p for f in functions for p in inspect.signature(f).parameters.values()]
    checked = {p.name: p.default for p in parameters if p.default is not p.empty}
    own = {"ids", "given", "argument"}  # of callers in the package
    assert {name: value for name, value in checked.items() if name not in own} | {"tolerance": None} == DEFAULTS
    assert all(f"Default: {written(value)}" in TEXTS[name] for name, value in DEFAULTS.items())


def test_a_decorated_function_refuses_other_options():
    @with_options(RayKeywords)
    def call(mesh, **options):
        return mesh, options

    assert call(1, seed=2) == (1, {"seed": 2})
    assert str(inspect.signature(call)).startswith("(mesh, *, sequence: str = 'fibonacci', seed: int = 0, first_point")
    with pytest.raises(
        TypeError, match=r"^cores: got an argument that call does not take, want one of mesh, sequence, seed, .*, progress$"
    ):
        call(1, cores=2)


@pytest.mark.parametrize(
    ("call", "name"), [(ws.sky_matrix, "tracer"), (ws.irradiation, "tolerance"), (ws.bent_normals, "up")]
)
def test_an_option_of_another_call_is_refused(call, name):
    with pytest.raises(
        TypeError, match=f"^{name}: got an argument that {call.__name__} does not take, want one of mesh, points, "
    ):
        call(None, None, **{name: 1})


def test_a_record_is_checked_in_two_steps():
    drawn = RayOptions.of(3, sequence="r2", seed=5, first_point=7, active=[True, False, True])
    assert (drawn.sequence.name, drawn.seed, drawn.first_point, drawn.active.tolist()) == ("r2", 5, 7, [1, 0, 1])
    assert (drawn.skip, drawn.tracer, drawn.progress) == (True, WIDE, False)
    cast = drawn.replace(skip=np.False_, tracer="warp", workers=2, progress=True)
    assert (cast.seed, cast.sequence, cast.active) == (drawn.seed, drawn.sequence, drawn.active)
    assert (cast.skip, cast.tracer, cast.workers, cast.progress) == (False, BUILTIN, 2, True)
    with pytest.raises(TypeError, match="unexpected keyword argument 'cores'"):
        CallOptions.of(3).replace(cores=2)
