/* test_refit.c - trees of a sequence that are refitted: whole, and the picture of trees built anew
 * SPDX-License-Identifier: Apache-2.0
 *
 * build/test/test_refit [seed]
 */
#include "containment.h"

#include "core/frame.h"
#include "render/render.h"

enum { FRAMES = 6, TRIANGLES = 60, BALLS = 12 };

static const int trees[] = {SPH_TREE_BALANCED, SPH_TREE_REINSERTED, SPH_TREE_BIH, SPH_TREE_BOX4};
enum { TREES = sizeof trees / sizeof *trees };

static struct sph_scene some(uint32_t planes) {
    struct sph_scene s = bare();
    soup(&s, TRIANGLES, 0.3);
    for (uint32_t i = 0; i < planes; i++)
        add_plane(&s, at(uniform(), -uniform(), uniform()), near_to(at(0, 1, 0), 0.5));
    for (int i = 0; i < BALLS; i++)
        add_ball(&s, at(uniform(), uniform(), uniform()), 0.1);
    return s;
}

/* Everything to another place nearby, and another view. */
static void stir(struct sph_scene *s, double far) {
    for (uint32_t i = 0; i < s->n_spheres; i++)
        s->spheres[i].ctr = near_to(s->spheres[i].ctr, far);
    for (uint32_t i = 0; i < s->n_facets; i++) {
        struct sph_vec by = near_to(at(0, 0, 0), far);
        for (int k = 0; k < 3 && s->facets[i].kind == SPH_TRIANGLE; k++) {
            struct sph_vec *v = &s->facets[i].v[k];
            *v = near_to(at(v->x + by.x, v->y + by.y, v->z + by.z), far / 100);
        }
    }
    s->camera.from = near_to(s->camera.from, 3 * far);
}

static uint64_t picture(const struct sph_machine *m, uint64_t *visits) {
    struct sph_frame frame;
    struct sph_counters counters = {{0}};
    struct sph_error err = {{0}};
    struct sph_render_options how = {.threads = 1};
    assert_int_equal(sph_render(m, &how, &frame, &counters, &err), 0);
    uint64_t hash = sph_frame_picture_hash(&frame); /* of ids, keys and colours */
    *visits += counters.count[SPH_COUNT_NODE_VISITS];
    sph_frame_free(&frame);
    return hash;
}

/* A sequence; returns how many frames were refitted, and adds up visits of both ways. */
static int sequence(int tree, uint32_t planes, int how, double far, uint64_t visits[2]) {
    struct sph_kept_tree kept = {.how = how, .loss = 0.1};
    struct sph_build_options o = standard;
    int refitted = 0;
    o.tree = tree, o.profile = SPH_DRAFT + (int)planes % SPH_PROFILES, o.width = 32, o.height = 24;
    o.background = tree == SPH_TREE_BIH ? SPH_BG_NONE : SPH_BG_RECT;
    struct sph_scene s = some(planes);
    for (int frame = 0; frame < FRAMES; frame++) {
        struct sph_build_report report, alone;
        struct ancestors a = {0};
        o.kept = NULL;
        struct sph_machine one = built(&s, o, &alone);
        o.kept = &kept, o.later = frame > 0;
        struct sph_machine m = built(&s, o, &report);
        assert_false(alone.refitted);
        if (tree != SPH_TREE_BIH && tree != SPH_TREE_BOX4)
            assert_int_equal(check_below(&m, 0, &a), report.facets + s.n_spheres);
        if (tree == SPH_TREE_BOX4)
            assert_int_equal(check_boxes(&s, &m), report.facets + s.n_spheres);
        assert_true(picture(&m, &visits[0]) == picture(&one, &visits[1]));
        if (!frame || how == SPH_REFIT_OFF) assert_false(report.refitted);
        if (how == SPH_REFIT_AUTO && report.refitted)
            assert_true(report.tree_cost <= 1 + kept.loss);
        if (!report.refitted) {
            assert_true(report.tree_cost == 1);
            assert_int_equal(m.lines, one.lines);
            assert_memory_equal(m.mem, one.mem, (size_t)m.lines * SPH_LINE_WORDS * 4);
        }
        refitted += report.refitted;
        sph_machine_free(&m);
        sph_machine_free(&one);
        stir(&s, far);
    }
    sph_kept_free(&kept);
    return refitted;
}

