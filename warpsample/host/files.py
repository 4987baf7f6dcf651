"""Writes files: refused before any work if they cannot be written, then complete or absent, and nothing is left behind.

Reads arrays of them, and takes no memory that a damaged header declares and the file does not hold.

Libraries get one of our streams instead of a path, or write into memory: some (VTK) crash on a full disk, others (VTK's PLY
writer) do not check whether their bytes were written.
"""

import os
import platform
import re
import secrets
import stat
import zipfile
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from functools import partial
from glob import escape
from io import BufferedWriter, FileIO
from math import prod
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np

from warpsample.host.interrupts import uninterrupted

try:
    import fcntl
except ModuleNotFoundError:  # Windows, where an open file cannot be removed
    fcntl = None  # type: ignore[assignment]

_BUFFER = 1 << 20
_DEFLATED = 1032  # bytes that one byte of a .zip stands for, at most
_HEADERS = {(1, 0): np.lib.format.read_array_header_1_0, (2, 0): np.lib.format.read_array_header_2_0}
_OUR_PARTS = re.compile(r"\d+\.[0-9a-f]{8}\.part")  # a process and eight random digits; others are a user's own
_LONGEST = 40  # characters of a name within the name of its part: file systems take 255 bytes


class WriteError(OSError):
    """A file could not be written; the previous file is unchanged."""


def check_output(path: Path, argument: str, *inputs: Path | None) -> None:
    """Refuses, by a ValueError, a file that could not be written, before anything is computed; leaves no trace.

    The file may exist, but be neither a folder nor, by another name, one of the inputs that are read; None of these is
    ignored.
    """
    if flaw := _flaw(path, [source for source in inputs if source is not None]):
        raise ValueError(f"{argument}: got {str(path)!r}, {flaw}")


def check_output_folder(folder: Path, argument: str) -> None:
    """Checks the path of a folder for output files, made if need be, as `check_output` does that of a file."""
    if folder.exists() and not folder.is_dir():
        raise ValueError(f"{argument}: got {str(folder)!r}, which is a file, want a folder")
    there = next(parent for parent in (folder.absolute(), *folder.absolute().parents) if parent.exists())
    if flaw := _flaw(there / "file", []):
        raise ValueError(f"{argument}: got {str(folder)!r}, {flaw}")


@contextmanager
def complete_or_absent(path: Path) -> Iterator[BinaryIO]:
    """A stream whose bytes become the file `path` at the end, or are discarded on an error.

    They go to a hidden file beside it, are flushed to disk and replace the old file, whose permissions they keep. If `path`
    is a link, its target is replaced. Remains of killed processes that wrote the same file are removed first. What cannot be
    written is a WriteError.
    """
    with part_of(path, _target(path)) as raw:
        stream = BufferedWriter(raw, _BUFFER)
        yield stream
        to_disk(stream)
        with _told(path):
            if fcntl is None:
                raw.close()  # Windows requires it; elsewhere the lock is needed to the end
            Path(raw.name).replace(_target(path))


def to_disk(stream: Any) -> None:
    """Brings what a stream of `complete_or_absent` holds to the disk, or is a WriteError: only the new name is left to do.

    Of files that belong together each is brought there before the first one replaces its old file.
    """
    stream.flush()
    with _told(stream.raw.path):
        os.fsync(stream.fileno())


def write_bytes(path: Path, content: Any) -> None:
    """`content`, bytes or a buffer, as the file; complete or absent."""
    with complete_or_absent(path) as stream:
        stream.write(content)


class _Archive(zipfile.ZipFile):
    """An .npz file that is only closed when it is complete: to close what an interrupt has left open is an error."""

    __del__ = object.__hash__  # does nothing; of a function of Python's, it would drop what a handler raises there


@contextmanager
def new_archive(stream: BinaryIO, compression: int = zipfile.ZIP_STORED) -> Iterator[zipfile.ZipFile]:
    """An .npz file to add arrays to, complete at the end and useless after an error."""
    archive = _Archive(stream, "w", compression)
    yield archive
    archive.close()


def write_arrays(stream: BinaryIO, arrays: Mapping[str, np.ndarray], compression: int = zipfile.ZIP_STORED) -> None:
    """Writes an .npz file."""
    with new_archive(stream, compression) as archive:
        for name, array in arrays.items():
            write_array(archive, name, array)


def write_array(archive: zipfile.ZipFile, name: str, array: np.ndarray) -> None:
    """Adds an array to an open .npz file."""
    member = archive.open(f"{name}.npy", "w", force_zip64=True)
    try:
        np.lib.format.write_array(member, array, allow_pickle=False)
    finally:
        uninterrupted(member.close)  # half closed, it would complain when it is forgotten


def read_array(path: Path) -> np.ndarray:
    """The array in an .npy file; a ValueError if that is damaged or shorter than it declares. No pickle is loaded."""
    with np.errstate(over="raise"):  # of the size that a damaged header declares
        return np.array(np.lib.format.open_memmap(path, mode="r"))  # by memory map: the file's size is checked first


