/* test_scene_optics.c - words of refraction and Whitted's sum: read, written, refused, built
 * SPDX-License-Identifier: Apache-2.0
 */
#include "scene_files.h"

#include <math.h>

#include "builder/build.h"
#include "validate/describe.h"
#include "scene/nesting.h"
#include "validate/validate.h"

#define SUM "shading sum\n"
static const struct bad bads[] = {
    {"index_0", CAM SUM "f 1 1 1 .1 .1 50 .7 0\n", 9, "used otherwise: index of refraction limited",
     STRICT, 0},
    {"index_small", CAM SUM "f 1 1 1 .1 .1 50 .7 0.249\n", 9, "index of refraction limited to",
     STRICT, 0},
    {"index_large", CAM SUM "f 1 1 1 .1 .1 50 .7 4.001\n", 9, "index of refraction limited to",
     STRICT, 0},
    {"index_negative", CAM SUM "f 1 1 1 .1 .1 50 .7 -1.5\n", 9, "index of refraction is negative",
     0, 0},
    {"index_negative_opaque", CAM SUM "f 1 1 1 .1 .1 50 0 -1.5\n", 9,
     "index of refraction is negative", 0, 0},
    {"t_above_1", CAM SUM "f 1 1 1 .1 .1 50 1.1 1.5\n", 9, "T 1.1 is not within 0 to 1", 0, 0},
    {"t_below_0", CAM SUM "f 1 1 1 .1 .1 50 -.7 1.5\n", 9, "T -0.7 is not within 0 to 1", 0, 0},
    {"shine_0", CAM SUM "f 1 1 1 .1 .1 0 .7 1.5\n", 9,
     "used otherwise: material with Ks but Shine 0", STRICT, 0},
    {"shine_large", CAM SUM "f 1 1 1 .1 .1 256 .7 1.5\n", 9, "Shine limited to 1..255", STRICT, 0},
    {"ka_above_1", CAM SUM "f 1 1 1 .1 .1 50 .7 1.5 2 0\n", 9, "Ka 2 is not within 0 to 1", 0, 0},
    {"kr_below_0", CAM SUM "f 1 1 1 .1 .1 50 .7 1.5 0 -1\n", 9, "Kr -1 is not within 0 to 1", 0, 0},
    {"kr_missing", CAM SUM "f 1 1 1 .1 .1 50 .7 1.5 0\ns 0 0 0 1\n", 10, "`f`: Kr", 0, 0},
    {"ka_without_sum", CAM "f 1 1 1 .1 .1 50 .7 1.5 .1 0\n", 8, "Ka and Kr need `shading sum`", 0,
     0},
    {"ka_after_blend", CAM SUM "shading blend\nf 1 1 1 .1 .1 50 .7 1.5 .1 0\n", 10,
     "Ka and Kr need `shading sum`", 0, 0},
    {"fm_index", CAM SUM "fm 1 1 1 1 1 1 0 0 0 50 .7 5\n", 9, "index of refraction limited", STRICT,
     0},
    {"nested_ratio",
     CAM SUM "f 1 1 1 .1 .1 50 .7 .25\ns 0 0 0 3\nf 1 1 1 .1 .1 50 .7 1.5\ns 0 0 0 1\n", 12,
     "`s`: index of refraction 1.5 in 0.25: the ratio is not within 0.25 to 4", 0, 0},
    {"shading_other", CAM "shading phong\n", 8, "`phong` is neither blend nor sum", 0, 0},
    {"shadows_other", CAM "shadows half\n", 8, "`shadows`: `half` is neither full nor clear", 0, 0},
    {"shadows_nothing", CAM "shadows", 8, "`shadows`: the file ends before full or clear", 0, 0},
    {"shading_number", CAM "shading 1\n", 8, "`1` is neither blend nor sum", 0, 0},
    {"shading_nothing", CAM "shading", 8, "the file ends before blend or sum", 0, 0},
};

static void test_bad(void **state) {
    const struct bad *bad = *state;
    struct sph_error err = {""};
    struct sph_scene scene;
    put_bad(bad);
    const struct sph_read_options how = bad_options(bad);
    assert_int_equal(sph_scene_read(file_name, &how, &scene, &err), -1);
    assert_message(bad, &err);
}

static struct sph_scene read_text(const char *text) {
    struct sph_error err = {""};
    struct sph_scene scene;
    put_file(text, strlen(text));
    if (sph_scene_read(file_name, NULL, &scene, &err)) fail_msg("%s", err.text);
    return scene;
}

