"""The hot loops of rays and estimates are vectorised, and both tracers compile for CUDA."""

import re
import subprocess
import sys

import pytest
import warp as wp

from warpsample.tracing.builtin import builtin_any_query, builtin_query, prepare_builtin
from warpsample.tracing.rays import build_hit_writer, ray_kernel
from warpsample.tracing.wide.prepare import prepare_wide
from warpsample.tracing.wide.query import wide_query

_REMARKS = """
import sys
import warp as wp
wp.config.log_level = wp.LOG_WARNING
wp.config.cpu_compiler_flags += " -Rpass=loop-vectorize -Rpass-missed=loop-vectorize"
import warpsample as ws
from warpsample.city.rasters.horizon_kernel import horizon_kernel
from warpsample.estimate.kernel import estimate_kernel
from warpsample.estimate.slots import Slots
from warpsample.estimate.weights import Weights, above, everywhere
from warpsample.tracing.wide.prepare import prepare_wide
from warpsample.tracing.rays import build_hit_writer, ray_kernel
from warpsample.tracing.wide.query import wide_query
several = wide_query(True, several=True)
rays = (ws.sequences.get("fibonacci"), ws.CosineHemisphere("polar").about(), None, 0.0, True)
kernels = (
    estimate_kernel(Slots(*rays, everywhere, Weights, True, True, 1, prepare_wide, several, True, True)),
    estimate_kernel(Slots(*rays, above, Weights, False, False, 1, None, None, True, True)),
    ray_kernel(prepare_wide, build_hit_writer(wide_query(False))),
    ray_kernel(prepare_wide, build_hit_writer(wide_query(True))),
    horizon_kernel(),
)
for kernel in kernels[: int(sys.argv[1])]:
    print("@@", file=sys.stderr, flush=True)
    wp.load_module(kernel.module, device="cpu")
"""


@pytest.mark.parametrize("count", [pytest.param(2, marks=pytest.mark.slow), pytest.param(5, marks=pytest.mark.thorough)])
def test_the_hot_loops_are_vectorised(count, tmp_path, child_environment):
    """The compiler's own remarks say so.

    The loops of rays are over the boxes of a node, the triangles of a leaf, and the rays of a chunk (two). Those of an
    estimate are: boxes, triangles and preparation; start, variates and directions of a stratum's rays; children and
    triangles above the horizon; a shaft's vectors and limits, boxes and triangles; of rays together, the sides of a leaf,
    and triangles or rays between them. Those of an integral without a mesh are:
    variates; their move into the sector; directions with the integrand. Its sums are four chains of additions in a fixed
    order (and the rest). Horizons have azimuths and directions besides what rays together have.
    The remark is at the loop's end, or at a branch in it that became a selection.
    """
    script = tmp_path / "remarks.py"
    script.write_text(_REMARKS)
    environment = {**child_environment, "WARP_CACHE_PATH": str(tmp_path / "cache")}
    done = subprocess.run([sys.executable, script, str(count)], env=environment, capture_output=True, text=True, check=True)
    _, *compiled = done.stderr.split("@@")
    assert len(compiled) == count
    for remarks, loops, in_order in zip(compiled, (15, 3, 4, 4, 11), (0, 2, 0, 0, 0), strict=False):
        hot = re.findall(
            r":(\d+):\d+: remark: vectorized loop \(vectorization width: (\d+).*\n.*(?:goto end_while_|if \(var_\d+\) {)",
            remarks,
        )
        assert len({line for line, _ in hot}) == loops, remarks
        assert min(int(width) for _, width in hot) >= 4  # lanes of SSE, the narrowest
        assert len(re.findall(r"loop not vectorized.*\n.*goto end_while_", remarks)) == in_order, remarks


KERNELS = {
    "wide": (prepare_wide, build_hit_writer(wide_query(False))),
    "warp": (prepare_builtin, build_hit_writer(builtin_query)),
    "warp, any": (prepare_builtin, build_hit_writer(builtin_any_query)),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", KERNELS)
def test_both_tracers_compile_for_cuda(name, tmp_path):
    kernel = ray_kernel(*KERNELS[name])
    (ptx,) = wp.compile_aot_module(kernel.module, device=None, arch=86, use_ptx=True, module_dir=tmp_path)
    assert ".visible .entry" in ptx.read_text()
