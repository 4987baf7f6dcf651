"""Time, error at texels and error of lookups of textures baked by each tool."""

from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path
from typing import Annotated, Any

import numpy as np
import typer

from warpsample.bench.record import SEED, Benchmark, Picture, Repeats, RowsByPart, Track
from warpsample.bench.rows import Spread, ToolRow, column, optional_column
from warpsample.bench.running.child import ChildJob
from warpsample.bench.running.machine import measure_peak_megabytes
from warpsample.bench.running.turns import run_tools
from warpsample.bench.scenes import bunny
from warpsample.bench.tables import TableView
from warpsample.bench.textures.lookups import LookupPlaces, sample_places
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
    """Time and error of one tool with one number of rays per texel."""

    scene: str = column("scene")
    side: int = column("side")
    workers: int = column("threads")
    rays: int | None = optional_column("rays", "of each texel")
    took: Spread | None = optional_column("s", "of the whole image")
    bias: float | None = optional_column("bias", "the mean error of the texels below", show="+.4f")
    rmse: float | None = optional_column("RMSE", "of texels whose centres are in one face", show=".4f")
    lookup: float | None = optional_column("lookup", "RMSE of bilinear lookups at places on the surface", show=".4f")
    times_ours: float | None = optional_column("times ours", "as long as ours to the same RMSE, at least")
    times_read: float | None = optional_column("read", "times as long as ours to the same error of lookups, at least")
    agrees: bool | None = optional_column("agrees", "whether the bias is below 0.03")
    peak_megabytes: float | None = optional_column("MB", "peak memory of the process", show=".0f")
    noise: float | None = optional_column("noise", "the part of lookups that is another one with each seed", show=".4f")
    overlap: float | None = optional_column(
        "overlap", "at places that read a texel which another chart claims, too", show=".4f"
    )
    resolution: float | None = optional_column("resolution", "at all others; the squares of the three add up", show=".4f")
    shared: float | None = optional_column("shared", "how many places these are", show=".2%")
    to_target: float | None = optional_column("to 0.02", "times as long as ours to a RMSE of 0.02, between the tool's rays")


@dataclass(frozen=True, eq=False)
class Known:
    """Reference values.

    Attributes:
        texels: indices of the texels with a reference value.
        at_texels: reference values at these texels.
        places: sample positions on the surface, with reference values.
    """

    texels: np.ndarray
    at_texels: np.ndarray
    places: LookupPlaces


def load_scene(asset: Path | None, part: str | None, size: int) -> Textured:
    """Load an asset with its texture coordinates and normals, or the bunny without an asset.

    The bunny is unwrapped anew, with the means of its face normals.

    Raises:
        ValueError: the file has no part of this name; lists the names.
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


def compute_known(scene: Textured, size: int, rays: int = _RAYS, most: int = _MOST) -> Known:
    """Compute reference values with many rays and another seed, at up to `most` texels and at `most` sample positions."""
    t = texture_points(scene.mesh, scene.uv, size, normals="smooth", corner_normals=scene.normals[scene.mesh.faces])
    flaws = face_flaws(scene.uv)
    usable = ~(flaws["without_uv"] | flaws["zero_area"])
    alone = ~claims_of(t.corners, usable, t.size, 1, t.options.memory).overlapping[t.face]
    inside = np.flatnonzero(alone & (np.asarray(t.points.barycentric) > 0.0).all(axis=1))
    if not len(inside):
        raise ValueError("asset: got coordinates by which all faces overlap others, want such that do not, or a part")
    inside = np.sort(np.random.default_rng(SEED).permutation(inside)[:most])
    at_texels = ambient_occlusion(scene.mesh, t.points.take(inside), rays, seed=_SEED).value
    return Known(t.texel[inside], at_texels, sample_places(t, scene.uv, most, rays, _SEED))


def build_texture(tool: str, scene: Textured, known: Known, *, size: int, workers: int) -> ChildJob:
    """Build one image by a tool, named as in "Blender, 16 rays"; the report needs two runs."""
    name, rays = tool.removesuffix(" rays").split(", ")
    (library, make, _), _ = TEXTURE_TOOLS[name]
    paint, images = make(scene, size, workers), deque[np.ndarray](maxlen=2)

    def report() -> dict[str, Any]:
        peak = measure_peak_megabytes()
        error = images[-1].ravel()[known.texels].astype(np.float64) - known.at_texels
        bias, rmse = float(error.mean()), float(np.sqrt(np.mean(error**2)))
        row = {
            "version": version(library),
            "rays": int(rays),
            "bias": bias,
            "rmse": rmse,
            **known.places.compute_error(images),
        }
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
) -> RowsByPart:
    """Measure each tool with several numbers of rays."""
    if part is not None and asset is None:
        raise ValueError(f"part: got {part!r} and no asset, want the file that it is of")
    tools = [f"{name}, {rays} rays" for name, (_, ladder) in TEXTURE_TOOLS.items() for rays in ladder]
    return {"rows": [row for size in track([side], 1) for row in compare(asset, size, tools, repeats, part=part)]}


def compare(
    asset: Path | None, size: int, tools: Sequence[str], repeats: int, *, part: str | None = None
) -> list[BakedTexture]:
    """Compare tools on one scene, with alternating runs."""
    scene, workers = load_scene(asset, part, size), check_workers(None)
    turns = run_tools(
        build_texture, tools, repeats, scene=scene, known=compute_known(scene, size), size=size, workers=workers
    )

    def ladder(name: str, key: str) -> list[tuple[float, Any]]:
        return [
            (turns.reports[tool][key], np.median(turns.seconds[tool])) for tool in turns.reports if tool.startswith(name)
        ]

    def figures(tool: str) -> dict[str, Any]:
        row, took, name = turns.reports[tool], Spread.of(turns.seconds[tool]), tool.split(",", maxsplit=1)[0]
        times = {
            field: compare_times(row[key], took.median, ladder(OURS, key))
            for field, key in (("times_ours", "rmse"), ("times_read", "lookup"))
        }
        to_target = interpolate_seconds(_TARGET, ladder(name, "rmse"))
        times["to_target"] = compare_times(_TARGET, to_target, ladder(OURS, "rmse")) if to_target else None
        return {**row, **times, "took": took}

    name = (part or asset.stem) if asset else "bunny"
    return turns.rows(BakedTexture, figures, scene=name, side=size, workers=workers)


def interpolate_seconds(error: float, ladder: Sequence[tuple[float, Any]]) -> float | None:
    """Return a tool's seconds to an error, interpolated linearly in logarithms between its (error, seconds).

    For an error above the largest, return the seconds of the largest. Return None for an error below the smallest, or
    without measurements.
    """
    known = np.log(sorted(ladder)).reshape(-1, 2)
    if not len(known) or np.log(error) < known[0, 0]:
        return None
    return float(np.exp(np.interp(np.log(error), *known.T)))


def compare_times(error: float, seconds: float, ours: Sequence[tuple[float, Any]]) -> float | None:
    """Return the ratio of `seconds` to warpsample's seconds for an error; None if warpsample's best error is larger."""
    least = interpolate_seconds(error, ours)
    return seconds / least if least else None


def _has_parts(row: BakedTexture) -> bool:
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
            "rows", "What the error of lookups is made of", "tool", _PARTS, split="scene side workers", where=_has_parts
        ),
    ],
    pictures=[Picture("textures", "rows", "took", y="lookup", panels="scene side", log="xy")],
)
