/* test_render_texture.c - pictures of textures: levels read off chains of one colour a level
 * SPDX-License-Identifier: Apache-2.0
 */
#include "textured.h"
#include "render/render.h"

enum { W = 32, H = 24, SIDE = 256 };

static struct sph_frame render(const struct sph_machine *m, struct sph_render_options o,
                               struct sph_counters *c) {
    struct sph_frame frame;
    struct sph_error err = {{0}};
    memset(c, 0, sizeof *c);
    int errors = sph_render(m, &o, &frame, c, &err);
    if (errors) fail_msg("errors %x %s", (unsigned)errors, err.text);
    return frame;
}

/* A wall across the view, 10 units away, an image of SIDE texels every `repeat` units. */
struct wall {
    struct sph_scene scene;
    struct sph_material material[2];
    struct sph_texture texture;
    struct sph_facet facet[2];
    struct sph_mip mip;
    struct sph_build_options options;
};

static void wall(struct wall *w, double repeat) {
    w->scene = textured_scene(w->material);
    w->texture = (struct sph_texture){.path = "levels", .line = 5};
    w->mip = textured_mip(SIDE, SIDE, NULL);
    w->facet[0] = (struct sph_facet){.kind = SPH_PLANE,
                                     .v = {{0, 0, -10}, {0, 0, 1}, {1, 0, 0}},
                                     .st = {{repeat, repeat}, {0.5, 0.5}, {0, 0}},
                                     .texture = 1};
    w->scene.n_facets = w->scene.n_textures = 1;
    w->scene.facets = w->facet;
    w->scene.textures = &w->texture;
    w->options = textured_options;
    w->options.mips = &w->mip;
}

/* Makes the wall a mirror in which a second one is seen, 5 units behind the camera. */
static void mirrored(struct wall *w) {
    w->scene.camera.angle = 20; /* all of it within the grid */
    w->facet[1] = w->facet[0];
    w->facet[1].v[0].z = 5;
    w->facet[1].group = 1;
    w->facet[1].line = 1;
    w->facet[0].texture = 0;
    w->facet[0].material = 1;
    w->material[1] = (struct sph_material){{1, 1, 1}, 0, 1, 1, 0, 1, 1, {0}, 0};
    w->scene.materials = w->material;
    w->scene.n_materials = w->scene.n_facets = 2;
}

/* log2 of how many texels, along each axis, a pixel of the view covers at the end of a path of
 * `away` units straight ahead. */
static double level(const struct wall *w, int x, int y, double away) {
    double screen = H / 2.0 / tan(w->scene.camera.angle / 2 * acos(-1) / 180);
    double dx = (x - (W - 1) / 2.0) / screen, dy = (y - (H - 1) / 2.0) / screen;
    double path = away * sqrt(1 + dx * dx + dy * dy), texel = w->facet[0].st[0][0] / SIDE;
    return log2(path / screen / texel);
}

/* Every pixel's lod word and colour tell the level that the pixel's size calls for. */
static void check_levels(struct wall *w, double away) {
    struct sph_build_report report;
    struct sph_counters c;
    double worst = 0;
    for (int filter = 0; filter < SPH_FILTERS; filter++) {
        w->options.tex_filter = filter;
        struct sph_machine m = textured_build(&w->scene, &w->options, &report);
        struct sph_frame f = render(&m, (struct sph_render_options){.threads = 1}, &c);
        uint64_t texels = 0;
        for (int i = 0; i < W * H; i++) {
            double lod = (f.pixels[i].texture >> SPH_LOD_LSB) / 256.0;
            double expected = fmin(fmax(level(w, i % W, i / W, away), 0), 8);
            double red = f.pixels[i].colour[2] & 255, shown = (red - 10) / 20;
            if (fabs(lod - expected) > worst) worst = fabs(lod - expected);
            double colour = filter < SPH_FILTER_LEVEL    ? 0
                            : filter == SPH_FILTER_LEVEL ? floor(lod + 0.5)
                                                         : lod;
            if (fabs(shown - colour) > 0.51 / 20)
                fail_msg("filter %d, pixel %d: lod %f, colour shows %f", filter, i, lod, shown);
            int between = filter == SPH_FILTER_BETWEEN && lod != floor(lod);
            texels += filter == SPH_FILTER_NEAREST ? 1 : between ? 8 : 4;
        }
        assert_int_equal(c.count[SPH_COUNT_TEXELS], texels);
        assert_int_equal(c.count[SPH_COUNT_SATURATIONS], 0);
        if (w->facet[0].st[0][0] >
            4) /* where, too, though nothing but the texture needs the point */
            assert_int_not_equal(f.pixels[0].texture, f.pixels[W * H - 1].texture);
        sph_frame_free(&f);
        sph_machine_free(&m);
    }
    printf("# repeat %g, %g away: lod off by at most %.4f\n", w->facet[0].st[0][0], away, worst);
    assert_true(worst < 0.01);
}

