"""What is pickled arrives with the same content, and a process has one mesh and one tree for each content."""

import copy
import gc
import pickle
import threading
from dataclasses import fields, is_dataclass

import numpy as np
import pytest
import trimesh

import warpsample as ws
from warpsample.host import shared_values
from warpsample.tracing.scene import scene_of

BOX = trimesh.creation.box()


def box(scale=1.0):
    return ws.Mesh(scale * BOX.vertices, BOX.faces)


def arrive(mesh, protocol=pickle.HIGHEST_PROTOCOL):
    """The mesh as another process gets it: one that has never had it."""
    pickled = pickle.dumps(mesh, protocol)
    shared_values._values.pop(mesh.digest)
    return [pickle.loads(pickled), pickle.loads(pickled)]


def assert_same(one, other):
    assert type(one) is type(other)
    if isinstance(one, np.ndarray):
        assert one.dtype == other.dtype
        assert np.array_equal(one, other)
    elif is_dataclass(one):
        for item in fields(one):
            assert_same(getattr(one, item.name), getattr(other, item.name))
    else:
        assert one == other


@pytest.mark.parametrize("protocol", range(pickle.HIGHEST_PROTOCOL + 1))
def test_one_mesh_arrives_for_each_content(protocol):
    mesh = box()
    first, second = arrive(mesh, protocol)
    assert first is second is not mesh
    assert_same(first, mesh)
    assert arrive(box(2.0))[0] is not first


def test_its_tree_stays_where_it_was_built():
    mesh = box(3.0)
    ws.trace(mesh, [0.0, 0.0, 9.0], [[0.0, 0.0, -1.0]])
    assert len(pickle.dumps(mesh)) < mesh.vertices.nbytes + mesh.faces.nbytes + 1000
    first, second = arrive(mesh)
    assert scene_of(first) is scene_of(second) is not scene_of(mesh)


def test_where_it_came_from_it_is_itself():
    mesh = box(4.0)
    assert pickle.loads(pickle.dumps(mesh)) is mesh
    assert copy.deepcopy(mesh) is mesh


def test_threads_get_the_same(monkeypatch):
    mesh, made = box(5.0), []
    pickled = pickle.dumps(mesh)
    shared_values._values.pop(mesh.digest)
    checked = ws.Mesh.__post_init__
    monkeypatch.setattr(ws.Mesh, "__post_init__", lambda self: (made.append(1), checked(self))[1])
    found, barrier = [], threading.Barrier(8)

    def work():
        barrier.wait()
        found.append(pickle.loads(pickled))

    threads = [threading.Thread(target=work) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(made) == 1
    assert len({id(mesh) for mesh in found}) == 1


def test_only_the_last_few_are_kept():
    digests = []
    for k in range(2 * shared_values._KEPT):
        mesh = box(10.0 + k)
        digests.append(mesh.digest)
        arrive(mesh)
    del mesh
    gc.collect()
    assert [digest in shared_values._values for digest in digests] == [False] * shared_values._KEPT + [
        True
    ] * shared_values._KEPT


def test_a_digest_tells_every_content_apart():
    vertices = np.arange(12.0).reshape(4, 3)
    faces = np.array([[0, 1, 2], [1, 3, 2]])
    nudged = vertices.copy()
    nudged[2, 1] = np.nextafter(nudged[2, 1], 9.0)
    meshes = [(vertices, faces), (nudged, faces), (vertices, faces[:1]), (vertices, faces[:, [1, 2, 0]])]
    assert len({ws.Mesh(*mesh).digest for mesh in meshes}) == len(meshes)
    assert ws.Mesh(vertices, faces).digest == ws.Mesh(vertices.tolist(), faces.astype(np.uint8)).digest


def test_all_else_arrives_as_it_was():
    mesh = ws.load_mesh("courtyard")
    points = ws.sample_surface(mesh, 20, barycentric=True)
    held = [
        points,
        ws.ambient_occlusion(mesh, points, 32),
        ws.sky_view_factor(mesh, points, 32),
        ws.trace(mesh, points, points.normal),
        ws.sample_directions(points, 4, pdf=True),
        *(case for kind in ws.distributions.classes().values() for case in kind.cases()),
        mesh.report,
    ]
    for value in held:
        assert_same(pickle.loads(pickle.dumps(value)), value)
