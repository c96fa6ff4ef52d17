// rt_long_product.v - product of two long unsigned numbers from two 18x18 multipliers
// SPDX-License-Identifier: Apache-2.0
// p = a * b, 34 bits of a by 17 bits of b a clock: a row of a by each piece of b, the lowest first.
//   row: sum = piece of a * piece of b + what stands there + carry; then 17 bits of p are ready
// A row takes ceil(AW/34) + 1 clocks. Operands stand still from the clock after start_i on, until
// ready_o is high again, in the last clock of the last row; then the next product may be started.
// done_o comes 4 clocks later; p_o stands from then on until the pieces of the next product come.
// Model: the product itself.
`timescale 1ns / 1ps
`default_nettype none
module rt_long_product #(
    parameter AW = 50,                     // bits of a
    parameter BW = 34,                     // bits of b
    parameter BN = 17                      // bits of a narrow b, at most BW
) (
    input  wire             clk,
    input  wire             rst,           // synchronous, active high
    input  wire             start_i,       // while ready_o is high
    output wire             ready_o,       // the next product may start
    input  wire             narrow_i,      // an operand too: b has BN bits
    input  wire [AW-1:0]    a_i,           // uAW
    input  wire [BW-1:0]    b_i,           // uBW
    output wire             done_o,
    output wire [AW+BW-1:0] p_o,           // u(AW+BW)
    output wire [AW+BN-1:0] narrow_o       // u(AW+BN), of a narrow b
);
    localparam A = (AW + 33) / 34, B = (BW + 16) / 17, N = (BN + 16) / 17;  // pieces
    localparam IB = $clog2(A + 1), JB = B > 1 ? $clog2(B) : 1;
    localparam [IB-1:0] END = A[IB-1:0];
    localparam LAST_B = B - 1, LAST_N = N - 1;

    // ---- step: piece of a, piece of b; the step behind the last piece shifts ----
    reg           busy_q;
    reg  [IB-1:0] i_q;
    reg  [JB-1:0] j_q;
    wire          end_row = i_q == END;
    wire          last = end_row && j_q == (narrow_i ? LAST_N[JB-1:0] : LAST_B[JB-1:0]);
    assign ready_o = !busy_q || last;
    always @(posedge clk) begin
        if (busy_q) begin
            i_q <= end_row ? {IB{1'b0}} : i_q + 1'b1;
            j_q <= last ? {JB{1'b0}} : end_row ? j_q + 1'b1 : j_q;
        end
        if (ready_o) busy_q <= start_i;
        if (rst) begin
            busy_q <= 1'b0;
            i_q    <= {IB{1'b0}};
            j_q    <= {JB{1'b0}};
        end
    end
    wire [34*A-1:0] a = {{(34*A-AW){1'b0}}, a_i};
    wire [17*B-1:0] b = {{(17*B-BW){1'b0}}, b_i};
    reg  [33:0] a_one, a_q;
    reg  [16:0] b_one, b_q;
    reg  [11:0] step_q;                    // {last, end of row, first row, step}, three stages
    integer     n;
    always @* begin
        a_one = 34'd0;
        b_one = 17'd0;
        for (n = 0; n < A; n = n + 1)
            a_one = a_one | (a[34*n +: 34] & {34{i_q == n[IB-1:0]}});
        for (n = 0; n < B; n = n + 1)
            b_one = b_one | (b[17*n +: 17] & {17{j_q == n[JB-1:0]}});
    end
    always @(posedge clk) begin
        a_q <= a_one;
        b_q <= b_one;
        step_q <= {step_q[7:0], last, end_row, j_q == {JB{1'b0}}, busy_q};
        if (rst) step_q <= 12'd0;
    end
    wire [52:0] p;
    rt_product #(.AW(35), .BW(18)) u_product (
        .clk(clk), .a_i($signed({1'b0, a_q})), .b_i($signed({1'b0, b_q})), .p_o(p)
    );

    // ---- sums: the row's window of p goes round, what is ready leaves below ----
    reg  [34*A-1:0] row_q;
    reg  [17*B-1:0] low_q;
    reg  [16:0]     carry_q;
    reg             done_q;
    wire            s_step = step_q[8], s_first = step_q[9], s_end = step_q[10];
    wire [50:0]     sum = p[50:0] + {17'd0, s_first ? 34'd0 : row_q[33:0]} + {34'd0, carry_q};
    wire [34*A+33:0] next = {sum[33:0], row_q};
    wire [17*B+16:0] below = {row_q[16:0], low_q};
    always @(posedge clk) begin
        if (s_step) begin
            row_q   <= s_end ? {carry_q, row_q[34*A-1:17]} : next[34*A+33:34];
            carry_q <= s_end ? 17'd0 : sum[50:34];
        end
        if (s_step && s_end) low_q <= below[17*B+16:17];
        done_q <= s_step && step_q[11];
        if (rst) begin
            carry_q <= 17'd0;
            done_q  <= 1'b0;
        end
    end
    wire [34*A+17*B-1:0] all = {row_q, low_q};
    wire [34*A+17*N-1:0] few = all[17*(B-N) +: 34*A+17*N];
    assign p_o      = all[AW+BW-1:0];
    assign narrow_o = few[AW+BN-1:0];
    assign done_o   = done_q;
    wire unused = &{1'b0, all, few, p[52:51], next[33:0], below[16:0]};
endmodule
`default_nettype wire
