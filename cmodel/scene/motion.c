/* motion.c - see motion.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "scene/motion.h"

#include <stdlib.h>
#include <string.h>

#include "scene/prim.h"
#include "scene/edit.h"
#include "scene/vector.h"

int sph_scene_add_motion(struct sph_scene *scene, const struct sph_motion *motion,
                         struct sph_error *err) {
    uint32_t n = scene->n_motions;
    struct sph_motion *room = scene->motions;
    if (!(n & (n - 1))) room = realloc(room, (n ? 2 * (size_t)n : 1) * sizeof *room);
    if (!room)
        return sph_fail(err, "%s:%u: no memory for more than %u motions", scene->path, motion->line,
                        n);
    scene->motions = room;
    room[scene->n_motions++] = *motion;
    return 0;
}

static double growth(const struct sph_motion *m, uint32_t frame) {
    return 1 + frame * m->grow;
}

static struct sph_vec moved(const struct sph_motion *m, uint32_t frame, struct sph_vec p) {
    double by = growth(m, frame);
    return sph_vec_of(m->about.x + by * (p.x - m->about.x) + frame * m->step.x,
                      m->about.y + by * (p.y - m->about.y) + frame * m->step.y,
                      m->about.z + by * (p.z - m->about.z) + frame * m->step.z);
}

static void move_facet(struct sph_facet *f, const struct sph_motion *m, uint32_t frame) {
    const struct sph_prim_scene *kind = sph_prim_scene_of((uint32_t)f->kind);
    for (int k = 0; k < kind->points; k++)
        f->v[k] = moved(m, frame, f->v[k]);
    if (kind->grow) kind->grow(f, growth(m, frame));
}

/* Whether the numbers of a facet may stand in a file. */
static int facet_small(const struct sph_facet *f) {
    for (int k = 0; k < 3; k++)
        if (!sph_vec_small(f->v[k]) || !(fabs(f->st[k][0]) <= SPH_NUMBER_MAX) ||
            !(fabs(f->st[k][1]) <= SPH_NUMBER_MAX))
            return 0;
    return 1;
}

static int beyond(const struct sph_scene *scene, uint32_t line, uint32_t frame,
                  struct sph_error *err) {
    return sph_fail(err, "%s:%u: at frame %u it is moved beyond %g", scene->path, line, frame,
                    SPH_NUMBER_MAX);
}

int sph_scene_move(struct sph_scene *scene, uint32_t frame, struct sph_error *err) {
    uint32_t first, second;
    for (uint32_t i = 0; i < scene->n_motions; i++)
        if (!(growth(&scene->motions[i], frame) > 0))
            return sph_fail(err, "%s:%u: `move`: nothing is left at frame %u", scene->path,
                            scene->motions[i].line, frame);
    if (sph_scene_fly(scene, frame, err)) return -1;
    if (!frame || !scene->n_motions) return 0;
    for (uint32_t i = 0; i < scene->n_spheres; i++) {
        struct sph_sphere *s = &scene->spheres[i];
        if (!s->motion) continue;
        s->ctr = moved(&scene->motions[s->motion - 1], frame, s->ctr);
        s->rad *= growth(&scene->motions[s->motion - 1], frame);
        if (!sph_vec_small(s->ctr) || !(s->rad <= SPH_NUMBER_MAX))
            return beyond(scene, s->line, frame, err);
    }
    for (uint32_t i = 0; i < scene->n_facets; i++) {
        struct sph_facet *f = &scene->facets[i];
        if (!f->motion) continue;
        move_facet(f, &scene->motions[f->motion - 1], frame);
        if (!facet_small(f)) return beyond(scene, f->line, frame, err);
    }
    int found = sph_scene_duplicate(scene, &first, &second, err);
    if (found > 0)
        return sph_fail(err, "%s:%u: at frame %u the same sphere (centre and radius) as in line %u",
                        scene->path, scene->spheres[second].line, frame,
                        scene->spheres[first].line);
    return found;
}
