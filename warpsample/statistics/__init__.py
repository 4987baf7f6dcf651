"""Coordinates, histograms and quadrature on the sphere, for tests of samplers and for pictures."""
