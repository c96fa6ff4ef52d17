/* test_bih_walk.c - rays through a BIH find what testing everything finds
 * SPDX-License-Identifier: Apache-2.0
 *
 * Run from the root of the repository: reads tests/scenes/facets/ and scenes/.
 */
#include "build_scene.h"
#include "model_scene.h"
#include "vectors.h"

#include "builder/grid/near.h"
#include "naive/naive.h"
#include "scene/edit.h"
#include "prim/sphere.h"
#include "trace/traverse.h"
#include "trace/setup.h"

enum { RAYS = 2500 / VEC_SHARE, TINY = SPH_PROFILES, CUT, COARSE, KINDS };

/* Widths of their own: no filter or multiplier is so small; roots cut; a point off by 70 units. */
static const char *const widths[] = {"draft:w=9,wd=10,pq=12,ng=1,fw=9", "standard:pr=6",
                                     "standard:pq=12"};

static struct sph_build_options options(int kind, struct sph_profile *p) {
    struct sph_build_options o = standard;
    struct sph_error err = {{0}};
    o.background = SPH_BG_NONE;
    o.shadow = o.inside = o.reflect = SPH_ON;
    if (kind < SPH_PROFILES) {
        o.profile = kind;
    } else {
        if (sph_profile_parse(widths[kind - SPH_PROFILES], p, &err)) fail_msg("%s", err.text);
        o.widths = p;
    }
    return o;
}

/* A ray in the grid: from anywhere, from a sphere's surface or its middle, or as far out of its own
 * sphere as a rounded point may be. */
static struct sph_ray ray_of(struct sph_rng *rng, const struct sph_machine *m) {
    const struct sph_profile *p = sph_machine_profile(m);
    struct sph_ray ray;
    vec_ray(rng, p, &ray);
    ray.kind = (int)vec_pick(rng, SPH_PRIMARY, SPH_REFLECTED);
    ray.inside = (int)vec_pick(rng, 0, 1);
    uint32_t id = (uint32_t)vec_pick(rng, 0,
                                     m->regs[SPH_REG_N_SPHERES] ? m->regs[SPH_REG_N_SPHERES] - 1
                                                                : m->regs[SPH_REG_N_PRIMS] - 1);
    struct sph_leaf s =
        sph_sphere_read(m->mem + ((size_t)m->regs[SPH_REG_PRIM_BASE] + id) * SPH_LINE_WORDS, p->w);
    int family = (int)vec_pick(rng, 0, 5);
    int64_t error = sph_point_error(p) >> sph_error_bits(p), half = 1ll << (p->w - 1);
    int axis = (int)vec_pick(rng, 0, 2), sign = vec_pick(rng, 0, 1) ? 1 : -1;
    for (int i = 0; i < 3 && family > 1; i++) { /* near the axis through the centre */
        ray.org[i] = s.ctr[i] + (family > 2 ? 0 : vec_pick(rng, -2, 2));
        if (i == axis) ray.org[i] += sign * (family == 3 ? s.rad + error : s.rad - (family == 4));
    }
    if (family > 1) ray.skip = (struct sph_skip){id, family == 3 || vec_pick(rng, 0, 1)};
    for (int i = 0; i < 3; i++) {
        if (ray.org[i] < -half) ray.org[i] = -half;
        if (ray.org[i] >= half) ray.org[i] = half - 1;
        if (family == 1 || ray.kind == SPH_SHADOW) /* to the sphere, or a light in it */
            ray.dir[i] = s.ctr[i] + vec_pick(rng, -s.rad, s.rad) - ray.org[i];
    }
    sph_ray_setup(p, &ray);
    return ray;
}

/* Both ways; how many rays hit. */
static int compare(struct sph_rng *rng, const struct sph_machine *m, struct sph_counters *c) {
    int hits = 0;
    for (int i = 0; i < RAYS; i++) {
        struct sph_ray ray = ray_of(rng, m);
        struct sph_counters brute = {{0}};
        uint32_t visits = 0, errors = 0;
        struct sph_hit a = sph_traverse(m, &ray, SPH_TRAVERSE_TREE, c, &visits, &errors);
        struct sph_hit b = sph_traverse(m, &ray, SPH_TRAVERSE_BRUTE, &brute, &visits, &errors);
        int same = a.key == b.key && (ray.kind == SPH_SHADOW || (a.id == b.id && a.far == b.far));
        if (!same || errors)
            fail_msg("%s, tree %d: ray %d kind %d org (%ld, %ld, %ld) dir (%ld, %ld, %ld) skip %u "
                     "%d: id %u key %lu far %d, expected %u %lu %d, errors %x",
                     m->profile.name, m->regs[SPH_REG_TREE], i, ray.kind, ray.org[0], ray.org[1],
                     ray.org[2], ray.dir[0], ray.dir[1], ray.dir[2], ray.skip.id, ray.skip.inside,
                     a.id, a.key, a.far, b.id, b.key, b.far, errors);
        hits += a.key != 0;
    }
    return hits;
}

