"""Units of a CityJSON file: factors that turn its coordinates into metres, by its `metadata.referenceSystem`."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any
from warnings import warn

import numpy as np

from warpsample.host.arguments import told
from warpsample.host.extras import missing
from warpsample.host.json_tree import Part
from warpsample.host.locks import imported

_KEY = "referenceSystem"
_STEEP = 500.0  # heights over the diagonal of the plan; a guyed mast alone has 300, a house in degrees 50,000
_LEAST = 1.0  # of heights: a house has more


@dataclass(frozen=True)
class Units:
    """Reference system of a file, and what it says of lengths.

    Attributes:
        name: as the file has it; "" for none.
        crs: the pyproj.CRS; None for no name, a name that is not known, or without pyproj.
        metres: (3,) float64, the lengths of the units of x, y and z in metres; 1 where they are not known.
        doubt: a phrase on what is not known, or "".
    """

    name: str
    crs: Any
    metres: np.ndarray
    doubt: str

    @classmethod
    def of(cls, head: Part) -> "Units":
        """Read the reference system of the first object of a file.

        Raises:
            TypeError, ValueError: one that is no text, or whose coordinates are no lengths of a map and heights.
        """
        metadata = head.part("metadata") if head.content.get("metadata") is not None else Part({}, "metadata")
        if metadata.content.get(_KEY) is None:
            return cls("", None, np.ones(3), "")
        name = metadata.text(_KEY)
        try:
            reference = imported("warpsample.city.rasters.reference")
        except ModuleNotFoundError as error:
            return cls(name, None, np.ones(3), f"whose unit is not known: {missing('it needs pyproj', error.name, 'city')}")
        try:
            crs = reference.crs_by_address(name)
        except reference.CRSError:
            return cls(name, None, np.ones(3), "which pyproj does not know")
        reference.check_map(crs, metadata.at(_KEY), "transform it first")
        flat, up = reference.metres_of(crs), reference.height_metres_of(crs, "")
        doubt = "without a unit of heights; they are taken to be in that of the map" if up is None and flat != 1.0 else ""
        return cls(name, crs, np.array([flat, flat, up or flat], np.float64), doubt)

    def check_lengths(self, points: np.ndarray) -> None:
        """Refuse points, (V, 3), of no known system that are much steeper than cities, as those in degrees are."""
        ends = np.stack([points.min(axis=0), points.max(axis=0)])
        on_earth, extent = np.abs(ends[:, :2]).max(axis=0) <= (180.0, 90.0), ends[1] - ends[0]
        if self.crs is None and on_earth.all() and extent[2] > max(_LEAST, _STEEP * np.hypot(*extent[:2])):
            raise ValueError(
                f"it has no metadata.{_KEY} that is known, and coordinates between {ends.tolist()}, as in degrees; want "
                "lengths"
            )

    def warn(self, path: Path, points: np.ndarray) -> None:
        """Warn once of units that are not known, and of a map that stretches lengths about the points, (V, 3)."""
        said = f"got {str(path)!r} in {told(self.name)}"
        if self.doubt:
            taken = "" if self.crs else "; its coordinates are taken as metres"
            warn(f"path: {said}, {self.doubt}{taken}", stacklevel=3)
        if self.crs is not None:
            x, y = 0.5 * (points.min(axis=0) + points.max(axis=0))[:2]
            stretched = imported("warpsample.city.rasters.reference").describe_stretch(self.crs, x, y)
            if stretched:
                warn(f"path: {stretched}: areas and slopes are wrong by as much; transform it first", stacklevel=3)
