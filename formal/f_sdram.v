// f_sdram.v - proof of rt_sdram: times of a bank, a hit is the open row, words as they were given
// SPDX-License-Identifier: Apache-2.0
// Any one bank is followed at the pins, with clocks since each kind of command; the properties are
// those of a datasheet in clocks of the module's parameters. Resets come at any time.
`timescale 1ns / 1ps
`default_nettype none
module f_sdram #(
    parameter RCD     = 2,
    parameter RP      = 2,
    parameter RAS     = 3,
    parameter RFC     = 5,
    parameter WR      = 2,
    parameter REFRESH = 480,
    parameter POWER   = 100
) (
    input wire        clk,
    input wire        rst,
    input wire        valid,
    input wire        write,
    input wire [21:0] addr,
    input wire [63:0] data,
    input wire [7:0]  strb,
    input wire [15:0] dq_in
);
    localparam [3:0] NOP = 4'b0111, ACTIVATE = 4'b0011, READ = 4'b0101, WRITE = 4'b0100,
                     PRECHARGE = 4'b0010, AUTO = 4'b0001, MODE = 4'b0000;
    localparam [4:0] LONG = 5'd31;        // clocks, or more
    // the most that a row stays open behind the last command: 486 clocks from one refresh to the
    // next by default, 8192 of which are 63.7 ms
    localparam W0 = RAS - 1 > WR + 2 ? RAS - 1 : WR + 2, W1 = RCD > RP ? RCD - 1 : RP - 1,
               W2 = W0 > W1 ? W0 : W1, CLOSE = W2 > 3 ? W2 : 3;
    (* anyconst *) wire [1:0] k;          // the bank
    wire        ready, rsp_valid, cke, oe;
    wire [63:0] rsp_data;
    wire [3:0]  command;
    wire [1:0]  ba, dqm;
    wire [12:0] a;
    wire [15:0] dq;
    rt_sdram #(
        .RCD(RCD), .RP(RP), .RAS(RAS), .RFC(RFC), .WR(WR), .REFRESH(REFRESH), .POWER(POWER)
    ) u_dut (
        .clk(clk), .rst(rst), .cmd_valid_i(valid), .cmd_ready_o(ready), .cmd_write_i(write),
        .cmd_addr_i(addr), .cmd_data_i(data), .cmd_strb_i(strb), .rsp_valid_o(rsp_valid),
        .rsp_data_o(rsp_data), .cke_o(cke), .command_o(command), .ba_o(ba), .a_o(a), .dqm_o(dqm),
        .dq_o(dq), .dq_oe_o(oe), .dq_i(dq_in)
    );
    (* hierconn *) wire [3:0]  \u_dut.any_q ;
    (* hierconn *) wire [3:0]  \u_dut.read_q ;
    (* hierconn *) wire [3:0]  \u_dut.write_q ;
    (* hierconn *) wire [3:0]  \u_dut.pre_q ;
    (* hierconn *) wire [15:0] \u_dut.due_q ;
    (* hierconn *) wire [3:0]  \u_dut.start_q ;
    (* hierconn *) wire [3:0]  \u_dut.open_q ;
    (* hierconn *) wire [1:0]  \u_dut.u_rows.mark ;
    (* hierconn *) wire [12:0] \u_dut.u_rows.word_q ;
    (* hierconn *) wire [1:0]  \u_dut.left_q ;
    (* hierconn *) wire [63:0] \u_dut.out_q ;
    (* hierconn *) wire [7:0]  \u_dut.mask_q ;

    // ---- the last clock's word, if it was taken ----
    reg         old_q = 1'b0, taken_q, write_q;
    reg  [21:0] addr_q;
    reg  [63:0] data_q;                   // of the last write
    reg  [7:0]  strb_q;
    always @(posedge clk) begin
        old_q   <= 1'b1;
        taken_q <= valid && ready && !rst;
        write_q <= write;
        addr_q  <= addr;
        if (valid && ready && write) begin
            data_q <= data;
            strb_q <= strb;
        end
    end
    always @* if (!old_q) assume (rst);

    // ---- at the pins: clocks since commands before this clock's, and with it ----
    wire is_act  = command == ACTIVATE && ba == k;
    wire is_pre  = command == PRECHARGE && (a[10] || ba == k);
    wire is_rd   = command == READ && ba == k, is_wr = command == WRITE && ba == k;
    reg  [4:0] act_q, pre_q, rd_q, wr_q, auto_q, mode_q, any_rd_q, any_wr_q;
    reg        open_q;
    reg [12:0] row_q;
    reg  [3:0] autos_q;                   // of power-up
    reg        first_q, ready_q;          // all banks were closed; the mode is set
    reg [15:0] power_q, since_q;          // clocks since the reset, since the last refresh
    function [4:0] older(input [4:0] age); older = age == LONG ? LONG : age + 5'd1; endfunction
    function far(input [4:0] age, input [5:0] n); far = age == LONG || age >= pre + n; endfunction
    wire [4:0] act  = is_act ? 5'd0 : act_q, pre = is_pre ? 5'd0 : pre_q;
    wire [4:0] rd   = is_rd ? 5'd0 : rd_q, wr = is_wr ? 5'd0 : wr_q;
    wire [4:0] aut  = command == AUTO ? 5'd0 : auto_q, mode = command == MODE ? 5'd0 : mode_q;
    wire [4:0] any_rd = command == READ ? 5'd0 : any_rd_q;
    wire [4:0] any_wr = command == WRITE ? 5'd0 : any_wr_q;
    wire       open = is_act || (open_q && !is_pre);
    wire [12:0] row = is_act ? a : row_q;
    wire [3:0] autos = autos_q + (command == AUTO && !ready_q);
    wire       first = first_q || command == PRECHARGE, set = ready_q || command == MODE;
    wire [15:0] since = command == AUTO ? 16'd0 : since_q;
    always @(posedge clk) begin
        act_q    <= older(act);
        pre_q    <= older(pre);
        rd_q     <= older(rd);
        wr_q     <= older(wr);
        auto_q   <= older(aut);
        mode_q   <= older(mode);
        any_rd_q <= older(any_rd);
        any_wr_q <= older(any_wr);
        open_q   <= open;
        row_q    <= row;
        autos_q  <= autos;
        first_q  <= first;
        ready_q  <= set;
        power_q  <= &power_q ? power_q : power_q + 16'd1;
        since_q  <= since + 16'd1;
        if (rst) begin
            {act_q, pre_q, rd_q, wr_q, auto_q, mode_q, any_rd_q, any_wr_q} <= {8{LONG}};
            {open_q, first_q, ready_q} <= 3'd0;
            autos_q <= 4'd0;
            power_q <= 16'd0;
            since_q <= 16'd0;
        end
    end

    // ---- what the part asks for ----
    wire word = command == READ || command == WRITE;
    always @* if (old_q) begin
        if (command != NOP) begin
            assert (cke && auto_q >= RFC && mode_q >= 2 && power_q >= POWER);
            assert (command != MODE || (first_q && autos_q == 8 && !open_q && a == 13'h22 && !ba));
        end
        if (is_act) assert (ready_q && !open_q && pre_q >= RP && act_q >= RAS + RP);
        if (is_pre && open_q) assert (act_q >= RAS && wr_q >= 3 + WR && rd_q >= 4);
        if (command == AUTO) assert (first_q && !open_q && pre_q >= RP);
        if (word) assert (any_rd_q >= (command == WRITE ? 7 : 4) && any_wr_q >= 4);
        // a word that was taken is moved at once, and no other one: in its row
        assert (word == taken_q);
        if (taken_q) assert ((command == WRITE) == write_q && ba == addr_q[8:7] &&
                             a == {4'd0, addr_q[6:0], 2'b00});
        if (is_rd || is_wr) assert (open_q && act_q >= RCD && row_q == addr_q[21:9]);
        // words that go out
        assert (oe == (any_wr < 4));
        if (oe) assert (dq == data_q[16*any_wr[1:0] +: 16] && dqm == ~strb_q[2*any_wr[1:0] +: 2]);
        else assert (dqm == 2'd0);
        // a refresh waits for the end of a write and a row's closing
        if (ready_q) assert (since_q <= REFRESH + CLOSE + RP);
    end

    // ---- invariant: what is waited for is not over earlier ----
    wire [3:0]  any = \u_dut.any_q , pres = \u_dut.pre_q , start = \u_dut.start_q ;
    wire [15:0] due = \u_dut.due_q ;
    always @* assume (\u_dut.u_rows.mark == k);
    wire [15:0] close = pres > any ? pres : any;
    always @* if (old_q) begin
        assert (open == \u_dut.open_q [k] && (!open || row == \u_dut.u_rows.word_q ));
        assert (any + act >= RCD - 1 && any + pre >= RP - 1 && any + aut >= RFC - 1 &&
                any + mode >= 1);
        if (open) assert (pres + act >= RAS - 1 && pres + wr >= 2 + WR && pres + rd >= 3);
        else assert (far(act, RAS) && far(wr, 3 + WR) && far(rd, 4));
        assert (\u_dut.read_q + any_rd >= 3 && \u_dut.write_q + any_rd >= 6);
        assert (\u_dut.read_q + any_wr >= 3 && \u_dut.write_q + any_wr >= 3);
        assert (any_wr <= wr && any_rd <= rd);
        assert (start <= 10 && (start == 10) == !first && (start == 0) == set);
        if (start == 10) assert (due + power_q >= POWER && !autos && \u_dut.open_q == 0);
        else assert (power_q >= POWER);
        if (start != 0) assert (\u_dut.open_q == 0);
        assert (any <= W1 || (any <= 1 || since + any < RFC) && \u_dut.open_q == 0);
        if (start != 0 && start != 10) assert (autos + start == 9);
        if (start != 0 && autos != 0) assert (since + any < RFC && since + due == REFRESH - 1);
        assert (\u_dut.left_q == (any_wr < 3 ? 3 - any_wr : 0));
        if (any_wr < 4) assert (\u_dut.out_q == data_q >> (16 * any_wr[1:0]) &&
            \u_dut.mask_q == (~{strb_q} & 8'hff) >> (2 * any_wr[1:0]));
        else assert (\u_dut.mask_q == 8'd0);
        assert (any <= 14 && pres <= CLOSE && (command == NOP || command <= READ));
        if (set) begin
            assert (autos == 8);
            if (due != 0) assert (since + due == REFRESH - 1);
            else if (\u_dut.open_q != 0) assert (since + close <= REFRESH - 1 + CLOSE);
            else assert (since + any <= REFRESH - 1 + CLOSE + RP);
        end
    end
endmodule
`default_nettype wire
