/* view.h - the golden model live: a window in which one moves through a scene
 * SPDX-License-Identifier: Apache-2.0
 *
 *     inputs -> state -> job (a snapshot) -> workers -> picture -> screen
 *                  `--> makers: machine, double reference
 *
 * The thread that calls view_run() takes inputs and shows pictures, and never waits for more than
 * a pixel: docs/reference/tool.md has how.
 */
#ifndef SPH_VIEW_H
#define SPH_VIEW_H

#include <stdio.h>

#include "builder/build.h"
#include "core/ray_log.h"

struct view_options {
    const struct sph_scene *scene;
    struct sph_build_options build;                              /* with its images */
    int threads;                                                 /* 0: one for every processor */
    const char *script, *record;                                 /* files, NULL: none */
    void (*print_rays)(FILE *to, const struct sph_ray_log *log); /* of a pixel that is clicked */
};

/* Shows the scene until the user ends it, or the script. 0, or -1 with a message. *left: 1 if
 * something is still being made of the scene, which must not be freed then. */
int view_run(const struct view_options *options, int *left, struct sph_error *err);

#endif
