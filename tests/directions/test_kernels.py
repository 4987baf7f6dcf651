"""Kernels of directions: their loops are vectorised, they compile for CUDA, and each is built once."""

import re
import subprocess
import sys

import numpy as np
import pytest
import warp as wp

import warpsample as ws
from warpsample.bench.running.machine import describe_machine
from warpsample.directions.blocks import direction_blocks
from warpsample.directions.rows import direction_rows
from warpsample.directions.square import square_blocks
from warpsample.distributions.elementwise import elementwise
from warpsample.distributions.parameters import bind_parameters
from warpsample.distributions.record import Distribution, Maps
from warpsample.mesh.placing import place_points

NOT_HERE = ("cosine_hemisphere", "environment_map")  # named above; named below, since its inverse calls libm
# Sequence and map have loops of their own, so each needs one partner only.
VECTORISED = [
    *((name, ws.CosineHemisphere("polar")) for name in ws.sequences.names()),
    ("sobol", ws.CosineHemisphere("offset")),
    ("sobol", ws.CosineHemisphere("concentric")),
    ("sobol", ws.CosineHemisphere("inversion")),
    *(("sobol", ws.distributions.get(name).cases()[-1]) for name in ws.distributions.names() if name not in NOT_HERE),
]

_LANES = {"avx512": 16}  # of float32; 8 with AVX2

_REMARKS = """
import numpy as np, warp as wp
wp.config.log_level = wp.LOG_WARNING
wp.config.cpu_compiler_flags += " -Rpass=loop-vectorize -Rpass-missed=loop-vectorize"
import warpsample as ws
normals = np.ones((2, 3), np.float32)
def announce(*what):
    import sys
    print("@@", *what, file=sys.stderr, flush=True)
for name, case in CASES:
    every = (1, 3, 64) if name == "sobol" else (3, 64)  # one sample a point is the loop of 3, without their quotients
    shapes = every if getattr(case, "method", "") in ("polar", "offset") else (64,)
    for count in shapes if case.width == 3 else ():
        announce(name, case, count)
        ws.sample_directions(normals, count, distribution=case, sequence=name)
for count in (1, 3, 64) if FIRST else ():
    announce("pdf and active", count)
    ws.sample_directions(normals, count, pdf=True, active=[True, False])
points = ws.SurfacePoints(np.zeros((2, 3)), normals)
by_point = (ws.GGX(np.full(2, 0.3)), ws.VisibleGGX(np.full(2, 0.3), view=normals))
by_point += tuple(ws.Reflection(lobe, view=normals) for lobe in by_point)
for lobe in by_point if FIRST else ():
    for count in (1, 3, 64):
        announce("by point", lobe, count)
        ws.sample_directions(points, count, distribution=lobe)
    announce("sample by point", lobe)
    w = lobe.sample(np.full((2, 3, 2), 0.5, np.float32))
    announce("pdf by point", lobe)
    lobe.pdf(w)
for count in (1, 3, 64) if FIRST else ():
    announce("tangents", count)
    ws.sample_directions(points.with_tangents(np.eye(3)[:2]), count)
for name in ws.sequences.names() if FIRST else ():
    announce("square", name)
    ws.sample_square(name, 1, 1)
seen = set()
for _, case in CASES:
    up = [[0.0] * (case.width - 1) + [1.0]]
    for kind, x in (("sample", [[0.5, 0.5]]), ("pdf", up), ("invert", up)):
        # Methods share maps, and a kernel is compiled once; some have no way back.
        if getattr(case.maps, kind) not in {*seen, None}:
            seen.add(getattr(case.maps, kind))
            announce(kind, case)
            getattr(case, kind)(x)
announce("end")
"""


def text_of(case):
    """Return the text that makes a case and its nested lobes, with the name of the package."""
    return re.sub(r"(?<![\w.])([A-Z]\w*\()", r"ws.\1", repr(case))


@pytest.mark.thorough
def test_every_loop_of_directions_is_vectorised(tmp_path, child_environment):
    """The compiler's own remarks say so, with a cold cache, in two processes."""
    halves = [VECTORISED[::2], VECTORISED[1::2]]
    children = []
    for i, half in enumerate(halves):
        cases = "[" + ", ".join(f"({name!r}, {text_of(case)})" for name, case in half) + "]"
        script = tmp_path / f"remarks_{i}.py"
        script.write_text(_REMARKS.replace("CASES", cases).replace("FIRST", str(i == 0)))
        environment = {**child_environment, "WARP_CACHE_PATH": str(tmp_path / f"cache_{i}")}
        children.append(subprocess.Popen([sys.executable, script], env=environment, stderr=subprocess.PIPE, text=True))
    outputs = [child.communicate()[1] for child in children]
    for child, remarks in zip(children, outputs, strict=True):
        assert child.returncode == 0, remarks
        compiled = re.split(r"^@@ ", remarks, flags=re.MULTILINE)[1:-1]
        assert len(compiled) > 25
        lanes, widths = _LANES.get(describe_machine().instructions, 8), set()
        for one in compiled:
            # Hot loops are the `while`s of their kernel; those over rows, and those that mend, are `for` loops.
            hot = re.findall(r"vectorized loop \(vectorization width: (\d+).*\n.*goto end_while_", one)
            assert hot, one
            widths.update(map(int, hot))
            assert min(map(int, hot)) >= lanes // 2, one  # those with float64 have half the lanes
            assert not re.search(r"loop not vectorized.*\n.*goto end_while_", one), one
        assert max(widths) >= lanes


