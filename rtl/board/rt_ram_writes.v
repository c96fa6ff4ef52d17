// rt_ram_writes.v - AXI4 writes to a block RAM: one burst at a time, a beat a clock
// SPDX-License-Identifier: Apache-2.0
//   AW --> address --> each beat of W --> RAM; the last one --> B, OKAY
// Strobes count for 16 bits together: pixels of RGB565 are written whole.
`timescale 1ns / 1ps
`default_nettype none
module rt_ram_writes #(
    parameter AB = 12                     // address bits of the RAM, which has words of 64 bits
) (
    input  wire          clk,
    input  wire          rst,
    // AXI4; the data are the RAM's
    input  wire          s_awvalid,
    output wire          s_awready,
    input  wire [31:0]   s_awaddr,
    input  wire          s_wvalid,
    output wire          s_wready,
    input  wire [7:0]    s_wstrb,
    input  wire          s_wlast,
    output reg           s_bvalid,
    input  wire          s_bready,
    // to the RAM
    output wire [3:0]    we_o,
    output reg  [AB-1:0] addr_o
);
    reg  open_q;                          // a burst is written
    wire unused = &{1'b0, s_awaddr, s_wstrb};
    assign s_awready = !open_q && !s_bvalid;
    assign s_wready  = open_q;
    assign we_o = {4{s_wvalid && open_q}} & {s_wstrb[6], s_wstrb[4], s_wstrb[2], s_wstrb[0]};
    always @(posedge clk) begin
        if (s_awvalid && s_awready) begin
            open_q <= 1'b1;
            addr_o <= s_awaddr[AB+2:3];
        end
        if (s_wvalid && open_q) begin
            addr_o <= addr_o + 1'b1;
            open_q <= !s_wlast;
        end
        s_bvalid <= (s_wvalid && open_q && s_wlast) || (s_bvalid && !s_bready);
        if (rst) begin
            open_q   <= 1'b0;
            s_bvalid <= 1'b0;
        end
    end
endmodule
`default_nettype wire
