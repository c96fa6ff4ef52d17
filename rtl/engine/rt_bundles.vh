// rt_bundles.vh - generated from bundles.def by sim/bundles.awk; do not edit
// SPDX-License-Identifier: Apache-2.0
// bus[`RT_RAY_ORG] is field ORG of a bus of `RT_RAY_BITS bits, a bundle ray
`ifndef RT_BUNDLES_VH
`define RT_BUNDLES_VH
`include "rt_layout.vh"
`define RT_VEC_X 0 +: WD
`define RT_VEC_Y WD +: WD
`define RT_VEC_Z 2*WD +: WD
`define RT_VEC_BITS (3*WD)
`define RT_POINT_X 0 +: W
`define RT_POINT_Y W +: W
`define RT_POINT_Z 2*W +: W
`define RT_POINT_BITS (3*W)
`define RT_UNIT_X 0 +: 18
`define RT_UNIT_Y 18 +: 18
`define RT_UNIT_Z 36 +: 18
`define RT_UNIT_BITS (54)
`define RT_VECTOR_VALID 0 +: 1
`define RT_VECTOR_SLOT 1 +: $clog2(SLOTS)
`define RT_VECTOR_VEC $clog2(SLOTS)+1 +: 3*WD
`define RT_VECTOR_BITS ($clog2(SLOTS)+3*WD+1)
`define RT_ORG_VALID 0 +: 1
`define RT_ORG_SLOT 1 +: $clog2(SLOTS)
`define RT_ORG_POINT $clog2(SLOTS)+1 +: 3*W
`define RT_ORG_BITS ($clog2(SLOTS)+3*W+1)
`define RT_SKIP_VALID 0 +: 1
`define RT_SKIP_SLOT 1 +: $clog2(SLOTS)
`define RT_SKIP_ID $clog2(SLOTS)+1 +: `RT_ID_BITS
`define RT_SKIP_INSIDE $clog2(SLOTS)+`RT_ID_BITS+1 +: 1
`define RT_SKIP_BITS ($clog2(SLOTS)+`RT_ID_BITS+2)
`define RT_RAY_VALID 0 +: 1
`define RT_RAY_NORMAL 1 +: 1
`define RT_RAY_LIGHT 2 +: 1
`define RT_RAY_SLOT 3 +: $clog2(SLOTS)
`define RT_RAY_PRIMARY $clog2(SLOTS)+3 +: 1
`define RT_RAY_SHADOW $clog2(SLOTS)+4 +: 1
`define RT_RAY_ORG $clog2(SLOTS)+5 +: 3*W
`define RT_RAY_DIR $clog2(SLOTS)+3*W+5 +: 3*WD
`define RT_RAY_A $clog2(SLOTS)+3*W+3*WD+5 +: 2*WD
`define RT_RAY_SKIP $clog2(SLOTS)+3*W+3*WD+2*WD+5 +: `RT_ID_BITS
`define RT_RAY_INSIDE $clog2(SLOTS)+3*W+3*WD+2*WD+`RT_ID_BITS+5 +: 1
`define RT_RAY_UNIT $clog2(SLOTS)+3*W+3*WD+2*WD+`RT_ID_BITS+6 +: 54
`define RT_RAY_Y $clog2(SLOTS)+3*W+3*WD+2*WD+`RT_ID_BITS+60 +: 17
`define RT_RAY_H $clog2(SLOTS)+3*W+3*WD+2*WD+`RT_ID_BITS+77 +: 6
`define RT_RAY_BITS ($clog2(SLOTS)+3*W+3*WD+2*WD+`RT_ID_BITS+83)
`define RT_FILTER_ORG 0 +: 3*FW
`define RT_FILTER_AXIS 3*FW +: 2
`define RT_FILTER_NEGATIVE 3*FW+2 +: 1
`define RT_FILTER_SCALE 3*FW+3 +: 17
`define RT_FILTER_SHIFT 3*FW+20 +: 6
`define RT_FILTER_DEPTH 3*FW+26 +: FW+1
`define RT_FILTER_BITS (3*FW+FW+1+26)
`define RT_VISIT_VALID 0 +: 1
`define RT_VISIT_SLOT 1 +: $clog2(SLOTS)
`define RT_VISIT_LEAF $clog2(SLOTS)+1 +: 4
`define RT_VISIT_LINE $clog2(SLOTS)+5 +: `RT_LINE_BITS
`define RT_VISIT_BITS ($clog2(SLOTS)+`RT_LINE_BITS+5)
`define RT_TEST_SLOT 0 +: $clog2(SLOTS)
`define RT_TEST_SHADOW $clog2(SLOTS) +: 1
`define RT_TEST_INSIDE $clog2(SLOTS)+1 +: 1
`define RT_TEST_ERROR $clog2(SLOTS)+2 +: 1
`define RT_TEST_ORG $clog2(SLOTS)+3 +: 3*W
`define RT_TEST_DIR $clog2(SLOTS)+3*W+3 +: 3*WD
`define RT_TEST_A $clog2(SLOTS)+3*W+3*WD+3 +: 2*WD
`define RT_TEST_SKIP $clog2(SLOTS)+3*W+3*WD+2*WD+3 +: `RT_ID_BITS
`define RT_TEST_RECORD $clog2(SLOTS)+3*W+3*WD+2*WD+`RT_ID_BITS+3 +: 256
`define RT_TEST_BITS ($clog2(SLOTS)+3*W+3*WD+2*WD+`RT_ID_BITS+259)
`define RT_FOUND_VALID 0 +: 1
`define RT_FOUND_SLOT 1 +: $clog2(SLOTS)
`define RT_FOUND_FRESH $clog2(SLOTS)+1 +: 1
`define RT_FOUND_KILL $clog2(SLOTS)+2 +: 1
`define RT_FOUND_BASE $clog2(SLOTS)+3 +: `RT_LINE_BITS
`define RT_FOUND_COUNT $clog2(SLOTS)+`RT_LINE_BITS+3 +: 3
`define RT_FOUND_LIST $clog2(SLOTS)+`RT_LINE_BITS+6 +: 72
`define RT_FOUND_BITS ($clog2(SLOTS)+`RT_LINE_BITS+78)
`define RT_RESULT_VALID 0 +: 1
`define RT_RESULT_SLOT 1 +: $clog2(SLOTS)
`define RT_RESULT_HIT $clog2(SLOTS)+1 +: 1
`define RT_RESULT_FAR $clog2(SLOTS)+2 +: 1
`define RT_RESULT_ID $clog2(SLOTS)+3 +: `RT_ID_BITS
`define RT_RESULT_KEY $clog2(SLOTS)+`RT_ID_BITS+3 +: W+WD+2
`define RT_RESULT_BITS ($clog2(SLOTS)+`RT_ID_BITS+W+WD+2+3)
`define RT_DONE_FOUND 0 +: 1
`define RT_DONE_SHADOW 1 +: 1
`define RT_DONE_PRIMARY 2 +: 1
`define RT_DONE_FIRST 3 +: 1
`define RT_DONE_FAR 4 +: 1
`define RT_DONE_ID 5 +: `RT_ID_BITS
`define RT_DONE_KEY `RT_ID_BITS+5 +: W+WD+2
`define RT_DONE_BITS (`RT_ID_BITS+W+WD+2+5)
`define RT_HIT_HIT 0 +: 1
`define RT_HIT_MISS 1 +: 1
`define RT_HIT_SHADOW 2 +: 1
`define RT_HIT_SLOT 3 +: $clog2(SLOTS)
`define RT_HIT_LIT $clog2(SLOTS)+3 +: 1
`define RT_HIT_FIRST $clog2(SLOTS)+4 +: 1
`define RT_HIT_PROBE $clog2(SLOTS)+5 +: 1
`define RT_HIT_FAR $clog2(SLOTS)+6 +: 1
`define RT_HIT_ID $clog2(SLOTS)+7 +: `RT_ID_BITS
`define RT_HIT_KEY $clog2(SLOTS)+`RT_ID_BITS+7 +: W+WD+2
`define RT_HIT_BITS ($clog2(SLOTS)+`RT_ID_BITS+W+WD+2+7)
`define RT_FETCH_VALID 0 +: 1
`define RT_FETCH_SLOT 1 +: $clog2(SLOTS)
`define RT_FETCH_LINE $clog2(SLOTS)+1 +: `RT_LINE_BITS
`define RT_FETCH_BITS ($clog2(SLOTS)+`RT_LINE_BITS+1)
`define RT_RECORD_VALID 0 +: 1
`define RT_RECORD_SLOT 1 +: $clog2(SLOTS)
`define RT_RECORD_DATA $clog2(SLOTS)+1 +: 256
`define RT_RECORD_BITS ($clog2(SLOTS)+257)
`define RT_SURFACE_VALID 0 +: 1
`define RT_SURFACE_SLOT 1 +: $clog2(SLOTS)
`define RT_SURFACE_POINT $clog2(SLOTS)+1 +: 3*W
`define RT_SURFACE_GUARDED $clog2(SLOTS)+3*W+1 +: 3*(W+NG)
`define RT_SURFACE_NORMAL $clog2(SLOTS)+3*W+3*(W+NG)+1 +: 3*WD
`define RT_SURFACE_BITS ($clog2(SLOTS)+3*W+3*(W+NG)+3*WD+1)
`define RT_MATERIAL_VALID 0 +: 1
`define RT_MATERIAL_SLOT 1 +: $clog2(SLOTS)
`define RT_MATERIAL_RGB $clog2(SLOTS)+1 +: 24
`define RT_MATERIAL_KR $clog2(SLOTS)+25 +: 9
`define RT_MATERIAL_KT $clog2(SLOTS)+34 +: 9
`define RT_MATERIAL_SUM $clog2(SLOTS)+43 +: 1
`define RT_MATERIAL_KA $clog2(SLOTS)+44 +: 9
`define RT_MATERIAL_KD $clog2(SLOTS)+53 +: 9
`define RT_MATERIAL_KS $clog2(SLOTS)+62 +: 8
`define RT_MATERIAL_POWER $clog2(SLOTS)+70 +: 12
`define RT_MATERIAL_INDEX $clog2(SLOTS)+82 +: 12
`define RT_MATERIAL_TEX $clog2(SLOTS)+94 +: `RT_LINE_BITS
`define RT_MATERIAL_BITS ($clog2(SLOTS)+`RT_LINE_BITS+94)
`define RT_BLEND_VALID 0 +: 1
`define RT_BLEND_SLOT 1 +: $clog2(SLOTS)
`define RT_BLEND_LAST $clog2(SLOTS)+1 +: 1
`define RT_BLEND_PROBE $clog2(SLOTS)+2 +: 1
`define RT_BLEND_MIRROR $clog2(SLOTS)+3 +: 1
`define RT_BLEND_REFRACT $clog2(SLOTS)+4 +: 1
`define RT_BLEND_DEPTH $clog2(SLOTS)+5 +: 3
`define RT_BLEND_W_MIRROR $clog2(SLOTS)+8 +: 17
`define RT_BLEND_W_REFRACT $clog2(SLOTS)+25 +: 17
`define RT_BLEND_W_TOTAL $clog2(SLOTS)+42 +: 17
`define RT_BLEND_BITS ($clog2(SLOTS)+59)
`define RT_BACK_VALID 0 +: 1
`define RT_BACK_SLOT 1 +: $clog2(SLOTS)
`define RT_BACK_POINT $clog2(SLOTS)+1 +: 3*W
`define RT_BACK_ID $clog2(SLOTS)+3*W+1 +: `RT_ID_BITS
`define RT_BACK_INSIDE $clog2(SLOTS)+3*W+`RT_ID_BITS+1 +: 1
`define RT_BACK_PATH $clog2(SLOTS)+3*W+`RT_ID_BITS+2 +: W+8
`define RT_BACK_BITS ($clog2(SLOTS)+3*W+`RT_ID_BITS+W+8+2)
`define RT_START_X 0 +: 14
`define RT_START_Y 14 +: 14
`define RT_START_DIR 28 +: 3*WD
`define RT_START_BITS (3*WD+28)
`define RT_PIXEL_X 0 +: 14
`define RT_PIXEL_Y 14 +: 14
`define RT_PIXEL_COLOUR 28 +: 72
`define RT_PIXEL_ID 100 +: `RT_ID_BITS
`define RT_PIXEL_VISITS `RT_ID_BITS+100 +: 24
`define RT_PIXEL_KEY `RT_ID_BITS+124 +: W+WD+2
`define RT_PIXEL_TEXTURE `RT_ID_BITS+W+WD+2+124 +: 32
`define RT_PIXEL_BITS (`RT_ID_BITS+W+WD+2+156)
`define RT_LIGHT_VALID 0 +: 1
`define RT_LIGHT_NUMBER 1 +: 3
`define RT_LIGHT_PART 4 +: 3
`define RT_LIGHT_DATA 7 +: 32
`define RT_LIGHT_BITS (39)
`define RT_REGS_EFFECTS 0 +: `RT_EFFECT_BITS
`define RT_REGS_TEX_FILTER `RT_EFFECT_BITS +: 2
`define RT_REGS_MAX_DEPTH `RT_EFFECT_BITS+2 +: 3
`define RT_REGS_N_LIGHTS `RT_EFFECT_BITS+5 +: 4
`define RT_REGS_BACKGROUND `RT_EFFECT_BITS+9 +: 24
`define RT_REGS_AMBIENT `RT_EFFECT_BITS+33 +: 48
`define RT_REGS_EYE `RT_EFFECT_BITS+81 +: 3*W
`define RT_REGS_ROOT `RT_EFFECT_BITS+3*W+81 +: `RT_LINE_BITS
`define RT_REGS_PRIM_BASE `RT_EFFECT_BITS+3*W+`RT_LINE_BITS+81 +: `RT_LINE_BITS
`define RT_REGS_MEM_LINES `RT_EFFECT_BITS+3*W+2*`RT_LINE_BITS+81 +: `RT_LINE_BITS
`define RT_REGS_VISIT_LIMIT `RT_EFFECT_BITS+3*W+3*`RT_LINE_BITS+81 +: 24
`define RT_REGS_N_PRIMS `RT_EFFECT_BITS+3*W+3*`RT_LINE_BITS+105 +: 24
`define RT_REGS_LEAF_BASE `RT_EFFECT_BITS+3*W+3*`RT_LINE_BITS+129 +: `RT_LINE_BITS
`define RT_REGS_N_LOOSE `RT_EFFECT_BITS+3*W+4*`RT_LINE_BITS+129 +: 24
`define RT_REGS_BOX `RT_EFFECT_BITS+3*W+4*`RT_LINE_BITS+153 +: 6*(W+2)
`define RT_REGS_BITS (`RT_EFFECT_BITS+3*W+4*`RT_LINE_BITS+6*(W+2)+153)
`define RT_TRACE_EVENT_ISSUED 0 +: 1
`define RT_TRACE_EVENT_VISIT 1 +: 1
`define RT_TRACE_EVENT_TESTS 2 +: 3
`define RT_TRACE_EVENT_MISS 5 +: 1
`define RT_TRACE_EVENT_BUBBLE 6 +: 1
`define RT_TRACE_EVENT_BITS (7)
`define RT_PRIM_EVENT_LEAF 0 +: 1
`define RT_PRIM_EVENT_FACET 1 +: 1
`define RT_PRIM_EVENT_ROOT 2 +: 1
`define RT_PRIM_EVENT_DIVIDE 3 +: 1
`define RT_PRIM_EVENT_BITS (4)
`define RT_EXACT_EVENT_PRIM 0 +: `RT_PRIM_EVENT_BITS
`define RT_EXACT_EVENT_MISS `RT_PRIM_EVENT_BITS +: 1
`define RT_EXACT_EVENT_BITS (`RT_PRIM_EVENT_BITS+1)
`define RT_SHADE_EVENT_PRIMARY 0 +: 1
`define RT_SHADE_EVENT_SHADOW 1 +: 1
`define RT_SHADE_EVENT_REFLECTED 2 +: 1
`define RT_SHADE_EVENT_REFRACTED 3 +: 1
`define RT_SHADE_EVENT_QUOTIENT 4 +: 1
`define RT_SHADE_EVENT_SATURATED 5 +: 1
`define RT_SHADE_EVENT_POWER 6 +: 1
`define RT_SHADE_EVENT_TEXEL 7 +: 1
`define RT_SHADE_EVENT_MISS 8 +: 1
`define RT_SHADE_EVENT_BITS (9)
`define RT_EVENT_TRACE 0 +: `RT_TRACE_EVENT_BITS
`define RT_EVENT_EXACT `RT_TRACE_EVENT_BITS +: `RT_EXACT_EVENT_BITS
`define RT_EVENT_SHADE `RT_TRACE_EVENT_BITS+`RT_EXACT_EVENT_BITS +: `RT_SHADE_EVENT_BITS
`define RT_EVENT_BITS (`RT_TRACE_EVENT_BITS+`RT_EXACT_EVENT_BITS+`RT_SHADE_EVENT_BITS)
`endif
