"""Files with the results of benchmarks.

`bench --json` writes every repeat. The files in `results/`, the source of the pages, keep medians and quartiles to four
digits. There is one file for each benchmark and kind of processor, with one line for each row.
"""

import json
from dataclasses import asdict, fields, is_dataclass
from pathlib import Path
from typing import Any, get_args, get_type_hints

from warpsample.bench.record import SEED, Benchmark, Result
from warpsample.bench.rows import Spread, get_columns
from warpsample.bench.running.machine import Machine
from warpsample.host.files import write_bytes

RESULTS = Path(__file__).parent / "results"


def save_repeats(path: Path, benchmark: Benchmark, result: Result) -> None:
    """Write a benchmark's result to a JSON file, atomically: machine, settings, and every row with all repeats."""
    rows = {part: [asdict(row) for row in rows] for part, rows in result.rows.items()}
    write_bytes(path, json.dumps({**_describe_run(benchmark, result), **rows}, indent=1, default=str).encode())


def save_summary(benchmark: Benchmark, result: Result, folder: Path = RESULTS) -> Path:
    """Write a benchmark's medians and quartiles for this processor to a file; return the path."""
    path = folder / f"{benchmark.name}-{result.machine.instructions}.json"
    parts = {
        key: json.dumps(value, ensure_ascii=False, default=str) for key, value in _describe_run(benchmark, result).items()
    }
    parts |= {part: _format_table(list(get_columns(kind)), result.rows[part]) for part, kind in benchmark.parts.items()}
    text = ",\n".join(f'"{key}": {value}' for key, value in parts.items())
    write_bytes(path, f"{{{text}}}\n".encode())
    return path


def load(benchmark: Benchmark, path: Path) -> Result:
    """Read a benchmark's result from a file written by `save_summary`; the rows have no repeats.

    Raises:
        ValueError: the file is damaged or from another version; names the file.
    """
    try:
        content = json.loads(path.read_text(encoding="utf-8"))
        rows = {part: [_build_row(kind, row, content[part]["columns"]) for row in content[part]["rows"]]
                 for part, kind in benchmark.parts.items()}  # fmt: skip
        return Result(Machine(**content["machine"]), dict(content["settings"]), rows)
    except (KeyError, TypeError, ValueError) as error:
        reason = f"{type(error).__name__} {error}"
        raise ValueError(f"{path}: got {reason}, want a file written by `warpsample bench all --write`") from error


def load_results(instructions: str, benchmarks: dict[str, Benchmark], folder: Path = RESULTS) -> dict[str, Result]:
    """Return the benchmark results in `folder` for one kind of processor, keyed by benchmark."""
    files = {name: folder / f"{name}-{instructions}.json" for name in benchmarks}
    return {name: load(benchmarks[name], path) for name, path in files.items() if path.is_file()}


def _describe_run(benchmark: Benchmark, result: Result) -> dict[str, Any]:
    return {
        "command": f"bench {benchmark.name}",
        "machine": asdict(result.machine),
        "settings": result.settings,
        "seed": SEED,
    }


def _format_table(names: list[str], rows: list[Any]) -> str:
    shown = names if rows else []
    lines = [json.dumps([_shorten(getattr(row, name)) for name in shown], ensure_ascii=False) for row in rows]
    return f'{{"columns": {json.dumps(shown)},\n "rows": [\n' + ",\n".join(f"  {line}" for line in lines) + "]}"


def _shorten(value: Any) -> Any:
    if isinstance(value, float):
        return float(f"{value:.4g}")
    if is_dataclass(value):
        return [_shorten(getattr(value, f.name)) for f in fields(value)]
    return {key: _shorten(v) for key, v in value.items()} if isinstance(value, dict) else value


def _build_row(kind: type, values: list[Any], names: list[str]) -> Any:
    types = get_type_hints(kind)
    return kind(**{name: _build_value(types[name], value) for name, value in zip(names, values, strict=True)})


def _build_value(kind: Any, value: Any) -> Any:
    """Convert a JSON list to a `Spread` where the field is one; return any other value unchanged."""
    return Spread(*value) if Spread in (kind, *get_args(kind)) and value is not None else value
