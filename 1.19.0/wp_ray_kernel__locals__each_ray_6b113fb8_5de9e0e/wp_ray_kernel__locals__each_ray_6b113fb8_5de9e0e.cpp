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




struct PreparedRay_54268e28
{
    wp::vec_t<3, wp::float32> inverse;
    wp::vec_t<3, wp::float32> shift;
    wp::vec_t<3, wp::int32> near;
    wp::vec_t<3, wp::float32> origin;
    wp::vec_t<3, wp::float32> shear;
    wp::vec_t<3, wp::int32> axes;


    PreparedRay_54268e28() = default;
    CUDA_CALLABLE PreparedRay_54268e28(wp::vec_t<3, wp::float32> const& inverse,
    wp::vec_t<3, wp::float32> const& shift = {},
    wp::vec_t<3, wp::int32> const& near = {},
    wp::vec_t<3, wp::float32> const& origin = {},
    wp::vec_t<3, wp::float32> const& shear = {},
    wp::vec_t<3, wp::int32> const& axes = {})
        : inverse{inverse}
        , shift{shift}
        , near{near}
        , origin{origin}
        , shear{shear}
        , axes{axes}

    {
    }

    CUDA_CALLABLE PreparedRay_54268e28& operator += (const PreparedRay_54268e28& rhs)
    {    inverse += rhs.inverse;
    shift += rhs.shift;
    near += rhs.near;
    origin += rhs.origin;
    shear += rhs.shear;
    axes += rhs.axes;

        return *this;}

};

static CUDA_CALLABLE void adj_PreparedRay_54268e28(wp::vec_t<3, wp::float32> const&,
    wp::vec_t<3, wp::float32> const&,
    wp::vec_t<3, wp::int32> const&,
    wp::vec_t<3, wp::float32> const&,
    wp::vec_t<3, wp::float32> const&,
    wp::vec_t<3, wp::int32> const&,
    wp::vec_t<3, wp::float32> & adj_inverse,
    wp::vec_t<3, wp::float32> & adj_shift,
    wp::vec_t<3, wp::int32> & adj_near,
    wp::vec_t<3, wp::float32> & adj_origin,
    wp::vec_t<3, wp::float32> & adj_shear,
    wp::vec_t<3, wp::int32> & adj_axes,
    PreparedRay_54268e28 & adj_ret)
{
    adj_inverse += adj_ret.inverse;
    adj_shift += adj_ret.shift;
    adj_near += adj_ret.near;
    adj_origin += adj_ret.origin;
    adj_shear += adj_ret.shear;
    adj_axes += adj_ret.axes;
}

// Required when compiling adjoints.
CUDA_CALLABLE PreparedRay_54268e28 add(const PreparedRay_54268e28& a, const PreparedRay_54268e28& b)
{
    return PreparedRay_54268e28();
}

CUDA_CALLABLE void adj_atomic_add(PreparedRay_54268e28* p, PreparedRay_54268e28 t)
{
    wp::adj_atomic_add(&p->inverse, t.inverse);
    wp::adj_atomic_add(&p->shift, t.shift);
    wp::adj_atomic_add(&p->near, t.near);
    wp::adj_atomic_add(&p->origin, t.origin);
    wp::adj_atomic_add(&p->shear, t.shear);
    wp::adj_atomic_add(&p->axes, t.axes);
}




struct Ray_728362d1
{
    wp::float32 inverse_x;
    wp::float32 inverse_y;
    wp::float32 inverse_z;
    wp::float32 shift_x;
    wp::float32 shift_y;
    wp::float32 shift_z;
    wp::uint64 near_x;
    wp::uint64 near_y;
    wp::uint64 near_z;
    wp::float32 origin_first;
    wp::float32 origin_second;
    wp::float32 origin_along;
    wp::float32 shear_first;
    wp::float32 shear_second;
    wp::float32 share_along;
    wp::uint64 first;
    wp::uint64 second;
    wp::uint64 along;
    wp::uint64 direction;
    wp::uint64 rows_of_leaf;


    Ray_728362d1() = default;
    CUDA_CALLABLE Ray_728362d1(wp::float32 const& inverse_x,
    wp::float32 const& inverse_y = {},
    wp::float32 const& inverse_z = {},
    wp::float32 const& shift_x = {},
    wp::float32 const& shift_y = {},
    wp::float32 const& shift_z = {},
    wp::uint64 const& near_x = {},
    wp::uint64 const& near_y = {},
    wp::uint64 const& near_z = {},
    wp::float32 const& origin_first = {},
    wp::float32 const& origin_second = {},
    wp::float32 const& origin_along = {},
    wp::float32 const& shear_first = {},
    wp::float32 const& shear_second = {},
    wp::float32 const& share_along = {},
    wp::uint64 const& first = {},
    wp::uint64 const& second = {},
    wp::uint64 const& along = {},
    wp::uint64 const& direction = {},
    wp::uint64 const& rows_of_leaf = {})
        : inverse_x{inverse_x}
        , inverse_y{inverse_y}
        , inverse_z{inverse_z}
        , shift_x{shift_x}
        , shift_y{shift_y}
        , shift_z{shift_z}
        , near_x{near_x}
        , near_y{near_y}
        , near_z{near_z}
        , origin_first{origin_first}
        , origin_second{origin_second}
        , origin_along{origin_along}
        , shear_first{shear_first}
        , shear_second{shear_second}
        , share_along{share_along}
        , first{first}
        , second{second}
        , along{along}
        , direction{direction}
        , rows_of_leaf{rows_of_leaf}

    {
    }

    CUDA_CALLABLE Ray_728362d1& operator += (const Ray_728362d1& rhs)
    {    inverse_x += rhs.inverse_x;
    inverse_y += rhs.inverse_y;
    inverse_z += rhs.inverse_z;
    shift_x += rhs.shift_x;
    shift_y += rhs.shift_y;
    shift_z += rhs.shift_z;
    near_x += rhs.near_x;
    near_y += rhs.near_y;
    near_z += rhs.near_z;
    origin_first += rhs.origin_first;
    origin_second += rhs.origin_second;
    origin_along += rhs.origin_along;
    shear_first += rhs.shear_first;
    shear_second += rhs.shear_second;
    share_along += rhs.share_along;
    first += rhs.first;
    second += rhs.second;
    along += rhs.along;
    direction += rhs.direction;
    rows_of_leaf += rhs.rows_of_leaf;

        return *this;}

};

static CUDA_CALLABLE void adj_Ray_728362d1(wp::float32 const&,
    wp::float32 const&,
    wp::float32 const&,
    wp::float32 const&,
    wp::float32 const&,
    wp::float32 const&,
    wp::uint64 const&,
    wp::uint64 const&,
    wp::uint64 const&,
    wp::float32 const&,
    wp::float32 const&,
    wp::float32 const&,
    wp::float32 const&,
    wp::float32 const&,
    wp::float32 const&,
    wp::uint64 const&,
    wp::uint64 const&,
    wp::uint64 const&,
    wp::uint64 const&,
    wp::uint64 const&,
    wp::float32 & adj_inverse_x,
    wp::float32 & adj_inverse_y,
    wp::float32 & adj_inverse_z,
    wp::float32 & adj_shift_x,
    wp::float32 & adj_shift_y,
    wp::float32 & adj_shift_z,
    wp::uint64 & adj_near_x,
    wp::uint64 & adj_near_y,
    wp::uint64 & adj_near_z,
    wp::float32 & adj_origin_first,
    wp::float32 & adj_origin_second,
    wp::float32 & adj_origin_along,
    wp::float32 & adj_shear_first,
    wp::float32 & adj_shear_second,
    wp::float32 & adj_share_along,
    wp::uint64 & adj_first,
    wp::uint64 & adj_second,
    wp::uint64 & adj_along,
    wp::uint64 & adj_direction,
    wp::uint64 & adj_rows_of_leaf,
    Ray_728362d1 & adj_ret)
{
    adj_inverse_x += adj_ret.inverse_x;
    adj_inverse_y += adj_ret.inverse_y;
    adj_inverse_z += adj_ret.inverse_z;
    adj_shift_x += adj_ret.shift_x;
    adj_shift_y += adj_ret.shift_y;
    adj_shift_z += adj_ret.shift_z;
    adj_near_x += adj_ret.near_x;
    adj_near_y += adj_ret.near_y;
    adj_near_z += adj_ret.near_z;
    adj_origin_first += adj_ret.origin_first;
    adj_origin_second += adj_ret.origin_second;
    adj_origin_along += adj_ret.origin_along;
    adj_shear_first += adj_ret.shear_first;
    adj_shear_second += adj_ret.shear_second;
    adj_share_along += adj_ret.share_along;
    adj_first += adj_ret.first;
    adj_second += adj_ret.second;
    adj_along += adj_ret.along;
    adj_direction += adj_ret.direction;
    adj_rows_of_leaf += adj_ret.rows_of_leaf;
}

// Required when compiling adjoints.
CUDA_CALLABLE Ray_728362d1 add(const Ray_728362d1& a, const Ray_728362d1& b)
{
    return Ray_728362d1();
}

CUDA_CALLABLE void adj_atomic_add(Ray_728362d1* p, Ray_728362d1 t)
{
    wp::adj_atomic_add(&p->inverse_x, t.inverse_x);
    wp::adj_atomic_add(&p->inverse_y, t.inverse_y);
    wp::adj_atomic_add(&p->inverse_z, t.inverse_z);
    wp::adj_atomic_add(&p->shift_x, t.shift_x);
    wp::adj_atomic_add(&p->shift_y, t.shift_y);
    wp::adj_atomic_add(&p->shift_z, t.shift_z);
    wp::adj_atomic_add(&p->near_x, t.near_x);
    wp::adj_atomic_add(&p->near_y, t.near_y);
    wp::adj_atomic_add(&p->near_z, t.near_z);
    wp::adj_atomic_add(&p->origin_first, t.origin_first);
    wp::adj_atomic_add(&p->origin_second, t.origin_second);
    wp::adj_atomic_add(&p->origin_along, t.origin_along);
    wp::adj_atomic_add(&p->shear_first, t.shear_first);
    wp::adj_atomic_add(&p->shear_second, t.shear_second);
    wp::adj_atomic_add(&p->share_along, t.share_along);
    wp::adj_atomic_add(&p->first, t.first);
    wp::adj_atomic_add(&p->second, t.second);
    wp::adj_atomic_add(&p->along, t.along);
    wp::adj_atomic_add(&p->direction, t.direction);
    wp::adj_atomic_add(&p->rows_of_leaf, t.rows_of_leaf);
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


// /work/main/warpsample/tracing/wide/prepare.py:63
static wp::float32 _nonzero_0(
    wp::float32 var_d)
{
    //---------
    // primal vars
    wp::float32 var_0;
    const wp::float32 var_1 = 8.673617379884035e-19;
    bool var_2;
    wp::float32 var_3;
    wp::float32 var_4;
    //---------
    // forward
    // def _nonzero(d: wp.float32) -> wp.float32:                                             <L 64>
    // return wp.where(wp.abs(d) > _SLOWEST, d, wp.copysign(_SLOWEST, d))                     <L 66>
    var_0 = wp::abs(var_d);
    var_2 = (var_0 > var_1);
    var_3 = wp::copysign(var_1, var_d);
    var_4 = wp::where(var_2, var_d, var_3);
    return var_4;
}


// /work/main/warpsample/maths/numerics.py:232
static wp::float32 greater_0(
    wp::float32 var_a,
    wp::float32 var_b)
{
    //---------
    // primal vars
    bool var_0;
    wp::float32 var_1;
    //---------
    // forward
    // def greater(a: wp.float32, b: wp.float32) -> wp.float32:                               <L 233>
    // return wp.where(a > b, a, b)                                                           <L 235>
    var_0 = (var_a > var_b);
    var_1 = wp::where(var_0, var_a, var_b);
    return var_1;
}


// /work/main/warpsample/tracing/wide/prepare.py:69
static PreparedRay_54268e28 prepare_ray_0(
    wp::vec_t<3, wp::float32> var_o,
    wp::vec_t<3, wp::float32> var_d)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float32 var_1;
    wp::float32 var_2;
    const wp::int32 var_3 = 1;
    wp::float32 var_4;
    wp::float32 var_5;
    const wp::int32 var_6 = 2;
    wp::float32 var_7;
    wp::float32 var_8;
    const wp::float32 var_9 = 1.0;
    wp::float32 var_10;
    const wp::float32 var_11 = 1.0;
    wp::float32 var_12;
    const wp::float32 var_13 = 1.0;
    wp::float32 var_14;
    wp::float32 var_15;
    wp::float32 var_16;
    bool var_17;
    wp::float32 var_18;
    wp::float32 var_19;
    wp::float32 var_20;
    wp::float32 var_21;
    bool var_22;
    wp::float32 var_23;
    wp::float32 var_24;
    PreparedRay_54268e28 var_25;
    wp::vec_t<3, wp::float32> var_26;
    const wp::int32 var_27 = 0;
    wp::float32 var_28;
    wp::float32 var_29;
    wp::float32 var_30;
    const wp::int32 var_31 = 1;
    wp::float32 var_32;
    wp::float32 var_33;
    wp::float32 var_34;
    const wp::int32 var_35 = 2;
    wp::float32 var_36;
    wp::float32 var_37;
    wp::float32 var_38;
    wp::vec_t<3, wp::float32> var_39;
    const wp::float32 var_40 = 0.0;
    bool var_41;
    const wp::int32 var_42 = 192;
    const wp::int32 var_43 = 0;
    wp::int32 var_44;
    const wp::float32 var_45 = 0.0;
    bool var_46;
    const wp::int32 var_47 = 0;
    wp::int32 var_48;
    const wp::float32 var_49 = 0.0;
    bool var_50;
    const wp::int32 var_51 = 0;
    wp::int32 var_52;
    wp::vec_t<3, wp::int32> var_53;
    const wp::int32 var_54 = 0;
    wp::float32 var_55;
    const wp::int32 var_56 = 2;
    wp::float32 var_57;
    const wp::int32 var_58 = 1;
    wp::float32 var_59;
    wp::float32 var_60;
    wp::float32 var_61;
    const wp::int32 var_62 = 1;
    wp::float32 var_63;
    const wp::int32 var_64 = 0;
    wp::float32 var_65;
    const wp::int32 var_66 = 2;
    wp::float32 var_67;
    wp::float32 var_68;
    wp::float32 var_69;
    const wp::int32 var_70 = 2;
    wp::float32 var_71;
    const wp::int32 var_72 = 1;
    wp::float32 var_73;
    const wp::int32 var_74 = 0;
    wp::float32 var_75;
    wp::float32 var_76;
    wp::float32 var_77;
    wp::vec_t<3, wp::float32> var_78;
    wp::float32 var_79;
    wp::float32 var_80;
    wp::float32 var_81;
    wp::float32 var_82;
    wp::float32 var_83;
    wp::float32 var_84;
    wp::float32 var_85;
    wp::float32 var_86;
    wp::float32 var_87;
    wp::float32 var_88;
    wp::vec_t<3, wp::float32> var_89;
    const wp::int32 var_90 = 0;
    const wp::int32 var_91 = 128;
    const wp::int32 var_92 = 64;
    wp::int32 var_93;
    wp::int32 var_94;
    const wp::int32 var_95 = 0;
    wp::int32 var_96;
    wp::int32 var_97;
    const wp::int32 var_98 = 0;
    wp::int32 var_99;
    wp::int32 var_100;
    wp::vec_t<3, wp::int32> var_101;
    //---------
    // forward
    // def prepare_ray(o: wp.vec3, d: wp.vec3) -> PreparedRay:                                <L 70>
    // x = _nonzero(d[0])                                                                     <L 80>
    var_1 = wp::extract(var_d, var_0);
    var_2 = _nonzero_0(var_1);
    // y = _nonzero(d[1])                                                                     <L 81>
    var_4 = wp::extract(var_d, var_3);
    var_5 = _nonzero_0(var_4);
    // z = _nonzero(d[2])                                                                     <L 82>
    var_7 = wp::extract(var_d, var_6);
    var_8 = _nonzero_0(var_7);
    // inverse_x = 1.0 / x                                                                    <L 83>
    var_10 = wp::div(var_9, var_2);
    // inverse_y = 1.0 / y                                                                    <L 84>
    var_12 = wp::div(var_11, var_5);
    // inverse_z = 1.0 / z                                                                    <L 85>
    var_14 = wp::div(var_13, var_8);
    // to_y = wp.abs(y) > wp.abs(x)                                                           <L 86>
    var_15 = wp::abs(var_5);
    var_16 = wp::abs(var_2);
    var_17 = (var_15 > var_16);
    // to_z = wp.abs(z) > greater(wp.abs(x), wp.abs(y))                                       <L 87>
    var_18 = wp::abs(var_8);
    var_19 = wp::abs(var_2);
    var_20 = wp::abs(var_5);
    var_21 = greater_0(var_19, var_20);
    var_22 = (var_18 > var_21);
    // scale = wp.where(to_z, inverse_z, wp.where(to_y, inverse_y, inverse_x))                <L 88>
    var_23 = wp::where(var_17, var_12, var_10);
    var_24 = wp::where(var_22, var_14, var_23);
    // p = PreparedRay()                                                                      <L 89>
    var_25 = PreparedRay_54268e28();
    // p.inverse = wp.vec3(inverse_x, inverse_y, inverse_z)                                   <L 90>
    var_26 = wp::vec_t<3, wp::float32>(var_10, var_12, var_14);
    var_25.inverse = var_26;
    // p.shift = wp.vec3(-o[0] * inverse_x, -o[1] * inverse_y, -o[2] * inverse_z)             <L 91>
    var_28 = wp::extract(var_o, var_27);
    var_29 = wp::neg(var_28);
    var_30 = wp::mul(var_29, var_10);
    var_32 = wp::extract(var_o, var_31);
    var_33 = wp::neg(var_32);
    var_34 = wp::mul(var_33, var_12);
    var_36 = wp::extract(var_o, var_35);
    var_37 = wp::neg(var_36);
    var_38 = wp::mul(var_37, var_14);
    var_39 = wp::vec_t<3, wp::float32>(var_30, var_34, var_38);
    var_25.shift = var_39;
    // p.near = wp.vec3i(wp.where(x < 0.0, _UPPER, 0), wp.where(y < 0.0, _UPPER, 0), wp.where(z < 0.0, _UPPER, 0))       <L 92>
    var_41 = (var_2 < var_40);
    var_44 = wp::where(var_41, var_42, var_43);
    var_46 = (var_5 < var_45);
    var_48 = wp::where(var_46, var_42, var_47);
    var_50 = (var_8 < var_49);
    var_52 = wp::where(var_50, var_42, var_51);
    var_53 = wp::vec_t<3, wp::int32>(var_44, var_48, var_52);
    var_25.near = var_53;
    // p.origin = wp.vec3(                                                                    <L 93>
    // wp.where(to_z, o[0], wp.where(to_y, o[2], o[1])),                                      <L 94>
    var_55 = wp::extract(var_o, var_54);
    var_57 = wp::extract(var_o, var_56);
    var_59 = wp::extract(var_o, var_58);
    var_60 = wp::where(var_17, var_57, var_59);
    var_61 = wp::where(var_22, var_55, var_60);
    // wp.where(to_z, o[1], wp.where(to_y, o[0], o[2])),                                      <L 95>
    var_63 = wp::extract(var_o, var_62);
    var_65 = wp::extract(var_o, var_64);
    var_67 = wp::extract(var_o, var_66);
    var_68 = wp::where(var_17, var_65, var_67);
    var_69 = wp::where(var_22, var_63, var_68);
    // wp.where(to_z, o[2], wp.where(to_y, o[1], o[0])),                                      <L 96>
    var_71 = wp::extract(var_o, var_70);
    var_73 = wp::extract(var_o, var_72);
    var_75 = wp::extract(var_o, var_74);
    var_76 = wp::where(var_17, var_73, var_75);
    var_77 = wp::where(var_22, var_71, var_76);
    var_78 = wp::vec_t<3, wp::float32>(var_61, var_69, var_77);
    // p.origin = wp.vec3(                                                                    <L 93>
    var_25.origin = var_78;
    // p.shear = wp.vec3(                                                                     <L 98>
    // -wp.where(to_z, x, wp.where(to_y, z, y)) * scale,                                      <L 99>
    var_79 = wp::where(var_17, var_8, var_5);
    var_80 = wp::where(var_22, var_2, var_79);
    var_81 = wp::neg(var_80);
    var_82 = wp::mul(var_81, var_24);
    // -wp.where(to_z, y, wp.where(to_y, x, z)) * scale,                                      <L 100>
    var_83 = wp::where(var_17, var_2, var_8);
    var_84 = wp::where(var_22, var_5, var_83);
    var_85 = wp::neg(var_84);
    var_86 = wp::mul(var_85, var_24);
    // wp.where(to_z, z, wp.where(to_y, y, x)),                                               <L 101>
    var_87 = wp::where(var_17, var_5, var_2);
    var_88 = wp::where(var_22, var_8, var_87);
    var_89 = wp::vec_t<3, wp::float32>(var_82, var_86, var_88);
    // p.shear = wp.vec3(                                                                     <L 98>
    var_25.shear = var_89;
    // p.axes = wp.vec3i(                                                                     <L 103>
    // wp.where(to_z, 0, wp.where(to_y, _Z, _Y)),                                             <L 104>
    var_93 = wp::where(var_17, var_91, var_92);
    var_94 = wp::where(var_22, var_90, var_93);
    // wp.where(to_z, _Y, wp.where(to_y, 0, _Z)),                                             <L 105>
    var_96 = wp::where(var_17, var_95, var_91);
    var_97 = wp::where(var_22, var_92, var_96);
    // wp.where(to_z, _Z, wp.where(to_y, _Y, 0)),                                             <L 106>
    var_99 = wp::where(var_17, var_92, var_98);
    var_100 = wp::where(var_22, var_91, var_99);
    var_101 = wp::vec_t<3, wp::int32>(var_94, var_97, var_100);
    // p.axes = wp.vec3i(                                                                     <L 103>
    var_25.axes = var_101;
    // return p                                                                               <L 108>
    return var_25;
}


