""".usd: what a renderer shows of it, placed and turned; and one sentence on what is not whole."""

import os
import signal
import struct
import sys
from pathlib import Path
from zipfile import ZipFile

import mesh_file_cases as cases
import psutil
import pytest

import warpsample as ws
from warpsample.mesh.files import usd


def triangle(stage, path, z=0.0):
    from pxr import UsdGeom

    mesh = UsdGeom.Mesh.Define(stage, path)
    mesh.GetPointsAttr().Set([(0, 0, z), (1, 0, z), (0, 1, z)])
    mesh.GetFaceVertexCountsAttr().Set([3])
    mesh.GetFaceVertexIndicesAttr().Set([0, 1, 2])
    return mesh


@pytest.fixture
def stage(tmp_path):
    from pxr import Usd

    return Usd.Stage.CreateNew(str(tmp_path / "scene.usda"))


def loaded(stage):
    stage.GetRootLayer().Save()
    return ws.load_mesh(stage.GetRootLayer().realPath)


def test_usd_polygons_placement_and_mirroring(stage):
    from pxr import Gf

    triangle(stage, "/moved").AddTranslateOp().Set(Gf.Vec3d(0, 0, 5e6 + 1e-3))
    triangle(stage, "/mirrored").AddScaleOp().Set(Gf.Vec3f(-1, 1, 1))
    left = triangle(stage, "/left")
    left.GetFaceVertexIndicesAttr().Set([0, 2, 1])
    left.CreateOrientationAttr("leftHanded")
    mesh = loaded(stage)
    assert mesh.report.area == 1.5
    assert mesh.report.upper[2] == 5e6 + 1e-3
    assert (mesh.face_normals == (0, 0, 1)).all()  # the mirrored one and the left-handed one are turned back


def test_usd_instances_are_placed_and_empty_prims_left_out(stage):
    from pxr import Gf, UsdGeom

    stage.CreateClassPrim("/prototype")
    triangle(stage, "/prototype/mesh", 1.0)
    for x in (0, 10, 20):
        instance = UsdGeom.Xform.Define(stage, f"/at{x}")
        instance.AddTranslateOp().Set(Gf.Vec3d(x, 0, 0))
        instance.GetPrim().GetReferences().AddInternalReference("/prototype")
        instance.GetPrim().SetInstanceable(True)
    UsdGeom.Mesh.Define(stage, "/empty")
    UsdGeom.Points.Define(stage, "/points").GetPointsAttr().Set([(99, 99, 99)])
    mesh = loaded(stage)
    assert mesh.vertices[mesh.faces[:, 0]].tolist() == [[0, 0, 1], [10, 0, 1], [20, 0, 1]]


def test_usd_point_instancers_are_placed(stage):
    from pxr import Gf, UsdGeom

    many = UsdGeom.PointInstancer.Define(stage, "/many")
    many.AddTranslateOp().Set(Gf.Vec3d(0, 0, 100))
    stage.OverridePrim("/many/prototypes")
    UsdGeom.Xform.Define(stage, "/many/prototypes/one").AddTranslateOp().Set(Gf.Vec3d(0, 5, 0))
    triangle(stage, "/many/prototypes/one/mesh").AddTranslateOp().Set(Gf.Vec3d(0, 0, 1))
    triangle(stage, "/many/prototypes/two")
    many.GetPrototypesRel().SetTargets(["/many/prototypes/one", "/many/prototypes/two"])
    many.GetProtoIndicesAttr().Set([0, 0, 1, 0])
    many.GetPositionsAttr().Set([(0, 0, 0), (10, 0, 0), (20, 0, 0), (30, 0, 0)])
    many.GetScalesAttr().Set([(1, 1, 1), (-2, 2, 2), (1, 1, 1), (1, 1, 1)])
    many.GetInvisibleIdsAttr().Set([3])
    mesh = loaded(stage)
    assert mesh.vertices[mesh.faces.min(axis=1)].tolist() == [[0, 5, 101], [10, 10, 102], [20, 0, 100]]
    assert mesh.face_areas.tolist() == [0.5, 2.0, 0.5]
    assert (mesh.face_normals == (0, 0, 1)).all()


