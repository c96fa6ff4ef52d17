/* aff_pose.c - everything of an AFF file in its place at a time; see aff_reader.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "scene/aff_reader.h"

#include <math.h>
#include <string.h>

#include "scene/polygon.h"
#include "scene/record.h"
#include "scene/vector.h"

static const struct sph_affine none = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};

static const struct sph_aff_keys *keys_of(const struct sph_aff *a, const char *name) {
    for (uint32_t i = 0; i < a->n_keys; i++)
        if (!strcmp(a->keys[i].name, name)) return &a->keys[i];
    return NULL;
}

static struct sph_vec point_of(const struct sph_aff_track *track, double time, double otherwise) {
    if (!track->n) return sph_vec_of(otherwise, otherwise, otherwise);
    return sph_spline_point(track->key, track->n, time);
}

static int turn_of(const struct sph_aff *a, const struct sph_aff_track *track, double time,
                   struct sph_turn *turn, struct sph_error *err) {
    *turn = (struct sph_turn){1, 0, 0, 0};
    if (!track->n || !sph_spline_turn(track->key, track->n, time, turn)) return 0;
    return sph_fail(err, "%s: no memory for %u keys", a->r.scene->path, track->n);
}

/* Seen up to the first key, then as the last key up to this time says. */
static int seen(const struct sph_aff_track *track, double time) {
    int now = 1;
    for (uint32_t i = 0; i < track->n && track->key[i].time <= time; i++)
        now = track->key[i].at.x != 0;
    return now;
}

/* What a name's keys do at a time; without keys it stands still. */
static int moved(const struct sph_aff *a, const char *name, double time, struct sph_affine *map,
                 int *visible, struct sph_error *err) {
    const struct sph_aff_keys *k = keys_of(a, name);
    struct sph_turn turn;
    *map = none;
    if (!k) return 0;
    if (turn_of(a, &k->track[SPH_AFF_TURN], time, &turn, err)) return -1;
    *map = sph_affine_of(point_of(&k->track[SPH_AFF_SCALE], time, 1), turn,
                         point_of(&k->track[SPH_AFF_MOVE], time, 0));
    if (!seen(&k->track[SPH_AFF_SEEN], time)) *visible = 0;
    return 0;
}

/* Whether a map leaves next to nothing of one axis beside another one. */
static int flat(const struct sph_affine *map) {
    double least = INFINITY, most = 0;
    for (int k = 0; k < 3; k++) {
        double length = sph_vec_length(sph_vec_of(map->m[0][k], map->m[1][k], map->m[2][k]));
        least = fmin(least, length), most = fmax(most, length);
    }
    return !(least > SPH_AFF_FLAT * most);
}

/* Every node stands behind the one that it is in. */
static int pose_nodes(struct sph_aff *a, double time, struct sph_error *err) {
    for (uint32_t i = 0; i < a->n_nodes; i++) {
        struct sph_aff_node *node = &a->nodes[i], *in = &a->nodes[node->parent - 1];
        struct sph_affine own = node->still;
        node->visible = node->parent ? in->visible : 1;
        if (*node->name && moved(a, node->name, time, &own, &node->visible, err)) return -1;
        node->world = node->parent ? sph_affine_after(&in->world, &own) : own;
        node->flat = (node->parent && in->flat) || flat(&node->world);
    }
    return 0;
}

static struct sph_vec between(struct sph_vec from, struct sph_vec to, double u) {
    struct sph_vec by = sph_vec_sub(to, from);
    return sph_vec_of(from.x + u * by.x, from.y + u * by.y, from.z + u * by.z);
}

