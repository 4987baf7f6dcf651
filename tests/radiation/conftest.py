"""What tests of irradiation share: a year, and a courtyard with points."""

import pytest
from weather_files import write_epw

import warpsample as ws


@pytest.fixture(scope="module")
def athens(tmp_path_factory):
    return write_epw(tmp_path_factory.mktemp("weather") / "athens.epw")


@pytest.fixture(scope="module")
def yard():
    mesh = ws.load_mesh("courtyard")
    return mesh, ws.sample_surface(mesh, 60, seed=4)
