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
static wp::vec_t<3, wp::int32> _reader__locals__read_6(
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
    wp::array_t<wp::vec_t<3, wp::int32>> var_6;
    const wp::int32 var_7 = 1;
    const wp::int32 var_8 = 0;
    wp::vec_t<3, wp::int32>* var_9;
    wp::vec_t<3, wp::int32> var_10;
    wp::vec_t<3, wp::int32> var_11;
    //---------
    // forward
    // def read(address: wp.uint64, i: Any):                                                  <L 1>
    // return wp.array(ptr=address + wp.uint64(i) * wp.uint64(size), shape=(1,), dtype=kind)[0]       <L 2>
    var_0 = wp::uint64(var_i);
    var_1 = 12ull;
    var_2 = wp::mul(var_0, var_1);
    var_3 = wp::add(var_address, var_2);
    var_5 = wp::tuple(var_4);
    var_6 = wp::array_t<wp::vec_t<3, wp::int32>>(var_3, var_7);
    var_9 = wp::address(var_6, var_8);
    var_11 = wp::load(var_9);
    var_10 = wp::copy(var_11);
    return var_10;
}


// /work/main/warpsample/maths/memory.py:0
static wp::vec_t<3, wp::float32> _reader__locals__read_5(
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
    wp::array_t<wp::vec_t<3, wp::float32>> var_6;
    const wp::int32 var_7 = 1;
    const wp::int32 var_8 = 0;
    wp::vec_t<3, wp::float32>* var_9;
    wp::vec_t<3, wp::float32> var_10;
    wp::vec_t<3, wp::float32> var_11;
    //---------
    // forward
    // def read(address: wp.uint64, i: Any):                                                  <L 1>
    // return wp.array(ptr=address + wp.uint64(i) * wp.uint64(size), shape=(1,), dtype=kind)[0]       <L 2>
    var_0 = wp::uint64(var_i);
    var_1 = 12ull;
    var_2 = wp::mul(var_0, var_1);
    var_3 = wp::add(var_address, var_2);
    var_5 = wp::tuple(var_4);
    var_6 = wp::array_t<wp::vec_t<3, wp::float32>>(var_3, var_7);
    var_9 = wp::address(var_6, var_8);
    var_11 = wp::load(var_9);
    var_10 = wp::copy(var_11);
    return var_10;
}