/* Corners and normals of animated triangles: straight on between two times. */
static void pose_patches(struct sph_aff *a, double time) {
    for (uint32_t i = 0; i < a->n_patches; i++) {
        const struct sph_aff_patch *p = &a->patches[i];
        uint32_t at = 0;
        while (at + 1 < p->n && p->at[at + 1].time <= time)
            at++;
        const struct sph_aff_corners *from = &p->at[at], *to = at + 1 < p->n ? from + 1 : from;
        double u =
            to == from || time <= from->time ? 0 : (time - from->time) / (to->time - from->time);
        for (int k = 0; k < 3; k++) {
            struct sph_facet *f = &a->r.scene->facets[p->facet];
            f->v[k] = between(from->v[k], to->v[k], u);
            f->n[k] = between(from->n[k], to->n[k], u);
            f->smooth = sph_smooth_given(f->n);
        }
    }
}

/* A facet in its place: 1, 0 if it is left out, or -1. */
static int pose_facet(struct sph_aff *a, struct sph_facet *f, struct sph_error *err) {
    struct sph_scene *scene = a->r.scene;
    const struct sph_aff_node *node = f->motion ? &a->nodes[f->motion - 1] : NULL;
    f->motion = 0;
    if (node && !node->visible)
        return sph_ledger_note(&scene->ledger, SPH_READ_HIDDEN, scene->path, f->line, NULL);
    if (node && node->flat && a->r.skip)
        return sph_ledger_note(&scene->ledger, SPH_READ_NO_SIZE, scene->path, f->line, err);
    if (node && node->flat)
        return sph_fail(err, "%s:%u: a triangle is scaled by 0; --skip-unsupported leaves it out",
                        scene->path, f->line);
    for (int k = 0; node && k < 3; k++)
        f->v[k] = sph_affine_point(&node->world, f->v[k]);
    for (int k = 0; node && f->smooth && k < 3; k++)
        f->n[k] = sph_affine_normal(&node->world, f->n[k]);
    f->smooth = f->smooth && sph_smooth_given(f->n);
    if (sph_triangle_empty(f->v[0], f->v[1], f->v[2]))
        return sph_ledger_note(&scene->ledger, SPH_READ_NO_AREA, scene->path, f->line, err);
    return 1;
}

static int pose_facets(struct sph_aff *a, struct sph_error *err) {
    struct sph_scene *scene = a->r.scene;
    struct sph_recount recount = {.ledger = &scene->ledger};
    uint32_t kept = 0;
    for (uint32_t i = 0; i < scene->n_facets; i++) {
        struct sph_facet f = scene->facets[i];
        int left = pose_facet(a, &f, err);
        if (left < 0) return -1;
        sph_recount_facet(&recount, &f, left);
        if (left) scene->facets[kept++] = f;
    }
    sph_recount_facet(&recount, NULL, 0);
    scene->n_facets = kept;
    return 0;
}

/* The same of a sphere. */
static int pose_sphere(struct sph_aff *a, struct sph_sphere *s, struct sph_error *err) {
    struct sph_scene *scene = a->r.scene;
    const struct sph_aff_node *node = s->motion ? &a->nodes[s->motion - 1] : NULL;
    s->motion = 0;
    if (node && !node->visible)
        return sph_ledger_note(&scene->ledger, SPH_READ_HIDDEN, scene->path, s->line, NULL);
    if (!node) return 1;
    double by = sph_affine_scale(&node->world);
    if (!(by > 0) && a->r.skip)
        return sph_ledger_note(&scene->ledger, SPH_READ_NO_SIZE, scene->path, s->line, err);
    if (!(by > 0))
        return sph_fail(err, "%s:%u: `s`: scaled to no sphere; --skip-unsupported leaves it out",
                        scene->path, s->line);
    s->ctr = sph_affine_point(&node->world, s->ctr);
    s->rad *= by;
    return 1;
}

static int pose_spheres(struct sph_aff *a, struct sph_error *err) {
    struct sph_scene *scene = a->r.scene;
    uint32_t kept = 0;
    for (uint32_t i = 0; i < scene->n_spheres; i++) {
        struct sph_sphere s = scene->spheres[i];
        int left = pose_sphere(a, &s, err);
        if (left < 0) return -1;
        if (left)
            scene->spheres[kept++] = s;
        else
            sph_ledger_take_back(&scene->ledger, SPH_READ_SPHERE);
    }
    scene->n_spheres = kept;
    return 0;
}

