/* test_background.c - background separation: no way loses a hit
 * SPDX-License-Identifier: Apache-2.0
 *
 * build/test/test_background [seed], from the root of the repository: reads scenes/.
 */
#include "view_check.h"

#include <string.h>

#include "pixel/background.h"
#include "naive/naive.h"
#include "render/render.h"
#include "validate/validate.h"
#include "scene_list.h"

enum { W = 24, H = 18 };

/* The ball of a primitive record. */
static struct sph_ball prim_ball(const struct sph_machine *m, uint32_t id) {
    const uint32_t *line = m->mem + ((size_t)m->regs[SPH_REG_PRIM_BASE] + id) * SPH_LINE_WORDS;
    return (struct sph_ball){{sph_field_signed(line, SPH_LEAF_CTR_X_LSB, SPH_LEAF_CTR_X_BITS),
                              sph_field_signed(line, SPH_LEAF_CTR_Y_LSB, SPH_LEAF_CTR_Y_BITS),
                              sph_field_signed(line, SPH_LEAF_CTR_Z_LSB, SPH_LEAF_CTR_Z_BITS)},
                             (int32_t)sph_field(line, SPH_LEAF_RAD_LSB, SPH_LEAF_RAD_BITS)};
}

/* A few spheres and an eye anywhere among, before, beside or far from them. */
static struct sph_scene random_view(int run) {
    static const uint32_t numbers[] = {1, 2, 4, 5, 9, 16, 30};
    struct sph_scene s = cloud(numbers[run % 7], between(0.01, 0.5));
    double far = run % 3 ? between(0, 3) : between(0, 1) * between(0, 40);
    struct sph_vec *from = &s.camera.from, *at = &s.camera.at;
    *from = (struct sph_vec){0.5 + far * between(-1, 1), 0.5 + far * between(-1, 1),
                             0.5 + far * between(-1, 1)};
    double aside = run % 5 ? between(0, 1.5) : 4;
    *at = (struct sph_vec){between(-aside, 1 + aside), between(-aside, 1 + aside),
                           between(-aside, 1 + aside)};
    s.camera.angle = between(3, 150);
    for (int i = 0; i < 2 && run & 1; i++) /* an oblique frustum */
        s.camera.shift[i] = between(-0.5, 0.5);
    s.camera.width = W, s.camera.height = H;
    return s;
}

static void primary(const struct sph_machine *m, int x, int y, int64_t dir[3]) {
    const int32_t *r = m->regs;
    dir[0] = r[SPH_REG_DIR_X0] + (int64_t)x * r[SPH_REG_PITCH];
    dir[1] = r[SPH_REG_DIR_Y0] - (int64_t)y * r[SPH_REG_PITCH];
    dir[2] = r[SPH_REG_DIR_Z];
}

/* Separated pixels of a machine, each of which must see no sphere; those of exact level 0 are
 * those that miss the root. */
static int check_view(const struct sph_machine *m, const struct sph_build_report *report,
                      int exact_root) {
    int saved = 0;
    for (int y = 0; y < H; y++)
        for (int x = 0; x < W; x++) {
            int64_t dir[3];
            primary(m, x, y, dir);
            int background = sph_is_background(m, x, y);
            if ((x + y) % 16 == 0) assert_int_equal(background, sph_naive_background(m, x, y));
            saved += background;
            if (exact_root)
                assert_int_equal(background, !hits(m->regs + SPH_REG_EYE_X, dir, &report->root));
            for (uint32_t id = 0; background && id < (uint32_t)m->regs[SPH_REG_N_PRIMS]; id++) {
                struct sph_ball ball = prim_ball(m, id);
                if (hits(m->regs + SPH_REG_EYE_X, dir, &ball))
                    fail_msg("mode %d: pixel %d,%d sees sphere %u", m->regs[SPH_REG_BG_MODE], x, y,
                             id);
            }
        }
    return saved;
}

static void test_views(void **unused) {
    static const struct {
        int mode, points, border, levels;
    } ways[] = {{SPH_BG_RECT, 0, 0, 0},   {SPH_BG_SPANS, 4, 0, 0},  {SPH_BG_SPANS, 16, 0, 0},
                {SPH_BG_SPANS, 16, 1, 0}, {SPH_BG_SPANS, 64, 3, 0}, {SPH_BG_EXACT, 0, 0, 0},
                {SPH_BG_EXACT, 0, 0, 1},  {SPH_BG_EXACT, 0, 0, 2}};
    enum { WAYS = sizeof ways / sizeof *ways };
    long saved[WAYS] = {0}, views = 0, refined = 0, fallen = 0, whole = 0;
    (void)unused;
    for (int run = 0; run < VIEWS / 2; run++) {
        struct sph_scene s = random_view(run);
        for (int way = 0; way < WAYS; way++) {
            struct sph_build_options o = standard;
            struct sph_build_report report;
            struct sph_machine m;
            struct sph_error err = {{0}};
            o.profile = run % SPH_PROFILES;
            o.tree = run & 8 ? SPH_TREE_PAPER : SPH_TREE_BALANCED;
            o.background = ways[way].mode, o.bg_points = ways[way].points;
            o.bg_border = ways[way].border, o.bg_levels = ways[way].levels;
            if (sph_build(&s, &o, &m, &report, &err)) break; /* too fine for the grid */
            if (sph_machine_validate(&m, &err)) fail_msg("%s", err.text);
            saved[way] +=
                check_view(&m, &report, ways[way].mode == SPH_BG_EXACT && !ways[way].levels);
            refined += report.bg_points > o.bg_points;
            fallen += strstr(report.background, "widened") != NULL;
            whole += strstr(report.background, "every pixel") != NULL;
            views += !way;
            sph_machine_free(&m);
        }
        free(s.spheres);
    }
    printf("# %ld views; saved:", views);
    for (int way = 0; way < WAYS; way++)
        printf(" %.2f", (double)saved[way] / (double)(views * W * H));
    printf("; %ld outlines refined, %ld widened, %ld whole\n", refined, fallen, whole);
    assert_true(views > VIEWS / 4 && refined > VIEWS / 20 && whole > VIEWS / 20);
    for (int way = 0; way < WAYS; way++)
        assert_true(saved[way] > views * W * H / 10);
    assert_true(saved[5] >= saved[3] && saved[3] > saved[0]); /* exact, spans, rect */
}

