/* test_fast.c - the fast walk against the literal one: every pixel, counter and error
 * SPDX-License-Identifier: Apache-2.0
 *
 * Run from the root of the repository: reads scenes/. Each is drawn in one of three profiles and
 * trees; with ALL=1 in all.
 */
#include <glob.h>

#include "builder/box.h"
#include "fast/fast.h"
#include "fast/leaf.h"
#include "fast/pixel.h"
#include "fast/prepare.h"
#include "fast/root.h"
#include "fast/surface.h"
#include "fast/decoded.h"
#include "fast/tile.h"
#include "math/isqrt.h"
#include "model_scene.h"
#include "prim/sphere.h"
#include "scene/rng.h"
#include "untold.h"

enum { LANES = SPH_FAST_PLAIN + 1 };

static long frames, pixels, tiled; /* compared; frames in packets */

static uint64_t seed(void) {
    const char *text = getenv("SEED");
    return text ? strtoull(text, NULL, 0) : 1;
}

/* What a literal frame is compared with. */
struct expected {
    const char *what;
    const struct sph_machine *m;
    struct sph_frame frame;
    struct sph_counters c;
    struct sph_trail *trails; /* and as many for the other frame */
    int errors;
};

/* Renders in another way; fails with the first difference. */
static void same(const struct expected *e, const struct sph_fast *fast, int traverse) {
    size_t n = (size_t)e->frame.width * (size_t)e->frame.height;
    struct sph_render_options o = {
        .traverse = traverse, .threads = 1, .fast = fast, .trails = e->trails + n};
    struct sph_counters c = {{0}};
    struct sph_frame other;
    char what[256];
    int bits = sph_render(e->m, &o, &other, &c, NULL);
    snprintf(what, sizeof what, "%s, %s: %s%s", e->what, sph_machine_profile(e->m)->name,
             sph_fast_lanes(fast), traverse == SPH_TRAVERSE_PACKETS ? ", packets" : "");
    for (int i = 0; i < other.width * other.height; i++)
        if (memcmp(&e->frame.pixels[i], &other.pixels[i], sizeof *other.pixels)) {
            model_differ(what, e->m, &other, &e->frame);
            fail_msg("%s, pixel %d,%d: %u visits, expected %u", what, i % other.width,
                     i / other.width, other.pixels[i].visits, e->frame.pixels[i].visits);
        }
    for (int i = 0; i < SPH_COUNTERS; i++)
        if (c.count[i] != e->c.count[i])
            fail_msg("%s, counter %d is %lu, expected %lu", what, i, c.count[i], e->c.count[i]);
    for (size_t i = 0; i < n; i++)
        if (memcmp(&e->trails[i], &e->trails[n + i], sizeof *e->trails))
            fail_msg("%s: the trail of pixel %zu", what, i);
    if (bits != e->errors) fail_msg("%s: errors %x, expected %x", what, bits, e->errors);
    frames++;
    pixels += other.width * other.height;
    sph_frame_free(&other);
}

/* Renders literally and in the other ways. */
static void compare(const struct sph_machine *m, const char *what) {
    size_t n = (size_t)m->regs[SPH_REG_FRAME_W] * (size_t)m->regs[SPH_REG_FRAME_H];
    struct expected e = {.what = what, .m = m, .trails = calloc(2 * n, sizeof *e.trails)};
    struct sph_render_options literal = {
        .traverse = SPH_TRAVERSE_TREE, .threads = 1, .trails = e.trails};
    struct sph_fast *fast[LANES];
    int ways = sph_machine_bih(m) ? 1 : LANES;
    e.errors = sph_render(m, &literal, &e.frame, &e.c, NULL);
    for (int lanes = 0; lanes < ways; lanes++) {
        fast[lanes] = sph_fast_new(m, lanes);
        assert_non_null(fast[lanes]);
        same(&e, fast[lanes], SPH_TRAVERSE_FAST);
    }
    untell(&e.frame, &e.c);
    for (int lanes = 0; lanes < ways; lanes++) {
        same(&e, fast[lanes], SPH_TRAVERSE_PACKETS);
        tiled += sph_fast_tiles(m, fast[lanes]);
        sph_fast_free(fast[lanes]);
    }
    free(e.trails);
    sph_frame_free(&e.frame);
}

