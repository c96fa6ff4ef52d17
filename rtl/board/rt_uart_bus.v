// rt_uart_bus.v - a serial line reads and writes registers, and writes memory
// SPDX-License-Identifier: Apache-2.0
//   'W', address, count, count words, check --> 'K', or 'E' if a bus said no
//   'R', address, check                     --> 'K' and a word, or 'E'
//   anything else, then silence             --> 'N': nothing was done, send it again
// Addresses and words have four bytes, the low one first; the sum of all bytes, check included, is
// 0 modulo 256. Addresses from 2^31 on are registers. Words wait in a RAM until the check is right:
// a packet is written as it was sent or not at all, up to the word that a bus refuses. A packet
// that is none, or stops, is over when the line was silent for 2^IDLE clocks, since what follows a
// wrong bit may have any length. The sender waits for an answer before it sends.
`timescale 1ns / 1ps
`default_nettype none
module rt_uart_bus #(
    parameter DIV  = 25,                  // clocks a bit of the line
    parameter IDLE = 20                   // log2 of the clocks after which a packet is over
) (
    input  wire        clk,
    input  wire        rst,
    input  wire        rx_i,
    output wire        tx_o,
    // registers: AXI4-Lite, 32 bits
    output reg         r_awvalid,
    input  wire        r_awready,
    output reg         r_wvalid,
    input  wire        r_wready,
    input  wire        r_bvalid,
    input  wire [1:0]  r_bresp,
    output reg         r_arvalid,
    input  wire        r_arready,
    input  wire        r_rvalid,
    input  wire [31:0] r_rdata,
    input  wire [1:0]  r_rresp,
    // memory: AXI4 writes of one beat of 64 bits, of which strobes choose a half
    output reg         m_awvalid,
    input  wire        m_awready,
    output reg         m_wvalid,
    input  wire        m_wready,
    output wire [7:0]  m_wstrb,
    input  wire        m_bvalid,
    input  wire [1:0]  m_bresp,
    // of both
    output reg  [31:0] address_o,
    output reg  [31:0] data_o             // for memory in both halves
);
    // ---- bytes ----
    wire       get, put_ready;
    wire [7:0] byte_in;
    reg        put_q;
    reg  [7:0] put_byte_q;
    rt_uart #(.DIV(DIV)) u_uart (
        .clk(clk), .rst(rst), .rx_i(rx_i), .tx_o(tx_o), .get_valid_o(get), .get_data_o(byte_in),
        .put_valid_i(put_q), .put_ready_o(put_ready), .put_data_i(put_byte_q)
    );

    // ---- a packet: operation, address, count, words, check ----
    localparam [2:0] OPERATION = 3'd0, ADDRESS = 3'd1, COUNT = 3'd2, WORD = 3'd3, CHECK = 3'd4,
                     BUS = 3'd5, ANSWER = 3'd6, LOST = 3'd7;
    reg  [2:0]  state_q;
    reg         write_q, bad_q;
    reg  [1:0]  at_q;                     // byte of a word
    reg  [7:0]  count_q;                  // words of the packet
    reg  [7:0]  index_q;                  // of the word that comes, or goes to a bus
    reg  [7:0]  sum_q;
    reg  [31:0] next_q;                   // where the next word goes
    reg  [IDLE:0] idle_q;
    reg         owed_q;                   // an answer of a bus
    wire [7:0]  sum = sum_q + byte_in;
    wire        stale = idle_q[IDLE];
    wire        busy  = r_awvalid || r_wvalid || r_arvalid || m_awvalid || m_wvalid || owed_q;
    wire        answer = r_bvalid || r_rvalid || m_bvalid;
    wire        refuse = (r_bvalid && r_bresp[1]) || (r_rvalid && r_rresp[1]) ||
                         (m_bvalid && m_bresp[1]);
    reg  [23:0] word_q;                   // bytes of a word that came
    wire [31:0] word = {byte_in, word_q};
    wire [31:0] held;                     // the word at index_q
    reg  [39:0] answer_q;                 // the lowest byte goes first
    reg  [2:0]  bytes_q;                  // of the answer
    wire        more = state_q == WORD && get && at_q == 2'd3;
    wire        go   = state_q == BUS && !busy && !bad_q && index_q != count_q;
    wire        last = index_q + 8'd1 == count_q;
    assign m_wstrb = address_o[2] ? 8'hf0 : 8'h0f;
    rt_slot_ram #(.WIDTH(32), .SLOTS(256), .OLD(0)) u_words (
        .clk(clk), .wr_en_i(more), .wr_addr_i(index_q), .wr_data_i(word),
        .rd_en_i(state_q == CHECK || state_q == BUS), .rd_addr_i(index_q), .rd_data_o(held)
    );

    always @(posedge clk) begin
        if (get) begin
            sum_q  <= state_q == OPERATION ? byte_in : sum;
            word_q <= word[31:8];
            at_q   <= state_q == OPERATION ? 2'd0 : at_q + 2'd1;
        end
        idle_q <= get || stale || state_q == OPERATION || state_q == BUS || state_q == ANSWER
                  ? {(IDLE+1){1'b0}} : idle_q + 1'b1;
        case (state_q)
            OPERATION: if (get) begin
                write_q <= byte_in == "W";
                bad_q   <= 1'b0;
                index_q <= 8'd0;
                count_q <= 8'd1;
                state_q <= byte_in == "W" || byte_in == "R" ? ADDRESS : LOST;
            end
            ADDRESS: if (get && at_q == 2'd3) begin
                next_q  <= word;
                state_q <= write_q ? COUNT : CHECK;
            end
            COUNT: if (get) begin
                count_q <= byte_in;
                at_q    <= 2'd0;
                state_q <= byte_in == 8'd0 ? LOST : WORD;
            end
            WORD: if (more) begin
                index_q <= last ? 8'd0 : index_q + 8'd1;
                if (last) state_q <= CHECK;
            end
            CHECK: if (get) state_q <= sum == 8'd0 ? BUS : LOST;
            BUS: if (!busy && !go) begin
                answer_q[7:0] <= bad_q ? "E" : "K";
                bytes_q       <= write_q || bad_q ? 3'd1 : 3'd5;
                state_q       <= ANSWER;
            end
            ANSWER: if (put_ready && !put_q) begin
                put_q      <= bytes_q != 3'd0;
                put_byte_q <= answer_q[7:0];
                answer_q   <= answer_q >> 8;
                bytes_q    <= bytes_q - 3'd1;
                if (bytes_q == 3'd0) state_q <= OPERATION;
            end
            default: ;                    // LOST
        endcase
        if (put_q && put_ready) put_q <= 1'b0;
        if (stale) begin
            answer_q[7:0] <= "N";
            bytes_q       <= 3'd1;
            state_q       <= ANSWER;
        end

        // ---- buses: one word at a time ----
        if (r_awready) r_awvalid <= 1'b0;
        if (r_wready)  r_wvalid  <= 1'b0;
        if (m_awready) m_awvalid <= 1'b0;
        if (m_wready)  m_wvalid  <= 1'b0;
        if (r_arready) r_arvalid <= 1'b0;
        if (answer) owed_q <= 1'b0;
        if (refuse) bad_q  <= 1'b1;
        if (r_rvalid) answer_q[39:8] <= r_rdata;
        if (go) begin
            r_awvalid <= write_q && next_q[31];
            r_wvalid  <= write_q && next_q[31];
            m_awvalid <= write_q && !next_q[31];
            m_wvalid  <= write_q && !next_q[31];
            r_arvalid <= !write_q;
            owed_q    <= 1'b1;
            address_o <= next_q;
            data_o    <= held;
            next_q    <= next_q + 32'd4;
            index_q   <= index_q + 8'd1;
        end
        if (rst) begin
            state_q   <= OPERATION;
            put_q     <= 1'b0;
            owed_q    <= 1'b0;
            r_awvalid <= 1'b0;
            r_wvalid  <= 1'b0;
            r_arvalid <= 1'b0;
            m_awvalid <= 1'b0;
            m_wvalid  <= 1'b0;
        end
    end
    wire unused = &{1'b0, r_bresp[0], r_rresp[0], m_bresp[0]};
endmodule
`default_nettype wire
