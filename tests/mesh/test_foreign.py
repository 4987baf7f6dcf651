"""Scenes, blocks and Open3D's meshes: what they hold is placed and joined, with named parts."""

from types import SimpleNamespace

import numpy as np
import pytest
import pyvista as pv
import trimesh
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet

import warpsample as ws

BOX = trimesh.creation.box()


class Tensor:
    """Like Open3D's: an array that may lie on a device, which NumPy cannot read there."""

    def __init__(self, array, home=False):
        self.array, self.home = array, home

    def cpu(self):
        return Tensor(self.array, home=True)

    def numpy(self):
        assert self.home
        return self.array


def test_a_scene_is_placed_and_its_nodes_are_parts():
    scene, away = trimesh.Scene(), np.diag([-1.0, 1.0, 2.0, 1.0])  # mirrored, and twice as high
    away[:3, 3] = 5.0, 0.0, 0.0
    scene.add_geometry(BOX, node_name="here")
    scene.add_geometry(BOX, node_name="there", transform=away)
    scene.add_geometry(trimesh.PointCloud(np.ones((3, 3))), node_name="cloud")
    mesh = ws.as_mesh(scene)
    assert mesh.parts == ("here", "there")
    assert list(mesh.part) == [0] * 12 + [1] * 12
    assert np.allclose(mesh.bounds, [[-0.5, -0.5, -1.0], [5.5, 0.5, 1.0]])
    centres = ws.face_centers(mesh)
    middle = np.where(mesh.part[:, None] == 0, 0.0, [5.0, 0.0, 0.0])
    assert ((centres.normal * (centres.position - middle)).sum(axis=1) > 0.0).all()  # outside stays outside
    assert np.allclose(mesh.face_areas.sum(), 6.0 + 10.0)


def test_blocks_are_joined_with_those_in_them():
    inner = pv.MultiBlock({"cube": pv.Cube(center=(9, 0, 0)), "nothing": None})
    blocks = pv.MultiBlock({"sphere": pv.Sphere(), "volume": pv.ImageData(dimensions=(3, 3, 3)), "inner": inner})
    blocks["cloud"] = pv.PolyData(np.ones((3, 3)))
    mesh = ws.as_mesh(blocks)
    assert mesh.parts == ("sphere", "volume", "inner/cube")
    assert list(np.bincount(mesh.part)) == [pv.Sphere().n_cells, 48, 12]
    area = np.bincount(mesh.part, mesh.face_areas)
    assert np.allclose(area[1:], [24.0, 6.0])


def test_blocks_need_no_names():
    """Of two blocks of one name, the first was taken twice."""
    blocks, nameless = pv.MultiBlock(), vtkMultiBlockDataSet()
    for place, surface in enumerate((pv.Sphere(), pv.Cube(), pv.PointSet(np.ones((3, 3))))):
        blocks.append(surface, "slab")
        nameless.SetBlock(place, surface)
    for given, names in ((blocks, ("slab", "slab")), (pv.wrap(nameless), ("0", "1"))):
        mesh = ws.as_mesh(given)
        assert mesh.parts == names
        assert list(np.bincount(mesh.part)) == [pv.Sphere().n_cells, 12]


def test_both_of_open3ds_meshes():
    """Of the same shape as those of Open3D 0.20, by which it was tried."""
    legacy = SimpleNamespace(vertices=BOX.vertices.tolist(), triangles=BOX.faces.tolist())
    tensors = SimpleNamespace(
        vertex=SimpleNamespace(positions=Tensor(BOX.vertices.astype(np.float32))),
        triangle=SimpleNamespace(indices=Tensor(BOX.faces.astype(np.int64))),
    )
    for given in (legacy, tensors):
        mesh = ws.as_mesh(given)
        assert np.array_equal(mesh.faces, BOX.faces)
        assert np.array_equal(mesh.vertices, BOX.vertices)
        assert mesh.part is None


@pytest.mark.parametrize(
    "empty", [trimesh.Scene(), pv.MultiBlock({"a": None}), trimesh.Scene(trimesh.PointCloud(np.ones((3, 3))))]
)
def test_a_scene_without_faces_is_reported(empty):
    with pytest.raises(ValueError, match="mesh: got a value of type (Scene|MultiBlock) without a face"):
        ws.as_mesh(empty)


def test_what_is_no_mesh_is_refused_with_what_is_one():
    with pytest.raises(TypeError, match="mesh: got a value of type dict, want .* or a TriangleMesh of Open3D"):
        ws.as_mesh({})
    with pytest.raises(TypeError, match="mesh: got a value of type UnstructuredGrid, want "):
        ws.as_mesh(pv.ImageData(dimensions=(3, 3, 3)).cast_to_unstructured_grid())
