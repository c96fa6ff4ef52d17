// rt_facet_sums.v - the four numbers whose signs say whether a ray meets a triangle or a plane
// SPDX-License-Identifier: Apache-2.0
//   A0 = v0-org, e1 = v1-v0, e2 = v2-v0 | N = e1 x e2 (plane: given), m = dir x A0 | dot products
//   det = N.dir   num = N.A0   U2 = m.e1   V = m.e2 = -U1
// A facet every INTERVAL clocks, 1, 2 or 4, which share 4 cross and 4 dot operations: 6 NW x NW and
// 12 CW x NW products of an INTERVALth of them each. Free-running; latency `RT_FACET_SUMS_LATENCY.
// Model: sph_facet_test() in cmodel/prim/facet.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_check.vh"
`include "rt_fx.vh"
`include "rt_facet.vh"
module rt_facet_sums #(
    parameter W   = 16,                    // coordinate, bits
    parameter WD  = 17,                    // direction component, bits
    parameter INTERVAL = 2,                // clocks a facet, 1, 2 or 4
    parameter VW  = 51                     // bits of a sum
) (
    input  wire                 clk,
    // a facet is taken: not again for INTERVAL clocks
    input  wire                 take_i,
    input  wire                 plane_i,
    input  wire [71:0]          v0_i,      // 3 x s24
    input  wire [71:0]          v1_i,
    input  wire [71:0]          v2_i,
    input  wire [3*W-1:0]       org_i,     // 3 x sW
    input  wire [3*WD-1:0]      dir_i,     // 3 x sWD
    // N, `RT_FACET_NORMAL clocks later, for a clock
    output wire [3*`RT_FACET_WIDE(W, WD)-1:0] n_o, // 3 x s
    // its sums
    output wire [VW-1:0]        det_o,     // sVW
    output wire [VW-1:0]        num_o,
    output wire [VW-1:0]        u2_o,
    output wire [VW-1:0]        v_o
);
    `RT_CHECK(INTERVAL == 1 || INTERVAL == 2 || INTERVAL == 4,
              rt_facet_sums_INTERVAL_must_be_1_2_or_4)
    localparam NW   = `RT_FACET_NARROW(W, WD);
    localparam CW   = `RT_FACET_WIDE(W, WD);
    localparam L    = `RT_MUL_LATENCY(NW);
    localparam ALONE = INTERVAL == 4 ? 1 : 0;     // one product of a component a clock
    localparam VECTOR = L + 2 + ALONE;            // clocks to the vector's load
    localparam DOT  = VECTOR + 1;                 // to the first dot product
    localparam VECTORS = INTERVAL == 1 ? 2 : 1;   // cross products at once
    localparam DOTS = 4 / INTERVAL;               // dot products at once
    localparam LD   = `RT_PRODUCT_LATENCY(CW);
    localparam HELD = VECTOR > INTERVAL ? VECTOR - INTERVAL : 0; // clocks that a normal waits

    // ---- stage 1: operands, for INTERVAL clocks; phase: clocks since the facet was taken ----
    reg  [3*NW-1:0] a0_q, e1_q, e2_q, dir_q;      // 3 x sNW
    reg  [72:0]     given_q;                      // plane, its normal
    localparam [31:0] LAST = INTERVAL - 1;        // then it stands still, and the operands with it
    reg  [1:0]      phase_q;
    reg  [VECTOR+2:1] at_q;                       // bit s: taken s clocks ago
    always @(posedge clk) begin
        at_q <= {at_q[VECTOR+1:1], take_i};
        phase_q <= take_i ? 2'd0 : phase_q == LAST[1:0] ? phase_q : phase_q + 2'd1;
        if (take_i) given_q <= {plane_i, v1_i};
    end
    genvar i, j, k;
    generate
        for (j = 0; j < 3; j = j + 1) begin : g_operands
            wire signed [W-1:0] v0 = $signed(v0_i[24*j +: W]);
            wire signed [W-1:0] v1 = $signed(v1_i[24*j +: W]);
            wire signed [W-1:0] v2 = $signed(v2_i[24*j +: W]);
            wire signed [W-1:0] o  = $signed(org_i[W*j +: W]);
            wire signed [WD-1:0] d = $signed(dir_i[WD*j +: WD]);
            wire signed [W:0] a0 = $signed({v0[W-1], v0}) - $signed({o[W-1], o});
            wire signed [W:0] e1 = $signed({v1[W-1], v1}) - $signed({v0[W-1], v0});
            wire signed [W:0] e2 = $signed({v2[W-1], v2}) - $signed({v0[W-1], v0});
            always @(posedge clk)
                if (take_i) begin
                    a0_q[NW*j +: NW]  <= {{(NW-W){a0[W]}}, a0[W-1:0]};
                    e1_q[NW*j +: NW]  <= {{(NW-W){e1[W]}}, e1[W-1:0]};
                    e2_q[NW*j +: NW]  <= {{(NW-W){e2[W]}}, e2[W-1:0]};
                    dir_q[NW*j +: NW] <= {{(NW-WD+1){d[WD-1]}}, d[WD-2:0]};
                end
        end
    endgenerate
    wire [72:0] given;
    generate
        if (HELD != 0) begin : g_held
            rt_delay #(.WIDTH(73), .CYCLES(HELD)) u_given (
                .clk(clk), .in_i(given_q), .out_o(given)
            );
        end else begin : g_still
            assign given = given_q;
        end
    endgenerate

    // ---- cross products: N, then m, or both; of one product a clock the subtracted one first ----
    wire [3*CW*VECTORS-1:0] vector;               // 3 x sCW each
    wire [VW*DOTS-1:0]      sum;
    generate
        for (i = 0; i < VECTORS; i = i + 1) begin : g_vector
            wire second = VECTORS == 2 ? i == 1 : ALONE != 0 ? phase_q[1] : phase_q[0];
            wire [3*NW-1:0] x = second ? dir_q : e1_q;
            wire [3*NW-1:0] y = second ? a0_q : e2_q;
            for (j = 0; j < 3; j = j + 1) begin : g_component
                localparam Y = (j + 1) % 3, Z = (j + 2) % 3;
                wire signed [NW-1:0] x_y = $signed(x[NW*Y +: NW]), x_z = $signed(x[NW*Z +: NW]);
                wire signed [NW-1:0] y_y = $signed(y[NW*Y +: NW]), y_z = $signed(y[NW*Z +: NW]);
                wire [2*NW-1:0] p;                // what is added, or each
                wire [CW+2*NW-1:0] long = {{CW{p[2*NW-1]}}, p};
                reg  [CW-1:0]   c_q, v_q;
                wire            load;
                if (ALONE != 0) begin : g_alone
                    wire first = at_q[L+1] || at_q[L+3];
                    wire signed [NW-1:0] x_now = phase_q[0] ? x_y : x_z;
                    wire signed [NW-1:0] y_now = phase_q[0] ? y_z : y_y;
                    rt_multiply #(.W(NW)) u_product (
                        .clk(clk), .in_valid_i(|at_q[INTERVAL:1]), .a_i(x_now), .b_i(y_now), .p_o(p)
                    );
                    always @(posedge clk) c_q <= long[CW-1:0] - (first ? {CW{1'b0}} : c_q);
                    assign load = at_q[VECTOR] || at_q[VECTOR+2];
                end else begin : g_pair
                    wire [2*NW-1:0] less;
                    rt_multiply #(.W(NW)) u_product (
                        .clk(clk), .in_valid_i(|at_q[INTERVAL:1]), .a_i(x_y), .b_i(y_z), .p_o(p)
                    );
                    rt_multiply #(.W(NW)) u_less (
                        .clk(clk), .in_valid_i(|at_q[INTERVAL:1]), .a_i(x_z), .b_i(y_y), .p_o(less)
                    );
                    wire [CW+2*NW-1:0] long_less = {{CW{less[2*NW-1]}}, less};
                    always @(posedge clk) c_q <= long[CW-1:0] - long_less[CW-1:0];
                    wire unused = &{1'b0, long_less};
                    assign load = 1'b1;
                end
                always @(posedge clk)
                    if (load) v_q <= i == 0 && at_q[VECTOR] && given[72]
                                     ? {{(CW-23){given[24*j+23]}}, given[24*j +: 23]} : c_q;
                wire unused = &{1'b0, long};
                assign vector[CW*(3*i+j) +: CW] = v_q;
            end
        end

        assign n_o = vector[3*CW-1:0];

        // ---- dot products: det, num, U2, V; operands wait for their vector ----
        for (k = 0; k < DOTS; k = k + 1) begin : g_dot
            localparam OF = DOTS == 4 && k >= 2 ? 1 : 0;
            wire [3*NW-1:0] now, b;
            if (DOTS == 4) begin : g_four
                assign now = k == 0 ? dir_q : k == 1 ? a0_q : k == 2 ? e1_q : e2_q;
            end else if (DOTS == 2) begin : g_two
                assign now = k == 0 ? (phase_q[0] ? e1_q : dir_q) : phase_q[0] ? e2_q : a0_q;
            end else begin : g_one
                assign now = phase_q[1] ? (phase_q[0] ? e2_q : e1_q) : phase_q[0] ? a0_q : dir_q;
            end
            rt_delay #(.WIDTH(3*NW), .CYCLES(DOT - 1)) u_wait (
                .clk(clk), .in_i(now), .out_o(b)
            );
            wire [3*(CW+NW)-1:0] p;
            wire [3*VW-1:0]      part;            // products as long as the sum, or its low bits
            for (j = 0; j < 3; j = j + 1) begin : g_lane
                rt_product #(.AW(CW), .BW(NW)) u_product (
                    .clk(clk), .a_i($signed(vector[CW*(3*OF+j) +: CW])),
                    .b_i($signed(b[NW*j +: NW])), .p_o(p[(CW+NW)*j +: CW+NW])
                );
                wire [VW+CW+NW-1:0] long = {{VW{p[(CW+NW)*(j+1)-1]}}, p[(CW+NW)*j +: CW+NW]};
                assign part[VW*j +: VW] = long[VW-1:0];
                wire unused = &{1'b0, long};
            end
            reg [VW-1:0] low_q, p2_q, r_q;
            always @(posedge clk) begin
                low_q <= part[0 +: VW] + part[VW +: VW];
                p2_q  <= part[2*VW +: VW];
                r_q   <= low_q + p2_q;
            end
            assign sum[VW*(DOTS-1-k) +: VW] = r_q;      // det above
        end

        // ---- all four at once: those of earlier clocks wait ----
        if (DOTS == 4) begin : g_now
            assign {det_o, num_o, u2_o, v_o} = sum;
        end else if (DOTS == 2) begin : g_before
            reg [2*VW-1:0] before_q;
            always @(posedge clk) before_q <= sum;
            assign {det_o, num_o, u2_o, v_o} = {before_q, sum};
        end else begin : g_line
            reg [3*VW-1:0] line_q;
            always @(posedge clk) line_q <= {line_q[2*VW-1:0], sum};
            assign {det_o, num_o, u2_o, v_o} = {line_q, sum};
        end
    endgenerate
    `RT_CHECK(DOT == `RT_FACET_NORMAL(W, WD, INTERVAL), rt_facet_sums_normal)
    `RT_CHECK(DOT + LD + 1 + INTERVAL == `RT_FACET_SUMS_LATENCY(W, WD, INTERVAL),
              rt_facet_sums_latency)
    wire unused = &{1'b0, v0_i, v1_i, v2_i, at_q, phase_q};
endmodule
`default_nettype wire
