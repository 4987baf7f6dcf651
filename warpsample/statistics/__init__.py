"""Coordinates, histograms and quadrature, shared by the tests of samplers and the pictures."""
