/* check.c - one case: the model against the oracles, floats beside it; see hard.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <math.h>
#include <string.h>

#include "builder/grid/bound.h"
#include "check.h"
#include "naive/naive.h"
#include "naive/hit.h"
#include "naive/math.h"
#include "shade/refract.h"
#include "surface.h"
#include "trace/filter.h"
#include "trace/setup.h"

void job_wrong(struct job *j, int check, const char *what) {
    j->t->wrong[check]++;
    j->mistakes++;
    if (j->out) fprintf(j->out, "  wrong %s: %s\n", hard_checks[check], what);
}

/* t lies less than 1/|dir| above and 2^(2-PQ) of the distance below
 * (docs/reference/machine_file.md). */
static void check_t(struct job *j, const struct sphere_answer *a, const struct sph_quotient *q) {
    long double length = sqrtl((long double)j->ray.a), t = ldexpl(q->mant, -q->exp);
    long double error = (t - exact_t(&a->exact)) * length;
    long double below = ldexpl((long double)a->key, 2 - j->p->pq) / length;
    long double part = error > 0 ? error * length : -error / below;
    struct hard_column *ours = &j->t->column[HARD_OURS];
    ours->worst = fmax(ours->worst, (double)fabsl(error));
    j->t->bound = fmax(j->t->bound, (double)part);
    if (part > 1 + 0x1p-40L) job_wrong(j, HARD_T, "error above its bound");
}

/* The ray that goes through the surface, for an index made of the key. */
static void check_refracted(struct job *j, const struct sph_surface *s, uint64_t key, int far) {
    uint32_t index = SPH_INDEX_MIN + (uint32_t)(key * 0x9e3779b97f4a7c15u >> 40) %
                                         (SPH_INDEX_MAX - SPH_INDEX_MIN + 1);
    uint32_t from = far ? index : SPH_INDEX_ONE, to = far ? SPH_INDEX_ONE : index;
    int64_t out[3] = {0}, other[3] = {0};
    int through = sph_refract(j->p, &j->ray, s, from, to, out);
    if (through != exact_refract(j->p, j->ray.dir, s->normal, from, to, other))
        job_wrong(j, HARD_BOUNCE, "not reflected wholly where it should be, or so");
    else if (memcmp(out, other, sizeof other))
        job_wrong(j, HARD_BOUNCE, "not the rounded refracted ray");
    if (j->naive && (through != sph_naive_refract(j->p, j->ray.dir, s->normal, from, to, other) ||
                     memcmp(out, other, sizeof other)))
        job_wrong(j, HARD_NAIVE, "refracted ray");
}

/* The point of a hit and all that follows from it. */
static void check_surface(struct job *j, const struct sph_leaf *s, const struct sphere_answer *a,
                          int far) {
    const struct sph_profile *p = j->p;
    struct sph_quotient q = sph_quotient(a->key, p->w + p->wd + 2, j->ray.a, 2 * p->wd, p->pq);
    struct sph_hit hit = {a->key, s->id, far != 0, 0};
    struct sph_surface model, exact;
    int64_t bounce[3], other[3];
    if (!exact_is_quotient(p, a->key, j->ray.a, &q))
        job_wrong(j, HARD_QUOTIENT, "not key/a rounded");
    if (a->exact.root) check_t(j, a, &q);
    if (j->ray.a < (uint64_t)SPH_MIN_SCREEN * SPH_MIN_SCREEN) return; /* no ray of a machine */

    int limited = sph_surface_at(p, &j->ray, &hit, s, &model);
    int expected = exact_surface(p, &j->ray, &q, far, s, &exact);
    if (limited != expected || memcmp(model.point, exact.point, sizeof exact.point))
        job_wrong(j, HARD_POINT, "not org + t*dir rounded");
    if (model.nn != exact.nn || memcmp(model.normal, exact.normal, sizeof exact.normal))
        job_wrong(j, HARD_NORMAL, "not the rounded normal of the point");
    sph_reflect(p, j->ray.dir, &model, bounce);
    exact_reflect(p, j->ray.dir, model.normal, other);
    if (memcmp(bounce, other, sizeof other))
        job_wrong(j, HARD_BOUNCE, "not the rounded mirror ray");
    check_refracted(j, &model, a->key, far);
    j->t->points++;
    if (!j->naive) return;
    if (limited != naive_surface(p, &j->ray, a->key, far, s, &exact) ||
        memcmp(model.point, exact.point, sizeof exact.point) ||
        memcmp(model.normal, exact.normal, sizeof exact.normal) ||
        memcmp(model.unit.u, exact.unit.u, sizeof exact.unit.u))
        job_wrong(j, HARD_NAIVE, "point, normal or unit vector");
    sph_naive_mirror(j->ray.dir, model.normal, p->wd, other);
    if (memcmp(bounce, other, sizeof other)) job_wrong(j, HARD_NAIVE, "mirror ray");
}

