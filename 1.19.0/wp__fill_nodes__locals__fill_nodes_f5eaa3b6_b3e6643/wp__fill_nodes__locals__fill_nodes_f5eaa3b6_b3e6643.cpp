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
static wp::float32 _reader__locals__read_0(
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
    wp::array_t<wp::float32> var_6;
    const wp::int32 var_7 = 1;
    const wp::int32 var_8 = 0;
    wp::float32* var_9;
    wp::float32 var_10;
    wp::float32 var_11;
    //---------
    // forward
    // def read(address: wp.uint64, i: Any):                                                  <L 1>
    // return wp.array(ptr=address + wp.uint64(i) * wp.uint64(size), shape=(1,), dtype=kind)[0]       <L 2>
    var_0 = wp::uint64(var_i);
    var_1 = 4ull;
    var_2 = wp::mul(var_0, var_1);
    var_3 = wp::add(var_address, var_2);
    var_5 = wp::tuple(var_4);
    var_6 = wp::array_t<wp::float32>(var_3, var_7);
    var_9 = wp::address(var_6, var_8);
    var_11 = wp::load(var_9);
    var_10 = wp::copy(var_11);
    return var_10;
}


// /work/main/warpsample/maths/memory.py:0
static void adj__reader__locals__read_0(
    wp::uint64 var_address,
    wp::int32 var_i,
    wp::uint64 & adj_address,
    wp::int32 & adj_i,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}

struct wp_args__fill_nodes__locals__fill_nodes_606d8a51 {
    wp::int32 first_node;
    wp::uint64 links;
    wp::uint64 leaf_boxes;
    wp::uint64 edges;
    wp::uint64 node_boxes;
    wp::uint64 nodes;
    wp::int64 first_task;
};


