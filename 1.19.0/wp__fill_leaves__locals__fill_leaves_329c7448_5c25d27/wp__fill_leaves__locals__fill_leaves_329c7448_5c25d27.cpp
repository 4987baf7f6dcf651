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
static void _writer__locals__write_0(
    wp::uint64 var_address,
    wp::int32 var_i,
    wp::float32 var_x)
{
    //---------
    // primal vars
    wp::uint64 var_0;
    wp::uint64 var_1;
    wp::uint64 var_2;
    wp::uint64 var_3;
    const wp::int32 var_4 = 1;
    wp::tuple_t<wp::int32> var_5;
    wp::array_t<wp::float32> var_6;
    const wp::int32 var_7 = 1;
    const wp::int32 var_8 = 0;
    //---------
    // forward
    // def write(address: wp.uint64, i: Any, x: kind):                                        <L 1>
    // view = wp.array(ptr=address + wp.uint64(i) * wp.uint64(size), shape=(1,), dtype=kind)       <L 2>
    var_0 = wp::uint64(var_i);
    var_1 = 4ull;
    var_2 = wp::mul(var_0, var_1);
    var_3 = wp::add(var_address, var_2);
    var_5 = wp::tuple(var_4);
    var_6 = wp::array_t<wp::float32>(var_3, var_7);
    // view[0] = x                                                                            <L 3>
    wp::array_store(var_6, var_8, var_x);
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


// /work/main/warpsample/maths/memory.py:0
static void adj__writer__locals__write_0(
    wp::uint64 var_address,
    wp::int32 var_i,
    wp::float32 var_x,
    wp::uint64 & adj_address,
    wp::int32 & adj_i,
    wp::float32 & adj_x)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}

struct wp_args__fill_leaves__locals__fill_leaves_fa77a838 {
    wp::uint64 leaf_faces;
    wp::uint64 vertices;
    wp::uint64 faces;
    wp::uint64 leaves;
    wp::uint64 boxes;
    wp::uint64 edges;
    wp::int64 first_task;
};


