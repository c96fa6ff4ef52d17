/* test_aff.c - scenes of AFF: transforms, keys, meshes, includes, and what is wrong with bad ones
 * SPDX-License-Identifier: Apache-2.0
 *
 * build/test/test_aff [seed]
 */
#include "scene_files.h"
#include "number.h"

#include <math.h>

#include "scene/aff.h"
#include "scene/motion.h"
#include "scene/rng.h"
#include "scene/spline.h"

#define MESH "m vertices 3\n0 0 0\n1 0 0\n0 1 0\ntriangles 1\n0 1 2\n"
#define KEYS4 "0 0 0 0 0 0 0\n1 0 0 0 0 0 0\n2 4 0 0 0 0 0\n3 4 0 0 0 0 0\n"
enum { MUTANTS = 1500 };
static uint64_t seed = 1;
static char part_name[80], nff_name[80];

static double unit(struct sph_rng *rng) {
    return sph_rng_range(rng, 0, 1);
}

static size_t below(struct sph_rng *rng, size_t n) {
    return (size_t)(sph_rng_next(rng) % n);
}

static const struct bad bads[] = {
    {"missing", CAM MAT "\ni 0 none.aff\n", 10, "`i`: ", 0, 0},
    {"itself", CAM MAT "i 0 scene.aff\n", 9, "scene.aff includes itself", 0, 0},
    {"word", CAM MAT "xs 1 1 1 0 0 1 0 0 0 0 {\nmove 1 0 0\n}\n", 10, "unknown word `move`", 0, 0},
    {"patch", CAM MAT "pb\n1 2 3\n", 9, "`pb` (Bezier patch) is not supported", 0, 0},
    {"index", CAM MAT "m vertices 2\n0 0 0\n1 0 0\ntriangles 1\n0 1 2\n", 13,
     "vertex 2 is none of 0 to 1", 0, 0},
    {"index_half", CAM MAT "m vertices 2\n0 0 0\n1 0 0\ntriangles 1\n0 0.5 1\n", 13,
     "vertex 0.5 is none of", 0, 0},
    {"index_normal", CAM MAT "m vertices 1\n0 0 0\nnormals 1\n0 0 1\ntriangles 1\n0 0 0 0 0 -1\n",
     14, "normal -1 is none of 0 to 0", 0, 0},
    {"index_coords",
     CAM MAT "m vertices 1\n0 0 0\ntexturecoords 1 none\n0 0\ntriangles 1\n0 0 0\n0 0 7\n", 15,
     "texture coordinate 7 is none of 0 to 0", 0, 0},
    {"no_vertices", CAM MAT "m triangles 1\n0 0 0\n", 9, "triangles without vertices", 0, 0},
    {"lists", CAM MAT "m vertices 0\nvertices 0\n", 10, "`vertices`: given twice", 0, 0},
    {"list", CAM MAT "m edges 3\n", 9, "`m`: `edges` is none of vertices, normals", 0, 0},
    {"mesh_end", CAM MAT "m vertices 2\n0 0 0\n", 10, "ends within `vertices`, before x", 0, 0},
    {"many", CAM MAT "m vertices 1e9\n", 9, "how many: 1e+09 is no whole number of 0 to", 0, 0},
    {"no_material", CAM MESH, 8, "no material (`f`) before this mesh", 0, 0},
    {"few_keys", CAM "k a {\ntransl 3\n" KEYS4 "}\n", 9, "3 keys; a spline has 4 or more", 0, 0},
    {"knots_less", CAM "k a {\ntransl 5\n" KEYS4 "}\n", 14, "`transl`: time: `}` is not", 0, 0},
    {"knots_more", CAM "k a {\ntransl 4\n" KEYS4 "4 0 0 0 0 0 0\n}\n", 14,
     "`transl`: `4` is a number more than the keys", 0, 0},
    {"track", CAM "k a { turn 4\n", 8, "`k`: `turn` is none of transl, rot, scale", 0, 0},
    {"tracks", CAM "k a {\nscale 4\n" KEYS4 "scale 4\n", 14, "`scale`: given twice", 0, 0},
    {"keys_end", CAM "k a {\nvisibility 1\n0 1\n", 10, "ends within `k`, before }", 0, 0},
    {"keys_name", CAM "k { }\n", 8, "`k`: no name", 0, 0},
    {"keys_twice", CAM "k a { visibility 1 0 1 }\nk a { visibility 1 0 0 }\n", 9,
     "second `k` of a, with other keys", 0, 0},
    {"axis", CAM "k a {\nrot 4\n0 0 0 0 9 0 0 0\n", 10, "`rot`: the axis is zero", 0, 0},
    {"xs_axis", CAM "xs 1 1 1\n0 0 0 9\n0 0 0 {\n}\n", 9, "`xs`: the axis is zero", 0, 0},
    {"brace", CAM MAT "x a\n" MESH, 10, "`x`: { is missing", 0, 0},
    {"open", CAM MAT "x a {\n" MESH, 9, "{ without }", 0, 0},
    {"closed", CAM MAT "x a {\n}\n}\n", 11, "} without {", 0, 0},
    {"oval", CAM MAT "x a {\nxs 1 2 1 0 0 1 0 0 0 0 {\ns 0 0 0 1\n} }\n", 11,
     "`s`: scaled to no sphere", 0, 0},
    {"scale_0", CAM MAT "xs 0 1 1 0 0 1 0 0 0 0 {\n" MESH "}\n", 10, "triangle is scaled by 0", 0,
     0},
    {"scale_outer", CAM MAT "xs 1 0 1 0 0 1 0 0 0 0 {\nxs 1 1 1 1 1 0 30 0 0 0 {\n" MESH "} }\n",
     11, "triangle is scaled by 0", 0, 0},
    {"scale_keys",
     CAM MAT "x a {\n" MESH "}\nk a {\nscale 4\n0 1 1 0 0 0 0\n1 1 1 0 0 0 0\n"
             "2 1 1 0 0 0 0\n3 1 1 0 0 0 0\n}\n",
     10, "triangle is scaled by 0", 0, 0},
    {"patch_times", CAM MAT "tpa 0\n", 9, "number of times: 0 is no", 0, 0},
    {"patch_order", CAM MAT "tpa 2\n1\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n0\n0 0 0 0 0 1\n", 14,
     "time 0 does not come after the one before, 1", 0, 0},
    {"a_twice", CAM "a 0 1 2\na 0 1 2\n", 9, "second `a`", 0, 0},
    {"a_back", CAM "a 1 0 2\n", 8, "the end is before the start", 0, 0},
    {"a_frames", CAM "a 0 1 0\n", 8, "`a`: frames: 0 is no whole number of 1 to", 0, 0},
    {"am", CAM "am 0 -1 0\n", 8, "`am`: a colour is negative", 0, 0},
    {"camera", MAT MESH, 0, "no camera (`v`)", 0, 0},
};

