"""Tools that the benchmarks compare, each used as in its own documentation."""
