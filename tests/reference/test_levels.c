/* test_levels.c - levels read off pictures, against the model's words and ray differentials; the
 * error of the path length at every angle; ways to choose a level, and what they count
 * SPDX-License-Identifier: Apache-2.0
 */
#include "textured.h"

#include "reference/levels.h"
#include "render/render.h"

enum { W = 32, H = 24, SIDE = 256 };

enum { PLANE, TRIANGLES, BALL };

/* A textured surface ahead, turned by `tilt` degrees away from square to the view: directly, or
 * behind the camera, in a mirror ahead. */
struct stage {
    struct sph_scene scene;
    struct sph_material material[2];
    struct sph_texture texture;
    struct sph_facet facet[3];
    struct sph_sphere ball;
    struct sph_mip mip;
    struct sph_build_options options;
};

static void stage(struct stage *s, int kind, double tilt, int mirrored) {
    double a = tilt * acos(-1) / 180, z = mirrored ? 5 : -10, far = 60;
    static const int corner[2][3][2] = {{{-1, -1}, {1, -1}, {1, 1}}, {{-1, -1}, {1, 1}, {-1, 1}}};
    *s = (struct stage){.options = textured_options};
    s->scene = textured_scene(s->material);
    s->material[1] = s->material[0];
    s->material[1].kd = 0, s->material[1].ks = 1;
    s->texture = (struct sph_texture){.path = "levels", .repeat = {1, 1}, .line = 5};
    s->mip = textured_mip(SIDE, SIDE, NULL);
    struct sph_vec normal = {0, sin(a), cos(a)}, up = {0, cos(a), -sin(a)};
    if (kind == PLANE)
        s->facet[s->scene.n_facets++] = (struct sph_facet){
            .v = {{0, 0, z}, normal, {1, 0, 0}}, .st = {{11, 11}, {0, 0}}, .kind = SPH_PLANE};
    for (int i = 0; i < 2 && kind == TRIANGLES; i++) {
        struct sph_facet *f = &s->facet[s->scene.n_facets++];
        *f = (struct sph_facet){.kind = SPH_TRIANGLE, .group = (uint32_t)i};
        for (int k = 0; k < 3; k++) {
            double x = far * corner[i][k][0], y = far * corner[i][k][1];
            f->v[k] = (struct sph_vec){x, y * up.y, z + y * up.z};
            f->st[k][0] = x / 11, f->st[k][1] = y / 11;
        }
    }
    for (uint32_t i = 0; i < s->scene.n_facets; i++)
        s->facet[i].texture = 1;
    if (mirrored)
        s->facet[s->scene.n_facets++] = (struct sph_facet){
            .kind = SPH_PLANE, .v = {{0, 0, -10}, {0, 0, 1}, {1, 0, 0}}, .group = 2, .material = 1};
    s->ball = (struct sph_sphere){{0, 0, -10}, 4, 0, 9, 1, 0};
    s->scene.n_spheres = kind == BALL;
    s->scene.spheres = &s->ball;
    s->scene.facets = s->facet;
    s->scene.n_materials = 2;
    s->scene.materials = s->material;
    s->scene.n_textures = 1;
    s->scene.textures = &s->texture;
    s->scene.camera.angle = 12;
    s->options.mips = &s->mip;
    s->options.tex_filter = SPH_FILTER_LEVEL;
}

/* Through both renderers. */
static void shoot(const struct stage *s, struct sph_frame *f, struct sph_reference *r) {
    struct sph_build_report report;
    struct sph_counters c = {{0}};
    struct sph_error err = {{0}};
    struct sph_machine m = textured_build(&s->scene, &s->options, &report);
    struct sph_render_options how = {.threads = 1};
    struct sph_reference_options o = {.width = W,
                                      .height = H,
                                      .max_depth = 2,
                                      .reflect = 1,
                                      .threads = 1,
                                      .mips = &s->mip,
                                      .filter = SPH_FILTER_LEVEL};
    assert_int_equal(sph_render(&m, &how, f, &c, &err), 0);
    if (sph_reference_render(&s->scene, &o, r, &err)) fail_msg("%s", err.text);
    sph_machine_free(&m);
}

/* The level that a picture shows is the model's, exactly; where the surface is seen within
 * `degrees` of straight on, it lies within one level of ray differentials. */
