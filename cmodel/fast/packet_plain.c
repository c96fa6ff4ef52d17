/* packet_plain.c - packets by what every processor of its kind has; see packet_walk.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "fast/packet_walk.h"

const struct sph_packet_way sph_packet_plain = {packet_nearest, packet_hidden};
