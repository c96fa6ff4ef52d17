// f_frames.v - proof of rt_frames: nothing is drawn into the frame that is shown
// SPDX-License-Identifier: Apache-2.0
// rt_run begins a frame where there is room, ends it, or forgets all, which ends it too; the
// display takes at any time.
`timescale 1ns / 1ps
`default_nettype none
module f_frames #(
    parameter ADDR = 32
) (
    input wire        clk,
    input wire        rst,
    input wire [3*ADDR-1:0] bases,
    input wire        waits,
    input wire        clear,
    input wire        load,
    input wire        begins,
    input wire        ends,
    input wire        good,
    input wire        take
);
    wire room, show_valid, swap, again, lost;
    wire [ADDR-1:0] draw_base, show_base;
    wire [1:0]  drawn, newest, shown;
    rt_frames #(.ADDR(ADDR)) u_dut (
        .clk(clk), .rst(rst), .bases_i(bases), .wait_i(waits), .layer_i(32'd0), .mux_i(2'd0),
        .cfg_valid_i(1'b0), .cfg_addr_i(7'd0), .cfg_data_i(32'd0), .clear_i(clear), .load_i(load),
        .begin_i(begins),
        .end_i(ends), .good_i(good), .room_o(room), .draw_base_o(draw_base), .take_i(take),
        .show_valid_o(show_valid), .show_base_o(show_base), .swap_o(swap), .again_o(again),
        .lost_o(lost), .drawn_o(drawn), .newest_o(newest), .shown_o(shown)
    );
    (* hierconn *) wire \u_dut.fresh_q , \u_dut.gone_q ;
    (* hierconn *) wire [ADDR-1:0] \u_dut.newest_base_q ;
    reg        old_q = 1'b0, drawing_q, fresh_q, gone_q, calm_q, valid_q;
    reg [ADDR-1:0] base_q, complete_q, wanted_q;  // complete_q: where the newest frame was drawn
    always @(posedge clk) begin
        old_q <= 1'b1;
        if (take) {fresh_q, gone_q} <= 2'd0;
        if (begins) drawing_q <= 1'b1;
        if (ends) drawing_q <= 1'b0;
        if (ends && good) {fresh_q, complete_q} <= {1'b1, draw_base};
        if (take && fresh_q) wanted_q <= complete_q;
        if (rst || clear) begin drawing_q <= 1'b0; fresh_q <= 1'b0; gone_q <= !rst; end
        calm_q  <= !take && !rst;
        base_q  <= show_base;
        valid_q <= show_valid;
    end
    always @* begin
        if (!old_q) assume (rst);
        if (begins) assume (room && !drawing_q && !ends && !clear);
        if (ends) assume (drawing_q && !clear);
    end
    always @* if (old_q) begin
        if (drawing_q && show_valid) assert (drawn != shown);
        if (calm_q) assert (show_valid == valid_q && (!show_valid || show_base == base_q));
        assert (swap == (take && fresh_q));
        assert (again == (take && !fresh_q && show_valid && !gone_q));
        assert (lost == (ends && good && fresh_q && !take));
        assert (room == !(waits && fresh_q));
        if (show_valid) assert (show_base == wanted_q);
        // invariant
        if (fresh_q) assert (\u_dut.newest_base_q == complete_q);
        assert (\u_dut.fresh_q == fresh_q && \u_dut.gone_q == gone_q);
        assert (drawn < 3 && newest < 3 && shown < 3);
        if (drawing_q && fresh_q) assert (drawn != newest);
        if (fresh_q && show_valid) assert (newest != shown);
    end
endmodule
`default_nettype wire