/* Lights are moved by their own keys, and by what they are in. */
static int pose_lights(struct sph_aff *a, double time, struct sph_error *err) {
    for (int i = 0; i < a->r.scene->n_lights; i++) {
        struct sph_vec *pos = &a->r.scene->lights[i].pos;
        struct sph_affine own = none;
        int visible;
        if (*a->lamp[i].name && moved(a, a->lamp[i].name, time, &own, &visible, err)) return -1;
        *pos = sph_vec_of(pos->x + own.m[0][3], pos->y + own.m[1][3], pos->z + own.m[2][3]);
        if (a->lamp[i].node) *pos = sph_affine_point(&a->nodes[a->lamp[i].node - 1].world, *pos);
    }
    return 0;
}

/* The keys of `camera`: it stands where they move to, and looks along -z, y up, turned by them. */
static int pose_camera(struct sph_aff *a, double time, struct sph_error *err) {
    struct sph_camera *camera = &a->r.scene->camera;
    const struct sph_aff_keys *k = keys_of(a, "camera");
    struct sph_turn turn;
    if (!k || !a->r.view_line) return 0;
    if (turn_of(a, &k->track[SPH_AFF_TURN], time, &turn, err)) return -1;
    if (k->track[SPH_AFF_MOVE].n) camera->from = point_of(&k->track[SPH_AFF_MOVE], time, 0);
    if (!k->track[SPH_AFF_TURN].n) return 0;
    struct sph_affine map = sph_affine_of(sph_vec_of(1, 1, 1), turn, camera->from);
    camera->at = sph_affine_point(&map, sph_vec_of(0, 0, -1));
    camera->up = sph_vec_of(map.m[0][1], map.m[1][1], map.m[2][1]);
    return 0;
}

/* What transforms have made of numbers is still as small as a number of a file. */
static int check_pose(const struct sph_aff *a, struct sph_error *err) {
    const struct sph_scene *scene = a->r.scene;
    uint32_t line = 0;
    const char *what = NULL;
    for (uint32_t i = 0; i < scene->n_facets && !what; i++) {
        const struct sph_facet *f = &scene->facets[i];
        for (int k = 0; k < 3; k++)
            if (!sph_vec_small(f->v[k]) || (f->smooth && !sph_vec_small(f->n[k])))
                what = "triangle";
        line = f->line;
    }
    for (uint32_t i = 0; i < scene->n_spheres && !what; i++) {
        const struct sph_sphere *s = &scene->spheres[i];
        if (!sph_vec_small(s->ctr) || !(s->rad <= SPH_NUMBER_MAX)) what = "sphere";
        line = s->line;
    }
    if (what)
        return sph_fail(err, "%s:%u: a %s is moved beyond %g", scene->path, line, what,
                        SPH_NUMBER_MAX);
    for (int i = 0; i < scene->n_lights; i++)
        if (!sph_vec_small(scene->lights[i].pos))
            return sph_fail(err, "%s: light %d is moved beyond %g", scene->path, i, SPH_NUMBER_MAX);
    const struct sph_camera *c = &scene->camera;
    if (!sph_vec_small(c->from) || !sph_vec_small(c->at) || !sph_vec_small(c->up))
        return sph_fail(err, "%s: camera: it is moved beyond %g", scene->path, SPH_NUMBER_MAX);
    return a->r.view_line ? sph_camera_check(c, scene->path, err) : 0;
}

int sph_aff_pose(struct sph_aff *a, double time, struct sph_error *err) {
    if (pose_nodes(a, time, err)) return -1;
    pose_patches(a, time);
    return pose_facets(a, err) || pose_spheres(a, err) || pose_lights(a, time, err) ||
                   pose_camera(a, time, err) || check_pose(a, err)
               ? -1
               : 0;
}
