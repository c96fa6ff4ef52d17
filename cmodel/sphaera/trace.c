/* trace.c - rays through the tree of a machine: see sphaera.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <inttypes.h>
#include <math.h>

#include "common/parallel.h"
#include "fast/prepare.h"
#include "pixel/background.h"
#include "sphaera/opaque.h"
#include "trace/setup.h"
#include "trace/traverse.h"

enum { GRAIN = 64 }; /* rays that are worth a thread */

/* A vector of the scene in the grid's axes. */
static void turn(const struct sph_machine *m, const double v[3], double out[3]) {
    for (int i = 0; i < 3; i++) {
        const double *row = m->rotation + 3 * (size_t)i;
        out[i] = row[0] * v[0] + row[1] * v[1] + row[2] * v[2];
    }
}

static double greatest(const double v[3]) {
    return fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));
}

/* What there is against a ray of real numbers. */
enum { SOUND, NOT_FINITE, NO_LENGTH, OUTSIDE };

/* How a machine takes rays of real numbers. */
struct grid {
    const struct sph_machine *m;
    double unit;        /* grid units in one of the scene: a power of 2 */
    double least, most; /* of coordinates: grid units; of a direction */
};

static struct grid grid_of(const struct sph_machine *m) {
    return (struct grid){m, ldexp(1, -m->grid_log2), -ldexp(1, m->profile.w - 1),
                         ldexp(1, m->profile.wd - 1) - 1};
}

/* Origin and direction of the ray in integers: the direction has all bits that it may have. */
static int quantise(const struct grid *g, const double origin[3], const double direction[3],
                    struct sph_ray *ray) {
    double org[3], dir[3], scaled[3], longest = greatest(direction);
    for (int i = 0; i < 3; i++)
        if (!isfinite(origin[i]) || !isfinite(direction[i])) return NOT_FINITE;
    if (!(longest > 0)) return NO_LENGTH;
    if (longest < 0x1p-500 || longest > 0x1p500) { /* so that turned it is a normal number */
        int exponent;
        frexp(longest, &exponent);
        for (int i = 0; i < 3; i++)
            scaled[i] = ldexp(direction[i], -exponent);
        direction = scaled;
    }
    turn(g->m, origin, org);
    turn(g->m, direction, dir);
    double scale = g->most / greatest(dir);
    for (int i = 0; i < 3; i++) {
        double at = round((org[i] - g->m->origin[i]) * g->unit);
        if (!(at >= g->least && at < -g->least)) return OUTSIDE;
        ray->org[i] = (int64_t)at;
        ray->dir[i] = (int64_t)round(dir[i] * scale);
    }
    return SOUND;
}

/* A ray of real numbers, before it has any: it starts on nothing, and may start inside a sphere. */
#define REAL_RAY                                                                                   \
    { .kind = SPH_PRIMARY, .skip = {SPH_ID_NONE, 0}, .inside = 1 }

struct batch {
    const struct sph_machine *m;
    const struct sph_fast *fast; /* NULL: literally */
    struct grid grid;
    const double *origins, *directions; /* or */
    const int32_t *grid_origins, *grid_directions;
    const sphaera_hits *to;
    uint64_t bad; /* the first ray that cannot be taken, and why: 8 * number + why */
};

/* The ray `at` of the batch, not set up. */
static int take(const struct batch *b, size_t at, struct sph_ray *ray) {
    *ray = (struct sph_ray)REAL_RAY;
    if (b->origins) return quantise(&b->grid, b->origins + 3 * at, b->directions + 3 * at, ray);
    int32_t any = 0;
    ray->inside = sph_machine_effect(b->m, SPH_EFFECT_INSIDE);
    ray->first = sph_machine_effect(b->m, SPH_EFFECT_FIRST);
    for (size_t i = 0; i < 3; i++) {
        ray->org[i] = b->grid_origins[3 * at + i];
        ray->dir[i] = b->grid_directions[3 * at + i];
        any |= b->grid_directions[3 * at + i];
        if (ray->org[i] < (int64_t)b->grid.least || ray->org[i] >= -(int64_t)b->grid.least ||
            ray->dir[i] < -(int64_t)b->grid.most - 1 || ray->dir[i] > (int64_t)b->grid.most)
            return OUTSIDE;
    }
    return any ? SOUND : NO_LENGTH;
}