static void test_bad(void **state) {
    const struct bad *bad = *state;
    struct sph_error err = {""};
    struct sph_scene scene;
    put_bad(bad);
    assert_int_equal(sph_scene_read(file_name, NULL, &scene, &err), -1);
    assert_message(bad, &err);
}

static struct sph_scene read_at(const char *text, double time) {
    const struct sph_read_options options = {.timed = 1, .time = time};
    struct sph_error err = {""};
    struct sph_scene scene;
    put_file(text, strlen(text));
    if (sph_scene_read(file_name, &options, &scene, &err)) fail_msg("%s", err.text);
    return scene;
}

static void near_to(struct sph_vec p, double x, double y, double z) {
    if (fabs(p.x - x) > 1e-9 || fabs(p.y - y) > 1e-9 || fabs(p.z - z) > 1e-9)
        fail_msg("(%.12g %.12g %.12g) is not (%g %g %g)", p.x, p.y, p.z, x, y, z);
}

/* A scene is written as NFF, whatever it was read from. */
static void round_trip_nff(const struct sph_scene *s) {
    char keep[sizeof file_name];
    memcpy(keep, file_name, sizeof keep);
    memcpy(file_name, nff_name, sizeof keep);
    round_trip(s);
    memcpy(file_name, keep, sizeof keep);
}

/* Scale first, then turn, then move; the inner transform before the outer one. */
static void test_transforms(void **unused) {
    (void)unused;
    struct sph_scene s =
        read_at(CAM MAT "xs 1 1 1\n0 0 1 90\n10 0 0{\nxs 2 3 4 1 0 0 90 0 0 5 {\n" MESH
                        "p 3 0 0 1 1 0 1 0 1 1 }c 0 0 0 1 0 0 2 1 s 1 2 3 4}\n" MESH,
                0);
    assert_int_equal(s.n_facets, 2 + 64 + 1);
    near_to(s.facets[0].v[0], 10, 0, 5);
    near_to(s.facets[0].v[1], 10, 2, 5);
    near_to(s.facets[0].v[2], 10, 0, 8);
    near_to(s.facets[1].v[0], 14, 0, 5);
    near_to(s.facets[66].v[1], 1, 0, 0);
    near_to(s.spheres[0].ctr, 8, 1, 3);
    assert_true(fabs(s.spheres[0].rad - 4) < 1e-12);
    round_trip_nff(&s);
    sph_scene_free(&s);
}

