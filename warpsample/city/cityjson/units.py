"""Units of a CityJSON file's coordinates, from its reference system, and factors to metres."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any
from warnings import warn

import numpy as np

from warpsample.city.cityjson.steepness import looks_like_degrees
from warpsample.host.arguments import quote
from warpsample.host.extras import missing
from warpsample.host.json_tree import Part
from warpsample.host.locks import imported
from warpsample.mesh.holes import Outlines

_KEY = "referenceSystem"


@dataclass(frozen=True)
class Units:
    """Coordinate reference system of a CityJSON file, with factors from its units to metres.

    Attributes:
        name: name of the reference system in the file; "" without one.
        crs: pyproj.CRS; None without a name, for an unknown name, or without pyproj.
        metres: (3,) float64, lengths of the units of x, y and z in metres; 1 where unknown.
        doubt: phrase on unknown units, or "".
    """

    name: str
    crs: Any
    metres: np.ndarray
    doubt: str

    @classmethod
    def of(cls, head: Part) -> "Units":
        """Read the reference system from the first document of a file.

        Raises:
            TypeError, ValueError: the name is not a text, or its coordinates are not lengths on a map and heights.
        """
        metadata = head.part("metadata") if head.content.get("metadata") is not None else Part({}, "metadata")
        if metadata.content.get(_KEY) is None:
            return cls("", None, np.ones(3), "")
        name = metadata.text(_KEY)
        try:
            reference = imported("warpsample.city.rasters.sources.reference")
        except ModuleNotFoundError as error:
            return cls(
                name,
                None,
                np.ones(3),
                f"whose unit is not known: {missing('reading the unit needs pyproj', error.name, 'city')}",
            )
        try:
            crs = reference.crs_by_address(name)
        except reference.CRSError:
            return cls(name, None, np.ones(3), "which pyproj does not know")
        reference.check_map(crs, metadata.at(_KEY), "transform it first")
        flat, up = reference.metres_of(crs), reference.height_metres_of(crs)
        doubt = "without a unit of heights; they are taken to be in that of the map" if up is None and flat != 1.0 else ""
        return cls(name, crs, np.array([flat, flat, up or flat], np.float64), doubt)

    def check_lengths(self, points: np.ndarray, outlines: Outlines) -> None:
        """Raise a ValueError for faces of an unknown reference system that look like degrees.

        Args:
            points: (V, 3) vertices in the file's units.
            outlines: outlines of the faces.
        """
        if self.crs is None and looks_like_degrees(points, outlines):
            ends = np.stack([end(points[outlines.corners], axis=0) for end in (np.min, np.max)])
            raise ValueError(
                f"the file has no known CRS in metadata.{_KEY}, and coordinates from {ends[0].tolist()} to "
                f"{ends[1].tolist()}, which look like degrees; want lengths; reproject the file to a map in metres"
            )

    def warn(self, path: Path, points: np.ndarray) -> None:
        """Warn of unknown units, and of a map that distorts lengths at the points (V, 3)."""
        message = f"got {str(path)!r} in {quote(self.name)}"
        if self.doubt:
            taken = "" if self.crs else "; its coordinates are taken as metres"
            warn(f"path: {message}, {self.doubt}{taken}", stacklevel=3)
        if self.crs is not None:
            x, y = 0.5 * (points.min(axis=0) + points.max(axis=0))[:2]
            stretched = imported("warpsample.city.rasters.sources.reference").describe_stretch(self.crs, x, y)
            if stretched:
                warn(
                    f"path: {stretched}: areas and slopes are wrong by the same factor; reproject the file first",
                    stacklevel=3,
                )
