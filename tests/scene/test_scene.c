/* test_scene.c - scene files: reading, leaving primitives out, writing
 * SPDX-License-Identifier: Apache-2.0
 */
#include "scene_files.h"

#include <locale.h>

#include "scene/generate.h"
#include "scene/nff_lex.h"

static void read_text(const char *text, int skip, struct sph_scene *scene) {
    struct sph_error err = {""};
    struct sph_read_options options = {.skip_unsupported = skip};
    put_file(text, strlen(text));
    if (sph_scene_read(file_name, &options, scene, &err)) fail_msg("%s", err.text);
}

static void test_good(void **state) {
    (void)state;
    struct sph_scene s;
    read_text("\xef\xbb\xbf# UTF-8 mark\r\nv from\r\n 1\n2 3e0 at 0 0 0 up 0 1 0\nresolution "
              "64\n32 angle 45\n"
              "l 1 2 3\nl 4 5 6 .1 2 0\nl 7 8 9\nl 1 1 1#comment\nb 0.25 .5 1.\nambient 0 0 1\n"
              "f 1 1 1 1 0 0 0 0\nf .1 .2 .3 .4 .5 6 .7 3\ns +1 -2.5e1 3E-2 4 s 5 6 7 8\n"
              "f 1 0 0 0 0 0 0 1\n",
              0, &s);
    assert_true(s.camera.from.x == 1 && s.camera.from.z == 3 && s.camera.angle == 45);
    assert_true(s.camera.width == 64 && s.camera.height == 32 && s.camera.hither == 0);
    assert_true(s.background[0] == 0.25 && s.background[2] == 1 && s.ambient[2] == 1);
    assert_int_equal(s.n_lights, 4);
    assert_true(s.lights[0].rgb[1] == 0.5 && s.lights[3].rgb[2] == 0.5); /* 1/sqrt(4) */
    assert_true(s.lights[1].rgb[0] == 0.1 && s.lights[1].rgb[1] == 2 && s.lights[2].pos.z == 9);
    assert_int_equal(s.n_spheres, 2);
    assert_true(s.spheres[0].ctr.y == -25 && s.spheres[0].ctr.z == 0.03 && s.spheres[1].rad == 8);
    assert_int_equal(s.spheres[1].line, 15);
    const struct sph_material *m = &s.materials[s.spheres[0].material];
    assert_true(m->rgb[2] == 0.3 && m->kd == 0.4 && m->ks == 0.5 && m->shine == 6);
    assert_true(m->trans == 0.7 && m->ior == 3 && m->line == 14);
    assert_string_equal(s.name, "scene");
    sph_scene_free(&s);
}

static void test_skip(void **state) {
    (void)state;
    struct sph_scene s;
    read_text(CAM MAT "t 1 2 3\n4 5 6\ns 0 0 0 1\nt\n0 0 0 1\n0 0 1 0\n"
                      "tpp s.png\n0 0 0 0 0 0\n1 1 1 0 0 0\ns 1 1 1 1\npb 1 1 1\n",
              1, &s);
    assert_int_equal(s.ledger.row[SPH_READ_UNSUPPORTED].n, 4);
    assert_int_equal(s.n_spheres, 2);
    assert_int_equal(s.spheres[1].line, 18);
    sph_scene_free(&s);
}

