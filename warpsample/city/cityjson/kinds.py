"""Types of a city's surfaces (roof, wall, ground), from the file or from normals."""

import numpy as np

ROOF, WALL, GROUND = "RoofSurface", "WallSurface", "GroundSurface"
BY_NORMAL = (ROOF, WALL, GROUND)
"""Types of upward, upright and downward surfaces."""

PLAIN = ("", "TrafficArea", "AuxiliaryTrafficArea", "WaterSurface")
"""Types of the surfaces of roads, water and plants that get results without an ending on their city object."""

_STEEP = 0.5  # cosine of 60 degrees: steeper surfaces are walls
_NOT_BUILT = {"Road", "Railway", "Waterway", "TransportSquare", "WaterBody", "LandUse", "PlantCover", "TINRelief"}
_NOT_BUILT |= {"SolitaryVegetationObject", "CityFurniture", "CityObjectGroup", "GenericCityObject"}


def is_built(kind: str) -> bool:
    """Return True if city objects of a CityJSON type have roofs and walls, as buildings have; True for unknown types."""
    return kind not in _NOT_BUILT


def classify_by_normal(crosses: np.ndarray) -> np.ndarray:
    """Classify faces by their normals as roof, wall or ground; return (N,) indices in BY_NORMAL.

    Normals are (N, 3) of any length; faces without a normal are walls.
    """
    length = np.linalg.norm(crosses, axis=1)
    return np.select([crosses[:, 2] > _STEEP * length, crosses[:, 2] < -_STEEP * length], [0, 2], 1)