/* A name without keys stands still; materials and comments go on across braces. */
static void test_still(void **unused) {
    (void)unused;
    struct sph_scene s = read_at("% AFF\n" CAM "x b{f 1 0 0 1 0 0 0 0\n" MESH "}% }\n" MESH, 0);
    assert_int_equal(s.n_facets, 2);
    assert_int_equal(s.facets[1].material, 0);
    near_to(s.facets[0].v[1], 1, 0, 0);
    sph_scene_free(&s);
}

#define MOVING                                                                                     \
    CAM MAT "a 1 3 5\nla lamp 0 0 1 1 1 1\nx a {\nx b {\n" MESH "}\n" MESH "}\n"                   \
            "k a {\ntransl 4\n" KEYS4 "visibility 2\n1.5 0\n2 1\n}\n"                              \
            "k b { scale 4 0 1 1 1 0 0 0 1 1 1 1 0 0 0 2 3 3 3 0 0 0 3 3 3 3 0 0 0 }\n"            \
            "k lamp { transl 4\n" KEYS4 "}\n"

static void test_keys(void **unused) {
    (void)unused;
    struct sph_scene s = read_at(MOVING, 1);
    near_to(s.facets[0].v[1], 1, 0, 0);
    near_to(s.lights[0].pos, 0, 0, 1);
    sph_scene_free(&s);
    s = read_at(MOVING, 1.25); /* tangents (2, 0, 0) at both ends of the step (4, 0, 0) */
    double u = 0.25, x = u * (2 + u * (3 * 4 - 2 * 2 - 2 + u * (2 + 2 - 2 * 4)));
    near_to(s.facets[1].v[0], x, 0, 0);
    near_to(s.facets[0].v[1], x + 1 + x / 2, 0, 0);
    near_to(s.lights[0].pos, x, 0, 1);
    sph_scene_free(&s);
    s = read_at(MOVING, 1.5);
    assert_int_equal(s.n_facets, 0);
    sph_scene_free(&s);
    s = read_at(MOVING, 99);
    assert_int_equal(s.n_facets, 2);
    near_to(s.facets[0].v[1], 7, 0, 0);
    sph_scene_free(&s);
}

/* Frames are spread evenly over the time of `a`. */
static void test_frames(void **unused) {
    (void)unused;
    struct sph_scene timed = read_at(MOVING, 1.5 + 1), rest = read_at(MOVING, 7), moved;
    struct sph_error err = {""};
    rest.read = (struct sph_read_options){0};
    assert_int_equal(sph_scene_at(&rest, 3, &moved, &err), 0);
    assert_same_scene(&timed, &moved);
    assert_same_facets(&timed, &moved);
    sph_scene_at_free(&moved);
    assert_int_equal(sph_scene_at(&rest, 5, &moved, &err), -1);
    assert_non_null(strstr(err.text, "scene.aff: frame 5: the animation has frames 0 to 4"));
    sph_scene_free(&rest);
    sph_scene_free(&timed);
}

/* From one key to the next: ends, tension, continuity, bias by the definition's own formula. */
static void test_spline(void **unused) {
    (void)unused;
    struct sph_rng rng = {seed};
    for (int n = 0; n < 2000; n++) {
        struct sph_key k[5];
        double time = 0;
        for (int i = 0; i < 5; i++) {
            time += 0.25 + unit(&rng);
            k[i] = (struct sph_key){.time = time,
                                    .at = {unit(&rng), n % 2, -i},
                                    .tension = unit(&rng) - 0.5,
                                    .continuity = unit(&rng) - 0.5,
                                    .bias = unit(&rng) - 0.5};
        }
        for (int i = 1; i <= 3; i++)
            near_to(sph_spline_point(k, 5, k[i].time), k[i].at.x, k[i].at.y, k[i].at.z);
        near_to(sph_spline_point(k, 5, 0), k[1].at.x, k[1].at.y, k[1].at.z);
        near_to(sph_spline_point(k, 5, 99), k[3].at.x, k[3].at.y, k[3].at.z);
        /* the slope behind key 2 in the time of its piece, and the one before it */
        double h = 1e-6, before = k[2].at.x - k[1].at.x, behind = k[3].at.x - k[2].at.x;
        double t = 1 - k[2].tension, c = k[2].continuity, b = k[2].bias;
        double all = k[3].time - k[1].time, in = k[2].time - k[1].time, out = k[3].time - k[2].time;
        double leaves = t * ((1 + b) * (1 + c) * before + (1 - b) * (1 - c) * behind) * out / all;
        double comes = t * ((1 + b) * (1 - c) * before + (1 - b) * (1 + c) * behind) * in / all;
        double right = (sph_spline_point(k, 5, k[2].time + h * out).x - k[2].at.x) / h;
        double left = (k[2].at.x - sph_spline_point(k, 5, k[2].time - h * in).x) / h;
        assert_true(fabs(right - leaves) < 1e-4 && fabs(left - comes) < 1e-4);
    }
}

