/* check_more.c - the checks of facets, ties, trees and vectors; see check.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "exact.h"
#include "facet.h"
#include "naive/hit.h"
#include "naive/math.h"
#include "naive/naive.h"
#include "named.h"
#include "shade/refract.h"
#include "surface.h"
#include "trace/bih.h"
#include "trace/traverse.h"

/* ---- rays and up to two facets; see check.h ---- */

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

/* ---- a sphere and a facet on one ray: which one comes first; see check.h ---- */

/* What the ray meets through a node of both, the sphere of id 0 and the facet of id 1, by the keys
 * of the oracles: of equal ones the sphere. */
static void check_first(struct job *j, const struct sphere_answer *s,
                        const struct facet_answer *f) {
    struct named n = hard_named_start((int)(j->p - sph_profiles));
    struct sph_leaf sphere = j->c->sphere[0];
    const struct sph_facet_leaf *const both[2] = {NULL, &j->c->facet[0]};
    const uint32_t ids[2] = {0, 1};
    uint64_t near = s->exact.exit ? 1 : (uint64_t)(s->exact.whole + (s->exact.part > 0));
    uint64_t far = f->exact.key;
    int shadow = j->ray.kind == SPH_SHADOW, hit = s->exact.hit || f->exact.hit;
    uint32_t id = s->exact.hit && (!f->exact.hit || near <= far) ? 0 : 1;
    struct sph_ray ray = j->ray;
    if (ray.skip.id != SPH_ID_NONE) ray.skip.id = ray.skip.id != sphere.id;
    sphere.id = 0;
    for (int order = 0; order < 2; order++) {
        uint32_t mem[TWO_RECORDS * SPH_LINE_WORDS], visits = 0, errors = 0;
        struct sph_counters counters = {0};
        struct sph_machine m;
        two_records(&n, both, &sphere, order, ids, mem, &m);
        for (int how = SPH_TRAVERSE_TREE; how <= SPH_TRAVERSE_BRUTE; how++) {
            struct sph_hit got = sph_traverse(&m, &ray, how, &counters, &visits, &errors);
            if (errors || !got.key != !hit || (hit && !shadow && got.id != id))
                job_wrong(j, HARD_TREE, how ? "another hit of all" : "another hit in a node");
        }
        if (!j->naive || order) continue;
        struct sph_naive_found found = sph_naive_trace(&m, &ray);
        if (!found.how.hit != !hit || (hit && !shadow && found.prim.facet != (int)id))
            job_wrong(j, HARD_NAIVE, "the first of a sphere and a facet");
    }
}

void check_ties(struct job *j) {
    struct sphere_answer s = {0};
    struct facet_answer f = {0};
    check_sphere(j, &j->c->sphere[0], &s);
    check_facet(j, &j->c->facet[0], &f);
    check_first(j, &s, &f);
    if (!s.exact.root || !f.exact.hit || f.exact.ended || j->ray.kind == SPH_SHADOW) return;
    const uint64_t key[2] = {s.key, f.key};
    sph_i128 scaled = f.exact.num * (sph_i128)j->ray.a, det = f.exact.det;
    int floats = j->ray.skip.id == SPH_ID_NONE && j->ray.inside;
    job_order(j, exact_against(&s.exact, (int64_t)(scaled / det), scaled % det, det), key,
              floats ? s.floats : NULL, f.floats);
}

/* ---- planes of a BIH, and spheres in one; see check.h ---- */

/* Sign of a*v/|d| - t * 2^t_shift, v >= 0. */
static int against(const struct job *j, const struct sph_bih_ray *b, int64_t v, int64_t d,
                   uint32_t t) {
    sph_i128 exact = (sph_i128)j->ray.a * v, bound = ((sph_i128)t << b->t_shift) * d;
    return exact < bound ? -1 : exact > bound;
}

/* A slab test without margin: t = v/d rounded; which side of the exact t it must not lie on. */
static void clip_floats(struct job *j, int64_t v, int64_t d, int leaves) {
    double side = leaves ? -1 : 1, t32 = (double)((float)v * (1 / (float)d));
    double t64 = (double)v * (1 / (double)d);
    j->t->column[SPH_F32_TEXTBOOK].hit += side * fma(t32, (double)d, -(double)v) > 0;
    j->t->column[SPH_F64_TEXTBOOK].hit += side * fma(t64, (double)d, -(double)v) > 0;
}

