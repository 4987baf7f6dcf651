"""Functions of each tool that bake ambient occlusion into an image (H, W) with a number of rays per texel, v down.

All tools use the same smooth normals and no distance limit; each tool fills the gutters around charts in its own way.
"""

from collections.abc import Callable
from itertools import count as count_from
from typing import Any, NamedTuple

import numpy as np

from warpsample.bench.running.turns import Tool
from warpsample.estimate.visibility import ambient_occlusion
from warpsample.mesh.mesh import Mesh
from warpsample.texture.texture_points import texture_points

_MARGIN = 16  # texels that Blender fills around charts by default
_FAR = 1e3  # mesh diagonals; in effect no distance limit
_AWAY = -1.0  # coordinate of faces without coordinates, outside the image


class Textured(NamedTuple):
    """Mesh with texture coordinates and normals, to be baked by each tool.

    Attributes:
        mesh: the mesh.
        uv: (F, 3, 2) coordinates, v down; NaN at faces that only block light.
        normals: (V, 3) unit normals.
    """

    mesh: Mesh
    uv: np.ndarray
    normals: np.ndarray


Painter = Callable[[int], np.ndarray]


def _warpsample(scene: Textured, size: int, workers: int) -> Painter:
    seeds, normals = count_from(), scene.normals[scene.mesh.faces]

    def paint(rays: int) -> np.ndarray:
        options = {"normals": "smooth", "corner_normals": normals, "workers": workers}
        t = texture_points(scene.mesh, scene.uv, size, **options)
        pixels: np.ndarray = t.image(ambient_occlusion(scene.mesh, t.points, rays, seed=next(seeds), workers=workers).value)
        return pixels

    return paint


def _blender(scene: Textured, size: int, workers: int) -> Painter:
    import bpy

    bpy.ops.wm.read_factory_settings(use_empty=True)
    mesh = bpy.data.meshes.new("mesh")
    mesh.from_pydata(scene.mesh.vertices.tolist(), [], scene.mesh.faces.tolist())
    upward = np.nan_to_num(scene.uv, nan=_AWAY).reshape(-1, 2) * (1.0, -1.0) + (0.0, 1.0)
    mesh.uv_layers.new().data.foreach_set("uv", upward.ravel())
    mesh.polygons.foreach_set("use_smooth", [True] * len(scene.mesh.faces))
    mesh.normals_split_custom_set_from_vertices(scene.normals.tolist())
    obj = bpy.data.objects.new("thing", mesh)
    bpy.context.collection.objects.link(obj)
    bpy.context.view_layer.objects.active = obj
    obj.select_set(True)
    image = bpy.data.images.new("image", size, size, float_buffer=True)
    material = bpy.data.materials.new("material")
    material.use_nodes = True
    node = material.node_tree.nodes.new("ShaderNodeTexImage")
    node.image, material.node_tree.nodes.active = image, node
    mesh.materials.append(material)
    seeds = count_from()

    def paint(rays: int) -> np.ndarray:
        set_up(rays)
        bpy.ops.object.bake(type="AO", margin=_MARGIN)
        pixels = np.empty(4 * size * size, np.float32)
        image.pixels.foreach_get(pixels)
        return pixels.reshape(size, size, 4)[::-1, :, 0].copy()

    def set_up(rays: int) -> None:
        settings = bpy.context.scene
        settings.render.engine, settings.cycles.device = "CYCLES", "CPU"
        settings.render.threads_mode, settings.render.threads = "FIXED", workers
        settings.cycles.samples, settings.cycles.seed = rays, next(seeds)
        settings.cycles.use_adaptive_sampling = settings.cycles.use_denoising = False
        settings.world = settings.world or bpy.data.worlds.new("world")
        settings.world.light_settings.distance = _FAR * scene.mesh.diagonal

    return paint


def _open3d(scene: Textured, size: int, workers: int) -> Painter:
    import open3d as o3d

    mesh = o3d.t.geometry.TriangleMesh()
    mesh.vertex.positions = o3d.core.Tensor(scene.mesh.vertices.astype(np.float32))
    mesh.vertex.normals = o3d.core.Tensor(scene.normals.astype(np.float32))
    mesh.triangle.indices = o3d.core.Tensor(scene.mesh.faces.astype(np.int64))
    upward = np.nan_to_num(scene.uv, nan=_AWAY) * (1.0, -1.0) + (0.0, 1.0)
    mesh.triangle.texture_uvs = o3d.core.Tensor(upward.astype(np.float32))

    def paint(rays: int) -> np.ndarray:
        image: Any = mesh.compute_ambient_occlusion(size, rays, max_hit_distance=_FAR * scene.mesh.diagonal)
        pixels: np.ndarray = np.asarray(image.as_tensor().numpy() if hasattr(image, "as_tensor") else image.numpy())
        return pixels.reshape(size, size, -1)[..., 0] / np.float32(255.0)

    return paint


TEXTURE_TOOLS = {
    "warpsample": (Tool("warpsample", _warpsample), (16, 64, 256)),
    "Blender": (Tool("bpy", _blender), (4, 16, 64)),
    "Open3D": (Tool("open3d", _open3d), (16, 64)),
}
"""(tool, rays per texel of the measurements) by name; `make(scene, side of the image, threads)` returns a painter."""
