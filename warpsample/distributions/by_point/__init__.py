"""Parameters with one row for each point: their checks, the fields of distributions, and tables for kernels."""
