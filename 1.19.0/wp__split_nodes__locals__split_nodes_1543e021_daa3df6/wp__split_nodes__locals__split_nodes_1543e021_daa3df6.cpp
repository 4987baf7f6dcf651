#define WP_NO_BFLOAT16

#define WP_TILE_BLOCK_DIM 1
#define WP_NO_CRT
#include "builtin.h"
#include "deterministic.h"

#define builtin_tid1d() wp::linear_tid<wp_linear_tid>(task_index, dim)
#define builtin_tid2d(x, y) wp::tid(x, y, task_index, dim)
#define builtin_tid3d(x, y, z) wp::tid(x, y, z, task_index, dim)
#define builtin_tid4d(x, y, z, w) wp::tid(x, y, z, w, task_index, dim)

#define builtin_block_dim() wp::block_dim()


// avoid namespacing of float type for casting to float type, this is to avoid wp::float(x), which is not valid in C++
#define float(x) cast_float(x)
#define adj_float(x, adj_x, adj_ret) adj_cast_float(x, adj_x, adj_ret)

#define int(x) cast_int(x)
#define adj_int(x, adj_x, adj_ret) adj_cast_int(x, adj_x, adj_ret)


// /work/main/warpsample/maths/memory.py:0
static wp::int32 _reader__locals__read_1(
    wp::uint64 var_address,
    wp::int32 var_i)
{
    //---------
    // primal vars
    wp::uint64 var_0;
    wp::uint64 var_1;
    wp::uint64 var_2;
    wp::uint64 var_3;
    const wp::int32 var_4 = 1;
    wp::tuple_t<wp::int32> var_5;
    wp::array_t<wp::int32> var_6;
    const wp::int32 var_7 = 1;
    const wp::int32 var_8 = 0;
    wp::int32* var_9;
    wp::int32 var_10;
    wp::int32 var_11;
    //---------
    // forward
    // def read(address: wp.uint64, i: Any):                                                  <L 1>
    // return wp.array(ptr=address + wp.uint64(i) * wp.uint64(size), shape=(1,), dtype=kind)[0]       <L 2>
    var_0 = wp::uint64(var_i);
    var_1 = 4ull;
    var_2 = wp::mul(var_0, var_1);
    var_3 = wp::add(var_address, var_2);
    var_5 = wp::tuple(var_4);
    var_6 = wp::array_t<wp::int32>(var_3, var_7);
    var_9 = wp::address(var_6, var_8);
    var_11 = wp::load(var_9);
    var_10 = wp::copy(var_11);
    return var_10;
}


// /work/main/warpsample/tracing/wide/build.py:119
static wp::int32 _largest_0(
    wp::int32 var_by_area,
    wp::int32 var_children,
    wp::array_t<wp::int32> var_begins,
    wp::array_t<wp::int32> var_ends,
    wp::array_t<wp::float32> var_areas)
{
    //---------
    // primal vars
    const wp::int32 var_0 = -1;
    wp::int32 var_1;
    const wp::float32 var_2 = -1.0;
    wp::float32 var_3;
    wp::range_t var_4;
    wp::int32 var_5;
    wp::int32* var_6;
    wp::int32* var_7;
    wp::int32 var_8;
    wp::int32 var_9;
    wp::int32 var_10;
    const wp::int32 var_11 = 0;
    bool var_12;
    wp::float32* var_13;
    wp::float32 var_14;
    wp::float32 var_15;
    wp::float32 var_16;
    bool var_17;
    const wp::int32 var_18 = 16;
    bool var_19;
    bool var_20;
    wp::float32 var_21;
    wp::int32 var_22;
    wp::int32 var_23;
    wp::float32 var_24;
    //---------
    // forward
    // def _largest(                                                                          <L 120>
    // largest = wp.int32(-1)                                                                 <L 128>
    var_1 = wp::int32(var_0);
    // most = wp.float32(-1.0)                                                                <L 129>
    var_3 = wp::float32(var_2);
    // for k in range(children):                                                              <L 130>
    var_4 = wp::range(var_children);
    start_for_0:;
        if (iter_cmp(var_4) == 0) goto end_for_0;
        var_5 = wp::iter_next(var_4);
        // size = ends[k] - begins[k]                                                         <L 131>
        var_6 = wp::address(var_ends, var_5);
        var_7 = wp::address(var_begins, var_5);
        var_9 = wp::load(var_6);
        var_10 = wp::load(var_7);
        var_8 = wp::sub(var_9, var_10);
        // weight = wp.where(by_area != 0, areas[k], wp.float32(size))                        <L 132>
        var_12 = (var_by_area != var_11);
        var_13 = wp::address(var_areas, var_5);
        var_14 = wp::float32(var_8);
        var_16 = wp::load(var_13);
        var_15 = wp::where(var_12, var_16, var_14);
        // if size > WIDTH and weight > most:                                                 <L 133>
        var_19 = (var_8 > var_18);
        var_17 = var_19;
        if (var_17) {
            var_20 = (var_15 > var_3);
            var_17 = var_17 && var_20;
        }
        if (var_17) {
            // most = weight                                                                  <L 134>
            var_21 = wp::copy(var_15);
            // largest = k                                                                    <L 135>
            var_22 = wp::copy(var_5);
        }
        var_23 = wp::where(var_17, var_22, var_1);
        var_24 = wp::where(var_17, var_21, var_3);
        wp::assign(var_1, var_23);
        wp::assign(var_3, var_24);
        goto start_for_0;
    end_for_0:;
    // return largest                                                                         <L 136>
    return var_1;
}


// /work/main/warpsample/tracing/wide/sah.py:18
static wp::vec_t<3, wp::float32> _xyz_0(
    wp::vec_t<4, wp::float32> var_v)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float32 var_1;
    const wp::int32 var_2 = 1;
    wp::float32 var_3;
    const wp::int32 var_4 = 2;
    wp::float32 var_5;
    wp::vec_t<3, wp::float32> var_6;
    //---------
    // forward
    // def _xyz(v: wp.vec4) -> wp.vec3:                                                       <L 19>
    // return wp.vec3(v[0], v[1], v[2])                                                       <L 21>
    var_1 = wp::extract(var_v, var_0);
    var_3 = wp::extract(var_v, var_2);
    var_5 = wp::extract(var_v, var_4);
    var_6 = wp::vec_t<3, wp::float32>(var_1, var_3, var_5);
    return var_6;
}