/* A scene in a profile and tree, as it asks and with other effects of rays; 0: too fine for it. */
static int scene_in(const struct sph_scene *scene, const char *path, int profile, int tree) {
    static const int turned[] = {1 << SPH_EFFECT_INSIDE, 1 << SPH_EFFECT_FIRST,
                                 1 << SPH_EFFECT_FIRST | 1 << SPH_EFFECT_INTERPENETRATE,
                                 1 << SPH_EFFECT_SHADOW | 1 << SPH_EFFECT_REFLECT};
    struct sph_machine m;
    if (!model_build(scene, profile, tree, SPH_BG_NONE, SANITIZED ? 8 : 32, SANITIZED ? 5 : 18, &m))
        return 0;
    int effects = m.regs[SPH_REG_EFFECTS];
    compare(&m, path);
    for (size_t i = 0; i < sizeof turned / sizeof *turned; i++) {
        m.regs[SPH_REG_EFFECTS] = effects ^ turned[i];
        compare(&m, path);
    }
    m.regs[SPH_REG_EFFECTS] = effects;
    m.regs[SPH_REG_LEAST_WEIGHT] = effects >> SPH_EFFECT_REFLECT & 1 ? 40 : 0;
    compare(&m, path);
    m.regs[SPH_REG_LEAST_WEIGHT] = 0;
    struct sph_profile cut = m.profile;
    cut.pr = cut.w;
    sph_machine_set_profile(&m, &cut);
    compare(&m, path);
    sph_machine_free(&m);
    return 1;
}

static void every_scene(void **state) {
    static const char *const patterns[] = {"scenes/*.nff", "scenes/facets/*.nff",
                                           "scenes/refraction/*.nff", "tests/scenes/facets/*.nff"};
    static const int trees[] = {SPH_TREE_PAPER, SPH_TREE_BALANCED, SPH_TREE_REINSERTED,
                                SPH_TREE_BIH,   SPH_TREE_BRUTE,    SPH_TREE_BOX4};
    int drawn = 0;
    glob_t found = {0};
    (void)state;
    for (size_t i = 0; i < sizeof patterns / sizeof *patterns; i++)
        assert_int_equal(glob(patterns[i], i ? GLOB_APPEND : 0, NULL, &found), 0);
    for (size_t i = 0; i < found.gl_pathc; i++) {
        struct sph_scene scene = read_scene(found.gl_pathv[i]);
        for (int p = 0; p < SPH_PROFILES; p++)
            for (int t = 0; t < (int)(sizeof trees / sizeof *trees); t++)
                if (getenv("ALL") || (i + (size_t)p + (size_t)t) % 3 == 0)
                    drawn += scene_in(&scene, found.gl_pathv[i], p, trees[t]);
        sph_scene_free(&scene);
    }
    assert_true(drawn > 60);
    globfree(&found);
}

/* The root its own children, each as large as can be: a stack that is full. */
static void circle(int tree) {
    struct sph_scene scene = model_scene("paper100");
    struct sph_machine m;
    assert_true(model_build(&scene, SPH_STANDARD, tree, SPH_BG_NONE, 6, 4, &m));
    uint32_t root = (uint32_t)m.regs[SPH_REG_ROOT], *line = sph_line(&m, root);
    for (uint32_t children = 1; children <= 4; children++) {
        memset(line, 0, SPH_LINE_WORDS * sizeof *line);
        sph_field_set(line, SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS, root);
        sph_field_set(line, SPH_NODE_N_INNER_LSB, SPH_NODE_N_INNER_BITS, children);
        if (tree == SPH_TREE_BOX4) {
            int32_t end = 1 << (m.profile.w - 1);
            struct sph_aabb whole = {{-end, -end, -end}, {end, end, end}};
            struct sph_aabb boxes[4] = {whole, whole, whole, whole};
            sph_box_put(line, boxes, (int)children, &m.profile);
        }
        for (int i = 0; i < (int)children && tree != SPH_TREE_BOX4; i++)
            sph_field_set(line, i * SPH_CHILD_STRIDE + SPH_CHILD_RAD_LSB, SPH_CHILD_RAD_BITS,
                          (1u << SPH_CHILD_RAD_BITS) - 1);
        for (m.regs[SPH_REG_VISIT_LIMIT] = 10; m.regs[SPH_REG_VISIT_LIMIT] < 20;
             m.regs[SPH_REG_VISIT_LIMIT]++)
            compare(&m, "circles");
    }
    sph_machine_free(&m);
    sph_scene_free(&scene);
}

