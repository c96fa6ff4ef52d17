/* report.c - see report.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "tool/report.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "machine/camera.h"
#include "validate/describe.h"
#include "validate/prims.h"
#include "machine/records.h"
#include "common/file.h"
#include "tool/sequence.h"

/* Of the arithmetic, bits. */
static json_t *widths(const struct sph_profile *p) {
    return json_pack("{s:i, s:i, s:i, s:i, s:i, s:i}", "W", p->w, "WD", p->wd, "PQ", p->pq, "NG",
                     p->ng, "FW", p->fw, "PR", p->pr);
}

/* Where the eye is, and how wide it sees. */
static json_t *camera(const struct sph_machine *m) {
    const int32_t *r = m->regs;
    const struct sph_machine_camera c = sph_machine_camera(m);
    double left = c.view[0] + 0.5, right = r[SPH_REG_FRAME_W] - left;
    double across = atan(left / c.screen) + atan(right / c.screen);
    return json_pack("{s:[i, i, i], s:f, s:[f, f]}", "eye", r[SPH_REG_EYE_X], r[SPH_REG_EYE_Y],
                     r[SPH_REG_EYE_Z], "degrees_across", across * 180 / acos(-1), "view_pixel",
                     c.view[0], c.view[1]);
}

void report_machine(json_t *report, const struct sph_machine *m) {
    static const char *const ways[] = {"none", "rect", "spans", "exact"};
    const int32_t *r = m->regs;
    if (!report) return;
    struct sph_counts n = sph_machine_count(m);
    json_t *machine = json_object();
    report_text(machine, "name", m->name);
    report_text(machine, "profile", sph_machine_profile(m)->name);
    report_add(machine, "widths", widths(sph_machine_profile(m)));
    report_add(machine, "camera", camera(m));
    report_text(machine, "tree", sph_machine_tree_name(m));
    report_text(machine, "background", ways[r[SPH_REG_BG_MODE]]);
    report_count(machine, "width", (uint64_t)r[SPH_REG_FRAME_W]);
    report_count(machine, "height", (uint64_t)r[SPH_REG_FRAME_H]);
    for (uint32_t kind = 0; kind < SPH_KINDS; kind++) {
        char name[32];
        snprintf(name, sizeof name, "%ss", sph_kind_name(kind));
        report_count(machine, name, n.of[kind]);
    }
    report_count(machine, "lights", (uint64_t)r[SPH_REG_N_LIGHTS]);
    report_count(machine, "max_depth", (uint64_t)r[SPH_REG_MAX_DEPTH]);
    report_count(machine, "tree_bytes", (uint64_t)r[SPH_REG_PRIM_BASE] * SPH_LINE_WORDS * 4);
    report_count(machine, "memory_bytes", (uint64_t)m->lines * SPH_LINE_WORDS * 4);
    json_t *effects = json_array();
    for (int i = 0; i < SPH_REPORTS; i++)
        if (sph_parts[i].bit >= 0 && sph_machine_effect(m, sph_parts[i].bit))
            json_array_append_new(effects, json_string(sph_parts[i].word));
    report_add(machine, "effects", effects);
    report_add(machine, "one_camera", json_boolean(sph_machine_effect(m, SPH_EFFECT_CAMERA)));
    report_number(machine, "grid_step", ldexp(1.0, m->grid_log2));
    report_add(report, "machine", machine);
}

/* The lines of text as an array of strings. */
static json_t *lines(const char *text) {
    json_t *list = json_array();
    while (*text) {
        size_t length = strcspn(text, "\n");
        if (length) json_array_append_new(list, json_stringn(text, length));
        text += length + (text[length] != 0);
    }
    return list;
}

/* Each effect: what the machine has, what the scene calls for, why. */
static json_t *effects_of(const struct sph_build_report *b) {
    json_t *list = json_array();
    for (int i = 0; i < SPH_REPORTS; i++) {
        const struct sph_effect_report *e = &b->effects[i];
        json_t *entry = json_object();
        report_text(entry, "name", e->name);
        report_count(entry, "on", (uint64_t)e->on);
        report_count(entry, "called", (uint64_t)e->called);
        report_text(entry, "why", e->why);
        report_add(entry, "left_out", json_boolean(e->left_out));
        json_array_append_new(list, entry);
    }
    return list;
}

void report_ledger(json_t *report, const struct sph_ledger *ledger) {
    json_t *list = json_array();
    for (int kind = 0; kind < SPH_READS; kind++) {
        const struct sph_ledger_row *row = &ledger->row[kind];
        if (!row->n) continue;
        json_t *entry = json_object();
        report_text(entry, "kind", sph_read_name((enum sph_read)kind));
        report_text(entry, "end", sph_read_end_name(sph_read_end((enum sph_read)kind)));
        report_count(entry, "count", row->n);
        report_text(entry, "file", row->file);
        report_add(entry, "line", row->line ? json_integer(row->line) : json_null());
        json_array_append_new(list, entry);
    }
    report_add(report, "ledger", list);
}

