"""Folder of the tiles of a raster, one .npz file per tile, next to an output that is not complete yet."""

import json
import os
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any
from zipfile import BadZipFile

import numpy as np

from warpsample.city.rasters.tiles import RasterRun
from warpsample.host.arguments import quote
from warpsample.host.engine import check_space
from warpsample.host.files import WriteError, complete_or_absent, read_arrays, write_arrays, write_bytes
from warpsample.host.interrupts import uninterrupted
from warpsample.host.shared_values import describe_remedy
from warpsample.output.rasters.bake import WORK, Tiles, summarize_tile
from warpsample.output.rasters.job import RasterJob, read_unchanging

try:
    import fcntl
except ModuleNotFoundError:  # Windows
    fcntl = None  # type: ignore[assignment]

ABOUT, DIGESTS = "about.json", "digests.npz"
"""Files with the attributes of the run, and with the digests of the blocks of its input rasters."""

_TILE = "tile-{}.npz"
_INDEX = "index"  # of a tile, in its file


class TileFiles:
    """Storage of computed raster tiles as .npz files, in the hidden folder `.NAME.tiles` next to the output NAME.

    Attributes:
        path: Path of the folder.
        resume: Whether to continue an existing folder.
    """

    def __init__(self, output: Path, resume: bool) -> None:
        """Set the output file, next to which the hidden folder of tiles is created."""
        self.path: Path = output.absolute().with_name(f".{output.name}.tiles")
        self.resume = resume

    @contextmanager
    def locked(self) -> Iterator[None]:
        """Create and lock the folder of tiles within a `with` statement; remove the folder at the end if it is empty.

        Raises:
            ValueError: the folder exists and is not to be resumed, or holds other files or links, or is a file or a link.
            WriteError: another process is writing the tiles, or the folder cannot be created.
        """
        is_link = self.path.is_symlink()
        if is_link or (self.path.exists() and not self.path.is_dir()):
            raise ValueError(
                f"--output: got {str(self.path)!r}, which is a {'link' if is_link else 'file'}, want another output name, "
                "because a folder of this name holds the tiles of the run"
            )
        try:
            with suppress(FileExistsError):
                self.path.mkdir()
        except OSError as error:
            raise WriteError(f"{self.path} cannot be written: {error.strerror or error}") from error
        with _locked(self.path):
            self._check_folder()
            yield

    def _check_folder(self) -> None:
        """Raise a ValueError if the folder has other files, or has tiles and `--resume` is not given."""
        files = list(self.path.iterdir())
        if any(file.is_symlink() for file in files):  # what is written to them would replace other files
            raise ValueError(f"--output: got {str(self.path)!r}, which holds links, want another output name")
        if files and not (self.path / ABOUT).is_file():
            raise ValueError(f"--output: got {str(self.path)!r}, which holds other files, want another output name")
        if files and not self.resume:
            raise ValueError(
                f"--output: got {str(self.path)!r}, which exists already, want a new name, or --resume to continue the run"
            )

    def begin(self, run: RasterRun, about: dict[str, Any]) -> np.ndarray:
        """Start or resume a computation in the folder; return the (tiles,) bool mask of tiles that are complete.

        Raises:
            ValueError: the folder is of another run; the message names the difference.
            WriteError: the folder cannot be written, or the disk has too little space.
        """
        about = json.loads(json.dumps(about))
        if (self.path / ABOUT).exists():
            kept = self.about()
            for name in dict.fromkeys((*about, *kept)):
                if kept.get(name) != about.get(name):
                    was, now = quote(kept.get(name)), quote(about.get(name))
                    raise ValueError(
                        f"--output: got {str(self.path)!r} of {name} {was}, want tiles of {name} {now}; "
                        + describe_remedy(name)
                    )
        whole = np.array([self._is_whole(index, run) for index in range(run.grid[0] * run.grid[1])])
        cells = run.reader.shape[0] * run.reader.shape[1]
        check_space(self.path, int(cells * (1.0 - whole.mean())) * 4 * len(run.names), f"{cells:,} cells")
        write_bytes(self.path / ABOUT, json.dumps(about).encode())
        return whole

    def _is_whole(self, index: int, run: RasterRun) -> bool:
        """Return whether the .npz file of a tile can be read, and holds the number of the tile and all result arrays."""
        try:
            arrays = read_arrays(self._file(index)) if self._file(index).is_file() else {}
            return set(arrays) == {*run.names, _INDEX} and arrays[_INDEX] == index
        except (OSError, ValueError, KeyError, EOFError, BadZipFile):
            return False

    def _file(self, index: int) -> Path:
        """Return the path of the .npz file of a tile."""
        return tile_file(self.path, index)

    def compute(self, job: RasterJob, digests: Mapping[str, np.ndarray], tiles: list[int]) -> Iterator[np.void]:
        """Compute the tiles one after the other, write each to a file, and yield counts and sums of its values."""
        write_digests(self.path, digests)
        own = read_unchanging(job, self.about(), self.path, digests)
        spans = list(own.spans())
        for index in tiles:
            arrays = own.numbers(spans[index])
            write_tile_file(self.path, index, own, arrays)
            yield summarize_tile(arrays)

    def tiles(self, run: RasterRun) -> Tiles:
        """Yield the range of rows and columns and the arrays of each tile, after all have been computed."""
        for index, span in enumerate(run.spans()):
            arrays = read_arrays(self._file(index))
            yield span, {name: arrays[name] for name in run.names}

    def about(self) -> dict[str, Any]:
        """Return the attributes stored in the folder, which identify the computation."""
        return read_about(self.path)

    def remove(self) -> None:
        """Remove the hidden folder with all tiles, but keep other files; what a killed process leaves can be resumed."""
        uninterrupted(self._remove)

    def _remove(self) -> None:
        """Remove the files of the run, and its attributes last: without them its files would be those of a user."""
        for pattern in (f"{WORK}/plain.tif", f"{WORK}/cog.tif", f"{WORK}/*.tif.aux.xml", f"{WORK}/*.tif.*.tmp"):
            for path in list(self.path.glob(pattern)):
                path.unlink()
        _remove_if_empty(self.path / WORK)
        tiles = [path for path in self.path.glob(_TILE.format("*")) if path.stem.rpartition("-")[2].isdecimal()]
        for path in (*tiles, *(one for name in (DIGESTS, ABOUT) if (one := self.path / name).exists())):
            path.unlink()
        _remove_if_empty(self.path)


