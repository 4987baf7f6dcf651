"""A number for each face of a mesh, as the command line tells it: one for all, a file of them, or by named parts."""

from pathlib import Path

import numpy as np

from warpsample.host.arguments import check_file, naming_file
from warpsample.host.files import read_array
from warpsample.mesh.mesh import Mesh, as_mesh

_WANTS = "a number, NAME.npy of one for each face, or by part, as leaf=0.2,glass=0.8"


def with_optics(mesh: Mesh, **told: str | None) -> Mesh:
    """The mesh with the transmittance and the reflectance that options of these names tell, as it is without.

    By parts, each pair names all parts that are called so, or that have that name between slashes, as objects with
    materials do; of faces of other parts the share is 0.

    Raises:
        TypeError, ValueError, FileNotFoundError: no such shares, a file without them, or a name that no part has.
    """
    shares = {name: _shares(mesh, text, f"--{name}") for name, text in told.items() if text is not None}
    if not shares:
        return mesh
    try:
        return as_mesh(mesh, **shares)
    except (TypeError, ValueError) as error:
        raise type(error)(f"--{error}") from None


def _shares(mesh: Mesh, told: str, option: str) -> np.ndarray:
    """What an option tells: a number, or one for each face."""
    if told.endswith(".npy"):
        file = check_file(Path(told), option, _WANTS)
        with naming_file(option, file, _WANTS):
            return read_array(file)
    return _by_parts(mesh, told, option) if "=" in told else np.array(_number(told, told, option))


def _by_parts(mesh: Mesh, told: str, option: str) -> np.ndarray:
    """(F,) float64, 0 for faces of parts that are not named."""
    if mesh.part is None:
        raise ValueError(f"{option}: got {told!r} for a mesh without named parts, want a number or NAME.npy")
    shares = np.zeros(len(mesh.parts) + 1)  # the last is of faces of no part
    for pair in told.split(","):
        name, _, share = pair.rpartition("=")
        named = [i for i, part in enumerate(mesh.parts) if name in (part, *part.split("/"))]
        if not name or not named:
            known = ", ".join(sorted(set(mesh.parts)))
            raise ValueError(f"{option}: got {pair!r}, want the name of a part, of {known[:200]}")
        shares[named] = _number(share, pair, option)
    return shares[mesh.part]


def _number(text: str, told: str, option: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise ValueError(f"{option}: got {told!r}, want {_WANTS}") from None
