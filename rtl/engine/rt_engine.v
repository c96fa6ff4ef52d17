// rt_engine.v - a barrel of SLOTS rays: set-up, traversal, exact leaves, shading
// SPDX-License-Identifier: Apache-2.0
// One token per slot travels the ring drawn in docs/rtl_interfaces.md.
// Model: sph_render_pixel() in cmodel/engine/render_pixel.c, SLOTS pixels at once
`default_nettype none
`include "rt_layout.vh"
module rt_engine #(
    parameter W          = 16,   // coordinate, bits
    parameter WD         = 17,   // direction component, bits
    parameter PQ         = 17,   // significant bits of the quotient
    parameter NG         = 2,    // guard bits of the normal
    parameter FW         = 14,   // filter coordinate, bits
    parameter PR         = 0,    // significant bits of the root, 0: all
    parameter SLOTS      = 64,   // rays in flight, power of two
    parameter STACK      = 16,   // sibling groups waiting per ray, power of two
    parameter SHADOW     = 1,    // effects elaborated, see rt_core
    parameter REFLECT    = 5,
    parameter LIGHTS     = 8,
    parameter INSIDE     = 1,
    parameter FIRST      = 1,
    parameter INTERPENETRATE = 1,
    parameter FACETS     = 0,
    parameter TEXTURE    = 0,
    parameter REFRACT    = 0,
    parameter SPECULAR   = 0,
    parameter SUM        = 0,
    parameter ACCEL      = 0,    // 0: nodes of four children, 1: BIH
    parameter NODE_LINES = 256,  // node cache
    parameter LEAF_LINES = 128,  // leaf and primitive cache
    parameter TEXTURE_LINES = 128, // texture cache
    parameter TEXTURE_WAYS = 4,  // its groups of a set
    parameter TEXTURE_GROUP = 1, // lines of a group
    parameter TEXTURE_COORDS = 2, // units for texture coordinates
    parameter COARSE     = 0,    // bits of a level's fraction that are rounded away
    parameter ROOTS      = 3,    // square root units
    parameter QUOTIENTS  = 3,    // dividers
    parameter DIVISIONS  = 1,    // dividers for keys of facets
    parameter ROOT_STEP  = 2,    // root bits a clock
    parameter QUOTIENT_STEP = 2, // quotient bits a clock
    parameter DIVISION_STEP = 2, // bits of a facet's key a clock
    parameter READS      = TEXTURE != 0 ? 3 : 2  // not to be set: readers of memory
) (
    input  wire              clk,
    input  wire              rst,
    input  wire              flush_i,         // forget the caches
    output wire              busy_o,
    // registers
    input  wire [`RT_EFFECT_BITS-1:0] effects_i, // EFFECTS of machine.def
    input  wire [1:0]        tex_filter_i,
    input  wire [2:0]        max_depth_i,
    input  wire [3:0]        n_lights_i,
    input  wire [23:0]       background_i,
    input  wire [47:0]       ambient_i,
    input  wire [3*W-1:0]    eye_i,
    input  wire [25:0]       root_i,
    input  wire [25:0]       prim_base_i,
    input  wire [25:0]       mem_lines_i,
    input  wire [23:0]       visit_limit_i,
    input  wire [23:0]       n_prims_i,       // with ACCEL
    input  wire [25:0]       leaf_base_i,
    input  wire [23:0]       n_loose_i,
    input  wire [6*(W+2)-1:0] box_i,          // {z1, y1, x1, z0, y0, x0}
    input  wire              light_valid_i,   // writes one part of one light
    input  wire [2:0]        light_number_i,
    input  wire [2:0]        light_part_i,
    input  wire [31:0]       light_data_i,
    // from rt_walk
    input  wire              in_valid_i,
    output wire              in_ready_o,
    input  wire [13:0]       in_x_i,
    input  wire [13:0]       in_y_i,
    input  wire [3*WD-1:0]   in_dir_i,
    // finished pixels
    output wire              pix_valid_o,
    input  wire              pix_ready_i,
    output wire [13:0]       pix_x_o,
    output wire [13:0]       pix_y_o,
    output wire [71:0]       pix_colour_o,
    output wire [23:0]       pix_id_o,
    output wire [W+WD+1:0]   pix_key_o,
    output wire [23:0]       pix_visits_o,
    output wire [31:0]       pix_texture_o,
    // memory: nodes in bit 0, leaves and primitives in bit 1, textures, if any, in bit 2
    output wire [READS-1:0]  mem_req_valid_o,
    input  wire [READS-1:0]  mem_req_ready_i,
    output wire [26*READS-1:0] mem_req_line_o,
    input  wire [READS-1:0]  mem_rsp_valid_i,
    output wire [READS-1:0]  mem_rsp_ready_o,
    input  wire [255:0]      mem_rsp_data_i,
    input  wire              mem_rsp_error_i,
    // events of this cycle, for the counters
    output wire [3:0]        count_rays_o,    // {refracted, reflected, shadow, primary}
    output wire              count_power_o,
    output wire              count_visit_o,
    output wire [2:0]        count_tests_o,
    output wire              count_leaf_o,
    output wire              count_root_o,
    output wire              count_facet_o,
    output wire              count_divide_o,
    output wire              count_quotient_o,
    output wire              count_saturated_o,
    output wire              count_issued_o,
    output wire [2:0]        count_miss_o,    // {texture, leaf, node}
    output wire              count_texel_o,
    output wire              count_bubble_o,
    output wire [3:0]        errors_o         // {bus, visit limit, stack, node}
);
    localparam SLOTW = $clog2(SLOTS);
    localparam KW = W + WD + 2;
    localparam SHADOWS = LIGHTS != 0 && SHADOW != 0 ? 1 : 0;           // shadow rays
    localparam SHARES  = REFRACT != 0 || SUM != 0 ? 1 : 0;             // blends by shares
    localparam GLOSS   = LIGHTS != 0 && SPECULAR != 0 ? 1 : 0;         // highlights
    localparam BOUNCES = REFLECT != 0 || INTERPENETRATE != 0 || REFRACT != 0 ? 1 : 0; // mirrored
    localparam POINTS  = LIGHTS != 0 || BOUNCES != 0 || TEXTURE != 0 ? 1 : 0; // points, normals
    localparam FARS    = INSIDE != 0 || FACETS != 0 ? 1 : 0;           // hits that are far
    localparam LW = ACCEL != 0 ? `RT_BIH_T - 1 : FW;                   // depth limit, bits - 1
    wire points_on = n_lights_i != 4'd0 ||                             // the same, at run time
                     effects_i[`RT_EFFECT_REFLECT] || effects_i[`RT_EFFECT_INTERPENETRATE] ||
                     (REFRACT != 0 && effects_i[`RT_EFFECT_REFRACT]) ||
                     (TEXTURE != 0 && effects_i[`RT_EFFECT_TEXTURE]);
    generate
        if (INTERPENETRATE != 0 && (FIRST == 0 || INSIDE == 0)) begin : g_check
            rt_engine_INTERPENETRATE_needs_FIRST_and_INSIDE u_error ();
        end
        if ((REFRACT != 0 && INSIDE == 0) || (SPECULAR != 0 && SUM == 0)) begin : g_check_optics
            rt_engine_REFRACT_needs_INSIDE_and_SPECULAR_needs_SUM u_error ();
        end
        if (ACCEL != 0 && FIRST != 0) begin : g_accel
            rt_engine_ACCEL_needs_FIRST_to_be_0 u_error ();
        end
    endgenerate

    // ---- set-up ----
    wire              primary_valid, primary_ready, bounce_valid, vec_valid;
    wire [SLOTW-1:0]  primary_slot, bounce_slot, vec_slot;
    wire [3*WD-1:0]   primary_vec, bounce_vec, vec;
    wire              surface_valid, hit_valid, hit_far;
    wire [SLOTW-1:0]  surface_slot, hit_slot;
    wire [3*W-1:0]    surface_point;
    wire [3*WD-1:0]   surface_normal;
    wire [23:0]       hit_id;
    wire [KW-1:0]     hit_key;
    wire              ray_valid, ray_shadow, ray_primary, ray_negative;
    wire [SLOTW-1:0]  ray_slot;
    wire [3*W-1:0]    ray_org;
    wire [3*WD-1:0]   ray_dir;
    wire [2*WD-1:0]   ray_a;
    wire [24:0]       ray_skip;
    wire [3*FW-1:0]   ray_forg;
    wire [53:0]       ray_unit;
    wire [1:0]        ray_axis;
    wire [16:0]       ray_scale;
    wire [5:0]        ray_shift;
    wire [FW:0]       ray_depth;
    wire [16:0]       ray_y;
    wire [5:0]        ray_h;
    wire              shadow_go, lamp_valid, lamp_lit, normal_valid, cosine_valid, unit_light;
    wire              back_valid, back_ready;      // a refracted ray starts: where, on what
    wire              back = REFRACT != 0 && back_valid;
    wire [3*W-1:0]    back_point;
    wire [24:0]       back_skip;
    wire [W+7:0]      back_path;
    wire [1:0]        deep_rays;                   // {refracted, reflected}, with SHARES
    wire [SLOTW-1:0]  normal_slot, cosine_slot;
    wire              ray_go = ray_valid && !ray_shadow;
    wire [3*WD-1:0]   normal_vec;
    wire [2*WD-1:0]   normal_nn;
    wire [15:0]       cosine;
    rt_setup #(.W(W), .WD(WD), .FW(FW), .SHADOW(SHADOW), .LIGHTS(LIGHTS), .BOUNCES(BOUNCES),
               .TEXTURE(TEXTURE), .SLOTS(SLOTS), .SLOTW(SLOTW)) u_setup (
        .clk(clk), .rst(rst), .eye_i(eye_i), .shadow_on_i(effects_i[`RT_EFFECT_SHADOW]),
        .normal_valid_i(surface_valid), .normal_slot_i(surface_slot),
        .normal_vec_i(surface_normal),
        .light_valid_i(vec_valid), .light_slot_i(vec_slot), .light_vec_i(vec),
        .bounce_valid_i(bounce_valid), .bounce_slot_i(bounce_slot), .bounce_vec_i(bounce_vec),
        .primary_valid_i(primary_valid), .primary_ready_o(primary_ready),
        .primary_slot_i(primary_slot), .primary_vec_i(primary_vec),
        .point_valid_i(surface_valid || back), .point_slot_i(back ? bounce_slot : surface_slot),
        .point_i(back ? back_point : surface_point),
        .skip_valid_i(hit_valid || back), .skip_slot_i(back ? bounce_slot : hit_slot),
        .skip_i(back ? back_skip : {hit_far, hit_id}),
        .ray_valid_o(ray_valid), .ray_slot_o(ray_slot), .ray_shadow_o(ray_shadow),
        .ray_primary_o(ray_primary),
        .ray_org_o(ray_org), .ray_dir_o(ray_dir), .ray_a_o(ray_a), .ray_skip_o(ray_skip),
        .ray_forg_o(ray_forg), .ray_unit_o(ray_unit), .ray_axis_o(ray_axis),
        .ray_negative_o(ray_negative), .ray_scale_o(ray_scale), .ray_shift_o(ray_shift),
        .ray_depth_o(ray_depth), .ray_y_o(ray_y), .ray_h_o(ray_h),
        .lamp_valid_o(lamp_valid), .lamp_lit_o(lamp_lit), .shadow_go_o(shadow_go),
        .normal_valid_o(normal_valid), .normal_slot_o(normal_slot),
        .normal_vec_o(normal_vec), .normal_nn_o(normal_nn),
        .light_valid_o(unit_light),
        .cosine_valid_o(cosine_valid), .cosine_slot_o(cosine_slot), .cosine_o(cosine)
    );
    wire              inside_on = effects_i[`RT_EFFECT_INSIDE];
    wire              facets_on = effects_i[`RT_EFFECT_FACETS];
    wire              ray_again;              // the repeated primary ray of its pixel
    wire              ray_first = FIRST != 0 && effects_i[`RT_EFFECT_FIRST] && ray_primary &&
                                  !ray_again;
    assign count_rays_o = {SHARES != 0 && deep_rays[1],
                           SHARES != 0 ? deep_rays[0] : ray_go && !ray_primary,
                           shadow_go, ray_go && ray_primary};

    // ---- traversal: leaf records to test, then a ray that is done ----
    wire              leaf_visit, visit_valid, done_valid;
    wire [SLOTW-1:0]  leaf_slot, visit_slot, done_slot, visits_slot;
    wire [3:0]        leaf_mask;
    wire [2:0]        leaf_count;
    wire [25:0]       leaf_line;
    wire              filter_read, next_read, next_hit, next_ends, visits_read;
    wire [SLOTW-1:0]  filter_slot, next_slot;
    wire [LW:0]       ray_limit, filter_depth, next_depth;  // what lies deeper does not matter
    wire [23:0]       visits;
    wire              bad_node, visit_limit, node_error, leaf_error, overflow, bad_record, bad_leaf;
    generate
        if (ACCEL == 0) begin : g_four
            wire              issue_valid, found_valid, found_fresh, found_kill;
            wire [SLOTW-1:0]  issue_slot;
            wire [25:0]       issue_line, found_base;
            wire [2:0]        found_count;
            wire [71:0]       found_list;
            assign ray_limit  = ray_depth;
            assign leaf_visit = found_valid && leaf_mask != 4'd0;
            assign leaf_count = {2'b0, leaf_mask[0]} + {2'b0, leaf_mask[1]} +
                                {2'b0, leaf_mask[2]} + {2'b0, leaf_mask[3]};
            rt_traverse #(.FW(FW), .SLOTS(SLOTS), .SLOTW(SLOTW), .LINES(NODE_LINES),
                          .SHADOW(SHADOWS), .FIRST(FIRST), .FACETS(FACETS)) u_traverse (
                .clk(clk), .rst(rst), .flush_i(flush_i),
                .mem_lines_i(mem_lines_i), .root_i(root_i), .visit_limit_i(visit_limit_i),
                .facets_on_i(facets_on),
                .new_valid_i(ray_valid), .new_slot_i(ray_slot), .new_org_i(ray_forg),
                .new_unit_i(ray_unit), .new_axis_i(ray_axis), .new_negative_i(ray_negative),
                .new_first_i(ray_first),
                .go_valid_i(ray_go), .go_slot_i(ray_slot), .go_pixel_i(ray_primary && !ray_again),
                .shadow_go_i(shadow_go), .shadow_slot_i(cosine_slot),
                .next_valid_i(issue_valid), .next_slot_i(issue_slot), .next_line_i(issue_line),
                .depth_read_o(filter_read), .depth_slot_o(filter_slot), .depth_i(filter_depth),
                .found_valid_o(found_valid), .found_slot_o(leaf_slot), .found_base_o(found_base),
                .found_count_o(found_count), .found_list_o(found_list),
                .found_fresh_o(found_fresh), .found_kill_o(found_kill),
                .found_leaf_o(leaf_mask), .found_line_o(leaf_line),
                .visits_read_i(visits_read), .visits_slot_i(visits_slot), .visits_o(visits),
                .mem_req_valid_o(mem_req_valid_o[0]), .mem_req_ready_i(mem_req_ready_i[0]),
                .mem_req_line_o(mem_req_line_o[25:0]),
                .mem_rsp_valid_i(mem_rsp_valid_i[0]), .mem_rsp_ready_o(mem_rsp_ready_o[0]),
                .mem_rsp_data_i(mem_rsp_data_i), .mem_rsp_error_i(mem_rsp_error_i),
                .issued_o(count_issued_o), .visit_o(count_visit_o), .tests_o(count_tests_o),
                .miss_o(count_miss_o[0]), .bad_node_o(bad_node), .visit_limit_o(visit_limit),
                .bus_error_o(node_error)
            );

            // the next node: visits with leaves first, they waited longest
            wire              leafy_valid, plain_valid, leafy_in, plain_in, next_ready;
            wire [SLOTW-1:0]  leafy_slot, plain_slot;
            rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_leafy (
                .clk(clk), .rst(rst), .in_valid_i(visit_valid), .in_ready_o(leafy_in),
                .in_data_i(visit_slot),
                .out_valid_o(leafy_valid), .out_ready_i(next_ready), .out_data_o(leafy_slot)
            );
            rt_fifo #(.WIDTH(SLOTW), .DEPTH(SLOTS)) u_plain (
                .clk(clk), .rst(rst), .in_valid_i(found_valid && leaf_mask == 4'd0),
                .in_ready_o(plain_in), .in_data_i(leaf_slot),
                .out_valid_o(plain_valid), .out_ready_i(next_ready && !leafy_valid),
                .out_data_o(plain_slot)
            );
            rt_next #(.FW(FW), .SLOTS(SLOTS), .SLOTW(SLOTW), .DEPTH(STACK),
                      .ENDS(SHADOWS != 0 || FIRST != 0 ? 1 : 0)) u_next (
                .clk(clk), .rst(rst),
                .found_valid_i(found_valid), .found_slot_i(leaf_slot), .found_base_i(found_base),
                .found_count_i(found_count), .found_list_i(found_list),
                .found_fresh_i(found_fresh), .found_kill_i(found_kill),
                .in_valid_i(leafy_valid || plain_valid), .in_ready_o(next_ready),
                .in_slot_i(leafy_valid ? leafy_slot : plain_slot),
                .read_o(next_read), .slot_o(next_slot), .depth_i(next_depth), .hit_i(next_hit),
                .ends_i(next_ends),
                .issue_valid_o(issue_valid), .issue_slot_o(issue_slot), .issue_line_o(issue_line),
                .done_valid_o(done_valid), .done_slot_o(done_slot),
                .bubble_o(count_bubble_o), .overflow_o(overflow)
            );
            wire unused = &{1'b0, leafy_in, plain_in, n_prims_i, leaf_base_i, n_loose_i, box_i};
        end else begin : g_bih
            assign {filter_read, filter_slot} = {(SLOTW+1){1'b0}};
            rt_bih #(.W(W), .WD(WD), .SLOTS(SLOTS), .SLOTW(SLOTW), .LINES(NODE_LINES),
                     .SHADOW(SHADOWS), .FACETS(FACETS)) u_bih (
                .clk(clk), .rst(rst), .flush_i(flush_i),
                .mem_lines_i(mem_lines_i), .root_i(root_i), .visit_limit_i(visit_limit_i),
                .n_prims_i(n_prims_i), .leaf_base_i(leaf_base_i), .n_loose_i(n_loose_i),
                .box_i(box_i), .facets_on_i(facets_on),
                .new_valid_i(ray_valid), .new_slot_i(ray_slot), .new_org_i(ray_org),
                .new_dir_i(ray_dir), .new_a_i(ray_a), .new_shadow_i(ray_shadow),
                .new_limit_o(ray_limit),
                .go_valid_i(ray_go), .go_slot_i(ray_slot),
                .go_pixel_i(ray_primary && !ray_again),
                .shadow_go_i(shadow_go), .shadow_slot_i(cosine_slot),
                .leaf_valid_o(leaf_visit), .leaf_slot_o(leaf_slot), .leaf_mask_o(leaf_mask),
                .leaf_count_o(leaf_count), .leaf_line_o(leaf_line),
                .tested_valid_i(visit_valid), .tested_slot_i(visit_slot),
                .limit_read_o(next_read), .limit_slot_o(next_slot), .limit_i(next_depth),
                .hit_i(next_hit), .ends_i(next_ends),
                .done_valid_o(done_valid), .done_slot_o(done_slot),
                .visits_read_i(visits_read), .visits_slot_i(visits_slot), .visits_o(visits),
                .mem_req_valid_o(mem_req_valid_o[0]), .mem_req_ready_i(mem_req_ready_i[0]),
                .mem_req_line_o(mem_req_line_o[25:0]),
                .mem_rsp_valid_i(mem_rsp_valid_i[0]), .mem_rsp_ready_o(mem_rsp_ready_o[0]),
                .mem_rsp_data_i(mem_rsp_data_i), .mem_rsp_error_i(mem_rsp_error_i),
                .issued_o(count_issued_o), .visit_o(count_visit_o), .tests_o(count_tests_o),
                .miss_o(count_miss_o[0]), .bubble_o(count_bubble_o), .bad_node_o(bad_node),
                .visit_limit_o(visit_limit), .overflow_o(overflow), .bus_error_o(node_error)
            );
            wire unused = &{1'b0, ray_forg, ray_unit, ray_axis, ray_negative, ray_depth,
                            filter_depth};
        end
    endgenerate

    // ---- exact leaves ----
    wire              result_valid, result_hit, result_far;
    wire [SLOTW-1:0]  result_slot;
    wire [23:0]       result_id;
    wire [KW-1:0]     result_key;
    wire              fetch_valid, fetch_ready, prim_valid, prim_ready;
    wire [SLOTW-1:0]  fetch_slot, prim_slot;
    wire [25:0]       fetch_line;
    wire [255:0]      prim_data;
    rt_leaf_unit #(.W(W), .WD(WD), .SLOTS(SLOTS), .SLOTW(SLOTW), .LINES(LEAF_LINES),
                   .ROOTS(ROOTS), .ROOT_STEP(ROOT_STEP), .PR(PR), .SHADOW(SHADOWS),
                   .INSIDE(INSIDE), .FACETS(FACETS), .DIVISIONS(DIVISIONS),
                   .DIVISION_STEP(DIVISION_STEP)) u_leaves (
        .clk(clk), .rst(rst), .flush_i(flush_i), .inside_on_i(inside_on),
        .facets_on_i(facets_on),
        .ray_valid_i(ray_valid), .ray_slot_i(ray_slot), .ray_shadow_i(ray_shadow),
        .ray_org_i(ray_org), .ray_dir_i(ray_dir), .ray_a_i(ray_a), .ray_skip_i(ray_skip),
        .in_valid_i(leaf_visit), .in_slot_i(leaf_slot), .in_leaf_i(leaf_mask),
        .in_line_i(leaf_line),
        .out_valid_o(result_valid), .out_slot_o(result_slot), .out_hit_o(result_hit),
        .out_far_o(result_far), .out_id_o(result_id), .out_key_o(result_key),
        .prim_valid_i(fetch_valid), .prim_ready_o(fetch_ready), .prim_slot_i(fetch_slot),
        .prim_line_i(fetch_line),
        .prim_valid_o(prim_valid), .prim_ready_i(prim_ready), .prim_slot_o(prim_slot),
        .prim_data_o(prim_data),
        .mem_req_valid_o(mem_req_valid_o[1]), .mem_req_ready_i(mem_req_ready_i[1]),
        .mem_req_line_o(mem_req_line_o[51:26]),
        .mem_rsp_valid_i(mem_rsp_valid_i[1]), .mem_rsp_ready_o(mem_rsp_ready_o[1]),
        .mem_rsp_data_i(mem_rsp_data_i), .mem_rsp_error_i(mem_rsp_error_i),
        .test_o(count_leaf_o), .root_o(count_root_o), .facet_o(count_facet_o),
        .divide_o(count_divide_o), .bad_node_o(bad_leaf), .miss_o(count_miss_o[1]),
        .bus_error_o(leaf_error)
    );
    wire              done_found, done_shadow, done_primary, done_first, done_far;
    wire [23:0]       done_id;
    wire [KW-1:0]     done_key;
    rt_collect #(.W(W), .WD(WD), .FW(LW), .KEYS(ACCEL), .SLOTS(SLOTS), .SLOTW(SLOTW),
                 .SHADOW(SHADOWS), .INSIDE(FARS), .FIRST(FIRST)) u_collect (
        .clk(clk), .rst(rst),
        .want_valid_i(leaf_visit), .want_slot_i(leaf_slot), .want_count_i(leaf_count),
        .new_valid_i(ray_valid), .new_slot_i(ray_slot), .new_scale_i(ray_scale),
        .new_shift_i(ray_shift), .new_shadow_i(ray_shadow), .new_primary_i(ray_primary),
        .new_first_i(ray_first), .new_depth_i(ray_limit),
        .in_valid_i(result_valid), .in_slot_i(result_slot), .in_hit_i(result_hit),
        .in_far_i(result_far), .in_id_i(result_id), .in_key_i(result_key),
        .out_valid_o(visit_valid), .out_slot_o(visit_slot),
        .filter_valid_i(filter_read), .filter_slot_i(filter_slot), .filter_depth_o(filter_depth),
        .next_valid_i(next_read), .next_slot_i(next_slot), .next_depth_o(next_depth),
        .next_found_o(next_hit), .next_ends_o(next_ends),
        .done_valid_i(done_valid), .done_slot_i(done_slot), .done_found_o(done_found),
        .done_shadow_o(done_shadow), .done_primary_o(done_primary), .done_first_o(done_first),
        .done_far_o(done_far), .done_id_o(done_id), .done_key_o(done_key)
    );

    // ---- shading ----
    reg               over_valid_q;           // rt_collect has answered about a ray that is done
    reg [SLOTW-1:0]   over_slot_q;
    always @(posedge clk) begin
        over_valid_q <= done_valid;
        over_slot_q  <= done_slot;
        if (rst) over_valid_q <= 1'b0;
    end
    wire              material_valid;
    wire [SLOTW-1:0]  material_slot;
    wire [32:0]       material;
    wire [25:0]       material_tex;
    wire [59:0]       material_look;
    wire [3*(W+NG)-1:0] surface_guarded;
    wire              bare_valid;             // a surface that needs no point
    wire [SLOTW-1:0]  bare_slot;
    rt_surface #(.W(W), .WD(WD), .PQ(PQ), .NG(NG), .POINTS(POINTS), .BOUNCES(BOUNCES),
                 .INSIDE(INSIDE), .FACETS(FACETS), .TEXTURE(TEXTURE), .LOOKS(SHARES),
                 .SLOTS(SLOTS), .SLOTW(SLOTW), .QUOTIENTS(QUOTIENTS),
                 .QUOTIENT_STEP(QUOTIENT_STEP)) u_surface (
        .clk(clk), .rst(rst), .prim_base_i(prim_base_i), .eye_i(eye_i), .points_on_i(points_on),
        .facets_on_i(facets_on),
        .ray_valid_i(ray_valid && !ray_shadow), .ray_slot_i(ray_slot), .ray_org_i(ray_org),
        .ray_dir_i(ray_dir), .ray_a_i(ray_a),
        .in_valid_i(hit_valid), .in_slot_i(hit_slot), .in_far_i(hit_far), .in_id_i(hit_id),
        .in_key_i(hit_key),
        .prim_valid_o(fetch_valid), .prim_ready_i(fetch_ready), .prim_slot_o(fetch_slot),
        .prim_line_o(fetch_line),
        .prim_valid_i(prim_valid), .prim_ready_o(prim_ready), .prim_slot_i(prim_slot),
        .prim_data_i(prim_data),
        .material_valid_o(material_valid), .material_slot_o(material_slot),
        .material_o(material), .material_tex_o(material_tex),
        .material_look_o(material_look),
        .bare_valid_o(bare_valid), .bare_slot_o(bare_slot),
        .out_valid_o(surface_valid), .out_slot_o(surface_slot), .out_point_o(surface_point),
        .out_guarded_o(surface_guarded), .out_normal_o(surface_normal),
        .quotient_o(count_quotient_o), .saturated_o(count_saturated_o)
    );
    wire              shadow_valid, shadow_lit, sum_valid;
    wire [SLOTW-1:0]  shadow_slot, sum_slot;
    wire [50:0]       sum;

    // ---- texture: between a surface, which may be without a normal, and its lights ----
    wire              lit_valid = normal_valid || bare_valid;    // never both: see points_on
    wire [SLOTW-1:0]  lit_slot  = bare_valid ? bare_slot : normal_slot;
    wire              start_valid, albedo_valid, bad_texture, texture_error;
    wire [SLOTW-1:0]  start_slot, albedo_slot;
    wire [32:0]       albedo;
    wire [31:0]       texture;
    wire              path_valid;
    wire [SLOTW-1:0]  path_slot;
    wire [W+7:0]      path;
    generate
        if (TEXTURE != 0) begin : g_texture
            rt_texture #(.W(W), .WD(WD), .NG(NG), .BACK(REFRACT), .SLOTS(SLOTS), .SLOTW(SLOTW),
                         .LINES(TEXTURE_LINES), .WAYS(TEXTURE_WAYS),
                         .GROUP(TEXTURE_GROUP), .COORDS(TEXTURE_COORDS),
                         .COARSE(COARSE)) u_texture (
                .clk(clk), .rst(rst), .flush_i(flush_i),
                .on_i(effects_i[`RT_EFFECT_TEXTURE]), .filter_i(tex_filter_i),
                .mem_lines_i(mem_lines_i),
                .ray_valid_i(ray_go), .ray_slot_i(ray_slot), .ray_primary_i(ray_primary),
                .ray_y_i(ray_y), .ray_h_i(ray_h),
                .hit_valid_i(hit_valid), .hit_slot_i(hit_slot), .hit_far_i(hit_far),
                .hit_key_i(hit_key),
                .record_valid_i(material_valid), .record_slot_i(material_slot),
                .record_i(material), .record_tex_i(material_tex),
                .point_valid_i(surface_valid), .point_slot_i(surface_slot),
                .point_i(surface_guarded),
                .path_valid_o(path_valid), .path_slot_o(path_slot), .path_o(path),
                .back_valid_i(back), .back_slot_i(bounce_slot), .back_path_i(back_path),
                .in_valid_i(lit_valid), .in_slot_i(lit_slot), .in_unit_i(ray_unit),
                .material_valid_o(albedo_valid), .material_slot_o(albedo_slot),
                .material_o(albedo), .out_valid_o(start_valid), .out_slot_o(start_slot),
                .word_read_i(visits_read), .word_slot_i(visits_slot), .word_o(texture),
                .mem_req_valid_o(mem_req_valid_o[READS-1]),
                .mem_req_ready_i(mem_req_ready_i[READS-1]),
                .mem_req_line_o(mem_req_line_o[26*READS-1 -: 26]),
                .mem_rsp_valid_i(mem_rsp_valid_i[READS-1]),
                .mem_rsp_ready_o(mem_rsp_ready_o[READS-1]),
                .mem_rsp_data_i(mem_rsp_data_i), .mem_rsp_error_i(mem_rsp_error_i),
                .texel_o(count_texel_o), .miss_o(count_miss_o[2]), .bad_node_o(bad_texture),
                .bus_error_o(texture_error)
            );
        end else begin : g_plain
            assign {start_valid, start_slot} = {lit_valid, lit_slot};
            assign {albedo_valid, albedo_slot, albedo} = {material_valid, material_slot, material};
            assign {count_texel_o, count_miss_o[2], bad_texture, texture_error} = 4'd0;
            assign texture = {12'd`RT_LOD_NONE, 20'd0};
            assign {path_valid, path_slot, path} = {(SLOTW+W+9){1'b0}};
            wire unused = &{1'b0, material_tex, surface_guarded, ray_y, ray_h, tex_filter_i,
                            back_path};
        end
    endgenerate

    // ---- highlights: between a light that has settled and the sum ----
    wire              settled, settled_lit;
    wire [SLOTW-1:0]  settled_slot;
    wire [15:0]       settled_highlight;
    wire [50:0]       gloss;
    generate
        if (GLOSS != 0) begin : g_shine
            rt_shine #(.SHADOW(SHADOWS), .SLOTS(SLOTS), .SLOTW(SLOTW)) u_shine (
                .clk(clk), .rst(rst),
                .on_i(effects_i[`RT_EFFECT_SUM] && effects_i[`RT_EFFECT_SPECULAR]),
                .dir_valid_i(ray_go), .normal_valid_i(normal_valid), .light_valid_i(unit_light),
                .unit_slot_i(ray_slot), .unit_i(ray_unit),
                .look_valid_i(material_valid), .look_slot_i(material_slot),
                .look_i(material_look),
                .lamp_valid_i(lamp_valid), .lamp_slot_i(cosine_slot), .lamp_lit_i(lamp_lit),
                .shadow_valid_i(shadow_valid), .shadow_slot_i(shadow_slot),
                .shadow_lit_i(shadow_lit),
                .out_valid_o(settled), .out_slot_o(settled_slot), .out_lit_o(settled_lit),
                .out_highlight_o(settled_highlight), .power_o(count_power_o)
            );
        end else begin : g_no_shine
            assign {settled, settled_slot, settled_lit} = {lamp_valid, cosine_slot, lamp_lit};
            assign settled_highlight = 16'd0;
            assign count_power_o     = 1'b0;
            wire unused = &{1'b0, unit_light};
        end
    endgenerate

    // ---- lights, pixels ----
    generate
        if (LIGHTS != 0) begin : g_lights
            rt_lights #(.W(W), .WD(WD), .LIGHTS(LIGHTS), .SHADOW(GLOSS != 0 ? 0 : SHADOW),
                        .AMBIENT(SUM != 0 ? 0 : 1), .GLOSS(GLOSS), .SLOTS(SLOTS),
                        .SLOTW(SLOTW)) u_lights (
                .clk(clk), .rst(rst), .n_lights_i(n_lights_i), .ambient_i(ambient_i),
                .light_valid_i(light_valid_i), .light_number_i(light_number_i),
                .light_part_i(light_part_i), .light_data_i(light_data_i),
                .point_valid_i(surface_valid), .point_slot_i(surface_slot),
                .point_i(surface_point),
                .cosine_valid_i(cosine_valid), .cosine_slot_i(cosine_slot), .cosine_i(cosine),
                .start_valid_i(start_valid), .start_slot_i(start_slot),
                .lamp_valid_i(settled), .lamp_slot_i(settled_slot), .lamp_lit_i(settled_lit),
                .lamp_highlight_i(settled_highlight),
                .shadow_valid_i(shadow_valid), .shadow_slot_i(shadow_slot),
                .shadow_lit_i(shadow_lit),
                .vec_valid_o(vec_valid), .vec_slot_o(vec_slot), .vec_o(vec),
                .sum_valid_o(sum_valid), .sum_slot_o(sum_slot), .sum_o(sum),
                .gloss_o(gloss)
            );
        end else begin : g_ambient
            assign vec_valid = 1'b0;
            assign vec_slot  = {SLOTW{1'b0}};
            assign vec       = {3*WD{1'b0}};
            assign sum_valid = start_valid;
            assign sum_slot  = start_slot;
            assign gloss     = 51'd0;
            assign sum       = SUM != 0 ? 51'd0 :
                               {1'b0, ambient_i[47:32], 1'b0, ambient_i[31:16],
                                1'b0, ambient_i[15:0]};
            wire unused = &{1'b0, light_valid_i, light_number_i, light_part_i, light_data_i,
                            cosine_valid, cosine_slot, cosine, settled, settled_slot,
                            settled_lit, settled_highlight,
                            shadow_valid, shadow_slot, shadow_lit};
        end
    endgenerate
    rt_pixels #(.W(W), .WD(WD), .SHADOW(SHADOWS), .REFLECT(REFLECT), .LIGHTS(LIGHTS),
                .INSIDE(INSIDE), .FACETS(FACETS), .TEXTURE(TEXTURE),
                .INTERPENETRATE(INTERPENETRATE), .REFRACT(REFRACT), .SPECULAR(SPECULAR),
                .SUM(SUM), .PR(PR), .SLOTS(SLOTS), .SLOTW(SLOTW)) u_pixels (
        .clk(clk), .rst(rst), .busy_o(busy_o),
        .shares_on_i({effects_i[`RT_EFFECT_SUM], effects_i[`RT_EFFECT_SPECULAR],
                      effects_i[`RT_EFFECT_REFRACT], effects_i[`RT_EFFECT_REFLECT]}),
        .max_depth_i(max_depth_i), .ambient_i(ambient_i),
        .probe_on_i(effects_i[`RT_EFFECT_INTERPENETRATE]),
        .background_i(background_i),
        .prim_base_i(prim_base_i), .mem_lines_i(mem_lines_i),
        .in_valid_i(in_valid_i), .in_ready_o(in_ready_o), .in_x_i(in_x_i), .in_y_i(in_y_i),
        .in_dir_i(in_dir_i),
        .primary_valid_o(primary_valid), .primary_ready_i(primary_ready),
        .primary_slot_o(primary_slot), .primary_vec_o(primary_vec),
        .bounce_valid_o(bounce_valid), .bounce_slot_o(bounce_slot), .bounce_vec_o(bounce_vec),
        .ray_valid_i(ray_valid && !ray_shadow), .ray_slot_i(ray_slot), .ray_dir_i(ray_dir),
        .ray_a_i(ray_a), .ray_again_o(ray_again),
        .normal_valid_i(normal_valid), .normal_slot_i(normal_slot),
        .normal_vec_i(normal_vec), .normal_nn_i(normal_nn),
        .ask_valid_i(done_valid), .ask_slot_i(done_slot),
        .done_valid_i(over_valid_q), .done_slot_i(over_slot_q), .done_found_i(done_found),
        .done_shadow_i(done_shadow), .done_primary_i(done_primary), .done_first_i(done_first),
        .done_far_i(done_far), .done_id_i(done_id),
        .done_key_i(done_key),
        .shadow_valid_o(shadow_valid), .shadow_slot_o(shadow_slot),
        .shadow_lit_o(shadow_lit),
        .hit_valid_o(hit_valid), .hit_slot_o(hit_slot), .hit_far_o(hit_far),
        .hit_id_o(hit_id), .hit_key_o(hit_key),
        .material_valid_i(albedo_valid), .material_slot_i(albedo_slot), .material_i(albedo),
        .sum_valid_i(sum_valid), .sum_slot_i(sum_slot), .sum_i(sum),
        .look_valid_i(material_valid), .look_slot_i(material_slot), .look_i(material_look),
        .gloss_i(gloss), .point_valid_i(surface_valid), .point_slot_i(surface_slot),
        .point_i(surface_point),
        .path_valid_i(path_valid), .path_slot_i(path_slot), .path_i(path),
        .back_valid_o(back_valid), .back_ready_i(back_ready), .back_point_o(back_point),
        .back_skip_o(back_skip), .back_path_o(back_path), .count_o(deep_rays),
        .visits_read_o(visits_read), .visits_slot_o(visits_slot), .visits_i(visits),
        .texture_i(texture),
        .pix_valid_o(pix_valid_o), .pix_ready_i(pix_ready_i),
        .pix_x_o(pix_x_o), .pix_y_o(pix_y_o), .pix_colour_o(pix_colour_o),
        .pix_id_o(pix_id_o), .pix_key_o(pix_key_o), .pix_visits_o(pix_visits_o),
        .pix_texture_o(pix_texture_o),
        .bad_node_o(bad_record)
    );
    assign back_ready = !surface_valid && !hit_valid && !path_valid;
    assign errors_o = {node_error || leaf_error || texture_error, visit_limit, overflow,
                       bad_node || bad_record || bad_leaf || bad_texture};
    wire unused = &{1'b0, effects_i};
endmodule
`default_nettype wire
