/* cut.c - see cut.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "reference/cut.h"

#include <math.h>

#include "reference/facet.h"
#include "reference/meet.h"
#include "reference/reference.h"
#include "reference/tree.h"
#include "reference/world.h"

enum { SAMPLE = 4096 }; /* pixels of the small frame, at most */

struct planes {
    const struct sph_scene *scene;
    uint32_t n, facet[SPH_MAX_PLANES];
    uint64_t seen[SPH_MAX_PLANES]; /* beyond the grid, by how many pixels */
};

/* The plane that the ray meets first, as an index; -1 if none. *t: where. */
static int first_plane(const struct planes *p, const struct sph_ref_ray *ray, double *t) {
    struct sph_ref_cast cast = sph_ref_cast(ray);
    int first = -1;
    *t = INFINITY;
    for (uint32_t i = 0; i < p->n; i++) {
        struct sph_ref_meet m;
        if (!sph_ref_facet(&p->scene->facets[p->facet[i]], &cast, &m)) continue;
        if (m.met && m.t < *t) *t = m.t, first = (int)i;
    }
    return first;
}

/* Whether nothing hides the plane at t; makes the tree when it is first asked. -1: no memory. */
static int seen_at(const struct planes *p, const struct sph_ref_ray *ray, double t,
                   struct sph_ref_tree **tree) {
    if (!*tree) *tree = sph_ref_tree_new(p->scene);
    return *tree ? !(sph_ref_trace(*tree, ray, t, 1).t < t) : -1;
}

/* What the eye sees. The planes alone tell for most pixels: few rays meet them beyond the grid. */
static int measure_primary(struct planes *p, const struct sph_machine *m,
                           const struct sph_ref_view *view, struct sph_cut *cut) {
    struct sph_ref_tree *tree = NULL;
    struct sph_ends ends = sph_ends_of(m);
    int seen = 0;
    for (int y = 0; y < view->height && seen >= 0; y++)
        for (int x = 0; x < view->width && seen >= 0; x++) {
            struct sph_ref_ray ray = {.org = {view->eye[0], view->eye[1], view->eye[2]},
                                      .skip = SPH_ID_NONE};
            double t, length = 0;
            sph_ref_view_dir(view, x, y, ray.dir);
            int plane = first_plane(p, &ray, &t);
            if (plane < 0) continue;
            const struct sph_facet *f = &p->scene->facets[p->facet[plane]];
            if (!sph_ends_show(&ends, p->scene, f, ray.org, ray.dir, t)) continue;
            for (int i = 0; i < 3; i++)
                length += t * ray.dir[i] * t * ray.dir[i];
            seen = seen_at(p, &ray, t, &tree);
            if (seen <= 0) continue;
            cut->beyond++;
            p->seen[plane]++;
            cut->nearest = fmin(cut->nearest, sqrt(length));
        }
    sph_ref_tree_free(tree);
    return seen < 0 ? -1 : 0;
}

/* What mirrors and glass show, in a frame of fewer pixels. */
static int measure_later(const struct sph_scene *scene, const struct sph_machine *m,
                         const struct sph_ref_view *view, struct sph_cut *cut,
                         struct sph_error *err) {
    int by = (int)ceil(sqrt((double)cut->pixels / SAMPLE));
    struct sph_reference small;
    struct sph_reference_options o = {.width = (view->width + by - 1) / by,
                                      .height = (view->height + by - 1) / by,
                                      .max_depth = m->regs[SPH_REG_MAX_DEPTH],
                                      .reflect = sph_machine_effect(m, SPH_EFFECT_REFLECT),
                                      .refract = sph_machine_effect(m, SPH_EFFECT_REFRACT),
                                      .world = m};
    if (!o.max_depth || (!o.reflect && !o.refract)) return 0;
    if (sph_reference_render(scene, &o, &small, err)) return -1;
    cut->sample = (uint64_t)o.width * (uint64_t)o.height;
    for (uint64_t i = 0; i < cut->sample; i++)
        cut->later += small.pixels[i].beyond == SPH_BEYOND_LATER;
    sph_reference_free(&small);
    return 0;
}

int sph_cut_measure(const struct sph_scene *scene, const struct sph_machine *m, struct sph_cut *cut,
                    struct sph_error *err) {
    struct planes p = {.scene = scene};
    struct sph_ref_view view;
    *cut = (struct sph_cut){.nearest = INFINITY};
    for (uint32_t i = 0; i < scene->n_facets && p.n < SPH_MAX_PLANES; i++)
        if (sph_ref_facet_unbounded(&scene->facets[i])) p.facet[p.n++] = i;
    if (!p.n ||
        !sph_ref_view_of(&scene->camera, m->regs[SPH_REG_FRAME_W], m->regs[SPH_REG_FRAME_H], &view))
        return 0;
    cut->pixels = (uint64_t)view.width * (uint64_t)view.height;
    if (measure_primary(&p, m, &view, cut))
        return sph_fail(err, "%s: no memory for %u spheres", scene->path, scene->n_spheres);
    for (uint32_t i = 1, most = 0; i < p.n; i++)
        if (p.seen[i] > p.seen[most]) most = i, p.facet[0] = p.facet[i];
    cut->plane = p.facet[0];
    return measure_later(scene, m, &view, cut, err);
}
