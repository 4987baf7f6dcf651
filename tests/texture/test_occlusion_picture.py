"""What the viewer shows of a file: the occlusion of all its materials on one picture."""

import io
from base64 import b64encode
from types import SimpleNamespace

import matplotlib.image
import numpy as np
import pytest
from lookups import lookup, on_surface
from PIL import Image
from textured_scenes import changed, opened, picture, rich

import warpsample as ws
from warpsample.texture import occlusion_picture
from warpsample.texture.occlusion_picture import read_occlusion
from warpsample.viewer.baked import occlusion_scene


@pytest.fixture
def baked(call, tmp_path):
    (tmp_path / "in.glb").write_bytes(rich())
    output = tmp_path / "out.glb"
    assert call("bake", tmp_path / "in.glb", "-o", output, "--texture", 64, "--samples", 64, "--strength", 0.5)[0] == 0
    return output


def test_each_face_shows_its_own_picture(baked):
    """At random places on floor and wall it is what the material says, by its own set and strength."""
    shown = read_occlusion(baked)
    mesh, (tree, data, _) = ws.load_mesh(baked), opened(baked)
    points, at = on_surface(mesh, shown.uv, 2000)
    read = lookup(shown.picture[..., None] / 255, at)[:, 0]
    for faces, number, texture in ((points.face < 2, 1, 1), (points.face >= 2, 0, 2)):
        own = np.einsum("pk,pkc->pc", points.barycentric, ws.load_uv(baked, set=number)[points.face])
        right = 0.5 + 0.5 * lookup(picture(tree, data, texture), own[faces])[:, 0]
        assert faces.sum() > 100
        assert np.abs(read[faces] - right).max() < 0.003  # half a step of eight bits, and the edge of a tile
        assert np.ptp(right) > 0.02


def test_what_cannot_be_shown_is_white(baked, tmp_path):
    """A wall without a material, and a floor whose picture the file transforms: nothing to show is None."""

    def change(tree):
        del tree["meshes"][1]["primitives"][0]["material"]

    path = tmp_path / "changed.glb"
    path.write_bytes(changed(baked.read_bytes(), change))
    shown = read_occlusion(path)
    points, at = on_surface(ws.load_mesh(path), shown.uv, 500)
    read = lookup(shown.picture[..., None] / 255, at)[:, 0]
    assert (read[points.face >= 2] == 1.0).all()
    assert (read[points.face < 2] < 1.0).all()

    def transform(tree):
        change(tree)
        tree["materials"][0]["occlusionTexture"]["extensions"] = {"KHR_texture_transform": {}}

    path.write_bytes(changed(baked.read_bytes(), transform))
    with pytest.warns(UserWarning, match="KHR_texture_transform"):
        assert read_occlusion(path) is None
    assert read_occlusion(path.with_suffix(".ply")) is None
    path.write_bytes(changed(baked.read_bytes(), lambda tree: tree["materials"][1]["occlusionTexture"].update(strength=[2])))
    with pytest.raises(ValueError, match=r"changed.glb.*materials\[1\].occlusionTexture.strength: got \[2\]"):
        read_occlusion(path)


@pytest.mark.parametrize(("far", "is_shown"), [(1.0, True), (1.0000002, True), (1.001, False), (np.nan, False)])
def test_faces_that_a_bake_takes_are_shown(far, is_shown):
    """Coordinates of 1 that float32 has rounded count as inside the image, as in a bake."""
    uv = np.array([[[0.0, -2e-7], [far, 0.0], [0.0, 1.0]]])
    shown = occlusion_picture._join_pictures([np.zeros((8, 8), np.uint8)], [1.0], np.zeros(1, np.int64), [uv])
    assert (lookup(shown.picture[..., None] / 255, shown.uv[:, 0])[:, 0] == (0.0 if is_shown else 1.0)).all()


def test_the_viewer_is_given_it(can_render, baked):
    """The picture as it is, upside down for VTK, and faces in the mesh's order for the mouse."""
    import pyvista as pv

    from warpsample.plotting.scenes import draw_mesh

    shown, mesh = read_occlusion(baked), ws.load_mesh(baked)
    plotter = pv.Plotter(off_screen=True)
    actor = draw_mesh(plotter, mesh.vertices, mesh.faces, (shown.picture, shown.uv))
    drawn = actor.mapper.dataset
    corners = drawn.points[drawn.regular_faces]
    assert np.allclose(corners, mesh.vertices[mesh.faces], atol=1e-5)
    assert np.allclose(drawn.active_texture_coordinates[drawn.regular_faces] * (1, -1) + (0, 1), shown.uv, atol=1e-6)
    assert np.array_equal(actor.texture.to_array()[..., 0], shown.picture)
    plotter.close()


