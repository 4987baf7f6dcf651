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


struct Facet_ffcefc8d
{
    wp::vec_t<3, wp::float64> a;
    wp::vec_t<3, wp::float64> b;
    wp::vec_t<3, wp::float64> c;
    wp::vec_t<3, wp::float64> n;
    wp::float64 area;
    wp::float64 offset;
    wp::float64 slack;


    Facet_ffcefc8d() = default;
    CUDA_CALLABLE Facet_ffcefc8d(wp::vec_t<3, wp::float64> const& a,
    wp::vec_t<3, wp::float64> const& b = {},
    wp::vec_t<3, wp::float64> const& c = {},
    wp::vec_t<3, wp::float64> const& n = {},
    wp::float64 const& area = {},
    wp::float64 const& offset = {},
    wp::float64 const& slack = {})
        : a{a}
        , b{b}
        , c{c}
        , n{n}
        , area{area}
        , offset{offset}
        , slack{slack}

    {
    }

    CUDA_CALLABLE Facet_ffcefc8d& operator += (const Facet_ffcefc8d& rhs)
    {    a += rhs.a;
    b += rhs.b;
    c += rhs.c;
    n += rhs.n;
    area += rhs.area;
    offset += rhs.offset;
    slack += rhs.slack;

        return *this;}

};

static CUDA_CALLABLE void adj_Facet_ffcefc8d(wp::vec_t<3, wp::float64> const&,
    wp::vec_t<3, wp::float64> const&,
    wp::vec_t<3, wp::float64> const&,
    wp::vec_t<3, wp::float64> const&,
    wp::float64 const&,
    wp::float64 const&,
    wp::float64 const&,
    wp::vec_t<3, wp::float64> & adj_a,
    wp::vec_t<3, wp::float64> & adj_b,
    wp::vec_t<3, wp::float64> & adj_c,
    wp::vec_t<3, wp::float64> & adj_n,
    wp::float64 & adj_area,
    wp::float64 & adj_offset,
    wp::float64 & adj_slack,
    Facet_ffcefc8d & adj_ret)
{
    adj_a += adj_ret.a;
    adj_b += adj_ret.b;
    adj_c += adj_ret.c;
    adj_n += adj_ret.n;
    adj_area += adj_ret.area;
    adj_offset += adj_ret.offset;
    adj_slack += adj_ret.slack;
}

// Required when compiling adjoints.
CUDA_CALLABLE Facet_ffcefc8d add(const Facet_ffcefc8d& a, const Facet_ffcefc8d& b)
{
    return Facet_ffcefc8d();
}

CUDA_CALLABLE void adj_atomic_add(Facet_ffcefc8d* p, Facet_ffcefc8d t)
{
    wp::adj_atomic_add(&p->a, t.a);
    wp::adj_atomic_add(&p->b, t.b);
    wp::adj_atomic_add(&p->c, t.c);
    wp::adj_atomic_add(&p->n, t.n);
    wp::adj_atomic_add(&p->area, t.area);
    wp::adj_atomic_add(&p->offset, t.offset);
    wp::adj_atomic_add(&p->slack, t.slack);
}




struct FaceContact_ae9d5902
{
    wp::vec_t<3, wp::float64> p;
    wp::int32 own;
    Facet_ffcefc8d facet;
    wp::float64 side;
    bool alone;
    wp::vec_t<3, wp::float64> o;
    wp::float64 moved;
    wp::float64 inwards;
    wp::vec_t<3, wp::float64> aside;
    wp::int32 along;
    wp::float64 best_along;
    wp::int32 against;
    wp::float64 best_against;
    wp::float64 ahead;


    FaceContact_ae9d5902() = default;
    CUDA_CALLABLE FaceContact_ae9d5902(wp::vec_t<3, wp::float64> const& p,
    wp::int32 const& own = {},
    Facet_ffcefc8d const& facet = {},
    wp::float64 const& side = {},
    bool const& alone = {},
    wp::vec_t<3, wp::float64> const& o = {},
    wp::float64 const& moved = {},
    wp::float64 const& inwards = {},
    wp::vec_t<3, wp::float64> const& aside = {},
    wp::int32 const& along = {},
    wp::float64 const& best_along = {},
    wp::int32 const& against = {},
    wp::float64 const& best_against = {},
    wp::float64 const& ahead = {})
        : p{p}
        , own{own}
        , facet{facet}
        , side{side}
        , alone{alone}
        , o{o}
        , moved{moved}
        , inwards{inwards}
        , aside{aside}
        , along{along}
        , best_along{best_along}
        , against{against}
        , best_against{best_against}
        , ahead{ahead}

    {
    }

    CUDA_CALLABLE FaceContact_ae9d5902& operator += (const FaceContact_ae9d5902& rhs)
    {    p += rhs.p;
    own += rhs.own;
    facet += rhs.facet;
    side += rhs.side;
    o += rhs.o;
    moved += rhs.moved;
    inwards += rhs.inwards;
    aside += rhs.aside;
    along += rhs.along;
    best_along += rhs.best_along;
    against += rhs.against;
    best_against += rhs.best_against;
    ahead += rhs.ahead;

        return *this;}

};

static CUDA_CALLABLE void adj_FaceContact_ae9d5902(wp::vec_t<3, wp::float64> const&,
    wp::int32 const&,
    Facet_ffcefc8d const&,
    wp::float64 const&,
    bool const&,
    wp::vec_t<3, wp::float64> const&,
    wp::float64 const&,
    wp::float64 const&,
    wp::vec_t<3, wp::float64> const&,
    wp::int32 const&,
    wp::float64 const&,
    wp::int32 const&,
    wp::float64 const&,
    wp::float64 const&,
    wp::vec_t<3, wp::float64> & adj_p,
    wp::int32 & adj_own,
    Facet_ffcefc8d & adj_facet,
    wp::float64 & adj_side,
    bool & adj_alone,
    wp::vec_t<3, wp::float64> & adj_o,
    wp::float64 & adj_moved,
    wp::float64 & adj_inwards,
    wp::vec_t<3, wp::float64> & adj_aside,
    wp::int32 & adj_along,
    wp::float64 & adj_best_along,
    wp::int32 & adj_against,
    wp::float64 & adj_best_against,
    wp::float64 & adj_ahead,
    FaceContact_ae9d5902 & adj_ret)
{
    adj_p += adj_ret.p;
    adj_own += adj_ret.own;
    adj_facet += adj_ret.facet;
    adj_side += adj_ret.side;
    adj_alone += adj_ret.alone;
    adj_o += adj_ret.o;
    adj_moved += adj_ret.moved;
    adj_inwards += adj_ret.inwards;
    adj_aside += adj_ret.aside;
    adj_along += adj_ret.along;
    adj_best_along += adj_ret.best_along;
    adj_against += adj_ret.against;
    adj_best_against += adj_ret.best_against;
    adj_ahead += adj_ret.ahead;
}

// Required when compiling adjoints.
CUDA_CALLABLE FaceContact_ae9d5902 add(const FaceContact_ae9d5902& a, const FaceContact_ae9d5902& b)
{
    return FaceContact_ae9d5902();
}

