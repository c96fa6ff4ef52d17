// f_slots.v - proof of rt_slots: every slot's token is in one place, and comes back once
// SPDX-License-Identifier: Apache-2.0
//   free --> primary ray --> [rest: traced, shaded] --> done --> hit, miss, shadow --> rest
//    '-- delivered <-- [blended, skies] <-- end, sky ----'  '--> [again] --> primary ray
// SLOTS tokens, queues of as many words. What a queue gives it was given (f_fifo.v). The rest
// stands for rt_setup, rt_trace and rt_shade: it keeps a token as long as it likes, and gives it
// back as a ray that is done or a pixel that is complete. What a ray found is anything.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
`include "rt_bundles.vh"
module f_slots #(
    parameter AB    = 3,         // of a slot's number
    parameter W     = 4,
    parameter WD    = 5,
    parameter SLOTS = 1 << AB,
    parameter SLOTW = AB
) (
    input wire                       clk,
    input wire                       rst,
    input wire [`RT_REGS_BITS-1:0]   regs,
    input wire                       in_valid, primary_ready, pix_ready,
    input wire [`RT_START_BITS-1:0]  start,
    input wire [SLOTW-1:0]           ray_slot, done_slot, end_slot,
    input wire                       done_valid, end_valid,
    input wire [`RT_DONE_BITS-1:0]   done,
    input wire [`RT_BLEND_BITS-1:0]  blend,
    input wire [`RT_VISITS_BITS-1:0] visits,
    input wire [71:0]                colour,
    input wire [31:0]                texture
);
    (* anyconst *) wire [SLOTW-1:0] slot;                // any one
    wire busy, in_ready, ray_again, read, pix_valid;
    wire [`RT_VECTOR_BITS-1:0] primary;
    wire [`RT_HIT_BITS-1:0] hit;
    wire [SLOTW-1:0] read_slot;
    wire [`RT_PIXEL_BITS-1:0] pix;
    wire [3:0] fault;
    rt_slots #(.W(W), .WD(WD), .SLOTS(SLOTS)) u_dut (
        .clk(clk), .rst(rst), .busy_o(busy), .regs_i(regs), .in_valid_i(in_valid),
        .in_ready_o(in_ready), .start_i(start), .primary_o(primary),
        .primary_ready_i(primary_ready), .ray_slot_i(ray_slot), .ray_again_o(ray_again),
        .done_valid_i(done_valid), .done_slot_i(done_slot), .done_i(done), .hit_o(hit),
        .blend_i(blend), .end_valid_i(end_valid), .end_slot_i(end_slot), .read_o(read),
        .read_slot_o(read_slot), .visits_i(visits), .colour_i(colour), .texture_i(texture),
        .pix_valid_o(pix_valid), .pix_ready_i(pix_ready), .pix_o(pix), .fault_o(fault)
    );
    (* hierconn *) wire [SLOTW:0] \u_dut.fill_q , \u_dut.used_q ;
    (* hierconn *) wire [SLOTW:0] \u_dut.g_setup[0].u_free.wr_q , \u_dut.g_setup[0].u_free.rd_q ;
    (* hierconn *) wire [SLOTW:0] \u_dut.u_blended.wr_q , \u_dut.u_blended.rd_q ;
    (* hierconn *) wire [SLOTW:0] \u_dut.u_skies.wr_q , \u_dut.u_skies.rd_q ;
    (* hierconn *) wire [SLOTW:0] \u_dut.g_probe.u_probe.u_queue.wr_q ;
    (* hierconn *) wire [SLOTW:0] \u_dut.g_probe.u_probe.u_queue.rd_q ;
    (* hierconn *) wire \u_dut.free_valid , \u_dut.filling , \u_dut.again_valid ;
    (* hierconn *) wire \u_dut.o_blend , \u_dut.o_sky , \u_dut.o_load , \u_dut.o_blend_in ;
    (* hierconn *) wire \u_dut.g_setup[0].u_free.some_q , \u_dut.g_setup[0].u_free.room_q ;
    (* hierconn *) wire \u_dut.u_blended.some_q , \u_dut.u_blended.room_q ;
    (* hierconn *) wire \u_dut.u_skies.some_q , \u_dut.u_skies.room_q ;
    (* hierconn *) wire \u_dut.g_probe.u_probe.u_queue.some_q ;
    (* hierconn *) wire \u_dut.g_probe.u_probe.u_queue.room_q ;
    (* hierconn *) wire \u_dut.o_turn_blend , \u_dut.o_turn_sky ;
    (* hierconn *) wire [1:0] \u_dut.u_delivery.above_q ;
    (* hierconn *) wire \u_dut.o_sky_in , \u_dut.free_in , \u_dut.p_valid_q , \u_dut.sky_q ;
    (* hierconn *) wire \u_dut.r_valid_q ;
    (* hierconn *) wire [SLOTW-1:0] \u_dut.r_slot_q ;
    (* hierconn *) wire \u_dut.t_valid_q , \u_dut.d_valid_q , \u_dut.d_valid , \u_dut.d_void ;
    (* hierconn *) wire \u_dut.g_probe.u_probe.q_valid , \u_dut.g_probe.u_probe.q_in ;
    (* hierconn *) wire \u_dut.g_probe.u_probe.load ;
    (* hierconn *) wire [SLOTW-1:0] \u_dut.free_slot , \u_dut.t_slot_q , \u_dut.d_slot_q ;
    (* hierconn *) wire [SLOTW-1:0] \u_dut.slot_q , \u_dut.p_slot_q , \u_dut.o_blend_slot ;
    (* hierconn *) wire [SLOTW-1:0] \u_dut.o_sky_slot , \u_dut.again_slot ;
    (* hierconn *) wire [SLOTW-1:0] \u_dut.g_probe.u_probe.q_slot ;
    (* hierconn *) wire [SLOTW-1:0] \u_dut.u_pixel.mark , \u_dut.u_first.mark ;
    (* hierconn *) wire [SLOTW-1:0] \u_dut.g_probe.u_probe.u_surface.mark ;
    (* hierconn *) wire [SLOTW-1:0] \u_dut.g_probe.u_probe.u_first.mark ;
    (* hierconn *) wire [SLOTW-1:0] \u_dut.g_probe.u_probe.u_dir.mark ;
    (* hierconn *) wire \u_dut.seen_q ;

    // ---- model: where the token of the chosen slot is; how many are with the rest ----
    reg  old_q = 1'b0, rst_q, free_mine_q, rest_mine_q, again_mine_q, blended_mine_q, skies_mine_q;
    reg  blend_first_q, sky_first_q;                     // went while one of the others waited
    reg [SLOTW:0] rest_q;
    wire take      = in_valid && in_ready;
    wire repeats   = \u_dut.again_valid && primary_ready;
    wire token     = hit[`RT_HIT_HIT] || hit[`RT_HIT_MISS] || hit[`RT_HIT_SHADOW];
    wire out       = pix_valid && pix_ready;
    wire fill      = \u_dut.filling ;
    wire to_again  = \u_dut.d_valid && \u_dut.d_void ;
    wire pop_again = \u_dut.g_probe.u_probe.q_valid && \u_dut.g_probe.u_probe.load ;
    wire pop_blend = \u_dut.o_turn_blend && \u_dut.o_load ;
    wire pop_sky   = \u_dut.o_turn_sky && \u_dut.o_load ;
    wire new_mine   = fill && \u_dut.fill_q [SLOTW-1:0] == slot;
    wire take_mine  = take && \u_dut.free_slot == slot;
    wire token_mine = token && \u_dut.slot_q == slot;
    wire done_mine  = done_valid && done_slot == slot;
    wire end_mine   = end_valid && end_slot == slot;
    wire out_mine   = out && \u_dut.p_slot_q == slot;
    always @(posedge clk) begin
        old_q          <= 1'b1;
        rst_q          <= rst;
        blend_first_q  <= \u_dut.o_sky && !pop_sky && (blend_first_q || pop_blend);
        sky_first_q    <= \u_dut.o_blend && !pop_blend && (sky_first_q || pop_sky);
        rest_q         <= rest_q + take + repeats + token - done_valid - end_valid;
        free_mine_q    <= (free_mine_q && !take_mine) || new_mine || out_mine;
        rest_mine_q    <= (rest_mine_q && !done_mine && !end_mine) || take_mine || token_mine ||
                          (repeats && \u_dut.again_slot == slot);
        again_mine_q   <= (again_mine_q && !(pop_again && \u_dut.g_probe.u_probe.q_slot == slot)) ||
                          (to_again && \u_dut.d_slot_q == slot);
        blended_mine_q <= (blended_mine_q && !(pop_blend && \u_dut.o_blend_slot == slot)) ||
                          end_mine;
        skies_mine_q   <= (skies_mine_q && !(pop_sky && \u_dut.o_sky_slot == slot)) ||
                          (\u_dut.sky_q && \u_dut.slot_q == slot);
        if (rst) begin
            rest_q <= 0;
            {blend_first_q, sky_first_q} <= 2'd0;
            {free_mine_q, rest_mine_q, again_mine_q, blended_mine_q, skies_mine_q} <= 5'd0;
        end
    end
    always @* begin
        if (!old_q) assume (rst);
        // the rest gives what it has
        assume ({1'b0, rest_q} >= done_valid + end_valid);
        if (done_mine || end_mine) assume (rest_mine_q);
        assume (!(done_mine && end_mine));
        if (blend[`RT_BLEND_VALID] && blend[`RT_BLEND_SLOT] == slot) assume (rest_mine_q);
        assume (\u_dut.u_pixel.mark == slot && \u_dut.u_first.mark == slot);
        assume (\u_dut.g_probe.u_probe.u_surface.mark == slot);
        assume (\u_dut.g_probe.u_probe.u_first.mark == slot);
        assume (\u_dut.g_probe.u_probe.u_dir.mark == slot);
        // f_fifo.v: a queue gives what it holds
        if (\u_dut.free_valid && \u_dut.free_slot == slot)  assume (free_mine_q);
        if (\u_dut.o_blend && \u_dut.o_blend_slot == slot)  assume (blended_mine_q);
        if (\u_dut.o_sky && \u_dut.o_sky_slot == slot)      assume (skies_mine_q);
        if (\u_dut.g_probe.u_probe.q_valid && \u_dut.g_probe.u_probe.q_slot == slot)
            assume (again_mine_q);
    end

    wire [SLOTW:0] n_free  = \u_dut.g_setup[0].u_free.wr_q - \u_dut.g_setup[0].u_free.rd_q ;
    wire [SLOTW:0] n_blend = \u_dut.u_blended.wr_q - \u_dut.u_blended.rd_q ;
    wire [SLOTW:0] n_sky   = \u_dut.u_skies.wr_q - \u_dut.u_skies.rd_q ;
    wire [SLOTW:0] n_again = \u_dut.g_probe.u_probe.u_queue.wr_q -
                             \u_dut.g_probe.u_probe.u_queue.rd_q ;
    wire unborn     = fill && \u_dut.fill_q [SLOTW-1:0] <= slot;
    wire t_mine     = \u_dut.t_valid_q && \u_dut.t_slot_q == slot;
    wire d_mine     = \u_dut.d_valid_q && \u_dut.d_slot_q == slot;
    wire s_any      = token || \u_dut.sky_q ;
    wire s_mine     = s_any && \u_dut.slot_q == slot;
    wire r_mine     = \u_dut.r_valid_q && \u_dut.r_slot_q == slot;
    wire p_mine     = \u_dut.p_valid_q && \u_dut.p_slot_q == slot;
    wire again_mine = \u_dut.again_valid && \u_dut.again_slot == slot;
    wire [SLOTW+2:0] all = {2'd0, SLOTS[SLOTW:0] - \u_dut.fill_q } + {2'd0, n_free} +
                           {2'd0, n_blend} + {2'd0, n_sky} + {2'd0, n_again} + {2'd0, rest_q} +
                           \u_dut.t_valid_q + \u_dut.d_valid_q + s_any + \u_dut.r_valid_q +
                           \u_dut.p_valid_q + \u_dut.again_valid ;
    always @* if (old_q) begin
        // no push into a full queue
        if (fill || out)     assert (\u_dut.free_in );
        if (end_valid)       assert (\u_dut.o_blend_in );
        if (\u_dut.sky_q )   assert (\u_dut.o_sky_in );
        if (to_again)        assert (\u_dut.g_probe.u_probe.q_in );
        // f_fifo.v: flags of a queue
        assert (\u_dut.g_setup[0].u_free.some_q == (n_free != 0) &&
                \u_dut.g_setup[0].u_free.room_q == (n_free != SLOTS));
        assert (\u_dut.u_blended.some_q == (n_blend != 0) &&
                \u_dut.u_blended.room_q == (n_blend != SLOTS));
        assert (\u_dut.u_skies.some_q == (n_sky != 0) &&
                \u_dut.u_skies.room_q == (n_sky != SLOTS));
        assert (\u_dut.g_probe.u_probe.u_queue.some_q == (n_again != 0) &&
                \u_dut.g_probe.u_probe.u_queue.room_q == (n_again != SLOTS));
        // tokens: as many as slots, each slot's in one place; a ray is hit, miss, shadow or sky
        assert (all == SLOTS);
        assert (unborn + free_mine_q + rest_mine_q + again_mine_q + blended_mine_q + skies_mine_q +
                t_mine + d_mine + s_mine + r_mine + p_mine + again_mine == 5'd1);
        assert (hit[`RT_HIT_HIT] + hit[`RT_HIT_MISS] + hit[`RT_HIT_SHADOW] + \u_dut.sky_q <= 3'd1);
        assert (\u_dut.fill_q <= SLOTS && n_free <= SLOTS && n_blend <= SLOTS && n_sky <= SLOTS &&
                n_again <= SLOTS && rest_q <= SLOTS);
        if (\u_dut.seen_q ) assert (hit[`RT_HIT_HIT] || rst_q);
        if (rst_q) assert (n_blend == 0 && n_sky == 0);
        if (fill) assert (\u_dut.used_q == 0 && n_free == \u_dut.fill_q );
        // busy until all are free again
        assert (\u_dut.used_q == \u_dut.fill_q - n_free);
        assert (busy == (n_free != \u_dut.fill_q ));
        // a pixel that is offered and taken gets the slot that leaves the queue
        if (take) assert (primary[`RT_VECTOR_VALID]);
        if (take) assert (primary[`RT_VECTOR_SLOT] == \u_dut.free_slot );
        // something moves: a free slot takes a pixel, one that is complete is delivered
        if (!fill && n_free != 0 && primary_ready && in_valid) assert (take || repeats);
        if (n_blend != 0 || n_sky != 0) assert (!pix_ready || pop_blend || pop_sky);
        // of skies and blended pixels one of the others goes before at most
        assert (!(blend_first_q && pop_blend) && !(sky_first_q && pop_sky));
        if (blend_first_q) assert (\u_dut.u_delivery.above_q == 2'd2);
        if (sky_first_q)   assert (\u_dut.u_delivery.above_q == 2'd0);
    end
endmodule
`default_nettype wire
