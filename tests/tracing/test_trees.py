"""Trees hold every face in one leaf and every box around its children, on any mesh; they are built once, and refitted."""

import weakref
from collections import Counter

import numpy as np
import pytest
import trimesh
from meshes import BOX, random_rays

import warpsample as ws
from warpsample.proof.rays import rays_inside
from warpsample.tracing.scene import scene_of
from warpsample.tracing.wide import build
from warpsample.tracing.wide.layout import MOST_DEPTH

MESHES = {
    "one": (np.eye(3), [[0, 1, 2]]),
    "all degenerate": (np.eye(3), [[0, 0, 1], [1, 1, 1]]),
    "one point": (np.ones((3, 3)), [[0, 1, 2]]),
    "5000 equal": (np.eye(3), np.tile([[0, 1, 2]], (5000, 1))),
    "halving": (np.concatenate([np.eye(3) * 2.0**-k for k in range(120)]), np.arange(360).reshape(-1, 3)),
    "coplanar grid": trimesh.creation.box().subdivide().subdivide(),
    "needles": (
        np.stack([np.linspace(0, 1, 600), np.tile([0.0, 1e-6, 1.0], 200), np.zeros(600)], 1),
        np.arange(600).reshape(-1, 3),
    ),
}


@pytest.mark.parametrize("name", MESHES)
@pytest.mark.filterwarnings("ignore:mesh. got faces of size:UserWarning")  # "halving"
def test_every_face_is_in_one_leaf_and_every_box_around_what_is_below(name):
    scene = scene_of(ws.as_mesh(MESHES[name]))
    tree = scene.tree(2)
    topology = tree.topology
    count = Counter(topology.faces[topology.faces >= 0].tolist())
    assert count == dict.fromkeys(range(len(scene.faces)), 1)
    assert len(topology.levels) - 1 <= MOST_DEPTH
    below = topology.links[topology.links != 0]
    assert sorted(below.tolist()) == [*range(-len(topology.faces), 0), *range(1, len(topology.links))]
    boxes = np.swapaxes(tree.nodes[:, :6], 1, 2)
    for node, slot in zip(*np.nonzero(topology.links), strict=True):
        place = topology.links[node, slot]
        if place < 0:
            inside = scene.vertices[scene.faces[topology.faces[~place][topology.faces[~place] >= 0]]].reshape(-1, 3)
            low, high = inside.min(axis=0), inside.max(axis=0)
        else:
            used = topology.links[place] != 0
            low, high = boxes[place, used, :3].min(axis=0), boxes[place, used, 3:].max(axis=0)
        assert (boxes[node, slot, :3] <= low).all()
        assert (boxes[node, slot, 3:] >= high).all()
    assert (tree.nodes.ctypes.data % 64, tree.leaves.ctypes.data % 64) == (0, 0)


@pytest.mark.parametrize("name", MESHES)
@pytest.mark.filterwarnings("ignore:mesh. got faces of size:UserWarning")  # "halving"
def test_both_tracers_answer_on_hostile_meshes(name):
    mesh = ws.as_mesh(MESHES[name])
    origins, directions = random_rays(2000)
    wide, warp = (ws.trace(mesh, 3.0 * origins, directions - 3.0 * origins, tracer=tracer) for tracer in ("wide", "warp"))
    assert np.count_nonzero(np.isfinite(wide.distance) != np.isfinite(warp.distance)) <= 1
    assert (wide.face < len(mesh.faces)).all()
    assert wide.invalid == warp.invalid == 0


@pytest.mark.filterwarnings("ignore:mesh. got faces of size:UserWarning")  # half of them below 1e-11
def test_a_tree_too_deep_for_areas_is_split_by_count(monkeypatch):
    """Triangles about a corner are each a little smaller than the last, so that areas would make a deep tree of them."""
    rows = np.concatenate([np.eye(3) * 0.95**k for k in range(1000)]), np.arange(3000).reshape(-1, 3)
    deep, flat = (ws.Mesh(*rows) for _ in range(2))
    rays = np.array([0.5, 0.6, 0.7]), np.random.default_rng(1).uniform(-1.0, 0.1, (1 << 12, 3))
    want = ws.trace(deep, *rays)
    assert len(scene_of(deep).tree(1).topology.levels) - 1 > 2
    monkeypatch.setattr(build, "SAH_LEVELS", 0)
    assert np.array_equal(ws.trace(flat, *rays).face, want.face)
    assert len(scene_of(flat).tree(1).topology.levels) - 1 == 2  # 1000 faces: 16 x 16 leaves
    assert 0.1 < (want.face >= 0).mean() < 0.9


# Trees are kept, and follow their vertices


def test_a_tree_is_built_once_and_dies_with_its_mesh(monkeypatch):
    mesh = ws.Mesh(BOX.vertices, BOX.faces)
    ws.trace(mesh, [0.0, 0.0, 0.0], [[0.0, 0.0, 1.0]])
    kept = weakref.ref(scene_of(mesh))
    monkeypatch.setattr("warpsample.tracing.scene.build", None)
    monkeypatch.setattr("warpsample.tracing.scene.fill", None)
    ws.trace(mesh, [0.0, 0.0, 0.0], [[0.0, 0.0, 1.0]], any_hit=True)
    del mesh
    assert kept() is None


def test_refit_is_a_tree_of_the_moved_vertices(bunny_path, monkeypatch):
    bunny = ws.load_mesh(bunny_path)
    bent = bunny.vertices + 0.2 * np.sin(3.0 * bunny.vertices[:, [1, 2, 0]])
    rays = rays_inside(ws.Mesh(bent, bunny.faces), 1 << 14, 2)
    want = ws.trace(ws.Mesh(bent, bunny.faces), *rays)
    ws.trace(bunny, [0.0, 0.0, 0.0], [[0.0, 0.0, 1.0]])
    monkeypatch.setattr("warpsample.tracing.scene.build", None)
    moved = ws.refit(bunny, bent)
    got = ws.trace(moved, *rays)
    assert np.array_equal(moved.vertices, bent)
    assert np.array_equal(got.distance, want.distance)
    assert np.count_nonzero(got.face != want.face) <= 3  # where two faces are at the same distance


def test_refit_wants_as_many_vertices():
    with pytest.raises(ValueError, match=r"vertices: got shape \(4, 3\), want \(8, 3\) as in the mesh"):
        ws.refit(BOX, np.zeros((4, 3)))
