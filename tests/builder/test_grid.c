/* test_grid.c - what need not be on the grid: a far eye's place, most of a huge sphere
 * SPDX-License-Identifier: Apache-2.0
 */
#include "build_scene.h"

#include <math.h>

#include "builder/grid/grid.h"
#include "builder/grid/huge_bounds.h"

/* A box of some size about a point. */
static struct sph_box some_box(const double at[3], double size) {
    struct sph_box box;
    for (int i = 0; i < 3; i++) {
        box.lo[i] = at[i] - size * uniform();
        box.hi[i] = at[i] + size * uniform();
    }
    return box;
}

static void within(const struct sph_box *box, double p[3]) {
    for (int i = 0; i < 3; i++)
        p[i] = between(box->lo[i], box->hi[i]);
}

/* No point of a box is farther from its place in the picture than the eye says. */
static void eye_moves_little(void **unused) {
    (void)unused;
    int placed = 0;
    for (int n = 0; n < 20000; n++) {
        double depth = exp(between(0, 20)), axis[3] = {0, 0, 1}, worst = 0;
        struct sph_scene scene = {.camera = {.angle = 2 * atan(10 / depth) * 180 / M_PI}};
        struct sph_box box = some_box((double[3]){0, 0, -depth}, 10);
        struct sph_eye eye =
            sph_eye_place(&scene, axis, box.lo, box.hi, 12 + 4 * (int)(4 * uniform()));
        if (!(eye.ahead > 0)) continue;
        placed++;
        assert_true(eye.from.z == -eye.ahead && eye.ahead < depth);
        double old = 1 / tan(scene.camera.angle * M_PI / 360),
               now = 1 / tan(eye.angle * M_PI / 360);
        for (int i = 0; i < 8; i++) {
            double p[3];
            within(&box, p);
            if (i < 2) p[2] = i ? box.hi[2] : box.lo[2];
            double by = now / (-p[2] - eye.ahead) / (old / -p[2]) - 1;
            assert_true(fabs(by) < eye.off * (1 + 1e-6) + 1e-11);
            worst = fmax(worst, fabs(by));
        }
        assert_true(worst > eye.off * 0.99 - 1e-12); /* and some are as far */
        /* nothing beside the eye, nor behind it */
        box.hi[2] = 1;
        assert_true(sph_eye_place(&scene, axis, box.lo, box.hi, 24).ahead == 0);
    }
    printf("# %d eyes put nearer\n", placed);
    assert_true(placed > 5000);
}

/* What is met of a huge sphere from anywhere else lies in the box that is left of it. */
static void ground_is_met_inside(void **unused) {
    (void)unused;
    int cut = 0, near_end = 0;
    for (int n = 0; n < 20000; n++) {
        double rad = exp(between(3, 9)), top[3] = {0, 0, 0}, at[3], length = 0;
        for (int i = 0; i < 3; i++) {
            at[i] = between(-1, 1);
            length += at[i] * at[i];
        }
        for (int i = 0; i < 3; i++)
            at[i] *= rad * between(1, 1.01) / sqrt(length);
        struct sph_box rest = some_box(top, 10), box = rest, was;
        sph_box_add(&rest, top, 0);
        sph_box_add(&box, at, rad);
        was = box;
        if (!sph_huge_sphere_cut(at, rad, &rest, 24, &box)) {
            assert_memory_equal(&box, &was, sizeof box);
            continue;
        }
        cut++;
        assert_true(sph_box_side(&box) < sph_box_side(&was));
        for (int i = 0; i < 40; i++) {
            double p[3], d[3], k = rad * rad, a = 0, b = 0;
            within(&rest, p);
            for (int j = 0; j < 3; j++) {
                double to = at[j] - p[j];
                d[j] = between(-1, 1);
                k -= to * to, a += d[j] * d[j], b += to * d[j];
            }
            if (k >= 0 || b <= 0 || k * a + b * b <= 0) continue;
            double t = (b - sqrt(k * a + b * b)) / a;
            for (int j = 0; j < 3; j++) {
                double hit = p[j] + t * d[j];
                assert_true(hit >= box.lo[j] && hit <= box.hi[j]);
                near_end += hit < rest.lo[j] || hit > rest.hi[j];
            }
        }
    }
    printf("# %d spheres cut, %d points beside all else\n", cut, near_end);
    assert_true(cut > 1000 && near_end > 1000);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(eye_moves_little),
        cmocka_unit_test(ground_is_met_inside),
    };
    return cmocka_run_group_tests_name("grid", tests, NULL, NULL);
}
