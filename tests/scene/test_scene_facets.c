/* test_scene_facets.c - scene files: polygons, triangles, planes, textures
 * SPDX-License-Identifier: Apache-2.0
 */
#include "scene_files.h"

#include <math.h>

#include "scene/ears.h"
#include "scene/polygon.h"
#include "scene/rng.h"

#define SQUARE "0 0 0\n2 0 0\n2 2 0\n0 2 0\n"
static const struct bad bads[] = {
    {"polygon_before_material", CAM "p 3 0 0 0 1 0 0 0 1 0\n", 8, "no material", 0, 0},
    {"triangle_before_material", CAM "tt x 0 0 0 0 0\n", 8, "no material", 0, 0},
    {"plane_before_material", CAM "plane 0 0 0 0 1 0\n", 8, "before this plane", 0, 0},
    {"polygon_2", CAM MAT "p 2 0 0 0 1 0 0\n", 9, "`p`: 2 corners; a polygon has 3 to 1024", 0, 0},
    {"polygon_many", CAM MAT "p 1025\n", 9, "1025 corners", 0, 0},
    {"polygon_part", CAM MAT "pp 3.5\n", 9, "`pp`: 3.5 corners", 0, 0},
    {"polygon_short", CAM MAT "p 3\n0 0 0\n1 0 0\n0 1\n", 12, "ends within `p`, before z", 0, 0},
    {"patch_short", CAM MAT "pp 3\n0 0 0 0 0 1\n1 0 0\n", 11, "ends within `pp`", 0, 0},
    {"point", CAM MAT "p 3 1 2 3 1 2 3 1 2 3\n", 9, "left out: triangle or polygon without area",
     STRICT, 0},
    {"line", CAM MAT "p 3 0 0 0 1 1 1 .3 .3 .3\n", 9, "left out: triangle or polygon without area",
     STRICT, 0},
    {"lines", CAM MAT "s 0 0 0 1\np 4 0 0 0 1 1 1 .3 .3 .3 .9 .9 .9\n", 10, "without area", STRICT,
     0},
    {"bow_tie", CAM MAT "p 4 0 0 0 2 2 0 2 0 0 0 1 0\n", 9,
     "`p`: the edges from corner 1 and from corner 3 of the polygon cross", 0, 0},
    {"bow_tie_even", CAM MAT "p 4 0 0 0 2 2 0 2 0 0 0 2 0\n", 9,
     "`p`: the edges from corner 1 and from corner 3 of the polygon cross", 0, 0},
    {"pentagram",
     CAM MAT "p 5 1 0 0 -.809017 .587785 0 .309017 -.951057 0 .309017 .951057 0 "
             "-.809017 -.587785 0\n",
     9, "from corner 1 and from corner 3 of the polygon cross", 0, 0},
    {"over_itself", CAM MAT "p 8 0 0 0 4 0 0 4 4 0 2 2 0 0 0 0 0 4 0 2 2 0 4 0 0\n", 9, "`p`: ", 0,
     0},
    {"tt_flat", CAM MAT "tt x.png 0 0 0 0 0 1 1 1 0 0 2 2 2 1 1\n", 9, "without area", STRICT, 0},
    {"tt_short", CAM MAT "tt x.png 0 0 0 0 0 1 1 1 0 0 2 2 2 1\n", 9, "ends within `tt`, before v",
     0, 0},
    {"tt_no_name", CAM MAT "tt", 9, "ends within `tt`, before image file", 0, 0},
    {"tt_number", CAM MAT "tt x.png 0 0 y\n", 9, "`tt`: z: `y` is not a decimal", 0, 0},
    {"plane_short", CAM MAT "plane 0 0 0 0 1\n", 9, "ends within `plane`, before nz", 0, 0},
    {"plane_normal", CAM MAT "plane 0 0 0 0 -0 0\n", 9, "the normal is zero", 0, 0},
    {"plane_along", CAM MAT "plane 0 0 0 0 1 0 0 -3 0\n", 9, "is along the normal", 0, 0},
    {"plane_along_zero", CAM MAT "plane 0 0 0 0 1 0 0 0 0\n", 9, "or zero", 0, 0},
    {"plane_along_short", CAM MAT "plane 0 0 0 0 1 0 2 s 0 0 0 1\n", 9, "sy: `s` is not", 0, 0},
    {"texture_empty", CAM "texture \"\" 1 1\n", 8, "name of the image file is empty", 0, 0},
    {"texture_no_size", CAM "texture x.png 1\n", 8, "ends within `texture`, before sv", 0, 0},
    {"texture_zero", CAM "texture x.png 1 0\n", 8, "`texture`: sv 0 is not positive", 0, 0},
    {"texture_offset", CAM "texture x.png 1 1 .5 clamp\n", 8, "ov: `clamp` is not", 0, 0},
    {"texture_quote", CAM "texture \"x.png 1 1\n", 8, "line ends before the second quote", 0, 0},
    {"texture_quote_end", CAM "texture \"x.png", 8, "file ends before the second quote", 0, 0},
    {"texture_quote_within", CAM "texture x\"y\" 1 1\n", 8, "a quote within the name", 0, 0},
    {"texture_control", CAM "texture x\033y 1 1\n", 8, "byte 0x1b", 0, 0},
    {"fm_short", CAM "fm 1 1 1 1 1 1 0 0 0 5 0\n", 8, "ends within `fm`, before index", 0, 0},
    {"fm_above_1", CAM "fm 1 1 1 1 2 1 0 0 0 5 0 1\n", 8, "diffuse green 2 is not", 0, 0},
    {"fm_shine", CAM "fm 1 1 1 1 1 1 0 0 0 -5 0 1\n", 8, "`fm`: Shine is negative", 0, 0},
    {"fm_t", CAM "fm 1 1 1 1 1 1 0 0 0 5 2 1\n", 8, "T 2 is not within", 0, 0},
};