// /work/main/warpsample/tracing/wide/prepare.py:111
static void prepare_wide_0(
    wp::uint64 var_chunk,
    wp::int32 var_length)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 1664;
    wp::tuple_t<wp::int32> var_1;
    wp::array_t<wp::float32> var_2;
    const wp::int32 var_3 = 1664;
    wp::tuple_t<wp::int32> var_4;
    wp::array_t<wp::int32> var_5;
    const wp::int32 var_6 = 1664;
    const wp::int32 var_7 = 0;
    wp::int32 var_8;
    bool var_9;
    const wp::int32 var_10 = 0;
    wp::int32 var_11;
    wp::float32* var_12;
    const wp::int32 var_13 = 64;
    wp::int32 var_14;
    wp::int32 var_15;
    wp::float32* var_16;
    const wp::int32 var_17 = 2;
    wp::int32 var_18;
    wp::int32 var_19;
    wp::int32 var_20;
    wp::float32* var_21;
    wp::vec_t<3, wp::float32> var_22;
    wp::float32 var_23;
    wp::float32 var_24;
    wp::float32 var_25;
    const wp::int32 var_26 = 192;
    wp::int32 var_27;
    wp::float32* var_28;
    wp::int32 var_29;
    wp::int32 var_30;
    wp::float32* var_31;
    const wp::int32 var_32 = 2;
    wp::int32 var_33;
    wp::int32 var_34;
    wp::int32 var_35;
    wp::float32* var_36;
    wp::vec_t<3, wp::float32> var_37;
    wp::float32 var_38;
    wp::float32 var_39;
    wp::float32 var_40;
    PreparedRay_54268e28 var_41;
    wp::vec_t<3, wp::float32>* var_42;
    const wp::int32 var_43 = 0;
    wp::float32 var_44;
    wp::vec_t<3, wp::float32> var_45;
    const wp::int32 var_46 = 512;
    wp::int32 var_47;
    wp::vec_t<3, wp::float32>* var_48;
    const wp::int32 var_49 = 1;
    wp::float32 var_50;
    wp::vec_t<3, wp::float32> var_51;
    wp::int32 var_52;
    wp::int32 var_53;
    wp::vec_t<3, wp::float32>* var_54;
    const wp::int32 var_55 = 2;
    wp::float32 var_56;
    wp::vec_t<3, wp::float32> var_57;
    const wp::int32 var_58 = 2;
    wp::int32 var_59;
    wp::int32 var_60;
    wp::int32 var_61;
    wp::vec_t<3, wp::float32>* var_62;
    const wp::int32 var_63 = 0;
    wp::float32 var_64;
    wp::vec_t<3, wp::float32> var_65;
    const wp::int32 var_66 = 704;
    wp::int32 var_67;
    wp::vec_t<3, wp::float32>* var_68;
    const wp::int32 var_69 = 1;
    wp::float32 var_70;
    wp::vec_t<3, wp::float32> var_71;
    wp::int32 var_72;
    wp::int32 var_73;
    wp::vec_t<3, wp::float32>* var_74;
    const wp::int32 var_75 = 2;
    wp::float32 var_76;
    wp::vec_t<3, wp::float32> var_77;
    const wp::int32 var_78 = 2;
    wp::int32 var_79;
    wp::int32 var_80;
    wp::int32 var_81;
    wp::vec_t<3, wp::int32>* var_82;
    const wp::int32 var_83 = 0;
    wp::int32 var_84;
    wp::vec_t<3, wp::int32> var_85;
    const wp::int32 var_86 = 896;
    wp::int32 var_87;
    wp::vec_t<3, wp::int32>* var_88;
    const wp::int32 var_89 = 1;
    wp::int32 var_90;
    wp::vec_t<3, wp::int32> var_91;
    wp::int32 var_92;
    wp::int32 var_93;
    wp::vec_t<3, wp::int32>* var_94;
    const wp::int32 var_95 = 2;
    wp::int32 var_96;
    wp::vec_t<3, wp::int32> var_97;
    const wp::int32 var_98 = 2;
    wp::int32 var_99;
    wp::int32 var_100;
    wp::int32 var_101;
    wp::vec_t<3, wp::float32>* var_102;
    const wp::int32 var_103 = 0;
    wp::float32 var_104;
    wp::vec_t<3, wp::float32> var_105;
    const wp::int32 var_106 = 1088;
    wp::int32 var_107;
    wp::vec_t<3, wp::float32>* var_108;
    const wp::int32 var_109 = 1;
    wp::float32 var_110;
    wp::vec_t<3, wp::float32> var_111;
    wp::int32 var_112;
    wp::int32 var_113;
    wp::vec_t<3, wp::float32>* var_114;
    const wp::int32 var_115 = 2;
    wp::float32 var_116;
    wp::vec_t<3, wp::float32> var_117;
    const wp::int32 var_118 = 2;
    wp::int32 var_119;
    wp::int32 var_120;
    wp::int32 var_121;
    wp::vec_t<3, wp::float32>* var_122;
    const wp::int32 var_123 = 0;
    wp::float32 var_124;
    wp::vec_t<3, wp::float32> var_125;
    const wp::int32 var_126 = 1280;
    wp::int32 var_127;
    wp::vec_t<3, wp::float32>* var_128;
    const wp::int32 var_129 = 1;
    wp::float32 var_130;
    wp::vec_t<3, wp::float32> var_131;
    wp::int32 var_132;
    wp::int32 var_133;
    wp::vec_t<3, wp::float32>* var_134;
    const wp::int32 var_135 = 2;
    wp::float32 var_136;
    wp::vec_t<3, wp::float32> var_137;
    const wp::int32 var_138 = 2;
    wp::int32 var_139;
    wp::int32 var_140;
    wp::int32 var_141;
    wp::vec_t<3, wp::int32>* var_142;
    const wp::int32 var_143 = 0;
    wp::int32 var_144;
    wp::vec_t<3, wp::int32> var_145;
    const wp::int32 var_146 = 1472;
    wp::int32 var_147;
    wp::vec_t<3, wp::int32>* var_148;
    const wp::int32 var_149 = 1;
    wp::int32 var_150;
    wp::vec_t<3, wp::int32> var_151;
    wp::int32 var_152;
    wp::int32 var_153;
    wp::vec_t<3, wp::int32>* var_154;
    const wp::int32 var_155 = 2;
    wp::int32 var_156;
    wp::vec_t<3, wp::int32> var_157;
    const wp::int32 var_158 = 2;
    wp::int32 var_159;
    wp::int32 var_160;
    wp::int32 var_161;
    const wp::int32 var_162 = 1;
    wp::int32 var_163;
    //---------
    // forward
    // def prepare_wide(chunk: wp.uint64, length: wp.int32):                                  <L 112>
    // rays = wp.array(ptr=chunk, shape=(CHUNK_FLOATS,), dtype=wp.float32)                    <L 114>
    var_1 = wp::tuple(var_0);
    var_2 = wp::array_t<wp::float32>(var_chunk, var_3);
    // offsets = wp.array(ptr=chunk, shape=(CHUNK_FLOATS,), dtype=wp.int32)                   <L 115>
    var_4 = wp::tuple(var_0);
    var_5 = wp::array_t<wp::int32>(var_chunk, var_6);
    // k = wp.int32(0)                                                                        <L 116>
    var_8 = wp::int32(var_7);
    // while k < length:                                                                      <L 117>
    start_while_0:;
    var_9 = (var_8 < var_length);
    if ((var_9) == false) goto end_while_0;
        // o = wp.vec3(rays[ORIGIN + k], rays[ORIGIN + CHUNK + k], rays[ORIGIN + 2 * CHUNK + k])       <L 118>
        var_11 = wp::add(var_10, var_8);
        var_12 = wp::address(var_2, var_11);
        var_14 = wp::add(var_10, var_13);
        var_15 = wp::add(var_14, var_8);
        var_16 = wp::address(var_2, var_15);
        var_18 = wp::mul(var_17, var_13);
        var_19 = wp::add(var_10, var_18);
        var_20 = wp::add(var_19, var_8);
        var_21 = wp::address(var_2, var_20);
        var_23 = wp::load(var_12);
        var_24 = wp::load(var_16);
        var_25 = wp::load(var_21);
        var_22 = wp::vec_t<3, wp::float32>(var_23, var_24, var_25);
        // d = wp.vec3(rays[DIRECTION + k], rays[DIRECTION + CHUNK + k], rays[DIRECTION + 2 * CHUNK + k])       <L 119>
        var_27 = wp::add(var_26, var_8);
        var_28 = wp::address(var_2, var_27);
        var_29 = wp::add(var_26, var_13);
        var_30 = wp::add(var_29, var_8);
        var_31 = wp::address(var_2, var_30);
        var_33 = wp::mul(var_32, var_13);
        var_34 = wp::add(var_26, var_33);
        var_35 = wp::add(var_34, var_8);
        var_36 = wp::address(var_2, var_35);
        var_38 = wp::load(var_28);
        var_39 = wp::load(var_31);
        var_40 = wp::load(var_36);
        var_37 = wp::vec_t<3, wp::float32>(var_38, var_39, var_40);
        // p = prepare_ray(o, d)                                                              <L 120>
        var_41 = prepare_ray_0(var_22, var_37);
        // rays[_INVERSE + k] = p.inverse[0]                                                  <L 121>
        var_42 = &((var_41).inverse);
        var_45 = wp::load(var_42);
        var_44 = wp::extract(var_45, var_43);
        var_47 = wp::add(var_46, var_8);
        wp::array_store(var_2, var_47, var_44);
        // rays[_INVERSE + CHUNK + k] = p.inverse[1]                                          <L 122>
        var_48 = &((var_41).inverse);
        var_51 = wp::load(var_48);
        var_50 = wp::extract(var_51, var_49);
        var_52 = wp::add(var_46, var_13);
        var_53 = wp::add(var_52, var_8);
        wp::array_store(var_2, var_53, var_50);
        // rays[_INVERSE + 2 * CHUNK + k] = p.inverse[2]                                      <L 123>
        var_54 = &((var_41).inverse);
        var_57 = wp::load(var_54);
        var_56 = wp::extract(var_57, var_55);
        var_59 = wp::mul(var_58, var_13);
        var_60 = wp::add(var_46, var_59);
        var_61 = wp::add(var_60, var_8);
        wp::array_store(var_2, var_61, var_56);
        // rays[_SHIFT + k] = p.shift[0]                                                      <L 124>
        var_62 = &((var_41).shift);
        var_65 = wp::load(var_62);
        var_64 = wp::extract(var_65, var_63);
        var_67 = wp::add(var_66, var_8);
        wp::array_store(var_2, var_67, var_64);
        // rays[_SHIFT + CHUNK + k] = p.shift[1]                                              <L 125>
        var_68 = &((var_41).shift);
        var_71 = wp::load(var_68);
        var_70 = wp::extract(var_71, var_69);
        var_72 = wp::add(var_66, var_13);
        var_73 = wp::add(var_72, var_8);
        wp::array_store(var_2, var_73, var_70);
        // rays[_SHIFT + 2 * CHUNK + k] = p.shift[2]                                          <L 126>
        var_74 = &((var_41).shift);
        var_77 = wp::load(var_74);
        var_76 = wp::extract(var_77, var_75);
        var_79 = wp::mul(var_78, var_13);
        var_80 = wp::add(var_66, var_79);
        var_81 = wp::add(var_80, var_8);
        wp::array_store(var_2, var_81, var_76);
        // offsets[_NEAR + k] = p.near[0]                                                     <L 127>
        var_82 = &((var_41).near);
        var_85 = wp::load(var_82);
        var_84 = wp::extract(var_85, var_83);
        var_87 = wp::add(var_86, var_8);
        wp::array_store(var_5, var_87, var_84);
        // offsets[_NEAR + CHUNK + k] = p.near[1]                                             <L 128>
        var_88 = &((var_41).near);
        var_91 = wp::load(var_88);
        var_90 = wp::extract(var_91, var_89);
        var_92 = wp::add(var_86, var_13);
        var_93 = wp::add(var_92, var_8);
        wp::array_store(var_5, var_93, var_90);
        // offsets[_NEAR + 2 * CHUNK + k] = p.near[2]                                         <L 129>
        var_94 = &((var_41).near);
        var_97 = wp::load(var_94);
        var_96 = wp::extract(var_97, var_95);
        var_99 = wp::mul(var_98, var_13);
        var_100 = wp::add(var_86, var_99);
        var_101 = wp::add(var_100, var_8);
        wp::array_store(var_5, var_101, var_96);
        // rays[_ORIGIN + k] = p.origin[0]                                                    <L 130>
        var_102 = &((var_41).origin);
        var_105 = wp::load(var_102);
        var_104 = wp::extract(var_105, var_103);
        var_107 = wp::add(var_106, var_8);
        wp::array_store(var_2, var_107, var_104);
        // rays[_ORIGIN + CHUNK + k] = p.origin[1]                                            <L 131>
        var_108 = &((var_41).origin);
        var_111 = wp::load(var_108);
        var_110 = wp::extract(var_111, var_109);
        var_112 = wp::add(var_106, var_13);
        var_113 = wp::add(var_112, var_8);
        wp::array_store(var_2, var_113, var_110);
        // rays[_ORIGIN + 2 * CHUNK + k] = p.origin[2]                                        <L 132>
        var_114 = &((var_41).origin);
        var_117 = wp::load(var_114);
        var_116 = wp::extract(var_117, var_115);
        var_119 = wp::mul(var_118, var_13);
        var_120 = wp::add(var_106, var_119);
        var_121 = wp::add(var_120, var_8);
        wp::array_store(var_2, var_121, var_116);
        // rays[_SHEAR + k] = p.shear[0]                                                      <L 133>
        var_122 = &((var_41).shear);
        var_125 = wp::load(var_122);
        var_124 = wp::extract(var_125, var_123);
        var_127 = wp::add(var_126, var_8);
        wp::array_store(var_2, var_127, var_124);
        // rays[_SHEAR + CHUNK + k] = p.shear[1]                                              <L 134>
        var_128 = &((var_41).shear);
        var_131 = wp::load(var_128);
        var_130 = wp::extract(var_131, var_129);
        var_132 = wp::add(var_126, var_13);
        var_133 = wp::add(var_132, var_8);
        wp::array_store(var_2, var_133, var_130);
        // rays[_SHEAR + 2 * CHUNK + k] = p.shear[2]                                          <L 135>
        var_134 = &((var_41).shear);
        var_137 = wp::load(var_134);
        var_136 = wp::extract(var_137, var_135);
        var_139 = wp::mul(var_138, var_13);
        var_140 = wp::add(var_126, var_139);
        var_141 = wp::add(var_140, var_8);
        wp::array_store(var_2, var_141, var_136);
        // offsets[_AXES + k] = p.axes[0]                                                     <L 136>
        var_142 = &((var_41).axes);
        var_145 = wp::load(var_142);
        var_144 = wp::extract(var_145, var_143);
        var_147 = wp::add(var_146, var_8);
        wp::array_store(var_5, var_147, var_144);
        // offsets[_AXES + CHUNK + k] = p.axes[1]                                             <L 137>
        var_148 = &((var_41).axes);
        var_151 = wp::load(var_148);
        var_150 = wp::extract(var_151, var_149);
        var_152 = wp::add(var_146, var_13);
        var_153 = wp::add(var_152, var_8);
        wp::array_store(var_5, var_153, var_150);
        // offsets[_AXES + 2 * CHUNK + k] = p.axes[2]                                         <L 138>
        var_154 = &((var_41).axes);
        var_157 = wp::load(var_154);
        var_156 = wp::extract(var_157, var_155);
        var_159 = wp::mul(var_158, var_13);
        var_160 = wp::add(var_146, var_159);
        var_161 = wp::add(var_160, var_8);
        wp::array_store(var_5, var_161, var_156);
        // k += 1                                                                             <L 139>
        var_163 = wp::add(var_8, var_162);
        wp::assign(var_8, var_163);
    goto start_while_0;
    end_while_0:;
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