/* Several scenes of one file: which is read, and what is wrong with others. */
static void test_sections(void **state) {
    static const char shared[] = "b 1 0 0\nf 1 1 1 1 0 0 0 1\n# scene no\n", rest[] = CAM;
    static const struct {
        const char *text, *section; /* section NULL: the file alone */
        unsigned spheres;
        const char *message; /* NULL: it is read */
    } cases[] = {
        /* the common part and its own */
        {"scene a\ns 0 0 0 5\nscene b\ns 0 0 0 7\ns 0 0 2 1\n", "a", 1, NULL},
        {"scene a\ns 0 0 0 5\nscene b\ns 0 0 0 7\ns 0 0 2 1\n", "b", 2, NULL},
        /* another may have what is no NFF, and the word within a line */
        {"scene a\ns 0 0 0 5\nscene b\ns scene b\ntexture \"of scene b\" 1\n", "a", 1, NULL},
        {"s 0 0 0 4\n", "a", 0, "scene.nff: has no scene `a`"},
        {"scene a\ns 0 0 0 5\n", "", 0, "scene.nff: has no scene ``"},
        {"scene a\ns 0 0 0 5\nscene a\n", "a", 0, "scene.nff:13: second scene `a`"},
        {"scene a\ns 0 0 0 5\n", NULL, 0, "there are several scenes: say "},
        {"scene a\ns 0 0\nscene b\n", "a", 0, "scene.nff:13: `s`: z: `scene`"},
        {"scene", "a", 0, "the file ends within `scene`, before name"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[512], path[sizeof file_name + 16];
        struct sph_scene s;
        struct sph_error err = {""};
        const char *section = cases[i].section;
        snprintf(text, sizeof text, "%s%s%s", shared, rest, cases[i].text);
        put_file(text, strlen(text));
        snprintf(path, sizeof path, "%s%s%s", file_name, section ? ":" : "",
                 section ? section : "");
        int bad = sph_scene_read(path, NULL, &s, &err);
        if (!bad != !cases[i].message) fail_msg("case %zu: %s", i, err.text);
        if (bad && !strstr(err.text, cases[i].message)) fail_msg("case %zu: %s", i, err.text);
        if (bad) continue;
        assert_int_equal(s.n_spheres, cases[i].spheres);
        assert_true(s.background[0] == 1 && s.spheres[0].rad == 5 + 2 * (*section == 'b'));
        assert_int_equal(s.spheres[0].line, 12 + 2 * (*section == 'b'));
        assert_string_equal(s.name, section);
        sph_scene_free(&s);
    }
}

/* A scene of n spheres whose numbers have all bits random. */
static void test_round_trip(void **state) {
    (void)state;
    struct sph_error err = {""};
    struct sph_generate_options o = {.n = 20000, .seed = 5};
    struct sph_scene s;
    assert_int_equal(sph_generate("random", &o, &s, &err), 0);
    s.spheres[7].ctr.x = 1.0000000000000002e-300;
    s.spheres[8].ctr.y = -9.8765432109876543e29;
    s.camera.hither = 1.0 / 3;
    round_trip(&s);
    sph_scene_free(&s);
}

static void test_write_error(void **state) {
    (void)state;
    struct sph_error err = {""};
    struct sph_scene s;
    FILE *file = fopen("/dev/full", "w");
    assert_int_equal(sph_generate("paper5", NULL, &s, &err), 0);
    assert_int_equal(sph_scene_write(&s, file, &err), -1);
    assert_non_null(strstr(err.text, "cannot write"));
    fclose(file);
    sph_scene_free(&s);
}

/* Numbers of more digits than a double are those of strtod. */
static void test_digits(void **state) {
    uint64_t random = 1;
    (void)state;
    for (int i = 0; i < 20000; i++) {
        char text[64];
        double value, wanted;
        uint64_t bits, good;
        random = random * 6364136223846793005u + 1442695040888963407u;
        int digits = 14 + (int)(random >> 40) % 8, power = (int)(random >> 50) % 60 - 30;
        unsigned long long more = random ^ random >> 29, ends = i % 4 ? 0 : random >> 60;
        /* in the middle of two doubles, or by a last digit beside it */
        double whole = (double)(1ull << 53) + (double)(more >> 12);
        if (i % 4)
            snprintf(text, sizeof text, "-%.*s.%sE%d", digits, "1234567890123456789012", "5",
                     power);
        else
            snprintf(text, sizeof text, "%.0f.%llu", whole, ends);
        for (char *c = text; *c && i % 4 && *c != 'E'; c++)
            if (*c >= '0' && *c <= '9') *c = (char)('0' + (more = more * 13 + 7, more >> 7) % 10);
        assert_int_not_equal(sph_parse_number(text, &value), -1);
        wanted = strtod(text, NULL);
        memcpy(&bits, &value, sizeof bits);
        memcpy(&good, &wanted, sizeof good);
        if (bits != good) fail_msg("%s is %a, not %a", text, value, wanted);
    }
}

/* A locale with a decimal comma changes nothing. It is made here; skipped without the Debian
 * package locales. */
static void test_locale(void **state) {
    (void)state;
    struct sph_error err = {""};
    struct sph_scene s;
    char command[256], clean[256], text[8];
    snprintf(clean, sizeof clean, "rm -rf %s/de_DE.UTF-8", folder);
    snprintf(command, sizeof command, "localedef -i de_DE -f UTF-8 %s/de_DE.UTF-8 >%s 2>&1", folder,
             file_name);
    if (system(command)) {
        assert_int_equal(system(clean), 0); /* it may have begun */
        skip();
    }
    assert_int_equal(setenv("LOCPATH", folder, 1), 0);
    assert_non_null(setlocale(LC_ALL, "de_DE.UTF-8"));
    snprintf(text, sizeof text, "%.1f", 0.5);
    assert_string_equal(text, "0,5");
    assert_int_equal(sph_generate("random", NULL, &s, &err), 0);
    round_trip(&s);
    sph_scene_free(&s);
    setlocale(LC_ALL, "C");
    assert_int_equal(system(clean), 0);
}

int main(void) {
    const struct CMUnitTest others[] = {
        cmocka_unit_test(test_good),       cmocka_unit_test(test_skip),
        cmocka_unit_test(test_round_trip), cmocka_unit_test(test_write_error),
        cmocka_unit_test(test_locale),     cmocka_unit_test(test_digits),
        cmocka_unit_test(test_sections)};
    return run_cases("scene", NULL, NULL, 0, others, sizeof others / sizeof others[0]);
}
