/* test_trace_limits.c - rules of a ray's way where they change: both sides of each comparison
 * SPDX-License-Identifier: Apache-2.0
 *
 * What model and RTL must do alike, though random numbers seldom meet it: nodes that end with
 * memory, planes and spheres that a ray just reaches, children that are equally near.
 */
#include "vectors.h"

#include <string.h>

#include "builder/tree/tree.h"
#include "machine/machine.h"
#include "trace/bih.h"
#include "trace/filter.h"
#include "trace/traverse.h"
#include "trace/setup.h"

enum { LINES = 6, BAD = 1 << SPH_ERROR_BAD_NODE };

static uint32_t mem[(LINES + 2) * SPH_LINE_WORDS]; /* two lines more than the machine knows */

/* A machine of six empty lines, with no primitives. */
static struct sph_machine empty(int tree) {
    struct sph_machine m = {.mem = mem, .lines = LINES};
    memset(mem, 0, sizeof mem);
    sph_machine_set_profile(&m, &sph_profiles[SPH_STANDARD]);
    m.regs[SPH_REG_MEM_LINES] = LINES;
    m.regs[SPH_REG_TREE] = tree;
    m.regs[SPH_REG_LEAF_BASE] = LINES; /* the records end with memory: there are none */
    m.regs[SPH_REG_VISIT_LIMIT] = 100;
    for (int i = 0; i < 3; i++) {
        m.regs[SPH_REG_BOX_X0 + i] = -30000;
        m.regs[SPH_REG_BOX_X1 + i] = 30000;
    }
    return m;
}

/* A ray from the middle of the grid. */
static struct sph_ray ray_to(int kind, int64_t x, int64_t y, int64_t z) {
    struct sph_ray ray = {.kind = kind, .skip = {SPH_ID_NONE, 0}, .dir = {x, y, z}, .inside = 1};
    sph_ray_setup(&sph_profiles[SPH_STANDARD], &ray);
    return ray;
}

/* The nodes that a ray visits, and its errors. */
static uint32_t visits_of(const struct sph_machine *m, const struct sph_ray *ray,
                          uint32_t *errors) {
    struct sph_counters c = {{0}};
    uint32_t visits = 0;
    *errors = 0;
    assert_int_equal(sph_traverse(m, ray, SPH_TRAVERSE_TREE, &c, &visits, errors).key, 0);
    assert_int_equal(visits, c.count[SPH_COUNT_NODE_VISITS]);
    return visits;
}

static void set_bih(struct sph_machine *m, uint32_t line, int half, uint32_t axis, int fit,
                    int32_t l, int32_t r, uint32_t child) {
    uint32_t *node = sph_line(m, line) + half * (SPH_BIH_STRIDE / 32);
    sph_field_set(node, SPH_BIH_AXIS_LSB, SPH_BIH_AXIS_BITS, axis);
    sph_field_set(node, SPH_BIH_FIT_LSB, SPH_BIH_FIT_BITS, (uint32_t)fit);
    sph_field_set(node, SPH_BIH_CLIP_L_LSB, SPH_BIH_CLIP_L_BITS, (uint32_t)l);
    sph_field_set(node, SPH_BIH_CLIP_R_LSB, SPH_BIH_CLIP_R_BITS, (uint32_t)r);
    sph_field_set(node, SPH_BIH_CHILD_LSB, SPH_BIH_CHILD_BITS, child);
}

/* The last line may be a node, the one behind it not; whatever the tree. */
static void root_at_the_end(void **state) {
    static const int trees[] = {SPH_TREE_BALANCED, SPH_TREE_BOX4, SPH_TREE_BIH};
    (void)state;
    for (int t = 0; t < 3; t++)
        for (int line = LINES - 1; line <= LINES; line++) {
            struct sph_machine m = empty(trees[t]);
            struct sph_ray ray = ray_to(SPH_PRIMARY, 1000, 20, 3);
            uint32_t errors;
            m.regs[SPH_REG_ROOT] = line;
            for (int i = LINES - 1; i <= LINES; i++)
                if (trees[t] == SPH_TREE_BIH) set_bih(&m, (uint32_t)i, 0, SPH_BIH_LEAF, 0, 0, 0, 0);
            assert_int_equal(visits_of(&m, &ray, &errors), line < LINES);
            assert_int_equal(errors, line < LINES ? 0 : BAD);
        }
}

