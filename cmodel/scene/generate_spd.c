/* generate_spd.c - scenes of cones, cylinders and spheres in the manner of SPD; see generate.h
 * SPDX-License-Identifier: Apache-2.0
 *
 * Haines' Standard Procedural Databases have jacks, lattice, rings and tree. These are like them in
 * kind, made by formulas of our own; files keep the cones as `c`.
 */
#include "scene/generate_kinds.h"

#include <math.h>

#include "scene/frustum.h"
#include "scene/vector.h"

/* A scene that grows. */
struct growth {
    struct sph_scene *scene;
    struct sph_error *err;
    uint32_t groups, material;
};

static int add_cone(struct growth *g, struct sph_vec base, double base_rad, struct sph_vec apex,
                    double apex_rad) {
    struct sph_frustum cone = {base, apex, base_rad, apex_rad, 0};
    struct sph_facet look = {.material = g->material};
    return sph_scene_add_frustum(g->scene, &cone, SPH_FRUSTUM_ROUND, &look, &g->groups, g->err);
}

static int add_ball(struct growth *g, struct sph_vec at, double rad) {
    return sph_scene_add_sphere(g->scene, at, rad, g->material, 0, g->err);
}

/* A square of the ground, of half a side, y = 0, in the last colour. */
static int add_ground(struct growth *g, double half) {
    struct sph_facet f = {
        .kind = SPH_TRIANGLE, .material = SPH_PALETTE_SIZE - 1, .group = g->groups++};
    const struct sph_vec c[4] = {
        {-half, 0, half}, {half, 0, half}, {half, 0, -half}, {-half, 0, -half}};
    for (int i = 1; i < 3; i++) {
        f.v[0] = c[0], f.v[1] = c[i], f.v[2] = c[i + 1];
        if (sph_scene_add_facet(g->scene, &f, g->err)) return -1;
    }
    return 0;
}

/* Camera, light, colours and background of all of them. */
static int start(struct growth *g, const struct sph_generate_options *o, const char *kind,
                 struct sph_vec from, struct sph_vec at, double angle) {
    if (o->size < 1 || o->size > 5)
        return sph_fail(g->err, "%s: size %d is not within 1 to 5", kind, o->size);
    snprintf(g->scene->name, sizeof g->scene->name, "%s%d", kind, o->size);
    sph_make_camera(g->scene, from, at, sph_vec_of(0, 1, 0), angle);
    for (int i = 0; i < 3; i++) {
        g->scene->ambient[i] = 0.1;
        g->scene->background[i] = 0.125 * (i + 2);
    }
    return sph_scene_add_light(g->scene, sph_vec_of(-12, 20, 16), 1, 1, 1, g->err) ||
           sph_make_palette(g->scene, 0.25, 40, g->err);
}

/* Three bars across each other with a ball on each end, one standing on three of them. */
static int add_jack(struct growth *g, struct sph_vec at, double turn) {
    const double tilt = acos(sqrt(1 / 3.0)), reach = 1, thick = 0.16;
    for (int i = 0; i < 3; i++) {
        double angle = turn + 2 * M_PI * i / 3;
        struct sph_vec dir = {sin(tilt) * cos(angle), cos(tilt), sin(tilt) * sin(angle)};
        struct sph_vec low = sph_vec_add(at, dir, -reach), high = sph_vec_add(at, dir, reach);
        if (add_cone(g, low, thick, high, thick) || add_ball(g, low, 1.6 * thick) ||
            add_ball(g, high, 1.6 * thick))
            return -1;
    }
    return 0;
}

/* size x size jacks on the ground, each turned otherwise. */
int sph_make_jacks(const struct sph_generate_options *o, struct sph_scene *scene,
                   struct sph_error *err) {
    struct growth g = {scene, err, 0, 0};
    double half = 1.25 * o->size;
    if (start(&g, o, "jacks", sph_vec_of(0.5 * half, 1.6 * half + 1, 3.2 * half),
              sph_vec_of(0, 0.5, 0), 36))
        return -1;
    for (int i = 0; i < o->size * o->size; i++) {
        int column = i % o->size, row = i / o->size;
        double x = 2.5 * column + 1.25 - half, z = 2.5 * row + 1.25 - half;
        g.material = (uint32_t)i % (SPH_PALETTE_SIZE - 1);
        if (add_jack(&g, sph_vec_of(x, sqrt(1 / 3.0) + 0.256, z), 0.7 * i)) return -1;
    }
    return add_ground(&g, half + 1);
}

