"""Distribution parameters that differ from point to point: arrays with one row per point, checked and passed to kernels."""
