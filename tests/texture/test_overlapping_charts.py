"""New texture coordinates of surfaces that lie above themselves: xatlas projects them, and lays parts on each other."""

import numpy as np
import pytest
from meshes import quads

import warpsample as ws
from warpsample.texture.uv import overlaps
from warpsample.texture.uv.charts import label_charts
from warpsample.texture.uv.cutting import cut_meshes, separate_overlaps


def coil(turns, steps, profile, pitch):
    """A profile (S, 2), of radius and height, that is carried around the z axis and rises by `pitch` each turn."""
    angle = np.linspace(0, 2 * np.pi * turns, round(turns * steps) + 1)[:, None]
    radius, height = (own + np.zeros_like(angle) for own in profile.T)
    height = height + pitch * angle / (2 * np.pi)
    vertices = np.stack([radius * np.cos(angle), radius * np.sin(angle), height], axis=2).reshape(-1, 3)
    return vertices, quads(len(angle), len(profile))


def road(curve, width, rise):
    """A road along a curve (n, 2), that rises from its start to its end."""
    ahead = np.gradient(curve, axis=0)
    beside = 0.5 * width * np.column_stack([-ahead[:, 1], ahead[:, 0]]) / np.linalg.norm(ahead, axis=1)[:, None]
    height = np.linspace(0, rise, len(curve))
    sides = [np.column_stack([curve + side * beside, height]) for side in (1, -1)]
    return np.concatenate(sides), quads(2, len(curve))


def eight(steps, rise):
    angle = np.linspace(0.4, 0.4 + 3.98 * np.pi, steps + 1)
    return road(np.column_stack([5 * np.sin(angle), 2.5 * np.sin(2 * angle)]), 0.3, rise)


def uneven_spiral():
    """Turns of 400 narrow steps and of 8 wide ones; the steps of all turns have the same places from above."""
    angle = np.concatenate([turn + np.linspace(0, 1, (400, 8)[turn % 2], endpoint=False) for turn in range(4)])
    angle, wide = 2 * np.pi * angle, np.floor(angle) % 2 == 1
    radii = 0.65 + np.where(wide, 0.3, 0.02) * np.array([[-1], [1]])
    sides = [np.column_stack([own * np.cos(angle), own * np.sin(angle), 1e-4 * angle]) for own in radii]
    return np.concatenate(sides), quads(2, len(angle))


TURN = np.linspace(0, 2 * np.pi, 9) + 0.2
WIRE = np.column_stack([1 + 0.1 * np.cos(TURN), 0.1 * np.sin(TURN)])
DECK = np.array([(3.0, 0), (6, 0)])
SHAPES = {
    "ramp of 64 faces": lambda: coil(4, 8, DECK, 0.3),
    "ramp of 32 turns": lambda: coil(32, 48, DECK / 6, 0.02),
    "ramp of 2.25 turns": lambda: coil(2.25, 96, DECK, 0.3),
    "flat ring of 1.1 turns": lambda: coil(1.1, 96, DECK, 0),
    "spring": lambda: coil(5, 450, WIRE, 0.3),
    "eight of 80 faces": lambda: eight(40, 0.05),
    "flat eight": lambda: eight(300, 0.0),
    "uneven spiral": uneven_spiral,
}


SIMILAR = ("ramp of 32 turns", "flat ring of 1.1 turns", "eight of 80 faces")  # to the others


@pytest.mark.parametrize(
    "shape", [pytest.param(one, marks=pytest.mark.thorough) if one in SIMILAR else one for one in SHAPES]
)
def test_no_chart_lies_on_itself(shape):
    """98 % of the texels of the first ramp and 9 % of the spring lay in two turns; charts remain large, and apart."""
    split, uv = ws.unwrap(ws.Mesh(*SHAPES[shape]()), 512)
    t = ws.texture_points(split, uv, 512)
    assert (t.report.overlapped, t.report.zero_area) == (0, 0)
    label = label_charts(uv)
    assert label.max() < (400 if shape == "spring" else 36)  # 220 to 260, and 33 for 32 turns, were measured
    chart = np.full(512 * 512, -1)
    chart[t.texel] = label[t.face]
    chart = chart.reshape(512, 512)
    for step in (1, 2):  # padding is 4, and texels that are covered reach up to 1 beyond each chart
        for first, second in ((chart[:, step:], chart[:, :-step]), (chart[step:], chart[:-step])):
            both = (first >= 0) & (second >= 0)
            assert (first[both] == second[both]).all()


