/* test_outline.c - outlines hold their spheres; wrong options are refused
 * SPDX-License-Identifier: Apache-2.0
 */
#include "view_check.h"

#include <string.h>

#include "builder/background/cones.h"
#include "builder/background/outline.h"
#include "builder/background/spans.h"

enum { SIDE = 64, MARGIN = 4, WIDE = SIDE + 2 * MARGIN };

/* The rows of an outline as a mask; those of a mask as an outline's. */
static void to_mask(const struct sph_outline *o, char mask[WIDE][WIDE]) {
    for (int y = 0; y < WIDE; y++)
        for (int x = 0; x < WIDE; x++)
            mask[y][x] = x - MARGIN >= o->rows[y].x0 && x - MARGIN < o->rows[y].x1;
}

static void assert_mask(const struct sph_outline *o, char mask[WIDE][WIDE]) {
    for (int y = 0; y < WIDE; y++) {
        struct sph_span row = {0, 0};
        for (int x = 0; x < WIDE; x++) {
            if (!mask[y][x]) continue;
            if (row.x1 <= row.x0) row.x0 = x - MARGIN;
            row.x1 = x - MARGIN + 1;
        }
        int empty = o->rows[y].x1 <= o->rows[y].x0;
        assert_int_equal(empty, row.x1 <= row.x0);
        if (empty) continue;
        assert_int_equal(o->rows[y].x0, row.x0);
        assert_int_equal(o->rows[y].x1, row.x1);
    }
}

/* Scan of columns and border of a few rows that are anywhere, against the same on a mask. */
static void test_steps(void **unused) {
    static char mask[WIDE][WIDE], wide[WIDE][WIDE];
    struct sph_error err = {{0}};
    (void)unused;
    for (int run = 0; run < VIEWS / 4; run++) {
        struct sph_outline o;
        int border = run % MARGIN;
        assert_int_equal(sph_outline_start(&o, SIDE, SIDE, MARGIN, &err), 0);
        o.x1 = o.y1 = SIDE; /* rows stay in the frame */
        for (int n = run % 7; n > 0; n--) {
            int y = (int)between(0, SIDE), x = (int)between(0, SIDE);
            o.rows[y + MARGIN] = (struct sph_span){x, (int)between(x, SIDE) + 1};
        }
        to_mask(&o, mask);
        for (int x = 0; x < WIDE; x++) {
            int first = WIDE, last = -1;
            for (int y = 0; y < WIDE; y++)
                if (mask[y][x]) last = y, first = first < y ? first : y;
            for (int y = first; y <= last; y++)
                mask[y][x] = 1;
        }
        assert_int_equal(sph_outline_columns(&o, &err), 0);
        assert_mask(&o, mask);
        to_mask(&o, mask);
        for (int y = 0; y < WIDE; y++)
            for (int x = 0; x < WIDE; x++) {
                wide[y][x] = 0;
                for (int v = y - border; v <= y + border; v++)
                    for (int u = x - border; u <= x + border; u++)
                        if (v >= 0 && v < WIDE && u >= 0 && u < WIDE) wide[y][x] |= mask[v][u];
            }
        assert_int_equal(sph_outline_border(&o, border, &err), 0);
        assert_mask(&o, wide);
        free(o.rows);
    }
}

/* Spans hold every pixel that hits, and what the paper's methods lose at their word is seen. */
static void test_spans(void **unused) {
    struct sph_span rows[SIDE], exact;
    struct sph_work work = {0};
    struct sph_error err = {{0}};
    long how[4] = {0}, lost_rect = 0, lost_borderless = 0, lost_border = 0;
    (void)unused;
    for (int run = 0; run < VIEWS; run++) {
        const struct sph_profile *p = &sph_profiles[run % SPH_PROFILES];
        int32_t eye[3];
        struct sph_ball ball;
        struct sph_rays rays;
        struct sph_spans spans;
        double point[4][2];
        random_sphere(p, SIDE, SIDE, &ball, eye, &rays);
        if (run & 1) { /* not so near, and so wholly in view */
            for (int i = 0; i < 2; i++)
                ball.c[i] = eye[i] / 2 + ball.c[i] / 4, ball.r = ball.r / 8 + 1;
            eye[2] = (1 << (p->w - 1)) - 1;
        }
        int border = run % 3, points = 4 << run % 5;
        if (sph_spans_make(&spans, &ball, eye, &rays, SIDE, SIDE, points, border, &err))
            fail_msg("%s", err.text);
        how[spans.how]++;
        struct sph_cone cone = sph_cone_make(&ball, eye, &rays, &work);
        for (int y = 0; y < SIDE; y++) {
            sph_cone_row(&cone, SIDE, y, &exact.x0, &exact.x1, &work);
            for (int x = 0; x < SIDE; x++) {
                int64_t dir[3] = {rays.x0 + x * (int64_t)rays.pitch,
                                  rays.y0 - y * (int64_t)rays.pitch, rays.z};
                int in = x >= spans.rows[y].x0 && x < spans.rows[y].x1, hit = hits(eye, dir, &ball);
                assert_true(in || !hit);
                assert_true(!hit || (x >= exact.x0 && x < exact.x1));
            }
        }
        free(spans.rows);

        if (sph_rect_paper(&ball, eye, &rays, SIDE, SIDE, rows, point, &work))
            for (int y = 0; y < SIDE; y++) {
                sph_cone_row(&cone, SIDE, y, &exact.x0, &exact.x1, &work);
                lost_rect +=
                    exact.x1 > exact.x0 && (exact.x0 < rows[y].x0 || exact.x1 > rows[y].x1);
            }
        for (border = 0; border <= 1 && sph_in_front(&ball, eye); border++) {
            struct sph_projection how16 = {&ball, eye, &rays, 16};
            assert_int_equal(sph_spans_draw(rows, &how16, SIDE, SIDE, border, &work, &err), 0);
            for (int y = 0; y < SIDE; y++) {
                sph_cone_row(&cone, SIDE, y, &exact.x0, &exact.x1, &work);
                *(border ? &lost_border : &lost_borderless) +=
                    exact.x1 > exact.x0 && (exact.x0 < rows[y].x0 || exact.x1 > rows[y].x1);
            }
        }
    }
    printf("# %ld outlines, %ld widened, %ld whole, %ld behind\n", how[0], how[1], how[2], how[3]);
    printf("# rows that lose pixels: %ld by four points, %ld by 16x16, %ld with a border\n",
           lost_rect, lost_borderless, lost_border);
    assert_true(how[0] > VIEWS / 5 && how[2] > VIEWS / 50 && how[3] > VIEWS / 50);
    assert_true(lost_rect > VIEWS / 20 && lost_borderless > lost_border && lost_border > 0);
}