void check_clips(struct job *j) {
    int axis = j->c->clip.axis, below = j->c->clip.below;
    int64_t d = j->ray.dir[axis], v = j->c->clip.at - j->ray.org[axis];
    struct sph_bih_ray b;
    struct sph_interval span = {0, SPH_BIH_NO_BOUND};
    if (!j->ray.a) return;
    sph_bih_setup(j->p, &j->ray, &b);
    int left = sph_bih_cut(&b, &j->ray, axis, j->c->clip.at, below, &span);
    int starts = below ? v >= 0 : v <= 0; /* on this side */
    int comes = below ? d < 0 : d > 0;    /* or gets there */
    j->t->hits += starts || comes;
    if (left != (starts || comes)) job_wrong(j, HARD_TREE, "a side that the ray sees, or does not");
    if (!left || !d) return;
    if (d < 0) d = -d, v = -v;
    if (v < 0 || (!comes && v == 0)) {
        if (span.lo) job_wrong(j, HARD_TREE, "bounded though nothing is behind");
        return;
    }
    if (comes ? span.hi != SPH_BIH_NO_BOUND : span.lo != 0)
        job_wrong(j, HARD_TREE, "the other bound moved");
    if (comes && against(j, &b, v, d, span.lo) < 0)
        job_wrong(j, HARD_TREE, "what lies at the plane is left out");
    if (!comes && span.hi != SPH_BIH_NO_BOUND && against(j, &b, v, d, span.hi) > 0)
        job_wrong(j, HARD_TREE, "what lies before the plane is left out");
    if (v < 1ll << 24) clip_floats(j, v, d, !comes);
}

/* The first of both spheres: a BIH of two leaves, one leaf, the exact order. */
void check_walks(struct job *j) {
    struct named n = hard_named_start((int)(j->p - sph_profiles));
    struct sph_leaf leaf[2] = {j->c->sphere[0], j->c->sphere[1]};
    uint32_t words[TWO_LINES * SPH_LINE_WORDS], id = SPH_ID_NONE;
    uint64_t key = 0;
    struct sph_machine m;
    n.list = &(struct hard_list){0}; /* a BIH that cannot be built says so by its answers */
    for (int i = 0; i < 2; i++) {
        struct exact e = exact_leaf(&j->ray, &leaf[i]);
        uint64_t at = (uint64_t)(e.whole + (e.part > 0));
        leaf[i].id = (uint32_t)i;
        j->t->hits += e.hit != 0;
        if (!e.hit || (id != SPH_ID_NONE && at >= key)) continue;
        key = at;
        id = (uint32_t)i;
    }
    two_leaves(&n, leaf, words, &m);
    for (int kind = SPH_TREE_BIH; kind <= SPH_TREE_BRUTE; kind++) {
        uint32_t visits = 0, errors = 0;
        struct sph_counters counters = {0};
        two_in_bih(&n, leaf, kind, words, &m);
        struct sph_hit hit =
            sph_traverse(&m, &j->ray, SPH_TRAVERSE_TREE, &counters, &visits, &errors);
        j->t->column[HARD_OURS].hit += (hit.key != 0) != (key != 0);
        if (errors || hit.id != id || hit.key != key)
            job_wrong(j, HARD_TREE, kind == SPH_TREE_BIH ? "another hit in a BIH" : "of one leaf");
    }
}

/* ---- refracted rays and unit vectors; see check.h ---- */

/* Whether all is reflected: textbook by cosines of unit vectors, paper by the integers' formula. */
#define TOTAL(real, root, name)                                                                    \
    static int total_##name(int integers, const int64_t dir[3], const int64_t normal[3],           \
                            uint32_t from, uint32_t to) {                                          \
        real a = 0, n = 0, b = 0, eta = (real)from / (real)to, p = (real)from, q = (real)to;       \
        for (int i = 0; i < 3; i++) {                                                              \
            a += (real)dir[i] * (real)dir[i];                                                      \
            n += (real)normal[i] * (real)normal[i];                                                \
            b += (real)dir[i] * (real)normal[i];                                                   \
        }                                                                                          \
        if (integers) return q * q * a * n - p * p * (a * n - b * b) < 0;                          \
        real cosine = b / (root(a) * root(n));                                                     \
        return 1 - eta * eta * (1 - cosine * cosine) < 0;                                          \
    }
