// rt_facet_key.v - keys of hits on facets
// SPDX-License-Identifier: Apache-2.0
//   key = ceil(a*num' / det'); a plane farther than the grid, num'*size > det'*room:
//   key = ceil(a*room / size) + size - ceil(det'*room / num')
//   hit --+-----------------------> queue --+--> rt_divide, of a far plane twice --> queue --> key
//         +--> is a plane too far? -> queue +
// Keys leave in the order of the hits. Nothing here waits for who takes them: at most HOLD hits may
// be under way. A key every ceil(2*WD/17) clocks, of a far plane half as many.
// Model: end() and sph_facet_key() in cmodel/prim/facet.c
`timescale 1ns / 1ps
`default_nettype none
`include "rt_facet.vh"
module rt_facet_key #(
    parameter W    = 16,                         // coordinate, bits
    parameter WD   = 17,                         // direction component, bits
    parameter TAG  = 30,                         // tag, bits
    parameter DW   = 50,                         // det', bits
    parameter MW   = 49,                         // num', bits
    parameter HOLD = 16                          // hits under way
) (
    input  wire             clk,
    input  wire             rst,                 // synchronous, active high
    // from rt_facet: a hit; planes at least `RT_FACET_PLANE clocks apart
    input  wire             in_valid_i,
    input  wire [TAG-1:0]   in_tag_i,
    input  wire             in_plane_i,
    input  wire [DW-1:0]    in_det_i,            // det', > 0
    input  wire [MW-1:0]    in_num_i,            // num', > 0
    input  wire [2*WD-1:0]  in_a_i,              // dir.dir
    input  wire [W:0]       in_room_i,           // to one unit beyond the grid, along the longest
    input  wire [WD-1:0]    in_size_i,           // axis of dir; |dir| along it
    // to rt_facet
    output wire             out_valid_o,
    input  wire             out_ready_i,
    output wire [TAG-1:0]   out_tag_o,
    output wire [W+WD+1:0]  out_key_o,           // > 0
    // event
    output wire             divide_o             // a key begins
);
    localparam LW = DW > MW ? DW : MW;           // long factor
    localparam NW = W + 1 > WD ? W + 1 : WD;     // narrow one
    localparam KW = W + WD + 2;                  // key
    localparam BW = 2*WD;
    localparam STEPS = `RT_FACET_PLANE(W, WD)/2; // clocks of a product with a narrow factor

    // ---- planes: det'*room, then num'*size; is that more? ----
    wire             plane = in_valid_i && in_plane_i;
    wire             next, p_done, f_in, f_valid, far;
    wire [LW+NW-1:0] p;
    reg  [LW-1:0]    num_q;
    reg  [NW-1:0]    size_q;
    reg  [LW+NW-1:0] face_q;
    reg              second_q;                   // p_done is that of the second product
    rt_delay_valid #(.CYCLES(STEPS)) u_next (
        .clk(clk), .rst(rst), .in_i(plane), .out_o(next)
    );
    rt_long_product #(.AW(LW), .BW(NW)) u_product (
        .clk(clk), .rst(rst), .start_i(plane || next),
        .a_i(plane ? {{(LW-DW){1'b0}}, in_det_i} : num_q),
        .b_i(plane ? {{(NW-W-1){1'b0}}, in_room_i} : size_q), .done_o(p_done), .p_o(p)
    );
    always @(posedge clk) begin
        if (plane) begin
            num_q  <= {{(LW-MW){1'b0}}, in_num_i};
            size_q <= {{(NW-WD){1'b0}}, in_size_i};
        end
        if (p_done) begin
            face_q   <= p;
            second_q <= !second_q;
        end
        if (rst) second_q <= 1'b0;
    end
    wire             pop;
    wire             k_plane;
    rt_fifo #(.WIDTH(1), .DEPTH(HOLD)) u_fars (
        .clk(clk), .rst(rst), .in_valid_i(p_done && second_q), .in_ready_o(f_in),
        .in_data_i(face_q < p), .out_valid_o(f_valid), .out_ready_i(pop && k_plane),
        .out_data_o(far)
    );

    // ---- the hit at hand; of a far plane first what its key of its own has more ----
    localparam HB = TAG + 1 + DW + MW + 2*WD + W + 1 + WD;
    wire             k_in, k_valid, ready;
    wire [TAG-1:0]   k_tag;
    wire [DW-1:0]    k_det;
    wire [MW-1:0]    k_num;
    wire [2*WD-1:0]  k_a;
    wire [W:0]       k_room;
    wire [WD-1:0]    k_size;
    reg              again_q;                    // it is a far plane's own turn
    rt_fifo #(.WIDTH(HB), .DEPTH(HOLD)) u_hits (
        .clk(clk), .rst(rst), .in_valid_i(in_valid_i), .in_ready_o(k_in),
        .in_data_i({in_tag_i, in_plane_i, in_det_i, in_num_i, in_a_i, in_room_i, in_size_i}),
        .out_valid_o(k_valid), .out_ready_i(pop),
        .out_data_o({k_tag, k_plane, k_det, k_num, k_a, k_room, k_size})
    );
    wire             k_far  = k_plane && far;
    wire             begins = k_valid && (!k_plane || f_valid);
    wire             take   = begins && ready;
    assign pop      = take && (!k_far || again_q);
    assign divide_o = pop;
    always @(posedge clk) begin
        if (take) again_q <= k_far && !again_q;
        if (rst) again_q <= 1'b0;
    end

    // ---- quotients ----
    wire             q_valid, q_rank, q_far;
    wire [TAG-1:0]   q_tag;
    wire [BW:0]      q_key;
    rt_divide #(.AW(LW), .BW(BW), .DW(LW), .TAG(TAG+2)) u_divide (
        .clk(clk), .rst(rst), .in_valid_i(begins), .in_ready_o(ready),
        .in_tag_i({k_tag, k_far && !again_q, k_far}),
        .in_a_i(!k_far ? {{(LW-MW){1'b0}}, k_num}
                : again_q ? {{(LW-W-1){1'b0}}, k_room} : {{(LW-DW){1'b0}}, k_det}),
        .in_b_i(k_far && !again_q ? {{(BW-W-1){1'b0}}, k_room} : k_a),
        .in_d_i(!k_far ? {{(LW-DW){1'b0}}, k_det}
                : again_q ? {{(LW-WD){1'b0}}, k_size} : {{(LW-MW){1'b0}}, k_num}),
        .out_valid_o(q_valid), .out_tag_o({q_tag, q_rank, q_far}), .out_key_o(q_key)
    );

    // ---- keys; sizes of far planes wait for their ranks ----
    wire             s_in, s_valid, o_in;
    wire [WD-1:0]    s_size;
    reg  [WD-1:0]    add_q;                      // size - ceil(det'*room / num')
    wire [WD:0]      add = {1'b0, s_size} - q_key[WD:0];
    rt_fifo #(.WIDTH(WD), .DEPTH(HOLD)) u_sizes (
        .clk(clk), .rst(rst), .in_valid_i(take && k_far && !again_q), .in_ready_o(s_in),
        .in_data_i(k_size), .out_valid_o(s_valid), .out_ready_i(q_valid && q_rank),
        .out_data_o(s_size)
    );
    always @(posedge clk) if (q_valid && q_rank) add_q <= add[WD-1:0];
    rt_fifo #(.WIDTH(TAG+KW), .DEPTH(HOLD)) u_keys (
        .clk(clk), .rst(rst), .in_valid_i(q_valid && !q_rank), .in_ready_o(o_in),
        .in_data_i({q_tag, q_key[KW-1:0] + (q_far ? {{(KW-WD){1'b0}}, add_q} : {KW{1'b0}})}),
        .out_valid_o(out_valid_o), .out_ready_i(out_ready_i), .out_data_o({out_tag_o, out_key_o})
    );
    // for benches: {turned away, taken, clocks of work}
    localparam [31:0] CLOCKS = (BW + 16) / 17;
    wire [7:0] work_keys_of_facets /* verilator public_flat_rd */ =
        {begins && !ready, pop, take ? CLOCKS[5:0] : 6'd0};
    wire unused = &{1'b0, f_in, k_in, s_in, s_valid, o_in, add[WD], q_key};
endmodule
`default_nettype wire
