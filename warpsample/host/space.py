"""Whether a disk has room for what is to be written."""

import shutil
from pathlib import Path

from warpsample.host.files import WriteError

_UNITS = (("TB", 12), ("GB", 9), ("MB", 6), ("kB", 3))


def check_space(path: Path, needed: int, what: str) -> None:
    """Refuses what there is no space for, before it is computed.

    Raises:
        WriteError: says how much it takes, and how much is free.
    """
    folder = path.resolve().parent
    free = shutil.disk_usage(next(parent for parent in (folder, *folder.parents) if parent.exists())).free
    if needed > free:
        raise WriteError(f"{path} cannot be written: {what} take {_told(needed)}, and {_told(free)} are free")


def _told(count: int) -> str:
    """Bytes in the unit that shows digits."""
    unit, power = next(((unit, power) for unit, power in _UNITS if count >= 10**power), ("bytes", 0))
    return f"{count / 10**power:,.3f} {unit}" if power else f"{count} {unit}"