static void test_bad(void **state) {
    const struct bad *bad = *state;
    struct sph_error err = {""};
    struct sph_scene scene;
    put_bad(bad);
    const struct sph_read_options how = bad_options(bad);
    assert_int_equal(sph_scene_read(file_name, &how, &scene, &err), -1);
    assert_message(bad, &err);
    assert_null(scene.facets);
    assert_null(scene.textures);
}

static void read_text(const char *text, struct sph_scene *scene) {
    struct sph_error err = {""};
    put_file(text, strlen(text));
    if (sph_scene_read(file_name, NULL, scene, &err)) fail_msg("%s", err.text);
}

static void assert_corner(const struct sph_facet *f, int corner, double x, double y, double z) {
    assert_true(f->v[corner].x == x && f->v[corner].y == y && f->v[corner].z == z);
}

/* Corners of a text, x and y of each a digit: how many, and one of them. */
static int corners_of(const char *text) {
    return (int)(strlen(text) + 1) / 3;
}

static struct sph_vec corner_of(const char *text, int i) {
    return sph_vec_of(text[3 * i] - '0', text[3 * i + 1] - '0', 0);
}

/* What polygons become. */
static const struct {
    const char *text;      /* behind a material */
    const char *groups;    /* a digit a triangle: those of one polygon share it */
    const char *corners;   /* three a triangle as in corner_of(), the first ones; -- : any */
    const char *lines;     /* a digit a triangle: line 9 + it */
    const char *materials; /* a digit a triangle */
    uint32_t bent;         /* polygons that are not flat, the first in line 9 */
} polygons[] = {
    /* a square; behind another material a triangle with normals; a sphere */
    {"p 4\n" SQUARE "f 0 1 0 .5 .5 1 0 1\npp 3 0 0 0 9 9 9 1 0 0 0 0 0 0 1 0 8 8 8\ns 0 0 0 1\n",
     "001", "00 20 22 00 22 02 -- -- 01", "006", "001", 0},
    /* a corner on an edge: the fan starts where it loses least */
    {"p 5 0 0 0 1 0 0 2 0 0 2 2 0 0 2 0\n", "000", "10", "000", "000", 0},
    /* closed by its first corner */
    {"p 5 0 0 0 2 0 0 2 2 0 0 2 0 0 0 0\n", "00", "", "00", "00", 0},
    /* all but one on a line */
    {"p 5 0 0 0 1 0 0 2 0 0 3 0 0 0 4 0\n", "000", "04", "000", "000", 0},
    /* as good as convex */
    {"p 4 0 0 0 1 1e-7 0 2 0 0 1 1 0\n", "00", "", "00", "00", 0},
    /* as good as the same corner twice */
    {"p 5 0 0 0 2 0 0 2 2 0 2.0000000000001 2.0000000000001 0 0 2 0\n", "00", "", "00", "00", 0},
    /* not flat, so triangles that are polygons of their own: a wall of the Cornell box as measured,
     * and a patch; as good as flat */
    {"p 4 552.8 0 0 549.6 0 559.2 556 548.8 559.2 556 548.8 0\n"
     "p 4 0 0 0 2 0 0 2 2 .001 0 2 0\n"
     "pp 5 0 0 0 0 0 1 2 0 1 0 0 1 3 2 -1 0 0 1 2 4 1 0 0 1 0 4 0 0 0 1\n",
     "0122345", "", "0011222", "0000000", 2},
};

