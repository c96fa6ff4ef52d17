/* flight.c - the way of the camera from frame to frame; see motion.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include <inttypes.h>
#include <stdlib.h>

#include "scene/edit.h"
#include "scene/motion.h"
#include "scene/spline.h"
#include "scene/vector.h"

static int check(const struct sph_scene *scene, struct sph_vec from, struct sph_vec at,
                 uint32_t line, uint32_t frame, struct sph_error *err) {
    struct sph_camera camera = scene->camera;
    char where[sizeof scene->path + 48];
    camera.from = from, camera.at = at;
    snprintf(where, sizeof where, "%s:%" PRIu32 ": `fly`: frame %" PRIu32, scene->path, line,
             frame);
    if (!sph_vec_small(from) || !sph_vec_small(at))
        return sph_fail(err, "%s: the camera is beyond %g", where, SPH_NUMBER_MAX);
    return sph_camera_check(&camera, where, err);
}

int sph_scene_add_flight(struct sph_scene *scene, const struct sph_flight *flight,
                         struct sph_error *err) {
    uint32_t n = scene->n_flights;
    uint32_t before = n ? scene->flights[n - 1].frame : 0;
    if (flight->frame <= before)
        return sph_fail(err, "%s:%u: `fly`: frame %u is not after frame %u", scene->path,
                        flight->line, flight->frame, before);
    struct sph_flight *room = scene->flights;
    if (!(n & (n - 1))) room = realloc(room, (n ? 2 * (size_t)n : 1) * sizeof *room);
    if (!room)
        return sph_fail(err, "%s:%u: no memory for more than %u places of the camera", scene->path,
                        flight->line, n);
    scene->flights = room;
    room[scene->n_flights++] = *flight;
    return 0;
}

int sph_scene_check_flights(const struct sph_scene *scene, struct sph_error *err) {
    for (uint32_t i = 0; i < scene->n_flights; i++) {
        const struct sph_flight *f = &scene->flights[i];
        if (check(scene, f->from, f->at, f->line, f->frame, err)) return -1;
    }
    return 0;
}

/* A key as far beyond b as b is beyond a: it shapes the end of the curve. */
static struct sph_key beyond(const struct sph_key *a, const struct sph_key *b) {
    return (struct sph_key){
        .time = 2 * b->time - a->time,
        .at = {2 * b->at.x - a->at.x, 2 * b->at.y - a->at.y, 2 * b->at.z - a->at.z}};
}

/* Keys of one of the two points, with one more at either end; malloc, NULL if memory is out. */
static struct sph_key *keys(const struct sph_scene *scene, int look) {
    uint32_t n = scene->n_flights + 1;
    struct sph_key *key = calloc(n + 2ull, sizeof *key);
    if (!key) return NULL;
    key[1].at = look ? scene->camera.at : scene->camera.from;
    for (uint32_t i = 1; i < n; i++) {
        const struct sph_flight *f = &scene->flights[i - 1];
        key[i + 1].time = f->frame;
        key[i + 1].at = look ? f->at : f->from;
    }
    key[0] = beyond(&key[2], &key[1]);
    key[n + 1] = beyond(&key[n - 1], &key[n]);
    return key;
}

int sph_scene_fly(struct sph_scene *scene, uint32_t frame, struct sph_error *err) {
    struct sph_vec point[2];
    if (!frame || !scene->n_flights) return 0;
    for (int look = 0; look < 2; look++) {
        struct sph_key *key = keys(scene, look);
        if (!key) return sph_fail(err, "%s: no memory for the way of the camera", scene->path);
        point[look] = sph_spline_point(key, scene->n_flights + 3, frame);
        free(key);
    }
    if (check(scene, point[0], point[1], scene->flights[0].line, frame, err)) return -1;
    scene->camera.from = point[0], scene->camera.at = point[1];
    return 0;
}
