/* keep.h - P_b of primitives, kept from frame to frame while they are still
 * SPDX-License-Identifier: Apache-2.0
 *
 * Park et al. 2011, section 4: log(P_b) is made once in a static scene, and for each frame where
 * coordinates change. A base is kept if its primitive does not move, is where and what it was in
 * the frame before, and the grid's step and the screen are the same. P_b is made of corners as the
 * scene has them, so it depends neither on where the grid lies nor on where the camera looks.
 */
#ifndef SPH_TEXTURE_KEEP_H
#define SPH_TEXTURE_KEEP_H

#include "math/flops.h"
#include "scene/texture_base.h"
#include "common/error.h"
#include "scene/scene.h"

struct sph_kept_base {
    struct sph_texture_shape shape; /* and the image's texels, of which the base was made */
    double texels;
    int base; /* s7.8, or SPH_NO_BASE */
};

struct sph_texture_bases {
    uint32_t n;                   /* primitives that there is room for, spheres, then facets */
    struct sph_kept_base *last;   /* of each, of the newest build */
    struct sph_texture_view view; /* that they hold for */
    /* of the newest build: */
    uint64_t computed, kept;
    struct sph_flops flops; /* of those computed */
};

#define SPH_NO_BASE INT32_MAX

/* Room for the bases of a scene, none known yet. -1 with a message if memory is out. */
int sph_bases_start(struct sph_texture_bases *bases, const struct sph_scene *scene,
                    struct sph_error *err);

void sph_bases_end(struct sph_texture_bases *bases);

/* Before a build: forgets the primitives that move, and all of them if the view is another. A scene
 * may have other primitives than the one before; those beyond the room are made anew. */
void sph_bases_frame(struct sph_texture_bases *bases, const struct sph_scene *scene,
                     const struct sph_texture_view *view);

/* Base of a primitive, kept or made from its shape. */
int sph_bases_of(struct sph_texture_bases *bases, uint32_t id,
                 const struct sph_texture_shape *shape, double texels);

#endif