static struct sph_frame rendered(const struct sph_machine *m, int expected) {
    struct sph_render_options o = {.traverse = SPH_TRAVERSE_TREE, .threads = 1};
    struct sph_frame frame;
    struct sph_counters c = {{0}};
    assert_int_equal(sph_render(m, &o, &frame, &c, NULL), expected);
    return frame;
}

/* Whole frames of every scene are the same with every way, but for visits. */
static void test_frames(void **unused) {
    static const char *const patterns[] = {"scenes/*.nff", "scenes/views/*.nff"};
    struct scene_list found = list_scenes(patterns, 2);
    struct sph_read_options read = {0};
    struct sph_error err = {{0}};
    int saved = 0;
    (void)unused;
    for (size_t j = 0; j < found.n; j++) {
        struct sph_scene s;
        struct sph_build_options o = standard;
        struct sph_build_report report;
        struct sph_frame before = {0};
        if (sph_scene_read(found.name[j], &read, &s, &err)) fail_msg("%s", err.text);
        o.width = 64, o.height = 36;
        for (int way = 0; way < 6; way++) {
            o.background = way > SPH_BG_EXACT ? SPH_BG_EXACT : way;
            o.bg_levels = way > SPH_BG_EXACT ? way - SPH_BG_EXACT : 0;
            struct sph_machine m = built(&s, o, &report);
            struct sph_frame frame = rendered(&m, 0);
            for (int at = 0; at < 64 * 36; at++) {
                const struct sph_pixel *p = &frame.pixels[at];
                saved += !p->visits;
                if (!way) continue;
                const struct sph_pixel *q = &before.pixels[at];
                if (p->id != q->id || p->key != q->key ||
                    memcmp(p->colour, q->colour, sizeof p->colour) != 0)
                    fail_msg("%s, way %d: pixel %d,%d differs", found.name[j], way, at % 64,
                             at / 64);
            }
            if (way)
                sph_frame_free(&frame);
            else
                before = frame;
            sph_machine_free(&m);
        }
        sph_frame_free(&before);
        sph_scene_free(&s);
    }
    printf("# %d scenes, %d pixels left out\n", (int)found.n, saved);
    assert_true(found.n >= 17 && saved > (int)found.n * 64 * 36);
}

/* Broken tables: random words decide as the naive model says; tables beyond memory trace all. */
static void test_broken_tables(void **unused) {
    long background = 0, pixels = 0;
    (void)unused;
    for (int run = 0; run < 40; run++) {
        struct sph_scene s = cloud(30, 0.1);
        struct sph_build_options o = standard;
        struct sph_build_report report;
        o.profile = run % SPH_PROFILES, o.width = W, o.height = H;
        o.background = run & 4 ? SPH_BG_SPANS : SPH_BG_EXACT, o.bg_levels = run & 8 ? 2 : 0;
        struct sph_machine m = built(&s, o, &report);
        size_t base = (size_t)m.regs[SPH_REG_BG_BASE];
        m.regs[SPH_REG_RECT_X1] = W / 4; /* a rectangle that is not asked for */
        for (int32_t move = 1; move <= 1 << 26; move *= 4) {
            m.regs[SPH_REG_BG_BASE] = (int32_t)base + move;
            assert_true(sph_background_missing(&m));
            for (int y = 0; y < H; y++)
                assert_false(sph_is_background(&m, W / 2, y) || sph_naive_background(&m, 0, y));
            if (move > 4) continue;
            struct sph_frame frame = rendered(&m, 1 << SPH_ERROR_BAD_NODE);
            for (int i = 0; i < W * H; i++)
                assert_true(frame.pixels[i].visits > 0);
            sph_frame_free(&frame);
        }
        m.regs[SPH_REG_BG_BASE] = (int32_t)base;
        assert_false(sph_background_missing(&m));
        if (o.background == SPH_BG_SPANS) { /* only the window's rows are needed */
            m.regs[SPH_REG_BG_BASE]++, m.regs[SPH_REG_WIN_Y1] = H / 8 * 8;
            assert_false(sph_background_missing(&m));
            m.regs[SPH_REG_BG_BASE]--, m.regs[SPH_REG_WIN_Y1] = H;
        }
        for (size_t i = base * SPH_LINE_WORDS; i < m.lines * (size_t)SPH_LINE_WORDS; i++)
            m.mem[i] = (uint32_t)(uniform() * 0x1p32);
        for (int y = 0; y < H; y++)
            for (int x = 0; x < W; x++, pixels++) {
                background += sph_is_background(&m, x, y);
                assert_int_equal(sph_is_background(&m, x, y), sph_naive_background(&m, x, y));
            }
        sph_machine_free(&m);
        free(s.spheres);
    }
    printf("# %ld of %ld pixels left out by random tables\n", background, pixels);
    assert_true(background > pixels / 10 && background < pixels * 9 / 10);
}

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_views),
        cmocka_unit_test(test_broken_tables),
        cmocka_unit_test(test_frames),
    };
    seed(argc, argv);
    return cmocka_run_group_tests_name("background", tests, NULL, NULL);
}
