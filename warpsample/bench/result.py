"""What a benchmark has found, with the machine and the settings; and its files.

`bench --json` writes everything, every repeat included. The files of `results/`, from which the README is made, hold medians
and quartiles to four digits, a line for each row: one file for each benchmark and kind of processor.
"""

import json
from dataclasses import asdict, dataclass, fields, is_dataclass
from pathlib import Path
from typing import Any, get_args, get_type_hints

from warpsample.bench.machine import Machine
from warpsample.bench.record import SEED, Benchmark
from warpsample.bench.timing import Spread
from warpsample.host.files import write_bytes

RESULTS = Path(__file__).parent / "results"


@dataclass(frozen=True)
class Result:
    """Of one run of a benchmark.

    Attributes:
        machine: where.
        settings: the benchmark's `settings`.
        found: the benchmark's `found`.
    """

    machine: Machine
    settings: Any
    found: Any


def save_everything(path: Path, benchmark: Benchmark, result: Result) -> None:
    """Writes machine, settings and every row with all its repeats; complete or not at all."""
    head = _head(benchmark, result)
    write_bytes(path, json.dumps({**head, **asdict(result.found)}, indent=1).encode())


def keep(benchmark: Benchmark, result: Result, folder: Path = RESULTS) -> Path:
    """Writes the file of this benchmark and processor that the README is made from; returns it."""
    path = folder / f"{benchmark.name}-{result.machine.instructions}.json"
    parts = {key: json.dumps(value, ensure_ascii=False) for key, value in _head(benchmark, result).items()}
    for part in fields(result.found):
        parts[part.name] = _table(getattr(result.found, part.name))
    text = ",\n".join(f'"{key}": {value}' for key, value in parts.items())
    write_bytes(path, f"{{{text}}}\n".encode())
    return path


def load(benchmark: Benchmark, path: Path) -> Result:
    """What `keep` wrote, without the repeats.

    Raises:
        ValueError: the file is damaged, or of another version; names it.
    """
    types = get_type_hints(benchmark.found)
    try:
        content = json.loads(path.read_text(encoding="utf-8"))
        parts = {name: [_row(get_args(kind)[0], row, content[name]["columns"]) for row in content[name]["rows"]]
                 for name, kind in types.items()}  # fmt: skip
        return Result(Machine(**content["machine"]), benchmark.settings(**content["settings"]), benchmark.found(**parts))
    except (KeyError, TypeError, ValueError) as error:
        told = f"{type(error).__name__} {error}"
        raise ValueError(f"{path}: got {told}, want results as `warpsample bench all --write` keeps them") from error


def kept(instructions: str, benchmarks: dict[str, Benchmark], folder: Path = RESULTS) -> dict[str, Result]:
    """By the name of the benchmark, what `folder` holds of a kind of processor."""
    files = {name: folder / f"{name}-{instructions}.json" for name in benchmarks}
    return {name: load(benchmarks[name], path) for name, path in files.items() if path.is_file()}


def _head(benchmark: Benchmark, result: Result) -> dict[str, Any]:
    settings = asdict(result.settings)
    return {"command": f"bench {benchmark.name}", "machine": asdict(result.machine), "settings": settings, "seed": SEED}


def _table(rows: list[Any]) -> str:
    # Lists are repeats, which these files do without.
    columns = [f.name for f in fields(rows[0]) if not isinstance(getattr(rows[0], f.name), list)] if rows else []
    lines = [json.dumps([_short(getattr(row, name)) for name in columns], ensure_ascii=False) for row in rows]
    return f'{{"columns": {json.dumps(columns)},\n "rows": [\n' + ",\n".join(f"  {line}" for line in lines) + "]}"


def _short(value: Any) -> Any:
    if isinstance(value, float):
        return float(f"{value:.4g}")
    if is_dataclass(value):
        return [_short(getattr(value, f.name)) for f in fields(value)]
    return {key: _short(v) for key, v in value.items()} if isinstance(value, dict) else value


def _row(kind: type, values: list[Any], columns: list[str]) -> Any:
    types = get_type_hints(kind)
    return kind(**{name: _value(types[name], value) for name, value in zip(columns, values, strict=True)})


def _value(kind: Any, value: Any) -> Any:
    """A list where a `Spread` is wanted becomes one; all else is as JSON has it."""
    return Spread(*value) if Spread in (kind, *get_args(kind)) and value is not None else value