template <bool wp_linear_contiguous>
static void _fill_nodes__locals__fill_nodes_606d8a51_cpu_kernel_forward(
    wp::launch_bounds_t<1> dim,
    size_t task_index,
    wp_args__fill_nodes__locals__fill_nodes_606d8a51 *_wp_args)
{
    static constexpr bool wp_linear_tid = wp_linear_contiguous;

    //---------
    // argument vars
    wp::int32 var_first_node = _wp_args->first_node;
    wp::uint64 var_links = _wp_args->links;
    wp::uint64 var_leaf_boxes = _wp_args->leaf_boxes;
    wp::uint64 var_edges = _wp_args->edges;
    wp::uint64 var_node_boxes = _wp_args->node_boxes;
    wp::uint64 var_nodes = _wp_args->nodes;
    wp::int64 var_first_task = _wp_args->first_task;
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int32 var_1;
    wp::int32 var_2;
    wp::int32 var_3;
    wp::uint64 var_4;
    const wp::int32 var_5 = 4;
    const wp::int32 var_6 = 16;
    wp::int32 var_7;
    wp::uint64 var_8;
    wp::uint64 var_9;
    wp::uint64 var_10;
    wp::tuple_t<wp::int32> var_11;
    wp::array_t<wp::int32> var_12;
    const wp::int32 var_13 = 16;
    wp::uint64 var_14;
    wp::uint64 var_15;
    wp::uint64 var_16;
    wp::uint64 var_17;
    const wp::int32 var_18 = 128;
    wp::tuple_t<wp::int32> var_19;
    wp::array_t<wp::float32> var_20;
    const wp::int32 var_21 = 128;
    wp::uint64 var_22;
    wp::uint64 var_23;
    wp::uint64 var_24;
    wp::uint64 var_25;
    const wp::int32 var_26 = 2;
    wp::tuple_t<wp::int32> var_27;
    wp::array_t<wp::vec_t<3, wp::float32>> var_28;
    const wp::int32 var_29 = 2;
    const wp::float32 var_30 = 1.152921504606847e+18;
    wp::vec_t<3, wp::float32> var_31;
    wp::float32 var_32;
    wp::vec_t<3, wp::float32> var_33;
    const wp::int32 var_34 = 0;
    wp::int32 var_35;
    bool var_36;
    wp::int32* var_37;
    wp::int32 var_38;
    wp::int32 var_39;
    wp::vec_t<3, wp::float32> var_40;
    wp::float32 var_41;
    wp::vec_t<3, wp::float32> var_42;
    const wp::float32 var_43 = 0.0;
    wp::float32 var_44;
    const wp::int32 var_45 = 0;
    bool var_46;
    wp::uint64 var_47;
    wp::uint64 var_48;
    wp::uint64 var_49;
    wp::uint64 var_50;
    const wp::int32 var_51 = 0;
    bool var_52;
    wp::int32 var_53;
    wp::uint64 var_54;
    wp::uint64 var_55;
    wp::uint64 var_56;
    wp::uint64 var_57;
    wp::int32 var_58;
    wp::float32 var_59;
    wp::float32 var_60;
    wp::uint64 var_61;
    const wp::int32 var_62 = 2;
    wp::tuple_t<wp::int32> var_63;
    wp::array_t<wp::vec_t<3, wp::float32>> var_64;
    const wp::int32 var_65 = 2;
    const wp::int32 var_66 = 0;
    wp::vec_t<3, wp::float32>* var_67;
    wp::vec_t<3, wp::float32> var_68;
    wp::vec_t<3, wp::float32> var_69;
    const wp::int32 var_70 = 1;
    wp::vec_t<3, wp::float32>* var_71;
    wp::vec_t<3, wp::float32> var_72;
    wp::vec_t<3, wp::float32> var_73;
    const wp::int32 var_74 = 0;
    wp::vec_t<3, wp::float32>* var_75;
    const wp::float32 var_76 = 7.62939453125e-06;
    wp::vec_t<3, wp::float32> var_77;
    wp::vec_t<3, wp::float32> var_78;
    wp::vec_t<3, wp::float32> var_79;
    const wp::int32 var_80 = 1;
    wp::vec_t<3, wp::float32>* var_81;
    wp::vec_t<3, wp::float32> var_82;
    wp::vec_t<3, wp::float32> var_83;
    wp::vec_t<3, wp::float32> var_84;
    wp::vec_t<3, wp::float32> var_85;
    wp::vec_t<3, wp::float32> var_86;
    wp::vec_t<3, wp::float32> var_87;
    wp::vec_t<3, wp::float32> var_88;
    wp::float32 var_89;
    const wp::int32 var_90 = 0;
    wp::float32 var_91;
    wp::int32 var_92;
    wp::int32 var_93;
    wp::float32 var_94;
    const wp::int32 var_95 = 3;
    wp::int32 var_96;
    wp::int32 var_97;
    wp::int32 var_98;
    const wp::int32 var_99 = 1;
    wp::float32 var_100;
    wp::int32 var_101;
    wp::int32 var_102;
    wp::float32 var_103;
    const wp::int32 var_104 = 3;
    wp::int32 var_105;
    wp::int32 var_106;
    wp::int32 var_107;
    const wp::int32 var_108 = 2;
    wp::float32 var_109;
    wp::int32 var_110;
    wp::int32 var_111;
    wp::float32 var_112;
    const wp::int32 var_113 = 3;
    wp::int32 var_114;
    wp::int32 var_115;
    wp::int32 var_116;
    wp::float32 var_117;
    const wp::int32 var_118 = 6;
    wp::int32 var_119;
    wp::int32 var_120;
    const wp::int32 var_121 = 7;
    wp::int32 var_122;
    wp::int32 var_123;
    const wp::int32 var_124 = 1;
    wp::int32 var_125;
    const wp::int32 var_126 = 0;
    const wp::int32 var_127 = 1;
    //---------
    // forward
    // def fill_nodes(                                                                        <L 137>
    // node = first_node + wp.int32(first_task) + wp.tid()                                    <L 146>
    var_0 = wp::int32(var_first_task);
    var_1 = wp::add(var_first_node, var_0);
    var_2 = builtin_tid1d();
    var_3 = wp::add(var_1, var_2);
    // below = wp.array(ptr=links + wp.uint64(node) * wp.uint64(4 * WIDTH), shape=(WIDTH,), dtype=wp.int32)       <L 147>
    var_4 = wp::uint64(var_3);
    var_7 = wp::mul(var_5, var_6);
    var_8 = wp::uint64(var_7);
    var_9 = wp::mul(var_4, var_8);
    var_10 = wp::add(var_links, var_9);
    var_11 = wp::tuple(var_6);
    var_12 = wp::array_t<wp::int32>(var_10, var_13);
    // rows = wp.array(ptr=nodes + wp.uint64(node) * wp.uint64(NODE_BYTES), shape=(_NODE_FLOATS,), dtype=wp.float32)       <L 148>
    var_14 = wp::uint64(var_3);
    var_15 = 512ull;
    var_16 = wp::mul(var_14, var_15);
    var_17 = wp::add(var_nodes, var_16);
    var_19 = wp::tuple(var_18);
    var_20 = wp::array_t<wp::float32>(var_17, var_21);
    // own = wp.array(ptr=node_boxes + wp.uint64(node) * wp.uint64(24), shape=(2,), dtype=wp.vec3)       <L 149>
    var_22 = wp::uint64(var_3);
    var_23 = 24ull;
    var_24 = wp::mul(var_22, var_23);
    var_25 = wp::add(var_node_boxes, var_24);
    var_27 = wp::tuple(var_26);
    var_28 = wp::array_t<wp::vec_t<3, wp::float32>>(var_25, var_29);
    // low = wp.vec3(_NOWHERE)                                                                <L 150>
    var_31 = wp::vec_t<3, wp::float32>(var_30);
    // high = wp.vec3(-_NOWHERE)                                                              <L 151>
    var_32 = wp::neg(var_30);
    var_33 = wp::vec_t<3, wp::float32>(var_32);
    // k = wp.int32(0)                                                                        <L 152>
    var_35 = wp::int32(var_34);
    // while k < WIDTH:                                                                       <L 153>
    start_while_0:;
    var_36 = (var_35 < var_6);
    if ((var_36) == false) goto end_while_0;
        // link = below[k]                                                                    <L 154>
        var_37 = wp::address(var_12, var_35);
        var_39 = wp::load(var_37);
        var_38 = wp::copy(var_39);
        // lower = wp.vec3(_NOWHERE)                                                          <L 155>
        var_40 = wp::vec_t<3, wp::float32>(var_30);
        // upper = wp.vec3(-_NOWHERE)                                                         <L 156>
        var_41 = wp::neg(var_30);
        var_42 = wp::vec_t<3, wp::float32>(var_41);
        // edge = wp.float32(0.0)                                                             <L 157>
        var_44 = wp::float32(var_43);
        // if link != 0:                                                                      <L 158>
        var_46 = (var_38 != var_45);
        if (var_46) {
            // address = node_boxes + wp.uint64(link) * wp.uint64(24)                         <L 159>
            var_47 = wp::uint64(var_38);
            var_48 = 24ull;
            var_49 = wp::mul(var_47, var_48);
            var_50 = wp::add(var_node_boxes, var_49);
            // if link < 0:                                                                   <L 160>
            var_52 = (var_38 < var_51);
            if (var_52) {
                // address = leaf_boxes + wp.uint64(~link) * wp.uint64(24)                    <L 161>
                var_53 = wp::invert(var_38);
                var_54 = wp::uint64(var_53);
                var_55 = 24ull;
                var_56 = wp::mul(var_54, var_55);
                var_57 = wp::add(var_leaf_boxes, var_56);
                // edge = float_at(edges, ~link)                                              <L 162>
                var_58 = wp::invert(var_38);
                var_59 = _reader__locals__read_0(var_edges, var_58);
            }
            var_60 = wp::where(var_52, var_59, var_44);
            var_61 = wp::where(var_52, var_57, var_50);
            // box = wp.array(ptr=address, shape=(2,), dtype=wp.vec3)                         <L 163>
            var_63 = wp::tuple(var_62);
            var_64 = wp::array_t<wp::vec_t<3, wp::float32>>(var_61, var_65);
            // low = wp.min(low, box[0])                                                      <L 164>
            var_67 = wp::address(var_64, var_66);
            var_69 = wp::load(var_67);
            var_68 = wp::min(var_31, var_69);
            // high = wp.max(high, box[1])                                                    <L 165>
            var_71 = wp::address(var_64, var_70);
            var_73 = wp::load(var_71);
            var_72 = wp::max(var_33, var_73);
            // lower = box[0] - wp.vec3(_PADDING)                                             <L 166>
            var_75 = wp::address(var_64, var_74);
            var_77 = wp::vec_t<3, wp::float32>(var_76);
            var_79 = wp::load(var_75);
            var_78 = wp::sub(var_79, var_77);
            // upper = box[1] + wp.vec3(_PADDING)                                             <L 167>
            var_81 = wp::address(var_64, var_80);
            var_82 = wp::vec_t<3, wp::float32>(var_76);
            var_84 = wp::load(var_81);
            var_83 = wp::add(var_84, var_82);
        }
        var_85 = wp::where(var_46, var_68, var_31);
        var_86 = wp::where(var_46, var_72, var_33);
        var_87 = wp::where(var_46, var_78, var_40);
        var_88 = wp::where(var_46, var_83, var_42);
        var_89 = wp::where(var_46, var_60, var_44);
        // for axis in range(3):                                                              <L 168>
        // rows[axis * WIDTH + k] = lower[axis]                                               <L 169>
        var_91 = wp::extract(var_87, var_90);
        var_92 = wp::mul(var_90, var_6);
        var_93 = wp::add(var_92, var_35);
        wp::array_store(var_20, var_93, var_91);
        // rows[(3 + axis) * WIDTH + k] = upper[axis]                                         <L 170>
        var_94 = wp::extract(var_88, var_90);
        var_96 = wp::add(var_95, var_90);
        var_97 = wp::mul(var_96, var_6);
        var_98 = wp::add(var_97, var_35);
        wp::array_store(var_20, var_98, var_94);
        // rows[axis * WIDTH + k] = lower[axis]                                               <L 169>
        var_100 = wp::extract(var_87, var_99);
        var_101 = wp::mul(var_99, var_6);
        var_102 = wp::add(var_101, var_35);
        wp::array_store(var_20, var_102, var_100);
        // rows[(3 + axis) * WIDTH + k] = upper[axis]                                         <L 170>
        var_103 = wp::extract(var_88, var_99);
        var_105 = wp::add(var_104, var_99);
        var_106 = wp::mul(var_105, var_6);
        var_107 = wp::add(var_106, var_35);
        wp::array_store(var_20, var_107, var_103);
        // rows[axis * WIDTH + k] = lower[axis]                                               <L 169>
        var_109 = wp::extract(var_87, var_108);
        var_110 = wp::mul(var_108, var_6);
        var_111 = wp::add(var_110, var_35);
        wp::array_store(var_20, var_111, var_109);
        // rows[(3 + axis) * WIDTH + k] = upper[axis]                                         <L 170>
        var_112 = wp::extract(var_88, var_108);
        var_114 = wp::add(var_113, var_108);
        var_115 = wp::mul(var_114, var_6);
        var_116 = wp::add(var_115, var_35);
        wp::array_store(var_20, var_116, var_112);
        // rows[6 * WIDTH + k] = wp.cast(link, wp.float32)                                    <L 171>
        var_117 = wp::cast<wp::float32>(var_38);
        var_119 = wp::mul(var_118, var_6);
        var_120 = wp::add(var_119, var_35);
        wp::array_store(var_20, var_120, var_117);
        // rows[7 * WIDTH + k] = edge                                                         <L 172>
        var_122 = wp::mul(var_121, var_6);
        var_123 = wp::add(var_122, var_35);
        wp::array_store(var_20, var_123, var_89);
        // k += 1                                                                             <L 173>
        var_125 = wp::add(var_35, var_124);
        wp::assign(var_31, var_85);
        wp::assign(var_33, var_86);
        wp::assign(var_35, var_125);
    goto start_while_0;
    end_while_0:;
    // own[0] = low                                                                           <L 174>
    wp::array_store(var_28, var_126, var_31);
    // own[1] = high                                                                          <L 175>
    wp::array_store(var_28, var_127, var_33);
}



