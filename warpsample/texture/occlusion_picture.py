"""Reader that joins all occlusion textures of a glTF file into one picture, for the viewer."""

import warnings
from dataclasses import dataclass
from io import BytesIO
from math import ceil, sqrt
from pathlib import Path

import numpy as np

from warpsample.host.arguments import check_number, naming_file
from warpsample.host.engine import check_memory
from warpsample.host.json_tree import Part
from warpsample.mesh.files.gltf import iterate_primitives, opened, read_corners, surface
from warpsample.mesh.files.gltf_data import Data
from warpsample.mesh.files.uv import LAST_SET
from warpsample.texture.pictures import import_library
from warpsample.texture.report import find_outside_faces

_SIDE = 8192  # largest side of the joined picture, in texels: graphics cards accept this size
_FORMATS = ("PNG", "JPEG", "WEBP")  # of glTF; Pillow would run another program for some other formats
_PNG = b"\x89PNG"
_BYTES = 8  # memory per texel: decoded by Pillow, and as an array
_TRANSFORM, _WEBP = "KHR_texture_transform", "EXT_texture_webp"


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

    Faces without occlusion are white, and so are faces with coordinates outside the image, with a texture transform, or with
    a picture in another format than .png, .jpg and .webp.

    Returns:
        the joined picture; None for a file of another type or without an occlusion texture that can be shown.

    Raises:
        ValueError: the file or a picture in it cannot be read.

    Warns:
        UserWarning: the file has occlusion textures with a transform, or with a picture in another format.
    """
    if path.suffix.lower() not in (".glb", ".gltf"):
        return None
    with naming_file("mesh", path, "a glTF file with pictures"), opened(path) as (tree, data):
        faces, infos = [], []
        for placed in iterate_primitives(tree):
            faces.append(len(surface(placed.primitive, data)[1]))
            infos.append(_read_occlusion_info(tree, placed.primitive))
        kinds = {info: row for row, info in enumerate(dict.fromkeys(each for each in infos if isinstance(each, tuple)))}
        if left_out := ", ".join(dict.fromkeys(info for info in infos if isinstance(info, str))):
            warnings.warn(f"mesh: got occlusion that is not shown, in {left_out}", stacklevel=2)
        if not kinds:
            return None
        pictures = [_read_red(tree, data, path, image) for image, _, _ in kinds]
    kind = np.repeat([kinds[info] if isinstance(info, tuple) else -1 for info in infos], faces)
    sets = {number: read_corners(path, f"TEXCOORD_{number}") for _, number, _ in kinds}
    strengths = [strength for _, _, strength in kinds]
    return _join_pictures(pictures, strengths, kind, [sets[number] for _, number, _ in kinds])


def _read_occlusion_info(tree: Part, primitive: Part) -> tuple[int, int, float] | str | None:
    """Return the image, the set of coordinates and the strength of a primitive's occlusion.

    The result is None without occlusion, and a phrase if the texture cannot be shown.
    """
    if "material" not in primitive:
        return None
    materials, textures = tree.parts("materials"), tree.parts("textures")
    material = materials[primitive.index("material", materials)]
    if "occlusionTexture" not in material:
        return None
    info = material.part("occlusionTexture")
    texture = textures[info.index("index", textures)]
    if "extensions" in info and _TRANSFORM in info.part("extensions"):
        return f"{info.path} ({_TRANSFORM})"
    others = texture.part("extensions") if "extensions" in texture else Part({})
    source = others.part(_WEBP) if _WEBP in others else texture
    if "source" not in source:
        return f"{texture.path} ({', '.join(others.content)})" if others.content else None
    strength = check_number(info.content.get("strength", 1.0), info.at("strength"), 0.0, 1.0)
    return source.index("source", tree.parts("images")), info.whole("texCoord", 0, LAST_SET), strength


def _read_red(tree: Part, data: Data, path: Path, image: int) -> np.ndarray:
    """Return the red channel of a picture, (H, W) uint8 or uint16.

    A .png may be of any size that fits into memory, because `bake` writes large ones. Others have the limit of Pillow.
    """
    part = tree.parts("images")[image]
    pillow, png = (import_library(name, "pictures need Pillow") for name in ("PIL.Image", "PIL.PngImagePlugin"))
    content = data.picture(part, path)
    try:
        is_png = content.startswith(_PNG)
        picture = png.PngImageFile(BytesIO(content)) if is_png else pillow.open(BytesIO(content), formats=_FORMATS)
    except (SyntaxError, pillow.UnidentifiedImageError):
        raise ValueError(f"{part.path}: got a picture that is none of {', '.join(_FORMATS)}, want one of these") from None
    with picture:
        texels = f"the texels of a picture of {picture.width:,} x {picture.height:,}"
        check_memory(_BYTES * picture.width * picture.height, texels, "show a smaller picture")
        is_grey = picture.mode == "L" or picture.mode.startswith("I;16")
        pixels = np.array(picture if is_grey else picture.convert("RGB"))
    return pixels if pixels.ndim == 2 else pixels[..., 0]


def _join_pictures(
    pictures: list[np.ndarray], strengths: list[float], kind: np.ndarray, sets: list[np.ndarray]
) -> OcclusionPicture:
    """Arrange several pictures as a grid in one picture, and convert each face's texture coordinates.

    Viewers show the occlusion 1 + strength * (red - 1). Each picture is framed by copies of its edge texels.
    """
    columns = ceil(sqrt(len(pictures) + 1))
    side = min(max(max(picture.shape) for picture in pictures), _SIDE // columns - 2)
    pitch = side + 2
    whole = np.full((columns * pitch, columns * pitch), 255, np.uint8)
    uv = np.full((len(kind), 3, 2), np.nan)
    for number, coordinates in enumerate(sets):
        uv[kind == number] = coordinates[kind == number]
    is_shown = (kind >= 0) & np.isfinite(uv).all(axis=(1, 2)) & ~find_outside_faces(uv)
    place = np.where(is_shown, kind, len(pictures))
    uv = np.clip(np.where(is_shown[:, None, None], uv, 0.5), 0.0, 1.0)
    for number, picture in enumerate(pictures):
        row, column = (pitch * at for at in divmod(number, columns))
        take = [(np.arange(side) * length) // side for length in picture.shape]
        occlusion = 1.0 + strengths[number] * (picture[np.ix_(*take)] / np.iinfo(picture.dtype).max - 1.0)
        shown = np.round(255.0 * np.clip(occlusion, 0.0, 1.0)).astype(np.uint8)
        whole[row : row + pitch, column : column + pitch] = np.pad(shown, 1, mode="edge")
    corner = np.stack([place % columns, place // columns], axis=1)[:, None]
    return OcclusionPicture(whole, (pitch * corner + 1.0 + side * uv) / (columns * pitch))