/* Turns of one axis at an even pace are even; keys are met whichever of two axes says them. */
static void test_turn(void **unused) {
    (void)unused;
    struct sph_key k[6];
    struct sph_turn q;
    for (int i = 0; i < 6; i++)
        k[i] = (struct sph_key){.time = i,
                                .at = {0, i % 2 ? -2 : 2, 0},
                                .degrees = (i % 2 ? -1 : 1) * (100.0 * i + 360 * (i % 3 == 1))};
    for (int i = 8; i <= 32; i++) {
        double time = i / 8.0;
        assert_int_equal(sph_spline_turn(k, 6, time, &q), 0);
        struct sph_affine a = sph_affine_of(sph_vec_of(1, 1, 1), q, sph_vec_of(0, 0, 0));
        double angle = time * 100 * M_PI / 180;
        near_to(sph_affine_point(&a, sph_vec_of(0, 0, 1)), sin(angle), 0, cos(angle));
    }
}

static void test_camera(void **unused) {
    (void)unused;
    struct sph_scene s = read_at(
        CAM MAT MESH "k camera { rot 4 0 0 1 0 90 0 0 0 1 0 1 0 90 0 0 0 2 0 1 0 90 0 0 0 3 0 1 0 "
                     "90 0 0 0 transl 4\n" KEYS4 "}\n",
        2);
    near_to(s.camera.from, 4, 0, 0);
    near_to(s.camera.at, 3, 0, 0);
    near_to(s.camera.up, 0, 1, 0);
    assert_int_equal(s.camera.width, 320);
    sph_scene_free(&s);
}

/* Corners go straight from one time to the next, and stay before the first and behind the last. */
static void test_patch(void **unused) {
    (void)unused;
    const char *text = CAM MAT "xs 1 1 1 0 0 1 0 0 0 9 { tpa 2\n1\n0 0 0 0 0 1\n1 0 0 0 0 1\n"
                               "0 1 0 0 0 1\n3\n0 0 8 0 0 1\n1 0 4 0 0 1\n0 1 2 0 0 1\n }";
    const double time[] = {0, 1, 1.5, 3, 7}, z[] = {0, 0, 2, 8, 8};
    for (int i = 0; i < 5; i++) {
        struct sph_scene s = read_at(text, time[i]);
        near_to(s.facets[0].v[0], 0, 0, 9 + z[i]);
        near_to(s.facets[0].v[1], 1, 0, 9 + z[i] / 2);
        near_to(s.facets[0].v[2], 0, 1, 9 + z[i] / 4);
        sph_scene_free(&s);
    }
}

static void test_mesh(void **unused) {
    (void)unused;
    struct sph_scene s = read_at(
        CAM MAT "am 2.5 1 0.25\nm vertices 4 0 0 0 1 0 0 0 1 0 1 1 0 normals 1 0 0 1\n"
                "texturecoords 2 a.ppm 0 0 0.5 2 triangles 2 0 1 2 0 0 0 0 1 0 3 2 1 0 0 0 1 1 1\n"
                "ttp a.ppm 0 0 0 0 0 1 0.5 2 1 0 0 0 0 1 0 0 0 1 0 0 0 1 0 0\n",
        0);
    assert_int_equal(s.n_facets, 3);
    assert_int_equal(s.n_textures, 1);
    near_to(s.facets[1].v[0], 1, 1, 0);
    assert_true(s.facets[0].st[1][0] == 0.5 && s.facets[0].st[1][1] == 2);
    assert_true(s.facets[0].st[0][1] == 0 && s.facets[2].st[0][1] == 2);
    assert_int_equal(s.facets[2].texture, 1);
    assert_true(s.ambient[0] == 1 && s.ambient[2] == 0.25);
    assert_true(s.facets[0].smooth && s.facets[0].n[1].z == 1 && s.facets[2].smooth);
    assert_false(s.materials[0].passes);                     /* it transmits nothing */
    assert_null(strstr(s.textures[0].path, "TextureFiles")); /* there is none */
    sph_scene_free(&s);
}