def read_arrays(path: Path) -> dict[str, np.ndarray]:
    """The arrays in an .npz file, by name. No pickle is loaded.

    A file that cannot hold what its headers declare, or that is damaged, is a ValueError or a BadZipFile.
    """
    if not zipfile.is_zipfile(path):
        raise ValueError("it is no .npz")
    most, found = _DEFLATED * path.stat().st_size, {}
    with zipfile.ZipFile(path) as archive:
        for name in archive.namelist():
            with archive.open(name) as member:
                shape, _, kind = _HEADERS[np.lib.format.read_magic(member)](member)
            declared = prod(shape) * kind.itemsize
            if declared > most:
                raise ValueError(f"its {name} declares {declared:,} bytes, and the file holds {most:,} at most")
            with archive.open(name) as member:
                found[name.removesuffix(".npy")] = np.lib.format.read_array(member, allow_pickle=False)
    return found


class _Part(FileIO):
    """The hidden file that a file is written to; its errors name the file."""

    def __init__(self, part: Path, path: Path) -> None:
        self.path = path
        super().__init__(part, "x")

    def write(self, data: Any) -> int | None:
        """Writes bytes as `FileIO.write` does."""
        with _told(self.path):
            return super().write(data)


@contextmanager
def part_of(path: Path, target: Path) -> Iterator[_Part]:
    """Open an empty hidden file beside `target`, locked while this process lives; remove the file at the end.

    Its errors are WriteErrors that name `path`, the output of the user.
    """
    _remove_orphans(target)
    part = target.with_name(f"{_prefix(target)}{os.getpid()}.{secrets.token_hex(4)}.part")
    opened: list[_Part] = []
    try:  # starts here, because an interrupt may come as soon as the file exists
        uninterrupted(partial(_open, part, path, target, opened))
        yield opened[-1]
    finally:
        uninterrupted(partial(_discard, part, opened))


def _open(part: Path, path: Path, target: Path, opened: list[_Part]) -> None:
    """Make and lock the part, and put it into a list."""
    with _told(path):
        while not part.exists():  # again, if another run took it for an orphan before it was locked
            opened.append(_Part(part, path))
            _lock(opened[-1])
        if mode := _mode(target):
            part.chmod(mode & 0o777)


def _discard(part: Path, opened: list[_Part]) -> None:
    """Close the raw files, so that nothing more is written to a full disk, and remove the part."""
    try:
        for raw in opened:
            raw.close()
    finally:
        with suppress(OSError):
            part.unlink(missing_ok=True)


def _remove_orphans(target: Path) -> None:
    """Removes the parts of `target` that killed processes left: those of this machine that are not locked.

    A lock shows that the process lives, even if its number is used again. Locks of other machines on a shared folder may not
    be visible here, so their parts are left alone; without locks nothing is removed.
    """
    with suppress(OSError):
        prefix = _prefix(target)
        for orphan in target.parent.glob(f"{escape(prefix)}*.part"):
            with suppress(OSError):
                ours = _OUR_PARTS.fullmatch(orphan.name.removeprefix(prefix))
                if ours and orphan.is_file() and not orphan.is_symlink():
                    _remove_if_dead(orphan)


def _remove_if_dead(orphan: Path) -> None:
    if fcntl is None:
        orphan.unlink()
        return
    with orphan.open("r+b") as file:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        orphan.unlink()  # while it is locked, see part_of


def _lock(file: Any) -> None:
    """Locks a file until it is closed or its process ends."""
    if fcntl is not None:
        with suppress(OSError):  # of file systems without locks
            fcntl.flock(file, fcntl.LOCK_EX)


def _prefix(target: Path) -> str:
    """The prefix of the names of the parts of `target` on this machine."""
    return f".{target.name[:_LONGEST]}.{re.sub(r'[^A-Za-z0-9-]', '-', platform.node())[-_LONGEST:]}."


def _target(path: Path) -> Path:
    """The file itself, or the target of a link."""
    return Path(os.path.realpath(path))


def _mode(target: Path) -> int:
    """Kind and permissions of an existing file; 0 if there is none."""
    try:
        return target.stat().st_mode
    except (FileNotFoundError, NotADirectoryError):
        return 0


def _flaw(path: Path, inputs: list[Path]) -> str:
    """Why an output cannot be written; empty if it can."""
    try:
        target = _target(path)
        mode = _mode(target)
        for source in inputs:
            if is_same(target, source):
                return f"which is the input {str(source)!r}, want another file"
        kinds = {
            "which is a folder, want a file": stat.S_ISDIR(mode),
            "whose folder does not exist": not target.parent.is_dir(),
            "which is not an ordinary file": mode and not stat.S_ISREG(mode),
            "which may not be written": mode and not os.access(target, os.W_OK),
        }
        for flaw, found in kinds.items():
            if found:
                return flaw
        with part_of(path, target) as raw:
            raw.close()
            Path(raw.name).unlink(missing_ok=True)  # as `part_of` does: an interrupt can skip one of the two, not both
            return ""
    except OSError as error:
        return f"which cannot be written: {_reason(error)}"


def is_same(target: Path, source: Path) -> bool:
    """Return whether two paths are one existing file, by whatever names."""
    with suppress(OSError):  # one of the two does not exist
        return target.samefile(source)
    return False


@contextmanager
def _told(path: Path) -> Iterator[None]:
    """Turns a system error about a part into an error that names the file."""
    try:
        yield
    except OSError as error:
        if error.errno is None:  # not the system's: a TimeoutError, as handlers of signals raise it for a deadline
            raise
        raise WriteError(f"{path} cannot be written: {_reason(error)}") from error


def _reason(error: OSError) -> str:
    cause = error.__cause__ if isinstance(error, WriteError) else error
    return getattr(cause, "strerror", None) or str(error)
