/* cmd_floats.c - `sphaera floats`: the tests of a scene's rays in float32 and float64
 * SPDX-License-Identifier: Apache-2.0
 */
#include <inttypes.h>
#include <stdlib.h>

#include "image/image.h"
#include "tool/float_count.h"
#include "tool/print.h"
#include "tool/report.h"

struct arguments {
    struct tool_source source;
    const char *input, *picture, *json;
};

enum { KEY_JSON = 512 };

static const struct argp_option options[] = {
    {"picture", 'p', "FILE.png", 0,
     "the frame in grey, orange where float64 sees another primitive, red where float32 alone does",
     0},
    {"json", KEY_JSON, "FILE", 0, "report as JSON (- : on standard output instead of text)", 0},
    {0},
};

static error_t parse(int key, char *arg, struct argp_state *state) {
    struct arguments *a = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &a->source;
        return 0;
    case 'p':
        a->picture = tool_picture(state, &a->source.outputs, key, "--picture", arg, TOOL_EXACT);
        return 0;
    case KEY_JSON:
        a->json = tool_output(&a->source.outputs, key, arg);
        return 0;
    default:
        return tool_one_scene(state, key, arg, &a->input, "no scene and no machine given");
    }
}

/* ---- text and report ---- */

static const char *const kinds[FLOAT_KINDS] = {"primary", "shadow", "reflected", "refracted"};
static const char *const rows[FLOAT_ROWS] = {"all", "float32", "float64"};

/* Columns: what counts of FLOAT_ALL alone comes first. */
enum { TESTS, RULES, RAYS, HITS, ROOTS, PAIRS, EQUAL, COLUMNS };
static const char *const columns[COLUMNS] = {"tests", "rules", "rays", "hits",
                                             "roots", "pairs", "equal"};

static void cells(const struct float_counts *c, uint64_t of[COLUMNS]) {
    const uint64_t all[COLUMNS] = {c->tests, c->rules, c->rays, c->hits,
                                   c->roots, c->pairs, c->equal};
    for (int i = 0; i < COLUMNS; i++)
        of[i] = all[i];
}

static void print_floats(FILE *to, const struct float_tally *t) {
    if (!to) return;
    fprintf(to, "%-18s", "ray");
    for (int i = 0; i < COLUMNS; i++)
        fprintf(to, " %10s", columns[i]);
    fprintf(to, "\n");
    for (int k = 0; k < FLOAT_KINDS; k++)
        for (int row = 0; row < FLOAT_ROWS && t->of[k][FLOAT_ALL].rays; row++) {
            uint64_t of[COLUMNS];
            cells(&t->of[k][row], of);
            fprintf(to, "%-10s%-8s", row ? "" : kinds[k], rows[row]);
            for (int i = 0; i < COLUMNS; i++)
                if (row && i < RAYS)
                    fprintf(to, " %10s", "");
                else
                    fprintf(to, " %10" PRIu64, of[i]);
            fprintf(to, "\n");
        }
    fprintf(to,
            "pixels that see another primitive: float32 %" PRIu64 ", float64 %" PRIu64
            ", both %" PRIu64 "\n",
            t->pixels[FLOAT_32], t->pixels[FLOAT_64], t->pixels[FLOAT_ALL]);
}

static void report_floats(json_t *report, const struct float_tally *t) {
    json_t *floats = json_object(), *pixels = json_object();
    for (int k = 0; k < FLOAT_KINDS; k++) {
        json_t *kind = json_object();
        for (int row = 0; row < FLOAT_ROWS; row++) {
            json_t *counts = json_object();
            uint64_t of[COLUMNS];
            cells(&t->of[k][row], of);
            for (int i = row ? RAYS : 0; i < COLUMNS; i++)
                report_count(counts, columns[i], of[i]);
            json_object_set_new(kind, rows[row], counts);
        }
        json_object_set_new(floats, kinds[k], kind);
    }
    for (int row = FLOAT_32; row < FLOAT_ROWS; row++)
        report_count(pixels, rows[row], t->pixels[row]);
    report_count(pixels, "both", t->pixels[FLOAT_ALL]);
    report_add(report, "floats", floats);
    report_add(report, "pixels", pixels);
}

/* ---- picture ---- */

/* As the eye weighs the light (ITU-R BT.709), 0xBBGGRR. */
static uint32_t grey(uint32_t colour) {
    float light = 0.2126f * (float)(colour & 255) + 0.7152f * (float)(colour >> 8 & 255) +
                  0.0722f * (float)(colour >> 16 & 255);
    return sph_linear_byte(light, SPH_TRANSFER_SRGB) * 0x010101u;
}

static size_t pixels_of(const struct sph_frame *frame) {
    return (size_t)frame->width * (size_t)frame->height;
}

static int draw(const char *path, struct sph_frame *frame, struct sph_error *err) {
    static const uint32_t red = 0x0000ff, orange = 0x00a0ff;
    for (size_t i = 0; i < pixels_of(frame); i++) {
        struct sph_pixel *p = &frame->pixels[i];
        int f32 = p->visits >> FLOAT_32 & 1, f64 = p->visits >> FLOAT_64 & 1;
        p->colour[0] = f64 ? orange : f32 ? red : grey(p->colour[0]);
    }
    return sph_image_write(path, frame, 0, err);
}

static int count(const struct sph_machine *m, const struct arguments *a, struct sph_error *err) {
    struct sph_frame frame = {m->regs[SPH_REG_FRAME_W], m->regs[SPH_REG_FRAME_H], NULL};
    struct float_tally tally;
    if (a->picture) {
        frame.pixels = calloc(pixels_of(&frame), sizeof *frame.pixels);
        if (!frame.pixels) return sph_fail(err, "%s: no memory for the picture", a->picture);
    }
    int rc = float_count(m, a->picture ? &frame : NULL, &tally, err);
    if (!rc && a->picture) rc = draw(a->picture, &frame, err);
    sph_frame_free(&frame);
    if (rc) return -1;
    print_floats(print_stream(a->json), &tally);
    json_t *report = report_new("floats");
    report_text(report, "input", a->input);
    report_floats(report, &tally);
    return report_write(report, a->json, err);
}

int tool_floats(int argc, char **argv) {
    static const struct argp_child children[] = {{&tool_source_argp, 0, NULL, 1}, {0}};
    static const struct argp argp = {
        options,
        parse,
        "SCENE|MACHINE.sph",
        "Traces a scene and makes each test of its rays again in float32 and float64.\v"
        "The model traces the rays and decides each test in exact integers. Textbook formulas "
        "(quadratic equation; Moeller and Trumbore) get the same integers. `all` counts what there "
        "is, the lines of floats what they have wrong: rays that meet another primitive or another "
        "light, hits instead of misses or the reverse, roots that are off by more than the model's "
        "rounding, pairs of hits of a ray in the other order, and pairs that are said to be "
        "equally far away. Hits of equal keys (equal) are never wrong. Tests of what a ray starts "
        "on (rules) are decided without arithmetic, and the floats are told.",
        children,
        NULL,
        NULL};
    struct arguments a = {.source = tool_source_default};
    struct tool_built built;
    struct sph_error err = {""};
    tool_parse(&argp, argc, argv, 0, &a);

    if (tool_load(a.input, &a.source, &built, &err)) return tool_failed(&err);
    int rc = count(&built.machine, &a, &err);
    sph_machine_free(&built.machine);
    return rc ? tool_failed(&err) : TOOL_GOOD;
}
