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


// /work/main/warpsample/mesh/placing.py:32
static void _drawer__locals__draw_0(
    wp::uint64 var_seed,
    wp::uint64 var_first,
    wp::int32 var_length,
    wp::float64 var_total,
    wp::int32 var_guide_bits,
    wp::array_t<wp::float64> var_shares,
    wp::array_t<wp::uint32> var_buckets,
    wp::array_t<wp::uint32> var_words)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    bool var_2;
    wp::uint64 var_3;
    wp::uint64 var_4;
    const wp::int32 var_5 = 0;
    wp::uint32 var_6;
    wp::uint32 var_7;
    wp::uint32 var_8;
    const wp::uint32 var_9 = 1u;
    wp::vec_t<4, wp::uint32> var_10;
    wp::uint32 var_11;
    wp::uint32 var_12;
    wp::vec_t<4, wp::uint32> var_13;
    const wp::int32 var_14 = 0;
    wp::uint32 var_15;
    wp::float64 var_16;
    const wp::int32 var_17 = 1;
    wp::uint32 var_18;
    wp::float64 var_19;
    const wp::float64 var_20 = 2.3283064365386963e-10;
    wp::float64 var_21;
    wp::float64 var_22;
    wp::float64 var_23;
    wp::float64 var_24;
    const wp::int32 var_25 = 0;
    wp::uint32 var_26;
    wp::uint64 var_27;
    const wp::int32 var_28 = 32;
    wp::int32 var_29;
    wp::uint64 var_30;
    wp::uint64 var_31;
    wp::uint32 var_32;
    const wp::int32 var_33 = 2;
    wp::uint32 var_34;
    const wp::int32 var_35 = 3;
    wp::uint32 var_36;
    const wp::int32 var_37 = 64;
    wp::int32 var_38;
    const wp::int32 var_39 = 1;
    wp::int32 var_40;
    //---------
    // forward
    // def draw(                                                                              <L 33>
    // k = wp.int32(0)                                                                        <L 43>
    var_1 = wp::int32(var_0);
    // while k < length:                                                                      <L 44>
    start_while_0:;
    var_2 = (var_1 < var_length);
    if ((var_2) == false) goto end_while_0;
        // id = first + wp.uint64(k)                                                          <L 45>
        var_3 = wp::uint64(var_1);
        var_4 = wp::add(var_first, var_3);
        // counter = wp.vec4ui(wp.uint32(0), low_word(id), high_word(id), _SURFACE_STREAM)       <L 46>
        var_6 = wp::uint32(var_5);
        var_7 = low_word_0(var_4);
        var_8 = high_word_0(var_4);
        var_10 = wp::vec_t<4, wp::uint32>(var_6, var_7, var_8, var_9);
        // bits = philox4x32_10(counter, low_word(seed), high_word(seed))                     <L 47>
        var_11 = low_word_0(var_seed);
        var_12 = high_word_0(var_seed);
        var_13 = philox4x32_10_0(var_10, var_11, var_12);
        // shares[k] = (wp.float64(bits[0]) + wp.float64(bits[1]) * _WORD_STEP) * _WORD_STEP * total       <L 48>
        var_15 = wp::extract(var_13, var_14);
        var_16 = wp::float64(var_15);
        var_18 = wp::extract(var_13, var_17);
        var_19 = wp::float64(var_18);
        var_21 = wp::mul(var_19, var_20);
        var_22 = wp::add(var_16, var_21);
        var_23 = wp::mul(var_22, var_20);
        var_24 = wp::mul(var_23, var_total);
        wp::array_store(var_shares, var_1, var_24);
        // buckets[k] = wp.uint32(wp.uint64(bits[0]) >> wp.uint64(32 - guide_bits))           <L 49>
        var_26 = wp::extract(var_13, var_25);
        var_27 = wp::uint64(var_26);
        var_29 = wp::sub(var_28, var_guide_bits);
        var_30 = wp::uint64(var_29);
        var_31 = wp::rshift(var_27, var_30);
        var_32 = wp::uint32(var_31);
        wp::array_store(var_buckets, var_1, var_32);
        // words[k] = bits[2]                                                                 <L 50>
        var_34 = wp::extract(var_13, var_33);
        wp::array_store(var_words, var_1, var_34);
        // words[block + k] = bits[3]                                                         <L 51>
        var_36 = wp::extract(var_13, var_35);
        var_38 = wp::add(var_37, var_1);
        wp::array_store(var_words, var_38, var_36);
        // k += 1                                                                             <L 52>
        var_40 = wp::add(var_1, var_39);
        wp::assign(var_1, var_40);
    goto start_while_0;
    end_while_0:;
}