// /work/main/warpsample/tracing/wide/sah.py:37
static void centres_0(
    wp::array_t<wp::vec_t<4, wp::float32>> var_lower,
    wp::array_t<wp::vec_t<4, wp::float32>> var_upper,
    wp::int32 var_begin,
    wp::int32 var_end,
    wp::vec_t<3, wp::float32> & ret_0,
    wp::vec_t<3, wp::float32> & ret_1)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 1e+30;
    wp::vec_t<3, wp::float32> var_1;
    wp::float32 var_2;
    wp::vec_t<3, wp::float32> var_3;
    wp::range_t var_4;
    wp::int32 var_5;
    wp::vec_t<4, wp::float32>* var_6;
    wp::vec_t<3, wp::float32> var_7;
    wp::vec_t<4, wp::float32> var_8;
    wp::vec_t<4, wp::float32>* var_9;
    wp::vec_t<3, wp::float32> var_10;
    wp::vec_t<4, wp::float32> var_11;
    wp::vec_t<3, wp::float32> var_12;
    wp::vec_t<3, wp::float32> var_13;
    wp::vec_t<3, wp::float32> var_14;
    //---------
    // forward
    // def centres(lower: wp.array[wp.vec4], upper: wp.array[wp.vec4], begin: wp.int32, end: wp.int32):       <L 38>
    // low = wp.vec3(LARGE)                                                                   <L 40>
    var_1 = wp::vec_t<3, wp::float32>(var_0);
    // high = wp.vec3(-LARGE)                                                                 <L 41>
    var_2 = wp::neg(var_0);
    var_3 = wp::vec_t<3, wp::float32>(var_2);
    // for i in range(begin, end):                                                            <L 42>
    var_4 = wp::range(var_begin, var_end);
    start_for_0:;
        if (iter_cmp(var_4) == 0) goto end_for_0;
        var_5 = wp::iter_next(var_4);
        // centre = _xyz(lower[i]) + _xyz(upper[i])                                           <L 43>
        var_6 = wp::address(var_lower, var_5);
        var_8 = wp::load(var_6);
        var_7 = _xyz_0(var_8);
        var_9 = wp::address(var_upper, var_5);
        var_11 = wp::load(var_9);
        var_10 = _xyz_0(var_11);
        var_12 = wp::add(var_7, var_10);
        // low = wp.min(low, centre)                                                          <L 44>
        var_13 = wp::min(var_1, var_12);
        // high = wp.max(high, centre)                                                        <L 45>
        var_14 = wp::max(var_3, var_12);
        wp::assign(var_1, var_13);
        wp::assign(var_3, var_14);
        goto start_for_0;
    end_for_0:;
    // return low, high                                                                       <L 46>
    ret_0 = var_1;
    ret_1 = var_3;
    return;
}


// /work/main/warpsample/tracing/wide/sah.py:49
static void _add_to_bin_0(
    wp::int32 var_k,
    wp::vec_t<3, wp::float32> var_low,
    wp::vec_t<3, wp::float32> var_high,
    wp::array_t<wp::vec_t<3, wp::float32>> var_lows,
    wp::array_t<wp::vec_t<3, wp::float32>> var_highs,
    wp::array_t<wp::int32> var_counts)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float32>* var_0;
    wp::vec_t<3, wp::float32> var_1;
    wp::vec_t<3, wp::float32> var_2;
    wp::vec_t<3, wp::float32>* var_3;
    wp::vec_t<3, wp::float32> var_4;
    wp::vec_t<3, wp::float32> var_5;
    wp::int32* var_6;
    const wp::int32 var_7 = 1;
    wp::int32 var_8;
    wp::int32 var_9;
    //---------
    // forward
    // def _add_to_bin(                                                                       <L 50>
    // lows[k] = wp.min(lows[k], low)                                                         <L 54>
    var_0 = wp::address(var_lows, var_k);
    var_2 = wp::load(var_0);
    var_1 = wp::min(var_2, var_low);
    wp::array_store(var_lows, var_k, var_1);
    // highs[k] = wp.max(highs[k], high)                                                      <L 55>
    var_3 = wp::address(var_highs, var_k);
    var_5 = wp::load(var_3);
    var_4 = wp::max(var_5, var_high);
    wp::array_store(var_highs, var_k, var_4);
    // counts[k] = counts[k] + 1                                                              <L 56>
    var_6 = wp::address(var_counts, var_k);
    var_9 = wp::load(var_6);
    var_8 = wp::add(var_9, var_7);
    wp::array_store(var_counts, var_k, var_8);
}


// /work/main/warpsample/tracing/wide/sah.py:59
static void fill_bins_0(
    wp::array_t<wp::vec_t<4, wp::float32>> var_lower,
    wp::array_t<wp::vec_t<4, wp::float32>> var_upper,
    wp::int32 var_begin,
    wp::int32 var_end,
    wp::vec_t<3, wp::float32> var_start,
    wp::vec_t<3, wp::float32> var_scale,
    wp::array_t<wp::vec_t<3, wp::float32>> var_lows,
    wp::array_t<wp::vec_t<3, wp::float32>> var_highs,
    wp::array_t<wp::int32> var_counts)
{
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int32 var_1;
    const wp::float32 var_2 = 1e+30;
    wp::vec_t<3, wp::float32> var_3;
    wp::float32 var_4;
    wp::vec_t<3, wp::float32> var_5;
    const wp::int32 var_6 = 0;
    wp::range_t var_7;
    wp::int32 var_8;
    wp::vec_t<4, wp::float32>* var_9;
    wp::vec_t<3, wp::float32> var_10;
    wp::vec_t<4, wp::float32> var_11;
    wp::vec_t<4, wp::float32>* var_12;
    wp::vec_t<3, wp::float32> var_13;
    wp::vec_t<4, wp::float32> var_14;
    wp::vec_t<3, wp::float32> var_15;
    wp::vec_t<3, wp::float32> var_16;
    wp::vec_t<3, wp::float32> var_17;
    const wp::int32 var_18 = 0;
    wp::float32 var_19;
    wp::int32 var_20;
    const wp::int32 var_21 = 16;
    const wp::int32 var_22 = 1;
    wp::float32 var_23;
    wp::int32 var_24;
    wp::int32 var_25;
    const wp::int32 var_26 = 2;
    wp::int32 var_27;
    const wp::int32 var_28 = 2;
    wp::float32 var_29;
    wp::int32 var_30;
    wp::int32 var_31;
    //---------
    // forward
    // def fill_bins(                                                                         <L 60>
    // for k in range(ALL_BINS):                                                              <L 75>
    var_0 = 0;
    start_for_0:;
        if (var_0 >= 48) goto end_for_0;
        var_1 = var_0;
        var_0 += 1;
        // lows[k] = wp.vec3(LARGE)                                                           <L 76>
        var_3 = wp::vec_t<3, wp::float32>(var_2);
        wp::array_store(var_lows, var_1, var_3);
        // highs[k] = wp.vec3(-LARGE)                                                         <L 77>
        var_4 = wp::neg(var_2);
        var_5 = wp::vec_t<3, wp::float32>(var_4);
        wp::array_store(var_highs, var_1, var_5);
        // counts[k] = 0                                                                      <L 78>
        wp::array_store(var_counts, var_1, var_6);
        goto start_for_0;
    end_for_0:;
    // for i in range(begin, end):                                                            <L 79>
    var_7 = wp::range(var_begin, var_end);
    start_for_2:;
        if (iter_cmp(var_7) == 0) goto end_for_2;
        var_8 = wp::iter_next(var_7);
        // low = _xyz(lower[i])                                                               <L 80>
        var_9 = wp::address(var_lower, var_8);
        var_11 = wp::load(var_9);
        var_10 = _xyz_0(var_11);
        // high = _xyz(upper[i])                                                              <L 81>
        var_12 = wp::address(var_upper, var_8);
        var_14 = wp::load(var_12);
        var_13 = _xyz_0(var_14);
        // bin = wp.cw_mul(low + high - start, scale)                                         <L 82>
        var_15 = wp::add(var_10, var_13);
        var_16 = wp::sub(var_15, var_start);
        var_17 = wp::cw_mul(var_16, var_scale);
        // _add_to_bin(wp.int32(bin[0]), low, high, lows, highs, counts)                      <L 83>
        var_19 = wp::extract(var_17, var_18);
        var_20 = wp::int32(var_19);
        _add_to_bin_0(var_20, var_10, var_13, var_lows, var_highs, var_counts);
        // _add_to_bin(BINS + wp.int32(bin[1]), low, high, lows, highs, counts)               <L 84>
        var_23 = wp::extract(var_17, var_22);
        var_24 = wp::int32(var_23);
        var_25 = wp::add(var_21, var_24);
        _add_to_bin_0(var_25, var_10, var_13, var_lows, var_highs, var_counts);
        // _add_to_bin(2 * BINS + wp.int32(bin[2]), low, high, lows, highs, counts)           <L 85>
        var_27 = wp::mul(var_26, var_21);
        var_29 = wp::extract(var_17, var_28);
        var_30 = wp::int32(var_29);
        var_31 = wp::add(var_27, var_30);
        _add_to_bin_0(var_31, var_10, var_13, var_lows, var_highs, var_counts);
        goto start_for_2;
    end_for_2:;
}


