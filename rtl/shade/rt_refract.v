// rt_refract.v - direction of a ray behind a surface, or total internal reflection
// SPDX-License-Identifier: Apache-2.0
// d, n shifted so that 2^(WD-1) <= |d|, |n| < 2^WD; p, q: index of the side it leaves, it enters;
//   A = d.d  N = n.n  B = d.n  X = (q-p)*(q+p)*A*N + (p*B)^2   X < 0: all is reflected
//   out = normalise(p*N*d - (p*B + floor(sqrt(X / 4^s)) * 2^s) * n)
// One product after another, DIGIT bits of the second factor a clock, and one root: slow and small.
//   shift | B p*B p*N | A*N *(q-p) *(q+p) | + (p*B)^2 | root | x y z, to rt_normalise
// A digit: 1 products with pieces of the first factor | 2 their sum | 3 added up
// Model: sph_refract() in cmodel/shade/refract.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_check.vh"
`include "rt_layout.vh"
module rt_refract #(
    parameter W     = 16,  // coordinate, bits
    parameter WD    = 17,  // direction and normal component, bits, W+1 to `RT_REFRACT_WD
    parameter PR    = 0,   // significant bits of the root, 0: all
    parameter DIGIT = 17,  // bits of a factor a clock, and of a piece of the other, 2 or more
    parameter STEP  = 2,   // root bits a clock
    parameter TAG   = 8    // tag, bits
) (
    input  wire            clk,
    input  wire            rst,
    input  wire            in_valid_i,
    output wire            in_ready_o,
    input  wire [TAG-1:0]  in_tag_i,
    input  wire [3*WD-1:0] in_dir_i,       // {z, y, x} sWD, of the ray that hit
    input  wire [2*WD-1:0] in_a_i,         // dir.dir
    input  wire [3*WD-1:0] in_normal_i,    // {z, y, x} sWD, towards the ray's side
    input  wire [2*WD-1:0] in_nn_i,        // normal.normal
    input  wire [11:0]     in_from_i,      // p, thousandths
    input  wire [11:0]     in_to_i,        // q
    output wire            out_valid_o,    // one cycle
    output wire [TAG-1:0]  out_tag_o,
    output wire            out_total_o,    // all is reflected: out_dir_o is nothing
    output wire [3*WD-1:0] out_dir_o       // {z, y, x} sWD
);
    localparam XW = 4*WD + 25;             // X and all that is added up
    localparam BW = 2*WD + 13;             // p*B
    localparam LW = 2*WD + 14;             // p*B + root
    localparam QW = 2*W + 2*WD;            // radicand
    localparam RB = PR != 0 ? PR : W + WD; // root
    localparam S  = WD - W + 12;
    localparam VW = 3*WD + 13;             // direction before it is normalised
    // digits of a factor's magnitude
    localparam D_VEC = (WD + DIGIT - 1) / DIGIT;   // |d|, |n| < 2^WD
    localparam D_IDX = (13 + DIGIT - 1) / DIGIT;   // p, q-p, q+p
    localparam D_NN  = (2*WD + DIGIT - 1) / DIGIT;
    localparam D_PB  = (BW - 1 + DIGIT - 1) / DIGIT;
    localparam RW    = D_PB*DIGIT;                 // the longest
    localparam PIECES = (XW + DIGIT - 1) / DIGIT;  // of the other factor
    localparam PAIRS  = (PIECES + 1) / 2;
    localparam CW    = $clog2(D_PB + 1);
    localparam HW    = $clog2(WD + 1);
    `RT_CHECK(WD <= `RT_REFRACT_WD, rt_refract_WD_must_be_at_most_RT_REFRACT_WD)

    // ---- control: a product is loaded and runs; if its sum is waited for, it is added first, in
    // two clocks ----
    localparam [2:0] IDLE = 3'd0, SHIFT = 3'd1, LOAD = 3'd2, RUN = 3'd3, ADD = 3'd4, TEST = 3'd5,
                     ROOT = 3'd6, END = 3'd7;
    localparam [3:0] O_B = 4'd0, O_PB = 4'd3, O_PN = 4'd4, O_AN = 4'd5, O_LESS = 4'd6,
                     O_MORE = 4'd7, O_SQUARE = 4'd8, O_X = 4'd10;
    reg  [2:0]     state_q;
    reg  [3:0]     op_q;                   // O_B + 0..2; O_X..15: p*N*d[i], then (p*B + root)*n[i]
    reg  [CW-1:0]  left_q;                 // digits
    reg            added_q;                // second clock of ADD
    wire           last = left_q == {{(CW-1){1'b0}}, 1'b1};
    wire           vector = op_q >= O_X || op_q < O_PB;
    wire           follow = op_q < O_B + 4'd2 || op_q == O_MORE || (op_q >= O_X && !op_q[0]);
    wire           take = in_valid_i && in_ready_o;
    wire           normal_long, dir_long;
    reg  [HW-1:0]  room_q;                 // shifts left: a vector of 0 has none that ends
    wire           shifted = (normal_long && dir_long) || room_q == {HW{1'b0}};
    wire           root_valid, norm_valid;
    reg  signed [XW-1:0] acc_q;
    wire           total = state_q == TEST && acc_q[XW-1];
    assign in_ready_o  = state_q == IDLE;
    assign out_total_o = total;
    assign out_valid_o = total || norm_valid;
    always @(posedge clk) begin
        case (state_q)
            IDLE:  if (take) state_q <= SHIFT;
            SHIFT: if (shifted) state_q <= LOAD;
            LOAD:  state_q <= RUN;
            RUN:   if (last) state_q <= follow ? LOAD : ADD;
            ADD:   if (added_q) state_q <= op_q == O_SQUARE ? TEST : op_q == 4'd15 ? END : LOAD;
            TEST:  state_q <= total ? IDLE : ROOT;
            ROOT:  if (root_valid) state_q <= LOAD;
            default: if (norm_valid) state_q <= IDLE;
        endcase
        if (state_q == SHIFT) op_q <= O_B;
        else if ((state_q == RUN && last && follow) || (added_q && op_q != O_SQUARE))
            op_q <= op_q + 4'd1;
        else if (state_q == TEST) op_q <= O_X;
        added_q <= state_q == ADD && !added_q;
        room_q <= take ? WD[HW-1:0] : room_q - 1'b1;
        if (rst) begin state_q <= IDLE; added_q <= 1'b0; end
    end

    // ---- operands; vectors are shifted up, then rotate ----
    reg  [TAG-1:0]      tag_q;
    reg  [11:0]         from_q, to_q;
    reg  signed [WD:0]  dx_q, dy_q, dz_q, nx_q, ny_q, nz_q;
    reg  [2*WD-1:0]     a_q, nn_q;
    assign dir_long    = |a_q[2*WD-1 -: 2];
    assign normal_long = |nn_q[2*WD-1 -: 2];
    wire                turn = state_q == LOAD && vector && !(op_q >= O_X && !op_q[0]);
    always @(posedge clk)
        if (take) begin
            tag_q  <= in_tag_i;
            from_q <= in_from_i;
            to_q   <= in_to_i;
            a_q    <= in_a_i;
            nn_q   <= in_nn_i;
            dx_q   <= {in_dir_i[WD-1], in_dir_i[0 +: WD]};
            dy_q   <= {in_dir_i[2*WD-1], in_dir_i[WD +: WD]};
            dz_q   <= {in_dir_i[3*WD-1], in_dir_i[2*WD +: WD]};
            nx_q   <= {in_normal_i[WD-1], in_normal_i[0 +: WD]};
            ny_q   <= {in_normal_i[2*WD-1], in_normal_i[WD +: WD]};
            nz_q   <= {in_normal_i[3*WD-1], in_normal_i[2*WD +: WD]};
        end else if (state_q == SHIFT) begin
            if (!dir_long && !shifted) begin
                a_q <= a_q << 2;
                {dx_q, dy_q, dz_q} <= {dx_q[WD-1:0], 1'b0, dy_q[WD-1:0], 1'b0, dz_q[WD-1:0], 1'b0};
            end
            if (!normal_long && !shifted) begin
                nn_q <= nn_q << 2;
                {nx_q, ny_q, nz_q} <= {nx_q[WD-1:0], 1'b0, ny_q[WD-1:0], 1'b0, nz_q[WD-1:0], 1'b0};
            end
        end else if (turn) begin
            {dx_q, dy_q, dz_q} <= {dy_q, dz_q, dx_q};
            {nx_q, ny_q, nz_q} <= {ny_q, nz_q, nx_q};
        end

    // ---- products: acc +-= m * |r|, digits of |r| from the lowest on; all modulo 2^XW ----
    reg  signed [XW-1:0]  m_q;
    reg  [RW-1:0]         r_q;
    reg                   minus_q, clear_q;
    reg  signed [BW-1:0]  pb_q;
    reg  [2*WD+11:0]      pn_q;
    reg  signed [LW-1:0]  along_q;
    wire signed [XW-1:0]  w_dx = {{(XW-WD-1){dx_q[WD]}}, dx_q};
    wire signed [XW-1:0]  w_pb = {{(XW-BW){pb_q[BW-1]}}, pb_q};
    wire signed [XW-1:0]  w_along = {{(XW-LW){along_q[LW-1]}}, along_q};
    wire signed [13:0]    less = $signed({2'b00, to_q}) - $signed({2'b00, from_q});
    wire [13:0]           more = {2'b00, to_q} + {2'b00, from_q};
    wire [3:0]            op_next = state_q == SHIFT ? O_B : state_q == ROOT ? O_X : op_q + 4'd1;
    reg  signed [RW:0]    r, r_next_q;     // of the next product; of that which is loaded
    always @*
        case (op_next)
            O_PB, O_PN: r = {{(RW-11){1'b0}}, from_q};
            O_AN:     r = {{(RW+1-2*WD){1'b0}}, nn_q};
            O_LESS:   r = {{(RW-13){less[13]}}, less};
            O_MORE:   r = {{(RW-13){1'b0}}, more};
            O_SQUARE: r = {{(RW+1-BW){pb_q[BW-1]}}, pb_q};
            default:  r = op_next >= O_X && !op_next[0] ? {{(RW-WD){dx_q[WD]}}, dx_q}
                          : {{(RW-WD){nx_q[WD]}}, nx_q};
        endcase
    always @(posedge clk) r_next_q <= r;
    wire signed [RW:0]    r_less = -r_next_q;
    always @(posedge clk) begin
        if (state_q == RUN) begin
            clear_q <= 1'b0;
            left_q  <= left_q - 1'b1;
            m_q     <= m_q <<< DIGIT;
            r_q     <= r_q >> DIGIT;
        end
        if (state_q == LOAD) begin
            clear_q <= !(op_q == O_B + 4'd1 || op_q == O_B + 4'd2 || op_q == O_SQUARE ||
                         (op_q >= O_X && op_q[0]));
            case (op_q)
                O_PB, O_LESS, O_MORE: m_q <= acc_q;
                O_PN:     m_q <= {{(XW-2*WD){1'b0}}, nn_q};
                O_AN:     m_q <= {{(XW-2*WD){1'b0}}, a_q};
                O_SQUARE: m_q <= w_pb;
                default:  m_q <= op_q < O_PB ? w_dx : op_q[0] ? w_along
                                 : {{(XW-2*WD-12){1'b0}}, pn_q};
            endcase
            r_q     <= r_next_q[RW] ? r_less[RW-1:0] : r_next_q[RW-1:0];
            minus_q <= r_next_q[RW] ^ (op_q >= O_X && op_q[0]);
            case (op_q)
                O_PB, O_PN, O_LESS, O_MORE: left_q <= D_IDX[CW-1:0];
                O_AN:     left_q <= D_NN[CW-1:0];
                O_SQUARE: left_q <= D_PB[CW-1:0];
                default:  left_q <= D_VEC[CW-1:0];
            endcase
        end
        if (state_q == LOAD && op_q == O_PN) pb_q <= acc_q[BW-1:0];
        if (state_q == LOAD && op_q == O_AN) pn_q <= acc_q[2*WD+11:0];
    end

    // ---- a digit: pieces at even and at odd places do not overlap ----
    wire [2*PAIRS*DIGIT-1:0] m_long = {{(2*PAIRS*DIGIT-XW){1'b0}}, m_q};
    reg  [2*PAIRS*DIGIT-1:0] even_q, odd_q;
    wire [2*PAIRS*DIGIT-1:0] row = even_q + (odd_q << DIGIT);
    reg  [XW-1:0]            row_q;
    reg                      p_valid_q, p_clear_q, p_minus_q, row_valid_q, row_clear_q, row_minus_q;
    integer k;
    always @(posedge clk) begin
        p_valid_q <= state_q == RUN;
        p_clear_q <= clear_q;
        p_minus_q <= minus_q;
        for (k = 0; k < PAIRS; k = k + 1) begin
            even_q[2*DIGIT*k +: 2*DIGIT] <= m_long[2*DIGIT*k +: DIGIT] * r_q[DIGIT-1:0];
            odd_q[2*DIGIT*k +: 2*DIGIT]  <= m_long[2*DIGIT*k + DIGIT +: DIGIT] * r_q[DIGIT-1:0];
        end
        row_valid_q <= p_valid_q;
        row_clear_q <= p_clear_q;
        row_minus_q <= p_minus_q;
        row_q       <= row[XW-1:0];
        if (row_valid_q)
            acc_q <= (row_clear_q ? {XW{1'b0}} : acc_q) + (row_minus_q ? -row_q : row_q);
    end

    // ---- root ----
    wire [RB-1:0] root;
    wire [5:0]    zeros;
    wire          root_in, inexact, root_tag;
    rt_isqrt #(.XW(QW), .STEP(STEP), .BITS(PR)) u_isqrt (
        .clk(clk), .rst(rst), .in_valid_i(state_q == TEST && !total),
        .in_ready_o(root_in), .in_x_i(acc_q[2*S +: QW]), .in_tag_i(1'b0),
        .out_valid_o(root_valid), .out_root_o(root), .out_shift_o(zeros),
        .out_inexact_o(inexact), .out_tag_o(root_tag)
    );
    wire [LW-1:0] root_long = {{(LW-RB-S){1'b0}}, root, {S{1'b0}}} << zeros;
    always @(posedge clk)
        if (root_valid) along_q <= {pb_q[BW-1], pb_q} + root_long;

    // ---- x, y, z of the direction ----
    reg           component_q;             // one is added up
    always @(posedge clk) begin
        component_q <= added_q && op_q > O_X;
        if (rst) component_q <= 1'b0;
    end
    rt_normalise #(.VW(VW), .BITS(WD)) u_normalise (
        .clk(clk), .rst(rst), .in_valid_i(component_q),
        .in_v_i(acc_q[VW-1:0]), .out_valid_o(norm_valid),
        .out_x_o(out_dir_o[0 +: WD]), .out_y_o(out_dir_o[WD +: WD]),
        .out_z_o(out_dir_o[2*WD +: WD])
    );
    assign out_tag_o = tag_q;
    // for benches: {turned away, taken, clocks of work}
    wire [7:0] work_refracted_directions /* verilator public_flat_rd */ =
        {in_valid_i && !in_ready_o, take, 5'd0, take || !in_ready_o};
    wire unused = &{1'b0, root_in, inexact, root_tag, r_less[RW], row};
endmodule
`default_nettype wire
