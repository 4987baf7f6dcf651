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




struct Samples_fe638941
{
    wp::vec_t<4, wp::uint32> run;
    wp::uint32 first_point;
    wp::uint64 seed;
    wp::uint64 ids;
    wp::int64 points;
    wp::int32 count;
    wp::int32 segment;
    wp::int32 rows;
    wp::uint64 normals;
    wp::uint64 vectors;
    wp::uint64 pdf;
    wp::uint64 status;
    wp::uint64 active;
    Parameters_f3aa772c parameters;


    Samples_fe638941() = default;
    CUDA_CALLABLE Samples_fe638941(wp::vec_t<4, wp::uint32> const& run,
    wp::uint32 const& first_point = {},
    wp::uint64 const& seed = {},
    wp::uint64 const& ids = {},
    wp::int64 const& points = {},
    wp::int32 const& count = {},
    wp::int32 const& segment = {},
    wp::int32 const& rows = {},
    wp::uint64 const& normals = {},
    wp::uint64 const& vectors = {},
    wp::uint64 const& pdf = {},
    wp::uint64 const& status = {},
    wp::uint64 const& active = {},
    Parameters_f3aa772c const& parameters = {})
        : run{run}
        , first_point{first_point}
        , seed{seed}
        , ids{ids}
        , points{points}
        , count{count}
        , segment{segment}
        , rows{rows}
        , normals{normals}
        , vectors{vectors}
        , pdf{pdf}
        , status{status}
        , active{active}
        , parameters{parameters}

    {
    }

    CUDA_CALLABLE Samples_fe638941& operator += (const Samples_fe638941& rhs)
    {    run += rhs.run;
    first_point += rhs.first_point;
    seed += rhs.seed;
    ids += rhs.ids;
    points += rhs.points;
    count += rhs.count;
    segment += rhs.segment;
    rows += rhs.rows;
    normals += rhs.normals;
    vectors += rhs.vectors;
    pdf += rhs.pdf;
    status += rhs.status;
    active += rhs.active;
    parameters += rhs.parameters;

        return *this;}

};

static CUDA_CALLABLE void adj_Samples_fe638941(wp::vec_t<4, wp::uint32> const&,
    wp::uint32 const&,
    wp::uint64 const&,
    wp::uint64 const&,
    wp::int64 const&,
    wp::int32 const&,
    wp::int32 const&,
    wp::int32 const&,
    wp::uint64 const&,
    wp::uint64 const&,
    wp::uint64 const&,
    wp::uint64 const&,
    wp::uint64 const&,
    Parameters_f3aa772c const&,
    wp::vec_t<4, wp::uint32> & adj_run,
    wp::uint32 & adj_first_point,
    wp::uint64 & adj_seed,
    wp::uint64 & adj_ids,
    wp::int64 & adj_points,
    wp::int32 & adj_count,
    wp::int32 & adj_segment,
    wp::int32 & adj_rows,
    wp::uint64 & adj_normals,
    wp::uint64 & adj_vectors,
    wp::uint64 & adj_pdf,
    wp::uint64 & adj_status,
    wp::uint64 & adj_active,
    Parameters_f3aa772c & adj_parameters,
    Samples_fe638941 & adj_ret)
{
    adj_run += adj_ret.run;
    adj_first_point += adj_ret.first_point;
    adj_seed += adj_ret.seed;
    adj_ids += adj_ret.ids;
    adj_points += adj_ret.points;
    adj_count += adj_ret.count;
    adj_segment += adj_ret.segment;
    adj_rows += adj_ret.rows;
    adj_normals += adj_ret.normals;
    adj_vectors += adj_ret.vectors;
    adj_pdf += adj_ret.pdf;
    adj_status += adj_ret.status;
    adj_active += adj_ret.active;
    adj_parameters += adj_ret.parameters;
}

// Required when compiling adjoints.
CUDA_CALLABLE Samples_fe638941 add(const Samples_fe638941& a, const Samples_fe638941& b)
{
    return Samples_fe638941();
}

CUDA_CALLABLE void adj_atomic_add(Samples_fe638941* p, Samples_fe638941 t)
{
    wp::adj_atomic_add(&p->run, t.run);
    wp::adj_atomic_add(&p->first_point, t.first_point);
    wp::adj_atomic_add(&p->seed, t.seed);
    wp::adj_atomic_add(&p->ids, t.ids);
    wp::adj_atomic_add(&p->points, t.points);
    wp::adj_atomic_add(&p->count, t.count);
    wp::adj_atomic_add(&p->segment, t.segment);
    wp::adj_atomic_add(&p->rows, t.rows);
    wp::adj_atomic_add(&p->normals, t.normals);
    wp::adj_atomic_add(&p->vectors, t.vectors);
    wp::adj_atomic_add(&p->pdf, t.pdf);
    wp::adj_atomic_add(&p->status, t.status);
    wp::adj_atomic_add(&p->active, t.active);
    adj_atomic_add(&p->parameters, t.parameters);
}




// /work/main/warpsample/directions/samples.py:51
static wp::float32 weigh_all_0(
    wp::array_t<wp::uint8> var_active,
    wp::int32 var_i)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 1.0;
    //---------
    // forward
    // def weigh_all(active: wp.array[wp.uint8], i: wp.int32) -> wp.float32:                  <L 52>
    // return 1.0                                                                             <L 54>
    return var_0;
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


// /work/main/warpsample/directions/samples.py:109
static wp::int32 build_unit_writer__locals__write_units_0(
    wp::array_t<wp::float32> var_normals,
    wp::array_t<wp::uint8> var_active,
    wp::int32 var_rows,
    wp::array_t<wp::float32> var_units)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    const wp::int32 var_2 = 0;
    wp::int32 var_3;
    bool var_4;
    wp::float32 var_5;
    const wp::int32 var_6 = 3;
    wp::int32 var_7;
    wp::float32* var_8;
    const wp::int32 var_9 = 3;
    wp::int32 var_10;
    const wp::int32 var_11 = 1;
    wp::int32 var_12;
    wp::float32* var_13;
    const wp::int32 var_14 = 3;
    wp::int32 var_15;
    const wp::int32 var_16 = 2;
    wp::int32 var_17;
    wp::float32* var_18;
    wp::vec_t<3, wp::float32> var_19;
    wp::float32 var_20;
    wp::float32 var_21;
    wp::float32 var_22;
    wp::vec_t<3, wp::float32> var_23;
    wp::vec_t<4, wp::float32> var_24;
    const wp::int32 var_25 = 0;
    wp::float32 var_26;
    const wp::int32 var_27 = 1;
    wp::float32 var_28;
    const wp::int32 var_29 = 264;
    wp::int32 var_30;
    const wp::int32 var_31 = 2;
    wp::float32 var_32;
    const wp::int32 var_33 = 2;
    wp::int32 var_34;
    wp::int32 var_35;
    const bool var_36 = false;
    const wp::int32 var_37 = 3;
    wp::float32 var_38;
    wp::float32 var_39;
    const wp::float32 var_40 = 0.1;
    bool var_41;
    const wp::int32 var_42 = 0;
    const wp::int32 var_43 = 1;
    wp::int32 var_44;
    wp::int32 var_45;
    const wp::int32 var_46 = 1;
    wp::int32 var_47;
    //---------
    // forward
    // def write_units(normals: wp.array[wp.float32], active: wp.array[wp.uint8], rows: wp.int32, units: wp.array[wp.float32]):       <L 110>
    // rare = wp.int32(0)                                                                     <L 112>
    var_1 = wp::int32(var_0);
    // r = wp.int32(0)                                                                        <L 113>
    var_3 = wp::int32(var_2);
    // while r < rows:                                                                        <L 114>
    start_while_0:;
    var_4 = (var_3 < var_rows);
    if ((var_4) == false) goto end_while_0;
        // unit = scaled_to_unit(weigh(active, r) * wp.vec3(normals[3 * r], normals[3 * r + 1], normals[3 * r + 2]))       <L 115>
        var_5 = weigh_all_0(var_active, var_3);
        var_7 = wp::mul(var_6, var_3);
        var_8 = wp::address(var_normals, var_7);
        var_10 = wp::mul(var_9, var_3);
        var_12 = wp::add(var_10, var_11);
        var_13 = wp::address(var_normals, var_12);
        var_15 = wp::mul(var_14, var_3);
        var_17 = wp::add(var_15, var_16);
        var_18 = wp::address(var_normals, var_17);
        var_20 = wp::load(var_8);
        var_21 = wp::load(var_13);
        var_22 = wp::load(var_18);
        var_19 = wp::vec_t<3, wp::float32>(var_20, var_21, var_22);
        var_23 = wp::mul(var_5, var_19);
        var_24 = scaled_to_unit_0(var_23);
        // units[r] = unit[0]                                                                 <L 116>
        var_26 = wp::extract(var_24, var_25);
        wp::array_store(var_units, var_3, var_26);
        // units[stride + r] = unit[1]                                                        <L 117>
        var_28 = wp::extract(var_24, var_27);
        var_30 = wp::add(var_29, var_3);
        wp::array_store(var_units, var_30, var_28);
        // units[2 * stride + r] = unit[2]                                                    <L 118>
        var_32 = wp::extract(var_24, var_31);
        var_34 = wp::mul(var_33, var_29);
        var_35 = wp::add(var_34, var_3);
        wp::array_store(var_units, var_35, var_32);
        // if wp.static(with_check):                                                          <L 119>
        // rare = rare | wp.where(wp.abs(unit[3]) < 0.1, 0, 1)                                <L 121>
        var_38 = wp::extract(var_24, var_37);
        var_39 = wp::abs(var_38);
        var_41 = (var_39 < var_40);
        var_44 = wp::where(var_41, var_42, var_43);
        var_45 = wp::bit_or(var_1, var_44);
        // r += 1                                                                             <L 122>
        var_47 = wp::add(var_3, var_46);
        wp::assign(var_1, var_45);
        wp::assign(var_3, var_47);
    goto start_while_0;
    end_while_0:;
    // return rare                                                                            <L 123>
    return var_1;
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


