/* test_build_texture.c - images in memory, P_b, and what is refused
 * SPDX-License-Identifier: Apache-2.0
 */
#include "textured.h"

#include "builder/texture/texture.h"
#include "scene/texture_base.h"
#include "validate/validate.h"

static void free_all(struct sph_machine *m, struct sph_mip *mip) {
    sph_machine_free(m);
    free(mip->texels);
}

/* P_b means what it says: at that distance a pixel has the area of a texel; each doubling adds 1.
 */
static void base(void **state) {
    (void)state;
    struct sph_rng rng = vec_seed("base");
    struct sph_flops f = {0};
    for (int i = 0; i < 2000; i++) {
        struct sph_texture_area area = {sph_rng_range(&rng, 1, 1e6), sph_rng_range(&rng, 0.001, 9),
                                        sph_rng_range(&rng, 16, 4e6)};
        struct sph_texture_view view = {sph_rng_range(&rng, 50, 5000), 320 * 240, 0.01, 0};
        double away = exp2(sph_texture_base(&area, &view, &f) / 256.0);
        double pixel = away / view.distance, texel = area.size / (area.share * area.texels);
        assert_true(fabs(log2(pixel * pixel / texel)) < 2 * 1 / 256.0);
        struct sph_texture_area finer = area; /* twice as many texels along each axis */
        finer.texels *= 4;
        int one = sph_texture_base(&area, &view, &f) - sph_texture_base(&finer, &view, &f);
        assert_in_range(one, 255, 257); /* the level rises by 1 */
        view.literal = 1;
        int two = sph_texture_base(&finer, &view, &f) - sph_texture_base(&area, &view, &f);
        assert_in_range(two, 511, 513); /* as printed it falls, and by 2 */
    }
    struct sph_texture_area none = {100, 0, 256};
    struct sph_texture_view view = {300, 76800, 1, 0};
    assert_int_equal(sph_texture_base(&none, &view, &f), 32767);
    none.share = 1e300;
    assert_int_equal(sph_texture_base(&none, &view, &f), -32768);
}

/* Every texel of every level stands where the header and the tiles say; equal images once. */
static void images(void **state) {
    (void)state;
    struct sph_rng rng = vec_seed("images");
    struct sph_material white;
    struct sph_scene scene = textured_scene(&white);
    struct sph_texture texture[4] = {{.path = "a", .repeat = {1, 1}, .line = 5},
                                     {.path = "b", .repeat = {1, 1}, .line = 6},
                                     {.path = "a", .repeat = {2, 1}, .line = 7},
                                     {.path = "unused", .repeat = {2, 1}, .line = 8}};
    struct sph_mip mip[4] = {textured_mip(37, 21, &rng), textured_mip(1, 130, &rng)};
    struct sph_sphere ball[3];
    for (uint32_t i = 0; i < 3; i++)
        ball[i] = (struct sph_sphere){{20.0 * i, 0, -50}, 9, 0, i + 9, i + 1, 0};
    mip[2] = mip[0];
    mip[3] = (struct sph_mip){4096, 4096, 13, 0, NULL}; /* never looked at */
    scene.n_textures = 4;
    scene.n_spheres = 3;
    scene.textures = texture;
    scene.spheres = ball;
    struct sph_build_options o = textured_options;
    struct sph_build_report report;
    o.mips = mip;
    o.background = SPH_BG_SPANS; /* its table lies in front */
    o.bg_border = 1;
    struct sph_machine m = textured_build(&scene, &o, &report);
    assert_non_null(strstr(report.effects[SPH_REPORT_TEXTURE].why,
                           "3 primitives with an image, 3 mappings, 2 images"));
    uint32_t image[3];
    for (uint32_t i = 0; i < 3; i++)
        image[i] = sph_field(textured_map(&m, i), SPH_MAP_IMAGE_LSB, SPH_MAP_IMAGE_BITS);
    assert_int_equal(image[0], image[2]);
    assert_int_not_equal(image[0], image[1]);
    for (uint32_t i = 0; i < 2; i++) {
        const uint32_t *head = m.mem + (size_t)image[i] * SPH_LINE_WORDS, *texel = mip[i].texels;
        for (int l = 0; l < mip[i].levels; l++) {
            uint32_t w = sph_level_size((uint32_t)mip[i].width, l);
            uint32_t h = sph_level_size((uint32_t)mip[i].height, l);
            uint32_t first = l ? sph_field(head, 28 + 20 * (l - 1), 20) : 0;
            for (uint32_t y = 0; y < h; y++)
                for (uint32_t x = 0; x < w; x++)
                    assert_int_equal(head[8 * (1 + first) + sph_texel_word(w, x, y)], *texel++);
        }
    }
    free(mip[1].texels);
    free_all(&m, mip);
}

/* A scene of one sphere and one triangle with a texture, changed in one place. */
struct broken {
    struct sph_texture texture;
    struct sph_facet facet;
    int plane;
    const char *message;
};

