"""`bench textures`: time of baking textures, and error at texels and at positions looked up, for each tool."""

from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path
from typing import Annotated, Any

import numpy as np
import typer

from warpsample.bench.record import SEED, Benchmark, Picture, Repeats, RowsByPart, Track
from warpsample.bench.reporting.tables import TableView
from warpsample.bench.rows import Spread, ToolRow, column, optional_column
from warpsample.bench.running.child import ChildJob
from warpsample.bench.running.machine import measure_peak_megabytes
from warpsample.bench.running.turns import run_tools
from warpsample.bench.scenes import bunny
from warpsample.bench.textures.lookups import LookupPlaces, sample_places
from warpsample.bench.textures.painters import TEXTURE_TOOLS, Textured
from warpsample.estimate.visibility import ambient_occlusion
from warpsample.host.arguments import check_choice
from warpsample.host.engine import check_workers
from warpsample.mesh.files import load_mesh
from warpsample.mesh.files.gltf import read_corners
from warpsample.mesh.files.uv import load_uv
from warpsample.texture.claims import claim_points
from warpsample.texture.jobs import SCENES
from warpsample.texture.report import find_face_flaws
from warpsample.texture.shading import compute_corner_normals
from warpsample.texture.texture_points import texture_points
from warpsample.texture.uv.unwrapping import unwrap

OURS = "warpsample"
_RAYS, _SEED = 4096, 1 << 40  # rays per texel and seed of the reference
_MOST = 1 << 18  # texels, and sample positions on the surface, with a reference
_MOST_BIAS = 0.03
_TARGET = 0.02


@dataclass(frozen=True)
class BakedTexture(ToolRow):
    """Row of `bench textures`: time and error of one tool with one number of rays per texel."""

    scene: str = column("scene")
    side: int = column("side")
    workers: int = column("threads")
    rays: int | None = optional_column("rays", "rays per texel")
    took: Spread | None = optional_column("seconds", "time of the whole image")
    bias: float | None = optional_column("bias", "mean error of texels with their centre in one face", show="+.4f")
    rmse: float | None = optional_column("RMSE", "RMSE of texels with their centre in one face", show=".4f")
    lookup: float | None = optional_column(
        "lookup", "RMSE of bilinear lookups at sample positions on the surface", show=".4f"
    )
    times_ours: float | None = optional_column(
        "time / warpsample", "time over warpsample's at the same RMSE of texels; a lower bound"
    )
    times_read: float | None = optional_column(
        "same for lookups", "time over warpsample's at the same error of lookups; a lower bound"
    )
    agrees: bool | None = optional_column("agrees", "True if the bias is below 0.03")
    peak_megabytes: float | None = optional_column("peak MB", "peak memory of the process", show=".0f")
    noise: float | None = optional_column("noise", "part of the error of lookups that changes with the seed", show=".4f")
    overlap: float | None = optional_column(
        "overlap", "common error at positions that read a texel which another chart claims too", show=".4f"
    )
    resolution: float | None = optional_column(
        "resolution", "common error at the other positions; the squares of the three parts add up", show=".4f"
    )
    shared: float | None = optional_column("shared", "fraction of positions that read a texel of another chart", show=".2%")
    to_target: float | None = optional_column(
        "time / warpsample to 0.02", "time over warpsample's to an RMSE of 0.02, interpolated between ray counts"
    )


@dataclass(frozen=True, eq=False)
class Known:
    """Reference values of ambient occlusion at texels and at sample positions.

    Attributes:
        texels: indices of the texels with a reference value.
        at_texels: reference values at these texels.
        places: sample positions on the surface, with reference values.
    """

    texels: np.ndarray
    at_texels: np.ndarray
    places: LookupPlaces


