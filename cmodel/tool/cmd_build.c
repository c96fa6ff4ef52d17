/* cmd_build.c - `sphaera build`: scene file to machine file
 * SPDX-License-Identifier: Apache-2.0
 */
#include <inttypes.h>
#include <stdlib.h>
#include <sys/stat.h>

#include "common/number.h"
#include "validate/describe.h"
#include "tool/print.h"
#include "tool/progress.h"
#include "tool/report.h"
#include "tool/sequence.h"

struct arguments {
    struct tool_source source;
    const char *input, *output, *json;
    int stats, progress;
    double stereo; /* 0: one eye */
    struct tool_frames frames;
};

enum { KEY_JSON = 512, KEY_STATS, KEY_FRAMES, KEY_PROGRESS, KEY_STEREO };

static const struct argp_option options[] = {
    {"output", 'o', "FILE", 0, "machine file to write", 0},
    {"stats", KEY_STATS, NULL, 0, "bih, box4: nodes, leaves, levels and bytes as text", 0},
    {"frames", KEY_FRAMES, "A..B", 0,
     "machines of these frames of a moving scene, FILE-0007.sph and so on", 0},
    {"stereo", KEY_STEREO, "D", 0,
     "two machines, FILE-left.sph and FILE-right.sph, of eyes that are D scene units apart: "
     "--eye-shift by half of it either way",
     0},
    {"json", KEY_JSON, "FILE", 0, "report as JSON (- : on standard output instead of text)", 0},
    {"progress", KEY_PROGRESS, NULL, 0, "show progress though stderr is no terminal", 0},
    {0},
};

static error_t parse(int key, char *arg, struct argp_state *state) {
    struct arguments *a = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &a->source;
        return 0;
    case 'o':
        a->output = tool_output(&a->source.outputs, key, arg);
        return 0;
    case KEY_JSON:
        a->json = tool_output(&a->source.outputs, key, arg);
        return 0;
    case KEY_STATS:
        a->stats = 1;
        return 0;
    case KEY_PROGRESS:
        a->progress = a->frames.progress = 1;
        return 0;
    case KEY_STEREO:
        a->stereo = tool_real(state, "--stereo", arg, 1e-9, SPH_NUMBER_MAX);
        return 0;
    case KEY_FRAMES:
        tool_frames_parse(state, arg, &a->frames);
        return 0;
    case ARGP_KEY_END:
        if (a->stereo > 0) tool_stereo_check(state, &a->source.outputs);
        if (a->frames.on && a->source.read.at)
            argp_error(state, "--frames and --at exclude each other");
        if (a->frames.on && a->source.read.timed)
            argp_error(state, "--frames and --time exclude each other");
        if (a->input && !a->output) argp_error(state, "no output given (-o)");
        break;
    default:
        break;
    }
    return tool_one_scene(state, key, arg, &a->input, "no scene given");
}

/* The writer renames a finished file to path: keeps it from replacing a device. */
static int check_target(const char *path, struct sph_error *err) {
    struct stat st;
    if (!stat(path, &st) && !S_ISREG(st.st_mode))
        return sph_fail(err, "%s: not a file that can be replaced", path);
    return 0;
}

static int write_frame(void *user, uint32_t frame, const struct tool_built *built, json_t *entry,
                       struct sph_error *err) {
    const struct arguments *a = user;
    char *path = tool_numbered(a->output, frame);
    int rc = path ? check_target(path, err) : sph_fail(err, "no memory for the name of a file");
    if (!rc) rc = sph_machine_write(&built->machine, path, err);
    report_text(entry, "output", path);
    free(path);
    return rc;
}

static int build_frames(struct arguments *a) {
    struct sph_error err = {""};
    json_t *report = report_new("build"), *list = json_array();
    report_text(report, "input", a->input);
    json_object_set_new(report, "frames", list);
    int rc = tool_each_frame(a->input, &a->source, &a->frames, print_stream(a->json), list,
                             write_frame, a, &err);
    if (report_write(report, rc ? NULL : a->json, &err)) rc = -1;
    return rc ? tool_failed(&err) : TOOL_GOOD;
}

/* What a tree of boxes is like. */
static void print_boxes(const struct sph_machine *m, uint32_t nodes) {
    uint32_t bytes = SPH_LINE_WORDS * 4 * nodes;
    FILE *to = tool_text();
    sph_machine_describe_tree(m, to);
    fprintf(to, "bytes     %u of nodes and %" PRId64 " of leaf records\n", bytes,
            (int64_t)m->regs[SPH_REG_PRIM_BASE] * SPH_LINE_WORDS * 4 - bytes);
}

/* tool_load(), and how far it is. */
static int load(const struct arguments *a, struct tool_built *built, struct sph_error *err) {
    struct progress lines[2];
    struct sph_progress reading = progress_of(&lines[0], "reading", a->progress);
    struct sph_progress building = progress_of(&lines[1], "building", a->progress);
    struct tool_source source = a->source;
    source.read.progress = &reading;
    source.build.progress = &building;
    int rc = tool_load(a->input, &source, built, err);
    progress_end(&lines[0]);
    progress_end(&lines[1]);
    return rc;
}

static int build(void *user) {
    struct arguments *a = user;
    struct tool_built built;
    struct sph_error err = {""};
    if (tool_is_machine(a->input)) {
        sph_fail(&err, "%s: is a machine file already", a->input);
        return tool_failed(&err);
    }
    if (a->frames.on) return build_frames(a);
    if (check_target(a->output, &err) || load(a, &built, &err)) return tool_failed(&err);
    print_build(print_stream(a->json), &built);
    int boxes = built.machine.regs[SPH_REG_TREE] == SPH_TREE_BOX4;
    if (a->stats && (boxes || sph_machine_bih(&built.machine))) {
        if (!boxes) print_bih(print_stream(a->json), &built.machine, &built.report.bih);
        if (boxes && !a->json) print_boxes(&built.machine, built.report.nodes);
        if (!a->json)
            fprintf(tool_text(), "build    tree %.3f ms\n", 1e3 * built.report.tree_seconds);
    }
    json_t *report = report_new("build");
    report_text(report, "input", a->input);
    report_text(report, "output", a->output);
    report_machine(report, &built.machine);
    report_build(report, &built);
    int rc = sph_machine_write(&built.machine, a->output, &err);
    if (report_write(report, rc ? NULL : a->json, &err)) rc = -1;
    sph_machine_free(&built.machine);
    return rc ? tool_failed(&err) : TOOL_GOOD;
}

int tool_build(int argc, char **argv) {
    static const struct argp_child children[] = {{&tool_source_argp, 0, NULL, 1}, {0}};
    static const struct argp argp = {
        options,
        parse,
        "SCENE",
        "Quantises a scene, builds its tree and writes the machine file.\v"
        "Prints the grid step, the smallest radius in steps, how much the field of view is off, "
        "the tree, and which effects are on and why.",
        children,
        NULL,
        NULL};
    struct arguments a = {.source = tool_source_default};
    a.source.effects = TOOL_EFFECTS_MET;
    tool_parse(&argp, argc, argv, 0, &a);
    const char **names[] = {&a.output, &a.json};
    return a.stereo > 0 ? tool_stereo(a.stereo, &a.source, names, 2, build, &a) : build(&a);
}
