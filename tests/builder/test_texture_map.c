/* test_texture_map.c - how images lie on triangles, planes and spheres of a built machine
 * SPDX-License-Identifier: Apache-2.0
 */
#include "textured.h"

#include "texture/coords.h"

/* Coordinates in repeats, wrapped to -0.5 .. 0.5. */
static double off(int64_t at, double expected) {
    double d = (double)at / (1 << SPH_ST_FRACTION) - expected;
    return fabs(d - round(d));
}

/* The record of triangle i at its corners, which are grid points: off by no more than
 * docs/design/textures.md says. *worst: error over bound. */
static void check_triangle(const struct sph_machine *m, uint32_t i, const struct sph_facet *facet,
                           double *worst) {
    const uint32_t *leaf =
        m->mem + (size_t)((uint32_t)m->regs[SPH_REG_FACET_BASE] + i) * SPH_LINE_WORDS;
    const uint32_t *map = textured_map(m, i);
    int ng = sph_profiles[SPH_STANDARD].ng;
    int64_t corner[3][3], middle[3];
    for (int k = 0; k < 3; k++) {
        for (int c = 0; c < 3; c++)
            corner[c][k] = (int64_t)sph_field_signed(leaf, 72 * c + 24 * k, 24) * (1 << ng);
        middle[k] = (corner[0][k] + corner[1][k] + corner[2][k]) / 3;
    }
    for (int c = 0; c < 3; c++) {
        struct sph_st got = sph_coords_facet(map, corner[c]);
        double away = 0;
        for (int k = 0; k < 3; k++)
            away += fabs((double)(corner[c][k] - middle[k]));
        for (int k = 0; k < 2; k++) {
            int e = sph_field_signed(map, k ? SPH_MAP_T_E_LSB : SPH_MAP_S_E_LSB, SPH_MAP_S_E_BITS);
            double bound = (ldexp(away, -e - 1) + 1.5) * 0x1p-20;
            double expected = k ? 1 - facet->st[c][1] : facet->st[c][0];
            *worst = fmax(*worst, off(got.at[k], expected) / bound);
        }
    }
}

static void triangles(void **state) {
    (void)state;
    struct sph_rng rng = vec_seed("triangles");
    enum { N = 300 };
    struct sph_material white;
    struct sph_scene scene = textured_scene(&white);
    struct sph_texture texture = {.path = "noise", .repeat = {1, 1}, .line = 5};
    struct sph_mip mip = textured_mip(16, 16, &rng);
    struct sph_facet facet[N];
    for (int i = 0; i < N; i++) {
        facet[i] = (struct sph_facet){.kind = SPH_TRIANGLE, .texture = 1, .group = (uint32_t)i};
        double size = pow(2, sph_rng_range(&rng, -4, 3)), at[3];
        for (int k = 0; k < 3; k++)
            at[k] = sph_rng_range(&rng, -10, 10);
        for (int c = 0; c < 3; c++) {
            facet[i].v[c] = (struct sph_vec){at[0] + sph_rng_range(&rng, -size, size),
                                             at[1] + sph_rng_range(&rng, -size, size),
                                             at[2] + sph_rng_range(&rng, -size, size)};
            for (int k = 0; k < 2; k++)
                facet[i].st[c][k] = sph_rng_range(&rng, -3, 3);
        }
    }
    double rise = 1 - 0x1p-19; /* the gradient's mantissa rounds up to one bit more */
    facet[0] = (struct sph_facet){.kind = SPH_TRIANGLE,
                                  .v = {{0, 0, -9}, {8, 0, -9}, {0, 8, -9}},
                                  .st = {{0, 0}, {rise, 0}, {0, rise}},
                                  .texture = 1};
    scene.n_facets = N;
    scene.facets = facet;
    scene.n_textures = 1;
    scene.textures = &texture;
    double worst = 0;
    for (int pr = SPH_STANDARD; pr < SPH_PROFILES; pr++) {
        struct sph_build_options o = textured_options;
        struct sph_build_report report;
        o.profile = pr;
        o.mips = &mip;
        struct sph_machine m = textured_build(&scene, &o, &report);
        for (uint32_t i = 0; i < N; i++)
            check_triangle(&m, i, &facet[i], &worst);
        sph_machine_free(&m);
    }
    printf("# coordinates at corners are off by at most %.3g of the bound\n", worst);
    assert_true(worst < 1);
    free(mip.texels);
}

