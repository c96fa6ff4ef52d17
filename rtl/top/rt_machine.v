// rt_machine.v - the registers of a machine: read back at any time, given to the core at a START
// SPDX-License-Identifier: Apache-2.0
// They may be written while a frame is drawn: that frame has the values of its own START. After
// rst all are set to 0, which takes 2^7 cycles; giving them to the core takes N_REGS cycles, after
// that if it is asked for before. In both, busy_o is high and reads and writes must wait. A START
// behind a STOP, which has reset the core meanwhile, gives all of them anew.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module rt_machine (
    input  wire        clk,
    input  wire        rst,
    // from rt_control
    output wire        busy_o,          // no access now
    input  wire [3:0]  write_i,         // a bit for each byte
    input  wire [6:0]  write_addr_i,
    input  wire [31:0] write_data_i,
    input  wire [6:0]  read_addr_i,
    output wire [31:0] read_data_o,     // in the same cycle
    // from rt_run
    input  wire        load_i,          // give all to the core
    output wire        loading_o,
    // to the core
    output wire        cfg_valid_o,
    output wire [6:0]  cfg_addr_o,
    output wire [31:0] cfg_data_o
);
    localparam [6:0] LAST = `RT_N_REGS - 1;
    reg        clear_q, load_q;
    reg  [6:0] at_q;
    assign busy_o      = clear_q || load_q;
    assign loading_o   = load_q;
    assign cfg_valid_o = load_q && !clear_q;
    assign cfg_addr_o  = at_q;
    assign cfg_data_o  = read_data_o;
    always @(posedge clk) begin
        at_q <= clear_q || (load_q && !load_i) ? at_q + 1'b1 : 7'd0;
        if (&at_q) clear_q <= 1'b0;
        if (at_q == LAST && !clear_q) load_q <= 1'b0;
        if (load_i) load_q <= 1'b1;
        if (rst) begin
            clear_q <= 1'b1;
            load_q  <= 1'b0;
            at_q    <= 7'd0;
        end
    end
    genvar b;
    generate
        for (b = 0; b < 4; b = b + 1) begin : g_byte
            rt_slot_file #(.WIDTH(8), .SLOTS(128)) u_byte (
                .clk(clk), .wr_en_i(clear_q || (write_i[b] && !busy_o)),
                .wr_addr_i(clear_q ? at_q : write_addr_i),
                .wr_data_i(clear_q ? 8'd0 : write_data_i[8*b +: 8]),
                .rd_addr_i(load_q ? at_q : read_addr_i), .rd_data_o(read_data_o[8*b +: 8])
            );
        end
    endgenerate
endmodule
`default_nettype wire
