// f_long_product.v - proof that rt_long_product is the product of its operands
// SPDX-License-Identifier: Apache-2.0
// From any state that keeps the rules below: a product begins in clock 0, and its operands stand
// still as long as the module wants them to; others come before and behind it. The products of
// chunks are any function; of 17 bits without sign they are at most (2^17 - 1)^2 (products.smt2).
// RULES 1: the rules instead, by induction. The steps of a row follow one another on their way to
// the sums, and no carry is left when none is there, or the first of a row.
`timescale 1ns / 1ps
`default_nettype none
module f_long_product #(
    parameter AW = 50,
    parameter BW = 34,
    parameter BN = 17,
    parameter NARROW = 0,                            // the product that begins has a narrow b
    parameter RULES = 0
) (
    input wire          clk,
    input wire          rst, start, narrow,
    input wire [AW-1:0] a,
    input wire [BW-1:0] b
);
    localparam A = (AW + 33) / 34, B = (BW + 16) / 17, N = (BN + 16) / 17;
    localparam IB = $clog2(A + 1), JB = B > 1 ? $clog2(B) : 1;
    localparam ROWS = NARROW != 0 ? N : B;
    localparam [35:0] MOST = (36'd1 << 34) - (36'd1 << 18) + 1;
    localparam STEPS = (A + 1) * ROWS, END = A, LAST_B = B - 1, LAST_N = N - 1;
    wire ready, done;
    wire [AW+BW-1:0] p;
    wire [AW+BN-1:0] few;
    rt_long_product #(.AW(AW), .BW(BW), .BN(BN)) u_dut (
        .clk(clk), .rst(rst), .start_i(start), .ready_o(ready), .narrow_i(narrow), .a_i(a),
        .b_i(b), .done_o(done), .p_o(p), .narrow_o(few)
    );
    (* hierconn *) wire          \u_dut.busy_q ;
    (* hierconn *) wire [IB-1:0] \u_dut.i_q ;
    (* hierconn *) wire [JB-1:0] \u_dut.j_q ;
    (* hierconn *) wire [11:0]   \u_dut.step_q ;
    (* hierconn *) wire [16:0]   \u_dut.carry_q ;

    // ---- rules ----
    // i of the steps in the stages before the sums, the youngest is the one that is chosen now
    reg  [3*IB-1:0] pos_q;
    reg  narrow_q, first_q;                          // the product's; its first step is chosen
    wire [4*IB-1:0] pos  = {pos_q, \u_dut.i_q };
    wire [3:0]      step = {\u_dut.step_q [8], \u_dut.step_q [4], \u_dut.step_q [0],
                            \u_dut.busy_q };
    wire [2:0]      ends = {\u_dut.step_q [10], \u_dut.step_q [6], \u_dut.step_q [2]};
    reg  [3:0]      kept;
    integer         k;
    always @* begin
        kept = 4'hf;
        for (k = 0; k < 3; k = k + 1) begin          // a step, and the one a clock before it
            if (step[k+1] && !ends[k])
                kept[k] = step[k] && pos[IB*k +: IB] == pos[IB*(k+1) +: IB] + 1'b1;
            else if (step[k])
                kept[k] = pos[IB*k +: IB] == 0;
            if (step[k+1] && ends[k] != (pos[IB*(k+1) +: IB] == END)) kept[k] = 1'b0;
            if (pos[IB*k +: IB] > END || pos[IB*(k+1) +: IB] > END) kept[k] = 1'b0;
        end
        if (!(step[3] && pos[3*IB +: IB] != 0) && \u_dut.carry_q != 0) kept[3] = 1'b0;
        if (!\u_dut.busy_q && (\u_dut.i_q != 0 || \u_dut.j_q != 0)) kept[3] = 1'b0;
        if (first_q && (!\u_dut.busy_q || \u_dut.i_q != 0 || \u_dut.j_q != 0)) kept[3] = 1'b0;
        if (!first_q && \u_dut.j_q > (narrow_q ? LAST_N : LAST_B)) kept[3] = 1'b0;
    end
    always @(posedge clk) begin
        pos_q   <= rst ? 0 : pos[3*IB-1:0];
        first_q <= start && ready && !rst;
        if (first_q) narrow_q <= narrow;
    end

    // ---- the product that began in clock 0 ----
    reg  [5:0]    age_q = 6'd0;
    reg  [AW-1:0] a_q;
    reg  [BW-1:0] b_q;
    function signed [35:0] times(input signed [17:0] x, input signed [17:0] y); times = x * y;
    endfunction
    (* anyseq *) wire [34*A-1:0] a_all;              // a constant bit would leave its product
    (* anyseq *) wire [17*B-1:0] b_all;
    wire [2*A*ROWS-1:0] fit;
    wire [34*A+17*ROWS-1:0] sum [0:ROWS];
    assign sum[0] = 0;
    genvar i, j;
    generate
        for (j = 0; j < ROWS; j = j + 1) begin : g_row
            wire [34*A+17*ROWS-1:0] row [0:A];
            assign row[0] = sum[j];
            for (i = 0; i < A; i = i + 1) begin : g_piece
                wire [35:0] low  = times({1'b0, a_all[34*i +: 17]}, {1'b0, b_all[17*j +: 17]});
                wire [35:0] high = times({1'b0, a_all[34*i+17 +: 17]}, {1'b0, b_all[17*j +: 17]});
                wire [34*A+17*ROWS-1:0] one = {19'd0, low[33:0]} + {2'd0, high[33:0], 17'd0};
                assign fit[2*(A*j+i) +: 2] = {low <= MOST, high <= MOST};
                assign row[i+1] = row[i] + (one << (34*i + 17*j));
            end
            assign sum[j+1] = row[A];
        end
    endgenerate
    always @(posedge clk) begin
        if (!(&age_q)) age_q <= age_q + 1'b1;
        if (age_q == 1) {a_q, b_q} <= {a, b};
    end
    generate
        if (RULES != 0) begin : g_rules
            always @* begin
                if (age_q == 0) assume (rst);
                if (\u_dut.busy_q && !first_q) assume (narrow == narrow_q);
                if (age_q != 0) assert (&kept);
            end
        end else begin : g_product
            always @* begin
                assume (!rst);
                if (age_q == 0) assume (&kept && start && ready);
                if (age_q >= 1 && age_q <= STEPS) assume (narrow == NARROW);
                if (age_q > 1 && age_q <= STEPS) assume (a == a_q && b == b_q);
                if (age_q == STEPS + 4) begin
                    assume (a_all == a_q && b_all == b_q && &fit);
                    assert (done);
                    if (NARROW != 0) assert (few == sum[ROWS][AW+BN-1:0]);
                    else             assert (p == sum[ROWS][AW+BW-1:0]);
                end
            end
        end
    endgenerate
endmodule
`default_nettype wire
