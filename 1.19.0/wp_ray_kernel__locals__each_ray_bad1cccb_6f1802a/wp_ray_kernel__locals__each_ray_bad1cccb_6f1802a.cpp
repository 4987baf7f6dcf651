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


struct Placement_e6d83c4e
{
    wp::int64 points;
    wp::int32 double_origins;
    wp::uint64 origins;
    wp::uint64 normals;
    wp::uint64 starts;
    wp::uint64 order;
    wp::uint64 ids;
    wp::vec_t<3, wp::float64> centre;
    wp::float64 scale;
    wp::float64 unit;
    wp::float64 reach;
    wp::vec_t<3, wp::float32> extent;
    wp::float32 coarseness;


    Placement_e6d83c4e() = default;
    CUDA_CALLABLE Placement_e6d83c4e(wp::int64 const& points,
    wp::int32 const& double_origins = {},
    wp::uint64 const& origins = {},
    wp::uint64 const& normals = {},
    wp::uint64 const& starts = {},
    wp::uint64 const& order = {},
    wp::uint64 const& ids = {},
    wp::vec_t<3, wp::float64> const& centre = {},
    wp::float64 const& scale = {},
    wp::float64 const& unit = {},
    wp::float64 const& reach = {},
    wp::vec_t<3, wp::float32> const& extent = {},
    wp::float32 const& coarseness = {})
        : points{points}
        , double_origins{double_origins}
        , origins{origins}
        , normals{normals}
        , starts{starts}
        , order{order}
        , ids{ids}
        , centre{centre}
        , scale{scale}
        , unit{unit}
        , reach{reach}
        , extent{extent}
        , coarseness{coarseness}

    {
    }

    CUDA_CALLABLE Placement_e6d83c4e& operator += (const Placement_e6d83c4e& rhs)
    {    points += rhs.points;
    double_origins += rhs.double_origins;
    origins += rhs.origins;
    normals += rhs.normals;
    starts += rhs.starts;
    order += rhs.order;
    ids += rhs.ids;
    centre += rhs.centre;
    scale += rhs.scale;
    unit += rhs.unit;
    reach += rhs.reach;
    extent += rhs.extent;
    coarseness += rhs.coarseness;

        return *this;}

};

static CUDA_CALLABLE void adj_Placement_e6d83c4e(wp::int64 const&,
    wp::int32 const&,
    wp::uint64 const&,
    wp::uint64 const&,
    wp::uint64 const&,
    wp::uint64 const&,
    wp::uint64 const&,
    wp::vec_t<3, wp::float64> const&,
    wp::float64 const&,
    wp::float64 const&,
    wp::float64 const&,
    wp::vec_t<3, wp::float32> const&,
    wp::float32 const&,
    wp::int64 & adj_points,
    wp::int32 & adj_double_origins,
    wp::uint64 & adj_origins,
    wp::uint64 & adj_normals,
    wp::uint64 & adj_starts,
    wp::uint64 & adj_order,
    wp::uint64 & adj_ids,
    wp::vec_t<3, wp::float64> & adj_centre,
    wp::float64 & adj_scale,
    wp::float64 & adj_unit,
    wp::float64 & adj_reach,
    wp::vec_t<3, wp::float32> & adj_extent,
    wp::float32 & adj_coarseness,
    Placement_e6d83c4e & adj_ret)
{
    adj_points += adj_ret.points;
    adj_double_origins += adj_ret.double_origins;
    adj_origins += adj_ret.origins;
    adj_normals += adj_ret.normals;
    adj_starts += adj_ret.starts;
    adj_order += adj_ret.order;
    adj_ids += adj_ret.ids;
    adj_centre += adj_ret.centre;
    adj_scale += adj_ret.scale;
    adj_unit += adj_ret.unit;
    adj_reach += adj_ret.reach;
    adj_extent += adj_ret.extent;
    adj_coarseness += adj_ret.coarseness;
}

// Required when compiling adjoints.
CUDA_CALLABLE Placement_e6d83c4e add(const Placement_e6d83c4e& a, const Placement_e6d83c4e& b)
{
    return Placement_e6d83c4e();
}

CUDA_CALLABLE void adj_atomic_add(Placement_e6d83c4e* p, Placement_e6d83c4e t)
{
    wp::adj_atomic_add(&p->points, t.points);
    wp::adj_atomic_add(&p->double_origins, t.double_origins);
    wp::adj_atomic_add(&p->origins, t.origins);
    wp::adj_atomic_add(&p->normals, t.normals);
    wp::adj_atomic_add(&p->starts, t.starts);
    wp::adj_atomic_add(&p->order, t.order);
    wp::adj_atomic_add(&p->ids, t.ids);
    wp::adj_atomic_add(&p->centre, t.centre);
    wp::adj_atomic_add(&p->scale, t.scale);
    wp::adj_atomic_add(&p->unit, t.unit);
    wp::adj_atomic_add(&p->reach, t.reach);
    wp::adj_atomic_add(&p->extent, t.extent);
    wp::adj_atomic_add(&p->coarseness, t.coarseness);
}




struct Accelerator_9fc73cd7
{
    wp::uint64 nodes;
    wp::uint64 leaves;
    wp::uint64 mesh;
    wp::uint64 start;
    wp::int32 starts;


    Accelerator_9fc73cd7() = default;
    CUDA_CALLABLE Accelerator_9fc73cd7(wp::uint64 const& nodes,
    wp::uint64 const& leaves = {},
    wp::uint64 const& mesh = {},
    wp::uint64 const& start = {},
    wp::int32 const& starts = {})
        : nodes{nodes}
        , leaves{leaves}
        , mesh{mesh}
        , start{start}
        , starts{starts}

    {
    }

    CUDA_CALLABLE Accelerator_9fc73cd7& operator += (const Accelerator_9fc73cd7& rhs)
    {    nodes += rhs.nodes;
    leaves += rhs.leaves;
    mesh += rhs.mesh;
    start += rhs.start;
    starts += rhs.starts;

        return *this;}

};

static CUDA_CALLABLE void adj_Accelerator_9fc73cd7(wp::uint64 const&,
    wp::uint64 const&,
    wp::uint64 const&,
    wp::uint64 const&,
    wp::int32 const&,
    wp::uint64 & adj_nodes,
    wp::uint64 & adj_leaves,
    wp::uint64 & adj_mesh,
    wp::uint64 & adj_start,
    wp::int32 & adj_starts,
    Accelerator_9fc73cd7 & adj_ret)
{
    adj_nodes += adj_ret.nodes;
    adj_leaves += adj_ret.leaves;
    adj_mesh += adj_ret.mesh;
    adj_start += adj_ret.start;
    adj_starts += adj_ret.starts;
}

// Required when compiling adjoints.
CUDA_CALLABLE Accelerator_9fc73cd7 add(const Accelerator_9fc73cd7& a, const Accelerator_9fc73cd7& b)
{
    return Accelerator_9fc73cd7();
}

CUDA_CALLABLE void adj_atomic_add(Accelerator_9fc73cd7* p, Accelerator_9fc73cd7 t)
{
    wp::adj_atomic_add(&p->nodes, t.nodes);
    wp::adj_atomic_add(&p->leaves, t.leaves);
    wp::adj_atomic_add(&p->mesh, t.mesh);
    wp::adj_atomic_add(&p->start, t.start);
    wp::adj_atomic_add(&p->starts, t.starts);
}




struct Glass_69c17290
{
    Accelerator_9fc73cd7 tree;
    wp::uint64 transmittance;


    Glass_69c17290() = default;
    CUDA_CALLABLE Glass_69c17290(Accelerator_9fc73cd7 const& tree,
    wp::uint64 const& transmittance = {})
        : tree{tree}
        , transmittance{transmittance}

    {
    }

    CUDA_CALLABLE Glass_69c17290& operator += (const Glass_69c17290& rhs)
    {    tree += rhs.tree;
    transmittance += rhs.transmittance;

        return *this;}

};

static CUDA_CALLABLE void adj_Glass_69c17290(Accelerator_9fc73cd7 const&,
    wp::uint64 const&,
    Accelerator_9fc73cd7 & adj_tree,
    wp::uint64 & adj_transmittance,
    Glass_69c17290 & adj_ret)
{
    adj_tree += adj_ret.tree;
    adj_transmittance += adj_ret.transmittance;
}

// Required when compiling adjoints.
CUDA_CALLABLE Glass_69c17290 add(const Glass_69c17290& a, const Glass_69c17290& b)
{
    return Glass_69c17290();
}

CUDA_CALLABLE void adj_atomic_add(Glass_69c17290* p, Glass_69c17290 t)
{
    adj_atomic_add(&p->tree, t.tree);
    wp::adj_atomic_add(&p->transmittance, t.transmittance);
}




struct Rays_3ba80fd7
{
    Placement_e6d83c4e placement;
    wp::int64 count;
    wp::int64 per_task;
    wp::int32 double_directions;
    wp::uint64 directions;
    wp::uint64 distance;
    wp::uint64 face;
    wp::uint64 visits;
    wp::uint64 first;
    wp::uint64 transmitted;
    Glass_69c17290 glass;


    Rays_3ba80fd7() = default;
    CUDA_CALLABLE Rays_3ba80fd7(Placement_e6d83c4e const& placement,
    wp::int64 const& count = {},
    wp::int64 const& per_task = {},
    wp::int32 const& double_directions = {},
    wp::uint64 const& directions = {},
    wp::uint64 const& distance = {},
    wp::uint64 const& face = {},
    wp::uint64 const& visits = {},
    wp::uint64 const& first = {},
    wp::uint64 const& transmitted = {},
    Glass_69c17290 const& glass = {})
        : placement{placement}
        , count{count}
        , per_task{per_task}
        , double_directions{double_directions}
        , directions{directions}
        , distance{distance}
        , face{face}
        , visits{visits}
        , first{first}
        , transmitted{transmitted}
        , glass{glass}

    {
    }

    CUDA_CALLABLE Rays_3ba80fd7& operator += (const Rays_3ba80fd7& rhs)
    {    placement += rhs.placement;
    count += rhs.count;
    per_task += rhs.per_task;
    double_directions += rhs.double_directions;
    directions += rhs.directions;
    distance += rhs.distance;
    face += rhs.face;
    visits += rhs.visits;
    first += rhs.first;
    transmitted += rhs.transmitted;
    glass += rhs.glass;

        return *this;}

};

static CUDA_CALLABLE void adj_Rays_3ba80fd7(Placement_e6d83c4e const&,
    wp::int64 const&,
    wp::int64 const&,
    wp::int32 const&,
    wp::uint64 const&,
    wp::uint64 const&,
    wp::uint64 const&,
    wp::uint64 const&,
    wp::uint64 const&,
    wp::uint64 const&,
    Glass_69c17290 const&,
    Placement_e6d83c4e & adj_placement,
    wp::int64 & adj_count,
    wp::int64 & adj_per_task,
    wp::int32 & adj_double_directions,
    wp::uint64 & adj_directions,
    wp::uint64 & adj_distance,
    wp::uint64 & adj_face,
    wp::uint64 & adj_visits,
    wp::uint64 & adj_first,
    wp::uint64 & adj_transmitted,
    Glass_69c17290 & adj_glass,
    Rays_3ba80fd7 & adj_ret)
{
    adj_placement += adj_ret.placement;
    adj_count += adj_ret.count;
    adj_per_task += adj_ret.per_task;
    adj_double_directions += adj_ret.double_directions;
    adj_directions += adj_ret.directions;
    adj_distance += adj_ret.distance;
    adj_face += adj_ret.face;
    adj_visits += adj_ret.visits;
    adj_first += adj_ret.first;
    adj_transmitted += adj_ret.transmitted;
    adj_glass += adj_ret.glass;
}

// Required when compiling adjoints.
CUDA_CALLABLE Rays_3ba80fd7 add(const Rays_3ba80fd7& a, const Rays_3ba80fd7& b)
{
    return Rays_3ba80fd7();
}

CUDA_CALLABLE void adj_atomic_add(Rays_3ba80fd7* p, Rays_3ba80fd7 t)
{
    adj_atomic_add(&p->placement, t.placement);
    wp::adj_atomic_add(&p->count, t.count);
    wp::adj_atomic_add(&p->per_task, t.per_task);
    wp::adj_atomic_add(&p->double_directions, t.double_directions);
    wp::adj_atomic_add(&p->directions, t.directions);
    wp::adj_atomic_add(&p->distance, t.distance);
    wp::adj_atomic_add(&p->face, t.face);
    wp::adj_atomic_add(&p->visits, t.visits);
    wp::adj_atomic_add(&p->first, t.first);
    wp::adj_atomic_add(&p->transmitted, t.transmitted);
    adj_atomic_add(&p->glass, t.glass);
}