def test_a_vertex_that_no_face_uses_is_out_of_the_picture(can_render, baked):
    """One left over at 100 m of a mesh of 1 m left nothing to see."""
    mesh, shown = ws.load_mesh(baked), read_occlusion(baked)
    larger = ws.Mesh(np.concatenate([mesh.vertices, [(1e4, 0, 0)]]), mesh.faces)
    views = []
    for one in (mesh, larger):
        plotter = occlusion_scene(one, shown, up="y", size=(1200, 675), off_screen=True)
        views.append((plotter.camera.parallel_scale, plotter.camera.focal_point))
        plotter.close()
    assert views[0] == views[1]


def test_the_view_of_a_baked_file_is_about_its_occlusion(can_render, call, baked, tmp_path):
    """The line on stdout has the values of the pictures; with a distribution the clouds are shown as before."""
    file, mesh, shown = tmp_path / "view.png", ws.load_mesh(baked), read_occlusion(baked)
    status, out, err = call("view", baked, "--size", 1200, 675, "--screenshot", file)
    assert (status, err) == (0, "")
    assert out.startswith(f"{file}: baked occlusion on {len(mesh.faces)} of {len(mesh.faces)} faces; mean 0.")
    assert "χ²" not in out
    _, at = on_surface(mesh, shown.uv, 20_000)
    mean = (lookup(shown.picture[..., None] / 255, at)[:, 0]).mean()
    # Two means over 20,000 random points of values from 0.5 to 1, rounded to 0.01.
    assert float(out.split("mean ")[1].split()[0]) == pytest.approx(mean, abs=0.015)
    pixels = matplotlib.image.imread(file)[..., :3]
    assert pixels.shape == (675, 1200, 3)
    left, right = np.split(pixels, 2, axis=1)
    assert (np.abs(left - right).max(axis=-1) > 0.05).mean() > 0.02
    status, out, _ = call("view", baked, "--points", 3, "--size", 1200, 675, "--screenshot", file)
    assert out.startswith(f"{file}: 3 points x 1,024 directions")


def test_a_png_may_be_larger_than_pillow_opens(baked, monkeypatch):
    """Pillow takes large pictures for attacks, and `bake` writes larger ones; the memory is the limit instead."""
    shown = read_occlusion(baked)
    monkeypatch.setattr("PIL.Image.MAX_IMAGE_PIXELS", 1000)  # of 64 x 64
    assert np.array_equal(read_occlusion(baked).picture, shown.picture)
    monkeypatch.setattr("warpsample.host.engine._ALWAYS_FREE", 0)
    monkeypatch.setattr("psutil.virtual_memory", lambda: SimpleNamespace(available=30_000))
    with pytest.raises(MemoryError, match="^the texels of a picture of 64 x 64 need"):
        read_occlusion(baked)


@pytest.mark.parametrize("extension", ["EXT_texture_webp", "KHR_texture_basisu", None])
def test_a_webp_is_shown_and_other_formats_are_named(baked, tmp_path, extension):
    """Both were passed over without a word; a WebP goes before the .png for viewers without this extension."""
    values = np.full((8, 8, 3), (128, 200, 10), np.uint8)
    content = io.BytesIO()
    Image.fromarray(values).save(content, "WEBP", lossless=True)

    def name(tree):
        data = f"data:image/webp;base64,{b64encode(content.getvalue()).decode()}"
        tree["images"].append({"uri": data})
        texture = tree["textures"][tree["materials"][1]["occlusionTexture"]["index"]]
        if extension is None:
            tree["materials"][0]["occlusionTexture"]["extensions"] = {"KHR_texture_transform": {"scale": [2, 2]}}
        else:
            texture["extensions"] = {extension: {"source": len(tree["images"]) - 1}}
        if extension == "KHR_texture_basisu":
            del texture["source"]

    path = tmp_path / "changed.glb"
    path.write_bytes(changed(baked.read_bytes(), name))
    wants = {"KHR_texture_basisu": r"textures\[2\] \(KHR_texture_basisu\)"}
    wants[None] = r"materials\[0\].occlusionTexture \(KHR_texture_transform\)"
    if extension == "EXT_texture_webp":
        shown = read_occlusion(path)
    else:
        with pytest.warns(UserWarning, match=f"^mesh: got occlusion that is not shown, in {wants[extension]}$"):
            shown = read_occlusion(path)
    wall = np.arange(4) >= 2
    points, at = on_surface(ws.load_mesh(path), shown.uv, 500)
    read = lookup(shown.picture[..., None] / 255, at)[:, 0]
    if extension == "EXT_texture_webp":
        assert np.abs(read[wall[points.face]] - (1 + 0.5 * (128 / 255 - 1))).max() < 0.003
    white = {"KHR_texture_basisu": wall, None: ~wall}.get(extension, np.zeros(4, bool))
    assert (read[white[points.face]] == 1.0).all()
    assert (read[~white[points.face]] < 1.0).any()
