/* cmd_accuracy.c - `sphaera accuracy`: a scene through model and double reference, compared
 * SPDX-License-Identifier: Apache-2.0
 */
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>

#include "core/frame.h"
#include "image/image.h"
#include "tool/levels.h"
#include "tool/print.h"
#include "tool/report.h"
#include "image/mips.h"
#include "trial/measure.h"

struct arguments {
    struct tool_source source;
    const char *input, *frame, *json, *picture;
    int threads, truth, levels;
};

enum { KEY_JSON = 512, KEY_TRUTH, KEY_LEVELS, KEY_FRAME };

static const struct argp_option options[] = {
    {"difference", 'd', "FILE.png", 0, "reference, model and their difference side by side", 0},
    {"truth", KEY_TRUTH, "N", 0, "reflections of the reference, 0 to 10 (as --depth)", 0},
    {"levels", KEY_LEVELS, "NAME", 0,
     "how the reference chooses levels of textures: mended (default, as the machine), paper, bmrt, "
     "or by ray differentials (rays)",
     0},
    {"frame", KEY_FRAME, "FILE", 0, "frame file of the model, ids as the scene numbers its objects",
     0},
    {"threads", 't', "N", 0, "0: one for every processor (default)", 0},
    {"json", KEY_JSON, "FILE", 0, "report as JSON (- : on standard output instead of text)", 0},
    {0},
};

static error_t parse(int key, char *arg, struct argp_state *state) {
    struct arguments *a = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &a->source;
        return 0;
    case 'd':
        a->picture = tool_picture(state, &a->source.outputs, key, "--difference", arg, TOOL_EXACT);
        return 0;
    case KEY_FRAME:
        a->frame = tool_output(&a->source.outputs, key, arg);
        return 0;
    case KEY_LEVELS:
        a->levels = tool_choice(state, "--levels", arg, tool_level_names);
        return 0;
    case KEY_TRUTH:
        a->truth = (int)tool_number(state, "--truth", arg, 0, SPH_MAX_DEPTH);
        return 0;
    case 't':
        a->threads = (int)tool_number(state, "--threads", arg, 0, 1024);
        return 0;
    case KEY_JSON:
        a->json = tool_output(&a->source.outputs, key, arg);
        return 0;
    default:
        return tool_one_scene(state, key, arg, &a->input, "no scene given");
    }
}

/* What is held while a scene is measured. */
struct measured {
    struct tool_built built;
    struct sph_yardstick yardstick;
    struct sph_trial trial; /* its machine is that of built */
    struct sph_mip *mips;
    struct sph_levels levels;
};

/* reference | model | difference: a pixel that is right but for its sphere shows blue. */
static int draw(const char *path, const struct measured *m, struct sph_error *err) {
    const struct sph_frame *drawn = &m->trial.shot.frame;
    struct sph_frame truth = *drawn;
    size_t n = (size_t)truth.width * (size_t)truth.height;
    truth.pixels = malloc(n * sizeof *truth.pixels);
    if (!truth.pixels) return sph_fail(err, "%s: no memory for the picture", path);
    for (size_t i = 0; i < n; i++) {
        truth.pixels[i] = drawn->pixels[i];
        truth.pixels[i].id = m->yardstick.reference.pixels[i].id;
        for (int layer = 0; layer < SPH_FRAMES; layer++)
            truth.pixels[i].colour[layer] = m->yardstick.reference.pixels[i].colour[layer];
    }
    int rc = sph_image_write_difference(path, &truth, drawn, SPH_FRAMES - 1, err);
    sph_frame_free(&truth);
    return rc;
}

static void print(FILE *to, const struct measured *m) {
    const struct sph_accuracy *e = &m->trial.accuracy;
    const struct sph_image_error *image = &e->image;
    const struct sph_estimate *expected = &m->built.picture.expected;
    if (!to) return;
    fprintf(to, "psnr       %.2f dB (depth 0: %.2f, depth 1: %.2f)\n", image->psnr[SPH_FRAMES - 1],
            image->psnr[0], image->psnr[1]);
    fprintf(to, "pixels     %" PRIu64 ", %" PRIu64 " off by more than 8, the worst by %d\n",
            image->pixels, image->far_off, image->worst);
    fprintf(to,
            "wrong      silhouette %" PRIu64 ", other sphere %" PRIu64 ", shadow %" PRIu64
            ", reflected %" PRIu64 ", refracted %" PRIu64 "\n",
            image->silhouette, image->wrong_id, e->shadow, e->reflected, e->refracted);
    fprintf(to,
            "undecided  %" PRIu64 " pixels that doubles cannot tell, counted for none of that\n",
            image->undecidable);
    fprintf(to, "distance   off by %.3f grid steps on the mean of %" PRIu64 " pixels", e->t_mean,
            e->same);
    if (e->x >= 0) fprintf(to, ", by %.3f at x %d y %d", e->t_worst, e->x, e->y);
    fprintf(to, "\nexpected   %.2f dB, %.1f pixels of silhouette and other sphere, %.3g pixels off",
            expected->psnr, expected->wrong * (double)image->pixels, expected->pixels);
    fprintf(to, "\ntime       model %.3f s, reference %.3f s of processor\n", m->trial.seconds,
            m->yardstick.seconds);
}

