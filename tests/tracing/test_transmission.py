"""Rays through faces that transmit: products of what they cross, up to the first opaque face."""

import numpy as np
import pytest
import warp as wp
from meshes import aimed, icosphere, loose, planes, random_rays, soup

import warpsample as ws
from warpsample import funcs

pytestmark = pytest.mark.slow  # kernels of their own

wp.set_module_options({"enable_backward": False})


@wp.kernel
def ask(
    tree: funcs.Tree,
    origins: wp.array[wp.vec3d],
    directions: wp.array[wp.vec3],
    limit: float,
    share: wp.array[wp.float32],
    met: wp.array[wp.int32],
):
    i = wp.tid()
    share[i] = funcs.transmitted(tree, origins[i], directions[i], limit)
    met[i] = wp.where(funcs.any_hit(tree, origins[i], directions[i], limit), 1, 0)


def mixed(seed=5):
    """A soup of which a third is opaque, some lets all through, the rest a part."""
    rng = np.random.default_rng(seed)
    tau = rng.uniform(0.2, 0.9, 400).astype(np.float32)
    tau[rng.random(400) < 0.3] = 0.0
    tau[rng.random(400) < 0.1] = 1.0
    return ws.as_mesh(soup(), transmittance=tau)


def products(mesh, origins, directions, reach=np.inf):
    """(distance, face) of the first opaque face and the product before it, from all hits, one by one."""
    found = ws.trace_all(mesh, origins, directions, max_distance=None if reach == np.inf else reach)
    distance, face, share = (np.full(len(directions), x) for x in (np.inf, -1, 1.0))
    for ray in range(len(directions)):
        hits = slice(*found.first[ray : ray + 2])
        stops = np.flatnonzero(mesh.transmittance[found.face[hits]] == 0.0)
        end = np.inf
        if len(stops):
            end, face[ray] = found.distance[hits][stops[0]], found.face[hits][stops[0]]
        before = found.face[hits][found.distance[hits] < end]
        distance[ray], share[ray] = end, np.prod(mesh.transmittance[before], dtype=np.float64)
    return distance, face, share


@pytest.mark.parametrize("reach", [np.inf, 0.8])
def test_a_trace_has_the_first_opaque_face_and_the_product_before_it(reach):
    mesh = mixed()
    origins, directions = random_rays(4000)
    limit = None if reach == np.inf else reach
    hits = ws.trace(mesh, origins, directions, max_distance=limit)
    distance, face, share = products(mesh, origins, directions, reach)
    assert np.array_equal(hits.distance, distance.astype(np.float32))
    one_of_two = np.where(np.arange(-1, 400) < 20, np.arange(-1, 400) + 20, np.arange(-1, 400))  # the soup's duplicates
    one_of_two[0] = -1
    assert np.array_equal(one_of_two[hits.face + 1], one_of_two[face.astype(int) + 1])
    np.testing.assert_allclose(hits.transmitted, share, rtol=1e-7)
    assert len(np.unique(hits.transmitted)) > 300
    some = ws.trace(mesh, origins, directions, max_distance=limit, any_hit=True)
    assert np.array_equal(some.face >= 0, face >= 0)
    assert np.array_equal(some.transmitted, np.where(face >= 0, np.float32(0.0), hits.transmitted))
    given = wp.array(origins, dtype=wp.vec3d, device="cpu"), wp.array(directions, dtype=wp.vec3, device="cpu")
    seen = [wp.zeros(4000, dtype=kind, device="cpu") for kind in (wp.float32, wp.int32)]
    wp.launch(ask, 4000, inputs=[ws.tree(mesh), *given, reach], outputs=seen, device="cpu")
    small = ws.trace(mesh, origins, directions.astype(np.float32), max_distance=limit, any_hit=True)
    assert np.array_equal(seen[0].numpy(), small.transmitted)
    assert np.array_equal(seen[1].numpy() != 0, small.face >= 0)


