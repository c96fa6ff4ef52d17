/* texture.h - images as textures: read and made smaller, through OpenImageIO
 * SPDX-License-Identifier: Apache-2.0
 *
 * The C face of texture.cpp.
 */
#ifndef SPH_IMAGE_TEXTURE_H
#define SPH_IMAGE_TEXTURE_H

#ifdef __cplusplus
extern "C" {
#endif

#include "common/error.h"
#include "texture/texel.h"

/* lazy.c looks for these by name */
#pragma GCC visibility push(default)

/* Reads an image of any kind that OpenImageIO knows, or a PNG or JPEG that is a part of a file,
 * "file#first+bytes", and makes its MIP chain. One channel is grey,
 * two are grey and alpha; of more the first three are the colour, the fourth is alpha if the file
 * says so; without alpha it is 1. Whole numbers are taken by their range, real ones limited to
 * 0 .. 1. Texels are linear light. colours: SPH_COLOURS_*; by the file it is decoded from sRGB, or
 * from the gamma that the file has, unless the file says that it is linear, or says nothing and has
 * real numbers or whole ones of more than 8 bits. Colour that the file has multiplied by alpha is
 * divided by it, unless some of it is larger than its alpha.
 * Level l + 1 is the box-filtered half of level l, in float; each is rounded once, to bytes.
 * 0; or -1 with file and reason, and nothing to free: missing, no regular file, damaged, no pixels,
 * more than SPH_TEXTURE_SIDE on a side, more bytes than such an image needs, a volume, deep
 * pixels. */
int sph_mip_load(const char *path, int colours, struct sph_mip *mip, struct sph_error *err);

void sph_mip_free(struct sph_mip *mip);

#pragma GCC visibility pop

#ifdef __cplusplus
}
#endif

#endif
