/* sample.h - the rays of some pixels of a frame, for which trees are made
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_SAMPLE_H
#define SPH_SAMPLE_H

#include "common/error.h"
#include "core/ray_log.h"
#include "machine/machine.h"

/* What is done with a ray of the sample and what it found; of several threads at a time. */
typedef void sph_sample_look(void *user, const struct sph_logged *ray);

/* Traces the rays of the pixels in the middles of at most 32 x 18 equal parts of the machine's
 * frame. Which rays there are does not depend on its tree. -1 if memory is out. */
int sph_sample(const struct sph_machine *machine, sph_sample_look *look, void *user,
               struct sph_error *err);

#endif
