// tmds_decode.vh - the byte of a TMDS symbol, for benches; included in a module
// SPDX-License-Identifier: Apache-2.0
// DVI 1.0, figure 3-6, and the four symbols of blanking.
function [8:0] decode(input [9:0] symbol);   // the top bit: it is data
    integer n;
    reg [7:0] bits;
    begin
        bits = symbol[9] ? ~symbol[7:0] : symbol[7:0];
        decode[0] = bits[0];
        for (n = 1; n < 8; n = n + 1) decode[n] = bits[n] ^ bits[n-1] ^ !symbol[8];
        decode[8] = symbol != 10'h354 && symbol != 10'h0ab && symbol != 10'h154
                 && symbol != 10'h2ab;
    end
endfunction