/* Registers that let no ray start; each is in order with one less, or with all planes. */
static void bih_registers(void **state) {
    (void)state;
    for (int wrong = 0; wrong < 2; wrong++) {
        struct sph_ray ray = ray_to(SPH_PRIMARY, 1000, 20, 3);
        uint32_t errors;
        struct sph_machine m = empty(SPH_TREE_BIH);
        set_bih(&m, 0, 0, SPH_BIH_LEAF, 0, 0, 0, 0);
        m.regs[SPH_REG_LEAF_BASE] = LINES + wrong;
        assert_int_equal(visits_of(&m, &ray, &errors), !wrong);
        assert_int_equal(errors, wrong ? BAD : 0);
        m = empty(SPH_TREE_BIH); /* two records of no radius, loose or not */
        set_bih(&m, 0, 0, SPH_BIH_LEAF, 0, 0, 0, 0);
        m.regs[SPH_REG_LEAF_BASE] = LINES - 2;
        m.regs[SPH_REG_N_PRIMS] = 2;
        m.regs[SPH_REG_N_LOOSE] = 2 + wrong;
        assert_int_equal(visits_of(&m, &ray, &errors), !wrong);
        assert_int_equal(errors, wrong ? BAD : 0);
        m = empty(SPH_TREE_BIH); /* children behind memory, and records of a leaf */
        set_bih(&m, 0, 0, 0, 0, 100, -100, LINES - 1 + (uint32_t)wrong);
        set_bih(&m, LINES - 1, 0, SPH_BIH_LEAF, 0, 0, 0, 0);
        set_bih(&m, LINES - 1, 1, SPH_BIH_LEAF, 0, 0, 0, 0);
        assert_int_equal(visits_of(&m, &ray, &errors), wrong ? 1 : 3);
        assert_int_equal(errors, wrong ? BAD : 0);
        m = empty(SPH_TREE_BIH);
        m.regs[SPH_REG_LEAF_BASE] = LINES - 2;
        m.regs[SPH_REG_N_PRIMS] = 2;
        set_bih(&m, 0, 0, SPH_BIH_LEAF, 0, 1, 1 + wrong, 0);
        assert_int_equal(visits_of(&m, &ray, &errors), 1);
        assert_int_equal(errors, wrong ? BAD : 0);
    }
}

/* Bounds at the largest T-word; distances that lose bits, rounded to the side that is wider. */
static void bounds_of_words(void **state) {
    (void)state;
    for (int shift = 0; shift <= 9; shift += 3) {
        const struct sph_bih_ray b = {.t_shift = shift};
        const uint64_t unit = 1ull << shift, none = SPH_BIH_NO_BOUND;
        assert_int_equal(sph_bih_time(&b, none * unit - 1), none - 1);
        assert_int_equal(sph_bih_time(&b, none * unit), none);
        assert_int_equal(sph_bih_time(&b, (none + 1) * unit), none);
        assert_int_equal(sph_bih_time(&b, none * unit * 4), none);
    }
    const struct sph_bih_ray b = {.axis = {{.mant = 1 << 17, .shift = 17}}, .v_shift = 2};
    const struct sph_ray ray = {.dir = {1}};
    for (int32_t v = 4; v <= 8; v++) { /* a T-word is 4 units */
        struct sph_interval in = {0, SPH_BIH_NO_BOUND}, out = in;
        assert_int_equal(sph_bih_cut(&b, &ray, 0, v, 0, &in), 1);
        assert_int_equal(sph_bih_cut(&b, &ray, 0, v, 1, &out), 1);
        assert_int_equal(in.lo, v / 4);
        assert_int_equal(out.hi, (v + 3) / 4 + 1);
    }
}

