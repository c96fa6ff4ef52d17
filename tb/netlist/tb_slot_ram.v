// tb_slot_ram.v - a netlist of rt_slot_ram against a memory: random words, collisions among them
// SPDX-License-Identifier: Apache-2.0
`timescale 1ns / 1ps
`default_nettype none
module tb_slot_ram #(
    parameter WIDTH = 66,
    parameter SLOTS = 512,
    parameter OLD   = 1,
    parameter AB    = $clog2(SLOTS)
);
    reg              clk = 1'b0, wr_en = 1'b0, rd_en = 1'b0, valid = 1'b0;
    reg  [AB-1:0]    wr_addr = 0, rd_addr = 0;
    reg  [WIDTH-1:0] wr_data = 0, mem [0:SLOTS-1], expected = 0;
    wire [WIDTH-1:0] rd_data;
    integer          i, wrong = 0;
    rt_slot_ram #(.WIDTH(WIDTH), .SLOTS(SLOTS), .OLD(OLD)) u_netlist (
        .clk(clk), .wr_en_i(wr_en), .wr_addr_i(wr_addr), .wr_data_i(wr_data), .rd_en_i(rd_en),
        .rd_addr_i(rd_addr), .rd_data_o(rd_data)
    );
    always #5 clk = !clk;
    initial begin
        for (i = 0; i < SLOTS; i = i + 1) mem[i] = 0;
        for (i = 0; i < 10000; i = i + 1) begin
            @(negedge clk);
            {wr_en, rd_en} = $random;
            {wr_addr, rd_addr} = {$random, $random};
            if (i % 3 == 0) rd_addr = wr_addr;
            if (OLD == 0 && rd_addr == wr_addr) rd_en = 1'b0;
            wr_data = {$random, $random, $random};
            @(posedge clk);
            if (rd_en) {valid, expected} = {1'b1, mem[rd_addr]};
            if (wr_en) mem[wr_addr] = wr_data;
            #1 if (valid && rd_data !== expected) wrong = wrong + 1;
        end
        if (wrong == 0) $display("ok netlist of %0d words of %0d bits", SLOTS, WIDTH);
        else $display("not ok netlist of %0d words of %0d bits: %0d wrong", SLOTS, WIDTH, wrong);
        $finish;
    end
endmodule
`default_nettype wire
