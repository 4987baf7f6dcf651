"""Building blocks in float32 and uint32 that the compiler turns into vector instructions.

Each `wp.func` is plain arithmetic without libm calls, branches or tables, so that a loop around it runs 8 lanes wide on AVX2
and 16 on AVX-512. The compiler fuses no product with a sum unless the code calls `fma`, so that scalar and vector code give
the same bits. Worst errors are over every float32 of the stated range (uniform variates: all 2^24), against float64.
"""

import warp as wp

GRID = 1 << 24
"""Number of steps of uniform variates: multiples of 1/GRID in [0, 1), so that 1 - u is exact in float32."""

_GRID_STEP = wp.constant(wp.float32(1.0 / GRID))
_GRID_SIZE = wp.constant(wp.float64(GRID))
_LAST_CELL = wp.constant(wp.int32(GRID - 1))
_LARGEST_UNIFORM = wp.constant(wp.float32(1.0 - 1.0 / GRID))
_ALMOST_UNIT = wp.constant(wp.float32(2.0**-20))
_EXPONENT_MASK = wp.constant(wp.int32(0x7F800000))
_INVERSE_ROOT_SEED = wp.constant(wp.int32(0x5F375A86 - 0x00400000))
_EXPONENT_OF_2_127 = wp.constant(wp.int32(0x7F000000))
_EXPONENT_OF_2_MINUS_126 = wp.constant(wp.int32(0x00800000))
_FMA = """
#if defined(__CUDA_ARCH__)
    return fma{0}(a, b, c);
#else
    return __builtin_fma{0}(a, b, c);
#endif
"""
_FMA_ADJOINT = """
    adj_a += b * adj_ret;
    adj_b += a * adj_ret;
    adj_c += adj_ret;
"""
# A bare number in a kernel is float32.
ZERO: wp.float64 = wp.constant(wp.float64(0.0))
HALF: wp.float64 = wp.constant(wp.float64(0.5))
ONE: wp.float64 = wp.constant(wp.float64(1.0))
TWO: wp.float64 = wp.constant(wp.float64(2.0))
INV_PI: wp.float32 = wp.constant(wp.float32(0.3183098861837907))
INV_TWO_PI: wp.float32 = wp.constant(wp.float32(0.15915494309189535))
TWO_OVER_PI: wp.float32 = wp.constant(wp.float32(0.6366197723675814))
INV_PI_DOUBLE: wp.float64 = wp.constant(wp.float64(0.3183098861837907))
INV_TWO_PI_DOUBLE: wp.float64 = wp.constant(wp.float64(0.15915494309189535))
EVEN_BITS: wp.uint32 = wp.constant(wp.uint32(0x55555555))
EVEN_PAIRS: wp.uint32 = wp.constant(wp.uint32(0x33333333))
EVEN_NIBBLES: wp.uint32 = wp.constant(wp.uint32(0x0F0F0F0F))
EVEN_BYTES: wp.uint32 = wp.constant(wp.uint32(0x00FF00FF))


@wp.func_native(snippet=_FMA.format("f"), adj_snippet=_FMA_ADJOINT)
def fma(a: wp.float32, b: wp.float32, c: wp.float32) -> wp.float32:
    """Return a * b + c, rounded once.

    The function is native because Warp has no such builtin. If the compiler chose which products to fuse, the bits would
    depend on the surrounding loop; with `fma` the bits are the same in every kernel.
    """


@wp.func_native(snippet=_FMA.format(""), adj_snippet=_FMA_ADJOINT)
def fma_double(a: wp.float64, b: wp.float64, c: wp.float64) -> wp.float64:
    """Return a * b + c in float64, rounded once; native for the same reason as `fma`."""


@wp.func
def low_word(x: wp.uint64) -> wp.uint32:
    """Return the low 32 bits of x."""
    return wp.uint32(x)


@wp.func
def high_word(x: wp.uint64) -> wp.uint32:
    """Return the high 32 bits of x."""
    return wp.uint32(x >> wp.uint64(32))


@wp.func
def uniform_from_bits(bits: wp.uint32) -> wp.float32:
    """Return the top 24 of 32 random bits as a multiple of 2^-24 in [0, 1), exactly."""
    return wp.float32(wp.int32(bits >> wp.uint32(8))) * _GRID_STEP


