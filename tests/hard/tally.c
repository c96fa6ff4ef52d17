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

/* ---- a case on one line; see hard.h ---- */

static void vector(FILE *out, const char *name, const int64_t v[3]) {
    fprintf(out, " %s (%ld, %ld, %ld)", name, v[0], v[1], v[2]);
}

static void ray(FILE *out, const struct sph_ray *r) {
    static const char *const kinds[] = {"primary", "shadow", "reflected", "refracted"};
    fprintf(out, " %s ray", kinds[r->kind]);
    vector(out, "org", r->org);
    vector(out, "dir", r->dir);
    if (r->skip.id != SPH_ID_NONE)
        fprintf(out, " from %u, %s", r->skip.id, r->skip.inside ? "inside" : "outside");
    if (r->kind == SPH_SHADOW) vector(out, "lift", r->lift);
    if (!r->inside) fprintf(out, ", effect inside off");
}

static void spheres(FILE *out, const struct hard_case *c) {
    for (int i = 0; i < c->n; i++) {
        fprintf(out, "; sphere %u", c->sphere[i].id);
        vector(out, "ctr", c->sphere[i].ctr);
        fprintf(out, " rad %ld", c->sphere[i].rad);
    }
}

static void facets(FILE *out, const struct hard_case *c) {
    for (int i = 0; i < c->n; i++) {
        const struct sph_facet_leaf *f = &c->facet[i];
        fprintf(out, "; %s %u", f->kind == SPH_TRIANGLE ? "triangle" : "plane", f->id);
        vector(out, "v0", f->v[0]);
        vector(out, f->kind == SPH_TRIANGLE ? "v1" : "normal", f->v[1]);
        if (f->kind == SPH_TRIANGLE) vector(out, "v2", f->v[2]);
    }
}

void hard_print(FILE *out, const struct sph_profile *p, const struct hard_case *c) {
    fprintf(out, "  %s,", p->name);
    switch (c->of) {
    case HARD_REFRACTION:
        vector(out, "dir", c->ray.dir);
        vector(out, "normal", c->v);
        fprintf(out, " index %u to %u", c->from, c->to);
        break;
    case HARD_AROUND:
    case HARD_UNITS:
        vector(out, c->of == HARD_UNITS ? "vector" : "s2.16 normal", c->v);
        break;
    case HARD_TEXELS:
        fprintf(out, " at %ld * 2^-20 of %u texels, %s, weights %u %u %u", c->texel.at,
                c->texel.size, c->texel.clamp ? "clamped" : "repeated", c->texel.wx, c->texel.wy,
                c->texel.between);
        break;
    case HARD_LEVELS:
        fprintf(out, " path %u/16, base %d/256, %d levels", c->level.path, c->level.base,
                c->level.levels);
        break;
    default:
        ray(out, &c->ray);
        if (c->of == HARD_CLIPS)
            fprintf(out, "; axis %d %s %ld", c->clip.axis, c->clip.below ? "<=" : ">=", c->clip.at);
        else if (c->of != HARD_FACETS)
            spheres(out, c);
        if (c->of == HARD_FACETS || c->of == HARD_TIES) facets(out, c);
    }
    fprintf(out, "\n");
}
