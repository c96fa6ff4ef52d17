/* cmd_compare.c - `sphaera compare`: pictures or frames, exactly
 * SPDX-License-Identifier: Apache-2.0
 */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "core/frame.h"
#include "image/image.h"
#include "common/file.h"
#include "render/render.h"
#include "tool/print.h"
#include "tool/report.h"

struct arguments {
    const char *input[2], *json, *picture;
    int inputs, layer, ignore_work;
    struct tool_outputs outputs;
};

enum { KEY_JSON = 512, KEY_LAYER, KEY_IGNORE };

static const struct argp_option options[] = {
    {"difference", 'd', "FILE.png", 0, "two frames and their difference side by side", 0},
    {"layer", KEY_LAYER, "N", 0, "colours of that picture: 0, 1 or 2 (default)", 0},
    {"ignore-work", KEY_IGNORE, NULL, 0,
     "frames of different trees or traversals: neither visits nor counters", 0},
    {"json", KEY_JSON, "FILE", 0, "report as JSON (- : on standard output instead of text)", 0},
    {0},
};

static error_t parse(int key, char *arg, struct argp_state *state) {
    struct arguments *a = state->input;
    switch (key) {
    case 'd':
        a->picture = tool_picture(state, &a->outputs, key, "--difference", arg, TOOL_EXACT);
        return 0;
    case KEY_JSON:
        a->json = tool_output(&a->outputs, key, arg);
        return 0;
    case KEY_LAYER:
        a->layer = (int)tool_number(state, "--layer", arg, 0, SPH_FRAMES - 1);
        return 0;
    case KEY_IGNORE:
        a->ignore_work = 1;
        return 0;
    case ARGP_KEY_ARG:
        if (a->inputs == 2) argp_error(state, "two files: '%s' is one too many", arg);
        a->input[a->inputs++] = arg;
        return 0;
    case ARGP_KEY_END:
        if (a->inputs != 2) argp_error(state, "two files are needed");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static int is_frame(const char *path) {
    return sph_input_starts(path, "SPHFRAME", 8);
}

/* What both kinds of comparison report. */
static void report_difference(json_t *report, int size_differs, uint64_t pixels, int x, int y,
                              uint32_t max_difference) {
    json_t *d = json_object();
    json_object_set_new(d, "size_differs", json_boolean(size_differs));
    report_count(d, "pixels", pixels);
    json_object_set_new(d, "first", pixels ? json_pack("[ii]", x, y) : json_null());
    report_count(d, "max_difference", max_difference);
    json_object_set_new(report, "difference", d);
}

/* Frames and the names of counters and errors that differ. 1 different, 0 same, -1 failed. */
static int compare_frames(const struct arguments *a, FILE *to, json_t *report,
                          struct sph_error *err) {
    static const char *const counters[] = {SPH_COUNTER_NAMES}, *const errors[] = {SPH_ERROR_NAMES};
    struct sph_shot shots[2];
    struct sph_frame_difference d;
    if (sph_shot_read(a->input[0], &shots[0], err)) return -1;
    if (sph_shot_read(a->input[1], &shots[1], err)) return sph_frame_free(&shots[0].frame), -1;
    int rc = sph_shot_compare(&shots[0], &shots[1], a->ignore_work, &d);
    if (to && rc) sph_shot_explain(&shots[0], &shots[1], &d, "first file", "second file", to);
    report_difference(report, d.size_differs, d.pixels, d.x, d.y, d.max_colour);
    json_object_set_new(report, "counters_differ",
                        report_names(d.counters, counters, SPH_COUNTERS));
    json_object_set_new(report, "errors_differ", report_names(d.errors, errors, SPH_ERRORS));
    if (a->picture &&
        sph_image_write_difference(a->picture, &shots[0].frame, &shots[1].frame, a->layer, err))
        rc = -1;
    sph_frame_free(&shots[0].frame);
    sph_frame_free(&shots[1].frame);
    return rc;
}

static void explain_pictures(const struct sph_image *a, const struct sph_image *b,
                             const struct sph_image_difference *d, FILE *to) {
    if (d->size_differs) {
        fprintf(to, "sizes differ: %dx%d with %d channels and %dx%d with %d channels\n", a->width,
                a->height, a->channels, b->width, b->height, b->channels);
        return;
    }
    fprintf(to,
            "%" PRIu64 " of %" PRIu64 " pixels differ, by up to %u; first at x %d y %d:", d->pixels,
            (uint64_t)a->width * (uint64_t)a->height, d->max_byte, d->x, d->y);
    const struct sph_image *images[] = {a, b};
    for (int i = 0; i < 2; i++)
        for (int c = 0; c < a->channels; c++)
            fprintf(to, "%s %d", i && !c ? " and" : "",
                    images[i]->bytes[((size_t)d->y * (size_t)a->width + (size_t)d->x) *
                                         (size_t)a->channels +
                                     (size_t)c]);
    fputc('\n', to);
}

static int compare_pictures(const struct arguments *a, FILE *to, json_t *report,
                            struct sph_error *err) {
    struct sph_image images[2];
    struct sph_image_difference d;
    if (a->picture) return sph_fail(err, "%s: --difference is for frame files", a->input[0]);
    if (sph_image_read(a->input[0], &images[0], err)) return -1;
    if (sph_image_read(a->input[1], &images[1], err)) return sph_image_free(&images[0]), -1;
    int rc = sph_image_compare(&images[0], &images[1], &d);
    if (to && rc) explain_pictures(&images[0], &images[1], &d, to);
    report_difference(report, d.size_differs, d.pixels, d.x, d.y, d.max_byte);
    sph_image_free(&images[0]);
    sph_image_free(&images[1]);
    return rc;
}

int tool_compare(int argc, char **argv) {
    static const struct argp argp = {
        options,
        parse,
        "A B",
        "Compares two pictures or two frame files: size first, then every pixel, exactly.\v"
        "Frame files are compared in every field of every pixel, in the counters that model and "
        "hardware share, and in error bits. Exit code 0: same; 1: different, or failed; 2: usage.",
        NULL,
        NULL,
        NULL};
    struct arguments a = {.layer = SPH_FRAMES - 1};
    struct sph_error err = {""};
    tool_parse(&argp, argc, argv, 0, &a);

    for (int i = 0; i < a.inputs; i++)
        if (tool_spares(&a.outputs, a.input[i], &err)) return tool_failed(&err);
    FILE *to = print_stream(a.json);
    json_t *report = report_new("compare");
    report_text(report, "first", a.input[0]);
    report_text(report, "second", a.input[1]);
    int frames = is_frame(a.input[0]) + is_frame(a.input[1]);
    int rc = frames == 2   ? compare_frames(&a, to, report, &err)
             : frames == 0 ? compare_pictures(&a, to, report, &err)
                           : sph_fail(&err, "%s, %s: one is a frame file, one is not", a.input[0],
                                      a.input[1]);
    json_object_set_new(report, "same", json_boolean(rc == 0));
    if (report_write(report, rc < 0 ? NULL : a.json, &err)) rc = -1;
    if (rc < 0) return tool_failed(&err);
    if (to && !rc) fprintf(to, "same\n");
    return rc ? TOOL_FAILED : TOOL_GOOD;
}