/* Clouds of spheres that cut each other and of small ones, all profiles, three sizes of leaves, one
 * leaf, boxes. */
static void rays(void **unused) {
    struct sph_rng rng = vec_seed("test_bih_walk");
    static const uint32_t prims[] = {1, 3, 8};
    (void)unused;
    for (int kind = 0; kind < KINDS; kind++)
        for (int i = 0; i < 6; i++) {
            struct sph_profile p;
            struct sph_build_options o = options(kind, &p);
            struct sph_build_report report;
            struct sph_scene s = cloud(kind == TINY ? 40 : 150, i & 1 ? 0.25 : 0.04);
            o.tree = i < 3 ? SPH_TREE_BIH : i == 3 ? SPH_TREE_BRUTE : SPH_TREE_BOX4;
            o.max_prims = prims[i % 3];
            o.bih = i == 1 ? SPH_BIH_LISTING : SPH_BIH_FULL;
            if (kind == TINY)
                for (uint32_t j = 0; j < s.n_spheres; j++)
                    s.spheres[j].rad += 0.05;
            struct sph_machine m = built(&s, o, &report);
            struct sph_counters c = {{0}};
            int hits = compare(&rng, &m, &c);
            assert_true(hits > RAYS / 10);
            if (o.tree == SPH_TREE_BRUTE)
                assert_true(c.count[SPH_COUNT_CHILD_TESTS] == 0);
            else
                assert_true(c.count[SPH_COUNT_LEAF_TESTS] <
                            (uint64_t)RAYS * s.n_spheres / (i & 1 || kind >= TINY ? 1 : 4));
            struct sph_bih_stats stats;
            if (o.tree != SPH_TREE_BOX4) sph_bih_measure(&m, &stats);
            if (o.bih == SPH_BIH_FULL && o.tree != SPH_TREE_BOX4)
                assert_memory_equal(&stats, &report.bih, sizeof stats);
            sph_machine_free(&m);
            free(s.spheres);
        }
}

/* Triangles, planes and spheres; rays as above. */
static void facet_rays(void **unused) {
    struct sph_rng rng = vec_seed("test_bih_walk");
    (void)unused;
    for (int n = 0; n < FACET_SCENES; n++) {
        struct sph_scene s = facet_scene(n);
        for (int kind = 0; kind < SPH_PROFILES && s.n_spheres; kind++) {
            struct sph_profile p;
            struct sph_build_options o = options(kind, &p);
            struct sph_build_report report;
            struct sph_counters c = {{0}};
            o.tree = kind == n ? SPH_TREE_BRUTE : SPH_TREE_BIH;
            o.max_prims = 1u << kind;
            struct sph_machine m = built(&s, o, &report);
            assert_int_equal(m.regs[SPH_REG_N_LOOSE], report.loose);
            assert_true(compare(&rng, &m, &c) > 0);
            sph_machine_free(&m);
            o.tree = SPH_TREE_BOX4;
            m = built(&s, o, &report);
            assert_true(compare(&rng, &m, &c) > 0);
            sph_machine_free(&m);
        }
        sph_scene_free(&s);
    }
}

/* Whole frames, with shadows and mirrors: the trees, brute force; here and there the naive model.
 */