static json_t *accuracy_json(const struct sph_accuracy *e) {
    json_t *json = json_object(), *psnr = json_array();
    for (int layer = 0; layer < SPH_FRAMES; layer++)
        json_array_append_new(psnr, isfinite(e->image.psnr[layer]) ? json_real(e->image.psnr[layer])
                                                                   : json_null());
    json_object_set_new(json, "psnr", psnr);
    report_count(json, "pixels", e->image.pixels);
    report_count(json, "undecidable", e->image.undecidable);
    report_count(json, "silhouette", e->image.silhouette);
    report_count(json, "wrong_id", e->image.wrong_id);
    report_count(json, "shadow", e->shadow);
    report_count(json, "reflected", e->reflected);
    report_count(json, "refracted", e->refracted);
    report_count(json, "far_off", e->image.far_off);
    report_count(json, "worst", (uint64_t)e->image.worst);
    report_count(json, "same", e->same);
    report_number(json, "t_worst", e->t_worst);
    report_number(json, "t_mean", e->t_mean);
    json_object_set_new(json, "t_at", e->x < 0 ? json_null() : json_pack("[ii]", e->x, e->y));
    return json;
}

/* Everything after reading the scene; *m is all zero before and freed by the caller. */
static int measure(const struct arguments *a, const struct sph_scene *scene, struct measured *m,
                   struct sph_error *err) {
    if (a->source.build.texture != SPH_OFF && sph_mips_load(scene, &m->mips, err)) return -1;
    struct sph_trial *t = &m->trial;
    t->numbers = malloc((scene->n_spheres + scene->n_facets + 1ull) * sizeof *t->numbers);
    if (!t->numbers) return sph_fail(err, "%s: no memory for the numbers of primitives", a->input);
    struct tool_source source = a->source;
    source.build.numbers = t->numbers;
    source.build.mips = m->mips;
    if (!source.profile_auto)
        source.bound = (struct sph_error_bound){INFINITY, 0}; /* it measures */
    if (tool_build_scene(&source, scene, m->mips, &m->built, err)) return -1;
    t->machine = m->built.machine;
    t->report = m->built.report;
    source.build.width = t->machine.regs[SPH_REG_FRAME_W];
    source.build.height = t->machine.regs[SPH_REG_FRAME_H];
    if (a->truth >= 0) source.build.max_depth = a->truth;
    const struct sph_yardstick_options how = {.lod = a->levels, .threads = a->threads};
    if (sph_yardstick_make(scene, &source.build, &how, &m->yardstick, err) ||
        sph_trial_draw(&m->yardstick, a->threads, t, err))
        return -1;
    json_t *report = report_new("accuracy");
    report_text(report, "input", a->input);
    report_machine(report, &t->machine);
    report_build(report, &m->built);
    report_shot(report, &t->shot); /* its hash is of the machine's ids */
    sph_trial_judge(&m->yardstick, t);
    m->levels = sph_levels_measure(&t->shot.frame, &m->yardstick.reference);
    if ((a->frame && sph_shot_write(&t->shot, a->frame, err)) ||
        (a->picture && draw(a->picture, m, err))) {
        json_decref(report);
        return -1;
    }
    FILE *to = print_stream(a->json);
    print_build(to, &m->built);
    print(to, m);
    print_levels(to, &m->levels);
    json_object_set_new(report, "accuracy", accuracy_json(&m->trial.accuracy));
    if (m->levels.pixels) {
        json_object_set_new(report, "levels", levels_json(&m->levels));
        json_object_set_new(report, "level_work", level_work_json(&m->yardstick.reference.work));
    }
    report_number(report, "cpu_seconds", m->trial.seconds);
    report_number(report, "reference_cpu_seconds", m->yardstick.seconds);
    return report_write(report, a->json, err);
}

int tool_accuracy(int argc, char **argv) {
    static const struct argp_child children[] = {{&tool_source_argp, 0, NULL, 1}, {0}};
    static const struct argp argp = {
        options,
        parse,
        "SCENE",
        "What the machine's arithmetic costs in the picture of a scene.\v"
        "The golden model is compared with a renderer in double precision that sees the scene as "
        "it is written. Wrong pixels: hit in one and background in the other (silhouette); another "
        "sphere; the same sphere, but a light that is blocked in one alone (shadow) or another "
        "sphere in the mirror (reflected) or through it (refracted). Pixels that double precision "
        "cannot tell (undecided) count for none of that. The exit code says nothing of their "
        "number.",
        children,
        NULL,
        NULL};
    struct arguments a = {.source = tool_source_default, .truth = -1};
    struct sph_scene scene;
    struct sph_error err = {""};
    tool_parse(&argp, argc, argv, 0, &a);

    if (tool_wants_scene(a.input, &err) || tool_scene_read(a.input, &a.source, &scene, &err))
        return tool_failed(&err);
    struct measured m = {0};
    int rc = measure(&a, &scene, &m, &err);
    sph_trial_free(&m.trial);
    sph_yardstick_free(&m.yardstick);
    sph_mips_free(m.mips, scene.n_textures);
    sph_scene_free(&scene);
    return rc ? tool_failed(&err) : TOOL_GOOD;
}