static void test_polygons(void **state) {
    (void)state;
    for (size_t k = 0; k < sizeof polygons / sizeof *polygons; k++) {
        struct sph_scene s;
        char text[1024];
        snprintf(text, sizeof text, CAM MAT "%s", polygons[k].text);
        read_text(text, &s);
        if (s.n_facets != strlen(polygons[k].groups)) fail_msg("%s: %u", text, s.n_facets);
        for (uint32_t i = 0; i < s.n_facets; i++) {
            const struct sph_facet *f = &s.facets[i];
            assert_int_equal(f->kind, SPH_TRIANGLE);
            assert_int_equal(f->group, polygons[k].groups[i] - '0');
            assert_int_equal(f->line, 9 + polygons[k].lines[i] - '0');
            assert_int_equal(f->material, polygons[k].materials[i] - '0');
        }
        for (int i = 0; i < corners_of(polygons[k].corners); i++) {
            struct sph_vec at = corner_of(polygons[k].corners, i);
            if (at.x >= 0) assert_corner(&s.facets[i / 3], i % 3, at.x, at.y, 0);
        }
        assert_int_equal(s.n_spheres, strstr(text, "\ns ") != NULL);
        assert_int_equal(s.ledger.row[SPH_READ_BENT].n, polygons[k].bent);
        if (polygons[k].bent) assert_int_equal(s.ledger.row[SPH_READ_BENT].line, 9);
        round_trip(&s);
        sph_scene_free(&s);
    }
}

/* Twice the area of a triangle, seen along -z. */
static double twice(const struct sph_facet *f) {
    return (f->v[1].x - f->v[0].x) * (f->v[2].y - f->v[0].y) -
           (f->v[1].y - f->v[0].y) * (f->v[2].x - f->v[0].x);
}

/* Polygons that are not convex, from any corner on and both ways round: so many triangles of one
 * group, all turned as the polygon is, of its area together; written and read they are the same. */
static void test_concave(void **state) {
    (void)state;
    static const struct {
        const char *corners; /* as in corner_of() */
        double twice;        /* its area */
    } shapes[] = {
        {"00 40 11 04", 8},                          /* a dart */
        {"00 30 31 11 13 03", 10},                   /* an L */
        {"00 80 84 64 44 21 04", 52},                /* corners on an edge */
        {"00 70 72 62 61 41 42 32 31 11 12 02", 20}, /* a comb */
    };
    for (size_t k = 0; k < sizeof shapes / sizeof *shapes; k++)
        for (int turn = 0, n = corners_of(shapes[k].corners); turn < 2 * n; turn++) {
            char text[2048] = CAM MAT;
            int sign = turn < n ? 1 : -1;
            size_t used = strlen(text);
            used += (size_t)snprintf(text + used, sizeof text - used, "p %d\n", n);
            for (int i = 0; i < n; i++) {
                struct sph_vec at = corner_of(shapes[k].corners, (turn + sign * i + 2 * n) % n);
                used += (size_t)snprintf(text + used, sizeof text - used, "%g %g 3\n", at.x, at.y);
            }
            struct sph_scene s;
            double sum = 0;
            read_text(text, &s);
            assert_int_equal(s.n_facets, n - 2);
            for (uint32_t i = 0; i < s.n_facets; i++) {
                assert_true(sign * twice(&s.facets[i]) > 0);
                assert_int_equal(s.facets[i].group, 0);
                sum += sign * twice(&s.facets[i]);
            }
            assert_true(fabs(sum - shapes[k].twice) < 1e-12);
            round_trip(&s);
            sph_scene_free(&s);
        }
}

