// rt_clocks.v - clocks of a ULX3S out of its 25 MHz, and resets that end when they run
// SPDX-License-Identifier: Apache-2.0
//   25 MHz --> PLL of an ECP5, 625 MHz inside --> / 5 = 125 MHz, bits of the display, two a clock
//                                             --> / 25 = 25 MHz, pixels, and the core
//                                             --> / MEM_DIV, memory
// rst_o is for clk, mem_rst_o for mem_clk; both end 16 clocks after the PLL holds.
`timescale 1ns / 1ps
`default_nettype none
module rt_clocks #(
    parameter MEM_DIV = 10                // 5..128: 625 MHz divided by it is mem_clk
) (
    input  wire clk_25mhz,
    input  wire restart_i,                // a button, of no clock
    output wire clk,                      // 25 MHz
    output wire clk5,                     // 125 MHz, edges together
    output wire mem_clk,
    output wire rst_o,
    output wire mem_rst_o
);
    wire locked;
    (* FREQUENCY_PIN_CLKI = "25", FREQUENCY_PIN_CLKOP = "125", FREQUENCY_PIN_CLKOS = "25",
       ICP_CURRENT = "12", LPF_RESISTOR = "8", MFG_ENABLE_FILTEROPAMP = "1",
       MFG_GMCREF_SEL = "2" *)
    EHXPLLL #(
        .PLLRST_ENA("DISABLED"), .INTFB_WAKE("DISABLED"), .STDBY_ENABLE("DISABLED"),
        .DPHASE_SOURCE("DISABLED"), .OUTDIVIDER_MUXA("DIVA"), .OUTDIVIDER_MUXB("DIVB"),
        .OUTDIVIDER_MUXC("DIVC"), .OUTDIVIDER_MUXD("DIVD"), .CLKI_DIV(1), .CLKFB_DIV(5),
        .FEEDBK_PATH("CLKOP"),
        .CLKOP_ENABLE("ENABLED"), .CLKOP_DIV(5), .CLKOP_CPHASE(2), .CLKOP_FPHASE(0),
        .CLKOS_ENABLE("ENABLED"), .CLKOS_DIV(25), .CLKOS_CPHASE(2), .CLKOS_FPHASE(0),
        .CLKOS2_ENABLE("ENABLED"), .CLKOS2_DIV(MEM_DIV), .CLKOS2_CPHASE(2), .CLKOS2_FPHASE(0)
    ) u_pll (
        .RST(1'b0), .STDBY(1'b0), .CLKI(clk_25mhz), .CLKOP(clk5), .CLKOS(clk), .CLKOS2(mem_clk),
        .CLKFB(clk5), .PHASESEL0(1'b0), .PHASESEL1(1'b0), .PHASEDIR(1'b1), .PHASESTEP(1'b1),
        .PHASELOADREG(1'b1), .PLLWAKESYNC(1'b0), .ENCLKOP(1'b0), .LOCK(locked)
    );
    rt_reset u_rst (.clk(clk), .hold_i(restart_i || !locked), .rst_o(rst_o));
    rt_reset u_mem_rst (.clk(mem_clk), .hold_i(restart_i || !locked), .rst_o(mem_rst_o));
endmodule
`default_nettype wire
