"""Colours, colour maps and font of all pictures."""

from functools import lru_cache
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


@lru_cache
def font_file(bold: bool = False) -> str:
    """Return the path of the font DejaVu Sans that matplotlib contains, for texts of PyVista scenes.

    Scenes then have the font of figures, with ² and Greek letters.
    """
    import matplotlib as mpl

    return str(Path(mpl.get_data_path()) / "fonts" / "ttf" / f"DejaVuSans{'-Bold' * bold}.ttf")
