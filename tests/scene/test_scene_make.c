/* test_scene_make.c - generated scenes and the files in scenes/
 * SPDX-License-Identifier: Apache-2.0
 *
 * Run from the top folder of the repository. Sphere lists of the SPD scene `balls` come from the
 * Debian package tachyon-doc.
 */
#include "scene_files.h"

#include <math.h>

#include "common/number.h"
#include "scene/generate.h"

#define TACHYON "/usr/share/doc/tachyon/examples/scenes/"

/* Reads the `SPHERE CENTER x y z RAD r` lines of a Tachyon scene. */
static struct sph_sphere *read_tachyon(const char *path, uint32_t *n) {
    struct sph_sphere *list = malloc(100000 * sizeof *list);
    char line[256];
    FILE *file = fopen(path, "r");
    if (!file) fail_msg("%s is missing: install the Debian package tachyon-doc", path);
    for (*n = 0; fgets(line, sizeof line, file);) {
        static const char *const words[] = {"SPHERE", "CENTER", NULL, NULL, NULL, "RAD", NULL};
        enum { WORDS = sizeof words / sizeof *words };
        struct sph_sphere s = {0};
        double *numbers[] = {&s.ctr.x, &s.ctr.y, &s.ctr.z, &s.rad}, **number = numbers;
        char *rest = line;
        int i = 0;
        for (const char *word; i < WORDS && (word = strtok_r(NULL, " \t\r\n", &rest)); i++)
            if (words[i] ? strcmp(word, words[i]) != 0 : sph_parse_number(word, *number++)) break;
        if (i == WORDS) list[(*n)++] = s;
    }
    fclose(file);
    return list;
}

/* The two lists are the same set within 0.001 in every number. */
static void assert_same_set(const struct sph_sphere *p, const struct sph_sphere *q, uint32_t n) {
    char *used = calloc(n + 1, 1);
    for (uint32_t i = 0; i < n; i++) {
        uint32_t found = n;
        for (uint32_t k = 0; k < n && found == n; k++) {
            uint32_t j = (i + k) % n;
            if (!used[j] && fabs(p[i].ctr.x - q[j].ctr.x) < 1e-3 &&
                fabs(p[i].ctr.y - q[j].ctr.y) < 1e-3 && fabs(p[i].ctr.z - q[j].ctr.z) < 1e-3 &&
                fabs(p[i].rad - q[j].rad) < 1e-3)
                found = j;
        }
        if (found == n) fail_msg("sphere %u has no partner", i);
        used[found] = 1;
    }
    free(used);
}

static void test_sphereflake(void **state) {
    (void)state;
    static const uint32_t counts[] = {10, 91, 820, 7381, 66430};
    static const char *const lists[] = {NULL, "smallballs.dat", "820spheres.dat", "balls.dat",
                                        NULL};
    for (int size = 1; size <= 5; size++) {
        struct sph_error err = {""};
        struct sph_generate_options o = {.size = size};
        struct sph_scene s;
        if (sph_generate("sphereflake", &o, &s, &err)) fail_msg("%s", err.text);
        assert_int_equal(s.n_spheres, counts[size - 1]);
        if (lists[size - 1]) {
            char path[128];
            uint32_t n;
            snprintf(path, sizeof path, TACHYON "%s", lists[size - 1]);
            struct sph_sphere *list = read_tachyon(path, &n);
            assert_int_equal(n, s.n_spheres);
            assert_same_set(s.spheres, list, n);
            free(list);
        }
        sph_scene_free(&s);
    }
}

static void test_generate(void **state) {
    (void)state;
    static const char *const kinds[] = {"paper5", "paper100", "interpenetrating", "random",
                                        "huge_tiny"};
    static const uint32_t counts[] = {5, 100, 27, 1000, 101};
    for (int i = 0; i < 5; i++) {
        struct sph_error err = {""};
        struct sph_scene s, again;
        struct sph_generate_options o = {.width = 64, .height = 36, .seed = 9};
        assert_int_equal(sph_generate(kinds[i], NULL, &s, &err), 0);
        assert_int_equal(s.n_spheres, counts[i]);
        assert_true(s.n_lights > 0 && s.camera.width == 320 && s.camera.height == 180);
        round_trip(&s);
        assert_int_equal(sph_generate(kinds[i], NULL, &again, &err), 0);
        assert_same_scene(&s, &again);
        sph_scene_free(&again);
        assert_int_equal(sph_generate(kinds[i], &o, &again, &err), 0);
        assert_int_equal(again.n_spheres, counts[i]);
        assert_int_equal(again.camera.width, 64);
        sph_scene_free(&again);
        sph_scene_free(&s);
    }
}

static int outside(double v, double reach) {
    return !(v >= -reach && v <= reach);
}

