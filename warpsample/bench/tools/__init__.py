"""Tools of the benchmarks, each used as in its own documentation."""