static void test_pictures(void **unused) {
    (void)unused;
    for (int i = 0; i < TREES; i++)
        for (uint32_t planes = 0; planes < 5; planes += 2) {
            uint64_t visits[3][2] = {{0}};
            assert_int_equal(sequence(trees[i], planes, SPH_REFIT_OFF, 0.1, visits[0]), 0);
            assert_true(visits[0][0] == visits[0][1]);
            assert_int_equal(sequence(trees[i], planes, SPH_REFIT_ON, 0.1, visits[1]), FRAMES - 1);
            int some = sequence(trees[i], planes, SPH_REFIT_AUTO, 0.02, visits[2]);
            assert_in_range(some, 1, FRAMES - 1);
            printf("# tree %d, %u planes: %.3f times the visits of trees built anew; auto %.3f, %d "
                   "of %d\n",
                   trees[i], planes, (double)visits[1][0] / (double)visits[1][1],
                   (double)visits[2][0] / (double)visits[2][1], some, FRAMES);
        }
}

/* Far enough, and every tree costs too much. */
static void test_rule(void **unused) {
    (void)unused;
    for (int i = 0; i < TREES; i++) {
        uint64_t visits[2] = {0};
        assert_int_equal(sequence(trees[i], 0, SPH_REFIT_AUTO, 0.5, visits), 0);
        assert_true(visits[0] == visits[1]);
    }
}

/* Thin triangles that lie along x, or from corner to corner of their boxes. */
static void sticks(struct sph_scene *s, int aslant) {
    for (uint32_t i = 0; i < s->n_facets; i++) {
        struct sph_vec *v = s->facets[i].v, c = v[0];
        double l = 0.5, m = l / sqrt(3);
        v[1] = aslant ? at(c.x + m, c.y + m, c.z + m) : at(c.x + l, c.y, c.z);
        v[2] = at(v[1].x, v[1].y, v[1].z + 0.01);
    }
}

/* Sticks that turn where they are: their balls stay as they are, and their boxes do not. */
static void test_cost(void **unused) {
    static const int kinds[] = {SPH_TREE_REINSERTED, SPH_TREE_BOX4};
    (void)unused;
    for (int i = 0; i < 2; i++)
        for (int from = 0; from < 2; from++) {
            struct sph_kept_tree kept = {.how = SPH_REFIT_ON};
            struct sph_build_options o = standard;
            struct sph_build_report report;
            struct sph_scene s = bare();
            soup(&s, 200, 0.3);
            s.camera.from = at(0, 0, 5), s.camera.at = at(0, 0, 0), s.camera.up = at(0, 1, 0);
            for (uint32_t j = 0; j < s.n_facets; j++) /* bundles of ten */
                s.facets[j].v[0] = near_to(s.facets[j - j % 10].v[0], 0.02);
            o.tree = kinds[i], o.kept = &kept;
            for (int frame = 0; frame < 2; frame++) {
                sticks(&s, from ^ frame);
                struct sph_machine m = built(&s, o, &report);
                assert_int_equal(report.refitted, frame);
                sph_machine_free(&m);
            }
            printf("# tree %d, sticks turned %s: cost %.3f\n", kinds[i], from ? "back" : "aslant",
                   report.tree_cost);
            if (kinds[i] != SPH_TREE_BOX4) assert_true(fabs(report.tree_cost - 1) < 0.3);
            if (kinds[i] == SPH_TREE_BOX4)
                assert_true(from ? report.tree_cost < 0.7 : report.tree_cost > 1.6);
            sph_kept_free(&kept);
        }
}

/* Other primitives are another tree; the first hit depends on the tree; the paper's is its
 * own. */
