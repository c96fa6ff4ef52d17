/* bih_walk.h - one ray through a bounding interval hierarchy          RTL: rtl/trace/rt_bih.v
 * SPDX-License-Identifier: Apache-2.0
 *
 * Aroxa 2014, III.B, Listing 3.5; docs/design/bih.md has every rule and what of the listing is
 * mended. Planes first, then the global box, then nodes, the nearer of two children first. Which
 * nodes a ray visits, and which leaf records it tests, depends on the ray alone.
 */
#ifndef SPH_BIH_WALK_H
#define SPH_BIH_WALK_H

#include "trace/traverse.h"

/* As sph_traverse() of a machine with a BIH. *gaps, if not NULL: grows by the inner nodes visited
 * of which the ray meets no child, the empty space of Aroxa IV.D. */
struct sph_hit sph_bih_walk(const struct sph_machine *m, const struct sph_ray *ray,
                            struct sph_counters *c, uint32_t *visits, uint32_t *errors,
                            uint32_t *gaps);

#endif
