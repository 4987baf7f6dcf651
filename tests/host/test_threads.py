"""Calls from any thread and after a fork give the kernels, trees and results of a single thread."""

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from hangs import HANGS

import warpsample as ws
from warpsample.host.locks import once, once_property


@pytest.fixture
def alone(child_environment):
    """Runs a task of parallel.py in its own process, which may crash or hang without affecting the suite."""

    def run(*task):
        command = [sys.executable, "-X", "faulthandler", str(Path(__file__).parents[1] / "support" / "parallel.py"), *task]
        done = subprocess.run(command, capture_output=True, text=True, timeout=HANGS, env=child_environment, check=False)
        assert done.returncode == 0, done.stderr

    return run


TASKS = dict.fromkeys(("first_use", "new_meshes"), pytest.mark.slow) | dict.fromkeys(
    ("faces_changed", "refits", "debugged"), pytest.mark.thorough
)


@pytest.mark.parametrize("task", [pytest.param(task, marks=mark) for task, mark in TASKS.items()])
def test_threads_answer_as_one(alone, task):
    alone(task)


@pytest.mark.slow
@pytest.mark.parametrize("method", ["fork", *(pytest.param(m, marks=pytest.mark.thorough) for m in ("spawn", "forkserver"))])
def test_processes_answer_after_their_parent_has_used_threads(alone, method):
    alone("processes", method)


@pytest.mark.thorough  # the first use above has slices, and the test above has processes
def test_a_pool_answers_slices_after_its_parent_has_used_threads(alone):
    alone("slices")


@pytest.mark.slow
def test_a_fork_waits_for_what_is_being_made(alone):
    alone("fork_while_making")


@pytest.mark.slow
@pytest.mark.skipif(not hasattr(os, "fork"), reason="there is no fork")
def test_a_fork_waits_for_a_matrix_product(alone):
    alone("fork_while_multiplying")


@pytest.mark.thorough
def test_sixteen_threads_for_a_minute(alone):
    alone("stress")


def test_what_is_made_once_is_made_once():
    made = []

    class Owner:
        @once_property
        def numbers(self):
            """Some."""
            made.append(self)
            return np.arange(3)

    owner, others = Owner(), Owner()
    assert owner.numbers is owner.numbers
    assert others.numbers is not owner.numbers
    assert made == [owner, others]
    with pytest.raises(ValueError, match="read-only"):
        owner.numbers[0] = 1
    with pytest.raises(ValueError, match="WRITEABLE"):
        owner.numbers.flags.writeable = True
    assert Owner.numbers.__doc__ == "Some."

    @once
    def double(x, times=2):
        made.append(x)
        return [x] * times

    assert double(3) is double(3)
    assert double(3, times=4) is double(3, times=4)
    assert double(3) is not double(3, times=4)
    assert made[2:] == [3, 3]


# What a mesh has checked, it owns


def test_a_mesh_does_not_see_what_happens_to_the_callers_arrays():
    vertices, faces = np.eye(3), np.array([[0, 1, 2]], np.int32)
    mesh = ws.Mesh(vertices, faces)
    before = ws.sample_surface(mesh, 10).position, ws.trace(mesh, [1.0, 1.0, 1.0], [[-1.0, -1.0, -1.0]]).distance
    vertices[:] = np.nan
    faces[:] = 2**30
    assert np.array_equal(mesh.vertices, np.eye(3))
    assert np.array_equal(mesh.faces, [[0, 1, 2]])
    after = ws.sample_surface(mesh, 10).position, ws.trace(mesh, [1.0, 1.0, 1.0], [[-1.0, -1.0, -1.0]]).distance
    assert all(np.array_equal(a, b) for a, b in zip(before, after, strict=True))
    for name in ("vertices", "faces", "face_normals", "face_areas", "vertex_normals", "cross_products"):
        array = getattr(mesh, name)
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 0
        with pytest.raises(ValueError, match="WRITEABLE"):
            array.flags.writeable = True


def test_results_do_not_alias_the_mesh():
    mesh = ws.Mesh(np.eye(3), [[0, 1, 2]])
    for points in (ws.vertex_points(mesh), ws.face_centers(mesh), ws.sample_surface(mesh, 5)):
        points.position[:] = np.nan
        points.normal[:] = 0.0
    assert np.array_equal(ws.vertex_points(mesh).position, np.eye(3))
    assert np.abs(ws.face_centers(mesh).normal - 3.0**-0.5).max() <= 1e-7


def test_a_copied_mesh_is_frozen_too():
    import copy
    import pickle

    mesh = ws.Mesh(np.eye(3), [[0, 1, 2]])
    ws.trace(mesh, [1.0, 1.0, 1.0], [[-1.0, -1.0, -1.0]])
    for again in (copy.deepcopy(mesh), pickle.loads(pickle.dumps(mesh))):
        assert np.array_equal(again.vertices, mesh.vertices)
        with pytest.raises(ValueError, match="read-only"):
            again.faces[0, 0] = 2**30
        assert ws.trace(again, [1.0, 1.0, 1.0], [[-1.0, -1.0, -1.0]]).face[0] == 0
