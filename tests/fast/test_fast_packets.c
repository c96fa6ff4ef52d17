/* test_fast_packets.c - rays that are walked together, against each by itself
 * SPDX-License-Identifier: Apache-2.0
 *
 * Run from the root of the repository: reads scenes/.
 */
#include "drawn.h"
#include "fast/fast.h"
#include "fast/packet.h"
#include "model_scene.h"
#include "prim/sphere.h"
#include "trace/setup.h"

enum { LANES = SPH_FAST_PLAIN + 1 };

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

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(bundles), cmocka_unit_test(unsound)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
