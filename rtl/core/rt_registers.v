// rt_registers.v - configuration registers of the core
// SPDX-License-Identifier: Apache-2.0
// Written one at a time while the core is idle; numbers and formats: machine.def.
// Lights stand LIGHT_STRIDE registers apart and are kept by rt_lights.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_bundles.vh"
module rt_registers #(
    parameter W  = 16,  // coordinate, bits
    parameter WD = 17,  // direction component, bits
    parameter TEXTURE = 0, // 1: the register of textures
    parameter SMOOTH = 0,  // 1: that of interpolated normals
    parameter ACCEL = 0,   // 1: those of a BIH
    parameter TURNED = 0,  // 1: those of a grid in any axes
    parameter CAMERA = 0   // 1: that of the only camera
) (
    input  wire              clk,
    input  wire              valid_i,
    input  wire [6:0]        addr_i,
    input  wire [31:0]       data_i,
    output reg  [31:0]       effects_o,
    output wire [`RT_REGS_BITS-1:0] regs_o,   // those that an engine looks at
    //: {BOX[6*(W+2)], N_LOOSE[24], LEAF_BASE[26], N_PRIMS[24], VISIT_LIMIT[24], MEM_LINES[26],
    //: SMOOTH_BASE[26], PRIM_BASE[26], ROOT[26], EYE[3*W], AMBIENT[48], BACKGROUND[24],
    //: N_LIGHTS[4], LEAST[9], MAX_DEPTH[4], TEX_FILTER[2], EFFECTS[EFFECT_BITS]}
    output reg  [55:0]       window_o,        // {y1, x1, y0, x0}
    output reg  [1:0]        bg_mode_o,
    output reg  [55:0]       rect_o,          // {y1, x1, y0, x0}
    output reg  [`RT_LINE_BITS-1:0] bg_base_o,
    output reg  [4:0]        bg_count_o,
    output reg  [3*WD-1:0]   dir_o,           // {z, y of row 0, x of column 0}
    output reg  [WD-1:0]     pitch_o,
    output wire [95:0]       first_o,         // with TURNED: {z, y, x}, each sWD.(32-WD)
    output wire [95:0]       across_o,        // of a pixel to the right
    output wire [95:0]       down_o,          // of a row down
    output reg  [31:0]       profile_o,
    output reg  [1:0]        frame_o,
    output wire [3:0]        coarse_o,
    output reg               bih_o,           // TREE is a BIH
    output reg               boxes_o,         // TREE has boxes around children
    output wire              strayed_o,       // the camera is not the one that ONE_CAMERA has
    // lights live in the engines: one write goes by
    output wire              light_valid_o,
    output wire [2:0]        light_number_o,
    output wire [2:0]        light_part_o
);
    wire [6:0] offset = addr_i - `RT_REG_LIGHT0_X;
    assign light_valid_o  = valid_i && addr_i >= `RT_REG_LIGHT0_X && !offset[6];
    assign light_number_o = offset[5:3];
    assign light_part_o   = offset[2:0];
    // registers of bundle regs: made by make layout
    reg  [`RT_EFFECT_BITS-1:0] effects_q;
    reg  [1:0] tex_filter_q;
    reg  [3:0] max_depth_q;
    reg  [8:0] least_q;
    reg  [3:0] n_lights_q;
    reg  [`RT_RGB_BITS-1:0] background_q;
    reg  [47:0] ambient_q;
    reg  [3*W-1:0] eye_q;
    reg  [`RT_LINE_BITS-1:0] root_q;
    reg  [`RT_LINE_BITS-1:0] prim_base_q;
    reg  [`RT_LINE_BITS-1:0] smooth_base_q;
    reg  [`RT_LINE_BITS-1:0] mem_lines_q;
    reg  [`RT_VISITS_BITS-1:0] visit_limit_q;
    reg  [`RT_ID_BITS-1:0] n_prims_q;
    reg  [`RT_LINE_BITS-1:0] leaf_base_q;
    reg  [`RT_ID_BITS-1:0] n_loose_q;
    reg  [6*(W+2)-1:0] box_q;
    always @(posedge clk)
        if (valid_i) begin
            if (addr_i == `RT_REG_EFFECTS) effects_q <= data_i[`RT_EFFECT_BITS-1:0];
            if (addr_i == `RT_REG_TEX_FILTER) tex_filter_q <= data_i[1:0];
            if (addr_i == `RT_REG_MAX_DEPTH) max_depth_q <= data_i[3:0];
            if (addr_i == `RT_REG_LEAST_WEIGHT) least_q <= data_i[8:0];
            if (addr_i == `RT_REG_N_LIGHTS) n_lights_q <= data_i[3:0];
            if (addr_i == `RT_REG_BG_COLOUR) background_q <= data_i[`RT_RGB_BITS-1:0];
            if (addr_i == `RT_REG_AMBIENT_R) ambient_q[0*16 +: 16] <= data_i[15:0];
            if (addr_i == `RT_REG_AMBIENT_R + 7'd1) ambient_q[1*16 +: 16] <= data_i[15:0];
            if (addr_i == `RT_REG_AMBIENT_R + 7'd2) ambient_q[2*16 +: 16] <= data_i[15:0];
            if (addr_i == `RT_REG_EYE_X) eye_q[0*W +: W] <= data_i[W-1:0];
            if (addr_i == `RT_REG_EYE_X + 7'd1) eye_q[1*W +: W] <= data_i[W-1:0];
            if (addr_i == `RT_REG_EYE_X + 7'd2) eye_q[2*W +: W] <= data_i[W-1:0];
            if (addr_i == `RT_REG_ROOT) root_q <= data_i[`RT_LINE_BITS-1:0];
            if (addr_i == `RT_REG_PRIM_BASE) prim_base_q <= data_i[`RT_LINE_BITS-1:0];
            if (addr_i == `RT_REG_SMOOTH_BASE) smooth_base_q <= data_i[`RT_LINE_BITS-1:0];
            if (addr_i == `RT_REG_MEM_LINES) mem_lines_q <= data_i[`RT_LINE_BITS-1:0];
            if (addr_i == `RT_REG_VISIT_LIMIT) visit_limit_q <= data_i[`RT_VISITS_BITS-1:0];
            if (addr_i == `RT_REG_N_PRIMS) n_prims_q <= data_i[`RT_ID_BITS-1:0];
            if (addr_i == `RT_REG_LEAF_BASE) leaf_base_q <= data_i[`RT_LINE_BITS-1:0];
            if (addr_i == `RT_REG_N_LOOSE) n_loose_q <= data_i[`RT_ID_BITS-1:0];
            if (addr_i == `RT_REG_BOX_X0) box_q[0*(W+2) +: (W+2)] <= data_i[(W+2)-1:0];
            if (addr_i == `RT_REG_BOX_X0 + 7'd1) box_q[1*(W+2) +: (W+2)] <= data_i[(W+2)-1:0];
            if (addr_i == `RT_REG_BOX_X0 + 7'd2) box_q[2*(W+2) +: (W+2)] <= data_i[(W+2)-1:0];
            if (addr_i == `RT_REG_BOX_X0 + 7'd3) box_q[3*(W+2) +: (W+2)] <= data_i[(W+2)-1:0];
            if (addr_i == `RT_REG_BOX_X0 + 7'd4) box_q[4*(W+2) +: (W+2)] <= data_i[(W+2)-1:0];
            if (addr_i == `RT_REG_BOX_X0 + 7'd5) box_q[5*(W+2) +: (W+2)] <= data_i[(W+2)-1:0];
        end
    assign regs_o[`RT_REGS_EFFECTS] = effects_q;
    assign regs_o[`RT_REGS_TEX_FILTER] = TEXTURE != 0 ? tex_filter_q : {2{1'b0}};
    assign regs_o[`RT_REGS_MAX_DEPTH] = max_depth_q;
    assign regs_o[`RT_REGS_LEAST] = least_q;
    assign regs_o[`RT_REGS_N_LIGHTS] = n_lights_q;
    assign regs_o[`RT_REGS_BACKGROUND] = background_q;
    assign regs_o[`RT_REGS_AMBIENT] = ambient_q;
    assign regs_o[`RT_REGS_EYE] = eye_q;
    assign regs_o[`RT_REGS_ROOT] = root_q;
    assign regs_o[`RT_REGS_PRIM_BASE] = prim_base_q;
    assign regs_o[`RT_REGS_SMOOTH_BASE] = SMOOTH != 0 ? smooth_base_q : {`RT_LINE_BITS{1'b0}};
    assign regs_o[`RT_REGS_MEM_LINES] = mem_lines_q;
    assign regs_o[`RT_REGS_VISIT_LIMIT] = visit_limit_q;
    assign regs_o[`RT_REGS_N_PRIMS] = ACCEL != 0 ? n_prims_q : {`RT_ID_BITS{1'b0}};
    assign regs_o[`RT_REGS_LEAF_BASE] = ACCEL != 0 ? leaf_base_q : {`RT_LINE_BITS{1'b0}};
    assign regs_o[`RT_REGS_N_LOOSE] = ACCEL != 0 ? n_loose_q : {`RT_ID_BITS{1'b0}};
    assign regs_o[`RT_REGS_BOX] = ACCEL != 0 ? box_q : {6*(W+2){1'b0}};
    // end of those
    always @(posedge clk)
        if (valid_i)
            case (addr_i)
                `RT_REG_EFFECTS:     effects_o       <= data_i;
                `RT_REG_WIN_X0:      window_o[13:0]  <= data_i[13:0];
                `RT_REG_WIN_Y0:      window_o[27:14] <= data_i[13:0];
                `RT_REG_WIN_X1:      window_o[41:28] <= data_i[13:0];
                `RT_REG_WIN_Y1:      window_o[55:42] <= data_i[13:0];
                `RT_REG_BG_MODE:     bg_mode_o       <= data_i[1:0];
                `RT_REG_RECT_X0:     rect_o[13:0]    <= data_i[13:0];
                `RT_REG_RECT_Y0:     rect_o[27:14]   <= data_i[13:0];
                `RT_REG_RECT_X1:     rect_o[41:28]   <= data_i[13:0];
                `RT_REG_RECT_Y1:     rect_o[55:42]   <= data_i[13:0];
                `RT_REG_DIR_X0:      dir_o[0 +: WD]   <= data_i[WD-1:0];
                `RT_REG_DIR_Y0:      dir_o[WD +: WD]  <= data_i[WD-1:0];
                `RT_REG_DIR_Z:       dir_o[2*WD +: WD] <= data_i[WD-1:0];
                `RT_REG_PITCH:       pitch_o         <= data_i[WD-1:0];
                `RT_REG_PROFILE:     profile_o       <= data_i;
                `RT_REG_FRAME:       frame_o         <= data_i[1:0];
                `RT_REG_TREE: begin
                    bih_o   <= data_i[2:0] == 3'd`RT_TREE_BIH || data_i[2:0] == 3'd`RT_TREE_BRUTE;
                    boxes_o <= data_i[2:0] == 3'd`RT_TREE_BOX4;
                end
                `RT_REG_BG_BASE:     bg_base_o       <= data_i[`RT_LINE_BITS-1:0];
                `RT_REG_BG_COUNT:    bg_count_o      <= data_i[4:0];
                default: ;
            endcase
    // the camera in words without sign: {down, across, pitch, dir, eye}
    wire [319:0] raster;
    wire [95:0]  first, eye;
    genvar c;
    generate
        for (c = 0; c < 3; c = c + 1) begin : g_word
            assign first[32*c +: 32] = {{32-WD{1'b0}}, dir_o[WD*c +: WD]};
            assign eye[32*c +: 32]   = {{32-W{1'b0}}, eye_q[W*c +: W]};
        end
        if (TEXTURE != 0) begin : g_texture
            reg [3:0] coarse_q;
            always @(posedge clk)
                if (valid_i && addr_i == `RT_REG_COARSE) coarse_q <= data_i[3:0];
            assign coarse_o = coarse_q;
        end else begin : g_no_texture
            assign coarse_o = 4'd0;
        end
        if (TURNED != 0) begin : g_turned
            localparam F = 32 - WD;                // bits of fraction; the camera's axes have none
            reg [95:0]  first_q;
            reg [191:0] step_q;                    // {down, across}
            wire [6:0]  axis   = addr_i - `RT_REG_DIR_X0;
            wire [6:0]  step   = addr_i - `RT_REG_ACROSS_X;
            wire        turned = effects_o[`RT_EFFECT_TURNED];
            wire [31:0] pitch  = {pitch_o, {F{1'b0}}};
            integer     k;
            genvar      g;
            always @(posedge clk)
                if (valid_i) begin
                    for (k = 0; k < 3; k = k + 1)
                        if (axis == k[6:0]) first_q[32*k +: 32] <= data_i;
                    for (k = 0; k < 6; k = k + 1)
                        if (step == k[6:0]) step_q[32*k +: 32] <= data_i;
                end
            for (g = 0; g < 3; g = g + 1) begin : g_axis
                assign first_o[32*g +: 32] =
                    turned ? first_q[32*g +: 32] : {first_q[32*g +: WD], {F{1'b0}}};
            end
            assign across_o = turned ? step_q[95:0]   : {64'd0, pitch};
            assign down_o   = turned ? step_q[191:96] : {32'd0, -pitch, 32'd0};
            assign raster = {step_q, {32-WD{1'b0}}, pitch_o, turned ? first_q : first};
        end else begin : g_camera
            assign {first_o, across_o, down_o} = 288'd0;
            assign raster = {192'd0, {32-WD{1'b0}}, pitch_o, first};
        end
        if (CAMERA != 0) begin : g_one_camera
            reg  [31:0]  own_q, sum;
            wire [415:0] seen = {raster, eye};
            integer      r;
            always @(posedge clk)
                if (valid_i && addr_i == `RT_REG_ONE_CAMERA) own_q <= data_i;
            always @* begin
                sum = 32'd0;
                for (r = 0; r < 13; r = r + 1)
                    sum = {sum[31-`RT_CAMERA_TURN:0], sum[31:32-`RT_CAMERA_TURN]} ^
                          seen[32*r +: 32];
            end
            assign strayed_o = effects_o[`RT_EFFECT_CAMERA] && sum != own_q;
        end else begin : g_any_camera
            assign strayed_o = 1'b0;
            wire unused = &{1'b0, raster, eye};
        end
    endgenerate
endmodule
`default_nettype wire
