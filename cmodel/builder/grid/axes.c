/* axes.c - see axes.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "builder/grid/axes.h"

#include <math.h>
#include <string.h>

#include "builder/build.h"
#include "builder/tree/choose_tree.h"
#include "builder/grid/huge_bounds.h"
#include "machine/records.h"
#include "scene/vector.h"

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
