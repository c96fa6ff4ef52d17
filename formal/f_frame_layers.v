// f_frame_layers.v - proof of rt_frame_write with layers: a group is written three times, in turn
// SPDX-License-Identifier: Apache-2.0
// As f_frame_write: groups come from f_any_groups, bursts go to f_any_write. Followed is one pixel
// of any group, its Rendering, L1 and L2, each through address and format to its own layer.
`timescale 1ns / 1ps
`default_nettype none
module f_frame_layers #(
    parameter ADDR = 32
) (
    input wire         clk,
    input wire         rst,
    input wire [ADDR-1:0] base,
    input wire [1:0]   mux,
    input wire         begins,
    input wire [15:0]  stride,
    input wire         rgb565,
    input wire [31:0]  layer,
    input wire         cut,
    input wire         dead,
    input wire         flush,
    input wire         pix_valid,
    input wire [13:0]  pix_x,
    input wire [13:0]  pix_y,
    input wire [71:0]  colours,
    input wire [23:0]  frame
);
    wire empty, idle, pix_ready;
    wire [3:0] pixels;
    rt_frame_write #(.DATA(64), .BUFFERS(4), .LAYERS(1), .ADDR(ADDR)) u_dut (
        .clk(clk), .rst(rst), .base_i(base), .begin_i(begins), .mux_i(mux), .stride_i(stride),
        .rgb565_i(rgb565), .layer_i(layer), .cut_i(cut), .dead_i(dead), .forget_i(1'b0),
        .flush_i(flush), .empty_o(empty), .idle_o(idle), .stall_o(), .slverr_o(), .decerr_o(),
        .burst_o(), .beat_o(), .pixels_o(pixels), .pix_valid_i(pix_valid),
        .pix_ready_o(pix_ready), .pix_x_i(pix_x), .pix_y_i(pix_y), .pix_colour_i(colours),
        .pix_frame_i(frame), .m_awvalid(), .m_awready(1'b0), .m_awaddr(), .m_awlen(),
        .m_wvalid(), .m_wready(1'b0), .m_wdata(), .m_wstrb(), .m_wlast(), .m_bvalid(1'b0),
        .m_bready(), .m_bresp(2'b00)
    );
    // what goes into groups, and comes out of them
    (* hierconn *) wire [71:0]  \u_dut.u_groups.pix_rgb_i ;
    (* hierconn *) wire         \u_dut.u_groups.group_valid_o ;
    (* hierconn *) wire         \u_dut.u_groups.group_ready_i ;
    (* hierconn *) wire [10:0]  \u_dut.u_groups.group_column_o ;
    (* hierconn *) wire [13:0]  \u_dut.u_groups.group_y_o ;
    (* hierconn *) wire [7:0]   \u_dut.u_groups.group_mask_o ;
    (* hierconn *) wire [575:0] \u_dut.u_groups.group_rgb_o ;
    (* hierconn *) wire         \u_dut.u_groups.empty_o ;
    // what goes to the bus
    (* hierconn *) wire         \u_dut.u_write.group_valid_i ;
    (* hierconn *) wire         \u_dut.u_write.group_ready_o ;
    (* hierconn *) wire [ADDR-1:0] \u_dut.u_write.group_addr_i ;
    (* hierconn *) wire [31:0]  \u_dut.u_write.group_strobe_i ;
    (* hierconn *) wire [255:0] \u_dut.u_write.group_data_i ;
    // of the frame
    (* hierconn *) wire [15:0]  \u_dut.stride_q ;
    (* hierconn *) wire         \u_dut.row_valid_q ;
    (* hierconn *) wire [29:0]  \u_dut.row_q ;
    (* hierconn *) wire         \u_dut.rgb565_q ;
    (* hierconn *) wire [31:0]  \u_dut.g_layers.layer_bytes_q ;
    (* hierconn *) wire [ADDR-1:0] \u_dut.g_layers.base_q ;
    (* hierconn *) wire [1:0]   \u_dut.g_layers.layer_q ;

    // ---- model: the burst that is between, of the group that waits ----
    (* anyconst *) wire [2:0] p;          // the pixel of it that is followed
    reg         old_q = 1'b0, begun_q = 1'b0, there_q;
    wire drop = cut || dead;
    wire out  = \u_dut.u_write.group_valid_i && \u_dut.u_write.group_ready_o ;
    wire in   = \u_dut.row_valid_q && (!there_q || out);
    wire [71:0] all = \u_dut.u_groups.group_rgb_o [72*p +: 72];
    reg  [1:0]  turn_q;                   // the layer that is next of the group
    reg  [31:0] layer_q;
    reg  [ADDR-1:0] base_q, addr_q;
    // layers before it
    wire [ADDR-1:0] past = turn_q == 0 ? 0 : turn_q == 1 ? layer_q : 2 * layer_q;
    reg  [23:0] rgb_q;
    reg  [7:0]  mask_q;
    reg  [29:0] row_q;                    // product of these, of the clock before
    reg  [13:0] y_q;
    reg  [15:0] step_q;
    always @(posedge clk) begin
        old_q  <= 1'b1;
        base_q <= base;
        if (begins) {begun_q, layer_q} <= {1'b1, layer};
        {y_q, step_q} <= {\u_dut.u_groups.group_y_o , \u_dut.stride_q };
        row_q <= {16'd0, \u_dut.u_groups.group_y_o } * {14'd0, \u_dut.stride_q };
        if (out) there_q <= 1'b0;
        if (in) begin
            there_q <= 1'b1;
            turn_q  <= turn_q == 2'd2 ? 2'd0 : turn_q + 2'd1;
            addr_q  <= (turn_q == 2'd0 ? base : \u_dut.g_layers.base_q ) +
                       row_q +
                       (8 * \u_dut.u_groups.group_column_o << (\u_dut.rgb565_q ? 1 : 2));
            rgb_q   <= all >> 24 * turn_q;
            mask_q  <= \u_dut.u_groups.group_mask_o ;
        end
        if (rst || drop) {there_q, turn_q} <= 3'd0;
        if (rst) begun_q <= 1'b0;
    end
    wire [31:0] word = \u_dut.u_write.group_data_i [32*p +: 32];
    wire [15:0] half = \u_dut.u_write.group_data_i [16*p +: 16];
    always @* begin
        if (!old_q) assume (rst);
        if (begins) assume (!there_q && turn_q == 2'd0 && !\u_dut.u_groups.group_valid_o );
        if (!begun_q) assume (!\u_dut.u_groups.group_valid_o );
        if (turn_q != 2'd0) assume (base == base_q);   // of the frame that is drawn
    end

    always @* if (old_q) begin
        assert (\u_dut.u_groups.pix_rgb_i == colours);
        // it leaves with its third burst
        assert (\u_dut.u_groups.group_ready_i == (turn_q == 2'd2 && in));
        assert (\u_dut.u_write.group_valid_i == there_q);
        if (there_q) begin
            assert (\u_dut.u_write.group_addr_i == addr_q);
            if (\u_dut.rgb565_q ) begin
                assert (\u_dut.u_write.group_strobe_i [2*p +: 2] == {2{mask_q[p]}});
                if (mask_q[p]) assert (half == {rgb_q[7:3], rgb_q[15:10], rgb_q[23:19]});
            end else begin
                assert (\u_dut.u_write.group_strobe_i [4*p +: 4] == {4{mask_q[p]}});
                if (mask_q[p]) assert (word == {8'd0, rgb_q[7:0], rgb_q[15:8], rgb_q[23:16]});
            end
        end
        // invariant
        assert (\u_dut.g_layers.layer_q == turn_q && turn_q < 3);
        if (begun_q) assert (\u_dut.g_layers.layer_bytes_q == layer_q);
        if (turn_q != 2'd0) assert (begun_q && \u_dut.row_valid_q );
        if (turn_q != 2'd0) assert (\u_dut.g_layers.base_q == base_q + past);
        if (there_q) assert (begun_q);
        assert (\u_dut.row_q == row_q);
        if (\u_dut.row_valid_q )            // of the group that waits
            assert (\u_dut.u_groups.group_valid_o && y_q == \u_dut.u_groups.group_y_o &&
                    step_q == \u_dut.stride_q );
        assert (empty == (\u_dut.u_groups.empty_o && !there_q && idle));
    end
endmodule
`default_nettype wire
