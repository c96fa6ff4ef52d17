// f_memory.v - proof that rt_slot_file does what f_slot_file.v, which stands for it, says
// SPDX-License-Identifier: Apache-2.0
// Any one address, read all the time: reading does not change the memory, so this is every read.
`timescale 1ns / 1ps
`default_nettype none
module f_memory #(
    parameter WIDTH = 8,
    parameter SLOTS = 16,
    parameter AB    = $clog2(SLOTS)
) (
    input wire             clk,
    input wire             wr_en,
    input wire [AB-1:0]    wr_addr,
    input wire [WIDTH-1:0] wr_data
);
    (* anyconst *) wire [AB-1:0] mark;
    wire [WIDTH-1:0] rd_data;
    rt_slot_file #(.WIDTH(WIDTH), .SLOTS(SLOTS)) u_dut (
        .clk(clk), .wr_en_i(wr_en), .wr_addr_i(wr_addr), .wr_data_i(wr_data),
        .rd_addr_i(mark), .rd_data_o(rd_data)
    );
    reg known_q = 1'b0;
    reg [WIDTH-1:0] word_q;
    always @(posedge clk) if (wr_en && wr_addr == mark) begin
        known_q <= 1'b1;
        word_q  <= wr_data;
    end
    always @* if (known_q) assert (rd_data == word_q);
endmodule
`default_nettype wire