CUDA_CALLABLE void adj_atomic_add(FaceContact_ae9d5902* p, FaceContact_ae9d5902 t)
{
    wp::adj_atomic_add(&p->p, t.p);
    wp::adj_atomic_add(&p->own, t.own);
    adj_atomic_add(&p->facet, t.facet);
    wp::adj_atomic_add(&p->side, t.side);
    wp::adj_atomic_add(&p->alone, t.alone);
    wp::adj_atomic_add(&p->o, t.o);
    wp::adj_atomic_add(&p->moved, t.moved);
    wp::adj_atomic_add(&p->inwards, t.inwards);
    wp::adj_atomic_add(&p->aside, t.aside);
    wp::adj_atomic_add(&p->along, t.along);
    wp::adj_atomic_add(&p->best_along, t.best_along);
    wp::adj_atomic_add(&p->against, t.against);
    wp::adj_atomic_add(&p->best_against, t.best_against);
    wp::adj_atomic_add(&p->ahead, t.ahead);
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




struct Contacts_1da7c857
{
    Placement_e6d83c4e placement;
    wp::uint64 towards;
    wp::uint64 face;
    wp::uint64 raised;
    wp::uint64 vertices;
    wp::uint64 triangles;
    wp::vec_t<3, wp::float32> spread;
    wp::uint64 starts;
    wp::int32 sides;


    Contacts_1da7c857() = default;
    CUDA_CALLABLE Contacts_1da7c857(Placement_e6d83c4e const& placement,
    wp::uint64 const& towards = {},
    wp::uint64 const& face = {},
    wp::uint64 const& raised = {},
    wp::uint64 const& vertices = {},
    wp::uint64 const& triangles = {},
    wp::vec_t<3, wp::float32> const& spread = {},
    wp::uint64 const& starts = {},
    wp::int32 const& sides = {})
        : placement{placement}
        , towards{towards}
        , face{face}
        , raised{raised}
        , vertices{vertices}
        , triangles{triangles}
        , spread{spread}
        , starts{starts}
        , sides{sides}

    {
    }

    CUDA_CALLABLE Contacts_1da7c857& operator += (const Contacts_1da7c857& rhs)
    {    placement += rhs.placement;
    towards += rhs.towards;
    face += rhs.face;
    raised += rhs.raised;
    vertices += rhs.vertices;
    triangles += rhs.triangles;
    spread += rhs.spread;
    starts += rhs.starts;
    sides += rhs.sides;

        return *this;}

};

static CUDA_CALLABLE void adj_Contacts_1da7c857(Placement_e6d83c4e const&,
    wp::uint64 const&,
    wp::uint64 const&,
    wp::uint64 const&,
    wp::uint64 const&,
    wp::uint64 const&,
    wp::vec_t<3, wp::float32> const&,
    wp::uint64 const&,
    wp::int32 const&,
    Placement_e6d83c4e & adj_placement,
    wp::uint64 & adj_towards,
    wp::uint64 & adj_face,
    wp::uint64 & adj_raised,
    wp::uint64 & adj_vertices,
    wp::uint64 & adj_triangles,
    wp::vec_t<3, wp::float32> & adj_spread,
    wp::uint64 & adj_starts,
    wp::int32 & adj_sides,
    Contacts_1da7c857 & adj_ret)
{
    adj_placement += adj_ret.placement;
    adj_towards += adj_ret.towards;
    adj_face += adj_ret.face;
    adj_raised += adj_ret.raised;
    adj_vertices += adj_ret.vertices;
    adj_triangles += adj_ret.triangles;
    adj_spread += adj_ret.spread;
    adj_starts += adj_ret.starts;
    adj_sides += adj_ret.sides;
}

// Required when compiling adjoints.
CUDA_CALLABLE Contacts_1da7c857 add(const Contacts_1da7c857& a, const Contacts_1da7c857& b)
{
    return Contacts_1da7c857();
}

CUDA_CALLABLE void adj_atomic_add(Contacts_1da7c857* p, Contacts_1da7c857 t)
{
    adj_atomic_add(&p->placement, t.placement);
    wp::adj_atomic_add(&p->towards, t.towards);
    wp::adj_atomic_add(&p->face, t.face);
    wp::adj_atomic_add(&p->raised, t.raised);
    wp::adj_atomic_add(&p->vertices, t.vertices);
    wp::adj_atomic_add(&p->triangles, t.triangles);
    wp::adj_atomic_add(&p->spread, t.spread);
    wp::adj_atomic_add(&p->starts, t.starts);
    wp::adj_atomic_add(&p->sides, t.sides);
}




struct Around_9296a408
{
    Contacts_1da7c857 contacts;
    wp::vec_t<3, wp::float32> p;
    wp::float32 r;
    wp::vec_t<3, wp::float64> look;
    bool searching;


    Around_9296a408() = default;
    CUDA_CALLABLE Around_9296a408(Contacts_1da7c857 const& contacts,
    wp::vec_t<3, wp::float32> const& p = {},
    wp::float32 const& r = {},
    wp::vec_t<3, wp::float64> const& look = {},
    bool const& searching = {})
        : contacts{contacts}
        , p{p}
        , r{r}
        , look{look}
        , searching{searching}

    {
    }

    CUDA_CALLABLE Around_9296a408& operator += (const Around_9296a408& rhs)
    {    contacts += rhs.contacts;
    p += rhs.p;
    r += rhs.r;
    look += rhs.look;

        return *this;}

};

static CUDA_CALLABLE void adj_Around_9296a408(Contacts_1da7c857 const&,
    wp::vec_t<3, wp::float32> const&,
    wp::float32 const&,
    wp::vec_t<3, wp::float64> const&,
    bool const&,
    Contacts_1da7c857 & adj_contacts,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::float32 & adj_r,
    wp::vec_t<3, wp::float64> & adj_look,
    bool & adj_searching,
    Around_9296a408 & adj_ret)
{
    adj_contacts += adj_ret.contacts;
    adj_p += adj_ret.p;
    adj_r += adj_ret.r;
    adj_look += adj_ret.look;
    adj_searching += adj_ret.searching;
}

// Required when compiling adjoints.
CUDA_CALLABLE Around_9296a408 add(const Around_9296a408& a, const Around_9296a408& b)
{
    return Around_9296a408();
}

CUDA_CALLABLE void adj_atomic_add(Around_9296a408* p, Around_9296a408 t)
{
    adj_atomic_add(&p->contacts, t.contacts);
    wp::adj_atomic_add(&p->p, t.p);
    wp::adj_atomic_add(&p->r, t.r);
    wp::adj_atomic_add(&p->look, t.look);
    wp::adj_atomic_add(&p->searching, t.searching);
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


// /work/main/warpsample/maths/memory.py:0
static wp::int32 _reader__locals__read_1(
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


// /work/main/warpsample/maths/numerics.py:217
static wp::vec_t<3, wp::float32> normalize_0(
    wp::vec_t<3, wp::float32> var_v)
{
    //---------
    // primal vars
    wp::vec_t<4, wp::float32> var_0;
    const wp::int32 var_1 = 3;
    wp::float32 var_2;
    wp::float32 var_3;
    const wp::float32 var_4 = 0.1;
    bool var_5;
    const wp::int32 var_6 = 0;
    wp::float32 var_7;
    const wp::int32 var_8 = 1;
    wp::float32 var_9;
    const wp::int32 var_10 = 2;
    wp::float32 var_11;
    wp::vec_t<3, wp::float32> var_12;
    const wp::float32 var_13 = 0.0;
    wp::vec_t<3, wp::float32> var_14;
    //---------
    // forward
    // def normalize(v: wp.vec3) -> wp.vec3:                                                  <L 218>
    // unit = scaled_to_unit(v)                                                               <L 220>
    var_0 = scaled_to_unit_0(var_v);
    // if wp.abs(unit[3]) < 0.1:                                                              <L 221>
    var_2 = wp::extract(var_0, var_1);
    var_3 = wp::abs(var_2);
    var_5 = (var_3 < var_4);
    if (var_5) {
        // return wp.vec3(unit[0], unit[1], unit[2])                                          <L 222>
        var_7 = wp::extract(var_0, var_6);
        var_9 = wp::extract(var_0, var_8);
        var_11 = wp::extract(var_0, var_10);
        var_12 = wp::vec_t<3, wp::float32>(var_7, var_9, var_11);
        return var_12;
    }
    // return wp.vec3(0.0)                                                                    <L 223>
    var_14 = wp::vec_t<3, wp::float32>(var_13);
    return var_14;
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


// /work/main/warpsample/tracing/starts.py:96
static bool _is_raised_0(
    Contacts_1da7c857 var_contacts,
    wp::int64 var_i)
{
    //---------
    // primal vars
    const bool var_0 = false;
    bool var_1;
    wp::uint64* var_2;
    wp::uint64 var_3;
    bool var_4;
    wp::uint64 var_5;
    wp::uint64* var_6;
    wp::uint8 var_7;
    wp::uint64 var_8;
    const wp::int32 var_9 = 0;
    wp::uint8 var_10;
    bool var_11;
    bool var_12;
    //---------
    // forward
    // def _is_raised(contacts: Contacts, i: wp.int64) -> wp.bool:                            <L 97>
    // raised = wp.bool(False)                                                                <L 99>
    var_1 = bool(var_0);
    // if contacts.raised != wp.uint64(0):                                                    <L 100>
    var_2 = &((var_contacts).raised);
    var_3 = 0ull;
    var_5 = wp::load(var_2);
    var_4 = (var_5 != var_3);
    if (var_4) {
        // raised = byte_at(contacts.raised, i) != wp.uint8(0)                                <L 101>
        var_6 = &((var_contacts).raised);
        var_8 = wp::load(var_6);
        var_7 = _reader__locals__read_4(var_8, var_i);
        var_10 = wp::uint8(var_9);
        var_11 = (var_7 != var_10);
    }
    var_12 = wp::where(var_4, var_11, var_1);
    // return raised                                                                          <L 102>
    return var_12;
}


// /work/main/warpsample/tracing/sight/contacts.py:201
static wp::vec_t<3, wp::float32> start_above_0(
    Contacts_1da7c857 var_contacts,
    wp::vec_t<3, wp::float64> var_p,
    wp::vec_t<3, wp::float64> var_look)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 2;
    wp::float64 var_1;
    wp::float64 var_2;
    wp::vec_t<3, wp::float32>* var_3;
    const wp::int32 var_4 = 2;
    wp::float32 var_5;
    wp::vec_t<3, wp::float32> var_6;
    wp::float64 var_7;
    wp::float64 var_8;
    Placement_e6d83c4e* var_9;
    wp::float32* var_10;
    wp::float64 var_11;
    wp::float32 var_12;
    const wp::float64 var_13 = 1.9073486328125e-06;
    wp::float64 var_14;
    wp::float64 var_15;
    const wp::int32 var_16 = 0;
    wp::float64 var_17;
    const wp::int32 var_18 = 1;
    wp::float64 var_19;
    const wp::int32 var_20 = 2;
    wp::float64 var_21;
    const wp::int32 var_22 = 2;
    wp::float64 var_23;
    wp::float64 var_24;
    wp::float64 var_25;
    wp::vec_t<3, wp::float64> var_26;
    wp::vec_t<3, wp::float32> var_27;
    //---------
    // forward
    // def start_above(contacts: Contacts, p: wp.vec3d, look: wp.vec3d) -> wp.vec3:           <L 202>
    // most = wp.max(wp.abs(p[2]), wp.float64(contacts.spread[2]))                            <L 209>
    var_1 = wp::extract(var_p, var_0);
    var_2 = wp::abs(var_1);
    var_3 = &((var_contacts).spread);
    var_6 = wp::load(var_3);
    var_5 = wp::extract(var_6, var_4);
    var_7 = wp::float64(var_5);
    var_8 = wp::max(var_2, var_7);
    // height = wp.float64(contacts.placement.coarseness) + _RAISED * most                    <L 210>
    var_9 = &((var_contacts).placement);
    var_10 = &(((var_contacts).placement).coarseness);
    var_12 = wp::load(var_10);
    var_11 = wp::float64(var_12);
    var_14 = wp::mul(var_13, var_8);
    var_15 = wp::add(var_11, var_14);
    // return wp.vec3(wp.vec3d(p[0], p[1], p[2] + wp.copysign(height, look[2])))              <L 211>
    var_17 = wp::extract(var_p, var_16);
    var_19 = wp::extract(var_p, var_18);
    var_21 = wp::extract(var_p, var_20);
    var_23 = wp::extract(var_look, var_22);
    var_24 = wp::copysign(var_15, var_23);
    var_25 = wp::add(var_21, var_24);
    var_26 = wp::vec_t<3, wp::float64>(var_17, var_19, var_25);
    var_27 = wp::vec_t<3, wp::float32>(var_26);
    return var_27;
}


// /work/main/warpsample/maths/memory.py:0
static void _writer__locals__write_3(
    wp::uint64 var_address,
    wp::int64 var_i,
    wp::vec_t<3, wp::float32> var_x)
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
    //---------
    // forward
    // def write(address: wp.uint64, i: Any, x: kind):                                        <L 1>
    // view = wp.array(ptr=address + wp.uint64(i) * wp.uint64(size), shape=(1,), dtype=kind)       <L 2>
    var_0 = wp::uint64(var_i);
    var_1 = 12ull;
    var_2 = wp::mul(var_0, var_1);
    var_3 = wp::add(var_address, var_2);
    var_5 = wp::tuple(var_4);
    var_6 = wp::array_t<wp::vec_t<3, wp::float32>>(var_3, var_7);
    // view[0] = x                                                                            <L 3>
    wp::array_store(var_6, var_8, var_x);
}


// /work/main/warpsample/tracing/starts.py:105
static void _set_start_0(
    Contacts_1da7c857 var_contacts,
    wp::int64 var_i,
    wp::int32 var_side,
    wp::vec_t<3, wp::float32> var_start)
{
    //---------
    // primal vars
    wp::uint64* var_0;
    wp::int32* var_1;
    wp::int64 var_2;
    wp::int32 var_3;
    wp::int64 var_4;
    wp::int64 var_5;
    wp::int64 var_6;
    wp::uint64 var_7;
    //---------
    // forward
    // def _set_start(contacts: Contacts, i: wp.int64, side: wp.int32, start: wp.vec3):       <L 106>
    // set_vec3(contacts.starts, i * wp.int64(contacts.sides) + wp.int64(side), start)        <L 108>
    var_0 = &((var_contacts).starts);
    var_1 = &((var_contacts).sides);
    var_3 = wp::load(var_1);
    var_2 = wp::int64(var_3);
    var_4 = wp::mul(var_i, var_2);
    var_5 = wp::int64(var_side);
    var_6 = wp::add(var_4, var_5);
    var_7 = wp::load(var_0);
    _writer__locals__write_3(var_7, var_6, var_start);
}


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


// /work/main/warpsample/tracing/sight/facets.py:83
static Facet_ffcefc8d corners_of_0(
    Contacts_1da7c857 var_contacts,
    wp::int32 var_face)
{
    //---------
    // primal vars
    wp::uint64* var_0;
    wp::vec_t<3, wp::int32> var_1;
    wp::uint64 var_2;
    Facet_ffcefc8d var_3;
    wp::uint64* var_4;
    const wp::int32 var_5 = 0;
    wp::int32 var_6;
    wp::vec_t<3, wp::float32> var_7;
    wp::uint64 var_8;
    wp::vec_t<3, wp::float64> var_9;
    wp::uint64* var_10;
    const wp::int32 var_11 = 1;
    wp::int32 var_12;
    wp::vec_t<3, wp::float32> var_13;
    wp::uint64 var_14;
    wp::vec_t<3, wp::float64> var_15;
    wp::uint64* var_16;
    const wp::int32 var_17 = 2;
    wp::int32 var_18;
    wp::vec_t<3, wp::float32> var_19;
    wp::uint64 var_20;
    wp::vec_t<3, wp::float64> var_21;
    //---------
    // forward
    // def corners_of(contacts: Contacts, face: wp.int32) -> Facet:                           <L 84>
    // corners = vec3i_at(contacts.triangles, face)                                           <L 86>
    var_0 = &((var_contacts).triangles);
    var_2 = wp::load(var_0);
    var_1 = _reader__locals__read_6(var_2, var_face);
    // facet = Facet()                                                                        <L 87>
    var_3 = Facet_ffcefc8d();
    // facet.a = in_double(vec3_at(contacts.vertices, corners[0]))                            <L 88>
    var_4 = &((var_contacts).vertices);
    var_6 = wp::extract(var_1, var_5);
    var_8 = wp::load(var_4);
    var_7 = _reader__locals__read_5(var_8, var_6);
    var_9 = in_double_0(var_7);
    var_3.a = var_9;
    // facet.b = in_double(vec3_at(contacts.vertices, corners[1]))                            <L 89>
    var_10 = &((var_contacts).vertices);
    var_12 = wp::extract(var_1, var_11);
    var_14 = wp::load(var_10);
    var_13 = _reader__locals__read_5(var_14, var_12);
    var_15 = in_double_0(var_13);
    var_3.b = var_15;
    // facet.c = in_double(vec3_at(contacts.vertices, corners[2]))                            <L 90>
    var_16 = &((var_contacts).vertices);
    var_18 = wp::extract(var_1, var_17);
    var_20 = wp::load(var_16);
    var_19 = _reader__locals__read_5(var_20, var_18);
    var_21 = in_double_0(var_19);
    var_3.c = var_21;
    // return facet                                                                           <L 91>
    return var_3;
}


// /work/main/warpsample/tracing/sight/facets.py:66
static Facet_ffcefc8d with_normal_0(
    Contacts_1da7c857 var_contacts,
    Facet_ffcefc8d var_facet,
    wp::vec_t<3, wp::float64> var_n)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float32>* var_0;
    wp::vec_t<3, wp::float64> var_1;
    wp::vec_t<3, wp::float32> var_2;
    Placement_e6d83c4e* var_3;
    wp::float32* var_4;
    wp::float64 var_5;
    wp::float32 var_6;
    wp::float64* var_7;
    wp::float64 var_8;
    wp::float64 var_9;
    const wp::int32 var_10 = 0;
    wp::vec_t<3, wp::float64>* var_11;
    wp::float64 var_12;
    wp::vec_t<3, wp::float64> var_13;
    wp::float64 var_14;
    wp::vec_t<3, wp::float64>* var_15;
    wp::float64 var_16;
    wp::vec_t<3, wp::float64> var_17;
    wp::float64 var_18;
    wp::float64 var_19;
    wp::vec_t<3, wp::float64>* var_20;
    wp::float64 var_21;
    wp::vec_t<3, wp::float64> var_22;
    wp::float64 var_23;
    wp::float64 var_24;
    wp::float64* var_25;
    const wp::float64 var_26 = 1.9073486328125e-06;
    wp::float64 var_27;
    wp::float64 var_28;
    wp::float64 var_29;
    wp::float64 var_30;
    wp::float64 var_31;
    wp::float64 var_32;
    wp::float64 var_33;
    wp::float64 var_34;
    wp::float64* var_35;
    wp::float64 var_36;
    wp::float64 var_37;
    wp::float64 var_38;
    wp::float64 var_39;
    wp::float64 var_40;
    const wp::int32 var_41 = 1;
    wp::vec_t<3, wp::float64>* var_42;
    wp::float64 var_43;
    wp::vec_t<3, wp::float64> var_44;
    wp::float64 var_45;
    wp::vec_t<3, wp::float64>* var_46;
    wp::float64 var_47;
    wp::vec_t<3, wp::float64> var_48;
    wp::float64 var_49;
    wp::float64 var_50;
    wp::vec_t<3, wp::float64>* var_51;
    wp::float64 var_52;
    wp::vec_t<3, wp::float64> var_53;
    wp::float64 var_54;
    wp::float64 var_55;
    wp::float64* var_56;
    wp::float64 var_57;
    wp::float64 var_58;
    wp::float64 var_59;
    wp::float64 var_60;
    wp::float64 var_61;
    wp::float64 var_62;
    wp::float64 var_63;
    wp::float64 var_64;
    wp::float64* var_65;
    wp::float64 var_66;
    wp::float64 var_67;
    wp::float64 var_68;
    wp::float64 var_69;
    wp::float64 var_70;
    const wp::int32 var_71 = 2;
    wp::vec_t<3, wp::float64>* var_72;
    wp::float64 var_73;
    wp::vec_t<3, wp::float64> var_74;
    wp::float64 var_75;
    wp::vec_t<3, wp::float64>* var_76;
    wp::float64 var_77;
    wp::vec_t<3, wp::float64> var_78;
    wp::float64 var_79;
    wp::float64 var_80;
    wp::vec_t<3, wp::float64>* var_81;
    wp::float64 var_82;
    wp::vec_t<3, wp::float64> var_83;
    wp::float64 var_84;
    wp::float64 var_85;
    wp::float64* var_86;
    wp::float64 var_87;
    wp::float64 var_88;
    wp::float64 var_89;
    wp::float64 var_90;
    wp::float64 var_91;
    wp::float64 var_92;
    wp::float64 var_93;
    wp::float64 var_94;
    wp::float64* var_95;
    wp::float64 var_96;
    wp::float64 var_97;
    wp::float64 var_98;
    wp::float64 var_99;
    wp::float64 var_100;
    //---------
    // forward
    // def with_normal(contacts: Contacts, facet: Facet, n: wp.vec3d) -> Facet:               <L 67>
    // spread = in_double(contacts.spread)                                                    <L 72>
    var_0 = &((var_contacts).spread);
    var_2 = wp::load(var_0);
    var_1 = in_double_0(var_2);
    // facet.n = n                                                                            <L 73>
    var_facet.n = var_n;
    // facet.offset = wp.float64(contacts.placement.coarseness)                               <L 74>
    var_3 = &((var_contacts).placement);
    var_4 = &(((var_contacts).placement).coarseness);
    var_6 = wp::load(var_4);
    var_5 = wp::float64(var_6);
    var_facet.offset = var_5;
    // facet.slack = facet.offset                                                             <L 75>
    var_7 = &((var_facet).offset);
    var_9 = wp::load(var_7);
    var_8 = wp::copy(var_9);
    var_facet.slack = var_8;
    // for axis in range(3):                                                                  <L 76>
    // reach = wp.max(wp.max(wp.abs(facet.a[axis]), wp.abs(facet.b[axis])), wp.abs(facet.c[axis]))       <L 77>
    var_11 = &((var_facet).a);
    var_13 = wp::load(var_11);
    var_12 = wp::extract(var_13, var_10);
    var_14 = wp::abs(var_12);
    var_15 = &((var_facet).b);
    var_17 = wp::load(var_15);
    var_16 = wp::extract(var_17, var_10);
    var_18 = wp::abs(var_16);
    var_19 = wp::max(var_14, var_18);
    var_20 = &((var_facet).c);
    var_22 = wp::load(var_20);
    var_21 = wp::extract(var_22, var_10);
    var_23 = wp::abs(var_21);
    var_24 = wp::max(var_19, var_23);
    // facet.offset += _OFFSET * wp.abs(n[axis]) * wp.max(reach, spread[axis])                <L 78>
    var_25 = &((var_facet).offset);
    var_27 = wp::extract(var_n, var_10);
    var_28 = wp::abs(var_27);
    var_29 = wp::mul(var_26, var_28);
    var_30 = wp::extract(var_1, var_10);
    var_31 = wp::max(var_24, var_30);
    var_32 = wp::mul(var_29, var_31);
    var_34 = wp::load(var_25);
    var_33 = wp::add(var_34, var_32);
    var_facet.offset = var_33;
    // facet.slack += _OFFSET * wp.max(reach, spread[axis])                                   <L 79>
    var_35 = &((var_facet).slack);
    var_36 = wp::extract(var_1, var_10);
    var_37 = wp::max(var_24, var_36);
    var_38 = wp::mul(var_26, var_37);
    var_40 = wp::load(var_35);
    var_39 = wp::add(var_40, var_38);
    var_facet.slack = var_39;
    // reach = wp.max(wp.max(wp.abs(facet.a[axis]), wp.abs(facet.b[axis])), wp.abs(facet.c[axis]))       <L 77>
    var_42 = &((var_facet).a);
    var_44 = wp::load(var_42);
    var_43 = wp::extract(var_44, var_41);
    var_45 = wp::abs(var_43);
    var_46 = &((var_facet).b);
    var_48 = wp::load(var_46);
    var_47 = wp::extract(var_48, var_41);
    var_49 = wp::abs(var_47);
    var_50 = wp::max(var_45, var_49);
    var_51 = &((var_facet).c);
    var_53 = wp::load(var_51);
    var_52 = wp::extract(var_53, var_41);
    var_54 = wp::abs(var_52);
    var_55 = wp::max(var_50, var_54);
    // facet.offset += _OFFSET * wp.abs(n[axis]) * wp.max(reach, spread[axis])                <L 78>
    var_56 = &((var_facet).offset);
    var_57 = wp::extract(var_n, var_41);
    var_58 = wp::abs(var_57);
    var_59 = wp::mul(var_26, var_58);
    var_60 = wp::extract(var_1, var_41);
    var_61 = wp::max(var_55, var_60);
    var_62 = wp::mul(var_59, var_61);
    var_64 = wp::load(var_56);
    var_63 = wp::add(var_64, var_62);
    var_facet.offset = var_63;
    // facet.slack += _OFFSET * wp.max(reach, spread[axis])                                   <L 79>
    var_65 = &((var_facet).slack);
    var_66 = wp::extract(var_1, var_41);
    var_67 = wp::max(var_55, var_66);
    var_68 = wp::mul(var_26, var_67);
    var_70 = wp::load(var_65);
    var_69 = wp::add(var_70, var_68);
    var_facet.slack = var_69;
    // reach = wp.max(wp.max(wp.abs(facet.a[axis]), wp.abs(facet.b[axis])), wp.abs(facet.c[axis]))       <L 77>
    var_72 = &((var_facet).a);
    var_74 = wp::load(var_72);
    var_73 = wp::extract(var_74, var_71);
    var_75 = wp::abs(var_73);
    var_76 = &((var_facet).b);
    var_78 = wp::load(var_76);
    var_77 = wp::extract(var_78, var_71);
    var_79 = wp::abs(var_77);
    var_80 = wp::max(var_75, var_79);
    var_81 = &((var_facet).c);
    var_83 = wp::load(var_81);
    var_82 = wp::extract(var_83, var_71);
    var_84 = wp::abs(var_82);
    var_85 = wp::max(var_80, var_84);
    // facet.offset += _OFFSET * wp.abs(n[axis]) * wp.max(reach, spread[axis])                <L 78>
    var_86 = &((var_facet).offset);
    var_87 = wp::extract(var_n, var_71);
    var_88 = wp::abs(var_87);
    var_89 = wp::mul(var_26, var_88);
    var_90 = wp::extract(var_1, var_71);
    var_91 = wp::max(var_85, var_90);
    var_92 = wp::mul(var_89, var_91);
    var_94 = wp::load(var_86);
    var_93 = wp::add(var_94, var_92);
    var_facet.offset = var_93;
    // facet.slack += _OFFSET * wp.max(reach, spread[axis])                                   <L 79>
    var_95 = &((var_facet).slack);
    var_96 = wp::extract(var_1, var_71);
    var_97 = wp::max(var_85, var_96);
    var_98 = wp::mul(var_26, var_97);
    var_100 = wp::load(var_95);
    var_99 = wp::add(var_100, var_98);
    var_facet.slack = var_99;
    // return facet                                                                           <L 80>
    return var_facet;
}


// /work/main/warpsample/tracing/sight/contacts.py:182
static FaceContact_ae9d5902 raise_start_0(
    Contacts_1da7c857 var_contacts,
    FaceContact_ae9d5902 var_contact,
    wp::vec_t<3, wp::float64> var_look,
    bool var_known)
{
    //---------
    // primal vars
    Facet_ffcefc8d* var_0;
    Facet_ffcefc8d var_1;
    Facet_ffcefc8d var_2;
    const wp::float64 var_3 = 1.0;
    wp::vec_t<3, wp::float64>* var_4;
    wp::float64 var_5;
    wp::vec_t<3, wp::float64> var_6;
    wp::float64 var_7;
    const wp::float64 var_8 = 0.0;
    const wp::vec_t<3, wp::float64> var_9 = wp::initializer_array<3,wp::float64>{0.0, 0.0, 0.0};
    wp::float64* var_10;
    wp::vec_t<3, wp::float64>* var_11;
    wp::vec_t<3, wp::float64>* var_12;
    wp::vec_t<3, wp::float64>* var_13;
    wp::vec_t<3, wp::float64> var_14;
    wp::vec_t<3, wp::float64> var_15;
    wp::vec_t<3, wp::float64> var_16;
    wp::float64 var_17;
    wp::vec_t<3, wp::float64> var_18;
    wp::float64 var_19;
    wp::float64 var_20;
    wp::float64* var_21;
    wp::float64 var_22;
    wp::float64 var_23;
    const wp::float64 var_24 = 2.0;
    wp::float64* var_25;
    wp::float64 var_26;
    wp::float64 var_27;
    wp::float64 var_28;
    wp::float64* var_29;
    wp::vec_t<3, wp::float64>* var_30;
    wp::vec_t<3, wp::float64> var_31;
    wp::float64 var_32;
    wp::vec_t<3, wp::float64> var_33;
    wp::float64 var_34;
    bool var_35;
    bool var_36;
    const wp::float64 var_37 = 0.1;
    bool var_38;
    bool var_39;
    wp::vec_t<3, wp::float64> var_40;
    wp::float64 var_41;
    Facet_ffcefc8d var_42;
    wp::float64* var_43;
    wp::float64 var_44;
    wp::float64 var_45;
    wp::float64 var_46;
    wp::vec_t<3, wp::float64> var_47;
    wp::vec_t<3, wp::float64>* var_48;
    wp::vec_t<3, wp::float64> var_49;
    wp::vec_t<3, wp::float64> var_50;
    wp::vec_t<3, wp::float64> var_51;
    //---------
    // forward
    // def raise_start(contacts: Contacts, contact: FaceContact, look: wp.vec3d, known: wp.bool) -> FaceContact:       <L 183>
    // own = contact.facet                                                                    <L 185>
    var_0 = &((var_contact).facet);
    var_2 = wp::load(var_0);
    var_1 = wp::copy(var_2);
    // contact.side = wp.copysign(ONE, wp.dot(own.n, look))                                   <L 186>
    var_4 = &((var_1).n);
    var_6 = wp::load(var_4);
    var_5 = wp::dot(var_6, var_look);
    var_7 = wp::copysign(var_3, var_5);
    var_contact.side = var_7;
    // contact.inwards = ZERO                                                                 <L 187>
    var_contact.inwards = var_8;
    // contact.aside = NOWHERE                                                                <L 188>
    var_contact.aside = var_9;
    // height = contact.side * wp.dot(own.n, contact.p - own.a)                               <L 189>
    var_10 = &((var_contact).side);
    var_11 = &((var_1).n);
    var_12 = &((var_contact).p);
    var_13 = &((var_1).a);
    var_15 = wp::load(var_12);
    var_16 = wp::load(var_13);
    var_14 = wp::sub(var_15, var_16);
    var_18 = wp::load(var_11);
    var_17 = wp::dot(var_18, var_14);
    var_20 = wp::load(var_10);
    var_19 = wp::mul(var_20, var_17);
    // away = wp.clamp(own.offset - height, ZERO, TWO * own.offset)                           <L 190>
    var_21 = &((var_1).offset);
    var_23 = wp::load(var_21);
    var_22 = wp::sub(var_23, var_19);
    var_25 = &((var_1).offset);
    var_27 = wp::load(var_25);
    var_26 = wp::mul(var_24, var_27);
    var_28 = wp::clamp(var_22, var_8, var_26);
    // way = contact.side * own.n                                                             <L 191>
    var_29 = &((var_contact).side);
    var_30 = &((var_1).n);
    var_32 = wp::load(var_29);
    var_33 = wp::load(var_30);
    var_31 = wp::mul(var_32, var_33);
    // steep = wp.dot(way, look)                                                              <L 192>
    var_34 = wp::dot(var_31, var_look);
    // if not known and steep > _TENTH and away > ZERO:  # a vertex moves along its normal, which is above all its faces       <L 193>
    var_36 = wp::unot(var_known);
    var_35 = var_36;
    if (var_35) {
        var_38 = (var_34 > var_37);
        var_35 = var_35 && var_38;
    }
    if (var_35) {
        var_39 = (var_28 > var_8);
        var_35 = var_35 && var_39;
    }
    if (var_35) {
        // way = look                                                                         <L 194>
        var_40 = wp::copy(var_look);
        // away = wp.max(away / steep, with_normal(contacts, own, look).offset)               <L 195>
        var_41 = wp::div(var_28, var_34);
        var_42 = with_normal_0(var_contacts, var_1, var_look);
        var_43 = &(var_42.offset);
        var_45 = wp::load(var_43);
        var_44 = wp::max(var_41, var_45);
    }
    var_46 = wp::where(var_35, var_44, var_28);
    var_47 = wp::where(var_35, var_40, var_31);
    // contact.o = contact.p + away * way                                                     <L 196>
    var_48 = &((var_contact).p);
    var_49 = wp::mul(var_46, var_47);
    var_51 = wp::load(var_48);
    var_50 = wp::add(var_51, var_49);
    var_contact.o = var_50;
    // contact.moved = away                                                                   <L 197>
    var_contact.moved = var_46;
    // return contact                                                                         <L 198>
    return var_contact;
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


// /work/main/warpsample/tracing/sight/touching.py:18
static wp::int32 _children_around_0(
    wp::uint64 var_node,
    wp::vec_t<3, wp::float32> var_p,
    wp::float32 var_r)
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
    wp::tuple_t<wp::int32> var_13;
    wp::fixedarray_t<16, wp::int32> var_14;
    const wp::int32 var_15 = 16;
    const wp::int32 var_16 = 0;
    wp::int32 var_17;
    bool var_18;
    wp::float32* var_19;
    const wp::int32 var_20 = 0;
    wp::float32 var_21;
    wp::float32 var_22;
    bool var_23;
    wp::float32 var_24;
    const wp::int32 var_25 = 1;
    const wp::int32 var_26 = 0;
    wp::int32 var_27;
    const wp::int32 var_28 = 3;
    wp::int32 var_29;
    wp::int32 var_30;
    wp::float32* var_31;
    const wp::int32 var_32 = 0;
    wp::float32 var_33;
    wp::float32 var_34;
    bool var_35;
    wp::float32 var_36;
    const wp::int32 var_37 = 1;
    const wp::int32 var_38 = 0;
    wp::int32 var_39;
    wp::int32 var_40;
    wp::int32 var_41;
    wp::float32* var_42;
    const wp::int32 var_43 = 1;
    wp::float32 var_44;
    wp::float32 var_45;
    bool var_46;
    wp::float32 var_47;
    const wp::int32 var_48 = 1;
    const wp::int32 var_49 = 0;
    wp::int32 var_50;
    const wp::int32 var_51 = 4;
    wp::int32 var_52;
    wp::int32 var_53;
    wp::float32* var_54;
    const wp::int32 var_55 = 1;
    wp::float32 var_56;
    wp::float32 var_57;
    bool var_58;
    wp::float32 var_59;
    const wp::int32 var_60 = 1;
    const wp::int32 var_61 = 0;
    wp::int32 var_62;
    wp::int32 var_63;
    const wp::int32 var_64 = 2;
    wp::int32 var_65;
    wp::int32 var_66;
    wp::float32* var_67;
    const wp::int32 var_68 = 2;
    wp::float32 var_69;
    wp::float32 var_70;
    bool var_71;
    wp::float32 var_72;
    const wp::int32 var_73 = 1;
    const wp::int32 var_74 = 0;
    wp::int32 var_75;
    const wp::int32 var_76 = 5;
    wp::int32 var_77;
    wp::int32 var_78;
    wp::float32* var_79;
    const wp::int32 var_80 = 2;
    wp::float32 var_81;
    wp::float32 var_82;
    bool var_83;
    wp::float32 var_84;
    const wp::int32 var_85 = 1;
    const wp::int32 var_86 = 0;
    wp::int32 var_87;
    wp::int32 var_88;
    wp::int32 var_89;
    wp::int32 var_90;
    wp::int32* var_91;
    const wp::int32 var_92 = 0;
    bool var_93;
    wp::int32 var_94;
    const wp::int32 var_95 = 1;
    const wp::int32 var_96 = 0;
    wp::int32 var_97;
    wp::int32 var_98;
    const wp::int32 var_99 = 1;
    wp::int32 var_100;
    wp::uint64* var_101;
    const wp::int32 var_102 = 0;
    wp::int32 var_103;
    wp::uint64 var_104;
    //---------
    // forward
    // def _children_around(node: wp.uint64, p: wp.vec3, r: wp.float32) -> wp.int32:          <L 19>
    // rows = wp.array(ptr=node, shape=(_NODE_FLOATS,), dtype=wp.float32)                     <L 21>
    var_1 = wp::tuple(var_0);
    var_2 = wp::array_t<wp::float32>(var_node, var_3);
    // links = wp.array(ptr=node + wp.uint64(4 * LINKS), shape=(WIDTH,), dtype=wp.int32)       <L 22>
    var_6 = wp::mul(var_4, var_5);
    var_7 = wp::uint64(var_6);
    var_8 = wp::add(var_node, var_7);
    var_10 = wp::tuple(var_9);
    var_11 = wp::array_t<wp::int32>(var_8, var_12);
    // near = wp.zeros(shape=(WIDTH,), dtype=wp.int32)                                        <L 23>
    var_13 = wp::tuple(var_9);
    var_14 = wp::fixedarray_t<16, wp::int32>(var_15);
    // k = wp.int32(0)                                                                        <L 24>
    var_17 = wp::int32(var_16);
    // while k < WIDTH:                                                                       <L 25>
    start_while_0:;
    var_18 = (var_17 < var_9);
    if ((var_18) == false) goto end_while_0;
        // x = wp.where(rows[k] <= p[0] + r, 1, 0) & wp.where(rows[3 * WIDTH + k] >= p[0] - r, 1, 0)       <L 26>
        var_19 = wp::address(var_2, var_17);
        var_21 = wp::extract(var_p, var_20);
        var_22 = wp::add(var_21, var_r);
        var_24 = wp::load(var_19);
        var_23 = (var_24 <= var_22);
        var_27 = wp::where(var_23, var_25, var_26);
        var_29 = wp::mul(var_28, var_9);
        var_30 = wp::add(var_29, var_17);
        var_31 = wp::address(var_2, var_30);
        var_33 = wp::extract(var_p, var_32);
        var_34 = wp::sub(var_33, var_r);
        var_36 = wp::load(var_31);
        var_35 = (var_36 >= var_34);
        var_39 = wp::where(var_35, var_37, var_38);
        var_40 = wp::bit_and(var_27, var_39);
        // y = wp.where(rows[WIDTH + k] <= p[1] + r, 1, 0) & wp.where(rows[4 * WIDTH + k] >= p[1] - r, 1, 0)       <L 27>
        var_41 = wp::add(var_9, var_17);
        var_42 = wp::address(var_2, var_41);
        var_44 = wp::extract(var_p, var_43);
        var_45 = wp::add(var_44, var_r);
        var_47 = wp::load(var_42);
        var_46 = (var_47 <= var_45);
        var_50 = wp::where(var_46, var_48, var_49);
        var_52 = wp::mul(var_51, var_9);
        var_53 = wp::add(var_52, var_17);
        var_54 = wp::address(var_2, var_53);
        var_56 = wp::extract(var_p, var_55);
        var_57 = wp::sub(var_56, var_r);
        var_59 = wp::load(var_54);
        var_58 = (var_59 >= var_57);
        var_62 = wp::where(var_58, var_60, var_61);
        var_63 = wp::bit_and(var_50, var_62);
        // z = wp.where(rows[2 * WIDTH + k] <= p[2] + r, 1, 0) & wp.where(rows[5 * WIDTH + k] >= p[2] - r, 1, 0)       <L 28>
        var_65 = wp::mul(var_64, var_9);
        var_66 = wp::add(var_65, var_17);
        var_67 = wp::address(var_2, var_66);
        var_69 = wp::extract(var_p, var_68);
        var_70 = wp::add(var_69, var_r);
        var_72 = wp::load(var_67);
        var_71 = (var_72 <= var_70);
        var_75 = wp::where(var_71, var_73, var_74);
        var_77 = wp::mul(var_76, var_9);
        var_78 = wp::add(var_77, var_17);
        var_79 = wp::address(var_2, var_78);
        var_81 = wp::extract(var_p, var_80);
        var_82 = wp::sub(var_81, var_r);
        var_84 = wp::load(var_79);
        var_83 = (var_84 >= var_82);
        var_87 = wp::where(var_83, var_85, var_86);
        var_88 = wp::bit_and(var_75, var_87);
        // near[k] = x & y & z & wp.where(links[k] != 0, 1, 0)                                <L 29>
        var_89 = wp::bit_and(var_40, var_63);
        var_90 = wp::bit_and(var_89, var_88);
        var_91 = wp::address(var_11, var_17);
        var_94 = wp::load(var_91);
        var_93 = (var_94 != var_92);
        var_97 = wp::where(var_93, var_95, var_96);
        var_98 = wp::bit_and(var_90, var_97);
        wp::array_store(var_14, var_17, var_98);
        // k += 1                                                                             <L 30>
        var_100 = wp::add(var_17, var_99);
        wp::assign(var_17, var_100);
    goto start_while_0;
    end_while_0:;
    // return lanes_with(near.ptr, 0)                                                         <L 31>
    var_101 = (wp::uint64*)&(var_14.data);
    var_104 = wp::load(var_101);
    var_103 = lanes_with_0(var_104, var_102);
    return var_103;
}


// /work/main/warpsample/tracing/sight/touching.py:77
static wp::int32 faces_touching__locals__enter_0(
    wp::uint64 var_node,
    Around_9296a408 var_query)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float32>* var_0;
    wp::float32* var_1;
    wp::int32 var_2;
    wp::vec_t<3, wp::float32> var_3;
    wp::float32 var_4;
    //---------
    // forward
    // def enter(node: wp.uint64, query: query_type):                                         <L 78>
    // return _children_around(node, query.p, query.r)                                        <L 79>
    var_0 = &((var_query).p);
    var_1 = &((var_query).r);
    var_3 = wp::load(var_0);
    var_4 = wp::load(var_1);
    var_2 = _children_around_0(var_node, var_3, var_4);
    return var_2;
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


// /work/main/warpsample/tracing/sight/touching.py:34
static wp::int32 _is_near_zero_0(
    wp::float32 var_a,
    wp::float32 var_b,
    wp::float32 var_c,
    wp::float32 var_r)
{
    //---------
    // primal vars
    wp::float32 var_0;
    wp::float32 var_1;
    bool var_2;
    const wp::int32 var_3 = 1;
    const wp::int32 var_4 = 0;
    wp::int32 var_5;
    wp::float32 var_6;
    wp::float32 var_7;
    wp::float32 var_8;
    bool var_9;
    const wp::int32 var_10 = 1;
    const wp::int32 var_11 = 0;
    wp::int32 var_12;
    wp::int32 var_13;
    //---------
    // forward
    // def _is_near_zero(a: wp.float32, b: wp.float32, c: wp.float32, r: wp.float32) -> wp.int32:       <L 35>
    // return wp.where(lesser(lesser(a, b), c) <= r, 1, 0) & wp.where(greater(greater(a, b), c) >= -r, 1, 0)       <L 37>
    var_0 = lesser_0(var_a, var_b);
    var_1 = lesser_0(var_0, var_c);
    var_2 = (var_1 <= var_r);
    var_5 = wp::where(var_2, var_3, var_4);
    var_6 = greater_0(var_a, var_b);
    var_7 = greater_0(var_6, var_c);
    var_8 = wp::neg(var_r);
    var_9 = (var_7 >= var_8);
    var_12 = wp::where(var_9, var_10, var_11);
    var_13 = wp::bit_and(var_5, var_12);
    return var_13;
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


// /work/main/warpsample/tracing/sight/touching.py:40
static wp::int32 _triangles_near_point_0(
    wp::uint64 var_leaf,
    wp::vec_t<3, wp::float32> var_p,
    wp::float32 var_r)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 16;
    wp::tuple_t<wp::int32> var_1;
    wp::fixedarray_t<16, wp::int32> var_2;
    const wp::int32 var_3 = 16;
    const wp::int32 var_4 = 0;
    wp::int32 var_5;
    bool var_6;
    const wp::int32 var_7 = 0;
    wp::vec_t<3, wp::float32> var_8;
    const wp::int32 var_9 = 3;
    wp::vec_t<3, wp::float32> var_10;
    const wp::int32 var_11 = 6;
    wp::vec_t<3, wp::float32> var_12;
    const wp::int32 var_13 = 0;
    wp::float32 var_14;
    const wp::int32 var_15 = 0;
    wp::float32 var_16;
    const wp::int32 var_17 = 0;
    wp::float32 var_18;
    wp::int32 var_19;
    const wp::int32 var_20 = 1;
    wp::float32 var_21;
    const wp::int32 var_22 = 1;
    wp::float32 var_23;
    const wp::int32 var_24 = 1;
    wp::float32 var_25;
    wp::int32 var_26;
    wp::int32 var_27;
    const wp::int32 var_28 = 2;
    wp::float32 var_29;
    const wp::int32 var_30 = 2;
    wp::float32 var_31;
    const wp::int32 var_32 = 2;
    wp::float32 var_33;
    wp::int32 var_34;
    wp::int32 var_35;
    wp::vec_t<3, wp::float32> var_36;
    wp::vec_t<3, wp::float32> var_37;
    wp::vec_t<3, wp::float32> var_38;
    wp::float32 var_39;
    wp::float32 var_40;
    wp::float32 var_41;
    wp::float32 var_42;
    wp::float32 var_43;
    const wp::float32 var_44 = 3.814697265625e-06;
    wp::float32 var_45;
    wp::float32 var_46;
    wp::float32 var_47;
    wp::float32 var_48;
    wp::float32 var_49;
    wp::float32 var_50;
    wp::float32 var_51;
    const wp::float32 var_52 = 4.0;
    wp::float32 var_53;
    wp::float32 var_54;
    wp::float32 var_55;
    wp::float32 var_56;
    wp::float32 var_57;
    wp::float32 var_58;
    wp::float32 var_59;
    bool var_60;
    const wp::int32 var_61 = 1;
    const wp::int32 var_62 = 0;
    wp::int32 var_63;
    wp::int32 var_64;
    wp::vec_t<3, wp::float32> var_65;
    wp::float32 var_66;
    wp::float32 var_67;
    bool var_68;
    const wp::int32 var_69 = 1;
    const wp::int32 var_70 = 0;
    wp::int32 var_71;
    wp::int32 var_72;
    wp::vec_t<3, wp::float32> var_73;
    wp::float32 var_74;
    wp::float32 var_75;
    bool var_76;
    const wp::int32 var_77 = 1;
    const wp::int32 var_78 = 0;
    wp::int32 var_79;
    wp::int32 var_80;
    wp::vec_t<3, wp::float32> var_81;
    wp::float32 var_82;
    wp::float32 var_83;
    bool var_84;
    const wp::int32 var_85 = 1;
    const wp::int32 var_86 = 0;
    wp::int32 var_87;
    wp::int32 var_88;
    const wp::int32 var_89 = 1;
    wp::int32 var_90;
    wp::uint64* var_91;
    const wp::int32 var_92 = 0;
    wp::int32 var_93;
    wp::uint64 var_94;
    //---------
    // forward
    // def _triangles_near_point(leaf: wp.uint64, p: wp.vec3, r: wp.float32) -> wp.int32:       <L 41>
    // touched = wp.zeros(shape=(WIDTH,), dtype=wp.int32)                                     <L 43>
    var_1 = wp::tuple(var_0);
    var_2 = wp::fixedarray_t<16, wp::int32>(var_3);
    // k = wp.int32(0)                                                                        <L 44>
    var_5 = wp::int32(var_4);
    // while k < WIDTH:                                                                       <L 45>
    start_while_0:;
    var_6 = (var_5 < var_0);
    if ((var_6) == false) goto end_while_0;
        // a = corner(leaf, 0, k, p)                                                          <L 46>
        var_8 = corner_0(var_leaf, var_7, var_5, var_p);
        // b = corner(leaf, 3, k, p)                                                          <L 47>
        var_10 = corner_0(var_leaf, var_9, var_5, var_p);
        // c = corner(leaf, 6, k, p)                                                          <L 48>
        var_12 = corner_0(var_leaf, var_11, var_5, var_p);
        // near = _is_near_zero(a[0], b[0], c[0], r) & _is_near_zero(a[1], b[1], c[1], r) & _is_near_zero(a[2], b[2], c[2], r)       <L 49>
        var_14 = wp::extract(var_8, var_13);
        var_16 = wp::extract(var_10, var_15);
        var_18 = wp::extract(var_12, var_17);
        var_19 = _is_near_zero_0(var_14, var_16, var_18, var_r);
        var_21 = wp::extract(var_8, var_20);
        var_23 = wp::extract(var_10, var_22);
        var_25 = wp::extract(var_12, var_24);
        var_26 = _is_near_zero_0(var_21, var_23, var_25, var_r);
        var_27 = wp::bit_and(var_19, var_26);
        var_29 = wp::extract(var_8, var_28);
        var_31 = wp::extract(var_10, var_30);
        var_33 = wp::extract(var_12, var_32);
        var_34 = _is_near_zero_0(var_29, var_31, var_33, var_r);
        var_35 = wp::bit_and(var_27, var_34);
        // n = wp.cross(b - a, c - a)                                                         <L 50>
        var_36 = wp::sub(var_10, var_8);
        var_37 = wp::sub(var_12, var_8);
        var_38 = wp::cross(var_36, var_37);
        // far = greater(greater(size_of(a), size_of(b)), size_of(c))                         <L 51>
        var_39 = size_of_0(var_8);
        var_40 = size_of_0(var_10);
        var_41 = greater_0(var_39, var_40);
        var_42 = size_of_0(var_12);
        var_43 = greater_0(var_41, var_42);
        // rounding = _ROUNDING * far * far                                                   <L 53>
        var_45 = wp::mul(var_44, var_43);
        var_46 = wp::mul(var_45, var_43);
        // beside = (r * size_of(n) + rounding * far) * far * 4.0                             <L 54>
        var_47 = size_of_0(var_38);
        var_48 = wp::mul(var_r, var_47);
        var_49 = wp::mul(var_46, var_43);
        var_50 = wp::add(var_48, var_49);
        var_51 = wp::mul(var_50, var_43);
        var_53 = wp::mul(var_51, var_52);
        // near = near & wp.where(wp.abs(wp.dot(n, a)) <= r * size_of(n) + rounding * far, 1, 0)       <L 55>
        var_54 = wp::dot(var_38, var_8);
        var_55 = wp::abs(var_54);
        var_56 = size_of_0(var_38);
        var_57 = wp::mul(var_r, var_56);
        var_58 = wp::mul(var_46, var_43);
        var_59 = wp::add(var_57, var_58);
        var_60 = (var_55 <= var_59);
        var_63 = wp::where(var_60, var_61, var_62);
        var_64 = wp::bit_and(var_35, var_63);
        // near = near & wp.where(wp.dot(n, wp.cross(a, b)) >= -beside, 1, 0)                 <L 56>
        var_65 = wp::cross(var_8, var_10);
        var_66 = wp::dot(var_38, var_65);
        var_67 = wp::neg(var_53);
        var_68 = (var_66 >= var_67);
        var_71 = wp::where(var_68, var_69, var_70);
        var_72 = wp::bit_and(var_64, var_71);
        // near = near & wp.where(wp.dot(n, wp.cross(b, c)) >= -beside, 1, 0)                 <L 57>
        var_73 = wp::cross(var_10, var_12);
        var_74 = wp::dot(var_38, var_73);
        var_75 = wp::neg(var_53);
        var_76 = (var_74 >= var_75);
        var_79 = wp::where(var_76, var_77, var_78);
        var_80 = wp::bit_and(var_72, var_79);
        // near = near & wp.where(wp.dot(n, wp.cross(c, a)) >= -beside, 1, 0)                 <L 58>
        var_81 = wp::cross(var_12, var_8);
        var_82 = wp::dot(var_38, var_81);
        var_83 = wp::neg(var_53);
        var_84 = (var_82 >= var_83);
        var_87 = wp::where(var_84, var_85, var_86);
        var_88 = wp::bit_and(var_80, var_87);
        // touched[k] = near                                                                  <L 59>
        wp::array_store(var_2, var_5, var_88);
        // k += 1                                                                             <L 60>
        var_90 = wp::add(var_5, var_89);
        wp::assign(var_5, var_90);
    goto start_while_0;
    end_while_0:;
    // return lanes_with(touched.ptr, 0)                                                      <L 61>
    var_91 = (wp::uint64*)&(var_2.data);
    var_94 = wp::load(var_91);
    var_93 = lanes_with_0(var_94, var_92);
    return var_93;
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


// /work/main/warpsample/tracing/sight/facets.py:94
static Facet_ffcefc8d facet_of_0(
    Contacts_1da7c857 var_contacts,
    wp::int32 var_face)
{
    //---------
    // primal vars
    Facet_ffcefc8d var_0;
    wp::vec_t<3, wp::float64>* var_1;
    wp::vec_t<3, wp::float64>* var_2;
    wp::vec_t<3, wp::float64> var_3;
    wp::vec_t<3, wp::float64> var_4;
    wp::vec_t<3, wp::float64> var_5;
    wp::vec_t<3, wp::float64>* var_6;
    wp::vec_t<3, wp::float64>* var_7;
    wp::vec_t<3, wp::float64> var_8;
    wp::vec_t<3, wp::float64> var_9;
    wp::vec_t<3, wp::float64> var_10;
    wp::vec_t<3, wp::float64> var_11;
    wp::float64 var_12;
    wp::vec_t<3, wp::float64>* var_13;
    wp::vec_t<3, wp::float64>* var_14;
    wp::vec_t<3, wp::float64> var_15;
    wp::vec_t<3, wp::float64> var_16;
    wp::vec_t<3, wp::float64> var_17;
    wp::float64 var_18;
    wp::vec_t<3, wp::float64>* var_19;
    wp::vec_t<3, wp::float64>* var_20;
    wp::vec_t<3, wp::float64> var_21;
    wp::vec_t<3, wp::float64> var_22;
    wp::vec_t<3, wp::float64> var_23;
    wp::float64 var_24;
    wp::float64 var_25;
    wp::vec_t<3, wp::float64>* var_26;
    wp::vec_t<3, wp::float64>* var_27;
    wp::vec_t<3, wp::float64> var_28;
    wp::vec_t<3, wp::float64> var_29;
    wp::vec_t<3, wp::float64> var_30;
    wp::float64 var_31;
    wp::float64 var_32;
    wp::float64* var_33;
    const wp::float64 var_34 = 0.0;
    bool var_35;
    wp::float64 var_36;
    wp::float64* var_37;
    wp::vec_t<3, wp::float64> var_38;
    wp::float64 var_39;
    Facet_ffcefc8d var_40;
    Facet_ffcefc8d var_41;
    wp::float64* var_42;
    wp::float64* var_43;
    wp::float64 var_44;
    wp::float64 var_45;
    bool var_46;
    wp::float64 var_47;
    const wp::vec_t<3, wp::float64> var_48 = wp::initializer_array<3,wp::float64>{0.0, 0.0, 0.0};
    //---------
    // forward
    // def facet_of(contacts: Contacts, face: wp.int32) -> Facet:                             <L 95>
    // facet = corners_of(contacts, face)                                                     <L 97>
    var_0 = corners_of_0(var_contacts, var_face);
    // n = wp.cross(facet.b - facet.a, facet.c - facet.a)                                     <L 98>
    var_1 = &((var_0).b);
    var_2 = &((var_0).a);
    var_4 = wp::load(var_1);
    var_5 = wp::load(var_2);
    var_3 = wp::sub(var_4, var_5);
    var_6 = &((var_0).c);
    var_7 = &((var_0).a);
    var_9 = wp::load(var_6);
    var_10 = wp::load(var_7);
    var_8 = wp::sub(var_9, var_10);
    var_11 = wp::cross(var_3, var_8);
    // facet.area = wp.length(n)                                                              <L 99>
    var_12 = wp::length(var_11);
    var_0.area = var_12;
    // longest = wp.max(wp.max(wp.length(facet.b - facet.a), wp.length(facet.c - facet.b)), wp.length(facet.a - facet.c))       <L 100>
    var_13 = &((var_0).b);
    var_14 = &((var_0).a);
    var_16 = wp::load(var_13);
    var_17 = wp::load(var_14);
    var_15 = wp::sub(var_16, var_17);
    var_18 = wp::length(var_15);
    var_19 = &((var_0).c);
    var_20 = &((var_0).b);
    var_22 = wp::load(var_19);
    var_23 = wp::load(var_20);
    var_21 = wp::sub(var_22, var_23);
    var_24 = wp::length(var_21);
    var_25 = wp::max(var_18, var_24);
    var_26 = &((var_0).a);
    var_27 = &((var_0).c);
    var_29 = wp::load(var_26);
    var_30 = wp::load(var_27);
    var_28 = wp::sub(var_29, var_30);
    var_31 = wp::length(var_28);
    var_32 = wp::max(var_25, var_31);
    // if facet.area > ZERO:                                                                  <L 101>
    var_33 = &((var_0).area);
    var_36 = wp::load(var_33);
    var_35 = (var_36 > var_34);
    if (var_35) {
        // facet = with_normal(contacts, facet, n / facet.area)                               <L 102>
        var_37 = &((var_0).area);
        var_39 = wp::load(var_37);
        var_38 = wp::div(var_11, var_39);
        var_40 = with_normal_0(var_contacts, var_0, var_38);
    }
    var_41 = wp::where(var_35, var_40, var_0);
    // if facet.area <= facet.offset * longest:                                               <L 103>
    var_42 = &((var_41).area);
    var_43 = &((var_41).offset);
    var_45 = wp::load(var_43);
    var_44 = wp::mul(var_45, var_32);
    var_47 = wp::load(var_42);
    var_46 = (var_47 <= var_44);
    if (var_46) {
        // facet.n = NOWHERE                                                                  <L 104>
        var_41.n = var_48;
    }
    // return facet                                                                           <L 105>
    return var_41;
}


// /work/main/warpsample/tracing/sight/facets.py:108
static wp::float64 _inwards_0(
    Facet_ffcefc8d var_facet,
    wp::vec_t<3, wp::float64> var_start,
    wp::vec_t<3, wp::float64> var_end,
    wp::vec_t<3, wp::float64> var_p)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float64> var_0;
    wp::vec_t<3, wp::float64> var_1;
    wp::vec_t<3, wp::float64> var_2;
    wp::vec_t<3, wp::float64>* var_3;
    wp::float64 var_4;
    wp::vec_t<3, wp::float64> var_5;
    wp::float64 var_6;
    wp::float64 var_7;
    //---------
    // forward
    // def _inwards(facet: Facet, start: wp.vec3d, end: wp.vec3d, p: wp.vec3d) -> wp.float64:       <L 109>
    // edge = end - start                                                                     <L 111>
    var_0 = wp::sub(var_end, var_start);
    // return wp.dot(wp.cross(edge, p - start), facet.n) / wp.length(edge)                    <L 112>
    var_1 = wp::sub(var_p, var_start);
    var_2 = wp::cross(var_0, var_1);
    var_3 = &((var_facet).n);
    var_5 = wp::load(var_3);
    var_4 = wp::dot(var_2, var_5);
    var_6 = wp::length(var_0);
    var_7 = wp::div(var_4, var_6);
    return var_7;
}


// /work/main/warpsample/tracing/sight/facets.py:115
static wp::float64 inward_distance_0(
    Facet_ffcefc8d var_facet,
    wp::vec_t<3, wp::float64> var_p)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float64>* var_0;
    wp::vec_t<3, wp::float64>* var_1;
    wp::float64 var_2;
    wp::vec_t<3, wp::float64> var_3;
    wp::vec_t<3, wp::float64> var_4;
    wp::vec_t<3, wp::float64>* var_5;
    wp::vec_t<3, wp::float64>* var_6;
    wp::float64 var_7;
    wp::vec_t<3, wp::float64> var_8;
    wp::vec_t<3, wp::float64> var_9;
    wp::float64 var_10;
    wp::vec_t<3, wp::float64>* var_11;
    wp::vec_t<3, wp::float64>* var_12;
    wp::float64 var_13;
    wp::vec_t<3, wp::float64> var_14;
    wp::vec_t<3, wp::float64> var_15;
    wp::float64 var_16;
    //---------
    // forward
    // def inward_distance(facet: Facet, p: wp.vec3d) -> wp.float64:                          <L 116>
    // first = wp.min(_inwards(facet, facet.a, facet.b, p), _inwards(facet, facet.b, facet.c, p))       <L 118>
    var_0 = &((var_facet).a);
    var_1 = &((var_facet).b);
    var_3 = wp::load(var_0);
    var_4 = wp::load(var_1);
    var_2 = _inwards_0(var_facet, var_3, var_4, var_p);
    var_5 = &((var_facet).b);
    var_6 = &((var_facet).c);
    var_8 = wp::load(var_5);
    var_9 = wp::load(var_6);
    var_7 = _inwards_0(var_facet, var_8, var_9, var_p);
    var_10 = wp::min(var_2, var_7);
    // return wp.min(first, _inwards(facet, facet.c, facet.a, p))                             <L 119>
    var_11 = &((var_facet).c);
    var_12 = &((var_facet).a);
    var_14 = wp::load(var_11);
    var_15 = wp::load(var_12);
    var_13 = _inwards_0(var_facet, var_14, var_15, var_p);
    var_16 = wp::min(var_10, var_13);
    return var_16;
}


