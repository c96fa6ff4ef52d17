/* cmd_price.c - `sphaera price`: what accuracy costs in time, a row a profile
 * SPDX-License-Identifier: Apache-2.0
 */
#include <inttypes.h>
#include <math.h>

#include "image/mips.h"
#include "tool/print.h"
#include "tool/report.h"
#include "trial/price.h"

struct arguments {
    struct tool_report_arguments report;
    uint32_t most;
    int more, threads;
};

enum { KEY_MORE = 512, KEY_PIXELS, KEY_JSON };
enum { MOST = 1 << 28 }; /* pixels */

static const struct argp_option options[] = {
    {"more", KEY_MORE, NULL, 0,
     "a row for each single knob that pays: fewer bits of W, PQ or PR, two pipes, trees of spheres "
     "and boxes, BIH",
     0},
    {"pixels", KEY_PIXELS, "N", 0,
     "of a larger frame about so many pixels are looked at (524288); 0: all", 0},
    {"threads", 't', "N", 0, "0: one for every processor (default)", 0},
    {"json", KEY_JSON, "FILE", 0, "report as JSON (- : on standard output instead of text)", 0},
    {0},
};

static error_t parse(int key, char *arg, struct argp_state *state) {
    struct arguments *a = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &a->report.source;
        return 0;
    case KEY_MORE:
        a->more = 1;
        return 0;
    case KEY_PIXELS:
        a->most = (uint32_t)tool_number(state, "--pixels", arg, 0, MOST);
        return 0;
    case 't':
        a->threads = (int)tool_number(state, "--threads", arg, 0, 1024);
        return 0;
    case KEY_JSON:
        a->report.json = tool_output(&a->report.source.outputs, key, arg);
        return 0;
    default:
        return tool_one_scene(state, key, arg, &a->report.input, "no scene given");
    }
}

/* ---- as text ---- */

/* A number, - if it is not known (0); ~ before one that is estimated. */
static const char *or_none(char text[16], const char *form, double value, int estimated) {
    text[0] = '~';
    snprintf(text + estimated, (size_t)(16 - estimated), value > 0 ? form : "-", value);
    return text + (estimated && !(value > 0));
}

static void print_row(FILE *to, const struct sph_price *p, int i) {
    const struct sph_price_row *r = &p->row[i];
    const struct sph_known_core *k = &r->known;
    char cell[7][16];
    fprintf(to, "%c %-28s ", i == p->best ? '*' : ' ', r->name);
    if (!r->built) {
        fprintf(to, "%s\n", r->why);
        return;
    }
    fprintf(to, "%7.2f %8s %6" PRIu64 " %6" PRIu64 " %8.2f %7s %5s %4s %6s %9s %7s\n",
            r->accuracy.image.psnr[SPH_FRAMES - 1],
            or_none(cell[0], "%.2f", r->expected.fits ? r->expected.psnr : 0, 0), r->wrong,
            r->accuracy.image.undecidable, r->cycles.pixel,
            or_none(cell[1], "%.0f", k->lut4eq, k->cells_estimated),
            or_none(cell[2], "%.0f", k->mult, k->cells_estimated),
            or_none(cell[3], "%.0f", k->bram, k->cells_estimated),
            or_none(cell[4], "%.1f", k->median, k->clock_estimated),
            or_none(cell[5], "%.3f", r->milliseconds, k->clock_estimated),
            or_none(cell[6], "%.1f", r->energy.pixel, 1));
}

