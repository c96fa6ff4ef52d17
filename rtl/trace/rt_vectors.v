// rt_vectors.v - chooses the vector that rt_setup takes next
// SPDX-License-Identifier: Apache-2.0
// Surface normals go first, then lights, then mirrored directions, and new primary rays last: what
// is nearest to its end goes first; with PHASES a light waits for the clock in which its unit
// takes. The first three always find room (token rule): queues hold their slots, block RAM the
// vectors. For a source that is not built there is neither. A primary ray that is not taken at once
// waits in a register, and the ready of its source looks at nothing else.
// There is no model of it: the order of vectors changes no result.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_bundles.vh"
module rt_vectors #(
    parameter WD      = 17,  // direction component, bits
    parameter NORMALS = 1,   // 1: surface normals come
    parameter LIGHTS  = 1,   // 1: vectors to lights come
    parameter BOUNCES = 1,   // 1: mirrored directions come
    parameter SHADES  = 1,   // shading units, power of two
    parameter PHASES  = 0,   // 1: of two units for unit vectors each takes every second clock
    parameter SLOTS   = 32   // power of two
) (
    input  wire                       clk,
    input  wire                       rst,
    // sources of vectors, the first three of each shading unit
    input  wire [SHADES*(`RT_VECTOR_BITS-$clog2(SHADES))-1:0] normal_i,
    input  wire [SHADES*(`RT_VECTOR_BITS-$clog2(SHADES))-1:0] light_i,
    input  wire [SHADES*(`RT_VECTOR_BITS-$clog2(SHADES))-1:0] bounce_i,
    input  wire [`RT_VECTOR_BITS-1:0] primary_i,
    //: {SLOT[SLOTW], VEC[3*WD], VALID}
    output wire                       primary_ready_o,
    input  wire                       first_i,       // with PHASES: the first unit may take
    // the vector chosen
    output reg                        out_valid_o,
    input  wire                       out_ready_i,
    output wire                       out_normal_o,  // its kind; none of the three: primary
    output wire                       out_light_o,
    output wire                       out_bounce_o,
    output reg [$clog2(SLOTS)-1:0]    out_slot_o,
    output wire [3*WD-1:0]            out_vec_o
);
    localparam SLOTW = $clog2(SLOTS);
    localparam SB = $clog2(SHADES);
    localparam OWNW = SLOTW - SB;           // slot of a shading unit
    localparam VB = `RT_VECTOR_BITS - SB;   // a vector of such
    localparam N  = 3*SHADES;               // sources: SHADES of normals, of lights, of bounces
    localparam [2:0] BUILT = {BOUNCES != 0, LIGHTS != 0, NORMALS != 0};  // bit 0 goes first
    wire [N*VB-1:0]    in = {bounce_i, light_i, normal_i};

    // ---- choose ----
    wire               load = !out_valid_o || out_ready_i;
    wire [N-1:0]       valid, room;
    wire [N-1:0]       may;                 // in the next clock it would be taken
    wire [N-1:0]       now = valid & may;
    wire [N-1:0]       take = now & (~now + 1'b1) & {N{load}};
    wire [N*SLOTW-1:0] slot;
    wire [3*N*WD-1:0]  vec;
    reg                p_valid_q;           // a primary ray waits
    reg [SLOTW-1:0]    p_slot_q;
    reg [3*WD-1:0]     p_vec_q;
    wire               primary = p_valid_q || primary_i[`RT_VECTOR_VALID];
    assign primary_ready_o = !p_valid_q;
    always @(posedge clk) begin
        p_valid_q <= primary && !(load && now == {N{1'b0}});
        if (!p_valid_q) begin
            p_slot_q <= primary_i[`RT_VECTOR_SLOT];
            p_vec_q  <= primary_i[`RT_VECTOR_VEC];
        end
        if (rst) p_valid_q <= 1'b0;
    end
    genvar s;
    generate
        for (s = 0; s < N; s = s + 1) begin : g_source
            wire [VB-1:0] in_s = in[VB*s +: VB];
            if (PHASES != 0 && s/SHADES == 1) begin : g_phase
                assign may[s] = first_i == (s % 2 != 0);  // an odd one's goes to the second
            end else begin : g_any
                assign may[s] = 1'b1;
            end
            if (BUILT[s/SHADES]) begin : g_on
                localparam [31:0] SHADE = s % SHADES;
                wire [OWNW-1:0]   own;
                wire [OWNW+31:0]  whole = {SHADE, own};
                rt_fifo #(.WIDTH(OWNW), .DEPTH(SLOTS >> SB)) u_queue (
                    .clk(clk), .rst(rst), .in_valid_i(in_s[`RT_VECTOR_VALID]),
                    .in_ready_o(room[s]), .in_data_i(in_s[VB-1 -: OWNW]),
                    .out_valid_o(valid[s]), .out_ready_i(take[s]), .out_data_o(own)
                );
                rt_slot_ram #(.WIDTH(3*WD), .SLOTS(SLOTS >> SB), .OLD(0)) u_vec (
                    .clk(clk), .wr_en_i(in_s[`RT_VECTOR_VALID]),
                    .wr_addr_i(in_s[VB-1 -: OWNW]), .wr_data_i(in_s[`RT_VECTOR_VEC]),
                    .rd_en_i(take[s]), .rd_addr_i(own), .rd_data_o(vec[3*WD*s +: 3*WD])
                );
                assign slot[SLOTW*s +: SLOTW] = whole[SLOTW-1:0];
                wire unused = &{1'b0, whole};
            end else begin : g_off
                wire unused = &{1'b0, in_s};
                assign {valid[s], room[s]} = 2'b00;
                assign slot[SLOTW*s +: SLOTW] = {SLOTW{1'b0}};
                assign vec[3*WD*s +: 3*WD]    = {3*WD{1'b0}};
            end
        end
    endgenerate

    // ---- the vector, from where it was read ----
    reg [N-1:0]        from_q;              // one-hot; none: primary
    reg [3*WD-1:0]     primary_q;
    reg [SLOTW-1:0]    slot_next;
    reg [3*WD-1:0]     vec_next;
    integer            i;
    always @* begin
        slot_next = p_valid_q ? p_slot_q : primary_i[`RT_VECTOR_SLOT];
        vec_next  = primary_q;
        for (i = N - 1; i >= 0; i = i - 1) begin
            if (take[i])   slot_next = slot[SLOTW*i +: SLOTW];
            if (from_q[i]) vec_next  = vec[3*WD*i +: 3*WD];
        end
    end
    always @(posedge clk) begin
        if (load) begin
            out_valid_o <= now != {N{1'b0}} || primary;
            from_q      <= take;
            out_slot_o  <= slot_next;
            primary_q   <= p_valid_q ? p_vec_q : primary_i[`RT_VECTOR_VEC];
        end
        if (rst) out_valid_o <= 1'b0;
    end
    assign out_normal_o = |from_q[0 +: SHADES];
    assign out_light_o  = |from_q[SHADES +: SHADES];
    assign out_bounce_o = |from_q[2*SHADES +: SHADES];
    assign out_vec_o    = vec_next;
    wire unused = &{1'b0, room, in, first_i};
endmodule
`default_nettype wire
