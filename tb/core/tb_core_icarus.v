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
    parameter W = 16,
    parameter WD = 17,
    parameter PQ = 17,
    parameter NG = 2,
    parameter FW = 14,
    parameter PR = 0,
    parameter LINES = 131072,  // of memory
    // parameters of machine.def
    parameter SHADOW     = 1,    // 0 or 1: rays towards the lights
    parameter REFLECT    = 5,    // 0..10: mirror rays, up to MAX_DEPTH
    parameter LIGHTS     = 8,    // 0..8: point lights
    parameter INSIDE     = 1,    // 0 or 1: rays may start inside a sphere, far roots count
    parameter FIRST      = 1,    // 0 or 1: primary rays end at the first visit that hits a leaf
    parameter INTERPENETRATE = 1, // 0 or 1: mends first hits that lie in another sphere
    parameter FACETS     = 1,    // 0 or 1: triangles and planes
    parameter TEXTURE    = 0,    // 0 or 1: images on surfaces
    parameter REFRACT    = 0,    // 0 or 1: refracted rays, mirror rays where all is reflected
    parameter SPECULAR   = 0,    // 0 or 1: highlights of materials with sum
    parameter SUM        = 0,    // 0 or 1: materials whose shares add up, colour on top of rays
    parameter SMOOTH     = 0,    // 0 or 1: interpolated normals of triangles
    parameter CLEAR      = 0,    // 0 or 1: shadow rays pass what is marked as clear
    parameter TURNED     = 0,    // 0 or 1: a grid in other axes than the camera's
    parameter SPREAD     = 0,    // 0 or 1: levels in mirrors and glass by how spheres spread rays
    parameter COARSE     = 0,    // 0..8: bits of the fraction of levels rounded away
    parameter RECT       = 1,    // 0 or 1: background separation by rectangle
    parameter SPANS      = 1,    // 0 or 1: background separation by spans in memory
    parameter CONES      = 1,    // 0..16: exact background separation, by so many spheres
    parameter ACCEL      = 0,    // 0 or 1: a BIH instead of nodes of four children
    parameter BOXES      = 0,    // 0 or 1: boxes around the children of a node, not spheres
    parameter ENGINES    = 1,    // 1..8: engines
    parameter PIPES      = 1,    // 1..4: traversal pipes an engine
    parameter EXACTS     = 0,    // 0..4: leaf units, 0: 1, for 3 and 4 pipes 2, with BOXES SHADES
    parameter SHADES     = 0,    // 0..4: shading units an engine, 0: 1, 2, 2, 4 by PIPES
    parameter SETUPS     = 0,    // 0..2: set-up units an engine, 0: 2 for 4 pipes, else 1
    parameter WALKS      = 0,    // 0..2: walks of the window, 0: 1, for several pipes 2
    parameter SLOTS      = 64,   // 4..1024, power of two: rays in flight a pipe
    parameter NODE_LINES = 256,  // 8..4096, power of two: node cache, lines; twice if PIPES > 1
    parameter LEAF_LINES = 128,  // 8..4096, power of two: leaf cache, lines; 4 times if PIPES > 1
    parameter TEXTURE_LINES = 128, // 8..4096, power of two: lines of a shading unit's texture cache
    parameter TEXTURE_WAYS = 4,  // 1..32, power of two: groups of a set of the texture cache
    parameter TEXTURE_GROUP = 1, // 1..4, power of two: lines of a group, fetched together
    parameter TEXTURE_COORDS = 2, // 1..8: units for texture coordinates an engine
    parameter ROOTS      = 0,    // 0..8: square root units a leaf unit, 0: 6, for 1 pipe 3
    parameter QUOTIENTS  = 2,    // 1..8: dividers an engine
    parameter DIVISIONS  = 0,    // 0..8: units for keys of facets a leaf unit, 0: 1, with BOXES 3
    parameter ROOT_STEP  = 2,    // 1..W+WD: root bits a clock
    parameter QUOTIENT_STEP = 2, // 1..PQ: quotient bits a clock
    parameter DIVISION_STEP = 2, // 1..W+WD: bits of a facet's key a clock
    parameter LEAF_INTERVAL = 2, // 2..4, power of two: clocks an exact test of a sphere
    parameter FACET_INTERVAL = 0, // 0..4, power of two: clocks a facet, 0: 2, wide without BOXES 4
    parameter UNITS      = 2,    // 1..2: units for unit vectors an engine
    parameter UNIT_INTERVAL = 2, // 2..4, power of two: clocks a vector of each
    parameter SQUARES    = 0,    // 0..2: squares of filters in LUTs: 1 no, 2 yes, 0: of 4 pipes
    parameter SPILLS     = 0,    // 0..2: odd bits of memories in LUTs: 1 no, 2 yes, 0: from 3 pipes
    parameter HIT_INTERVAL = 8,  // 8..12: clocks a hit point and its normal, 8 or 12
    parameter BOUNCE_INTERVAL = 10 // 10..12: clocks a mirrored direction, 10 or 12
    // end of parameters
);
    localparam N_REGS = `RT_N_REGS;
    localparam QUEUE = 1024;   // requests under way

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
    reg [63:0] rsp_data = 64'd0;
    reg pix_ready = 1'b0;
    reg [4:0] count_addr = 5'd0;
    wire busy;
    wire req_valid;
    wire [25:0] req_line;
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
    wire [5:0] errors;

    rt_core #(
        .W(W), .WD(WD), .PQ(PQ), .NG(NG), .FW(FW), .PR(PR),
        // connections of machine.def
        .SHADOW(SHADOW), .REFLECT(REFLECT), .LIGHTS(LIGHTS), .INSIDE(INSIDE),
        .FIRST(FIRST), .INTERPENETRATE(INTERPENETRATE), .FACETS(FACETS), .TEXTURE(TEXTURE),
        .REFRACT(REFRACT), .SPECULAR(SPECULAR), .SUM(SUM), .SMOOTH(SMOOTH), .CLEAR(CLEAR),
        .TURNED(TURNED), .SPREAD(SPREAD), .COARSE(COARSE), .RECT(RECT), .SPANS(SPANS),
        .CONES(CONES), .ACCEL(ACCEL), .BOXES(BOXES), .ENGINES(ENGINES), .PIPES(PIPES),
        .EXACTS(EXACTS), .SHADES(SHADES), .SETUPS(SETUPS), .WALKS(WALKS), .SLOTS(SLOTS),
        .NODE_LINES(NODE_LINES), .LEAF_LINES(LEAF_LINES), .TEXTURE_LINES(TEXTURE_LINES),
        .TEXTURE_WAYS(TEXTURE_WAYS), .TEXTURE_GROUP(TEXTURE_GROUP),
        .TEXTURE_COORDS(TEXTURE_COORDS), .ROOTS(ROOTS), .QUOTIENTS(QUOTIENTS),
        .DIVISIONS(DIVISIONS), .ROOT_STEP(ROOT_STEP), .QUOTIENT_STEP(QUOTIENT_STEP),
        .DIVISION_STEP(DIVISION_STEP), .LEAF_INTERVAL(LEAF_INTERVAL),
        .FACET_INTERVAL(FACET_INTERVAL), .UNITS(UNITS), .UNIT_INTERVAL(UNIT_INTERVAL),
        .SQUARES(SQUARES), .SPILLS(SPILLS), .HIT_INTERVAL(HIT_INTERVAL),
        .BOUNCE_INTERVAL(BOUNCE_INTERVAL)
        // end of connections
    ) u_core (
        .clk(clk), .rst(rst),
        .cfg_valid_i(cfg_valid), .cfg_addr_i(cfg_addr), .cfg_data_i(cfg_data),
        .start_i(start), .keep_cache_i(keep), .busy_o(busy),
        .mem_req_valid_o(req_valid), .mem_req_ready_i(req_ready), .mem_req_line_o(req_line),
        .mem_rsp_valid_i(rsp_valid), .mem_rsp_ready_o(rsp_ready), .mem_rsp_data_i(rsp_data),
        .mem_rsp_error_i(rsp_error),
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

    // ---- memory: in order, `latency` clocks late, random waits; data even with an error ----
    reg [25:0] q_line [0:QUEUE-1];
    integer q_due [0:QUEUE-1];
    reg q_error [0:QUEUE-1];
    integer head, tail, beat, cycle, requests, quiet;
    reg offered;
    reg cut = 1'b0;            // this frame is going to be cut off
    reg spoilt = 1'b0;         // lines from `spoil` on answer with an error
    time begun, last;          // start was taken, the last pixel was given
    reg [255:0] line;
    initial begin
        head = 0; tail = 0; beat = 0; cycle = 0; requests = 0; quiet = 0; offered = 1'b0;
    end

    always @(posedge clk) if (!driven) begin
        // what happened in this clock
        if (rsp_valid && rsp_ready) begin
            offered = 1'b0;
            beat = (beat + 1) % 4;
            if (beat == 0) head = (head + 1) % QUEUE;
            quiet = 0;
        end
        if (!rst && req_valid && req_ready) begin
            q_line[tail] = req_line;
            q_due[tail] = cycle + latency;
            if ({$random(seed)} % 100 < stall)
                q_due[tail] = q_due[tail] + {$random(seed)} % (2 * latency + 16);
            q_error[tail] = requests == error_at || req_line >= regs[`RT_REG_MEM_LINES] ||
                            (spoilt && req_line >= spoil);
            if (req_line >= regs[`RT_REG_MEM_LINES])
                $fwrite(out, "h request for line %0d\n", req_line);
            requests = requests + 1;
            tail = (tail + 1) % QUEUE;
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
            head = tail;
            beat = 0;
            offered = 1'b0;
        end
        // what the next clock shows
        cycle = cycle + 1;
        if (!offered && head != tail && q_due[head] <= cycle &&
                {$random(seed)} % 100 >= stall) begin
            offered = 1'b1;
            line = mem[q_line[head]];
            rsp_data <= line[64*beat +: 64];
            rsp_error <= q_error[head];
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
                              rsp_valid, rsp_ready, (tail - head + QUEUE) % QUEUE, pix_valid);
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