/* What the figures are worth, of rows alike once. */
static void print_notes(FILE *to, const struct sph_price *p) {
    const struct sph_price_row *sure = NULL;
    int cells = 0, clock = 0, estimated = 0, energy = 0;
    for (int i = 0; i < p->n; i++) {
        const struct sph_price_row *r = &p->row[i];
        if (!r->built) continue;
        sure = r;
        cells += !r->known.lut4eq;
        clock += !(r->known.median > 0);
        energy += r->energy.pixel > 0;
        estimated += r->known.cells_estimated || r->known.clock_estimated;
    }
    if (!sure) return;
    if (p->sampled)
        fprintf(to,
                "sample: %" PRIu64 " pixels of %" PRIu64 "; wrong in the whole frame are at most "
                "%.3g %% of %s\n",
                sure->accuracy.image.pixels, (uint64_t)p->width * (uint64_t)p->height,
                100 * sure->wrong_most, sure->name);
    fprintf(to, "cycles: by the model's counters, not simulated: within 7 %% of the RTL, 25 %% for "
                "texels that bind (make price RTL=1 measures them)\n");
    for (int i = 0; i < p->n; i++) {
        const struct sph_known_core *k = &p->row[i].known;
        if (k->seeds)
            fprintf(to, "clock:  %s %.1f to %.1f MHz, %d seed%s\n", p->row[i].name, k->worst,
                    k->best, k->seeds, k->seeds > 1 ? "s" : "");
    }
    if (estimated)
        fprintf(to, "~:      estimated: cells from cores that differ in some words, mostly within "
                    "5 %%; the clock is that of the nearest core that was routed\n");
    if (cells) fprintf(to, "cells -: nobody has synthesised that core; make price does\n");
    if (clock) fprintf(to, "clock -: nobody has routed that core; make study-seeds does\n");
    fprintf(to, energy ? "energy: as standard cells of 0.18 um, from events that were fitted to "
                         "netlists, within 10 %% (make silicon measures it)\n"
                       : "energy: not known of such a core (make silicon measures it)\n");
    if (p->tried[0]) fprintf(to, "does not pay: %s\n", p->tried);
}

static void print(FILE *to, const char *input, const struct sph_price *p,
                  const struct sph_error_bound *bound) {
    char says[1024];
    if (!to) return;
    fprintf(to, "%s, %dx%d\n", input, p->width, p->height);
    fprintf(to, "  %-28s %7s %8s %6s %6s %8s %7s %5s %4s %6s %9s %7s\n", "", "dB", "expected",
            "wrong", "undec.", "cycles/p", "LUT4eq", "MULT", "RAM", "MHz", "ms/frame", "nJ/p");
    for (int i = 0; i < p->n; i++)
        print_row(to, p, i);
    print_notes(to, p);
    sph_price_says(p, bound, says, sizeof says);
    fprintf(to, "%s\n", says);
}

/* ---- as JSON ---- */

static json_t *number_or_null(double value) {
    return isfinite(value) ? json_real(value) : json_null();
}

static json_t *measured_json(const struct sph_price_row *r) {
    json_t *json = json_object();
    report_add(json, "psnr", number_or_null(r->accuracy.image.psnr[SPH_FRAMES - 1]));
    report_add(json, "psnr_least", number_or_null(r->psnr_least));
    report_count(json, "pixels", r->accuracy.image.pixels);
    report_count(json, "undecidable", r->accuracy.image.undecidable);
    report_count(json, "wrong", r->wrong);
    report_number(json, "wrong_most", r->wrong_most);
    report_count(json, "shadow", r->accuracy.shadow);
    report_count(json, "reflected", r->accuracy.reflected);
    report_count(json, "refracted", r->accuracy.refracted);
    return json;
}

static json_t *energy_json(const struct sph_energy *e) {
    if (!(e->pixel > 0)) return json_null();
    json_t *json = json_object(), *parts = json_object();
    report_number(json, "nj_pixel", e->pixel);
    report_add(json, "parts", parts);
    for (int i = 0; i < e->parts; i++)
        report_number(parts, e->part[i].name, e->part[i].pixel);
    return json;
}

static json_t *row_json(const struct sph_price_row *r) {
    const struct sph_known_core *k = &r->known;
    json_t *json = json_object();
    report_text(json, "name", r->name);
    report_text(json, "profile", r->profile.name);
    report_add(json, "why", r->built ? json_null() : json_string(r->why));
    report_add(json, "expected",
               r->expected.fits
                   ? json_pack("{s:o, s:f, s:f}", "psnr", number_or_null(r->expected.psnr),
                               "pixels", r->expected.pixels, "wrong", r->expected.wrong)
                   : json_null());
    if (!r->built) return json;
    report_add(json, "measured", measured_json(r));
    report_add(json, "keeps", json_boolean(r->keeps));
    report_text(json, "tree", r->tree);
    report_text(json, "core", r->core);
    report_count(json, "pipes", (uint64_t)r->sizes.PIPES);
    report_number(json, "cycles_per_pixel", r->cycles.pixel);
    report_add(json, "limit",
               r->cycles.most < 0 ? json_null()
                                  : json_pack("{s:s, s:f}", "unit", sph_load_name(r->cycles.most),
                                              "share", r->cycles.binds[r->cycles.most]));
    report_add(json, "cells",
               k->lut4eq ? json_pack("{s:i, s:i, s:i, s:b}", "lut4eq", k->lut4eq, "mult", k->mult,
                                     "bram", k->bram, "estimated", k->cells_estimated)
                         : json_null());
    report_add(json, "clock",
               k->median > 0
                   ? json_pack("{s:f, s:f, s:f, s:i, s:b}", "worst", k->worst, "median", k->median,
                               "best", k->best, "seeds", k->seeds, "estimated", k->clock_estimated)
                   : json_null());
    report_add(json, "milliseconds", k->median > 0 ? json_real(r->milliseconds) : json_null());
    report_add(json, "energy", energy_json(&r->energy));
    return json;
}