// /work/main/warpsample/maths/memory.py:0
static wp::int64 _reader__locals__read_2(
    wp::uint64 var_address,
    wp::int64 var_i)
{
    //---------
    // primal vars
    wp::uint64 var_0;
    wp::uint64 var_1;
    wp::uint64 var_2;
    wp::uint64 var_3;
    const wp::int32 var_4 = 1;
    wp::tuple_t<wp::int32> var_5;
    wp::array_t<wp::int64> var_6;
    const wp::int32 var_7 = 1;
    const wp::int32 var_8 = 0;
    wp::int64* var_9;
    wp::int64 var_10;
    wp::int64 var_11;
    //---------
    // forward
    // def read(address: wp.uint64, i: Any):                                                  <L 1>
    // return wp.array(ptr=address + wp.uint64(i) * wp.uint64(size), shape=(1,), dtype=kind)[0]       <L 2>
    var_0 = wp::uint64(var_i);
    var_1 = 8ull;
    var_2 = wp::mul(var_0, var_1);
    var_3 = wp::add(var_address, var_2);
    var_5 = wp::tuple(var_4);
    var_6 = wp::array_t<wp::int64>(var_3, var_7);
    var_9 = wp::address(var_6, var_8);
    var_11 = wp::load(var_9);
    var_10 = wp::copy(var_11);
    return var_10;
}


// /work/main/warpsample/tracing/placement.py:115
static wp::int64 point_of_0(
    Placement_e6d83c4e var_placement,
    wp::int64 var_i)
{
    //---------
    // primal vars
    wp::uint64* var_0;
    wp::uint64 var_1;
    bool var_2;
    wp::uint64 var_3;
    wp::uint64* var_4;
    wp::int64 var_5;
    wp::uint64 var_6;
    //---------
    // forward
    // def point_of(placement: Placement, i: wp.int64) -> wp.int64:                           <L 116>
    // if placement.order == wp.uint64(0):                                                    <L 118>
    var_0 = &((var_placement).order);
    var_1 = 0ull;
    var_3 = wp::load(var_0);
    var_2 = (var_3 == var_1);
    if (var_2) {
        // return i                                                                           <L 119>
        return var_i;
    }
    // return long_at(placement.order, i)                                                     <L 120>
    var_4 = &((var_placement).order);
    var_6 = wp::load(var_4);
    var_5 = _reader__locals__read_2(var_6, var_i);
    return var_5;
}


// /work/main/warpsample/maths/memory.py:0
static wp::vec_t<3, wp::float64> _reader__locals__read_7(
    wp::uint64 var_address,
    wp::int64 var_i)
{
    //---------
    // primal vars
    wp::uint64 var_0;
    wp::uint64 var_1;
    wp::uint64 var_2;
    wp::uint64 var_3;
    const wp::int32 var_4 = 1;
    wp::tuple_t<wp::int32> var_5;
    wp::array_t<wp::vec_t<3, wp::float64>> var_6;
    const wp::int32 var_7 = 1;
    const wp::int32 var_8 = 0;
    wp::vec_t<3, wp::float64>* var_9;
    wp::vec_t<3, wp::float64> var_10;
    wp::vec_t<3, wp::float64> var_11;
    //---------
    // forward
    // def read(address: wp.uint64, i: Any):                                                  <L 1>
    // return wp.array(ptr=address + wp.uint64(i) * wp.uint64(size), shape=(1,), dtype=kind)[0]       <L 2>
    var_0 = wp::uint64(var_i);
    var_1 = 24ull;
    var_2 = wp::mul(var_0, var_1);
    var_3 = wp::add(var_address, var_2);
    var_5 = wp::tuple(var_4);
    var_6 = wp::array_t<wp::vec_t<3, wp::float64>>(var_3, var_7);
    var_9 = wp::address(var_6, var_8);
    var_11 = wp::load(var_9);
    var_10 = wp::copy(var_11);
    return var_10;
}


// /work/main/warpsample/maths/memory.py:0
static wp::vec_t<3, wp::float32> _reader__locals__read_5(
    wp::uint64 var_address,
    wp::int64 var_i)
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


// /work/main/warpsample/tracing/placement.py:0
static wp::vec_t<3, wp::float64> in_double_0(
    wp::vec_t<3, wp::float32> var_v)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float32 var_1;
    wp::float64 var_2;
    const wp::int32 var_3 = 1;
    wp::float32 var_4;
    wp::float64 var_5;
    const wp::int32 var_6 = 2;
    wp::float32 var_7;
    wp::float64 var_8;
    wp::vec_t<3, wp::float64> var_9;
    //---------
    // forward
    // def in_double(v: Any) -> wp.vec3d:                                                     <L 1>
    // return wp.vec3d(wp.float64(v[0]), wp.float64(v[1]), wp.float64(v[2]))                  <L 3>
    var_1 = wp::extract(var_v, var_0);
    var_2 = wp::float64(var_1);
    var_4 = wp::extract(var_v, var_3);
    var_5 = wp::float64(var_4);
    var_7 = wp::extract(var_v, var_6);
    var_8 = wp::float64(var_7);
    var_9 = wp::vec_t<3, wp::float64>(var_2, var_5, var_8);
    return var_9;
}


// /work/main/warpsample/tracing/placement.py:99
static wp::vec_t<3, wp::float64> vector_in_double_0(
    wp::uint64 var_address,
    wp::int32 var_double,
    wp::int64 var_i)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    bool var_1;
    wp::vec_t<3, wp::float64> var_2;
    wp::vec_t<3, wp::float32> var_3;
    wp::vec_t<3, wp::float64> var_4;
    //---------
    // forward
    // def vector_in_double(address: wp.uint64, double: wp.int32, i: wp.int64) -> wp.vec3d:       <L 100>
    // if double != 0:                                                                        <L 102>
    var_1 = (var_double != var_0);
    if (var_1) {
        // return vec3d_at(address, i)                                                        <L 103>
        var_2 = _reader__locals__read_7(var_address, var_i);
        return var_2;
    }
    // return in_double(vec3_at(address, i))                                                  <L 104>
    var_3 = _reader__locals__read_5(var_address, var_i);
    var_4 = in_double_0(var_3);
    return var_4;
}


// /work/main/warpsample/tracing/placement.py:131
static wp::vec_t<3, wp::float64> local_origin_0(
    Placement_e6d83c4e var_placement,
    wp::int64 var_point)
{
    //---------
    // primal vars
    wp::uint64* var_0;
    wp::int32* var_1;
    wp::vec_t<3, wp::float64> var_2;
    wp::uint64 var_3;
    wp::int32 var_4;
    wp::vec_t<3, wp::float64>* var_5;
    wp::vec_t<3, wp::float64> var_6;
    wp::vec_t<3, wp::float64> var_7;
    wp::float64* var_8;
    wp::vec_t<3, wp::float64> var_9;
    wp::float64 var_10;
    //---------
    // forward
    // def local_origin(placement: Placement, point: wp.int64) -> wp.vec3d:                   <L 132>
    // return (vector_in_double(placement.origins, placement.double_origins, point) - placement.centre) * placement.scale       <L 137>
    var_0 = &((var_placement).origins);
    var_1 = &((var_placement).double_origins);
    var_3 = wp::load(var_0);
    var_4 = wp::load(var_1);
    var_2 = vector_in_double_0(var_3, var_4, var_point);
    var_5 = &((var_placement).centre);
    var_7 = wp::load(var_5);
    var_6 = wp::sub(var_2, var_7);
    var_8 = &((var_placement).scale);
    var_10 = wp::load(var_8);
    var_9 = wp::mul(var_6, var_10);
    return var_9;
}


// /work/main/warpsample/tracing/placement.py:107
static wp::vec_t<3, wp::float64> unit_in_double_0(
    wp::vec_t<3, wp::float64> var_d,
    wp::int32 var_double)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    bool var_1;
    const wp::int32 var_2 = 0;
    wp::float64 var_3;
    wp::float64 var_4;
    const wp::int32 var_5 = 1;
    wp::float64 var_6;
    wp::float64 var_7;
    wp::float64 var_8;
    const wp::int32 var_9 = 2;
    wp::float64 var_10;
    wp::float64 var_11;
    wp::float64 var_12;
    wp::vec_t<3, wp::float64> var_13;
    wp::vec_t<3, wp::float64> var_14;
    const wp::float64 var_15 = 1.0;
    wp::float64 var_16;
    wp::float64 var_17;
    wp::float64 var_18;
    wp::vec_t<3, wp::float64> var_19;
    //---------
    // forward
    // def unit_in_double(d: wp.vec3d, double: wp.int32) -> wp.vec3d:                         <L 108>
    // if double != 0:  # squares of float64 components may over- or underflow                <L 110>
    var_1 = (var_double != var_0);
    if (var_1) {
        // d = d / wp.max(wp.max(wp.abs(d[0]), wp.abs(d[1])), wp.abs(d[2]))                   <L 111>
        var_3 = wp::extract(var_d, var_2);
        var_4 = wp::abs(var_3);
        var_6 = wp::extract(var_d, var_5);
        var_7 = wp::abs(var_6);
        var_8 = wp::max(var_4, var_7);
        var_10 = wp::extract(var_d, var_9);
        var_11 = wp::abs(var_10);
        var_12 = wp::max(var_8, var_11);
        var_13 = wp::div(var_d, var_12);
    }
    var_14 = wp::where(var_1, var_13, var_d);
    // return (ONE / wp.sqrt(wp.dot(d, d))) * d                                               <L 112>
    var_16 = wp::dot(var_14, var_14);
    var_17 = wp::sqrt(var_16);
    var_18 = wp::div(var_15, var_17);
    var_19 = wp::mul(var_18, var_14);
    return var_19;
}


// /work/main/warpsample/tracing/rays.py:80
static wp::vec_t<3, wp::float32> _direction_1(
    Rays_3ba80fd7 var_rays,
    wp::int64 var_ray)
{
    //---------
    // primal vars
    wp::int32* var_0;
    const wp::int32 var_1 = 0;
    bool var_2;
    wp::int32 var_3;
    wp::uint64* var_4;
    wp::vec_t<3, wp::float32> var_5;
    wp::uint64 var_6;
    wp::uint64* var_7;
    const wp::int32 var_8 = 1;
    wp::vec_t<3, wp::float64> var_9;
    wp::uint64 var_10;
    const wp::int32 var_11 = 1;
    wp::vec_t<3, wp::float64> var_12;
    wp::vec_t<3, wp::float32> var_13;
    //---------
    // forward
    // def _direction(rays: Rays, ray: wp.int64) -> wp.vec3:                                  <L 81>
    // if rays.double_directions == 0:                                                        <L 83>
    var_0 = &((var_rays).double_directions);
    var_3 = wp::load(var_0);
    var_2 = (var_3 == var_1);
    if (var_2) {
        // return vec3_at(rays.directions, ray)                                               <L 84>
        var_4 = &((var_rays).directions);
        var_6 = wp::load(var_4);
        var_5 = _reader__locals__read_5(var_6, var_ray);
        return var_5;
    }
    // return wp.vec3(unit_in_double(vector_in_double(rays.directions, 1, ray), 1))           <L 85>
    var_7 = &((var_rays).directions);
    var_10 = wp::load(var_7);
    var_9 = vector_in_double_0(var_10, var_8, var_ray);
    var_12 = unit_in_double_0(var_9, var_11);
    var_13 = wp::vec_t<3, wp::float32>(var_12);
    return var_13;
}


// /work/main/warpsample/tracing/placement.py:167
static bool is_far_off_0(
    wp::vec_t<3, wp::float64> var_o)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float64 var_1;
    wp::float64 var_2;
    const wp::int32 var_3 = 1;
    wp::float64 var_4;
    wp::float64 var_5;
    wp::float64 var_6;
    const wp::int32 var_7 = 2;
    wp::float64 var_8;
    wp::float64 var_9;
    wp::float64 var_10;
    const wp::float64 var_11 = 6.0;
    bool var_12;
    //---------
    // forward
    // def is_far_off(o: wp.vec3d) -> wp.bool:                                                <L 168>
    // return wp.max(wp.max(wp.abs(o[0]), wp.abs(o[1])), wp.abs(o[2])) > _FURTHEST            <L 170>
    var_1 = wp::extract(var_o, var_0);
    var_2 = wp::abs(var_1);
    var_4 = wp::extract(var_o, var_3);
    var_5 = wp::abs(var_4);
    var_6 = wp::max(var_2, var_5);
    var_8 = wp::extract(var_o, var_7);
    var_9 = wp::abs(var_8);
    var_10 = wp::max(var_6, var_9);
    var_12 = (var_10 > var_11);
    return var_12;
}


