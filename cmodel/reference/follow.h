/* follow.h - what a ray of the double reference sees, and what the rays after it see
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_REFERENCE_FOLLOW_H
#define SPH_REFERENCE_FOLLOW_H

#include "reference/reference.h"
#include "reference/tree.h"
#include "reference/view.h"
#include "reference/world.h"

struct sph_ref_job {
    const struct sph_scene *scene;
    const struct sph_reference_options *o;
    const struct sph_ref_tree *tree;
    struct sph_ref_view view;
    struct sph_ref_textures textures;
    const struct sph_ends *ends; /* planes beyond are met there, as a machine does; NULL: nowhere */
};

/* A ray on its way. */
struct sph_ref_branch {
    struct sph_ref_ray ray;
    struct sph_ref_path path;
    double weight;
    int depth, mirrored; /* it is a mirror ray */
    int via;             /* SPH_VIA_* */
};

enum { SPH_REF_STEPS = 16 }; /* of a pixel that are kept; the first ones */

/* A ray and what it met. */
struct sph_ref_step {
    struct sph_ref_ray ray;
    struct sph_ref_hit hit;
    int depth;
    double at[3], normal[3];               /* unless nothing is met, as all below */
    uint32_t faced, blocked;               /* as in sph_reference_pixel */
    struct sph_ref_hit by[SPH_MAX_LIGHTS]; /* what blocks light l, t as a part of the way to it */
    double swing[3]; /* of the pixel's colour, if the normal turned by a radian: at most */
};

/* The rays of a pixel, in the order in which they were followed. */
struct sph_ref_log {
    int n;
    struct sph_ref_step step[SPH_REF_STEPS];
};

struct sph_ref_seen {
    struct sph_reference_pixel pixel;
    struct sph_ref_log *log; /* may be NULL */
    struct sph_level_work *work;
    double sum[SPH_FRAMES][3]; /* as the frames of the machine: docs/design/shading.md */
};

/* Adds all that the ray sees to *seen. */
void sph_ref_follow(const struct sph_ref_job *j, struct sph_ref_branch b,
                    struct sph_ref_seen *seen);

/* What the primary ray of a pixel sees, into *seen, whose log and work are given. */
void sph_ref_sample_of(const struct sph_ref_job *j, int x, int y, struct sph_ref_seen *seen);

#endif
