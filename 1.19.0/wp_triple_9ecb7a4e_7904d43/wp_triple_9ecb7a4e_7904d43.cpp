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

struct wp_args_triple_6003061e {
    wp::array_t<wp::int32> x;
};


template <bool wp_linear_contiguous>
static void triple_6003061e_cpu_kernel_forward(
    wp::launch_bounds_t<1> dim,
    size_t task_index,
    wp_args_triple_6003061e *_wp_args)
{
    static constexpr bool wp_linear_tid = wp_linear_contiguous;
    wp_args_triple_6003061e wp_contiguous_args;
    if constexpr (wp_linear_contiguous)
    {
        wp_contiguous_args = *_wp_args;
        wp_contiguous_args.x.strides[0] = sizeof(wp::int32);
        _wp_args = &wp_contiguous_args;
    }
    //---------
    // argument vars
    wp::array_t<wp::int32> var_x = _wp_args->x;
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int32* var_1;
    const wp::int32 var_2 = 3;
    wp::int32 var_3;
    wp::int32 var_4;
    //---------
    // forward
    // def triple(x: wp.array[wp.int32]):                                                     <L 25>
    // x[wp.tid()] *= 3                                                                       <L 26>
    var_0 = builtin_tid1d();
    var_1 = wp::address(var_x, var_0);
    var_4 = wp::load(var_1);
    var_3 = wp::mul(var_4, var_2);
    wp::array_store(var_x, var_0, var_3);
}



template <bool wp_linear_contiguous>
static WP_FORCEINLINE void triple_6003061e_cpu_forward_tasks(
    wp::launch_bounds_t<1> *dim,
    wp_args_triple_6003061e *_wp_args)
{
    for (size_t task_index = 0; task_index < dim->size; ++task_index)
    {
        triple_6003061e_cpu_kernel_forward<wp_linear_contiguous>(*dim, task_index, _wp_args);
    }
}

static WP_FORCEINLINE void triple_6003061e_cpu_forward_dispatch(
    wp::launch_bounds_t<1> *dim,
    wp_args_triple_6003061e *_wp_args)
{
    wp::tile_shared_storage_t tile_mem;
#if defined(WP_ENABLE_TILES_IN_STACK_MEMORY)
    wp::shared_tile_storage = &tile_mem;
#endif

    const bool wp_linear_contiguous = dim->coord_mult == 1 && ((_wp_args->x.strides[0] == (int)sizeof(wp::int32)));
    if (wp_linear_contiguous)
        triple_6003061e_cpu_forward_tasks<true>(dim, _wp_args);
    else
        triple_6003061e_cpu_forward_tasks<false>(dim, _wp_args);
}

extern "C" {

// Python CPU entry points
WP_API void triple_6003061e_cpu_forward(
    wp::launch_bounds_t<1> *dim,
    wp_args_triple_6003061e *_wp_args)
{
    triple_6003061e_cpu_forward_dispatch(dim, _wp_args);
}

} // extern C