// /work/main/warpsample/tracing/sight/facets.py:122
static bool is_touching_0(
    Facet_ffcefc8d var_facet,
    wp::vec_t<3, wp::float64> var_p,
    wp::float64 var_moved)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float64>* var_0;
    wp::vec_t<3, wp::float64>* var_1;
    wp::vec_t<3, wp::float64> var_2;
    wp::vec_t<3, wp::float64> var_3;
    wp::float64 var_4;
    wp::vec_t<3, wp::float64> var_5;
    wp::float64 var_6;
    const wp::float64 var_7 = 2.0;
    wp::float64* var_8;
    wp::float64 var_9;
    wp::float64 var_10;
    wp::float64 var_11;
    bool var_12;
    bool var_13;
    wp::float64 var_14;
    wp::float64* var_15;
    wp::float64 var_16;
    wp::float64 var_17;
    wp::float64 var_18;
    bool var_19;
    //---------
    // forward
    // def is_touching(facet: Facet, p: wp.vec3d, moved: wp.float64) -> wp.bool:              <L 123>
    // near = wp.abs(wp.dot(facet.n, p - facet.a)) <= TWO * facet.offset + moved              <L 125>
    var_0 = &((var_facet).n);
    var_1 = &((var_facet).a);
    var_3 = wp::load(var_1);
    var_2 = wp::sub(var_p, var_3);
    var_5 = wp::load(var_0);
    var_4 = wp::dot(var_5, var_2);
    var_6 = wp::abs(var_4);
    var_8 = &((var_facet).offset);
    var_10 = wp::load(var_8);
    var_9 = wp::mul(var_7, var_10);
    var_11 = wp::add(var_9, var_moved);
    var_12 = (var_6 <= var_11);
    // return near and inward_distance(facet, p) >= -facet.slack - moved                      <L 126>
    var_13 = var_12;
    if (var_13) {
        var_14 = inward_distance_0(var_facet, var_p);
        var_15 = &((var_facet).slack);
        var_17 = wp::load(var_15);
        var_16 = wp::neg(var_17);
        var_18 = wp::sub(var_16, var_moved);
        var_19 = (var_14 >= var_18);
        var_13 = var_13 && var_19;
    }
    return var_13;
}


