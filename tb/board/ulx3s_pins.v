// ulx3s_pins.v - the board of SDRAM for a bench in C++: the part's pins in one direction each
// SPDX-License-Identifier: Apache-2.0
`timescale 1ns / 1ps
`default_nettype none
module ulx3s_pins #(
    parameter DIV   = 25,                 // of rt_ulx3s_sdram
    parameter STILL = 18,
    parameter POWER = 12500
) (
    input  wire        clk_25mhz,
    input  wire [6:0]  btn_i,
    input  wire        uart_rx_i,
    output wire        uart_tx_o,
    output wire [3:0]  gpdi_o,
    output wire [7:0]  led_o,
    output wire        sdram_clk_o,
    output wire        sdram_cke_o,
    output wire [3:0]  sdram_command_o,
    output wire [1:0]  sdram_ba_o,
    output wire [12:0] sdram_a_o,
    output wire [1:0]  sdram_dqm_o,
    output wire        sdram_oe_o,        // the board drives dq
    output wire [15:0] sdram_drives_o,    // these of its pins do
    output wire [15:0] sdram_dq_o,        // what is on the wires
    input  wire [15:0] sdram_dq_i         // what the part drives, while the board does not
);
    wire [15:0] dq;
    assign dq         = sdram_oe_o ? 16'hzzzz : sdram_dq_i;
    assign sdram_dq_o = dq;
    assign sdram_oe_o = u_board.dq_oe;
    genvar i;
    generate for (i = 0; i < 16; i = i + 1) begin : g_pin
        assign sdram_drives_o[i] = !u_board.u_pins.g_pin[i].u_pin.T;
    end endgenerate
    rt_ulx3s_sdram #(.DIV(DIV), .STILL(STILL), .POWER(POWER)) u_board (
        .clk_25mhz(clk_25mhz), .btn_i(btn_i), .uart_rx_i(uart_rx_i), .uart_tx_o(uart_tx_o),
        .gpdi_o(gpdi_o), .led_o(led_o), .sdram_clk_o(sdram_clk_o), .sdram_cke_o(sdram_cke_o),
        .sdram_cs_n_o(sdram_command_o[3]), .sdram_ras_n_o(sdram_command_o[2]),
        .sdram_cas_n_o(sdram_command_o[1]), .sdram_we_n_o(sdram_command_o[0]),
        .sdram_ba_o(sdram_ba_o), .sdram_a_o(sdram_a_o), .sdram_dqm_o(sdram_dqm_o),
        .sdram_dq_io(dq)
    );
endmodule
`default_nettype wire