// /work/main/warpsample/tracing/wide/sah.py:24
static wp::float32 _half_area_0(
    wp::vec_t<3, wp::float32> var_low,
    wp::vec_t<3, wp::float32> var_high)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float32> var_0;
    const wp::int32 var_1 = 0;
    wp::float32 var_2;
    const wp::int32 var_3 = 1;
    wp::float32 var_4;
    wp::float32 var_5;
    const wp::int32 var_6 = 1;
    wp::float32 var_7;
    const wp::int32 var_8 = 2;
    wp::float32 var_9;
    wp::float32 var_10;
    wp::float32 var_11;
    const wp::int32 var_12 = 2;
    wp::float32 var_13;
    const wp::int32 var_14 = 0;
    wp::float32 var_15;
    wp::float32 var_16;
    wp::float32 var_17;
    //---------
    // forward
    // def _half_area(low: wp.vec3, high: wp.vec3) -> wp.float32:                             <L 25>
    // d = high - low                                                                         <L 27>
    var_0 = wp::sub(var_high, var_low);
    // return d[0] * d[1] + d[1] * d[2] + d[2] * d[0]                                         <L 28>
    var_2 = wp::extract(var_0, var_1);
    var_4 = wp::extract(var_0, var_3);
    var_5 = wp::mul(var_2, var_4);
    var_7 = wp::extract(var_0, var_6);
    var_9 = wp::extract(var_0, var_8);
    var_10 = wp::mul(var_7, var_9);
    var_11 = wp::add(var_5, var_10);
    var_13 = wp::extract(var_0, var_12);
    var_15 = wp::extract(var_0, var_14);
    var_16 = wp::mul(var_13, var_15);
    var_17 = wp::add(var_11, var_16);
    return var_17;
}


// /work/main/warpsample/tracing/wide/sah.py:31
static wp::float32 _leaf_count_0(
    wp::int32 var_triangles)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 16;
    wp::int32 var_1;
    const wp::int32 var_2 = 1;
    wp::int32 var_3;
    wp::int32 var_4;
    wp::float32 var_5;
    //---------
    // forward
    // def _leaf_count(triangles: wp.int32) -> wp.float32:                                    <L 32>
    // return wp.float32((triangles + WIDTH - 1) / WIDTH)                                     <L 34>
    var_1 = wp::add(var_triangles, var_0);
    var_3 = wp::sub(var_1, var_2);
    var_4 = wp::div(var_3, var_0);
    var_5 = wp::float32(var_4);
    return var_5;
}


