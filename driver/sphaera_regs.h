/* sphaera_regs.h - generated from top.def and machine.def by make layout; do not edit
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPHAERA_REGS_H
#define SPHAERA_REGS_H

#define SPHAERA_ID 0x000u /* ro: the letters SpHR */
#define SPHAERA_ID_RESET 0x53704852u
#define SPHAERA_VERSION 0x004u /* ro: of the release, from file VERSION */
#define SPHAERA_VERSION_RESET 0x00010000u
#define SPHAERA_VERSION_MINOR_LSB 0u
#define SPHAERA_VERSION_MINOR 0x0000ffffu /* its second number: more registers, the others stay */
#define SPHAERA_VERSION_MAJOR_LSB 16u
#define SPHAERA_VERSION_MAJOR 0xffff0000u /* its first number: another meaning of a register */
#define SPHAERA_CORE_PROFILE 0x008u /* ro: widths of the core, as register PROFILE has them */
#define SPHAERA_CORE_EFFECTS 0x00cu /* ro: effects of the core, as register EFFECTS has them */
#define SPHAERA_CORE_PARTS 0x010u /* ro: what else the core was built with */
#define SPHAERA_CORE_PARTS_ENGINES_LSB 0u
#define SPHAERA_CORE_PARTS_ENGINES 0x0000000fu /* engines */
#define SPHAERA_CORE_PARTS_DEPTH_LSB 4u
#define SPHAERA_CORE_PARTS_DEPTH 0x000000f0u /* deepest reflection or refraction */
#define SPHAERA_CORE_PARTS_LIGHTS_LSB 8u
#define SPHAERA_CORE_PARTS_LIGHTS 0x00000f00u /* lights */
#define SPHAERA_CORE_PARTS_CONES_LSB 12u
#define SPHAERA_CORE_PARTS_CONES 0x0001f000u /* cones of the background */
#define SPHAERA_CORE_PARTS_RECT_LSB 17u
#define SPHAERA_CORE_PARTS_RECT 0x00020000u /* rectangle of the background */
#define SPHAERA_CORE_PARTS_SPANS_LSB 18u
#define SPHAERA_CORE_PARTS_SPANS 0x00040000u /* spans of the background */
#define SPHAERA_CORE_PARTS_ACCEL_LSB 19u
#define SPHAERA_CORE_PARTS_ACCEL 0x00080000u /* a BIH instead of nodes of four children */
#define SPHAERA_CORE_PARTS_COARSE_LSB 20u
#define SPHAERA_CORE_PARTS_COARSE 0x00f00000u /* bits of a level's fraction that are rounded away */
#define SPHAERA_CORE_PARTS_BOXES_LSB 24u
#define SPHAERA_CORE_PARTS_BOXES 0x01000000u /* boxes around the children of a node, not spheres */
#define SPHAERA_CORE_BUS 0x014u /* ro: what the block was built with */
#define SPHAERA_CORE_BUS_DATA_LSB 0u
#define SPHAERA_CORE_BUS_DATA 0x000000ffu /* data bits of the AXI4 masters, 64 or 128 */
#define SPHAERA_CORE_BUS_VIDEO_LSB 8u
#define SPHAERA_CORE_BUS_VIDEO 0x00000100u /* there is a video output */
#define SPHAERA_CORE_BUS_LAYERS_LSB 9u
#define SPHAERA_CORE_BUS_LAYERS 0x00000200u /* frames have three layers, Rendering, L1 and L2 */
#define SPHAERA_CORE_BUS_ADDR_LSB 10u
#define SPHAERA_CORE_BUS_ADDR 0x0000fc00u /* bits of an address of the AXI4 masters, 32 to 40 */
#define SPHAERA_CORE_BUS_BUILD_LSB 16u
#define SPHAERA_CORE_BUS_BUILD 0x001f0000u /* it builds trees of up to 2^n spheres, 0: none */
#define SPHAERA_CONTROL 0x020u /* wo: each one written is an order */
#define SPHAERA_CONTROL_RESET 0x00000000u
#define SPHAERA_CONTROL_START_LSB 0u
#define SPHAERA_CONTROL_START 0x00000001u /* draw a frame of the machine registers as they stand now */
#define SPHAERA_CONTROL_KEEP_CACHE_LSB 1u
#define SPHAERA_CONTROL_KEEP_CACHE 0x00000002u /* with START: memory did not change, caches stay */
#define SPHAERA_CONTROL_STOP_LSB 2u
#define SPHAERA_CONTROL_STOP 0x00000004u /* end the frame: it is not complete, nothing else is lost */
#define SPHAERA_CONTROL_SOFT_RESET_LSB 3u
#define SPHAERA_CONTROL_SOFT_RESET 0x00000008u /* STOP; errors, interrupts, counts of frames and the frame store start anew */
#define SPHAERA_CONTROL_FORGET_LSB 4u
#define SPHAERA_CONTROL_FORGET 0x00000010u /* with SOFT_RESET: the buses were reset too, they owe no answers */
#define SPHAERA_CONTROL_SNAPSHOT_LSB 5u
#define SPHAERA_CONTROL_SNAPSHOT 0x00000020u /* copy all counters to where they are read */
#define SPHAERA_CONTROL_TAKE_LSB 6u
#define SPHAERA_CONTROL_TAKE 0x00000040u /* take the newest frame to show, as video does at its blanking */
#define SPHAERA_CONTROL_BUILD_LSB 7u
#define SPHAERA_CONTROL_BUILD 0x00000080u /* build a tree of the records; with START: then draw, if it was built */
#define SPHAERA_STATUS 0x024u /* ro: what the block does */
#define SPHAERA_STATUS_RESET 0x00000000u
#define SPHAERA_STATUS_BUSY_LSB 0u
#define SPHAERA_STATUS_BUSY 0x00000001u /* a frame is drawn, or its pixels are still written */
#define SPHAERA_STATUS_DRAINING_LSB 1u
#define SPHAERA_STATUS_DRAINING 0x00000002u /* stopped, the buses still owe answers */
#define SPHAERA_STATUS_BLANK_LSB 2u
#define SPHAERA_STATUS_BLANK 0x00000004u /* video is between two frames */
#define SPHAERA_STATUS_VALID_LSB 3u
#define SPHAERA_STATUS_VALID 0x00000008u /* a frame is shown */
#define SPHAERA_STATUS_DRAWN_LSB 4u
#define SPHAERA_STATUS_DRAWN 0x00000030u /* number of the frame that is drawn, or was */
#define SPHAERA_STATUS_NEWEST_LSB 6u
#define SPHAERA_STATUS_NEWEST 0x000000c0u /* of the newest complete frame */
#define SPHAERA_STATUS_SHOWN_LSB 8u
#define SPHAERA_STATUS_SHOWN 0x00000300u /* of the frame that is shown */
#define SPHAERA_STATUS_WAITING_LSB 10u
#define SPHAERA_STATUS_WAITING 0x00000400u /* the next frame waits until the newest is shown */
#define SPHAERA_STATUS_BUILDING_LSB 11u
#define SPHAERA_STATUS_BUILDING 0x00000800u /* a tree is built, or waits for the frame that reads its place */
#define SPHAERA_STATUS_TREE_VALID_LSB 12u
#define SPHAERA_STATUS_TREE_VALID 0x00001000u /* a tree is complete */
#define SPHAERA_STATUS_TREE_LSB 13u
#define SPHAERA_STATUS_TREE 0x00002000u /* in which place the newest complete one is */
#define SPHAERA_FRAME_COUNT 0x028u /* ro: frames complete */
#define SPHAERA_FRAME_COUNT_RESET 0x00000000u
#define SPHAERA_ERRORS 0x02cu /* w1c: sticky errors, those of the core first */
#define SPHAERA_ERRORS_RESET 0x00000000u
#define SPHAERA_ERRORS_BAD_NODE_LSB 0u
#define SPHAERA_ERRORS_BAD_NODE 0x00000001u /* an address outside memory; a node, leaf line or texture that is malformed */
#define SPHAERA_ERRORS_STACK_OVERFLOW_LSB 1u
#define SPHAERA_ERRORS_STACK_OVERFLOW 0x00000002u /* a tree deeper than the stack */
#define SPHAERA_ERRORS_VISIT_LIMIT_LSB 2u
#define SPHAERA_ERRORS_VISIT_LIMIT 0x00000004u /* a ray visited VISIT_LIMIT nodes: a cycle in the tree */
#define SPHAERA_ERRORS_BUS_ERROR_LSB 3u
#define SPHAERA_ERRORS_BUS_ERROR 0x00000008u /* memory answered with an error */
#define SPHAERA_ERRORS_MISSING_EFFECT_LSB 4u
#define SPHAERA_ERRORS_MISSING_EFFECT 0x00000010u /* EFFECTS, TREE or MEM_LINES asks for what is not there: nothing is rendered */
#define SPHAERA_ERRORS_WRONG_PROFILE_LSB 5u
#define SPHAERA_ERRORS_WRONG_PROFILE 0x00000020u /* the machine has other widths: nothing is rendered */
#define SPHAERA_ERRORS_LEFT_OUT_LSB 6u
#define SPHAERA_ERRORS_LEFT_OUT 0x00000040u /* the camera is not the one that something is left out for: nothing is rendered */
#define SPHAERA_ERRORS_SCENE_SLVERR_LSB 8u
#define SPHAERA_ERRORS_SCENE_SLVERR 0x00000100u /* memory answered a read of the scene with SLVERR */
#define SPHAERA_ERRORS_SCENE_DECERR_LSB 9u
#define SPHAERA_ERRORS_SCENE_DECERR 0x00000200u /* memory answered a read of the scene with DECERR */
#define SPHAERA_ERRORS_FRAME_SLVERR_LSB 10u
#define SPHAERA_ERRORS_FRAME_SLVERR 0x00000400u /* a write to the frame store was answered with SLVERR */
#define SPHAERA_ERRORS_FRAME_DECERR_LSB 11u
#define SPHAERA_ERRORS_FRAME_DECERR 0x00000800u /* a write to the frame store was answered with DECERR */
#define SPHAERA_ERRORS_SCAN_ERROR_LSB 12u
#define SPHAERA_ERRORS_SCAN_ERROR 0x00001000u /* a read of the frame that is shown was answered with an error */
#define SPHAERA_ERRORS_WATCHDOG_LSB 13u
#define SPHAERA_ERRORS_WATCHDOG 0x00002000u /* a bus of scene or frame store did nothing for WATCHDOG clocks */
#define SPHAERA_ERRORS_REFUSED_LSB 14u
#define SPHAERA_ERRORS_REFUSED 0x00004000u /* START came while a frame was drawn or drained, and did nothing */
#define SPHAERA_ERRORS_SCAN_WATCHDOG_LSB 15u
#define SPHAERA_ERRORS_SCAN_WATCHDOG 0x00008000u /* the bus of the display did nothing for WATCHDOG clocks */
#define SPHAERA_ERRORS_BUILD_MANY_LSB 16u
#define SPHAERA_ERRORS_BUILD_MANY 0x00010000u /* more spheres than BUILD, no tree was built */
#define SPHAERA_ERRORS_BUILD_ROOM_LSB 17u
#define SPHAERA_ERRORS_BUILD_ROOM 0x00020000u /* fewer lines than two a sphere, no tree was built */
#define SPHAERA_ERRORS_BUILD_RECORD_LSB 18u
#define SPHAERA_ERRORS_BUILD_RECORD 0x00040000u /* a record is no sphere of the profile, no tree was built */
#define SPHAERA_ERRORS_BUILD_BUS_LSB 19u
#define SPHAERA_ERRORS_BUILD_BUS 0x00080000u /* a bus of the builder had an error, or did nothing for WATCHDOG clocks */
#define SPHAERA_ERRORS_BUILD_ORDER_LSB 20u
#define SPHAERA_ERRORS_BUILD_ORDER 0x00100000u /* no order, or a refit of other spheres than were built last */
#define SPHAERA_ERRORS_BUILD_REFUSED_LSB 21u
#define SPHAERA_ERRORS_BUILD_REFUSED 0x00200000u /* BUILD came while a tree was built or drained, and did nothing */
#define SPHAERA_INTERRUPTS 0x030u /* w1c: what happened */
#define SPHAERA_INTERRUPTS_RESET 0x00000000u
#define SPHAERA_INTERRUPTS_FRAME_DONE_LSB 0u
#define SPHAERA_INTERRUPTS_FRAME_DONE 0x00000001u /* a frame ended, complete or not */
#define SPHAERA_INTERRUPTS_SWAP_LSB 1u
#define SPHAERA_INTERRUPTS_SWAP 0x00000002u /* another frame is shown */
#define SPHAERA_INTERRUPTS_UNDERRUN_LSB 2u
#define SPHAERA_INTERRUPTS_UNDERRUN 0x00000004u /* video had no pixel when it needed one */
#define SPHAERA_INTERRUPTS_ERROR_LSB 3u
#define SPHAERA_INTERRUPTS_ERROR 0x00000008u /* a bit of ERRORS was set */
#define SPHAERA_INTERRUPTS_BUILD_DONE_LSB 4u
#define SPHAERA_INTERRUPTS_BUILD_DONE 0x00000010u /* a tree was built, or not because of an error */
#define SPHAERA_INTERRUPT_ENABLE 0x034u /* rw: which of them drive the interrupt line */
#define SPHAERA_INTERRUPT_ENABLE_RESET 0x00000000u
#define SPHAERA_INTERRUPT_ENABLE_SOURCES_LSB 0u
#define SPHAERA_INTERRUPT_ENABLE_SOURCES 0x0000001fu /* the bits of INTERRUPTS */
#define SPHAERA_WATCHDOG 0x038u /* rw: clocks that a bus may owe an answer, 0: any number */
#define SPHAERA_WATCHDOG_RESET 0x00100000u
#define SPHAERA_SCENE_BASE 0x040u /* rw: address of line 0 of the machine, a multiple of 4096 */
#define SPHAERA_SCENE_BASE_RESET 0x00000000u
#define SPHAERA_SCENE_BASE_PAGE_LSB 12u
#define SPHAERA_SCENE_BASE_PAGE 0xfffff000u /* the bits below are 0 */
#define SPHAERA_FRAME0 0x044u /* rw: address of frame 0, a multiple of 64 */
#define SPHAERA_FRAME0_RESET 0x00000000u
#define SPHAERA_FRAME0_PLACE_LSB 6u
#define SPHAERA_FRAME0_PLACE 0xffffffc0u /* the bits below are 0 */
#define SPHAERA_FRAME1 0x048u /* rw: of frame 1 */
#define SPHAERA_FRAME1_RESET 0x00000000u
#define SPHAERA_FRAME1_PLACE_LSB 6u
#define SPHAERA_FRAME1_PLACE 0xffffffc0u /* the bits below are 0 */
#define SPHAERA_FRAME2 0x04cu /* rw: of frame 2 */
#define SPHAERA_FRAME2_RESET 0x00000000u
#define SPHAERA_FRAME2_PLACE_LSB 6u
#define SPHAERA_FRAME2_PLACE 0xffffffc0u /* the bits below are 0 */
#define SPHAERA_STRIDE 0x050u /* rw: bytes from a row of a frame to the next */
#define SPHAERA_STRIDE_RESET 0x00000a00u
#define SPHAERA_STRIDE_UNITS_LSB 5u
#define SPHAERA_STRIDE_UNITS 0x0000ffe0u /* of 32 bytes, the bits below are 0 */
#define SPHAERA_FORMAT 0x054u /* rw: how a pixel is stored */
#define SPHAERA_FORMAT_RESET 0x00000000u
#define SPHAERA_FORMAT_RGB565_LSB 0u
#define SPHAERA_FORMAT_RGB565 0x00000001u /* 0: XRGB8888, 1: RGB565; blue in the low bits */
#define SPHAERA_MUX 0x058u /* rw: colours stored from the next START on, or layer shown */
#define SPHAERA_MUX_RESET 0x00000000u
#define SPHAERA_MUX_FRAME_LSB 0u
#define SPHAERA_MUX_FRAME 0x00000003u /* 0: as register FRAME of the machine has it, 1 Rendering, 2 L1, 3 L2 */
#define SPHAERA_FRAME_MODE 0x05cu /* rw: of the frame store */
#define SPHAERA_FRAME_MODE_RESET 0x00000000u
#define SPHAERA_FRAME_MODE_WAIT_LSB 0u
#define SPHAERA_FRAME_MODE_WAIT 0x00000001u /* a frame is not begun before the newest one is shown */
#define SPHAERA_VIDEO 0x060u /* rw: the display */
#define SPHAERA_VIDEO_RESET 0x00000000u
#define SPHAERA_VIDEO_ENABLE_LSB 0u
#define SPHAERA_VIDEO_ENABLE 0x00000001u /* video runs; its mode must not change then */
#define SPHAERA_VIDEO_DOUBLE_LSB 1u
#define SPHAERA_VIDEO_DOUBLE 0x00000002u /* a pixel of the store is shown as two by two */
#define SPHAERA_VIDEO_H_POL_LSB 2u
#define SPHAERA_VIDEO_H_POL 0x00000004u /* hsync is high in its pulse */
#define SPHAERA_VIDEO_V_POL_LSB 3u
#define SPHAERA_VIDEO_V_POL 0x00000008u /* vsync is high in its pulse */
#define SPHAERA_VIDEO_H_ACTIVE 0x064u /* rw: pixels of a row */
#define SPHAERA_VIDEO_H_ACTIVE_RESET 0x00100280u
#define SPHAERA_VIDEO_H_ACTIVE_ACTIVE_LSB 0u
#define SPHAERA_VIDEO_H_ACTIVE_ACTIVE 0x00001fffu /* that are shown */
#define SPHAERA_VIDEO_H_ACTIVE_FRONT_LSB 16u
#define SPHAERA_VIDEO_H_ACTIVE_FRONT 0x1fff0000u /* from the last one to the pulse */
#define SPHAERA_VIDEO_H_SYNC 0x068u /* rw: pixels of the pulse */
#define SPHAERA_VIDEO_H_SYNC_RESET 0x00300060u
#define SPHAERA_VIDEO_H_SYNC_SYNC_LSB 0u
#define SPHAERA_VIDEO_H_SYNC_SYNC 0x00001fffu /* the pulse */
#define SPHAERA_VIDEO_H_SYNC_BACK_LSB 16u
#define SPHAERA_VIDEO_H_SYNC_BACK 0x1fff0000u /* from it to the first pixel */
#define SPHAERA_VIDEO_V_ACTIVE 0x06cu /* rw: rows */
#define SPHAERA_VIDEO_V_ACTIVE_RESET 0x000a01e0u
#define SPHAERA_VIDEO_V_ACTIVE_ACTIVE_LSB 0u
#define SPHAERA_VIDEO_V_ACTIVE_ACTIVE 0x00001fffu /* that are shown */
#define SPHAERA_VIDEO_V_ACTIVE_FRONT_LSB 16u
#define SPHAERA_VIDEO_V_ACTIVE_FRONT 0x1fff0000u /* from the last one to the pulse */
#define SPHAERA_VIDEO_V_SYNC 0x070u /* rw: rows of the pulse */
#define SPHAERA_VIDEO_V_SYNC_RESET 0x00210002u
#define SPHAERA_VIDEO_V_SYNC_SYNC_LSB 0u
#define SPHAERA_VIDEO_V_SYNC_SYNC 0x00001fffu /* the pulse */
#define SPHAERA_VIDEO_V_SYNC_BACK_LSB 16u
#define SPHAERA_VIDEO_V_SYNC_BACK 0x1fff0000u /* from it to the first row */
#define SPHAERA_LAYER_BYTES 0x074u /* rw: with LAYERS, bytes from a layer of a frame to the next */
#define SPHAERA_LAYER_BYTES_RESET 0x00000000u
#define SPHAERA_LAYER_BYTES_UNITS_LSB 6u
#define SPHAERA_LAYER_BYTES_UNITS 0xffffffc0u /* of 64 bytes, the bits below are 0 */
#define SPHAERA_ADDRESS_HIGH 0x078u /* rw: with ADDR above 32, bits 39..32 of the addresses */
#define SPHAERA_ADDRESS_HIGH_RESET 0x00000000u
#define SPHAERA_ADDRESS_HIGH_FRAME0_LSB 0u
#define SPHAERA_ADDRESS_HIGH_FRAME0 0x000000ffu /* of register FRAME0 */
#define SPHAERA_ADDRESS_HIGH_FRAME1_LSB 8u
#define SPHAERA_ADDRESS_HIGH_FRAME1 0x0000ff00u /* of FRAME1 */
#define SPHAERA_ADDRESS_HIGH_FRAME2_LSB 16u
#define SPHAERA_ADDRESS_HIGH_FRAME2 0x00ff0000u /* of FRAME2 */
#define SPHAERA_ADDRESS_HIGH_SCENE_LSB 24u
#define SPHAERA_ADDRESS_HIGH_SCENE 0xff000000u /* of SCENE_BASE */
#define SPHAERA_BUILD_COUNT 0x080u /* rw: spheres of the next BUILD; lines are of SCENE_BASE */
#define SPHAERA_BUILD_COUNT_RESET 0x00000000u
#define SPHAERA_BUILD_COUNT_SPHERES_LSB 0u
#define SPHAERA_BUILD_COUNT_SPHERES 0x00ffffffu /* their number */
#define SPHAERA_BUILD_RECORDS 0x084u /* rw: where their primitive records are */
#define SPHAERA_BUILD_RECORDS_RESET 0x00000000u
#define SPHAERA_BUILD_RECORDS_LINE_LSB 0u
#define SPHAERA_BUILD_RECORDS_LINE 0x03ffffffu /* of the record of sphere 0 */
#define SPHAERA_BUILD_TREE0 0x088u /* rw: the first place of a tree */
#define SPHAERA_BUILD_TREE0_RESET 0x00000000u
#define SPHAERA_BUILD_TREE0_LINE_LSB 0u
#define SPHAERA_BUILD_TREE0_LINE 0x03ffffffu /* of the root, nodes and leaf records follow */
#define SPHAERA_BUILD_TREE1 0x08cu /* rw: the second place */
#define SPHAERA_BUILD_TREE1_RESET 0x00000000u
#define SPHAERA_BUILD_TREE1_LINE_LSB 0u
#define SPHAERA_BUILD_TREE1_LINE 0x03ffffffu /* of the root */
#define SPHAERA_BUILD_LINES 0x090u /* rw: room of each place */
#define SPHAERA_BUILD_LINES_RESET 0x00000000u
#define SPHAERA_BUILD_LINES_LINES_LSB 0u
#define SPHAERA_BUILD_LINES_LINES 0x03ffffffu /* two for each sphere, at least one */
#define SPHAERA_BUILD_MODE 0x094u /* rw: how trees are built and used */
#define SPHAERA_BUILD_MODE_RESET 0x00000000u
#define SPHAERA_BUILD_MODE_ORDER_LSB 0u
#define SPHAERA_BUILD_MODE_ORDER 0x00000003u /* of the spheres: 0 along a curve, 1 the paper's, 2 of the build before */
#define SPHAERA_BUILD_MODE_ROUNDS_LSB 4u
#define SPHAERA_BUILD_MODE_ROUNDS 0x00000030u /* of joining along that curve that follow the first */
#define SPHAERA_BUILD_MODE_ROOT_LSB 8u
#define SPHAERA_BUILD_MODE_ROOT 0x00000100u /* a frame has the newest tree's line in place of register ROOT */
#define SPHAERA_BUILD_CLOCKS 0x098u /* ro: clocks of the last build, without waiting for its place */
#define SPHAERA_BUILD_CLOCKS_RESET 0x00000000u
#define SPHAERA_BUILD_WRITTEN 0x09cu /* ro: lines that the last build wrote */
#define SPHAERA_BUILD_WRITTEN_RESET 0x00000000u