@wp.func
def uniform_from_double(x: wp.float64) -> wp.float32:
    """Round x in [0, 1] down to a multiple of 2^-24 below 1."""
    return wp.float32(wp.min(wp.int32(x * _GRID_SIZE), _LAST_CELL)) * _GRID_STEP


@wp.func
def clamp_uniform(u: wp.float32) -> wp.float32:
    """Clamp u to [0, 1 - 2^-24], for inverses that rounding would take to -0.0 or 1; the gradient at both ends is 0."""
    return wp.min(wp.max(u, 0.0), _LARGEST_UNIFORM)


@wp.func
def reverse_bits(x: wp.uint32) -> wp.uint32:
    """Reverse the order of 32 bits: bit 0 becomes bit 31."""
    x = ((x >> wp.uint32(1)) & EVEN_BITS) | ((x & EVEN_BITS) << wp.uint32(1))
    x = ((x >> wp.uint32(2)) & EVEN_PAIRS) | ((x & EVEN_PAIRS) << wp.uint32(2))
    x = ((x >> wp.uint32(4)) & EVEN_NIBBLES) | ((x & EVEN_NIBBLES) << wp.uint32(4))
    x = ((x >> wp.uint32(8)) & EVEN_BYTES) | ((x & EVEN_BYTES) << wp.uint32(8))
    return (x >> wp.uint32(16)) | (x << wp.uint32(16))


@wp.func
def weyl(index: wp.uint32, step: wp.uint64) -> wp.uint32:
    """Return element `index` of a Weyl sequence: the top 32 bits of the fractional part of index * step / 2^64.

    Consecutive indices give a rotation of the unit interval by step / 2^64.
    """
    carry = high_word(wp.uint64(index) * wp.uint64(low_word(step)))
    return index * high_word(step) + carry


@wp.func
def root(x: wp.float32) -> wp.float32:
    """Return sqrt(x), with gradient 0 at 0, where the gradient of `wp.sqrt` is infinite and its product with 0 is NaN."""
    return wp.sqrt(x)


@wp.func_grad(root)
def _adj_root(x: wp.float32, adj_ret: wp.float32):
    if x > 0.0:
        wp.adjoint[x] += 0.5 * adj_ret / wp.sqrt(x)


@wp.func
def root_double(x: wp.float64) -> wp.float64:
    """Return sqrt(x) in float64, with gradient 0 at 0."""
    return wp.sqrt(x)


@wp.func_grad(root_double)
def _adj_root_double(x: wp.float64, adj_ret: wp.float64):
    if x > ZERO:
        wp.adjoint[x] += HALF * adj_ret / wp.sqrt(x)


@wp.func
def sincos_eighth(x: wp.float32) -> wp.vec2:
    """Return (cos 2 pi x, sin 2 pi x) for abs(x) <= 1/8, by minimax polynomials; worst absolute error 8.4e-8."""
    t = x * x
    c = fma(t, fma(t, fma(t, fma(t, 59.245964, -85.443741), 64.939323), -19.739208), 1.0)
    # 2 pi is the sum of two floats here: a single float is wrong by half a unit in the last place.
    s = fma(x, 6.2831855, x * fma(t, fma(t, fma(t, -75.393585, 81.592354), -41.341663), -1.7484555e-07))
    return wp.vec2(c, s)


@wp.func
def sincos_turns(u: wp.float32) -> wp.vec2:
    """Return (cos 2 pi u, sin 2 pi u) for u in [0, 1]; worst absolute error 8.4e-8, exact at the quarter turns.

    u - 1/2 and the two reflections onto an eighth of a turn are exact in float32, so values near a zero stay precise.
    """
    half = 0.5 - u
    x = wp.abs(half) - 0.25
    y = wp.abs(x)
    z = 0.25 - y
    nearer = y < z
    cs = sincos_eighth(wp.where(nearer, y, z))
    c = wp.where(nearer, cs[1], cs[0])
    s = wp.where(nearer, cs[0], cs[1])
    return wp.vec2(wp.copysign(c, x), wp.copysign(s, half))


