/* trace.c - one ray through the tree of a machine: see sphaera.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <math.h>

#include "sphaera/opaque.h"
#include "trace/traverse.h"
#include "trace/setup.h"

/* A vector of the scene in the camera's frame. */
static void turn(const struct sph_machine *m, const double v[3], double out[3]) {
    for (int i = 0; i < 3; i++) {
        const double *row = m->rotation + 3 * (size_t)i;
        out[i] = row[0] * v[0] + row[1] * v[1] + row[2] * v[2];
    }
}

/* Origin and direction of the ray in integers: the direction has all bits that it may have. */
static int quantise(const sphaera_machine *machine, const double origin[3],
                    const double direction[3], struct sph_ray *ray, struct sph_error *err) {
    const struct sph_machine *m = &machine->machine;
    double org[3], dir[3], scaled[3], longest = 0;
    int exponent;
    for (int i = 0; i < 3; i++)
        if (!isfinite(origin[i]) || !isfinite(direction[i]))
            return sph_fail(err, "origin or direction is not finite");
    for (int i = 0; i < 3; i++)
        longest = fmax(longest, fabs(direction[i]));
    if (!(longest > 0)) return sph_fail(err, "direction has no length");
    frexp(longest, &exponent); /* so that turned it is a normal number */
    for (int i = 0; i < 3; i++)
        scaled[i] = ldexp(direction[i], -exponent);
    turn(m, origin, org);
    turn(m, scaled, dir);
    longest = 0;
    for (int i = 0; i < 3; i++)
        longest = fmax(longest, fabs(dir[i]));
    double least = -ldexp(1, m->profile.w - 1), most = ldexp(1, m->profile.wd - 1) - 1;
    for (int i = 0; i < 3; i++) {
        double at = round(ldexp(org[i] - m->origin[i], -m->grid_log2));
        if (!(at >= least && at < -least))
            return sph_fail(err, "origin lies outside the grid: %g is not %g to %g grid units", at,
                            least, -least - 1);
        ray->org[i] = (int64_t)at;
        ray->dir[i] = (int64_t)round(dir[i] / longest * most);
    }
    return 0;
}

int sphaera_trace(const sphaera_machine *machine, const double origin[3], const double direction[3],
                  sphaera_hit *hit, sphaera_error *error) {
    if (sph_api_null(machine, "machine", error) || sph_api_null(origin, "origin", error) ||
        sph_api_null(direction, "direction", error) || sph_api_null(hit, "hit", error))
        return -1;
    SPH_API_ENVIRONMENT;
    const struct sph_machine *m = &machine->machine;
    struct sph_error err = {""};
    struct sph_counters counters = {{0}};
    struct sph_ray ray = {.kind = SPH_PRIMARY, .skip = {SPH_ID_NONE, 0}, .inside = 1};
    uint32_t visits = 0, errors = 0;
    *hit = (sphaera_hit){.id = SPHAERA_NONE};
    if (quantise(machine, origin, direction, &ray, &err)) return sph_api_failed(&err, error);
    sph_ray_setup(&m->profile, &ray);
    struct sph_hit found = sph_traverse(m, &ray, SPH_TRAVERSE_TREE, &counters, &visits, &errors);
    hit->visits = visits;
    if (!found.key) return 0;
    double longest = 0, unit = 0, t = (double)found.key / (double)ray.a;
    for (int i = 0; i < 3; i++)
        longest = fmax(longest, fabs(direction[i]));
    for (int i = 0; i < 3; i++)
        unit += direction[i] / longest * (direction[i] / longest);
    hit->id = found.id;
    hit->inside = found.far;
    hit->key = found.key;
    hit->distance = ldexp(t * sqrt((double)ray.a), m->grid_log2);
    for (int i = 0; i < 3; i++)
        hit->point[i] = origin[i] + hit->distance * (direction[i] / longest) / sqrt(unit);
    return 0;
}
