"""The public call `tree`, which prepares a mesh for ray tracing in user-defined Warp kernels."""

from typing import Any

import numpy as np
import warp as wp

from warpsample.host.arrays import check_device, cpu
from warpsample.host.engine import check_workers
from warpsample.mesh.mesh import as_mesh
from warpsample.tracing.own_rays import Tree
from warpsample.tracing.scene import GLASS, coarseness_of, scene_of


def tree(mesh: Any, *, device: Any = None, workers: int | None = None) -> Any:
    """Prepare a mesh for ray tracing in user-defined kernels; `funcs.any_hit` and `funcs.nearest_hit` take the result.

    The mesh may be deleted. On the CPU rays get the answers of `trace` bit for bit, elsewhere those of wp.Mesh.

    Args:
        mesh: Mesh or anything that `as_mesh` accepts; the tree of a Mesh is used.
        device: Warp device of the kernel, such as "cuda:0". Default: None, the CPU.
        workers: Number of CPU threads, an integer. Default: None, the value of WARPSAMPLE_WORKERS or all cores.

    Returns:
        a `funcs.Tree`.

    Raises:
        TypeError, ValueError: an argument of a wrong type or value; the message names it. A mesh with translucent faces, for
            a device other than the CPU.

    Example:
        >>> tree = ws.tree(ws.load_mesh("courtyard"))
        >>> print(tree.nodes.device, tree.extent[2] > 0.0)
        cpu True
    """
    where, workers = check_device(device, cpu()), check_workers(workers)
    scene = scene_of(as_mesh(mesh), through=where.is_cpu)
    made = Tree()
    made.centre, made.scale = wp.vec3d(*scene.centre), scene.scale
    made.extent, made.coarseness = wp.vec3(*scene.extent), coarseness_of(scene, True)
    if where.is_cpu:
        built = scene.blockers(workers)
        made.nodes, made.leaves = _on_cpu(built.nodes), _on_cpu(built.leaves)
    else:
        made.mesh = scene.builtin(where).mesh
        made.extent = wp.vec3(1.0, 1.0, 1.0)
        made.nodes = made.leaves = wp.empty(0, dtype=wp.float32, device=where)
    made.glass_nodes = made.glass_leaves = made.transmittance = wp.empty(0, dtype=wp.float32, device=where)
    if scene.transmittance is not None:
        glass = scene.tree(workers, GLASS)
        made.glass_nodes, made.glass_leaves = _on_cpu(glass.nodes), _on_cpu(glass.leaves)
        made.transmittance = wp.array(scene.transmittance, dtype=wp.float32, device="cpu")
    made.nodes.scene = scene  # owner of the memory: copies of a struct share only its arrays
    return made


def _on_cpu(array: np.ndarray) -> wp.array:
    """Return an array as a flat float32 Warp array on the CPU that shares its memory."""
    return wp.array(array.ravel(), dtype=wp.float32, device="cpu", copy=False)