#define SPHAERA_MACHINE 0x200u
#define SPHAERA_MACHINE_REGISTERS 120u
#define SPHAERA_COUNTERS 0x400u
#define SPHAERA_COUNTS 41u

#define SPHAERA_REG_EFFECTS 0u
#define SPHAERA_REG_MAX_DEPTH 1u
#define SPHAERA_REG_N_LIGHTS 2u
#define SPHAERA_REG_FRAME_W 3u
#define SPHAERA_REG_FRAME_H 4u
#define SPHAERA_REG_WIN_X0 5u
#define SPHAERA_REG_WIN_Y0 6u
#define SPHAERA_REG_WIN_X1 7u
#define SPHAERA_REG_WIN_Y1 8u
#define SPHAERA_REG_BG_MODE 9u
#define SPHAERA_REG_RECT_X0 10u
#define SPHAERA_REG_RECT_Y0 11u
#define SPHAERA_REG_RECT_X1 12u
#define SPHAERA_REG_RECT_Y1 13u
#define SPHAERA_REG_BG_COLOUR 14u
#define SPHAERA_REG_AMBIENT_R 15u
#define SPHAERA_REG_AMBIENT_G 16u
#define SPHAERA_REG_AMBIENT_B 17u
#define SPHAERA_REG_EYE_X 18u
#define SPHAERA_REG_EYE_Y 19u
#define SPHAERA_REG_EYE_Z 20u
#define SPHAERA_REG_DIR_X0 21u
#define SPHAERA_REG_DIR_Y0 22u
#define SPHAERA_REG_DIR_Z 23u
#define SPHAERA_REG_PITCH 24u
#define SPHAERA_REG_ROOT 25u
#define SPHAERA_REG_PRIM_BASE 26u
#define SPHAERA_REG_MEM_LINES 27u
#define SPHAERA_REG_N_PRIMS 28u
#define SPHAERA_REG_VISIT_LIMIT 29u
#define SPHAERA_REG_PROFILE 30u
#define SPHAERA_REG_TREE 31u
#define SPHAERA_REG_LIGHT0_X 32u
#define SPHAERA_REG_LIGHT0_Y 33u
#define SPHAERA_REG_LIGHT0_Z 34u
#define SPHAERA_REG_LIGHT0_R 35u
#define SPHAERA_REG_LIGHT0_G 36u
#define SPHAERA_REG_LIGHT0_B 37u
#define SPHAERA_REG_FRAME 96u
#define SPHAERA_REG_BG_BASE 97u
#define SPHAERA_REG_BG_COUNT 98u
#define SPHAERA_REG_FACET_BASE 99u
#define SPHAERA_REG_N_SPHERES 100u
#define SPHAERA_REG_TEX_FILTER 101u
#define SPHAERA_REG_COARSE 102u
#define SPHAERA_REG_SMOOTH_BASE 103u
#define SPHAERA_REG_LEAF_BASE 104u
#define SPHAERA_REG_N_LOOSE 105u
#define SPHAERA_REG_BOX_X0 106u
#define SPHAERA_REG_BOX_Y0 107u
#define SPHAERA_REG_BOX_Z0 108u
#define SPHAERA_REG_BOX_X1 109u
#define SPHAERA_REG_BOX_Y1 110u
#define SPHAERA_REG_BOX_Z1 111u
#define SPHAERA_REG_ACROSS_X 112u
#define SPHAERA_REG_ACROSS_Y 113u
#define SPHAERA_REG_ACROSS_Z 114u
#define SPHAERA_REG_DOWN_X 115u
#define SPHAERA_REG_DOWN_Y 116u
#define SPHAERA_REG_DOWN_Z 117u
#define SPHAERA_REG_LEAST_WEIGHT 118u
#define SPHAERA_REG_ONE_CAMERA 119u

