    // The golden model behind the ports of rt_core: make/rt_top.mk puts this behind the head of
    // rt_core.v. A frame: all lines are read twice over the bus, with every tag in turn, then come
    // pixels, one in seven clocks or one a clock. With the last one it is idle, as early as it may.
    // SPDX-License-Identifier: Apache-2.0
    import "DPI-C" function void golden_register(input int number, input int value);
    import "DPI-C" function int golden_lines(input int keep);
    import "DPI-C" function void golden_beat(input int number, input longint data);
    import "DPI-C" function int golden_draw(input int bad);
    import "DPI-C" function int golden_pixel(input int number, input int turn, output int x,
        output int y, output int rendering, output int l1, output int l2, output int chosen);
    import "DPI-C" function longint golden_count(input int number);
    import "DPI-C" function void axi_rule_broken(input string what);    // of tb/bench.h
    // For top_view.h, which tb_shell alone has: what this edge sees. rest: {rt_top's writer of
    // frames is empty, its display takes a frame, missed a pixel, is blank}.
    import "DPI-C" function void golden_seen(input int core, input int rest, input int errors,
        input longint count);

    localparam TAGS = 4, BEATS = 256 / MEM_DATA;
    localparam IDLE = 2'd0, READ = 2'd1, DRAW = 2'd2, PIXELS = 2'd3;
    reg [1:0]  state_q;
    reg [31:0] lines_q, asked_q, beats_q, pixel_q;
    reg [31:0] tag_beats_q [0:TAGS-1];   // that came for it
    reg        bad_q, pix_valid_q;
    reg [2:0]  wait_q;
    reg [47:0] count_q;
    reg        busy_q;
    reg [4:0]  count_addr_q;
    // request n has tag n % TAGS; this is the one whose beat comes
    wire [31:0] tag  = 32'(mem_rsp_tag_i) % TAGS;
    wire [31:0] beat = tag_beats_q[tag];
    wire [31:0] of   = tag + TAGS * (beat / BEATS);
    int        pixel [6], next [6];      // x, y, colours: of what is offered, of what comes then
    assign busy_o          = state_q != IDLE;
    assign active_o        = rst || busy_o || busy_q || start_i || cfg_valid_i ||
                             count_addr_i != count_addr_q;
    assign mem_req_valid_o = state_q == READ && asked_q != 2 * lines_q &&
                             BEATS * asked_q - beats_q < BEATS * MEM_DATA;
    assign mem_req_tag_o   = `RT_TAG_BITS'(asked_q % TAGS);
    assign mem_req_line_o  = `RT_LINE_BITS'(asked_q < lines_q ? asked_q : asked_q - lines_q);
    assign mem_rsp_ready_o = state_q == READ && !wait_q[0];
    assign pix_valid_o     = pix_valid_q;
    assign pix_x_o         = pixel[0][13:0];
    assign pix_y_o         = pixel[1][13:0];
    assign pix_colour_o    = {pixel[4][23:0], pixel[3][23:0], pixel[2][23:0]};
    assign pix_frame_o     = pixel[5][`RT_RGB_BITS-1:0];
    assign pix_id_o        = 0;
    assign pix_key_o       = 0;
    assign pix_visits_o    = 0;
    assign pix_texture_o   = 0;
    assign count_data_o    = count_q;
`ifdef TOP_VIEW
    always @(posedge clk)
        golden_seen(32'({rst, start_i, keep_cache_i, busy_o, mem_req_valid_o && mem_req_ready_i}),
            32'({rt_top.u_run.write_empty_i, rt_top.video_take, rt_top.underrun, rt_top.blank}),
            32'(errors_o), 64'(count_q));
`endif
    always @(posedge clk) begin
        count_q <= 48'(golden_count(32'(count_addr_i)));
        busy_q  <= busy_o;
        count_addr_q <= count_addr_i;
        wait_q  <= wait_q == 6 ? 0 : wait_q + 1'b1;
        if (mem_rsp_valid_i && (mem_rsp_tag_i >= TAGS || of >= asked_q) && state_q == READ) begin
            axi_rule_broken("an answer that nobody asked for");
        end
        if (cfg_valid_i && state_q == IDLE && !rst) golden_register(32'(cfg_addr_i), cfg_data_i);
        case (state_q)
            IDLE: if (start_i) begin
                lines_q  <= golden_lines(32'(keep_cache_i));
                asked_q  <= 0;
                beats_q  <= 0;
                for (int t = 0; t < TAGS; t++) tag_beats_q[t] <= 0;
                bad_q    <= 1'b0;
                errors_o <= 0;
                wait_q   <= 0;
                state_q  <= READ;
            end
            READ: begin
                if (mem_req_valid_o && mem_req_ready_i) asked_q <= asked_q + 1;
                if (mem_rsp_valid_i && mem_rsp_ready_o) begin
                    for (int w = 0; w < MEM_DATA / 64; w++)
                        golden_beat(4 * (of % lines_q) + (beat % BEATS) * (MEM_DATA / 64) + w,
                                    mem_rsp_data_i[64*w +: 64]);
                    tag_beats_q[tag] <= beat + 1;
                    beats_q <= beats_q + 1;
                    bad_q   <= bad_q || mem_rsp_error_i;
                end
                if (beats_q == 2 * BEATS * lines_q) state_q <= DRAW;
            end
            DRAW: begin
                errors_o <= `RT_ERRORS'(golden_draw(32'(bad_q))) | `RT_ERRORS'(bad_q) << `RT_ERROR_BUS_ERROR;
                pixel_q  <= 0;
                state_q  <= PIXELS;
            end
            PIXELS: if (!pix_valid_q || pix_ready_i) begin
                pix_valid_q <= 1'b0;
                case (golden_pixel(pixel_q, 32'(wait_q == 0), next[0], next[1], next[2], next[3],
                                   next[4], next[5]))
                    0: state_q <= IDLE;
                    1: begin
                        pix_valid_q <= 1'b1;
                        pixel_q     <= pixel_q + 1;
                        pixel       <= next;
                    end
                    default: ;           // its turn has not come
                endcase
            end
        endcase
        if (rst) begin
            state_q     <= IDLE;
            pix_valid_q <= 1'b0;
            wait_q      <= 0;
            errors_o    <= 0;
        end
    end
endmodule
`default_nettype wire