// /work/main/warpsample/tracing/placement.py:173
static wp::float64 distance_to_scene_0(
    wp::vec_t<3, wp::float64> var_o,
    wp::vec_t<3, wp::float64> var_d)
{
    //---------
    // primal vars
    const wp::float64 var_0 = 0.0;
    wp::float64 var_1;
    const wp::float32 var_2 = INFINITY;
    wp::float64 var_3;
    const wp::int32 var_4 = 0;
    const wp::float64 var_5 = 1.0;
    wp::float64 var_6;
    wp::float64 var_7;
    const wp::float64 var_8 = 1e-150;
    bool var_9;
    wp::float64 var_10;
    wp::float64 var_11;
    wp::float64 var_12;
    wp::float64 var_13;
    wp::float64 var_14;
    wp::float64 var_15;
    wp::float64 var_16;
    wp::float64 var_17;
    const wp::float64 var_18 = 1.25;
    wp::float64 var_19;
    wp::float64 var_20;
    wp::float64 var_21;
    wp::float64 var_22;
    wp::float64 var_23;
    wp::float64 var_24;
    const wp::int32 var_25 = 1;
    wp::float64 var_26;
    wp::float64 var_27;
    bool var_28;
    wp::float64 var_29;
    wp::float64 var_30;
    wp::float64 var_31;
    wp::float64 var_32;
    wp::float64 var_33;
    wp::float64 var_34;
    wp::float64 var_35;
    wp::float64 var_36;
    wp::float64 var_37;
    wp::float64 var_38;
    wp::float64 var_39;
    wp::float64 var_40;
    wp::float64 var_41;
    wp::float64 var_42;
    const wp::int32 var_43 = 2;
    wp::float64 var_44;
    wp::float64 var_45;
    bool var_46;
    wp::float64 var_47;
    wp::float64 var_48;
    wp::float64 var_49;
    wp::float64 var_50;
    wp::float64 var_51;
    wp::float64 var_52;
    wp::float64 var_53;
    wp::float64 var_54;
    wp::float64 var_55;
    wp::float64 var_56;
    wp::float64 var_57;
    wp::float64 var_58;
    wp::float64 var_59;
    wp::float64 var_60;
    bool var_61;
    bool var_62;
    wp::vec_t<3, wp::float64> var_63;
    wp::vec_t<3, wp::float64> var_64;
    bool var_65;
    bool var_66;
    wp::float64 var_67;
    wp::float64 var_68;
    //---------
    // forward
    // def distance_to_scene(o: wp.vec3d, d: wp.vec3d) -> wp.float64:                         <L 174>
    // enter = ZERO                                                                           <L 179>
    var_1 = wp::copy(var_0);
    // leave = wp.float64(wp.INF)                                                             <L 180>
    var_3 = INFINITY;
    // for axis in range(3):                                                                  <L 181>
    // inverse = ONE / wp.where(wp.abs(d[axis]) > _LEAST_STEP, d[axis], wp.copysign(_LEAST_STEP, d[axis]))       <L 182>
    var_6 = wp::extract(var_d, var_4);
    var_7 = wp::abs(var_6);
    var_9 = (var_7 > var_8);
    var_10 = wp::extract(var_d, var_4);
    var_11 = wp::extract(var_d, var_4);
    var_12 = wp::copysign(var_8, var_11);
    var_13 = wp::where(var_9, var_10, var_12);
    var_14 = wp::div(var_5, var_13);
    // middle = -o[axis] * inverse                                                            <L 183>
    var_15 = wp::extract(var_o, var_4);
    var_16 = wp::neg(var_15);
    var_17 = wp::mul(var_16, var_14);
    // half = wp.abs(_ENTRY * inverse)                                                        <L 184>
    var_19 = wp::mul(var_18, var_14);
    var_20 = wp::abs(var_19);
    // enter = wp.max(enter, middle - half)                                                   <L 185>
    var_21 = wp::sub(var_17, var_20);
    var_22 = wp::max(var_1, var_21);
    // leave = wp.min(leave, middle + half)                                                   <L 186>
    var_23 = wp::add(var_17, var_20);
    var_24 = wp::min(var_3, var_23);
    // inverse = ONE / wp.where(wp.abs(d[axis]) > _LEAST_STEP, d[axis], wp.copysign(_LEAST_STEP, d[axis]))       <L 182>
    var_26 = wp::extract(var_d, var_25);
    var_27 = wp::abs(var_26);
    var_28 = (var_27 > var_8);
    var_29 = wp::extract(var_d, var_25);
    var_30 = wp::extract(var_d, var_25);
    var_31 = wp::copysign(var_8, var_30);
    var_32 = wp::where(var_28, var_29, var_31);
    var_33 = wp::div(var_5, var_32);
    // middle = -o[axis] * inverse                                                            <L 183>
    var_34 = wp::extract(var_o, var_25);
    var_35 = wp::neg(var_34);
    var_36 = wp::mul(var_35, var_33);
    // half = wp.abs(_ENTRY * inverse)                                                        <L 184>
    var_37 = wp::mul(var_18, var_33);
    var_38 = wp::abs(var_37);
    // enter = wp.max(enter, middle - half)                                                   <L 185>
    var_39 = wp::sub(var_36, var_38);
    var_40 = wp::max(var_22, var_39);
    // leave = wp.min(leave, middle + half)                                                   <L 186>
    var_41 = wp::add(var_36, var_38);
    var_42 = wp::min(var_24, var_41);
    // inverse = ONE / wp.where(wp.abs(d[axis]) > _LEAST_STEP, d[axis], wp.copysign(_LEAST_STEP, d[axis]))       <L 182>
    var_44 = wp::extract(var_d, var_43);
    var_45 = wp::abs(var_44);
    var_46 = (var_45 > var_8);
    var_47 = wp::extract(var_d, var_43);
    var_48 = wp::extract(var_d, var_43);
    var_49 = wp::copysign(var_8, var_48);
    var_50 = wp::where(var_46, var_47, var_49);
    var_51 = wp::div(var_5, var_50);
    // middle = -o[axis] * inverse                                                            <L 183>
    var_52 = wp::extract(var_o, var_43);
    var_53 = wp::neg(var_52);
    var_54 = wp::mul(var_53, var_51);
    // half = wp.abs(_ENTRY * inverse)                                                        <L 184>
    var_55 = wp::mul(var_18, var_51);
    var_56 = wp::abs(var_55);
    // enter = wp.max(enter, middle - half)                                                   <L 185>
    var_57 = wp::sub(var_54, var_56);
    var_58 = wp::max(var_40, var_57);
    // leave = wp.min(leave, middle + half)                                                   <L 186>
    var_59 = wp::add(var_54, var_56);
    var_60 = wp::min(var_42, var_59);
    // return wp.where(enter < leave and not is_far_off(o + enter * d), enter, -ONE)          <L 187>
    var_62 = (var_58 < var_60);
    var_61 = var_62;
    if (var_61) {
        var_63 = wp::mul(var_58, var_d);
        var_64 = wp::add(var_o, var_63);
        var_65 = is_far_off_0(var_64);
        var_66 = wp::unot(var_65);
        var_61 = var_61 && var_66;
    }
    var_67 = wp::neg(var_5);
    var_68 = wp::where(var_61, var_58, var_67);
    return var_68;
}


// /work/main/warpsample/tracing/placement.py:140
static wp::float32 extent_along_0(
    wp::vec_t<3, wp::float32> var_extent,
    wp::vec_t<3, wp::float32> var_n)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float32 var_1;
    wp::float32 var_2;
    const wp::int32 var_3 = 0;
    wp::float32 var_4;
    wp::float32 var_5;
    const wp::int32 var_6 = 1;
    wp::float32 var_7;
    wp::float32 var_8;
    const wp::int32 var_9 = 1;
    wp::float32 var_10;
    wp::float32 var_11;
    wp::float32 var_12;
    const wp::int32 var_13 = 2;
    wp::float32 var_14;
    wp::float32 var_15;
    const wp::int32 var_16 = 2;
    wp::float32 var_17;
    wp::float32 var_18;
    wp::float32 var_19;
    //---------
    // forward
    // def extent_along(extent: wp.vec3, n: wp.vec3) -> wp.float32:                           <L 141>
    // return wp.abs(n[0]) * extent[0] + wp.abs(n[1]) * extent[1] + wp.abs(n[2]) * extent[2]       <L 146>
    var_1 = wp::extract(var_n, var_0);
    var_2 = wp::abs(var_1);
    var_4 = wp::extract(var_extent, var_3);
    var_5 = wp::mul(var_2, var_4);
    var_7 = wp::extract(var_n, var_6);
    var_8 = wp::abs(var_7);
    var_10 = wp::extract(var_extent, var_9);
    var_11 = wp::mul(var_8, var_10);
    var_12 = wp::add(var_5, var_11);
    var_14 = wp::extract(var_n, var_13);
    var_15 = wp::abs(var_14);
    var_17 = wp::extract(var_extent, var_16);
    var_18 = wp::mul(var_15, var_17);
    var_19 = wp::add(var_12, var_18);
    return var_19;
}


// /work/main/warpsample/tracing/placement.py:155
static wp::float32 offset_within_0(
    wp::vec_t<3, wp::float32> var_extent,
    wp::float32 var_coarseness,
    wp::vec_t<3, wp::float32> var_n)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 1.9073486328125e-06;
    wp::float32 var_1;
    wp::float32 var_2;
    wp::float32 var_3;
    //---------
    // forward
    // def offset_within(extent: wp.vec3, coarseness: wp.float32, n: wp.vec3) -> wp.float32:       <L 156>
    // return _OFFSET * extent_along(extent, n) + coarseness                                  <L 158>
    var_1 = extent_along_0(var_extent, var_n);
    var_2 = wp::mul(var_0, var_1);
    var_3 = wp::add(var_2, var_coarseness);
    return var_3;
}


// /work/main/warpsample/tracing/placement.py:161
static wp::float32 origin_offset_0(
    Placement_e6d83c4e var_placement,
    wp::vec_t<3, wp::float32> var_n)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float32>* var_0;
    wp::float32* var_1;
    wp::float32 var_2;
    wp::vec_t<3, wp::float32> var_3;
    wp::float32 var_4;
    //---------
    // forward
    // def origin_offset(placement: Placement, n: wp.vec3) -> wp.float32:                     <L 162>
    // return offset_within(placement.extent, placement.coarseness, n)                        <L 164>
    var_0 = &((var_placement).extent);
    var_1 = &((var_placement).coarseness);
    var_3 = wp::load(var_0);
    var_4 = wp::load(var_1);
    var_2 = offset_within_0(var_3, var_4, var_n);
    return var_2;
}


// /work/main/warpsample/tracing/queries.py:77
static void set_origin_0(
    wp::uint64 var_chunk,
    wp::int32 var_k,
    wp::vec_t<3, wp::float32> var_o)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 1664;
    wp::tuple_t<wp::int32> var_1;
    wp::array_t<wp::float32> var_2;
    const wp::int32 var_3 = 1664;
    const wp::int32 var_4 = 0;
    wp::float32 var_5;
    const wp::int32 var_6 = 0;
    wp::int32 var_7;
    const wp::int32 var_8 = 1;
    wp::float32 var_9;
    const wp::int32 var_10 = 64;
    wp::int32 var_11;
    wp::int32 var_12;
    const wp::int32 var_13 = 2;
    wp::float32 var_14;
    const wp::int32 var_15 = 2;
    wp::int32 var_16;
    wp::int32 var_17;
    wp::int32 var_18;
    //---------
    // forward
    // def set_origin(chunk: wp.uint64, k: wp.int32, o: wp.vec3):                             <L 78>
    // rows = wp.array(ptr=chunk, shape=(CHUNK_FLOATS,), dtype=wp.float32)                    <L 80>
    var_1 = wp::tuple(var_0);
    var_2 = wp::array_t<wp::float32>(var_chunk, var_3);
    // rows[ORIGIN + k] = o[0]                                                                <L 81>
    var_5 = wp::extract(var_o, var_4);
    var_7 = wp::add(var_6, var_k);
    wp::array_store(var_2, var_7, var_5);
    // rows[ORIGIN + CHUNK + k] = o[1]                                                        <L 82>
    var_9 = wp::extract(var_o, var_8);
    var_11 = wp::add(var_6, var_10);
    var_12 = wp::add(var_11, var_k);
    wp::array_store(var_2, var_12, var_9);
    // rows[ORIGIN + 2 * CHUNK + k] = o[2]                                                    <L 83>
    var_14 = wp::extract(var_o, var_13);
    var_16 = wp::mul(var_15, var_10);
    var_17 = wp::add(var_6, var_16);
    var_18 = wp::add(var_17, var_k);
    wp::array_store(var_2, var_18, var_14);
}


