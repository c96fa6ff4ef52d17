// rt_collect.v - gathers the leaf results of a visit and keeps each ray's first hit
// SPDX-License-Identifier: Apache-2.0
// A smaller key wins, a tie goes to the smaller id, so the order of arrival does not matter.
// The best key gives a depth beyond which nothing can win: depth = key * scale >> shift, rounded up.
// One result a cycle; the token leaves 4 cycles after the last result of its visit.
// Model: leaf_visit() in cmodel/trace/traverse.c, sph_ray_depth() in cmodel/trace/setup.c
`default_nettype none
module rt_collect #(
    parameter W     = 16,  // coordinate, bits
    parameter WD    = 17,  // direction component, bits
    parameter FW    = 14,  // filter coordinate, bits
    parameter SLOTS = 32,  // power of two
    parameter SLOTW = 5    // log2 of SLOTS
) (
    input  wire              clk,
    input  wire              rst,
    // from rt_traverse: how many results the visit of a slot will have
    input  wire              want_valid_i,
    input  wire [SLOTW-1:0]  want_slot_i,
    input  wire [2:0]        want_count_i,
    // from rt_setup: a new ray in a slot
    input  wire              new_valid_i,
    input  wire [SLOTW-1:0]  new_slot_i,
    input  wire [16:0]       new_scale_i,   // u1.15
    input  wire [5:0]        new_shift_i,   // 63: depth cannot be bounded
    input  wire              new_shadow_i,
    input  wire [FW:0]       new_depth_i,   // depth limit at the start
    // from rt_leaf by way of rt_root_pool: one result
    input  wire              in_valid_i,
    input  wire [SLOTW-1:0]  in_slot_i,
    input  wire              in_hit_i,
    input  wire              in_far_i,
    input  wire [23:0]       in_id_i,
    input  wire [W+WD+1:0]   in_key_i,
    // to rt_next: the visit is complete
    output wire              out_valid_o,
    output wire [SLOTW-1:0]  out_slot_o,
    // state of a slot, asynchronous reads
    input  wire [SLOTW-1:0]  filter_slot_i,
    output wire [FW:0]       filter_depth_o, // what lies deeper does not matter
    input  wire [SLOTW-1:0]  next_slot_i,
    output wire [FW:0]       next_depth_o,
    output wire              next_found_o,   // the ray has a hit
    output wire              next_shadow_o,
    input  wire [SLOTW-1:0]  done_slot_i,
    output wire              done_found_o,
    output wire              done_shadow_o,
    output wire              done_far_o,
    output wire [23:0]       done_id_o,
    output wire [W+WD+1:0]   done_key_o
);
    localparam KW   = W + WD + 2;            // key
    localparam BW   = KW + 25;               // {far, id, key}
    localparam LIM  = {(FW+1){1'b1}};        // largest depth

    // ---- per slot: is it a shadow ray, has it a hit, how many results were seen ----
    reg [SLOTS-1:0] found_q, shadow_q;
    reg [2:0]       seen_q [0:SLOTS-1];
    wire [2:0]      want;
    rt_slot_file #(.WIDTH(3), .SLOTS(SLOTS)) u_want (
        .clk(clk), .wr_en_i(want_valid_i), .wr_addr_i(want_slot_i), .wr_data_i(want_count_i),
        .rd_addr_i(in_slot_i), .rd_data_o(want)
    );
    wire [16:0] scale;
    wire [5:0]  shift;
    rt_slot_file #(.WIDTH(23), .SLOTS(SLOTS)) u_scale (
        .clk(clk), .wr_en_i(new_valid_i), .wr_addr_i(new_slot_i),
        .wr_data_i({new_shift_i, new_scale_i}),
        .rd_addr_i(in_slot_i), .rd_data_o({shift, scale})
    );

    // ---- stage 0: compare with the best so far ----
    wire [BW-1:0] best, done_best;
    wire [BW-1:0] cand = {in_far_i, in_id_i, in_key_i};
    wire closer = in_key_i < best[KW-1:0] ||
                  (in_key_i == best[KW-1:0] && in_id_i < best[KW +: 24]);
    wire win  = in_valid_i && in_hit_i && (!found_q[in_slot_i] || closer);
    wire last = seen_q[in_slot_i] + 3'd1 == want;
    rt_slot_file #(.WIDTH(BW), .SLOTS(SLOTS)) u_best (
        .clk(clk), .wr_en_i(win && !shadow_q[in_slot_i]), .wr_addr_i(in_slot_i), .wr_data_i(cand),
        .rd_addr_i(in_slot_i), .rd_data_o(best)
    );
    rt_slot_file #(.WIDTH(BW), .SLOTS(SLOTS)) u_done (
        .clk(clk), .wr_en_i(win && !shadow_q[in_slot_i]), .wr_addr_i(in_slot_i), .wr_data_i(cand),
        .rd_addr_i(done_slot_i), .rd_data_o(done_best)
    );
    wire unused = &{1'b0, best[BW-1]};
    integer i;
    always @(posedge clk) begin
        if (in_valid_i) seen_q[in_slot_i] <= last ? 3'd0 : seen_q[in_slot_i] + 3'd1;
        if (win) found_q[in_slot_i] <= 1'b1;
        if (new_valid_i) begin
            found_q[new_slot_i]  <= 1'b0;
            shadow_q[new_slot_i] <= new_shadow_i;
        end
        if (rst) for (i = 0; i < SLOTS; i = i + 1) seen_q[i] <= 3'd0;
    end

    // ---- stages 1 to 3: depth of the new best ----
    reg             s1_win_q, s2_win_q, s3_win_q, s1_last_q, s2_last_q, s3_last_q, s4_last_q;
    reg [SLOTW-1:0] s1_slot_q, s2_slot_q, s3_slot_q, s4_slot_q;
    reg [16:0]      s1_top_q, s1_scale_q;    // u17 top of the key, rounded up; u1.15
    reg [5:0]       s1_shift_q, s2_shift_q;
    reg [33:0]      s2_prod_q;
    reg [FW:0]      s3_depth_q;
    wire [33:0]     s2_depth = s2_prod_q >> s2_shift_q;
    always @(posedge clk) begin
        s1_win_q   <= win && !shadow_q[in_slot_i];
        s1_last_q  <= in_valid_i && last;
        s1_slot_q  <= in_slot_i;
        s1_top_q   <= in_key_i[KW-1 -: 17] + 17'd1;
        s1_scale_q <= scale;
        s1_shift_q <= shift;
        s2_win_q   <= s1_win_q;
        s2_last_q  <= s1_last_q;
        s2_slot_q  <= s1_slot_q;
        s2_shift_q <= s1_shift_q;
        s2_prod_q  <= s1_top_q * s1_scale_q;
        s3_win_q   <= s2_win_q;
        s3_last_q  <= s2_last_q;
        s3_slot_q  <= s2_slot_q;
        s3_depth_q <= s2_shift_q == 6'd63 || s2_depth >= {{(33-FW){1'b0}}, LIM} ? LIM
                      : s2_depth[FW:0] + 1'b1;
        s4_last_q  <= s3_last_q;
        s4_slot_q  <= s3_slot_q;
        if (rst) begin
            s1_last_q <= 1'b0; s2_last_q <= 1'b0; s3_last_q <= 1'b0; s4_last_q <= 1'b0;
            s1_win_q <= 1'b0; s2_win_q <= 1'b0; s3_win_q <= 1'b0;
        end
    end
    assign out_valid_o = s4_last_q;
    assign out_slot_o  = s4_slot_q;

    // ---- depth limit of each slot: set-up writes the first, hits lower it ----
    // A slot has one token: set-up and a leaf result never concern the same slot at once, but
    // they may come in the same cycle; two files, chosen by found_q, avoid a second write port.
    wire [FW:0] filter_first, filter_best, next_first, next_best;
    rt_slot_file #(.WIDTH(FW+1), .SLOTS(SLOTS)) u_first_f (
        .clk(clk), .wr_en_i(new_valid_i), .wr_addr_i(new_slot_i), .wr_data_i(new_depth_i),
        .rd_addr_i(filter_slot_i), .rd_data_o(filter_first)
    );
    rt_slot_file #(.WIDTH(FW+1), .SLOTS(SLOTS)) u_first_n (
        .clk(clk), .wr_en_i(new_valid_i), .wr_addr_i(new_slot_i), .wr_data_i(new_depth_i),
        .rd_addr_i(next_slot_i), .rd_data_o(next_first)
    );
    rt_slot_file #(.WIDTH(FW+1), .SLOTS(SLOTS)) u_best_f (
        .clk(clk), .wr_en_i(s3_win_q), .wr_addr_i(s3_slot_q), .wr_data_i(s3_depth_q),
        .rd_addr_i(filter_slot_i), .rd_data_o(filter_best)
    );
    rt_slot_file #(.WIDTH(FW+1), .SLOTS(SLOTS)) u_best_n (
        .clk(clk), .wr_en_i(s3_win_q), .wr_addr_i(s3_slot_q), .wr_data_i(s3_depth_q),
        .rd_addr_i(next_slot_i), .rd_data_o(next_best)
    );
    assign filter_depth_o = found_q[filter_slot_i] ? filter_best : filter_first;
    assign next_depth_o   = found_q[next_slot_i] ? next_best : next_first;
    assign next_found_o   = found_q[next_slot_i];
    assign next_shadow_o  = shadow_q[next_slot_i];
    assign done_found_o   = found_q[done_slot_i];
    assign done_shadow_o  = shadow_q[done_slot_i];
    assign {done_far_o, done_id_o, done_key_o} = done_best;
endmodule
`default_nettype wire
