// f_layers.v - proof of rt_frames with layers: MUX chooses what is shown when a frame is taken
// SPDX-License-Identifier: Apache-2.0
// As f_frames. Registers go to the core between two frames; MUX and LAYER_BYTES are written at any
// time.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module f_layers #(
    parameter ADDR = 32
) (
    input wire        clk,
    input wire        rst,
    input wire [3*ADDR-1:0] bases,
    input wire        waits,
    input wire [31:0] layer_bytes,
    input wire [1:0]  mux,
    input wire        cfg_valid,
    input wire [6:0]  cfg_addr,
    input wire [31:0] cfg_data,
    input wire        clear,
    input wire        load,
    input wire        begins,
    input wire        ends,
    input wire        good,
    input wire        take
);
    wire room, show_valid, swap;
    wire [ADDR-1:0] draw_base, show_base;
    wire [1:0]  drawn, newest, shown;
    rt_frames #(.LAYERS(1), .ADDR(ADDR)) u_dut (
        .clk(clk), .rst(rst), .bases_i(bases), .wait_i(waits), .layer_i(layer_bytes),
        .mux_i(mux), .cfg_valid_i(cfg_valid), .cfg_addr_i(cfg_addr), .cfg_data_i(cfg_data),
        .clear_i(clear), .load_i(load), .begin_i(begins), .end_i(ends), .good_i(good),
        .room_o(room), .draw_base_o(draw_base), .take_i(take), .show_valid_o(show_valid),
        .show_base_o(show_base), .swap_o(swap), .again_o(), .lost_o(), .drawn_o(drawn),
        .newest_o(newest), .shown_o(shown)
    );
    (* hierconn *) wire        \u_dut.fresh_q ;
    (* hierconn *) wire [ADDR-1:0] \u_dut.newest_base_q ;
    (* hierconn *) wire [ADDR-1:0] \u_dut.shown_base_q ;
    (* hierconn *) wire [1:0]  \u_dut.g_layers.layer_q ;
    (* hierconn *) wire [1:0]  \u_dut.g_layers.newest_q ;
    (* hierconn *) wire [1:0]  \u_dut.g_layers.shown_q ;

    // ---- model: a frame has an address and a layer of its own, from its beginning on ----
    reg        old_q = 1'b0, drawing_q, fresh_q, calm_q, valid_q, known_q;
    reg [1:0]  frame_q, drawn_q, newest_q, shown_q;   // register FRAME, and of these frames
    reg [ADDR-1:0] newest_base_q, shown_base_q, place_q, base_q;
    wire [1:0]  frame = cfg_data[1:0] == 2'd3 ? 2'd2 : cfg_data[1:0];
    wire [ADDR-1:0] root  = fresh_q ? newest_base_q : shown_base_q;
    wire [1:0]  own   = fresh_q ? newest_q : shown_q;
    wire [1:0]  layer = mux == 2'd0 ? own : mux - 2'd1;
    always @(posedge clk) begin
        old_q <= 1'b1;
        if (cfg_valid && cfg_addr == `RT_REG_FRAME) {known_q, frame_q} <= {1'b1, frame};
        if (begins) {drawing_q, drawn_q} <= {1'b1, frame_q};
        if (ends) drawing_q <= 1'b0;
        if (take) begin
            place_q <= root + (layer == 0 ? 0 : layer == 1 ? layer_bytes : 2 * layer_bytes);
            fresh_q <= 1'b0;
            {shown_base_q, shown_q} <= {root, own};
        end
        if (ends && good) {fresh_q, newest_base_q, newest_q} <= {1'b1, draw_base, drawn_q};
        if (rst || clear) begin drawing_q <= 1'b0; fresh_q <= 1'b0; end
        if (rst) known_q <= 1'b0;
        calm_q  <= !take && !rst;
        base_q  <= show_base;
        valid_q <= show_valid;
    end
    always @* begin
        if (!old_q) assume (rst);
        if (begins) assume (room && !drawing_q && !ends && !clear && known_q);
        if (ends) assume (drawing_q && !clear);
        if (cfg_valid) assume (!drawing_q && !begins);
    end
    always @* if (old_q) begin
        if (show_valid) assert (show_base == place_q);
        if (calm_q) assert (show_valid == valid_q && (!show_valid || show_base == base_q));
        if (drawing_q && show_valid) assert (drawn != shown);
        // invariant
        assert (\u_dut.fresh_q == fresh_q);
        if (known_q) assert (\u_dut.g_layers.layer_q == frame_q);
        if (drawing_q) assert (known_q && drawn_q == frame_q);
        if (fresh_q) assert (\u_dut.newest_base_q == newest_base_q);
        if (fresh_q) assert (\u_dut.g_layers.newest_q == newest_q);
        if (show_valid) assert (\u_dut.shown_base_q == shown_base_q);
        if (show_valid) assert (\u_dut.g_layers.shown_q == shown_q);
        assert (drawn < 3 && newest < 3 && shown < 3);
        if (drawing_q && fresh_q) assert (drawn != newest);
        if (fresh_q && show_valid) assert (newest != shown);
    end
endmodule
`default_nettype wire
