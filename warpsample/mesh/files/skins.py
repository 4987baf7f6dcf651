"""Skins of glTF files: joints that pose a mesh in place of its node's matrix."""

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import count, takewhile

import numpy as np

from warpsample.host.engine import check_memory
from warpsample.host.json_tree import Part
from warpsample.mesh.files.gltf_data import Data

_BYTES = 400  # memory per vertex: its matrix and temporary arrays


@dataclass(frozen=True, eq=False)
class Skin:
    """Skin of a glTF mesh: joints that deform the mesh.

    Attributes:
        part: JSON of the skin.
        joints: (J, 4, 4) matrices of the joints in the scene, for row vectors.
    """

    part: Part
    joints: np.ndarray

    @classmethod
    def of(cls, node: Part, skins: list[Part], nodes: list[Part], places: Mapping[int, np.ndarray]) -> "Skin | None":
        """Return which of the skins a glTF node has, or None; `places` maps node numbers to matrices."""
        if "skin" not in node:
            return None
        part = skins[node.index("skin", skins)]
        joints = part.indices("joints", nodes)
        for joint in joints:
            if joint not in places:
                raise ValueError(f"{part.at('joints')}: got node {joint}, want nodes of the scene that has the skin")
        return cls(part, np.array([places[joint] for joint in joints]).reshape(-1, 4, 4))

    def poses(self, primitive: Part, data: Data) -> np.ndarray | None:
        """Return the matrices, (V, 4, 4), that move each vertex of a primitive to its deformed position.

        Returns None for a primitive without joints.
        """
        attributes = primitive.part("attributes")
        sets = list(takewhile(lambda number: f"JOINTS_{number}" in attributes, count()))
        if not sets:
            return None
        joints = np.concatenate([data.rows(attributes, f"JOINTS_{number}")[1] for number in sets], axis=1)
        weights = np.concatenate([data.vectors(attributes, f"WEIGHTS_{number}", 4) for number in sets], axis=1)
        if joints.shape != weights.shape:
            raise ValueError(
                f"{attributes.path}: got JOINTS of shape {joints.shape} and WEIGHTS of {weights.shape}, want equal shapes"
            )
        check_memory(_BYTES * len(joints), f"skins of {len(joints):,} vertices", "leave them out")
        weights = weights.astype(np.float64)
        weights[~weights.any(axis=1), 0] = 1.0  # as viewers do: a vertex without weights follows its first joint
        joints = np.where(weights == 0.0, 0, joints).astype(np.int64)
        if len(joints) and not 0 <= joints.min() <= joints.max() < len(self.joints):
            raise ValueError(
                f"{attributes.at('JOINTS_0')}: got joint {joints.max()}, want 0 to {len(self.joints) - 1}, as in the skin"
            )
        weights /= weights.sum(axis=1, keepdims=True)
        moves, found = self._moves(data), np.zeros((len(joints), 4, 4))
        for column in range(joints.shape[1]):
            found += weights[:, column, None, None] * moves[joints[:, column]]
        return found

    def _moves(self, data: Data) -> np.ndarray:
        """Return the matrix of each joint, (J, 4, 4), that moves the undeformed mesh with the joint."""
        if "inverseBindMatrices" not in self.part:
            return self.joints
        inverse = data.matrices(self.part, "inverseBindMatrices")
        if len(inverse) < len(self.joints):
            at = self.part.at("inverseBindMatrices")
            raise ValueError(f"{at}: got {len(inverse)} matrices, want one for each of {len(self.joints)} joints")
        return inverse[: len(self.joints)] @ self.joints


def posed(points: np.ndarray, poses: np.ndarray) -> np.ndarray:
    """Transform points (V, 3) by one (4, 4) matrix per point."""
    if len(points) != len(poses):
        raise ValueError(f"the skin has joints for {len(poses):,} of {len(points):,} vertices, want joints for each vertex")
    return np.einsum("vi,vij->vj", points.astype(np.float64), poses[:, :3, :3]) + poses[:, 3, :3]
