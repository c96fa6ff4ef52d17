// rt_tmds.v - TMDS encoder of one channel, DVI 1.0 section 3.2
// SPDX-License-Identifier: Apache-2.0
//   stage 1: fewer transitions: each bit is the XOR or XNOR of it and the one before
//   stage 2: DC balance: the 8 bits are inverted if that brings ones and zeros sent so far nearer
// Blanking sends one of four symbols of seven transitions or more, and the balance starts anew.
// Latency 2, one symbol a clock while advance_i is high; bit 0 is sent first.
`timescale 1ns / 1ps
`default_nettype none
module rt_tmds (
    input  wire       clk,
    input  wire       advance_i,          // the clock counts
    input  wire       de_i,               // data, or else control
    input  wire [7:0] data_i,
    input  wire [1:0] control_i,          // of channel 0: vsync, hsync
    output reg  [9:0] symbol_o
);
    // ---- stage 1: transitions ----
    function [3:0] count_ones(input [7:0] bits);
        count_ones = {3'd0, bits[0]} + {3'd0, bits[1]} + {3'd0, bits[2]} + {3'd0, bits[3]}
                   + {3'd0, bits[4]} + {3'd0, bits[5]} + {3'd0, bits[6]} + {3'd0, bits[7]};
    endfunction
    wire [3:0] ones_in = count_ones(data_i);
    wire xnors = ones_in > 4'd4 || (ones_in == 4'd4 && !data_i[0]);
    reg  [7:0] coded;
    integer i;
    always @* begin
        coded[0] = data_i[0];
        for (i = 1; i < 8; i = i + 1) coded[i] = coded[i-1] ^ data_i[i] ^ xnors;
    end
    reg        s1_de_q;
    reg  [1:0] s1_control_q;
    reg  [7:0] s1_q;
    reg        s1_xor_q;                  // bit 8 of the symbol: XOR
    always @(posedge clk) if (advance_i) begin
        s1_control_q <= control_i;
        s1_q         <= coded;
        s1_xor_q     <= !xnors;
        s1_de_q      <= de_i;
    end

    // ---- stage 2: balance; half of (ones - zeros) of the 8 bits is ones - 4 ----
    wire [3:0] ones = count_ones(s1_q);
    wire signed [4:0] more = $signed({1'b0, ones}) - 5'sd4;    // -4..4
    reg  signed [4:0] sum_q;              // half of (ones - zeros) sent since blanking, -5..5
    wire even   = sum_q == 5'sd0 || more == 5'sd0;
    wire invert = even ? !s1_xor_q : sum_q[4] == more[4];
    // half of what bits 9 and 8 add: 11 is +1, 00 is -1
    wire signed [4:0] ends = even ? 5'sd0 : {{4{!invert && !s1_xor_q}}, (invert == s1_xor_q)};
    always @(posedge clk) if (advance_i) begin
        if (s1_de_q) begin
            symbol_o <= {invert, s1_xor_q, s1_q ^ {8{invert}}};
            sum_q    <= (invert ? sum_q - more : sum_q + more) + ends;
        end else begin
            case (s1_control_q)
                2'b00:   symbol_o <= 10'b1101010100;
                2'b01:   symbol_o <= 10'b0010101011;
                2'b10:   symbol_o <= 10'b0101010100;
                default: symbol_o <= 10'b1010101011;
            endcase
            sum_q <= 5'sd0;
        end
    end
endmodule
`default_nettype wire
