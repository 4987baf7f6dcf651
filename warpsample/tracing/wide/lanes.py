"""Conversion of the results of a vectorised loop, sixteen numbers, to a mask of sixteen bits."""

import warp as wp


@wp.func_native("""
#if defined(__CUDA_ARCH__)
    int mask = 0;
    for (int lane = 0; lane < 16; ++lane)
        mask |= (((const int*)row)[lane] >> bit & 1) << lane;
    return mask;
#else
    typedef int ints __attribute__((ext_vector_type(16)));
    typedef bool bools __attribute__((ext_vector_type(16)));
    ints numbers;
    __builtin_memcpy(&numbers, (const void*)row, sizeof(numbers));
    return __builtin_bit_cast(unsigned short, __builtin_convertvector((numbers & 1 << bit) != 0, bools));
#endif
""")
def lanes_with(row: wp.uint64, bit: wp.int32) -> wp.int32:
    """Return a 16-bit mask: bit k is set if the k-th of sixteen int32 numbers at `row` has its bit number `bit` set.

    The function is native because Warp has no such builtin, and a loop that gathers the bits folds the register four times.
    With AVX-512 this is one instruction, and the row stays in a register; AVX2 packs the numbers to bytes first.
    """