static void circles(void **state) {
    (void)state;
    circle(SPH_TREE_BALANCED);
    circle(SPH_TREE_BOX4);
}

/* A number -n .. n. */
static int64_t small(struct sph_rng *rng, int n) {
    return (int64_t)(sph_rng_next(rng) >> 8) % (2 * n + 1) - n;
}

/* Spheres and rays of few bits, so that each comparison meets both sides equal. */
static void spheres(void **state) {
    struct sph_rng rng = {seed()};
    struct sph_machine m = {.profile = sph_profiles[SPH_DRAFT]};
    (void)state;
    for (int i = 0; i < (SANITIZED ? 20000 : 400000); i++) {
        struct sph_leaf s = {.rad = small(&rng, 2) + 3, .id = (uint32_t)small(&rng, 1) + 1};
        struct sph_ray ray = {.kind = (int)(sph_rng_next(&rng) >> 8 & 1),
                              .skip = {(uint32_t)small(&rng, 1) + 1, (int)small(&rng, 1) > 0},
                              .inside = (int)small(&rng, 1) >= 0};
        for (int k = 0; k < 3; k++) {
            s.ctr[k] = small(&rng, 3);
            ray.org[k] = small(&rng, 3);
            ray.dir[k] = small(&rng, 3);
            ray.a += (uint64_t)(ray.dir[k] * ray.dir[k]);
        }
        uint32_t record[SPH_LINE_WORDS] = {0}, errors = 0;
        for (int k = 0; k < 3; k++)
            sph_field_set(record, SPH_LEAF_CTR_X_LSB + k * SPH_LEAF_CTR_X_BITS, SPH_LEAF_CTR_X_BITS,
                          (uint32_t)s.ctr[k]);
        sph_field_set(record, SPH_LEAF_RAD_LSB, SPH_LEAF_RAD_BITS, (uint32_t)s.rad);
        sph_field_set(record, SPH_LEAF_ID_LSB, SPH_LEAF_ID_BITS, s.id);
        m.profile.pr = i % 5 ? 0 : 4;
        struct sph_counters c[2] = {{{0}}, {{0}}};
        struct sph_probe literal = sph_probe_of(&m, &ray, &c[0], &errors);
        struct sph_probe fast = sph_probe_of(&m, &ray, &c[1], &errors);
        struct sph_fast_leaf leaf = {
            {(int32_t)s.ctr[0], (int32_t)s.ctr[1], (int32_t)s.ctr[2]}, (int32_t)s.rad, s.id, 0};
        if (i & 1) literal.best = fast.best = (struct sph_hit){5, 1, 0};
        sph_leaf_visit(&literal, record);
        sph_fast_leaf_visit(&fast, &leaf, record);
        assert_int_equal(fast.best.key, literal.best.key);
        assert_int_equal(fast.best.id, literal.best.id);
        assert_int_equal(fast.best.far, literal.best.far);
        assert_int_equal(c[1].count[SPH_COUNT_ROOTS], c[0].count[SPH_COUNT_ROOTS]);
    }
}

/* A number of at most `bits` bits and a sign, of any length. */
static int64_t any(struct sph_rng *rng, int bits) {
    uint64_t r = sph_rng_next(rng) >> 2;
    int length = (int)(sph_rng_next(rng) >> 8) % (bits + 1);
    int64_t size = (int64_t)(r & ((1ull << (length < 0 ? -length : length)) - 1));
    return sph_rng_next(rng) >> 9 & 1 ? -size : size;
}

/* A corner or an origin: of few bits, so that each comparison meets both sides equal, of any
 * length, or at an end of the grid. */
static int64_t coordinate(struct sph_rng *rng, int w, int way) {
    int64_t half = 1ll << (w - 1);
    if (way == 0) return small(rng, 2);
    if (way == 1) return any(rng, w - 1);
    return sph_rng_next(rng) >> 9 & 1 ? half - 1 : -half;
}

/* Triangles of the profiles whose products have room in 64 bits; half of the rays go to a corner
 * or the middle of an edge. */
