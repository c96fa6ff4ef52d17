// s_build_sort.v - rt_build_sort for all keys of up to N spheres: their order, for both readers
// SPDX-License-Identifier: Apache-2.0
// Keys rise along the order, numbers among equal keys: so it is sorted and each number is in it
// once. The first reader waits between places; what it reads is copied for the second one.
`timescale 1ns / 1ps
`default_nettype none
module s_build_sort #(
    parameter N   = 3,
    parameter AB  = 2,
    parameter KEY = 4,
    parameter DB  = 2
);
    reg            clk = 1'b0, clear = 1'b1, key_valid = 1'b0, sort = 1'b0, a_en = 1'b0;
    reg            b_en = 1'b0;
    reg  [KEY*N:0] keys = 0;                 // of all spheres; the top bit: all were tried
    reg  [AB:0]    n = 1, at = 0;
    reg  [AB:0]    a_at = 0, b_at = 0;       // places that were read
    reg            a_came = 1'b0, b_came = 1'b0, reading = 1'b0;
    wire           ready, done;
    wire [AB-1:0]  a_id, b_id;
    reg  [AB-1:0]  a_last, b_last;
    rt_build_sort #(.AB(AB), .KEY(KEY), .DB(DB)) u_dut (
        .clk(clk), .rst(1'b0), .clear_i(clear), .ready_o(ready), .key_valid_i(key_valid),
        .key_i(keys[KEY*at[AB-1:0] +: KEY]), .sort_i(sort), .count_i(n), .done_o(done),
        .a_en_i(a_en), .a_copy_i(1'b1), .a_place_i(a_at[AB-1:0]), .a_id_o(a_id), .b_en_i(b_en),
        .b_place_i(b_at[AB-1:0]), .b_id_o(b_id), .link_i(1'b0), .link_from_i({AB{1'b0}}),
        .link_to_i({AB{1'b0}}), .put_i(1'b0), .put_place_i({AB{1'b0}}), .put_id_i({AB{1'b0}})
    );
    always #1 clk = !clk;
    function after;                          // a sphere behind another one
        input [AB-1:0] a;
        input [AB-1:0] b;
        after = a < n && (keys[KEY*b +: KEY] < keys[KEY*a +: KEY] ||
                          (keys[KEY*b +: KEY] == keys[KEY*a +: KEY] && b < a));
    endfunction
    task check;                              // the sphere of a place, and that of the place before
        input [AB:0]   place;
        input [AB-1:0] id;
        input [AB-1:0] last;
        if (!(id < n) || (place != 0 && !after(id, last))) begin
            $display("fails: %0d spheres, keys %h, place %0d: %0d", n, keys, place, id);
            $finish;
        end
    endtask
    always @(posedge clk) begin
        clear  <= 1'b0;
        sort   <= 1'b0;
        a_came <= a_en;
        b_came <= b_en;
        if (ready && !reading && !sort && at != n) key_valid <= 1'b1;
        if (key_valid) begin
            at <= at + 1'b1;
            if (at + 1'b1 == n) begin
                key_valid <= 1'b0;
                sort      <= 1'b1;
            end
        end
        if (done) begin
            reading <= 1'b1;
            a_at    <= 0;
            b_at    <= 0;
            a_en    <= 1'b1;
        end
        if (a_en) a_en <= 1'b0;
        if (a_came) begin
            check(a_at, a_id, a_last);
            a_last <= a_id;
            a_at   <= a_at + 1'b1;
            a_en   <= a_at + 1'b1 != n;
            b_en   <= a_at + 1'b1 == n;
        end
        if (b_en) b_en <= 1'b0;
        if (b_came) begin
            check(b_at, b_id, b_last);
            b_last <= b_id;
            b_at   <= b_at + 1'b1;
            b_en   <= b_at + 1'b1 != n;
            if (b_at + 1'b1 == n) begin
                reading <= 1'b0;
                at      <= 0;
                clear   <= 1'b1;
                keys    <= keys + 1'b1;
                if (keys + 1'b1 == 1 << KEY*n) begin
                    keys <= 0;
                    n    <= n + 1'b1;
                    if (n == N) begin
                        $display("proved");
                        $finish;
                    end
                end
            end
        end
    end
endmodule
`default_nettype wire
