"""The bar of a command that computes part by part, with what it tells of the parts so far."""

from typing import Any


def terminal_bar() -> Any:
    """A bar of rich's on stderr, if that is a terminal; its tasks have a field `told`, the text at its end."""
    from rich.console import Console
    from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn

    console = Console(stderr=True)
    columns = (TextColumn("{task.description}"), BarColumn(), TimeRemainingColumn(), TextColumn("{task.fields[told]}"))
    return Progress(*columns, console=console, disable=not console.is_terminal, transient=True)
