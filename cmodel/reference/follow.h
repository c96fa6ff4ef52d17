/* follow.h - what a ray of the double reference sees, and what the rays after it see
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_REFERENCE_FOLLOW_H
#define SPH_REFERENCE_FOLLOW_H

#include "reference/reference.h"
#include "reference/tree.h"
#include "reference/view.h"

struct sph_ref_job {
    const struct sph_scene *scene;
    const struct sph_reference_options *o;
    const struct sph_ref_tree *tree;
    struct sph_ref_view view;
    struct sph_ref_textures textures;
};

/* A ray on its way. */
struct sph_ref_branch {
    struct sph_ref_ray ray;
    struct sph_ref_path path;
    double weight;
    int depth, mirrored; /* it is a mirror ray */
    int via;             /* SPH_VIA_* */
};

struct sph_ref_seen {
    struct sph_reference_pixel pixel;
    struct sph_level_work *work;
    double sum[SPH_FRAMES][3]; /* as the frames of the machine: docs/model/refraction.md */
};

/* Adds all that the ray sees to *seen. */
void sph_ref_follow(const struct sph_ref_job *j, struct sph_ref_branch b,
                    struct sph_ref_seen *seen);

#endif
