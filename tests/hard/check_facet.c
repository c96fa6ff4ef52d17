/* check_facet.c - rays and up to two facets; see check.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <math.h>

#include "check.h"
#include "naive/naive.h"

static void check_floats(struct job *j, const struct sph_facet_leaf *f, struct facet_answer *a) {
    const struct facet_exact *e = &a->exact;
    if (j->ray.skip.id != SPH_ID_NONE) return; /* of which floats know nothing */
    for (int i = HARD_OURS + 1; i < HARD_COLUMNS; i++) {
        if (!hard_column_is_of(i, HARD_FACETS)) continue;
        struct hard_column *column = &j->t->column[i];
        struct sph_floats r = a->floats[i] = sph_float_facet(i, &j->ray, f);
        column->hit += r.hit != e->hit;
        if (!r.hit || !e->hit) continue;
        column->root += r.far != e->far;
        if (e->ended) continue;
        long double t = (long double)e->num / (long double)e->det;
        double off = (double)(fabsl((long double)r.t - t) * sqrtl((long double)j->ray.a));
        if (off > column->worst) column->worst = off;
    }
}

void check_facet(struct job *j, const struct sph_facet_leaf *f, struct facet_answer *a) {
    uint64_t divisions = 0;
    struct sph_facet_result r = sph_facet_test(j->p, &j->ray, f);
    const struct facet_exact *e = &a->exact;
    a->exact = exact_facet(j->p, &j->ray, f);
    a->hit = r.hit;
    if (r.hit && j->ray.kind != SPH_SHADOW) a->key = sph_facet_key(&j->ray, &r, &divisions);
    j->t->hits += e->hit != 0;
    j->t->column[HARD_OURS].hit += r.hit != e->hit;
    if (r.hit != e->hit) job_wrong(j, HARD_HIT, e->hit ? "hits" : "misses");
    if (r.hit && e->hit && r.far != e->far) job_wrong(j, HARD_FAR, "the other side");
    if (a->key != e->key) job_wrong(j, HARD_KEY, "not a*t rounded up");
    if (j->c->through && e->met && !r.hit)
        job_wrong(j, HARD_THROUGH, "a ray through a point of the facet goes past it");
    if (e->hit && !e->ended && a->key) {
        long double t = (long double)e->num / (long double)e->det,
                    unit = sqrtl((long double)j->ray.a);
        double off = (double)(((long double)a->key / (unit * unit) - t) * unit);
        if (fabs(off) > j->t->column[HARD_OURS].worst) j->t->column[HARD_OURS].worst = fabs(off);
    }
    check_floats(j, f, a);
    if (!j->naive) return;
    struct sph_naive_leaf n = sph_naive_facet(j->p, &j->ray, f);
    j->t->naive++;
    if (n.hit != r.hit || (n.hit && n.far != r.far) || n.key != a->key)
        job_wrong(j, HARD_NAIVE, "hit, far or key of a facet");
}

void check_facets(struct job *j) {
    struct facet_answer a[2] = {0};
    for (int i = 0; i < j->c->n; i++)
        check_facet(j, &j->c->facet[i], &a[i]);
    if (j->c->n < 2 || !a[0].exact.hit || !a[1].exact.hit || j->ray.kind == SPH_SHADOW) return;
    int floats = !a[0].exact.ended && !a[1].exact.ended && j->ray.skip.id == SPH_ID_NONE;
    const uint64_t key[2] = {a[0].key, a[1].key};
    job_order(j, exact_facet_order(&a[0].exact, &a[1].exact), key, floats ? a[0].floats : NULL,
              a[1].floats);
}