/* A frame that begins behind all T-words is not met. */
static void frame_beyond(void **state) {
    const struct sph_profile *p = &sph_profiles[SPH_STANDARD];
    (void)state;
    for (int32_t x = 10; x <= 20000; x += 19990) {
        struct sph_ray ray = ray_to(SPH_PRIMARY, 1, 30000, 30000);
        const struct sph_box_frame frame = {.org = {x, -1, -1}};
        struct sph_bih_ray bih;
        struct sph_box_axis axes[3];
        sph_bih_setup(p, &ray, &bih);
        sph_box_axes(p, &bih, &ray, &frame, axes);
        assert_int_equal(axes[0].enter >= SPH_BOX_BEYOND, x > 10);
    }
}

/* A node that fits its child cuts the ray on both sides: what it reaches behind is not visited. */
static void fitting_nodes(void **state) {
    (void)state;
    struct sph_ray ray = ray_to(SPH_PRIMARY, 30000, 30000, 3);
    for (int32_t y = 500; y <= 2500; y += 1000) { /* the ray is at x 1000 to 2000 where y is */
        struct sph_machine m = empty(SPH_TREE_BIH);
        uint32_t errors;
        set_bih(&m, 0, 0, 0, 1, 1000, 2000, 1);
        set_bih(&m, 1, 0, 1, 1, y - 200, y + 200, 2);
        set_bih(&m, 2, 0, SPH_BIH_LEAF, 0, 0, 0, 0);
        assert_int_equal(visits_of(&m, &ray, &errors), y == 1500 ? 3 : 2);
        assert_int_equal(errors, 0);
    }
}

/* Where along a ray to a light a plane is, as a T-word. */
static uint32_t enters(const struct sph_ray *ray, int32_t x, uint32_t *limit) {
    struct sph_bih_ray planes;
    struct sph_interval span = {0, SPH_BIH_NO_BOUND};
    sph_bih_setup(&sph_profiles[SPH_STANDARD], ray, &planes);
    assert_int_equal(sph_bih_cut(&planes, ray, 0, x, 0, &span), 1);
    *limit = planes.limit;
    return span.lo;
}

/* What a ray enters with the T-word of its light may have a hit before it, what it enters with the
 * next one has none: the global box, a child. */
static void planes_at_the_light(void **state) {
    (void)state;
    int equal = 0, behind = 0;
    for (int32_t far = 20000; far < 20300; far++) {
        struct sph_ray ray = ray_to(SPH_SHADOW, 20000, 100, 3);
        struct sph_machine m = empty(SPH_TREE_BIH);
        uint32_t errors, limit, lo = enters(&ray, far, &limit);
        int before = lo <= limit;
        equal += lo == limit, behind += !before;
        set_bih(&m, 0, 0, 0, 1, far, 30000, 1);
        set_bih(&m, 1, 0, SPH_BIH_LEAF, 0, 0, 0, 0);
        assert_int_equal(visits_of(&m, &ray, &errors), 1 + before);
        m.regs[SPH_REG_BOX_X0] = far;
        assert_int_equal(visits_of(&m, &ray, &errors), before ? 2 : 0);
    }
    assert_true(equal > 0 && behind > 0);
}

/* A ray that enters through one plane where it leaves through another meets the box. */
static void corners_of_boxes(void **state) {
    (void)state;
    int equal = 0;
    for (int run = 0; run < 800; run++) {
        int32_t up = 20000 + run / 4, y = up * 10 / 19 + run % 4 - 2;
        struct sph_ray ray = ray_to(SPH_PRIMARY, 19000, up, 3);
        struct sph_bih_ray planes;
        const int32_t box[2][3] = {{10000, 0, -100}, {30000, y, 100}};
        struct sph_interval lo = {0, SPH_BIH_NO_BOUND}, hi = lo;
        struct sph_machine m = empty(SPH_TREE_BIH);
        uint32_t errors;
        sph_bih_setup(&m.profile, &ray, &planes);
        assert_true(sph_bih_cut(&planes, &ray, 0, box[0][0], 0, &lo) &&
                    sph_bih_cut(&planes, &ray, 1, y, 1, &hi));
        int met = lo.lo <= hi.hi;
        equal += lo.lo == hi.hi;
        set_bih(&m, 0, 0, SPH_BIH_LEAF, 0, 0, 0, 0);
        for (int i = 0; i < 3; i++) {
            m.regs[SPH_REG_BOX_X0 + i] = box[0][i];
            m.regs[SPH_REG_BOX_X1 + i] = box[1][i];
        }
        assert_int_equal(visits_of(&m, &ray, &errors), met);
    }
    assert_true(equal > 9 && equal < 400);
}

