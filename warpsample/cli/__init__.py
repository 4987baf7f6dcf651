"""The `warpsample` command: its entry point, which imports nothing but what hears a signal."""

import warnings

from warpsample.cli.signals import listening


def main() -> None:
    """Entry point."""
    with listening():
        from warpsample.cli.commands import app  # noqa: PLC0415  (takes a second, in which Ctrl-C is heard already)
        from warpsample.cli.terminal import print_anything  # noqa: PLC0415

        warnings.formatwarning = lambda message, *_, **__: f"warning: {message}\n"
        print_anything()
        app(prog_name="warpsample")