def test_long_faces_make_no_pixels_larger(monkeypatch):
    """Faces are drawn in blocks. Folds were missed with larger pixels, in a chart of narrow faces or beside long strips."""
    coils = [coil(2, 24, DECK / 6, 1e-3)] * 40 + [coil(2, 4000, DECK / 6, 1e-3)]
    strip = np.array([(0.0, 0, 0), (7, 7, 0), (7, 7.001, 0), (0, 0.001, 0)])[[(0, 1, 2), (0, 2, 3)]]
    positions = [vertices[faces] for vertices, faces in coils]
    positions.append(np.concatenate([np.add(strip, [0, 0.001 * k, 0]) for k in range(1000)]))
    places = np.concatenate([own[:, :, :2] + 5.0 * k for k, own in enumerate(positions)])
    chart = np.repeat(np.arange(42), [len(own) for own in positions])
    made = []
    for rows in (2.0**12, 2.0**22):
        monkeypatch.setattr(overlaps, "_ROWS", rows)
        made.append(overlaps.divide_overlaps(places, np.concatenate(positions), chart, np.full(42, 2.0**15)))
    assert np.array_equal(*made)
    assert made[0].max() + 1 == 2 * 41 + 1


def test_small_charts_of_large_images_are_drawn_as_finely_as_their_texels():
    """Lock washers a few texels wide, beside a sheet, lay on themselves: they were drawn at 2,048 pixels at most."""
    vertices, faces = coil(2, 8, DECK / 6, 0.02)
    place = np.stack(np.meshgrid(*[np.arange(20) / 20] * 2, [0.1]), axis=3).reshape(-1, 1, 3)
    small = (2e-4 * vertices + place)[:, faces].reshape(-1, 3)
    sheet = np.array([(0.0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)])[[0, 1, 2, 0, 2, 3]]
    cut = cut_meshes(
        [((2e3 * own).astype(np.float32), np.arange(len(own)).reshape(-1, 3)) for own in (small, sheet)], 16384, 2
    )
    assert len(cut.charts.sizes) == 401
    assert len(separate_overlaps(cut, 16384, 2).charts.sizes) >= 801  # 669 at 2,048


def test_a_surface_with_one_layer_is_not_divided():
    """A hill that is nearly flat stays one chart, with all its slopes."""
    x, y = np.meshgrid(*[np.linspace(0, 1, 60)] * 2, indexing="ij")
    vertices = np.stack([x, y, 0.01 * np.exp(-9 * (x - 0.5) ** 2 - 9 * (y - 0.5) ** 2)], axis=2).reshape(-1, 3)
    _, uv = ws.unwrap(ws.Mesh(vertices, quads(60, 60)), 256)
    assert label_charts(uv).max() == 0


@pytest.mark.parametrize("ratio", [500, 3000])
def test_small_parts_of_large_scenes_keep_all_faces(ratio):
    """xatlas shrank single charts of a spring to a point; up to 135 of 6,400 faces had no area."""
    large, small = (
        coil(3, 100, DECK / 6, 0.1),
        coil(2, 100, np.column_stack([1 + 0.2 * np.cos(TURN), 0.2 * np.sin(TURN)]), 0.6),
    )
    vertices = np.concatenate([large[0], small[0] / ratio + [0.3, 0.7, 0.2]])
    split, uv = ws.unwrap(ws.Mesh(vertices, np.concatenate([large[1], small[1] + len(large[0])])), 512)
    assert (np.ptp(uv, axis=1).max(axis=1) > 0.0).all()
    assert ws.texture_points(split, uv, 512).report.overlapped == 0