// /work/main/warpsample/tracing/wide/prepare.py:142
static Ray_728362d1 _ray_0(
    PreparedRay_54268e28 var_p,
    wp::uint64 var_direction,
    wp::uint64 var_rows_of_leaf)
{
    //---------
    // primal vars
    Ray_728362d1 var_0;
    wp::vec_t<3, wp::float32>* var_1;
    const wp::int32 var_2 = 0;
    wp::float32 var_3;
    wp::vec_t<3, wp::float32> var_4;
    wp::vec_t<3, wp::float32>* var_5;
    const wp::int32 var_6 = 1;
    wp::float32 var_7;
    wp::vec_t<3, wp::float32> var_8;
    wp::vec_t<3, wp::float32>* var_9;
    const wp::int32 var_10 = 2;
    wp::float32 var_11;
    wp::vec_t<3, wp::float32> var_12;
    wp::vec_t<3, wp::float32>* var_13;
    const wp::int32 var_14 = 0;
    wp::float32 var_15;
    wp::vec_t<3, wp::float32> var_16;
    wp::vec_t<3, wp::float32>* var_17;
    const wp::int32 var_18 = 1;
    wp::float32 var_19;
    wp::vec_t<3, wp::float32> var_20;
    wp::vec_t<3, wp::float32>* var_21;
    const wp::int32 var_22 = 2;
    wp::float32 var_23;
    wp::vec_t<3, wp::float32> var_24;
    wp::vec_t<3, wp::int32>* var_25;
    const wp::int32 var_26 = 0;
    wp::int32 var_27;
    wp::vec_t<3, wp::int32> var_28;
    wp::uint64 var_29;
    wp::vec_t<3, wp::int32>* var_30;
    const wp::int32 var_31 = 1;
    wp::int32 var_32;
    wp::vec_t<3, wp::int32> var_33;
    wp::uint64 var_34;
    wp::vec_t<3, wp::int32>* var_35;
    const wp::int32 var_36 = 2;
    wp::int32 var_37;
    wp::vec_t<3, wp::int32> var_38;
    wp::uint64 var_39;
    wp::vec_t<3, wp::float32>* var_40;
    const wp::int32 var_41 = 0;
    wp::float32 var_42;
    wp::vec_t<3, wp::float32> var_43;
    wp::vec_t<3, wp::float32>* var_44;
    const wp::int32 var_45 = 1;
    wp::float32 var_46;
    wp::vec_t<3, wp::float32> var_47;
    wp::vec_t<3, wp::float32>* var_48;
    const wp::int32 var_49 = 2;
    wp::float32 var_50;
    wp::vec_t<3, wp::float32> var_51;
    wp::vec_t<3, wp::float32>* var_52;
    const wp::int32 var_53 = 0;
    wp::float32 var_54;
    wp::vec_t<3, wp::float32> var_55;
    wp::vec_t<3, wp::float32>* var_56;
    const wp::int32 var_57 = 1;
    wp::float32 var_58;
    wp::vec_t<3, wp::float32> var_59;
    wp::vec_t<3, wp::float32>* var_60;
    const wp::int32 var_61 = 2;
    wp::float32 var_62;
    wp::vec_t<3, wp::float32> var_63;
    wp::vec_t<3, wp::int32>* var_64;
    const wp::int32 var_65 = 0;
    wp::int32 var_66;
    wp::vec_t<3, wp::int32> var_67;
    wp::uint64 var_68;
    wp::vec_t<3, wp::int32>* var_69;
    const wp::int32 var_70 = 1;
    wp::int32 var_71;
    wp::vec_t<3, wp::int32> var_72;
    wp::uint64 var_73;
    wp::vec_t<3, wp::int32>* var_74;
    const wp::int32 var_75 = 2;
    wp::int32 var_76;
    wp::vec_t<3, wp::int32> var_77;
    wp::uint64 var_78;
    //---------
    // forward
    // def _ray(p: PreparedRay, direction: wp.uint64, rows_of_leaf: wp.uint64) -> Ray:        <L 143>
    // ray = Ray()                                                                            <L 145>
    var_0 = Ray_728362d1();
    // ray.inverse_x = p.inverse[0]                                                           <L 146>
    var_1 = &((var_p).inverse);
    var_4 = wp::load(var_1);
    var_3 = wp::extract(var_4, var_2);
    var_0.inverse_x = var_3;
    // ray.inverse_y = p.inverse[1]                                                           <L 147>
    var_5 = &((var_p).inverse);
    var_8 = wp::load(var_5);
    var_7 = wp::extract(var_8, var_6);
    var_0.inverse_y = var_7;
    // ray.inverse_z = p.inverse[2]                                                           <L 148>
    var_9 = &((var_p).inverse);
    var_12 = wp::load(var_9);
    var_11 = wp::extract(var_12, var_10);
    var_0.inverse_z = var_11;
    // ray.shift_x = p.shift[0]                                                               <L 149>
    var_13 = &((var_p).shift);
    var_16 = wp::load(var_13);
    var_15 = wp::extract(var_16, var_14);
    var_0.shift_x = var_15;
    // ray.shift_y = p.shift[1]                                                               <L 150>
    var_17 = &((var_p).shift);
    var_20 = wp::load(var_17);
    var_19 = wp::extract(var_20, var_18);
    var_0.shift_y = var_19;
    // ray.shift_z = p.shift[2]                                                               <L 151>
    var_21 = &((var_p).shift);
    var_24 = wp::load(var_21);
    var_23 = wp::extract(var_24, var_22);
    var_0.shift_z = var_23;
    // ray.near_x = wp.uint64(p.near[0])                                                      <L 152>
    var_25 = &((var_p).near);
    var_28 = wp::load(var_25);
    var_27 = wp::extract(var_28, var_26);
    var_29 = wp::uint64(var_27);
    var_0.near_x = var_29;
    // ray.near_y = wp.uint64(p.near[1])                                                      <L 153>
    var_30 = &((var_p).near);
    var_33 = wp::load(var_30);
    var_32 = wp::extract(var_33, var_31);
    var_34 = wp::uint64(var_32);
    var_0.near_y = var_34;
    // ray.near_z = wp.uint64(p.near[2])                                                      <L 154>
    var_35 = &((var_p).near);
    var_38 = wp::load(var_35);
    var_37 = wp::extract(var_38, var_36);
    var_39 = wp::uint64(var_37);
    var_0.near_z = var_39;
    // ray.origin_first = p.origin[0]                                                         <L 155>
    var_40 = &((var_p).origin);
    var_43 = wp::load(var_40);
    var_42 = wp::extract(var_43, var_41);
    var_0.origin_first = var_42;
    // ray.origin_second = p.origin[1]                                                        <L 156>
    var_44 = &((var_p).origin);
    var_47 = wp::load(var_44);
    var_46 = wp::extract(var_47, var_45);
    var_0.origin_second = var_46;
    // ray.origin_along = p.origin[2]                                                         <L 157>
    var_48 = &((var_p).origin);
    var_51 = wp::load(var_48);
    var_50 = wp::extract(var_51, var_49);
    var_0.origin_along = var_50;
    // ray.shear_first = p.shear[0]                                                           <L 158>
    var_52 = &((var_p).shear);
    var_55 = wp::load(var_52);
    var_54 = wp::extract(var_55, var_53);
    var_0.shear_first = var_54;
    // ray.shear_second = p.shear[1]                                                          <L 159>
    var_56 = &((var_p).shear);
    var_59 = wp::load(var_56);
    var_58 = wp::extract(var_59, var_57);
    var_0.shear_second = var_58;
    // ray.share_along = p.shear[2]                                                           <L 160>
    var_60 = &((var_p).shear);
    var_63 = wp::load(var_60);
    var_62 = wp::extract(var_63, var_61);
    var_0.share_along = var_62;
    // ray.first = wp.uint64(p.axes[0])                                                       <L 161>
    var_64 = &((var_p).axes);
    var_67 = wp::load(var_64);
    var_66 = wp::extract(var_67, var_65);
    var_68 = wp::uint64(var_66);
    var_0.first = var_68;
    // ray.second = wp.uint64(p.axes[1])                                                      <L 162>
    var_69 = &((var_p).axes);
    var_72 = wp::load(var_69);
    var_71 = wp::extract(var_72, var_70);
    var_73 = wp::uint64(var_71);
    var_0.second = var_73;
    // ray.along = wp.uint64(p.axes[2])                                                       <L 163>
    var_74 = &((var_p).axes);
    var_77 = wp::load(var_74);
    var_76 = wp::extract(var_77, var_75);
    var_78 = wp::uint64(var_76);
    var_0.along = var_78;
    // ray.direction = direction                                                              <L 164>
    var_0.direction = var_direction;
    // ray.rows_of_leaf = rows_of_leaf                                                        <L 165>
    var_0.rows_of_leaf = var_rows_of_leaf;
    // return ray                                                                             <L 166>
    return var_0;
}


// /work/main/warpsample/tracing/wide/prepare.py:169
static Ray_728362d1 ray_in_0(
    wp::uint64 var_column)
{
    //---------
    // primal vars
    PreparedRay_54268e28 var_0;
    const wp::int32 var_1 = 512;
    wp::vec_t<3, wp::float32> var_2;
    const wp::int32 var_3 = 704;
    wp::vec_t<3, wp::float32> var_4;
    const wp::int32 var_5 = 896;
    wp::int32 var_6;
    const wp::int32 var_7 = 64;
    wp::int32 var_8;
    wp::int32 var_9;
    const wp::int32 var_10 = 2;
    wp::int32 var_11;
    wp::int32 var_12;
    wp::int32 var_13;
    wp::vec_t<3, wp::int32> var_14;
    const wp::int32 var_15 = 1088;
    wp::vec_t<3, wp::float32> var_16;
    const wp::int32 var_17 = 1280;
    wp::vec_t<3, wp::float32> var_18;
    const wp::int32 var_19 = 1472;
    wp::int32 var_20;
    wp::int32 var_21;
    wp::int32 var_22;
    const wp::int32 var_23 = 2;
    wp::int32 var_24;
    wp::int32 var_25;
    wp::int32 var_26;
    wp::vec_t<3, wp::int32> var_27;
    const wp::uint64 var_28 = 768ull;
    wp::uint64 var_29;
    const wp::uint64 var_30 = 4ull;
    Ray_728362d1 var_31;
    //---------
    // forward
    // def ray_in(column: wp.uint64) -> Ray:                                                  <L 170>
    // p = PreparedRay()                                                                      <L 172>
    var_0 = PreparedRay_54268e28();
    // p.inverse = vector_in(column, _INVERSE)                                                <L 173>
    var_2 = vector_in_0(var_column, var_1);
    var_0.inverse = var_2;
    // p.shift = vector_in(column, _SHIFT)                                                    <L 174>
    var_4 = vector_in_0(var_column, var_3);
    var_0.shift = var_4;
    // p.near = wp.vec3i(int_at(column, _NEAR), int_at(column, _NEAR + CHUNK), int_at(column, _NEAR + 2 * CHUNK))       <L 175>
    var_6 = _reader__locals__read_1(var_column, var_5);
    var_8 = wp::add(var_5, var_7);
    var_9 = _reader__locals__read_1(var_column, var_8);
    var_11 = wp::mul(var_10, var_7);
    var_12 = wp::add(var_5, var_11);
    var_13 = _reader__locals__read_1(var_column, var_12);
    var_14 = wp::vec_t<3, wp::int32>(var_6, var_9, var_13);
    var_0.near = var_14;
    // p.origin = vector_in(column, _ORIGIN)                                                  <L 176>
    var_16 = vector_in_0(var_column, var_15);
    var_0.origin = var_16;
    // p.shear = vector_in(column, _SHEAR)                                                    <L 177>
    var_18 = vector_in_0(var_column, var_17);
    var_0.shear = var_18;
    // p.axes = wp.vec3i(int_at(column, _AXES), int_at(column, _AXES + CHUNK), int_at(column, _AXES + 2 * CHUNK))       <L 178>
    var_20 = _reader__locals__read_1(var_column, var_19);
    var_21 = wp::add(var_19, var_7);
    var_22 = _reader__locals__read_1(var_column, var_21);
    var_24 = wp::mul(var_23, var_7);
    var_25 = wp::add(var_19, var_24);
    var_26 = _reader__locals__read_1(var_column, var_25);
    var_27 = wp::vec_t<3, wp::int32>(var_20, var_22, var_26);
    var_0.axes = var_27;
    // return _ray(p, column + _DIRECTION_BYTES, _ROWS_OF_LEAF)                               <L 179>
    var_29 = wp::add(var_column, var_28);
    var_31 = _ray_0(var_0, var_29, var_30);
    return var_31;
}


// /work/main/warpsample/tracing/wide/candidates.py:25
static wp::float32 entry_distance_0(
    wp::uint64 var_node,
    Ray_728362d1 var_ray,
    wp::int32 var_k)
{
    //---------
    // primal vars
    wp::uint64* var_0;
    wp::uint64 var_1;
    wp::uint64 var_2;
    const wp::int32 var_3 = 16;
    wp::tuple_t<wp::int32> var_4;
    wp::array_t<wp::float32> var_5;
    const wp::int32 var_6 = 16;
    const wp::uint64 var_7 = 64ull;
    wp::uint64 var_8;
    wp::uint64* var_9;
    wp::uint64 var_10;
    wp::uint64 var_11;
    wp::tuple_t<wp::int32> var_12;
    wp::array_t<wp::float32> var_13;
    const wp::int32 var_14 = 16;
    wp::uint64 var_15;
    wp::uint64 var_16;
    wp::uint64* var_17;
    wp::uint64 var_18;
    wp::uint64 var_19;
    wp::tuple_t<wp::int32> var_20;
    wp::array_t<wp::float32> var_21;
    const wp::int32 var_22 = 16;
    wp::float32* var_23;
    wp::float32* var_24;
    wp::float32* var_25;
    wp::float32 var_26;
    wp::float32 var_27;
    wp::float32 var_28;
    wp::float32 var_29;
    wp::float32* var_30;
    wp::float32* var_31;
    wp::float32* var_32;
    wp::float32 var_33;
    wp::float32 var_34;
    wp::float32 var_35;
    wp::float32 var_36;
    wp::float32* var_37;
    wp::float32* var_38;
    wp::float32* var_39;
    wp::float32 var_40;
    wp::float32 var_41;
    wp::float32 var_42;
    wp::float32 var_43;
    wp::float32 var_44;
    const wp::float32 var_45 = 0.0;
    wp::float32 var_46;
    wp::float32 var_47;
    //---------
    // forward
    // def entry_distance(node: wp.uint64, ray: Ray, k: wp.int32) -> wp.float32:              <L 26>
    // x = wp.array(ptr=node + ray.near_x, shape=(WIDTH,), dtype=wp.float32)                  <L 28>
    var_0 = &((var_ray).near_x);
    var_2 = wp::load(var_0);
    var_1 = wp::add(var_node, var_2);
    var_4 = wp::tuple(var_3);
    var_5 = wp::array_t<wp::float32>(var_1, var_6);
    // y = wp.array(ptr=node + _ROW + ray.near_y, shape=(WIDTH,), dtype=wp.float32)           <L 29>
    var_8 = wp::add(var_node, var_7);
    var_9 = &((var_ray).near_y);
    var_11 = wp::load(var_9);
    var_10 = wp::add(var_8, var_11);
    var_12 = wp::tuple(var_3);
    var_13 = wp::array_t<wp::float32>(var_10, var_14);
    // z = wp.array(ptr=node + _ROW + _ROW + ray.near_z, shape=(WIDTH,), dtype=wp.float32)       <L 30>
    var_15 = wp::add(var_node, var_7);
    var_16 = wp::add(var_15, var_7);
    var_17 = &((var_ray).near_z);
    var_19 = wp::load(var_17);
    var_18 = wp::add(var_16, var_19);
    var_20 = wp::tuple(var_3);
    var_21 = wp::array_t<wp::float32>(var_18, var_22);
    // enter_x = fma(x[k], ray.inverse_x, ray.shift_x)                                        <L 31>
    var_23 = wp::address(var_5, var_k);
    var_24 = &((var_ray).inverse_x);
    var_25 = &((var_ray).shift_x);
    var_27 = wp::load(var_23);
    var_28 = wp::load(var_24);
    var_29 = wp::load(var_25);
    var_26 = fma_0(var_27, var_28, var_29);
    // enter_y = fma(y[k], ray.inverse_y, ray.shift_y)                                        <L 32>
    var_30 = wp::address(var_13, var_k);
    var_31 = &((var_ray).inverse_y);
    var_32 = &((var_ray).shift_y);
    var_34 = wp::load(var_30);
    var_35 = wp::load(var_31);
    var_36 = wp::load(var_32);
    var_33 = fma_0(var_34, var_35, var_36);
    // enter_z = fma(z[k], ray.inverse_z, ray.shift_z)                                        <L 33>
    var_37 = wp::address(var_21, var_k);
    var_38 = &((var_ray).inverse_z);
    var_39 = &((var_ray).shift_z);
    var_41 = wp::load(var_37);
    var_42 = wp::load(var_38);
    var_43 = wp::load(var_39);
    var_40 = fma_0(var_41, var_42, var_43);
    // return greater(greater(enter_x, enter_y), greater(enter_z, 0.0))                       <L 34>
    var_44 = greater_0(var_26, var_33);
    var_46 = greater_0(var_40, var_45);
    var_47 = greater_0(var_44, var_46);
    return var_47;
}


// /work/main/warpsample/maths/numerics.py:226
static wp::float32 lesser_0(
    wp::float32 var_a,
    wp::float32 var_b)
{
    //---------
    // primal vars
    bool var_0;
    wp::float32 var_1;
    //---------
    // forward
    // def lesser(a: wp.float32, b: wp.float32) -> wp.float32:                                <L 227>
    // return wp.where(a < b, a, b)                                                           <L 229>
    var_0 = (var_a < var_b);
    var_1 = wp::where(var_0, var_a, var_b);
    return var_1;
}