def test_opaque_and_clear_meshes_are_as_those_without_a_transmittance_and_as_no_mesh():
    origins, directions = random_rays(2000)
    plain = ws.trace(soup(), origins, directions)
    dark = ws.trace(ws.as_mesh(soup(), transmittance=0.0), origins, directions)
    assert plain.transmitted is dark.transmitted is None
    assert np.array_equal(plain.distance, dark.distance)
    assert np.array_equal(plain.face, dark.face)
    clear = ws.trace(ws.as_mesh(soup(), transmittance=1.0), origins, directions)
    assert (clear.transmitted == 1.0).all()
    assert (clear.face == -1).all()
    opaque = ws.tree(soup())
    share = wp.zeros(2000, dtype=wp.float32, device="cpu")
    given = wp.array(origins, dtype=wp.vec3d, device="cpu"), wp.array(directions, dtype=wp.vec3, device="cpu")
    wp.launch(
        ask, 2000, inputs=[opaque, *given, np.inf], outputs=[share, wp.zeros(2000, dtype=int, device="cpu")], device="cpu"
    )
    assert np.array_equal(share.numpy() == 0.0, plain.face >= 0)
    assert set(share.numpy()) == {0.0, 1.0}


def test_a_moved_mesh_keeps_what_it_lets_through():
    mesh, shift = mixed(), np.array([0.5, 0.0, 2.0])
    origins, directions = random_rays(2000)
    ws.trace(mesh, origins, directions)  # so that there are trees to move
    moved, anew = ws.refit(mesh, mesh.vertices + shift), ws.Mesh(mesh.vertices + shift, mesh.faces)
    anew = ws.as_mesh(anew, transmittance=mesh.transmittance)
    found, right = (ws.trace(each, origins + shift, directions) for each in (moved, anew))
    assert np.array_equal(found.distance, right.distance)
    np.testing.assert_allclose(found.transmitted, right.transmitted, rtol=1e-6)  # products in another order
    assert np.count_nonzero(found.transmitted < 1.0) > 500


def test_other_shares_take_no_new_tree_while_the_faces_that_let_some_through_stay(monkeypatch):
    mesh, built = mixed(), []
    origins, directions = random_rays(500)
    first = ws.trace(mesh, origins, directions)
    monkeypatch.setattr("warpsample.tracing.scene.build", lambda *_: built.append("all"))
    with monkeypatch.context() as patched:
        patched.setattr("warpsample.tracing.scene.build_some", lambda *_: built.append("some"))
        winter = ws.as_mesh(mesh, transmittance=np.where(mesh.transmittance % 1.0, 0.5, mesh.transmittance))
        found = ws.trace(winter, origins, directions)
    assert built == []
    assert np.array_equal(found.distance, first.distance)
    assert not np.array_equal(found.transmitted, first.transmitted)
    assert (np.frexp(found.transmitted)[0] == 0.5).all()  # powers of two
    clear = ws.trace(ws.as_mesh(winter, transmittance=0.25), origins, directions)  # all of them let some through
    assert built == []
    assert (clear.face == -1).all()
    assert np.array_equal(ws.trace(mesh, origins, directions).transmitted, first.transmitted)


@pytest.mark.parametrize("shared", [True, False])
def test_each_face_of_a_closed_body_dims_a_ray_once_also_at_edges_and_corners(shared):
    body = ws.as_mesh(icosphere() if shared else loose(icosphere()), transmittance=0.5)
    origins, directions = aimed(body, 4000)
    hits = ws.trace(body, origins, directions)
    outside = np.linalg.norm(origins, axis=1) > 1.0
    assert set(hits.transmitted[outside]) == {1.0, 0.25}
    assert set(hits.transmitted[np.linalg.norm(origins, axis=1) < 0.9]) == {0.5}


def test_light_through_a_hundred_planes_and_rays_that_are_none():
    pile = ws.as_mesh(planes(100), transmittance=np.repeat(np.linspace(0.9, 0.99, 100), 2))
    directions = np.array([[0.0, 0.0, -1.0], [0.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.3, 0.3, -3.0]])
    hits = ws.trace(pile, np.array([0.2, 0.2, 1.5]), directions)
    assert np.isnan(hits.transmitted[1])
    expected = np.prod(pile.transmittance[::2].astype(np.float64))
    np.testing.assert_allclose(hits.transmitted[[0, 2, 3]], [expected, 1.0, expected], rtol=1e-7)
    assert (hits.face == -1).all()


def test_tracers_that_know_no_glass_refuse_it():
    with pytest.raises(ValueError, match="^tracer: got 'warp' for a mesh that transmits light, want 'wide' on the CPU$"):
        ws.trace(mixed(), np.zeros(3), np.ones((1, 3)), tracer="warp")
