/* test_reference_texture.c - ray differentials against finite differences, levels of every way, and
 * textured pictures of the model against the double reference
 * SPDX-License-Identifier: Apache-2.0
 */
#include "textured.h"
#include "uncut.h"

#include "reference/levels.h"
#include "render/render.h"

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* A ray from the eye at x, y, over a mirror ball onto a floor: where it ends, and its path there.
 */
struct shot {
    double at[3], dir[3];
    struct sph_ref_path path;
};

enum { FROM_OUTSIDE, FROM_INSIDE };

static void shoot(double x, double y, int from, struct shot *s) {
    static const double right[3] = {1, 0, 0}, up[3] = {0, 1, 0}, floor_normal[3] = {0.1, 2, -0.3};
    const double ctr[3] = {0.3, 0.2, from == FROM_OUTSIDE ? -9 : -1}, rad = 3;
    double org[3] = {0, 0, 0}, normal[3], oc[3];
    s->dir[0] = x, s->dir[1] = y, s->dir[2] = -40;
    sph_ref_path_start(&s->path, s->dir, right, up);
    for (int k = 0; k < 2; k++) /* unit directions turn, they do not grow */
        assert_true(fabs(dot(s->path.dir[k], s->dir)) < 1e-12);
    for (int i = 0; i < 3; i++)
        oc[i] = org[i] - ctr[i];
    double a = dot(s->dir, s->dir), b = dot(oc, s->dir), c = dot(oc, oc) - rad * rad;
    double root = sqrt(b * b - a * c), t = (-b + (from == FROM_OUTSIDE ? -root : root)) / a;
    for (int i = 0; i < 3; i++) {
        org[i] += t * s->dir[i];
        normal[i] = (org[i] - ctr[i]) * (from == FROM_OUTSIDE ? 7 : -7);
    }
    sph_ref_path_hit(&s->path, s->dir, t, normal);
    sph_ref_path_mirror(&s->path, s->dir, normal, (from == FROM_OUTSIDE ? 1 : -1) / rad);
    double turn = 2 * dot(s->dir, normal) / dot(normal, normal);
    for (int i = 0; i < 3; i++)
        s->dir[i] -= turn * normal[i];
    t = (-5 - dot(org, floor_normal)) / dot(s->dir, floor_normal);
    sph_ref_path_hit(&s->path, s->dir, t, floor_normal);
    for (int i = 0; i < 3; i++)
        s->at[i] = org[i] + t * s->dir[i];
}

static void differentials(void **state) {
    (void)state;
    for (int from = FROM_OUTSIDE; from <= FROM_INSIDE; from++)
        for (int i = 0; i < 100; i++) {
            const double h = 1e-4, x = i % 10 - 5.3, y = -2.7 + 0.2 * i / 10.0;
            struct shot s = {0}, step[2][2] = {0};
            shoot(x, y, from, &s);
            for (int side = 0; side < 2; side++) {
                shoot(x + (side ? h : -h), y, from, &step[0][side]);
                shoot(x, y + (side ? h : -h), from, &step[1][side]);
            }
            for (int axis = 0; axis < 2; axis++) {
                double size = sqrt(dot(s.path.org[axis], s.path.org[axis]));
                for (int k = 0; k < 3; k++) {
                    double by = (step[axis][1].at[k] - step[axis][0].at[k]) / (2 * h);
                    assert_true(fabs(by - s.path.org[axis][k]) < 1e-5 * size);
                }
            }
        }
}

/* A wall square to the view: all ways but the printed one agree; texels twice as long one way raise
 * BMRT's estimate and the differentials by half a level above the mean that P_b is. */