// /work/main/warpsample/mesh/placing.py:57
static wp::int32 _face_of_0(
    wp::float64 var_share,
    wp::array_t<wp::float64> var_areas,
    wp::int32 var_low,
    wp::int32 var_high)
{
    //---------
    // primal vars
    bool var_0;
    wp::int32 var_1;
    const wp::int32 var_2 = 2;
    wp::int32 var_3;
    wp::float64* var_4;
    bool var_5;
    wp::float64 var_6;
    wp::int32 var_7;
    const wp::int32 var_8 = 1;
    wp::int32 var_9;
    wp::int32 var_10;
    wp::int32 var_11;
    //---------
    // forward
    // def _face_of(share: wp.float64, areas: wp.array[wp.float64], low: wp.int32, high: wp.int32) -> wp.int32:       <L 58>
    // while low < high:                                                                      <L 60>
    start_while_0:;
    var_0 = (var_low < var_high);
    if ((var_0) == false) goto end_while_0;
        // middle = (low + high) / 2                                                          <L 61>
        var_1 = wp::add(var_low, var_high);
        var_3 = wp::div(var_1, var_2);
        // if areas[middle] > share:                                                          <L 62>
        var_4 = wp::address(var_areas, var_3);
        var_6 = wp::load(var_4);
        var_5 = (var_6 > var_share);
        if (var_5) {
            // high = middle                                                                  <L 63>
            var_7 = wp::copy(var_3);
        }
        if (!var_5) {
            // low = middle + 1                                                               <L 65>
            var_9 = wp::add(var_3, var_8);
        }
        var_10 = wp::where(var_5, var_low, var_9);
        var_11 = wp::where(var_5, var_7, var_high);
        wp::assign(var_low, var_10);
        wp::assign(var_high, var_11);
    goto start_while_0;
    end_while_0:;
    // return low                                                                             <L 66>
    return var_low;
}


// /work/main/warpsample/mesh/placing.py:69
static wp::vec_t<3, wp::float64> _weights_of_0(
    wp::uint32 var_first,
    wp::uint32 var_second)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::float64 var_1;
    wp::float64 var_2;
    const wp::float64 var_3 = 2.3283064365386963e-10;
    wp::float64 var_4;
    wp::float64 var_5;
    wp::float64 var_6;
    wp::float64 var_7;
    wp::float64 var_8;
    wp::float64 var_9;
    wp::float64 var_10;
    wp::float64 var_11;
    wp::float64 var_12;
    wp::float64 var_13;
    wp::float64 var_14;
    wp::float64 var_15;
    wp::vec_t<3, wp::float64> var_16;
    //---------
    // forward
    // def _weights_of(first: wp.uint32, second: wp.uint32) -> wp.vec3d:                      <L 70>
    // root = wp.sqrt((wp.float64(first) + wp.float64(0.5)) * _WORD_STEP)                     <L 72>
    var_0 = wp::float64(var_first);
    var_1 = 0.5;
    var_2 = wp::add(var_0, var_1);
    var_4 = wp::mul(var_2, var_3);
    var_5 = wp::sqrt(var_4);
    // split = (wp.float64(second) + wp.float64(0.5)) * _WORD_STEP                            <L 73>
    var_6 = wp::float64(var_second);
    var_7 = 0.5;
    var_8 = wp::add(var_6, var_7);
    var_9 = wp::mul(var_8, var_3);
    // return wp.vec3d(wp.float64(1.0) - root, root * (wp.float64(1.0) - split), root * split)       <L 74>
    var_10 = 1.0;
    var_11 = wp::sub(var_10, var_5);
    var_12 = 1.0;
    var_13 = wp::sub(var_12, var_9);
    var_14 = wp::mul(var_5, var_13);
    var_15 = wp::mul(var_5, var_9);
    var_16 = wp::vec_t<3, wp::float64>(var_11, var_14, var_15);
    return var_16;
}


// /work/main/warpsample/maths/numerics.py:64
static void adj_low_word_0(
    wp::uint64 var_x,
    wp::uint64 & adj_x,
    wp::uint32 & adj_ret)
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


