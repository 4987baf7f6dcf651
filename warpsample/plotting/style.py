"""Colours, colour maps, font and round limits of axes, for all pictures."""

from functools import lru_cache
from math import floor, log10
from pathlib import Path

SURFACE = "#d8d4cc"
"""Colour of a mesh without numbers, and of faces and cells without a value."""
SKY = "#c7d5e0"
"""Background of scenes, darker than a white mesh."""
LOBE = "#d1495b"
BARS = "#7aa6c2"
DOTS = "#2f6690"
INK = "#333333"
"""Colour of text."""

OPENNESS = "gray"
"""Colour map of ambient occlusion and sky view: 0 (occluded) is black and 1 (open) is white."""
ENERGY = "plasma"
"""Colour map of irradiation and irradiance: dark blue to yellow."""
ERROR = "YlGnBu"
"""Colour map of standard errors: 0 is pale yellow."""
AMOUNT = "YlOrRd"
"""Colour map of counts and fractions that are 0 at most places: 0 is pale yellow."""

COUNTS = "viridis"
"""Colour map of densities: 0 is dark blue."""
DIFFERENCE = "RdBu_r"
"""Colour map of residuals: 0 is white, positive is red."""

_STEPS = (1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0)


def round_up(x: float) -> float:
    """Round x > 0 up to one of few steps times a power of ten, so that limits of axes change seldom."""
    scale = 10.0 ** floor(log10(x))
    return float(next(step * scale for step in _STEPS if step * scale >= x * (1 - 1e-9)))


@lru_cache
def font_file(bold: bool = False) -> str:
    """Return the path of the font DejaVu Sans that matplotlib contains, for texts of PyVista scenes.

    Scenes then have the font of figures, with ² and Greek letters.
    """
    import matplotlib as mpl

    return str(Path(mpl.get_data_path()) / "fonts" / "ttf" / f"DejaVuSans{'-Bold' * bold}.ttf")
