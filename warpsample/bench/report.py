"""What was measured, as tables to read or as JSON lines to keep."""

import json
import platform
from dataclasses import asdict
from importlib.metadata import version
from pathlib import Path

from warpsample.bench.directions import Row
from warpsample.bench.startup import Startup
from warpsample.engine import check_workers


def machine() -> dict[str, object]:
    """What the figures depend on."""
    versions = {name: version(name) for name in ("warpsample", "warp-lang", "numpy")}
    return {"cpu": _cpu(), "cores": check_workers(None), "python": platform.python_version(), **versions}


def _cpu() -> str:
    """The processor's own name where the system tells it, and its vector width, on which everything here depends."""
    information = Path("/proc/cpuinfo")
    lines = information.read_text().splitlines() if information.is_file() else []
    entries = dict(line.split(":", 1) for line in lines if ":" in line)
    names = {key.strip(): value for key, value in entries.items()}
    flags = names.get("flags", "").split()
    width = next((name for flag, name in (("avx512f", " AVX-512"), ("avx2", " AVX2")) if flag in flags), "")
    return names.get("model name", platform.processor() or platform.machine()).strip() + width


def show(rows: list[Row], starts: list[Startup], as_json: bool) -> None:
    """Prints all of it."""
    if as_json:
        for record in [{"machine": machine()}, *map(asdict, rows), *map(asdict, starts)]:
            print(json.dumps(record))  # noqa: T201
        return
    from rich.box import SIMPLE  # noqa: PLC0415
    from rich.console import Console  # noqa: PLC0415
    from rich.table import Table  # noqa: PLC0415

    console = Console()
    console.print("sample_directions into an existing float32 (x, y, z) array; medians; fill is NumPy's out.fill(0)")
    console.print(", ".join(f"{key} {value}" for key, value in machine().items()))
    for samples in sorted({row.samples for row in rows}, reverse=True):
        chosen = [row for row in rows if row.samples == samples]
        title = f"{chosen[0].points:,} points x {samples}, million directions per second"
        table = Table(title=title, box=SIMPLE, padding=(0, 1, 0, 0))
        for heading in ("case", "workers", "M/s", "of fill", "spread", "x built-ins", "x 1 worker"):
            table.add_column(heading, justify="left" if heading == "case" else "right")
        for row in chosen:
            mid, low, high = row.of_fill
            table.add_row(
                row.case,
                str(row.workers),
                f"{row.million_per_second:.0f}",
                f"{mid:.2f}",
                f"{low:.2f}-{high:.2f}",
                f"{row.of_builtins:.1f}",
                f"{row.of_one_worker:.2f}",
            )
        console.print(table)
    table = Table(title="A new process, seconds", box=SIMPLE)
    for heading in ("kernel cache", "import warp", "+ import warpsample", "first directions"):
        table.add_column(heading, justify="left" if heading == "kernel cache" else "right")
    for start in starts:
        table.add_row(
            start.kernel_cache,
            f"{start.import_warp:.2f}",
            f"{start.import_warpsample:.3f}",
            f"{start.first_directions:.2f}",
        )
    console.print(table)
