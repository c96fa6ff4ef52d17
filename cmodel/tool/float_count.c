/* float_count.c - see float_count.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "tool/float_count.h"

#include <math.h>
#include <stdlib.h>

#include "common/parallel.h"
#include "engine/render_pixel.h"
#include "machine/records.h"
#include "prim/prim.h"
#include "prim/sphere.h"
#include "reference/floats.h"

static const int formulas[FLOAT_ROWS] = {0, SPH_F32_TEXTBOOK, SPH_F64_TEXTBOOK};

/* One test: what the model says, and what floats say of it. */
struct test {
    uint32_t id;
    int hit, hides; /* a shadow ray that hits it ends there */
    int ruled;      /* decided by where the ray starts */
    uint64_t key;   /* of a hit, of no shadow ray */
    int rooted;     /* a*t rounded up is `root` */
    uint64_t root;
    struct sph_floats by[FLOAT_ROWS];
};

/* What a thread works with. */
struct worker {
    const struct sph_machine *m;
    struct sph_ray_log log;
    struct sph_stages stages;
    struct test *tests;
    int room, failed;
    struct float_tally tally;
};

static const uint32_t *record_of(const struct sph_machine *m, uint32_t id, uint32_t *kind) {
    const int32_t *r = m->regs;
    uint32_t spheres = (uint32_t)(sph_whole(m) ? r[SPH_REG_N_SPHERES] : r[SPH_REG_N_PRIMS]);
    int whole = id >= spheres;
    const uint32_t *record =
        sph_line(m, whole ? (uint32_t)r[SPH_REG_FACET_BASE] + (size_t)(id - spheres)
                          : (uint32_t)r[SPH_REG_PRIM_BASE] + (size_t)id);
    *kind = sph_record_kind(whole, record);
    return record;
}

static void test_sphere(const struct sph_profile *p, const struct sph_ray *ray,
                        const uint32_t *record, struct test *t) {
    struct sph_leaf sphere = sph_sphere_read(record, p->w);
    struct sph_leaf_result r = sph_leaf_test(ray, &sphere);
    uint64_t roots = 0;
    int own = sphere.id == ray->skip.id, ahead = r.disc > 0 && (r.b > 0 || r.k > 0);
    t->hit = r.hit;
    t->ruled = own && !(ray->inside && ray->skip.inside && ahead);
    if (r.hit && ray->kind != SPH_SHADOW) {
        t->key = sph_leaf_key_bits(&r, p->pr, &roots);
        t->rooted = !r.exit;
        t->root = sph_leaf_key(&r, &roots);
    }
    for (int i = FLOAT_32; i < FLOAT_ROWS; i++)
        t->by[i] = sph_float_sphere(formulas[i], ray, &sphere);
}

static void test_facet(const struct sph_profile *p, const struct sph_ray *ray, uint32_t kind,
                       const uint32_t *record, struct test *t) {
    struct sph_facet_leaf f = sph_prim_of(kind)->facet(p, record);
    struct sph_ray to_light = *ray, endless = *ray;
    uint64_t divisions = 0;
    to_light.kind = SPH_SHADOW, endless.kind = SPH_PRIMARY;
    struct sph_facet_result r = sph_facet_test(p, ray, &f);
    struct sph_facet_result there = sph_facet_test(p, &to_light, &f); /* t at the plane itself */
    t->hit = r.hit;
    t->ruled = sph_facet_own(ray, &f);
    if (ray->kind == SPH_SHADOW) { /* the light, or the plane that the point was rounded through */
        int meets = sph_facet_test(p, &endless, &f).hit && r.num < (sph_i128)r.det;
        t->ruled |= meets && !r.hit;
    } else if (r.hit) {
        t->key = t->root = sph_facet_key(ray, &r, &divisions);
        t->rooted = r.num == there.num && r.det == there.det; /* else it ends with the grid */
    }
    for (int i = FLOAT_32; i < FLOAT_ROWS; i++)
        t->by[i] = sph_float_facet(formulas[i], ray, &f);
}

