"""Reading and writing of files; an output file is either complete or absent.

Outputs are checked before any work, and are complete or absent after it. Arrays are read without the memory that a damaged
header declares and the file does not hold.

Other libraries get a stream of this module in place of a path, or write into memory: VTK crashes on a full disk, and its PLY
writer does not check whether the bytes were written.
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
_DEFLATED = 1032  # largest number of bytes that one byte of a .zip unpacks to
_HEADERS = {(1, 0): np.lib.format.read_array_header_1_0, (2, 0): np.lib.format.read_array_header_2_0}
_OUR_PARTS = re.compile(
    r"\d+\.[0-9a-f]{8}\.part"
)  # number of a process and eight random digits; files with other names belong to users
_LONGEST = 40  # characters of a name within the name of its part: file systems take 255 bytes


written: list[Path] = []
"""The output file that was completed last, for the message of a command that a signal ends."""


class WriteError(OSError):
    """Error for a file that cannot be written; the previous file is unchanged."""


def check_output(path: Path, argument: str, *inputs: Path | None) -> None:
    """Raise an error if a file cannot be written, before anything is computed.

    Args:
        path: output file; it may exist.
        argument: name of the argument in the error.
        inputs: files that the run reads; None is ignored.

    Raises:
        ValueError: the file cannot be written, is a folder, or is one of the inputs, perhaps by another name.
    """
    if flaw := _flaw(path, [source for source in inputs if source is not None]):
        raise ValueError(f"{argument}: got {str(path)!r}, {flaw}")


def check_output_folder(folder: Path, argument: str) -> None:
    """Raise an error if files cannot be written to a folder, which need not exist yet.

    Raises:
        ValueError: the folder is a file, or cannot be written.
    """
    if folder.exists() and not folder.is_dir():
        raise ValueError(f"{argument}: got {str(folder)!r}, which is a file, want a folder")
    existing = next(parent for parent in (folder.absolute(), *folder.absolute().parents) if parent.exists())
    if flaw := _flaw(existing / "file", []):
        raise ValueError(f"{argument}: got {str(folder)!r}, {flaw}")


@contextmanager
def complete_or_absent(path: Path) -> Iterator[BinaryIO]:
    """Open a file for writing within a `with` statement; it appears at `path` only when it is complete.

    The bytes go to a hidden file in the same folder, are flushed to the disk, and replace the old file, whose permissions
    they keep. If `path` is a link, its target is replaced. Hidden files that killed processes left for the same output are
    removed first.

    Raises:
        WriteError: the file cannot be written.
    """
    with part_of(path, _target(path)) as raw:
        stream = BufferedWriter(raw, _BUFFER)
        yield stream
        to_disk(stream)
        with _naming_output(path):
            if fcntl is None:
                raw.close()  # Windows requires it; elsewhere the lock is needed to the end
            Path(raw.name).replace(_target(path))
            written[:] = [path]


def to_disk(stream: Any) -> None:
    """Flush a file of `complete_or_absent` to the disk, so that only renaming is left to do.

    Call it for each of several files that belong together, before the first of the files replaces its old file.

    Raises:
        WriteError: the bytes cannot be written.
    """
    stream.flush()
    with _naming_output(stream.raw.path):
        os.fsync(stream.fileno())


def write_bytes(path: Path, content: Any) -> None:
    """Write bytes or a buffer as the file `path`, complete or absent; raise a WriteError if that fails."""
    with complete_or_absent(path) as stream:
        stream.write(content)


class _Archive(zipfile.ZipFile):
    """Zip writer for .npz files that reports an incomplete file as an error."""

    __del__ = object.__hash__  # does nothing; a Python function would drop an exception that a signal handler raises there


@contextmanager
def new_archive(stream: BinaryIO, compression: int = zipfile.ZIP_STORED) -> Iterator[zipfile.ZipFile]:
    """Open a new .npz file within a `with` statement, to which arrays can be added."""
    archive = _Archive(stream, "w", compression)
    yield archive
    archive.close()


def write_arrays(stream: BinaryIO, arrays: Mapping[str, np.ndarray], compression: int = zipfile.ZIP_STORED) -> None:
    """Write a dictionary of arrays as an .npz file."""
    with new_archive(stream, compression) as archive:
        for name, array in arrays.items():
            write_array(archive, name, array)


def write_array(archive: zipfile.ZipFile, name: str, array: np.ndarray) -> None:
    """Write an array into an open .npz file."""
    member = archive.open(f"{name}.npy", "w", force_zip64=True)
    try:
        np.lib.format.write_array(member, array, allow_pickle=False)
    finally:
        uninterrupted(member.close)  # half closed, it would print an error when Python deletes it


def read_array(path: Path) -> np.ndarray:
    """Return the array in an .npy file; pickled objects are refused.

    Raises:
        ValueError: the file is damaged, or shorter than its header declares.
    """
    with np.errstate(over="raise"):  # a damaged header may declare a size that overflows
        return np.array(np.lib.format.open_memmap(path, mode="r"))  # by memory map: the file's size is checked first


def read_arrays(path: Path) -> dict[str, np.ndarray]:
    """Return the arrays in an .npz file as a dictionary; pickled objects are refused.

    Raises:
        ValueError, BadZipFile: the file is damaged, or too short for the arrays that its headers declare.
    """
    if not zipfile.is_zipfile(path):
        raise ValueError("the file is not an .npz file")
    most, arrays = _DEFLATED * path.stat().st_size, {}
    with zipfile.ZipFile(path) as archive:
        for name in archive.namelist():
            with archive.open(name) as member:
                shape, _, kind = _HEADERS[np.lib.format.read_magic(member)](member)
            declared = prod(shape) * kind.itemsize
            if declared > most:
                raise ValueError(f"the header of {name} declares {declared:,} bytes, but the file can hold at most {most:,}")
            with archive.open(name) as member:
                arrays[name.removesuffix(".npy")] = np.lib.format.read_array(member, allow_pickle=False)
    return arrays


class _Part(FileIO):
    """Hidden file that becomes an output at the end. Errors name the output."""

    def __init__(self, part: Path, path: Path) -> None:
        self.path = path
        super().__init__(part, "x")

    def write(self, data: Any) -> int | None:
        """Write bytes to the hidden file that later replaces the output file; return the number of bytes."""
        with _naming_output(self.path):
            return super().write(data)


@contextmanager
def part_of(path: Path, target: Path) -> Iterator[_Part]:
    """Open a hidden temporary file in the folder of `target` within a `with` statement; remove it at the end.

    Raises:
        WriteError: the hidden file cannot be written; names `path`, the output of the user.
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
    """Create and lock the hidden temporary file `part`, and append the open file to the list `opened`."""
    with _naming_output(path):
        while not part.exists():  # again, if another run took it for an orphan before it was locked
            opened.append(_Part(part, path))
            _lock(opened[-1])
        if mode := _mode(target):
            part.chmod(mode & 0o777)


