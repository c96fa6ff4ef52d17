/* report.c - what came of a campaign, as a table and as JSON; see campaign.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <jansson.h>
#include <string.h>

#include "campaign.h"
#include "common/file.h"

/* "hit/root/order, worst error" of a formula; `-` where nothing is wrong. */
static void cell(FILE *out, const struct hard_column *column) {
    char text[96];
    snprintf(text, sizeof text, "%lu/%lu/%lu", column->hit, column->root, column->order);
    if (!strcmp(text, "0/0/0")) strcpy(text, "0");
    size_t used = strlen(text);
    if (column->worst > 0) snprintf(text + used, sizeof text - used, ", %.2g", column->worst);
    fprintf(out, " %-26s |", text);
}

/* of: the kind of its cases, -1: of all kinds. */
static void line(FILE *out, const char *family, const char *profile, int of,
                 const struct hard_tally *t) {
    const struct hard_column *ours = &t->column[HARD_OURS];
    uint64_t other = 0;
    for (int i = 0; i < HARD_CHECKS; i++)
        if (i != HARD_HIT && i != HARD_FAR && i != HARD_ORDER) other += t->wrong[i];
    fprintf(out, "| %-10s | %-9s | %10lu | %10lu | %lu/%lu/%lu | %lu | %-6.3g | %-8.6f |", family,
            profile, t->cases, t->hits, ours->hit, t->wrong[HARD_FAR], t->wrong[HARD_ORDER], other,
            ours->worst, t->bound);
    for (int i = HARD_OURS + 1; i < HARD_COLUMNS; i++)
        if (of < 0 || hard_column_is_of(i, of))
            cell(out, &t->column[i]);
        else
            fprintf(out, " %-26s |", "-");
    fprintf(out, "\n");
}

void report_table(const struct campaign *c, FILE *out) {
    struct hard_tally sum = {0};
    fprintf(out, "| family | profile | cases | hits | wrong | other | worst t | of bound |");
    for (int i = HARD_OURS + 1; i < HARD_COLUMNS; i++)
        fprintf(out, " %s |", hard_columns[i]);
    fprintf(out, "\n|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (int i = HARD_ROWS - 1, n = 0; n < HARD_ROWS; n++, i = n - 1) {
        const struct hard_tally *t = &c->row[i];
        if (!t->cases) continue;
        if (i == HARD_ROWS - 1)
            line(out, "3 bits", "draft", HARD_SPHERES, t);
        else
            line(out, hard_families[i / SPH_PROFILES].name, sph_profiles[i % SPH_PROFILES].name,
                 hard_families[i / SPH_PROFILES].of, t);
        hard_tally_add(&sum, t);
    }
    line(out, "all", "", -1, &sum);
}

static json_t *column_json(const struct hard_column *c) {
    return json_pack("{s:I, s:I, s:I, s:I, s:f}", "wrong_hit", (json_int_t)c->hit, "wrong_root",
                     (json_int_t)c->root, "wrong_order", (json_int_t)c->order, "wrong_tie",
                     (json_int_t)c->tie, "worst_t", c->worst);
}

static json_t *row_json(int i, const struct hard_tally *t) {
    int exhaustive = i == HARD_ROWS - 1;
    json_t *formulas = json_object(), *wrong = json_object();
    for (int j = 0; j < HARD_COLUMNS; j++)
        json_object_set_new(formulas, hard_columns[j], column_json(&t->column[j]));
    for (int j = 0; j < HARD_CHECKS; j++)
        json_object_set_new(wrong, hard_checks[j], json_integer((json_int_t)t->wrong[j]));
    return json_pack("{s:s, s:s, s:I, s:I, s:I, s:I, s:I, s:I, s:f, s:o, s:o}", "family",
                     exhaustive ? "exhaustive" : hard_families[i / SPH_PROFILES].name, "profile",
                     sph_profiles[exhaustive ? SPH_DRAFT : i % SPH_PROFILES].name, "cases",
                     (json_int_t)t->cases, "hits", (json_int_t)t->hits, "pairs",
                     (json_int_t)t->pairs, "points", (json_int_t)t->points, "filtered",
                     (json_int_t)t->filtered, "naive", (json_int_t)t->naive, "of_bound", t->bound,
                     "wrong", wrong, "formulas", formulas);
}

int report_json(const struct campaign *c, const char *path, struct sph_error *err) {
    struct sph_output out;
    json_t *rows = json_array();
    for (int i = 0; i < HARD_ROWS; i++)
        if (c->row[i].cases) json_array_append_new(rows, row_json(i, &c->row[i]));
    json_t *all =
        json_pack("{s:I, s:I, s:I, s:f, s:I, s:o}", "seed", (json_int_t)c->seed, "cases_a_profile",
                  (json_int_t)c->cases, "first", (json_int_t)c->first, "seconds", c->seconds,
                  "cases_of_this_run", (json_int_t)c->done, "rows", rows);
    int rc = sph_output_open(&out, path, err);
    if (!rc) {
        int bad = json_dumpf(all, out.file, JSON_INDENT(1));
        if (bad && !ferror(out.file)) sph_fail(err, "%s: no memory", path);
        rc = sph_output_close(&out, bad && !ferror(out.file), err);
    }
    json_decref(all);
    return rc;
}
