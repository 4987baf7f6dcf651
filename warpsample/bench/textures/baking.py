"""The benchmark: time, and error at texels and of what a viewer reads."""

from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path
from typing import Annotated, Any

import numpy as np
import typer

from warpsample.bench.record import SEED, Benchmark, Found, Picture, Repeats, Track
from warpsample.bench.rows import Spread, ToolRow, column, maybe
from warpsample.bench.running.child import ChildJob
from warpsample.bench.running.machine import peak_megabytes
from warpsample.bench.running.turns import take_turns
from warpsample.bench.scenes import bunny
from warpsample.bench.tables import TableView
from warpsample.bench.textures.lookups import LookupPlaces, places_of
from warpsample.bench.textures.painters import TEXTURE_TOOLS, Textured
from warpsample.estimate.visibility import ambient_occlusion
from warpsample.host.arguments import check_choice
from warpsample.host.engine import check_workers
from warpsample.mesh.files import load_mesh
from warpsample.mesh.files.gltf import read_corners
from warpsample.mesh.files.uv import load_uv
from warpsample.texture.claims import claims_of
from warpsample.texture.jobs import SCENES
from warpsample.texture.report import face_flaws
from warpsample.texture.shading import corner_normals_of
from warpsample.texture.texture_points import texture_points
from warpsample.texture.unwrapping import unwrap

OURS = "warpsample"
_RAYS, _SEED = 4096, 1 << 40  # of the reference
_MOST = 1 << 18  # texels, and places on the surface, at which it is known
_MOST_BIAS = 0.03
_TARGET = 0.02


@dataclass(frozen=True)
class BakedTexture(ToolRow):
    """One tool, with so many rays of each texel."""

    scene: str = column("scene")
    side: int = column("side")
    workers: int = column("threads")
    rays: int | None = maybe("rays", "of each texel")
    took: Spread | None = maybe("s", "of the whole image")
    bias: float | None = maybe("bias", "the mean error of the texels below", show="+.4f")
    rmse: float | None = maybe("RMSE", "of texels whose centres are in one face", show=".4f")
    lookup: float | None = maybe("lookup", "RMSE of bilinear lookups at places on the surface", show=".4f")
    times_ours: float | None = maybe("times ours", "as long as ours to the same RMSE, at least")
    times_read: float | None = maybe("read", "times as long as ours to the same error of lookups, at least")
    agrees: bool | None = maybe("agrees", "whether the bias is below 0.03")
    peak_megabytes: float | None = maybe("MB", "peak memory of the process", show=".0f")
    noise: float | None = maybe("noise", "the part of lookups that is another one with each seed", show=".4f")
    overlap: float | None = maybe("overlap", "at places that read a texel which another chart claims, too", show=".4f")
    resolution: float | None = maybe("resolution", "at all others; the squares of the three add up", show=".4f")
    shared: float | None = maybe("shared", "how many places these are", show=".2%")
    to_target: float | None = maybe("to 0.02", "times as long as ours to a RMSE of 0.02, between the tool's rays")


@dataclass(frozen=True, eq=False)
class Known:
    """What is right: `at_texels`, and at places of the surface."""

    texels: np.ndarray
    at_texels: np.ndarray
    places: LookupPlaces


def scene_of(asset: Path | None, part: str | None, size: int) -> Textured:
    """A file's own coordinates of the set 0 and its normals, or the bunny with new ones and means of those of faces.

    Raises:
        ValueError: a part that the file does not have; names those that it has.
    """
    if asset is None:
        mesh = bunny(0)
        split, uv = unwrap(mesh, size)
        normals = np.zeros((len(split.vertices), 3), np.float32)
        normals[split.faces] = mesh.vertex_normals[mesh.faces]
        return Textured(split, uv, normals)
    mesh, uv = load_mesh(asset), load_uv(asset)
    given = read_corners(asset, "NORMAL") if asset.suffix.lower() in SCENES else None
    normals = np.zeros((len(mesh.vertices), 3), np.float32)
    normals[mesh.faces] = corner_normals_of(mesh, given)
    if part is not None:
        named = np.array(mesh.parts) == check_choice(part, "part", sorted(set(mesh.parts)))
        uv = np.where((named[mesh.part] & (mesh.part >= 0))[:, None, None], uv, np.nan)
    return Textured(mesh, uv, normals)


def known_of(scene: Textured, size: int, rays: int = _RAYS, most: int = _MOST) -> Known:
    """What is right by many rays, of another seed, at no more than so many texels and at as many places."""
    t = texture_points(scene.mesh, scene.uv, size, normals="smooth", corner_normals=scene.normals[scene.mesh.faces])
    flaws = face_flaws(scene.uv)
    usable = ~(flaws["without_uv"] | flaws["zero_area"])
    alone = ~claims_of(t.corners, usable, t.size, 1, t.options.memory).overlapping[t.face]
    inside = np.flatnonzero(alone & (np.asarray(t.points.barycentric) > 0.0).all(axis=1))
    if not len(inside):
        raise ValueError("asset: got coordinates by which all faces overlap others, want such that do not, or a part")
    inside = np.sort(np.random.default_rng(SEED).permutation(inside)[:most])
    at_texels = ambient_occlusion(scene.mesh, t.points.take(inside), rays, seed=_SEED).value
    return Known(t.texel[inside], at_texels, places_of(t, scene.uv, most, rays, _SEED))


