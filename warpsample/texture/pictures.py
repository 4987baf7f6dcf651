"""Encoding of images as .png, by Pillow, and as .exr, by OpenEXR."""

from collections.abc import Mapping
from io import BytesIO
from types import ModuleType

import numpy as np

from warpsample.host.extras import missing
from warpsample.host.locks import imported

WHITE = {8: (255.0, np.uint8), 16: (65535.0, np.uint16)}
"""Largest number of a channel of a .png and its type, by the bits per channel."""
DEPTHS = tuple(WHITE)
"""Bits per channel of a .png."""


def encode_png(image: np.ndarray, depth: int) -> bytes:
    """Return the bytes of a .png of an (H, W) image, linear, clipped to [0, 1] and rounded to `depth` bits.

    An image (H, W, 3) holds vectors: each direction is stored as a colour of 8 bits, 0.5 + 0.5 * component. Vectors of
    length 0 are stored as +z.
    """
    if image.ndim == 3:
        length = np.linalg.norm(image.astype(np.float64), axis=2, keepdims=True)
        image = 0.5 + 0.5 * np.where(length > 0.0, image / np.where(length > 0.0, length, 1.0), (0.0, 0.0, 1.0))
    white, kind = WHITE[depth]
    levels = np.floor(np.clip(image.astype(np.float64), 0.0, 1.0) * white + 0.5).astype(kind)
    stream = BytesIO()
    import_library("PIL.Image", "a .png needs Pillow").fromarray(levels).save(stream, "PNG", compress_level=9)
    return stream.getvalue()


def encode_exr(layers: Mapping[str, np.ndarray]) -> bytes:
    """Return the bytes of a float32 .exr with one or more layers.

    Args:
        layers: images by layer name. An (H, W) image is channel Y; an (H, W, 3) image is channels R, G and B.
    """
    openexr = import_library("OpenEXR", "an .exr needs OpenEXR")
    channels = {}
    for layer, image in layers.items():
        prefix = f"{layer}." if layer else ""
        split = np.moveaxis(image, -1, 0) if image.ndim == 3 else [image]
        names = "RGB" if image.ndim == 3 else "Y"
        channels |= {prefix + name: np.ascontiguousarray(one, np.float32) for name, one in zip(names, split, strict=True)}
    header = {"compression": openexr.ZIP_COMPRESSION, "type": openexr.scanlineimage}
    stream = BytesIO()  # of a file on a full disk, OpenEXR reports no error when it closes the file
    openexr.File(header, channels).write(stream)
    return stream.getvalue()


def check_library(suffix: str) -> None:
    """Raise an error if the library for a file suffix is missing, before any work."""
    if suffix in (".png", ".glb", ".gltf"):
        import_library("PIL.Image", f"a texture in a {suffix} needs Pillow")
    elif suffix == ".exr":
        import_library("OpenEXR", "an .exr needs OpenEXR")


def import_library(name: str, what: str) -> ModuleType:
    """Import and return an image library; raise an error that explains how to install it if it is missing.

    Raises:
        ModuleNotFoundError: the library is missing; the message starts with `what` and names the install command.
    """
    try:
        return imported(name)
    except ModuleNotFoundError:
        raise missing(what, name) from None