// /work/main/warpsample/tracing/wide/sah.py:88
static void best_split_0(
    wp::int32 var_triangles,
    wp::array_t<wp::vec_t<3, wp::float32>> var_lows,
    wp::array_t<wp::vec_t<3, wp::float32>> var_highs,
    wp::array_t<wp::int32> var_counts,
    wp::array_t<wp::float32> var_right,
    wp::int32 & ret_0,
    wp::float32 & ret_1,
    wp::float32 & ret_2)
{
    //---------
    // primal vars
    const wp::int32 var_0 = -1;
    wp::int32 var_1;
    const wp::float32 var_2 = 3e+38;
    wp::float32 var_3;
    const wp::float32 var_4 = 0.0;
    wp::float32 var_5;
    const wp::float32 var_6 = 0.0;
    wp::float32 var_7;
    const wp::int32 var_8 = 0;
    wp::int32 var_9;
    const wp::int32 var_10 = 48;
    bool var_11;
    const wp::float32 var_12 = 1e+30;
    wp::vec_t<3, wp::float32> var_13;
    wp::float32 var_14;
    wp::vec_t<3, wp::float32> var_15;
    const wp::int32 var_16 = 16;
    wp::int32 var_17;
    const wp::int32 var_18 = 1;
    wp::int32 var_19;
    bool var_20;
    wp::vec_t<3, wp::float32>* var_21;
    wp::vec_t<3, wp::float32> var_22;
    wp::vec_t<3, wp::float32> var_23;
    wp::vec_t<3, wp::float32>* var_24;
    wp::vec_t<3, wp::float32> var_25;
    wp::vec_t<3, wp::float32> var_26;
    wp::float32 var_27;
    const wp::int32 var_28 = 1;
    wp::int32 var_29;
    wp::vec_t<3, wp::float32> var_30;
    wp::float32 var_31;
    wp::vec_t<3, wp::float32> var_32;
    const wp::int32 var_33 = 0;
    wp::int32 var_34;
    wp::int32 var_35;
    const wp::int32 var_36 = 1;
    wp::int32 var_37;
    wp::range_t var_38;
    wp::int32 var_39;
    wp::vec_t<3, wp::float32>* var_40;
    wp::vec_t<3, wp::float32> var_41;
    wp::vec_t<3, wp::float32> var_42;
    wp::vec_t<3, wp::float32>* var_43;
    wp::vec_t<3, wp::float32> var_44;
    wp::vec_t<3, wp::float32> var_45;
    wp::int32* var_46;
    wp::int32 var_47;
    wp::int32 var_48;
    bool var_49;
    const wp::int32 var_50 = 0;
    bool var_51;
    bool var_52;
    wp::float32 var_53;
    wp::float32 var_54;
    wp::float32 var_55;
    const wp::int32 var_56 = 1;
    wp::int32 var_57;
    wp::float32* var_58;
    wp::int32 var_59;
    wp::float32 var_60;
    wp::float32 var_61;
    wp::float32 var_62;
    wp::float32 var_63;
    bool var_64;
    wp::float32 var_65;
    wp::int32 var_66;
    wp::float32 var_67;
    const wp::int32 var_68 = 1;
    wp::int32 var_69;
    wp::float32* var_70;
    wp::float32 var_71;
    wp::float32 var_72;
    wp::int32 var_73;
    wp::float32 var_74;
    wp::float32 var_75;
    wp::float32 var_76;
    wp::int32 var_77;
    wp::float32 var_78;
    wp::float32 var_79;
    wp::float32 var_80;
    wp::int32 var_81;
    //---------
    // forward
    // def best_split(                                                                        <L 89>
    // best = wp.int32(-1)                                                                    <L 100>
    var_1 = wp::int32(var_0);
    // least = wp.float32(_MOST_COST)                                                         <L 101>
    var_3 = wp::float32(var_2);
    // left_area = wp.float32(0.0)                                                            <L 102>
    var_5 = wp::float32(var_4);
    // right_area = wp.float32(0.0)                                                           <L 103>
    var_7 = wp::float32(var_6);
    // first = wp.int32(0)                                                                    <L 104>
    var_9 = wp::int32(var_8);
    // while first < ALL_BINS:  # the compiler would unroll `range` and take twice as long       <L 105>
    start_while_0:;
    var_11 = (var_9 < var_10);
    if ((var_11) == false) goto end_while_0;
        // low = wp.vec3(LARGE)                                                               <L 106>
        var_13 = wp::vec_t<3, wp::float32>(var_12);
        // high = wp.vec3(-LARGE)                                                             <L 107>
        var_14 = wp::neg(var_12);
        var_15 = wp::vec_t<3, wp::float32>(var_14);
        // k = first + BINS - 1                                                               <L 108>
        var_17 = wp::add(var_9, var_16);
        var_19 = wp::sub(var_17, var_18);
        // while k > first:                                                                   <L 109>
    start_while_2:;
        var_20 = (var_19 > var_9);
    if ((var_20) == false) goto end_while_2;
            // low = wp.min(low, lows[k])                                                     <L 110>
            var_21 = wp::address(var_lows, var_19);
            var_23 = wp::load(var_21);
            var_22 = wp::min(var_13, var_23);
            // high = wp.max(high, highs[k])                                                  <L 111>
            var_24 = wp::address(var_highs, var_19);
            var_26 = wp::load(var_24);
            var_25 = wp::max(var_15, var_26);
            // right[k] = _half_area(low, high)                                               <L 112>
            var_27 = _half_area_0(var_22, var_25);
            wp::array_store(var_right, var_19, var_27);
            // k -= 1                                                                         <L 113>
            var_29 = wp::sub(var_19, var_28);
            wp::assign(var_13, var_22);
            wp::assign(var_15, var_25);
            wp::assign(var_19, var_29);
    goto start_while_2;
    end_while_2:;
        // low = wp.vec3(LARGE)                                                               <L 114>
        var_30 = wp::vec_t<3, wp::float32>(var_12);
        // high = wp.vec3(-LARGE)                                                             <L 115>
        var_31 = wp::neg(var_12);
        var_32 = wp::vec_t<3, wp::float32>(var_31);
        // count = wp.int32(0)                                                                <L 116>
        var_34 = wp::int32(var_33);
        // for k in range(first, first + BINS - 1):                                           <L 117>
        var_35 = wp::add(var_9, var_16);
        var_37 = wp::sub(var_35, var_36);
        var_38 = wp::range(var_9, var_37);
        start_for_4:;
            if (iter_cmp(var_38) == 0) goto end_for_4;
            var_39 = wp::iter_next(var_38);
            // low = wp.min(low, lows[k])                                                     <L 118>
            var_40 = wp::address(var_lows, var_39);
            var_42 = wp::load(var_40);
            var_41 = wp::min(var_30, var_42);
            // high = wp.max(high, highs[k])                                                  <L 119>
            var_43 = wp::address(var_highs, var_39);
            var_45 = wp::load(var_43);
            var_44 = wp::max(var_32, var_45);
            // count += counts[k]                                                             <L 120>
            var_46 = wp::address(var_counts, var_39);
            var_48 = wp::load(var_46);
            var_47 = wp::add(var_34, var_48);
            // if count > 0 and count < triangles:                                            <L 121>
            var_51 = (var_47 > var_50);
            var_49 = var_51;
            if (var_49) {
                var_52 = (var_47 < var_triangles);
                var_49 = var_49 && var_52;
            }
            if (var_49) {
                // area = _half_area(low, high)                                               <L 122>
                var_53 = _half_area_0(var_41, var_44);
                // cost = area * _leaf_count(count) + right[k + 1] * _leaf_count(triangles - count)       <L 123>
                var_54 = _leaf_count_0(var_47);
                var_55 = wp::mul(var_53, var_54);
                var_57 = wp::add(var_39, var_56);
                var_58 = wp::address(var_right, var_57);
                var_59 = wp::sub(var_triangles, var_47);
                var_60 = _leaf_count_0(var_59);
                var_62 = wp::load(var_58);
                var_61 = wp::mul(var_62, var_60);
                var_63 = wp::add(var_55, var_61);
                // if cost < least:                                                           <L 124>
                var_64 = (var_63 < var_3);
                if (var_64) {
                    // least = cost                                                           <L 125>
                    var_65 = wp::copy(var_63);
                    // best = k                                                               <L 126>
                    var_66 = wp::copy(var_39);
                    // left_area = area                                                       <L 127>
                    var_67 = wp::copy(var_53);
                    // right_area = right[k + 1]                                              <L 128>
                    var_69 = wp::add(var_39, var_68);
                    var_70 = wp::address(var_right, var_69);
                    var_72 = wp::load(var_70);
                    var_71 = wp::copy(var_72);
                }
                var_73 = wp::where(var_64, var_66, var_1);
                var_74 = wp::where(var_64, var_65, var_3);
                var_75 = wp::where(var_64, var_67, var_5);
                var_76 = wp::where(var_64, var_71, var_7);
            }
            var_77 = wp::where(var_49, var_73, var_1);
            var_78 = wp::where(var_49, var_74, var_3);
            var_79 = wp::where(var_49, var_75, var_5);
            var_80 = wp::where(var_49, var_76, var_7);
            wp::assign(var_1, var_77);
            wp::assign(var_3, var_78);
            wp::assign(var_5, var_79);
            wp::assign(var_7, var_80);
            wp::assign(var_30, var_41);
            wp::assign(var_32, var_44);
            wp::assign(var_34, var_47);
            goto start_for_4;
        end_for_4:;
        // first += BINS                                                                      <L 129>
        var_81 = wp::add(var_9, var_16);
        wp::assign(var_9, var_81);
    goto start_while_0;
    end_while_0:;
    // return best, left_area, right_area                                                     <L 130>
    ret_0 = var_1;
    ret_1 = var_5;
    ret_2 = var_7;
    return;
}