template <bool wp_linear_contiguous>
static void _fill_leaves__locals__fill_leaves_fa77a838_cpu_kernel_forward(
    wp::launch_bounds_t<1> dim,
    size_t task_index,
    wp_args__fill_leaves__locals__fill_leaves_fa77a838 *_wp_args)
{
    static constexpr bool wp_linear_tid = wp_linear_contiguous;

    //---------
    // argument vars
    wp::uint64 var_leaf_faces = _wp_args->leaf_faces;
    wp::uint64 var_vertices = _wp_args->vertices;
    wp::uint64 var_faces = _wp_args->faces;
    wp::uint64 var_leaves = _wp_args->leaves;
    wp::uint64 var_boxes = _wp_args->boxes;
    wp::uint64 var_edges = _wp_args->edges;
    wp::int64 var_first_task = _wp_args->first_task;
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int32 var_1;
    wp::int32 var_2;
    wp::uint64 var_3;
    const wp::int32 var_4 = 4;
    const wp::int32 var_5 = 16;
    wp::int32 var_6;
    wp::uint64 var_7;
    wp::uint64 var_8;
    wp::uint64 var_9;
    wp::tuple_t<wp::int32> var_10;
    wp::array_t<wp::int32> var_11;
    const wp::int32 var_12 = 16;
    wp::uint64 var_13;
    wp::uint64 var_14;
    wp::uint64 var_15;
    wp::uint64 var_16;
    const wp::int32 var_17 = 160;
    wp::tuple_t<wp::int32> var_18;
    wp::array_t<wp::float32> var_19;
    const wp::int32 var_20 = 160;
    wp::uint64 var_21;
    wp::uint64 var_22;
    wp::uint64 var_23;
    wp::uint64 var_24;
    const wp::int32 var_25 = 2;
    wp::tuple_t<wp::int32> var_26;
    wp::array_t<wp::vec_t<3, wp::float32>> var_27;
    const wp::int32 var_28 = 2;
    const wp::float32 var_29 = 1.152921504606847e+18;
    wp::vec_t<3, wp::float32> var_30;
    wp::float32 var_31;
    wp::vec_t<3, wp::float32> var_32;
    const wp::float32 var_33 = 0.0;
    wp::float32 var_34;
    const wp::int32 var_35 = 0;
    wp::int32 var_36;
    bool var_37;
    const wp::float32 var_38 = NAN;
    const wp::float32 var_39 = NAN;
    wp::vec_t<3, wp::float32> var_40;
    wp::vec_t<3, wp::float32> var_41;
    wp::vec_t<3, wp::float32> var_42;
    wp::int32* var_43;
    const wp::int32 var_44 = 0;
    bool var_45;
    wp::int32 var_46;
    wp::int32* var_47;
    wp::vec_t<3, wp::int32> var_48;
    wp::int32 var_49;
    const wp::int32 var_50 = 0;
    wp::int32 var_51;
    wp::vec_t<3, wp::float32> var_52;
    const wp::int32 var_53 = 1;
    wp::int32 var_54;
    wp::vec_t<3, wp::float32> var_55;
    const wp::int32 var_56 = 2;
    wp::int32 var_57;
    wp::vec_t<3, wp::float32> var_58;
    wp::vec_t<3, wp::float32> var_59;
    wp::vec_t<3, wp::float32> var_60;
    wp::vec_t<3, wp::float32> var_61;
    wp::vec_t<3, wp::float32> var_62;
    wp::vec_t<3, wp::float32> var_63;
    wp::float32 var_64;
    wp::float32 var_65;
    wp::vec_t<3, wp::float32> var_66;
    wp::vec_t<3, wp::float32> var_67;
    wp::vec_t<3, wp::float32> var_68;
    wp::vec_t<3, wp::float32> var_69;
    wp::float32 var_70;
    wp::vec_t<3, wp::float32> var_71;
    wp::vec_t<3, wp::float32> var_72;
    wp::vec_t<3, wp::float32> var_73;
    const wp::int32 var_74 = 0;
    wp::float32 var_75;
    wp::int32 var_76;
    wp::int32 var_77;
    wp::float32 var_78;
    const wp::int32 var_79 = 3;
    wp::int32 var_80;
    wp::int32 var_81;
    wp::int32 var_82;
    wp::float32 var_83;
    const wp::int32 var_84 = 6;
    wp::int32 var_85;
    wp::int32 var_86;
    wp::int32 var_87;
    const wp::int32 var_88 = 1;
    wp::float32 var_89;
    wp::int32 var_90;
    wp::int32 var_91;
    wp::float32 var_92;
    const wp::int32 var_93 = 3;
    wp::int32 var_94;
    wp::int32 var_95;
    wp::int32 var_96;
    wp::float32 var_97;
    const wp::int32 var_98 = 6;
    wp::int32 var_99;
    wp::int32 var_100;
    wp::int32 var_101;
    const wp::int32 var_102 = 2;
    wp::float32 var_103;
    wp::int32 var_104;
    wp::int32 var_105;
    wp::float32 var_106;
    const wp::int32 var_107 = 3;
    wp::int32 var_108;
    wp::int32 var_109;
    wp::int32 var_110;
    wp::float32 var_111;
    const wp::int32 var_112 = 6;
    wp::int32 var_113;
    wp::int32 var_114;
    wp::int32 var_115;
    wp::int32* var_116;
    wp::float32 var_117;
    wp::int32 var_118;
    const wp::int32 var_119 = 9;
    wp::int32 var_120;
    wp::int32 var_121;
    const wp::int32 var_122 = 1;
    wp::int32 var_123;
    const wp::int32 var_124 = 0;
    const wp::int32 var_125 = 1;
    //---------
    // forward
    // def fill_leaves(                                                                       <L 88>
    // leaf = wp.int32(first_task) + wp.tid()                                                 <L 97>
    var_0 = wp::int32(var_first_task);
    var_1 = builtin_tid1d();
    var_2 = wp::add(var_0, var_1);
    // mine = wp.array(ptr=leaf_faces + wp.uint64(leaf) * wp.uint64(4 * WIDTH), shape=(WIDTH,), dtype=wp.int32)       <L 98>
    var_3 = wp::uint64(var_2);
    var_6 = wp::mul(var_4, var_5);
    var_7 = wp::uint64(var_6);
    var_8 = wp::mul(var_3, var_7);
    var_9 = wp::add(var_leaf_faces, var_8);
    var_10 = wp::tuple(var_5);
    var_11 = wp::array_t<wp::int32>(var_9, var_12);
    // rows = wp.array(ptr=leaves + wp.uint64(leaf) * wp.uint64(LEAF_BYTES), shape=(_LEAF_FLOATS,), dtype=wp.float32)       <L 99>
    var_13 = wp::uint64(var_2);
    var_14 = 640ull;
    var_15 = wp::mul(var_13, var_14);
    var_16 = wp::add(var_leaves, var_15);
    var_18 = wp::tuple(var_17);
    var_19 = wp::array_t<wp::float32>(var_16, var_20);
    // box = wp.array(ptr=boxes + wp.uint64(leaf) * wp.uint64(24), shape=(2,), dtype=wp.vec3)       <L 100>
    var_21 = wp::uint64(var_2);
    var_22 = 24ull;
    var_23 = wp::mul(var_21, var_22);
    var_24 = wp::add(var_boxes, var_23);
    var_26 = wp::tuple(var_25);
    var_27 = wp::array_t<wp::vec_t<3, wp::float32>>(var_24, var_28);
    // low = wp.vec3(_NOWHERE)                                                                <L 101>
    var_30 = wp::vec_t<3, wp::float32>(var_29);
    // high = wp.vec3(-_NOWHERE)                                                              <L 102>
    var_31 = wp::neg(var_29);
    var_32 = wp::vec_t<3, wp::float32>(var_31);
    // longest = wp.float32(0.0)                                                              <L 103>
    var_34 = wp::float32(var_33);
    // k = wp.int32(0)                                                                        <L 104>
    var_36 = wp::int32(var_35);
    // while k < WIDTH:  # the compiler would unroll `range` and take four times as long       <L 105>
    start_while_0:;
    var_37 = (var_36 < var_5);
    if ((var_37) == false) goto end_while_0;
        // a = wp.vec3(wp.NAN)  # no ray hits an empty lane                                   <L 106>
        var_40 = wp::vec_t<3, wp::float32>(var_39);
        // b = a                                                                              <L 107>
        var_41 = wp::copy(var_40);
        // c = a                                                                              <L 108>
        var_42 = wp::copy(var_40);
        // if mine[k] >= 0:                                                                   <L 109>
        var_43 = wp::address(var_11, var_36);
        var_46 = wp::load(var_43);
        var_45 = (var_46 >= var_44);
        if (var_45) {
            // corners = vec3i_at(faces, mine[k])                                             <L 110>
            var_47 = wp::address(var_11, var_36);
            var_49 = wp::load(var_47);
            var_48 = _reader__locals__read_6(var_faces, var_49);
            // a = vec3_at(vertices, corners[0])                                              <L 111>
            var_51 = wp::extract(var_48, var_50);
            var_52 = _reader__locals__read_5(var_vertices, var_51);
            // b = vec3_at(vertices, corners[1])                                              <L 112>
            var_54 = wp::extract(var_48, var_53);
            var_55 = _reader__locals__read_5(var_vertices, var_54);
            // c = vec3_at(vertices, corners[2])                                              <L 113>
            var_57 = wp::extract(var_48, var_56);
            var_58 = _reader__locals__read_5(var_vertices, var_57);
            // least = wp.min(wp.min(a, b), c)                                                <L 114>
            var_59 = wp::min(var_52, var_55);
            var_60 = wp::min(var_59, var_58);
            // most = wp.max(wp.max(a, b), c)                                                 <L 115>
            var_61 = wp::max(var_52, var_55);
            var_62 = wp::max(var_61, var_58);
            // longest = wp.max(longest, wp.max(most - least))                                <L 116>
            var_63 = wp::sub(var_62, var_60);
            var_64 = wp::max(var_63);
            var_65 = wp::max(var_34, var_64);
            // low = wp.min(low, least)                                                       <L 117>
            var_66 = wp::min(var_30, var_60);
            // high = wp.max(high, most)                                                      <L 118>
            var_67 = wp::max(var_32, var_62);
        }
        var_68 = wp::where(var_45, var_66, var_30);
        var_69 = wp::where(var_45, var_67, var_32);
        var_70 = wp::where(var_45, var_65, var_34);
        var_71 = wp::where(var_45, var_52, var_40);
        var_72 = wp::where(var_45, var_55, var_41);
        var_73 = wp::where(var_45, var_58, var_42);
        // for axis in range(3):                                                              <L 119>
        // rows[axis * WIDTH + k] = a[axis]                                                   <L 120>
        var_75 = wp::extract(var_71, var_74);
        var_76 = wp::mul(var_74, var_5);
        var_77 = wp::add(var_76, var_36);
        wp::array_store(var_19, var_77, var_75);
        // rows[(3 + axis) * WIDTH + k] = b[axis]                                             <L 121>
        var_78 = wp::extract(var_72, var_74);
        var_80 = wp::add(var_79, var_74);
        var_81 = wp::mul(var_80, var_5);
        var_82 = wp::add(var_81, var_36);
        wp::array_store(var_19, var_82, var_78);
        // rows[(6 + axis) * WIDTH + k] = c[axis]                                             <L 122>
        var_83 = wp::extract(var_73, var_74);
        var_85 = wp::add(var_84, var_74);
        var_86 = wp::mul(var_85, var_5);
        var_87 = wp::add(var_86, var_36);
        wp::array_store(var_19, var_87, var_83);
        // rows[axis * WIDTH + k] = a[axis]                                                   <L 120>
        var_89 = wp::extract(var_71, var_88);
        var_90 = wp::mul(var_88, var_5);
        var_91 = wp::add(var_90, var_36);
        wp::array_store(var_19, var_91, var_89);
        // rows[(3 + axis) * WIDTH + k] = b[axis]                                             <L 121>
        var_92 = wp::extract(var_72, var_88);
        var_94 = wp::add(var_93, var_88);
        var_95 = wp::mul(var_94, var_5);
        var_96 = wp::add(var_95, var_36);
        wp::array_store(var_19, var_96, var_92);
        // rows[(6 + axis) * WIDTH + k] = c[axis]                                             <L 122>
        var_97 = wp::extract(var_73, var_88);
        var_99 = wp::add(var_98, var_88);
        var_100 = wp::mul(var_99, var_5);
        var_101 = wp::add(var_100, var_36);
        wp::array_store(var_19, var_101, var_97);
        // rows[axis * WIDTH + k] = a[axis]                                                   <L 120>
        var_103 = wp::extract(var_71, var_102);
        var_104 = wp::mul(var_102, var_5);
        var_105 = wp::add(var_104, var_36);
        wp::array_store(var_19, var_105, var_103);
        // rows[(3 + axis) * WIDTH + k] = b[axis]                                             <L 121>
        var_106 = wp::extract(var_72, var_102);
        var_108 = wp::add(var_107, var_102);
        var_109 = wp::mul(var_108, var_5);
        var_110 = wp::add(var_109, var_36);
        wp::array_store(var_19, var_110, var_106);
        // rows[(6 + axis) * WIDTH + k] = c[axis]                                             <L 122>
        var_111 = wp::extract(var_73, var_102);
        var_113 = wp::add(var_112, var_102);
        var_114 = wp::mul(var_113, var_5);
        var_115 = wp::add(var_114, var_36);
        wp::array_store(var_19, var_115, var_111);
        // rows[9 * WIDTH + k] = wp.cast(mine[k], wp.float32)                                 <L 123>
        var_116 = wp::address(var_11, var_36);
        var_118 = wp::load(var_116);
        var_117 = wp::cast<wp::float32>(var_118);
        var_120 = wp::mul(var_119, var_5);
        var_121 = wp::add(var_120, var_36);
        wp::array_store(var_19, var_121, var_117);
        // k += 1                                                                             <L 124>
        var_123 = wp::add(var_36, var_122);
        wp::assign(var_30, var_68);
        wp::assign(var_32, var_69);
        wp::assign(var_34, var_70);
        wp::assign(var_36, var_123);
    goto start_while_0;
    end_while_0:;
    // box[0] = low                                                                           <L 125>
    wp::array_store(var_27, var_124, var_30);
    // box[1] = high                                                                          <L 126>
    wp::array_store(var_27, var_125, var_32);
    // set_float(edges, leaf, longest)                                                        <L 127>
    _writer__locals__write_0(var_edges, var_2, var_34);
}