/* Whether the origin lies at most sqrt(3)/2 outside the sphere: where rounding puts the origins of
 * rays that start on its inner side, for which alone the filter speaks
 * (docs/design/traversal.md). */
static int next_to(const struct sph_ray *ray, const struct sph_leaf *s) {
    int64_t off = -4 * s->rad * s->rad - 3; /* |oc| <= rad + sqrt(3)/2, squared */
    for (int i = 0; i < 3; i++)
        off += 4 * (s->ctr[i] - ray->org[i]) * (s->ctr[i] - ray->org[i]);
    return off <= 0 || (sph_i128)off * off <= (sph_i128)48 * s->rad * s->rad;
}

/* The filter's child around the sphere must let the ray through, at the depth of its own hit. */
static void check_filter(struct job *j, const struct sph_leaf *s, uint64_t key) {
    const struct sph_profile *p = j->p;
    struct sph_ball ball = {{(int32_t)s->ctr[0], (int32_t)s->ctr[1], (int32_t)s->ctr[2]},
                            (int32_t)s->rad};
    struct sph_ball around = sph_filter_leaf(&ball, p);
    if (around.r + SPH_FILTER_MARGIN >= 1 << SPH_CHILD_RAD_BITS) return;
    if (j->ray.skip.id == s->id && !next_to(&j->ray, s)) return;
    struct sph_child child = {{around.c[0], around.c[1], around.c[2]},
                              around.r + SPH_FILTER_MARGIN};
    int32_t near, depth = j->ray.depth_max;
    if (key) depth = sph_ray_depth(p, &j->ray, key);
    j->t->filtered++;
    if (!sph_filter(&j->ray, &child, depth, &near)) job_wrong(j, HARD_FILTER, "a hit is left out");
}

static void check_floats(struct job *j, const struct sph_leaf *s, struct sphere_answer *a) {
    const struct exact *e = &a->exact;
    long double length = sqrtl((long double)e->a), t = e->root ? exact_t(e) : 0;
    for (int i = HARD_OURS + 1; i < HARD_COLUMNS; i++) {
        struct hard_column *column = &j->t->column[i];
        if (!hard_column_is_of(i, j->c->of)) continue;
        struct sph_floats f = a->floats[i] = sph_float_sphere(i, &j->ray, s);
        column->hit += f.hit != e->hit;
        if (!f.hit || !e->hit) continue;
        column->root += f.far != e->far;
        if (f.far != e->far || j->ray.kind == SPH_SHADOW) continue;
        column->worst = fmax(column->worst, (double)fabsl((f.t - t) * length));
    }
}

