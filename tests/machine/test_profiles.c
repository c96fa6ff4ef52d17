/* test_profiles.c - profiles of any widths: how they are written, what is refused, their frames
 * SPDX-License-Identifier: Apache-2.0
 *
 * Run from the root of the repository: reads scenes/.
 */
#include "model_scene.h"

#include "math/arith.h"
#include "scene/rng.h"
#include "prim/sphere.h"
#include "validate/validate.h"

/* Widths w wd pr pq ng fw of a text, and the name they are known by. */
static void texts(void **state) {
    static const struct {
        const char *text, *name;
        int widths[6];
    } list[] = {
        {"draft", "draft", {12, 13, 0, 13, 2, 12}},
        {"standard", "standard", {16, 17, 0, 17, 2, 14}},
        {"standard:pq=12,ng=0", "standard:pq=12,ng=0", {16, 17, 0, 12, 0, 14}},
        {"standard:ng=0,pq=12", "standard:pq=12,ng=0", {16, 17, 0, 12, 0, 14}},
        {"standard:pq=17", "standard", {16, 17, 0, 17, 2, 14}},
        {"standard:pr=33", "standard", {16, 17, 0, 17, 2, 14}}, /* all of them */
        {"standard:pr=32", "standard:pr=32", {16, 17, 32, 17, 2, 14}},
        {"standard:pr=0", "standard", {16, 17, 0, 17, 2, 14}},
        {"fine:w=16,wd=17", "standard:pq=24", {16, 17, 0, 24, 2, 14}}, /* nearest name */
        {"draft:w=16,wd=17,pq=17,fw=14", "standard", {16, 17, 0, 17, 2, 14}},
        {"fine:wd=31,pq=31,ng=4,fw=6,pr=50",
         "fine:wd=31,pq=31,ng=4,fw=6,pr=50",
         {20, 31, 50, 31, 4, 6}},
        {"reference:wd=27,pr=50", "reference:wd=27,pr=50", {24, 27, 50, 28, 2, 14}},
        {"draft:w=8,wd=9,fw=6,pq=8,pr=4", "draft:w=8,wd=9,pq=8,fw=6,pr=4", {8, 9, 4, 8, 2, 6}},
    };
    (void)state;
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        struct sph_profile p;
        struct sph_error err = {{0}};
        if (sph_profile_parse(list[i].text, &p, &err)) fail_msg("%s", err.text);
        const int is[6] = {p.w, p.wd, p.pr, p.pq, p.ng, p.fw};
        assert_memory_equal(is, list[i].widths, sizeof is);
        assert_string_equal(p.name, list[i].name);
        struct sph_profile again = sph_profile_unpack(sph_profile_pack(&p));
        assert_memory_equal(&again, &p, sizeof p);
        assert_int_equal(sph_profile_parse(p.name, &again, &err), 0); /* its name says it all */
        assert_int_equal(sph_profile_pack(&again), sph_profile_pack(&p));
    }
    for (int i = 0; i < SPH_PROFILES; i++) {
        struct sph_profile p = sph_profile_unpack(sph_profile_pack(&sph_profiles[i]));
        assert_string_equal(p.name, sph_profiles[i].name);
        assert_int_equal(sph_min_screen(&p), SPH_MIN_SCREEN);
    }
}

