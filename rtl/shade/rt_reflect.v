// rt_reflect.v - mirrored direction
// SPDX-License-Identifier: Apache-2.0
//   out = normalise(dir*(n.n) - 2*(dir.n)*n), exact before the one normalising shift
// Two multipliers: A has dir, B has n as one factor; the other comes in two halves.
//   cycle     1      2      3    5     6     7     8     9     10
//   A      dx*nx  dy*ny  dz*nz  dx*nn(hi,lo) dy*nn(hi,lo) dz*nn(hi,lo)
//   B                           nx*dn(hi,lo) ny*dn(hi,lo) nz*dn(hi,lo)
// Latency 20 cycles, a new one every 10 cycles.
// Model: sph_reflect() in cmodel/shade/surface.c
`timescale 1ns / 1ps
`default_nettype none
module rt_reflect #(
    parameter WD  = 17,  // direction and normal component, bits
    parameter TAG = 8    // tag, bits
) (
    input  wire                 clk,
    input  wire                 rst,
    input  wire                 in_valid_i,
    output wire                 in_ready_o,
    input  wire [TAG-1:0]       in_tag_i,
    input  wire signed [WD-1:0] in_dir_x_i,     // ray direction
    input  wire signed [WD-1:0] in_dir_y_i,
    input  wire signed [WD-1:0] in_dir_z_i,
    input  wire signed [WD-1:0] in_normal_x_i,  // of the surface
    input  wire signed [WD-1:0] in_normal_y_i,
    input  wire signed [WD-1:0] in_normal_z_i,
    input  wire [2*WD-1:0]      in_nn_i,        // normal.normal
    output wire                 out_valid_o,    // one cycle
    output reg  [TAG-1:0]       out_tag_o,
    output reg                  out_behind_o,   // dir.n < 0
    output wire signed [WD-1:0] out_dir_x_o,
    output wire signed [WD-1:0] out_dir_y_o,
    output wire signed [WD-1:0] out_dir_z_o
);
    localparam PW = 2*WD + 1;                   // WD * (WD+1) bits; also dn: |dn| <= 3 * 2^(2WD-2)
    localparam DW = 2*WD + 2;                   // A - 2*B: below 1.5 * 2^2WD
    localparam VW = 3*WD + 1;                   // |out| = |dir| * nn < sqrt(27) * 2^(3WD-3)

    // ---- control: ph_q[n] n cycles after the input was taken ----
    reg  [13:1]          ph_q;
    wire                 take = in_valid_i && in_ready_o;
    assign in_ready_o = ~|ph_q[9:1];
    always @(posedge clk) begin
        ph_q <= {ph_q[12:1], take};
        if (rst) ph_q <= 13'd0;
    end

    reg  signed [PW-1:0] s2_dn_q;               // dir.n
    // ---- input: components rotate, x is the one in turn ----
    reg  [TAG-1:0]       in_tag_q;
    reg  signed [WD-1:0] dir_x_q, dir_y_q, dir_z_q;
    reg  signed [WD-1:0] nrm_x_q, nrm_y_q, nrm_z_q;
    reg  [2*WD-1:0]      nn_q;
    always @(posedge clk) begin
        if (take) begin
            nn_q <= in_nn_i;
            {dir_x_q, dir_y_q, dir_z_q} <= {in_dir_x_i, in_dir_y_i, in_dir_z_i};
            {nrm_x_q, nrm_y_q, nrm_z_q} <= {in_normal_x_i, in_normal_y_i, in_normal_z_i};
        end else if (|ph_q[3:1] || ph_q[6] || ph_q[8]) begin
            {dir_x_q, dir_y_q, dir_z_q} <= {dir_y_q, dir_z_q, dir_x_q};
            {nrm_x_q, nrm_y_q, nrm_z_q} <= {nrm_y_q, nrm_z_q, nrm_x_q};
        end
        if (take)     in_tag_q  <= in_tag_i;
        if (ph_q[10])                           // stays until the result is out
            {out_behind_o, out_tag_o} <= {s2_dn_q[PW-1], in_tag_q};
    end

    // ---- stage 1: products; the half above bit WD first, signed, then the lower, unsigned;
    //      the factor of A is chosen a cycle before ----
    reg  signed [PW-1:0] s1_a_q, s1_b_q;
    reg  signed [WD:0]   by_q;                  // normal, then nn by halves
    reg                  lo_q;                  // cycles 6, 8, 10
    wire                 lo_next = ph_q[5] || ph_q[7] || ph_q[9];
    wire signed [WD-1:0] nrm_next = take ? in_normal_x_i : nrm_y_q;
    wire signed [WD:0]   nn = $signed({1'b0, lo_next ? nn_q[WD-1:0] : nn_q[2*WD-1:WD]});
    wire signed [WD:0]   dn = $signed(lo_q ? {1'b0, s2_dn_q[WD-1:0]} : s2_dn_q[PW-1:WD]);
    always @(posedge clk) begin
        lo_q   <= lo_next;
        if (in_valid_i || |ph_q[9:1])
            by_q <= take || |ph_q[2:1] ? $signed({nrm_next[WD-1], nrm_next}) : nn;
        if (|ph_q[10:1]) begin
            s1_a_q <= dir_x_q * by_q;
            s1_b_q <= nrm_x_q * dn;
        end
    end

    // ---- stage 2, cycles 2 to 4: dn; cycles 6 to 11: dir*nn - 2*n*dn by halves ----
    reg  signed [DW-1:0] s2_diff_q;
    wire signed [PW-1:0] s2_old = ph_q[2] ? {PW{1'b0}} : s2_dn_q;
    always @(posedge clk) begin
        if (|ph_q[4:2]) s2_dn_q <= s2_old + s1_a_q;
        if (|ph_q[11:6])
            s2_diff_q <= $signed({s1_a_q[PW-1], s1_a_q}) - $signed({s1_b_q, 1'b0});
    end

    // ---- stage 3, cycles 7 to 12: join the halves ----
    reg  signed [DW-1:0] s3_hi_q;
    reg  signed [VW-1:0] s4_v_q;
    always @(posedge clk) if (|ph_q[12:7]) begin
        s3_hi_q <= s2_diff_q;
        s4_v_q  <= $signed({s3_hi_q[VW-WD-1:0], {WD{1'b0}}})
                 + $signed({{(VW-DW){s2_diff_q[DW-1]}}, s2_diff_q});
    end

    // ---- cycles 9, 11, 13: to normalisation, out 7 cycles later ----
    rt_normalise #(.VW(VW), .BITS(WD)) u_normalise (
        .clk(clk), .rst(rst),
        .in_valid_i(ph_q[9] || ph_q[11] || ph_q[13]), .in_v_i(s4_v_q),
        .out_valid_o(out_valid_o),
        .out_x_o(out_dir_x_o), .out_y_o(out_dir_y_o), .out_z_o(out_dir_z_o)
    );
    // for benches: {turned away, taken, clocks of work}
    wire [7:0] work_mirrored_directions /* verilator public_flat_rd */ =
        {in_valid_i && !in_ready_o, take, 5'd0, take || !in_ready_o};
    wire unused = &{1'b0, s3_hi_q[DW-1:VW-WD]};
endmodule
`default_nettype wire
