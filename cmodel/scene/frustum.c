/* frustum.c - see frustum.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "scene/frustum.h"

#include <math.h>

#include "scene/edit.h"
#include "scene/vector.h"

/* Two directions square to the axis and to each other: u x v looks along it. */
struct frame {
    struct sph_vec u, v;
};

static struct sph_vec unit(struct sph_vec v) {
    double size = fmax(fabs(v.x), fmax(fabs(v.y), fabs(v.z)));
    v = sph_vec_of(v.x / size, v.y / size, v.z / size);
    double length = sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
    return sph_vec_of(v.x / length, v.y / length, v.z / length);
}

static struct frame frame_of(const struct sph_frustum *c) {
    struct sph_vec w =
        unit(sph_vec_of(c->apex.x - c->base.x, c->apex.y - c->base.y, c->apex.z - c->base.z));
    double x = fabs(w.x), y = fabs(w.y), z = fabs(w.z);
    struct sph_vec far = sph_vec_of(x <= y && x <= z, y < x && y <= z, z < x && z < y);
    struct sph_vec u = unit(sph_vec_cross(far, w));
    return (struct frame){u, sph_vec_cross(w, u)};
}

/* Corner i of n of the circle around a point. */
static struct sph_vec corner(const struct frame *f, struct sph_vec at, double rad, int i, int n) {
    double angle = 2 * M_PI * (i % n) / n, a = rad * cos(angle), b = rad * sin(angle);
    return sph_vec_of(at.x + a * f->u.x + b * f->v.x, at.y + a * f->u.y + b * f->v.y,
                      at.z + a * f->u.z + b * f->v.z);
}

int sph_frustum_sides(double round) {
    int n = 3;
    while (1 - cos(M_PI / n) > round)
        n++;
    return n;
}

static int add_triangle(struct sph_scene *scene, const struct sph_facet *look, struct sph_vec a,
                        struct sph_vec b, struct sph_vec c, struct sph_error *err) {
    struct sph_facet facet = *look;
    facet.v[0] = a, facet.v[1] = b, facet.v[2] = c;
    return sph_scene_add_facet(scene, &facet, err);
}

/* Side i of n: outwards if base and apex are given in order, inwards if exchanged. */
static int add_side(struct sph_scene *scene, const struct sph_frustum *c, const struct frame *f,
                    int i, int n, const struct sph_facet *look, struct sph_error *err) {
    struct sph_vec b0 = corner(f, c->base, fabs(c->base_rad), i, n),
                   b1 = corner(f, c->base, fabs(c->base_rad), i + 1, n),
                   a0 = corner(f, c->apex, fabs(c->apex_rad), i, n),
                   a1 = corner(f, c->apex, fabs(c->apex_rad), i + 1, n);
    if (c->base_rad + c->apex_rad < 0) {
        struct sph_vec swap = b0;
        b0 = b1, b1 = swap;
        swap = a0, a0 = a1, a1 = swap;
    }
    if (c->apex_rad == 0) return add_triangle(scene, look, b0, b1, c->apex, err);
    if (c->base_rad == 0) return add_triangle(scene, look, c->base, a1, a0, err);
    return add_triangle(scene, look, b0, b1, a1, err) || add_triangle(scene, look, b0, a1, a0, err);
}

static int check(const struct sph_scene *scene, const struct sph_frustum *c,
                 struct sph_error *err) {
    const char *what = NULL;
    if (c->base.x == c->apex.x && c->base.y == c->apex.y && c->base.z == c->apex.z)
        what = "base and apex are the same point";
    if (c->base_rad == 0 && c->apex_rad == 0) what = "both radii are zero";
    if ((c->base_rad < 0 && c->apex_rad > 0) || (c->base_rad > 0 && c->apex_rad < 0))
        what = "one radius is negative, the other is not";
    return what ? sph_fail(err, "%s:%u: `c`: %s", scene->path, c->line, what) : 0;
}

int sph_scene_add_frustum(struct sph_scene *scene, const struct sph_frustum *cone, double round,
                          const struct sph_facet *look, uint32_t *n_groups, struct sph_error *err) {
    struct sph_facet side = *look;
    int n = sph_frustum_sides(round);
    if (check(scene, cone, err) || sph_scene_keep_frustum(scene, cone, err)) return -1;
    struct frame f = frame_of(cone);
    side.kind = SPH_TRIANGLE;
    side.frustum = scene->n_frusta;
    for (int i = 0; i < n; i++) {
        side.group = (*n_groups)++;
        if (add_side(scene, cone, &f, i, n, &side, err)) return -1;
    }
    return 0;
}
