/* test_box_order.c - the order of children in a node of boxes: only visits of shadow rays change
 * SPDX-License-Identifier: Apache-2.0
 *
 * Run from the root of the repository: reads scenes/.
 */
#include "builder/tree/box.h"

#include "core/frame.h"
#include "model_scene.h"

enum { W = 48, H = 27 };

static struct sph_machine build(const char *path, int shadow) {
    struct sph_scene scene = read_scene(path);
    struct sph_build_options o = SPH_BUILD_DEFAULT;
    struct sph_build_report report;
    struct sph_machine m;
    struct sph_error err = {{0}};
    o.tree = SPH_TREE_BOX4, o.width = W, o.height = H;
    o.shadow = shadow, o.texture = SPH_OFF;
    if (sph_build(&scene, &o, &m, &report, &err)) fail_msg("%s", err.text);
    sph_scene_free(&scene);
    return m;
}

/* Visits of a frame; *hash: of its picture. */
static double visits(const struct sph_machine *m, uint64_t *hash) {
    struct sph_counters c;
    int errors;
    struct sph_frame f = model_render(m, SPH_TRAVERSE_TREE, 0, &c, &errors);
    assert_int_equal(errors, 0);
    *hash = sph_frame_picture_hash(&f);
    sph_frame_free(&f);
    return (double)c.count[SPH_COUNT_NODE_VISITS];
}

/* Turns the inner children of a node round, and of all below it. */
static void turn(struct sph_machine *m, uint32_t node) {
    uint32_t *line = sph_line(m, node), old[SPH_LINE_WORDS], swap[SPH_LINE_WORDS];
    uint32_t base = sph_field(line, SPH_NODE_BASE_LSB, SPH_NODE_BASE_BITS);
    uint32_t n = sph_field(line, SPH_NODE_N_INNER_LSB, SPH_NODE_N_INNER_BITS);
    memcpy(old, line, sizeof old);
    for (uint32_t i = 0; i < n; i++) {
        for (int at = 0; at < SPH_BOX_STRIDE; at++)
            sph_field_set(line, (int)i * SPH_BOX_STRIDE + at, 1,
                          sph_field(old, (int)(n - 1 - i) * SPH_BOX_STRIDE + at, 1));
        turn(m, base + i);
    }
    for (uint32_t i = 0; i < n / 2; i++) {
        uint32_t *a = sph_line(m, base + i), *b = sph_line(m, base + n - 1 - i);
        memcpy(swap, a, sizeof swap);
        memcpy(a, b, sizeof swap);
        memcpy(b, swap, sizeof swap);
    }
}

/* Turned round, a tree takes more visits for the same picture; ordered again it does not. */
static void gains(void **state) {
    (void)state;
    static const struct {
        const char *path;
        double most; /* of the visits in the other order */
    } cases[] = {{"scenes/facets/room.nff", 0.96},
                 {"scenes/texture/kitchen.nff", 0.98},
                 {"scenes/texture/museum.nff", 0.995}};
    for (size_t i = 0; i < (SANITIZED ? 1 : sizeof cases / sizeof *cases); i++) {
        struct sph_machine m = build(cases[i].path, SPH_ON);
        struct sph_error err = {{0}};
        uint64_t hash[3];
        double first = visits(&m, &hash[0]);
        turn(&m, (uint32_t)m.regs[SPH_REG_ROOT]);
        double turned = visits(&m, &hash[1]);
        assert_int_equal(sph_box_order(&m, &err), 0);
        double again = visits(&m, &hash[2]);
        printf("# %-30s visits: %.0f, turned round %.0f, ordered again %.0f\n", cases[i].path,
               first, turned, again);
        assert_true(hash[0] == hash[1] && hash[0] == hash[2]);
        assert_true(first < cases[i].most * turned);
        assert_true(again < cases[i].most * turned);
        sph_machine_free(&m);
    }
}

/* Where no shadow ray goes nothing moves. */
static void stays(void **state) {
    (void)state;
    struct sph_machine m = build("scenes/facets/room.nff", SPH_OFF);
    size_t size = m.lines * SPH_LINE_WORDS * sizeof *m.mem;
    uint32_t *before = malloc(size);
    struct sph_error err = {{0}};
    turn(&m, (uint32_t)m.regs[SPH_REG_ROOT]);
    memcpy(before, m.mem, size);
    assert_int_equal(sph_box_order(&m, &err), 0);
    assert_memory_equal(before, m.mem, size);
    free(before);
    sph_machine_free(&m);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(gains), cmocka_unit_test(stays)};
    return cmocka_run_group_tests_name("box order", tests, NULL, NULL);
}
