/* layout.h - generated from machine.def by make layout; do not edit
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_LAYOUT_H
#define SPH_LAYOUT_H

#define SPH_FILTER_MARGIN 2
#define SPH_FILTER_FRACTION 1
#define SPH_LINE_WORDS 8
#define SPH_LINE_BITS 26
#define SPH_TAG_BITS 5
#define SPH_ID_BITS 24
#define SPH_RGB_BITS 24
#define SPH_VISITS_BITS 24
#define SPH_MAX_LIGHTS 8
#define SPH_MAX_DEPTH 10
#define SPH_REFRACT_DEPTH 5
#define SPH_MIN_SCREEN 16
#define SPH_STACK_DEPTH 16
#define SPH_ID_NONE 16777215
#define SPH_COLOUR_ONE 32768
#define SPH_RSQRT_ERROR 6
#define SPH_RECIPROCAL_ERROR 7
#define SPH_ACROSS_SHORT 4
#define SPH_MAX_SIDE 16383
#define SPH_MAX_CONES 16
#define SPH_CONE_LINES 4
#define SPH_MAX_SPHERES 16000000
#define SPH_MAX_FACETS 1048576
#define SPH_MAX_PLANES 6
#define SPH_MAX_GROUP 64
#define SPH_TEXTURE_SIDE 2048
#define SPH_TEXTURE_LEVELS 12
#define SPH_INDEX_ONE 1000
#define SPH_INDEX_MIN 250
#define SPH_SHINE_MIN 1
#define SPH_SHINE_MAX 255
#define SPH_POWER_ONE 16
#define SPH_INDEX_MAX 4000
#define SPH_REFRACT_WD 25
#define SPH_LOD_BITS 8
#define SPH_SPREAD_MOST 12
#define SPH_BEND_ONE 3
#define SPH_BEND_THROUGH 4
#define SPH_LOD_NONE 4095
#define SPH_TREE_PAPER 1
#define SPH_TREE_BALANCED 2
#define SPH_TREE_REINSERTED 5
#define SPH_TREE_BIH 3
#define SPH_TREE_BRUTE 4
#define SPH_TREE_BOX4 6
#define SPH_TREE_HW 7
#define SPH_TREE_LAST 7
#define SPH_BIH_STACK 64
#define SPH_BIH_T 22
#define SPH_BIH_V 18
#define SPH_BIH_G 18
#define SPH_BIH_CHUNK 4
#define SPH_BIH_LEAF 3
#define SPH_BOX_CROSS 17
#define SPH_BOX_FINE 4
#define SPH_BOX_NEAR 11
#define SPH_BUILD_CURVE 0
#define SPH_BUILD_PAPER 1
#define SPH_BUILD_REFIT 2
#define SPH_BUILD_AXIS 8
#define SPH_BUILD_DIGIT 6
#define SPH_BUILD_SIDE 12
#define SPH_BUILD_WINDOW 8
#define SPH_FRAMES 3
#define SPH_SPHERE 0
#define SPH_TRIANGLE 1
#define SPH_PLANE 2
#define SPH_NODE_BASE_LSB 224
#define SPH_NODE_BASE_BITS 26
#define SPH_NODE_N_INNER_LSB 250
#define SPH_NODE_N_INNER_BITS 3
#define SPH_NODE_N_LEAF_LSB 253
#define SPH_NODE_N_LEAF_BITS 3
#define SPH_CHILD_CTR_X_LSB 0
#define SPH_CHILD_CTR_X_BITS 14
#define SPH_CHILD_CTR_Y_LSB 14
#define SPH_CHILD_CTR_Y_BITS 14
#define SPH_CHILD_CTR_Z_LSB 28
#define SPH_CHILD_CTR_Z_BITS 14
#define SPH_CHILD_RAD_LSB 42
#define SPH_CHILD_RAD_BITS 14
#define SPH_CHILD_STRIDE 56
#define SPH_LEAF_CTR_X_LSB 0
#define SPH_LEAF_CTR_X_BITS 24
#define SPH_LEAF_CTR_Y_LSB 24
#define SPH_LEAF_CTR_Y_BITS 24
#define SPH_LEAF_CTR_Z_LSB 48
#define SPH_LEAF_CTR_Z_BITS 24
#define SPH_LEAF_RAD_LSB 72
#define SPH_LEAF_RAD_BITS 24
#define SPH_LEAF_ID_LSB 96
#define SPH_LEAF_ID_BITS 24
#define SPH_LEAF_CLEAR_LSB 127
#define SPH_LEAF_CLEAR_BITS 1
#define SPH_LEAF_STRIDE 128
#define SPH_PRIM_RED_LSB 128
#define SPH_PRIM_RED_BITS 8
#define SPH_PRIM_GREEN_LSB 136
#define SPH_PRIM_GREEN_BITS 8
#define SPH_PRIM_BLUE_LSB 144
#define SPH_PRIM_BLUE_BITS 8
#define SPH_PRIM_KR_LSB 152
#define SPH_PRIM_KR_BITS 9
#define SPH_PRIM_KIND_LSB 120
#define SPH_PRIM_KIND_BITS 7
#define SPH_PRIM_TEX_LSB 192
#define SPH_PRIM_TEX_BITS 26
#define SPH_PRIM_KT_LSB 161
#define SPH_PRIM_KT_BITS 9
#define SPH_PRIM_SUM_LSB 170
#define SPH_PRIM_SUM_BITS 1
#define SPH_PRIM_KA_LSB 171
#define SPH_PRIM_KA_BITS 9
#define SPH_PRIM_KD_LSB 180
#define SPH_PRIM_KD_BITS 9
#define SPH_PRIM_KS_LSB 218
#define SPH_PRIM_KS_BITS 8
#define SPH_PRIM_POWER_LSB 226
#define SPH_PRIM_POWER_BITS 12
#define SPH_PRIM_INDEX_LSB 238
#define SPH_PRIM_INDEX_BITS 12
#define SPH_PRIM_BEND_LSB 250
#define SPH_PRIM_BEND_BITS 6
#define SPH_PRIM_SMOOTH_LSB 72
#define SPH_PRIM_SMOOTH_BITS 24
#define SPH_SMOOTH_B_X_LSB 0
#define SPH_SMOOTH_B_X_BITS 24
#define SPH_SMOOTH_B_Y_LSB 24
#define SPH_SMOOTH_B_Y_BITS 24
#define SPH_SMOOTH_B_Z_LSB 48
#define SPH_SMOOTH_B_Z_BITS 24
#define SPH_SMOOTH_M_XX_LSB 72
#define SPH_SMOOTH_M_XX_BITS 14
#define SPH_SMOOTH_E_LSB 198
#define SPH_SMOOTH_E_BITS 6
#define SPH_SMOOTH_N_X_LSB 204
#define SPH_SMOOTH_N_X_BITS 17
#define SPH_SMOOTH_N_Y_LSB 221
#define SPH_SMOOTH_N_Y_BITS 17
#define SPH_SMOOTH_N_Z_LSB 238
#define SPH_SMOOTH_N_Z_BITS 17
#define SPH_FACET_ID_LSB 216
#define SPH_FACET_ID_BITS 24
#define SPH_FACET_BEFORE_LSB 240
#define SPH_FACET_BEFORE_BITS 6
#define SPH_FACET_CLEAR_LSB 246
#define SPH_FACET_CLEAR_BITS 1
#define SPH_FACET_AFTER_LSB 247
#define SPH_FACET_AFTER_BITS 6
#define SPH_FACET_KIND_LSB 254
#define SPH_FACET_KIND_BITS 2
#define SPH_FACET_MORE_LSB 248
#define SPH_FACET_MORE_BITS 6
#define SPH_TRIANGLE_V0_X_LSB 0
#define SPH_TRIANGLE_V0_X_BITS 24
#define SPH_TRIANGLE_V0_Y_LSB 24
#define SPH_TRIANGLE_V0_Y_BITS 24
#define SPH_TRIANGLE_V0_Z_LSB 48
#define SPH_TRIANGLE_V0_Z_BITS 24
#define SPH_TRIANGLE_V1_X_LSB 72
#define SPH_TRIANGLE_V1_X_BITS 24
#define SPH_TRIANGLE_V1_Y_LSB 96
#define SPH_TRIANGLE_V1_Y_BITS 24
#define SPH_TRIANGLE_V1_Z_LSB 120
#define SPH_TRIANGLE_V1_Z_BITS 24
#define SPH_TRIANGLE_V2_X_LSB 144
#define SPH_TRIANGLE_V2_X_BITS 24
#define SPH_TRIANGLE_V2_Y_LSB 168
#define SPH_TRIANGLE_V2_Y_BITS 24
#define SPH_TRIANGLE_V2_Z_LSB 192
#define SPH_TRIANGLE_V2_Z_BITS 24
#define SPH_PLANE_P_X_LSB 0
#define SPH_PLANE_P_X_BITS 24
#define SPH_PLANE_P_Y_LSB 24
#define SPH_PLANE_P_Y_BITS 24
#define SPH_PLANE_P_Z_LSB 48
#define SPH_PLANE_P_Z_BITS 24
#define SPH_PLANE_N_X_LSB 72
#define SPH_PLANE_N_X_BITS 24
#define SPH_PLANE_N_Y_LSB 96
#define SPH_PLANE_N_Y_BITS 24
#define SPH_PLANE_N_Z_LSB 120
#define SPH_PLANE_N_Z_BITS 24
#define SPH_MAP_KIND_LSB 0
#define SPH_MAP_KIND_BITS 2
#define SPH_MAP_CLAMP_S_LSB 2
#define SPH_MAP_CLAMP_S_BITS 1
#define SPH_MAP_CLAMP_T_LSB 3
#define SPH_MAP_CLAMP_T_BITS 1
#define SPH_MAP_BASE_LSB 4
#define SPH_MAP_BASE_BITS 16
#define SPH_MAP_IMAGE_LSB 20
#define SPH_MAP_IMAGE_BITS 26
#define SPH_MAP_S_X_LSB 48
#define SPH_MAP_S_X_BITS 18
#define SPH_MAP_S_Y_LSB 66
#define SPH_MAP_S_Y_BITS 18
#define SPH_MAP_S_Z_LSB 84
#define SPH_MAP_S_Z_BITS 18
#define SPH_MAP_S_E_LSB 102
#define SPH_MAP_S_E_BITS 6
#define SPH_MAP_S_0_LSB 108
#define SPH_MAP_S_0_BITS 40
#define SPH_MAP_T_X_LSB 148
#define SPH_MAP_T_X_BITS 18
#define SPH_MAP_T_Y_LSB 166
#define SPH_MAP_T_Y_BITS 18
#define SPH_MAP_T_Z_LSB 184
#define SPH_MAP_T_Z_BITS 18
#define SPH_MAP_T_E_LSB 202
#define SPH_MAP_T_E_BITS 6
#define SPH_MAP_T_0_LSB 208
#define SPH_MAP_T_0_BITS 40
#define SPH_MAP_TURN_LSB 48
#define SPH_MAP_TURN_BITS 16
#define SPH_MAP_SCALE_S_LSB 192
#define SPH_MAP_SCALE_S_BITS 16
#define SPH_MAP_SCALE_T_LSB 208
#define SPH_MAP_SCALE_T_BITS 16
#define SPH_MAP_PLUS_S_LSB 224
#define SPH_MAP_PLUS_S_BITS 16
#define SPH_MAP_PLUS_T_LSB 240
#define SPH_MAP_PLUS_T_BITS 16
#define SPH_IMAGE_W_LSB 0
#define SPH_IMAGE_W_BITS 12
#define SPH_IMAGE_H_LSB 12
#define SPH_IMAGE_H_BITS 12
#define SPH_IMAGE_LEVELS_LSB 24
#define SPH_IMAGE_LEVELS_BITS 4
#define SPH_IMAGE_FIRST_LSB 28
#define SPH_IMAGE_FIRST_BITS 20
#define SPH_BOX_LO_X_LSB 0
#define SPH_BOX_LO_X_BITS 7
#define SPH_BOX_LO_Y_LSB 7
#define SPH_BOX_LO_Y_BITS 7
#define SPH_BOX_LO_Z_LSB 14
#define SPH_BOX_LO_Z_BITS 7
#define SPH_BOX_HI_X_LSB 21
#define SPH_BOX_HI_X_BITS 7
#define SPH_BOX_HI_Y_LSB 28
#define SPH_BOX_HI_Y_BITS 7
#define SPH_BOX_HI_Z_LSB 35
#define SPH_BOX_HI_Z_BITS 7
#define SPH_BOX_STRIDE 42
#define SPH_FRAME_ORG_X_LSB 168
#define SPH_FRAME_ORG_X_BITS 14
#define SPH_FRAME_ORG_Y_LSB 182
#define SPH_FRAME_ORG_Y_BITS 14
#define SPH_FRAME_ORG_Z_LSB 196
#define SPH_FRAME_ORG_Z_BITS 14
#define SPH_FRAME_STEP_X_LSB 210
#define SPH_FRAME_STEP_X_BITS 4
#define SPH_FRAME_STEP_Y_LSB 214
#define SPH_FRAME_STEP_Y_BITS 4
#define SPH_FRAME_STEP_Z_LSB 218
#define SPH_FRAME_STEP_Z_BITS 4
#define SPH_BIH_CHILD_LSB 0
#define SPH_BIH_CHILD_BITS 29
#define SPH_BIH_FIT_LSB 29
#define SPH_BIH_FIT_BITS 1
#define SPH_BIH_AXIS_LSB 30
#define SPH_BIH_AXIS_BITS 2
#define SPH_BIH_CLIP_L_LSB 32
#define SPH_BIH_CLIP_L_BITS 32
#define SPH_BIH_CLIP_R_LSB 64
#define SPH_BIH_CLIP_R_BITS 32
#define SPH_BIH_FIRST_LSB 32
#define SPH_BIH_FIRST_BITS 32
#define SPH_BIH_COUNT_LSB 64
#define SPH_BIH_COUNT_BITS 32
#define SPH_BIH_STRIDE 128
#define SPH_SPAN_X0_LSB 0
#define SPH_SPAN_X0_BITS 16
#define SPH_SPAN_X1_LSB 16
#define SPH_SPAN_X1_BITS 16
#define SPH_SPAN_STRIDE 32
#define SPH_CONE_F_LSB 0
#define SPH_CONE_F_BITS 128
#define SPH_CONE_FX_LSB 128
#define SPH_CONE_FX_BITS 128
#define SPH_CONE_FY_LSB 256
#define SPH_CONE_FY_BITS 128
#define SPH_CONE_FXX_LSB 384
#define SPH_CONE_FXX_BITS 128
#define SPH_CONE_FXY_LSB 512
#define SPH_CONE_FXY_BITS 128
#define SPH_CONE_FYY_LSB 640
#define SPH_CONE_FYY_BITS 128
#define SPH_CONE_B_LSB 768
#define SPH_CONE_B_BITS 64
#define SPH_CONE_BX_LSB 832
#define SPH_CONE_BX_BITS 64
#define SPH_CONE_BY_LSB 896
#define SPH_CONE_BY_BITS 64
#define SPH_CONE_INSIDE_LSB 960
#define SPH_CONE_INSIDE_BITS 1
#define SPH_REG_EFFECTS 0
#define SPH_REG_MAX_DEPTH 1
#define SPH_REG_N_LIGHTS 2
#define SPH_REG_FRAME_W 3
#define SPH_REG_FRAME_H 4
#define SPH_REG_WIN_X0 5
#define SPH_REG_WIN_Y0 6
#define SPH_REG_WIN_X1 7
#define SPH_REG_WIN_Y1 8
#define SPH_REG_BG_MODE 9
#define SPH_REG_RECT_X0 10
#define SPH_REG_RECT_Y0 11
#define SPH_REG_RECT_X1 12
#define SPH_REG_RECT_Y1 13
#define SPH_REG_BG_COLOUR 14
#define SPH_REG_AMBIENT_R 15
#define SPH_REG_AMBIENT_G 16
#define SPH_REG_AMBIENT_B 17
#define SPH_REG_EYE_X 18
#define SPH_REG_EYE_Y 19
#define SPH_REG_EYE_Z 20
#define SPH_REG_DIR_X0 21
#define SPH_REG_DIR_Y0 22
#define SPH_REG_DIR_Z 23
#define SPH_REG_PITCH 24
#define SPH_REG_ROOT 25
#define SPH_REG_PRIM_BASE 26
#define SPH_REG_MEM_LINES 27
#define SPH_REG_N_PRIMS 28
#define SPH_REG_VISIT_LIMIT 29
#define SPH_REG_PROFILE 30
#define SPH_REG_TREE 31
#define SPH_REG_LIGHT0_X 32
#define SPH_REG_LIGHT0_Y 33
#define SPH_REG_LIGHT0_Z 34
#define SPH_REG_LIGHT0_R 35
#define SPH_REG_LIGHT0_G 36
#define SPH_REG_LIGHT0_B 37
#define SPH_REG_FRAME 96
#define SPH_REG_BG_BASE 97
#define SPH_REG_BG_COUNT 98
#define SPH_REG_FACET_BASE 99
#define SPH_REG_N_SPHERES 100
#define SPH_REG_TEX_FILTER 101
#define SPH_REG_COARSE 102
#define SPH_REG_SMOOTH_BASE 103
#define SPH_REG_LEAF_BASE 104
#define SPH_REG_N_LOOSE 105
#define SPH_REG_BOX_X0 106
#define SPH_REG_BOX_Y0 107
#define SPH_REG_BOX_Z0 108
#define SPH_REG_BOX_X1 109
#define SPH_REG_BOX_Y1 110
#define SPH_REG_BOX_Z1 111
#define SPH_REG_ACROSS_X 112
#define SPH_REG_ACROSS_Y 113
#define SPH_REG_ACROSS_Z 114
#define SPH_REG_DOWN_X 115
#define SPH_REG_DOWN_Y 116
#define SPH_REG_DOWN_Z 117
#define SPH_REG_LEAST_WEIGHT 118
#define SPH_REG_ONE_CAMERA 119
#define SPH_LEAST_WEIGHT_MAX 256
#define SPH_CAMERA_TURN 11
#define SPH_LIGHT_STRIDE 8
#define SPH_LIGHT_SHIFT_LSB 16
#define SPH_LIGHT_SHIFT_BITS 5
#define SPH_N_REGS 120
#define SPH_COUNT_RAYS_PRIMARY 0
#define SPH_COUNT_RAYS_SHADOW 1
#define SPH_COUNT_RAYS_REFLECTED 2
#define SPH_COUNT_NODE_VISITS 3
#define SPH_COUNT_CHILD_TESTS 4
#define SPH_COUNT_LEAF_TESTS 5
#define SPH_COUNT_ROOTS 6
#define SPH_COUNT_QUOTIENTS 7
#define SPH_COUNT_BACKGROUND 8
#define SPH_COUNT_SATURATIONS 9
#define SPH_COUNT_CYCLES 10
#define SPH_COUNT_ISSUE_WAIT 11
#define SPH_COUNT_NODE_MISSES 12
#define SPH_COUNT_LEAF_MISSES 13
#define SPH_COUNT_RAYS_WAITING 14
#define SPH_COUNT_POP_BUBBLES 15
#define SPH_COUNT_FACET_TESTS 16
#define SPH_COUNT_DIVISIONS 17
#define SPH_COUNT_TEXELS 18
#define SPH_COUNT_TEXEL_MISSES 19
#define SPH_COUNT_RAYS_REFRACTED 20
#define SPH_COUNT_POWERS 21
#define SPH_ERROR_BAD_NODE 0
#define SPH_ERROR_STACK_OVERFLOW 1
#define SPH_ERROR_VISIT_LIMIT 2
#define SPH_ERROR_BUS_ERROR 3
#define SPH_ERROR_MISSING_EFFECT 4
#define SPH_ERROR_WRONG_PROFILE 5
#define SPH_ERROR_LEFT_OUT 6
#define SPH_EFFECT_SHADOW 0
#define SPH_EFFECT_REFLECT 1
#define SPH_EFFECT_INSIDE 2
#define SPH_EFFECT_FIRST 3
#define SPH_EFFECT_INTERPENETRATE 4
#define SPH_EFFECT_FACETS 5
#define SPH_EFFECT_TEXTURE 6
#define SPH_EFFECT_REFRACT 7
#define SPH_EFFECT_SPECULAR 8
#define SPH_EFFECT_SUM 9
#define SPH_EFFECT_SMOOTH 10
#define SPH_EFFECT_CLEAR 11
#define SPH_EFFECT_TURNED 12
#define SPH_EFFECT_SPREAD 13
#define SPH_EFFECT_CAMERA 14
#define SPH_EFFECT_BITS 15
#define SPH_KINDS 3
#define SPH_KINDS_UNBOUNDED 4
#define SPH_COUNTERS 22
#define SPH_COUNTERS_BOTH 3605503
#define SPH_ERRORS 7
#define SPH_PROFILE_TABLE {"draft", 12, 13, 13, 2, 12, 0}, {"standard", 16, 17, 17, 2, 14, 0}, {"fine", 20, 22, 24, 2, 14, 0}, {"reference", 24, 25, 28, 2, 14, 0}
#define SPH_WIDTH_TABLE {"w", offsetof(struct sph_profile, w), 0, 5, 8, 24, "a leaf record has 24 bits"}, {"wd", offsetof(struct sph_profile, wd), 5, 5, 9, 31, "a register has 32 bits"}, {"pq", offsetof(struct sph_profile, pq), 10, 6, 4, 32, "a quotient is one word of the model"}, {"ng", offsetof(struct sph_profile, ng), 16, 3, 0, 4, "the bounds of build are 64-bit numbers"}, {"fw", offsetof(struct sph_profile, fw), 19, 4, 6, 14, "a node record has 14 bits"}, {"pr", offsetof(struct sph_profile, pr), 23, 6, 0, 51, "the longest root has 52 bits"}
#define SPH_COUNTER_NAMES "rays_primary", "rays_shadow", "rays_reflected", "node_visits", "child_tests", "leaf_tests", "roots", "quotients", "background", "saturations", "cycles", "issue_wait", "node_misses", "leaf_misses", "rays_waiting", "pop_bubbles", "facet_tests", "divisions", "texels", "texel_misses", "rays_refracted", "powers"
#define SPH_ERROR_NAMES "bad_node", "stack_overflow", "visit_limit", "bus_error", "missing_effect", "wrong_profile", "left_out"
#define SPH_EFFECT_MASK 32767
#define SPH_EACH_EFFECT(X)  \
    X(SHADOW, shadow, "SHADOW", 0, 1, 1, SPH_OPTION_WHEN, 0, 0, -1, 0, 0, -1, "rays towards the lights") \
    X(REFLECT, reflect, "REFLECT", 1, 10, 5, SPH_OPTION_WHEN, 0, 0, -1, 0, 0, SPH_REG_MAX_DEPTH, "mirror rays, up to MAX_DEPTH") \
    X(LIGHTS, lights, "LIGHTS", -1, 8, 8, SPH_OPTION_COUNT, 0, 0, -1, 0, 0, SPH_REG_N_LIGHTS, "point lights") \
    X(INSIDE, inside, "INSIDE", 2, 1, 1, SPH_OPTION_WHEN, 0, 0, -1, 0, 0, -1, "rays may start inside a sphere, far roots count") \
    X(FIRST, first, "FIRST", 3, 1, 1, SPH_OPTION_NONE, 0, 0, -1, 0, 0, -1, "primary rays end at the first visit that hits a leaf") \
    X(INTERPENETRATE, interpenetrate, "INTERPENETRATE", 4, 1, 1, SPH_OPTION_WHEN, 24, 0, -1, 0, 0, -1, "mends first hits that lie in another sphere") \
    X(FACETS, facets, "FACETS", 5, 1, 1, SPH_OPTION_NONE, 0, 48, -1, 0, 0, -1, "triangles and planes") \
    X(TEXTURE, texture, "TEXTURE", 6, 1, 0, SPH_OPTION_OFF, 0, 0, -1, 0, 0, -1, "images on surfaces") \
    X(REFRACT, refract, "REFRACT", 7, 1, 0, SPH_OPTION_WHEN, 8, 48, -1, 0, 0, -1, "refracted rays, mirror rays where all is reflected") \
    X(SPECULAR, specular, "SPECULAR", 8, 1, 0, SPH_OPTION_WHEN, 1024, 0, -1, 0, 0, -1, "highlights of materials with sum") \
    X(SUM, sum, "SUM", 9, 1, 0, SPH_OPTION_NONE, 0, 0, -1, 0, 0, -1, "materials whose shares add up, colour on top of rays") \
    X(SMOOTH, smooth, "SMOOTH", 10, 1, 0, SPH_OPTION_WHEN, 64, 0, -1, 0, 0, -1, "interpolated normals of triangles") \
    X(CLEAR, clear, "CLEAR", 11, 1, 0, SPH_OPTION_WHEN, 1, 0, -1, 0, 0, -1, "shadow rays pass what is marked as clear") \
    X(TURNED, turned, "TURNED", 12, 1, 0, SPH_OPTION_NONE, 0, 32, -1, 0, 0, -1, "a grid in other axes than the camera's") \
    X(SPREAD, spread, "SPREAD", 13, 1, 0, SPH_OPTION_WHEN, 128, 0, -1, 0, 0, -1, "levels in mirrors and glass by how spheres spread rays") \
    X(CAMERA, camera, "CAMERA", 14, 1, 1, SPH_OPTION_NONE, 0, 0, -1, 0, 0, -1, "any other camera is refused, since something is left out")
#define SPH_EACH_PART(X) SPH_EACH_EFFECT(X) \
    X(COARSE, coarse, "COARSE", -1, 8, 0, SPH_OPTION_NONE, 128, 0, -1, 0, 0, SPH_REG_COARSE, "bits of the fraction of levels rounded away") \
    X(RECT, rect, "RECT", -1, 1, 1, SPH_OPTION_NONE, 0, 0, SPH_REG_BG_MODE, 1, 1, -1, "background separation by rectangle") \
    X(SPANS, spans, "SPANS", -1, 1, 1, SPH_OPTION_NONE, 0, 0, SPH_REG_BG_MODE, 2, 2, -1, "background separation by spans in memory") \
    X(CONES, cones, "CONES", -1, 16, 1, SPH_OPTION_NONE, 0, 0, SPH_REG_BG_MODE, 3, 3, SPH_REG_BG_COUNT, "exact background separation, by so many spheres") \
    X(BIH, bih, "ACCEL", -1, 1, 0, SPH_OPTION_NONE, 0, 16, SPH_REG_TREE, 3, 4, -1, "a BIH instead of nodes of four children") \
    X(BOXES, boxes, "BOXES", -1, 1, 0, SPH_OPTION_NONE, 0, 1048592, SPH_REG_TREE, 6, 6, -1, "boxes around the children of a node, not spheres")
#define SPH_EACH_REG(X)  \
    X(EFFECTS) \
    X(MAX_DEPTH) \
    X(N_LIGHTS) \
    X(FRAME_W) \
    X(FRAME_H) \
    X(WIN_X0) \
    X(WIN_Y0) \
    X(WIN_X1) \
    X(WIN_Y1) \
    X(BG_MODE) \
    X(RECT_X0) \
    X(RECT_Y0) \
    X(RECT_X1) \
    X(RECT_Y1) \
    X(BG_COLOUR) \
    X(AMBIENT_R) \
    X(AMBIENT_G) \
    X(AMBIENT_B) \
    X(EYE_X) \
    X(EYE_Y) \
    X(EYE_Z) \
    X(DIR_X0) \
    X(DIR_Y0) \
    X(DIR_Z) \
    X(PITCH) \
    X(ROOT) \
    X(PRIM_BASE) \
    X(MEM_LINES) \
    X(N_PRIMS) \
    X(VISIT_LIMIT) \
    X(PROFILE) \
    X(TREE) \
    X(LIGHT0_X) \
    X(LIGHT0_Y) \
    X(LIGHT0_Z) \
    X(LIGHT0_R) \
    X(LIGHT0_G) \
    X(LIGHT0_B) \
    X(FRAME) \
    X(BG_BASE) \
    X(BG_COUNT) \
    X(FACET_BASE) \
    X(N_SPHERES) \
    X(TEX_FILTER) \
    X(COARSE) \
    X(SMOOTH_BASE) \
    X(LEAF_BASE) \
    X(N_LOOSE) \
    X(BOX_X0) \
    X(BOX_Y0) \
    X(BOX_Z0) \
    X(BOX_X1) \
    X(BOX_Y1) \
    X(BOX_Z1) \
    X(ACROSS_X) \
    X(ACROSS_Y) \
    X(ACROSS_Z) \
    X(DOWN_X) \
    X(DOWN_Y) \
    X(DOWN_Z) \
    X(LEAST_WEIGHT) \
    X(ONE_CAMERA)
#define SPH_EACH_KIND(X)  \
    X(sphere) \
    X(triangle) \
    X(plane)
#define SPH_EACH_COUNTER(X)  \
    X(RAYS_PRIMARY, rays_primary) \
    X(RAYS_SHADOW, rays_shadow) \
    X(RAYS_REFLECTED, rays_reflected) \
    X(NODE_VISITS, node_visits) \
    X(CHILD_TESTS, child_tests) \
    X(LEAF_TESTS, leaf_tests) \
    X(ROOTS, roots) \
    X(QUOTIENTS, quotients) \
    X(BACKGROUND, background) \
    X(SATURATIONS, saturations) \
    X(CYCLES, cycles) \
    X(ISSUE_WAIT, issue_wait) \
    X(NODE_MISSES, node_misses) \
    X(LEAF_MISSES, leaf_misses) \
    X(RAYS_WAITING, rays_waiting) \
    X(POP_BUBBLES, pop_bubbles) \
    X(FACET_TESTS, facet_tests) \
    X(DIVISIONS, divisions) \
    X(TEXELS, texels) \
    X(TEXEL_MISSES, texel_misses) \
    X(RAYS_REFRACTED, rays_refracted) \
    X(POWERS, powers)
#define SPH_EACH_SIZE(X)  \
    X(ENGINES, 1) \
    X(PIPES, 1) \
    X(LEAF_UNITS, 0) \
    X(SHADES, 0) \
    X(SETUPS, 0) \
    X(WALKS, 0) \
    X(SLOTS, 64) \
    X(MEM_DATA, 64) \
    X(MEM_PENDING, 0) \
    X(LINE_BITS, 24) \
    X(NODE_LINES, 512) \
    X(LEAF_LINES, 128) \
    X(TEXTURE_LINES, 128) \
    X(TEXTURE_WAYS, 4) \
    X(TEXTURE_GROUP, 1) \
    X(TEXTURE_COORDS, 2) \
    X(ROOTS, 0) \
    X(QUOTIENTS, 2) \
    X(ROOT_STEP, 1) \
    X(QUOTIENT_STEP, 2) \
    X(LEAF_INTERVAL, 2) \
    X(FACET_INTERVAL, 0) \
    X(UNITS, 2) \
    X(UNIT_INTERVAL, 2) \
    X(SQUARES, 0) \
    X(SPILLS, 0) \
    X(HIT_INTERVAL, 8) \
    X(BOUNCE_INTERVAL, 10)
#define SPH_EACH_PACE(X)  \
    X(FINE, LEAF_INTERVAL, 4) \
    X(FINE, UNIT_INTERVAL, 4) \
    X(FINE, HIT_INTERVAL, 12) \
    X(FINE, BOUNCE_INTERVAL, 12) \
    X(FINE, WALKS, 2) \
    X(REFERENCE, LEAF_INTERVAL, 4) \
    X(REFERENCE, UNIT_INTERVAL, 4) \
    X(REFERENCE, HIT_INTERVAL, 12) \
    X(REFERENCE, BOUNCE_INTERVAL, 12) \
    X(REFERENCE, WALKS, 2)
#define SPH_EACH_UNIT_COUNT(X)  \
    X(SHADE_UNITS, (SHADES != 0 ? SHADES : PIPES == 1 || INTERPENETRATE != 0 ? 1 : PIPES == 4 ? 4 : 2)) \
    X(LEAF_COUNT, (LEAF_UNITS>0 ? LEAF_UNITS : BOXES>0 ? SHADE_UNITS : PIPES>2 && SHADE_UNITS>1 ? 2:1)) \
    X(SETUP_UNITS, (SETUPS != 0 ? SETUPS : PIPES == 4 && LEAF_COUNT > 1 ? 2 : 1)) \
    X(LINES_COMING, (MEM_PENDING != 0 ? MEM_PENDING : MEM_DATA))
#define SPH_EACH_RATE(X)  \
    X(FACET_CLOCKS, (FACET_INTERVAL != 0 ? FACET_INTERVAL : BOXES == 0 && W >= 18 ? 4 : 2)) \
    X(KEY_CLOCKS, ((2 * WD + 16) / 17)) \
    X(ROOT_STAGES, (ROOTS != 0 ? ROOTS : PIPES > 1 ? 12 : 6)) \
    X(ROOT_ROUNDS, ((W + WD + ROOT_STEP - 1) / ROOT_STEP)) \
    X(ROOT_CLOCKS, (ROOT_ROUNDS / ROOT_STAGES + 1)) \
    X(QUOTIENT_CLOCKS, ((PQ + QUOTIENT_STEP - 1) / QUOTIENT_STEP + 6)) \
    X(REFRACT_CLOCKS, (62 + 11 * (WD > 17) + (W + WD + 1) / 2))
#define SPH_EACH_LOAD(X)  \
    X(node_visits, "node visits", PIPES, node_visits + ACCEL * (rays + node_visits - child_tests/2)) \
    X(rays_set_up_for_planes, "rays set up for planes", PIPES, (ACCEL + BOXES > 0) * rays * 3) \
    X(records_to_tests, "records to tests", LEAF_COUNT, 2 * (leaf_tests + facet_tests)) \
    X(exact_tests_of_spheres, "exact tests of spheres", LEAF_COUNT, leaf_tests * LEAF_INTERVAL) \
    X(exact_tests_of_facets, "exact tests of facets", LEAF_COUNT, facet_tests * FACET_CLOCKS) \
    X(keys_of_facets, "keys of facets", LEAF_COUNT, divisions * KEY_CLOCKS) \
    X(roots, "roots", LEAF_COUNT, roots * ROOT_CLOCKS) \
    X(unit_vectors, "unit vectors", SETUP_UNITS * UNITS, vectors * UNIT_INTERVAL) \
    X(quotients, "quotients", SHADE_UNITS * QUOTIENTS, quotients * QUOTIENT_CLOCKS) \
    X(points_and_normals, "points and normals", SHADE_UNITS, quotients * HIT_INTERVAL) \
    X(mirrored_directions, "mirrored directions", SHADE_UNITS, rays_reflected * BOUNCE_INTERVAL) \
    X(refracted_directions, "refracted directions", SHADE_UNITS, rays_refracted * REFRACT_CLOCKS) \
    X(lights_added, "lights added", SHADE_UNITS, 3 * quotients * (1 + N_LIGHTS)) \
    X(highlights, "highlights", SHADE_UNITS, powers * 24) \
    X(surfaces_blended, "surfaces blended", SHADE_UNITS, SUM * surfaces * 12) \
    X(interpolated_normals, "interpolated normals", SHADE_UNITS, SMOOTH * min(quotients, divisions) * 18) \
    X(texture_coordinates, "texture coordinates", SHADE_UNITS, textured * 13) \
    X(pixel_walk, "pixel walk", 1, rays_primary)

#endif
