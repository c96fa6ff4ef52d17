// rt_word_reads.v - AXI4 reads as reads of single words, which a memory answers in their order
// SPDX-License-Identifier: Apache-2.0
//   AR --> address, words left --> cmd          rsp --> queue --> R
// A word is asked for when the queue has room for it, so answers never wait; one a clock. The next
// burst is taken with the last word of this one. INCR bursts of full beats, of any length. rst may
// last longer than the master's: nothing is taken meanwhile.
`timescale 1ns / 1ps
`default_nettype none
module rt_word_reads #(
    parameter DEPTH = 32                  // words on their way and waiting, a power of two
) (
    input  wire        clk,
    input  wire        rst,
    // AXI4
    input  wire        s_arvalid,
    output wire        s_arready,
    input  wire [31:0] s_araddr,
    input  wire [7:0]  s_arlen,
    output wire        s_rvalid,
    input  wire        s_rready,
    output wire [63:0] s_rdata,
    output wire        s_rlast,
    // words
    output wire        cmd_valid_o,
    input  wire        cmd_ready_i,
    output reg  [21:0] cmd_addr_o,        // number of the word
    output wire        cmd_last_o,        // of its burst
    input  wire        rsp_valid_i,       // in the order of commands
    input  wire        rsp_last_i,        // what cmd_last_o was
    input  wire [63:0] rsp_data_i
);
    localparam CB = $clog2(DEPTH) + 1;
    reg  [8:0]    left_q;                 // words of this burst to ask for
    reg  [CB-1:0] owed_q;                 // words asked for and not yet taken, never over DEPTH
    wire          give = s_rvalid && s_rready;
    wire          ask  = cmd_valid_o && cmd_ready_i;
    wire          room;                   // of the queue; owed_q sees to it
    wire          unused = &{1'b0, s_araddr, room};
    assign cmd_valid_o = left_q != 9'd0 && !owed_q[CB-1];
    assign cmd_last_o  = left_q == 9'd1;
    assign s_arready   = !rst && (left_q == 9'd0 || (ask && cmd_last_o));
    always @(posedge clk) begin
        if (ask) begin
            cmd_addr_o <= cmd_addr_o + 22'd1;
            left_q     <= left_q - 9'd1;
        end
        if (s_arvalid && s_arready) begin
            cmd_addr_o <= s_araddr[24:3];
            left_q     <= {1'b0, s_arlen} + 9'd1;
        end
        owed_q <= owed_q + {{(CB-1){1'b0}}, ask} - {{(CB-1){1'b0}}, give};
        if (rst) begin
            left_q <= 9'd0;
            owed_q <= {CB{1'b0}};
        end
    end
    rt_fifo #(.WIDTH(65), .DEPTH(DEPTH)) u_queue (
        .clk(clk), .rst(rst), .in_valid_i(rsp_valid_i), .in_ready_o(room),
        .in_data_i({rsp_last_i, rsp_data_i}), .out_valid_o(s_rvalid), .out_ready_i(s_rready),
        .out_data_o({s_rlast, s_rdata})
    );
endmodule
`default_nettype wire