def test_usd_shows_what_a_renderer_shows(stage):
    triangle(stage, "/hidden").MakeInvisible()
    triangle(stage, "/hidden/below")
    triangle(stage, "/guide").CreatePurposeAttr("guide")
    triangle(stage, "/proxy").CreatePurposeAttr("proxy")
    triangle(stage, "/render", 1.0).CreatePurposeAttr("render")
    moving = triangle(stage, "/moving")
    moving.GetPointsAttr().Clear()
    for time in (2.0, 3.0):
        moving.GetPointsAttr().Set([(0, 0, time), (1, 0, time), (0, 1, time)], time)
    mesh = loaded(stage)
    assert mesh.vertices[mesh.faces[:, 0], 2].tolist() == [1.0, 2.0]


def test_holes_of_usd_meshes_are_left_out(stage):
    """A square, a triangle and a square: neither the triangle nor its normals and coordinates are read."""
    mesh = triangle(stage, "/windows")
    mesh.GetPointsAttr().Set([(x, y, 0) for x in range(4) for y in (0, 1)])
    mesh.GetFaceVertexCountsAttr().Set([4, 3, 4])
    mesh.GetFaceVertexIndicesAttr().Set([0, 2, 3, 1, 2, 4, 5, 4, 6, 7, 5])
    mesh.CreateHoleIndicesAttr([1, 9])
    found = loaded(stage)
    assert found.face_areas.tolist() == [0.5, 0.5, 0.5, 0.5]
    assert sorted(set(found.vertices[found.faces][..., 0].ravel())) == [0.0, 1.0, 2.0, 3.0]
    assert (found.vertices[found.faces][:2, :, 0].max(), found.vertices[found.faces][2:, :, 0].min()) == (1.0, 2.0)
    assert usd.read_normals(Path(stage.GetRootLayer().realPath)).shape == (4, 3, 3)