static void levels(void **state) {
    (void)state;
    static const double repeat[] = {100, 30, 11, 4, 1.5, 0.3, 0.05};
    for (size_t i = 0; i < sizeof repeat / sizeof *repeat; i++) {
        struct wall w;
        wall(&w, repeat[i]);
        check_levels(&w, 10);
        free(w.mip.texels);
    }
}

/* The path in the mirror: 10 to the first wall, 15 to the second. */
static void mirrors(void **state) {
    (void)state;
    struct wall w;
    wall(&w, 6);
    mirrored(&w);
    check_levels(&w, 25);
    free(w.mip.texels);
}

/* As printed, the formula chooses other levels: here the finest one for a wall far too fine. */
static void literal(void **state) {
    (void)state;
    struct sph_build_report report;
    struct sph_counters c;
    struct wall w;
    wall(&w, 0.3);
    for (w.options.lod_literal = 0; w.options.lod_literal < 2; w.options.lod_literal++) {
        struct sph_machine m = textured_build(&w.scene, &w.options, &report);
        struct sph_frame f = render(&m, (struct sph_render_options){.threads = 1}, &c);
        uint32_t lod = f.pixels[W * H / 2].texture >> SPH_LOD_LSB;
        assert_true(w.options.lod_literal ? lod == 0 : lod > 7 * 256);
        sph_frame_free(&f);
        sph_machine_free(&m);
    }
    free(w.mip.texels);
}

/* A level is the nearest one with the bits of fraction that are left, upwards from the middle. */
static void coarse(void **state) {
    (void)state;
    struct sph_build_report report;
    struct sph_counters c;
    struct wall w;
    wall(&w, 4);
    struct sph_machine m = textured_build(&w.scene, &w.options, &report);
    struct sph_frame fine = render(&m, (struct sph_render_options){.threads = 1}, &c);
    for (int drop = 0; drop <= 8; drop++) {
        m.regs[SPH_REG_COARSE] = drop;
        struct sph_frame f = render(&m, (struct sph_render_options){.threads = 1}, &c);
        for (int i = 0; i < W * H; i++) {
            double lod = fine.pixels[i].texture >> SPH_LOD_LSB, step = ldexp(1, drop);
            assert_int_equal(f.pixels[i].texture >> SPH_LOD_LSB, floor(lod / step + 0.5) * step);
        }
        sph_frame_free(&f);
    }
    sph_frame_free(&fine);
    sph_machine_free(&m);
    free(w.mip.texels);
}

/* What the callback was told of a frame. */
struct told {
    uint64_t texels, words;
    const struct sph_machine *m;
};

static void fetched(void *user, const struct sph_texel *texel) {
    struct told *t = user;
    t->texels++;
    t->words += texel->word;
    assert_in_range(texel->word, 0, (uint64_t)t->m->lines * SPH_LINE_WORDS - 1);
    assert_true(texel->x < texel->width);
}

/* The callback sees every texel; the words of pixels sum their addresses, whatever the traversal
 * and the threads. */
