// core_tb.sv - rt_core draws a machine file two times; every pixel against the golden model
// SPDX-License-Identifier: Apache-2.0
//
// +machine=FILE.sph; parameters of rt_core: sim/cores.py, or sphaera_machine_parameter(). Ends with
// 1 if anything differs.
`timescale 1ns / 1ps
module core_tb #(
    parameter W = 16, WD = 17, PQ = 17, NG = 2, FW = 14, PR = 0,
    parameter SHADOW = 1, REFLECT = 2, LIGHTS = 1, INSIDE = 0, FIRST = 0, INTERPENETRATE = 0,
    parameter FACETS = 0, RECT = 0, SPANS = 0, CONES = 0, CAMERA = 0
);
    import sphaera_pkg::*;
    localparam FRAMES = 2, COUNTERS = 22;
    logic         clk = 0, rst = 1, start = 0, write = 0;
    logic         busy, ask, rsp_take, drawn;
    logic [6:0]   number;
    logic [31:0]  word, texture;
    logic [25:0]  wanted;
    logic [4:0]   tag, rsp_tag, count = 0;
    logic [255:0] line;
    logic [2:0]   beat = 4;          // of the line that is read; 4: none is
    logic [13:0]  x, y;
    logic [71:0]  colour;
    logic [23:0]  id, visits;
    logic [W+WD+1:0] key;
    logic [47:0]  counted;
    logic [6:0]   errors;
    logic         ready = 0;
    golden        model;
    always #5 clk = !clk;
    rt_core #(
        .W(W), .WD(WD), .PQ(PQ), .NG(NG), .FW(FW), .PR(PR), .SHADOW(SHADOW), .REFLECT(REFLECT),
        .LIGHTS(LIGHTS), .INSIDE(INSIDE), .FIRST(FIRST), .INTERPENETRATE(INTERPENETRATE),
        .FACETS(FACETS), .RECT(RECT), .SPANS(SPANS), .CONES(CONES), .CAMERA(CAMERA)
    ) u_core (
        .clk(clk), .rst(rst), .start_i(start), .keep_cache_i(1'b0), .busy_o(busy), .active_o(),
        .cfg_valid_i(write), .cfg_addr_i(number), .cfg_data_i(word),
        .mem_req_valid_o(ask), .mem_req_ready_i(beat == 4), .mem_req_line_o(wanted),
        .mem_req_tag_o(tag), .mem_rsp_valid_i(beat < 4), .mem_rsp_ready_o(rsp_take),
        .mem_rsp_tag_i(rsp_tag), .mem_rsp_data_i(line[64*beat[1:0] +: 64]), .mem_rsp_error_i(1'b0),
        .pix_valid_o(drawn), .pix_ready_i(ready), .pix_x_o(x), .pix_y_o(y), .pix_colour_o(colour),
        .pix_frame_o(), .pix_id_o(id), .pix_key_o(key), .pix_visits_o(visits),
        .pix_texture_o(texture), .count_addr_i(count), .count_data_o(counted), .errors_o(errors));

    // memory, and pixels that wait now and then
    always @(posedge clk) if (!rst) begin
        ready <= $urandom_range(3) != 0;
        if (ask && beat == 4) begin
            bit [255:0] bits;
            model.line(32'(wanted), bits);
            line    <= bits;
            rsp_tag <= tag;
            beat    <= 0;
        end else if (beat < 4 && rsp_take) beat <= beat + 1;
        if (drawn && ready)
            void'(model.pixel(x, y, colour, id, 64'(key), visits, texture));
    end

    initial begin
        string path;
        if ($value$plusargs("machine=%s", path) == 0) $fatal(1, "+machine=FILE.sph, please");
        model = new(path);
        repeat (16) @(negedge clk);
        rst = 0;
        for (int i = 0; i < model.registers(); i++) begin
            @(negedge clk);
            write  = 1;
            number = 7'(i);
            word   = model.register(i);
        end
        @(negedge clk) write = 0;
        repeat (FRAMES) begin
            start = 1;
            @(negedge clk) start = 0;
            do @(negedge clk); while (busy);
            for (int i = 0; i < COUNTERS; i++) begin
                count = 5'(i);
                repeat (2) @(negedge clk);
                void'(model.counter(i, counted));
            end
            void'(model.errors(32'(errors)));
            void'(model.done());
        end
        if (model.differ != 0) $fatal(1, "not ok: %0d differences", model.differ);
        $display("ok: %0d frames as the model draws them", FRAMES);
        $finish;
    end
endmodule