// /work/main/warpsample/maths/numerics.py:94
static wp::uint32 reverse_bits_0(
    wp::uint32 var_x)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 1;
    wp::uint32 var_1;
    wp::uint32 var_2;
    const wp::uint32 var_3 = 1431655765u;
    wp::uint32 var_4;
    wp::uint32 var_5;
    const wp::int32 var_6 = 1;
    wp::uint32 var_7;
    wp::uint32 var_8;
    wp::uint32 var_9;
    const wp::int32 var_10 = 2;
    wp::uint32 var_11;
    wp::uint32 var_12;
    const wp::uint32 var_13 = 858993459u;
    wp::uint32 var_14;
    wp::uint32 var_15;
    const wp::int32 var_16 = 2;
    wp::uint32 var_17;
    wp::uint32 var_18;
    wp::uint32 var_19;
    const wp::int32 var_20 = 4;
    wp::uint32 var_21;
    wp::uint32 var_22;
    const wp::uint32 var_23 = 252645135u;
    wp::uint32 var_24;
    wp::uint32 var_25;
    const wp::int32 var_26 = 4;
    wp::uint32 var_27;
    wp::uint32 var_28;
    wp::uint32 var_29;
    const wp::int32 var_30 = 8;
    wp::uint32 var_31;
    wp::uint32 var_32;
    const wp::uint32 var_33 = 16711935u;
    wp::uint32 var_34;
    wp::uint32 var_35;
    const wp::int32 var_36 = 8;
    wp::uint32 var_37;
    wp::uint32 var_38;
    wp::uint32 var_39;
    const wp::int32 var_40 = 16;
    wp::uint32 var_41;
    wp::uint32 var_42;
    const wp::int32 var_43 = 16;
    wp::uint32 var_44;
    wp::uint32 var_45;
    wp::uint32 var_46;
    //---------
    // forward
    // def reverse_bits(x: wp.uint32) -> wp.uint32:                                           <L 95>
    // x = ((x >> wp.uint32(1)) & EVEN_BITS) | ((x & EVEN_BITS) << wp.uint32(1))              <L 97>
    var_1 = wp::uint32(var_0);
    var_2 = wp::rshift(var_x, var_1);
    var_4 = wp::bit_and(var_2, var_3);
    var_5 = wp::bit_and(var_x, var_3);
    var_7 = wp::uint32(var_6);
    var_8 = wp::lshift(var_5, var_7);
    var_9 = wp::bit_or(var_4, var_8);
    // x = ((x >> wp.uint32(2)) & EVEN_PAIRS) | ((x & EVEN_PAIRS) << wp.uint32(2))            <L 98>
    var_11 = wp::uint32(var_10);
    var_12 = wp::rshift(var_9, var_11);
    var_14 = wp::bit_and(var_12, var_13);
    var_15 = wp::bit_and(var_9, var_13);
    var_17 = wp::uint32(var_16);
    var_18 = wp::lshift(var_15, var_17);
    var_19 = wp::bit_or(var_14, var_18);
    // x = ((x >> wp.uint32(4)) & EVEN_NIBBLES) | ((x & EVEN_NIBBLES) << wp.uint32(4))        <L 99>
    var_21 = wp::uint32(var_20);
    var_22 = wp::rshift(var_19, var_21);
    var_24 = wp::bit_and(var_22, var_23);
    var_25 = wp::bit_and(var_19, var_23);
    var_27 = wp::uint32(var_26);
    var_28 = wp::lshift(var_25, var_27);
    var_29 = wp::bit_or(var_24, var_28);
    // x = ((x >> wp.uint32(8)) & EVEN_BYTES) | ((x & EVEN_BYTES) << wp.uint32(8))            <L 100>
    var_31 = wp::uint32(var_30);
    var_32 = wp::rshift(var_29, var_31);
    var_34 = wp::bit_and(var_32, var_33);
    var_35 = wp::bit_and(var_29, var_33);
    var_37 = wp::uint32(var_36);
    var_38 = wp::lshift(var_35, var_37);
    var_39 = wp::bit_or(var_34, var_38);
    // return (x >> wp.uint32(16)) | (x << wp.uint32(16))                                     <L 101>
    var_41 = wp::uint32(var_40);
    var_42 = wp::rshift(var_39, var_41);
    var_44 = wp::uint32(var_43);
    var_45 = wp::lshift(var_39, var_44);
    var_46 = wp::bit_or(var_42, var_45);
    return var_46;
}


// /work/main/warpsample/sequences/sobol.py:14
static wp::uint32 laine_karras_0(
    wp::uint32 var_x,
    wp::uint32 var_key)
{
    //---------
    // primal vars
    const wp::uint32 var_0 = 1025551850u;
    wp::uint32 var_1;
    wp::uint32 var_2;
    wp::uint32 var_3;
    const wp::int32 var_4 = 16;
    wp::uint32 var_5;
    wp::uint32 var_6;
    const wp::int32 var_7 = 1;
    wp::uint32 var_8;
    wp::uint32 var_9;
    wp::uint32 var_10;
    const wp::uint32 var_11 = 89287766u;
    wp::uint32 var_12;
    wp::uint32 var_13;
    const wp::uint32 var_14 = 1403136100u;
    wp::uint32 var_15;
    wp::uint32 var_16;
    //---------
    // forward
    // def laine_karras(x: wp.uint32, key: wp.uint32) -> wp.uint32:                           <L 15>
    // x = x ^ (x * _HASH_1)                                                                  <L 20>
    var_1 = wp::mul(var_x, var_0);
    var_2 = wp::bit_xor(var_x, var_1);
    // x = x + key                                                                            <L 21>
    var_3 = wp::add(var_2, var_key);
    // x = x * ((key >> wp.uint32(16)) | wp.uint32(1))                                        <L 22>
    var_5 = wp::uint32(var_4);
    var_6 = wp::rshift(var_key, var_5);
    var_8 = wp::uint32(var_7);
    var_9 = wp::bit_or(var_6, var_8);
    var_10 = wp::mul(var_3, var_9);
    // x = x ^ (x * _HASH_2)                                                                  <L 23>
    var_12 = wp::mul(var_10, var_11);
    var_13 = wp::bit_xor(var_10, var_12);
    // return x ^ (x * _HASH_3)                                                               <L 24>
    var_15 = wp::mul(var_13, var_14);
    var_16 = wp::bit_xor(var_13, var_15);
    return var_16;
}


