"""Thermal radiation between grey surfaces: net loss of each surface from temperatures and emissivities."""

import warnings
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from warpsample.host.arguments import quote
from warpsample.host.arrays import as_real
from warpsample.host.summary import Summary
from warpsample.host.tables import frame_of
from warpsample.radiation.exchange.radiosity import radiosity_of

if TYPE_CHECKING:
    from scipy.sparse import csr_array

STEFAN_BOLTZMANN = 5.670374419e-8
"""Stefan-Boltzmann constant in W/(m² K⁴), exact to these digits since 2019."""

_HOTTEST = 1e6  # kelvin
_CELSIUS = (0.0, 60.0)  # usual temperatures of rooms and weather in degrees Celsius; unusual in kelvin
_LEAK = 1e-3  # share of a row that may leak from a closed room, at edges where faces meet at less than 14 degrees


@dataclass(frozen=True, eq=False, repr=False)
class NetRadiation(Summary):
    """Net thermal radiation of N surfaces, at one time or at k times.

    Attributes:
        flux: (N,) or (N, k) float64, W/m², emitted minus absorbed; positive where the surface cools.
        power: Flux times area, in W if the mesh is in metres, in the shape of `flux`.
        leaving: Radiosity, emitted plus reflected, in W/m², in the shape of `flux`.
        names: Names of the surfaces, or None.
    """

    flux: NDArray[np.float64]
    power: NDArray[np.float64]
    leaving: NDArray[np.float64]
    names: tuple[str, ...] | None = None

    def to_frame(self) -> Any:
        """Return the net radiation as a table with the columns flux, power and leaving radiation.

        Returns:
            a pandas.DataFrame with a row for each surface, or for each surface and time; without pandas a dictionary of
            arrays. Columns are the names if there are any, the index of the time for k times, flux, power and leaving.

        Example:
            >>> yard = ws.view_factors(ws.load_mesh("courtyard"), 16, groups=np.repeat(["yard", "rest"], [848, 1232]))
            >>> night = yard.net_radiation({"yard": 280.0, "rest": 285.0}, 0.9, outside=265.0)
            >>> print(list(night.to_frame()), list(night.to_frame()["names"]))
            ['names', 'flux', 'power', 'leaving'] ['rest', 'yard']
        """
        rows, *times = self.flux.shape
        columns: dict[str, np.ndarray] = {}
        if self.names is not None:
            columns["names"] = np.repeat(np.array(self.names, object), self.flux.size // rows)
        if times:
            columns["time"] = np.tile(np.arange(*times), rows)
        return frame_of(columns | {name: getattr(self, name).ravel() for name in ("flux", "power", "leaving")})


def net_radiation_of(
    matrix: "csr_array",
    open_share: np.ndarray,
    temperature: Any,
    emissivity: Any,
    outside: Any,
    *,
    areas: np.ndarray,
    names: tuple[str, ...] | None,
) -> NetRadiation:
    """Compute the net thermal radiation of all surfaces; see `ViewFactors.net_radiation`.

    matrix, open_share, areas, names: `matrix`, `outside`, `areas` and `names` of the view factors.
    """
    rows = len(areas)
    kelvin = _check_numbers(_expand_names(names, temperature, "temperature"), "temperature", 0.0, _HOTTEST)
    share = _check_numbers(_expand_names(names, emissivity, "emissivity"), "emissivity", np.finfo(np.float64).tiny, 1.0)
    if outside is None and (open := float(open_share.max(initial=0.0))) > _LEAK:
        raise ValueError(
            f"outside: got None, but a surface has a view factor of {open:.2g} to the outside, want the temperature "
            "of the surroundings in kelvin, or 0.0 if nothing radiates from there"
        )
    beyond = _check_numbers(0.0 if outside is None else outside, "outside", 0.0, _HOTTEST)
    if kelvin.ndim > 2 or (kelvin.ndim and len(kelvin) != rows):
        raise ValueError(
            f"temperature: got shape {kelvin.shape}, want ({rows},), a number for each surface, or ({rows}, k), a "
            "number for each surface and time"
        )
    if share.ndim and share.shape != (rows,):
        raise ValueError(f"emissivity: got shape {share.shape}, want one number, or ({rows},), a number for each surface")
    times = kelvin.shape[1:]
    if beyond.ndim and beyond.shape != times:
        raise ValueError(f"outside: got shape {beyond.shape}, want one number{f' or {times}' if times else ''}")
    _warn_of_celsius(kelvin)
    emitted = np.broadcast_to(STEFAN_BOLTZMANN * np.square(np.square(kelvin)), (rows, *times)).reshape(rows, -1)
    sky = np.outer(open_share, np.broadcast_to(STEFAN_BOLTZMANN * np.square(np.square(beyond)), times).ravel())
    part = np.broadcast_to(share, (rows,))[:, None]
    try:
        leaving = radiosity_of(matrix, part * emitted + (1.0 - part) * sky, 1.0 - part[:, 0])
    except ValueError as error:  # of the reflectance: all other arguments are in range
        raise ValueError(
            f"emissivity: got down to {share.min():g}, want larger numbers, so that reflections die out"
        ) from error
    flux = part * (emitted - matrix @ leaving - sky)
    found = (a.reshape(rows, *times) for a in (flux, flux * areas[:, None], leaving))
    return NetRadiation(*found, names)


def _expand_names(names: tuple[str, ...] | None, value: Any, argument: str) -> Any:
    """Convert a dictionary from names of surfaces to an array with one row per surface; return other values unchanged.

    Raises:
        ValueError: surfaces have no names, or the dictionary's keys are not these names.
    """
    if not isinstance(value, Mapping):
        return value
    if names is None:
        raise ValueError(
            f"{argument}: got a dictionary, but the surfaces have no names, want numbers; view_factors(groups=) names "
            "surfaces"
        )
    if set(value) != set(names):
        raise ValueError(
            f"{argument}: got a dictionary with the names {sorted(map(str, value))}, want all of {sorted(names)}"
        )
    rows = [as_real(value[name], f"{argument}[{name!r}]") for name in names]
    if len(shapes := {row.shape for row in rows if row.ndim}) > 1:
        raise ValueError(
            f"{argument}: got arrays of different shapes, {', '.join(map(str, sorted(shapes)))}, want one number for "
            "each surface, or "
            "arrays of the same length, one number for each time"
        )
    return np.stack(np.broadcast_arrays(*rows))


def _warn_of_celsius(kelvin: np.ndarray) -> None:
    """Warn if all temperatures, meant in kelvin, are in the usual range of degrees Celsius."""
    low, high = _CELSIUS
    if kelvin.size and low < kelvin.max() <= high:
        warnings.warn(
            f"temperature: got at most {kelvin.max():g} kelvin; if these are degrees Celsius, add 273.15", stacklevel=4
        )


def _check_numbers(value: Any, argument: str, low: float, high: float) -> np.ndarray:
    """Return `value` as a float64 array after checking that its numbers are from `low` to `high`.

    Raises:
        TypeError, ValueError: not numbers, or numbers outside the limits.
    """
    array = as_real(value, argument).astype(np.float64)
    if array.size and not (array.min() >= low and array.max() <= high):
        at_least = "above 0" if low > 0.0 else f"from {low:g}"
        raise ValueError(f"{argument}: got {quote(value)}, want finite numbers {at_least} to {high:g}")
    return array
