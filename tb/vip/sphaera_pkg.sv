// sphaera_pkg.sv - the golden model in a bench of SystemVerilog: scoreboard of a core, single units
// SPDX-License-Identifier: Apache-2.0
//
// DPI-C onto libsphaera, nothing else: docs/reference/library.md. Names that begin with
// sphaera_ are functions of sphaera.h; structs of it are passed as arrays of their words.
`timescale 1ns / 1ps
package sphaera_pkg;
    localparam ERROR = 512;   // bytes of a sphaera_error
    import "DPI-C" function int sphaera_machine_read(input string path, output chandle machine,
                                                     output byte error[ERROR]);
    import "DPI-C" function void sphaera_machine_free(input chandle machine);
    import "DPI-C" function int sphaera_registers();
    import "DPI-C" function int sphaera_machine_register(input chandle machine, input int number);
    import "DPI-C" function int sphaera_machine_line(input chandle machine, input int unsigned line,
                                                     output int unsigned words[8]);
    import "DPI-C" function string sphaera_machine_core(input chandle machine);
    import "DPI-C" function int sphaera_scoreboard_new(input chandle machine, input int threads,
                                                       output chandle board,
                                                       output byte error[ERROR]);
    import "DPI-C" function void sphaera_scoreboard_free(input chandle board);
    import "DPI-C" function int sphaera_scoreboard_pixel(input chandle board, input int x,
        input int y, input int unsigned rendering, input int unsigned l1, input int unsigned l2,
        input int unsigned id, input longint unsigned key, input int unsigned visits,
        input int unsigned texture);
    import "DPI-C" function int sphaera_scoreboard_colour(input chandle board, input int x,
                                                          input int y, input int unsigned colour);
    import "DPI-C" function int sphaera_scoreboard_counter(input chandle board, input int number,
                                                           input longint unsigned value);
    import "DPI-C" function int sphaera_scoreboard_errors(input chandle board,
                                                          input int unsigned bits);
    import "DPI-C" function int sphaera_scoreboard_end(input chandle board);
    import "DPI-C" function string sphaera_scoreboard_text(input chandle board);
    import "DPI-C" function string sphaera_counter_name(input int number);
    import "DPI-C" function int sphaera_counter_exact(input int number);
    import "DPI-C" function int sphaera_model_unit_vector(input int bits, input longint v[3],
        output int u[3], output int unsigned scale, output int shift, output byte error[ERROR]);
    import "DPI-C" function int sphaera_model_root(input longint unsigned high,
        input longint unsigned low, input int bits, output longint unsigned root,
        output int inexact, output byte error[ERROR]);
    import "DPI-C" function int sphaera_model_quotient(input longint unsigned key,
        input int key_bits, input longint unsigned a, input int a_bits, input int pq,
        output int unsigned mant, output int exp, output byte error[ERROR]);
    import "DPI-C" function int sphaera_model_leaf(input longint leaf[13], output longint result[6],
                                                   output byte error[ERROR]);
    import "DPI-C" function int sphaera_model_filter(input int filter[16], output int pass,
                                                     output int near_depth,
                                                     output byte error[ERROR]);
    import "DPI-C" function int sphaera_model_texel(input int unsigned near_texels[4],
        input int unsigned far_texels[4], input int near_weights[2], input int far_weights[2],
        input int level, output int unsigned texel, output byte error[ERROR]);

    function automatic void stop(byte error[ERROR]);
        string text;
        for (int i = 0; i < ERROR && error[i] != 0; i++) text = $sformatf("%s%c", text, error[i]);
        $fatal(1, "sphaera: %s", text);
    endfunction

    // ---- a machine, and what a core makes of it ----
    // What the core gives is told as it comes, in any order; a function is 1 if the model has the
    // same. The first difference of a frame is printed with the stages of its pixel's rays.
    class golden;
        int differ;                  // of all frames that ended
        local chandle machine, board;
        local bit told;

        // Reads a machine file and draws it; stops the simulation if it is damaged.
        function new(string path);
            byte error[ERROR];
            if (sphaera_machine_read(path, machine, error) != 0) stop(error);
            if (sphaera_scoreboard_new(machine, 0, board, error) != 0) stop(error);
        endfunction

        // What the core is given: register 0 .. registers() - 1, line 0 .. MEM_LINES - 1.
        function int registers();
            return sphaera_registers();
        endfunction
        function bit [31:0] register(int number);
            return sphaera_machine_register(machine, number);
        endfunction
        function void line(int unsigned number, output bit [255:0] bits);
            int unsigned words[8];
            if (sphaera_machine_line(machine, number, words) != 0)
                $fatal(1, "sphaera: there is no line %0d", number);
            for (int i = 0; i < 8; i++) bits[32*i +: 32] = words[i];
        endfunction
        // Words for sim/cores.py: what the core must have.
        function string core();
            return sphaera_machine_core(machine);
        endfunction

        local function bit same(int differs);
            if (differs != 0 && !told) $display("%s", sphaera_scoreboard_text(board));
            if (differs != 0) told = 1;
            return differs == 0;
        endfunction

        // A pixel of the pixel port; colour: {L2, L1, Rendering}.
        function bit pixel(bit [13:0] x, bit [13:0] y, bit [71:0] colour, bit [23:0] id,
                           bit [63:0] key, bit [23:0] visits, bit [31:0] texture);
            return same(sphaera_scoreboard_pixel(board, 32'(x), 32'(y), 32'(colour[23:0]),
                                                 32'(colour[47:24]), 32'(colour[71:48]), 32'(id),
                                                 key, 32'(visits), texture));
        endfunction
        // The same of a frame in memory: 0xBBGGRR.
        function bit colour(int x, int y, bit [23:0] value);
            return same(sphaera_scoreboard_colour(board, x, y, 32'(value)));
        endfunction
        function bit counter(int number, bit [47:0] value);
            return same(sphaera_scoreboard_counter(board, number, 64'(value)));
        endfunction
        function bit errors(bit [31:0] bits);
            return same(sphaera_scoreboard_errors(board, bits));
        endfunction
        // The end of a frame; pixels that did not come are a difference. The next one may follow.
        function bit done();
            int n = sphaera_scoreboard_end(board);
            differ += n;
            if (n != 0) void'(same(n));
            told = 0;
            return n == 0;
        endfunction
        function void free();
            sphaera_scoreboard_free(board);
            sphaera_machine_free(machine);
        endfunction
    endclass

    // ---- single units ----
    // Operands and results of a unit as its ports have them, sign extended; 1 if the model gives
    // the same. The first difference is printed. Operands out of range stop the simulation.
    class units;
        int checks, differ;

        local function bit same(bit equal, string of, string got, string wanted);
            checks++;
            if (!equal && differ == 0) $display("%s: %s, expected %s", of, got, wanted);
            if (!equal) differ++;
            return equal;
        endfunction
        local function string show_vector(int u[3], int unsigned scale, int shift);
            return $sformatf("%0d,%0d,%0d scale %0d shift %0d", u[0], u[1], u[2], scale, shift);
        endfunction
        local function string show_leaf(bit hit, bit far_root, bit exit, bit [127:0] disc,
                                        longint b);
            return $sformatf("hit %b far %b exit %b disc %h b %0d", hit, far_root, exit, disc, b);
        endfunction

        // rt_unit: v of `bits` bits; u, scale (out_y_o), shift (out_h_o)
        function bit unit_vector(int bits, longint v[3], int u[3], int unsigned scale, int shift);
            byte error[ERROR];
            int e[3], h;
            int unsigned y;
            if (sphaera_model_unit_vector(bits, v, e, y, h, error) != 0) stop(error);
            return same(u[0] == e[0] && u[1] == e[1] && u[2] == e[2] && scale == y && shift == h,
                        $sformatf("unit vector of %0d,%0d,%0d", v[0], v[1], v[2]),
                        show_vector(u, scale, shift), show_vector(e, y, h));
        endfunction

        // rt_isqrt: the whole root, also of a unit that gives its first `bits` bits (0: all)
        function bit root(bit [127:0] x, int bits, longint unsigned value, bit inexact);
            byte error[ERROR];
            longint unsigned e;
            int i;
            if (sphaera_model_root(x[127:64], x[63:0], bits, e, i, error) != 0) stop(error);
            return same(value == e && inexact == i[0],
                        $sformatf("root of %h", x), $sformatf("%h inexact %b", value, inexact),
                        $sformatf("%h inexact %b", e, i[0]));
        endfunction

        // rt_quotient
        function bit quotient(longint unsigned key, int key_bits, longint unsigned a, int a_bits,
                              int pq, int unsigned mant, int exp);
            byte error[ERROR];
            int unsigned m;
            int e;
            if (sphaera_model_quotient(key, key_bits, a, a_bits, pq, m, e, error) != 0) stop(error);
            return same(mant == m && exp == e,
                        $sformatf("quotient of %h and %h", key, a),
                        $sformatf("%h exp %0d", mant, exp), $sformatf("%h exp %0d", m, e));
        endfunction

        // rt_leaf of W and WD bits: disc, 2W+2WD bits, and b count of a hit without exit alone
        function bit leaf(int w_bits, int wd_bits, longint origin[3], longint direction[3],
                          longint centre[3], longint radius, bit [23:0] id, bit [23:0] skip_id,
                          bit skip_inside, bit shadow, bit inside_on, bit hit, bit far_root,
                          bit exit, bit [127:0] disc, longint b);
            byte error[ERROR];
            longint w[13], r[6];
            bit [127:0] wanted;
            for (int i = 0; i < 3; i++) begin
                w[i] = origin[i];
                w[3+i] = direction[i];
                w[6+i] = centre[i];
            end
            w[9]  = radius;
            w[10] = {8'b0, skip_id, 8'b0, id};
            w[11] = {31'b0, shadow, 31'b0, skip_inside};
            w[12] = {32'b0, 31'b0, inside_on};       // every bit of the root
            if (sphaera_model_leaf(w, r, error) != 0) stop(error);
            wanted = {r[4], r[3]} & ((128'd1 << 2 * (w_bits + wd_bits)) - 128'd1);
            return same(hit == r[0][0] && (!hit || (far_root == r[0][32] && exit == r[1][0])) &&
                        (!hit || exit || (disc == wanted && b == r[2])),
                        $sformatf("leaf at %0d,%0d,%0d radius %0d", centre[0], centre[1],
                                  centre[2], radius),
                        show_leaf(hit, far_root, exit, disc, b),
                        show_leaf(r[0][0], r[0][32], r[1][0], wanted, r[2]));
        endfunction

        // rt_filter
        function bit node_filter(int origin[3], int least, int p_a, int p_b, int q[3], int axis,
                                 bit negative, int depth_max, int centre[3], int radius, bit pass,
                                 int near_depth);
            byte error[ERROR];
            int w[16], p, n;
            for (int i = 0; i < 3; i++) begin
                w[i] = origin[i];
                w[6+i] = q[i];
                w[12+i] = centre[i];
            end
            w[3]  = least;
            w[4]  = p_a;
            w[5]  = p_b;
            w[9]  = axis;
            w[10] = 32'(negative);
            w[11] = depth_max;
            w[15] = radius;
            if (sphaera_model_filter(w, p, n, error) != 0) stop(error);
            return same(pass == p[0] && (!pass || near_depth == n),
                        $sformatf("filter of %0d,%0d,%0d radius %0d", centre[0], centre[1],
                                  centre[2], radius),
                        $sformatf("pass %b near %0d", pass, near_depth),
                        $sformatf("pass %b near %0d", p[0], n));
        endfunction

        // rt_texel_filter: texels 0xBBGGRR
        function bit texel(int unsigned near_texels[4], int unsigned far_texels[4],
                           int near_weights[2], int far_weights[2], int level,
                           int unsigned value);
            byte error[ERROR];
            int unsigned e;
            if (sphaera_model_texel(near_texels, far_texels, near_weights, far_weights, level, e,
                                    error) != 0) stop(error);
            return same(value == e, "texel", $sformatf("%h", value), $sformatf("%h", e));
        endfunction
    endclass
endpackage
