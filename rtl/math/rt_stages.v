// rt_stages.v - a word and its valid bit, CYCLES later; valid is cleared by reset
// SPDX-License-Identifier: Apache-2.0
// A stage that nothing valid enters keeps its word, so that nothing behind it switches.
`timescale 1ns / 1ps
`default_nettype none
module rt_stages #(
    parameter WIDTH  = 8,  // bits
    parameter CYCLES = 1   // at least 1
) (
    input  wire             clk,
    input  wire             rst,
    input  wire             in_valid_i,
    input  wire [WIDTH-1:0] in_i,
    output wire             out_valid_o,
    output wire [WIDTH-1:0] out_o
);
    wire [CYCLES:0]           valid;
    wire [WIDTH*(CYCLES+1)-1:0] word;
    assign valid[0]         = in_valid_i;
    assign word[0 +: WIDTH] = in_i;
    genvar i;
    generate
        for (i = 0; i < CYCLES; i = i + 1) begin : g_stage
            reg             valid_q;
            reg [WIDTH-1:0] word_q;
            always @(posedge clk) begin
                valid_q <= valid[i];
                if (valid[i]) word_q <= word[WIDTH*i +: WIDTH];
                if (rst) valid_q <= 1'b0;
            end
            assign valid[i+1]                   = valid_q;
            assign word[WIDTH*(i+1) +: WIDTH] = word_q;
        end
    endgenerate
    assign out_valid_o = valid[CYCLES];
    assign out_o       = word[WIDTH*CYCLES +: WIDTH];
endmodule
`default_nettype wire
