"""State of the mesh files of a command, to find out whether they change while the command reads them several times."""

from dataclasses import dataclass
from pathlib import Path

from warpsample.host.arguments import is_file
from warpsample.mesh.files.linked_files import list_linked_files

_IN_SEVERAL_FILES = (".glb", ".gltf", ".usd", ".usda", ".usdc")  # formats whose meshes may be in other files
_PICTURES = (".png", ".jpg", ".jpeg", ".webp", ".ktx2")  # no results depend on them


@dataclass(frozen=True)
class InputState:
    """Sizes and times of mesh files, and of the buffers and layers that they refer to.

    Attributes:
        paths: Paths of the mesh files.
        states: File, size in bytes, time of change in ns and number in the file system, for each file.
    """

    paths: tuple[Path, ...]
    states: tuple[tuple[Path, int, int, int], ...]

    @classmethod
    def of(cls, *paths: Path | None) -> "InputState":
        """Return the present state of mesh files and of the files with their data; None is ignored."""
        given = tuple(path for path in paths if path is not None)
        return cls(given, tuple(_read_state(file) for path in given for file in (path, *_list_data_files(path))))

    def check(self) -> None:
        """Raise a ValueError if a file has changed since this state was recorded."""
        if any(_read_state(state[0]) != state for state in self.states):
            names = " and ".join(repr(str(path)) for path in self.paths)
            raise ValueError(f"mesh: got {names}, changed since the run began, want files that stay the same until its end")


def _list_data_files(path: Path) -> list[Path]:
    """Return the buffers that a glTF file names, or the layers of a USD file."""
    if path.suffix.lower() not in _IN_SEVERAL_FILES:
        return []
    return [file for file in list_linked_files(path) if file.suffix.lower() not in _PICTURES]


def _read_state(path: Path) -> tuple[Path, int, int, int]:
    """Return the state of a file; zeros for a missing file and for a pipe, which can be read only once."""
    if not is_file(path):
        return path, 0, 0, 0
    found = path.stat()
    return path, found.st_size, found.st_mtime_ns, found.st_ino
