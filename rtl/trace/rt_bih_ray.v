// rt_bih_ray.v - what a BIH wants to know of a ray: a word for each axis
// SPDX-License-Identifier: Apache-2.0
// A plane v grid units away across axis i is reached at key v * a / |dir_i|. The top bits of a are
// found, then three dividers make g = a / |dir_i|, times 2^shift, of all axes at once; the words
// are written one after the other and the ray starts. Shadow rays go before others.
//   read 1 | shift a z/2 | divide `RT_BIH_G/STEP + z'/2 + 2 | write 3; about 25 clocks a ray
// Model: sph_bih_setup() in cmodel/trace/bih.c
`default_nettype none
`include "rt_layout.vh"
module rt_bih_ray #(
    parameter W     = 16,  // coordinate, bits
    parameter WD    = 17,  // direction component, bits
    parameter SLOTS = 32,  // power of two
    parameter SLOTW = 5,   // log2 of SLOTS
    parameter SHADOW = 1,  // 1: shadow rays
    parameter STEP  = 2,   // quotient bits a clock
    parameter AW    = W + 9 + `RT_BIH_G  // not to be set: bits of a word
) (
    input  wire             clk,
    input  wire             rst,
    // from rt_setup: a ray, then its token
    input  wire             new_valid_i,
    input  wire [SLOTW-1:0] new_slot_i,
    input  wire [3*W-1:0]   new_org_i,      // {z, y, x} sW
    input  wire [3*WD-1:0]  new_dir_i,      // {z, y, x} sWD
    input  wire [2*WD-1:0]  new_a_i,        // dir.dir
    input  wire             go_valid_i,     // primary or reflected
    input  wire [SLOTW-1:0] go_slot_i,
    input  wire             go_pixel_i,     // the pixel's visits start at 0
    input  wire             shadow_go_i,    // shadow ray
    input  wire [SLOTW-1:0] shadow_slot_i,
    // to rt_bih: the ray's word of an axis
    output reg              axis_valid_o,
    output wire [SLOTW-1:0] axis_slot_o,
    output reg [1:0]        axis_number_o,  // 0 x, 1 y, 2 z
    output wire [AW-1:0]    axis_word_o,    // {org sW, back, flat, open, shift u6, g}
    // token: all three are written
    output wire             start_valid_o,
    input  wire             start_ready_i,
    output wire [SLOTW-1:0] start_slot_o,
    output wire             start_pixel_o
);
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

    // ---- the ray at hand: read, a shifted up, divided, written ----
    localparam [1:0] IDLE = 2'd0, READ = 2'd1, SHIFT = 2'd2, DIVIDE = 2'd3;
    reg [1:0]        state_q;
    reg [SLOTW-1:0]  slot_q;
    reg              pixel_q;
    reg [NW-1:0]     a_q;                    // a, its top bit on its way up
    reg signed [7:0] zeros_q;                // places it was shifted
    reg [1:0]        next_q;                 // axis to write
    wire [3*W-1:0]   org;
    wire [3*WD-1:0]  dir;
    wire [2*WD-1:0]  a;
    wire [2:0]       done, idle, flat;
    wire [3*GW-1:0]  mants;
    wire [23:0]      exps;
    wire             none  = &flat;           // no direction: must not wait for a top bit
    wire             begun = state_q == SHIFT && (a_q[NW-1] || none);
    wire             write = state_q == DIVIDE && done[next_q];
    wire             last  = axis_valid_o && axis_number_o == 2'd2;
    assign load = (q_shadow_valid || q_new_valid) && (state_q == IDLE || last);
    rt_slot_ram #(.WIDTH(3*W+5*WD), .SLOTS(SLOTS), .OLD(0)) u_ray (
        .clk(clk), .wr_en_i(new_valid_i), .wr_addr_i(new_slot_i),
        .wr_data_i({new_a_i, new_dir_i, new_org_i}),
        .rd_en_i(load), .rd_addr_i(q_slot), .rd_data_o({a, dir, org})
    );
    always @(posedge clk) begin
        case (state_q)
            IDLE:    if (load) state_q <= READ;
            READ:    state_q <= SHIFT;
            SHIFT:   if (begun) state_q <= DIVIDE;
            default: if (last) state_q <= load ? READ : IDLE;
        endcase
        if (load) begin
            slot_q  <= q_slot;
            pixel_q <= !q_shadow_valid && q_new[0];
        end
        if (state_q == READ) begin
            a_q     <= {{(NW-2*WD){1'b0}}, a};
            zeros_q <= 8'sd0;
        end else if (!a_q[NW-1]) begin
            a_q     <= a_q[NW-2] ? a_q << 1 : a_q << 2;
            zeros_q <= zeros_q + (a_q[NW-2] ? 8'sd1 : 8'sd2);
        end
        if (write) next_q <= next_q == 2'd2 ? 2'd0 : next_q + 2'd1;
        if (rst) begin
            state_q <= IDLE;
            next_q  <= 2'd0;
        end
    end
    genvar i;
    generate
        for (i = 0; i < 3; i = i + 1) begin : g_axis
            localparam [31:0] N = i;
            wire [WD-1:0] d   = dir[WD*i +: WD];
            wire [WD-1:0] mag = d[WD-1] ? ~d + 1'b1 : d;
            assign flat[i] = d == {WD{1'b0}};
            rt_quotient #(.KW(DW), .AW(WD), .PQ(GW), .STEP(STEP)) u_quotient (
                .clk(clk), .rst(rst), .in_valid_i(begun), .in_ready_o(idle[i]),
                .in_key_i({a_q[NW-1] || none, a_q[NW-2 -: DW-1]}),
                .in_a_i(mag | {{(WD-1){1'b0}}, flat[i]}),
                .out_valid_o(done[i]), .out_ready_i(write && next_q == N[1:0]),
                .out_mant_o(mants[GW*i +: GW]), .out_exp_o(exps[8*i +: 8])
            );
        end
    endgenerate

    // ---- one axis a clock ----
    localparam PW = W + 2 + GW + 8;          // {org, dir < 0, flat, g, exponent} of an axis
    wire [3*PW-1:0]  parts;
    generate
        for (i = 0; i < 3; i = i + 1) begin : g_part
            assign parts[PW*i +: PW] = {org[W*i +: W], dir[WD*i + WD-1], flat[i],
                                        mants[GW*i +: GW], exps[8*i +: 8]};
        end
    endgenerate
    wire [PW-1:0]    part = next_q[1] ? parts[2*PW +: PW] : next_q[0] ? parts[PW +: PW]
                            : parts[0 +: PW];
    wire signed [7:0] shift = $signed(part[7:0]) + zeros_q + BIAS[7:0];  // below 0: no bound
    reg [W-1:0]      org_q;
    reg              back_q, flat_q, open_q;
    reg [5:0]        shift_q;
    reg [GW-1:0]     g_q;
    always @(posedge clk) begin
        axis_valid_o  <= write;
        axis_number_o <= next_q;
        {org_q, back_q, flat_q, g_q} <= part[PW-1:8];
        open_q  <= shift[7];
        shift_q <= shift[7] ? 6'd0 : shift[5:0];
        if (rst) axis_valid_o <= 1'b0;
    end
    assign axis_slot_o = slot_q;
    assign axis_word_o = {org_q, back_q, flat_q, open_q, shift_q, g_q};

    // ---- token ----
    wire             start_in_ready;
    rt_fifo #(.WIDTH(SLOTW+1), .DEPTH(SLOTS)) u_start_queue (
        .clk(clk), .rst(rst), .in_valid_i(last), .in_ready_o(start_in_ready),
        .in_data_i({slot_q, pixel_q}),
        .out_valid_o(start_valid_o), .out_ready_i(start_ready_i),
        .out_data_o({start_slot_o, start_pixel_o})
    );
    wire unused = &{1'b0, idle, shift[6], new_in_ready, shadow_in_ready, start_in_ready};
endmodule
`default_nettype wire
