// f_share.v - proof of rt_share at its full width: colour, shares and weights are the model's
// SPDX-License-Identifier: Apache-2.0
// A surface is taken after a reset, of which data registers know nothing, and its result is
// compared 12 clocks later, when rt_share is as idle as before: so every surface is that one. The
// reference has each product whole. Inputs: any, but weights are at most 1.
`timescale 1ns / 1ps
`default_nettype none
module f_share #(
    parameter SUM      = 1,
    parameter SPECULAR = 1,
    parameter CHANNEL  = 0      // of the colour that is looked at
) (
    input wire         clk,
    input wire         background, sum,
    input wire [47:0]  ambient,
    input wire [50:0]  lights, gloss,
    input wire [23:0]  albedo,
    input wire [8:0]   ka, kd, kr, kt, least,
    input wire [7:0]   ks, tag,
    input wire [16:0]  weight,
    input wire [1:0]   depth,
    input wire [143:0] frames
);
    reg [3:0] age_q = 4'd0;
    always @(posedge clk) if (age_q != 4'd15) age_q <= age_q + 1'b1;
    wire [16:0] w  = weight > 17'd65536 ? 17'd65536 : weight;   // no assumption: abc knows none
    wire [1:0]  at = depth == 2'd3 ? 2'd2 : depth;
    wire ready, valid;
    wire [7:0]   out_tag;
    wire [143:0] out;
    wire [16:0]  mirror, refract, total;
    wire         light_mirror, light_refract;
    rt_share #(.SUM(SUM), .SPECULAR(SPECULAR), .TAG(8)) u_dut (
        .clk(clk), .rst(age_q == 0), .in_valid_i(age_q == 1), .in_ready_o(ready), .in_tag_i(tag),
        .in_background_i(background), .in_ambient_i(ambient), .in_lights_i(lights),
        .in_gloss_i(gloss), .in_albedo_i(albedo), .in_sum_i(sum), .in_ka_i(ka), .in_kd_i(kd),
        .in_ks_i(ks), .in_kr_i(kr), .in_kt_i(kt), .in_weight_i(w), .in_least_i(least),
        .in_depth_i(at), .in_frames_i(frames), .out_valid_o(valid), .out_tag_o(out_tag),
        .out_frames_o(out), .out_mirror_o(mirror), .out_refract_o(refract), .out_total_o(total),
        .out_light_mirror_o(light_mirror), .out_light_refract_o(light_refract)
    );

    // ---- the model: sph_shading_read(), _worth(), _light(), _own(), sph_shares_add() ----
    function [8:0] share(input [8:0] s); share = s[8] ? 9'd256 : s; endfunction
    // a product of a share, a byte or an albedo is below 2^25 - 2^8: 2^17 - 1 times 2^8 at most
    function [16:0] by_256(input [33:0] p); by_256 = ({1'b0, p[24:0]} + 26'd128) >> 8; endfunction
    function [17:0] by_128(input [33:0] p); by_128 = (p[24:0] + 25'd64) >> 7; endfunction
    function [17:0] by_65536(input [33:0] p);
        by_65536 = ({1'b0, p[32:0]} + 34'd32768) >> 16;
    endfunction
    function [33:0] times(input [16:0] a, input [16:0] b); times = a * b; endfunction
    function [15:0] limit(input [17:0] x); limit = x > 18'd65280 ? 16'd65280 : x[15:0]; endfunction
    function [15:0] most(input [18:0] x); most = x > 19'd65535 ? 16'd65535 : x[15:0]; endfunction
    reg         m_background, m_sum;
    reg [15:0]  m_ambient;
    reg [16:0]  m_lights, m_gloss, m_weight;
    reg [7:0]   m_albedo, m_ks, m_tag;
    reg [8:0]   m_ka, m_kd, m_kr, m_kt, m_least;
    reg [1:0]   m_depth;
    reg [47:0]  m_frames;
    always @(posedge clk) if (age_q == 1) begin
        m_background <= background;
        m_sum     <= SUM != 0 && sum && !background;
        m_ambient <= ambient[16*CHANNEL +: 16];
        m_lights  <= lights[17*CHANNEL +: 17];
        m_gloss   <= gloss[17*CHANNEL +: 17];
        m_albedo  <= albedo[8*CHANNEL +: 8];
        {m_ka, m_kd, m_kr, m_kt} <= {share(ka), share(kd), share(kr), share(kt)};
        m_least   <= least;
        {m_ks, m_tag, m_weight, m_depth} <= {ks, tag, w, at};
        m_frames  <= {frames[96 + 16*CHANNEL +: 16], frames[48 + 16*CHANNEL +: 16],
                      frames[16*CHANNEL +: 16]};
    end
    // the background is an albedo in the light of 1 alone, other blends have shares of 1 and no
    // highlight: the same products, with factors 0 and 256
    wire [8:0]  a = m_background ? 9'd0 : m_sum ? m_ka : 9'd256, d = m_sum ? m_kd : 9'd256;
    wire [16:0] lit = m_background ? 17'h08000 : m_lights;
    wire [17:0] both  = {1'b0, by_256(times({1'b0, m_ambient}, {8'd0, a}))} +
                        {1'b0, by_256(times(lit, {8'd0, d}))};
    wire [16:0] light = SUM == 0 ? lit : both > 18'd131071 ? 17'd131071 : both[16:0];
    wire [7:0]  glossy = m_sum ? m_ks : 8'd0;
    wire [15:0] bright = limit(by_128(times(m_gloss, {9'd0, glossy})));
    wire [15:0] shine = SPECULAR != 0 ? bright : 16'd0;
    wire [15:0] seen  = limit(by_128(times(light, {9'd0, m_albedo})));
    wire [15:0] colour = limit({2'd0, seen} + {2'd0, shine});
    wire [16:0] w_kr  = by_256(times(m_weight, {8'd0, m_kr}));
    wire [16:0] w_kt  = by_256(times(m_weight, {8'd0, m_kt}));
    wire        no_kr = w_kr < {m_least, 8'd0}, no_kt = w_kt < {m_least, 8'd0};
    wire [9:0]  rays  = (no_kr ? 10'd0 : {1'b0, m_kr}) + (no_kt ? 10'd0 : {1'b0, m_kt});
    wire [8:0]  all   = rays > 10'd256 ? 9'd256 : rays[8:0];
    wire [8:0]  own   = m_sum ? 9'd256 : 9'd256 - all;
    wire [16:0] front = by_256(times(m_weight, {8'd0, own}));
    wire [17:0] whole = by_65536(times({1'b0, colour}, m_weight));
    wire [17:0] part  = by_65536(times({1'b0, colour}, front));
    wire [18:0] f_0   = {3'd0, m_frames[15:0]} + {1'b0, whole};
    wire [18:0] f_1   = {3'd0, m_frames[31:16]} + {1'b0, m_depth[0] ? whole : part};
    wire [18:0] f_2   = {3'd0, m_frames[47:32]} + {1'b0, part};
    always @* begin
        if (age_q == 1) assert (ready);
        if (age_q == 13) begin
            assert (valid && ready && out_tag == m_tag);
            assert (mirror == w_kr && refract == w_kt);
            assert (light_mirror == no_kr && light_refract == no_kt);
            assert (total == by_256(times(m_weight, {8'd0, all})));
            assert (out[16*CHANNEL +: 16] == (m_depth == 0 ? most(f_0) : m_frames[15:0]));
            assert (out[48 + 16*CHANNEL +: 16] == (m_depth <= 1 ? most(f_1) : m_frames[31:16]));
            assert (out[96 + 16*CHANNEL +: 16] == most(f_2));
        end
    end
endmodule
`default_nettype wire
