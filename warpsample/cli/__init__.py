"""The `warpsample` command: its entry point, which first imports only the handling of signals."""

import os
import sys
import warnings

from warpsample.cli.signals import listening


def main() -> None:
    """Runs the command line, as `warpsample` and `python -m warpsample` do."""
    _open_what_is_closed()
    with listening():
        from warpsample.cli.commands import app
        from warpsample.cli.terminal import print_anything, saying_what_fails

        warnings.formatwarning = lambda message, *_, **__: f"warning: {message}\n"
        print_anything()
        with saying_what_fails():  # for what no command handles: --version and --help
            try:
                app(prog_name="warpsample")
            finally:
                sys.stdout.flush()


def _open_what_is_closed() -> None:
    """Opens closed standard streams to nowhere: else a file of ours could get the number that libraries print to."""
    while (number := os.open(os.devnull, os.O_RDWR)) <= 2:
        pass
    os.close(number)
    for number, (name, mode) in enumerate((("stdin", "r"), ("stdout", "w"), ("stderr", "w"))):
        if getattr(sys, name) is None:
            setattr(sys, name, os.fdopen(number, mode, encoding="utf-8", closefd=False))
