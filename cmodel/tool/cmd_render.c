/* cmd_render.c - `sphaera render`: a machine or a scene through the golden model
 * SPDX-License-Identifier: Apache-2.0
 */
#include <stdlib.h>
#include <time.h>

#include "common/number.h"
#include "image/image.h"
#include "validate/describe.h"
#include "render/render.h"
#include "tool/pictures.h"
#include "tool/print.h"
#include "tool/progress.h"
#include "tool/report.h"
#include "tool/sequence.h"

struct arguments {
    struct tool_source source;
    const char *input, *frame, *json, *walk;
    struct light_pictures light;
    int traverse, walks, threads, counters, progress;
    struct tool_frames frames;
    const char *movie;
    double stereo; /* 0: one eye */
};

enum {
    KEY_FRAME = 512,
    KEY_BRUTE,
    KEY_LITERAL,
    KEY_PACKETS,
    KEY_COUNTERS,
    KEY_JSON,
    KEY_FRAMES,
    KEY_PROGRESS,
    KEY_DEPTHS,
    KEY_WALK,
    KEY_STEREO
};

static const struct argp_option options[] = {
    {"output", 'o', "FILE", 0, TOOL_OUTPUT_TEXT "; with --frames .gif, or .mp4 by ffmpeg", 0},
    {"exr", TOOL_KEY_EXR, "FILE.exr", 0,
     "picture in linear light with ids, keys and visits, OpenEXR", 0},
    {"transfer", TOOL_KEY_TRANSFER, "NAME", 0,
     "how the bytes of the picture stand for light: srgb (default), as people see it; linear, the "
     "bytes of the frame",
     0},
    {"frame", KEY_FRAME, "FILE", 0, "frame file, for `sphaera compare`", 0},
    {"walk", KEY_WALK, "FILE.png", 0,
     "bih: picture with a fifth more green for each empty space, more blue for each node that the "
     "primary ray meets",
     0},
    {"layer", TOOL_KEY_LAYER, "N", 0,
     "colours of pictures: 0 without reflections, 1 one reflection, 2 all (default)", 0},
    {"depths", KEY_DEPTHS, NULL, 0,
     "pictures tell how many surfaces behind one another made a pixel: 0 black, 1 red, 2 green, "
     "3 blue, 4 yellow, 5 magenta, 6 white",
     0},
    {"brute", KEY_BRUTE, NULL, 0, "without tree: test every primitive, find the nearest", 0},
    {"literal", KEY_LITERAL, NULL, 0,
     "by the functions that the RTL is read beside: slower, the same results", 0},
    {"packets", KEY_PACKETS, NULL, 0,
     "rays of neighbours together: faster, the same picture, but visits and counters of the tree's "
     "work are 0; with --counters, --frame or --exr, which tell them, one after another",
     0},
    {"threads", 't', "N", 0, "0: one for every processor (default)", 0},
    {"counters", KEY_COUNTERS, NULL, 0, "print the counters", 0},
    {"frames", KEY_FRAMES, "A..B", 0,
     "these frames of a moving scene, with numbers in the names of files: FILE-0007.png", 0},
    {"stereo", KEY_STEREO, "D", 0,
     "two pictures, FILE-left.png and FILE-right.png, of eyes that are D scene units apart: "
     "--eye-shift by half of it either way",
     0},
    {"json", KEY_JSON, "FILE", 0, "report as JSON (- : on standard output instead of text)", 0},
    {"progress", KEY_PROGRESS, NULL, 0, "show progress though stderr is no terminal", 0},
    {0},
};

static const char *const traversals[] = {"tree", "brute", "tree", "packets"}; /* SPH_TRAVERSE_* */

