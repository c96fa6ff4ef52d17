// f_counts.v - proof of rt_counters: totals are at rest PLACES + 4 clocks after the last event
// SPDX-License-Identifier: Apache-2.0
// From any state in which stages follow one another in turn, as they do from a reset on, also amid
// a clearing. Clocks in which `clk` stands still are none of these.
`timescale 1ns / 1ps
`default_nettype none
module f_counts #(
    parameter PLACES = 16
) (
    input wire       clk,
    input wire [4:0] addr
);
    localparam AB = $clog2(PLACES);
    wire [47:0] data;
    rt_counters #(.PLACES(PLACES), .USED(PLACES)) u_dut (
        .clk(clk), .rst(1'b0), .clear_i(1'b0), .add_i({8*PLACES{1'b0}}), .addr_i(addr),
        .data_o(data)
    );
    (* hierconn *) wire [AB-1:0] \u_dut.u_total.mark , \u_dut.u_shown.mark ;
    (* hierconn *) wire [AB-1:0] \u_dut.turn_q , \u_dut.total_q , \u_dut.s2_at_q ;
    wire [AB-1:0] first = \u_dut.turn_q - 1'b1, second = \u_dut.total_q - 1'b1;
    reg  [47:0] data_q;
    always @(posedge clk) data_q <= data;
    always @* begin
        assume (\u_dut.u_total.mark == \u_dut.u_shown.mark && addr == \u_dut.u_shown.mark );
        assume (\u_dut.total_q == first && \u_dut.s2_at_q == second);
        assert (data == data_q);
    end
endmodule
`default_nettype wire
