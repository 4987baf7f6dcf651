"""What the command line says of textures: the options of `bake --texture`."""

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
    "texture": Annotated[str | None, option("Into a texture of so many texels a side, as 1024 or 1024x512.")],
    "uv": Annotated[
        Literal["auto", "0", "1", "new"] | None,
        option(
            "Texture coordinates: a set of the file, or new ones; by default a set with room for every face, else new ones."
        ),
    ],
    "supersample": Annotated[
        int | None, option("Points of a texel, which share its rays: the mean over the texel; by default 1.")
    ],
    "normals": Annotated[
        Literal["face", "smooth", "lifted"] | None,
        option("Of texels; by default those of the faces, or smooth for --quantity normals."),
    ],
    "gutter": Annotated[str | None, option("Texels around charts that are filled, or all, the default.")],
    "strength": Annotated[float | None, option("Of the occlusion in a .glb, 0 to 1; by default 1.")],
    "depth": Annotated[Literal["8", "16"] | None, option("Bits of a number in a .png, also within a .glb; by default 8.")],
    "strict": Annotated[
        bool,
        typer.Option(
            "--strict",
            help="Refuse texture coordinates that overlap, reach out or are flat, texels too small for float32, and "
            "--instances mean.",
        ),
    ],
    "high": Annotated[Path | None, option("A finer mesh, whose numbers are wanted at the texels of this one.")],
    "cage": Annotated[float | None, option("How far outside and inside of this mesh the finer one is looked for.")],
    "inside": Annotated[
        Literal["fill", "keep"] | None,
        option(
            "Texels inside closed bodies, as a floor under a wall: fill them from the visible part of their chart, or keep "
            "their numbers; by default fill."
        ),
    ],
    "instances": Annotated[
        Literal["split", "mean"] | None,
        option(
            "Meshes in several places of a .glb: split gives a place its own copy of mesh, material and picture where its "
            "numbers differ by more than their errors; mean gives all places the mean; by default split."
        ),
    ],
}
"""The types of the options that apply to textures."""


def options_of(run: BakeRun, given: dict[str, Any]) -> TextureOptions | None:
    """The options of a run, checked; None where it bakes no texture."""
    given = dict(given)
    size = given.pop("texture", None)
    if size is None:
        for name, value in given.items():
            raise ValueError(f"--{name}: got {value} without --texture; it applies only to textures")
        return None
    for name in ("points", "at", "by", "lod", "split", "context", "report"):
        if getattr(run, name):
            why = "it is about points" if name == "report" else "its points are texels"
            raise ValueError(f"--{name}: got {getattr(run, name)} for --texture, want none: {why}")
    samples = check_samples(given.pop("supersample", 1), "--supersample")
    parts = re.fullmatch(r"([0-9]{1,9})(?:x([0-9]{1,9}))?", size)
    if not parts:
        raise ValueError(f"--texture: got {size!r}, want texels as 1024 or 1024x512")
    both = check_size((int(parts[1]), int(parts[2] or parts[1])), samples, "--texture")
    if "gutter" in given:
        given["gutter"] = _gutter(given["gutter"])
    if "strength" in given:
        check_number(given["strength"], "--strength", 0.0, 1.0)
    if "depth" in given:
        given["depth"] = check_integer(int(given["depth"]), "--depth", 8, 16)
    if ("high" in given) != ("cage" in given):
        raise ValueError("--high: got one of --high and --cage, want both: a mesh, and how far around this one it is")
    if "high" in given:
        check_file(given["high"], "--high", "a mesh file")
        check_number(given["cage"], "--cage", 1e-30, 1e30)
    if run.quantity == "normals":
        given.setdefault("normals", "smooth")  # what a normal map shows
    return TextureOptions(both, samples=samples, **given)


def _gutter(value: str) -> str | int:
    made = int(value) if value.isascii() and value.isdecimal() and len(value) < 10 else value
    check_gutter(made, "--gutter")
    return made
