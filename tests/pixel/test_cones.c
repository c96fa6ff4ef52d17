/* test_cones.c - forward differences of a sphere are the exact predicate
 * SPDX-License-Identifier: Apache-2.0
 */
#include "view_check.h"

#include "builder/background/cones.h"

/* Forward differences are the formula, at every pixel, in the widths that the hardware has. */
static void test_differences(void **unused) {
    static const int sides[][2] = {{24, 18}, {1, 1}, {2, 1}, {1, 7}, {97, 3}};
    (void)unused;
    for (int run = 0; run < VIEWS; run++) {
        const struct sph_profile *p = &sph_profiles[run % SPH_PROFILES];
        int side = run / SPH_PROFILES % 32; /* small frames have many pitches to choose from */
        int width = sides[side % 5][0], height = sides[side % 5][1];
        if (side > 5) width = 24, height = 18;
        int32_t eye[3];
        struct sph_ball ball;
        struct sph_rays rays;
        struct sph_work work = {0};
        random_sphere(p, width, height, &ball, eye, &rays);
        struct sph_cone c = sph_cone_make(&ball, eye, &rays, &work);
        __int128 parts[] = {c.f, c.fx, c.fy, c.fxx, c.fxy, c.fyy};
        for (int i = 0; i < 6; i++) {
            __int128 most = (__int128)1 << (2 * p->w + 2 * p->wd + 3);
            assert_true(parts[i] < most && parts[i] >= -most);
        }
        int64_t most = 1ll << (p->w + p->wd + 3);
        assert_true(c.b < most && c.b >= -most && c.bx < most && c.bx >= -most);
        assert_true(c.by < most && c.by >= -most);
        for (int y = 0; y < height; y++)
            for (int x = 0; x < width; x++) {
                int64_t dir[3] = {rays.x0 + x * (int64_t)rays.pitch,
                                  rays.y0 - y * (int64_t)rays.pitch, rays.z};
                __int128 a = 0, b = 0, k = (__int128)ball.r * ball.r;
                for (int i = 0; i < 3; i++) {
                    int64_t oc = (int64_t)ball.c[i] - eye[i];
                    a += dir[i] * dir[i], b += oc * dir[i], k -= oc * oc;
                }
                assert_true(k * a + b * b == c.f + x * c.fx + x * (x - 1) / 2 * c.fxx + y * c.fy +
                                                 y * (y - 1) / 2 * c.fyy + x * y * c.fxy);
                assert_true(b == c.b + x * c.bx + y * c.by);
                assert_int_equal(c.inside, k > 0);
            }
    }
}

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_differences)};
    seed(argc, argv);
    return cmocka_run_group_tests_name("cones", tests, NULL, NULL);
}