static void ways_agree(void **state) {
    (void)state;
    struct sph_material white;
    struct sph_scene scene = textured_scene(&white);
    struct sph_texture texture = {.path = "levels", .line = 5};
    struct sph_mip mip = textured_mip(256, 64, NULL); /* square texels all the same */
    struct sph_facet facet = {.kind = SPH_PLANE,
                              .v = {{0, 0, -10}, {0, 0, 1}, {1, 0, 0}},
                              .st = {{6, 1.5}, {0, 0}, {0, 0}},
                              .texture = 1};
    scene.n_facets = scene.n_textures = 1;
    scene.facets = &facet;
    scene.textures = &texture;
    for (int longer = 0; longer < 2; longer++) {
        facet.st[0][0] = 6 << longer;
        struct sph_reference_options o = {
            .width = 33, .height = 25, .mips = &mip, .filter = SPH_FILTER_BETWEEN};
        struct sph_reference r;
        struct sph_error err = {{0}};
        if (sph_reference_render(&scene, &o, &r, &err)) fail_msg("%s", err.text);
        const struct sph_reference_pixel *p = &r.pixels[33 * 12 + 16]; /* the middle */
        double mended = p->lod[SPH_LOD_MENDED];
        assert_true(p->textured && mended > 3 && mended < 6);
        assert_true(fabs(p->lod[SPH_LOD_BMRT] - mended - 0.5 * longer) < 1e-9);
        assert_true(fabs(p->lod[SPH_LOD_RAYS] - mended - 0.5 * longer) < 1e-9);
        assert_true(fabs(p->lod[SPH_LOD_PRINTED] - mended) > 1);
        double red = p->colour[0] & 255; /* the colour is that of the level */
        assert_true(fabs((red - 10) / 20 - mended) < 0.51 / 20);
        sph_reference_free(&r);
    }
    free(mip.texels);
}

/* On a sphere a footprint's size in the image is that of its ends: by coordinates, not gradients.
 */
static void sphere_footprints(void **state) {
    (void)state;
    struct sph_rng rng = vec_seed("sphere_footprints");
    struct sph_material white;
    struct sph_scene scene = textured_scene(&white);
    struct sph_texture texture = {.path = "levels", .repeat = {3, 2}, .line = 5};
    struct sph_mip mip = textured_mip(1024, 512, NULL);
    struct sph_sphere ball = {.ctr = {1, 2, 3}, .rad = 5, .texture = 1};
    scene.n_spheres = scene.n_textures = 1;
    scene.spheres = &ball;
    scene.textures = &texture;
    struct sph_ref_textures r = {&scene, &mip, SPH_FILTER_BETWEEN, SPH_LOD_RAYS, 100, 100, 0};
    double pi = acos(-1.0);
    for (int i = 0; i < 2000; i++) {
        double b = sph_rng_range(&rng, 0.3, pi - 0.3), a = sph_rng_range(&rng, -3, 3), rgb[3];
        double n[3] = {sin(b) * sin(a), cos(b), sin(b) * cos(a)}, lod[SPH_LODS], step[3], at[3];
        struct sph_ref_path path = {.length = 1};
        const double ctr[3] = {ball.ctr.x, ball.ctr.y, ball.ctr.z};
        double along = 0, h = 1e-5;
        for (int k = 0; k < 3; k++) {
            at[k] = ctr[k] + 5 * n[k];
            step[k] = sph_rng_range(&rng, -1, 1);
            along += step[k] * n[k];
        }
        for (int k = 0; k < 3; k++) {
            step[k] -= along * n[k];
            path.org[i % 2][k] = step[k];
            n[k] += h * step[k] / 5;
        }
        assert_int_equal(sph_ref_texture(&r, 0, at, &path, rgb, lod, NULL), 1);
        double du = 3 * 1024 * (atan2(n[0], n[2]) - a) / (2 * pi) / h;
        double dv = 2 * 512 * (atan2(hypot(n[0], n[2]), n[1]) - b) / pi / h;
        double expected = log2(hypot(du, dv));
        if (expected > 0.1) assert_true(fabs(lod[SPH_LOD_RAYS] - expected) < 1e-3);
    }
    free(mip.texels);
}