void check_sphere(struct job *j, const struct sph_leaf *s, struct sphere_answer *a) {
    uint64_t roots = 0;
    const struct exact *e = &a->exact;
    struct sph_leaf_result r = sph_leaf_test(&j->ray, s);
    struct hard_column *ours = &j->t->column[HARD_OURS];
    int shadow = j->ray.kind == SPH_SHADOW, w = j->p->w, wd = j->p->wd;
    a->exact = exact_leaf(&j->ray, s);
    a->hit = r.hit;
    j->t->hits += (uint64_t)e->hit;
    if (r.hit != e->hit) {
        ours->hit++;
        job_wrong(j, HARD_HIT, e->hit ? "misses" : "hits");
    } else if (r.hit && (r.far != e->far || r.exit != e->exit)) {
        ours->root++;
        job_wrong(j, HARD_FAR, e->far ? "takes the near root" : "takes the far root");
    }
    sph_i128 most = (sph_i128)1 << (2 * w + 2 * wd + 1);
    if (r.disc != e->disc || r.b != e->b || r.disc >= most || r.disc < -most ||
        r.k >> (2 * w + 2) != (r.k < 0 ? -1 : 0) || r.b >> (w + wd + 1) != (r.b < 0 ? -1 : 0))
        job_wrong(j, HARD_DISC, "disc, b or the width of disc, b or k");

    if (r.hit && !shadow && (r.exit || r.disc > 0)) { /* else there is no root to be taken */
        a->key = sph_leaf_key(&r, &roots);
        int right = a->key >= 1 && a->key >> (w + wd + 2) == 0;
        if (e->exit) right = a->key == 1;
        if (e->root) /* key - 1 < a*t <= key */
            right = right && exact_compare(e, (int64_t)a->key) <= 0 &&
                    exact_compare(e, (int64_t)a->key - 1) > 0;
        if (!right) job_wrong(j, HARD_KEY, "not a*t rounded up");
    }
    if (j->naive) {
        struct sph_naive_leaf n = sph_naive_leaf(&j->ray, s);
        j->t->naive++;
        if (n.hit != r.hit || (n.hit && (n.far != r.far || n.exit != r.exit)) || n.key != a->key)
            job_wrong(j, HARD_NAIVE, "hit, far, exit or key");
    }
    if (e->hit && r.hit && a->key && j->ray.a) check_surface(j, s, a, r.far);
    if (e->hit) check_filter(j, s, a->key);
    if (j->ray.skip.id != s->id && j->ray.inside) check_floats(j, s, a);
}

void job_order(struct job *j, int order, const uint64_t key[2], const struct sph_floats *f,
               const struct sph_floats *g) {
    struct hard_column *column = j->t->column;
    int said = key[0] < key[1] ? -1 : key[0] > key[1];
    j->t->pairs++;
    if (said && said != order) job_wrong(j, HARD_ORDER, "the keys say otherwise than t");
    for (int i = HARD_OURS; i < HARD_COLUMNS; i++) {
        if (i != HARD_OURS) {
            if (!f || !f[i].hit || !g[i].hit) continue;
            said = f[i].t < g[i].t ? -1 : f[i].t > g[i].t;
        }
        column[i].order += said == -order && said;
        column[i].tie += !said != !order;
    }
}

/* Both spheres are hit: which one is nearer? */
static void check_order(struct job *j, const struct sphere_answer a[2]) {
    int order = exact_order(&a[0].exact, &a[1].exact);
    int floats = j->ray.skip.id == SPH_ID_NONE && j->ray.inside;
    const uint64_t key[2] = {a[0].key, a[1].key};
    job_order(j, order, key, floats ? a[0].floats : NULL, a[1].floats);
}

static void check_spheres(struct job *j) {
    struct sphere_answer a[2] = {0};
    for (int i = 0; i < j->c->n; i++)
        check_sphere(j, &j->c->sphere[i], &a[i]);
    if (j->c->n == 2 && a[0].exact.root && a[1].exact.root && a[0].hit && a[1].hit &&
        j->c->ray.kind != SPH_SHADOW)
        check_order(j, a);
}

int hard_check(const struct sph_profile *p, const struct hard_case *c, int naive,
               struct hard_tally *t, FILE *out) {
    static void (*const checks[HARD_KINDS])(struct job *) = {
        check_spheres, check_facets, check_refraction, check_around, check_texels,
        check_levels,  check_clips,  check_walks,      check_units,  check_ties};
    struct job j = {p, c, c->ray, naive, 0, t, out};
    sph_ray_setup(p, &j.ray);
    t->cases++;
    checks[c->of](&j);
    if (j.mistakes && out) hard_print(out, p, c);
    return j.mistakes;
}