/* Aroxa's scenarios: where the spheres are, the lattice without gaps, what options do. */
static void test_scenarios(void **state) {
    (void)state;
    static const char *const kinds[] = {"scenario1", "scenario2", "scenario3"};
    for (int i = 0; i < 3; i++)
        for (uint32_t n = 64; n <= 512; n *= 2) {
            struct sph_error err = {""};
            struct sph_generate_options o = {.n = n, .seed = n, .radius = 0.5, .plain = n == 128};
            struct sph_scene s;
            uint32_t corners = 0, sides[3] = {0};
            assert_int_equal(sph_generate(kinds[i], &o, &s, &err), 0);
            assert_true(s.n_spheres == n && s.n_facets == 1 && s.n_lights == 1);
            assert_true(s.camera.width == 640 && s.camera.height == 1088);
            assert_true(s.materials[0].sum.on == !o.plain && s.materials[1].trans > 0.6);
            for (uint32_t j = 0; j < n; j++) {
                const struct sph_vec c = s.spheres[j].ctr;
                double near = fmin(fabs(c.x), fmin(fabs(c.y), fabs(c.z)));
                assert_true(s.spheres[j].rad == 0.5);
                assert_false(outside(c.x, 19.5) || outside(c.y, 19.5) || outside(c.z, 19.5));
                corners += near >= 12.5;
                sides[0] += c.y == s.spheres[n - 1].ctr.y && c.z == s.spheres[n - 1].ctr.z;
                sides[1] += c.z == s.spheres[n - 1].ctr.z && c.x == s.spheres[n - 1].ctr.x;
                sides[2] += c.x == s.spheres[n - 1].ctr.x && c.y == s.spheres[n - 1].ctr.y;
            }
            if (i == 1) assert_int_equal(corners, n);
            if (i == 2) assert_true(corners >= n / 2);
            if (i != 1) assert_int_equal(sides[0] * sides[1] * sides[2], i == 0 ? n : n - n / 2);
            if (i != 1) assert_true(sides[0] >= sides[2] && sides[0] <= 2 * sides[2]);
            round_trip(&s);
            sph_scene_free(&s);
        }
    struct sph_generate_options thick = {.radius = 20.5};
    struct sph_error err = {""};
    struct sph_scene s;
    assert_int_equal(sph_generate("scenario1", &thick, &s, &err), -1);
    assert_non_null(strstr(err.text, "radius 20.5"));
}

/* Scenes in the manner of SPD, and those that many renderers show: what is in them at sizes 1, 3.
 */
static void test_shown(void **state) {
    (void)state;
    static const struct {
        const char *kind;
        uint32_t spheres[2], facets[2];
        int lights;
    } made[] = {{"balls", {10, 820}, {2, 2}, 3},  {"mount", {4, 4}, {128, 2048}, 1},
                {"tetra", {0, 0}, {16, 256}, 1},  {"shells", {48, 144}, {0, 0}, 1},
                {"cover", {474, 474}, {0, 0}, 1}, {"cornell", {0, 0}, {30, 30}, 1},
                {"horizon", {1, 1}, {1, 1}, 1}};
    for (size_t i = 0; i < sizeof made / sizeof *made; i++)
        for (int k = 0; k < 2; k++) {
            struct sph_error err = {""};
            struct sph_generate_options o = {.size = k ? 3 : 1};
            struct sph_scene s;
            if (sph_generate(made[i].kind, &o, &s, &err)) fail_msg("%s", err.text);
            assert_int_equal(s.n_spheres, made[i].spheres[k]);
            assert_int_equal(s.n_facets, made[i].facets[k]);
            assert_int_equal(s.n_lights, made[i].lights);
            round_trip(&s);
            sph_scene_free(&s);
        }
}

/* The spheres of the cover stand on the largest and do not touch each other. */
static void test_cover(void **state) {
    (void)state;
    for (uint64_t seed = 0; seed < 3; seed++) {
        struct sph_error err = {""};
        struct sph_generate_options o = {.seed = seed};
        struct sph_scene s;
        assert_int_equal(sph_generate("cover", &o, &s, &err), 0);
        for (uint32_t i = 1; i < s.n_spheres; i++)
            for (uint32_t k = 0; k < i; k++) {
                const struct sph_sphere *a = &s.spheres[i], *b = &s.spheres[k];
                double apart =
                    hypot(hypot(a->ctr.x - b->ctr.x, a->ctr.y - b->ctr.y), a->ctr.z - b->ctr.z) -
                    a->rad - b->rad;
                assert_true(apart > (k ? 0 : -1e-9));
                if (!k && a->rad < 1) assert_true(apart < 1e-9);
            }
        sph_scene_free(&s);
    }
}

static int by_edge(const void *a, const void *b) {
    return memcmp(a, b, 2 * sizeof(struct sph_vec));
}

