// two_kinds.v - a triangle and a new kind with the same test: the same records, rays and results
// SPDX-License-Identifier: Apache-2.0
// Two rt_prim get the same tests, one as KIND 1, the other as KIND; what they answer must be equal
// in every clock. Prints `same` or what differs. tests/prim/test_kinds.sh makes the new kind.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_bundles.vh"
module two_kinds;
    parameter KIND = 3;
    localparam W = 12, WD = 13, NG = 2, SLOTS = 4, TESTS = 400;
    reg clk = 1'b0, rst = 1'b1, valid = 1'b0;
    always #2 clk = !clk;
    wire [1:0] ready, bad;
    wire [2*`RT_RESULT_BITS-1:0] results;
    wire [`RT_RESULT_BITS-1:0]   one = results[0 +: `RT_RESULT_BITS];
    wire [`RT_RESULT_BITS-1:0]   two = results[`RT_RESULT_BITS +: `RT_RESULT_BITS];
    reg  [`RT_TEST_BITS-1:0] test;
    reg  [255:0] record;
    genvar g;
    generate
        for (g = 0; g < 2; g = g + 1) begin : g_prim
            localparam [7:0] K = g == 0 ? 1 : KIND;
            reg [`RT_TEST_BITS-1:0] t;
            reg [255:0] r;
            always @* begin
                r = record;
                r[`RT_FACET_KIND_LSB +: `RT_FACET_KIND_BITS] = K < 8'd3 ? K[1:0] : 2'd3;
                r[`RT_FACET_MORE_LSB +: `RT_FACET_MORE_BITS] = K < 8'd3 ? 6'd0 : K - 8'd3;
                t = test;
                t[`RT_TEST_RECORD] = r;
            end
            rt_prim #(.W(W), .WD(WD), .SLOTS(SLOTS), .FACETS(1)) u_prim (
                .clk(clk), .rst(rst), .effects_i({`RT_EFFECT_BITS{1'b1}}),
                .in_valid_i(valid), .in_ready_o(ready[g]), .test_i(t),
                .result_o(results[`RT_RESULT_BITS*g +: `RT_RESULT_BITS]), .event_o(),
                .bad_o(bad[g])
            );
        end
    endgenerate

    integer i, seed = 7, sent = 0, hits = 0, came = 0, org, dir, sum;
    integer v [0:8];
    task make;                                   // a ray to a point within the corners
        begin
            record = 256'd0;
            for (i = 0; i < 9; i = i + 1) begin
                v[i] = ($random(seed) & 'h7ff) - 1024;
                record[24*i +: 24] = v[i];
            end
            record[`RT_FACET_ID_LSB +: `RT_FACET_ID_BITS] = sent;
            test = {`RT_TEST_BITS{1'b0}};
            test[`RT_TEST_SLOT]   = sent;
            test[`RT_TEST_SHADOW] = sent % 4 == 1;
            test[`RT_TEST_SKIP]   = sent % 5 == 1 ? sent : 'hffffff;
            sum = 0;
            for (i = 0; i < 3; i = i + 1) begin
                org = ($random(seed) & 'h7ff) - 1024;
                dir = (2*v[i] + v[3+i] + v[6+i] >>> 2) - org + (sent % 3 == 0 ? 'h100 : 0);
                put_component;
                sum = sum + dir*dir;
            end
            test[`RT_TEST_A] = sum;
        end
    endtask
    reg [3*W-1:0]  orgs;
    reg [3*WD-1:0] dirs;
    task put_component;
        begin
            orgs[W*i +: W]   = org;
            dirs[WD*i +: WD] = dir;
            test[`RT_TEST_ORG] = orgs;
            test[`RT_TEST_DIR] = dirs;
        end
    endtask

    initial begin
        make;
        repeat (4) @(negedge clk);
        rst = 1'b0;
        while (came < TESTS) begin
            valid = $random(seed) & 3 && sent < TESTS;
            #1 if (ready[0] !== ready[1] || bad !== 2'd0) begin
                $display("differs: test %0d, ready %b, no kind %b", sent, ready, bad);
                $finish(0);
            end
            if (one[`RT_RESULT_VALID] !== two[`RT_RESULT_VALID] ||
                (one[`RT_RESULT_VALID] && one !== two)) begin
                $display("differs: result %h, not %h", two, one);
                $finish(0);
            end
            came = came + one[`RT_RESULT_VALID];
            hits = hits + (one[`RT_RESULT_VALID] && one[`RT_RESULT_HIT]);
            i = valid && ready[0];
            @(negedge clk) if (i) begin
                sent = sent + 1;
                make;
            end
        end
        if (hits > TESTS/4) $display("same: %0d results, %0d hits", came, hits);
        $finish(0);
    end
endmodule
`default_nettype wire