/* A chain without sharp edges, its levels made by averaging. */
static struct sph_mip smooth(int side) {
    struct sph_mip mip = textured_mip(side, side, NULL);
    for (int l = 0; l < mip.levels; l++) {
        int n = side >> l;
        uint32_t *level = mip.texels + sph_mip_at(&mip, l);
        const uint32_t *finer = l ? mip.texels + sph_mip_at(&mip, l - 1) : NULL;
        for (int i = 0; i < n * n; i++) {
            uint32_t word = 0;
            int x = i % n, y = i / n;
            for (int c = 0; c < 3; c++) {
                double v = 128 + 60 * sin(2 * acos(-1) * (x + c * 20) / n * 2) +
                           60 * cos(2 * acos(-1) * y / n);
                for (int k = 0; k < 4 && finer; k++)
                    v = (k ? v : 0) +
                        (finer[(2 * y + k / 2) * 2 * n + 2 * x + k % 2] >> 8 * c & 255) / 4.0;
                word |= (uint32_t)lround(v) << 8 * c;
            }
            level[i] = word;
        }
    }
    return mip;
}

/* The hall with smooth images: every profile within its floor, levels as the reference has them. */
static void hall(void **state) {
    (void)state;
    static const double floors[SPH_PROFILES] = {35, 44, 53, 55};
    struct sph_scene scene;
    struct sph_error err = {{0}};
    struct sph_read_options read = {0};
    struct sph_mip mips[3];
    enum { W = VEC_SHARE > 1 ? 32 : 96, H = VEC_SHARE > 1 ? 18 : 54 };
    if (sph_scene_read("scenes/texture/hall.nff", &read, &scene, &err)) fail_msg("%s", err.text);
    assert_int_equal(scene.n_textures, 3);
    for (int i = 0; i < 3; i++)
        mips[i] = smooth(128 << i);
    for (int profile = 0; profile < SPH_PROFILES; profile++) {
        struct sph_build_options o = textured_options;
        struct sph_build_report report;
        struct sph_counters c = {{0}};
        o.profile = profile;
        o.width = W, o.height = H;
        o.mips = mips;
        struct sph_machine m = textured_build(&scene, &o, &report);
        struct sph_render_options how = {.threads = 1};
        struct sph_reference_options ref = {.width = W,
                                            .height = H,
                                            .max_depth = o.max_depth,
                                            .shadow = 1,
                                            .reflect = 1,
                                            .threads = 1,
                                            .world = &m,
                                            .mips = mips,
                                            .filter = o.tex_filter};
        struct sph_frame f;
        struct sph_reference r;
        assert_int_equal(sph_render(&m, &how, &f, &c, &err), 0);
        if (sph_reference_render(&scene, &ref, &r, &err)) fail_msg("%s", err.text);
        uncut(&f, &r);
        struct sph_image_error e = sph_reference_compare(&f, &r);
        struct sph_levels l = sph_levels_measure(&f, &r);
        printf("# %-9s %.1f dB, %lu of %lu off by more than 8; lod off by %.4f on the mean\n",
               sph_profiles[profile].name, e.psnr[2], e.far_off, e.pixels, l.model_mean);
        assert_true(e.psnr[2] > floors[profile]);
        assert_true(l.pixels > W * H / 3 && l.model_mean < 0.007);
        sph_frame_free(&f);
        sph_reference_free(&r);
        sph_machine_free(&m);
    }
    for (int i = 0; i < 3; i++)
        free(mips[i].texels);
    sph_scene_free(&scene);
}

