"""Optional libraries: the extras that bring them, the error for a missing one, and a process for one that may crash."""

import os
import subprocess
import sys

EXTRAS: dict[str, tuple[str, ...]] = {
    "viz": ("pyvista", "matplotlib", "pxr", "trame", "nest_asyncio2", "ipywidgets"),
    "radiation": ("pvlib", "pyradiance"),
    "cluster": ("dask", "distributed", "zarr", "xarray"),
    "city": ("rasterio", "rioxarray", "pyproj", "affine", "h5netcdf"),
    "texture": ("xatlas", "PIL", "OpenEXR"),
    "test": ("trimesh",),
}
"""Modules that each extra installs, as pyproject.toml lists them; a module of several extras is listed once."""


def missing(what: str, module: str | None, extra: str = "") -> ModuleNotFoundError:
    """Return the ModuleNotFoundError for a missing optional library, with the command that installs it.

    The line installs from a checkout, `.`: the package is not on an index.

    Args:
        what: clause that names the library, as "weather needs pvlib".
        module: module that was not found, perhaps a part of a package.
        extra: name of another extra, or of several, where the call needs more than the module.
    """
    top = str(module).partition(".")[0]
    found = extra or next((name for name, modules in EXTRAS.items() if top in modules), "")
    return ModuleNotFoundError(f"{what}: pip install " + (f"'.[{found}]'" if found else top), name=top)


REFUSED = 3
"""Exit status of a program of `run_program` that writes a reason in place of its result."""


_START = """import sys
sys.path[:] = {path!r}
import ctypes
if sys.platform == "linux":
    ctypes.CDLL(None).prctl(1, 9)  # PR_SET_PDEATHSIG, SIGKILL
"""


def run_program(program: str, content: bytes = b"") -> tuple[int, bytes]:
    """Run a Python program in a new process, for a library that may crash; an interrupt ends the process.

    The program imports what its parent would import: with an empty path first, as Python does it, modules of the working
    folder would be run. On Linux, the process also ends if a signal kills its parent.

    Args:
        program: source code.
        content: standard input of the program.

    Returns:
        exit status, and standard output.
    """
    texts = [each for each in sys.path if isinstance(each, str)]  # Python passes over others
    command = [sys.executable, "-c", _START.format(path=texts) + program]
    environment = {**os.environ, "PYTHONIOENCODING": "utf-8:surrogateescape"}  # for names of files that it prints
    pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "stderr": subprocess.DEVNULL}
    with subprocess.Popen(command, env=environment, **pipes) as child:
        try:
            output = child.communicate(content)[0]
        finally:
            child.kill()
    return child.returncode, output