def load_scene(asset: Path | None, part: str | None, size: int) -> Textured:
    """Load a mesh with texture coordinates and normals from a file; without a file, load the bunny.

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
    file_normals = read_corners(asset, "NORMAL") if asset.suffix.lower() in SCENES else None
    normals = np.zeros((len(mesh.vertices), 3), np.float32)
    normals[mesh.faces] = compute_corner_normals(mesh, file_normals)
    if part is not None:
        is_in_part = np.array(mesh.parts) == check_choice(part, "part", sorted(set(mesh.parts)))
        uv = np.where((is_in_part[mesh.part] & (mesh.part >= 0))[:, None, None], uv, np.nan)
    return Textured(mesh, uv, normals)


def compute_known(scene: Textured, size: int, rays: int = _RAYS, most: int = _MOST) -> Known:
    """Compute reference values of ambient occlusion at up to `most` texels and at `most` sample positions.

    They use many rays and another seed.
    """
    t = texture_points(scene.mesh, scene.uv, size, normals="smooth", corner_normals=scene.normals[scene.mesh.faces])
    flaws = find_face_flaws(scene.uv)
    usable = ~(flaws["without_uv"] | flaws["zero_area"])
    alone = ~claim_points(t.corners, usable, t.size, 1, t.options.memory).overlapping[t.face]
    inside = np.flatnonzero(alone & (np.asarray(t.points.barycentric) > 0.0).all(axis=1))
    if not len(inside):
        raise ValueError(
            "asset: got texture coordinates in which all faces overlap, want faces without overlap; or pass --part"
        )
    inside = np.sort(np.random.default_rng(SEED).permutation(inside)[:most])
    at_texels = ambient_occlusion(scene.mesh, t.points.take(inside), rays, seed=_SEED).value
    return Known(t.texel[inside], at_texels, sample_places(t, scene.uv, most, rays, _SEED))


def build_texture(tool: str, scene: Textured, known: Known, *, size: int, workers: int) -> ChildJob:
    """Prepare a tool with a number of rays, for example "Blender, 16 rays", to bake one image; return the work to time.

    The job's report needs two runs.
    """
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
    side: Annotated[int, typer.Option(help="Side of the square image in texels.", min=128)] = 512,
    asset: Annotated[
        Path | None, typer.Option(help="Path of a mesh with texture coordinates, for example in.glb. Default: the bunny.")
    ] = None,
    part: Annotated[
        str | None,
        typer.Option(help="Name of the part of the asset to bake; the other parts only block light. Default: all parts."),
    ] = None,
    repeats: Repeats = 3,
) -> RowsByPart:
    """Measure the baking of ambient occlusion by each tool with several numbers of rays; return the rows."""
    if part is not None and asset is None:
        raise ValueError(f"part: got {part!r} without asset, want both: pass --asset, the mesh file that contains the part")
    tools = [f"{name}, {rays} rays" for name, (_, ladder) in TEXTURE_TOOLS.items() for rays in ladder]
    return {"rows": [row for size in track([side], 1) for row in compare(asset, size, tools, repeats, part=part)]}


def compare(
    asset: Path | None, size: int, tools: Sequence[str], repeats: int, *, part: str | None = None
) -> list[BakedTexture]:
    """Measure the baking of one scene by several tools, with alternating runs."""
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
    """Interpolate a tool's time for an error, in seconds, from its measured (error, seconds) pairs.

    The interpolation is linear in logarithms. For an error above the largest, return the seconds of the largest. Return None
    for an error below the smallest, or without measurements.
    """
    ladder_logs = np.log(sorted(ladder)).reshape(-1, 2)
    if not len(ladder_logs) or np.log(error) < ladder_logs[0, 0]:
        return None
    return float(np.exp(np.interp(np.log(error), *ladder_logs.T)))


def compare_times(error: float, seconds: float, ours: Sequence[tuple[float, Any]]) -> float | None:
    """Return the ratio of `seconds` to warpsample's seconds for the same error.

    Return None if warpsample's best error is larger.
    """
    least = interpolate_seconds(error, ours)
    return seconds / least if least else None


def _select_for_page(rows: list[BakedTexture]) -> list[BakedTexture]:
    return [row for row in rows if row.rays == 64]


def _has_parts(row: BakedTexture) -> bool:
    return row.noise is not None


_CELLS = "took bias rmse lookup times_ours times_read peak_megabytes"
_PARTS = "lookup noise overlap resolution shared to_target"

RECORD = Benchmark(
    name="textures",
    summary="Compare ambient occlusion baked into a texture by warpsample, Blender and Open3D.",
    measure=measure,
    parts={"rows": BakedTexture},
    views=[
        TableView("rows", "Occlusion in a texture", "tool", _CELLS, split="scene side workers"),
        TableView(
            "rows",
            "Parts of the error of lookups",
            "tool",
            _PARTS,
            split="scene side workers",
            where=_has_parts,
            page_rows=_select_for_page,
        ),
    ],
    pictures=[Picture("textures", "rows", "took", y="lookup", panels="scene side", log="xy")],
)