static double distance(const struct sph_machine *m, const struct sph_ray *ray, uint64_t key) {
    return ldexp((double)key / (double)ray->a * sqrt((double)ray->a), m->grid_log2);
}

static void put(const struct batch *b, size_t at, const struct sph_ray *ray,
                const struct sph_hit *hit, uint32_t visits) {
    const sphaera_hits *to = b->to;
    int any = hit->key != 0;
    if (to->id) to->id[at] = any ? hit->id : SPHAERA_NONE;
    if (to->key) to->key[at] = hit->key;
    if (to->inside) to->inside[at] = any && hit->far;
    if (to->visits) to->visits[at] = visits;
    if (to->distance) to->distance[at] = any ? distance(b->m, ray, hit->key) : 0;
}

static struct sph_hit find(const struct batch *b, const struct sph_ray *ray, uint32_t *visits) {
    struct sph_counters counters = {{0}};
    uint32_t errors = 0;
    *visits = 0;
    return b->fast ? sph_fast_trace(b->fast, ray, &counters, visits, &errors)
                   : sph_traverse(b->m, ray, SPH_TRAVERSE_TREE, &counters, visits, &errors);
}

static void refuse(struct batch *b, size_t at, int why) {
    uint64_t word = 8 * (uint64_t)at + (uint64_t)why;
    sph_parallel_lock();
    if (word < b->bad) b->bad = word;
    sph_parallel_unlock();
}

/* Rays first .. end - 1 of those from `from` on. */
struct part {
    struct batch *b;
    size_t from, n;
};

static void part(void *user, uint32_t first, uint32_t end) {
    const struct part *p = user;
    struct batch *b = p->b;
    for (size_t at = p->from + first; at < p->from + end; at += SPH_TOGETHER) {
        struct sph_ray rays[SPH_TOGETHER];
        int n = (int)(p->from + end - at < SPH_TOGETHER ? p->from + end - at : SPH_TOGETHER);
        for (int i = 0; i < n; i++) {
            int why = take(b, at + (size_t)i, &rays[i]);
            if (!why) continue;
            refuse(b, at + (size_t)i, why);
            return;
        }
        if (b->fast) sph_fast_prepare_all(b->fast, rays, n);
        for (int i = 0; i < n; i++) {
            uint32_t visits;
            if (!b->fast) sph_ray_setup(&b->m->profile, &rays[i]);
            struct sph_hit hit = find(b, &rays[i], &visits);
            put(b, at + (size_t)i, &rays[i], &hit, visits);
        }
    }
}

/* What is said of ray `at`, called by the names of the arguments. */
static int wrong(const struct batch *b, size_t at, int why, struct sph_error *err) {
    const struct sph_profile *p = &b->m->profile;
    if (why == NOT_FINITE)
        return sph_fail(err, "origins[%zu] or directions[%zu] is not finite", at, at);
    if (why == NO_LENGTH) return sph_fail(err, "directions[%zu] has no length", at);
    if (b->origins)
        return sph_fail(err, "origins[%zu] lies outside the grid of %d bits a coordinate", at,
                        p->w);
    return sph_fail(err, "origins[%zu] has more than %d bits, or directions[%zu] more than %d", at,
                    p->w, at, p->wd);
}

static int run(struct batch *b, size_t n, int threads, struct sph_error *err) {
    enum { ONCE = 1 << 30 }; /* rays of one loop */
    b->bad = UINT64_MAX;
    b->grid = grid_of(b->m);
    int before = sph_parallel_most(threads);
    for (size_t from = 0; from < n && b->bad == UINT64_MAX; from += ONCE) {
        struct part p = {b, from, n - from < ONCE ? n - from : ONCE};
        sph_parallel_for((uint32_t)p.n, GRAIN, part, &p);
    }
    sph_parallel_most(before);
    return b->bad == UINT64_MAX ? 0 : wrong(b, (size_t)(b->bad / 8), (int)(b->bad % 8), err);
}

