"""Pictures in files are read as VTK reads them if they are whole, and refused wherever they are cut or garbled."""

import tracemalloc

import numpy as np
import pytest

import warpsample as ws
from warpsample.host.picture import read_picture

HEIGHT, WIDTH = 12, 33


def refused(path, why=".+"):
    return pytest.raises(ValueError, match=f"^radiance: got '.*{path.name}', which cannot be read as a picture: {why}$")


def header(rows="-Y", columns="+X"):
    return f"#?RADIANCE\n# made\nFORMAT=32-bit_rle_rgbe\n\n{rows} {HEIGHT} {columns} {WIDTH}\n".encode()


@pytest.fixture
def pixels():
    rng = np.random.default_rng(3)
    made = rng.integers(2, 256, (HEIGHT, WIDTH, 4)).astype(np.uint8)
    made[3:6], made[7, 4:30], made[8, 8] = made[3, 0], made[7, 5], 0
    return made


def runs(numbers):
    """Radiance's run-length code of a channel: a run of equal bytes is 128 + its length and the byte."""
    made, at = bytearray(), 0
    while at < len(numbers):
        same = next((k for k in range(at, len(numbers)) if numbers[k] != numbers[at]), len(numbers)) - at
        made += bytes([128 + same, numbers[at]]) if same > 2 else bytes([1, numbers[at]])
        at += same if same > 2 else 1
    return bytes(made)


def encoded(pixels):
    line = bytes([2, 2, 0, WIDTH])
    return b"".join(line + b"".join(runs(row[:, channel].tolist()) for channel in range(4)) for row in pixels)


@pytest.mark.parametrize("encode", [encoded, np.ndarray.tobytes])
def test_hdr_is_read_as_vtk_reads_it(encode, pixels, tmp_path):
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOImage import vtkHDRReader

    path = tmp_path / "sky.hdr"
    shares = pixels[..., :3] * np.ldexp(1.0, pixels[..., 3:].astype(int) - 136) * (pixels[..., 3:] > 0)
    for rows, columns in (("-Y", "+X"), ("+Y", "+X"), ("-Y", "-X")):
        path.write_bytes(header(rows, columns) + encode(pixels))
        found = read_picture(path)
        assert found.dtype == np.float32
        assert np.array_equal(found, shares[:: 1 if rows == "-Y" else -1, :: 1 if columns == "+X" else -1])
        reader = vtkHDRReader()
        reader.SetFileName(str(path))
        reader.Update()
        by_vtk = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(HEIGHT, WIDTH, 3)[::-1]
        assert np.array_equal(found, by_vtk)


@pytest.mark.parametrize("encode", [encoded, np.ndarray.tobytes])
def test_hdr_that_is_not_whole_is_refused(encode, pixels, tmp_path):
    path = tmp_path / "sky.hdr"
    content = header() + encode(pixels)
    for end in range(len(content)):
        path.write_bytes(content[:end])
        with refused(path):
            read_picture(path)
    for damaged in (
        content + b"\n",
        content.replace(b"#?", b"?#"),
        content.replace(b"+X 33", b"+X 34"),
        content.replace(b"-Y 12", b"-Y 11"),
        content.replace(b"-Y 12", b"-Y -2"),
        content[: content.index(b"-Y")] + b"-Y 0 +X 33\n",
        content[: content.index(b"-Y")] + b"-Y 99999 +X 0\n",  # whose lines take no bytes, and any number of steps
        content.replace(b"_rgbe", b"_xyze"),
    ):
        path.write_bytes(damaged)
        with refused(path):
            read_picture(path)


def test_hdr_is_divided_by_the_factors_that_its_header_states(pixels, tmp_path):
    """Radiance multiplies pixels by EXPOSURE and COLORCORR, any number of times; the original radiances are wanted."""
    path = tmp_path / "sky.hdr"
    path.write_bytes(header() + encoded(pixels))
    plain = read_picture(path)
    lines = b"# made\nEXPOSURE=4.0\nCOLORCORR=1 2 0.5\npfilt -e 0.5\nEXPOSURE= 5.000000e-01\n"
    inputs = b"dim.hdr:\n\tpfilt -e 8\n\tEXPOSURE=8.0\n\tFORMAT=32-bit_rle_xyze\npcomb dim.hdr\n"  # as `pcomb` writes them
    for made in (lines, lines + inputs):
        path.write_bytes(header().replace(b"# made\n", made) + encoded(pixels))
        assert np.array_equal(read_picture(path), plain / np.float32([2.0, 4.0, 1.0]))
    for wrong in (
        b"EXPOSURE=0",
        b"EXPOSURE=nan",
        b"EXPOSURE=",
        b"EXPOSURE=1 2",
        b"EXPOSURE=1e99",
        b"COLORCORR=1 x 1",
        b"EXPOSURE=1_0",
    ):
        path.write_bytes(header().replace(b"# made", wrong) + encoded(pixels))
        with refused(path, f"the header has '{wrong.decode()}', want (1 number|3 numbers) above 0"):
            read_picture(path)


