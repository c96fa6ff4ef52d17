/* pixel_rays.h - the rays of a pixel, for `sphaera info --pixel`
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_PIXEL_RAYS_H
#define SPH_PIXEL_RAYS_H

#include <stdio.h>

#include "core/ray_log.h"
#include "core/stages.h"
#include "machine/machine.h"
#include "tool/json.h"

/* Traces pixel x, y, which must lie in the frame, into log, and stage by stage into stages, which
 * may be NULL. -1 with a message if memory is out. */
int pixel_rays(const struct sph_machine *m, int x, int y, struct sph_ray_log *log,
               struct sph_stages *stages, struct sph_error *err);

/* Prints them as a tree; to may be NULL. */
void print_rays(FILE *to, const struct sph_ray_log *log);

/* Prints the stages, a line each; to may be NULL. */
void print_stages(FILE *to, const struct sph_machine *m, const struct sph_stages *stages);

/* Adds them as the members `pixel_rays` and `stages`. */
void report_rays(json_t *report, const struct sph_ray_log *log);
void report_stages(json_t *report, const struct sph_machine *m, const struct sph_stages *stages);

#endif
