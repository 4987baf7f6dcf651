"""The records of quantities: each is whole, and the command line and the READMEs say what they say."""

import re
from dataclasses import fields, replace
from inspect import Parameter, signature

import numpy as np
import pytest

import warpsample as ws
from warpsample.cli.bake import OPTIONS, bake_command
from warpsample.estimate.quantities.record import ARGUMENTS
from warpsample.output import quantities as registry

QUANTITIES = registry.quantities()


@pytest.mark.parametrize("name", QUANTITIES)
def test_a_record_fits_its_call(name):
    quantity = QUANTITIES[name]
    assert quantity.name == name
    assert list(signature(quantity.call).parameters)[:2] == ["mesh", "points"]
    assert signature(quantity.call).return_annotation in (quantity.result, *quantity.result.__mro__[1:-1])
    needed = {option for option, default in quantity.parameters.items() if default is Parameter.empty}
    assert needed == {ARGUMENTS.get(option, option) for option in quantity.files}
    assert {"value", "standard_error", "rays", "status"} <= set(quantity.arrays)
    assert set(quantity.shared) <= {item.name for item in fields(quantity.result)}
    assert all(quantity.takes(option) for option in ("seed", "workers", "first_point"))


def test_every_call_of_estimate_is_public():
    assert {quantity.call.__name__ for quantity in QUANTITIES.values() if quantity.in_stores} <= set(ws.__all__)


def test_every_option_of_the_command_line_is_for_some_quantity(call):
    assert all(registry.quantities_with(name) for name, option in OPTIONS.items() if option.by_quantity)
    help_text = call("bake", "--help")[1]
    assert all(name in help_text.replace("\n", "") for name in ("sky-matrix", "--max-distance", "--ground-albedo"))


@pytest.mark.parametrize(
    ("option", "text"),
    [
        (
            "samples",
            (
                "Number of rays per point. Default: 256, or 1024 for irradiation and sky-matrix. "
                "Not for position, normals, thickness, sun-hours."
            ),
        ),
        (
            "ground_albedo",
            "Fraction of light that the ground around the mesh reflects, 0 to 1. Default: 0.2. Only for irradiation.",
        ),
        (
            "north",
            (
                "Direction of north; 0 0 -1 for files with +y up. Default: 0 1 0. "
                "Only for irradiation, sky-matrix, sun-hours."
            ),
        ),
        (
            "period",
            (
                "First and last day of the period, such as 06-01 08-31, or with hours, 03-21T09 03-21T15. "
                "Default: the whole year. Only for irradiation, sun-hours."
            ),
        ),
    ],
)
def test_the_help_of_an_option_says_its_default_and_whom_it_is_for(option, text):
    kind = signature(bake_command).parameters[option].annotation
    assert kind.__metadata__[0].help == text


def test_options_that_do_not_apply_are_refused_and_files_asked_for():
    registry.check_options(QUANTITIES["ao"], {"seed": 0, "samples": 2, "falloff": 1.0})
    for name, options, message in [
        (
            "ao",
            {"up": (0, 0, 1)},
            r"--up: got \(0, 0, 1\) for ao; the option applies only to sky, visible-sky, irradiance, irradiation, sky-mat",
        ),
        (
            "sun-hours",
            {"weather": "athens", "samples": 2},
            "--samples: got 2 for sun-hours; the option applies only to ao, bent",
        ),
        ("sky", {"ground_albedo": 0.1}, "--ground-albedo: got 0.1 for sky; the option applies only to irradiation$"),
        ("irradiance", {"seed": 0}, "--environment: got None for irradiance, want a picture"),
    ]:
        with pytest.raises(ValueError, match=f"^{message}"):
            registry.check_options(QUANTITIES[name], options)
    with pytest.raises(ValueError, match="^quantity: got 'light', want one of ao, bent-normals"):
        registry.quantity_of("light")


def test_the_tables_of_the_readmes_are_those_of_the_records(repository):
    for room, table in (("estimate", registry.call_table()), ("output", registry.name_table())):
        assert table in (repository / "warpsample" / room / "README.md").read_text()


def test_the_example_of_how_to_add_one_is_its_source(repository):
    room = repository / "warpsample" / "estimate"
    (shown,) = re.findall(r"^```py\n(.*?)^```", (room / "README.md").read_text(), flags=re.DOTALL | re.MULTILINE)
    source = (room / "quantities" / "mean_distance.py").read_text().replace("    found =", "found =")
    found, record = re.sub(r"  # .*", "", shown).split("\n\n\n")
    assert f"{found}\n" in source
    assert source.endswith(record)


def test_colours_go_from_black_to_white():
    values = np.float32([-1.0, 0.0, 0.5, 4.0])
    found = ws.Estimate(values, *(None,) * 6)
    for black, white, shades in ((0.0, 1.0, [0, 0, 32, 255]), (-1.0, 1.0, [0, 51, 76, 255]), (0.0, 9.0, [0, 0, 14, 113])):
        quantity = replace(QUANTITIES["ao"], black=black, white=white)
        assert quantity.colours(found).tolist() == [[shade] * 3 + [255] for shade in shades]
    nothing = ws.Estimate(np.zeros(2, np.float32), *(None,) * 6)
    assert QUANTITIES["mean-distance"].colours(nothing)[:, 0].tolist() == [0, 0]


def test_values_of_three_components_have_letters():
    three, one = np.zeros((2, 3)), np.zeros(2)
    found = ws.Estimate(three, three, three, three, one, one, ws.Skipped())
    letters = [f"{name}_{letter}" for name in ("value", "standard_error") for letter in "xyz"]
    assert list(QUANTITIES["bent-normals"].columns(found)) == [*letters, "rays", "status"]