static void check(int kind, double tilt, int mirrored, double degrees, int least) {
    struct stage s;
    struct sph_frame f;
    struct sph_reference r;
    int n = 0;
    stage(&s, kind, tilt, mirrored);
    shoot(&s, &f, &r);
    for (int i = 0; i < W * H; i++) {
        const struct sph_reference_pixel *q = &r.pixels[i];
        uint32_t word = f.pixels[i].texture >> SPH_LOD_LSB;
        if (word == SPH_LOD_NONE || f.pixels[i].id != q->id || !q->textured) continue;
        uint32_t red = f.pixels[i].colour[SPH_FRAMES - 1] & 255;
        assert_int_equal(red % 20, 10); /* one level alone */
        assert_int_equal(red / 20, (word + 128) >> 8);
        assert_int_equal(q->via, mirrored ? SPH_VIA_FLAT : SPH_VIA_NOTHING);
        if (q->facing < cos(degrees * acos(-1) / 180)) continue;
        if (fabs(red / 20 - q->lod[SPH_LOD_RAYS]) > 1)
            fail_msg("kind %d, tilt %g, pixel %d: level %u, ray differentials %g", kind, tilt, i,
                     red / 20, q->lod[SPH_LOD_RAYS]);
        n++;
    }
    assert_in_range(n, least, W * H);
    sph_frame_free(&f);
    sph_reference_free(&r);
    free(s.mip.texels);
}

static void pictures(void **state) {
    (void)state;
    for (int mirrored = 0; mirrored < 2; mirrored++)
        for (int kind = PLANE; kind <= TRIANGLES; kind++)
            for (double tilt = 0; tilt <= 75; tilt += 15)
                check(kind, tilt, mirrored, 40, tilt <= 30 ? W * H / 2 : 0);
    check(BALL, 0, 0, 30, 50);
}

/* Path length is off by log2 of the cosine, and so is BMRT's estimate, directly and in a flat
 * mirror; a pixel counts where its angle is. */
static void slants(void **state) {
    (void)state;
    for (int mirrored = 0; mirrored < 2; mirrored++)
        for (double tilt = 12; tilt < 80; tilt += 10) {
            struct stage s;
            struct sph_frame f;
            struct sph_reference r;
            uint64_t n = 0;
            stage(&s, PLANE, tilt, mirrored);
            shoot(&s, &f, &r);
            struct sph_levels e = sph_levels_measure(&f, &r);
            for (int via = 0; via < SPH_VIAS; via++)
                for (int k = 0; k < SPH_SLANTS; k++) {
                    const struct sph_slant *b = &e.slant[via][k];
                    if (!b->pixels) continue;
                    double low = SPH_SLANT_STEP * k * acos(-1) / 180;
                    double top = SPH_SLANT_STEP * (k + 1) * acos(-1) / 180;
                    assert_int_equal(via, mirrored ? SPH_VIA_FLAT : SPH_VIA_NOTHING);
                    assert_true(fabs(SPH_SLANT_STEP * (k + 0.5) - tilt) < 12.5);
                    assert_true(b->path_low >= log2(cos(top)) - 0.05);
                    assert_true(b->path_top <= log2(cos(low)) + 0.05);
                    assert_true(b->path_low <= b->path && b->path <= b->path_top);
                    assert_true(fabs(b->bmrt - b->path) < 1e-6);
                    assert_int_equal(b->near, tilt < 50 ? b->pixels : b->near);
                    n += b->pixels;
                }
            assert_in_range(n, W * H / 2, W * H);
            sph_frame_free(&f);
            sph_reference_free(&r);
            free(s.mip.texels);
        }
}

