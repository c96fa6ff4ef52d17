/* nff_writer.h - what the files that write NFF records share
 * SPDX-License-Identifier: Apache-2.0
 *
 * Numbers are written with 15 digits where these give the same double back, with 17 otherwise.
 */
#ifndef SPH_SCENE_NFF_WRITER_H
#define SPH_SCENE_NFF_WRITER_H

#include "scene/scene.h"

/* Where to, and what the primitives that are written next look like. */
struct sph_nff_writer {
    const struct sph_scene *scene;
    FILE *file;
    uint32_t material, texture, motion;
    int shading; /* -1: none; 0, 1: sum.on of the materials that `shading` is for */
    int clear;   /* `shadows clear` is */
};

/* A record: its word, then numbers; and with one vector. */
void sph_nff_put(struct sph_nff_writer *w, const char *word, const double *values, int n);
void sph_nff_put_point(struct sph_nff_writer *w, const char *word, struct sph_vec v);

/* Each writes a record if what comes next looks otherwise than what was before: `f`, `shading`
 * and `shadows`, `move` or `still`, `texture` of spheres and planes. */
void sph_nff_put_material(struct sph_nff_writer *w, uint32_t material);
void sph_nff_put_motion(struct sph_nff_writer *w, uint32_t motion);
void sph_nff_put_texture(struct sph_nff_writer *w, uint32_t texture);

/* The name that an image has in a file: its path without the folder of the scene. */
const char *sph_nff_image_name(const struct sph_scene *scene, const char *path);

/* ` srgb` or ` linear`, if the texture has one of them. */
void sph_nff_put_colours(struct sph_nff_writer *w, uint32_t texture);

/* A word and this name, quoted where it must be. The line does not end. */
void sph_nff_put_image(struct sph_nff_writer *w, const char *word, const char *path);

#endif
