/* test_effects_scenes.c - effects of whole scenes: those of scenes/effects, one by one and in
 * pairs; what build leaves off changes no pixel; forcing SPDX-License-Identifier: Apache-2.0
 *
 * build/test/test_effects_scenes [seed]; run from the root of the repository: reads scenes/.
 */
#include "effects_scene.h"

#include "validate/describe.h"
#include "scene/generate.h"
#include "textured.h"
#include "scene_list.h"

static struct sph_build_report report;

enum { IMAGES = 16 };
static struct sph_mip images[IMAGES]; /* noise: what a file shows does not matter here */

static struct sph_build_options small(int width, int height) {
    struct sph_build_options o = standard;
    o.background = SPH_BG_NONE, o.width = width / (SLOW > 1 ? 2 : 1), o.height = height;
    o.texture = o.refract = o.specular = o.smooth = o.clear = o.spread = SPH_AUTO;
    o.mips = images, o.tex_filter = SPH_FILTER_BETWEEN;
    return o;
}

static int paint(void **unused) {
    struct sph_rng random = {1};
    (void)unused;
    for (int i = 0; i < IMAGES; i++)
        images[i] = textured_mip(64, 64, &random);
    return 0;
}

static int wipe(void **unused) {
    (void)unused;
    for (int i = 0; i < IMAGES; i++)
        free(images[i].texels);
    return 0;
}

static struct sph_scene scene_at(const char *path) {
    struct sph_scene scene;
    struct sph_error err = {{0}};
    struct sph_read_options how = {0};
    if (sph_scene_read(path, &how, &scene, &err)) fail_msg("%s", err.text);
    assert_true((int)scene.n_textures <= IMAGES);
    return scene;
}

/* Every profile, tree and traversal. */
static void compare_all(const struct sph_scene *scene, int width, int height, struct tally *t) {
    for (int way = 0; way < 4 * SPH_PROFILES; way++) {
        struct sph_build_options o = small(width, height);
        o.profile = way / 4, o.max_depth = 3;
        o.tree = way & 1 ? SPH_TREE_PAPER : SPH_TREE_BALANCED;
        o.traverse = way & 2 ? SPH_BUILD_FIRST : SPH_BUILD_NEAREST;
        compare(scene, o, t);
    }
}

static void test_files(void **unused) {
    struct tally t = {0};
    static const char *const patterns[] = {"scenes/*.nff", "scenes/effects/effects.nff:*"};
    struct scene_list found = list_scenes(patterns, 2);
    (void)unused;
    for (size_t i = 0; i < found.n; i++) {
        struct sph_scene scene = scene_at(found.name[i]);
        compare_all(&scene, 32, 18, &t);
        sph_scene_free(&scene);
    }
    print_tally(&t);
    assert_true(t.frames > 380);
}

static void test_generated(void **unused) {
    static const struct {
        const char *kind;
        struct sph_generate_options how;
    } kinds[] = {{"sphereflake", {.size = 2}},
                 {"sphereflake", {.size = 3}},
                 {"random", {.n = 40, .seed = 1}},
                 {"random", {.n = 40, .seed = 2}},
                 {"random", {.n = 400, .seed = 3}},
                 {"interpenetrating", {0}},
                 {"paper100", {.seed = 1}},
                 {"paper100", {.seed = 2}},
                 {"paper5", {.seed = 3}},
                 {"paper5", {.seed = 4}},
                 {"huge_tiny", {0}}};
    struct tally t = {0};
    (void)unused;
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        struct sph_scene scene;
        struct sph_error err = {{0}};
        if (sph_generate(kinds[i].kind, &kinds[i].how, &scene, &err)) fail_msg("%s", err.text);
        compare_all(&scene, 24, 14, &t);
        sph_scene_free(&scene);
    }
    print_tally(&t);
    assert_true(t.frames > 150);
}

/* Sparse scenes, most of them without spheres that are near each other. */
static void test_sparse(void **unused) {
    struct tally t = {0};
    (void)unused;
    for (int run = 0; run < 400 / SLOW; run++) {
        struct sph_scene s = cloud(1 + (uint32_t)run % 9, 0.12);
        struct sph_build_options o = small(24, 18);
        o.profile = run % SPH_PROFILES;
        o.traverse = run & 4 ? SPH_BUILD_FIRST : SPH_BUILD_NEAREST;
        s.camera.angle = 22;
        for (int l = 0; l < 2; l++) {
            s.lights[l].pos = (struct sph_vec){between(-1, 2), between(-1, 2), between(-1, 2)};
            if (run & 8 && s.n_spheres > (uint32_t)l) s.lights[l].pos = s.spheres[l].ctr;
        }
        compare(&s, o, &t);
        free(s.spheres);
    }
    print_tally(&t);
    for (int i = 0; i <= SPH_REPORT_INTERPENETRATE; i++)
        assert_true(i == SPH_REPORT_FIRST || i == SPH_REPORT_REFLECT || t.off[i] >= 2);
}

