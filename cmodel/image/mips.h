/* mips.h - the images of a scene, read before it is built
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_IMAGE_MIPS_H
#define SPH_IMAGE_MIPS_H

#include "common/error.h"
#include "scene/scene.h"
#include "texture/texel.h"

/* Reads the images of a scene, n_textures of them in its order; a file that stands twice is read
 * once and shares its texels. 0, or -1 with scene, line, file and reason, and nothing to free. */
int sph_mips_load(const struct sph_scene *scene, struct sph_mip **mips, struct sph_error *err);

void sph_mips_free(struct sph_mip *mips, uint32_t n);

#endif
