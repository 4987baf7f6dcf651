"""Kernels are split, threaded and vectorised, and can be built for CUDA."""

import mmap
import re
import subprocess
import sys
import threading

import numpy as np
import pytest
import warp as wp

import warpsample as ws
from warpsample.directions.blocks import direction_blocks
from warpsample.directions.job import DirectionJob
from warpsample.directions.rows import direction_rows
from warpsample.directions.square import square_blocks
from warpsample.directions.variates import CHUNK
from warpsample.distributions.elementwise import FLAT_BLOCK, elementwise
from warpsample.distributions.parameters import with_parameters
from warpsample.distributions.record import Distribution, Maps
from warpsample.host import engine
from warpsample.mesh.placing import place_points

CPU = wp.get_device("cpu")


@wp.kernel(enable_backward=False, grid_stride=False)
def _count(out: wp.array[wp.int32], first_task: wp.int64):
    out[wp.int32(first_task) + wp.tid()] += 1


@pytest.mark.parametrize("workers", [1, 2, 5])
@pytest.mark.parametrize("tasks", [1, 7, 4096, 4097])
def test_every_task_runs_once(workers, tasks, monkeypatch):
    monkeypatch.setattr(engine, "_MOST_TASKS", 1000)
    out = np.zeros(tasks, np.int32)
    engine.run(_count, tasks, [wp.array(out, device=CPU, copy=False)], CPU, workers, 10**9)
    assert (out == 1).all()


def test_an_interrupt_stops_the_threads_before_the_call_returns(monkeypatch):
    run_chunks = engine._run_chunks

    def interrupted_here(*arguments):
        if threading.current_thread() is threading.main_thread():
            raise KeyboardInterrupt
        run_chunks(*arguments)

    monkeypatch.setattr(engine, "_run_chunks", interrupted_here)
    monkeypatch.setattr(engine, "_MOST_WORK", 1)
    out = np.zeros(100_000, np.int32)
    with pytest.raises(KeyboardInterrupt):
        engine.run(_count, len(out), [wp.array(out, device=CPU, copy=False)], CPU, 3, 10**9)
    done = out.sum()
    assert done < len(out)  # 100,000 launches take longer than the interrupt
    assert engine._threads(2).submit(out.sum).result() == done


def test_however_often_it_is_interrupted_a_call_outlasts_its_threads(monkeypatch):
    """They write to arrays that are released afterwards."""
    run_chunks, patient, begun, waits = engine._run_chunks, engine.wait, threading.Event(), []
    ended = []

    def slow_elsewhere(*arguments):
        if threading.current_thread() is threading.main_thread():
            begun.wait(10.0)
            return
        begun.set()
        patient([engine._threads(2).submit(threading.Event().wait, 0.2)])  # some work
        run_chunks(*arguments)
        ended.append(True)

    def impatient(futures):
        waits.append(futures)
        if len(waits) <= 3:
            raise KeyboardInterrupt
        return patient(futures)

    monkeypatch.setattr(engine, "_run_chunks", slow_elsewhere)
    monkeypatch.setattr(engine, "wait", impatient)
    out = np.zeros(1000, np.int32)
    with pytest.raises(KeyboardInterrupt):
        engine.run(_count, len(out), [wp.array(out, device=CPU, copy=False)], CPU, 2, 10**9)
    assert ended == [True]
    assert len(waits) == 4


def test_fewer_threads_than_asked_for_do_the_work(monkeypatch):
    """As when the system has no more, or Python is ending."""

    class NoMore:
        left = 1

        def submit(self, work, *arguments):
            if self.left == 0:
                raise RuntimeError("can't start new thread")
            self.left -= 1
            return engine.ThreadPoolExecutor(1).submit(work, *arguments)

    pool = NoMore()
    monkeypatch.setattr(engine, "_threads", lambda _: pool)
    out = np.zeros(10_000, np.int32)
    engine.run(_count, len(out), [wp.array(out, device=CPU, copy=False)], CPU, 4, 10**9)
    assert (out == 1).all()
    assert pool.left == 0


def test_an_error_in_a_worker_reaches_the_caller():
    with pytest.raises(Exception, match="argument"):
        engine.run(_count, 10, ["not an array"], CPU, 2, 10**9)


def _reserve(size):
    """Memory that is only allocated when it is written to."""
    return mmap.mmap(-1, size, flags=mmap.MAP_PRIVATE | mmap.MAP_ANONYMOUS | getattr(mmap, "MAP_NORESERVE", 0x4000))


