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


struct Parameters_f3aa772c
{
    wp::float32 scalar;
    wp::float32 x;
    wp::float32 y;
    wp::float32 z;


    Parameters_f3aa772c() = default;
    CUDA_CALLABLE Parameters_f3aa772c(wp::float32 const& scalar,
    wp::float32 const& x = {},
    wp::float32 const& y = {},
    wp::float32 const& z = {})
        : scalar{scalar}
        , x{x}
        , y{y}
        , z{z}

    {
    }

    CUDA_CALLABLE Parameters_f3aa772c& operator += (const Parameters_f3aa772c& rhs)
    {    scalar += rhs.scalar;
    x += rhs.x;
    y += rhs.y;
    z += rhs.z;

        return *this;}

};

static CUDA_CALLABLE void adj_Parameters_f3aa772c(wp::float32 const&,
    wp::float32 const&,
    wp::float32 const&,
    wp::float32 const&,
    wp::float32 & adj_scalar,
    wp::float32 & adj_x,
    wp::float32 & adj_y,
    wp::float32 & adj_z,
    Parameters_f3aa772c & adj_ret)
{
    adj_scalar += adj_ret.scalar;
    adj_x += adj_ret.x;
    adj_y += adj_ret.y;
    adj_z += adj_ret.z;
}

// Required when compiling adjoints.
CUDA_CALLABLE Parameters_f3aa772c add(const Parameters_f3aa772c& a, const Parameters_f3aa772c& b)
{
    return Parameters_f3aa772c();
}

CUDA_CALLABLE void adj_atomic_add(Parameters_f3aa772c* p, Parameters_f3aa772c t)
{
    wp::adj_atomic_add(&p->scalar, t.scalar);
    wp::adj_atomic_add(&p->x, t.x);
    wp::adj_atomic_add(&p->y, t.y);
    wp::adj_atomic_add(&p->z, t.z);
}




// /work/main/warpsample/distributions/elementwise.py:20
static wp::vec_t<3, wp::float32> _read_3_0(
    wp::array_t<wp::float32> var_x,
    wp::int32 var_i)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 3;
    wp::int32 var_1;
    wp::float32* var_2;
    const wp::int32 var_3 = 3;
    wp::int32 var_4;
    const wp::int32 var_5 = 1;
    wp::int32 var_6;
    wp::float32* var_7;
    const wp::int32 var_8 = 3;
    wp::int32 var_9;
    const wp::int32 var_10 = 2;
    wp::int32 var_11;
    wp::float32* var_12;
    wp::vec_t<3, wp::float32> var_13;
    wp::float32 var_14;
    wp::float32 var_15;
    wp::float32 var_16;
    //---------
    // forward
    // def _read_3(x: wp.array[wp.float32], i: wp.int32) -> wp.vec3:                          <L 21>
    // return wp.vec3(x[3 * i], x[3 * i + 1], x[3 * i + 2])                                   <L 23>
    var_1 = wp::mul(var_0, var_i);
    var_2 = wp::address(var_x, var_1);
    var_4 = wp::mul(var_3, var_i);
    var_6 = wp::add(var_4, var_5);
    var_7 = wp::address(var_x, var_6);
    var_9 = wp::mul(var_8, var_i);
    var_11 = wp::add(var_9, var_10);
    var_12 = wp::address(var_x, var_11);
    var_14 = wp::load(var_2);
    var_15 = wp::load(var_7);
    var_16 = wp::load(var_12);
    var_13 = wp::vec_t<3, wp::float32>(var_14, var_15, var_16);
    return var_13;
}


// /work/main/warpsample/distributions/cosine_hemisphere.py:39
static wp::float32 square_to_cosine_hemisphere_pdf_0(
    wp::vec_t<3, wp::float32> var_w)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 2;
    wp::float32 var_1;
    const wp::float32 var_2 = 0.0;
    bool var_3;
    const wp::int32 var_4 = 2;
    wp::float32 var_5;
    const wp::float32 var_6 = 0.3183098861837907;
    wp::float32 var_7;
    const wp::float32 var_8 = 0.0;
    wp::float32 var_9;
    //---------
    // forward
    // def square_to_cosine_hemisphere_pdf(w: wp.vec3) -> wp.float32:                         <L 40>
    // return wp.where(w[2] > 0.0, w[2] * INV_PI, 0.0)                                        <L 42>
    var_1 = wp::extract(var_w, var_0);
    var_3 = (var_1 > var_2);
    var_5 = wp::extract(var_w, var_4);
    var_7 = wp::mul(var_5, var_6);
    var_9 = wp::where(var_3, var_7, var_8);
    return var_9;
}


