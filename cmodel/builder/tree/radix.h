/* radix.h - stable sorting of many keys
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_RADIX_H
#define SPH_RADIX_H

#include <stddef.h>
#include <stdint.h>

/* Sorts n keys by their upper 32 bits, rising; those that are equal there stay in their order.
 * spare: as many. Returns which of the two holds them then. */
uint64_t *sph_radix(uint64_t *keys, uint64_t *spare, size_t n);

#endif