static void triangles(void **state) {
    struct sph_rng rng = {seed()};
    struct sph_machine m = {.regs[SPH_REG_EFFECTS] = 1 << SPH_EFFECT_FACETS};
    static const int at[3] = {SPH_TRIANGLE_V0_X_LSB, SPH_TRIANGLE_V1_X_LSB, SPH_TRIANGLE_V2_X_LSB};
    int hits = 0;
    (void)state;
    assert_false(sph_fast_triangles_fit(&sph_profiles[SPH_REFERENCE]));
    for (int i = 0; i < (SANITIZED ? 30000 : 600000); i++) {
        const struct sph_profile *p = &sph_profiles[i % 3];
        int way = i / 3 % 3, far = way && i & 1;
        struct sph_ray ray = {.kind = (int)(sph_rng_next(&rng) >> 8 & 1),
                              .skip = {(uint32_t)small(&rng, 2) + 2, 0}};
        uint32_t record[SPH_LINE_WORDS] = {0}, errors = 0;
        assert_true(sph_fast_triangles_fit(p));
        m.profile = *p;
        int to = (int)((sph_rng_next(&rng) >> 9) % 3), aimed = i / 9 & 1;
        for (int k = 0; k < 3; k++) {
            int64_t most = (1ll << (p->wd - 1)) - 1, up = sph_rng_next(&rng) >> 9 & 1 ? 1 : -1;
            ray.org[k] = coordinate(&rng, p->w, way);
            ray.dir[k] = far ? up * most : way ? any(&rng, p->wd - 1) : small(&rng, 3);
            int64_t v[3];
            for (int c = 0; c < 3; c++) {
                v[c] = coordinate(&rng, p->w, way);
                sph_field_set(record, at[c] + k * SPH_LEAF_CTR_Y_LSB, SPH_LEAF_CTR_X_BITS,
                              (uint32_t)v[c]);
            }
            if (aimed) ray.dir[k] = (v[0] + v[to]) / 2 - ray.org[k];
            ray.lift[k] = small(&rng, 2);
            ray.a += (uint64_t)(ray.dir[k] * ray.dir[k]);
        }
        sph_field_set(record, SPH_FACET_KIND_LSB, SPH_FACET_KIND_BITS, SPH_TRIANGLE);
        sph_field_set(record, SPH_FACET_ID_LSB, SPH_FACET_ID_BITS, (uint32_t)small(&rng, 1) + 2);
        sph_field_set(record, SPH_FACET_BEFORE_LSB, SPH_FACET_BEFORE_BITS, (uint32_t)i & 1);
        sph_field_set(record, SPH_FACET_AFTER_LSB, SPH_FACET_AFTER_BITS, (uint32_t)i >> 1 & 1);
        struct sph_counters c[2] = {{{0}}, {{0}}};
        struct sph_probe literal = sph_probe_of(&m, &ray, &c[0], &errors);
        struct sph_probe fast = sph_probe_of(&m, &ray, &c[1], &errors);
        struct sph_fast_triangle triangle;
        if (i & 2) literal.best = fast.best = (struct sph_hit){5, 2, 0};
        sph_fast_triangle_read(p, record, &triangle);
        assert_true(triangle.known);
        sph_leaf_visit(&literal, record);
        sph_fast_triangle_visit(&fast, &triangle);
        assert_int_equal(fast.best.key, literal.best.key);
        assert_int_equal(fast.best.id, literal.best.id);
        assert_int_equal(fast.best.far, literal.best.far);
        assert_memory_equal(&c[0], &c[1], sizeof *c);
        hits += literal.best.key && literal.best.key != 5;
    }
    printf("# %d hits of triangles\n", hits);
    assert_true(hits > 1000);
}