@pytest.mark.parametrize("count", [3, 64])
def test_beyond_two_to_the_31_directions(count):
    """The last rows of 2^31 + 2^20 directions: 26 GB of addresses, of which only those pages are touched."""
    points = (2**31 + 2**20) // count
    size = points * count
    try:
        vectors, normals = (np.frombuffer(_reserve(12 * n), np.float32, 3 * n) for n in (size, points))
    except OSError:
        pytest.skip("this machine does not hand out address space that it has no memory for")
    tail = np.random.default_rng(8).normal(size=(1000, 3)).astype(np.float32)
    normals[-3000:] = tail.ravel()
    status = np.zeros(points, np.uint8)
    distribution, sequence = ws.CosineHemisphere(), ws.sequences.get("sobol")
    slots = (sequence, distribution.about(), None, 0.0, False, False)
    job = DirectionJob()
    job.points, job.count, job.block, job.rows = points, count, count, 1
    job.normals, job.vectors, job.status = normals.ctypes.data, vectors.ctypes.data, status.ctypes.data
    if count == 64:
        kernel, tasks, last = direction_rows(*slots, CHUNK), points, 1000
    else:
        kernel, tasks, last = (
            direction_blocks(*slots, False),
            -(-size // FLAT_BLOCK),
            1000 * count // 256,
        )
    wp.launch(kernel, dim=last, inputs=[job, tasks - last], device=CPU, record_tape=False)
    expected = ws.sample_directions(tail, count, first_point=points - 1000).vectors.ravel()
    got = vectors[-len(expected) :]
    written = last * 256 * 3 if count == 3 else len(expected)
    assert written > 2000
    assert np.array_equal(got[-written + 3 * 256 :], expected[-written + 3 * 256 :])


def test_threads_and_launches_are_kept(normals):
    before = engine._threads(2)
    many = np.repeat(normals, 200, axis=0)
    ws.sample_directions(many, 16, workers=3)
    idle = {key: len(commands) for key, commands in engine._idle.items()}
    ws.sample_directions(many, 16, workers=3)
    assert engine._threads(2) is before
    assert {key: len(commands) for key, commands in engine._idle.items()} == idle


# Sequence and map have loops of their own, so each needs one partner only.
VECTORISED = [
    *((name, ws.CosineHemisphere("polar")) for name in ws.sequences.names()),
    ("sobol", ws.CosineHemisphere("offset")),
    ("sobol", ws.CosineHemisphere("concentric")),
    ("sobol", ws.CosineHemisphere("inversion")),
    *(
        ("sobol", ws.distributions.get(name).cases()[-1])
        for name in ws.distributions.names()
        if name not in ("cosine_hemisphere", "visible_beckmann")  # the latter says in its record that it is scalar
    ),
]

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
        ws.sample_directions(normals, count, case, name)
for count in (1, 3, 64) if FIRST else ():
    announce("pdf and active", count)
    ws.sample_directions(normals, count, pdf=True, active=[True, False])
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


@pytest.mark.slow
def test_every_loop_of_directions_is_vectorised(tmp_path, child_environment):
    """According to the compiler's remarks, with a cold cache, in two processes."""
    halves = [VECTORISED[::2], VECTORISED[1::2]]
    children = []
    for i, half in enumerate(halves):
        cases = "[" + ", ".join(f"({name!r}, ws.{case!r})" for name, case in half) + "]"
        script = tmp_path / f"remarks_{i}.py"
        script.write_text(_REMARKS.replace("CASES", cases).replace("FIRST", str(i == 0)))
        environment = {**child_environment, "WARP_CACHE_PATH": str(tmp_path / f"cache_{i}")}
        children.append(subprocess.Popen([sys.executable, script], env=environment, stderr=subprocess.PIPE, text=True))
    outputs = [child.communicate()[1] for child in children]
    for child, remarks in zip(children, outputs, strict=True):
        assert child.returncode == 0, remarks
        compiled = re.split(r"^@@ ", remarks, flags=re.MULTILINE)[1:-1]
        assert len(compiled) > 25
        for one in compiled:
            # Hot loops are the `while`s of their kernel; those over rows, and those that mend, are `for` loops.
            hot = re.findall(r"vectorized loop \(vectorization width: (\d+).*\n.*goto end_while_", one)
            assert hot, one
            assert min(map(int, hot)) >= 4  # lanes of SSE, the narrowest
            assert not re.search(r"loop not vectorized.*\n.*goto end_while_", one), one


def slots(sequence, case, with_pdf, masked):
    maps = case.maps
    return (ws.sequences.get(sequence), case.about(), maps.redraw, maps.redraw_below, with_pdf, masked)


def all_kernels():
    yield "place_points", place_points()
    for name in ws.sequences.names():
        yield f"square {name}", square_blocks(ws.sequences.get(name).sample)
        yield f"rows {name}", direction_rows(*slots(name, ws.CosineHemisphere(), True, True), 1)
    for case in dict.fromkeys(case for _, case in VECTORISED):
        w = case.width
        maps = [(case.maps.sample, 2, w), (case.maps.pdf, w, 1), (case.maps.invert, w, 2)]
        if w == 3:  # holds sample and pdf
            yield f"blocks {case}", direction_blocks(*slots("sobol", case, True, False), False)
            maps = maps[2:]
        for func, width, out in maps:
            if func is not None:
                bound = with_parameters(func, wp.vec2 if width == 2 else wp.vec3, len(case.parameters))
                yield f"{func.key} {case}", elementwise(bound, width, out)


@pytest.mark.slow
@pytest.mark.parametrize(("label", "kernel"), [pytest.param(*pair, id=pair[0]) for pair in all_kernels()])
def test_every_kernel_compiles_for_cuda(label, kernel, tmp_path):
    """They are compiled to PTX by the compiler in warp-lang, which needs no driver."""
    if kernel.module in _compiled:
        return
    _compiled.add(kernel.module)
    (ptx,) = wp.compile_aot_module(kernel.module, device=None, arch=86, use_ptx=True, module_dir=tmp_path)
    assert ".visible .entry" in ptx.read_text()


_compiled = set()


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
    built = len(direction_rows.known)
    for tilt in (0.25, 0.5):
        distribution = Tilted(tilt)
        assert (distribution.sample(u)[:, 0] == tilt).all()
        assert distribution.pdf(up).tolist() == [tilt]
        assert (distribution.invert(up)[:, 0] == tilt).all()
        assert np.abs(ws.sample_directions(up, 16, distribution).vectors[0, :, 0] - tilt).max() <= 1e-7
    assert len(direction_rows.known) == built + 1


def test_kernels_are_built_once_for_equal_jobs(normals):
    ws.sample_directions(normals, 16)
    built = len(direction_rows.known)
    ws.sample_directions(normals, 32, seed=9)
    ws.sample_directions(normals, 16, ws.CosineHemisphere("polar"))
    assert len(direction_rows.known) == built
