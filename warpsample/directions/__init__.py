"""Sampling of random directions at surface points: the public functions and their Warp kernels.

Terms:
    row: all samples of one point.
    segment: consecutive samples of one row.
    block: consecutive (point, sample) pairs, from one or more rows.
    chunk: samples, at most CHUNK, that a kernel holds in local memory at a time.
    task: work of one thread of a kernel: some rows, one segment or some blocks.
    part: consecutive points of a call that does not fit into the device's memory as a whole.
"""