// /work/main/warpsample/tracing/queries.py:68
static void set_direction_0(
    wp::uint64 var_chunk,
    wp::int32 var_k,
    wp::vec_t<3, wp::float32> var_d)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 1664;
    wp::tuple_t<wp::int32> var_1;
    wp::array_t<wp::float32> var_2;
    const wp::int32 var_3 = 1664;
    const wp::int32 var_4 = 0;
    wp::float32 var_5;
    const wp::int32 var_6 = 192;
    wp::int32 var_7;
    const wp::int32 var_8 = 1;
    wp::float32 var_9;
    const wp::int32 var_10 = 64;
    wp::int32 var_11;
    wp::int32 var_12;
    const wp::int32 var_13 = 2;
    wp::float32 var_14;
    const wp::int32 var_15 = 2;
    wp::int32 var_16;
    wp::int32 var_17;
    wp::int32 var_18;
    //---------
    // forward
    // def set_direction(chunk: wp.uint64, k: wp.int32, d: wp.vec3):                          <L 69>
    // rows = wp.array(ptr=chunk, shape=(CHUNK_FLOATS,), dtype=wp.float32)                    <L 71>
    var_1 = wp::tuple(var_0);
    var_2 = wp::array_t<wp::float32>(var_chunk, var_3);
    // rows[DIRECTION + k] = d[0]                                                             <L 72>
    var_5 = wp::extract(var_d, var_4);
    var_7 = wp::add(var_6, var_k);
    wp::array_store(var_2, var_7, var_5);
    // rows[DIRECTION + CHUNK + k] = d[1]                                                     <L 73>
    var_9 = wp::extract(var_d, var_8);
    var_11 = wp::add(var_6, var_10);
    var_12 = wp::add(var_11, var_k);
    wp::array_store(var_2, var_12, var_9);
    // rows[DIRECTION + 2 * CHUNK + k] = d[2]                                                 <L 74>
    var_14 = wp::extract(var_d, var_13);
    var_16 = wp::mul(var_15, var_10);
    var_17 = wp::add(var_6, var_16);
    var_18 = wp::add(var_17, var_k);
    wp::array_store(var_2, var_18, var_14);
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


// /work/main/warpsample/tracing/rays.py:88
static void _load_ray_0(
    Rays_3ba80fd7 var_rays,
    wp::int64 var_point,
    wp::vec_t<3, wp::float64> var_o,
    wp::int64 var_ray,
    wp::uint64 var_column)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float32> var_0;
    const wp::float64 var_1 = 0.0;
    wp::float64 var_2;
    bool var_3;
    wp::uint64* var_4;
    wp::int32* var_5;
    wp::vec_t<3, wp::float64> var_6;
    wp::uint64 var_7;
    wp::int32 var_8;
    wp::int32* var_9;
    wp::vec_t<3, wp::float64> var_10;
    wp::int32 var_11;
    wp::float64 var_12;
    bool var_13;
    wp::vec_t<3, wp::float64> var_14;
    wp::vec_t<3, wp::float64> var_15;
    wp::vec_t<3, wp::float64> var_16;
    wp::vec_t<3, wp::float64> var_17;
    wp::vec_t<3, wp::float64> var_18;
    wp::float64 var_19;
    wp::vec_t<3, wp::float32> var_20;
    bool var_21;
    Placement_e6d83c4e* var_22;
    wp::uint64* var_23;
    wp::uint64 var_24;
    bool var_25;
    wp::uint64 var_26;
    bool var_27;
    Placement_e6d83c4e* var_28;
    wp::uint64* var_29;
    wp::vec_t<3, wp::float32> var_30;
    wp::uint64 var_31;
    wp::float32 var_32;
    Placement_e6d83c4e* var_33;
    wp::uint64* var_34;
    wp::uint64 var_35;
    bool var_36;
    wp::uint64 var_37;
    Placement_e6d83c4e* var_38;
    wp::float32 var_39;
    Placement_e6d83c4e var_40;
    wp::float32 var_41;
    wp::vec_t<3, wp::float32> var_42;
    wp::vec_t<3, wp::float32> var_43;
    Placement_e6d83c4e* var_44;
    wp::uint64* var_45;
    wp::int64 var_46;
    wp::int64 var_47;
    const wp::float32 var_48 = 0.0;
    bool var_49;
    wp::int64 var_50;
    wp::int64 var_51;
    wp::int64 var_52;
    wp::int64 var_53;
    wp::vec_t<3, wp::float32> var_54;
    wp::uint64 var_55;
    wp::vec_t<3, wp::float32> var_56;
    wp::vec_t<3, wp::float32> var_57;
    const wp::int32 var_58 = 0;
    const wp::int32 var_59 = 0;
    const wp::int32 var_60 = 384;
    bool var_61;
    const wp::float32 var_62 = -1.0;
    Placement_e6d83c4e* var_63;
    wp::float64* var_64;
    wp::float64 var_65;
    wp::float64 var_66;
    wp::float32 var_67;
    wp::float32 var_68;
    const wp::int32 var_69 = 448;
    wp::float32 var_70;
    //---------
    // forward
    // def _load_ray(rays: Rays, point: wp.int64, o: wp.vec3d, ray: wp.int64, column: wp.uint64):       <L 89>
    // d = _direction(rays, ray)                                                              <L 91>
    var_0 = _direction_1(var_rays, var_ray);
    // ahead = ZERO                                                                           <L 92>
    var_2 = wp::copy(var_1);
    // if is_far_off(o):                                                                      <L 93>
    var_3 = is_far_off_0(var_o);
    if (var_3) {
        // unit = unit_in_double(vector_in_double(rays.directions, rays.double_directions, ray), rays.double_directions)       <L 94>
        var_4 = &((var_rays).directions);
        var_5 = &((var_rays).double_directions);
        var_7 = wp::load(var_4);
        var_8 = wp::load(var_5);
        var_6 = vector_in_double_0(var_7, var_8, var_ray);
        var_9 = &((var_rays).double_directions);
        var_11 = wp::load(var_9);
        var_10 = unit_in_double_0(var_6, var_11);
        // ahead = distance_to_scene(o, unit)                                                 <L 95>
        var_12 = distance_to_scene_0(var_o, var_10);
        // o = wp.where(ahead < ZERO, o - o, o + ahead * unit)  # for a ray that misses: 0, or NaN if not finite       <L 96>
        var_13 = (var_12 < var_1);
        var_14 = wp::sub(var_o, var_o);
        var_15 = wp::mul(var_12, var_10);
        var_16 = wp::add(var_o, var_15);
        var_17 = wp::where(var_13, var_14, var_16);
    }
    var_18 = wp::where(var_3, var_17, var_o);
    var_19 = wp::where(var_3, var_12, var_2);
    // start = wp.vec3(o)                                                                     <L 97>
    var_20 = wp::vec_t<3, wp::float32>(var_18);
    // if rays.placement.normals != wp.uint64(0) and ahead == ZERO:                           <L 98>
    var_22 = &((var_rays).placement);
    var_23 = &(((var_rays).placement).normals);
    var_24 = 0ull;
    var_26 = wp::load(var_23);
    var_25 = (var_26 != var_24);
    var_21 = var_25;
    if (var_21) {
        var_27 = (var_19 == var_1);
        var_21 = var_21 && var_27;
    }
    if (var_21) {
        // n = vec3_at(rays.placement.normals, point)                                         <L 99>
        var_28 = &((var_rays).placement);
        var_29 = &(((var_rays).placement).normals);
        var_31 = wp::load(var_29);
        var_30 = _reader__locals__read_5(var_31, var_point);
        // forward = wp.dot(n, d)                                                             <L 100>
        var_32 = wp::dot(var_30, var_0);
        // if rays.placement.starts == wp.uint64(0):                                          <L 101>
        var_33 = &((var_rays).placement);
        var_34 = &(((var_rays).placement).starts);
        var_35 = 0ull;
        var_37 = wp::load(var_34);
        var_36 = (var_37 == var_35);
        if (var_36) {
            // start += wp.copysign(origin_offset(rays.placement, n), forward) * n            <L 102>
            var_38 = &((var_rays).placement);
            var_40 = wp::load(var_38);
            var_39 = origin_offset_0(var_40, var_30);
            var_41 = wp::copysign(var_39, var_32);
            var_42 = wp::mul(var_41, var_30);
            var_43 = wp::add(var_20, var_42);
        }
        if (!var_36) {
            // start = vec3_at(rays.placement.starts, wp.int64(2) * point + wp.where(forward < 0.0, wp.int64(1), wp.int64(0)))       <L 104>
            var_44 = &((var_rays).placement);
            var_45 = &(((var_rays).placement).starts);
            var_46 = 2ll;
            var_47 = wp::mul(var_46, var_point);
            var_49 = (var_32 < var_48);
            var_50 = 1ll;
            var_51 = 0ll;
            var_52 = wp::where(var_49, var_50, var_51);
            var_53 = wp::add(var_47, var_52);
            var_55 = wp::load(var_45);
            var_54 = _reader__locals__read_5(var_55, var_53);
        }
        var_56 = wp::where(var_36, var_43, var_54);
    }
    var_57 = wp::where(var_21, var_56, var_20);
    // set_origin(column, 0, start)                                                           <L 105>
    set_origin_0(var_column, var_58, var_57);
    // set_direction(column, 0, d)                                                            <L 106>
    set_direction_0(var_column, var_59, var_0);
    // set_float(column, REACH, wp.where(ahead < ZERO, -1.0, wp.float32(rays.placement.reach - ahead)))       <L 107>
    var_61 = (var_19 < var_1);
    var_63 = &((var_rays).placement);
    var_64 = &(((var_rays).placement).reach);
    var_66 = wp::load(var_64);
    var_65 = wp::sub(var_66, var_19);
    var_67 = wp::float32(var_65);
    var_68 = wp::where(var_61, var_62, var_67);
    _writer__locals__write_0(var_column, var_60, var_68);
    // set_float(column, AHEAD, wp.float32(ahead))                                            <L 108>
    var_70 = wp::float32(var_19);
    _writer__locals__write_0(var_column, var_69, var_70);
}


// /work/main/warpsample/maths/numerics.py:50
static CUDA_CALLABLE wp::float32 fma_0(
    wp::float32 a,
    wp::float32 b,
    wp::float32 c)
{

#if defined(__CUDA_ARCH__)
    return fmaf(a, b, c);
#else
    return __builtin_fmaf(a, b, c);
#endif
}


