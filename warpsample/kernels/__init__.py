"""The loops around a sequence and a distribution, as cached kernels.

What makes the compiler vectorise them: a `while` over one-dimensional views that the kernel itself opens from an address,
scalar stores, no branch and no libm call inside. Kernels take addresses and scalars only, so NumPy arrays need no wrapping;
who calls them has checked shapes and types.
"""

FLAT_BLOCK = 256
"""Elements of one task on the CPU: long enough to hide its setup, short enough that a rare redraw rereads little."""