// /work/main/warpsample/distributions/parameters.py:43
static wp::float32 bind_parameters__locals__call_1(
    wp::vec_t<3, wp::float32> var_x,
    Parameters_f3aa772c var_parameters)
{
    //---------
    // primal vars
    wp::float32 var_0;
    //---------
    // forward
    // def call(x: argument, parameters: Parameters):                                         <L 44>
    // return func(x)                                                                         <L 46>
    var_0 = square_to_cosine_hemisphere_pdf_0(var_x);
    return var_0;
}


// /work/main/warpsample/distributions/elementwise.py:26
static void _write_1_0(
    wp::array_t<wp::float32> var_y,
    wp::int32 var_i,
    wp::float32 var_value)
{
    //---------
    // primal vars
    //---------
    // forward
    // def _write_1(y: wp.array[wp.float32], i: wp.int32, value: wp.float32):                 <L 27>
    // y[i] = value                                                                           <L 29>
    wp::array_store(var_y, var_i, var_value);
}


// /work/main/warpsample/distributions/elementwise.py:20
static void adj__read_3_0(
    wp::array_t<wp::float32> var_x,
    wp::int32 var_i,
    wp::array_t<wp::float32> & adj_x,
    wp::int32 & adj_i,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/distributions/cosine_hemisphere.py:39
static void adj_square_to_cosine_hemisphere_pdf_0(
    wp::vec_t<3, wp::float32> var_w,
    wp::vec_t<3, wp::float32> & adj_w,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/distributions/parameters.py:43
static void adj_bind_parameters__locals__call_1(
    wp::vec_t<3, wp::float32> var_x,
    Parameters_f3aa772c var_parameters,
    wp::vec_t<3, wp::float32> & adj_x,
    Parameters_f3aa772c & adj_parameters,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/distributions/elementwise.py:26
static void adj__write_1_0(
    wp::array_t<wp::float32> var_y,
    wp::int32 var_i,
    wp::float32 var_value,
    wp::array_t<wp::float32> & adj_y,
    wp::int32 & adj_i,
    wp::float32 & adj_value)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}

struct wp_args_elementwise__locals__elementwise_7459a743 {
    wp::int64 total;
    wp::int32 block;
    wp::uint64 source;
    wp::uint64 target;
    Parameters_f3aa772c parameters;
    wp::int64 first_task;
};


template <bool wp_linear_contiguous>
static void elementwise__locals__elementwise_7459a743_cpu_kernel_forward(
    wp::launch_bounds_t<1> dim,
    size_t task_index,
    wp_args_elementwise__locals__elementwise_7459a743 *_wp_args)
{
    static constexpr bool wp_linear_tid = wp_linear_contiguous;

    //---------
    // argument vars
    wp::int64 var_total = _wp_args->total;
    wp::int32 var_block = _wp_args->block;
    wp::uint64 var_source = _wp_args->source;
    wp::uint64 var_target = _wp_args->target;
    Parameters_f3aa772c var_parameters = _wp_args->parameters;
    wp::int64 var_first_task = _wp_args->first_task;
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int64 var_1;
    wp::int64 var_2;
    wp::int64 var_3;
    wp::int64 var_4;
    wp::int64 var_5;
    wp::int64 var_6;
    wp::int64 var_7;
    wp::int32 var_8;
    const wp::int32 var_9 = 4;
    const wp::int32 var_10 = 3;
    wp::int32 var_11;
    wp::int64 var_12;
    wp::int64 var_13;
    wp::uint64 var_14;
    wp::uint64 var_15;
    wp::int32 var_16;
    wp::tuple_t<wp::int32> var_17;
    wp::array_t<wp::float32> var_18;
    const wp::int32 var_19 = 4;
    const wp::int32 var_20 = 1;
    wp::int32 var_21;
    wp::int64 var_22;
    wp::int64 var_23;
    wp::uint64 var_24;
    wp::uint64 var_25;
    wp::int32 var_26;
    wp::tuple_t<wp::int32> var_27;
    wp::array_t<wp::float32> var_28;
    const wp::int32 var_29 = 0;
    wp::int32 var_30;
    bool var_31;
    wp::vec_t<3, wp::float32> var_32;
    wp::float32 var_33;
    const wp::int32 var_34 = 1;
    wp::int32 var_35;
    //---------
    // forward
    // def elementwise(                                                                       <L 58>
    // first = (first_task + wp.int64(wp.tid())) * wp.int64(block)                            <L 67>
    var_0 = builtin_tid1d();
    var_1 = wp::int64(var_0);
    var_2 = wp::add(var_first_task, var_1);
    var_3 = wp::int64(var_block);
    var_4 = wp::mul(var_2, var_3);
    // length = wp.int32(wp.min(wp.int64(block), total - first))                              <L 68>
    var_5 = wp::int64(var_block);
    var_6 = wp::sub(var_total, var_4);
    var_7 = wp::min(var_5, var_6);
    var_8 = wp::int32(var_7);
    // x = wp.array(ptr=source + wp.uint64(first * wp.int64(4 * width)), shape=(width * length,), dtype=wp.float32)       <L 69>
    var_11 = wp::mul(var_9, var_10);
    var_12 = wp::int64(var_11);
    var_13 = wp::mul(var_4, var_12);
    var_14 = wp::uint64(var_13);
    var_15 = wp::add(var_source, var_14);
    var_16 = wp::mul(var_10, var_8);
    var_17 = wp::tuple(var_16);
    var_18 = wp::array_t<wp::float32>(var_15, var_16);
    // y = wp.array(ptr=target + wp.uint64(first * wp.int64(4 * out_width)), shape=(out_width * length,), dtype=wp.float32)       <L 70>
    var_21 = wp::mul(var_19, var_20);
    var_22 = wp::int64(var_21);
    var_23 = wp::mul(var_4, var_22);
    var_24 = wp::uint64(var_23);
    var_25 = wp::add(var_target, var_24);
    var_26 = wp::mul(var_20, var_8);
    var_27 = wp::tuple(var_26);
    var_28 = wp::array_t<wp::float32>(var_25, var_26);
    // i = wp.int32(0)                                                                        <L 71>
    var_30 = wp::int32(var_29);
    // while i < length:                                                                      <L 72>
    start_while_0:;
    var_31 = (var_30 < var_8);
    if ((var_31) == false) goto end_while_0;
        // write(y, i, func(read(x, i), parameters))                                          <L 73>
        var_32 = _read_3_0(var_18, var_30);
        var_33 = bind_parameters__locals__call_1(var_32, var_parameters);
        _write_1_0(var_28, var_30, var_33);
        // i += 1                                                                             <L 74>
        var_35 = wp::add(var_30, var_34);
        wp::assign(var_30, var_35);
    goto start_while_0;
    end_while_0:;
}



template <bool wp_linear_contiguous>
static WP_FORCEINLINE void elementwise__locals__elementwise_7459a743_cpu_forward_tasks(
    wp::launch_bounds_t<1> *dim,
    wp_args_elementwise__locals__elementwise_7459a743 *_wp_args)
{
    for (size_t task_index = 0; task_index < dim->size; ++task_index)
    {
        elementwise__locals__elementwise_7459a743_cpu_kernel_forward<wp_linear_contiguous>(*dim, task_index, _wp_args);
    }
}

static WP_FORCEINLINE void elementwise__locals__elementwise_7459a743_cpu_forward_dispatch(
    wp::launch_bounds_t<1> *dim,
    wp_args_elementwise__locals__elementwise_7459a743 *_wp_args)
{
    wp::tile_shared_storage_t tile_mem;
#if defined(WP_ENABLE_TILES_IN_STACK_MEMORY)
    wp::shared_tile_storage = &tile_mem;
#endif

    elementwise__locals__elementwise_7459a743_cpu_forward_tasks<false>(dim, _wp_args);
}

extern "C" {

// Python CPU entry points
WP_API void elementwise__locals__elementwise_7459a743_cpu_forward(
    wp::launch_bounds_t<1> *dim,
    wp_args_elementwise__locals__elementwise_7459a743 *_wp_args)
{
    elementwise__locals__elementwise_7459a743_cpu_forward_dispatch(dim, _wp_args);
}

} // extern C