// /work/main/warpsample/tracing/wide/candidates.py:37
static wp::float32 exit_distance_0(
    wp::uint64 var_node,
    Ray_728362d1 var_ray,
    wp::float32 var_reach,
    wp::int32 var_k)
{
    //---------
    // primal vars
    const wp::uint64 var_0 = 192ull;
    wp::uint64 var_1;
    wp::uint64* var_2;
    wp::uint64 var_3;
    wp::uint64 var_4;
    const wp::int32 var_5 = 16;
    wp::tuple_t<wp::int32> var_6;
    wp::array_t<wp::float32> var_7;
    const wp::int32 var_8 = 16;
    wp::uint64 var_9;
    const wp::uint64 var_10 = 64ull;
    wp::uint64 var_11;
    wp::uint64* var_12;
    wp::uint64 var_13;
    wp::uint64 var_14;
    wp::tuple_t<wp::int32> var_15;
    wp::array_t<wp::float32> var_16;
    const wp::int32 var_17 = 16;
    wp::uint64 var_18;
    wp::uint64 var_19;
    wp::uint64 var_20;
    wp::uint64* var_21;
    wp::uint64 var_22;
    wp::uint64 var_23;
    wp::tuple_t<wp::int32> var_24;
    wp::array_t<wp::float32> var_25;
    const wp::int32 var_26 = 16;
    wp::float32* var_27;
    wp::float32* var_28;
    wp::float32* var_29;
    wp::float32 var_30;
    wp::float32 var_31;
    wp::float32 var_32;
    wp::float32 var_33;
    wp::float32* var_34;
    wp::float32* var_35;
    wp::float32* var_36;
    wp::float32 var_37;
    wp::float32 var_38;
    wp::float32 var_39;
    wp::float32 var_40;
    wp::float32* var_41;
    wp::float32* var_42;
    wp::float32* var_43;
    wp::float32 var_44;
    wp::float32 var_45;
    wp::float32 var_46;
    wp::float32 var_47;
    wp::float32 var_48;
    wp::float32 var_49;
    wp::float32 var_50;
    //---------
    // forward
    // def exit_distance(node: wp.uint64, ray: Ray, reach: wp.float32, k: wp.int32) -> wp.float32:       <L 38>
    // x = wp.array(ptr=node + _UPPER - ray.near_x, shape=(WIDTH,), dtype=wp.float32)         <L 43>
    var_1 = wp::add(var_node, var_0);
    var_2 = &((var_ray).near_x);
    var_4 = wp::load(var_2);
    var_3 = wp::sub(var_1, var_4);
    var_6 = wp::tuple(var_5);
    var_7 = wp::array_t<wp::float32>(var_3, var_8);
    // y = wp.array(ptr=node + _UPPER + _ROW - ray.near_y, shape=(WIDTH,), dtype=wp.float32)       <L 44>
    var_9 = wp::add(var_node, var_0);
    var_11 = wp::add(var_9, var_10);
    var_12 = &((var_ray).near_y);
    var_14 = wp::load(var_12);
    var_13 = wp::sub(var_11, var_14);
    var_15 = wp::tuple(var_5);
    var_16 = wp::array_t<wp::float32>(var_13, var_17);
    // z = wp.array(ptr=node + _UPPER + _ROW + _ROW - ray.near_z, shape=(WIDTH,), dtype=wp.float32)       <L 45>
    var_18 = wp::add(var_node, var_0);
    var_19 = wp::add(var_18, var_10);
    var_20 = wp::add(var_19, var_10);
    var_21 = &((var_ray).near_z);
    var_23 = wp::load(var_21);
    var_22 = wp::sub(var_20, var_23);
    var_24 = wp::tuple(var_5);
    var_25 = wp::array_t<wp::float32>(var_22, var_26);
    // leave_x = fma(x[k], ray.inverse_x, ray.shift_x)                                        <L 46>
    var_27 = wp::address(var_7, var_k);
    var_28 = &((var_ray).inverse_x);
    var_29 = &((var_ray).shift_x);
    var_31 = wp::load(var_27);
    var_32 = wp::load(var_28);
    var_33 = wp::load(var_29);
    var_30 = fma_0(var_31, var_32, var_33);
    // leave_y = fma(y[k], ray.inverse_y, ray.shift_y)                                        <L 47>
    var_34 = wp::address(var_16, var_k);
    var_35 = &((var_ray).inverse_y);
    var_36 = &((var_ray).shift_y);
    var_38 = wp::load(var_34);
    var_39 = wp::load(var_35);
    var_40 = wp::load(var_36);
    var_37 = fma_0(var_38, var_39, var_40);
    // leave_z = fma(z[k], ray.inverse_z, ray.shift_z)                                        <L 48>
    var_41 = wp::address(var_25, var_k);
    var_42 = &((var_ray).inverse_z);
    var_43 = &((var_ray).shift_z);
    var_45 = wp::load(var_41);
    var_46 = wp::load(var_42);
    var_47 = wp::load(var_43);
    var_44 = fma_0(var_45, var_46, var_47);
    // return lesser(lesser(leave_x, leave_y), lesser(leave_z, reach))                        <L 49>
    var_48 = lesser_0(var_30, var_37);
    var_49 = lesser_0(var_44, var_reach);
    var_50 = lesser_0(var_48, var_49);
    return var_50;
}


// /work/main/warpsample/tracing/wide/lanes.py:6
static CUDA_CALLABLE wp::int32 lanes_with_0(
    wp::uint64 row,
    wp::int32 bit)
{

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
}


// /work/main/warpsample/tracing/wide/candidates.py:52
static void boxes_hit_0(
    wp::uint64 var_node,
    Ray_728362d1 var_ray,
    wp::float32 var_reach,
    wp::int32 var_flip,
    wp::int32 & ret_0,
    wp::int32 & ret_1)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 16;
    wp::tuple_t<wp::int32> var_1;
    wp::fixedarray_t<16, wp::int32> var_2;
    const wp::int32 var_3 = 16;
    const wp::int32 var_4 = 2139095040;
    wp::int32 var_5;
    const wp::int32 var_6 = 0;
    wp::int32 var_7;
    bool var_8;
    wp::float32 var_9;
    wp::float32 var_10;
    bool var_11;
    wp::int32 var_12;
    const wp::int32 var_13 = 15;
    wp::int32 var_14;
    wp::int32 var_15;
    wp::int32 var_16;
    wp::int32 var_17;
    wp::int32 var_18;
    wp::int32 var_19;
    const wp::int32 var_20 = -1;
    const wp::int32 var_21 = 0;
    wp::int32 var_22;
    const wp::int32 var_23 = 1;
    wp::int32 var_24;
    wp::uint64* var_25;
    const wp::int32 var_26 = 31;
    wp::int32 var_27;
    wp::uint64 var_28;
    wp::int32 var_29;
    wp::int32 var_30;
    //---------
    // forward
    // def boxes_hit(node: wp.uint64, ray: Ray, reach: wp.float32, flip: wp.int32):           <L 53>
    // hit = wp.zeros(shape=(WIDTH,), dtype=wp.int32)                                         <L 59>
    var_1 = wp::tuple(var_0);
    var_2 = wp::fixedarray_t<16, wp::int32>(var_3);
    // best = wp.int32(_NO_HIT)                                                               <L 60>
    var_5 = wp::int32(var_4);
    // k = wp.int32(0)                                                                        <L 61>
    var_7 = wp::int32(var_6);
    // while k < WIDTH:                                                                       <L 62>
    start_while_0:;
    var_8 = (var_7 < var_0);
    if ((var_8) == false) goto end_while_0;
        // enter = entry_distance(node, ray, k)                                               <L 63>
        var_9 = entry_distance_0(var_node, var_ray, var_7);
        // met = enter <= exit_distance(node, ray, reach, k)                                  <L 64>
        var_10 = exit_distance_0(var_node, var_ray, var_reach, var_7);
        var_11 = (var_9 <= var_10);
        // key = ((wp.cast(enter, wp.int32) & (~_CHILD)) | k) ^ flip                          <L 66>
        var_12 = wp::cast<wp::int32>(var_9);
        var_14 = wp::invert(var_13);
        var_15 = wp::bit_and(var_12, var_14);
        var_16 = wp::bit_or(var_15, var_7);
        var_17 = wp::bit_xor(var_16, var_flip);
        // best = wp.min(best, wp.where(met, key, _NO_HIT))                                   <L 67>
        var_18 = wp::where(var_11, var_17, var_4);
        var_19 = wp::min(var_5, var_18);
        // hit[k] = wp.where(met, -1, 0)                                                      <L 68>
        var_22 = wp::where(var_11, var_20, var_21);
        wp::array_store(var_2, var_7, var_22);
        // k += 1                                                                             <L 69>
        var_24 = wp::add(var_7, var_23);
        wp::assign(var_5, var_19);
        wp::assign(var_7, var_24);
    goto start_while_0;
    end_while_0:;
    // return lanes_with(hit.ptr, 31), (best ^ flip) & _CHILD                                 <L 70>
    var_25 = (wp::uint64*)&(var_2.data);
    var_28 = wp::load(var_25);
    var_27 = lanes_with_0(var_28, var_26);
    var_29 = wp::bit_xor(var_5, var_flip);
    var_30 = wp::bit_and(var_29, var_13);
    ret_0 = var_27;
    ret_1 = var_30;
    return;
}


// /work/main/warpsample/tracing/wide/query.py:96
static void _start_at_one_0(
    Accelerator_9fc73cd7 var_accelerator,
    Ray_728362d1 var_ray,
    wp::float32 var_reach,
    wp::int32 var_flip,
    wp::uint64 var_scratch,
    wp::uint64 & ret_0,
    wp::int32 & ret_1,
    wp::int32 & ret_2,
    wp::uint64 & ret_3)
{
    //---------
    // primal vars
    wp::uint64* var_0;
    wp::int32 var_1;
    wp::int32 var_2;
    wp::uint64 var_3;
    wp::uint64* var_4;
    wp::uint64 var_5;
    wp::uint64 var_6;
    //---------
    // forward
    // def _start_at_one(accelerator: Accelerator, ray: Ray, reach: wp.float32, flip: wp.int32, scratch: wp.uint64):       <L 97>
    // mask, child = boxes_hit(accelerator.start, ray, reach, flip)                           <L 99>
    var_0 = &((var_accelerator).start);
    var_3 = wp::load(var_0);
    boxes_hit_0(var_3, var_ray, var_reach, var_flip, var_1, var_2);
    // return accelerator.start, mask, child, scratch                                         <L 100>
    var_4 = &((var_accelerator).start);
    var_6 = wp::load(var_4);
    var_5 = wp::copy(var_6);
    ret_0 = var_5;
    ret_1 = var_1;
    ret_2 = var_2;
    ret_3 = var_scratch;
    return;
}


// /work/main/warpsample/tracing/wide/layout.py:50
static wp::int32 link_in_0(
    wp::uint64 var_node,
    wp::int32 var_k)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 96;
    wp::int32 var_1;
    wp::int32 var_2;
    //---------
    // forward
    // def link_in(node: wp.uint64, k: wp.int32) -> wp.int32:                                 <L 51>
    // return int_at(node, LINKS + k)                                                         <L 53>
    var_1 = wp::add(var_0, var_k);
    var_2 = _reader__locals__read_1(var_node, var_1);
    return var_2;
}


// /work/main/warpsample/tracing/wide/layout.py:44
static wp::uint64 leaf_at_0(
    Accelerator_9fc73cd7 var_accelerator,
    wp::int32 var_i)
{
    //---------
    // primal vars
    wp::uint64* var_0;
    wp::uint64 var_1;
    wp::uint64 var_2;
    wp::uint64 var_3;
    wp::uint64 var_4;
    wp::uint64 var_5;
    //---------
    // forward
    // def leaf_at(accelerator: Accelerator, i: wp.int32) -> wp.uint64:                       <L 45>
    // return accelerator.leaves + wp.uint64(i) * wp.uint64(LEAF_BYTES)                       <L 47>
    var_0 = &((var_accelerator).leaves);
    var_1 = wp::uint64(var_i);
    var_2 = 640ull;
    var_3 = wp::mul(var_1, var_2);
    var_5 = wp::load(var_0);
    var_4 = wp::add(var_5, var_3);
    return var_4;
}


// /work/main/warpsample/tracing/wide/layout.py:56
static wp::float32 edge_in_0(
    wp::uint64 var_node,
    wp::int32 var_k)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 112;
    wp::int32 var_1;
    wp::float32 var_2;
    //---------
    // forward
    // def edge_in(node: wp.uint64, k: wp.int32) -> wp.float32:                               <L 57>
    // return float_at(node, EDGES + k)                                                       <L 59>
    var_1 = wp::add(var_0, var_k);
    var_2 = _reader__locals__read_0(var_node, var_1);
    return var_2;
}


// /work/main/warpsample/maths/numerics.py:238
static wp::float32 negative_0(
    wp::float32 var_x)
{
    //---------
    // primal vars
    const wp::float32 var_0 = -1.0;
    wp::float32 var_1;
    wp::float32 var_2;
    //---------
    // forward
    // def negative(x: wp.float32) -> wp.float32:                                             <L 239>
    // return wp.float32(-1.0) * x                                                            <L 241>
    var_1 = wp::float32(var_0);
    var_2 = wp::mul(var_1, var_x);
    return var_2;
}


// /work/main/warpsample/tracing/wide/candidates.py:73
static wp::float32 _flip_sign_0(
    wp::float32 var_x,
    wp::int32 var_sign)
{
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int32 var_1;
    wp::float32 var_2;
    //---------
    // forward
    // def _flip_sign(x: wp.float32, sign: wp.int32) -> wp.float32:                           <L 74>
    // return wp.cast(wp.cast(x, wp.int32) ^ sign, wp.float32)                                <L 76>
    var_0 = wp::cast<wp::int32>(var_x);
    var_1 = wp::bit_xor(var_0, var_sign);
    var_2 = wp::cast<wp::float32>(var_1);
    return var_2;
}


