/* pick.h - the rays of one pixel, drawn
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_VIEW_PICK_H
#define SPH_VIEW_PICK_H

#include "core/frame.h"
#include "core/ray_log.h"
#include "view/workers.h"

/* A ray as it is drawn, in the scene's frame. */
struct view_ray {
    int kind, hit;           /* SPH_PRIMARY ..; something is */
    struct sph_vec from, to; /* to: the hit, the light, or far away */
};

struct view_rays {
    struct view_ray *list;
    int n;
};

/* Traces pixel x, y of a job; the log and the pixel say what its rays are, and *rays where. far:
 * how long a ray is that hits nothing, scene units. -1 without memory; the log is to be freed
 * either way, and *rays with view_rays_free(). */
int view_pick(const struct view_job *job, int x, int y, double far, struct sph_pixel *pixel,
              struct sph_ray_log *log, struct view_rays *rays);

void view_rays_free(struct view_rays *rays);

/* Draws them over a picture of width x height pixels of 0xBBGGRR, and a cross where the first one
 * ends: shadow rays yellow, red if blocked; mirror rays cyan, refracted ones magenta. */
void view_rays_draw(const struct view_rays *rays, const struct sph_camera *camera, int width,
                    int height, uint32_t *pixels);

#endif