/* Does the frame of the scene with options o differ from what `with` gives? */
static int matters(const struct sph_scene *scene, struct sph_build_options o,
                   struct sph_build_options with) {
    struct sph_machine a = built(scene, o, &report), b = built(scene, with, &report);
    struct sph_frame fa = frame_of(&a), fb = frame_of(&b);
    int differ = frames_differ(&fa, &fb);
    assert_true(strlen(report.warning) > 0); /* what is called for is missing */
    sph_frame_free(&fa);
    sph_frame_free(&fb);
    sph_machine_free(&a);
    sph_machine_free(&b);
    return differ > 0;
}

/* Whether a list such as "shadow+lights2" has a word that starts so. */
static int has(const char *list, const char *word) {
    const char *at = strstr(list, word);
    return at && (at == list || at[-1] == '+' || at[-1] == '_');
}

/* The scene of a line: its name, without bih, which alone is the scene none. */
static struct sph_scene scene_of(const char *name) {
    char path[256];
    int length = (int)strlen(name);
    if (strcmp(name, "bih") == 0) return scene_at("scenes/effects/effects.nff:none");
    if (has(name, "bih")) length -= (int)strlen("_bih");
    snprintf(path, sizeof path, "scenes/effects/effects.nff:%.*s", length, name);
    return scene_at(path);
}

/* The list has what the name says, and what comes along. */
static void check_list(const char *name, const char *list, int lights) {
    int cut = has(name, "interpenetrate"), glass = has(name, "refract");
    int shiny = has(name, "specular");
    int facets = has(name, "facets") || has(name, "smooth"), clear = has(name, "clear");
    assert_int_equal(has(list, "shadow"),
                     has(name, "shadow") || clear || (lights && (glass || facets)));
    assert_int_equal(has(list, "reflect"), has(name, "reflect") || glass);
    assert_int_equal(lights > 1, has(name, "lights"));
    assert_int_equal(has(list, "inside"), has(name, "inside") || cut || glass);
    assert_int_equal(has(list, "first") && has(list, "interpenetrate"), cut);
    assert_int_equal(has(list, "facets"), facets);
    assert_int_equal(has(list, "smooth"), has(name, "smooth"));
    assert_int_equal(has(list, "clear"), clear);
    assert_int_equal(has(list, "texture"), has(name, "texture"));
    assert_int_equal(has(list, "spread"),
                     has(name, "texture") && (has(name, "reflect") || glass) && !facets);
    assert_int_equal(has(list, "refract"), glass);
    assert_int_equal(has(list, "specular"), shiny);
    assert_int_equal(has(list, "sum"), has(name, "sum") || glass || shiny);
    assert_int_equal(has(list, "bih"), has(name, "bih"));
}

/* One line of effects.txt: the machine asks for the list, the list is what the name says, and each
 * effect that can be switched off changes some pixel. */
static void check_line(const char *name, const char *options, const char *list) {
    char core[160];
    struct sph_build_options o = small(64, 36);
    struct sph_scene scene = scene_of(name);
    if (strstr(options, "--traverse=first")) o.traverse = SPH_BUILD_FIRST;
    if (strstr(options, "--tree=paper")) o.tree = SPH_TREE_PAPER;
    if (strstr(options, "--accel=bih")) o.tree = SPH_TREE_BIH;
    struct sph_machine m = built(&scene, o, &report);
    sph_machine_core(&m, core, sizeof core);
    if (strcmp(core, list) != 0) fail_msg("%s asks for %s, not %s", name, core, list);
    assert_int_equal(report.warning[0], 0);
    sph_machine_free(&m);

    check_list(name, list, scene.n_lights);
    static const struct {
        const char *word;
        int report;
    } switches[] = {
        {"shadow", SPH_REPORT_SHADOW},     {"reflect", SPH_REPORT_REFLECT},
        {"inside", SPH_REPORT_INSIDE},     {"interpenetrate", SPH_REPORT_INTERPENETRATE},
        {"texture", SPH_REPORT_TEXTURE},   {"refract", SPH_REPORT_REFRACT},
        {"specular", SPH_REPORT_SPECULAR}, {"lights", SPH_REPORT_LIGHTS},
        {"smooth", SPH_REPORT_SMOOTH},     {"clear", SPH_REPORT_CLEAR},
        {"spread", SPH_REPORT_SPREAD}};
    for (size_t i = 0; i < sizeof switches / sizeof *switches; i++) {
        int along = (has(name, "refract") || has(name, "facets") || has(name, "smooth")) &&
                    !has(name, switches[i].word); /* comes along, needed or not */
        if (along || !has(list, switches[i].word)) continue;
        struct sph_build_options off = o;
        off.asked[switches[i].report] =
            switches[i].report == SPH_REPORT_LIGHTS ? scene.n_lights - 1 : SPH_OFF;
        if (!matters(&scene, o, off)) fail_msg("%s: %s does nothing", name, switches[i].word);
    }
    sph_scene_free(&scene);
}