// /work/main/warpsample/tracing/wide/candidates.py:79
static wp::int32 triangles_near_0(
    wp::uint64 var_leaf,
    Ray_728362d1 var_ray,
    wp::float32 var_reach,
    wp::float32 var_edge)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 1.9073486328125e-06;
    const wp::float32 var_1 = 1.0;
    wp::float32* var_2;
    wp::float32 var_3;
    wp::float32 var_4;
    wp::float32 var_5;
    wp::float32 var_6;
    wp::float32 var_7;
    const wp::float32 var_8 = 64.0;
    wp::float32 var_9;
    wp::float32* var_10;
    wp::float32 var_11;
    wp::float32 var_12;
    wp::float32 var_13;
    wp::float32* var_14;
    wp::int32 var_15;
    wp::float32 var_16;
    const wp::int32 var_17 = -2147483648;
    wp::int32 var_18;
    wp::int32 var_19;
    const wp::float32 var_20 = 12.0;
    wp::float32 var_21;
    const wp::float32 var_22 = 8.0;
    wp::float32 var_23;
    wp::float32 var_24;
    const wp::float32 var_25 = 6.357828776041666e-07;
    wp::float32 var_26;
    wp::uint64* var_27;
    wp::uint64 var_28;
    wp::uint64 var_29;
    const wp::int32 var_30 = 144;
    wp::tuple_t<wp::int32> var_31;
    wp::array_t<wp::float32> var_32;
    const wp::int32 var_33 = 144;
    wp::uint64* var_34;
    wp::uint64 var_35;
    wp::uint64 var_36;
    wp::tuple_t<wp::int32> var_37;
    wp::array_t<wp::float32> var_38;
    const wp::int32 var_39 = 144;
    wp::uint64* var_40;
    wp::uint64 var_41;
    wp::uint64 var_42;
    wp::tuple_t<wp::int32> var_43;
    wp::array_t<wp::float32> var_44;
    const wp::int32 var_45 = 144;
    const wp::int32 var_46 = 16;
    wp::tuple_t<wp::int32> var_47;
    wp::fixedarray_t<16, wp::int32> var_48;
    const wp::int32 var_49 = 16;
    const wp::int32 var_50 = 0;
    wp::int32 var_51;
    bool var_52;
    wp::float32* var_53;
    wp::float32* var_54;
    wp::float32 var_55;
    wp::float32 var_56;
    wp::float32 var_57;
    wp::float32* var_58;
    const wp::int32 var_59 = 48;
    wp::int32 var_60;
    wp::float32* var_61;
    wp::float32 var_62;
    wp::float32 var_63;
    wp::float32 var_64;
    wp::float32* var_65;
    const wp::int32 var_66 = 96;
    wp::int32 var_67;
    wp::float32* var_68;
    wp::float32 var_69;
    wp::float32 var_70;
    wp::float32 var_71;
    wp::float32* var_72;
    wp::float32* var_73;
    wp::float32* var_74;
    wp::float32 var_75;
    wp::float32 var_76;
    wp::float32 var_77;
    wp::float32 var_78;
    wp::float32 var_79;
    wp::float32* var_80;
    wp::float32* var_81;
    wp::int32 var_82;
    wp::float32* var_83;
    wp::float32 var_84;
    wp::float32 var_85;
    wp::float32 var_86;
    wp::float32 var_87;
    wp::float32 var_88;
    wp::float32* var_89;
    wp::float32* var_90;
    wp::int32 var_91;
    wp::float32* var_92;
    wp::float32 var_93;
    wp::float32 var_94;
    wp::float32 var_95;
    wp::float32 var_96;
    wp::float32 var_97;
    wp::float32* var_98;
    wp::float32* var_99;
    wp::float32* var_100;
    wp::float32 var_101;
    wp::float32 var_102;
    wp::float32 var_103;
    wp::float32 var_104;
    wp::float32 var_105;
    wp::float32* var_106;
    wp::float32* var_107;
    wp::int32 var_108;
    wp::float32* var_109;
    wp::float32 var_110;
    wp::float32 var_111;
    wp::float32 var_112;
    wp::float32 var_113;
    wp::float32 var_114;
    wp::float32* var_115;
    wp::float32* var_116;
    wp::int32 var_117;
    wp::float32* var_118;
    wp::float32 var_119;
    wp::float32 var_120;
    wp::float32 var_121;
    wp::float32 var_122;
    wp::float32 var_123;
    wp::float32 var_124;
    wp::float32 var_125;
    wp::float32 var_126;
    wp::float32 var_127;
    wp::float32 var_128;
    wp::float32 var_129;
    wp::float32 var_130;
    wp::float32 var_131;
    wp::float32 var_132;
    wp::float32 var_133;
    wp::float32 var_134;
    wp::float32 var_135;
    wp::float32 var_136;
    wp::float32 var_137;
    wp::float32 var_138;
    wp::float32 var_139;
    wp::float32 var_140;
    wp::float32 var_141;
    wp::float32 var_142;
    wp::float32 var_143;
    wp::int32 var_144;
    wp::int32 var_145;
    wp::int32 var_146;
    wp::float32 var_147;
    wp::float32 var_148;
    wp::float32 var_149;
    wp::float32 var_150;
    wp::float32 var_151;
    const wp::float32 var_152 = 6.0;
    wp::float32 var_153;
    wp::float32 var_154;
    wp::float32 var_155;
    wp::float32 var_156;
    wp::float32 var_157;
    wp::float32 var_158;
    wp::float32 var_159;
    bool var_160;
    const wp::int32 var_161 = 1073741824;
    const wp::int32 var_162 = 0;
    wp::int32 var_163;
    wp::float32 var_164;
    wp::float32 var_165;
    bool var_166;
    const wp::int32 var_167 = 0;
    wp::int32 var_168;
    wp::int32 var_169;
    wp::float32 var_170;
    bool var_171;
    const wp::int32 var_172 = -2147483648;
    const wp::int32 var_173 = 0;
    wp::int32 var_174;
    wp::int32 var_175;
    const wp::int32 var_176 = 1;
    wp::int32 var_177;
    wp::uint64* var_178;
    const wp::int32 var_179 = 31;
    wp::int32 var_180;
    wp::uint64 var_181;
    wp::uint64* var_182;
    const wp::int32 var_183 = 30;
    wp::int32 var_184;
    wp::uint64 var_185;
    wp::int32 var_186;
    wp::int32 var_187;
    //---------
    // forward
    // def triangles_near(leaf: wp.uint64, ray: Ray, reach: wp.float32, edge: wp.float32) -> wp.int32:       <L 80>
    // edge = greater(edge, _LEAST_EDGE * (1.0 + wp.abs(ray.origin_along)))                   <L 95>
    var_2 = &((var_ray).origin_along);
    var_4 = wp::load(var_2);
    var_3 = wp::abs(var_4);
    var_5 = wp::add(var_1, var_3);
    var_6 = wp::mul(var_0, var_5);
    var_7 = greater_0(var_edge, var_6);
    // reach_along = lesser(reach, _FURTHEST) * wp.abs(ray.share_along)                       <L 96>
    var_9 = lesser_0(var_reach, var_8);
    var_10 = &((var_ray).share_along);
    var_12 = wp::load(var_10);
    var_11 = wp::abs(var_12);
    var_13 = wp::mul(var_9, var_11);
    // backwards = (wp.cast(ray.share_along, wp.int32) ^ _SIGN) & _SIGN                       <L 97>
    var_14 = &((var_ray).share_along);
    var_16 = wp::load(var_14);
    var_15 = wp::cast<wp::int32>(var_16);
    var_18 = wp::bit_xor(var_15, var_17);
    var_19 = wp::bit_and(var_18, var_17);
    // twelve_e = 12.0 * edge                                                                 <L 98>
    var_21 = wp::mul(var_20, var_7);
    // eight_e_e = 8.0 * edge * edge                                                          <L 99>
    var_23 = wp::mul(var_22, var_7);
    var_24 = wp::mul(var_23, var_7);
    // least = _LEAST * edge                                                                  <L 100>
    var_26 = wp::mul(var_25, var_7);
    // first = wp.array(ptr=leaf + ray.first, shape=(_LEAF_FLOATS,), dtype=wp.float32)        <L 101>
    var_27 = &((var_ray).first);
    var_29 = wp::load(var_27);
    var_28 = wp::add(var_leaf, var_29);
    var_31 = wp::tuple(var_30);
    var_32 = wp::array_t<wp::float32>(var_28, var_33);
    // second = wp.array(ptr=leaf + ray.second, shape=(_LEAF_FLOATS,), dtype=wp.float32)       <L 102>
    var_34 = &((var_ray).second);
    var_36 = wp::load(var_34);
    var_35 = wp::add(var_leaf, var_36);
    var_37 = wp::tuple(var_30);
    var_38 = wp::array_t<wp::float32>(var_35, var_39);
    // along = wp.array(ptr=leaf + ray.along, shape=(_LEAF_FLOATS,), dtype=wp.float32)        <L 103>
    var_40 = &((var_ray).along);
    var_42 = wp::load(var_40);
    var_41 = wp::add(var_leaf, var_42);
    var_43 = wp::tuple(var_30);
    var_44 = wp::array_t<wp::float32>(var_41, var_45);
    // met = wp.zeros(shape=(WIDTH,), dtype=wp.int32)                                         <L 104>
    var_47 = wp::tuple(var_46);
    var_48 = wp::fixedarray_t<16, wp::int32>(var_49);
    // k = wp.int32(0)                                                                        <L 105>
    var_51 = wp::int32(var_50);
    // while k < WIDTH:                                                                       <L 106>
    start_while_0:;
    var_52 = (var_51 < var_46);
    if ((var_52) == false) goto end_while_0;
        // az = ray.origin_along - along[k]                                                   <L 108>
        var_53 = &((var_ray).origin_along);
        var_54 = wp::address(var_44, var_51);
        var_56 = wp::load(var_53);
        var_57 = wp::load(var_54);
        var_55 = wp::sub(var_56, var_57);
        // bz = ray.origin_along - along[_SECOND + k]                                         <L 109>
        var_58 = &((var_ray).origin_along);
        var_60 = wp::add(var_59, var_51);
        var_61 = wp::address(var_44, var_60);
        var_63 = wp::load(var_58);
        var_64 = wp::load(var_61);
        var_62 = wp::sub(var_63, var_64);
        // cz = ray.origin_along - along[_THIRD + k]                                          <L 110>
        var_65 = &((var_ray).origin_along);
        var_67 = wp::add(var_66, var_51);
        var_68 = wp::address(var_44, var_67);
        var_70 = wp::load(var_65);
        var_71 = wp::load(var_68);
        var_69 = wp::sub(var_70, var_71);
        // ax = fma(ray.shear_first, az, ray.origin_first - first[k])                         <L 111>
        var_72 = &((var_ray).shear_first);
        var_73 = &((var_ray).origin_first);
        var_74 = wp::address(var_32, var_51);
        var_76 = wp::load(var_73);
        var_77 = wp::load(var_74);
        var_75 = wp::sub(var_76, var_77);
        var_79 = wp::load(var_72);
        var_78 = fma_0(var_79, var_55, var_75);
        // bx = fma(ray.shear_first, bz, ray.origin_first - first[_SECOND + k])               <L 112>
        var_80 = &((var_ray).shear_first);
        var_81 = &((var_ray).origin_first);
        var_82 = wp::add(var_59, var_51);
        var_83 = wp::address(var_32, var_82);
        var_85 = wp::load(var_81);
        var_86 = wp::load(var_83);
        var_84 = wp::sub(var_85, var_86);
        var_88 = wp::load(var_80);
        var_87 = fma_0(var_88, var_62, var_84);
        // cx = fma(ray.shear_first, cz, ray.origin_first - first[_THIRD + k])                <L 113>
        var_89 = &((var_ray).shear_first);
        var_90 = &((var_ray).origin_first);
        var_91 = wp::add(var_66, var_51);
        var_92 = wp::address(var_32, var_91);
        var_94 = wp::load(var_90);
        var_95 = wp::load(var_92);
        var_93 = wp::sub(var_94, var_95);
        var_97 = wp::load(var_89);
        var_96 = fma_0(var_97, var_69, var_93);
        // ay = fma(ray.shear_second, az, ray.origin_second - second[k])                      <L 114>
        var_98 = &((var_ray).shear_second);
        var_99 = &((var_ray).origin_second);
        var_100 = wp::address(var_38, var_51);
        var_102 = wp::load(var_99);
        var_103 = wp::load(var_100);
        var_101 = wp::sub(var_102, var_103);
        var_105 = wp::load(var_98);
        var_104 = fma_0(var_105, var_55, var_101);
        // by = fma(ray.shear_second, bz, ray.origin_second - second[_SECOND + k])            <L 115>
        var_106 = &((var_ray).shear_second);
        var_107 = &((var_ray).origin_second);
        var_108 = wp::add(var_59, var_51);
        var_109 = wp::address(var_38, var_108);
        var_111 = wp::load(var_107);
        var_112 = wp::load(var_109);
        var_110 = wp::sub(var_111, var_112);
        var_114 = wp::load(var_106);
        var_113 = fma_0(var_114, var_62, var_110);
        // cy = fma(ray.shear_second, cz, ray.origin_second - second[_THIRD + k])             <L 116>
        var_115 = &((var_ray).shear_second);
        var_116 = &((var_ray).origin_second);
        var_117 = wp::add(var_66, var_51);
        var_118 = wp::address(var_38, var_117);
        var_120 = wp::load(var_116);
        var_121 = wp::load(var_118);
        var_119 = wp::sub(var_120, var_121);
        var_123 = wp::load(var_115);
        var_122 = fma_0(var_123, var_69, var_119);
        // u = fma(cx, by, negative(cy * bx))                                                 <L 117>
        var_124 = wp::mul(var_122, var_87);
        var_125 = negative_0(var_124);
        var_126 = fma_0(var_96, var_113, var_125);
        // v = fma(ax, cy, negative(ay * cx))                                                 <L 118>
        var_127 = wp::mul(var_104, var_96);
        var_128 = negative_0(var_127);
        var_129 = fma_0(var_78, var_122, var_128);
        // w = fma(bx, ay, negative(by * ax))                                                 <L 119>
        var_130 = wp::mul(var_113, var_78);
        var_131 = negative_0(var_130);
        var_132 = fma_0(var_87, var_104, var_131);
        // sum = u + v + w                                                                    <L 120>
        var_133 = wp::add(var_126, var_129);
        var_134 = wp::add(var_133, var_132);
        // inside = greater(lesser(lesser(u, v), w), negative(greater(greater(u, v), w)))  # depth inside; below 0 outside       <L 121>
        var_135 = lesser_0(var_126, var_129);
        var_136 = lesser_0(var_135, var_132);
        var_137 = greater_0(var_126, var_129);
        var_138 = greater_0(var_137, var_132);
        var_139 = negative_0(var_138);
        var_140 = greater_0(var_136, var_139);
        // weighted = fma(u, az, fma(v, bz, w * cz))                                          <L 122>
        var_141 = wp::mul(var_132, var_69);
        var_142 = fma_0(var_129, var_62, var_141);
        var_143 = fma_0(var_126, var_55, var_142);
        // t = _flip_sign(weighted, (wp.cast(sum, wp.int32) & _SIGN) ^ backwards)             <L 123>
        var_144 = wp::cast<wp::int32>(var_134);
        var_145 = wp::bit_and(var_144, var_17);
        var_146 = wp::bit_xor(var_145, var_19);
        var_147 = _flip_sign_0(var_143, var_146);
        // before = lesser(t, fma(reach_along, wp.abs(sum), negative(t)))  # margin ahead of the origin and before reach       <L 124>
        var_148 = wp::abs(var_134);
        var_149 = negative_0(var_147);
        var_150 = fma_0(var_13, var_148, var_149);
        var_151 = lesser_0(var_147, var_150);
        // six_r = fma(6.0, wp.abs(az), twelve_e)                                             <L 125>
        var_153 = wp::abs(var_55);
        var_154 = fma_0(var_152, var_153, var_21);
        // margin = (least * six_r) * six_r                                                   <L 126>
        var_155 = wp::mul(var_26, var_154);
        var_156 = wp::mul(var_155, var_154);
        // within = lesser(six_r * inside, before)                                            <L 127>
        var_157 = wp::mul(var_154, var_140);
        var_158 = lesser_0(var_157, var_151);
        // sure = wp.where(within > margin + margin, _SURELY, 0) & wp.where(fma(ax, ax, ay * ay) <= eight_e_e, _SURELY, 0)       <L 128>
        var_159 = wp::add(var_156, var_156);
        var_160 = (var_158 > var_159);
        var_163 = wp::where(var_160, var_161, var_162);
        var_164 = wp::mul(var_104, var_104);
        var_165 = fma_0(var_78, var_78, var_164);
        var_166 = (var_165 <= var_24);
        var_168 = wp::where(var_166, var_161, var_167);
        var_169 = wp::bit_and(var_163, var_168);
        // met[k] = wp.where(within >= negative(margin), _MAYBE, 0) | sure                    <L 129>
        var_170 = negative_0(var_156);
        var_171 = (var_158 >= var_170);
        var_174 = wp::where(var_171, var_172, var_173);
        var_175 = wp::bit_or(var_174, var_169);
        wp::array_store(var_48, var_51, var_175);
        // k += 1                                                                             <L 130>
        var_177 = wp::add(var_51, var_176);
        wp::assign(var_51, var_177);
    goto start_while_0;
    end_while_0:;
    // return lanes_with(met.ptr, 31) | (lanes_with(met.ptr, 30) << WIDTH)                    <L 131>
    var_178 = (wp::uint64*)&(var_48.data);
    var_181 = wp::load(var_178);
    var_180 = lanes_with_0(var_181, var_179);
    var_182 = (wp::uint64*)&(var_48.data);
    var_185 = wp::load(var_182);
    var_184 = lanes_with_0(var_185, var_183);
    var_186 = wp::lshift(var_184, var_46);
    var_187 = wp::bit_or(var_180, var_186);
    return var_187;
}


// /work/main/warpsample/maths/numerics.py:244
static wp::int32 lowest_bit_0(
    wp::int32 var_mask)
{
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int32 var_1;
    const wp::int32 var_2 = 1;
    wp::int32 var_3;
    wp::int32 var_4;
    //---------
    // forward
    // def lowest_bit(mask: wp.int32) -> wp.int32:                                            <L 245>
    // return wp.bit_count((mask & (-mask)) - 1)                                              <L 247>
    var_0 = wp::neg(var_mask);
    var_1 = wp::bit_and(var_mask, var_0);
    var_3 = wp::sub(var_1, var_2);
    var_4 = wp::bit_count(var_3);
    return var_4;
}


// /work/main/warpsample/tracing/wide/triangle.py:58
static wp::float64 _direction_0(
    Ray_728362d1 var_ray,
    wp::uint64 var_row)
{
    //---------
    // primal vars
    wp::uint64* var_0;
    wp::uint64* var_1;
    wp::uint64 var_2;
    wp::uint64 var_3;
    wp::uint64 var_4;
    wp::uint64 var_5;
    const wp::int32 var_6 = 0;
    wp::float32 var_7;
    wp::float64 var_8;
    //---------
    // forward
    // def _direction(ray: Ray, row: wp.uint64) -> wp.float64:                                <L 59>
    // return wp.float64(float_at(ray.direction + row * ray.rows_of_leaf, 0))                 <L 61>
    var_0 = &((var_ray).direction);
    var_1 = &((var_ray).rows_of_leaf);
    var_3 = wp::load(var_1);
    var_2 = wp::mul(var_row, var_3);
    var_5 = wp::load(var_0);
    var_4 = wp::add(var_5, var_2);
    var_7 = _reader__locals__read_0(var_4, var_6);
    var_8 = wp::float64(var_7);
    return var_8;
}