_PICTURE_REMARKS = """
import sys
import numpy as np, warp as wp
wp.config.log_level = wp.LOG_WARNING
wp.config.cpu_compiler_flags += " -Rpass=loop-vectorize -Rpass-missed=loop-vectorize"
import warpsample as ws
from warpsample.distributions.lights.picture_reading import PictureReading
picture = np.ones((64, 128))
for contrast in (1.0, 1e12):
    picture[1, 2] = contrast
    for lobe in (ws.EnvironmentMap(picture), PictureReading(picture)):
        print("@@", lobe, file=sys.stderr, flush=True)
        ws.sample_directions(np.ones((2, 3), np.float32), 64, distribution=lobe, sequence="independent")
"""


@pytest.mark.thorough
def test_the_loop_over_directions_towards_a_picture_is_vectorised(tmp_path, child_environment):
    """The search in the picture's table, too, for few steps and for many."""
    script = tmp_path / "remarks.py"
    script.write_text(_PICTURE_REMARKS)
    environment = {**child_environment, "WARP_CACHE_PATH": str(tmp_path / "cache")}
    remarks = subprocess.run([sys.executable, script], env=environment, capture_output=True, text=True, check=True).stderr
    compiled = re.split(r"^@@ ", remarks, flags=re.MULTILINE)[1:]
    assert len(compiled) == 4
    for one in compiled:
        widths = [int(n) for n in re.findall(r"vectorized loop \(vectorization width: (\d+).*\n.*goto end_while_", one)]
        assert len(widths) >= 3, one  # the sequence, the map, and copies of the last directions
        assert min(widths) >= _LANES.get(describe_machine().instructions, 8) // 2, one  # float64 has half the lanes
        assert not re.search(r"loop not vectorized.*\n.*goto end_while_", one), one


def directions_by(factory, sequence, case, **how):
    maps = {"redraw": case.maps.redraw, "redraw_below": case.maps.redraw_below}
    return factory(ws.sequences.get(sequence), case.about(), **maps, **how)


def all_kernels(with_maps):
    """Yield a kernel of each kind and of each sequence, and kernels of each map, which the kernels of directions call."""
    yield place_points(1)
    for name in ws.sequences.names():
        yield square_blocks(ws.sequences.get(name))
        yield directions_by(direction_rows, name, ws.CosineHemisphere(), with_pdf=True, masked=True, chunk=1)
    for case in dict.fromkeys(case for _, case in VECTORISED):
        w = case.width
        maps = [(case.maps.sample, 2, w), (case.maps.pdf, w, 1), (case.maps.invert, w, 2)]
        if case.name in ("cosine_hemisphere", "mixture"):  # with and without a frame, and with parameters
            yield directions_by(direction_blocks, "sobol", case, with_pdf=True, masked=False, one_sample=False)
        for func, width, out in maps:
            if with_maps and func is not None:
                bound = bind_parameters(func, wp.vec2 if width == 2 else wp.vec3, len(case.parameters))
                yield elementwise(bound, width, out)


@pytest.mark.slow
@pytest.mark.parametrize("with_maps", [False, pytest.param(True, marks=pytest.mark.thorough)])
def test_every_kernel_compiles_for_cuda(with_maps, tmp_path):
    """The compiler inside warp-lang makes PTX of copies in one module, without a driver."""
    kernels, module = list(dict.fromkeys(all_kernels(with_maps))), wp.get_module(f"directions_for_cuda_{with_maps}")
    assert len(kernels) > (50 if with_maps else 12)
    module.options |= {"enable_backward": False, "optimization_level": 1}  # errors of compilation do not depend on it
    for i, kernel in enumerate(kernels):
        wp.Kernel(kernel.func, key=f"kernel_{i}", module=module)
    (ptx,) = wp.compile_aot_module(module, device=None, arch=86, use_ptx=True, module_dir=tmp_path)
    assert ptx.read_text().count(".visible .entry") == len(kernels)


@wp.func
def _tilted(u: wp.vec2, tilt: wp.float32) -> wp.vec3:
    return wp.vec3(tilt, 0.0, wp.sqrt(1.0 - tilt * tilt))


@wp.func
def _tilted_pdf(w: wp.vec3, tilt: wp.float32) -> wp.float32:
    return tilt * w[2]


@wp.func
def _tilted_invert(w: wp.vec3, tilt: wp.float32) -> wp.vec2:
    return wp.vec2(tilt, 0.0)


class Tilted(Distribution):
    """A made-up distribution with a parameter."""

    name = "tilted"
    parameters = ("tilt",)

    def __init__(self, tilt):
        object.__setattr__(self, "tilt", tilt)

    @property
    def maps(self):
        return Maps(_tilted, _tilted_pdf, _tilted_invert)


def test_a_parameter_reaches_the_kernels_and_a_new_value_compiles_nothing(normals):
    u = np.zeros((5, 2), np.float32)
    up = np.array([[0.0, 0.0, 1.0]], np.float32)
    built = len(direction_rows.cache)
    for tilt in (0.25, 0.5):
        distribution = Tilted(tilt)
        assert (distribution.sample(u)[:, 0] == tilt).all()
        assert distribution.pdf(up).tolist() == [tilt]
        assert (distribution.invert(up)[:, 0] == tilt).all()
        assert np.abs(ws.sample_directions(up, 64, distribution=distribution).vectors[0, :, 0] - tilt).max() <= 1e-7
    assert len(direction_rows.cache) == built + 1


def test_kernels_are_built_once_for_equal_jobs(normals):
    ws.sample_directions(normals, 32)
    built = len(direction_rows.cache)
    ws.sample_directions(normals, 64, seed=9)
    ws.sample_directions(normals, 32, distribution=ws.CosineHemisphere("polar"))
    assert len(direction_rows.cache) == built