/* The rim of a sphere of 10^5 pixels, aslant through a small frame: no number of points is enough.
 */
static void test_widened(void **unused) {
    struct sph_ball ball = {{2828427, 2828427, -8000000}, 4000000};
    const int32_t eye[3] = {7, 0, 0};
    struct sph_rays rays;
    struct sph_spans spans;
    long hit = 0;
    (void)unused;
    assert_int_equal(sph_rays_fit(&(struct sph_raster){SIDE, SIDE, 0.05, {0, 0}},
                                  sph_profiles[SPH_REFERENCE].wd, &rays, NULL),
                     0);
    assert_int_equal(sph_spans_make(&spans, &ball, eye, &rays, SIDE, SIDE, 2048, 0, NULL), 0);
    for (int y = 0; y < SIDE; y++)
        for (int x = 0; x < SIDE; x++) {
            int64_t dir[3] = {rays.x0 + x * (int64_t)rays.pitch, rays.y0 - y * (int64_t)rays.pitch,
                              rays.z};
            int in = x >= spans.rows[y].x0 && x < spans.rows[y].x1, h = hits(eye, dir, &ball);
            assert_true(in || !h);
            hit += h;
        }
    free(spans.rows);
    assert_true(hit > 0 && hit < SIDE * SIDE);
    assert_int_equal(spans.how, SPH_SPANS_WIDENED);
    assert_int_equal(spans.points, SPH_POINTS_MAX);
}

/* Sides of a frame and options beyond their ranges are refused. */
static void test_refusals(void **unused) {
    struct sph_scene s = cloud(3, 0.1);
    static const struct {
        int width, height, mode, points, border, levels;
        const char *part;
    } bad[] = {{16384, 1, 0, 0, 0, 0, "16384x1, sides are 1..16383"},
               {1, 16384, 0, 0, 0, 0, "1x16384, sides are 1..16383"},
               {8, 8, 4, 0, 0, 0, "background mode 4"},
               {8, 8, -1, 0, 0, 0, "background mode -1"},
               {8, 8, 2, 3, 0, 0, "bg_points 3 is not in 4..4096"},
               {8, 8, 2, 4097, 0, 0, "bg_points 4097"},
               {8, 8, 2, 0, -1, 0, "bg_border -1"},
               {8, 8, 2, 0, 65, 0, "bg_border 65"},
               {8, 8, 3, 0, 0, 3, "bg_levels 3"},
               {8, 8, 3, 0, 0, -1, "bg_levels -1"}};
    (void)unused;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        struct sph_build_options o = standard;
        struct sph_build_report report;
        struct sph_machine m;
        struct sph_error err = {{0}};
        o.profile = SPH_REFERENCE, o.width = bad[i].width, o.height = bad[i].height;
        o.background = bad[i].mode, o.bg_points = bad[i].points;
        o.bg_border = bad[i].border, o.bg_levels = bad[i].levels;
        assert_int_equal(sph_build(&s, &o, &m, &report, &err), -1);
        if (!strstr(err.text, bad[i].part)) fail_msg("'%s' lacks '%s'", err.text, bad[i].part);
    }
    struct sph_build_options o = standard; /* the largest there is */
    struct sph_build_report report;
    o.profile = SPH_REFERENCE, o.background = SPH_BG_SPANS, o.width = SPH_MAX_SIDE, o.height = 9;
    struct sph_machine m = built(&s, o, &report);
    assert_int_equal(m.regs[SPH_REG_MEM_LINES] - m.regs[SPH_REG_BG_BASE], 2);
    sph_machine_free(&m);
    free(s.spheres);
}

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_steps),
        cmocka_unit_test(test_spans),
        cmocka_unit_test(test_widened),
        cmocka_unit_test(test_refusals),
    };
    seed(argc, argv);
    return cmocka_run_group_tests_name("outline", tests, NULL, NULL);
}
