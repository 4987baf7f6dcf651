"""The benchmark: time, and error at texels and of what a viewer reads."""

from collections.abc import Sequence
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path
from typing import Annotated, Any

import numpy as np
import typer

from warpsample.bench.record import Benchmark, Found, Picture, Repeats, Track
from warpsample.bench.rows import Spread, ToolRow, column, maybe
from warpsample.bench.running.child import ChildJob
from warpsample.bench.running.machine import peak_megabytes
from warpsample.bench.running.turns import keeping_last, take_turns
from warpsample.bench.scenes import bunny
from warpsample.bench.tables import TableView
from warpsample.bench.textures.painters import TEXTURE_TOOLS, Textured
from warpsample.estimate.visibility import ambient_occlusion
from warpsample.host.engine import check_workers
from warpsample.mesh.files import load_mesh
from warpsample.mesh.files.uv import load_uv
from warpsample.mesh.mesh import unit_or_zero
from warpsample.mesh.points.sampling import sample_surface
from warpsample.mesh.surface import SurfacePoints
from warpsample.texture.texture_points import texture_points
from warpsample.texture.unwrapping import unwrap

OURS = "warpsample"
_RAYS, _SEED = 4096, 1 << 40  # of the reference
_PLACES = 4096  # on the surface, at which pictures are looked up
_MOST_BIAS = 0.03


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


@dataclass(frozen=True, eq=False)
class Known:
    """What is right: `at` texels, and at `places` of the surface by their coordinates."""

    texels: np.ndarray
    at_texels: np.ndarray
    places: np.ndarray
    at_places: np.ndarray


def scene_of(asset: Path | None, size: int) -> Textured:
    """A file's own coordinates of the set 0, or the bunny with new ones; normals are the means of those of faces."""
    if asset is not None:
        mesh = load_mesh(asset)
        return Textured(mesh, load_uv(asset), mesh.vertex_normals)
    mesh = bunny(0)
    split, uv = unwrap(mesh, size)
    normals = np.zeros((len(split.vertices), 3), np.float32)
    normals[split.faces] = mesh.vertex_normals[mesh.faces]
    return Textured(split, uv, normals)


def known_of(scene: Textured, size: int, rays: int = _RAYS) -> Known:
    """What is right by many rays, of another seed."""
    corners = scene.normals[scene.mesh.faces]
    t = texture_points(scene.mesh, scene.uv, size, normals="smooth", corner_normals=corners)
    points = t.points
    inside = np.flatnonzero((np.asarray(points.barycentric) > 0.0).all(axis=1))
    drawn = sample_surface(scene.mesh, _PLACES, seed=_SEED, barycentric=True)
    normal = unit_or_zero(np.einsum("pk,pkc->pc", drawn.barycentric, corners[drawn.face].astype(np.float64)))
    drawn = SurfacePoints(drawn.position, normal, drawn.face, drawn.barycentric)
    right = [ambient_occlusion(scene.mesh, at, rays, seed=_SEED).value for at in (points.take(inside), drawn)]
    places = np.einsum("pk,pkc->pc", drawn.barycentric, scene.uv[drawn.face])
    return Known(t.texel[inside], right[0], places, right[1])


def read(image: np.ndarray, uv: np.ndarray) -> np.ndarray:
    """(N,) of a square image (H, H) at (N, 2) coordinates, v down, as viewers read it: bilinear, clamped."""
    place = np.clip(uv * len(image) - 0.5, 0.0, len(image) - 1.0)
    low = np.minimum(place.astype(int), max(len(image) - 2, 0))
    (s, t), (x, y) = (place - low).T, low.T
    rows = [image[y + k, x] * (1.0 - s) + image[y + k, x + 1] * s for k in (0, 1)]
    return rows[0] * (1.0 - t) + rows[1] * t


def build_texture(tool: str, scene: Textured, known: Known, *, size: int, workers: int) -> ChildJob:
    """One image of a tool, called as "Blender, 16 rays"."""
    name, rays = tool.removesuffix(" rays").split(", ")
    (library, make, _), _ = TEXTURE_TOOLS[name]
    paint = make(scene, size, workers)
    work, last = keeping_last(lambda: paint(int(rays)))

    def report() -> dict[str, Any]:
        image, peak = last(), peak_megabytes()
        error = image.ravel()[known.texels].astype(np.float64) - known.at_texels
        lookup = float(np.sqrt(np.mean((read(image, known.places) - known.at_places) ** 2)))
        bias, rmse = float(error.mean()), float(np.sqrt(np.mean(error**2)))
        row = {"version": version(library), "rays": int(rays), "bias": bias, "rmse": rmse, "lookup": lookup}
        return row | {"agrees": abs(bias) < _MOST_BIAS, "peak_megabytes": peak}

    return ChildJob(work, report)


def measure(
    track: Track,
    *,
    side: Annotated[int, typer.Option(help="Side of the image in texels.", min=64)] = 512,
    asset: Annotated[Path | None, typer.Option(help="A file with texture coordinates; by default the bunny.")] = None,
    repeats: Repeats = 3,
) -> Found:
    """Each tool with few rays and with more."""
    tools = [f"{name}, {rays} rays" for name, (_, ladder) in TEXTURE_TOOLS.items() for rays in ladder]
    return {"rows": [row for size in track([side], 1) for row in compare(asset, size, tools, repeats)]}


def compare(asset: Path | None, size: int, tools: Sequence[str], repeats: int) -> list[BakedTexture]:
    """Tools on one scene, taking turns."""
    scene, workers = scene_of(asset, size), check_workers(None)
    turns = take_turns(build_texture, tools, repeats, scene=scene, known=known_of(scene, size), size=size, workers=workers)
    ours = [tool for tool in turns.told if tool.startswith(OURS)]

    def figures(tool: str) -> dict[str, Any]:
        row, took = turns.told[tool], Spread.of(turns.seconds[tool])
        times = {
            field: times_of(row[key], took.median, [(turns.told[own][key], np.median(turns.seconds[own])) for own in ours])
            for field, key in (("times_ours", "rmse"), ("times_read", "lookup"))
        }
        return {**row, **times, "took": took}

    return turns.rows(BakedTexture, figures, scene=asset.stem if asset else "bunny", side=size, workers=workers)


def times_of(error: float, seconds: float, ours: Sequence[tuple[float, Any]]) -> float | None:
    """How many times as long as ours to the same error, along lines between our (error, seconds) in logarithms.

    Where even our coarsest is better, it counts; None where our best is not as good.
    """
    known = np.log(sorted(ours))
    if np.log(error) < known[0, 0]:
        return None
    return float(seconds / np.exp(np.interp(np.log(error), *known.T)))


_CELLS = "took bias rmse lookup times_ours times_read peak_megabytes"

RECORD = Benchmark(
    name="textures",
    summary="Ambient occlusion in a texture: ours, Blender and Open3D, by the error at texels and of lookups.",
    measure=measure,
    parts={"rows": BakedTexture},
    views=[TableView("rows", "Occlusion in a texture", "tool", _CELLS, split="scene side workers")],
    pictures=[Picture("textures", "rows", "took", y="lookup", panels="scene side", log="xy")],
)
