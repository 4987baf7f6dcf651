"""What the figures depend on: processor, cores, versions, commit."""

import platform
import subprocess
from importlib.metadata import version
from pathlib import Path

from warpsample.host.engine import check_workers


def machine() -> dict[str, object]:
    """Of this process; `cores` are those that it may use."""
    versions = {name: version(name) for name in ("warpsample", "warp-lang", "numpy")}
    return {
        "cpu": _cpu(),
        "cores": check_workers(None),
        "system": platform.system(),
        "python": platform.python_version(),
        **versions,
        "commit": commit(),
    }


def caption() -> str:
    """The same in a line, for pictures."""
    m = machine()
    return f"{m['cpu']}, {m['cores']} cores, warp-lang {m['warp-lang']}, NumPy {m['numpy']}, warpsample {m['commit']}"


def _cpu() -> str:
    """The processor's own name where the system tells it, and its vector width, on which everything here depends."""
    information = Path("/proc/cpuinfo")
    lines = information.read_text().splitlines() if information.is_file() else []
    entries = dict(line.split(":", 1) for line in lines if ":" in line)
    names = {key.strip(): value for key, value in entries.items()}
    flags = names.get("flags", "").split()
    width = next((name for flag, name in (("avx512f", " AVX-512"), ("avx2", " AVX2")) if flag in flags), "")
    return names.get("model name", platform.processor() or platform.machine()).strip() + width


def commit() -> str:
    """Of the checkout around the package, if the package is what is in it; else "unknown"."""
    package = Path(__file__).parents[1]
    try:
        top = Path(_git(package, "rev-parse", "--show-toplevel"))
        files = sorted(package.rglob("*.py"))
        if not all(file.read_bytes() == (top / "warpsample" / file.relative_to(package)).read_bytes() for file in files):
            return "unknown"
        changed = _git(top, "status", "--porcelain", "--", "warpsample")
        return _git(top, "rev-parse", "--short=12", "HEAD") + ("+changes" if changed else "")
    except (OSError, subprocess.CalledProcessError):
        return "unknown"


def _git(folder: Path, *arguments: str) -> str:
    command = ["git", "-C", str(folder), *arguments]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip()