/* Cuts a line into n words or more, of which there have to be so many. */
static void words_of(char *line, int n, const char *words[]) {
    char *rest = line;
    for (int i = 0; i < n; i++)
        assert_non_null(words[i] = strtok_r(NULL, " \t\n", &rest));
}

static void test_table(void **unused) {
    char line[256];
    const char *words[4];
    int lines = 0;
    (void)unused;
    FILE *file = fopen("scenes/effects/effects.txt", "r");
    assert_non_null(file);
    while (fgets(line, sizeof line, file)) {
        if (line[0] == '#') continue;
        words_of(line, 4, words);
        check_line(words[0], words[2], words[3]);
        lines++;
    }
    fclose(file);
    assert_int_equal(lines, 68);
}

/* docs/results/data/asks.tsv: what every other scene asks for. */
static void test_asks(void **unused) {
    char line[256], path[128], core[160];
    const char *words[2];
    int lines = 0;
    (void)unused;
    FILE *file = fopen("docs/results/data/asks.tsv", "r");
    assert_non_null(file);
    while (fgets(line, sizeof line, file)) {
        if (line[0] == '#') continue;
        words_of(line, 2, words);
        snprintf(path, sizeof path, "scenes/%s.nff", words[0]);
        struct sph_build_options o = standard;
        o.width = 64, o.height = 36, o.background = SPH_BG_NONE;
        o.texture = o.refract = o.specular = o.smooth = o.clear = o.spread = SPH_AUTO;
        o.mips = images, o.tex_filter = SPH_FILTER_BETWEEN;
        struct sph_scene scene = scene_at(path);
        struct sph_machine m = built(&scene, o, &report);
        sph_machine_core(&m, core, sizeof core);
        if (strcmp(core, words[1]) != 0)
            fail_msg("%s asks for %s, not %s: make pages", words[0], core, words[1]);
        sph_machine_free(&m);
        sph_scene_free(&scene);
        lines++;
    }
    fclose(file);
    /* not effects/ and limits/ */
    static const char *const patterns[] = {"scenes/*.nff", "scenes/[!el]*/*.nff"};
    assert_int_equal(lines, list_scenes(patterns, 2).n);
}

/* What an option makes of a scene: number, and parts of reason and warning. */
static void force(const struct sph_scene *s, struct sph_build_options o, int effect, int on,
                  const char *why, const char *warning) {
    struct sph_machine m = built(s, o, &report);
    assert_int_equal(report.effects[effect].on, on);
    if (!strstr(report.effects[effect].why, why) || !strstr(report.warning, warning) ||
        !warning[0] != !report.warning[0])
        fail_msg("'%s', warning '%s'", report.effects[effect].why, report.warning);
    sph_machine_free(&m);
}

static void refuse(const struct sph_scene *s, struct sph_build_options o, const char *part) {
    struct sph_machine m;
    struct sph_error err = {{0}};
    assert_int_equal(sph_build(s, &o, &m, &report, &err), -1);
    if (!strstr(err.text, part)) fail_msg("'%s' lacks '%s'", err.text, part);
}

