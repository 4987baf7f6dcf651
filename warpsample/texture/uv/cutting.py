"""Cutting of meshes into charts with xatlas, and the size of charts."""

from typing import Any, NamedTuple

import numpy as np

from warpsample.texture.uv.charts import (
    POINT,
    find_areas,
    find_edge_lengths,
    find_flat_areas,
    find_longest_edges,
    find_wide,
    label_charts,
)
from warpsample.texture.uv.overlaps import divide_overlaps
from warpsample.texture.uv.packing import Charts, find_scale, measure_charts, new_atlas

_SHEET = 4096  # texels: side of the images in which xatlas hands over charts
_FINE = 1e6  # texels along the largest mesh there: xatlas rounds charts up to whole texels before it shrinks long ones
_SHORTEST, _LONGEST = 8, 256  # texels: longest charts there, in meshes of very many faces and of few
_TOO_LONG = 1.05  # largest length of charts of slivers alone, in sides of the image
_STRETCHED = 1.5  # largest length of a chart with slivers, in lengths of the chart without slivers
_SIDE = 1024  # texels: overlaps are looked for at least as finely as in images of this side
_MOST = 2.0**22  # pixels of all charts among which overlaps are looked for,
_LEAST = 2.0**12  # but at least so many in each chart, or as many as it has texels
_SHRUNK = 0.95  # least scale with slivers, in scales without slivers
_ROUNDS = 4  # most times that narrowed faces are cut again
_WIDE = 4.0  # texels: narrower faces are not cut again
_NARROWED = 7.0  # least ratio of the widths in space and in the chart of faces that are cut again; 8 can be refused
_LONG = 0.8  # least length of a long edge in a chart, in lengths of the longest

Meshes = list[tuple[np.ndarray, np.ndarray]]
"""Vertices (V, 3) and faces (F, 3) of each mesh."""


class Cut(NamedTuple):
    """Faces of all meshes that have a chart.

    Attributes:
        mesh: (F,) number of each face's mesh.
        row: (F,) row of each face in its mesh.
        is_wide: (F,) whether it is no sliver.
        old: (V,) vertex in its mesh for each vertex of the charts.
        positions: (V, 3) positions of these vertices in space.
        charts: the charts of these faces.
    """

    mesh: np.ndarray
    row: np.ndarray
    is_wide: np.ndarray
    old: np.ndarray
    positions: np.ndarray
    charts: Charts

    def select(self, mask: np.ndarray) -> "Cut":
        """Return the charts of some faces only."""
        charts = measure_charts(self.charts.places, self.charts.faces[mask], self.charts.chart[mask])
        return self._replace(mesh=self.mesh[mask], row=self.row[mask], is_wide=self.is_wide[mask], charts=charts)


def cut_meshes(meshes: Meshes, size: int, padding: int) -> Cut:
    """Compute the charts of all meshes for an image of `size` texels.

    In charts of rough surfaces, xatlas makes single faces far too narrow or small. These are cut again, apart.

    Raises:
        ValueError: xatlas takes none of the faces.
    """
    cut = _cut_without_slivers(meshes, size, padding)
    for _ in range(_ROUNDS):
        narrowed = _find_narrowed(cut, find_scale(cut.charts, size, padding))
        if narrowed.all() or not narrowed.any():
            break
        rows = [cut.row[narrowed & (cut.mesh == i)] for i in range(len(meshes))]
        cut = _join(cut.select(~narrowed), _cut(meshes, rows))
    return cut


def _cut_without_slivers(meshes: Meshes, size: int, padding: int) -> Cut:
    """Return the charts of all meshes.

    Slivers by rounding may have huge charts, or make all other charts smaller. Then charts are computed again without the
    slivers that are connected to other faces. Charts of slivers alone are left out if they are longer than the image.
    """
    cut = _cut(meshes, [np.arange(len(faces)) for _, faces in meshes])
    if cut.is_wide.all() or not cut.is_wide.any():
        return cut
    loose = [_find_loose(*own) for own in meshes]
    starts = np.cumsum([0] + [len(own) for own in loose])
    without = _leave_out_long(cut.select(np.concatenate(loose)[starts[cut.mesh] + cut.row]), size, padding)
    cut, scale = _leave_out_long(cut, size, padding), find_scale(without.charts, size, padding)
    if find_scale(cut.charts, size, padding) >= _SHRUNK * scale and not _is_stretched(cut, 1.0 / scale):
        return cut
    return _leave_out_long(_cut(meshes, [np.flatnonzero(own) for own in loose]), size, padding)


