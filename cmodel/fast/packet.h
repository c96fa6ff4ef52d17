/* packet.h - many rays through the tree together: the same hits, without counts of work
 * SPDX-License-Identifier: Apache-2.0
 *
 * A packet's nodes are chosen for all of its rays, so that nobody knows what one of them would have
 * visited alone. What is hit does not depend on that if every node holds what lies below it, which
 * is looked at first. docs/design/model.md has the method.
 */
#ifndef SPH_FAST_PACKET_H
#define SPH_FAST_PACKET_H

#include "fast/fast.h"
#include "machine/machine.h"

enum { SPH_PACKET = 64 };

/* Rays of one kind: n of them, 1 .. SPH_PACKET. What is not there may be anything. */
struct sph_bundle {
    int n, kind, inside;              /* as in sph_ray; primary rays start at the same point */
    int32_t org[3][SPH_PACKET];       /* sW */
    int32_t dir[3][SPH_PACKET];       /* sWD */
    struct sph_skip skip[SPH_PACKET]; /* of shadow rays */
};

/* Ray i, without unit and what else is made of it but its square. */
struct sph_ray sph_bundle_ray(const struct sph_bundle *rays, int i);

/* 1 if packets give what sph_fast_trace() does of each ray without `first`: a sound tree of
 * spheres, in which no ray ends with an error, and widths whose products doubles hold exactly. */
int sph_packets_fit(const struct sph_fast *fast);

/* Nearest hits of primary rays. */
void sph_packet_nearest(const struct sph_fast *fast, const struct sph_bundle *rays,
                        struct sph_hit hits[SPH_PACKET]);

/* Bit i: something is between the origin of shadow ray i and its light. */
uint64_t sph_packet_hidden(const struct sph_fast *fast, const struct sph_bundle *rays);

#endif
