/* packets.h - what the ways of packets share; see packet.h
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_FAST_PACKETS_H
#define SPH_FAST_PACKETS_H

#include "fast/decoded.h"
#include "fast/packet.h"

struct sph_packet_way {
    void (*nearest)(const struct sph_fast *, const struct sph_bundle *, struct sph_hit *);
    uint64_t (*hidden)(const struct sph_fast *, const struct sph_bundle *);
};

/* packet_walk.h, compiled for what every processor of its kind has, and for AVX2: NULL where the
 * compiler knows none. */
extern const struct sph_packet_way sph_packet_plain;
extern const struct sph_packet_way *const sph_packet_avx2;

/* The hit of ray i on leaf record *leaf, in integers; with `best` of another record, >= 0, the one
 * of the two that counts, whose number is then *leaf. */
struct sph_hit sph_packet_exact(const struct sph_fast *fast, const struct sph_bundle *rays, int i,
                                int64_t best, uint32_t *leaf);

/* Ray i by itself. */
struct sph_hit sph_packet_alone(const struct sph_fast *fast, const struct sph_bundle *rays, int i);

#endif
