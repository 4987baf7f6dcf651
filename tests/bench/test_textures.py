"""`bench textures`: what is right, what a viewer reads, and equal errors."""

import numpy as np
import pytest
from bench_output import draw_pictures, lines_of
from lookups import lookup

import warpsample as ws
from warpsample.bench.textures import baking
from warpsample.bench.textures.baking import (
    OURS,
    RECORD,
    build_texture,
    compare_times,
    compute_known,
    interpolate_seconds,
    load_scene,
)
from warpsample.bench.textures.lookups import read_bilinear
from warpsample.bench.textures.painters import Textured

SIZE = 64


@pytest.fixture(scope="module")
def scene():
    """A ball of some faces, and new coordinates of it."""
    pytest.importorskip("xatlas")
    ball = ws.as_mesh(pytest.importorskip("trimesh").creation.icosphere(1))
    split, uv = ws.unwrap(ball, SIZE)
    normals = split.vertices / np.linalg.norm(split.vertices, axis=1, keepdims=True)
    return Textured(split, uv, normals.astype(np.float32))


def test_what_a_viewer_reads_is_bilinear_and_clamped():
    rng = np.random.default_rng(0)
    image, uv = rng.random((7, 7)), rng.uniform(-0.1, 1.1, (100, 2))
    assert np.allclose(read_bilinear(image, uv), lookup(image[..., None], uv)[:, 0], rtol=0, atol=1e-12)


def test_ours_is_as_far_from_what_is_right_as_its_rays_are(scene):
    """By smooth normals the faces of a ball are in their own way: what is right is 0.992 in the mean, by 80 faces."""
    known = compute_known(scene, SIZE, 1024, 4096)
    assert known.at_texels.mean() == pytest.approx(0.99206, abs=0.002)  # texels are not uniform by area
    assert len(known.texels) > 50
    job = build_texture(f"{OURS}, 64 rays", scene, known, size=SIZE, workers=1)
    job.work()
    job.work()
    found = job.report()
    assert (found["rays"], found["agrees"]) == (64, True)
    assert found["rmse"] < 0.02
    assert found["lookup"] < 0.02
    assert found["lookup"] ** 2 == pytest.approx(sum(found[part] ** 2 for part in ("noise", "overlap", "resolution")))


def test_equal_errors_are_between_ours():
    """Ours takes four times as long for half the error; beyond its ends the nearer one counts, or there is none."""
    ours = [(0.04, 1.0), (0.02, 4.0), (0.01, 16.0)]
    assert compare_times(0.02, 8.0, ours) == pytest.approx(2.0)
    assert compare_times(0.02 * 2**0.5, 8.0, ours) == pytest.approx(4.0)
    assert compare_times(0.1, 8.0, ours) == pytest.approx(8.0)
    assert compare_times(0.01, 16.0, ours) == pytest.approx(1.0)
    assert compare_times(0.009, 8.0, ours) is None
    assert interpolate_seconds(0.02 * 2**0.5, ours) == pytest.approx(2.0)
    assert interpolate_seconds(0.02, []) is None


def test_the_part_of_a_file_that_gets_it_is_named(tmp_path):
    pytest.importorskip("trimesh")
    path = tmp_path / "two.obj"
    corners = "".join(f"v {x} {y} {z}\n" for z in (0, 1) for x, y in ((0, 0), (1, 0), (0, 1)))
    path.write_text(f"{corners}vt 0 0\nvt 1 0\nvt 0 1\no lower\nf 1/1 2/2 3/3\no upper\nf 4/1 5/2 6/3\n")
    scene = load_scene(path, "upper", SIZE)
    assert np.isnan(scene.uv).all(axis=(1, 2)).tolist() == [True, False]
    assert compute_known(scene, SIZE, 64, 64).at_texels.tolist() == [1.0] * 64
    with pytest.raises(ValueError, match="^part: got 'middle', want one of lower, upper"):
        load_scene(path, "middle", SIZE)
    with pytest.raises(ValueError, match="^asset: got texture coordinates in which all faces overlap"):
        compute_known(load_scene(path, None, SIZE), SIZE)
    with pytest.raises(ValueError, match="^part: got 'upper' without asset"):
        baking.measure(None, part="upper")


@pytest.mark.thorough
def test_all_is_measured_and_shown(tmp_path, capsys):
    rows = baking.compare(None, 128, [f"{OURS}, 16 rays", f"{OURS}, 64 rays", "Blender, 4 rays", "nobody, 4 rays"], 1)
    by_tool = {row.tool: row for row in rows}
    assert "KeyError" in by_tool["nobody, 4 rays"].failure
    ours = [by_tool[f"{OURS}, {rays} rays"] for rays in (16, 64)]
    assert ours[1].rmse < ours[0].rmse
    assert [row.times_ours for row in ours] == pytest.approx([1.0, 1.0])
    assert not RECORD.has_disagreement({"rows": rows})
    text = "\n".join(lines_of("textures", {"side": 128, "repeats": 1}, {"rows": rows}, capsys))
    assert "bunny, side 128, threads" in text
    assert draw_pictures("textures", {"rows": rows}, tmp_path) == ["textures.png"]