static json_t *price_json(const char *input, const struct sph_price *p,
                          const struct sph_error_bound *bound) {
    char says[1024];
    json_t *report = report_new("price"), *price = json_object(), *rows = json_array();
    report_text(report, "input", input);
    report_add(report, "price", price);
    report_count(price, "width", (uint64_t)p->width);
    report_count(price, "height", (uint64_t)p->height);
    report_add(price, "sampled", json_boolean(p->sampled));
    report_add(price, "keep",
               json_pack("{s:f, s:f}", "pixels", bound->pixels, "psnr", bound->psnr));
    for (int i = 0; i < p->n; i++)
        json_array_append_new(rows, row_json(&p->row[i]));
    report_add(price, "rows", rows);
    report_add(price, "best", p->best < 0 ? json_null() : json_integer(p->best));
    sph_price_says(p, bound, says, sizeof says);
    report_text(price, "says", says);
    report_text(price, "tried", p->tried);
    return report;
}

static int price(const struct arguments *a, const struct sph_scene *scene,
                 const struct sph_mip *mips, struct sph_error *err) {
    const struct tool_source *s = &a->report.source;
    struct sph_build_options build = s->build;
    struct sph_price p;
    struct sph_price_options o = {.bound = s->bound,
                                  .only = s->build.widths,
                                  .most = a->most,
                                  .more = a->more,
                                  .met = s->effects == TOOL_EFFECTS_MET,
                                  .threads = a->threads};
    build.mips = mips;
    if (tool_frame_size(s, scene, &build, err) || sph_price_make(scene, &build, &o, &p, err))
        return -1;
    print(print_stream(a->report.json), a->report.input, &p, &o.bound);
    return report_write(price_json(a->report.input, &p, &o.bound), a->report.json, err);
}

int tool_price(int argc, char **argv) {
    static const struct argp_child children[] = {{&tool_source_argp, 0, NULL, 1}, {0}};
    static const struct argp argp = {
        options,
        parse,
        "SCENE",
        "What accuracy costs in time: a row for each profile, for this scene, size and camera.\v"
        "dB and pixels that see a wrong object (or one where there is none) are measured against "
        "the scene as it is written, in double precision, where doubles can tell (undec.: where "
        "they cannot); expected: what `build` goes by, at least. Cycles a pixel are of one engine, "
        "from the work of the golden model; cells, clock and milliseconds are of the core "
        "that `make sim` runs, ~ if they are estimated. The first row that keeps --error is "
        "marked. "
        "--profile: a row of these widths alone.",
        children,
        NULL,
        NULL};
    struct arguments a = {.report = {.source = tool_source_default}, .most = SPH_JUDGE_PIXELS};
    struct sph_scene scene;
    struct sph_mip *mips = NULL;
    struct sph_error err = {""};
    a.report.source.effects = TOOL_EFFECTS_MET;
    tool_parse(&argp, argc, argv, 0, &a);

    const char *input = a.report.input;
    if (tool_wants_scene(input, &err) || tool_scene_read(input, &a.report.source, &scene, &err))
        return tool_failed(&err);
    int rc = a.report.source.build.texture == SPH_OFF ? 0 : sph_mips_load(&scene, &mips, &err);
    if (!rc) rc = price(&a, &scene, mips, &err);
    sph_mips_free(mips, scene.n_textures);
    sph_scene_free(&scene);
    return rc ? tool_failed(&err) : TOOL_GOOD;
}
