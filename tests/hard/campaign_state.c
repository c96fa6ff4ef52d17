/* campaign_state.c - the state file of a campaign: text, one row a line; see campaign.h
 * SPDX-License-Identifier: Apache-2.0
 *
 *   hard-state 1
 *   plan SEED CASES FIRST SHARE FAMILY FAMILIES PROFILE CHUNKS
 *   done 4 chunks a digit, hexadecimal
 *   row ...   counts in the order of struct hard_tally, errors as hexadecimal floating point
 *   end
 */
#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "campaign.h"

static const char plan_format[] =
    "plan %" PRIu64 " %" PRIu64 " %" PRIu64 " %" PRIu64 " %d %d %d %" PRIu64;

static void plan_of(const struct campaign *c, uint64_t chunks, char *text, size_t size) {
    snprintf(text, size, plan_format, c->seed, c->cases, c->first, c->share, c->family, c->families,
             c->profile, chunks);
}

/* The counts of a tally, in order. */
enum { COUNTS = 6 + HARD_CHECKS + 4 * HARD_COLUMNS };
static void counts_of(struct hard_tally *t, uint64_t *at[COUNTS]) {
    int n = 0;
    uint64_t *head[] = {&t->cases, &t->hits, &t->pairs, &t->naive, &t->points, &t->filtered};
    for (int i = 0; i < 6; i++)
        at[n++] = head[i];
    for (int i = 0; i < HARD_CHECKS; i++)
        at[n++] = &t->wrong[i];
    for (int i = 0; i < HARD_COLUMNS; i++) {
        at[n++] = &t->column[i].hit;
        at[n++] = &t->column[i].root;
        at[n++] = &t->column[i].order;
        at[n++] = &t->column[i].tie;
    }
}

int campaign_save(const struct campaign *c, const uint8_t *done, uint64_t chunks,
                  struct sph_error *err) {
    char plan[256], name[4096];
    plan_of(c, chunks, plan, sizeof plan);
    snprintf(name, sizeof name, "%s.new", c->state);
    FILE *f = fopen(name, "w");
    if (!f) return sph_fail(err, "%s: %s", name, strerror(errno));
    fprintf(f, "hard-state 1\n%s\ndone ", plan);
    for (uint64_t i = 0; i < chunks; i += 4) {
        int digit = 0;
        for (uint64_t j = i; j < i + 4 && j < chunks; j++)
            digit |= done[j] << (j - i);
        fputc("0123456789abcdef"[digit], f);
    }
    for (int i = 0; i < HARD_ROWS; i++) {
        struct hard_tally t = c->row[i];
        uint64_t *at[COUNTS];
        counts_of(&t, at);
        fprintf(f, "\nrow");
        for (int j = 0; j < COUNTS; j++)
            fprintf(f, " %" PRIu64, *at[j]);
        for (int j = 0; j < HARD_COLUMNS; j++)
            fprintf(f, " %a", t.column[j].worst);
        fprintf(f, " %a", t.bound);
    }
    fprintf(f, "\nend\n");
    int bad = ferror(f);
    if (fclose(f) || bad) return sph_fail(err, "%s: %s", name, strerror(errno));
    if (rename(name, c->state)) return sph_fail(err, "%s: %s", c->state, strerror(errno));
    return 0;
}

/* Reads "done" and the rows. 0 if anything is missing. */
static int read_body(FILE *f, struct campaign *c, uint8_t *done, uint64_t chunks) {
    char word[8];
    if (fscanf(f, " done ") != 0) return 0;
    for (uint64_t i = 0; i < chunks; i += 4) {
        int digit = fgetc(f);
        if (digit == EOF || !strchr("0123456789abcdef", digit)) return 0;
        digit = digit <= '9' ? digit - '0' : digit - 'a' + 10;
        for (uint64_t j = i; j < i + 4 && j < chunks; j++)
            done[j] = (uint8_t)(digit >> (j - i) & 1);
    }
    for (int i = 0; i < HARD_ROWS; i++) {
        struct hard_tally *t = &c->row[i];
        uint64_t *at[COUNTS];
        counts_of(t, at);
        if (fscanf(f, " %7s", word) != 1 || strcmp(word, "row") != 0) return 0;
        for (int j = 0; j < COUNTS; j++)
            if (fscanf(f, " %" SCNu64, at[j]) != 1) return 0;
        for (int j = 0; j < HARD_COLUMNS; j++)
            if (fscanf(f, " %la", &t->column[j].worst) != 1) return 0;
        if (fscanf(f, " %la", &t->bound) != 1) return 0;
    }
    return fscanf(f, " %7s", word) == 1 && !strcmp(word, "end");
}

int campaign_load(struct campaign *c, uint8_t *done, uint64_t chunks, struct sph_error *err) {
    char line[256], plan[256];
    FILE *f = fopen(c->state, "r");
    if (!f && errno == ENOENT) return 1;
    if (!f) return sph_fail(err, "%s: %s", c->state, strerror(errno));
    plan_of(c, chunks, plan, sizeof plan);
    if (!fgets(line, sizeof line, f) || strcmp(line, "hard-state 1\n") != 0) {
        fclose(f);
        return sph_fail(err, "%s:1: not a state file of this program", c->state);
    }
    if (!fgets(line, sizeof line, f) || strncmp(line, plan, strlen(plan)) != 0 ||
        line[strlen(plan)] != '\n') {
        fclose(f);
        return sph_fail(err,
                        "%s:2: of another campaign: seed, cases, first, share, family or "
                        "profile differ",
                        c->state);
    }
    int whole = read_body(f, c, done, chunks);
    fclose(f);
    return whole ? 0 : sph_fail(err, "%s: damaged", c->state);
}
