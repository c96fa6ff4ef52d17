/* test_box.c - boxes in a node's frame hold what they are written for: every plane of a small grid,
 * and every child of whole trees; none is deeper than a ray's stack
 * SPDX-License-Identifier: Apache-2.0
 *
 * build/test/test_box [seed]
 */
#include "containment.h"

#include "core/frame.h"
#include "render/render.h"

enum { TRIANGLES = 60, BALLS = 12 };

/* Along one axis, at W 8: every frame, and in it every plane of a child, below and above. A written
 * plane is outside by less than a step, of which 128 hardly reach over the frame. */
static void planes(void **unused) {
    (void)unused;
    struct sph_profile p = sph_profiles[SPH_DRAFT];
    p.w = 8;
    int end = 1 << (p.w - 1);
    for (int lo = -end; lo <= end; lo++)
        for (int hi = lo; hi <= end; hi++)
            for (int at = lo; at <= hi; at++) {
                uint32_t line[SPH_LINE_WORDS] = {0};
                struct sph_aabb boxes[] = {{{lo, lo, lo}, {hi, hi, hi}},
                                           {{lo, at, at}, {at, at, hi}}};
                struct sph_box box[2];
                sph_box_put(line, boxes, 2, &p);
                int step = hi - lo > SPH_BOX_CODES ? 2 : 1;
                for (int j = 0; j < 2; j++) {
                    sph_box_read(line, j, &p, &box[j]);
                    for (int i = 0; i < 3; i++) {
                        assert_true(box[j].lo[i] <= boxes[j].lo[i]);
                        assert_true(box[j].hi[i] >= boxes[j].hi[i]);
                        assert_true(box[j].lo[i] >= boxes[j].lo[i] - step);
                        assert_true(box[j].hi[i] <= boxes[j].hi[i] + step);
                    }
                }
            }
}

static void trees(void **unused) {
    (void)unused;
    for (int run = 0; run < 8; run++) {
        struct sph_build_options o = standard;
        struct sph_build_report report;
        struct sph_scene s = bare();
        soup(&s, TRIANGLES, run & 1 ? 0.02 : 0.4);
        for (int i = 0; i < run / 2; i++)
            add_plane(&s, at(uniform(), -uniform(), uniform()), near_to(at(0, 1, 0), 0.5));
        for (int i = 0; i < BALLS; i++)
            add_ball(&s, at(uniform(), uniform(), uniform()), 0.1);
        o.tree = SPH_TREE_BOX4, o.profile = run % SPH_PROFILES;
        struct sph_machine m = built(&s, o, &report);
        assert_int_equal(check_boxes(&s, &m), s.n_spheres + report.facets);
        sph_machine_free(&m);
    }
}

/* Levels of nodes below a line, its own with them. */
static uint32_t levels(const struct sph_machine *m, uint32_t line) {
    const uint32_t *node = sph_line(m, line);
    uint32_t base = sph_field(node, SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS), most = 0;
    uint32_t inner = sph_field(node, SPH_NODE_N_INNER_LSB, SPH_NODE_N_INNER_BITS);
    for (uint32_t i = 0; i < inner; i++) {
        uint32_t n = levels(m, base + i);
        if (n > most) most = n;
    }
    return most + 1;
}

/* Triangles within each other, each a seventh larger: the cheapest tree peels off the largest ones,
 * three a level, and has 29 levels of nodes, where a ray has room for 16. */
static void deep(void **unused) {
    static const int trees[] = {SPH_TREE_BOX4, SPH_TREE_REINSERTED};
    (void)unused;
    for (int i = 0; i < 2; i++)
        for (int planes = 0; planes < 7; planes += 3) {
            struct sph_build_options o = standard;
            struct sph_build_report report;
            struct sph_scene s = bare();
            for (double size = planes ? 3e-4 : 1e-5; size < 1; size *= 8. / 7)
                add_triangle(&s, at(1.1 * size, 0.1 * size, -0.9 * size),
                             at(-0.9 * size, 1.1 * size, 0.1 * size),
                             at(0.1 * size, -0.9 * size, 1.1 * size), s.n_facets);
            for (int k = 0; k < planes; k++)
                add_plane(&s, at(uniform(), -uniform(), uniform()), near_to(at(0, 1, 0), 0.5));
            o.tree = trees[i], o.profile = SPH_REFERENCE, o.width = 24, o.height = 16;
            struct sph_machine m = built(&s, o, &report);
            uint32_t n = levels(&m, (uint32_t)m.regs[SPH_REG_ROOT]);
            printf("# tree %d, %u facets, %d of them planes: %u levels\n", trees[i], s.n_facets,
                   planes, n);
            assert_true(n <= SPH_STACK_DEPTH);
            assert_int_equal(n, report.depth);
            uint64_t hash[2];
            for (int how = 0; how < 2; how++) {
                struct sph_frame frame;
                struct sph_counters counters = {{0}};
                struct sph_render_options r = {
                    .traverse = how ? SPH_TRAVERSE_BRUTE : SPH_TRAVERSE_TREE, .threads = 1};
                assert_int_equal(sph_render(&m, &r, &frame, &counters, NULL), 0);
                hash[how] = sph_frame_picture_hash(&frame);
                sph_frame_free(&frame);
            }
            assert_true(hash[0] == hash[1]);
            sph_machine_free(&m);
        }
}

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(planes), cmocka_unit_test(trees),
                                       cmocka_unit_test(deep)};
    seed(argc, argv);
    return cmocka_run_group_tests_name("box", tests, NULL, NULL);
}