// /work/main/warpsample/maths/numerics.py:175
static wp::vec_t<4, wp::float32> scaled_to_unit_0(
    wp::vec_t<3, wp::float32> var_v)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float32 var_1;
    wp::int32 var_2;
    const wp::int32 var_3 = 2139095040;
    wp::int32 var_4;
    const wp::int32 var_5 = 1;
    wp::float32 var_6;
    wp::int32 var_7;
    wp::int32 var_8;
    const wp::int32 var_9 = 2;
    wp::float32 var_10;
    wp::int32 var_11;
    wp::int32 var_12;
    wp::int32 var_13;
    wp::int32 var_14;
    const wp::int32 var_15 = 2130706432;
    wp::int32 var_16;
    const wp::int32 var_17 = 8388608;
    wp::int32 var_18;
    wp::float32 var_19;
    const wp::int32 var_20 = 0;
    wp::float32 var_21;
    wp::float32 var_22;
    const wp::int32 var_23 = 1;
    wp::float32 var_24;
    wp::float32 var_25;
    const wp::int32 var_26 = 2;
    wp::float32 var_27;
    wp::float32 var_28;
    const wp::float32 var_29 = 0.5;
    wp::float32 var_30;
    wp::float32 var_31;
    wp::float32 var_32;
    wp::float32 var_33;
    const wp::int32 var_34 = 1593268870;
    wp::int32 var_35;
    const wp::int32 var_36 = 1;
    wp::int32 var_37;
    wp::int32 var_38;
    wp::float32 var_39;
    wp::float32 var_40;
    wp::float32 var_41;
    const wp::float32 var_42 = 1.5;
    wp::float32 var_43;
    wp::float32 var_44;
    wp::float32 var_45;
    wp::float32 var_46;
    const wp::float32 var_47 = 1.5;
    wp::float32 var_48;
    wp::float32 var_49;
    wp::float32 var_50;
    wp::float32 var_51;
    wp::float32 var_52;
    const wp::float32 var_53 = 0.5;
    wp::float32 var_54;
    wp::float32 var_55;
    wp::float32 var_56;
    const wp::float32 var_57 = 1.0;
    wp::float32 var_58;
    wp::float32 var_59;
    wp::float32 var_60;
    wp::float32 var_61;
    wp::float32 var_62;
    wp::float32 var_63;
    wp::float32 var_64;
    wp::vec_t<4, wp::float32> var_65;
    //---------
    // forward
    // def scaled_to_unit(v: wp.vec3) -> wp.vec4:                                             <L 176>
    // ex = wp.cast(v[0], wp.int32) & _EXPONENT_MASK                                          <L 185>
    var_1 = wp::extract(var_v, var_0);
    var_2 = wp::cast<wp::int32>(var_1);
    var_4 = wp::bit_and(var_2, var_3);
    // ey = wp.cast(v[1], wp.int32) & _EXPONENT_MASK                                          <L 186>
    var_6 = wp::extract(var_v, var_5);
    var_7 = wp::cast<wp::int32>(var_6);
    var_8 = wp::bit_and(var_7, var_3);
    // ez = wp.cast(v[2], wp.int32) & _EXPONENT_MASK                                          <L 187>
    var_10 = wp::extract(var_v, var_9);
    var_11 = wp::cast<wp::int32>(var_10);
    var_12 = wp::bit_and(var_11, var_3);
    // exponent = wp.max(wp.max(ex, ey), ez)                                                  <L 188>
    var_13 = wp::max(var_4, var_8);
    var_14 = wp::max(var_13, var_12);
    // scale = wp.cast(wp.max(_EXPONENT_OF_2_127 - exponent, _EXPONENT_OF_2_MINUS_126), wp.float32)       <L 189>
    var_16 = wp::sub(var_15, var_14);
    var_18 = wp::max(var_16, var_17);
    var_19 = wp::cast<wp::float32>(var_18);
    // x = v[0] * scale                                                                       <L 190>
    var_21 = wp::extract(var_v, var_20);
    var_22 = wp::mul(var_21, var_19);
    // y = v[1] * scale                                                                       <L 191>
    var_24 = wp::extract(var_v, var_23);
    var_25 = wp::mul(var_24, var_19);
    // z = v[2] * scale                                                                       <L 192>
    var_27 = wp::extract(var_v, var_26);
    var_28 = wp::mul(var_27, var_19);
    // half_square = 0.5 * fma(x, x, fma(y, y, z * z))                                        <L 193>
    var_30 = wp::mul(var_28, var_28);
    var_31 = fma_0(var_25, var_25, var_30);
    var_32 = fma_0(var_22, var_22, var_31);
    var_33 = wp::mul(var_29, var_32);
    // inverse = wp.cast(_INVERSE_ROOT_SEED - (wp.cast(half_square, wp.int32) >> 1), wp.float32)       <L 194>
    var_35 = wp::cast<wp::int32>(var_33);
    var_37 = wp::rshift(var_35, var_36);
    var_38 = wp::sub(var_34, var_37);
    var_39 = wp::cast<wp::float32>(var_38);
    // inverse = inverse * fma(-half_square * inverse, inverse, 1.5)                          <L 195>
    var_40 = wp::neg(var_33);
    var_41 = wp::mul(var_40, var_39);
    var_43 = fma_0(var_41, var_39, var_42);
    var_44 = wp::mul(var_39, var_43);
    // inverse = inverse * fma(-half_square * inverse, inverse, 1.5)                          <L 196>
    var_45 = wp::neg(var_33);
    var_46 = wp::mul(var_45, var_44);
    var_48 = fma_0(var_46, var_44, var_47);
    var_49 = wp::mul(var_44, var_48);
    // x = x * inverse                                                                        <L 197>
    var_50 = wp::mul(var_22, var_49);
    // y = y * inverse                                                                        <L 198>
    var_51 = wp::mul(var_25, var_49);
    // z = z * inverse                                                                        <L 199>
    var_52 = wp::mul(var_28, var_49);
    // half_error = 0.5 * fma(-x, x, fma(-y, y, fma(-z, z, 1.0)))                             <L 200>
    var_54 = wp::neg(var_50);
    var_55 = wp::neg(var_51);
    var_56 = wp::neg(var_52);
    var_58 = fma_0(var_56, var_52, var_57);
    var_59 = fma_0(var_55, var_51, var_58);
    var_60 = fma_0(var_54, var_50, var_59);
    var_61 = wp::mul(var_53, var_60);
    // return wp.vec4(fma(x, half_error, x), fma(y, half_error, y), fma(z, half_error, z), half_error)       <L 201>
    var_62 = fma_0(var_50, var_61, var_50);
    var_63 = fma_0(var_51, var_61, var_51);
    var_64 = fma_0(var_52, var_61, var_52);
    var_65 = wp::vec_t<4, wp::float32>(var_62, var_63, var_64, var_61);
    return var_65;
}


// /work/main/warpsample/maths/numerics.py:204
static wp::vec_t<4, wp::float32> direction_to_unit_0(
    wp::vec_t<3, wp::float32> var_v)
{
    //---------
    // primal vars
    const wp::float32 var_0 = -0.5;
    const wp::int32 var_1 = 0;
    wp::float32 var_2;
    wp::float32 var_3;
    const wp::int32 var_4 = 0;
    wp::float32 var_5;
    const wp::float32 var_6 = -0.5;
    const wp::int32 var_7 = 1;
    wp::float32 var_8;
    wp::float32 var_9;
    const wp::int32 var_10 = 1;
    wp::float32 var_11;
    const wp::float32 var_12 = -0.5;
    const wp::int32 var_13 = 2;
    wp::float32 var_14;
    wp::float32 var_15;
    const wp::int32 var_16 = 2;
    wp::float32 var_17;
    const wp::float32 var_18 = 0.5;
    wp::float32 var_19;
    wp::float32 var_20;
    wp::float32 var_21;
    wp::float32 var_22;
    const wp::float32 var_23 = 9.5367431640625e-07;
    bool var_24;
    const wp::int32 var_25 = 0;
    wp::float32 var_26;
    const wp::int32 var_27 = 0;
    wp::float32 var_28;
    wp::float32 var_29;
    const wp::int32 var_30 = 1;
    wp::float32 var_31;
    const wp::int32 var_32 = 1;
    wp::float32 var_33;
    wp::float32 var_34;
    const wp::int32 var_35 = 2;
    wp::float32 var_36;
    const wp::int32 var_37 = 2;
    wp::float32 var_38;
    wp::float32 var_39;
    wp::vec_t<4, wp::float32> var_40;
    wp::vec_t<4, wp::float32> var_41;
    //---------
    // forward
    // def direction_to_unit(v: wp.vec3) -> wp.vec4:                                          <L 205>
    // half_error = fma(-0.5 * v[0], v[0], fma(-0.5 * v[1], v[1], fma(-0.5 * v[2], v[2], 0.5)))       <L 211>
    var_2 = wp::extract(var_v, var_1);
    var_3 = wp::mul(var_0, var_2);
    var_5 = wp::extract(var_v, var_4);
    var_8 = wp::extract(var_v, var_7);
    var_9 = wp::mul(var_6, var_8);
    var_11 = wp::extract(var_v, var_10);
    var_14 = wp::extract(var_v, var_13);
    var_15 = wp::mul(var_12, var_14);
    var_17 = wp::extract(var_v, var_16);
    var_19 = fma_0(var_15, var_17, var_18);
    var_20 = fma_0(var_9, var_11, var_19);
    var_21 = fma_0(var_3, var_5, var_20);
    // if wp.abs(half_error) < _ALMOST_UNIT:                                                  <L 212>
    var_22 = wp::abs(var_21);
    var_24 = (var_22 < var_23);
    if (var_24) {
        // return wp.vec4(fma(v[0], half_error, v[0]), fma(v[1], half_error, v[1]), fma(v[2], half_error, v[2]), half_error)       <L 213>
        var_26 = wp::extract(var_v, var_25);
        var_28 = wp::extract(var_v, var_27);
        var_29 = fma_0(var_26, var_21, var_28);
        var_31 = wp::extract(var_v, var_30);
        var_33 = wp::extract(var_v, var_32);
        var_34 = fma_0(var_31, var_21, var_33);
        var_36 = wp::extract(var_v, var_35);
        var_38 = wp::extract(var_v, var_37);
        var_39 = fma_0(var_36, var_21, var_38);
        var_40 = wp::vec_t<4, wp::float32>(var_29, var_34, var_39, var_21);
        return var_40;
    }
    // return scaled_to_unit(v)                                                               <L 214>
    var_41 = scaled_to_unit_0(var_v);
    return var_41;
}


