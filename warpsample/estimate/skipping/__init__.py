"""Which parts of the tree the rays of a point need not look at."""
