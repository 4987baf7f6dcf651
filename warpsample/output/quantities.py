"""All quantities, by the names that the command line has for them."""

from collections.abc import Mapping
from functools import cache
from typing import Any

from warpsample.estimate import quantities as of_rays
from warpsample.estimate.quantities.record import Quantity
from warpsample.host.registry import look_up, records_of
from warpsample.radiation import quantities as of_light


@cache
def quantities() -> dict[str, Quantity]:
    """By name, those of `estimate` before those of `radiation`."""
    return records_of(of_rays) | records_of(of_light)


def quantity_of(name: str) -> Quantity:
    """The record of a quantity.

    Raises:
        TypeError, ValueError: no name of one; the message lists those that are.
    """
    return look_up(quantities(), name, "quantity")


def taking(option: str) -> list[str]:
    """The names of the quantities to which an option of the command line applies."""
    return [name for name, quantity in quantities().items() if quantity.takes(option)]


def in_stores() -> list[str]:
    """The names of the quantities that Zarr stores hold."""
    return [name for name, quantity in quantities().items() if quantity.in_stores]


def check_options(quantity: Quantity, options: Mapping[str, Any]) -> None:
    """Refuses options that do not apply to a quantity, and asks for the files without which it cannot be computed.

    Raises:
        ValueError: names the option.
    """
    for option, wants in quantity.files.items():
        if options.get(option) is None:
            raise ValueError(f"--{option}: got None for {quantity.name}, want {wants}")
    for option, value in options.items():
        if not quantity.takes(option):
            names = " and ".join(taking(option))
            raise ValueError(f"--{option.replace('_', '-')}: got {value} for {quantity.name}; it applies only to {names}")
