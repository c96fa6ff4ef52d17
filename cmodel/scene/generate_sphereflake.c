/* generate_sphereflake.c - the SPD scene `balls`, with its floor and without; see generate.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * Eric Haines' sphereflake ("A Proposal for Standard Graphics Environments", IEEE CG&A 7(11),
 * 1987): every sphere carries nine spheres of a third of its radius, which touch it from
 * outside. Their directions are fixed with respect to the direction in which their parent left
 * its own parent (+z for the first sphere): three trios, 120 degrees apart about that axis.
 */
#include "scene/generate_kinds.h"

#include <math.h>

enum { N_CHILDREN = 9, MAX_SIZE = 5 };

/* v turned about the unit vector axis by the angle with cosine c and sine s (Rodrigues). */
static struct sph_vec turn(struct sph_vec v, struct sph_vec axis, double c, double s) {
    double along = (axis.x * v.x + axis.y * v.y + axis.z * v.z) * (1 - c);
    return sph_vec_of(c * v.x + s * (axis.y * v.z - axis.z * v.y) + along * axis.x,
                      c * v.y + s * (axis.z * v.x - axis.x * v.z) + along * axis.y,
                      c * v.z + s * (axis.x * v.y - axis.y * v.x) + along * axis.z);
}

/* The nine unit vectors for a parent that points to +z. A trio is three directions 60 degrees
 * from each other; tilted by asin(2/sqrt(6)) about (1, -1, 0), one of them points 54.7 degrees
 * up from the equator and the two others lie on it. */
static void child_directions(struct sph_vec out[N_CHILDREN]) {
    const double d = sqrt(0.5), c = sqrt(1.0 / 3), s = sqrt(2.0 / 3);
    const struct sph_vec trio[3] = {{d, d, 0}, {d, 0, -d}, {0, d, -d}};
    for (int set = 0; set < 3; set++)
        for (int i = 0; i < 3; i++) {
            double angle = set * 2 * M_PI / 3;
            struct sph_vec tilted = turn(trio[i], sph_vec_of(d, -d, 0), c, s);
            out[3 * set + i] = turn(tilted, sph_vec_of(0, 0, 1), cos(angle), sin(angle));
        }
}

/* v, given for +z, carried along when +z is turned the short way onto the unit vector dir. */
static struct sph_vec carry(struct sph_vec v, struct sph_vec dir) {
    double s = hypot(dir.x, dir.y);
    if (dir.z >= 1) return v;
    if (dir.z <= -1) return sph_vec_of(-v.x, v.y, -v.z);
    return turn(v, sph_vec_of(-dir.y / s, dir.x / s, 0), dir.z, s);
}

/* Adds the sphere and, depth generations deep, its children; parents before children. */
static int add(struct sph_scene *scene, const struct sph_vec children[N_CHILDREN],
               struct sph_vec ctr, double rad, struct sph_vec dir, int depth,
               struct sph_error *err) {
    if (sph_scene_add_sphere(scene, ctr, rad, 0, 0, err)) return -1;
    double reach = rad + rad / 3;
    for (int i = 0; i < N_CHILDREN && depth > 0; i++) {
        struct sph_vec d = carry(children[i], dir);
        struct sph_vec at = {ctr.x + reach * d.x, ctr.y + reach * d.y, ctr.z + reach * d.z};
        if (add(scene, children, at, rad / 3, d, depth - 1, err)) return -1;
    }
    return 0;
}

int sph_make_sphereflake(const struct sph_generate_options *options, struct sph_scene *scene,
                         struct sph_error *err) {
    static const struct sph_vec lights[] = {{4, 3, 2}, {1, -4, 4}, {-3, 1, 5}};
    const double bright = 1 / sqrt(3);
    const struct sph_material mirror = {{1, 0.9, 0.7}, 0.5, 0.5, 37, 0, 1, 0, {0}, 0};
    struct sph_vec children[N_CHILDREN];
    if (options->size < 1 || options->size > MAX_SIZE)
        return sph_fail(err, "%s: size %d is not within 1 to %d", scene->name, options->size,
                        MAX_SIZE);
    snprintf(scene->name, sizeof scene->name, "sphereflake%d", options->size);
    sph_make_camera(scene, sph_vec_of(2.1, 1.3, 1.7), sph_vec_of(0, 0, 0), sph_vec_of(0, 0, 1), 45);
    scene->background[0] = 0.078;
    scene->background[1] = 0.361;
    scene->background[2] = 0.753;
    for (int i = 0; i < 3; i++)
        if (sph_scene_add_light(scene, lights[i], bright, bright, bright, err)) return -1;
    if (sph_scene_add_material(scene, &mirror, err)) return -1;
    child_directions(children);
    return add(scene, children, sph_vec_of(0, 0, 0), 0.5, sph_vec_of(0, 0, 1), options->size, err);
}

/* The same over a square floor that the first sphere stands on. */
int sph_make_balls(const struct sph_generate_options *options, struct sph_scene *scene,
                   struct sph_error *err) {
    const struct sph_material matt = {{1, 0.75, 0.33}, 0.8, 0, 1, 0, 1, 0, {0}, 0};
    const double half = 12, top = -0.5;
    if (sph_make_sphereflake(options, scene, err) || sph_scene_add_material(scene, &matt, err))
        return -1;
    snprintf(scene->name, sizeof scene->name, "balls%d", options->size);
    struct sph_facet f = {.kind = SPH_TRIANGLE, .material = 1};
    const struct sph_vec c[4] = {
        {half, half, top}, {-half, half, top}, {-half, -half, top}, {half, -half, top}};
    for (int i = 1; i < 3; i++) {
        f.v[0] = c[0], f.v[1] = c[i], f.v[2] = c[i + 1];
        if (sph_scene_add_facet(scene, &f, err)) return -1;
    }
    return 0;
}