/* Shadow rays pass whatever transmits. */
static void test_clear(void **unused) {
    (void)unused;
    struct sph_scene s = read_at(CAM "f 1 1 1 1 0 0 0.2 1\ns 0 0 0 1\nfm 0 0 0 1 1 1 0 0 0 1 0 1\n"
                                     "s 0 0 0 2\n",
                                 0);
    assert_true(s.materials[s.spheres[0].material].passes);
    assert_false(s.materials[s.spheres[1].material].passes);
    round_trip_nff(&s);
    sph_scene_free(&s);
}

/* A normal turns with the surface, not with its points. */
static void test_scaled_normal(void **unused) {
    (void)unused;
    struct sph_scene s =
        read_at(CAM MAT "xs 2 1 1 0 0 1 0 5 0 0 { pp 3 0 0 0 1 1 0 0 1 0 1 1 0 0 0 1 1 1 0 }\n", 0);
    assert_true(s.facets[0].smooth);
    near_to(s.facets[0].v[0], 5, 0, 0);
    near_to(s.facets[0].n[0], 1, 2, 0);
    sph_scene_free(&s);
}

static void put_part(const char *text) {
    char keep[sizeof file_name];
    memcpy(keep, file_name, sizeof keep);
    memcpy(file_name, part_name, sizeof keep);
    put_file(text, strlen(text));
    memcpy(file_name, keep, sizeof keep);
}

/* Levels of detail; the same keys twice; lines of the scene file for what is built of a part. */
static void test_include(void **unused) {
    (void)unused;
    struct sph_error err = {""};
    put_part(MAT MESH "k a { visibility 1 0 1 }");
    struct sph_scene s = read_at(CAM "i 0 part.aff\ni 1 part.aff\nd 1\n\ni 1 part.aff\n" MESH, 0);
    assert_int_equal(s.n_facets, 3);
    assert_int_equal(s.facets[0].line, 8);
    assert_int_equal(s.facets[1].line, 12);
    assert_int_equal(s.facets[2].line, 13);
    sph_scene_free(&s);
    const struct {
        const char *part, *says;
    } wrong[] = {{"\n\nturn 1", "part.aff:3: unknown word `turn`"},
                 {"}\n", "part.aff:1: } without {"},
                 {"\ni 0 part.aff", "part.aff:2: `i`: "},
                 {"i 0 scene.aff", "scene.aff includes itself"}};
    for (int i = 0; i < 4; i++) {
        put_part(wrong[i].part);
        put_bad(&(struct bad){.text = CAM "xs 1 1 1 0 0 1 0 0 0 0 { i 0 part.aff }\n"});
        err.text[0] = 0;
        assert_int_equal(sph_scene_read(file_name, NULL, &s, &err), -1);
        if (!strstr(err.text, wrong[i].says)) fail_msg("'%s' lacks %s", err.text, wrong[i].says);
    }
}

static int told, told_last;

static int tell(void *user, int done, int all) {
    (void)user;
    assert_true(done >= told_last && done <= all);
    told += done > told_last;
    told_last = done;
    return 0;
}

/* Three times a part of 40 kB, spheres and comments, within a file of 90 kB. */
static void test_progress(void **unused) {
    struct sph_progress progress = {tell, NULL, 0, 1};
    struct sph_read_options options = {.progress = &progress};
    struct sph_error err = {{0}};
    struct sph_scene s;
    char *text = malloc(100000);
    (void)unused;
    assert_non_null(text);
    snprintf(text, 100000,
             "%45000s\n" CAM MAT "i 0 part.aff\n%45000s\ns 7 7 7 1\n"
             "i 0 part.aff\ni 0 part.aff\n",
             "", "");
    put_file(text, strlen(text));
    memset(text, '#', 40000);
    text[40000] = 0;
    put_part(text);
    free(text);
    if (sph_scene_read(file_name, &options, &s, &err)) fail_msg("%s", err.text);
    sph_scene_free(&s);
    if (told < 5 || told_last < SPH_PROGRESS_ALL * 8 / 10) fail_msg("%d, %d", told, told_last);
}

