// axi_rules.vh - rules of AXI4, AXI4-Lite and AXI4-Stream, the same in proofs and in simulations
// SPDX-License-Identifier: Apache-2.0
// What a master or a slave of this project must keep, clock by clock, whatever the other side does.
// A proof has them beside its module; a bench binds them to every instance of it (tb/*/*_rules.sv),
// where the first one that is broken ends it. anew: the bus is reset, so nothing waits any more; a
// STOP is no such thing.
`timescale 1ns / 1ps
`ifdef VERILATOR
import "DPI-C" function void axi_rule_broken(input string what);    // of tb/bench.h
`define RULES always @(posedge clk)
`define RULE(holds, text) if ((holds) !== 1'b1) axi_rule_broken({`"text`", $sformatf(": %m")})
`else
`define RULES always @*
`define RULE(holds, text) assert (holds)
`endif

// Addresses and beats of a reader.
module axi_read_rules #(
    parameter DATA = 64,                // bits of a beat
    parameter ADDR = 32,
    parameter ID   = 5,                 // bits of an ID
    parameter MOST = 16                 // beats of a burst at most
) (
    input wire            clk,
    input wire            rst,
    input wire            anew,
    input wire            arvalid,
    input wire            arready,
    input wire [ID-1:0]   arid,
    input wire [ADDR-1:0] araddr,
    input wire [7:0]      arlen
);
    localparam [31:0] BYTES_W = DATA / 8;
    localparam [12:0] BYTES = BYTES_W[12:0];
    reg                  wait_q = 1'b0;
    reg  [ID+ADDR+7:0]   request_q;
    wire [12:0]          end_at = {1'b0, araddr[11:0]} + ({5'd0, arlen} + 13'd1) * BYTES;
    always @(posedge clk) begin
        wait_q    <= arvalid && !arready && !rst && !anew;
        request_q <= {arid, araddr, arlen};
    end
    `RULES if (!rst) begin
        if (wait_q)
            `RULE(arvalid && {arid, araddr, arlen} == request_q, an address waits unchanged);
        if (arvalid) begin
            `RULE(end_at <= 13'd4096, a burst stays within 4 KiB);
            `RULE((araddr[12:0] & (BYTES - 13'd1)) == 13'd0, a burst is aligned to its beats);
            `RULE({24'd0, arlen} < MOST, a burst is no longer than it may be);
        end
    end
endmodule

// Addresses, beats and answers of a writer that sends a burst at a time, address and data at once.
module axi_write_rules #(
    parameter DATA = 64,
    parameter ADDR = 32
) (
    input wire            clk,
    input wire            rst,
    input wire            anew,
    input wire            awvalid,
    input wire            awready,
    input wire [ADDR-1:0] awaddr,
    input wire [7:0]      awlen,
    input wire            wvalid,
    input wire            wready,
    input wire [DATA-1:0] wdata,
    input wire [DATA/8-1:0] wstrb,
    input wire            wlast,
    input wire            bvalid,
    input wire            bready
);
    localparam [31:0] BYTES_W = DATA / 8;
    localparam [12:0] BYTES = BYTES_W[12:0];
    reg                  aw_wait_q = 1'b0, w_wait_q = 1'b0;
    reg  [ADDR+7:0]      address_q;
    reg  [DATA+DATA/8:0] beat_q;
    reg  [7:0]           beats_q;        // of the burst, that the bus took
    wire [12:0]          end_at = {1'b0, awaddr[11:0]} + ({5'd0, awlen} + 13'd1) * BYTES;
    always @(posedge clk) begin
        aw_wait_q <= awvalid && !awready && !rst && !anew;
        w_wait_q  <= wvalid && !wready && !rst && !anew;
        address_q <= {awaddr, awlen};
        beat_q    <= {wdata, wstrb, wlast};
        if (wvalid && wready) beats_q <= wlast ? 8'd0 : beats_q + 8'd1;
        if (rst || anew) beats_q <= 8'd0;
    end
    `RULES if (!rst) begin
        if (aw_wait_q) `RULE(awvalid && {awaddr, awlen} == address_q, an address waits unchanged);
        if (w_wait_q) `RULE(wvalid && {wdata, wstrb, wlast} == beat_q, a beat waits unchanged);
        if (wvalid) `RULE(wlast == (beats_q == awlen), beats are as many as AWLEN says);
        if (awvalid) begin
            `RULE(end_at <= 13'd4096, a burst stays within 4 KiB);
            `RULE((awaddr[12:0] & (BYTES - 13'd1)) == 13'd0, a burst is aligned to its beats);
        end
        if (bvalid) `RULE(bready, an answer never waits);
    end
endmodule

// Answers of a slave of AXI4-Lite, which takes a write and a read at a time.
module axi_lite_rules (
    input wire        clk,
    input wire        rst,
    input wire        awvalid,
    input wire        awready,
    input wire        wvalid,
    input wire        wready,
    input wire        bvalid,
    input wire        bready,
    input wire [1:0]  bresp,
    input wire        arvalid,
    input wire        arready,
    input wire        rvalid,
    input wire        rready,
    input wire [31:0] rdata,
    input wire [1:0]  rresp
);
    reg        b_wait_q = 1'b0, r_wait_q = 1'b0;
    reg        aw_q, w_q, ar_q;          // taken, and not answered
    reg [1:0]  bresp_q;
    reg [33:0] read_q;
    always @(posedge clk) begin
        b_wait_q <= bvalid && !bready && !rst;
        r_wait_q <= rvalid && !rready && !rst;
        bresp_q  <= bresp;
        read_q   <= {rresp, rdata};
        aw_q     <= !rst && ((awvalid && awready) || (aw_q && !(bvalid && !b_wait_q)));
        w_q      <= !rst && ((wvalid && wready) || (w_q && !(bvalid && !b_wait_q)));
        ar_q     <= !rst && ((arvalid && arready) || (ar_q && !(rvalid && !r_wait_q)));
    end
    `RULES if (!rst) begin
        if (b_wait_q) `RULE(bvalid && bresp == bresp_q, an answer to a write waits unchanged);
        if (r_wait_q)
            `RULE(rvalid && {rresp, rdata} == read_q, an answer to a read waits unchanged);
        if (bvalid && !b_wait_q) `RULE(aw_q && w_q, an answer has an address and data);
        if (rvalid && !r_wait_q) `RULE(ar_q, an answer has an address);
        if (bvalid) `RULE(!bresp[0], OKAY or SLVERR);
        if (rvalid) `RULE(!rresp[0], OKAY or SLVERR);
    end
endmodule

// Video of AXI4-Stream.
module axi_stream_rules (
    input wire        clk,
    input wire        rst,
    input wire        tvalid,
    input wire        tready,
    input wire [23:0] tdata,
    input wire        tuser,
    input wire        tlast
);
    reg        wait_q = 1'b0;
    reg [25:0] pixel_q;
    always @(posedge clk) begin
        wait_q  <= tvalid && !tready && !rst;
        pixel_q <= {tdata, tuser, tlast};
    end
    `RULES if (!rst && wait_q)
        `RULE(tvalid && {tdata, tuser, tlast} == pixel_q, a pixel waits unchanged);
endmodule