static void refused(void **state) {
    (void)state;
    const struct sph_texture t = {.path = "a", .repeat = {1, 1}, .line = 5};
    const struct sph_facet f = {.kind = SPH_TRIANGLE,
                                .v = {{-1, 0, -9}, {1, 0, -9}, {0, 1, -9}},
                                .st = {{0, 0}, {1, 0}, {0, 1}},
                                .texture = 1,
                                .line = 9};
    const struct sph_facet p = {.kind = SPH_PLANE,
                                .v = {{0, -2, 0}, {0, 1, 0}, {1, 0, 0}},
                                .st = {{1, 1}, {0, 0}, {0, 0}},
                                .texture = 1,
                                .line = 9};
    struct broken list[] = {
        {t, f, 0, "textured.nff:9: a texture coordinate of 40000, at most 32767"},
        {t, f, 0, "textured.nff:9: a texture coordinate of nan"},
        {t, f, 0, "textured.nff:5: 0.001 repeats on a sphere"},
        {t, f, 0, "textured.nff:5: 128 repeats on a sphere"},
        {t, f, 0, "textured.nff:5: an offset of -8 on a sphere, clamped"},
        {t, p, 1, "textured.nff:9: repeats of 1e-20 are too small for the grid"},
        {t, p, 1, "textured.nff:9: clamped repeats of 1e-06 are too small for the scene"},
        {t, f, 0, "textured.nff:9: there is no texture 2"},
    };
    list[0].facet.st[1][1] = 40000;
    list[1].facet.st[2][0] = NAN;
    list[2].texture.repeat[1] = 0.001;
    list[3].texture.repeat[0] = 128;
    list[4].texture.wrap[0] = 1, list[4].texture.offset[0] = -8;
    list[5].facet.st[0][1] = 1e-20;
    list[6].texture.wrap[1] = 1, list[6].facet.st[0][1] = 1e-6;
    list[7].facet.texture = 2;
    struct sph_material white;
    struct sph_scene scene = textured_scene(&white);
    struct sph_mip mip = textured_mip(8, 8, NULL);
    struct sph_sphere ball = {.ctr = {0, 0, -20}, .rad = 3, .texture = 1};
    scene.n_textures = scene.n_facets = scene.n_spheres = 1;
    scene.spheres = &ball;
    struct sph_build_options o = textured_options;
    struct sph_build_report report;
    struct sph_machine m;
    o.mips = &mip;
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        struct sph_error err = {{0}};
        scene.textures = &list[i].texture;
        scene.facets = &list[i].facet;
        ball.texture = !list[i].plane;
        assert_int_equal(sph_build(&scene, &o, &m, &report, &err), -1);
        if (!strstr(err.text, list[i].message))
            fail_msg("%s, expected %s", err.text, list[i].message);
    }
    struct sph_error err = {{0}};
    list[0].facet = f;
    scene.textures = &list[0].texture;
    scene.facets = &list[0].facet;
    o.mips = NULL;
    assert_int_equal(sph_build(&scene, &o, &m, &report, &err), -1);
    assert_non_null(strstr(err.text, "textured.nff:5: the images of the scene were not read"));
    o.texture = SPH_OFF; /* then it is the machine without, with a warning */
    m = textured_build(&scene, &o, &report);
    assert_false(sph_machine_effect(&m, SPH_EFFECT_TEXTURE));
    assert_null(textured_map(&m, 0));
    assert_non_null(strstr(report.warning, "texture off: 2 primitives have an image"));
    free_all(&m, &mip);
}

