// rt_longitude.v - longitude and latitude of a vector by shift and add (CORDIC)
// SPDX-License-Identifier: Apache-2.0
//   around = 1/2 + atan2(x, z) / turn, down = acos(y / |v|) / half a turn; on the axis around = 1/2
// Two rotations of 18 steps onto the first axis, a step a clock: (z, x), then what it gave (the
// distance from the axis, GAIN times) and GAIN * y. Words s5.22, angles in 2^-24 turns.
//   1 load | 18 steps | 1 change | 18 steps | 1 limit, round
// Latency 39 cycles, one at a time. Model: sph_longitude() in cmodel/texture/coords.c
`timescale 1ns / 1ps
`default_nettype none
module rt_longitude #(
    parameter TAG = 8                      // what travels along, bits
) (
    input  wire               clk,
    input  wire               rst,         // synchronous, active high
    input  wire               in_valid_i,
    output wire               in_ready_o,
    input  wire [TAG-1:0]     in_tag_i,
    input  wire signed [18:0] in_x_i,      // s2.16
    input  wire signed [18:0] in_y_i,
    input  wire signed [18:0] in_z_i,
    output reg                out_valid_o, // one cycle
    output reg  [TAG-1:0]     out_tag_o,
    output reg  [17:0]        out_around_o,  // u0.18 turns
    output reg  [17:0]        out_down_o     // u1.17 half turns
);
    localparam [4:0] STEPS = 5'd18;
    localparam signed [17:0] GAIN = 18'sd107922;   // u1.16

    // ---- control: step_q counts both rotations, STEPS is the clock that ends one ----
    reg        busy_q, second_q;
    reg  [4:0] step_q;
    wire       take = in_valid_i && in_ready_o;
    wire       last = step_q == STEPS;
    wire       moves = take || busy_q;     // else all stands still
    assign in_ready_o = !busy_q;
    always @(posedge clk) begin
        if (moves) step_q <= take || last ? 5'd0 : step_q + 5'd1;
        second_q    <= !take && (second_q || last);
        busy_q      <= take || (busy_q && !(last && second_q));
        out_valid_o <= busy_q && last && second_q;
        if (rst) begin
            busy_q      <= 1'b0;
            out_valid_o <= 1'b0;
        end
    end

    // ---- angles: atan(2^-step) ----
    reg [21:0] angle;                      // 2^-24 turns
    always @*
        case (step_q)
            5'd0:    angle = 22'd2097152;
            5'd1:    angle = 22'd1238021;
            5'd2:    angle = 22'd654136;
            5'd3:    angle = 22'd332050;
            5'd4:    angle = 22'd166669;
            5'd5:    angle = 22'd83416;
            5'd6:    angle = 22'd41718;
            5'd7:    angle = 22'd20860;
            5'd8:    angle = 22'd10430;
            5'd9:    angle = 22'd5215;
            5'd10:   angle = 22'd2608;
            5'd11:   angle = 22'd1304;
            5'd12:   angle = 22'd652;
            5'd13:   angle = 22'd326;
            5'd14:   angle = 22'd163;
            5'd15:   angle = 22'd81;
            5'd16:   angle = 22'd41;
            default: angle = 22'd20;
        endcase

    // ---- GAIN * y, while the first rotation runs ----
    reg  signed [18:0] y_in_q;
    reg  signed [36:0] y_prod_q;           // s4.32
    wire signed [27:0] y_gain = $signed({y_prod_q[36], y_prod_q[36:10]}) +
                                $signed({27'd0, y_prod_q[9]});
    always @(posedge clk) begin
        if (take) y_in_q <= in_y_i;
        y_prod_q <= y_in_q * GAIN;
    end

    // ---- a step: towards y = 0, the angle on the way ----
    reg  signed [27:0] x_q, y_q;           // s5.22
    reg  signed [24:0] sum_q;              // 2^-24 turns
    reg  [23:0]        around_q;
    reg                zero_q;             // no direction: no angle
    reg  [TAG-1:0]     tag_q;
    wire               back = in_z_i[18];
    wire signed [27:0] in_x = {{3{in_x_i[18]}}, in_x_i, 6'd0};
    wire signed [27:0] in_z = {{3{in_z_i[18]}}, in_z_i, 6'd0};
    wire               up = !y_q[27];
    wire signed [27:0] dx = y_q >>> step_q, dy = x_q >>> step_q;
    wire signed [24:0] turn = zero_q ? 25'sd0 : sum_q;
    // one sum each, with what is taken away as its complement
    wire [28:0] x_next   = {x_q, 1'b1} + {dx ^ {28{!up}}, !up};
    wire [28:0] y_next   = {y_q, 1'b1} + {dy ^ {28{up}}, up};
    wire [25:0] sum_next = {sum_q, 1'b1} + {{3'd0, angle} ^ {25{!up}}, !up};
    // what begins a rotation: of the first, a vector; of the second, the distance that x has
    wire signed [27:0] y_new = !take ? y_gain : back ? -in_x : in_x;
    always @(posedge clk) if (moves) begin
        if (take)       x_q <= back ? -in_z : in_z;
        else if (!last) x_q <= x_next[28:1];
        y_q   <= take || last ? y_new : y_next[28:1];
        sum_q <= take || last ? 25'sd0 : sum_next[25:1];
        if (last) begin
            zero_q   <= x_q == 28'sd0 && y_gain == 28'sd0;
            if (!second_q) around_q <= around_q + turn[23:0];
        end
        if (take) begin
            zero_q   <= in_x_i == 19'sd0 && in_z_i == 19'sd0;
            around_q <= {!back, 23'd0};
            tag_q    <= in_tag_i;
        end
    end

    // ---- the end: 1/4 - latitude, limited; both to 2^-18 turns, half up ----
    wire signed [24:0] down = 25'sd4194304 - turn;
    wire        [23:0] limited = down[24] ? 24'd0 : down[23] ? 24'h800000 : down[23:0];
    always @(posedge clk) begin
        out_tag_o    <= tag_q;
        out_around_o <= around_q[23:6] + {17'd0, around_q[5]};
        out_down_o   <= limited[23:6] + {17'd0, limited[5]};
    end
    wire unused = &{1'b0, y_prod_q[8:0], around_q[4:0], limited[4:0], turn[24], x_next[0],
                    y_next[0], sum_next[0]};
endmodule
`default_nettype wire
