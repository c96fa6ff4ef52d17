// rt_isqrt.v - integer square root, STEP bits a clock
// SPDX-License-Identifier: Apache-2.0
// root = floor(sqrt(x)), inexact = (root^2 != x). Digit by digit: two radicand bits enter rem, and
// the trial 4*root+1 is subtracted if it fits. Invariant: rem = x / 4^i - root^2 <= 2*root.
// One radicand at a time: a result ceil(XW/2/STEP) + 1 clocks after its radicand.
// Model: sph_isqrt() in cmodel/math/isqrt.c
`default_nettype none
module rt_isqrt #(
    parameter XW   = 66,                   // radicand, bits: even
    parameter STEP = 2                     // root bits a clock: 1 to XW/2
) (
    input  wire            clk,
    input  wire            rst,            // synchronous, active high
    // from rt_root_pool
    input  wire            in_valid_i,
    output wire            in_ready_o,
    input  wire [XW-1:0]   in_x_i,         // uXW
    // to rt_root_pool
    output wire            out_valid_o,
    input  wire            out_ready_i,
    output wire [XW/2-1:0] out_root_o,     // u(XW/2)
    output wire            out_inexact_o   // root^2 != x
);
    generate
        if (XW % 2 != 0 || STEP < 1 || STEP > XW/2) begin : g_check
            rt_isqrt_XW_must_be_even_and_STEP_1_to_half_of_it u_error ();
        end
    endgenerate
    localparam ROUNDS = (XW/2 + STEP - 1) / STEP;
    localparam RW     = ROUNDS*STEP;       // root bits of whole rounds; the first ones are 0
    localparam CW     = $clog2(ROUNDS + 1);
    localparam [CW-1:0] FIRST = ROUNDS[CW-1:0];

    // ---- one round: STEP digits ----
    reg [2*RW-1:0] x_q;                    // radicand, next bits at the top
    reg [RW-1:0]   root_q;                 // digits so far
    reg [RW:0]     rem_q;                  // at most 2*root
    reg [2*RW-1:0] x_d;
    reg [RW-1:0]   root_d;
    reg [RW+2:0]   rem_d;
    reg [RW+2:0]   left;                   // rem - trial, top bit: it does not fit
    integer i;
    always @* begin
        x_d    = x_q;
        root_d = root_q;
        rem_d  = {2'd0, rem_q};
        left   = {(RW+3){1'b0}};
        for (i = 0; i < STEP; i = i + 1) begin
            rem_d  = {rem_d[RW:0], x_d[2*RW-1 -: 2]};
            x_d    = x_d << 2;
            left   = rem_d - {1'b0, root_d, 2'b01};
            root_d = {root_d[RW-2:0], !left[RW+2]};
            if (!left[RW+2]) rem_d = left;
        end
    end

    // ---- control: rounds left; the result stays in the registers until it is taken ----
    reg          full_q;                   // a radicand or its root is inside
    reg [CW-1:0] count_q;                  // rounds left
    wire         take = in_valid_i && in_ready_o;
    always @(posedge clk) begin
        if (take) begin
            full_q  <= 1'b1;
            count_q <= FIRST;
            x_q     <= {{(2*RW-XW){1'b0}}, in_x_i};
            root_q  <= {RW{1'b0}};
            rem_q   <= {(RW+1){1'b0}};
        end else if (count_q != 0) begin
            count_q <= count_q - 1'b1;
            x_q     <= x_d;
            root_q  <= root_d;
            rem_q   <= rem_d[RW:0];
        end else if (out_ready_i) begin
            full_q <= 1'b0;
        end
        if (rst) begin
            full_q  <= 1'b0;
            count_q <= {CW{1'b0}};
        end
    end
    assign out_valid_o   = full_q && count_q == 0;
    assign in_ready_o    = !full_q || (out_valid_o && out_ready_i);
    assign out_root_o    = root_q[XW/2-1:0];
    assign out_inexact_o = |rem_q;

    wire unused = &{1'b0, rem_d[RW+2:RW+1], root_q};
endmodule
`default_nettype wire
