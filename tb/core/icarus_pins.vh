// icarus_pins.vh - the core driven clock by clock, by text: a part of tb_core_icarus.v
// SPDX-License-Identifier: Apache-2.0
//
// The output begins with MEM_DATA, hex. +pins=FILE: each line of it has the inputs of a clock,
// `control cfg_addr cfg_data count_addr rsp_tag rsp_data`, all hex, control = {rst, start, keep,
// cfg_valid, req_ready, rsp_valid, rsp_error, pix_ready}; after each the output has a line:
// {req_valid, rsp_ready, pix_valid} in binary, the line asked for, its tag, the pixel, and behind
// the edge busy, errors, counter. What goes with no valid is x. driven_icarus.h writes and reads.
    reg [31:0] p_data;
    reg [4:0] p_tag;
    reg [255:0] p_beat;
    reg [7:0] p_control;
    integer p_got;
    initial begin
        #1 if (driven) $fwrite(out, "%h\n", MEM_DATA);
        $fflush(out);
        while (driven) begin
            p_got = $fscanf(pins, "%h %h %h %h %h %h", p_control, cfg_addr, p_data, count_addr,
                            p_tag, p_beat);
            if (p_got != 6) $finish;
            {rst, start, keep, cfg_valid, req_ready, rsp_valid, rsp_error, pix_ready} = p_control;
            if (!start || rst) keep = 1'bx;
            if (!rsp_valid) rsp_error = 1'bx;
            if (!cfg_valid) cfg_addr = 7'bx;
            cfg_data = cfg_valid ? p_data : 32'bx;
            rsp_tag = rsp_valid ? p_tag : 5'bx;
            rsp_data = rsp_valid ? p_beat[MEM_DATA-1:0] : {MEM_DATA{1'bx}};
            #1 $fwrite(out, "%b%b%b %h %h", req_valid, rsp_ready, pix_valid, req_line, req_tag);
            if (pix_valid !== 1'b0)
                $fwrite(out, " %h %h %h %h %h %h %h %h", pix_x, pix_y, pix_colour, pix_id, pix_key,
                        pix_visits, pix_texture, pix_frame);
            clk = 1'b1;
            #1 $fwrite(out, " / %b %h %h\n", busy, errors, count_data);
            $fflush(out);
            clk = 1'b0;
        end
    end