static void fetches(void **state) {
    (void)state;
    struct sph_rng rng = vec_seed("fetches");
    struct sph_build_report report;
    struct sph_counters c;
    struct wall w;
    wall(&w, 2);
    free(w.mip.texels);
    w.mip = textured_mip(37, 50, &rng);
    mirrored(&w);
    w.facet[0].texture = 1; /* both: two lookups a pixel */
    w.material[1].kd = w.material[1].ks = 0.5;
    struct sph_machine m = textured_build(&w.scene, &w.options, &report);
    struct told told = {0, 0, &m};
    struct sph_frame f = render(
        &m, (struct sph_render_options){.threads = 1, .fetch = fetched, .fetch_user = &told}, &c);
    uint64_t words = 0;
    for (int i = 0; i < W * H; i++)
        words += f.pixels[i].texture & 0xfffff;
    assert_int_equal(told.texels, c.count[SPH_COUNT_TEXELS]);
    assert_in_range(told.texels, 2 * 4 * W * H + 1, 2 * 8 * W * H);
    assert_int_equal(told.words % (1 << 20), words % (1 << 20));
    struct sph_frame g =
        render(&m, (struct sph_render_options){.threads = 3, .traverse = SPH_TRAVERSE_BRUTE}, &c);
    assert_int_equal(sph_frame_picture_hash(&f), sph_frame_picture_hash(&g));
    g.pixels[5].texture ^= 1u << 20;
    assert_int_not_equal(sph_frame_picture_hash(&f), sph_frame_picture_hash(&g));
    sph_frame_free(&g);
    sph_frame_free(&f);
    sph_machine_free(&m);
    free(w.mip.texels);
}

/* An image of white changes no colour; nor does a scene whose images are left out. */
static void white_image(void **state) {
    (void)state;
    struct sph_build_report report;
    struct sph_counters c;
    struct sph_frame f[3];
    struct wall w;
    wall(&w, 2);
    for (size_t i = 0; i < sph_mip_at(&w.mip, w.mip.levels); i++)
        w.mip.texels[i] = 0xffffffff;
    mirrored(&w);
    w.facet[0].texture = 1;
    w.material[0].rgb[1] = 0.3;
    w.material[1] = (struct sph_material){{0.9, 0.5, 0.1}, 0.6, 0.4, 1, 0, 1, 1, {0}, 0};
    struct sph_sphere ball = {.ctr = {1, 1, -6}, .rad = 2, .material = 1, .texture = 1};
    w.texture.repeat[0] = w.texture.repeat[1] = 1;
    w.scene.spheres = &ball;
    w.scene.n_spheres = 1;
    w.scene.n_lights = 1;
    w.scene.lights[0] = (struct sph_light){{3, 3, 3}, {0.5, 0.6, 0.7}, 9};
    for (int i = 0; i < 3; i++) {
        if (i == 1) w.options.texture = SPH_OFF;
        if (i == 2) w.facet[0].texture = w.facet[1].texture = ball.texture = 0;
        struct sph_machine m = textured_build(&w.scene, &w.options, &report);
        f[i] = render(&m, (struct sph_render_options){.threads = 1}, &c);
        sph_machine_free(&m);
    }
    for (int i = 0; i < W * H; i++) {
        assert_memory_equal(f[0].pixels[i].colour, f[2].pixels[i].colour, sizeof f->pixels->colour);
        assert_int_not_equal(f[0].pixels[i].texture, SPH_NO_TEXTURE);
        assert_int_equal(f[2].pixels[i].texture, SPH_NO_TEXTURE);
    }
    assert_int_equal(sph_frame_hash(&f[1]), sph_frame_hash(&f[2]));
    for (int i = 0; i < 3; i++)
        sph_frame_free(&f[i]);
    free(w.mip.texels);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(levels),  cmocka_unit_test(mirrors),     cmocka_unit_test(literal),
        cmocka_unit_test(fetches), cmocka_unit_test(white_image), cmocka_unit_test(coarse),
    };
    return cmocka_run_group_tests_name("render texture", tests, NULL, NULL);
}
