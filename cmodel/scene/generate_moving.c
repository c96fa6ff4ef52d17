/* generate_moving.c - sets a generated scene in motion; see generate.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * Spheres, polygons and cones drift, each in a direction of its own; the camera goes round the axis
 * `up` through the point that it looks at.
 */
#include "common/number.h"
#include "machine/records.h"
#include "scene/affine.h"
#include "scene/generate_kinds.h"
#include "scene/motion.h"
#include "scene/rng.h"

#include <math.h>

/* Between two places of the camera: the curve is 0.01 % off the circle. */
#define KEY_DEGREES 15.0

/* Any direction, as likely as any other (Archimedes: heights on a sphere are evenly spread). */
static int add_drift(struct sph_rng *rng, double step, struct sph_scene *scene, uint32_t *motion,
                     struct sph_error *err) {
    double z = sph_rng_range(rng, -1, 1), angle = sph_rng_range(rng, 0, 2 * M_PI);
    double across = sqrt(1 - z * z);
    struct sph_motion m = {
        .step = {step * across * cos(angle), step * across * sin(angle), step * z}};
    if (sph_scene_add_motion(scene, &m, err)) return -1;
    *motion = scene->n_motions;
    return 0;
}

static int together(const struct sph_facet *a, const struct sph_facet *b) {
    return !sph_kind_unbounded((uint32_t)a->kind) &&
           (b->frustum ? a->frustum == b->frustum : a->group == b->group);
}

static int drift(const struct sph_generate_options *o, struct sph_scene *scene,
                 struct sph_error *err) {
    struct sph_rng rng = {~o->seed};
    for (uint32_t i = 0; i < scene->n_spheres; i++)
        if (add_drift(&rng, o->drift, scene, &scene->spheres[i].motion, err)) return -1;
    for (uint32_t i = 0; i < scene->n_facets; i++) {
        struct sph_facet *f = &scene->facets[i];
        if (sph_kind_unbounded((uint32_t)f->kind)) continue;
        if (i && together(f - 1, f))
            f->motion = f[-1].motion;
        else if (add_drift(&rng, o->drift, scene, &f->motion, err))
            return -1;
    }
    return 0;
}

/* v turned about a unit vector (Rodrigues' formula). */
static struct sph_vec turned(struct sph_vec v, struct sph_vec axis, double angle) {
    struct sph_vec side = sph_vec_cross(axis, v);
    double c = cos(angle), s = sin(angle), along = (1 - c) * sph_vec_dot(axis, v);
    return sph_vec_of(c * v.x + s * side.x + along * axis.x, c * v.y + s * side.y + along * axis.y,
                      c * v.z + s * side.z + along * axis.z);
}

static int orbit(const struct sph_generate_options *o, struct sph_scene *scene,
                 struct sph_error *err) {
    const struct sph_camera *camera = &scene->camera;
    double frames = fmax(1, floor(KEY_DEGREES / o->orbit));
    struct sph_vec axis = camera->up, arm = sph_vec_sub(camera->from, camera->at);
    double length = sph_vec_length(axis);
    axis = sph_vec_of(axis.x / length, axis.y / length, axis.z / length);
    for (double at = frames; at * o->orbit <= 360 && at <= SPH_MAX_FRAME; at += frames) {
        struct sph_vec v = turned(arm, axis, at * o->orbit * M_PI / 180);
        struct sph_flight f = {
            .frame = (uint32_t)at,
            .at = camera->at,
            .from = {camera->at.x + v.x, camera->at.y + v.y, camera->at.z + v.z}};
        if (sph_scene_add_flight(scene, &f, err)) return -1;
    }
    return sph_scene_check_flights(scene, err);
}

int sph_make_moving(const struct sph_generate_options *o, struct sph_scene *scene,
                    struct sph_error *err) {
    if (!(o->drift >= 0 && o->drift <= SPH_NUMBER_MAX))
        return sph_fail(err, "%s: drift %g is not from 0 to %g", scene->name, o->drift,
                        SPH_NUMBER_MAX);
    if (!(o->orbit >= 0 && o->orbit <= 360))
        return sph_fail(err, "%s: orbit %g is not from 0 to 360", scene->name, o->orbit);
    if (o->drift > 0 && drift(o, scene, err)) return -1;
    return o->orbit > 0 ? orbit(o, scene, err) : 0;
}
