// rt_sdram.v - controller of an SDRAM of 4 banks x 8192 rows x 512 columns x 16 bits: 32 MB
// SPDX-License-Identifier: Apache-2.0
//   word of 64 bits: row 21..9, bank 8..7, column 6..0 and two zeros; a burst of four each
//   closed bank: ACTIVATE; another row: PRECHARGE, ACTIVATE; this row: READ or WRITE, 4 clocks each
// Rows stay open until another one of their bank is asked for, or a refresh is due. A read's word
// is there RCD + 8 clocks after it was taken in a closed bank, 8 clocks after that in an open one.
// All pins are registers. Times are in clocks of 16 ns (62.5 MHz), for parts of grade 7 or 75:
// tRCD, tRP 20 ns, tRAS 44, tRC and tRFC 66, tWR 15, a refresh each 7.8 us, 200 us of power.
`timescale 1ns / 1ps
`default_nettype none
module rt_sdram #(
    parameter RCD     = 2,                // ACTIVATE to READ or WRITE, 2..7
    parameter RP      = 2,                // PRECHARGE to ACTIVATE or REFRESH, 2..7
    parameter RAS     = 3,                // ACTIVATE to PRECHARGE, 2..7
    parameter RFC     = 5,                // REFRESH to anything, 2..15
    parameter WR      = 2,                // last word written to PRECHARGE, 1..7
    parameter REFRESH = 480,              // clocks between two of them, less what one may wait
    parameter POWER   = 12500,            // clocks before the first command
    parameter INPUT   = 0                 // registers between the pins and dq_i, 0..2
) (
    input  wire        clk,
    input  wire        rst,
    // words
    input  wire        cmd_valid_i,
    output wire        cmd_ready_o,
    input  wire        cmd_write_i,
    input  wire [21:0] cmd_addr_i,        // number of the word
    input  wire [63:0] cmd_data_i,        // of a write
    input  wire [7:0]  cmd_strb_i,        // bytes that are written
    output reg         rsp_valid_o,       // of reads, in order; it does not wait
    output reg  [63:0] rsp_data_o,
    // pins
    output reg         cke_o,
    output reg  [3:0]  command_o,         // cs_n, ras_n, cas_n, we_n
    output reg  [1:0]  ba_o,
    output reg  [12:0] a_o,
    output wire [1:0]  dqm_o,
    output wire [15:0] dq_o,
    output reg         dq_oe_o,
    input  wire [15:0] dq_i
);
    localparam [3:0] NOP = 4'b0111, ACTIVATE = 4'b0011, READ = 4'b0101, WRITE = 4'b0100,
                     PRECHARGE = 4'b0010, AUTO = 4'b0001, MODE = 4'b0000;
    localparam [12:0] MODE_BITS = 13'b000_0_00_010_0_010; // CAS latency 2, sequential, 4 words
    localparam [31:0] N_RCD = RCD - 1, N_RP = RP - 1, N_RAS = RAS - 1, N_RFC = RFC - 1,
                      N_WRITE = 3 + WR - 1, N_REFRESH = REFRESH - 1, N_POWER = POWER;

    // ---- clocks until something may be done ----
    reg  [3:0]  any_q;                    // any command
    reg  [3:0]  read_q, write_q, pre_q;   // one of these
    reg  [15:0] due_q;                    // a refresh; at power-up: the first command
    wire        due = due_q == 16'd0;

    // ---- the next command ----
    reg  [3:0]  start_q;                  // steps of power-up left: precharge, 8 refreshes, mode
    reg  [3:0]  open_q;                   // banks with an open row
    reg  [3:0]  next;
    wire [1:0]  bank = cmd_addr_i[8:7];
    wire [12:0] row  = cmd_addr_i[21:9];
    wire [12:0] open_row;
    wire        hit  = open_q[bank] && open_row == row;
    rt_slot_file #(.WIDTH(13), .SLOTS(4)) u_rows (
        .clk(clk), .wr_en_i(next == ACTIVATE), .wr_addr_i(bank), .wr_data_i(row), .rd_addr_i(bank),
        .rd_data_o(open_row)
    );
    always @* begin
        next = NOP;
        if (any_q == 4'd0) begin
            if (start_q != 4'd0) begin
                if (start_q == 4'd10) next = due ? PRECHARGE : NOP;
                else next = start_q == 4'd1 ? MODE : AUTO;
            end else if (due) begin
                if (open_q == 4'd0) next = AUTO;
                else if (pre_q == 4'd0) next = PRECHARGE;
            end else if (cmd_valid_i) begin
                if (!open_q[bank]) next = ACTIVATE;
                else if (!hit) next = pre_q == 4'd0 ? PRECHARGE : NOP;
                else if (cmd_write_i) next = write_q == 4'd0 ? WRITE : NOP;
                else next = read_q == 4'd0 ? READ : NOP;
            end
        end
    end
    wire all = start_q != 4'd0 || due;    // PRECHARGE of all banks
    assign cmd_ready_o = next == READ || next == WRITE;

    // ---- pins of the command, and what it makes others wait ----
    always @(posedge clk) begin
        cke_o     <= 1'b1;
        command_o <= next;
        ba_o      <= next == MODE ? 2'd0 : bank;
        a_o       <= next == MODE ? MODE_BITS :
                     next == PRECHARGE ? {2'd0, all, 10'd0} :
                     next == ACTIVATE ? row : {4'd0, cmd_addr_i[6:0], 2'd0};
        if (any_q != 4'd0)   any_q   <= any_q - 4'd1;
        if (read_q != 4'd0)  read_q  <= read_q - 4'd1;
        if (write_q != 4'd0) write_q <= write_q - 4'd1;
        if (pre_q != 4'd0)   pre_q   <= pre_q - 4'd1;
        if (!due) due_q <= due_q - 16'd1;
        case (next)
            ACTIVATE: begin
                any_q        <= N_RCD[3:0];
                if (pre_q < N_RAS[3:0] + 4'd1) pre_q <= N_RAS[3:0];
                open_q[bank] <= 1'b1;
            end
            PRECHARGE: begin
                any_q  <= N_RP[3:0];
                open_q <= all ? 4'd0 : open_q & ~(4'd1 << bank);
            end
            AUTO: begin
                any_q <= N_RFC[3:0];
                due_q <= N_REFRESH[15:0];
            end
            MODE: any_q <= 4'd1;
            READ: begin                   // the pins are free of it CL + 4 clocks later
                read_q  <= 4'd3;
                write_q <= 4'd6;
                if (pre_q < 4'd4) pre_q <= 4'd3;
            end
            WRITE: begin
                read_q  <= 4'd3;
                write_q <= 4'd3;
                if (pre_q < N_WRITE[3:0] + 4'd1) pre_q <= N_WRITE[3:0];
            end
            default: ;
        endcase
        if (start_q != 4'd0 && next != NOP) start_q <= start_q - 4'd1;
        if (rst) begin
            cke_o     <= 1'b0;
            command_o <= NOP;
            start_q   <= 4'd10;
            open_q    <= 4'd0;
            due_q     <= N_POWER[15:0];
            any_q     <= 4'd0;
            read_q    <= 4'd0;
            write_q   <= 4'd0;
            pre_q     <= 4'd0;
        end
    end

    // ---- words out: four in a row, from the command on; masks are of writes alone ----
    reg [63:0] out_q;
    reg [7:0]  mask_q;
    reg [1:0]  left_q;
    assign dq_o  = out_q[15:0];
    assign dqm_o = mask_q[1:0];
    always @(posedge clk) begin
        out_q   <= next == WRITE ? cmd_data_i : out_q >> 16;
        mask_q  <= next == WRITE ? ~cmd_strb_i : mask_q >> 2;
        left_q  <= next == WRITE ? 2'd3 : left_q - {1'b0, left_q != 2'd0};
        dq_oe_o <= next == WRITE || left_q != 2'd0;
        if (rst) begin
            mask_q  <= 8'd0;
            left_q  <= 2'd0;
            dq_oe_o <= 1'b0;
        end
    end

    // ---- words in: the first three clocks after the READ's pins, then one a clock ----
    localparam LAST = 5 + INPUT;
    reg [LAST:0] pipe_q;
    reg [47:0]   in_q;
    always @(posedge clk) begin
        pipe_q      <= {pipe_q[LAST-1:0], next == READ};
        in_q        <= {dq_i, in_q[47:16]};
        rsp_valid_o <= pipe_q[LAST];
        if (pipe_q[LAST]) rsp_data_o <= {dq_i, in_q};
        if (rst) begin
            pipe_q      <= {(LAST+1){1'b0}};
            rsp_valid_o <= 1'b0;
        end
    end
    wire unused = &{1'b0, N_RCD, N_RP, N_RAS, N_RFC, N_WRITE, N_REFRESH, N_POWER};
endmodule
`default_nettype wire
