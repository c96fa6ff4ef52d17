// rt_facet_key.v - keys of hits on facets
// SPDX-License-Identifier: Apache-2.0
//   key = ceil(a*num' / det'); a plane farther than the grid, num'*size > det'*room:
//   key = ceil(a*room / size) + size - ceil(det'*room / num')
// A hit makes its products here while the divider is at work for the one before it; another divider
// ranks planes beyond the grid. Keys leave in the order of the hits, from a register, so that who
// takes them does not make the divider wait. rt_facet has several of these.
// Model: end() and sph_facet_key() in cmodel/prim/facet.c
`timescale 1ns / 1ps
`default_nettype none
module rt_facet_key #(
    parameter W     = 16,                        // coordinate, bits
    parameter WD    = 17,                        // direction component, bits
    parameter TAG   = 30,                        // tag, bits
    parameter DW    = 50,                        // det', bits
    parameter MW    = 49,                        // num', bits
    parameter STEP  = 2,                         // bits of a key a clock
    parameter PLANES = 1                         // 1: planes too, 0: triangles alone
) (
    input  wire             clk,
    input  wire             rst,                 // synchronous, active high
    // from rt_facet: a hit
    input  wire             in_valid_i,
    output wire             in_ready_o,
    input  wire [TAG-1:0]   in_tag_i,
    input  wire             in_plane_i,
    input  wire [DW-1:0]    in_det_i,            // det', > 0
    input  wire [MW-1:0]    in_num_i,            // num', > 0
    input  wire [2*WD-1:0]  in_a_i,              // dir.dir
    input  wire [W:0]       in_room_i,           // to one unit beyond the grid, along the longest
    input  wire [WD-1:0]    in_size_i,           // axis of dir; |dir| along it
    // to rt_facet
    output reg              out_valid_o,
    input  wire             out_ready_i,
    output reg  [TAG-1:0]   out_tag_o,
    output reg  [W+WD+1:0]  out_key_o            // > 0
);
    localparam QW = W + WD + 1;                  // quotient
    localparam LW = DW > MW ? DW : MW;           // long factor
    localparam NW = W + 1 > WD ? W + 1 : WD;     // narrow one
    localparam FW = MW + WD < LW + NW ? MW + WD : LW + NW; // det'*room, if it counts: < num'*size
    localparam [2:0] IDLE = 3'd0, WAY = 3'd1, SCALE = 3'd2, WAIT = 3'd3, DIVIDE = 3'd4;
    localparam [1:0] FACE = 2'd0, NEXT = 2'd1, KEY = 2'd2, ROOM = 2'd3; // products, as they come
    localparam [1:0] OF_DET = 2'd0, OF_NUM = 2'd1, OF_KEY = 2'd2;

    // ---- the hit at hand ----
    reg  [2:0]       state_q;
    reg  [TAG-1:0]   tag_q;
    reg  [DW-1:0]    det_q;
    reg  [MW-1:0]    num_q;
    reg  [2*WD-1:0]  a_q;
    reg  [W:0]       room_q;
    reg  [WD-1:0]    size_q;
    wire             begins  = in_valid_i && in_ready_o;
    wire             plane   = PLANES != 0 && in_plane_i;
    assign in_ready_o = state_q == IDLE;
    always @(posedge clk) if (begins) begin
        tag_q  <= in_tag_i;
        det_q  <= in_det_i;
        num_q  <= in_num_i;
        a_q    <= in_a_i;
        room_q <= in_room_i;
        size_q <= in_size_i;
    end

    // ---- products: det'*room and num'*size of a plane, a*num', and a*room if need be ----
    reg  [1:0]       op_q;                       // factors that the product reads
    reg  [1:0]       came_q;                     // product that comes next
    reg              past_q, rank_q, again_q;    // beyond the grid; its order, a*room are under way
    reg  [LW+NW-1:0] face_q;                     // det'*room
    wire             p_ready, p_done, rank_ready, divider;
    wire [LW+2*WD-1:0] product;
    wire [LW+NW-1:0] narrow;
    wire             ways    = state_q == WAY && p_ready;
    wire             scales  = state_q == SCALE && p_ready;
    wire             rank_go = state_q == WAIT && past_q && !rank_q && rank_ready;
    wire             again   = state_q == WAIT && rank_q && !again_q && p_ready;
    wire             divides = state_q == DIVIDE;
    always @(posedge clk) begin
        if (begins) begin
            op_q    <= plane ? OF_DET : OF_KEY;
            state_q <= plane ? WAY : WAIT;
            came_q  <= plane ? FACE : KEY;
            past_q  <= 1'b0;
            rank_q  <= 1'b0;
            again_q <= 1'b0;
        end
        if (ways) begin
            op_q    <= OF_NUM;
            state_q <= SCALE;
        end
        if (scales) begin
            op_q    <= OF_KEY;
            state_q <= WAIT;
        end
        if (rank_go) rank_q <= 1'b1;
        if (again)   again_q <= 1'b1;
        if (p_done) begin
            came_q <= came_q + 2'd1;
            if (came_q == FACE) face_q <= narrow;
            if (came_q == NEXT) past_q <= PLANES != 0 && face_q < narrow;
            if (came_q == KEY ? !past_q : came_q == ROOM) state_q <= DIVIDE;
        end
        if (divides && divider) state_q <= IDLE;
        if (rst) state_q <= IDLE;
    end
    wire [1:0]    of = PLANES != 0 ? op_q : OF_KEY;
    wire [LW-1:0] long = of == OF_DET ? {{(LW-DW){1'b0}}, det_q}
                         : of == OF_KEY && past_q ? {{(LW-W-1){1'b0}}, room_q}
                         : {{(LW-MW){1'b0}}, num_q};
    wire [2*WD-1:0] short = of == OF_DET ? {{(2*WD-W-1){1'b0}}, room_q}
                            : of == OF_NUM ? {{WD{1'b0}}, size_q} : a_q;
    rt_long_product #(.AW(LW), .BW(2*WD), .BN(NW)) u_product (
        .clk(clk), .rst(rst), .start_i(begins || ways || scales || again), .ready_o(p_ready),
        .narrow_i(of != OF_KEY), .a_i(long), .b_i(short), .done_o(p_done), .p_o(product),
        .narrow_o(narrow)
    );

    // ---- key ----
    wire [LW+2*WD+DW+QW-1:0] wide = {{(DW+QW){1'b0}}, product};
    wire                k_valid, k_ready;        // a key is there; it is taken
    wire [QW:0]         key, k_key;              // k_key: with the order of planes
    reg                 k_past_q;
    reg  [TAG-1:0]      k_tag_q;
    rt_divide #(.DW(DW), .QW(QW), .STEP(STEP)) u_divide (
        .clk(clk), .rst(rst), .in_valid_i(divides), .in_ready_o(divider),
        .in_x_i(wide[DW+QW-1:0]), .in_d_i(past_q ? {{(DW-WD){1'b0}}, size_q} : det_q),
        .out_valid_o(k_valid), .out_ready_i(k_ready), .out_key_o(key)
    );
    always @(posedge clk) if (divides && divider) begin
        k_past_q <= past_q;
        k_tag_q  <= tag_q;
    end
    always @(posedge clk) begin
        if (k_ready) begin
            out_tag_o <= k_tag_q;
            out_key_o <= k_key;
        end
        out_valid_o <= k_ready || (out_valid_o && !out_ready_i);
        if (rst) out_valid_o <= 1'b0;
    end

    // ---- order of planes beyond the grid ----
    generate
        if (PLANES != 0) begin : g_rank
            wire             ranked;
            wire [WD:0]      rank;
            reg  [WD-1:0]    from_q, add_q;
            reg              ranked_q;           // add_q is what a key of its own has more
            wire [MW+WD-1:0] face = {{(MW+WD-FW){1'b0}}, face_q[FW-1:0]};
            wire [WD:0]      add = {1'b0, from_q} - rank;
            wire             ranks = k_ready && k_past_q;
            always @(posedge clk) begin
                if (rank_go) from_q <= size_q;
                add_q    <= add[WD-1:0];
                ranked_q <= ranked && !ranks;
                if (rst) ranked_q <= 1'b0;
            end
            rt_divide #(.DW(MW), .QW(WD), .STEP(1), .AT_ONCE(0)) u_rank (
                .clk(clk), .rst(rst), .in_valid_i(rank_go), .in_ready_o(rank_ready),
                .in_x_i(face), .in_d_i(num_q),
                .out_valid_o(ranked), .out_ready_i(ranks),
                .out_key_o(rank)
            );
            assign k_ready = k_valid && !out_valid_o && (!k_past_q || ranked_q);
            assign k_key   = key + (k_past_q ? {{(QW+1-WD){1'b0}}, add_q} : {(QW+1){1'b0}});
            wire unused = add[WD];
        end else begin : g_near
            assign rank_ready = 1'b0;
            assign k_ready    = k_valid && !out_valid_o;
            assign k_key      = key;
            wire unused = &{1'b0, k_past_q};
        end
    endgenerate
    wire unused = &{1'b0, face_q, narrow, wide, in_plane_i, in_room_i, in_size_i};
endmodule
`default_nettype wire