// /work/main/warpsample/tracing/wide/sah.py:133
static wp::int32 partition_0(
    wp::array_t<wp::vec_t<4, wp::float32>> var_lower,
    wp::array_t<wp::vec_t<4, wp::float32>> var_upper,
    wp::int32 var_begin,
    wp::int32 var_end,
    wp::int32 var_axis,
    wp::float32 var_start,
    wp::float32 var_scale,
    wp::int32 var_last_bin)
{
    //---------
    // primal vars
    wp::int32 var_0;
    const wp::int32 var_1 = 1;
    wp::int32 var_2;
    bool var_3;
    wp::vec_t<4, wp::float32>* var_4;
    wp::vec_t<4, wp::float32> var_5;
    wp::vec_t<4, wp::float32> var_6;
    wp::vec_t<4, wp::float32>* var_7;
    wp::vec_t<4, wp::float32> var_8;
    wp::vec_t<4, wp::float32> var_9;
    wp::float32 var_10;
    wp::float32 var_11;
    wp::float32 var_12;
    wp::float32 var_13;
    wp::float32 var_14;
    wp::int32 var_15;
    bool var_16;
    const wp::int32 var_17 = 1;
    wp::int32 var_18;
    wp::vec_t<4, wp::float32>* var_19;
    wp::vec_t<4, wp::float32> var_20;
    wp::vec_t<4, wp::float32> var_21;
    wp::vec_t<4, wp::float32>* var_22;
    wp::vec_t<4, wp::float32> var_23;
    wp::vec_t<4, wp::float32> var_24;
    const wp::int32 var_25 = 1;
    wp::int32 var_26;
    wp::int32 var_27;
    wp::int32 var_28;
    //---------
    // forward
    // def partition(                                                                         <L 134>
    // low = begin                                                                            <L 145>
    var_0 = wp::copy(var_begin);
    // high = end - 1                                                                         <L 146>
    var_2 = wp::sub(var_end, var_1);
    // while low <= high:                                                                     <L 147>
    start_while_0:;
    var_3 = (var_0 <= var_2);
    if ((var_3) == false) goto end_while_0;
        // a = lower[low]                                                                     <L 148>
        var_4 = wp::address(var_lower, var_0);
        var_6 = wp::load(var_4);
        var_5 = wp::copy(var_6);
        // b = upper[low]                                                                     <L 149>
        var_7 = wp::address(var_upper, var_0);
        var_9 = wp::load(var_7);
        var_8 = wp::copy(var_9);
        // if wp.int32((a[axis] + b[axis] - start) * scale) <= last_bin:                      <L 150>
        var_10 = wp::extract(var_5, var_axis);
        var_11 = wp::extract(var_8, var_axis);
        var_12 = wp::add(var_10, var_11);
        var_13 = wp::sub(var_12, var_start);
        var_14 = wp::mul(var_13, var_scale);
        var_15 = wp::int32(var_14);
        var_16 = (var_15 <= var_last_bin);
        if (var_16) {
            // low += 1                                                                       <L 151>
            var_18 = wp::add(var_0, var_17);
        }
        if (!var_16) {
            // lower[low] = lower[high]                                                       <L 153>
            var_19 = wp::address(var_lower, var_2);
            var_21 = wp::load(var_19);
            var_20 = wp::copy(var_21);
            wp::array_store(var_lower, var_0, var_20);
            // upper[low] = upper[high]                                                       <L 154>
            var_22 = wp::address(var_upper, var_2);
            var_24 = wp::load(var_22);
            var_23 = wp::copy(var_24);
            wp::array_store(var_upper, var_0, var_23);
            // lower[high] = a                                                                <L 155>
            wp::array_store(var_lower, var_2, var_5);
            // upper[high] = b                                                                <L 156>
            wp::array_store(var_upper, var_2, var_8);
            // high -= 1                                                                      <L 157>
            var_26 = wp::sub(var_2, var_25);
        }
        var_27 = wp::where(var_16, var_18, var_0);
        var_28 = wp::where(var_16, var_2, var_26);
        wp::assign(var_0, var_27);
        wp::assign(var_2, var_28);
    goto start_while_0;
    end_while_0:;
    // return low                                                                             <L 158>
    return var_0;
}


