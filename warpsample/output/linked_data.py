"""Writing of two files that belong together: a text file, such as a .gltf, and the data file that it names, its .bin.

The user names only the first file, so the data never replace a file of another owner. Whatever ends the work, the old pair
or the new pair is complete: the data are on the disk under a free name before the first file names them.
"""

import os
import re
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager, suppress
from functools import partial
from io import BufferedWriter
from itertools import count
from pathlib import Path
from stat import S_IMODE
from time import sleep
from typing import BinaryIO

from warpsample.host.files import WriteError, is_same, part_of, to_disk, write_bytes
from warpsample.host.interrupts import uninterrupted

try:
    import fcntl
except ModuleNotFoundError:  # Windows
    fcntl = None  # type: ignore[assignment]

_BEAT, _PATIENCE = 0.01, 60.0  # seconds between two tries to lock a folder, and in all; a run holds the lock for moments


def check_linked_data(path: Path, suffix: str, argument: str) -> None:
    """Raise a ValueError if no data file (for example a .bin) can be created in the folder of an output file.

    For a link, the folder is that of the link's target.

    Raises:
        ValueError: the folder cannot be written; names the argument.
    """
    target = Path(os.path.realpath(path))
    try:
        with part_of(path, target.with_suffix(suffix)):
            pass
    except WriteError as error:
        raise ValueError(f"{argument}: got {str(path)!r}, next to which no {suffix} can be written: {error}") from None


def write_with_data(
    path: Path,
    suffix: str,
    *,
    write_data: Callable[[BinaryIO], None],
    text_naming: Callable[[str], bytes],
    named_by: Callable[[Path], Iterable[Path]],
    inputs: Iterable[Path] = (),
) -> Path:
    """Write an output file and the data file that it names, for example a .gltf and its .bin; return the latter's path.

    The data keep the name that the old file at `path` gives them, if it names NAME.bin or NAME-1.bin and the like beside it.
    Else they get the first free name of these. If `path` is a link, its target is written, and the data are next to the
    target. Two runs that write the same path do so one after the other, where the file
    system has locks.

    Args:
        path: the file that the user named, as out.gltf.
        suffix: of the data, as ".bin".
        write_data: writes the data into a stream.
        text_naming: returns the content of `path` for a name of the data.
        named_by: returns the files that a file names; none for a file that cannot be read.
        inputs: files that keep their content, even if the old file names them. Files that another file in the same folder
            names keep their content, too.

    Raises:
        WriteError: the files cannot be written; the old ones are unchanged.
    """
    path = Path(os.path.realpath(path))
    with part_of(path, path.with_suffix(suffix)) as raw:
        stream = BufferedWriter(raw)
        write_data(stream)
        to_disk(stream)
        if fcntl is None:
            raw.close()  # Windows renames no open file
        find_old = partial(_old_data, path, suffix, named_by, inputs)
        return uninterrupted(partial(_publish, Path(raw.name), path, suffix, text_naming, find_old))


def _publish(
    part: Path, path: Path, suffix: str, text_naming: Callable[[str], bytes], find_old: Callable[[], Path | None]
) -> Path:
    """Move the finished data file to its final name and write the file that names it; return the data file's path."""
    with _alone_in(path):
        return _write_pair(part, path, suffix, text_naming, find_old())


def _write_pair(part: Path, path: Path, suffix: str, text_naming: Callable[[str], bytes], old: Path | None) -> Path:
    """Move the data file to a free name, then write the output file that refers to it; return the data file's path."""
    data = _new_file(path, suffix)
    try:
        part.chmod(S_IMODE((old or data).stat().st_mode))
        part.replace(data)
        write_bytes(path, text_naming(data.name))
    except BaseException as error:
        with suppress(OSError):
            data.unlink()
        if isinstance(error, OSError) and not isinstance(error, WriteError):
            raise WriteError(f"{path} cannot be written: {error.strerror or error}") from error
        raise
    return data if old is None else _take_name(data, old, path, text_naming)


