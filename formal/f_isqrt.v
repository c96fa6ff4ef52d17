// f_isqrt.v - proof of rt_isqrt: root^2 <= x < (root+1)^2, inexact, latency, interval, order
// SPDX-License-Identifier: Apache-2.0
// With BITS: s = shift and root^2 <= x / 4^s < (root+1)^2; s is 0, or root has all BITS bits;
// inexact = ((root 2^s)^2 != x). The square of the digits so far is kept beside the root of each
// stage: with root' = 2 root + d, root'^2 is 4 root^2 + d (4 root + 1). So no multiplication is
// needed, and full widths can be proved. With MULTIPLY the square is that of a multiplier: small
// widths.
`timescale 1ns / 1ps
`default_nettype none
module f_isqrt #(
    parameter XW       = 66,
    parameter STEP     = 2,
    parameter BITS     = 0,
    parameter STAGES   = 3,               // 1 to 4 stages come of it
    parameter MULTIPLY = 0
) (
    input wire          clk,
    input wire          rst,
    input wire          in_valid,
    input wire [XW-1:0] in_x,
    input wire [1:0]    in_tag
);
    localparam ROUNDS   = (XW/2 + STEP - 1) / STEP;
    localparam RW       = ROUNDS*STEP;
    localparam BW       = BITS != 0 ? BITS : RW;
    localparam INTERVAL = ROUNDS / STAGES + 1;
    localparam LAST     = ROUNDS / INTERVAL;
    localparam SW       = 2*RW + 2;       // of x and squares
    wire in_ready, out_valid, out_inexact;
    wire [(BITS != 0 ? BITS : XW/2)-1:0] out_root;
    wire [5:0] out_shift;
    wire [1:0] out_tag;
    rt_isqrt #(.XW(XW), .STEP(STEP), .BITS(BITS), .STAGES(STAGES), .TAG(2)) u_dut (
        .clk(clk), .rst(rst), .in_valid_i(in_valid), .in_ready_o(in_ready), .in_x_i(in_x),
        .in_tag_i(in_tag), .out_valid_o(out_valid), .out_root_o(out_root),
        .out_shift_o(out_shift), .out_inexact_o(out_inexact), .out_tag_o(out_tag)
    );

    // ---- registers of the stages, those of stage s in field s ----
    function integer root_bits(input integer s);   // of its root
        integer digits;
        begin
            digits = (s == LAST ? ROUNDS : (s + 1)*INTERVAL)*STEP;
            root_bits = digits < 2 ? 2 : digits < BW ? digits : BW;
        end
    endfunction
    (* hierconn *) wire [ROUNDS+1:1] \u_dut.age_q ;
    (* hierconn *) wire [2*RW-1:0] \u_dut.g_stage[0].x_q , \u_dut.g_stage[1].x_q ;
    (* hierconn *) wire [2*RW-1:0] \u_dut.g_stage[2].x_q , \u_dut.g_stage[3].x_q ;
    (* hierconn *) wire [root_bits(0)-1:0] \u_dut.g_stage[0].root_q , \u_dut.g_stage[0].root_d ;
    (* hierconn *) wire [root_bits(1)-1:0] \u_dut.g_stage[1].root_q , \u_dut.g_stage[1].root_d ;
    (* hierconn *) wire [root_bits(2)-1:0] \u_dut.g_stage[2].root_q , \u_dut.g_stage[2].root_d ;
    (* hierconn *) wire [root_bits(3)-1:0] \u_dut.g_stage[3].root_q , \u_dut.g_stage[3].root_d ;
    (* hierconn *) wire [root_bits(0):0] \u_dut.g_stage[0].rem_q ;
    (* hierconn *) wire [root_bits(1):0] \u_dut.g_stage[1].rem_q ;
    (* hierconn *) wire [root_bits(2):0] \u_dut.g_stage[2].rem_q ;
    (* hierconn *) wire [root_bits(3):0] \u_dut.g_stage[3].rem_q ;
    (* hierconn *) wire [5:0] \u_dut.g_stage[0].shift_q , \u_dut.g_stage[0].shift_d ;
    (* hierconn *) wire [5:0] \u_dut.g_stage[1].shift_q , \u_dut.g_stage[1].shift_d ;
    (* hierconn *) wire [5:0] \u_dut.g_stage[2].shift_q , \u_dut.g_stage[2].shift_d ;
    (* hierconn *) wire [5:0] \u_dut.g_stage[3].shift_q , \u_dut.g_stage[3].shift_d ;
    (* hierconn *) wire \u_dut.g_stage[0].lost_q , \u_dut.g_stage[1].lost_q ;
    (* hierconn *) wire \u_dut.g_stage[2].lost_q , \u_dut.g_stage[3].lost_q ;
    (* hierconn *) wire [1:0] \u_dut.g_stage[0].tag_q , \u_dut.g_stage[1].tag_q ;
    (* hierconn *) wire [1:0] \u_dut.g_stage[2].tag_q , \u_dut.g_stage[3].tag_q ;
    localparam FW = 2*RW + 3*SW + 15;     // {tag, lost, shift', shift, rem, root', root, x}
    wire [SW-1:0] root_0 = \u_dut.g_stage[0].root_q , more_0 = \u_dut.g_stage[0].root_d ;
    wire [SW-1:0] root_1 = \u_dut.g_stage[1].root_q , more_1 = \u_dut.g_stage[1].root_d ;
    wire [SW-1:0] root_2 = \u_dut.g_stage[2].root_q , more_2 = \u_dut.g_stage[2].root_d ;
    wire [SW-1:0] root_3 = \u_dut.g_stage[3].root_q , more_3 = \u_dut.g_stage[3].root_d ;
    wire [SW-1:0] rem_0 = \u_dut.g_stage[0].rem_q , rem_1 = \u_dut.g_stage[1].rem_q ;
    wire [SW-1:0] rem_2 = \u_dut.g_stage[2].rem_q , rem_3 = \u_dut.g_stage[3].rem_q ;
    wire [4*FW-1:0] fields = {
        \u_dut.g_stage[3].tag_q , \u_dut.g_stage[3].lost_q , \u_dut.g_stage[3].shift_d ,
        \u_dut.g_stage[3].shift_q , rem_3, more_3, root_3, \u_dut.g_stage[3].x_q ,
        \u_dut.g_stage[2].tag_q , \u_dut.g_stage[2].lost_q , \u_dut.g_stage[2].shift_d ,
        \u_dut.g_stage[2].shift_q , rem_2, more_2, root_2, \u_dut.g_stage[2].x_q ,
        \u_dut.g_stage[1].tag_q , \u_dut.g_stage[1].lost_q , \u_dut.g_stage[1].shift_d ,
        \u_dut.g_stage[1].shift_q , rem_1, more_1, root_1, \u_dut.g_stage[1].x_q ,
        \u_dut.g_stage[0].tag_q , \u_dut.g_stage[0].lost_q , \u_dut.g_stage[0].shift_d ,
        \u_dut.g_stage[0].shift_q , rem_0, more_0, root_0, \u_dut.g_stage[0].x_q };

    // ---- radicands under way: bit k in the k-th clock after theirs ----
    reg old_q = 1'b0;
    reg  [ROUNDS+1:1] age_q;
    wire [ROUNDS+1:0] age = {age_q, in_valid && in_ready};
    always @(posedge clk) begin
        old_q <= 1'b1;
        age_q <= rst ? {(ROUNDS+1){1'b0}} : age[ROUNDS:0];
    end
    always @* if (!old_q) assume (rst);
    integer k, near;
    always @* if (old_q) begin
        assert (age_q == \u_dut.age_q );
        assert (out_valid == age_q[ROUNDS+1]);                      // ROUNDS + 1 clocks later
        for (k = 1; k <= ROUNDS + 1; k = k + 1)                     // INTERVAL clocks apart
            for (near = k + 1; near < k + INTERVAL && near <= ROUNDS + 1; near = near + 1)
                assert (!age_q[k] || !age_q[near]);
        assert (in_ready == !(|(age_q & ((1 << (INTERVAL-1)) - 1))));
    end

    // ---- each stage: its radicand, the bits of it that are used, their root's square ----
    localparam GW = 2 + 2*RW + 2*SW;      // {tag, radicand, used, square}
    wire [GW*(LAST+2)-1:0] kept;          // what stage s is loaded with is in field s
    wire [GW*(LAST+1)-1:0] now;           // what it has
    wire [2*RW-1:0] in_wide = in_x;
    assign kept[GW-1:0] = {in_tag, in_wide, {(2*SW){1'b0}}};
    genvar s, n;
    generate
        for (s = 0; s <= LAST; s = s + 1) begin : g_stage
            localparam BEFORE = s*INTERVAL;
            localparam KEPT   = s == LAST ? ROUNDS - BEFORE : INTERVAL - 1;  // its own rounds
            localparam XU     = 2*STEP*(s == LAST ? KEPT : INTERVAL);
            wire [2*RW-1:0] x;
            wire [SW-1:0]   root, root_d, rem;
            wire [5:0]      shift, shift_d;
            wire            lost;
            wire [1:0]      tag;
            assign {tag, lost, shift_d, shift, rem, root_d, root, x} = fields[FW*s +: FW];
            reg [1:0]      tag_q;
            reg [2*RW-1:0] wide_q;
            reg [SW-1:0]   used_q, used_d, square_q, square_d;
            reg [2*RW-1:0] next;                 // bits of x
            reg [SW-1:0]   part;                 // of the root
            reg            digit;
            integer i;
            always @* begin
                used_d   = used_q;
                square_d = square_q;
                next     = x;
                part     = root;
                digit    = 1'b0;
                for (i = STEP - 1; i >= 0; i = i - 1)
                    if (i >= shift_d - shift) begin
                        digit    = root_d[i - (shift_d - shift)];
                        used_d   = {used_d[SW-3:0], next[2*RW-1 -: 2]};
                        square_d = {square_d[SW-3:0], 2'd0} + (digit ? {part, 2'b01} : 0);
                        next     = next << 2;
                        part     = {part[SW-2:0], digit};
                    end
            end
            wire load = age[BEFORE];
            wire [INTERVAL:0] rounds = age[BEFORE +: KEPT+1] >> 1;
            always @(posedge clk)
                if (load) {tag_q, wide_q, used_q, square_q} <= kept[GW*s +: GW];
                else if (rounds != 0) {used_q, square_q} <= {used_d, square_d};
            assign kept[GW*(s+1) +: GW] = {tag_q, wide_q, used_d, square_d};
            wire [SW-1:0] square = MULTIPLY ? root*root : square_q;
            wire [SW-1:0] wide   = wide_q;
            assign now[GW*s +: GW] = {tag_q, wide_q, used_q, square};
            for (n = 0; n <= KEPT; n = n + 1) begin : g_round   // after n rounds of its own
                localparam DONE = (BEFORE + n)*STEP;           // digits in all
                localparam REST = 2*RW - XU + 2*STEP*n;        // bits of x that wait for others
                wire [2*RW-1:0] ahead  = wide_q << 2*DONE;
                wire [2*RW-1:0] behind = wide_q << 2*STEP*BEFORE;
                always @* if (old_q && age_q[BEFORE+1+n]) begin
                    assert (tag == tag_q && wide >> XW == 0);
                    // rem = used bits of x - root^2 <= 2 root
                    assert ({1'b0, square} + rem == {1'b0, used_q} && rem <= 2*root);
                    assert (used_q == wide >> 2*(RW - DONE + shift));
                    // of x what is not used: first what this stage uses, then the others
                    assert (((x ^ ahead) >> REST) == 0);
                    assert (((x ^ behind) & ({(2*RW){1'b1}} >> XU)) == 0);
                    // digits so far; the first ones, of whole rounds, are 0
                    assert (root >> (DONE == 0 ? 0 : XW/2 - (RW - DONE)) == 0);
                    if (DONE <= BW) assert (shift == 0 && !lost);
                    if (BITS != 0) begin
                        assert (shift <= DONE);
                        if (shift != 0) assert (root[BW-1]);
                        assert (lost == |((wide >> 2*(RW - DONE)) & ~({SW{1'b1}} << 2*shift)));
                    end
                end
            end
        end
    endgenerate

    // ---- the result ----
    wire [1:0]      tag;
    wire [2*RW-1:0] last;
    wire [SW-1:0]   used, square;
    assign {tag, last, used, square} = now[GW*LAST +: GW];
    wire [SW-1:0]   root = out_root, wide = last;
    wire [SW-1:0]   whole = fields[FW*LAST + 2*RW +: SW];
    always @* if (old_q && out_valid) begin
        assert (out_tag == tag);
        assert (used == wide >> 2*out_shift);
        assert (square <= used && used < square + 2*root + 1);
        assert (out_inexact == (used != square || (wide & ~({SW{1'b1}} << 2*out_shift)) != 0));
        if (BITS == 0) assert (out_shift == 0);
        else if (out_shift != 0) assert (out_root >> BW - 1 == 1 && out_shift < XW/2);
        assert (root == whole);                                     // no digit is cut off
    end
endmodule
`default_nettype wire
