// rt_layout.vh - generated from machine.def by gen_layout.awk; do not edit
// SPDX-License-Identifier: Apache-2.0
`ifndef RT_LAYOUT_VH
`define RT_LAYOUT_VH
`define RT_PROFILE_DRAFT_W 12
`define RT_PROFILE_DRAFT_WD 13
`define RT_PROFILE_DRAFT_PQ 13
`define RT_PROFILE_DRAFT_NG 2
`define RT_PROFILE_DRAFT_FW 12
`define RT_PROFILE_DRAFT_PR 0
`define RT_PROFILE_STANDARD_W 16
`define RT_PROFILE_STANDARD_WD 17
`define RT_PROFILE_STANDARD_PQ 17
`define RT_PROFILE_STANDARD_NG 2
`define RT_PROFILE_STANDARD_FW 14
`define RT_PROFILE_STANDARD_PR 0
`define RT_PROFILE_FINE_W 20
`define RT_PROFILE_FINE_WD 22
`define RT_PROFILE_FINE_PQ 24
`define RT_PROFILE_FINE_NG 2
`define RT_PROFILE_FINE_FW 14
`define RT_PROFILE_FINE_PR 0
`define RT_PROFILE_REFERENCE_W 24
`define RT_PROFILE_REFERENCE_WD 25
`define RT_PROFILE_REFERENCE_PQ 28
`define RT_PROFILE_REFERENCE_NG 2
`define RT_PROFILE_REFERENCE_FW 14
`define RT_PROFILE_REFERENCE_PR 0
`define RT_WIDTH_W_LSB 0
`define RT_WIDTH_WD_LSB 5
`define RT_WIDTH_PQ_LSB 10
`define RT_WIDTH_NG_LSB 16
`define RT_WIDTH_FW_LSB 19
`define RT_WIDTH_PR_LSB 23
`define RT_FILTER_MARGIN 2
`define RT_FILTER_FRACTION 1
`define RT_LINE_WORDS 8
`define RT_LINE_BITS 26
`define RT_ID_BITS 24
`define RT_RGB_BITS 24
`define RT_VISITS_BITS 24
`define RT_MAX_LIGHTS 8
`define RT_MAX_DEPTH 10
`define RT_REFRACT_DEPTH 5
`define RT_MIN_SCREEN 16
`define RT_STACK_DEPTH 16
`define RT_ID_NONE 16777215
`define RT_COLOUR_ONE 32768
`define RT_RSQRT_ERROR 6
`define RT_ACROSS_SHORT 4
`define RT_MAX_SIDE 16383
`define RT_MAX_CONES 16
`define RT_CONE_LINES 4
`define RT_MAX_SPHERES 16000000
`define RT_MAX_FACETS 1048576
`define RT_MAX_PLANES 6
`define RT_MAX_GROUP 64
`define RT_TEXTURE_SIDE 2048
`define RT_TEXTURE_LEVELS 12
`define RT_INDEX_ONE 1000
`define RT_INDEX_MIN 250
`define RT_SHINE_MIN 1
`define RT_SHINE_MAX 255
`define RT_POWER_ONE 16
`define RT_INDEX_MAX 4000
`define RT_REFRACT_WD 25
`define RT_LOD_BITS 8
`define RT_SPREAD_MOST 12
`define RT_BEND_ONE 3
`define RT_BEND_THROUGH 4
`define RT_LOD_NONE 4095
`define RT_TREE_PAPER 1
`define RT_TREE_BALANCED 2
`define RT_TREE_REINSERTED 5
`define RT_TREE_BIH 3
`define RT_TREE_BRUTE 4
`define RT_TREE_BOX4 6
`define RT_TREE_LAST 6
`define RT_BIH_STACK 64
`define RT_BIH_T 22
`define RT_BIH_V 18
`define RT_BIH_G 18
`define RT_BIH_DIVIDE 20
`define RT_BIH_CHUNK 4
`define RT_BIH_LEAF 3
`define RT_BOX_NEAR 11
`define RT_FRAMES 3
`define RT_SPHERE 0
`define RT_TRIANGLE 1
`define RT_PLANE 2
`define RT_NODE_BASE_LSB 224
`define RT_NODE_BASE_BITS 26
`define RT_NODE_N_INNER_LSB 250
`define RT_NODE_N_INNER_BITS 3
`define RT_NODE_N_LEAF_LSB 253
`define RT_NODE_N_LEAF_BITS 3
`define RT_CHILD_CTR_X_LSB 0
`define RT_CHILD_CTR_X_BITS 14
`define RT_CHILD_CTR_Y_LSB 14
`define RT_CHILD_CTR_Y_BITS 14
`define RT_CHILD_CTR_Z_LSB 28
`define RT_CHILD_CTR_Z_BITS 14
`define RT_CHILD_RAD_LSB 42
`define RT_CHILD_RAD_BITS 14
`define RT_CHILD_STRIDE 56
`define RT_LEAF_CTR_X_LSB 0
`define RT_LEAF_CTR_X_BITS 24
`define RT_LEAF_CTR_Y_LSB 24
`define RT_LEAF_CTR_Y_BITS 24
`define RT_LEAF_CTR_Z_LSB 48
`define RT_LEAF_CTR_Z_BITS 24
`define RT_LEAF_RAD_LSB 72
`define RT_LEAF_RAD_BITS 24
`define RT_LEAF_ID_LSB 96
`define RT_LEAF_ID_BITS 24
`define RT_LEAF_CLEAR_LSB 127
`define RT_LEAF_CLEAR_BITS 1
`define RT_LEAF_STRIDE 128
`define RT_PRIM_RED_LSB 128
`define RT_PRIM_RED_BITS 8
`define RT_PRIM_GREEN_LSB 136
`define RT_PRIM_GREEN_BITS 8
`define RT_PRIM_BLUE_LSB 144
`define RT_PRIM_BLUE_BITS 8
`define RT_PRIM_KR_LSB 152
`define RT_PRIM_KR_BITS 9
`define RT_PRIM_KIND_LSB 120
`define RT_PRIM_KIND_BITS 7
`define RT_PRIM_TEX_LSB 192
`define RT_PRIM_TEX_BITS 26
`define RT_PRIM_KT_LSB 161
`define RT_PRIM_KT_BITS 9
`define RT_PRIM_SUM_LSB 170
`define RT_PRIM_SUM_BITS 1
`define RT_PRIM_KA_LSB 171
`define RT_PRIM_KA_BITS 9
`define RT_PRIM_KD_LSB 180
`define RT_PRIM_KD_BITS 9
`define RT_PRIM_KS_LSB 218
`define RT_PRIM_KS_BITS 8
`define RT_PRIM_POWER_LSB 226
`define RT_PRIM_POWER_BITS 12
`define RT_PRIM_INDEX_LSB 238
`define RT_PRIM_INDEX_BITS 12
`define RT_PRIM_BEND_LSB 250
`define RT_PRIM_BEND_BITS 6
`define RT_PRIM_SMOOTH_LSB 72
`define RT_PRIM_SMOOTH_BITS 24
`define RT_SMOOTH_B_X_LSB 0
`define RT_SMOOTH_B_X_BITS 24
`define RT_SMOOTH_B_Y_LSB 24
`define RT_SMOOTH_B_Y_BITS 24
`define RT_SMOOTH_B_Z_LSB 48
`define RT_SMOOTH_B_Z_BITS 24
`define RT_SMOOTH_M_XX_LSB 72
`define RT_SMOOTH_M_XX_BITS 14
`define RT_SMOOTH_E_LSB 198
`define RT_SMOOTH_E_BITS 6
`define RT_SMOOTH_N_X_LSB 204
`define RT_SMOOTH_N_X_BITS 17
`define RT_SMOOTH_N_Y_LSB 221
`define RT_SMOOTH_N_Y_BITS 17
`define RT_SMOOTH_N_Z_LSB 238
`define RT_SMOOTH_N_Z_BITS 17
`define RT_FACET_ID_LSB 216
`define RT_FACET_ID_BITS 24
`define RT_FACET_BEFORE_LSB 240
`define RT_FACET_BEFORE_BITS 6
`define RT_FACET_CLEAR_LSB 246
`define RT_FACET_CLEAR_BITS 1
`define RT_FACET_AFTER_LSB 247
`define RT_FACET_AFTER_BITS 6
`define RT_FACET_KIND_LSB 254
`define RT_FACET_KIND_BITS 2
`define RT_FACET_MORE_LSB 248
`define RT_FACET_MORE_BITS 6
`define RT_TRIANGLE_V0_X_LSB 0
`define RT_TRIANGLE_V0_X_BITS 24
`define RT_TRIANGLE_V0_Y_LSB 24
`define RT_TRIANGLE_V0_Y_BITS 24
`define RT_TRIANGLE_V0_Z_LSB 48
`define RT_TRIANGLE_V0_Z_BITS 24
`define RT_TRIANGLE_V1_X_LSB 72
`define RT_TRIANGLE_V1_X_BITS 24
`define RT_TRIANGLE_V1_Y_LSB 96
`define RT_TRIANGLE_V1_Y_BITS 24
`define RT_TRIANGLE_V1_Z_LSB 120
`define RT_TRIANGLE_V1_Z_BITS 24
`define RT_TRIANGLE_V2_X_LSB 144
`define RT_TRIANGLE_V2_X_BITS 24
`define RT_TRIANGLE_V2_Y_LSB 168
`define RT_TRIANGLE_V2_Y_BITS 24
`define RT_TRIANGLE_V2_Z_LSB 192
`define RT_TRIANGLE_V2_Z_BITS 24
`define RT_PLANE_P_X_LSB 0
`define RT_PLANE_P_X_BITS 24
`define RT_PLANE_P_Y_LSB 24
`define RT_PLANE_P_Y_BITS 24
`define RT_PLANE_P_Z_LSB 48
`define RT_PLANE_P_Z_BITS 24
`define RT_PLANE_N_X_LSB 72
`define RT_PLANE_N_X_BITS 24
`define RT_PLANE_N_Y_LSB 96
`define RT_PLANE_N_Y_BITS 24
`define RT_PLANE_N_Z_LSB 120
`define RT_PLANE_N_Z_BITS 24
`define RT_MAP_KIND_LSB 0
`define RT_MAP_KIND_BITS 2
`define RT_MAP_CLAMP_S_LSB 2
`define RT_MAP_CLAMP_S_BITS 1
`define RT_MAP_CLAMP_T_LSB 3
`define RT_MAP_CLAMP_T_BITS 1
`define RT_MAP_BASE_LSB 4
`define RT_MAP_BASE_BITS 16
`define RT_MAP_IMAGE_LSB 20
`define RT_MAP_IMAGE_BITS 26
`define RT_MAP_S_X_LSB 48
`define RT_MAP_S_X_BITS 18
`define RT_MAP_S_Y_LSB 66
`define RT_MAP_S_Y_BITS 18
`define RT_MAP_S_Z_LSB 84
`define RT_MAP_S_Z_BITS 18
`define RT_MAP_S_E_LSB 102
`define RT_MAP_S_E_BITS 6
`define RT_MAP_S_0_LSB 108
`define RT_MAP_S_0_BITS 40
`define RT_MAP_T_X_LSB 148
`define RT_MAP_T_X_BITS 18
`define RT_MAP_T_Y_LSB 166
`define RT_MAP_T_Y_BITS 18
`define RT_MAP_T_Z_LSB 184
`define RT_MAP_T_Z_BITS 18
`define RT_MAP_T_E_LSB 202
`define RT_MAP_T_E_BITS 6
`define RT_MAP_T_0_LSB 208
`define RT_MAP_T_0_BITS 40
`define RT_MAP_TURN_LSB 48
`define RT_MAP_TURN_BITS 16
`define RT_MAP_SCALE_S_LSB 192
`define RT_MAP_SCALE_S_BITS 16
`define RT_MAP_SCALE_T_LSB 208
`define RT_MAP_SCALE_T_BITS 16
`define RT_MAP_PLUS_S_LSB 224
`define RT_MAP_PLUS_S_BITS 16
`define RT_MAP_PLUS_T_LSB 240
`define RT_MAP_PLUS_T_BITS 16
`define RT_IMAGE_W_LSB 0
`define RT_IMAGE_W_BITS 12
`define RT_IMAGE_H_LSB 12
`define RT_IMAGE_H_BITS 12
`define RT_IMAGE_LEVELS_LSB 24
`define RT_IMAGE_LEVELS_BITS 4
`define RT_IMAGE_FIRST_LSB 28
`define RT_IMAGE_FIRST_BITS 20
`define RT_BOX_LO_X_LSB 0
`define RT_BOX_LO_X_BITS 7
`define RT_BOX_LO_Y_LSB 7
`define RT_BOX_LO_Y_BITS 7
`define RT_BOX_LO_Z_LSB 14
`define RT_BOX_LO_Z_BITS 7
`define RT_BOX_HI_X_LSB 21
`define RT_BOX_HI_X_BITS 7
`define RT_BOX_HI_Y_LSB 28
`define RT_BOX_HI_Y_BITS 7
`define RT_BOX_HI_Z_LSB 35
`define RT_BOX_HI_Z_BITS 7
`define RT_BOX_STRIDE 42
`define RT_FRAME_ORG_X_LSB 168
`define RT_FRAME_ORG_X_BITS 14
`define RT_FRAME_ORG_Y_LSB 182
`define RT_FRAME_ORG_Y_BITS 14
`define RT_FRAME_ORG_Z_LSB 196
`define RT_FRAME_ORG_Z_BITS 14
`define RT_FRAME_STEP_X_LSB 210
`define RT_FRAME_STEP_X_BITS 4
`define RT_FRAME_STEP_Y_LSB 214
`define RT_FRAME_STEP_Y_BITS 4
`define RT_FRAME_STEP_Z_LSB 218
`define RT_FRAME_STEP_Z_BITS 4
`define RT_BIH_CHILD_LSB 0
`define RT_BIH_CHILD_BITS 29
`define RT_BIH_FIT_LSB 29
`define RT_BIH_FIT_BITS 1
`define RT_BIH_AXIS_LSB 30
`define RT_BIH_AXIS_BITS 2
`define RT_BIH_CLIP_L_LSB 32
`define RT_BIH_CLIP_L_BITS 32
`define RT_BIH_CLIP_R_LSB 64
`define RT_BIH_CLIP_R_BITS 32
`define RT_BIH_FIRST_LSB 32
`define RT_BIH_FIRST_BITS 32
`define RT_BIH_COUNT_LSB 64
`define RT_BIH_COUNT_BITS 32
`define RT_BIH_STRIDE 128
`define RT_SPAN_X0_LSB 0
`define RT_SPAN_X0_BITS 16
`define RT_SPAN_X1_LSB 16
`define RT_SPAN_X1_BITS 16
`define RT_SPAN_STRIDE 32
`define RT_CONE_F_LSB 0
`define RT_CONE_F_BITS 128
`define RT_CONE_FX_LSB 128
`define RT_CONE_FX_BITS 128
`define RT_CONE_FY_LSB 256
`define RT_CONE_FY_BITS 128
`define RT_CONE_FXX_LSB 384
`define RT_CONE_FXX_BITS 128
`define RT_CONE_FXY_LSB 512
`define RT_CONE_FXY_BITS 128
`define RT_CONE_FYY_LSB 640
`define RT_CONE_FYY_BITS 128
`define RT_CONE_B_LSB 768
`define RT_CONE_B_BITS 64
`define RT_CONE_BX_LSB 832
`define RT_CONE_BX_BITS 64
`define RT_CONE_BY_LSB 896
`define RT_CONE_BY_BITS 64
`define RT_CONE_INSIDE_LSB 960
`define RT_CONE_INSIDE_BITS 1
`define RT_REG_EFFECTS 0
`define RT_REG_MAX_DEPTH 1
`define RT_REG_N_LIGHTS 2
`define RT_REG_FRAME_W 3
`define RT_REG_FRAME_H 4
`define RT_REG_WIN_X0 5
`define RT_REG_WIN_Y0 6
`define RT_REG_WIN_X1 7
`define RT_REG_WIN_Y1 8
`define RT_REG_BG_MODE 9
`define RT_REG_RECT_X0 10
`define RT_REG_RECT_Y0 11
`define RT_REG_RECT_X1 12
`define RT_REG_RECT_Y1 13
`define RT_REG_BG_COLOUR 14
`define RT_REG_AMBIENT_R 15
`define RT_REG_AMBIENT_G 16
`define RT_REG_AMBIENT_B 17
`define RT_REG_EYE_X 18
`define RT_REG_EYE_Y 19
`define RT_REG_EYE_Z 20
`define RT_REG_DIR_X0 21
`define RT_REG_DIR_Y0 22
`define RT_REG_DIR_Z 23
`define RT_REG_PITCH 24
`define RT_REG_ROOT 25
`define RT_REG_PRIM_BASE 26
`define RT_REG_MEM_LINES 27
`define RT_REG_N_PRIMS 28
`define RT_REG_VISIT_LIMIT 29
`define RT_REG_PROFILE 30
`define RT_REG_TREE 31
`define RT_REG_LIGHT0_X 32
`define RT_REG_LIGHT0_Y 33
`define RT_REG_LIGHT0_Z 34
`define RT_REG_LIGHT0_R 35
`define RT_REG_LIGHT0_G 36
`define RT_REG_LIGHT0_B 37
`define RT_REG_FRAME 96
`define RT_REG_BG_BASE 97
`define RT_REG_BG_COUNT 98
`define RT_REG_FACET_BASE 99
`define RT_REG_N_SPHERES 100
`define RT_REG_TEX_FILTER 101
`define RT_REG_COARSE 102
`define RT_REG_SMOOTH_BASE 103
`define RT_REG_LEAF_BASE 104
`define RT_REG_N_LOOSE 105
`define RT_REG_BOX_X0 106
`define RT_REG_BOX_Y0 107
`define RT_REG_BOX_Z0 108
`define RT_REG_BOX_X1 109
`define RT_REG_BOX_Y1 110
`define RT_REG_BOX_Z1 111
`define RT_REG_ACROSS_X 112
`define RT_REG_ACROSS_Y 113
`define RT_REG_ACROSS_Z 114
`define RT_REG_DOWN_X 115
`define RT_REG_DOWN_Y 116
`define RT_REG_DOWN_Z 117
`define RT_REG_LEAST_WEIGHT 118
`define RT_LEAST_WEIGHT_MAX 256
`define RT_LIGHT_STRIDE 8
`define RT_LIGHT_SHIFT_LSB 16
`define RT_LIGHT_SHIFT_BITS 5
`define RT_N_REGS 119
`define RT_COUNT_RAYS_PRIMARY 0
`define RT_COUNT_RAYS_SHADOW 1
`define RT_COUNT_RAYS_REFLECTED 2
`define RT_COUNT_NODE_VISITS 3
`define RT_COUNT_CHILD_TESTS 4
`define RT_COUNT_LEAF_TESTS 5
`define RT_COUNT_ROOTS 6
`define RT_COUNT_QUOTIENTS 7
`define RT_COUNT_BACKGROUND 8
`define RT_COUNT_SATURATIONS 9
`define RT_COUNT_CYCLES 10
`define RT_COUNT_ISSUE_WAIT 11
`define RT_COUNT_NODE_MISSES 12
`define RT_COUNT_LEAF_MISSES 13
`define RT_COUNT_RAYS_WAITING 14
`define RT_COUNT_POP_BUBBLES 15
`define RT_COUNT_FACET_TESTS 16
`define RT_COUNT_DIVISIONS 17
`define RT_COUNT_TEXELS 18
`define RT_COUNT_TEXEL_MISSES 19
`define RT_COUNT_RAYS_REFRACTED 20
`define RT_COUNT_POWERS 21
`define RT_ERROR_BAD_NODE 0
`define RT_ERROR_STACK_OVERFLOW 1
`define RT_ERROR_VISIT_LIMIT 2
`define RT_ERROR_BUS_ERROR 3
`define RT_ERROR_MISSING_EFFECT 4
`define RT_ERROR_WRONG_PROFILE 5
`define RT_EFFECT_SHADOW 0
`define RT_EFFECT_REFLECT 1
`define RT_EFFECT_INSIDE 2
`define RT_EFFECT_FIRST 3
`define RT_EFFECT_INTERPENETRATE 4
`define RT_EFFECT_FACETS 5
`define RT_EFFECT_TEXTURE 6
`define RT_EFFECT_REFRACT 7
`define RT_EFFECT_SPECULAR 8
`define RT_EFFECT_SUM 9
`define RT_EFFECT_SMOOTH 10
`define RT_EFFECT_CLEAR 11
`define RT_EFFECT_TURNED 12
`define RT_EFFECT_SPREAD 13
`define RT_EFFECT_BITS 14
`define RT_KINDS 3
`define RT_KINDS_UNBOUNDED 4
`define RT_COUNTERS 22
`define RT_COUNTERS_BOTH 3605503
`define RT_ERRORS 6
`define RT_EFFECTS_BUILT (32'd0 | (SHADOW != 0 ? 32'd1 << 0 : 32'd0) | (REFLECT != 0 ? 32'd1 << 1 : 32'd0) | (INSIDE != 0 ? 32'd1 << 2 : 32'd0) | (FIRST != 0 ? 32'd1 << 3 : 32'd0) | (INTERPENETRATE != 0 ? 32'd1 << 4 : 32'd0) | (FACETS != 0 ? 32'd1 << 5 : 32'd0) | (TEXTURE != 0 ? 32'd1 << 6 : 32'd0) | (REFRACT != 0 ? 32'd1 << 7 : 32'd0) | (SPECULAR != 0 ? 32'd1 << 8 : 32'd0) | (SUM != 0 ? 32'd1 << 9 : 32'd0) | (SMOOTH != 0 ? 32'd1 << 10 : 32'd0) | (CLEAR != 0 ? 32'd1 << 11 : 32'd0) | (TURNED != 0 ? 32'd1 << 12 : 32'd0) | (SPREAD != 0 ? 32'd1 << 13 : 32'd0))
`define RT_DEEPEST (REFRACT != 0 && REFLECT < `RT_REFRACT_DEPTH ? `RT_REFRACT_DEPTH : REFLECT)
`define RT_CHECK_CORE  \
    `RT_CHECK(W >= 8 && W <= 24, rt_core_W_must_be_8_to_24) \
    `RT_CHECK(WD >= 9 && WD <= 31, rt_core_WD_must_be_9_to_31) \
    `RT_CHECK(PQ >= 4 && PQ <= 32, rt_core_PQ_must_be_4_to_32) \
    `RT_CHECK(NG >= 0 && NG <= 4, rt_core_NG_must_be_0_to_4) \
    `RT_CHECK(FW >= 6 && FW <= 14, rt_core_FW_must_be_6_to_14) \
    `RT_CHECK(PR >= 0 && PR <= 51, rt_core_PR_must_be_0_to_51) \
    `RT_CHECK(SHADOW >= 0 && SHADOW <= 1, rt_core_SHADOW_must_be_0_to_1) \
    `RT_CHECK(REFLECT >= 0 && REFLECT <= 10, rt_core_REFLECT_must_be_0_to_10) \
    `RT_CHECK(LIGHTS >= 0 && LIGHTS <= 8, rt_core_LIGHTS_must_be_0_to_8) \
    `RT_CHECK(INSIDE >= 0 && INSIDE <= 1, rt_core_INSIDE_must_be_0_to_1) \
    `RT_CHECK(FIRST >= 0 && FIRST <= 1, rt_core_FIRST_must_be_0_to_1) \
    `RT_CHECK(INTERPENETRATE >= 0 && INTERPENETRATE <= 1, rt_core_INTERPENETRATE_must_be_0_to_1) \
    `RT_CHECK(INTERPENETRATE == 0 || INSIDE != 0, rt_core_INTERPENETRATE_needs_INSIDE) \
    `RT_CHECK(INTERPENETRATE == 0 || FIRST != 0, rt_core_INTERPENETRATE_needs_FIRST) \
    `RT_CHECK(FACETS >= 0 && FACETS <= 1, rt_core_FACETS_must_be_0_to_1) \
    `RT_CHECK(TEXTURE >= 0 && TEXTURE <= 1, rt_core_TEXTURE_must_be_0_to_1) \
    `RT_CHECK(REFRACT >= 0 && REFRACT <= 1, rt_core_REFRACT_must_be_0_to_1) \
    `RT_CHECK(REFRACT == 0 || INSIDE != 0, rt_core_REFRACT_needs_INSIDE) \
    `RT_CHECK(SPECULAR >= 0 && SPECULAR <= 1, rt_core_SPECULAR_must_be_0_to_1) \
    `RT_CHECK(SPECULAR == 0 || SUM != 0, rt_core_SPECULAR_needs_SUM) \
    `RT_CHECK(SUM >= 0 && SUM <= 1, rt_core_SUM_must_be_0_to_1) \
    `RT_CHECK(SMOOTH >= 0 && SMOOTH <= 1, rt_core_SMOOTH_must_be_0_to_1) \
    `RT_CHECK(SMOOTH == 0 || FACETS != 0, rt_core_SMOOTH_needs_FACETS) \
    `RT_CHECK(CLEAR >= 0 && CLEAR <= 1, rt_core_CLEAR_must_be_0_to_1) \
    `RT_CHECK(CLEAR == 0 || SHADOW != 0, rt_core_CLEAR_needs_SHADOW) \
    `RT_CHECK(TURNED >= 0 && TURNED <= 1, rt_core_TURNED_must_be_0_to_1) \
    `RT_CHECK(SPREAD >= 0 && SPREAD <= 1, rt_core_SPREAD_must_be_0_to_1) \
    `RT_CHECK(SPREAD == 0 || TEXTURE != 0, rt_core_SPREAD_needs_TEXTURE) \
    `RT_CHECK(COARSE >= 0 && COARSE <= 8, rt_core_COARSE_must_be_0_to_8) \
    `RT_CHECK(COARSE == 0 || TEXTURE != 0, rt_core_COARSE_needs_TEXTURE) \
    `RT_CHECK(RECT >= 0 && RECT <= 1, rt_core_RECT_must_be_0_to_1) \
    `RT_CHECK(SPANS >= 0 && SPANS <= 1, rt_core_SPANS_must_be_0_to_1) \
    `RT_CHECK(CONES >= 0 && CONES <= 16, rt_core_CONES_must_be_0_to_16) \
    `RT_CHECK(ACCEL >= 0 && ACCEL <= 1, rt_core_ACCEL_must_be_0_to_1) \
    `RT_CHECK(ACCEL == 0 || FIRST == 0, rt_core_ACCEL_excludes_FIRST) \
    `RT_CHECK(BOXES >= 0 && BOXES <= 1, rt_core_BOXES_must_be_0_to_1) \
    `RT_CHECK(BOXES == 0 || FIRST == 0, rt_core_BOXES_excludes_FIRST) \
    `RT_CHECK(BOXES == 0 || ACCEL == 0, rt_core_BOXES_excludes_ACCEL) \
    `RT_CHECK(ENGINES >= 1 && ENGINES <= 8, rt_core_ENGINES_must_be_1_to_8) \
    `RT_CHECK(PIPES >= 1 && PIPES <= 4, rt_core_PIPES_must_be_1_to_4) \
    `RT_CHECK(EXACTS >= 0 && EXACTS <= 4, rt_core_EXACTS_must_be_0_to_4) \
    `RT_CHECK(SHADES >= 0 && SHADES <= 4, rt_core_SHADES_must_be_0_to_4) \
    `RT_CHECK(SETUPS >= 0 && SETUPS <= 2, rt_core_SETUPS_must_be_0_to_2) \
    `RT_CHECK(WALKS >= 0 && WALKS <= 2, rt_core_WALKS_must_be_0_to_2) \
    `RT_CHECK(SLOTS >= 4 && SLOTS <= 1024 && (SLOTS & (SLOTS - 1)) == 0, rt_core_SLOTS_must_be_a_power_of_two_from_4_to_1024) \
    `RT_CHECK(NODE_LINES >= 8 && NODE_LINES <= 4096 && (NODE_LINES & (NODE_LINES - 1)) == 0, rt_core_NODE_LINES_must_be_a_power_of_two_from_8_to_4096) \
    `RT_CHECK(LEAF_LINES >= 8 && LEAF_LINES <= 4096 && (LEAF_LINES & (LEAF_LINES - 1)) == 0, rt_core_LEAF_LINES_must_be_a_power_of_two_from_8_to_4096) \
    `RT_CHECK(TEXTURE_LINES >= 8 && TEXTURE_LINES <= 4096 && (TEXTURE_LINES & (TEXTURE_LINES - 1)) == 0, rt_core_TEXTURE_LINES_must_be_a_power_of_two_from_8_to_4096) \
    `RT_CHECK(TEXTURE_WAYS >= 1 && TEXTURE_WAYS <= 32 && (TEXTURE_WAYS & (TEXTURE_WAYS - 1)) == 0, rt_core_TEXTURE_WAYS_must_be_a_power_of_two_from_1_to_32) \
    `RT_CHECK(TEXTURE_GROUP >= 1 && TEXTURE_GROUP <= 4 && (TEXTURE_GROUP & (TEXTURE_GROUP - 1)) == 0, rt_core_TEXTURE_GROUP_must_be_a_power_of_two_from_1_to_4) \
    `RT_CHECK(TEXTURE_COORDS >= 1 && TEXTURE_COORDS <= 8, rt_core_TEXTURE_COORDS_must_be_1_to_8) \
    `RT_CHECK(ROOTS >= 0 && ROOTS <= 8, rt_core_ROOTS_must_be_0_to_8) \
    `RT_CHECK(QUOTIENTS >= 1 && QUOTIENTS <= 8, rt_core_QUOTIENTS_must_be_1_to_8) \
    `RT_CHECK(DIVISIONS >= 0 && DIVISIONS <= 8, rt_core_DIVISIONS_must_be_0_to_8) \
    `RT_CHECK(ROOT_STEP >= 1 && ROOT_STEP <= W+WD, rt_core_ROOT_STEP_must_be_1_to_W_plus_WD) \
    `RT_CHECK(QUOTIENT_STEP >= 1 && QUOTIENT_STEP <= PQ, rt_core_QUOTIENT_STEP_must_be_1_to_PQ) \
    `RT_CHECK(DIVISION_STEP >= 1 && DIVISION_STEP <= W+WD, rt_core_DIVISION_STEP_must_be_1_to_W_plus_WD) \
    `RT_CHECK(LEAF_INTERVAL >= 2 && LEAF_INTERVAL <= 4 && (LEAF_INTERVAL & (LEAF_INTERVAL - 1)) == 0, rt_core_LEAF_INTERVAL_must_be_a_power_of_two_from_2_to_4) \
    `RT_CHECK(FACET_INTERVAL >= 0 && FACET_INTERVAL <= 4 && (FACET_INTERVAL & (FACET_INTERVAL - 1)) == 0, rt_core_FACET_INTERVAL_must_be_a_power_of_two_from_0_to_4) \
    `RT_CHECK(UNITS >= 1 && UNITS <= 2, rt_core_UNITS_must_be_1_to_2) \
    `RT_CHECK(UNIT_INTERVAL >= 2 && UNIT_INTERVAL <= 4 && (UNIT_INTERVAL & (UNIT_INTERVAL - 1)) == 0, rt_core_UNIT_INTERVAL_must_be_a_power_of_two_from_2_to_4) \
    `RT_CHECK(SQUARES >= 0 && SQUARES <= 2, rt_core_SQUARES_must_be_0_to_2) \
    `RT_CHECK(SPILLS >= 0 && SPILLS <= 2, rt_core_SPILLS_must_be_0_to_2) \
    `RT_CHECK(HIT_INTERVAL >= 8 && HIT_INTERVAL <= 12, rt_core_HIT_INTERVAL_must_be_8_to_12) \
    `RT_CHECK(BOUNCE_INTERVAL >= 10 && BOUNCE_INTERVAL <= 12, rt_core_BOUNCE_INTERVAL_must_be_10_to_12) \
    `RT_CHECK(WD > W, rt_core_WD_must_be_above_W) \
    `RT_CHECK(FW <= W, rt_core_FW_must_be_at_most_W) \
    `RT_CHECK(3*W + 2*WD <= 126, rt_core_3W_plus_2WD_must_be_at_most_126) \
    `RT_CHECK(PQ + WD <= 62, rt_core_PQ_plus_WD_must_be_at_most_62) \
    `RT_CHECK(PQ + WD >= W + NG + 5, rt_core_PQ_plus_WD_must_be_at_least_W_plus_NG_plus_5) \
    `RT_CHECK(PR == 0 || (PR >= 4 && PR < W + WD), rt_core_PR_must_be_0_or_4_to_W_plus_WD_minus_1) \
    `RT_CHECK(ENGINES*PIPES <= 8, rt_core_ENGINES_times_PIPES_must_be_at_most_8) \
    `RT_CHECK(LEAF_UNITS != 3 && SHADE_UNITS != 3, rt_core_EXACTS_and_SHADES_must_be_powers_of_two) \
    `RT_CHECK(LEAF_UNITS <= SHADE_UNITS, rt_core_EXACTS_must_be_at_most_SHADES) \
    `RT_CHECK(SETUP_UNITS <= LEAF_UNITS, rt_core_SETUPS_must_be_at_most_EXACTS) \
    `RT_CHECK(SHADE_UNITS <= PIPES || (SHADE_UNITS == 4 && PIPES == 3), rt_core_SHADES_must_be_at_most_PIPES) \
    `RT_CHECK(SHADE_UNITS == 1 || INTERPENETRATE == 0, rt_core_INTERPENETRATE_needs_SHADES_to_be_1) \
    `RT_CHECK(TEXTURE == 0 || TEXTURE_LINES >= 2*TEXTURE_WAYS*TEXTURE_GROUP, rt_core_TEXTURE_LINES_must_be_2_sets) \
    `RT_CHECK(HIT_INTERVAL == 8 || HIT_INTERVAL == 12, rt_core_HIT_INTERVAL_must_be_8_or_12) \
    `RT_CHECK(BOUNCE_INTERVAL == 10 || BOUNCE_INTERVAL == 12, rt_core_BOUNCE_INTERVAL_must_be_10_or_12)
`endif