/* What the grid cuts off planes. */
static json_t *cut_of(const struct sph_cut *cut) {
    json_t *json = json_object();
    report_count(json, "pixels", cut->pixels);
    report_count(json, "beyond", cut->beyond);
    report_add(json, "nearest", cut->beyond ? json_real(cut->nearest) : json_null());
    report_count(json, "sample", cut->sample);
    report_count(json, "later", cut->later);
    return json;
}

/* What the picture is expected to be like. */
static json_t *expected(const struct sph_estimate *e) {
    json_t *json = json_object();
    report_number(json, "pixels", e->pixels);
    report_number(json, "wrong", e->wrong);
    report_number(json, "psnr", e->psnr);
    return json;
}

/* What it was drawn to be like. */
static json_t *measured(const struct sph_measured *m) {
    json_t *json = json_object();
    report_count(json, "pixels", m->pixels);
    report_count(json, "of", m->of);
    report_add(json, "psnr", isfinite(m->psnr) ? json_real(m->psnr) : json_null());
    report_add(json, "psnr_least",
               isfinite(m->psnr_least) ? json_real(m->psnr_least) : json_null());
    return json;
}

void report_build(json_t *report, const struct tool_built *built) {
    const struct sph_build_report *b = &built->report;
    if (!report || !built->from_scene) return;
    json_t *build = json_object();
    report_number(build, "grid_step", b->grid_step);
    report_number(build, "smallest_radius", b->smallest_radius);
    report_number(build, "fov_error", b->fov_error);
    report_count(build, "nodes", b->nodes);
    report_count(build, "depth", b->depth);
    if (b->tree_why[0]) report_text(build, "tree_why", b->tree_why);
    if (built->profile_why[0]) report_text(build, "profile_why", built->profile_why);
    const struct sph_known_picture *picture = &built->picture;
    if (picture->expected.fits) report_add(build, "expected", expected(&picture->expected));
    if (picture->measured.pixels) report_add(build, "measured", measured(&picture->measured));
    report_count(build, "skipped", sph_ledger_left_out(&b->ledger));
    report_number(build, "seconds", b->build_seconds);
    report_number(build, "tree_seconds", b->tree_seconds);
    if (sph_machine_bih(&built->machine)) report_bih(build, &built->machine, &b->bih);
    report_bases(build, b);
    if (b->cut.pixels) report_add(build, "planes_cut", cut_of(&b->cut));
    report_add(build, "effects", effects_of(b));
    report_add(build, "left_out", lines(b->left_out));
    report_add(build, "background", lines(b->background));
    report_add(build, "warnings", lines(b->warning));
    report_ledger(build, &b->ledger);
    report_add(report, "build", build);
}

void report_shot(json_t *report, const struct sph_shot *shot) {
    static const char *const counters[] = {SPH_COUNTER_NAMES}, *const errors[] = {SPH_ERROR_NAMES};
    char hash[17];
    if (!report) return;
    json_t *frame = json_object(), *counts = json_object();
    struct sph_hashes hashes = sph_frame_hashes(&shot->frame);
    snprintf(hash, sizeof hash, "%016" PRIx64, hashes.frame);
    report_count(frame, "width", (uint64_t)shot->frame.width);
    report_count(frame, "height", (uint64_t)shot->frame.height);
    report_text(frame, "hash", hash);
    snprintf(hash, sizeof hash, "%016" PRIx64, hashes.picture);
    report_text(frame, "picture_hash", hash);
    for (int i = 0; i < SPH_COUNTERS; i++)
        if (sph_counter_both(i)) report_count(counts, counters[i], shot->counters.count[i]);
    report_add(report, "frame", frame);
    report_add(report, "counters", counts);
    report_add(report, "errors", report_names(shot->errors, errors, SPH_ERRORS));
}

int report_write(json_t *report, const char *path, struct sph_error *err) {
    struct sph_output out;
    int rc = 0;
    if (path) {
        rc = sph_output_open(&out, path, err);
        if (!rc) {
            int bad = json_dumpf(report, out.file, JSON_INDENT(2) | JSON_REAL_PRECISION(17));
            if (!bad) fputc('\n', out.file);
            int lost = report_lost() || (bad && !ferror(out.file));
            rc = sph_output_close(&out, lost, err);
            if (lost) sph_fail(err, "%s: no memory for the report", path);
        }
    }
    json_decref(report);
    return rc;
}
