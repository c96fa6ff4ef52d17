// minimal.v - rt_core draws the machine that two files of $readmemh hold, into scene.ppm
// SPDX-License-Identifier: Apache-2.0
`timescale 1ns / 1ps
module minimal;
    reg  [31:0]  regs [0:119];        // scene.regs.hex
    reg  [255:0] mem [0:9];           // scene.mem.hex, lines
    reg  [23:0]  frame [0:24*16-1];
    reg          clk = 0;
    reg  [7:0]   step = 8'hf0;        // 16 clocks of reset, 120 registers, start, frame
    reg  [3:0]   line = 0;            // of memory, read in four beats; 4: none is asked for
    reg  [2:0]   beat = 4;
    wire         busy, ask, take, drawn;
    wire [25:0]  wanted;
    wire [4:0]   reader;              // who asks
    reg  [4:0]   tag;
    wire [13:0]  x, y;
    wire [23:0]  pixel;
    integer      i, file;
    rt_core #(                        // as the comments of these files say, and no more
        .W(12), .WD(13), .PQ(13), .NG(2), .FW(12), .PR(0), .SHADOW(1), .REFLECT(2), .LIGHTS(1),
        .INSIDE(0), .FIRST(0), .INTERPENETRATE(0), .FACETS(0), .RECT(0), .SPANS(0), .CONES(0),
        .CAMERA(0)
    ) u_core (
        .clk(clk), .rst(step[7]), .start_i(step == 120), .keep_cache_i(1'b0), .busy_o(busy),
        .cfg_valid_i(step < 120), .cfg_addr_i(step[6:0]), .cfg_data_i(regs[step[6:0]]),
        .mem_req_valid_o(ask), .mem_req_ready_i(beat == 4), .mem_req_line_o(wanted),
        .mem_req_tag_o(reader), .mem_rsp_tag_i(tag),
        .mem_rsp_valid_i(beat < 4), .mem_rsp_ready_o(take), .mem_rsp_error_i(1'b0),
        .mem_rsp_data_i(mem[line][64*beat[1:0] +: 64]), .count_addr_i(5'd0), .count_data_o(),
        .pix_valid_o(drawn), .pix_ready_i(1'b1), .pix_x_o(x), .pix_y_o(y), .pix_frame_o(pixel),
        .pix_colour_o(), .pix_id_o(), .pix_key_o(), .pix_visits_o(), .pix_texture_o(), .errors_o(),
        .active_o());
    always #5 clk = !clk;
    always @(posedge clk) begin
        if (step != 123) step <= step + 1;
        if (ask && beat == 4) {tag, line, beat} <= {reader, wanted[3:0], 3'd0};
        else if (take && beat < 4) beat <= beat + 1;
        if (drawn) frame[y*24 + x] <= pixel;
        if (step == 123 && !busy) begin
            file = $fopen("scene.ppm", "wb");
            $fwrite(file, "P6\n24 16\n255\n");
            for (i = 0; i < 24*16; i = i + 1)
                $fwrite(file, "%c%c%c", frame[i][7:0], frame[i][15:8], frame[i][23:16]);
            $finish;
        end
    end
    initial $readmemh("scene.regs.hex", regs);
    initial $readmemh("scene.mem.hex", mem);
endmodule
