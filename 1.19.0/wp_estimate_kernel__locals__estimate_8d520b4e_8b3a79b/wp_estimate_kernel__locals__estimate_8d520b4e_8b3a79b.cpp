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


struct ShadingPoint_241c3e67
{
    wp::int64 index;
    wp::int32 status;
    wp::vec_t<4, wp::uint32> key;
    wp::vec_t<3, wp::float32> n;
    wp::vec_t<3, wp::float64> position;
    wp::vec_t<3, wp::float32> o;
    wp::float32 low;
    wp::float32 reach;
    wp::uint64 chunk;
    wp::uint64 own;
    wp::uint64 shaft;
    wp::uint64 opened;
    wp::uint64 scratch;
    wp::uint64 sides;
    wp::uint64 waiting;


    ShadingPoint_241c3e67() = default;
    CUDA_CALLABLE ShadingPoint_241c3e67(wp::int64 const& index,
    wp::int32 const& status = {},
    wp::vec_t<4, wp::uint32> const& key = {},
    wp::vec_t<3, wp::float32> const& n = {},
    wp::vec_t<3, wp::float64> const& position = {},
    wp::vec_t<3, wp::float32> const& o = {},
    wp::float32 const& low = {},
    wp::float32 const& reach = {},
    wp::uint64 const& chunk = {},
    wp::uint64 const& own = {},
    wp::uint64 const& shaft = {},
    wp::uint64 const& opened = {},
    wp::uint64 const& scratch = {},
    wp::uint64 const& sides = {},
    wp::uint64 const& waiting = {})
        : index{index}
        , status{status}
        , key{key}
        , n{n}
        , position{position}
        , o{o}
        , low{low}
        , reach{reach}
        , chunk{chunk}
        , own{own}
        , shaft{shaft}
        , opened{opened}
        , scratch{scratch}
        , sides{sides}
        , waiting{waiting}

    {
    }

    CUDA_CALLABLE ShadingPoint_241c3e67& operator += (const ShadingPoint_241c3e67& rhs)
    {    index += rhs.index;
    status += rhs.status;
    key += rhs.key;
    n += rhs.n;
    position += rhs.position;
    o += rhs.o;
    low += rhs.low;
    reach += rhs.reach;
    chunk += rhs.chunk;
    own += rhs.own;
    shaft += rhs.shaft;
    opened += rhs.opened;
    scratch += rhs.scratch;
    sides += rhs.sides;
    waiting += rhs.waiting;

        return *this;}

};

static CUDA_CALLABLE void adj_ShadingPoint_241c3e67(wp::int64 const&,
    wp::int32 const&,
    wp::vec_t<4, wp::uint32> const&,
    wp::vec_t<3, wp::float32> const&,
    wp::vec_t<3, wp::float64> const&,
    wp::vec_t<3, wp::float32> const&,
    wp::float32 const&,
    wp::float32 const&,
    wp::uint64 const&,
    wp::uint64 const&,
    wp::uint64 const&,
    wp::uint64 const&,
    wp::uint64 const&,
    wp::uint64 const&,
    wp::uint64 const&,
    wp::int64 & adj_index,
    wp::int32 & adj_status,
    wp::vec_t<4, wp::uint32> & adj_key,
    wp::vec_t<3, wp::float32> & adj_n,
    wp::vec_t<3, wp::float64> & adj_position,
    wp::vec_t<3, wp::float32> & adj_o,
    wp::float32 & adj_low,
    wp::float32 & adj_reach,
    wp::uint64 & adj_chunk,
    wp::uint64 & adj_own,
    wp::uint64 & adj_shaft,
    wp::uint64 & adj_opened,
    wp::uint64 & adj_scratch,
    wp::uint64 & adj_sides,
    wp::uint64 & adj_waiting,
    ShadingPoint_241c3e67 & adj_ret)
{
    adj_index += adj_ret.index;
    adj_status += adj_ret.status;
    adj_key += adj_ret.key;
    adj_n += adj_ret.n;
    adj_position += adj_ret.position;
    adj_o += adj_ret.o;
    adj_low += adj_ret.low;
    adj_reach += adj_ret.reach;
    adj_chunk += adj_ret.chunk;
    adj_own += adj_ret.own;
    adj_shaft += adj_ret.shaft;
    adj_opened += adj_ret.opened;
    adj_scratch += adj_ret.scratch;
    adj_sides += adj_ret.sides;
    adj_waiting += adj_ret.waiting;
}

// Required when compiling adjoints.
CUDA_CALLABLE ShadingPoint_241c3e67 add(const ShadingPoint_241c3e67& a, const ShadingPoint_241c3e67& b)
{
    return ShadingPoint_241c3e67();
}

CUDA_CALLABLE void adj_atomic_add(ShadingPoint_241c3e67* p, ShadingPoint_241c3e67 t)
{
    wp::adj_atomic_add(&p->index, t.index);
    wp::adj_atomic_add(&p->status, t.status);
    wp::adj_atomic_add(&p->key, t.key);
    wp::adj_atomic_add(&p->n, t.n);
    wp::adj_atomic_add(&p->position, t.position);
    wp::adj_atomic_add(&p->o, t.o);
    wp::adj_atomic_add(&p->low, t.low);
    wp::adj_atomic_add(&p->reach, t.reach);
    wp::adj_atomic_add(&p->chunk, t.chunk);
    wp::adj_atomic_add(&p->own, t.own);
    wp::adj_atomic_add(&p->shaft, t.shaft);
    wp::adj_atomic_add(&p->opened, t.opened);
    wp::adj_atomic_add(&p->scratch, t.scratch);
    wp::adj_atomic_add(&p->sides, t.sides);
    wp::adj_atomic_add(&p->waiting, t.waiting);
}




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




struct InShaft_29ffc368
{
    wp::int32 state;
    wp::uint64 leaf;
    wp::int32 triangles;


    InShaft_29ffc368() = default;
    CUDA_CALLABLE InShaft_29ffc368(wp::int32 const& state,
    wp::uint64 const& leaf = {},
    wp::int32 const& triangles = {})
        : state{state}
        , leaf{leaf}
        , triangles{triangles}

    {
    }

    CUDA_CALLABLE InShaft_29ffc368& operator += (const InShaft_29ffc368& rhs)
    {    state += rhs.state;
    leaf += rhs.leaf;
    triangles += rhs.triangles;

        return *this;}

};

static CUDA_CALLABLE void adj_InShaft_29ffc368(wp::int32 const&,
    wp::uint64 const&,
    wp::int32 const&,
    wp::int32 & adj_state,
    wp::uint64 & adj_leaf,
    wp::int32 & adj_triangles,
    InShaft_29ffc368 & adj_ret)
{
    adj_state += adj_ret.state;
    adj_leaf += adj_ret.leaf;
    adj_triangles += adj_ret.triangles;
}

// Required when compiling adjoints.
CUDA_CALLABLE InShaft_29ffc368 add(const InShaft_29ffc368& a, const InShaft_29ffc368& b)
{
    return InShaft_29ffc368();
}

CUDA_CALLABLE void adj_atomic_add(InShaft_29ffc368* p, InShaft_29ffc368 t)
{
    wp::adj_atomic_add(&p->state, t.state);
    wp::adj_atomic_add(&p->leaf, t.leaf);
    wp::adj_atomic_add(&p->triangles, t.triangles);
}




struct Plane_dba16a08
{
    wp::float32 nx;
    wp::float32 ny;
    wp::float32 nz;
    wp::float32 limit;
    wp::uint64 x_row;
    wp::uint64 y_row;
    wp::uint64 z_row;


    Plane_dba16a08() = default;
    CUDA_CALLABLE Plane_dba16a08(wp::float32 const& nx,
    wp::float32 const& ny = {},
    wp::float32 const& nz = {},
    wp::float32 const& limit = {},
    wp::uint64 const& x_row = {},
    wp::uint64 const& y_row = {},
    wp::uint64 const& z_row = {})
        : nx{nx}
        , ny{ny}
        , nz{nz}
        , limit{limit}
        , x_row{x_row}
        , y_row{y_row}
        , z_row{z_row}

    {
    }

    CUDA_CALLABLE Plane_dba16a08& operator += (const Plane_dba16a08& rhs)
    {    nx += rhs.nx;
    ny += rhs.ny;
    nz += rhs.nz;
    limit += rhs.limit;
    x_row += rhs.x_row;
    y_row += rhs.y_row;
    z_row += rhs.z_row;

        return *this;}

};

static CUDA_CALLABLE void adj_Plane_dba16a08(wp::float32 const&,
    wp::float32 const&,
    wp::float32 const&,
    wp::float32 const&,
    wp::uint64 const&,
    wp::uint64 const&,
    wp::uint64 const&,
    wp::float32 & adj_nx,
    wp::float32 & adj_ny,
    wp::float32 & adj_nz,
    wp::float32 & adj_limit,
    wp::uint64 & adj_x_row,
    wp::uint64 & adj_y_row,
    wp::uint64 & adj_z_row,
    Plane_dba16a08 & adj_ret)
{
    adj_nx += adj_ret.nx;
    adj_ny += adj_ret.ny;
    adj_nz += adj_ret.nz;
    adj_limit += adj_ret.limit;
    adj_x_row += adj_ret.x_row;
    adj_y_row += adj_ret.y_row;
    adj_z_row += adj_ret.z_row;
}

// Required when compiling adjoints.
CUDA_CALLABLE Plane_dba16a08 add(const Plane_dba16a08& a, const Plane_dba16a08& b)
{
    return Plane_dba16a08();
}

CUDA_CALLABLE void adj_atomic_add(Plane_dba16a08* p, Plane_dba16a08 t)
{
    wp::adj_atomic_add(&p->nx, t.nx);
    wp::adj_atomic_add(&p->ny, t.ny);
    wp::adj_atomic_add(&p->nz, t.nz);
    wp::adj_atomic_add(&p->limit, t.limit);
    wp::adj_atomic_add(&p->x_row, t.x_row);
    wp::adj_atomic_add(&p->y_row, t.y_row);
    wp::adj_atomic_add(&p->z_row, t.z_row);
}




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




struct Lobes_4a4eb700
{
    Placement_e6d83c4e placement;
    wp::uint64 seed;
    wp::uint64 first_point;
    wp::int32 first_row;
    wp::int64 visits;
    wp::int32 rows;
    wp::uint64 normals;
    wp::uint64 active;
    wp::int32 samples_per_stratum;
    wp::int32 bands;
    wp::int32 sectors;
    wp::uint64 shafts;
    wp::int32 skip;
    wp::float32 falloff;
    wp::float32 edge;
    Parameters_f3aa772c parameters;
    wp::uint64 value;
    wp::uint64 error;
    wp::uint64 spread;
    wp::uint64 degrees;
    wp::uint64 cast;
    wp::uint64 empty;
    wp::uint64 status;
    Glass_69c17290 glass;


    Lobes_4a4eb700() = default;
    CUDA_CALLABLE Lobes_4a4eb700(Placement_e6d83c4e const& placement,
    wp::uint64 const& seed = {},
    wp::uint64 const& first_point = {},
    wp::int32 const& first_row = {},
    wp::int64 const& visits = {},
    wp::int32 const& rows = {},
    wp::uint64 const& normals = {},
    wp::uint64 const& active = {},
    wp::int32 const& samples_per_stratum = {},
    wp::int32 const& bands = {},
    wp::int32 const& sectors = {},
    wp::uint64 const& shafts = {},
    wp::int32 const& skip = {},
    wp::float32 const& falloff = {},
    wp::float32 const& edge = {},
    Parameters_f3aa772c const& parameters = {},
    wp::uint64 const& value = {},
    wp::uint64 const& error = {},
    wp::uint64 const& spread = {},
    wp::uint64 const& degrees = {},
    wp::uint64 const& cast = {},
    wp::uint64 const& empty = {},
    wp::uint64 const& status = {},
    Glass_69c17290 const& glass = {})
        : placement{placement}
        , seed{seed}
        , first_point{first_point}
        , first_row{first_row}
        , visits{visits}
        , rows{rows}
        , normals{normals}
        , active{active}
        , samples_per_stratum{samples_per_stratum}
        , bands{bands}
        , sectors{sectors}
        , shafts{shafts}
        , skip{skip}
        , falloff{falloff}
        , edge{edge}
        , parameters{parameters}
        , value{value}
        , error{error}
        , spread{spread}
        , degrees{degrees}
        , cast{cast}
        , empty{empty}
        , status{status}
        , glass{glass}

    {
    }

    CUDA_CALLABLE Lobes_4a4eb700& operator += (const Lobes_4a4eb700& rhs)
    {    placement += rhs.placement;
    seed += rhs.seed;
    first_point += rhs.first_point;
    first_row += rhs.first_row;
    visits += rhs.visits;
    rows += rhs.rows;
    normals += rhs.normals;
    active += rhs.active;
    samples_per_stratum += rhs.samples_per_stratum;
    bands += rhs.bands;
    sectors += rhs.sectors;
    shafts += rhs.shafts;
    skip += rhs.skip;
    falloff += rhs.falloff;
    edge += rhs.edge;
    parameters += rhs.parameters;
    value += rhs.value;
    error += rhs.error;
    spread += rhs.spread;
    degrees += rhs.degrees;
    cast += rhs.cast;
    empty += rhs.empty;
    status += rhs.status;
    glass += rhs.glass;

        return *this;}

};

static CUDA_CALLABLE void adj_Lobes_4a4eb700(Placement_e6d83c4e const&,
    wp::uint64 const&,
    wp::uint64 const&,
    wp::int32 const&,
    wp::int64 const&,
    wp::int32 const&,
    wp::uint64 const&,
    wp::uint64 const&,
    wp::int32 const&,
    wp::int32 const&,
    wp::int32 const&,
    wp::uint64 const&,
    wp::int32 const&,
    wp::float32 const&,
    wp::float32 const&,
    Parameters_f3aa772c const&,
    wp::uint64 const&,
    wp::uint64 const&,
    wp::uint64 const&,
    wp::uint64 const&,
    wp::uint64 const&,
    wp::uint64 const&,
    wp::uint64 const&,
    Glass_69c17290 const&,
    Placement_e6d83c4e & adj_placement,
    wp::uint64 & adj_seed,
    wp::uint64 & adj_first_point,
    wp::int32 & adj_first_row,
    wp::int64 & adj_visits,
    wp::int32 & adj_rows,
    wp::uint64 & adj_normals,
    wp::uint64 & adj_active,
    wp::int32 & adj_samples_per_stratum,
    wp::int32 & adj_bands,
    wp::int32 & adj_sectors,
    wp::uint64 & adj_shafts,
    wp::int32 & adj_skip,
    wp::float32 & adj_falloff,
    wp::float32 & adj_edge,
    Parameters_f3aa772c & adj_parameters,
    wp::uint64 & adj_value,
    wp::uint64 & adj_error,
    wp::uint64 & adj_spread,
    wp::uint64 & adj_degrees,
    wp::uint64 & adj_cast,
    wp::uint64 & adj_empty,
    wp::uint64 & adj_status,
    Glass_69c17290 & adj_glass,
    Lobes_4a4eb700 & adj_ret)
{
    adj_placement += adj_ret.placement;
    adj_seed += adj_ret.seed;
    adj_first_point += adj_ret.first_point;
    adj_first_row += adj_ret.first_row;
    adj_visits += adj_ret.visits;
    adj_rows += adj_ret.rows;
    adj_normals += adj_ret.normals;
    adj_active += adj_ret.active;
    adj_samples_per_stratum += adj_ret.samples_per_stratum;
    adj_bands += adj_ret.bands;
    adj_sectors += adj_ret.sectors;
    adj_shafts += adj_ret.shafts;
    adj_skip += adj_ret.skip;
    adj_falloff += adj_ret.falloff;
    adj_edge += adj_ret.edge;
    adj_parameters += adj_ret.parameters;
    adj_value += adj_ret.value;
    adj_error += adj_ret.error;
    adj_spread += adj_ret.spread;
    adj_degrees += adj_ret.degrees;
    adj_cast += adj_ret.cast;
    adj_empty += adj_ret.empty;
    adj_status += adj_ret.status;
    adj_glass += adj_ret.glass;
}

// Required when compiling adjoints.
CUDA_CALLABLE Lobes_4a4eb700 add(const Lobes_4a4eb700& a, const Lobes_4a4eb700& b)
{
    return Lobes_4a4eb700();
}

CUDA_CALLABLE void adj_atomic_add(Lobes_4a4eb700* p, Lobes_4a4eb700 t)
{
    adj_atomic_add(&p->placement, t.placement);
    wp::adj_atomic_add(&p->seed, t.seed);
    wp::adj_atomic_add(&p->first_point, t.first_point);
    wp::adj_atomic_add(&p->first_row, t.first_row);
    wp::adj_atomic_add(&p->visits, t.visits);
    wp::adj_atomic_add(&p->rows, t.rows);
    wp::adj_atomic_add(&p->normals, t.normals);
    wp::adj_atomic_add(&p->active, t.active);
    wp::adj_atomic_add(&p->samples_per_stratum, t.samples_per_stratum);
    wp::adj_atomic_add(&p->bands, t.bands);
    wp::adj_atomic_add(&p->sectors, t.sectors);
    wp::adj_atomic_add(&p->shafts, t.shafts);
    wp::adj_atomic_add(&p->skip, t.skip);
    wp::adj_atomic_add(&p->falloff, t.falloff);
    wp::adj_atomic_add(&p->edge, t.edge);
    adj_atomic_add(&p->parameters, t.parameters);
    wp::adj_atomic_add(&p->value, t.value);
    wp::adj_atomic_add(&p->error, t.error);
    wp::adj_atomic_add(&p->spread, t.spread);
    wp::adj_atomic_add(&p->degrees, t.degrees);
    wp::adj_atomic_add(&p->cast, t.cast);
    wp::adj_atomic_add(&p->empty, t.empty);
    wp::adj_atomic_add(&p->status, t.status);
    adj_atomic_add(&p->glass, t.glass);
}




struct Lobe_95707b65
{
    wp::vec_t<3, wp::float32> normal;
    wp::int32 row;
    wp::uint64 point;


    Lobe_95707b65() = default;
    CUDA_CALLABLE Lobe_95707b65(wp::vec_t<3, wp::float32> const& normal,
    wp::int32 const& row = {},
    wp::uint64 const& point = {})
        : normal{normal}
        , row{row}
        , point{point}

    {
    }

    CUDA_CALLABLE Lobe_95707b65& operator += (const Lobe_95707b65& rhs)
    {    normal += rhs.normal;
    row += rhs.row;
    point += rhs.point;

        return *this;}

};

static CUDA_CALLABLE void adj_Lobe_95707b65(wp::vec_t<3, wp::float32> const&,
    wp::int32 const&,
    wp::uint64 const&,
    wp::vec_t<3, wp::float32> & adj_normal,
    wp::int32 & adj_row,
    wp::uint64 & adj_point,
    Lobe_95707b65 & adj_ret)
{
    adj_normal += adj_ret.normal;
    adj_row += adj_ret.row;
    adj_point += adj_ret.point;
}

// Required when compiling adjoints.
CUDA_CALLABLE Lobe_95707b65 add(const Lobe_95707b65& a, const Lobe_95707b65& b)
{
    return Lobe_95707b65();
}

CUDA_CALLABLE void adj_atomic_add(Lobe_95707b65* p, Lobe_95707b65 t)
{
    wp::adj_atomic_add(&p->normal, t.normal);
    wp::adj_atomic_add(&p->row, t.row);
    wp::adj_atomic_add(&p->point, t.point);
}




struct Weights_23742fab
{
    wp::float32 x;
    wp::float32 y;
    wp::float32 z;
    wp::uint64 pixels;
    wp::int32 width;
    wp::int32 height;


    Weights_23742fab() = default;
    CUDA_CALLABLE Weights_23742fab(wp::float32 const& x,
    wp::float32 const& y = {},
    wp::float32 const& z = {},
    wp::uint64 const& pixels = {},
    wp::int32 const& width = {},
    wp::int32 const& height = {})
        : x{x}
        , y{y}
        , z{z}
        , pixels{pixels}
        , width{width}
        , height{height}

    {
    }

    CUDA_CALLABLE Weights_23742fab& operator += (const Weights_23742fab& rhs)
    {    x += rhs.x;
    y += rhs.y;
    z += rhs.z;
    pixels += rhs.pixels;
    width += rhs.width;
    height += rhs.height;

        return *this;}

};

static CUDA_CALLABLE void adj_Weights_23742fab(wp::float32 const&,
    wp::float32 const&,
    wp::float32 const&,
    wp::uint64 const&,
    wp::int32 const&,
    wp::int32 const&,
    wp::float32 & adj_x,
    wp::float32 & adj_y,
    wp::float32 & adj_z,
    wp::uint64 & adj_pixels,
    wp::int32 & adj_width,
    wp::int32 & adj_height,
    Weights_23742fab & adj_ret)
{
    adj_x += adj_ret.x;
    adj_y += adj_ret.y;
    adj_z += adj_ret.z;
    adj_pixels += adj_ret.pixels;
    adj_width += adj_ret.width;
    adj_height += adj_ret.height;
}

// Required when compiling adjoints.
CUDA_CALLABLE Weights_23742fab add(const Weights_23742fab& a, const Weights_23742fab& b)
{
    return Weights_23742fab();
}

CUDA_CALLABLE void adj_atomic_add(Weights_23742fab* p, Weights_23742fab t)
{
    wp::adj_atomic_add(&p->x, t.x);
    wp::adj_atomic_add(&p->y, t.y);
    wp::adj_atomic_add(&p->z, t.z);
    wp::adj_atomic_add(&p->pixels, t.pixels);
    wp::adj_atomic_add(&p->width, t.width);
    wp::adj_atomic_add(&p->height, t.height);
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




struct Prior_2e82b100
{
    wp::float64 worth;
    wp::float64 unseen;
    wp::float64 worth_if_all_agree;
    wp::float64 unseen_if_all_agree;
    wp::float64 unseen_if_one_differs;


    Prior_2e82b100() = default;
    CUDA_CALLABLE Prior_2e82b100(wp::float64 const& worth,
    wp::float64 const& unseen = {},
    wp::float64 const& worth_if_all_agree = {},
    wp::float64 const& unseen_if_all_agree = {},
    wp::float64 const& unseen_if_one_differs = {})
        : worth{worth}
        , unseen{unseen}
        , worth_if_all_agree{worth_if_all_agree}
        , unseen_if_all_agree{unseen_if_all_agree}
        , unseen_if_one_differs{unseen_if_one_differs}

    {
    }

    CUDA_CALLABLE Prior_2e82b100& operator += (const Prior_2e82b100& rhs)
    {    worth += rhs.worth;
    unseen += rhs.unseen;
    worth_if_all_agree += rhs.worth_if_all_agree;
    unseen_if_all_agree += rhs.unseen_if_all_agree;
    unseen_if_one_differs += rhs.unseen_if_one_differs;

        return *this;}

};

static CUDA_CALLABLE void adj_Prior_2e82b100(wp::float64 const&,
    wp::float64 const&,
    wp::float64 const&,
    wp::float64 const&,
    wp::float64 const&,
    wp::float64 & adj_worth,
    wp::float64 & adj_unseen,
    wp::float64 & adj_worth_if_all_agree,
    wp::float64 & adj_unseen_if_all_agree,
    wp::float64 & adj_unseen_if_one_differs,
    Prior_2e82b100 & adj_ret)
{
    adj_worth += adj_ret.worth;
    adj_unseen += adj_ret.unseen;
    adj_worth_if_all_agree += adj_ret.worth_if_all_agree;
    adj_unseen_if_all_agree += adj_ret.unseen_if_all_agree;
    adj_unseen_if_one_differs += adj_ret.unseen_if_one_differs;
}

// Required when compiling adjoints.
CUDA_CALLABLE Prior_2e82b100 add(const Prior_2e82b100& a, const Prior_2e82b100& b)
{
    return Prior_2e82b100();
}

CUDA_CALLABLE void adj_atomic_add(Prior_2e82b100* p, Prior_2e82b100 t)
{
    wp::adj_atomic_add(&p->worth, t.worth);
    wp::adj_atomic_add(&p->unseen, t.unseen);
    wp::adj_atomic_add(&p->worth_if_all_agree, t.worth_if_all_agree);
    wp::adj_atomic_add(&p->unseen_if_all_agree, t.unseen_if_all_agree);
    wp::adj_atomic_add(&p->unseen_if_one_differs, t.unseen_if_one_differs);
}




// /work/main/warpsample/tracing/sight/point.py:100
static ShadingPoint_241c3e67 point_in_0(
    wp::uint64 var_workspace,
    wp::int32 var_own,
    wp::int32 var_chunk)
{
    //---------
    // primal vars
    ShadingPoint_241c3e67 var_0;
    wp::uint64* var_1;
    const wp::int32 var_2 = 4;
    wp::int32 var_3;
    wp::uint64 var_4;
    wp::uint64 var_5;
    wp::uint64 var_6;
    wp::uint64* var_7;
    const wp::int32 var_8 = 4;
    wp::int32 var_9;
    wp::uint64 var_10;
    wp::uint64 var_11;
    wp::uint64 var_12;
    wp::uint64* var_13;
    const wp::int32 var_14 = 4;
    const wp::int32 var_15 = 80;
    wp::int32 var_16;
    wp::uint64 var_17;
    wp::uint64 var_18;
    wp::uint64 var_19;
    wp::uint64* var_20;
    const wp::int32 var_21 = 4;
    const wp::int32 var_22 = 688;
    wp::int32 var_23;
    wp::uint64 var_24;
    wp::uint64 var_25;
    wp::uint64 var_26;
    wp::uint64* var_27;
    const wp::int32 var_28 = 4;
    const wp::int32 var_29 = 112;
    wp::int32 var_30;
    wp::uint64 var_31;
    wp::uint64 var_32;
    wp::uint64 var_33;
    wp::uint64* var_34;
    const wp::int32 var_35 = 4;
    const wp::int32 var_36 = 192;
    wp::int32 var_37;
    wp::uint64 var_38;
    wp::uint64 var_39;
    wp::uint64 var_40;
    //---------
    // forward
    // def point_in(workspace: wp.uint64, own: wp.int32, chunk: wp.int32) -> ShadingPoint:       <L 101>
    // point = ShadingPoint()                                                                 <L 106>
    var_0 = ShadingPoint_241c3e67();
    // point.chunk = workspace                                                                <L 107>
    var_0.chunk = var_workspace;
    // point.own = point.chunk + wp.uint64(4 * chunk)                                         <L 108>
    var_1 = &((var_0).chunk);
    var_3 = wp::mul(var_2, var_chunk);
    var_4 = wp::uint64(var_3);
    var_6 = wp::load(var_1);
    var_5 = wp::add(var_6, var_4);
    var_0.own = var_5;
    // point.shaft = point.own + wp.uint64(4 * own)                                           <L 109>
    var_7 = &((var_0).own);
    var_9 = wp::mul(var_8, var_own);
    var_10 = wp::uint64(var_9);
    var_12 = wp::load(var_7);
    var_11 = wp::add(var_12, var_10);
    var_0.shaft = var_11;
    // point.opened = point.shaft + wp.uint64(4 * SHAFT_FLOATS)                               <L 110>
    var_13 = &((var_0).shaft);
    var_16 = wp::mul(var_14, var_15);
    var_17 = wp::uint64(var_16);
    var_19 = wp::load(var_13);
    var_18 = wp::add(var_19, var_17);
    var_0.opened = var_18;
    // point.scratch = point.opened + wp.uint64(4 * _OPENED_FLOATS)                           <L 111>
    var_20 = &((var_0).opened);
    var_23 = wp::mul(var_21, var_22);
    var_24 = wp::uint64(var_23);
    var_26 = wp::load(var_20);
    var_25 = wp::add(var_26, var_24);
    var_0.scratch = var_25;
    // point.sides = point.scratch + wp.uint64(4 * _SCRATCH_FLOATS)                           <L 112>
    var_27 = &((var_0).scratch);
    var_30 = wp::mul(var_28, var_29);
    var_31 = wp::uint64(var_30);
    var_33 = wp::load(var_27);
    var_32 = wp::add(var_33, var_31);
    var_0.sides = var_32;
    // point.waiting = point.sides + wp.uint64(4 * SIDES_FLOATS)                              <L 113>
    var_34 = &((var_0).sides);
    var_37 = wp::mul(var_35, var_36);
    var_38 = wp::uint64(var_37);
    var_40 = wp::load(var_34);
    var_39 = wp::add(var_40, var_38);
    var_0.waiting = var_39;
    // return point                                                                           <L 114>
    return var_0;
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


// /work/main/warpsample/maths/memory.py:0
static wp::uint8 _reader__locals__read_4(
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
    wp::array_t<wp::uint8> var_6;
    const wp::int32 var_7 = 1;
    const wp::int32 var_8 = 0;
    wp::uint8* var_9;
    wp::uint8 var_10;
    wp::uint8 var_11;
    //---------
    // forward
    // def read(address: wp.uint64, i: Any):                                                  <L 1>
    // return wp.array(ptr=address + wp.uint64(i) * wp.uint64(size), shape=(1,), dtype=kind)[0]       <L 2>
    var_0 = wp::uint64(var_i);
    var_1 = 1ull;
    var_2 = wp::mul(var_0, var_1);
    var_3 = wp::add(var_address, var_2);
    var_5 = wp::tuple(var_4);
    var_6 = wp::array_t<wp::uint8>(var_3, var_7);
    var_9 = wp::address(var_6, var_8);
    var_11 = wp::load(var_9);
    var_10 = wp::copy(var_11);
    return var_10;
}


// /work/main/warpsample/directions/samples.py:21
static wp::int32 normal_status_0(
    wp::vec_t<3, wp::float32> var_n,
    wp::float32 var_weight)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float32 var_1;
    const wp::int32 var_2 = 0;
    wp::float32 var_3;
    wp::float32 var_4;
    const wp::int32 var_5 = 1;
    wp::float32 var_6;
    const wp::int32 var_7 = 1;
    wp::float32 var_8;
    wp::float32 var_9;
    wp::float32 var_10;
    const wp::int32 var_11 = 2;
    wp::float32 var_12;
    const wp::int32 var_13 = 2;
    wp::float32 var_14;
    wp::float32 var_15;
    wp::float32 var_16;
    const wp::float32 var_17 = 0.0;
    bool var_18;
    const wp::int32 var_19 = 0;
    wp::float32 var_20;
    wp::float32 var_21;
    const wp::int32 var_22 = 1;
    wp::float32 var_23;
    wp::float32 var_24;
    wp::float32 var_25;
    const wp::int32 var_26 = 2;
    wp::float32 var_27;
    wp::float32 var_28;
    wp::float32 var_29;
    const wp::float32 var_30 = 0.0;
    bool var_31;
    const wp::int32 var_32 = 2;
    const wp::int32 var_33 = 0;
    wp::int32 var_34;
    const wp::int32 var_35 = 3;
    wp::int32 var_36;
    const wp::float32 var_37 = 0.0;
    bool var_38;
    const wp::int32 var_39 = 1;
    wp::int32 var_40;
    //---------
    // forward
    // def normal_status(n: wp.vec3, weight: wp.float32) -> wp.int32:                         <L 22>
    // finite = (n[0] - n[0]) + (n[1] - n[1]) + (n[2] - n[2]) == 0.0                          <L 24>
    var_1 = wp::extract(var_n, var_0);
    var_3 = wp::extract(var_n, var_2);
    var_4 = wp::sub(var_1, var_3);
    var_6 = wp::extract(var_n, var_5);
    var_8 = wp::extract(var_n, var_7);
    var_9 = wp::sub(var_6, var_8);
    var_10 = wp::add(var_4, var_9);
    var_12 = wp::extract(var_n, var_11);
    var_14 = wp::extract(var_n, var_13);
    var_15 = wp::sub(var_12, var_14);
    var_16 = wp::add(var_10, var_15);
    var_18 = (var_16 == var_17);
    // zero = wp.abs(n[0]) + wp.abs(n[1]) + wp.abs(n[2]) == 0.0                               <L 25>
    var_20 = wp::extract(var_n, var_19);
    var_21 = wp::abs(var_20);
    var_23 = wp::extract(var_n, var_22);
    var_24 = wp::abs(var_23);
    var_25 = wp::add(var_21, var_24);
    var_27 = wp::extract(var_n, var_26);
    var_28 = wp::abs(var_27);
    var_29 = wp::add(var_25, var_28);
    var_31 = (var_29 == var_30);
    // code = wp.where(finite, wp.where(zero, ZERO_NORMAL, 0), NONFINITE_NORMAL)              <L 26>
    var_34 = wp::where(var_31, var_32, var_33);
    var_36 = wp::where(var_18, var_34, var_35);
    // return wp.where(weight == 0.0, INACTIVE, code)                                         <L 27>
    var_38 = (var_weight == var_37);
    var_40 = wp::where(var_38, var_39, var_36);
    return var_40;
}


// /work/main/warpsample/tracing/sight/point.py:117
static ShadingPoint_241c3e67 orient_point_0(
    ShadingPoint_241c3e67 var_point,
    Placement_e6d83c4e var_placement,
    wp::uint64 var_normals,
    wp::uint64 var_active,
    wp::int64 var_visit)
{
    //---------
    // primal vars
    wp::int64 var_0;
    wp::int64* var_1;
    wp::vec_t<3, wp::float32> var_2;
    wp::int64 var_3;
    wp::vec_t<4, wp::float32> var_4;
    const wp::int32 var_5 = 0;
    wp::float32 var_6;
    const wp::int32 var_7 = 1;
    wp::float32 var_8;
    const wp::int32 var_9 = 2;
    wp::float32 var_10;
    wp::vec_t<3, wp::float32> var_11;
    const wp::float32 var_12 = 1.0;
    wp::float32 var_13;
    wp::uint64 var_14;
    bool var_15;
    wp::int64* var_16;
    wp::uint8 var_17;
    wp::int64 var_18;
    const wp::int32 var_19 = 0;
    wp::uint8 var_20;
    bool var_21;
    const wp::float32 var_22 = 0.0;
    const wp::float32 var_23 = 1.0;
    wp::float32 var_24;
    wp::float32 var_25;
    wp::int32 var_26;
    //---------
    // forward
    // def orient_point(                                                                      <L 118>
    // point.index = point_of(placement, visit)                                               <L 125>
    var_0 = point_of_0(var_placement, var_visit);
    var_point.index = var_0;
    // normal = vec3_at(normals, point.index)                                                 <L 126>
    var_1 = &((var_point).index);
    var_3 = wp::load(var_1);
    var_2 = _reader__locals__read_5(var_normals, var_3);
    // unit = scaled_to_unit(normal)                                                          <L 127>
    var_4 = scaled_to_unit_0(var_2);
    // point.n = wp.vec3(unit[0], unit[1], unit[2])                                           <L 128>
    var_6 = wp::extract(var_4, var_5);
    var_8 = wp::extract(var_4, var_7);
    var_10 = wp::extract(var_4, var_9);
    var_11 = wp::vec_t<3, wp::float32>(var_6, var_8, var_10);
    var_point.n = var_11;
    // weight = wp.float32(1.0)                                                               <L 129>
    var_13 = wp::float32(var_12);
    // if active != wp.uint64(0):                                                             <L 130>
    var_14 = 0ull;
    var_15 = (var_active != var_14);
    if (var_15) {
        // weight = wp.where(byte_at(active, point.index) == wp.uint8(0), 0.0, 1.0)           <L 131>
        var_16 = &((var_point).index);
        var_18 = wp::load(var_16);
        var_17 = _reader__locals__read_4(var_active, var_18);
        var_20 = wp::uint8(var_19);
        var_21 = (var_17 == var_20);
        var_24 = wp::where(var_21, var_22, var_23);
    }
    var_25 = wp::where(var_15, var_24, var_13);
    // point.status = normal_status(normal, weight)                                           <L 132>
    var_26 = normal_status_0(var_2, var_25);
    var_point.status = var_26;
    // return point                                                                           <L 133>
    return var_point;
}


// /work/main/warpsample/maths/memory.py:0
static wp::uint64 _reader__locals__read_3(
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


// /work/main/warpsample/tracing/placement.py:123
static wp::uint64 id_of_0(
    Placement_e6d83c4e var_placement,
    wp::uint64 var_first,
    wp::int64 var_point)
{
    //---------
    // primal vars
    wp::uint64* var_0;
    wp::uint64 var_1;
    bool var_2;
    wp::uint64 var_3;
    wp::uint64 var_4;
    wp::uint64 var_5;
    wp::uint64* var_6;
    wp::uint64 var_7;
    wp::uint64 var_8;
    //---------
    // forward
    // def id_of(placement: Placement, first: wp.uint64, point: wp.int64) -> wp.uint64:       <L 124>
    // if placement.ids == wp.uint64(0):                                                      <L 126>
    var_0 = &((var_placement).ids);
    var_1 = 0ull;
    var_3 = wp::load(var_0);
    var_2 = (var_3 == var_1);
    if (var_2) {
        // return first + wp.uint64(point)                                                    <L 127>
        var_4 = wp::uint64(var_point);
        var_5 = wp::add(var_first, var_4);
        return var_5;
    }
    // return address_at(placement.ids, point)                                                <L 128>
    var_6 = &((var_placement).ids);
    var_8 = wp::load(var_6);
    var_7 = _reader__locals__read_3(var_8, var_point);
    return var_7;
}


// /work/main/warpsample/maths/numerics.py:70
static wp::uint32 high_word_0(
    wp::uint64 var_x)
{
    //---------
    // primal vars
    wp::uint64 var_0;
    wp::uint64 var_1;
    wp::uint32 var_2;
    //---------
    // forward
    // def high_word(x: wp.uint64) -> wp.uint32:                                              <L 71>
    // return wp.uint32(x >> wp.uint64(32))                                                   <L 73>
    var_0 = 32ull;
    var_1 = wp::rshift(var_x, var_0);
    var_2 = wp::uint32(var_1);
    return var_2;
}


// /work/main/warpsample/maths/numerics.py:64
static wp::uint32 low_word_0(
    wp::uint64 var_x)
{
    //---------
    // primal vars
    wp::uint32 var_0;
    //---------
    // forward
    // def low_word(x: wp.uint64) -> wp.uint32:                                               <L 65>
    // return wp.uint32(x)                                                                    <L 67>
    var_0 = wp::uint32(var_x);
    return var_0;
}


// /work/main/warpsample/sequences/hashing.py:43
static wp::vec_t<4, wp::uint32> philox4x32_10_0(
    wp::vec_t<4, wp::uint32> var_counter,
    wp::uint32 var_key_0,
    wp::uint32 var_key_1)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::uint32 var_1;
    const wp::int32 var_2 = 1;
    wp::uint32 var_3;
    const wp::int32 var_4 = 2;
    wp::uint32 var_5;
    const wp::int32 var_6 = 3;
    wp::uint32 var_7;
    const wp::int32 var_8 = 0;
    wp::uint64 var_9;
    wp::uint64 var_10;
    wp::uint64 var_11;
    wp::uint64 var_12;
    wp::uint64 var_13;
    wp::uint64 var_14;
    wp::uint32 var_15;
    wp::uint32 var_16;
    wp::uint32 var_17;
    wp::uint32 var_18;
    wp::uint32 var_19;
    wp::uint32 var_20;
    wp::uint32 var_21;
    wp::uint32 var_22;
    const wp::uint32 var_23 = 2654435769u;
    wp::uint32 var_24;
    const wp::uint32 var_25 = 3144134277u;
    wp::uint32 var_26;
    const wp::int32 var_27 = 1;
    wp::uint64 var_28;
    wp::uint64 var_29;
    wp::uint64 var_30;
    wp::uint64 var_31;
    wp::uint64 var_32;
    wp::uint64 var_33;
    wp::uint32 var_34;
    wp::uint32 var_35;
    wp::uint32 var_36;
    wp::uint32 var_37;
    wp::uint32 var_38;
    wp::uint32 var_39;
    wp::uint32 var_40;
    wp::uint32 var_41;
    wp::uint32 var_42;
    wp::uint32 var_43;
    const wp::int32 var_44 = 2;
    wp::uint64 var_45;
    wp::uint64 var_46;
    wp::uint64 var_47;
    wp::uint64 var_48;
    wp::uint64 var_49;
    wp::uint64 var_50;
    wp::uint32 var_51;
    wp::uint32 var_52;
    wp::uint32 var_53;
    wp::uint32 var_54;
    wp::uint32 var_55;
    wp::uint32 var_56;
    wp::uint32 var_57;
    wp::uint32 var_58;
    wp::uint32 var_59;
    wp::uint32 var_60;
    const wp::int32 var_61 = 3;
    wp::uint64 var_62;
    wp::uint64 var_63;
    wp::uint64 var_64;
    wp::uint64 var_65;
    wp::uint64 var_66;
    wp::uint64 var_67;
    wp::uint32 var_68;
    wp::uint32 var_69;
    wp::uint32 var_70;
    wp::uint32 var_71;
    wp::uint32 var_72;
    wp::uint32 var_73;
    wp::uint32 var_74;
    wp::uint32 var_75;
    wp::uint32 var_76;
    wp::uint32 var_77;
    const wp::int32 var_78 = 4;
    wp::uint64 var_79;
    wp::uint64 var_80;
    wp::uint64 var_81;
    wp::uint64 var_82;
    wp::uint64 var_83;
    wp::uint64 var_84;
    wp::uint32 var_85;
    wp::uint32 var_86;
    wp::uint32 var_87;
    wp::uint32 var_88;
    wp::uint32 var_89;
    wp::uint32 var_90;
    wp::uint32 var_91;
    wp::uint32 var_92;
    wp::uint32 var_93;
    wp::uint32 var_94;
    const wp::int32 var_95 = 5;
    wp::uint64 var_96;
    wp::uint64 var_97;
    wp::uint64 var_98;
    wp::uint64 var_99;
    wp::uint64 var_100;
    wp::uint64 var_101;
    wp::uint32 var_102;
    wp::uint32 var_103;
    wp::uint32 var_104;
    wp::uint32 var_105;
    wp::uint32 var_106;
    wp::uint32 var_107;
    wp::uint32 var_108;
    wp::uint32 var_109;
    wp::uint32 var_110;
    wp::uint32 var_111;
    const wp::int32 var_112 = 6;
    wp::uint64 var_113;
    wp::uint64 var_114;
    wp::uint64 var_115;
    wp::uint64 var_116;
    wp::uint64 var_117;
    wp::uint64 var_118;
    wp::uint32 var_119;
    wp::uint32 var_120;
    wp::uint32 var_121;
    wp::uint32 var_122;
    wp::uint32 var_123;
    wp::uint32 var_124;
    wp::uint32 var_125;
    wp::uint32 var_126;
    wp::uint32 var_127;
    wp::uint32 var_128;
    const wp::int32 var_129 = 7;
    wp::uint64 var_130;
    wp::uint64 var_131;
    wp::uint64 var_132;
    wp::uint64 var_133;
    wp::uint64 var_134;
    wp::uint64 var_135;
    wp::uint32 var_136;
    wp::uint32 var_137;
    wp::uint32 var_138;
    wp::uint32 var_139;
    wp::uint32 var_140;
    wp::uint32 var_141;
    wp::uint32 var_142;
    wp::uint32 var_143;
    wp::uint32 var_144;
    wp::uint32 var_145;
    const wp::int32 var_146 = 8;
    wp::uint64 var_147;
    wp::uint64 var_148;
    wp::uint64 var_149;
    wp::uint64 var_150;
    wp::uint64 var_151;
    wp::uint64 var_152;
    wp::uint32 var_153;
    wp::uint32 var_154;
    wp::uint32 var_155;
    wp::uint32 var_156;
    wp::uint32 var_157;
    wp::uint32 var_158;
    wp::uint32 var_159;
    wp::uint32 var_160;
    wp::uint32 var_161;
    wp::uint32 var_162;
    const wp::int32 var_163 = 9;
    wp::uint64 var_164;
    wp::uint64 var_165;
    wp::uint64 var_166;
    wp::uint64 var_167;
    wp::uint64 var_168;
    wp::uint64 var_169;
    wp::uint32 var_170;
    wp::uint32 var_171;
    wp::uint32 var_172;
    wp::uint32 var_173;
    wp::uint32 var_174;
    wp::uint32 var_175;
    wp::uint32 var_176;
    wp::uint32 var_177;
    wp::uint32 var_178;
    wp::uint32 var_179;
    wp::vec_t<4, wp::uint32> var_180;
    //---------
    // forward
    // def philox4x32_10(counter: wp.vec4ui, key_0: wp.uint32, key_1: wp.uint32) -> wp.vec4ui:       <L 44>
    // x0 = counter[0]                                                                        <L 49>
    var_1 = wp::extract(var_counter, var_0);
    // x1 = counter[1]                                                                        <L 50>
    var_3 = wp::extract(var_counter, var_2);
    // x2 = counter[2]                                                                        <L 51>
    var_5 = wp::extract(var_counter, var_4);
    // x3 = counter[3]                                                                        <L 52>
    var_7 = wp::extract(var_counter, var_6);
    // for _ in range(10):                                                                    <L 53>
    // product_0 = wp.uint64(_PHILOX_0) * wp.uint64(x0)                                       <L 54>
    var_9 = 3528531795ull;
    var_10 = wp::uint64(var_1);
    var_11 = wp::mul(var_9, var_10);
    // product_1 = wp.uint64(_PHILOX_1) * wp.uint64(x2)                                       <L 55>
    var_12 = 3449720151ull;
    var_13 = wp::uint64(var_5);
    var_14 = wp::mul(var_12, var_13);
    // x0 = high_word(product_1) ^ x1 ^ key_0                                                 <L 56>
    var_15 = high_word_0(var_14);
    var_16 = wp::bit_xor(var_15, var_3);
    var_17 = wp::bit_xor(var_16, var_key_0);
    // x1 = low_word(product_1)                                                               <L 57>
    var_18 = low_word_0(var_14);
    // x2 = high_word(product_0) ^ x3 ^ key_1                                                 <L 58>
    var_19 = high_word_0(var_11);
    var_20 = wp::bit_xor(var_19, var_7);
    var_21 = wp::bit_xor(var_20, var_key_1);
    // x3 = low_word(product_0)                                                               <L 59>
    var_22 = low_word_0(var_11);
    // key_0 = key_0 + _WEYL_0                                                                <L 60>
    var_24 = wp::add(var_key_0, var_23);
    // key_1 = key_1 + _WEYL_1                                                                <L 61>
    var_26 = wp::add(var_key_1, var_25);
    // product_0 = wp.uint64(_PHILOX_0) * wp.uint64(x0)                                       <L 54>
    var_28 = wp::uint64(var_9);
    var_29 = wp::uint64(var_17);
    var_30 = wp::mul(var_28, var_29);
    // product_1 = wp.uint64(_PHILOX_1) * wp.uint64(x2)                                       <L 55>
    var_31 = wp::uint64(var_12);
    var_32 = wp::uint64(var_21);
    var_33 = wp::mul(var_31, var_32);
    // x0 = high_word(product_1) ^ x1 ^ key_0                                                 <L 56>
    var_34 = high_word_0(var_33);
    var_35 = wp::bit_xor(var_34, var_18);
    var_36 = wp::bit_xor(var_35, var_24);
    // x1 = low_word(product_1)                                                               <L 57>
    var_37 = low_word_0(var_33);
    // x2 = high_word(product_0) ^ x3 ^ key_1                                                 <L 58>
    var_38 = high_word_0(var_30);
    var_39 = wp::bit_xor(var_38, var_22);
    var_40 = wp::bit_xor(var_39, var_26);
    // x3 = low_word(product_0)                                                               <L 59>
    var_41 = low_word_0(var_30);
    // key_0 = key_0 + _WEYL_0                                                                <L 60>
    var_42 = wp::add(var_24, var_23);
    // key_1 = key_1 + _WEYL_1                                                                <L 61>
    var_43 = wp::add(var_26, var_25);
    // product_0 = wp.uint64(_PHILOX_0) * wp.uint64(x0)                                       <L 54>
    var_45 = wp::uint64(var_9);
    var_46 = wp::uint64(var_36);
    var_47 = wp::mul(var_45, var_46);
    // product_1 = wp.uint64(_PHILOX_1) * wp.uint64(x2)                                       <L 55>
    var_48 = wp::uint64(var_12);
    var_49 = wp::uint64(var_40);
    var_50 = wp::mul(var_48, var_49);
    // x0 = high_word(product_1) ^ x1 ^ key_0                                                 <L 56>
    var_51 = high_word_0(var_50);
    var_52 = wp::bit_xor(var_51, var_37);
    var_53 = wp::bit_xor(var_52, var_42);
    // x1 = low_word(product_1)                                                               <L 57>
    var_54 = low_word_0(var_50);
    // x2 = high_word(product_0) ^ x3 ^ key_1                                                 <L 58>
    var_55 = high_word_0(var_47);
    var_56 = wp::bit_xor(var_55, var_41);
    var_57 = wp::bit_xor(var_56, var_43);
    // x3 = low_word(product_0)                                                               <L 59>
    var_58 = low_word_0(var_47);
    // key_0 = key_0 + _WEYL_0                                                                <L 60>
    var_59 = wp::add(var_42, var_23);
    // key_1 = key_1 + _WEYL_1                                                                <L 61>
    var_60 = wp::add(var_43, var_25);
    // product_0 = wp.uint64(_PHILOX_0) * wp.uint64(x0)                                       <L 54>
    var_62 = wp::uint64(var_9);
    var_63 = wp::uint64(var_53);
    var_64 = wp::mul(var_62, var_63);
    // product_1 = wp.uint64(_PHILOX_1) * wp.uint64(x2)                                       <L 55>
    var_65 = wp::uint64(var_12);
    var_66 = wp::uint64(var_57);
    var_67 = wp::mul(var_65, var_66);
    // x0 = high_word(product_1) ^ x1 ^ key_0                                                 <L 56>
    var_68 = high_word_0(var_67);
    var_69 = wp::bit_xor(var_68, var_54);
    var_70 = wp::bit_xor(var_69, var_59);
    // x1 = low_word(product_1)                                                               <L 57>
    var_71 = low_word_0(var_67);
    // x2 = high_word(product_0) ^ x3 ^ key_1                                                 <L 58>
    var_72 = high_word_0(var_64);
    var_73 = wp::bit_xor(var_72, var_58);
    var_74 = wp::bit_xor(var_73, var_60);
    // x3 = low_word(product_0)                                                               <L 59>
    var_75 = low_word_0(var_64);
    // key_0 = key_0 + _WEYL_0                                                                <L 60>
    var_76 = wp::add(var_59, var_23);
    // key_1 = key_1 + _WEYL_1                                                                <L 61>
    var_77 = wp::add(var_60, var_25);
    // product_0 = wp.uint64(_PHILOX_0) * wp.uint64(x0)                                       <L 54>
    var_79 = wp::uint64(var_9);
    var_80 = wp::uint64(var_70);
    var_81 = wp::mul(var_79, var_80);
    // product_1 = wp.uint64(_PHILOX_1) * wp.uint64(x2)                                       <L 55>
    var_82 = wp::uint64(var_12);
    var_83 = wp::uint64(var_74);
    var_84 = wp::mul(var_82, var_83);
    // x0 = high_word(product_1) ^ x1 ^ key_0                                                 <L 56>
    var_85 = high_word_0(var_84);
    var_86 = wp::bit_xor(var_85, var_71);
    var_87 = wp::bit_xor(var_86, var_76);
    // x1 = low_word(product_1)                                                               <L 57>
    var_88 = low_word_0(var_84);
    // x2 = high_word(product_0) ^ x3 ^ key_1                                                 <L 58>
    var_89 = high_word_0(var_81);
    var_90 = wp::bit_xor(var_89, var_75);
    var_91 = wp::bit_xor(var_90, var_77);
    // x3 = low_word(product_0)                                                               <L 59>
    var_92 = low_word_0(var_81);
    // key_0 = key_0 + _WEYL_0                                                                <L 60>
    var_93 = wp::add(var_76, var_23);
    // key_1 = key_1 + _WEYL_1                                                                <L 61>
    var_94 = wp::add(var_77, var_25);
    // product_0 = wp.uint64(_PHILOX_0) * wp.uint64(x0)                                       <L 54>
    var_96 = wp::uint64(var_9);
    var_97 = wp::uint64(var_87);
    var_98 = wp::mul(var_96, var_97);
    // product_1 = wp.uint64(_PHILOX_1) * wp.uint64(x2)                                       <L 55>
    var_99 = wp::uint64(var_12);
    var_100 = wp::uint64(var_91);
    var_101 = wp::mul(var_99, var_100);
    // x0 = high_word(product_1) ^ x1 ^ key_0                                                 <L 56>
    var_102 = high_word_0(var_101);
    var_103 = wp::bit_xor(var_102, var_88);
    var_104 = wp::bit_xor(var_103, var_93);
    // x1 = low_word(product_1)                                                               <L 57>
    var_105 = low_word_0(var_101);
    // x2 = high_word(product_0) ^ x3 ^ key_1                                                 <L 58>
    var_106 = high_word_0(var_98);
    var_107 = wp::bit_xor(var_106, var_92);
    var_108 = wp::bit_xor(var_107, var_94);
    // x3 = low_word(product_0)                                                               <L 59>
    var_109 = low_word_0(var_98);
    // key_0 = key_0 + _WEYL_0                                                                <L 60>
    var_110 = wp::add(var_93, var_23);
    // key_1 = key_1 + _WEYL_1                                                                <L 61>
    var_111 = wp::add(var_94, var_25);
    // product_0 = wp.uint64(_PHILOX_0) * wp.uint64(x0)                                       <L 54>
    var_113 = wp::uint64(var_9);
    var_114 = wp::uint64(var_104);
    var_115 = wp::mul(var_113, var_114);
    // product_1 = wp.uint64(_PHILOX_1) * wp.uint64(x2)                                       <L 55>
    var_116 = wp::uint64(var_12);
    var_117 = wp::uint64(var_108);
    var_118 = wp::mul(var_116, var_117);
    // x0 = high_word(product_1) ^ x1 ^ key_0                                                 <L 56>
    var_119 = high_word_0(var_118);
    var_120 = wp::bit_xor(var_119, var_105);
    var_121 = wp::bit_xor(var_120, var_110);
    // x1 = low_word(product_1)                                                               <L 57>
    var_122 = low_word_0(var_118);
    // x2 = high_word(product_0) ^ x3 ^ key_1                                                 <L 58>
    var_123 = high_word_0(var_115);
    var_124 = wp::bit_xor(var_123, var_109);
    var_125 = wp::bit_xor(var_124, var_111);
    // x3 = low_word(product_0)                                                               <L 59>
    var_126 = low_word_0(var_115);
    // key_0 = key_0 + _WEYL_0                                                                <L 60>
    var_127 = wp::add(var_110, var_23);
    // key_1 = key_1 + _WEYL_1                                                                <L 61>
    var_128 = wp::add(var_111, var_25);
    // product_0 = wp.uint64(_PHILOX_0) * wp.uint64(x0)                                       <L 54>
    var_130 = wp::uint64(var_9);
    var_131 = wp::uint64(var_121);
    var_132 = wp::mul(var_130, var_131);
    // product_1 = wp.uint64(_PHILOX_1) * wp.uint64(x2)                                       <L 55>
    var_133 = wp::uint64(var_12);
    var_134 = wp::uint64(var_125);
    var_135 = wp::mul(var_133, var_134);
    // x0 = high_word(product_1) ^ x1 ^ key_0                                                 <L 56>
    var_136 = high_word_0(var_135);
    var_137 = wp::bit_xor(var_136, var_122);
    var_138 = wp::bit_xor(var_137, var_127);
    // x1 = low_word(product_1)                                                               <L 57>
    var_139 = low_word_0(var_135);
    // x2 = high_word(product_0) ^ x3 ^ key_1                                                 <L 58>
    var_140 = high_word_0(var_132);
    var_141 = wp::bit_xor(var_140, var_126);
    var_142 = wp::bit_xor(var_141, var_128);
    // x3 = low_word(product_0)                                                               <L 59>
    var_143 = low_word_0(var_132);
    // key_0 = key_0 + _WEYL_0                                                                <L 60>
    var_144 = wp::add(var_127, var_23);
    // key_1 = key_1 + _WEYL_1                                                                <L 61>
    var_145 = wp::add(var_128, var_25);
    // product_0 = wp.uint64(_PHILOX_0) * wp.uint64(x0)                                       <L 54>
    var_147 = wp::uint64(var_9);
    var_148 = wp::uint64(var_138);
    var_149 = wp::mul(var_147, var_148);
    // product_1 = wp.uint64(_PHILOX_1) * wp.uint64(x2)                                       <L 55>
    var_150 = wp::uint64(var_12);
    var_151 = wp::uint64(var_142);
    var_152 = wp::mul(var_150, var_151);
    // x0 = high_word(product_1) ^ x1 ^ key_0                                                 <L 56>
    var_153 = high_word_0(var_152);
    var_154 = wp::bit_xor(var_153, var_139);
    var_155 = wp::bit_xor(var_154, var_144);
    // x1 = low_word(product_1)                                                               <L 57>
    var_156 = low_word_0(var_152);
    // x2 = high_word(product_0) ^ x3 ^ key_1                                                 <L 58>
    var_157 = high_word_0(var_149);
    var_158 = wp::bit_xor(var_157, var_143);
    var_159 = wp::bit_xor(var_158, var_145);
    // x3 = low_word(product_0)                                                               <L 59>
    var_160 = low_word_0(var_149);
    // key_0 = key_0 + _WEYL_0                                                                <L 60>
    var_161 = wp::add(var_144, var_23);
    // key_1 = key_1 + _WEYL_1                                                                <L 61>
    var_162 = wp::add(var_145, var_25);
    // product_0 = wp.uint64(_PHILOX_0) * wp.uint64(x0)                                       <L 54>
    var_164 = wp::uint64(var_9);
    var_165 = wp::uint64(var_155);
    var_166 = wp::mul(var_164, var_165);
    // product_1 = wp.uint64(_PHILOX_1) * wp.uint64(x2)                                       <L 55>
    var_167 = wp::uint64(var_12);
    var_168 = wp::uint64(var_159);
    var_169 = wp::mul(var_167, var_168);
    // x0 = high_word(product_1) ^ x1 ^ key_0                                                 <L 56>
    var_170 = high_word_0(var_169);
    var_171 = wp::bit_xor(var_170, var_156);
    var_172 = wp::bit_xor(var_171, var_161);
    // x1 = low_word(product_1)                                                               <L 57>
    var_173 = low_word_0(var_169);
    // x2 = high_word(product_0) ^ x3 ^ key_1                                                 <L 58>
    var_174 = high_word_0(var_166);
    var_175 = wp::bit_xor(var_174, var_160);
    var_176 = wp::bit_xor(var_175, var_162);
    // x3 = low_word(product_0)                                                               <L 59>
    var_177 = low_word_0(var_166);
    // key_0 = key_0 + _WEYL_0                                                                <L 60>
    var_178 = wp::add(var_161, var_23);
    // key_1 = key_1 + _WEYL_1                                                                <L 61>
    var_179 = wp::add(var_162, var_25);
    // return wp.vec4ui(x0, x1, x2, x3)                                                       <L 62>
    var_180 = wp::vec_t<4, wp::uint32>(var_172, var_173, var_176, var_177);
    return var_180;
}


// /work/main/warpsample/sequences/hashing.py:99
static wp::vec_t<4, wp::uint32> run_key_0(
    wp::uint64 var_seed,
    wp::uint32 var_high)
{
    //---------
    // primal vars
    const wp::uint32 var_0 = 0u;
    const wp::uint32 var_1 = 2u;
    wp::vec_t<4, wp::uint32> var_2;
    wp::uint32 var_3;
    wp::uint32 var_4;
    wp::vec_t<4, wp::uint32> var_5;
    //---------
    // forward
    // def run_key(seed: wp.uint64, high: wp.uint32) -> wp.vec4ui:                            <L 100>
    // return philox4x32_10(wp.vec4ui(high, ZERO_WORD, ZERO_WORD, _KEYS), low_word(seed), high_word(seed))       <L 102>
    var_2 = wp::vec_t<4, wp::uint32>(var_high, var_0, var_0, var_1);
    var_3 = low_word_0(var_seed);
    var_4 = high_word_0(var_seed);
    var_5 = philox4x32_10_0(var_2, var_3, var_4);
    return var_5;
}


// /work/main/warpsample/sequences/hashing.py:91
static wp::uint32 finalise_0(
    wp::uint32 var_word)
{
    //---------
    // primal vars
    const wp::uint32 var_0 = 16u;
    wp::uint32 var_1;
    wp::uint32 var_2;
    const wp::uint32 var_3 = 2246822507u;
    wp::uint32 var_4;
    const wp::uint32 var_5 = 13u;
    wp::uint32 var_6;
    wp::uint32 var_7;
    const wp::uint32 var_8 = 3266489909u;
    wp::uint32 var_9;
    wp::uint32 var_10;
    wp::uint32 var_11;
    //---------
    // forward
    // def finalise(word: wp.uint32) -> wp.uint32:                                            <L 92>
    // word = (word ^ (word >> _SHIFT)) * _MURMUR_1                                           <L 94>
    var_1 = wp::rshift(var_word, var_0);
    var_2 = wp::bit_xor(var_word, var_1);
    var_4 = wp::mul(var_2, var_3);
    // word = (word ^ (word >> _MURMUR_SHIFT)) * _MURMUR_2                                    <L 95>
    var_6 = wp::rshift(var_4, var_5);
    var_7 = wp::bit_xor(var_4, var_6);
    var_9 = wp::mul(var_7, var_8);
    // return word ^ (word >> _SHIFT)                                                         <L 96>
    var_10 = wp::rshift(var_9, var_0);
    var_11 = wp::bit_xor(var_9, var_10);
    return var_11;
}


// /work/main/warpsample/sequences/hashing.py:117
static wp::uint32 swap_halves_0(
    wp::uint32 var_word)
{
    //---------
    // primal vars
    const wp::uint32 var_0 = 16u;
    wp::uint32 var_1;
    wp::uint32 var_2;
    wp::uint32 var_3;
    //---------
    // forward
    // def swap_halves(word: wp.uint32) -> wp.uint32:                                         <L 118>
    // return (word << _SHIFT) | (word >> _SHIFT)                                             <L 120>
    var_1 = wp::lshift(var_word, var_0);
    var_2 = wp::rshift(var_word, var_0);
    var_3 = wp::bit_or(var_1, var_2);
    return var_3;
}


// /work/main/warpsample/sequences/hashing.py:123
static wp::vec_t<4, wp::uint32> premixed_key_0(
    wp::vec_t<4, wp::uint32> var_run,
    wp::uint32 var_low)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::uint32 var_1;
    wp::uint32 var_2;
    wp::uint32 var_3;
    const wp::int32 var_4 = 1;
    wp::uint32 var_5;
    wp::uint32 var_6;
    wp::uint32 var_7;
    const wp::int32 var_8 = 2;
    wp::uint32 var_9;
    wp::uint32 var_10;
    const wp::int32 var_11 = 3;
    wp::uint32 var_12;
    wp::vec_t<4, wp::uint32> var_13;
    //---------
    // forward
    // def premixed_key(run: wp.vec4ui, low: wp.uint32) -> wp.vec4ui:                         <L 124>
    // word = finalise(low ^ run[0])                                                          <L 129>
    var_1 = wp::extract(var_run, var_0);
    var_2 = wp::bit_xor(var_low, var_1);
    var_3 = finalise_0(var_2);
    // return wp.vec4ui(word, run[1] + swap_halves(word), run[2] + word, run[3])              <L 130>
    var_5 = wp::extract(var_run, var_4);
    var_6 = swap_halves_0(var_3);
    var_7 = wp::add(var_5, var_6);
    var_9 = wp::extract(var_run, var_8);
    var_10 = wp::add(var_9, var_3);
    var_12 = wp::extract(var_run, var_11);
    var_13 = wp::vec_t<4, wp::uint32>(var_3, var_7, var_10, var_12);
    return var_13;
}


// /work/main/warpsample/sequences/hashing.py:65
static wp::vec_t<4, wp::uint32> pcg4d_0(
    wp::uint32 var_x,
    wp::uint32 var_y,
    wp::uint32 var_z,
    wp::uint32 var_w)
{
    //---------
    // primal vars
    const wp::uint32 var_0 = 1664525u;
    wp::uint32 var_1;
    const wp::uint32 var_2 = 1013904223u;
    wp::uint32 var_3;
    wp::uint32 var_4;
    wp::uint32 var_5;
    wp::uint32 var_6;
    wp::uint32 var_7;
    wp::uint32 var_8;
    wp::uint32 var_9;
    wp::uint32 var_10;
    wp::uint32 var_11;
    wp::uint32 var_12;
    wp::uint32 var_13;
    wp::uint32 var_14;
    wp::uint32 var_15;
    wp::uint32 var_16;
    wp::uint32 var_17;
    const wp::uint32 var_18 = 16u;
    wp::uint32 var_19;
    wp::uint32 var_20;
    wp::uint32 var_21;
    wp::uint32 var_22;
    wp::uint32 var_23;
    wp::uint32 var_24;
    wp::uint32 var_25;
    wp::uint32 var_26;
    wp::uint32 var_27;
    wp::uint32 var_28;
    wp::uint32 var_29;
    wp::uint32 var_30;
    wp::uint32 var_31;
    wp::uint32 var_32;
    wp::uint32 var_33;
    wp::uint32 var_34;
    wp::vec_t<4, wp::uint32> var_35;
    //---------
    // forward
    // def pcg4d(x: wp.uint32, y: wp.uint32, z: wp.uint32, w: wp.uint32) -> wp.vec4ui:        <L 66>
    // x = x * _MULTIPLIER + _INCREMENT                                                       <L 72>
    var_1 = wp::mul(var_x, var_0);
    var_3 = wp::add(var_1, var_2);
    // y = y * _MULTIPLIER + _INCREMENT                                                       <L 73>
    var_4 = wp::mul(var_y, var_0);
    var_5 = wp::add(var_4, var_2);
    // z = z * _MULTIPLIER + _INCREMENT                                                       <L 74>
    var_6 = wp::mul(var_z, var_0);
    var_7 = wp::add(var_6, var_2);
    // w = w * _MULTIPLIER + _INCREMENT                                                       <L 75>
    var_8 = wp::mul(var_w, var_0);
    var_9 = wp::add(var_8, var_2);
    // x += y * w                                                                             <L 76>
    var_10 = wp::mul(var_5, var_9);
    var_11 = wp::add(var_3, var_10);
    // y += z * x                                                                             <L 77>
    var_12 = wp::mul(var_7, var_11);
    var_13 = wp::add(var_5, var_12);
    // z += x * y                                                                             <L 78>
    var_14 = wp::mul(var_11, var_13);
    var_15 = wp::add(var_7, var_14);
    // w += y * z                                                                             <L 79>
    var_16 = wp::mul(var_13, var_15);
    var_17 = wp::add(var_9, var_16);
    // x = x ^ (x >> _SHIFT)                                                                  <L 80>
    var_19 = wp::rshift(var_11, var_18);
    var_20 = wp::bit_xor(var_11, var_19);
    // y = y ^ (y >> _SHIFT)                                                                  <L 81>
    var_21 = wp::rshift(var_13, var_18);
    var_22 = wp::bit_xor(var_13, var_21);
    // z = z ^ (z >> _SHIFT)                                                                  <L 82>
    var_23 = wp::rshift(var_15, var_18);
    var_24 = wp::bit_xor(var_15, var_23);
    // w = w ^ (w >> _SHIFT)                                                                  <L 83>
    var_25 = wp::rshift(var_17, var_18);
    var_26 = wp::bit_xor(var_17, var_25);
    // x += y * w                                                                             <L 84>
    var_27 = wp::mul(var_22, var_26);
    var_28 = wp::add(var_20, var_27);
    // y += z * x                                                                             <L 85>
    var_29 = wp::mul(var_24, var_28);
    var_30 = wp::add(var_22, var_29);
    // z += x * y                                                                             <L 86>
    var_31 = wp::mul(var_28, var_30);
    var_32 = wp::add(var_24, var_31);
    // w += y * z                                                                             <L 87>
    var_33 = wp::mul(var_30, var_32);
    var_34 = wp::add(var_26, var_33);
    // return wp.vec4ui(x, y, z, w)                                                           <L 88>
    var_35 = wp::vec_t<4, wp::uint32>(var_28, var_30, var_32, var_34);
    return var_35;
}


// /work/main/warpsample/sequences/hashing.py:133
static wp::vec_t<4, wp::uint32> mixed_key_0(
    wp::vec_t<4, wp::uint32> var_run,
    wp::uint32 var_low)
{
    //---------
    // primal vars
    wp::vec_t<4, wp::uint32> var_0;
    const wp::int32 var_1 = 0;
    wp::uint32 var_2;
    const wp::int32 var_3 = 1;
    wp::uint32 var_4;
    const wp::int32 var_5 = 2;
    wp::uint32 var_6;
    const wp::int32 var_7 = 3;
    wp::uint32 var_8;
    wp::vec_t<4, wp::uint32> var_9;
    //---------
    // forward
    // def mixed_key(run: wp.vec4ui, low: wp.uint32) -> wp.vec4ui:                            <L 134>
    // key = premixed_key(run, low)                                                           <L 136>
    var_0 = premixed_key_0(var_run, var_low);
    // return pcg4d(key[0], key[1], key[2], key[3])                                           <L 137>
    var_2 = wp::extract(var_0, var_1);
    var_4 = wp::extract(var_0, var_3);
    var_6 = wp::extract(var_0, var_5);
    var_8 = wp::extract(var_0, var_7);
    var_9 = pcg4d_0(var_2, var_4, var_6, var_8);
    return var_9;
}


// /work/main/warpsample/sequences/hashing.py:140
static wp::vec_t<4, wp::uint32> point_key_0(
    wp::uint64 var_seed,
    wp::uint64 var_point)
{
    //---------
    // primal vars
    wp::uint32 var_0;
    wp::vec_t<4, wp::uint32> var_1;
    wp::uint32 var_2;
    wp::vec_t<4, wp::uint32> var_3;
    //---------
    // forward
    // def point_key(seed: wp.uint64, point: wp.uint64) -> wp.vec4ui:                         <L 141>
    // return mixed_key(run_key(seed, high_word(point)), low_word(point))                     <L 143>
    var_0 = high_word_0(var_point);
    var_1 = run_key_0(var_seed, var_0);
    var_2 = low_word_0(var_point);
    var_3 = mixed_key_0(var_1, var_2);
    return var_3;
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


// /work/main/warpsample/tracing/sight/point.py:136
static wp::vec_t<3, wp::float32> _origin_0(
    Placement_e6d83c4e var_placement,
    ShadingPoint_241c3e67 var_point,
    wp::int32 var_sides)
{
    //---------
    // primal vars
    bool var_0;
    wp::uint64* var_1;
    wp::uint64 var_2;
    bool var_3;
    wp::uint64 var_4;
    const wp::int32 var_5 = 1;
    bool var_6;
    wp::uint64* var_7;
    wp::int64* var_8;
    wp::vec_t<3, wp::float32> var_9;
    wp::uint64 var_10;
    wp::int64 var_11;
    wp::uint64* var_12;
    wp::int64* var_13;
    wp::vec_t<3, wp::float32> var_14;
    wp::uint64 var_15;
    wp::int64 var_16;
    wp::vec_t<3, wp::float32>* var_17;
    wp::float32 var_18;
    wp::vec_t<3, wp::float32> var_19;
    wp::uint64* var_20;
    wp::uint64 var_21;
    bool var_22;
    wp::uint64 var_23;
    wp::uint64* var_24;
    wp::int64 var_25;
    wp::int64* var_26;
    wp::int64 var_27;
    wp::int64 var_28;
    const wp::float32 var_29 = 0.0;
    bool var_30;
    wp::int64 var_31;
    wp::int64 var_32;
    wp::int64 var_33;
    wp::int64 var_34;
    wp::vec_t<3, wp::float32> var_35;
    wp::uint64 var_36;
    wp::vec_t<3, wp::float64>* var_37;
    wp::vec_t<3, wp::float32> var_38;
    wp::vec_t<3, wp::float64> var_39;
    wp::float32 var_40;
    wp::float32 var_41;
    wp::vec_t<3, wp::float32> var_42;
    wp::vec_t<3, wp::float32> var_43;
    //---------
    // forward
    // def _origin(placement: Placement, point: ShadingPoint, sides: wp.int32) -> wp.vec3:       <L 137>
    // if placement.starts != wp.uint64(0) and sides == 1:                                    <L 139>
    var_1 = &((var_placement).starts);
    var_2 = 0ull;
    var_4 = wp::load(var_1);
    var_3 = (var_4 != var_2);
    var_0 = var_3;
    if (var_0) {
        var_6 = (var_sides == var_5);
        var_0 = var_0 && var_6;
    }
    if (var_0) {
        // return vec3_at(placement.starts, point.index)                                      <L 140>
        var_7 = &((var_placement).starts);
        var_8 = &((var_point).index);
        var_10 = wp::load(var_7);
        var_11 = wp::load(var_8);
        var_9 = _reader__locals__read_5(var_10, var_11);
        return var_9;
    }
    // side = vec3_at(placement.normals, point.index)                                         <L 141>
    var_12 = &((var_placement).normals);
    var_13 = &((var_point).index);
    var_15 = wp::load(var_12);
    var_16 = wp::load(var_13);
    var_14 = _reader__locals__read_5(var_15, var_16);
    // forward = wp.dot(side, point.n)                                                        <L 142>
    var_17 = &((var_point).n);
    var_19 = wp::load(var_17);
    var_18 = wp::dot(var_14, var_19);
    // if placement.starts != wp.uint64(0):                                                   <L 143>
    var_20 = &((var_placement).starts);
    var_21 = 0ull;
    var_23 = wp::load(var_20);
    var_22 = (var_23 != var_21);
    if (var_22) {
        // return vec3_at(placement.starts, wp.int64(2) * point.index + wp.where(forward < 0.0, wp.int64(1), wp.int64(0)))       <L 144>
        var_24 = &((var_placement).starts);
        var_25 = 2ll;
        var_26 = &((var_point).index);
        var_28 = wp::load(var_26);
        var_27 = wp::mul(var_25, var_28);
        var_30 = (var_18 < var_29);
        var_31 = 1ll;
        var_32 = 0ll;
        var_33 = wp::where(var_30, var_31, var_32);
        var_34 = wp::add(var_27, var_33);
        var_36 = wp::load(var_24);
        var_35 = _reader__locals__read_5(var_36, var_34);
        return var_35;
    }
    // return wp.vec3(point.position) + wp.copysign(origin_offset(placement, side), forward) * side       <L 145>
    var_37 = &((var_point).position);
    var_39 = wp::load(var_37);
    var_38 = wp::vec_t<3, wp::float32>(var_39);
    var_40 = origin_offset_0(var_placement, var_14);
    var_41 = wp::copysign(var_40, var_18);
    var_42 = wp::mul(var_41, var_14);
    var_43 = wp::add(var_38, var_42);
    return var_43;
}


// /work/main/warpsample/tracing/placement.py:149
static wp::float32 reach_along_0(
    Placement_e6d83c4e var_placement,
    wp::vec_t<3, wp::float32> var_n,
    wp::vec_t<3, wp::float32> var_o)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float32>* var_0;
    wp::vec_t<3, wp::float32> var_1;
    wp::vec_t<3, wp::float32> var_2;
    wp::vec_t<3, wp::float32> var_3;
    wp::float32 var_4;
    //---------
    // forward
    // def reach_along(placement: Placement, n: wp.vec3, o: wp.vec3) -> wp.float32:           <L 150>
    // return extent_along(wp.max(placement.extent, wp.abs(o)), n)                            <L 152>
    var_0 = &((var_placement).extent);
    var_1 = wp::abs(var_o);
    var_3 = wp::load(var_0);
    var_2 = wp::max(var_3, var_1);
    var_4 = extent_along_0(var_2, var_n);
    return var_4;
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


// /work/main/warpsample/tracing/queries.py:86
static void start_all_0(
    wp::uint64 var_chunk,
    wp::vec_t<3, wp::float32> var_o,
    wp::float32 var_reach)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 1664;
    wp::tuple_t<wp::int32> var_1;
    wp::array_t<wp::float32> var_2;
    const wp::int32 var_3 = 1664;
    const wp::int32 var_4 = 0;
    wp::int32 var_5;
    const wp::int32 var_6 = 64;
    bool var_7;
    const wp::int32 var_8 = 384;
    wp::int32 var_9;
    const wp::int32 var_10 = 1;
    wp::int32 var_11;
    //---------
    // forward
    // def start_all(chunk: wp.uint64, o: wp.vec3, reach: wp.float32):                        <L 87>
    // rows = wp.array(ptr=chunk, shape=(CHUNK_FLOATS,), dtype=wp.float32)                    <L 89>
    var_1 = wp::tuple(var_0);
    var_2 = wp::array_t<wp::float32>(var_chunk, var_3);
    // k = wp.int32(0)                                                                        <L 90>
    var_5 = wp::int32(var_4);
    // while k < CHUNK:                                                                       <L 91>
    start_while_0:;
    var_7 = (var_5 < var_6);
    if ((var_7) == false) goto end_while_0;
        // set_origin(chunk, k, o)                                                            <L 92>
        set_origin_0(var_chunk, var_5, var_o);
        // rows[REACH + k] = reach                                                            <L 93>
        var_9 = wp::add(var_8, var_5);
        wp::array_store(var_2, var_9, var_reach);
        // k += 1                                                                             <L 94>
        var_11 = wp::add(var_5, var_10);
        wp::assign(var_5, var_11);
    goto start_while_0;
    end_while_0:;
}


// /work/main/warpsample/tracing/sight/point.py:148
static ShadingPoint_241c3e67 place_point_0(
    ShadingPoint_241c3e67 var_point,
    Placement_e6d83c4e var_placement,
    wp::int32 var_sides)
{
    //---------
    // primal vars
    wp::int64* var_0;
    wp::vec_t<3, wp::float64> var_1;
    wp::int64 var_2;
    wp::vec_t<3, wp::float32> var_3;
    const wp::float32 var_4 = 9.5367431640625e-07;
    wp::vec_t<3, wp::float32>* var_5;
    wp::vec_t<3, wp::float32>* var_6;
    wp::float32 var_7;
    wp::vec_t<3, wp::float32> var_8;
    wp::vec_t<3, wp::float32> var_9;
    wp::float32 var_10;
    wp::float64* var_11;
    wp::float32 var_12;
    wp::float64 var_13;
    bool var_14;
    wp::int32* var_15;
    const wp::int32 var_16 = 0;
    bool var_17;
    wp::int32 var_18;
    wp::vec_t<3, wp::float64>* var_19;
    wp::vec_t<3, wp::float64>* var_20;
    wp::vec_t<3, wp::float64> var_21;
    wp::vec_t<3, wp::float64> var_22;
    wp::vec_t<3, wp::float64> var_23;
    wp::vec_t<3, wp::float64>* var_24;
    wp::vec_t<3, wp::float64>* var_25;
    wp::vec_t<3, wp::float64> var_26;
    wp::vec_t<3, wp::float64> var_27;
    wp::vec_t<3, wp::float64> var_28;
    wp::float64 var_29;
    const wp::float64 var_30 = 0.0;
    bool var_31;
    const wp::int32 var_32 = 4;
    wp::uint64* var_33;
    wp::vec_t<3, wp::float32>* var_34;
    wp::float32* var_35;
    wp::uint64 var_36;
    wp::vec_t<3, wp::float32> var_37;
    wp::float32 var_38;
    //---------
    // forward
    // def place_point(point: ShadingPoint, placement: Placement, sides: wp.int32) -> ShadingPoint:       <L 149>
    // point.position = local_origin(placement, point.index)                                  <L 154>
    var_0 = &((var_point).index);
    var_2 = wp::load(var_0);
    var_1 = local_origin_0(var_placement, var_2);
    var_point.position = var_1;
    // point.o = _origin(placement, point, sides)                                             <L 155>
    var_3 = _origin_0(var_placement, var_point, var_sides);
    var_point.o = var_3;
    // point.low = HORIZON_MARGIN * reach_along(placement, point.n, point.o)                  <L 156>
    var_5 = &((var_point).n);
    var_6 = &((var_point).o);
    var_8 = wp::load(var_5);
    var_9 = wp::load(var_6);
    var_7 = reach_along_0(var_placement, var_8, var_9);
    var_10 = wp::mul(var_4, var_7);
    var_point.low = var_10;
    // point.reach = wp.float32(placement.reach)                                              <L 157>
    var_11 = &((var_placement).reach);
    var_13 = wp::load(var_11);
    var_12 = wp::float32(var_13);
    var_point.reach = var_12;
    // if point.status == 0 and wp.dot(point.position - point.position, point.position - point.position) != ZERO:       <L 158>
    var_15 = &((var_point).status);
    var_18 = wp::load(var_15);
    var_17 = (var_18 == var_16);
    var_14 = var_17;
    if (var_14) {
        var_19 = &((var_point).position);
        var_20 = &((var_point).position);
        var_22 = wp::load(var_19);
        var_23 = wp::load(var_20);
        var_21 = wp::sub(var_22, var_23);
        var_24 = &((var_point).position);
        var_25 = &((var_point).position);
        var_27 = wp::load(var_24);
        var_28 = wp::load(var_25);
        var_26 = wp::sub(var_27, var_28);
        var_29 = wp::dot(var_21, var_26);
        var_31 = (var_29 != var_30);
        var_14 = var_14 && var_31;
    }
    if (var_14) {
        // point.status = NONFINITE_POSITION                                                  <L 159>
        var_point.status = var_32;
    }
    // start_all(point.chunk, point.o, point.reach)                                           <L 160>
    var_33 = &((var_point).chunk);
    var_34 = &((var_point).o);
    var_35 = &((var_point).reach);
    var_36 = wp::load(var_33);
    var_37 = wp::load(var_34);
    var_38 = wp::load(var_35);
    start_all_0(var_36, var_37, var_38);
    // return point                                                                           <L 161>
    return var_point;
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


// /work/main/warpsample/tracing/sight/leaves.py:20
static void clear_leaf_0(
    wp::uint64 var_leaf)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 160;
    const wp::float32 var_1 = 0.0;
    //---------
    // forward
    // def clear_leaf(leaf: wp.uint64):                                                       <L 21>
    // set_float(leaf, _LONGEST, 0.0)                                                         <L 23>
    _writer__locals__write_0(var_leaf, var_0, var_1);
}


// /work/main/warpsample/tracing/sight/frontier.py:45
static wp::float32 limit_of_boxes_0(
    wp::float32 var_limit,
    wp::vec_t<3, wp::float32> var_n)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 7.62939453125e-06;
    const wp::int32 var_1 = 0;
    wp::float32 var_2;
    wp::float32 var_3;
    const wp::int32 var_4 = 1;
    wp::float32 var_5;
    wp::float32 var_6;
    wp::float32 var_7;
    const wp::int32 var_8 = 2;
    wp::float32 var_9;
    wp::float32 var_10;
    wp::float32 var_11;
    wp::float32 var_12;
    wp::float32 var_13;
    //---------
    // forward
    // def limit_of_boxes(limit: wp.float32, n: wp.vec3) -> wp.float32:                       <L 46>
    // return limit + _PADDING * (wp.abs(n[0]) + wp.abs(n[1]) + wp.abs(n[2]))                 <L 48>
    var_2 = wp::extract(var_n, var_1);
    var_3 = wp::abs(var_2);
    var_5 = wp::extract(var_n, var_4);
    var_6 = wp::abs(var_5);
    var_7 = wp::add(var_3, var_6);
    var_9 = wp::extract(var_n, var_8);
    var_10 = wp::abs(var_9);
    var_11 = wp::add(var_7, var_10);
    var_12 = wp::mul(var_0, var_11);
    var_13 = wp::add(var_limit, var_12);
    return var_13;
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


// /work/main/warpsample/tracing/sight/frontier.py:39
static wp::float32 _distance_to_interval_0(
    wp::float32 var_low,
    wp::float32 var_high,
    wp::float32 var_x)
{
    //---------
    // primal vars
    wp::float32 var_0;
    wp::float32 var_1;
    wp::float32 var_2;
    const wp::float32 var_3 = 0.0;
    wp::float32 var_4;
    //---------
    // forward
    // def _distance_to_interval(low: wp.float32, high: wp.float32, x: wp.float32) -> wp.float32:       <L 40>
    // return greater(greater(low - x, x - high), 0.0)                                        <L 42>
    var_0 = wp::sub(var_low, var_x);
    var_1 = wp::sub(var_x, var_high);
    var_2 = greater_0(var_0, var_1);
    var_4 = greater_0(var_2, var_3);
    return var_4;
}


// /work/main/warpsample/tracing/sight/frontier.py:51
static void visible_children_0(
    wp::uint64 var_node,
    wp::vec_t<3, wp::float32> var_o,
    wp::vec_t<3, wp::float32> var_n,
    wp::float32 var_limit,
    wp::float32 var_reach,
    wp::int32 & ret_0,
    wp::int32 & ret_1)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 128;
    wp::tuple_t<wp::int32> var_1;
    wp::array_t<wp::float32> var_2;
    const wp::int32 var_3 = 128;
    const wp::int32 var_4 = 4;
    const wp::int32 var_5 = 96;
    wp::int32 var_6;
    wp::uint64 var_7;
    wp::uint64 var_8;
    const wp::int32 var_9 = 16;
    wp::tuple_t<wp::int32> var_10;
    wp::array_t<wp::int32> var_11;
    const wp::int32 var_12 = 16;
    const wp::int32 var_13 = 0;
    wp::int32 var_14;
    const wp::int32 var_15 = 0;
    wp::int32 var_16;
    const wp::int32 var_17 = 0;
    wp::int32 var_18;
    bool var_19;
    const wp::int32 var_20 = 0;
    wp::float32 var_21;
    const wp::float32 var_22 = 0.0;
    bool var_23;
    const wp::int32 var_24 = 3;
    wp::int32 var_25;
    wp::int32 var_26;
    wp::float32* var_27;
    wp::float32* var_28;
    wp::float32 var_29;
    wp::float32 var_30;
    wp::float32 var_31;
    const wp::int32 var_32 = 1;
    wp::float32 var_33;
    const wp::float32 var_34 = 0.0;
    bool var_35;
    const wp::int32 var_36 = 4;
    wp::int32 var_37;
    wp::int32 var_38;
    wp::float32* var_39;
    wp::int32 var_40;
    wp::float32* var_41;
    wp::float32 var_42;
    wp::float32 var_43;
    wp::float32 var_44;
    const wp::int32 var_45 = 2;
    wp::float32 var_46;
    const wp::float32 var_47 = 0.0;
    bool var_48;
    const wp::int32 var_49 = 5;
    wp::int32 var_50;
    wp::int32 var_51;
    wp::float32* var_52;
    const wp::int32 var_53 = 2;
    wp::int32 var_54;
    wp::int32 var_55;
    wp::float32* var_56;
    wp::float32 var_57;
    wp::float32 var_58;
    wp::float32 var_59;
    const wp::int32 var_60 = 0;
    wp::float32 var_61;
    const wp::int32 var_62 = 1;
    wp::float32 var_63;
    const wp::int32 var_64 = 2;
    wp::float32 var_65;
    wp::float32 var_66;
    wp::float32 var_67;
    wp::float32 var_68;
    bool var_69;
    const wp::int32 var_70 = 1;
    const wp::int32 var_71 = 0;
    wp::int32 var_72;
    wp::float32* var_73;
    const wp::int32 var_74 = 3;
    wp::int32 var_75;
    wp::int32 var_76;
    wp::float32* var_77;
    const wp::int32 var_78 = 0;
    wp::float32 var_79;
    wp::float32 var_80;
    wp::float32 var_81;
    wp::float32 var_82;
    wp::int32 var_83;
    wp::float32* var_84;
    const wp::int32 var_85 = 4;
    wp::int32 var_86;
    wp::int32 var_87;
    wp::float32* var_88;
    const wp::int32 var_89 = 1;
    wp::float32 var_90;
    wp::float32 var_91;
    wp::float32 var_92;
    wp::float32 var_93;
    const wp::int32 var_94 = 2;
    wp::int32 var_95;
    wp::int32 var_96;
    wp::float32* var_97;
    const wp::int32 var_98 = 5;
    wp::int32 var_99;
    wp::int32 var_100;
    wp::float32* var_101;
    const wp::int32 var_102 = 2;
    wp::float32 var_103;
    wp::float32 var_104;
    wp::float32 var_105;
    wp::float32 var_106;
    wp::float32 var_107;
    wp::float32 var_108;
    wp::float32 var_109;
    wp::float32 var_110;
    bool var_111;
    const wp::int32 var_112 = 1;
    const wp::int32 var_113 = 0;
    wp::int32 var_114;
    wp::int32 var_115;
    wp::int32* var_116;
    const wp::int32 var_117 = 0;
    bool var_118;
    wp::int32 var_119;
    const wp::int32 var_120 = 1;
    const wp::int32 var_121 = 0;
    wp::int32 var_122;
    wp::int32 var_123;
    wp::int32 var_124;
    wp::int32 var_125;
    const wp::float32 var_126 = 0.0;
    bool var_127;
    const wp::int32 var_128 = 1;
    const wp::int32 var_129 = 0;
    wp::int32 var_130;
    wp::int32 var_131;
    wp::int32 var_132;
    const wp::int32 var_133 = 1;
    wp::int32 var_134;
    //---------
    // forward
    // def visible_children(node: wp.uint64, o: wp.vec3, n: wp.vec3, limit: wp.float32, reach: wp.float32):       <L 52>
    // rows = wp.array(ptr=node, shape=(_NODE_FLOATS,), dtype=wp.float32)                     <L 57>
    var_1 = wp::tuple(var_0);
    var_2 = wp::array_t<wp::float32>(var_node, var_3);
    // links = wp.array(ptr=node + wp.uint64(4 * LINKS), shape=(WIDTH,), dtype=wp.int32)       <L 58>
    var_6 = wp::mul(var_4, var_5);
    var_7 = wp::uint64(var_6);
    var_8 = wp::add(var_node, var_7);
    var_10 = wp::tuple(var_9);
    var_11 = wp::array_t<wp::int32>(var_8, var_12);
    // visible_children = wp.int32(0)                                                         <L 59>
    var_14 = wp::int32(var_13);
    // around = wp.int32(0)                                                                   <L 60>
    var_16 = wp::int32(var_15);
    // k = wp.int32(0)                                                                        <L 61>
    var_18 = wp::int32(var_17);
    // while k < WIDTH:                                                                       <L 62>
    start_while_0:;
    var_19 = (var_18 < var_9);
    if ((var_19) == false) goto end_while_0;
        // x = wp.where(n[0] > 0.0, rows[3 * WIDTH + k], rows[k])                             <L 63>
        var_21 = wp::extract(var_n, var_20);
        var_23 = (var_21 > var_22);
        var_25 = wp::mul(var_24, var_9);
        var_26 = wp::add(var_25, var_18);
        var_27 = wp::address(var_2, var_26);
        var_28 = wp::address(var_2, var_18);
        var_30 = wp::load(var_27);
        var_31 = wp::load(var_28);
        var_29 = wp::where(var_23, var_30, var_31);
        // y = wp.where(n[1] > 0.0, rows[4 * WIDTH + k], rows[WIDTH + k])                     <L 64>
        var_33 = wp::extract(var_n, var_32);
        var_35 = (var_33 > var_34);
        var_37 = wp::mul(var_36, var_9);
        var_38 = wp::add(var_37, var_18);
        var_39 = wp::address(var_2, var_38);
        var_40 = wp::add(var_9, var_18);
        var_41 = wp::address(var_2, var_40);
        var_43 = wp::load(var_39);
        var_44 = wp::load(var_41);
        var_42 = wp::where(var_35, var_43, var_44);
        // z = wp.where(n[2] > 0.0, rows[5 * WIDTH + k], rows[2 * WIDTH + k])                 <L 65>
        var_46 = wp::extract(var_n, var_45);
        var_48 = (var_46 > var_47);
        var_50 = wp::mul(var_49, var_9);
        var_51 = wp::add(var_50, var_18);
        var_52 = wp::address(var_2, var_51);
        var_54 = wp::mul(var_53, var_9);
        var_55 = wp::add(var_54, var_18);
        var_56 = wp::address(var_2, var_55);
        var_58 = wp::load(var_52);
        var_59 = wp::load(var_56);
        var_57 = wp::where(var_48, var_58, var_59);
        // above = wp.where(fma(x, n[0], fma(y, n[1], z * n[2])) >= limit, 1, 0)              <L 66>
        var_61 = wp::extract(var_n, var_60);
        var_63 = wp::extract(var_n, var_62);
        var_65 = wp::extract(var_n, var_64);
        var_66 = wp::mul(var_57, var_65);
        var_67 = fma_0(var_42, var_63, var_66);
        var_68 = fma_0(var_29, var_61, var_67);
        var_69 = (var_68 >= var_limit);
        var_72 = wp::where(var_69, var_70, var_71);
        // dx = _distance_to_interval(rows[k], rows[3 * WIDTH + k], o[0])                     <L 67>
        var_73 = wp::address(var_2, var_18);
        var_75 = wp::mul(var_74, var_9);
        var_76 = wp::add(var_75, var_18);
        var_77 = wp::address(var_2, var_76);
        var_79 = wp::extract(var_o, var_78);
        var_81 = wp::load(var_73);
        var_82 = wp::load(var_77);
        var_80 = _distance_to_interval_0(var_81, var_82, var_79);
        // dy = _distance_to_interval(rows[WIDTH + k], rows[4 * WIDTH + k], o[1])             <L 68>
        var_83 = wp::add(var_9, var_18);
        var_84 = wp::address(var_2, var_83);
        var_86 = wp::mul(var_85, var_9);
        var_87 = wp::add(var_86, var_18);
        var_88 = wp::address(var_2, var_87);
        var_90 = wp::extract(var_o, var_89);
        var_92 = wp::load(var_84);
        var_93 = wp::load(var_88);
        var_91 = _distance_to_interval_0(var_92, var_93, var_90);
        // dz = _distance_to_interval(rows[2 * WIDTH + k], rows[5 * WIDTH + k], o[2])         <L 69>
        var_95 = wp::mul(var_94, var_9);
        var_96 = wp::add(var_95, var_18);
        var_97 = wp::address(var_2, var_96);
        var_99 = wp::mul(var_98, var_9);
        var_100 = wp::add(var_99, var_18);
        var_101 = wp::address(var_2, var_100);
        var_103 = wp::extract(var_o, var_102);
        var_105 = wp::load(var_97);
        var_106 = wp::load(var_101);
        var_104 = _distance_to_interval_0(var_105, var_106, var_103);
        // apart = wp.sqrt(fma(dx, dx, fma(dy, dy, dz * dz)))                                 <L 70>
        var_107 = wp::mul(var_104, var_104);
        var_108 = fma_0(var_91, var_91, var_107);
        var_109 = fma_0(var_80, var_80, var_108);
        var_110 = wp::sqrt(var_109);
        // visible_children = visible_children | ((above & wp.where(apart < reach, 1, 0) & wp.where(links[k] != 0, 1, 0)) << k)       <L 71>
        var_111 = (var_110 < var_reach);
        var_114 = wp::where(var_111, var_112, var_113);
        var_115 = wp::bit_and(var_72, var_114);
        var_116 = wp::address(var_11, var_18);
        var_119 = wp::load(var_116);
        var_118 = (var_119 != var_117);
        var_122 = wp::where(var_118, var_120, var_121);
        var_123 = wp::bit_and(var_115, var_122);
        var_124 = wp::lshift(var_123, var_18);
        var_125 = wp::bit_or(var_14, var_124);
        // around = around | (wp.where(apart == 0.0, 1, 0) << k)                              <L 72>
        var_127 = (var_110 == var_126);
        var_130 = wp::where(var_127, var_128, var_129);
        var_131 = wp::lshift(var_130, var_18);
        var_132 = wp::bit_or(var_16, var_131);
        // k += 1                                                                             <L 73>
        var_134 = wp::add(var_18, var_133);
        wp::assign(var_14, var_125);
        wp::assign(var_16, var_132);
        wp::assign(var_18, var_134);
    goto start_while_0;
    end_while_0:;
    // return visible_children, around                                                        <L 74>
    ret_0 = var_14;
    ret_1 = var_16;
    return;
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


// /work/main/warpsample/tracing/wide/layout.py:68
static wp::float32 highest_corner_0(
    wp::uint64 var_leaf,
    wp::int32 var_k,
    wp::float32 var_nx,
    wp::float32 var_ny,
    wp::float32 var_nz)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 160;
    wp::tuple_t<wp::int32> var_1;
    wp::array_t<wp::float32> var_2;
    const wp::int32 var_3 = 160;
    wp::float32* var_4;
    const wp::int32 var_5 = 16;
    wp::int32 var_6;
    wp::float32* var_7;
    const wp::int32 var_8 = 2;
    wp::int32 var_9;
    wp::int32 var_10;
    wp::float32* var_11;
    wp::float32 var_12;
    wp::float32 var_13;
    wp::float32 var_14;
    wp::float32 var_15;
    wp::float32 var_16;
    wp::float32 var_17;
    const wp::int32 var_18 = 3;
    wp::int32 var_19;
    wp::int32 var_20;
    wp::float32* var_21;
    const wp::int32 var_22 = 4;
    wp::int32 var_23;
    wp::int32 var_24;
    wp::float32* var_25;
    const wp::int32 var_26 = 5;
    wp::int32 var_27;
    wp::int32 var_28;
    wp::float32* var_29;
    wp::float32 var_30;
    wp::float32 var_31;
    wp::float32 var_32;
    wp::float32 var_33;
    wp::float32 var_34;
    wp::float32 var_35;
    const wp::int32 var_36 = 6;
    wp::int32 var_37;
    wp::int32 var_38;
    wp::float32* var_39;
    const wp::int32 var_40 = 7;
    wp::int32 var_41;
    wp::int32 var_42;
    wp::float32* var_43;
    const wp::int32 var_44 = 8;
    wp::int32 var_45;
    wp::int32 var_46;
    wp::float32* var_47;
    wp::float32 var_48;
    wp::float32 var_49;
    wp::float32 var_50;
    wp::float32 var_51;
    wp::float32 var_52;
    wp::float32 var_53;
    wp::float32 var_54;
    wp::float32 var_55;
    //---------
    // forward
    // def highest_corner(leaf: wp.uint64, k: wp.int32, nx: wp.float32, ny: wp.float32, nz: wp.float32) -> wp.float32:       <L 69>
    // rows = wp.array(ptr=leaf, shape=(_LEAF_FLOATS,), dtype=wp.float32)                     <L 71>
    var_1 = wp::tuple(var_0);
    var_2 = wp::array_t<wp::float32>(var_leaf, var_3);
    // a = fma(rows[k], nx, fma(rows[WIDTH + k], ny, rows[2 * WIDTH + k] * nz))               <L 72>
    var_4 = wp::address(var_2, var_k);
    var_6 = wp::add(var_5, var_k);
    var_7 = wp::address(var_2, var_6);
    var_9 = wp::mul(var_8, var_5);
    var_10 = wp::add(var_9, var_k);
    var_11 = wp::address(var_2, var_10);
    var_13 = wp::load(var_11);
    var_12 = wp::mul(var_13, var_nz);
    var_15 = wp::load(var_7);
    var_14 = fma_0(var_15, var_ny, var_12);
    var_17 = wp::load(var_4);
    var_16 = fma_0(var_17, var_nx, var_14);
    // b = fma(rows[3 * WIDTH + k], nx, fma(rows[4 * WIDTH + k], ny, rows[5 * WIDTH + k] * nz))       <L 73>
    var_19 = wp::mul(var_18, var_5);
    var_20 = wp::add(var_19, var_k);
    var_21 = wp::address(var_2, var_20);
    var_23 = wp::mul(var_22, var_5);
    var_24 = wp::add(var_23, var_k);
    var_25 = wp::address(var_2, var_24);
    var_27 = wp::mul(var_26, var_5);
    var_28 = wp::add(var_27, var_k);
    var_29 = wp::address(var_2, var_28);
    var_31 = wp::load(var_29);
    var_30 = wp::mul(var_31, var_nz);
    var_33 = wp::load(var_25);
    var_32 = fma_0(var_33, var_ny, var_30);
    var_35 = wp::load(var_21);
    var_34 = fma_0(var_35, var_nx, var_32);
    // c = fma(rows[6 * WIDTH + k], nx, fma(rows[7 * WIDTH + k], ny, rows[8 * WIDTH + k] * nz))       <L 74>
    var_37 = wp::mul(var_36, var_5);
    var_38 = wp::add(var_37, var_k);
    var_39 = wp::address(var_2, var_38);
    var_41 = wp::mul(var_40, var_5);
    var_42 = wp::add(var_41, var_k);
    var_43 = wp::address(var_2, var_42);
    var_45 = wp::mul(var_44, var_5);
    var_46 = wp::add(var_45, var_k);
    var_47 = wp::address(var_2, var_46);
    var_49 = wp::load(var_47);
    var_48 = wp::mul(var_49, var_nz);
    var_51 = wp::load(var_43);
    var_50 = fma_0(var_51, var_ny, var_48);
    var_53 = wp::load(var_39);
    var_52 = fma_0(var_53, var_nx, var_50);
    // return greater(greater(a, b), c)                                                       <L 75>
    var_54 = greater_0(var_16, var_34);
    var_55 = greater_0(var_54, var_52);
    return var_55;
}


// /work/main/warpsample/tracing/sight/frontier.py:77
static wp::int32 triangles_above_0(
    wp::uint64 var_leaf,
    wp::vec_t<3, wp::float32> var_n,
    wp::float32 var_limit)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    const wp::int32 var_2 = 0;
    wp::int32 var_3;
    const wp::int32 var_4 = 16;
    bool var_5;
    const wp::int32 var_6 = 0;
    wp::float32 var_7;
    const wp::int32 var_8 = 1;
    wp::float32 var_9;
    const wp::int32 var_10 = 2;
    wp::float32 var_11;
    wp::float32 var_12;
    bool var_13;
    const wp::int32 var_14 = 1;
    wp::int32 var_15;
    const wp::int32 var_16 = 0;
    wp::int32 var_17;
    wp::int32 var_18;
    const wp::int32 var_19 = 1;
    wp::int32 var_20;
    //---------
    // forward
    // def triangles_above(leaf: wp.uint64, n: wp.vec3, limit: wp.float32) -> wp.int32:       <L 78>
    // mask = wp.int32(0)                                                                     <L 80>
    var_1 = wp::int32(var_0);
    // k = wp.int32(0)                                                                        <L 81>
    var_3 = wp::int32(var_2);
    // while k < WIDTH:                                                                       <L 82>
    start_while_0:;
    var_5 = (var_3 < var_4);
    if ((var_5) == false) goto end_while_0;
        // mask = mask | wp.where(highest_corner(leaf, k, n[0], n[1], n[2]) >= limit, 1 << k, 0)       <L 83>
        var_7 = wp::extract(var_n, var_6);
        var_9 = wp::extract(var_n, var_8);
        var_11 = wp::extract(var_n, var_10);
        var_12 = highest_corner_0(var_leaf, var_3, var_7, var_9, var_11);
        var_13 = (var_12 >= var_limit);
        var_15 = wp::lshift(var_14, var_3);
        var_17 = wp::where(var_13, var_15, var_16);
        var_18 = wp::bit_or(var_1, var_17);
        // k += 1                                                                             <L 84>
        var_20 = wp::add(var_3, var_19);
        wp::assign(var_1, var_18);
        wp::assign(var_3, var_20);
    goto start_while_0;
    end_while_0:;
    // return mask                                                                            <L 85>
    return var_1;
}


// /work/main/warpsample/tracing/sight/leaves.py:26
static void raise_extent_0(
    wp::uint64 var_leaf,
    wp::float32 var_edge)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 160;
    wp::float32 var_1;
    wp::float32 var_2;
    //---------
    // forward
    // def raise_extent(leaf: wp.uint64, edge: wp.float32):                                   <L 27>
    // set_float(leaf, _LONGEST, greater(float_at(leaf, _LONGEST), edge))                     <L 29>
    var_1 = _reader__locals__read_0(var_leaf, var_0);
    var_2 = greater_0(var_1, var_edge);
    _writer__locals__write_0(var_leaf, var_0, var_2);
}


// /work/main/warpsample/tracing/sight/leaves.py:32
static void copy_triangle_0(
    wp::uint64 var_source,
    wp::int32 var_k,
    wp::uint64 var_leaf,
    wp::int32 var_lane)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    const wp::int32 var_1 = 16;
    wp::int32 var_2;
    wp::int32 var_3;
    wp::int32 var_4;
    wp::int32 var_5;
    wp::float32 var_6;
    const wp::int32 var_7 = 1;
    wp::int32 var_8;
    wp::int32 var_9;
    wp::int32 var_10;
    wp::int32 var_11;
    wp::float32 var_12;
    const wp::int32 var_13 = 2;
    wp::int32 var_14;
    wp::int32 var_15;
    wp::int32 var_16;
    wp::int32 var_17;
    wp::float32 var_18;
    const wp::int32 var_19 = 3;
    wp::int32 var_20;
    wp::int32 var_21;
    wp::int32 var_22;
    wp::int32 var_23;
    wp::float32 var_24;
    const wp::int32 var_25 = 4;
    wp::int32 var_26;
    wp::int32 var_27;
    wp::int32 var_28;
    wp::int32 var_29;
    wp::float32 var_30;
    const wp::int32 var_31 = 5;
    wp::int32 var_32;
    wp::int32 var_33;
    wp::int32 var_34;
    wp::int32 var_35;
    wp::float32 var_36;
    const wp::int32 var_37 = 6;
    wp::int32 var_38;
    wp::int32 var_39;
    wp::int32 var_40;
    wp::int32 var_41;
    wp::float32 var_42;
    const wp::int32 var_43 = 7;
    wp::int32 var_44;
    wp::int32 var_45;
    wp::int32 var_46;
    wp::int32 var_47;
    wp::float32 var_48;
    const wp::int32 var_49 = 8;
    wp::int32 var_50;
    wp::int32 var_51;
    wp::int32 var_52;
    wp::int32 var_53;
    wp::float32 var_54;
    const wp::int32 var_55 = 9;
    wp::int32 var_56;
    wp::int32 var_57;
    wp::int32 var_58;
    wp::int32 var_59;
    wp::float32 var_60;
    //---------
    // forward
    // def copy_triangle(source: wp.uint64, k: wp.int32, leaf: wp.uint64, lane: wp.int32):       <L 33>
    // for row in range(10):                                                                  <L 35>
    // set_float(leaf, row * WIDTH + lane, float_at(source, row * WIDTH + k))                 <L 36>
    var_2 = wp::mul(var_0, var_1);
    var_3 = wp::add(var_2, var_lane);
    var_4 = wp::mul(var_0, var_1);
    var_5 = wp::add(var_4, var_k);
    var_6 = _reader__locals__read_0(var_source, var_5);
    _writer__locals__write_0(var_leaf, var_3, var_6);
    var_8 = wp::mul(var_7, var_1);
    var_9 = wp::add(var_8, var_lane);
    var_10 = wp::mul(var_7, var_1);
    var_11 = wp::add(var_10, var_k);
    var_12 = _reader__locals__read_0(var_source, var_11);
    _writer__locals__write_0(var_leaf, var_9, var_12);
    var_14 = wp::mul(var_13, var_1);
    var_15 = wp::add(var_14, var_lane);
    var_16 = wp::mul(var_13, var_1);
    var_17 = wp::add(var_16, var_k);
    var_18 = _reader__locals__read_0(var_source, var_17);
    _writer__locals__write_0(var_leaf, var_15, var_18);
    var_20 = wp::mul(var_19, var_1);
    var_21 = wp::add(var_20, var_lane);
    var_22 = wp::mul(var_19, var_1);
    var_23 = wp::add(var_22, var_k);
    var_24 = _reader__locals__read_0(var_source, var_23);
    _writer__locals__write_0(var_leaf, var_21, var_24);
    var_26 = wp::mul(var_25, var_1);
    var_27 = wp::add(var_26, var_lane);
    var_28 = wp::mul(var_25, var_1);
    var_29 = wp::add(var_28, var_k);
    var_30 = _reader__locals__read_0(var_source, var_29);
    _writer__locals__write_0(var_leaf, var_27, var_30);
    var_32 = wp::mul(var_31, var_1);
    var_33 = wp::add(var_32, var_lane);
    var_34 = wp::mul(var_31, var_1);
    var_35 = wp::add(var_34, var_k);
    var_36 = _reader__locals__read_0(var_source, var_35);
    _writer__locals__write_0(var_leaf, var_33, var_36);
    var_38 = wp::mul(var_37, var_1);
    var_39 = wp::add(var_38, var_lane);
    var_40 = wp::mul(var_37, var_1);
    var_41 = wp::add(var_40, var_k);
    var_42 = _reader__locals__read_0(var_source, var_41);
    _writer__locals__write_0(var_leaf, var_39, var_42);
    var_44 = wp::mul(var_43, var_1);
    var_45 = wp::add(var_44, var_lane);
    var_46 = wp::mul(var_43, var_1);
    var_47 = wp::add(var_46, var_k);
    var_48 = _reader__locals__read_0(var_source, var_47);
    _writer__locals__write_0(var_leaf, var_45, var_48);
    var_50 = wp::mul(var_49, var_1);
    var_51 = wp::add(var_50, var_lane);
    var_52 = wp::mul(var_49, var_1);
    var_53 = wp::add(var_52, var_k);
    var_54 = _reader__locals__read_0(var_source, var_53);
    _writer__locals__write_0(var_leaf, var_51, var_54);
    var_56 = wp::mul(var_55, var_1);
    var_57 = wp::add(var_56, var_lane);
    var_58 = wp::mul(var_55, var_1);
    var_59 = wp::add(var_58, var_k);
    var_60 = _reader__locals__read_0(var_source, var_59);
    _writer__locals__write_0(var_leaf, var_57, var_60);
}


// /work/main/warpsample/tracing/sight/frontier.py:102
static wp::int32 _copy_to_local_leaf_0(
    wp::uint64 var_leaf,
    wp::vec_t<3, wp::float32> var_n,
    wp::float32 var_limit,
    wp::float32 var_edge,
    wp::uint64 var_local,
    wp::int32 var_triangles)
{
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int32 var_1;
    wp::int32 var_2;
    const wp::int32 var_3 = 16;
    bool var_4;
    const wp::int32 var_5 = -1;
    const wp::int32 var_6 = 0;
    bool var_7;
    wp::range_t var_8;
    wp::int32 var_9;
    wp::int32 var_10;
    const wp::int32 var_11 = 1;
    wp::int32 var_12;
    wp::int32 var_13;
    const wp::int32 var_14 = 1;
    wp::int32 var_15;
    //---------
    // forward
    // def _copy_to_local_leaf(                                                               <L 103>
    // met = triangles_above(leaf, n, limit)                                                  <L 110>
    var_0 = triangles_above_0(var_leaf, var_n, var_limit);
    // count = wp.bit_count(met)                                                              <L 111>
    var_1 = wp::bit_count(var_0);
    // if triangles + count > WIDTH:                                                          <L 112>
    var_2 = wp::add(var_triangles, var_1);
    var_4 = (var_2 > var_3);
    if (var_4) {
        // return -1                                                                          <L 113>
        return var_5;
    }
    // if count > 0:                                                                          <L 114>
    var_7 = (var_1 > var_6);
    if (var_7) {
        // raise_extent(local, edge)                                                          <L 115>
        raise_extent_0(var_local, var_edge);
    }
    // for _ in range(count):                                                                 <L 116>
    var_8 = wp::range(var_1);
    start_for_1:;
        if (iter_cmp(var_8) == 0) goto end_for_1;
        var_9 = wp::iter_next(var_8);
        // copy_triangle(leaf, lowest_bit(met), local, triangles)                             <L 117>
        var_10 = lowest_bit_0(var_0);
        copy_triangle_0(var_leaf, var_10, var_local, var_triangles);
        // met = met & (met - 1)                                                              <L 118>
        var_12 = wp::sub(var_0, var_11);
        var_13 = wp::bit_and(var_0, var_12);
        // triangles += 1                                                                     <L 119>
        var_15 = wp::add(var_triangles, var_14);
        wp::assign(var_triangles, var_15);
        wp::assign(var_0, var_13);
        goto start_for_1;
    end_for_1:;
    // return triangles                                                                       <L 120>
    return var_triangles;
}


// /work/main/warpsample/tracing/sight/frontier.py:88
static void _copy_child_0(
    wp::uint64 var_node,
    wp::int32 var_child,
    wp::uint64 var_nodes,
    wp::int32 var_entry)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 128;
    wp::tuple_t<wp::int32> var_1;
    wp::array_t<wp::float32> var_2;
    const wp::int32 var_3 = 128;
    const wp::int32 var_4 = 16;
    wp::int32 var_5;
    wp::uint64 var_6;
    wp::uint64 var_7;
    wp::uint64 var_8;
    wp::uint64 var_9;
    wp::tuple_t<wp::int32> var_10;
    wp::array_t<wp::float32> var_11;
    const wp::int32 var_12 = 128;
    wp::int32 var_13;
    const wp::int32 var_14 = 0;
    bool var_15;
    const wp::int32 var_16 = 3;
    wp::int32 var_17;
    wp::range_t var_18;
    wp::int32 var_19;
    const wp::float32 var_20 = 1.152921504606847e+18;
    wp::float32 var_21;
    const wp::int32 var_22 = 3;
    wp::int32 var_23;
    wp::int32 var_24;
    const wp::int32 var_25 = 0;
    wp::int32 var_26;
    wp::int32 var_27;
    wp::float32* var_28;
    wp::float32 var_29;
    wp::float32 var_30;
    wp::int32 var_31;
    wp::int32 var_32;
    const wp::int32 var_33 = 1;
    wp::int32 var_34;
    wp::int32 var_35;
    wp::float32* var_36;
    wp::float32 var_37;
    wp::float32 var_38;
    wp::int32 var_39;
    wp::int32 var_40;
    const wp::int32 var_41 = 2;
    wp::int32 var_42;
    wp::int32 var_43;
    wp::float32* var_44;
    wp::float32 var_45;
    wp::float32 var_46;
    wp::int32 var_47;
    wp::int32 var_48;
    const wp::int32 var_49 = 3;
    wp::int32 var_50;
    wp::int32 var_51;
    wp::float32* var_52;
    wp::float32 var_53;
    wp::float32 var_54;
    wp::int32 var_55;
    wp::int32 var_56;
    const wp::int32 var_57 = 4;
    wp::int32 var_58;
    wp::int32 var_59;
    wp::float32* var_60;
    wp::float32 var_61;
    wp::float32 var_62;
    wp::int32 var_63;
    wp::int32 var_64;
    const wp::int32 var_65 = 5;
    wp::int32 var_66;
    wp::int32 var_67;
    wp::float32* var_68;
    wp::float32 var_69;
    wp::float32 var_70;
    wp::int32 var_71;
    wp::int32 var_72;
    const wp::int32 var_73 = 6;
    wp::int32 var_74;
    wp::int32 var_75;
    wp::float32* var_76;
    wp::float32 var_77;
    wp::float32 var_78;
    wp::int32 var_79;
    wp::int32 var_80;
    const wp::int32 var_81 = 7;
    wp::int32 var_82;
    wp::int32 var_83;
    wp::float32* var_84;
    wp::float32 var_85;
    wp::float32 var_86;
    wp::int32 var_87;
    wp::int32 var_88;
    //---------
    // forward
    // def _copy_child(node: wp.uint64, child: wp.int32, nodes: wp.uint64, entry: wp.int32):       <L 89>
    // source = wp.array(ptr=node, shape=(_NODE_FLOATS,), dtype=wp.float32)                   <L 91>
    var_1 = wp::tuple(var_0);
    var_2 = wp::array_t<wp::float32>(var_node, var_3);
    // target = wp.array(ptr=nodes + wp.uint64(entry / WIDTH) * wp.uint64(NODE_BYTES), shape=(_NODE_FLOATS,), dtype=wp.float32)       <L 92>
    var_5 = wp::div(var_entry, var_4);
    var_6 = wp::uint64(var_5);
    var_7 = 512ull;
    var_8 = wp::mul(var_6, var_7);
    var_9 = wp::add(var_nodes, var_8);
    var_10 = wp::tuple(var_0);
    var_11 = wp::array_t<wp::float32>(var_9, var_12);
    // lane = entry % WIDTH                                                                   <L 93>
    var_13 = wp::mod(var_entry, var_4);
    // if lane == 0:                                                                          <L 94>
    var_15 = (var_13 == var_14);
    if (var_15) {
        // for k in range(3 * WIDTH):                                                         <L 95>
        var_17 = wp::mul(var_16, var_4);
        var_18 = wp::range(var_17);
        start_for_0:;
            if (iter_cmp(var_18) == 0) goto end_for_0;
            var_19 = wp::iter_next(var_18);
            // target[k] = _NOWHERE                                                           <L 96>
            wp::array_store(var_11, var_19, var_20);
            // target[3 * WIDTH + k] = -_NOWHERE                                              <L 97>
            var_21 = wp::neg(var_20);
            var_23 = wp::mul(var_22, var_4);
            var_24 = wp::add(var_23, var_19);
            wp::array_store(var_11, var_24, var_21);
            goto start_for_0;
        end_for_0:;
    }
    // for row in range(8):                                                                   <L 98>
    // target[row * WIDTH + lane] = source[row * WIDTH + child]                               <L 99>
    var_26 = wp::mul(var_25, var_4);
    var_27 = wp::add(var_26, var_child);
    var_28 = wp::address(var_2, var_27);
    var_30 = wp::load(var_28);
    var_29 = wp::copy(var_30);
    var_31 = wp::mul(var_25, var_4);
    var_32 = wp::add(var_31, var_13);
    wp::array_store(var_11, var_32, var_29);
    var_34 = wp::mul(var_33, var_4);
    var_35 = wp::add(var_34, var_child);
    var_36 = wp::address(var_2, var_35);
    var_38 = wp::load(var_36);
    var_37 = wp::copy(var_38);
    var_39 = wp::mul(var_33, var_4);
    var_40 = wp::add(var_39, var_13);
    wp::array_store(var_11, var_40, var_37);
    var_42 = wp::mul(var_41, var_4);
    var_43 = wp::add(var_42, var_child);
    var_44 = wp::address(var_2, var_43);
    var_46 = wp::load(var_44);
    var_45 = wp::copy(var_46);
    var_47 = wp::mul(var_41, var_4);
    var_48 = wp::add(var_47, var_13);
    wp::array_store(var_11, var_48, var_45);
    var_50 = wp::mul(var_49, var_4);
    var_51 = wp::add(var_50, var_child);
    var_52 = wp::address(var_2, var_51);
    var_54 = wp::load(var_52);
    var_53 = wp::copy(var_54);
    var_55 = wp::mul(var_49, var_4);
    var_56 = wp::add(var_55, var_13);
    wp::array_store(var_11, var_56, var_53);
    var_58 = wp::mul(var_57, var_4);
    var_59 = wp::add(var_58, var_child);
    var_60 = wp::address(var_2, var_59);
    var_62 = wp::load(var_60);
    var_61 = wp::copy(var_62);
    var_63 = wp::mul(var_57, var_4);
    var_64 = wp::add(var_63, var_13);
    wp::array_store(var_11, var_64, var_61);
    var_66 = wp::mul(var_65, var_4);
    var_67 = wp::add(var_66, var_child);
    var_68 = wp::address(var_2, var_67);
    var_70 = wp::load(var_68);
    var_69 = wp::copy(var_70);
    var_71 = wp::mul(var_65, var_4);
    var_72 = wp::add(var_71, var_13);
    wp::array_store(var_11, var_72, var_69);
    var_74 = wp::mul(var_73, var_4);
    var_75 = wp::add(var_74, var_child);
    var_76 = wp::address(var_2, var_75);
    var_78 = wp::load(var_76);
    var_77 = wp::copy(var_78);
    var_79 = wp::mul(var_73, var_4);
    var_80 = wp::add(var_79, var_13);
    wp::array_store(var_11, var_80, var_77);
    var_82 = wp::mul(var_81, var_4);
    var_83 = wp::add(var_82, var_child);
    var_84 = wp::address(var_2, var_83);
    var_86 = wp::load(var_84);
    var_85 = wp::copy(var_86);
    var_87 = wp::mul(var_81, var_4);
    var_88 = wp::add(var_87, var_13);
    wp::array_store(var_11, var_88, var_85);
}


// /work/main/warpsample/tracing/sight/frontier.py:123
static void _frontier_0(
    Accelerator_9fc73cd7 var_tree,
    ShadingPoint_241c3e67 var_point,
    wp::int32 & ret_0,
    wp::int32 & ret_1)
{
    //---------
    // primal vars
    wp::uint64* var_0;
    const wp::uint64 var_1 = 2048ull;
    wp::uint64 var_2;
    wp::uint64 var_3;
    wp::uint64* var_4;
    const wp::int32 var_5 = 16;
    wp::tuple_t<wp::int32> var_6;
    wp::array_t<wp::int32> var_7;
    const wp::int32 var_8 = 16;
    wp::uint64 var_9;
    const wp::int32 var_10 = 0;
    const wp::int32 var_11 = 0;
    const wp::int32 var_12 = 1;
    wp::int32 var_13;
    wp::vec_t<3, wp::float32>* var_14;
    wp::vec_t<3, wp::float32> var_15;
    wp::vec_t<3, wp::float32> var_16;
    wp::vec_t<3, wp::float32>* var_17;
    wp::float32 var_18;
    wp::vec_t<3, wp::float32> var_19;
    wp::float32* var_20;
    wp::float32 var_21;
    wp::float32 var_22;
    wp::float32 var_23;
    const wp::int32 var_24 = 0;
    wp::int32 var_25;
    const wp::int32 var_26 = 0;
    wp::int32 var_27;
    wp::int32 var_28;
    wp::int32 var_29;
    const wp::int32 var_30 = 0;
    bool var_31;
    const wp::int32 var_32 = 1;
    wp::int32 var_33;
    wp::int32* var_34;
    wp::uint64 var_35;
    wp::int32 var_36;
    wp::vec_t<3, wp::float32>* var_37;
    wp::float32* var_38;
    wp::int32 var_39;
    wp::int32 var_40;
    wp::vec_t<3, wp::float32> var_41;
    wp::float32 var_42;
    wp::int32 var_43;
    wp::range_t var_44;
    wp::int32 var_45;
    wp::int32 var_46;
    const wp::int32 var_47 = 1;
    wp::int32 var_48;
    wp::int32 var_49;
    wp::int32 var_50;
    const wp::int32 var_51 = -1;
    wp::int32 var_52;
    wp::int32 var_53;
    const wp::int32 var_54 = 1;
    wp::int32 var_55;
    const wp::int32 var_56 = 0;
    bool var_57;
    const wp::int32 var_58 = 0;
    bool var_59;
    wp::int32 var_60;
    wp::uint64 var_61;
    wp::float32 var_62;
    wp::int32 var_63;
    wp::int32 var_64;
    bool var_65;
    const wp::int32 var_66 = 1;
    wp::int32 var_67;
    const wp::int32 var_68 = 0;
    wp::int32 var_69;
    wp::int32 var_70;
    wp::int32 var_71;
    wp::int32 var_72;
    wp::int32 var_73;
    wp::int32 var_74;
    wp::int32 var_75;
    wp::int32 var_76;
    const wp::int32 var_77 = 0;
    bool var_78;
    const wp::int32 var_79 = 64;
    bool var_80;
    wp::uint64* var_81;
    wp::uint64 var_82;
    const wp::int32 var_83 = 1;
    wp::int32 var_84;
    wp::int32 var_85;
    wp::int32 var_86;
    wp::int32 var_87;
    wp::int32 var_88;
    const wp::int32 var_89 = 1;
    wp::int32 var_90;
    wp::int32 var_91;
    bool var_92;
    bool var_93;
    const wp::int32 var_94 = 0;
    bool var_95;
    const wp::int32 var_96 = -1;
    wp::int32 var_97;
    //---------
    // forward
    // def _frontier(tree: Accelerator, point: ShadingPoint):                                 <L 124>
    // local = point.opened + LOCAL_LEAF                                                      <L 131>
    var_0 = &((var_point).opened);
    var_3 = wp::load(var_0);
    var_2 = wp::add(var_3, var_1);
    // clear_leaf(local)                                                                      <L 132>
    clear_leaf_0(var_2);
    // waiting = wp.array(ptr=point.scratch, shape=(WIDTH,), dtype=wp.int32)                  <L 133>
    var_4 = &((var_point).scratch);
    var_6 = wp::tuple(var_5);
    var_9 = wp::load(var_4);
    var_7 = wp::array_t<wp::int32>(var_9, var_8);
    // waiting[0] = 0                                                                         <L 134>
    wp::array_store(var_7, var_11, var_10);
    // waits = wp.int32(1)                                                                    <L 135>
    var_13 = wp::int32(var_12);
    // n = point.n                                                                            <L 136>
    var_14 = &((var_point).n);
    var_16 = wp::load(var_14);
    var_15 = wp::copy(var_16);
    // limit = wp.dot(n, point.o) - point.low                                                 <L 137>
    var_17 = &((var_point).o);
    var_19 = wp::load(var_17);
    var_18 = wp::dot(var_15, var_19);
    var_20 = &((var_point).low);
    var_22 = wp::load(var_20);
    var_21 = wp::sub(var_18, var_22);
    // box_limit = limit_of_boxes(limit, n)                                                   <L 138>
    var_23 = limit_of_boxes_0(var_21, var_15);
    // entries = wp.int32(0)                                                                  <L 139>
    var_25 = wp::int32(var_24);
    // triangles = wp.int32(0)                                                                <L 140>
    var_27 = wp::int32(var_26);
    // for _ in range(_MOST_OPENED):                                                          <L 141>
    var_28 = 0;
    start_for_0:;
        if (var_28 >= 32) goto end_for_0;
        var_29 = var_28;
        var_28 += 1;
        // if waits > 0:                                                                      <L 142>
        var_31 = (var_13 > var_30);
        if (var_31) {
            // waits -= 1                                                                     <L 143>
            var_33 = wp::sub(var_13, var_32);
            // node = node_at(tree, waiting[waits])                                           <L 144>
            var_34 = wp::address(var_7, var_33);
            var_36 = wp::load(var_34);
            var_35 = node_at_0(var_tree, var_36);
            // seen, around = visible_children(node, point.o, n, box_limit, point.reach)       <L 145>
            var_37 = &((var_point).o);
            var_38 = &((var_point).reach);
            var_41 = wp::load(var_37);
            var_42 = wp::load(var_38);
            visible_children_0(var_35, var_41, var_15, var_23, var_42, var_39, var_40);
            // for _ in range(wp.bit_count(seen)):                                            <L 146>
            var_43 = wp::bit_count(var_39);
            var_44 = wp::range(var_43);
            start_for_2:;
                if (iter_cmp(var_44) == 0) goto end_for_2;
                var_45 = wp::iter_next(var_44);
                // child = lowest_bit(seen)                                                   <L 147>
                var_46 = lowest_bit_0(var_39);
                // seen = seen & (seen - 1)                                                   <L 148>
                var_48 = wp::sub(var_39, var_47);
                var_49 = wp::bit_and(var_39, var_48);
                // link = link_in(node, child)                                                <L 149>
                var_50 = link_in_0(var_35, var_46);
                // apart = wp.int32(-1)                                                       <L 150>
                var_52 = wp::int32(var_51);
                // if ((around >> child) & 1) != 0:                                           <L 151>
                var_53 = wp::rshift(var_40, var_46);
                var_55 = wp::bit_and(var_53, var_54);
                var_57 = (var_55 != var_56);
                if (var_57) {
                    // if link < 0:                                                           <L 152>
                    var_59 = (var_50 < var_58);
                    if (var_59) {
                        // leaf = leaf_at(tree, ~link)                                        <L 153>
                        var_60 = wp::invert(var_50);
                        var_61 = leaf_at_0(var_tree, var_60);
                        // apart = _copy_to_local_leaf(leaf, n, limit, edge_in(node, child), local, triangles)       <L 154>
                        var_62 = edge_in_0(var_35, var_46);
                        var_63 = _copy_to_local_leaf_0(var_61, var_15, var_21, var_62, var_2, var_27);
                        // triangles = wp.max(triangles, apart)                               <L 155>
                        var_64 = wp::max(var_27, var_63);
                    }
                    if (!var_59) {
                        // elif waits < WIDTH:                                                <L 156>
                        var_65 = (var_33 < var_5);
                        if (var_65) {
                            // waiting[waits] = link                                          <L 157>
                            wp::array_store(var_7, var_33, var_50);
                            // waits += 1                                                     <L 158>
                            var_67 = wp::add(var_33, var_66);
                            // apart = 0                                                      <L 159>
                        }
                        var_69 = wp::where(var_65, var_67, var_33);
                        var_70 = wp::where(var_65, var_68, var_52);
                    }
                    var_71 = wp::where(var_59, var_33, var_69);
                    var_72 = wp::where(var_59, var_64, var_27);
                    var_73 = wp::where(var_59, var_63, var_70);
                }
                var_74 = wp::where(var_57, var_71, var_33);
                var_75 = wp::where(var_57, var_72, var_27);
                var_76 = wp::where(var_57, var_73, var_52);
                // if apart < 0:                                                              <L 160>
                var_78 = (var_76 < var_77);
                if (var_78) {
                    // if entries < _MOST_ENTRIES:                                            <L 161>
                    var_80 = (var_25 < var_79);
                    if (var_80) {
                        // _copy_child(node, child, point.opened, entries)                    <L 162>
                        var_81 = &((var_point).opened);
                        var_82 = wp::load(var_81);
                        _copy_child_0(var_35, var_46, var_82, var_25);
                    }
                    // entries += 1                                                           <L 163>
                    var_84 = wp::add(var_25, var_83);
                }
                var_85 = wp::where(var_78, var_84, var_25);
                wp::assign(var_33, var_74);
                wp::assign(var_25, var_85);
                wp::assign(var_27, var_75);
                wp::assign(var_39, var_49);
                goto start_for_2;
            end_for_2:;
        }
        var_86 = wp::where(var_31, var_33, var_13);
        var_87 = wp::where(var_31, var_45, var_29);
        wp::assign(var_13, var_86);
        wp::assign(var_29, var_87);
        goto start_for_0;
    end_for_0:;
    // starts = (entries + WIDTH - 1) / WIDTH                                                 <L 164>
    var_88 = wp::add(var_25, var_5);
    var_90 = wp::sub(var_88, var_89);
    var_91 = wp::div(var_90, var_5);
    // if entries > _MOST_ENTRIES or waits > 0:                                               <L 165>
    var_93 = (var_25 > var_79);
    var_92 = var_93;
    if (!var_92) {
        var_95 = (var_13 > var_94);
        var_92 = var_92 || var_95;
    }
    if (var_92) {
        // starts = -1                                                                        <L 166>
    }
    var_97 = wp::where(var_92, var_96, var_91);
    // return starts, triangles                                                               <L 167>
    ret_0 = var_97;
    ret_1 = var_27;
    return;
}


// /work/main/warpsample/tracing/sight/frontier.py:170
static void open_around_0(
    Accelerator_9fc73cd7 var_tree,
    ShadingPoint_241c3e67 var_point,
    Accelerator_9fc73cd7 & ret_0,
    wp::int32 & ret_1,
    bool & ret_2)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    const bool var_2 = false;
    bool var_3;
    wp::vec_t<3, wp::float64>* var_4;
    bool var_5;
    wp::vec_t<3, wp::float64> var_6;
    bool var_7;
    wp::int32 var_8;
    wp::int32 var_9;
    const wp::int32 var_10 = 0;
    bool var_11;
    const wp::int32 var_12 = 1;
    wp::int32 var_13;
    const wp::int32 var_14 = 1;
    wp::int32 var_15;
    wp::uint64* var_16;
    wp::uint64 var_17;
    wp::uint64 var_18;
    wp::int32 var_19;
    wp::int32 var_20;
    bool var_21;
    //---------
    // forward
    // def open_around(tree: Accelerator, point: ShadingPoint):                               <L 171>
    // local = wp.int32(0)                                                                    <L 176>
    var_1 = wp::int32(var_0);
    // opened = wp.bool(False)                                                                <L 177>
    var_3 = bool(var_2);
    // if not is_far_off(point.position):                                                     <L 178>
    var_4 = &((var_point).position);
    var_6 = wp::load(var_4);
    var_5 = is_far_off_0(var_6);
    var_7 = wp::unot(var_5);
    if (var_7) {
        // starts, around = _frontier(tree, point)                                            <L 179>
        _frontier_0(var_tree, var_point, var_8, var_9);
        // opened = starts >= 0                                                               <L 180>
        var_11 = (var_8 >= var_10);
        // if opened:                                                                         <L 181>
        if (var_11) {
            // local = (1 << around) - 1                                                      <L 182>
            var_13 = wp::lshift(var_12, var_9);
            var_15 = wp::sub(var_13, var_14);
            // tree.start = point.opened                                                      <L 183>
            var_16 = &((var_point).opened);
            var_18 = wp::load(var_16);
            var_17 = wp::copy(var_18);
            var_tree.start = var_17;
            // tree.starts = starts                                                           <L 184>
            var_tree.starts = var_8;
        }
        var_19 = wp::where(var_11, var_15, var_1);
    }
    var_20 = wp::where(var_7, var_19, var_1);
    var_21 = wp::where(var_7, var_11, var_3);
    // return tree, local, opened                                                             <L 185>
    ret_0 = var_tree;
    ret_1 = var_20;
    ret_2 = var_21;
    return;
}


// /work/main/warpsample/maths/frames.py:8
static wp::mat_t<3, 3, wp::float32> frame_about_0(
    wp::vec_t<3, wp::float32> var_n)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 1.0;
    const wp::int32 var_1 = 2;
    wp::float32 var_2;
    wp::float32 var_3;
    const wp::float32 var_4 = -1.0;
    const wp::int32 var_5 = 2;
    wp::float32 var_6;
    wp::float32 var_7;
    wp::float32 var_8;
    const wp::int32 var_9 = 0;
    wp::float32 var_10;
    wp::float32 var_11;
    const wp::int32 var_12 = 1;
    wp::float32 var_13;
    wp::float32 var_14;
    const wp::int32 var_15 = 0;
    wp::float32 var_16;
    wp::float32 var_17;
    const wp::float32 var_18 = 1.0;
    wp::float32 var_19;
    const wp::int32 var_20 = 0;
    wp::float32 var_21;
    wp::float32 var_22;
    const wp::int32 var_23 = 1;
    wp::float32 var_24;
    const wp::int32 var_25 = 1;
    wp::float32 var_26;
    wp::float32 var_27;
    wp::float32 var_28;
    const wp::int32 var_29 = 1;
    wp::float32 var_30;
    wp::float32 var_31;
    const wp::int32 var_32 = 0;
    wp::float32 var_33;
    wp::float32 var_34;
    const wp::int32 var_35 = 1;
    wp::float32 var_36;
    wp::float32 var_37;
    const wp::int32 var_38 = 2;
    wp::float32 var_39;
    wp::mat_t<3, 3, wp::float32> var_40;
    //---------
    // forward
    // def frame_about(n: wp.vec3) -> wp.mat33:                                               <L 9>
    // sign = wp.copysign(1.0, n[2])                                                          <L 16>
    var_2 = wp::extract(var_n, var_1);
    var_3 = wp::copysign(var_0, var_2);
    // a = -1.0 / (sign + n[2])                                                               <L 17>
    var_6 = wp::extract(var_n, var_5);
    var_7 = wp::add(var_3, var_6);
    var_8 = wp::div(var_4, var_7);
    // xa = n[0] * a                                                                          <L 18>
    var_10 = wp::extract(var_n, var_9);
    var_11 = wp::mul(var_10, var_8);
    // xya = n[1] * xa                                                                        <L 19>
    var_13 = wp::extract(var_n, var_12);
    var_14 = wp::mul(var_13, var_11);
    // return wp.mat33(                                                                       <L 20>
    // fma(sign * n[0], xa, 1.0), xya, n[0],                                                  <L 21>
    var_16 = wp::extract(var_n, var_15);
    var_17 = wp::mul(var_3, var_16);
    var_19 = fma_0(var_17, var_11, var_18);
    var_21 = wp::extract(var_n, var_20);
    // sign * xya, fma(n[1], n[1] * a, sign), n[1],                                           <L 22>
    var_22 = wp::mul(var_3, var_14);
    var_24 = wp::extract(var_n, var_23);
    var_26 = wp::extract(var_n, var_25);
    var_27 = wp::mul(var_26, var_8);
    var_28 = fma_0(var_24, var_27, var_3);
    var_30 = wp::extract(var_n, var_29);
    // -sign * n[0], -n[1], n[2],                                                             <L 23>
    var_31 = wp::neg(var_3);
    var_33 = wp::extract(var_n, var_32);
    var_34 = wp::mul(var_31, var_33);
    var_36 = wp::extract(var_n, var_35);
    var_37 = wp::neg(var_36);
    var_39 = wp::extract(var_n, var_38);
    var_40 = wp::mat_t<3, 3, wp::float32>(var_19, var_14, var_21, var_22, var_28, var_30, var_34, var_37, var_39);
    return var_40;
}


// /work/main/warpsample/maths/frames.py:27
static wp::vec_t<3, wp::float32> to_world_0(
    wp::mat_t<3, 3, wp::float32> var_frame,
    wp::vec_t<3, wp::float32> var_w)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    const wp::int32 var_1 = 0;
    wp::float32 var_2;
    const wp::int32 var_3 = 0;
    wp::float32 var_4;
    const wp::int32 var_5 = 0;
    const wp::int32 var_6 = 1;
    wp::float32 var_7;
    const wp::int32 var_8 = 1;
    wp::float32 var_9;
    const wp::int32 var_10 = 0;
    const wp::int32 var_11 = 2;
    wp::float32 var_12;
    const wp::int32 var_13 = 2;
    wp::float32 var_14;
    wp::float32 var_15;
    wp::float32 var_16;
    wp::float32 var_17;
    const wp::int32 var_18 = 1;
    const wp::int32 var_19 = 0;
    wp::float32 var_20;
    const wp::int32 var_21 = 0;
    wp::float32 var_22;
    const wp::int32 var_23 = 1;
    const wp::int32 var_24 = 1;
    wp::float32 var_25;
    const wp::int32 var_26 = 1;
    wp::float32 var_27;
    const wp::int32 var_28 = 1;
    const wp::int32 var_29 = 2;
    wp::float32 var_30;
    const wp::int32 var_31 = 2;
    wp::float32 var_32;
    wp::float32 var_33;
    wp::float32 var_34;
    wp::float32 var_35;
    const wp::int32 var_36 = 2;
    const wp::int32 var_37 = 0;
    wp::float32 var_38;
    const wp::int32 var_39 = 0;
    wp::float32 var_40;
    const wp::int32 var_41 = 2;
    const wp::int32 var_42 = 1;
    wp::float32 var_43;
    const wp::int32 var_44 = 1;
    wp::float32 var_45;
    const wp::int32 var_46 = 2;
    const wp::int32 var_47 = 2;
    wp::float32 var_48;
    const wp::int32 var_49 = 2;
    wp::float32 var_50;
    wp::float32 var_51;
    wp::float32 var_52;
    wp::float32 var_53;
    wp::vec_t<3, wp::float32> var_54;
    //---------
    // forward
    // def to_world(frame: wp.mat33, w: wp.vec3) -> wp.vec3:                                  <L 28>
    // return wp.vec3(                                                                        <L 30>
    // fma(frame[0, 0], w[0], fma(frame[0, 1], w[1], frame[0, 2] * w[2])),                    <L 31>
    var_2 = wp::extract(var_frame, var_0, var_1);
    var_4 = wp::extract(var_w, var_3);
    var_7 = wp::extract(var_frame, var_5, var_6);
    var_9 = wp::extract(var_w, var_8);
    var_12 = wp::extract(var_frame, var_10, var_11);
    var_14 = wp::extract(var_w, var_13);
    var_15 = wp::mul(var_12, var_14);
    var_16 = fma_0(var_7, var_9, var_15);
    var_17 = fma_0(var_2, var_4, var_16);
    // fma(frame[1, 0], w[0], fma(frame[1, 1], w[1], frame[1, 2] * w[2])),                    <L 32>
    var_20 = wp::extract(var_frame, var_18, var_19);
    var_22 = wp::extract(var_w, var_21);
    var_25 = wp::extract(var_frame, var_23, var_24);
    var_27 = wp::extract(var_w, var_26);
    var_30 = wp::extract(var_frame, var_28, var_29);
    var_32 = wp::extract(var_w, var_31);
    var_33 = wp::mul(var_30, var_32);
    var_34 = fma_0(var_25, var_27, var_33);
    var_35 = fma_0(var_20, var_22, var_34);
    // fma(frame[2, 0], w[0], fma(frame[2, 1], w[1], frame[2, 2] * w[2])),                    <L 33>
    var_38 = wp::extract(var_frame, var_36, var_37);
    var_40 = wp::extract(var_w, var_39);
    var_43 = wp::extract(var_frame, var_41, var_42);
    var_45 = wp::extract(var_w, var_44);
    var_48 = wp::extract(var_frame, var_46, var_47);
    var_50 = wp::extract(var_w, var_49);
    var_51 = wp::mul(var_48, var_50);
    var_52 = fma_0(var_43, var_45, var_51);
    var_53 = fma_0(var_38, var_40, var_52);
    var_54 = wp::vec_t<3, wp::float32>(var_17, var_35, var_53);
    return var_54;
}


// /work/main/warpsample/tracing/sight/shafts.py:61
static void _complete_shaft_0(
    ShadingPoint_241c3e67 var_point)
{
    //---------
    // primal vars
    wp::uint64* var_0;
    const wp::int32 var_1 = 80;
    wp::tuple_t<wp::int32> var_2;
    wp::array_t<wp::float32> var_3;
    const wp::int32 var_4 = 80;
    wp::uint64 var_5;
    wp::vec_t<3, wp::float32>* var_6;
    wp::vec_t<3, wp::float32> var_7;
    wp::vec_t<3, wp::float32> var_8;
    wp::vec_t<3, wp::float32>* var_9;
    wp::vec_t<3, wp::float32> var_10;
    wp::vec_t<3, wp::float32> var_11;
    const wp::int32 var_12 = 0;
    wp::int32 var_13;
    const wp::int32 var_14 = 16;
    bool var_15;
    wp::float32* var_16;
    wp::int32 var_17;
    wp::float32* var_18;
    const wp::int32 var_19 = 2;
    wp::int32 var_20;
    wp::int32 var_21;
    wp::float32* var_22;
    wp::vec_t<3, wp::float32> var_23;
    wp::float32 var_24;
    wp::float32 var_25;
    wp::float32 var_26;
    wp::float32 var_27;
    const wp::int32 var_28 = 3;
    wp::int32 var_29;
    wp::int32 var_30;
    const wp::int32 var_31 = 1;
    wp::int32 var_32;
    wp::float32 var_33;
    wp::float32* var_34;
    wp::float32 var_35;
    wp::float32 var_36;
    wp::float32 var_37;
    const wp::int32 var_38 = 3;
    wp::int32 var_39;
    const wp::int32 var_40 = 0;
    wp::float32 var_41;
    wp::int32 var_42;
    wp::float32 var_43;
    const wp::int32 var_44 = 64;
    wp::int32 var_45;
    const wp::int32 var_46 = 1;
    wp::float32 var_47;
    wp::int32 var_48;
    wp::float32 var_49;
    wp::int32 var_50;
    const wp::int32 var_51 = 2;
    wp::float32 var_52;
    wp::int32 var_53;
    wp::float32 var_54;
    wp::int32 var_55;
    wp::float32* var_56;
    wp::float32 var_57;
    wp::float32 var_58;
    const wp::int32 var_59 = 67;
    //---------
    // forward
    // def _complete_shaft(point: ShadingPoint):                                              <L 62>
    // rows = wp.array(ptr=point.shaft, shape=(SHAFT_FLOATS,), dtype=wp.float32)              <L 64>
    var_0 = &((var_point).shaft);
    var_2 = wp::tuple(var_1);
    var_5 = wp::load(var_0);
    var_3 = wp::array_t<wp::float32>(var_5, var_4);
    // o = point.o                                                                            <L 65>
    var_6 = &((var_point).o);
    var_8 = wp::load(var_6);
    var_7 = wp::copy(var_8);
    // n = point.n                                                                            <L 66>
    var_9 = &((var_point).n);
    var_11 = wp::load(var_9);
    var_10 = wp::copy(var_11);
    // k = wp.int32(0)                                                                        <L 67>
    var_13 = wp::int32(var_12);
    // while k < WIDTH:                                                                       <L 68>
    start_while_0:;
    var_15 = (var_13 < var_14);
    if ((var_15) == false) goto end_while_0;
        // rows[3 * WIDTH + k] = wp.dot(wp.vec3(rows[k], rows[WIDTH + k], rows[2 * WIDTH + k]), o)       <L 70>
        var_16 = wp::address(var_3, var_13);
        var_17 = wp::add(var_14, var_13);
        var_18 = wp::address(var_3, var_17);
        var_20 = wp::mul(var_19, var_14);
        var_21 = wp::add(var_20, var_13);
        var_22 = wp::address(var_3, var_21);
        var_24 = wp::load(var_16);
        var_25 = wp::load(var_18);
        var_26 = wp::load(var_22);
        var_23 = wp::vec_t<3, wp::float32>(var_24, var_25, var_26);
        var_27 = wp::dot(var_23, var_7);
        var_29 = wp::mul(var_28, var_14);
        var_30 = wp::add(var_29, var_13);
        wp::array_store(var_3, var_30, var_27);
        // k += 1                                                                             <L 71>
        var_32 = wp::add(var_13, var_31);
        wp::assign(var_13, var_32);
    goto start_while_0;
    end_while_0:;
    // rows[3 * WIDTH] = limit_of_boxes(wp.dot(n, o) - point.low, n)                          <L 73>
    var_33 = wp::dot(var_10, var_7);
    var_34 = &((var_point).low);
    var_36 = wp::load(var_34);
    var_35 = wp::sub(var_33, var_36);
    var_37 = limit_of_boxes_0(var_35, var_10);
    var_39 = wp::mul(var_38, var_14);
    wp::array_store(var_3, var_39, var_37);
    // for axis in range(3):                                                                  <L 74>
    // rows[axis * WIDTH] = n[axis]                                                           <L 75>
    var_41 = wp::extract(var_10, var_40);
    var_42 = wp::mul(var_40, var_14);
    wp::array_store(var_3, var_42, var_41);
    // rows[_ORIGIN + axis] = o[axis]                                                         <L 76>
    var_43 = wp::extract(var_7, var_40);
    var_45 = wp::add(var_44, var_40);
    wp::array_store(var_3, var_45, var_43);
    // rows[axis * WIDTH] = n[axis]                                                           <L 75>
    var_47 = wp::extract(var_10, var_46);
    var_48 = wp::mul(var_46, var_14);
    wp::array_store(var_3, var_48, var_47);
    // rows[_ORIGIN + axis] = o[axis]                                                         <L 76>
    var_49 = wp::extract(var_7, var_46);
    var_50 = wp::add(var_44, var_46);
    wp::array_store(var_3, var_50, var_49);
    // rows[axis * WIDTH] = n[axis]                                                           <L 75>
    var_52 = wp::extract(var_10, var_51);
    var_53 = wp::mul(var_51, var_14);
    wp::array_store(var_3, var_53, var_52);
    // rows[_ORIGIN + axis] = o[axis]                                                         <L 76>
    var_54 = wp::extract(var_7, var_51);
    var_55 = wp::add(var_44, var_51);
    wp::array_store(var_3, var_55, var_54);
    // rows[_LOW] = point.low                                                                 <L 77>
    var_56 = &((var_point).low);
    var_58 = wp::load(var_56);
    var_57 = wp::copy(var_58);
    wp::array_store(var_3, var_59, var_57);
}


// /work/main/warpsample/tracing/sight/shafts.py:80
static void aim_about_0(
    wp::uint64 var_vectors,
    ShadingPoint_241c3e67 var_point)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 48;
    wp::tuple_t<wp::int32> var_1;
    wp::array_t<wp::float32> var_2;
    const wp::int32 var_3 = 48;
    wp::uint64* var_4;
    const wp::int32 var_5 = 80;
    wp::tuple_t<wp::int32> var_6;
    wp::array_t<wp::float32> var_7;
    const wp::int32 var_8 = 80;
    wp::uint64 var_9;
    wp::vec_t<3, wp::float32>* var_10;
    wp::mat_t<3, 3, wp::float32> var_11;
    wp::vec_t<3, wp::float32> var_12;
    const wp::int32 var_13 = 0;
    wp::int32 var_14;
    const wp::int32 var_15 = 16;
    bool var_16;
    wp::float32* var_17;
    wp::int32 var_18;
    wp::float32* var_19;
    const wp::int32 var_20 = 2;
    wp::int32 var_21;
    wp::int32 var_22;
    wp::float32* var_23;
    wp::vec_t<3, wp::float32> var_24;
    wp::float32 var_25;
    wp::float32 var_26;
    wp::float32 var_27;
    wp::vec_t<3, wp::float32> var_28;
    const wp::int32 var_29 = 0;
    wp::float32 var_30;
    const wp::int32 var_31 = 1;
    wp::float32 var_32;
    wp::int32 var_33;
    const wp::int32 var_34 = 2;
    wp::float32 var_35;
    const wp::int32 var_36 = 2;
    wp::int32 var_37;
    wp::int32 var_38;
    const wp::int32 var_39 = 1;
    wp::int32 var_40;
    //---------
    // forward
    // def aim_about(vectors: wp.uint64, point: ShadingPoint):                                <L 81>
    // given = wp.array(ptr=vectors, shape=(_VECTORS_FLOATS,), dtype=wp.float32)              <L 83>
    var_1 = wp::tuple(var_0);
    var_2 = wp::array_t<wp::float32>(var_vectors, var_3);
    // rows = wp.array(ptr=point.shaft, shape=(SHAFT_FLOATS,), dtype=wp.float32)              <L 84>
    var_4 = &((var_point).shaft);
    var_6 = wp::tuple(var_5);
    var_9 = wp::load(var_4);
    var_7 = wp::array_t<wp::float32>(var_9, var_8);
    // frame = frame_about(point.n)                                                           <L 85>
    var_10 = &((var_point).n);
    var_12 = wp::load(var_10);
    var_11 = frame_about_0(var_12);
    // k = wp.int32(0)                                                                        <L 86>
    var_14 = wp::int32(var_13);
    // while k < WIDTH:                                                                       <L 87>
    start_while_0:;
    var_16 = (var_14 < var_15);
    if ((var_16) == false) goto end_while_0;
        // v = to_world(frame, wp.vec3(given[k], given[WIDTH + k], given[2 * WIDTH + k]))       <L 88>
        var_17 = wp::address(var_2, var_14);
        var_18 = wp::add(var_15, var_14);
        var_19 = wp::address(var_2, var_18);
        var_21 = wp::mul(var_20, var_15);
        var_22 = wp::add(var_21, var_14);
        var_23 = wp::address(var_2, var_22);
        var_25 = wp::load(var_17);
        var_26 = wp::load(var_19);
        var_27 = wp::load(var_23);
        var_24 = wp::vec_t<3, wp::float32>(var_25, var_26, var_27);
        var_28 = to_world_0(var_11, var_24);
        // rows[k] = v[0]                                                                     <L 89>
        var_30 = wp::extract(var_28, var_29);
        wp::array_store(var_7, var_14, var_30);
        // rows[WIDTH + k] = v[1]                                                             <L 90>
        var_32 = wp::extract(var_28, var_31);
        var_33 = wp::add(var_15, var_14);
        wp::array_store(var_7, var_33, var_32);
        // rows[2 * WIDTH + k] = v[2]                                                         <L 91>
        var_35 = wp::extract(var_28, var_34);
        var_37 = wp::mul(var_36, var_15);
        var_38 = wp::add(var_37, var_14);
        wp::array_store(var_7, var_38, var_35);
        // k += 1                                                                             <L 92>
        var_40 = wp::add(var_14, var_39);
        wp::assign(var_14, var_40);
    goto start_while_0;
    end_while_0:;
    // _complete_shaft(point)                                                                 <L 93>
    _complete_shaft_0(var_point);
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


// /work/main/warpsample/tracing/sight/shafts.py:127
static Plane_dba16a08 _plane_0(
    wp::uint64 var_shaft,
    wp::int32 var_i)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 80;
    wp::tuple_t<wp::int32> var_1;
    wp::array_t<wp::float32> var_2;
    const wp::int32 var_3 = 80;
    Plane_dba16a08 var_4;
    wp::float32* var_5;
    wp::float32 var_6;
    wp::float32 var_7;
    const wp::int32 var_8 = 16;
    wp::int32 var_9;
    wp::float32* var_10;
    wp::float32 var_11;
    wp::float32 var_12;
    const wp::int32 var_13 = 2;
    wp::int32 var_14;
    wp::int32 var_15;
    wp::float32* var_16;
    wp::float32 var_17;
    wp::float32 var_18;
    const wp::int32 var_19 = 3;
    wp::int32 var_20;
    wp::int32 var_21;
    wp::float32* var_22;
    wp::float32 var_23;
    wp::float32 var_24;
    wp::float32* var_25;
    const wp::float32 var_26 = 0.0;
    bool var_27;
    wp::float32 var_28;
    const wp::uint64 var_29 = 192ull;
    wp::uint64 var_30;
    wp::uint64 var_31;
    wp::float32* var_32;
    const wp::float32 var_33 = 0.0;
    bool var_34;
    wp::float32 var_35;
    wp::uint64 var_36;
    wp::uint64 var_37;
    const wp::uint64 var_38 = 64ull;
    wp::uint64 var_39;
    wp::float32* var_40;
    const wp::float32 var_41 = 0.0;
    bool var_42;
    wp::float32 var_43;
    wp::uint64 var_44;
    wp::uint64 var_45;
    wp::uint64 var_46;
    wp::uint64 var_47;
    //---------
    // forward
    // def _plane(shaft: wp.uint64, i: wp.int32) -> Plane:                                    <L 128>
    // rows = wp.array(ptr=shaft, shape=(SHAFT_FLOATS,), dtype=wp.float32)                    <L 130>
    var_1 = wp::tuple(var_0);
    var_2 = wp::array_t<wp::float32>(var_shaft, var_3);
    // plane = Plane()                                                                        <L 131>
    var_4 = Plane_dba16a08();
    // plane.nx = rows[i]                                                                     <L 132>
    var_5 = wp::address(var_2, var_i);
    var_7 = wp::load(var_5);
    var_6 = wp::copy(var_7);
    var_4.nx = var_6;
    // plane.ny = rows[WIDTH + i]                                                             <L 133>
    var_9 = wp::add(var_8, var_i);
    var_10 = wp::address(var_2, var_9);
    var_12 = wp::load(var_10);
    var_11 = wp::copy(var_12);
    var_4.ny = var_11;
    // plane.nz = rows[2 * WIDTH + i]                                                         <L 134>
    var_14 = wp::mul(var_13, var_8);
    var_15 = wp::add(var_14, var_i);
    var_16 = wp::address(var_2, var_15);
    var_18 = wp::load(var_16);
    var_17 = wp::copy(var_18);
    var_4.nz = var_17;
    // plane.limit = rows[3 * WIDTH + i]                                                      <L 135>
    var_20 = wp::mul(var_19, var_8);
    var_21 = wp::add(var_20, var_i);
    var_22 = wp::address(var_2, var_21);
    var_24 = wp::load(var_22);
    var_23 = wp::copy(var_24);
    var_4.limit = var_23;
    // plane.x_row = wp.where(plane.nx > 0.0, _UPPER, wp.uint64(0))                           <L 136>
    var_25 = &((var_4).nx);
    var_28 = wp::load(var_25);
    var_27 = (var_28 > var_26);
    var_30 = 0ull;
    var_31 = wp::where(var_27, var_29, var_30);
    var_4.x_row = var_31;
    // plane.y_row = wp.where(plane.ny > 0.0, _UPPER, wp.uint64(0)) + _ROW                    <L 137>
    var_32 = &((var_4).ny);
    var_35 = wp::load(var_32);
    var_34 = (var_35 > var_33);
    var_36 = 0ull;
    var_37 = wp::where(var_34, var_29, var_36);
    var_39 = wp::add(var_37, var_38);
    var_4.y_row = var_39;
    // plane.z_row = wp.where(plane.nz > 0.0, _UPPER, wp.uint64(0)) + _ROW + _ROW             <L 138>
    var_40 = &((var_4).nz);
    var_43 = wp::load(var_40);
    var_42 = (var_43 > var_41);
    var_44 = 0ull;
    var_45 = wp::where(var_42, var_29, var_44);
    var_46 = wp::add(var_45, var_38);
    var_47 = wp::add(var_46, var_38);
    var_4.z_row = var_47;
    // return plane                                                                           <L 139>
    return var_4;
}


// /work/main/warpsample/tracing/wide/layout.py:84
static wp::vec_t<3, wp::float32> corner_0(
    wp::uint64 var_leaf,
    wp::int32 var_first_row,
    wp::int32 var_k,
    wp::vec_t<3, wp::float32> var_o)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 160;
    wp::tuple_t<wp::int32> var_1;
    wp::array_t<wp::float32> var_2;
    const wp::int32 var_3 = 160;
    const wp::int32 var_4 = 16;
    wp::int32 var_5;
    wp::int32 var_6;
    wp::float32* var_7;
    const wp::int32 var_8 = 0;
    wp::float32 var_9;
    wp::float32 var_10;
    wp::float32 var_11;
    wp::int32 var_12;
    wp::float32* var_13;
    const wp::int32 var_14 = 1;
    wp::float32 var_15;
    wp::float32 var_16;
    wp::float32 var_17;
    const wp::int32 var_18 = 2;
    wp::int32 var_19;
    wp::int32 var_20;
    wp::float32* var_21;
    const wp::int32 var_22 = 2;
    wp::float32 var_23;
    wp::float32 var_24;
    wp::float32 var_25;
    wp::vec_t<3, wp::float32> var_26;
    //---------
    // forward
    // def corner(leaf: wp.uint64, first_row: wp.int32, k: wp.int32, o: wp.vec3) -> wp.vec3:       <L 85>
    // rows = wp.array(ptr=leaf, shape=(_LEAF_FLOATS,), dtype=wp.float32)                     <L 90>
    var_1 = wp::tuple(var_0);
    var_2 = wp::array_t<wp::float32>(var_leaf, var_3);
    // at = first_row * WIDTH + k                                                             <L 91>
    var_5 = wp::mul(var_first_row, var_4);
    var_6 = wp::add(var_5, var_k);
    // return wp.vec3(rows[at] - o[0], rows[at + WIDTH] - o[1], rows[at + 2 * WIDTH] - o[2])       <L 92>
    var_7 = wp::address(var_2, var_6);
    var_9 = wp::extract(var_o, var_8);
    var_11 = wp::load(var_7);
    var_10 = wp::sub(var_11, var_9);
    var_12 = wp::add(var_6, var_4);
    var_13 = wp::address(var_2, var_12);
    var_15 = wp::extract(var_o, var_14);
    var_17 = wp::load(var_13);
    var_16 = wp::sub(var_17, var_15);
    var_19 = wp::mul(var_18, var_4);
    var_20 = wp::add(var_6, var_19);
    var_21 = wp::address(var_2, var_20);
    var_23 = wp::extract(var_o, var_22);
    var_25 = wp::load(var_21);
    var_24 = wp::sub(var_25, var_23);
    var_26 = wp::vec_t<3, wp::float32>(var_10, var_16, var_24);
    return var_26;
}


// /work/main/warpsample/tracing/wide/layout.py:78
static wp::float32 size_of_0(
    wp::vec_t<3, wp::float32> var_v)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float32 var_1;
    wp::float32 var_2;
    const wp::int32 var_3 = 1;
    wp::float32 var_4;
    wp::float32 var_5;
    wp::float32 var_6;
    const wp::int32 var_7 = 2;
    wp::float32 var_8;
    wp::float32 var_9;
    wp::float32 var_10;
    //---------
    // forward
    // def size_of(v: wp.vec3) -> wp.float32:                                                 <L 79>
    // return wp.abs(v[0]) + wp.abs(v[1]) + wp.abs(v[2])                                      <L 81>
    var_1 = wp::extract(var_v, var_0);
    var_2 = wp::abs(var_1);
    var_4 = wp::extract(var_v, var_3);
    var_5 = wp::abs(var_4);
    var_6 = wp::add(var_2, var_5);
    var_8 = wp::extract(var_v, var_7);
    var_9 = wp::abs(var_8);
    var_10 = wp::add(var_6, var_9);
    return var_10;
}


// /work/main/warpsample/tracing/sight/shafts.py:151
static wp::int32 _is_triangle_inside_0(
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::vec_t<3, wp::float32> var_c,
    Plane_dba16a08 var_plane,
    wp::float32 var_margin)
{
    //---------
    // primal vars
    wp::float32* var_0;
    wp::float32* var_1;
    wp::float32* var_2;
    wp::vec_t<3, wp::float32> var_3;
    wp::float32 var_4;
    wp::float32 var_5;
    wp::float32 var_6;
    wp::float32 var_7;
    wp::float32 var_8;
    wp::float32 var_9;
    wp::float32 var_10;
    wp::float32 var_11;
    wp::float32 var_12;
    bool var_13;
    const wp::int32 var_14 = 1;
    const wp::int32 var_15 = 0;
    wp::int32 var_16;
    //---------
    // forward
    // def _is_triangle_inside(a: wp.vec3, b: wp.vec3, c: wp.vec3, plane: Plane, margin: wp.float32) -> wp.int32:       <L 152>
    // n = wp.vec3(plane.nx, plane.ny, plane.nz)                                              <L 154>
    var_0 = &((var_plane).nx);
    var_1 = &((var_plane).ny);
    var_2 = &((var_plane).nz);
    var_4 = wp::load(var_0);
    var_5 = wp::load(var_1);
    var_6 = wp::load(var_2);
    var_3 = wp::vec_t<3, wp::float32>(var_4, var_5, var_6);
    // return wp.where(greater(greater(wp.dot(a, n), wp.dot(b, n)), wp.dot(c, n)) >= -margin, 1, 0)       <L 155>
    var_7 = wp::dot(var_a, var_3);
    var_8 = wp::dot(var_b, var_3);
    var_9 = greater_0(var_7, var_8);
    var_10 = wp::dot(var_c, var_3);
    var_11 = greater_0(var_9, var_10);
    var_12 = wp::neg(var_margin);
    var_13 = (var_11 >= var_12);
    var_16 = wp::where(var_13, var_14, var_15);
    return var_16;
}


// /work/main/warpsample/tracing/sight/shafts.py:54
static wp::vec_t<3, wp::float32> corner_of_0(
    wp::uint64 var_vectors,
    wp::int32 var_i)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 5;
    wp::int32 var_1;
    wp::float32 var_2;
    const wp::int32 var_3 = 16;
    wp::int32 var_4;
    wp::float32 var_5;
    const wp::int32 var_6 = 2;
    wp::int32 var_7;
    wp::int32 var_8;
    wp::float32 var_9;
    wp::vec_t<3, wp::float32> var_10;
    //---------
    // forward
    // def corner_of(vectors: wp.uint64, i: wp.int32) -> wp.vec3:                             <L 55>
    // k = PLANES + i                                                                         <L 57>
    var_1 = wp::add(var_0, var_i);
    // return wp.vec3(float_at(vectors, k), float_at(vectors, WIDTH + k), float_at(vectors, 2 * WIDTH + k))       <L 58>
    var_2 = _reader__locals__read_0(var_vectors, var_1);
    var_4 = wp::add(var_3, var_1);
    var_5 = _reader__locals__read_0(var_vectors, var_4);
    var_7 = wp::mul(var_6, var_3);
    var_8 = wp::add(var_7, var_1);
    var_9 = _reader__locals__read_0(var_vectors, var_8);
    var_10 = wp::vec_t<3, wp::float32>(var_2, var_5, var_9);
    return var_10;
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


// /work/main/warpsample/tracing/sight/shafts.py:158
static wp::int32 _is_facing_0(
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::vec_t<3, wp::float32> var_c,
    wp::uint64 var_shaft)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float32> var_0;
    wp::vec_t<3, wp::float32> var_1;
    wp::vec_t<3, wp::float32> var_2;
    wp::float32 var_3;
    wp::float32 var_4;
    const wp::int32 var_5 = 0;
    wp::vec_t<3, wp::float32> var_6;
    wp::float32 var_7;
    const wp::int32 var_8 = 1;
    wp::vec_t<3, wp::float32> var_9;
    wp::float32 var_10;
    const wp::int32 var_11 = 2;
    wp::vec_t<3, wp::float32> var_12;
    wp::float32 var_13;
    const wp::int32 var_14 = 3;
    wp::vec_t<3, wp::float32> var_15;
    wp::float32 var_16;
    wp::float32 var_17;
    wp::float32 var_18;
    wp::float32 var_19;
    wp::float32 var_20;
    wp::float32 var_21;
    wp::float32 var_22;
    const wp::float32 var_23 = 1.9073486328125e-06;
    wp::float32 var_24;
    wp::float32 var_25;
    wp::float32 var_26;
    wp::float32 var_27;
    wp::float32 var_28;
    wp::float32 var_29;
    wp::float32 var_30;
    bool var_31;
    const wp::int32 var_32 = 1;
    const wp::int32 var_33 = 0;
    wp::int32 var_34;
    bool var_35;
    const wp::int32 var_36 = 1;
    const wp::int32 var_37 = 0;
    wp::int32 var_38;
    wp::int32 var_39;
    bool var_40;
    const wp::int32 var_41 = 1;
    const wp::int32 var_42 = 0;
    wp::int32 var_43;
    wp::float32 var_44;
    bool var_45;
    const wp::int32 var_46 = 1;
    const wp::int32 var_47 = 0;
    wp::int32 var_48;
    wp::int32 var_49;
    wp::int32 var_50;
    //---------
    // forward
    // def _is_facing(a: wp.vec3, b: wp.vec3, c: wp.vec3, shaft: wp.uint64) -> wp.int32:       <L 159>
    // e = b - a                                                                              <L 164>
    var_0 = wp::sub(var_b, var_a);
    // f = c - a                                                                              <L 165>
    var_1 = wp::sub(var_c, var_a);
    // n = wp.cross(e, f)                                                                     <L 166>
    var_2 = wp::cross(var_0, var_1);
    // height = -wp.dot(n, a)                                                                 <L 167>
    var_3 = wp::dot(var_2, var_a);
    var_4 = wp::neg(var_3);
    // p = wp.dot(n, corner_of(shaft, 0))                                                     <L 168>
    var_6 = corner_of_0(var_shaft, var_5);
    var_7 = wp::dot(var_2, var_6);
    // q = wp.dot(n, corner_of(shaft, 1))                                                     <L 169>
    var_9 = corner_of_0(var_shaft, var_8);
    var_10 = wp::dot(var_2, var_9);
    // r = wp.dot(n, corner_of(shaft, 2))                                                     <L 170>
    var_12 = corner_of_0(var_shaft, var_11);
    var_13 = wp::dot(var_2, var_12);
    // s = wp.dot(n, corner_of(shaft, 3))                                                     <L 171>
    var_15 = corner_of_0(var_shaft, var_14);
    var_16 = wp::dot(var_2, var_15);
    // least = lesser(lesser(p, q), lesser(r, s))                                             <L 172>
    var_17 = lesser_0(var_7, var_10);
    var_18 = lesser_0(var_13, var_16);
    var_19 = lesser_0(var_17, var_18);
    // most = greater(greater(p, q), greater(r, s))                                           <L 173>
    var_20 = greater_0(var_7, var_10);
    var_21 = greater_0(var_13, var_16);
    var_22 = greater_0(var_20, var_21);
    // margin = _MARGIN * size_of(e) * size_of(f)                                             <L 174>
    var_24 = size_of_0(var_0);
    var_25 = wp::mul(var_23, var_24);
    var_26 = size_of_0(var_1);
    var_27 = wp::mul(var_25, var_26);
    // height_margin = margin * size_of(a)                                                    <L 175>
    var_28 = size_of_0(var_a);
    var_29 = wp::mul(var_27, var_28);
    // from_above = wp.where(height > -height_margin, 1, 0) & wp.where(least < margin, 1, 0)       <L 176>
    var_30 = wp::neg(var_29);
    var_31 = (var_4 > var_30);
    var_34 = wp::where(var_31, var_32, var_33);
    var_35 = (var_19 < var_27);
    var_38 = wp::where(var_35, var_36, var_37);
    var_39 = wp::bit_and(var_34, var_38);
    // from_below = wp.where(height < height_margin, 1, 0) & wp.where(most > -margin, 1, 0)       <L 177>
    var_40 = (var_4 < var_29);
    var_43 = wp::where(var_40, var_41, var_42);
    var_44 = wp::neg(var_27);
    var_45 = (var_22 > var_44);
    var_48 = wp::where(var_45, var_46, var_47);
    var_49 = wp::bit_and(var_43, var_48);
    // return from_above | from_below                                                         <L 178>
    var_50 = wp::bit_or(var_39, var_49);
    return var_50;
}


// /work/main/warpsample/tracing/sight/shafts.py:200
static wp::int32 triangles_in_0(
    wp::uint64 var_leaf,
    wp::uint64 var_shaft)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 4;
    const wp::int32 var_1 = 64;
    wp::int32 var_2;
    wp::uint64 var_3;
    wp::uint64 var_4;
    const wp::int32 var_5 = 0;
    wp::vec_t<3, wp::float32> var_6;
    const wp::int32 var_7 = 67;
    wp::float32 var_8;
    const wp::int32 var_9 = 0;
    Plane_dba16a08 var_10;
    const wp::int32 var_11 = 1;
    Plane_dba16a08 var_12;
    const wp::int32 var_13 = 2;
    Plane_dba16a08 var_14;
    const wp::int32 var_15 = 3;
    Plane_dba16a08 var_16;
    const wp::int32 var_17 = 4;
    Plane_dba16a08 var_18;
    const wp::int32 var_19 = 0;
    wp::int32 var_20;
    const wp::int32 var_21 = 0;
    wp::int32 var_22;
    const wp::int32 var_23 = 16;
    bool var_24;
    const wp::int32 var_25 = 0;
    wp::vec_t<3, wp::float32> var_26;
    const wp::int32 var_27 = 3;
    wp::vec_t<3, wp::float32> var_28;
    const wp::int32 var_29 = 6;
    wp::vec_t<3, wp::float32> var_30;
    const wp::float32 var_31 = 1.9073486328125e-06;
    wp::float32 var_32;
    wp::float32 var_33;
    wp::float32 var_34;
    wp::float32 var_35;
    wp::float32 var_36;
    wp::float32 var_37;
    wp::int32 var_38;
    wp::int32 var_39;
    wp::int32 var_40;
    wp::int32 var_41;
    wp::int32 var_42;
    wp::int32 var_43;
    wp::int32 var_44;
    wp::int32 var_45;
    wp::int32 var_46;
    wp::int32 var_47;
    wp::int32 var_48;
    wp::int32 var_49;
    wp::int32 var_50;
    const wp::int32 var_51 = 1;
    wp::int32 var_52;
    //---------
    // forward
    // def triangles_in(leaf: wp.uint64, shaft: wp.uint64) -> wp.int32:                       <L 201>
    // o = vec3_at(shaft + wp.uint64(4 * _ORIGIN), 0)                                         <L 203>
    var_2 = wp::mul(var_0, var_1);
    var_3 = wp::uint64(var_2);
    var_4 = wp::add(var_shaft, var_3);
    var_6 = _reader__locals__read_5(var_4, var_5);
    // low = float_at(shaft, _LOW)                                                            <L 204>
    var_8 = _reader__locals__read_0(var_shaft, var_7);
    // p = _plane(shaft, 0)                                                                   <L 205>
    var_10 = _plane_0(var_shaft, var_9);
    // q = _plane(shaft, 1)                                                                   <L 206>
    var_12 = _plane_0(var_shaft, var_11);
    // r = _plane(shaft, 2)                                                                   <L 207>
    var_14 = _plane_0(var_shaft, var_13);
    // s = _plane(shaft, 3)                                                                   <L 208>
    var_16 = _plane_0(var_shaft, var_15);
    // t = _plane(shaft, 4)                                                                   <L 209>
    var_18 = _plane_0(var_shaft, var_17);
    // mask = wp.int32(0)                                                                     <L 210>
    var_20 = wp::int32(var_19);
    // k = wp.int32(0)                                                                        <L 211>
    var_22 = wp::int32(var_21);
    // while k < WIDTH:                                                                       <L 212>
    start_while_0:;
    var_24 = (var_22 < var_23);
    if ((var_24) == false) goto end_while_0;
        // a = corner(leaf, 0, k, o)                                                          <L 213>
        var_26 = corner_0(var_leaf, var_25, var_22, var_6);
        // b = corner(leaf, 3, k, o)                                                          <L 214>
        var_28 = corner_0(var_leaf, var_27, var_22, var_6);
        // c = corner(leaf, 6, k, o)                                                          <L 215>
        var_30 = corner_0(var_leaf, var_29, var_22, var_6);
        // margin = _MARGIN * greater(greater(size_of(a), size_of(b)), size_of(c))            <L 216>
        var_32 = size_of_0(var_26);
        var_33 = size_of_0(var_28);
        var_34 = greater_0(var_32, var_33);
        var_35 = size_of_0(var_30);
        var_36 = greater_0(var_34, var_35);
        var_37 = wp::mul(var_31, var_36);
        // inside = (                                                                         <L 217>
        // _is_triangle_inside(a, b, c, p, low)                                               <L 218>
        var_38 = _is_triangle_inside_0(var_26, var_28, var_30, var_10, var_8);
        // & _is_triangle_inside(a, b, c, q, margin)                                          <L 219>
        var_39 = _is_triangle_inside_0(var_26, var_28, var_30, var_12, var_37);
        var_40 = wp::bit_and(var_38, var_39);
        // & _is_triangle_inside(a, b, c, r, margin)                                          <L 220>
        var_41 = _is_triangle_inside_0(var_26, var_28, var_30, var_14, var_37);
        var_42 = wp::bit_and(var_40, var_41);
        // inside = inside & _is_triangle_inside(a, b, c, s, margin) & _is_triangle_inside(a, b, c, t, margin)       <L 222>
        var_43 = _is_triangle_inside_0(var_26, var_28, var_30, var_16, var_37);
        var_44 = wp::bit_and(var_42, var_43);
        var_45 = _is_triangle_inside_0(var_26, var_28, var_30, var_18, var_37);
        var_46 = wp::bit_and(var_44, var_45);
        // mask = mask | ((inside & _is_facing(a, b, c, shaft)) << k)                         <L 223>
        var_47 = _is_facing_0(var_26, var_28, var_30, var_shaft);
        var_48 = wp::bit_and(var_46, var_47);
        var_49 = wp::lshift(var_48, var_22);
        var_50 = wp::bit_or(var_20, var_49);
        // k += 1                                                                             <L 224>
        var_52 = wp::add(var_22, var_51);
        wp::assign(var_20, var_50);
        wp::assign(var_22, var_52);
    goto start_while_0;
    end_while_0:;
    // return mask                                                                            <L 225>
    return var_20;
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


// /work/main/warpsample/tracing/sight/shafts.py:142
static wp::int32 _is_box_inside_0(
    wp::uint64 var_node,
    Plane_dba16a08 var_plane,
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
    wp::uint64* var_7;
    wp::uint64 var_8;
    wp::uint64 var_9;
    wp::tuple_t<wp::int32> var_10;
    wp::array_t<wp::float32> var_11;
    const wp::int32 var_12 = 16;
    wp::uint64* var_13;
    wp::uint64 var_14;
    wp::uint64 var_15;
    wp::tuple_t<wp::int32> var_16;
    wp::array_t<wp::float32> var_17;
    const wp::int32 var_18 = 16;
    wp::float32* var_19;
    wp::float32* var_20;
    wp::float32* var_21;
    wp::float32* var_22;
    wp::float32* var_23;
    wp::float32* var_24;
    wp::float32 var_25;
    wp::float32 var_26;
    wp::float32 var_27;
    wp::float32 var_28;
    wp::float32 var_29;
    wp::float32 var_30;
    wp::float32 var_31;
    wp::float32 var_32;
    wp::float32 var_33;
    wp::float32* var_34;
    bool var_35;
    wp::float32 var_36;
    const wp::int32 var_37 = 1;
    const wp::int32 var_38 = 0;
    wp::int32 var_39;
    //---------
    // forward
    // def _is_box_inside(node: wp.uint64, plane: Plane, k: wp.int32) -> wp.int32:            <L 143>
    // x = wp.array(ptr=node + plane.x_row, shape=(WIDTH,), dtype=wp.float32)                 <L 145>
    var_0 = &((var_plane).x_row);
    var_2 = wp::load(var_0);
    var_1 = wp::add(var_node, var_2);
    var_4 = wp::tuple(var_3);
    var_5 = wp::array_t<wp::float32>(var_1, var_6);
    // y = wp.array(ptr=node + plane.y_row, shape=(WIDTH,), dtype=wp.float32)                 <L 146>
    var_7 = &((var_plane).y_row);
    var_9 = wp::load(var_7);
    var_8 = wp::add(var_node, var_9);
    var_10 = wp::tuple(var_3);
    var_11 = wp::array_t<wp::float32>(var_8, var_12);
    // z = wp.array(ptr=node + plane.z_row, shape=(WIDTH,), dtype=wp.float32)                 <L 147>
    var_13 = &((var_plane).z_row);
    var_15 = wp::load(var_13);
    var_14 = wp::add(var_node, var_15);
    var_16 = wp::tuple(var_3);
    var_17 = wp::array_t<wp::float32>(var_14, var_18);
    // return wp.where(fma(x[k], plane.nx, fma(y[k], plane.ny, z[k] * plane.nz)) >= plane.limit, 1, 0)       <L 148>
    var_19 = wp::address(var_5, var_k);
    var_20 = &((var_plane).nx);
    var_21 = wp::address(var_11, var_k);
    var_22 = &((var_plane).ny);
    var_23 = wp::address(var_17, var_k);
    var_24 = &((var_plane).nz);
    var_26 = wp::load(var_23);
    var_27 = wp::load(var_24);
    var_25 = wp::mul(var_26, var_27);
    var_29 = wp::load(var_21);
    var_30 = wp::load(var_22);
    var_28 = fma_0(var_29, var_30, var_25);
    var_32 = wp::load(var_19);
    var_33 = wp::load(var_20);
    var_31 = fma_0(var_32, var_33, var_28);
    var_34 = &((var_plane).limit);
    var_36 = wp::load(var_34);
    var_35 = (var_31 >= var_36);
    var_39 = wp::where(var_35, var_37, var_38);
    return var_39;
}


// /work/main/warpsample/tracing/sight/shafts.py:181
static wp::int32 boxes_in_0(
    wp::uint64 var_node,
    wp::uint64 var_shaft)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    Plane_dba16a08 var_1;
    const wp::int32 var_2 = 1;
    Plane_dba16a08 var_3;
    const wp::int32 var_4 = 2;
    Plane_dba16a08 var_5;
    const wp::int32 var_6 = 3;
    Plane_dba16a08 var_7;
    const wp::int32 var_8 = 4;
    Plane_dba16a08 var_9;
    const wp::int32 var_10 = 0;
    wp::int32 var_11;
    const wp::int32 var_12 = 0;
    wp::int32 var_13;
    const wp::int32 var_14 = 16;
    bool var_15;
    wp::int32 var_16;
    wp::int32 var_17;
    wp::int32 var_18;
    wp::int32 var_19;
    wp::int32 var_20;
    wp::int32 var_21;
    wp::int32 var_22;
    wp::int32 var_23;
    wp::int32 var_24;
    wp::int32 var_25;
    wp::int32 var_26;
    const wp::int32 var_27 = 1;
    wp::int32 var_28;
    //---------
    // forward
    // def boxes_in(node: wp.uint64, shaft: wp.uint64) -> wp.int32:                           <L 182>
    // p = _plane(shaft, 0)                                                                   <L 184>
    var_1 = _plane_0(var_shaft, var_0);
    // q = _plane(shaft, 1)                                                                   <L 185>
    var_3 = _plane_0(var_shaft, var_2);
    // r = _plane(shaft, 2)                                                                   <L 186>
    var_5 = _plane_0(var_shaft, var_4);
    // s = _plane(shaft, 3)                                                                   <L 187>
    var_7 = _plane_0(var_shaft, var_6);
    // t = _plane(shaft, 4)                                                                   <L 188>
    var_9 = _plane_0(var_shaft, var_8);
    // mask = wp.int32(0)                                                                     <L 189>
    var_11 = wp::int32(var_10);
    // k = wp.int32(0)                                                                        <L 190>
    var_13 = wp::int32(var_12);
    // while k < WIDTH:                                                                       <L 191>
    start_while_0:;
    var_15 = (var_13 < var_14);
    if ((var_15) == false) goto end_while_0;
        // inside = (                                                                         <L 192>
        // _is_box_inside(node, p, k) & _is_box_inside(node, q, k) & _is_box_inside(node, r, k) & _is_box_inside(node, s, k)       <L 193>
        var_16 = _is_box_inside_0(var_node, var_1, var_13);
        var_17 = _is_box_inside_0(var_node, var_3, var_13);
        var_18 = wp::bit_and(var_16, var_17);
        var_19 = _is_box_inside_0(var_node, var_5, var_13);
        var_20 = wp::bit_and(var_18, var_19);
        var_21 = _is_box_inside_0(var_node, var_7, var_13);
        var_22 = wp::bit_and(var_20, var_21);
        // mask = mask | ((inside & _is_box_inside(node, t, k)) << k)                         <L 195>
        var_23 = _is_box_inside_0(var_node, var_9, var_13);
        var_24 = wp::bit_and(var_22, var_23);
        var_25 = wp::lshift(var_24, var_13);
        var_26 = wp::bit_or(var_11, var_25);
        // k += 1                                                                             <L 196>
        var_28 = wp::add(var_13, var_27);
        wp::assign(var_11, var_26);
        wp::assign(var_13, var_28);
    goto start_while_0;
    end_while_0:;
    // return mask                                                                            <L 197>
    return var_11;
}


// /work/main/warpsample/tracing/sight/search.py:33
static void _look_1(
    wp::uint64 var_leaf,
    wp::uint64 var_shaft,
    InShaft_29ffc368 var_found,
    InShaft_29ffc368 & ret_0,
    bool & ret_1)
{
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int32* var_1;
    const wp::int32 var_2 = 0;
    bool var_3;
    wp::int32 var_4;
    //---------
    // forward
    // def _look(leaf: wp.uint64, shaft: wp.uint64, found: InShaft):                          <L 34>
    // found.leaf = leaf                                                                      <L 36>
    var_found.leaf = var_leaf;
    // found.triangles = triangles_in(leaf, shaft)                                            <L 37>
    var_0 = triangles_in_0(var_leaf, var_shaft);
    var_found.triangles = var_0;
    // return found, found.triangles != 0                                                     <L 38>
    var_1 = &((var_found).triangles);
    var_4 = wp::load(var_1);
    var_3 = (var_4 != var_2);
    ret_0 = var_found;
    ret_1 = var_3;
    return;
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


// /work/main/warpsample/tracing/wide/walk.py:42
static void tree_walk__locals__walk_2(
    Accelerator_9fc73cd7 var_tree,
    wp::uint64 var_query,
    InShaft_29ffc368 var_answer,
    wp::int32 var_visits,
    wp::uint64 var_scratch,
    InShaft_29ffc368 & ret_0,
    bool & ret_1)
{
    //---------
    // primal vars
    wp::uint64 var_0;
    wp::int32* var_1;
    const wp::int32 var_2 = 1;
    wp::range_t var_3;
    wp::int32 var_4;
    wp::int32 var_5;
    wp::uint64* var_6;
    wp::uint64 var_7;
    wp::uint64 var_8;
    wp::uint64 var_9;
    wp::uint64 var_10;
    wp::uint64 var_11;
    const wp::int32 var_12 = -1;
    const wp::float32 var_13 = 0.0;
    wp::uint64 var_14;
    wp::uint64* var_15;
    wp::uint64 var_16;
    wp::uint64 var_17;
    wp::int32 var_18;
    const bool var_19 = false;
    bool var_20;
    wp::int32* var_21;
    const wp::int32 var_22 = 0;
    bool var_23;
    wp::int32 var_24;
    bool var_25;
    wp::int32 var_26;
    const wp::int32 var_27 = 0;
    bool var_28;
    wp::int32 var_29;
    const wp::int32 var_30 = 1;
    wp::int32 var_31;
    wp::int32 var_32;
    wp::int32 var_33;
    const bool var_34 = false;
    bool var_35;
    const wp::int32 var_36 = 0;
    bool var_37;
    wp::int32 var_38;
    wp::uint64 var_39;
    InShaft_29ffc368 var_40;
    bool var_41;
    const wp::int32 var_42 = 0;
    bool var_43;
    const wp::float32 var_44 = 0.0;
    wp::uint64 var_45;
    wp::uint64 var_46;
    wp::uint64 var_47;
    wp::int32 var_48;
    InShaft_29ffc368 var_49;
    wp::uint64 var_50;
    wp::uint64 var_51;
    wp::int32 var_52;
    bool var_53;
    const wp::int32 var_54 = 1;
    wp::int32 var_55;
    bool var_56;
    const wp::int32 var_57 = 0;
    bool var_58;
    bool var_59;
    bool var_60;
    bool var_61;
    bool var_62;
    const wp::uint64 var_63 = 16ull;
    wp::uint64 var_64;
    const wp::int32 var_65 = 0;
    wp::uint64 var_66;
    const wp::int32 var_67 = 2;
    wp::int32 var_68;
    const bool var_69 = false;
    bool var_70;
    wp::uint64 var_71;
    wp::uint64 var_72;
    wp::int32 var_73;
    bool var_74;
    InShaft_29ffc368 var_75;
    wp::int32 var_76;
    wp::uint64 var_77;
    wp::uint64 var_78;
    wp::int32 var_79;
    bool var_80;
    bool var_81;
    InShaft_29ffc368 var_82;
    wp::int32 var_83;
    wp::uint64 var_84;
    wp::uint64 var_85;
    wp::int32 var_86;
    bool var_87;
    bool var_88;
    //---------
    // forward
    // def walk(tree: Accelerator, query: query_type, answer: answer_type, visits: wp.int32, scratch: wp.uint64):       <L 43>
    // top = scratch                                                                          <L 44>
    var_0 = wp::copy(var_scratch);
    // for other in range(1, tree.starts):                                                    <L 45>
    var_1 = &((var_tree).starts);
    var_4 = wp::load(var_1);
    var_3 = wp::range(var_2, var_4);
    start_for_0:;
        if (iter_cmp(var_3) == 0) goto end_for_0;
        var_5 = wp::iter_next(var_3);
        // top = push_node(top, tree.start + wp.uint64(other) * wp.uint64(NODE_BYTES), _UNTESTED, 0.0)       <L 46>
        var_6 = &((var_tree).start);
        var_7 = wp::uint64(var_5);
        var_8 = 512ull;
        var_9 = wp::mul(var_7, var_8);
        var_11 = wp::load(var_6);
        var_10 = wp::add(var_11, var_9);
        var_14 = push_node_0(var_0, var_10, var_12, var_13);
        wp::assign(var_0, var_14);
        goto start_for_0;
    end_for_0:;
    // node = tree.start                                                                      <L 47>
    var_15 = &((var_tree).start);
    var_17 = wp::load(var_15);
    var_16 = wp::copy(var_17);
    // mask = _UNTESTED                                                                       <L 48>
    var_18 = wp::copy(var_12);
    // spent = wp.bool(False)                                                                 <L 49>
    var_20 = bool(var_19);
    // searching = tree.starts > 0                                                            <L 50>
    var_21 = &((var_tree).starts);
    var_24 = wp::load(var_21);
    var_23 = (var_24 > var_22);
    // while searching:                                                                       <L 51>
    start_while_2:;
    if ((var_23) == false) goto end_while_2;
        // if mask == _UNTESTED:                                                              <L 52>
        var_25 = (var_18 == var_12);
        if (var_25) {
            // mask = enter(node, query)                                                      <L 53>
            var_26 = boxes_in_0(var_16, var_query);
        }
        if (!var_25) {
            // elif mask != 0:                                                                <L 54>
            var_28 = (var_18 != var_27);
            if (var_28) {
                // child = lowest_bit(mask)                                                   <L 55>
                var_29 = lowest_bit_0(var_18);
                // mask = mask & (mask - 1)                                                   <L 56>
                var_31 = wp::sub(var_18, var_30);
                var_32 = wp::bit_and(var_18, var_31);
                // link = link_in(node, child)                                                <L 57>
                var_33 = link_in_0(var_16, var_29);
                // enough = wp.bool(False)                                                    <L 58>
                var_35 = bool(var_34);
                // if link < 0:                                                               <L 59>
                var_37 = (var_33 < var_36);
                if (var_37) {
                    // answer, enough = look(leaf_at(tree, ~link), query, answer)             <L 60>
                    var_38 = wp::invert(var_33);
                    var_39 = leaf_at_0(var_tree, var_38);
                    _look_1(var_39, var_query, var_answer, var_40, var_41);
                }
                if (!var_37) {
                    // if mask != 0:                                                          <L 62>
                    var_43 = (var_32 != var_42);
                    if (var_43) {
                        // top = push_node(top, node, mask, 0.0)                              <L 63>
                        var_45 = push_node_0(var_0, var_16, var_32, var_44);
                    }
                    var_46 = wp::where(var_43, var_45, var_0);
                    // node = node_at(tree, link)                                             <L 64>
                    var_47 = node_at_0(var_tree, var_33);
                    // mask = _UNTESTED                                                       <L 65>
                    var_48 = wp::copy(var_12);
                }
                var_49 = wp::where(var_37, var_40, var_answer);
                var_50 = wp::where(var_37, var_0, var_46);
                var_51 = wp::where(var_37, var_16, var_47);
                var_52 = wp::where(var_37, var_32, var_48);
                var_53 = wp::where(var_37, var_41, var_35);
                // visits -= 1                                                                <L 66>
                var_55 = wp::sub(var_visits, var_54);
                // spent = visits == 0 and not enough                                         <L 67>
                var_58 = (var_55 == var_57);
                var_56 = var_58;
                if (var_56) {
                    var_59 = wp::unot(var_53);
                    var_56 = var_56 && var_59;
                }
                // searching = not (enough or spent)                                          <L 68>
                var_60 = var_53;
                if (!var_60) {
                    var_60 = var_60 || var_56;
                }
                var_61 = wp::unot(var_60);
            }
            if (!var_28) {
                // elif top != scratch:                                                       <L 69>
                var_62 = (var_0 != var_scratch);
                if (var_62) {
                    // top -= STACK_ENTRY                                                     <L 70>
                    var_64 = wp::sub(var_0, var_63);
                    // node = address_at(top, 0)                                              <L 71>
                    var_66 = _reader__locals__read_3(var_64, var_65);
                    // mask = int_at(top, 2)                                                  <L 72>
                    var_68 = _reader__locals__read_1(var_64, var_67);
                }
                if (!var_62) {
                    // searching = wp.bool(False)                                             <L 74>
                    var_70 = bool(var_69);
                }
                var_71 = wp::where(var_62, var_64, var_0);
                var_72 = wp::where(var_62, var_66, var_16);
                var_73 = wp::where(var_62, var_68, var_18);
                var_74 = wp::where(var_62, var_23, var_70);
            }
            var_75 = wp::where(var_28, var_49, var_answer);
            var_76 = wp::where(var_28, var_55, var_visits);
            var_77 = wp::where(var_28, var_50, var_71);
            var_78 = wp::where(var_28, var_51, var_72);
            var_79 = wp::where(var_28, var_52, var_73);
            var_80 = wp::where(var_28, var_56, var_20);
            var_81 = wp::where(var_28, var_61, var_74);
        }
        var_82 = wp::where(var_25, var_answer, var_75);
        var_83 = wp::where(var_25, var_visits, var_76);
        var_84 = wp::where(var_25, var_0, var_77);
        var_85 = wp::where(var_25, var_16, var_78);
        var_86 = wp::where(var_25, var_26, var_79);
        var_87 = wp::where(var_25, var_20, var_80);
        var_88 = wp::where(var_25, var_23, var_81);
        wp::assign(var_answer, var_82);
        wp::assign(var_visits, var_83);
        wp::assign(var_0, var_84);
        wp::assign(var_16, var_85);
        wp::assign(var_18, var_86);
        wp::assign(var_20, var_87);
        wp::assign(var_23, var_88);
    goto start_while_2;
    end_while_2:;
    // return answer, spent                                                                   <L 75>
    ret_0 = var_answer;
    ret_1 = var_20;
    return;
}


// /work/main/warpsample/tracing/sight/search.py:44
static InShaft_29ffc368 search_shaft_0(
    Accelerator_9fc73cd7 var_tree,
    ShadingPoint_241c3e67 var_point,
    wp::int32 var_local)
{
    //---------
    // primal vars
    InShaft_29ffc368 var_0;
    const wp::int32 var_1 = 0;
    bool var_2;
    wp::uint64* var_3;
    const wp::uint64 var_4 = 2048ull;
    wp::uint64 var_5;
    wp::uint64 var_6;
    wp::uint64* var_7;
    wp::uint64* var_8;
    wp::int32 var_9;
    wp::uint64 var_10;
    wp::uint64 var_11;
    wp::int32 var_12;
    const bool var_13 = false;
    bool var_14;
    bool var_15;
    wp::int32* var_16;
    const wp::int32 var_17 = 0;
    bool var_18;
    wp::int32 var_19;
    wp::int32* var_20;
    const wp::int32 var_21 = 0;
    bool var_22;
    wp::int32 var_23;
    wp::uint64* var_24;
    const wp::int32 var_25 = 32;
    wp::uint64* var_26;
    InShaft_29ffc368 var_27;
    bool var_28;
    wp::uint64 var_29;
    wp::uint64 var_30;
    InShaft_29ffc368 var_31;
    bool var_32;
    wp::int32* var_33;
    const wp::int32 var_34 = 0;
    bool var_35;
    wp::int32 var_36;
    const wp::int32 var_37 = 1;
    const wp::int32 var_38 = 2;
    const wp::int32 var_39 = 0;
    wp::int32 var_40;
    wp::int32 var_41;
    //---------
    // forward
    // def search_shaft(tree: Accelerator, point: ShadingPoint, local: wp.int32) -> InShaft:       <L 45>
    // found = InShaft()                                                                      <L 50>
    var_0 = InShaft_29ffc368();
    // if local != 0:                                                                         <L 51>
    var_2 = (var_local != var_1);
    if (var_2) {
        // found.leaf = point.opened + LOCAL_LEAF                                             <L 52>
        var_3 = &((var_point).opened);
        var_6 = wp::load(var_3);
        var_5 = wp::add(var_6, var_4);
        var_0.leaf = var_5;
        // found.triangles = triangles_in(found.leaf, point.shaft) & local                    <L 53>
        var_7 = &((var_0).leaf);
        var_8 = &((var_point).shaft);
        var_10 = wp::load(var_7);
        var_11 = wp::load(var_8);
        var_9 = triangles_in_0(var_10, var_11);
        var_12 = wp::bit_and(var_9, var_local);
        var_0.triangles = var_12;
    }
    // spent = wp.bool(False)                                                                 <L 54>
    var_14 = bool(var_13);
    // if found.triangles == 0 and tree.starts > 0:                                           <L 55>
    var_16 = &((var_0).triangles);
    var_19 = wp::load(var_16);
    var_18 = (var_19 == var_17);
    var_15 = var_18;
    if (var_15) {
        var_20 = &((var_tree).starts);
        var_23 = wp::load(var_20);
        var_22 = (var_23 > var_21);
        var_15 = var_15 && var_22;
    }
    if (var_15) {
        // found, spent = _walk(tree, point.shaft, found, _VISITS, point.scratch)             <L 56>
        var_24 = &((var_point).shaft);
        var_26 = &((var_point).scratch);
        var_29 = wp::load(var_24);
        var_30 = wp::load(var_26);
        tree_walk__locals__walk_2(var_tree, var_29, var_0, var_25, var_30, var_27, var_28);
    }
    var_31 = wp::where(var_15, var_27, var_0);
    var_32 = wp::where(var_15, var_28, var_14);
    // found.state = wp.where(found.triangles != 0, OCCUPIED, wp.where(spent, UNDECIDED, EMPTY))       <L 57>
    var_33 = &((var_31).triangles);
    var_36 = wp::load(var_33);
    var_35 = (var_36 != var_34);
    var_40 = wp::where(var_32, var_38, var_39);
    var_41 = wp::where(var_35, var_37, var_40);
    var_31.state = var_41;
    // return found                                                                           <L 58>
    return var_31;
}


// /work/main/warpsample/tracing/sight/search.py:61
static wp::int32 in_local_leaf_0(
    InShaft_29ffc368 var_found,
    ShadingPoint_241c3e67 var_point)
{
    //---------
    // primal vars
    wp::uint64* var_0;
    wp::uint64* var_1;
    const wp::uint64 var_2 = 2048ull;
    wp::uint64 var_3;
    wp::uint64 var_4;
    bool var_5;
    wp::uint64 var_6;
    wp::int32* var_7;
    const wp::int32 var_8 = 0;
    wp::int32 var_9;
    wp::int32 var_10;
    //---------
    // forward
    // def in_local_leaf(found: InShaft, point: ShadingPoint) -> wp.int32:                    <L 62>
    // return wp.where(found.leaf == point.opened + LOCAL_LEAF, found.triangles, 0)           <L 64>
    var_0 = &((var_found).leaf);
    var_1 = &((var_point).opened);
    var_4 = wp::load(var_1);
    var_3 = wp::add(var_4, var_2);
    var_6 = wp::load(var_0);
    var_5 = (var_6 == var_3);
    var_7 = &((var_found).triangles);
    var_10 = wp::load(var_7);
    var_9 = wp::where(var_5, var_10, var_8);
    return var_9;
}


// /work/main/warpsample/estimate/lobes.py:81
static void finder_of__locals__find_0(
    Lobes_4a4eb700 var_lobes,
    Accelerator_9fc73cd7 var_tree,
    ShadingPoint_241c3e67 var_point,
    wp::int32 var_i,
    wp::int32 var_local,
    wp::int32 & ret_0,
    wp::int32 & ret_1)
{
    //---------
    // primal vars
    wp::uint64* var_0;
    wp::uint64 var_1;
    const wp::uint64 var_2 = 192ull;
    wp::uint64 var_3;
    wp::uint64 var_4;
    wp::uint64 var_5;
    InShaft_29ffc368 var_6;
    wp::int32* var_7;
    const wp::int32 var_8 = 0;
    bool var_9;
    wp::int32 var_10;
    const wp::int32 var_11 = 0;
    const wp::int32 var_12 = 1;
    wp::int32 var_13;
    const bool var_14 = false;
    wp::int32 var_15;
    //---------
    // forward
    // def find(lobes: Lobes, tree: Accelerator, point: ShadingPoint, i: wp.int32, local: wp.int32):       <L 82>
    // aim_about(lobes.shafts + wp.uint64(i) * VECTORS_BYTES, point)                          <L 84>
    var_0 = &((var_lobes).shafts);
    var_1 = wp::uint64(var_i);
    var_3 = wp::mul(var_1, var_2);
    var_5 = wp::load(var_0);
    var_4 = wp::add(var_5, var_3);
    aim_about_0(var_4, var_point);
    // found = search_shaft(tree, point, local)                                               <L 85>
    var_6 = search_shaft_0(var_tree, var_point, var_local);
    // may_meet = wp.where(found.state == EMPTY, 0, BLOCKERS)                                 <L 86>
    var_7 = &((var_6).state);
    var_10 = wp::load(var_7);
    var_9 = (var_10 == var_8);
    var_13 = wp::where(var_9, var_11, var_12);
    // if wp.static(glass):                                                                   <L 87>
    // return may_meet, in_local_leaf(found, point)                                           <L 89>
    var_15 = in_local_leaf_0(var_6, var_point);
    ret_0 = var_13;
    ret_1 = var_15;
    return;
}


// /work/main/warpsample/estimate/lobes.py:67
static Lobe_95707b65 lobe_of_0(
    Lobes_4a4eb700 var_lobes,
    ShadingPoint_241c3e67 var_point)
{
    //---------
    // primal vars
    Lobe_95707b65 var_0;
    wp::vec_t<3, wp::float32>* var_1;
    wp::vec_t<3, wp::float32> var_2;
    wp::vec_t<3, wp::float32> var_3;
    wp::int32* var_4;
    wp::int64* var_5;
    wp::int32 var_6;
    wp::int64 var_7;
    wp::int32 var_8;
    wp::int32 var_9;
    Placement_e6d83c4e* var_10;
    wp::uint64* var_11;
    wp::int64* var_12;
    wp::uint64 var_13;
    Placement_e6d83c4e var_14;
    wp::uint64 var_15;
    wp::int64 var_16;
    //---------
    // forward
    // def lobe_of(lobes: Lobes, point: ShadingPoint) -> Lobe:                                <L 68>
    // lobe = Lobe()                                                                          <L 70>
    var_0 = Lobe_95707b65();
    // lobe.normal = point.n                                                                  <L 71>
    var_1 = &((var_point).n);
    var_3 = wp::load(var_1);
    var_2 = wp::copy(var_3);
    var_0.normal = var_2;
    // lobe.row = lobes.first_row + wp.int32(point.index)                                     <L 72>
    var_4 = &((var_lobes).first_row);
    var_5 = &((var_point).index);
    var_7 = wp::load(var_5);
    var_6 = wp::int32(var_7);
    var_9 = wp::load(var_4);
    var_8 = wp::add(var_9, var_6);
    var_0.row = var_8;
    // lobe.point = id_of(lobes.placement, lobes.first_point, point.index)                    <L 73>
    var_10 = &((var_lobes).placement);
    var_11 = &((var_lobes).first_point);
    var_12 = &((var_point).index);
    var_14 = wp::load(var_10);
    var_15 = wp::load(var_11);
    var_16 = wp::load(var_12);
    var_13 = id_of_0(var_14, var_15, var_16);
    var_0.point = var_13;
    // return lobe                                                                            <L 74>
    return var_0;
}


// /work/main/warpsample/tracing/sight/rays.py:19
static wp::int32 whole_vectors_0(
    wp::int32 var_length)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 8;
    wp::int32 var_1;
    const wp::int32 var_2 = 1;
    wp::int32 var_3;
    wp::int32 var_4;
    wp::int32 var_5;
    //---------
    // forward
    // def whole_vectors(length: wp.int32) -> wp.int32:                                       <L 20>
    // return (length + LANES - 1) / LANES * LANES                                            <L 22>
    var_1 = wp::add(var_length, var_0);
    var_3 = wp::sub(var_1, var_2);
    var_4 = wp::div(var_3, var_0);
    var_5 = wp::mul(var_4, var_0);
    return var_5;
}


// /work/main/warpsample/sequences/hashing.py:146
static wp::vec_t<4, wp::uint32> stream_key_0(
    wp::vec_t<4, wp::uint32> var_key,
    wp::uint32 var_stream)
{
    //---------
    // primal vars
    wp::vec_t<4, wp::uint32> var_0;
    //---------
    // forward
    // def stream_key(key: wp.vec4ui, stream: wp.uint32) -> wp.vec4ui:                        <L 147>
    // return mixed_key(key, stream)                                                          <L 149>
    var_0 = mixed_key_0(var_key, var_stream);
    return var_0;
}


// /work/main/warpsample/sequences/hashing.py:152
static wp::vec_t<4, wp::uint32> select_key_0(
    wp::vec_t<4, wp::uint32> var_first,
    wp::vec_t<4, wp::uint32> var_second,
    wp::int32 var_which)
{
    //---------
    // primal vars
    const wp::uint32 var_0 = 0u;
    wp::uint32 var_1;
    wp::uint32 var_2;
    const wp::int32 var_3 = 0;
    wp::uint32 var_4;
    const wp::int32 var_5 = 0;
    wp::uint32 var_6;
    const wp::int32 var_7 = 0;
    wp::uint32 var_8;
    wp::uint32 var_9;
    wp::uint32 var_10;
    wp::uint32 var_11;
    const wp::int32 var_12 = 1;
    wp::uint32 var_13;
    const wp::int32 var_14 = 1;
    wp::uint32 var_15;
    const wp::int32 var_16 = 1;
    wp::uint32 var_17;
    wp::uint32 var_18;
    wp::uint32 var_19;
    wp::uint32 var_20;
    const wp::int32 var_21 = 2;
    wp::uint32 var_22;
    const wp::int32 var_23 = 2;
    wp::uint32 var_24;
    const wp::int32 var_25 = 2;
    wp::uint32 var_26;
    wp::uint32 var_27;
    wp::uint32 var_28;
    wp::uint32 var_29;
    const wp::int32 var_30 = 3;
    wp::uint32 var_31;
    const wp::int32 var_32 = 3;
    wp::uint32 var_33;
    const wp::int32 var_34 = 3;
    wp::uint32 var_35;
    wp::uint32 var_36;
    wp::uint32 var_37;
    wp::uint32 var_38;
    wp::vec_t<4, wp::uint32> var_39;
    //---------
    // forward
    // def select_key(first: wp.vec4ui, second: wp.vec4ui, which: wp.int32) -> wp.vec4ui:       <L 153>
    // mask = ZERO_WORD - wp.uint32(which)                                                    <L 158>
    var_1 = wp::uint32(var_which);
    var_2 = wp::sub(var_0, var_1);
    // return wp.vec4ui(                                                                      <L 159>
    // first[0] ^ ((first[0] ^ second[0]) & mask),                                            <L 160>
    var_4 = wp::extract(var_first, var_3);
    var_6 = wp::extract(var_first, var_5);
    var_8 = wp::extract(var_second, var_7);
    var_9 = wp::bit_xor(var_6, var_8);
    var_10 = wp::bit_and(var_9, var_2);
    var_11 = wp::bit_xor(var_4, var_10);
    // first[1] ^ ((first[1] ^ second[1]) & mask),                                            <L 161>
    var_13 = wp::extract(var_first, var_12);
    var_15 = wp::extract(var_first, var_14);
    var_17 = wp::extract(var_second, var_16);
    var_18 = wp::bit_xor(var_15, var_17);
    var_19 = wp::bit_and(var_18, var_2);
    var_20 = wp::bit_xor(var_13, var_19);
    // first[2] ^ ((first[2] ^ second[2]) & mask),                                            <L 162>
    var_22 = wp::extract(var_first, var_21);
    var_24 = wp::extract(var_first, var_23);
    var_26 = wp::extract(var_second, var_25);
    var_27 = wp::bit_xor(var_24, var_26);
    var_28 = wp::bit_and(var_27, var_2);
    var_29 = wp::bit_xor(var_22, var_28);
    // first[3] ^ ((first[3] ^ second[3]) & mask),                                            <L 163>
    var_31 = wp::extract(var_first, var_30);
    var_33 = wp::extract(var_first, var_32);
    var_35 = wp::extract(var_second, var_34);
    var_36 = wp::bit_xor(var_33, var_35);
    var_37 = wp::bit_and(var_36, var_2);
    var_38 = wp::bit_xor(var_31, var_37);
    var_39 = wp::vec_t<4, wp::uint32>(var_11, var_20, var_29, var_38);
    return var_39;
}


// /work/main/warpsample/maths/numerics.py:104
static wp::uint32 weyl_0(
    wp::uint32 var_index,
    wp::uint64 var_step)
{
    //---------
    // primal vars
    wp::uint64 var_0;
    wp::uint32 var_1;
    wp::uint64 var_2;
    wp::uint64 var_3;
    wp::uint32 var_4;
    wp::uint32 var_5;
    wp::uint32 var_6;
    wp::uint32 var_7;
    //---------
    // forward
    // def weyl(index: wp.uint32, step: wp.uint64) -> wp.uint32:                              <L 105>
    // carry = high_word(wp.uint64(index) * wp.uint64(low_word(step)))                        <L 110>
    var_0 = wp::uint64(var_index);
    var_1 = low_word_0(var_step);
    var_2 = wp::uint64(var_1);
    var_3 = wp::mul(var_0, var_2);
    var_4 = high_word_0(var_3);
    // return index * high_word(step) + carry                                                 <L 111>
    var_5 = high_word_0(var_step);
    var_6 = wp::mul(var_index, var_5);
    var_7 = wp::add(var_6, var_4);
    return var_7;
}


// /work/main/warpsample/maths/numerics.py:76
static wp::float32 uniform_from_bits_0(
    wp::uint32 var_bits)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 8;
    wp::uint32 var_1;
    wp::uint32 var_2;
    wp::int32 var_3;
    wp::float32 var_4;
    const wp::float32 var_5 = 5.960464477539063e-08;
    wp::float32 var_6;
    //---------
    // forward
    // def uniform_from_bits(bits: wp.uint32) -> wp.float32:                                  <L 77>
    // return wp.float32(wp.int32(bits >> wp.uint32(8))) * _GRID_STEP                         <L 79>
    var_1 = wp::uint32(var_0);
    var_2 = wp::rshift(var_bits, var_1);
    var_3 = wp::int32(var_2);
    var_4 = wp::float32(var_3);
    var_6 = wp::mul(var_4, var_5);
    return var_6;
}


// /work/main/warpsample/sequences/fibonacci.py:15
static wp::vec_t<2, wp::float32> fibonacci_sample_0(
    wp::vec_t<4, wp::uint32> var_key,
    wp::uint32 var_sample,
    wp::uint32 var_count)
{
    //---------
    // primal vars
    const wp::float64 var_0 = 1.844674407370955e+19;
    wp::float64 var_1;
    wp::float64 var_2;
    wp::uint64 var_3;
    const wp::int32 var_4 = 0;
    wp::uint32 var_5;
    wp::uint64 var_6;
    wp::uint32 var_7;
    wp::uint64 var_8;
    wp::uint64 var_9;
    wp::uint32 var_10;
    wp::uint32 var_11;
    wp::uint32 var_12;
    wp::float32 var_13;
    const wp::uint64 var_14 = 11400714819323198485ull;
    wp::uint32 var_15;
    const wp::int32 var_16 = 1;
    wp::uint32 var_17;
    wp::uint32 var_18;
    wp::float32 var_19;
    wp::vec_t<2, wp::float32> var_20;
    //---------
    // forward
    // def fibonacci_sample(key: wp.vec4ui, sample: wp.uint32, count: wp.uint32) -> wp.vec2:       <L 16>
    // step = wp.uint64(_BELOW_2_64 / wp.float64(count))                                      <L 24>
    var_1 = wp::float64(var_count);
    var_2 = wp::div(var_0, var_1);
    var_3 = wp::uint64(var_2);
    // shift = high_word(wp.uint64(key[0]) * wp.uint64(high_word(step)))                      <L 25>
    var_5 = wp::extract(var_key, var_4);
    var_6 = wp::uint64(var_5);
    var_7 = high_word_0(var_3);
    var_8 = wp::uint64(var_7);
    var_9 = wp::mul(var_6, var_8);
    var_10 = high_word_0(var_9);
    // return wp.vec2(uniform_from_bits(weyl(sample, step) + shift), uniform_from_bits(weyl(sample, GOLDEN_STEP) + key[1]))       <L 26>
    var_11 = weyl_0(var_sample, var_3);
    var_12 = wp::add(var_11, var_10);
    var_13 = uniform_from_bits_0(var_12);
    var_15 = weyl_0(var_sample, var_14);
    var_17 = wp::extract(var_key, var_16);
    var_18 = wp::add(var_15, var_17);
    var_19 = uniform_from_bits_0(var_18);
    var_20 = wp::vec_t<2, wp::float32>(var_13, var_19);
    return var_20;
}


// /work/main/warpsample/maths/numerics.py:114
static wp::float32 root_0(
    wp::float32 var_x)
{
    //---------
    // primal vars
    wp::float32 var_0;
    //---------
    // forward
    // def root(x: wp.float32) -> wp.float32:                                                 <L 115>
    // return wp.sqrt(x)                                                                      <L 117>
    var_0 = wp::sqrt(var_x);
    return var_0;
}


// /work/main/warpsample/maths/numerics.py:138
static wp::vec_t<2, wp::float32> sincos_eighth_0(
    wp::float32 var_x)
{
    //---------
    // primal vars
    wp::float32 var_0;
    const wp::float32 var_1 = 59.245964;
    const wp::float32 var_2 = -85.443741;
    wp::float32 var_3;
    const wp::float32 var_4 = 64.939323;
    wp::float32 var_5;
    const wp::float32 var_6 = -19.739208;
    wp::float32 var_7;
    const wp::float32 var_8 = 1.0;
    wp::float32 var_9;
    const wp::float32 var_10 = 6.2831855;
    const wp::float32 var_11 = -75.393585;
    const wp::float32 var_12 = 81.592354;
    wp::float32 var_13;
    const wp::float32 var_14 = -41.341663;
    wp::float32 var_15;
    const wp::float32 var_16 = -1.7484555e-07;
    wp::float32 var_17;
    wp::float32 var_18;
    wp::float32 var_19;
    wp::vec_t<2, wp::float32> var_20;
    //---------
    // forward
    // def sincos_eighth(x: wp.float32) -> wp.vec2:                                           <L 139>
    // t = x * x                                                                              <L 141>
    var_0 = wp::mul(var_x, var_x);
    // c = fma(t, fma(t, fma(t, fma(t, 59.245964, -85.443741), 64.939323), -19.739208), 1.0)       <L 142>
    var_3 = fma_0(var_0, var_1, var_2);
    var_5 = fma_0(var_0, var_3, var_4);
    var_7 = fma_0(var_0, var_5, var_6);
    var_9 = fma_0(var_0, var_7, var_8);
    // s = fma(x, 6.2831855, x * fma(t, fma(t, fma(t, -75.393585, 81.592354), -41.341663), -1.7484555e-07))       <L 144>
    var_13 = fma_0(var_0, var_11, var_12);
    var_15 = fma_0(var_0, var_13, var_14);
    var_17 = fma_0(var_0, var_15, var_16);
    var_18 = wp::mul(var_x, var_17);
    var_19 = fma_0(var_x, var_10, var_18);
    // return wp.vec2(c, s)                                                                   <L 145>
    var_20 = wp::vec_t<2, wp::float32>(var_9, var_19);
    return var_20;
}


// /work/main/warpsample/maths/numerics.py:148
static wp::vec_t<2, wp::float32> sincos_turns_0(
    wp::float32 var_u)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 0.5;
    wp::float32 var_1;
    wp::float32 var_2;
    const wp::float32 var_3 = 0.25;
    wp::float32 var_4;
    wp::float32 var_5;
    const wp::float32 var_6 = 0.25;
    wp::float32 var_7;
    bool var_8;
    wp::float32 var_9;
    wp::vec_t<2, wp::float32> var_10;
    const wp::int32 var_11 = 1;
    wp::float32 var_12;
    const wp::int32 var_13 = 0;
    wp::float32 var_14;
    wp::float32 var_15;
    const wp::int32 var_16 = 0;
    wp::float32 var_17;
    const wp::int32 var_18 = 1;
    wp::float32 var_19;
    wp::float32 var_20;
    wp::float32 var_21;
    wp::float32 var_22;
    wp::vec_t<2, wp::float32> var_23;
    //---------
    // forward
    // def sincos_turns(u: wp.float32) -> wp.vec2:                                            <L 149>
    // half = 0.5 - u                                                                         <L 154>
    var_1 = wp::sub(var_0, var_u);
    // x = wp.abs(half) - 0.25                                                                <L 155>
    var_2 = wp::abs(var_1);
    var_4 = wp::sub(var_2, var_3);
    // y = wp.abs(x)                                                                          <L 156>
    var_5 = wp::abs(var_4);
    // z = 0.25 - y                                                                           <L 157>
    var_7 = wp::sub(var_6, var_5);
    // nearer = y < z                                                                         <L 158>
    var_8 = (var_5 < var_7);
    // cs = sincos_eighth(wp.where(nearer, y, z))                                             <L 159>
    var_9 = wp::where(var_8, var_5, var_7);
    var_10 = sincos_eighth_0(var_9);
    // c = wp.where(nearer, cs[1], cs[0])                                                     <L 160>
    var_12 = wp::extract(var_10, var_11);
    var_14 = wp::extract(var_10, var_13);
    var_15 = wp::where(var_8, var_12, var_14);
    // s = wp.where(nearer, cs[0], cs[1])                                                     <L 161>
    var_17 = wp::extract(var_10, var_16);
    var_19 = wp::extract(var_10, var_18);
    var_20 = wp::where(var_8, var_17, var_19);
    // return wp.vec2(wp.copysign(c, x), wp.copysign(s, half))                                <L 162>
    var_21 = wp::copysign(var_15, var_4);
    var_22 = wp::copysign(var_20, var_1);
    var_23 = wp::vec_t<2, wp::float32>(var_21, var_22);
    return var_23;
}


// /work/main/warpsample/distributions/cosine_hemisphere.py:27
static wp::vec_t<3, wp::float32> square_to_cosine_hemisphere_0(
    wp::vec_t<2, wp::float32> var_u)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float32 var_1;
    wp::float32 var_2;
    const wp::int32 var_3 = 1;
    wp::float32 var_4;
    wp::vec_t<2, wp::float32> var_5;
    const wp::int32 var_6 = 0;
    wp::float32 var_7;
    wp::float32 var_8;
    const wp::int32 var_9 = 1;
    wp::float32 var_10;
    wp::float32 var_11;
    const wp::float32 var_12 = 1.0;
    const wp::int32 var_13 = 0;
    wp::float32 var_14;
    wp::float32 var_15;
    wp::float32 var_16;
    wp::vec_t<3, wp::float32> var_17;
    //---------
    // forward
    // def square_to_cosine_hemisphere(u: wp.vec2) -> wp.vec3:                                <L 28>
    // r = root(u[0])                                                                         <L 34>
    var_1 = wp::extract(var_u, var_0);
    var_2 = root_0(var_1);
    // cs = sincos_turns(u[1])                                                                <L 35>
    var_4 = wp::extract(var_u, var_3);
    var_5 = sincos_turns_0(var_4);
    // return wp.vec3(r * cs[0], r * cs[1], wp.sqrt(1.0 - u[0]))                              <L 36>
    var_7 = wp::extract(var_5, var_6);
    var_8 = wp::mul(var_2, var_7);
    var_10 = wp::extract(var_5, var_9);
    var_11 = wp::mul(var_2, var_10);
    var_14 = wp::extract(var_u, var_13);
    var_15 = wp::sub(var_12, var_14);
    var_16 = wp::sqrt(var_15);
    var_17 = wp::vec_t<3, wp::float32>(var_8, var_11, var_16);
    return var_17;
}


// /work/main/warpsample/distributions/parameters.py:43
static wp::vec_t<3, wp::float32> bind_parameters__locals__call_0(
    wp::vec_t<2, wp::float32> var_x,
    Parameters_f3aa772c var_parameters)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float32> var_0;
    //---------
    // forward
    // def call(x: argument, parameters: Parameters):                                         <L 44>
    // return func(x)                                                                         <L 46>
    var_0 = square_to_cosine_hemisphere_0(var_x);
    return var_0;
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


// /work/main/warpsample/distributions/parameters.py:69
static wp::vec_t<4, wp::float32> build_about__locals__about_0(
    wp::vec_t<3, wp::float32> var_n,
    wp::vec_t<2, wp::float32> var_u,
    Parameters_f3aa772c var_parameters)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float32> var_0;
    wp::mat_t<3, 3, wp::float32> var_1;
    wp::vec_t<3, wp::float32> var_2;
    const wp::int32 var_3 = 0;
    wp::float32 var_4;
    const wp::int32 var_5 = 1;
    wp::float32 var_6;
    const wp::int32 var_7 = 2;
    wp::float32 var_8;
    wp::float32 var_9;
    wp::vec_t<4, wp::float32> var_10;
    //---------
    // forward
    // def about(n: wp.vec3, u: wp.vec2, parameters: Parameters):                             <L 70>
    // w = sample(u, parameters)                                                              <L 72>
    var_0 = bind_parameters__locals__call_0(var_u, var_parameters);
    // d = to_world(frame_about(n), w)                                                        <L 73>
    var_1 = frame_about_0(var_n);
    var_2 = to_world_0(var_1, var_0);
    // return wp.vec4(d[0], d[1], d[2], pdf(w, parameters))                                   <L 74>
    var_4 = wp::extract(var_2, var_3);
    var_6 = wp::extract(var_2, var_5);
    var_8 = wp::extract(var_2, var_7);
    var_9 = bind_parameters__locals__call_1(var_0, var_parameters);
    var_10 = wp::vec_t<4, wp::float32>(var_4, var_6, var_8, var_9);
    return var_10;
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


// /work/main/warpsample/estimate/rays.py:59
static void directions_of__locals__write_directions_0(
    Lobes_4a4eb700 var_lobes,
    ShadingPoint_241c3e67 var_point,
    wp::int32 var_length)
{
    //---------
    // primal vars
    wp::uint64* var_0;
    const wp::int32 var_1 = 192;
    wp::tuple_t<wp::int32> var_2;
    wp::array_t<wp::float32> var_3;
    const wp::int32 var_4 = 192;
    wp::uint64 var_5;
    wp::vec_t<3, wp::float32>* var_6;
    wp::vec_t<3, wp::float32> var_7;
    wp::vec_t<3, wp::float32> var_8;
    wp::uint64* var_9;
    wp::uint64 var_10;
    wp::uint64 var_11;
    const wp::int32 var_12 = 0;
    wp::int32 var_13;
    const wp::int32 var_14 = 0;
    wp::int32 var_15;
    bool var_16;
    wp::float32* var_17;
    const wp::float32 var_18 = 0.0;
    wp::float32 var_19;
    wp::float32 var_20;
    const wp::int32 var_21 = 64;
    wp::int32 var_22;
    wp::float32* var_23;
    const wp::float32 var_24 = 0.0;
    wp::float32 var_25;
    wp::float32 var_26;
    wp::vec_t<2, wp::float32> var_27;
    Parameters_f3aa772c* var_28;
    wp::vec_t<4, wp::float32> var_29;
    Parameters_f3aa772c var_30;
    const wp::int32 var_31 = 0;
    wp::float32 var_32;
    const wp::int32 var_33 = 1;
    wp::float32 var_34;
    const wp::int32 var_35 = 2;
    wp::float32 var_36;
    wp::vec_t<3, wp::float32> var_37;
    const bool var_38 = false;
    const wp::int32 var_39 = 1;
    wp::int32 var_40;
    const bool var_41 = false;
    //---------
    // forward
    // def write_directions(lobes: Lobes, point: ShadingPoint, length: wp.int32):             <L 60>
    // u = wp.array(ptr=point.own, shape=(OWN_FLOATS,), dtype=wp.float32)                     <L 61>
    var_0 = &((var_point).own);
    var_2 = wp::tuple(var_1);
    var_5 = wp::load(var_0);
    var_3 = wp::array_t<wp::float32>(var_5, var_4);
    // n = point.n                                                                            <L 62>
    var_6 = &((var_point).n);
    var_8 = wp::load(var_6);
    var_7 = wp::copy(var_8);
    // chunk = point.chunk                                                                    <L 63>
    var_9 = &((var_point).chunk);
    var_11 = wp::load(var_9);
    var_10 = wp::copy(var_11);
    // rare = wp.int32(0)                                                                     <L 64>
    var_13 = wp::int32(var_12);
    // k = wp.int32(0)                                                                        <L 65>
    var_15 = wp::int32(var_14);
    // while k < length:                                                                      <L 66>
    start_while_0:;
    var_16 = (var_15 < var_length);
    if ((var_16) == false) goto end_while_0;
        // d = about(n, wp.vec2(u[k] + 0.0, u[CHUNK + k] + 0.0), lobes.parameters)            <L 67>
        var_17 = wp::address(var_3, var_15);
        var_20 = wp::load(var_17);
        var_19 = wp::add(var_20, var_18);
        var_22 = wp::add(var_21, var_15);
        var_23 = wp::address(var_3, var_22);
        var_26 = wp::load(var_23);
        var_25 = wp::add(var_26, var_24);
        var_27 = wp::vec_t<2, wp::float32>(var_19, var_25);
        var_28 = &((var_lobes).parameters);
        var_30 = wp::load(var_28);
        var_29 = build_about__locals__about_0(var_7, var_27, var_30);
        // set_direction(chunk, k, wp.vec3(d[0], d[1], d[2]))                                 <L 68>
        var_32 = wp::extract(var_29, var_31);
        var_34 = wp::extract(var_29, var_33);
        var_36 = wp::extract(var_29, var_35);
        var_37 = wp::vec_t<3, wp::float32>(var_32, var_34, var_36);
        set_direction_0(var_10, var_15, var_37);
        // if wp.static(redraws):                                                             <L 69>
        // k += 1                                                                             <L 71>
        var_40 = wp::add(var_15, var_39);
        wp::assign(var_15, var_40);
    goto start_while_0;
    end_while_0:;
    // if wp.static(redraws):                                                                 <L 72>
}


// /work/main/warpsample/estimate/rays.py:24
static void spread_of__locals__spread_0(
    Lobes_4a4eb700 var_lobes,
    ShadingPoint_241c3e67 var_point,
    wp::int32 var_stratum,
    wp::int32 var_first,
    wp::int32 var_length)
{
    //---------
    // primal vars
    wp::uint64* var_0;
    const wp::int32 var_1 = 192;
    wp::tuple_t<wp::int32> var_2;
    wp::array_t<wp::float32> var_3;
    const wp::int32 var_4 = 192;
    wp::uint64 var_5;
    const wp::int32 var_6 = 2;
    wp::int32 var_7;
    wp::uint32 var_8;
    wp::vec_t<4, wp::uint32>* var_9;
    wp::vec_t<4, wp::uint32> var_10;
    wp::vec_t<4, wp::uint32> var_11;
    wp::vec_t<4, wp::uint32>* var_12;
    const wp::uint32 var_13 = 1u;
    wp::uint32 var_14;
    wp::vec_t<4, wp::uint32> var_15;
    wp::vec_t<4, wp::uint32> var_16;
    wp::int32* var_17;
    wp::int32 var_18;
    wp::int32 var_19;
    wp::int32* var_20;
    wp::int32 var_21;
    wp::int32 var_22;
    wp::int32 var_23;
    wp::float32 var_24;
    const wp::float32 var_25 = 1.0;
    wp::int32* var_26;
    wp::float32 var_27;
    wp::int32 var_28;
    wp::float32 var_29;
    const wp::float32 var_30 = 1.0;
    wp::int32* var_31;
    wp::float32 var_32;
    wp::int32 var_33;
    wp::float32 var_34;
    wp::int32* var_35;
    wp::int32 var_36;
    wp::int32 var_37;
    const wp::int32 var_38 = 0;
    wp::int32 var_39;
    bool var_40;
    wp::int32 var_41;
    bool var_42;
    const wp::int32 var_43 = 1;
    const wp::int32 var_44 = 0;
    wp::int32 var_45;
    wp::vec_t<4, wp::uint32> var_46;
    wp::int32 var_47;
    wp::int32 var_48;
    wp::uint32 var_49;
    wp::uint32 var_50;
    wp::vec_t<2, wp::float32> var_51;
    const wp::int32 var_52 = 0;
    wp::float32 var_53;
    wp::float32 var_54;
    wp::float32 var_55;
    const wp::int32 var_56 = 1;
    wp::float32 var_57;
    wp::float32 var_58;
    wp::float32 var_59;
    wp::float32 var_60;
    const wp::float32 var_61 = 0.9999999403953552;
    bool var_62;
    wp::float32 var_63;
    bool var_64;
    wp::float32 var_65;
    const wp::int32 var_66 = 64;
    wp::int32 var_67;
    const wp::int32 var_68 = 1;
    wp::int32 var_69;
    //---------
    // forward
    // def spread(lobes: Lobes, point: ShadingPoint, stratum: wp.int32, first: wp.int32, length: wp.int32):       <L 25>
    // u = wp.array(ptr=point.own, shape=(OWN_FLOATS,), dtype=wp.float32)                     <L 30>
    var_0 = &((var_point).own);
    var_2 = wp::tuple(var_1);
    var_5 = wp::load(var_0);
    var_3 = wp::array_t<wp::float32>(var_5, var_4);
    // stream = wp.uint32(2 * stratum)                                                        <L 31>
    var_7 = wp::mul(var_6, var_stratum);
    var_8 = wp::uint32(var_7);
    // key = stream_key(point.key, stream)                                                    <L 32>
    var_9 = &((var_point).key);
    var_11 = wp::load(var_9);
    var_10 = stream_key_0(var_11, var_8);
    // other = stream_key(point.key, stream + ONE_WORD)                                       <L 33>
    var_12 = &((var_point).key);
    var_14 = wp::add(var_8, var_13);
    var_16 = wp::load(var_12);
    var_15 = stream_key_0(var_16, var_14);
    // sector = stratum / lobes.bands                                                         <L 34>
    var_17 = &((var_lobes).bands);
    var_19 = wp::load(var_17);
    var_18 = wp::div(var_stratum, var_19);
    // band = wp.float32(stratum - sector * lobes.bands)                                      <L 35>
    var_20 = &((var_lobes).bands);
    var_22 = wp::load(var_20);
    var_21 = wp::mul(var_18, var_22);
    var_23 = wp::sub(var_stratum, var_21);
    var_24 = wp::float32(var_23);
    // band_size = 1.0 / wp.float32(lobes.bands)                                              <L 36>
    var_26 = &((var_lobes).bands);
    var_28 = wp::load(var_26);
    var_27 = wp::float32(var_28);
    var_29 = wp::div(var_25, var_27);
    // sector_size = 1.0 / wp.float32(lobes.sectors)                                          <L 37>
    var_31 = &((var_lobes).sectors);
    var_33 = wp::load(var_31);
    var_32 = wp::float32(var_33);
    var_34 = wp::div(var_30, var_32);
    // samples = lobes.samples_per_stratum                                                    <L 38>
    var_35 = &((var_lobes).samples_per_stratum);
    var_37 = wp::load(var_35);
    var_36 = wp::copy(var_37);
    // k = wp.int32(0)                                                                        <L 39>
    var_39 = wp::int32(var_38);
    // while k < length:                                                                      <L 40>
    start_while_0:;
    var_40 = (var_39 < var_length);
    if ((var_40) == false) goto end_while_0;
        // i = first + k                                                                      <L 41>
        var_41 = wp::add(var_first, var_39);
        // second = wp.where(i >= samples, 1, 0)                                              <L 42>
        var_42 = (var_41 >= var_36);
        var_45 = wp::where(var_42, var_43, var_44);
        // p = sample(select_key(key, other, second), wp.uint32(i - second * samples), wp.uint32(samples))       <L 43>
        var_46 = select_key_0(var_10, var_15, var_45);
        var_47 = wp::mul(var_45, var_36);
        var_48 = wp::sub(var_41, var_47);
        var_49 = wp::uint32(var_48);
        var_50 = wp::uint32(var_36);
        var_51 = fibonacci_sample_0(var_46, var_49, var_50);
        // x = (p[0] + band) * band_size                                                      <L 44>
        var_53 = wp::extract(var_51, var_52);
        var_54 = wp::add(var_53, var_24);
        var_55 = wp::mul(var_54, var_29);
        // y = (p[1] + wp.float32(sector)) * sector_size                                      <L 45>
        var_57 = wp::extract(var_51, var_56);
        var_58 = wp::float32(var_18);
        var_59 = wp::add(var_57, var_58);
        var_60 = wp::mul(var_59, var_34);
        // u[k] = wp.where(x < LAST_UNIFORM, x, LAST_UNIFORM)  # where the sum is rounded up to the next stratum       <L 46>
        var_62 = (var_55 < var_61);
        var_63 = wp::where(var_62, var_55, var_61);
        wp::array_store(var_3, var_39, var_63);
        // u[CHUNK + k] = wp.where(y < LAST_UNIFORM, y, LAST_UNIFORM)                         <L 47>
        var_64 = (var_60 < var_61);
        var_65 = wp::where(var_64, var_60, var_61);
        var_67 = wp::add(var_66, var_39);
        wp::array_store(var_3, var_67, var_65);
        // k += 1                                                                             <L 48>
        var_69 = wp::add(var_39, var_68);
        wp::assign(var_39, var_69);
    goto start_while_0;
    end_while_0:;
    // directions(lobes, point, length)                                                       <L 49>
    directions_of__locals__write_directions_0(var_lobes, var_point, var_length);
}


// /work/main/warpsample/tracing/sight/packets.py:32
static wp::uint64 first_rays_0(
    wp::int32 var_length)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    bool var_1;
    const wp::uint64 var_2 = 0ull;
    wp::uint64 var_3;
    const wp::int32 var_4 = 64;
    wp::int32 var_5;
    wp::int32 var_6;
    wp::uint64 var_7;
    wp::uint64 var_8;
    wp::uint64 var_9;
    //---------
    // forward
    // def first_rays(length: wp.int32) -> wp.uint64:                                         <L 33>
    // return wp.where(length > 0, (~NO_RAYS) >> wp.uint64((CHUNK - length) % CHUNK), NO_RAYS)       <L 35>
    var_1 = (var_length > var_0);
    var_3 = wp::invert(var_2);
    var_5 = wp::sub(var_4, var_length);
    var_6 = wp::mod(var_5, var_4);
    var_7 = wp::uint64(var_6);
    var_8 = wp::rshift(var_3, var_7);
    var_9 = wp::where(var_1, var_8, var_2);
    return var_9;
}


// /work/main/warpsample/estimate/stratum.py:107
static wp::uint64 weighing__locals__weigh_rays_0(
    Lobe_95707b65 var_lobe,
    Weights_23742fab var_data,
    ShadingPoint_241c3e67 var_point,
    wp::int32 var_length)
{
    //---------
    // primal vars
    wp::uint64 var_0;
    const bool var_1 = false;
    //---------
    // forward
    // def weigh_rays(lobe: Lobe, data: struct, point: ShadingPoint, length: wp.int32) -> wp.uint64:       <L 108>
    // alive = first_rays(length)                                                             <L 110>
    var_0 = first_rays_0(var_length);
    // if wp.static(not constant):                                                            <L 111>
    // return alive                                                                           <L 118>
    return var_0;
}


// /work/main/warpsample/tracing/queries.py:50
static wp::uint64 column_of_0(
    wp::uint64 var_chunk,
    wp::int32 var_k)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 4;
    wp::int32 var_1;
    wp::uint64 var_2;
    wp::uint64 var_3;
    //---------
    // forward
    // def column_of(chunk: wp.uint64, k: wp.int32) -> wp.uint64:                             <L 51>
    // return chunk + wp.uint64(4 * k)                                                        <L 53>
    var_1 = wp::mul(var_0, var_k);
    var_2 = wp::uint64(var_1);
    var_3 = wp::add(var_chunk, var_2);
    return var_3;
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


// /work/main/warpsample/tracing/queries.py:62
static wp::vec_t<3, wp::float32> direction_of_0(
    wp::uint64 var_chunk,
    wp::int32 var_k)
{
    //---------
    // primal vars
    wp::uint64 var_0;
    const wp::int32 var_1 = 192;
    wp::vec_t<3, wp::float32> var_2;
    //---------
    // forward
    // def direction_of(chunk: wp.uint64, k: wp.int32) -> wp.vec3:                            <L 63>
    // return vector_in(column_of(chunk, k), DIRECTION)                                       <L 65>
    var_0 = column_of_0(var_chunk, var_k);
    var_2 = vector_in_0(var_0, var_1);
    return var_2;
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


// /work/main/warpsample/tracing/sight/point.py:164
static void move_ray_near_0(
    ShadingPoint_241c3e67 var_point,
    wp::int32 var_k,
    wp::vec_t<3, wp::float64> var_d)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float64>* var_0;
    wp::float64 var_1;
    wp::vec_t<3, wp::float64> var_2;
    wp::uint64* var_3;
    wp::vec_t<3, wp::float64>* var_4;
    wp::vec_t<3, wp::float64> var_5;
    wp::vec_t<3, wp::float64> var_6;
    wp::vec_t<3, wp::float64> var_7;
    wp::vec_t<3, wp::float32> var_8;
    wp::uint64 var_9;
    const wp::float64 var_10 = 0.0;
    bool var_11;
    const wp::float32 var_12 = -1.0;
    wp::float32* var_13;
    wp::float64 var_14;
    wp::float32 var_15;
    wp::float64 var_16;
    wp::float32 var_17;
    wp::float32 var_18;
    wp::uint64* var_19;
    wp::uint64 var_20;
    wp::uint64 var_21;
    const wp::int32 var_22 = 384;
    //---------
    // forward
    // def move_ray_near(point: ShadingPoint, k: wp.int32, d: wp.vec3d):                      <L 165>
    // ahead = distance_to_scene(point.position, d)                                           <L 170>
    var_0 = &((var_point).position);
    var_2 = wp::load(var_0);
    var_1 = distance_to_scene_0(var_2, var_d);
    // set_origin(point.chunk, k, wp.vec3(point.position + ahead * d))                        <L 171>
    var_3 = &((var_point).chunk);
    var_4 = &((var_point).position);
    var_5 = wp::mul(var_1, var_d);
    var_7 = wp::load(var_4);
    var_6 = wp::add(var_7, var_5);
    var_8 = wp::vec_t<3, wp::float32>(var_6);
    var_9 = wp::load(var_3);
    set_origin_0(var_9, var_k, var_8);
    // reach = wp.where(ahead < ZERO, -1.0, wp.float32(wp.float64(point.reach) - ahead))       <L 172>
    var_11 = (var_1 < var_10);
    var_13 = &((var_point).reach);
    var_15 = wp::load(var_13);
    var_14 = wp::float64(var_15);
    var_16 = wp::sub(var_14, var_1);
    var_17 = wp::float32(var_16);
    var_18 = wp::where(var_11, var_12, var_17);
    // set_float(column_of(point.chunk, k), REACH, reach)                                     <L 173>
    var_19 = &((var_point).chunk);
    var_21 = wp::load(var_19);
    var_20 = column_of_0(var_21, var_k);
    _writer__locals__write_0(var_20, var_22, var_18);
}


// /work/main/warpsample/tracing/sight/rays.py:25
static void move_rays_near_0(
    ShadingPoint_241c3e67 var_point,
    wp::int32 var_length)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float64>* var_0;
    bool var_1;
    wp::vec_t<3, wp::float64> var_2;
    wp::range_t var_3;
    wp::int32 var_4;
    wp::uint64* var_5;
    wp::vec_t<3, wp::float32> var_6;
    wp::uint64 var_7;
    wp::vec_t<3, wp::float64> var_8;
    //---------
    // forward
    // def move_rays_near(point: ShadingPoint, length: wp.int32):                             <L 26>
    // if is_far_off(point.position):                                                         <L 28>
    var_0 = &((var_point).position);
    var_2 = wp::load(var_0);
    var_1 = is_far_off_0(var_2);
    if (var_1) {
        // for k in range(length):                                                            <L 29>
        var_3 = wp::range(var_length);
        start_for_0:;
            if (iter_cmp(var_3) == 0) goto end_for_0;
            var_4 = wp::iter_next(var_3);
            // move_ray_near(point, k, in_double(direction_of(point.chunk, k)))               <L 30>
            var_5 = &((var_point).chunk);
            var_7 = wp::load(var_5);
            var_6 = direction_of_0(var_7, var_4);
            var_8 = in_double_0(var_6);
            move_ray_near_0(var_point, var_4, var_8);
            goto start_for_0;
        end_for_0:;
    }
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


// /work/main/warpsample/tracing/sight/rays.py:37
static void prepare_rays__locals__prepare_chunk_0(
    Accelerator_9fc73cd7 var_tree,
    ShadingPoint_241c3e67 var_point,
    wp::int32 var_local,
    wp::int32 var_length)
{
    //---------
    // primal vars
    wp::uint64* var_0;
    wp::int32 var_1;
    wp::uint64 var_2;
    //---------
    // forward
    // def prepare_chunk(tree: Accelerator, point: ShadingPoint, local: wp.int32, length: wp.int32):       <L 38>
    // prepare(point.chunk, whole_vectors(length))                                            <L 39>
    var_0 = &((var_point).chunk);
    var_1 = whole_vectors_0(var_length);
    var_2 = wp::load(var_0);
    prepare_wide_0(var_2, var_1);
}


// /work/main/warpsample/tracing/sight/packets.py:38
static wp::int32 set_size_0(
    wp::uint64 var_rays)
{
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int32 var_1;
    //---------
    // forward
    // def set_size(rays: wp.uint64) -> wp.int32:                                             <L 39>
    // return wp.int32(wp.bit_count(rays))                                                    <L 41>
    var_0 = wp::bit_count(var_rays);
    var_1 = wp::int32(var_0);
    return var_1;
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


// /work/main/warpsample/tracing/sight/sides.py:30
static wp::vec_t<3, wp::float32> _cross_0(
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 1;
    wp::float32 var_1;
    const wp::int32 var_2 = 2;
    wp::float32 var_3;
    const wp::int32 var_4 = 2;
    wp::float32 var_5;
    const wp::int32 var_6 = 1;
    wp::float32 var_7;
    wp::float32 var_8;
    wp::float32 var_9;
    wp::float32 var_10;
    const wp::int32 var_11 = 2;
    wp::float32 var_12;
    const wp::int32 var_13 = 0;
    wp::float32 var_14;
    const wp::int32 var_15 = 0;
    wp::float32 var_16;
    const wp::int32 var_17 = 2;
    wp::float32 var_18;
    wp::float32 var_19;
    wp::float32 var_20;
    wp::float32 var_21;
    const wp::int32 var_22 = 0;
    wp::float32 var_23;
    const wp::int32 var_24 = 1;
    wp::float32 var_25;
    const wp::int32 var_26 = 1;
    wp::float32 var_27;
    const wp::int32 var_28 = 0;
    wp::float32 var_29;
    wp::float32 var_30;
    wp::float32 var_31;
    wp::float32 var_32;
    wp::vec_t<3, wp::float32> var_33;
    //---------
    // forward
    // def _cross(a: wp.vec3, b: wp.vec3) -> wp.vec3:                                         <L 31>
    // return wp.vec3(                                                                        <L 33>
    // fma(a[1], b[2], negative(a[2] * b[1])),                                                <L 34>
    var_1 = wp::extract(var_a, var_0);
    var_3 = wp::extract(var_b, var_2);
    var_5 = wp::extract(var_a, var_4);
    var_7 = wp::extract(var_b, var_6);
    var_8 = wp::mul(var_5, var_7);
    var_9 = negative_0(var_8);
    var_10 = fma_0(var_1, var_3, var_9);
    // fma(a[2], b[0], negative(a[0] * b[2])),                                                <L 35>
    var_12 = wp::extract(var_a, var_11);
    var_14 = wp::extract(var_b, var_13);
    var_16 = wp::extract(var_a, var_15);
    var_18 = wp::extract(var_b, var_17);
    var_19 = wp::mul(var_16, var_18);
    var_20 = negative_0(var_19);
    var_21 = fma_0(var_12, var_14, var_20);
    // fma(a[0], b[1], negative(a[1] * b[0])),                                                <L 36>
    var_23 = wp::extract(var_a, var_22);
    var_25 = wp::extract(var_b, var_24);
    var_27 = wp::extract(var_a, var_26);
    var_29 = wp::extract(var_b, var_28);
    var_30 = wp::mul(var_27, var_29);
    var_31 = negative_0(var_30);
    var_32 = fma_0(var_23, var_25, var_31);
    var_33 = wp::vec_t<3, wp::float32>(var_10, var_21, var_32);
    return var_33;
}


// /work/main/warpsample/tracing/sight/sides.py:40
static void open_leaf_0(
    wp::uint64 var_leaf,
    wp::vec_t<3, wp::float32> var_o,
    wp::float32 var_reach,
    wp::uint64 var_sides)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 192;
    wp::tuple_t<wp::int32> var_1;
    wp::array_t<wp::float32> var_2;
    const wp::int32 var_3 = 192;
    const wp::int32 var_4 = 144;
    wp::tuple_t<wp::int32> var_5;
    wp::array_t<wp::float32> var_6;
    const wp::int32 var_7 = 144;
    wp::tuple_t<wp::int32> var_8;
    wp::fixedarray_t<144, wp::float32> var_9;
    const wp::int32 var_10 = 144;
    wp::uint64* var_11;
    wp::tuple_t<wp::int32> var_12;
    wp::array_t<wp::float32> var_13;
    const wp::int32 var_14 = 144;
    wp::uint64 var_15;
    const wp::int32 var_16 = 0;
    wp::int32 var_17;
    bool var_18;
    wp::float32* var_19;
    wp::float32 var_20;
    wp::float32 var_21;
    const wp::int32 var_22 = 1;
    wp::int32 var_23;
    const wp::int32 var_24 = 0;
    wp::int32 var_25;
    const wp::int32 var_26 = 16;
    bool var_27;
    wp::float32* var_28;
    wp::int32 var_29;
    wp::float32* var_30;
    const wp::int32 var_31 = 2;
    wp::int32 var_32;
    wp::int32 var_33;
    wp::float32* var_34;
    wp::vec_t<3, wp::float32> var_35;
    wp::float32 var_36;
    wp::float32 var_37;
    wp::float32 var_38;
    const wp::int32 var_39 = 3;
    wp::int32 var_40;
    wp::int32 var_41;
    wp::float32* var_42;
    const wp::int32 var_43 = 4;
    wp::int32 var_44;
    wp::int32 var_45;
    wp::float32* var_46;
    const wp::int32 var_47 = 5;
    wp::int32 var_48;
    wp::int32 var_49;
    wp::float32* var_50;
    wp::vec_t<3, wp::float32> var_51;
    wp::float32 var_52;
    wp::float32 var_53;
    wp::float32 var_54;
    const wp::int32 var_55 = 6;
    wp::int32 var_56;
    wp::int32 var_57;
    wp::float32* var_58;
    const wp::int32 var_59 = 7;
    wp::int32 var_60;
    wp::int32 var_61;
    wp::float32* var_62;
    const wp::int32 var_63 = 8;
    wp::int32 var_64;
    wp::int32 var_65;
    wp::float32* var_66;
    wp::vec_t<3, wp::float32> var_67;
    wp::float32 var_68;
    wp::float32 var_69;
    wp::float32 var_70;
    wp::vec_t<3, wp::float32> var_71;
    wp::vec_t<3, wp::float32> var_72;
    wp::vec_t<3, wp::float32> var_73;
    wp::vec_t<3, wp::float32> var_74;
    wp::vec_t<3, wp::float32> var_75;
    wp::vec_t<3, wp::float32> var_76;
    wp::vec_t<3, wp::float32> var_77;
    wp::vec_t<3, wp::float32> var_78;
    wp::vec_t<3, wp::float32> var_79;
    wp::vec_t<3, wp::float32> var_80;
    const wp::int32 var_81 = 0;
    wp::float32 var_82;
    const wp::int32 var_83 = 0;
    wp::float32 var_84;
    const wp::int32 var_85 = 1;
    wp::float32 var_86;
    const wp::int32 var_87 = 1;
    wp::float32 var_88;
    const wp::int32 var_89 = 2;
    wp::float32 var_90;
    const wp::int32 var_91 = 2;
    wp::float32 var_92;
    wp::float32 var_93;
    wp::float32 var_94;
    wp::float32 var_95;
    wp::float32 var_96;
    wp::float32 var_97;
    wp::float32 var_98;
    wp::float32 var_99;
    wp::float32 var_100;
    wp::float32 var_101;
    wp::float32 var_102;
    wp::float32 var_103;
    wp::float32 var_104;
    wp::float32 var_105;
    const wp::float32 var_106 = 2.384185791015625e-07;
    wp::float32 var_107;
    const wp::float32 var_108 = 9.5367431640625e-07;
    wp::float32 var_109;
    wp::float32 var_110;
    const wp::float32 var_111 = 0.0;
    bool var_112;
    const wp::float32 var_113 = -1.0;
    const wp::float32 var_114 = 1.0;
    wp::float32 var_115;
    const wp::int32 var_116 = 0;
    wp::float32 var_117;
    wp::float32 var_118;
    const wp::int32 var_119 = 1;
    wp::float32 var_120;
    wp::float32 var_121;
    wp::int32 var_122;
    const wp::int32 var_123 = 2;
    wp::float32 var_124;
    wp::float32 var_125;
    const wp::int32 var_126 = 2;
    wp::int32 var_127;
    wp::int32 var_128;
    const wp::int32 var_129 = 0;
    wp::float32 var_130;
    wp::float32 var_131;
    const wp::int32 var_132 = 3;
    wp::int32 var_133;
    wp::int32 var_134;
    const wp::int32 var_135 = 1;
    wp::float32 var_136;
    wp::float32 var_137;
    const wp::int32 var_138 = 4;
    wp::int32 var_139;
    wp::int32 var_140;
    const wp::int32 var_141 = 2;
    wp::float32 var_142;
    wp::float32 var_143;
    const wp::int32 var_144 = 5;
    wp::int32 var_145;
    wp::int32 var_146;
    const wp::int32 var_147 = 0;
    wp::float32 var_148;
    wp::float32 var_149;
    const wp::int32 var_150 = 6;
    wp::int32 var_151;
    wp::int32 var_152;
    const wp::int32 var_153 = 1;
    wp::float32 var_154;
    wp::float32 var_155;
    const wp::int32 var_156 = 7;
    wp::int32 var_157;
    wp::int32 var_158;
    const wp::int32 var_159 = 2;
    wp::float32 var_160;
    wp::float32 var_161;
    const wp::int32 var_162 = 8;
    wp::int32 var_163;
    wp::int32 var_164;
    wp::float32 var_165;
    wp::float32 var_166;
    bool var_167;
    const wp::float32 var_168 = 0.9999990463256836;
    wp::float32 var_169;
    bool var_170;
    const wp::float32 var_171 = 1.152921504606847e+18;
    wp::float32 var_172;
    wp::float32 var_173;
    const wp::int32 var_174 = 144;
    wp::int32 var_175;
    wp::float32 var_176;
    const wp::int32 var_177 = 160;
    wp::int32 var_178;
    wp::float32 var_179;
    wp::float32 var_180;
    const wp::int32 var_181 = 176;
    wp::int32 var_182;
    const wp::int32 var_183 = 1;
    wp::int32 var_184;
    //---------
    // forward
    // def open_leaf(leaf: wp.uint64, o: wp.vec3, reach: wp.float32, sides: wp.uint64):       <L 41>
    // rows = wp.array(ptr=sides, shape=(SIDES_FLOATS,), dtype=wp.float32)                    <L 49>
    var_1 = wp::tuple(var_0);
    var_2 = wp::array_t<wp::float32>(var_sides, var_3);
    // given = wp.array(ptr=leaf, shape=(_CORNER_FLOATS,), dtype=wp.float32)                  <L 50>
    var_5 = wp::tuple(var_4);
    var_6 = wp::array_t<wp::float32>(var_leaf, var_7);
    // local = wp.zeros(shape=(_CORNER_FLOATS,), dtype=wp.float32)                            <L 52>
    var_8 = wp::tuple(var_4);
    var_9 = wp::fixedarray_t<144, wp::float32>(var_10);
    // corners = wp.array(ptr=local.ptr, shape=(_CORNER_FLOATS,), dtype=wp.float32)           <L 53>
    var_11 = (wp::uint64*)&(var_9.data);
    var_12 = wp::tuple(var_4);
    var_15 = wp::load(var_11);
    var_13 = wp::array_t<wp::float32>(var_15, var_14);
    // i = wp.int32(0)                                                                        <L 54>
    var_17 = wp::int32(var_16);
    // while i < _CORNER_FLOATS:                                                              <L 55>
    start_while_0:;
    var_18 = (var_17 < var_4);
    if ((var_18) == false) goto end_while_0;
        // corners[i] = given[i]                                                              <L 56>
        var_19 = wp::address(var_6, var_17);
        var_21 = wp::load(var_19);
        var_20 = wp::copy(var_21);
        wp::array_store(var_13, var_17, var_20);
        // i += 1                                                                             <L 57>
        var_23 = wp::add(var_17, var_22);
        wp::assign(var_17, var_23);
    goto start_while_0;
    end_while_0:;
    // k = wp.int32(0)                                                                        <L 58>
    var_25 = wp::int32(var_24);
    // while k < WIDTH:                                                                       <L 59>
    start_while_2:;
    var_27 = (var_25 < var_26);
    if ((var_27) == false) goto end_while_2;
        // first = wp.vec3(corners[k], corners[WIDTH + k], corners[2 * WIDTH + k])            <L 60>
        var_28 = wp::address(var_13, var_25);
        var_29 = wp::add(var_26, var_25);
        var_30 = wp::address(var_13, var_29);
        var_32 = wp::mul(var_31, var_26);
        var_33 = wp::add(var_32, var_25);
        var_34 = wp::address(var_13, var_33);
        var_36 = wp::load(var_28);
        var_37 = wp::load(var_30);
        var_38 = wp::load(var_34);
        var_35 = wp::vec_t<3, wp::float32>(var_36, var_37, var_38);
        // second = wp.vec3(corners[3 * WIDTH + k], corners[4 * WIDTH + k], corners[5 * WIDTH + k])       <L 61>
        var_40 = wp::mul(var_39, var_26);
        var_41 = wp::add(var_40, var_25);
        var_42 = wp::address(var_13, var_41);
        var_44 = wp::mul(var_43, var_26);
        var_45 = wp::add(var_44, var_25);
        var_46 = wp::address(var_13, var_45);
        var_48 = wp::mul(var_47, var_26);
        var_49 = wp::add(var_48, var_25);
        var_50 = wp::address(var_13, var_49);
        var_52 = wp::load(var_42);
        var_53 = wp::load(var_46);
        var_54 = wp::load(var_50);
        var_51 = wp::vec_t<3, wp::float32>(var_52, var_53, var_54);
        // third = wp.vec3(corners[6 * WIDTH + k], corners[7 * WIDTH + k], corners[8 * WIDTH + k])       <L 62>
        var_56 = wp::mul(var_55, var_26);
        var_57 = wp::add(var_56, var_25);
        var_58 = wp::address(var_13, var_57);
        var_60 = wp::mul(var_59, var_26);
        var_61 = wp::add(var_60, var_25);
        var_62 = wp::address(var_13, var_61);
        var_64 = wp::mul(var_63, var_26);
        var_65 = wp::add(var_64, var_25);
        var_66 = wp::address(var_13, var_65);
        var_68 = wp::load(var_58);
        var_69 = wp::load(var_62);
        var_70 = wp::load(var_66);
        var_67 = wp::vec_t<3, wp::float32>(var_68, var_69, var_70);
        // a = first - o                                                                      <L 63>
        var_71 = wp::sub(var_35, var_o);
        // b = second - o                                                                     <L 64>
        var_72 = wp::sub(var_51, var_o);
        // c = third - o                                                                      <L 65>
        var_73 = wp::sub(var_67, var_o);
        // e = second - first                                                                 <L 66>
        var_74 = wp::sub(var_51, var_35);
        // f = third - second                                                                 <L 67>
        var_75 = wp::sub(var_67, var_51);
        // g = first - third                                                                  <L 68>
        var_76 = wp::sub(var_35, var_67);
        // p = _cross(a, e)                                                                   <L 69>
        var_77 = _cross_0(var_71, var_74);
        // q = _cross(b, f)                                                                   <L 70>
        var_78 = _cross_0(var_72, var_75);
        // r = _cross(c, g)                                                                   <L 71>
        var_79 = _cross_0(var_73, var_76);
        // n = _cross(g, e)                                                                   <L 72>
        var_80 = _cross_0(var_76, var_74);
        // height = fma(n[0], a[0], fma(n[1], a[1], n[2] * a[2]))                             <L 73>
        var_82 = wp::extract(var_80, var_81);
        var_84 = wp::extract(var_71, var_83);
        var_86 = wp::extract(var_80, var_85);
        var_88 = wp::extract(var_71, var_87);
        var_90 = wp::extract(var_80, var_89);
        var_92 = wp::extract(var_71, var_91);
        var_93 = wp::mul(var_90, var_92);
        var_94 = fma_0(var_86, var_88, var_93);
        var_95 = fma_0(var_82, var_84, var_94);
        // far = greater(greater(size_of(a), size_of(b)), size_of(c))                         <L 74>
        var_96 = size_of_0(var_71);
        var_97 = size_of_0(var_72);
        var_98 = greater_0(var_96, var_97);
        var_99 = size_of_0(var_73);
        var_100 = greater_0(var_98, var_99);
        // edge = greater(greater(greater(size_of(e), size_of(f)), size_of(g)), _LEAST_EDGE)       <L 75>
        var_101 = size_of_0(var_74);
        var_102 = size_of_0(var_75);
        var_103 = greater_0(var_101, var_102);
        var_104 = size_of_0(var_76);
        var_105 = greater_0(var_103, var_104);
        var_107 = greater_0(var_105, var_106);
        // margin = _MARGIN * far * edge                                                      <L 76>
        var_109 = wp::mul(var_108, var_100);
        var_110 = wp::mul(var_109, var_107);
        // turn = wp.where(height < 0.0, -1.0, 1.0)                                           <L 77>
        var_112 = (var_95 < var_111);
        var_115 = wp::where(var_112, var_113, var_114);
        // rows[k] = turn * p[0]                                                              <L 78>
        var_117 = wp::extract(var_77, var_116);
        var_118 = wp::mul(var_115, var_117);
        wp::array_store(var_2, var_25, var_118);
        // rows[WIDTH + k] = turn * p[1]                                                      <L 79>
        var_120 = wp::extract(var_77, var_119);
        var_121 = wp::mul(var_115, var_120);
        var_122 = wp::add(var_26, var_25);
        wp::array_store(var_2, var_122, var_121);
        // rows[2 * WIDTH + k] = turn * p[2]                                                  <L 80>
        var_124 = wp::extract(var_77, var_123);
        var_125 = wp::mul(var_115, var_124);
        var_127 = wp::mul(var_126, var_26);
        var_128 = wp::add(var_127, var_25);
        wp::array_store(var_2, var_128, var_125);
        // rows[3 * WIDTH + k] = turn * q[0]                                                  <L 81>
        var_130 = wp::extract(var_78, var_129);
        var_131 = wp::mul(var_115, var_130);
        var_133 = wp::mul(var_132, var_26);
        var_134 = wp::add(var_133, var_25);
        wp::array_store(var_2, var_134, var_131);
        // rows[4 * WIDTH + k] = turn * q[1]                                                  <L 82>
        var_136 = wp::extract(var_78, var_135);
        var_137 = wp::mul(var_115, var_136);
        var_139 = wp::mul(var_138, var_26);
        var_140 = wp::add(var_139, var_25);
        wp::array_store(var_2, var_140, var_137);
        // rows[5 * WIDTH + k] = turn * q[2]                                                  <L 83>
        var_142 = wp::extract(var_78, var_141);
        var_143 = wp::mul(var_115, var_142);
        var_145 = wp::mul(var_144, var_26);
        var_146 = wp::add(var_145, var_25);
        wp::array_store(var_2, var_146, var_143);
        // rows[6 * WIDTH + k] = turn * r[0]                                                  <L 84>
        var_148 = wp::extract(var_79, var_147);
        var_149 = wp::mul(var_115, var_148);
        var_151 = wp::mul(var_150, var_26);
        var_152 = wp::add(var_151, var_25);
        wp::array_store(var_2, var_152, var_149);
        // rows[7 * WIDTH + k] = turn * r[1]                                                  <L 85>
        var_154 = wp::extract(var_79, var_153);
        var_155 = wp::mul(var_115, var_154);
        var_157 = wp::mul(var_156, var_26);
        var_158 = wp::add(var_157, var_25);
        wp::array_store(var_2, var_158, var_155);
        // rows[8 * WIDTH + k] = turn * r[2]                                                  <L 86>
        var_160 = wp::extract(var_79, var_159);
        var_161 = wp::mul(var_115, var_160);
        var_163 = wp::mul(var_162, var_26);
        var_164 = wp::add(var_163, var_25);
        wp::array_store(var_2, var_164, var_161);
        // from_edge = wp.abs(height) <= margin * edge                                        <L 87>
        var_165 = wp::abs(var_95);
        var_166 = wp::mul(var_110, var_107);
        var_167 = (var_165 <= var_166);
        // within = far < reach * _NEARER                                                     <L 88>
        var_169 = wp::mul(var_reach, var_168);
        var_170 = (var_100 < var_169);
        // rows[_SURE + k] = wp.where(from_edge, _NEVER, wp.where(within, margin, _NEVER))       <L 89>
        var_172 = wp::where(var_170, var_110, var_171);
        var_173 = wp::where(var_167, var_171, var_172);
        var_175 = wp::add(var_174, var_25);
        wp::array_store(var_2, var_175, var_173);
        // rows[_OUTSIDE + k] = negative(margin)                                              <L 90>
        var_176 = negative_0(var_110);
        var_178 = wp::add(var_177, var_25);
        wp::array_store(var_2, var_178, var_176);
        // rows[_BEHIND + k] = wp.where(from_edge, margin, -_NEVER)                           <L 91>
        var_179 = wp::neg(var_171);
        var_180 = wp::where(var_167, var_110, var_179);
        var_182 = wp::add(var_181, var_25);
        wp::array_store(var_2, var_182, var_180);
        // k += 1                                                                             <L 92>
        var_184 = wp::add(var_25, var_183);
        wp::assign(var_25, var_184);
    goto start_while_2;
    end_while_2:;
}


// /work/main/warpsample/tracing/sight/sides.py:95
static wp::int32 _classify_ray_0(
    wp::vec_t<3, wp::float32> var_d,
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> var_q,
    wp::vec_t<3, wp::float32> var_r,
    wp::float32 var_sure,
    wp::float32 var_outside,
    wp::float32 var_behind)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float32 var_1;
    const wp::int32 var_2 = 0;
    wp::float32 var_3;
    const wp::int32 var_4 = 1;
    wp::float32 var_5;
    const wp::int32 var_6 = 1;
    wp::float32 var_7;
    const wp::int32 var_8 = 2;
    wp::float32 var_9;
    const wp::int32 var_10 = 2;
    wp::float32 var_11;
    wp::float32 var_12;
    wp::float32 var_13;
    wp::float32 var_14;
    const wp::int32 var_15 = 0;
    wp::float32 var_16;
    const wp::int32 var_17 = 0;
    wp::float32 var_18;
    const wp::int32 var_19 = 1;
    wp::float32 var_20;
    const wp::int32 var_21 = 1;
    wp::float32 var_22;
    const wp::int32 var_23 = 2;
    wp::float32 var_24;
    const wp::int32 var_25 = 2;
    wp::float32 var_26;
    wp::float32 var_27;
    wp::float32 var_28;
    wp::float32 var_29;
    const wp::int32 var_30 = 0;
    wp::float32 var_31;
    const wp::int32 var_32 = 0;
    wp::float32 var_33;
    const wp::int32 var_34 = 1;
    wp::float32 var_35;
    const wp::int32 var_36 = 1;
    wp::float32 var_37;
    const wp::int32 var_38 = 2;
    wp::float32 var_39;
    const wp::int32 var_40 = 2;
    wp::float32 var_41;
    wp::float32 var_42;
    wp::float32 var_43;
    wp::float32 var_44;
    wp::float32 var_45;
    wp::float32 var_46;
    wp::float32 var_47;
    wp::float32 var_48;
    bool var_49;
    const wp::int32 var_50 = -2147483648;
    const wp::int32 var_51 = 0;
    wp::int32 var_52;
    bool var_53;
    const wp::int32 var_54 = 0;
    wp::int32 var_55;
    wp::int32 var_56;
    bool var_57;
    const wp::int32 var_58 = 1073741824;
    const wp::int32 var_59 = 0;
    wp::int32 var_60;
    wp::int32 var_61;
    //---------
    // forward
    // def _classify_ray(                                                                     <L 96>
    // u = fma(p[0], d[0], fma(p[1], d[1], p[2] * d[2]))                                      <L 100>
    var_1 = wp::extract(var_p, var_0);
    var_3 = wp::extract(var_d, var_2);
    var_5 = wp::extract(var_p, var_4);
    var_7 = wp::extract(var_d, var_6);
    var_9 = wp::extract(var_p, var_8);
    var_11 = wp::extract(var_d, var_10);
    var_12 = wp::mul(var_9, var_11);
    var_13 = fma_0(var_5, var_7, var_12);
    var_14 = fma_0(var_1, var_3, var_13);
    // v = fma(q[0], d[0], fma(q[1], d[1], q[2] * d[2]))                                      <L 101>
    var_16 = wp::extract(var_q, var_15);
    var_18 = wp::extract(var_d, var_17);
    var_20 = wp::extract(var_q, var_19);
    var_22 = wp::extract(var_d, var_21);
    var_24 = wp::extract(var_q, var_23);
    var_26 = wp::extract(var_d, var_25);
    var_27 = wp::mul(var_24, var_26);
    var_28 = fma_0(var_20, var_22, var_27);
    var_29 = fma_0(var_16, var_18, var_28);
    // w = fma(r[0], d[0], fma(r[1], d[1], r[2] * d[2]))                                      <L 102>
    var_31 = wp::extract(var_r, var_30);
    var_33 = wp::extract(var_d, var_32);
    var_35 = wp::extract(var_r, var_34);
    var_37 = wp::extract(var_d, var_36);
    var_39 = wp::extract(var_r, var_38);
    var_41 = wp::extract(var_d, var_40);
    var_42 = wp::mul(var_39, var_41);
    var_43 = fma_0(var_35, var_37, var_42);
    var_44 = fma_0(var_31, var_33, var_43);
    // least = lesser(lesser(u, v), w)                                                        <L 103>
    var_45 = lesser_0(var_14, var_29);
    var_46 = lesser_0(var_45, var_44);
    // most = greater(greater(u, v), w)                                                       <L 104>
    var_47 = greater_0(var_14, var_29);
    var_48 = greater_0(var_47, var_44);
    // may = wp.where(least >= outside, _MAYBE, 0) | wp.where(most <= behind, _MAYBE, 0)       <L 105>
    var_49 = (var_46 >= var_outside);
    var_52 = wp::where(var_49, var_50, var_51);
    var_53 = (var_48 <= var_behind);
    var_55 = wp::where(var_53, var_50, var_54);
    var_56 = wp::bit_or(var_52, var_55);
    // return may | wp.where(least > sure, _SURELY, 0)                                        <L 106>
    var_57 = (var_46 > var_sure);
    var_60 = wp::where(var_57, var_58, var_59);
    var_61 = wp::bit_or(var_56, var_60);
    return var_61;
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


// /work/main/warpsample/tracing/sight/sides.py:124
static wp::int32 rays_passing_0(
    wp::uint64 var_sides,
    wp::int32 var_t,
    wp::uint64 var_column)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 192;
    wp::tuple_t<wp::int32> var_1;
    wp::array_t<wp::float32> var_2;
    const wp::int32 var_3 = 192;
    const wp::int32 var_4 = 1664;
    wp::tuple_t<wp::int32> var_5;
    wp::array_t<wp::float32> var_6;
    const wp::int32 var_7 = 1664;
    wp::float32* var_8;
    const wp::int32 var_9 = 16;
    wp::int32 var_10;
    wp::float32* var_11;
    const wp::int32 var_12 = 2;
    wp::int32 var_13;
    wp::int32 var_14;
    wp::float32* var_15;
    wp::vec_t<3, wp::float32> var_16;
    wp::float32 var_17;
    wp::float32 var_18;
    wp::float32 var_19;
    const wp::int32 var_20 = 3;
    wp::int32 var_21;
    wp::int32 var_22;
    wp::float32* var_23;
    const wp::int32 var_24 = 4;
    wp::int32 var_25;
    wp::int32 var_26;
    wp::float32* var_27;
    const wp::int32 var_28 = 5;
    wp::int32 var_29;
    wp::int32 var_30;
    wp::float32* var_31;
    wp::vec_t<3, wp::float32> var_32;
    wp::float32 var_33;
    wp::float32 var_34;
    wp::float32 var_35;
    const wp::int32 var_36 = 6;
    wp::int32 var_37;
    wp::int32 var_38;
    wp::float32* var_39;
    const wp::int32 var_40 = 7;
    wp::int32 var_41;
    wp::int32 var_42;
    wp::float32* var_43;
    const wp::int32 var_44 = 8;
    wp::int32 var_45;
    wp::int32 var_46;
    wp::float32* var_47;
    wp::vec_t<3, wp::float32> var_48;
    wp::float32 var_49;
    wp::float32 var_50;
    wp::float32 var_51;
    const wp::int32 var_52 = 144;
    wp::int32 var_53;
    wp::float32* var_54;
    wp::float32 var_55;
    wp::float32 var_56;
    const wp::int32 var_57 = 160;
    wp::int32 var_58;
    wp::float32* var_59;
    wp::float32 var_60;
    wp::float32 var_61;
    const wp::int32 var_62 = 176;
    wp::int32 var_63;
    wp::float32* var_64;
    wp::float32 var_65;
    wp::float32 var_66;
    wp::tuple_t<wp::int32> var_67;
    wp::fixedarray_t<16, wp::int32> var_68;
    const wp::int32 var_69 = 16;
    const wp::int32 var_70 = 0;
    wp::int32 var_71;
    bool var_72;
    const wp::int32 var_73 = 192;
    wp::int32 var_74;
    wp::float32* var_75;
    const wp::int32 var_76 = 64;
    wp::int32 var_77;
    wp::int32 var_78;
    wp::float32* var_79;
    const wp::int32 var_80 = 2;
    wp::int32 var_81;
    wp::int32 var_82;
    wp::int32 var_83;
    wp::float32* var_84;
    wp::vec_t<3, wp::float32> var_85;
    wp::float32 var_86;
    wp::float32 var_87;
    wp::float32 var_88;
    wp::int32 var_89;
    const wp::int32 var_90 = 1;
    wp::int32 var_91;
    wp::uint64* var_92;
    const wp::int32 var_93 = 31;
    wp::int32 var_94;
    wp::uint64 var_95;
    wp::uint64* var_96;
    const wp::int32 var_97 = 30;
    wp::int32 var_98;
    wp::uint64 var_99;
    wp::int32 var_100;
    wp::int32 var_101;
    //---------
    // forward
    // def rays_passing(sides: wp.uint64, t: wp.int32, column: wp.uint64) -> wp.int32:        <L 125>
    // rows = wp.array(ptr=sides, shape=(SIDES_FLOATS,), dtype=wp.float32)                    <L 130>
    var_1 = wp::tuple(var_0);
    var_2 = wp::array_t<wp::float32>(var_sides, var_3);
    // rays = wp.array(ptr=column, shape=(CHUNK_FLOATS,), dtype=wp.float32)                   <L 131>
    var_5 = wp::tuple(var_4);
    var_6 = wp::array_t<wp::float32>(var_column, var_7);
    // p = wp.vec3(rows[t], rows[WIDTH + t], rows[2 * WIDTH + t])                             <L 132>
    var_8 = wp::address(var_2, var_t);
    var_10 = wp::add(var_9, var_t);
    var_11 = wp::address(var_2, var_10);
    var_13 = wp::mul(var_12, var_9);
    var_14 = wp::add(var_13, var_t);
    var_15 = wp::address(var_2, var_14);
    var_17 = wp::load(var_8);
    var_18 = wp::load(var_11);
    var_19 = wp::load(var_15);
    var_16 = wp::vec_t<3, wp::float32>(var_17, var_18, var_19);
    // q = wp.vec3(rows[3 * WIDTH + t], rows[4 * WIDTH + t], rows[5 * WIDTH + t])             <L 133>
    var_21 = wp::mul(var_20, var_9);
    var_22 = wp::add(var_21, var_t);
    var_23 = wp::address(var_2, var_22);
    var_25 = wp::mul(var_24, var_9);
    var_26 = wp::add(var_25, var_t);
    var_27 = wp::address(var_2, var_26);
    var_29 = wp::mul(var_28, var_9);
    var_30 = wp::add(var_29, var_t);
    var_31 = wp::address(var_2, var_30);
    var_33 = wp::load(var_23);
    var_34 = wp::load(var_27);
    var_35 = wp::load(var_31);
    var_32 = wp::vec_t<3, wp::float32>(var_33, var_34, var_35);
    // r = wp.vec3(rows[6 * WIDTH + t], rows[7 * WIDTH + t], rows[8 * WIDTH + t])             <L 134>
    var_37 = wp::mul(var_36, var_9);
    var_38 = wp::add(var_37, var_t);
    var_39 = wp::address(var_2, var_38);
    var_41 = wp::mul(var_40, var_9);
    var_42 = wp::add(var_41, var_t);
    var_43 = wp::address(var_2, var_42);
    var_45 = wp::mul(var_44, var_9);
    var_46 = wp::add(var_45, var_t);
    var_47 = wp::address(var_2, var_46);
    var_49 = wp::load(var_39);
    var_50 = wp::load(var_43);
    var_51 = wp::load(var_47);
    var_48 = wp::vec_t<3, wp::float32>(var_49, var_50, var_51);
    // sure = rows[_SURE + t]                                                                 <L 135>
    var_53 = wp::add(var_52, var_t);
    var_54 = wp::address(var_2, var_53);
    var_56 = wp::load(var_54);
    var_55 = wp::copy(var_56);
    // outside = rows[_OUTSIDE + t]                                                           <L 136>
    var_58 = wp::add(var_57, var_t);
    var_59 = wp::address(var_2, var_58);
    var_61 = wp::load(var_59);
    var_60 = wp::copy(var_61);
    // behind = rows[_BEHIND + t]                                                             <L 137>
    var_63 = wp::add(var_62, var_t);
    var_64 = wp::address(var_2, var_63);
    var_66 = wp::load(var_64);
    var_65 = wp::copy(var_66);
    // met = wp.zeros(shape=(WIDTH,), dtype=wp.int32)                                         <L 138>
    var_67 = wp::tuple(var_9);
    var_68 = wp::fixedarray_t<16, wp::int32>(var_69);
    // k = wp.int32(0)                                                                        <L 139>
    var_71 = wp::int32(var_70);
    // while k < WIDTH:                                                                       <L 140>
    start_while_0:;
    var_72 = (var_71 < var_9);
    if ((var_72) == false) goto end_while_0;
        // d = wp.vec3(rays[DIRECTION + k], rays[DIRECTION + CHUNK + k], rays[DIRECTION + 2 * CHUNK + k])       <L 141>
        var_74 = wp::add(var_73, var_71);
        var_75 = wp::address(var_6, var_74);
        var_77 = wp::add(var_73, var_76);
        var_78 = wp::add(var_77, var_71);
        var_79 = wp::address(var_6, var_78);
        var_81 = wp::mul(var_80, var_76);
        var_82 = wp::add(var_73, var_81);
        var_83 = wp::add(var_82, var_71);
        var_84 = wp::address(var_6, var_83);
        var_86 = wp::load(var_75);
        var_87 = wp::load(var_79);
        var_88 = wp::load(var_84);
        var_85 = wp::vec_t<3, wp::float32>(var_86, var_87, var_88);
        // met[k] = _classify_ray(d, p, q, r, sure, outside, behind)                          <L 142>
        var_89 = _classify_ray_0(var_85, var_16, var_32, var_48, var_55, var_60, var_65);
        wp::array_store(var_68, var_71, var_89);
        // k += 1                                                                             <L 143>
        var_91 = wp::add(var_71, var_90);
        wp::assign(var_71, var_91);
    goto start_while_0;
    end_while_0:;
    // return lanes_with(met.ptr, 31) | (lanes_with(met.ptr, 30) << WIDTH)                    <L 144>
    var_92 = (wp::uint64*)&(var_68.data);
    var_95 = wp::load(var_92);
    var_94 = lanes_with_0(var_95, var_93);
    var_96 = (wp::uint64*)&(var_68.data);
    var_99 = wp::load(var_96);
    var_98 = lanes_with_0(var_99, var_97);
    var_100 = wp::lshift(var_98, var_9);
    var_101 = wp::bit_or(var_94, var_100);
    return var_101;
}


// /work/main/warpsample/tracing/sight/packets.py:50
static wp::int32 lowest_ray_0(
    wp::uint64 var_rays)
{
    //---------
    // primal vars
    wp::uint64 var_0;
    const wp::uint64 var_1 = 1ull;
    wp::uint64 var_2;
    wp::uint64 var_3;
    wp::uint64 var_4;
    wp::int32 var_5;
    wp::int32 var_6;
    //---------
    // forward
    // def lowest_ray(rays: wp.uint64) -> wp.int32:                                           <L 51>
    // return wp.int32(wp.bit_count((rays & (~rays + _ONE)) - _ONE))                          <L 53>
    var_0 = wp::invert(var_rays);
    var_2 = wp::add(var_0, var_1);
    var_3 = wp::bit_and(var_rays, var_2);
    var_4 = wp::sub(var_3, var_1);
    var_5 = wp::bit_count(var_4);
    var_6 = wp::int32(var_5);
    return var_6;
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


// /work/main/warpsample/tracing/sight/packets.py:56
static bool _is_hit_0(
    wp::uint64 var_leaf,
    wp::int32 var_triangles,
    wp::uint64 var_column,
    wp::float32 var_reach)
{
    //---------
    // primal vars
    const bool var_0 = false;
    bool var_1;
    Ray_728362d1 var_2;
    bool var_3;
    const wp::int32 var_4 = 0;
    bool var_5;
    bool var_6;
    wp::int32 var_7;
    const wp::int32 var_8 = 1;
    wp::int32 var_9;
    wp::int32 var_10;
    wp::float32 var_11;
    bool var_12;
    const wp::float32 var_13 = 0.0;
    bool var_14;
    bool var_15;
    bool var_16;
    //---------
    // forward
    // def _is_hit(leaf: wp.uint64, triangles: wp.int32, column: wp.uint64, reach: wp.float32) -> wp.bool:       <L 57>
    // met = wp.bool(False)                                                                   <L 59>
    var_1 = bool(var_0);
    // ray = ray_in(column)                                                                   <L 60>
    var_2 = ray_in_0(var_column);
    // while triangles != 0 and not met:                                                      <L 61>
    start_while_0:;
    var_5 = (var_triangles != var_4);
    var_3 = var_5;
    if (var_3) {
        var_6 = wp::unot(var_1);
        var_3 = var_3 && var_6;
    }
    if ((var_3) == false) goto end_while_0;
        // k = lowest_bit(triangles)                                                          <L 62>
        var_7 = lowest_bit_0(var_triangles);
        // triangles = triangles & (triangles - 1)                                            <L 63>
        var_9 = wp::sub(var_triangles, var_8);
        var_10 = wp::bit_and(var_triangles, var_9);
        // distance = plane_distance(leaf, k, ray)                                            <L 64>
        var_11 = plane_distance_0(var_leaf, var_7, var_2);
        // met = distance > 0.0 and distance < reach and is_between_edges(leaf, k, ray)       <L 65>
        var_14 = (var_11 > var_13);
        var_12 = var_14;
        if (var_12) {
            var_15 = (var_11 < var_reach);
            var_12 = var_12 && var_15;
        }
        if (var_12) {
            var_16 = _build_edge_test__locals__between_0(var_leaf, var_7, var_2);
            var_12 = var_12 && var_16;
        }
        wp::assign(var_triangles, var_10);
        wp::assign(var_1, var_12);
    goto start_while_0;
    end_while_0:;
    // return met                                                                             <L 66>
    return var_1;
}


// /work/main/warpsample/tracing/sight/packets.py:44
static wp::uint64 ray_set_0(
    wp::int32 var_k)
{
    //---------
    // primal vars
    const wp::uint64 var_0 = 1ull;
    wp::uint64 var_1;
    wp::uint64 var_2;
    //---------
    // forward
    // def ray_set(k: wp.int32) -> wp.uint64:                                                 <L 45>
    // return _ONE << wp.uint64(k)                                                            <L 47>
    var_1 = wp::uint64(var_k);
    var_2 = wp::lshift(var_0, var_1);
    return var_2;
}


// /work/main/warpsample/tracing/sight/packets.py:69
static wp::uint64 _unblocked_by_triangles_0(
    wp::uint64 var_leaf,
    wp::int32 var_triangles,
    ShadingPoint_241c3e67 var_point,
    wp::uint64 var_alive,
    wp::int32 var_blocks)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float32>* var_0;
    wp::float32* var_1;
    wp::uint64* var_2;
    wp::vec_t<3, wp::float32> var_3;
    wp::float32 var_4;
    wp::uint64 var_5;
    const wp::int32 var_6 = 0;
    bool var_7;
    wp::int32 var_8;
    const wp::int32 var_9 = 1;
    wp::int32 var_10;
    wp::int32 var_11;
    wp::range_t var_12;
    wp::int32 var_13;
    wp::uint64* var_14;
    wp::uint64* var_15;
    wp::uint64 var_16;
    const wp::uint64 var_17 = 64ull;
    wp::uint64 var_18;
    wp::uint64 var_19;
    wp::uint64 var_20;
    wp::int32 var_21;
    wp::uint64 var_22;
    const wp::int32 var_23 = 0;
    bool var_24;
    const wp::int32 var_25 = 16;
    wp::int32 var_26;
    wp::uint64 var_27;
    wp::int32 var_28;
    const wp::int32 var_29 = 65535;
    wp::int32 var_30;
    wp::uint64 var_31;
    wp::uint64 var_32;
    wp::uint64 var_33;
    wp::uint64 var_34;
    wp::int32 var_35;
    wp::uint64 var_36;
    wp::uint64 var_37;
    wp::uint64 var_38;
    const wp::uint64 var_39 = 0ull;
    bool var_40;
    wp::int32 var_41;
    const wp::uint64 var_42 = 1ull;
    wp::uint64 var_43;
    wp::uint64 var_44;
    const wp::int32 var_45 = 1;
    wp::int32 var_46;
    wp::uint64* var_47;
    wp::uint64 var_48;
    wp::uint64 var_49;
    wp::float32* var_50;
    bool var_51;
    wp::float32 var_52;
    wp::uint64 var_53;
    wp::uint64 var_54;
    wp::uint64 var_55;
    wp::uint64 var_56;
    wp::uint64 var_57;
    //---------
    // forward
    // def _unblocked_by_triangles(                                                           <L 70>
    // open_leaf(leaf, point.o, point.reach, point.sides)                                     <L 74>
    var_0 = &((var_point).o);
    var_1 = &((var_point).reach);
    var_2 = &((var_point).sides);
    var_3 = wp::load(var_0);
    var_4 = wp::load(var_1);
    var_5 = wp::load(var_2);
    open_leaf_0(var_leaf, var_3, var_4, var_5);
    // while triangles != 0:                                                                  <L 75>
    start_while_0:;
    var_7 = (var_triangles != var_6);
    if ((var_7) == false) goto end_while_0;
        // t = lowest_bit(triangles)                                                          <L 76>
        var_8 = lowest_bit_0(var_triangles);
        // triangles = triangles & (triangles - 1)                                            <L 77>
        var_10 = wp::sub(var_triangles, var_9);
        var_11 = wp::bit_and(var_triangles, var_10);
        // for block in range(blocks):                                                        <L 78>
        var_12 = wp::range(var_blocks);
        start_for_2:;
            if (iter_cmp(var_12) == 0) goto end_for_2;
            var_13 = wp::iter_next(var_12);
            // passing = rays_passing(point.sides, t, point.chunk + wp.uint64(block) * _ROW)       <L 79>
            var_14 = &((var_point).sides);
            var_15 = &((var_point).chunk);
            var_16 = wp::uint64(var_13);
            var_18 = wp::mul(var_16, var_17);
            var_20 = wp::load(var_15);
            var_19 = wp::add(var_20, var_18);
            var_22 = wp::load(var_14);
            var_21 = rays_passing_0(var_22, var_8, var_19);
            // if passing != 0:                                                               <L 80>
            var_24 = (var_21 != var_23);
            if (var_24) {
                // shift = wp.uint64(WIDTH * block)                                           <L 81>
                var_26 = wp::mul(var_25, var_13);
                var_27 = wp::uint64(var_26);
                // alive = alive & (~(wp.uint64((passing >> WIDTH) & _ALL) << shift))         <L 82>
                var_28 = wp::rshift(var_21, var_25);
                var_30 = wp::bit_and(var_28, var_29);
                var_31 = wp::uint64(var_30);
                var_32 = wp::lshift(var_31, var_27);
                var_33 = wp::invert(var_32);
                var_34 = wp::bit_and(var_alive, var_33);
                // maybe = alive & (wp.uint64(passing & _ALL) << shift)                       <L 83>
                var_35 = wp::bit_and(var_21, var_29);
                var_36 = wp::uint64(var_35);
                var_37 = wp::lshift(var_36, var_27);
                var_38 = wp::bit_and(var_34, var_37);
                // while maybe != NO_RAYS:                                                    <L 84>
    start_while_4:;
                var_40 = (var_38 != var_39);
    if ((var_40) == false) goto end_while_4;
                    // k = lowest_ray(maybe)                                                  <L 85>
                    var_41 = lowest_ray_0(var_38);
                    // maybe = maybe & (maybe - _ONE)                                         <L 86>
                    var_43 = wp::sub(var_38, var_42);
                    var_44 = wp::bit_and(var_38, var_43);
                    // if _is_hit(leaf, 1 << t, column_of(point.chunk, k), point.reach):       <L 87>
                    var_46 = wp::lshift(var_45, var_8);
                    var_47 = &((var_point).chunk);
                    var_49 = wp::load(var_47);
                    var_48 = column_of_0(var_49, var_41);
                    var_50 = &((var_point).reach);
                    var_52 = wp::load(var_50);
                    var_51 = _is_hit_0(var_leaf, var_46, var_48, var_52);
                    if (var_51) {
                        // alive = alive & (~ray_set(k))                                      <L 88>
                        var_53 = ray_set_0(var_41);
                        var_54 = wp::invert(var_53);
                        var_55 = wp::bit_and(var_34, var_54);
                    }
                    var_56 = wp::where(var_51, var_55, var_34);
                    wp::assign(var_34, var_56);
                    wp::assign(var_38, var_44);
    goto start_while_4;
    end_while_4:;
            }
            var_57 = wp::where(var_24, var_34, var_alive);
            wp::assign(var_alive, var_57);
            goto start_for_2;
        end_for_2:;
        wp::assign(var_triangles, var_11);
    goto start_while_0;
    end_while_0:;
    // return alive                                                                           <L 89>
    return var_alive;
}


// /work/main/warpsample/tracing/sight/packets.py:154
static wp::uint64 _push_0(
    wp::uint64 var_top,
    wp::uint64 var_node,
    wp::uint64 var_rays)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    const wp::int32 var_1 = 1;
    const wp::uint64 var_2 = 16ull;
    wp::uint64 var_3;
    //---------
    // forward
    // def _push(top: wp.uint64, node: wp.uint64, rays: wp.uint64) -> wp.uint64:              <L 155>
    // set_address(top, 0, node)                                                              <L 157>
    _writer__locals__write_2(var_top, var_0, var_node);
    // set_address(top, 1, rays)                                                              <L 158>
    _writer__locals__write_2(var_top, var_1, var_rays);
    // return top + _ENTRY                                                                    <L 159>
    var_3 = wp::add(var_top, var_2);
    return var_3;
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


// /work/main/warpsample/tracing/sight/packets.py:115
static wp::int32 _children_hit_0(
    wp::uint64 var_node,
    ShadingPoint_241c3e67 var_point,
    wp::uint64 var_rays)
{
    //---------
    // primal vars
    wp::float32* var_0;
    wp::float32 var_1;
    wp::float32 var_2;
    const wp::int32 var_3 = 16;
    wp::tuple_t<wp::int32> var_4;
    wp::fixedarray_t<16, wp::int32> var_5;
    const wp::int32 var_6 = 16;
    wp::tuple_t<wp::int32> var_7;
    wp::fixedarray_t<16, wp::int32> var_8;
    const wp::int32 var_9 = 16;
    const wp::uint64 var_10 = 0ull;
    bool var_11;
    wp::uint64 var_12;
    const wp::uint64 var_13 = 1ull;
    wp::uint64 var_14;
    wp::uint64 var_15;
    wp::uint64 var_16;
    wp::uint64 var_17;
    wp::uint64* var_18;
    wp::int32 var_19;
    wp::uint64 var_20;
    wp::uint64 var_21;
    Ray_728362d1 var_22;
    wp::uint32 var_23;
    wp::int32 var_24;
    wp::uint32 var_25;
    wp::int32 var_26;
    const wp::int32 var_27 = 0;
    wp::int32 var_28;
    bool var_29;
    wp::float32 var_30;
    wp::float32 var_31;
    bool var_32;
    const wp::int32 var_33 = -1;
    const wp::int32 var_34 = 0;
    wp::int32 var_35;
    wp::int32* var_36;
    wp::int32 var_37;
    wp::int32 var_38;
    wp::int32 var_39;
    wp::int32* var_40;
    wp::int32 var_41;
    wp::int32 var_42;
    wp::int32 var_43;
    const wp::int32 var_44 = 1;
    wp::int32 var_45;
    wp::uint64* var_46;
    const wp::int32 var_47 = 2;
    wp::int32 var_48;
    wp::tuple_t<wp::int32> var_49;
    wp::array_t<wp::int32> var_50;
    wp::uint64 var_51;
    wp::tuple_t<wp::int32> var_52;
    wp::fixedarray_t<16, wp::int32> var_53;
    const wp::int32 var_54 = 16;
    const wp::int32 var_55 = 0;
    wp::int32 var_56;
    bool var_57;
    wp::int32* var_58;
    wp::int32 var_59;
    wp::int32 var_60;
    wp::int32* var_61;
    wp::int32 var_62;
    wp::int32 var_63;
    wp::int32 var_64;
    wp::int32* var_65;
    wp::int32* var_66;
    wp::int32 var_67;
    wp::int32 var_68;
    wp::int32 var_69;
    const wp::int32 var_70 = 0;
    bool var_71;
    const wp::int32 var_72 = -1;
    const wp::int32 var_73 = 0;
    wp::int32 var_74;
    const wp::int32 var_75 = 1;
    wp::int32 var_76;
    wp::uint64* var_77;
    const wp::int32 var_78 = 31;
    wp::int32 var_79;
    wp::uint64 var_80;
    //---------
    // forward
    // def _children_hit(node: wp.uint64, point: ShadingPoint, rays: wp.uint64) -> wp.int32:       <L 116>
    // reach = point.reach                                                                    <L 121>
    var_0 = &((var_point).reach);
    var_2 = wp::load(var_0);
    var_1 = wp::copy(var_2);
    // low = wp.zeros(shape=(WIDTH,), dtype=wp.int32)                                         <L 122>
    var_4 = wp::tuple(var_3);
    var_5 = wp::fixedarray_t<16, wp::int32>(var_6);
    // high = wp.zeros(shape=(WIDTH,), dtype=wp.int32)                                        <L 123>
    var_7 = wp::tuple(var_3);
    var_8 = wp::fixedarray_t<16, wp::int32>(var_9);
    // while rays != NO_RAYS:                                                                 <L 124>
    start_while_0:;
    var_11 = (var_rays != var_10);
    if ((var_11) == false) goto end_while_0;
        // bit = rays & (~rays + _ONE)                                                        <L 125>
        var_12 = wp::invert(var_rays);
        var_14 = wp::add(var_12, var_13);
        var_15 = wp::bit_and(var_rays, var_14);
        // rays = rays & (rays - _ONE)                                                        <L 126>
        var_16 = wp::sub(var_rays, var_13);
        var_17 = wp::bit_and(var_rays, var_16);
        // ray = ray_in(column_of(point.chunk, lowest_ray(bit)))                              <L 127>
        var_18 = &((var_point).chunk);
        var_19 = lowest_ray_0(var_15);
        var_21 = wp::load(var_18);
        var_20 = column_of_0(var_21, var_19);
        var_22 = ray_in_0(var_20);
        // low_bit = wp.int32(low_word(bit))                                                  <L 128>
        var_23 = low_word_0(var_15);
        var_24 = wp::int32(var_23);
        // high_bit = wp.int32(high_word(bit))                                                <L 129>
        var_25 = high_word_0(var_15);
        var_26 = wp::int32(var_25);
        // k = wp.int32(0)                                                                    <L 130>
        var_28 = wp::int32(var_27);
        // while k < WIDTH:                                                                   <L 131>
    start_while_2:;
        var_29 = (var_28 < var_3);
    if ((var_29) == false) goto end_while_2;
            // meets = wp.where(entry_distance(node, ray, k) <= exit_distance(node, ray, reach, k), -1, 0)       <L 132>
            var_30 = entry_distance_0(var_node, var_22, var_28);
            var_31 = exit_distance_0(var_node, var_22, var_1, var_28);
            var_32 = (var_30 <= var_31);
            var_35 = wp::where(var_32, var_33, var_34);
            // low[k] = low[k] | (meets & low_bit)                                            <L 133>
            var_36 = wp::address(var_5, var_28);
            var_37 = wp::bit_and(var_35, var_24);
            var_39 = wp::load(var_36);
            var_38 = wp::bit_or(var_39, var_37);
            wp::array_store(var_5, var_28, var_38);
            // high[k] = high[k] | (meets & high_bit)                                         <L 134>
            var_40 = wp::address(var_8, var_28);
            var_41 = wp::bit_and(var_35, var_26);
            var_43 = wp::load(var_40);
            var_42 = wp::bit_or(var_43, var_41);
            wp::array_store(var_8, var_28, var_42);
            // k += 1                                                                         <L 135>
            var_45 = wp::add(var_28, var_44);
            wp::assign(var_28, var_45);
    goto start_while_2;
    end_while_2:;
        wp::assign(var_rays, var_17);
    goto start_while_0;
    end_while_0:;
    // words = wp.array(ptr=point.scratch, shape=(2 * WIDTH,), dtype=wp.int32)                <L 136>
    var_46 = &((var_point).scratch);
    var_48 = wp::mul(var_47, var_3);
    var_49 = wp::tuple(var_48);
    var_51 = wp::load(var_46);
    var_50 = wp::array_t<wp::int32>(var_51, var_48);
    // some = wp.zeros(shape=(WIDTH,), dtype=wp.int32)                                        <L 137>
    var_52 = wp::tuple(var_3);
    var_53 = wp::fixedarray_t<16, wp::int32>(var_54);
    // i = wp.int32(0)                                                                        <L 138>
    var_56 = wp::int32(var_55);
    // while i < WIDTH:                                                                       <L 139>
    start_while_4:;
    var_57 = (var_56 < var_3);
    if ((var_57) == false) goto end_while_4;
        // words[i] = low[i]                                                                  <L 140>
        var_58 = wp::address(var_5, var_56);
        var_60 = wp::load(var_58);
        var_59 = wp::copy(var_60);
        wp::array_store(var_50, var_56, var_59);
        // words[WIDTH + i] = high[i]                                                         <L 141>
        var_61 = wp::address(var_8, var_56);
        var_63 = wp::load(var_61);
        var_62 = wp::copy(var_63);
        var_64 = wp::add(var_3, var_56);
        wp::array_store(var_50, var_64, var_62);
        // some[i] = wp.where((low[i] | high[i]) != 0, -1, 0)                                 <L 142>
        var_65 = wp::address(var_5, var_56);
        var_66 = wp::address(var_8, var_56);
        var_68 = wp::load(var_65);
        var_69 = wp::load(var_66);
        var_67 = wp::bit_or(var_68, var_69);
        var_71 = (var_67 != var_70);
        var_74 = wp::where(var_71, var_72, var_73);
        wp::array_store(var_53, var_56, var_74);
        // i += 1                                                                             <L 143>
        var_76 = wp::add(var_56, var_75);
        wp::assign(var_56, var_76);
    goto start_while_4;
    end_while_4:;
    // return lanes_with(some.ptr, 31)                                                        <L 144>
    var_77 = (wp::uint64*)&(var_53.data);
    var_80 = wp::load(var_77);
    var_79 = lanes_with_0(var_80, var_78);
    return var_79;
}


// /work/main/warpsample/tracing/sight/packets.py:147
static wp::uint64 _rays_at_child_0(
    ShadingPoint_241c3e67 var_point,
    wp::int32 var_child)
{
    //---------
    // primal vars
    wp::uint64* var_0;
    const wp::int32 var_1 = 2;
    const wp::int32 var_2 = 16;
    wp::int32 var_3;
    wp::tuple_t<wp::int32> var_4;
    wp::array_t<wp::uint32> var_5;
    wp::uint64 var_6;
    wp::int32 var_7;
    wp::uint32* var_8;
    wp::uint64 var_9;
    wp::uint32 var_10;
    wp::uint64 var_11;
    wp::uint64 var_12;
    wp::uint32* var_13;
    wp::uint64 var_14;
    wp::uint32 var_15;
    wp::uint64 var_16;
    //---------
    // forward
    // def _rays_at_child(point: ShadingPoint, child: wp.int32) -> wp.uint64:                 <L 148>
    // words = wp.array(ptr=point.scratch, shape=(2 * WIDTH,), dtype=wp.uint32)               <L 150>
    var_0 = &((var_point).scratch);
    var_3 = wp::mul(var_1, var_2);
    var_4 = wp::tuple(var_3);
    var_6 = wp::load(var_0);
    var_5 = wp::array_t<wp::uint32>(var_6, var_3);
    // return (wp.uint64(words[WIDTH + child]) << wp.uint64(32)) | wp.uint64(words[child])       <L 151>
    var_7 = wp::add(var_2, var_child);
    var_8 = wp::address(var_5, var_7);
    var_10 = wp::load(var_8);
    var_9 = wp::uint64(var_10);
    var_11 = 32ull;
    var_12 = wp::lshift(var_9, var_11);
    var_13 = wp::address(var_5, var_child);
    var_15 = wp::load(var_13);
    var_14 = wp::uint64(var_15);
    var_16 = wp::bit_or(var_12, var_14);
    return var_16;
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


// /work/main/warpsample/tracing/wide/query.py:41
static void any_triangle_0(
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
    const wp::int32 var_1 = 16;
    wp::int32 var_2;
    wp::int32 var_3;
    wp::int32 var_4;
    const wp::int32 var_5 = -1;
    wp::int32 var_6;
    const wp::int32 var_7 = 0;
    bool var_8;
    wp::int32 var_9;
    const wp::int32 var_10 = 65535;
    wp::int32 var_11;
    wp::int32 var_12;
    const wp::int32 var_13 = 0;
    bool var_14;
    wp::int32 var_15;
    const wp::int32 var_16 = 0;
    wp::int32 var_17;
    wp::int32 var_18;
    wp::int32 var_19;
    wp::range_t var_20;
    wp::int32 var_21;
    const wp::int32 var_22 = 0;
    bool var_23;
    wp::int32 var_24;
    wp::float32 var_25;
    bool var_26;
    const wp::float32 var_27 = 0.0;
    bool var_28;
    bool var_29;
    wp::int32 var_30;
    bool var_31;
    wp::int32 var_32;
    wp::int32 var_33;
    wp::int32 var_34;
    const wp::int32 var_35 = 1;
    wp::int32 var_36;
    wp::int32 var_37;
    wp::int32 var_38;
    //---------
    // forward
    // def any_triangle(leaf: wp.uint64, lanes: wp.int32, ray: Ray, reach: wp.float32, edge: wp.float32):       <L 42>
    // found = triangles_near(leaf, ray, reach, edge) & (lanes | (lanes << WIDTH))            <L 44>
    var_0 = triangles_near_0(var_leaf, var_ray, var_reach, var_edge);
    var_2 = wp::lshift(var_lanes, var_1);
    var_3 = wp::bit_or(var_lanes, var_2);
    var_4 = wp::bit_and(var_0, var_3);
    // triangle = wp.int32(-1)                                                                <L 45>
    var_6 = wp::int32(var_5);
    // if found != 0:                                                                         <L 46>
    var_8 = (var_4 != var_7);
    if (var_8) {
        // sure = (found >> WIDTH) & _ALL                                                     <L 47>
        var_9 = wp::rshift(var_4, var_1);
        var_11 = wp::bit_and(var_9, var_10);
        // met = found & _ALL                                                                 <L 48>
        var_12 = wp::bit_and(var_4, var_10);
        // if sure != 0:                                                                      <L 49>
        var_14 = (var_11 != var_13);
        if (var_14) {
            // triangle = lowest_bit(sure)                                                    <L 50>
            var_15 = lowest_bit_0(var_11);
            // met = 0                                                                        <L 51>
        }
        var_17 = wp::where(var_14, var_15, var_6);
        var_18 = wp::where(var_14, var_16, var_12);
        // for _ in range(wp.bit_count(met)):                                                 <L 52>
        var_19 = wp::bit_count(var_18);
        var_20 = wp::range(var_19);
        start_for_0:;
            if (iter_cmp(var_20) == 0) goto end_for_0;
            var_21 = wp::iter_next(var_20);
            // if triangle < 0:                                                               <L 53>
            var_23 = (var_17 < var_22);
            if (var_23) {
                // distance = plane_distance(leaf, lowest_bit(met), ray)                      <L 54>
                var_24 = lowest_bit_0(var_18);
                var_25 = plane_distance_0(var_leaf, var_24, var_ray);
                // if distance > 0.0 and distance < reach and is_between_edges(leaf, lowest_bit(met), ray):       <L 55>
                var_28 = (var_25 > var_27);
                var_26 = var_28;
                if (var_26) {
                    var_29 = (var_25 < var_reach);
                    var_26 = var_26 && var_29;
                }
                if (var_26) {
                    var_30 = lowest_bit_0(var_18);
                    var_31 = _build_edge_test__locals__between_0(var_leaf, var_30, var_ray);
                    var_26 = var_26 && var_31;
                }
                if (var_26) {
                    // triangle = lowest_bit(met)                                             <L 56>
                    var_32 = lowest_bit_0(var_18);
                }
                var_33 = wp::where(var_26, var_32, var_17);
            }
            var_34 = wp::where(var_23, var_33, var_17);
            // met = met & (met - 1)                                                          <L 57>
            var_36 = wp::sub(var_18, var_35);
            var_37 = wp::bit_and(var_18, var_36);
            wp::assign(var_17, var_34);
            wp::assign(var_18, var_37);
            goto start_for_0;
        end_for_0:;
    }
    var_38 = wp::where(var_8, var_17, var_6);
    // return reach, triangle                                                                 <L 58>
    ret_0 = var_reach;
    ret_1 = var_38;
    return;
}


// /work/main/warpsample/tracing/sight/sides.py:109
static wp::int32 triangles_passed_0(
    wp::uint64 var_sides,
    wp::vec_t<3, wp::float32> var_d)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 192;
    wp::tuple_t<wp::int32> var_1;
    wp::array_t<wp::float32> var_2;
    const wp::int32 var_3 = 192;
    const wp::int32 var_4 = 16;
    wp::tuple_t<wp::int32> var_5;
    wp::fixedarray_t<16, wp::int32> var_6;
    const wp::int32 var_7 = 16;
    const wp::int32 var_8 = 0;
    wp::int32 var_9;
    bool var_10;
    wp::float32* var_11;
    wp::int32 var_12;
    wp::float32* var_13;
    const wp::int32 var_14 = 2;
    wp::int32 var_15;
    wp::int32 var_16;
    wp::float32* var_17;
    wp::vec_t<3, wp::float32> var_18;
    wp::float32 var_19;
    wp::float32 var_20;
    wp::float32 var_21;
    const wp::int32 var_22 = 3;
    wp::int32 var_23;
    wp::int32 var_24;
    wp::float32* var_25;
    const wp::int32 var_26 = 4;
    wp::int32 var_27;
    wp::int32 var_28;
    wp::float32* var_29;
    const wp::int32 var_30 = 5;
    wp::int32 var_31;
    wp::int32 var_32;
    wp::float32* var_33;
    wp::vec_t<3, wp::float32> var_34;
    wp::float32 var_35;
    wp::float32 var_36;
    wp::float32 var_37;
    const wp::int32 var_38 = 6;
    wp::int32 var_39;
    wp::int32 var_40;
    wp::float32* var_41;
    const wp::int32 var_42 = 7;
    wp::int32 var_43;
    wp::int32 var_44;
    wp::float32* var_45;
    const wp::int32 var_46 = 8;
    wp::int32 var_47;
    wp::int32 var_48;
    wp::float32* var_49;
    wp::vec_t<3, wp::float32> var_50;
    wp::float32 var_51;
    wp::float32 var_52;
    wp::float32 var_53;
    const wp::int32 var_54 = 144;
    wp::int32 var_55;
    wp::float32* var_56;
    const wp::int32 var_57 = 160;
    wp::int32 var_58;
    wp::float32* var_59;
    const wp::int32 var_60 = 176;
    wp::int32 var_61;
    wp::float32* var_62;
    wp::int32 var_63;
    wp::float32 var_64;
    wp::float32 var_65;
    wp::float32 var_66;
    const wp::int32 var_67 = 1;
    wp::int32 var_68;
    wp::uint64* var_69;
    const wp::int32 var_70 = 31;
    wp::int32 var_71;
    wp::uint64 var_72;
    wp::uint64* var_73;
    const wp::int32 var_74 = 30;
    wp::int32 var_75;
    wp::uint64 var_76;
    wp::int32 var_77;
    wp::int32 var_78;
    //---------
    // forward
    // def triangles_passed(sides: wp.uint64, d: wp.vec3) -> wp.int32:                        <L 110>
    // rows = wp.array(ptr=sides, shape=(SIDES_FLOATS,), dtype=wp.float32)                    <L 112>
    var_1 = wp::tuple(var_0);
    var_2 = wp::array_t<wp::float32>(var_sides, var_3);
    // met = wp.zeros(shape=(WIDTH,), dtype=wp.int32)                                         <L 113>
    var_5 = wp::tuple(var_4);
    var_6 = wp::fixedarray_t<16, wp::int32>(var_7);
    // k = wp.int32(0)                                                                        <L 114>
    var_9 = wp::int32(var_8);
    // while k < WIDTH:                                                                       <L 115>
    start_while_0:;
    var_10 = (var_9 < var_4);
    if ((var_10) == false) goto end_while_0;
        // p = wp.vec3(rows[k], rows[WIDTH + k], rows[2 * WIDTH + k])                         <L 116>
        var_11 = wp::address(var_2, var_9);
        var_12 = wp::add(var_4, var_9);
        var_13 = wp::address(var_2, var_12);
        var_15 = wp::mul(var_14, var_4);
        var_16 = wp::add(var_15, var_9);
        var_17 = wp::address(var_2, var_16);
        var_19 = wp::load(var_11);
        var_20 = wp::load(var_13);
        var_21 = wp::load(var_17);
        var_18 = wp::vec_t<3, wp::float32>(var_19, var_20, var_21);
        // q = wp.vec3(rows[3 * WIDTH + k], rows[4 * WIDTH + k], rows[5 * WIDTH + k])         <L 117>
        var_23 = wp::mul(var_22, var_4);
        var_24 = wp::add(var_23, var_9);
        var_25 = wp::address(var_2, var_24);
        var_27 = wp::mul(var_26, var_4);
        var_28 = wp::add(var_27, var_9);
        var_29 = wp::address(var_2, var_28);
        var_31 = wp::mul(var_30, var_4);
        var_32 = wp::add(var_31, var_9);
        var_33 = wp::address(var_2, var_32);
        var_35 = wp::load(var_25);
        var_36 = wp::load(var_29);
        var_37 = wp::load(var_33);
        var_34 = wp::vec_t<3, wp::float32>(var_35, var_36, var_37);
        // r = wp.vec3(rows[6 * WIDTH + k], rows[7 * WIDTH + k], rows[8 * WIDTH + k])         <L 118>
        var_39 = wp::mul(var_38, var_4);
        var_40 = wp::add(var_39, var_9);
        var_41 = wp::address(var_2, var_40);
        var_43 = wp::mul(var_42, var_4);
        var_44 = wp::add(var_43, var_9);
        var_45 = wp::address(var_2, var_44);
        var_47 = wp::mul(var_46, var_4);
        var_48 = wp::add(var_47, var_9);
        var_49 = wp::address(var_2, var_48);
        var_51 = wp::load(var_41);
        var_52 = wp::load(var_45);
        var_53 = wp::load(var_49);
        var_50 = wp::vec_t<3, wp::float32>(var_51, var_52, var_53);
        // met[k] = _classify_ray(d, p, q, r, rows[_SURE + k], rows[_OUTSIDE + k], rows[_BEHIND + k])       <L 119>
        var_55 = wp::add(var_54, var_9);
        var_56 = wp::address(var_2, var_55);
        var_58 = wp::add(var_57, var_9);
        var_59 = wp::address(var_2, var_58);
        var_61 = wp::add(var_60, var_9);
        var_62 = wp::address(var_2, var_61);
        var_64 = wp::load(var_56);
        var_65 = wp::load(var_59);
        var_66 = wp::load(var_62);
        var_63 = _classify_ray_0(var_d, var_18, var_34, var_50, var_64, var_65, var_66);
        wp::array_store(var_6, var_9, var_63);
        // k += 1                                                                             <L 120>
        var_68 = wp::add(var_9, var_67);
        wp::assign(var_9, var_68);
    goto start_while_0;
    end_while_0:;
    // return lanes_with(met.ptr, 31) | (lanes_with(met.ptr, 30) << WIDTH)                    <L 121>
    var_69 = (wp::uint64*)&(var_6.data);
    var_72 = wp::load(var_69);
    var_71 = lanes_with_0(var_72, var_70);
    var_73 = (wp::uint64*)&(var_6.data);
    var_76 = wp::load(var_73);
    var_75 = lanes_with_0(var_76, var_74);
    var_77 = wp::lshift(var_75, var_4);
    var_78 = wp::bit_or(var_71, var_77);
    return var_78;
}


// /work/main/warpsample/tracing/sight/packets.py:92
static wp::uint64 _unblocked_by_leaf_0(
    wp::uint64 var_leaf,
    wp::float32 var_edge,
    ShadingPoint_241c3e67 var_point,
    wp::uint64 var_rays,
    wp::uint64 var_alive)
{
    //---------
    // primal vars
    const wp::uint64 var_0 = 1ull;
    wp::uint64 var_1;
    wp::uint64 var_2;
    const wp::uint64 var_3 = 0ull;
    bool var_4;
    const wp::int32 var_5 = 65535;
    wp::uint64* var_6;
    wp::int32 var_7;
    wp::uint64 var_8;
    wp::uint64 var_9;
    Ray_728362d1 var_10;
    wp::float32* var_11;
    wp::float32 var_12;
    wp::int32 var_13;
    wp::float32 var_14;
    const wp::int32 var_15 = 0;
    bool var_16;
    wp::uint64 var_17;
    wp::uint64 var_18;
    wp::uint64 var_19;
    wp::vec_t<3, wp::float32>* var_20;
    wp::float32* var_21;
    wp::uint64* var_22;
    wp::vec_t<3, wp::float32> var_23;
    wp::float32 var_24;
    wp::uint64 var_25;
    bool var_26;
    wp::int32 var_27;
    wp::uint64 var_28;
    wp::uint64 var_29;
    wp::uint64* var_30;
    wp::uint64* var_31;
    wp::vec_t<3, wp::float32> var_32;
    wp::uint64 var_33;
    wp::int32 var_34;
    wp::uint64 var_35;
    const wp::int32 var_36 = 16;
    wp::int32 var_37;
    wp::int32 var_38;
    const wp::int32 var_39 = 0;
    bool var_40;
    const wp::int32 var_41 = 1;
    const wp::int32 var_42 = 0;
    wp::int32 var_43;
    bool var_44;
    const wp::int32 var_45 = 0;
    bool var_46;
    const wp::int32 var_47 = 0;
    bool var_48;
    wp::int32 var_49;
    wp::uint64* var_50;
    wp::uint64 var_51;
    wp::uint64 var_52;
    wp::float32* var_53;
    bool var_54;
    wp::float32 var_55;
    const wp::int32 var_56 = 1;
    const wp::int32 var_57 = 0;
    wp::int32 var_58;
    wp::int32 var_59;
    wp::uint64 var_60;
    wp::uint64 var_61;
    wp::uint64 var_62;
    wp::uint64 var_63;
    wp::uint64 var_64;
    //---------
    // forward
    // def _unblocked_by_leaf(                                                                <L 93>
    // if (rays & (rays - _ONE)) == NO_RAYS:                                                  <L 100>
    var_1 = wp::sub(var_rays, var_0);
    var_2 = wp::bit_and(var_rays, var_1);
    var_4 = (var_2 == var_3);
    if (var_4) {
        // _reach, triangle = any_triangle(leaf, _ALL, ray_in(column_of(point.chunk, lowest_ray(rays))), point.reach, edge)       <L 101>
        var_6 = &((var_point).chunk);
        var_7 = lowest_ray_0(var_rays);
        var_9 = wp::load(var_6);
        var_8 = column_of_0(var_9, var_7);
        var_10 = ray_in_0(var_8);
        var_11 = &((var_point).reach);
        var_14 = wp::load(var_11);
        any_triangle_0(var_leaf, var_5, var_10, var_14, var_edge, var_12, var_13);
        // return wp.where(triangle >= 0, alive & (~rays), alive)                             <L 102>
        var_16 = (var_13 >= var_15);
        var_17 = wp::invert(var_rays);
        var_18 = wp::bit_and(var_alive, var_17);
        var_19 = wp::where(var_16, var_18, var_alive);
        return var_19;
    }
    // open_leaf(leaf, point.o, point.reach, point.sides)                                     <L 103>
    var_20 = &((var_point).o);
    var_21 = &((var_point).reach);
    var_22 = &((var_point).sides);
    var_23 = wp::load(var_20);
    var_24 = wp::load(var_21);
    var_25 = wp::load(var_22);
    open_leaf_0(var_leaf, var_23, var_24, var_25);
    // while rays != NO_RAYS:                                                                 <L 104>
    start_while_1:;
    var_26 = (var_rays != var_3);
    if ((var_26) == false) goto end_while_1;
        // k = lowest_ray(rays)                                                               <L 105>
        var_27 = lowest_ray_0(var_rays);
        // rays = rays & (rays - _ONE)                                                        <L 106>
        var_28 = wp::sub(var_rays, var_0);
        var_29 = wp::bit_and(var_rays, var_28);
        // passed = triangles_passed(point.sides, direction_of(point.chunk, k))               <L 107>
        var_30 = &((var_point).sides);
        var_31 = &((var_point).chunk);
        var_33 = wp::load(var_31);
        var_32 = direction_of_0(var_33, var_27);
        var_35 = wp::load(var_30);
        var_34 = triangles_passed_0(var_35, var_32);
        // met = wp.where((passed >> WIDTH) & _ALL != 0, 1, 0)                                <L 108>
        var_37 = wp::rshift(var_34, var_36);
        var_38 = wp::bit_and(var_37, var_5);
        var_40 = (var_38 != var_39);
        var_43 = wp::where(var_40, var_41, var_42);
        // if met == 0 and passed != 0:                                                       <L 109>
        var_46 = (var_43 == var_45);
        var_44 = var_46;
        if (var_44) {
            var_48 = (var_34 != var_47);
            var_44 = var_44 && var_48;
        }
        if (var_44) {
            // met = wp.where(_is_hit(leaf, passed & _ALL, column_of(point.chunk, k), point.reach), 1, 0)       <L 110>
            var_49 = wp::bit_and(var_34, var_5);
            var_50 = &((var_point).chunk);
            var_52 = wp::load(var_50);
            var_51 = column_of_0(var_52, var_27);
            var_53 = &((var_point).reach);
            var_55 = wp::load(var_53);
            var_54 = _is_hit_0(var_leaf, var_49, var_51, var_55);
            var_58 = wp::where(var_54, var_56, var_57);
        }
        var_59 = wp::where(var_44, var_58, var_43);
        // alive = alive & (~(wp.uint64(met) << wp.uint64(k)))                                <L 111>
        var_60 = wp::uint64(var_59);
        var_61 = wp::uint64(var_27);
        var_62 = wp::lshift(var_60, var_61);
        var_63 = wp::invert(var_62);
        var_64 = wp::bit_and(var_alive, var_63);
        wp::assign(var_rays, var_29);
        wp::assign(var_alive, var_64);
    goto start_while_1;
    end_while_1:;
    // return alive                                                                           <L 112>
    return var_alive;
}


// /work/main/warpsample/tracing/sight/packets.py:162
static wp::uint64 _unblocked_by_tree_0(
    Accelerator_9fc73cd7 var_tree,
    ShadingPoint_241c3e67 var_point,
    wp::uint64 var_alive)
{
    //---------
    // primal vars
    wp::uint64* var_0;
    wp::uint64 var_1;
    wp::uint64 var_2;
    wp::int32* var_3;
    wp::range_t var_4;
    wp::int32 var_5;
    wp::int32 var_6;
    wp::uint64* var_7;
    wp::uint64 var_8;
    wp::uint64 var_9;
    wp::uint64 var_10;
    wp::uint64 var_11;
    wp::uint64 var_12;
    wp::uint64 var_13;
    wp::uint64* var_14;
    bool var_15;
    wp::uint64 var_16;
    const wp::uint64 var_17 = 16ull;
    wp::uint64 var_18;
    const wp::int32 var_19 = 0;
    wp::uint64 var_20;
    const wp::int32 var_21 = 1;
    wp::uint64 var_22;
    wp::uint64 var_23;
    wp::int32 var_24;
    const wp::int32 var_25 = 0;
    bool var_26;
    wp::int32 var_27;
    const wp::int32 var_28 = 1;
    wp::int32 var_29;
    wp::int32 var_30;
    wp::uint64 var_31;
    wp::uint64 var_32;
    const wp::uint64 var_33 = 0ull;
    bool var_34;
    wp::int32 var_35;
    const wp::int32 var_36 = 0;
    bool var_37;
    wp::int32 var_38;
    wp::uint64 var_39;
    wp::float32 var_40;
    wp::uint64 var_41;
    wp::uint64 var_42;
    wp::uint64 var_43;
    wp::uint64 var_44;
    wp::uint64 var_45;
    wp::uint64 var_46;
    wp::uint64 var_47;
    //---------
    // forward
    // def _unblocked_by_tree(tree: Accelerator, point: ShadingPoint, alive: wp.uint64) -> wp.uint64:       <L 163>
    // top = point.waiting                                                                    <L 165>
    var_0 = &((var_point).waiting);
    var_2 = wp::load(var_0);
    var_1 = wp::copy(var_2);
    // for start in range(tree.starts):                                                       <L 166>
    var_3 = &((var_tree).starts);
    var_5 = wp::load(var_3);
    var_4 = wp::range(var_5);
    start_for_0:;
        if (iter_cmp(var_4) == 0) goto end_for_0;
        var_6 = wp::iter_next(var_4);
        // top = _push(top, tree.start + wp.uint64(start) * wp.uint64(NODE_BYTES), alive)       <L 167>
        var_7 = &((var_tree).start);
        var_8 = wp::uint64(var_6);
        var_9 = 512ull;
        var_10 = wp::mul(var_8, var_9);
        var_12 = wp::load(var_7);
        var_11 = wp::add(var_12, var_10);
        var_13 = _push_0(var_1, var_11, var_alive);
        wp::assign(var_1, var_13);
        goto start_for_0;
    end_for_0:;
    // while top != point.waiting:                                                            <L 168>
    start_while_2:;
    var_14 = &((var_point).waiting);
    var_16 = wp::load(var_14);
    var_15 = (var_1 != var_16);
    if ((var_15) == false) goto end_while_2;
        // top -= _ENTRY                                                                      <L 169>
        var_18 = wp::sub(var_1, var_17);
        // node = address_at(top, 0)                                                          <L 170>
        var_20 = _reader__locals__read_3(var_18, var_19);
        // mask = _children_hit(node, point, address_at(top, 1) & alive)                      <L 171>
        var_22 = _reader__locals__read_3(var_18, var_21);
        var_23 = wp::bit_and(var_22, var_alive);
        var_24 = _children_hit_0(var_20, var_point, var_23);
        // while mask != 0:                                                                   <L 172>
    start_while_4:;
        var_26 = (var_24 != var_25);
    if ((var_26) == false) goto end_while_4;
            // child = lowest_bit(mask)                                                       <L 173>
            var_27 = lowest_bit_0(var_24);
            // mask = mask & (mask - 1)                                                       <L 174>
            var_29 = wp::sub(var_24, var_28);
            var_30 = wp::bit_and(var_24, var_29);
            // rays = alive & _rays_at_child(point, child)                                    <L 175>
            var_31 = _rays_at_child_0(var_point, var_27);
            var_32 = wp::bit_and(var_alive, var_31);
            // if rays != NO_RAYS:                                                            <L 176>
            var_34 = (var_32 != var_33);
            if (var_34) {
                // link = link_in(node, child)                                                <L 177>
                var_35 = link_in_0(var_20, var_27);
                // if link < 0:                                                               <L 178>
                var_37 = (var_35 < var_36);
                if (var_37) {
                    // alive = _unblocked_by_leaf(leaf_at(tree, ~link), edge_in(node, child), point, rays, alive)       <L 179>
                    var_38 = wp::invert(var_35);
                    var_39 = leaf_at_0(var_tree, var_38);
                    var_40 = edge_in_0(var_20, var_27);
                    var_41 = _unblocked_by_leaf_0(var_39, var_40, var_point, var_32, var_alive);
                }
                if (!var_37) {
                    // top = _push(top, node_at(tree, link), rays)                            <L 181>
                    var_42 = node_at_0(var_tree, var_35);
                    var_43 = _push_0(var_18, var_42, var_32);
                }
                var_44 = wp::where(var_37, var_41, var_alive);
                var_45 = wp::where(var_37, var_18, var_43);
            }
            var_46 = wp::where(var_34, var_44, var_alive);
            var_47 = wp::where(var_34, var_45, var_18);
            wp::assign(var_alive, var_46);
            wp::assign(var_18, var_47);
            wp::assign(var_24, var_30);
    goto start_while_4;
    end_while_4:;
        wp::assign(var_1, var_18);
    goto start_while_2;
    end_while_2:;
    // return alive                                                                           <L 182>
    return var_alive;
}


// /work/main/warpsample/tracing/sight/packets.py:185
static wp::uint64 blocked_rays_0(
    Accelerator_9fc73cd7 var_tree,
    ShadingPoint_241c3e67 var_point,
    wp::int32 var_local,
    wp::uint64 var_rays,
    wp::int32 var_length)
{
    //---------
    // primal vars
    wp::uint64 var_0;
    const wp::int32 var_1 = 0;
    bool var_2;
    wp::uint64* var_3;
    const wp::uint64 var_4 = 2048ull;
    wp::uint64 var_5;
    wp::uint64 var_6;
    const wp::int32 var_7 = 16;
    wp::int32 var_8;
    const wp::int32 var_9 = 1;
    wp::int32 var_10;
    wp::int32 var_11;
    wp::uint64 var_12;
    wp::uint64 var_13;
    wp::uint64 var_14;
    wp::vec_t<3, wp::float64>* var_15;
    bool var_16;
    wp::vec_t<3, wp::float64> var_17;
    const wp::uint64 var_18 = 0ull;
    bool var_19;
    wp::uint64 var_20;
    wp::int32 var_21;
    wp::uint64 var_22;
    wp::uint64* var_23;
    wp::int32 var_24;
    wp::uint64 var_25;
    wp::uint64 var_26;
    const wp::int32 var_27 = 384;
    wp::float32 var_28;
    wp::uint64 var_29;
    wp::uint64 var_30;
    wp::uint64 var_31;
    wp::float32* var_32;
    const wp::float32 var_33 = 0.0;
    bool var_34;
    wp::float32 var_35;
    wp::uint64 var_36;
    wp::uint64 var_37;
    wp::uint64 var_38;
    wp::uint64 var_39;
    wp::uint64 var_40;
    wp::uint64 var_41;
    wp::uint64 var_42;
    //---------
    // forward
    // def blocked_rays(tree: Accelerator, point: ShadingPoint, local: wp.int32, rays: wp.uint64, length: wp.int32) -> wp.uint64:       <L 186>
    // alive = rays                                                                           <L 191>
    var_0 = wp::copy(var_rays);
    // if local != 0:                                                                         <L 192>
    var_2 = (var_local != var_1);
    if (var_2) {
        // alive = _unblocked_by_triangles(point.opened + LOCAL_LEAF, local, point, alive, (length + WIDTH - 1) / WIDTH)       <L 193>
        var_3 = &((var_point).opened);
        var_6 = wp::load(var_3);
        var_5 = wp::add(var_6, var_4);
        var_8 = wp::add(var_length, var_7);
        var_10 = wp::sub(var_8, var_9);
        var_11 = wp::div(var_10, var_7);
        var_12 = _unblocked_by_triangles_0(var_5, var_local, var_point, var_0, var_11);
    }
    var_13 = wp::where(var_2, var_12, var_0);
    // left = alive                                                                           <L 194>
    var_14 = wp::copy(var_13);
    // apart = is_far_off(point.position)                                                     <L 195>
    var_15 = &((var_point).position);
    var_17 = wp::load(var_15);
    var_16 = is_far_off_0(var_17);
    // while alive != NO_RAYS:                                                                <L 196>
    start_while_0:;
    var_19 = (var_13 != var_18);
    if ((var_19) == false) goto end_while_0;
        // these = alive                                                                      <L 197>
        var_20 = wp::copy(var_13);
        // if apart:                                                                          <L 198>
        if (var_16) {
            // these = ray_set(lowest_ray(alive))                                             <L 199>
            var_21 = lowest_ray_0(var_13);
            var_22 = ray_set_0(var_21);
            // point.reach = float_at(column_of(point.chunk, lowest_ray(alive)), REACH)       <L 200>
            var_23 = &((var_point).chunk);
            var_24 = lowest_ray_0(var_13);
            var_26 = wp::load(var_23);
            var_25 = column_of_0(var_26, var_24);
            var_28 = _reader__locals__read_0(var_25, var_27);
            var_point.reach = var_28;
        }
        var_29 = wp::where(var_16, var_22, var_20);
        // alive = alive & (~these)                                                           <L 201>
        var_30 = wp::invert(var_29);
        var_31 = wp::bit_and(var_13, var_30);
        // if point.reach > 0.0:                                                              <L 202>
        var_32 = &((var_point).reach);
        var_35 = wp::load(var_32);
        var_34 = (var_35 > var_33);
        if (var_34) {
            // left = left & (~these | _unblocked_by_tree(tree, point, these))                <L 203>
            var_36 = wp::invert(var_29);
            var_37 = _unblocked_by_tree_0(var_tree, var_point, var_29);
            var_38 = wp::bit_or(var_36, var_37);
            var_39 = wp::bit_and(var_14, var_38);
        }
        var_40 = wp::where(var_34, var_39, var_14);
        wp::assign(var_13, var_31);
        wp::assign(var_14, var_40);
    goto start_while_0;
    end_while_0:;
    // return rays & (~left)                                                                  <L 204>
    var_41 = wp::invert(var_14);
    var_42 = wp::bit_and(var_rays, var_41);
    return var_42;
}


// /work/main/warpsample/estimate/stratum.py:132
static void stratum_sum__locals__sum_stratum_0(
    Lobes_4a4eb700 var_lobes,
    Accelerator_9fc73cd7 var_tree,
    Weights_23742fab var_data,
    ShadingPoint_241c3e67 var_point,
    wp::int32 var_stratum,
    wp::int32 var_found,
    wp::int32 var_local,
    wp::vec_t<3, wp::float64> & ret_0,
    wp::vec_t<3, wp::float64> & ret_1,
    wp::int32 & ret_2,
    wp::int32 & ret_3,
    wp::vec_t<3, wp::float32> & ret_4)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    const wp::int32 var_2 = 0;
    wp::int32 var_3;
    const wp::float64 var_4 = 0.0;
    wp::float64 var_5;
    wp::float64 var_6;
    wp::float64 var_7;
    wp::float64 var_8;
    wp::float64 var_9;
    wp::float64 var_10;
    const wp::int32 var_11 = 0;
    wp::int32 var_12;
    wp::int32* var_13;
    wp::int32 var_14;
    wp::int32 var_15;
    const wp::int32 var_16 = 2;
    wp::int32 var_17;
    const wp::float32 var_18 = 1.0;
    const wp::float32 var_19 = 0.0;
    const wp::float32 var_20 = 0.0;
    wp::vec_t<3, wp::float32> var_21;
    const wp::float32 var_22 = 0.0;
    const wp::float32 var_23 = 0.0;
    const wp::float32 var_24 = 0.0;
    wp::vec_t<3, wp::float32> var_25;
    Lobe_95707b65 var_26;
    const wp::int32 var_27 = 2;
    wp::int32 var_28;
    const wp::int32 var_29 = 0;
    const wp::int32 var_30 = 64;
    wp::range_t var_31;
    wp::int32 var_32;
    const wp::int32 var_33 = 64;
    const wp::int32 var_34 = 2;
    wp::int32 var_35;
    wp::int32 var_36;
    wp::int32 var_37;
    wp::int32 var_38;
    wp::uint64 var_39;
    wp::uint64 var_40;
    const wp::int32 var_41 = 0;
    bool var_42;
    wp::int32 var_43;
    wp::int32 var_44;
    bool var_45;
    const bool var_46 = true;
    const wp::int32 var_47 = -1;
    wp::int32 var_48;
    const wp::int32 var_49 = 0;
    bool var_50;
    wp::uint64 var_51;
    wp::uint64 var_52;
    wp::uint64 var_53;
    wp::uint64 var_54;
    wp::uint64 var_55;
    wp::int32 var_56;
    wp::int32 var_57;
    wp::int32 var_58;
    wp::uint64 var_59;
    wp::int32 var_60;
    wp::int32 var_61;
    wp::uint64 var_62;
    const bool var_63 = true;
    wp::int32 var_64;
    wp::int32 var_65;
    const wp::int32 var_66 = 2;
    wp::int32 var_67;
    const wp::int32 var_68 = 0;
    wp::int32 var_69;
    wp::uint64 var_70;
    wp::uint64 var_71;
    wp::int32 var_72;
    wp::int32 var_73;
    wp::int32 var_74;
    wp::int32 var_75;
    wp::int32 var_76;
    const bool var_77 = true;
    wp::float64 var_78;
    wp::float64 var_79;
    wp::int32 var_80;
    const bool var_81 = false;
    wp::vec_t<3, wp::float64> var_82;
    wp::vec_t<3, wp::float64> var_83;
    //---------
    // forward
    // def sum_stratum(                                                                       <L 133>
    // hits = wp.int32(0)                                                                     <L 144>
    var_1 = wp::int32(var_0);
    // more_hits = wp.int32(0)                                                                <L 145>
    var_3 = wp::int32(var_2);
    // x = ZERO                                                                               <L 146>
    var_5 = wp::copy(var_4);
    // y = ZERO                                                                               <L 147>
    var_6 = wp::copy(var_4);
    // z = ZERO                                                                               <L 148>
    var_7 = wp::copy(var_4);
    // more_x = ZERO                                                                          <L 149>
    var_8 = wp::copy(var_4);
    // more_y = ZERO                                                                          <L 150>
    var_9 = wp::copy(var_4);
    // more_z = ZERO                                                                          <L 151>
    var_10 = wp::copy(var_4);
    // cast = wp.int32(0)                                                                     <L 152>
    var_12 = wp::int32(var_11);
    // each = lobes.samples_per_stratum                                                       <L 153>
    var_13 = &((var_lobes).samples_per_stratum);
    var_15 = wp::load(var_13);
    var_14 = wp::copy(var_15);
    // free = 2 * each                                                                        <L 154>
    var_17 = wp::mul(var_16, var_14);
    // w = wp.vec3(1.0, 0.0, 0.0)                                                             <L 155>
    var_21 = wp::vec_t<3, wp::float32>(var_18, var_19, var_20);
    // lost = wp.vec3(0.0, 0.0, 0.0)                                                          <L 156>
    var_25 = wp::vec_t<3, wp::float32>(var_22, var_23, var_24);
    // lobe = lobe_of(lobes, point)                                                           <L 157>
    var_26 = lobe_of_0(var_lobes, var_point);
    // for first in range(0, 2 * each, CHUNK):                                                <L 158>
    var_28 = wp::mul(var_27, var_14);
    var_31 = wp::range(var_29, var_28, var_30);
    start_for_0:;
        if (iter_cmp(var_31) == 0) goto end_for_0;
        var_32 = wp::iter_next(var_31);
        // length = wp.min(CHUNK, 2 * each - first)                                           <L 159>
        var_35 = wp::mul(var_34, var_14);
        var_36 = wp::sub(var_35, var_32);
        var_37 = wp::min(var_33, var_36);
        // spread(lobes, point, stratum, first, whole_vectors(length))                        <L 160>
        var_38 = whole_vectors_0(var_37);
        spread_of__locals__spread_0(var_lobes, var_point, var_stratum, var_32, var_38);
        // rays = weigh(lobe, data, point, length)                                            <L 161>
        var_39 = weighing__locals__weigh_rays_0(var_26, var_data, var_point, var_37);
        // left = rays                                                                        <L 162>
        var_40 = wp::copy(var_39);
        // if found != 0:                                                                     <L 163>
        var_42 = (var_found != var_41);
        if (var_42) {
            // move_rays_near(point, length)                                                  <L 164>
            move_rays_near_0(var_point, var_37);
            // prepare(tree, point, local, length)                                            <L 165>
            prepare_rays__locals__prepare_chunk_0(var_tree, var_point, var_local, var_37);
            // cast += set_size(rays)                                                         <L 166>
            var_43 = set_size_0(var_39);
            var_44 = wp::add(var_12, var_43);
            // if wp.static(any_hit) and (found & stops) != 0:                                <L 167>
            var_45 = var_46;
            if (var_45) {
                var_48 = wp::bit_and(var_found, var_47);
                var_50 = (var_48 != var_49);
                var_45 = var_45 && var_50;
            }
            if (var_45) {
                // left = rays & (~block(tree, point, local, rays, length))                   <L 168>
                var_51 = blocked_rays_0(var_tree, var_point, var_local, var_39, var_37);
                var_52 = wp::invert(var_51);
                var_53 = wp::bit_and(var_39, var_52);
                // free -= set_size(rays & (~left))                                           <L 169>
                var_54 = wp::invert(var_53);
                var_55 = wp::bit_and(var_39, var_54);
                var_56 = set_size_0(var_55);
                var_57 = wp::sub(var_17, var_56);
            }
            var_58 = wp::where(var_45, var_57, var_17);
            var_59 = wp::where(var_45, var_53, var_40);
        }
        var_60 = wp::where(var_42, var_44, var_12);
        var_61 = wp::where(var_42, var_58, var_17);
        var_62 = wp::where(var_42, var_59, var_40);
        // if wp.static(counts):                                                              <L 170>
        // hits += set_size(left)                                                             <L 171>
        var_64 = set_size_0(var_62);
        var_65 = wp::add(var_1, var_64);
        // more_hits += 2 * set_size(left & first_rays(wp.clamp(each - first, 0, length))) - set_size(left)       <L 172>
        var_67 = wp::sub(var_14, var_32);
        var_69 = wp::clamp(var_67, var_68, var_37);
        var_70 = first_rays_0(var_69);
        var_71 = wp::bit_and(var_62, var_70);
        var_72 = set_size_0(var_71);
        var_73 = wp::mul(var_66, var_72);
        var_74 = set_size_0(var_62);
        var_75 = wp::sub(var_73, var_74);
        var_76 = wp::add(var_3, var_75);
        wp::assign(var_1, var_65);
        wp::assign(var_3, var_76);
        wp::assign(var_12, var_60);
        wp::assign(var_17, var_61);
        goto start_for_0;
    end_for_0:;
    // if wp.static(counts):                                                                  <L 191>
    // x = wp.float64(hits)                                                                   <L 192>
    var_78 = wp::float64(var_1);
    // more_x = wp.float64(more_hits)                                                         <L 193>
    var_79 = wp::float64(var_3);
    // free = hits  # and weighs 1                                                            <L 194>
    var_80 = wp::copy(var_1);
    // if wp.static(glass):                                                                   <L 195>
    // return wp.vec3d(x, y, z), wp.vec3d(more_x, more_y, more_z), cast, free, w              <L 197>
    var_82 = wp::vec_t<3, wp::float64>(var_78, var_6, var_7);
    var_83 = wp::vec_t<3, wp::float64>(var_79, var_9, var_10);
    ret_0 = var_82;
    ret_1 = var_83;
    ret_2 = var_12;
    ret_3 = var_80;
    ret_4 = var_21;
    return;
}


// /work/main/warpsample/estimate/stratum.py:31
static wp::vec_t<3, wp::float64> jump_of__locals__jump_at_0(
    wp::vec_t<3, wp::float32> var_w,
    wp::vec_t<3, wp::float64> var_total,
    wp::int32 var_free,
    wp::int32 var_rays)
{
    //---------
    // primal vars
    const wp::float64 var_0 = 1.0;
    const wp::float64 var_1 = 0.0;
    wp::vec_t<3, wp::float64> var_2;
    const bool var_3 = false;
    const bool var_4 = false;
    wp::vec_t<3, wp::float64> var_5;
    //---------
    // forward
    // def jump_at(w: wp.vec3, total: wp.vec3d, free: wp.int32, rays: wp.int32) -> wp.vec3d:       <L 32>
    // jump = wp.vec3d(ONE, ZERO, ZERO)                                                       <L 37>
    var_2 = wp::vec_t<3, wp::float64>(var_0, var_1, var_1);
    // if wp.static(not any_hit):                                                             <L 38>
    // if wp.static(not counts):                                                              <L 43>
    // return wp.cw_mul(jump, jump)                                                           <L 47>
    var_5 = wp::cw_mul(var_2, var_2);
    return var_5;
}


// /work/main/warpsample/estimate/intervals.py:73
static wp::float64 edge_variance_0(
    wp::int32 var_free,
    wp::int32 var_rays,
    wp::float32 var_limit)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::int32 var_1;
    wp::float64 var_2;
    wp::float64 var_3;
    const wp::int32 var_4 = 1;
    wp::int32 var_5;
    wp::float64 var_6;
    wp::float64 var_7;
    wp::float64 var_8;
    wp::float64 var_9;
    //---------
    // forward
    // def edge_variance(free: wp.int32, rays: wp.int32, limit: wp.float32) -> wp.float64:       <L 74>
    // share = wp.float64(free) * wp.float64(rays - free) / wp.float64(rays - 1)              <L 79>
    var_0 = wp::float64(var_free);
    var_1 = wp::sub(var_rays, var_free);
    var_2 = wp::float64(var_1);
    var_3 = wp::mul(var_0, var_2);
    var_5 = wp::sub(var_rays, var_4);
    var_6 = wp::float64(var_5);
    var_7 = wp::div(var_3, var_6);
    // return wp.min(share, wp.float64(limit))                                                <L 80>
    var_8 = wp::float64(var_limit);
    var_9 = wp::min(var_7, var_8);
    return var_9;
}


// /work/main/warpsample/estimate/intervals.py:83
static void posterior_0(
    wp::float64 var_variance,
    wp::float64 var_expected,
    wp::float64 var_unseen,
    wp::float64 var_rest,
    wp::float64 var_fourth,
    wp::int32 var_mixed,
    wp::int32 var_fewer,
    wp::int32 var_strata,
    Prior_2e82b100 var_prior,
    wp::float64 & ret_0,
    wp::float64 & ret_1)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    bool var_1;
    wp::float64* var_2;
    wp::float64* var_3;
    wp::float64 var_4;
    wp::float64 var_5;
    wp::float64 var_6;
    const wp::int32 var_7 = 1;
    bool var_8;
    wp::float64* var_9;
    wp::float64* var_10;
    wp::float64 var_11;
    wp::float64 var_12;
    wp::float64 var_13;
    const wp::int32 var_14 = 0;
    bool var_15;
    wp::float64* var_16;
    wp::float64 var_17;
    wp::float64 var_18;
    wp::float64 var_19;
    wp::float64 var_20;
    const wp::int32 var_21 = 0;
    bool var_22;
    wp::float64 var_23;
    const wp::float64 var_24 = 0.0;
    wp::float64 var_25;
    bool var_26;
    wp::float64 var_27;
    wp::float64 var_28;
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
    bool var_41;
    const wp::float64 var_42 = 3.0;
    wp::float64 var_43;
    wp::float64 var_44;
    wp::float64 var_45;
    const wp::float64 var_46 = 2.0;
    wp::float64 var_47;
    const wp::float64 var_48 = 1.0;
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
    //---------
    // forward
    // def posterior(                                                                         <L 84>
    // worth = wp.where(mixed > 0, prior.worth, prior.worth_if_all_agree)                     <L 108>
    var_1 = (var_mixed > var_0);
    var_2 = &((var_prior).worth);
    var_3 = &((var_prior).worth_if_all_agree);
    var_5 = wp::load(var_2);
    var_6 = wp::load(var_3);
    var_4 = wp::where(var_1, var_5, var_6);
    // of_ray = wp.where(fewer == 1, prior.unseen_if_one_differs, prior.unseen)               <L 109>
    var_8 = (var_fewer == var_7);
    var_9 = &((var_prior).unseen_if_one_differs);
    var_10 = &((var_prior).unseen);
    var_12 = wp::load(var_9);
    var_13 = wp::load(var_10);
    var_11 = wp::where(var_8, var_12, var_13);
    // edges = expected + wp.where(mixed > 0, of_ray, prior.unseen_if_all_agree) * unseen       <L 110>
    var_15 = (var_mixed > var_14);
    var_16 = &((var_prior).unseen_if_all_agree);
    var_18 = wp::load(var_16);
    var_17 = wp::where(var_15, var_11, var_18);
    var_19 = wp::mul(var_17, var_unseen);
    var_20 = wp::add(var_expected, var_19);
    // seen = wp.where(mixed > 0, variance - rest, ZERO)                                      <L 111>
    var_22 = (var_mixed > var_21);
    var_23 = wp::sub(var_variance, var_rest);
    var_25 = wp::where(var_22, var_23, var_24);
    // if seen > edges:                                                                       <L 112>
    var_26 = (var_25 > var_20);
    if (var_26) {
        // worth *= (edges / seen) * (edges / seen)                                           <L 113>
        var_27 = wp::div(var_20, var_25);
        var_28 = wp::div(var_20, var_25);
        var_29 = wp::mul(var_27, var_28);
        var_30 = wp::mul(var_4, var_29);
    }
    var_31 = wp::where(var_26, var_30, var_4);
    // degrees = worth + wp.float64(mixed)                                                    <L 114>
    var_32 = wp::float64(var_mixed);
    var_33 = wp::add(var_31, var_32);
    // shrunk = (worth * edges + wp.float64(mixed) * wp.max(seen, ZERO)) / degrees  # rounding leaves seen below 0       <L 115>
    var_34 = wp::mul(var_31, var_20);
    var_35 = wp::float64(var_mixed);
    var_36 = wp::max(var_25, var_24);
    var_37 = wp::mul(var_35, var_36);
    var_38 = wp::add(var_34, var_37);
    var_39 = wp::div(var_38, var_33);
    // square = shrunk + rest                                                                 <L 116>
    var_40 = wp::add(var_39, var_rest);
    // if rest > ZERO:                                                                        <L 117>
    var_41 = (var_rest > var_24);
    if (var_41) {
        // own = wp.clamp(_THREE * (rest / fourth) * rest - TWO, ONE, wp.float64(strata))       <L 119>
        var_43 = wp::div(var_rest, var_fourth);
        var_44 = wp::mul(var_42, var_43);
        var_45 = wp::mul(var_44, var_rest);
        var_47 = wp::sub(var_45, var_46);
        var_49 = wp::float64(var_strata);
        var_50 = wp::clamp(var_47, var_48, var_49);
        // first = shrunk / square                                                            <L 120>
        var_51 = wp::div(var_39, var_40);
        // second = rest / square                                                             <L 121>
        var_52 = wp::div(var_rest, var_40);
        // degrees = ONE / (first * first / degrees + second * second / own)                  <L 122>
        var_53 = wp::mul(var_51, var_51);
        var_54 = wp::div(var_53, var_33);
        var_55 = wp::mul(var_52, var_52);
        var_56 = wp::div(var_55, var_50);
        var_57 = wp::add(var_54, var_56);
        var_58 = wp::div(var_48, var_57);
    }
    var_59 = wp::where(var_41, var_58, var_33);
    // return square, degrees                                                                 <L 123>
    ret_0 = var_40;
    ret_1 = var_59;
    return;
}


// /work/main/warpsample/estimate/lobe.py:25
static void widths_of__locals__widths_of_0(
    wp::vec_t<3, wp::float64> var_variance,
    wp::vec_t<3, wp::float64> var_expected,
    wp::vec_t<3, wp::float64> var_unseen,
    wp::vec_t<3, wp::float64> var_rest,
    wp::vec_t<3, wp::float64> var_fourth,
    wp::int32 var_mixed,
    wp::int32 var_fewer,
    wp::int32 var_strata,
    wp::vec_t<3, wp::float64> & ret_0,
    wp::vec_t<3, wp::float64> & ret_1)
{
    //---------
    // primal vars
    const wp::vec_t<3, wp::float64> var_0 = wp::initializer_array<3,wp::float64>{0.0, 0.0, 0.0};
    wp::vec_t<3, wp::float64> var_1;
    wp::vec_t<3, wp::float64> var_2;
    const wp::float64 var_3 = 16.0;
    const wp::float64 var_4 = 0.6;
    const wp::float64 var_5 = 9.0;
    const wp::float64 var_6 = 2.6895999999999995;
    const wp::float64 var_7 = 3.85;
    Prior_2e82b100 var_8;
    const wp::int32 var_9 = 0;
    wp::float64 var_10;
    wp::float64 var_11;
    wp::float64 var_12;
    wp::float64 var_13;
    wp::float64 var_14;
    wp::float64 var_15;
    wp::float64 var_16;
    wp::float64 var_17;
    wp::float64 var_18;
    //---------
    // forward
    // def widths_of(                                                                         <L 26>
    // width = NOTHING                                                                        <L 37>
    var_1 = wp::copy(var_0);
    // degrees = NOTHING                                                                      <L 38>
    var_2 = wp::copy(var_0);
    // prior = Prior(worth, unseen_ray, worth_if_agreed, unseen_if_agreed, unseen_if_one)       <L 39>
    var_8 = Prior_2e82b100(var_3, var_4, var_5, var_6, var_7);
    // for c in range(channels):                                                              <L 40>
    // of_ray = unseen[c] / wp.float64(strata)                                                <L 41>
    var_10 = wp::extract(var_unseen, var_9);
    var_11 = wp::float64(var_strata);
    var_12 = wp::div(var_10, var_11);
    // square, freedom = posterior(variance[c], expected[c], of_ray, rest[c], fourth[c], mixed, fewer, strata, prior)       <L 42>
    var_13 = wp::extract(var_variance, var_9);
    var_14 = wp::extract(var_expected, var_9);
    var_15 = wp::extract(var_rest, var_9);
    var_16 = wp::extract(var_fourth, var_9);
    posterior_0(var_13, var_14, var_12, var_15, var_16, var_mixed, var_fewer, var_strata, var_8, var_17, var_18);
    // width[c] = square                                                                      <L 43>
    wp::assign_inplace(var_1, var_9, var_17);
    // degrees[c] = freedom                                                                   <L 44>
    wp::assign_inplace(var_2, var_9, var_18);
    // return width, degrees                                                                  <L 45>
    ret_0 = var_1;
    ret_1 = var_2;
    return;
}


// /work/main/warpsample/estimate/lobe.py:57
static void traced_lobe__locals__sum_lobe_0(
    Lobes_4a4eb700 var_lobes,
    Accelerator_9fc73cd7 var_accelerator,
    Weights_23742fab var_data,
    ShadingPoint_241c3e67 var_point,
    wp::vec_t<3, wp::float64> & ret_0,
    wp::vec_t<3, wp::float64> & ret_1,
    wp::vec_t<3, wp::float64> & ret_2,
    wp::vec_t<3, wp::float64> & ret_3,
    wp::int32 & ret_4,
    wp::int32 & ret_5)
{
    //---------
    // primal vars
    const wp::vec_t<3, wp::float64> var_0 = wp::initializer_array<3,wp::float64>{0.0, 0.0, 0.0};
    wp::vec_t<3, wp::float64> var_1;
    wp::vec_t<3, wp::float64> var_2;
    const wp::int32 var_3 = 0;
    wp::int32 var_4;
    const wp::int32 var_5 = 0;
    wp::int32 var_6;
    wp::vec_t<3, wp::float64> var_7;
    wp::vec_t<3, wp::float64> var_8;
    wp::vec_t<3, wp::float64> var_9;
    wp::vec_t<3, wp::float64> var_10;
    const wp::int32 var_11 = 0;
    wp::int32 var_12;
    const wp::int32 var_13 = 0;
    wp::int32 var_14;
    Accelerator_9fc73cd7 var_15;
    const wp::int32 var_16 = 0;
    wp::int32 var_17;
    const bool var_18 = false;
    bool var_19;
    const bool var_20 = true;
    wp::int32* var_21;
    const wp::int32 var_22 = 0;
    bool var_23;
    wp::int32 var_24;
    Accelerator_9fc73cd7 var_25;
    wp::int32 var_26;
    bool var_27;
    Accelerator_9fc73cd7 var_28;
    wp::int32 var_29;
    bool var_30;
    bool var_31;
    wp::int32* var_32;
    const wp::int32 var_33 = 0;
    bool var_34;
    wp::int32 var_35;
    const wp::int32 var_36 = 0;
    bool var_37;
    const wp::int32 var_38 = 0;
    const wp::int32 var_39 = 1;
    wp::int32 var_40;
    const wp::int32 var_41 = 0;
    wp::int32 var_42;
    wp::int32* var_43;
    wp::range_t var_44;
    wp::int32 var_45;
    wp::int32 var_46;
    wp::int32 var_47;
    wp::int32* var_48;
    const wp::int32 var_49 = 2;
    bool var_50;
    wp::int32 var_51;
    const wp::int32 var_52 = 0;
    const wp::int32 var_53 = 1;
    wp::int32 var_54;
    wp::int32* var_55;
    const wp::int32 var_56 = 1;
    wp::int32 var_57;
    wp::int32 var_58;
    wp::range_t var_59;
    wp::int32 var_60;
    wp::int32 var_61;
    wp::int32 var_62;
    const bool var_63 = true;
    bool var_64;
    wp::uint64* var_65;
    wp::uint64 var_66;
    bool var_67;
    wp::uint64 var_68;
    const wp::int32 var_69 = 0;
    bool var_70;
    wp::int32* var_71;
    const wp::int32 var_72 = 1;
    wp::int32 var_73;
    wp::int32 var_74;
    wp::int32 var_75;
    wp::int32 var_76;
    wp::int32 var_77;
    wp::int32 var_78;
    wp::int32 var_79;
    wp::int32 var_80;
    const wp::int32 var_81 = 0;
    bool var_82;
    wp::int32 var_83;
    bool var_84;
    const bool var_85 = true;
    const wp::int32 var_86 = 0;
    bool var_87;
    const wp::int32 var_88 = 2;
    wp::int32* var_89;
    wp::int32 var_90;
    wp::int32 var_91;
    wp::int32 var_92;
    const wp::int32 var_93 = 0;
    const wp::int32 var_94 = 2;
    wp::int32* var_95;
    wp::int32 var_96;
    wp::int32 var_97;
    wp::float64 var_98;
    const wp::int32 var_99 = 0;
    const wp::float64 var_100 = 1.0;
    const wp::int32 var_101 = 0;
    bool var_102;
    const wp::int32 var_103 = 2;
    wp::int32* var_104;
    wp::int32 var_105;
    wp::int32 var_106;
    const wp::int32 var_107 = 0;
    wp::int32 var_108;
    wp::int32 var_109;
    wp::int32* var_110;
    wp::int32 var_111;
    wp::int32 var_112;
    wp::int32 var_113;
    const wp::int32 var_114 = 1;
    wp::int32 var_115;
    wp::vec_t<3, wp::float64> var_116;
    wp::vec_t<3, wp::float64> var_117;
    wp::int32 var_118;
    wp::int32 var_119;
    wp::vec_t<3, wp::float32> var_120;
    wp::int32 var_121;
    wp::vec_t<3, wp::float64> var_122;
    wp::vec_t<3, wp::float64> var_123;
    wp::vec_t<3, wp::float64> var_124;
    const wp::int32 var_125 = 2;
    wp::int32* var_126;
    wp::int32 var_127;
    wp::int32 var_128;
    wp::vec_t<3, wp::float64> var_129;
    wp::vec_t<3, wp::float64> var_130;
    bool var_131;
    const wp::int32 var_132 = 0;
    bool var_133;
    const wp::int32 var_134 = 2;
    wp::int32* var_135;
    wp::int32 var_136;
    wp::int32 var_137;
    bool var_138;
    const wp::int32 var_139 = 2;
    wp::int32* var_140;
    wp::int32 var_141;
    wp::int32 var_142;
    wp::float32* var_143;
    wp::float64 var_144;
    wp::float32 var_145;
    wp::vec_t<3, wp::float64> var_146;
    wp::vec_t<3, wp::float64> var_147;
    const wp::int32 var_148 = 1;
    wp::int32 var_149;
    const wp::int32 var_150 = 2;
    wp::int32* var_151;
    wp::int32 var_152;
    wp::int32 var_153;
    wp::int32 var_154;
    wp::int32 var_155;
    wp::int32 var_156;
    wp::vec_t<3, wp::float64> var_157;
    wp::vec_t<3, wp::float64> var_158;
    wp::vec_t<3, wp::float64> var_159;
    wp::int32 var_160;
    wp::int32 var_161;
    wp::vec_t<3, wp::float64> var_162;
    wp::vec_t<3, wp::float64> var_163;
    wp::vec_t<3, wp::float64> var_164;
    wp::vec_t<3, wp::float64> var_165;
    wp::vec_t<3, wp::float64> var_166;
    wp::int32 var_167;
    wp::int32 var_168;
    wp::vec_t<3, wp::float64> var_169;
    wp::vec_t<3, wp::float64> var_170;
    wp::vec_t<3, wp::float64> var_171;
    wp::vec_t<3, wp::float64> var_172;
    wp::int32 var_173;
    wp::int32 var_174;
    wp::vec_t<3, wp::float64> var_175;
    wp::vec_t<3, wp::float64> var_176;
    wp::int32 var_177;
    wp::int32 var_178;
    wp::vec_t<3, wp::float64> var_179;
    wp::vec_t<3, wp::float64> var_180;
    wp::vec_t<3, wp::float64> var_181;
    wp::vec_t<3, wp::float64> var_182;
    wp::int32 var_183;
    wp::int32 var_184;
    wp::int32 var_185;
    wp::int32* var_186;
    wp::int32* var_187;
    wp::int32 var_188;
    wp::int32 var_189;
    wp::int32 var_190;
    wp::vec_t<3, wp::float64> var_191;
    wp::vec_t<3, wp::float64> var_192;
    //---------
    // forward
    // def sum_lobe(lobes: Lobes, accelerator: Accelerator, data: struct, point: ShadingPoint):       <L 58>
    // total = NOTHING                                                                        <L 60>
    var_1 = wp::copy(var_0);
    // variance = NOTHING                                                                     <L 61>
    var_2 = wp::copy(var_0);
    // mixed = wp.int32(0)                                                                    <L 62>
    var_4 = wp::int32(var_3);
    // fewer = wp.int32(0)                                                                    <L 63>
    var_6 = wp::int32(var_5);
    // expected = NOTHING                                                                     <L 64>
    var_7 = wp::copy(var_0);
    // unseen = NOTHING                                                                       <L 65>
    var_8 = wp::copy(var_0);
    // rest = NOTHING                                                                         <L 66>
    var_9 = wp::copy(var_0);
    // fourth = NOTHING                                                                       <L 67>
    var_10 = wp::copy(var_0);
    // cast = wp.int32(0)                                                                     <L 68>
    var_12 = wp::int32(var_11);
    // empty = wp.int32(0)                                                                    <L 69>
    var_14 = wp::int32(var_13);
    // seen = accelerator                                                                     <L 70>
    var_15 = wp::copy(var_accelerator);
    // local = wp.int32(0)                                                                    <L 71>
    var_17 = wp::int32(var_16);
    // opened = wp.bool(False)                                                                <L 72>
    var_19 = bool(var_18);
    // if wp.static(wide):                                                                    <L 73>
    // if lobes.skip != 0:                                                                    <L 74>
    var_21 = &((var_lobes).skip);
    var_24 = wp::load(var_21);
    var_23 = (var_24 != var_22);
    if (var_23) {
        // seen, local, opened = open_around(accelerator, point)                              <L 75>
        open_around_0(var_accelerator, var_point, var_25, var_26, var_27);
    }
    var_28 = wp::where(var_23, var_25, var_15);
    var_29 = wp::where(var_23, var_26, var_17);
    var_30 = wp::where(var_23, var_27, var_19);
    // anything = wp.where(seen.starts == 0 and local == 0, 0, BLOCKERS) | of_glass           <L 76>
    var_32 = &((var_28).starts);
    var_35 = wp::load(var_32);
    var_34 = (var_35 == var_33);
    var_31 = var_34;
    if (var_31) {
        var_37 = (var_29 == var_36);
        var_31 = var_31 && var_37;
    }
    var_40 = wp::where(var_31, var_38, var_39);
    var_42 = wp::bit_or(var_40, var_41);
    // for sector in range(lobes.sectors):                                                    <L 77>
    var_43 = &((var_lobes).sectors);
    var_45 = wp::load(var_43);
    var_44 = wp::range(var_45);
    start_for_0:;
        if (iter_cmp(var_44) == 0) goto end_for_0;
        var_46 = wp::iter_next(var_44);
        // sector_found = anything                                                            <L 78>
        var_47 = wp::copy(var_42);
        // for step in range(wp.where(lobes.bands > 2, 0, 1), lobes.bands + 1):  # a sector of many bands, then its bands       <L 79>
        var_48 = &((var_lobes).bands);
        var_51 = wp::load(var_48);
        var_50 = (var_51 > var_49);
        var_54 = wp::where(var_50, var_52, var_53);
        var_55 = &((var_lobes).bands);
        var_58 = wp::load(var_55);
        var_57 = wp::add(var_58, var_56);
        var_59 = wp::range(var_54, var_57);
        start_for_2:;
            if (iter_cmp(var_59) == 0) goto end_for_2;
            var_60 = wp::iter_next(var_59);
            // found = sector_found                                                           <L 80>
            var_61 = wp::copy(var_47);
            // stratum_local = local                                                          <L 81>
            var_62 = wp::copy(var_29);
            // if wp.static(wide):                                                            <L 82>
            // if opened and lobes.shafts != wp.uint64(0) and found != 0:                     <L 83>
            var_64 = var_30;
            if (var_64) {
                var_65 = &((var_lobes).shafts);
                var_66 = 0ull;
                var_68 = wp::load(var_65);
                var_67 = (var_68 != var_66);
                var_64 = var_64 && var_67;
            }
            if (var_64) {
                var_70 = (var_61 != var_69);
                var_64 = var_64 && var_70;
            }
            if (var_64) {
                // shaft = sector * (lobes.bands + 1) + step                                  <L 84>
                var_71 = &((var_lobes).bands);
                var_74 = wp::load(var_71);
                var_73 = wp::add(var_74, var_72);
                var_75 = wp::mul(var_46, var_73);
                var_76 = wp::add(var_75, var_60);
                // found, stratum_local = find(lobes, seen, point, shaft, local)              <L 85>
                finder_of__locals__find_0(var_lobes, var_28, var_point, var_76, var_29, var_77, var_78);
            }
            var_79 = wp::where(var_64, var_77, var_61);
            var_80 = wp::where(var_64, var_78, var_62);
            // if step == 0:                                                                  <L 86>
            var_82 = (var_60 == var_81);
            if (var_82) {
                // sector_found = found                                                       <L 87>
                var_83 = wp::copy(var_79);
            }
            if (!var_82) {
                // elif wp.static(constant) and found == 0:                                   <L 88>
                var_84 = var_85;
                if (var_84) {
                    var_87 = (var_79 == var_86);
                    var_84 = var_84 && var_87;
                }
                if (var_84) {
                    // empty += 2 * lobes.samples_per_stratum                                 <L 89>
                    var_89 = &((var_lobes).samples_per_stratum);
                    var_91 = wp::load(var_89);
                    var_90 = wp::mul(var_88, var_91);
                    var_92 = wp::add(var_14, var_90);
                    // total[0] += wp.float64(2 * lobes.samples_per_stratum)                  <L 90>
                    var_95 = &((var_lobes).samples_per_stratum);
                    var_97 = wp::load(var_95);
                    var_96 = wp::mul(var_94, var_97);
                    var_98 = wp::float64(var_96);
                    wp::add_inplace(var_1, var_93, var_98);
                    // unseen[0] += open_jump                                                 <L 91>
                    wp::add_inplace(var_8, var_99, var_100);
                }
                if (!var_84) {
                    // empty += wp.where(found == 0, 2 * lobes.samples_per_stratum, 0)        <L 93>
                    var_102 = (var_79 == var_101);
                    var_104 = &((var_lobes).samples_per_stratum);
                    var_106 = wp::load(var_104);
                    var_105 = wp::mul(var_103, var_106);
                    var_108 = wp::where(var_102, var_105, var_107);
                    var_109 = wp::add(var_14, var_108);
                    // add, difference, rays, free, w = sum_stratum(                          <L 94>
                    // lobes, seen, data, point, sector * lobes.bands + step - 1, found, stratum_local       <L 95>
                    var_110 = &((var_lobes).bands);
                    var_112 = wp::load(var_110);
                    var_111 = wp::mul(var_46, var_112);
                    var_113 = wp::add(var_111, var_60);
                    var_115 = wp::sub(var_113, var_114);
                    stratum_sum__locals__sum_stratum_0(var_lobes, var_28, var_data, var_point, var_115, var_79, var_80, var_116, var_117, var_118, var_119, var_120);
                    // cast += rays                                                           <L 97>
                    var_121 = wp::add(var_12, var_118);
                    // squares = wp.cw_mul(difference, difference)                            <L 98>
                    var_122 = wp::cw_mul(var_117, var_117);
                    // total += add                                                           <L 99>
                    var_123 = wp::add(var_1, var_116);
                    // variance += squares                                                    <L 100>
                    var_124 = wp::add(var_2, var_122);
                    // jump = jump_at(w, add, free, 2 * lobes.samples_per_stratum)            <L 101>
                    var_126 = &((var_lobes).samples_per_stratum);
                    var_128 = wp::load(var_126);
                    var_127 = wp::mul(var_125, var_128);
                    var_129 = jump_of__locals__jump_at_0(var_120, var_116, var_119, var_127);
                    // unseen += jump                                                         <L 102>
                    var_130 = wp::add(var_8, var_129);
                    // if free > 0 and free < 2 * lobes.samples_per_stratum:                  <L 103>
                    var_133 = (var_119 > var_132);
                    var_131 = var_133;
                    if (var_131) {
                        var_135 = &((var_lobes).samples_per_stratum);
                        var_137 = wp::load(var_135);
                        var_136 = wp::mul(var_134, var_137);
                        var_138 = (var_119 < var_136);
                        var_131 = var_131 && var_138;
                    }
                    if (var_131) {
                        // expected += edge_variance(free, 2 * lobes.samples_per_stratum, lobes.edge) * jump       <L 104>
                        var_140 = &((var_lobes).samples_per_stratum);
                        var_142 = wp::load(var_140);
                        var_141 = wp::mul(var_139, var_142);
                        var_143 = &((var_lobes).edge);
                        var_145 = wp::load(var_143);
                        var_144 = edge_variance_0(var_119, var_141, var_145);
                        var_146 = wp::mul(var_144, var_129);
                        var_147 = wp::add(var_7, var_146);
                        // mixed += 1                                                         <L 105>
                        var_149 = wp::add(var_4, var_148);
                        // fewer += wp.min(free, 2 * lobes.samples_per_stratum - free)        <L 106>
                        var_151 = &((var_lobes).samples_per_stratum);
                        var_153 = wp::load(var_151);
                        var_152 = wp::mul(var_150, var_153);
                        var_154 = wp::sub(var_152, var_119);
                        var_155 = wp::min(var_119, var_154);
                        var_156 = wp::add(var_6, var_155);
                    }
                    if (!var_131) {
                        // rest += squares                                                    <L 108>
                        var_157 = wp::add(var_9, var_122);
                        // fourth += wp.cw_mul(squares, squares)                              <L 109>
                        var_158 = wp::cw_mul(var_122, var_122);
                        var_159 = wp::add(var_10, var_158);
                    }
                    var_160 = wp::where(var_131, var_149, var_4);
                    var_161 = wp::where(var_131, var_156, var_6);
                    var_162 = wp::where(var_131, var_147, var_7);
                    var_163 = wp::where(var_131, var_9, var_157);
                    var_164 = wp::where(var_131, var_10, var_159);
                }
                var_165 = wp::where(var_84, var_1, var_123);
                var_166 = wp::where(var_84, var_2, var_124);
                var_167 = wp::where(var_84, var_4, var_160);
                var_168 = wp::where(var_84, var_6, var_161);
                var_169 = wp::where(var_84, var_7, var_162);
                var_170 = wp::where(var_84, var_8, var_130);
                var_171 = wp::where(var_84, var_9, var_163);
                var_172 = wp::where(var_84, var_10, var_164);
                var_173 = wp::where(var_84, var_12, var_121);
                var_174 = wp::where(var_84, var_92, var_109);
            }
            var_175 = wp::where(var_82, var_1, var_165);
            var_176 = wp::where(var_82, var_2, var_166);
            var_177 = wp::where(var_82, var_4, var_167);
            var_178 = wp::where(var_82, var_6, var_168);
            var_179 = wp::where(var_82, var_7, var_169);
            var_180 = wp::where(var_82, var_8, var_170);
            var_181 = wp::where(var_82, var_9, var_171);
            var_182 = wp::where(var_82, var_10, var_172);
            var_183 = wp::where(var_82, var_12, var_173);
            var_184 = wp::where(var_82, var_14, var_174);
            var_185 = wp::where(var_82, var_83, var_47);
            wp::assign(var_1, var_175);
            wp::assign(var_2, var_176);
            wp::assign(var_4, var_177);
            wp::assign(var_6, var_178);
            wp::assign(var_7, var_179);
            wp::assign(var_8, var_180);
            wp::assign(var_9, var_181);
            wp::assign(var_10, var_182);
            wp::assign(var_12, var_183);
            wp::assign(var_14, var_184);
            wp::assign(var_47, var_185);
            goto start_for_2;
        end_for_2:;
        goto start_for_0;
    end_for_0:;
    // width, degrees = widths(variance, expected, unseen, rest, fourth, mixed, fewer, lobes.bands * lobes.sectors)       <L 110>
    var_186 = &((var_lobes).bands);
    var_187 = &((var_lobes).sectors);
    var_189 = wp::load(var_186);
    var_190 = wp::load(var_187);
    var_188 = wp::mul(var_189, var_190);
    widths_of__locals__widths_of_0(var_2, var_7, var_8, var_9, var_10, var_4, var_6, var_188, var_191, var_192);
    // return total, variance, width, degrees, cast, empty                                    <L 111>
    ret_0 = var_1;
    ret_1 = var_2;
    ret_2 = var_191;
    ret_3 = var_192;
    ret_4 = var_12;
    ret_5 = var_14;
    return;
}


// /work/main/warpsample/estimate/kernel.py:25
static void _keep__locals__keep_0(
    Lobes_4a4eb700 var_lobes,
    wp::int64 var_point,
    wp::vec_t<3, wp::float64> var_total,
    wp::vec_t<3, wp::float64> var_variance,
    wp::vec_t<3, wp::float64> var_width,
    wp::vec_t<3, wp::float64> var_degrees)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 2;
    wp::int32* var_1;
    wp::int32 var_2;
    wp::int32 var_3;
    wp::int32* var_4;
    wp::int32 var_5;
    wp::int32 var_6;
    wp::int32* var_7;
    wp::int32 var_8;
    wp::int32 var_9;
    wp::float64 var_10;
    wp::uint64 var_11;
    const wp::int32 var_12 = 4;
    const wp::int32 var_13 = 1;
    wp::int32 var_14;
    wp::uint64 var_15;
    wp::uint64 var_16;
    wp::uint64* var_17;
    wp::uint64 var_18;
    wp::uint64 var_19;
    wp::tuple_t<wp::int32> var_20;
    wp::array_t<wp::float32> var_21;
    const wp::int32 var_22 = 1;
    wp::uint64* var_23;
    wp::uint64 var_24;
    wp::uint64 var_25;
    wp::tuple_t<wp::int32> var_26;
    wp::array_t<wp::float32> var_27;
    const wp::int32 var_28 = 1;
    wp::uint64* var_29;
    wp::uint64 var_30;
    wp::uint64 var_31;
    wp::tuple_t<wp::int32> var_32;
    wp::array_t<wp::float32> var_33;
    const wp::int32 var_34 = 1;
    wp::uint64* var_35;
    wp::uint64 var_36;
    wp::uint64 var_37;
    wp::tuple_t<wp::int32> var_38;
    wp::array_t<wp::float32> var_39;
    const wp::int32 var_40 = 1;
    const wp::int32 var_41 = 0;
    wp::float64 var_42;
    wp::float64 var_43;
    wp::float32 var_44;
    wp::float64 var_45;
    wp::float64 var_46;
    wp::float64 var_47;
    wp::float32 var_48;
    wp::float64 var_49;
    wp::float64 var_50;
    wp::float64 var_51;
    wp::float32 var_52;
    wp::float64 var_53;
    wp::float32 var_54;
    //---------
    // forward
    // def keep(lobes: Lobes, point: wp.int64, total: wp.vec3d, variance: wp.vec3d, width: wp.vec3d, degrees: wp.vec3d):       <L 26>
    // rays = wp.float64(2 * lobes.samples_per_stratum * lobes.bands * lobes.sectors)         <L 28>
    var_1 = &((var_lobes).samples_per_stratum);
    var_3 = wp::load(var_1);
    var_2 = wp::mul(var_0, var_3);
    var_4 = &((var_lobes).bands);
    var_6 = wp::load(var_4);
    var_5 = wp::mul(var_2, var_6);
    var_7 = &((var_lobes).sectors);
    var_9 = wp::load(var_7);
    var_8 = wp::mul(var_5, var_9);
    var_10 = wp::float64(var_8);
    // at = wp.uint64(point) * wp.uint64(4 * channels)                                        <L 29>
    var_11 = wp::uint64(var_point);
    var_14 = wp::mul(var_12, var_13);
    var_15 = wp::uint64(var_14);
    var_16 = wp::mul(var_11, var_15);
    // value = wp.array(ptr=lobes.value + at, shape=(channels,), dtype=wp.float32)            <L 30>
    var_17 = &((var_lobes).value);
    var_19 = wp::load(var_17);
    var_18 = wp::add(var_19, var_16);
    var_20 = wp::tuple(var_13);
    var_21 = wp::array_t<wp::float32>(var_18, var_22);
    // error = wp.array(ptr=lobes.error + at, shape=(channels,), dtype=wp.float32)            <L 31>
    var_23 = &((var_lobes).error);
    var_25 = wp::load(var_23);
    var_24 = wp::add(var_25, var_16);
    var_26 = wp::tuple(var_13);
    var_27 = wp::array_t<wp::float32>(var_24, var_28);
    // spreads = wp.array(ptr=lobes.spread + at, shape=(channels,), dtype=wp.float32)         <L 32>
    var_29 = &((var_lobes).spread);
    var_31 = wp::load(var_29);
    var_30 = wp::add(var_31, var_16);
    var_32 = wp::tuple(var_13);
    var_33 = wp::array_t<wp::float32>(var_30, var_34);
    // freedom = wp.array(ptr=lobes.degrees + at, shape=(channels,), dtype=wp.float32)        <L 33>
    var_35 = &((var_lobes).degrees);
    var_37 = wp::load(var_35);
    var_36 = wp::add(var_37, var_16);
    var_38 = wp::tuple(var_13);
    var_39 = wp::array_t<wp::float32>(var_36, var_40);
    // for c in range(channels):                                                              <L 34>
    // value[c] = wp.float32(total[c] / rays)                                                 <L 35>
    var_42 = wp::extract(var_total, var_41);
    var_43 = wp::div(var_42, var_10);
    var_44 = wp::float32(var_43);
    wp::array_store(var_21, var_41, var_44);
    // error[c] = wp.float32(wp.sqrt(variance[c]) / rays)                                     <L 36>
    var_45 = wp::extract(var_variance, var_41);
    var_46 = wp::sqrt(var_45);
    var_47 = wp::div(var_46, var_10);
    var_48 = wp::float32(var_47);
    wp::array_store(var_27, var_41, var_48);
    // spreads[c] = wp.float32(wp.sqrt(width[c]) / rays)                                      <L 37>
    var_49 = wp::extract(var_width, var_41);
    var_50 = wp::sqrt(var_49);
    var_51 = wp::div(var_50, var_10);
    var_52 = wp::float32(var_51);
    wp::array_store(var_33, var_41, var_52);
    // freedom[c] = wp.float32(degrees[c])                                                    <L 38>
    var_53 = wp::extract(var_degrees, var_41);
    var_54 = wp::float32(var_53);
    wp::array_store(var_39, var_41, var_54);
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
static void set_byte_0(
    wp::uint64 var_address,
    wp::int64 var_i,
    wp::int32 var_x)
{
    //---------
    // primal vars
    wp::uint64 var_0;
    wp::uint64 var_1;
    const wp::int32 var_2 = 1;
    wp::tuple_t<wp::int32> var_3;
    wp::array_t<wp::uint8> var_4;
    const wp::int32 var_5 = 1;
    wp::uint8 var_6;
    const wp::int32 var_7 = 0;
    //---------
    // forward
    // def set_byte(address: wp.uint64, i: Any, x: wp.int32):                                 <L 1>
    // view = wp.array(ptr=address + wp.uint64(i), shape=(1,), dtype=wp.uint8)                <L 3>
    var_0 = wp::uint64(var_i);
    var_1 = wp::add(var_address, var_0);
    var_3 = wp::tuple(var_2);
    var_4 = wp::array_t<wp::uint8>(var_1, var_5);
    // view[0] = wp.uint8(x)                                                                  <L 4>
    var_6 = wp::uint8(var_x);
    wp::array_store(var_4, var_7, var_6);
}


// /work/main/warpsample/estimate/kernel.py:49
static void _estimator__locals__estimate_point_0(
    Lobes_4a4eb700 var_lobes,
    Accelerator_9fc73cd7 var_accelerator,
    Weights_23742fab var_data,
    wp::int64 var_visit,
    ShadingPoint_241c3e67 var_workspace)
{
    //---------
    // primal vars
    Placement_e6d83c4e* var_0;
    wp::uint64* var_1;
    wp::uint64* var_2;
    ShadingPoint_241c3e67 var_3;
    Placement_e6d83c4e var_4;
    wp::uint64 var_5;
    wp::uint64 var_6;
    wp::uint64* var_7;
    Placement_e6d83c4e* var_8;
    wp::uint64* var_9;
    wp::int64* var_10;
    wp::uint64 var_11;
    Placement_e6d83c4e var_12;
    wp::uint64 var_13;
    wp::int64 var_14;
    wp::vec_t<4, wp::uint32> var_15;
    wp::uint64 var_16;
    const bool var_17 = true;
    Placement_e6d83c4e* var_18;
    const wp::int32 var_19 = 1;
    ShadingPoint_241c3e67 var_20;
    Placement_e6d83c4e var_21;
    const bool var_22 = false;
    const wp::vec_t<3, wp::float64> var_23 = wp::initializer_array<3,wp::float64>{0.0, 0.0, 0.0};
    wp::vec_t<3, wp::float64> var_24;
    wp::vec_t<3, wp::float64> var_25;
    wp::vec_t<3, wp::float64> var_26;
    wp::vec_t<3, wp::float64> var_27;
    const wp::int32 var_28 = 0;
    wp::int32 var_29;
    const wp::int32 var_30 = 0;
    wp::int32 var_31;
    wp::int32* var_32;
    const wp::int32 var_33 = 0;
    bool var_34;
    wp::int32 var_35;
    wp::vec_t<3, wp::float64> var_36;
    wp::vec_t<3, wp::float64> var_37;
    wp::vec_t<3, wp::float64> var_38;
    wp::vec_t<3, wp::float64> var_39;
    wp::int32 var_40;
    wp::int32 var_41;
    wp::vec_t<3, wp::float64> var_42;
    wp::vec_t<3, wp::float64> var_43;
    wp::float64 var_44;
    const wp::float64 var_45 = 0.0;
    bool var_46;
    const wp::int32 var_47 = 5;
    wp::vec_t<3, wp::float64> var_48;
    wp::vec_t<3, wp::float64> var_49;
    wp::vec_t<3, wp::float64> var_50;
    wp::vec_t<3, wp::float64> var_51;
    wp::vec_t<3, wp::float64> var_52;
    wp::vec_t<3, wp::float64> var_53;
    wp::vec_t<3, wp::float64> var_54;
    wp::vec_t<3, wp::float64> var_55;
    wp::vec_t<3, wp::float64> var_56;
    wp::vec_t<3, wp::float64> var_57;
    wp::vec_t<3, wp::float64> var_58;
    wp::vec_t<3, wp::float64> var_59;
    wp::int32 var_60;
    wp::int32 var_61;
    wp::int64* var_62;
    wp::int64 var_63;
    wp::uint64* var_64;
    wp::int64* var_65;
    wp::uint64 var_66;
    wp::int64 var_67;
    wp::uint64* var_68;
    wp::int64* var_69;
    wp::uint64 var_70;
    wp::int64 var_71;
    wp::uint64* var_72;
    wp::int64* var_73;
    wp::int32* var_74;
    wp::uint64 var_75;
    wp::int64 var_76;
    wp::int32 var_77;
    //---------
    // forward
    // def estimate_point(lobes: Lobes, accelerator: Accelerator, data: struct, visit: wp.int64, workspace: ShadingPoint):       <L 50>
    // point = orient_point(workspace, lobes.placement, lobes.normals, lobes.active, visit)       <L 52>
    var_0 = &((var_lobes).placement);
    var_1 = &((var_lobes).normals);
    var_2 = &((var_lobes).active);
    var_4 = wp::load(var_0);
    var_5 = wp::load(var_1);
    var_6 = wp::load(var_2);
    var_3 = orient_point_0(var_workspace, var_4, var_5, var_6, var_visit);
    // point.key = point_key(lobes.seed, id_of(lobes.placement, lobes.first_point, point.index))       <L 53>
    var_7 = &((var_lobes).seed);
    var_8 = &((var_lobes).placement);
    var_9 = &((var_lobes).first_point);
    var_10 = &((var_3).index);
    var_12 = wp::load(var_8);
    var_13 = wp::load(var_9);
    var_14 = wp::load(var_10);
    var_11 = id_of_0(var_12, var_13, var_14);
    var_16 = wp::load(var_7);
    var_15 = point_key_0(var_16, var_11);
    var_3.key = var_15;
    // if wp.static(traced):                                                                  <L 54>
    // point = place_point(point, lobes.placement, 1)                                         <L 55>
    var_18 = &((var_lobes).placement);
    var_21 = wp::load(var_18);
    var_20 = place_point_0(var_3, var_21, var_19);
    // if wp.static(not upward):                                                              <L 56>
    // total = NOTHING                                                                        <L 58>
    var_24 = wp::copy(var_23);
    // variance = NOTHING                                                                     <L 59>
    var_25 = wp::copy(var_23);
    // width = NOTHING                                                                        <L 60>
    var_26 = wp::copy(var_23);
    // degrees = NOTHING                                                                      <L 61>
    var_27 = wp::copy(var_23);
    // cast = wp.int32(0)                                                                     <L 62>
    var_29 = wp::int32(var_28);
    // empty = wp.int32(0)                                                                    <L 63>
    var_31 = wp::int32(var_30);
    // if point.status == 0:                                                                  <L 64>
    var_32 = &((var_20).status);
    var_35 = wp::load(var_32);
    var_34 = (var_35 == var_33);
    if (var_34) {
        // total, variance, width, degrees, cast, empty = sum_lobe(lobes, accelerator, data, point)       <L 65>
        traced_lobe__locals__sum_lobe_0(var_lobes, var_accelerator, var_data, var_20, var_36, var_37, var_38, var_39, var_40, var_41);
        // if wp.dot(total - total, total - total) != ZERO:                                   <L 66>
        var_42 = wp::sub(var_36, var_36);
        var_43 = wp::sub(var_36, var_36);
        var_44 = wp::dot(var_42, var_43);
        var_46 = (var_44 != var_45);
        if (var_46) {
            // point.status = NONFINITE_VALUE                                                 <L 67>
            var_20.status = var_47;
            // total = NOTHING                                                                <L 68>
            var_48 = wp::copy(var_23);
            // variance = NOTHING                                                             <L 69>
            var_49 = wp::copy(var_23);
            // width = NOTHING                                                                <L 70>
            var_50 = wp::copy(var_23);
            // degrees = NOTHING                                                              <L 71>
            var_51 = wp::copy(var_23);
        }
        var_52 = wp::where(var_46, var_48, var_36);
        var_53 = wp::where(var_46, var_49, var_37);
        var_54 = wp::where(var_46, var_50, var_38);
        var_55 = wp::where(var_46, var_51, var_39);
    }
    var_56 = wp::where(var_34, var_52, var_24);
    var_57 = wp::where(var_34, var_53, var_25);
    var_58 = wp::where(var_34, var_54, var_26);
    var_59 = wp::where(var_34, var_55, var_27);
    var_60 = wp::where(var_34, var_40, var_29);
    var_61 = wp::where(var_34, var_41, var_31);
    // keep(lobes, point.index, total, variance, width, degrees)                              <L 72>
    var_62 = &((var_20).index);
    var_63 = wp::load(var_62);
    _keep__locals__keep_0(var_lobes, var_63, var_56, var_57, var_58, var_59);
    // set_int(lobes.cast, point.index, cast)                                                 <L 73>
    var_64 = &((var_lobes).cast);
    var_65 = &((var_20).index);
    var_66 = wp::load(var_64);
    var_67 = wp::load(var_65);
    _writer__locals__write_1(var_66, var_67, var_60);
    // set_int(lobes.empty, point.index, empty)                                               <L 74>
    var_68 = &((var_lobes).empty);
    var_69 = &((var_20).index);
    var_70 = wp::load(var_68);
    var_71 = wp::load(var_69);
    _writer__locals__write_1(var_70, var_71, var_61);
    // set_byte(lobes.status, point.index, point.status)                                      <L 75>
    var_72 = &((var_lobes).status);
    var_73 = &((var_20).index);
    var_74 = &((var_20).status);
    var_75 = wp::load(var_72);
    var_76 = wp::load(var_73);
    var_77 = wp::load(var_74);
    set_byte_0(var_75, var_76, var_77);
}


// /work/main/warpsample/maths/numerics.py:120
static void adj_root_0(
    wp::float32 var_x,
    wp::float32 & adj_x,
    wp::float32 & var_adj_ret)
{
	// user-defined adjoint code
    //---------
    // primal vars
    const wp::float32 var_0 = 0.0;
    bool var_1;
    const wp::float32 var_2 = 0.5;
    wp::float32 var_3;
    wp::float32 var_4;
    wp::float32 var_5;
    wp::float32 var_6;
    //---------
    // forward
    // def _adj_root(x: wp.float32, adj_ret: wp.float32):                                     <L 121>
    // if x > 0.0:                                                                            <L 122>
    var_1 = (var_x > var_0);
    if (var_1) {
        // wp.adjoint[x] += 0.5 * adj_ret / wp.sqrt(x)                                        <L 123>
        var_3 = wp::mul(var_2, var_adj_ret);
        var_4 = wp::sqrt(var_x);
        var_5 = wp::div(var_3, var_4);
        var_6 = wp::add(adj_x, var_5);
        adj_x = var_6;
    }
}


// /work/main/warpsample/tracing/sight/point.py:100
static void adj_point_in_0(
    wp::uint64 var_workspace,
    wp::int32 var_own,
    wp::int32 var_chunk,
    wp::uint64 & adj_workspace,
    wp::int32 & adj_own,
    wp::int32 & adj_chunk,
    ShadingPoint_241c3e67 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
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
static void adj__reader__locals__read_5(
    wp::uint64 var_address,
    wp::int64 var_i,
    wp::uint64 & adj_address,
    wp::int64 & adj_i,
    wp::vec_t<3, wp::float32> & adj_ret)
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


// /work/main/warpsample/maths/memory.py:0
static void adj__reader__locals__read_4(
    wp::uint64 var_address,
    wp::int64 var_i,
    wp::uint64 & adj_address,
    wp::int64 & adj_i,
    wp::uint8 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/directions/samples.py:21
static void adj_normal_status_0(
    wp::vec_t<3, wp::float32> var_n,
    wp::float32 var_weight,
    wp::vec_t<3, wp::float32> & adj_n,
    wp::float32 & adj_weight,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/point.py:117
static void adj_orient_point_0(
    ShadingPoint_241c3e67 var_point,
    Placement_e6d83c4e var_placement,
    wp::uint64 var_normals,
    wp::uint64 var_active,
    wp::int64 var_visit,
    ShadingPoint_241c3e67 & adj_point,
    Placement_e6d83c4e & adj_placement,
    wp::uint64 & adj_normals,
    wp::uint64 & adj_active,
    wp::int64 & adj_visit,
    ShadingPoint_241c3e67 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/maths/memory.py:0
static void adj__reader__locals__read_3(
    wp::uint64 var_address,
    wp::int64 var_i,
    wp::uint64 & adj_address,
    wp::int64 & adj_i,
    wp::uint64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/placement.py:123
static void adj_id_of_0(
    Placement_e6d83c4e var_placement,
    wp::uint64 var_first,
    wp::int64 var_point,
    Placement_e6d83c4e & adj_placement,
    wp::uint64 & adj_first,
    wp::int64 & adj_point,
    wp::uint64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/maths/numerics.py:70
static void adj_high_word_0(
    wp::uint64 var_x,
    wp::uint64 & adj_x,
    wp::uint32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/maths/numerics.py:64
static void adj_low_word_0(
    wp::uint64 var_x,
    wp::uint64 & adj_x,
    wp::uint32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/sequences/hashing.py:43
static void adj_philox4x32_10_0(
    wp::vec_t<4, wp::uint32> var_counter,
    wp::uint32 var_key_0,
    wp::uint32 var_key_1,
    wp::vec_t<4, wp::uint32> & adj_counter,
    wp::uint32 & adj_key_0,
    wp::uint32 & adj_key_1,
    wp::vec_t<4, wp::uint32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/sequences/hashing.py:99
static void adj_run_key_0(
    wp::uint64 var_seed,
    wp::uint32 var_high,
    wp::uint64 & adj_seed,
    wp::uint32 & adj_high,
    wp::vec_t<4, wp::uint32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/sequences/hashing.py:91
static void adj_finalise_0(
    wp::uint32 var_word,
    wp::uint32 & adj_word,
    wp::uint32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/sequences/hashing.py:117
static void adj_swap_halves_0(
    wp::uint32 var_word,
    wp::uint32 & adj_word,
    wp::uint32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/sequences/hashing.py:123
static void adj_premixed_key_0(
    wp::vec_t<4, wp::uint32> var_run,
    wp::uint32 var_low,
    wp::vec_t<4, wp::uint32> & adj_run,
    wp::uint32 & adj_low,
    wp::vec_t<4, wp::uint32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/sequences/hashing.py:65
static void adj_pcg4d_0(
    wp::uint32 var_x,
    wp::uint32 var_y,
    wp::uint32 var_z,
    wp::uint32 var_w,
    wp::uint32 & adj_x,
    wp::uint32 & adj_y,
    wp::uint32 & adj_z,
    wp::uint32 & adj_w,
    wp::vec_t<4, wp::uint32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/sequences/hashing.py:133
static void adj_mixed_key_0(
    wp::vec_t<4, wp::uint32> var_run,
    wp::uint32 var_low,
    wp::vec_t<4, wp::uint32> & adj_run,
    wp::uint32 & adj_low,
    wp::vec_t<4, wp::uint32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/sequences/hashing.py:140
static void adj_point_key_0(
    wp::uint64 var_seed,
    wp::uint64 var_point,
    wp::uint64 & adj_seed,
    wp::uint64 & adj_point,
    wp::vec_t<4, wp::uint32> & adj_ret)
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


// /work/main/warpsample/tracing/sight/point.py:136
static void adj__origin_0(
    Placement_e6d83c4e var_placement,
    ShadingPoint_241c3e67 var_point,
    wp::int32 var_sides,
    Placement_e6d83c4e & adj_placement,
    ShadingPoint_241c3e67 & adj_point,
    wp::int32 & adj_sides,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/placement.py:149
static void adj_reach_along_0(
    Placement_e6d83c4e var_placement,
    wp::vec_t<3, wp::float32> var_n,
    wp::vec_t<3, wp::float32> var_o,
    Placement_e6d83c4e & adj_placement,
    wp::vec_t<3, wp::float32> & adj_n,
    wp::vec_t<3, wp::float32> & adj_o,
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


// /work/main/warpsample/tracing/queries.py:86
static void adj_start_all_0(
    wp::uint64 var_chunk,
    wp::vec_t<3, wp::float32> var_o,
    wp::float32 var_reach,
    wp::uint64 & adj_chunk,
    wp::vec_t<3, wp::float32> & adj_o,
    wp::float32 & adj_reach)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/point.py:148
static void adj_place_point_0(
    ShadingPoint_241c3e67 var_point,
    Placement_e6d83c4e var_placement,
    wp::int32 var_sides,
    ShadingPoint_241c3e67 & adj_point,
    Placement_e6d83c4e & adj_placement,
    wp::int32 & adj_sides,
    ShadingPoint_241c3e67 & adj_ret)
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


// /work/main/warpsample/tracing/sight/leaves.py:20
static void adj_clear_leaf_0(
    wp::uint64 var_leaf,
    wp::uint64 & adj_leaf)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/frontier.py:45
static void adj_limit_of_boxes_0(
    wp::float32 var_limit,
    wp::vec_t<3, wp::float32> var_n,
    wp::float32 & adj_limit,
    wp::vec_t<3, wp::float32> & adj_n,
    wp::float32 & adj_ret)
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


// /work/main/warpsample/tracing/sight/frontier.py:39
static void adj__distance_to_interval_0(
    wp::float32 var_low,
    wp::float32 var_high,
    wp::float32 var_x,
    wp::float32 & adj_low,
    wp::float32 & adj_high,
    wp::float32 & adj_x,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/frontier.py:51
static void adj_visible_children_0(
    wp::uint64 var_node,
    wp::vec_t<3, wp::float32> var_o,
    wp::vec_t<3, wp::float32> var_n,
    wp::float32 var_limit,
    wp::float32 var_reach,
    wp::int32 & ret_0,
    wp::int32 & ret_1,
    wp::uint64 & adj_node,
    wp::vec_t<3, wp::float32> & adj_o,
    wp::vec_t<3, wp::float32> & adj_n,
    wp::float32 & adj_limit,
    wp::float32 & adj_reach,
    wp::int32 & adj_ret_0,
    wp::int32 & adj_ret_1)
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


// /work/main/warpsample/tracing/wide/layout.py:68
static void adj_highest_corner_0(
    wp::uint64 var_leaf,
    wp::int32 var_k,
    wp::float32 var_nx,
    wp::float32 var_ny,
    wp::float32 var_nz,
    wp::uint64 & adj_leaf,
    wp::int32 & adj_k,
    wp::float32 & adj_nx,
    wp::float32 & adj_ny,
    wp::float32 & adj_nz,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/frontier.py:77
static void adj_triangles_above_0(
    wp::uint64 var_leaf,
    wp::vec_t<3, wp::float32> var_n,
    wp::float32 var_limit,
    wp::uint64 & adj_leaf,
    wp::vec_t<3, wp::float32> & adj_n,
    wp::float32 & adj_limit,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/leaves.py:26
static void adj_raise_extent_0(
    wp::uint64 var_leaf,
    wp::float32 var_edge,
    wp::uint64 & adj_leaf,
    wp::float32 & adj_edge)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/leaves.py:32
static void adj_copy_triangle_0(
    wp::uint64 var_source,
    wp::int32 var_k,
    wp::uint64 var_leaf,
    wp::int32 var_lane,
    wp::uint64 & adj_source,
    wp::int32 & adj_k,
    wp::uint64 & adj_leaf,
    wp::int32 & adj_lane)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/frontier.py:102
static void adj__copy_to_local_leaf_0(
    wp::uint64 var_leaf,
    wp::vec_t<3, wp::float32> var_n,
    wp::float32 var_limit,
    wp::float32 var_edge,
    wp::uint64 var_local,
    wp::int32 var_triangles,
    wp::uint64 & adj_leaf,
    wp::vec_t<3, wp::float32> & adj_n,
    wp::float32 & adj_limit,
    wp::float32 & adj_edge,
    wp::uint64 & adj_local,
    wp::int32 & adj_triangles,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/frontier.py:88
static void adj__copy_child_0(
    wp::uint64 var_node,
    wp::int32 var_child,
    wp::uint64 var_nodes,
    wp::int32 var_entry,
    wp::uint64 & adj_node,
    wp::int32 & adj_child,
    wp::uint64 & adj_nodes,
    wp::int32 & adj_entry)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/frontier.py:123
static void adj__frontier_0(
    Accelerator_9fc73cd7 var_tree,
    ShadingPoint_241c3e67 var_point,
    wp::int32 & ret_0,
    wp::int32 & ret_1,
    Accelerator_9fc73cd7 & adj_tree,
    ShadingPoint_241c3e67 & adj_point,
    wp::int32 & adj_ret_0,
    wp::int32 & adj_ret_1)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/frontier.py:170
static void adj_open_around_0(
    Accelerator_9fc73cd7 var_tree,
    ShadingPoint_241c3e67 var_point,
    Accelerator_9fc73cd7 & ret_0,
    wp::int32 & ret_1,
    bool & ret_2,
    Accelerator_9fc73cd7 & adj_tree,
    ShadingPoint_241c3e67 & adj_point,
    Accelerator_9fc73cd7 & adj_ret_0,
    wp::int32 & adj_ret_1,
    bool & adj_ret_2)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/maths/frames.py:8
static void adj_frame_about_0(
    wp::vec_t<3, wp::float32> var_n,
    wp::vec_t<3, wp::float32> & adj_n,
    wp::mat_t<3, 3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/maths/frames.py:27
static void adj_to_world_0(
    wp::mat_t<3, 3, wp::float32> var_frame,
    wp::vec_t<3, wp::float32> var_w,
    wp::mat_t<3, 3, wp::float32> & adj_frame,
    wp::vec_t<3, wp::float32> & adj_w,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/shafts.py:61
static void adj__complete_shaft_0(
    ShadingPoint_241c3e67 var_point,
    ShadingPoint_241c3e67 & adj_point)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/shafts.py:80
static void adj_aim_about_0(
    wp::uint64 var_vectors,
    ShadingPoint_241c3e67 var_point,
    wp::uint64 & adj_vectors,
    ShadingPoint_241c3e67 & adj_point)
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


// /work/main/warpsample/tracing/sight/shafts.py:127
static void adj__plane_0(
    wp::uint64 var_shaft,
    wp::int32 var_i,
    wp::uint64 & adj_shaft,
    wp::int32 & adj_i,
    Plane_dba16a08 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/wide/layout.py:84
static void adj_corner_0(
    wp::uint64 var_leaf,
    wp::int32 var_first_row,
    wp::int32 var_k,
    wp::vec_t<3, wp::float32> var_o,
    wp::uint64 & adj_leaf,
    wp::int32 & adj_first_row,
    wp::int32 & adj_k,
    wp::vec_t<3, wp::float32> & adj_o,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/wide/layout.py:78
static void adj_size_of_0(
    wp::vec_t<3, wp::float32> var_v,
    wp::vec_t<3, wp::float32> & adj_v,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/shafts.py:151
static void adj__is_triangle_inside_0(
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::vec_t<3, wp::float32> var_c,
    Plane_dba16a08 var_plane,
    wp::float32 var_margin,
    wp::vec_t<3, wp::float32> & adj_a,
    wp::vec_t<3, wp::float32> & adj_b,
    wp::vec_t<3, wp::float32> & adj_c,
    Plane_dba16a08 & adj_plane,
    wp::float32 & adj_margin,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/shafts.py:54
static void adj_corner_of_0(
    wp::uint64 var_vectors,
    wp::int32 var_i,
    wp::uint64 & adj_vectors,
    wp::int32 & adj_i,
    wp::vec_t<3, wp::float32> & adj_ret)
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


// /work/main/warpsample/tracing/sight/shafts.py:158
static void adj__is_facing_0(
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::vec_t<3, wp::float32> var_c,
    wp::uint64 var_shaft,
    wp::vec_t<3, wp::float32> & adj_a,
    wp::vec_t<3, wp::float32> & adj_b,
    wp::vec_t<3, wp::float32> & adj_c,
    wp::uint64 & adj_shaft,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/shafts.py:200
static void adj_triangles_in_0(
    wp::uint64 var_leaf,
    wp::uint64 var_shaft,
    wp::uint64 & adj_leaf,
    wp::uint64 & adj_shaft,
    wp::int32 & adj_ret)
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


// /work/main/warpsample/tracing/sight/shafts.py:142
static void adj__is_box_inside_0(
    wp::uint64 var_node,
    Plane_dba16a08 var_plane,
    wp::int32 var_k,
    wp::uint64 & adj_node,
    Plane_dba16a08 & adj_plane,
    wp::int32 & adj_k,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/shafts.py:181
static void adj_boxes_in_0(
    wp::uint64 var_node,
    wp::uint64 var_shaft,
    wp::uint64 & adj_node,
    wp::uint64 & adj_shaft,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/search.py:33
static void adj__look_1(
    wp::uint64 var_leaf,
    wp::uint64 var_shaft,
    InShaft_29ffc368 var_found,
    InShaft_29ffc368 & ret_0,
    bool & ret_1,
    wp::uint64 & adj_leaf,
    wp::uint64 & adj_shaft,
    InShaft_29ffc368 & adj_found,
    InShaft_29ffc368 & adj_ret_0,
    bool & adj_ret_1)
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


// /work/main/warpsample/tracing/wide/walk.py:42
static void adj_tree_walk__locals__walk_2(
    Accelerator_9fc73cd7 var_tree,
    wp::uint64 var_query,
    InShaft_29ffc368 var_answer,
    wp::int32 var_visits,
    wp::uint64 var_scratch,
    InShaft_29ffc368 & ret_0,
    bool & ret_1,
    Accelerator_9fc73cd7 & adj_tree,
    wp::uint64 & adj_query,
    InShaft_29ffc368 & adj_answer,
    wp::int32 & adj_visits,
    wp::uint64 & adj_scratch,
    InShaft_29ffc368 & adj_ret_0,
    bool & adj_ret_1)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/search.py:44
static void adj_search_shaft_0(
    Accelerator_9fc73cd7 var_tree,
    ShadingPoint_241c3e67 var_point,
    wp::int32 var_local,
    Accelerator_9fc73cd7 & adj_tree,
    ShadingPoint_241c3e67 & adj_point,
    wp::int32 & adj_local,
    InShaft_29ffc368 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/search.py:61
static void adj_in_local_leaf_0(
    InShaft_29ffc368 var_found,
    ShadingPoint_241c3e67 var_point,
    InShaft_29ffc368 & adj_found,
    ShadingPoint_241c3e67 & adj_point,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/estimate/lobes.py:81
static void adj_finder_of__locals__find_0(
    Lobes_4a4eb700 var_lobes,
    Accelerator_9fc73cd7 var_tree,
    ShadingPoint_241c3e67 var_point,
    wp::int32 var_i,
    wp::int32 var_local,
    wp::int32 & ret_0,
    wp::int32 & ret_1,
    Lobes_4a4eb700 & adj_lobes,
    Accelerator_9fc73cd7 & adj_tree,
    ShadingPoint_241c3e67 & adj_point,
    wp::int32 & adj_i,
    wp::int32 & adj_local,
    wp::int32 & adj_ret_0,
    wp::int32 & adj_ret_1)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/estimate/lobes.py:67
static void adj_lobe_of_0(
    Lobes_4a4eb700 var_lobes,
    ShadingPoint_241c3e67 var_point,
    Lobes_4a4eb700 & adj_lobes,
    ShadingPoint_241c3e67 & adj_point,
    Lobe_95707b65 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/rays.py:19
static void adj_whole_vectors_0(
    wp::int32 var_length,
    wp::int32 & adj_length,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/sequences/hashing.py:146
static void adj_stream_key_0(
    wp::vec_t<4, wp::uint32> var_key,
    wp::uint32 var_stream,
    wp::vec_t<4, wp::uint32> & adj_key,
    wp::uint32 & adj_stream,
    wp::vec_t<4, wp::uint32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/sequences/hashing.py:152
static void adj_select_key_0(
    wp::vec_t<4, wp::uint32> var_first,
    wp::vec_t<4, wp::uint32> var_second,
    wp::int32 var_which,
    wp::vec_t<4, wp::uint32> & adj_first,
    wp::vec_t<4, wp::uint32> & adj_second,
    wp::int32 & adj_which,
    wp::vec_t<4, wp::uint32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/maths/numerics.py:104
static void adj_weyl_0(
    wp::uint32 var_index,
    wp::uint64 var_step,
    wp::uint32 & adj_index,
    wp::uint64 & adj_step,
    wp::uint32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/maths/numerics.py:76
static void adj_uniform_from_bits_0(
    wp::uint32 var_bits,
    wp::uint32 & adj_bits,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/sequences/fibonacci.py:15
static void adj_fibonacci_sample_0(
    wp::vec_t<4, wp::uint32> var_key,
    wp::uint32 var_sample,
    wp::uint32 var_count,
    wp::vec_t<4, wp::uint32> & adj_key,
    wp::uint32 & adj_sample,
    wp::uint32 & adj_count,
    wp::vec_t<2, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/maths/numerics.py:138
static void adj_sincos_eighth_0(
    wp::float32 var_x,
    wp::float32 & adj_x,
    wp::vec_t<2, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/maths/numerics.py:148
static void adj_sincos_turns_0(
    wp::float32 var_u,
    wp::float32 & adj_u,
    wp::vec_t<2, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/distributions/cosine_hemisphere.py:27
static void adj_square_to_cosine_hemisphere_0(
    wp::vec_t<2, wp::float32> var_u,
    wp::vec_t<2, wp::float32> & adj_u,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/distributions/parameters.py:43
static void adj_bind_parameters__locals__call_0(
    wp::vec_t<2, wp::float32> var_x,
    Parameters_f3aa772c var_parameters,
    wp::vec_t<2, wp::float32> & adj_x,
    Parameters_f3aa772c & adj_parameters,
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


// /work/main/warpsample/distributions/parameters.py:69
static void adj_build_about__locals__about_0(
    wp::vec_t<3, wp::float32> var_n,
    wp::vec_t<2, wp::float32> var_u,
    Parameters_f3aa772c var_parameters,
    wp::vec_t<3, wp::float32> & adj_n,
    wp::vec_t<2, wp::float32> & adj_u,
    Parameters_f3aa772c & adj_parameters,
    wp::vec_t<4, wp::float32> & adj_ret)
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


// /work/main/warpsample/estimate/rays.py:59
static void adj_directions_of__locals__write_directions_0(
    Lobes_4a4eb700 var_lobes,
    ShadingPoint_241c3e67 var_point,
    wp::int32 var_length,
    Lobes_4a4eb700 & adj_lobes,
    ShadingPoint_241c3e67 & adj_point,
    wp::int32 & adj_length)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/estimate/rays.py:24
static void adj_spread_of__locals__spread_0(
    Lobes_4a4eb700 var_lobes,
    ShadingPoint_241c3e67 var_point,
    wp::int32 var_stratum,
    wp::int32 var_first,
    wp::int32 var_length,
    Lobes_4a4eb700 & adj_lobes,
    ShadingPoint_241c3e67 & adj_point,
    wp::int32 & adj_stratum,
    wp::int32 & adj_first,
    wp::int32 & adj_length)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/packets.py:32
static void adj_first_rays_0(
    wp::int32 var_length,
    wp::int32 & adj_length,
    wp::uint64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/estimate/stratum.py:107
static void adj_weighing__locals__weigh_rays_0(
    Lobe_95707b65 var_lobe,
    Weights_23742fab var_data,
    ShadingPoint_241c3e67 var_point,
    wp::int32 var_length,
    Lobe_95707b65 & adj_lobe,
    Weights_23742fab & adj_data,
    ShadingPoint_241c3e67 & adj_point,
    wp::int32 & adj_length,
    wp::uint64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/queries.py:50
static void adj_column_of_0(
    wp::uint64 var_chunk,
    wp::int32 var_k,
    wp::uint64 & adj_chunk,
    wp::int32 & adj_k,
    wp::uint64 & adj_ret)
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


// /work/main/warpsample/tracing/queries.py:62
static void adj_direction_of_0(
    wp::uint64 var_chunk,
    wp::int32 var_k,
    wp::uint64 & adj_chunk,
    wp::int32 & adj_k,
    wp::vec_t<3, wp::float32> & adj_ret)
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


// /work/main/warpsample/tracing/sight/point.py:164
static void adj_move_ray_near_0(
    ShadingPoint_241c3e67 var_point,
    wp::int32 var_k,
    wp::vec_t<3, wp::float64> var_d,
    ShadingPoint_241c3e67 & adj_point,
    wp::int32 & adj_k,
    wp::vec_t<3, wp::float64> & adj_d)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/rays.py:25
static void adj_move_rays_near_0(
    ShadingPoint_241c3e67 var_point,
    wp::int32 var_length,
    ShadingPoint_241c3e67 & adj_point,
    wp::int32 & adj_length)
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


// /work/main/warpsample/tracing/sight/rays.py:37
static void adj_prepare_rays__locals__prepare_chunk_0(
    Accelerator_9fc73cd7 var_tree,
    ShadingPoint_241c3e67 var_point,
    wp::int32 var_local,
    wp::int32 var_length,
    Accelerator_9fc73cd7 & adj_tree,
    ShadingPoint_241c3e67 & adj_point,
    wp::int32 & adj_local,
    wp::int32 & adj_length)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/packets.py:38
static void adj_set_size_0(
    wp::uint64 var_rays,
    wp::uint64 & adj_rays,
    wp::int32 & adj_ret)
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


// /work/main/warpsample/tracing/sight/sides.py:30
static void adj__cross_0(
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::vec_t<3, wp::float32> & adj_a,
    wp::vec_t<3, wp::float32> & adj_b,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/sides.py:40
static void adj_open_leaf_0(
    wp::uint64 var_leaf,
    wp::vec_t<3, wp::float32> var_o,
    wp::float32 var_reach,
    wp::uint64 var_sides,
    wp::uint64 & adj_leaf,
    wp::vec_t<3, wp::float32> & adj_o,
    wp::float32 & adj_reach,
    wp::uint64 & adj_sides)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/sides.py:95
static void adj__classify_ray_0(
    wp::vec_t<3, wp::float32> var_d,
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> var_q,
    wp::vec_t<3, wp::float32> var_r,
    wp::float32 var_sure,
    wp::float32 var_outside,
    wp::float32 var_behind,
    wp::vec_t<3, wp::float32> & adj_d,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<3, wp::float32> & adj_q,
    wp::vec_t<3, wp::float32> & adj_r,
    wp::float32 & adj_sure,
    wp::float32 & adj_outside,
    wp::float32 & adj_behind,
    wp::int32 & adj_ret)
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


// /work/main/warpsample/tracing/sight/sides.py:124
static void adj_rays_passing_0(
    wp::uint64 var_sides,
    wp::int32 var_t,
    wp::uint64 var_column,
    wp::uint64 & adj_sides,
    wp::int32 & adj_t,
    wp::uint64 & adj_column,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/packets.py:50
static void adj_lowest_ray_0(
    wp::uint64 var_rays,
    wp::uint64 & adj_rays,
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


// /work/main/warpsample/tracing/sight/packets.py:56
static void adj__is_hit_0(
    wp::uint64 var_leaf,
    wp::int32 var_triangles,
    wp::uint64 var_column,
    wp::float32 var_reach,
    wp::uint64 & adj_leaf,
    wp::int32 & adj_triangles,
    wp::uint64 & adj_column,
    wp::float32 & adj_reach,
    bool & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/packets.py:44
static void adj_ray_set_0(
    wp::int32 var_k,
    wp::int32 & adj_k,
    wp::uint64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/packets.py:69
static void adj__unblocked_by_triangles_0(
    wp::uint64 var_leaf,
    wp::int32 var_triangles,
    ShadingPoint_241c3e67 var_point,
    wp::uint64 var_alive,
    wp::int32 var_blocks,
    wp::uint64 & adj_leaf,
    wp::int32 & adj_triangles,
    ShadingPoint_241c3e67 & adj_point,
    wp::uint64 & adj_alive,
    wp::int32 & adj_blocks,
    wp::uint64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/packets.py:154
static void adj__push_0(
    wp::uint64 var_top,
    wp::uint64 var_node,
    wp::uint64 var_rays,
    wp::uint64 & adj_top,
    wp::uint64 & adj_node,
    wp::uint64 & adj_rays,
    wp::uint64 & adj_ret)
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


// /work/main/warpsample/tracing/sight/packets.py:115
static void adj__children_hit_0(
    wp::uint64 var_node,
    ShadingPoint_241c3e67 var_point,
    wp::uint64 var_rays,
    wp::uint64 & adj_node,
    ShadingPoint_241c3e67 & adj_point,
    wp::uint64 & adj_rays,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/packets.py:147
static void adj__rays_at_child_0(
    ShadingPoint_241c3e67 var_point,
    wp::int32 var_child,
    ShadingPoint_241c3e67 & adj_point,
    wp::int32 & adj_child,
    wp::uint64 & adj_ret)
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


// /work/main/warpsample/tracing/wide/query.py:41
static void adj_any_triangle_0(
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


// /work/main/warpsample/tracing/sight/sides.py:109
static void adj_triangles_passed_0(
    wp::uint64 var_sides,
    wp::vec_t<3, wp::float32> var_d,
    wp::uint64 & adj_sides,
    wp::vec_t<3, wp::float32> & adj_d,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/packets.py:92
static void adj__unblocked_by_leaf_0(
    wp::uint64 var_leaf,
    wp::float32 var_edge,
    ShadingPoint_241c3e67 var_point,
    wp::uint64 var_rays,
    wp::uint64 var_alive,
    wp::uint64 & adj_leaf,
    wp::float32 & adj_edge,
    ShadingPoint_241c3e67 & adj_point,
    wp::uint64 & adj_rays,
    wp::uint64 & adj_alive,
    wp::uint64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/packets.py:162
static void adj__unblocked_by_tree_0(
    Accelerator_9fc73cd7 var_tree,
    ShadingPoint_241c3e67 var_point,
    wp::uint64 var_alive,
    Accelerator_9fc73cd7 & adj_tree,
    ShadingPoint_241c3e67 & adj_point,
    wp::uint64 & adj_alive,
    wp::uint64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/packets.py:185
static void adj_blocked_rays_0(
    Accelerator_9fc73cd7 var_tree,
    ShadingPoint_241c3e67 var_point,
    wp::int32 var_local,
    wp::uint64 var_rays,
    wp::int32 var_length,
    Accelerator_9fc73cd7 & adj_tree,
    ShadingPoint_241c3e67 & adj_point,
    wp::int32 & adj_local,
    wp::uint64 & adj_rays,
    wp::int32 & adj_length,
    wp::uint64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/estimate/stratum.py:132
static void adj_stratum_sum__locals__sum_stratum_0(
    Lobes_4a4eb700 var_lobes,
    Accelerator_9fc73cd7 var_tree,
    Weights_23742fab var_data,
    ShadingPoint_241c3e67 var_point,
    wp::int32 var_stratum,
    wp::int32 var_found,
    wp::int32 var_local,
    wp::vec_t<3, wp::float64> & ret_0,
    wp::vec_t<3, wp::float64> & ret_1,
    wp::int32 & ret_2,
    wp::int32 & ret_3,
    wp::vec_t<3, wp::float32> & ret_4,
    Lobes_4a4eb700 & adj_lobes,
    Accelerator_9fc73cd7 & adj_tree,
    Weights_23742fab & adj_data,
    ShadingPoint_241c3e67 & adj_point,
    wp::int32 & adj_stratum,
    wp::int32 & adj_found,
    wp::int32 & adj_local,
    wp::vec_t<3, wp::float64> & adj_ret_0,
    wp::vec_t<3, wp::float64> & adj_ret_1,
    wp::int32 & adj_ret_2,
    wp::int32 & adj_ret_3,
    wp::vec_t<3, wp::float32> & adj_ret_4)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/estimate/stratum.py:31
static void adj_jump_of__locals__jump_at_0(
    wp::vec_t<3, wp::float32> var_w,
    wp::vec_t<3, wp::float64> var_total,
    wp::int32 var_free,
    wp::int32 var_rays,
    wp::vec_t<3, wp::float32> & adj_w,
    wp::vec_t<3, wp::float64> & adj_total,
    wp::int32 & adj_free,
    wp::int32 & adj_rays,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/estimate/intervals.py:73
static void adj_edge_variance_0(
    wp::int32 var_free,
    wp::int32 var_rays,
    wp::float32 var_limit,
    wp::int32 & adj_free,
    wp::int32 & adj_rays,
    wp::float32 & adj_limit,
    wp::float64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/estimate/intervals.py:83
static void adj_posterior_0(
    wp::float64 var_variance,
    wp::float64 var_expected,
    wp::float64 var_unseen,
    wp::float64 var_rest,
    wp::float64 var_fourth,
    wp::int32 var_mixed,
    wp::int32 var_fewer,
    wp::int32 var_strata,
    Prior_2e82b100 var_prior,
    wp::float64 & ret_0,
    wp::float64 & ret_1,
    wp::float64 & adj_variance,
    wp::float64 & adj_expected,
    wp::float64 & adj_unseen,
    wp::float64 & adj_rest,
    wp::float64 & adj_fourth,
    wp::int32 & adj_mixed,
    wp::int32 & adj_fewer,
    wp::int32 & adj_strata,
    Prior_2e82b100 & adj_prior,
    wp::float64 & adj_ret_0,
    wp::float64 & adj_ret_1)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/estimate/lobe.py:25
static void adj_widths_of__locals__widths_of_0(
    wp::vec_t<3, wp::float64> var_variance,
    wp::vec_t<3, wp::float64> var_expected,
    wp::vec_t<3, wp::float64> var_unseen,
    wp::vec_t<3, wp::float64> var_rest,
    wp::vec_t<3, wp::float64> var_fourth,
    wp::int32 var_mixed,
    wp::int32 var_fewer,
    wp::int32 var_strata,
    wp::vec_t<3, wp::float64> & ret_0,
    wp::vec_t<3, wp::float64> & ret_1,
    wp::vec_t<3, wp::float64> & adj_variance,
    wp::vec_t<3, wp::float64> & adj_expected,
    wp::vec_t<3, wp::float64> & adj_unseen,
    wp::vec_t<3, wp::float64> & adj_rest,
    wp::vec_t<3, wp::float64> & adj_fourth,
    wp::int32 & adj_mixed,
    wp::int32 & adj_fewer,
    wp::int32 & adj_strata,
    wp::vec_t<3, wp::float64> & adj_ret_0,
    wp::vec_t<3, wp::float64> & adj_ret_1)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/estimate/lobe.py:57
static void adj_traced_lobe__locals__sum_lobe_0(
    Lobes_4a4eb700 var_lobes,
    Accelerator_9fc73cd7 var_accelerator,
    Weights_23742fab var_data,
    ShadingPoint_241c3e67 var_point,
    wp::vec_t<3, wp::float64> & ret_0,
    wp::vec_t<3, wp::float64> & ret_1,
    wp::vec_t<3, wp::float64> & ret_2,
    wp::vec_t<3, wp::float64> & ret_3,
    wp::int32 & ret_4,
    wp::int32 & ret_5,
    Lobes_4a4eb700 & adj_lobes,
    Accelerator_9fc73cd7 & adj_accelerator,
    Weights_23742fab & adj_data,
    ShadingPoint_241c3e67 & adj_point,
    wp::vec_t<3, wp::float64> & adj_ret_0,
    wp::vec_t<3, wp::float64> & adj_ret_1,
    wp::vec_t<3, wp::float64> & adj_ret_2,
    wp::vec_t<3, wp::float64> & adj_ret_3,
    wp::int32 & adj_ret_4,
    wp::int32 & adj_ret_5)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/estimate/kernel.py:25
static void adj__keep__locals__keep_0(
    Lobes_4a4eb700 var_lobes,
    wp::int64 var_point,
    wp::vec_t<3, wp::float64> var_total,
    wp::vec_t<3, wp::float64> var_variance,
    wp::vec_t<3, wp::float64> var_width,
    wp::vec_t<3, wp::float64> var_degrees,
    Lobes_4a4eb700 & adj_lobes,
    wp::int64 & adj_point,
    wp::vec_t<3, wp::float64> & adj_total,
    wp::vec_t<3, wp::float64> & adj_variance,
    wp::vec_t<3, wp::float64> & adj_width,
    wp::vec_t<3, wp::float64> & adj_degrees)
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
static void adj_set_byte_0(
    wp::uint64 var_address,
    wp::int64 var_i,
    wp::int32 var_x,
    wp::uint64 & adj_address,
    wp::int64 & adj_i,
    wp::int32 & adj_x)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/estimate/kernel.py:49
static void adj__estimator__locals__estimate_point_0(
    Lobes_4a4eb700 var_lobes,
    Accelerator_9fc73cd7 var_accelerator,
    Weights_23742fab var_data,
    wp::int64 var_visit,
    ShadingPoint_241c3e67 var_workspace,
    Lobes_4a4eb700 & adj_lobes,
    Accelerator_9fc73cd7 & adj_accelerator,
    Weights_23742fab & adj_data,
    wp::int64 & adj_visit,
    ShadingPoint_241c3e67 & adj_workspace)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}

struct wp_args_estimate_kernel__locals__estimate_bda69d1e {
    Lobes_4a4eb700 lobes;
    Accelerator_9fc73cd7 accelerator;
    Weights_23742fab data;
    wp::int64 first_task;
};


template <bool wp_linear_contiguous>
static void estimate_kernel__locals__estimate_bda69d1e_cpu_kernel_forward(
    wp::launch_bounds_t<1> dim,
    size_t task_index,
    wp_args_estimate_kernel__locals__estimate_bda69d1e *_wp_args)
{
    static constexpr bool wp_linear_tid = wp_linear_contiguous;

    //---------
    // argument vars
    Lobes_4a4eb700 var_lobes = _wp_args->lobes;
    Accelerator_9fc73cd7 var_accelerator = _wp_args->accelerator;
    Weights_23742fab var_data = _wp_args->data;
    wp::int64 var_first_task = _wp_args->first_task;
    //---------
    // primal vars
    const wp::int32 var_0 = 4384;
    wp::tuple_t<wp::int32> var_1;
    wp::fixedarray_t<4384, wp::float32> var_2;
    const wp::int32 var_3 = 4384;
    wp::uint64* var_4;
    const wp::int32 var_5 = 192;
    const wp::int32 var_6 = 1664;
    ShadingPoint_241c3e67 var_7;
    wp::uint64 var_8;
    wp::int32 var_9;
    wp::int64 var_10;
    wp::int64 var_11;
    wp::int32* var_12;
    wp::int64 var_13;
    wp::int32 var_14;
    wp::int64 var_15;
    wp::int32* var_16;
    wp::range_t var_17;
    wp::int32 var_18;
    wp::int32 var_19;
    wp::int64 var_20;
    wp::int64 var_21;
    wp::int64* var_22;
    bool var_23;
    wp::int64 var_24;
    wp::int64 var_25;
    wp::int64 var_26;
    //---------
    // forward
    // def estimate(lobes: Lobes, accelerator: Accelerator, data: struct, first_task: wp.int64):       <L 90>
    // memory = wp.zeros(shape=(floats,), dtype=wp.float32)                                   <L 91>
    var_1 = wp::tuple(var_0);
    var_2 = wp::fixedarray_t<4384, wp::float32>(var_3);
    // workspace = point_in(memory.ptr, own, chunk)                                           <L 92>
    var_4 = (wp::uint64*)&(var_2.data);
    var_8 = wp::load(var_4);
    var_7 = point_in_0(var_8, var_5, var_6);
    // first = (first_task + wp.int64(wp.tid())) * wp.int64(lobes.rows)                       <L 93>
    var_9 = builtin_tid1d();
    var_10 = wp::int64(var_9);
    var_11 = wp::add(var_first_task, var_10);
    var_12 = &((var_lobes).rows);
    var_14 = wp::load(var_12);
    var_13 = wp::int64(var_14);
    var_15 = wp::mul(var_11, var_13);
    // for k in range(lobes.rows):                                                            <L 94>
    var_16 = &((var_lobes).rows);
    var_18 = wp::load(var_16);
    var_17 = wp::range(var_18);
    start_for_0:;
        if (iter_cmp(var_17) == 0) goto end_for_0;
        var_19 = wp::iter_next(var_17);
        // if first + wp.int64(k) < lobes.visits:                                             <L 95>
        var_20 = wp::int64(var_19);
        var_21 = wp::add(var_15, var_20);
        var_22 = &((var_lobes).visits);
        var_24 = wp::load(var_22);
        var_23 = (var_21 < var_24);
        if (var_23) {
            // estimate_point(lobes, accelerator, data, first + wp.int64(k), workspace)       <L 96>
            var_25 = wp::int64(var_19);
            var_26 = wp::add(var_15, var_25);
            _estimator__locals__estimate_point_0(var_lobes, var_accelerator, var_data, var_26, var_7);
        }
        goto start_for_0;
    end_for_0:;
}



template <bool wp_linear_contiguous>
static WP_FORCEINLINE void estimate_kernel__locals__estimate_bda69d1e_cpu_forward_tasks(
    wp::launch_bounds_t<1> *dim,
    wp_args_estimate_kernel__locals__estimate_bda69d1e *_wp_args)
{
    for (size_t task_index = 0; task_index < dim->size; ++task_index)
    {
        estimate_kernel__locals__estimate_bda69d1e_cpu_kernel_forward<wp_linear_contiguous>(*dim, task_index, _wp_args);
    }
}

static WP_FORCEINLINE void estimate_kernel__locals__estimate_bda69d1e_cpu_forward_dispatch(
    wp::launch_bounds_t<1> *dim,
    wp_args_estimate_kernel__locals__estimate_bda69d1e *_wp_args)
{
    wp::tile_shared_storage_t tile_mem;
#if defined(WP_ENABLE_TILES_IN_STACK_MEMORY)
    wp::shared_tile_storage = &tile_mem;
#endif

    estimate_kernel__locals__estimate_bda69d1e_cpu_forward_tasks<false>(dim, _wp_args);
}

extern "C" {

// Python CPU entry points
WP_API void estimate_kernel__locals__estimate_bda69d1e_cpu_forward(
    wp::launch_bounds_t<1> *dim,
    wp_args_estimate_kernel__locals__estimate_bda69d1e *_wp_args)
{
    estimate_kernel__locals__estimate_bda69d1e_cpu_forward_dispatch(dim, _wp_args);
}

} // extern C

