// f_facet_ahead.v - proof of rt_facet_ahead: N.lift and |N_x| + |N_y| + |N_z|, at its real widths
// SPDX-License-Identifier: Apache-2.0
// Any N and lift in the first clock. A clock later their products and magnitudes are those of
// ahead() in cmodel/prim/facet.c. With SUMS, from any that keep their bounds, 2 + WAIT clocks later
// the sums of these, in words that hold every value.
`timescale 1ns / 1ps
`default_nettype none
module f_facet_ahead #(
    parameter CW   = 34,
    parameter NG   = 2,
    parameter WAIT = 1,
    parameter SUMS = 0
) (
    input wire                clk,
    input wire [3*CW-1:0]     n,
    input wire [3*(NG+2)-1:0] lift
);
    localparam PW = CW + NG + 2;
    localparam X = CW + NG + 4;                      // bits of the model's words
    wire signed [CW+NG+1:0] along;
    wire                    carry;
    wire [CW:0]             size;
    rt_facet_ahead #(.CW(CW), .NG(NG), .WAIT(WAIT)) u_dut (
        .clk(clk), .n_i(n), .lift_i(lift), .along_o(along), .carry_o(carry), .size_o(size)
    );
    localparam signed [CW-1:0] LEAST = {1'b1, {(CW-1){1'b0}}};
    localparam signed [NG+1:0] MOST = 1 << NG;
    wire [3*X-1:0] products, sizes;
    reg [3:0]      age_q = 4'd0;
    genvar i;
    generate
        for (i = 0; i < 3; i = i + 1) begin : g_axis
            wire signed [CW-1:0] n_i = n[CW*i +: CW];
            wire signed [NG+1:0] l_i = lift[(NG+2)*i +: NG+2];
            wire signed [X-1:0]  x = n_i;
            reg  signed [X-1:0]  by;                 // x times l_i, a bit at a time
            integer k;
            always @* begin
                by = -((x <<< (NG+1)) & {X{l_i[NG+1]}});
                for (k = 0; k <= NG; k = k + 1) by = by + ((x <<< k) & {X{l_i[k]}});
            end
            assign products[X*i +: X] = by;
            assign sizes[X*i +: X]    = x < 0 ? -x : x;
            always @* if (age_q == 0) assume (n_i != LEAST && l_i <= MOST && l_i >= -MOST);
        end
    endgenerate
    // ---- a product an axis; then what is summed of them ----
    (* hierconn *) wire [3*PW-1:0] \u_dut.s1_p_q ;
    (* hierconn *) wire [3*CW-1:0] \u_dut.s1_m_q ;
    (* hierconn *) wire [2:0]      \u_dut.s1_neg_q , \u_dut.s1_turn_q ;
    reg [3*X-1:0] products_q, sizes_q;
    wire [3*X-1:0] p, m;                             // as the module has them
    generate
        for (i = 0; i < 3; i = i + 1) begin : g_stage
            wire signed [PW-1:0] p_i = \u_dut.s1_p_q [PW*i +: PW];
            assign p[X*i +: X] = p_i + $signed({1'b0, \u_dut.s1_neg_q [i]});
            assign m[X*i +: X] = \u_dut.s1_m_q [CW*i +: CW] + \u_dut.s1_turn_q [i];
        end
    endgenerate
    localparam signed [X-1:0] ONE = 1, FAR = ONE <<< (CW+NG-1), LONG = ONE <<< (CW-1);
    function fits(input signed [X-1:0] x, input signed [X-1:0] most);
        fits = x < most && x > -most;
    endfunction
    function signed [X-1:0] sum(input [3*X-1:0] x);
        sum = $signed(x[0 +: X]) + $signed(x[X +: X]) + $signed(x[2*X +: X]);
    endfunction
    reg signed [X-1:0] along_q, size_q;
    wire signed [X-1:0] got = along + $signed({1'b0, carry});
    always @(posedge clk) begin
        if (age_q != 15) age_q <= age_q + 1'b1;
        if (age_q == 0) {products_q, sizes_q} <= {products, sizes};
        if (age_q == 0) {along_q, size_q} <= {sum(p), sum(m)};
    end
    always @* if (SUMS == 0 && age_q == 1) begin
        assert (p == products_q && m == sizes_q);
    end else if (SUMS != 0) begin
        if (age_q == 0) begin
            assume (fits(p[0 +: X], FAR) && fits(p[X +: X], FAR) && fits(p[2*X +: X], FAR));
            assume (fits(m[0 +: X], LONG) && fits(m[X +: X], LONG) && fits(m[2*X +: X], LONG));
        end
        if (age_q == 2 + WAIT) assert (got == along_q && size == size_q);
    end
endmodule
`default_nettype wire
