// s_build_groups.v - rt_build_groups for every number of spheres: a tree of them, in its own lines
// SPDX-License-Identifier: Apache-2.0
// Each sphere is a leaf once; each line is referred to once and holds a node or leaf records; a
// child is the run of what its own node holds; no node lies beyond 2n lines. Who takes nodes and
// children waits in some clocks.
`timescale 1ns / 1ps
`default_nettype none
module s_build_groups #(
    parameter AB = 9
);
    localparam N = 1 << AB, LB = AB + 2;
    reg           clk = 1'b0, start = 1'b1;
    reg  [AB:0]   n = 1;
    reg  [15:0]   waits = 16'h1ace;
    wire          idle, low, upper, whole, node_valid, child_valid;
    wire [LB-1:0] next;
    wire [AB-1:0] ball_at;
    wire [2*LB+5:0] node;
    wire [2*AB:0] child;
    rt_build_groups #(.AB(AB)) u_dut (
        .clk(clk), .rst(1'b0), .start_i(start), .count_i(n), .idle_o(idle), .next_o(next),
        .drained_i(waits[0]), .whole_done_i(waits[1]), .low_o(low), .upper_o(upper),
        .whole_o(whole), .ball_i(child_valid && waits[3] && !low && !whole), .ball_at_o(ball_at),
        .node_valid_o(node_valid), .node_ready_i(waits[2]), .node_o(node),
        .child_valid_o(child_valid), .child_ready_i(waits[3]), .child_o(child)
    );
    always #1 clk = !clk;
    wire [LB-1:0] line = node[0 +: LB], base = node[LB +: LB];
    wire [2:0]    inner = node[2*LB +: 3], leaves = node[2*LB+3 +: 3];
    wire [AB-1:0] first = child[0 +: AB], last = child[AB +: AB];
    integer       told [0:2*N-1];            // n of the last build that referred to a line,
    integer       holds [0:2*N-1];           // and for which it holds a node
    integer       seen [0:N-1];              // and for which a sphere is a leaf

    integer       items [0:2*N-1];           // how many children it has
    integer       i, n_told, n_seen, parent, children, at, wholes;
    initial begin
        for (i = 0; i < 2*N; i = i + 1) {told[i], holds[i]} = 0;
        for (i = 0; i < N; i = i + 1) seen[i] = 0;
    end
    task fail;
        begin
            $display("fails: %0d spheres, line %0d, child %0d", n, line, first);
            $finish;
        end
    endtask
    always @(posedge clk) begin
        waits <= {waits[14:0], waits[15] ^ waits[13] ^ waits[12] ^ waits[10]};
        if (start) begin
            start    <= 1'b0;
            n_told   <= 0;
            n_seen   <= 0;
            at       <= 0;
            children <= 0;
            wholes   <= 0;
        end else if (idle) begin
            if (n_seen != n || n_told != next - 1 || holds[0] != n || at != children) fail;
            if (next > 2*n || wholes != (n > 4)) fail;
            if (n == N) begin
                $display("proved");
                $finish;
            end
            n     <= n + 1'b1;
            start <= 1'b1;
        end
        if (node_valid && waits[2]) begin
            if (at != children || inner + leaves == 0 || inner + leaves > 4) fail;
            if (base <= line || base + inner + (leaves + 1)/2 > 2*n || holds[line] == n) fail;
            for (i = base; i < base + inner + (leaves + 1)/2; i = i + 1) begin
                if (told[i] == n || (holds[i] == n) != (i < base + inner)) fail;
                told[i] = n;
            end
            holds[line] = n;
            parent      <= base;
            children    <= inner + leaves;
            n_told      <= n_told + inner + (leaves + 1)/2;
            items[line] = inner + leaves;
            at          <= 0;
        end
        if (child_valid && waits[3] && whole) begin
            wholes <= wholes + 1;
            if (first != 0 || last != n - 1 || child[2*AB]) fail;
        end else if (child_valid && waits[3]) begin
            if (child[2*AB] != (at == children - 1) || at >= children) fail;
            if (low) begin
                if (first != last || first >= n || seen[first] == n) fail;
                seen[first] = n;
                n_seen <= n_seen + 1;
            end else if (first[1:0] != 0 || last - first + 1 != items[parent + at]) fail;
            if (!low && at == 0 && ball_at != first >> 2) fail;
            at <= at + 1;
        end
    end
endmodule
`default_nettype wire
