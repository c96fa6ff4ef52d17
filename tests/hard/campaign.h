/* campaign.h - many cases in many processes, resumable
 * SPDX-License-Identifier: Apache-2.0
 *
 * Work is cut into chunks, each a function of the plan and its number alone: slices of the
 * exhaustive part, then blocks of generated cases, all families and profiles in turn.
 */
#ifndef HARD_CAMPAIGN_H
#define HARD_CAMPAIGN_H

#include "common/error.h"
#include "hard.h"

enum { HARD_BLOCK = 1 << 16, HARD_NAIVE_SHARE = 64 /* one in so many in GMP as well */ };
enum { HARD_ROWS = HARD_FAMILIES * SPH_PROFILES + 1 };

struct campaign {
    uint64_t seed, cases; /* a profile */
    uint64_t first;       /* number of the first case of a family: to spread a campaign */
    uint64_t share;       /* one in so many of the exhaustive part; 0: none of it */
    uint64_t chunks;      /* most chunks of this run; the rest is left for the next */
    uint64_t part, parts; /* of all chunks each parts-th, from number part: for many machines */
    int family, families; /* the first one, and how many */
    int profile;          /* -1: all */
    int processes;
    const char *state; /* file, or NULL */
    const char *program;
    /* result: row family * SPH_PROFILES + profile, the last one exhaustive */
    struct hard_tally row[HARD_ROWS];
    double seconds; /* of this run */
    uint64_t done;  /* cases of this run */
};

/* Runs what the state file does not have yet; shows progress on a terminal. 0; 1 if chunks are
 * left for another run; or -1 with a message: state file of another plan or not writable, a process
 * that ended early. */
int campaign_run(struct campaign *c, struct sph_error *err);

/* Puts the state files of parts of this plan together as c->state. 0, or -1 with a message: a file
 * that is missing, damaged, of another plan, or has a chunk that one before it has. */
int campaign_merge(struct campaign *c, char *const *files, int n, struct sph_error *err);

/* Chunks of the plan. */
uint64_t campaign_chunks(const struct campaign *c);

/* Cases of each family that the plan asks for. */
uint64_t campaign_family_cases(const struct campaign *c);

/* ---- state file (campaign.c) ---- */

/* Reads done[0..chunks-1] and the rows. 0; 1 if there is no such file; -1 with a message. */
int campaign_load(struct campaign *c, uint8_t *done, uint64_t chunks, struct sph_error *err);

/* Writes them to a temporary name, then renames. */
int campaign_save(const struct campaign *c, const uint8_t *done, uint64_t chunks,
                  struct sph_error *err);

/* ---- report (report.c) ---- */

void report_table(const struct campaign *c, FILE *out);
int report_json(const struct campaign *c, const char *path, struct sph_error *err);

#endif
