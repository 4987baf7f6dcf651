"""Images of numbers as files: .png by Pillow, .exr by OpenEXR."""

from collections.abc import Mapping
from io import BytesIO
from pathlib import Path
from tempfile import TemporaryDirectory
from types import ModuleType

import numpy as np

from warpsample.host.files import WriteError
from warpsample.host.making import imported, missing

_WHITE = {8: (255.0, np.uint8), 16: (65535.0, np.uint16)}
DEPTHS = tuple(_WHITE)
"""Bits of a number in a .png."""


def encode_png(image: np.ndarray, depth: int) -> bytes:
    """The bytes of a .png of (H, W) numbers from 0 to 1, linear and rounded; beyond these, cut.

    Vectors, (H, W, 3), are colours of 8 bits: each stands for its direction, from -1 to 1; one of length 0 for +z.
    """
    if image.ndim == 3:
        length = np.linalg.norm(image.astype(np.float64), axis=2, keepdims=True)
        image = 0.5 + 0.5 * np.where(length > 0.0, image / np.where(length > 0.0, length, 1.0), (0.0, 0.0, 1.0))
    white, kind = _WHITE[depth]
    levels = np.floor(np.clip(image.astype(np.float64), 0.0, 1.0) * white + 0.5).astype(kind)
    stream = BytesIO()
    import_library("PIL.Image", "a .png needs Pillow").fromarray(levels).save(stream, "PNG", compress_level=9)
    return stream.getvalue()


def encode_exr(layers: Mapping[str, np.ndarray]) -> bytes:
    """The bytes of an .exr of float32 images by the names of their layers: (H, W) is Y, (H, W, 3) R, G and B."""
    openexr = import_library("OpenEXR", "an .exr needs OpenEXR")
    channels = {}
    for layer, image in layers.items():
        prefix = f"{layer}." if layer else ""
        split = np.moveaxis(image, -1, 0) if image.ndim == 3 else [image]
        names = "RGB" if image.ndim == 3 else "Y"
        channels |= {prefix + name: np.ascontiguousarray(one, np.float32) for name, one in zip(names, split, strict=True)}
    header = {"compression": openexr.ZIP_COMPRESSION, "type": openexr.scanlineimage}
    with TemporaryDirectory() as folder:  # the import_library writes into files only
        path = Path(folder, "image.exr")
        try:
            openexr.File(header, channels).write(str(path))
        except RuntimeError as error:
            raise WriteError(f"a copy of the picture cannot be written into {folder}: {error}") from None
        return path.read_bytes()


def check_library(suffix: str) -> None:
    """Refuses a suffix of a file for which a import_library is missing, before anything is computed."""
    if suffix in (".png", ".glb", ".gltf"):
        import_library("PIL.Image", f"a texture in a {suffix} needs Pillow")
    elif suffix == ".exr":
        import_library("OpenEXR", "an .exr needs OpenEXR")


def import_library(name: str, what: str) -> ModuleType:
    """A import_library of pictures; where it is missing, `what` needs it and how to install it."""
    try:
        return imported(name)
    except ModuleNotFoundError:
        raise missing(what, name) from None