static double ratio(const struct sph_scene *s, uint32_t sphere) {
    return sph_index_ratio(&s->materials[s->spheres[sphere].material]);
}

/* What is around glass: the smallest transparent sphere that holds it, else the nearest plane that
 * it is wholly behind, else nothing. */
#define CLEAR(index) "f 1 1 1 .1 .1 50 .7 " index "\n"
static void test_nesting(void **state) {
    (void)state;
    struct sph_scene s = read_text(
        CAM SUM CLEAR("1.5") "s 0 0 0 4\ns 0 0 0 -3\n"          /* hollow */
        CLEAR("1.2") "s 0 0 0 2\ns 0 0 1 1\ns 0 0 -1 .5\n"      /* in its air; 3: in 2, touching */
                     "s 3.6 0 0 .3\n"                           /* within the wall */
        CLEAR("1.6") "s 4 0 0 .5\ns 9 0 0 1\n"                  /* cuts the outside; alone */
        CLEAR("2") "plane 0 -9 0 0 2 0\nplane 0 -20 0 0 1 0\n"  /* water, and deeper */
        CLEAR("3") "s 0 -12 0 1\ns 0 -30 0 9.9\ns 0 -9.5 0 1\n" /* in it; deeper; half in it */
                   "f 1 1 1 .1 .1 50 0 1.5\ns 20 0 0 4\n" CLEAR(
                       "1.3") "s 20 0 0 1\n"                          /* in what is opaque */
                              "f 1 1 1 .5 .5 50 0 1\ns 30 0 0 -1\n"); /* opaque: the sign says
                                                                         nothing */
    const double want[] = {1.5, 1 / 1.5, 1.2,     1.2 / 1.2, 1.2 / 1.2, 1.2 / 1.5, 1.6,
                           1.6, 3 / 2.0, 3 / 2.0, 3,         1.5,       1.3,       1};
    assert_int_equal(s.n_spheres, sizeof want / sizeof *want);
    for (uint32_t i = 0; i < s.n_spheres; i++) {
        if (fabs(ratio(&s, i) - want[i]) > 1e-15) print_message("sphere %u\n", i);
        assert_true(fabs(ratio(&s, i) - want[i]) <= 1e-15);
        assert_true(s.spheres[i].rad > 0);
    }
    round_trip(&s);
    sph_scene_free(&s);
}

static void test_read(void **state) {
    (void)state;
    struct sph_scene s = read_text(CAM "shading blend\nf 1 1 1 .1 .2 0 .7 0\ns 0 0 0 1\n" SUM
                                       "f 1 1 1 .1 .2 50 .7 .95\n"
                                       "s 2 0 0 1\nf 1 1 1 .1 .2 50 .7 .95 .3 .4\ns 4 0 0 1\n"
                                       "fm 0 0 0 .5 1 0 .3 .3 .3 20 0 0 .6 0\ns 6 0 0 1\n"
                                       "shading blend\nf 1 1 1 .1 .2 300 .7 9\ns 8 0 0 1\n");
    const struct sph_material *m = s.materials;
    assert_int_equal(s.n_materials, 5);
    assert_false(m[0].sum.on || m[4].sum.on);
    assert_true(m[1].sum.on && m[1].sum.ka == 0.1 && m[1].sum.kr == 0.2);
    assert_true(m[2].sum.on && m[2].sum.ka == 0.3 && m[2].sum.kr == 0.4 && m[2].ks == 0.2);
    assert_true(m[3].sum.on && m[3].sum.ka == 0.6 && m[3].sum.kr == 0 && m[3].kd == 1);
    round_trip(&s);
    struct sph_error err = {""};
    struct sph_scene again;
    if (sph_scene_read(file_name, NULL, &again, &err)) fail_msg("%s", err.text);
    assert_int_equal(again.n_materials, 5);
    for (int i = 0; i < 5; i++) {
        const struct sph_sum *sum = &again.materials[i].sum;
        assert_true(sum->on == m[i].sum.on && sum->ka == m[i].sum.ka && sum->kr == m[i].sum.kr);
    }
    sph_scene_free(&again);
    sph_scene_free(&s);
}