/* Set-up, point and normal of rays in widths of any kind: the same words. */
static void surfaces(void **state) {
    struct sph_rng rng = {seed()};
    int done = 0;
    (void)state;
    for (int i = 0; i < (SANITIZED ? 40000 : 600000); i++) {
        struct sph_profile p = sph_profiles[i % SPH_PROFILES];
        if (i % 3) {
            p.w = 8 + (int)(sph_rng_next(&rng) >> 8) % 9 + 8 * (i % 2);
            p.wd = p.w + 1 + (int)(sph_rng_next(&rng) >> 9 & 3);
            p.pq = 4 + (int)(sph_rng_next(&rng) >> 9 & 15) + 12 * (i % 2);
            p.ng = (int)(sph_rng_next(&rng) >> 9 & 3);
            p.fw = p.w < 14 ? p.w : 14;
        }
        if (sph_profile_check(&p, NULL)) continue;
        struct sph_ray a = {.kind = (int)(sph_rng_next(&rng) >> 9 & 3)}, b;
        struct sph_surface s, t;
        struct sph_leaf sphere;
        for (int k = 0; k < 3; k++) {
            a.org[k] = any(&rng, p.w - 1);
            a.dir[k] = any(&rng, p.wd - 1);
            sphere.ctr[k] = any(&rng, p.w - 1);
        }
        b = a;
        sph_ray_setup(&p, &a);
        sph_fast_prepare(&p, &b);
        assert_memory_equal(&a, &b, sizeof a);
        done++;
        struct sph_hit hit = {(uint64_t)any(&rng, p.w + p.wd + 1) | 1, 0, i & 1};
        hit.key = hit.key >> 63 ? -hit.key : hit.key;
        memset(&s, 0, sizeof s);
        memset(&t, 0, sizeof t);
        assert_int_equal(sph_fast_surface(&p, &b, &hit, sphere.ctr, &t),
                         sph_surface_at(&p, &a, &hit, &sphere, &s));
        assert_memory_equal(&s, &t, sizeof s);
    }
    assert_true(done > 10000);
}

/* Rays that are set up together, in widths of any kind, at the ends of their widths and, of a
 * damaged machine, beyond: the same words as one by one. */
static void together(void **state) {
    enum { MOST = 2 * SPH_TOGETHER + 3 };
    struct sph_rng rng = {seed()};
    struct sph_scene scene = model_scene("paper5");
    struct sph_machine m;
    struct sph_fast *fast[LANES];
    (void)state;
    assert_true(model_build(&scene, SPH_STANDARD, SPH_TREE_BALANCED, SPH_BG_NONE, 4, 4, &m));
    for (int lanes = 0; lanes < LANES; lanes++)
        assert_non_null(fast[lanes] = sph_fast_new(&m, lanes));
    for (int i = 0; i < (SANITIZED ? 4000 : 60000); i++) {
        struct sph_ray rays[1 + LANES][MOST];
        struct sph_profile p = sph_profiles[i % SPH_PROFILES];
        int n = 1 + (int)((sph_rng_next(&rng) >> 9) % MOST), wild = i % 7 == 0;
        if (i % 3 == 0) p.wd += (int)(sph_rng_next(&rng) >> 9 & 3);
        m.profile = p;
        for (int j = 0; j < n; j++) {
            struct sph_ray *a = memset(&rays[0][j], 0, sizeof *a);
            int64_t most = 1ll << (p.wd - 1);
            a->kind = (int)(sph_rng_next(&rng) >> 9 & 3);
            a->inside = (int)(sph_rng_next(&rng) >> 9 & 1);
            a->first = (int)(sph_rng_next(&rng) >> 9 & 1);
            for (int k = 0; k < 3; k++) {
                int way = (int)(sph_rng_next(&rng) >> 9 & 7);
                a->org[k] = coordinate(&rng, p.w, way % 3);
                a->dir[k] = way == 0   ? -most
                            : way == 1 ? most - 1
                            : way == 2 ? a->dir[0]
                            : way == 3 ? small(&rng, 1)
                                       : any(&rng, p.wd - 1);
                a->lift[k] = small(&rng, 100);
            }
            if (wild && small(&rng, 8) == 0) a->dir[(i >> 3) % 3] = most + small(&rng, 9) / 3;
            if (wild && small(&rng, 8) == 0) a->dir[j % 3] = any(&rng, 32);
            if (wild && small(&rng, 8) == 0) a->org[(i >> 3) % 3] = any(&rng, 31);
        }
        for (int lanes = 0; lanes < LANES; lanes++) {
            memcpy(rays[1 + lanes], rays[0], sizeof rays[0]);
            sph_fast_prepare_all(fast[lanes], rays[1 + lanes], n);
        }
        for (int j = 0; j < n; j++) {
            sph_ray_setup(&p, &rays[0][j]);
            for (int lanes = 0; lanes < LANES; lanes++)
                assert_memory_equal(&rays[1 + lanes][j], &rays[0][j], sizeof rays[0][j]);
        }
    }
    for (int lanes = 0; lanes < LANES; lanes++)
        sph_fast_free(fast[lanes]);
    sph_machine_free(&m);
    sph_scene_free(&scene);
}

