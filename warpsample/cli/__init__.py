"""The `warpsample` command: its entry point, which first imports only the handling of signals."""

import gc
import os
import sys
import warnings
from collections.abc import Iterator
from contextlib import contextmanager

from warpsample.cli.signals import listening
from warpsample.cli.streams import escape, open_closed_streams


def main() -> None:
    """Run the command line, as `warpsample` and `python -m warpsample` do."""
    open_closed_streams()
    with _safe_children(), listening():
        gc.disable()  # what is imported stays; looking for garbage in it takes a tenth of the start
        from warpsample.cli.commands import app
        from warpsample.cli.terminal import print_anything, printing_errors

        gc.enable()
        warnings.formatwarning = lambda message, *_, **__: f"warning: {escape(str(message))}\n"
        print_anything()
        with printing_errors():  # for what no command handles: --version and --help
            try:
                app(prog_name="warpsample")
            finally:
                sys.stdout.flush()


@contextmanager
def _safe_children() -> Iterator[None]:
    """Context manager: child processes of Python 3.11 or later import nothing from the working folder."""
    before = os.environ.get("PYTHONSAFEPATH")
    os.environ["PYTHONSAFEPATH"] = "1"
    try:
        yield
    finally:
        del os.environ["PYTHONSAFEPATH"]
        if before is not None:
            os.environ["PYTHONSAFEPATH"] = before