// /work/main/warpsample/tracing/rays.py:111
static void _normalize_0(
    wp::uint64 var_chunk,
    wp::int64 var_length)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 1664;
    wp::tuple_t<wp::int32> var_1;
    wp::array_t<wp::float32> var_2;
    const wp::int32 var_3 = 1664;
    const wp::int32 var_4 = 0;
    wp::int32 var_5;
    wp::int32 var_6;
    bool var_7;
    const wp::int32 var_8 = 192;
    wp::int32 var_9;
    wp::float32* var_10;
    const wp::int32 var_11 = 64;
    wp::int32 var_12;
    wp::int32 var_13;
    wp::float32* var_14;
    const wp::int32 var_15 = 2;
    wp::int32 var_16;
    wp::int32 var_17;
    wp::int32 var_18;
    wp::float32* var_19;
    wp::vec_t<3, wp::float32> var_20;
    wp::float32 var_21;
    wp::float32 var_22;
    wp::float32 var_23;
    wp::vec_t<4, wp::float32> var_24;
    const wp::int32 var_25 = 0;
    wp::float32 var_26;
    wp::int32 var_27;
    const wp::int32 var_28 = 1;
    wp::float32 var_29;
    wp::int32 var_30;
    wp::int32 var_31;
    const wp::int32 var_32 = 2;
    wp::float32 var_33;
    const wp::int32 var_34 = 2;
    wp::int32 var_35;
    wp::int32 var_36;
    wp::int32 var_37;
    wp::float32* var_38;
    wp::float32* var_39;
    wp::float32 var_40;
    wp::float32 var_41;
    wp::float32 var_42;
    wp::int32 var_43;
    wp::float32* var_44;
    wp::int32 var_45;
    wp::float32* var_46;
    wp::float32 var_47;
    wp::float32 var_48;
    wp::float32 var_49;
    wp::float32 var_50;
    const wp::int32 var_51 = 2;
    wp::int32 var_52;
    wp::int32 var_53;
    wp::float32* var_54;
    const wp::int32 var_55 = 2;
    wp::int32 var_56;
    wp::int32 var_57;
    wp::float32* var_58;
    wp::float32 var_59;
    wp::float32 var_60;
    wp::float32 var_61;
    wp::float32 var_62;
    const wp::int32 var_63 = 3;
    wp::float32 var_64;
    wp::float32 var_65;
    const wp::float32 var_66 = 0.1;
    bool var_67;
    const wp::int32 var_68 = 1;
    const wp::int32 var_69 = 0;
    wp::int32 var_70;
    const wp::float32 var_71 = 0.0;
    bool var_72;
    const wp::int32 var_73 = 1;
    const wp::int32 var_74 = 0;
    wp::int32 var_75;
    wp::int32 var_76;
    const wp::int32 var_77 = 0;
    bool var_78;
    const wp::int32 var_79 = 384;
    wp::int32 var_80;
    wp::float32* var_81;
    const wp::float32 var_82 = NAN;
    const wp::float32 var_83 = NAN;
    wp::float32 var_84;
    wp::float32 var_85;
    wp::float32 var_86;
    wp::int32 var_87;
    const wp::int32 var_88 = 1;
    wp::int32 var_89;
    //---------
    // forward
    // def _normalize(chunk: wp.uint64, length: wp.int64):                                    <L 112>
    // rays = wp.array(ptr=chunk, shape=(CHUNK_FLOATS,), dtype=wp.float32)                    <L 114>
    var_1 = wp::tuple(var_0);
    var_2 = wp::array_t<wp::float32>(var_chunk, var_3);
    // k = wp.int32(0)                                                                        <L 115>
    var_5 = wp::int32(var_4);
    // while k < wp.int32(length):                                                            <L 116>
    start_while_0:;
    var_6 = wp::int32(var_length);
    var_7 = (var_5 < var_6);
    if ((var_7) == false) goto end_while_0;
        // unit = direction_to_unit(wp.vec3(rays[DIRECTION + k], rays[DIRECTION + CHUNK + k], rays[DIRECTION + 2 * CHUNK + k]))       <L 117>
        var_9 = wp::add(var_8, var_5);
        var_10 = wp::address(var_2, var_9);
        var_12 = wp::add(var_8, var_11);
        var_13 = wp::add(var_12, var_5);
        var_14 = wp::address(var_2, var_13);
        var_16 = wp::mul(var_15, var_11);
        var_17 = wp::add(var_8, var_16);
        var_18 = wp::add(var_17, var_5);
        var_19 = wp::address(var_2, var_18);
        var_21 = wp::load(var_10);
        var_22 = wp::load(var_14);
        var_23 = wp::load(var_19);
        var_20 = wp::vec_t<3, wp::float32>(var_21, var_22, var_23);
        var_24 = direction_to_unit_0(var_20);
        // rays[DIRECTION + k] = unit[0]                                                      <L 118>
        var_26 = wp::extract(var_24, var_25);
        var_27 = wp::add(var_8, var_5);
        wp::array_store(var_2, var_27, var_26);
        // rays[DIRECTION + CHUNK + k] = unit[1]                                              <L 119>
        var_29 = wp::extract(var_24, var_28);
        var_30 = wp::add(var_8, var_11);
        var_31 = wp::add(var_30, var_5);
        wp::array_store(var_2, var_31, var_29);
        // rays[DIRECTION + 2 * CHUNK + k] = unit[2]                                          <L 120>
        var_33 = wp::extract(var_24, var_32);
        var_35 = wp::mul(var_34, var_11);
        var_36 = wp::add(var_8, var_35);
        var_37 = wp::add(var_36, var_5);
        wp::array_store(var_2, var_37, var_33);
        // nothing = (rays[k] - rays[k]) + (rays[CHUNK + k] - rays[CHUNK + k]) + (rays[2 * CHUNK + k] - rays[2 * CHUNK + k])       <L 122>
        var_38 = wp::address(var_2, var_5);
        var_39 = wp::address(var_2, var_5);
        var_41 = wp::load(var_38);
        var_42 = wp::load(var_39);
        var_40 = wp::sub(var_41, var_42);
        var_43 = wp::add(var_11, var_5);
        var_44 = wp::address(var_2, var_43);
        var_45 = wp::add(var_11, var_5);
        var_46 = wp::address(var_2, var_45);
        var_48 = wp::load(var_44);
        var_49 = wp::load(var_46);
        var_47 = wp::sub(var_48, var_49);
        var_50 = wp::add(var_40, var_47);
        var_52 = wp::mul(var_51, var_11);
        var_53 = wp::add(var_52, var_5);
        var_54 = wp::address(var_2, var_53);
        var_56 = wp::mul(var_55, var_11);
        var_57 = wp::add(var_56, var_5);
        var_58 = wp::address(var_2, var_57);
        var_60 = wp::load(var_54);
        var_61 = wp::load(var_58);
        var_59 = wp::sub(var_60, var_61);
        var_62 = wp::add(var_50, var_59);
        // valid = wp.where(wp.abs(unit[3]) < 0.1, 1, 0) * wp.where(nothing == 0.0, 1, 0)       <L 123>
        var_64 = wp::extract(var_24, var_63);
        var_65 = wp::abs(var_64);
        var_67 = (var_65 < var_66);
        var_70 = wp::where(var_67, var_68, var_69);
        var_72 = (var_62 == var_71);
        var_75 = wp::where(var_72, var_73, var_74);
        var_76 = wp::mul(var_70, var_75);
        // rays[REACH + k] = wp.where(valid != 0, rays[REACH + k], wp.float32(wp.NAN))        <L 124>
        var_78 = (var_76 != var_77);
        var_80 = wp::add(var_79, var_5);
        var_81 = wp::address(var_2, var_80);
        var_84 = wp::float32(var_83);
        var_86 = wp::load(var_81);
        var_85 = wp::where(var_78, var_86, var_84);
        var_87 = wp::add(var_79, var_5);
        wp::array_store(var_2, var_87, var_85);
        // k += 1                                                                             <L 125>
        var_89 = wp::add(var_5, var_88);
        wp::assign(var_5, var_89);
    goto start_while_0;
    end_while_0:;
}


// /work/main/warpsample/tracing/builtin.py:8
static void prepare_builtin_0(
    wp::uint64 var_chunk,
    wp::int32 var_length)
{
    //---------
    // primal vars
    //---------
    // forward
    // def prepare_builtin(chunk: wp.uint64, length: wp.int32):                               <L 9>
}


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


// /work/main/warpsample/tracing/queries.py:56
static wp::vec_t<3, wp::float32> vector_in_0(
    wp::uint64 var_column,
    wp::int32 var_row)
{
    //---------
    // primal vars
    wp::float32 var_0;
    const wp::int32 var_1 = 64;
    wp::int32 var_2;
    wp::float32 var_3;
    const wp::int32 var_4 = 2;
    wp::int32 var_5;
    wp::int32 var_6;
    wp::float32 var_7;
    wp::vec_t<3, wp::float32> var_8;
    //---------
    // forward
    // def vector_in(column: wp.uint64, row: wp.int32) -> wp.vec3:                            <L 57>
    // return wp.vec3(float_at(column, row), float_at(column, row + CHUNK), float_at(column, row + 2 * CHUNK))       <L 59>
    var_0 = _reader__locals__read_0(var_column, var_row);
    var_2 = wp::add(var_row, var_1);
    var_3 = _reader__locals__read_0(var_column, var_2);
    var_5 = wp::mul(var_4, var_1);
    var_6 = wp::add(var_row, var_5);
    var_7 = _reader__locals__read_0(var_column, var_6);
    var_8 = wp::vec_t<3, wp::float32>(var_0, var_3, var_7);
    return var_8;
}


// /work/main/warpsample/tracing/builtin.py:13
static void builtin_query_0(
    Accelerator_9fc73cd7 var_accelerator,
    wp::uint64 var_column,
    wp::float32 var_reach,
    wp::uint64 var_scratch,
    wp::float32 & ret_0,
    wp::int32 & ret_1,
    wp::int32 & ret_2,
    wp::int32 & ret_3)
{
    //---------
    // primal vars
    wp::uint64* var_0;
    const wp::int32 var_1 = 0;
    wp::vec_t<3, wp::float32> var_2;
    const wp::int32 var_3 = 192;
    wp::vec_t<3, wp::float32> var_4;
    wp::mesh_query_ray_t var_5;
    const wp::int32 var_6 = -1;
    wp::uint64 var_7;
    const wp::int32 var_8 = -1;
    wp::int32 var_9;
    const wp::float32 var_10 = INFINITY;
    const wp::float32 var_11 = INFINITY;
    wp::float32 var_12;
    bool var_13;
    bool* var_14;
    bool var_15;
    wp::float32* var_16;
    bool var_17;
    wp::float32 var_18;
    wp::int32* var_19;
    wp::int32 var_20;
    wp::int32 var_21;
    wp::float32* var_22;
    wp::float32 var_23;
    wp::float32 var_24;
    wp::int32 var_25;
    wp::float32 var_26;
    const wp::int32 var_27 = 0;
    const wp::int32 var_28 = 0;
    //---------
    // forward
    // def builtin_query(accelerator: Accelerator, column: wp.uint64, reach: wp.float32, scratch: wp.uint64):       <L 14>
    // query = wp.mesh_query_ray(accelerator.mesh, vector_in(column, ORIGIN), vector_in(column, DIRECTION), reach)       <L 20>
    var_0 = &((var_accelerator).mesh);
    var_2 = vector_in_0(var_column, var_1);
    var_4 = vector_in_0(var_column, var_3);
    var_7 = wp::load(var_0);
    var_5 = wp::mesh_query_ray(var_7, var_2, var_4, var_reach, var_6);
    // face = wp.int32(-1)                                                                    <L 21>
    var_9 = wp::int32(var_8);
    // distance = wp.float32(wp.INF)                                                          <L 22>
    var_12 = wp::float32(var_11);
    // if query.result and query.t < reach:                                                   <L 23>
    var_14 = &((var_5).result);
    var_15 = wp::load(var_14);
    var_13 = var_15;
    if (var_13) {
        var_16 = &((var_5).t);
        var_18 = wp::load(var_16);
        var_17 = (var_18 < var_reach);
        var_13 = var_13 && var_17;
    }
    if (var_13) {
        // face = query.face                                                                  <L 24>
        var_19 = &((var_5).face);
        var_21 = wp::load(var_19);
        var_20 = wp::copy(var_21);
        // distance = query.t                                                                 <L 25>
        var_22 = &((var_5).t);
        var_24 = wp::load(var_22);
        var_23 = wp::copy(var_24);
    }
    var_25 = wp::where(var_13, var_20, var_9);
    var_26 = wp::where(var_13, var_23, var_12);
    // return distance, face, 0, 0                                                            <L 26>
    ret_0 = var_26;
    ret_1 = var_25;
    ret_2 = var_27;
    ret_3 = var_28;
    return;
}


// /work/main/warpsample/tracing/rays.py:128
static wp::float32 user_distance_0(
    Rays_3ba80fd7 var_rays,
    wp::uint64 var_column,
    wp::float32 var_near)
{
    //---------
    // primal vars
    wp::float64 var_0;
    const wp::int32 var_1 = 448;
    wp::float32 var_2;
    wp::float64 var_3;
    wp::float64 var_4;
    Placement_e6d83c4e* var_5;
    wp::float64* var_6;
    wp::float64 var_7;
    wp::float64 var_8;
    wp::float32 var_9;
    //---------
    // forward
    // def user_distance(rays: Rays, column: wp.uint64, near: wp.float32) -> wp.float32:       <L 129>
    // return wp.float32((wp.float64(near) + wp.float64(float_at(column, AHEAD))) * rays.placement.unit)       <L 131>
    var_0 = wp::float64(var_near);
    var_2 = _reader__locals__read_0(var_column, var_1);
    var_3 = wp::float64(var_2);
    var_4 = wp::add(var_0, var_3);
    var_5 = &((var_rays).placement);
    var_6 = &(((var_rays).placement).unit);
    var_8 = wp::load(var_6);
    var_7 = wp::mul(var_4, var_8);
    var_9 = wp::float32(var_7);
    return var_9;
}


// /work/main/warpsample/maths/memory.py:0
static void _writer__locals__write_1(
    wp::uint64 var_address,
    wp::int64 var_i,
    wp::int32 var_x)
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
    //---------
    // forward
    // def write(address: wp.uint64, i: Any, x: kind):                                        <L 1>
    // view = wp.array(ptr=address + wp.uint64(i) * wp.uint64(size), shape=(1,), dtype=kind)       <L 2>
    var_0 = wp::uint64(var_i);
    var_1 = 4ull;
    var_2 = wp::mul(var_0, var_1);
    var_3 = wp::add(var_address, var_2);
    var_5 = wp::tuple(var_4);
    var_6 = wp::array_t<wp::int32>(var_3, var_7);
    // view[0] = x                                                                            <L 3>
    wp::array_store(var_6, var_8, var_x);
}


