/* tally.c - names, sums and a case on one line; see hard.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <math.h>

#include "hard.h"

const char *const hard_columns[HARD_COLUMNS] = {"ours", "float32 textbook", "float32 paper",
                                                "float32 Gems", "float64 textbook"};

const char *const hard_checks[HARD_CHECKS] = {"hit",      "far",    "disc",  "key",
                                              "quotient", "t",      "point", "normal",
                                              "bounce",   "filter", "order", "naive model"};

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

void hard_print(FILE *out, const struct sph_profile *p, const struct hard_case *c) {
    static const char *const kinds[] = {"primary", "shadow", "reflected"};
    const struct sph_ray *r = &c->ray;
    fprintf(out, "  %s, %s ray org (%ld, %ld, %ld) dir (%ld, %ld, %ld)", p->name, kinds[r->kind],
            r->org[0], r->org[1], r->org[2], r->dir[0], r->dir[1], r->dir[2]);
    if (r->skip.id != SPH_ID_NONE)
        fprintf(out, " from sphere %u, %s", r->skip.id, r->skip.inside ? "inside" : "outside");
    if (!r->inside) fprintf(out, ", effect inside off");
    for (int i = 0; i < c->n; i++)
        fprintf(out, "; sphere %u ctr (%ld, %ld, %ld) rad %ld", c->sphere[i].id,
                c->sphere[i].ctr[0], c->sphere[i].ctr[1], c->sphere[i].ctr[2], c->sphere[i].rad);
    fprintf(out, "\n");
}
