/* test_scene_bad.c - bad scene files: each gives a message with file, line and reason
 * SPDX-License-Identifier: Apache-2.0
 */
#include "scene_files.h"

#include "scene/rng.h"

#define VIEW(from, at, up, angle, size)                                                            \
    "v from " from "\nat " at "\nup " up "\nangle " angle "\nhither 1\nresolution " size "\n"
static const struct bad bads[] = {
    {"empty", "", 0, "empty", 0, 0},
    {"only_comments", "# nothing\n\n", 0, "empty", 0, 0},
    {"no_camera", MAT "s 0 0 0 1\n", 0, "no camera", 0, 0},
    {"truncated_sphere", CAM MAT "s 0 0", 9, "ends within `s`", 0, 0},
    {"truncated_material", CAM "f 1 0 0 .5", 8, "ends within `f`", 0, 0},
    {"truncated_view", "v\nfrom 0 0", 2, "ends within `from`", 0, 0},
    {"truncated_light_colour", CAM "l 1 2 3 1 1", 8, "ends within `l`", 0, 0},
    {"view_without_angle", "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nresolution 9 9\n", 1, "`angle`", 0,
     0},
    {"view_field_twice", "v\nfrom 0 0 5\nfrom 0 0 5\n", 3, "twice", 0, 0},
    {"sphere_short", CAM MAT "s 0 0 1\ns 1 1 1 1\n", 10, "`s`: radius", 0, 0},
    {"nan", CAM MAT "s 0 nan 0 1\n", 9, "not a decimal number", 0, 0},
    {"infinity", CAM MAT "s 0 0 0 inf\n", 9, "not a decimal number", 0, 0},
    {"overflow", CAM MAT "s 0 0 0 1e999\n", 9, "too large", 0, 0},
    {"too_large", CAM MAT "s 0 0 -1e31 1\n", 9, "too large", 0, 0},
    {"hexadecimal", CAM MAT "s 0x10 0 0 1\n", 9, "not a decimal number", 0, 0},
    {"not_numeric", CAM MAT "s a b c d\n", 9, "`a` is not a decimal number", 0, 0},
    {"number_with_tail", CAM MAT "s 1.5mm 0 0 1\n", 9, "`1.5mm`", 0, 0},
    {"decimal_comma", CAM MAT "s 1,5 0 0 1\n", 9, "`1,5`", 0, 0},
    {"radius_zero", CAM MAT "s 0 0 0 0\n", 9, "`s`: radius is 0", 0, 0},
    {"radius_underflow", CAM MAT "s 0 0 0 1e-999\n", 9, "`s`: radius is 0", 0, 0},
    {"radius_minus_zero", CAM MAT "s 0 0 0 -0\n", 9, "`s`: radius is 0", 0, 0},
    {"radius_both_signs", CAM MAT "s 0 0 0 1\ns 0 0 0 -1\n", 10, "sphere that stands there twice",
     STRICT, 0},
    {"eye_is_target", VIEW("1 2 3", "1 2 3", "0 1 0", "30", "9 9"), 1, "same point", 0, 0},
    {"up_parallel", VIEW("0 0 5", "0 0 0", "0 0 -2", "30", "9 9"), 1, "parallel", 0, 0},
    {"up_zero", VIEW("0 0 5", "0 0 0", "0 0 0", "30", "9 9"), 1, "`up` is zero", 0, 0},
    {"angle_zero", VIEW("0 0 5", "0 0 0", "0 1 0", "0", "9 9"), 1, "between 0 and 180", 0, 0},
    {"angle_180", VIEW("0 0 5", "0 0 0", "0 1 0", "180", "9 9"), 1, "between 0 and 180", 0, 0},
    {"angle_negative", VIEW("0 0 5", "0 0 0", "0 1 0", "-5", "9 9"), 1, "between 0 and", 0, 0},
    {"size_zero", VIEW("0 0 5", "0 0 0", "0 1 0", "30", "9 0"), 6, "height 0", 0, 0},
    {"size_large", VIEW("0 0 5", "0 0 0", "0 1 0", "30", "16384 9"), 6, "width 16384", 0, 0},
    {"size_fraction", VIEW("0 0 5", "0 0 0", "0 1 0", "30", "9.5 9"), 6, "whole number", 0, 0},
    {"sphere_before_material", CAM "s 0 0 0 1\n", 8, "no material", 0, 0},
    {"second_view", CAM CAM, 8, "second `v`; the first is in line 1", 0, 0},
    {"second_background", CAM "b 0 0 0\nb 0 0 0\n", 9, "second `b`", 0, 0},
    {"duplicate", CAM MAT "s 1 2 3 4\ns 0 0 0 1\ns 1 2 3.0 4e0\n", 11, "that of line 9", STRICT, 0},
    {"duplicate_zeros", CAM MAT "s 0 0 0 1\n" MAT "s 0 -0 0 1\n", 11, "that of line 9", STRICT, 0},
    {"nine_lights", CAM LIGHT LIGHT LIGHT LIGHT LIGHT LIGHT LIGHT LIGHT LIGHT, 16, "more than 8", 0,
     0},
    {"nul_byte", CAM MAT "s 0 0\0 0 1\n", 9, "byte 0x00", 0, sizeof CAM MAT "s 0 0\0 0 1\n" - 1},
    {"nul_in_comment", CAM "#\0\n", 8, "byte 0x00", 0, sizeof CAM "#\0\n" - 1},
    {"control_character", CAM "\033[1m", 8, "byte 0x1b", 0, 0},
    {"high_bytes", CAM "\xff\xfe\n", 8, "unknown word `\?\?`", 0, 0},
    {"long_word", CAM "xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx", 8,
     "a word of more", 0, 0},
    {"background_above_1", CAM "b 0 1.5 0\n", 8, "green 1.5 is not within", 0, 0},
    {"background_below_0", CAM "b 0 0 -.1\n", 8, "blue -0.1 is not within", 0, 0},
    {"ambient_above_1", CAM "ambient 2 0 0\n", 8, "red 2 is not within", 0, 0},
    {"material_above_1", CAM "f 255 0 0 .5 .5 10 0 1\n", 8, "red 255 is not within", 0, 0},
    {"ks_above_1", CAM "f 1 0 0 .5 5 10 0 1\n", 8, "Ks 5 is not within", 0, 0},
    {"transmittance_below_0", CAM "f 1 0 0 .5 .5 10 -1 1\n", 8, "T -1 is not within", 0, 0},
    {"shine_negative", CAM "f 1 0 0 .5 .5 -1 0 1\n", 8, "Shine", 0, 0},
    {"light_negative", CAM "l 0 0 0 1 -1 1\n", 8, "green -1 is negative", 0, 0},
    {"garbage", CAM "hello\n", 8, "unknown word `hello`", 0, 0},
    {"garbage_with_skip", CAM "hello\n", 8, "unknown word `hello`", SKIP, 0},
    {"number_alone", CAM "42\n", 8, "unknown word `42`: a number where a record should", SKIP, 0},
    {"image_behind_f", CAM "f 1 0 0 1 0 0 0 1 brick.PPM\n", 8, "`texture brick.PPM su sv`", 0, 0},
    {"quadric", CAM MAT "Q 1 2 3\n", 9, "unknown word `Q`: no record of NFF or AFF", 0, 0},
    {"sense8", "nff\nversion 2.0\n", 1, "Neutral File Format of Sense8", 0, 0},
    {"mtl", "# a\nnewmtl x\nKd 1 1 1\n", 0, "give the .obj file, no scene", 0, 0},
    {"fbx", "Kaydara FBX Binary  ", 0, "is an FBX scene: export it as glTF", 0, 0},
    {"off", "OFF\n3 1 0\n", 0, "is an OFF mesh: convert it to PLY", 0, 0},
    {"collada", "<?xml version=\"1.0\"?>\n<COLLADA>\n", 0, "is a COLLADA scene", 0, 0},
    {"png", "\x89PNG\r\n\x1a\n", 0, "is a PNG image, no scene", 0, 0},
    {"zeros", "\0\0", 1, "byte 0x00", 0, 2},
    {"patch", CAM "tpp x\n", 8, "`tpp` (textured triangle with normals) is not", 0, 0},
    {"patch_part", CAM MAT "pb 3 1 2\n", 9, "`pb` (Bezier patch) is not", 0, 0},
};

