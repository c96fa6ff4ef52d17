// rt_uart.v - bytes over a serial line: 8 bits, no parity, one stop bit, DIV clocks a bit
// SPDX-License-Identifier: Apache-2.0
//   rx_i --> two flip-flops --> start edge --> a sample in the middle of each bit --> byte
//   byte --> start, 8 bits, stop --> tx_o
// A start bit that is over in its middle is none. A byte whose stop bit is low is thrown away; the
// next one begins when the line was high again, so that a break is nothing, however long.
`timescale 1ns / 1ps
`default_nettype none
module rt_uart #(
    parameter DIV = 25                    // clocks a bit, 4..65535
) (
    input  wire       clk,
    input  wire       rst,
    input  wire       rx_i,               // high when idle, of no clock
    output wire       tx_o,
    // received, for one clock
    output reg        get_valid_o,
    output wire [7:0] get_data_o,
    // to be sent
    input  wire       put_valid_i,
    output wire       put_ready_o,
    input  wire [7:0] put_data_i
);
    localparam [31:0] LAST = DIV - 1, HALF = DIV / 2 - 1;

    // ---- in ----
    wire       rx;
    reg        was_q;                     // rx a clock before
    reg  [3:0] in_q;                      // bits to come, the start bit first; 0: idle
    reg [15:0] in_wait_q;
    reg  [8:0] in_bits_q;
    assign get_data_o = in_bits_q[7:0];
    rt_sync u_rx (.clk(clk), .d_i(rx_i), .q_o(rx));
    always @(posedge clk) begin
        get_valid_o <= 1'b0;
        was_q       <= rx;
        if (in_q == 4'd0) begin
            in_wait_q <= HALF[15:0];
            if (!rx && was_q) in_q <= 4'd10;
        end else if (in_wait_q != 16'd0) begin
            in_wait_q <= in_wait_q - 16'd1;
        end else begin
            in_wait_q <= LAST[15:0];
            in_q      <= in_q == 4'd10 && rx ? 4'd0 : in_q - 4'd1;
            if (in_q != 4'd10 && in_q != 4'd1) in_bits_q <= {1'b0, rx, in_bits_q[7:1]};
            get_valid_o <= in_q == 4'd1 && rx;
        end
        if (rst) begin
            was_q       <= 1'b0;
            in_q        <= 4'd0;
            get_valid_o <= 1'b0;
        end
    end

    // ---- out ----
    reg  [9:0] out_bits_q;                // what is left, the next one lowest; ones when idle
    reg  [3:0] out_q;                     // bits left
    reg [15:0] out_wait_q;
    assign tx_o        = out_bits_q[0];
    assign put_ready_o = out_q == 4'd0;
    always @(posedge clk) begin
        if (out_q == 4'd0) begin
            out_wait_q <= LAST[15:0];
            if (put_valid_i) begin
                out_bits_q <= {1'b1, put_data_i, 1'b0};
                out_q      <= 4'd10;
            end
        end else if (out_wait_q != 16'd0) begin
            out_wait_q <= out_wait_q - 16'd1;
        end else begin
            out_wait_q <= LAST[15:0];
            out_bits_q <= {1'b1, out_bits_q[9:1]};
            out_q      <= out_q - 4'd1;
        end
        if (rst) begin
            out_bits_q <= 10'h3ff;
            out_q      <= 4'd0;
        end
    end
    wire unused = &{1'b0, LAST, HALF, in_bits_q[8]};
endmodule
`default_nettype wire
