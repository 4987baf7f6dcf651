"""Options with a number for each face of a mesh: one number for all faces, a file, or numbers by named parts."""

from pathlib import Path

import numpy as np

from warpsample.host.arguments import check_file, naming_file
from warpsample.host.files import read_array
from warpsample.mesh.mesh import Mesh, as_mesh

_WANTS = "a number, NAME.npy with one number for each face, or numbers by part, such as leaf=0.2,glass=0.8"


def with_optics(mesh: Mesh, own: np.ndarray | None = None, **options: str | None) -> Mesh:
    """Return a copy of a mesh with the transmittance and reflectance given by command-line options.

    A pair such as leaf=0.2 applies to all parts with that name, or with that name between slashes, as in OBJECT/MATERIAL.
    Faces of other parts get 0.

    Args:
        mesh: Mesh.
        own: (F,) mask of the faces to which a number for all faces applies; others get 0. Default: all faces.
        **options: Texts of the options, or None for those that are not given.

    Raises:
        TypeError, ValueError, FileNotFoundError: a wrong number, a missing or wrong file, or a name without a part.
    """
    shares = {name: _shares(mesh, own, text, f"--{name}") for name, text in options.items() if text is not None}
    if not shares:
        return mesh
    try:
        return as_mesh(mesh, **shares)
    except (TypeError, ValueError) as error:
        raise type(error)(f"--{error}") from None


def _shares(mesh: Mesh, own: np.ndarray | None, text: str, option: str) -> np.ndarray:
    """Parse an option like `--reflectance` to one number for all faces, or an array with a number per face."""
    if text.endswith(".npy"):
        file = check_file(Path(text), option, _WANTS)
        with naming_file(option, file, _WANTS):
            return read_array(file)
    if "=" in text:
        return _by_parts(mesh, text, option)
    number = np.array(_number(text, text, option))
    return number if own is None else np.where(own, number, 0.0)


def _by_parts(mesh: Mesh, text: str, option: str) -> np.ndarray:
    """Parse numbers by part, for example "wall=0.3,roof=0.1", to (F,) float64 numbers per face; 0 for other faces."""
    if mesh.part is None or not any(mesh.parts):
        raise ValueError(f"{option}: got {text!r} for a mesh without named parts, want a number or NAME.npy")
    shares = np.zeros(len(mesh.parts) + 1)  # the last is of faces of no part
    seen = set[str]()
    for pair in text.split(","):
        name, _, share = pair.rpartition("=")
        if name in seen:
            raise ValueError(f"{option}: got {pair!r} as a second number for {name!r}, want one number for each name")
        seen.add(name)
        named = [i for i, part in enumerate(mesh.parts) if name in (part, *part.split("/"))]
        if not name or not named:
            known = ", ".join(sorted(set(filter(None, mesh.parts))))
            raise ValueError(f"{option}: got {pair!r}, want NAME=NUMBER with the name of a part, one of {known[:200]}")
        shares[named] = _number(share, pair, option)
    return shares[mesh.part]


def _number(text: str, whole: str, option: str) -> float:
    """Convert text to a number; raise a ValueError that quotes the whole text of the option."""
    try:
        return float(text)
    except ValueError:
        raise ValueError(f"{option}: got {whole!r}, want {_WANTS}") from None
