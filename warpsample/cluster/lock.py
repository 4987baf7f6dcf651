"""The lock of a store: a file beside it, which one process has at a time."""

import errno
import os
import stat
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from functools import partial
from pathlib import Path
from typing import Any

from warpsample.host.files import WriteError
from warpsample.host.interrupts import uninterrupted

try:
    import fcntl
except ModuleNotFoundError:  # Windows
    fcntl = None  # type: ignore[assignment]


@contextmanager
def locked(path: Path) -> Iterator[None]:
    """Within, this process alone writes the store. The lock, a file beside it, goes with a process that is killed.

    Raises:
        WriteError: another process writes it, or it cannot be written at all.
    """
    file, held = path.with_name(lock_name(path)), []
    try:
        uninterrupted(partial(_take, path, file, held))
        yield
    finally:
        uninterrupted(partial(_give_back, file, held))


def lock_name(path: Path) -> str:
    """The name of the file that is locked for a store."""
    return f".{path.name}.lock"


def _take(path: Path, file: Path, held: list[Any]) -> None:
    """Puts the locked file into a list.

    Raises:
        WriteError: as `locked`.
    """
    while True:  # again, if who had it removed it in between
        try:
            opened = os.fdopen(_ordinary(file), "a")
        except OSError as error:
            raise WriteError(f"{path} cannot be written: its lock {file.name}: {error.strerror}") from error
        if not _lock(opened):
            opened.close()
            raise WriteError(f"{path} cannot be written: another process is writing it")
        with suppress(FileNotFoundError):
            if file.stat().st_ino == os.fstat(opened.fileno()).st_ino:
                held.append(opened)
                return
        opened.close()


def _ordinary(file: Path) -> int:
    """Opens a file to be locked, but follows no link and waits for no one at a pipe's other end.

    Raises:
        OSError: it is no ordinary file, or cannot be opened.
    """
    flags = os.O_CREAT | os.O_APPEND | os.O_WRONLY
    opened = os.open(file, flags | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0), 0o666)
    if not stat.S_ISREG(os.fstat(opened).st_mode):
        os.close(opened)
        raise OSError(errno.EINVAL, "not an ordinary file")
    return opened


def _give_back(file: Path, held: list[Any]) -> None:
    """Removes the lock, which is empty, unlike a file of somebody's that has its name."""
    for opened in held:
        if os.fstat(opened.fileno()).st_size == 0:
            file.unlink(missing_ok=True)
        opened.close()


def _lock(file: Any) -> bool:
    """Whether no other process has locked the file, which this one does now."""
    if fcntl is not None:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            return False
        except OSError:  # of file systems without locks
            pass
    return True