/* Bits of memory turned over, limits of visits, registers beyond memory: the same errors. */
static void damage(struct sph_machine *m, const char *name, int times) {
    struct sph_rng rng = {seed()};
    size_t bytes = (size_t)m->lines * SPH_LINE_WORDS * sizeof *m->mem;
    uint32_t *sound = malloc(bytes);
    int effects = m->regs[SPH_REG_EFFECTS], root = m->regs[SPH_REG_ROOT];
    memcpy(sound, m->mem, bytes);
    for (int i = 0; i < times; i++) {
        uint64_t flips = 1 + sph_rng_next(&rng) % 40, turn = sph_rng_next(&rng);
        memcpy(m->mem, sound, bytes);
        for (uint64_t j = 0; j < flips; j++) {
            uint64_t r = sph_rng_next(&rng);
            m->mem[(r >> 5) % (m->lines * SPH_LINE_WORDS)] ^= 1u << (r & 31);
        }
        m->regs[SPH_REG_VISIT_LIMIT] = turn & 1 ? 200 : (int32_t)(turn >> 8 & 7);
        m->regs[SPH_REG_EFFECTS] = effects ^ (int)(turn >> 1 & 1) << SPH_EFFECT_FIRST;
        m->regs[SPH_REG_ROOT] =
            turn >> 16 & 15 ? root : (int32_t)((turn >> 20) % (m->lines + 2ull));
        compare(m, name);
    }
    memcpy(m->mem, sound, bytes);
    m->regs[SPH_REG_ROOT] = -1;
    compare(m, name);
    free(sound);
}

static void damaged(void **state) {
    static const char *const names[] = {"scenes/interpenetrating.nff", "scenes/paper100.nff",
                                        "tests/scenes/facets/mixed.nff"};
    (void)state;
    static const int trees[] = {SPH_TREE_BALANCED, SPH_TREE_BIH, SPH_TREE_BOX4};
    enum { TREES = sizeof trees / sizeof *trees };
    for (size_t i = 0; i < TREES * sizeof names / sizeof *names; i++) {
        const char *name = names[i / TREES];
        struct sph_scene scene = read_scene(name);
        struct sph_machine m;
        int tree = trees[i % TREES];
        assert_true(model_build(&scene, SPH_STANDARD, tree, SPH_BG_NONE, 12, 7, &m));
        damage(&m, name, SANITIZED ? 30 : 200);
        m.regs[SPH_REG_N_LOOSE] = m.regs[SPH_REG_N_PRIMS] + 1;
        compare(&m, name);
        sph_machine_free(&m);
        sph_scene_free(&scene);
    }
    printf("# SEED=%lu: %ld frames, %ld pixels, %ld in packets\n", seed(), frames, pixels, tiled);
    assert_true(tiled > 100);
}

/* Each ray of a bundle by itself and in the packet. */
static void check_bundle(const struct sph_machine *m, const struct sph_fast *fast,
                         const struct sph_bundle *b) {
    struct sph_hit hits[SPH_PACKET];
    uint64_t hidden = 0;
    if (b->kind == SPH_PRIMARY)
        sph_packet_nearest(fast, b, hits);
    else
        hidden = sph_packet_hidden(fast, b);
    assert_int_equal(b->n < SPH_PACKET ? hidden >> b->n : 0, 0);
    for (int i = 0; i < b->n; i++) {
        struct sph_ray ray = {.kind = b->kind, .inside = b->inside, .skip = {SPH_ID_NONE, 0}};
        struct sph_counters c = {{0}};
        uint32_t visits = 0, errors = 0;
        if (b->kind == SPH_SHADOW) ray.skip = b->skip[i];
        for (int k = 0; k < 3; k++) {
            ray.org[k] = b->org[k][i];
            ray.dir[k] = b->dir[k][i];
        }
        sph_ray_setup(sph_machine_profile(m), &ray);
        struct sph_hit hit = sph_traverse(m, &ray, SPH_TRAVERSE_TREE, &c, &visits, &errors);
        if (b->kind == SPH_SHADOW) {
            assert_int_equal(hidden >> i & 1, hit.key != 0);
            continue;
        }
        assert_int_equal(hits[i].key, hit.key);
        assert_int_equal(hits[i].id, hit.id);
        assert_int_equal(hits[i].far, hit.far);
    }
}

/* Rays past a sphere that touch it, its centre 5 s away along an axis, its radius 3 s: 4 along the
 * axis and 3 across; rays through its centre; rays beside them, from other points and in other
 * directions. */
