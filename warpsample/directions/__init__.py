"""Directions at points: the call and its kernels.

A *row* is all samples of one point, a *segment* some consecutive ones of a row, a *block* consecutive (point, sample) pairs
of many rows. A *chunk* is what a kernel holds in local memory at a time: at most CHUNK samples, or rays. A *task* is what
one thread of a kernel computes: some rows, one segment or one block; a *part* some points of a call that is taken in parts.
"""
