/* texture.h - the naive model's textures, by the definitions of docs/design/textures.md
 * SPDX-License-Identifier: Apache-2.0
 *
 * Angles and logarithms come from the library instead of tables, coordinates from GMP.
 */
#ifndef SPH_NAIVE_TEXTURE_H
#define SPH_NAIVE_TEXTURE_H

#include "naive/hit.h"
#include "texture/coords.h" /* struct sph_longitude alone */

/* From the eye to where a ray begins, or to its hit. */
struct sph_naive_path {
    uint64_t length; /* u(W+4).4 grid units */
    int spread;      /* k: a pixel's footprint grows 2^k times as fast as along a primary ray */
    uint32_t bend;   /* of the surface that the ray left, 0: flat */
};

/* The path to what the ray hits with this key. */
void sph_naive_path_add(const struct sph_machine *m, const struct sph_ray *ray, uint64_t key,
                        struct sph_naive_path *path);

/* The texel, 0xAABBGGRR, that a surface's colour is multiplied by; white if it has no texture or
 * memory has no such image. *seen is the frame's word of the pixel, which the fetches change. */
uint32_t sph_naive_texel(const struct sph_machine *m, const struct sph_naive_found *f,
                         const struct sph_naive_point *s, uint64_t length, uint32_t *seen);

/* Longitude and latitude of v, s2.16. */
struct sph_longitude sph_naive_longitude(const int64_t v[3]);

/* round(256 log2 x), x >= 1, of x rounded half up to nine significant bits. */
int64_t sph_naive_log2(uint64_t x);

#endif