// /work/main/warpsample/tracing/sight/contacts.py:84
static bool _is_better_0(
    wp::float64 var_cosine,
    wp::int32 var_face,
    wp::float64 var_best,
    wp::int32 var_known)
{
    //---------
    // primal vars
    bool var_0;
    const wp::float64 var_1 = 0.0;
    bool var_2;
    bool var_3;
    const wp::int32 var_4 = 0;
    bool var_5;
    bool var_6;
    bool var_7;
    bool var_8;
    bool var_9;
    //---------
    // forward
    // def _is_better(cosine: wp.float64, face: wp.int32, best: wp.float64, known: wp.int32) -> wp.bool:       <L 85>
    // return cosine >= ZERO and (known < 0 or cosine > best or (cosine == best and face < known))       <L 90>
    var_2 = (var_cosine >= var_1);
    var_0 = var_2;
    if (var_0) {
        var_5 = (var_known < var_4);
        var_3 = var_5;
        if (!var_3) {
            var_6 = (var_cosine > var_best);
            var_3 = var_3 || var_6;
        }
        if (!var_3) {
            var_8 = (var_cosine == var_best);
            var_7 = var_8;
            if (var_7) {
                var_9 = (var_face < var_known);
                var_7 = var_7 && var_9;
            }
            var_3 = var_3 || var_7;
        }
        var_0 = var_0 && var_3;
    }
    return var_0;
}