def separate_overlaps(cut: Cut, size: int, padding: int) -> Cut:
    """Return charts that do not lie on themselves, by pixels about as large as the texels of an image of `size` texels."""
    charts, positions = cut.charts, cut.positions[cut.charts.faces]
    texels = charts.areas * find_scale(charts, max(size, _SIDE), padding) ** 2
    pixels = np.maximum(texels * (_MOST / max(_MOST, texels.sum())), np.minimum(texels, _LEAST))
    chart = divide_overlaps(charts.places[charts.faces], positions, charts.chart, pixels)
    if chart.max() == charts.chart.max():
        return cut
    count = len(charts.places)
    vertex, corner = np.unique(chart[:, None] * count + charts.faces, return_inverse=True)
    own = vertex % count
    charts = measure_charts(charts.places[own], corner.reshape(-1, 3), chart)
    return cut._replace(old=cut.old[own], positions=cut.positions[own], charts=charts)


def _find_narrowed(cut: Cut, scale: float) -> np.ndarray:
    """Return the mask of faces that are several texels wide in space, and far narrower in their charts.

    The width in space is that at the scale of the charts, or at the scale of a long edge of the face if that is larger.

    Args:
        cut: faces with charts.
        scale: texels per unit of length.
    """
    corners, places = cut.positions[cut.charts.faces], cut.charts.places[cut.charts.faces]
    edges, lengths = find_edge_lengths(corners), find_edge_lengths(places)
    longest = lengths.max(axis=1)
    stretch = np.where(lengths > _LONG * longest[:, None], lengths, 0.0) / np.maximum(edges, POINT) ** 2
    stretch = np.maximum(stretch.max(axis=1), 1.0 / np.maximum(edges.max(axis=1), POINT))
    width = 2.0 * find_areas(corners) * stretch
    is_narrow = _NARROWED * 2.0 * find_flat_areas(places) < width * longest
    return cut.is_wide & is_narrow & (width * scale > _WIDE)


def _join(first: Cut, second: Cut) -> Cut:
    """Return the faces of two cuts, ordered by mesh and row, with their charts."""
    order = np.lexsort((np.r_[first.row, second.row], np.r_[first.mesh, second.mesh]))
    mesh, row, is_wide = (np.concatenate(own)[order] for own in zip(first[:3], second[:3], strict=True))
    old, positions = (np.concatenate(own) for own in zip(first[3:5], second[3:5], strict=True))
    one, other = first.charts, second.charts
    faces = np.concatenate([one.faces, other.faces + len(one.places)])[order]
    chart = np.r_[one.chart, other.chart + len(one.sizes)][order]
    charts = _scale_charts(np.concatenate([one.places, other.places]), faces, chart, positions[faces])
    return Cut(mesh, row, is_wide, old, positions, charts)