// /work/main/warpsample/sequences/sobol.py:27
static wp::uint32 sobol_second_0(
    wp::uint32 var_index)
{
    //---------
    // primal vars
    wp::uint32 var_0;
    const wp::int32 var_1 = 1;
    wp::uint32 var_2;
    wp::uint32 var_3;
    const wp::uint32 var_4 = 1431655765u;
    wp::uint32 var_5;
    wp::uint32 var_6;
    const wp::int32 var_7 = 2;
    wp::uint32 var_8;
    wp::uint32 var_9;
    const wp::uint32 var_10 = 858993459u;
    wp::uint32 var_11;
    wp::uint32 var_12;
    const wp::int32 var_13 = 4;
    wp::uint32 var_14;
    wp::uint32 var_15;
    const wp::uint32 var_16 = 252645135u;
    wp::uint32 var_17;
    wp::uint32 var_18;
    const wp::int32 var_19 = 8;
    wp::uint32 var_20;
    wp::uint32 var_21;
    const wp::uint32 var_22 = 16711935u;
    wp::uint32 var_23;
    wp::uint32 var_24;
    const wp::int32 var_25 = 16;
    wp::uint32 var_26;
    wp::uint32 var_27;
    wp::uint32 var_28;
    //---------
    // forward
    // def sobol_second(index: wp.uint32) -> wp.uint32:                                       <L 28>
    // x = index                                                                              <L 33>
    var_0 = wp::copy(var_index);
    // x = x ^ ((x >> wp.uint32(1)) & EVEN_BITS)                                              <L 34>
    var_2 = wp::uint32(var_1);
    var_3 = wp::rshift(var_0, var_2);
    var_5 = wp::bit_and(var_3, var_4);
    var_6 = wp::bit_xor(var_0, var_5);
    // x = x ^ ((x >> wp.uint32(2)) & EVEN_PAIRS)                                             <L 35>
    var_8 = wp::uint32(var_7);
    var_9 = wp::rshift(var_6, var_8);
    var_11 = wp::bit_and(var_9, var_10);
    var_12 = wp::bit_xor(var_6, var_11);
    // x = x ^ ((x >> wp.uint32(4)) & EVEN_NIBBLES)                                           <L 36>
    var_14 = wp::uint32(var_13);
    var_15 = wp::rshift(var_12, var_14);
    var_17 = wp::bit_and(var_15, var_16);
    var_18 = wp::bit_xor(var_12, var_17);
    // x = x ^ ((x >> wp.uint32(8)) & EVEN_BYTES)                                             <L 37>
    var_20 = wp::uint32(var_19);
    var_21 = wp::rshift(var_18, var_20);
    var_23 = wp::bit_and(var_21, var_22);
    var_24 = wp::bit_xor(var_18, var_23);
    // return x ^ (x >> wp.uint32(16))                                                        <L 38>
    var_26 = wp::uint32(var_25);
    var_27 = wp::rshift(var_24, var_26);
    var_28 = wp::bit_xor(var_24, var_27);
    return var_28;
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


// /work/main/warpsample/sequences/sobol.py:41
static wp::vec_t<2, wp::float32> _scramble_0(
    wp::uint32 var_index,
    wp::uint32 var_second,
    wp::vec_t<4, wp::uint32> var_key)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 1;
    wp::uint32 var_1;
    wp::uint32 var_2;
    const wp::int32 var_3 = 2;
    wp::uint32 var_4;
    wp::uint32 var_5;
    wp::uint32 var_6;
    wp::float32 var_7;
    wp::uint32 var_8;
    wp::float32 var_9;
    wp::vec_t<2, wp::float32> var_10;
    //---------
    // forward
    // def _scramble(index: wp.uint32, second: wp.uint32, key: wp.vec4ui) -> wp.vec2:         <L 42>
    // x = laine_karras(index, key[1])                                                        <L 44>
    var_1 = wp::extract(var_key, var_0);
    var_2 = laine_karras_0(var_index, var_1);
    // y = laine_karras(second, key[2])                                                       <L 45>
    var_4 = wp::extract(var_key, var_3);
    var_5 = laine_karras_0(var_second, var_4);
    // return wp.vec2(uniform_from_bits(reverse_bits(x)), uniform_from_bits(reverse_bits(y)))       <L 46>
    var_6 = reverse_bits_0(var_2);
    var_7 = uniform_from_bits_0(var_6);
    var_8 = reverse_bits_0(var_5);
    var_9 = uniform_from_bits_0(var_8);
    var_10 = wp::vec_t<2, wp::float32>(var_7, var_9);
    return var_10;
}


// /work/main/warpsample/sequences/sobol.py:49
static wp::vec_t<2, wp::float32> sobol_sample_0(
    wp::vec_t<4, wp::uint32> var_key,
    wp::uint32 var_sample,
    wp::uint32 var_count)
{
    //---------
    // primal vars
    wp::uint32 var_0;
    const wp::int32 var_1 = 0;
    wp::uint32 var_2;
    wp::uint32 var_3;
    wp::uint32 var_4;
    wp::uint32 var_5;
    wp::vec_t<2, wp::float32> var_6;
    //---------
    // forward
    // def sobol_sample(key: wp.vec4ui, sample: wp.uint32, count: wp.uint32) -> wp.vec2:       <L 50>
    // index = reverse_bits(laine_karras(reverse_bits(sample), key[0]))                       <L 56>
    var_0 = reverse_bits_0(var_sample);
    var_2 = wp::extract(var_key, var_1);
    var_3 = laine_karras_0(var_0, var_2);
    var_4 = reverse_bits_0(var_3);
    // return _scramble(index, sobol_second(index), key)                                      <L 57>
    var_5 = sobol_second_0(var_4);
    var_6 = _scramble_0(var_4, var_5, var_key);
    return var_6;
}


// /work/main/warpsample/directions/blocks.py:61
static void _build_block_variates__locals__fill_0(
    Samples_fe638941 var_samples,
    wp::int64 var_point,
    wp::int32 var_start,
    wp::int32 var_length,
    wp::array_t<wp::float32> var_u)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 1;
    wp::int32 var_1;
    const bool var_2 = true;
    wp::int32* var_3;
    wp::int32 var_4;
    wp::int32 var_5;
    const wp::float32 var_6 = 1.0;
    wp::int32* var_7;
    wp::float32 var_8;
    wp::int32 var_9;
    wp::float32 var_10;
    wp::vec_t<4, wp::uint32>* var_11;
    wp::vec_t<4, wp::uint32> var_12;
    wp::vec_t<4, wp::uint32> var_13;
    wp::uint32* var_14;
    wp::uint32 var_15;
    wp::uint32 var_16;
    wp::uint32 var_17;
    wp::uint32 var_18;
    const wp::int32 var_19 = 0;
    wp::int32 var_20;
    bool var_21;
    wp::int32 var_22;
    const wp::int32 var_23 = 0;
    wp::uint32 var_24;
    const bool var_25 = true;
    wp::int32 var_26;
    wp::float32 var_27;
    const wp::float32 var_28 = 0.5;
    wp::float32 var_29;
    wp::float32 var_30;
    wp::int32 var_31;
    wp::int32 var_32;
    wp::int32 var_33;
    wp::int32 var_34;
    wp::uint32 var_35;
    wp::uint32 var_36;
    wp::uint32 var_37;
    wp::vec_t<4, wp::uint32> var_38;
    wp::vec_t<2, wp::float32> var_39;
    const wp::int32 var_40 = 0;
    wp::float32 var_41;
    const wp::int32 var_42 = 1;
    wp::float32 var_43;
    const wp::int32 var_44 = 256;
    wp::int32 var_45;
    const wp::int32 var_46 = 1;
    wp::int32 var_47;
    //---------
    // forward
    // def fill(samples: Samples, point: wp.int64, start: wp.int32, length: wp.int32, u: wp.array[wp.float32]):       <L 62>
    // count = wp.int32(1)                                                                    <L 63>
    var_1 = wp::int32(var_0);
    // if wp.static(not one_sample):                                                          <L 64>
    // count = samples.count                                                                  <L 65>
    var_3 = &((var_samples).count);
    var_5 = wp::load(var_3);
    var_4 = wp::copy(var_5);
    // per_count = 1.0 / wp.float32(samples.count)                                            <L 66>
    var_7 = &((var_samples).count);
    var_9 = wp::load(var_7);
    var_8 = wp::float32(var_9);
    var_10 = wp::div(var_6, var_8);
    // run = samples.run                                                                      <L 67>
    var_11 = &((var_samples).run);
    var_13 = wp::load(var_11);
    var_12 = wp::copy(var_13);
    // low = samples.first_point + wp.uint32(point)                                           <L 68>
    var_14 = &((var_samples).first_point);
    var_15 = wp::uint32(var_point);
    var_17 = wp::load(var_14);
    var_16 = wp::add(var_17, var_15);
    // total = wp.uint32(count)                                                               <L 69>
    var_18 = wp::uint32(var_4);
    // i = wp.int32(0)                                                                        <L 70>
    var_20 = wp::int32(var_19);
    // while i < length:                                                                      <L 71>
    start_while_0:;
    var_21 = (var_20 < var_length);
    if ((var_21) == false) goto end_while_0;
        // q = i                                                                              <L 72>
        var_22 = wp::copy(var_20);
        // sample = wp.uint32(0)                                                              <L 73>
        var_24 = wp::uint32(var_23);
        // if wp.static(not one_sample):                                                      <L 74>
        // q = wp.int32((wp.float32(start + i) + 0.5) * per_count)                            <L 76>
        var_26 = wp::add(var_start, var_20);
        var_27 = wp::float32(var_26);
        var_29 = wp::add(var_27, var_28);
        var_30 = wp::mul(var_29, var_10);
        var_31 = wp::int32(var_30);
        // sample = wp.uint32(start + i - q * count)                                          <L 77>
        var_32 = wp::add(var_start, var_20);
        var_33 = wp::mul(var_31, var_4);
        var_34 = wp::sub(var_32, var_33);
        var_35 = wp::uint32(var_34);
        // v = sample_of(key_of(run, low + wp.uint32(q)), sample, total)                      <L 78>
        var_36 = wp::uint32(var_31);
        var_37 = wp::add(var_16, var_36);
        var_38 = mixed_key_0(var_12, var_37);
        var_39 = sobol_sample_0(var_38, var_35, var_18);
        // u[i] = v[0]                                                                        <L 79>
        var_41 = wp::extract(var_39, var_40);
        wp::array_store(var_u, var_20, var_41);
        // u[FLAT_BLOCK + i] = v[1]                                                           <L 80>
        var_43 = wp::extract(var_39, var_42);
        var_45 = wp::add(var_44, var_20);
        wp::array_store(var_u, var_45, var_43);
        // i += 1                                                                             <L 81>
        var_47 = wp::add(var_20, var_46);
        wp::assign(var_20, var_47);
    goto start_while_0;
    end_while_0:;
}


