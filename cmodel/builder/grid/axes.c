/* axes.c - see axes.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/grid/axes.h"

#include <math.h>
#include <string.h>

#include "builder/build.h"
#include "builder/grid/huge_bounds.h"
#include "builder/tree/choose_tree.h"
#include "machine/records.h"
#include "scene/vector.h"

/* ---- eye ---- */

enum {
    LEAST = 4,   /* times u: then c' - u is no small number */
    MARGIN = 16, /* grid units that a grid has besides what lies on it, at most */
    WIDEST = 32  /* tan(angle/2): then a screen of 12 bits still is SPH_MIN_SCREEN away */
};

/* What is seen: depth of its middle, half of what it is deep and wide. */
struct seen {
    double middle, deep, wide;
};

static double moved(const struct seen *s, double c) {
    return s->deep * (s->middle - c) / (s->middle * (c - s->deep));
}

/* How far a point may be off across the view, in units of the scene. */
static double off(const struct seen *s, double c, double step) {
    return s->wide * moved(s, c) + step / 2;
}

/* The middle's depth from an eye put as far away as a grid allows; no farther than it is. */
static double farthest(const struct seen *s, double step, int w) {
    return fmin(s->middle, (ldexp(1, w) - MARGIN) * step - s->deep);
}

struct sph_eye sph_eye_place(const struct sph_scene *scene, const double axis[3],
                             const double lo[3], const double hi[3], int w) {
    const struct sph_camera *cam = &scene->camera;
    struct sph_eye eye = {cam->from, 0, cam->angle, 1, 0};
    struct seen s = {-(lo[2] + hi[2]) / 2, (hi[2] - lo[2]) / 2,
                     fmax(fmax(hi[0], -lo[0]), fmax(hi[1], -lo[1]))};
    double tangent = tan(cam->angle * M_PI / 360), c = s.middle, best;
    double side = tangent * (1 + 2 * fmax(fabs(cam->shift[0]), fabs(cam->shift[1])));
    s.wide = fmin(s.wide, 2 * side * s.middle); /* no more is seen: frames are no wider */
    double least = fmax(LEAST * s.deep, fmax(2 * s.wide, side * s.middle / WIDEST));
    if (!(least > 0 && s.middle > least) || !isfinite(s.middle)) return eye;
    double step = exp2(floor(log2(least) - w));
    if (!(step > 0)) return eye; /* below the least of doubles */
    while (farthest(&s, step, w) < s.middle)
        step *= 2;
    best = off(&s, s.middle, step) / 2;
    while ((step /= 2) > 0 && farthest(&s, step, w) > least) {
        double here = farthest(&s, step, w), by = off(&s, here, step);
        if (by < best) best = by, c = here;
    }
    if (c == s.middle) return eye;
    eye.ahead = s.middle - c;
    eye.wider = s.middle / c;
    eye.angle = atan(tangent * eye.wider) * 360 / M_PI;
    eye.off = moved(&s, c);
    eye.from.x -= axis[0] * eye.ahead;
    eye.from.y -= axis[1] * eye.ahead;
    eye.from.z -= axis[2] * eye.ahead;
    return eye;
}

const double sph_scene_axes[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};

/* Divides by the length; 0 if there is none. */
static int normalise(struct sph_vec *v) {
    double most = fmax(fabs(v->x), fmax(fabs(v->y), fabs(v->z)));
    if (!(most > 0) || !isfinite(most)) return 0;
    v->x /= most, v->y /= most, v->z /= most;
    double len = sqrt(v->x * v->x + v->y * v->y + v->z * v->z);
    v->x /= len, v->y /= len, v->z /= len;
    return 1;
}

int sph_camera_axes(const struct sph_scene *scene, double rows[9], struct sph_error *err) {
    const struct sph_camera *cam = &scene->camera;
    struct sph_vec z = sph_vec_sub(cam->from, cam->at), up = cam->up;
    if (!normalise(&z)) return sph_fail(err, "%s: from and at are the same point", scene->path);
    if (!normalise(&up)) return sph_fail(err, "%s: up has no direction", scene->path);
    struct sph_vec x = sph_vec_cross(up, z);
    if (x.x * x.x + x.y * x.y + x.z * x.z < 1e-20 || !normalise(&x))
        return sph_fail(err, "%s: up is parallel to the view", scene->path);
    struct sph_vec y = sph_vec_cross(z, x);
    const double found[9] = {x.x, x.y, x.z, y.x, y.y, y.z, z.x, z.y, z.z};
    memcpy(rows, found, sizeof found);
    return 0;
}

/* Half the surface of the boxes around all that has an end. */
static double surface(const struct sph_scene *scene, const double rows[9]) {
    double sum = 0;
    for (uint32_t i = 0; i < scene->n_spheres; i++)
        sum += 12 * scene->spheres[i].rad * scene->spheres[i].rad;
    for (uint32_t i = 0; i < scene->n_facets; i++) {
        const struct sph_facet *f = &scene->facets[i];
        struct sph_box box = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
        double at[3];
        if (sph_kind_unbounded((uint32_t)f->kind)) continue;
        for (int k = 0; k < 3; k++) {
            sph_vec_turn(rows, f->v[k], at);
            sph_box_add(&box, at, 0);
        }
        for (int k = 0; k < 3; k++)
            at[k] = box.hi[k] - box.lo[k];
        sum += at[0] * at[1] + at[1] * at[2] + at[2] * at[0];
    }
    return sum;
}

int sph_axes_of(const struct sph_scene *scene, const struct sph_build_options *o) {
    double camera[9];
    int tree = sph_tree_of(scene, o);
    if (o->axes != SPH_AXES_AUTO) return o->axes;
    if ((tree != SPH_TREE_BOX4 && tree != SPH_TREE_BIH) || o->background != SPH_BG_NONE ||
        sph_camera_axes(scene, camera, NULL))
        return SPH_AXES_CAMERA;
    return 8 * surface(scene, sph_scene_axes) < 7 * surface(scene, camera) ? SPH_AXES_SCENE
                                                                           : SPH_AXES_CAMERA;
}