/* Stars of random rays: every point of the plane lies in one triangle if it lies in the star. */
static void test_stars(void **state) {
    (void)state;
    struct sph_rng rng = {11};
    for (int star = 0; star < 60; star++) {
        int n = 5 + star;
        struct sph_vec corner[80];
        int index[80][3];
        double bent = 0, reach[80];
        struct sph_error err = {""};
        for (int i = 0; i < n; i++) {
            reach[i] = sph_rng_range(&rng, 0.1, 1);
            corner[i] = (struct sph_vec){reach[i] * cos(2 * M_PI * i / n),
                                         reach[i] * sin(2 * M_PI * i / n), 0};
        }
        assert_int_equal(sph_polygon_cut(corner, n, index, &bent, &err), n - 2);
        for (int point = 0; point < 200; point++) {
            double at[2], turns[3], in = 0;
            at[0] = sph_rng_range(&rng, -1, 1);
            at[1] = sph_rng_range(&rng, -1, 1);
            double angle = atan2(at[1], at[0]) / (2 * M_PI) * n;
            int i = (int)floor(angle + n) % n, within;
            const struct sph_vec *a = &corner[i], *b = &corner[(i + 1) % n];
            within = (b->x - a->x) * (at[1] - a->y) - (b->y - a->y) * (at[0] - a->x) > 0;
            for (int t = 0; t < n - 2; t++) {
                for (int e = 0; e < 3; e++) {
                    const struct sph_vec *p = &corner[index[t][e]];
                    const struct sph_vec *q = &corner[index[t][(e + 1) % 3]];
                    turns[e] = (q->x - p->x) * (at[1] - p->y) - (q->y - p->y) * (at[0] - p->x);
                }
                in += turns[0] > 0 && turns[1] > 0 && turns[2] > 0;
            }
            assert_true(in == within);
        }
    }
}

/* How often an outline goes round a point. */
static int winding(const struct sph_vec *c, int n, double x, double y) {
    int turns = 0;
    for (int i = 0; i < n; i++) {
        const struct sph_vec *a = &c[i], *b = &c[(i + 1) % n];
        double side = (b->x - a->x) * (y - a->y) - (b->y - a->y) * (x - a->x);
        turns += (a->y <= y && b->y > y && side > 0) - (a->y > y && b->y <= y && side < 0);
    }
    return turns;
}

/* Outlines that touch themselves: a point lies in as many triangles as the outline goes round it.
 * All are turned so that every corner is the first once. */
static void test_touching(void **state) {
    (void)state;
    static const char *const shapes[] = {
        "00 90 99 09 00 33 36 66 63 33",                /* a hole by a bridge */
        "00 90 99 09 00 22 23 33 55 57 77 75 55 33 22", /* two of them, one behind the other */
        "00 40 44 20 04",                               /* a corner on an edge */
        "00 40 44 21 21 04",                            /* the same corner twice */
        "00 90 40 04",                                  /* there and back again */
        "00 21 40 44 21 35 15 04",                      /* a corner at a corner */
        "00 40 44 24 22 24 04",                         /* a slit */
    };
    struct sph_rng rng = {5};
    for (size_t k = 0; k < sizeof shapes / sizeof *shapes; k++)
        for (int first = 0, n = corners_of(shapes[k]); first < n; first++) {
            struct sph_vec corner[16];
            int index[16][3];
            double bent;
            struct sph_error err = {""};
            for (int i = 0; i < n; i++)
                corner[i] = corner_of(shapes[k], (i + first) % n);
            int count = sph_polygon_cut(corner, n, index, &bent, &err);
            if (count <= 0) fail_msg("shape %zu from %d: %s", k, first, err.text);
            for (int point = 0; point < 300; point++) {
                double x = sph_rng_range(&rng, -1, 10), y = sph_rng_range(&rng, -1, 10);
                int in = 0;
                for (int t = 0; t < count; t++) {
                    struct sph_vec v[3] = {corner[index[t][0]], corner[index[t][1]],
                                           corner[index[t][2]]};
                    in += winding(v, 3, x, y);
                }
                if (in != winding(corner, n, x, y))
                    fail_msg("shape %zu from %d: %g, %g lies in %d", k, first, x, y, in);
            }
        }
}

