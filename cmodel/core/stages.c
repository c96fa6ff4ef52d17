/* stages.c - see stages.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "core/stages.h"

#include <limits.h>
#include <stdlib.h>

void sph_stages_note(struct sph_stages *s, int stage, uint32_t number, const sph_i128 *words,
                     size_t n) {
    if (s->n == s->room) {
        int room = s->room ? 2 * s->room : 256;
        struct sph_stage_line *more = realloc(s->lines, (size_t)room * sizeof *more);
        if (!more) {
            s->full = 1;
            return;
        }
        s->lines = more;
        s->room = room;
    }
    if (stage >= SPH_STAGE_NODE && stage <= SPH_STAGE_LEAF) s->visit++, s->child = 0;
    if (stage == SPH_STAGE_FILTER || stage == SPH_STAGE_BOX) number = s->child++;
    if (stage == SPH_STAGE_TEXEL) number = s->texel++;
    if (stage == SPH_STAGE_LIGHT) number = s->light++;
    if (stage == SPH_STAGE_HIGHLIGHT) number = s->light - 1;
    int visited = stage >= SPH_STAGE_NODE && stage <= SPH_STAGE_KEY;
    struct sph_stage_line *line = &s->lines[s->n++];
    *line = (struct sph_stage_line){s->ray, s->kind,  stage, visited ? s->visit : 0,
                                    number, s->clock, {0}};
    if (stage >= SPH_STAGE_QUOTIENT) line->ray = s->at, line->kind = s->at_kind;
    if (stage == SPH_STAGE_PIXEL) line->ray = INT_MAX;
    for (size_t i = 0; i < n; i++)
        line->word[i] = (sph_u128)words[i];
}

void sph_stages_begin(struct sph_stages *s, const struct sph_ray *ray) {
    s->ray = s->rays++, s->kind = ray->kind;
    s->visit = 0;
    if (ray->kind != SPH_SHADOW) {
        s->at = s->ray, s->at_kind = s->kind;
        s->texel = s->light = 0;
    }
    SPH_NOTE(s, SPH_STAGE_RAY, 0, SPH_THREE(ray->org), SPH_THREE(ray->dir), (sph_i128)ray->a,
             SPH_THREE(ray->unit.u), ray->skip.id, ray->skip.inside);
}

void sph_stages_end(struct sph_stages *s, const struct sph_ray *ray, const struct sph_hit *hit) {
    int found = hit->key != 0, told = found && ray->kind != SPH_SHADOW;
    SPH_NOTE(s, SPH_STAGE_HIT, 0, found, told ? hit->id : SPH_ID_NONE, told ? hit->key : 0,
             told && hit->far);
}

void sph_stages_pixel(struct sph_stages *s, const struct sph_pixel *p) {
    SPH_NOTE(s, SPH_STAGE_PIXEL, 0, SPH_THREE(p->colour), p->id, p->key, p->visits, p->texture);
}

static int by(uint32_t a, uint32_t b) {
    return (a > b) - (a < b);
}

static int is_test(const struct sph_stage_line *l) {
    return l->stage >= SPH_STAGE_SPHERE && l->stage <= SPH_STAGE_KEY;
}

/* All of a visit is of one stage; of its tests those of one primitive stand together. */
static int group(const struct sph_stage_line *l) {
    return l->visit || is_test(l) ? SPH_STAGE_NODE : l->stage;
}

int sph_stages_order(const struct sph_stage_line *a, const struct sph_stage_line *b) {
    int tests = is_test(a) && is_test(b);
    int order = (a->ray > b->ray) - (a->ray < b->ray);
    if (!order) order = group(a) - group(b);
    if (!order) order = by(a->visit, b->visit);
    if (!order) order = tests ? by(a->number, b->number) : a->stage - b->stage;
    if (!order) order = tests ? a->stage - b->stage : by(a->number, b->number);
    return order;
}

/* Insertion: what is there is nearly in order, and equal ones stay as they came. */
void sph_stages_sort(struct sph_stages *s) {
    for (int i = 1; i < s->n; i++) {
        struct sph_stage_line line = s->lines[i];
        int at = i;
        for (; at && sph_stages_order(&s->lines[at - 1], &line) > 0; at--)
            s->lines[at] = s->lines[at - 1];
        s->lines[at] = line;
    }
}

void sph_stages_free(struct sph_stages *s) {
    free(s->lines);
    *s = (struct sph_stages){0};
}