static struct test test_of(const struct sph_machine *m, const struct sph_ray *ray, uint32_t id) {
    const struct sph_profile *p = sph_machine_profile(m);
    struct test t = {.id = id};
    uint32_t kind;
    const uint32_t *record = record_of(m, id, &kind);
    t.hides = !sph_machine_effect(m, SPH_EFFECT_CLEAR) || !sph_record_clear(kind, record);
    if (kind == SPH_SPHERE)
        test_sphere(p, ray, record, &t);
    else
        test_facet(p, ray, kind, record, &t);
    for (int i = FLOAT_32; t.ruled && i < FLOAT_ROWS; i++)
        t.by[i] = (struct sph_floats){t.hit, 0, (double)t.key / (double)ray->a};
    return t;
}

static void count_test(const struct sph_profile *p, const struct sph_ray *ray, const struct test *t,
                       struct float_counts *of) {
    long double room = 1 + ldexpl((long double)t->root, 2 - p->pq);
    of[FLOAT_ALL].tests++;
    of[FLOAT_ALL].rules += t->ruled != 0;
    of[FLOAT_ALL].hits += t->hit != 0;
    if (t->ruled) return;
    of[FLOAT_ALL].roots += t->rooted != 0;
    for (int i = FLOAT_32; i < FLOAT_ROWS; i++) {
        of[i].hits += t->by[i].hit != t->hit;
        if (!t->rooted || !t->by[i].hit) continue;
        long double off = (long double)t->by[i].t * (long double)ray->a - (long double)t->root;
        of[i].roots += !(fabsl(off) <= room);
    }
}

static void count_pair(const struct test *t, const struct test *u, struct float_counts *of) {
    int order = t->key < u->key ? -1 : t->key > u->key;
    if (!t->key || !u->key || t->ruled || u->ruled) return;
    of[FLOAT_ALL].pairs += order != 0;
    of[FLOAT_ALL].equal += order == 0;
    for (int i = FLOAT_32; order && i < FLOAT_ROWS; i++) {
        if (!t->by[i].hit || !u->by[i].hit) continue;
        int said = t->by[i].t < u->by[i].t ? -1 : t->by[i].t > u->by[i].t;
        of[i].pairs += said == -order;
        of[i].equal += said == 0;
    }
}

/* Whether the ray by floats of type i meets another primitive than the model's. */
static int is_wrong(const struct sph_logged *l, const struct test *tests, int n, int i) {
    const struct test *first = NULL;
    for (const struct test *t = tests; t < tests + n; t++) {
        if (!t->by[i].hit || (l->ray.kind == SPH_SHADOW && !t->hides)) continue;
        if (!first || t->by[i].t < first->by[i].t ||
            (t->by[i].t == first->by[i].t && t->id < first->id))
            first = t;
    }
    if (l->ray.kind == SPH_SHADOW || !first || !l->hit.key) return !first != !l->hit.key;
    return first->id != l->hit.id && first->key != l->hit.key;
}

/* Returns a bit for each type that has the ray wrong. */
static uint32_t count_ray(struct worker *w, const struct sph_logged *l, int n) {
    struct float_counts *of = w->tally.of[l->ray.kind];
    const struct sph_profile *p = sph_machine_profile(w->m);
    uint32_t wrong = 0;
    of[FLOAT_ALL].rays++;
    for (int j = 0; j < n; j++) {
        count_test(p, &l->ray, &w->tests[j], of);
        for (int k = 0; k < j; k++)
            count_pair(&w->tests[j], &w->tests[k], of);
    }
    for (int i = FLOAT_32; i < FLOAT_ROWS; i++)
        if (is_wrong(l, w->tests, n, i)) of[i].rays++, wrong |= 1u << i;
    return wrong;
}

static int is_test(const struct sph_stage_line *line) {
    return line->stage >= SPH_STAGE_SPHERE && line->stage <= SPH_STAGE_PLANE;
}

