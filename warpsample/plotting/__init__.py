"""Arrays as PyVista plotters and matplotlib figures. Draws what it is given, computes nothing else, and shows nothing."""
