// rt_bih_ray.v - what a BIH wants to know of a ray: two words for each axis
// SPDX-License-Identifier: Apache-2.0
// A plane v grid units away across axis i is reached at key v * a / |dir_i|. The top bits of a are
// found while origins and signs are written; then three dividers of a bank make g = a / |dir_i|,
// times 2^shift, of all axes at once, their words are written and the ray starts.
//   read 1 | shift a z/2, at least 3 | divide `RT_BIH_G/STEP + z'/2 + 2 | write 3
// A ray leaves every 5 clocks or, if that is more, every 18/BANKS or so. Shadow rays go before
// others.
// Model: sph_bih_setup() in cmodel/trace/bih.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module rt_bih_ray #(
    parameter W     = 16,  // coordinate, bits
    parameter WD    = 17,  // direction component, bits
    parameter SLOTS = 32,  // power of two
    parameter SHADOW = 1,  // 1: shadow rays
    parameter BANKS = 2,   // rays that are divided at once, three dividers each
    parameter STEP  = 2    // quotient bits a clock
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
    localparam GW = `RT_BIH_G;
    localparam DW = WD > `RT_BIH_DIVIDE ? WD : `RT_BIH_DIVIDE;  // bits of a that are divided
    localparam NW = 2*WD > DW ? 2*WD : DW;                      // a, on its way up
    localparam T  = W + WD + 2 > `RT_BIH_T ? W + WD + 2 - `RT_BIH_T : 0;  // bits that keys lose
    localparam V  = W + 2 > `RT_BIH_V ? W + 2 - `RT_BIH_V : 0;            // and distances
    localparam signed [31:0] BIAS = DW - NW + T - V;

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

    // ---- the ray at hand: read, a shifted up, places written ----
    localparam [1:0] IDLE = 2'd0, READ = 2'd1, WORK = 2'd2;
    reg [1:0]        state_q;
    reg [SLOTW-1:0]  slot_q;
    reg              pixel_q;
    reg [NW-1:0]     a_q;                    // a, its top bit on its way up
    reg signed [7:0] zeros_q;                // places it was shifted
    reg [1:0]        place_q;                // axis to write, 3: all are written
    wire [3*W-1:0]   org;
    wire [3*WD-1:0]  dir;
    wire [2*WD-1:0]  a;
    wire [2:0]       flat;
    wire [3*WD-1:0]  mags;
    wire [BANKS-1:0] full;
    wire             none  = &flat;          // no direction: then a is 1, which has a top bit
    wire             begun = state_q == WORK && place_q[1] && a_q[NW-1] && !(&full);
    wire [BANKS-1:0] take  = ~full & (full + 1'b1) & {BANKS{begun}};  // the lowest that is free
    assign load = (q_shadow_valid || q_new_valid) && (state_q == IDLE || begun);
    rt_slot_ram #(.WIDTH(3*W+5*WD), .SLOTS(SLOTS), .OLD(0)) u_ray (
        .clk(clk), .wr_en_i(new_valid_i), .wr_addr_i(new_slot_i),
        .wr_data_i({new_a_i, new_dir_i, new_org_i}),
        .rd_en_i(load), .rd_addr_i(q_slot), .rd_data_o({a, dir, org})
    );
    wire [3*(W+2)-1:0] places;
    genvar i, b;
    generate
        for (i = 0; i < 3; i = i + 1) begin : g_axis
            wire [WD-1:0] d = dir[WD*i +: WD];
            assign flat[i] = d == {WD{1'b0}};
            assign mags[WD*i +: WD] = (d[WD-1] ? ~d + 1'b1 : d) | {{(WD-1){1'b0}}, flat[i]};
            assign places[(W+2)*i +: W+2] = {org[W*i +: W], d[WD-1], flat[i]};
        end
    endgenerate
    always @(posedge clk) begin
        if (load) state_q <= READ;
        else if (state_q == READ) state_q <= WORK;
        else if (begun) state_q <= IDLE;
        if (load) begin
            slot_q  <= q_slot;
            pixel_q <= !q_shadow_valid && q_new[0];
        end
        if (state_q == READ) begin
            a_q     <= {{(NW-2*WD){1'b0}}, a[2*WD-1:1], a[0] || none};
            zeros_q <= 8'sd0;
            place_q <= 2'd0;
        end else begin
            if (!a_q[NW-1]) begin
                a_q     <= a_q[NW-2] ? a_q << 1 : a_q << 2;
                zeros_q <= zeros_q + (a_q[NW-2] ? 8'sd1 : 8'sd2);
            end
            if (place_q != 2'd3) place_q <= place_q + 2'd1;
        end
        place_valid_o <= state_q == WORK && place_q != 2'd3;
        place_slot_o  <= slot_q;
        place_axis_o  <= place_q;
        place_o       <= place_q[1] ? places[2*(W+2) +: W+2]
                         : place_q[0] ? places[W+2 +: W+2] : places[0 +: W+2];
        if (rst) begin
            state_q       <= IDLE;
            place_valid_o <= 1'b0;
        end
    end

    // ---- banks of dividers ----
    localparam PW = GW + 8;                  // {g, exponent} of an axis
    localparam BW = 3*PW + SLOTW + 9;        // {axes, slot, pixel, zeros} of a bank
    wire [BANKS-1:0] ready, last;            // all three are divided; the last is being written
    wire [BANKS*BW-1:0] banks;
    wire [BANKS*3-1:0] give;                 // axes that are being written
    generate
        for (b = 0; b < BANKS; b = b + 1) begin : g_bank
            reg              full_q, b_pixel_q;
            reg [SLOTW-1:0]  b_slot_q;
            reg signed [7:0] b_zeros_q;
            wire [2:0]       done, idle;
            wire [3*PW-1:0]  axes;
            for (i = 0; i < 3; i = i + 1) begin : g_axis
                rt_quotient #(.KW(DW), .AW(WD), .PQ(GW), .STEP(STEP)) u_quotient (
                    .clk(clk), .rst(rst), .in_valid_i(take[b]), .in_ready_o(idle[i]),
                    .in_key_i(a_q[NW-1 -: DW]),
                    .in_a_i(mags[WD*i +: WD]),
                    .out_valid_o(done[i]), .out_ready_i(give[3*b + i]),
                    .out_mant_o(axes[PW*i + 8 +: GW]), .out_exp_o(axes[PW*i +: 8])
                );
            end
            always @(posedge clk) begin
                if (take[b]) begin
                    full_q    <= 1'b1;
                    b_slot_q  <= slot_q;
                    b_pixel_q <= pixel_q;
                    b_zeros_q <= zeros_q;
                end else if (last[b]) begin
                    full_q <= 1'b0;
                end
                if (rst) full_q <= 1'b0;
            end
            assign full[b]  = full_q;
            assign ready[b] = &done;
            assign banks[BW*b +: BW] = {axes, b_slot_q, b_pixel_q, b_zeros_q};
            wire unused = &{1'b0, idle};
        end
    endgenerate

    // ---- one axis a clock of the lowest bank that is ready ----
    reg [1:0]        next_q;                 // axis to write
    reg [BANKS-1:0]  bank_q;                 // one-hot: whose axes are being written
    wire [BANKS-1:0] bank  = next_q == 2'd0 ? ready & (~ready + 1'b1) : bank_q;
    wire             write = |bank;
    reg [BW-1:0]     one;
    integer          n;
    always @* begin
        one = {BW{1'b0}};
        for (n = 0; n < BANKS; n = n + 1)
            if (bank[n]) one = one | banks[BW*n +: BW];
    end
    wire [2:0]       now = {next_q == 2'd2, next_q == 2'd1, next_q == 2'd0};
    generate
        for (b = 0; b < BANKS; b = b + 1) begin : g_give
            assign give[3*b +: 3] = now & {3{bank[b]}};
            assign last[b]        = bank[b] && now[2];
        end
    endgenerate
    wire [PW-1:0]    part  = now[2] ? one[BW-1 -: PW] : now[1] ? one[BW-PW-1 -: PW]
                             : one[BW-2*PW-1 -: PW];
    wire signed [7:0] shift = $signed(part[7:0]) + $signed(one[7:0]) + BIAS[7:0];
    reg              pace_pixel_q;
    always @(posedge clk) begin
        bank_q <= bank;
        if (write) next_q <= now[2] ? 2'd0 : next_q + 2'd1;
        pace_valid_o <= write;
        pace_slot_o  <= one[9 +: SLOTW];
        pace_pixel_q <= one[8];
        pace_axis_o  <= next_q;
        pace_o       <= {shift[7], shift[7] ? 6'd0 : shift[5:0], part[PW-1:8]};  // below 0: open
        if (rst) begin
            next_q       <= 2'd0;
            pace_valid_o <= 1'b0;
        end
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
        {(q_shadow_valid || q_new_valid) && !load, load, 5'd0, state_q != IDLE};
    wire unused = &{1'b0, shift[6], new_in_ready, shadow_in_ready, start_in_ready};
endmodule
`default_nettype wire
