// leaf_test.vh - sph_leaf_test() of the sums that f_leaf_wide.v and f_leaf_slow.v look at
// SPDX-License-Identifier: Apache-2.0
// Of b_q and k_q, which the leaf has made; SUMS: nothing is asserted here.
    function signed [2*NW-1:0] times_wide(input signed [NW-1:0] x, input signed [NW-1:0] y);
        times_wide = x * y;
    endfunction
    wire signed [X-1:0]  b = b_q, k = k_q, a = $signed({1'b0, a_q});
    wire signed [X-1:0]  ka   = times_wide(k[NW-1:0], a[NW-1:0]);
    wire signed [X-1:0]  bb   = times_wide(b[NW-1:0], b[NW-1:0]);
    wire signed [X-1:0]  disc = ka + bb;
    wire signed [X-1:0]  light = k + (2*b - a);
    localparam signed [X-1:0] ONE = 1;
    localparam signed [X-1:0] LONG = (ONE <<< W) - 1, D = ONE <<< (WD - 1);   // factors at most
    function fits(input signed [X-1:0] x, input signed [X-1:0] most);
        fits = x <= most && x >= -most;
    endfunction
    wire fit = fits(b, 3*LONG*D) && k <= LONG*LONG && k >= -3*LONG*LONG && a <= 3*D*D &&
                    fits(ka, ONE <<< (X-3)) && fits(bb, ONE <<< (X-3)) &&
                    disc < ONE <<< (DW-2) && disc >= -(ONE <<< (DW-1));
    wire own    = own_q;
    wire inner  = INSIDE != 0 && on_q;
    wire skip   = inner ? own && !skip_inside_q : own || k >= 0;
    wire ahead  = disc > 0 && (b > 0 || k > 0);
    wire far    = !skip && (k >= 0 || own);
    wire ends   = SHADOW != 0 && shadow_q;
    wire exit   = !skip && !ends && own && !ahead;
    wire hit    = !skip && (!ends ? ahead || own
                            : own   ? light < 0
                            : k < 0 ? disc > 0 && b > 0 && (b < a || light > 0)
                                    : (k > 0 || b > 0) && light < 0);

    // ---- T clocks later ----
    always @* if (age_q == T && SUMS == 0) begin
        assume (fit);
        assert (out_valid && out_tag == tag_q && out_id == id_q);
        assert (out_hit == hit);
        if (hit) assert (out_b == b && out_far == far);
        if (hit && !ends) assert (out_exit == exit);
        if (hit && !ends && !exit) assert (out_disc == disc);
    end
