// f_control.v - proof of rt_control: rules of AXI4-Lite; settings and what was built are read
// SPDX-License-Identifier: Apache-2.0
// Followed are one setting, any of the list, and one offset that no register has. The processor
// asks in any clock, address and data of a write in any order; rt_machine and rt_totals are busy at
// any time.
`include "axi_rules.vh"
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_top.vh"
module f_control #(
    parameter LAYERS = 0,
    parameter ADDR = 32,
    parameter BUILD = 0
) (
    input wire         clk,
    input wire         rst,
    input wire         awvalid,
    input wire [11:0]  awaddr,
    input wire         wvalid,
    input wire [31:0]  wdata,
    input wire [3:0]   wstrb,
    input wire         bready,
    input wire         arvalid,
    input wire [11:0]  araddr,
    input wire         rready,
    input wire [127:0] built,
    input wire [31:0]  status,
    input wire [63:0]  build,
    input wire [21:0]  errors,
    input wire [3:0]   happened,
    input wire         good,
    input wire [31:0]  machine_data,
    input wire         machine_busy,
    input wire [31:0]  count_data,
    input wire         count_busy
);
    localparam ALL = `RT_TOP_SETTINGS, OTHERS = `RT_TOP_OTHERS;
    localparam [ALL-1:0] THERE = ~(`RT_TOP_SETTINGS_OF_LAYERS & {ALL{LAYERS == 0}} |
                                   `RT_TOP_SETTINGS_OF_ADDR & {ALL{ADDR == 32}} |
                                   `RT_TOP_SETTINGS_OF_BUILD & {ALL{BUILD == 0}});
    localparam [OTHERS-1:0] OTHERS_THERE = ~(`RT_TOP_OTHERS_OF_BUILD & {OTHERS{BUILD == 0}});
    localparam [32*ALL-1:0] RESET = `RT_TOP_SETTINGS_RESET;
    localparam [32*ALL-1:0] KEPT = `RT_TOP_SETTINGS_KEPT & ~{{32*ALL-5{1'b0}}, BUILD == 0, 4'd0};
    localparam [12*ALL-1:0] AT = `RT_TOP_SETTINGS_AT;
    localparam [12*OTHERS-1:0]   OTHERS_AT = `RT_TOP_OTHERS_AT;
    wire awready, wready, bvalid, arready, rvalid, irq, busy;
    wire [1:0]  bresp, rresp;
    wire [31:0] rdata;
    wire [7:0]  order;
    wire [3:0]  machine_write;
    wire [32*ALL-1:0] settings;
    rt_control #(.LAYERS(LAYERS), .ADDR(ADDR), .BUILD(BUILD)) u_dut (
        .clk(clk), .rst(rst), .s_awvalid(awvalid), .s_awready(awready), .s_awaddr(awaddr),
        .s_wvalid(wvalid), .s_wready(wready), .s_wdata(wdata), .s_wstrb(wstrb),
        .s_bvalid(bvalid), .s_bready(bready), .s_bresp(bresp), .s_arvalid(arvalid),
        .s_arready(arready), .s_araddr(araddr), .s_rvalid(rvalid), .s_rready(rready),
        .s_rdata(rdata), .s_rresp(rresp), .irq_o(irq), .busy_o(busy), .built_i(built),
        .status_i(status), .build_i(build),
        .errors_i(errors), .happened_i(happened), .good_i(good), .order_o(order),
        .settings_o(settings), .machine_write_o(machine_write), .write_addr_o(),
        .write_data_o(), .read_addr_o(), .machine_data_i(machine_data),
        .machine_busy_i(machine_busy), .count_data_i(count_data), .count_busy_i(count_busy)
    );
    axi_lite_rules u_rules (
        .clk(clk), .rst(rst), .awvalid(awvalid), .awready(awready), .wvalid(wvalid),
        .wready(wready), .bvalid(bvalid), .bready(bready), .bresp(bresp), .arvalid(arvalid),
        .arready(arready), .rvalid(rvalid), .rready(rready), .rdata(rdata), .rresp(rresp)
    );
    (* hierconn *) wire        \u_rules.aw_q , \u_rules.w_q , \u_rules.ar_q ;
    (* hierconn *) wire        \u_rules.b_wait_q , \u_rules.r_wait_q ;
    (* hierconn *) wire [21:0] \u_dut.errors_q ;
    (* hierconn *) wire [4:0]  \u_dut.happened_q ;
    (* hierconn *) wire [31:0] \u_dut.frames_q ;
    (* hierconn *) wire        \u_dut.aw_errors_q , \u_dut.aw_interrupts_q ;
    (* hierconn *) wire        \u_dut.aw_full_q ;
    (* hierconn *) wire        \u_dut.w_full_q ;
    (* hierconn *) wire        \u_dut.aw_seen_q ;
    (* hierconn *) wire        \u_dut.ar_full_q , \u_dut.ar_seen_q , \u_dut.ar_free_q ;
    (* hierconn *) wire [9:0]  \u_dut.aw_q ;
    (* hierconn *) wire [9:0]  \u_dut.ar_q ;
    (* hierconn *) wire [31:0] \u_dut.w_q ;
    (* hierconn *) wire [3:0]  \u_dut.strobe_q ;
    (* hierconn *) wire [OTHERS+ALL:0] \u_dut.aw_is_q , \u_dut.ar_is_q ;
    (* hierconn *) wire        \u_dut.aw_machine_q , \u_dut.aw_control_q ;
    (* hierconn *) wire        \u_dut.ar_machine_q , \u_dut.ar_count_q ;

    // ---- what an address selects ----
    function machine(input [11:0] at);
        machine = at >= `RT_TOP_MACHINE && at < `RT_TOP_COUNTERS;
    endfunction
    function counter(input [11:0] at);
        counter = at >= `RT_TOP_COUNTERS && at < `RT_TOP_COUNTERS + 8*`RT_TOP_COUNTS;
    endfunction
    function [OTHERS+ALL:0] selected(input [11:0] at);
        integer n;
        begin
            selected[OTHERS+ALL] = counter(at) ||
                                   (machine(at) && at < `RT_TOP_MACHINE + 4*`RT_N_REGS);
            for (n = 0; n < ALL; n = n + 1) selected[n] = THERE[n] && at == AT[12*n +: 12];
            for (n = 0; n < OTHERS; n = n + 1)
                selected[ALL+n] = OTHERS_THERE[n] && at == OTHERS_AT[12*n +: 12];
        end
    endfunction

    // ---- model: what the slave took and did not answer ----
    reg         old_q = 1'b0, aw_q, w_q, ar_q;
    reg  [9:0]  aw_addr_q, ar_addr_q;
    reg  [31:0] data_q;
    reg  [3:0]  strobe_q;
    wire        to_machine = machine({aw_addr_q, 2'd0});
    reg         aw_seen_q;                       // there in the clock before, too
    wire        does  = aw_seen_q && w_q && !bvalid && !(to_machine && machine_busy);
    wire [11:0] from  = {ar_addr_q, 2'd0};
    wire        free  = !(machine(from) && machine_busy) && !(counter(from) && count_busy);
    reg         seen_q, free_q;                  // there in the clock before; then free, too
    wire        reads = free_q && !rvalid && free;
    reg         did_q, read_q;

    // ---- one setting, and an offset of nothing ----
    (* anyconst *) wire [4:0]  number;
    (* anyconst *) wire [11:0] nowhere;
    wire [11:0] place = AT[12*number +: 12];
    wire [31:0] keep  = {{8{strobe_q[3]}}, {8{strobe_q[2]}}, {8{strobe_q[1]}}, {8{strobe_q[0]}}};
    reg  [31:0] value_q, was_q;
    wire        known = |selected(nowhere);

    // ---- what happened: a bit that is set in the clock of its clearing stays ----
    wire        anew = order[`RT_TOP_CONTROL_SOFT_RESET];
    wire [11:0] to   = {aw_addr_q, 2'd0};
    wire [31:0] ones = data_q & keep;
    wire [21:0] errors_after = errors |
        (errors_m & ~(does && to == `RT_TOP_ERRORS ? ones[21:0] : 22'd0));
    wire [4:0]  happened_after = {happened[3], |errors, happened[2:0]} |
        (happened_m & ~(does && to == `RT_TOP_INTERRUPTS ? ones[4:0] : 5'd0));
    reg  [21:0] errors_m;
    reg  [4:0]  happened_m;
    reg  [31:0] frames_m, happened_was_q;
    reg  [7:0]  order_m;
    reg         read_happened_q;

    wire       b_wait_q = \u_rules.b_wait_q ;
    wire       r_wait_q = \u_rules.r_wait_q ;
    reg        at_nowhere_q, read_place_q, read_nowhere_q, read_built_q;
    reg [31:0] built_q;
    wire [2:0] word = from[4:2] - 3'd2;          // of what the block was built with
    always @(posedge clk) begin
        old_q <= 1'b1;
        if (awvalid && awready) {aw_q, aw_addr_q} <= {1'b1, awaddr[11:2]};
        if (wvalid && wready) {w_q, data_q, strobe_q} <= {1'b1, wdata, wstrb};
        if (arvalid && arready) {ar_q, ar_addr_q} <= {1'b1, araddr[11:2]};
        if (does) {aw_q, w_q} <= 2'd0;
        if (reads) ar_q <= 1'b0;
        aw_seen_q <= aw_q && !does && !rst;
        seen_q <= ar_q && !reads && !rst;
        free_q <= seen_q && free && !reads && !rst;
        if (does && {aw_addr_q, 2'd0} == place)
            value_q <= ((value_q & ~keep) | (data_q & keep)) & KEPT[32*number +: 32];
        was_q    <= value_q;
        did_q    <= does && !rst;
        read_q   <= reads && !rst;
        errors_m   <= rst || anew ? 22'd0 : errors_after & {{6{BUILD != 0}}, 16'hffff};
        happened_m <= rst || anew ? 5'd0 : happened_after & {BUILD != 0, 4'hf};
        frames_m   <= rst || anew ? 32'd0 : frames_m + good;
        order_m    <= does && to == `RT_TOP_CONTROL && !rst ? ones[7:0] & {BUILD != 0, 7'h7f}
                                                            : 8'd0;
        happened_was_q  <= from == `RT_TOP_ERRORS ? {10'd0, errors_m}
                           : from == `RT_TOP_FRAME_COUNT ? frames_m : {27'd0, happened_m};
        read_happened_q <= from == `RT_TOP_ERRORS || from == `RT_TOP_INTERRUPTS ||
                           from == `RT_TOP_FRAME_COUNT;
        at_nowhere_q   <= {aw_addr_q, 2'd0} == nowhere;
        read_place_q   <= from == place;
        read_nowhere_q <= from == nowhere;
        read_built_q   <= from >= `RT_TOP_CORE_PROFILE && from <= `RT_TOP_CORE_BUS;
        built_q        <= built[32*word[1:0] +: 32];
        if (rst) {aw_q, w_q, value_q} <= {2'd0, RESET[32*number +: 32]};
        if (rst) ar_q <= 1'b0;
    end
    always @* begin
        if (!old_q) assume (rst);
        assume (number < ALL && THERE[number] && nowhere[1:0] == 0 && !known);
    end

    always @* if (old_q) begin
        if (bvalid && !b_wait_q) assert (did_q);                          // no answer unasked
        if (rvalid && !r_wait_q) assert (read_q);
        if (did_q) assert (bvalid && bresp == (at_nowhere_q ? 2'b10 : bresp));
        if (rvalid && !r_wait_q && read_nowhere_q) assert (rresp == 2'b10 && rdata == 0);
        if (rvalid && !r_wait_q && read_place_q) assert (rresp == 2'b00 && rdata == was_q);
        if (rvalid && !r_wait_q && read_built_q) assert (rresp == 2'b00 && rdata == built_q);
        if (read_q) assert (rvalid);                                      // never stuck
        assert (busy == (aw_q || w_q || ar_q || bvalid || rvalid));
        assert (settings[32*number +: 32] == value_q);                    // as it was written
        assert (order == order_m);                                        // with the answer
        if (rvalid && !r_wait_q && read_happened_q)
            assert (rresp == 2'b00 && rdata == happened_was_q);
        if (machine_write != 0) assert (does && to_machine);
        assert (irq == |(happened_m & settings[`RT_TOP_SET_INTERRUPT_ENABLE_SOURCES]));
        // invariant
        assert (\u_dut.errors_q == errors_m && \u_dut.happened_q == happened_m);
        assert (\u_dut.frames_q == frames_m);
        assert (\u_rules.aw_q == (aw_q || did_q) && \u_rules.w_q == (w_q || did_q));
        assert (\u_rules.ar_q == (ar_q || read_q));
        if (did_q) assert (!aw_q && !w_q);
        if (read_q) assert (!ar_q);
        assert (did_q == (bvalid && !b_wait_q) && read_q == (rvalid && !r_wait_q));
        assert (\u_dut.aw_full_q == aw_q && \u_dut.w_full_q == w_q);
        if (aw_q) assert (\u_dut.aw_q == aw_addr_q);
        if (w_q) assert (\u_dut.w_q == data_q && \u_dut.strobe_q == strobe_q);
        assert (\u_dut.aw_seen_q == aw_seen_q && (aw_q || !aw_seen_q));
        if (aw_seen_q)
            assert (\u_dut.aw_is_q == selected({aw_addr_q, 2'd0}) &&
                    \u_dut.aw_machine_q == to_machine &&
                    \u_dut.aw_errors_q == (to == `RT_TOP_ERRORS) &&
                    \u_dut.aw_interrupts_q == (to == `RT_TOP_INTERRUPTS) &&
                    \u_dut.aw_control_q == ({aw_addr_q, 2'd0} == `RT_TOP_CONTROL));
        assert (\u_dut.ar_full_q == ar_q && \u_dut.ar_seen_q == seen_q && (ar_q || !seen_q));
        assert (\u_dut.ar_free_q == free_q && (seen_q || !free_q));
        if (ar_q) assert (\u_dut.ar_q == ar_addr_q);
        if (seen_q)
            assert (\u_dut.ar_is_q == selected(from) && \u_dut.ar_machine_q == machine(from) &&
                    \u_dut.ar_count_q == counter(from));
    end
endmodule
`default_nettype wire
