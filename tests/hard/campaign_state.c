/* campaign_state.c - the state file of a campaign: text, one row a line; see campaign.h
 * SPDX-License-Identifier: Apache-2.0
 *
 *   hard-state 2
 *   plan SEED CASES FIRST SHARE FAMILY FAMILIES PROFILE CHUNKS
 *   done 4 chunks a digit, hexadecimal
 *   row ...   counts in the order of struct hard_tally, errors with 17 digits
 *   end
 */
#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "campaign.h"
#include "common/number.h"
#include "common/file.h"

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
    char plan[256];
    struct sph_output out;
    plan_of(c, chunks, plan, sizeof plan);
    if (sph_output_open(&out, c->state, err)) return -1;
    FILE *f = out.file;
    fprintf(f, "hard-state 2\n%s\ndone ", plan);
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
            fprintf(f, " %.17g", t.column[j].worst);
        fprintf(f, " %.17g", t.bound);
    }
    fprintf(f, "\nend\n");
    return sph_output_close(&out, 0, err);
}

/* The next word of a row, a number. 0 if it is none. */
static int next_count(char **rest, uint64_t *value) {
    const char *word = strtok_r(NULL, " \n", rest);
    return word && !sph_parse_count(word, 0, UINT64_MAX, value);
}
static int next_real(char **rest, double *value) {
    const char *word = strtok_r(NULL, " \n", rest);
    return word && !sph_parse_number(word, value);
}

/* Reads a row: a line. 0 if anything is missing. */
static int read_row(char *line, struct hard_tally *t) {
    char *rest = line;
    const char *word = strtok_r(NULL, " \n", &rest);
    uint64_t *at[COUNTS];
    counts_of(t, at);
    if (!word || strcmp(word, "row") != 0) return 0;
    for (int j = 0; j < COUNTS; j++)
        if (!next_count(&rest, at[j])) return 0;
    for (int j = 0; j < HARD_COLUMNS; j++)
        if (!next_real(&rest, &t->column[j].worst)) return 0;
    return next_real(&rest, &t->bound) && !strtok_r(NULL, " \n", &rest);
}

/* Reads "done" and the rows. 0 if anything is missing. */
static int read_body(FILE *f, struct campaign *c, uint8_t *done, uint64_t chunks) {
    char *line = NULL;
    size_t room = 0;
    int whole =
        fgetc(f) == 'd' && fgetc(f) == 'o' && fgetc(f) == 'n' && fgetc(f) == 'e' && fgetc(f) == ' ';
    for (uint64_t i = 0; i < chunks && whole; i += 4) {
        int digit = fgetc(f);
        if (digit == EOF || !strchr("0123456789abcdef", digit)) return 0;
        digit = digit <= '9' ? digit - '0' : digit - 'a' + 10;
        for (uint64_t j = i; j < i + 4 && j < chunks; j++)
            done[j] = (uint8_t)(digit >> (j - i) & 1);
    }
    whole = whole && fgetc(f) == '\n';
    for (int i = 0; i < HARD_ROWS && whole; i++)
        whole = getline(&line, &room, f) > 0 && read_row(line, &c->row[i]);
    whole = whole && getline(&line, &room, f) > 0 && !strcmp(line, "end\n");
    free(line);
    return whole;
}

int campaign_load(struct campaign *c, uint8_t *done, uint64_t chunks, struct sph_error *err) {
    char line[256], plan[256];
    FILE *f = fopen(c->state, "r");
    if (!f && errno == ENOENT) return 1;
    if (!f) return sph_fail(err, "%s: %s", c->state, strerror(errno));
    plan_of(c, chunks, plan, sizeof plan);
    if (!fgets(line, sizeof line, f) || strcmp(line, "hard-state 2\n") != 0) {
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