static void refused(void **state) {
    static const struct {
        const char *text, *why;
    } list[] = {
        {"", "'' is none of draft"},
        {"huge", "'huge' is none of draft"},
        {"standardstandardstandard", "is none of draft"},
        {"Standard", "is none of draft"},
        {"standard:", "'' is none of w, wd, pr"},
        {"standard:pq=12,", "'' is none of w, wd, pr"},
        {"standard:,pq=12", "'' is none of w, wd, pr"},
        {"standard,pq=12", "is none of draft"},
        {"standard:p=12", "'p' is none of w, wd, pr"},
        {"standard:pq", "pq has no number"},
        {"standard:pq=", "pq has no number"},
        {"standard:pq=x", "pq has no number"},
        {"standard:pq=-1", "pq has no number"},
        {"standard:pq=12.5", "pq has no number"},
        {"standard:pq=12:ng=0", "pq has no number"},
        {"standard:pq=12,pq=13", "pq is given twice"},
        {"standard:w=25,wd=27", "w is 25, not in 8..24: a leaf record has 24 bits"},
        {"standard:w=7", "w is 7, not in 8..24"},
        {"standard:wd=32", "wd is 32, not in 9..31: a register has 32 bits"},
        {"standard:wd=16", "light - point needs w + 1 bits"},
        {"fine:w=22", "light - point needs w + 1 bits"},
        {"standard:pq=33", "pq is 33, not in 4..32: a quotient is one word"},
        {"fine:wd=31,pq=32", "t * dir has at most 62 bits"},
        {"reference:wd=28", "num * a of a triangle has 3w + 2wd + 1 bits"},
        {"standard:pq=5", "points of mirror rays need w + ng + 5 - wd = 6 bits"},
        {"standard:ng=5", "ng is 5, not in 0..4: the bounds of build"},
        {"standard:fw=15", "fw is 15, not in 6..14: a node record has 14 bits"},
        {"draft:fw=13", "the filter sees the top fw of w bits"},
        {"standard:fw=5", "fw is 5, not in 6..14"},
        {"standard:pr=3", "pr is 3, neither 0 (all) nor in 4..32"},
        {"standard:pr=34", "pr is 34, neither 0 (all) nor in 4..32"},
        {"standard:pr=55", "pr is 55, not in 0..51: the longest root"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        struct sph_profile p;
        struct sph_error err = {{0}};
        if (sph_profile_parse(list[i].text, &p, &err) != -1) fail_msg("%s is taken", list[i].text);
        if (!strstr(err.text, list[i].why)) fail_msg("%s: %s", list[i].text, err.text);
    }
    struct sph_scene scene = model_scene("paper5");
    struct sph_profile p = sph_profiles[SPH_STANDARD];
    struct sph_machine m;
    struct sph_build_report report;
    struct sph_error err = {{0}}, err2 = {{0}};
    struct sph_build_options o = {.widths = &p, .tree = SPH_TREE_BALANCED, .width = 8, .height = 6};
    p.pq = 6, scene.camera.angle = 160; /* a screen too near for so short a quotient */
    assert_int_equal(sph_build(&scene, &o, &m, &report, &err), -1);
    if (!strstr(err.text, "6 bits of the quotient need 32768")) fail_msg("%s", err.text);
    p.pq = 5;
    assert_int_equal(sph_build(&scene, &o, &m, &report, &err2), -1);
    if (!strstr(err2.text, "w + ng + 5 - wd")) fail_msg("%s", err2.text);
    sph_scene_free(&scene);
}

/* One knob turned at a time, both ways where there are two, and all of them. */
static const char *const turned[] = {
    "standard:w=14",
    "standard:wd=21",
    "standard:pq=10",
    "standard:pq=24",
    "standard:ng=0",
    "standard:ng=4",
    "standard:fw=9",
    "standard:pr=14",
    "standard:pr=6",
    "draft:w=8,wd=9,pq=8,fw=6,pr=4",
    "reference:wd=27,pq=31,ng=4,pr=40",
};
enum { TURNED = sizeof turned / sizeof *turned };

/* 1 if the named profile that a machine's own starts with gives another frame or other work. */
static int knob_matters(const struct sph_scene *scene, struct sph_build_options o,
                        const struct sph_frame *golden, const struct sph_counters *c) {
    char name[64];
    struct sph_machine m;
    struct sph_counters named;
    struct sph_build_report report;
    int errors;
    snprintf(name, sizeof name, "%.*s", (int)strcspn(o.widths->name, ":"), o.widths->name);
    o.widths = NULL, o.profile = sph_profile_find(name);
    if (sph_build(scene, &o, &m, &report, NULL)) return 1;
    struct sph_frame f = model_render(&m, SPH_TRAVERSE_TREE, 0, &named, &errors);
    size_t bytes = (size_t)(f.width * f.height) * sizeof *f.pixels;
    int other = memcmp(f.pixels, golden->pixels, bytes) || memcmp(&named, c, sizeof named);
    sph_frame_free(&f);
    sph_machine_free(&m);
    return other;
}

/* Golden, brute and naive frames are the same; every knob changes the picture or the work. */
static void frames(void **state) {
    static const char *const scenes[] = {"interpenetrating", "inside", "materials"};
#ifdef __SANITIZE_ADDRESS__
    enum { NW = 6, NH = 4, ENOUGH = 0 }; /* too few pixels to show every knob */
#else
    enum { NW = 16, NH = 12, ENOUGH = 1 };
#endif
    (void)state;
    int wrong = 0, done = 0, matters[TURNED] = {0};
    for (int n = 0; n < 3; n++) {
        struct sph_scene scene = model_scene(scenes[n]);
        for (int k = 0; k < TURNED; k++) {
            struct sph_profile p;
            struct sph_machine m;
            struct sph_counters c;
            struct sph_build_report report;
            struct sph_error err = {{0}};
            int errors;
            if (sph_profile_parse(turned[k], &p, &err)) fail_msg("%s", err.text);
            struct sph_build_options o = {.widths = &p,
                                          .tree = SPH_TREE_BALANCED,
                                          .background = (n + k) % 4,
                                          .width = NW,
                                          .height = NH,
                                          .bg_border = 1,
                                          .max_depth = 2,
                                          .shadow = SPH_ON,
                                          .reflect = SPH_ON,
                                          .lights = SPH_AUTO,
                                          .inside = SPH_AUTO};
            if (sph_build(&scene, &o, &m, &report, &err)) {
                printf("# left out: %s\n", err.text);
                continue;
            }
            if (sph_machine_validate(&m, &err)) fail_msg("%s", err.text);
            struct sph_frame golden = model_render(&m, SPH_TRAVERSE_TREE, 0, &c, &errors);
            assert_int_equal(errors, 0);
            matters[k] += knob_matters(&scene, o, &golden, &c);
            struct sph_frame brute = model_render(&m, SPH_TRAVERSE_BRUTE, 0, &c, &errors);
            struct sph_frame naive = model_naive(&m);
            wrong += model_differ("naive", &m, &golden, &naive);
            wrong += model_differ("brute", &m, &golden, &brute);
            done++;
            sph_frame_free(&golden);
            sph_frame_free(&brute);
            sph_frame_free(&naive);
            sph_machine_free(&m);
        }
        sph_scene_free(&scene);
    }
    printf("# %d frames of %dx%d\n", done, NW, NH);
    assert_int_equal(wrong, 0);
    assert_true(done >= 3 * TURNED - 3);
    for (int k = 0; k < TURNED; k++)
        if (ENOUGH && !matters[k]) fail_msg("%s changes nothing", turned[k]);
}

/* Keys of cut roots: the naive search agrees, far keys end at 1, and hits stay what they are. */
static void cut_keys(void **state) {
    (void)state;
    struct sph_rng rng = {.state = 7};
    long hits = 0, shorter = 0, ends = 0;
    for (int run = 0; run < 20000; run++) {
        struct sph_ray ray = {.kind = SPH_REFLECTED, .skip = {SPH_ID_NONE, 0}, .inside = 1};
        struct sph_leaf leaf = {.rad = 1 + (int64_t)(sph_rng_next(&rng) % 4000), .id = 3};
        ray.a = 0;
        for (int i = 0; i < 3; i++) {
            ray.org[i] = (int64_t)(sph_rng_next(&rng) % 4096) - 2048;
            leaf.ctr[i] = (int64_t)(sph_rng_next(&rng) % 4096) - 2048;
            ray.dir[i] = (int64_t)(sph_rng_next(&rng) % 8192) - 4096;
            ray.a += (uint64_t)(ray.dir[i] * ray.dir[i]);
        }
        struct sph_leaf_result r = sph_leaf_test(&ray, &leaf);
        if (!r.hit) continue;
        uint64_t roots = 0, whole = sph_leaf_key(&r, &roots);
        int inexact, length = sph_bit_length(sph_isqrt((sph_u128)r.disc, &inexact));
        hits++;
        for (int pr = 4; pr <= 24; pr += 5) {
            uint64_t key = sph_leaf_key_bits(&r, pr, &roots);
            struct sph_naive_leaf n = sph_naive_leaf_bits(&ray, &leaf, pr);
            assert_true(n.hit && n.key == key && key >= 1);
            if (length <= pr) assert_int_equal(key, whole);
            assert_true(r.far ? key <= whole : key >= whole);
            shorter += key != whole;
            ends += key == 1 && whole > 1;
        }
    }
    printf("# %ld hits, %ld keys changed, %ld far ones ended at 1\n", hits, shorter, ends);
    assert_true(hits > 5000 && shorter > hits && ends > 10);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(texts),
        cmocka_unit_test(refused),
        cmocka_unit_test(frames),
        cmocka_unit_test(cut_keys),
    };
    return cmocka_run_group_tests_name("profiles", tests, NULL, NULL);
}