static void test_skip(void **unused) {
    (void)unused;
    const struct sph_read_options skip = {.skip_unsupported = 1};
    struct sph_error err = {""};
    struct sph_scene s;
    const char *text = CAM MAT "pb\n1 2 3\nxs 1 2 1 0 0 1 0 0 0 0 { s 0 0 0 1 }\n" MESH;
    put_file(text, strlen(text));
    if (sph_scene_read(file_name, &skip, &s, &err)) fail_msg("%s", err.text);
    assert_int_equal(sph_ledger_left_out(&s.ledger), 2);
    assert_int_equal(s.n_facets, 1);
    assert_int_equal(s.n_spheres, 0);
    sph_scene_free(&s);
}

/* Words left out, doubled, exchanged and bytes changed: a scene or a message with the file. */
static void test_mutants(void **unused) {
    (void)unused;
    static const char good[] = MOVING "i 0 part.aff\nxs 1 2 3 0 0 1 30 1 1 1 { tpa 1 0 0 0 0 0 0 1 "
                                      "1 0 0 0 0 1 0 1 0 0 0 1\ntt none 0 0 0 0 0 1 0 0 1 0 0 1 0 "
                                      "0 1 }\nam 1 1 1\nk camera { rot 4 0 1 0 0 9 0 0 0 1 0 1 0 9 "
                                      "0 0 0 2 0 0 1 9 0 0 0 3 1 0 0 5 0 0 0 }\n";
    static const char bytes[] = "0 {}-\n.9xkmae#%\"";
    struct sph_rng rng = {seed};
    int read = 0;
    put_part(MAT MESH);
    struct sph_scene whole = read_at(good, 1);
    sph_scene_free(&whole);
    for (int n = 0; n < MUTANTS; n++) {
        char text[2 * sizeof good];
        size_t length = sizeof good - 1;
        struct sph_error err = {""};
        struct sph_scene s;
        memcpy(text, good, sizeof good);
        for (int i = 0; i < 1 + n % 3; i++) {
            size_t at = below(&rng, length), run = 1 + below(&rng, 12);
            if (at + run > length) run = length - at;
            switch (below(&rng, 3)) {
            case 0:
                text[at] = bytes[below(&rng, sizeof bytes - 1)];
                break;
            case 1:
                memmove(text + at, text + at + run, length - at - run);
                length -= run;
                break;
            default:
                memmove(text + at + run, text + at, length - at);
                length += run;
            }
        }
        put_file(text, length);
        if (!sph_scene_read(file_name, NULL, &s, &err)) {
            read++;
            sph_scene_free(&s);
        } else if (!strstr(err.text, ".aff")) {
            fail_msg("mutant %d: no file in '%s'", n, err.text);
        }
    }
    if (read < MUTANTS / 100 || read == MUTANTS) fail_msg("%d of %d were read", read, MUTANTS);
}

static int start(void **state) {
    if (make_folder(state)) return -1;
    snprintf(file_name, sizeof file_name, "%.60s/scene.aff", folder);
    snprintf(nff_name, sizeof nff_name, "%.60s/scene.nff", folder);
    snprintf(part_name, sizeof part_name, "%.60s/part.aff", folder);
    return 0;
}

static int end(void **state) {
    unlink(part_name);
    unlink(nff_name);
    return remove_folder(state);
}

int main(int argc, char **argv) {
    enum { N_BADS = sizeof bads / sizeof *bads, N_TESTS = 15 };
    struct CMUnitTest tests[N_TESTS + N_BADS] = {
        cmocka_unit_test(test_transforms),    cmocka_unit_test(test_still),
        cmocka_unit_test(test_keys),          cmocka_unit_test(test_frames),
        cmocka_unit_test(test_spline),        cmocka_unit_test(test_turn),
        cmocka_unit_test(test_camera),        cmocka_unit_test(test_patch),
        cmocka_unit_test(test_mesh),          cmocka_unit_test(test_clear),
        cmocka_unit_test(test_scaled_normal), cmocka_unit_test(test_include),
        cmocka_unit_test(test_skip),          cmocka_unit_test(test_mutants),
        cmocka_unit_test(test_progress)};
    for (int i = 0; i < N_BADS; i++)
        tests[N_TESTS + i] = (struct CMUnitTest){
            .name = bads[i].name, .test_func = test_bad, .initial_state = (void *)&bads[i]};
    if (argc > 1) seed = test_number(argv[1], "seed", 1);
    printf("# repeat with: %s %llu\n", argv[0], (unsigned long long)seed);
    return cmocka_run_group_tests_name("AFF", tests, start, end);
}