#define SPHAERA_TREE_PAPER 1u
#define SPHAERA_TREE_BALANCED 2u
#define SPHAERA_TREE_REINSERTED 5u
#define SPHAERA_TREE_BIH 3u
#define SPHAERA_TREE_BRUTE 4u
#define SPHAERA_TREE_BOX4 6u
#define SPHAERA_TREE_HW 7u
#define SPHAERA_TREE_LAST 7u

#define SPHAERA_COUNT_RAYS_PRIMARY 0u
#define SPHAERA_COUNT_RAYS_SHADOW 1u
#define SPHAERA_COUNT_RAYS_REFLECTED 2u
#define SPHAERA_COUNT_NODE_VISITS 3u
#define SPHAERA_COUNT_CHILD_TESTS 4u
#define SPHAERA_COUNT_LEAF_TESTS 5u
#define SPHAERA_COUNT_ROOTS 6u
#define SPHAERA_COUNT_QUOTIENTS 7u
#define SPHAERA_COUNT_BACKGROUND 8u
#define SPHAERA_COUNT_SATURATIONS 9u
#define SPHAERA_COUNT_CYCLES 10u
#define SPHAERA_COUNT_ISSUE_WAIT 11u
#define SPHAERA_COUNT_NODE_MISSES 12u
#define SPHAERA_COUNT_LEAF_MISSES 13u
#define SPHAERA_COUNT_RAYS_WAITING 14u
#define SPHAERA_COUNT_POP_BUBBLES 15u
#define SPHAERA_COUNT_FACET_TESTS 16u
#define SPHAERA_COUNT_DIVISIONS 17u
#define SPHAERA_COUNT_TEXELS 18u
#define SPHAERA_COUNT_TEXEL_MISSES 19u
#define SPHAERA_COUNT_RAYS_REFRACTED 20u
#define SPHAERA_COUNT_POWERS 21u
#define SPHAERA_COUNT_READ_BURSTS 32u
#define SPHAERA_COUNT_READ_BEATS 33u
#define SPHAERA_COUNT_WRITE_BURSTS 34u
#define SPHAERA_COUNT_WRITE_BEATS 35u
#define SPHAERA_COUNT_WRITE_PIXELS 36u
#define SPHAERA_COUNT_FRAMES_SHOWN 37u
#define SPHAERA_COUNT_FRAMES_AGAIN 38u
#define SPHAERA_COUNT_FRAMES_LOST 39u
#define SPHAERA_COUNT_UNDERRUNS 40u