static void frames(void **unused) {
    (void)unused;
    int wrong = 0;
    for (int n = 0; n < MODEL_SCENES + FACET_SCENES; n++) {
        int facets = n >= MODEL_SCENES, profile = n % SPH_PROFILES, errors, bad;
        struct sph_scene s = facets ? facet_scene(n - MODEL_SCENES) : model_scene(model_scenes[n]);
        struct sph_machine m, four;
        struct sph_counters c, all;
        if (model_build(&s, profile, SPH_TREE_BALANCED, SPH_BG_RECT, MODEL_W, MODEL_H, &four) &&
            model_build(&s, profile, SPH_TREE_BIH, SPH_BG_RECT, MODEL_W, MODEL_H, &m)) {
            struct sph_frame tree = model_render(&four, SPH_TRAVERSE_TREE, 0, &all, &bad);
            struct sph_frame bih = model_render(&m, SPH_TRAVERSE_TREE, 0, &c, &errors);
            assert_int_equal(bad | errors, 0);
            wrong += model_differ("bih", &m, &bih, &tree);
            assert_int_equal(c.count[SPH_COUNT_RAYS_SHADOW], all.count[SPH_COUNT_RAYS_SHADOW]);
            assert_int_equal(c.count[SPH_COUNT_BACKGROUND], all.count[SPH_COUNT_BACKGROUND]);
            for (int i = 0; i < MODEL_W * MODEL_H && !facets && n % 3 == 0; i += 37) {
                struct sph_pixel p = sph_naive_pixel(&m, i % MODEL_W, i / MODEL_W);
                wrong += p.id != bih.pixels[i].id || p.key != bih.pixels[i].key ||
                         memcmp(p.colour, bih.pixels[i].colour, sizeof p.colour) != 0;
            }
            sph_frame_free(&bih);
            sph_machine_free(&m);
            assert_true(model_build(&s, profile, SPH_TREE_BOX4, SPH_BG_RECT, MODEL_W, MODEL_H, &m));
            bih = model_render(&m, SPH_TRAVERSE_TREE, 0, &c, &errors);
            assert_int_equal(errors, 0);
            wrong += model_differ("box4", &m, &bih, &tree);
            assert_int_equal(c.count[SPH_COUNT_RAYS_SHADOW], all.count[SPH_COUNT_RAYS_SHADOW]);
            sph_frame_free(&tree);
            sph_frame_free(&bih);
            sph_machine_free(&m);
            sph_machine_free(&four);
        }
        sph_scene_free(&s);
    }
    assert_int_equal(wrong, 0);
}

/* A machine of few spheres in profile standard. */
static struct sph_machine example(uint32_t n, uint32_t prims) {
    struct sph_profile p;
    struct sph_build_options o = options(SPH_STANDARD, &p);
    struct sph_build_report report;
    struct sph_scene s = cloud(n, 0.05);
    o.tree = SPH_TREE_BIH;
    o.max_prims = prims;
    struct sph_machine m = built(&s, o, &report);
    free(s.spheres);
    return m;
}

/* A ray from the eye to the middle of sphere 0; the errors that it meets. */
static uint32_t shot(const struct sph_machine *m, struct sph_hit *hit, struct sph_counters *c) {
    struct sph_ray ray = {.skip = {SPH_ID_NONE, 0}, .inside = 1};
    const uint32_t *prim = m->mem + (size_t)m->regs[SPH_REG_PRIM_BASE] * SPH_LINE_WORDS;
    struct sph_leaf s = sph_sphere_read(prim, m->profile.w);
    uint32_t visits = 0, errors = 0;
    for (int i = 0; i < 3; i++) {
        ray.org[i] = m->regs[SPH_REG_EYE_X + i];
        ray.dir[i] = s.ctr[i] - ray.org[i];
    }
    sph_ray_setup(&m->profile, &ray);
    *hit = sph_traverse(m, &ray, SPH_TRAVERSE_TREE, c, &visits, &errors);
    assert_int_equal(visits, c->count[SPH_COUNT_NODE_VISITS]);
    return errors;
}