static void test_others(void **unused) {
    (void)unused;
    for (int i = 0; i < TREES; i++)
        for (int change = 0; change < 5; change++) {
            struct sph_kept_tree kept = {.how = SPH_REFIT_ON};
            struct sph_build_options o = standard;
            struct sph_build_report report;
            struct sph_scene s = some(1);
            if (change == 3) s.n_facets = 0;
            if (change == 3 && (trees[i] == SPH_TREE_BIH || trees[i] == SPH_TREE_BOX4)) continue;
            o.tree = change == 4 ? SPH_TREE_PAPER : trees[i], o.kept = &kept,
            o.background = SPH_BG_NONE;
            if (change == 3) o.traverse = SPH_BUILD_FIRST;
            for (int frame = 0; frame < 2; frame++) {
                struct sph_machine m = built(&s, o, &report);
                assert_false(report.refitted);
                sph_machine_free(&m);
                if (change == 0) s.n_spheres--;
                if (change == 1) s.n_facets--; /* the plane */
                if (change == 2) {             /* a triangle becomes one */
                    s.facets[0].kind = SPH_PLANE;
                    s.facets[0].v[1] = at(0, 0, 1), s.facets[0].v[2] = at(1, 0, 0);
                }
            }
            sph_kept_free(&kept);
        }
}

/* Planes of a BIH reach as far as what is below them, and no farther. */
static struct sph_aabb check_planes(const struct sph_bih *b, const struct sph_aabb *boxes,
                                    uint32_t number) {
    const struct sph_bih_node *n = &b->nodes[number];
    struct sph_aabb all = {{INT32_MAX, INT32_MAX, INT32_MAX}, {INT32_MIN, INT32_MIN, INT32_MIN}};
    for (uint32_t i = 0; n->axis == SPH_BIH_LEAF && i < n->count; i++)
        for (int k = 0; k < 3; k++) {
            const struct sph_aabb *box = &boxes[b->order[n->first + i]];
            if (box->lo[k] < all.lo[k]) all.lo[k] = box->lo[k];
            if (box->hi[k] > all.hi[k]) all.hi[k] = box->hi[k];
        }
    if (n->axis == SPH_BIH_LEAF) return all;
    struct sph_aabb l = check_planes(b, boxes, n->child), r = l;
    if (!n->fit) r = check_planes(b, boxes, n->child + 1);
    assert_int_equal(n->clip_l, n->fit ? l.lo[n->axis] : l.hi[n->axis]);
    assert_int_equal(n->clip_r, n->fit ? r.hi[n->axis] : r.lo[n->axis]);
    for (int k = 0; k < 3; k++) {
        all.lo[k] = l.lo[k] < r.lo[k] ? l.lo[k] : r.lo[k];
        all.hi[k] = l.hi[k] > r.hi[k] ? l.hi[k] : r.hi[k];
    }
    return all;
}

static void test_bih(void **unused) {
    enum { MOST = 300 };
    (void)unused;
    for (uint32_t n = 0; n < MOST; n += 1 + n / 2)
        for (uint32_t prims = 1; prims < 9; prims *= 2)
            for (int how = SPH_BIH_FULL; how <= SPH_BIH_LISTING; how++) {
                struct sph_aabb boxes[MOST];
                struct sph_bih_options o = {prims, SPH_BIH_STACK + 1, how, NULL, 0};
                struct sph_bih bih;
                struct sph_error err = {{0}};
                for (int move = 0; move < 3; move++) {
                    for (uint32_t i = 0; i < n; i++)
                        for (int k = 0; k < 3; k++) {
                            boxes[i].lo[k] = (int32_t)between(-30000, 30000);
                            boxes[i].hi[k] = boxes[i].lo[k] + (int32_t)between(0, 900);
                        }
                    if (move)
                        sph_bih_refit(boxes, &bih);
                    else
                        assert_int_equal(sph_bih_build(boxes, n, &o, &bih, &err), 0);
                    if (!move) continue;
                    struct sph_aabb all = check_planes(&bih, boxes, 0);
                    assert_memory_equal(&all, &bih.box, sizeof all);
                }
                sph_bih_free(&bih);
            }
}

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_pictures), cmocka_unit_test(test_rule),
                                       cmocka_unit_test(test_cost), cmocka_unit_test(test_others),
                                       cmocka_unit_test(test_bih)};
    seed(argc, argv);
    return cmocka_run_group_tests_name("refit", tests, NULL, NULL);
}