/* Every edge of a closed mesh has two triangles, one in each direction, to the last bit. */
static void test_icosphere(void **state) {
    (void)state;
    struct edge {
        struct sph_vec from, to;
    };
    for (int size = 1; size <= 3; size++) {
        struct sph_error err = {""};
        struct sph_scene s;
        struct sph_generate_options o = {.size = size};
        assert_int_equal(sph_generate("icosphere", &o, &s, &err), 0);
        uint32_t n = 20u << 2 * size, edges = 3 * n;
        assert_int_equal(s.n_facets, n + 1);
        assert_int_equal(s.facets[n].kind, SPH_PLANE);
        struct edge *list = calloc(edges, sizeof *list);
        assert_non_null(list);
        for (uint32_t i = 0; i < edges; i++) {
            struct sph_vec *v = s.facets[i / 3].v, zero = {0, 0, 0};
            struct edge *e = &list[i];
            e->from = v[i % 3], e->to = v[(i + 1) % 3];
            e->from.x += zero.x, e->from.y += zero.y, e->from.z += zero.z; /* no -0 */
            e->to.x += zero.x, e->to.y += zero.y, e->to.z += zero.z;
        }
        qsort(list, edges, sizeof *list, by_edge);
        for (uint32_t i = 0; i < edges; i++) {
            struct edge back = {list[i].to, list[i].from};
            assert_true(i == 0 || by_edge(&list[i - 1], &list[i]) != 0);
            assert_non_null(bsearch(&back, list, edges, sizeof *list, by_edge));
        }
        round_trip(&s);
        free(list);
        sph_scene_free(&s);
    }
}

static void test_generate_bad(void **state) {
    (void)state;
    struct sph_error err = {""}, err2 = {""}, err3 = {""}, err4 = {""}, err5 = {""};
    struct sph_generate_options big = {.size = 6, .n = SPH_MAX_SPHERES + 1};
    struct sph_generate_options wide = {.width = 20000, .height = 1};
    struct sph_scene s;
    assert_int_equal(sph_generate("cube", NULL, &s, &err), -1);
    assert_non_null(strstr(err.text, "cannot generate `cube`"));
    assert_int_equal(sph_generate("sphereflake", &big, &s, &err2), -1);
    assert_int_equal(sph_generate("random", &big, &s, &err3), -1);
    assert_int_equal(sph_generate("paper5", &wide, &s, &err4), -1);
    assert_non_null(strstr(err4.text, "20000"));
    assert_int_equal(sph_generate("icosphere", &big, &s, &err5), -1);
    assert_null(s.spheres);
}

/* The files in scenes/ read well; those made by a generator are what it makes today. */
static void test_scene_files(void **state) {
    (void)state;
    static const struct {
        const char *name, *kind;
        uint32_t n_spheres;
    } files[] = {{"sphereflake2", "sphereflake", 91},
                 {"paper5", "paper5", 5},
                 {"paper100", "paper100", 100},
                 {"interpenetrating", "interpenetrating", 27},
                 {"huge_tiny", "huge_tiny", 101},
                 {"one_sphere", NULL, 1},
                 {"materials", NULL, 10},
                 {"inside", NULL, 7},
                 {"eight_lights", NULL, 8},
                 {"no_light", NULL, 2},
                 {"empty", NULL, 0},
                 {"facets/triangles", NULL, 0},
                 {"facets/plane", NULL, 6},
                 {"facets/room", NULL, 7}};
    for (size_t i = 0; i < sizeof files / sizeof files[0]; i++) {
        struct sph_error err = {""};
        struct sph_scene s, made;
        char path[64];
        snprintf(path, sizeof path, "scenes/%s.nff", files[i].name);
        if (sph_scene_read(path, NULL, &s, &err)) fail_msg("%s", err.text);
        assert_int_equal(s.n_spheres, files[i].n_spheres);
        assert_true(s.camera.width == 320 && s.camera.height == 180);
        const char *slash = strrchr(files[i].name, '/');
        assert_string_equal(s.name, slash ? slash + 1 : files[i].name);
        if (files[i].kind) {
            assert_int_equal(sph_generate(files[i].kind, NULL, &made, &err), 0);
            assert_same_scene(&s, &made);
            sph_scene_free(&made);
        }
        sph_scene_free(&s);
    }
}

int main(void) {
    const struct CMUnitTest others[] = {
        cmocka_unit_test(test_sphereflake),  cmocka_unit_test(test_generate),
        cmocka_unit_test(test_scenarios),    cmocka_unit_test(test_icosphere),
        cmocka_unit_test(test_shown),        cmocka_unit_test(test_cover),
        cmocka_unit_test(test_generate_bad), cmocka_unit_test(test_scene_files)};
    return run_cases("scene_make", NULL, NULL, 0, others, sizeof others / sizeof others[0]);
}