template <bool wp_linear_contiguous>
static WP_FORCEINLINE void _fill_leaves__locals__fill_leaves_fa77a838_cpu_forward_tasks(
    wp::launch_bounds_t<1> *dim,
    wp_args__fill_leaves__locals__fill_leaves_fa77a838 *_wp_args)
{
    for (size_t task_index = 0; task_index < dim->size; ++task_index)
    {
        _fill_leaves__locals__fill_leaves_fa77a838_cpu_kernel_forward<wp_linear_contiguous>(*dim, task_index, _wp_args);
    }
}

static WP_FORCEINLINE void _fill_leaves__locals__fill_leaves_fa77a838_cpu_forward_dispatch(
    wp::launch_bounds_t<1> *dim,
    wp_args__fill_leaves__locals__fill_leaves_fa77a838 *_wp_args)
{
    wp::tile_shared_storage_t tile_mem;
#if defined(WP_ENABLE_TILES_IN_STACK_MEMORY)
    wp::shared_tile_storage = &tile_mem;
#endif

    _fill_leaves__locals__fill_leaves_fa77a838_cpu_forward_tasks<false>(dim, _wp_args);
}

extern "C" {

// Python CPU entry points
WP_API void _fill_leaves__locals__fill_leaves_fa77a838_cpu_forward(
    wp::launch_bounds_t<1> *dim,
    wp_args__fill_leaves__locals__fill_leaves_fa77a838 *_wp_args)
{
    _fill_leaves__locals__fill_leaves_fa77a838_cpu_forward_dispatch(dim, _wp_args);
}

} // extern C

