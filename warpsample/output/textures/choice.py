"""Options of `warpsample bake --texture`, converted from the command line."""

import re

from warpsample.host.arguments import check_file, check_integer, check_number
from warpsample.output.baked import BakeRun
from warpsample.texture.claims import check_samples, check_size
from warpsample.texture.image import check_gutter
from warpsample.texture.jobs import SCENES
from warpsample.texture.sets import TextureOptions


def texture_options(run: BakeRun) -> TextureOptions:
    """Convert the texture options of a `warpsample bake` command to `TextureOptions`, after checking their values.

    Raises:
        ValueError: an option that cannot be used; the message names the option.
        FileNotFoundError: the finer mesh does not exist.
    """
    given = dict(run.more)
    samples = check_samples(given.pop("supersample", 1), "--supersample")
    size = given.pop("texture")
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
    if "high" in given:
        check_file(given["high"], "--high", "a mesh file")
        check_number(given["cage"], "--cage", 1e-30, 1e30)
    if run.quantity == "normals":
        is_scene = given.get("high", run.mesh).suffix.lower() in SCENES
        given.setdefault("normals", "file" if is_scene else "smooth")  # as in viewers; other files have no rule for them
    return TextureOptions(both, samples=samples, **given)


def _parse_gutter(value: str) -> str | int:
    """Parse the option `--gutter`: the number of texels around charts to fill, or "all"."""
    gutter = int(value) if value.isascii() and value.isdecimal() and len(value) < 10 else value
    check_gutter(gutter, "--gutter")
    return gutter
