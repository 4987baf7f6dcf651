"""The files of results.

`bench --json` writes everything, every repeat included. The files of `results/`, from which the README is made, hold medians
and quartiles to four digits, a line for each row: one file for each benchmark and kind of processor.
"""

import json
from dataclasses import asdict, fields, is_dataclass
from pathlib import Path
from typing import Any, get_args, get_type_hints

from warpsample.bench.record import SEED, Benchmark, Result
from warpsample.bench.rows import Spread, columns
from warpsample.bench.running.machine import Machine
from warpsample.host.files import write_bytes

RESULTS = Path(__file__).parent / "results"


def save_everything(path: Path, benchmark: Benchmark, result: Result) -> None:
    """Writes machine, settings and every row with all its repeats; complete or not at all."""
    rows = {part: [asdict(row) for row in found] for part, found in result.found.items()}
    write_bytes(path, json.dumps({**_head(benchmark, result), **rows}, indent=1, default=str).encode())


def keep(benchmark: Benchmark, result: Result, folder: Path = RESULTS) -> Path:
    """Writes the file of this benchmark and processor that the README is made from; returns it."""
    path = folder / f"{benchmark.name}-{result.machine.instructions}.json"
    parts = {key: json.dumps(value, ensure_ascii=False, default=str) for key, value in _head(benchmark, result).items()}
    parts |= {part: _table(list(columns(kind)), result.found[part]) for part, kind in benchmark.parts.items()}
    text = ",\n".join(f'"{key}": {value}' for key, value in parts.items())
    write_bytes(path, f"{{{text}}}\n".encode())
    return path


def load(benchmark: Benchmark, path: Path) -> Result:
    """What `keep` wrote, without the repeats.

    Raises:
        ValueError: the file is damaged, or of another version; names it.
    """
    try:
        content = json.loads(path.read_text(encoding="utf-8"))
        found = {part: [_row(kind, row, content[part]["columns"]) for row in content[part]["rows"]]
                 for part, kind in benchmark.parts.items()}  # fmt: skip
        return Result(Machine(**content["machine"]), dict(content["settings"]), found)
    except (KeyError, TypeError, ValueError) as error:
        told = f"{type(error).__name__} {error}"
        raise ValueError(f"{path}: got {told}, want results as `warpsample bench all --write` keeps them") from error


def kept(instructions: str, benchmarks: dict[str, Benchmark], folder: Path = RESULTS) -> dict[str, Result]:
    """What `folder` holds of a kind of processor, by the name of the benchmark."""
    files = {name: folder / f"{name}-{instructions}.json" for name in benchmarks}
    return {name: load(benchmarks[name], path) for name, path in files.items() if path.is_file()}


def _head(benchmark: Benchmark, result: Result) -> dict[str, Any]:
    return {
        "command": f"bench {benchmark.name}",
        "machine": asdict(result.machine),
        "settings": result.settings,
        "seed": SEED,
    }


def _table(names: list[str], rows: list[Any]) -> str:
    shown = names if rows else []
    lines = [json.dumps([_short(getattr(row, name)) for name in shown], ensure_ascii=False) for row in rows]
    return f'{{"columns": {json.dumps(shown)},\n "rows": [\n' + ",\n".join(f"  {line}" for line in lines) + "]}"


def _short(value: Any) -> Any:
    if isinstance(value, float):
        return float(f"{value:.4g}")
    if is_dataclass(value):
        return [_short(getattr(value, f.name)) for f in fields(value)]
    return {key: _short(v) for key, v in value.items()} if isinstance(value, dict) else value


def _row(kind: type, values: list[Any], names: list[str]) -> Any:
    types = get_type_hints(kind)
    return kind(**{name: _value(types[name], value) for name, value in zip(names, values, strict=True)})


def _value(kind: Any, value: Any) -> Any:
    """A list where a `Spread` is wanted becomes one; all else is as JSON has it."""
    return Spread(*value) if Spread in (kind, *get_args(kind)) and value is not None else value