// /work/main/warpsample/mesh/placing.py:32
static void adj__drawer__locals__draw_0(
    wp::uint64 var_seed,
    wp::uint64 var_first,
    wp::int32 var_length,
    wp::float64 var_total,
    wp::int32 var_guide_bits,
    wp::array_t<wp::float64> var_shares,
    wp::array_t<wp::uint32> var_buckets,
    wp::array_t<wp::uint32> var_words,
    wp::uint64 & adj_seed,
    wp::uint64 & adj_first,
    wp::int32 & adj_length,
    wp::float64 & adj_total,
    wp::int32 & adj_guide_bits,
    wp::array_t<wp::float64> & adj_shares,
    wp::array_t<wp::uint32> & adj_buckets,
    wp::array_t<wp::uint32> & adj_words)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/mesh/placing.py:57
static void adj__face_of_0(
    wp::float64 var_share,
    wp::array_t<wp::float64> var_areas,
    wp::int32 var_low,
    wp::int32 var_high,
    wp::float64 & adj_share,
    wp::array_t<wp::float64> & adj_areas,
    wp::int32 & adj_low,
    wp::int32 & adj_high,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/warpsample/mesh/placing.py:69
static void adj__weights_of_0(
    wp::uint32 var_first,
    wp::uint32 var_second,
    wp::uint32 & adj_first,
    wp::uint32 & adj_second,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}

struct wp_args_place_points__locals__place_points_8f7d4796 {
    wp::uint64 seed;
    wp::uint64 first_point;
    wp::int32 points;
    wp::int32 vertex_count;
    wp::int32 last_face;
    wp::uint64 vertices;
    wp::uint64 faces;
    wp::uint64 cumulative;
    wp::uint64 guide;
    wp::int32 guide_bits;
    wp::uint64 normals;
    wp::uint64 position;
    wp::uint64 normal;
    wp::uint64 face;
    wp::uint64 barycentric;
    wp::int64 first_task;
};


template <bool wp_linear_contiguous>
static void place_points__locals__place_points_8f7d4796_cpu_kernel_forward(
    wp::launch_bounds_t<1> dim,
    size_t task_index,
    wp_args_place_points__locals__place_points_8f7d4796 *_wp_args)
{
    static constexpr bool wp_linear_tid = wp_linear_contiguous;

    //---------
    // argument vars
    wp::uint64 var_seed = _wp_args->seed;
    wp::uint64 var_first_point = _wp_args->first_point;
    wp::int32 var_points = _wp_args->points;
    wp::int32 var_vertex_count = _wp_args->vertex_count;
    wp::int32 var_last_face = _wp_args->last_face;
    wp::uint64 var_vertices = _wp_args->vertices;
    wp::uint64 var_faces = _wp_args->faces;
    wp::uint64 var_cumulative = _wp_args->cumulative;
    wp::uint64 var_guide = _wp_args->guide;
    wp::int32 var_guide_bits = _wp_args->guide_bits;
    wp::uint64 var_normals = _wp_args->normals;
    wp::uint64 var_position = _wp_args->position;
    wp::uint64 var_normal = _wp_args->normal;
    wp::uint64 var_face = _wp_args->face;
    wp::uint64 var_barycentric = _wp_args->barycentric;
    wp::int64 var_first_task = _wp_args->first_task;
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int32 var_1;
    wp::int32 var_2;
    const wp::int32 var_3 = 64;
    wp::int32 var_4;
    wp::int32 var_5;
    wp::int32 var_6;
    wp::tuple_t<wp::int32> var_7;
    wp::array_t<wp::vec_t<3, wp::float64>> var_8;
    const wp::int32 var_9 = 1;
    wp::int32 var_10;
    wp::tuple_t<wp::int32> var_11;
    wp::array_t<wp::vec_t<3, wp::int32>> var_12;
    const wp::int32 var_13 = 1;
    wp::int32 var_14;
    wp::tuple_t<wp::int32> var_15;
    wp::array_t<wp::float64> var_16;
    const wp::int32 var_17 = 1;
    wp::int32 var_18;
    wp::tuple_t<wp::int32> var_19;
    wp::array_t<wp::vec_t<3, wp::float32>> var_20;
    wp::tuple_t<wp::int32> var_21;
    wp::array_t<wp::vec_t<3, wp::float64>> var_22;
    wp::tuple_t<wp::int32> var_23;
    wp::array_t<wp::vec_t<3, wp::float32>> var_24;
    wp::tuple_t<wp::int32> var_25;
    wp::array_t<wp::int32> var_26;
    wp::tuple_t<wp::int32> var_27;
    wp::fixedarray_t<64, wp::float64> var_28;
    const wp::int32 var_29 = 64;
    wp::tuple_t<wp::int32> var_30;
    wp::fixedarray_t<64, wp::uint32> var_31;
    const wp::int32 var_32 = 64;
    const wp::int32 var_33 = 128;
    wp::tuple_t<wp::int32> var_34;
    wp::fixedarray_t<128, wp::uint32> var_35;
    const wp::int32 var_36 = 128;
    wp::uint64 var_37;
    wp::uint64 var_38;
    wp::float64* var_39;
    wp::float64 var_40;
    wp::range_t var_41;
    wp::int32 var_42;
    wp::uint64 var_43;
    wp::uint32* var_44;
    wp::uint64 var_45;
    wp::uint32 var_46;
    wp::uint64 var_47;
    wp::uint64 var_48;
    const wp::int32 var_49 = 2;
    wp::tuple_t<wp::int32> var_50;
    wp::array_t<wp::int32> var_51;
    const wp::int32 var_52 = 2;
    wp::float64* var_53;
    const wp::int32 var_54 = 0;
    wp::int32* var_55;
    const wp::int32 var_56 = 1;
    wp::int32* var_57;
    wp::int32 var_58;
    wp::float64 var_59;
    wp::int32 var_60;
    wp::int32 var_61;
    wp::int32 var_62;
    wp::range_t var_63;
    wp::int32 var_64;
    wp::int32 var_65;
    wp::uint32* var_66;
    wp::int32 var_67;
    wp::uint32* var_68;
    wp::vec_t<3, wp::float64> var_69;
    wp::uint32 var_70;
    wp::uint32 var_71;
    wp::int32* var_72;
    wp::int32 var_73;
    wp::vec_t<3, wp::int32>* var_74;
    wp::vec_t<3, wp::int32> var_75;
    wp::vec_t<3, wp::int32> var_76;
    const wp::int32 var_77 = 0;
    wp::int32 var_78;
    wp::vec_t<3, wp::float64>* var_79;
    wp::vec_t<3, wp::float64> var_80;
    wp::vec_t<3, wp::float64> var_81;
    const wp::int32 var_82 = 1;
    wp::float64 var_83;
    const wp::int32 var_84 = 1;
    wp::int32 var_85;
    wp::vec_t<3, wp::float64>* var_86;
    wp::vec_t<3, wp::float64> var_87;
    wp::vec_t<3, wp::float64> var_88;
    wp::vec_t<3, wp::float64> var_89;
    wp::vec_t<3, wp::float64> var_90;
    const wp::int32 var_91 = 2;
    wp::float64 var_92;
    const wp::int32 var_93 = 2;
    wp::int32 var_94;
    wp::vec_t<3, wp::float64>* var_95;
    wp::vec_t<3, wp::float64> var_96;
    wp::vec_t<3, wp::float64> var_97;
    wp::vec_t<3, wp::float64> var_98;
    wp::vec_t<3, wp::float64> var_99;
    wp::int32* var_100;
    wp::int32 var_101;
    wp::vec_t<3, wp::float32>* var_102;
    wp::vec_t<3, wp::float32> var_103;
    wp::vec_t<3, wp::float32> var_104;
    wp::uint64 var_105;
    bool var_106;
    wp::tuple_t<wp::int32> var_107;
    wp::array_t<wp::vec_t<3, wp::float64>> var_108;
    //---------
    // forward
    // def place_points(                                                                      <L 86>
    // start = (wp.int32(first_task) + wp.tid()) * block                                      <L 105>
    var_0 = wp::int32(var_first_task);
    var_1 = builtin_tid1d();
    var_2 = wp::add(var_0, var_1);
    var_4 = wp::mul(var_2, var_3);
    // length = wp.min(block, points - start)                                                 <L 106>
    var_5 = wp::sub(var_points, var_4);
    var_6 = wp::min(var_3, var_5);
    // corners = wp.array(ptr=vertices, shape=(vertex_count,), dtype=wp.vec3d)                <L 107>
    var_7 = wp::tuple(var_vertex_count);
    var_8 = wp::array_t<wp::vec_t<3, wp::float64>>(var_vertices, var_vertex_count);
    // triangles = wp.array(ptr=faces, shape=(last_face + 1,), dtype=wp.vec3i)                <L 108>
    var_10 = wp::add(var_last_face, var_9);
    var_11 = wp::tuple(var_10);
    var_12 = wp::array_t<wp::vec_t<3, wp::int32>>(var_faces, var_10);
    // areas = wp.array(ptr=cumulative, shape=(last_face + 1,), dtype=wp.float64)             <L 109>
    var_14 = wp::add(var_last_face, var_13);
    var_15 = wp::tuple(var_14);
    var_16 = wp::array_t<wp::float64>(var_cumulative, var_14);
    // unit = wp.array(ptr=normals, shape=(last_face + 1,), dtype=wp.vec3)                    <L 110>
    var_18 = wp::add(var_last_face, var_17);
    var_19 = wp::tuple(var_18);
    var_20 = wp::array_t<wp::vec_t<3, wp::float32>>(var_normals, var_18);
    // positions = wp.array(ptr=position, shape=(points,), dtype=wp.vec3d)                    <L 111>
    var_21 = wp::tuple(var_points);
    var_22 = wp::array_t<wp::vec_t<3, wp::float64>>(var_position, var_points);
    // turned = wp.array(ptr=normal, shape=(points,), dtype=wp.vec3)                          <L 112>
    var_23 = wp::tuple(var_points);
    var_24 = wp::array_t<wp::vec_t<3, wp::float32>>(var_normal, var_points);
    // indices = wp.array(ptr=face, shape=(points,), dtype=wp.int32)                          <L 113>
    var_25 = wp::tuple(var_points);
    var_26 = wp::array_t<wp::int32>(var_face, var_points);
    // shares = wp.zeros(shape=(block,), dtype=wp.float64)                                    <L 114>
    var_27 = wp::tuple(var_3);
    var_28 = wp::fixedarray_t<64, wp::float64>(var_29);
    // buckets = wp.zeros(shape=(block,), dtype=wp.uint32)                                    <L 115>
    var_30 = wp::tuple(var_3);
    var_31 = wp::fixedarray_t<64, wp::uint32>(var_32);
    // words = wp.zeros(shape=(words_size,), dtype=wp.uint32)                                 <L 116>
    var_34 = wp::tuple(var_33);
    var_35 = wp::fixedarray_t<128, wp::uint32>(var_36);
    // draw(seed, first_point + wp.uint64(start), length, areas[last_face], guide_bits, shares, buckets, words)       <L 117>
    var_37 = wp::uint64(var_4);
    var_38 = wp::add(var_first_point, var_37);
    var_39 = wp::address(var_16, var_last_face);
    var_40 = wp::load(var_39);
    _drawer__locals__draw_0(var_seed, var_38, var_6, var_40, var_guide_bits, var_28, var_31, var_35);
    // for j in range(length):                                                                <L 118>
    var_41 = wp::range(var_6);
    start_for_0:;
        if (iter_cmp(var_41) == 0) goto end_for_0;
        var_42 = wp::iter_next(var_41);
        // ends = wp.array(ptr=guide + wp.uint64(4) * wp.uint64(buckets[j]), shape=(2,), dtype=wp.int32)       <L 119>
        var_43 = 4ull;
        var_44 = wp::address(var_31, var_42);
        var_46 = wp::load(var_44);
        var_45 = wp::uint64(var_46);
        var_47 = wp::mul(var_43, var_45);
        var_48 = wp::add(var_guide, var_47);
        var_50 = wp::tuple(var_49);
        var_51 = wp::array_t<wp::int32>(var_48, var_52);
        // indices[start + j] = _face_of(shares[j], areas, ends[0], ends[1])                  <L 120>
        var_53 = wp::address(var_28, var_42);
        var_55 = wp::address(var_51, var_54);
        var_57 = wp::address(var_51, var_56);
        var_59 = wp::load(var_53);
        var_60 = wp::load(var_55);
        var_61 = wp::load(var_57);
        var_58 = _face_of_0(var_59, var_16, var_60, var_61);
        var_62 = wp::add(var_4, var_42);
        wp::array_store(var_26, var_62, var_58);
        goto start_for_0;
    end_for_0:;
    // for j in range(length):                                                                <L 121>
    var_63 = wp::range(var_6);
    start_for_2:;
        if (iter_cmp(var_63) == 0) goto end_for_2;
        var_64 = wp::iter_next(var_63);
        // i = start + j                                                                      <L 122>
        var_65 = wp::add(var_4, var_64);
        // weights = _weights_of(words[j], words[block + j])                                  <L 123>
        var_66 = wp::address(var_35, var_64);
        var_67 = wp::add(var_3, var_64);
        var_68 = wp::address(var_35, var_67);
        var_70 = wp::load(var_66);
        var_71 = wp::load(var_68);
        var_69 = _weights_of_0(var_70, var_71);
        // triangle = triangles[indices[i]]                                                   <L 124>
        var_72 = wp::address(var_26, var_65);
        var_73 = wp::load(var_72);
        var_74 = wp::address(var_12, var_73);
        var_76 = wp::load(var_74);
        var_75 = wp::copy(var_76);
        // a = corners[triangle[0]]                                                           <L 126>
        var_78 = wp::extract(var_75, var_77);
        var_79 = wp::address(var_8, var_78);
        var_81 = wp::load(var_79);
        var_80 = wp::copy(var_81);
        // positions[i] = a + weights[1] * (corners[triangle[1]] - a) + weights[2] * (corners[triangle[2]] - a)       <L 127>
        var_83 = wp::extract(var_69, var_82);
        var_85 = wp::extract(var_75, var_84);
        var_86 = wp::address(var_8, var_85);
        var_88 = wp::load(var_86);
        var_87 = wp::sub(var_88, var_80);
        var_89 = wp::mul(var_83, var_87);
        var_90 = wp::add(var_80, var_89);
        var_92 = wp::extract(var_69, var_91);
        var_94 = wp::extract(var_75, var_93);
        var_95 = wp::address(var_8, var_94);
        var_97 = wp::load(var_95);
        var_96 = wp::sub(var_97, var_80);
        var_98 = wp::mul(var_92, var_96);
        var_99 = wp::add(var_90, var_98);
        wp::array_store(var_22, var_65, var_99);
        // turned[i] = unit[indices[i]]                                                       <L 128>
        var_100 = wp::address(var_26, var_65);
        var_101 = wp::load(var_100);
        var_102 = wp::address(var_20, var_101);
        var_104 = wp::load(var_102);
        var_103 = wp::copy(var_104);
        wp::array_store(var_24, var_65, var_103);
        // if barycentric != wp.uint64(0):                                                    <L 129>
        var_105 = 0ull;
        var_106 = (var_barycentric != var_105);
        if (var_106) {
            // wp.array(ptr=barycentric, shape=(points,), dtype=wp.vec3d)[i] = weights        <L 130>
            var_107 = wp::tuple(var_points);
            var_108 = wp::array_t<wp::vec_t<3, wp::float64>>(var_barycentric, var_points);
            wp::array_store(var_108, var_65, var_69);
        }
        goto start_for_2;
    end_for_2:;
}



template <bool wp_linear_contiguous>
static WP_FORCEINLINE void place_points__locals__place_points_8f7d4796_cpu_forward_tasks(
    wp::launch_bounds_t<1> *dim,
    wp_args_place_points__locals__place_points_8f7d4796 *_wp_args)
{
    for (size_t task_index = 0; task_index < dim->size; ++task_index)
    {
        place_points__locals__place_points_8f7d4796_cpu_kernel_forward<wp_linear_contiguous>(*dim, task_index, _wp_args);
    }
}

static WP_FORCEINLINE void place_points__locals__place_points_8f7d4796_cpu_forward_dispatch(
    wp::launch_bounds_t<1> *dim,
    wp_args_place_points__locals__place_points_8f7d4796 *_wp_args)
{
    wp::tile_shared_storage_t tile_mem;
#if defined(WP_ENABLE_TILES_IN_STACK_MEMORY)
    wp::shared_tile_storage = &tile_mem;
#endif

    place_points__locals__place_points_8f7d4796_cpu_forward_tasks<false>(dim, _wp_args);
}

extern "C" {

// Python CPU entry points
WP_API void place_points__locals__place_points_8f7d4796_cpu_forward(
    wp::launch_bounds_t<1> *dim,
    wp_args_place_points__locals__place_points_8f7d4796 *_wp_args)
{
    place_points__locals__place_points_8f7d4796_cpu_forward_dispatch(dim, _wp_args);
}

} // extern C

