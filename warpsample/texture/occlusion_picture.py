"""Reader that joins all occlusion textures of a glTF file into one picture, for the viewer."""

from dataclasses import dataclass
from io import BytesIO
from math import ceil, sqrt
from pathlib import Path

import numpy as np

from warpsample.host.arguments import check_number, naming_file
from warpsample.host.json_tree import Part
from warpsample.mesh.files.gltf import iterate_primitives, opened, read_corners, surface
from warpsample.mesh.files.gltf_data import Data
from warpsample.mesh.files.uv import LAST_SET
from warpsample.texture.pictures import import_library

_SIDE = 8192  # largest side of the joined picture, in texels: graphics cards accept this size
_FORMATS = ("PNG", "JPEG", "WEBP")  # of glTF; Pillow would run another program for some other formats
_TRANSFORM = "KHR_texture_transform"


@dataclass(frozen=True, eq=False)
class OcclusionPicture:
    """Occlusion of a baked mesh as one picture with texture coordinates, as the viewer shows it.

    Attributes:
        picture: (H, W) uint8, grey levels.
        uv: (F, 3, 2) float64, texture coordinates of the faces in the picture, v downward.
    """

    picture: np.ndarray
    uv: np.ndarray


def read_occlusion(path: Path) -> OcclusionPicture | None:
    """Read the occlusion textures of a glTF file, for the faces that `load_mesh` reads.

    Faces without occlusion are white, and so are faces with coordinates outside the image or with a texture transform.

    Returns:
        the joined picture; None for a file of another type or without an occlusion texture.

    Raises:
        ValueError: the file or a picture in it cannot be read.
    """
    if path.suffix.lower() not in (".glb", ".gltf"):
        return None
    with naming_file("mesh", path, "a glTF file with pictures"), opened(path) as (tree, data):
        faces, infos = [], []
        for placed in iterate_primitives(tree):
            faces.append(len(surface(placed.primitive, data)[1]))
            infos.append(_read_occlusion_info(tree, placed.primitive))
        kinds = list(dict.fromkeys(info for info in infos if info is not None))
        if not kinds:
            return None
        pictures = [_read_grey_levels(tree, data, path, image, strength) for image, _, strength in kinds]
    kind = np.repeat([-1 if info is None else kinds.index(info) for info in infos], faces)
    return _join_pictures(pictures, kind, [read_corners(path, f"TEXCOORD_{number}") for _, number, _ in kinds])


def _read_occlusion_info(tree: Part, primitive: Part) -> tuple[int, int, float] | None:
    """Return the image, the set of coordinates and the strength of a primitive's occlusion; None without occlusion."""
    if "material" not in primitive:
        return None
    materials, textures = tree.parts("materials"), tree.parts("textures")
    material = materials[primitive.index("material", materials)]
    if "occlusionTexture" not in material:
        return None
    info = material.part("occlusionTexture")
    texture = textures[info.index("index", textures)]
    if "source" not in texture or ("extensions" in info and _TRANSFORM in info.part("extensions")):
        return None
    strength = check_number(info.content.get("strength", 1.0), info.at("strength"), 0.0, 1.0)
    return texture.index("source", tree.parts("images")), info.whole("texCoord", 0, LAST_SET), strength


def _read_grey_levels(tree: Part, data: Data, path: Path, image: int, strength: float) -> np.ndarray:
    """Return the (H, W) float64 occlusion that viewers show for a picture: 1 + strength * (red - 1)."""
    part = tree.parts("images")[image]
    pillow = import_library("PIL.Image", "pictures need Pillow")
    try:
        opened_picture = pillow.open(BytesIO(data.picture(part, path)), formats=_FORMATS)
    except pillow.UnidentifiedImageError:
        raise ValueError(f"{part.path}: got a picture that is none of {', '.join(_FORMATS)}, want one of these") from None
    with opened_picture:
        pixels = np.array(opened_picture if opened_picture.mode.startswith("I;16") else opened_picture.convert("RGB"))
    red = (pixels if pixels.ndim == 2 else pixels[..., 0]) / np.iinfo(pixels.dtype).max
    return 1.0 + strength * (red - 1.0)


def _join_pictures(pictures: list[np.ndarray], kind: np.ndarray, sets: list[np.ndarray]) -> OcclusionPicture:
    """Arrange several pictures as a grid in one picture, and convert each face's texture coordinates.

    Each picture is framed by copies of its edge texels.
    """
    columns = ceil(sqrt(len(pictures) + 1))
    side = min(max(max(picture.shape) for picture in pictures), _SIDE // columns - 2)
    pitch = side + 2
    whole = np.full((columns * pitch, columns * pitch), 255, np.uint8)
    uv = np.empty((len(kind), 3, 2))
    for number, coordinates in enumerate(sets):
        uv[kind == number] = coordinates[kind == number]
    beyond = ~((uv >= 0.0) & (uv <= 1.0)).all(axis=(1, 2))
    place = np.where((kind < 0) | beyond, len(pictures), kind)
    uv[place == len(pictures)] = 0.5
    for number, picture in enumerate(pictures):
        row, column = (pitch * at for at in divmod(number, columns))
        take = [(np.arange(side) * length) // side for length in picture.shape]
        shown = np.round(255.0 * np.clip(picture, 0.0, 1.0)).astype(np.uint8)
        whole[row : row + pitch, column : column + pitch] = np.pad(shown[np.ix_(*take)], 1, mode="edge")
    corner = np.stack([place % columns, place // columns], axis=1)[:, None]
    return OcclusionPicture(whole, (pitch * corner + 1.0 + side * uv) / (columns * pitch))
