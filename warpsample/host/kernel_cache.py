"""Start of Warp, and loading of kernels: without output on stdout, and never from damaged files.

LLVM crashes on some damaged files, runs others without a check, and ends the process when the disk is full. So each built
file gets a digest, which is checked before the file is loaded. Modules of users are loaded by Warp alone.
"""

import atexit
import os
import shutil
import tempfile
import warnings
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager, suppress
from functools import partial
from hashlib import sha256
from pathlib import Path
from time import perf_counter
from typing import BinaryIO

import warp as wp

from warpsample.host.locks import once
from warpsample.host.progress import awaited, log

WIDE_VECTORS = "-mprefer-vector-width=512"
"""Compiler flag for vectors of 512 bits, which make the loops of kernels 1.1 to 1.6 times as fast on Intel processors with
AVX-512. The compiler prefers 256 bits there by default; on other processors the flag has no effect."""

_MARK = ".sha256"  # suffix of the file with the digest of another file
_SOURCES = (".cpp", ".cu")  # kept by Warp for reading only
_SPACE = 1 << 20  # bytes; twice what the largest module takes
_NO_DRIVER = b"Warp CUDA warning: Could not find or load the NVIDIA CUDA driver"


@once
def start() -> None:
    """Initialise Warp once per process; if its cache folder cannot be written, use a temporary one and warn."""
    with _quiet(wp.LOG_ERROR):
        try:
            _without_driver_warning(wp.init)
        except OSError as error:
            folder = wp.config.kernel_cache_dir = tempfile.mkdtemp(prefix="warpsample-")
            atexit.register(shutil.rmtree, folder, ignore_errors=True)
            _without_driver_warning(wp.init)
            _say_unwritable(str(error.filename), str(error.strerror))


@once
def load(kernel: wp.Kernel, device: str) -> None:
    """Load the compiled code of a kernel from the cache, or compile it if the cache has none or a damaged copy.

    A warning reports a damaged or unwritable cache.

    Raises:
        RuntimeError: no folder can be written, or a module that was just built cannot be loaded; names the folder.
    """
    start()
    if device == "cpu":
        _ask_for_wide_vectors(kernel.module)
    block = 1 if device == "cpu" else 256  # the choice of wp.launch
    load_module = partial(wp.load_module, kernel.module, device, block_dim=block)
    entry = Path(wp.config.kernel_cache_dir, kernel.module.get_module_identifier(block))
    with _quiet(wp.LOG_WARNING):
        whole = _is_whole(entry)
        if whole:
            try:
                load_module()
                _mark(entry)  # Warp may have added this processor's object to that of another
                return
            except Exception:  # of Warp, about files that another process has just removed
                whole = False
        with awaited(f"compiling the kernel {kernel.func.__name__}, once: it is kept in {entry.parent}"):
            begin = perf_counter()
            _build(kernel.module, load_module, entry)
        log.info("compiled the kernel %s for %s in %.2f s", kernel.func.__name__, device, perf_counter() - begin)
    if whole is False:
        outcome = "it was built anew" if _is_whole(entry) else "it cannot be replaced, delete it"
        warnings.warn(f"kernel cache: {entry} was damaged; {outcome}", stacklevel=2)


def _ask_for_wide_vectors(module: wp.Module) -> None:
    """Add the flag for wide vector instructions to a Warp module's compiler flags, unless the user forbids it."""
    flags = wide_flags()
    if flags and module.options["cpu_compiler_flags"] is None:
        module.options["cpu_compiler_flags"] = flags
        module.mark_modified()


def wide_flags() -> str:
    """Return the compiler flags with the flag for wide vector instructions; "" if the user wants no flags."""
    flags = "-march=native" if wp.config.cpu_compiler_flags is None else wp.config.cpu_compiler_flags  # Warp's default
    return f"{flags} {WIDE_VECTORS}" if flags else ""


@contextmanager
def _quiet(level: int) -> Iterator[None]:
    """Silence Warp's list of loaded modules within a `with` statement, unless the user has set a log level."""
    before = wp.config.log_level
    if before == wp.LOG_INFO:
        wp.config.log_level = level
    try:
        yield
    finally:
        wp.config.log_level = before


def _without_driver_warning(work: Callable[[], None]) -> None:
    """Call `work`, and remove Warp's warning of a missing CUDA driver from stderr."""
    with ExitStack() as after:
        with suppress(OSError):  # stderr is closed, or there is no temporary folder
            held = after.enter_context(tempfile.TemporaryFile())
            stderr = os.dup(2)
            os.dup2(held.fileno(), 2)
            after.callback(_show_others, held, stderr)
        work()


