// rt_control.v - AXI4-Lite slave: the registers of rt_top
// SPDX-License-Identifier: Apache-2.0
// One write and one read at a time; addresses and data of a write may come in any order. A strobe
// that is low leaves its byte as it is. An offset without a register is answered with SLVERR and
// does nothing. Accesses to registers of the machine wait while rt_machine is busy, those to
// counters while a snapshot is taken. What an address selects is in registers a clock behind it,
// and a word of theirs a clock behind that. The list of registers: cmodel/machine/top.def
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_top.vh"
module rt_control #(
    parameter LAYERS = 0,               // 1: the registers that rt_top has with it alone
    parameter ADDR   = 32,              // above 32: those that it has then
    parameter BUILD  = 0                // above 0: those of a builder of trees, too
) (
    input  wire        clk,
    input  wire        rst,
    // AXI4-Lite
    input  wire        s_awvalid,
    output wire        s_awready,
    input  wire [11:0] s_awaddr,
    input  wire        s_wvalid,
    output wire        s_wready,
    input  wire [31:0] s_wdata,
    input  wire [3:0]  s_wstrb,
    output reg         s_bvalid,
    input  wire        s_bready,
    output reg  [1:0]  s_bresp,
    input  wire        s_arvalid,
    output wire        s_arready,
    input  wire [11:0] s_araddr,
    output reg         s_rvalid,
    input  wire        s_rready,
    output reg  [31:0] s_rdata,
    output reg  [1:0]  s_rresp,
    output wire        irq_o,           // level
    output wire        busy_o,          // something was taken and not answered
    // what stands in read-only registers
    input  wire [127:0] built_i,        // {CORE_BUS, CORE_PARTS, CORE_EFFECTS, CORE_PROFILE}
    input  wire [31:0] status_i,        // STATUS
    input  wire [63:0] build_i,         // {BUILD_WRITTEN, BUILD_CLOCKS}
    // what happens
    input  wire [21:0] errors_i,        // bits of ERRORS that are set now
    input  wire [3:0]  happened_i,      // bits of INTERRUPTS but ERROR
    input  wire        good_i,          // a frame is complete
    // orders, settings
    output reg  [7:0]  order_o,         // bits of CONTROL, for one cycle
    output wire [32*`RT_TOP_SETTINGS-1:0] settings_o, // read-write registers, from WATCHDOG on
    // to rt_machine and rt_totals
    output wire [3:0]  machine_write_o,
    output wire [6:0]  write_addr_o,
    output wire [31:0] write_data_o,
    output wire [6:0]  read_addr_o,
    input  wire [31:0] machine_data_i,
    input  wire        machine_busy_i,
    input  wire [31:0] count_data_i,
    input  wire        count_busy_i
);
    localparam ALL = `RT_TOP_SETTINGS;
    localparam OTHERS = `RT_TOP_OTHERS;
    localparam [ALL-1:0] THERE = ~((LAYERS != 0 ? {ALL{1'b0}} : `RT_TOP_SETTINGS_OF_LAYERS) |
                                   (ADDR > 32 ? {ALL{1'b0}} : `RT_TOP_SETTINGS_OF_ADDR) |
                                   (BUILD != 0 ? {ALL{1'b0}} : `RT_TOP_SETTINGS_OF_BUILD));
    localparam [OTHERS-1:0] OTHERS_THERE = ~(BUILD != 0 ? {OTHERS{1'b0}}
                                                        : `RT_TOP_OTHERS_OF_BUILD);
    localparam [21:0] ERRORS_THERE = {{6{BUILD != 0}}, 16'hffff};
    localparam [7:0] ORDERS_THERE = {BUILD != 0, 7'h7f};
    localparam [4:0] HAPPENED_THERE = {BUILD != 0, 4'hf};
    localparam [32*ALL-1:0] RESET = `RT_TOP_SETTINGS_RESET;
    localparam [32*ALL-1:0] KEPT = `RT_TOP_SETTINGS_KEPT &
                                   ~{{32*ALL-5{1'b0}}, ~HAPPENED_THERE}; // of INTERRUPT_ENABLE
    localparam [12*ALL-1:0] AT = `RT_TOP_SETTINGS_AT;
    localparam [12*OTHERS-1:0] OTHERS_AT = `RT_TOP_OTHERS_AT;
    localparam [6:0] REGS = `RT_N_REGS;
    localparam [11:0] COUNTERS_END = `RT_TOP_COUNTERS + 8*`RT_TOP_COUNTS;

    // ---- what an address selects: {a register of rt_machine or rt_totals, others, settings} ----
    localparam IS = 1 + OTHERS + ALL;
    function at_machine(input [11:2] at);
        at_machine = {at, 2'd0} >= `RT_TOP_MACHINE && {at, 2'd0} < `RT_TOP_COUNTERS;
    endfunction
    function at_count(input [11:2] at);
        at_count = {at, 2'd0} >= `RT_TOP_COUNTERS && {at, 2'd0} < COUNTERS_END;
    endfunction
    function [IS-1:0] selected(input [11:2] at);
        integer n;
        begin
            for (n = 0; n < ALL; n = n + 1)
                selected[n] = THERE[n] && {at, 2'd0} == AT[12*n +: 12];
            for (n = 0; n < OTHERS; n = n + 1)
                selected[ALL+n] = OTHERS_THERE[n] && {at, 2'd0} == OTHERS_AT[12*n +: 12];
            selected[IS-1] = at_count(at) || (at_machine(at) && at[8:2] < REGS);
        end
    endfunction

    // ---- a write: address and data are kept until both are there and it can be done ----
    reg         aw_full_q, w_full_q, aw_seen_q;    // seen: what is selected stands below
    reg  [11:2] aw_q;
    reg  [31:0] w_q;
    reg  [3:0]  strobe_q;
    reg  [IS-1:0] aw_is_q;
    reg         aw_machine_q, aw_control_q, aw_errors_q, aw_interrupts_q;
    wire        write = aw_seen_q && w_full_q && !s_bvalid && !(aw_machine_q && machine_busy_i);
    wire [31:0] keep  = {{8{strobe_q[3]}}, {8{strobe_q[2]}}, {8{strobe_q[1]}}, {8{strobe_q[0]}}};
    wire [31:0] ones  = w_q & keep;                // of registers that act on a one
    assign s_awready  = !aw_full_q;
    assign s_wready   = !w_full_q;
    always @(posedge clk) begin
        if (s_awready) {aw_full_q, aw_q} <= {s_awvalid, s_awaddr[11:2]};
        if (s_wready)  {w_full_q, w_q, strobe_q} <= {s_wvalid, s_wdata, s_wstrb};
        aw_seen_q       <= aw_full_q && !write;
        aw_is_q         <= selected(aw_q);
        aw_machine_q    <= at_machine(aw_q);
        aw_control_q    <= {aw_q, 2'd0} == `RT_TOP_CONTROL;
        aw_errors_q     <= {aw_q, 2'd0} == `RT_TOP_ERRORS;
        aw_interrupts_q <= {aw_q, 2'd0} == `RT_TOP_INTERRUPTS;
        if (s_bready)  s_bvalid <= 1'b0;
        if (write) begin
            {aw_full_q, w_full_q} <= 2'd0;
            s_bvalid <= 1'b1;
            s_bresp  <= |aw_is_q ? 2'b00 : 2'b10;
        end
        if (rst) {aw_full_q, w_full_q, aw_seen_q, s_bvalid} <= 4'd0;
    end
    assign machine_write_o = write && aw_machine_q && aw_is_q[IS-1] ? strobe_q : 4'd0;
    assign write_addr_o    = aw_q[8:2];
    assign write_data_o    = w_q;
    always @(posedge clk)              // from a register, as the answer: it reaches far
        order_o <= write && aw_control_q && !rst ? ones[7:0] & ORDERS_THERE : 8'd0;

    // ---- a read: what others have comes through a register, a clock before the answer ----
    reg         ar_full_q, ar_seen_q, ar_free_q;   // free: elsewhere_q was read while it may be
    reg  [11:2] ar_q;
    reg  [IS-1:0] ar_is_q;
    reg         ar_machine_q, ar_count_q;
    wire        ar_free = !(ar_machine_q && machine_busy_i) && !(ar_count_q && count_busy_i);
    wire        read = ar_free_q && !s_rvalid && ar_free;
    reg  [31:0] elsewhere_q, read_value;
    assign s_arready   = !ar_full_q;
    assign read_addr_o = ar_q[8:2];
    always @(posedge clk) begin
        if (s_arready) {ar_full_q, ar_q} <= {s_arvalid, s_araddr[11:2]};
        ar_seen_q    <= ar_full_q && !read;
        ar_free_q    <= ar_seen_q && ar_free && !read;
        ar_is_q      <= selected(ar_q);
        ar_machine_q <= at_machine(ar_q);
        ar_count_q   <= at_count(ar_q);
        elsewhere_q  <= ar_count_q ? count_data_i : machine_data_i;
        if (s_rready)  s_rvalid <= 1'b0;
        if (read) begin
            ar_full_q <= 1'b0;
            s_rvalid  <= 1'b1;
            s_rdata   <= read_value;
            s_rresp   <= |ar_is_q ? 2'b00 : 2'b10;
        end
        if (rst) {ar_full_q, ar_seen_q, ar_free_q, s_rvalid} <= 4'd0;
    end

    // ---- settings: read-write registers, one behind the other ----
    genvar i;
    generate
        for (i = 0; i < ALL; i = i + 1) begin : g_setting
            if (THERE[i]) begin : g_there
                reg [31:0] value_q;
                always @(posedge clk) begin
                    if (write && aw_is_q[i])
                        value_q <= ((value_q & ~keep) | ones) & KEPT[32*i +: 32];
                    if (rst) value_q <= RESET[32*i +: 32];
                end
                assign settings_o[32*i +: 32] = value_q;
            end else begin : g_none
                assign settings_o[32*i +: 32] = 32'd0;
            end
        end
    endgenerate

    // ---- what happened ----
    reg  [21:0] errors_q;
    reg  [4:0]  happened_q;
    reg  [31:0] frames_q;
    always @(posedge clk) begin
        errors_q   <= ((errors_q & ~(write && aw_errors_q ? ones[21:0] : 22'd0)) |
                       errors_i) & ERRORS_THERE;
        happened_q <= ((happened_q & ~(write && aw_interrupts_q ? ones[4:0] : 5'd0)) |
                       {happened_i[3], errors_i != 22'd0, happened_i[2:0]}) & HAPPENED_THERE;
        frames_q   <= frames_q + {31'd0, good_i};
        if (rst || order_o[`RT_TOP_CONTROL_SOFT_RESET]) begin
            errors_q   <= 22'd0;
            happened_q <= 5'd0;
            frames_q   <= 32'd0;
        end
    end
    assign irq_o = (happened_q & settings_o[`RT_TOP_SET_INTERRUPT_ENABLE_SOURCES]) != 5'd0;

    // ---- values: a register without a word of its own, and none, have 0 ----
    reg  [31:0] word;
    integer k;
    always @* begin
        read_value = ar_is_q[IS-1] ? elsewhere_q : 32'd0;
        for (k = 0; k < OTHERS; k = k + 1) begin
            case (OTHERS_AT[12*k +: 12])
                `RT_TOP_ID:           word = `RT_TOP_ID_RESET;
                `RT_TOP_VERSION:      word = `RT_TOP_VERSION_RESET;
                `RT_TOP_CORE_PROFILE: word = built_i[0 +: 32];
                `RT_TOP_CORE_EFFECTS: word = built_i[32 +: 32];
                `RT_TOP_CORE_PARTS:   word = built_i[64 +: 32];
                `RT_TOP_CORE_BUS:     word = built_i[96 +: 32];
                `RT_TOP_STATUS:       word = status_i;
                `RT_TOP_FRAME_COUNT:  word = frames_q;
                `RT_TOP_ERRORS:       word = {10'd0, errors_q};
                `RT_TOP_INTERRUPTS:   word = {27'd0, happened_q};
                `RT_TOP_BUILD_CLOCKS: word = build_i[0 +: 32];
                `RT_TOP_BUILD_WRITTEN: word = build_i[32 +: 32];
                default:              word = 32'd0;
            endcase
            if (ar_is_q[ALL+k]) read_value = read_value | word;
        end
        for (k = 0; k < ALL; k = k + 1)
            if (ar_is_q[k]) read_value = read_value | settings_o[32*k +: 32];
    end
    assign busy_o = aw_full_q || w_full_q || s_bvalid || ar_full_q || s_rvalid;
    wire unused = &{1'b0, s_awaddr[1:0], s_araddr[1:0]};
endmodule
`default_nettype wire