def _take_name(data: Path, old: Path, path: Path, text_naming: Callable[[str], bytes]) -> Path:
    """Rename the new data file to the name of the data file that it replaces; return the final path.

    The data have both names until the file at `path` names the second one. Without hard links they keep the first.
    """
    try:
        old.unlink()
        os.link(data, old)  # an error if another program has taken the name
    except OSError:
        return data
    kept, left = old, data
    try:
        write_bytes(path, text_naming(old.name))
    except OSError:
        kept, left = data, old
    with suppress(OSError):
        left.unlink()
    return kept


def _new_file(path: Path, suffix: str) -> Path:
    """Create an empty data file under the first free name next to `path`, and return its path."""
    for number in count():
        made = path.with_name(f"{path.stem}-{number}{suffix}") if number else path.with_suffix(suffix)
        try:
            made.open("xb").close()
        except FileExistsError:  # a link without a target and a folder are files here, and so is OUT.BIN on some systems
            continue
        except OSError as error:
            raise WriteError(f"{path} cannot be written: {error.strerror or error}") from error
        return made
    raise AssertionError("unreachable")


def _old_data(path: Path, suffix: str, named_by: Callable[[Path], Iterable[Path]], inputs: Iterable[Path]) -> Path | None:
    """Return the data file named by the existing file at `path` if it may be overwritten, else None."""
    ours, kept = re.compile(rf"{re.escape(path.stem)}(-\d+)?{re.escape(suffix)}"), list(inputs)
    for file in named_by(path):
        is_ours = file.parent == path.parent and ours.fullmatch(file.name) and file.is_file()
        with suppress(OSError):  # a folder that cannot be listed may hold another file that names the data
            if is_ours and not any(is_same(file, source) for source in (*kept, *_named_by_siblings(path, named_by))):
                return file
    return None


def _named_by_siblings(path: Path, named_by: Callable[[Path], Iterable[Path]]) -> Iterator[Path]:
    """Yield the data files named by the other files in the folder of `path`."""
    for sibling in path.absolute().parent.iterdir():
        if os.path.realpath(sibling) != os.path.realpath(path):
            yield from named_by(sibling)


@contextmanager
def _alone_in(path: Path) -> Iterator[None]:
    """Lock the folder of `path` within a `with` statement, so that only one process at a time writes there."""
    opened = None
    try:
        with suppress(OSError):  # a folder that cannot be listed
            opened = None if fcntl is None else os.open(path.parent, os.O_RDONLY)
        if opened is not None:
            _wait_for(opened, path)
        yield
    finally:
        if opened is not None:
            os.close(opened)


@contextmanager
def locked_folder(folder: Path) -> Iterator[None]:
    """Lock a folder within a `with` statement, without waiting; the operating system releases the lock of a killed process.

    Raises:
        WriteError: another process has locked the folder, or the folder cannot be opened.
    """
    if fcntl is None:  # Windows opens no folders
        yield
        return
    try:
        opened = os.open(folder, os.O_RDONLY)
    except OSError as error:
        raise WriteError(f"{folder} cannot be written: {error.strerror or error}") from error
    try:
        if not _is_locked(opened):
            raise WriteError(f"{folder} cannot be written: another process is writing it")
        yield
    finally:
        os.close(opened)


def _wait_for(opened: int, path: Path) -> None:
    """Lock an open folder; raise a WriteError if that takes too long, since no interrupt is heard here."""
    for _ in range(int(_PATIENCE / _BEAT)):
        if _is_locked(opened):
            return
        sleep(_BEAT)
    raise WriteError(f"{path} cannot be written: another process has locked its folder")


def _is_locked(opened: int) -> bool:
    """Lock an open folder if no other run has locked it; True also where the file system has no locks."""
    with suppress(OSError):
        try:
            fcntl.flock(opened, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            return False
    return True