// /work/main/warpsample/tracing/sight/contacts.py:59
static FaceContact_ae9d5902 _move_off_facet_0(
    FaceContact_ae9d5902 var_contact,
    Facet_ffcefc8d var_other)
{
    //---------
    // primal vars
    Facet_ffcefc8d* var_0;
    Facet_ffcefc8d var_1;
    Facet_ffcefc8d var_2;
    wp::float64* var_3;
    wp::vec_t<3, wp::float64>* var_4;
    wp::vec_t<3, wp::float64> var_5;
    wp::float64 var_6;
    wp::vec_t<3, wp::float64> var_7;
    wp::vec_t<3, wp::float64>* var_8;
    wp::vec_t<3, wp::float64>* var_9;
    wp::vec_t<3, wp::float64> var_10;
    wp::vec_t<3, wp::float64> var_11;
    wp::vec_t<3, wp::float64> var_12;
    wp::float64 var_13;
    wp::vec_t<3, wp::float64>* var_14;
    wp::vec_t<3, wp::float64>* var_15;
    wp::vec_t<3, wp::float64> var_16;
    wp::vec_t<3, wp::float64> var_17;
    wp::vec_t<3, wp::float64> var_18;
    wp::float64 var_19;
    wp::float64 var_20;
    wp::vec_t<3, wp::float64>* var_21;
    wp::vec_t<3, wp::float64>* var_22;
    wp::vec_t<3, wp::float64> var_23;
    wp::vec_t<3, wp::float64> var_24;
    wp::vec_t<3, wp::float64> var_25;
    wp::float64 var_26;
    wp::float64 var_27;
    wp::vec_t<3, wp::float64>* var_28;
    wp::vec_t<3, wp::float64>* var_29;
    wp::vec_t<3, wp::float64>* var_30;
    wp::vec_t<3, wp::float64> var_31;
    wp::vec_t<3, wp::float64> var_32;
    wp::vec_t<3, wp::float64> var_33;
    wp::float64 var_34;
    wp::vec_t<3, wp::float64> var_35;
    wp::vec_t<3, wp::float64>* var_36;
    wp::vec_t<3, wp::float64>* var_37;
    wp::vec_t<3, wp::float64>* var_38;
    wp::vec_t<3, wp::float64> var_39;
    wp::vec_t<3, wp::float64> var_40;
    wp::vec_t<3, wp::float64> var_41;
    wp::float64 var_42;
    wp::vec_t<3, wp::float64> var_43;
    wp::vec_t<3, wp::float64>* var_44;
    wp::vec_t<3, wp::float64>* var_45;
    wp::vec_t<3, wp::float64>* var_46;
    wp::vec_t<3, wp::float64> var_47;
    wp::vec_t<3, wp::float64> var_48;
    wp::vec_t<3, wp::float64> var_49;
    wp::float64 var_50;
    wp::vec_t<3, wp::float64> var_51;
    bool var_52;
    wp::float64 var_53;
    wp::float64 var_54;
    wp::float64* var_55;
    bool var_56;
    wp::float64 var_57;
    wp::float64 var_58;
    wp::float64 var_59;
    wp::float64* var_60;
    wp::float64 var_61;
    wp::float64 var_62;
    bool var_63;
    bool var_64;
    wp::vec_t<3, wp::float64>* var_65;
    wp::float64 var_66;
    wp::vec_t<3, wp::float64> var_67;
    wp::float64* var_68;
    bool var_69;
    wp::float64 var_70;
    wp::float64 var_71;
    wp::float64 var_72;
    const wp::float64 var_73 = 0.3333333333333333;
    wp::float64 var_74;
    wp::vec_t<3, wp::float64>* var_75;
    wp::vec_t<3, wp::float64>* var_76;
    wp::vec_t<3, wp::float64>* var_77;
    wp::vec_t<3, wp::float64> var_78;
    wp::vec_t<3, wp::float64> var_79;
    wp::vec_t<3, wp::float64> var_80;
    wp::float64 var_81;
    wp::vec_t<3, wp::float64> var_82;
    wp::float64 var_83;
    wp::float64* var_84;
    const wp::float64 var_85 = 1.0;
    wp::float64 var_86;
    wp::float64 var_87;
    wp::float64 var_88;
    wp::vec_t<3, wp::float64>* var_89;
    wp::vec_t<3, wp::float64>* var_90;
    wp::vec_t<3, wp::float64>* var_91;
    wp::vec_t<3, wp::float64> var_92;
    wp::vec_t<3, wp::float64> var_93;
    wp::vec_t<3, wp::float64> var_94;
    wp::float64 var_95;
    wp::vec_t<3, wp::float64> var_96;
    wp::float64 var_97;
    bool var_98;
    wp::float64* var_99;
    bool var_100;
    wp::float64 var_101;
    const wp::float64 var_102 = 0.5;
    wp::float64* var_103;
    wp::float64 var_104;
    wp::float64 var_105;
    bool var_106;
    wp::vec_t<3, wp::float64>* var_107;
    wp::float64* var_108;
    wp::float64 var_109;
    wp::float64 var_110;
    wp::float64 var_111;
    wp::vec_t<3, wp::float64>* var_112;
    wp::vec_t<3, wp::float64> var_113;
    wp::vec_t<3, wp::float64> var_114;
    wp::vec_t<3, wp::float64> var_115;
    wp::vec_t<3, wp::float64> var_116;
    wp::float64 var_117;
    wp::float64* var_118;
    wp::float64 var_119;
    wp::float64 var_120;
    bool var_121;
    wp::float64* var_122;
    wp::float64* var_123;
    wp::float64 var_124;
    wp::float64 var_125;
    wp::float64 var_126;
    wp::float64 var_127;
    wp::float64 var_128;
    wp::float64 var_129;
    //---------
    // forward
    // def _move_off_facet(contact: FaceContact, other: Facet) -> FaceContact:                <L 60>
    // own = contact.facet                                                                    <L 65>
    var_0 = &((var_contact).facet);
    var_2 = wp::load(var_0);
    var_1 = wp::copy(var_2);
    // up = contact.side * own.n                                                              <L 66>
    var_3 = &((var_contact).side);
    var_4 = &((var_1).n);
    var_6 = wp::load(var_3);
    var_7 = wp::load(var_4);
    var_5 = wp::mul(var_6, var_7);
    // rises = wp.max(wp.max(wp.dot(up, other.a - own.a), wp.dot(up, other.b - own.a)), wp.dot(up, other.c - own.a))       <L 67>
    var_8 = &((var_other).a);
    var_9 = &((var_1).a);
    var_11 = wp::load(var_8);
    var_12 = wp::load(var_9);
    var_10 = wp::sub(var_11, var_12);
    var_13 = wp::dot(var_5, var_10);
    var_14 = &((var_other).b);
    var_15 = &((var_1).a);
    var_17 = wp::load(var_14);
    var_18 = wp::load(var_15);
    var_16 = wp::sub(var_17, var_18);
    var_19 = wp::dot(var_5, var_16);
    var_20 = wp::max(var_13, var_19);
    var_21 = &((var_other).c);
    var_22 = &((var_1).a);
    var_24 = wp::load(var_21);
    var_25 = wp::load(var_22);
    var_23 = wp::sub(var_24, var_25);
    var_26 = wp::dot(var_5, var_23);
    var_27 = wp::max(var_20, var_26);
    // a = wp.dot(other.n, own.a - other.a)                                                   <L 68>
    var_28 = &((var_other).n);
    var_29 = &((var_1).a);
    var_30 = &((var_other).a);
    var_32 = wp::load(var_29);
    var_33 = wp::load(var_30);
    var_31 = wp::sub(var_32, var_33);
    var_35 = wp::load(var_28);
    var_34 = wp::dot(var_35, var_31);
    // b = wp.dot(other.n, own.b - other.a)                                                   <L 69>
    var_36 = &((var_other).n);
    var_37 = &((var_1).b);
    var_38 = &((var_other).a);
    var_40 = wp::load(var_37);
    var_41 = wp::load(var_38);
    var_39 = wp::sub(var_40, var_41);
    var_43 = wp::load(var_36);
    var_42 = wp::dot(var_43, var_39);
    // c = wp.dot(other.n, own.c - other.a)                                                   <L 70>
    var_44 = &((var_other).n);
    var_45 = &((var_1).c);
    var_46 = &((var_other).a);
    var_48 = wp::load(var_45);
    var_49 = wp::load(var_46);
    var_47 = wp::sub(var_48, var_49);
    var_51 = wp::load(var_44);
    var_50 = wp::dot(var_51, var_47);
    // across = wp.max(wp.max(a, b), c) > other.offset and wp.min(wp.min(a, b), c) < -other.offset       <L 71>
    var_53 = wp::max(var_34, var_42);
    var_54 = wp::max(var_53, var_50);
    var_55 = &((var_other).offset);
    var_57 = wp::load(var_55);
    var_56 = (var_54 > var_57);
    var_52 = var_56;
    if (var_52) {
        var_58 = wp::min(var_34, var_42);
        var_59 = wp::min(var_58, var_50);
        var_60 = &((var_other).offset);
        var_62 = wp::load(var_60);
        var_61 = wp::neg(var_62);
        var_63 = (var_59 < var_61);
        var_52 = var_52 && var_63;
    }
    // across = across and inward_distance(own, contact.p) > own.slack  # and the point is not at an edge       <L 72>
    var_64 = var_52;
    if (var_64) {
        var_65 = &((var_contact).p);
        var_67 = wp::load(var_65);
        var_66 = inward_distance_0(var_1, var_67);
        var_68 = &((var_1).slack);
        var_70 = wp::load(var_68);
        var_69 = (var_66 > var_70);
        var_64 = var_64 && var_69;
    }
    // gain = (a + b + c) * _THIRD - wp.dot(other.n, contact.p - other.a)                     <L 73>
    var_71 = wp::add(var_34, var_42);
    var_72 = wp::add(var_71, var_50);
    var_74 = wp::mul(var_72, var_73);
    var_75 = &((var_other).n);
    var_76 = &((var_contact).p);
    var_77 = &((var_other).a);
    var_79 = wp::load(var_76);
    var_80 = wp::load(var_77);
    var_78 = wp::sub(var_79, var_80);
    var_82 = wp::load(var_75);
    var_81 = wp::dot(var_82, var_78);
    var_83 = wp::sub(var_74, var_81);
    // side = wp.where(across, contact.side, wp.copysign(ONE, gain))                          <L 74>
    var_84 = &((var_contact).side);
    var_86 = wp::copysign(var_85, var_83);
    var_88 = wp::load(var_84);
    var_87 = wp::where(var_64, var_88, var_86);
    // height = side * wp.dot(other.n, contact.o - other.a)                                   <L 75>
    var_89 = &((var_other).n);
    var_90 = &((var_contact).o);
    var_91 = &((var_other).a);
    var_93 = wp::load(var_90);
    var_94 = wp::load(var_91);
    var_92 = wp::sub(var_93, var_94);
    var_96 = wp::load(var_89);
    var_95 = wp::dot(var_96, var_92);
    var_97 = wp::mul(var_87, var_95);
    // if rises > own.offset and height < HALF * other.offset:                                <L 76>
    var_99 = &((var_1).offset);
    var_101 = wp::load(var_99);
    var_100 = (var_27 > var_101);
    var_98 = var_100;
    if (var_98) {
        var_103 = &((var_other).offset);
        var_105 = wp::load(var_103);
        var_104 = wp::mul(var_102, var_105);
        var_106 = (var_97 < var_104);
        var_98 = var_98 && var_106;
    }
    if (var_98) {
        // if across:                                                                         <L 77>
        if (var_64) {
            // contact.aside += (side * (other.offset - height)) * other.n                    <L 78>
            var_107 = &((var_contact).aside);
            var_108 = &((var_other).offset);
            var_110 = wp::load(var_108);
            var_109 = wp::sub(var_110, var_97);
            var_111 = wp::mul(var_87, var_109);
            var_112 = &((var_other).n);
            var_114 = wp::load(var_112);
            var_113 = wp::mul(var_111, var_114);
            var_116 = wp::load(var_107);
            var_115 = wp::add(var_116, var_113);
            var_contact.aside = var_115;
        }
        if (!var_64) {
            // elif wp.abs(gain) > _THIRD * other.offset:                                     <L 79>
            var_117 = wp::abs(var_83);
            var_118 = &((var_other).offset);
            var_120 = wp::load(var_118);
            var_119 = wp::mul(var_73, var_120);
            var_121 = (var_117 > var_119);
            if (var_121) {
                // contact.inwards = wp.max(contact.inwards, (other.offset - height) / wp.abs(gain))       <L 80>
                var_122 = &((var_contact).inwards);
                var_123 = &((var_other).offset);
                var_125 = wp::load(var_123);
                var_124 = wp::sub(var_125, var_97);
                var_126 = wp::abs(var_83);
                var_127 = wp::div(var_124, var_126);
                var_129 = wp::load(var_122);
                var_128 = wp::max(var_129, var_127);
                var_contact.inwards = var_128;
            }
        }
    }
    // return contact                                                                         <L 81>
    return var_contact;
}