/* Words that validation refuses, one at a time. */
static void invalid(void **state) {
    (void)state;
    struct sph_material white;
    struct sph_scene scene = textured_scene(&white);
    struct sph_texture texture = {.path = "a", .repeat = {1, 1}, .line = 5};
    struct sph_mip mip = textured_mip(37, 21, NULL);
    struct sph_sphere ball = {.ctr = {0, 0, -20}, .rad = 3, .texture = 1};
    scene.n_textures = scene.n_spheres = 1;
    scene.spheres = &ball;
    scene.textures = &texture;
    struct sph_build_options o = textured_options;
    struct sph_build_report report;
    o.mips = &mip;
    struct sph_machine m = textured_build(&scene, &o, &report);
    uint32_t prim = (uint32_t)m.regs[SPH_REG_PRIM_BASE];
    uint32_t map = sph_field(m.mem + 8 * prim, SPH_PRIM_TEX_LSB, SPH_PRIM_TEX_BITS);
    uint32_t image = sph_field(m.mem + 8 * map, SPH_MAP_IMAGE_LSB, SPH_MAP_IMAGE_BITS);
    const struct {
        uint32_t line;
        int lsb, bits;
        uint32_t value;
        const char *message;
    } list[] = {
        {prim, SPH_PRIM_TEX_LSB, 26, m.lines, "primitive 0: mapping at line"},
        {prim, SPH_PRIM_TEX_LSB, 26, prim, "primitive 0: mapping at line"},
        {map, SPH_MAP_KIND_LSB, 2, 2, "mapping of kind 2"},
        {map, SPH_MAP_IMAGE_LSB, 26, m.lines, "image at line"},
        {map, SPH_MAP_IMAGE_LSB, 26, 0, "image at line 0"},
        {map, SPH_MAP_IMAGE_LSB, 26, m.lines - 1, "image of"},
        {image, SPH_IMAGE_W_LSB, 12, 2048, "image of 2049 x 21 texels"},
        {image, SPH_IMAGE_LEVELS_LSB, 4, 5, "has 5 levels"},
        {image, SPH_IMAGE_LEVELS_LSB, 4, 0, "has 0 levels"},
        {image, SPH_IMAGE_FIRST_LSB, 20, 1, "level 1 starts at line 1"},
        {image, SPH_IMAGE_FIRST_LSB + 80, 20, 9, "level 5 starts at line 9"},
    };
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        struct sph_error err = {{0}};
        uint32_t *line = m.mem + 8 * (size_t)list[i].line;
        uint32_t before = sph_field(line, list[i].lsb, list[i].bits);
        sph_field_set(line, list[i].lsb, list[i].bits, list[i].value);
        assert_int_equal(sph_machine_validate(&m, &err), -1);
        if (!strstr(err.text, list[i].message))
            fail_msg("%s, expected %s", err.text, list[i].message);
        sph_field_set(line, list[i].lsb, list[i].bits, before);
    }
    struct sph_error err = {{0}};
    m.lines--, m.regs[SPH_REG_MEM_LINES]--;
    assert_int_equal(sph_machine_validate(&m, &err), -1);
    assert_non_null(strstr(err.text, "memory has"));
    free_all(&m, &mip);
}

/* How spheres spread rays: those alone that rays leave, if there is an image; by their radius. */
static void bends(void **state) {
    (void)state;
    for (int64_t r = 1; r < 1 << 24; r += 1 + r / 7) {
        double off = sph_bend_of(r) - SPH_BEND_ONE - 2 * log2((double)r);
        assert_true(fabs(off) <= 0.5 &&
                    sph_bend_of(r) + SPH_BEND_THROUGH < 1 << SPH_PRIM_BEND_BITS);
    }
    struct sph_material look[2];
    struct sph_scene scene = textured_scene(look);
    struct sph_texture texture = {.path = "a", .repeat = {1, 1}, .line = 5};
    struct sph_mip mip = textured_mip(37, 21, NULL);
    struct sph_sphere ball[2] = {{.ctr = {-3, 0, -20}, .rad = 3, .texture = 1},
                                 {.ctr = {3, 0, -20}, .rad = 1.5, .material = 1}};
    look[1] = look[0];
    scene.n_textures = 1, scene.n_spheres = scene.n_materials = 2;
    scene.spheres = ball;
    scene.textures = &texture;
    for (int i = 0; i < 8; i++) { /* bits: mirrors, texture, spread */
        struct sph_build_options o = textured_options;
        struct sph_build_report report;
        o.mips = &mip;
        o.texture = i & 2 ? SPH_AUTO : SPH_OFF;
        o.spread = i & 4 ? SPH_AUTO : SPH_OFF;
        look[1].ks = i & 1;
        struct sph_machine m = textured_build(&scene, &o, &report);
        const uint32_t *prim = m.mem + 8 * (size_t)m.regs[SPH_REG_PRIM_BASE];
        assert_int_equal(sph_machine_effect(&m, SPH_EFFECT_SPREAD), i == 7);
        assert_int_equal(report.effects[SPH_REPORT_SPREAD].called, (i & 3) == 3);
        assert_int_equal(strstr(report.warning, "spread off: as asked") != NULL, i == 3);
        assert_int_equal(sph_field(prim, SPH_PRIM_BEND_LSB, SPH_PRIM_BEND_BITS), 0);
        uint32_t rad = sph_field(prim + 8, SPH_LEAF_RAD_LSB, SPH_LEAF_RAD_BITS);
        assert_int_equal(sph_field(prim + 8, SPH_PRIM_BEND_LSB, SPH_PRIM_BEND_BITS),
                         i == 7 ? sph_bend_of(rad) : 0);
        sph_machine_free(&m);
        o.spread = SPH_ON; /* as asked: refused without images */
        if (!(i & 2)) {
            struct sph_error err = {{0}};
            assert_int_equal(sph_build(&scene, &o, &m, &report, &err), -1);
            assert_non_null(strstr(err.text, "spread on: it needs texture"));
            continue;
        }
        m = textured_build(&scene, &o, &report);
        assert_int_equal(sph_machine_effect(&m, SPH_EFFECT_SPREAD), 1);
        sph_machine_free(&m);
    }
    free(mip.texels);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(base),    cmocka_unit_test(images), cmocka_unit_test(refused),
        cmocka_unit_test(invalid), cmocka_unit_test(bends),
    };
    return cmocka_run_group_tests_name("build texture", tests, NULL, NULL);
}