def _discard(part: Path, opened: list[_Part]) -> None:
    """Close the open files and remove the hidden temporary file `part`."""
    try:
        for raw in opened:
            raw.close()
    finally:
        with suppress(OSError):
            part.unlink(missing_ok=True)


def _remove_orphans(target: Path) -> None:
    """Remove hidden temporary files of `target` that killed processes have left behind.

    A locked file belongs to a living process, even if the number of the process is used again. Files of other machines in a
    shared folder stay, since their locks may not be visible here. Without locks in the file system, all files stay.
    """
    with suppress(OSError):
        prefix = _prefix(target)
        for orphan in target.parent.glob(f"{escape(prefix)}*.part"):
            with suppress(OSError):
                ours = _OUR_PARTS.fullmatch(orphan.name.removeprefix(prefix))
                if ours and orphan.is_file() and not orphan.is_symlink():
                    _remove_if_dead(orphan)


def _remove_if_dead(orphan: Path) -> None:
    """Remove a hidden temporary file, unless a running process has locked it (then raise an OSError)."""
    if fcntl is None:
        orphan.unlink()
        return
    with orphan.open("r+b") as file:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        orphan.unlink()  # while this process holds the lock, see _open


def _lock(file: Any) -> None:
    """Lock an open file until it is closed or this process ends."""
    if fcntl is not None:
        with suppress(OSError):  # the file system has no locks
            fcntl.flock(file, fcntl.LOCK_EX)


def _prefix(target: Path) -> str:
    """Return the beginning of the names of hidden temporary files for the output `target`."""
    return f".{target.name[:_LONGEST]}.{re.sub(r'[^A-Za-z0-9-]', '-', platform.node())[-_LONGEST:]}."


def _target(path: Path) -> Path:
    """Return the path of a file, with a symbolic link resolved."""
    return Path(os.path.realpath(path))


def _mode(target: Path) -> int:
    """Return the type and permission bits of a file; 0 for a missing file."""
    try:
        return target.stat().st_mode
    except (FileNotFoundError, NotADirectoryError):
        return 0


def _flaw(path: Path, inputs: list[Path]) -> str:
    """Return why a file cannot be written, for example because it is also an input; "" if it can."""
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
    """Return whether two paths lead to the same file, which need not exist yet."""
    with suppress(OSError):  # one of the two does not exist
        return target.samefile(source)
    return os.path.realpath(target) == os.path.realpath(source)


@contextmanager
def _naming_output(path: Path) -> Iterator[None]:
    """Convert a system error within a `with` statement to a WriteError that names the file `path`."""
    try:
        yield
    except OSError as error:
        if error.errno is None:  # not of the system: a TimeoutError that a signal handler raises for a deadline
            raise
        raise WriteError(f"{path} cannot be written: {_reason(error)}") from error


def _reason(error: OSError) -> str:
    """Return the operating system's message for an error."""
    cause = error.__cause__ if isinstance(error, WriteError) else error
    return getattr(cause, "strerror", None) or str(error)
