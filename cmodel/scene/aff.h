/* aff.h - scenes of the Animated File Format
 * SPDX-License-Identifier: Apache-2.0
 *
 * J. Lext, U. Assarsson, T. Moeller: AFF, of BART, a Benchmark for Animated Ray Tracing, 2000: NFF
 * with includes, meshes, nested transforms and keyframes (docs/reference/scene_format.md#aff).
 */
#ifndef SPH_AFF_H
#define SPH_AFF_H

#include "scene/scene.h"

/* Does the name end in `.aff`, in letters of either size? */
int sph_aff_is(const char *path);

/* Reads an AFF file and what it includes, as it stands at options->at or options->time. 0, or -1
 * with "file:line: ..." in *err; on failure *scene holds nothing to free. */
int sph_aff_read(const char *path, const struct sph_read_options *options, struct sph_scene *scene,
                 struct sph_error *err);

#endif