// /work/main/warpsample/maths/memory.py:0
static void adj__reader__locals__read_6(
    wp::uint64 var_address,
    wp::int32 var_i,
    wp::uint64 & adj_address,
    wp::int32 & adj_i,
    wp::vec_t<3, wp::int32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/maths/memory.py:0
static void adj__reader__locals__read_5(
    wp::uint64 var_address,
    wp::int32 var_i,
    wp::uint64 & adj_address,
    wp::int32 & adj_i,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}

struct wp_args__triangle_boxes__locals__triangle_boxes_96b6f416 {
    wp::uint64 vertices;
    wp::uint64 faces;
    wp::uint64 lower;
    wp::uint64 upper;
    wp::int64 first_task;
};


template <bool wp_linear_contiguous>
static void _triangle_boxes__locals__triangle_boxes_96b6f416_cpu_kernel_forward(
    wp::launch_bounds_t<1> dim,
    size_t task_index,
    wp_args__triangle_boxes__locals__triangle_boxes_96b6f416 *_wp_args)
{
    static constexpr bool wp_linear_tid = wp_linear_contiguous;

    //---------
    // argument vars
    wp::uint64 var_vertices = _wp_args->vertices;
    wp::uint64 var_faces = _wp_args->faces;
    wp::uint64 var_lower = _wp_args->lower;
    wp::uint64 var_upper = _wp_args->upper;
    wp::int64 var_first_task = _wp_args->first_task;
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int32 var_1;
    wp::int32 var_2;
    wp::vec_t<3, wp::int32> var_3;
    const wp::int32 var_4 = 0;
    wp::int32 var_5;
    wp::vec_t<3, wp::float32> var_6;
    const wp::int32 var_7 = 1;
    wp::int32 var_8;
    wp::vec_t<3, wp::float32> var_9;
    const wp::int32 var_10 = 2;
    wp::int32 var_11;
    wp::vec_t<3, wp::float32> var_12;
    wp::vec_t<3, wp::float32> var_13;
    wp::vec_t<3, wp::float32> var_14;
    wp::vec_t<3, wp::float32> var_15;
    wp::vec_t<3, wp::float32> var_16;
    const wp::int32 var_17 = 1;
    wp::int32 var_18;
    wp::tuple_t<wp::int32> var_19;
    wp::array_t<wp::vec_t<4, wp::float32>> var_20;
    const wp::int32 var_21 = 1;
    wp::int32 var_22;
    wp::tuple_t<wp::int32> var_23;
    wp::array_t<wp::vec_t<4, wp::float32>> var_24;
    const wp::int32 var_25 = 0;
    wp::float32 var_26;
    const wp::int32 var_27 = 1;
    wp::float32 var_28;
    const wp::int32 var_29 = 2;
    wp::float32 var_30;
    wp::float32 var_31;
    wp::vec_t<4, wp::float32> var_32;
    const wp::int32 var_33 = 0;
    wp::float32 var_34;
    const wp::int32 var_35 = 1;
    wp::float32 var_36;
    const wp::int32 var_37 = 2;
    wp::float32 var_38;
    const wp::float32 var_39 = 0.0;
    wp::vec_t<4, wp::float32> var_40;
    //---------
    // forward
    // def triangle_boxes(vertices: wp.uint64, faces: wp.uint64, lower: wp.uint64, upper: wp.uint64, first_task: wp.int64):       <L 103>
    // i = wp.int32(first_task) + wp.tid()                                                    <L 104>
    var_0 = wp::int32(var_first_task);
    var_1 = builtin_tid1d();
    var_2 = wp::add(var_0, var_1);
    // corners = vec3i_at(faces, i)                                                           <L 105>
    var_3 = _reader__locals__read_6(var_faces, var_2);
    // a = vec3_at(vertices, corners[0])                                                      <L 106>
    var_5 = wp::extract(var_3, var_4);
    var_6 = _reader__locals__read_5(var_vertices, var_5);
    // b = vec3_at(vertices, corners[1])                                                      <L 107>
    var_8 = wp::extract(var_3, var_7);
    var_9 = _reader__locals__read_5(var_vertices, var_8);
    // c = vec3_at(vertices, corners[2])                                                      <L 108>
    var_11 = wp::extract(var_3, var_10);
    var_12 = _reader__locals__read_5(var_vertices, var_11);
    // low = wp.min(wp.min(a, b), c)                                                          <L 109>
    var_13 = wp::min(var_6, var_9);
    var_14 = wp::min(var_13, var_12);
    // high = wp.max(wp.max(a, b), c)                                                         <L 110>
    var_15 = wp::max(var_6, var_9);
    var_16 = wp::max(var_15, var_12);
    // lows = wp.array(ptr=lower, shape=(i + 1,), dtype=wp.vec4)                              <L 111>
    var_18 = wp::add(var_2, var_17);
    var_19 = wp::tuple(var_18);
    var_20 = wp::array_t<wp::vec_t<4, wp::float32>>(var_lower, var_18);
    // highs = wp.array(ptr=upper, shape=(i + 1,), dtype=wp.vec4)                             <L 112>
    var_22 = wp::add(var_2, var_21);
    var_23 = wp::tuple(var_22);
    var_24 = wp::array_t<wp::vec_t<4, wp::float32>>(var_upper, var_22);
    // lows[i] = wp.vec4(low[0], low[1], low[2], wp.cast(i, wp.float32))                      <L 113>
    var_26 = wp::extract(var_14, var_25);
    var_28 = wp::extract(var_14, var_27);
    var_30 = wp::extract(var_14, var_29);
    var_31 = wp::cast<wp::float32>(var_2);
    var_32 = wp::vec_t<4, wp::float32>(var_26, var_28, var_30, var_31);
    wp::array_store(var_20, var_2, var_32);
    // highs[i] = wp.vec4(high[0], high[1], high[2], 0.0)                                     <L 114>
    var_34 = wp::extract(var_16, var_33);
    var_36 = wp::extract(var_16, var_35);
    var_38 = wp::extract(var_16, var_37);
    var_40 = wp::vec_t<4, wp::float32>(var_34, var_36, var_38, var_39);
    wp::array_store(var_24, var_2, var_40);
}



template <bool wp_linear_contiguous>
static WP_FORCEINLINE void _triangle_boxes__locals__triangle_boxes_96b6f416_cpu_forward_tasks(
    wp::launch_bounds_t<1> *dim,
    wp_args__triangle_boxes__locals__triangle_boxes_96b6f416 *_wp_args)
{
    for (size_t task_index = 0; task_index < dim->size; ++task_index)
    {
        _triangle_boxes__locals__triangle_boxes_96b6f416_cpu_kernel_forward<wp_linear_contiguous>(*dim, task_index, _wp_args);
    }
}

static WP_FORCEINLINE void _triangle_boxes__locals__triangle_boxes_96b6f416_cpu_forward_dispatch(
    wp::launch_bounds_t<1> *dim,
    wp_args__triangle_boxes__locals__triangle_boxes_96b6f416 *_wp_args)
{
    wp::tile_shared_storage_t tile_mem;
#if defined(WP_ENABLE_TILES_IN_STACK_MEMORY)
    wp::shared_tile_storage = &tile_mem;
#endif

    _triangle_boxes__locals__triangle_boxes_96b6f416_cpu_forward_tasks<false>(dim, _wp_args);
}

extern "C" {

// Python CPU entry points
WP_API void _triangle_boxes__locals__triangle_boxes_96b6f416_cpu_forward(
    wp::launch_bounds_t<1> *dim,
    wp_args__triangle_boxes__locals__triangle_boxes_96b6f416 *_wp_args)
{
    _triangle_boxes__locals__triangle_boxes_96b6f416_cpu_forward_dispatch(dim, _wp_args);
}

} // extern C