/* BMRT's estimate of any triangle and any point of a sphere, against lengths by small steps. */
static void estimate(void **state) {
    (void)state;
    struct sph_rng rng = vec_seed("estimate");
    struct sph_texture_view view = {300, 76800, 1, 0};
    double pi = acos(-1);
    for (int i = 0; i < 2000; i++) {
        struct sph_choice c = {.length = sph_rng_range(&rng, 1, 50), .side = {64, 300}};
        struct sph_texture_shape *s = &c.shape;
        double d[2][3], area[2], most = 0, level[SPH_WAYS];
        struct sph_level_work work = {.hits = {0}};
        s->kind = i % 2 ? SPH_SHAPE_TRIANGLE : SPH_SHAPE_SPHERE;
        for (int k = 0; k < 3; k++)
            for (int j = 0; j < 3; j++) {
                s->corner[k][j] = sph_rng_range(&rng, -9, 9);
                if (j < 2) s->st[k][j] = sph_rng_range(&rng, 0.1, 3);
            }
        for (int k = 0; k < 2; k++)
            for (int j = 0; j < 3; j++)
                s->edge[k][j] = s->corner[k + 1][j] - s->corner[0][j];
        for (int j = 0; j < 3; j++)
            s->normal[j] = s->edge[0][(j + 1) % 3] * s->edge[1][(j + 2) % 3] -
                           s->edge[0][(j + 2) % 3] * s->edge[1][(j + 1) % 3];
        double down = sph_rng_range(&rng, 0.2, pi - 0.2), around = sph_rng_range(&rng, -3, 3);
        s->rad = 5;
        c.from[0] = 5 * sin(down) * sin(around), c.from[1] = 5 * cos(down);
        c.from[2] = 5 * sin(down) * cos(around);
        area[0] = s->st[1][0] - s->st[0][0], area[1] = s->st[2][0] - s->st[0][0];
        double b0 = s->st[1][1] - s->st[0][1], b1 = s->st[2][1] - s->st[0][1];
        double det = area[0] * b1 - area[1] * b0; /* s and t as sums of edges */
        for (int j = 0; j < 3; j++) {
            d[0][j] = (b1 * s->edge[0][j] - b0 * s->edge[1][j]) / det;
            d[1][j] = (area[0] * s->edge[1][j] - area[1] * s->edge[0][j]) / det;
        }
        for (int k = 0; k < 2; k++) {
            double length = sqrt(d[k][0] * d[k][0] + d[k][1] * d[k][1] + d[k][2] * d[k][2]);
            if (s->kind == SPH_SHAPE_SPHERE)
                length = (k ? pi * 5 : 2 * pi * 5 * sin(down)) / s->st[0][k];
            most = fmax(most, c.length / 300 / length * c.side[k]);
        }
        sph_choose_all(&c, &view, &work, level);
        assert_true(fabs(level[SPH_WAY_BMRT] - log2(most)) < 1e-9);
        assert_true(level[SPH_WAY_BMRT] == level[SPH_WAY_BMRT_ALONE]);
        assert_true(fabs(level[SPH_WAY_KEPT] - level[SPH_WAY_ANEW]) < 1e-9);
        assert_true(fabs(level[SPH_WAY_KEPT] - level[SPH_WAY_ANEW_ALONE]) < 1e-9);
        assert_int_equal(work.hits[s->kind], 1);
    }
}

/* What a decision counts is what stands in docs/results/texture_results.md, worked out by hand:
 * edges and cross product of a triangle are 6 and 3 additions and 6 products. */
static void counts(void **state) {
    (void)state;
    static const struct sph_flops triangle[SPH_WAYS] = {
        {15, 24, 2, 2, 1}, {21, 24, 2, 2, 1}, {1, 0, 0, 0, 1}, {9, 9, 1, 1, 2}, {18, 15, 1, 1, 2}};
    struct sph_level_work work = {.hits = {0}};
    struct sph_texture_view view = {300, 76800, 1, 0};
    struct sph_choice c = {.shape = {.edge = {{1, 0, 0}, {0, 1, 0}},
                                     .corner = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                                     .normal = {0, 0, 1},
                                     .st = {{0, 0}, {1, 0}, {0, 1}}},
                           .length = 5,
                           .side = {64, 64}};
    double level[SPH_WAYS];
    for (int i = 0; i < 3; i++)
        sph_choose_all(&c, &view, &work, level);
    assert_int_equal(work.hits[SPH_SHAPE_TRIANGLE], 3);
    for (int way = 0; way < SPH_WAYS; way++) {
        const struct sph_flops *f = &work.flops[way][SPH_SHAPE_TRIANGLE], *g = &triangle[way];
        assert_int_equal(f->add, 3 * g->add);
        assert_int_equal(f->mul, 3 * g->mul);
        assert_int_equal(f->div, 3 * g->div);
        assert_int_equal(f->root, 3 * g->root);
        assert_int_equal(f->log, 3 * g->log);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(pictures), cmocka_unit_test(slants),
                                       cmocka_unit_test(estimate), cmocka_unit_test(counts)};
    return cmocka_run_group_tests_name("levels", tests, NULL, NULL);
}