def test_usd_that_is_not_whole_is_refused_in_one_sentence(stage, tmp_path, capfd):
    from pxr import UsdGeom

    path = tmp_path / "refers.usda"
    path.write_text('#usda 1.0\ndef Xform "x" (prepend references = @./missing.usda@</m>) { }\n')
    with cases.refused(path, "Could not open asset .*missing.usda@ .*"):
        ws.load_mesh(path)
    path = tmp_path / "bad_byte.usda"
    path.write_bytes(b'#usda 1.0\ndef Mesh "m\xbe\xff" { }\n')
    with cases.refused(path, "the file is damaged"):
        ws.load_mesh(path)
    path = cases.write("usdz", tmp_path, cases.SPHERE.vertices, cases.SPHERE.faces)
    content = bytearray(path.read_bytes())
    content[len(content) // 2] ^= 1
    path.write_bytes(content)
    with cases.refused(path, "the file inner.usdc in the archive is damaged"):
        ws.load_mesh(path)
    triangle(stage, "/mesh")
    UsdGeom.Sphere.Define(stage, "/ball")
    with cases.refused(tmp_path / "scene.usda", "the prim /ball is a Sphere, want only meshes; convert the shape to a mesh"):
        loaded(stage)
    assert capfd.readouterr() == ("", "")


def test_archives_without_a_layer_are_refused_in_one_sentence(tmp_path, capfd):
    """Before, the reason was an error of Python, such as "'NoneType' object has no attribute 'ComputeAbsolutePath'"."""
    for number, names in enumerate(((), ("a.txt",))):
        path = tmp_path / f"{number}.usdz"
        with ZipFile(path, "w") as archive:
            for name in names:
                archive.writestr(name, "no layer")
        with cases.refused(path, f"{path.name} holds no USD layer; the first file of a .usdz must be .*"):
            ws.load_mesh(path)
    path.write_bytes(b"no archive")
    with cases.refused(path, "the file is not a zip archive, or is cut off"):
        ws.load_mesh(path)
    assert capfd.readouterr() == ("", "")


def test_usd_that_refers_to_a_pipe_is_refused(tmp_path):
    """Opened, it would wait for ever; also by a file that the file refers to."""
    os.mkfifo(tmp_path / "pipe.usda")
    for name, other in (("below", "pipe"), ("scene", "below")):
        text = f'#usda 1.0\ndef Xform "m" (prepend references = @./{other}.usda@</m>) {{ }}\n'
        (tmp_path / f"{name}.usda").write_text(text)
    with cases.refused(tmp_path / "scene.usda", "the file refers to '.*/pipe.usda', which is no ordinary file"):
        ws.load_mesh(tmp_path / "scene.usda")


def test_huge_tables_of_binary_usd_allocate_nothing(tmp_path):
    path = cases.write("usdc", tmp_path, cases.SPHERE.vertices, cases.SPHERE.faces)
    content = bytearray(path.read_bytes())
    table = int.from_bytes(content[16:24], "little")
    content[table : table + 8] = (10**8).to_bytes(8, "little")  # usd-core would take 3 GB for them
    path.write_bytes(content)
    with cases.refused(path, "the header declares 100,000,000 sections .*"):
        ws.load_mesh(path)


@pytest.mark.thorough  # a process for each of eight sections
def test_huge_counts_of_binary_usd_allocate_nothing(tmp_path):
    """Of the tokens, their bytes, the strings, fields, sets of fields, paths, encoded paths and specs."""
    path = cases.write("usdc", tmp_path, cases.SPHERE.vertices, cases.SPHERE.faces)
    whole = path.read_bytes()
    table = int.from_bytes(whole[16:24], "little")
    refused = []
    for name, start, _ in struct.iter_unpack("<16sqq", whole[table + 8 :]):
        for at in (start, start + 8) if name.strip(b"\0") in (b"TOKENS", b"PATHS") else (start,):
            content = bytearray(whole)
            content[at + 3] = 0xF7  # one byte: four thousand million entries
            path.write_bytes(content)
            plain = name.strip(b"\0").decode()
            with cases.refused(path, rf"the section '{plain}' declares 4,1[0-9,]* entries, too many for [\d,]+ bytes"):
                ws.load_mesh(path)
            refused.append(plain)
    assert refused == ["TOKENS", "TOKENS", "STRINGS", "FIELDS", "FIELDSETS", "PATHS", "PATHS", "SPECS"]


def test_what_ends_usd_core_is_refused(tmp_path, capfd):
    """One byte is changed: the number of the name of the root's only child, and the count of an array's numbers."""
    path = cases.write("usdc", tmp_path, cases.SPHERE.vertices, cases.SPHERE.faces)
    whole = path.read_bytes()
    child = whole.index(struct.pack("<q", 1), 88) + 8
    count = whole.index(struct.pack("<q", cases.SPHERE.faces.size), 88)
    for at, found in ((child + 2, 0), (count + 3, 0), (count + 6, 0)):
        content = bytearray(whole)
        assert content[at] == found
        content[at] = 0xFF
        path.write_bytes(content)
        with cases.refused(path, "usd-core ended with .*|.*exception thrown unpacking.*"):
            ws.load_mesh(path)
    assert capfd.readouterr() == ("", "")


def test_reading_usd_ends_with_what_a_handler_raises(bunny_path, monkeypatch):
    def late(*_):
        raise TimeoutError("mine")

    monkeypatch.setattr(usd, "_PROGRAM", "import time; time.sleep(1000)")
    others = psutil.Process().children()
    before = signal.signal(signal.SIGALRM, late)
    signal.setitimer(signal.ITIMER_REAL, 0.3)
    try:
        with pytest.raises(TimeoutError, match="^mine$"):
            ws.load_mesh(bunny_path)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, before)
    assert set(psutil.Process().children()) == set(others)


def test_a_reason_that_quotes_an_array_is_short(tmp_path):
    path = tmp_path / "long.usda"
    path.write_text('#usda 1.0\ndef Mesh "m"\n{\n    int[] faceVertexCounts = [' + "3, " * 999 + "_]\n}\n")
    with pytest.raises(ValueError, match="cannot be read as a mesh: ") as raised:
        ws.load_mesh(path)
    assert len(str(raised.value)) < 400


def test_usd_without_usd_core_says_what_to_install(bunny_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "pxr", None)
    with pytest.raises(ModuleNotFoundError, match=r"^path: got 'bunny\.usd', which needs usd-core: pip install '"):
        ws.load_mesh(bunny_path)
