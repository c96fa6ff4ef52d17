/* fast.h - the walk of the tree, of a machine that was decoded once: the same hits and counts
 * SPDX-License-Identifier: Apache-2.0
 *
 * cmodel/trace is the text that the RTL is read beside, and stays as it is; here the same walk is
 * made for speed: docs/design/model.md. What is not known here is left to the literal functions,
 * once for a machine.
 */
#ifndef SPH_FAST_H
#define SPH_FAST_H

#include "core/frame.h"
#include "machine/machine.h"
#include "core/ray.h"

struct sph_fast;

/* How the children of a node are tested: by the best way that the processor has, or by plain C. */
enum { SPH_FAST_BEST, SPH_FAST_PLAIN };

/* Decodes a machine, sound or not, which stays as it is while this is in use. NULL if its tree is
 * of a kind that is not known here, or memory is out: then sph_traverse() is to be called. */
struct sph_fast *sph_fast_new(const struct sph_machine *m, int lanes);

void sph_fast_free(struct sph_fast *fast);

/* "avx2", "neon" or "plain": what tests the children; "bih", "boxes". */
const char *sph_fast_lanes(const struct sph_fast *fast);

/* As sph_traverse() of the machine through its tree: the same hit, counters, visits and errors. */
struct sph_hit sph_fast_trace(const struct sph_fast *fast, const struct sph_ray *ray,
                              struct sph_counters *c, uint32_t *visits, uint32_t *errors);

#endif