/* A plane's coordinates: 0 at its point, 1 a repeat along s, and up. */
static void planes(void **state) {
    (void)state;
    struct sph_material white;
    struct sph_scene scene = textured_scene(&white);
    struct sph_texture texture = {.path = "noise", .line = 5};
    struct sph_mip mip = textured_mip(64, 32, NULL);
    struct sph_facet facet = {.kind = SPH_PLANE,
                              .v = {{1, -2, -3}, {0, 2, 0}, {3, 1, 0}}, /* s along x */
                              .st = {{4, 0.5}, {0.25, 0.5}, {0, 0}},
                              .texture = 1};
    struct sph_sphere ball = {.ctr = {0, 0, -20}, .rad = 9};
    scene.n_facets = scene.n_textures = scene.n_spheres = 1;
    scene.facets = &facet;
    scene.textures = &texture;
    scene.spheres = &ball;
    scene.camera.at = (struct sph_vec){3, -1, -4}; /* turned axes */
    for (int clamp = 0; clamp < 2; clamp++) {
        struct sph_build_options o = textured_options;
        struct sph_build_report report;
        texture.wrap[0] = texture.wrap[1] = clamp;
        o.mips = &mip;
        struct sph_machine m = textured_build(&scene, &o, &report);
        assert_null(textured_map(&m, 0));
        const uint32_t *map = textured_map(&m, 1);
        for (int i = 0; i < 200; i++) {
            int column = i % 20, row = i / 20;
            double x = 1 + (column - 10) / 3.0, z = -3 + (row - 5) / 3.0;
            double d[3] = {x, -2, z};
            int64_t at[3];
            for (int k = 0; k < 3; k++) {
                double v = 0;
                for (int c = 0; c < 3; c++)
                    v += m.rotation[3 * k + c] * d[c];
                at[k] = llround((v - m.origin[k]) / ldexp(1, m.grid_log2 - 2)); /* NG = 2 */
            }
            struct sph_st got = sph_coords_facet(map, at);
            double s = (x - 1) / 4 + 0.25, t = 1 - ((-(z + 3)) / 0.5 + 0.5);
            /* the plane's point is rounded to the grid: half a step each way */
            double step = 1.5 * ldexp(1, m.grid_log2);
            assert_true(off(got.at[0], s) < step / 4 && off(got.at[1], t) < step / 0.5);
            if (clamp) /* not modulo anything */
                assert_true(fabs((double)got.at[1] / 1048576 - t) < 0.01);
        }
        sph_machine_free(&m);
    }
    free(mip.texels);
}

/* Where on a sphere of the world a direction lies, whatever the camera. */
static void spheres(void **state) {
    (void)state;
    struct sph_rng rng = vec_seed("spheres");
    struct sph_material white;
    struct sph_scene scene = textured_scene(&white);
    struct sph_texture texture = {
        .path = "noise", .repeat = {3, 0.5}, .offset = {0.25, -0.125}, .line = 5};
    struct sph_mip mip = textured_mip(64, 32, NULL);
    struct sph_sphere ball[3] = {{.ctr = {0, 0, -20}, .rad = 9, .texture = 1},
                                 {.ctr = {0, 9, -50}, .rad = 9, .texture = 1},
                                 {.ctr = {0, 30, -50}, .rad = 4, .texture = 1}};
    scene.n_textures = 1;
    scene.n_spheres = 3;
    scene.textures = &texture;
    scene.spheres = ball;
    scene.camera.at = (struct sph_vec){2, 1, -4};
    struct sph_build_options o = textured_options;
    struct sph_build_report report;
    o.mips = &mip;
    struct sph_machine m = textured_build(&scene, &o, &report);
    assert_ptr_equal(textured_map(&m, 0),
                     textured_map(&m, 1)); /* the same record for equal radii */
    assert_ptr_not_equal(textured_map(&m, 0), textured_map(&m, 2));
    const uint32_t *map = textured_map(&m, 0);
    for (int i = 0; i < 20000; i++) {
        double y = sph_rng_range(&rng, -0.98, 0.98), a = sph_rng_range(&rng, -3.14159, 3.14159);
        double d[3] = {sqrt(1 - y * y) * sin(a), y, sqrt(1 - y * y) * cos(a)}, turn = acos(-1) * 2;
        int32_t unit[3];
        int far = i & 1;
        for (int k = 0; k < 3; k++) {
            double v = 0;
            for (int c = 0; c < 3; c++)
                v += m.rotation[3 * k + c] * d[c];
            unit[k] = (int32_t)lround(far ? -65536 * v : 65536 * v);
        }
        struct sph_st got = sph_coords_sphere(map, unit, far);
        double s = 3 * (0.5 + a / turn) + 0.25; /* t rises from the south pole, downwards here */
        double t = 1 - (0.5 * (0.5 + asin(y) / (turn / 2)) - 0.125);
        assert_true(off(got.at[0], s) < 1e-4 && off(got.at[1], t) < 1e-4);
    }
    sph_machine_free(&m);
    free(mip.texels);
}

/* Clamped, the image goes once from pole to pole and around, offset 0: nothing is modulo 1. */
static void clamped_sphere(void **state) {
    (void)state;
    struct sph_material white;
    struct sph_scene scene = textured_scene(&white);
    struct sph_texture texture = {.path = "noise", .repeat = {1, 2}, .wrap = {1, 1}, .line = 5};
    struct sph_mip mip = textured_mip(64, 32, NULL);
    struct sph_sphere ball = {.ctr = {0, 0, -20}, .rad = 9, .texture = 1};
    scene.n_textures = scene.n_spheres = 1;
    scene.textures = &texture;
    scene.spheres = &ball;
    struct sph_build_options o = textured_options;
    struct sph_build_report report;
    o.mips = &mip;
    struct sph_machine m = textured_build(&scene, &o, &report);
    const int32_t up[3] = {0, 65536, 0}, left[3] = {-65536, 0, 0}, down[3] = {0, -65536, 0};
    const int32_t *const unit[3] = {up, left, down};
    static const double st[3][2] = {{0.5, -1}, {0.25, 0}, {0.5, 1}};
    for (int i = 0; i < 3; i++) {
        struct sph_st got = sph_coords_sphere(textured_map(&m, 0), unit[i], 0);
        for (int k = 0; k < 2; k++)
            assert_true(fabs((double)got.at[k] / (1 << SPH_ST_FRACTION) - st[i][k]) < 1e-4);
    }
    sph_machine_free(&m);
    free(mip.texels);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(triangles),
        cmocka_unit_test(planes),
        cmocka_unit_test(spheres),
        cmocka_unit_test(clamped_sphere),
    };
    return cmocka_run_group_tests_name("texture map", tests, NULL, NULL);
}
