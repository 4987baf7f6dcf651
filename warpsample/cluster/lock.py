"""Lock of a store: a file next to the store, which one process can lock at a time."""

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
    """Lock a Zarr store within a `with` statement, so that no other process writes the store.

    The operating system releases the lock if the process is killed.

    Raises:
        WriteError: if another process is writing the store, or the lock file cannot be opened.
    """
    file, held = path.with_name(lock_name(path)), []
    try:
        uninterrupted(partial(_acquire, path, file, held))
        yield
    finally:
        uninterrupted(partial(_release, file, held))


def lock_name(path: Path) -> str:
    """Return the name of the lock file of a store."""
    return f".{path.name}.lock"


def _acquire(path: Path, file: Path, held: list[Any]) -> None:
    """Lock a store by opening and locking its lock file; the open file is appended to the list `held`.

    Args:
        path: Path of the store, for error messages.
        file: Path of the lock file.
        held: List to append to, so that an interrupt does not lose the open file.

    Raises:
        WriteError: as for `locked`.
    """
    while True:  # again, if the previous owner removed the file in between
        try:
            opened = os.fdopen(_open_regular_file(file), "a")
        except OSError as error:
            raise WriteError(
                f"{path} cannot be written: its lock file {file.name} cannot be opened: {error.strerror}"
            ) from error
        if not _lock(opened):
            opened.close()
            raise WriteError(f"{path} cannot be written: another process is writing it")
        with suppress(FileNotFoundError):
            if file.stat().st_ino == os.fstat(opened.fileno()).st_ino:
                held.append(opened)
                return
        opened.close()


def _open_regular_file(file: Path) -> int:
    """Open or create a regular file for appending, and return its file descriptor.

    Links are not followed, and a pipe does not block.

    Raises:
        OSError: if the path is not a regular file, or cannot be opened.
    """
    flags = os.O_CREAT | os.O_APPEND | os.O_WRONLY
    opened = os.open(file, flags | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0), 0o666)
    if not stat.S_ISREG(os.fstat(opened).st_mode):
        os.close(opened)
        raise OSError(errno.EINVAL, "not an ordinary file")
    return opened


def _release(file: Path, held: list[Any]) -> None:
    """Close the open lock files, and delete the lock file if it is empty; a file with content belongs to the user."""
    for opened in held:
        if os.fstat(opened.fileno()).st_size == 0:
            file.unlink(missing_ok=True)
        opened.close()


def _lock(file: Any) -> bool:
    """Lock an open file without waiting; return False if another process holds the lock."""
    if fcntl is not None:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            return False
        except OSError:  # file systems without locks
            pass
    return True