// /work/main/warpsample/directions/blocks.py:86
static void _repeat_normals_0(
    wp::array_t<wp::float32> var_units,
    wp::int32 var_points,
    wp::int32 var_count,
    wp::int32 var_start,
    wp::int32 var_length,
    wp::array_t<wp::float32> var_repeated)
{
    //---------
    // primal vars
    wp::range_t var_0;
    wp::int32 var_1;
    wp::float32* var_2;
    wp::float32 var_3;
    wp::float32 var_4;
    const wp::int32 var_5 = 264;
    wp::int32 var_6;
    wp::float32* var_7;
    wp::float32 var_8;
    wp::float32 var_9;
    const wp::int32 var_10 = 2;
    wp::int32 var_11;
    wp::int32 var_12;
    wp::float32* var_13;
    wp::float32 var_14;
    wp::float32 var_15;
    wp::int32 var_16;
    wp::int32 var_17;
    const wp::int32 var_18 = 0;
    wp::int32 var_19;
    const wp::int32 var_20 = 1;
    wp::int32 var_21;
    wp::int32 var_22;
    wp::int32 var_23;
    wp::int32 var_24;
    const wp::int32 var_25 = 8;
    wp::range_t var_26;
    wp::int32 var_27;
    wp::uint64* var_28;
    const wp::int32 var_29 = 4;
    wp::int32 var_30;
    wp::uint64 var_31;
    wp::uint64 var_32;
    wp::uint64 var_33;
    const wp::int32 var_34 = 3;
    wp::int32 var_35;
    wp::tuple_t<wp::int32> var_36;
    wp::array_t<wp::float32> var_37;
    const wp::int32 var_38 = 0;
    wp::int32 var_39;
    const wp::int32 var_40 = 2;
    wp::int32 var_41;
    wp::int32 var_42;
    const wp::int32 var_43 = 1;
    wp::int32 var_44;
    const wp::int32 var_45 = 2;
    wp::int32 var_46;
    wp::int32 var_47;
    const wp::int32 var_48 = 2;
    wp::int32 var_49;
    const wp::int32 var_50 = 2;
    wp::int32 var_51;
    wp::int32 var_52;
    const wp::int32 var_53 = 3;
    wp::int32 var_54;
    const wp::int32 var_55 = 2;
    wp::int32 var_56;
    wp::int32 var_57;
    const wp::int32 var_58 = 4;
    wp::int32 var_59;
    const wp::int32 var_60 = 2;
    wp::int32 var_61;
    wp::int32 var_62;
    const wp::int32 var_63 = 5;
    wp::int32 var_64;
    const wp::int32 var_65 = 2;
    wp::int32 var_66;
    wp::int32 var_67;
    const wp::int32 var_68 = 6;
    wp::int32 var_69;
    const wp::int32 var_70 = 2;
    wp::int32 var_71;
    wp::int32 var_72;
    const wp::int32 var_73 = 7;
    wp::int32 var_74;
    const wp::int32 var_75 = 2;
    wp::int32 var_76;
    wp::int32 var_77;
    //---------
    // forward
    // def _repeat_normals(                                                                   <L 87>
    // for p in range(points):                                                                <L 96>
    var_0 = wp::range(var_points);
    start_for_0:;
        if (iter_cmp(var_0) == 0) goto end_for_0;
        var_1 = wp::iter_next(var_0);
        // x = units[p]                                                                       <L 97>
        var_2 = wp::address(var_units, var_1);
        var_4 = wp::load(var_2);
        var_3 = wp::copy(var_4);
        // y = units[_STRIDE + p]                                                             <L 98>
        var_6 = wp::add(var_5, var_1);
        var_7 = wp::address(var_units, var_6);
        var_9 = wp::load(var_7);
        var_8 = wp::copy(var_9);
        // z = units[2 * _STRIDE + p]                                                         <L 99>
        var_11 = wp::mul(var_10, var_5);
        var_12 = wp::add(var_11, var_1);
        var_13 = wp::address(var_units, var_12);
        var_15 = wp::load(var_13);
        var_14 = wp::copy(var_15);
        // for m in range(wp.max(p * count - start, 0), wp.min((p + 1) * count - start, length), LANES):       <L 101>
        var_16 = wp::mul(var_1, var_count);
        var_17 = wp::sub(var_16, var_start);
        var_19 = wp::max(var_17, var_18);
        var_21 = wp::add(var_1, var_20);
        var_22 = wp::mul(var_21, var_count);
        var_23 = wp::sub(var_22, var_start);
        var_24 = wp::min(var_23, var_length);
        var_26 = wp::range(var_19, var_24, var_25);
        start_for_2:;
            if (iter_cmp(var_26) == 0) goto end_for_2;
            var_27 = wp::iter_next(var_26);
            // at = wp.array(ptr=repeated.ptr + wp.uint64(4 * m), shape=(3 * _STRIDE,), dtype=wp.float32)       <L 102>
            var_28 = (wp::uint64*)&(var_repeated.data);
            var_30 = wp::mul(var_29, var_27);
            var_31 = wp::uint64(var_30);
            var_33 = wp::load(var_28);
            var_32 = wp::add(var_33, var_31);
            var_35 = wp::mul(var_34, var_5);
            var_36 = wp::tuple(var_35);
            var_37 = wp::array_t<wp::float32>(var_32, var_35);
            // for k in range(LANES):                                                         <L 103>
            // at[k] = x                                                                      <L 104>
            wp::array_store(var_37, var_38, var_3);
            // at[_STRIDE + k] = y                                                            <L 105>
            var_39 = wp::add(var_5, var_38);
            wp::array_store(var_37, var_39, var_8);
            // at[2 * _STRIDE + k] = z                                                        <L 106>
            var_41 = wp::mul(var_40, var_5);
            var_42 = wp::add(var_41, var_38);
            wp::array_store(var_37, var_42, var_14);
            // at[k] = x                                                                      <L 104>
            wp::array_store(var_37, var_43, var_3);
            // at[_STRIDE + k] = y                                                            <L 105>
            var_44 = wp::add(var_5, var_43);
            wp::array_store(var_37, var_44, var_8);
            // at[2 * _STRIDE + k] = z                                                        <L 106>
            var_46 = wp::mul(var_45, var_5);
            var_47 = wp::add(var_46, var_43);
            wp::array_store(var_37, var_47, var_14);
            // at[k] = x                                                                      <L 104>
            wp::array_store(var_37, var_48, var_3);
            // at[_STRIDE + k] = y                                                            <L 105>
            var_49 = wp::add(var_5, var_48);
            wp::array_store(var_37, var_49, var_8);
            // at[2 * _STRIDE + k] = z                                                        <L 106>
            var_51 = wp::mul(var_50, var_5);
            var_52 = wp::add(var_51, var_48);
            wp::array_store(var_37, var_52, var_14);
            // at[k] = x                                                                      <L 104>
            wp::array_store(var_37, var_53, var_3);
            // at[_STRIDE + k] = y                                                            <L 105>
            var_54 = wp::add(var_5, var_53);
            wp::array_store(var_37, var_54, var_8);
            // at[2 * _STRIDE + k] = z                                                        <L 106>
            var_56 = wp::mul(var_55, var_5);
            var_57 = wp::add(var_56, var_53);
            wp::array_store(var_37, var_57, var_14);
            // at[k] = x                                                                      <L 104>
            wp::array_store(var_37, var_58, var_3);
            // at[_STRIDE + k] = y                                                            <L 105>
            var_59 = wp::add(var_5, var_58);
            wp::array_store(var_37, var_59, var_8);
            // at[2 * _STRIDE + k] = z                                                        <L 106>
            var_61 = wp::mul(var_60, var_5);
            var_62 = wp::add(var_61, var_58);
            wp::array_store(var_37, var_62, var_14);
            // at[k] = x                                                                      <L 104>
            wp::array_store(var_37, var_63, var_3);
            // at[_STRIDE + k] = y                                                            <L 105>
            var_64 = wp::add(var_5, var_63);
            wp::array_store(var_37, var_64, var_8);
            // at[2 * _STRIDE + k] = z                                                        <L 106>
            var_66 = wp::mul(var_65, var_5);
            var_67 = wp::add(var_66, var_63);
            wp::array_store(var_37, var_67, var_14);
            // at[k] = x                                                                      <L 104>
            wp::array_store(var_37, var_68, var_3);
            // at[_STRIDE + k] = y                                                            <L 105>
            var_69 = wp::add(var_5, var_68);
            wp::array_store(var_37, var_69, var_8);
            // at[2 * _STRIDE + k] = z                                                        <L 106>
            var_71 = wp::mul(var_70, var_5);
            var_72 = wp::add(var_71, var_68);
            wp::array_store(var_37, var_72, var_14);
            // at[k] = x                                                                      <L 104>
            wp::array_store(var_37, var_73, var_3);
            // at[_STRIDE + k] = y                                                            <L 105>
            var_74 = wp::add(var_5, var_73);
            wp::array_store(var_37, var_74, var_8);
            // at[2 * _STRIDE + k] = z                                                        <L 106>
            var_76 = wp::mul(var_75, var_5);
            var_77 = wp::add(var_76, var_73);
            wp::array_store(var_37, var_77, var_14);
            goto start_for_2;
        end_for_2:;
        goto start_for_0;
    end_for_0:;
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


// /work/main/warpsample/directions/samples.py:30
static void store_direction_0(
    wp::array_t<wp::float32> var_vectors,
    wp::array_t<wp::float32> var_pdf,
    wp::int32 var_i,
    wp::vec_t<4, wp::float32> var_d)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float32 var_1;
    const wp::int32 var_2 = 3;
    wp::int32 var_3;
    const wp::int32 var_4 = 1;
    wp::float32 var_5;
    const wp::int32 var_6 = 3;
    wp::int32 var_7;
    const wp::int32 var_8 = 1;
    wp::int32 var_9;
    const wp::int32 var_10 = 2;
    wp::float32 var_11;
    const wp::int32 var_12 = 3;
    wp::int32 var_13;
    const wp::int32 var_14 = 2;
    wp::int32 var_15;
    //---------
    // forward
    // def store_direction(vectors: wp.array[wp.float32], pdf: wp.array[wp.float32], i: wp.int32, d: wp.vec4):       <L 31>
    // vectors[3 * i] = d[0]                                                                  <L 33>
    var_1 = wp::extract(var_d, var_0);
    var_3 = wp::mul(var_2, var_i);
    wp::array_store(var_vectors, var_3, var_1);
    // vectors[3 * i + 1] = d[1]                                                              <L 34>
    var_5 = wp::extract(var_d, var_4);
    var_7 = wp::mul(var_6, var_i);
    var_9 = wp::add(var_7, var_8);
    wp::array_store(var_vectors, var_9, var_5);
    // vectors[3 * i + 2] = d[2]                                                              <L 35>
    var_11 = wp::extract(var_d, var_10);
    var_13 = wp::mul(var_12, var_i);
    var_15 = wp::add(var_13, var_14);
    wp::array_store(var_vectors, var_15, var_11);
}


