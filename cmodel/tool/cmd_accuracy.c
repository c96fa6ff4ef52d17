/* cmd_accuracy.c - `sphaera accuracy`: a scene through model and double reference, compared
 * SPDX-License-Identifier: Apache-2.0
 */
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <time.h>

#include "core/frame_file.h"
#include "image/image.h"
#include "reference/accuracy.h"
#include "tool/levels.h"
#include "tool/print.h"
#include "tool/report.h"
#include "image/mips.h"
#include "render/render.h"

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
    struct sph_shot shot;
    struct sph_trail *trails;
    struct sph_reference reference;
    double model_seconds, reference_seconds;
    struct sph_accuracy accuracy;
    struct sph_mip *mips;
    struct sph_levels levels;
    uint32_t *numbers;
};

/* Seconds of processor, all threads. */
static double cpu_now(void) {
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int run_model(const struct arguments *a, struct measured *m, struct sph_error *err) {
    const int32_t *r = m->built.machine.regs;
    m->trails = calloc((size_t)r[SPH_REG_FRAME_W] * (size_t)r[SPH_REG_FRAME_H], sizeof *m->trails);
    if (!m->trails) return sph_fail(err, "%s: no memory for the rays of a frame", a->input);
    struct sph_render_options how = {
        .traverse = SPH_TRAVERSE_FAST, .threads = a->threads, .trails = m->trails};
    double start = cpu_now();
    int bits = sph_render(&m->built.machine, &how, &m->shot.frame, &m->shot.counters, err);
    m->model_seconds = cpu_now() - start;
    m->shot.errors = (uint32_t)bits;
    return bits < 0 ? -1 : 0;
}

static int run_reference(const struct arguments *a, const struct sph_scene *scene,
                         struct measured *m, struct sph_error *err) {
    const struct sph_build_options *b = &a->source.build;
    struct sph_reference_options how = {
        .width = m->shot.frame.width,
        .height = m->shot.frame.height,
        .max_depth = a->truth < 0 ? b->max_depth : a->truth,
        .shadow = 1,
        .reflect = 1,
        .refract = 1,
        .specular = 1,
        .threads = a->threads,
        .world = &m->built.machine,
        .mips = m->mips,
        .filter = b->tex_filter,
        .lod = a->levels,
        .spread = sph_machine_effect(&m->built.machine, SPH_EFFECT_SPREAD)};
    double start = cpu_now();
    int rc = sph_reference_render(scene, &how, &m->reference, err);
    m->reference_seconds = cpu_now() - start;
    return rc;
}

/* reference | model | difference: a pixel that is right but for its sphere shows blue. */
static int draw(const char *path, const struct measured *m, struct sph_error *err) {
    struct sph_frame truth = m->shot.frame;
    size_t n = (size_t)truth.width * (size_t)truth.height;
    truth.pixels = malloc(n * sizeof *truth.pixels);
    if (!truth.pixels) return sph_fail(err, "%s: no memory for the picture", path);
    for (size_t i = 0; i < n; i++) {
        truth.pixels[i] = m->shot.frame.pixels[i];
        truth.pixels[i].id = m->reference.pixels[i].id;
        for (int layer = 0; layer < SPH_FRAMES; layer++)
            truth.pixels[i].colour[layer] = m->reference.pixels[i].colour[layer];
    }
    int rc = sph_image_write_difference(path, &truth, &m->shot.frame, SPH_FRAMES - 1, err);
    sph_frame_free(&truth);
    return rc;
}

static void print(FILE *to, const struct measured *m) {
    const struct sph_accuracy *e = &m->accuracy;
    const struct sph_image_error *image = &e->image;
    const struct sph_estimate *expected = &m->built.expected;
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
    fprintf(to, "\ntime       model %.3f s, reference %.3f s of processor\n", m->model_seconds,
            m->reference_seconds);
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
    m->numbers = malloc((scene->n_spheres + scene->n_facets + 1ull) * sizeof *m->numbers);
    if (!m->numbers) return sph_fail(err, "%s: no memory for the numbers of primitives", a->input);
    struct tool_source source = a->source;
    source.build.numbers = m->numbers;
    if (tool_build_scene(&source, scene, m->mips, &m->built, err)) return -1;
    if (run_model(a, m, err) || run_reference(a, scene, m, err)) return -1;
    json_t *report = report_new("accuracy");
    report_text(report, "input", a->input);
    report_machine(report, &m->built.machine);
    report_build(report, &m->built);
    report_shot(report, &m->shot); /* its hash is of the machine's ids */
    sph_accuracy_number(m->numbers, &m->shot.frame, m->trails);
    struct sph_accuracy_frame f = {
        &m->built.machine,         &m->shot.frame,           m->trails, m->built.report.lights,
        m->built.report.eye.ahead, m->built.report.eye.wider};
    m->accuracy = sph_accuracy_measure(&f, &m->reference);
    m->levels = sph_levels_measure(&m->shot.frame, &m->reference);
    if ((a->frame && sph_shot_write(&m->shot, a->frame, err)) ||
        (a->picture && draw(a->picture, m, err))) {
        json_decref(report);
        return -1;
    }
    FILE *to = print_stream(a->json);
    print_build(to, &m->built);
    print(to, m);
    print_levels(to, &m->levels);
    json_object_set_new(report, "accuracy", accuracy_json(&m->accuracy));
    if (m->levels.pixels) {
        json_object_set_new(report, "levels", levels_json(&m->levels));
        json_object_set_new(report, "level_work", level_work_json(&m->reference.work));
    }
    report_number(report, "cpu_seconds", m->model_seconds);
    report_number(report, "reference_cpu_seconds", m->reference_seconds);
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
    sph_machine_free(&m.built.machine);
    sph_frame_free(&m.shot.frame);
    sph_reference_free(&m.reference);
    free(m.trails);
    free(m.numbers);
    sph_mips_free(m.mips, scene.n_textures);
    sph_scene_free(&scene);
    return rc ? tool_failed(&err) : TOOL_GOOD;
}
