"""The `warpsample` command: its entry point, which imports nothing but what hears a signal."""

from warpsample.cli.signals import listening


def main() -> None:
    """Entry point."""
    with listening():
        import warp as wp  # noqa: PLC0415  (takes a second, in which Ctrl-C is heard already)

        from warpsample.cli.commands import app  # noqa: PLC0415
        from warpsample.cli.terminal import print_anything  # noqa: PLC0415

        wp.config.log_level = wp.LOG_WARNING  # what Warp logs goes to stdout, which belongs to the output
        print_anything()
        app(prog_name="warpsample")