/* Shadow rays pass materials that transmit, from `shadows clear` to `shadows full`. */
static void test_shadows(void **state) {
    (void)state;
    struct sph_scene s =
        read_text(CAM "f 1 1 1 1 0 0 .5 1\ns 0 0 0 1\nshadows clear\ns 1 0 0 1\n"
                      "f 1 1 1 1 0 0 0 1\ns 2 0 0 1\nf 1 1 1 1 0 0 .01 1\ns 3 0 0 1\n" SUM
                      "fm 0 0 0 1 1 1 0 0 0 1 .5 1.5\ns 4 0 0 1\ns 5 0 0 -.5\n"
                      "shadows full\nf 1 1 1 1 0 0 .5 1.5\ns 6 0 0 1\n");
    static const int want[] = {0, 0, 0, 1, 1, 1, 0};
    for (uint32_t i = 0; i < 7; i++)
        assert_int_equal(s.materials[s.spheres[i].material].passes, want[i]);
    round_trip(&s);
    sph_scene_free(&s);
}

static const struct sph_build_options options = {.profile = SPH_STANDARD,
                                                 .tree = SPH_TREE_BALANCED,
                                                 .max_depth = 2,
                                                 .shadow = SPH_AUTO,
                                                 .reflect = SPH_AUTO,
                                                 .refract = SPH_AUTO,
                                                 .specular = SPH_AUTO,
                                                 .lights = SPH_AUTO,
                                                 .inside = SPH_AUTO,
                                                 .interpenetrate = SPH_AUTO};

static struct sph_machine build(const char *text, struct sph_build_options o) {
    struct sph_scene s = read_text(text);
    struct sph_build_report report;
    struct sph_machine m;
    struct sph_error err = {""};
    if (sph_build(&s, &o, &m, &report, &err)) fail_msg("%s", err.text);
    if (sph_machine_validate(&m, &err)) fail_msg("%s", err.text);
    sph_scene_free(&s);
    return m;
}

#define FIELD(prim, name) sph_field(prim, SPH_PRIM_##name##_LSB, SPH_PRIM_##name##_BITS)

static uint32_t *prim_of(const struct sph_machine *m, int id) {
    return m->mem + (size_t)(m->regs[SPH_REG_PRIM_BASE] + id) * SPH_LINE_WORDS;
}

#define RED "f .9 .3 .3 .3 .1 40 0 0 .3 .3\n"
#define GLASS "f 1 1 1 .1 .1 50 .7 .95 .1 0\n"

/* The two materials of the thesis, word by word. */
static void test_words(void **state) {
    (void)state;
    struct sph_machine m = build(CAM LIGHT SUM RED "s -2 0 0 1\n" GLASS "s 2 0 0 1\n", options);
    const uint32_t *red = prim_of(&m, 0), *glass = prim_of(&m, 1);
    assert_int_equal(FIELD(red, SUM), 1);
    assert_int_equal(FIELD(red, RED), 230); /* 255 * 0.9 */
    assert_int_equal(FIELD(red, GREEN), 77);
    assert_int_equal(FIELD(red, KA), 77);
    assert_int_equal(FIELD(red, KD), 77);
    assert_int_equal(FIELD(red, KR), 77);
    assert_int_equal(FIELD(red, KT), 0);
    assert_int_equal(FIELD(red, KS), 26);
    assert_int_equal(FIELD(red, POWER), 640);
    assert_int_equal(FIELD(red, INDEX), 0);
    assert_int_equal(FIELD(glass, BLUE), 255);
    assert_int_equal(FIELD(glass, KA), 26);
    assert_int_equal(FIELD(glass, KR), 0);
    assert_int_equal(FIELD(glass, KT), 179);
    assert_int_equal(FIELD(glass, POWER), 800);
    assert_int_equal(FIELD(glass, INDEX), 950);
    char core[256];
    sph_machine_core(&m, core, sizeof core);
    assert_string_equal(core, "shadow+reflect2+lights1+inside+refract+specular+sum");
    sph_machine_free(&m);
}

static int effects(const char *text, struct sph_build_options o) {
    struct sph_machine m = build(text, o);
    int bits = m.regs[SPH_REG_EFFECTS] >> SPH_EFFECT_REFRACT;
    for (int id = 0; id < m.regs[SPH_REG_N_PRIMS] && !(bits >> 2); id++) {
        assert_int_equal(FIELD(prim_of(&m, id), SUM), 0);
        assert_int_equal(prim_of(&m, id)[5] >> 1, 0); /* bits 161 to 191 */
    }
    sph_machine_free(&m);
    return bits;
}

