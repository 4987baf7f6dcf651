"""Fixtures that all tests share."""

import gc
import importlib.util
import os
import signal
import sys
from pathlib import Path

import numpy as np
import precision
import pytest
import trimesh
import warp as wp
from significance import ALPHA, STATISTICAL_TESTS

precision.watch()  # before our modules take what it replaces

import warpsample as ws  # noqa: E402
from warpsample import cli  # noqa: E402
from warpsample.plotting import rendering  # noqa: E402

wp.config.log_level = wp.LOG_WARNING
wp.init()

_made = []


def pytest_collection_modifyitems(config, items):
    """Leaves thorough tests to `-m thorough`, also those in files that are slow as a whole."""
    if "thorough" not in config.option.markexpr:
        left = [item for item in items if item.get_closest_marker("thorough")]
        config.hook.pytest_deselected(items=left)
        items[:] = [item for item in items if not item.get_closest_marker("thorough")]


def pytest_collection_finish():
    """Keeps modules and tests out of each later collection of garbage, which would look at a million objects."""
    gc.collect()
    gc.freeze()


@pytest.fixture
def plausible():
    """Asserts that a p-value is not below the suite's level."""

    def check(p_value: float) -> None:
        _made.append(p_value)
        assert len(_made) <= STATISTICAL_TESTS
        assert p_value >= ALPHA

    return check


@pytest.fixture(scope="session")
def bunny_path() -> Path:
    return Path(wp.__file__).parent / "examples" / "assets" / "bunny.usd"


@pytest.fixture(scope="session")
def bunny(bunny_path) -> ws.Mesh:
    return ws.load_mesh(bunny_path)


@pytest.fixture(scope="session")
def points(bunny) -> ws.SurfacePoints:
    """600 points on the bunny."""
    return ws.sample_surface(bunny, 600, seed=1)


@pytest.fixture(scope="session")
def some(points) -> ws.SurfacePoints:
    """300 points, one of them nowhere and one without a normal."""
    position, normal = points.position[:300].copy(), points.normal[:300].copy()
    position[7], normal[250] = np.nan, 0.0
    return ws.SurfacePoints(position, normal, points.face[:300])


@pytest.fixture
def normals() -> np.ndarray:
    """1,000 random directions of random length."""
    rng = np.random.default_rng(1)
    return (rng.normal(size=(1000, 3)) * rng.uniform(0.1, 10.0, size=(1000, 1))).astype(np.float32)


@pytest.fixture(scope="session")
def repository() -> Path:
    return Path(__file__).parents[1]


@pytest.fixture
def child_environment() -> dict[str, str]:
    """The environment of child processes: no window, and plain output."""
    return {key: value for key, value in os.environ.items() if key not in ("DISPLAY", "WAYLAND_DISPLAY", "FORCE_COLOR")}


@pytest.fixture
def cube(tmp_path):
    path = tmp_path / "cube.ply"
    trimesh.creation.box().export(path)
    return path


@pytest.fixture
def call(monkeypatch, capsys):
    """Runs `warpsample ...`; returns (exit status, stdout, stderr)."""

    def run(*arguments):
        monkeypatch.setattr(sys, "argv", ["warpsample", *map(str, arguments)])
        with pytest.raises(SystemExit) as stop:
            cli.main()
        return stop.value.code, *capsys.readouterr()

    return run


@pytest.fixture
def handlers_as_before():
    """SIGINT raises KeyboardInterrupt in the test. No event loop of another test hears it: its pipe would fill."""
    before, pipe = signal.signal(signal.SIGINT, signal.default_int_handler), signal.set_wakeup_fd(-1)
    yield
    signal.signal(signal.SIGINT, before)
    signal.set_wakeup_fd(pipe, warn_on_full_buffer=False)


@pytest.fixture(scope="session")
def can_render():
    """Skips if no picture can be made, and keeps pictures off-screen."""
    try:
        rendering.check_rendering()
    except RuntimeError as error:
        pytest.skip(str(error))


@pytest.fixture(scope="session")
def script(repository):
    """Loads a script of viz/ by its name."""

    def load(name):
        specification = importlib.util.spec_from_file_location(name, repository / "viz" / f"{name}.py")
        module = importlib.util.module_from_spec(specification)
        specification.loader.exec_module(module)
        return module

    return load