/* Broken registers and words end a ray with the right error and no more work. */
static void broken(void **unused) {
    const uint32_t bad = 1 << SPH_ERROR_BAD_NODE;
    struct sph_machine m = example(60, 1);
    struct sph_counters c = {{0}};
    struct sph_hit hit;
    (void)unused;
    assert_int_equal(shot(&m, &hit, &c), 0);
    assert_true(hit.key && c.count[SPH_COUNT_NODE_VISITS] > 2);
    static const struct {
        int reg, value;
        uint32_t errors;
        uint64_t visits, tests;
    } list[] = {
        {SPH_REG_ROOT, 1 << 20, 1 << SPH_ERROR_BAD_NODE, 0, 0},
        {SPH_REG_LEAF_BASE, 1 << 20, 1 << SPH_ERROR_BAD_NODE, 0, 0},
        {SPH_REG_N_LOOSE, 61, 1 << SPH_ERROR_BAD_NODE, 0, 0},
        {SPH_REG_VISIT_LIMIT, 1, 1 << SPH_ERROR_VISIT_LIMIT, 1, 2},
        {SPH_REG_VISIT_LIMIT, 2, 1 << SPH_ERROR_VISIT_LIMIT, 2, 4},
        {SPH_REG_BOX_X1, -(1 << 17), 0, 0, 0},
    };
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        int32_t before = m.regs[list[i].reg];
        m.regs[list[i].reg] = list[i].value;
        c = (struct sph_counters){{0}};
        assert_int_equal(shot(&m, &hit, &c), list[i].errors);
        assert_int_equal(c.count[SPH_COUNT_NODE_VISITS], list[i].visits);
        assert_int_equal(c.count[SPH_COUNT_CHILD_TESTS], list[i].tests);
        assert_true(!hit.key);
        m.regs[list[i].reg] = before;
    }
    uint32_t root = m.mem[0];
    sph_field_set(m.mem, SPH_BIH_CHILD_LSB, SPH_BIH_CHILD_BITS, m.lines);
    c = (struct sph_counters){{0}};
    assert_int_equal(shot(&m, &hit, &c), bad);
    assert_int_equal(c.count[SPH_COUNT_NODE_VISITS], 1);
    assert_int_equal(c.count[SPH_COUNT_CHILD_TESTS], 0);
    m.mem[0] = (uint32_t)SPH_BIH_LEAF << SPH_BIH_AXIS_LSB; /* clips as range of records */
    c = (struct sph_counters){{0}};
    assert_int_equal(shot(&m, &hit, &c), bad);
    m.mem[0] = root;
    m.mem[0] &= ~(((1u << SPH_BIH_CHILD_BITS) - 1) << SPH_BIH_CHILD_LSB); /* its own child */
    m.mem[1] = 0x1ffff, m.mem[2] = (uint32_t)-0x20000;
    memcpy(m.mem + 4, m.mem, 16); /* both children: never an end */
    c = (struct sph_counters){{0}};
    assert_int_equal(shot(&m, &hit, &c), 1 << SPH_ERROR_STACK_OVERFLOW);
    assert_int_equal(c.count[SPH_COUNT_NODE_VISITS], SPH_BIH_STACK + 1);
    sph_machine_free(&m);
}

/* Leaf records in chunks: a shadow ray ends after the chunk that hits. */
static void chunks(void **unused) {
    struct sph_scene s = cloud(11, 0.05);
    struct sph_profile p;
    struct sph_build_options o = options(SPH_STANDARD, &p);
    struct sph_build_report report;
    (void)unused;
    o.tree = SPH_TREE_BRUTE;
    struct sph_machine m = built(&s, o, &report);
    for (uint32_t first = 0; first < 3; first++)
        for (uint32_t i = first; i < 11; i++) {
            m.mem[1] = first, m.mem[2] = 11 - first;
            const uint32_t *leaf = m.mem + (size_t)(1 + i / 2) * SPH_LINE_WORDS;
            struct sph_leaf at =
                sph_sphere_read(leaf + (i & 1) * (SPH_LEAF_STRIDE / 32), m.profile.w);
            struct sph_ray ray = {.kind = SPH_SHADOW, .skip = {SPH_ID_NONE, 0}, .inside = 1};
            struct sph_counters c = {{0}};
            uint32_t visits = 0, errors = 0, tested = first;
            for (int j = 0; j < 3; j++) {
                ray.org[j] = at.ctr[j];
                ray.dir[j] = j ? 1 : at.rad + 2; /* out of this sphere: only just */
            }
            sph_ray_setup(&m.profile, &ray);
            assert_int_equal(sph_traverse(&m, &ray, SPH_TRAVERSE_TREE, &c, &visits, &errors).key,
                             1);
            while (tested <= i)
                tested = (tested & ~1u) + SPH_BIH_CHUNK;
            if (tested > 11) tested = 11;
            assert_true(c.count[SPH_COUNT_LEAF_TESTS] <= tested - first);
            uint64_t end = c.count[SPH_COUNT_LEAF_TESTS] + first; /* a chunk's */
            assert_true(end == 11 || (end - (first & ~1u)) % SPH_BIH_CHUNK == 0);
            assert_int_equal(visits, 1);
        }
    sph_machine_free(&m);
    free(s.spheres);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rays),   cmocka_unit_test(facet_rays), cmocka_unit_test(frames),
        cmocka_unit_test(broken), cmocka_unit_test(chunks),
    };
    return cmocka_run_group_tests_name("bih walk", tests, NULL, NULL);
}
