"""Finds the records of a package: a new file with a record is a new entry, listed nowhere else."""

import importlib
import pkgutil
from types import ModuleType
from typing import Any

from warpsample.host.arguments import check_choice


def records_of(package: ModuleType) -> dict[str, Any]:
    """The `RECORD` of each module of `package` that has one, by its name."""
    modules = (importlib.import_module(f"{package.__name__}.{info.name}") for info in pkgutil.iter_modules(package.__path__))
    return {module.RECORD.name: module.RECORD for module in modules if hasattr(module, "RECORD")}


def look_up(known: dict[str, Any], name: str, argument: str) -> Any:
    """known[name], or the error of `check_choice`, with the names that exist."""
    if isinstance(name, str) and name in known:
        return known[name]
    return known[check_choice(name, argument, sorted(known))]
