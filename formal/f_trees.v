// f_trees.v - proof of rt_trees: no tree is written over that is the newest, or that a frame reads
// SPDX-License-Identifier: Apache-2.0
// Orders come in any clock; a frame lasts from the clock behind its load as long as it likes, and
// begins when another is over. rt_build is done in any clock in which it runs, with any errors.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_top.vh"
module f_trees (
    input wire        clk,
    input wire        rst,
    input wire [7:0]  order,
    input wire [31:0] limit,
    input wire [`RT_LINE_BITS-1:0] tree0,
    input wire [`RT_LINE_BITS-1:0] tree1,
    input wire        root,
    input wire        load,
    input wire        frame,
    input wire        built,
    input wire [4:0]  errors,
    input wire        idle,
    input wire        stall
);
    wire [5:0]  told;
    wire        done, building, draining, valid, newest, start, held, reads, accept, go, cut;
    wire [31:0] clocks;
    wire [`RT_LINE_BITS-1:0] reads_line, line;
    rt_trees u_dut (
        .clk(clk), .rst(rst), .order_i(order), .limit_i(limit), .tree0_i(tree0), .tree1_i(tree1),
        .root_i(root), .errors_o(told), .done_o(done), .building_o(building),
        .draining_o(draining), .valid_o(valid), .newest_o(newest), .clocks_o(clocks),
        .start_o(start), .held_o(held), .load_i(load), .frame_i(frame), .reads_o(reads),
        .reads_line_o(reads_line), .accept_o(accept), .line_o(line), .go_o(go), .built_i(built),
        .errors_i(errors), .cut_o(cut), .idle_i(idle), .stall_i(stall)
    );
    (* hierconn *) wire [2:0] \u_dut.state_q ;
    (* hierconn *) wire       \u_dut.to_q , \u_dut.reads_place_q ;
    (* hierconn *) wire [`RT_LINE_BITS-1:0] \u_dut.newest_line_q ;
    localparam [2:0] IDLE = 3'd0, WAIT = 3'd1, GO = 3'd2, RUN = 3'd3, CUT = 3'd4;
    wire        anew  = order[`RT_TOP_CONTROL_SOFT_RESET];
    wire        works = \u_dut.state_q == GO || \u_dut.state_q == RUN;
    reg         old_q = 1'b0, frame_q, load_q, valid_q, newest_q, bad_q, anew_q, stopped_q, plain_q;
    reg  [`RT_LINE_BITS-1:0] newest_line_q, read_q;
    reg  [1:0]  owed_q;                          // builds that began and did not end
    always @(posedge clk) begin
        old_q    <= 1'b1;
        frame_q  <= frame && !rst;
        load_q   <= load && !rst;
        valid_q  <= valid && !rst;
        newest_q <= newest;
        newest_line_q <= \u_dut.newest_line_q ;
        bad_q    <= !(built && errors == 5'd0);
        anew_q   <= anew && !rst;
        owed_q   <= rst || anew ? 2'd0 : owed_q + {1'b0, accept} - {1'b0, done};
        read_q   <= load ? \u_dut.newest_line_q : read_q;
        stopped_q <= (anew || order[`RT_TOP_CONTROL_STOP]) && !accept;
    end
    always @* begin
        if (!old_q) assume (rst);
        if (frame) assume (frame_q || load_q);   // a frame begins by its load, when no other is
        if (load) assume (!frame && !load_q);
        if (built) assume (\u_dut.state_q == RUN);
    end
    always @* if (old_q) begin
        // where the builder writes nobody reads, and the newest is not
        if (works && valid) assert (newest != \u_dut.to_q && \u_dut.newest_line_q == newest_line_q);
        if (works && reads && (frame || load_q)) assert (\u_dut.reads_place_q != \u_dut.to_q );
        // the newest changes with a tree that is whole alone
        if (bad_q && valid) assert (valid_q && newest == newest_q &&
                                    \u_dut.newest_line_q == newest_line_q);
        if (anew_q) assert (!valid && !held && !works);
        if (frame && reads) assert (reads_line == read_q);
        // each build ends once
        assert (owed_q == (building ? 2'd1 : 2'd0));
        assert (!(done && !building));
        if (stopped_q) assert (!held);
        if (start) assert (order[`RT_TOP_CONTROL_START] || (held && !building && !frame));
        // invariant
        assert (\u_dut.state_q <= CUT);
        if (building && valid) assert (newest != \u_dut.to_q );
        if (building && !valid && reads && (frame || load_q))
            assert (!works || \u_dut.reads_place_q != \u_dut.to_q );
    end
endmodule
`default_nettype wire
