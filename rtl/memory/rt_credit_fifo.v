// rt_credit_fifo.v - queue of words that were asked for: each has a place before it comes
// SPDX-License-Identifier: Apache-2.0
// A place is taken when its word is asked for (ask_i, while credit_o is high) and free again when
// the word leaves. So a word that comes is never refused, and who brings it, in order with words
// for others, never waits. Latency and rate are those of rt_fifo.
`timescale 1ns / 1ps
`default_nettype none
module rt_credit_fifo #(
    parameter WIDTH = 8,   // bits of a word
    parameter DEPTH = 16   // words, a power of two, at least 2
) (
    input  wire             clk,
    input  wire             rst,          // synchronous, active high
    // to and from who asks
    output wire             credit_o,     // there is a place for one word more
    input  wire             ask_i,        // a word is asked for; only with credit_o
    // from the producer: a word that was asked for
    input  wire             in_valid_i,
    input  wire [WIDTH-1:0] in_data_i,
    // to the consumer
    output wire             out_valid_o,
    input  wire             out_ready_i,
    output wire [WIDTH-1:0] out_data_o
);
    localparam AB = $clog2(DEPTH);
    reg  [AB:0] used_q;                   // words asked for that have not left, 0..DEPTH
    wire        leave = out_valid_o && out_ready_i;
    wire        room;                     // always when a word comes
    assign credit_o = !used_q[AB];
    always @(posedge clk) begin
        if (ask_i && !leave) used_q <= used_q + 1'b1;
        if (!ask_i && leave) used_q <= used_q - 1'b1;
        if (rst) used_q <= {(AB+1){1'b0}};
    end
    rt_fifo #(.WIDTH(WIDTH), .DEPTH(DEPTH)) u_words (
        .clk(clk), .rst(rst),
        .in_valid_i(in_valid_i), .in_ready_o(room), .in_data_i(in_data_i),
        .out_valid_o(out_valid_o), .out_ready_i(out_ready_i), .out_data_o(out_data_o)
    );
    wire unused = &{1'b0, room};
endmodule
`default_nettype wire
