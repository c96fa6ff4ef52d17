// rt_control.v - AXI4-Lite slave: the registers of rt_top
// SPDX-License-Identifier: Apache-2.0
// One write and one read at a time; addresses and data of a write may come in any order. A strobe
// that is low leaves its byte as it is. An offset without a register is answered with SLVERR and
// does nothing. Accesses to registers of the machine wait while rt_machine is busy, those to
// counters while a snapshot is taken. The list of registers: cmodel/machine/top.def
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_top.vh"
module rt_control #(
    parameter LAYERS = 0,               // 1: the registers that rt_top has with it alone
    parameter ADDR   = 32               // above 32: those that it has then
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
    // what happens
    input  wire [15:0] errors_i,        // bits of ERRORS that are set now
    input  wire [2:0]  happened_i,      // bits of INTERRUPTS but ERROR
    input  wire        good_i,          // a frame is complete
    // orders, settings
    output reg  [6:0]  order_o,         // bits of CONTROL, for one cycle
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
    localparam [ALL-1:0] THERE = ~((LAYERS != 0 ? {ALL{1'b0}} : `RT_TOP_SETTINGS_OF_LAYERS) |
                                   (ADDR > 32 ? {ALL{1'b0}} : `RT_TOP_SETTINGS_OF_ADDR));
    localparam [32*ALL-1:0] RESET = `RT_TOP_SETTINGS_RESET;
    localparam [32*ALL-1:0] KEPT = `RT_TOP_SETTINGS_KEPT;
    localparam [12*ALL-1:0] AT = `RT_TOP_SETTINGS_AT;
    localparam OTHERS = `RT_TOP_OTHERS;
    localparam [12*OTHERS-1:0] OTHERS_AT = `RT_TOP_OTHERS_AT;
    localparam [6:0] REGS = `RT_N_REGS;
    localparam [11:0] COUNTERS_END = `RT_TOP_COUNTERS + 8*`RT_TOP_COUNTS;

    // ---- a write: address and data are kept until both are there and it can be done ----
    reg         aw_full_q, w_full_q;
    reg  [11:2] aw_q;
    reg  [31:0] w_q;
    reg  [3:0]  strobe_q;
    wire [11:0] w_addr = {aw_q, 2'd0};
    wire        aw_machine = w_addr >= `RT_TOP_MACHINE && w_addr < `RT_TOP_COUNTERS;
    wire        aw_count   = w_addr >= `RT_TOP_COUNTERS && w_addr < COUNTERS_END;
    wire        write = aw_full_q && w_full_q && !s_bvalid && !(aw_machine && machine_busy_i);
    wire [31:0] keep  = {{8{strobe_q[3]}}, {8{strobe_q[2]}}, {8{strobe_q[1]}}, {8{strobe_q[0]}}};
    wire [31:0] ones  = w_q & keep;                // of registers that act on a one
    assign s_awready  = !aw_full_q;
    assign s_wready   = !w_full_q;
    reg  [31:0] read_value;
    reg  [1:0]  known;                             // {read, write}: there is such a register
    always @(posedge clk) begin
        if (s_awready) {aw_full_q, aw_q} <= {s_awvalid, s_awaddr[11:2]};
        if (s_wready)  {w_full_q, w_q, strobe_q} <= {s_wvalid, s_wdata, s_wstrb};
        if (s_bready)  s_bvalid <= 1'b0;
        if (write) begin
            {aw_full_q, w_full_q} <= 2'd0;
            s_bvalid <= 1'b1;
            s_bresp  <= known[0] ? 2'b00 : 2'b10;
        end
        if (rst) {aw_full_q, w_full_q, s_bvalid} <= 3'd0;
    end
    assign machine_write_o = write && aw_machine && aw_q[8:2] < REGS ? strobe_q : 4'd0;
    assign write_addr_o    = aw_q[8:2];
    assign write_data_o    = w_q;
    always @(posedge clk)              // from a register, as the answer: it reaches far
        order_o <= write && w_addr == `RT_TOP_CONTROL && !rst ? ones[6:0] : 7'd0;

    // ---- a read ----
    reg         ar_full_q;
    reg  [11:2] ar_q;
    wire [11:0] r_addr = {ar_q, 2'd0};
    wire        ar_machine = r_addr >= `RT_TOP_MACHINE && r_addr < `RT_TOP_COUNTERS;
    wire        ar_count   = r_addr >= `RT_TOP_COUNTERS && r_addr < COUNTERS_END;
    wire        read = ar_full_q && !s_rvalid && !(ar_machine && machine_busy_i) &&
                       !(ar_count && count_busy_i);
    assign s_arready   = !ar_full_q;
    assign read_addr_o = ar_q[8:2];
    always @(posedge clk) begin
        if (s_arready) {ar_full_q, ar_q} <= {s_arvalid, s_araddr[11:2]};
        if (s_rready)  s_rvalid <= 1'b0;
        if (read) begin
            ar_full_q <= 1'b0;
            s_rvalid  <= 1'b1;
            s_rdata   <= known[1] ? read_value : 32'd0;
            s_rresp   <= known[1] ? 2'b00 : 2'b10;
        end
        if (rst) {ar_full_q, s_rvalid} <= 2'd0;
    end

    // ---- settings: read-write registers, one behind the other ----
    genvar i;
    generate
        for (i = 0; i < ALL; i = i + 1) begin : g_setting
            if (THERE[i]) begin : g_there
                reg [31:0] value_q;
                always @(posedge clk) begin
                    if (write && w_addr == AT[12*i +: 12])
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
    reg  [15:0] errors_q;
    reg  [3:0]  happened_q;
    reg  [31:0] frames_q;
    always @(posedge clk) begin
        errors_q   <= (errors_q & ~(write && w_addr == `RT_TOP_ERRORS ? ones[15:0] : 16'd0)) |
                      errors_i;
        happened_q <= (happened_q & ~(write && w_addr == `RT_TOP_INTERRUPTS ? ones[3:0] : 4'd0)) |
                      {errors_i != 16'd0, happened_i};
        frames_q   <= frames_q + {31'd0, good_i};
        if (rst || order_o[`RT_TOP_CONTROL_SOFT_RESET]) begin
            errors_q   <= 16'd0;
            happened_q <= 4'd0;
            frames_q   <= 32'd0;
        end
    end
    assign irq_o = (happened_q & settings_o[`RT_TOP_SET_INTERRUPT_ENABLE_SOURCES]) != 4'd0;

    // ---- values ----
    integer k;
    always @* begin
        known = {ar_count || (ar_machine && ar_q[8:2] < REGS),
                 aw_count || (aw_machine && aw_q[8:2] < REGS)};
        for (k = 0; k < OTHERS; k = k + 1)
            known = known | {r_addr == OTHERS_AT[12*k +: 12], w_addr == OTHERS_AT[12*k +: 12]};
        case (r_addr)
            `RT_TOP_ID:           read_value = `RT_TOP_ID_RESET;
            `RT_TOP_VERSION:      read_value = `RT_TOP_VERSION_RESET;
            `RT_TOP_CORE_PROFILE: read_value = built_i[0 +: 32];
            `RT_TOP_CORE_EFFECTS: read_value = built_i[32 +: 32];
            `RT_TOP_CORE_PARTS:   read_value = built_i[64 +: 32];
            `RT_TOP_CORE_BUS:     read_value = built_i[96 +: 32];
            `RT_TOP_CONTROL:      read_value = 32'd0;
            `RT_TOP_STATUS:       read_value = status_i;
            `RT_TOP_FRAME_COUNT:  read_value = frames_q;
            `RT_TOP_ERRORS:       read_value = {16'd0, errors_q};
            `RT_TOP_INTERRUPTS:   read_value = {28'd0, happened_q};
            default:              read_value = ar_count ? count_data_i : machine_data_i;
        endcase
        for (k = 0; k < ALL; k = k + 1) if (THERE[k]) begin
            known = known | {r_addr == AT[12*k +: 12], w_addr == AT[12*k +: 12]};
            if (r_addr == AT[12*k +: 12]) read_value = settings_o[32*k +: 32];
        end
    end
    assign busy_o = aw_full_q || w_full_q || s_bvalid || ar_full_q || s_rvalid;
    wire unused = &{1'b0, s_awaddr[1:0], s_araddr[1:0]};
endmodule
`default_nettype wire
