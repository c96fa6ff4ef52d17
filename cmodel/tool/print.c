/* print.c - see print.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "tool/print.h"

#include <inttypes.h>
#include <string.h>

#include "tool/outputs.h"
#include "tool/report.h"
#include "validate/describe.h"
#include "validate/prims.h"

FILE *print_stream(const char *json_path) {
    return json_path && !strcmp(json_path, "-") ? NULL : tool_text();
}

/* Each line of text after a head. */
static void print_lines(FILE *to, const char *head, const char *text) {
    while (*text) {
        size_t length = strcspn(text, "\n");
        if (length) fprintf(to, "%s%.*s\n", head, (int)length, text);
        text += length + (text[length] != 0);
    }
}

void print_ledger(const struct sph_ledger *ledger) {
    sph_ledger_print(ledger, SPH_USED_OTHERWISE, "sphaera: warning: ", stderr);
}

/* One line for each effect: what the machine has of it, and why. */
static void print_effects(FILE *to, const struct sph_build_report *b) {
    for (int i = 0; i < SPH_REPORTS; i++) {
        const struct sph_effect_report *e = &b->effects[i];
        char on[16];
        snprintf(on, sizeof on, sph_parts[i].most > 1 ? "%d" : "on", e->on);
        fprintf(to, "effect   %-14s %-3s %s%s\n", e->name, e->on ? on : "off",
                e->left_out && !e->on ? "left out: " : "", e->why);
    }
}

void print_left_out(FILE *to, const struct sph_build_report *b) {
    if (!to) return;
    for (int i = 0; i < SPH_REPORTS; i++)
        if (b->effects[i].left_out)
            fprintf(to, "left out %s: %s\n", b->effects[i].name, b->effects[i].why);
    print_lines(to, "left out ", b->left_out);
}

void print_build(FILE *to, const struct tool_built *built) {
    const struct sph_build_report *b = &built->report;
    const struct sph_machine *m = &built->machine;
    const int32_t *r = m->regs;
    if (built->from_scene) print_ledger(&b->ledger);
    if (built->from_scene && b->warning[0]) print_lines(stderr, "sphaera: warning: ", b->warning);
    if (!to) return;
    struct sph_counts n = sph_machine_count(m);
    char text[256];
    sph_counts_text(&n, text, sizeof text);
    fprintf(to, "scene    %s: %s, %d lights, %dx%d, profile %s\n", m->name, text,
            r[SPH_REG_N_LIGHTS], r[SPH_REG_FRAME_W], r[SPH_REG_FRAME_H],
            sph_machine_profile(m)->name);
    if (!built->from_scene) return;
    if (built->profile_why[0]) fprintf(to, "profile  %s\n", built->profile_why);
    fprintf(to, "grid     step %g, smallest radius %.4g steps, field of view off by %.2g\n",
            b->grid_step, b->smallest_radius, b->fov_error);
    fprintf(to, "tree     %s: %u nodes on %u levels, %.3f s%s%s\n", sph_machine_tree_name(m),
            b->nodes, b->depth, b->build_seconds, b->tree_why[0] ? ", " : "", b->tree_why);
    print_effects(to, b);
    print_lines(to, "left out ", b->left_out);
    if (b->bases_computed)
        fprintf(to, "bases    %" PRIu64 " made: levels of textured primitives\n",
                b->bases_computed);
    print_lines(to, "backgr.  ", b->background);
    fprintf(to, "memory   %u lines, %" PRIu64 " bytes\n", m->lines,
            (uint64_t)m->lines * SPH_LINE_WORDS * 4);
}

void print_shot(FILE *to, const struct sph_shot *shot, int counters) {
    static const char *const names[] = {SPH_COUNTER_NAMES}, *const errors[] = {SPH_ERROR_NAMES};
    if (!to) return;
    if (counters)
        for (int i = 0; i < SPH_COUNTERS; i++)
            if (sph_counter_both(i))
                fprintf(to, "%-16s %12" PRIu64 "\n", names[i], shot->counters.count[i]);
    struct sph_hashes hashes = sph_frame_hashes(&shot->frame);
    fprintf(to, "errors ");
    for (int i = 0; i < SPH_ERRORS; i++)
        if (shot->errors >> i & 1) fprintf(to, " %s", errors[i]);
    fprintf(to, "%s\npicture %016" PRIx64 "\nframe   %016" PRIx64 "\n", shot->errors ? "" : " none",
            hashes.picture, hashes.frame);
}

static double mean(uint64_t sum, uint32_t n) {
    return n ? (double)sum / n : 0;
}

void print_bih(FILE *to, const struct sph_machine *m, const struct sph_bih_stats *s) {
    if (!to) return;
    fprintf(to, "nodes    %u inner, %u leaves, %u optimized\n", s->inner, s->leaves, s->optimized);
    fprintf(to, "prims    of a leaf: %u least, %.2f mean, %u most\n", s->prims_min,
            mean(s->prims_sum, s->leaves), s->prims_max);
    fprintf(to, "levels   of leaves: %u least, %.2f mean, %u most\n", s->depth_min,
            mean(s->depth_sum, s->leaves), s->depth_max);
    fprintf(to, "leaves   with N primitives:");
    for (int i = 0; i < SPH_BIH_BARS; i++)
        fprintf(to, " %s %d: %.2f %%", i < SPH_BIH_BARS - 1 ? "N =" : "N >",
                i < SPH_BIH_BARS - 1 ? i : i - 1, 100 * mean(s->bars[i], s->leaves));
    fprintf(to,
            "\nbytes    %" PRIu64 " (12 a node, 4 a primitive, 24); here %" PRIu64
            " of nodes and %" PRIu64 " of leaf records\n",
            sph_bih_bytes(s), sph_bih_node_bytes(m), sph_bih_record_bytes(m));
}

void report_bih(json_t *report, const struct sph_machine *m, const struct sph_bih_stats *s) {
    if (!report) return;
    json_t *bih = json_object(), *bars = json_array();
    report_count(bih, "inner", s->inner);
    report_count(bih, "leaves", s->leaves);
    report_count(bih, "optimized", s->optimized);
    report_count(bih, "prims_min", s->prims_min);
    report_number(bih, "prims_mean", mean(s->prims_sum, s->leaves));
    report_count(bih, "prims_max", s->prims_max);
    report_count(bih, "depth_min", s->depth_min);
    report_number(bih, "depth_mean", mean(s->depth_sum, s->leaves));
    report_count(bih, "depth_max", s->depth_max);
    for (int i = 0; i < SPH_BIH_BARS; i++)
        json_array_append_new(bars, json_integer(s->bars[i]));
    json_object_set_new(bih, "leaves_by_prims", bars);
    report_count(bih, "bytes", sph_bih_bytes(s));
    report_count(bih, "node_bytes", sph_bih_node_bytes(m));
    report_count(bih, "record_bytes", sph_bih_record_bytes(m));
    json_object_set_new(report, "bih", bih);
}
