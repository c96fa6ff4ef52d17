/* test_box.c - boxes in a node's frame hold what they are written for: every plane of a small grid,
 * and every child of whole trees
 * SPDX-License-Identifier: Apache-2.0
 *
 * build/test/test_box [seed]
 */
#include "containment.h"

#include "builder/box.h"
#include "machine/box.h"
#include "machine/records.h"

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

/* Everything below a node lies in the node's box; how many primitives there are. */
static uint32_t below(const struct sph_machine *m, const struct sph_plants *plants, uint32_t line,
                      const struct sph_box *outer) {
    const uint32_t *node = sph_line(m, line);
    uint32_t base = sph_field(node, SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS), n = 0;
    uint32_t inner = sph_field(node, SPH_NODE_N_INNER_LSB, SPH_NODE_N_INNER_BITS);
    uint32_t leaves = sph_field(node, SPH_NODE_N_LEAF_LSB, SPH_NODE_N_LEAF_BITS);
    for (uint32_t i = 0; i < inner + leaves; i++) {
        struct sph_box box, both;
        sph_box_read(node, (int)i, &m->profile, &box);
        for (int k = 0; k < 3; k++) { /* a box in its parent's step may be the larger one */
            both.lo[k] = box.lo[k] > outer->lo[k] ? box.lo[k] : outer->lo[k];
            both.hi[k] = box.hi[k] < outer->hi[k] ? box.hi[k] : outer->hi[k];
        }
        if (i < inner) {
            n += below(m, plants, base + i, &both);
            continue;
        }
        const uint32_t *record = sph_record(m, 1, base + inner, i - inner);
        int facet = sph_field(record, SPH_FACET_KIND_LSB, SPH_FACET_KIND_BITS) != SPH_SPHERE;
        uint32_t id = facet ? sph_field(record, SPH_FACET_ID_LSB, SPH_FACET_ID_BITS)
                            : sph_field(record, SPH_LEAF_ID_LSB, SPH_LEAF_ID_BITS);
        struct sph_aabb prim;
        sph_box_of(plants, id, &prim);
        for (int k = 0; k < 3; k++)
            assert_true(both.lo[k] <= prim.lo[k] && prim.hi[k] <= both.hi[k]);
        n++;
    }
    return n;
}

static void trees(void **unused) {
    (void)unused;
    for (int run = 0; run < 8; run++) {
        struct sph_build_options o = standard;
        struct sph_build_report report;
        struct sph_scene s = bare();
        struct sph_grid grid;
        struct sph_facets facets;
        struct sph_ball balls[BALLS + TRIANGLES + 5];
        soup(&s, TRIANGLES, run & 1 ? 0.02 : 0.4);
        for (int i = 0; i < run / 2; i++)
            add_plane(&s, at(uniform(), -uniform(), uniform()), near_to(at(0, 1, 0), 0.5));
        for (int i = 0; i < BALLS; i++)
            add_ball(&s, at(uniform(), uniform(), uniform()), 0.1);
        o.tree = SPH_TREE_BOX4, o.profile = run % SPH_PROFILES;
        struct sph_machine m = built(&s, o, &report);
        double smallest;
        assert_int_equal(sph_grid_fit(&s, m.profile.w, &grid, NULL), 0);
        assert_int_equal(sph_grid_spheres(&grid, &s, &m.profile, balls, &smallest, NULL), 0);
        assert_int_equal(sph_grid_facets(&grid, &s, &m.profile, &facets, NULL), 0);
        struct sph_plants plants = {balls, s.n_spheres, &facets, &m.profile, grid.eye, o.tree};
        struct sph_box all = {{INT32_MIN, INT32_MIN, INT32_MIN}, {INT32_MAX, INT32_MAX, INT32_MAX}};
        assert_int_equal(below(&m, &plants, 0, &all), s.n_spheres + facets.n);
        sph_facets_free(&facets);
        sph_machine_free(&m);
    }
}

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(planes), cmocka_unit_test(trees)};
    seed(argc, argv);
    return cmocka_run_group_tests_name("box", tests, NULL, NULL);
}