static error_t parse(int key, char *arg, struct argp_state *state) {
    struct arguments *a = state->input;
    if (key == 'o' && movie_is(arg)) {
        a->movie = tool_output(&a->source.outputs, key, arg);
        return 0;
    }
    if (!light_option(&a->light, &a->source.outputs, key, arg, state)) return 0;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &a->source;
        return 0;
    case KEY_FRAME:
        a->frame = tool_output(&a->source.outputs, key, arg);
        return 0;
    case KEY_WALK:
        a->walk = tool_picture(state, &a->source.outputs, key, "--walk", arg, TOOL_EXACT);
        return 0;
    case KEY_DEPTHS:
        a->light.depths = 1;
        return 0;
    case KEY_BRUTE:
        a->traverse = SPH_TRAVERSE_BRUTE, a->walks |= 1;
        return 0;
    case KEY_LITERAL:
        a->traverse = SPH_TRAVERSE_TREE, a->walks |= 2;
        return 0;
    case KEY_PACKETS:
        a->traverse = SPH_TRAVERSE_PACKETS, a->walks |= 4;
        return 0;
    case 't':
        a->threads = (int)tool_number(state, "--threads", arg, 0, 1024);
        return 0;
    case KEY_COUNTERS:
        a->counters = 1;
        return 0;
    case KEY_STEREO:
        a->stereo = tool_real(state, "--stereo", arg, 1e-9, SPH_NUMBER_MAX);
        a->source.option = "stereo";
        return 0;
    case KEY_FRAMES:
        tool_frames_parse(state, arg, &a->frames);
        return 0;
    case KEY_JSON:
        a->json = tool_output(&a->source.outputs, key, arg);
        return 0;
    case KEY_PROGRESS:
        a->progress = a->frames.progress = 1;
        return 0;
    default:
        if (key == ARGP_KEY_END && a->traverse == SPH_TRAVERSE_PACKETS &&
            (a->counters || a->frame || a->light.exr))
            a->traverse = SPH_TRAVERSE_FAST;
        if (key == ARGP_KEY_END && (a->walks & (a->walks - 1)))
            argp_error(state, "--brute, --literal and --packets exclude one another");
        if (key == ARGP_KEY_END && a->stereo > 0) tool_stereo_check(state, &a->source.outputs);
        if (key == ARGP_KEY_END && a->frames.on && a->source.read.at)
            argp_error(state, "--frames and --at exclude each other");
        if (key == ARGP_KEY_END && a->frames.on && a->source.read.timed)
            argp_error(state, "--frames and --time exclude each other");
        if (key == ARGP_KEY_END && a->movie && !a->frames.on)
            argp_error(state, "-o %s: of what frames? --frames A..B", a->movie);
        if (key == ARGP_KEY_END && a->source.samples > 1 && (a->light.depths || a->walk))
            argp_error(state, "--samples is for light: --depths and --walk are false colours");
        return tool_one_scene(state, key, arg, &a->input, "no machine or scene given");
    }
}

/* Renders into *shot; returns the seconds it took, or -1 with a message. trails may be NULL. */
static double render(const struct arguments *a, const struct sph_machine *machine,
                     struct sph_shot *shot, struct sph_trail *trails, struct sph_error *err) {
    struct progress progress;
    struct sph_render_options how = {
        .traverse = a->traverse, .threads = a->threads, .trails = trails};
    if (progress_start(&progress, "rendering", a->progress)) {
        how.progress = progress_show;
        how.user = &progress;
    }
    double start = progress_now();
    int bits = sph_render(machine, &how, &shot->frame, &shot->counters, err);
    progress_end(&progress);
    shot->errors = (uint32_t)bits;
    return bits < 0 ? -1 : progress_now() - start;
}

/* Renders, and writes every file but the report; *seconds: of rendering. */
static int shoot(const struct arguments *a, const struct tool_built *built, struct sph_shot *shot,
                 double *seconds, struct sph_error *err) {
    if (a->walk && !sph_machine_bih(&built->machine))
        return sph_fail(err, "--walk is for --accel bih and brute, this is %s",
                        sph_machine_tree_name(&built->machine));
    const int32_t *r = built->machine.regs;
    size_t pixels = (size_t)r[SPH_REG_FRAME_W] * (size_t)r[SPH_REG_FRAME_H];
    int pictures = a->light.picture || a->light.exr;
    struct sph_trail *trails = pictures ? calloc(pixels, sizeof *trails) : NULL;
    if (pictures && !trails) return sph_fail(err, "%s: no memory for a picture", a->input);
    *seconds = render(a, &built->machine, shot, trails, err);
    int rc = *seconds < 0 ? -1 : 0;
    if (!rc && trails)
        rc =
            light_picture(&a->light, a->source.samples, &built->machine, &shot->frame, trails, err);
    if (!rc && a->frame) rc = sph_shot_write(shot, a->frame, err);
    if (!rc && a->walk)
        rc = walk_picture(a->walk, &built->machine, &shot->frame, a->light.layer, err);
    free(trails);
    return rc;
}

