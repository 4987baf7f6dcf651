"""Lobes that nothing blocks: the loops over their directions."""

import re
import subprocess
import sys

import pytest

_REMARKS = """
import warp as wp
wp.config.log_level = wp.LOG_WARNING
wp.config.cpu_compiler_flags += " -Rpass=loop-vectorize -Rpass-missed=loop-vectorize"
import warpsample as ws
@wp.func
def sky(w: wp.vec3) -> wp.vec3:
    return wp.vec3(0.3, 0.4, 0.5) * wp.max(w[2], 0.0)
ws.integrate([[0.0, 0.0, 1.0]], sky, 256, distribution=ws.DISTRIBUTION, sequence="SEQUENCE")
"""


@pytest.mark.thorough
@pytest.mark.parametrize(("distribution", "sequence"), [("CosineHemisphere()", "fibonacci"), ("GGX(0.3)", "sobol")])
def test_every_loop_over_directions_is_vectorised(distribution, sequence, tmp_path, child_environment):
    """The compiler's own remarks say so. Float64 in the loop of the map would halve its lanes."""
    script = tmp_path / "remarks.py"
    script.write_text(_REMARKS.replace("DISTRIBUTION", distribution).replace("SEQUENCE", sequence))
    environment = {**child_environment, "WARP_CACHE_PATH": str(tmp_path / "cache")}
    done = subprocess.run([sys.executable, script], env=environment, capture_output=True, text=True, check=True)
    widths = [int(n) for n in re.findall(r"vectorized loop \(vectorization width: (\d+).*\n.*goto end_while_", done.stderr)]
    assert len(widths) == 3, done.stderr  # the sequence, its sector, and the map with what is integrated
    assert len(set(widths[1:])) == 1  # all float32
    scalar = re.findall(r"loop not vectorized.*\n *(\d+) .*goto end_while_", done.stderr)
    assert len(set(scalar)) == 2, done.stderr  # what adds up a row, in four sums, and its remainder
