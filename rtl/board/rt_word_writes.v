// rt_word_writes.v - AXI4 writes as writes of single words with strobes
// SPDX-License-Identifier: Apache-2.0
//   AW --> address --> each beat of W --> cmd; behind the last one B, OKAY
// One burst at a time; what is read after B sees what was written. INCR bursts of full beats. rst
// may last longer than the master's: nothing is taken meanwhile.
`timescale 1ns / 1ps
`default_nettype none
module rt_word_writes (
    input  wire        clk,
    input  wire        rst,
    // AXI4; data and strobes are those of the words
    input  wire        s_awvalid,
    output wire        s_awready,
    input  wire [31:0] s_awaddr,
    input  wire        s_wvalid,
    output wire        s_wready,
    input  wire        s_wlast,
    output reg         s_bvalid,
    input  wire        s_bready,
    // words
    output wire        cmd_valid_o,
    input  wire        cmd_ready_i,
    output reg  [21:0] cmd_addr_o         // number of the word
);
    reg  open_q;                          // a burst is written
    wire unused = &{1'b0, s_awaddr};
    assign s_awready   = !rst && !open_q && (!s_bvalid || s_bready);
    assign cmd_valid_o = open_q && s_wvalid;
    assign s_wready    = open_q && cmd_ready_i;
    always @(posedge clk) begin
        if (s_bready) s_bvalid <= 1'b0;
        if (s_wvalid && s_wready) begin
            cmd_addr_o <= cmd_addr_o + 22'd1;
            open_q     <= !s_wlast;
            s_bvalid   <= s_wlast;
        end
        if (s_awvalid && s_awready) begin
            open_q     <= 1'b1;
            cmd_addr_o <= s_awaddr[24:3];
        end
        if (rst) begin
            open_q   <= 1'b0;
            s_bvalid <= 1'b0;
        end
    end
endmodule
`default_nettype wire
