// rt_reflect_twelve.v - mirrored direction, one every twelve clocks
// SPDX-License-Identifier: Apache-2.0
//   out = normalise(dir*nn - 2*n*dn)    nn = n.n    dn = dir.n
// Directions d and n are cut into pieces of 17 bits, l and h, nn and dn into 0, 1 and 2. Frames of
// twelve slots: dn of the vectors at the port, then the products of those that were taken last:
//   slot     1, 2, 3: x, y, z    4, 7, 10: x, y, z    5, 8, 11    6, 9, 12
//   p0       dl*nl               dl*nn0               dl*nn1      dl*nn2
//   p1       dh*nh               dh*nn2               dh*nn0      dh*nn1
//   p2       nl*dh               nl*dn0               nl*dn1      nl*dn2
//   p3       nh*dl               nh*dn2               nh*dn0      nh*dn1
// Then p0 - 2*p2 and p1 - 2*p3 | their sum, where weights are equal | one accumulator | normalise
// Latency 24 clocks. Model: sph_reflect() in cmodel/shade/surface.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_check.vh"
module rt_reflect_twelve #(
    parameter WD  = 25,  // direction and normal component, bits, 18 to 25
    parameter TAG = 8    // tag, bits
) (
    input  wire                 clk,
    input  wire                 rst,
    input  wire                 in_valid_i,     // stays, and the vectors, until they are taken
    output wire                 in_ready_o,     // in slot 12 if valid was high before slot 1
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
    `RT_CHECK(WD >= 18 && WD <= 25, rt_bounce_twelve_WD_must_be_18_to_25)
    localparam VW = 3*WD + 1;                   // |out| = |dir| * nn < sqrt(27) * 2^(3WD-3)
    localparam AW = VW + 2;                     // and its first step, below 1.5 * 2^3WD + 2^38

    // ---- control: slot_q[n] in slot n; offered: what stands at the port was there in slot 1 ----
    reg  [12:1] slot_q;
    reg         offered_q, taken_q;             // taken: the frame has products
    wire        take = in_valid_i && in_ready_o;
    assign in_ready_o = slot_q[12] && offered_q;
    always @(posedge clk) begin
        slot_q <= {slot_q[11:1], slot_q[12]};
        if (slot_q[1])  offered_q <= in_valid_i;
        if (slot_q[12]) taken_q   <= take;
        if (rst) begin
            slot_q    <= 12'd1;
            offered_q <= 1'b0;
            taken_q   <= 1'b0;
        end
    end

    // ---- what was taken: components rotate every three slots, pieces every slot ----
    reg  [TAG-1:0]  tag_q;
    reg  [3*WD-1:0] dir_q, nrm_q;               // x, the one in turn, at the bottom
    reg  [53:0]     nn_q, dn_q;                 // pieces {2, 1, 0}, 18 bits signed each
    wire [51:0]     dn;
    reg             behind_q;
    wire [50:0]     nn = {{(51-2*WD){1'b0}}, in_nn_i};
    wire            turn = slot_q[6] || slot_q[9];
    always @(posedge clk) begin
        if (take) begin
            tag_q <= in_tag_i;
            behind_q <= dn[51];
            dir_q <= {in_dir_z_i, in_dir_y_i, in_dir_x_i};
            nrm_q <= {in_normal_z_i, in_normal_y_i, in_normal_x_i};
            nn_q  <= {1'b0, nn[50:34], 1'b0, nn[33:17], 1'b0, nn[16:0]};
            dn_q  <= {dn[51:34], 1'b0, dn[33:17], 1'b0, dn[16:0]};
        end else begin
            if (turn) begin
                dir_q <= {dir_q[WD-1:0], dir_q[3*WD-1:WD]};
                nrm_q <= {nrm_q[WD-1:0], nrm_q[3*WD-1:WD]};
            end
            if (|slot_q[12:4]) begin
                nn_q <= {nn_q[17:0], nn_q[53:18]};
                dn_q <= {dn_q[17:0], dn_q[53:18]};
            end
        end
        if (slot_q[12]) {out_behind_o, out_tag_o} <= {behind_q, tag_q};  // stay until it is out
    end

    // ---- stage 1: operands; stage 2: products ----
    wire          dots = |slot_q[3:1];
    wire [WD-1:0] d = slot_q[1] ? in_dir_x_i : slot_q[2] ? in_dir_y_i
                      : slot_q[3] ? in_dir_z_i : dir_q[WD-1:0];
    wire [WD-1:0] n = slot_q[1] ? in_normal_x_i : slot_q[2] ? in_normal_y_i
                      : slot_q[3] ? in_normal_z_i : nrm_q[WD-1:0];
    wire signed [17:0] d_l = {1'b0, d[16:0]}, d_h = {{(35-WD){d[WD-1]}}, d[WD-1:17]};
    wire signed [17:0] n_l = {1'b0, n[16:0]}, n_h = {{(35-WD){n[WD-1]}}, n[WD-1:17]};
    reg  signed [17:0] s1_a0_q, s1_a1_q, s1_a2_q, s1_a3_q, s1_b0_q, s1_b1_q, s1_b2_q, s1_b3_q;
    reg  signed [35:0] s2_p0_q, s2_p1_q, s2_p2_q, s2_p3_q;
    always @(posedge clk) begin
        s1_a0_q <= d_l;
        s1_a1_q <= d_h;
        s1_a2_q <= n_l;
        s1_a3_q <= n_h;
        s1_b0_q <= dots ? n_l : $signed(nn_q[17:0]);
        s1_b1_q <= dots ? n_h : $signed(nn_q[53:36]);
        s1_b2_q <= dots ? d_h : $signed(dn_q[17:0]);
        s1_b3_q <= dots ? d_l : $signed(dn_q[53:36]);
        s2_p0_q <= s1_a0_q * s1_b0_q;
        s2_p1_q <= s1_a1_q * s1_b1_q;
        s2_p2_q <= s1_a2_q * s1_b2_q;
        s2_p3_q <= s1_a3_q * s1_b3_q;
    end

    // ---- dn: three products of each weight in slots 3 to 5, joined; from slot 8 on ----
    reg  signed [37:0] ll_q, hh_q;
    reg  signed [38:0] mid_q;
    reg  [51:0]        low_dn_q;
    reg  [51:0]        dn_sum_q;
    wire signed [37:0] p0 = {{2{s2_p0_q[35]}}, s2_p0_q}, p1 = {{2{s2_p1_q[35]}}, s2_p1_q};
    wire signed [38:0] p2 = {{3{s2_p2_q[35]}}, s2_p2_q}, p3 = {{3{s2_p3_q[35]}}, s2_p3_q};
    always @(posedge clk) begin
        if (|slot_q[5:3]) begin
            ll_q  <= (slot_q[3] ? 38'sd0 : ll_q) + p0;
            hh_q  <= (slot_q[3] ? 38'sd0 : hh_q) + p1;
            mid_q <= (slot_q[3] ? 39'sd0 : mid_q) + (p2 + p3);
        end
        low_dn_q <= {{{14{ll_q[37]}}, ll_q[37:17]} + mid_q[34:0], ll_q[16:0]};
        dn_sum_q <= {low_dn_q[51:34] + hh_q[17:0], low_dn_q[33:0]};
    end
    assign dn = dn_sum_q;

    // ---- stages 3 to 5: dir*nn - 2*n*dn of a component; first, last: of its three steps ----
    reg  signed [37:0]   s3_e_q, s3_f_q;
    reg  signed [38:0]   s4_t_q;
    reg  signed [37:0]   s4_f_q;
    reg  signed [AW-1:0] acc_q;                 // 17 bits leave with every step
    reg  [33:0]          acc_low_q;
    reg  [5:1]           first_q, last_q;       // in stage n
    wire signed [AW-1:0] s4_t = {{(AW-39){s4_t_q[38]}}, s4_t_q};
    wire signed [AW-1:0] acc_old = first_q[4] ? $signed({s4_f_q[AW-52:0], 51'd0}) : acc_q >>> 17;
    wire [AW+33:0]       v = {acc_q, acc_low_q};
    always @(posedge clk) begin
        s3_e_q <= p0 - $signed({p2[36:0], 1'b0});
        s3_f_q <= p1 - $signed({p3[36:0], 1'b0});
        s4_t_q <= $signed({s3_e_q[37], s3_e_q})
                + (first_q[3] ? 39'sd0 : $signed({s3_f_q[37], s3_f_q}));
        s4_f_q <= s3_f_q;
        acc_q  <= acc_old + s4_t;
        acc_low_q <= {acc_q[16:0], acc_low_q[33:17]};
        first_q <= {first_q[4:1], taken_q && (slot_q[4] || slot_q[7] || slot_q[10])};
        last_q  <= {last_q[4:1], taken_q && (slot_q[6] || slot_q[9] || slot_q[12])};
        if (rst) last_q <= 5'd0;
    end

    // ---- to normalisation, out 7 cycles behind z ----
    rt_normalise #(.VW(VW), .BITS(WD)) u_normalise (
        .clk(clk), .rst(rst),
        .in_valid_i(last_q[5]), .in_v_i($signed(v[VW-1:0])),
        .out_valid_o(out_valid_o),
        .out_x_o(out_dir_x_o), .out_y_o(out_dir_y_o), .out_z_o(out_dir_z_o)
    );
    // for benches: {turned away, taken, clocks of work}
    wire [7:0] work_mirrored_directions /* verilator public_flat_rd */ =
        {in_valid_i && !in_ready_o, take, 2'd0, take, take, 2'd0};
    wire unused = &{1'b0, v, p2, p3, hh_q, mid_q, first_q[5], s4_f_q};
endmodule
`default_nettype wire
