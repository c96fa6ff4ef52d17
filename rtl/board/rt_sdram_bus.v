// rt_sdram_bus.v - AXI4 ports of readers and writers at one SDRAM, which has a clock of its own
// SPDX-License-Identifier: Apache-2.0
//   rt_word_reads, rt_word_writes --> [choice] --> queue --> rt_sdram --> queue --> the reader
// Port 0 of the readers, a display, comes first; then writers, then the other readers, the lower
// number first: a word a clock, whole bursts of nobody. So a word of the display waits for QUEUE
// others at most. Commands cross in one queue and in one order: what was written before an answer B
// is seen by every read after it. Ports are packed, port i in field i.
`timescale 1ns / 1ps
`default_nettype none
module rt_sdram_bus #(
    parameter READS   = 3,                // readers, 2..4
    parameter WRITES  = 2,                // writers, 1..4
    parameter DEPTH   = 32,               // words on their way of a reader, a power of two
    parameter QUEUE   = 8,                // words that wait for memory, a power of two above 3
    parameter POWER   = 12500             // of rt_sdram
) (
    input  wire                 clk,
    input  wire                 rst,
    // readers
    input  wire [READS-1:0]     s_arvalid,
    output wire [READS-1:0]     s_arready,
    input  wire [32*READS-1:0]  s_araddr,
    input  wire [8*READS-1:0]   s_arlen,
    output wire [READS-1:0]     s_rvalid,
    input  wire [READS-1:0]     s_rready,
    output wire [64*READS-1:0]  s_rdata,
    output wire [READS-1:0]     s_rlast,
    // writers
    input  wire [WRITES-1:0]    s_awvalid,
    output wire [WRITES-1:0]    s_awready,
    input  wire [32*WRITES-1:0] s_awaddr,
    input  wire [WRITES-1:0]    s_wvalid,
    output wire [WRITES-1:0]    s_wready,
    input  wire [64*WRITES-1:0] s_wdata,
    input  wire [8*WRITES-1:0]  s_wstrb,
    input  wire [WRITES-1:0]    s_wlast,
    output wire [WRITES-1:0]    s_bvalid,
    input  wire [WRITES-1:0]    s_bready,
    // memory
    input  wire                 mem_clk,
    input  wire                 mem_rst,
    output wire                 cke_o,
    output wire [3:0]           command_o,        // cs_n, ras_n, cas_n, we_n
    output wire [1:0]           ba_o,
    output wire [12:0]          a_o,
    output wire [1:0]           dqm_o,
    output wire [15:0]          dq_o,
    output wire                 dq_oe_o,
    input  wire [15:0]          dq_i              // a clock after rt_sdram's
);
    localparam ALL = READS + WRITES;
    localparam RB  = 2;                           // bits of a reader's number
    localparam CMD = 1 + 1 + RB + 22 + 64 + 8;    // write, last, reader, address, data, strobes
    wire clk_rst, mem_rst_s;
    rt_reset_pair u_resets (
        .a_clk(clk), .a_rst(rst), .a_rst_o(clk_rst),
        .b_clk(mem_clk), .b_rst(mem_rst), .b_rst_o(mem_rst_s)
    );

    // ---- ports: in the order of their rank ----
    wire [ALL-1:0]     valid, ready;
    wire [CMD*ALL-1:0] cmd;
    wire               rsp_valid, rsp_last;
    wire [RB-1:0]      rsp_reader;
    wire [63:0]        rsp_data;
    genvar i;
    generate
        for (i = 0; i < READS; i = i + 1) begin : g_read
            localparam [31:0] AT = i == 0 ? 0 : WRITES + i, ME = i;
            wire        last;
            wire [21:0] addr;
            rt_word_reads #(.DEPTH(DEPTH)) u_reads (
                .clk(clk), .rst(clk_rst), .s_arvalid(s_arvalid[i]), .s_arready(s_arready[i]),
                .s_araddr(s_araddr[32*i +: 32]), .s_arlen(s_arlen[8*i +: 8]),
                .s_rvalid(s_rvalid[i]), .s_rready(s_rready[i]), .s_rdata(s_rdata[64*i +: 64]),
                .s_rlast(s_rlast[i]), .cmd_valid_o(valid[AT]), .cmd_ready_i(ready[AT]),
                .cmd_addr_o(addr), .cmd_last_o(last),
                .rsp_valid_i(rsp_valid && rsp_reader == ME[RB-1:0]), .rsp_last_i(rsp_last),
                .rsp_data_i(rsp_data)
            );
            assign cmd[CMD*AT +: CMD] = {1'b0, last, ME[RB-1:0], addr, 64'd0, 8'd0};
            wire unused = &{1'b0, ME};
        end
        for (i = 0; i < WRITES; i = i + 1) begin : g_write
            wire [21:0] addr;
            rt_word_writes u_writes (
                .clk(clk), .rst(clk_rst), .s_awvalid(s_awvalid[i]), .s_awready(s_awready[i]),
                .s_awaddr(s_awaddr[32*i +: 32]), .s_wvalid(s_wvalid[i]), .s_wready(s_wready[i]),
                .s_wlast(s_wlast[i]), .s_bvalid(s_bvalid[i]), .s_bready(s_bready[i]),
                .cmd_valid_o(valid[1+i]), .cmd_ready_i(ready[1+i]), .cmd_addr_o(addr)
            );
            assign cmd[CMD*(1+i) +: CMD] = {1'b1, 1'b0, {RB{1'b0}}, addr, s_wdata[64*i +: 64],
                                            s_wstrb[8*i +: 8]};
        end
    endgenerate

    // ---- choice ----
    wire [ALL-1:0] first = valid & (~valid + 1'b1);
    wire           put_ready;
    reg  [CMD-1:0] put;
    integer        k;
    assign ready = first & {ALL{put_ready}};
    always @* begin
        put = {CMD{1'b0}};
        for (k = 0; k < ALL; k = k + 1) put = put | (cmd[CMD*k +: CMD] & {CMD{first[k]}});
    end

    // ---- to memory and back ----
    wire           go, go_ready, write, last, back, tag_room, tag_there, back_room;
    wire [RB-1:0]  reader;
    wire [RB:0]    tag;
    wire [21:0]    addr;
    wire [63:0]    data, back_data;
    wire [7:0]     strobe;
    wire [$clog2(QUEUE):0] no_count;
    wire [7:0]     no_back_count;
    rt_async_fifo #(.WIDTH(CMD), .DEPTH(QUEUE)) u_commands (
        .wr_clk(clk), .wr_rst(clk_rst), .wr_valid_i(|valid), .wr_ready_o(put_ready),
        .wr_data_i(put), .wr_count_o(no_count), .rd_clk(mem_clk), .rd_rst(mem_rst_s),
        .rd_valid_o(go), .rd_ready_i(go_ready),
        .rd_data_o({write, last, reader, addr, data, strobe})
    );
    rt_sdram #(.POWER(POWER), .INPUT(1)) u_sdram (
        .clk(mem_clk), .rst(mem_rst_s), .cmd_valid_i(go), .cmd_ready_o(go_ready),
        .cmd_write_i(write), .cmd_addr_i(addr), .cmd_data_i(data), .cmd_strb_i(strobe),
        .rsp_valid_o(back), .rsp_data_o(back_data), .cke_o(cke_o), .command_o(command_o),
        .ba_o(ba_o), .a_o(a_o), .dqm_o(dqm_o), .dq_o(dq_o), .dq_oe_o(dq_oe_o), .dq_i(dq_i)
    );
    // whose reads are on their way, three at most; room for all that readers may ask for
    rt_fifo #(.WIDTH(RB + 1), .DEPTH(8)) u_tags (
        .clk(mem_clk), .rst(mem_rst_s), .in_valid_i(go && go_ready && !write),
        .in_ready_o(tag_room), .in_data_i({last, reader}), .out_valid_o(tag_there),
        .out_ready_i(back), .out_data_o(tag)
    );
    rt_async_fifo #(.WIDTH(RB + 65), .DEPTH(128)) u_answers (
        .wr_clk(mem_clk), .wr_rst(mem_rst_s), .wr_valid_i(back), .wr_ready_o(back_room),
        .wr_data_i({tag, back_data}), .wr_count_o(no_back_count), .rd_clk(clk), .rd_rst(clk_rst),
        .rd_valid_o(rsp_valid), .rd_ready_i(1'b1), .rd_data_o({rsp_last, rsp_reader, rsp_data})
    );
    wire unused = &{1'b0, no_count, no_back_count, tag_room, tag_there, back_room};
endmodule
`default_nettype wire
