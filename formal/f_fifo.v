// f_fifo.v - proof of rt_fifo: nothing lost, duplicated, reordered or overrun
// SPDX-License-Identifier: Apache-2.0
// Any word that is pushed may be marked. It leaves after exactly the words that were inside when it
// came, with what was pushed. Pushes into a full queue and resets may come at any time.
`timescale 1ns / 1ps
`default_nettype none
module f_fifo #(
    parameter WIDTH = 8,
    parameter DEPTH = 16
) (
    input wire             clk,
    input wire             rst,
    input wire             in_valid,
    input wire [WIDTH-1:0] in_data,
    input wire             out_ready,
    input wire             pick          // mark the word that is pushed
);
    localparam AB = $clog2(DEPTH);
    wire in_ready, out_valid;
    wire [WIDTH-1:0] out_data;
    rt_fifo #(.WIDTH(WIDTH), .DEPTH(DEPTH)) u_dut (
        .clk(clk), .rst(rst), .in_valid_i(in_valid), .in_ready_o(in_ready), .in_data_i(in_data),
        .out_valid_o(out_valid), .out_ready_i(out_ready), .out_data_o(out_data)
    );
    (* hierconn *) wire [AB:0]      \u_dut.wr_q ;
    (* hierconn *) wire [AB:0]      \u_dut.rd_q ;
    (* hierconn *) wire [AB-1:0]    \u_dut.u_words.mark ;
    (* hierconn *) wire [WIDTH-1:0] \u_dut.u_words.word_q ;

    // ---- model: how many words, and how many of them before the marked one ----
    reg               old_q = 1'b0;      // a clock has passed
    reg [AB:0]        count_q;
    reg               marked_q;
    reg [AB:0]        ahead_q;
    reg [WIDTH-1:0]   data_q;
    wire push = in_valid && in_ready;
    wire pop  = out_valid && out_ready;
    wire mark = push && pick && !marked_q && \u_dut.wr_q [AB-1:0] == \u_dut.u_words.mark ;
    wire gone = pop && marked_q && ahead_q == 0;
    always @(posedge clk) begin
        old_q   <= 1'b1;
        count_q <= count_q + {{AB{1'b0}}, push} - {{AB{1'b0}}, pop};
        if (mark) begin
            marked_q <= 1'b1;
            ahead_q  <= count_q - {{AB{1'b0}}, pop};
            data_q   <= in_data;
        end else if (pop) begin
            ahead_q <= ahead_q - 1'b1;
        end
        if (gone) marked_q <= 1'b0;
        if (rst) begin count_q <= 0; marked_q <= 1'b0; end
    end
    always @* if (!old_q) assume (rst);

    // ---- last clock, for the handshake ----
    reg wait_q;
    always @(posedge clk) wait_q <= out_valid && !out_ready && !rst;

    always @* if (old_q) begin
        assert (count_q <= DEPTH);                                    // never overrun
        assert (in_ready == (count_q != DEPTH));
        assert (out_valid == (count_q != 0));
        if (marked_q && ahead_q == 0) assert (out_valid && out_data == data_q);
        if (wait_q) assert (out_valid);                               // valid stays
        // invariant
        assert (count_q == \u_dut.wr_q - \u_dut.rd_q );
        if (marked_q) begin
            assert (ahead_q < count_q);
            assert (\u_dut.u_words.word_q == data_q);
            assert (\u_dut.u_words.mark == \u_dut.rd_q [AB-1:0] + ahead_q[AB-1:0]);
        end
    end
endmodule
`default_nettype wire