/* (size + 1)^3 balls, and bars between neighbours. */
int sph_make_lattice(const struct sph_generate_options *o, struct sph_scene *scene,
                     struct sph_error *err) {
    struct growth g = {scene, err, 0, 0};
    int side = o->size + 1;
    double half = o->size / 2.0;
    if (start(&g, o, "lattice", sph_vec_of(1.4 * o->size, 1.1 * o->size, 2.4 * o->size),
              sph_vec_of(0, 0, 0), 38))
        return -1;
    for (int i = 0; i < side * side * side; i++) {
        const int cell[3] = {i % side, i / side % side, i / side / side};
        struct sph_vec at = {cell[0] - half, cell[1] - half, cell[2] - half};
        g.material = (uint32_t)(cell[0] + cell[1] + cell[2]) % 2;
        if (add_ball(&g, at, 0.16)) return -1;
        for (int axis = 0; axis < 3; axis++) {
            struct sph_vec dir = {axis == 0, axis == 1, axis == 2};
            g.material = 2 + (uint32_t)axis;
            if (cell[axis] < o->size && add_cone(&g, at, 0.06, sph_vec_add(at, dir, 1), 0.06))
                return -1;
        }
    }
    return 0;
}

/* A limb that tapers, and from its end two that are turned against each other. */
static int add_limb(struct growth *g, struct sph_vec at, struct sph_vec dir, double length,
                    int depth, int number) {
    struct sph_vec end = sph_vec_add(at, dir, length);
    double thick = 0.11 * length;
    g->material = depth ? 10 : 8;
    if (add_cone(g, at, thick, end, depth ? 0.7 * thick : 0)) return -1;
    for (int i = 0; i < 2 && depth; i++) {
        double turn = 2.4 * (2 * number + i), lean = i ? 0.75 : 0.5;
        struct sph_vec next = {dir.x + lean * cos(turn), dir.y + 0.1, dir.z + lean * sin(turn)};
        double size = sqrt(next.x * next.x + next.y * next.y + next.z * next.z);
        next = sph_vec_of(next.x / size, next.y / size, next.z / size);
        if (add_limb(g, end, next, 0.7 * length, depth - 1, 2 * number + i)) return -1;
    }
    return 0;
}

/* 2^(size + 2) - 1 cones. */
int sph_make_tree(const struct sph_generate_options *o, struct sph_scene *scene,
                  struct sph_error *err) {
    struct growth g = {scene, err, 0, 0};
    if (start(&g, o, "tree", sph_vec_of(0, 2.5, 8), sph_vec_of(0, 1.8, 0), 36)) return -1;
    return add_limb(&g, sph_vec_of(0, 0, 0), sph_vec_of(0, 1, 0), 1.3, o->size + 1, 1) ||
                   add_ground(&g, 4)
               ? -1
               : 0;
}

/* Size rings, each of twelve balls and the bars between them, around one another in turn. */
int sph_make_rings(const struct sph_generate_options *o, struct sph_scene *scene,
                   struct sph_error *err) {
    enum { CORNERS = 12 };
    struct growth g = {scene, err, 0, 0};
    double reach = 0.7 * o->size + 0.6;
    if (start(&g, o, "rings", sph_vec_of(0.4 * reach, 1.4 * reach + 1, 2.6 * reach + 1),
              sph_vec_of(0, 0, 0), 38))
        return -1;
    for (int ring = 0; ring < o->size; ring++) {
        double middle = 1.4 * ring - 0.7 * (o->size - 1);
        struct sph_vec at[CORNERS];
        for (int i = 0; i < CORNERS; i++) {
            double angle = 2 * M_PI * i / CORNERS, a = cos(angle), b = sin(angle);
            at[i] = ring & 1 ? sph_vec_of(middle + a, b, 0) : sph_vec_of(middle + a, 0, b);
        }
        g.material = (uint32_t)ring;
        for (int i = 0; i < CORNERS; i++)
            if (add_ball(&g, at[i], 0.14) || add_cone(&g, at[i], 0.14, at[(i + 1) % CORNERS], 0.14))
                return -1;
    }
    return 0;
}
