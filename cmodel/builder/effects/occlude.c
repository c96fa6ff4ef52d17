/* occlude.c - shadows that can be, and lights that cannot get out; see occlude.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * A shadow ray starts at most the error of hit points away from its sphere B. The rays from B to
 * the light fill the balls of radius s*B.r around L + s*(B.c - L), s = 0..1. If A, grown by the
 * error, meets none of them, |w - s*v| > a + s*b for w = A.c - L, v = B.c - L and all those s:
 *
 *     f(s) = (v.v - b^2) s^2 - 2 (w.v + a*b) s + w.w - a^2 > 0
 */
#include "builder/effects/occlude.h"

#include <string.h>

#include "builder/prim/build.h"

enum { MOST_TRIES = 1 << 22 }; /* pairs of spheres compared, times lights */

typedef __int128 wide;

static int64_t dot(const int64_t a[3], const int64_t b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static int comes_near(const struct sph_grid_facet *facet, const struct sph_ball *ball,
                      const struct sph_profile *p) {
    return sph_prim_build_of((uint32_t)facet->kind)->near(facet, ball, p);
}

int sph_near_facet(const struct sph_world *w, uint32_t *facet, uint32_t *ball) {
    uint64_t tries = (uint64_t)w->n * w->facets->n;
    for (uint32_t i = 0; i < w->facets->n; i++)
        for (uint32_t j = 0; j < w->n; j++) {
            if (tries > MOST_TRIES) return -1;
            if (!comes_near(&w->facets->list[i], &w->balls[j], w->profile)) continue;
            *facet = i, *ball = j;
            return 1;
        }
    return 0;
}

uint32_t sph_eye_ball(const struct sph_world *world) {
    uint32_t i = 0;
    while (i < world->n && sph_ball_side(&world->balls[i], world->eye) < 0)
        i++;
    return i;
}

/* Whether f(s) <= 0 for an s of 0..1. */
static int meets(const int64_t w[3], int64_t a, const int64_t v[3], int64_t b) {
    int64_t p = dot(v, v) - b * b, q = dot(w, v) + a * b, r = dot(w, w) - a * a;
    if (r <= 0 || p - 2 * q + r <= 0) return 1; /* at an end */
    return q > 0 && q < p && (wide)q * q >= (wide)p * r;
}

/* From the light to the centre, in units of the error. */
static void from_light(const struct sph_ball *ball, const int32_t light[3], int bits,
                       int64_t out[3]) {
    for (int i = 0; i < 3; i++)
        out[i] = ((int64_t)ball->c[i] - light[i]) * (1ll << bits);
}

/* A ball around the eye with the light outside: it shades its own inner side. */
static int own(const struct sph_world *world, const int32_t (*lights)[3], int count,
               struct sph_witness *found) {
    for (uint32_t i = 0; i < world->n; i++) {
        if (sph_ball_side(&world->balls[i], world->eye) < 0) continue;
        for (int l = 0; l < count; l++)
            if (sph_ball_side(&world->balls[i], lights[l]) < 0) {
                *found = (struct sph_witness){i, i, l};
                return 1;
            }
    }
    return 0;
}

int sph_occlusion(const struct sph_world *world, const int32_t (*lights)[3], int count,
                  struct sph_witness *found) {
    int bits = sph_error_bits(world->profile), tries = 0;
    int64_t error = sph_point_error(world->profile);
    if (own(world, lights, count, found)) return SPH_OCCLUDES_OWN;
    if (world->n < 2 || !count) return SPH_NOTHING_OCCLUDES;
    uint8_t buried[SPH_MOST_BURIED] = {0};
    int small = world->n <= SPH_MOST_BURIED;
    if (small) sph_buried(world, lights, count, buried);
    for (int l = 0; l < count; l++)
        for (uint32_t j = 0; j < world->n; j++) {
            if (small && buried[j]) continue;
            int64_t v[3], w[3], b = (int64_t)world->balls[j].r << bits;
            from_light(&world->balls[j], lights[l], bits, v);
            for (uint32_t i = 0; i < world->n; i++) {
                if (i == j || (small && buried[i])) continue;
                if (tries++ == MOST_TRIES) return SPH_OCCLUDES_UNSURE;
                from_light(&world->balls[i], lights[l], bits, w);
                if (!meets(w, ((int64_t)world->balls[i].r << bits) + error, v, b)) continue;
                *found = (struct sph_witness){i, j, l};
                return SPH_OCCLUDES;
            }
        }
    return SPH_NOTHING_OCCLUDES;
}

uint32_t sph_dark_ball(const struct sph_world *world, const int32_t light[3]) {
    uint32_t around = world->n;
    for (uint32_t i = 0; i < world->n; i++) {
        if (sph_ball_side(&world->balls[i], light) < 0) continue;
        if (around < world->n) return world->n; /* two that hold it overlap */
        around = i;
    }
    if (around == world->n) return around;
    const struct sph_ball *ball = &world->balls[around];
    struct sph_ball lamp = {{light[0], light[1], light[2]}, 0};
    if (sph_ball_side(ball, world->eye) >= 0 || !sph_deep(ball, &lamp, world->profile))
        return world->n;
    for (uint32_t i = 0; i < world->n; i++)
        if (i != around && sph_nearness(ball, &world->balls[i], world->profile) != SPH_APART)
            return world->n;
    for (uint32_t i = 0; i < world->facets->n; i++)
        if (comes_near(&world->facets->list[i], ball, world->profile)) return world->n;
    return around;
}

/* The only ball near `host`; n if there is none or more than one. */
static uint32_t only_neighbour(const struct sph_world *world, uint32_t host) {
    uint32_t found = world->n;
    for (uint32_t i = 0; i < world->n; i++) {
        if (i == host) continue;
        if (sph_nearness(&world->balls[host], &world->balls[i], world->profile) == SPH_APART)
            continue;
        if (found < world->n) return world->n;
        found = i;
    }
    return found;
}

int sph_deep(const struct sph_ball *host, const struct sph_ball *ball,
             const struct sph_profile *p) {
    int64_t unit = 1ll << sph_error_bits(p), more = sph_point_error(p) + unit, apart = 0;
    int64_t room = (7ll * host->r - 8ll * ball->r) * unit - 8 * more;
    for (int i = 0; i < 3; i++) {
        int64_t d = (int64_t)host->c[i] - ball->c[i];
        apart += d * d;
    }
    __int128 reach = (__int128)64 * unit * unit * apart;
    return host->r * unit >= 4 * more && room >= 0 && reach <= (__int128)room * room;
}

void sph_buried(const struct sph_world *world, const int32_t (*lights)[3], int count,
                uint8_t *buried) {
    memset(buried, 0, world->n);
    if (!world->mended) return;
    for (uint32_t i = 0; i < world->n; i++) {
        const struct sph_ball *host = &world->balls[i];
        int empty = sph_ball_side(host, world->eye) < 0;
        for (int l = 0; l < count; l++)
            empty = empty && sph_ball_side(host, lights[l]) < 0;
        uint32_t in = empty ? only_neighbour(world, i) : world->n;
        if (in < world->n && sph_deep(host, &world->balls[in], world->profile)) buried[in] = 1;
    }
}