/* The depth of a T-word keeps its first bit and eleven behind it, and rises. */
static void depths_of_boxes(void **state) {
    (void)state;
    int32_t last = -1;
    for (uint32_t t = 0; t < 1u << 14; t++) {
        int32_t depth = sph_box_depth(t);
        assert_true(t < 1u << (SPH_BOX_NEAR + 1) ? depth == (int32_t)t
                                                 : depth == last || depth == last + 1);
        last = depth;
    }
}

static void set_child(uint32_t *line, int i, int32_t x, int32_t rad) {
    int at = i * SPH_CHILD_STRIDE;
    sph_field_set(line, at + SPH_CHILD_CTR_X_LSB, SPH_CHILD_CTR_X_BITS, (uint32_t)x);
    sph_field_set(line, at + SPH_CHILD_RAD_LSB, SPH_CHILD_RAD_BITS, (uint32_t)rad);
}

/* Children come by where they begin, equal ones as the node has them. */
static void order_of_children(void **state) {
    static const struct {
        int32_t near[4];
        int order[4];
    } cases[] = {{{10, 10, 10, 10}, {0, 1, 2, 3}},
                 {{11, 10, 11, 10}, {1, 3, 0, 2}},
                 {{13, 12, 11, 10}, {3, 2, 1, 0}},
                 {{10, 11, 12, 13}, {0, 1, 2, 3}},
                 {{12, 10, 12, 12}, {1, 0, 2, 3}}};
    (void)state;
    for (size_t n = 0; n < sizeof cases / sizeof *cases; n++)
        for (int any = 0; any < 2; any++) { /* for a shadow ray as the node has them */
            struct sph_machine m = empty(SPH_TREE_BALANCED);
            struct sph_ray ray = ray_to(any ? SPH_SHADOW : SPH_PRIMARY, 60000, 0, 0);
            struct sph_found found;
            sph_field_set(mem, SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS, 2);
            sph_field_set(mem, SPH_NODE_N_INNER_LSB, SPH_NODE_N_INNER_BITS, 4);
            for (int i = 0; i < 4; i++)
                set_child(mem, i, cases[n].near[i] + 2 + i, 2 + i);
            assert_int_equal(sph_visit(&m, &ray, NULL, 0, ray.depth_max, &found), 1);
            assert_int_equal(found.inner.count, 4);
            for (int i = 0; i < 4; i++)
                assert_int_equal(found.inner.list[i].child, any ? i : cases[n].order[i]);
            assert_true(sph_visit(&m, &ray, NULL, 0, 12, &found));
            for (int i = 0, seen = 0; i < 4; i++)
                if (cases[n].near[i] <= 12 && !any) seen++, assert_true(found.inner.count >= seen);
        }
}

/* A node has four children at most, and all of them lie in memory: else it is a bad node. */
static void nodes_that_are_bad(void **state) {
    static const struct {
        uint32_t base, inner, leaves;
        int good;
    } cases[] = {{2, 0, 0, 1}, {2, 4, 0, 1}, {3, 4, 0, 0}, {2, 3, 2, 0}, {2, 5, 0, 0},
                 {2, 0, 5, 0}, {2, 3, 1, 1}, {3, 3, 1, 0}, {4, 0, 4, 1}, {4, 0, 3, 1},
                 {5, 0, 3, 0}, {5, 0, 2, 1}, {5, 1, 1, 0}, {6, 0, 0, 1}, {7, 0, 0, 0}};
    (void)state;
    for (size_t n = 0; n < sizeof cases / sizeof *cases; n++) {
        struct sph_machine m = empty(SPH_TREE_BALANCED);
        struct sph_ray ray = ray_to(SPH_PRIMARY, 60000, 0, 0);
        struct sph_found found;
        uint32_t errors;
        sph_field_set(mem, SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS, cases[n].base);
        sph_field_set(mem, SPH_NODE_N_INNER_LSB, SPH_NODE_N_INNER_BITS, cases[n].inner);
        sph_field_set(mem, SPH_NODE_N_LEAF_LSB, SPH_NODE_N_LEAF_BITS, cases[n].leaves);
        for (int i = 0; i < 4; i++)
            set_child(mem, i, -3000, 0); /* behind the ray */
        assert_int_equal(sph_visit(&m, &ray, NULL, 0, ray.depth_max, &found), cases[n].good);
        assert_int_equal(visits_of(&m, &ray, &errors), 1);
        assert_int_equal(errors, cases[n].good ? 0 : BAD);
    }
}

