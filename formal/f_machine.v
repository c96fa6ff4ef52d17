// f_machine.v - proof of rt_machine: a register reads as it was written; a START gives each once
// SPDX-License-Identifier: Apache-2.0
// Followed is one register, which the solver chooses. Writes and reads come in any clock, those
// that do not wait for busy_o too; a START may come while one is followed, behind a STOP.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module f_machine (
    input wire        clk,
    input wire        rst,
    input wire [3:0]  write,
    input wire [6:0]  write_addr,
    input wire [31:0] write_data,
    input wire [6:0]  read_addr,
    input wire        load
);
    localparam [7:0] LAST = `RT_N_REGS - 1;
    wire busy, loading, cfg_valid;
    wire [6:0]  cfg_addr;
    wire [31:0] read_data, cfg_data;
    rt_machine u_dut (
        .clk(clk), .rst(rst), .busy_o(busy), .write_i(write), .write_addr_i(write_addr),
        .write_data_i(write_data), .read_addr_i(read_addr), .read_data_o(read_data),
        .load_i(load), .loading_o(loading), .cfg_valid_o(cfg_valid), .cfg_addr_o(cfg_addr),
        .cfg_data_o(cfg_data)
    );
    (* hierconn *) wire       \u_dut.clear_q ;
    (* hierconn *) wire       \u_dut.load_q ;
    (* hierconn *) wire [6:0] \u_dut.at_q ;
    (* hierconn *) wire [6:0] \u_dut.g_byte[0].u_byte.mark ;
    (* hierconn *) wire [6:0] \u_dut.g_byte[1].u_byte.mark ;
    (* hierconn *) wire [6:0] \u_dut.g_byte[2].u_byte.mark ;
    (* hierconn *) wire [6:0] \u_dut.g_byte[3].u_byte.mark ;
    (* hierconn *) wire [7:0] \u_dut.g_byte[0].u_byte.word_q ;
    (* hierconn *) wire [7:0] \u_dut.g_byte[1].u_byte.word_q ;
    (* hierconn *) wire [7:0] \u_dut.g_byte[2].u_byte.word_q ;
    (* hierconn *) wire [7:0] \u_dut.g_byte[3].u_byte.word_q ;

    // ---- model: the register, clocks since rst and since the START, whether it was given ----
    wire [6:0] me = \u_dut.g_byte[0].u_byte.mark ;
    wire [31:0] held = {\u_dut.g_byte[3].u_byte.word_q , \u_dut.g_byte[2].u_byte.word_q ,
                        \u_dut.g_byte[1].u_byte.word_q , \u_dut.g_byte[0].u_byte.word_q };
    reg        old_q = 1'b0, given_q, load_q;
    reg [7:0]  clear_q, step_q;           // 128: no longer; N_REGS: no longer
    reg [31:0] value_q;
    wire       clear = !clear_q[7];
    integer i;
    always @(posedge clk) begin
        old_q <= 1'b1;
        if (clear) clear_q <= clear_q + 1;
        for (i = 0; i < 4; i = i + 1)
            if (write[i] && !busy && write_addr == me) value_q[8*i +: 8] <= write_data[8*i +: 8];
        if (step_q <= LAST && !clear) step_q <= step_q + 1;
        if (load) step_q <= 0;
        given_q <= !load && (given_q || (cfg_valid && cfg_addr == me));
        load_q  <= load;
        if (rst) {clear_q, step_q, value_q, load_q} <= {8'd0, LAST + 8'd1, 32'd0, 1'b0};
    end
    always @* begin
        if (!old_q) assume (rst);
        assume (\u_dut.g_byte[1].u_byte.mark == me && \u_dut.g_byte[2].u_byte.mark == me);
        assume (\u_dut.g_byte[3].u_byte.mark == me);
    end

    always @* if (old_q) begin
        assert (busy == (clear || step_q <= LAST));              // 128 clocks, and N_REGS
        assert (loading == (step_q <= LAST) && cfg_valid == (loading && !clear));
        if (cfg_valid) assert (cfg_addr == step_q);              // all of them, in order
        if (cfg_valid && cfg_addr == me) assert (cfg_data == value_q && !given_q);
        if (!busy && read_addr == me) assert (read_data == value_q);
        // invariant
        assert (\u_dut.clear_q == clear && \u_dut.load_q == loading);
        assert (clear_q <= 128 && step_q <= LAST + 1);
        if (clear && loading) assert (step_q == 0);
        if (clear) assert (\u_dut.at_q == clear_q && value_q == 0);
        if (!clear || clear_q > me) assert (held == value_q);
        if (loading) assert ((clear || \u_dut.at_q == step_q) && given_q == (step_q > me));
        if (!busy) assert (\u_dut.at_q == 0 || \u_dut.at_q == LAST + 1);
    end
endmodule
`default_nettype wire
