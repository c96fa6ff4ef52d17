// f_frame_write.v - proof of rt_frame_write: a pixel is written once, to its own address, unchanged
// SPDX-License-Identifier: Apache-2.0
// Stands for its parts: groups come from f_any_groups, which gives any group in any clock, and
// bursts go to f_any_write, which takes them in any clock; f_frame_groups and f_axi_write prove
// those. Followed is one byte of any group, through mux, address and format.
`timescale 1ns / 1ps
`default_nettype none
module f_frame_write #(
    parameter ADDR = 32
) (
    input wire         clk,
    input wire         rst,
    input wire [ADDR-1:0] base,
    input wire [1:0]   mux,
    input wire         begins,
    input wire [15:0]  stride,
    input wire         rgb565,
    input wire         cut,
    input wire         dead,
    input wire         flush,
    input wire         pix_valid,
    input wire [13:0]  pix_x,
    input wire [13:0]  pix_y,
    input wire [71:0]  colours,
    input wire [23:0]  frame
);
    wire empty, idle, burst, pix_ready;
    wire [3:0] pixels;
    rt_frame_write #(.DATA(64), .BUFFERS(4), .ADDR(ADDR)) u_dut (
        .clk(clk), .rst(rst), .base_i(base), .mux_i(mux), .begin_i(begins), .stride_i(stride),
        .rgb565_i(rgb565), .layer_i(32'd0), .cut_i(cut), .dead_i(dead), .forget_i(1'b0),
        .flush_i(flush), .empty_o(empty), .idle_o(idle), .stall_o(), .slverr_o(), .decerr_o(),
        .burst_o(burst), .beat_o(), .pixels_o(pixels), .pix_valid_i(pix_valid),
        .pix_ready_o(pix_ready),
        .pix_x_i(pix_x), .pix_y_i(pix_y), .pix_colour_i(colours), .pix_frame_i(frame),
        .m_awvalid(), .m_awready(1'b0), .m_awaddr(), .m_awlen(), .m_wvalid(), .m_wready(1'b0),
        .m_wdata(), .m_wstrb(), .m_wlast(), .m_bvalid(1'b0), .m_bready(), .m_bresp(2'b00)
    );
    // what goes into groups, and comes out of them
    (* hierconn *) wire         \u_dut.u_groups.pix_valid_i ;
    (* hierconn *) wire [23:0]  \u_dut.u_groups.pix_rgb_i ;
    (* hierconn *) wire         \u_dut.u_groups.group_valid_o ;
    (* hierconn *) wire         \u_dut.u_groups.group_ready_i ;
    (* hierconn *) wire [10:0]  \u_dut.u_groups.group_column_o ;
    (* hierconn *) wire [13:0]  \u_dut.u_groups.group_y_o ;
    (* hierconn *) wire [7:0]   \u_dut.u_groups.group_mask_o ;
    (* hierconn *) wire [191:0] \u_dut.u_groups.group_rgb_o ;
    (* hierconn *) wire         \u_dut.u_groups.empty_o ;
    (* hierconn *) wire         \u_dut.u_groups.rst ;
    // what goes to the bus
    (* hierconn *) wire         \u_dut.u_write.group_valid_i ;
    (* hierconn *) wire         \u_dut.u_write.group_ready_o ;
    (* hierconn *) wire [ADDR-1:0] \u_dut.u_write.group_addr_i ;
    (* hierconn *) wire         \u_dut.u_write.group_half_i ;
    (* hierconn *) wire [31:0]  \u_dut.u_write.group_strobe_i ;
    (* hierconn *) wire [255:0] \u_dut.u_write.group_data_i ;

    // of the frame
    (* hierconn *) wire [1:0]   \u_dut.g_mux.mux_q ;
    (* hierconn *) wire [15:0]  \u_dut.stride_q ;
    (* hierconn *) wire         \u_dut.row_valid_q ;
    (* hierconn *) wire [29:0]  \u_dut.row_q ;
    (* hierconn *) wire         \u_dut.rgb565_q ;

    // ---- model: the group that is between, its format and its place ----
    (* anyconst *) wire [2:0] p;          // the pixel of it that is followed
    wire drop = cut || dead;
    wire in  = \u_dut.u_groups.group_valid_o && \u_dut.u_groups.group_ready_i ;
    wire out = \u_dut.u_write.group_valid_i && \u_dut.u_write.group_ready_o ;
    wire [23:0] rgb_in = \u_dut.u_groups.group_rgb_o [24*p +: 24];
    reg         old_q = 1'b0, begun_q = 1'b0, there_q, half_q;
    reg  [1:0]  mux_q;
    reg  [15:0] stride_q;
    reg  [ADDR-1:0] addr_q;
    reg  [23:0] rgb_q;
    reg  [7:0]  mask_q;
    reg  [29:0] row_q;                    // product of these, of the clock before
    reg  [13:0] y_q;
    reg  [15:0] step_q;
    always @(posedge clk) begin
        old_q <= 1'b1;
        if (begins) {begun_q, mux_q, half_q, stride_q} <= {1'b1, mux, rgb565, stride};
        {y_q, step_q} <= {\u_dut.u_groups.group_y_o , \u_dut.stride_q };
        row_q <= {16'd0, \u_dut.u_groups.group_y_o } * {14'd0, \u_dut.stride_q };
        if (out) there_q <= 1'b0;
        if (in) begin
            there_q <= 1'b1;
            addr_q  <= base + row_q +
                       (8 * \u_dut.u_groups.group_column_o << (half_q ? 1 : 2));
            rgb_q   <= rgb_in;
            mask_q  <= \u_dut.u_groups.group_mask_o ;
        end
        if (rst || drop) there_q <= 1'b0;
        if (rst) begun_q <= 1'b0;
    end
    wire [31:0] word = \u_dut.u_write.group_data_i [32*p +: 32];
    wire [15:0] half = \u_dut.u_write.group_data_i [16*p +: 16];
    integer i;
    always @* begin
        if (!old_q) assume (rst);
        if (begins) assume (!there_q && !\u_dut.u_groups.group_valid_o ); // no pixel
        if (!begun_q) assume (!\u_dut.u_groups.group_valid_o );
    end

    always @* if (old_q) begin
        // a pixel goes in with the colour that START chose, and waits unless all are thrown away
        assert (\u_dut.u_groups.rst == (rst || drop));
        assert (\u_dut.u_groups.pix_valid_i == pix_valid && (pix_ready || !drop));
        if (begun_q)
            assert (\u_dut.u_groups.pix_rgb_i == (mux_q == 0 ? frame : colours >>
                                                  (24 * (mux_q - 1)) & 24'hffffff));
        // a group comes out once, where it belongs, as it was
        assert (\u_dut.u_write.group_valid_i == there_q);
        if (in && !drop) assert (!there_q || out);
        if (there_q) begin
            assert (\u_dut.u_write.group_addr_i == addr_q);
            assert (\u_dut.u_write.group_half_i == half_q);
            if (half_q) begin
                assert (\u_dut.u_write.group_strobe_i [2*p +: 2] == {2{mask_q[p]}});
                assert (\u_dut.u_write.group_strobe_i [31:16] == 0);
                if (mask_q[p]) assert (half == {rgb_q[7:3], rgb_q[15:10], rgb_q[23:19]});
            end else begin
                assert (\u_dut.u_write.group_strobe_i [4*p +: 4] == {4{mask_q[p]}});
                if (mask_q[p]) assert (word == {8'd0, rgb_q[7:0], rgb_q[15:8], rgb_q[23:16]});
            end
            assert (pixels == mask_q[0] + mask_q[1] + mask_q[2] + mask_q[3] + mask_q[4] +
                              mask_q[5] + mask_q[6] + mask_q[7]);
        end
        // invariant
        if (begun_q) assert (\u_dut.stride_q == stride_q && \u_dut.rgb565_q == half_q);
        if (begun_q) assert (\u_dut.g_mux.mux_q == mux_q);
        if (there_q) assert (begun_q);
        assert (\u_dut.row_q == row_q);
        if (\u_dut.row_valid_q )            // of the group that waits
            assert (\u_dut.u_groups.group_valid_o && y_q == \u_dut.u_groups.group_y_o &&
                    step_q == \u_dut.stride_q );
        assert (empty == (\u_dut.u_groups.empty_o && !there_q && idle));  // nothing is between
    end
endmodule
`default_nettype wire
