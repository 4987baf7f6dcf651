"""Kernels for AVX2 on a processor that has AVX-512, in each Python process that has this folder in its PYTHONPATH.

`PYTHONPATH=tests/support/avx2 WARP_CACHE_PATH=/tmp/avx2 pytest` tries what other users get.
"""

import importlib.abc
import importlib.util
import sys

FLAGS = "-target-feature -avx512f"


class ConfigFinder(importlib.abc.MetaPathFinder):
    """Adds the flags to those of `warp.config` when it is imported."""

    def find_spec(self, name, path, target=None):
        if name != "warp.config":
            return None
        sys.meta_path.remove(self)
        spec = importlib.util.find_spec(name)
        run = spec.loader.exec_module

        def run_and_add(module):
            run(module)
            module.cpu_compiler_flags += f" {FLAGS}"

        spec.loader.exec_module = run_and_add
        return spec


sys.meta_path.insert(0, ConfigFinder())