def build_texture(tool: str, scene: Textured, known: Known, *, size: int, workers: int) -> ChildJob:
    """One image of a tool, called as "Blender, 16 rays"; it is told of once it has been made twice."""
    name, rays = tool.removesuffix(" rays").split(", ")
    (library, make, _), _ = TEXTURE_TOOLS[name]
    paint, images = make(scene, size, workers), deque[np.ndarray](maxlen=2)

    def report() -> dict[str, Any]:
        peak = peak_megabytes()
        error = images[-1].ravel()[known.texels].astype(np.float64) - known.at_texels
        bias, rmse = float(error.mean()), float(np.sqrt(np.mean(error**2)))
        row = {"version": version(library), "rays": int(rays), "bias": bias, "rmse": rmse, **known.places.error(images)}
        shared = float(known.places.shared.mean())
        return row | {"shared": shared, "agrees": abs(bias) < _MOST_BIAS, "peak_megabytes": peak}

    return ChildJob(lambda: images.append(paint(int(rays))), report)


def measure(
    track: Track,
    *,
    side: Annotated[int, typer.Option(help="Side of the image in texels.", min=64)] = 512,
    asset: Annotated[Path | None, typer.Option(help="A file with texture coordinates; by default the bunny.")] = None,
    part: Annotated[str | None, typer.Option(help="The part of the file that gets it; others only block light.")] = None,
    repeats: Repeats = 3,
) -> Found:
    """Each tool with few rays and with more."""
    if part is not None and asset is None:
        raise ValueError(f"part: got {part!r} and no asset, want the file that it is of")
    tools = [f"{name}, {rays} rays" for name, (_, ladder) in TEXTURE_TOOLS.items() for rays in ladder]
    return {"rows": [row for size in track([side], 1) for row in compare(asset, size, tools, repeats, part=part)]}


def compare(
    asset: Path | None, size: int, tools: Sequence[str], repeats: int, *, part: str | None = None
) -> list[BakedTexture]:
    """Tools on one scene, taking turns."""
    scene, workers = scene_of(asset, part, size), check_workers(None)
    turns = take_turns(build_texture, tools, repeats, scene=scene, known=known_of(scene, size), size=size, workers=workers)

    def ladder(name: str, key: str) -> list[tuple[float, Any]]:
        return [(turns.told[tool][key], np.median(turns.seconds[tool])) for tool in turns.told if tool.startswith(name)]

    def figures(tool: str) -> dict[str, Any]:
        row, took, name = turns.told[tool], Spread.of(turns.seconds[tool]), tool.split(",", maxsplit=1)[0]
        times = {
            field: times_of(row[key], took.median, ladder(OURS, key))
            for field, key in (("times_ours", "rmse"), ("times_read", "lookup"))
        }
        to_target = seconds_to(_TARGET, ladder(name, "rmse"))
        times["to_target"] = times_of(_TARGET, to_target, ladder(OURS, "rmse")) if to_target else None
        return {**row, **times, "took": took}

    name = (part or asset.stem) if asset else "bunny"
    return turns.rows(BakedTexture, figures, scene=name, side=size, workers=workers)


def seconds_to(error: float, ladder: Sequence[tuple[float, Any]]) -> float | None:
    """How long a tool takes to an error, along lines between its (error, seconds) in logarithms.

    Where even its coarsest is better, that counts; None where its best is not as good, or where it has none.
    """
    known = np.log(sorted(ladder)).reshape(-1, 2)
    if not len(known) or np.log(error) < known[0, 0]:
        return None
    return float(np.exp(np.interp(np.log(error), *known.T)))


def times_of(error: float, seconds: float, ours: Sequence[tuple[float, Any]]) -> float | None:
    """How many times as long as ours to the same error; None where our best is not as good."""
    least = seconds_to(error, ours)
    return seconds / least if least else None


def _in_parts(row: BakedTexture) -> bool:
    return row.noise is not None


_CELLS = "took bias rmse lookup times_ours times_read peak_megabytes"
_PARTS = "lookup noise overlap resolution shared to_target"

RECORD = Benchmark(
    name="textures",
    summary="Ambient occlusion in a texture: ours, Blender and Open3D, by the error at texels and of lookups.",
    measure=measure,
    parts={"rows": BakedTexture},
    views=[
        TableView("rows", "Occlusion in a texture", "tool", _CELLS, split="scene side workers"),
        TableView(
            "rows", "What the error of lookups is made of", "tool", _PARTS, split="scene side workers", where=_in_parts
        ),
    ],
    pictures=[Picture("textures", "rows", "took", y="lookup", panels="scene side", log="xy")],
)