/* X(bit of ERRORS, what it says) */
#define SPHAERA_EACH_ERROR(X) \
    X(SPHAERA_ERRORS_BAD_NODE, "an address outside memory; a node, leaf line or texture that is malformed") \
    X(SPHAERA_ERRORS_STACK_OVERFLOW, "a tree deeper than the stack") \
    X(SPHAERA_ERRORS_VISIT_LIMIT, "a ray visited VISIT_LIMIT nodes: a cycle in the tree") \
    X(SPHAERA_ERRORS_BUS_ERROR, "memory answered with an error") \
    X(SPHAERA_ERRORS_MISSING_EFFECT, "EFFECTS, TREE or MEM_LINES asks for what is not there: nothing is rendered") \
    X(SPHAERA_ERRORS_WRONG_PROFILE, "the machine has other widths: nothing is rendered") \
    X(SPHAERA_ERRORS_LEFT_OUT, "the camera is not the one that something is left out for: nothing is rendered") \
    X(SPHAERA_ERRORS_SCENE_SLVERR, "memory answered a read of the scene with SLVERR") \
    X(SPHAERA_ERRORS_SCENE_DECERR, "memory answered a read of the scene with DECERR") \
    X(SPHAERA_ERRORS_FRAME_SLVERR, "a write to the frame store was answered with SLVERR") \
    X(SPHAERA_ERRORS_FRAME_DECERR, "a write to the frame store was answered with DECERR") \
    X(SPHAERA_ERRORS_SCAN_ERROR, "a read of the frame that is shown was answered with an error") \
    X(SPHAERA_ERRORS_WATCHDOG, "a bus of scene or frame store did nothing for WATCHDOG clocks") \
    X(SPHAERA_ERRORS_REFUSED, "START came while a frame was drawn or drained, and did nothing") \
    X(SPHAERA_ERRORS_SCAN_WATCHDOG, "the bus of the display did nothing for WATCHDOG clocks") \
    X(SPHAERA_ERRORS_BUILD_MANY, "more spheres than BUILD, no tree was built") \
    X(SPHAERA_ERRORS_BUILD_ROOM, "fewer lines than two a sphere, no tree was built") \
    X(SPHAERA_ERRORS_BUILD_RECORD, "a record is no sphere of the profile, no tree was built") \
    X(SPHAERA_ERRORS_BUILD_BUS, "a bus of the builder had an error, or did nothing for WATCHDOG clocks") \
    X(SPHAERA_ERRORS_BUILD_ORDER, "no order, or a refit of other spheres than were built last") \
    X(SPHAERA_ERRORS_BUILD_REFUSED, "BUILD came while a tree was built or drained, and did nothing")

#endif