static void test_bad(void **state) {
    const struct bad *bad = *state;
    struct sph_error err = {""};
    struct sph_scene scene;
    const struct sph_read_options options = bad_options(bad);
    put_bad(bad);
    assert_int_equal(sph_scene_read(file_name, &options, &scene, &err), -1);
    assert_message(bad, &err);
    assert_null(scene.spheres);
    assert_null(scene.materials);
}

static void test_missing_and_folder(void **state) {
    (void)state;
    struct sph_error err = {""}, err2 = {""};
    struct sph_scene scene;
    assert_int_equal(sph_scene_read("/nowhere/x.nff", NULL, &scene, &err), -1);
    assert_string_equal(err.text, "/nowhere/x.nff: cannot open: No such file or directory");
    assert_int_equal(sph_scene_read(folder, NULL, &scene, &err2), -1);
    assert_non_null(strstr(err2.text, "is a folder"));
}

static void test_too_many_spheres(void **state) {
    (void)state;
    struct sph_error err = {""};
    struct sph_scene full = {.path = "x.nff", .n_spheres = SPH_MAX_SPHERES};
    assert_int_equal(sph_scene_add_sphere(&full, sph_vec_of(0, 0, 0), 1, 0, 7, &err), -1);
    assert_string_equal(err.text, "x.nff:7: more than 16000000 spheres");
}

/* Every beginning of a good file, and good files with random damage: success or a message. */
static void test_damaged(void **state) {
    (void)state;
    const char good[] = CAM "b .1 .2 .3\n" LIGHT "l 1 1 1 1 1 1 # x\n" MAT
                            "s 0 0 0 1\np 3\n0 0 0\n1 0 0\n0 1 0\nc 0 0 0 1 0 0 1 1\ns 1 1 1 1\n";
    const size_t n = sizeof good - 1;
    struct sph_read_options skip = {.skip_unsupported = 1};
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
        int bad = sph_scene_read(file_name, &skip, &scene, &err);
        assert_int_equal(bad, err.text[0] ? -1 : 0);
        n_read += !bad;
        if (!bad) sph_scene_free(&scene);
    }
    assert_in_range(n_read, 20, n + 1999);
}

int main(void) {
    const struct CMUnitTest others[] = {cmocka_unit_test(test_missing_and_folder),
                                        cmocka_unit_test(test_too_many_spheres),
                                        cmocka_unit_test(test_damaged)};
    return run_cases("scene_bad", test_bad, bads, sizeof bads / sizeof bads[0], others,
                     sizeof others / sizeof others[0]);
}
