// rt_bih_ray.v - what a BIH wants to know of a ray: two words for each axis
// SPDX-License-Identifier: Apache-2.0
// A plane v grid units away across axis i is reached at key v * a / |dir_i|. An axis a clock: both
// are shifted up until their top bit is set; a table has the reciprocal of the size, which times a
// is g = a / |dir_i| times 2^shift, or up to 2 less.
//   read | 1 size | 2..4 up | 5 line of the table | 6 slope | 7 reciprocal | 8, 9 product | 10 pace
// A ray every 3 clocks; it starts 13 clocks after it was read. Shadow rays go before others.
// Model: sph_bih_setup() in cmodel/trace/bih.c, sph_ratio() in cmodel/math/arith.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module rt_bih_ray #(
    parameter W     = 16,  // coordinate, bits
    parameter WD    = 17,  // direction component, bits
    parameter SLOTS = 32,  // power of two
    parameter SHADOW = 1   // 1: shadow rays
) (
    input  wire             clk,
    input  wire             rst,
    // from rt_setup: a ray, then its token
    input  wire             new_valid_i,
    input  wire [$clog2(SLOTS)-1:0] new_slot_i,
    input  wire [3*W-1:0]   new_org_i,      // {z, y, x} sW
    input  wire [3*WD-1:0]  new_dir_i,      // {z, y, x} sWD
    input  wire [2*WD-1:0]  new_a_i,        // dir.dir
    input  wire             go_valid_i,     // primary or reflected
    input  wire [$clog2(SLOTS)-1:0] go_slot_i,
    input  wire             go_pixel_i,     // the pixel's visits start at 0
    input  wire             shadow_go_i,    // shadow ray
    input  wire [$clog2(SLOTS)-1:0] shadow_slot_i,
    // to rt_bih: where a ray stands on an axis and which way it goes
    output reg              place_valid_o,
    output reg [$clog2(SLOTS)-1:0] place_slot_o,
    output reg [1:0]        place_axis_o,   // 0 x, 1 y, 2 z
    output reg [W+1:0]      place_o,        // {org sW, back, flat}
    // how fast
    output reg              pace_valid_o,
    output reg [$clog2(SLOTS)-1:0] pace_slot_o,
    output reg [1:0]        pace_axis_o,
    output reg [`RT_BIH_G+6:0] pace_o,      // {open, shift u6, g}
    // token: all six are written
    output wire             start_valid_o,
    input  wire             start_ready_i,
    output wire [$clog2(SLOTS)-1:0] start_slot_o,
    output wire             start_pixel_o
);
    localparam SLOTW = $clog2(SLOTS);
    localparam AW = 64;                      // a on its way up; a size has half as many bits
    localparam DW = AW/2;
    localparam T  = W + WD + 2 > `RT_BIH_T ? W + WD + 2 - `RT_BIH_T : 0;  // bits that keys lose
    localparam V  = W + 2 > `RT_BIH_V ? W + 2 - `RT_BIH_V : 0;            // and distances
    localparam signed [31:0] BIAS = 17 - WD + T - V;

    // ---- queues ----
    wire             q_new_valid, q_shadow_valid, new_in_ready, shadow_in_ready, load;
    wire [SLOTW:0]   q_new;
    wire [SLOTW-1:0] q_shadow;
    rt_fifo #(.WIDTH(SLOTW+1), .DEPTH(SLOTS)) u_new_queue (
        .clk(clk), .rst(rst), .in_valid_i(go_valid_i), .in_ready_o(new_in_ready),
        .in_data_i({go_slot_i, go_pixel_i}),
        .out_valid_o(q_new_valid), .out_ready_i(load && !q_shadow_valid), .out_data_o(q_new)
    );
    generate
        if (SHADOW != 0) begin : g_shadow
            rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_shadow_queue (
                .clk(clk), .rst(rst), .in_valid_i(shadow_go_i), .in_ready_o(shadow_in_ready),
                .in_data_i(shadow_slot_i),
                .out_valid_o(q_shadow_valid), .out_ready_i(load), .out_data_o(q_shadow)
            );
        end else begin : g_no_shadow
            assign {shadow_in_ready, q_shadow_valid, q_shadow} = {(SLOTW+2){1'b0}};
            wire unused = &{1'b0, shadow_go_i, shadow_slot_i};
        end
    endgenerate
    wire [SLOTW-1:0] q_slot  = q_shadow_valid ? q_shadow : q_new[SLOTW:1];

    // ---- the ray at hand ----
    reg              busy_q;                 // its axes are taken, one a clock
    reg [SLOTW-1:0]  slot_q;
    reg              pixel_q;
    reg [1:0]        axis_q;
    wire [3*W-1:0]   org;
    wire [3*WD-1:0]  dir;
    wire [2*WD-1:0]  a;
    assign load = (q_shadow_valid || q_new_valid) && (!busy_q || axis_q[1]);
    rt_slot_ram #(.WIDTH(3*W+5*WD), .SLOTS(SLOTS), .OLD(0)) u_ray (
        .clk(clk), .wr_en_i(new_valid_i), .wr_addr_i(new_slot_i),
        .wr_data_i({new_a_i, new_dir_i, new_org_i}),
        .rd_en_i(load), .rd_addr_i(q_slot), .rd_data_o({a, dir, org})
    );
    always @(posedge clk) begin
        if (load) begin
            busy_q  <= 1'b1;
            slot_q  <= q_slot;
            pixel_q <= !q_shadow_valid && q_new[0];
            axis_q  <= 2'd0;
        end else begin
            if (axis_q[1]) busy_q <= 1'b0;
            axis_q <= axis_q + 2'd1;
        end
        if (rst) busy_q <= 1'b0;
    end

    // ---- stage 1: where it stands on an axis; size of the component, a ----
    wire [WD-1:0]    d    = axis_q[1] ? dir[2*WD +: WD] : axis_q[0] ? dir[WD +: WD] : dir[0 +: WD];
    wire [W-1:0]     o    = axis_q[1] ? org[2*W +: W] : axis_q[0] ? org[W +: W] : org[0 +: W];
    wire             flat = d == {WD{1'b0}}; // then its size is 1
    wire             none = dir == {(3*WD){1'b0}};  // no direction: a is 1
    reg [WD-1:0]     s1_size_q;
    reg [2*WD-1:0]   s1_a_q;
    always @(posedge clk) begin
        place_valid_o <= busy_q;
        place_slot_o  <= slot_q;
        place_axis_o  <= axis_q;
        place_o       <= {o, d[WD-1], flat};
        s1_size_q     <= (d[WD-1] ? ~d + 1'b1 : d) | {{(WD-1){1'b0}}, flat};
        s1_a_q        <= {a[2*WD-1:1], a[0] || none};
        if (rst) place_valid_o <= 1'b0;
    end

    // ---- stages 2 to 4: both up until their top bit is set ----
    reg [AW-1:0]     s2_a_q, s3_a_q;
    reg [20:0]       s4_a_q;
    reg [DW-1:0]     s2_size_q, s3_size_q, s4_size_q;
    reg [1:0]        s2_a_up_q;              // places, the first two bits, then more
    reg [3:0]        s3_a_up_q;
    reg [5:0]        s4_a_up_q;
    reg              s2_size_up_q;
    reg [2:0]        s3_size_up_q;
    reg [4:0]        s4_size_up_q;
    wire [AW-1:0]    s1_a = {s1_a_q, {(AW-2*WD){1'b0}}};
    wire [DW-1:0]    s1_size = {s1_size_q, {(DW-WD){1'b0}}};
    wire             a_32 = s1_a[AW-1 -: 32] == 32'd0, size_16 = s1_size[DW-1 -: 16] == 16'd0;
    wire [AW-1:0]    s2_a = a_32 ? s1_a << 32 : s1_a;
    wire             a_16 = s2_a[AW-1 -: 16] == 16'd0;
    wire             a_8 = s2_a_q[AW-1 -: 8] == 8'd0, size_8 = s2_size_q[DW-1 -: 8] == 8'd0;
    wire [AW-1:0]    s3_a = a_8 ? s2_a_q << 8 : s2_a_q;
    wire [DW-1:0]    s3_size = size_8 ? s2_size_q << 8 : s2_size_q;
    wire             a_4 = s3_a[AW-1 -: 4] == 4'd0, size_4 = s3_size[DW-1 -: 4] == 4'd0;
    wire             a_2 = s3_a_q[AW-1 -: 2] == 2'd0, size_2 = s3_size_q[DW-1 -: 2] == 2'd0;
    wire [AW-1:0]    s4_a = a_2 ? s3_a_q << 2 : s3_a_q;
    wire [DW-1:0]    s4_size = size_2 ? s3_size_q << 2 : s3_size_q;
    wire             a_1 = !s4_a[AW-1], size_1 = !s4_size[DW-1];
    always @(posedge clk) begin
        s2_a_q       <= a_16 ? s2_a << 16 : s2_a;
        s2_a_up_q    <= {a_32, a_16};
        s2_size_q    <= size_16 ? s1_size << 16 : s1_size;
        s2_size_up_q <= size_16;
        s3_a_q       <= a_4 ? s3_a << 4 : s3_a;
        s3_a_up_q    <= {s2_a_up_q, a_8, a_4};
        s3_size_q    <= size_4 ? s3_size << 4 : s3_size;
        s3_size_up_q <= {s2_size_up_q, size_8, size_4};
        s4_a_q       <= a_1 ? s4_a[AW-2 -: 21] : s4_a[AW-1 -: 21];
        s4_a_up_q    <= {s3_a_up_q, a_2, a_1};
        s4_size_q    <= size_1 ? s4_size << 1 : s4_size;
        s4_size_up_q <= {s3_size_up_q, size_2, size_1};
    end

    // ---- stages 5 to 7: the reciprocal ----
    wire [21:0]      s7_y;
    rt_reciprocal u_reciprocal (
        .clk(clk), .top_i(s4_size_q[DW-1 -: 22]), .more_i(|s4_size_q[DW-23:0]), .y_o(s7_y)
    );

    // ---- stages 8 to 10: the product ----
    wire [20:0]      s7_a;
    rt_delay #(.WIDTH(21), .CYCLES(3)) u_a (.clk(clk), .in_i(s4_a_q), .out_o(s7_a));
    reg [38:0]       s8_high_q;              // of the upper 18 bits of the reciprocal
    reg [24:0]       s8_low_q;               // of the others
    reg [17:0]       s9_g_q;
    wire [42:0]      s8_product = {s8_high_q, 4'd0} + {18'd0, s8_low_q};
    reg signed [7:0] s5_shift_q;
    wire signed [7:0] s9_shift;
    rt_delay #(.WIDTH(8), .CYCLES(4)) u_shift (.clk(clk), .in_i(s5_shift_q), .out_o(s9_shift));
    wire             s9_valid, s9_pixel;
    wire [SLOTW-1:0] s9_slot;
    wire [1:0]       s9_axis;
    rt_delay_valid #(.CYCLES(9)) u_valid (.clk(clk), .rst(rst), .in_i(busy_q), .out_o(s9_valid));
    rt_delay #(.WIDTH(SLOTW+3), .CYCLES(9)) u_tag (
        .clk(clk), .in_i({slot_q, pixel_q, axis_q}), .out_o({s9_slot, s9_pixel, s9_axis})
    );
    reg              pace_pixel_q;
    always @(posedge clk) begin
        s5_shift_q   <= BIAS[7:0] + {2'd0, s4_a_up_q} - {3'd0, s4_size_up_q};
        s8_high_q    <= s7_a * s7_y[21:4];
        s8_low_q     <= s7_a * s7_y[3:0];
        s9_g_q       <= s8_product[42:25];
        pace_valid_o <= s9_valid;
        pace_slot_o  <= s9_slot;
        pace_pixel_q <= s9_pixel;
        pace_axis_o  <= s9_axis;
        pace_o       <= {s9_shift[7], s9_shift[7] ? 6'd0 : s9_shift[5:0], s9_g_q};  // below 0: open
        if (rst) pace_valid_o <= 1'b0;
    end

    // ---- token ----
    wire             start_in_ready;
    rt_fifo #(.WIDTH(SLOTW+1), .DEPTH(SLOTS)) u_start_queue (
        .clk(clk), .rst(rst), .in_valid_i(pace_valid_o && pace_axis_o[1]),
        .in_ready_o(start_in_ready),
        .in_data_i({pace_slot_o, pace_pixel_q}),
        .out_valid_o(start_valid_o), .out_ready_i(start_ready_i),
        .out_data_o({start_slot_o, start_pixel_o})
    );
    // for benches: {turned away, taken, clocks of work}
    wire [7:0] work_rays_set_up_for_planes /* verilator public_flat_rd */ =
        {(q_shadow_valid || q_new_valid) && !load, load, 5'd0, busy_q};
    wire unused = &{1'b0, s9_shift[6], s8_product[24:0], new_in_ready,
                    shadow_in_ready, start_in_ready};
endmodule
`default_nettype wire