template <bool wp_linear_contiguous>
static WP_FORCEINLINE void _fill_nodes__locals__fill_nodes_606d8a51_cpu_forward_tasks(
    wp::launch_bounds_t<1> *dim,
    wp_args__fill_nodes__locals__fill_nodes_606d8a51 *_wp_args)
{
    for (size_t task_index = 0; task_index < dim->size; ++task_index)
    {
        _fill_nodes__locals__fill_nodes_606d8a51_cpu_kernel_forward<wp_linear_contiguous>(*dim, task_index, _wp_args);
    }
}

static WP_FORCEINLINE void _fill_nodes__locals__fill_nodes_606d8a51_cpu_forward_dispatch(
    wp::launch_bounds_t<1> *dim,
    wp_args__fill_nodes__locals__fill_nodes_606d8a51 *_wp_args)
{
    wp::tile_shared_storage_t tile_mem;
#if defined(WP_ENABLE_TILES_IN_STACK_MEMORY)
    wp::shared_tile_storage = &tile_mem;
#endif

    _fill_nodes__locals__fill_nodes_606d8a51_cpu_forward_tasks<false>(dim, _wp_args);
}

extern "C" {

// Python CPU entry points
WP_API void _fill_nodes__locals__fill_nodes_606d8a51_cpu_forward(
    wp::launch_bounds_t<1> *dim,
    wp_args__fill_nodes__locals__fill_nodes_606d8a51 *_wp_args)
{
    _fill_nodes__locals__fill_nodes_606d8a51_cpu_forward_dispatch(dim, _wp_args);
}

} // extern C