/* The rays of a pixel, whose tests stand in the order of the rays. Returns a bit for each type that
 * sees another primitive. */
static uint32_t count_rays(struct worker *w) {
    const struct sph_stages *s = &w->stages;
    uint32_t seen = 0;
    for (int r = 0, at = 0; r < w->log.n; r++) {
        struct sph_logged *l = &w->log.rays[r];
        int n = 0;
        l->ray.stages = NULL; /* its tests are made again, and not followed */
        for (; at < s->n && (!is_test(&s->lines[at]) || s->lines[at].ray <= r); at++)
            if (is_test(&s->lines[at])) w->tests[n++] = test_of(w->m, &l->ray, s->lines[at].number);
        uint32_t wrong = count_ray(w, l, n);
        if (l->ray.kind == SPH_PRIMARY) seen = wrong; /* of two the second counts: ray_log.h */
    }
    return seen;
}

/* As many tests as there are lines. */
static int make_room(struct worker *w) {
    if (w->stages.n <= w->room) return 0;
    struct test *more = realloc(w->tests, (size_t)w->stages.room * sizeof *more);
    if (!more) return -1;
    w->tests = more;
    w->room = w->stages.room;
    return 0;
}

static struct sph_pixel count_pixel(struct worker *w, int x, int y) {
    struct sph_render_options how = {
        .traverse = SPH_TRAVERSE_TREE, .threads = 1, .log = &w->log, .stages = &w->stages};
    struct sph_counters counters = {{0}};
    uint32_t errors = 0;
    w->log.n = 0;
    w->stages = (struct sph_stages){.lines = w->stages.lines, .room = w->stages.room};
    struct sph_pixel pixel = sph_render_pixel(w->m, &how, x, y, &counters, &errors, NULL);
    if (w->log.full || w->stages.full || make_room(w)) {
        w->failed = 1;
        return pixel;
    }
    pixel.visits = count_rays(w);
    for (int i = FLOAT_32; i < FLOAT_ROWS; i++)
        w->tally.pixels[i] += pixel.visits >> i & 1;
    w->tally.pixels[FLOAT_ALL] += pixel.visits == (1u << FLOAT_32 | 1u << FLOAT_64);
    return pixel;
}

/* What threads share. */
struct job {
    const struct sph_machine *m;
    struct sph_frame *frame;
    struct float_tally *tally;
    int failed;
};

static void add(uint64_t *sum, const uint64_t *of, size_t n) {
    for (size_t i = 0; i < n; i++)
        sum[i] += of[i];
}

static void rows(void *user, uint32_t first, uint32_t end) {
    struct job *j = user;
    const int32_t *r = j->m->regs;
    struct worker w = {.m = j->m};
    for (uint32_t row = first; row < end && !w.failed; row++)
        for (int x = r[SPH_REG_WIN_X0]; x < r[SPH_REG_WIN_X1]; x++) {
            int y = r[SPH_REG_WIN_Y0] + (int)row;
            struct sph_pixel pixel = count_pixel(&w, x, y);
            if (j->frame) j->frame->pixels[(size_t)y * (size_t)j->frame->width + (size_t)x] = pixel;
        }
    sph_parallel_lock();
    add((uint64_t *)j->tally, (const uint64_t *)&w.tally, sizeof w.tally / sizeof(uint64_t));
    j->failed |= w.failed;
    sph_parallel_unlock();
    sph_ray_log_free(&w.log);
    sph_stages_free(&w.stages);
    free(w.tests);
}

int float_count(const struct sph_machine *m, struct sph_frame *frame, struct float_tally *tally,
                struct sph_error *err) {
    const int32_t *r = m->regs;
    struct job j = {m, frame, tally, 0};
    *tally = (struct float_tally){0};
    sph_parallel_for((uint32_t)(r[SPH_REG_WIN_Y1] - r[SPH_REG_WIN_Y0]), 1, rows, &j);
    return j.failed ? sph_fail(err, "%s: no memory for the rays of a pixel", m->name) : 0;
}