static void touch(struct sph_rng *rng, const struct sph_machine *m, const struct sph_fast *fast) {
    int wd = sph_machine_profile(m)->wd, w = sph_machine_profile(m)->w;
    uint32_t n = (uint32_t)m->regs[SPH_REG_N_PRIMS];
    struct sph_bundle b = {.kind = (int)(sph_rng_next(rng) >> 9 & 1),
                           .inside = (int)(sph_rng_next(rng) >> 9 & 1),
                           .n = 1 + (int)(sph_rng_next(rng) >> 9 & 63)};
    uint32_t id = (uint32_t)(sph_rng_next(rng) >> 9) % n;
    struct sph_leaf s = sph_sphere_read(sph_line(m, (uint32_t)m->regs[SPH_REG_PRIM_BASE] + id), w);
    int axis = (int)((sph_rng_next(rng) >> 9) % 3), mixed = small(rng, 4) == 0;
    int64_t sign = sph_rng_next(rng) >> 9 & 1 ? 1 : -1, most = (1ll << (wd - 1)) / 4 - 2;
    int64_t org[3];
    for (int k = 0; k < 3; k++)
        org[k] = s.ctr[k] - (k == axis ? sign * 5 * (s.rad / 3) : 0);
    for (int i = 0; i < b.n; i++) {
        int across = (axis + 1 + (int)(sph_rng_next(rng) >> 9 & 1)) % 3;
        int64_t of = 1 + (int64_t)(sph_rng_next(rng) >> 9) % most, shift = small(rng, 2);
        int64_t aside = small(rng, 1) ? sph_rng_next(rng) >> 9 & 1 ? 3 : -3 : 0;
        b.skip[i] = (struct sph_skip){(uint32_t)((sph_rng_next(rng) >> 9) % n), small(rng, 5) == 0};
        for (int k = 0; k < 3; k++) {
            int64_t from = org[k] + (b.kind == SPH_SHADOW ? small(rng, 2) : 0);
            int64_t limit = 1ll << (w - 1);
            b.org[k][i] = (int32_t)(from >= limit ? limit - 1 : from < -limit ? -limit : from);
            b.dir[k][i] = (int32_t)(k == axis ? 4 * sign * of : k == across ? aside * of : 0);
            if (shift == 1) b.dir[k][i] += (int32_t)small(rng, 1);
            if (mixed) b.dir[k][i] = (int32_t)any(rng, wd - 2);
        }
        if (mixed && b.kind == SPH_PRIMARY && !b.dir[0][i]) b.dir[0][i] = 1;
    }
    check_bundle(m, fast, &b);
}

static void bundles(void **state) {
    static const char *const names[] = {"scenes/interpenetrating.nff", "scenes/paper100.nff",
                                        "tests/scenes/touching.nff"};
    enum { NAMES = sizeof names / sizeof *names };
    struct sph_rng rng = {seed()};
    (void)state;
    for (int i = 0; i < SPH_PROFILES * NAMES; i++) {
        struct sph_scene scene = read_scene(names[i % NAMES]);
        struct sph_machine m;
        if (!model_build(&scene, i / NAMES, SPH_TREE_BALANCED, SPH_BG_NONE, 12, 7, &m)) continue;
        for (int lanes = 0; lanes < LANES; lanes++) {
            struct sph_fast *fast = sph_fast_new(&m, lanes);
            assert_true(sph_packets_fit(fast));
            for (int k = 0; k < (SANITIZED ? 100 : 2000); k++)
                touch(&rng, &m, fast);
            sph_fast_free(fast);
        }
        sph_machine_free(&m);
        sph_scene_free(&scene);
    }
}

/* Nodes that do not hold what is below them, children that are met twice, and a limit that a ray
 * could reach: no packets. */