static void test_forced(void **unused) {
    struct sph_scene all = scene_at("scenes/effects/effects.nff:shadow_interpenetrate");
    struct sph_scene none = scene_at("scenes/effects/effects.nff:none");
    struct sph_build_options o = standard, p;
    (void)unused;
#define WITH(field, value) (p = o, p.field = (value), p)
    force(&all, WITH(shadow, SPH_OFF), SPH_REPORT_SHADOW, 0, "as asked; called for: the sphere ",
          "shadow off: as asked; called for: ");
    force(&all, WITH(lights, 0), SPH_REPORT_LIGHTS, 0, "left out: scenes/", "lights off: as asked");
    force(&all, WITH(inside, SPH_OFF), SPH_REPORT_INSIDE, 0, " overlap", "inside off: as asked");
    force(&none, WITH(shadow, SPH_ON), SPH_REPORT_SHADOW, 1, "as asked; not called for: no li", "");
    force(&none, WITH(reflect, SPH_ON), SPH_REPORT_REFLECT, 2, "as asked; not called", "");
    force(&none, WITH(inside, SPH_ON), SPH_REPORT_INSIDE, 1, "as asked; not called", "");
    force(&none, WITH(smooth, SPH_ON), SPH_REPORT_SMOOTH, 0,
          "though on was asked: there is no triangle", "");
    force(&none, WITH(clear, SPH_ON), SPH_REPORT_CLEAR, 0, "though on was asked: it needs shadow",
          "");
    p = WITH(spread, SPH_ON), p.texture = SPH_AUTO;
    force(&none, p, SPH_REPORT_SPREAD, 0, "though on was asked: it needs texture", "");
    o.traverse = SPH_BUILD_FIRST;
    force(&all, o, SPH_REPORT_INTERPENETRATE, 1, " overlap", "");
    force(&all, WITH(interpenetrate, SPH_OFF), SPH_REPORT_INTERPENETRATE, 0, "as asked; called",
          "interpenetrate off: as asked");
    force(&all, WITH(inside, SPH_OFF), SPH_REPORT_INTERPENETRATE, 0, "needs inside",
          "interpenetrate off: ");
    force(&none, WITH(interpenetrate, SPH_ON), SPH_REPORT_INSIDE, 1, "interpenetrate needs it", "");
    refuse(&all, WITH(lights, 2), "2 lights are asked for, the scene has 1");
    refuse(&all, WITH(shadow, 2), "neither auto, off nor on");
    p = WITH(clear, SPH_ON), p.shadow = SPH_OFF;
    refuse(&none, p, "clear on: it needs shadow");
    p = WITH(spread, SPH_ON), p.texture = SPH_OFF;
    refuse(&none, p, "spread on: it needs texture");
    p = WITH(interpenetrate, SPH_ON), p.inside = SPH_OFF;
    refuse(&all, p, "it needs inside");
    p = WITH(interpenetrate, SPH_ON), p.traverse = SPH_BUILD_NEAREST;
    refuse(&all, p, "traverse is nearest");
    p = WITH(reflect, SPH_ON), p.max_depth = 0;
    refuse(&all, p, "depth is 0");
    sph_scene_free(&all);
    sph_scene_free(&none);
}

/* Which lights are left out. */
static void test_lights(void **unused) {
    struct sph_scene s = cloud(2, 0.1);
    struct sph_build_options o = standard, p;
    (void)unused;
    s.spheres[0].ctr = (struct sph_vec){0.5, 0.5, 0.5};
    s.spheres[1].ctr = (struct sph_vec){0.1, 0.9, 0.1};
    s.lights[0].pos = s.spheres[0].ctr;
    force(&s, o, SPH_REPORT_LIGHTS, 1, "cloud.nff:3 is shut in by the sphere cloud.nff:10", "");
    force(&s, WITH(shadow, SPH_OFF), SPH_REPORT_LIGHTS, 2, "2 of the scene's 2", "shadow off");
    force(&s, WITH(lights, 1), SPH_REPORT_LIGHTS, 1, "left out: cloud.nff:4", "lights fewer");
    for (int i = 0; i < 3; i++) { /* one colour is enough */
        for (int k = 0; k < 3; k++)
            s.lights[1].rgb[k] = i == k ? 0x1p-15 : 0;
        force(&s, o, SPH_REPORT_LIGHTS, 1, "1 of the scene's 2", "");
    }
    s.lights[1].rgb[2] = 0x1p-17;
    force(&s, o, SPH_REPORT_LIGHTS, 0, "cloud.nff:4 is black", "");
    force(&s, o, SPH_REPORT_SHADOW, 0, "no light shines", "");
    free(s.spheres);
}

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_files),  cmocka_unit_test(test_generated),
        cmocka_unit_test(test_sparse), cmocka_unit_test(test_table),
        cmocka_unit_test(test_asks),   cmocka_unit_test(test_forced),
        cmocka_unit_test(test_lights),
    };
    seed(argc, argv);
    return cmocka_run_group_tests_name("effects of scenes", tests, paint, wipe);
}
