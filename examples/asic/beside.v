// beside.v - the wrapper of compiled SRAM beside the file that it replaces, at random
// SPDX-License-Identifier: Apache-2.0
// rt_slot_ram_rtl is rtl/memory/rt_slot_ram.v under another name: tests/flow/test_minimal.sh.
`timescale 1ns / 1ps
`default_nettype none
module beside;
    reg clk = 1'b0;
    reg wr_en = 1'b1, rd_en = 1'b0, known = 1'b0;
    reg [1:0] wr_addr = 2'd0, rd_addr = 2'd0;
    reg [7:0] wr_data = 8'd0;
    wire [7:0] one, other;
    integer i, bad;
    rt_slot_ram_rtl #(.WIDTH(8), .SLOTS(4)) u_rtl (
        .clk(clk), .wr_en_i(wr_en), .wr_addr_i(wr_addr), .wr_data_i(wr_data), .rd_en_i(rd_en),
        .rd_addr_i(rd_addr), .rd_data_o(one)
    );
    rt_slot_ram #(.WIDTH(8), .SLOTS(4)) u_compiled (
        .clk(clk), .wr_en_i(wr_en), .wr_addr_i(wr_addr), .wr_data_i(wr_data), .rd_en_i(rd_en),
        .rd_addr_i(rd_addr), .rd_data_o(other)
    );
    initial begin
        bad = 0;
        for (i = 0; i < 4000; i = i + 1) begin
            #1 clk = 1'b1;
            #1 if (known && one !== other) bad = bad + 1;
            known   = known || rd_en;
            wr_en   = i < 3 || $random;
            wr_addr = i < 3 ? i + 1 : $random;
            wr_data = $random;
            rd_en   = i > 4 && $random;
            rd_addr = $random;
            #1 clk = 1'b0;
        end
        $display("%0d of %0d clocks differ", bad, i);
        $finish;
    end
endmodule
`default_nettype wire