// /work/main/warpsample/directions/samples.py:38
static void store_direction_and_pdf_0(
    wp::array_t<wp::float32> var_vectors,
    wp::array_t<wp::float32> var_pdf,
    wp::int32 var_i,
    wp::vec_t<4, wp::float32> var_d)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 3;
    wp::float32 var_1;
    //---------
    // forward
    // def store_direction_and_pdf(vectors: wp.array[wp.float32], pdf: wp.array[wp.float32], i: wp.int32, d: wp.vec4):       <L 39>
    // store_direction(vectors, pdf, i, d)                                                    <L 41>
    store_direction_0(var_vectors, var_pdf, var_i, var_d);
    // pdf[i] = d[3]                                                                          <L 42>
    var_1 = wp::extract(var_d, var_0);
    wp::array_store(var_pdf, var_i, var_1);
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


// /work/main/warpsample/directions/blocks.py:27
static void _build_mender__locals__mend_0(
    Samples_fe638941 var_samples,
    wp::int64 var_point,
    wp::int32 var_start,
    wp::int32 var_length,
    wp::array_t<wp::float32> var_normals,
    wp::array_t<wp::uint8> var_active,
    wp::array_t<wp::float32> var_vectors,
    wp::array_t<wp::float32> var_pdf)
{
    //---------
    // primal vars
    wp::range_t var_0;
    wp::int32 var_1;
    wp::int32 var_2;
    wp::int32* var_3;
    wp::int32 var_4;
    wp::int32 var_5;
    const wp::int32 var_6 = 3;
    wp::int32 var_7;
    wp::float32* var_8;
    const wp::int32 var_9 = 3;
    wp::int32 var_10;
    const wp::int32 var_11 = 1;
    wp::int32 var_12;
    wp::float32* var_13;
    const wp::int32 var_14 = 3;
    wp::int32 var_15;
    const wp::int32 var_16 = 2;
    wp::int32 var_17;
    wp::float32* var_18;
    wp::vec_t<3, wp::float32> var_19;
    wp::float32 var_20;
    wp::float32 var_21;
    wp::float32 var_22;
    wp::float32 var_23;
    wp::int32 var_24;
    const wp::int32 var_25 = 0;
    bool var_26;
    wp::uint64* var_27;
    wp::uint64 var_28;
    wp::uint64 var_29;
    wp::uint64 var_30;
    wp::uint64 var_31;
    wp::uint64 var_32;
    const wp::int32 var_33 = 1;
    wp::tuple_t<wp::int32> var_34;
    wp::array_t<wp::uint8> var_35;
    const wp::int32 var_36 = 1;
    wp::uint8 var_37;
    const wp::int32 var_38 = 0;
    const wp::float32 var_39 = 0.0;
    wp::vec_t<4, wp::float32> var_40;
    const bool var_41 = false;
    //---------
    // forward
    // def mend(                                                                              <L 28>
    // for i in range(length):                                                                <L 38>
    var_0 = wp::range(var_length);
    start_for_0:;
        if (iter_cmp(var_0) == 0) goto end_for_0;
        var_1 = wp::iter_next(var_0);
        // q = (start + i) / samples.count                                                    <L 39>
        var_2 = wp::add(var_start, var_1);
        var_3 = &((var_samples).count);
        var_5 = wp::load(var_3);
        var_4 = wp::div(var_2, var_5);
        // normal = wp.vec3(normals[3 * q], normals[3 * q + 1], normals[3 * q + 2])           <L 40>
        var_7 = wp::mul(var_6, var_4);
        var_8 = wp::address(var_normals, var_7);
        var_10 = wp::mul(var_9, var_4);
        var_12 = wp::add(var_10, var_11);
        var_13 = wp::address(var_normals, var_12);
        var_15 = wp::mul(var_14, var_4);
        var_17 = wp::add(var_15, var_16);
        var_18 = wp::address(var_normals, var_17);
        var_20 = wp::load(var_8);
        var_21 = wp::load(var_13);
        var_22 = wp::load(var_18);
        var_19 = wp::vec_t<3, wp::float32>(var_20, var_21, var_22);
        // code = normal_status(normal, weigh(active, q))                                     <L 41>
        var_23 = weigh_all_0(var_active, var_4);
        var_24 = normal_status_0(var_19, var_23);
        // if code != 0:                                                                      <L 42>
        var_26 = (var_24 != var_25);
        if (var_26) {
            // status = wp.array(ptr=samples.status + wp.uint64(point) + wp.uint64(q), shape=(1,), dtype=wp.uint8)       <L 43>
            var_27 = &((var_samples).status);
            var_28 = wp::uint64(var_point);
            var_30 = wp::load(var_27);
            var_29 = wp::add(var_30, var_28);
            var_31 = wp::uint64(var_4);
            var_32 = wp::add(var_29, var_31);
            var_34 = wp::tuple(var_33);
            var_35 = wp::array_t<wp::uint8>(var_32, var_36);
            // status[0] = wp.uint8(code)                                                     <L 44>
            var_37 = wp::uint8(var_24);
            wp::array_store(var_35, var_38, var_37);
            // store(vectors, pdf, i, wp.vec4(0.0))                                           <L 45>
            var_40 = wp::vec_t<4, wp::float32>(var_39);
            store_direction_and_pdf_0(var_vectors, var_pdf, var_1, var_40);
        }
        if (!var_26) {
            // elif wp.static(redraws):                                                       <L 46>
        }
        goto start_for_0;
    end_for_0:;
}


