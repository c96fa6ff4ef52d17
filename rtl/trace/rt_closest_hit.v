// rt_closest_hit.v - gathers the leaf results of a visit and keeps each ray's first hit
// SPDX-License-Identifier: Apache-2.0
// A smaller key wins, a tie goes to the smaller id, so the order of arrival does not matter.
// The best key gives a depth beyond which nothing can win: key * scale >> shift, rounded up; with
// KEYS its own top bits are that depth, and FW + 1 of them are kept.
// One result a cycle; the token leaves 4 cycles after the last result of its visit.
// Model: keep_nearest() in cmodel/trace/leaf_unit.c, sph_ray_depth() in cmodel/trace/setup.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module rt_closest_hit #(
    parameter W     = 16,  // coordinate, bits
    parameter WD    = 17,  // direction component, bits
    parameter FW    = 14,  // filter coordinate, bits
    parameter SLOTS = 32,  // power of two
    parameter SHADOW = 1,  // 1: shadow rays
    parameter INSIDE = 1,  // 1: far roots, or facets: far is kept
    parameter FIRST = 1,   // 1: rays that end with the first visit that hits
    parameter LUTS  = 0,   // LUT cells that a block RAM is worth, rt_slot_ram
    parameter KEYS  = 0    // 1: depths are T-words, 2: of boxes; scale and shift are not used
) (
    input  wire              clk,
    input  wire              rst,
    // from rt_traverse or rt_bih: how many results the visit of a slot will have
    input  wire              want_valid_i,
    input  wire [$clog2(SLOTS)-1:0] want_slot_i,
    input  wire [2:0]        want_count_i,
    // from rt_setup: a new ray in a slot
    input  wire              new_valid_i,
    input  wire [$clog2(SLOTS)-1:0] new_slot_i,
    input  wire [16:0]       new_scale_i,   // u1.15
    input  wire [5:0]        new_shift_i,   // 63: depth cannot be bounded
    input  wire              new_shadow_i,
    input  wire              new_primary_i,
    input  wire              new_first_i,   // ends with the first visit that hits
    input  wire [FW:0]       new_depth_i,   // depth limit at the start
    // from rt_leaf_unit: one result
    input  wire              in_valid_i,
    input  wire [$clog2(SLOTS)-1:0] in_slot_i,
    input  wire              in_hit_i,
    input  wire              in_far_i,
    input  wire [`RT_ID_BITS-1:0] in_id_i,
    input  wire [W+WD+1:0]   in_key_i,
    // to rt_traversal_stack: the visit is complete
    output wire              out_valid_o,
    output wire [$clog2(SLOTS)-1:0] out_slot_o,
    // state of a slot, one cycle after its number
    input  wire              filter_valid_i,
    input  wire [$clog2(SLOTS)-1:0] filter_slot_i,
    output wire [FW:0]       filter_depth_o, // what lies deeper does not matter
    input  wire              next_valid_i,
    input  wire [$clog2(SLOTS)-1:0] next_slot_i,
    output wire [FW:0]       next_depth_o,
    output wire              next_found_o,   // the ray has a hit
    output wire              next_ends_o,    // a hit ends the ray: shadow, or first
    input  wire              done_valid_i,
    input  wire [$clog2(SLOTS)-1:0] done_slot_i,
    output wire              done_found_o,
    output wire              done_shadow_o,
    output wire              done_primary_o,
    output wire              done_first_o,
    output wire              done_far_o,
    output wire [1:0]        done_fars_o,    // hits from inside that there were, 2: or more
    output wire [`RT_ID_BITS-1:0] done_id_o,
    output wire [W+WD+1:0]   done_key_o
);
    localparam SLOTW = $clog2(SLOTS);
    localparam KW   = W + WD + 2;            // key
    localparam BW   = KW + `RT_ID_BITS;      // {id, key}; above it the mark, then far
    localparam LIM  = {(FW+1){1'b1}};        // largest depth
    localparam IB   = INSIDE != 0 ? 1 : 0;   // bits of a flag, if it is elaborated
    localparam SB   = SHADOW != 0 ? 1 : 0;
    localparam FB   = FIRST != 0 ? 1 : 0;
    localparam EB   = SHADOW != 0 || FIRST != 0 ? 1 : 0;
    localparam DB   = SHADOW != 0 ? FW + 1 : 0;  // depth at the start: the largest, or a light's

    // ---- has the ray of a slot a hit? ----
    // Two bits in two memories with one writer each: a new ray makes them equal, a hit makes them
    // differ. After reset every slot's hit bit and count of results are cleared, one a cycle.
    reg [SLOTW:0]   clear_q;                 // slots cleared
    wire            clearing   = !clear_q[SLOTW];
    wire [SLOTW-1:0] clear_slot = clear_q[SLOTW-1:0];
    wire            new_mark, in_mark, win;
    reg             s2_win_q, s2_mark_q;     // the mark is written for a hit that wins
    reg [SLOTW-1:0] s2_slot_q;
    wire [SLOTW-1:0] put_slot = clearing ? clear_slot : s2_slot_q;
    rt_slot_file #(.WIDTH(1), .SLOTS(SLOTS)) u_mark (
        .clk(clk), .wr_en_i(clearing || s2_win_q), .wr_addr_i(put_slot),
        .wr_data_i(!clearing && s2_mark_q),
        .rd_addr_i(new_slot_i), .rd_data_o(new_mark)
    );
    localparam XB0 = 6 + 17;                 // {mark, shift, scale} of a ray
    localparam XB = KEYS != 0 ? 0 : XB0;     // keys need the mark alone
    wire [XB0:0]  new_scale = {new_mark, new_shift_i, new_scale_i};
    wire [XB:0]   in_scale;
    assign in_mark = in_scale[XB];
    rt_slot_file #(.WIDTH(XB+1), .SLOTS(SLOTS)) u_scale (
        .clk(clk), .wr_en_i(new_valid_i), .wr_addr_i(new_slot_i),
        .wr_data_i(new_scale[XB0 -: XB+1]),
        .rd_addr_i(in_slot_i), .rd_data_o(in_scale)
    );

    // ---- count the results of a visit ----
    wire [2:0] want, seen_before;
    wire [2:0] seen = seen_before + 3'd1;
    wire       last = seen == want;
    rt_slot_file #(.WIDTH(3), .SLOTS(SLOTS)) u_want (
        .clk(clk), .wr_en_i(want_valid_i), .wr_addr_i(want_slot_i), .wr_data_i(want_count_i),
        .rd_addr_i(in_slot_i), .rd_data_o(want)
    );
    rt_slot_file #(.WIDTH(3), .SLOTS(SLOTS)) u_seen (
        .clk(clk), .wr_en_i(clearing || in_valid_i),
        .wr_addr_i(clearing ? clear_slot : in_slot_i),
        .wr_data_i(clearing || last ? 3'd0 : seen),
        .rd_addr_i(in_slot_i), .rd_data_o(seen_before)
    );

    // ---- stage 0: read the best so far; is the result before of the same slot? ----
    wire [BW+IB:0] best, done_best;          // {far, hit mark, id, key}
    reg             s1_valid_q, s1_same_q;   // s1_same_q: of the slot of the result a clock before
    reg             s1_mark_q, s1_far_q, s2_far_q;
    reg [SLOTW-1:0] s1_slot_q;
    reg [BW-1:0]    s1_new_q, s1_best_q, s2_new_q;      // {id, key}
    reg             s1_found_q;              // s1_best_q is a hit of this ray
    wire            s2_read = s2_win_q && s2_slot_q == in_slot_i;  // it is being written
    always @(posedge clk) begin
        s1_valid_q <= in_valid_i && in_hit_i;
        s1_same_q  <= in_slot_i == s1_slot_q;
        s1_slot_q  <= in_slot_i;
        if (in_valid_i) begin
            s1_mark_q  <= !in_mark;
            s1_far_q   <= in_far_i;
            s1_new_q   <= {in_id_i, in_key_i};
            s1_best_q  <= s2_read ? s2_new_q : best[BW-1:0];
            s1_found_q <= (s2_read ? s2_mark_q : best[BW]) != in_mark;
        end
        if (s1_valid_q) begin
            s2_new_q   <= s1_new_q;
            s2_mark_q  <= s1_mark_q;
            s2_far_q   <= s1_far_q;
        end
        s2_slot_q  <= s1_slot_q;
        if (rst) s1_valid_q <= 1'b0;
    end

    // ---- stage 1: compare with it, or with the result before, which was not written yet ----
    function closer(input [BW-1:0] one, input [BW-1:0] other);
        closer = one[KW-1:0] < other[KW-1:0] ||
                 (one[KW-1:0] == other[KW-1:0] && one[BW-1:KW] < other[BW-1:KW]);
    endfunction
    assign win = s1_valid_q && (s1_same_q && s2_win_q ? closer(s1_new_q, s2_new_q)
                                : !s1_found_q || closer(s1_new_q, s1_best_q));
    // ---- stage 2: write ----
    wire [BW+1:0] cand = {s2_far_q, s2_mark_q, s2_new_q};
    wire [BW+IB:0] put = clearing ? {(BW+IB+1){1'b0}} : cand[BW+IB:0];
    rt_slot_file #(.WIDTH(BW+IB+1), .SLOTS(SLOTS)) u_best (
        .clk(clk), .wr_en_i(clearing || s2_win_q), .wr_addr_i(put_slot),
        .wr_data_i(put), .rd_addr_i(in_slot_i), .rd_data_o(best)
    );
    rt_slot_ram #(.WIDTH(BW+IB+1), .SLOTS(SLOTS), .OLD(0), .LUTS(LUTS)) u_done (
        .clk(clk), .wr_en_i(clearing || s2_win_q), .wr_addr_i(put_slot),
        .wr_data_i(put), .rd_en_i(done_valid_i), .rd_addr_i(done_slot_i), .rd_data_o(done_best)
    );
    always @(posedge clk) begin
        if (clearing) clear_q <= clear_q + 1'b1;
        if (rst) clear_q <= 0;
    end

    // ---- hits from inside, of cores that ask for them: each counts, whether it wins or not ----
    // Written for each hit with the ray's mark, so that what a ray before it left does not count.
    generate
        if (INSIDE != 0 && FIRST != 0) begin : g_fars
            wire [2:0] in_fars, done_fars;       // {mark, number}
            reg        s2_hit_q;
            reg  [2:0] s1_fars_q, s2_fars_q;
            wire       s2_again = s1_same_q && s2_hit_q;
            wire [1:0] s1_had = s2_again ? s2_fars_q[1:0]
                                : s1_fars_q[2] == s1_mark_q ? s1_fars_q[1:0] : 2'd0;
            wire [2:0] put_fars = clearing ? 3'd0 : s2_fars_q;
            wire       fars_wr = clearing || s2_hit_q;
            always @(posedge clk) begin
                s2_hit_q  <= s1_valid_q;
                s1_fars_q <= s2_hit_q && s2_slot_q == in_slot_i ? s2_fars_q : in_fars;
                s2_fars_q <= {s1_mark_q, s1_had + {1'b0, s1_far_q && !s1_had[1]}};
                if (rst) s2_hit_q <= 1'b0;
            end
            rt_slot_file #(.WIDTH(3), .SLOTS(SLOTS)) u_fars (
                .clk(clk), .wr_en_i(fars_wr), .wr_addr_i(put_slot), .wr_data_i(put_fars),
                .rd_addr_i(in_slot_i), .rd_data_o(in_fars)
            );
            rt_slot_ram #(.WIDTH(3), .SLOTS(SLOTS), .OLD(0), .LUTS(LUTS)) u_fars_d (
                .clk(clk), .wr_en_i(fars_wr), .wr_addr_i(put_slot), .wr_data_i(put_fars),
                .rd_en_i(done_valid_i), .rd_addr_i(done_slot_i), .rd_data_o(done_fars)
            );
            assign done_fars_o = done_fars[1:0]; // of a ray with a hit
            wire unused = done_fars[2];
        end else begin : g_no_fars
            assign done_fars_o = 2'd0;
        end
    endgenerate

    // ---- stages 1 to 3: depth of the new best ----
    reg             s3_win_q, s1_last_q, s2_last_q, s3_last_q, s4_last_q;
    reg             s3_mark_q;
    reg [SLOTW-1:0] s3_slot_q, s4_slot_q;
    wire [FW:0]     s3_depth;
    always @(posedge clk) begin
        s3_mark_q  <= s2_mark_q;
        s1_last_q  <= in_valid_i && last;
        s2_win_q   <= win;
        s2_last_q  <= s1_last_q;
        s3_win_q   <= s2_win_q;
        s3_last_q  <= s2_last_q;
        s3_slot_q  <= s2_slot_q;
        s4_last_q  <= s3_last_q;
        s4_slot_q  <= s3_slot_q;
        if (rst) begin
            s1_last_q <= 1'b0; s2_last_q <= 1'b0; s3_last_q <= 1'b0; s4_last_q <= 1'b0;
            s2_win_q <= 1'b0; s3_win_q <= 1'b0;
        end
    end
    assign out_valid_o = s4_last_q;
    assign out_slot_o  = s4_slot_q;
    generate
        if (KEYS != 0) begin : g_key
            localparam TW = `RT_BIH_T;
            localparam T = KW > TW ? KW - TW : 0;                  // bits of a key that are dropped
            wire [KW+TW-1:0] key = {{TW{1'b0}}, in_key_i} >> T;    // fits: TW bits, or KW
            wire [TW-1:0] s1_time;
            rt_delay #(.WIDTH(TW), .CYCLES(1)) u_key (
                .clk(clk), .in_i(key[TW-1:0]), .out_o(s1_time)
            );
            wire [FW:0] s1_depth;
            if (KEYS == 2) begin : g_boxes
                rt_box_depth u_depth (.time_i(s1_time), .depth_o(s1_depth));
            end else begin : g_times
                assign s1_depth = s1_time;
            end
            rt_delay #(.WIDTH(FW+1), .CYCLES(2)) u_depth (
                .clk(clk), .in_i(s1_depth), .out_o(s3_depth)
            );
            wire unused = &{1'b0, key, new_scale};
        end else begin : g_scaled
            // A key is below 2.4 * 2^(W+WD) (docs/reference/machine_file.md), so its top + 1 fits
            // 17 bits.
            reg [16:0]  s1_top_q, s1_scale_q;    // u17 top of the key, rounded up; u1.15
            reg [5:0]   s1_shift_q, s2_shift_q;
            reg [33:0]  s2_prod_q;
            reg [FW:0]  s3_low_q;                // of the depth, rounded down
            reg [4:0]   s3_high_q;               // a bit above is 1, by groups
            reg         s3_none_q;               // it is not bounded
            integer     g;
            wire [33:0] s2_depth = s2_prod_q >> s2_shift_q;
            wire [39:0] s2_high  = {6'd0, s2_depth} >> (FW + 1);
            always @(posedge clk) begin
                if (in_valid_i) begin
                    s1_top_q   <= in_key_i[KW-1 -: 17] + 17'd1;
                    s1_scale_q <= in_scale[16:0];
                    s1_shift_q <= in_scale[22:17];
                end
                if (s1_valid_q) begin
                    s2_shift_q <= s1_shift_q;
                    s2_prod_q  <= s1_top_q * s1_scale_q;
                end
                if (s2_win_q) begin
                    s3_none_q  <= s2_shift_q == 6'd63;
                    s3_low_q   <= s2_depth[FW:0];
                    for (g = 0; g < 5; g = g + 1) s3_high_q[g] <= |s2_high[8*g +: 8];
                end
            end
            wire        s3_over = s3_none_q || |s3_high_q || s3_low_q == LIM;
            assign s3_depth = (s3_low_q + 1'b1) | {(FW+1){s3_over}};
        end
    endgenerate

    // ---- depth limit of each slot: set-up writes the first, hits lower it ----
    // Each memory carries its mark; filters and rt_traversal_stack read both kinds at once.
    wire [FW+1:0] filter_best, next_best;
    wire [DB:0]   filter_first;              // {depth, mark}
    wire [DB+EB:0] next_first;               // {ends with a hit, depth, mark}
    wire [SB+FB+1:0] done_first;             // {first, shadow, primary, mark}
    wire          new_ends = (SHADOW != 0 && new_shadow_i) || (FIRST != 0 && new_first_i);
    wire [FW+2:0] new_next = SHADOW != 0 ? {new_ends, new_depth_i, new_mark}
                                         : {{(FW+1){1'b0}}, new_ends, new_mark};
    wire [3:0]    new_done = SHADOW != 0 ? {new_first_i, new_shadow_i, new_primary_i, new_mark}
                                         : {1'b0, new_first_i, new_primary_i, new_mark};
    wire [FW:0]   filter_start, next_start;
    generate
        if (SHADOW != 0) begin : g_light     // a light may lie nearer than the limit
            assign filter_start = filter_first[DB -: FW+1];
            assign next_start   = next_first[DB -: FW+1];
        end else begin : g_limit
            assign filter_start = LIM;
            assign next_start   = LIM;
        end
    endgenerate
    wire          best_wr   = clearing || s3_win_q;
    wire [SLOTW-1:0] best_slot = clearing ? clear_slot : s3_slot_q;
    wire [FW+1:0] best_data = clearing ? {(FW+2){1'b0}} : {s3_mark_q, s3_depth};
    rt_slot_ram #(.WIDTH(DB+1), .SLOTS(SLOTS), .OLD(0), .LUTS(LUTS)) u_first_f (
        .clk(clk), .wr_en_i(new_valid_i), .wr_addr_i(new_slot_i), .wr_data_i(new_next[DB:0]),
        .rd_en_i(filter_valid_i), .rd_addr_i(filter_slot_i), .rd_data_o(filter_first)
    );
    rt_slot_ram #(.WIDTH(FW+2), .SLOTS(SLOTS), .OLD(0), .LUTS(LUTS)) u_best_f (
        .clk(clk), .wr_en_i(best_wr), .wr_addr_i(best_slot), .wr_data_i(best_data),
        .rd_en_i(filter_valid_i), .rd_addr_i(filter_slot_i), .rd_data_o(filter_best)
    );
    rt_slot_ram #(.WIDTH(DB+EB+1), .SLOTS(SLOTS), .OLD(0), .LUTS(LUTS)) u_first_n (
        .clk(clk), .wr_en_i(new_valid_i), .wr_addr_i(new_slot_i), .wr_data_i(new_next[DB+EB:0]),
        .rd_en_i(next_valid_i), .rd_addr_i(next_slot_i), .rd_data_o(next_first)
    );
    rt_slot_ram #(.WIDTH(FW+2), .SLOTS(SLOTS), .OLD(0), .LUTS(LUTS)) u_best_n (
        .clk(clk), .wr_en_i(best_wr), .wr_addr_i(best_slot), .wr_data_i(best_data),
        .rd_en_i(next_valid_i), .rd_addr_i(next_slot_i), .rd_data_o(next_best)
    );
    rt_slot_ram #(.WIDTH(SB+FB+2), .SLOTS(SLOTS), .OLD(0), .LUTS(LUTS)) u_first_d (
        .clk(clk), .wr_en_i(new_valid_i), .wr_addr_i(new_slot_i),
        .wr_data_i(new_done[SB+FB+1:0]),
        .rd_en_i(done_valid_i), .rd_addr_i(done_slot_i), .rd_data_o(done_first)
    );
    wire filter_found = filter_first[0] != filter_best[FW+1];
    assign filter_depth_o = filter_found ? filter_best[FW:0] : filter_start;
    assign next_found_o   = next_first[0] != next_best[FW+1];
    assign next_depth_o   = next_found_o ? next_best[FW:0] : next_start;
    assign next_ends_o    = EB != 0 && next_first[DB+EB];
    assign done_found_o   = done_first[0] != done_best[BW];
    assign done_primary_o = done_first[1];
    assign done_shadow_o  = SHADOW != 0 && done_first[SB+1];
    assign done_first_o   = FIRST != 0 && done_first[SB+FB+1];
    assign done_far_o     = INSIDE != 0 && done_best[BW+IB];
    assign {done_id_o, done_key_o} = done_best[BW-1:0];
    wire unused = &{1'b0, cand, new_next, new_done, new_depth_i, new_shadow_i, new_first_i};
endmodule
`default_nettype wire
