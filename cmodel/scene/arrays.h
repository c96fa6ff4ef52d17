/* arrays.h - a scene out of arrays of numbers, as programs have them
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef SPH_SCENE_ARRAYS_H
#define SPH_SCENE_ARRAYS_H

#include "scene/scene.h"

/* Rows of numbers; what may be NULL is said. */
struct sph_arrays {
    const char *name;         /* in messages of the ledger */
    struct sph_camera camera; /* hither does not count */
    double background[3], ambient[3];
    uint32_t n_materials, n_spheres, n_triangles, n_planes, n_lights, n_textures;
    const double *materials;        /* [8]: red green blue Kd Ks Shine T index, as `f` of NFF */
    const double *spheres;          /* [4]: centre, radius; below 0 as in `s` of NFF */
    const double *triangles;        /* [3][3] */
    const double *normals;          /* [3][3], or NULL */
    const double *planes;           /* [6]: a point, the normal */
    const double *lights, *colours; /* [3] both; colours may be NULL */
    /* numbers of materials; NULL: 0 */
    const uint32_t *sphere_materials, *triangle_materials, *plane_materials;
    const char *const *textures; /* files of images, which repeat */
    /* numbers of textures, SPH_ID_NONE: none; NULL: none at all */
    const uint32_t *sphere_textures, *triangle_textures;
    const double *st; /* [3][2] of triangles: s, t of corners; if they have textures */
};

/* Makes the scene, with the rules of NFF files. In its ledger lines are rows, from 1 on. 0, or -1
 * with "array[row]: field ..."; then *scene holds nothing to free. */
int sph_scene_of_arrays(const struct sph_arrays *arrays, struct sph_scene *scene,
                        struct sph_error *err);

#endif