// /work/main/warpsample/maths/memory.py:0
static void _writer__locals__write_0(
    wp::uint64 var_address,
    wp::int64 var_i,
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


// /work/main/warpsample/tracing/rays.py:142
static void build_hit_writer__locals__write_hit_1(
    Rays_3ba80fd7 var_rays,
    Accelerator_9fc73cd7 var_accelerator,
    wp::uint64 var_column,
    wp::int64 var_ray,
    wp::uint64 var_scratch)
{
    //---------
    // primal vars
    const wp::float32 var_0 = INFINITY;
    const wp::float32 var_1 = INFINITY;
    wp::float32 var_2;
    const wp::int32 var_3 = -1;
    wp::int32 var_4;
    const wp::int32 var_5 = 384;
    wp::float32 var_6;
    const wp::float32 var_7 = 0.0;
    bool var_8;
    wp::float32 var_9;
    wp::int32 var_10;
    wp::int32 var_11;
    wp::int32 var_12;
    wp::float32 var_13;
    wp::uint64* var_14;
    wp::uint64 var_15;
    bool var_16;
    wp::uint64 var_17;
    wp::uint64* var_18;
    wp::int64 var_19;
    wp::int64 var_20;
    wp::uint64 var_21;
    wp::uint64* var_22;
    wp::int64 var_23;
    wp::int64 var_24;
    wp::int64 var_25;
    wp::int64 var_26;
    wp::uint64 var_27;
    const wp::float32 var_28 = 0.0;
    bool var_29;
    bool var_30;
    const wp::float32 var_31 = NAN;
    const wp::float32 var_32 = NAN;
    wp::float32 var_33;
    wp::float32 var_34;
    wp::float32 var_35;
    wp::int32 var_36;
    wp::uint64* var_37;
    wp::uint64 var_38;
    wp::uint64* var_39;
    wp::uint64 var_40;
    //---------
    // forward
    // def write_hit(rays: Rays, accelerator: Accelerator, column: wp.uint64, ray: wp.int64, scratch: wp.uint64):       <L 143>
    // distance = wp.float32(wp.INF)                                                          <L 144>
    var_2 = wp::float32(var_1);
    // face = wp.int32(-1)                                                                    <L 145>
    var_4 = wp::int32(var_3);
    // reach = float_at(column, REACH)                                                        <L 146>
    var_6 = _reader__locals__read_0(var_column, var_5);
    // if reach > 0.0:                                                                        <L 147>
    var_8 = (var_6 > var_7);
    if (var_8) {
        // near, face, nodes, leaves = query(accelerator, column, reach, scratch)             <L 148>
        builtin_query_0(var_accelerator, var_column, var_6, var_scratch, var_9, var_10, var_11, var_12);
        // distance = user_distance(rays, column, near)                                       <L 149>
        var_13 = user_distance_0(var_rays, var_column, var_9);
        // if rays.visits != wp.uint64(0):                                                    <L 150>
        var_14 = &((var_rays).visits);
        var_15 = 0ull;
        var_17 = wp::load(var_14);
        var_16 = (var_17 != var_15);
        if (var_16) {
            // set_int(rays.visits, wp.int64(2) * ray, nodes)                                 <L 151>
            var_18 = &((var_rays).visits);
            var_19 = 2ll;
            var_20 = wp::mul(var_19, var_ray);
            var_21 = wp::load(var_18);
            _writer__locals__write_1(var_21, var_20, var_11);
            // set_int(rays.visits, wp.int64(2) * ray + wp.int64(1), leaves)                  <L 152>
            var_22 = &((var_rays).visits);
            var_23 = 2ll;
            var_24 = wp::mul(var_23, var_ray);
            var_25 = 1ll;
            var_26 = wp::add(var_24, var_25);
            var_27 = wp::load(var_22);
            _writer__locals__write_1(var_27, var_26, var_12);
        }
    }
    if (!var_8) {
        // elif not (reach <= 0.0):                                                           <L 153>
        var_29 = (var_6 <= var_28);
        var_30 = wp::unot(var_29);
        if (var_30) {
            // distance = wp.float32(wp.NAN)                                                  <L 154>
            var_33 = wp::float32(var_32);
        }
        var_34 = wp::where(var_30, var_33, var_2);
    }
    var_35 = wp::where(var_8, var_13, var_34);
    var_36 = wp::where(var_8, var_10, var_4);
    // set_float(rays.distance, ray, distance)                                                <L 155>
    var_37 = &((var_rays).distance);
    var_38 = wp::load(var_37);
    _writer__locals__write_0(var_38, var_ray, var_35);
    // set_int(rays.face, ray, face)                                                          <L 156>
    var_39 = &((var_rays).face);
    var_40 = wp::load(var_39);
    _writer__locals__write_1(var_40, var_ray, var_36);
}


// /work/main/warpsample/maths/memory.py:0
static void adj__reader__locals__read_2(
    wp::uint64 var_address,
    wp::int64 var_i,
    wp::uint64 & adj_address,
    wp::int64 & adj_i,
    wp::int64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/placement.py:115
static void adj_point_of_0(
    Placement_e6d83c4e var_placement,
    wp::int64 var_i,
    Placement_e6d83c4e & adj_placement,
    wp::int64 & adj_i,
    wp::int64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/maths/memory.py:0
static void adj__reader__locals__read_7(
    wp::uint64 var_address,
    wp::int64 var_i,
    wp::uint64 & adj_address,
    wp::int64 & adj_i,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/maths/memory.py:0
static void adj__reader__locals__read_5(
    wp::uint64 var_address,
    wp::int64 var_i,
    wp::uint64 & adj_address,
    wp::int64 & adj_i,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/placement.py:0
static void adj_in_double_0(
    wp::vec_t<3, wp::float32> var_v,
    wp::vec_t<3, wp::float32> & adj_v,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/placement.py:99
static void adj_vector_in_double_0(
    wp::uint64 var_address,
    wp::int32 var_double,
    wp::int64 var_i,
    wp::uint64 & adj_address,
    wp::int32 & adj_double,
    wp::int64 & adj_i,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/placement.py:131
static void adj_local_origin_0(
    Placement_e6d83c4e var_placement,
    wp::int64 var_point,
    Placement_e6d83c4e & adj_placement,
    wp::int64 & adj_point,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/placement.py:107
static void adj_unit_in_double_0(
    wp::vec_t<3, wp::float64> var_d,
    wp::int32 var_double,
    wp::vec_t<3, wp::float64> & adj_d,
    wp::int32 & adj_double,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/rays.py:80
static void adj__direction_1(
    Rays_3ba80fd7 var_rays,
    wp::int64 var_ray,
    Rays_3ba80fd7 & adj_rays,
    wp::int64 & adj_ray,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/placement.py:167
static void adj_is_far_off_0(
    wp::vec_t<3, wp::float64> var_o,
    wp::vec_t<3, wp::float64> & adj_o,
    bool & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/placement.py:173
static void adj_distance_to_scene_0(
    wp::vec_t<3, wp::float64> var_o,
    wp::vec_t<3, wp::float64> var_d,
    wp::vec_t<3, wp::float64> & adj_o,
    wp::vec_t<3, wp::float64> & adj_d,
    wp::float64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/placement.py:140
static void adj_extent_along_0(
    wp::vec_t<3, wp::float32> var_extent,
    wp::vec_t<3, wp::float32> var_n,
    wp::vec_t<3, wp::float32> & adj_extent,
    wp::vec_t<3, wp::float32> & adj_n,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/placement.py:155
static void adj_offset_within_0(
    wp::vec_t<3, wp::float32> var_extent,
    wp::float32 var_coarseness,
    wp::vec_t<3, wp::float32> var_n,
    wp::vec_t<3, wp::float32> & adj_extent,
    wp::float32 & adj_coarseness,
    wp::vec_t<3, wp::float32> & adj_n,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/placement.py:161
static void adj_origin_offset_0(
    Placement_e6d83c4e var_placement,
    wp::vec_t<3, wp::float32> var_n,
    Placement_e6d83c4e & adj_placement,
    wp::vec_t<3, wp::float32> & adj_n,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/queries.py:77
static void adj_set_origin_0(
    wp::uint64 var_chunk,
    wp::int32 var_k,
    wp::vec_t<3, wp::float32> var_o,
    wp::uint64 & adj_chunk,
    wp::int32 & adj_k,
    wp::vec_t<3, wp::float32> & adj_o)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/queries.py:68
static void adj_set_direction_0(
    wp::uint64 var_chunk,
    wp::int32 var_k,
    wp::vec_t<3, wp::float32> var_d,
    wp::uint64 & adj_chunk,
    wp::int32 & adj_k,
    wp::vec_t<3, wp::float32> & adj_d)
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


// /work/main/warpsample/tracing/rays.py:88
static void adj__load_ray_0(
    Rays_3ba80fd7 var_rays,
    wp::int64 var_point,
    wp::vec_t<3, wp::float64> var_o,
    wp::int64 var_ray,
    wp::uint64 var_column,
    Rays_3ba80fd7 & adj_rays,
    wp::int64 & adj_point,
    wp::vec_t<3, wp::float64> & adj_o,
    wp::int64 & adj_ray,
    wp::uint64 & adj_column)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/maths/numerics.py:50
static CUDA_CALLABLE void adj_fma_0(
    wp::float32 a,
    wp::float32 b,
    wp::float32 c,
    wp::float32 & adj_a,
    wp::float32 & adj_b,
    wp::float32 & adj_c,
    wp::float32 & adj_ret)
{

    adj_a += b * adj_ret;
    adj_b += a * adj_ret;
    adj_c += adj_ret;
}


// /work/main/warpsample/maths/numerics.py:175
static void adj_scaled_to_unit_0(
    wp::vec_t<3, wp::float32> var_v,
    wp::vec_t<3, wp::float32> & adj_v,
    wp::vec_t<4, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/maths/numerics.py:204
static void adj_direction_to_unit_0(
    wp::vec_t<3, wp::float32> var_v,
    wp::vec_t<3, wp::float32> & adj_v,
    wp::vec_t<4, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/rays.py:111
static void adj__normalize_0(
    wp::uint64 var_chunk,
    wp::int64 var_length,
    wp::uint64 & adj_chunk,
    wp::int64 & adj_length)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/builtin.py:8
static void adj_prepare_builtin_0(
    wp::uint64 var_chunk,
    wp::int32 var_length,
    wp::uint64 & adj_chunk,
    wp::int32 & adj_length)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
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


// /work/main/warpsample/tracing/queries.py:56
static void adj_vector_in_0(
    wp::uint64 var_column,
    wp::int32 var_row,
    wp::uint64 & adj_column,
    wp::int32 & adj_row,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/builtin.py:13
static void adj_builtin_query_0(
    Accelerator_9fc73cd7 var_accelerator,
    wp::uint64 var_column,
    wp::float32 var_reach,
    wp::uint64 var_scratch,
    wp::float32 & ret_0,
    wp::int32 & ret_1,
    wp::int32 & ret_2,
    wp::int32 & ret_3,
    Accelerator_9fc73cd7 & adj_accelerator,
    wp::uint64 & adj_column,
    wp::float32 & adj_reach,
    wp::uint64 & adj_scratch,
    wp::float32 & adj_ret_0,
    wp::int32 & adj_ret_1,
    wp::int32 & adj_ret_2,
    wp::int32 & adj_ret_3)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/rays.py:128
static void adj_user_distance_0(
    Rays_3ba80fd7 var_rays,
    wp::uint64 var_column,
    wp::float32 var_near,
    Rays_3ba80fd7 & adj_rays,
    wp::uint64 & adj_column,
    wp::float32 & adj_near,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/maths/memory.py:0
static void adj__writer__locals__write_1(
    wp::uint64 var_address,
    wp::int64 var_i,
    wp::int32 var_x,
    wp::uint64 & adj_address,
    wp::int64 & adj_i,
    wp::int32 & adj_x)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/maths/memory.py:0
static void adj__writer__locals__write_0(
    wp::uint64 var_address,
    wp::int64 var_i,
    wp::float32 var_x,
    wp::uint64 & adj_address,
    wp::int64 & adj_i,
    wp::float32 & adj_x)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/rays.py:142
static void adj_build_hit_writer__locals__write_hit_1(
    Rays_3ba80fd7 var_rays,
    Accelerator_9fc73cd7 var_accelerator,
    wp::uint64 var_column,
    wp::int64 var_ray,
    wp::uint64 var_scratch,
    Rays_3ba80fd7 & adj_rays,
    Accelerator_9fc73cd7 & adj_accelerator,
    wp::uint64 & adj_column,
    wp::int64 & adj_ray,
    wp::uint64 & adj_scratch)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}

struct wp_args_ray_kernel__locals__each_ray_02af066f {
    Rays_3ba80fd7 rays;
    Accelerator_9fc73cd7 accelerator;
    wp::int64 first_task;
};


template <bool wp_linear_contiguous>
static void ray_kernel__locals__each_ray_02af066f_cpu_kernel_forward(
    wp::launch_bounds_t<1> dim,
    size_t task_index,
    wp_args_ray_kernel__locals__each_ray_02af066f *_wp_args)
{
    static constexpr bool wp_linear_tid = wp_linear_contiguous;

    //---------
    // argument vars
    Rays_3ba80fd7 var_rays = _wp_args->rays;
    Accelerator_9fc73cd7 var_accelerator = _wp_args->accelerator;
    wp::int64 var_first_task = _wp_args->first_task;
    //---------
    // primal vars
    const wp::int32 var_0 = 108;
    wp::tuple_t<wp::int32> var_1;
    wp::fixedarray_t<108, wp::int32> var_2;
    const wp::int32 var_3 = 108;
    const wp::int32 var_4 = 512;
    wp::tuple_t<wp::int32> var_5;
    wp::fixedarray_t<512, wp::float32> var_6;
    const wp::int32 var_7 = 512;
    wp::int32 var_8;
    wp::int64 var_9;
    wp::int64 var_10;
    wp::int64* var_11;
    wp::int64 var_12;
    wp::int64 var_13;
    wp::int64* var_14;
    Placement_e6d83c4e* var_15;
    wp::int64* var_16;
    wp::int64* var_17;
    wp::int64 var_18;
    wp::int64 var_19;
    wp::int64 var_20;
    wp::int64 var_21;
    wp::int64 var_22;
    wp::int64 var_23;
    wp::int32 var_24;
    wp::int64* var_25;
    wp::int64 var_26;
    wp::int64 var_27;
    wp::int64* var_28;
    wp::int64 var_29;
    wp::int64 var_30;
    wp::int64 var_31;
    Placement_e6d83c4e* var_32;
    wp::int64 var_33;
    Placement_e6d83c4e var_34;
    Placement_e6d83c4e* var_35;
    wp::vec_t<3, wp::float64> var_36;
    Placement_e6d83c4e var_37;
    wp::range_t var_38;
    wp::int32 var_39;
    wp::int64 var_40;
    bool var_41;
    Placement_e6d83c4e* var_42;
    wp::int64 var_43;
    Placement_e6d83c4e var_44;
    Placement_e6d83c4e* var_45;
    wp::vec_t<3, wp::float64> var_46;
    Placement_e6d83c4e var_47;
    wp::int64 var_48;
    wp::vec_t<3, wp::float64> var_49;
    wp::int64* var_50;
    wp::int64 var_51;
    wp::int64 var_52;
    wp::int64 var_53;
    wp::uint64* var_54;
    const wp::int32 var_55 = 4;
    wp::int32 var_56;
    wp::uint64 var_57;
    wp::uint64 var_58;
    wp::uint64 var_59;
    wp::int64 var_60;
    wp::int64 var_61;
    wp::int64* var_62;
    bool var_63;
    wp::int64 var_64;
    wp::int64 var_65;
    wp::int64 var_66;
    wp::int64 var_67;
    wp::int64 var_68;
    wp::int64 var_69;
    wp::uint64* var_70;
    wp::int64* var_71;
    wp::uint64 var_72;
    wp::int64 var_73;
    wp::uint64* var_74;
    const wp::int32 var_75 = 64;
    wp::uint64 var_76;
    wp::int64* var_77;
    wp::int64 var_78;
    wp::int64 var_79;
    wp::int64* var_80;
    wp::int64 var_81;
    wp::int64 var_82;
    wp::int64 var_83;
    wp::range_t var_84;
    wp::int32 var_85;
    Placement_e6d83c4e* var_86;
    wp::int64 var_87;
    Placement_e6d83c4e var_88;
    wp::int64* var_89;
    wp::int64 var_90;
    wp::int64 var_91;
    wp::int64 var_92;
    wp::int64 var_93;
    wp::int64 var_94;
    wp::int64* var_95;
    bool var_96;
    wp::int64 var_97;
    wp::int64 var_98;
    wp::int64 var_99;
    wp::int64 var_100;
    wp::int64 var_101;
    wp::int64 var_102;
    wp::uint64* var_103;
    const wp::int32 var_104 = 4;
    wp::int32 var_105;
    wp::uint64 var_106;
    wp::uint64 var_107;
    wp::uint64 var_108;
    wp::uint64* var_109;
    wp::uint64 var_110;
    //---------
    // forward
    // def each_ray(rays: Rays, accelerator: Accelerator, first_task: wp.int64):              <L 203>
    // words = wp.zeros(shape=(SCRATCH,), dtype=wp.int32)                                     <L 204>
    var_1 = wp::tuple(var_0);
    var_2 = wp::fixedarray_t<108, wp::int32>(var_3);
    // floats = wp.zeros(shape=(size,), dtype=wp.float32)                                     <L 205>
    var_5 = wp::tuple(var_4);
    var_6 = wp::fixedarray_t<512, wp::float32>(var_7);
    // first = (first_task + wp.int64(wp.tid())) * rays.per_task                              <L 206>
    var_8 = builtin_tid1d();
    var_9 = wp::int64(var_8);
    var_10 = wp::add(var_first_task, var_9);
    var_11 = &((var_rays).per_task);
    var_13 = wp::load(var_11);
    var_12 = wp::mul(var_10, var_13);
    // length = wp.int32(wp.min(rays.per_task, rays.placement.points * rays.count - first))       <L 207>
    var_14 = &((var_rays).per_task);
    var_15 = &((var_rays).placement);
    var_16 = &(((var_rays).placement).points);
    var_17 = &((var_rays).count);
    var_19 = wp::load(var_16);
    var_20 = wp::load(var_17);
    var_18 = wp::mul(var_19, var_20);
    var_21 = wp::sub(var_18, var_12);
    var_23 = wp::load(var_14);
    var_22 = wp::min(var_23, var_21);
    var_24 = wp::int32(var_22);
    // row = first / rays.count                                                               <L 208>
    var_25 = &((var_rays).count);
    var_27 = wp::load(var_25);
    var_26 = wp::div(var_12, var_27);
    // j = first - row * rays.count                                                           <L 209>
    var_28 = &((var_rays).count);
    var_30 = wp::load(var_28);
    var_29 = wp::mul(var_26, var_30);
    var_31 = wp::sub(var_12, var_29);
    // point = point_of(rays.placement, row)                                                  <L 210>
    var_32 = &((var_rays).placement);
    var_34 = wp::load(var_32);
    var_33 = point_of_0(var_34, var_26);
    // o = local_origin(rays.placement, point)                                                <L 211>
    var_35 = &((var_rays).placement);
    var_37 = wp::load(var_35);
    var_36 = local_origin_0(var_37, var_33);
    // for k in range(length):                                                                <L 212>
    var_38 = wp::range(var_24);
    start_for_0:;
        if (iter_cmp(var_38) == 0) goto end_for_0;
        var_39 = wp::iter_next(var_38);
        // if j == wp.int64(0):                                                               <L 213>
        var_40 = 0ll;
        var_41 = (var_31 == var_40);
        if (var_41) {
            // point = point_of(rays.placement, row)                                          <L 214>
            var_42 = &((var_rays).placement);
            var_44 = wp::load(var_42);
            var_43 = point_of_0(var_44, var_26);
            // o = local_origin(rays.placement, point)                                        <L 215>
            var_45 = &((var_rays).placement);
            var_47 = wp::load(var_45);
            var_46 = local_origin_0(var_47, var_43);
        }
        var_48 = wp::where(var_41, var_43, var_33);
        var_49 = wp::where(var_41, var_46, var_36);
        // _load_ray(rays, point, o, point * rays.count + j, floats.ptr + wp.uint64(4 * k))       <L 216>
        var_50 = &((var_rays).count);
        var_52 = wp::load(var_50);
        var_51 = wp::mul(var_48, var_52);
        var_53 = wp::add(var_51, var_31);
        var_54 = (wp::uint64*)&(var_6.data);
        var_56 = wp::mul(var_55, var_39);
        var_57 = wp::uint64(var_56);
        var_59 = wp::load(var_54);
        var_58 = wp::add(var_59, var_57);
        _load_ray_0(var_rays, var_48, var_49, var_53, var_58);
        // j += wp.int64(1)                                                                   <L 217>
        var_60 = 1ll;
        var_61 = wp::add(var_31, var_60);
        // if j == rays.count:                                                                <L 218>
        var_62 = &((var_rays).count);
        var_64 = wp::load(var_62);
        var_63 = (var_61 == var_64);
        if (var_63) {
            // j = wp.int64(0)                                                                <L 219>
            var_65 = 0ll;
            // row += wp.int64(1)                                                             <L 220>
            var_66 = 1ll;
            var_67 = wp::add(var_26, var_66);
        }
        var_68 = wp::where(var_63, var_67, var_26);
        var_69 = wp::where(var_63, var_65, var_61);
        wp::assign(var_26, var_68);
        wp::assign(var_31, var_69);
        wp::assign(var_33, var_48);
        wp::assign(var_36, var_49);
        goto start_for_0;
    end_for_0:;
    // _normalize(floats.ptr, rays.per_task)                                                  <L 221>
    var_70 = (wp::uint64*)&(var_6.data);
    var_71 = &((var_rays).per_task);
    var_72 = wp::load(var_70);
    var_73 = wp::load(var_71);
    _normalize_0(var_72, var_73);
    // prepare(floats.ptr, CHUNK)                                                             <L 222>
    var_74 = (wp::uint64*)&(var_6.data);
    var_76 = wp::load(var_74);
    prepare_builtin_0(var_76, var_75);
    // row = first / rays.count                                                               <L 223>
    var_77 = &((var_rays).count);
    var_79 = wp::load(var_77);
    var_78 = wp::div(var_12, var_79);
    // j = first - row * rays.count                                                           <L 224>
    var_80 = &((var_rays).count);
    var_82 = wp::load(var_80);
    var_81 = wp::mul(var_78, var_82);
    var_83 = wp::sub(var_12, var_81);
    // for k in range(length):                                                                <L 225>
    var_84 = wp::range(var_24);
    start_for_2:;
        if (iter_cmp(var_84) == 0) goto end_for_2;
        var_85 = wp::iter_next(var_84);
        // ray = point_of(rays.placement, row) * rays.count + j                               <L 226>
        var_86 = &((var_rays).placement);
        var_88 = wp::load(var_86);
        var_87 = point_of_0(var_88, var_78);
        var_89 = &((var_rays).count);
        var_91 = wp::load(var_89);
        var_90 = wp::mul(var_87, var_91);
        var_92 = wp::add(var_90, var_83);
        // j += wp.int64(1)                                                                   <L 227>
        var_93 = 1ll;
        var_94 = wp::add(var_83, var_93);
        // if j == rays.count:                                                                <L 228>
        var_95 = &((var_rays).count);
        var_97 = wp::load(var_95);
        var_96 = (var_94 == var_97);
        if (var_96) {
            // j = wp.int64(0)                                                                <L 229>
            var_98 = 0ll;
            // row += wp.int64(1)                                                             <L 230>
            var_99 = 1ll;
            var_100 = wp::add(var_78, var_99);
        }
        var_101 = wp::where(var_96, var_100, var_78);
        var_102 = wp::where(var_96, var_98, var_94);
        // answer(rays, accelerator, floats.ptr + wp.uint64(4 * k), ray, words.ptr)           <L 231>
        var_103 = (wp::uint64*)&(var_6.data);
        var_105 = wp::mul(var_104, var_85);
        var_106 = wp::uint64(var_105);
        var_108 = wp::load(var_103);
        var_107 = wp::add(var_108, var_106);
        var_109 = (wp::uint64*)&(var_2.data);
        var_110 = wp::load(var_109);
        build_hit_writer__locals__write_hit_1(var_rays, var_accelerator, var_107, var_92, var_110);
        wp::assign(var_78, var_101);
        wp::assign(var_83, var_102);
        goto start_for_2;
    end_for_2:;
}



template <bool wp_linear_contiguous>
static WP_FORCEINLINE void ray_kernel__locals__each_ray_02af066f_cpu_forward_tasks(
    wp::launch_bounds_t<1> *dim,
    wp_args_ray_kernel__locals__each_ray_02af066f *_wp_args)
{
    for (size_t task_index = 0; task_index < dim->size; ++task_index)
    {
        ray_kernel__locals__each_ray_02af066f_cpu_kernel_forward<wp_linear_contiguous>(*dim, task_index, _wp_args);
    }
}

static WP_FORCEINLINE void ray_kernel__locals__each_ray_02af066f_cpu_forward_dispatch(
    wp::launch_bounds_t<1> *dim,
    wp_args_ray_kernel__locals__each_ray_02af066f *_wp_args)
{
    wp::tile_shared_storage_t tile_mem;
#if defined(WP_ENABLE_TILES_IN_STACK_MEMORY)
    wp::shared_tile_storage = &tile_mem;
#endif

    ray_kernel__locals__each_ray_02af066f_cpu_forward_tasks<false>(dim, _wp_args);
}

extern "C" {

// Python CPU entry points
WP_API void ray_kernel__locals__each_ray_02af066f_cpu_forward(
    wp::launch_bounds_t<1> *dim,
    wp_args_ray_kernel__locals__each_ray_02af066f *_wp_args)
{
    ray_kernel__locals__each_ray_02af066f_cpu_forward_dispatch(dim, _wp_args);
}

} // extern C

