// EHXPLLL.v - what the PLL of an ECP5 does, for simulation: it divides the clock of its VCO
// SPDX-License-Identifier: Apache-2.0
// A bench cannot make clocks out of a slower one without times, so it gives CLKI the clock of the
// VCO; an output of divider N is high for N of its edges and low for N. Outputs that rise together
// do so in one step. CLKOS3, phases and feedback are left out. Yosys, which only reads this, does
// not know both edges.
`timescale 1ns / 1ps
`default_nettype none
// verilator lint_off UNUSEDPARAM
module EHXPLLL #(
    parameter PLLRST_ENA = "DISABLED", INTFB_WAKE = "DISABLED", STDBY_ENABLE = "DISABLED",
    parameter DPHASE_SOURCE = "DISABLED", OUTDIVIDER_MUXA = "DIVA", OUTDIVIDER_MUXB = "DIVB",
    parameter OUTDIVIDER_MUXC = "DIVC", OUTDIVIDER_MUXD = "DIVD", FEEDBK_PATH = "CLKOP",
    parameter CLKOP_ENABLE = "ENABLED", CLKOS_ENABLE = "ENABLED", CLKOS2_ENABLE = "ENABLED",
    parameter CLKI_DIV = 1, CLKFB_DIV = 1,
    parameter CLKOP_DIV = 8, CLKOP_CPHASE = 0, CLKOP_FPHASE = 0,
    parameter CLKOS_DIV = 8, CLKOS_CPHASE = 0, CLKOS_FPHASE = 0,
    parameter CLKOS2_DIV = 8, CLKOS2_CPHASE = 0, CLKOS2_FPHASE = 0
) (
    input  wire CLKI,
    input  wire CLKFB,
    input  wire RST, STDBY, PHASESEL0, PHASESEL1, PHASEDIR, PHASESTEP, PHASELOADREG, PLLWAKESYNC,
    input  wire ENCLKOP,
    output reg  CLKOP = 1'b0,
    output reg  CLKOS = 1'b0,
    output reg  CLKOS2 = 1'b0,
    output reg  LOCK = 1'b0
);
    reg [15:0] step_q = 16'd0, op_q = 16'd0, os_q = 16'd0, os2_q = 16'd0;
    localparam [31:0] OP = CLKOP_DIV - 1, OS = CLKOS_DIV - 1, OS2 = CLKOS2_DIV - 1;
`ifdef YOSYS
    always @(posedge CLKI) begin
`else
    always @(posedge CLKI or negedge CLKI) begin
`endif
        op_q  <= op_q == OP[15:0] ? 16'd0 : op_q + 16'd1;
        os_q  <= os_q == OS[15:0] ? 16'd0 : os_q + 16'd1;
        os2_q <= os2_q == OS2[15:0] ? 16'd0 : os2_q + 16'd1;
        if (op_q == 16'd0)  CLKOP  <= !CLKOP;
        if (os_q == 16'd0)  CLKOS  <= !CLKOS;
        if (os2_q == 16'd0) CLKOS2 <= !CLKOS2;
        if (step_q != 16'd1000) step_q <= step_q + 16'd1;
        LOCK <= step_q == 16'd1000;
    end
    wire unused = &{1'b0, CLKFB, RST, STDBY, PHASESEL0, PHASESEL1, PHASEDIR, PHASESTEP,
                    PHASELOADREG, PLLWAKESYNC, ENCLKOP, OP, OS, OS2};
endmodule
`default_nettype wire
