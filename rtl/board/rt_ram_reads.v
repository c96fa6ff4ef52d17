// rt_ram_reads.v - AXI4 reads of a block RAM: one burst at a time, a beat a clock
// SPDX-License-Identifier: Apache-2.0
//   AR --> address, beats left --> RAM --> its output register, valid --> R
// The RAM keeps its word while it is not asked for another, so that a beat may wait. The next burst
// is taken with the last beat of this one. INCR bursts of full beats; every answer is OKAY.
`timescale 1ns / 1ps
`default_nettype none
module rt_ram_reads #(
    parameter AB = 12                     // address bits of the RAM, which has words of 64 bits
) (
    input  wire          clk,
    input  wire          rst,
    // AXI4
    input  wire          s_arvalid,
    output wire          s_arready,
    input  wire [31:0]   s_araddr,
    input  wire [7:0]    s_arlen,
    output reg           s_rvalid,
    input  wire          s_rready,
    output reg           s_rlast,
    // to the RAM, whose word a clock later is s_rdata
    output wire          en_o,
    output reg  [AB-1:0] addr_o
);
    reg  [8:0] left_q;                    // beats of this burst
    wire go = !s_rvalid || s_rready;
    wire unused = &{1'b0, s_araddr};      // bits of a byte, and above the RAM
    assign en_o      = go && left_q != 9'd0;
    assign s_arready = left_q == 9'd0 || (go && left_q == 9'd1);
    always @(posedge clk) begin
        if (en_o) begin
            addr_o <= addr_o + 1'b1;
            left_q <= left_q - 9'd1;
        end
        if (go) begin
            s_rvalid <= left_q != 9'd0;
            s_rlast  <= left_q == 9'd1;
        end
        if (s_arvalid && s_arready) begin
            addr_o <= s_araddr[AB+2:3];
            left_q <= {1'b0, s_arlen} + 9'd1;
        end
        if (rst) begin
            left_q   <= 9'd0;
            s_rvalid <= 1'b0;
        end
    end
endmodule
`default_nettype wire
