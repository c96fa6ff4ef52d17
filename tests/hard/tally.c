/* tally.c - names, sums and a case on one line; see hard.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <math.h>

#include "hard.h"

const char *const hard_columns[HARD_COLUMNS] = {"ours", "float32 textbook", "float32 paper",
                                                "float32 Gems", "float64 textbook"};

const char *const hard_checks[HARD_CHECKS] = {
    "hit",    "far",    "disc",  "key",         "quotient", "t",       "point", "normal",
    "bounce", "filter", "order", "naive model", "through",  "texture", "tree",  "unit"};

const char *const hard_kinds[HARD_KINDS] = {"spheres", "facets", "refraction", "around", "texels",
                                            "levels",  "clips",  "walks",      "units",  "ties"};

int hard_column_is_of(int column, int of) {
    if (of == HARD_WALKS) return column == HARD_OURS;
    if (column == SPH_F32_GEMS) return of == HARD_SPHERES;
    return column != SPH_F32_PAPER || of <= HARD_REFRACTION || of == HARD_TIES;
}

void hard_tally_add(struct hard_tally *sum, const struct hard_tally *t) {
    sum->cases += t->cases;
    sum->hits += t->hits;
    sum->pairs += t->pairs;
    sum->naive += t->naive;
    sum->points += t->points;
    sum->filtered += t->filtered;
    for (int i = 0; i < HARD_CHECKS; i++)
        sum->wrong[i] += t->wrong[i];
    for (int i = 0; i < HARD_COLUMNS; i++) {
        struct hard_column *to = &sum->column[i];
        const struct hard_column *from = &t->column[i];
        to->hit += from->hit;
        to->root += from->root;
        to->order += from->order;
        to->tie += from->tie;
        to->worst = fmax(to->worst, from->worst);
    }
    sum->bound = fmax(sum->bound, t->bound);
}

uint64_t hard_tally_wrong(const struct hard_tally *t) {
    uint64_t sum = 0;
    for (int i = 0; i < HARD_CHECKS; i++)
        sum += t->wrong[i];
    return sum;
}
