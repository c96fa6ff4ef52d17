// tb_core_icarus.v - the core in Icarus: memory, registers and stalls from plusargs, pixels as text
// SPDX-License-Identifier: Apache-2.0
//
// vvp BENCH +regs=FILE +mem=FILE +out=FILE +latency=N +stall=PERCENT +seed=N +watchdog=N
//           +error_at=N (-1: never) +warm=0|1 +reset_at=N (-1: never) +reset_for=CLOCKS
//           +spoil=LINE (-1: none)                     files in hex, with absolute paths
// or, with +pins=FILE, driven by text: icarus_pins.vh
//
// Lines of the output: `p x y colour id key visits texture` (all hex), `c number value` (hex),
// `k clocks` (from start to the last pixel), `e errors`, `w` (the warm pass begins), `h why`
// (hang), `end`. simulate_icarus.cpp reads them.
// Everything the core sees changes at the rising edge, or soon after it.
`timescale 1ns / 1ps
`default_nettype none
`include "rt_layout.vh"
module tb_core_icarus #(
    parameter LINES = 131072,  // of memory
    `include "rt_core_parameters.vh"
);
    localparam N_REGS = `RT_N_REGS;
    localparam QUEUE = 1024;   // requests under way, more than MEM_PENDING

    reg clk = 1'b0;
    reg rst = 1'b1;
    reg cfg_valid = 1'b0;
    reg [6:0] cfg_addr = 7'd0;
    reg [31:0] cfg_data = 32'd0;
    reg start = 1'b0;
    reg keep = 1'b0;
    reg req_ready = 1'b0;
    reg rsp_valid = 1'b0;
    reg rsp_error = 1'b0;
    reg [4:0] rsp_tag = 5'd0;
    reg [MEM_DATA-1:0] rsp_data = {MEM_DATA{1'b0}};
    reg pix_ready = 1'b0;
    reg [4:0] count_addr = 5'd0;
    wire busy;
    wire req_valid;
    wire [25:0] req_line;
    wire [4:0] req_tag;
    wire rsp_ready;
    wire pix_valid;
    wire [13:0] pix_x;
    wire [13:0] pix_y;
    wire [71:0] pix_colour;
    wire [23:0] pix_id;
    wire [W+WD+1:0] pix_key;
    wire [23:0] pix_visits;
    wire [31:0] pix_texture;
    wire [23:0] pix_frame;
    wire [47:0] count_data;
    wire [`RT_ERRORS-1:0] errors;
    wire active;
    reg gated = 1'b0, asked;   // the core's clock stands still while it does not ask for it
    always @* if (!clk) asked = !gated || active;
    wire core_clk = clk && asked;

    rt_core #(
        `include "rt_core_pass.vh"
    ) u_core (
        .clk(core_clk), .rst(rst),
        .cfg_valid_i(cfg_valid), .cfg_addr_i(cfg_addr), .cfg_data_i(cfg_data),
        .start_i(start), .keep_cache_i(keep), .busy_o(busy), .active_o(active),
        .mem_req_valid_o(req_valid), .mem_req_ready_i(req_ready), .mem_req_line_o(req_line),
        .mem_req_tag_o(req_tag), .mem_rsp_valid_i(rsp_valid), .mem_rsp_ready_o(rsp_ready),
        .mem_rsp_tag_i(rsp_tag), .mem_rsp_data_i(rsp_data), .mem_rsp_error_i(rsp_error),
        .pix_valid_o(pix_valid), .pix_ready_i(pix_ready), .pix_x_o(pix_x), .pix_y_o(pix_y),
        .pix_colour_o(pix_colour), .pix_id_o(pix_id), .pix_key_o(pix_key),
        .pix_visits_o(pix_visits), .pix_texture_o(pix_texture), .pix_frame_o(pix_frame),
        .count_addr_i(count_addr), .count_data_o(count_data), .errors_o(errors)
    );

    reg driven = 1'b0;         // by text, clock by clock: icarus_pins.vh
    always #5 if (!driven) clk = !clk;

    // ---- plusargs ----
    reg [8*1024-1:0] name;
    reg [31:0] regs [0:N_REGS-1];
    reg [255:0] mem [0:LINES-1];
    integer pins, out, latency, stall, seed, watchdog, error_at, warm, reset_at, reset_for, spoil;
    initial begin
        if (!$value$plusargs("latency=%d", latency)) latency = 20;
        if (!$value$plusargs("stall=%d", stall)) stall = 0;
        if (!$value$plusargs("seed=%d", seed)) seed = 1;
        if (!$value$plusargs("watchdog=%d", watchdog)) watchdog = 200000;
        if (!$value$plusargs("error_at=%d", error_at)) error_at = -1;
        if (!$value$plusargs("warm=%d", warm)) warm = 0;
        if (!$value$plusargs("gated=%d", gated)) gated = 1'b0;
        if (!$value$plusargs("spoil=%d", spoil)) spoil = -1;
        if (!$value$plusargs("reset_at=%d", reset_at)) reset_at = -1;
        if (!$value$plusargs("reset_for=%d", reset_for)) reset_for = 1;
        if ($value$plusargs("dump=%s", name)) begin
            $dumpfile(name);
            $dumpvars(0, tb_core_icarus);
        end
        if (!$value$plusargs("out=%s", name)) name = "pixels.txt";
        out = $fopen(name, "w");
        if ($value$plusargs("pins=%s", name)) begin
            driven = 1'b1;
            pins = $fopen(name, "r");
        end else begin         // what Icarus cannot read it leaves unknown, and goes on
            if ($value$plusargs("regs=%s", name)) $readmemh(name, regs);
            if (^regs[N_REGS-1] === 1'bx) $fwrite(out, "n no registers from %0s\n", name);
            if ($value$plusargs("mem=%s", name)) $readmemh(name, mem);
            if (^mem[0] === 1'bx) $fwrite(out, "n no memory from %0s\n", name);
            if (^regs[N_REGS-1] === 1'bx || ^mem[0] === 1'bx) $finish;
        end
    end
`include "icarus_pins.vh"

    // ---- memory: `latency` clocks late; data even with an error. With stalls, random waits, and
    // beats of any tag: of its first line, if that is due ----
    reg [25:0] q_line [0:QUEUE-1];
    reg [4:0] q_tag [0:QUEUE-1];
    integer q_due [0:QUEUE-1];
    reg q_error [0:QUEUE-1];
    integer q_beat [0:QUEUE-1];          // beats that came of it
    integer size, at, tag, cycle, requests, quiet;
    reg offered;
    reg cut = 1'b0;            // this frame is going to be cut off
    reg spoilt = 1'b0;         // lines from `spoil` on answer with an error
    time begun, last;          // start was taken, the last pixel was given
    reg [255:0] line;
    initial begin
        size = 0; at = 0; cycle = 0; requests = 0; quiet = 0; offered = 1'b0;
    end

    always @(posedge clk) if (!driven) begin
        // what happened in this clock
        if (rsp_valid && rsp_ready) begin
            offered = 1'b0;
            q_beat[at] = q_beat[at] + 1;
            if (q_beat[at] == 256 / MEM_DATA) begin
                size = size - 1;
                for (at = at; at < size; at = at + 1) begin
                    q_line[at] = q_line[at+1];
                    q_tag[at] = q_tag[at+1];
                    q_due[at] = q_due[at+1];
                    q_error[at] = q_error[at+1];
                    q_beat[at] = q_beat[at+1];
                end
            end
            quiet = 0;
        end
        if (!rst && req_valid && req_ready) begin
            q_line[size] = req_line;
            q_tag[size] = req_tag;
            q_due[size] = cycle + latency;
            if ({$random(seed)} % 100 < stall)
                q_due[size] = q_due[size] + {$random(seed)} % (2 * latency + 16);
            q_error[size] = requests == error_at || req_line >= regs[`RT_REG_MEM_LINES] ||
                            (spoilt && req_line >= spoil);
            q_beat[size] = 0;
            if (req_line >= regs[`RT_REG_MEM_LINES])
                $fwrite(out, "h request for line %0d\n", req_line);
            requests = requests + 1;
            size = size + 1;
        end
        quiet = quiet + 1;
        if (!rst && pix_valid && pix_ready && !cut) begin
            $fwrite(out, "p %h %h %h %h %h %h %h %h\n", pix_x, pix_y, pix_colour, pix_id,
                    pix_key, pix_visits, pix_texture, ($time - begun) / 10);
            $fflush(out); // who reads may want no more of it
            quiet = 0;
            last = $time;
        end
        if (rst) begin         // memory is reset with the core
            size = 0;
            offered = 1'b0;
        end
        // what the next clock shows
        cycle = cycle + 1;
        if (!offered && size != 0) begin
            at = 0;
            if ({$random(seed)} % 100 < stall) begin
                tag = q_tag[{$random(seed)} % size];
                while (q_tag[at] != tag) at = at + 1;
            end
            if (q_due[at] <= cycle && {$random(seed)} % 100 >= stall) begin
                offered = 1'b1;
                line = mem[q_line[at]];
                rsp_tag <= q_tag[at];
                rsp_data <= line[MEM_DATA*q_beat[at] +: MEM_DATA];
                rsp_error <= q_error[at];
            end
        end
        rsp_valid <= offered;
        req_ready <= {$random(seed)} % 100 >= stall;
        pix_ready <= {$random(seed)} % 100 >= stall;
    end

    // ---- registers, passes, counters ----
    integer i, noise, work;
    reg [47:0] worked [0:2];         // counters of work, one a clock: does the core go on?
    wire [4:0] working = work == 0 ? `RT_COUNT_NODE_VISITS :
                         work == 1 ? `RT_COUNT_LEAF_TESTS : `RT_COUNT_FACET_TESTS;
    task show(input [4:0] number);   // a clock later it is there
        begin
            count_addr <= number;
            @(posedge clk);
            #1 $fwrite(out, "c %h %h\n", number, count_data);
        end
    endtask
    task pass(input keep_cache);
        begin
            keep <= keep_cache;
            start <= 1'b1;
            quiet = 0;
            work = 0;
            @(posedge clk);
            begun = $time;
            last = $time;
            start <= 1'b0;
            #1;
            while (busy && quiet < watchdog) begin
                if (stall != 0) begin  // what a busy core must ignore
                    start <= {$random(noise)} % 20 == 0;
                    cfg_valid <= {$random(noise)} % 5 == 0;
                    cfg_addr <= $random(noise);
                    cfg_data <= $random(noise);
                end
                count_addr <= working;
                @(posedge clk);
                #1 if (count_data !== worked[work]) quiet = 0;
                worked[work] = count_data;
                work = (work + 1) % 3;
            end
            start <= 1'b0;
            cfg_valid <= 1'b0;
            if (busy) $fwrite(out, "g no progress for %0d clocks: ", quiet,
                              "mem_req valid %b line %0d, ", req_valid, req_line,
                              "mem_rsp valid %b ready %b, memory owes %0d lines, pix valid %b\n",
                              rsp_valid, rsp_ready, size, pix_valid);
            show(`RT_COUNT_CYCLES);    // at once: the last one to be complete
            $fwrite(out, "k %h\n", (last - begun) / 10);
            for (i = 0; i < `RT_COUNTERS; i = i + 1) show(i);
            $fwrite(out, "e %h\n", errors);
            @(posedge clk);
        end
    endtask

    initial begin
        noise = seed + 1;
        @(posedge clk) wait (!driven);
        repeat (3) @(posedge clk);
        rst <= 1'b0;
        for (i = 0; i < N_REGS; i = i + 1) begin
            cfg_valid <= 1'b1;
            cfg_addr <= i;
            cfg_data <= regs[i];
            @(posedge clk);
        end
        cfg_valid <= 1'b0;
        @(posedge clk);
        if (reset_at >= 0) begin
            cut = 1'b1;
            start <= 1'b1;
            @(posedge clk);
            start <= 1'b0;
            repeat (reset_at) @(posedge clk);
            rst <= 1'b1;
            repeat (reset_for) @(posedge clk);
            rst <= 1'b0;
            cut = 1'b0;
        end
        spoilt = spoil >= 0 && warm == 0;
        pass(1'b0);
        if (warm != 0) begin
            spoilt = spoil >= 0;
            $fwrite(out, "w\n");
            pass(1'b1);
        end
        $fwrite(out, "end\n");
        $fclose(out);
        $finish;
    end
endmodule

`default_nettype wire
