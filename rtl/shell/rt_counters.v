// rt_counters.v - the work counters of the core
// SPDX-License-Identifier: Apache-2.0
// Adds up to SOURCES events of ADD bits a counter and cycle; 48 bits do not overflow in years.
// Numbers: machine.def. data_o is the counter addressed one cycle before.
`default_nettype none
`include "rt_layout.vh"
module rt_counters (
    input  wire         clk,
    input  wire         clear_i,
    input  wire [127:0] add_i,    // counter i: u8 at 8*i
    input  wire [3:0]   addr_i,
    output reg  [47:0]  data_o
);
    reg [48*`RT_COUNTERS-1:0] count_q;
    integer i;
    always @(posedge clk) begin
        for (i = 0; i < `RT_COUNTERS; i = i + 1)
            count_q[48*i +: 48] <= clear_i ? 48'd0 : count_q[48*i +: 48] + {40'd0, add_i[8*i +: 8]};
        data_o <= count_q[48*addr_i +: 48];
    end
endmodule
`default_nettype wire
