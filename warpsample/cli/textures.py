"""Options of `warpsample bake --texture`."""

import re
from pathlib import Path
from typing import Annotated, Any, Literal

import typer

from warpsample.cli.terminal import option
from warpsample.host.arguments import check_file, check_integer, check_number
from warpsample.output.baked import BakeRun
from warpsample.texture.image import check_gutter
from warpsample.texture.sets import TextureOptions
from warpsample.texture.texture_points import check_samples, check_size

OPTIONS: dict[str, Any] = {
    "texture": Annotated[str | None, option("Write a texture of this size in texels, such as 1024 (square) or 1024x512.")],
    "uv": Annotated[
        Literal["auto", "0", "1", "new"] | None,
        option(
            "Texture coordinates: set 0 or 1 of the file, or new ones. auto: a set that covers every face, else new ones. "
            "Default: auto."
        ),
    ],
    "supersample": Annotated[
        int | None, option("Number of points per texel, which share the rays of the texel and are averaged. Default: 1.")
    ],
    "normals": Annotated[
        Literal["face", "smooth", "lifted"] | None,
        option("Normals at texels; lifted also moves the points to the smooth surface. Default: face; smooth for normals."),
    ],
    "gutter": Annotated[str | None, option("Number of empty texels to fill around each chart, or all. Default: all.")],
    "strength": Annotated[float | None, option("Strength of the occlusion in a .glb or .gltf, 0 to 1. Default: 1.")],
    "depth": Annotated[Literal["8", "16"] | None, option("Bits per channel of a .png, also inside a .glb. Default: 8.")],
    "strict": Annotated[
        bool,
        typer.Option(
            "--strict",
            help="Fail on texture coordinates that overlap, leave the image or have no area, on texels too small for "
            "float32, and on --instances mean for a mesh in several places.",
        ),
    ],
    "high": Annotated[
        Path | None, option("Finer mesh on which to compute the values for the texels of the first mesh. Needs --cage.")
    ],
    "cage": Annotated[
        float | None,
        option("Largest distance between the first mesh and the mesh of --high, outside and inside, in units of the mesh."),
    ],
    "inside": Annotated[
        Literal["fill", "keep"] | None,
        option(
            "Texels inside closed bodies, such as a floor under a wall: fill copies values from the visible part of the "
            "chart, keep uses the computed values. Default: fill."
        ),
    ],
    "instances": Annotated[
        Literal["split", "mean"] | None,
        option(
            "Meshes in several places of a .glb: split copies mesh, material and texture for a place whose values differ by "
            "more than the errors; mean averages all places. Default: split."
        ),
    ],
}
"""Annotations of the options for textures, keyed by name."""


def options_of(run: BakeRun, given: dict[str, Any]) -> TextureOptions | None:
    """Check the options for textures of a run and return them; return None if the run has no `--texture`."""
    given = dict(given)
    size = given.pop("texture", None)
    if size is None:
        for name, value in given.items():
            raise ValueError(f"--{name}: got {value} without --texture; it applies only to textures")
        return None
    for name in ("points", "at", "by", "lod", "split", "context", "report"):
        if getattr(run, name):
            why = "a report describes points" if name == "report" else "a texture has its points at the texels"
            raise ValueError(f"--{name}: got {getattr(run, name)} for --texture, want none: {why}")
    samples = check_samples(given.pop("supersample", 1), "--supersample")
    parts = re.fullmatch(r"([0-9]{1,9})(?:x([0-9]{1,9}))?", size)
    if not parts:
        raise ValueError(f"--texture: got {size!r}, want a size in texels, such as 1024 or 1024x512")
    both = check_size((int(parts[1]), int(parts[2] or parts[1])), samples, "--texture")
    if "gutter" in given:
        given["gutter"] = _parse_gutter(given["gutter"])
    if "strength" in given:
        check_number(given["strength"], "--strength", 0.0, 1.0)
    if "depth" in given:
        given["depth"] = check_integer(int(given["depth"]), "--depth", 8, 16)
    if ("high" in given) != ("cage" in given):
        raise ValueError(
            "--high: got one of --high and --cage, want both: the finer mesh, and its largest distance from the first mesh"
        )
    if "high" in given:
        check_file(given["high"], "--high", "a mesh file")
        check_number(given["cage"], "--cage", 1e-30, 1e30)
    if run.quantity == "normals":
        given.setdefault("normals", "smooth")  # a normal map contains smooth normals
    return TextureOptions(both, samples=samples, **given)


def _parse_gutter(value: str) -> str | int:
    """Return a gutter as a number of texels, or "all"; raise a ValueError for other text."""
    gutter = int(value) if value.isascii() and value.isdecimal() and len(value) < 10 else value
    check_gutter(gutter, "--gutter")
    return gutter