def tile_file(folder: Path, index: int) -> Path:
    """Return the path of the .npz file of a tile in a folder of tiles."""
    return folder / _TILE.format(index)


def read_about(folder: Path) -> dict[str, Any]:
    """Read the attributes stored in a folder of tiles, which identify the computation.

    Raises:
        ValueError: the file of the attributes is damaged.
    """
    try:
        found = json.loads((folder / ABOUT).read_bytes())
    except ValueError:
        found = None
    if not isinstance(found, dict):
        raise ValueError(f"--output: got {str(folder)!r}, whose {ABOUT} is damaged, want another output name")
    return found


def write_digests(folder: Path, digests: Mapping[str, np.ndarray]) -> None:
    """Write the hashes of the input rasters' blocks into a folder of tiles."""
    with complete_or_absent(folder / DIGESTS) as stream:
        write_arrays(stream, digests)


def write_tile_file(folder: Path, index: int, run: RasterRun, arrays: Mapping[str, np.ndarray]) -> None:
    """Write the arrays of one tile to an .npz file in a folder; other processes never see a partly written file."""
    with complete_or_absent(tile_file(folder, index)) as stream:
        write_arrays(stream, {_INDEX: np.array(index), **{name: arrays[name] for name in run.names}})


@contextmanager
def _locked(folder: Path) -> Iterator[None]:
    """Lock a folder within a `with` statement, without waiting; remove the folder at the end if it is empty.

    The operating system releases the lock of a killed process. Only the process with the lock removes the folder.

    Raises:
        WriteError: another process has locked the folder, or the folder cannot be opened.
    """
    if fcntl is None:  # Windows opens no folders
        try:
            yield
        finally:
            _remove_if_empty(folder)
        return
    try:
        opened = os.open(folder, os.O_RDONLY | os.O_DIRECTORY)
    except FileNotFoundError:  # removed by the process that had the lock
        raise WriteError(f"{folder} cannot be written: another process is writing it") from None
    except OSError as error:
        raise WriteError(f"{folder} cannot be written: {error.strerror or error}") from error
    try:
        if not _is_locked(opened) or not _is_at(folder, opened):
            raise WriteError(f"{folder} cannot be written: another process is writing it")
        try:
            yield
        finally:
            if _is_at(folder, opened):
                _remove_if_empty(folder)
    finally:
        os.close(opened)


def _is_locked(opened: int) -> bool:
    """Lock an open folder if no other run has locked it; True also where the file system has no locks."""
    with suppress(OSError):
        try:
            fcntl.flock(opened, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            return False
    return True


def _is_at(folder: Path, opened: int) -> bool:
    """Return whether an open folder is still at its path; another process may have removed it, and made a new folder."""
    try:
        return os.path.samestat(folder.stat(), os.fstat(opened))
    except FileNotFoundError:
        return False


def _remove_if_empty(folder: Path) -> None:
    """Remove a folder unless it contains files."""
    with suppress(OSError):
        folder.rmdir()
