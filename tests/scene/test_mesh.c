/* test_mesh.c - meshes: what their records become, and what is said of wrong ones
 * SPDX-License-Identifier: Apache-2.0
 */
#include "scene_files.h"

#include <math.h>
#include <stdio.h>

#include "common/module.h"
#include "machine/layout.h"
#include "scene/vector.h"

#define TRIANGLE "v 0 0 0\nv 1 0 0\nv 0 1 0\n"
#define HEAD(rest) "ply\nformat ascii 1.0\n" rest
#define XYZ "property float x\nproperty float y\nproperty float z\n"
#define FACE "element face 1\nproperty list uchar int vertex_indices\n"
#define GLTF(rest) "{\"asset\":{\"version\":\"2.0\"}" rest "}"

static char ending[8]; /* of the file that is written */

static void name_file(const char *name) {
    snprintf(file_name, sizeof file_name, "%s/%s", folder, name);
    snprintf(ending, sizeof ending, "%s", strrchr(name, '.'));
}

/* The kind stands in the name of a case: "obj index". */
static const struct bad bads[] = {
    {"obj word", "v 0 0 x\n", 1, "`v`: z: `x` is not a number", 0, 0},
    {"obj short", TRIANGLE "v 1 2\n", 4, "`v`: z is missing", 0, 0},
    {"obj nan", "v 0 nan 0\n", 1, "`nan` is not a number", 0, 0},
    {"obj inf", "v 0 1e999 0\n", 1, "too large", 0, 0},
    {"obj index", TRIANGLE "f 1 2 4\n", 4, "vertex 4, but the file has 3", 0, 0},
    {"obj huge", TRIANGLE "f 1 2 99999999999\n", 4, "vertex 99999999999, but the file has 3", 0, 0},
    {"obj beyond", TRIANGLE "f 1 2 99999999999999999999\n", 4, "is no number of a vertex", 0, 0},
    {"obj back", TRIANGLE "f -1 -2 -4\n", 4, "vertex -4, but there are 3 before it", 0, 0},
    {"obj zero", TRIANGLE "f 0 1 2\n", 4, "is no number of a vertex", 0, 0},
    {"obj normal", TRIANGLE "f 1//1 2//1 3//1\n", 4, "normal 1, but the file has 0", 0, 0},
    {"obj corner", TRIANGLE "f 1/ 2/x 3/\n", 4, "is no number of a texture coordinate", 0, 0},
    {"obj none", TRIANGLE "f\n", 4, "`f`: no corners", 0, 0},
    {"obj library", "mtllib none.mtl\n" TRIANGLE "f 1 2 3\n", 1, "none.mtl cannot be read", 0, 0},
    {"obj bytes", "mtllib \xff\xfe.mtl\n" TRIANGLE "f 1 2 3\n", 1, "cannot be read", 0, 0},
    {"obj empty", "o x\n", 0, "", 0, 0},
    {"obj five", "v 0 0 0 1 1\n", 1, "6th number is missing", 0, 0},
    {"obj strict", TRIANGLE "f 1 2 3\nl 1 2\n", 5, "left out: line or point", STRICT, 0},
    {"ply cut", "ply\nformat ascii 1.0\n", 2, "the file ends before end_header", 0, 0},
    {"ply format", "ply\nformat text 1.0\n", 2, "none of ascii", 0, 0},
    {"ply none", "ply\nelement vertex 1\n" XYZ "end_header\n0 0 0\n", 6, "`format`: is missing", 0,
     0},
    {"ply word", HEAD("elephant\n"), 3, "unknown word in the head", 0, 0},
    {"ply first", HEAD("property float x\n"), 3, "no element before it", 0, 0},
    {"ply count", HEAD("element vertex -1\n"), 3, "the number of elements is none", 0, 0},
    {"ply type", HEAD("element vertex 1\nproperty real x\n"), 4, "unknown type", 0, 0},
    {"ply rows", HEAD("element vertex 4000000000\n" XYZ "end_header\n0 0 0\n"), 8,
     "ends after 1 of 4000000000 vertex", 0, 0},
    {"ply nan", HEAD("element vertex 1\n" XYZ "end_header\n0 nan 0\n"), 8, "`nan` is not", 0, 0},
    {"ply more", HEAD("element vertex 1\n" XYZ "end_header\n0 0 0 0\n"), 8, "more numbers", 0, 0},
    {"ply index", HEAD("element vertex 1\n" XYZ FACE "end_header\n0 0 0\n3 0 0 1\n"), 11,
     "vertex 1 is none of 0 to 0", 0, 0},
    {"ply xyz", HEAD("element vertex 1\nproperty float x\nend_header\n0\n"), 0, "with x, y, z", 0,
     0},
    {"ply binary", "ply\nformat binary_little_endian 1.0\nelement vertex 9\n" XYZ "end_header\n123",
     0, "the file ends within vertex 0 of 9", 0, 0},
    {"stl word", "solid x\nfacet normal 0 0 1\nvertex 0 0 0\n", 3, "where `outer loop` should", 0,
     0},
    {"stl cut", "solid x\nfacet normal 0 0 1\nouter loop\n", 3, "ends within a facet", 0, 0},
    {"stl number", "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 z\n", 4, "`z` is not", 0,
     0},
    {"stl count",
     "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa\x01\0\0\0x",
     0, "ends after 0 of 1 triangles", 0, 85},
    {"gltf json", "{\"asset\":{\"version\":\"2.0\"},\n\"nodes\":[}\n", 2, "unexpected token", 0, 0},
    {"gltf version", "{\"asset\":{\"version\":\"1.0\"}}", 0, "glTF 1.0, not of version 2", 0, 0},
    {"gltf needs", GLTF(",\"extensionsRequired\":[\"KHR_draco_mesh_compression\"]"), 0,
     "needs the extension KHR_draco_mesh_compression", 0, 0},
    {"gltf bin", GLTF(",\"buffers\":[{\"uri\":\"none.bin\",\"byteLength\":4}]"), 0,
     "buffer 0: none.bin cannot be read", 0, 0},
    {"gltf image", GLTF(",\"images\":[{\"uri\":\"none.png\"}]"), 0, "none.png cannot be read", 0,
     0},
    {"gltf circle", GLTF(",\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"children\":[0]}]"), 0, "", 0,
     0},
    {"glb cut", "glTF\2\0\0\0\x64\0\0\0", 0, "the file ends early", 0, 12},
    {"glb json", "glTF\2\0\0\0\x18\0\0\0\xff\xff\xff\x7fJSON{}  ", 0, "is no JSON", 0, 24},
};

