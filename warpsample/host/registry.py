"""Search for the records of a package: a new module with a `RECORD` adds an entry, without any list of modules."""

import importlib
import pkgutil
from types import ModuleType
from typing import Any

from warpsample.host.arguments import check_choice


def records_of(package: ModuleType) -> dict[str, Any]:
    """Import all modules of a package, and return their `RECORD`s, keyed by the record's name."""
    modules = (importlib.import_module(f"{package.__name__}.{info.name}") for info in pkgutil.iter_modules(package.__path__))
    return {module.RECORD.name: module.RECORD for module in modules if hasattr(module, "RECORD")}


def look_up(known: dict[str, Any], name: str, argument: str) -> Any:
    """Look up a record by name; raise a ValueError that lists all names if there is none."""
    if isinstance(name, str) and name in known:
        return known[name]
    return known[check_choice(name, argument, sorted(known))]