/* A sphere of the filter counts as long as its near side is no deeper than the depth. */
static void filter_depth(void **state) {
    (void)state;
    for (int axis = 0; axis < 3; axis++) {
        struct sph_ray ray =
            ray_to(SPH_PRIMARY, axis == 0 ? -900 : 0, axis == 1 ? -900 : 0, axis == 2 ? -900 : 0);
        struct sph_child child = {{0, 0, 0}, 7};
        int32_t near;
        child.ctr[axis] = -30;
        assert_int_equal(sph_filter(&ray, &child, 23, &near), 1);
        assert_int_equal(near, 23);
        assert_int_equal(sph_filter(&ray, &child, 22, &near), 0);
    }
}

/* The axis is that of the largest component, of equal ones the first; and its sign. */
static void axis_of_a_ray(void **state) {
    static const struct {
        int dir[3], axis;
    } cases[] = {{{1, 0, 0}, 0}, {{0, 1, 0}, 1}, {{0, 0, 1}, 2}, {{1, 1, 0}, 0}, {{0, 1, 1}, 1},
                 {{1, 0, 1}, 0}, {{1, 1, 1}, 0}, {{1, 2, 2}, 1}, {{2, 1, 2}, 0}, {{2, 2, 1}, 0},
                 {{2, 3, 1}, 1}, {{1, 2, 3}, 2}, {{3, 2, 1}, 0}, {{3, 1, 2}, 0}, {{2, 1, 3}, 2}};
    (void)state;
    for (size_t n = 0; n < sizeof cases / sizeof *cases; n++)
        for (int signs = 0; signs < 8; signs++) {
            int64_t d[3];
            for (int i = 0; i < 3; i++)
                d[i] = cases[n].dir[i] * (signs >> i & 1 ? -10000 : 10000);
            struct sph_ray ray = ray_to(SPH_PRIMARY, d[0], d[1], d[2]);
            assert_int_equal(ray.axis, cases[n].axis);
            assert_int_equal(ray.negative, signs >> cases[n].axis & 1);
        }
}

/* A key has a depth, unless the direction is so short that its scale would go left: of diagonals
 * that are nearly as long as a power of two. */
static void depth_of_short_rays(void **state) {
    (void)state;
    int none = 0;
    for (int pr = 0; pr < SPH_PROFILES; pr++)
        for (int bit = 4; bit < sph_profiles[pr].wd - 1; bit++) {
            const struct sph_profile *p = &sph_profiles[pr];
            int64_t d = (int64_t)(0.577 * (1 << bit));
            struct sph_ray ray = {.skip = {SPH_ID_NONE, 0}, .dir = {-d, d, -d}};
            sph_ray_setup(p, &ray);
            none += ray.depth_shift < 0;
            assert_int_equal(sph_ray_depth(p, &ray, 1) == sph_depth_limit(p), ray.depth_shift < 0);
        }
    assert_true(none > 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(root_at_the_end),     cmocka_unit_test(bih_registers),
        cmocka_unit_test(fitting_nodes),       cmocka_unit_test(planes_at_the_light),
        cmocka_unit_test(depths_of_boxes),     cmocka_unit_test(corners_of_boxes),
        cmocka_unit_test(order_of_children),   cmocka_unit_test(nodes_that_are_bad),
        cmocka_unit_test(filter_depth),        cmocka_unit_test(axis_of_a_ray),
        cmocka_unit_test(depth_of_short_rays), cmocka_unit_test(bounds_of_words),
        cmocka_unit_test(frame_beyond),
    };
    return cmocka_run_group_tests_name("limits of a ray's way", tests, NULL, NULL);
}
