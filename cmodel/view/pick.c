/* pick.c - see pick.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "view/pick.h"

#include <math.h>
#include <stdlib.h>

#include "engine/render_pixel.h"

/* A point of the grid in the scene. */
static struct sph_vec world(const struct sph_machine *m, const double at[3]) {
    double p[3], out[3] = {0, 0, 0};
    for (int i = 0; i < 3; i++)
        p[i] = m->origin[i] + ldexp(at[i], m->grid_log2);
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            out[k] += m->rotation[3 * i + k] * p[i];
    return (struct sph_vec){out[0], out[1], out[2]};
}

/* Where a ray is drawn. The key of a hidden light says nothing of the place. */
static struct view_ray drawn(const struct sph_machine *m, const struct sph_logged *l, double far) {
    struct view_ray r = {.kind = l->ray.kind, .hit = l->hit.key != 0};
    double from[3], to[3], length = sqrt((double)l->ray.a),
                           end = ldexp(far, -m->grid_log2) / length;
    if (sph_ray_ends(&l->ray))
        end = 1;
    else if (r.hit)
        end = (double)l->hit.key / (double)l->ray.a;
    for (int i = 0; i < 3; i++) {
        from[i] = (double)l->ray.org[i];
        to[i] = from[i] + end * (double)l->ray.dir[i];
    }
    r.from = world(m, from);
    r.to = world(m, to);
    return r;
}

int view_pick(const struct view_job *job, int x, int y, double far, struct sph_pixel *pixel,
              struct sph_ray_log *log, struct view_rays *rays) {
    struct sph_machine m;
    const struct sph_render_options how = {
        .traverse = SPH_TRAVERSE_FAST, .fast = job->fast, .log = log};
    struct sph_counters counters = {{0}};
    uint32_t errors = 0;
    *rays = (struct view_rays){0};
    *log = (struct sph_ray_log){0};
    view_aim_start(job->machine, &job->aim, &m);
    view_aim_pixel(&job->aim, x, y, &m);
    *pixel = sph_render_pixel(&m, &how, x, y, &counters, &errors, NULL);
    rays->list = malloc(((size_t)log->n + 1) * sizeof *rays->list);
    if (log->full || !rays->list) {
        view_rays_free(rays);
        return -1;
    }
    for (; rays->n < log->n; rays->n++)
        rays->list[rays->n] = drawn(&m, &log->rays[rays->n], far);
    return 0;
}

void view_rays_free(struct view_rays *rays) {
    free(rays->list);
    *rays = (struct view_rays){0};
}
