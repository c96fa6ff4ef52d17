/* packet_avx2.c - packets, compiled with -mavx2; see packet_walk.h
 * SPDX-License-Identifier: Apache-2.0
 */
#ifdef __AVX2__
#include "fast/packet_walk.h"

static const struct sph_packet_way way = {packet_nearest, packet_hidden};
const struct sph_packet_way *const sph_packet_avx2 = &way;
#else
#include "fast/packets.h"

const struct sph_packet_way *const sph_packet_avx2 = NULL;
#endif
