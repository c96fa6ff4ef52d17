/* test_rays.c - primary rays and the background rectangle, checked in exact integers
 * SPDX-License-Identifier: Apache-2.0
 */
#include "build_scene.h"

#include <math.h>

#include "builder/background/rect.h"

static void test_rays(void **unused) {
    (void)unused;
    for (int run = 0; run < 2000; run++) {
        const struct sph_profile *p = &sph_profiles[run % SPH_PROFILES];
        int width = (int)between(1, 1300), height = (int)between(1, 1000);
        double angle = between(0.5, 160);
        struct sph_raster raster = {width, height, angle, {0, 0}};
        struct sph_rays r;
        int64_t most = (1ll << (p->wd - 1)) - 1, to[2] = {0, 0};
        double heights = 0; /* that the corner farthest away is off by the shift */
        for (int i = 0; i < 2 && run & 8; i++) {
            raster.shift[i] = between(-2, 2) * pow(uniform(), 3);
            heights = fmax(heights, fabs(raster.shift[i]));
        }
        if (sph_rays_fit(&raster, p->wd, &r, NULL)) {
            double far = height / tan(angle * M_PI / 360); /* with a pitch of 2 */
            double side = (width > height ? width : height) + 2 * heights * height;
            double wide = (double)most / (side - 0.999) * far; /* with the greatest pitch */
            assert_true(far > (double)most - 1 || side > most || wide < SPH_MIN_SCREEN + 1);
            continue;
        }
        assert_true(r.pitch >= 2 && r.pitch % 2 == 0 && r.z <= -SPH_MIN_SCREEN && r.z >= -most);
        for (int i = 0; i < 2; i++)
            to[i] = llround(raster.shift[i] * height * r.pitch);
        int64_t x1 = r.x0 + (width - 1ll) * r.pitch, y1 = r.y0 - (height - 1ll) * r.pitch;
        assert_true(r.x0 >= -most && x1 <= most && r.x0 - to[0] == to[0] - x1);
        assert_true(y1 >= -most && r.y0 <= most && r.y0 - to[1] == to[1] - y1);
        double tangent = r.pitch * (height / 2.0) / -r.z,
               unit = sqrt(0.5) / (r.pitch * height / 2.);
        double off = fabs(tangent / tan(angle * M_PI / 360) - 1);
        assert_true(r.fov_error > off - 1e-9 && r.fov_error < off + (heights > 0) * unit + 1e-9);
    }
}

/* The screen is never nearer than MIN_SCREEN: such angles are refused. */
static void test_widest(void **unused) {
    (void)unused;
    int refused = 0;
    for (int run = 0; run < 2000; run++) {
        const struct sph_profile *p = &sph_profiles[run % SPH_PROFILES];
        int side = (int)between(1, 64);
        double angle = 180 - pow(10, between(-6, 0));
        struct sph_rays r;
        if (sph_rays_fit(&(struct sph_raster){side, side, angle, {0, 0}}, p->wd, &r, NULL)) {
            double far = ldexp(1, p->wd - 1) * side / (side > 1 ? side - 1 : 1);
            assert_true(far / tan(angle * M_PI / 360) < SPH_MIN_SCREEN + 2);
            refused++;
        } else {
            assert_true(r.z <= -SPH_MIN_SCREEN);
        }
    }
    assert_true(refused > 100 && refused < 1900);
}

/* Exact: does the ray from the eye along dir hit the ball? */
static int hits(const int32_t eye[3], const int64_t dir[3], const struct sph_ball *ball) {
    __int128 a = 0, b = 0, k = (__int128)ball->r * ball->r;
    for (int i = 0; i < 3; i++) {
        int64_t oc = (int64_t)ball->c[i] - eye[i];
        a += (__int128)dir[i] * dir[i];
        b += (__int128)oc * dir[i];
        k -= (__int128)oc * oc;
    }
    return k * a + b * b > 0 && (b > 0 || k > 0);
}

static void test_rectangle(void **unused) {
    enum { W = 48, H = 36 };
    struct sph_work work = {0};
    long inside = 0, hit = 0, views[3] = {0};
    (void)unused;
    for (int run = 0; run < 3000; run++) {
        const struct sph_profile *p = &sph_profiles[run & 1 ? SPH_DRAFT : SPH_STANDARD];
        struct sph_rays r;
        struct sph_raster raster = {W, H, between(5, 150), {0, 0}};
        if (run & 4) raster.shift[0] = between(-1, 1), raster.shift[1] = between(-1, 1);
        if (sph_rays_fit(&raster, p->wd, &r, NULL)) {
            assert_true(run & 4); /* a wide screen to the side comes too near */
            continue;
        }
        double room = ldexp(1, p->w - 1) / 2;
        struct sph_ball ball;
        int32_t eye[3];
        for (int i = 0; i < 3; i++) {
            eye[i] = (int32_t)between(-room, room);
            ball.c[i] = (int32_t)between(-room, room);
        }
        ball.r = (int32_t)(1 + room * pow(uniform(), 3));
        struct sph_rect rect = sph_rect_project(&ball, eye, &r, W, H, &work);
        int whole = rect.x1 - rect.x0 == W && rect.y1 - rect.y0 == H;
        views[whole ? 2 : rect.x1 > 0]++;
        assert_true(rect.x0 >= 0 && rect.x0 <= rect.x1 && rect.x1 <= W);
        assert_true(rect.y0 >= 0 && rect.y0 <= rect.y1 && rect.y1 <= H);
        for (int y = 0; y < H; y++)
            for (int x = 0; x < W; x++) {
                int64_t dir[3] = {r.x0 + x * (int64_t)r.pitch, r.y0 - y * (int64_t)r.pitch, r.z};
                int in = x >= rect.x0 && x < rect.x1 && y >= rect.y0 && y < rect.y1;
                int h = hits(eye, dir, &ball);
                assert_true(in || !h);
                inside += in, hit += h;
            }
    }
    printf("# rectangle: %ld views empty, %ld part, %ld whole; %.0f %% of its pixels hit\n",
           views[0], views[1], views[2], 100.0 * (double)hit / (double)inside);
    assert_true(views[0] > 100 && views[1] > 100 && views[2] > 100);
}

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_rays),
        cmocka_unit_test(test_widest),
        cmocka_unit_test(test_rectangle),
    };
    seed(argc, argv);
    return cmocka_run_group_tests_name("rays", tests, NULL, NULL);
}