// /work/main/warpsample/directions/blocks.py:131
static void direction_blocks__locals__fill_block_0(
    Samples_fe638941 var_samples,
    wp::int64 var_first,
    wp::uint64 var_buffer)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 1;
    wp::int32 var_1;
    const bool var_2 = true;
    wp::int32* var_3;
    wp::int32 var_4;
    wp::int32 var_5;
    const wp::int64 var_6 = 256ll;
    wp::int64* var_7;
    wp::int64 var_8;
    wp::int64 var_9;
    wp::int64 var_10;
    wp::int64 var_11;
    wp::int64 var_12;
    wp::int32 var_13;
    wp::int64 var_14;
    wp::int64 var_15;
    wp::int64 var_16;
    wp::int64 var_17;
    wp::int64 var_18;
    wp::int32 var_19;
    wp::int32 var_20;
    const wp::int32 var_21 = 1;
    wp::int32 var_22;
    wp::int32 var_23;
    const wp::int32 var_24 = 1;
    wp::int32 var_25;
    wp::uint64* var_26;
    wp::uint64 var_27;
    wp::uint64 var_28;
    wp::uint64 var_29;
    wp::uint64 var_30;
    wp::uint64 var_31;
    const wp::int32 var_32 = 3;
    wp::int32 var_33;
    wp::tuple_t<wp::int32> var_34;
    wp::array_t<wp::float32> var_35;
    wp::uint64* var_36;
    wp::uint64 var_37;
    wp::uint64 var_38;
    wp::uint64 var_39;
    wp::uint64 var_40;
    wp::uint64 var_41;
    const wp::int32 var_42 = 3;
    wp::int32 var_43;
    wp::tuple_t<wp::int32> var_44;
    wp::array_t<wp::float32> var_45;
    wp::uint64* var_46;
    wp::uint64 var_47;
    wp::uint64 var_48;
    wp::uint64 var_49;
    wp::uint64 var_50;
    wp::uint64 var_51;
    wp::tuple_t<wp::int32> var_52;
    wp::array_t<wp::float32> var_53;
    wp::uint64* var_54;
    wp::uint64 var_55;
    wp::uint64 var_56;
    wp::uint64 var_57;
    wp::tuple_t<wp::int32> var_58;
    wp::array_t<wp::uint8> var_59;
    const wp::int32 var_60 = 2;
    const wp::int32 var_61 = 256;
    wp::int32 var_62;
    wp::tuple_t<wp::int32> var_63;
    wp::array_t<wp::float32> var_64;
    const wp::int32 var_65 = 8;
    wp::int32 var_66;
    wp::uint64 var_67;
    wp::uint64 var_68;
    const wp::int32 var_69 = 3;
    const wp::int32 var_70 = 264;
    wp::int32 var_71;
    wp::tuple_t<wp::int32> var_72;
    wp::array_t<wp::float32> var_73;
    wp::uint64 var_74;
    wp::uint64 var_75;
    const wp::int32 var_76 = 3;
    wp::int32 var_77;
    wp::tuple_t<wp::int32> var_78;
    wp::array_t<wp::float32> var_79;
    wp::int32 var_80;
    const bool var_81 = true;
    const wp::int32 var_82 = 0;
    wp::int32 var_83;
    bool var_84;
    wp::float32* var_85;
    wp::int32 var_86;
    wp::float32* var_87;
    const wp::int32 var_88 = 2;
    wp::int32 var_89;
    wp::int32 var_90;
    wp::float32* var_91;
    wp::vec_t<3, wp::float32> var_92;
    wp::float32 var_93;
    wp::float32 var_94;
    wp::float32 var_95;
    wp::float32* var_96;
    const wp::float32 var_97 = 0.0;
    wp::float32 var_98;
    wp::float32 var_99;
    wp::int32 var_100;
    wp::float32* var_101;
    const wp::float32 var_102 = 0.0;
    wp::float32 var_103;
    wp::float32 var_104;
    wp::vec_t<2, wp::float32> var_105;
    Parameters_f3aa772c* var_106;
    wp::vec_t<4, wp::float32> var_107;
    Parameters_f3aa772c var_108;
    const bool var_109 = false;
    const wp::int32 var_110 = 1;
    wp::int32 var_111;
    const wp::int32 var_112 = 0;
    bool var_113;
    //---------
    // forward
    // def fill_block(samples: Samples, first: wp.int64, buffer: wp.uint64):                  <L 132>
    // count = wp.int32(1)                                                                    <L 133>
    var_1 = wp::int32(var_0);
    // if wp.static(not one_sample):                                                          <L 134>
    // count = samples.count                                                                  <L 135>
    var_3 = &((var_samples).count);
    var_5 = wp::load(var_3);
    var_4 = wp::copy(var_5);
    // length = wp.int32(wp.min(_BLOCK, samples.points * wp.int64(count) - first))            <L 136>
    var_7 = &((var_samples).points);
    var_8 = wp::int64(var_4);
    var_10 = wp::load(var_7);
    var_9 = wp::mul(var_10, var_8);
    var_11 = wp::sub(var_9, var_first);
    var_12 = wp::min(var_6, var_11);
    var_13 = wp::int32(var_12);
    // point = first / wp.int64(count)                                                        <L 137>
    var_14 = wp::int64(var_4);
    var_15 = wp::div(var_first, var_14);
    // start = wp.int32(first - point * wp.int64(count))                                      <L 138>
    var_16 = wp::int64(var_4);
    var_17 = wp::mul(var_15, var_16);
    var_18 = wp::sub(var_first, var_17);
    var_19 = wp::int32(var_18);
    // span = (start + length - 1) / count + 1                                                <L 139>
    var_20 = wp::add(var_19, var_13);
    var_22 = wp::sub(var_20, var_21);
    var_23 = wp::div(var_22, var_4);
    var_25 = wp::add(var_23, var_24);
    // normals = wp.array(ptr=samples.normals + wp.uint64(point) * wp.uint64(12), shape=(3 * span,), dtype=wp.float32)       <L 140>
    var_26 = &((var_samples).normals);
    var_27 = wp::uint64(var_15);
    var_28 = 12ull;
    var_29 = wp::mul(var_27, var_28);
    var_31 = wp::load(var_26);
    var_30 = wp::add(var_31, var_29);
    var_33 = wp::mul(var_32, var_25);
    var_34 = wp::tuple(var_33);
    var_35 = wp::array_t<wp::float32>(var_30, var_33);
    // vectors = wp.array(ptr=samples.vectors + wp.uint64(first) * wp.uint64(12), shape=(3 * length,), dtype=wp.float32)       <L 141>
    var_36 = &((var_samples).vectors);
    var_37 = wp::uint64(var_first);
    var_38 = 12ull;
    var_39 = wp::mul(var_37, var_38);
    var_41 = wp::load(var_36);
    var_40 = wp::add(var_41, var_39);
    var_43 = wp::mul(var_42, var_13);
    var_44 = wp::tuple(var_43);
    var_45 = wp::array_t<wp::float32>(var_40, var_43);
    // pdf = wp.array(ptr=samples.pdf + wp.uint64(first) * wp.uint64(4), shape=(length,), dtype=wp.float32)       <L 142>
    var_46 = &((var_samples).pdf);
    var_47 = wp::uint64(var_first);
    var_48 = 4ull;
    var_49 = wp::mul(var_47, var_48);
    var_51 = wp::load(var_46);
    var_50 = wp::add(var_51, var_49);
    var_52 = wp::tuple(var_13);
    var_53 = wp::array_t<wp::float32>(var_50, var_13);
    // active = wp.array(ptr=samples.active + wp.uint64(point), shape=(span,), dtype=wp.uint8)       <L 143>
    var_54 = &((var_samples).active);
    var_55 = wp::uint64(var_15);
    var_57 = wp::load(var_54);
    var_56 = wp::add(var_57, var_55);
    var_58 = wp::tuple(var_25);
    var_59 = wp::array_t<wp::uint8>(var_56, var_25);
    // u = wp.array(ptr=buffer, shape=(2 * FLAT_BLOCK,), dtype=wp.float32)                    <L 144>
    var_62 = wp::mul(var_60, var_61);
    var_63 = wp::tuple(var_62);
    var_64 = wp::array_t<wp::float32>(var_buffer, var_62);
    // units = wp.array(ptr=buffer + wp.uint64(8 * FLAT_BLOCK), shape=(3 * _STRIDE,), dtype=wp.float32)       <L 145>
    var_66 = wp::mul(var_65, var_61);
    var_67 = wp::uint64(var_66);
    var_68 = wp::add(var_buffer, var_67);
    var_71 = wp::mul(var_69, var_70);
    var_72 = wp::tuple(var_71);
    var_73 = wp::array_t<wp::float32>(var_68, var_71);
    // repeated = wp.array(ptr=buffer + wp.uint64(repeated_at), shape=(3 * _STRIDE,), dtype=wp.float32)       <L 146>
    var_74 = 5216ull;
    var_75 = wp::add(var_buffer, var_74);
    var_77 = wp::mul(var_76, var_70);
    var_78 = wp::tuple(var_77);
    var_79 = wp::array_t<wp::float32>(var_75, var_77);
    // rare = write_units(normals, active, span, units)                                       <L 147>
    var_80 = build_unit_writer__locals__write_units_0(var_35, var_59, var_25, var_73);
    // fill(samples, point, start, length, u)                                                 <L 148>
    _build_block_variates__locals__fill_0(var_samples, var_15, var_19, var_13, var_64);
    // if wp.static(not one_sample):                                                          <L 149>
    // _repeat_normals(units, span, count, start, length, repeated)                           <L 150>
    _repeat_normals_0(var_73, var_25, var_4, var_19, var_13, var_79);
    // j = wp.int32(0)                                                                        <L 151>
    var_83 = wp::int32(var_82);
    // while j < length:                                                                      <L 152>
    start_while_0:;
    var_84 = (var_83 < var_13);
    if ((var_84) == false) goto end_while_0;
        // n = wp.vec3(repeated[j], repeated[_STRIDE + j], repeated[2 * _STRIDE + j])         <L 153>
        var_85 = wp::address(var_79, var_83);
        var_86 = wp::add(var_70, var_83);
        var_87 = wp::address(var_79, var_86);
        var_89 = wp::mul(var_88, var_70);
        var_90 = wp::add(var_89, var_83);
        var_91 = wp::address(var_79, var_90);
        var_93 = wp::load(var_85);
        var_94 = wp::load(var_87);
        var_95 = wp::load(var_91);
        var_92 = wp::vec_t<3, wp::float32>(var_93, var_94, var_95);
        // d = about(n, wp.vec2(u[j] + 0.0, u[FLAT_BLOCK + j] + 0.0), samples.parameters)       <L 154>
        var_96 = wp::address(var_64, var_83);
        var_99 = wp::load(var_96);
        var_98 = wp::add(var_99, var_97);
        var_100 = wp::add(var_61, var_83);
        var_101 = wp::address(var_64, var_100);
        var_104 = wp::load(var_101);
        var_103 = wp::add(var_104, var_102);
        var_105 = wp::vec_t<2, wp::float32>(var_98, var_103);
        var_106 = &((var_samples).parameters);
        var_108 = wp::load(var_106);
        var_107 = build_about__locals__about_0(var_92, var_105, var_108);
        // store(vectors, pdf, j, d)                                                          <L 155>
        store_direction_and_pdf_0(var_45, var_53, var_83, var_107);
        // if wp.static(redraws):                                                             <L 156>
        // j += 1                                                                             <L 158>
        var_111 = wp::add(var_83, var_110);
        wp::assign(var_83, var_111);
    goto start_while_0;
    end_while_0:;
    // if rare != 0:                                                                          <L 159>
    var_113 = (var_80 != var_112);
    if (var_113) {
        // mend(samples, point, start, length, normals, active, vectors, pdf)                 <L 160>
        _build_mender__locals__mend_0(var_samples, var_15, var_19, var_13, var_35, var_59, var_45, var_53);
    }
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


