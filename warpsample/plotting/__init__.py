"""Functions that draw arrays as PyVista scenes and matplotlib figures; showing or saving is left to the caller."""
