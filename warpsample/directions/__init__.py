"""Directions at points: the call and its kernels, the loops around a sequence and a distribution.

What makes the compiler vectorise them: a `while` over one-dimensional views that the kernel itself opens from an address,
scalar stores, no branch and no libm call inside. Kernels take addresses and scalars only, so NumPy arrays need no wrapping;
who calls them has checked shapes and types.
"""