// /work/main/warpsample/directions/samples.py:51
static void adj_weigh_all_0(
    wp::array_t<wp::uint8> var_active,
    wp::int32 var_i,
    wp::array_t<wp::uint8> & adj_active,
    wp::int32 & adj_i,
    wp::float32 & adj_ret)
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


// /work/main/warpsample/directions/samples.py:109
static void adj_build_unit_writer__locals__write_units_0(
    wp::array_t<wp::float32> var_normals,
    wp::array_t<wp::uint8> var_active,
    wp::int32 var_rows,
    wp::array_t<wp::float32> var_units,
    wp::array_t<wp::float32> & adj_normals,
    wp::array_t<wp::uint8> & adj_active,
    wp::int32 & adj_rows,
    wp::array_t<wp::float32> & adj_units,
    wp::int32 & adj_ret)
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


// /work/main/warpsample/maths/numerics.py:94
static void adj_reverse_bits_0(
    wp::uint32 var_x,
    wp::uint32 & adj_x,
    wp::uint32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/sequences/sobol.py:14
static void adj_laine_karras_0(
    wp::uint32 var_x,
    wp::uint32 var_key,
    wp::uint32 & adj_x,
    wp::uint32 & adj_key,
    wp::uint32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/sequences/sobol.py:27
static void adj_sobol_second_0(
    wp::uint32 var_index,
    wp::uint32 & adj_index,
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


// /work/main/warpsample/sequences/sobol.py:41
static void adj__scramble_0(
    wp::uint32 var_index,
    wp::uint32 var_second,
    wp::vec_t<4, wp::uint32> var_key,
    wp::uint32 & adj_index,
    wp::uint32 & adj_second,
    wp::vec_t<4, wp::uint32> & adj_key,
    wp::vec_t<2, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/sequences/sobol.py:49
static void adj_sobol_sample_0(
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


// /work/main/warpsample/directions/blocks.py:61
static void adj__build_block_variates__locals__fill_0(
    Samples_fe638941 var_samples,
    wp::int64 var_point,
    wp::int32 var_start,
    wp::int32 var_length,
    wp::array_t<wp::float32> var_u,
    Samples_fe638941 & adj_samples,
    wp::int64 & adj_point,
    wp::int32 & adj_start,
    wp::int32 & adj_length,
    wp::array_t<wp::float32> & adj_u)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/directions/blocks.py:86
static void adj__repeat_normals_0(
    wp::array_t<wp::float32> var_units,
    wp::int32 var_points,
    wp::int32 var_count,
    wp::int32 var_start,
    wp::int32 var_length,
    wp::array_t<wp::float32> var_repeated,
    wp::array_t<wp::float32> & adj_units,
    wp::int32 & adj_points,
    wp::int32 & adj_count,
    wp::int32 & adj_start,
    wp::int32 & adj_length,
    wp::array_t<wp::float32> & adj_repeated)
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


// /work/main/warpsample/directions/samples.py:30
static void adj_store_direction_0(
    wp::array_t<wp::float32> var_vectors,
    wp::array_t<wp::float32> var_pdf,
    wp::int32 var_i,
    wp::vec_t<4, wp::float32> var_d,
    wp::array_t<wp::float32> & adj_vectors,
    wp::array_t<wp::float32> & adj_pdf,
    wp::int32 & adj_i,
    wp::vec_t<4, wp::float32> & adj_d)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/directions/samples.py:38
static void adj_store_direction_and_pdf_0(
    wp::array_t<wp::float32> var_vectors,
    wp::array_t<wp::float32> var_pdf,
    wp::int32 var_i,
    wp::vec_t<4, wp::float32> var_d,
    wp::array_t<wp::float32> & adj_vectors,
    wp::array_t<wp::float32> & adj_pdf,
    wp::int32 & adj_i,
    wp::vec_t<4, wp::float32> & adj_d)
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


// /work/main/warpsample/directions/blocks.py:27
static void adj__build_mender__locals__mend_0(
    Samples_fe638941 var_samples,
    wp::int64 var_point,
    wp::int32 var_start,
    wp::int32 var_length,
    wp::array_t<wp::float32> var_normals,
    wp::array_t<wp::uint8> var_active,
    wp::array_t<wp::float32> var_vectors,
    wp::array_t<wp::float32> var_pdf,
    Samples_fe638941 & adj_samples,
    wp::int64 & adj_point,
    wp::int32 & adj_start,
    wp::int32 & adj_length,
    wp::array_t<wp::float32> & adj_normals,
    wp::array_t<wp::uint8> & adj_active,
    wp::array_t<wp::float32> & adj_vectors,
    wp::array_t<wp::float32> & adj_pdf)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/directions/blocks.py:131
static void adj_direction_blocks__locals__fill_block_0(
    Samples_fe638941 var_samples,
    wp::int64 var_first,
    wp::uint64 var_buffer,
    Samples_fe638941 & adj_samples,
    wp::int64 & adj_first,
    wp::uint64 & adj_buffer)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}

struct wp_args_direction_blocks__locals__direction_blocks_fffb756b {
    Samples_fe638941 samples;
    wp::int64 first_task;
};


template <bool wp_linear_contiguous>
static void direction_blocks__locals__direction_blocks_fffb756b_cpu_kernel_forward(
    wp::launch_bounds_t<1> dim,
    size_t task_index,
    wp_args_direction_blocks__locals__direction_blocks_fffb756b *_wp_args)
{
    static constexpr bool wp_linear_tid = wp_linear_contiguous;

    //---------
    // argument vars
    Samples_fe638941 var_samples = _wp_args->samples;
    wp::int64 var_first_task = _wp_args->first_task;
    //---------
    // primal vars
    const wp::int32 var_0 = 2096;
    wp::tuple_t<wp::int32> var_1;
    wp::fixedarray_t<2096, wp::float32> var_2;
    const wp::int32 var_3 = 2096;
    wp::int32 var_4;
    wp::int64 var_5;
    wp::int64 var_6;
    wp::int32* var_7;
    wp::int64 var_8;
    wp::int32 var_9;
    wp::int64 var_10;
    const wp::int64 var_11 = 256ll;
    wp::int64 var_12;
    wp::int32* var_13;
    wp::int64 var_14;
    wp::int32 var_15;
    wp::int64 var_16;
    wp::int64 var_17;
    wp::int64* var_18;
    wp::int32* var_19;
    wp::int64 var_20;
    wp::int32 var_21;
    wp::int64 var_22;
    wp::int64 var_23;
    wp::int64 var_24;
    bool var_25;
    wp::uint64* var_26;
    wp::uint64 var_27;
    wp::int64 var_28;
    //---------
    // forward
    // def direction_blocks(samples: Samples, first_task: wp.int64):                          <L 163>
    // buffer = wp.zeros(shape=(floats,), dtype=wp.float32)                                   <L 164>
    var_1 = wp::tuple(var_0);
    var_2 = wp::fixedarray_t<2096, wp::float32>(var_3);
    // first = (first_task + wp.int64(wp.tid())) * wp.int64(samples.rows) * _BLOCK            <L 165>
    var_4 = builtin_tid1d();
    var_5 = wp::int64(var_4);
    var_6 = wp::add(var_first_task, var_5);
    var_7 = &((var_samples).rows);
    var_9 = wp::load(var_7);
    var_8 = wp::int64(var_9);
    var_10 = wp::mul(var_6, var_8);
    var_12 = wp::mul(var_10, var_11);
    // end = wp.min(first + wp.int64(samples.rows) * _BLOCK, samples.points * wp.int64(samples.count))       <L 166>
    var_13 = &((var_samples).rows);
    var_15 = wp::load(var_13);
    var_14 = wp::int64(var_15);
    var_16 = wp::mul(var_14, var_11);
    var_17 = wp::add(var_12, var_16);
    var_18 = &((var_samples).points);
    var_19 = &((var_samples).count);
    var_21 = wp::load(var_19);
    var_20 = wp::int64(var_21);
    var_23 = wp::load(var_18);
    var_22 = wp::mul(var_23, var_20);
    var_24 = wp::min(var_17, var_22);
    // while first < end:                                                                     <L 167>
    start_while_0:;
    var_25 = (var_12 < var_24);
    if ((var_25) == false) goto end_while_0;
        // fill_block(samples, first, buffer.ptr)                                             <L 168>
        var_26 = (wp::uint64*)&(var_2.data);
        var_27 = wp::load(var_26);
        direction_blocks__locals__fill_block_0(var_samples, var_12, var_27);
        // first += _BLOCK                                                                    <L 169>
        var_28 = wp::add(var_12, var_11);
        wp::assign(var_12, var_28);
    goto start_while_0;
    end_while_0:;
}



template <bool wp_linear_contiguous>
static WP_FORCEINLINE void direction_blocks__locals__direction_blocks_fffb756b_cpu_forward_tasks(
    wp::launch_bounds_t<1> *dim,
    wp_args_direction_blocks__locals__direction_blocks_fffb756b *_wp_args)
{
    for (size_t task_index = 0; task_index < dim->size; ++task_index)
    {
        direction_blocks__locals__direction_blocks_fffb756b_cpu_kernel_forward<wp_linear_contiguous>(*dim, task_index, _wp_args);
    }
}

static WP_FORCEINLINE void direction_blocks__locals__direction_blocks_fffb756b_cpu_forward_dispatch(
    wp::launch_bounds_t<1> *dim,
    wp_args_direction_blocks__locals__direction_blocks_fffb756b *_wp_args)
{
    wp::tile_shared_storage_t tile_mem;
#if defined(WP_ENABLE_TILES_IN_STACK_MEMORY)
    wp::shared_tile_storage = &tile_mem;
#endif

    direction_blocks__locals__direction_blocks_fffb756b_cpu_forward_tasks<false>(dim, _wp_args);
}

extern "C" {

// Python CPU entry points
WP_API void direction_blocks__locals__direction_blocks_fffb756b_cpu_forward(
    wp::launch_bounds_t<1> *dim,
    wp_args_direction_blocks__locals__direction_blocks_fffb756b *_wp_args)
{
    direction_blocks__locals__direction_blocks_fffb756b_cpu_forward_dispatch(dim, _wp_args);
}

} // extern C

