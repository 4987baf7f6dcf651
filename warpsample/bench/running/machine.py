"""What the figures depend on: processor, cores, versions, commit."""

import platform
import subprocess
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path

import warp as wp

from warpsample.host.engine import check_workers


@dataclass(frozen=True)
class Machine:
    """Where something was measured, and by which versions of Python, warp-lang, NumPy and warpsample.

    Attributes:
        cpu: the processor's own name, where the system tells it.
        instructions: the widest that the kernels use there: "avx512", "avx2", or else the architecture. They use none
            that Warp's flags deny the compiler.
        cores: that the process may use.
        commit: of the checkout around the package, "unknown" without one.
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
        """In a line, for pictures and headings."""
        return (
            f"{self.processor}, {self.cores} cores, warp-lang {self.warp}, NumPy {self.numpy}, "
            f"Python {self.python}, commit {self.commit}"
        )

    @property
    def processor(self) -> str:
        """Its name and its instructions."""
        return f"{self.cpu}, {({'avx512': 'AVX-512', 'avx2': 'AVX2'}).get(self.instructions, self.instructions)}"


def this_machine() -> Machine:
    """The machine of this process."""
    versions = [version(name) for name in ("warp-lang", "numpy", "warpsample")]
    here = check_workers(None), platform.system(), platform.python_version()
    return Machine(*_processor(), *here, *versions, commit(Path(__file__).parents[2]))


def _processor() -> tuple[str, str]:
    information = Path("/proc/cpuinfo")
    lines = information.read_text().splitlines() if information.is_file() else []
    entries = dict(line.split(":", 1) for line in lines if ":" in line)
    names = {key.strip(): value.strip() for key, value in entries.items()}
    denied = {flag[1:] for flag in (wp.config.cpu_compiler_flags or "").split() if flag.startswith("-avx")}
    flags = set(names.get("flags", "").split()) - denied
    found = next((name for flag, name in (("avx512f", "avx512"), ("avx2", "avx2")) if flag in flags), platform.machine())
    return names.get("model name") or platform.processor() or platform.machine(), found.lower()


def commit(package: Path) -> str:
    """The commit of the checkout around a package, if the package is what is in it; else "unknown"."""
    try:
        top = Path(_git(package, "rev-parse", "--show-toplevel"))
        files = sorted(package.rglob("*.py"))
        if not all(file.read_bytes() == (top / "warpsample" / file.relative_to(package)).read_bytes() for file in files):
            return "unknown"
        changed = _git(top, "status", "--porcelain", "--", ":(glob)warpsample/**/*.py")  # results are no part of it
        return _git(top, "rev-parse", "--short=12", "HEAD") + ("+changes" if changed else "")
    except (OSError, subprocess.CalledProcessError):
        return "unknown"


def _git(folder: Path, *arguments: str) -> str:
    command = ["git", "-C", str(folder), *arguments]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip()


def peak_megabytes() -> float | None:
    """The greatest resident memory of this process so far; None on a system that does not say it as Linux does."""
    status = Path("/proc/self/status")
    if not status.is_file():  # getrusage would count what the parent held when it started this process, too
        return None
    return next(float(line.split()[1]) * 1024 / 1e6 for line in status.read_text().splitlines() if "VmHWM" in line)