// /work/main/warpsample/tracing/sight/contacts.py:93
static FaceContact_ae9d5902 _look_at_other_0(
    Contacts_1da7c857 var_contacts,
    FaceContact_ae9d5902 var_contact,
    wp::int32 var_face,
    wp::vec_t<3, wp::float64> var_look,
    bool var_searching)
{
    //---------
    // primal vars
    Facet_ffcefc8d var_0;
    wp::vec_t<3, wp::float64>* var_1;
    wp::vec_t<3, wp::float64>* var_2;
    wp::float64 var_3;
    wp::vec_t<3, wp::float64> var_4;
    wp::vec_t<3, wp::float64> var_5;
    const wp::float64 var_6 = 0.0;
    bool var_7;
    wp::int32* var_8;
    const wp::int32 var_9 = -1;
    bool var_10;
    wp::int32 var_11;
    const wp::int32 var_12 = -2;
    wp::vec_t<3, wp::float64>* var_13;
    wp::float64* var_14;
    bool var_15;
    wp::vec_t<3, wp::float64> var_16;
    wp::float64 var_17;
    wp::vec_t<3, wp::float64>* var_18;
    wp::float64 var_19;
    wp::vec_t<3, wp::float64> var_20;
    wp::float64* var_21;
    wp::float64* var_22;
    wp::float64 var_23;
    wp::float64 var_24;
    wp::float64 var_25;
    wp::float64 var_26;
    wp::float64* var_27;
    wp::int32* var_28;
    bool var_29;
    wp::float64 var_30;
    wp::int32 var_31;
    wp::float64 var_32;
    wp::float64* var_33;
    wp::int32* var_34;
    bool var_35;
    wp::float64 var_36;
    wp::int32 var_37;
    wp::float64 var_38;
    FaceContact_ae9d5902 var_39;
    FaceContact_ae9d5902 var_40;
    FaceContact_ae9d5902 var_41;
    FaceContact_ae9d5902 var_42;
    //---------
    // forward
    // def _look_at_other(                                                                    <L 94>
    // facet = facet_of(contacts, face)                                                       <L 98>
    var_0 = facet_of_0(var_contacts, var_face);
    // if wp.dot(facet.n, facet.n) == ZERO:                                                   <L 99>
    var_1 = &((var_0).n);
    var_2 = &((var_0).n);
    var_4 = wp::load(var_1);
    var_5 = wp::load(var_2);
    var_3 = wp::dot(var_4, var_5);
    var_7 = (var_3 == var_6);
    if (var_7) {
        // if contact.own == -1:                                                              <L 100>
        var_8 = &((var_contact).own);
        var_11 = wp::load(var_8);
        var_10 = (var_11 == var_9);
        if (var_10) {
            // contact.own = _THIN                                                            <L 101>
            var_contact.own = var_12;
        }
    }
    if (!var_7) {
        // elif is_touching(facet, contact.p, contact.moved):                                 <L 102>
        var_13 = &((var_contact).p);
        var_14 = &((var_contact).moved);
        var_16 = wp::load(var_13);
        var_17 = wp::load(var_14);
        var_15 = is_touching_0(var_0, var_16, var_17);
        if (var_15) {
            // if searching:                                                                  <L 103>
            if (var_searching) {
                // cosine = wp.dot(facet.n, look)                                             <L 104>
                var_18 = &((var_0).n);
                var_20 = wp::load(var_18);
                var_19 = wp::dot(var_20, var_look);
                // contact.ahead += cosine * facet.area                                       <L 105>
                var_21 = &((var_contact).ahead);
                var_22 = &((var_0).area);
                var_24 = wp::load(var_22);
                var_23 = wp::mul(var_19, var_24);
                var_26 = wp::load(var_21);
                var_25 = wp::add(var_26, var_23);
                var_contact.ahead = var_25;
                // if _is_better(cosine, face, contact.best_along, contact.along):            <L 106>
                var_27 = &((var_contact).best_along);
                var_28 = &((var_contact).along);
                var_30 = wp::load(var_27);
                var_31 = wp::load(var_28);
                var_29 = _is_better_0(var_19, var_face, var_30, var_31);
                if (var_29) {
                    // contact.best_along = cosine                                            <L 107>
                    var_contact.best_along = var_19;
                    // contact.along = face                                                   <L 108>
                    var_contact.along = var_face;
                }
                // if _is_better(-cosine, face, contact.best_against, contact.against):       <L 109>
                var_32 = wp::neg(var_19);
                var_33 = &((var_contact).best_against);
                var_34 = &((var_contact).against);
                var_36 = wp::load(var_33);
                var_37 = wp::load(var_34);
                var_35 = _is_better_0(var_32, var_face, var_36, var_37);
                if (var_35) {
                    // contact.best_against = -cosine                                         <L 110>
                    var_38 = wp::neg(var_19);
                    var_contact.best_against = var_38;
                    // contact.against = face                                                 <L 111>
                    var_contact.against = var_face;
                }
            }
            if (!var_searching) {
                // contact = _move_off_facet(contact, facet)                                  <L 113>
                var_39 = _move_off_facet_0(var_contact, var_0);
            }
            var_40 = wp::where(var_searching, var_contact, var_39);
        }
        var_41 = wp::where(var_15, var_40, var_contact);
    }
    var_42 = wp::where(var_7, var_contact, var_41);
    // return contact                                                                         <L 114>
    return var_42;
}


// /work/main/warpsample/tracing/sight/contacts.py:136
static FaceContact_ae9d5902 _look_at_0(
    wp::int32 var_face,
    Around_9296a408 var_around,
    FaceContact_ae9d5902 var_contact)
{
    //---------
    // primal vars
    wp::int32* var_0;
    bool var_1;
    wp::int32 var_2;
    const bool var_3 = false;
    bool var_4;
    Contacts_1da7c857* var_5;
    wp::vec_t<3, wp::float64>* var_6;
    bool* var_7;
    FaceContact_ae9d5902 var_8;
    Contacts_1da7c857 var_9;
    wp::vec_t<3, wp::float64> var_10;
    bool var_11;
    FaceContact_ae9d5902 var_12;
    //---------
    // forward
    // def _look_at(face: wp.int32, around: Around, contact: FaceContact) -> FaceContact:       <L 137>
    // if face != contact.own:                                                                <L 139>
    var_0 = &((var_contact).own);
    var_2 = wp::load(var_0);
    var_1 = (var_face != var_2);
    if (var_1) {
        // contact.alone = wp.bool(False)                                                     <L 140>
        var_4 = bool(var_3);
        var_contact.alone = var_4;
        // contact = _look_at_other(around.contacts, contact, face, around.look, around.searching)       <L 141>
        var_5 = &((var_around).contacts);
        var_6 = &((var_around).look);
        var_7 = &((var_around).searching);
        var_9 = wp::load(var_5);
        var_10 = wp::load(var_6);
        var_11 = wp::load(var_7);
        var_8 = _look_at_other_0(var_9, var_contact, var_face, var_10, var_11);
    }
    var_12 = wp::where(var_1, var_8, var_contact);
    // return contact                                                                         <L 142>
    return var_12;
}


// /work/main/warpsample/tracing/sight/touching.py:81
static void faces_touching__locals__look_into_0(
    wp::uint64 var_leaf,
    Around_9296a408 var_query,
    FaceContact_ae9d5902 var_answer,
    FaceContact_ae9d5902 & ret_0,
    bool & ret_1)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float32>* var_0;
    wp::float32* var_1;
    wp::int32 var_2;
    wp::vec_t<3, wp::float32> var_3;
    wp::float32 var_4;
    wp::int32 var_5;
    wp::range_t var_6;
    wp::int32 var_7;
    wp::int32 var_8;
    wp::int32 var_9;
    FaceContact_ae9d5902 var_10;
    const wp::int32 var_11 = 1;
    wp::int32 var_12;
    wp::int32 var_13;
    const bool var_14 = false;
    bool var_15;
    //---------
    // forward
    // def look_into(leaf: wp.uint64, query: query_type, answer: answer_type):                <L 82>
    // touched = _triangles_near_point(leaf, query.p, query.r)                                <L 83>
    var_0 = &((var_query).p);
    var_1 = &((var_query).r);
    var_3 = wp::load(var_0);
    var_4 = wp::load(var_1);
    var_2 = _triangles_near_point_0(var_leaf, var_3, var_4);
    // for _ in range(wp.bit_count(touched)):                                                 <L 84>
    var_5 = wp::bit_count(var_2);
    var_6 = wp::range(var_5);
    start_for_0:;
        if (iter_cmp(var_6) == 0) goto end_for_0;
        var_7 = wp::iter_next(var_6);
        // answer = look(face_in(leaf, lowest_bit(touched)), query, answer)                   <L 85>
        var_8 = lowest_bit_0(var_2);
        var_9 = face_in_0(var_leaf, var_8);
        var_10 = _look_at_0(var_9, var_query, var_answer);
        // touched = touched & (touched - 1)                                                  <L 86>
        var_12 = wp::sub(var_2, var_11);
        var_13 = wp::bit_and(var_2, var_12);
        wp::assign(var_answer, var_10);
        wp::assign(var_2, var_13);
        goto start_for_0;
    end_for_0:;
    // return answer, wp.bool(False)                                                          <L 87>
    var_15 = bool(var_14);
    ret_0 = var_answer;
    ret_1 = var_15;
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
static void tree_walk__locals__walk_0(
    Accelerator_9fc73cd7 var_tree,
    Around_9296a408 var_query,
    FaceContact_ae9d5902 var_answer,
    wp::int32 var_visits,
    wp::uint64 var_scratch,
    FaceContact_ae9d5902 & ret_0,
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
    FaceContact_ae9d5902 var_40;
    bool var_41;
    const wp::int32 var_42 = 0;
    bool var_43;
    const wp::float32 var_44 = 0.0;
    wp::uint64 var_45;
    wp::uint64 var_46;
    wp::uint64 var_47;
    wp::int32 var_48;
    FaceContact_ae9d5902 var_49;
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
    FaceContact_ae9d5902 var_75;
    wp::int32 var_76;
    wp::uint64 var_77;
    wp::uint64 var_78;
    wp::int32 var_79;
    bool var_80;
    bool var_81;
    FaceContact_ae9d5902 var_82;
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
            var_26 = faces_touching__locals__enter_0(var_16, var_query);
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
                    faces_touching__locals__look_into_0(var_39, var_query, var_answer, var_40, var_41);
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


// /work/main/warpsample/tracing/sight/touching.py:91
static FaceContact_ae9d5902 faces_touching__locals__look_around_0(
    Accelerator_9fc73cd7 var_tree,
    Around_9296a408 var_query,
    FaceContact_ae9d5902 var_answer,
    wp::uint64 var_scratch)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    FaceContact_ae9d5902 var_1;
    bool var_2;
    //---------
    // forward
    // def look_around(tree: Accelerator, query: query_type, answer: answer_type, scratch: wp.uint64):       <L 92>
    // answer, _spent = walk(tree, query, answer, 0, scratch)                                 <L 93>
    tree_walk__locals__walk_0(var_tree, var_query, var_answer, var_0, var_scratch, var_1, var_2);
    // return answer                                                                          <L 94>
    return var_1;
}


// /work/main/warpsample/tracing/sight/contacts.py:148
static FaceContact_ae9d5902 look_around_0(
    Contacts_1da7c857 var_contacts,
    Accelerator_9fc73cd7 var_tree,
    FaceContact_ae9d5902 var_contact,
    wp::vec_t<3, wp::float64> var_look,
    bool var_searching,
    wp::uint64 var_scratch)
{
    //---------
    // primal vars
    Placement_e6d83c4e* var_0;
    wp::vec_t<3, wp::float32>* var_1;
    wp::vec_t<3, wp::float32> var_2;
    wp::vec_t<3, wp::float32> var_3;
    Around_9296a408 var_4;
    wp::vec_t<3, wp::float64>* var_5;
    wp::vec_t<3, wp::float32> var_6;
    wp::vec_t<3, wp::float64> var_7;
    const wp::float32 var_8 = 2.0;
    const wp::float32 var_9 = 3.814697265625e-06;
    wp::float32 var_10;
    const wp::int32 var_11 = 0;
    wp::float32 var_12;
    const wp::int32 var_13 = 1;
    wp::float32 var_14;
    wp::float32 var_15;
    const wp::int32 var_16 = 2;
    wp::float32 var_17;
    wp::float32 var_18;
    wp::float32 var_19;
    const wp::float32 var_20 = 4.0;
    Placement_e6d83c4e* var_21;
    wp::float32* var_22;
    wp::float32 var_23;
    wp::float32 var_24;
    wp::float32 var_25;
    FaceContact_ae9d5902 var_26;
    //---------
    // forward
    // def look_around(                                                                       <L 149>
    // extent = contacts.placement.extent                                                     <L 156>
    var_0 = &((var_contacts).placement);
    var_1 = &(((var_contacts).placement).extent);
    var_3 = wp::load(var_1);
    var_2 = wp::copy(var_3);
    // around = Around()                                                                      <L 157>
    var_4 = Around_9296a408();
    // around.contacts = contacts                                                             <L 158>
    var_4.contacts = var_contacts;
    // around.p = wp.vec3(contact.p)                                                          <L 159>
    var_5 = &((var_contact).p);
    var_7 = wp::load(var_5);
    var_6 = wp::vec_t<3, wp::float32>(var_7);
    var_4.p = var_6;
    // around.r = 2.0 * _TWICE * (extent[0] + extent[1] + extent[2]) + 4.0 * contacts.placement.coarseness       <L 160>
    var_10 = wp::mul(var_8, var_9);
    var_12 = wp::extract(var_2, var_11);
    var_14 = wp::extract(var_2, var_13);
    var_15 = wp::add(var_12, var_14);
    var_17 = wp::extract(var_2, var_16);
    var_18 = wp::add(var_15, var_17);
    var_19 = wp::mul(var_10, var_18);
    var_21 = &((var_contacts).placement);
    var_22 = &(((var_contacts).placement).coarseness);
    var_24 = wp::load(var_22);
    var_23 = wp::mul(var_20, var_24);
    var_25 = wp::add(var_19, var_23);
    var_4.r = var_25;
    // around.look = look                                                                     <L 161>
    var_4.look = var_look;
    // around.searching = searching                                                           <L 162>
    var_4.searching = var_searching;
    // return _look_around(tree, around, contact, scratch)                                    <L 163>
    var_26 = faces_touching__locals__look_around_0(var_tree, var_4, var_contact, var_scratch);
    return var_26;
}