static int trace(const sphaera_machine *machine, struct batch *b, size_t n, int threads,
                 sphaera_error *error) {
    SPH_API_ENVIRONMENT;
    struct sph_error err = {""};
    b->m = &machine->machine;
    b->fast = sph_api_fast(machine);
    if (sph_api_whole("threads", threads, 0, SPH_API_THREADS, &err) || run(b, n, threads, &err))
        return sph_api_failed(&err, error);
    return 0;
}

int sphaera_trace_rays(const sphaera_machine *machine, size_t n, const double *origins,
                       const double *directions, int threads, const sphaera_hits *hits,
                       sphaera_error *error) {
    if (sph_api_null(machine, "machine", error) || sph_api_null(origins, "origins", error) ||
        sph_api_null(directions, "directions", error) || sph_api_null(hits, "hits", error))
        return -1;
    struct batch b = {.origins = origins, .directions = directions, .to = hits};
    return trace(machine, &b, n, threads, error);
}

int sphaera_trace_grid(const sphaera_machine *machine, size_t n, const int32_t *origins,
                       const int32_t *directions, int threads, const sphaera_hits *hits,
                       sphaera_error *error) {
    if (sph_api_null(machine, "machine", error) || sph_api_null(origins, "origins", error) ||
        sph_api_null(directions, "directions", error) || sph_api_null(hits, "hits", error))
        return -1;
    struct batch b = {.grid_origins = origins, .grid_directions = directions, .to = hits};
    return trace(machine, &b, n, threads, error);
}

int sphaera_primary(const sphaera_machine *machine, int x, int y, int32_t origin[3],
                    int32_t direction[3], sphaera_error *error) {
    if (sph_api_null(machine, "machine", error) || sph_api_null(origin, "origin", error) ||
        sph_api_null(direction, "direction", error))
        return -1;
    struct sph_error err = {""};
    const struct sph_machine *m = &machine->machine;
    if (sph_api_whole("x", x, 0, m->regs[SPH_REG_FRAME_W] - 1, &err) ||
        sph_api_whole("y", y, 0, m->regs[SPH_REG_FRAME_H] - 1, &err))
        return sph_api_failed(&err, error);
    int64_t dir[3];
    sph_primary_dir(m, x, y, dir);
    for (int i = 0; i < 3; i++) {
        origin[i] = m->regs[SPH_REG_EYE_X + i];
        direction[i] = (int32_t)dir[i];
    }
    return 0;
}

int sphaera_trace(const sphaera_machine *machine, const double origin[3], const double direction[3],
                  sphaera_hit *hit, sphaera_error *error) {
    if (sph_api_null(machine, "machine", error) || sph_api_null(origin, "origin", error) ||
        sph_api_null(direction, "direction", error) || sph_api_null(hit, "hit", error))
        return -1;
    SPH_API_ENVIRONMENT;
    struct sph_error err = {""};
    struct batch b = {.m = &machine->machine, .fast = sph_api_fast(machine)};
    const struct grid grid = grid_of(b.m);
    struct sph_ray ray = REAL_RAY;
    *hit = (sphaera_hit){.id = SPHAERA_NONE};
    switch (quantise(&grid, origin, direction, &ray)) {
    case NOT_FINITE:
        sph_fail(&err, "origin or direction is not finite");
        return sph_api_failed(&err, error);
    case NO_LENGTH:
        sph_fail(&err, "direction has no length");
        return sph_api_failed(&err, error);
    case OUTSIDE:
        sph_fail(&err, "origin lies outside the grid of %d bits a coordinate", b.m->profile.w);
        return sph_api_failed(&err, error);
    default:
        break;
    }
    sph_ray_setup(&b.m->profile, &ray);
    struct sph_hit found = find(&b, &ray, &hit->visits);
    if (!found.key) return 0;
    double longest = greatest(direction), unit = 0;
    for (int i = 0; i < 3; i++)
        unit += direction[i] / longest * (direction[i] / longest);
    hit->id = found.id;
    hit->inside = found.far;
    hit->key = found.key;
    hit->distance = distance(b.m, &ray, found.key);
    for (int i = 0; i < 3; i++)
        hit->point[i] = origin[i] + hit->distance * (direction[i] / longest) / sqrt(unit);
    return 0;
}