TOTAL(float, sqrtf, single)
TOTAL(double, sqrt, full)

void check_refraction(struct job *j) {
    const struct hard_case *c = j->c;
    struct sph_surface s = {.nn = 0};
    int64_t out[3] = {0}, other[3] = {0};
    for (int i = 0; i < 3; i++) {
        s.normal[i] = c->v[i];
        s.nn += (uint64_t)(c->v[i] * c->v[i]);
    }
    if (!s.nn || !j->ray.a) return; /* of no hit */
    s.unit = sph_unit(s.normal, s.nn, j->p->wd);
    int through = sph_refract(j->p, &j->ray, &s, c->from, c->to, out);
    int expected = exact_refract(j->p, c->ray.dir, c->v, c->from, c->to, other);
    j->t->hits += expected != 0;
    j->t->column[HARD_OURS].hit += through != expected;
    if (through != expected)
        job_wrong(j, HARD_HIT, "not reflected wholly where it should be, or so");
    if (memcmp(out, other, sizeof out)) job_wrong(j, HARD_BOUNCE, "not the rounded refracted ray");
    j->t->column[SPH_F32_TEXTBOOK].hit +=
        total_single(0, c->ray.dir, c->v, c->from, c->to) == expected;
    j->t->column[SPH_F32_PAPER].hit +=
        total_single(1, c->ray.dir, c->v, c->from, c->to) == expected;
    j->t->column[SPH_F64_TEXTBOOK].hit +=
        total_full(0, c->ray.dir, c->v, c->from, c->to) == expected;
    if (!j->naive) return;
    j->t->naive++;
    if (through != sph_naive_refract(j->p, c->ray.dir, c->v, c->from, c->to, other) ||
        memcmp(out, other, sizeof out))
        job_wrong(j, HARD_NAIVE, "refracted ray");
}

/* Within half a unit of 2^-16 above v/|v|, and SPH_RSQRT_ERROR of 2^16 more below. */
void check_units(struct job *j) {
    const int64_t *v = j->c->v;
    uint64_t vv = (uint64_t)(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    struct sph_unit u = sph_unit(v, vv, j->p->wd);
    long double length = sqrtl((long double)vv);
    float single =
        sqrtf((float)v[0] * (float)v[0] + (float)v[1] * (float)v[1] + (float)v[2] * (float)v[2]);
    double full = sqrt((double)v[0] * (double)v[0] + (double)v[1] * (double)v[1] +
                       (double)v[2] * (double)v[2]);
    int64_t naive[3];
    j->t->hits += vv != 0;
    if (j->naive) sph_naive_unit(v, j->p->wd, naive), j->t->naive++;
    for (int i = 0; i < 3; i++) {
        if (j->naive && naive[i] != u.u[i]) job_wrong(j, HARD_NAIVE, "unit vector");
        if (!vv) {
            if (u.u[i]) job_wrong(j, HARD_UNIT, "a direction of nothing");
            continue;
        }
        long double exact = 65536 * fabsl((long double)v[i]) / length, got = abs(u.u[i]);
        struct hard_column *column = j->t->column;
        if (got > exact + 0.501L || got < exact * (1 - 7 / 65536.0L) - 0.501L)
            job_wrong(j, HARD_UNIT, "not v/|v|");
        if ((v[i] < 0 && u.u[i] > 0) || (v[i] > 0 && u.u[i] < 0))
            job_wrong(j, HARD_UNIT, "turned round");
        column[HARD_OURS].worst = fmax(column[HARD_OURS].worst, (double)fabsl(got - exact));
        double f32 = fabs(65536 * (double)(fabsf((float)v[i]) / single) - (double)exact);
        double f64 = fabs(65536 * (fabs((double)v[i]) / full) - (double)exact);
        column[SPH_F32_TEXTBOOK].worst = fmax(column[SPH_F32_TEXTBOOK].worst, f32);
        column[SPH_F64_TEXTBOOK].worst = fmax(column[SPH_F64_TEXTBOOK].worst, f64);
    }
}
