"""Description of the machine that runs a benchmark: processor, cores, versions and commit."""

import platform
import subprocess
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path

import warp as wp

from warpsample.host.engine import check_workers


@dataclass(frozen=True)
class Machine:
    """Machine that ran a benchmark, with versions of Python, warp-lang, NumPy and warpsample.

    Attributes:
        cpu: model name of the processor, or its architecture if the system does not report a name.
        instructions: widest instructions of the kernels: "avx512", "avx2" or the architecture. Instructions that Warp's
            compiler flags disable do not count.
        cores: cores that the process may use.
        commit: commit of the checkout around the package; "unknown" without a checkout.
    """

    cpu: str
    instructions: str
    cores: int
    system: str
    python: str
    warp: str
    numpy: str
    warpsample: str
    commit: str

    def __str__(self) -> str:
        """Return a description of the machine in one line, for pictures and headings."""
        return (
            f"{self.processor}, {self.cores} cores, warp-lang {self.warp}, NumPy {self.numpy}, "
            f"Python {self.python}, commit {self.commit}"
        )

    @property
    def processor(self) -> str:
        """Name of the processor and its widest vector instructions."""
        return f"{self.cpu}, {({'avx512': 'AVX-512', 'avx2': 'AVX2'}).get(self.instructions, self.instructions)}"


def describe_machine() -> Machine:
    """Return a description of this machine and of the versions of this process."""
    versions = [version(name) for name in ("warp-lang", "numpy", "warpsample")]
    here = check_workers(None), platform.system(), platform.python_version()
    return Machine(*_read_processor(), *here, *versions, find_commit(Path(__file__).parents[2]))


def _read_processor() -> tuple[str, str]:
    information = Path("/proc/cpuinfo")
    lines = information.read_text().splitlines() if information.is_file() else []
    entries = dict(line.split(":", 1) for line in lines if ":" in line)
    names = {key.strip(): value.strip() for key, value in entries.items()}
    denied = {flag[1:] for flag in (wp.config.cpu_compiler_flags or "").split() if flag.startswith("-avx")}
    flags = set(names.get("flags", "").split()) - denied
    widest = next((name for flag, name in (("avx512f", "avx512"), ("avx2", "avx2")) if flag in flags), platform.machine())
    return names.get("model name") or platform.processor() or platform.machine(), widest.lower()


def find_commit(package: Path) -> str:
    """Return the git commit of a package's checkout; "unknown" if the checkout has other files than the package."""
    try:
        top = Path(_run_git(package, "rev-parse", "--show-toplevel"))
        files = sorted(package.rglob("*.py"))
        if not all(file.read_bytes() == (top / "warpsample" / file.relative_to(package)).read_bytes() for file in files):
            return "unknown"
        changed = _run_git(
            top, "status", "--porcelain", "--", ":(glob)warpsample/**/*.py"
        )  # result files do not count as changes
        return _run_git(top, "rev-parse", "--short=12", "HEAD") + ("+changes" if changed else "")
    except (OSError, subprocess.CalledProcessError):
        return "unknown"


def _run_git(folder: Path, *arguments: str) -> str:
    command = ["git", "-C", str(folder), *arguments]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip()


def measure_peak_megabytes() -> float | None:
    """Return the peak resident memory of this process in MB; None on systems without /proc/self/status."""
    status = Path("/proc/self/status")
    if not status.is_file():  # getrusage would include the parent's memory at the start of this process
        return None
    return next(float(line.split()[1]) * 1024 / 1e6 for line in status.read_text().splitlines() if "VmHWM" in line)