/* Everything after reading and building. */
static int render_built(const struct arguments *a, const struct tool_built *built,
                        struct sph_error *err) {
    struct sph_shot shot = {0};
    double seconds = 0;
    clock_t start = clock();
    int rc = shoot(a, built, &shot, &seconds, err);
    double cpu = (double)(clock() - start) / CLOCKS_PER_SEC;
    if (!shot.frame.pixels) return -1;
    FILE *to = rc ? NULL : print_stream(a->json);
    print_build(to, built);
    print_shot(to, &shot, a->counters);
    if (to) fprintf(to, "rendered in %.3f s\n", seconds);
    json_t *report = report_new("render");
    report_text(report, "input", a->input);
    report_text(report, "traverse", traversals[a->traverse]);
    report_machine(report, &built->machine);
    report_build(report, built);
    report_shot(a->json ? report : NULL, &shot);
    report_number(report, "seconds", seconds);
    report_number(report, "cpu_seconds", cpu);
    if (report_write(report, rc ? NULL : a->json, err)) rc = -1;
    sph_frame_free(&shot.frame);
    return rc;
}

/* One of several frames, into files of its own. */
static int render_frame(void *user, uint32_t frame, const struct tool_built *built, json_t *entry,
                        struct sph_error *err) {
    const struct arguments *all = user;
    struct arguments a = *all;
    struct sph_shot shot = {0};
    double seconds = 0;
    char *names[] = {tool_numbered(all->light.picture, frame), tool_numbered(all->light.exr, frame),
                     tool_numbered(all->frame, frame), tool_numbered(all->walk, frame)};
    a.light.picture = names[0], a.light.exr = names[1], a.frame = names[2], a.walk = names[3];
    int rc = shoot(&a, built, &shot, &seconds, err);
    if (!rc) {
        print_shot(print_stream(a.json), &shot, a.counters);
        report_shot(entry, &shot);
        report_number(entry, "seconds", seconds);
    }
    sph_frame_free(&shot.frame);
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        free(names[i]);
    return rc;
}

static int render_frames(struct arguments *a) {
    struct sph_error err = {""};
    json_t *report = report_new("render"), *list = json_array();
    report_text(report, "input", a->input);
    report_text(report, "traverse", traversals[a->traverse]);
    json_object_set_new(report, "frames", list);
    FILE *to = print_stream(a->json);
    int rc = a->movie ? tool_movie_of(a->movie, &a->light.picture, a->input, &a->source, &a->frames,
                                      to, list, render_frame, a, &err)
                      : tool_each_frame(a->input, &a->source, &a->frames, to, list, render_frame, a,
                                        &err);
    if (report_write(report, rc ? NULL : a->json, &err)) rc = -1;
    return rc ? tool_failed(&err) : TOOL_GOOD;
}

static int draw(void *user) {
    struct arguments *a = user;
    struct tool_built built;
    struct sph_error err = {""};
    if (a->frames.on) return render_frames(a);
    if (tool_load(a->input, &a->source, &built, &err)) return tool_failed(&err);
    int rc = render_built(a, &built, &err);
    sph_machine_free(&built.machine);
    return rc ? tool_failed(&err) : TOOL_GOOD;
}

int tool_render(int argc, char **argv) {
    static const struct argp_child children[] = {{&tool_source_argp, 0, NULL, 1}, {0}};
    static const struct argp argp = {
        options,
        parse,
        "MACHINE.sph|SCENE",
        "Renders with the golden model, bit by bit as the hardware does.\v"
        "Prints the sticky errors and a hash of every field of every pixel; two frames are the "
        "same if their hashes are. Options of build are for scene files only.",
        children,
        NULL,
        NULL};
    struct arguments a = {.source = tool_source_default,
                          .traverse = SPH_TRAVERSE_FAST,
                          .light = {.layer = SPH_FRAMES - 1, .transfer = SPH_TRANSFER_SRGB}};
    tool_parse(&argp, argc, argv, 0, &a);
    const char **names[] = {&a.light.picture, &a.light.exr, &a.frame, &a.walk, &a.json, &a.movie};
    return a.stereo > 0 ? tool_stereo(a.stereo, &a.source, names, 6, draw, &a) : draw(&a);
}
