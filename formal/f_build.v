// f_build.v - proof of rt_build: what is read, what is written and when, errors
// SPDX-License-Identifier: Apache-2.0
// Its parts say anything, but for these: a node lies within the lines that it may take, as
// s_build_groups.v proves of rt_build_groups, and its children come in their order, and only while
// nodes are made. Records, memory and resets are any.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module f_build #(
    parameter COUNT = 16
) (
    input wire         clk,
    input wire         rst,
    input wire         start,
    input wire [1:0]   mode,
    input wire [1:0]   rounds,
    input wire [`RT_ID_BITS-1:0] count,
    input wire [`RT_LINE_BITS-1:0] prim_base,
    input wire [`RT_LINE_BITS-1:0] root,
    input wire [`RT_LINE_BITS-1:0] lines,
    input wire         req_ready,
    input wire         rsp_valid,
    input wire [255:0] rsp_data,
    input wire         rsp_error,
    input wire         wr_ready,
    input wire         wr_idle,
    input wire         wr_error
);
    localparam AB = $clog2(COUNT), LB = AB + 2;
    wire busy, done, req_valid, wr_valid;
    wire [4:0] error;
    wire [`RT_LINE_BITS-1:0] written, req_line, wr_line;
    wire [255:0] wr_data;
    rt_build #(.W(8), .FW(6), .COUNT(COUNT)) u_dut (
        .clk(clk), .rst(rst), .start_i(start), .mode_i(mode), .rounds_i(rounds), .count_i(count),
        .prim_base_i(prim_base), .root_i(root), .lines_i(lines), .busy_o(busy), .done_o(done),
        .error_o(error), .written_o(written), .req_valid_o(req_valid), .req_ready_i(req_ready),
        .req_line_o(req_line), .rsp_valid_i(rsp_valid), .rsp_data_i(rsp_data),
        .rsp_error_i(rsp_error), .wr_valid_o(wr_valid), .wr_ready_i(wr_ready),
        .wr_line_o(wr_line), .wr_data_o(wr_data), .wr_idle_i(wr_idle), .wr_error_i(wr_error)
    );
    (* hierconn *) wire [2:0]  \u_dut.state_q ;
    (* hierconn *) wire [AB:0] \u_dut.asked_q , \u_dut.came_q ;
    (* hierconn *) wire        \u_dut.line_q , \u_dut.void_q , \u_dut.heads , \u_dut.takes ;
    (* hierconn *) wire        \u_dut.whole , \u_dut.done_valid ;
    (* hierconn *) wire        \u_dut.second_q , \u_dut.put_records_q , \u_dut.put_node_q ;
    (* hierconn *) wire [1:0]  \u_dut.done_kind , \u_dut.slot_q ;
    (* hierconn *) wire [LB-1:0] \u_dut.records_line_q , \u_dut.head_line , \u_dut.head_base ;
    (* hierconn *) wire [2:0]  \u_dut.head_inner , \u_dut.head_leaves ;
    wire idle  = \u_dut.state_q == 0;
    wire reads = \u_dut.state_q == 1;
    wire nodes = \u_dut.state_q == 6;
    wire [`RT_ID_BITS+1:0] need = count == 0 ? 1 : {1'b0, count, 1'b0};

    // ---- model: what was taken of a node, errors, records ----
    reg         old_q = 1'b0, bad_q;         // a record came with an error, or was wrong
    reg  [2:0]  taken_q;                     // children
    reg  [4:0]  error_q;
    reg  [`RT_ID_BITS:0] got_q;              // lines that came
    reg  [`RT_ID_BITS+3*`RT_LINE_BITS+3:0] job_q;
    reg         start_q, rst_q;
    wire [2:0]  children = \u_dut.head_inner + \u_dut.head_leaves ;
    wire [2:0]  leaves   = taken_q > \u_dut.head_inner ? taken_q - \u_dut.head_inner : 3'd0;
    wire [2:0]  lines_so = (leaves + 1) >> 1;
    wire        begins   = start && idle;
    always @(posedge clk) begin
        old_q   <= 1'b1;
        error_q <= error;
        start_q <= begins;
        rst_q   <= rst;
        job_q   <= {mode, rounds, count, prim_base, root, lines};
        if (reads && rsp_valid) got_q <= got_q + 1'b1;
        if (begins) got_q <= 0;
        if (\u_dut.takes && !\u_dut.whole ) taken_q <= taken_q + 1'b1;
        if ((wr_valid && wr_ready && !\u_dut.put_records_q ) || rst) taken_q <= 0;
    end

    // ---- what is given ----
    always @* begin
        if (!old_q) assume (rst);
        if (busy) assume (job_q == {mode, rounds, count, prim_base, root, lines});
        assume (!(start && !idle));
        // as many lines come as were asked for
        if (rsp_valid && reads) assume (got_q < \u_dut.asked_q );
        if (rsp_valid) assume (reads);
        if (\u_dut.done_valid ) begin
            assume (nodes && count != 0 && !\u_dut.whole );
            assume (\u_dut.heads && taken_q < children);
            assume (\u_dut.done_kind ==
                    {taken_q >= \u_dut.head_inner , taken_q == children - 1'b1});
        end
        if (\u_dut.heads ) begin
            assume (count != 0 && children != 0 && children <= 4 && \u_dut.head_inner <= 4);
            assume (\u_dut.head_leaves <= 4 && \u_dut.head_line < need);
            assume (\u_dut.head_base + \u_dut.head_inner + ((\u_dut.head_leaves + 1) >> 1) <= need);
        end
        if (nodes && taken_q != 0) assume (\u_dut.heads );
    end

    // ---- what holds ----
    always @* if (old_q) begin
        // requests: the records of the job, each once
        if (req_valid) assert (reads && \u_dut.asked_q < count);
        if (req_valid) assert (req_line == prim_base + \u_dut.asked_q );
        if (reads) assert (count <= COUNT && \u_dut.asked_q <= count && got_q <= \u_dut.asked_q );
        if (reads) assert (\u_dut.came_q + \u_dut.line_q == got_q);
        if (!idle && count > COUNT) assert (\u_dut.state_q == 7);
        if (!idle && lines < need) assert (\u_dut.state_q == 7);
        // lines that are written: of a build whose records are sound, within the job's
        if (wr_valid) assert (nodes && !(error & 5'b10111));
        if (!idle && !reads && \u_dut.state_q != 7) assert (!(error & 5'b10111));
        if (wr_valid) assert (wr_line - root < lines);
        // errors stay
        if (!rst_q && !start_q) assert ((error_q & ~error) == 0);
        // an error of the start ends a build at once
        if (reads) assert (!error[1:0] && !error[4]);
        // of a node's children
        if (!nodes) assert (taken_q == 0 && !\u_dut.put_node_q && !\u_dut.put_records_q &&
                            !\u_dut.second_q && \u_dut.records_line_q == 0);
        assert (taken_q <= 4 && \u_dut.slot_q == taken_q[1:0]);
        if (nodes && taken_q == 0)
            assert ((!\u_dut.put_node_q || count == 0) && !\u_dut.put_records_q &&
                    !\u_dut.second_q && \u_dut.records_line_q == 0);
        if (nodes && taken_q != 0) begin
            assert (taken_q <= children && \u_dut.put_node_q == (taken_q == children));
            assert (\u_dut.records_line_q + (\u_dut.put_records_q || \u_dut.second_q ) == lines_so);
            assert (leaves[0] ? \u_dut.second_q || (\u_dut.put_node_q && !\u_dut.put_records_q )
                              : !\u_dut.second_q );
            if (\u_dut.second_q ) assert (\u_dut.put_records_q == \u_dut.put_node_q );
            assert (!\u_dut.put_records_q || leaves != 0);
        end
    end
endmodule
`default_nettype wire