// /work/main/warpsample/tracing/wide/triangle.py:64
static wp::float32 plane_distance_0(
    wp::uint64 var_leaf,
    wp::int32 var_k,
    Ray_728362d1 var_ray)
{
    //---------
    // primal vars
    wp::uint64* var_0;
    wp::uint64 var_1;
    wp::uint64 var_2;
    const wp::int32 var_3 = 144;
    wp::tuple_t<wp::int32> var_4;
    wp::array_t<wp::float32> var_5;
    const wp::int32 var_6 = 144;
    wp::uint64* var_7;
    wp::uint64 var_8;
    wp::uint64 var_9;
    wp::tuple_t<wp::int32> var_10;
    wp::array_t<wp::float32> var_11;
    const wp::int32 var_12 = 144;
    wp::uint64* var_13;
    wp::uint64 var_14;
    wp::uint64 var_15;
    wp::tuple_t<wp::int32> var_16;
    wp::array_t<wp::float32> var_17;
    const wp::int32 var_18 = 144;
    wp::float32* var_19;
    wp::float64 var_20;
    wp::float32 var_21;
    wp::float32* var_22;
    wp::float64 var_23;
    wp::float32 var_24;
    wp::float32* var_25;
    wp::float64 var_26;
    wp::float32 var_27;
    const wp::int32 var_28 = 48;
    wp::int32 var_29;
    wp::float32* var_30;
    wp::float64 var_31;
    wp::float32 var_32;
    wp::int32 var_33;
    wp::float32* var_34;
    wp::float64 var_35;
    wp::float32 var_36;
    wp::int32 var_37;
    wp::float32* var_38;
    wp::float64 var_39;
    wp::float32 var_40;
    const wp::int32 var_41 = 96;
    wp::int32 var_42;
    wp::float32* var_43;
    wp::float64 var_44;
    wp::float32 var_45;
    wp::int32 var_46;
    wp::float32* var_47;
    wp::float64 var_48;
    wp::float32 var_49;
    wp::int32 var_50;
    wp::float32* var_51;
    wp::float64 var_52;
    wp::float32 var_53;
    wp::float64 var_54;
    wp::float64 var_55;
    wp::float64 var_56;
    wp::float64 var_57;
    wp::float64 var_58;
    wp::float64 var_59;
    wp::float64 var_60;
    wp::float64 var_61;
    wp::float64 var_62;
    wp::float64 var_63;
    wp::float64 var_64;
    wp::float64 var_65;
    wp::float64 var_66;
    wp::float64 var_67;
    wp::float64 var_68;
    wp::float64 var_69;
    wp::float64 var_70;
    wp::float64 var_71;
    wp::float64 var_72;
    wp::float64 var_73;
    wp::float64 var_74;
    wp::float32* var_75;
    wp::float64 var_76;
    wp::float32 var_77;
    wp::float64 var_78;
    wp::float32* var_79;
    wp::float64 var_80;
    wp::float32 var_81;
    wp::float64 var_82;
    wp::float32* var_83;
    wp::float64 var_84;
    wp::float32 var_85;
    wp::float64 var_86;
    wp::uint64* var_87;
    wp::float64 var_88;
    wp::uint64 var_89;
    wp::float64 var_90;
    wp::uint64* var_91;
    wp::float64 var_92;
    wp::uint64 var_93;
    wp::float64 var_94;
    wp::float64 var_95;
    wp::uint64* var_96;
    wp::float64 var_97;
    wp::uint64 var_98;
    wp::float64 var_99;
    wp::float64 var_100;
    wp::float64 var_101;
    wp::float64 var_102;
    wp::float64 var_103;
    wp::float64 var_104;
    wp::float64 var_105;
    wp::float64 var_106;
    wp::float32 var_107;
    //---------
    // forward
    // def plane_distance(leaf: wp.uint64, k: wp.int32, ray: Ray) -> wp.float32:              <L 65>
    // first = wp.array(ptr=leaf + ray.first, shape=(_LEAF_FLOATS,), dtype=wp.float32)        <L 67>
    var_0 = &((var_ray).first);
    var_2 = wp::load(var_0);
    var_1 = wp::add(var_leaf, var_2);
    var_4 = wp::tuple(var_3);
    var_5 = wp::array_t<wp::float32>(var_1, var_6);
    // second = wp.array(ptr=leaf + ray.second, shape=(_LEAF_FLOATS,), dtype=wp.float32)       <L 68>
    var_7 = &((var_ray).second);
    var_9 = wp::load(var_7);
    var_8 = wp::add(var_leaf, var_9);
    var_10 = wp::tuple(var_3);
    var_11 = wp::array_t<wp::float32>(var_8, var_12);
    // along = wp.array(ptr=leaf + ray.along, shape=(_LEAF_FLOATS,), dtype=wp.float32)        <L 69>
    var_13 = &((var_ray).along);
    var_15 = wp::load(var_13);
    var_14 = wp::add(var_leaf, var_15);
    var_16 = wp::tuple(var_3);
    var_17 = wp::array_t<wp::float32>(var_14, var_18);
    // ax = wp.float64(first[k])                                                              <L 70>
    var_19 = wp::address(var_5, var_k);
    var_21 = wp::load(var_19);
    var_20 = wp::float64(var_21);
    // ay = wp.float64(second[k])                                                             <L 71>
    var_22 = wp::address(var_11, var_k);
    var_24 = wp::load(var_22);
    var_23 = wp::float64(var_24);
    // az = wp.float64(along[k])                                                              <L 72>
    var_25 = wp::address(var_17, var_k);
    var_27 = wp::load(var_25);
    var_26 = wp::float64(var_27);
    // bx = wp.float64(first[_SECOND + k])                                                    <L 73>
    var_29 = wp::add(var_28, var_k);
    var_30 = wp::address(var_5, var_29);
    var_32 = wp::load(var_30);
    var_31 = wp::float64(var_32);
    // by = wp.float64(second[_SECOND + k])                                                   <L 74>
    var_33 = wp::add(var_28, var_k);
    var_34 = wp::address(var_11, var_33);
    var_36 = wp::load(var_34);
    var_35 = wp::float64(var_36);
    // bz = wp.float64(along[_SECOND + k])                                                    <L 75>
    var_37 = wp::add(var_28, var_k);
    var_38 = wp::address(var_17, var_37);
    var_40 = wp::load(var_38);
    var_39 = wp::float64(var_40);
    // cx = wp.float64(first[_THIRD + k])                                                     <L 76>
    var_42 = wp::add(var_41, var_k);
    var_43 = wp::address(var_5, var_42);
    var_45 = wp::load(var_43);
    var_44 = wp::float64(var_45);
    // cy = wp.float64(second[_THIRD + k])                                                    <L 77>
    var_46 = wp::add(var_41, var_k);
    var_47 = wp::address(var_11, var_46);
    var_49 = wp::load(var_47);
    var_48 = wp::float64(var_49);
    // cz = wp.float64(along[_THIRD + k])                                                     <L 78>
    var_50 = wp::add(var_41, var_k);
    var_51 = wp::address(var_17, var_50);
    var_53 = wp::load(var_51);
    var_52 = wp::float64(var_53);
    // nx = (by - ay) * (cz - az) - (bz - az) * (cy - ay)                                     <L 79>
    var_54 = wp::sub(var_35, var_23);
    var_55 = wp::sub(var_52, var_26);
    var_56 = wp::mul(var_54, var_55);
    var_57 = wp::sub(var_39, var_26);
    var_58 = wp::sub(var_48, var_23);
    var_59 = wp::mul(var_57, var_58);
    var_60 = wp::sub(var_56, var_59);
    // ny = (bz - az) * (cx - ax) - (bx - ax) * (cz - az)                                     <L 80>
    var_61 = wp::sub(var_39, var_26);
    var_62 = wp::sub(var_44, var_20);
    var_63 = wp::mul(var_61, var_62);
    var_64 = wp::sub(var_31, var_20);
    var_65 = wp::sub(var_52, var_26);
    var_66 = wp::mul(var_64, var_65);
    var_67 = wp::sub(var_63, var_66);
    // nz = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)                                     <L 81>
    var_68 = wp::sub(var_31, var_20);
    var_69 = wp::sub(var_48, var_23);
    var_70 = wp::mul(var_68, var_69);
    var_71 = wp::sub(var_35, var_23);
    var_72 = wp::sub(var_44, var_20);
    var_73 = wp::mul(var_71, var_72);
    var_74 = wp::sub(var_70, var_73);
    // x = ax - wp.float64(ray.origin_first)                                                  <L 82>
    var_75 = &((var_ray).origin_first);
    var_77 = wp::load(var_75);
    var_76 = wp::float64(var_77);
    var_78 = wp::sub(var_20, var_76);
    // y = ay - wp.float64(ray.origin_second)                                                 <L 83>
    var_79 = &((var_ray).origin_second);
    var_81 = wp::load(var_79);
    var_80 = wp::float64(var_81);
    var_82 = wp::sub(var_23, var_80);
    // z = az - wp.float64(ray.origin_along)                                                  <L 84>
    var_83 = &((var_ray).origin_along);
    var_85 = wp::load(var_83);
    var_84 = wp::float64(var_85);
    var_86 = wp::sub(var_26, var_84);
    // slope = nx * _direction(ray, ray.first) + ny * _direction(ray, ray.second) + nz * _direction(ray, ray.along)       <L 85>
    var_87 = &((var_ray).first);
    var_89 = wp::load(var_87);
    var_88 = _direction_0(var_ray, var_89);
    var_90 = wp::mul(var_60, var_88);
    var_91 = &((var_ray).second);
    var_93 = wp::load(var_91);
    var_92 = _direction_0(var_ray, var_93);
    var_94 = wp::mul(var_67, var_92);
    var_95 = wp::add(var_90, var_94);
    var_96 = &((var_ray).along);
    var_98 = wp::load(var_96);
    var_97 = _direction_0(var_ray, var_98);
    var_99 = wp::mul(var_74, var_97);
    var_100 = wp::add(var_95, var_99);
    // return wp.float32((nx * x + ny * y + nz * z) / slope)                                  <L 86>
    var_101 = wp::mul(var_60, var_78);
    var_102 = wp::mul(var_67, var_82);
    var_103 = wp::add(var_101, var_102);
    var_104 = wp::mul(var_74, var_86);
    var_105 = wp::add(var_103, var_104);
    var_106 = wp::div(var_105, var_100);
    var_107 = wp::float32(var_106);
    return var_107;
}


// /work/main/warpsample/tracing/wide/triangle.py:15
static bool _is_inside_0(
    wp::float64 var_ax,
    wp::float64 var_ay,
    wp::float64 var_bx,
    wp::float64 var_by,
    wp::float64 var_cx,
    wp::float64 var_cy)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::float64 var_1;
    wp::float64 var_2;
    wp::float64 var_3;
    wp::float64 var_4;
    wp::float64 var_5;
    wp::float64 var_6;
    wp::float64 var_7;
    wp::float64 var_8;
    bool var_9;
    bool var_10;
    const wp::float64 var_11 = 0.0;
    bool var_12;
    bool var_13;
    bool var_14;
    bool var_15;
    bool var_16;
    bool var_17;
    bool var_18;
    //---------
    // forward
    // def _is_inside(ax: wp.float64, ay: wp.float64, bx: wp.float64, by: wp.float64, cx: wp.float64, cy: wp.float64) -> wp.bool:       <L 16>
    // u = cx * by - cy * bx                                                                  <L 18>
    var_0 = wp::mul(var_cx, var_by);
    var_1 = wp::mul(var_cy, var_bx);
    var_2 = wp::sub(var_0, var_1);
    // v = ax * cy - ay * cx                                                                  <L 19>
    var_3 = wp::mul(var_ax, var_cy);
    var_4 = wp::mul(var_ay, var_cx);
    var_5 = wp::sub(var_3, var_4);
    // w = bx * ay - by * ax                                                                  <L 20>
    var_6 = wp::mul(var_bx, var_ay);
    var_7 = wp::mul(var_by, var_ax);
    var_8 = wp::sub(var_6, var_7);
    // return (u >= ZERO and v >= ZERO and w >= ZERO) or (u <= ZERO and v <= ZERO and w <= ZERO)       <L 21>
    var_12 = (var_2 >= var_11);
    var_10 = var_12;
    if (var_10) {
        var_13 = (var_5 >= var_11);
        var_10 = var_10 && var_13;
    }
    if (var_10) {
        var_14 = (var_8 >= var_11);
        var_10 = var_10 && var_14;
    }
    var_9 = var_10;
    if (!var_9) {
        var_16 = (var_2 <= var_11);
        var_15 = var_16;
        if (var_15) {
            var_17 = (var_5 <= var_11);
            var_15 = var_15 && var_17;
        }
        if (var_15) {
            var_18 = (var_8 <= var_11);
            var_15 = var_15 && var_18;
        }
        var_9 = var_9 || var_15;
    }
    return var_9;
}


// /work/main/warpsample/tracing/wide/triangle.py:102
static bool _build_edge_test__locals__between_0(
    wp::uint64 var_leaf,
    wp::int32 var_k,
    Ray_728362d1 var_ray)
{
    //---------
    // primal vars
    wp::uint64* var_0;
    wp::uint64 var_1;
    wp::uint64 var_2;
    const wp::int32 var_3 = 144;
    wp::tuple_t<wp::int32> var_4;
    wp::array_t<wp::float32> var_5;
    const wp::int32 var_6 = 144;
    wp::uint64* var_7;
    wp::uint64 var_8;
    wp::uint64 var_9;
    wp::tuple_t<wp::int32> var_10;
    wp::array_t<wp::float32> var_11;
    const wp::int32 var_12 = 144;
    wp::uint64* var_13;
    wp::uint64 var_14;
    wp::uint64 var_15;
    wp::tuple_t<wp::int32> var_16;
    wp::array_t<wp::float32> var_17;
    const wp::int32 var_18 = 144;
    wp::uint64* var_19;
    wp::float64 var_20;
    wp::uint64 var_21;
    wp::uint64* var_22;
    wp::float64 var_23;
    wp::uint64 var_24;
    wp::uint64* var_25;
    wp::float64 var_26;
    wp::uint64 var_27;
    wp::float32* var_28;
    wp::float64 var_29;
    wp::float32 var_30;
    wp::float32* var_31;
    wp::float64 var_32;
    wp::float32 var_33;
    wp::float32* var_34;
    wp::float64 var_35;
    wp::float32 var_36;
    wp::float32* var_37;
    wp::float64 var_38;
    wp::float32 var_39;
    wp::float64 var_40;
    const wp::int32 var_41 = 48;
    wp::int32 var_42;
    wp::float32* var_43;
    wp::float64 var_44;
    wp::float32 var_45;
    wp::float64 var_46;
    const wp::int32 var_47 = 96;
    wp::int32 var_48;
    wp::float32* var_49;
    wp::float64 var_50;
    wp::float32 var_51;
    wp::float64 var_52;
    wp::float32* var_53;
    wp::float64 var_54;
    wp::float32 var_55;
    wp::float64 var_56;
    wp::float64 var_57;
    wp::float64 var_58;
    wp::float64 var_59;
    wp::float32* var_60;
    wp::float64 var_61;
    wp::float32 var_62;
    wp::float64 var_63;
    wp::float64 var_64;
    wp::float64 var_65;
    wp::float64 var_66;
    wp::int32 var_67;
    wp::float32* var_68;
    wp::float64 var_69;
    wp::float32 var_70;
    wp::float64 var_71;
    wp::float64 var_72;
    wp::float64 var_73;
    wp::float64 var_74;
    wp::int32 var_75;
    wp::float32* var_76;
    wp::float64 var_77;
    wp::float32 var_78;
    wp::float64 var_79;
    wp::float64 var_80;
    wp::float64 var_81;
    wp::float64 var_82;
    wp::int32 var_83;
    wp::float32* var_84;
    wp::float64 var_85;
    wp::float32 var_86;
    wp::float64 var_87;
    wp::float64 var_88;
    wp::float64 var_89;
    wp::float64 var_90;
    wp::int32 var_91;
    wp::float32* var_92;
    wp::float64 var_93;
    wp::float32 var_94;
    wp::float64 var_95;
    wp::float64 var_96;
    wp::float64 var_97;
    wp::float64 var_98;
    bool var_99;
    //---------
    // forward
    // def between(leaf: wp.uint64, k: wp.int32, ray: Ray) -> wp.bool:                        <L 103>
    // first = wp.array(ptr=leaf + ray.first, shape=(_LEAF_FLOATS,), dtype=wp.float32)        <L 104>
    var_0 = &((var_ray).first);
    var_2 = wp::load(var_0);
    var_1 = wp::add(var_leaf, var_2);
    var_4 = wp::tuple(var_3);
    var_5 = wp::array_t<wp::float32>(var_1, var_6);
    // second = wp.array(ptr=leaf + ray.second, shape=(_LEAF_FLOATS,), dtype=wp.float32)       <L 105>
    var_7 = &((var_ray).second);
    var_9 = wp::load(var_7);
    var_8 = wp::add(var_leaf, var_9);
    var_10 = wp::tuple(var_3);
    var_11 = wp::array_t<wp::float32>(var_8, var_12);
    // along = wp.array(ptr=leaf + ray.along, shape=(_LEAF_FLOATS,), dtype=wp.float32)        <L 106>
    var_13 = &((var_ray).along);
    var_15 = wp::load(var_13);
    var_14 = wp::add(var_leaf, var_15);
    var_16 = wp::tuple(var_3);
    var_17 = wp::array_t<wp::float32>(var_14, var_18);
    // d_first = _direction(ray, ray.first)                                                   <L 107>
    var_19 = &((var_ray).first);
    var_21 = wp::load(var_19);
    var_20 = _direction_0(var_ray, var_21);
    // d_second = _direction(ray, ray.second)                                                 <L 108>
    var_22 = &((var_ray).second);
    var_24 = wp::load(var_22);
    var_23 = _direction_0(var_ray, var_24);
    // d_along = _direction(ray, ray.along)                                                   <L 109>
    var_25 = &((var_ray).along);
    var_27 = wp::load(var_25);
    var_26 = _direction_0(var_ray, var_27);
    // ox = wp.float64(ray.origin_first)                                                      <L 110>
    var_28 = &((var_ray).origin_first);
    var_30 = wp::load(var_28);
    var_29 = wp::float64(var_30);
    // oy = wp.float64(ray.origin_second)                                                     <L 111>
    var_31 = &((var_ray).origin_second);
    var_33 = wp::load(var_31);
    var_32 = wp::float64(var_33);
    // oz = wp.float64(ray.origin_along)                                                      <L 112>
    var_34 = &((var_ray).origin_along);
    var_36 = wp::load(var_34);
    var_35 = wp::float64(var_36);
    // az = wp.float64(along[k]) - oz                                                         <L 113>
    var_37 = wp::address(var_17, var_k);
    var_39 = wp::load(var_37);
    var_38 = wp::float64(var_39);
    var_40 = wp::sub(var_38, var_35);
    // bz = wp.float64(along[_SECOND + k]) - oz                                               <L 114>
    var_42 = wp::add(var_41, var_k);
    var_43 = wp::address(var_17, var_42);
    var_45 = wp::load(var_43);
    var_44 = wp::float64(var_45);
    var_46 = wp::sub(var_44, var_35);
    // cz = wp.float64(along[_THIRD + k]) - oz                                                <L 115>
    var_48 = wp::add(var_47, var_k);
    var_49 = wp::address(var_17, var_48);
    var_51 = wp::load(var_49);
    var_50 = wp::float64(var_51);
    var_52 = wp::sub(var_50, var_35);
    // return inside(                                                                         <L 116>
    // (wp.float64(first[k]) - ox) * d_along - az * d_first,                                  <L 117>
    var_53 = wp::address(var_5, var_k);
    var_55 = wp::load(var_53);
    var_54 = wp::float64(var_55);
    var_56 = wp::sub(var_54, var_29);
    var_57 = wp::mul(var_56, var_26);
    var_58 = wp::mul(var_40, var_20);
    var_59 = wp::sub(var_57, var_58);
    // (wp.float64(second[k]) - oy) * d_along - az * d_second,                                <L 118>
    var_60 = wp::address(var_11, var_k);
    var_62 = wp::load(var_60);
    var_61 = wp::float64(var_62);
    var_63 = wp::sub(var_61, var_32);
    var_64 = wp::mul(var_63, var_26);
    var_65 = wp::mul(var_40, var_23);
    var_66 = wp::sub(var_64, var_65);
    // (wp.float64(first[_SECOND + k]) - ox) * d_along - bz * d_first,                        <L 119>
    var_67 = wp::add(var_41, var_k);
    var_68 = wp::address(var_5, var_67);
    var_70 = wp::load(var_68);
    var_69 = wp::float64(var_70);
    var_71 = wp::sub(var_69, var_29);
    var_72 = wp::mul(var_71, var_26);
    var_73 = wp::mul(var_46, var_20);
    var_74 = wp::sub(var_72, var_73);
    // (wp.float64(second[_SECOND + k]) - oy) * d_along - bz * d_second,                      <L 120>
    var_75 = wp::add(var_41, var_k);
    var_76 = wp::address(var_11, var_75);
    var_78 = wp::load(var_76);
    var_77 = wp::float64(var_78);
    var_79 = wp::sub(var_77, var_32);
    var_80 = wp::mul(var_79, var_26);
    var_81 = wp::mul(var_46, var_23);
    var_82 = wp::sub(var_80, var_81);
    // (wp.float64(first[_THIRD + k]) - ox) * d_along - cz * d_first,                         <L 121>
    var_83 = wp::add(var_47, var_k);
    var_84 = wp::address(var_5, var_83);
    var_86 = wp::load(var_84);
    var_85 = wp::float64(var_86);
    var_87 = wp::sub(var_85, var_29);
    var_88 = wp::mul(var_87, var_26);
    var_89 = wp::mul(var_52, var_20);
    var_90 = wp::sub(var_88, var_89);
    // (wp.float64(second[_THIRD + k]) - oy) * d_along - cz * d_second,                       <L 122>
    var_91 = wp::add(var_47, var_k);
    var_92 = wp::address(var_11, var_91);
    var_94 = wp::load(var_92);
    var_93 = wp::float64(var_94);
    var_95 = wp::sub(var_93, var_32);
    var_96 = wp::mul(var_95, var_26);
    var_97 = wp::mul(var_52, var_23);
    var_98 = wp::sub(var_96, var_97);
    var_99 = _is_inside_0(var_59, var_66, var_74, var_82, var_90, var_98);
    return var_99;
}


