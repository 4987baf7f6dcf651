"""CityJSON version of the example mesh, for `load_city("courtyard")`."""

import json
from os import PathLike

import numpy as np

from warpsample.city.cityjson.kinds import BY_NORMAL
from warpsample.mesh.examples import example
from warpsample.mesh.mesh import Mesh

_STEP = 3.0  # metres; all coordinates are multiples of this step


def example_content(path: str | PathLike[str]) -> bytes | None:
    """Return the bytes of the named example; None without an example of this name, or if a file has this name.

    All buildings are one Building with semantics, and the ground is a LandUse without; each triangle is a face.
    """
    made = example(path)
    if made is None:
        return None
    mesh = Mesh(*made)
    upward = mesh.face_normals[:, 2] > 0.5
    ground = upward & (mesh.vertices[mesh.faces][:, :, 2] == 0.0).all(axis=1)
    values = np.where(upward, 0, 1)[~ground].tolist()
    semantics = {"surfaces": [{"type": name} for name in BY_NORMAL[:2]], "values": values}
    faces = mesh.faces[:, None, :]
    objects = {
        "ground": {"type": "LandUse", "geometry": [_multi_surface(faces[ground])]},
        "buildings": {"type": "Building", "geometry": [_multi_surface(faces[~ground]) | {"semantics": semantics}]},
    }
    whole = {"type": "CityJSON", "version": "2.0", "transform": {"scale": [_STEP] * 3, "translate": [0.0] * 3}}
    vertices = np.rint(mesh.vertices / _STEP).astype(int).tolist()
    return json.dumps(whole | {"CityObjects": objects, "vertices": vertices}).encode()


def _multi_surface(faces: np.ndarray) -> dict[str, object]:
    return {"type": "MultiSurface", "lod": "1", "boundaries": faces.tolist()}