/* REFRACT 1, SPECULAR 2, SUM 4: only where they are called for. */
static void test_effects(void **state) {
    (void)state;
    struct sph_build_options o = options;
    static const struct {
        const char *f; /* as NFF says, without `shading` */
        int effects;
    } nff[] = {
        {"f 1 1 1 .5 .5 50 .7 .95\n", 7},                /* glass */
        {"shading blend\nf 1 1 1 .5 .5 50 .7 .95\n", 0}, /* as the file asks */
        {"f 1 1 1 .5 .5 50 0 1\n", 6},                   /* a highlight */
        {"f 1 1 1 .5 .5 0 0 1\n", 0},                    /* none, and a mirror: blends */
        {"f 1 1 1 1 0 50 0 1\n", 0},                     /* matt */
        {"f 1 1 1 .8 .5 0 0 1\n", 4},                    /* more than 1 in all: a sum */
        {"f 1 1 1 1 0 0 .5 1.5\n", 5},                   /* clear without highlight */
    };
    for (size_t i = 0; i < sizeof nff / sizeof *nff; i++) {
        char text[400];
        snprintf(text, sizeof text, CAM LIGHT "%ss 0 0 0 1\n", nff[i].f);
        assert_int_equal(effects(text, o), nff[i].effects);
    }
    assert_int_equal(effects(CAM LIGHT SUM GLASS "s 0 0 0 1\n", o), 7);
    assert_int_equal(effects(CAM SUM GLASS "s 0 0 0 1\n", o), 5); /* no light */
    assert_int_equal(effects(CAM LIGHT SUM RED "s 0 0 0 1\n", o), 6);
    assert_int_equal(effects(CAM LIGHT SUM "f 1 1 1 .5 0 0 0 0\ns 0 0 0 1\n", o), 4);
    assert_int_equal(effects(CAM LIGHT "f 1 0 0 1 0 0 0 1\ns 0 0 0 1\n" SUM GLASS, o),
                     0); /* not used */
    o.max_depth = 0;
    assert_int_equal(effects(CAM LIGHT SUM GLASS "s 0 0 0 1\n", o), 6);
    o.max_depth = 2;
    o.refract = SPH_OFF;
    assert_int_equal(effects(CAM LIGHT SUM GLASS "s 0 0 0 1\n", o), 6);
    o.specular = SPH_OFF;
    assert_int_equal(effects(CAM LIGHT SUM GLASS "s 0 0 0 1\n", o), 4);
    o.specular = SPH_ON;
    assert_int_equal(effects(CAM LIGHT MAT "s 0 0 0 1\n", o), 6);
}

static void fails(const char *text, struct sph_build_options o, const char *says) {
    struct sph_scene s = read_text(text);
    struct sph_build_report report;
    struct sph_machine m;
    struct sph_error err = {""};
    assert_int_equal(sph_build(&s, &o, &m, &report, &err), -1);
    if (!strstr(err.text, says)) fail_msg("expected %s, got %s", says, err.text);
    sph_scene_free(&s);
}

static void test_build_refuses(void **state) {
    (void)state;
    struct sph_build_options o = options;
    struct sph_profile wide;
    struct sph_error err = {""};
    assert_int_equal(sph_profile_parse("standard:wd=26", &wide, &err), 0);
    o.widths = &wide;
    fails(CAM SUM GLASS "s 0 0 0 1\n", o, "scene.nff:9: refract: wd is 26, at most 25");
    o = options;
    o.traverse = SPH_BUILD_FIRST;
    fails(CAM SUM GLASS "s 0 0 0 1\n", o, "scene.nff:9: traverse first is for scenes without");
    o = options;
    o.inside = SPH_OFF;
    fails(CAM SUM GLASS "s 0 0 0 1\n", o, "scene.nff:9: refract: it needs inside");
    o = options;
    o.refract = SPH_ON, o.max_depth = 0;
    fails(CAM SUM GLASS "s 0 0 0 1\n", o, "refract on: there must be a ray");
    o = options;
    o.refract = 7;
    fails(CAM SUM GLASS "s 0 0 0 1\n", o, "neither auto, off nor on: 7");
}

