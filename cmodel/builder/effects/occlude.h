/* occlude.h - can a sphere stand between a light and a lit point of another?
 * SPDX-License-Identifier: Apache-2.0
 *
 * Exact integers, careful: "cannot" is proved for every point that the machine may reach, rounded
 * as it is. E is sph_point_error(), near is sph_nearness(): docs/design/builder.md.
 */
#ifndef SPH_OCCLUDE_H
#define SPH_OCCLUDE_H

#include "builder/grid/facets.h"
#include "builder/grid/near.h"

/* The primitives as the machine has them, and where its rays may start. */
struct sph_world {
    const struct sph_ball *balls;
    uint32_t n;
    const struct sph_profile *profile;
    const int32_t *eye;
    const struct sph_facets *facets;
    int mended; /* no pixel shows a point inside another sphere: nearest hits, or INTERPENETRATE */
};

/* The first ball that the eye is in or on; n if there is none. */
uint32_t sph_eye_ball(const struct sph_world *world);

enum { SPH_NOTHING_OCCLUDES, SPH_OCCLUDES, SPH_OCCLUDES_OWN, SPH_OCCLUDES_UNSURE };

/* A ball that may stand between light and receiver. */
struct sph_witness {
    uint32_t occluder, receiver;
    int light;
};

/* 8 * (distance of the centres + ball->r + error + 1) <= 7 * host->r, and host->r is at least four
 * times error + 1. */
int sph_deep(const struct sph_ball *host, const struct sph_ball *ball, const struct sph_profile *p);

/* Marks in buried[0..n-1] the balls that change nothing: alone and deep in another, which neither
 * the eye nor a light is in.
 *
 * Let A be deep in B. No ray from outside B finds A before B, and a shadow ray between points
 * outside B that meets A meets B. A ray that starts on B, at least rB - E from cB, makes no more
 * than a right angle with the normal but for errors, so it comes towards the centre by at most
 * rB / 4 and passes it at a distance whose square is at least
 * (rB - E)^2 - rB^2 / 16 > (7 rB / 8 - E - 1)^2. With FIRST a primary ray may end at A, but then
 * the probe finds the far side of B and the pixel is repeated: hence `mended`. */
void sph_buried(const struct sph_world *world, const int32_t (*lights)[3], int count,
                uint8_t *buried);

/* Most spheres among which buried ones are looked for. */
enum { SPH_MOST_BURIED = 2048 };

/* Looks for a light of lights[0..count-1] and two balls of which one may shade the other:
 * SPH_OCCLUDES. The eye is in a ball that the light is outside of: SPH_OCCLUDES_OWN (occluder,
 * light). Too many pairs to try: SPH_OCCLUDES_UNSURE.
 *
 * A shadow ray goes from at most E from a point of ball B to a light L. The segments from B to L
 * fill the balls of radius s rB around L + s (cB - L), 0 <= s <= 1. Ball A cannot shade B if A, its
 * radius grown by E, meets none of them: with w = cA - L, v = cB - L and a = rA + E,
 *     f(s) = (v.v - rB^2) s^2 - 2 (w.v + a rB) s + w.w - a^2 > 0    for all s of 0 .. 1
 * which the ends and, if the minimum lies between them, the discriminant decide. Its own ball
 * shades a point only from within, exactly if the light is outside: then the eye is in it. */
int sph_occlusion(const struct sph_world *world, const int32_t (*lights)[3], int count,
                  struct sph_witness *found);

/* Looks for a facet and a ball that are not farther apart than the error of hit points: 1 with
 * *facet and *ball, 0 if there are none, -1 if there are too many pairs to try. */
int sph_near_facet(const struct sph_world *world, uint32_t *facet, uint32_t *ball);

/* The ball around a light that keeps it from reaching anything, n if there is none: the eye is not
 * in it, the light is deep in it, and no other ball and no facet is near it.
 *
 * Every point outside ball A sees the light L through A, which the exact test finds. A point P of A
 * is hit from outside, at least rA - E from cA; of the vector from P to L, no longer than 2 rA, at
 * least rA / 8 points against the normal, so the cosine is below -1/16, its error below 2^-10. */
uint32_t sph_dark_ball(const struct sph_world *world, const int32_t light[3]);

#endif