static void test_bad(void **state) {
    const struct bad *bad = *state;
    struct sph_read_options options = bad_options(bad);
    struct sph_scene scene;
    struct sph_error err = {""};
    char name[16];
    snprintf(name, sizeof name, "m.%.*s", (int)strcspn(bad->name, " "), bad->name);
    name_file(name);
    put_bad(bad);
    int rc = sph_scene_read(file_name, &options, &scene, &err);
    unlink(file_name);
    assert_int_equal(rc, -1);
    assert_message(bad, &err);
}

/* Reads a text. */
static struct sph_scene read_text(const char *name, const char *text, size_t n,
                                  const struct sph_read_options *options) {
    struct sph_scene scene;
    struct sph_error err = {""};
    name_file(name);
    put_file(text, n);
    int rc = sph_scene_read(file_name, options, &scene, &err);
    unlink(file_name);
    if (rc) fail_msg("%s", err.text);
    return scene;
}

/* Three triangles of one plane, whatever the format. */
static void assert_triangle(const struct sph_facet *f) {
    static const double right[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    for (int k = 0; k < 3; k++) {
        assert_true(f->v[k].x == right[k][0]);
        assert_true(f->v[k].y == right[k][1]);
        assert_true(f->v[k].z == right[k][2]);
    }
}

/* Numbers of a binary file, in either order of bytes. */
static size_t put_number(char *to, double value, size_t size, int big) {
    float f = (float)value;
    uint32_t word;
    memcpy(&word, &f, sizeof word);
    if (size < 4) word = (uint32_t)value;
    for (size_t i = 0; i < size; i++)
        to[i] = (char)(word >> 8 * (big ? size - 1 - i : i));
    return size;
}

static void test_formats(void **state) {
    (void)state;
    static const char stl[] = "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                              "vertex 0 1 0\nendloop\nendfacet\nendsolid\n";
    static const char ply[] =
        HEAD("element vertex 3\n" XYZ FACE "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    static const double v[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    struct sph_scene s[6];
    char bytes[400];
    s[0] = read_text("m.obj", TRIANGLE "f 1 2 3\n", strlen(TRIANGLE "f 1 2 3\n"), NULL);
    s[1] = read_text("m.stl", stl, sizeof stl - 1, NULL);
    s[2] = read_text("m.ply", ply, sizeof ply - 1, NULL);
    for (int big = 0; big < 2; big++) {
        size_t n = (size_t)snprintf(bytes, sizeof bytes,
                                    "ply\nformat binary_%s_endian 1.0\nelement vertex 3\n" XYZ
                                    "element face 1\nproperty list uchar ushort vertex_indices\n"
                                    "end_header\n",
                                    big ? "big" : "little");
        for (int i = 0; i < 9; i++)
            n += put_number(bytes + n, v[i], 4, big);
        n += put_number(bytes + n, 3, 1, big);
        for (int i = 0; i < 3; i++)
            n += put_number(bytes + n, i, 2, big);
        s[3 + big] = read_text("m.ply", bytes, n, NULL);
    }
    memset(bytes, 0, 84 + 50); /* binary STL under a name that says nothing, by its content */
    bytes[80] = 1;
    for (size_t i = 0; i < 9; i++)
        put_number(bytes + 84 + 12 + 4 * i, v[i], 4, 0);
    s[5] = read_text("m.dat", bytes, 84 + 50, NULL);
    for (int i = 0; i < 6; i++) {
        assert_int_equal(s[i].n_facets, 1);
        assert_triangle(&s[i].facets[0]);
        assert_int_equal(s[i].n_lights, 2); /* fitted, as the camera */
        assert_true(s[i].camera.angle > 0);
        assert_true(fabs(s[i].camera.up.z) > fabs(s[i].camera.up.y) ? i == 1 || i == 5
                                                                    : i != 1 && i != 5);
        sph_scene_free(&s[i]);
    }
}

/* A binary STL: what stands behind its triangles is noted, and twelve numbers are numbers, but that
 * a normal is not used. */
static void test_stl(void **state) {
    (void)state;
    static const struct {
        int more, odd; /* bytes behind a triangle; which number is none, -1: all are */
        int rc, notes;
    } rows[] = {{0, -1, 0, 0}, {1, -1, 0, 1}, {49, -1, 0, 1}, {50, -1, 0, 1},
                {0, 0, 0, 0},  {0, 2, 0, 0},  {0, 3, -1, 0},  {0, 11, -1, 0}};
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        char bytes[84 + 50 + 50] = {0};
        struct sph_read_options options = {.skip_unsupported = 1};
        struct sph_scene scene;
        struct sph_error err = {""};
        bytes[80] = 1;
        put_number(bytes + 84 + 12 + 12, 1, 4, 0);
        put_number(bytes + 84 + 12 + 28, 1, 4, 0);
        if (rows[k].odd >= 0) put_number(bytes + 84 + 4 * rows[k].odd, NAN, 4, 0);
        name_file("m.stl");
        put_file(bytes, 84 + 50 + (size_t)rows[k].more);
        int rc = sph_scene_read(file_name, &options, &scene, &err);
        unlink(file_name);
        if (rc != rows[k].rc) fail_msg("row %zu: %s", k, err.text);
        if (rc) {
            assert_non_null(strstr(err.text, "not a number"));
            continue;
        }
        assert_int_equal(scene.ledger.row[SPH_READ_UNSUPPORTED].n, rows[k].notes);
        sph_scene_free(&scene);
    }
}

/* MTL: what its numbers become. */
static void test_material(void **state) {
    (void)state;
    static const struct {
        const char *mtl;
        double rgb[3], kd, ks, kr, shine, trans, ior;
    } rows[] = {
        {"Kd .5 .25 0\n", {1, .5, 0}, .5, 0, 0, 0, 0, 1},
        {"Kd 1 1 1\nKs .5 .5 .5\nNs 20\n", {1, 1, 1}, 1, .5, 0, 20, 0, 1},
        {"Kd 0 0 0\nKs .5 .5 .5\nNs 20\nillum 3\n", {0, 0, 0}, 0, .5, .5, 20, 0, 1},
        {"Kd 1 1 1\nd .25\nNi 1.5\n", {1, 1, 1}, .25, 0, 0, 0, .75, 1.5},
        {"Kd 1 1 1\nTr .25\n", {1, 1, 1}, .75, 0, 0, 0, .25, 1},
        {"Kd 0 0 0\nTf .5 .5 .5\nillum 6\nNi 1.25\n", {0, 0, 0}, 0, 0, 0, 0, .5, 1.25},
    };
    static const char obj[] = "mtllib m.mtl\nusemtl m\n" TRIANGLE "f 1 2 3\n";
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char text[200];
        snprintf(text, sizeof text, "newmtl m\n%s", rows[i].mtl);
        name_file("m.mtl");
        put_file(text, strlen(text));
        struct sph_scene s = read_text("m.obj", obj, sizeof obj - 1, NULL);
        const struct sph_material *m = &s.materials[s.facets[0].material];
        const double got[] = {m->rgb[0], m->rgb[1], m->rgb[2], m->kd, m->ks,
                              m->sum.kr, m->shine,  m->trans,  m->ior};
        const double right[] = {rows[i].rgb[0], rows[i].rgb[1], rows[i].rgb[2],
                                rows[i].kd,     rows[i].ks,     rows[i].kr,
                                rows[i].shine,  rows[i].trans,  rows[i].ior};
        for (size_t k = 0; k < 9; k++)
            if (fabs(got[k] - right[k]) > 1e-6)
                fail_msg("row %zu, number %zu: %g, not %g", i, k, got[k], right[k]);
        sph_scene_free(&s);
    }
    name_file("m.mtl");
    unlink(file_name);
}

