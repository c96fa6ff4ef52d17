// rt_build_sort.v - numbers of spheres in the order of their keys
// SPDX-License-Identifier: Apache-2.0
//   key, id --> bank 0 --> [1 the word | 2 place of its digit] --> bank 1 --> .. --> bank 0
// A radix sort, low digits first: each pass moves a word a clock from one bank to the other, turns
// its key by a digit, and counts the next digit of what it moves. Places of a pass are sums of the
// counts of smaller digits. A count that is read in a clock is written in the next one; if two
// words with the same digit follow each other, the second takes what is being written. n words take
// DIGITS * (n + 68) clocks after their last one came in. Bank 1 then holds the list of a tree,
// which comes back as the order. What of an order is read first is copied to bank 1, so that there
// are two readers.
// Model: sph_bt_order() in cmodel/build/order.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module rt_build_sort #(
    parameter AB  = 12,                      // bits of the number of a sphere
    parameter KEY = 3*`RT_BUILD_AXIS,        // bits of a key, a multiple of DB
    parameter DB  = `RT_BUILD_DIGIT          // bits of a digit
) (
    input  wire          clk,
    input  wire          rst,                // synchronous, active high
    // from rt_build
    input  wire          clear_i,            // forget all; ready_o says when keys may come
    output wire          ready_o,            // counts are 0
    input  wire          key_valid_i,        // keys of 0, 1, 2, ..
    input  wire [KEY-1:0] key_i,
    input  wire          sort_i,             // they were the last
    input  wire [AB:0]   count_i,            // spheres
    output reg           done_o,             // bank 0 holds the order
    // places of the order, a clock after their number; two readers
    input  wire          a_en_i,
    input  wire          a_copy_i,           // for the second reader, too
    input  wire [AB-1:0] a_place_i,
    output wire [AB-1:0] a_id_o,
    input  wire          b_en_i,
    input  wire [AB-1:0] b_place_i,
    output wire [AB-1:0] b_id_o,
    // a list, in bank 1: who follows whom
    input  wire          link_i,
    input  wire [AB-1:0] link_from_i,
    input  wire [AB-1:0] link_to_i,
    // another order, to bank 0
    input  wire          put_i,
    input  wire [AB-1:0] put_place_i,
    input  wire [AB-1:0] put_id_i
);
    localparam DIGITS = KEY / DB;
    localparam PB     = $clog2(DIGITS + 1);
    localparam [PB-1:0] LAST = DIGITS[PB-1:0] - 1'b1;
    localparam [2:0] IDLE = 3'd0, CLEAR = 3'd1, FILL = 3'd2, SUMS = 3'd3, MOVE = 3'd4;

    reg  [2:0]    state_q;
    reg  [PB-1:0] pass_q;                    // the digit that words are moved by
    reg  [DB-1:0] digit_q;                   // of CLEAR and SUMS
    reg  [AB:0]   sum_q;                     // words of smaller digits
    reg  [AB:0]   read_q;                    // words read
    reg           moved_q;                   // a word was read in the last clock
    reg           here_q, put_q;             // it is there, with its place
    reg  [AB-1:0] write_q;                   // of FILL: the next one
    reg           copy_q;                    // what was read in the last clock is copied
    reg  [AB-1:0] copied_q;
    wire          moving  = state_q == MOVE;
    wire          more    = read_q != count_i;
    assign ready_o = state_q == FILL;

    // ---- banks ----
    wire [KEY+AB-1:0] word0, word1;
    wire          from1   = pass_q[0];       // bank that the pass reads
    reg  [KEY+AB-1:0] word_q, turned_q;
    wire [KEY+AB-1:0] turned = {word_q[AB +: DB], word_q[KEY+AB-1:AB+DB], word_q[AB-1:0]};
    reg  [AB:0]   place_q;
    rt_slot_ram #(.WIDTH(KEY + AB), .SLOTS(1 << AB), .OLD(0)) u_bank0 (
        .clk(clk),
        .wr_en_i(key_valid_i || put_i || (put_q && from1)),
        .wr_addr_i(key_valid_i ? write_q : put_i ? put_place_i : place_q[AB-1:0]),
        .wr_data_i(key_valid_i ? {key_i, write_q}
                               : {turned_q[AB +: KEY], put_i ? put_id_i : turned_q[AB-1:0]}),
        .rd_en_i(moving ? !from1 && more : a_en_i),
        .rd_addr_i(moving ? read_q[AB-1:0] : a_place_i),
        .rd_data_o(word0)
    );
    rt_slot_ram #(.WIDTH(KEY + AB), .SLOTS(1 << AB), .OLD(0)) u_bank1 (
        .clk(clk),
        .wr_en_i((put_q && !from1) || copy_q || link_i),
        .wr_addr_i(link_i ? link_from_i : copy_q ? copied_q : place_q[AB-1:0]),
        .wr_data_i({turned_q[AB +: KEY],
                    link_i ? link_to_i : copy_q ? word0[AB-1:0] : turned_q[AB-1:0]}),
        .rd_en_i(moving ? from1 && more : b_en_i),
        .rd_addr_i(moving ? read_q[AB-1:0] : b_place_i),
        .rd_data_o(word1)
    );
    assign a_id_o = word0[AB-1:0];
    assign b_id_o = word1[AB-1:0];

    // ---- counts of the next digit, places of this one ----
    wire          summing = state_q == SUMS;
    wire          sweep   = summing || state_q == CLEAR;
    wire [DB-1:0] counted = key_valid_i ? key_i[DB-1:0] : turned[AB +: DB];
    reg           counts_q;                  // a word is counted, by this digit
    reg  [DB-1:0] counted_q;
    reg  [AB:0]   count_q;
    wire [AB:0]   count, place;
    wire [AB:0]   raised  = count_q + 1'b1;
    rt_slot_file #(.WIDTH(AB + 1), .SLOTS(1 << DB)) u_counts (
        .clk(clk),
        .wr_en_i(counts_q || sweep),
        .wr_addr_i(sweep ? digit_q : counted_q),
        .wr_data_i(sweep ? {(AB+1){1'b0}} : raised),
        .rd_addr_i(sweep ? digit_q : counted),
        .rd_data_o(count)
    );
    wire [DB-1:0] digit   = word_q[AB +: DB];
    wire [DB-1:0] put_digit = turned_q[KEY+AB-1 -: DB];
    wire [AB:0]   behind  = place_q + 1'b1;
    rt_slot_file #(.WIDTH(AB + 1), .SLOTS(1 << DB)) u_places (
        .clk(clk),
        .wr_en_i(put_q || summing),
        .wr_addr_i(summing ? digit_q : put_digit),
        .wr_data_i(summing ? sum_q : behind),
        .rd_addr_i(digit),
        .rd_data_o(place)
    );

    always @(posedge clk) begin
        copy_q   <= a_en_i && a_copy_i;
        copied_q <= a_place_i;
        moved_q  <= moving && more;
        here_q   <= moved_q;
        word_q   <= from1 ? word1 : word0;
        put_q    <= here_q;
        turned_q <= turned;
        place_q  <= put_q && put_digit == digit ? behind : place;
        counts_q  <= key_valid_i || (here_q && pass_q != LAST);
        counted_q <= counted;
        count_q   <= counts_q && counted_q == counted ? raised : count;
        if (moving && more) read_q <= read_q + 1'b1;
        if (key_valid_i) write_q <= write_q + 1'b1;
        if (sweep) digit_q <= digit_q + 1'b1;
        if (summing) sum_q <= sum_q + count;
        done_o <= 1'b0;
        case (state_q)
            CLEAR: if (&digit_q) state_q <= FILL;
            FILL: if (sort_i) begin
                state_q <= SUMS;
                pass_q  <= {PB{1'b0}};
                sum_q   <= {(AB+1){1'b0}};
            end
            SUMS: if (&digit_q) begin
                state_q <= MOVE;
                read_q  <= {(AB+1){1'b0}};
            end
            MOVE: if (!more && !moved_q && !here_q && !put_q) begin
                pass_q  <= pass_q + 1'b1;
                sum_q   <= {(AB+1){1'b0}};
                state_q <= pass_q == LAST ? IDLE : SUMS;
                done_o  <= pass_q == LAST;
            end
            default: ;
        endcase
        if (clear_i) begin
            state_q <= CLEAR;
            digit_q <= {DB{1'b0}};
            write_q <= {AB{1'b0}};
        end
        if (rst) begin
            state_q <= IDLE;
            moved_q <= 1'b0;
            here_q  <= 1'b0;
            put_q   <= 1'b0;
            counts_q <= 1'b0;
            copy_q  <= 1'b0;
            done_o  <= 1'b0;
        end
    end
    wire unused = &{1'b0, place_q[AB]};
endmodule
`default_nettype wire