def _show_others(held: BinaryIO, stderr: int) -> None:
    """Restore stderr and write the lines collected in `held` to it, without the driver warning."""
    os.dup2(stderr, 2)
    os.close(stderr)
    held.seek(0)
    with suppress(OSError):
        os.write(2, b"".join(line for line in held if not line.startswith(_NO_DRIVER)))


def _is_whole(entry: Path) -> bool | None:
    """Return True if a module's cached files match their checksums, False if not, None if files are missing."""
    if not os.path.lexists(entry):
        return None
    try:
        outputs, marked = _contents(entry)
        if any(_digest(entry, name) != Path(entry, name + _MARK).read_bytes() for name in marked):
            return False
    except OSError:
        return False
    return True if marked and marked == outputs else None


def _contents(entry: Path) -> tuple[set[str], set[str]]:
    """Return (names of a module's cached files, names of the files with a checksum)."""
    names = [path.name for path in entry.iterdir()]
    marked = {name.removesuffix(_MARK) for name in names if name.endswith(_MARK)}
    return {name for name in names if not name.endswith((_MARK, *_SOURCES))}, marked


def _digest(entry: Path, name: str) -> bytes:
    """Return the SHA-256 of a file in hexadecimal digits."""
    return sha256(Path(entry, name).read_bytes()).hexdigest().encode()


def _mark(entry: Path) -> None:
    """Write checksums for the cached files of a module that have none."""
    with suppress(OSError):  # a file without a digest is only built again
        outputs, marked = _contents(entry)
        for name in outputs - marked:
            Path(entry, name + _MARK).write_bytes(_digest(entry, name))


def _build(module: wp.Module, load_module: Callable[[], None], entry: Path) -> None:
    """Compile and load a Warp module, and put its files into the cache; use a temporary folder if that fails."""
    home = entry.parent
    try:
        with _workshop(home, entry.name) as built:
            _build_there(module, load_module, built)
            _publish(built, entry)
    except OSError as error:
        try:
            with _workshop(Path(tempfile.gettempdir()), entry.name) as built:
                _build_there(module, load_module, built)
        except OSError as again:
            raise RuntimeError(
                f"kernel cache: nothing can be written in {home} ({error.strerror}), nor in a temporary folder "
                f"({again.strerror}); free some disk space or delete the cache"
            ) from again
        _say_unwritable(str(home), str(error.strerror))


@contextmanager
def _workshop(parent: Path, name: str) -> Iterator[Path]:
    """Use a new folder as Warp's cache within a `with` statement, and yield the module's path in the folder.

    Raises:
        OSError: the disk is full; LLVM would end the process.
    """
    parent.mkdir(parents=True, exist_ok=True)
    folder = Path(tempfile.mkdtemp(prefix="wp_", dir=parent))  # wp.clear_kernel_cache() removes it if this process is killed
    usual = wp.config.kernel_cache_dir
    try:
        (folder / f"{name}_space").write_bytes(os.urandom(_SPACE))  # zeros might not use disk space
        (folder / f"{name}_space").unlink()
        wp.config.kernel_cache_dir = str(folder)
        yield folder / name
    finally:
        wp.config.kernel_cache_dir = usual
        for path in folder.glob(f"{name}*"):
            _remove(path)
        with suppress(OSError):  # files that another thread is building now stay
            folder.rmdir()


def _remove(path: Path) -> None:
    """Remove a file or a folder."""
    if path.is_dir():
        shutil.rmtree(path, ignore_errors=True)
    else:
        path.unlink(missing_ok=True)


def _build_there(module: wp.Module, load_module: Callable[[], None], built: Path) -> None:
    """Compile and load a module in Warp's current cache folder, and write checksums of its files."""
    try:
        load_module()
    except Exception as error:
        if isinstance(error, OSError) or module.failed_builds:  # the folder or the kernel is at fault
            raise
        raise RuntimeError(
            f"kernel cache: {built.name} cannot be loaded although it was just built ({error}); "
            f"delete {built.parent.parent} and try again"
        ) from error
    _mark(built)  # if it exists: another kernel of the module may have loaded it before


def _publish(built: Path, entry: Path) -> None:
    """Move a compiled module to the cache in one step, so that other processes see all files or none."""
    with suppress(OSError):  # another process was first, with an equal result; or the old one stays
        if built.exists() and not _is_whole(entry):
            if os.path.lexists(entry):
                entry.rename(built.with_name(f"{built.name}_old"))
            built.rename(entry)


@once
def _say_unwritable(folder: str, reason: str) -> None:
    """Warn once that a cache folder cannot be written."""
    warnings.warn(
        f"kernel cache: {folder} is not writable ({reason}); kernels are built in a temporary folder by each process",
        stacklevel=2,
    )
