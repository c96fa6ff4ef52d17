/* test_measure.c - a sample is of the frame, and its bounds hold for the frame
 * SPDX-License-Identifier: Apache-2.0
 */
#include "model_scene.h"

#include <math.h>

#include "reference/levels.h"
#include "trial/measure.h"

enum { W = SANITIZED ? 64 : 160, H = SANITIZED ? 48 : 120 };

static struct sph_yardstick yardstick(const struct sph_scene *scene,
                                      const struct sph_build_options *o, uint32_t most) {
    struct sph_yardstick y;
    struct sph_error err = {{0}};
    const struct sph_yardstick_options how = {.most = most, .lod = SPH_LOD_MENDED};
    if (sph_yardstick_make(scene, o, &how, &y, &err)) fail_msg("%s", err.text);
    return y;
}

static struct sph_trial trial(const struct sph_yardstick *y, const struct sph_build_options *o) {
    struct sph_trial t;
    struct sph_error err = {{0}};
    if (sph_trial_measure(y, o, 0, &t, &err)) fail_msg("%s", err.text);
    return t;
}

/* As both have it of the whole frame; none stands twice. */
static void same_pixels(const struct sph_yardstick *some, const struct sph_yardstick *all,
                        const struct sph_trial *of_some, const struct sph_trial *of_all) {
    for (int i = 0; i < some->reference.width; i++) {
        uint32_t at = some->places[i];
        assert_true(at < W * H && (i == 0 || at != some->places[i - 1]));
        assert_memory_equal(&some->reference.pixels[i].colour, &all->reference.pixels[at].colour,
                            sizeof all->reference.pixels[at].colour);
        assert_int_equal(some->reference.pixels[i].id, all->reference.pixels[at].id);
        assert_memory_equal(of_some->shot.frame.pixels[i].colour,
                            of_all->shot.frame.pixels[at].colour,
                            sizeof of_all->shot.frame.pixels[at].colour);
        assert_int_equal(of_some->shot.frame.pixels[i].id, of_all->shot.frame.pixels[at].id);
        assert_int_equal(of_some->shot.frame.pixels[i].visits,
                         of_all->shot.frame.pixels[at].visits);
    }
}

static void samples_of_frames(void **state) {
    (void)state;
    static const struct {
        const char *scene;
        int profile;
        uint32_t most;
    } rows[] = {
        {"scenes/paper100.nff", SPH_DRAFT, W * H / 2},     /* every other pixel */
        {"scenes/paper100.nff", SPH_DRAFT, 1},             /* one */
        {"scenes/sphereflake2.nff", SPH_DRAFT, 500},       /* many wrong ones */
        {"scenes/refraction/nested.nff", SPH_DRAFT, 1000}, /* rare and far off */
        {"scenes/facets/room.nff", SPH_STANDARD, 1000},    /* none wrong in most samples */
        {"scenes/empty.nff", SPH_STANDARD, 100},           /* nothing to be wrong */
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct sph_scene scene = read_scene(rows[i].scene);
        struct sph_build_options o = SPH_BUILD_DEFAULT;
        o.profile = rows[i].profile, o.width = W, o.height = H;
        struct sph_yardstick all = yardstick(&scene, &o, W * H),
                             some = yardstick(&scene, &o, rows[i].most);
        struct sph_trial of_all = trial(&all, &o), of_some = trial(&some, &o);
        const struct sph_image_error *e = &of_all.accuracy.image, *s = &of_some.accuracy.image;
        assert_null(all.places); /* as many as there are: no sample */
        assert_true(s->pixels <= rows[i].most && s->pixels > 0 && 4 * s->pixels >= rows[i].most);
        same_pixels(&some, &all, &of_some, &of_all);
        assert_int_equal(of_some.shot.counters.count[SPH_COUNT_RAYS_PRIMARY], s->pixels);
        double wrong = (double)of_all.wrong / (double)(e->pixels - e->undecidable);
        assert_true(of_all.wrong_most == wrong && of_all.psnr_least == e->psnr[SPH_FRAMES - 1]);
        printf("# %-28s %5lu of %lu pixels: wrong %.5f of %.5f, %.2f of %.2f dB\n", rows[i].scene,
               s->pixels, e->pixels, wrong, of_some.wrong_most, of_all.psnr_least,
               of_some.psnr_least);
        assert_true(wrong <= of_some.wrong_most);
        assert_true(of_all.psnr_least >= of_some.psnr_least);
        sph_trial_free(&of_all);
        sph_trial_free(&of_some);
        sph_yardstick_free(&all);
        sph_yardstick_free(&some);
        sph_scene_free(&scene);
    }
}

/* Of the published limits of Clopper and Pearson, two-sided 95 %, the upper ones. */
static void limits(void **state) {
    (void)state;
    static const struct {
        uint64_t k, n;
        double most;
    } rows[] = {
        {0, 10, 0.3085},      /* none found */
        {1, 10, 0.4450},      /* one */
        {5, 10, 0.8129},      /* half */
        {10, 10, 1},          /* all */
        {0, 0, 1},            /* nothing is known */
        {0, 1000000, 3.69e-6} /* of many */
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        assert_true(fabs(sph_trial_at_most(rows[i].k, rows[i].n) / rows[i].most - 1) < 1e-3);
}

/* What cannot be built is refused, and nothing is left. */
static void refused(void **state) {
    (void)state;
    struct sph_scene scene = read_scene("scenes/paper5.nff");
    struct sph_build_options o = SPH_BUILD_DEFAULT;
    struct sph_yardstick y = yardstick(&scene, &o, 64);
    struct sph_trial t;
    struct sph_error err = {{0}};
    o.shadow = SPH_OFF, o.clear = SPH_ON; /* clear needs shadow */
    assert_int_equal(sph_trial_measure(&y, &o, 0, &t, &err), -1);
    assert_true(err.text[0]);
    sph_yardstick_free(&y);
    sph_scene_free(&scene);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(samples_of_frames),
                                       cmocka_unit_test(limits), cmocka_unit_test(refused)};
    return cmocka_run_group_tests_name("trial/test_measure", tests, NULL, NULL);
}