/* The sign of a determinant where doubles lose it: a step of the last bit beside a long line. */
static void test_turn(void **state) {
    (void)state;
    const double a[2] = {0.5, 0.5}, far[2] = {24, 24}, farther[2] = {12, 12};
    for (int i = -3; i <= 3; i++)
        for (int k = -3; k <= 3; k++) {
            double at[2] = {a[0] + i * 0x1p-53, a[1] + k * 0x1p-53};
            if (i < 0 || k < 0) at[0] = a[0] + i * 0x1p-54, at[1] = a[1] + k * 0x1p-54;
            int want = (at[1] > at[0]) - (at[1] < at[0]);
            assert_int_equal(sph_turn(farther, far, at), want);
            assert_int_equal(sph_turn(at, farther, far), want);
            assert_int_equal(sph_turn(far, farther, at), -want);
        }
    const double tiny[3][2] = {{0, 0}, {3e-170, 1e-170}, {3e-160, 1e-160}};
    assert_int_equal(sph_turn(tiny[0], tiny[1], (double[]){3e-160, 1.0001e-160}), 1);
    assert_int_equal(
        sph_turn(tiny[0], (double[]){0x3p-600, 0x1p-600}, (double[]){0x3p-590, 0x1p-590}), 0);
    assert_int_equal(sph_turn(tiny[1], tiny[2], tiny[1]), 0);
}

static void test_planes_and_textures(void **state) {
    (void)state;
    struct sph_scene s;
    char image[100];
    read_text(CAM MAT "plane 0 -1 0 0 2 0\ns 0 0 0 1\ntexture a.png 2 3 .25 .5\ns 1 0 0 1\n"
                      "plane 0 0 -9 0 0 1 1 1 0 texture \"a b.png\" .5 .5 clamp s 2 0 0 1\n"
                      "texture none/x.png 1 1 s 4 0 0 1\ntexture none\ns 3 0 0 1\n"
                      "tt a.png#c\n0 0 0 0 0\n1 0 0 1 0\n0 1 0 0 -1.5\n"
                      "tt \"none\" 0 0 0 0 0 1 0 0 1 0 0 0 1 0 1 plane 1 0 0 1 0 0\n"
                      "tt a.png 0 0 3 0 0 1 0 3 1 0 0 1 3 0 -1.5\n"
                      "texture a.png 2 3 .25 .75 s 0 1 0 1 texture a.png 4 3 .25 .5 s 0 2 0 1\n"
                      "texture a.png 2 3 .25 .5 s 0 3 0 1\n",
              &s);
    assert_int_equal(s.n_facets, 6);
    assert_int_equal(s.n_textures, 7);
    snprintf(image, sizeof image, "%s/a.png", folder);
    assert_string_equal(s.textures[0].path, image);
    snprintf(image, sizeof image, "%s/none/x.png", folder);
    assert_string_equal(s.textures[2].path, image);
    snprintf(image, sizeof image, "%s/none", folder);
    assert_string_equal(s.textures[4].path, image);
    assert_true(s.textures[0].repeat[1] == 3 && s.textures[0].offset[0] == 0.25);
    assert_int_equal(s.textures[0].wrap[0], 0);
    assert_int_equal(s.textures[1].wrap[1], 1);
    static const uint32_t spheres[8] = {0, 1, 2, 3, 0, 6, 7, 1}, facets[6] = {0, 1, 4, 5, 0, 4};
    for (int i = 0; i < 8; i++)
        assert_int_equal(s.spheres[i].texture, spheres[i]);
    for (int i = 0; i < 6; i++)
        assert_int_equal(s.facets[i].texture, facets[i]);
    assert_corner(&s.facets[0], 1, 0, 2, 0);
    assert_corner(&s.facets[0], 2, 1, 0, 0); /* s along x; along z where x is the normal */
    assert_corner(&s.facets[1], 2, 1, 1, 0);
    assert_corner(&s.facets[4], 2, 0, 0, 1);
    assert_true(s.facets[1].st[0][0] == 2 && s.facets[1].st[1][1] == 0.5);
    assert_true(s.facets[2].st[2][1] == -1.5 && s.facets[2].st[1][0] == 1);
    assert_int_equal(s.facets[0].kind, SPH_PLANE);
    round_trip(&s);
    sph_scene_free(&s);
}

