/* gltf_place.c - cameras and lights of a glTF scene where its nodes put them; see gltf.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "common/number.h"
#include "scene/affine.h"
#include "scene/assimp/gltf.h"
#include "scene/edit.h"

#define FAR 100.0 /* how many radii a light of parallel rays is away */

enum { DEEPEST = 256, NODES = 1 << 20 };

/* A light, and how bright it is where it is weighed. */
struct light {
    struct sph_vec pos;
    double rgb[3];
    int plain; /* a point light already */
};

struct walk {
    const struct sph_gltf *g;
    const char *camera; /* that is looked for, NULL: the first */
    struct sph_vec middle;
    double radius;
    struct sph_scene *scene;
    uint32_t n_nodes, n_cameras, n_lights, room;
    int found; /* a camera has been chosen */
    struct light *lights;
};

static void numbers(const json_t *list, int n, double *to) {
    for (int i = 0; i < n && json_is_array(list); i++)
        to[i] = json_number_value(json_array_get(list, (size_t)i));
}

/* The map of a node: its matrix, column by column, or scale, turn and move. */
static struct sph_affine map_of(const json_t *node) {
    double m[16], scale[3] = {1, 1, 1}, q[4] = {0, 0, 0, 1}, move[3] = {0};
    const json_t *matrix = json_object_get(node, "matrix");
    if (json_is_array(matrix)) {
        struct sph_affine a;
        numbers(matrix, 16, m);
        for (int i = 0; i < 3; i++)
            for (int k = 0; k < 4; k++)
                a.m[i][k] = m[4 * k + i];
        return a;
    }
    numbers(json_object_get(node, "scale"), 3, scale);
    numbers(json_object_get(node, "rotation"), 4, q);
    numbers(json_object_get(node, "translation"), 3, move);
    return sph_affine_of(sph_vec_of(scale[0], scale[1], scale[2]),
                         (struct sph_turn){q[3], q[0], q[1], q[2]},
                         sph_vec_of(move[0], move[1], move[2]));
}

static struct sph_vec column(const struct sph_affine *a, int k, double by) {
    struct sph_vec v = {a->m[0][k], a->m[1][k], a->m[2][k]};
    double length = sph_vec_length(v);
    by /= length > 0 ? length : 1;
    return sph_vec_of(by * v.x, by * v.y, by * v.z);
}

static struct sph_vec along(struct sph_vec from, struct sph_vec dir, double by) {
    return sph_vec_of(from.x + by * dir.x, from.y + by * dir.y, from.z + by * dir.z);
}

static const json_t *entry(const json_t *list, const json_t *index) {
    json_int_t i = json_is_integer(index) ? json_integer_value(index) : -1;
    return i < 0 ? NULL : json_array_get(list, (size_t)i);
}

static int note(struct walk *w, enum sph_read kind, struct sph_error *err) {
    return sph_ledger_note(&w->scene->ledger, kind, w->g->path, 0, err);
}

/* ---- cameras: they look along -z of their node, +y is up ---- */

static int is_called(const struct walk *w, const json_t *node, const json_t *camera) {
    uint64_t number;
    if (!w->camera) return 1;
    const char *names[] = {json_string_value(json_object_get(node, "name")),
                           json_string_value(json_object_get(camera, "name"))};
    for (int i = 0; i < 2; i++)
        if (names[i] && !strcmp(names[i], w->camera)) return 1;
    return !sph_parse_count(w->camera, 0, UINT32_MAX, &number) && number == w->n_cameras;
}

static int take_camera(struct walk *w, const json_t *node, const struct sph_affine *a,
                       struct sph_error *err) {
    const json_t *camera =
        entry(json_object_get(w->g->root, "cameras"), json_object_get(node, "camera"));
    if (!camera) return 0;
    const json_t *lens = json_object_get(camera, "perspective");
    int called = is_called(w, node, camera);
    w->n_cameras++;
    if (w->found || !called || !lens) return note(w, SPH_READ_CAMERA_OTHER, err);
    struct sph_camera *c = &w->scene->camera;
    w->found = 1;
    c->from = sph_vec_of(a->m[0][3], a->m[1][3], a->m[2][3]);
    double far = sph_vec_length(sph_vec_sub(w->middle, c->from));
    c->at = along(c->from, column(a, 2, -1), far > 0 ? far : 1);
    c->up = column(a, 1, 1);
    c->angle = json_number_value(json_object_get(lens, "yfov")) * 180 / M_PI;
    c->hither = json_number_value(json_object_get(lens, "znear"));
    return note(w, SPH_READ_CAMERA, err);
}

/* ---- lights ---- */

static double largest(const struct light *l) {
    return fmax(l->rgb[0], fmax(l->rgb[1], l->rgb[2]));
}

