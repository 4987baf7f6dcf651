"""All quantities that commands can compute, keyed by name, such as "ao" for ambient occlusion."""

from collections.abc import Iterable, Mapping
from functools import cache
from inspect import Parameter
from typing import Any

from warpsample.estimate import quantities as of_rays
from warpsample.estimate.quantities.record import Quantity
from warpsample.host.registry import look_up, records_of
from warpsample.radiation import quantities as of_light


@cache
def quantities() -> dict[str, Quantity]:
    """Return all quantities, keyed by name: first quantities of `estimate`, then of `radiation`."""
    return records_of(of_rays) | records_of(of_light)


def quantity_of(name: str) -> Quantity:
    """Return the `Quantity` with the given name, for example "ao"; raise a ValueError for an unknown name."""
    return look_up(quantities(), name, "quantity")


def quantities_with(option: str) -> list[str]:
    """Return the names of the quantities to which an option of the command line applies."""
    return [name for name, quantity in quantities().items() if quantity.takes(option)]


def in_stores() -> list[str]:
    """Return the names of the quantities that can be written to Zarr stores."""
    return [name for name, quantity in quantities().items() if quantity.in_stores]


def check_options(quantity: Quantity, options: Mapping[str, Any]) -> None:
    """Check that options apply to a quantity, and that all required files are given.

    Raises:
        ValueError: an option that does not apply, or a file that is missing; the message names the option.
    """
    for option, wants in quantity.files.items():
        if options.get(option) is None:
            raise ValueError(f"--{option}: got None for {quantity.name}, want {wants}")
    for option, value in options.items():
        if not quantity.takes(option):
            *others, last = quantities_with(option)
            names = f"{', '.join(others)} and {last}" if others else last
            raise ValueError(
                f"--{option.replace('_', '-')}: got {value} for {quantity.name}; the option applies only to {names}"
            )


def call_table() -> str:
    """Return the README's Markdown table of the functions that estimate quantities."""
    of = [quantity for quantity in records_of(of_rays).values() if quantity.in_stores]
    everywhere = set.intersection(*(set(quantity.parameters) for quantity in of))
    rows = [("call", "value at each point"), ("---", "---")]
    for quantity in of:
        own = [
            name if default is Parameter.empty else f"{name}="
            for name, default in quantity.parameters.items()
            if name not in everywhere
        ]
        rows.append((f"`ws.{quantity.call.__name__}({', '.join(['mesh', 'points', *own])})`", quantity.value))
    return _markdown(rows)


def name_table() -> str:
    """Return the table of all quantities by their names on the command line, in Markdown."""
    rows = [("`--quantity`", "value at each point", "unit"), ("---", "---", "---")]
    return _markdown([*rows, *((f"`{name}`", quantity.value, quantity.unit) for name, quantity in quantities().items())])


def _markdown(rows: Iterable[tuple[str, ...]]) -> str:
    """Return rows of texts as a Markdown table; the first row is the header."""
    return "".join(f"| {' | '.join(row)} |\n" for row in rows)


if __name__ == "__main__":
    print(call_table(), name_table(), sep="\n", end="")  # noqa: T201
