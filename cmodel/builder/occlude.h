/* occlude.h - can a sphere stand between a light and a lit point of another?
 * SPDX-License-Identifier: Apache-2.0
 *
 * Exact integers, careful: "cannot" is proved for every point that the machine may reach, rounded
 * as it is (docs/model/build.md).
 */
#ifndef SPH_OCCLUDE_H
#define SPH_OCCLUDE_H

#include "builder/facets.h"
#include "builder/near.h"

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
 * the eye nor a light is in. */
void sph_buried(const struct sph_world *world, const int32_t (*lights)[3], int count,
                uint8_t *buried);

/* Most spheres among which buried ones are looked for. */
enum { SPH_MOST_BURIED = 2048 };

/* Looks for a light of lights[0..count-1] and two balls of which one may shade the other:
 * SPH_OCCLUDES. The eye is in a ball that the light is outside of: SPH_OCCLUDES_OWN (occluder,
 * light). Too many pairs to try: SPH_OCCLUDES_UNSURE. */
int sph_occlusion(const struct sph_world *world, const int32_t (*lights)[3], int count,
                  struct sph_witness *found);

/* Looks for a facet and a ball that are not farther apart than the error of hit points: 1 with
 * *facet and *ball, 0 if there are none, -1 if there are too many pairs to try. */
int sph_near_facet(const struct sph_world *world, uint32_t *facet, uint32_t *ball);

/* The ball around a light that keeps it from reaching anything, n if there is none: the eye is not
 * in it, the light is deep in it, and no other ball and no facet is near it. */
uint32_t sph_dark_ball(const struct sph_world *world, const int32_t light[3]);

#endif
