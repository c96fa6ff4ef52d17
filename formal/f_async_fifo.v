// f_async_fifo.v - proof of rt_async_fifo: nothing lost, duplicated, reordered or overrun
// SPDX-License-Identifier: Apache-2.0
// Both clocks are inputs: edges come in any order, at any ratio, together or not, and crossings are
// those of f_sync.v. Words are numbered as they are pushed and popped, modulo 2 DEPTH. Any one may
// be marked; it is popped with its own number and with what was pushed. The queue starts as reset
// leaves it.
`timescale 1ns / 1ps
`default_nettype none
module f_async_fifo #(
    parameter WIDTH = 8,
    parameter DEPTH = 16
) (
    input wire             wr_clk,
    input wire             rd_clk,
    input wire             wr_valid,
    input wire [WIDTH-1:0] wr_data,
    input wire             rd_ready,
    input wire             pick          // mark the word that is pushed
);
    localparam AB = $clog2(DEPTH);
    wire wr_ready, rd_valid;
    wire [WIDTH-1:0] rd_data;
    wire [AB:0] wr_count;
    rt_async_fifo #(.WIDTH(WIDTH), .DEPTH(DEPTH)) u_dut (
        .wr_clk(wr_clk), .wr_rst(1'b0), .wr_valid_i(wr_valid), .wr_ready_o(wr_ready),
        .wr_data_i(wr_data), .wr_count_o(wr_count), .rd_clk(rd_clk), .rd_rst(1'b0),
        .rd_valid_o(rd_valid), .rd_ready_i(rd_ready), .rd_data_o(rd_data)
    );
    (* hierconn *) wire [AB:0]      \u_dut.wr_q ;
    (* hierconn *) wire [AB:0]      \u_dut.rd_q ;
    (* hierconn *) wire [AB:0]      \u_dut.wr_gray_q ;
    (* hierconn *) wire [AB:0]      \u_dut.rd_gray_q ;
    (* hierconn *) wire             \u_dut.fetch ;
    (* hierconn *) wire [AB:0]      \u_dut.u_to_rd.before_q ;
    (* hierconn *) wire [AB:0]      \u_dut.u_to_rd.meta_q ;
    (* hierconn *) wire [AB:0]      \u_dut.u_to_rd.q_o ;
    (* hierconn *) wire [AB:0]      \u_dut.u_to_wr.before_q ;
    (* hierconn *) wire [AB:0]      \u_dut.u_to_wr.meta_q ;
    (* hierconn *) wire [AB:0]      \u_dut.u_to_wr.q_o ;
    (* hierconn *) wire [AB:0]      \u_dut.rd_s_q ;
    (* hierconn *) wire [AB-1:0]    \u_dut.u_words.mark ;
    (* hierconn *) wire [WIDTH-1:0] \u_dut.u_words.word_q ;

    // ---- model: numbers of words; the marked one ----
    reg               old_q = 1'b0;      // a step has passed
    reg [AB:0]        pushes_q = 0, pops_q = 0;
    reg               marked_q = 1'b0;   // pushed
    reg               gone_q = 1'b0;     // popped
    reg [AB:0]        number_q;
    reg [WIDTH-1:0]   data_q;
    wire push = wr_valid && wr_ready;
    wire pop  = rd_valid && rd_ready;
    (* gclk *) reg step;                 // ticks with every step
    always @(posedge step) old_q <= 1'b1;
    always @(posedge wr_clk) begin
        if (push) pushes_q <= pushes_q + 1'b1;
        if (push && pick && !marked_q && \u_dut.wr_q [AB-1:0] == \u_dut.u_words.mark ) begin
            marked_q <= 1'b1;
            number_q <= pushes_q;
            data_q   <= wr_data;
        end
    end
    always @(posedge rd_clk) begin
        if (pop) pops_q <= pops_q + 1'b1;
        if (pop && marked_q && pops_q == number_q) gone_q <= 1'b1;
    end

    // ---- pointers as they cross ----
    function [AB:0] binary(input [AB:0] gray);
        integer i;
        begin
            binary[AB] = gray[AB];
            for (i = AB - 1; i >= 0; i = i - 1) binary[i] = binary[i+1] ^ gray[i];
        end
    endfunction
    wire [AB:0] wr_q = \u_dut.wr_q , rd_q = \u_dut.rd_q ;
    wire [AB:0] w0 = binary(\u_dut.u_to_rd.before_q ), r0 = binary(\u_dut.u_to_wr.before_q );
    wire [AB:0] w1 = binary(\u_dut.u_to_rd.meta_q ),   r1 = binary(\u_dut.u_to_wr.meta_q );
    wire [AB:0] w2 = binary(\u_dut.u_to_rd.q_o ),      r2 = binary(\u_dut.u_to_wr.q_o );
    wire [AB:0] words = wr_q - rd_q;
    wire [AB:0] w0_in = w0 - rd_q, w1_in = w1 - rd_q, w2_in = w2 - rd_q;
    wire [AB:0] r3 = \u_dut.rd_s_q ;    // what the writer goes by
    wire [AB:0] r0_on = r0 - r3, r1_on = r1 - r3, r2_on = r2 - r3;
    wire [AB:0] rd_on = rd_q - r3, wr_on = wr_q - r3;
    wire [AB:0] number_in = number_q - rd_q;
    always @* if (!old_q) assume (wr_q == 0 && rd_q == 0 && !rd_valid &&
        \u_dut.wr_gray_q == 0 && \u_dut.rd_gray_q == 0 && w0 == 0 && w1 == 0 && w2 == 0 &&
        r0 == 0 && r1 == 0 && r2 == 0 && r3 == 0);

    // ---- last step, for the handshake ----
    reg             wait_q = 1'b0;
    reg [WIDTH-1:0] wait_data_q;
    always @(posedge rd_clk) begin
        wait_q      <= rd_valid && !rd_ready && old_q;
        wait_data_q <= rd_data;
    end

    always @* if (old_q) begin
        assert (words <= DEPTH);                                      // never overrun
        assert (wr_count >= words);                                   // no word is forgotten
        assert (pushes_q == wr_q && pops_q + rd_valid == rd_q);       // each leaves once
        assert (!(\u_dut.fetch && push && wr_q[AB-1:0] == rd_q[AB-1:0]));
        if (marked_q && !gone_q && rd_valid && pops_q == number_q) assert (rd_data == data_q);
        if (wait_q) assert (rd_valid && rd_data == wait_data_q);      // valid stays
        if (gone_q) assert (marked_q);
        // invariant
        assert (\u_dut.wr_gray_q == (wr_q ^ (wr_q >> 1)));
        assert (\u_dut.rd_gray_q == (rd_q ^ (rd_q >> 1)));
        assert (w2_in <= w1_in && w1_in <= w0_in && w0_in <= words && words - w0_in <= 1);
        assert (r2_on <= r1_on && r1_on <= r0_on && r0_on <= rd_on && rd_on <= wr_on &&
                wr_on <= DEPTH);
        assert (rd_on - r0_on <= 1);
        if (marked_q && !gone_q) begin
            assert (number_q[AB-1:0] == \u_dut.u_words.mark );
            if (rd_valid && pops_q == number_q) assert (rd_q == number_q + 1'b1);
            else assert (number_in < words && \u_dut.u_words.word_q == data_q);
        end
    end
endmodule
`default_nettype wire
