"""Beyond 2^31 directions or rays, and beyond 2^32 points: only the last are computed, and other memory is not touched."""

import mmap
from ctypes import Structure

import numpy as np
import pytest
import warp as wp

import warpsample as ws
from warpsample.directions import plan
from warpsample.directions.blocks import direction_blocks
from warpsample.directions.rows import direction_rows
from warpsample.directions.samples import SamplesArgs
from warpsample.directions.variates import CHUNK as VARIATES
from warpsample.distributions.elementwise import FLAT_BLOCK
from warpsample.tracing.given_rays import rays_of
from warpsample.tracing.placement import make_placement
from warpsample.tracing.queries import CHUNK
from warpsample.tracing.rays import build_hit_writer, ray_kernel
from warpsample.tracing.scene import scene_of
from warpsample.tracing.triples import Triples
from warpsample.tracing.wide.prepare import prepare_wide
from warpsample.tracing.wide.query import wide_query

MANY = 2**31 + 2**20


def reserved(dtype, *counts):
    """Arrays that take memory only where they are written to."""
    flags = mmap.MAP_PRIVATE | mmap.MAP_ANONYMOUS | getattr(mmap, "MAP_NORESERVE", 0x4000)
    try:
        return [np.frombuffer(mmap.mmap(-1, n * np.dtype(dtype).itemsize, flags=flags), dtype, n) for n in counts]
    except OSError:
        pytest.skip("this machine does not hand out address space that it has no memory for")


def launch_last(last, kernel, inputs, tasks):
    """Runs the last of a kernel's tasks, as the engine does, which fills structs by ctypes."""
    given = [arg.type() if isinstance(x, Structure) else x for arg, x in zip(kernel.adj.args, inputs, strict=False)]
    command = wp.launch(kernel, dim=last, inputs=[*given, tasks - last], device="cpu", record_tape=False, record_cmd=True)
    for index, value in enumerate(inputs):
        if isinstance(value, Structure):
            command.set_param_at_index_from_ctype(index, value)
    command.launch()


@pytest.mark.parametrize("count", [3, 64])
def test_directions(count):
    """Three directions per point are computed in flat blocks, 64 in rows."""
    points = MANY // count
    size = points * count
    vectors, normals = reserved(np.float32, 3 * size, 3 * points)
    tail = np.random.default_rng(8).normal(size=(1000, 3)).astype(np.float32)
    normals[-3000:] = tail.ravel()
    status = np.zeros(points, np.uint8)
    distribution, sequence = ws.CosineHemisphere(), ws.sequences.get("sobol")
    parts = sequence, distribution.about()
    how = {"redraw": None, "redraw_below": 0.0, "with_pdf": False, "masked": False}
    samples = SamplesArgs()
    samples.run = sequence.run_words(0, 0)
    samples.points, samples.count, samples.segment, samples.rows = points, count, count, 1
    samples.normals, samples.vectors, samples.status = normals.ctypes.data, vectors.ctypes.data, status.ctypes.data
    if count == 64:
        last, written = 1000, 1000 * count
        launch_last(last, direction_rows(*parts, **how, chunk=VARIATES), [samples], points)
    else:
        last = 1000 * count // FLAT_BLOCK
        written = last * FLAT_BLOCK - FLAT_BLOCK  # the very last block is not full
        launch_last(last, direction_blocks(*parts, **how, one_sample=False), [samples], -(-size // FLAT_BLOCK))
    expected = ws.sample_directions(tail, count, first_point=points - 1000).vectors.ravel()
    assert written > 2000
    assert np.array_equal(vectors[-3 * written :], expected[-3 * written :])


@pytest.mark.parametrize("first", [0, 2**32, 2**32 - 3, 2**40 + 1])
def test_no_job_has_ids_of_two_high_words(first, monkeypatch):
    """A kernel adds to the low word of an id alone. The jobs are looked at, and not run."""
    points, jobs = 2**32 + 5, []
    normals, out = reserved(np.float32, 3 * points, 3 * points)
    monkeypatch.setattr(plan, "run", lambda *arguments, **_: jobs.append(arguments[2][0]))
    ws.sample_directions(normals.reshape(-1, 3), 1, first_point=first, out=out.reshape(-1, 1, 3))
    ends = np.cumsum([first, *(job.points for job in jobs)], dtype=object)
    assert ends[-1] == first + points
    for job, start, end in zip(jobs, ends, ends[1:], strict=False):
        high, low = divmod(start, 2**32)
        assert job.first_point == low
        assert high == end - 1 >> 32
        assert tuple(job.run) == ws.sequences.get("sobol").run_words(0, high)


@pytest.mark.parametrize("per_point", [1, MANY])
def test_rays(per_point):
    """Each ray has an origin of its own, or all share one."""
    directions, distance, origins = reserved(np.float32, 3 * MANY, MANY, 3 * MANY // per_point)
    (face,) = reserved(np.int32, MANY)
    directions[-3:], origins[-3:] = [0.0, 0.0, -1.0], [0.5, 0.5, 3.0]
    scene = scene_of(ws.as_mesh(([(0, 0, 0), (2, 0, 0), (0, 2, 0)], [(0, 1, 2)])))
    way = Triples.of(directions.reshape(-1, 3), "directions")
    start = Triples.of(origins.reshape(-1, 3) if per_point == 1 else origins, "origins")
    rays = rays_of(make_placement(scene, start, np.inf), way, ws.Hits(distance, face, "wide"))
    rays.per_task = CHUNK
    inputs = [rays, scene.tree(1).accelerator()]
    launch_last(10, ray_kernel(prepare_wide, build_hit_writer(wide_query(False))), inputs, -(-MANY // CHUNK))
    assert (distance[-1], face[-1]) == (3.0, 0)
    assert np.isnan(distance[-10 * CHUNK : -1]).all()  # of zero directions