static void unsound(void **state) {
    struct sph_scene scene = model_scene("paper100");
    struct sph_machine m;
    (void)state;
    assert_true(model_build(&scene, SPH_STANDARD, SPH_TREE_BALANCED, SPH_BG_NONE, 12, 7, &m));
    uint32_t *root = sph_line(&m, (uint32_t)m.regs[SPH_REG_ROOT]);
    uint32_t kept[SPH_LINE_WORDS];
    int32_t limit = m.regs[SPH_REG_VISIT_LIMIT];
    memcpy(kept, root, sizeof kept);
    for (int i = 0; i < 4; i++) {
        uint32_t rad = sph_field(root, SPH_CHILD_RAD_LSB, SPH_CHILD_RAD_BITS);
        if (i == 1) sph_field_set(root, SPH_CHILD_RAD_LSB, SPH_CHILD_RAD_BITS, rad / 2);
        if (i == 2)
            sph_field_set(root, SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS,
                          (uint32_t)m.regs[SPH_REG_ROOT]);
        if (i == 3) m.regs[SPH_REG_VISIT_LIMIT] = 3;
        struct sph_fast *fast = sph_fast_new(&m, SPH_FAST_BEST);
        assert_int_equal(sph_packets_fit(fast), i == 0);
        sph_fast_free(fast);
        memcpy(root, kept, sizeof kept);
        m.regs[SPH_REG_VISIT_LIMIT] = limit;
    }
    sph_machine_free(&m);
    sph_scene_free(&scene);
}

static void check_root(sph_u128 x, int bits) {
    int inexact, expected;
    uint64_t root = sph_fast_isqrt_bits(x, bits, &inexact);
    assert_int_equal(root, sph_isqrt_bits(x, bits, &expected));
    assert_int_equal(inexact, expected);
}

/* Every small radicand; squares, what lies beside them and halfway, of every length. */
static void roots(void **state) {
    struct sph_rng rng = {seed()};
    (void)state;
    for (uint32_t x = 0; x < (SANITIZED ? 5000 : 300000); x++)
        check_root(x, (int)(x % 12));
    for (int length = 1; length <= 62; length++)
        for (uint64_t i = 0; i < (SANITIZED ? 30 : 2000); i++) {
            uint64_t most = (1ull << length) - 1;
            uint64_t root = i < 9 ? most - i : sph_rng_next(&rng) & most;
            if (i >= 9 && i < 18) root = (1ull << (length - 1)) + i - 9;
            if (root > most) continue;
            sph_u128 square = (sph_u128)root * root;
            int bits = i % 3 ? 0 : 4 + (int)(i % 48);
            check_root(square, bits);
            if (square) check_root(square - 1, bits);
            check_root(square + 1, bits);
            check_root(square + root, bits);
            check_root(square + 2 * root, bits);
        }
}

/* The fast walk shades no more than what it knows, and all of that. */
static void known_effects(void **state) {
    (void)state;
    const uint32_t all = 1 << SPH_EFFECT_SHADOW | 1 << SPH_EFFECT_REFLECT | 1 << SPH_EFFECT_INSIDE |
                         1 << SPH_EFFECT_FIRST | 1 << SPH_EFFECT_TURNED;
    for (int bit = 0; bit < 32; bit++) {
        const struct sph_machine m = {.regs = {[SPH_REG_EFFECTS] = (int32_t)(1u << bit)}};
        assert_int_equal(sph_fast_shades(&m), all >> bit & 1);
    }
}

/* What no walk here knows is left to the literal one. */
static void unknown_trees(void **state) {
    struct sph_scene scene = model_scene("paper5");
    struct sph_machine m;
    struct sph_counters c, expected;
    int errors, literal;
    (void)state;
    assert_true(model_build(&scene, SPH_STANDARD, SPH_TREE_PAPER, SPH_BG_NONE, 12, 7, &m));
    m.regs[SPH_REG_TREE] = 0;
    assert_null(sph_fast_new(&m, SPH_FAST_BEST));
    struct sph_frame a = model_render(&m, SPH_TRAVERSE_FAST, 1, &c, &errors);
    struct sph_frame b = model_render(&m, SPH_TRAVERSE_TREE, 1, &expected, &literal);
    assert_int_equal(model_differ("no tree", &m, &a, &b), 0);
    assert_memory_equal(&c, &expected, sizeof c);
    assert_int_equal(errors, literal);
    sph_frame_free(&a);
    sph_frame_free(&b);
    sph_machine_free(&m);
    sph_scene_free(&scene);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(roots),    cmocka_unit_test(spheres),  cmocka_unit_test(triangles),
        cmocka_unit_test(surfaces), cmocka_unit_test(together), cmocka_unit_test(every_scene),
        cmocka_unit_test(circles),  cmocka_unit_test(damaged),  cmocka_unit_test(unknown_trees),
        cmocka_unit_test(bundles),  cmocka_unit_test(unsound),  cmocka_unit_test(known_effects)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