/* Polygons are cut, normals and texture coordinates kept, lines known. */
static void test_faces(void **state) {
    (void)state;
    static const char obj[] = "v 0 0 0\nv 2 0 0\nv .5 .5 0\nv 0 2 0\nvn 0 0 1\n"
                              "f 1//1 2//1 \\\n3//1 4//1 # .5: assimp's own reader fails\n";
    struct sph_scene s = read_text("m.obj", obj, sizeof obj - 1, NULL);
    double area = 0;
    for (uint32_t i = 0; i < s.n_facets; i++) {
        const struct sph_vec *v = s.facets[i].v;
        area += sph_vec_length(sph_vec_cross(sph_vec_sub(v[1], v[0]), sph_vec_sub(v[2], v[0]))) / 2;
        assert_true(s.facets[i].smooth && s.facets[i].n[0].z == 1);
        assert_int_equal(s.facets[i].line, 7);
    }
    assert_int_equal(s.n_facets, 2);
    assert_true(fabs(area - 1) < 1e-6); /* it is not convex */
    sph_scene_free(&s);
}

/* Points without faces are spheres, as large as --radius or as fits. */
static void test_points(void **state) {
    (void)state;
    static const char ply[] =
        HEAD("element vertex 2\n" XYZ "property uchar red\nproperty uchar green\n"
             "property uchar blue\nend_header\n0 0 0 255 0 0\n2 0 0 0 188 0\n");
    struct sph_scene s = read_text("m.ply", ply, sizeof ply - 1, NULL);
    assert_int_equal(s.n_spheres, 2);
    assert_true(fabs(s.spheres[1].rad - 1 / sqrt(2)) < 1e-9);
    const struct sph_material *m = &s.materials[s.spheres[1].material];
    assert_true(m->rgb[0] == 0 && fabs(m->rgb[1] - 0.5029) < 1e-4); /* sRGB */
    sph_scene_free(&s);
    s = read_text("m.ply", ply, sizeof ply - 1, &(struct sph_read_options){.radius = .25});
    assert_true(s.spheres[0].rad == .25);
    sph_scene_free(&s);
}

int main(void) {
    const struct CMUnitTest others[] = {
        cmocka_unit_test(test_formats), cmocka_unit_test(test_material),
        cmocka_unit_test(test_faces), cmocka_unit_test(test_points), cmocka_unit_test(test_stl)};
    char why[400];
    if (!sph_module_load("mesh", why, sizeof why)) {
        printf("ok 1 - # skip meshes: built without assimp (make mesh-setup)\n");
        return 0;
    }
    return run_cases("mesh", test_bad, bads, sizeof bads / sizeof *bads, others,
                     sizeof others / sizeof *others);
}