// /work/main/warpsample/tracing/wide/query.py:18
static void nearest_triangle_0(
    wp::uint64 var_leaf,
    wp::int32 var_lanes,
    Ray_728362d1 var_ray,
    wp::float32 var_reach,
    wp::float32 var_edge,
    wp::float32 & ret_0,
    wp::int32 & ret_1)
{
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int32 var_1;
    const wp::int32 var_2 = -1;
    wp::int32 var_3;
    wp::int32 var_4;
    wp::range_t var_5;
    wp::int32 var_6;
    wp::int32 var_7;
    const wp::int32 var_8 = 1;
    wp::int32 var_9;
    wp::int32 var_10;
    wp::float32 var_11;
    const wp::float32 var_12 = 0.0;
    bool var_13;
    const wp::int32 var_14 = 1;
    const wp::int32 var_15 = 0;
    wp::int32 var_16;
    bool var_17;
    const wp::int32 var_18 = 1;
    const wp::int32 var_19 = 0;
    wp::int32 var_20;
    wp::int32 var_21;
    const wp::int32 var_22 = 16;
    wp::int32 var_23;
    wp::int32 var_24;
    wp::int32 var_25;
    wp::int32 var_26;
    const wp::int32 var_27 = 0;
    bool var_28;
    bool var_29;
    const wp::int32 var_30 = 1;
    const wp::int32 var_31 = 0;
    wp::int32 var_32;
    wp::int32 var_33;
    const wp::int32 var_34 = 0;
    bool var_35;
    wp::float32 var_36;
    const wp::int32 var_37 = 0;
    bool var_38;
    wp::int32 var_39;
    //---------
    // forward
    // def nearest_triangle(leaf: wp.uint64, lanes: wp.int32, ray: Ray, reach: wp.float32, edge: wp.float32):       <L 19>
    // found = triangles_near(leaf, ray, reach, edge)                                         <L 24>
    var_0 = triangles_near_0(var_leaf, var_ray, var_reach, var_edge);
    // met = found & lanes                                                                    <L 25>
    var_1 = wp::bit_and(var_0, var_lanes);
    // nearest = wp.int32(-1)                                                                 <L 26>
    var_3 = wp::int32(var_2);
    // for _ in range(wp.bit_count(met)):                                                     <L 27>
    var_4 = wp::bit_count(var_1);
    var_5 = wp::range(var_4);
    start_for_0:;
        if (iter_cmp(var_5) == 0) goto end_for_0;
        var_6 = wp::iter_next(var_5);
        // triangle = lowest_bit(met)                                                         <L 28>
        var_7 = lowest_bit_0(var_1);
        // met = met & (met - 1)                                                              <L 29>
        var_9 = wp::sub(var_1, var_8);
        var_10 = wp::bit_and(var_1, var_9);
        // distance = plane_distance(leaf, triangle, ray)                                     <L 30>
        var_11 = plane_distance_0(var_leaf, var_7, var_ray);
        // nearer = wp.where(distance > 0.0, 1, 0) & wp.where(distance < reach, 1, 0)         <L 33>
        var_13 = (var_11 > var_12);
        var_16 = wp::where(var_13, var_14, var_15);
        var_17 = (var_11 < var_reach);
        var_20 = wp::where(var_17, var_18, var_19);
        var_21 = wp::bit_and(var_16, var_20);
        // if (nearer & ~(found >> (WIDTH + triangle))) != 0:                                 <L 34>
        var_23 = wp::add(var_22, var_7);
        var_24 = wp::rshift(var_0, var_23);
        var_25 = wp::invert(var_24);
        var_26 = wp::bit_and(var_21, var_25);
        var_28 = (var_26 != var_27);
        if (var_28) {
            // nearer = wp.where(is_between_edges(leaf, triangle, ray), 1, 0)                 <L 35>
            var_29 = _build_edge_test__locals__between_0(var_leaf, var_7, var_ray);
            var_32 = wp::where(var_29, var_30, var_31);
        }
        var_33 = wp::where(var_28, var_32, var_21);
        // reach = wp.where(nearer != 0, distance, reach)                                     <L 36>
        var_35 = (var_33 != var_34);
        var_36 = wp::where(var_35, var_11, var_reach);
        // nearest = wp.where(nearer != 0, triangle, nearest)                                 <L 37>
        var_38 = (var_33 != var_37);
        var_39 = wp::where(var_38, var_7, var_3);
        wp::assign(var_reach, var_36);
        wp::assign(var_1, var_10);
        wp::assign(var_3, var_39);
        goto start_for_0;
    end_for_0:;
    // return reach, nearest                                                                  <L 38>
    ret_0 = var_reach;
    ret_1 = var_3;
    return;
}


// /work/main/warpsample/tracing/wide/layout.py:38
static wp::uint64 node_at_0(
    Accelerator_9fc73cd7 var_accelerator,
    wp::int32 var_i)
{
    //---------
    // primal vars
    wp::uint64* var_0;
    wp::uint64 var_1;
    wp::uint64 var_2;
    wp::uint64 var_3;
    wp::uint64 var_4;
    wp::uint64 var_5;
    //---------
    // forward
    // def node_at(accelerator: Accelerator, i: wp.int32) -> wp.uint64:                       <L 39>
    // return accelerator.nodes + wp.uint64(i) * wp.uint64(NODE_BYTES)                        <L 41>
    var_0 = &((var_accelerator).nodes);
    var_1 = wp::uint64(var_i);
    var_2 = 512ull;
    var_3 = wp::mul(var_1, var_2);
    var_5 = wp::load(var_0);
    var_4 = wp::add(var_5, var_3);
    return var_4;
}


// /work/main/warpsample/maths/memory.py:0
static void _writer__locals__write_2(
    wp::uint64 var_address,
    wp::int32 var_i,
    wp::uint64 var_x)
{
    //---------
    // primal vars
    wp::uint64 var_0;
    wp::uint64 var_1;
    wp::uint64 var_2;
    wp::uint64 var_3;
    const wp::int32 var_4 = 1;
    wp::tuple_t<wp::int32> var_5;
    wp::array_t<wp::uint64> var_6;
    const wp::int32 var_7 = 1;
    const wp::int32 var_8 = 0;
    //---------
    // forward
    // def write(address: wp.uint64, i: Any, x: kind):                                        <L 1>
    // view = wp.array(ptr=address + wp.uint64(i) * wp.uint64(size), shape=(1,), dtype=kind)       <L 2>
    var_0 = wp::uint64(var_i);
    var_1 = 8ull;
    var_2 = wp::mul(var_0, var_1);
    var_3 = wp::add(var_address, var_2);
    var_5 = wp::tuple(var_4);
    var_6 = wp::array_t<wp::uint64>(var_3, var_7);
    // view[0] = x                                                                            <L 3>
    wp::array_store(var_6, var_8, var_x);
}


// /work/main/warpsample/maths/memory.py:0
static void _writer__locals__write_1(
    wp::uint64 var_address,
    wp::int32 var_i,
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


// /work/main/warpsample/tracing/wide/walk.py:19
static wp::uint64 push_node_0(
    wp::uint64 var_top,
    wp::uint64 var_node,
    wp::int32 var_mask,
    wp::float32 var_reach)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    const wp::int32 var_1 = 2;
    const wp::int32 var_2 = 3;
    const wp::uint64 var_3 = 16ull;
    wp::uint64 var_4;
    //---------
    // forward
    // def push_node(top: wp.uint64, node: wp.uint64, mask: wp.int32, reach: wp.float32) -> wp.uint64:       <L 20>
    // set_address(top, 0, node)                                                              <L 22>
    _writer__locals__write_2(var_top, var_0, var_node);
    // set_int(top, 2, mask)                                                                  <L 23>
    _writer__locals__write_1(var_top, var_1, var_mask);
    // set_float(top, 3, reach)                                                               <L 24>
    _writer__locals__write_0(var_top, var_2, var_reach);
    // return top + STACK_ENTRY                                                               <L 25>
    var_4 = wp::add(var_top, var_3);
    return var_4;
}


// /work/main/warpsample/maths/memory.py:0
static wp::uint64 _reader__locals__read_3(
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
    wp::array_t<wp::uint64> var_6;
    const wp::int32 var_7 = 1;
    const wp::int32 var_8 = 0;
    wp::uint64* var_9;
    wp::uint64 var_10;
    wp::uint64 var_11;
    //---------
    // forward
    // def read(address: wp.uint64, i: Any):                                                  <L 1>
    // return wp.array(ptr=address + wp.uint64(i) * wp.uint64(size), shape=(1,), dtype=kind)[0]       <L 2>
    var_0 = wp::uint64(var_i);
    var_1 = 8ull;
    var_2 = wp::mul(var_0, var_1);
    var_3 = wp::add(var_address, var_2);
    var_5 = wp::tuple(var_4);
    var_6 = wp::array_t<wp::uint64>(var_3, var_7);
    var_9 = wp::address(var_6, var_8);
    var_11 = wp::load(var_9);
    var_10 = wp::copy(var_11);
    return var_10;
}


// /work/main/warpsample/tracing/wide/query.py:78
static void _pop_node_0(
    Ray_728362d1 var_ray,
    wp::float32 var_reach,
    wp::uint64 var_top,
    wp::uint64 var_bottom,
    wp::uint64 & ret_0,
    wp::int32 & ret_1,
    wp::uint64 & ret_2)
{
    //---------
    // primal vars
    wp::uint64 var_0;
    const wp::int32 var_1 = 0;
    wp::int32 var_2;
    bool var_3;
    const wp::int32 var_4 = 0;
    bool var_5;
    bool var_6;
    const wp::uint64 var_7 = 16ull;
    wp::uint64 var_8;
    const wp::int32 var_9 = 0;
    wp::uint64 var_10;
    const wp::int32 var_11 = 2;
    wp::int32 var_12;
    const wp::int32 var_13 = 3;
    wp::int32 var_14;
    wp::int32 var_15;
    bool var_16;
    const wp::int32 var_17 = 0;
    wp::int32 var_18;
    wp::int32 var_19;
    wp::int32 var_20;
    wp::int32 var_21;
    //---------
    // forward
    // def _pop_node(ray: Ray, reach: wp.float32, top: wp.uint64, bottom: wp.uint64):         <L 79>
    // node = wp.uint64(0)                                                                    <L 84>
    var_0 = 0ull;
    // mask = wp.int32(0)                                                                     <L 85>
    var_2 = wp::int32(var_1);
    // while mask == 0 and top != bottom:                                                     <L 86>
    start_while_0:;
    var_5 = (var_2 == var_4);
    var_3 = var_5;
    if (var_3) {
        var_6 = (var_top != var_bottom);
        var_3 = var_3 && var_6;
    }
    if ((var_3) == false) goto end_while_0;
        // top -= STACK_ENTRY                                                                 <L 87>
        var_8 = wp::sub(var_top, var_7);
        // node = address_at(top, 0)                                                          <L 88>
        var_10 = _reader__locals__read_3(var_8, var_9);
        // mask = int_at(top, 2)                                                              <L 89>
        var_12 = _reader__locals__read_1(var_8, var_11);
        // if int_at(top, 3) != wp.cast(reach, wp.int32):                                     <L 90>
        var_14 = _reader__locals__read_1(var_8, var_13);
        var_15 = wp::cast<wp::int32>(var_reach);
        var_16 = (var_14 != var_15);
        if (var_16) {
            // still, _ = boxes_hit(node, ray, reach, 0)                                      <L 91>
            boxes_hit_0(var_10, var_ray, var_reach, var_17, var_18, var_19);
            // mask = mask & still                                                            <L 92>
            var_20 = wp::bit_and(var_12, var_18);
        }
        var_21 = wp::where(var_16, var_20, var_12);
        wp::assign(var_top, var_8);
        wp::assign(var_0, var_10);
        wp::assign(var_2, var_21);
    goto start_while_0;
    end_while_0:;
    // return node, mask, top                                                                 <L 93>
    ret_0 = var_0;
    ret_1 = var_2;
    ret_2 = var_top;
    return;
}


// /work/main/warpsample/tracing/wide/layout.py:62
static wp::int32 face_in_0(
    wp::uint64 var_leaf,
    wp::int32 var_k)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 144;
    wp::int32 var_1;
    wp::int32 var_2;
    //---------
    // forward
    // def face_in(leaf: wp.uint64, k: wp.int32) -> wp.int32:                                 <L 63>
    // return int_at(leaf, FACES + k)                                                         <L 65>
    var_1 = wp::add(var_0, var_k);
    var_2 = _reader__locals__read_1(var_leaf, var_1);
    return var_2;
}


// /work/main/warpsample/tracing/wide/query.py:61
static void _nearest_answer_0(
    wp::uint64 var_leaf,
    wp::int32 var_triangle,
    Ray_728362d1 var_ray,
    wp::float32 var_reach,
    wp::float32 & ret_0,
    wp::int32 & ret_1)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    bool var_1;
    const wp::float32 var_2 = INFINITY;
    const wp::float32 var_3 = INFINITY;
    wp::float32 var_4;
    const wp::int32 var_5 = -1;
    wp::int32 var_6;
    wp::int32 var_7;
    //---------
    // forward
    // def _nearest_answer(leaf: wp.uint64, triangle: wp.int32, ray: Ray, reach: wp.float32):  # noqa: ARG001  (signature shared)       <L 62>
    // if triangle < 0:                                                                       <L 64>
    var_1 = (var_triangle < var_0);
    if (var_1) {
        // return wp.float32(wp.INF), wp.int32(-1)                                            <L 65>
        var_4 = wp::float32(var_3);
        var_6 = wp::int32(var_5);
        ret_0 = var_4;
        ret_1 = var_6;
        return;
    }
    // return reach, face_in(leaf, triangle)                                                  <L 66>
    var_7 = face_in_0(var_leaf, var_triangle);
    ret_0 = var_reach;
    ret_1 = var_7;
    return;
}


// /work/main/warpsample/tracing/wide/query.py:133
static void wide_walk__locals__walk_0(
    Accelerator_9fc73cd7 var_accelerator,
    Ray_728362d1 var_ray,
    wp::float32 var_reach,
    wp::uint64 var_scratch,
    wp::float32 & ret_0,
    wp::int32 & ret_1,
    wp::int32 & ret_2,
    wp::int32 & ret_3)
{
    //---------
    // primal vars
    const wp::int32 var_0 = -1;
    wp::int32 var_1;
    wp::uint64 var_2;
    const wp::int32 var_3 = 1;
    wp::int32 var_4;
    const wp::int32 var_5 = 0;
    wp::int32 var_6;
    const wp::int32 var_7 = 0;
    wp::uint64 var_8;
    wp::int32 var_9;
    wp::int32 var_10;
    wp::uint64 var_11;
    const wp::int32 var_12 = 0;
    bool var_13;
    const wp::int32 var_14 = 1;
    wp::int32 var_15;
    wp::int32 var_16;
    wp::int32 var_17;
    wp::int32 var_18;
    const wp::int32 var_19 = 0;
    wp::int32 var_20;
    const wp::int32 var_21 = 0;
    bool var_22;
    const wp::int32 var_23 = 1;
    wp::int32 var_24;
    wp::int32 var_25;
    wp::uint64 var_26;
    wp::float32 var_27;
    const wp::int32 var_28 = 65535;
    wp::float32 var_29;
    wp::int32 var_30;
    const wp::int32 var_31 = 0;
    bool var_32;
    wp::int32 var_33;
    wp::uint64 var_34;
    const bool var_35 = false;
    const wp::int32 var_36 = 0;
    bool var_37;
    wp::int32 var_38;
    wp::int32 var_39;
    wp::int32 var_40;
    wp::int32 var_41;
    wp::int32 var_42;
    wp::int32 var_43;
    wp::uint64 var_44;
    wp::int32 var_45;
    wp::int32 var_46;
    const wp::int32 var_47 = 1;
    wp::int32 var_48;
    wp::uint64 var_49;
    wp::int32 var_50;
    wp::int32 var_51;
    const wp::int32 var_52 = 0;
    bool var_53;
    const wp::int32 var_54 = 0;
    bool var_55;
    wp::uint64 var_56;
    wp::uint64 var_57;
    wp::uint64 var_58;
    wp::int32 var_59;
    wp::uint64 var_60;
    wp::int32 var_61;
    wp::uint64 var_62;
    wp::float32 var_63;
    wp::int32 var_64;
    wp::uint64 var_65;
    wp::int32 var_66;
    wp::int32 var_67;
    wp::uint64 var_68;
    wp::int32 var_69;
    wp::int32 var_70;
    wp::uint64 var_71;
    wp::int32 var_72;
    const wp::int32 var_73 = 0;
    bool var_74;
    const wp::int32 var_75 = 0;
    bool var_76;
    wp::uint64 var_77;
    wp::int32 var_78;
    wp::uint64 var_79;
    wp::uint64 var_80;
    wp::int32 var_81;
    wp::uint64 var_82;
    wp::int32 var_83;
    wp::uint64 var_84;
    wp::int32 var_85;
    wp::int32 var_86;
    wp::uint64 var_87;
    wp::float32 var_88;
    wp::int32 var_89;
    //---------
    // forward
    // def walk(accelerator: Accelerator, ray: Ray, reach: wp.float32, scratch: wp.uint64):       <L 134>
    // hit = wp.int32(-1)                                                                     <L 135>
    var_1 = wp::int32(var_0);
    // hit_leaf = wp.uint64(0)                                                                <L 136>
    var_2 = 0ull;
    // visited = wp.int32(1)                                                                  <L 137>
    var_4 = wp::int32(var_3);
    // visited_leaves = wp.int32(0)                                                           <L 138>
    var_6 = wp::int32(var_5);
    // node, mask, child, top = begin(accelerator, ray, reach, flip, scratch)                 <L 139>
    _start_at_one_0(var_accelerator, var_ray, var_reach, var_7, var_scratch, var_8, var_9, var_10, var_11);
    // while mask != 0:                                                                       <L 140>
    start_while_0:;
    var_13 = (var_9 != var_12);
    if ((var_13) == false) goto end_while_0;
        // mask = mask & (~(1 << child))                                                      <L 141>
        var_15 = wp::lshift(var_14, var_10);
        var_16 = wp::invert(var_15);
        var_17 = wp::bit_and(var_9, var_16);
        // link = link_in(node, child)                                                        <L 142>
        var_18 = link_in_0(var_8, var_10);
        // below = wp.int32(0)                                                                <L 143>
        var_20 = wp::int32(var_19);
        // if link < 0:                                                                       <L 144>
        var_22 = (var_18 < var_21);
        if (var_22) {
            // visited_leaves += 1                                                            <L 145>
            var_24 = wp::add(var_6, var_23);
            // leaf = leaf_at(accelerator, ~link)                                             <L 146>
            var_25 = wp::invert(var_18);
            var_26 = leaf_at_0(var_accelerator, var_25);
            // edge = edge_in(node, child)                                                    <L 147>
            var_27 = edge_in_0(var_8, var_10);
            // reach, triangle = look_into(leaf, _ALL, ray, reach, edge)                      <L 148>
            nearest_triangle_0(var_26, var_28, var_ray, var_reach, var_27, var_29, var_30);
            // if triangle >= 0:                                                              <L 149>
            var_32 = (var_30 >= var_31);
            if (var_32) {
                // hit = triangle                                                             <L 150>
                var_33 = wp::copy(var_30);
                // hit_leaf = leaf                                                            <L 151>
                var_34 = wp::copy(var_26);
                // if any_hit:                                                                <L 152>
                // if mask != 0:                                                              <L 155>
                var_37 = (var_17 != var_36);
                if (var_37) {
                    // still, child = boxes_hit(node, ray, reach, flip)                       <L 156>
                    boxes_hit_0(var_8, var_ray, var_29, var_7, var_38, var_39);
                    // mask = mask & still                                                    <L 157>
                    var_40 = wp::bit_and(var_17, var_38);
                }
                var_41 = wp::where(var_37, var_40, var_17);
                var_42 = wp::where(var_37, var_39, var_10);
            }
            var_43 = wp::where(var_32, var_33, var_1);
            var_44 = wp::where(var_32, var_34, var_2);
            var_45 = wp::where(var_32, var_41, var_17);
            var_46 = wp::where(var_32, var_42, var_10);
        }
        if (!var_22) {
            // visited += 1                                                                   <L 159>
            var_48 = wp::add(var_4, var_47);
            // inner = node_at(accelerator, link)                                             <L 160>
            var_49 = node_at_0(var_accelerator, var_18);
            // below, child = boxes_hit(inner, ray, reach, flip)                              <L 161>
            boxes_hit_0(var_49, var_ray, var_reach, var_7, var_50, var_51);
            // if below != 0:                                                                 <L 162>
            var_53 = (var_50 != var_52);
            if (var_53) {
                // if mask != 0:                                                              <L 163>
                var_55 = (var_17 != var_54);
                if (var_55) {
                    // top = push_node(top, node, mask, reach)                                <L 164>
                    var_56 = push_node_0(var_11, var_8, var_17, var_reach);
                }
                var_57 = wp::where(var_55, var_56, var_11);
                // node = inner                                                               <L 165>
                var_58 = wp::copy(var_49);
                // mask = below                                                               <L 166>
                var_59 = wp::copy(var_50);
            }
            var_60 = wp::where(var_53, var_58, var_8);
            var_61 = wp::where(var_53, var_59, var_17);
            var_62 = wp::where(var_53, var_57, var_11);
        }
        var_63 = wp::where(var_22, var_29, var_reach);
        var_64 = wp::where(var_22, var_43, var_1);
        var_65 = wp::where(var_22, var_44, var_2);
        var_66 = wp::where(var_22, var_4, var_48);
        var_67 = wp::where(var_22, var_24, var_6);
        var_68 = wp::where(var_22, var_8, var_60);
        var_69 = wp::where(var_22, var_45, var_61);
        var_70 = wp::where(var_22, var_46, var_51);
        var_71 = wp::where(var_22, var_11, var_62);
        var_72 = wp::where(var_22, var_20, var_50);
        // if below == 0:                                                                     <L 167>
        var_74 = (var_72 == var_73);
        if (var_74) {
            // if mask == 0:                                                                  <L 168>
            var_76 = (var_69 == var_75);
            if (var_76) {
                // node, mask, top = _pop_node(ray, reach, top, scratch)                      <L 169>
                _pop_node_0(var_ray, var_63, var_71, var_scratch, var_77, var_78, var_79);
            }
            var_80 = wp::where(var_76, var_77, var_68);
            var_81 = wp::where(var_76, var_78, var_69);
            var_82 = wp::where(var_76, var_79, var_71);
            // child = lowest_bit(mask)                                                       <L 170>
            var_83 = lowest_bit_0(var_81);
        }
        var_84 = wp::where(var_74, var_80, var_68);
        var_85 = wp::where(var_74, var_81, var_69);
        var_86 = wp::where(var_74, var_83, var_70);
        var_87 = wp::where(var_74, var_82, var_71);
        wp::assign(var_reach, var_63);
        wp::assign(var_1, var_64);
        wp::assign(var_2, var_65);
        wp::assign(var_4, var_66);
        wp::assign(var_6, var_67);
        wp::assign(var_8, var_84);
        wp::assign(var_9, var_85);
        wp::assign(var_10, var_86);
        wp::assign(var_11, var_87);
    goto start_while_0;
    end_while_0:;
    // nearest, face = answer(hit_leaf, hit, ray, reach)                                      <L 171>
    _nearest_answer_0(var_2, var_1, var_ray, var_reach, var_88, var_89);
    // return nearest, face, visited, visited_leaves                                          <L 172>
    ret_0 = var_88;
    ret_1 = var_89;
    ret_2 = var_4;
    ret_3 = var_6;
    return;
}