static int take_light(struct walk *w, const json_t *node, const struct sph_affine *a,
                      struct sph_error *err) {
    static const char name[] = "KHR_lights_punctual";
    const json_t *of = json_object_get(json_object_get(w->g->root, "extensions"), name);
    const json_t *here = json_object_get(json_object_get(node, "extensions"), name);
    const json_t *light = entry(json_object_get(of, "lights"), json_object_get(here, "light"));
    const json_t *intensity = json_object_get(light, "intensity");
    const char *type = json_string_value(json_object_get(light, "type"));
    struct light l = {.rgb = {1, 1, 1}};
    if (!light) return 0;
    numbers(json_object_get(light, "color"), 3, l.rgb);
    double by = json_is_number(intensity) ? json_number_value(intensity) : 1;
    if (type && !strcmp(type, "directional")) {
        l.pos = along(w->middle, column(a, 2, 1), FAR * w->radius);
    } else {
        l.pos = sph_vec_of(a->m[0][3], a->m[1][3], a->m[2][3]);
        double far = fmax(sph_vec_length(sph_vec_sub(l.pos, w->middle)), w->radius / 16);
        by /= far > 0 ? far * far : 1;
    }
    for (int i = 0; i < 3; i++)
        l.rgb[i] *= by;
    if (!(largest(&l) > 0 && largest(&l) <= SPH_NUMBER_MAX))
        return note(w, SPH_READ_LIGHT_OTHER, err);
    if (w->n_lights == w->room) {
        uint32_t room = w->room ? 2 * w->room : 8;
        struct light *more = realloc(w->lights, room * sizeof *more);
        if (!more) return sph_fail(err, "%s: no memory for %u lights", w->g->path, room);
        w->lights = more, w->room = room;
    }
    w->lights[w->n_lights++] = l;
    return 0;
}

static int by_brightness(const void *p, const void *q) {
    double a = largest(p), b = largest(q);
    return a < b ? 1 : a > b ? -1 : 0;
}

/* The brightest, scaled so that the squares of their largest channels add up to 1: equal ones are
 * 1 / sqrt(n), as those of NFF without a colour. */
static int put_lights(struct walk *w, struct sph_error *err) {
    double squares = 0;
    if (w->n_lights) qsort(w->lights, w->n_lights, sizeof *w->lights, by_brightness);
    for (uint32_t i = 0; i < w->n_lights && i < SPH_MAX_LIGHTS; i++)
        squares += pow(largest(&w->lights[i]) / largest(w->lights), 2);
    for (uint32_t i = 0; i < w->n_lights; i++) {
        const struct light *l = &w->lights[i];
        double by = 1 / (sqrt(squares) * largest(w->lights));
        int beyond = i >= SPH_MAX_LIGHTS;
        if (note(w, beyond ? SPH_READ_LIGHT_OTHER : SPH_READ_LIGHT_PLAIN, err)) return -1;
        if (!beyond && sph_scene_add_light(w->scene, l->pos, by * l->rgb[0], by * l->rgb[1],
                                           by * l->rgb[2], err))
            return -1;
    }
    return 0;
}

/* ---- nodes ---- */

static int walk_node(struct walk *w, const json_t *index, const struct sph_affine *above, int depth,
                     struct sph_error *err) {
    const json_t *node = entry(json_object_get(w->g->root, "nodes"), index);
    if (!node) return 0;
    if (depth > DEEPEST || w->n_nodes++ > NODES)
        return sph_fail(err, "%s: its nodes are more than %d deep, or in a circle", w->g->path,
                        DEEPEST);
    const struct sph_affine own = map_of(node), a = sph_affine_after(above, &own);
    if (take_camera(w, node, &a, err) || take_light(w, node, &a, err)) return -1;
    size_t i;
    json_t *child;
    json_array_foreach(json_object_get(node, "children"), i, child) {
        if (walk_node(w, child, &a, depth + 1, err)) return -1;
    }
    return 0;
}

int sph_gltf_place(const struct sph_gltf *g, const char *camera, struct sph_vec middle,
                   double radius, struct sph_scene *scene, struct sph_error *err) {
    static const struct sph_affine none = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
    struct walk w = {.g = g, .camera = camera, .middle = middle, .radius = radius, .scene = scene};
    const json_t *which = json_object_get(g->root, "scene");
    const json_t *first = json_integer(0);
    const json_t *root = entry(json_object_get(g->root, "scenes"), which ? which : first);
    size_t i;
    json_t *node;
    int bad = 0;
    json_array_foreach(json_object_get(root, "nodes"), i, node) {
        if (!bad) bad = walk_node(&w, node, &none, 0, err);
    }
    if (!bad && camera && !w.found)
        bad = sph_fail(err, "%s: no camera with a perspective is called %.80s; it has %u", g->path,
                       camera, w.n_cameras);
    if (!bad) bad = put_lights(&w, err);
    json_decref((json_t *)(uintptr_t)first);
    free(w.lights);
    return bad ? -1 : 0;
}