static void test_extended_material(void **state) {
    (void)state;
    struct sph_scene s;
    read_text(CAM "fm .1 .1 .1 .25 .5 0 .2 .4 .6 7 .3 1.5\ns 0 0 0 1\nfm 1 1 1 0 0 0 0 0 0 0 0 0\n"
                  "s 0 0 0 2\n",
              &s);
    const struct sph_material *m = s.materials;
    assert_true(m->rgb[0] == 0.5 && m->rgb[1] == 1 && m->rgb[2] == 0 && m->kd == 0.5);
    assert_true(m->ks > 0.3999 && m->ks < 0.4001 && m->shine == 7 && m->trans == 0.3);
    assert_true(m->ior == 1.5 && m[1].kd == 0 && m[1].rgb[0] == 0);
    sph_scene_free(&s);
}

static void test_too_many(void **state) {
    (void)state;
    struct sph_error err = {""}, err2 = {""};
    struct sph_scene full = {
        .path = "x.nff", .n_facets = SPH_MAX_FACETS, .n_textures = SPH_MAX_TEXTURES};
    struct sph_facet facet = {.kind = SPH_TRIANGLE, .line = 7};
    struct sph_texture texture = {.line = 8};
    assert_int_equal(sph_scene_add_facet(&full, &facet, &err), -1);
    assert_string_equal(err.text, "x.nff:7: more than 1048576 triangles and planes");
    assert_int_equal(sph_scene_add_texture(&full, &texture, &err2), -1);
    assert_string_equal(err2.text, "x.nff:8: more than 1024 textures");
}

/* Normals at corners: kept, written and read again; one that is zero leaves the polygon flat. */
static void test_normals(void **state) {
    (void)state;
    struct sph_scene s;
    read_text(CAM MAT "pp 3 0 0 0 9 9 9 1 0 0 0 0 2 0 1 0 8 8 8\n"
                      "ttp x 0 0 0 1 0 1 0 0 1 0 0 0 0 2 1 0 0 1 0 0 1 1 0 1\n"
                      "pp 3 0 0 0 9 9 9 1 0 0 0 0 0 0 1 0 8 8 8\n",
              &s);
    assert_int_equal(s.n_facets, 3);
    assert_true(s.facets[0].smooth && s.facets[1].smooth && !s.facets[2].smooth);
    assert_true(s.facets[0].n[0].x == 9 && s.facets[0].n[1].z == 2 && s.facets[0].n[2].y == 8);
    assert_true(s.facets[1].n[0].x == 1 && s.facets[1].n[1].z == 2 && s.facets[1].st[2][1] == 1);
    round_trip(&s);
    sph_scene_free(&s);
}

/* Every beginning of a good file, and good files with random damage: success or a message. */
static void test_damaged(void **state) {
    (void)state;
    const char good[] = CAM MAT "p 4\n" SQUARE "texture \"a b\" 1 2 clamp\nplane 0 0 0 0 1 0\n"
                                "tt x 0 0 0 0 0 1 0 0 1 0 0 1 0 0 1\nfm 1 1 1 1 1 1 0 0 0 5 0 1\n"
                                "pp 3 0 0 0 9 9 9 1 0 0 0 0 0 0 1 0 8 8 8\n";
    const size_t n = sizeof good - 1;
    struct sph_rng rng = {1};
    int n_read = 0;
    for (size_t i = 0; i < n + 2000; i++) {
        char text[sizeof good];
        memcpy(text, good, sizeof good);
        for (int k = 0; i >= n && k < 2; k++)
            text[sph_rng_next(&rng) % n] = (char)(sph_rng_next(&rng) >> (k ? 57 : 56));
        put_file(text, i < n ? i : n);
        struct sph_error err = {""};
        struct sph_scene scene;
        int bad = sph_scene_read(file_name, NULL, &scene, &err);
        assert_int_equal(bad, err.text[0] ? -1 : 0);
        n_read += !bad;
        if (!bad) sph_scene_free(&scene);
    }
    assert_in_range(n_read, 20, n + 1999);
}

int main(void) {
    const struct CMUnitTest others[] = {cmocka_unit_test(test_polygons),
                                        cmocka_unit_test(test_concave),
                                        cmocka_unit_test(test_stars),
                                        cmocka_unit_test(test_touching),
                                        cmocka_unit_test(test_turn),
                                        cmocka_unit_test(test_planes_and_textures),
                                        cmocka_unit_test(test_extended_material),
                                        cmocka_unit_test(test_too_many),
                                        cmocka_unit_test(test_normals),
                                        cmocka_unit_test(test_damaged)};
    return run_cases("scene_facets", test_bad, bads, sizeof bads / sizeof bads[0], others,
                     sizeof others / sizeof others[0]);
}
