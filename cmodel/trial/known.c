/* known.c - see known.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "trial/known.h"

#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "trial/known_table.h"

static const struct sph_known_core cores[] = {SPH_KNOWN_CORES};
enum { CORES = sizeof cores / sizeof *cores };

/* What a word costs in profile standard; points: the first of such words brings the word "points",
 * hit points and normals. */
static const struct word {
    const char *name;
    int lut4eq, mult, bram, points;
} words[] = {SPH_KNOWN_WORDS};
enum { WORDS = sizeof words / sizeof *words };

/* The words of a list, a bit each, whatever their counts; -1: one of them has no price. */
static int64_t words_of(const char *list) {
    int64_t set = 0;
    if (!strcmp(list, "none")) return 0;
    for (size_t length; *list; list += length + (list[length] == '+')) {
        length = strcspn(list, "+");
        size_t letters = strcspn(list, "0123456789+");
        int i = 0;
        while (i < WORDS &&
               (strlen(words[i].name) != letters || strncmp(words[i].name, list, letters) != 0))
            i++;
        if (i == WORDS) return -1;
        set |= 1ll << i;
        for (int p = 0; words[i].points && p < WORDS; p++)
            if (!strcmp(words[p].name, "points")) set |= 1ll << p;
    }
    return set;
}

/* How far a set of words is from another, in LUT4eq. */
static long distance(int64_t a, int64_t b) {
    long sum = 0;
    for (int i = 0; i < WORDS; i++)
        if ((a ^ b) >> i & 1) sum += labs(words[i].lut4eq);
    return sum;
}

/* The nearest core of a profile but `but` itself; clock: of those that were routed, else of those
 * whose cells are known. NULL: none. */
static const struct sph_known_core *nearest(const char *profile, int64_t set, const char *but,
                                            int clock) {
    const struct sph_known_core *best = NULL;
    long least = 0;
    for (int i = 0; i < CORES; i++) {
        const struct sph_known_core *c = &cores[i];
        int64_t has = words_of(c->effects);
        if (c->pipes != 1 || has < 0 || strcmp(c->profile, profile) != 0) continue;
        if ((but && !strcmp(c->effects, but)) || !(clock ? c->seeds : c->lut4eq)) continue;
        long far = distance(set, has);
        if (best && far >= least) continue;
        best = c;
        least = far;
    }
    return best;
}

static const struct sph_known_core *exact(const char *profile, const char *effects, int pipes) {
    for (int i = 0; i < CORES; i++)
        if (!strcmp(cores[i].profile, profile) && !strcmp(cores[i].effects, effects) &&
            cores[i].pipes == pipes)
            return &cores[i];
    return NULL;
}

/* Estimates; but: as nearest(). */
static struct sph_known_core estimate(const char *profile, const char *effects, int pipes,
                                      const char *but) {
    struct sph_known_core e = {.profile = profile, .effects = effects, .pipes = pipes};
    int64_t set = words_of(effects);
    const struct sph_known_core *like = nearest(profile, set, but, 0);
    const struct sph_known_core *routed = nearest(profile, set, but, 1);
    if (set < 0 || pipes != 1 || !like) return e;
    const struct sph_known_core *standard = exact("standard", like->effects, 1);
    double ratio = standard && standard->lut4eq ? (double)like->lut4eq / standard->lut4eq : 1;
    int64_t has = words_of(like->effects);
    e.lut4eq = like->lut4eq, e.mult = like->mult, e.bram = like->bram;
    for (int i = 0; i < WORDS; i++) {
        int sign = (int)(set >> i & 1) - (int)(has >> i & 1);
        e.lut4eq += sign * (int)lround(ratio * words[i].lut4eq);
        e.mult += sign * words[i].mult;
        e.bram += sign * words[i].bram;
    }
    e.cells_estimated = 1;
    if (!routed) return e;
    e.worst = routed->worst, e.median = routed->median, e.best = routed->best;
    e.clock_estimated = 1;
    return e;
}

struct sph_known_core sph_known_estimate(const char *profile, const char *effects, int pipes) {
    return estimate(profile, effects, pipes, effects);
}

struct sph_known_core sph_known_core(const char *profile, const char *effects, int pipes) {
    const struct sph_known_core *known = exact(profile, effects, pipes);
    struct sph_known_core core = estimate(profile, effects, pipes, NULL);
    if (known && known->lut4eq) {
        core.lut4eq = known->lut4eq, core.mult = known->mult, core.bram = known->bram;
        core.cells_estimated = 0;
    }
    if (known && known->seeds) {
        core.worst = known->worst, core.median = known->median, core.best = known->best;
        core.seeds = known->seeds;
        core.clock_estimated = 0;
    }
    return core;
}
