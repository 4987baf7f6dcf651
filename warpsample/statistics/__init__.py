"""Charts, histograms and quadrature that proof and pictures share."""
