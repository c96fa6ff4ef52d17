// rt_counters.v - the work counters of the core
// SPDX-License-Identifier: Apache-2.0
// Events gather in a small sum per counter; one sum a cycle, in turn, goes into its 48-bit total
// through one adder. A total is complete 16 cycles after the last event; clear_i takes as long.
// Numbers: machine.def. data_o is the total addressed one cycle before.
`default_nettype none
`include "rt_layout.vh"
module rt_counters (
    input  wire         clk,
    input  wire         rst,
    input  wire         clear_i,
    input  wire [127:0] add_i,    // counter i: u8 at 8*i, at most 63 events of this cycle
    input  wire [3:0]   addr_i,
    output reg  [47:0]  data_o
);
    reg [3:0]  turn_q;
    reg [4:0]  clear_q;           // totals that still start anew
    wire       clearing = clear_q != 5'd0;

    // ---- sums: at most 16 cycles of 63 events ----
    wire [159:0] sums;
    genvar c;
    generate
        for (c = 0; c < `RT_COUNTERS; c = c + 1) begin : g_sum
            reg [9:0] sum_q;
            wire      now = turn_q == c;
            always @(posedge clk) begin
                sum_q <= (now ? 10'd0 : sum_q) + {2'd0, add_i[8*c +: 8]};
                if (clear_i || rst) sum_q <= 10'd0;
            end
            assign sums[10*c +: 10] = now ? sum_q : 10'd0;
        end
    endgenerate
    reg [9:0] sum;
    integer i;
    always @* begin
        sum = 10'd0;
        for (i = 0; i < `RT_COUNTERS; i = i + 1) sum = sum | sums[10*i +: 10];
    end

    // ---- totals ----
    wire [47:0] total, shown;
    wire [47:0] total_next = (clearing ? 48'd0 : total) + {38'd0, sum};
    rt_slot_file #(.WIDTH(48), .SLOTS(16)) u_total (
        .clk(clk), .wr_en_i(1'b1), .wr_addr_i(turn_q), .wr_data_i(total_next),
        .rd_addr_i(turn_q), .rd_data_o(total)
    );
    rt_slot_file #(.WIDTH(48), .SLOTS(16)) u_shown (
        .clk(clk), .wr_en_i(1'b1), .wr_addr_i(turn_q), .wr_data_i(total_next),
        .rd_addr_i(addr_i), .rd_data_o(shown)
    );
    always @(posedge clk) begin
        turn_q <= turn_q + 4'd1;
        if (clearing) clear_q <= clear_q - 5'd1;
        if (clear_i || rst) clear_q <= 5'd16;
        if (rst) turn_q <= 4'd0;
        data_o <= shown;
    end
endmodule
`default_nettype wire