// /work/main/warpsample/maths/memory.py:0
static void adj__reader__locals__read_1(
    wp::uint64 var_address,
    wp::int32 var_i,
    wp::uint64 & adj_address,
    wp::int32 & adj_i,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/wide/build.py:119
static void adj__largest_0(
    wp::int32 var_by_area,
    wp::int32 var_children,
    wp::array_t<wp::int32> var_begins,
    wp::array_t<wp::int32> var_ends,
    wp::array_t<wp::float32> var_areas,
    wp::int32 & adj_by_area,
    wp::int32 & adj_children,
    wp::array_t<wp::int32> & adj_begins,
    wp::array_t<wp::int32> & adj_ends,
    wp::array_t<wp::float32> & adj_areas,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/wide/sah.py:18
static void adj__xyz_0(
    wp::vec_t<4, wp::float32> var_v,
    wp::vec_t<4, wp::float32> & adj_v,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/wide/sah.py:37
static void adj_centres_0(
    wp::array_t<wp::vec_t<4, wp::float32>> var_lower,
    wp::array_t<wp::vec_t<4, wp::float32>> var_upper,
    wp::int32 var_begin,
    wp::int32 var_end,
    wp::vec_t<3, wp::float32> & ret_0,
    wp::vec_t<3, wp::float32> & ret_1,
    wp::array_t<wp::vec_t<4, wp::float32>> & adj_lower,
    wp::array_t<wp::vec_t<4, wp::float32>> & adj_upper,
    wp::int32 & adj_begin,
    wp::int32 & adj_end,
    wp::vec_t<3, wp::float32> & adj_ret_0,
    wp::vec_t<3, wp::float32> & adj_ret_1)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/wide/sah.py:49
static void adj__add_to_bin_0(
    wp::int32 var_k,
    wp::vec_t<3, wp::float32> var_low,
    wp::vec_t<3, wp::float32> var_high,
    wp::array_t<wp::vec_t<3, wp::float32>> var_lows,
    wp::array_t<wp::vec_t<3, wp::float32>> var_highs,
    wp::array_t<wp::int32> var_counts,
    wp::int32 & adj_k,
    wp::vec_t<3, wp::float32> & adj_low,
    wp::vec_t<3, wp::float32> & adj_high,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_lows,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_highs,
    wp::array_t<wp::int32> & adj_counts)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/wide/sah.py:59
static void adj_fill_bins_0(
    wp::array_t<wp::vec_t<4, wp::float32>> var_lower,
    wp::array_t<wp::vec_t<4, wp::float32>> var_upper,
    wp::int32 var_begin,
    wp::int32 var_end,
    wp::vec_t<3, wp::float32> var_start,
    wp::vec_t<3, wp::float32> var_scale,
    wp::array_t<wp::vec_t<3, wp::float32>> var_lows,
    wp::array_t<wp::vec_t<3, wp::float32>> var_highs,
    wp::array_t<wp::int32> var_counts,
    wp::array_t<wp::vec_t<4, wp::float32>> & adj_lower,
    wp::array_t<wp::vec_t<4, wp::float32>> & adj_upper,
    wp::int32 & adj_begin,
    wp::int32 & adj_end,
    wp::vec_t<3, wp::float32> & adj_start,
    wp::vec_t<3, wp::float32> & adj_scale,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_lows,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_highs,
    wp::array_t<wp::int32> & adj_counts)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/wide/sah.py:24
static void adj__half_area_0(
    wp::vec_t<3, wp::float32> var_low,
    wp::vec_t<3, wp::float32> var_high,
    wp::vec_t<3, wp::float32> & adj_low,
    wp::vec_t<3, wp::float32> & adj_high,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/wide/sah.py:31
static void adj__leaf_count_0(
    wp::int32 var_triangles,
    wp::int32 & adj_triangles,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/wide/sah.py:88
static void adj_best_split_0(
    wp::int32 var_triangles,
    wp::array_t<wp::vec_t<3, wp::float32>> var_lows,
    wp::array_t<wp::vec_t<3, wp::float32>> var_highs,
    wp::array_t<wp::int32> var_counts,
    wp::array_t<wp::float32> var_right,
    wp::int32 & ret_0,
    wp::float32 & ret_1,
    wp::float32 & ret_2,
    wp::int32 & adj_triangles,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_lows,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_highs,
    wp::array_t<wp::int32> & adj_counts,
    wp::array_t<wp::float32> & adj_right,
    wp::int32 & adj_ret_0,
    wp::float32 & adj_ret_1,
    wp::float32 & adj_ret_2)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/wide/sah.py:133
static void adj_partition_0(
    wp::array_t<wp::vec_t<4, wp::float32>> var_lower,
    wp::array_t<wp::vec_t<4, wp::float32>> var_upper,
    wp::int32 var_begin,
    wp::int32 var_end,
    wp::int32 var_axis,
    wp::float32 var_start,
    wp::float32 var_scale,
    wp::int32 var_last_bin,
    wp::array_t<wp::vec_t<4, wp::float32>> & adj_lower,
    wp::array_t<wp::vec_t<4, wp::float32>> & adj_upper,
    wp::int32 & adj_begin,
    wp::int32 & adj_end,
    wp::int32 & adj_axis,
    wp::float32 & adj_start,
    wp::float32 & adj_scale,
    wp::int32 & adj_last_bin,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}

struct wp_args__split_nodes__locals__split_nodes_21038941 {
    wp::int32 by_area;
    wp::uint64 lower;
    wp::uint64 upper;
    wp::uint64 begins;
    wp::uint64 ends;
    wp::uint64 child_begins;
    wp::uint64 child_ends;
    wp::uint64 child_used;
    wp::int64 first_task;
};


template <bool wp_linear_contiguous>
static void _split_nodes__locals__split_nodes_21038941_cpu_kernel_forward(
    wp::launch_bounds_t<1> dim,
    size_t task_index,
    wp_args__split_nodes__locals__split_nodes_21038941 *_wp_args)
{
    static constexpr bool wp_linear_tid = wp_linear_contiguous;

    //---------
    // argument vars
    wp::int32 var_by_area = _wp_args->by_area;
    wp::uint64 var_lower = _wp_args->lower;
    wp::uint64 var_upper = _wp_args->upper;
    wp::uint64 var_begins = _wp_args->begins;
    wp::uint64 var_ends = _wp_args->ends;
    wp::uint64 var_child_begins = _wp_args->child_begins;
    wp::uint64 var_child_ends = _wp_args->child_ends;
    wp::uint64 var_child_used = _wp_args->child_used;
    wp::int64 var_first_task = _wp_args->first_task;
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int32 var_1;
    wp::int32 var_2;
    wp::int32 var_3;
    wp::tuple_t<wp::int32> var_4;
    wp::array_t<wp::vec_t<4, wp::float32>> var_5;
    wp::tuple_t<wp::int32> var_6;
    wp::array_t<wp::vec_t<4, wp::float32>> var_7;
    wp::uint64 var_8;
    const wp::int32 var_9 = 4;
    const wp::int32 var_10 = 16;
    wp::int32 var_11;
    wp::uint64 var_12;
    wp::uint64 var_13;
    wp::uint64 var_14;
    wp::tuple_t<wp::int32> var_15;
    wp::array_t<wp::int32> var_16;
    const wp::int32 var_17 = 16;
    wp::uint64 var_18;
    wp::tuple_t<wp::int32> var_19;
    wp::array_t<wp::int32> var_20;
    const wp::int32 var_21 = 16;
    wp::uint64 var_22;
    wp::tuple_t<wp::int32> var_23;
    wp::array_t<wp::int32> var_24;
    const wp::int32 var_25 = 16;
    wp::tuple_t<wp::int32> var_26;
    wp::fixedarray_t<16, wp::float32> var_27;
    const wp::int32 var_28 = 16;
    const wp::int32 var_29 = 48;
    wp::tuple_t<wp::int32> var_30;
    wp::fixedarray_t<48, wp::vec_t<3, wp::float32>> var_31;
    const wp::int32 var_32 = 48;
    wp::tuple_t<wp::int32> var_33;
    wp::fixedarray_t<48, wp::vec_t<3, wp::float32>> var_34;
    const wp::int32 var_35 = 48;
    wp::tuple_t<wp::int32> var_36;
    wp::fixedarray_t<48, wp::int32> var_37;
    const wp::int32 var_38 = 48;
    wp::tuple_t<wp::int32> var_39;
    wp::fixedarray_t<48, wp::float32> var_40;
    const wp::int32 var_41 = 48;
    wp::int32 var_42;
    const wp::int32 var_43 = 0;
    const wp::int32 var_44 = 0;
    const wp::int32 var_45 = 1;
    const wp::int32 var_46 = 0;
    const wp::int32 var_47 = 1;
    wp::int32 var_48;
    const wp::int32 var_49 = 0;
    wp::int32 var_50;
    bool var_51;
    bool var_52;
    const wp::int32 var_53 = 0;
    bool var_54;
    wp::int32 var_55;
    const wp::int32 var_56 = 0;
    bool var_57;
    wp::int32* var_58;
    wp::int32 var_59;
    wp::int32 var_60;
    wp::int32* var_61;
    wp::int32 var_62;
    wp::int32 var_63;
    wp::int32 var_64;
    const wp::int32 var_65 = 2;
    wp::int32 var_66;
    wp::int32 var_67;
    const wp::int32 var_68 = -1;
    wp::int32 var_69;
    wp::float32* var_70;
    wp::float32 var_71;
    wp::float32 var_72;
    wp::float32 var_73;
    const wp::int32 var_74 = 0;
    bool var_75;
    wp::vec_t<3, wp::float32> var_76;
    wp::vec_t<3, wp::float32> var_77;
    wp::vec_t<3, wp::float32> var_78;
    const wp::float32 var_79 = 1e-30;
    wp::vec_t<3, wp::float32> var_80;
    wp::vec_t<3, wp::float32> var_81;
    const wp::float32 var_82 = 15.9984;
    wp::vec_t<3, wp::float32> var_83;
    wp::vec_t<3, wp::float32> var_84;
    wp::int32 var_85;
    wp::int32 var_86;
    wp::float32 var_87;
    wp::float32 var_88;
    const wp::int32 var_89 = 0;
    bool var_90;
    const wp::int32 var_91 = 16;
    wp::int32 var_92;
    wp::float32 var_93;
    wp::float32 var_94;
    wp::int32 var_95;
    wp::int32 var_96;
    wp::int32 var_97;
    wp::int32 var_98;
    wp::int32 var_99;
    wp::int32 var_100;
    wp::float32 var_101;
    wp::float32 var_102;
    const wp::int32 var_103 = 1;
    const wp::int32 var_104 = 1;
    wp::int32 var_105;
    wp::int32 var_106;
    //---------
    // forward
    // def split_nodes(                                                                       <L 144>
    // node = wp.int32(first_task) + wp.tid()                                                 <L 155>
    var_0 = wp::int32(var_first_task);
    var_1 = builtin_tid1d();
    var_2 = wp::add(var_0, var_1);
    // end = int_at(ends, node)                                                               <L 156>
    var_3 = _reader__locals__read_1(var_ends, var_2);
    // lows = wp.array(ptr=lower, shape=(end,), dtype=wp.vec4)                                <L 157>
    var_4 = wp::tuple(var_3);
    var_5 = wp::array_t<wp::vec_t<4, wp::float32>>(var_lower, var_3);
    // highs = wp.array(ptr=upper, shape=(end,), dtype=wp.vec4)                               <L 158>
    var_6 = wp::tuple(var_3);
    var_7 = wp::array_t<wp::vec_t<4, wp::float32>>(var_upper, var_3);
    // row = wp.uint64(node) * wp.uint64(4 * WIDTH)                                           <L 159>
    var_8 = wp::uint64(var_2);
    var_11 = wp::mul(var_9, var_10);
    var_12 = wp::uint64(var_11);
    var_13 = wp::mul(var_8, var_12);
    // begin_of = wp.array(ptr=child_begins + row, shape=(WIDTH,), dtype=wp.int32)            <L 160>
    var_14 = wp::add(var_child_begins, var_13);
    var_15 = wp::tuple(var_10);
    var_16 = wp::array_t<wp::int32>(var_14, var_17);
    // end_of = wp.array(ptr=child_ends + row, shape=(WIDTH,), dtype=wp.int32)                <L 161>
    var_18 = wp::add(var_child_ends, var_13);
    var_19 = wp::tuple(var_10);
    var_20 = wp::array_t<wp::int32>(var_18, var_21);
    // used = wp.array(ptr=child_used + row, shape=(WIDTH,), dtype=wp.int32)                  <L 162>
    var_22 = wp::add(var_child_used, var_13);
    var_23 = wp::tuple(var_10);
    var_24 = wp::array_t<wp::int32>(var_22, var_25);
    // area_of = wp.zeros(shape=(WIDTH,), dtype=wp.float32)                                   <L 163>
    var_26 = wp::tuple(var_10);
    var_27 = wp::fixedarray_t<16, wp::float32>(var_28);
    // bin_lows = wp.zeros(shape=(ALL_BINS,), dtype=wp.vec3)                                  <L 164>
    var_30 = wp::tuple(var_29);
    var_31 = wp::fixedarray_t<48, wp::vec_t<3, wp::float32>>(var_32);
    // bin_highs = wp.zeros(shape=(ALL_BINS,), dtype=wp.vec3)                                 <L 165>
    var_33 = wp::tuple(var_29);
    var_34 = wp::fixedarray_t<48, wp::vec_t<3, wp::float32>>(var_35);
    // bin_counts = wp.zeros(shape=(ALL_BINS,), dtype=wp.int32)                               <L 166>
    var_36 = wp::tuple(var_29);
    var_37 = wp::fixedarray_t<48, wp::int32>(var_38);
    // right = wp.zeros(shape=(ALL_BINS,), dtype=wp.float32)                                  <L 167>
    var_39 = wp::tuple(var_29);
    var_40 = wp::fixedarray_t<48, wp::float32>(var_41);
    // begin_of[0] = int_at(begins, node)                                                     <L 168>
    var_42 = _reader__locals__read_1(var_begins, var_2);
    wp::array_store(var_16, var_43, var_42);
    // end_of[0] = end                                                                        <L 169>
    wp::array_store(var_20, var_44, var_3);
    // used[0] = 1                                                                            <L 170>
    wp::array_store(var_24, var_46, var_45);
    // children = wp.int32(1)                                                                 <L 171>
    var_48 = wp::int32(var_47);
    // largest = wp.int32(0)                                                                  <L 172>
    var_50 = wp::int32(var_49);
    // while children < WIDTH and largest >= 0:                                               <L 173>
    start_while_0:;
    var_52 = (var_48 < var_10);
    var_51 = var_52;
    if (var_51) {
        var_54 = (var_50 >= var_53);
        var_51 = var_51 && var_54;
    }
    if ((var_51) == false) goto end_while_0;
        // largest = _largest(by_area, children, begin_of, end_of, area_of)                   <L 174>
        var_55 = _largest_0(var_by_area, var_48, var_16, var_20, var_27);
        // if largest >= 0:                                                                   <L 175>
        var_57 = (var_55 >= var_56);
        if (var_57) {
            // b = begin_of[largest]                                                          <L 176>
            var_58 = wp::address(var_16, var_55);
            var_60 = wp::load(var_58);
            var_59 = wp::copy(var_60);
            // e = end_of[largest]                                                            <L 177>
            var_61 = wp::address(var_20, var_55);
            var_63 = wp::load(var_61);
            var_62 = wp::copy(var_63);
            // middle = b + (e - b) / 2                                                       <L 178>
            var_64 = wp::sub(var_62, var_59);
            var_66 = wp::div(var_64, var_65);
            var_67 = wp::add(var_59, var_66);
            // split = wp.int32(-1)                                                           <L 179>
            var_69 = wp::int32(var_68);
            // left_area = area_of[largest]                                                   <L 180>
            var_70 = wp::address(var_27, var_55);
            var_72 = wp::load(var_70);
            var_71 = wp::copy(var_72);
            // right_area = left_area                                                         <L 181>
            var_73 = wp::copy(var_71);
            // if by_area != 0:                                                               <L 182>
            var_75 = (var_by_area != var_74);
            if (var_75) {
                // start, stop = centres(lows, highs, b, e)                                   <L 183>
                centres_0(var_5, var_7, var_59, var_62, var_76, var_77);
                // extent = wp.max(stop - start, wp.vec3(1.0e-30))                            <L 184>
                var_78 = wp::sub(var_77, var_76);
                var_80 = wp::vec_t<3, wp::float32>(var_79);
                var_81 = wp::max(var_78, var_80);
                // scale = wp.cw_div(wp.vec3(MOST_BINS), extent)                              <L 185>
                var_83 = wp::vec_t<3, wp::float32>(var_82);
                var_84 = wp::cw_div(var_83, var_81);
                // fill_bins(lows, highs, b, e, start, scale, bin_lows, bin_highs, bin_counts)       <L 186>
                fill_bins_0(var_5, var_7, var_59, var_62, var_76, var_84, var_31, var_34, var_37);
                // split, left_area, right_area = best_split(e - b, bin_lows, bin_highs, bin_counts, right)       <L 187>
                var_85 = wp::sub(var_62, var_59);
                best_split_0(var_85, var_31, var_34, var_37, var_40, var_86, var_87, var_88);
                // if split >= 0:                                                             <L 188>
                var_90 = (var_86 >= var_89);
                if (var_90) {
                    // axis = split / BINS                                                    <L 189>
                    var_92 = wp::div(var_86, var_91);
                    // middle = partition(lows, highs, b, e, axis, start[axis], scale[axis], split - axis * BINS)       <L 190>
                    var_93 = wp::extract(var_76, var_92);
                    var_94 = wp::extract(var_84, var_92);
                    var_95 = wp::mul(var_92, var_91);
                    var_96 = wp::sub(var_86, var_95);
                    var_97 = partition_0(var_5, var_7, var_59, var_62, var_92, var_93, var_94, var_96);
                }
                var_98 = wp::where(var_90, var_97, var_67);
            }
            var_99 = wp::where(var_75, var_98, var_67);
            var_100 = wp::where(var_75, var_86, var_69);
            var_101 = wp::where(var_75, var_87, var_71);
            var_102 = wp::where(var_75, var_88, var_73);
            // end_of[largest] = middle                                                       <L 191>
            wp::array_store(var_20, var_55, var_99);
            // area_of[largest] = left_area                                                   <L 192>
            wp::array_store(var_27, var_55, var_101);
            // begin_of[children] = middle                                                    <L 193>
            wp::array_store(var_16, var_48, var_99);
            // end_of[children] = e                                                           <L 194>
            wp::array_store(var_20, var_48, var_62);
            // area_of[children] = right_area                                                 <L 195>
            wp::array_store(var_27, var_48, var_102);
            // used[children] = 1                                                             <L 196>
            wp::array_store(var_24, var_48, var_103);
            // children += 1                                                                  <L 197>
            var_105 = wp::add(var_48, var_104);
        }
        var_106 = wp::where(var_57, var_105, var_48);
        wp::assign(var_48, var_106);
        wp::assign(var_50, var_55);
    goto start_while_0;
    end_while_0:;
}



template <bool wp_linear_contiguous>
static WP_FORCEINLINE void _split_nodes__locals__split_nodes_21038941_cpu_forward_tasks(
    wp::launch_bounds_t<1> *dim,
    wp_args__split_nodes__locals__split_nodes_21038941 *_wp_args)
{
    for (size_t task_index = 0; task_index < dim->size; ++task_index)
    {
        _split_nodes__locals__split_nodes_21038941_cpu_kernel_forward<wp_linear_contiguous>(*dim, task_index, _wp_args);
    }
}

static WP_FORCEINLINE void _split_nodes__locals__split_nodes_21038941_cpu_forward_dispatch(
    wp::launch_bounds_t<1> *dim,
    wp_args__split_nodes__locals__split_nodes_21038941 *_wp_args)
{
    wp::tile_shared_storage_t tile_mem;
#if defined(WP_ENABLE_TILES_IN_STACK_MEMORY)
    wp::shared_tile_storage = &tile_mem;
#endif

    _split_nodes__locals__split_nodes_21038941_cpu_forward_tasks<false>(dim, _wp_args);
}

extern "C" {

// Python CPU entry points
WP_API void _split_nodes__locals__split_nodes_21038941_cpu_forward(
    wp::launch_bounds_t<1> *dim,
    wp_args__split_nodes__locals__split_nodes_21038941 *_wp_args)
{
    _split_nodes__locals__split_nodes_21038941_cpu_forward_dispatch(dim, _wp_args);
}

} // extern C