def test_hdr_with_a_size_in_columns_is_read(pixels, tmp_path):
    """Radiance has padded the numbers of the size with spaces since 2023."""
    path = tmp_path / "sky.hdr"
    path.write_bytes(header() + encoded(pixels))
    plain = read_picture(path)
    path.write_bytes(header(f"-Y{'':6}", f"+X{'':6}") + encoded(pixels))
    assert np.array_equal(read_picture(path), plain)


def test_hdr_of_runs_that_do_not_fit_is_refused(pixels, tmp_path):
    path = tmp_path / "sky.hdr"
    line = bytes([2, 2, 0, WIDTH])
    for content, why in [
        (line + bytes([128 + 34, 7]) + bytes(999), "a run of equal pixels is longer than the rest of the line"),
        (bytes([2, 2, 0, 34]) + bytes(999), "a line of the picture declares 34 pixels, want 33, as in the header"),
        (
            bytes([1, 1, 1, 9]) * WIDTH * HEIGHT,
            "the file uses the old run-length encoding, want the new encoding, line by line; save the picture again",
        ),
    ]:
        path.write_bytes(header() + content)
        with refused(path, why):
            read_picture(path)


def test_huge_pictures_allocate_nothing(pixels, tmp_path):
    whole = header() + encoded(pixels)
    contents = {"hdr": whole.replace(b"-Y 12", b"-Y 99999999"), "npy": b""}
    np.save(tmp_path / "sky.npy", np.ones((10, 10, 3), np.float32))
    contents["npy"] = (
        (tmp_path / "sky.npy").read_bytes().replace(b"(10, 10, 3)", b"(9**9, 9**9, 3)".replace(b"9**9", b"999999"))
    )
    for suffix, content in contents.items():
        path = tmp_path / f"huge.{suffix}"
        path.write_bytes(content)
        tracemalloc.start()
        try:
            with refused(path):
                read_picture(path)
            assert tracemalloc.get_traced_memory()[1] < 1e5
        finally:
            tracemalloc.stop()


@pytest.mark.parametrize("suffix", ["hdr", "npy"])
def test_reading_takes_no_more_than_twice_the_file_and_the_picture(suffix, tmp_path):
    path = tmp_path / f"sky.{suffix}"
    np.save(tmp_path / "sky.npy", np.ones((128, 256, 3), np.float32))
    dots = np.random.default_rng(4).integers(2, 256, (128, 256, 4)).astype(np.uint8)
    (tmp_path / "sky.hdr").write_bytes(b"#?RADIANCE\n\n-Y 128 +X 256\n" + dots.tobytes())
    read_picture(path)
    tracemalloc.start()
    try:
        found = read_picture(path)
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert peak <= 2 * (path.stat().st_size + found.nbytes)


class Loud:
    """Loading a pickle of it would leave a trace."""

    loaded = False

    def __reduce__(self):
        return setattr, (Loud, "loaded", True)


def test_npy_is_whole_and_no_pickle(tmp_path):
    path = tmp_path / "sky.npy"
    picture = np.random.default_rng(0).uniform(size=(8, 16, 3))
    np.save(path, picture)
    content = path.read_bytes()
    assert np.array_equal(read_picture(path), picture)
    for share in (30, 70, 97):
        path.write_bytes(content[: len(content) * share // 100])
        with refused(path):
            read_picture(path)
    for damaged in (b"", b"hello" * 99, b"\x93NUMPY" + bytes(200), content.replace(b"(8, 16, 3)", b"(8, -6, 3)")):
        path.write_bytes(damaged)
        with refused(path):
            read_picture(path)
    np.save(path, np.array([Loud()], object), allow_pickle=True)
    with refused(path):
        read_picture(path)
    assert not Loud.loaded


def test_bake_names_an_empty_picture(call, cube, tmp_path):
    for name in ("sky.npy", "sky.hdr"):
        path = tmp_path / name
        path.write_bytes(b"")
        status, out, err = call("bake", cube, "-o", tmp_path / "o.csv", "--quantity", "irradiance", "--environment", path)
        assert (status, out) == (2, "")
        assert err.startswith(f"error: --environment: got '{path}', which cannot be read as a picture: ")
        assert err.count("\n") == 1


def test_a_picture_that_gives_no_light_is_named(tmp_path):
    path = tmp_path / "sky.npy"
    np.save(path, np.full((2, 4), -1.0))
    point = ws.SurfacePoints(np.zeros((1, 3)), np.float32([[0.0, 0.0, 1.0]]))
    with pytest.raises(ValueError, match=f"^radiance: got '{path}' with numbers below 0"):
        ws.irradiance(ws.load_mesh("courtyard"), point, path, 32)