// /work/main/warpsample/tracing/sight/contacts.py:166
static wp::int32 find_own_face_0(
    FaceContact_ae9d5902 var_contact)
{
    //---------
    // primal vars
    wp::float64* var_0;
    const wp::float64 var_1 = 0.9999990463256836;
    bool var_2;
    wp::float64 var_3;
    wp::float64* var_4;
    bool var_5;
    wp::float64 var_6;
    wp::float64* var_7;
    const wp::float64 var_8 = 0.0;
    bool var_9;
    wp::float64 var_10;
    bool var_11;
    bool var_12;
    bool var_13;
    wp::int32* var_14;
    wp::int32* var_15;
    wp::int32 var_16;
    wp::int32 var_17;
    wp::int32 var_18;
    const wp::int32 var_19 = 0;
    bool var_20;
    wp::int32* var_21;
    wp::int32 var_22;
    wp::int32 var_23;
    //---------
    // forward
    // def find_own_face(contact: FaceContact) -> wp.int32:                                   <L 167>
    // along = contact.best_along > _SAME                                                     <L 173>
    var_0 = &((var_contact).best_along);
    var_3 = wp::load(var_0);
    var_2 = (var_3 > var_1);
    // against = contact.best_against > _SAME                                                 <L 174>
    var_4 = &((var_contact).best_against);
    var_6 = wp::load(var_4);
    var_5 = (var_6 > var_1);
    // forward = contact.ahead >= ZERO                                                        <L 175>
    var_7 = &((var_contact).ahead);
    var_10 = wp::load(var_7);
    var_9 = (var_10 >= var_8);
    // if along != against:                                                                   <L 176>
    var_11 = (var_2 != var_5);
    if (var_11) {
        // forward = along                                                                    <L 177>
        var_12 = wp::copy(var_2);
    }
    var_13 = wp::where(var_11, var_12, var_9);
    // found = wp.where(forward, contact.along, contact.against)                              <L 178>
    var_14 = &((var_contact).along);
    var_15 = &((var_contact).against);
    var_17 = wp::load(var_14);
    var_18 = wp::load(var_15);
    var_16 = wp::where(var_13, var_17, var_18);
    // return wp.where(found >= 0, found, contact.own)                                        <L 179>
    var_20 = (var_16 >= var_19);
    var_21 = &((var_contact).own);
    var_23 = wp::load(var_21);
    var_22 = wp::where(var_20, var_16, var_23);
    return var_22;
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


// /work/main/warpsample/tracing/sight/contacts.py:214
static wp::vec_t<3, wp::float32> start_of_0(
    Contacts_1da7c857 var_contacts,
    FaceContact_ae9d5902 var_contact,
    wp::vec_t<3, wp::float64> var_look)
{
    //---------
    // primal vars
    wp::int32* var_0;
    const wp::int32 var_1 = -2;
    bool var_2;
    wp::int32 var_3;
    wp::vec_t<3, wp::float32> var_4;
    wp::vec_t<3, wp::float64>* var_5;
    wp::vec_t<3, wp::float32> var_6;
    wp::vec_t<3, wp::float64> var_7;
    Placement_e6d83c4e* var_8;
    wp::float32 var_9;
    Placement_e6d83c4e var_10;
    wp::vec_t<3, wp::float32> var_11;
    wp::vec_t<3, wp::float32> var_12;
    Facet_ffcefc8d* var_13;
    wp::vec_t<3, wp::float64>* var_14;
    Facet_ffcefc8d* var_15;
    wp::vec_t<3, wp::float64>* var_16;
    wp::float64 var_17;
    wp::vec_t<3, wp::float64> var_18;
    wp::vec_t<3, wp::float64> var_19;
    const wp::float64 var_20 = 0.0;
    bool var_21;
    wp::vec_t<3, wp::float64>* var_22;
    wp::vec_t<3, wp::float32> var_23;
    wp::vec_t<3, wp::float64> var_24;
    Facet_ffcefc8d* var_25;
    wp::vec_t<3, wp::float64>* var_26;
    Facet_ffcefc8d* var_27;
    wp::vec_t<3, wp::float64>* var_28;
    wp::vec_t<3, wp::float64> var_29;
    wp::vec_t<3, wp::float64> var_30;
    wp::vec_t<3, wp::float64> var_31;
    Facet_ffcefc8d* var_32;
    wp::vec_t<3, wp::float64>* var_33;
    wp::vec_t<3, wp::float64> var_34;
    wp::vec_t<3, wp::float64> var_35;
    const wp::float64 var_36 = 0.3333333333333333;
    wp::vec_t<3, wp::float64> var_37;
    wp::vec_t<3, wp::float64>* var_38;
    wp::float64* var_39;
    const wp::float64 var_40 = 0.5;
    wp::float64 var_41;
    wp::float64 var_42;
    wp::vec_t<3, wp::float64>* var_43;
    wp::vec_t<3, wp::float64> var_44;
    wp::vec_t<3, wp::float64> var_45;
    wp::vec_t<3, wp::float64> var_46;
    wp::vec_t<3, wp::float64> var_47;
    wp::vec_t<3, wp::float64> var_48;
    wp::vec_t<3, wp::float64>* var_49;
    wp::vec_t<3, wp::float64> var_50;
    wp::vec_t<3, wp::float64> var_51;
    wp::vec_t<3, wp::float32> var_52;
    //---------
    // forward
    // def start_of(contacts: Contacts, contact: FaceContact, look: wp.vec3d) -> wp.vec3:       <L 215>
    // if contact.own == _THIN:                                                               <L 217>
    var_0 = &((var_contact).own);
    var_3 = wp::load(var_0);
    var_2 = (var_3 == var_1);
    if (var_2) {
        // towards = wp.vec3(look)                                                            <L 218>
        var_4 = wp::vec_t<3, wp::float32>(var_look);
        // return wp.vec3(contact.p) + origin_offset(contacts.placement, towards) * towards       <L 219>
        var_5 = &((var_contact).p);
        var_7 = wp::load(var_5);
        var_6 = wp::vec_t<3, wp::float32>(var_7);
        var_8 = &((var_contacts).placement);
        var_10 = wp::load(var_8);
        var_9 = origin_offset_0(var_10, var_4);
        var_11 = wp::mul(var_9, var_4);
        var_12 = wp::add(var_6, var_11);
        return var_12;
    }
    // if wp.dot(contact.facet.n, contact.facet.n) == ZERO:                                   <L 220>
    var_13 = &((var_contact).facet);
    var_14 = &(((var_contact).facet).n);
    var_15 = &((var_contact).facet);
    var_16 = &(((var_contact).facet).n);
    var_18 = wp::load(var_14);
    var_19 = wp::load(var_16);
    var_17 = wp::dot(var_18, var_19);
    var_21 = (var_17 == var_20);
    if (var_21) {
        // return wp.vec3(contact.p)                                                          <L 221>
        var_22 = &((var_contact).p);
        var_24 = wp::load(var_22);
        var_23 = wp::vec_t<3, wp::float32>(var_24);
        return var_23;
    }
    // middle = (contact.facet.a + contact.facet.b + contact.facet.c) * _THIRD                <L 222>
    var_25 = &((var_contact).facet);
    var_26 = &(((var_contact).facet).a);
    var_27 = &((var_contact).facet);
    var_28 = &(((var_contact).facet).b);
    var_30 = wp::load(var_26);
    var_31 = wp::load(var_28);
    var_29 = wp::add(var_30, var_31);
    var_32 = &((var_contact).facet);
    var_33 = &(((var_contact).facet).c);
    var_35 = wp::load(var_33);
    var_34 = wp::add(var_29, var_35);
    var_37 = wp::mul(var_34, var_36);
    // return wp.vec3(contact.o + wp.min(contact.inwards, HALF) * (middle - contact.p) + contact.aside)       <L 223>
    var_38 = &((var_contact).o);
    var_39 = &((var_contact).inwards);
    var_42 = wp::load(var_39);
    var_41 = wp::min(var_42, var_40);
    var_43 = &((var_contact).p);
    var_45 = wp::load(var_43);
    var_44 = wp::sub(var_37, var_45);
    var_46 = wp::mul(var_41, var_44);
    var_48 = wp::load(var_38);
    var_47 = wp::add(var_48, var_46);
    var_49 = &((var_contact).aside);
    var_51 = wp::load(var_49);
    var_50 = wp::add(var_47, var_51);
    var_52 = wp::vec_t<3, wp::float32>(var_50);
    return var_52;
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


// /work/main/warpsample/maths/memory.py:0
static void adj__reader__locals__read_1(
    wp::uint64 var_address,
    wp::int64 var_i,
    wp::uint64 & adj_address,
    wp::int64 & adj_i,
    wp::int32 & adj_ret)
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


// /work/main/warpsample/maths/numerics.py:217
static void adj_normalize_0(
    wp::vec_t<3, wp::float32> var_v,
    wp::vec_t<3, wp::float32> & adj_v,
    wp::vec_t<3, wp::float32> & adj_ret)
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


// /work/main/warpsample/tracing/starts.py:96
static void adj__is_raised_0(
    Contacts_1da7c857 var_contacts,
    wp::int64 var_i,
    Contacts_1da7c857 & adj_contacts,
    wp::int64 & adj_i,
    bool & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/contacts.py:201
static void adj_start_above_0(
    Contacts_1da7c857 var_contacts,
    wp::vec_t<3, wp::float64> var_p,
    wp::vec_t<3, wp::float64> var_look,
    Contacts_1da7c857 & adj_contacts,
    wp::vec_t<3, wp::float64> & adj_p,
    wp::vec_t<3, wp::float64> & adj_look,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/maths/memory.py:0
static void adj__writer__locals__write_3(
    wp::uint64 var_address,
    wp::int64 var_i,
    wp::vec_t<3, wp::float32> var_x,
    wp::uint64 & adj_address,
    wp::int64 & adj_i,
    wp::vec_t<3, wp::float32> & adj_x)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/starts.py:105
static void adj__set_start_0(
    Contacts_1da7c857 var_contacts,
    wp::int64 var_i,
    wp::int32 var_side,
    wp::vec_t<3, wp::float32> var_start,
    Contacts_1da7c857 & adj_contacts,
    wp::int64 & adj_i,
    wp::int32 & adj_side,
    wp::vec_t<3, wp::float32> & adj_start)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
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


// /work/main/warpsample/tracing/sight/facets.py:83
static void adj_corners_of_0(
    Contacts_1da7c857 var_contacts,
    wp::int32 var_face,
    Contacts_1da7c857 & adj_contacts,
    wp::int32 & adj_face,
    Facet_ffcefc8d & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/facets.py:66
static void adj_with_normal_0(
    Contacts_1da7c857 var_contacts,
    Facet_ffcefc8d var_facet,
    wp::vec_t<3, wp::float64> var_n,
    Contacts_1da7c857 & adj_contacts,
    Facet_ffcefc8d & adj_facet,
    wp::vec_t<3, wp::float64> & adj_n,
    Facet_ffcefc8d & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/contacts.py:182
static void adj_raise_start_0(
    Contacts_1da7c857 var_contacts,
    FaceContact_ae9d5902 var_contact,
    wp::vec_t<3, wp::float64> var_look,
    bool var_known,
    Contacts_1da7c857 & adj_contacts,
    FaceContact_ae9d5902 & adj_contact,
    wp::vec_t<3, wp::float64> & adj_look,
    bool & adj_known,
    FaceContact_ae9d5902 & adj_ret)
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


// /work/main/warpsample/tracing/wide/lanes.py:6
static CUDA_CALLABLE void adj_lanes_with_0(
    wp::uint64 row,
    wp::int32 bit,
    wp::uint64 & adj_row,
    wp::int32 & adj_bit,
    wp::int32 & adj_ret)
{
}


// /work/main/warpsample/tracing/sight/touching.py:18
static void adj__children_around_0(
    wp::uint64 var_node,
    wp::vec_t<3, wp::float32> var_p,
    wp::float32 var_r,
    wp::uint64 & adj_node,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::float32 & adj_r,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/touching.py:77
static void adj_faces_touching__locals__enter_0(
    wp::uint64 var_node,
    Around_9296a408 var_query,
    wp::uint64 & adj_node,
    Around_9296a408 & adj_query,
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


// /work/main/warpsample/tracing/sight/touching.py:34
static void adj__is_near_zero_0(
    wp::float32 var_a,
    wp::float32 var_b,
    wp::float32 var_c,
    wp::float32 var_r,
    wp::float32 & adj_a,
    wp::float32 & adj_b,
    wp::float32 & adj_c,
    wp::float32 & adj_r,
    wp::int32 & adj_ret)
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


// /work/main/warpsample/tracing/sight/touching.py:40
static void adj__triangles_near_point_0(
    wp::uint64 var_leaf,
    wp::vec_t<3, wp::float32> var_p,
    wp::float32 var_r,
    wp::uint64 & adj_leaf,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::float32 & adj_r,
    wp::int32 & adj_ret)
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


// /work/main/warpsample/tracing/sight/facets.py:94
static void adj_facet_of_0(
    Contacts_1da7c857 var_contacts,
    wp::int32 var_face,
    Contacts_1da7c857 & adj_contacts,
    wp::int32 & adj_face,
    Facet_ffcefc8d & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/facets.py:108
static void adj__inwards_0(
    Facet_ffcefc8d var_facet,
    wp::vec_t<3, wp::float64> var_start,
    wp::vec_t<3, wp::float64> var_end,
    wp::vec_t<3, wp::float64> var_p,
    Facet_ffcefc8d & adj_facet,
    wp::vec_t<3, wp::float64> & adj_start,
    wp::vec_t<3, wp::float64> & adj_end,
    wp::vec_t<3, wp::float64> & adj_p,
    wp::float64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/facets.py:115
static void adj_inward_distance_0(
    Facet_ffcefc8d var_facet,
    wp::vec_t<3, wp::float64> var_p,
    Facet_ffcefc8d & adj_facet,
    wp::vec_t<3, wp::float64> & adj_p,
    wp::float64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/facets.py:122
static void adj_is_touching_0(
    Facet_ffcefc8d var_facet,
    wp::vec_t<3, wp::float64> var_p,
    wp::float64 var_moved,
    Facet_ffcefc8d & adj_facet,
    wp::vec_t<3, wp::float64> & adj_p,
    wp::float64 & adj_moved,
    bool & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/contacts.py:84
static void adj__is_better_0(
    wp::float64 var_cosine,
    wp::int32 var_face,
    wp::float64 var_best,
    wp::int32 var_known,
    wp::float64 & adj_cosine,
    wp::int32 & adj_face,
    wp::float64 & adj_best,
    wp::int32 & adj_known,
    bool & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/contacts.py:59
static void adj__move_off_facet_0(
    FaceContact_ae9d5902 var_contact,
    Facet_ffcefc8d var_other,
    FaceContact_ae9d5902 & adj_contact,
    Facet_ffcefc8d & adj_other,
    FaceContact_ae9d5902 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/contacts.py:93
static void adj__look_at_other_0(
    Contacts_1da7c857 var_contacts,
    FaceContact_ae9d5902 var_contact,
    wp::int32 var_face,
    wp::vec_t<3, wp::float64> var_look,
    bool var_searching,
    Contacts_1da7c857 & adj_contacts,
    FaceContact_ae9d5902 & adj_contact,
    wp::int32 & adj_face,
    wp::vec_t<3, wp::float64> & adj_look,
    bool & adj_searching,
    FaceContact_ae9d5902 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/contacts.py:136
static void adj__look_at_0(
    wp::int32 var_face,
    Around_9296a408 var_around,
    FaceContact_ae9d5902 var_contact,
    wp::int32 & adj_face,
    Around_9296a408 & adj_around,
    FaceContact_ae9d5902 & adj_contact,
    FaceContact_ae9d5902 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/touching.py:81
static void adj_faces_touching__locals__look_into_0(
    wp::uint64 var_leaf,
    Around_9296a408 var_query,
    FaceContact_ae9d5902 var_answer,
    FaceContact_ae9d5902 & ret_0,
    bool & ret_1,
    wp::uint64 & adj_leaf,
    Around_9296a408 & adj_query,
    FaceContact_ae9d5902 & adj_answer,
    FaceContact_ae9d5902 & adj_ret_0,
    bool & adj_ret_1)
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
static void adj_tree_walk__locals__walk_0(
    Accelerator_9fc73cd7 var_tree,
    Around_9296a408 var_query,
    FaceContact_ae9d5902 var_answer,
    wp::int32 var_visits,
    wp::uint64 var_scratch,
    FaceContact_ae9d5902 & ret_0,
    bool & ret_1,
    Accelerator_9fc73cd7 & adj_tree,
    Around_9296a408 & adj_query,
    FaceContact_ae9d5902 & adj_answer,
    wp::int32 & adj_visits,
    wp::uint64 & adj_scratch,
    FaceContact_ae9d5902 & adj_ret_0,
    bool & adj_ret_1)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/touching.py:91
static void adj_faces_touching__locals__look_around_0(
    Accelerator_9fc73cd7 var_tree,
    Around_9296a408 var_query,
    FaceContact_ae9d5902 var_answer,
    wp::uint64 var_scratch,
    Accelerator_9fc73cd7 & adj_tree,
    Around_9296a408 & adj_query,
    FaceContact_ae9d5902 & adj_answer,
    wp::uint64 & adj_scratch,
    FaceContact_ae9d5902 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/contacts.py:148
static void adj_look_around_0(
    Contacts_1da7c857 var_contacts,
    Accelerator_9fc73cd7 var_tree,
    FaceContact_ae9d5902 var_contact,
    wp::vec_t<3, wp::float64> var_look,
    bool var_searching,
    wp::uint64 var_scratch,
    Contacts_1da7c857 & adj_contacts,
    Accelerator_9fc73cd7 & adj_tree,
    FaceContact_ae9d5902 & adj_contact,
    wp::vec_t<3, wp::float64> & adj_look,
    bool & adj_searching,
    wp::uint64 & adj_scratch,
    FaceContact_ae9d5902 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/tracing/sight/contacts.py:166
static void adj_find_own_face_0(
    FaceContact_ae9d5902 var_contact,
    FaceContact_ae9d5902 & adj_contact,
    wp::int32 & adj_ret)
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


// /work/main/warpsample/tracing/sight/contacts.py:214
static void adj_start_of_0(
    Contacts_1da7c857 var_contacts,
    FaceContact_ae9d5902 var_contact,
    wp::vec_t<3, wp::float64> var_look,
    Contacts_1da7c857 & adj_contacts,
    FaceContact_ae9d5902 & adj_contact,
    wp::vec_t<3, wp::float64> & adj_look,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}

struct wp_args__start_kernel__locals__find_starts_388d6c52 {
    Contacts_1da7c857 contacts;
    Accelerator_9fc73cd7 tree;
    wp::int64 first_task;
};


template <bool wp_linear_contiguous>
static void _start_kernel__locals__find_starts_388d6c52_cpu_kernel_forward(
    wp::launch_bounds_t<1> dim,
    size_t task_index,
    wp_args__start_kernel__locals__find_starts_388d6c52 *_wp_args)
{
    static constexpr bool wp_linear_tid = wp_linear_contiguous;

    //---------
    // argument vars
    Contacts_1da7c857 var_contacts = _wp_args->contacts;
    Accelerator_9fc73cd7 var_tree = _wp_args->tree;
    wp::int64 var_first_task = _wp_args->first_task;
    //---------
    // primal vars
    const wp::int32 var_0 = 108;
    wp::tuple_t<wp::int32> var_1;
    wp::fixedarray_t<108, wp::int32> var_2;
    const wp::int32 var_3 = 108;
    wp::int32 var_4;
    wp::int64 var_5;
    wp::int64 var_6;
    FaceContact_ae9d5902 var_7;
    Placement_e6d83c4e* var_8;
    wp::vec_t<3, wp::float64> var_9;
    Placement_e6d83c4e var_10;
    wp::uint64* var_11;
    wp::int32 var_12;
    wp::uint64 var_13;
    const wp::int32 var_14 = -1;
    const wp::int32 var_15 = -1;
    const bool var_16 = false;
    bool var_17;
    Placement_e6d83c4e* var_18;
    wp::uint64* var_19;
    wp::vec_t<3, wp::float32> var_20;
    wp::uint64 var_21;
    wp::vec_t<3, wp::float64> var_22;
    wp::int32* var_23;
    const wp::int32 var_24 = 1;
    bool var_25;
    wp::int32 var_26;
    wp::uint64* var_27;
    wp::vec_t<3, wp::float32> var_28;
    wp::uint64 var_29;
    wp::vec_t<3, wp::float32> var_30;
    wp::vec_t<3, wp::float64> var_31;
    wp::vec_t<3, wp::float64> var_32;
    bool var_33;
    wp::int32* var_34;
    wp::range_t var_35;
    wp::int32 var_36;
    wp::int32 var_37;
    wp::vec_t<3, wp::float64>* var_38;
    wp::vec_t<3, wp::float32> var_39;
    wp::vec_t<3, wp::float64> var_40;
    wp::vec_t<3, wp::float64> var_41;
    wp::int32* var_42;
    const wp::int32 var_43 = 0;
    bool var_44;
    wp::int32 var_45;
    wp::int32* var_46;
    Facet_ffcefc8d var_47;
    wp::int32 var_48;
    wp::vec_t<3, wp::float64> var_49;
    Facet_ffcefc8d var_50;
    const wp::int32 var_51 = 1;
    const wp::int32 var_52 = 0;
    wp::int32 var_53;
    wp::int32* var_54;
    const wp::int32 var_55 = 1;
    wp::int32 var_56;
    wp::int32 var_57;
    wp::range_t var_58;
    wp::int32 var_59;
    bool var_60;
    const wp::int32 var_61 = 0;
    bool var_62;
    wp::int32* var_63;
    const wp::int32 var_64 = 0;
    bool var_65;
    wp::int32 var_66;
    FaceContact_ae9d5902 var_67;
    FaceContact_ae9d5902 var_68;
    bool var_69;
    wp::float64 var_70;
    const wp::float64 var_71 = 0.0;
    bool var_72;
    bool var_73;
    const wp::int32 var_74 = 0;
    bool var_75;
    wp::int32* var_76;
    const wp::int32 var_77 = 0;
    bool var_78;
    wp::int32 var_79;
    bool* var_80;
    bool var_81;
    bool var_82;
    const wp::int32 var_83 = 0;
    bool var_84;
    bool var_85;
    const wp::int32 var_86 = 0;
    bool var_87;
    wp::uint64* var_88;
    FaceContact_ae9d5902 var_89;
    wp::uint64 var_90;
    FaceContact_ae9d5902 var_91;
    const wp::int32 var_92 = 0;
    bool var_93;
    wp::int32 var_94;
    wp::int32* var_95;
    const wp::int32 var_96 = 0;
    bool var_97;
    wp::int32 var_98;
    wp::int32* var_99;
    Facet_ffcefc8d var_100;
    wp::int32 var_101;
    const wp::int32 var_102 = 1;
    wp::int32 var_103;
    wp::vec_t<3, wp::float32> var_104;
    wp::vec_t<3, wp::float64> var_105;
    wp::vec_t<3, wp::float64> var_106;
    //---------
    // forward
    // def find_starts(contacts: Contacts, tree: Accelerator, first_task: wp.int64):          <L 116>
    // words = wp.zeros(shape=(SCRATCH,), dtype=wp.int32)                                     <L 117>
    var_1 = wp::tuple(var_0);
    var_2 = wp::fixedarray_t<108, wp::int32>(var_3);
    // i = first_task + wp.int64(wp.tid())                                                    <L 118>
    var_4 = builtin_tid1d();
    var_5 = wp::int64(var_4);
    var_6 = wp::add(var_first_task, var_5);
    // contact = FaceContact()                                                                <L 119>
    var_7 = FaceContact_ae9d5902();
    // contact.p = local_origin(contacts.placement, i)                                        <L 120>
    var_8 = &((var_contacts).placement);
    var_10 = wp::load(var_8);
    var_9 = local_origin_0(var_10, var_6);
    var_7.p = var_9;
    // contact.own = int_at(contacts.face, i)                                                 <L 121>
    var_11 = &((var_contacts).face);
    var_13 = wp::load(var_11);
    var_12 = _reader__locals__read_1(var_13, var_6);
    var_7.own = var_12;
    // contact.along = -1                                                                     <L 122>
    var_7.along = var_14;
    // contact.against = -1                                                                   <L 123>
    var_7.against = var_15;
    // contact.alone = wp.bool(False)                                                         <L 124>
    var_17 = bool(var_16);
    var_7.alone = var_17;
    // normal = vec3_at(contacts.placement.normals, i)                                        <L 125>
    var_18 = &((var_contacts).placement);
    var_19 = &(((var_contacts).placement).normals);
    var_21 = wp::load(var_19);
    var_20 = _reader__locals__read_5(var_21, var_6);
    // look = in_double(normal)                                                               <L 126>
    var_22 = in_double_0(var_20);
    // if contacts.sides == 1:                                                                <L 127>
    var_23 = &((var_contacts).sides);
    var_26 = wp::load(var_23);
    var_25 = (var_26 == var_24);
    if (var_25) {
        // look = in_double(normalize(vec3_at(contacts.towards, i)))                          <L 128>
        var_27 = &((var_contacts).towards);
        var_29 = wp::load(var_27);
        var_28 = _reader__locals__read_5(var_29, var_6);
        var_30 = normalize_0(var_28);
        var_31 = in_double_0(var_30);
    }
    var_32 = wp::where(var_25, var_31, var_22);
    // if _is_raised(contacts, i):                                                            <L 129>
    var_33 = _is_raised_0(var_contacts, var_6);
    if (var_33) {
        // for side in range(contacts.sides):                                                 <L 130>
        var_34 = &((var_contacts).sides);
        var_36 = wp::load(var_34);
        var_35 = wp::range(var_36);
        start_for_0:;
            if (iter_cmp(var_35) == 0) goto end_for_0;
            var_37 = wp::iter_next(var_35);
            // _set_start(contacts, i, side, start_above(contacts, contact.p, look))          <L 131>
            var_38 = &((var_7).p);
            var_40 = wp::load(var_38);
            var_39 = start_above_0(var_contacts, var_40, var_32);
            _set_start_0(var_contacts, var_6, var_37, var_39);
            // look = -look                                                                   <L 132>
            var_41 = wp::neg(var_32);
            wp::assign(var_32, var_41);
            goto start_for_0;
        end_for_0:;
        // return                                                                             <L 133>
        return;
    }
    // known = contact.own >= 0                                                               <L 134>
    var_42 = &((var_7).own);
    var_45 = wp::load(var_42);
    var_44 = (var_45 >= var_43);
    // if known:                                                                              <L 135>
    if (var_44) {
        // contact.facet = with_normal(contacts, corners_of(contacts, contact.own), in_double(normal))       <L 137>
        var_46 = &((var_7).own);
        var_48 = wp::load(var_46);
        var_47 = corners_of_0(var_contacts, var_48);
        var_49 = in_double_0(var_20);
        var_50 = with_normal_0(var_contacts, var_47, var_49);
        var_7.facet = var_50;
    }
    // for step in range(wp.where(known, 1, 0), contacts.sides + 1):                          <L 139>
    var_53 = wp::where(var_44, var_51, var_52);
    var_54 = &((var_contacts).sides);
    var_57 = wp::load(var_54);
    var_56 = wp::add(var_57, var_55);
    var_58 = wp::range(var_53, var_56);
    start_for_3:;
        if (iter_cmp(var_58) == 0) goto end_for_3;
        var_59 = wp::iter_next(var_58);
        // if step > 0 and contact.own >= 0:                                                  <L 140>
        var_62 = (var_59 > var_61);
        var_60 = var_62;
        if (var_60) {
            var_63 = &((var_7).own);
            var_66 = wp::load(var_63);
            var_65 = (var_66 >= var_64);
            var_60 = var_60 && var_65;
        }
        if (var_60) {
            // contact = raise_start(contacts, contact, look, known)                          <L 141>
            var_67 = raise_start_0(var_contacts, var_7, var_32, var_44);
        }
        var_68 = wp::where(var_60, var_67, var_7);
        // if wp.dot(look, look) > ZERO and (step == 0 or contact.own >= 0) and not contact.alone:       <L 142>
        var_70 = wp::dot(var_32, var_32);
        var_72 = (var_70 > var_71);
        var_69 = var_72;
        if (var_69) {
            var_75 = (var_59 == var_74);
            var_73 = var_75;
            if (!var_73) {
                var_76 = &((var_68).own);
                var_79 = wp::load(var_76);
                var_78 = (var_79 >= var_77);
                var_73 = var_73 || var_78;
            }
            var_69 = var_69 && var_73;
        }
        if (var_69) {
            var_80 = &((var_68).alone);
            var_82 = wp::load(var_80);
            var_81 = wp::unot(var_82);
            var_69 = var_69 && var_81;
        }
        if (var_69) {
            // contact.alone = wp.bool(step > 0)                                              <L 143>
            var_84 = (var_59 > var_83);
            var_85 = bool(var_84);
            var_68.alone = var_85;
            // contact = look_around(contacts, tree, contact, look, step == 0, words.ptr)       <L 144>
            var_87 = (var_59 == var_86);
            var_88 = (wp::uint64*)&(var_2.data);
            var_90 = wp::load(var_88);
            var_89 = look_around_0(var_contacts, var_tree, var_68, var_32, var_87, var_90);
        }
        var_91 = wp::where(var_69, var_89, var_68);
        // if step == 0:                                                                      <L 145>
        var_93 = (var_59 == var_92);
        if (var_93) {
            // contact.own = find_own_face(contact)                                           <L 146>
            var_94 = find_own_face_0(var_91);
            var_91.own = var_94;
            // if contact.own >= 0:                                                           <L 147>
            var_95 = &((var_91).own);
            var_98 = wp::load(var_95);
            var_97 = (var_98 >= var_96);
            if (var_97) {
                // contact.facet = facet_of(contacts, contact.own)                            <L 148>
                var_99 = &((var_91).own);
                var_101 = wp::load(var_99);
                var_100 = facet_of_0(var_contacts, var_101);
                var_91.facet = var_100;
            }
        }
        if (!var_93) {
            // _set_start(contacts, i, step - 1, start_of(contacts, contact, look))           <L 150>
            var_103 = wp::sub(var_59, var_102);
            var_104 = start_of_0(var_contacts, var_91, var_32);
            _set_start_0(var_contacts, var_6, var_103, var_104);
            // look = -look                                                                   <L 151>
            var_105 = wp::neg(var_32);
        }
        var_106 = wp::where(var_93, var_32, var_105);
        wp::assign(var_7, var_91);
        wp::assign(var_32, var_106);
        goto start_for_3;
    end_for_3:;
}



template <bool wp_linear_contiguous>
static WP_FORCEINLINE void _start_kernel__locals__find_starts_388d6c52_cpu_forward_tasks(
    wp::launch_bounds_t<1> *dim,
    wp_args__start_kernel__locals__find_starts_388d6c52 *_wp_args)
{
    for (size_t task_index = 0; task_index < dim->size; ++task_index)
    {
        _start_kernel__locals__find_starts_388d6c52_cpu_kernel_forward<wp_linear_contiguous>(*dim, task_index, _wp_args);
    }
}

static WP_FORCEINLINE void _start_kernel__locals__find_starts_388d6c52_cpu_forward_dispatch(
    wp::launch_bounds_t<1> *dim,
    wp_args__start_kernel__locals__find_starts_388d6c52 *_wp_args)
{
    wp::tile_shared_storage_t tile_mem;
#if defined(WP_ENABLE_TILES_IN_STACK_MEMORY)
    wp::shared_tile_storage = &tile_mem;
#endif

    _start_kernel__locals__find_starts_388d6c52_cpu_forward_tasks<false>(dim, _wp_args);
}

extern "C" {

// Python CPU entry points
WP_API void _start_kernel__locals__find_starts_388d6c52_cpu_forward(
    wp::launch_bounds_t<1> *dim,
    wp_args__start_kernel__locals__find_starts_388d6c52 *_wp_args)
{
    _start_kernel__locals__find_starts_388d6c52_cpu_forward_dispatch(dim, _wp_args);
}

} // extern C