// /work/main/warpsample/tracing/wide/query.py:182
static void wide_query__locals__wide_query_0(
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
    Ray_728362d1 var_0;
    wp::float32 var_1;
    wp::int32 var_2;
    wp::int32 var_3;
    wp::int32 var_4;
    //---------
    // forward
    // def wide_query(accelerator: Accelerator, column: wp.uint64, reach: wp.float32, scratch: wp.uint64):       <L 183>
    // return walk(accelerator, ray_in(column), reach, scratch)                               <L 184>
    var_0 = ray_in_0(var_column);
    wide_walk__locals__walk_0(var_accelerator, var_0, var_reach, var_scratch, var_1, var_2, var_3, var_4);
    ret_0 = var_1;
    ret_1 = var_2;
    ret_2 = var_3;
    ret_3 = var_4;
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
static void build_hit_writer__locals__write_hit_0(
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
        wide_query__locals__wide_query_0(var_accelerator, var_column, var_6, var_scratch, var_9, var_10, var_11, var_12);
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


// /work/main/warpsample/tracing/wide/prepare.py:63
static void adj__nonzero_0(
    wp::float32 var_d,
    wp::float32 & adj_d,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/maths/numerics.py:232
static void adj_greater_0(
    wp::float32 var_a,
    wp::float32 var_b,
    wp::float32 & adj_a,
    wp::float32 & adj_b,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/wide/prepare.py:69
static void adj_prepare_ray_0(
    wp::vec_t<3, wp::float32> var_o,
    wp::vec_t<3, wp::float32> var_d,
    wp::vec_t<3, wp::float32> & adj_o,
    wp::vec_t<3, wp::float32> & adj_d,
    PreparedRay_54268e28 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/wide/prepare.py:111
static void adj_prepare_wide_0(
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


// /work/main/warpsample/tracing/wide/prepare.py:142
static void adj__ray_0(
    PreparedRay_54268e28 var_p,
    wp::uint64 var_direction,
    wp::uint64 var_rows_of_leaf,
    PreparedRay_54268e28 & adj_p,
    wp::uint64 & adj_direction,
    wp::uint64 & adj_rows_of_leaf,
    Ray_728362d1 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/wide/prepare.py:169
static void adj_ray_in_0(
    wp::uint64 var_column,
    wp::uint64 & adj_column,
    Ray_728362d1 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/wide/candidates.py:25
static void adj_entry_distance_0(
    wp::uint64 var_node,
    Ray_728362d1 var_ray,
    wp::int32 var_k,
    wp::uint64 & adj_node,
    Ray_728362d1 & adj_ray,
    wp::int32 & adj_k,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/maths/numerics.py:226
static void adj_lesser_0(
    wp::float32 var_a,
    wp::float32 var_b,
    wp::float32 & adj_a,
    wp::float32 & adj_b,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/wide/candidates.py:37
static void adj_exit_distance_0(
    wp::uint64 var_node,
    Ray_728362d1 var_ray,
    wp::float32 var_reach,
    wp::int32 var_k,
    wp::uint64 & adj_node,
    Ray_728362d1 & adj_ray,
    wp::float32 & adj_reach,
    wp::int32 & adj_k,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/wide/lanes.py:6
static CUDA_CALLABLE void adj_lanes_with_0(
    wp::uint64 row,
    wp::int32 bit,
    wp::uint64 & adj_row,
    wp::int32 & adj_bit,
    wp::int32 & adj_ret)
{
}


// /work/main/warpsample/tracing/wide/candidates.py:52
static void adj_boxes_hit_0(
    wp::uint64 var_node,
    Ray_728362d1 var_ray,
    wp::float32 var_reach,
    wp::int32 var_flip,
    wp::int32 & ret_0,
    wp::int32 & ret_1,
    wp::uint64 & adj_node,
    Ray_728362d1 & adj_ray,
    wp::float32 & adj_reach,
    wp::int32 & adj_flip,
    wp::int32 & adj_ret_0,
    wp::int32 & adj_ret_1)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/wide/query.py:96
static void adj__start_at_one_0(
    Accelerator_9fc73cd7 var_accelerator,
    Ray_728362d1 var_ray,
    wp::float32 var_reach,
    wp::int32 var_flip,
    wp::uint64 var_scratch,
    wp::uint64 & ret_0,
    wp::int32 & ret_1,
    wp::int32 & ret_2,
    wp::uint64 & ret_3,
    Accelerator_9fc73cd7 & adj_accelerator,
    Ray_728362d1 & adj_ray,
    wp::float32 & adj_reach,
    wp::int32 & adj_flip,
    wp::uint64 & adj_scratch,
    wp::uint64 & adj_ret_0,
    wp::int32 & adj_ret_1,
    wp::int32 & adj_ret_2,
    wp::uint64 & adj_ret_3)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/wide/layout.py:50
static void adj_link_in_0(
    wp::uint64 var_node,
    wp::int32 var_k,
    wp::uint64 & adj_node,
    wp::int32 & adj_k,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/wide/layout.py:44
static void adj_leaf_at_0(
    Accelerator_9fc73cd7 var_accelerator,
    wp::int32 var_i,
    Accelerator_9fc73cd7 & adj_accelerator,
    wp::int32 & adj_i,
    wp::uint64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/wide/layout.py:56
static void adj_edge_in_0(
    wp::uint64 var_node,
    wp::int32 var_k,
    wp::uint64 & adj_node,
    wp::int32 & adj_k,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/maths/numerics.py:238
static void adj_negative_0(
    wp::float32 var_x,
    wp::float32 & adj_x,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/wide/candidates.py:73
static void adj__flip_sign_0(
    wp::float32 var_x,
    wp::int32 var_sign,
    wp::float32 & adj_x,
    wp::int32 & adj_sign,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/wide/candidates.py:79
static void adj_triangles_near_0(
    wp::uint64 var_leaf,
    Ray_728362d1 var_ray,
    wp::float32 var_reach,
    wp::float32 var_edge,
    wp::uint64 & adj_leaf,
    Ray_728362d1 & adj_ray,
    wp::float32 & adj_reach,
    wp::float32 & adj_edge,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/maths/numerics.py:244
static void adj_lowest_bit_0(
    wp::int32 var_mask,
    wp::int32 & adj_mask,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/wide/triangle.py:58
static void adj__direction_0(
    Ray_728362d1 var_ray,
    wp::uint64 var_row,
    Ray_728362d1 & adj_ray,
    wp::uint64 & adj_row,
    wp::float64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/wide/triangle.py:64
static void adj_plane_distance_0(
    wp::uint64 var_leaf,
    wp::int32 var_k,
    Ray_728362d1 var_ray,
    wp::uint64 & adj_leaf,
    wp::int32 & adj_k,
    Ray_728362d1 & adj_ray,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/wide/triangle.py:15
static void adj__is_inside_0(
    wp::float64 var_ax,
    wp::float64 var_ay,
    wp::float64 var_bx,
    wp::float64 var_by,
    wp::float64 var_cx,
    wp::float64 var_cy,
    wp::float64 & adj_ax,
    wp::float64 & adj_ay,
    wp::float64 & adj_bx,
    wp::float64 & adj_by,
    wp::float64 & adj_cx,
    wp::float64 & adj_cy,
    bool & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/wide/triangle.py:102
static void adj__build_edge_test__locals__between_0(
    wp::uint64 var_leaf,
    wp::int32 var_k,
    Ray_728362d1 var_ray,
    wp::uint64 & adj_leaf,
    wp::int32 & adj_k,
    Ray_728362d1 & adj_ray,
    bool & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/wide/query.py:18
static void adj_nearest_triangle_0(
    wp::uint64 var_leaf,
    wp::int32 var_lanes,
    Ray_728362d1 var_ray,
    wp::float32 var_reach,
    wp::float32 var_edge,
    wp::float32 & ret_0,
    wp::int32 & ret_1,
    wp::uint64 & adj_leaf,
    wp::int32 & adj_lanes,
    Ray_728362d1 & adj_ray,
    wp::float32 & adj_reach,
    wp::float32 & adj_edge,
    wp::float32 & adj_ret_0,
    wp::int32 & adj_ret_1)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/wide/layout.py:38
static void adj_node_at_0(
    Accelerator_9fc73cd7 var_accelerator,
    wp::int32 var_i,
    Accelerator_9fc73cd7 & adj_accelerator,
    wp::int32 & adj_i,
    wp::uint64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/maths/memory.py:0
static void adj__writer__locals__write_2(
    wp::uint64 var_address,
    wp::int32 var_i,
    wp::uint64 var_x,
    wp::uint64 & adj_address,
    wp::int32 & adj_i,
    wp::uint64 & adj_x)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/maths/memory.py:0
static void adj__writer__locals__write_1(
    wp::uint64 var_address,
    wp::int32 var_i,
    wp::int32 var_x,
    wp::uint64 & adj_address,
    wp::int32 & adj_i,
    wp::int32 & adj_x)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/wide/walk.py:19
static void adj_push_node_0(
    wp::uint64 var_top,
    wp::uint64 var_node,
    wp::int32 var_mask,
    wp::float32 var_reach,
    wp::uint64 & adj_top,
    wp::uint64 & adj_node,
    wp::int32 & adj_mask,
    wp::float32 & adj_reach,
    wp::uint64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/maths/memory.py:0
static void adj__reader__locals__read_3(
    wp::uint64 var_address,
    wp::int32 var_i,
    wp::uint64 & adj_address,
    wp::int32 & adj_i,
    wp::uint64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/wide/query.py:78
static void adj__pop_node_0(
    Ray_728362d1 var_ray,
    wp::float32 var_reach,
    wp::uint64 var_top,
    wp::uint64 var_bottom,
    wp::uint64 & ret_0,
    wp::int32 & ret_1,
    wp::uint64 & ret_2,
    Ray_728362d1 & adj_ray,
    wp::float32 & adj_reach,
    wp::uint64 & adj_top,
    wp::uint64 & adj_bottom,
    wp::uint64 & adj_ret_0,
    wp::int32 & adj_ret_1,
    wp::uint64 & adj_ret_2)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/wide/layout.py:62
static void adj_face_in_0(
    wp::uint64 var_leaf,
    wp::int32 var_k,
    wp::uint64 & adj_leaf,
    wp::int32 & adj_k,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/wide/query.py:61
static void adj__nearest_answer_0(
    wp::uint64 var_leaf,
    wp::int32 var_triangle,
    Ray_728362d1 var_ray,
    wp::float32 var_reach,
    wp::float32 & ret_0,
    wp::int32 & ret_1,
    wp::uint64 & adj_leaf,
    wp::int32 & adj_triangle,
    Ray_728362d1 & adj_ray,
    wp::float32 & adj_reach,
    wp::float32 & adj_ret_0,
    wp::int32 & adj_ret_1)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/wide/query.py:133
static void adj_wide_walk__locals__walk_0(
    Accelerator_9fc73cd7 var_accelerator,
    Ray_728362d1 var_ray,
    wp::float32 var_reach,
    wp::uint64 var_scratch,
    wp::float32 & ret_0,
    wp::int32 & ret_1,
    wp::int32 & ret_2,
    wp::int32 & ret_3,
    Accelerator_9fc73cd7 & adj_accelerator,
    Ray_728362d1 & adj_ray,
    wp::float32 & adj_reach,
    wp::uint64 & adj_scratch,
    wp::float32 & adj_ret_0,
    wp::int32 & adj_ret_1,
    wp::int32 & adj_ret_2,
    wp::int32 & adj_ret_3)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/wide/query.py:182
static void adj_wide_query__locals__wide_query_0(
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
static void adj_build_hit_writer__locals__write_hit_0(
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

struct wp_args_ray_kernel__locals__each_ray_cb3a4015 {
    Rays_3ba80fd7 rays;
    Accelerator_9fc73cd7 accelerator;
    wp::int64 first_task;
};


template <bool wp_linear_contiguous>
static void ray_kernel__locals__each_ray_cb3a4015_cpu_kernel_forward(
    wp::launch_bounds_t<1> dim,
    size_t task_index,
    wp_args_ray_kernel__locals__each_ray_cb3a4015 *_wp_args)
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
    const wp::int32 var_4 = 1664;
    wp::tuple_t<wp::int32> var_5;
    wp::fixedarray_t<1664, wp::float32> var_6;
    const wp::int32 var_7 = 1664;
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
    var_6 = wp::fixedarray_t<1664, wp::float32>(var_7);
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
    prepare_wide_0(var_76, var_75);
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
        build_hit_writer__locals__write_hit_0(var_rays, var_accelerator, var_107, var_92, var_110);
        wp::assign(var_78, var_101);
        wp::assign(var_83, var_102);
        goto start_for_2;
    end_for_2:;
}



template <bool wp_linear_contiguous>
static WP_FORCEINLINE void ray_kernel__locals__each_ray_cb3a4015_cpu_forward_tasks(
    wp::launch_bounds_t<1> *dim,
    wp_args_ray_kernel__locals__each_ray_cb3a4015 *_wp_args)
{
    for (size_t task_index = 0; task_index < dim->size; ++task_index)
    {
        ray_kernel__locals__each_ray_cb3a4015_cpu_kernel_forward<wp_linear_contiguous>(*dim, task_index, _wp_args);
    }
}

static WP_FORCEINLINE void ray_kernel__locals__each_ray_cb3a4015_cpu_forward_dispatch(
    wp::launch_bounds_t<1> *dim,
    wp_args_ray_kernel__locals__each_ray_cb3a4015 *_wp_args)
{
    wp::tile_shared_storage_t tile_mem;
#if defined(WP_ENABLE_TILES_IN_STACK_MEMORY)
    wp::shared_tile_storage = &tile_mem;
#endif

    ray_kernel__locals__each_ray_cb3a4015_cpu_forward_tasks<false>(dim, _wp_args);
}

extern "C" {

// Python CPU entry points
WP_API void ray_kernel__locals__each_ray_cb3a4015_cpu_forward(
    wp::launch_bounds_t<1> *dim,
    wp_args_ray_kernel__locals__each_ray_cb3a4015 *_wp_args)
{
    ray_kernel__locals__each_ray_cb3a4015_cpu_forward_dispatch(dim, _wp_args);
}

} // extern C

