"""What the surfaces of an object are called: by their semantics, or, of what is built, by where they face."""

import numpy as np

ROOF, WALL, GROUND = "RoofSurface", "WallSurface", "GroundSurface"
BY_NORMAL = (ROOF, WALL, GROUND)

_STEEP = 0.5  # cosine of 60 degrees: a surface that is steeper is a wall
_NOT_BUILT = {"Road", "Railway", "Waterway", "TransportSquare", "WaterBody", "LandUse", "PlantCover", "TINRelief"}
_NOT_BUILT |= {"SolitaryVegetationObject", "CityFurniture", "CityObjectGroup", "GenericCityObject"}


def is_built(kind: str) -> bool:
    """Whether an object of a type has roofs and walls: also types that are not known, as those of extensions."""
    return kind not in _NOT_BUILT


def classify_by_normal(crosses: np.ndarray) -> np.ndarray:
    """(N,) the number in BY_NORMAL of faces with these normals, (N, 3) of any length; without one they are walls."""
    length = np.linalg.norm(crosses, axis=1)
    return np.select([crosses[:, 2] > _STEEP * length, crosses[:, 2] < -_STEEP * length], [0, 2], 1)