/* One shot of a scene at W x H by its images' sizes, with SPREAD or without it. */
static struct sph_levels levels_of(const struct sph_scene *scene, const struct sph_mip *mips,
                                   int spread) {
    enum { W = 160, H = 90 };
    struct sph_build_options o = textured_options;
    struct sph_build_report report;
    struct sph_counters c = {{0}};
    struct sph_error err = {{0}};
    struct sph_frame f;
    struct sph_reference r;
    o.width = W, o.height = H, o.mips = mips;
    o.refract = SPH_AUTO, o.spread = spread;
    struct sph_machine m = textured_build(scene, &o, &report);
    assert_int_equal(sph_machine_effect(&m, SPH_EFFECT_SPREAD), spread == SPH_AUTO);
    assert_int_equal(strstr(report.warning, "spread off") != NULL, spread != SPH_AUTO);
    struct sph_render_options how = {.threads = 1};
    struct sph_reference_options ref = {.width = W,
                                        .height = H,
                                        .max_depth = o.max_depth,
                                        .shadow = 1,
                                        .reflect = 1,
                                        .refract = 1,
                                        .threads = 1,
                                        .world = &m,
                                        .mips = mips,
                                        .filter = o.tex_filter,
                                        .spread = spread == SPH_AUTO};
    assert_int_equal(sph_render(&m, &how, &f, &c, &err), 0);
    if (sph_reference_render(scene, &ref, &r, &err)) fail_msg("%s", err.text);
    struct sph_levels l = sph_levels_measure(&f, &r);
    sph_frame_free(&f);
    sph_reference_free(&r);
    sph_machine_free(&m);
    return l;
}

/* Seen by way of balls that mirror, levels come nearer to those of ray differentials, on the mean
 * and from pixel to pixel; through one of glass on the mean. Seen directly they stay. */
static void spread(void **state) {
    (void)state;
    static const struct {
        const char *name;
        int glass; /* 1: what mirrors is made of glass */
        uint64_t pixels;
        double mean, deviation; /* of what was */
    } scenes[] = {{"hall", 0, 300, 0.3, 0.6},
                  {"museum", 0, 80, 0.2, 0.6},
                  {"slant", 0, 900, 0.2, 0.9},
                  {"hall", 1, 500, 0.1, 1.2}};
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++) {
        char path[64];
        struct sph_scene scene;
        struct sph_error err = {{0}};
        struct sph_read_options read = {0};
        struct sph_mip mips[16];
        snprintf(path, sizeof path, "scenes/texture/%s.nff", scenes[i].name);
        if (sph_scene_read(path, &read, &scene, &err)) fail_msg("%s", err.text);
        assert_in_range(scene.n_textures, 1, 16);
        for (uint32_t t = 0; t < scene.n_textures; t++)
            mips[t] = textured_mip(256, 256, NULL);
        for (uint32_t k = 0; k < scene.n_materials; k++) {
            struct sph_material *m = &scene.materials[k];
            if (!scenes[i].glass || m->ks < 0.5) continue;
            m->sum = (struct sph_sum){.on = 1, .ka = 0.1};
            m->ks = 0, m->trans = 0.9, m->ior = 1.5;
        }
        struct sph_levels off = levels_of(&scene, mips, SPH_OFF);
        struct sph_levels on = levels_of(&scene, mips, SPH_AUTO);
        const struct sph_level_error *was = &off.error[SPH_VIA_CURVED];
        const struct sph_level_error *is = &on.error[SPH_VIA_CURVED];
        printf("# %s%s: %lu pixels by way of balls: %+.2f levels off, deviation %.2f; now %+.2f, "
               "%.2f; model off by %.4f on the mean\n",
               scenes[i].name, scenes[i].glass ? ", glass" : "", is->pixels, was->mean,
               was->deviation, is->mean, is->deviation, on.model_mean);
        assert_true(is->pixels == was->pixels && is->pixels >= scenes[i].pixels);
        assert_true(fabs(is->mean) < scenes[i].mean * fabs(was->mean));
        assert_true(is->deviation < scenes[i].deviation * was->deviation);
        assert_true(on.model_mean < 0.05); /* powers of two against real numbers */
        assert_memory_equal(&on.error[SPH_VIA_NOTHING], &off.error[SPH_VIA_NOTHING],
                            sizeof on.error[0]);
        for (uint32_t t = 0; t < scene.n_textures; t++)
            free(mips[t].texels);
        sph_scene_free(&scene);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(differentials),
        cmocka_unit_test(ways_agree),
        cmocka_unit_test(sphere_footprints),
        cmocka_unit_test(hall),
        cmocka_unit_test(spread),
    };
    return cmocka_run_group_tests_name("reference texture", tests, NULL, NULL);
}