/* A machine with one word wrong. */
static void test_machine_refused(void **state) {
    (void)state;
    static const struct {
        int lsb, bits;
        uint32_t value;
        const char *says;
    } words[] = {
        {SPH_PRIM_KT_LSB, SPH_PRIM_KT_BITS, 257, "primitive 1: kt is 257, not in 0..256"},
        {SPH_PRIM_KR_LSB, SPH_PRIM_KR_BITS, 300, "primitive 1: kr is 300"},
        {SPH_PRIM_KA_LSB, SPH_PRIM_KA_BITS, 257, "primitive 1: ka is 257"},
        {SPH_PRIM_KD_LSB, SPH_PRIM_KD_BITS, 511, "primitive 1: kd is 511"},
        {SPH_PRIM_POWER_LSB, SPH_PRIM_POWER_BITS, 15, "primitive 1: power is 15, not in 16..4080"},
        {SPH_PRIM_POWER_LSB, SPH_PRIM_POWER_BITS, 4081, "primitive 1: power is 4081"},
        {SPH_PRIM_INDEX_LSB, SPH_PRIM_INDEX_BITS, 249,
         "primitive 1: index is 249, not in 250..400"},
        {SPH_PRIM_INDEX_LSB, SPH_PRIM_INDEX_BITS, 4001, "primitive 1: index is 4001"},
    };
    static const struct {
        int off, on;
        const char *says;
    } bits[] = {{1 << SPH_EFFECT_SUM, 0, "SPECULAR needs SUM"},
                {1 << SPH_EFFECT_INSIDE, 0, "REFRACT needs INSIDE"},
                {0, 1 << SPH_EFFECT_FIRST, "REFRACT excludes FIRST"},
                {0, 2 << SPH_EFFECT_SUM, "register EFFECTS is"}};
    struct sph_machine m = build(CAM LIGHT SUM RED "s -2 0 0 1\n" GLASS "s 2 0 0 1\n", options);
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        struct sph_error err = {""};
        uint32_t *prim = prim_of(&m, 1), keep = sph_field(prim, words[i].lsb, words[i].bits);
        sph_field_set(prim, words[i].lsb, words[i].bits, words[i].value);
        assert_int_equal(sph_machine_validate(&m, &err), -1);
        if (!strstr(err.text, words[i].says))
            fail_msg("expected %s, got %s", words[i].says, err.text);
        sph_field_set(prim, words[i].lsb, words[i].bits, keep);
    }
    for (size_t i = 0; i < sizeof bits / sizeof *bits; i++) {
        struct sph_error err = {""};
        int32_t keep = m.regs[SPH_REG_EFFECTS];
        m.regs[SPH_REG_EFFECTS] = (keep & ~bits[i].off) | bits[i].on;
        assert_int_equal(sph_machine_validate(&m, &err), -1);
        if (!strstr(err.text, bits[i].says))
            fail_msg("expected %s, got %s", bits[i].says, err.text);
        m.regs[SPH_REG_EFFECTS] = keep;
    }
    struct sph_error err = {""};
    sph_field_set(prim_of(&m, 1), SPH_PRIM_SUM_LSB, 1, 0); /* 179 + 78 with the blend */
    sph_field_set(prim_of(&m, 1), SPH_PRIM_KR_LSB, SPH_PRIM_KR_BITS, 78);
    assert_int_equal(sph_machine_validate(&m, &err), -1);
    assert_non_null(strstr(err.text, "kr + kt is 257"));
    sph_machine_free(&m);
}

/* The machine has the ratio in thousandths. */
static void test_nested_machine(void **state) {
    (void)state;
    struct sph_scene s = read_text(CAM SUM CLEAR("1.5") "s 0 0 0 1\ns 0 0 0 -.8\n" CLEAR(
        "1.33") "s 5 0 0 1\n" CLEAR("1.7") "s 5 0 0 .5\n");
    struct sph_build_options o = {.profile = SPH_STANDARD,
                                  .max_depth = 2,
                                  .shadow = SPH_AUTO,
                                  .reflect = SPH_AUTO,
                                  .refract = SPH_AUTO,
                                  .specular = SPH_AUTO,
                                  .lights = SPH_AUTO,
                                  .inside = SPH_AUTO,
                                  .tree = SPH_TREE_BALANCED};
    struct sph_build_report report;
    struct sph_error err = {""};
    struct sph_machine m;
    static const uint32_t index[] = {1500, 667, 1330, 1278};
    if (sph_build(&s, &o, &m, &report, &err)) fail_msg("%s", err.text);
    for (uint32_t i = 0; i < 4; i++)
        assert_int_equal(sph_field(prim_of(&m, (int)i), SPH_PRIM_INDEX_LSB, SPH_PRIM_INDEX_BITS),
                         index[i]);
    sph_machine_free(&m);
    sph_scene_free(&s);
}

int main(void) {
    const struct CMUnitTest others[] = {
        cmocka_unit_test(test_read),          cmocka_unit_test(test_shadows),
        cmocka_unit_test(test_nesting),       cmocka_unit_test(test_nested_machine),
        cmocka_unit_test(test_words),         cmocka_unit_test(test_effects),
        cmocka_unit_test(test_build_refuses), cmocka_unit_test(test_machine_refused)};
    return run_cases("scene_optics", test_bad, bads, sizeof bads / sizeof bads[0], others,
                     sizeof others / sizeof others[0]);
}