@wp.func
def polish(v: wp.vec3) -> wp.vec3:
    """Normalise a vector whose length is within 1e-4 of 1 by one Newton step, to a length error of 8e-8.

    1 / sqrt alone leaves three times this error.
    """
    half_error = 0.5 * fma(-v[0], v[0], fma(-v[1], v[1], fma(-v[2], v[2], 1.0)))
    return wp.vec3(fma(v[0], half_error, v[0]), fma(v[1], half_error, v[1]), fma(v[2], half_error, v[2]))


@wp.func
def scaled_to_unit(v: wp.vec3) -> wp.vec4:
    """Normalise a finite vector v of length 1e-45 to 3e38: return (v / abs(v), error), with abs(error) below 0.1.

    The error is 1/2 for a zero vector and NaN for a vector that is not finite; the direction is then meaningless. An exact
    scaling by a power of two brings the largest component to about 1, so that no square underflows or overflows. The
    inverse root starts from the bits (Lomont2003) and takes two Newton steps; a third step on the vector leaves a length
    within 8e-8 of 1. The method is twice as fast as a root and a division, which do not pipeline.
    """
    # Compare exponents as integers: an integer maximum is one instruction, a float maximum four.
    ex = wp.cast(v[0], wp.int32) & _EXPONENT_MASK
    ey = wp.cast(v[1], wp.int32) & _EXPONENT_MASK
    ez = wp.cast(v[2], wp.int32) & _EXPONENT_MASK
    exponent = wp.max(wp.max(ex, ey), ez)
    scale = wp.cast(wp.max(_EXPONENT_OF_2_127 - exponent, _EXPONENT_OF_2_MINUS_126), wp.float32)
    x = v[0] * scale
    y = v[1] * scale
    z = v[2] * scale
    half_square = 0.5 * fma(x, x, fma(y, y, z * z))
    inverse = wp.cast(_INVERSE_ROOT_SEED - (wp.cast(half_square, wp.int32) >> 1), wp.float32)
    inverse = inverse * fma(-half_square * inverse, inverse, 1.5)
    inverse = inverse * fma(-half_square * inverse, inverse, 1.5)
    x = x * inverse
    y = y * inverse
    z = z * inverse
    half_error = 0.5 * fma(-x, x, fma(-y, y, fma(-z, z, 1.0)))
    return wp.vec4(fma(x, half_error, x), fma(y, half_error, y), fma(z, half_error, z), half_error)


@wp.func
def direction_to_unit(v: wp.vec3) -> wp.vec4:
    """Normalise a vector v whose length is 1 up to rounding: return (v / abs(v), error), faster than `scaled_to_unit`.

    One Newton step is enough for such a vector and leaves an error of 2^-39. The latency is a third of that of
    `scaled_to_unit`, which matters for rays that are prepared one at a time.
    """
    half_error = fma(-0.5 * v[0], v[0], fma(-0.5 * v[1], v[1], fma(-0.5 * v[2], v[2], 0.5)))
    if wp.abs(half_error) < _ALMOST_UNIT:
        return wp.vec4(fma(v[0], half_error, v[0]), fma(v[1], half_error, v[1]), fma(v[2], half_error, v[2]), half_error)
    return scaled_to_unit(v)


@wp.func
def normalize(v: wp.vec3) -> wp.vec3:
    """Return v / abs(v) for a finite v of length 1e-45 to 3e38; the zero vector where v is zero, NaN or infinite."""
    unit = scaled_to_unit(v)
    if wp.abs(unit[3]) < 0.1:
        return wp.vec3(unit[0], unit[1], unit[2])
    return wp.vec3(0.0)


@wp.func
def lesser(a: wp.float32, b: wp.float32) -> wp.float32:
    """Return the minimum of two numbers, neither NaN, in one instruction; `wp.min` also tests for NaN."""
    return wp.where(a < b, a, b)


@wp.func
def greater(a: wp.float32, b: wp.float32) -> wp.float32:
    """Return the maximum of two numbers, neither NaN, in one instruction."""
    return wp.where(a > b, a, b)


@wp.func
def negative(x: wp.float32) -> wp.float32:
    """Return -x as a product, which can fuse with a following sum; Warp's own minus subtracts from 0."""
    return wp.float32(-1.0) * x


@wp.func
def lowest_bit(mask: wp.int32) -> wp.int32:
    """Return the index of the lowest set bit of a mask that is not 0."""
    return wp.bit_count((mask & (-mask)) - 1)