def _find_loose(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """Return the mask of faces that are no slivers, or are connected to slivers only."""
    wide, label = find_wide(vertices[faces]), label_charts(vertices[faces].astype(np.float64))
    return wide | (np.bincount(label, wide) == 0)[label]


def _leave_out_long(cut: Cut, size: int, padding: int) -> Cut:
    """Leave out charts of slivers alone that are longer than the image."""
    charts = cut.charts
    scale = find_scale(cut.select(cut.is_wide).charts, size, padding)
    is_long = (np.bincount(charts.chart, cut.is_wide) == 0) & (charts.sizes.max(axis=1) * scale > _TOO_LONG * size)
    return cut.select(~is_long[charts.chart])


def _is_stretched(cut: Cut, texel: float) -> bool:
    """Return whether slivers make any chart longer than its other faces are, by more than a texel."""
    wide, number = cut.select(cut.is_wide).charts, np.unique(cut.charts.chart[cut.is_wide])
    lengths = cut.charts.sizes[number].max(axis=1)
    return bool((lengths > _STRETCHED * wide.sizes.max(axis=1) + texel).any())


def _cut(meshes: Meshes, kept: list[np.ndarray]) -> Cut:
    """Return the charts of some faces of each mesh."""
    shown = [(i, meshes[i][0], meshes[i][1][rows], rows) for i, rows in enumerate(kept) if len(rows)]
    atlas = _fill_atlas([(vertices, faces) for _, vertices, faces, _ in shown])
    made = [(*atlas.get_mesh(i), atlas.get_mesh_vertex_assignment(i)[1].astype(np.int32)) for i in range(len(shown))]
    starts = np.cumsum([0] + [len(old) for old, _, _, _ in made])
    faces = np.concatenate(
        [corners.astype(np.int64) + start for (_, corners, _, _), start in zip(made, starts, strict=False)]
    )
    old, _, uv, chart = (np.concatenate(own) for own in zip(*made, strict=True))
    places = uv.astype(np.float64) * (atlas.width, atlas.height)
    drawn = (chart[faces] >= 0).all(axis=1) & np.isfinite(places[faces]).all(axis=(1, 2))
    if not drawn.any():
        raise ValueError("mesh: got only faces without an area, want at least one face with an area")
    positions = np.concatenate([vertices[own[0]] for (_, vertices, _, _), own in zip(shown, made, strict=True)])
    positions = positions.astype(np.float64)
    corners, chart = positions[faces[drawn]], chart[faces[drawn, 0]]
    places = _restore_places(places, positions, faces[drawn], chart)
    mesh, row = np.concatenate([np.stack([np.full(len(rows), i), rows]) for i, _, _, rows in shown], axis=1)
    charts = _scale_charts(places, faces[drawn], chart, corners)
    return Cut(mesh[drawn], row[drawn], find_wide(corners), old, positions, charts)


def _fill_atlas(meshes: Meshes) -> Any:
    """Return an atlas with the charts of some meshes.

    xatlas hands over charts only in an image. In this one, charts have few texels, so that even huge charts are packed
    quickly. Charts may be in several images of one size.
    """
    import xatlas

    atlas = new_atlas()
    for vertices, faces in meshes:
        atlas.add_mesh(vertices, faces)
    options = xatlas.PackOptions()
    options.resolution, options.padding, options.rotate_charts, options.bilinear = _SHEET, 0, False, False
    diagonal = max(float(np.linalg.norm(np.ptp(vertices[faces], axis=(0, 1)))) for vertices, faces in meshes)
    options.texels_per_unit = _FINE / (diagonal or 1.0)
    side = _SHEET / np.sqrt(sum(len(faces) for _, faces in meshes))
    options.max_chart_size = int(np.clip(side, _SHORTEST, _LONGEST))
    atlas.generate(pack_options=options)
    return atlas


def _restore_places(places: np.ndarray, positions: np.ndarray, faces: np.ndarray, chart: np.ndarray) -> np.ndarray:
    """Return places where charts that xatlas shrinks to a point, small ones in a large scene, are projected on a plane.

    Args:
        places: (V, 2) places of the vertices.
        positions: (V, 3) positions of the vertices in space.
        faces: (F, 3) vertices of each face.
        chart: (F,) number of each face's chart.
    """
    lost = np.flatnonzero((np.bincount(chart, np.ptp(places[faces], axis=1).sum(axis=1)) == 0.0)[chart])
    corners = positions[faces[lost]]
    crosses = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals = np.column_stack([np.bincount(chart[lost], own) for own in crosses.T])[chart[lost]]
    across = np.cross(normals, np.eye(3)[np.abs(normals).argmin(axis=1)])
    planes = np.stack([across, np.cross(normals, across)], axis=1)
    planes /= np.maximum(np.linalg.norm(planes, axis=2), np.finfo(np.float64).tiny)[:, :, None]
    places = places.copy()
    places[faces[lost]] = corners @ planes.transpose(0, 2, 1)
    return places


def _scale_charts(places: np.ndarray, faces: np.ndarray, chart: np.ndarray, corners: np.ndarray) -> Charts:
    """Return charts as large as in space.

    A chart has the area in space of its faces other than slivers. A chart of slivers alone has their length.

    Args:
        places: (V, 2) places of the vertices, in an unknown unit in each chart.
        faces: (F, 3) vertices of each face.
        chart: (F,) number of each face's chart.
        corners: (F, 3, 3) corners of each face in space.
    """
    flat, wide = places[faces], find_wide(corners)
    area, flat_area = np.bincount(chart, wide * find_areas(corners)), np.bincount(chart, wide * find_flat_areas(flat))
    with np.errstate(divide="ignore", invalid="ignore"):
        by_length = np.bincount(chart, find_longest_edges(corners)) / np.bincount(chart, find_longest_edges(flat))
        scale = np.where(area * flat_area > 0.0, np.sqrt(area / flat_area), by_length)
    owner = np.zeros(len(places), np.int64)
    owner[faces] = chart[:, None]
    scaled = np.nan_to_num(places) * np.nan_to_num(scale, posinf=0.0)[owner, None]
    return measure_charts(scaled, faces, chart)
